//! The run of one organization block, with what interrupts it, and with OB 88 if it is aborted.

use sieben_engine::machine::{Frame, Origin, Registers};
use sieben_engine::{Context, Entry, Exit, StopReason, Tracer};
use sieben_model::block::BlockId;

use super::Cpu;
use crate::clock::TimeSource;
use crate::diagnostic_buffer::DiagnosticEntry;
use crate::host::{CpuHost, Time};
use crate::organization_blocks as ob;

/// How the run of an organization block ended.
pub(super) enum Outcome {
    Finished,
    Suspended,
    /// By the tracer; [`Go::On`] goes on.
    Paused(Rest),
    Stopped(StopReason, Option<DiagnosticEntry>),
}

/// Where a run begins.
pub(super) enum Go {
    /// An organization block from its beginning.
    Enter(Entry),
    /// With a suspended one: what waits for it comes first.
    Resume,
    /// Where the tracer paused it, as if nothing had happened.
    On(Rest),
}

/// What a paused run knows beside the state of the CPU.
#[derive(Clone, Debug, Default)]
pub(super) struct Rest {
    /// Registers of the aborted block while OB 88 runs.
    saved: Option<Box<Registers>>,
    first: Option<DiagnosticEntry>,
    clock_set: bool,
}

impl Cpu {
    #[inline]
    pub(super) fn entry(&mut self, block: BlockId, registers: Option<Registers>) -> Entry {
        let time = self.bcd_clock.show(self.date_and_time());
        Entry { block, start_information: self.class.bytes_with(time), registers: registers.map(Box::new) }
    }

    /// Runs an organization block, or goes on with a suspended one; and OB 88 if the run was aborted.
    pub(super) fn run(&mut self, mut go: Go, clock: &mut dyn FnMut() -> u64, mut tracer: Option<&mut dyn Tracer>) -> Outcome {
        let (mut saved, mut first, mut clock_set) = (None, None, false);
        // Moved nowhere: what was just written in parts is slow to read as a whole.
        if let Go::On(rest) = &mut go {
            Rest { saved, first, clock_set } = std::mem::take(rest);
        }
        loop {
            let source = self.settings.time;
            let engine = &*self.engine;
            let mut host = CpuHost {
                cpu_type: self.cpu_type,
                engine,
                rack: &mut self.rack,
                diagnostics: &mut self.diagnostics,
                failed_statements: &mut self.failed_statements,
                scans: self.cycle.number,
                requests: &self.requests,
                time: Time { source, clock: &mut *clock, now_us: self.now_us, start: self.settings.date_and_time },
                watchdog: &mut self.watchdog,
                class: self.class,
                first: first.take(),
                abort: None,
                program: &self.program,
                system: &mut self.system,
                interrupts: &mut self.interrupts,
                clock_set: std::mem::take(&mut clock_set),
                slice: self.slice,
                testing: self.testing,
                images: &mut self.images,
                written: Vec::new(),
                communication: &self.communication,
                forces: self.forced.forces(),
            };
            if let Go::Enter(entry) = &go {
                host.system.begin(host.class);
                let requested_us = self.requested_us.take().unwrap_or(self.now_us);
                host.interrupts.run_times.begin(entry.block.number, 0, requested_us, (self.now_us, source));
                self.machine.frames.clear();
                self.machine.parameters.clear();
            }
            if !matches!(go, Go::On(_)) {
                host.begin(&mut self.machine);
            }
            let tracer: Option<&mut dyn Tracer> = match &mut tracer {
                Some(tracer) => Some(&mut **tracer),
                None => None,
            };
            let mut context = Context { machine: &mut self.machine, host: &mut host, tracer };
            let exit = match &go {
                Go::Enter(entry) => engine.run(&mut context, entry),
                Go::Resume => engine.resume(&mut context),
                Go::On(_) => engine.go_on(&mut context),
            };
            let (abort, stop, now_us, start) = (host.abort, host.first, host.time.now_us, host.time.start);
            let clock_set = host.clock_set;
            self.slice = host.slice;
            self.now_us = now_us;
            self.settings.date_and_time = start;
            if exit == Exit::Paused {
                return Outcome::Paused(Rest { saved, first: stop, clock_set });
            }
            self.watchdog.settle(&self.machine);
            let ended_us = match source {
                // The last safe point may be long ago.
                TimeSource::Real if self.interrupts.run_times.is_measured() => clock().max(self.now_us),
                TimeSource::Real | TimeSource::Virtual => self.now_us,
            };
            self.interrupts.run_times.end(self.machine.frames.len(), ended_us);
            if let (Exit::Stopped(_), Some(info)) = (&exit, abort) {
                if self.leave_class() {
                    self.interrupts.abort(info, self.now_us);
                    go = Go::Resume;
                } else {
                    saved.get_or_insert_with(|| Box::new(self.machine.registers.clone()));
                    self.class = info;
                    go = Go::Enter(self.entry(ob::PROCESSING_ABORT, None));
                }
                continue;
            }
            if let Some(registers) = saved.take().filter(|_| exit != Exit::Suspended) {
                // OB 88 has registers of its own; those of the aborted block are the ones to show.
                self.machine.registers = *registers;
            }
            return match exit {
                Exit::Suspended => Outcome::Suspended,
                Exit::Stopped(reason) => Outcome::Stopped(reason, stop),
                _ => Outcome::Finished,
            };
        }
    }

    #[inline]
    pub(super) fn watchdog_us(&self) -> u64 {
        u64::try_from(self.settings.watchdog.as_micros()).unwrap_or(u64::MAX)
    }

    /// Gives up the innermost priority class; the block that it interrupted is the one to go on. `false` if it interrupted none.
    fn leave_class(&mut self) -> bool {
        let frames = &mut self.machine.frames;
        let Some(index) = frames.iter().rposition(Frame::begins_class).filter(|&index| index > 0) else { return false };
        let Some(Frame { origin: Origin::Interrupt { registers, .. }, parameters, .. }) = frames.drain(index..).next() else {
            return false;
        };
        self.machine.parameters.truncate(parameters as usize);
        self.machine.registers = *registers;
        true
    }
}
