//! What is read, and what is said about the rest.

use proptest::prelude::*;
use sieben_sim::wrap::FaultKind;

use super::*;
use crate::spec::{Draw, Drawn, Law, Of, PropertyKind, Value, Walk};

const INTERLOCK: &str = r#"
[campaign]
name = "motor block"
program = "."
[exhaustive]
inputs = ["Start", "I 0.0..I 1.3"]
state = "initial"
[[never]]
name = "short circuit"
expr = "Star AND Delta"
[[sometimes]]
name = "it does start"
expr = 'Line AND "Star"'
"#;
const OVEN: &str = r#"
[campaign]
name = "oven"
for = "600s"
seed = 7
samples = 20
settle = "60s"
keep = "failures"
[set]
"On" = 1
"Mode" = "16#02"
[sweep]
"Recipe.reset_time" = { values = [20.0, 40.0, 80.0], unit = "s" }
"Recipe.gain" = { from = 1.0, to = 8.0, steps = 8 }
[draw]
"oven.gain" = { normal = [180.0, 8.0], unit = "K" }
"oven.noise" = { uniform = [0.0, 0.5] }
"oven.time_constant" = { log_uniform = [10, 100] }
"Kind" = { choice = [1, 2, 5] }
"Acknowledge" = { walk = { every = "2s", chance = 0.1 } }
[swarm]
faults = true
[[fault]]
chance = 0.25
signal = "oven.temperature"
fault = ["stuck", "drift=0.2"]
from = { uniform = ["60s", "300s"] }
for = "5s"
[[response]]
when = "On"
then = "Heater"
within = "2s"
[[finally]]
name = "it is warm"
expr = "Temperature > 90.0"
[[measure]]
name = "overshoot"
of = "max"
expr = "Temperature - 100.0"
unit = "K"
"#;
const SHIFT: &str = r#"
[campaign]
replay = "plant.scenario"
within = "20ms"
tolerance = 0.5
ignore = ["Clock"]
samples = 1000
[matrix]
program = ["old", "new"]
[[same]]
expr = "Level"
[disturb]
time = { uniform = ["-15ms", "15ms"] }
bounce = { chance = 0.2, for = "30ms" }
value = { normal = [0.0, 3.0] }
"#;

fn read(text: &str) -> Spec {
    let (spec, diagnostics) = parse(text, FileId(0));
    assert_eq!(diagnostics, [], "{text}");
    spec.expect("without a diagnostic there is one")
}

#[test]
fn every_combination() {
    let spec = read(INTERLOCK);
    assert_eq!(spec.name.as_deref(), Some("motor block"));
    let exhaustive = spec.exhaustive.expect("it is there");
    assert_eq!(exhaustive.inputs.iter().map(|input| input.text.as_str()).collect::<Vec<_>>(), ["Start", "I 0.0..I 1.3"]);
    let kinds: Vec<_> = spec.properties.iter().map(|property| (property.kind, property.name.as_str())).collect();
    assert_eq!(kinds, [(PropertyKind::Never, "short circuit"), (PropertyKind::Sometimes, "it does start")]);
    // A place in an expression is a place in the file.
    for (property, text) in spec.properties.iter().zip(["Star AND Delta", "Line AND \"Star\""]) {
        assert_eq!(&INTERLOCK[property.expression.span.start as usize..property.expression.span.end as usize], text);
    }
}

#[test]
fn a_grid_with_draws_and_faults() {
    let spec = read(OVEN);
    assert_eq!((spec.for_us, spec.settle_us, spec.seed, spec.samples), (Some(600_000_000), 60_000_000, 7, 20));
    assert_eq!((spec.programs[0].text.as_str(), spec.keep, spec.swarm_faults), (".", Some(Keep::Failures), true));
    assert_eq!(spec.set[1].value, Value::Text("16#02".to_owned()));
    // The order of the file, not of the alphabet: the last one runs fastest.
    assert_eq!(spec.sweep.iter().map(|sweep| sweep.name.text.as_str()).collect::<Vec<_>>(), ["Recipe.reset_time", "Recipe.gain"]);
    assert_eq!(
        spec.sweep[1].values.iter().filter_map(|value| if let Value::Number(n) = value { Some(*n) } else { None }).collect::<Vec<_>>(),
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]
    );
    let drawn: Vec<&Drawn> = spec.draw.iter().map(|Draw { drawn, .. }| drawn).collect();
    assert_eq!(drawn[0], &Drawn::Once(Law::Normal(180.0, 8.0)));
    assert_eq!(drawn[2], &Drawn::Once(Law::LogUniform(10.0, 100.0)));
    assert_eq!(drawn[3], &Drawn::Choice(vec![Value::Number(1.0), Value::Number(2.0), Value::Number(5.0)]));
    assert_eq!(drawn[4], &Drawn::Walk(Walk { every_us: 2_000_000, chance: 0.1, step: None, least: f64::MIN, most: f64::MAX }));
    let fault = &spec.faults[0];
    assert_eq!(
        (fault.stream.as_str(), fault.chance, fault.from, fault.lasts),
        ("oven.temperature", 0.25, Law::Uniform(60e6, 300e6), Some(Law::Fixed(5e6)))
    );
    assert_eq!(fault.kinds, [FaultKind::Stuck(None), FaultKind::Drift(0.2)]);
    assert_eq!((spec.properties[0].name.as_str(), spec.properties[0].within_us), ("On", 2_000_000));
    assert_eq!((spec.measures[0].of, spec.measures[0].unit.as_deref()), (Of::Max, Some("K")));
}

#[test]
fn a_recording_that_is_disturbed() {
    let spec = read(SHIFT);
    let replay = spec.replay.expect("it is there");
    assert_eq!((replay.within_us, replay.tolerance, replay.ignore), (20_000, Some(0.5), vec!["Clock".to_owned()]));
    assert_eq!(spec.programs.iter().map(|program| program.text.as_str()).collect::<Vec<_>>(), ["old", "new"]);
    let disturb = spec.disturb.expect("it is there");
    assert_eq!(
        (disturb.time, disturb.bounce, disturb.value),
        (Some(Law::Uniform(-15e3, 15e3)), Some((0.2, 30_000)), Some(Law::Normal(0.0, 3.0)))
    );
}

#[test]
fn every_mistake_has_a_sentence_and_a_place() {
    const NEVER: &str = "\n[[never]]\nexpr = \"A\"\n";
    for (text, code, part, place) in [
        ("a b", "P7156", "not valid TOML", ""),
        ("[campain]\nname = \"x\"", "P7157", "there is no key `campain`", "campain"),
        ("campaign = 5", "P7157", "`campaign` is a table", "5"),
        ("never = 5", "P7157", "[[never]]", "5"),
        ("never = [1]", "P7157", "[[never]]", "1"),
        ("[campaign]\nsampels = 5", "P7157", "there is no key `sampels` in `[campaign]`", "sampels"),
        ("[campaign]\nsamples = 0", "P7157", "whole number from 1", "0"),
        ("[campaign]\nsamples = -1", "P7157", "whole number from 1", "-1"),
        ("[campaign]\nseed = 1.5", "P7157", "whole number from 0", "1.5"),
        ("[campaign]\nfor = 60", "P7157", "is a duration", "60"),
        ("[campaign]\nfor = \"soon\"", "P7157", "is not a duration", "\"soon\""),
        ("[campaign]\nname = \"\"", "P7157", "is empty", "\"\""),
        ("[campaign]\nkeep = \"none\"", "P7157", "`\"all\"` or `\"failures\"`", "\"none\""),
        ("[campaign]\nwithin = \"20ms\"", "P7157", "belongs to a recording", "within"),
        ("[exhaustive]\ninputs = [\"A\"]\nstate = \"reachable\"", "P7159", "not there yet", "\"reachable\""),
        ("[exhaustive]\ninputs = [\"A\"]\nstate = \"any\"", "P7159", "not there yet", "\"any\""),
        ("[exhaustive]\nblock = \"FB 1\"", "P7157", "needs its bits", "exhaustive"),
        ("[set]\nA = 2026-11-29", "P7157", "a value is a number", "2026-11-29"),
        ("[set]\nA = nan", "P7157", "a value is a number", "nan"),
        ("[set]\nA = 1\n[sweep]\na = { values = [1] }", "P7157", "`a` has a value already", "a"),
        ("[sweep]\nA = 5", "P7157", "swept over several values", "5"),
        ("[sweep]\nRecipe.gain = { values = [1] }", "P7157", "`\"Recipe.gain\" = …`", "Recipe"),
        ("[set]\nRecipe.gain = 1", "P7157", "stands in quotes", "Recipe"),
        ("[campaign]\nprogram = \"a\"\n[matrix]\nprogram = [\"b\"]", "P7157", "not in both", "a"),
        ("[swarm]\nfaults = true", "P7157", "there is none", ""),
        ("[sweep]\nA = { values = [] }", "P7157", "list of 1 to", "[]"),
        ("[sweep]\nA = { values = [1, true] }", "P7157", "all numbers", "[1, true]"),
        ("[sweep]\nA = { from = 1, to = 2, steps = 0 }", "P7157", "whole number from 1", "0"),
        ("[sweep]\nA = { from = 1, to = 2, steps = 99999999 }", "P7157", "at most", "{ from = 1, to = 2, steps = 99999999 }"),
        (
            "[sweep]\nA = { from = 0, to = 2, steps = 3, log = true }",
            "P7157",
            "greater than 0",
            "{ from = 0, to = 2, steps = 3, log = true }",
        ),
        ("[sweep]\nA = { from = 1, values = [2] }", "P7157", "write `{ from", "{ from = 1, values = [2] }"),
        ("[draw]\nA = { uniform = [2, 1] }", "P7157", "not greater", "[2, 1]"),
        ("[draw]\nA = { normal = [2, -1] }", "P7157", "standard deviation", "[2, -1]"),
        ("[draw]\nA = { log_uniform = [0, 1] }", "P7157", "greater than 0", "[0, 1]"),
        ("[draw]\nA = { uniform = [1, 2], normal = [1, 2] }", "P7157", "how it is drawn", "{ uniform = [1, 2], normal = [1, 2] }"),
        ("[draw]\nA = { unifrom = [1, 2] }", "P7157", "there is no key `unifrom`", "unifrom"),
        ("[draw]\nA = { walk = { every = \"0\", chance = 0.1 } }", "P7157", "more than 0", "{ every = \"0\", chance = 0.1 }"),
        ("[draw]\nA = { walk = { every = \"1s\", chance = 2 } }", "P7157", "from 0 to 1", "2"),
        ("[[fault]]\nsignal = \"a.b\"", "P7157", "needs its signal and how it fails", "[[fault]]"),
        ("[[fault]]\nsignal = \"a.b\"\nfault = \"burns\"", "P7157", "`burns` is no fault", "burns"),
        ("[[fault]]\nsignal = \"a.b\"\nfault = \"stuck@3s\"", "P7157", "`from` and `for`", "stuck@3s"),
        ("[disturb]\ntime = \"5ms\"", "P7157", "disturbs a recording", ""),
        ("[campaign]\nreplay = \"x\"\nfor = \"5s\"", "P7157", "leave `for` out", "x"),
        ("[campaign]\nreplay = \"x\"\n[exhaustive]\ninputs = [\"A\"]", "P7159", "a recording has its inputs", "x"),
        ("[[never]]\nname = \"x\"", "P7157", "needs an expression", "[[never]]"),
        ("[[response]]\nwhen = \"A\"", "P7157", "`when`, `then` and `within`", "[[response]]"),
        ("[[same]]\nexpr = \"A\"", "P7157", "compares programs", "A"),
        ("[[measure]]\nexpr = \"A\"\nof = \"median\"", "P7157", "`of` is `min`", "\"median\""),
        ("[campaign]\nname = \"x\"", "P7157", "nothing is asked", "campaign"),
        ("", "P7157", "nothing is asked", ""),
    ] {
        let asks =
            part.contains("nothing is asked") || text.contains("[[") || text.contains("= [1]") || text == "never = 5" || text == "a b";
        let text = if asks { text.to_owned() } else { format!("{text}{NEVER}") };
        let (spec, diagnostics) = parse(&text, FileId(0));
        assert!(spec.is_none(), "{text}");
        let found = diagnostics
            .iter()
            .find(|one| one.problem.code() == code && (one.message.contains(part) || one.help.as_deref().unwrap_or("").contains(part)));
        let Some(found) = found else { panic!("{text}\n{diagnostics:#?}") };
        let at = &text[found.span.start as usize..found.span.end as usize];
        assert!(place.is_empty() || at.trim() == place, "{text}\n{at}\n{found:?}");
    }
}

#[test]
fn names_stand_once() {
    let two = "[[never]]\nname = \"x\"\nexpr = \"A\"\n[[measure]]\nname = \"x\"\nof = \"max\"\nexpr = \"B\"\n";
    let (_, diagnostics) = parse(two, FileId(0));
    assert!(diagnostics[0].message.contains("`x` is there already"), "{diagnostics:?}");
    let faults = "[[fault]]\nname = \"f\"\nsignal = \"a.b\"\nfault = \"stuck\"\n[[fault]]\nname = \"f\"\nsignal = \"a.c\"\nfault = \"stuck\"\n[[never]]\nexpr = \"A\"\n";
    let (_, diagnostics) = parse(faults, FileId(0));
    assert!(diagnostics[0].message.contains("two faults are called `f`"), "{diagnostics:?}");
}

#[test]
fn of_a_million_mistakes_a_hundred_are_told() {
    let text: String = (0..100_000).map(|n| format!("k{n} = {n}\n")).collect();
    let (spec, diagnostics) = parse(&text, FileId(0));
    assert!(spec.is_none());
    assert_eq!(diagnostics.len(), 101);
    assert_eq!(diagnostics[100].message, "and 99900 more after this one");
}

#[test]
fn steps_reach_both_ends() {
    let numbers =
        |all: Vec<Value>| all.into_iter().filter_map(|value| if let Value::Number(n) = value { Some(n) } else { None }).collect::<Vec<_>>();
    assert_eq!(numbers(values::steps(1.0, 2.0, 1, false)), [1.0]);
    assert_eq!(numbers(values::steps(0.1, 0.7, 3, false)), [0.1, 0.1 + (0.7 - 0.1) * 0.5, 0.7]);
    let log = numbers(values::steps(1.0, 100.0, 3, true));
    assert!((log[1] - 10.0).abs() < 1e-9 && log[0] == 1.0 && log[2] == 100.0);
}

proptest! {
    #[test]
    fn whatever_is_read_nothing_breaks(which in 0..3_usize, at in any::<prop::sample::Index>(), length in 0..6_usize, other in ".{0,6}") {
        let text = [INTERLOCK, OVEN, SHIFT][which];
        let mut at = at.index(text.len());
        while !text.is_char_boundary(at) { at -= 1; }
        let mut end = (at + length).min(text.len());
        while !text.is_char_boundary(end) { end -= 1; }
        let text = format!("{}{other}{}", &text[..at], &text[end.max(at)..]);
        let (spec, diagnostics) = parse(&text, FileId(0));
        prop_assert_eq!(spec.is_some(), diagnostics.is_empty());
        for diagnostic in diagnostics {
            prop_assert!(text.get(diagnostic.span.start as usize..diagnostic.span.end as usize).is_some());
        }
    }
}

#[test]
fn a_file_with_very_many_properties_is_refused_once() {
    let mut text = "[campaign]\nprogram = \".\"\nfor = \"1s\"\n".to_owned();
    for index in 0..20_000 {
        text.push_str(&format!("[[never]]\nexpr = \"a{index}\"\n"));
    }
    let (_, diagnostics) = parse(&text, FileId(0));
    let messages: Vec<&str> = diagnostics.iter().map(|diagnostic| diagnostic.message.as_str()).collect();
    assert_eq!(messages, ["a campaign has at most 1000 properties and measures: each is computed after every scan"]);
}
