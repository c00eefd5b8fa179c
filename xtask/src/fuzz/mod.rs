//! `cargo xtask fuzz`: throws mutated inputs at every parser and compiler for a given time.
//!
//! A child process runs the target; input `n` of a run depends only on seed, corpus and `n`. Whatever kills the child (panic,
//! stack overflow, a hang that the parent ends) is found the same way: the parent reads `n` from the child's progress file,
//! makes the input again, writes it down and says how to replay it.

pub mod engines;
pub mod mutator;
pub mod targets;
mod tree_model;
pub mod trees;

use std::fs::{self, File, OpenOptions};
use std::io::{Read as _, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, Command};
use std::time::{Duration, Instant};

use crate::workspace;
use mutator::Mutator;
pub use targets::{TARGETS, Target};

/// An input that takes more CPU time is a hang. Inputs are at most [`mutator::INPUT_BYTES_MAX`] bytes long and take milliseconds.
const HANG: Duration = Duration::from_secs(10);
/// The same where an input is compiled four times: blocks that call one another become functions of millions of instructions, and a program
/// built to hurt a compiler has a minute in the tests, too.
const HANG_OF_COMPILERS: Duration = Duration::from_secs(4 * 60);
/// Targets that compile their inputs for several engines.
const COMPILERS: [&str; 2] = ["engines", "trees"];
/// So is one that takes longer by the clock, for it waits for something. On a busy machine an input waits for the processor, too.
const WAITS: Duration = Duration::from_secs(400);
/// How often the parent looks at the child.
const POLL: Duration = Duration::from_millis(20);
/// Stack of the thread that runs a target: the same as a program's main thread has on Linux.
const STACK_BYTES: usize = 8 << 20;

struct Options {
    seconds: u64,
    seed: u64,
    target: Option<String>,
    child: Option<PathBuf>,
    replay: Option<(String, PathBuf)>,
}

/// Runs the task.
pub fn run(arguments: &[String]) -> Result<(), String> {
    let options = read_options(arguments)?;
    if let Some((name, file)) = &options.replay {
        return replay(find(name)?, file);
    }
    if let Some(progress) = &options.child {
        let name = options.target.as_deref().unwrap_or_default();
        return child(find(name)?, &options, progress);
    }
    let chosen: Vec<&Target> = match &options.target {
        Some(name) => vec![find(name)?],
        None => TARGETS.iter().collect(),
    };
    let share = Duration::from_secs(options.seconds) / u32::try_from(chosen.len().max(1)).unwrap_or(1);
    println!("fuzz: {} targets, {:.1} s each, seed {}", chosen.len(), share.as_secs_f64(), options.seed);
    let mut failures = 0;
    for target in chosen {
        failures += usize::from(!parent(target, options.seed, share)?);
    }
    if failures == 0 { Ok(()) } else { Err(format!("fuzz: {failures} targets failed")) }
}

fn read_options(arguments: &[String]) -> Result<Options, String> {
    let mut options = Options { seconds: 20, seed: 1, target: None, child: None, replay: None };
    let mut words = arguments.iter();
    while let Some(word) = words.next() {
        let mut value = |what: &str| words.next().cloned().ok_or(format!("`{word}` is followed by {what}"));
        let number = |text: String| text.parse::<u64>().map_err(|_| format!("`{text}` is not a number"));
        match word.as_str() {
            "--seconds" => options.seconds = number(value("a number of seconds")?)?,
            "--seed" => options.seed = number(value("a number")?)?,
            "--target" => options.target = Some(value("a target")?),
            "--child" => options.child = Some(value("a file")?.into()),
            "--replay" => options.replay = Some((value("a target")?, value("a file")?.into())),
            unknown => return Err(format!("`{unknown}` is no option of fuzz: --seconds, --target, --seed or --replay")),
        }
    }
    Ok(options)
}

fn find(name: &str) -> Result<&'static Target, String> {
    TARGETS.iter().find(|target| target.name == name).ok_or_else(|| {
        let names: Vec<&str> = TARGETS.iter().map(|target| target.name).collect();
        format!("`{name}` is no fuzz target: {}", names.join(", "))
    })
}

/// Runs one target in a child; whether it survived.
fn parent(target: &Target, seed: u64, share: Duration) -> Result<bool, String> {
    let folder = workspace::root().join("target/fuzz");
    fs::create_dir_all(&folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
    let progress = folder.join(format!("{}-{}.progress", target.name, std::process::id()));
    fs::write(&progress, [0; Progress::BYTES]).map_err(|error| format!("cannot write {}: {error}", progress.display()))?;
    let program = std::env::current_exe().map_err(|error| format!("cannot find myself: {error}"))?;
    let mut child = Command::new(program)
        .args(["fuzz", "--target", target.name, "--seed", &seed.to_string(), "--child"])
        .arg(&progress)
        .spawn()
        .map_err(|error| format!("cannot start the child: {error}"))?;
    let started = Instant::now();
    let hang = if COMPILERS.contains(&target.name) { HANG_OF_COMPILERS } else { HANG };
    let end = watch(&mut child, &progress, hang, started, share);
    let executions = Progress::read(&progress).input;
    let _ = fs::remove_file(&progress);
    let seconds = started.elapsed().as_secs_f64();
    let what = match end {
        End::TimeUp => {
            println!("fuzz: {:<16} {executions:>9} executions, {:>7.0} a second", target.name, executions as f64 / seconds);
            return Ok(true);
        }
        End::Died => "panicked or crashed",
        End::Hung => "hung",
    };
    let input = Mutator::new(target, seed).input(executions);
    let file = folder.join(format!("{}-{seed}-{executions}.bin", target.name));
    fs::write(&file, input).map_err(|error| format!("cannot write {}: {error}", file.display()))?;
    let file = workspace::relative(&workspace::root(), &file);
    println!(
        "fuzz: {:<16} {what} after {executions} executions\n  the input is in {file}\n  cargo xtask fuzz --replay {} {file}",
        target.name, target.name
    );
    Ok(false)
}

enum End {
    TimeUp,
    Died,
    Hung,
}

fn watch(child: &mut Child, progress: &Path, hang: Duration, started: Instant, share: Duration) -> End {
    let mut seen = (Progress::read(progress), Instant::now());
    let end = loop {
        std::thread::sleep(POLL);
        if !matches!(child.try_wait(), Ok(None)) {
            return End::Died;
        }
        let now = Progress::read(progress);
        if now.input != seen.0.input {
            seen = (now, Instant::now());
        }
        // A share that ends while an input runs waits for it: it may be a hang.
        if started.elapsed() >= share && seen.1.elapsed() < POLL * 5 {
            break End::TimeUp;
        }
        if now.cpu_time.saturating_sub(seen.0.cpu_time) >= hang || seen.1.elapsed() >= WAITS {
            break End::Hung;
        }
    };
    let _ = child.kill();
    let _ = child.wait();
    end
}

/// What the child tells in its file: two numbers of eight bytes.
#[derive(Clone, Copy, Default)]
struct Progress {
    /// The number of the running input.
    input: u64,
    /// What the child took of the processor, in nanoseconds in the file.
    cpu_time: Duration,
}

impl Progress {
    const BYTES: usize = 16;
    const CPU_TIME_AT: u64 = 8;

    fn read(path: &Path) -> Self {
        let mut bytes = [0; Self::BYTES];
        match File::open(path).and_then(|mut file| file.read_exact(&mut bytes)) {
            Ok(()) => {
                let all = u128::from_le_bytes(bytes);
                Self { input: all as u64, cpu_time: Duration::from_nanos((all >> 64) as u64) }
            }
            Err(_) => Self::default(),
        }
    }
}

/// What this process took of the processor.
fn cpu_time() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
}

/// Runs inputs until the parent ends it, and tells which one is running.
fn child(target: &'static Target, options: &Options, progress: &Path) -> Result<(), String> {
    let open = || OpenOptions::new().write(true).open(progress).map_err(|error| format!("cannot open {}: {error}", progress.display()));
    let write = |file: &mut File, at: u64, number: u64| file.seek(SeekFrom::Start(at)).and_then(|_| file.write_all(&number.to_le_bytes()));
    let (mut inputs, mut times) = (open()?, open()?);
    let mutator = Mutator::new(target, options.seed);
    let work = move || {
        for number in 0u64.. {
            // The parent is gone, or the disk is full: nobody would learn what an input does.
            if write(&mut inputs, 0, number).is_err() {
                return;
            }
            (target.fuzz)(&mutator.input(number));
        }
    };
    let thread =
        std::thread::Builder::new().stack_size(STACK_BYTES).spawn(work).map_err(|error| format!("cannot start a thread: {error}"))?;
    while !thread.is_finished() {
        std::thread::sleep(POLL);
        // Without it the parent goes by the clock.
        let _ = write(&mut times, Progress::CPU_TIME_AT, cpu_time().as_nanos() as u64);
    }
    thread.join().map_err(|_| "the target panicked".to_owned())
}

fn replay(target: &'static Target, file: &Path) -> Result<(), String> {
    let input = fs::read(file).map_err(|error| format!("cannot read {}: {error}", file.display()))?;
    println!("fuzz: {} on {} bytes:\n{}", target.name, input.len(), String::from_utf8_lossy(&input));
    let started = Instant::now();
    let thread =
        std::thread::Builder::new().stack_size(STACK_BYTES).spawn(move || (target.fuzz)(&input)).map_err(|error| error.to_string())?;
    thread.join().map_err(|_| "fuzz: the target panicked".to_owned())?;
    println!("fuzz: passed in {:.3} s", started.elapsed().as_secs_f64());
    Ok(())
}
