//! Tests of programs from memory, on a computer that is made up.

use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

use super::report::{Worst, worst};
use super::self_checking::FirstSource;
use super::*;
use crate::tracing;

/// A computer whose clock goes on by so many milliseconds with each look, and that keeps the names of diagrams.
struct MadeUp {
    step_ms: u64,
    now_ms: AtomicU64,
    diagrams: std::sync::Mutex<Vec<String>>,
}

impl Outside for MadeUp {
    fn now(&self) -> Duration {
        Duration::from_millis(self.now_ms.fetch_add(self.step_ms, Ordering::Relaxed))
    }
    fn stop_after(&self, _: StopRequest, _: Duration) -> Box<dyn TimeLimit> {
        Box::new(Never)
    }
    fn load(&self, program: &Program, layout: &Layout) -> Arc<dyn Engine> {
        Interpreter::load(program, layout)
    }
    fn show(&self, findings: &[Finding], _: &Texts) -> Vec<String> {
        findings.iter().map(Finding::message).collect()
    }
    fn keep_diagram(&self, name: &str, draw: &dyn Fn() -> Result<String, String>) -> Option<String> {
        let svg = draw().expect("the diagram is drawn");
        assert!(svg.starts_with("<svg"), "{svg}");
        self.diagrams.lock().expect("no other thread has it").push(name.to_owned());
        Some(format!("kept as {name}"))
    }
}

struct Never;

impl TimeLimit for Never {
    fn has_ended_it(&self) -> bool {
        false
    }
}

fn conditions(step_ms: u64) -> (Conditions, Arc<MadeUp>) {
    let computer = Arc::new(MadeUp { step_ms, now_ms: AtomicU64::new(0), diagrams: std::sync::Mutex::default() });
    let conditions = Conditions {
        outside: Arc::clone(&computer) as Arc<dyn Outside>,
        overrides: Overrides::default(),
        encoding: None,
        diagnostics: false,
        cycle: None,
        limit: None,
        scans: None,
        timeout: Duration::from_secs(10),
        coverage: None,
        rules: Rules::default(),
    };
    (conditions, computer)
}

fn project(sources: &[(&str, &str)]) -> Project {
    let mut project = Project::default();
    sources.iter().for_each(|(path, text)| project.add_source(Path::new(path), text.as_bytes()));
    project
}

fn finished(cases: &[Case], conditions: &Conditions) -> Vec<Finished> {
    let one = |case: &Case| Finished {
        name: case.name.clone(),
        file: case.file.clone(),
        program: None,
        outcome: (case.run)(conditions),
        took: Duration::ZERO,
    };
    cases.iter().map(one).collect()
}

/// Counts its scans in MW 10.
const PROGRAM: (&str, &str) = ("main.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nL MW 10\n+ 1\nT MW 10\nEND_ORGANIZATION_BLOCK\n");
const TESTS: (&str, &str) = (
    "main.test.st",
    "TEST 'it counts'\n  SCAN(3);\n  ASSERT_EQ(3, %MW10);\nEND_TEST\nTEST 'it does not count further'\n  SCAN(5);\n  ASSERT_EQ(4, %MW10);\nEND_TEST\n",
);

#[test]
fn unit_tests_run_from_memory() {
    let (mut conditions, computer) = conditions(0);
    conditions.coverage = Some(Arc::default());
    let cases = unit::cases(TESTS.0, Ok(project(&[PROGRAM, TESTS])), &conditions);
    let finished = finished(&cases, &conditions);
    let text = report::text(&finished);
    assert!(text.starts_with("ok    main.test.st: it counts  (3 scans, "), "{text}");
    assert!(text.contains("FAIL  main.test.st: it does not count further") && text.ends_with("1 passed, 1 failed\n"), "{text}");
    assert!(text.contains("kept as it-does-not-count-further.svg"), "{text}");
    assert_eq!((worst(&finished), computer.diagrams.lock().expect("no other thread has it").len()), (Worst::Failed, 1));
    let coverage = conditions.coverage.as_deref().expect("it is counted").coverage();
    assert!(coverage.summary().contains("main.awl"), "{}", coverage.summary());
    assert_eq!(coverage.lines().percent(), 100, "{}", coverage.summary());
}

#[test]
fn a_test_ends_when_the_clock_that_came_in_says_so() {
    let (conditions, _) = conditions(4_000);
    let endless = ("main.test.st", "TEST 'it waits'\n  SCAN(1000000);\nEND_TEST\n");
    let cases = unit::cases(endless.0, Ok(project(&[PROGRAM, endless])), &conditions);
    let text = report::text(&finished(&cases, &conditions));
    assert!(text.contains("the test took too long and was given up"), "{text}");
}

#[test]
fn what_does_not_compile_or_cannot_be_read_is_a_verdict() {
    let (conditions, _) = conditions(0);
    let wrong = unit::cases(
        TESTS.0,
        Ok(project(&[("main.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nXYZ\nEND_ORGANIZATION_BLOCK\n"), TESTS])),
        &conditions,
    );
    assert_eq!(worst(&finished(&wrong, &conditions)), Worst::DoesNotCompile);
    let refused = unit::cases(TESTS.0, Err(Refusal::new(sieben_model::problems::Problem::P6001, "there is no file")), &conditions);
    assert_eq!(worst(&finished(&refused, &conditions)), Worst::Unreadable);
}

#[test]
fn scenarios_and_programs_that_check_themselves_run_from_memory() {
    let (conditions, _) = conditions(0);
    let stopwatch = Stopwatch::start(&conditions.outside);
    for (text, passes) in [("scan\nscan\nexpect MW10=2\n", true), ("scan\nexpect MW10=2\n", false)] {
        let scenario = tracing::scenario::read("count.scenario", text).expect("the lines are understood");
        let outcome = scenario::run(project(&[PROGRAM]), scenario, "count.scenario", stopwatch.clone(), &conditions);
        assert_eq!(matches!(outcome.verdict, Verdict::Passed), passes, "{:?}", outcome.verdict);
    }
    for (number, passes) in [("1", true), ("2", false)] {
        let text = format!("ORGANIZATION_BLOCK OB 1\nBEGIN\n__ASSERT== 1, {number}\nCALL SFC 46\nEND_ORGANIZATION_BLOCK\n");
        let outcome = self_checking::run(project(&[("main.awl", &text)]), FirstSource::Belongs, false, &stopwatch, &conditions);
        assert_eq!(matches!(outcome.verdict, Verdict::Passed), passes, "{:?}", outcome.verdict);
    }
    let outcome = self_checking::run(project(&[PROGRAM]), FirstSource::Belongs, false, &stopwatch, &conditions);
    assert!(matches!(outcome.verdict, Verdict::NoTest), "{:?}", outcome.verdict);
}
