//! Tests of programs: what a test is, how many run at once, what came of them.

pub(crate) mod coverage_pages;
pub(crate) mod discovery;
mod drawing;
mod last_change;
pub(crate) mod report;
pub(crate) mod rules;
pub(crate) mod scenario;
pub(crate) mod self_checking;
mod time_limit;
mod unit;

use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use sieben_cpu::Cpu;
use sieben_lang::encoding::Encoding;
use sieben_workspace::Refusal;
use sieben_workspace::coverage::Collector;
use sieben_workspace::failed::{self, Failed};
use sieben_workspace::project::{Build, Overrides};

use crate::engines::EngineArgument;
use sieben_sim::devices::random::Random;
use sieben_sim::scenario::Rules;
use sieben_sim::trace::Moment;

/// One test: a name, and what runs it. Whatever kind of test it is, it answers with an [`Outcome`].
pub(crate) struct Case {
    /// The name that reports show and `--filter` looks at: a path.
    pub(crate) name: String,
    /// The test file that it stands in, if it is a unit test.
    pub(crate) file: Option<String>,
    /// The program that is no test unless it checks itself; `None` = it is one.
    pub(crate) perhaps: Option<Vec<PathBuf>>,
    /// The scenario that it is, if it is one.
    pub(crate) scenario: Option<PathBuf>,
    /// The program that it tests, where a folder holds several.
    pub(crate) program: Option<String>,
    /// Runs it.
    pub(crate) run: Runner,
}

/// What runs a test.
type Runner = Box<dyn Fn(&Conditions) -> Outcome + Send + Sync>;

impl Case {
    /// A test with this name.
    fn new(name: String, run: Runner) -> Self {
        Self { name, file: None, perhaps: None, scenario: None, program: None, run }
    }
}

/// Under what conditions tests run.
#[derive(Clone)]
pub(crate) struct Conditions {
    /// What the command line says about every program.
    pub(crate) overrides: Overrides,
    /// The encoding of files without a byte order mark; `None` = guessed.
    pub(crate) encoding: Option<Encoding>,
    /// Whether the diagnostic buffer is shown of each test.
    pub(crate) diagnostics: bool,
    /// What runs the programs.
    pub(crate) engine: EngineArgument,
    /// Time from one scan to the next; `None` = the project's, else 10 ms.
    pub(crate) cycle: Option<Duration>,
    /// Virtual time after which a test that has not ended has failed; `None` = 60 s, or 100 days for a unit test.
    pub(crate) limit: Option<Duration>,
    /// Scans after which a test that has not ended has failed.
    pub(crate) scans: Option<u64>,
    /// Real time after which a test is given up.
    pub(crate) timeout: Duration,
    /// Takes in which statements tests run, if that is counted; then they run in the interpreter.
    pub(crate) coverage: Option<Arc<Collector>>,
    /// The folder for the timing diagrams of tests that fail, as SVG.
    pub(crate) svg: Option<PathBuf>,
    /// How closely a scenario is followed, and what its names are called in the program.
    pub(crate) rules: Rules,
}

/// What came of a test.
#[derive(Debug)]
pub(crate) struct Outcome {
    /// Passed or not.
    pub(crate) verdict: Verdict,
    /// Scans that were run.
    pub(crate) scans: u64,
    /// Virtual time at its end.
    pub(crate) simulated: Duration,
    /// What the CPU has to say at its end.
    pub(crate) after: After,
}

/// What a CPU has to say after a test, whether it passed or not.
#[derive(Clone, Debug, Default)]
pub(crate) struct After {
    /// Statements that failed while the program went on.
    pub(crate) failed: Option<Failed>,
    /// The diagnostic buffer, line by line, if that is wanted.
    pub(crate) diagnostics: Vec<String>,
}

impl After {
    /// What this one has to say.
    fn of(build: &Build, cpu: &Cpu, conditions: &Conditions) -> Self {
        let entries = cpu.diagnostic_buffer().entries().filter(|_| conditions.diagnostics);
        Self { failed: Failed::of(build, cpu), diagnostics: entries.map(|entry| failed::entry_text(build, entry)).collect() }
    }
}

impl Outcome {
    /// What came of a run; with `--strict` a statement that failed fails the test.
    fn new(verdict: Verdict, scans: u64, simulated: Duration, after: After, conditions: &Conditions) -> Self {
        let verdict = match (verdict, &after.failed) {
            (Verdict::Passed, Some(failed)) if conditions.overrides.strict => {
                Verdict::Failed(Box::new(Wrong { message: failed.line(), ..Wrong::default() }))
            }
            (verdict, _) => verdict,
        };
        Self { verdict, scans, simulated, after }
    }

    /// Nothing was run.
    fn nothing_ran(verdict: Verdict) -> Self {
        Self { verdict, scans: 0, simulated: Duration::ZERO, after: After::default() }
    }
}

/// Passed, or why not.
#[derive(Debug)]
pub(crate) enum Verdict {
    /// It ended as it should.
    Passed,
    /// It has no words to check itself and nobody named it as a test: it was not run.
    NoTest,
    /// It ran and found something wrong, or did not end.
    Failed(Box<Wrong>),
    /// It does not compile; the diagnostics as text, each for itself, and their number.
    DoesNotCompile(Vec<String>),
    /// Its files cannot be read, or do not belong to the program.
    Unreadable(Refusal),
    /// Lines of its file are not understood.
    Misread(Vec<Refusal>),
}

/// What a test found wrong.
#[derive(Debug, Default)]
pub(crate) struct Wrong {
    /// In one sentence.
    pub(crate) message: String,
    /// The source and its line, counted from 1.
    pub(crate) place: Option<(String, usize)>,
    /// The statement that found it.
    pub(crate) statement: Option<String>,
    /// `FC 5, statement 3`.
    pub(crate) block: Option<String>,
    /// Both values of an assertion.
    pub(crate) values: Option<(String, String)>,
    /// Their types, if they have some.
    pub(crate) types: Option<(String, String)>,
    /// The scan behind which it was wrong first.
    pub(crate) moment: Option<Moment>,
    /// What the author of the test says about it.
    pub(crate) said: Option<String>,
    /// More about it, line by line.
    pub(crate) lines: Vec<String>,
}

/// Puts the tests in an order that the seed says.
pub(crate) fn shuffle(cases: &mut [Case], seed: u64) {
    let mut random = Random::new(seed);
    for last in (1..cases.len()).rev() {
        cases.swap(last, (random.next() % (last as u64 + 1)) as usize);
    }
}

/// A test with what came of it.
pub(crate) struct Finished {
    /// Its name.
    pub(crate) name: String,
    /// The test file that it stands in, if it is a unit test.
    pub(crate) file: Option<String>,
    /// The program that it tests, where a folder holds several.
    pub(crate) program: Option<String>,
    /// What came of it.
    pub(crate) outcome: Outcome,
    /// How long it took, in real time.
    pub(crate) took: Duration,
}

/// Runs all tests, as many at once as `threads`, and tells `progress` how many are done. They come back in their order.
pub(crate) fn run_all(cases: &[Case], conditions: &Conditions, threads: usize, progress: &(dyn Fn(usize) + Sync)) -> Vec<Finished> {
    let next = AtomicUsize::new(0);
    let done = Mutex::new(Vec::with_capacity(cases.len()));
    std::thread::scope(|scope| {
        for _ in 0..threads.clamp(1, cases.len().max(1)) {
            scope.spawn(|| {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(case) = cases.get(index) else { return };
                    let begun = Instant::now();
                    let outcome = (case.run)(conditions);
                    let (name, file, program) = (case.name.clone(), case.file.clone(), case.program.clone());
                    let finished = Finished { name, file, program, outcome, took: begun.elapsed() };
                    // A panic ends the process, so that no one finds the lock poisoned.
                    let mut done = done.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
                    done.push((index, finished));
                    progress(done.len());
                }
            });
        }
    });
    let mut done = done.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, finished)| finished).collect()
}
