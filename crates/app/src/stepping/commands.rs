//! The commands of `sieben step`, one line each.

use sieben_model::problems::Problem;
use sieben_sim::history::{Condition, Halt, Target};
use sieben_sim::names::Name;

use super::{Direction, STATEMENTS_MAX, Stepper, Unit, Who};
use crate::failure::Failure;
use crate::names as command_names;
use crate::nearest::{nearest, one_of};

/// Longest line that is read as a command.
pub(crate) const LINE_MAX: usize = 4096;
/// Statements of one `step` that each get a row; of more only the last is shown.
const ROWS_MAX: u64 = 200;

/// What a command is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verb {
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
    Show,
    Who,
    Set,
    Where,
    Stack,
    List,
    Help,
    Quit,
}

/// A command with its words and what it does.
pub(crate) struct Row {
    /// Its names, the first one is the usual one.
    pub(crate) names: &'static [&'static str],
    /// What stands behind it.
    pub(crate) operand: &'static str,
    /// What it does.
    pub(crate) help: &'static str,
    verb: Verb,
}

macro_rules! rows {
    ($($verb:expr, [$($name:literal),+], $operand:literal, $help:literal;)*) => {
        /// All commands.
        pub(crate) const ROWS: &[Row] = &[$(Row { names: &[$($name),+], operand: $operand, help: $help, verb: $verb },)*];
    };
}

rows! {
    Verb::Step(Unit::Statement), ["step", "s", "into"], "[N]", "the next statement, or N of them, into blocks that are called";
    Verb::Step(Unit::Over), ["over", "n"], "[N]", "the next statement, over a block that it calls";
    Verb::Step(Unit::Out), ["out"], "[N]", "out of this block";
    Verb::Step(Unit::Network), ["network"], "[N]", "to the next network";
    Verb::Step(Unit::Block), ["block"], "[N]", "to another block, into it or out of it";
    Verb::Step(Unit::Scan), ["scan"], "[N]", "to the end of this scan, or of N scans";
    Verb::Back, ["back", "b"], "[N | over | out | network | block | scan] [N]", "back: by N statements, or the same steps the other way";
    Verb::Run, ["run", "r"], "[N | back]", "to the next breakpoint, N statements at most; or back to the last one";
    Verb::To, ["to"], "PLACE", "on to a place: FC1:4 (statement), FC1:label, main.awl:12, 12 (line)";
    Verb::Goto, ["goto"], "N", "to the moment after N statements of the run";
    Verb::Break, ["break"], "PLACE | NAME OP VALUE [if NAME OP VALUE] [every N]", "a breakpoint at a statement, or where a condition becomes true: MW10 > 5";
    Verb::Watch, ["watch"], "NAME", "a breakpoint where a value changes";
    Verb::Delete, ["delete"], "N", "deletes a breakpoint";
    Verb::Breakpoints, ["breakpoints"], "", "lists them";
    Verb::Print, ["print", "p"], "NAME,…", "values here";
    Verb::Show, ["show"], "NAME,…", "values here and after every movement";
    Verb::Who, ["who"], "NAME", "the statement that changed a value last, or wrote it without a change";
    Verb::Set, ["set"], "NAME=VALUE", "sets a value here and now; what was recorded ahead is dropped";
    Verb::Where, ["where", "why"], "", "shows the last statement again: place, registers, reason";
    Verb::Stack, ["stack"], "", "the blocks that run, outermost first";
    Verb::List, ["list", "l"], "", "the source around the next statement";
    Verb::Help, ["help", "?"], "", "these commands";
    Verb::Quit, ["quit", "q"], "", "ends";
}

/// What a command came to.
#[derive(Clone, Debug)]
pub(crate) enum Answer {
    /// The run moved; `rows` asks for a row of each of so many statements.
    Moved(Halt),
    /// Lines to print; nothing moved.
    Text(String),
    /// Values by name.
    Values(Vec<Name>),
    /// A value was set.
    Set(Name, String),
    /// The last change of a value.
    Who(Name, Option<Who>),
    /// A breakpoint was set.
    Breakpoint(u32, String),
    /// All breakpoints, or what is left of them.
    Breakpoints,
    /// Nothing was asked.
    Nothing,
    /// The end.
    Quit,
}

fn wrong(message: impl Into<String>) -> Failure {
    Failure::usage(Problem::P7040, message)
}

fn no_place(message: String) -> Failure {
    Failure::usage(Problem::P7041, message)
}

/// Carries out one line. `row` is called after each of a few statements.
///
/// # Errors
/// The line is no command, or it cannot be carried out; then nothing has changed.
pub(crate) fn carry_out(stepper: &mut Stepper<'_>, line: &str, row: &mut dyn FnMut(&mut Stepper<'_>)) -> Result<Answer, Failure> {
    let line = line.trim();
    if line.len() > LINE_MAX {
        return Err(wrong(format!("a command has at most {LINE_MAX} bytes, this one has {}", line.len())));
    }
    if line.is_empty() || line.starts_with('#') || line.starts_with("//") {
        return Ok(Answer::Nothing);
    }
    let (word, operand) = line.split_once(char::is_whitespace).map_or((line, ""), |(word, rest)| (word, rest.trim()));
    let found = ROWS.iter().find(|row| row.names.iter().any(|name| name.eq_ignore_ascii_case(word)));
    let Some(found) = found else {
        let names = ROWS.iter().map(|row| row.names[0]);
        let failure = wrong(format!("`{word}` is no command; there are {}", one_of(names.clone())));
        return Err(match nearest(word, names) {
            Some(near) => failure.help(format!("did you mean `{near}`?")),
            None => failure,
        });
    };
    if found.operand.is_empty() && !operand.is_empty() {
        return Err(wrong(format!("`{}` takes nothing behind it, not `{operand}`", found.names[0])));
    }
    if operand.is_empty() && !found.operand.is_empty() && !found.operand.starts_with('[') {
        return Err(wrong(format!("`{}` needs something behind it: {}", found.names[0], found.operand)));
    }
    verb(stepper, found, operand, row)
}

fn verb(stepper: &mut Stepper<'_>, found: &Row, operand: &str, row: &mut dyn FnMut(&mut Stepper<'_>)) -> Result<Answer, Failure> {
    Ok(match found.verb {
        Verb::Step(unit) => steps(stepper, unit, Direction::Forward, count(operand)?, row),
        Verb::Back => {
            let (word, rest) = operand.split_once(char::is_whitespace).unwrap_or((operand, ""));
            let unit = ROWS.iter().find_map(|row| match row.verb {
                Verb::Step(unit) if row.names.iter().any(|name| name.eq_ignore_ascii_case(word)) => Some(unit),
                _ => None,
            });
            match unit {
                Some(unit) => steps(stepper, unit, Direction::Back, count(rest)?, row),
                None => steps(stepper, Unit::Statement, Direction::Back, count(operand)?, row),
            }
        }
        Verb::Run if operand.eq_ignore_ascii_case("back") => Answer::Moved(stepper.run(Direction::Back, STATEMENTS_MAX)),
        Verb::Run if operand.is_empty() => Answer::Moved(stepper.run(Direction::Forward, STATEMENTS_MAX)),
        Verb::Run => Answer::Moved(stepper.run(Direction::Forward, count(operand)?.min(STATEMENTS_MAX * 10))),
        Verb::To => {
            let goal = stepper.goal(operand).map_err(no_place)?;
            Answer::Moved(stepper.run_to(goal))
        }
        Verb::Goto => {
            let position = operand
                .parse()
                .map_err(|_| wrong(format!("`{operand}` is no position; write how many statements of the run lie before it")))?;
            Answer::Moved(stepper.go_to(position))
        }
        Verb::Break => set_breakpoint(stepper, operand)?,
        Verb::Watch => {
            let name = name(stepper, operand)?;
            let number = stepper.add(operand, Target::Change(name), None, 1).map_err(wrong)?;
            Answer::Breakpoint(number, format!("pauses when `{operand}` changes"))
        }
        Verb::Delete => {
            let number = operand.parse().ok().filter(|&number| stepper.delete(number));
            match number {
                Some(_) => Answer::Breakpoints,
                None => {
                    let known: Vec<String> = stepper.breakpoints().iter().map(|one| one.number.to_string()).collect();
                    let known = if known.is_empty() { "there are none".to_owned() } else { format!("there are {}", known.join(", ")) };
                    return Err(wrong(format!("`{operand}` is the number of no breakpoint; {known}")));
                }
            }
        }
        Verb::Breakpoints => Answer::Breakpoints,
        Verb::Print => Answer::Values(values(stepper, operand)?),
        Verb::Show => {
            let names = values(stepper, operand)?;
            names.iter().try_for_each(|name| stepper.show(name.clone())).map_err(wrong)?;
            Answer::Values(names)
        }
        Verb::Who => {
            let name = name(stepper, operand)?;
            let who = stepper.who(&name);
            Answer::Who(name, who)
        }
        Verb::Set => {
            let (text, value) = command_names::split_assignment(operand)?;
            let name = name(stepper, text)?;
            let unfit = |error: sieben_sim::names::NameError| Failure::usage(Problem::P7004, format!("`{operand}`: {error}"));
            name.accepts(value).map_err(unfit)?;
            stepper.set(&name, value).map_err(unfit)?;
            Answer::Set(name, value.to_owned())
        }
        Verb::Where => Answer::Moved(Halt::Reached),
        Verb::Stack => Answer::Text(stack(stepper)),
        Verb::List => Answer::Text(around(stepper)),
        Verb::Help => Answer::Text(help()),
        Verb::Quit => Answer::Quit,
    })
}

fn steps(stepper: &mut Stepper<'_>, unit: Unit, direction: Direction, times: u64, row: &mut dyn FnMut(&mut Stepper<'_>)) -> Answer {
    let rows = unit == Unit::Statement && direction == Direction::Forward && times <= ROWS_MAX;
    if !rows {
        return Answer::Moved(stepper.step(unit, direction, times));
    }
    let mut halt = Halt::Reached;
    for index in 0..times {
        halt = stepper.step(unit, direction, 1);
        if halt != Halt::Reached {
            break;
        }
        if index + 1 < times {
            row(stepper);
        }
    }
    Answer::Moved(halt)
}

fn count(text: &str) -> Result<u64, Failure> {
    if text.is_empty() {
        return Ok(1);
    }
    match text.parse() {
        Ok(count) if count > 0 => Ok(count),
        _ => Err(wrong(format!("`{text}` is no number of steps; write a whole number from 1 on"))),
    }
}

fn name(stepper: &Stepper<'_>, text: &str) -> Result<Name, Failure> {
    command_names::resolve(text, &stepper.build().project.symbols, stepper.cpu())
}

fn values(stepper: &Stepper<'_>, operand: &str) -> Result<Vec<Name>, Failure> {
    command_names::resolve_lists(&[operand.to_owned()], &stepper.build().project.symbols, stepper.cpu())
}

/// `FC1:4 if MW10 > 5 every 3`, `MW10 > 5`.
fn set_breakpoint(stepper: &mut Stepper<'_>, operand: &str) -> Result<Answer, Failure> {
    let (rest, every) = match operand.rsplit_once(" every ") {
        Some((rest, times)) => (rest.trim(), count(times.trim())?),
        None => (operand, 1),
    };
    let (what, only_if) = match rest.split_once(" if ") {
        Some((what, condition)) => (what.trim(), Some(condition_of(stepper, condition)?)),
        None => (rest, None),
    };
    if what.contains(['<', '>', '=']) {
        let condition = condition_of(stepper, what)?;
        let number = stepper.add(operand, Target::Condition(condition), only_if, every).map_err(wrong)?;
        return Ok(Answer::Breakpoint(number, format!("pauses when `{what}` becomes true")));
    }
    let goal = stepper.goal(what).map_err(no_place)?;
    let number = stepper.add(operand, Target::Statement(goal.place, goal.last), only_if, every).map_err(wrong)?;
    let line = stepper.listing().line(goal.place);
    let moved = if goal.moved { "no statement stands there; " } else { "" };
    Ok(Answer::Breakpoint(number, format!("{moved}pauses before {}:{}: {}", line.file, line.line, line.text)))
}

fn condition_of(stepper: &Stepper<'_>, text: &str) -> Result<Condition, Failure> {
    Condition::parse(text, |name| stepper.name(name)).map_err(|error| Failure::usage(Problem::P7042, error.to_string()))
}

fn stack(stepper: &Stepper<'_>) -> String {
    let frames = &stepper.cpu().machine().frames;
    if frames.is_empty() {
        return "no block runs: the CPU is between two scans\n".to_owned();
    }
    frames.iter().map(|frame| format!("{}\n", stepper.listing().places.block(frame.block))).collect()
}

/// Lines shown before and behind the next statement.
const AROUND: usize = 5;

fn around(stepper: &Stepper<'_>) -> String {
    let history = stepper.history();
    let place = history.next_place().or(history.last().map(|event| event.place));
    let Some(span) = place.and_then(|place| stepper.listing().span(place)) else { return "no statement has run\n".to_owned() };
    let here = stepper.listing().places.line(span);
    let text = &stepper.build().project.texts.program.file(span.file).text;
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
pub(crate) fn help() -> String {
    let left = |row: &Row| format!("{} {}", row.names.join(", "), row.operand);
    let width = ROWS.iter().map(|row| left(row).chars().count()).filter(|&width| width <= 24).max().unwrap_or(24);
    ROWS.iter()
        .map(|row| {
            let left = left(row);
            if left.chars().count() > width {
                format!("  {left}\n  {:width$}  {}\n", "", row.help)
            } else {
                format!("  {left:width$}  {}\n", row.help)
            }
        })
        .collect()
}
