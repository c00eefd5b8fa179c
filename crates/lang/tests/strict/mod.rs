//! A Host for tests of single instructions.

use sieben_engine::{Fault, FaultPlace, Host, Machine, Reaction, StopReason};
use sieben_model::address::Width;
use sieben_model::block::BlockId;

/// Stops at every fault; every module answers with 0.
pub(crate) struct Strict;

impl Host for Strict {
    fn fault(&mut self, _: &mut Machine, fault: &Fault, place: FaultPlace) -> Reaction {
        Reaction::Stop(StopReason { event: fault.event(), place: Some(place) })
    }
    fn peripheral_read(&mut self, _: &mut Machine, _: u32, _: Width) -> Option<u32> {
        Some(0)
    }
    fn peripheral_write(&mut self, _: &mut Machine, _: u32, _: Width, _: u32) -> bool {
        true
    }
    fn safe_point(&mut self, machine: &mut Machine, _: FaultPlace) -> Reaction {
        machine.budget = 1000;
        Reaction::Continue
    }
    fn system_function(&mut self, _: &mut Machine, _: BlockId, _: usize) -> Reaction {
        Reaction::Continue
    }
}
