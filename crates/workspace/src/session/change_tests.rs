//! A session goes on when another program takes over.

use std::path::Path;
use std::sync::Arc;

use sieben_cpu::Loaded;
use sieben_engine::Interpreter;
use sieben_sim::history::{ChangeError, Halt, Plan};
use sieben_sim::names::{Name, Setting};

use super::commands::{Answer, carry_out};
use super::{Changed, Direction, LostKind, Session, Unit, table};
use crate::controller;
use crate::project::{Build, Overrides, Project};

/// The program before: `n` is at byte 0, line 25 writes MW 10.
const BEFORE: &str = "\
FUNCTION_BLOCK FB 1
VAR
 level : INT;
END_VAR
BEGIN
L #level
+ 1
T #level
END_FUNCTION_BLOCK
DATA_BLOCK DB 1
STRUCT
 n : INT;
 gone : INT;
END_STRUCT
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 2 FB 1
BEGIN
END_DATA_BLOCK
FUNCTION FC 1 : VOID
BEGIN
L DB1.n
+ 1
T DB1.n
T MW 10
END_FUNCTION
ORGANIZATION_BLOCK OB 1
BEGIN
UC FC 1
CALL FB 1, DB 2
END_ORGANIZATION_BLOCK
";

fn build(source: &str) -> Arc<Build> {
    let mut project = Project::default();
    project.add_source(Path::new("main.awl"), source.as_bytes());
    let build = project.compile(Overrides::default(), false);
    assert_eq!(build.findings.iter().map(|finding| finding.message()).collect::<Vec<_>>(), [""; 0]);
    Arc::new(build)
}

fn loaded(build: &Build) -> Loaded {
    controller::loaded(build, Interpreter::load)
}

/// A session with the program before, in which `timed` is set 50 ms after the beginning.
fn session(timed: &[&str]) -> Session {
    let build = build(BEFORE);
    let cpu = controller::load(&build, Interpreter::load, controller::settings(&build));
    let setting = |text: &&str| {
        let (name, value) = text.split_once('=').expect("NAME=VALUE");
        let name = Name::parse(name, &build.project.symbols, cpu.program()).expect("the name is known");
        (50_000, Setting::new(name, value).expect("the value fits"))
    };
    let timed = timed.iter().map(setting).collect();
    Session::new(Arc::clone(&build), cpu, Plan::new(10_000, None, timed))
}

fn carry(session: &mut Session, line: &str) -> Answer {
    carry_out(session, line, &mut |_| {}).unwrap_or_else(|refusal| panic!("{line}: {}", refusal.message))
}

fn change(session: &mut Session, source: &str) -> Changed {
    let build = build(source);
    let loaded = loaded(&build);
    session.change(build, loaded).expect("the CPU takes it")
}

#[test]
fn breakpoints_and_names_follow_the_words_of_the_user() {
    let mut session = session(&["DB1.n=100", "DB1.gone=7"]);
    carry(&mut session, "show DB1.n,DB1.gone,MW10");
    carry(&mut session, "break FC1:4");
    carry(&mut session, "break main.awl:25");
    carry(&mut session, "break FC1:1");
    carry(&mut session, "break DB1.n > 4 every 2");
    carry(&mut session, "break write DB1.gone");
    carry(&mut session, "to FB1:1");
    carry(&mut session, "watch #level");
    carry(&mut session, "scan 3");
    // Two lines more stand before everything; `n` lies two bytes further, `level` four; FC 1 writes MW 12, too.
    let after = BEFORE
        .replace("FUNCTION_BLOCK FB 1\n", "// Two\n// lines.\nFUNCTION_BLOCK FB 1\n")
        .replace(" level : INT;\n", " first : DINT;\n level : INT;\n")
        .replace(" n : INT;\n gone : INT;\n", " first : INT;\n n : INT;\n")
        .replace("T MW 10\n", "T MW 12\nT MW 10\n");
    let before: Vec<String> = session.watched().to_vec().iter().map(|name| session.value(name)).collect();
    let changed = change(&mut session, &after);
    let lost: Vec<(LostKind, &str)> = changed.lost.iter().map(|lost| (lost.what, lost.text.as_str())).collect();
    assert_eq!(
        lost,
        [(LostKind::Setting, "DB1.gone=7"), (LostKind::Watched, "DB1.gone"), (LostKind::Breakpoint(5), "write DB1.gone")],
        "{:?}",
        changed.lost
    );
    assert!(changed.lost.iter().all(|lost| !lost.why.is_empty()));
    // The values are kept by name, and shown from where they lie now.
    let now: Vec<String> = session.watched().to_vec().iter().map(|name| session.value(name)).collect();
    assert_eq!((before[0].as_str(), now.len()), (now[0].as_str(), 2));
    // What is before is no longer kept.
    assert_eq!(session.step(Unit::Statement, Direction::Back, 1), Halt::Forgotten);
    // Three lines more stand before `FC 1`: `main.awl:25` is where `FC1:1` is, and `FC1:4` is the statement before the one that it was.
    let lines: Vec<String> = table::answer(&mut session, &Answer::Breakpoints).lines().map(|line| line.trim().to_owned()).collect();
    assert_eq!(lines.len(), 5, "{lines:?}");
    let mut paused = Vec::new();
    for _ in 0..4 {
        assert_eq!(session.run(Direction::Forward, 1000), Halt::Watch);
        let view = session.view();
        paused.push((view.next.map(|line| line.text).unwrap_or_default(), view.hits.len()));
    }
    let expected = [("L DB1.n", 2), ("T MW 12", 1), ("end of the block", 1), ("L DB1.n", 2)];
    assert_eq!(paused.iter().map(|(next, hits)| (next.as_str(), *hits)).collect::<Vec<_>>(), expected);
}

#[test]
fn a_variable_of_an_instance_stays_with_its_data_block() {
    let mut session = session(&[]);
    carry(&mut session, "to FB1:1");
    carry(&mut session, "watch #level");
    carry(&mut session, "scan");
    let changed = change(&mut session, &BEFORE.replace(" level : INT;\n", " first : DINT;\n level : INT;\n"));
    assert_eq!(changed.lost, []);
    assert_eq!(session.run(Direction::Forward, 1000), Halt::Watch);
    let view = session.view();
    assert_eq!(view.executed.map(|line| line.text).as_deref(), Some("T #level"));
    assert!(view.hits[0].contains("1 -> 2"), "{:?}", view.hits);
    // Without the instance there is nothing to look at.
    carry(&mut session, "scan");
    let changed =
        change(&mut session, &BEFORE.replace("DATA_BLOCK DB 2 FB 1\nBEGIN\nEND_DATA_BLOCK\n", "").replace("CALL FB 1, DB 2\n", ""));
    assert_eq!(changed.lost.iter().map(|lost| lost.what).collect::<Vec<_>>(), [LostKind::Breakpoint(1)]);
}

#[test]
fn what_is_set_later_goes_where_the_variable_lies_now() {
    let mut session = session(&["DB1.n=100"]);
    carry(&mut session, "scan 2");
    let changed = change(&mut session, &BEFORE.replace(" n : INT;\n", " first : INT;\n n : INT;\n"));
    assert_eq!(changed.lost, []);
    carry(&mut session, "scan 5");
    let Answer::Values(names) = carry(&mut session, "print DB1.first,DB1.n") else { panic!("values are printed") };
    assert_eq!(names.iter().map(|name| session.value(name)).collect::<Vec<_>>(), ["0", "102"]);
}

#[test]
fn a_change_inside_a_scan_is_refused_and_changes_nothing() {
    let mut session = session(&[]);
    carry(&mut session, "break FC1:1");
    carry(&mut session, "step 3");
    let (position, old) = (session.history().position(), Arc::clone(session.build()));
    let new = build(&BEFORE.replace("+ 1\n", "+ 2\n"));
    let loaded = loaded(&new);
    assert!(matches!(session.change(new, loaded), Err(ChangeError::Refused(_))));
    assert!(Arc::ptr_eq(session.build(), &old));
    assert_eq!((session.history().position(), session.breakpoints().len()), (position, 1));
    assert_eq!(session.step(Unit::Statement, Direction::Back, 1), Halt::Reached);
}

#[test]
fn in_the_past_what_lay_ahead_is_forgotten() {
    let mut session = session(&[]);
    carry(&mut session, "scan 5");
    carry(&mut session, "back scan 3");
    let changed = change(&mut session, &BEFORE.replace("+ 1\n", "+ 10\n"));
    assert_eq!(changed.lost, []);
    assert!(session.history().is_at_present());
    carry(&mut session, "scan");
    let Answer::Values(names) = carry(&mut session, "print DB1.n") else { panic!("values are printed") };
    assert_eq!(session.value(&names[0]), "12");
}
