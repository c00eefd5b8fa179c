//! Another CPU takes the place of the one that runs, while all who look at the run stay: another project is chosen.
//!
//! What is known of the run begins anew with it: its program, what changed, its past, the status of its scans.

use sieben_cpu::Cpu;

use crate::control::{CurrentFacts, Facts};
use crate::gate::Plant;
use crate::status::Desk;

/// A CPU that has not started yet, and what is known of its program.
pub struct Next {
    /// The CPU.
    pub cpu: Cpu,
    /// What is known of its program.
    pub facts: Facts,
    /// From one scan to the next, in microseconds.
    pub cycle_us: u64,
}

/// Puts it there. To be called by the thread that scans, in [`exchange`](crate::driver::Surroundings::exchange); the CPU starts right after.
pub fn exchange(plant: &mut Plant, next: Next, (desk, facts): (&Desk, &CurrentFacts), real_us: u64) {
    plant.exchange(next.cpu, next.cycle_us, real_us);
    desk.begin_anew();
    facts.begin_anew(next.facts);
}
