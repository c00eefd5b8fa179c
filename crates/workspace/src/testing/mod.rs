//! Tests of programs: what a test is, and what came of it.

mod drawing;
mod properties;
pub mod report;
pub mod scenario;
pub mod self_checking;
#[cfg(test)]
mod tests;
pub mod unit;

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use sieben_cpu::{Cpu, Loaded, StopRequest};
use sieben_engine::{Engine, Interpreter, Layout, Program};
use sieben_lang::encoding::Encoding;
use sieben_model::cpu_type::CpuType;
use sieben_sim::devices::random::Random;
use sieben_sim::scenario::Rules;
use sieben_sim::trace::Moment;

use crate::coverage::Collector;
use crate::failed::{self, Failed};
use crate::finding::{self, Finding, Texts};
use crate::project::{Build, Overrides, Project};
use crate::refusal::Refusal;

/// One test: a name, and what runs it. Whatever kind of test it is, it answers with an [`Outcome`].
pub struct Case {
    /// The name that reports show and `--filter` looks at: a path.
    pub name: String,
    /// The test file that it stands in, if it is a unit test.
    pub file: Option<String>,
    /// The line of its name in that file, from 1.
    pub line: Option<usize>,
    /// The program that is no test unless it checks itself; `None` = it is one.
    pub perhaps: Option<Vec<PathBuf>>,
    /// The scenario that it is, if it is one.
    pub scenario: Option<PathBuf>,
    /// The program that it tests, where a folder holds several.
    pub program: Option<String>,
    /// Runs it.
    pub run: Runner,
}

/// What runs a test.
pub type Runner = Box<dyn Fn(&Conditions) -> Outcome + Send + Sync>;

impl Case {
    /// A test with this name.
    pub fn new(name: String, run: Runner) -> Self {
        Self { name, file: None, line: None, perhaps: None, scenario: None, program: None, run }
    }
}

/// Under what conditions tests run.
#[derive(Clone)]
pub struct Conditions {
    /// What tests need of the computer.
    pub outside: Arc<dyn Outside>,
    /// What the command line says about every program.
    pub overrides: Overrides,
    /// The encoding of files without a byte order mark; `None` = guessed.
    pub encoding: Option<Encoding>,
    /// Whether the diagnostic buffer is shown of each test.
    pub diagnostics: bool,
    /// Time from one scan to the next; `None` = the project's, else 10 ms.
    pub cycle: Option<Duration>,
    /// Virtual time after which a test that has not ended has failed; `None` = 60 s, or 100 days for a unit test.
    pub limit: Option<Duration>,
    /// Scans after which a test that has not ended has failed.
    pub scans: Option<u64>,
    /// Real time after which a test is given up.
    pub timeout: Duration,
    /// Takes in which statements tests run, if that is counted; then they run in the interpreter.
    pub coverage: Option<Arc<Collector>>,
    /// How closely a scenario is followed, and what its names are called in the program.
    pub rules: Rules,
}

/// What tests need of the computer that they run on.
pub trait Outside: Send + Sync {
    /// The time since a moment that stays the same: by it the real time of tests is limited.
    fn now(&self) -> Duration;
    /// Sends a CPU to STOP after so much real time, unless the answer is dropped before.
    fn stop_after(&self, request: StopRequest, timeout: Duration) -> Box<dyn TimeLimit>;
    /// Makes a program run.
    fn load(&self, program: &Program, layout: &Layout) -> Arc<dyn Engine>;
    /// What is wrong with a program, each finding as people read it, and their number.
    fn show(&self, findings: &[Finding], texts: &Texts) -> Vec<String>;
    /// Keeps a timing diagram of a test that failed, if that is wanted; what is said about it.
    fn keep_diagram(&self, name: &str, draw: &dyn Fn() -> Result<String, String>) -> Option<String>;
}

/// The real time of a test, which also ends what a CPU does inside one scan, such as a day of cyclic interrupts.
pub trait TimeLimit {
    /// Whether it has sent the CPU to STOP.
    fn has_ended_it(&self) -> bool;
}

impl Conditions {
    /// A program for a CPU type, ready to run. Who counts statements needs the interpreter.
    fn loaded(&self, cpu: &'static CpuType, build: &Build) -> Loaded {
        let code = Arc::new(build.compiled.program.clone());
        match &self.coverage {
            Some(_) => Loaded::new(cpu, code, Interpreter::load),
            None => Loaded::new(cpu, code, |program, layout| self.outside.load(program, layout)),
        }
    }

    /// Compiles a program for a test; answers why it cannot be run.
    fn compile(&self, project: Project, overrides: Overrides) -> Result<Build, Verdict> {
        let build = project.compile(overrides, false);
        match finding::has_errors(&build.findings) {
            true => Err(Verdict::DoesNotCompile(self.outside.show(&build.findings, &build.project.texts))),
            false => Ok(build),
        }
    }
}

/// What came of a test.
#[derive(Debug)]
pub struct Outcome {
    /// Passed or not.
    pub verdict: Verdict,
    /// Scans that were run.
    pub scans: u64,
    /// Virtual time at its end.
    pub simulated: Duration,
    /// What the CPU has to say at its end.
    pub after: After,
    /// What its user is told although it passed.
    pub warning: Option<String>,
}

/// What a CPU has to say after a test, whether it passed or not.
#[derive(Clone, Debug, Default)]
pub struct After {
    /// Statements that failed while the program went on.
    pub failed: Option<Failed>,
    /// The diagnostic buffer, line by line, if that is wanted.
    pub diagnostics: Vec<String>,
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
        Self { verdict, scans, simulated, after, warning: None }
    }

    /// Nothing was run.
    pub fn nothing_ran(verdict: Verdict) -> Self {
        Self { verdict, scans: 0, simulated: Duration::ZERO, after: After::default(), warning: None }
    }
}

/// The real time that a test has taken.
#[derive(Clone)]
pub struct Stopwatch {
    outside: Arc<dyn Outside>,
    begun: Duration,
}

impl Stopwatch {
    /// Begins now.
    pub fn start(outside: &Arc<dyn Outside>) -> Self {
        Self { outside: Arc::clone(outside), begun: outside.now() }
    }

    /// The time since it was started.
    pub fn elapsed(&self) -> Duration {
        self.outside.now().saturating_sub(self.begun)
    }
}

/// Passed, or why not.
#[derive(Debug)]
pub enum Verdict {
    /// It ended as it should.
    Passed,
    /// It has no words to check itself and it was not named as a test: it was not run.
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
pub struct Wrong {
    /// In one sentence.
    pub message: String,
    /// The source and its line, counted from 1.
    pub place: Option<(String, usize)>,
    /// The statement that found it.
    pub statement: Option<String>,
    /// `FC 5, statement 3`.
    pub block: Option<String>,
    /// Both values of an assertion.
    pub values: Option<(String, String)>,
    /// Their types, if they have some.
    pub types: Option<(String, String)>,
    /// The scan behind which it was wrong first.
    pub moment: Option<Moment>,
    /// What the author of the test says about it.
    pub said: Option<String>,
    /// More about it, line by line.
    pub lines: Vec<String>,
}

/// Puts the tests in an order that the seed says.
pub fn shuffle(cases: &mut [Case], seed: u64) {
    let mut random = Random::new(seed);
    for last in (1..cases.len()).rev() {
        cases.swap(last, (random.next() % (last as u64 + 1)) as usize);
    }
}

/// A test with what came of it.
pub struct Finished {
    /// Its name.
    pub name: String,
    /// The test file that it stands in, if it is a unit test.
    pub file: Option<String>,
    /// The program that it tests, where a folder holds several.
    pub program: Option<String>,
    /// What came of it.
    pub outcome: Outcome,
    /// How long it took, in real time.
    pub took: Duration,
}
