//! The run as text and as JSON: a row for a statement, with its registers, what it changed and why.

use serde_json::{Map, Value, json};
use sieben_cpu::OperatingMode;
use sieben_model::interface::Section;
use sieben_sim::history::{Breakpoint, By, Halt};
use sieben_sim::names::{Name, Setting, Shown};

use super::commands::Answer;
use super::{Change, Language, Line, LocalValue, Session, Variables, View, Who, texts};
use crate::controller;
use crate::failed::{self, Failed};
use crate::names;
use crate::refusal::Refusal;

/// What stands in the rows of statements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Columns {
    /// The registers, then the statement.
    Registers,
    /// The statement, then the variables that it names.
    Variables,
}

impl Columns {
    fn of(on_registers: bool) -> Self {
        if on_registers { Self::Registers } else { Self::Variables }
    }

    fn head(self, language: Language) -> &'static str {
        texts::pick(language, if self == Self::Registers { texts::HEAD } else { texts::HEAD_OF_VARIABLES })
    }
}

/// Columns of a statement of ST at least: after it stand the variables.
const STATEMENT_WIDTH: usize = 44;

/// The head of the columns of the block that runs first, or of the one where the run stands.
pub fn head(session: &mut Session) -> &'static str {
    let columns = Columns::of(session.on_registers(session.here()));
    session.columns = Some(columns);
    columns.head(session.language)
}

/// The row of the last statement: place, registers or values, text; below it what it changed and why. Where a block of another language begins, a
/// head for its columns stands above.
pub fn row(session: &mut Session) -> String {
    let language = session.language;
    let view = session.view();
    let columns = Columns::of(view.on_registers);
    let mut text = String::new();
    if view.executed.is_some() && session.columns.is_some_and(|printed| printed != columns) {
        session.columns = Some(columns);
        text.push_str(columns.head(language));
    }
    text.push_str(&match &view.executed {
        None => format!("{:>9}  {:>4}  {}\n", 0, number(view.scan), session.say(texts::RUN_BEGINS, &[])),
        Some(line) => {
            let place = format!("{}:{}", short(&line.file), line.line);
            let begin = format!("{:>9}  {:>4}  {place:<14}", view.position, number(view.scan));
            match columns {
                Columns::Registers => format!("{begin}  {}  {}\n", registers_of(&view), line.said(language)),
                Columns::Variables if view.values.is_empty() => format!("{begin}  {}\n", line.said(language)),
                Columns::Variables => format!("{begin}  {:<STATEMENT_WIDTH$}  // {}\n", line.said(language), after(&view.values)),
            }
        }
    });
    let reason = session.reason();
    if !reason.is_empty() {
        text.push_str(&format!("                 {reason}\n"));
    }
    let others = view.changed.iter().filter(|change| match columns {
        Columns::Registers => !COLUMNS.contains(&change.name.as_str()),
        // The registers of a call of ST are those of the compiler.
        Columns::Variables => !view.registers.iter().any(|(name, _)| *name == change.name),
    });
    let others: Vec<String> = others.map(|change| format!("{}: {} -> {}", change.name, change.before, change.after)).collect();
    if !others.is_empty() {
        text.push_str(&format!("                 {}\n", others.join("; ")));
    }
    text
}

/// The registers in their columns.
fn registers_of(view: &View) -> String {
    let value = |name: &str| view.registers.iter().find(|(found, _)| *found == name).map_or("", |(_, value)| value.as_str());
    let bits: Vec<String> = ["RLO", "STA", "/FC"].iter().map(|name| format!("{:>3}", value(name))).collect();
    let narrow: Vec<String> = ["OR", "CC", "OV", "OS", "BR"].iter().map(|name| format!("{:>2}", value(name))).collect();
    format!("{} {}  {:<11}  {:<11}", bits.join(" "), narrow.join(" "), value("ACCU1"), value("ACCU2"))
}

/// `speed = 7, step = 1`.
pub fn after(values: &[(String, String)]) -> String {
    values.iter().map(|(name, value)| format!("{name} = {value}")).collect::<Vec<_>>().join(", ")
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
fn when(session: &Session, scan: Option<u64>) -> String {
    scan.map_or_else(|| session.say(texts::WHILE_STARTING, &[]), |scan| session.say(texts::IN_SCAN, &[&scan]))
}

/// What an answer prints.
pub fn answer(session: &mut Session, answer: &Answer) -> String {
    match answer {
        Answer::Moved(halt) => {
            let mut text = row(session);
            let view = session.view();
            for hit in &view.hits {
                text.push_str(&format!("  {hit}\n"));
            }
            let halt = if view.mode == OperatingMode::Stop && view.position > 0 { Halt::Stopped } else { *halt };
            if let Some(words) = halt_text(session, halt, &view) {
                text.push_str(&format!("  {words}\n"));
            }
            let next = match &view.next {
                Some(next) => Some(session.say(texts::NEXT, &[&next.file, &next.line, &next.said(session.language)])),
                None if view.mode == OperatingMode::Run => Some(session.say(texts::NEXT_SCAN, &[&session.history().scans()])),
                None => None,
            };
            text.push_str(&next.map_or_else(String::new, |next| format!("  {next}\n")));
            text.extend(session.watched().iter().map(|name| value_text(session, name)));
            text
        }
        Answer::Text(text) => text.clone(),
        Answer::Diagnostics => {
            let failed = match Failed::of(session.build(), session.cpu()) {
                Some(failed) => session.say(texts::FAILED_TIMES, &[&failed.count, &failed.first_line()]),
                None => session.say(texts::NONE_FAILED, &[]),
            };
            let entries = session.cpu().diagnostic_buffer().entries();
            let lines: String = entries.map(|entry| format!("    {}\n", failed::entry_text(session.build(), entry))).collect();
            format!("  {failed}\n  {}\n{lines}", session.say(texts::DIAGNOSTIC_BUFFER, &[]))
        }
        Answer::Values(names) => names.iter().map(|name| value_text(session, name)).collect(),
        Answer::Locals(locals) => locals_text(session, locals),
        Answer::Set(Setting { name, text, .. }) => {
            let taken = name.holds(session.cpu(), text).unwrap_or(true);
            let later = if taken { "" } else { texts::pick(session.language, texts::SEEN_LATER) };
            format!("  {}{later}\n", session.say(texts::IS_SET, &[&name.text(), text]))
        }
        Answer::Who(name, who) => format!("  {}\n", who_text(session, name, who.as_ref())),
        Answer::Breakpoint(number, text) => format!("  {}\n", session.say(texts::BREAKPOINT, &[number, text])),
        Answer::Breakpoints if session.breakpoints().is_empty() => format!("  {}\n", session.say(texts::NO_BREAKPOINTS, &[])),
        Answer::Breakpoints => {
            let line = |one: &Breakpoint| format!("  {}\n", session.say(texts::BREAKPOINT_SEEN, &[&one.number, &one.text, &one.times]));
            session.breakpoints().iter().map(line).collect()
        }
        Answer::Nothing | Answer::Quit => String::new(),
    }
}

/// A value, and below it what else there is to see in its format.
fn value_text(session: &Session, name: &Name) -> String {
    let before = " ".repeat(name.text().chars().count() + 3);
    let details = names::details(name, session.cpu());
    let details: String = details.iter().map(|line| format!("  {before}{line}\n")).collect();
    format!("  {} = {}\n{details}", name.text(), session.value(name))
}

/// The variables of blocks, in columns.
fn locals_text(session: &Session, locals: &[Variables]) -> String {
    if locals.is_empty() {
        return format!("  {}\n", session.say(texts::NOTHING_KEPT, &[]));
    }
    let all = || locals.iter().flat_map(|one| &one.values);
    let width = |width: &dyn Fn(&LocalValue) -> usize| all().map(width).max().unwrap_or_default();
    let names = width(&|one| one.name.text().chars().count());
    let types = width(&|one| one.type_word.chars().count());
    let line = |one: &LocalValue| {
        let value = one.value.as_ref().map_or_else(|| "-".to_owned(), Shown::readable);
        format!("    {:<7} {:names$}  {:types$}  {value}\n", section(one.section), one.name.text(), one.type_word)
    };
    let of = |variables: &Variables| {
        let owner = &session.owner(variables);
        if variables.values.is_empty() {
            return format!("  {}\n", session.say(texts::NO_VARIABLES, &[owner]));
        }
        format!("  {}\n", session.say(texts::VARIABLES_OF, &[owner])) + &variables.values.iter().map(line).collect::<String>()
    };
    locals.iter().map(of).collect()
}

/// The short word for a part of a declaration.
pub fn section(section: Section) -> &'static str {
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
fn halt_text(session: &Session, halt: Halt, view: &View) -> Option<String> {
    Some(match halt {
        Halt::Reached | Halt::Watch => return None,
        Halt::ScanEnd => session.say(texts::END_OF_SCAN, &[&number(view.scan)]),
        Halt::Limit => session.say(texts::NOT_YET, &[]),
        Halt::Stopped => session.cpu().stop_cause().map_or_else(
            || session.say(texts::STOPPED, &[]),
            |cause| controller::stop_text(session.build(), cause).trim_end().replace('\n', "\n  "),
        ),
        Halt::NoMoreScans => session.say(texts::ALL_SCANS, &[&session.history().scans()]),
        Halt::Beginning => session.say(texts::BEGINNING, &[]),
        Halt::Forgotten => session.say(texts::FORGOTTEN, &[&session.history().first()]),
    })
}

fn who_text(session: &mut Session, name: &Name, who: Option<&Who>) -> String {
    let Some(who) = who else {
        let since = match session.history().first() {
            0 => session.say(texts::SINCE_BEGINNING, &[]),
            first => session.say(texts::SINCE_KEPT, &[&first]),
        };
        let written = session.writer(name).map_or_else(String::new, |by| {
            let Line { file, line, text, .. } = &by.line;
            let block = session.listing().called(by.line.place.block);
            let when = when(session, by.scan);
            format!("\n  {}", session.say(texts::WROTE_LAST, &[file, line, text, &block, &by.position, &when, &by.reason]))
        });
        return session.say(texts::NOTHING_CHANGED, &[&name.text(), &since]) + &written;
    };
    let (before, after) = &who.change;
    let what = match (&who.line, who.by) {
        (Some(line), _) => {
            let block = session.listing().called(line.place.block);
            format!("{}:{}: {} ({block})", line.file, line.line, line.said(session.language))
        }
        (None, By::ProcessImage) => session.say(texts::BY_IMAGE, &[]),
        (None, By::Set) => session.say(texts::BY_SET, &[]),
        (None, _) => session.say(texts::BY_CPU, &[]),
    };
    session.say(texts::CHANGED_BY, &[&name.text(), before, after, &who.position, &when(session, who.scan), &what])
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
pub fn answer_json(session: &mut Session, command: &str, answer: &Answer) -> Value {
    let view = session.view();
    let registers: Map<String, Value> = view.registers.iter().map(|(name, value)| ((*name).to_owned(), json!(value))).collect();
    let stop = session.cpu().stop_cause().filter(|_| view.mode == OperatingMode::Stop).map(controller::stop_json);
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
        "reason": session.reason(),
        "stack": view.stack.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "mode": view.mode.to_string(),
        "stop": stop,
    });
    if !view.on_registers && view.executed.is_some() {
        let values = view.values.iter().map(|(name, value)| (name.clone(), json!(value)));
        object["line_values"] = Value::Object(values.collect());
    }
    let shown = |names: &[Name], session: &Session| -> Map<String, Value> {
        names.iter().map(|name| (name.text().to_owned(), names::to_json(name, session.cpu()))).collect()
    };
    match answer {
        Answer::Moved(halt) => {
            object["halt"] = json!(halt_word(*halt));
            object["hits"] = json!(view.hits);
            if !session.watched().is_empty() {
                object["values"] = Value::Object(shown(session.watched(), session));
            }
        }
        Answer::Locals(locals) => {
            let value = |one: &LocalValue| {
                json!({ "section": section(one.section), "name": one.name.text(), "type": one.type_word,
                        "value": one.value.as_ref().map_or(Value::Null, names::shown_json) })
            };
            let of = |one: &Variables| {
                let mut of = json!({ "block": one.block.to_string(), "variables": one.values.iter().map(value).collect::<Vec<_>>() });
                if let Some(number) = one.data_block {
                    of["data_block"] = json!(format!("DB {number}"));
                }
                of
            };
            let running = locals.iter().find(|one| one.data_block.is_none());
            object["locals"] = running.map_or(Value::Null, of);
            if running.is_none() {
                object["kept"] = Value::Array(locals.iter().map(of).collect());
            }
        }
        Answer::Values(names) => object["values"] = Value::Object(shown(names, session)),
        Answer::Set(set) => object["set"] = json!({ "name": set.name.text(), "value": set.text }),
        Answer::Who(name, who) => {
            object["who"] = who.as_ref().map_or(Value::Null, |who| {
                json!({ "name": name.text(), "position": who.position, "scan": who.scan, "before": who.change.0, "after": who.change.1,
                        "place": who.line.as_ref().map(line_json) })
            });
            if who.is_none() {
                object["written"] = session.writer(name).map_or(Value::Null, |by| {
                    json!({ "name": name.text(), "position": by.position, "scan": by.scan, "place": line_json(&by.line), "reason": by.reason })
                });
            }
        }
        Answer::Breakpoint(number, text) => object["breakpoint"] = json!({ "number": number, "text": text }),
        Answer::Breakpoints => {
            let all = session.breakpoints().iter().map(|one| json!({ "number": one.number, "text": one.text, "times": one.times }));
            object["breakpoints"] = Value::Array(all.collect());
        }
        Answer::Diagnostics => {
            let (build, cpu) = (session.build(), session.cpu());
            object["diagnostic_buffer"] = failed::buffer_json(build, cpu);
            object["failed_statements"] = Failed::of(build, cpu).map(|failed| failed.json()).into();
        }
        Answer::Text(text) => object["text"] = json!(text),
        Answer::Nothing | Answer::Quit => {}
    }
    object
}

/// A command that could not be carried out.
pub fn refusal_json(command: &str, refusal: &Refusal) -> Value {
    json!({ "command": command, "error": { "code": refusal.problem.code(), "message": refusal.message, "help": refusal.shown_help() } })
}
