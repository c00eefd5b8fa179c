//! What the CPU does about a job.

mod variables;

use sieben_cpu::Requester;
use sieben_workspace::gate::Plant;

use super::job::{Job, Reply};
use super::wire::codes::Refusal;

/// What the answers to all clients of a server need, and no CPU has.
#[derive(Debug, Default)]
pub struct Surroundings {}

/// Does a job at the cycle control point. It was looked at by [`super::guard`] before.
pub fn perform(job: &Job, plant: &mut Plant, around: &mut Surroundings, by: Requester) -> Reply {
    let _ = (around, by);
    match job {
        Job::Read(items) => variables::read(plant, items),
        Job::Write(items) => variables::write(plant, items),
        _ => Reply::Refused(Refusal::NotImplemented),
    }
}
