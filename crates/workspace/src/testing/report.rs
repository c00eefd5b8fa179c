//! Results of tests: for people, as JSON, as JUnit XML and as TAP.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::time::Duration;

use serde_json::{Value, json};
use sieben_model::visible;

use super::{Finished, Verdict, Wrong};
use crate::duration;
use crate::failed::Failed;
use crate::refusal::Refusal;
use crate::xml::escaped;

/// How many tests ended how.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Those that passed.
    pub passed: usize,
    /// Those that found something wrong or did not end.
    pub failed: usize,
    /// Those that do not compile or cannot be read.
    pub broken: usize,
}

impl Tally {
    /// Counts.
    pub fn of(finished: &[Finished]) -> Self {
        let mut tally = Self::default();
        for test in finished {
            *match test.outcome.verdict {
                Verdict::Passed => &mut tally.passed,
                Verdict::NoTest => continue,
                Verdict::Failed(_) => &mut tally.failed,
                Verdict::DoesNotCompile(_) | Verdict::Unreadable(_) | Verdict::Misread(_) => &mut tally.broken,
            } += 1;
        }
        tally
    }
}

/// How the tests ended, as one word: the worst of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Worst {
    /// All passed.
    Passed,
    /// One found something wrong, or did not end.
    Failed,
    /// The files of one cannot be read.
    Unreadable,
    /// One does not compile.
    DoesNotCompile,
}

/// The worst of all tests.
pub fn worst(finished: &[Finished]) -> Worst {
    let one = |test: &Finished| match test.outcome.verdict {
        Verdict::Passed | Verdict::NoTest => Worst::Passed,
        Verdict::Failed(_) => Worst::Failed,
        Verdict::Unreadable(_) | Verdict::Misread(_) => Worst::Unreadable,
        Verdict::DoesNotCompile(_) => Worst::DoesNotCompile,
    };
    finished.iter().map(one).max().unwrap_or(Worst::Passed)
}

/// Why a test did not pass: a headline and the lines below it.
fn why(verdict: &Verdict) -> Option<(String, Vec<String>)> {
    match verdict {
        Verdict::Passed | Verdict::NoTest => None,
        Verdict::Failed(wrong) => {
            let headline = match &wrong.place {
                Some((file, line)) => format!("{file}:{line}: {}", wrong.message),
                None => wrong.message.clone(),
            };
            let mut lines = Vec::new();
            if let (Some(statement), Some(_)) = (&wrong.statement, &wrong.place) {
                lines.push(match &wrong.block {
                    Some(block) => format!("{statement}  // {block}"),
                    None => statement.clone(),
                });
            }
            lines.extend(wrong.said.iter().map(|said| format!("message: {said}")));
            lines.extend(wrong.lines.iter().cloned());
            Some((headline, lines))
        }
        Verdict::DoesNotCompile(findings) => {
            Some(("does not compile".to_owned(), findings.iter().flat_map(|finding| finding.lines()).map(str::to_owned).collect()))
        }
        Verdict::Unreadable(failure) => Some(misread(failure)),
        Verdict::Misread(failures) => {
            let mut told = failures.iter().map(misread);
            let (headline, mut lines) = told.next().unwrap_or_default();
            lines.extend(told.flat_map(|(headline, lines)| std::iter::once(headline).chain(lines)));
            Some((headline, lines))
        }
    }
}

/// What is wrong with a file, and what to do.
fn misread(refusal: &Refusal) -> (String, Vec<String>) {
    (refusal.message.clone(), vec![format!("[{}] {}", refusal.problem.code(), refusal.shown_help())])
}

fn plural(count: u64, word: &str) -> String {
    if count == 1 { format!("1 {word}") } else { format!("{count} {word}s") }
}

/// One line for each test, more for those that did not pass, and the count.
pub fn text(finished: &[Finished]) -> String {
    let mut out = String::new();
    // What is wrong with a file that several programs share is printed once.
    let mut told = BTreeSet::new();
    // Writing to a text cannot fail.
    for test in finished {
        let Some((headline, mut lines)) = why(&test.outcome.verdict) else {
            let scans = plural(test.outcome.scans, "scan");
            let time = duration::show(test.outcome.simulated);
            // A test that only calls blocks needs neither.
            let took = match test.outcome.simulated {
                Duration::ZERO if test.outcome.scans == 0 => "no scan".to_owned(),
                Duration::ZERO => scans,
                _ => format!("{scans}, {time} of virtual time"),
            };
            let _ = writeln!(out, "ok    {}  ({took})", test.name);
            notes(&mut out, test);
            continue;
        };
        if let Verdict::DoesNotCompile(findings) = &test.outcome.verdict {
            lines = untold(findings, &mut told);
        }
        // A unit test has a name of its own beside the place.
        let (headline, first) = match &test.file {
            Some(file) if *file != test.name => (String::new(), Some(headline)),
            _ => match headline.strip_prefix(&format!("{}:", test.name)) {
                Some(rest) => (format!(":{rest}"), None),
                None => (format!(": {headline}"), None),
            },
        };
        let _ = writeln!(out, "FAIL  {}{headline}", test.name);
        for line in first.into_iter().chain(lines) {
            let _ = writeln!(out, "{}", format!("        {line}").trim_end());
        }
        notes(&mut out, test);
    }
    let _ = writeln!(out, "{}", count(finished));
    out
}

/// What there is to say of a test whether it passed or not.
fn notes(out: &mut String, test: &Finished) {
    // With `--strict` it is the headline.
    let told = |failed: &&Failed| matches!(&test.outcome.verdict, Verdict::Failed(wrong) if wrong.message == failed.line());
    if let Some(failed) = test.outcome.after.failed.as_ref().filter(|failed| !told(failed)) {
        let _ = writeln!(out, "        note: {}", failed.line());
    }
    for (index, line) in test.outcome.after.diagnostics.iter().enumerate() {
        let head = if index == 0 { "        diagnostic buffer, newest first:\n" } else { "" };
        let _ = writeln!(out, "{head}          {line}");
    }
}

/// The statements that failed in all tests, in one line.
pub fn failed_statements(finished: &[Finished]) -> Option<String> {
    let all: Vec<&Failed> = finished.iter().filter_map(|test| test.outcome.after.failed.as_ref()).collect();
    let tests = plural(all.len() as u64, "test");
    Some(format!("{} (in {tests} of {})", Failed::of_all(all)?.line(), finished.len()))
}

/// The lines of what is wrong with a program, without what was told before.
fn untold<'a>(findings: &'a [String], told: &mut BTreeSet<&'a str>) -> Vec<String> {
    let Some((count, findings)) = findings.split_last() else { return Vec::new() };
    let new: Vec<&String> = findings.iter().filter(|finding| told.insert(finding)).collect();
    let mut lines: Vec<String> = new.iter().flat_map(|finding| finding.lines()).map(str::to_owned).collect();
    match findings.len() - new.len() {
        0 => lines.extend(count.lines().map(str::to_owned)),
        1 if new.is_empty() => lines.push("the same message as above".to_owned()),
        all if new.is_empty() => lines.push(format!("the same {all} messages as above")),
        some => lines.push(format!("and {} from above", plural(some as u64, "message"))),
    }
    lines
}

/// What came of the programs of folders that hold several: `programs: 28 passed, 1 failed (ue3.awl), 1 without a test (ue9.awl)`.
pub fn programs(finished: &[Finished], programs: &[&str]) -> String {
    let of = |program: &str| finished.iter().filter(|test| test.program.as_deref() == Some(program)).collect::<Vec<_>>();
    let (mut passed, mut failed, mut none) = (0, Vec::new(), Vec::new());
    for program in programs {
        let tests = of(program);
        match () {
            () if tests.is_empty() => none.push(*program),
            () if tests.iter().all(|test| matches!(test.outcome.verdict, Verdict::Passed)) => passed += 1,
            () => failed.push(*program),
        }
    }
    let mut parts = vec![format!("{passed} passed")];
    for (word, names) in [("failed", failed), ("without a test", none)] {
        if !names.is_empty() {
            let shown: Vec<String> = names.iter().map(|name| visible::name(name)).collect();
            parts.push(format!("{} {word} ({})", names.len(), shown.join(", ")));
        }
    }
    format!("{} programs: {}\n", programs.len(), parts.join(", "))
}

/// `4 passed, 1 failed`.
pub fn count(finished: &[Finished]) -> String {
    let Tally { passed, failed, broken } = Tally::of(finished);
    let broken = if broken > 0 { format!(", {broken} could not run") } else { String::new() };
    format!("{passed} passed, {failed} failed{broken}")
}

/// One object with all tests.
pub fn to_json(finished: &[Finished], took: Duration) -> Value {
    let seconds = |duration: Duration| (duration.as_secs_f64() * 1e6).round() / 1e6;
    let tests: Vec<Value> = finished.iter().map(|test| one_to_json(test, seconds(test.took))).collect();
    let Tally { passed, failed, broken } = Tally::of(finished);
    json!({ "tests": tests, "passed": passed, "failed": failed, "broken": broken, "duration_s": seconds(took) })
}

fn one_to_json(test: &Finished, seconds: f64) -> Value {
    let verdict = match &test.outcome.verdict {
        Verdict::Passed => "passed",
        Verdict::NoTest => "no-test",
        Verdict::Failed(_) => "failed",
        Verdict::DoesNotCompile(_) => "does-not-compile",
        Verdict::Unreadable(_) | Verdict::Misread(_) => "unreadable",
    };
    let nothing = Wrong::default();
    let wrong = match &test.outcome.verdict {
        Verdict::Failed(wrong) => wrong,
        _ => &nothing,
    };
    let message = match &test.outcome.verdict {
        Verdict::Passed | Verdict::NoTest => None,
        Verdict::Failed(wrong) => Some(wrong.message.clone()),
        Verdict::DoesNotCompile(findings) => Some(findings.concat()),
        Verdict::Unreadable(refusal) => Some(refusal.message.clone()),
        Verdict::Misread(refusals) => refusals.first().map(|refusal| refusal.message.clone()),
    };
    let problem = match &test.outcome.verdict {
        Verdict::Unreadable(refusal) => Some(refusal.problem.code()),
        Verdict::Misread(refusals) => refusals.first().map(|refusal| refusal.problem.code()),
        _ => None,
    };
    let mut object = json!({
        "name": test.name, "program": test.program, "test_file": test.file, "verdict": verdict, "message": message,
        "file": wrong.place.as_ref().map(|place| &place.0), "line": wrong.place.as_ref().map(|place| place.1),
        "statement": wrong.statement, "block": wrong.block,
        "left": wrong.values.as_ref().map(|values| &values.0), "right": wrong.values.as_ref().map(|values| &values.1),
        "left_type": wrong.types.as_ref().map(|types| &types.0), "right_type": wrong.types.as_ref().map(|types| &types.1),
        "said": wrong.said, "more": wrong.lines, "problem": problem,
        "at_scan": wrong.moment.map(|moment| moment.scan), "at_ms": wrong.moment.map(|moment| duration::milliseconds(moment.time_us)),
        "scans": test.outcome.scans, "time_ms": test.outcome.simulated.as_secs_f64() * 1e3, "duration_s": seconds,
    });
    if let Some(failed) = &test.outcome.after.failed {
        object["failed_statements"] = failed.json();
    }
    if !test.outcome.after.diagnostics.is_empty() {
        object["diagnostic_buffer"] = json!(test.outcome.after.diagnostics);
    }
    object
}

/// JUnit XML, as build servers read it.
pub fn junit(finished: &[Finished], took: Duration) -> String {
    let Tally { passed: _, failed, broken } = Tally::of(finished);
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let _ = writeln!(
        out,
        "<testsuites>\n  <testsuite name=\"sieben\" tests=\"{}\" failures=\"{failed}\" errors=\"{broken}\" time=\"{:.3}\">",
        finished.len(),
        took.as_secs_f64()
    );
    for test in finished {
        let _ = write!(
            out,
            "    <testcase name=\"{}\" classname=\"{}\" time=\"{:.3}\"",
            escaped(&test.name),
            escaped(test.file.as_deref().unwrap_or("sieben")),
            test.took.as_secs_f64()
        );
        let Some((headline, lines)) = why(&test.outcome.verdict) else {
            out.push_str("/>\n");
            continue;
        };
        let kind = if matches!(test.outcome.verdict, Verdict::Failed(_)) { "failure" } else { "error" };
        let text = lines.join("\n");
        let _ = writeln!(out, ">\n      <{kind} message=\"{}\">{}</{kind}>\n    </testcase>", escaped(&headline), escaped(&text));
    }
    out.push_str("  </testsuite>\n</testsuites>\n");
    out
}

/// The Test Anything Protocol, version 14.
pub fn tap(finished: &[Finished]) -> String {
    let mut out = format!("TAP version 14\n1..{}\n", finished.len());
    for (index, test) in finished.iter().enumerate() {
        let name = test.name.replace('\\', "\\\\").replace('#', "\\#");
        match why(&test.outcome.verdict) {
            None => {
                let _ = writeln!(out, "ok {} - {name}", index + 1);
            }
            Some((headline, lines)) => {
                let _ = writeln!(out, "not ok {} - {name}\n  ---\n  message: {}", index + 1, json!(headline));
                if !lines.is_empty() {
                    let _ = writeln!(out, "  detail: {}", json!(lines.join("\n")));
                }
                out.push_str("  ...\n");
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Outcome;

    fn finished() -> Vec<Finished> {
        let test = |name: &str, verdict| Finished {
            name: name.to_owned(),
            file: None,
            program: None,
            outcome: Outcome { scans: 1, ..Outcome::nothing_ran(verdict) },
            took: Duration::from_millis(2),
        };
        vec![
            test("a.awl", Verdict::Passed),
            test(
                "b#1.awl",
                Verdict::Failed(Box::new(Wrong {
                    message: "expected 1 < 0".to_owned(),
                    place: Some(("b#1.awl".to_owned(), 3)),
                    statement: Some("__ASSERT< 1, 0".to_owned()),
                    block: Some("OB 1, statement 2".to_owned()),
                    values: Some(("1".to_owned(), "0".to_owned())),
                    ..Wrong::default()
                })),
            ),
            test("c.awl", Verdict::DoesNotCompile(vec!["one\ntwo\u{1}\n".to_owned()])),
        ]
    }

    #[test]
    fn people_see_the_place_once() {
        assert_eq!(
            text(&finished()),
            "ok    a.awl  (1 scan)\n\
             FAIL  b#1.awl:3: expected 1 < 0\n        __ASSERT< 1, 0  // OB 1, statement 2\n\
             FAIL  c.awl: does not compile\n        one\n        two\u{1}\n\
             1 passed, 1 failed, 1 could not run\n"
        );
        assert_eq!(worst(&finished()), Worst::DoesNotCompile);
        assert_eq!(worst(&finished()[..2]), Worst::Failed);
        assert_eq!(worst(&finished()[..1]), Worst::Passed);
    }

    #[test]
    fn what_is_wrong_with_a_shared_file_is_told_once() {
        let test = |name: &str, findings: &[&str]| Finished {
            name: name.to_owned(),
            file: None,
            program: Some(name.to_owned()),
            outcome: Outcome::nothing_ran(Verdict::DoesNotCompile(findings.iter().map(|&finding| finding.to_owned()).collect())),
            took: Duration::ZERO,
        };
        let all = [
            test("a", &["shared\n", "1 error.\n"]),
            test("b", &["own\n", "shared\n", "2 errors.\n"]),
            test("c", &["shared\n", "1 error.\n"]),
        ];
        assert_eq!(
            text(&all),
            "FAIL  a: does not compile\n        shared\n        1 error.\n\
             FAIL  b: does not compile\n        own\n        and 1 message from above\n\
             FAIL  c: does not compile\n        the same message as above\n\
             0 passed, 0 failed, 3 could not run\n"
        );
        assert_eq!(programs(&all, &["a", "b", "c", "d"]), "4 programs: 0 passed, 3 failed (a, b, c), 1 without a test (d)\n");
    }

    #[test]
    fn signs_of_xml_and_tap_are_escaped() {
        let xml = junit(&finished(), Duration::from_millis(5));
        assert!(xml.contains("tests=\"3\" failures=\"1\" errors=\"1\""), "{xml}");
        assert!(xml.contains("<failure message=\"b#1.awl:3: expected 1 &lt; 0\">__ASSERT&lt; 1, 0"), "{xml}");
        assert!(xml.contains("two␁"), "{xml}");
        let tap = tap(&finished());
        assert!(tap.starts_with("TAP version 14\n1..3\nok 1 - a.awl\nnot ok 2 - b\\#1.awl\n  ---\n"), "{tap}");
    }
}
