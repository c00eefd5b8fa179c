//! Another CPU takes the place of the one that runs, while all who look at the run stay: another project is chosen.
//!
//! What is known of the run starts from the beginning with it: its program, what changed, its past, the status of its scans.

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
    desk.reset();
    facts.reset(next.facts);
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use sieben_cpu::{OperatingMode, Restart, Station};
    use sieben_engine::Interpreter;
    use sieben_model::address::Operand;

    use super::*;
    use crate::controller;
    use crate::gate::Gate;
    use crate::observed::Event;
    use crate::pace::{Pace, Speed};
    use crate::project::{Build, Overrides, Project};
    use crate::{Driver, End, Surroundings};

    fn build(name: &str) -> Build {
        let mut project = Project::new(None);
        project.add_settings(Path::new("sieben.toml"), format!("[project]\nname = \"{name}\"\n").as_bytes());
        project
            .add_source(Path::new("main.awl"), b"ORGANIZATION_BLOCK OB 1\nBEGIN\nL MW 10;\nL 1;\n+I;\nT MW 10;\nEND_ORGANIZATION_BLOCK\n");
        project.compile(Overrides::default(), false)
    }

    fn next(name: &str) -> Next {
        let build = build(name);
        let cpu = controller::load(&build, Interpreter::load, controller::settings(&build));
        Next { facts: Facts::of(&build, cpu.program()), cpu, cycle_us: 10_000 }
    }

    /// Another CPU comes before the twentieth scan; the run ends after twelve scans of that.
    struct Around<'r> {
        next: Option<Next>,
        desk: &'r Desk,
        facts: &'r CurrentFacts,
        scans: u64,
    }

    impl Surroundings for Around<'_> {
        fn exchange(&mut self, plant: &mut Plant) {
            if plant.scans >= 20
                && let Some(next) = self.next.take()
            {
                exchange(plant, next, (self.desk, self.facts), 0);
                self.scans = 0;
            }
        }
        fn after_scan(&mut self, plant: &mut Plant) {
            self.scans = plant.scans;
        }
        fn is_ended(&self) -> bool {
            self.next.is_none() && self.scans >= 12
        }
    }

    #[test]
    fn another_cpu_begins_anew_and_all_that_hold_the_run_stay() {
        let Next { cpu, facts, .. } = next("first");
        let request = cpu.stop_request();
        let mut plant = Plant::new(cpu, Pace::new(Speed::Max, 10_000, u64::MAX, 0));
        plant.stay_in_stop();
        let (gate, desk, facts) = (Gate::new(plant, Box::new(|| 0)), Desk::default(), CurrentFacts::new(facts));
        desk.past().keep();
        gate.enter(|plant| desk.observed.note(plant, "of the first")).expect("the gate is open");
        let mut around = Around { next: Some(next("second")), desk: &desk, facts: &facts, scans: 0 };
        assert_eq!(Driver::new(&gate, &desk, &mut around).run(Restart::Warm), End::Ended);
        let (scans, counted, mode) = gate
            .enter(|plant| (plant.scans, plant.cpu.read(&Operand::parse("MW 10").expect("an address")).ok(), plant.cpu.mode()))
            .expect("the gate is open");
        assert!((12..100).contains(&scans) && counted == Some(scans as u32), "{scans} {counted:?}");
        assert_eq!((mode, facts.facts().run, facts.facts().project.as_deref()), (OperatingMode::Run, 1, Some("second")));
        let (oldest, newest) = desk.past().range().expect("a past");
        assert_eq!((oldest.scan, newest.scan), (0, scans));
        let notes = desk.observed.newer_than(0).1;
        assert!(!notes.iter().any(|entry| entry.event == Event::Note("of the first".to_owned())), "{notes:?}");
        // Who could stop the first one stops this one.
        request.stop();
        let mut around = Around { next: None, desk: &desk, facts: &facts, scans: 0 };
        assert_eq!(Driver::new(&gate, &desk, &mut around).go_on(), End::Ended);
        assert_eq!(gate.enter(|plant| plant.cpu.mode()).expect("the gate is open"), OperatingMode::Stop);
    }
}
