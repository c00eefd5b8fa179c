//! The run as text and as JSON: a row for a statement, with its registers, what it changed and why.

use serde_json::{Map, Value, json};
use sieben_cpu::OperatingMode;
use sieben_model::block::BlockId;
use sieben_model::interface::Section;
use sieben_sim::history::{Breakpoint, By, Halt};
use sieben_sim::names::{Name, Setting};
use sieben_workspace::controller;
use sieben_workspace::failed::{self, Failed};
use sieben_workspace::names;

use super::commands::Answer;
use super::{Change, Language, Line, LocalValue, Stepper, View, Who, texts};
use crate::failure::{self, Failure};

/// The head of the columns.
pub(crate) fn head(language: Language) -> &'static str {
    texts::pick(language, texts::HEAD)
}

/// The row of the last statement: place, registers, text; below it what it changed and why.
pub(crate) fn row(stepper: &mut Stepper<'_>) -> String {
    let language = stepper.language;
    let view = stepper.view();
    let mut text = match &view.executed {
        None => format!("{:>9}  {:>4}  {}\n", 0, number(view.scan), stepper.say(texts::RUN_BEGINS, &[])),
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
    let reason = stepper.reason();
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
fn when(stepper: &Stepper<'_>, scan: Option<u64>) -> String {
    scan.map_or_else(|| stepper.say(texts::WHILE_STARTING, &[]), |scan| stepper.say(texts::IN_SCAN, &[&scan]))
}

/// What an answer prints.
pub(crate) fn answer(stepper: &mut Stepper<'_>, answer: &Answer) -> String {
    match answer {
        Answer::Moved(halt) => {
            let mut text = row(stepper);
            let view = stepper.view();
            for hit in &view.hits {
                text.push_str(&format!("  {hit}\n"));
            }
            let halt = if view.mode == OperatingMode::Stop && view.position > 0 { Halt::Stopped } else { *halt };
            if let Some(words) = halt_text(stepper, halt, &view) {
                text.push_str(&format!("  {words}\n"));
            }
            let next = match &view.next {
                Some(next) => Some(stepper.say(texts::NEXT, &[&next.file, &next.line, &next.said(stepper.language)])),
                None if view.mode == OperatingMode::Run => Some(stepper.say(texts::NEXT_SCAN, &[&stepper.history().scans()])),
                None => None,
            };
            text.push_str(&next.map_or_else(String::new, |next| format!("  {next}\n")));
            for name in stepper.watched() {
                text.push_str(&format!("  {} = {}\n", name.text(), stepper.value(name)));
            }
            text
        }
        Answer::Text(text) => text.clone(),
        Answer::Diagnostics => {
            let failed = match Failed::of(stepper.build(), stepper.cpu()) {
                Some(failed) => stepper.say(texts::FAILED_TIMES, &[&failed.count, &failed.first_line()]),
                None => stepper.say(texts::NONE_FAILED, &[]),
            };
            let entries = stepper.cpu().diagnostic_buffer().entries();
            let lines: String = entries.map(|entry| format!("    {}\n", failed::entry_text(stepper.build(), entry))).collect();
            format!("  {failed}\n  {}\n{lines}", stepper.say(texts::DIAGNOSTIC_BUFFER, &[]))
        }
        Answer::Values(names) => names.iter().map(|name| format!("  {} = {}\n", name.text(), stepper.value(name))).collect(),
        Answer::Locals(locals) => locals_text(stepper, locals.as_ref()),
        Answer::Set(Setting { name, text, .. }) => {
            let taken = name.holds(stepper.cpu(), text).unwrap_or(true);
            let later = if taken { "" } else { texts::pick(stepper.language, texts::SEEN_LATER) };
            format!("  {}{later}\n", stepper.say(texts::IS_SET, &[&name.text(), text]))
        }
        Answer::Who(name, who) => format!("  {}\n", who_text(stepper, name, who.as_ref())),
        Answer::Breakpoint(number, text) => format!("  {}\n", stepper.say(texts::BREAKPOINT, &[number, text])),
        Answer::Breakpoints if stepper.breakpoints().is_empty() => format!("  {}\n", stepper.say(texts::NO_BREAKPOINTS, &[])),
        Answer::Breakpoints => {
            let line = |one: &Breakpoint| format!("  {}\n", stepper.say(texts::BREAKPOINT_SEEN, &[&one.number, &one.text, &one.times]));
            stepper.breakpoints().iter().map(line).collect()
        }
        Answer::Nothing | Answer::Quit => String::new(),
    }
}

/// The variables of a block, in columns.
fn locals_text(stepper: &Stepper<'_>, locals: Option<&(BlockId, Vec<LocalValue>)>) -> String {
    let Some((block, values)) = locals else { return format!("  {}\n", stepper.say(texts::NO_BLOCK_RUNS, &[])) };
    let block = &stepper.listing().called(*block);
    if values.is_empty() {
        return format!("  {}\n", stepper.say(texts::NO_VARIABLES, &[block]));
    }
    let width = |width: &dyn Fn(&LocalValue) -> usize| values.iter().map(width).max().unwrap_or_default();
    let names = width(&|one| one.name.text().chars().count());
    let types = width(&|one| one.data_type.to_string().chars().count());
    let line = |one: &LocalValue| {
        let value = one.value.as_ref().map_or_else(|| "-".to_owned(), ToString::to_string);
        format!("    {:<7} {:names$}  {:types$}  {value}\n", section(one.section), one.name.text(), one.data_type.to_string())
    };
    format!("  {}\n", stepper.say(texts::VARIABLES_OF, &[block])) + &values.iter().map(line).collect::<String>()
}

/// The short word for a part of a declaration.
pub(crate) fn section(section: Section) -> &'static str {
    match section {
        Section::Input => "IN",
        Section::Output => "OUT",
        Section::InOut => "IN_OUT",
        Section::Static => "STAT",
        Section::Temp => "TEMP",
        Section::Return => "RETURN",
    }
}

/// Why a movement ended, if it is worth a word.
fn halt_text(stepper: &Stepper<'_>, halt: Halt, view: &View) -> Option<String> {
    Some(match halt {
        Halt::Reached | Halt::Watch => return None,
        Halt::ScanEnd => stepper.say(texts::END_OF_SCAN, &[&number(view.scan)]),
        Halt::Limit => stepper.say(texts::NOT_YET, &[]),
        Halt::Stopped => stepper.cpu().stop_cause().map_or_else(
            || stepper.say(texts::STOPPED, &[]),
            |cause| controller::stop_text(stepper.build(), cause).trim_end().replace('\n', "\n  "),
        ),
        Halt::NoMoreScans => stepper.say(texts::ALL_SCANS, &[&stepper.history().scans()]),
        Halt::Beginning => stepper.say(texts::BEGINNING, &[]),
        Halt::Forgotten => stepper.say(texts::FORGOTTEN, &[&stepper.history().first()]),
    })
}

fn who_text(stepper: &mut Stepper<'_>, name: &Name, who: Option<&Who>) -> String {
    let Some(who) = who else {
        let since = match stepper.history().first() {
            0 => stepper.say(texts::SINCE_BEGINNING, &[]),
            first => stepper.say(texts::SINCE_KEPT, &[&first]),
        };
        let written = stepper.writer(name).map_or_else(String::new, |by| {
            let Line { file, line, text, .. } = &by.line;
            let block = stepper.listing().called(by.line.place.block);
            let when = when(stepper, by.scan);
            format!("\n  {}", stepper.say(texts::WROTE_LAST, &[file, line, text, &block, &by.position, &when, &by.reason]))
        });
        return stepper.say(texts::NOTHING_CHANGED, &[&name.text(), &since]) + &written;
    };
    let (before, after) = &who.change;
    let what = match (&who.line, who.by) {
        (Some(line), _) => {
            let block = stepper.listing().called(line.place.block);
            format!("{}:{}: {} ({block})", line.file, line.line, line.said(stepper.language))
        }
        (None, By::ProcessImage) => stepper.say(texts::BY_IMAGE, &[]),
        (None, By::Set) => stepper.say(texts::BY_SET, &[]),
        (None, _) => stepper.say(texts::BY_CPU, &[]),
    };
    stepper.say(texts::CHANGED_BY, &[&name.text(), before, after, &who.position, &when(stepper, who.scan), &what])
}

/// A command that could not be carried out, as people read it.
pub(crate) fn failure(failure: &Failure, colour: bool, language: Language) -> String {
    let german = texts::HELP_GERMAN.iter().find(|(code, _)| *code == failure.refusal.problem.code());
    let help = match language {
        Language::German => german.map_or(failure.refusal.problem.help(), |(_, help)| help),
        Language::English => failure.refusal.problem.help(),
    };
    failure::render(&failure.refusal, colour, texts::pick(language, texts::ERROR), texts::pick(language, texts::HELP_WORD), help)
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
pub(crate) fn answer_json(stepper: &mut Stepper<'_>, command: &str, answer: &Answer) -> Value {
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
        "reason": stepper.reason(),
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
        Answer::Locals(locals) => {
            object["locals"] = locals.as_ref().map_or(Value::Null, |(block, values)| {
                let value = |one: &LocalValue| {
                    json!({ "section": section(one.section), "name": one.name.text(), "type": one.data_type.to_string(),
                            "value": one.value.as_ref().map_or(Value::Null, names::shown_json) })
                };
                json!({ "block": block.to_string(), "variables": values.iter().map(value).collect::<Vec<_>>() })
            });
        }
        Answer::Values(names) => object["values"] = Value::Object(shown(names, stepper)),
        Answer::Set(set) => object["set"] = json!({ "name": set.name.text(), "value": set.text }),
        Answer::Who(name, who) => {
            object["who"] = who.as_ref().map_or(Value::Null, |who| {
                json!({ "name": name.text(), "position": who.position, "scan": who.scan, "before": who.change.0, "after": who.change.1,
                        "place": who.line.as_ref().map(line_json) })
            });
            if who.is_none() {
                object["written"] = stepper.writer(name).map_or(Value::Null, |by| {
                    json!({ "name": name.text(), "position": by.position, "scan": by.scan, "place": line_json(&by.line), "reason": by.reason })
                });
            }
        }
        Answer::Breakpoint(number, text) => object["breakpoint"] = json!({ "number": number, "text": text }),
        Answer::Breakpoints => {
            let all = stepper.breakpoints().iter().map(|one| json!({ "number": one.number, "text": one.text, "times": one.times }));
            object["breakpoints"] = Value::Array(all.collect());
        }
        Answer::Diagnostics => {
            let (build, cpu) = (stepper.build(), stepper.cpu());
            object["diagnostic_buffer"] = failed::buffer_json(build, cpu);
            object["failed_statements"] = Failed::of(build, cpu).map(|failed| failed.json()).into();
        }
        Answer::Text(text) => object["text"] = json!(text),
        Answer::Nothing | Answer::Quit => {}
    }
    object
}

/// A command that could not be carried out.
pub(crate) fn failure_json(command: &str, failure: &Failure) -> Value {
    let refusal = &failure.refusal;
    json!({ "command": command, "error": { "code": refusal.problem.code(), "message": refusal.message, "help": refusal.shown_help() } })
}
