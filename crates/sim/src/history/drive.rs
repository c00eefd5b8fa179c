//! The tracer that counts statements, pauses where it is told, and asks a watcher.

use sieben_engine::{FaultPlace, Machine, StatementEvent, Stored, Tracer};

use super::plan::Action;

/// Someone who looks at every statement and says where to pause.
pub trait Watch {
    /// A movement begins with this machine.
    fn begin(&mut self, machine: &Machine) {
        let _ = machine;
    }
    /// Before a statement: whether to pause here. Not asked about the one that a movement begins with.
    fn before(&mut self, machine: &Machine, place: FaultPlace) -> bool {
        let _ = (machine, place);
        false
    }
    /// Something comes from outside: the process image with a scan, a value that is set, a restart.
    fn outside(&mut self, machine: &Machine, action: &Action) {
        let _ = (machine, action);
    }
    /// A statement stores something; what happens [`Self::after`] it or, if it called a block, before the next one.
    fn stores(&mut self, machine: &Machine, stored: Stored) {
        let _ = (machine, stored);
    }
    /// After a statement: whether to pause before the next one.
    fn after(&mut self, machine: &Machine, event: &StatementEvent) -> bool {
        let _ = (machine, event);
        false
    }
}

/// Nobody watches.
pub struct Unwatched;

impl Watch for Unwatched {}

/// A watcher, and whether it is asked about the statement too that a movement begins with.
pub(super) struct Watching<'w> {
    pub(super) watch: &'w mut dyn Watch,
    pub(super) from_here: bool,
}

/// Runs a CPU up to a position.
pub(super) struct Drive<'w> {
    /// Statements executed since the beginning.
    pub(super) executed: u64,
    /// Pauses when so many are.
    until: u64,
    /// Keeps the machine before the statement at this position.
    capture: Option<u64>,
    /// The next question is about the statement that the movement begins with.
    beginning: bool,
    watching: Watching<'w>,
    /// The watcher wants a pause.
    pub(super) wanted: bool,
    pub(super) last: Option<StatementEvent>,
    /// The machine before a statement, how many were executed then, and the machine behind it.
    pub(super) around: Option<(u64, Machine, Option<Machine>)>,
    pub(super) next_place: Option<FaultPlace>,
}

impl<'w> Drive<'w> {
    pub(super) fn new(executed: u64, until: u64, capture: Option<u64>, beginning: bool, watching: Watching<'w>) -> Self {
        Self { executed, until, capture, beginning, watching, wanted: false, last: None, around: None, next_place: None }
    }
}

impl Tracer for Drive<'_> {
    fn stores(&mut self, machine: &Machine, stored: Stored) {
        self.watching.watch.stores(machine, stored);
    }

    fn statement(&mut self, machine: &Machine, event: &StatementEvent) {
        if let Some((at, _, after)) = &mut self.around
            && *at == self.executed
        {
            *after = Some(machine.clone());
        }
        self.executed += 1;
        self.wanted |= self.watching.watch.after(machine, event);
        match &mut self.last {
            Some(last) => last.clone_from(event),
            last => *last = Some(event.clone()),
        }
    }

    fn pauses_before(&mut self, machine: &Machine, place: FaultPlace) -> bool {
        let beginning = std::mem::take(&mut self.beginning);
        if !self.wanted && (!beginning || self.watching.from_here) {
            self.wanted = self.watching.watch.before(machine, place);
        }
        if !beginning && (self.wanted || self.executed >= self.until) {
            self.next_place = Some(place);
            return true;
        }
        if self.capture == Some(self.executed) {
            self.around = Some((self.executed, machine.clone(), None));
        }
        false
    }
}
