//! Modules and the rack they are plugged into.

mod recorded;

use std::any::Any;
use std::fmt;
use std::ops::Range;

use sieben_model::address::Width;
use sieben_model::cpu_type::CpuType;
use sieben_model::problems::Problem;

use crate::interrupts::Interrupt;
use crate::listening::{Heard, Listener, Order, Ordered, Orders, Unrepeatable};
use crate::tape::{Reading, Tape};
pub(crate) use recorded::Place;

/// An input or output module, real or simulated, at byte addresses of the peripheral area.
pub trait IoModule: Any + Send {
    /// What the user calls it.
    fn name(&self) -> &str;
    /// Input bytes it answers for; empty if it has none.
    fn inputs(&self) -> Range<u32>;
    /// Output bytes it answers for; empty if it has none.
    fn outputs(&self) -> Range<u32>;
    /// Reads input bytes, the first one `offset` bytes behind the start of [`Self::inputs`].
    fn read(&self, offset: u32, into: &mut [u8]);
    /// Takes output bytes, the first one `offset` bytes behind the start of [`Self::outputs`].
    fn write(&mut self, offset: u32, from: &[u8]);
    /// Time passes.
    fn advance(&mut self, dt_us: u64) {
        let _ = dt_us;
    }
    /// Whether it answers at all; one that has failed or was pulled does not.
    fn answers(&self) -> bool {
        true
    }
    /// Lets it fail, or answer again; `false` if it cannot be told so.
    fn set_answering(&mut self, answers: bool) -> bool {
        let _ = answers;
        false
    }
    /// Interrupts that the module has raised since it was asked last: hardware, diagnostic, exchange …
    fn alarms(&mut self) -> Vec<Interrupt> {
        Vec::new()
    }
    /// Sets the input bits of `mask` from outside, to stay until changed; `false` if the module has a process of its own.
    fn set_input(&mut self, offset: u32, mask: u8, value: u8) -> bool {
        let _ = (offset, mask, value);
        false
    }
    /// The module as it is now, with all that it does from here on; `None` if it cannot be copied, as one with real wires.
    fn copy(&self) -> Option<Box<dyn IoModule>> {
        None
    }
}

/// A module without a process behind it: its inputs are set from outside and stay until changed. What is put out is at [`Rack::outputs`].
#[derive(Clone, Debug)]
pub struct SimulatedModule {
    name: String,
    first: u32,
    inputs: Vec<u8>,
    failed: bool,
}

impl SimulatedModule {
    /// A module with as many input as output bytes at these addresses.
    pub fn new(name: impl Into<String>, addresses: Range<u32>) -> Self {
        Self { name: name.into(), first: addresses.start, inputs: vec![0; addresses.len()], failed: false }
    }
}

impl IoModule for SimulatedModule {
    fn name(&self) -> &str {
        &self.name
    }
    fn inputs(&self) -> Range<u32> {
        self.first..self.first + self.inputs.len() as u32
    }
    fn outputs(&self) -> Range<u32> {
        self.inputs()
    }
    fn read(&self, offset: u32, into: &mut [u8]) {
        let start = offset as usize;
        into.copy_from_slice(&self.inputs[start..start + into.len()]);
    }
    fn write(&mut self, _: u32, _: &[u8]) {}
    fn answers(&self) -> bool {
        !self.failed
    }
    fn set_answering(&mut self, answers: bool) -> bool {
        self.failed = !answers;
        true
    }
    fn set_input(&mut self, offset: u32, mask: u8, value: u8) -> bool {
        let byte = &mut self.inputs[offset as usize];
        *byte = *byte & !mask | value & mask;
        true
    }
    fn copy(&self) -> Option<Box<dyn IoModule>> {
        Some(Box::new(self.clone()))
    }
}

/// Why modules cannot be plugged in together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RackError {
    /// Two modules want the same byte.
    Overlap {
        /// The module that came first.
        first: String,
        /// The module that came later.
        second: String,
        /// `true` for an input byte.
        input: bool,
        /// The byte.
        byte: u32,
    },
    /// A module reaches beyond the peripheral area.
    Beyond {
        /// The module.
        module: String,
        /// One behind its last byte.
        end: u32,
        /// Bytes that the CPU type has.
        limit: u32,
    },
}

impl RackError {
    /// The problem code.
    pub fn problem(&self) -> Problem {
        match self {
            Self::Overlap { .. } => Problem::P8002,
            Self::Beyond { .. } => Problem::P8003,
        }
    }
}

impl fmt::Display for RackError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Overlap { first, second, input, byte } => {
                let area = if *input { "PIB" } else { "PQB" };
                write!(f, "the modules `{first}` and `{second}` both use `{area} {byte}`; every byte belongs to at most one module")
            }
            Self::Beyond { module, end, limit } => {
                write!(f, "the module `{module}` reaches to byte {}, the CPU type has bytes 0 to {}", end.saturating_sub(1), limit - 1)
            }
        }
    }
}

impl std::error::Error for RackError {}

/// Bytes next to each other that belong to one module.
#[derive(Clone, Debug)]
struct Run {
    module: usize,
    bytes: Range<usize>,
}

/// All modules of a CPU.
pub struct Rack {
    modules: Vec<Box<dyn IoModule>>,
    /// Which of them go on by themselves and may raise interrupts: all but simulated ones.
    lively: Vec<bool>,
    input_owner: Vec<Option<u16>>,
    output_owner: Vec<Option<u16>>,
    input_runs: Vec<Run>,
    output_runs: Vec<Run>,
    /// What the CPU has put out; modules see 0 while outputs are disabled.
    outputs: Vec<u8>,
    enabled: bool,
    /// Simulated modules, or what was put out, have changed by something else than an exchange of images.
    changed: bool,
    /// As the last exchange found it: all modules are simulated ones that answer, and nobody listens to them or records what they say.
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
    /// One simulated module at every address: what a program without a configuration runs with.
    pub fn simulated(cpu: &CpuType) -> Self {
        let background = SimulatedModule::new("simulated", 0..cpu.peripheral);
        let mut rack = Self::empty(cpu);
        rack.claim(Box::new(background));
        rack.finish()
    }

    /// These modules, and a simulated one at every address that they leave free.
    ///
    /// # Errors
    /// Two of them overlap, or one reaches beyond the peripheral area.
    pub fn with_background(cpu: &CpuType, modules: Vec<Box<dyn IoModule>>) -> Result<Self, RackError> {
        Self::check(cpu, &modules)?;
        let mut rack = Self::simulated(cpu);
        for module in modules {
            rack.claim(module);
        }
        Ok(rack.finish())
    }

    /// Only these modules; an access elsewhere is an I/O access error.
    ///
    /// # Errors
    /// Two of them overlap, or one reaches beyond the peripheral area.
    pub fn with_only(cpu: &CpuType, modules: Vec<Box<dyn IoModule>>) -> Result<Self, RackError> {
        Self::check(cpu, &modules)?;
        let mut rack = Self::empty(cpu);
        for module in modules {
            rack.claim(module);
        }
        Ok(rack.finish())
    }

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
            let module = &self.modules[usize::from(owner(&self.input_owner, at)?)];
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
            let answers = |at: u32| owner(&rack.output_owner, at).is_some_and(|module| rack.modules[usize::from(module)].answers());
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

    /// Forgets what the modules said before a snapshot.
    pub(crate) fn forget_before(&mut self, snapshot: &RackSnapshot) {
        self.tape.forget_before(snapshot.tape);
    }

    /// Bytes that the tape takes.
    pub(crate) fn tape_bytes(&self) -> usize {
        self.tape.bytes()
    }

    /// What was last put out at these bytes; `None` if no module answers for one of them.
    pub fn peripheral_output(&self, byte: u32, width: Width) -> Option<u32> {
        (0..width.bytes()).try_fold(0, |value, index| {
            let at = byte.checked_add(index)?;
            owner(&self.output_owner, at)?;
            Some(value << 8 | u32::from(self.outputs[at as usize]))
        })
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
        let Some(index) = owner(&self.input_owner, byte) else { return false };
        self.changed = true;
        let module = &mut self.modules[usize::from(index)];
        let offset = byte - module.inputs().start;
        module.set_input(offset, mask, value)
    }

    /// As [`Self::set_input`], at a time to come: whatever runs at that time or later sees it, what runs before does not.
    /// `false` if no module has the byte.
    pub fn set_input_at(&mut self, at_us: u64, byte: u32, mask: u8, value: u8) -> bool {
        let there = owner(&self.input_owner, byte).is_some();
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
        let mut inputs = vec![0; self.input_owner.len()];
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

    /// Whether nobody has to be told that no module has raised anything.
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
            let index = owner(&rack.input_owner, byte).or_else(|| owner(&rack.output_owner, byte));
            Reading::Could(index.is_some_and(|index| rack.modules[usize::from(index)].set_answering(answers)))
        });
        reading == Reading::Could(true)
    }

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
            debug_assert!(self.outputs[all.clone()] == image[all], "an output was written by somebody who was not expected");
        }
    }

    /// Both exchanges at once, where the image of the inputs is as it was read last; `false` and nothing done if they ask or tell somebody
    /// something.
    #[inline]
    pub(crate) fn exchange_quietly(&mut self, outputs: &[u8], written: Range<usize>, inputs: &[u8]) -> bool {
        if self.plain {
            self.note_outputs(outputs, written);
            debug_assert!(
                self.input_runs.iter().all(|run| {
                    let read = run.bytes.start.min(inputs.len())..run.bytes.end.min(inputs.len());
                    is_same(&*self.modules[run.module], run.bytes.start, &inputs[read])
                }),
                "an input was written by somebody who was not expected"
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
        // Who listens or records wants to know of all.
        let changed = changed || self.listener.is_some() || self.tape.is_on();
        for run in &self.input_runs {
            let bytes = run.bytes.start..run.bytes.end.min(length);
            let module = &self.modules[run.module];
            if let Some(listener) = self.listener.as_mut().filter(|_| run.bytes.end > length && module.answers()) {
                // What lies behind the image is heard at the same moment, if it can change by itself.
                let behind = run.bytes.start.max(length)..run.bytes.end;
                if self.lively[run.module] {
                    let mut values = vec![0; behind.len()];
                    module.read(behind.start as u32 - module.inputs().start, &mut values);
                    listener.bytes(self.now_us, behind.start, &values);
                }
            }
            let Some(target) = image.get_mut(bytes.clone()) else { continue };
            if module.answers() {
                if !changed && !self.lively[run.module] {
                    debug_assert!(is_same(&**module, run.bytes.start, target), "an input was written by somebody who was not expected");
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
        if let Some(index) = owner(&self.output_owner, byte)
            && self.enabled
        {
            let module = &mut self.modules[usize::from(index)];
            let offset = byte - module.outputs().start;
            module.write(offset, &[value]);
            collect(&mut self.alarms, &mut **module);
        }
    }

    fn empty(cpu: &CpuType) -> Self {
        let size = cpu.peripheral as usize;
        Self {
            modules: Vec::new(),
            lively: Vec::new(),
            input_owner: vec![None; size],
            output_owner: vec![None; size],
            input_runs: Vec::new(),
            output_runs: Vec::new(),
            outputs: vec![0; size],
            enabled: false,
            changed: true,
            plain: false,
            alarms: Vec::new(),
            alarmed: false,
            tape: Tape::default(),
            now_us: 0,
            orders: Orders::default(),
            listener: None,
        }
    }

    fn check(cpu: &CpuType, modules: &[Box<dyn IoModule>]) -> Result<(), RackError> {
        for (index, module) in modules.iter().enumerate() {
            for (input, range) in [(true, module.inputs()), (false, module.outputs())] {
                if range.is_empty() && range.start < cpu.peripheral {
                    continue;
                }
                if range.end > cpu.peripheral {
                    return Err(RackError::Beyond { module: module.name().into(), end: range.end, limit: cpu.peripheral });
                }
                for earlier in &modules[..index] {
                    let other = if input { earlier.inputs() } else { earlier.outputs() };
                    let byte = range.start.max(other.start);
                    if byte < range.end.min(other.end) {
                        return Err(RackError::Overlap { first: earlier.name().into(), second: module.name().into(), input, byte });
                    }
                }
            }
        }
        Ok(())
    }

    fn claim(&mut self, module: Box<dyn IoModule>) {
        // A checked rack has at most one module per byte, far below 2^16.
        let index = Some(self.modules.len() as u16);
        for byte in module.inputs() {
            self.input_owner[byte as usize] = index;
        }
        for byte in module.outputs() {
            self.output_owner[byte as usize] = index;
        }
        self.lively.push(!is_simulated(&*module));
        self.modules.push(module);
    }

    fn finish(mut self) -> Self {
        self.input_runs = runs(&self.input_owner);
        self.output_runs = runs(&self.output_owner);
        self
    }
}

/// What a rack is at one moment.
pub(crate) struct RackSnapshot {
    /// `None` if one of the modules cannot be copied.
    modules: Option<Vec<Box<dyn IoModule>>>,
    outputs: Vec<u8>,
    enabled: bool,
    alarms: Vec<Interrupt>,
    alarmed: bool,
    tape: u64,
    now_us: u64,
    orders: Orders,
}

impl fmt::Debug for RackSnapshot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RackSnapshot").field("has_modules", &self.has_modules()).finish_non_exhaustive()
    }
}

impl RackSnapshot {
    pub(crate) fn has_modules(&self) -> bool {
        self.modules.is_some()
    }

    /// An estimate of the memory that it takes.
    pub(crate) fn bytes(&self) -> usize {
        let addresses = |module: &dyn IoModule| module.inputs().len() + module.outputs().len();
        self.outputs.len() + self.modules.iter().flatten().map(|module| addresses(&**module)).sum::<usize>()
    }
}

impl Rack {
    pub(crate) fn snapshot(&self) -> RackSnapshot {
        let modules = self.modules.iter().map(|module| module.copy()).collect();
        RackSnapshot {
            modules,
            outputs: self.outputs.clone(),
            enabled: self.enabled,
            alarms: self.alarms.clone(),
            alarmed: self.alarmed,
            tape: self.tape.position(),
            now_us: self.now_us,
            orders: self.orders.clone(),
        }
    }

    /// If one module could not be copied, all stay as they are, and the tape says what they said.
    pub(crate) fn go_back_to(&mut self, snapshot: &RackSnapshot) {
        let copied = snapshot.modules.as_ref().and_then(|modules| modules.iter().map(|module| module.copy()).collect());
        match copied {
            Some(modules) => {
                self.modules = modules;
                self.alarms.clone_from(&snapshot.alarms);
                self.now_us = snapshot.now_us;
                self.orders.clone_from(&snapshot.orders);
            }
            None => self.tape.go_to(snapshot.tape),
        }
        self.changed = true;
        self.alarmed = snapshot.alarmed;
        self.outputs.clone_from(&snapshot.outputs);
        self.enabled = snapshot.enabled;
    }
}

/// Alarms that can wait for the CPU; a module that raises more in one moment is not believed.
const ALARMS_MAX: usize = 1024;

fn is_simulated(module: &dyn IoModule) -> bool {
    (module as &dyn Any).is::<SimulatedModule>()
}

fn is_same(module: &dyn IoModule, start: usize, image: &[u8]) -> bool {
    let mut values = vec![0; image.len()];
    module.read(start as u32 - module.inputs().start, &mut values);
    values == image
}

fn collect(alarms: &mut Vec<Interrupt>, module: &mut dyn IoModule) {
    alarms.extend(module.alarms());
    alarms.truncate(ALARMS_MAX);
}

fn owner(owners: &[Option<u16>], byte: u32) -> Option<u16> {
    owners.get(byte as usize).copied().flatten()
}

fn runs(owners: &[Option<u16>]) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for (byte, owner) in owners.iter().enumerate() {
        let Some(module) = owner.map(usize::from) else { continue };
        match runs.last_mut() {
            Some(run) if run.module == module && run.bytes.end == byte => run.bytes.end += 1,
            _ => runs.push(Run { module, bytes: byte..byte + 1 }),
        }
    }
    runs
}
