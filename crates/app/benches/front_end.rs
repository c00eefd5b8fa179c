//! What a change costs in a large project: `cargo bench -p sieben-app --bench front_end`.
//!
//! A project of 100,000 statements in 500 files is compiled; then one block is changed again and again, and the time until all diagnostics
//! are known is taken. A figure is CPU time of the thread, because other work on the machine only ever adds time.
#![allow(clippy::print_stdout)] // A measurement prints its figures.

#[path = "front_end/project.rs"]
mod project;

use rustix::time::{ClockId, clock_gettime};
use sieben_lang::{Database, Options, compile};
use sieben_model::diagnostic::Severity;
use sieben_model::source::FileId;

/// Changes of each kind.
const CHANGES: usize = 100;
/// How often the whole is compiled.
const WHOLES: usize = 5;

/// The allocator of the command line.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// CPU time of this thread in milliseconds.
fn now_ms() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 * 1e3 + time.tv_nsec as f64 / 1e6
}

fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let begin = now_ms();
    let value = work();
    (now_ms() - begin, value)
}

fn row(name: &str, checked: &str, mut times: Vec<f64>) {
    times.sort_unstable_by(f64::total_cmp);
    println!("| {name} | {checked} | {:.1} ms | {:.1} ms | {:.1} ms |", times[0], times[times.len() / 2], times[times.len() - 1]);
}

/// Another text of a file; the number is another one each time.
type Change = fn(usize, usize) -> String;

/// What is changed, in a file of which language (by [`project::is_scl`]), and how.
const KINDS: &[(&str, bool, Change)] = &[
    ("a statement of a block of STL", false, |file, round| project::file(file, Some(round + 1))),
    ("a statement of a block of SCL", true, |file, round| project::file(file, Some(round + 1))),
    ("a statement of STL, so that the rest of the file moves", false, |file, round| {
        project::file(file, None).replacen("L 4;", &format!("L 4;{}", " ".repeat(round % 7 + 1)), 1)
    }),
    ("a statement of SCL, so that the rest of the file moves", true, |file, round| {
        project::file(file, None).replacen("t * 3;", &format!("t * 3;{}", " ".repeat(round % 7 + 1)), 1)
    }),
    ("a variable of a function block of STL", false, |file, round| {
        project::file(file, None).replacen("count : INT;", &format!("count : INT;\n more_{round} : INT;"), 1)
    }),
    ("a variable of a function block of SCL", true, |file, round| {
        project::file(file, None).replacen("count : INT;", &format!("count : INT;\n more_{round} : INT;"), 1)
    }),
    ("a mistake in a statement of STL", false, |file, round| project::file(file, None).replacen("L 4;", &format!("L lost_{round};"), 1)),
    ("a mistake in a statement of SCL", true, |file, round| project::file(file, None).replacen("t * 3;", &format!("t * lost_{round};"), 1)),
];

fn main() {
    let project = project::project();
    let statements = 2 * project::BLOCK_STATEMENTS * project::FILES;
    println!("{statements} statements in {} files and one with OB 1\n", project::FILES);
    println!("| changed | blocks checked | least | median | most |\n|---|---|---|---|---|");
    let options = Options { system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
    let whole = || compile(&project.sources, &project.symbols, &options);
    row("nothing is known: the whole project, with its code", "all", (0..WHOLES).map(|_| timed(whole).0).collect());
    let mut database = Database::new(project.symbols.clone(), options.clone());
    for (_, file) in project.sources.iter() {
        database.add(file.name.clone(), file.text.clone());
    }
    let (time, diagnostics) = timed(|| database.diagnostics());
    assert!(!diagnostics.iter().any(|one| one.severity() == Severity::Error), "{:?}", diagnostics.first());
    row("nothing is known: all diagnostics", "all", vec![time]);
    for &(name, scl, change) in KINDS {
        let mut times = Vec::new();
        let mut checked = 0;
        for round in 0..CHANGES {
            let file = (0..project::FILES).cycle().skip(round * 37).find(|&file| project::is_scl(file) == scl).expect("a file");
            let id = FileId(file as u32);
            database.replace(id, change(file, round));
            times.push(timed(|| database.diagnostics()).0);
            checked = checked.max(database.work().checked.len());
            database.replace(id, project::file(file, None));
            database.diagnostics();
        }
        row(name, &checked.to_string(), times);
    }
}
