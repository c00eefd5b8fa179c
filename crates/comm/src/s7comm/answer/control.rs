//! Start, stop, memory reset, the clock and the status lists.

use sieben_cpu::{DateAndTime, NoList, OperatingMode, PartialList, Requester, Restart, Station};
use sieben_workspace::gate::Plant;

use super::Surroundings;
use crate::s7comm::job::{Pending, Reply};
use crate::s7comm::wire::codes::Refusal;

/// Lists of which clients ask for index 0, and the index that they mean.
const INDEX_MEANT: &[(u16, u16)] = &[(0x0131, 1), (0x0232, 4)];

/// Reads a status list.
pub(super) fn status_list(plant: &Plant, id: u16, index: u16) -> Reply {
    let meant = INDEX_MEANT.iter().find(|row| row.0 == id && index == 0).map_or(index, |row| row.1);
    match plant.cpu.status_list(id, meant) {
        // The answer names what was asked for.
        Ok(list) => Reply::SystemStatus(PartialList { index, ..list }),
        Err(NoList::Id) => Reply::Refused(Refusal::UnknownListId),
        Err(NoList::Index) => Reply::Refused(Refusal::UnknownListIndex),
    }
}

/// Sets the clock.
pub(super) fn set_clock(plant: &mut Plant, wanted: DateAndTime) -> Reply {
    match plant.cpu.set_clock(wanted) {
        Ok(()) => Reply::Done,
        Err(_) => Reply::Refused(Refusal::WrongTime),
    }
}

/// STOP.
pub(super) fn stop(plant: &mut Plant, by: Requester) -> Reply {
    if plant.is_stopped() {
        return Reply::Already;
    }
    plant.stop(by);
    Reply::Done
}

/// Asks for a start from STOP; the thread that scans carries it out.
pub(super) fn start(plant: &mut Plant, restart: Restart, by: Requester) -> Reply {
    match plant.cpu.mode() {
        OperatingMode::Startup | OperatingMode::Run => Reply::Already,
        OperatingMode::Hold => Reply::Refused(Refusal::CannotPerform),
        // Two starts at the same time would be one, and its second client would wait for the wrong one.
        OperatingMode::Stop if plant.is_about_to_start() => Reply::Refused(Refusal::CannotPerform),
        OperatingMode::Stop => {
            plant.ask_for_start(restart, by);
            Reply::Later(Box::new(Starting))
        }
    }
}

/// A start that was asked for.
#[derive(Debug)]
struct Starting;

impl Pending for Starting {
    fn poll(&mut self, plant: &mut Plant, _: &mut Surroundings) -> Option<Reply> {
        match plant.cpu.mode() {
            _ if plant.is_about_to_start() => None,
            OperatingMode::Startup | OperatingMode::Run => Some(Reply::Done),
            // The startup ended in STOP, with an entry in the diagnostic buffer.
            OperatingMode::Stop | OperatingMode::Hold => Some(Reply::Refused(Refusal::CannotPerform)),
        }
    }
}

/// Memory reset.
pub(super) fn memory_reset(plant: &mut Plant, by: Requester) -> Reply {
    match Station::memory_reset(&mut plant.cpu, by) {
        Ok(()) => Reply::Done,
        Err(_) => Reply::Refused(Refusal::CannotPerform),
    }
}
