//! Looking back: the last moment before this one at which something was so.

use sieben_engine::{FaultPlace, Machine, StatementEvent, Stored};

use super::drive::{Watch, Watching};
use super::plan::Action;
use super::{Halt, History, Position};

/// Passes everything on, notes what the watcher wants and pauses nowhere.
struct Noting<'w> {
    watch: &'w mut dyn Watch,
    executed: u64,
    /// The statements before the last wish.
    wished: Option<u64>,
    /// A wish after so many statements is none of the past.
    here: Option<u64>,
}

impl Watch for Noting<'_> {
    fn begin(&mut self, machine: &Machine) {
        self.watch.begin(machine);
    }
    fn outside(&mut self, machine: &Machine, action: &Action) {
        self.watch.outside(machine, action);
    }
    fn stores(&mut self, machine: &Machine, stored: Stored) {
        self.watch.stores(machine, stored);
    }
    fn before(&mut self, machine: &Machine, place: FaultPlace) -> bool {
        if self.here != Some(self.executed) && self.watch.before(machine, place) {
            self.wished = Some(self.executed);
        }
        false
    }
    fn after(&mut self, machine: &Machine, event: &StatementEvent) -> bool {
        self.executed += 1;
        if self.here != Some(self.executed) && self.watch.after(machine, event) {
            self.wished = Some(self.executed);
        }
        false
    }
}

impl History {
    /// The last moment before this one (`or_now`: or this one) at which the watcher wants to pause: after the statement that it wanted to pause
    /// behind, or before the one that it wanted to pause at. The run stands where it stood.
    ///
    /// # Errors
    /// There is none back to the beginning, or what lies further back is forgotten.
    pub fn find_back(&mut self, or_now: bool, watch: &mut dyn Watch) -> Result<Position, Halt> {
        let here = self.position;
        let found = self.search_back(here, or_now, watch);
        let first = self.first();
        self.go_to_position(here);
        found.ok_or(if first == 0 { Halt::Beginning } else { Halt::Forgotten })
    }

    fn search_back(&mut self, here: Position, or_now: bool, watch: &mut dyn Watch) -> Option<Position> {
        let mut end = here;
        loop {
            self.restore_before(end);
            let begin = self.position;
            if begin >= end {
                return None;
            }
            let mut found = None;
            let now = (!or_now).then_some(here.statements);
            let mut noting = Noting { watch: &mut *watch, executed: begin.statements, wished: None, here: now };
            noting.begin(self.cpu.machine());
            while self.position < end && (self.cpu.is_paused() || self.has_recorded()) {
                self.go(end.statements, false, Watching { watch: &mut noting, from_here: true });
                if let Some(statements) = noting.wished.take() {
                    found = Some(Position { statements, actions: self.position.actions });
                }
            }
            if found.is_some() {
                return found.filter(|&found| found <= here);
            }
            end = begin;
        }
    }
}
