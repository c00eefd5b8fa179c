//! A session with a program: its run one statement at a time, forwards and back, with breakpoints and the reason of every statement.
//!
//! [`Session`] is what every form of it works on: lines, JSON, a screen, a debugger.

#[cfg(test)]
mod change_tests;
#[cfg(test)]
mod tests;

mod change;
mod changes;
pub mod commands;
mod listing;
mod movement;
pub mod recording;
mod seen;
pub mod table;
pub mod texts;
mod variables;

use std::cell::OnceCell;
use std::sync::Arc;

use sieben_cpu::{Cpu, OperatingMode};
use sieben_engine::FaultPlace;
use sieben_engine::machine::Registers;
use sieben_lang::reason::{Moment, Reasons};
use sieben_model::block::BlockId;
use sieben_model::symbols::SymbolTable;
use sieben_sim::history::{
    Breakpoint, Breakpoints, By, Condition, Halt, History, Hit, Plan, Position, StoreIfRlo, Target, Until, Unwatched, Watch,
};
use sieben_sim::names::{Name, NameError, Scope, Setting};

use crate::project::Build;
pub use change::{Changed, Lost, LostKind};
use change::{Request, Wanted};
pub use changes::Change;
pub use listing::{Goal, Line, Listing};
pub use movement::{Direction, Unit};
use movement::{Networks, OverLibrary, StepEnd};
pub use seen::LineValues;
use seen::{OutOfLibrary, Returned};
pub use sieben_lang::reason::Language;
pub use variables::{LocalValue, Variables};

/// Statements that one movement runs at most: a program that never comes to a breakpoint must come to an end.
pub const STATEMENTS_MAX: u64 = 1_000_000;

/// Steps of one command over a call, to a network or to a block. Each one back runs a part of the history again.
const STEPS_MAX: u64 = 1_000;
/// Breakpoints and watched values at most.
pub const BREAKPOINTS_MAX: usize = 100;

/// Where a run stands, ready to be shown.
#[derive(Clone, Debug)]
pub struct View {
    /// Statements executed since the beginning.
    pub position: u64,
    /// Statements of the whole recorded run.
    pub end: u64,
    /// Number of the scan, the first is 0 as with `exec`; `None` while the CPU starts.
    pub scan: Option<u64>,
    /// Virtual time in microseconds.
    pub time_us: u64,
    /// Nothing recorded lies ahead.
    pub present: bool,
    /// The statement that was executed last; `None` at the beginning.
    pub executed: Option<Line>,
    /// The statement that comes next; `None` between two scans.
    pub next: Option<Line>,
    /// Registers after the last statement.
    pub registers: Vec<(&'static str, String)>,
    /// Registers and memory that the last statement has changed.
    pub changed: Vec<Change>,
    /// Whether the last statement works on registers: those of ST never change what shows there.
    pub on_registers: bool,
    /// The variables that the last statement names, with their values after it; empty in STL.
    pub values: Vec<(String, String)>,
    /// The blocks that run, outermost first.
    pub stack: Vec<BlockId>,
    /// What the CPU does.
    pub mode: OperatingMode,
    /// Breakpoints that paused the last movement, and what changed.
    pub hits: Vec<String>,
}

/// Who changed a value last.
#[derive(Clone, Debug)]
pub struct Who {
    /// Who it was.
    pub by: By,
    /// The statement after which it had changed; `None` if no statement did it.
    pub line: Option<Line>,
    /// Statements executed then.
    pub position: u64,
    /// Number of the scan, the first is 0; `None` while the CPU starts.
    pub scan: Option<u64>,
    /// The value before and after.
    pub change: (String, String),
}

/// The statement that wrote a value without changing it.
#[derive(Clone, Debug)]
pub struct Writer {
    /// The statement.
    pub line: Line,
    /// Statements executed then.
    pub position: u64,
    /// Number of the scan, the first is 0; `None` while the CPU starts.
    pub scan: Option<u64>,
    /// Why it did not change it.
    pub reason: String,
}

/// A run under the microscope. It holds what it needs of the program, so that another program can take over.
pub struct Session {
    build: Arc<Build>,
    listing: Listing,
    history: History,
    networks: Networks,
    breakpoints: Vec<Breakpoint>,
    /// How each of them was asked for.
    requests: Vec<Request>,
    watched: Vec<Name>,
    numbered: u32,
    hits: Vec<Hit>,
    /// The variables of data blocks, once they were asked for.
    fields: OnceCell<Vec<Name>>,
    /// The call into the library that is over where the run stands.
    returned: Option<Returned>,
    /// Of the rows that were printed last, so that new columns get their head.
    columns: Option<table::Columns>,
    if_rlo: StoreIfRlo,
    /// The language that everything is said in.
    pub language: Language,
}

impl Session {
    /// A run that has not begun. The CPU is in STOP, in virtual time, with the program of the build.
    pub fn new(build: Arc<Build>, cpu: Cpu, plan: Plan) -> Self {
        Self::with_history(build, History::new(cpu, plan))
    }

    /// A run that has a history, of this program.
    pub fn with_history(build: Arc<Build>, history: History) -> Self {
        Self {
            listing: Listing::new(Arc::clone(&build)),
            history,
            networks: networks(&build),
            breakpoints: Vec::new(),
            requests: Vec::new(),
            watched: Vec::new(),
            numbered: 0,
            hits: Vec::new(),
            fields: OnceCell::new(),
            returned: None,
            columns: None,
            if_rlo: if_rlo(&build),
            build,
            language: Language::English,
        }
    }

    /// Goes on with this program.
    fn take(&mut self, build: Arc<Build>) {
        self.listing = Listing::new(Arc::clone(&build));
        (self.networks, self.if_rlo) = (networks(&build), if_rlo(&build));
        self.build = build;
        self.returned = None;
        self.fields = OnceCell::new();
    }

    /// A text in the language of this microscope, with values in their places.
    pub fn say(&self, text: texts::Text, values: &[&dyn std::fmt::Display]) -> String {
        texts::fill(self.language, text, values)
    }

    /// The history of the run.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// The CPU where the run stands.
    pub fn cpu(&self) -> &Cpu {
        self.history.cpu()
    }

    /// The program.
    pub fn build(&self) -> &Arc<Build> {
        &self.build
    }

    /// The statements of the program.
    pub fn listing(&self) -> &Listing {
        &self.listing
    }

    /// All breakpoints.
    pub fn breakpoints(&self) -> &[Breakpoint] {
        &self.breakpoints
    }

    /// Values that are shown after every movement.
    pub fn watched(&self) -> &[Name] {
        &self.watched
    }

    fn symbols(&self) -> &SymbolTable {
        &self.build.project.symbols
    }

    /// The registers after the last statement.
    pub fn registers(&self) -> Registers {
        match self.history.last() {
            Some(event) if self.history.cpu().is_paused() => event.after.clone(),
            _ => self.cpu().registers().clone(),
        }
    }

    /// One step, so many times.
    pub fn step(&mut self, unit: Unit, direction: Direction, times: u64) -> Halt {
        self.hits.clear();
        match (unit, direction) {
            (Unit::Statement, _) if !self.goes_over_library() => self.step(Unit::Into, direction, times),
            (Unit::Statement, Direction::Forward) => self.over_library(times),
            (Unit::Into, Direction::Forward) => match self.history.forward(times.min(STATEMENTS_MAX)) {
                Halt::Reached if times > STATEMENTS_MAX => Halt::Limit,
                halt => halt,
            },
            (Unit::Into, Direction::Back) => self.history.back(times),
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

    /// Whether a step may have to go over a block of the library: there is one, and the run does not stand in it.
    fn goes_over_library(&self) -> bool {
        let compiled = &self.build.compiled;
        let has_library = !compiled.library.is_empty() || !compiled.st_library.is_empty();
        has_library && self.history.next_place().is_none_or(|place| !self.in_library(place))
    }

    /// So many statements outside of the library.
    fn over_library(&mut self, times: u64) -> Halt {
        let build = Arc::clone(&self.build);
        let mut watch = OverLibrary { is_of_library: &|block| build.compiled.is_of_library(block), left: times };
        let from = self.history.position().statements;
        let mut idle_scans = 0;
        loop {
            let passed = self.history.position().statements - from;
            if passed >= STATEMENTS_MAX || idle_scans >= STEPS_MAX {
                return Halt::Limit;
            }
            match self.history.run(Until { statements: STATEMENTS_MAX - passed, scans: 1 }, &mut watch) {
                Halt::Watch => return Halt::Reached,
                // After the last statement of a scan no other one is asked about.
                Halt::ScanEnd if watch.left == 0 => return Halt::Reached,
                Halt::ScanEnd => {
                    let executed = self.history.position().statements - from;
                    idle_scans = if executed == passed { idle_scans + 1 } else { 0 };
                }
                Halt::Reached => return Halt::Limit,
                halt => return halt,
            }
        }
    }

    fn step_to_end(&mut self, unit: Unit, direction: Direction) -> Halt {
        let depth = self.cpu().machine().frames.len().max(1);
        match direction {
            // A scan's end is the end of every block.
            Direction::Forward => match self.history.run(
                Until { statements: STATEMENTS_MAX, scans: 1 },
                &mut StepEnd::new(unit, direction, depth, self.history.next_place(), &self.networks),
            ) {
                Halt::Watch | Halt::ScanEnd => Halt::Reached,
                Halt::Reached => Halt::Limit,
                halt => halt,
            },
            Direction::Back if unit == Unit::Statement => {
                let build = Arc::clone(&self.build);
                self.find_and_go_back(&mut OutOfLibrary(&build.compiled))
            }
            Direction::Back => {
                let networks = std::mem::take(&mut self.networks);
                let mut end = StepEnd::new(unit, direction, depth, self.history.next_place(), &networks);
                let halt = self.find_and_go_back(&mut end);
                self.networks = networks;
                halt
            }
        }
    }

    fn find_and_go_back(&mut self, watch: &mut dyn Watch) -> Halt {
        match self.history.find_back(false, watch) {
            Ok(found) => self.history.go_to_position(found),
            Err(halt) => self.go_to_first(halt),
        }
    }

    /// Runs to a breakpoint, or so many statements; back too.
    pub fn run(&mut self, direction: Direction, statements: u64) -> Halt {
        self.hits.clear();
        match direction {
            Direction::Forward => {
                let mut watch = Breakpoints::new(&mut self.breakpoints, &self.if_rlo);
                let halt = self.history.run(Until { statements, scans: u64::MAX }, &mut watch);
                let hits = std::mem::take(&mut watch.hits);
                if halt == Halt::Watch {
                    self.hits = hits;
                }
                if halt == Halt::Reached { Halt::Limit } else { halt }
            }
            Direction::Back => {
                // Counting backwards has no meaning: every one counts.
                let mut breakpoints: Vec<Breakpoint> = self.breakpoints.iter().map(|one| Breakpoint { every: 1, ..one.clone() }).collect();
                let mut watch = Breakpoints::new(&mut breakpoints, &self.if_rlo);
                match self.history.find_back(false, &mut watch) {
                    Ok(found) => {
                        self.hits = std::mem::take(&mut watch.hits);
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

    /// Which breakpoint paused, and what changed.
    fn hit_text(&self, hit: &Hit) -> Option<String> {
        let breakpoint = self.breakpoints.iter().find(|breakpoint| breakpoint.number == hit.number)?;
        let mut text = self.say(texts::BREAKPOINT, &[&hit.number, &breakpoint.text]);
        if let (Target::Change(name) | Target::Write(name), Some((before, after))) = (&breakpoint.target, hit.change) {
            text.push_str(&format!(": {} -> {}", self.shown(name, before), self.shown(name, after)));
            if !matches!(hit.by, By::Statement(_)) {
                text.push_str(&self.say(texts::BETWEEN, &[]));
            }
        }
        Some(text)
    }

    /// Runs on to a place.
    pub fn run_to(&mut self, goal: Goal) -> Halt {
        self.hits.clear();
        let mut there = At(goal);
        match self.history.run(Until { statements: STATEMENTS_MAX, scans: u64::MAX }, &mut there) {
            Halt::Watch => Halt::Reached,
            Halt::Reached => Halt::Limit,
            halt => halt,
        }
    }

    /// Goes to a position: so many statements since the beginning.
    pub fn go_to(&mut self, position: u64) -> Halt {
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
    pub fn goal(&self, text: &str) -> Result<Goal, String> {
        let here = self.history.next_place().or(self.history.last().map(|event| event.place));
        self.listing.goal(text, here, self.language)
    }

    /// The block whose variables are called by their names alone: where the run stands.
    pub fn here(&self) -> Option<BlockId> {
        self.history.next_place().or(self.history.last().map(|event| event.place)).map(|place| place.block)
    }

    /// Variables of a block by their names alone; those of ST are written without `#`.
    pub fn scope(&self, block: Option<BlockId>) -> Option<Scope> {
        scope(&self.build, block)
    }

    /// Reads the name of a value; a variable is one of this block. One of a block that does not run now has a value when it runs.
    ///
    /// # Errors
    /// Nothing is called that.
    pub fn name_in(&self, text: &str, block: Option<BlockId>) -> Result<Name, NameError> {
        let name = Name::parse_in(text, self.scope(block), self.symbols(), self.cpu().program())?;
        if name.block().is_none() {
            name.read(self.cpu())?;
        }
        Ok(name)
    }

    /// A name that goes on meaning the same when another instance of its block runs.
    ///
    /// # Errors
    /// It is a variable of an instance, and which one cannot be told here.
    pub fn bound(&self, name: Name) -> Result<Name, NameError> {
        name.readable().of_this_instance(self.cpu().machine(), self.cpu().registers())
    }

    /// Sets a breakpoint; the number that it got.
    ///
    /// # Errors
    /// There are too many.
    fn add(&mut self, text: &str, target: Target, only_if: Option<Condition>, every: u64, request: Request) -> Result<u32, String> {
        if self.breakpoints.len() >= BREAKPOINTS_MAX {
            return Err(self.say(texts::BREAKPOINTS_FULL, &[&BREAKPOINTS_MAX]));
        }
        self.numbered += 1;
        let number = self.numbered;
        self.requests.push(request);
        self.breakpoints.push(Breakpoint { number, text: text.to_owned(), target, only_if, every, times: 0 });
        Ok(number)
    }

    /// Deletes a breakpoint; `false` if there is none with this number.
    pub fn delete(&mut self, number: u32) -> bool {
        let Some(index) = self.breakpoints.iter().position(|breakpoint| breakpoint.number == number) else { return false };
        self.breakpoints.remove(index);
        self.requests.remove(index);
        true
    }

    /// Sets a breakpoint at a place, or deletes the one that is there.
    pub fn toggle(&mut self, goal: Goal) -> Result<(), String> {
        let target = Target::Statement(goal.place, goal.last);
        if let Some(number) = self.breakpoints.iter().find(|one| one.target == target).map(|one| one.number) {
            self.delete(number);
            return Ok(());
        }
        let line = self.listing.line(goal.place);
        let text = format!("{}:{}", line.file, line.line);
        let request = Request { wanted: Wanted::Place(text.clone()), only_if: None, block: Some(goal.place.block) };
        self.add(&text, target, None, 1, request).map(drop)
    }

    /// Shows a value after every movement.
    ///
    /// # Errors
    /// There are too many.
    pub fn show(&mut self, name: Name) -> Result<(), String> {
        if self.watched.len() >= BREAKPOINTS_MAX {
            return Err(self.say(texts::WATCHED_FULL, &[&BREAKPOINTS_MAX]));
        }
        self.watched.push(name);
        Ok(())
    }

    /// Sets a value here and now; what was recorded ahead is forgotten.
    ///
    /// # Errors
    /// It cannot be set.
    pub fn set(&mut self, setting: Setting) -> Result<(), NameError> {
        self.history.set(setting)
    }

    /// Who changed a value last, before now; `None` if it has not changed since the beginning, or since what is kept.
    pub fn who(&mut self, name: &Name) -> Option<Who> {
        let (position, hit) = self.last_hit(Target::Change(name.clone()))?;
        let here = self.history.position();
        self.history.go_to_position(position);
        let scan = self.history.scans().checked_sub(1);
        self.history.go_to_position(here);
        let (before, after) = hit.change.unwrap_or_default();
        let line = match hit.by {
            By::Statement(place) => Some(self.listing.line(place)),
            _ => None,
        };
        Some(Who { line, by: hit.by, position: position.statements, scan, change: (self.shown(name, before), self.shown(name, after)) })
    }

    /// When something happened last, at or before now.
    fn last_hit(&mut self, target: Target) -> Option<(Position, Hit)> {
        let mut one = [Breakpoint { number: 0, text: String::new(), target, only_if: None, every: 1, times: 0 }];
        let mut watch = Breakpoints::new(&mut one, &self.if_rlo);
        let found = self.history.find_back(true, &mut watch).ok()?;
        Some((found, watch.hits.into_iter().next()?))
    }

    /// The statement that wrote a value last without changing it, for a value that stays what it is; `None` if none has.
    pub fn writer(&mut self, name: &Name) -> Option<Writer> {
        let (found, hit) = self.last_hit(Target::Write(name.clone()))?;
        let By::Statement(place) = hit.by else { return None };
        let here = self.history.position();
        self.history.go_to_position(found);
        self.history.look_closely();
        let scan = self.history.scans().checked_sub(1);
        let writer = Writer { line: self.listing.line(place), position: found.statements, scan, reason: self.reason() };
        self.history.go_to_position(here);
        Some(writer)
    }

    /// Replays the last statements for an observer, so many at most. The run stands where it stood.
    pub fn watch_last(&mut self, statements: u64, watch: &mut dyn Watch) {
        let here = self.history.position();
        let from = here.statements.saturating_sub(statements).max(self.history.first());
        if from < here.statements {
            self.history.go_to(from);
            self.history.run(Until { statements: here.statements - from, scans: u64::MAX }, watch);
            self.history.go_to_position(here);
        }
    }

    /// Where the run stands.
    pub fn view(&mut self) -> View {
        self.look_closely();
        let history = &self.history;
        let accumulators = self.build.cpu.accumulators;
        let after = self.registers();
        let mut changed = Vec::new();
        let executed = self.executed();
        let place = executed.map(|(event, _)| event.place);
        if let Some((event, around)) = executed {
            changed = changes::of_registers(&event.before, &event.after, accumulators);
            if let Some(around) = around {
                let written = self.written(event.place);
                // In STL people know the addresses; in ST nothing says where a variable lies.
                let fields = if self.on_registers(Some(event.place.block)) { &[][..] } else { self.fields() };
                let (program, mnemonics) = (self.cpu().program(), self.listing.places().mnemonics);
                changed.extend(changes::of_memory(&around.before, &around.after, written.as_ref(), fields, program, mnemonics));
            }
        }
        let line = |place: Option<FaultPlace>| place.map(|place| self.listing.line(place));
        View {
            on_registers: self.on_registers(place.or(history.next_place()).map(|place| place.block)),
            values: self.values_after(),
            position: history.position().statements,
            end: history.end(),
            scan: history.scans().checked_sub(1),
            time_us: history.cpu().time_us(),
            present: history.is_at_present(),
            executed: line(place),
            next: line(history.next_place()),
            registers: changes::registers(&after, accumulators),
            changed,
            stack: history.cpu().machine().frames.iter().map(|frame| frame.block).collect(),
            mode: history.cpu().mode(),
            hits: self.hits.iter().filter_map(|hit| self.hit_text(hit)).collect(),
        }
    }

    /// Whether the statements of a block work on registers; `None`: those of the block that the CPU runs first.
    pub fn on_registers(&self, block: Option<BlockId>) -> bool {
        let block = block.unwrap_or(BlockId::new(sieben_model::block::BlockKind::OrganizationBlock, 1));
        self.build.compiled.bodies.get(&block).is_none_or(|body| body.works_on_registers())
    }

    /// Why the last statement did what it did, in one sentence; empty if nothing has run.
    pub fn reason(&mut self) -> String {
        self.look_closely();
        let Some((event, Some(around))) = self.executed() else { return String::new() };
        let stopped = self.cpu().stop_cause().filter(|_| self.cpu().mode() == OperatingMode::Stop);
        let fault = stopped.filter(|cause| cause.place == Some(event.place)).map(|cause| cause.first_event);
        let moment = Moment { event, before: Some(&around.before), after: &around.after, fault };
        Reasons::new(&self.build.compiled, &self.build.project.texts.program, self.symbols()).sentence(&moment, self.language)
    }

    /// The operand of a statement, if it names a single value.
    fn written(&self, place: FaultPlace) -> Option<Name> {
        let text = self.listing.line(place).text;
        let operand = self.build.compiled.bodies.get(&place.block)?.value_in(&text)?;
        Name::parse_in(operand, self.scope(Some(place.block)), self.symbols(), self.cpu().program()).ok()
    }

    /// The value of a name here, as people read it.
    pub fn value(&self, name: &Name) -> String {
        match (name.clone().readable().read(self.cpu()), name.block()) {
            (Ok(shown), _) => shown.readable(),
            (Err(_), Some(block)) => self.say(texts::NOT_HERE, &[&block]),
            (Err(_), None) => self.say(texts::NOT_LOADED, &[]),
        }
    }

    /// A value as people read it, or that it is not there.
    fn shown(&self, name: &Name, bits: Option<u64>) -> String {
        bits.map_or_else(|| self.say(texts::NOT_THERE, &[]), |bits| name.show_bits(bits).readable())
    }
}

/// Variables of a block by their names alone; those of ST are written without `#`.
fn scope(build: &Build, block: Option<BlockId>) -> Option<Scope> {
    block.map(|block| Scope { block, bare: build.compiled.bodies.get(&block).is_none_or(|body| body.has_bare_names()) })
}

/// The networks of the statements.
fn networks(build: &Build) -> Networks {
    build.compiled.bodies.iter().map(|(&id, body)| (id, body.networks())).collect()
}

/// The statements that store something only where the RLO is 1.
fn if_rlo(build: &Build) -> StoreIfRlo {
    let bodies = build.compiled.bodies.iter();
    bodies.flat_map(|(&block, body)| body.stores_if_rlo().into_iter().map(move |number| (block, number))).collect()
}

/// Pauses at a place.
struct At(Goal);

impl Watch for At {
    fn before(&mut self, _machine: &sieben_engine::Machine, place: FaultPlace) -> bool {
        place.block == self.0.place.block && (self.0.place.statement..=self.0.last).contains(&place.statement)
    }
}
