//! The history of a run: every statement of it can be gone back to.
//!
//! A run in virtual time is determined by its program and by what comes from outside: when scans begin and what is set from outside.
//! The history keeps that, and snapshots of the CPU every so many statements; a position between is reached by running on from the
//! snapshot before it. Positions are counted in statements since the beginning: position *n* is the moment after *n* statements.

mod drive;
mod kept;
mod plan;
mod search;
mod watch;

use std::collections::VecDeque;
use std::fmt;

use sieben_cpu::{ChangeRefused, Cpu, Loaded, OnlineChange, OperatingMode};
use sieben_engine::{FaultPlace, Machine, StatementEvent};

use crate::names::{NameError, Setting};

use drive::{Drive, Watching};
use kept::Kept;

pub use drive::{Unwatched, Watch};
pub use plan::{Action, Plan};
pub use watch::{Breakpoint, Breakpoints, By, Condition, Hit, Relation, StoreIfRlo, Target};

/// Where a run stands in its history.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Position {
    /// Statements executed since the beginning.
    pub statements: u64,
    /// Actions begun: the same number of statements may lie before and behind the beginning of a scan.
    pub actions: usize,
}

/// Why a movement ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Halt {
    /// It came to where it was to go.
    Reached,
    /// The watcher wanted it.
    Watch,
    /// The last of so many scans is over.
    ScanEnd,
    /// The limit of statements or of scans without one.
    Limit,
    /// The CPU is in STOP.
    Stopped,
    /// All scans of the plan have run.
    NoMoreScans,
    /// There is nothing before.
    Beginning,
    /// What lies before is no longer kept.
    Forgotten,
}

/// How far a movement goes at most.
#[derive(Clone, Copy, Debug)]
pub struct Until {
    /// Statements from here.
    pub statements: u64,
    /// Ends of scans from here.
    pub scans: u64,
}

/// Scans without a statement that a movement passes before it gives up.
const IDLE_SCANS_MAX: u64 = 1000;

/// Something from outside, and when it came.
#[derive(Clone, Debug)]
struct Entry {
    action: Action,
    /// Statements before it.
    at: u64,
    /// It came between two statements of a scan, not between two scans.
    inside: bool,
}

/// How a part of a movement ended.
struct Went {
    /// The watcher wants to pause.
    wanted: bool,
    /// The CPU is paused at the target.
    reached: bool,
    /// A scan is over.
    scan_ended: bool,
}

/// The machine around a statement. Its registers are not those of the statement, which the event has.
#[derive(Clone, Debug)]
pub struct Around {
    /// Before the statement.
    pub before: Machine,
    /// Behind it, before anything else happens.
    pub after: Machine,
}

/// Why another program did not take over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChangeError {
    /// The CPU does not take it.
    Refused(ChangeRefused),
    /// This is the past, and a module of the CPU cannot go back.
    Past,
}

impl fmt::Display for ChangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(refused) => refused.fmt(f),
            Self::Past => f.write_str("a module of this CPU cannot go back; go to the end of the history first"),
        }
    }
}

impl std::error::Error for ChangeError {}

/// A run that can go back.
pub struct History {
    cpu: Cpu,
    plan: Plan,
    /// What came from outside, oldest first; those before `dropped` are forgotten.
    log: VecDeque<Entry>,
    dropped: usize,
    kept: Kept,
    position: Position,
    /// Scans begun at this position.
    scans: u64,
    /// The greatest position of the run.
    end: u64,
    last: Option<StatementEvent>,
    around: Option<Around>,
    /// A value of the recording could not be set.
    refused: bool,
    /// The beginning of what is executed next, if the CPU is paused.
    next_place: Option<FaultPlace>,
}

impl History {
    /// A history that begins with a CPU in STOP, in virtual time. The plan says what comes when nobody says otherwise.
    pub fn new(mut cpu: Cpu, plan: Plan) -> Self {
        cpu.record_modules();
        let position = Position { statements: 0, actions: 0 };
        let kept = Kept::new(&cpu);
        Self {
            cpu,
            plan,
            log: VecDeque::new(),
            dropped: 0,
            kept,
            position,
            scans: 0,
            end: 0,
            last: None,
            around: None,
            refused: false,
            next_place: None,
        }
    }

    /// A history of which this was recorded: what came from outside, with the statements before it if it came inside a scan. The run stands at its
    /// beginning; [`Self::play`] brings it to its end.
    pub fn recorded(cpu: Cpu, plan: Plan, actions: Vec<(Action, Option<u64>)>) -> Self {
        let mut history = Self::new(cpu, plan);
        history.log = actions
            .into_iter()
            .map(|(action, inside)| Entry { action, at: inside.unwrap_or_default(), inside: inside.is_some() })
            .collect();
        history
    }

    /// Runs on through what was recorded, up to so many statements; `true` if it came to this very end.
    pub fn play(&mut self, statements: u64) -> bool {
        // Whoever changed the recording may have written anything.
        while self.position.statements <= statements
            && (self.has_recorded() || (self.cpu.is_paused() && self.position.statements < statements))
        {
            // Where an action began is known when it has come.
            if let Some(index) = self.position.actions.checked_sub(self.dropped)
                && let Some(entry) = self.log.get_mut(index).filter(|entry| !entry.inside)
            {
                entry.at = self.position.statements;
            }
            self.go(statements, false, Watching { watch: &mut Unwatched, from_here: false });
        }
        let scan = |entry: &Entry| if let Action::Scan { now_us } = entry.action { Some(now_us) } else { None };
        let last_us = self.log.iter().rev().find_map(scan);
        self.plan.rewind(!self.log.is_empty(), self.scans, last_us);
        self.position.statements == statements && !self.has_recorded() && !self.refused
    }

    /// The CPU at this position: paused between two statements, or between two scans.
    pub fn cpu(&self) -> &Cpu {
        &self.cpu
    }

    /// Where the run stands.
    pub fn position(&self) -> Position {
        self.position
    }

    /// Statements of the whole recorded run.
    pub fn end(&self) -> u64 {
        self.end
    }

    /// The first position that can be gone back to.
    pub fn first(&self) -> u64 {
        self.kept.first().statements
    }

    /// Scans that have begun.
    pub fn scans(&self) -> u64 {
        self.scans
    }

    /// Whether nothing lies ahead that was recorded.
    pub fn is_at_present(&self) -> bool {
        self.position.statements >= self.end && self.position.actions >= self.dropped + self.log.len()
    }

    /// The statement that was executed last, with the registers around it.
    pub fn last(&self) -> Option<&StatementEvent> {
        self.last.as_ref()
    }

    /// The machine around that statement, if [`Self::look_closely`] was asked, or the last movement was one statement.
    pub fn around(&self) -> Option<&Around> {
        self.around.as_ref()
    }

    /// The statement that comes next; `None` between two scans.
    pub fn next_place(&self) -> Option<FaultPlace> {
        self.next_place.filter(|_| self.cpu.is_paused())
    }

    /// Bytes that the snapshots take; an estimate.
    pub fn bytes(&self) -> usize {
        self.kept.bytes()
    }

    /// What came from outside, oldest first: the action, the statements before it, and whether it came inside a scan.
    pub fn actions(&self) -> impl Iterator<Item = (&Action, u64, bool)> {
        self.log.iter().map(|entry| (&entry.action, entry.at, entry.inside))
    }

    /// Whether the whole run is kept from its beginning.
    pub fn is_whole(&self) -> bool {
        self.dropped == 0
    }

    /// So many statements; see [`Self::run`].
    pub fn forward(&mut self, statements: u64) -> Halt {
        self.run(Until { statements, scans: u64::MAX }, &mut Unwatched)
    }

    /// Goes on, through what was recorded and beyond it, until the watcher says so or the limit is reached.
    pub fn run(&mut self, until: Until, watch: &mut dyn Watch) -> Halt {
        let target = self.position.statements.saturating_add(until.statements);
        if until.statements == 0 || until.scans == 0 {
            return Halt::Reached;
        }
        let (mut ends, mut idle) = (0, 0);
        watch.begin(self.cpu.machine());
        loop {
            let executed = self.position.statements;
            if !self.cpu.is_paused() && !self.has_recorded() && !self.supply() {
                return if self.cpu.mode() == OperatingMode::Stop { Halt::Stopped } else { Halt::NoMoreScans };
            }
            let Went { wanted, reached, scan_ended } = self.go(target, until.statements == 1, Watching { watch, from_here: false });
            if wanted {
                return Halt::Watch;
            }
            if reached {
                return Halt::Reached;
            }
            if self.cpu.is_paused() {
                continue;
            }
            ends += u64::from(scan_ended);
            if self.position.statements >= target {
                return Halt::Reached;
            }
            if self.cpu.mode() == OperatingMode::Stop && !self.has_recorded() && self.position.actions > 0 {
                return Halt::Stopped;
            }
            if ends >= until.scans {
                return Halt::ScanEnd;
            }
            idle = if self.position.statements == executed { idle + 1 } else { 0 };
            if idle > IDLE_SCANS_MAX {
                return Halt::Limit;
            }
        }
    }

    /// Goes back by so many statements.
    pub fn back(&mut self, statements: u64) -> Halt {
        let Some(target) = self.position.statements.checked_sub(statements) else {
            let first = self.first();
            self.go_to(first);
            return if first == 0 { Halt::Beginning } else { Halt::Forgotten };
        };
        self.go_to(target)
    }

    /// Goes back to the beginning of the scan that was running or has just ended, or of so many scans before it.
    pub fn back_scans(&mut self, scans: u64) -> Halt {
        if scans == 0 {
            return Halt::Reached;
        }
        let here = self.position;
        let beginnings = self.log.iter().enumerate().rev().filter(|(_, entry)| matches!(entry.action, Action::Scan { .. }));
        let mut before = beginnings
            .map(|(index, entry)| Position { statements: entry.at, actions: self.dropped + index })
            .filter(|&position| position < here);
        let found = usize::try_from(scans - 1).ok().and_then(|skipped| before.nth(skipped));
        match found {
            Some(position) => self.go_to_position(position),
            None => {
                let first = self.kept.first();
                self.go_to_position(first);
                if first.actions == 0 { Halt::Beginning } else { Halt::Forgotten }
            }
        }
    }

    /// Goes to a position of the recorded run: right after its statement; the end of the run is the last one.
    pub fn go_to(&mut self, statements: u64) -> Halt {
        if statements < self.first() {
            return Halt::Forgotten;
        }
        if statements >= self.end {
            self.replay_to(self.end, Some(self.dropped + self.log.len()));
        } else {
            self.replay_to(statements, None);
        }
        Halt::Reached
    }

    /// Goes to this very position, which [`Self::position`] has told.
    pub fn go_to_position(&mut self, position: Position) -> Halt {
        if position.statements < self.first() {
            return Halt::Forgotten;
        }
        self.replay_to(position.statements.min(self.end), Some(position.actions));
        Halt::Reached
    }

    /// Makes [`Self::around`] known for the last statement, wherever the last movement came from.
    pub fn look_closely(&mut self) {
        if self.around.is_none() && self.position.statements > self.first() {
            let position = self.position;
            self.go_to_position(position);
        }
    }

    /// Sets a value from outside, here and now. What was recorded ahead is forgotten: the run goes another way from here.
    ///
    /// # Errors
    /// Nothing of that name can be set, or this is the past and a module cannot be copied.
    pub fn set(&mut self, setting: Setting) -> Result<(), NameError> {
        let present = self.is_at_present();
        if !present && !self.kept.has_modules() {
            return Err(NameError::new(format!(
                "`{}` cannot be set in the past: a module of this CPU cannot go back; go to the end of the history first",
                setting.name.text()
            )));
        }
        setting.apply(&mut self.cpu)?;
        self.forget_ahead();
        let action = Action::Set(setting);
        self.log.push_back(Entry { action, at: self.position.statements, inside: self.cpu.is_paused() });
        self.position.actions += 1;
        Ok(())
    }

    /// Another program takes over, here and now, between two scans. What was recorded ahead is forgotten, and what was before as well: its
    /// statements are those of a program that is gone. `again` says what is still to be set in the names of the new program; what it does not
    /// find is left out.
    ///
    /// # Errors
    /// The CPU does not take it, or this is the past and a module cannot be copied. Then nothing has changed.
    pub fn change_online(&mut self, new: Loaded, again: impl FnMut(&Setting) -> Option<Setting>) -> Result<OnlineChange, ChangeError> {
        if !self.is_at_present() && !self.kept.has_modules() {
            return Err(ChangeError::Past);
        }
        let change = self.cpu.change_online(new).map_err(ChangeError::Refused)?;
        self.forget_ahead();
        self.plan.rename(again);
        self.dropped += self.log.len();
        self.log.clear();
        self.kept = Kept::from(&self.cpu, self.position, self.scans);
        self.cpu.forget_before(self.kept.oldest());
        (self.last, self.around, self.next_place) = (None, None, None);
        Ok(change)
    }

    fn forget_ahead(&mut self) {
        self.log.truncate(self.position.actions - self.dropped);
        self.kept.forget_behind(self.position);
        self.end = self.position.statements;
        let scan = |entry: &Entry| if let Action::Scan { now_us } = entry.action { Some(now_us) } else { None };
        let last_us = self.log.iter().rev().find_map(scan).or_else(|| (self.scans > 0).then(|| self.cpu.time_us()));
        // What is set before the CPU is started is no start.
        let started = self.dropped > 0 || self.log.iter().any(|entry| matches!(entry.action, Action::Restart(_)));
        self.plan.rewind(started, self.scans, last_us);
    }

    fn has_recorded(&self) -> bool {
        self.position.actions < self.dropped + self.log.len()
    }

    fn entry(&self, index: usize) -> Option<&Entry> {
        self.log.get(index.checked_sub(self.dropped)?)
    }

    /// Whether a scan is what runs or has run last; else it is a startup.
    fn in_scan(&self) -> bool {
        let done = self.log.iter().take(self.position.actions - self.dropped);
        let begun = done.rev().find(|entry| !matches!(entry.action, Action::Set(_)));
        begun.is_some_and(|entry| matches!(entry.action, Action::Scan { .. }))
    }

    /// Adds what the plan wants next; `false` if there is nothing.
    fn supply(&mut self) -> bool {
        let stopped = self.cpu.mode() == OperatingMode::Stop && self.plan.has_started();
        if stopped {
            return false;
        }
        let at = self.position.statements;
        let actions = self.plan.next();
        let any = !actions.is_empty();
        self.log.extend(actions.into_iter().map(|action| Entry { action, at, inside: false }));
        any
    }

    /// One thing: a value that is set, or the run up to the next pause, end of an action or snapshot.
    fn go(&mut self, target: u64, closely: bool, drive: Watching<'_>) -> Went {
        let paused = self.cpu.is_paused();
        let here = self.position.statements;
        let set_at = |entry: Option<&Entry>| entry.filter(|entry| entry.inside).map(|entry| entry.at);
        // What is set between two statements, and where the next such thing is.
        let set_inside = set_at(self.entry(self.position.actions + usize::from(!paused)));
        let entry = self.entry(self.position.actions).map(|entry| entry.action.clone());
        if let Some(Action::Set(setting)) = entry.as_ref().filter(|_| !paused || set_inside == Some(here)) {
            // It was accepted when it was recorded, but a recording may have been changed.
            self.refused |= setting.apply(&mut self.cpu).is_err();
            drive.watch.outside(self.cpu.machine(), &Action::Set(setting.clone()));
            self.position.actions += 1;
            self.keep_if_due();
            return Went { wanted: false, reached: false, scan_ended: false };
        }
        if let Some(action) = entry.as_ref().filter(|_| !paused) {
            drive.watch.outside(self.cpu.machine(), action);
        }
        let until = target.min(self.kept.next_at(self.position)).min(set_inside.unwrap_or(u64::MAX));
        let capture = if closely { Some(here) } else { target.checked_sub(1).filter(|_| target != u64::MAX) };
        let mut drive = Drive::new(here, until, capture, paused, drive);
        match entry {
            _ if paused => {
                self.cpu.go_on(Some(&mut drive));
            }
            Some(Action::Restart(restart)) => {
                self.position.actions += 1;
                let now = self.cpu.time_us();
                self.cpu.restart_with(restart, &mut || now, Some(&mut drive));
            }
            Some(Action::Scan { now_us }) => {
                self.position.actions += 1;
                self.scans += 1;
                self.cpu.scan_traced(now_us, &mut drive);
            }
            Some(Action::Set(_)) | None => {}
        }
        let (executed, wanted, next_place) = (drive.executed, drive.wanted, drive.next_place);
        if executed > here {
            self.last = drive.last.take();
            self.around = drive.around.take().filter(|(at, ..)| at + 1 == executed).and_then(|(_, before, after)| {
                let after = after?;
                Some(Around { before, after })
            });
        }
        self.next_place = next_place;
        self.position.statements = executed;
        self.end = self.end.max(executed);
        self.keep_if_due();
        let paused = self.cpu.is_paused();
        Went { wanted, reached: paused && executed >= target, scan_ended: !paused && self.in_scan() }
    }

    fn keep_if_due(&mut self) {
        if self.kept.is_due(self.position) {
            self.kept.keep(&self.cpu, self.position, self.scans, self.last.as_ref(), self.end);
            self.drop_forgotten();
        }
    }

    /// Entries before the oldest snapshot can no longer be needed.
    fn drop_forgotten(&mut self) {
        self.kept.bound(self.log.len(), self.cpu.recorded_bytes());
        self.cpu.forget_before(self.kept.oldest());
        let first = self.kept.first().actions;
        while self.dropped < first {
            self.log.pop_front();
            self.dropped += 1;
        }
    }

    /// Goes to a kept position by running on from the snapshot before it.
    fn replay_to(&mut self, statements: u64, actions: Option<usize>) {
        // One statement before it at the latest, so that what it changed is known.
        self.restore(Position { statements: statements.saturating_sub(1), actions: actions.unwrap_or(usize::MAX) });
        let actions = actions.unwrap_or(0);
        while self.position.statements < statements || self.position.actions < actions {
            if !self.cpu.is_paused() && !self.has_recorded() {
                break;
            }
            self.go(statements, false, Watching { watch: &mut Unwatched, from_here: false });
        }
    }

    /// The newest snapshot at or before a position; the run stands there.
    fn restore(&mut self, position: Position) {
        let index = self.kept.at_or_before(position);
        self.take_back(index);
    }

    /// The newest snapshot before a position, strictly; the first one if there is none.
    fn restore_before(&mut self, position: Position) {
        let index = self.kept.before(position);
        self.take_back(index);
    }

    fn take_back(&mut self, index: usize) {
        let kept = self.kept.get(index);
        self.cpu.go_back_to(&kept.snapshot);
        self.position = kept.position;
        self.scans = kept.scans;
        self.last = kept.last.clone();
        self.around = None;
        self.next_place = None;
    }
}
