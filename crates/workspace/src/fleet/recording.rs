//! One controller of a fleet written down as a scenario, which steps, traces and tests take without the others.

use std::sync::PoisonError;

use sieben_sim::scenario::Scenario;
use sieben_sim::scenario::made::Parts;
use sieben_sim::scenario::recorder::{Recorder, Subject};

use super::Fleet;
use crate::places::Places;
use crate::tracing::channels;
use crate::tracing::scenario::origin;

impl Fleet {
    /// From now on what goes into a controller and what comes out of it is written down; before its first scan.
    pub fn record(&self, number: usize) {
        let Some(instance) = self.instances.get(number) else { return };
        let program = &self.programs[self.groups[self.group_of(number)].program];
        let build = &program.build;
        let mut instance = instance.lock().unwrap_or_else(PoisonError::into_inner);
        let scenario = Scenario::made(Parts { cycle_us: self.cycle_us, ..Parts::default() });
        let scenario = scenario.with_settings(program.settings.min_cycle, program.settings.image_errors);
        let (inputs, outputs) = channels::signals(build, &instance.cpu);
        let subject = Subject {
            program: origin(build).program,
            title: self.name_of(number),
            cpu: None,
            inputs,
            outputs,
            chosen: false,
            plants: !build.project.settings.modules.is_empty(),
            mnemonics: Places::new(build).mnemonics,
        };
        instance.recorder = Some(Box::new(Recorder::new(subject, &scenario)));
    }

    /// What was written down; nothing of a controller that was not asked for.
    ///
    /// # Errors
    /// The run could not be written down whole; the message says why.
    pub fn recording(&self, number: usize) -> Option<Result<String, String>> {
        let mut instance = self.instances.get(number)?.lock().unwrap_or_else(PoisonError::into_inner);
        let recorder = instance.recorder.take()?;
        Some(match recorder.trouble() {
            Some(trouble) => Err(trouble.to_owned()),
            None => Ok(recorder.finish()),
        })
    }
}
