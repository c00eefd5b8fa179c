//! Power flow: what lines carry when statements did this and that.

use sieben_ide::drawing::flow::{Executed, Flow, Status, flows};
use sieben_ide::drawing::text::{Characters, text};
use sieben_ide::drawing::{Options, function_plan, ladder, svg};
use sieben_lang::network::flavour::Flavour;
use sieben_lang::network::form_b;
use sieben_lang::network::model::{Content, Element, End, Kind, Network, Place, Rung};
use sieben_lang::network::write::reads_tap;

/// Gives each element, and each sub-rung that begins with the tapped line, a statement of its own, in the order of the line; what lies inside of an element stands before it.
fn with_statements(text: &str) -> Network {
    let mut network = form_b::parse(text, 0, Flavour::S7).unwrap();
    if let Content::Rung(rung) = &mut network.content {
        number_rung(rung, &mut 0);
    }
    network
}

fn number_line(line: &mut [Element], next: &mut u32) {
    for element in line {
        let first = *next;
        match &mut element.kind {
            Kind::Parallel { branches, .. } => branches.iter_mut().for_each(|branch| number_line(&mut branch.line, next)),
            Kind::FlipFlop { second: Some(second), .. } => number_line(second, next),
            _ => {}
        }
        *next += 1;
        element.place = Place { first, last: *next - 1 };
    }
}

fn number_rung(rung: &mut Rung, next: &mut u32) {
    number_line(&mut rung.line, next);
    match &mut rung.end {
        End::Open => {}
        End::Outputs(outputs) => {
            for output in outputs {
                output.place = Place { first: *next, last: *next };
                *next += 1;
            }
        }
        End::Branches(rungs) => {
            for rung in rungs {
                if !reads_tap(&rung.line) {
                    rung.tap = Place { first: *next, last: *next };
                    *next += 1;
                }
                number_rung(rung, next);
            }
        }
    }
}

/// Statements that were executed: `1` and `0` found that, `-` found nothing; `.` was not executed. After `=` stand the operand and its value.
fn status(statements: &str) -> Status {
    let one = |word: &str| {
        let (found, value) = word.split_once('=').unwrap_or((word, ""));
        let found_bit = match found {
            "1" => Some(true),
            "0" => Some(false),
            _ => None,
        };
        let values = value.split_once(':').map(|(operand, value)| (operand.replace('_', " "), value.to_owned()));
        Executed { ran: found != ".", found: found_bit, logic: found_bit, values: values.into_iter().collect() }
    };
    Status { statements: statements.split_whitespace().map(one).collect() }
}

/// Both drawings of a diagram whose statements did this.
pub(crate) fn drawn(diagram: &str, statements: &str) -> [String; 2] {
    let network = with_statements(diagram);
    let status = status(statements);
    let line = |place: Place| place.first as usize;
    let options = Options::new(&line).with_status(&status);
    [ladder(&network, &options), function_plan(&network, &options)].map(|layout| {
        let layout = layout.unwrap();
        text(&layout, Some(&flows(&layout, Some(&status))), Characters::Unicode)
    })
}

#[test]
fn lines_carry_what_their_statements_found() {
    let mut wrong = String::new();
    for section in include_str!("status.md").split("\n## ").skip(1) {
        let blocks = super::blocks(section);
        let [(_, diagram), (_, statements), (_, lad), (_, fbd)] = blocks.as_slice() else { panic!("{section}: four blocks") };
        let drawn = drawn(diagram.trim(), statements);
        if drawn != [lad.clone(), fbd.clone()] {
            wrong += &format!("{diagram}{}\n{}", drawn[0], drawn[1]);
        }
    }
    assert!(wrong.is_empty(), "what is drawn now:\n{wrong}");
}

#[test]
fn a_picture_says_the_flow_and_value_of_each_element() {
    let network = with_statements("I 0.0 /I 0.1 -> = Q 4.0");
    let status = status("1=I_0.0:1 1=I_0.1:1 -=Q_4.0:0");
    let line = |place: Place| 120 + place.first as usize;
    let layout = ladder(&network, &Options::new(&line).with_status(&status)).unwrap();
    let flows = flows(&layout, Some(&status));
    let picture = svg::svg(&svg::Picture { title: "Network 1", layout: &layout, flows: Some(&flows) });
    for wanted in [
        r#"data-element="contact-120" data-flow="1" data-value="1""#,
        r#"data-element="contact-121" data-flow="0" data-value="1""#,
        r#"data-element="coil-122" data-flow="0" data-value="0""#,
    ] {
        assert!(picture.contains(wanted), "{wanted} in {picture}");
    }
    let words: Vec<&str> = Flow::ALL.iter().map(|row| row.1).collect();
    assert_eq!(words, ["1", "0", "not-run", "unknown"]);
}
