//! STOP to RUN: what each kind of restart clears, and the startup organization block.

use std::sync::atomic::Ordering;

use sieben_engine::Tracer;
use sieben_model::address::Area;

use super::Cpu;
use super::pause::{Inner, Then};
use super::run::{Go, Outcome};
use super::stop::Held;
use crate::created_data_blocks;
use crate::cycle::Cycle;
use crate::host::Watchdog;
use crate::interrupts::CyclicInterrupt;
use crate::mode::{OperatingMode, Restart};
use crate::organization_blocks as ob;
use crate::start_information::StartInformation;

impl Cpu {
    /// Starts the CPU at the time of the last scan: STARTUP, then RUN or STOP.
    pub fn restart(&mut self, restart: Restart) -> OperatingMode {
        let now = self.now_us;
        self.restart_with(restart, &mut || now, None)
    }

    /// Starts the CPU with a clock (microseconds) and someone who watches statements.
    pub fn restart_with(&mut self, restart: Restart, clock: &mut dyn FnMut() -> u64, tracer: Option<&mut dyn Tracer>) -> OperatingMode {
        self.stop();
        self.advance(clock());
        // What was asked of the CPU before it started is fulfilled by its having been in STOP.
        self.requests.stop.store(false, Ordering::Relaxed);
        self.requests.hold.store(false, Ordering::Relaxed);
        self.restart = self.kind_of_start(restart);
        self.warm_demanded = false;
        if self.restart != Restart::Hot {
            self.interrupted = None;
        }
        // After a hot restart the rest of the interrupted cycle is still to come.
        self.torn = self.interrupted.is_some();
        self.background_began = false;
        self.clear();
        let stop_event = self.cause.take().map_or(0, |cause| cause.event);
        self.cycle = Cycle::default();
        self.class = StartInformation::startup(self.restart, stop_event, self.cpu_type.has_ob88);
        self.system.restart(self.machine.clock_us, self.restart == Restart::Hot, self.class);
        self.system.clock_memory_byte = self.settings.clock_memory_byte;
        self.interrupts.startup(self.restart == Restart::Hot);
        self.mode = OperatingMode::Startup;
        self.log(StartInformation { event: 0x4301, ..self.class }, None);
        self.watchdog = Watchdog::new(true, self.now_us, self.watchdog_us(), self.settings.virtual_safe_points);
        let block = ob::startup(self.restart);
        let outcome = if self.engine.has_block(block) {
            let entry = self.entry(block, None);
            self.run(Go::Enter(entry), clock, tracer)
        } else {
            Outcome::Finished
        };
        self.after_startup(outcome);
        self.mode
    }

    /// The restart that the CPU makes when it is asked for one.
    pub(super) fn kind_of_start(&self, asked: Restart) -> Restart {
        // Hot restart is a matter of the S7-400, as is OB 88.
        // It goes on with what was there: after loading and a memory reset there is nothing.
        let hot = self.cpu_type.has_ob88 && !self.warm_demanded;
        let restart = if asked == Restart::Hot && !hot { Restart::Warm } else { asked };
        let cold = self.cpu_type.starts_cold && self.cpu_type.accumulators == 4;
        if cold && restart == Restart::Warm && self.engine.has_block(ob::startup(Restart::Cold)) {
            return Restart::Cold;
        }
        restart
    }

    /// What a restart clears.
    pub(super) fn clear(&mut self) {
        self.machine.frames.clear();
        self.machine.parameters.clear();
        self.images.changed();
        if self.restart == Restart::Hot {
            return;
        }
        self.rack.clear_outputs();
        match self.restart {
            Restart::Cold => self.clear_work_memory(),
            _ => {
                let retain = &self.settings.retain;
                for area in [Area::Input, Area::Output] {
                    self.machine.memory.area_mut(area).fill(0);
                }
                retain.bit_memory.clear_others(self.machine.memory.area_mut(Area::BitMemory));
                retain.timers.clear_others(&mut self.machine.timers);
                retain.counters.clear_others(&mut self.machine.counters);
                self.load_data_blocks(|non_retain| non_retain);
                created_data_blocks::clear(&mut self.machine, &self.system.non_retain);
            }
        }
    }

    /// All memory as a program that was just loaded finds it; data blocks that the last one made are gone.
    pub(super) fn clear_work_memory(&mut self) {
        self.images.changed();
        for area in [Area::Input, Area::Output, Area::BitMemory] {
            self.machine.memory.area_mut(area).fill(0);
        }
        self.machine.timers.fill(Default::default());
        self.machine.counters.fill(Default::default());
        created_data_blocks::delete_created(&mut self.machine);
        self.system.non_retain.clear();
        self.load_data_blocks(|_| true);
    }

    /// Copies data blocks from load memory, those whose NON_RETAIN attribute `which` wants.
    pub(super) fn load_data_blocks(&mut self, which: impl Fn(bool) -> bool) {
        for (&number, block) in self.program.data.iter().filter(|(_, block)| which(block.non_retain)) {
            let Some(mut entry) = self.machine.memory.data_block(u64::from(number)) else { continue };
            if entry.read_only != block.read_only {
                entry.read_only = block.read_only;
                self.machine.memory.data_blocks[usize::from(number)] = Some(entry);
            }
            let start = entry.base as usize;
            // The program may have written the load memory (SFC 84).
            let image = self.system.load_memory.get(&number).unwrap_or(&block.image);
            let length = image.len().min(entry.length as usize);
            self.machine.memory.arena[start..start + length].copy_from_slice(&image[..length]);
        }
    }

    pub(super) fn after_startup(&mut self, outcome: Outcome) {
        match outcome {
            Outcome::Paused(rest) => drop(self.pause((rest, Inner::Block), Then::Startup)),
            Outcome::Finished => {
                self.log(StartInformation { event: 0x4302, ..self.class }, None);
                self.mode = OperatingMode::Run;
                self.rack.enable_outputs(true);
                let cyclic = self.all_cyclic();
                self.interrupts.run(cyclic.into_iter(), self.machine.clock_us);
            }
            Outcome::Suspended => self.hold(Held::Startup),
            Outcome::Stopped(reason, first) => self.enter_stop(reason, first),
        }
    }

    /// All cyclic interrupts that the CPU has.
    pub(super) fn all_cyclic(&self) -> Vec<(u16, CyclicInterrupt)> {
        (CyclicInterrupt::FIRST..=CyclicInterrupt::LAST).filter_map(|number| self.cyclic(number)).collect()
    }

    /// The number and the setting of a cyclic interrupt that the CPU has: the configured one, or the usual one of a block that is loaded.
    fn cyclic(&self, number: u16) -> Option<(u16, CyclicInterrupt)> {
        let configured = self.settings.cyclic.get(&number).copied().filter(|_| self.cpu_type.has_organization_block(number));
        let usual = || CyclicInterrupt::usual(number).filter(|_| self.interrupts.is_available(number));
        configured.or_else(usual).map(|setting| (number, setting))
    }
}
