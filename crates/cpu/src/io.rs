//! Modules and the rack they are plugged into.

mod images;
mod module;
mod plugging;
mod recorded;
mod simulated;
mod snapshot;

use std::any::Any;
use std::fmt;

use sieben_model::address::Width;

use crate::interrupts::Interrupt;
use crate::listening::{Heard, Listener, Order, Ordered, Orders, Unrepeatable};
use crate::tape::{Reading, Tape};
pub use module::IoModule;
pub use plugging::RackError;
use plugging::{Run, owner};
pub(crate) use recorded::Place;
pub use simulated::SimulatedModule;
pub(crate) use snapshot::RackSnapshot;

/// All modules of a CPU.
pub struct Rack {
    modules: Vec<Box<dyn IoModule>>,
    /// Which of them go on by themselves and may raise interrupts: all but simulated ones.
    lively: Vec<bool>,
    input_runs: Vec<Run>,
    output_runs: Vec<Run>,
    /// What the CPU has put out; modules see 0 while outputs are disabled.
    outputs: Vec<u8>,
    enabled: bool,
    /// Simulated modules, or what was put out, have changed by something else than an exchange of images.
    changed: bool,
    /// As the last exchange found it: all modules are simulated ones that answer, without a listener and without a recording of what they say.
    plain: bool,
    /// What modules raised and the CPU has not seen yet.
    alarms: Vec<Interrupt>,
    /// A module had raised an interrupt when it was written to last.
    alarmed: bool,
    tape: Tape,
    /// The time of the modules, in microseconds.
    now_us: u64,
    orders: Orders,
    listener: Option<Listener>,
}

impl fmt::Debug for Rack {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.modules.iter().map(|module| module.name())).finish()
    }
}

impl Rack {
    /// The first module of this type, to press its buttons and read its levels.
    pub fn module<M: IoModule>(&self) -> Option<&M> {
        self.modules.iter().find_map(|module| (&**module as &dyn Any).downcast_ref())
    }

    /// The first module of this type, to change.
    pub fn module_mut<M: IoModule>(&mut self) -> Option<&mut M> {
        self.changed = true;
        self.modules.iter_mut().find_map(|module| (&mut **module as &mut dyn Any).downcast_mut())
    }

    /// All modules of this type, to change, in the order they were plugged in.
    pub fn modules_mut<M: IoModule>(&mut self) -> impl Iterator<Item = &mut M> {
        self.changed = true;
        self.modules.iter_mut().filter_map(|module| (&mut **module as &mut dyn Any).downcast_mut())
    }

    /// All modules, in the order they were plugged in.
    pub fn modules(&self) -> impl Iterator<Item = &dyn IoModule> {
        self.modules.iter().map(|module| &**module)
    }

    /// Reads the module itself; `None` if no module answers for one of the bytes.
    pub fn peripheral_read(&self, byte: u32, width: Width) -> Option<u32> {
        let mut bytes = [0; 4];
        let length = width.bytes() as usize;
        for (index, into) in bytes[..length].iter_mut().enumerate() {
            let at = byte.checked_add(index as u32)?;
            let module = &self.modules[owner(&self.input_runs, at)?];
            if !module.answers() {
                return None;
            }
            module.read(at - module.inputs().start, std::slice::from_mut(into));
        }
        Some(bytes[..length].iter().fold(0, |value, &byte| value << 8 | u32::from(byte)))
    }

    /// As [`Self::peripheral_read`], for the program, which hears the same again when the run goes back.
    pub(crate) fn read_for_program(&mut self, byte: u32, width: Width) -> Option<u32> {
        let value = match self.ask(|rack| Reading::Value(rack.peripheral_read(byte, width))) {
            Reading::Value(value) => value,
            other => self.tape.unexpected(&other),
        };
        if let (Some(listener), Some(value)) = (&mut self.listener, value) {
            let length = width.bytes() as usize;
            listener.bytes(self.now_us, byte as usize, &value.to_be_bytes()[4 - length..]);
        }
        value
    }

    /// Writes the module itself; `false` and nothing written if no module answers for one of the bytes.
    pub fn peripheral_write(&mut self, byte: u32, width: Width, value: u32) -> bool {
        let length = width.bytes();
        let bytes = value.to_be_bytes();
        let bytes = &bytes[(4 - length) as usize..];
        let reading = self.ask(|rack| {
            let answers = |at: u32| owner(&rack.output_runs, at).is_some_and(|module| rack.modules[module].answers());
            let taken = (0..length).all(|index| byte.checked_add(index).is_some_and(answers));
            for (index, &value) in (0..length).zip(bytes.iter().filter(|_| taken)) {
                rack.put(byte + index, value);
            }
            Reading::Taken { taken, alarms: !rack.alarms.is_empty() }
        });
        let (taken, alarms) = match reading {
            Reading::Taken { taken, alarms } => (taken, alarms),
            other => self.tape.unexpected(&other),
        };
        self.alarmed = alarms;
        if let Some(listener) = self.listener.as_mut().filter(|_| alarms) {
            listener.alarm_inside(self.now_us);
        }
        if taken {
            self.outputs[byte as usize..(byte + length) as usize].copy_from_slice(bytes);
        }
        taken
    }

    /// Asks the modules, or the tape where the run has gone back.
    fn ask(&mut self, question: impl FnOnce(&mut Self) -> Reading) -> Reading {
        if let Some(reading) = self.tape.play() {
            return reading;
        }
        let reading = question(self);
        self.tape.record(&reading);
        reading
    }

    /// From now on the tape keeps what the modules say, unless all of them can be copied: those go back themselves.
    pub(crate) fn record(&mut self) {
        if self.modules.iter().any(|module| module.copy().is_none()) {
            self.changed = true;
            self.tape.start();
        }
    }

    /// Bytes that the tape takes.
    pub(crate) fn tape_bytes(&self) -> usize {
        self.tape.bytes()
    }

    /// What was last put out at these bytes; `None` if no module answers for one of them.
    pub fn peripheral_output(&self, byte: u32, width: Width) -> Option<u32> {
        (0..width.bytes()).try_fold(0, |value, index| {
            let at = byte.checked_add(index)?;
            owner(&self.output_runs, at)?;
            Some(value << 8 | u32::from(self.outputs[at as usize]))
        })
    }

    /// Bytes that modules with a life of their own take, and those of the rack with its simulated modules.
    pub(crate) fn bytes(&self) -> (usize, usize) {
        let of_runs = (self.input_runs.capacity() + self.output_runs.capacity()) * size_of::<Run>();
        let (mut plants, mut own) = (0, self.outputs.capacity() + of_runs);
        for (module, &lively) in self.modules.iter().zip(&self.lively) {
            let bytes = size_of_val(&**module) + module.inputs().len();
            if lively { plants += bytes } else { own += bytes }
        }
        (plants, own)
    }

    /// What was last put out, all bytes.
    pub fn outputs(&self) -> &[u8] {
        &self.outputs
    }

    /// Sets input bits of a simulated module; `false` if the byte belongs to no such module.
    pub fn set_input(&mut self, byte: u32, mask: u8, value: u8) -> bool {
        self.ask(|rack| Reading::Could(rack.put_input(byte, mask, value))) == Reading::Could(true)
    }

    fn put_input(&mut self, byte: u32, mask: u8, value: u8) -> bool {
        let Some(index) = owner(&self.input_runs, byte) else { return false };
        self.changed = true;
        let module = &mut self.modules[index];
        let offset = byte - module.inputs().start;
        module.set_input(offset, mask, value)
    }

    /// As [`Self::set_input`], at a time to come: whatever runs at that time or later sees it, what runs before does not.
    /// `false` if no module has the byte.
    pub fn set_input_at(&mut self, at_us: u64, byte: u32, mask: u8, value: u8) -> bool {
        let there = owner(&self.input_runs, byte).is_some();
        if there {
            self.orders.add(Order { at_us, what: Ordered::Input { byte, mask, value } });
        }
        there
    }

    /// An interrupt comes at this time, as if a module had raised it.
    pub fn raise_at(&mut self, at_us: u64, interrupt: Interrupt) {
        self.orders.add(Order { at_us, what: Ordered::Alarm(interrupt) });
    }

    #[inline]
    pub(crate) fn advance(&mut self, dt_us: u64) {
        if !self.tape.is_on() {
            return self.go_on(dt_us);
        }
        self.ask(|rack| {
            rack.go_on(dt_us);
            Reading::Done
        });
    }

    #[inline]
    fn go_on(&mut self, dt_us: u64) {
        let end_us = self.now_us.saturating_add(dt_us);
        while let Some(order) = self.orders.take_due(end_us) {
            self.pass_until(order.at_us);
            match order.what {
                Ordered::Input { byte, mask, value } => drop(self.put_input(byte, mask, value)),
                Ordered::Alarm(interrupt) => self.alarms.push(interrupt),
            }
        }
        self.pass_until(end_us);
    }

    #[inline]
    fn pass_until(&mut self, end_us: u64) {
        let dt_us = end_us.saturating_sub(self.now_us);
        self.now_us = self.now_us.max(end_us);
        if self.plain {
            return;
        }
        for (module, _) in self.modules.iter_mut().zip(&self.lively).filter(|&(_, &lively)| lively) {
            module.advance(dt_us);
            collect(&mut self.alarms, &mut **module);
        }
    }

    /// From now on it is noted what the modules say, beginning with all input bytes that are not 0.
    pub fn listen(&mut self) {
        let mut inputs = vec![0; self.outputs.len()];
        self.get_image(&mut inputs, true);
        let mut listener = Listener::new(inputs.len());
        listener.bytes(self.now_us, 0, &inputs);
        self.changed = true;
        self.listener = Some(listener);
    }

    /// Whether it is noted what the modules say.
    pub fn is_listening(&self) -> bool {
        self.listener.is_some()
    }

    /// What was new since it was asked last, oldest first; nothing if nobody listens.
    pub fn take_heard(&mut self) -> Vec<Heard> {
        self.listener.as_mut().map(Listener::take).unwrap_or_default()
    }

    /// When and why what was heard did not suffice to have the same run again.
    pub fn unrepeatable(&self) -> Option<(u64, Unrepeatable)> {
        self.listener.as_ref().and_then(Listener::unrepeatable)
    }

    /// Whether a module had raised an interrupt when it was written to last.
    pub(crate) fn has_alarms(&self) -> bool {
        self.alarmed
    }

    /// Whether no module has raised anything, and neither a listener nor the tape has to know that.
    pub(crate) fn is_quiet(&self) -> bool {
        self.alarms.is_empty() && self.listener.is_none() && !self.tape.is_on()
    }

    /// What the modules have raised since they were asked last.
    pub(crate) fn take_alarms(&mut self) -> Vec<Interrupt> {
        let alarms = match self.ask(|rack| Reading::Alarms(std::mem::take(&mut rack.alarms))) {
            Reading::Alarms(alarms) => alarms,
            other => self.tape.unexpected(&other),
        };
        if let Some(listener) = &mut self.listener {
            listener.alarms(self.now_us, &alarms);
        }
        alarms
    }

    /// Lets the module that answers for this input or output byte fail, or answer again; `false` if there is none that can.
    pub fn set_answering(&mut self, byte: u32, answers: bool) -> bool {
        self.changed = true;
        let reading = self.ask(|rack| {
            let index = owner(&rack.input_runs, byte).or_else(|| owner(&rack.output_runs, byte));
            Reading::Could(index.is_some_and(|index| rack.modules[index].set_answering(answers)))
        });
        reading == Reading::Could(true)
    }

    /// Forgets what was put out: modules see 0 until the program writes again.
    pub(crate) fn clear_outputs(&mut self) {
        self.changed = true;
        self.outputs.fill(0);
    }

    /// Releases the outputs (RUN) or holds them at 0 (STOP and STARTUP).
    pub(crate) fn enable_outputs(&mut self, enabled: bool) {
        self.enabled = enabled;
        self.ask(|rack| {
            for run in &rack.output_runs {
                let module = &mut rack.modules[run.module];
                let offset = run.bytes.start as u32 - module.outputs().start;
                if enabled {
                    module.write(offset, &rack.outputs[run.bytes.clone()]);
                } else {
                    module.write(offset, &vec![0; run.bytes.len()]);
                }
            }
            Reading::Done
        });
    }

    fn put(&mut self, byte: u32, value: u8) {
        if let Some(index) = owner(&self.output_runs, byte)
            && self.enabled
        {
            let module = &mut self.modules[index];
            let offset = byte - module.outputs().start;
            module.write(offset, &[value]);
            collect(&mut self.alarms, &mut **module);
        }
    }
}

/// Alarms that can wait for the CPU; a module that raises more in one moment is not believed.
const ALARMS_MAX: usize = 1024;

fn collect(alarms: &mut Vec<Interrupt>, module: &mut dyn IoModule) {
    alarms.extend(module.alarms());
    alarms.truncate(ALARMS_MAX);
}
