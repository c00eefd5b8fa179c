//! How far a step goes: to the next statement of this block, out of it, to another network or block.

use std::collections::HashMap;

use sieben_engine::{FaultPlace, Machine, StatementEvent};
use sieben_model::block::BlockId;
use sieben_sim::history::Watch;

/// How far a step goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// To the next statement, into a block of the user that is called, over one of the library.
    Statement,
    /// To the next statement, into whatever block is called.
    Into,
    /// To the next statement, over a block that is called.
    Over,
    /// Out of the block.
    Out,
    /// To the next network, over blocks that are called.
    Network,
    /// To another block, into it or out of it.
    Block,
    /// To the end of a scan; back to its beginning.
    Scan,
}

/// Whether a step goes on or back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// On.
    Forward,
    /// Back.
    Back,
}

/// Networks of statements, by block.
pub(super) type Networks = HashMap<BlockId, Vec<u32>>;

/// Pauses where a step ends.
pub(super) struct StepEnd<'n> {
    unit: Unit,
    direction: Direction,
    /// Nested blocks where the step began.
    depth: usize,
    networks: &'n Networks,
    /// Block and network of the last statement that was not deeper.
    last: Option<(BlockId, u32)>,
}

impl<'n> StepEnd<'n> {
    /// The end of a step that begins after this statement, or before the statement `next`, so many blocks deep.
    pub(super) fn new(unit: Unit, direction: Direction, depth: usize, next: Option<FaultPlace>, networks: &'n Networks) -> Self {
        let mut end = Self { unit, direction, depth, networks, last: None };
        end.last = next.map(|place| end.key(place));
        end
    }

    fn key(&self, place: FaultPlace) -> (BlockId, u32) {
        // The implied end of a block belongs to its last network.
        let network = self.networks.get(&place.block).and_then(|all| all.get(place.statement as usize).or(all.last())).copied();
        (place.block, if self.unit == Unit::Block { 0 } else { network.unwrap_or_default() })
    }
}

impl Watch for StepEnd<'_> {
    fn begin(&mut self, _machine: &Machine) {
        if self.direction == Direction::Back {
            self.last = None;
        }
    }

    fn before(&mut self, machine: &Machine, place: FaultPlace) -> bool {
        let depth = machine.frames.len();
        match self.unit {
            Unit::Statement | Unit::Into | Unit::Scan => false,
            Unit::Over => depth <= self.depth,
            Unit::Out => depth < self.depth,
            Unit::Network if depth > self.depth => false,
            Unit::Network | Unit::Block => {
                let key = self.key(place);
                // A block that begins anew is another one, even if it is the same.
                let fresh = depth <= 1 && place.statement == 0 && machine.frames.last().is_some_and(|frame| frame.resume == 0);
                self.last.replace(key).is_some_and(|last| last != key) || fresh
            }
        }
    }

    fn after(&mut self, _machine: &Machine, _event: &StatementEvent) -> bool {
        false
    }
}

/// Pauses after so many statements outside of the library, before the next of them.
pub(super) struct OverLibrary<'c> {
    pub(super) is_of_library: &'c dyn Fn(BlockId) -> bool,
    /// Statements that are still to come.
    pub(super) left: u64,
}

impl Watch for OverLibrary<'_> {
    fn before(&mut self, _: &Machine, place: FaultPlace) -> bool {
        self.left == 0 && !(self.is_of_library)(place.block)
    }

    fn after(&mut self, _: &Machine, event: &StatementEvent) -> bool {
        if !(self.is_of_library)(event.place.block) {
            self.left = self.left.saturating_sub(1);
        }
        false
    }
}
