//! The exchange of the process images with the modules.

use std::ops::Range;

use super::{IoModule, Rack, collect};
use crate::tape::Reading;

impl Rack {
    /// Whether simulated modules, or what was put out, have changed by something else than an exchange of images; tells it once.
    #[inline]
    pub(crate) fn take_changed(&mut self) -> bool {
        let changed = std::mem::take(&mut self.changed);
        if changed {
            self.plain = !self.tape.is_on()
                && self.listener.is_none()
                && self.modules.iter().zip(&self.lively).all(|(module, &lively)| !lively && module.answers());
        }
        changed
    }

    /// Process image of the outputs → modules. Of the bytes of simulated modules only those that were `written` may be other ones than
    /// were put out last. Returns the bytes of the modules that do not answer.
    pub(crate) fn put_image(&mut self, image: &[u8], written: Range<usize>) -> Vec<Range<usize>> {
        self.note_outputs(image, written);
        if !self.tape.is_on() {
            return self.hand_out(image);
        }
        match self.ask(|rack| Reading::Failed(rack.hand_out(image))) {
            Reading::Failed(failed) => failed,
            other => self.tape.unexpected(&other),
        }
    }

    /// What modules are to put out, without asking them.
    #[inline]
    fn note_outputs(&mut self, image: &[u8], written: Range<usize>) {
        for run in &self.output_runs {
            let limits = if self.lively[run.module] { 0..image.len() } else { written.start..written.end.min(image.len()) };
            let bytes = run.bytes.start.max(limits.start)..run.bytes.end.min(limits.end);
            if let Some(source) = image.get(bytes.clone()) {
                self.outputs[bytes].copy_from_slice(source);
            }
            let all = run.bytes.start.min(image.len())..run.bytes.end.min(image.len());
            debug_assert!(self.outputs[all.clone()] == image[all], "an output was written from where it was not expected");
        }
    }

    /// Both exchanges at once, where the image of the inputs is as it was read last; `false` and nothing done if a module, a
    /// listener or the tape has to be asked or told.
    #[inline]
    pub(crate) fn exchange_quietly(&mut self, outputs: &[u8], written: Range<usize>, inputs: &[u8]) -> bool {
        if self.plain {
            self.note_outputs(outputs, written);
            debug_assert!(
                self.input_runs.iter().all(|run| {
                    let read = run.bytes.start.min(inputs.len())..run.bytes.end.min(inputs.len());
                    is_same(&*self.modules[run.module], run.bytes.start, &inputs[read])
                }),
                "an input was written from where it was not expected"
            );
        }
        self.plain
    }

    fn hand_out(&mut self, image: &[u8]) -> Vec<Range<usize>> {
        let mut failed = Vec::new();
        for run in &self.output_runs {
            let bytes = run.bytes.start..run.bytes.end.min(image.len());
            let Some(source) = image.get(bytes.clone()) else { continue };
            let module = &mut self.modules[run.module];
            if !module.answers() {
                failed.push(bytes);
            } else if self.enabled && self.lively[run.module] {
                let offset = bytes.start as u32 - module.outputs().start;
                module.write(offset, source);
                collect(&mut self.alarms, &mut **module);
            }
        }
        failed
    }

    /// Modules → process image of the inputs. Bytes without a module keep their value; those of a module that does not answer are 0
    /// and are returned. Those of simulated modules may stay as they are if neither the image nor these modules have `changed`.
    pub(crate) fn get_image(&mut self, image: &mut [u8], changed: bool) -> Vec<Range<usize>> {
        match self.tape.play() {
            Some(Reading::Image { bytes, failed }) => {
                let length = bytes.len().min(image.len());
                image[..length].copy_from_slice(&bytes[..length]);
                return failed;
            }
            Some(other) => return self.tape.unexpected(&other),
            None => {}
        }
        let length = image.len();
        let mut failed = Vec::new();
        // A listener and a tape have to know of all.
        let changed = changed || self.listener.is_some() || self.tape.is_on();
        for run in &self.input_runs {
            let bytes = run.bytes.start..run.bytes.end.min(length);
            let module = &self.modules[run.module];
            if let Some(listener) = self.listener.as_mut().filter(|_| run.bytes.end > length && module.answers()) {
                // What lies beyond the image is heard at the same moment, if it can change by itself.
                let beyond = run.bytes.start.max(length)..run.bytes.end;
                if self.lively[run.module] {
                    let mut values = vec![0; beyond.len()];
                    module.read(beyond.start as u32 - module.inputs().start, &mut values);
                    listener.bytes(self.now_us, beyond.start, &values);
                }
            }
            let Some(target) = image.get_mut(bytes.clone()) else { continue };
            if module.answers() {
                if !changed && !self.lively[run.module] {
                    debug_assert!(is_same(&**module, run.bytes.start, target), "an input was written from where it was not expected");
                    continue;
                }
                module.read(run.bytes.start as u32 - module.inputs().start, target);
                if let Some(listener) = &mut self.listener {
                    listener.bytes(self.now_us, bytes.start, target);
                }
            } else {
                target.fill(0);
                failed.push(bytes);
            }
        }
        if self.tape.is_on() {
            let bytes = self.tape.image(image);
            self.tape.record(&Reading::Image { bytes, failed: failed.clone() });
        }
        failed
    }
}

fn is_same(module: &dyn IoModule, start: usize, image: &[u8]) -> bool {
    let mut values = vec![0; image.len()];
    module.read(start as u32 - module.inputs().start, &mut values);
    values == image
}
