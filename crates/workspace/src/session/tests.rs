//! Whatever stands in a line of commands, the run stays what it is.

use std::path::Path;
use std::sync::Arc;

use proptest::prelude::*;
use sieben_engine::Interpreter;
use sieben_sim::history::Plan;

use super::commands::{ROWS, carry_out};
use super::{Language, Session, table};
use crate::controller;
use crate::project::{Build, Overrides, Project};

const SOURCE: &str = "DATA_BLOCK DB 1\nSTRUCT\n n : INT;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\nFUNCTION FC 1 : VOID\nVAR_TEMP\n n : INT;\nEND_VAR\nBEGIN\nL DB1.n\nT #n\n+ 1\nT DB1.n\n\
    END_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0\n= Q 4.0\nend: NOP 0\nNETWORK\nUC FC 1\nL DB1.n\nT MW 10\nEND_ORGANIZATION_BLOCK\n";

fn build() -> Arc<Build> {
    let mut project = Project::default();
    project.add_source(Path::new("main.awl"), SOURCE.as_bytes());
    Arc::new(project.compile(Overrides::default(), false))
}

/// Words that commands are made of, good and bad.
fn word() -> impl Strategy<Value = String> {
    let words = [
        "1",
        "2",
        "17",
        "0",
        "-1",
        "99999999999999999999",
        "FC1:2",
        "#n",
        "#n=3",
        "write #n",
        "write Q4.0",
        "FC 1.#n",
        "LW 0",
        "if #n > 1",
        "FC1:9",
        "OB1:end",
        "OB 1:1",
        ":",
        "1:",
        "MW10",
        "MW 10 > 3",
        "DB1.n",
        "DB1.n=5",
        "I0.0=1",
        "I0.0",
        "Q4.0",
        "if",
        "every",
        "back",
        "over",
        "scan",
        "=",
        ">",
        "<>",
        "\"",
        "\"a",
        "[",
        "16#",
        "STW",
        "STW.RLO",
        "T1",
        "C1=5",
        "é",
        "\u{0}",
        ",",
        "goto",
    ];
    prop_oneof![3 => proptest::sample::select(words.to_vec()).prop_map(str::to_owned), 1 => "\\PC{0,8}"]
}

fn line() -> impl Strategy<Value = String> {
    let verbs: Vec<&'static str> = ROWS.iter().flat_map(|row| row.names.iter().copied()).collect();
    (proptest::sample::select(verbs), proptest::collection::vec(word(), 0..4))
        .prop_map(|(verb, words)| format!("{verb} {}", words.join(" ")))
}

#[test]
fn no_line_of_commands_breaks_the_session() {
    let build = build();
    let settings = controller::settings(&build);
    proptest!(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() }, |(lines in proptest::collection::vec(line(), 1..25))| {
        let cpu = controller::load(&build, Interpreter::load, settings.clone());
        let mut session = Session::new(Arc::clone(&build), cpu, Plan::new(10_000, Some(40), Vec::new()));
        session.language = Language::German;
        for line in &lines {
            let before = session.history().position();
            match carry_out(&mut session, line, &mut |_| {}) {
                Ok(answer) => {
                    let _ = table::answer(&mut session, &answer);
                    let _ = table::answer_json(&mut session, line, &answer);
                }
                Err(refusal) => {
                    prop_assert!(!refusal.message.is_empty());
                    prop_assert_eq!(before, session.history().position());
                }
            }
            let history = session.history();
            prop_assert!(history.position().statements <= history.end());
        }
        // Where it stands can be left and found again.
        let (here, machine) = (session.history().position(), session.cpu().machine().clone());
        session.history.go_to(0);
        session.history.go_to_position(here);
        prop_assert_eq!(session.history().position(), here);
        prop_assert!(*session.cpu().machine() == machine);
    });
}
