//! What each optimization is worth: `cargo bench -p sieben-app --bench ablation [-- NAME,…]`, or `cargo xtask ablate`.
//!
//! `-- without` leaves out what is not worth its lines, one after the other, most lines first: each is measured without all that went before it,
//! and goes if the nine and the programs of STL lose one per cent at most without it, and the corpus three. If all of that costs more than three per
//! cent, what brings most comes back, until it does not.
//!
//! Each program runs with all optimizations and with all but one, in alternation. The nine programs of Structured Text, those of STL and
//! the corpus are told apart; a figure of the first two is the median of three measurements each, of the corpus one.
#![allow(clippy::print_stdout, clippy::print_stderr)] // A measurement prints its figures.
#![allow(dead_code)] // The programs are those of other measurements, which look at more of them.

use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;
use std::{env, fs};

use side_by_side::{compiled, load, mean, now_ns, root};
use sieben_engine::{Engine, Program};
use sieben_jit::{Jit, Pass, PassSet, StatusBits};

#[path = "native/cases.rs"]
mod cases;
#[path = "structured_text/corpus.rs"]
mod corpus;
#[path = "native/dense.rs"]
mod dense;
#[path = "structured_text/programs.rs"]
mod programs;
mod side_by_side;

/// The allocator of the command line.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Time of one measurement.
const MEASURED_NS: f64 = 2e7;
/// What all that goes may cost, in per cent.
const SUM_MAX: f64 = 3.0;
/// Scans that are measured together.
const BATCH: u64 = 20;

/// Which programs are taken together.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Group {
    Nine,
    Stl,
    Corpus,
}

/// A program that is measured.
struct Subject {
    group: Group,
    name: String,
    program: Program,
}

/// Machine code, and what it took to make it.
struct Made {
    engine: Arc<dyn Engine>,
    ms: f64,
}

fn made(program: &Program, passes: PassSet) -> Made {
    let mut result = None;
    load(program, |program, layout| {
        let start = now_ns();
        let engine = Jit::compiled_with(program, layout, StatusBits::Needed, passes).expect("machine code");
        result.insert(Made { engine, ms: (now_ns() - start) / 1e6 }).engine.clone()
    });
    result.expect("it was loaded")
}

fn subject(group: Group, name: &str, file: &str, text: &str) -> Option<Subject> {
    let program = compiled(file, text).map_err(|error| eprintln!("{error}")).ok()?;
    Some(Subject { group, name: name.to_owned(), program })
}

fn subjects() -> Vec<Subject> {
    let mut all = Vec::new();
    for case in programs::all() {
        all.extend(subject(Group::Nine, case.name, "bench.st", &case.st));
    }
    for case in cases::all().into_iter().filter(|case| !case.name.ends_with(" 4 statements")) {
        all.extend(subject(Group::Stl, &case.name, "bench.awl", &case.stl));
    }
    for (name, file) in corpus::all() {
        all.extend(subject(Group::Corpus, &name, "bench.st", &fs::read_to_string(&file).expect("a text")));
    }
    all
}

/// Nanoseconds of a scan.
fn scan_ns(program: &Program, engine: &Arc<dyn Engine>) -> f64 {
    let mut loaded = load(program, |_, _| engine.clone());
    (0..BATCH).for_each(|_| loaded.scan(None));
    let (start, mut best) = (now_ns(), f64::INFINITY);
    while now_ns() - start < MEASURED_NS {
        let begun = now_ns();
        (0..BATCH).for_each(|_| loaded.scan(None));
        let took = now_ns() - begun;
        // The clock of a virtual machine stands still now and then.
        if took > 0.0 {
            best = best.min(took / BATCH as f64);
        }
    }
    best
}

/// How much longer a program takes without an optimization, its code bytes and its time to compile beside those with it.
struct Ratio {
    /// A difference within the spread of the measurements counts as none.
    time: f64,
    bytes: f64,
    compile: f64,
}

fn median(mut all: Vec<f64>) -> f64 {
    all.sort_unstable_by(f64::total_cmp);
    all[all.len() / 2]
}

/// How often the corpus is measured where several figures add up; for a table it is once.
const CORPUS_ROUNDS: usize = 3;

fn ratio(subject: &Subject, with: &Made, without: &Made, corpus_rounds: usize) -> Ratio {
    let rounds = if subject.group == Group::Corpus { corpus_rounds } else { 3 };
    let (mut with_ns, mut without_ns) = (Vec::new(), Vec::new());
    for _ in 0..rounds {
        with_ns.push(scan_ns(&subject.program, &with.engine));
        without_ns.push(scan_ns(&subject.program, &without.engine));
    }
    let spread = |all: &[f64]| (all.iter().copied().fold(f64::INFINITY, f64::min), all.iter().copied().fold(0.0, f64::max));
    let ((least, most), (other_least, other_most)) = (spread(&with_ns), spread(&without_ns));
    let overlap = rounds > 1 && least <= other_most && other_least <= most;
    Ratio {
        time: if overlap { 1.0 } else { median(without_ns) / median(with_ns) },
        bytes: without.engine.code_bytes() as f64 / with.engine.code_bytes().max(1) as f64,
        compile: without.ms / with.ms,
    }
}

fn lines(pass: Pass) -> usize {
    let source = root().join("crates/jit/src");
    let count = |file: &&str| fs::read_to_string(source.join(Path::new(file))).map_or(0, |text| text.lines().count());
    pass.files().iter().map(count).sum()
}

/// What all programs do without some optimizations.
struct Measured {
    nine: f64,
    stl: f64,
    corpus: f64,
    worst: String,
    bytes: f64,
    compile: f64,
}

impl Measured {
    /// Some machine code beside other, one for each program.
    fn of(subjects: &[Subject], with: &[Made], without: &[Made], corpus_rounds: usize) -> Self {
        let pairs = subjects.iter().zip(with.iter().zip(without));
        let all: Vec<(&Subject, Ratio)> =
            pairs.map(|(subject, (with, without))| (subject, ratio(subject, with, without, corpus_rounds))).collect();
        let percent = |ratios: Vec<f64>| (mean(&ratios) - 1.0) * 100.0;
        let of = |group: Group| percent(all.iter().filter(|(subject, _)| subject.group == group).map(|(_, ratio)| ratio.time).collect());
        let mean_of = |of: fn(&Ratio) -> f64| percent(all.iter().map(|(_, ratio)| of(ratio)).collect());
        let worst = all.iter().max_by(|(_, a), (_, b)| a.time.total_cmp(&b.time));
        let worst = worst.map_or_else(String::new, |(subject, ratio)| format!("{} {:+.1} %", subject.name, (ratio.time - 1.0) * 100.0));
        Self {
            nine: of(Group::Nine),
            stl: of(Group::Stl),
            corpus: of(Group::Corpus),
            worst,
            bytes: mean_of(|ratio| ratio.bytes),
            compile: mean_of(|ratio| ratio.compile),
        }
    }

    /// Whether what was left out is not worth its lines.
    fn may_go(&self) -> bool {
        self.nine <= 1.0 && self.stl <= 1.0 && self.corpus <= 3.0
    }

    /// The mean that loses most.
    fn most(&self) -> f64 {
        self.nine.max(self.stl).max(self.corpus)
    }

    fn print(&self, name: &str, lines: usize, more: &str) {
        let Self { nine, stl, corpus, worst, bytes, compile } = self;
        println!("| {name} | {lines} | {nine:+.1} % | {stl:+.1} % | {corpus:+.1} % | {worst} | {bytes:+.1} % | {compile:+.1} % |{more}");
    }
}

fn all_made(subjects: &[Subject], passes: PassSet) -> Vec<Made> {
    subjects.iter().map(|subject| made(&subject.program, passes)).collect()
}

fn without(gone: &[Pass]) -> PassSet {
    PassSet::default().without_all(gone)
}

/// Leaves out what is not worth its lines; `whole` is the machine code with all optimizations.
fn leave_out(passes: &[Pass], subjects: &[Subject], whole: &[Made]) {
    let mut gone: Vec<Pass> = Vec::new();
    let mut left: Option<Vec<Made>> = None;
    for &pass in passes {
        let next = all_made(subjects, without(&gone).without(pass));
        let measured = Measured::of(subjects, left.as_deref().unwrap_or(whole), &next, 1);
        let goes = measured.may_go();
        measured.print(pass.name(), lines(pass), if goes { " goes |" } else { " stays |" });
        if goes {
            gone.push(pass);
            left = Some(next);
        }
    }
    let sum = |left: &[Made], name: &str, gone: &[Pass]| {
        let sum = Measured::of(subjects, whole, left, CORPUS_ROUNDS);
        sum.print(name, gone.iter().map(|&pass| lines(pass)).sum(), " |");
        sum.most() <= SUM_MAX
    };
    if let Some(left) = left
        && !sum(&left, "all that goes", &gone)
    {
        // What each of them would bring back.
        let but = |pass: Pass| gone.iter().copied().filter(|&other| other != pass).collect::<Vec<_>>();
        let worth = |&pass: &Pass| {
            let measured = Measured::of(subjects, &all_made(subjects, without(&but(pass))), &left, CORPUS_ROUNDS);
            measured.print(&format!("{} alone", pass.name()), lines(pass), " |");
            (measured.most(), pass)
        };
        let mut worth: Vec<(f64, Pass)> = gone.iter().map(worth).collect();
        worth.sort_by(|a, b| b.0.total_cmp(&a.0));
        for (_, pass) in worth {
            gone.retain(|&other| other != pass);
            if sum(&all_made(subjects, without(&gone)), &format!("all that goes, with {} again", pass.name()), &gone) {
                break;
            }
        }
    }
    println!("\n{}", gone.iter().map(|pass| pass.name()).collect::<Vec<_>>().join(","));
}

fn main() -> ExitCode {
    let mut wanted: Vec<String> = env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let leaves_out = wanted.first().is_some_and(|word| word == "without");
    if leaves_out {
        wanted.remove(0);
    }
    let passes: Result<Vec<Pass>, String> = wanted.iter().flat_map(|words| words.split(',')).map(str::parse).collect();
    let mut passes = match passes {
        Ok(passes) if passes.is_empty() => Pass::ALL.to_vec(),
        Ok(passes) => passes,
        Err(error) => {
            eprintln!("{error}");
            return ExitCode::from(2);
        }
    };
    passes.sort_by_key(|&pass| (std::cmp::Reverse(lines(pass)), pass.name()));
    let subjects = subjects();
    let whole = all_made(&subjects, PassSet::default());
    let (head, more) = if leaves_out { (" |", "---|") } else { ("", "") };
    println!("| without | lines | nine | STL | corpus | worst | code | compiling |{head}\n|---|---|---|---|---|---|---|---|{more}");
    if leaves_out {
        leave_out(&passes, &subjects, &whole);
        return ExitCode::SUCCESS;
    }
    for pass in passes {
        let next = all_made(&subjects, without(&[pass]));
        Measured::of(&subjects, &whole, &next, 1).print(pass.name(), lines(pass), "");
    }
    ExitCode::SUCCESS
}
