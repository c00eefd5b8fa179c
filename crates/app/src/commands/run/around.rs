//! What stands around a run while it goes on: retentive data, changed sources, another example, and what is said of it.

use std::sync::Arc;

use sieben_cpu::{Cpu, OperatingMode};
use sieben_model::visible::visible;
use sieben_workspace::control::{CurrentFacts, Facts, watched};
use sieben_workspace::exchange::exchange;
use sieben_workspace::failed::Failed;
use sieben_workspace::observed::Observer;
use sieben_workspace::project::Build;
use sieben_workspace::status::Desk;
use sieben_workspace::{Plant, Surroundings, controller};

use super::{Ending, Shown};
use crate::chosen::{Change, Chosen};
use crate::retain::Retention;
use crate::watch::Watch;
use crate::{output, screen};

/// What stands around the run: retentive data, changed sources, what is said and printed, Ctrl-C.
pub(super) struct Around<'a> {
    pub(super) retention: Option<Retention>,
    pub(super) watch: Option<Watch>,
    /// The program that runs.
    pub(super) build: &'a mut Build,
    /// What those who come in from outside know of it.
    pub(super) facts: &'a CurrentFacts,
    /// Which project runs; the page may change it.
    pub(super) chosen: &'a Chosen,
    /// Nothing is said about online changes: the result is for a program.
    pub(super) quiet: bool,
    /// The STOP that the CPU is in was said already, or is said at the end.
    pub(super) told_stop: bool,
    /// No STOP ends the run.
    pub(super) stays: bool,
    /// The first statement that failed, with its place in the program that ran then.
    pub(super) failed: Option<Failed>,
    pub(super) say: Say<'a>,
    /// Finds what changed, where that is printed.
    pub(super) changes: Option<Observer>,
    pub(super) ending: &'a Ending,
    /// What is printed cannot be printed any more.
    pub(super) is_broken: bool,
}

/// Says what happens while a run goes on: on the screen it is a note.
#[derive(Clone, Copy)]
pub(super) struct Say<'a> {
    pub(super) desk: &'a Desk,
    pub(super) shown: Shown,
}

impl Say<'_> {
    /// Says something; it may have colours.
    fn say(&self, plant: &Plant, text: &str) {
        match self.shown {
            Shown::Screen => {
                text.lines().filter(|line| !line.trim().is_empty()).for_each(|line| self.desk.observed.note(plant, line.trim_end()));
            }
            Shown::Changes | Shown::Messages => output::styled(text),
        }
    }
}

impl Surroundings for Around<'_> {
    /// Another example takes the place of the project, if the page wants that.
    fn exchange(&mut self, plant: &mut Plant) {
        let Some(Change { example, build, next }) = self.chosen.take() else { return };
        // Its retentive data is kept; that of the examples after it is in memory only.
        if let Some(mut retention) = self.retention.take() {
            retention.close(&mut plant.cpu);
        }
        *self.build = build;
        (self.failed, self.told_stop) = (None, !self.stays);
        exchange(plant, next, (self.say.desk, self.facts), self.ending.gate.now_us());
        plant.cpu.measure_blocks();
        if let Some(changes) = &mut self.changes {
            *changes = Observer::new(watched(&self.facts.facts()));
        }
        if !self.quiet {
            self.say.say(plant, &format!("The example `{}` runs now.\n", example.name));
        }
        self.chosen.took(example);
    }

    /// Keeps retentive data before the next scan releases the outputs of this one.
    fn keep(&mut self, cpu: &mut Cpu) {
        if let Some(retention) = &mut self.retention {
            retention.keep(cpu);
        }
    }

    /// Lets changed sources take over before the next scan.
    fn at_point(&mut self, plant: &mut Plant) {
        self.tell_stop(plant);
        if let Some(watch) = &mut self.watch {
            // Its place is one of the program that still runs.
            if self.failed.is_none() {
                self.failed = Failed::of(self.build, &plant.cpu);
            }
            let changes = watch.changes;
            let mut said = Vec::new();
            watch.poll(&mut plant.cpu, self.build, &mut |text| said.push(text.to_owned()));
            if !self.quiet {
                said.iter().for_each(|text| self.say.say(plant, text));
            }
            if watch.changes != changes {
                self.replace_facts(&plant.cpu);
            }
        }
        // A server may have linked or deleted data blocks.
        if !Arc::ptr_eq(plant.cpu.program(), &self.facts.facts().program) {
            self.replace_facts(&plant.cpu);
        }
    }

    fn before_scan(&mut self, plant: &mut Plant) {
        // The first look is at what was before the first scan.
        if plant.scans == 0
            && let Some(changes) = &mut self.changes
        {
            changes.observe(&plant.cpu, 0, &mut |_| {});
        }
    }

    fn after_scan(&mut self, plant: &mut Plant) {
        if let Some(changes) = &mut self.changes {
            let lines = screen::changed(changes, plant, plant.cpu.time_us());
            self.is_broken |= lines.iter().any(|line| output::print(line).is_err());
        }
    }

    fn is_ended(&self) -> bool {
        self.ending.is_wanted() || self.is_broken
    }
}

impl Around<'_> {
    /// Another program runs from now on.
    fn replace_facts(&mut self, cpu: &Cpu) {
        self.facts.replace(Facts::of(self.build, cpu.program()));
        if let Some(changes) = &mut self.changes {
            *changes = Observer::new(watched(&self.facts.facts()));
        }
    }

    /// Says once why the CPU is in STOP, where the run goes on all the same.
    fn tell_stop(&mut self, plant: &Plant) {
        let cpu = &plant.cpu;
        let cause = cpu.stop_cause().filter(|_| cpu.mode() == OperatingMode::Stop);
        match cause {
            Some(cause) if !self.told_stop => {
                self.told_stop = true;
                if !self.quiet {
                    self.say.say(plant, &visible(&controller::stop_text(self.build, cause)));
                }
            }
            None if self.stays => self.told_stop = false,
            _ => {}
        }
    }
}
