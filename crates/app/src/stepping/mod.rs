//! The microscope: a run one statement at a time, forwards and back, with breakpoints and the reason of every statement.
//!
//! [`Stepper`] is what the line form, the JSON form and the screen work on.

#[cfg(test)]
mod tests;

mod changes;
pub(crate) mod commands;
mod listing;
mod movement;
pub(crate) mod recording;
pub(crate) mod screen;
pub(crate) mod table;

use std::collections::BTreeSet;

use sieben_cpu::{Cpu, OperatingMode};
use sieben_engine::machine::Registers;
use sieben_engine::{FaultPlace, StatementEvent};
use sieben_lang::reason::{Moment, Reasons};
use sieben_model::block::BlockId;
use sieben_model::symbols::SymbolTable;
use sieben_sim::history::{Breakpoint, Breakpoints, Condition, Halt, History, Hit, Plan, Target, Until, Unwatched, Watch};
use sieben_sim::names::{Name, NameError};

pub(crate) use changes::Change;
pub(crate) use listing::{Goal, Line, Listing};
pub(crate) use movement::{Direction, Unit};
use movement::{Networks, StepEnd};
pub(crate) use sieben_lang::reason::Language;

use crate::names;
use crate::project::Build;

/// Statements that one movement runs at most: a program that never comes to a breakpoint must come to an end.
pub(crate) const STATEMENTS_MAX: u64 = 1_000_000;

/// Steps of one command over a call, to a network or to a block. Each one back runs a part of the history again.
const STEPS_MAX: u64 = 1_000;
/// Breakpoints and watched values at most.
pub(crate) const BREAKPOINTS_MAX: usize = 100;

/// Where a run stands, ready to be shown.
#[derive(Clone, Debug)]
pub(crate) struct View {
    /// Statements executed since the beginning.
    pub(crate) position: u64,
    /// Statements of the whole recorded run.
    pub(crate) end: u64,
    /// Number of the scan, the first is 0 as with `exec`; `None` while the CPU starts.
    pub(crate) scan: Option<u64>,
    /// Virtual time in microseconds.
    pub(crate) time_us: u64,
    /// Nothing recorded lies ahead.
    pub(crate) present: bool,
    /// The statement that was executed last; `None` at the beginning.
    pub(crate) executed: Option<Line>,
    /// The statement that comes next; `None` between two scans.
    pub(crate) next: Option<Line>,
    /// Registers after the last statement.
    pub(crate) registers: Vec<(&'static str, String)>,
    /// Registers and memory that the last statement has changed.
    pub(crate) changed: Vec<Change>,
    /// The blocks that run, outermost first.
    pub(crate) stack: Vec<BlockId>,
    /// What the CPU does.
    pub(crate) mode: OperatingMode,
    /// Breakpoints that paused the last movement, and what changed.
    pub(crate) hits: Vec<String>,
}

/// Who changed a value last.
#[derive(Clone, Debug)]
pub(crate) struct Who {
    /// The statement after which it had changed; `None` if no statement did it.
    pub(crate) line: Option<Line>,
    /// Statements executed then.
    pub(crate) position: u64,
    /// Number of the scan, the first is 0; `None` while the CPU starts.
    pub(crate) scan: Option<u64>,
    /// The value before and after.
    pub(crate) change: (String, String),
}

/// The statement that wrote a value without changing it.
#[derive(Clone, Debug)]
pub(crate) struct Writer {
    /// The statement.
    pub(crate) line: Line,
    /// Statements executed then.
    pub(crate) position: u64,
    /// Number of the scan, the first is 0; `None` while the CPU starts.
    pub(crate) scan: Option<u64>,
    /// Why it did not change it.
    pub(crate) reason: String,
}

/// A run under the microscope.
pub(crate) struct Stepper<'b> {
    build: &'b Build,
    listing: Listing<'b>,
    history: History,
    networks: Networks,
    breakpoints: Vec<Breakpoint>,
    watched: Vec<Name>,
    numbered: u32,
    hits: Vec<String>,
}

impl<'b> Stepper<'b> {
    /// A run that has not begun. The CPU is in STOP, in virtual time, with the program of the build.
    pub(crate) fn new(build: &'b Build, cpu: Cpu, plan: Plan) -> Self {
        Self::with_history(build, History::new(cpu, plan))
    }

    /// A run that has a history, of this program.
    pub(crate) fn with_history(build: &'b Build, history: History) -> Self {
        let blocks = &build.compiled.blocks;
        let networks =
            blocks.iter().map(|(&id, block)| (id, block.statements.iter().map(|statement| statement.network).collect())).collect();
        Self {
            build,
            listing: Listing::new(build),
            history,
            networks,
            breakpoints: Vec::new(),
            watched: Vec::new(),
            numbered: 0,
            hits: Vec::new(),
        }
    }

    /// The history of the run.
    pub(crate) fn history(&self) -> &History {
        &self.history
    }

    /// The CPU where the run stands.
    pub(crate) fn cpu(&self) -> &Cpu {
        self.history.cpu()
    }

    /// The program.
    pub(crate) fn build(&self) -> &'b Build {
        self.build
    }

    /// The statements of the program.
    pub(crate) fn listing(&self) -> &Listing<'b> {
        &self.listing
    }

    /// All breakpoints.
    pub(crate) fn breakpoints(&self) -> &[Breakpoint] {
        &self.breakpoints
    }

    /// Values that are shown after every movement.
    pub(crate) fn watched(&self) -> &[Name] {
        &self.watched
    }

    fn symbols(&self) -> &'b SymbolTable {
        &self.build.project.symbols
    }

    /// The registers after the last statement.
    pub(crate) fn registers(&self) -> Registers {
        match self.history.last() {
            Some(event) if self.history.cpu().is_paused() => event.after.clone(),
            _ => self.cpu().registers().clone(),
        }
    }

    /// One step, so many times.
    pub(crate) fn step(&mut self, unit: Unit, direction: Direction, times: u64) -> Halt {
        self.hits.clear();
        match (unit, direction) {
            (Unit::Statement, Direction::Forward) => match self.history.forward(times.min(STATEMENTS_MAX)) {
                Halt::Reached if times > STATEMENTS_MAX => Halt::Limit,
                halt => halt,
            },
            (Unit::Statement, Direction::Back) => self.history.back(times),
            (Unit::Scan, Direction::Forward) => {
                match self.history.run(Until { statements: STATEMENTS_MAX, scans: times }, &mut Unwatched) {
                    Halt::Reached => Halt::Limit,
                    halt => halt,
                }
            }
            (Unit::Scan, Direction::Back) => self.history.back_scans(times),
            _ => {
                let mut halt = Halt::Reached;
                let from = self.history.position().statements;
                for done in 0..times {
                    let passed = self.history.position().statements.abs_diff(from);
                    // Scans without any statement pass none.
                    if done >= STEPS_MAX || direction == Direction::Forward && passed >= STATEMENTS_MAX {
                        return Halt::Limit;
                    }
                    halt = self.step_to_end(unit, direction);
                    if matches!(halt, Halt::Beginning | Halt::Forgotten | Halt::Limit | Halt::Stopped | Halt::NoMoreScans) {
                        break;
                    }
                }
                halt
            }
        }
    }

    fn step_to_end(&mut self, unit: Unit, direction: Direction) -> Halt {
        let depth = self.cpu().machine().frames.len().max(1);
        let mut end = StepEnd::new(unit, direction, depth, self.history.next_place(), &self.networks);
        match direction {
            // A scan's end is the end of every block.
            Direction::Forward => match self.history.run(Until { statements: STATEMENTS_MAX, scans: 1 }, &mut end) {
                Halt::Watch | Halt::ScanEnd => Halt::Reached,
                Halt::Reached => Halt::Limit,
                halt => halt,
            },
            Direction::Back => match self.history.find_back(false, &mut end) {
                Ok(found) => self.history.go_to_position(found),
                Err(halt) => self.go_to_first(halt),
            },
        }
    }

    /// Runs to a breakpoint, or so many statements; back too.
    pub(crate) fn run(&mut self, direction: Direction, statements: u64) -> Halt {
        let registers = self.registers();
        self.hits.clear();
        match direction {
            Direction::Forward => {
                let mut watch = Breakpoints::new(&mut self.breakpoints, &registers);
                let halt = self.history.run(Until { statements, scans: u64::MAX }, &mut watch);
                let hits = std::mem::take(&mut watch.hits);
                if halt == Halt::Watch {
                    self.note(&hits);
                }
                if halt == Halt::Reached { Halt::Limit } else { halt }
            }
            Direction::Back => {
                // Counting backwards has no meaning: every one counts.
                let mut breakpoints: Vec<Breakpoint> = self.breakpoints.iter().map(|one| Breakpoint { every: 1, ..one.clone() }).collect();
                let mut watch = Breakpoints::new(&mut breakpoints, &registers);
                match self.history.find_back(false, &mut watch) {
                    Ok(found) => {
                        let hits = std::mem::take(&mut watch.hits);
                        self.note(&hits);
                        self.history.go_to_position(found);
                        Halt::Watch
                    }
                    Err(halt) => self.go_to_first(halt),
                }
            }
        }
    }

    /// Goes as far back as there is something, for the reason why there is no more.
    fn go_to_first(&mut self, halt: Halt) -> Halt {
        let first = self.history.first();
        self.history.go_to(first);
        halt
    }

    fn note(&mut self, hits: &[Hit]) {
        for hit in hits {
            let Some(breakpoint) = self.breakpoints.iter().find(|breakpoint| breakpoint.number == hit.number) else { continue };
            let mut text = format!("breakpoint {}: {}", hit.number, breakpoint.text);
            if let (Target::Change(name), Some((before, after))) = (&breakpoint.target, hit.change) {
                text.push_str(&format!(": {} -> {}", shown(name, before), shown(name, after)));
                if hit.by.is_none() {
                    text.push_str(", between two statements");
                }
            }
            self.hits.push(text);
        }
    }

    /// Runs on to a place.
    pub(crate) fn run_to(&mut self, goal: Goal) -> Halt {
        self.hits.clear();
        let mut there = At(goal);
        match self.history.run(Until { statements: STATEMENTS_MAX, scans: u64::MAX }, &mut there) {
            Halt::Watch => Halt::Reached,
            Halt::Reached => Halt::Limit,
            halt => halt,
        }
    }

    /// Goes to a position: so many statements since the beginning.
    pub(crate) fn go_to(&mut self, position: u64) -> Halt {
        self.hits.clear();
        let end = self.history.end();
        if position <= end {
            return self.history.go_to(position);
        }
        self.history.go_to(end);
        self.history.forward((position - end).min(STATEMENTS_MAX))
    }

    /// Reads `FC 5:3`, `main.awl:12` or `12`.
    ///
    /// # Errors
    /// There is no such place.
    pub(crate) fn goal(&self, text: &str) -> Result<Goal, String> {
        let here = self.history.next_place().or(self.history.last().map(|event| event.place));
        self.listing.goal(text, here)
    }

    /// Reads the name of a value.
    ///
    /// # Errors
    /// Nothing is called that.
    pub(crate) fn name(&self, text: &str) -> Result<Name, NameError> {
        let name = Name::parse(text, self.symbols(), self.cpu().program())?;
        name.read(self.cpu())?;
        Ok(name)
    }

    /// Sets a breakpoint; the number that it got.
    ///
    /// # Errors
    /// There are too many.
    pub(crate) fn add(&mut self, text: &str, target: Target, only_if: Option<Condition>, every: u64) -> Result<u32, String> {
        if self.breakpoints.len() >= BREAKPOINTS_MAX {
            return Err(format!("there are {BREAKPOINTS_MAX} breakpoints already; delete one"));
        }
        self.numbered += 1;
        let number = self.numbered;
        self.breakpoints.push(Breakpoint { number, text: text.to_owned(), target, only_if, every, times: 0 });
        Ok(number)
    }

    /// Deletes a breakpoint; `false` if there is none with this number.
    pub(crate) fn delete(&mut self, number: u32) -> bool {
        let count = self.breakpoints.len();
        self.breakpoints.retain(|breakpoint| breakpoint.number != number);
        self.breakpoints.len() < count
    }

    /// Sets a breakpoint at a place, or deletes the one that is there.
    pub(crate) fn toggle(&mut self, goal: Goal) -> Result<(), String> {
        let target = Target::Statement(goal.place, goal.last);
        if let Some(number) = self.breakpoints.iter().find(|one| one.target == target).map(|one| one.number) {
            self.delete(number);
            return Ok(());
        }
        let line = self.listing.line(goal.place);
        self.add(&format!("{}:{}", line.file, line.line), target, None, 1).map(drop)
    }

    /// Shows a value after every movement.
    ///
    /// # Errors
    /// There are too many.
    pub(crate) fn show(&mut self, name: Name) -> Result<(), String> {
        if self.watched.len() >= BREAKPOINTS_MAX {
            return Err(format!("{BREAKPOINTS_MAX} values are shown already"));
        }
        self.watched.push(name);
        Ok(())
    }

    /// Sets a value here and now; what was recorded ahead is forgotten.
    ///
    /// # Errors
    /// It cannot be set.
    pub(crate) fn set(&mut self, name: &Name, value: &str) -> Result<(), NameError> {
        self.history.set(name, value)
    }

    /// Who changed a value last, before now; `None` if nobody did since the beginning, or since what is kept.
    pub(crate) fn who(&mut self, name: &Name) -> Option<Who> {
        let registers = self.registers();
        let target = Target::Change(name.clone());
        let mut one = [Breakpoint { number: 0, text: String::new(), target, only_if: None, every: 1, times: 0 }];
        let here = self.history.position();
        let mut watch = Breakpoints::new(&mut one, &registers);
        let found = self.history.find_back(true, &mut watch).ok()?;
        let hit = watch.hits.first();
        let (before, after) = hit.and_then(|hit| hit.change).unwrap_or_default();
        let line = hit.and_then(|hit| hit.by).map(|place| self.listing.line(place));
        self.history.go_to_position(found);
        let scan = self.history.scans().checked_sub(1);
        self.history.go_to_position(here);
        Some(Who { line, position: found.statements, scan, change: (shown(name, before), shown(name, after)) })
    }

    /// The statement that wrote a value last without changing it, for a value that stays what it is; `None` if no statement that names it has run.
    pub(crate) fn writer(&mut self, name: &Name, language: Language) -> Option<Writer> {
        let code = &self.build.compiled.program.code;
        let places = code.iter().flat_map(|(&block, code)| (0..code.spans.len() as u32).map(move |statement| (block, statement)));
        let writes = |&(block, statement): &(BlockId, u32)| {
            let place = FaultPlace { block, statement };
            let text = self.listing.line(place).text;
            let is_stl = self.build.compiled.blocks.contains_key(&block);
            let store = if is_stl { matches!(text.split(' ').next(), Some("=" | "S" | "R" | "T")) } else { text.contains(":=") };
            store && self.written(place).is_some_and(|other| other.operand().is_some() && other.operand() == name.operand())
        };
        let mut writing = Writing(places.filter(writes).collect());
        if writing.0.is_empty() {
            return None;
        }
        let here = self.history.position();
        let found = self.history.find_back(true, &mut writing).ok()?;
        self.history.go_to_position(found);
        self.history.look_closely();
        let line = self.history.last().map(|event| self.listing.line(event.place));
        let writer = line.map(|line| Writer {
            line,
            position: found.statements,
            scan: self.history.scans().checked_sub(1),
            reason: self.reason(language),
        });
        self.history.go_to_position(here);
        writer
    }

    /// Where the run stands.
    pub(crate) fn view(&mut self) -> View {
        self.history.look_closely();
        let history = &self.history;
        let accumulators = self.build.cpu.accumulators;
        let after = self.registers();
        let mut changed = Vec::new();
        if let Some(event) = history.last() {
            changed = changes::of_registers(&event.before, &event.after, accumulators);
            if let Some(around) = history.around() {
                let written = self.written(event.place);
                changed.extend(changes::of_memory(&around.before, &around.after, written.as_ref(), self.listing.places.mnemonics));
            }
        }
        let place = |place: Option<FaultPlace>| place.map(|place| self.listing.line(place));
        View {
            position: history.position().statements,
            end: history.end(),
            scan: history.scans().checked_sub(1),
            time_us: history.cpu().time_us(),
            present: history.is_at_present(),
            executed: place(history.last().map(|event| event.place)),
            next: place(history.next_place()),
            registers: changes::registers(&after, accumulators),
            changed,
            stack: history.cpu().machine().frames.iter().map(|frame| frame.block).collect(),
            mode: history.cpu().mode(),
            hits: self.hits.clone(),
        }
    }

    /// Why the last statement did what it did, in one sentence; empty if nothing has run.
    pub(crate) fn reason(&mut self, language: Language) -> String {
        self.history.look_closely();
        let (Some(event), Some(around)) = (self.history.last(), self.history.around()) else { return String::new() };
        let stopped = self.cpu().stop_cause().filter(|_| self.cpu().mode() == OperatingMode::Stop);
        let fault = stopped.filter(|cause| cause.place == Some(event.place)).map(|cause| cause.first_event);
        let moment = Moment { event, before: Some(&around.before), after: &around.after, fault };
        Reasons::new(&self.build.compiled, &self.build.project.texts.program, self.symbols()).sentence(&moment, language)
    }

    /// The operand of a statement, if it names a single value.
    fn written(&self, place: FaultPlace) -> Option<Name> {
        let text = self.listing.line(place).text;
        let operand = match text.split_once(":=") {
            Some((target, _)) if !self.build.compiled.blocks.contains_key(&place.block) => target.trim(),
            _ => text.split_once(' ')?.1.trim(),
        };
        Name::parse(operand, self.symbols(), self.cpu().program()).ok()
    }

    /// The value of a name here, as people read it.
    pub(crate) fn value(&self, name: &Name) -> String {
        names::text(name, self.cpu())
    }
}

/// A value as people read it, or that it is not there.
fn shown(name: &Name, bits: Option<u64>) -> String {
    bits.map_or("not there".to_owned(), |bits| name.show_bits(bits).to_string())
}

/// Pauses behind each of these statements.
struct Writing(BTreeSet<(BlockId, u32)>);

impl Watch for Writing {
    fn after(&mut self, _machine: &sieben_engine::Machine, event: &StatementEvent) -> bool {
        self.0.contains(&(event.place.block, event.place.statement))
    }
}

/// Pauses at a place.
struct At(Goal);

impl Watch for At {
    fn before(&mut self, _machine: &sieben_engine::Machine, place: FaultPlace) -> bool {
        place.block == self.0.place.block && (self.0.place.statement..=self.0.last).contains(&place.statement)
    }
}
