//! The commands of `sieben step`, one line each.

use sieben_model::block::BlockId;
use sieben_model::problems::Problem;
use sieben_sim::history::{Condition, Halt, Target};
use sieben_sim::names::{Name, Setting};

use super::change::{Request, Wanted};
use super::texts::{self, Text, pick};
use super::{Direction, Language, STATEMENTS_MAX, Session, Unit, Variables, Who};
use crate::controller;
use crate::names as command_names;
use crate::refusal::Refusal;
use sieben_model::nearest::{nearest, one_of};

/// Longest line that is read as a command.
pub const LINE_MAX: usize = 4096;
/// Statements of one `step` that each get a row; of more only the last is shown.
const ROWS_MAX: u64 = 200;

/// What a command is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Verb {
    /// Steps by a unit.
    Step(Unit),
    /// Steps back, by statements or a unit.
    Back,
    Run,
    To,
    Goto,
    Break,
    Watch,
    Delete,
    Breakpoints,
    Print,
    Locals,
    Show,
    Who,
    Set,
    Where,
    Stack,
    List,
    Diagnostics,
    Help,
    Quit,
}

/// A command with its words and what it does.
pub struct Row {
    /// Its names, the first one is the usual one.
    pub names: &'static [&'static str],
    /// What stands behind it.
    pub operand: Text,
    /// What it does.
    pub help: Text,
    verb: Verb,
}

macro_rules! rows {
    ($($verb:expr, [$($name:literal),+], $operand:expr, $help:expr;)*) => {
        /// All commands.
        pub const ROWS: &[Row] = &[$(Row { names: &[$($name),+], operand: $operand, help: $help, verb: $verb },)*];
    };
}

const NOTHING: Text = ["", ""];
const N: Text = ["[N]", "[N]"];
const NAME: Text = ["NAME", "NAME"];
const NAMES: Text = ["NAME,…", "NAME,…"];

rows! {
    Verb::Step(Unit::Statement), ["step", "s"], N,
        ["the next statement, or N of them, into blocks that are called, over those of the library",
         "die nächste Anweisung, oder N davon, in aufgerufene Bausteine hinein, über die der Bibliothek hinweg"];
    Verb::Step(Unit::Into), ["into", "i"], N,
        ["the same, into blocks of the library as well", "dasselbe, auch in Bausteine der Bibliothek hinein"];
    Verb::Step(Unit::Over), ["over", "n"], N, ["the next statement, over a block that it calls", "die nächste Anweisung, über einen Aufruf hinweg"];
    Verb::Step(Unit::Out), ["out"], N, ["out of this block", "aus diesem Baustein heraus"];
    Verb::Step(Unit::Network), ["network"], N, ["to the next network", "zum nächsten Netzwerk"];
    Verb::Step(Unit::Block), ["block"], N, ["to another block, into it or out of it", "zu einem anderen Baustein, hinein oder heraus"];
    Verb::Step(Unit::Scan), ["scan"], N, ["to the end of this scan, or of N scans", "bis zum Ende dieses Zyklus, oder von N Zyklen"];
    Verb::Back, ["back", "b"], ["[N | into | over | out | network | block | scan] [N]", "[N | into | over | out | network | block | scan] [N]"],
        ["back: by N statements, or the same steps the other way", "zurück: um N Anweisungen, oder dieselben Schritte andersherum"];
    Verb::Run, ["run", "r"], ["[N | back]", "[N | back]"],
        ["to the next breakpoint, N statements at most; or back to the last one", "bis zum nächsten Haltepunkt, höchstens N Anweisungen; oder zurück zum letzten"];
    Verb::To, ["to"], ["PLACE", "STELLE"],
        ["on to a place: FC1:4 (statement), FC1:label, main.awl:12, 12 (line)", "weiter bis zu einer Stelle: FC1:4 (Anweisung), FC1:marke, main.awl:12, 12 (Zeile)"];
    Verb::Goto, ["goto"], ["N", "N"], ["to the moment after N statements of the run", "zu dem Augenblick nach N Anweisungen des Laufs"];
    Verb::Break, ["break"],
        ["PLACE | NAME OP VALUE | write NAME [if NAME OP VALUE] [every N]", "STELLE | NAME OP WERT | write NAME [if NAME OP WERT] [every N]"],
        ["a breakpoint: at a statement, where a condition becomes true (MW10 > 5), where a value is written",
         "ein Haltepunkt: an einer Anweisung, wo eine Bedingung wahr wird (MW10 > 5), wo ein Wert geschrieben wird"];
    Verb::Watch, ["watch"], NAME, ["a breakpoint where a value changes", "ein Haltepunkt, wo sich ein Wert ändert"];
    Verb::Delete, ["delete"], ["N", "N"], ["deletes a breakpoint", "löscht einen Haltepunkt"];
    Verb::Breakpoints, ["breakpoints"], NOTHING, ["lists them", "zeigt sie"];
    Verb::Print, ["print", "p"], NAMES, ["values here: MW10, \"symbol\", DB1.name, #variable", "Werte hier: MW10, \"symbol\", DB1.name, #variable"];
    Verb::Locals, ["locals", "v"], NOTHING, ["all variables of this block; between two scans what the program keeps",
         "alle Variablen dieses Bausteins; zwischen zwei Zyklen, was das Programm behält"];
    Verb::Show, ["show"], NAMES, ["values here and after every movement", "Werte hier und nach jeder Bewegung"];
    Verb::Who, ["who"], NAME,
        ["the statement that changed a value last, or wrote it without a change", "die Anweisung, die einen Wert zuletzt geändert oder unverändert geschrieben hat"];
    Verb::Set, ["set"], ["NAME=VALUE", "NAME=WERT"],
        ["sets a value here and now; what was recorded ahead is dropped", "setzt einen Wert hier und jetzt; was danach aufgezeichnet war, entfällt"];
    Verb::Where, ["where", "why"], NOTHING,
        ["shows the last statement again: place, registers, reason", "zeigt die letzte Anweisung noch einmal: Stelle, Register, Grund"];
    Verb::Stack, ["stack"], NOTHING, ["the blocks that run, outermost first", "die Bausteine, die laufen, der äußerste zuerst"];
    Verb::List, ["list", "l"], NOTHING, ["the source around the next statement", "die Quelle um die nächste Anweisung"];
    Verb::Diagnostics, ["diagnostics", "d"], NOTHING,
        ["the diagnostic buffer, newest entry first, and how often a statement failed", "der Diagnosepuffer, der neueste Eintrag zuerst, und wie oft eine Anweisung fehlschlug"];
    Verb::Help, ["help", "?"], NOTHING, ["these commands", "diese Befehle"];
    Verb::Quit, ["quit", "q"], NOTHING, ["ends", "Ende"];
}

/// What a command came to.
#[derive(Clone, Debug)]
pub enum Answer {
    /// The run moved; `rows` asks for a row of each of so many statements.
    Moved(Halt),
    /// Lines to print; nothing moved.
    Text(String),
    /// Values by name.
    Values(Vec<Name>),
    /// The variables of the block that runs, or of all that the program keeps.
    Locals(Vec<Variables>),
    /// A value was set.
    Set(Setting),
    /// The last change of a value.
    Who(Name, Option<Who>),
    /// A breakpoint was set.
    Breakpoint(u32, String),
    /// All breakpoints, or what is left of them.
    Breakpoints,
    /// The diagnostic buffer, and the statements that failed.
    Diagnostics,
    /// Nothing was asked.
    Nothing,
    /// The end.
    Quit,
}

fn wrong(message: impl Into<String>) -> Refusal {
    Refusal::new(Problem::P7040, message)
}

fn no_place(message: String) -> Refusal {
    Refusal::new(Problem::P7041, message)
}

/// Carries out one line. `row` is called after each of a few statements.
///
/// # Errors
/// The line is no command, or it cannot be carried out; then nothing has changed.
pub fn carry_out(session: &mut Session, line: &str, row: &mut dyn FnMut(&mut Session)) -> Result<Answer, Refusal> {
    let line = line.trim();
    if line.len() > LINE_MAX {
        return Err(wrong(session.say(texts::COMMAND_TOO_LONG, &[&LINE_MAX, &line.len()])));
    }
    if line.is_empty() || line.starts_with('#') || line.starts_with("//") {
        return Ok(Answer::Nothing);
    }
    let (word, operand) = line.split_once(char::is_whitespace).map_or((line, ""), |(word, rest)| (word, rest.trim()));
    let found = ROWS.iter().find(|row| row.names.iter().any(|name| name.eq_ignore_ascii_case(word)));
    let Some(found) = found else {
        let names = ROWS.iter().map(|row| row.names[0]);
        let and = pick(session.language, ["or", "und"]);
        let refusal = wrong(session.say(texts::NO_COMMAND, &[&word, &one_of(names.clone()).replace(" or ", &format!(" {and} "))]));
        return Err(match nearest(word, names) {
            Some(near) => refusal.help(session.say(texts::DID_YOU_MEAN, &[&near])),
            None => refusal,
        });
    };
    let takes = pick(session.language, found.operand);
    if takes.is_empty() && !operand.is_empty() {
        return Err(wrong(session.say(texts::NOTHING_BEHIND, &[&found.names[0], &operand])));
    }
    if operand.is_empty() && !takes.is_empty() && !takes.starts_with('[') {
        return Err(wrong(session.say(texts::SOMETHING_BEHIND, &[&found.names[0], &takes])));
    }
    verb(session, found, operand, row)
}

fn verb(session: &mut Session, found: &Row, operand: &str, row: &mut dyn FnMut(&mut Session)) -> Result<Answer, Refusal> {
    Ok(match found.verb {
        Verb::Step(unit) => steps(session, unit, Direction::Forward, count(session, operand)?, row),
        Verb::Back => {
            let (word, rest) = operand.split_once(char::is_whitespace).unwrap_or((operand, ""));
            let unit = ROWS.iter().find_map(|row| match row.verb {
                Verb::Step(unit) if row.names.iter().any(|name| name.eq_ignore_ascii_case(word)) => Some(unit),
                _ => None,
            });
            match unit {
                Some(unit) => steps(session, unit, Direction::Back, count(session, rest)?, row),
                None => steps(session, Unit::Statement, Direction::Back, count(session, operand)?, row),
            }
        }
        Verb::Run if operand.eq_ignore_ascii_case("back") => Answer::Moved(session.run(Direction::Back, STATEMENTS_MAX)),
        Verb::Run if operand.is_empty() => Answer::Moved(session.run(Direction::Forward, STATEMENTS_MAX)),
        Verb::Run => Answer::Moved(session.run(Direction::Forward, count(session, operand)?.min(STATEMENTS_MAX * 10))),
        Verb::To => {
            let goal = session.goal(operand).map_err(no_place)?;
            Answer::Moved(session.run_to(goal))
        }
        Verb::Goto => {
            let position = operand.parse().map_err(|_| wrong(session.say(texts::NO_POSITION, &[&operand])))?;
            Answer::Moved(session.go_to(position))
        }
        Verb::Break => set_breakpoint(session, operand)?,
        Verb::Watch => {
            let name = bound(session, operand, session.here())?;
            let request = Request { wanted: Wanted::Change(operand.to_owned()), only_if: None, block: session.here() };
            let number = session.add(operand, Target::Change(name), None, 1, request).map_err(wrong)?;
            Answer::Breakpoint(number, session.say(texts::PAUSES_WHEN_CHANGED, &[&operand]))
        }
        Verb::Delete => {
            let number = operand.parse().ok().filter(|&number| session.delete(number));
            match number {
                Some(_) => Answer::Breakpoints,
                None => {
                    let known: Vec<String> = session.breakpoints().iter().map(|one| one.number.to_string()).collect();
                    let known = match known.is_empty() {
                        true => session.say(texts::THERE_ARE_NONE, &[]),
                        false => session.say(texts::THERE_ARE, &[&known.join(", ")]),
                    };
                    return Err(wrong(session.say(texts::NO_BREAKPOINT, &[&operand, &known])));
                }
            }
        }
        Verb::Breakpoints => Answer::Breakpoints,
        Verb::Print => Answer::Values(values(session, operand)?),
        Verb::Locals => Answer::Locals(session.locals()),
        Verb::Show => {
            let names = values(session, operand)?;
            names.iter().try_for_each(|name| session.show(name.clone())).map_err(wrong)?;
            Answer::Values(names)
        }
        Verb::Who => {
            let name = bound(session, operand, session.here())?;
            let who = session.who(&name);
            Answer::Who(name, who)
        }
        Verb::Set => {
            let (text, value) = command_names::split_assignment(operand)?;
            let name = name(session, text, session.here())?;
            let unfit = |error: sieben_sim::names::NameError| {
                Refusal::new(command_names::problem_of_value(&error), format!("`{operand}`: {error}"))
            };
            let setting = Setting::new(name, value).map_err(unfit)?;
            session.set(setting.clone()).map_err(unfit)?;
            Answer::Set(setting)
        }
        Verb::Where => Answer::Moved(Halt::Reached),
        Verb::Stack => Answer::Text(stack(session)),
        Verb::List => Answer::Text(around(session)),
        Verb::Diagnostics => Answer::Diagnostics,
        Verb::Help => Answer::Text(help(session.language)),
        Verb::Quit => Answer::Quit,
    })
}

fn steps(session: &mut Session, unit: Unit, direction: Direction, times: u64, row: &mut dyn FnMut(&mut Session)) -> Answer {
    let rows = matches!(unit, Unit::Statement | Unit::Into) && direction == Direction::Forward && times <= ROWS_MAX;
    if !rows {
        return Answer::Moved(session.step(unit, direction, times));
    }
    let mut halt = Halt::Reached;
    for index in 0..times {
        halt = session.step(unit, direction, 1);
        if halt != Halt::Reached {
            break;
        }
        if index + 1 < times {
            row(session);
        }
    }
    Answer::Moved(halt)
}

fn count(session: &Session, text: &str) -> Result<u64, Refusal> {
    if text.is_empty() {
        return Ok(1);
    }
    match text.parse() {
        Ok(count) if count > 0 => Ok(count),
        _ => Err(wrong(session.say(texts::NO_COUNT, &[&text]))),
    }
}

/// A name; a variable is one of this block.
fn name(session: &Session, text: &str, block: Option<BlockId>) -> Result<Name, Refusal> {
    let variables = block.and_then(|block| session.cpu().program().code.get(&block));
    let variables = variables.map_or(&[][..], |code| &code.interface.variables);
    session.name_in(text, block).map_err(|error| {
        let refusal = command_names::refused(&error);
        if refusal.problem != Problem::P7003 {
            return refusal;
        }
        let plain = text.trim_matches(['"', '#']);
        let known = session.build().project.symbols.symbols().iter().map(|symbol| symbol.name.clone());
        let known: Vec<String> = known.chain(variables.iter().map(|variable| format!("#{}", variable.name))).collect();
        let near = nearest(text, known.iter().map(String::as_str)).or_else(|| nearest(plain, known.iter().map(String::as_str)));
        match near {
            Some(near) if !near.trim_start_matches('#').eq_ignore_ascii_case(plain) => {
                refusal.help(session.say(texts::DID_YOU_MEAN, &[&near]))
            }
            _ => refusal,
        }
    })
}

/// A name that means the same wherever the run goes.
fn bound(session: &Session, text: &str, block: Option<BlockId>) -> Result<Name, Refusal> {
    let name = name(session, text, block)?;
    session.bound(name).map_err(|error| Refusal::new(Problem::P7003, error.to_string()))
}

fn values(session: &Session, operand: &str) -> Result<Vec<Name>, Refusal> {
    command_names::split_list(operand).into_iter().map(|text| name(session, text, session.here())).collect()
}

/// `FC1:4 if MW10 > 5 every 3`, `MW10 > 5`, `write MW10`.
fn set_breakpoint(session: &mut Session, operand: &str) -> Result<Answer, Refusal> {
    let (rest, every) = match operand.rsplit_once(" every ") {
        Some((rest, times)) => (rest.trim(), count(session, times.trim())?),
        None => (operand, 1),
    };
    let (what, condition) = match rest.split_once(" if ") {
        Some((what, condition)) => (what.trim(), Some(condition)),
        None => (rest, None),
    };
    let here = session.here();
    let request = |wanted, block| Request { wanted, only_if: condition.map(str::to_owned), block };
    let only_if = |session: &Session, block| condition.map(|text| condition_of(session, text, block, false)).transpose();
    if let Some((word, written)) = what.split_once(char::is_whitespace)
        && word.eq_ignore_ascii_case("write")
    {
        let name = bound(session, written.trim(), here)?;
        if name.is_register() {
            return Err(wrong(session.say(texts::REGISTER_WRITTEN, &[&name.text()])));
        }
        let only_if = only_if(session, here)?;
        let text = session.say(texts::PAUSES_WHEN_WRITTEN, &[&name.text()]);
        let request = request(Wanted::Write(written.trim().to_owned()), here);
        let number = session.add(operand, Target::Write(name), only_if, every, request).map_err(wrong)?;
        return Ok(Answer::Breakpoint(number, text));
    }
    if what.contains(['<', '>', '=']) {
        let target = Target::Condition(condition_of(session, what, here, true)?);
        let only_if = only_if(session, here)?;
        let request = request(Wanted::Condition(what.to_owned()), here);
        let number = session.add(operand, target, only_if, every, request).map_err(wrong)?;
        return Ok(Answer::Breakpoint(number, session.say(texts::PAUSES_WHEN_TRUE, &[&what])));
    }
    let goal = session.goal(what).map_err(no_place)?;
    // At a place the variables are those of its block.
    let only_if = only_if(session, Some(goal.place.block))?;
    let line = session.listing().line(goal.place);
    // A line alone means one of the file where the run stands now.
    let place = if what.parse::<usize>().is_ok() { format!("{}:{what}", line.file) } else { what.to_owned() };
    let request = request(Wanted::Place(place), Some(goal.place.block));
    let number = session.add(operand, Target::Statement(goal.place, goal.last), only_if, every, request).map_err(wrong)?;
    let moved = if goal.moved { pick(session.language, texts::MOVED) } else { "" };
    let text = session.say(texts::PAUSES_BEFORE, &[&line.file, &line.line, &line.said(session.language)]);
    Ok(Answer::Breakpoint(number, format!("{moved}{text}")))
}

/// A condition about variables of this block; `anywhere`: it is looked at in other blocks too.
fn condition_of(session: &Session, text: &str, block: Option<BlockId>, anywhere: bool) -> Result<Condition, Refusal> {
    let name = |text: &str| {
        let name = session.name_in(text, block)?;
        if anywhere { session.bound(name) } else { Ok(name) }
    };
    Condition::parse(text, name).map_err(|error| Refusal::new(Problem::P7042, error.to_string()))
}

fn stack(session: &Session) -> String {
    let frames = &session.cpu().machine().frames;
    if frames.is_empty() {
        return session.say(texts::NO_BLOCK_RUNS, &[]) + "\n";
    }
    let called =
        |block| controller::name_in_source(session.build(), block).map_or_else(|| session.listing().places().block(block), str::to_owned);
    frames.iter().map(|frame| format!("{}\n", called(frame.block))).collect()
}

/// Lines shown before and behind the next statement.
const AROUND: usize = 5;

fn around(session: &Session) -> String {
    let history = session.history();
    let place = history.next_place().or(history.last().map(|event| event.place));
    let Some(span) = place.and_then(|place| session.listing().span(place)) else { return session.say(texts::NOTHING_RAN, &[]) + "\n" };
    let here = session.listing().places().line(span);
    let text = &session.build().project.texts.program.file(span.file).text;
    let first = here.saturating_sub(AROUND).max(1);
    let lines = text.lines().enumerate().skip(first - 1).take(here + AROUND + 1 - first);
    lines
        .map(|(index, text)| {
            let mark = if index + 1 == here { "->" } else { "  " };
            // A line may be a whole program.
            let shown: String = text.chars().take(160).collect();
            format!("{mark} {:>5}  {shown}\n", index + 1)
        })
        .collect()
}

/// All commands with what they do.
pub fn help(language: Language) -> String {
    let left = |row: &Row| format!("{} {}", row.names.join(", "), pick(language, row.operand));
    let width = ROWS.iter().map(|row| left(row).chars().count()).filter(|&width| width <= 24).max().unwrap_or(24);
    ROWS.iter()
        .map(|row| {
            let (left, help) = (left(row), pick(language, row.help));
            if left.chars().count() > width { format!("  {left}\n  {:width$}  {help}\n", "") } else { format!("  {left:width$}  {help}\n") }
        })
        .collect()
}
