//! What the statements that led here left behind, for the columns beside the source.

use std::collections::HashMap;

use sieben_engine::machine::Registers;
use sieben_engine::{FaultPlace, Machine, StatementEvent};
use sieben_sim::history::Watch;
use sieben_workspace::session::table;
use sieben_workspace::session::{LineValues, Session};

/// Statements before the present one that are looked at.
const TRAIL: u64 = 200;

/// What a statement left behind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Seen {
    /// RLO, STA and ACCU 1.
    Registers(u64, u64, u32),
    /// The variables that it names, as `speed = 7, step = 1`.
    Values(String),
}

/// A call whose block has not come back yet.
struct Call {
    event: StatementEvent,
    /// Blocks that run where it stands.
    depth: usize,
}

/// Keeps what the last execution of each statement of a scan left behind.
pub(super) struct Trail {
    pub(super) seen: HashMap<FaultPlace, Seen>,
    /// The same statements in their order, with all registers.
    pub(super) order: Vec<(FaultPlace, Registers)>,
    /// The clock stands still in a scan: another time is another scan.
    clock_us: u64,
    values: LineValues,
    calls: Vec<Call>,
    /// Blocks that ran before the last statement.
    depth: usize,
}

impl Trail {
    /// Of the statements that led where the run stands.
    pub(super) fn of(session: &mut Session) -> Self {
        let values = LineValues::new(session);
        let mut trail = Self { seen: HashMap::new(), order: Vec::new(), clock_us: 0, values, calls: Vec::new(), depth: usize::MAX };
        session.watch_last(TRAIL, &mut trail);
        if session.cpu().is_paused() {
            trail.come_back(session.cpu().machine());
        }
        trail
    }

    /// Calls that are over in this machine show what is there now.
    fn come_back(&mut self, machine: &Machine) {
        while self.calls.last().is_some_and(|call| call.depth >= machine.frames.len()) {
            let Some(call) = self.calls.pop() else { return };
            if call.depth == machine.frames.len() {
                self.note(&call.event, machine);
            }
        }
    }

    fn note(&mut self, event: &StatementEvent, machine: &Machine) {
        let values = self.values.of(event, machine);
        if !values.is_empty() {
            self.seen.insert(event.place, Seen::Values(table::after(&values)));
        }
    }
}

impl Watch for Trail {
    fn begin(&mut self, machine: &Machine) {
        self.depth = machine.frames.len();
    }

    fn before(&mut self, machine: &Machine, _: FaultPlace) -> bool {
        self.come_back(machine);
        self.depth = machine.frames.len();
        false
    }

    fn after(&mut self, machine: &Machine, event: &StatementEvent) -> bool {
        if self.clock_us != machine.clock_us {
            self.clock_us = machine.clock_us;
            self.seen.clear();
            self.order.clear();
            self.calls.clear();
        }
        self.order.push((event.place, event.after.clone()));
        if self.values.on_registers(event.place) {
            let registers = &event.after;
            self.seen.insert(event.place, Seen::Registers(registers.rlo, registers.sta, registers.accu1 as u32));
            return false;
        }
        self.note(event, machine);
        if machine.frames.len() > self.depth {
            self.calls.push(Call { event: event.clone(), depth: self.depth });
        }
        false
    }
}
