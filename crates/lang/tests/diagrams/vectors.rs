//! The table of networks: what each is drawn as or why it is not, and which statements a diagram stands for.

use sieben_lang::network::flavour::{Drawing, Flavour};
use sieben_lang::network::form_b::{parse, print};
use sieben_lang::network::read::compare::difference;
use sieben_lang::network::read::{Answer, Mode, draw, read};
use sieben_lang::network::to_lad::to_lad;
use sieben_lang::network::write::write;

use crate::blocks::blocks_of;
use crate::statements::{PLAIN, all_shown, first_scratch, statements};

struct Row {
    id: String,
    kind: String,
    input: String,
    expected: String,
}

fn rows() -> Vec<Row> {
    let table = include_str!("vectors.csv");
    let rows = csv::Reader::from_reader(table.as_bytes()).into_records().map(|record| {
        let record = record.expect("the table is readable");
        let field = |index: usize| record.get(index).expect("five columns").to_owned();
        Row { id: field(0), kind: field(1), input: field(2), expected: field(3) }
    });
    rows.collect()
}

fn codes<T: ToString>(codes: impl IntoIterator<Item = T>) -> String {
    codes.into_iter().map(|code| code.to_string()).collect::<Vec<_>>().join(",")
}

/// The drawing that the row shows, and the answer in its words.
fn answer(row: &Row) -> String {
    let input = statements(&row.input);
    let drawing = if row.expected.starts_with("exact in FBD") { Drawing::Fbd } else { Drawing::Lad };
    match draw(&input, &PLAIN, first_scratch(&input), Mode::Rewriting) {
        Answer::Exact(network) if drawing == Drawing::Fbd => {
            let lad = match to_lad(&network) {
                Ok((lad, rewrites)) => format!("equivalent {}: {}", codes(rewrites), print(&lad, Drawing::Lad)),
                Err(refusal) => format!("{} at statement {}", refusal.reason, refusal.statement + 1),
            };
            format!("exact in FBD: {} | in LAD: {lad}", print(&network, drawing))
        }
        Answer::Exact(network) => format!("exact: {}", print(&network, drawing)),
        Answer::Equivalent(reading, _) => {
            let networks: Vec<String> = reading.networks.iter().map(|network| print(network, drawing)).collect();
            format!("equivalent {}: {}", codes(&reading.rewrites), networks.join(" // "))
        }
        Answer::No(refusal) => format!("{} at statement {}", refusal.reason, refusal.statement + 1),
    }
}

#[test]
fn networks_are_drawn_as_the_table_has_them() {
    let mut wrong = Vec::new();
    for row in rows().iter().filter(|row| row.kind == "stl2lad") {
        let answer = answer(row);
        if answer != row.expected {
            wrong.push(format!("{} {}\n  expected {}\n  answered {answer}", row.id, row.input, row.expected));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn what_cannot_be_drawn_is_refused_at_the_statement_of_the_table() {
    let mut wrong = Vec::new();
    for row in rows().iter().filter(|row| row.kind == "why-not") {
        let answer = match read(&statements(&row.input), &PLAIN, Mode::Strict) {
            Ok(reading) => print(&reading.networks[0], Drawing::Lad),
            Err(refusal) => format!("{} at statement {}", refusal.reason, refusal.statement + 1),
        };
        if answer != row.expected {
            wrong.push(format!("{} {}\n  expected {}\n  answered {answer}", row.id, row.input, row.expected));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn diagrams_stand_for_the_statements_of_the_table() {
    let mut wrong = Vec::new();
    for row in rows().iter().filter(|row| row.kind.ends_with("-meaning")) {
        let drawing = if row.kind == "lad-meaning" { Drawing::Lad } else { Drawing::Fbd };
        let diagrams = row.input.split(" || ").next().unwrap_or_default();
        let programs = row.expected.trim_start_matches("STL: ").split(" || ").next().unwrap_or_default();
        let mut labels = 0;
        let rungs = blocks_of(diagrams);
        let blocks = blocks_of(programs);
        for (name, networks) in &rungs {
            let Some((_, programs)) = blocks.iter().find(|(other, _)| other == name) else { panic!("{}: {name}", row.id) };
            assert_eq!(networks.len(), programs.len(), "{}", row.id);
            for (line, program) in networks.iter().zip(programs) {
                let network = parse(line, 0, Flavour::S7).unwrap_or_else(|wrong| panic!("{}: {line}: {wrong:?}", row.id));
                let again = print(&network, drawing);
                let program = statements(program);
                let written = write(&network, first_scratch(&program), &mut labels).statements;
                let same = difference(&program, &written, &PLAIN).is_some_and(|codes| codes.is_empty());
                if again.replace(' ', "") != line.replace(' ', "") || !same {
                    wrong.push(format!(
                        "{} {line}\n  {again}\n  expected {}\n  written  {}",
                        row.id,
                        all_shown(&program),
                        all_shown(&written)
                    ));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
