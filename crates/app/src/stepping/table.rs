//! The run as text and as JSON: a row for a statement, with its registers, what it changed and why.

use serde_json::{Map, Value, json};
use sieben_cpu::OperatingMode;
use sieben_sim::history::Halt;
use sieben_sim::names::Name;

use super::commands::Answer;
use super::{Change, Language, Line, Stepper, View, Who};
use crate::failure::Failure;
use crate::{controller, names};

/// The head of the columns.
pub(crate) const HEAD: &str = "      pos  scan  place           RLO STA /FC OR CC OV OS BR  ACCU1        ACCU2        statement\n";

/// The row of the last statement: place, registers, text; below it what it changed and why.
pub(crate) fn row(stepper: &mut Stepper<'_>, language: Language) -> String {
    let view = stepper.view();
    let mut text = match &view.executed {
        None => format!("{:>9}  {:>4}  the run begins\n", 0, number(view.scan)),
        Some(line) => {
            let value = |name: &str| view.registers.iter().find(|(found, _)| *found == name).map_or("", |(_, value)| value.as_str());
            let bits: Vec<String> = ["RLO", "STA", "/FC"].iter().map(|name| format!("{:>3}", value(name))).collect();
            format!(
                "{:>9}  {:>4}  {:<14}  {} {:>2} {:>2} {:>2} {:>2} {:>2}  {:<11}  {:<11}  {}\n",
                view.position,
                number(view.scan),
                format!("{}:{}", short(&line.file), line.line),
                bits.join(" "),
                value("OR"),
                value("CC"),
                value("OV"),
                value("OS"),
                value("BR"),
                value("ACCU1"),
                value("ACCU2"),
                line.said(language)
            )
        }
    };
    let reason = stepper.reason(language);
    if !reason.is_empty() {
        text.push_str(&format!("                 {reason}\n"));
    }
    let others = view.changed.iter().filter(|change| !COLUMNS.contains(&change.name.as_str()));
    let others: Vec<String> = others.map(|change| format!("{}: {} -> {}", change.name, change.before, change.after)).collect();
    if !others.is_empty() {
        text.push_str(&format!("                 {}\n", others.join("; ")));
    }
    text
}

/// Registers that have a column.
const COLUMNS: [&str; 10] = ["RLO", "STA", "/FC", "OR", "CC", "OV", "OS", "BR", "ACCU1", "ACCU2"];

/// The last part of a path, at most 10 characters of it.
fn short(file: &str) -> String {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    if name.chars().count() <= 10 { name.to_owned() } else { name.chars().take(9).chain(['~']).collect() }
}

/// The number of a scan; `-` while the CPU starts.
fn number(scan: Option<u64>) -> String {
    scan.map_or_else(|| "-".to_owned(), |scan| scan.to_string())
}

/// In which scan.
fn when(scan: Option<u64>) -> String {
    scan.map_or_else(|| "while the CPU started".to_owned(), |scan| format!("in scan {scan}"))
}

/// What an answer prints.
pub(crate) fn answer(stepper: &mut Stepper<'_>, answer: &Answer, language: Language) -> String {
    match answer {
        Answer::Moved(halt) => {
            let mut text = row(stepper, language);
            let view = stepper.view();
            for hit in &view.hits {
                text.push_str(&format!("  {hit}\n"));
            }
            let halt = if view.mode == OperatingMode::Stop && view.position > 0 { Halt::Stopped } else { *halt };
            if let Some(words) = halt_text(stepper, halt, &view) {
                text.push_str(&format!("  {words}\n"));
            }
            text.push_str(&match &view.next {
                Some(next) => format!("  next: {}:{}: {}\n", next.file, next.line, next.said(language)),
                None if view.mode == OperatingMode::Run => format!("  next: scan {} begins\n", stepper.history().scans()),
                None => String::new(),
            });
            for name in stepper.watched() {
                text.push_str(&format!("  {} = {}\n", name.text(), stepper.value(name)));
            }
            text
        }
        Answer::Text(text) => text.clone(),
        Answer::Values(names) => names.iter().map(|name| format!("  {} = {}\n", name.text(), stepper.value(name))).collect(),
        Answer::Set(name, value) => {
            let taken = name.accepts(value).is_ok() && name.holds(stepper.cpu(), value).unwrap_or(true);
            let later = if taken { "" } else { ", seen at the next cycle control point" };
            format!("  {} is set to {value}{later}\n", name.text())
        }
        Answer::Who(name, who) => format!("  {}\n", who_text(stepper, name, who.as_ref(), language)),
        Answer::Breakpoint(number, text) => format!("  breakpoint {number}: {text}\n"),
        Answer::Breakpoints if stepper.breakpoints().is_empty() => "  no breakpoints\n".to_owned(),
        Answer::Breakpoints => {
            stepper.breakpoints().iter().map(|one| format!("  {}: {} (seen {} times)\n", one.number, one.text, one.times)).collect()
        }
        Answer::Nothing | Answer::Quit => String::new(),
    }
}

/// Why a movement ended, if it is worth a word.
fn halt_text(stepper: &Stepper<'_>, halt: Halt, view: &View) -> Option<String> {
    Some(match halt {
        Halt::Reached | Halt::Watch => return None,
        Halt::ScanEnd => format!("the end of scan {}", number(view.scan)),
        Halt::Limit => "it has not come there yet; the same command goes on".to_owned(),
        Halt::Stopped => stepper.cpu().stop_cause().map_or_else(
            || "the CPU is in STOP".to_owned(),
            |cause| controller::stop_text(stepper.build(), cause).trim_end().replace('\n', "\n  "),
        ),
        Halt::NoMoreScans => format!("all {} scans have run", stepper.history().scans()),
        Halt::Beginning => "this is the beginning".to_owned(),
        Halt::Forgotten => {
            format!("what lies further back is no longer kept; the history begins after statement {}", stepper.history().first())
        }
    })
}

fn who_text(stepper: &mut Stepper<'_>, name: &Name, who: Option<&Who>, language: Language) -> String {
    let Some(who) = who else {
        let since = match stepper.history().first() {
            0 => "since the beginning".to_owned(),
            first => format!("since statement {first}, where the kept history begins"),
        };
        let written = stepper.writer(name, language).map_or_else(String::new, |by| {
            let Line { file, line, text, block, .. } = &by.line;
            format!("\n  {file}:{line}: {text} ({block}) wrote it last, after statement {} {}: {}", by.position, when(by.scan), by.reason)
        });
        return format!("nothing has changed `{}` {since}{written}", name.text());
    };
    let (before, after) = &who.change;
    let what = match &who.line {
        Some(line) => format!("{}:{}: {} ({})", line.file, line.line, line.text, line.block),
        None => "no statement: the process image, a value set from outside, or the CPU".to_owned(),
    };
    format!("{}: {before} -> {after} after statement {} {}, by {what}", name.text(), who.position, when(who.scan))
}

fn line_json(line: &Line) -> Value {
    json!({ "block": line.block, "statement": u64::from(line.place.statement) + 1, "network": line.network, "file": line.file,
            "line": line.line, "text": line.text })
}

fn change_json(change: &Change) -> Value {
    json!({ "name": change.name, "before": change.before, "after": change.after })
}

/// A word for why a movement ended.
fn halt_word(halt: Halt) -> &'static str {
    match halt {
        Halt::Reached => "reached",
        Halt::Watch => "breakpoint",
        Halt::ScanEnd => "scan end",
        Halt::Limit => "limit",
        Halt::Stopped => "stopped",
        Halt::NoMoreScans => "no more scans",
        Halt::Beginning => "beginning",
        Halt::Forgotten => "forgotten",
    }
}

/// What an answer is for programs: where the run stands, and what the command asked for.
pub(crate) fn answer_json(stepper: &mut Stepper<'_>, command: &str, answer: &Answer, language: Language) -> Value {
    let view = stepper.view();
    let registers: Map<String, Value> = view.registers.iter().map(|(name, value)| ((*name).to_owned(), json!(value))).collect();
    let stop = stepper.cpu().stop_cause().filter(|_| view.mode == OperatingMode::Stop).map(controller::stop_json);
    let mut object = json!({
        "command": command,
        "position": view.position,
        "end": view.end,
        "present": view.present,
        "scan": view.scan,
        "time_us": view.time_us,
        "place": view.executed.as_ref().map(line_json),
        "next": view.next.as_ref().map(line_json),
        "registers": registers,
        "changed": view.changed.iter().map(change_json).collect::<Vec<_>>(),
        "reason": stepper.reason(language),
        "stack": view.stack.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "mode": view.mode.to_string(),
        "stop": stop,
    });
    let shown = |names: &[Name], stepper: &Stepper<'_>| -> Map<String, Value> {
        names.iter().map(|name| (name.text().to_owned(), names::to_json(name, stepper.cpu()))).collect()
    };
    match answer {
        Answer::Moved(halt) => {
            object["halt"] = json!(halt_word(*halt));
            object["hits"] = json!(view.hits);
            if !stepper.watched().is_empty() {
                object["values"] = Value::Object(shown(stepper.watched(), stepper));
            }
        }
        Answer::Values(names) => object["values"] = Value::Object(shown(names, stepper)),
        Answer::Set(name, value) => object["set"] = json!({ "name": name.text(), "value": value }),
        Answer::Who(name, who) => {
            object["who"] = who.as_ref().map_or(Value::Null, |who| {
                json!({ "name": name.text(), "position": who.position, "scan": who.scan, "before": who.change.0, "after": who.change.1,
                        "place": who.line.as_ref().map(line_json) })
            });
            if who.is_none() {
                object["written"] = stepper.writer(name, language).map_or(Value::Null, |by| {
                    json!({ "name": name.text(), "position": by.position, "scan": by.scan, "place": line_json(&by.line), "reason": by.reason })
                });
            }
        }
        Answer::Breakpoint(number, text) => object["breakpoint"] = json!({ "number": number, "text": text }),
        Answer::Breakpoints => {
            let all = stepper.breakpoints().iter().map(|one| json!({ "number": one.number, "text": one.text, "times": one.times }));
            object["breakpoints"] = Value::Array(all.collect());
        }
        Answer::Text(text) => object["text"] = json!(text),
        Answer::Nothing | Answer::Quit => {}
    }
    object
}

/// A command that could not be carried out.
pub(crate) fn failure_json(command: &str, failure: &Failure) -> Value {
    let help = failure.help.as_deref().unwrap_or(failure.problem.help());
    json!({ "command": command, "error": { "code": failure.problem.code(), "message": failure.message, "help": crate::report::capitalized(help) } })
}
