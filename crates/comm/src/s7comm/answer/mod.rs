//! What the CPU does about a job.

mod blocks;
mod control;
mod linking;
mod stored;
mod variables;

use std::sync::Arc;

use sieben_cpu::{Requester, Station};
use sieben_workspace::gate::Plant;

use super::job::{Job, Reply};
pub use linking::Linker;
pub use stored::{STORED_BLOCKS_MAX, STORED_BYTES_MAX, StoredBlocks};

/// What the answers to all clients of a server need, and no CPU has.
#[derive(Debug, Default)]
pub struct Surroundings {
    /// Blocks that were downloaded and not linked.
    pub stored: StoredBlocks,
    /// What makes a changed program ready to run; without one, data blocks get other values and nothing else.
    pub linker: Option<Arc<dyn Linker>>,
}

/// Does a job at the cycle control point. It was looked at by [`super::guard`] before.
pub fn perform(job: &Job, plant: &mut Plant, around: &mut Surroundings, by: Requester) -> Reply {
    if !job.only_reads() {
        plant.touch();
    }
    match job {
        Job::Read(items) => variables::read(plant, items),
        Job::Write(items) => variables::write(plant, items),
        Job::SystemStatus { id, index } => control::status_list(plant, *id, *index),
        Job::Clock => Reply::Clock(plant.cpu.clock()),
        Job::SetClock(wanted) => control::set_clock(plant, *wanted),
        Job::BlockCounts => blocks::counts(plant, &around.stored),
        Job::BlockList(block_type) => blocks::list(plant, &around.stored, *block_type),
        Job::BlockInfo(name) => blocks::info(plant, &around.stored, *name),
        Job::Stop => control::stop(plant, by),
        Job::Start(restart) => control::start(plant, *restart, by),
        Job::CopyRamToRom => {
            plant.cpu.copy_ram_to_rom();
            Reply::Done
        }
        // Between two scans there are no gaps that could be closed.
        Job::Compress => Reply::Done,
        Job::MemoryReset => control::memory_reset(plant, by),
        Job::Upload(name) => blocks::upload(plant, &around.stored, *name),
        Job::Download(download) => blocks::download(plant, &mut around.stored, download),
        Job::Link(names) => linking::link(plant, around, names),
        Job::Delete(names) => linking::delete(plant, around, names),
    }
}
