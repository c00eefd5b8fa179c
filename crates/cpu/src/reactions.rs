//! What the CPU answers when a running program asks: at a fault, a system function, peripheral access and a safe point.

use std::sync::atomic::Ordering;

use sieben_engine::{Fault, FaultPlace, Host, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::diagnostic_buffer::DiagnosticEntry;
use crate::host::{CpuHost, Slice};
use crate::interrupts::{Again, Request};
use crate::organization_blocks as ob;
use crate::start_information::StartInformation;
use crate::system;

impl Host for CpuHost<'_> {
    fn fault(&mut self, machine: &mut Machine, fault: &Fault, place: FaultPlace) -> Reaction {
        self.time.read(machine);
        if fault.lost().is_some() {
            let info = StartInformation::fault(fault, place, &self.class);
            self.failed_statements.add(info, place, self.scans);
            return Reaction::Continue;
        }
        if system::own_errors::keeps(&mut self.system.handlers, machine, fault, place) {
            return Reaction::Continue;
        }
        if let Some((filter, bit)) = system::filter_bit(fault) {
            let class = self.system.class(machine);
            if class.masked[filter] & bit != 0 {
                class.happened[filter] |= bit;
                return Reaction::Continue;
            }
        }
        let class = self.class(machine);
        let info = StartInformation::fault(fault, place, &class);
        let entry = self.enter(info, Some(place));
        if fault.is_noted() {
            self.failed_statements.add(info, place, self.scans);
            return Reaction::Continue;
        }
        self.first = Some(entry);
        if let Fault::Abort(abort) = *fault {
            return self.abort(class, info, ob::abort_stop_event(abort), place);
        }
        let nested = machine.frames.last().is_some_and(|frame| frame.in_error);
        if nested {
            let info = StartInformation { event: 0x3573, priority: 28, block: 88, ..info };
            if self.cpu_type.has_ob88 {
                self.enter(info, Some(place));
            }
            return self.abort(class, info, 0x4573, place);
        }
        let block = if matches!(fault, Fault::IoAccess { .. }) { ob::IO_ACCESS_ERROR } else { ob::PROGRAMMING_ERROR };
        if self.engine.has_block(block) {
            self.first = None;
            self.failed_statements.add(info, place, self.scans);
            self.system.interrupt(machine, info);
            Reaction::Enter { block, start_information: info.bytes(self.date_and_time()) }
        } else {
            Reaction::Stop(StopReason { event: ob::stop_event(block), place: Some(place) })
        }
    }

    fn peripheral_read(&mut self, _machine: &mut Machine, byte: u32, width: Width) -> Option<u32> {
        self.rack.read_for_program(byte, width)
    }

    fn peripheral_write(&mut self, machine: &mut Machine, byte: u32, width: Width, value: u32) -> bool {
        let written = self.rack.peripheral_write(byte, width, value);
        if written {
            if self.rack.has_alarms() {
                self.watchdog.ask_at_once(machine);
            }
            // A direct output shows in the process image too, or the next cycle control point would undo it.
            let bytes = value.to_be_bytes();
            let image = machine.memory.area_mut(Area::Output);
            let length = width.bytes() as usize;
            for (index, &new) in bytes[4 - length..].iter().enumerate() {
                if let Some(old) = image.get_mut(byte as usize + index) {
                    *old = new;
                }
            }
        }
        written
    }

    fn safe_point(&mut self, machine: &mut Machine, place: FaultPlace) -> Reaction {
        self.watchdog.settle(machine);
        self.time.read(machine);
        self.interrupts.run_times.end(machine.frames.len(), self.time.now_us);
        if self.requests.stop.swap(false, Ordering::Relaxed) {
            return Reaction::Stop(StopReason { event: 0x4303, place: None });
        }
        if self.testing {
            let enough = self.watchdog.expired(&self.time);
            if enough {
                self.watchdog.begin_again(self.time.now_us);
            }
            self.grant(machine);
            return if enough { Reaction::Suspend } else { Reaction::Continue };
        }
        let in_background = self.in_background(machine);
        if in_background {
            // OB 90 may take as long as it likes; what interrupts it may not.
            self.watchdog.begin_again(self.time.now_us);
        }
        if self.watchdog.expired(&self.time) {
            let elapsed = self.time.now_us.saturating_sub(self.watchdog.started_us);
            let info = StartInformation::cycle_time_exceeded(elapsed, &self.class(machine));
            if self.watchdog.startup || self.watchdog.exceeded || !self.interrupts.is_available(ob::TIME_ERROR.number) {
                let event = if self.watchdog.startup { 0x4555 } else { ob::stop_event(ob::TIME_ERROR) };
                self.first = Some(self.enter(info, Some(place)));
                return Reaction::Stop(StopReason { event, place: Some(place) });
            }
            self.watchdog.exceeded = true;
            self.restart_watchdog(machine);
            self.enter(info, Some(place));
            let active = self.class(machine);
            self.interrupts.request(info, &active, self.time.now_us);
        }
        while self.in_cycle()
            && let Some(event) = self.interrupts.take_scheduled(self.watchdog.total)
        {
            self.raise(machine, event.start_information());
        }
        self.gather(machine);
        // An interrupt of OB 90 stands above the next cycle and ends before it.
        let slice_over = in_background
            && match self.slice {
                Some(Slice::Points(points)) => self.watchdog.total >= points,
                Some(Slice::Until(until_us)) => self.time.now_us >= until_us || self.requests.visit.load(Ordering::Relaxed),
                None => false,
            };
        self.grant(machine);
        match self.pre_empt(machine) {
            Reaction::Continue if slice_over => {
                self.slice = None;
                Reaction::Suspend
            }
            Reaction::Continue if self.requests.hold.swap(false, Ordering::Relaxed) => Reaction::Suspend,
            reaction => reaction,
        }
    }

    fn written(&self, machine: &Machine, block: BlockId) -> Vec<std::ops::Range<usize>> {
        let mut written = self.written.clone();
        if let Some(bytes) = system::instance_bytes(block) {
            // All of its instance: what a system function block leaves as it is was written by the call.
            let start = (machine.registers.di_base + (machine.registers.ar2 & 0x00FF_FFFF) / 8) as usize;
            written.push(start..start + bytes as usize);
        }
        written
    }

    fn system_function(&mut self, machine: &mut Machine, block: BlockId, first_parameter: usize) -> Reaction {
        self.written.clear();
        self.images.changed();
        if !self.system.mocks.is_empty()
            && system::testing::system_function(&mut system::Call { machine, host: self, first: first_parameter }, block)
        {
            return Reaction::Continue;
        }
        let reaction = system::run(block, &mut system::Call { machine, host: self, first: first_parameter });
        match reaction {
            Some(Reaction::Continue) if self.testing => Reaction::Continue,
            Some(Reaction::Continue) => {
                self.gather(machine);
                self.pre_empt(machine)
            }
            Some(reaction) => reaction,
            // The engine asks `has_system_function` first.
            None => Reaction::Continue,
        }
    }

    fn has_system_function(&self, block: BlockId) -> bool {
        system::has(block)
    }
}

impl CpuHost<'_> {
    /// Whether OB 90 runs, and no interrupt on top of it.
    fn in_background(&self, machine: &Machine) -> bool {
        self.slice.is_some() && u16::from(self.class(machine).block) == ob::BACKGROUND.number
    }

    fn enter(&mut self, fields: StartInformation, place: Option<FaultPlace>) -> DiagnosticEntry {
        let entry = DiagnosticEntry { fields, time: self.date_and_time(), place };
        self.diagnostics.push(entry.clone());
        entry
    }

    /// Notes what happened since the last look: timed events, alarms of modules, a new time of day.
    fn gather(&mut self, machine: &Machine) {
        let active = self.class(machine);
        let now = self.now(machine);
        if std::mem::take(&mut self.clock_set) {
            self.interrupts.clock_set(0x3505, &now, Again::of(self.cpu_type), &active);
        }
        self.interrupts.gather(&now, machine, &active);
        for alarm in self.rack.take_alarms() {
            self.interrupts.raise(alarm.start_information(), &active, now.now_us);
        }
    }

    /// Starts the organization block that may run now, if there is one.
    fn pre_empt(&mut self, machine: &mut Machine) -> Reaction {
        if self.interrupts.is_idle() {
            return Reaction::Continue;
        }
        for info in self.interrupts.take_entries() {
            self.enter(info, None);
        }
        if let Some((event, info)) = self.interrupts.take_stop() {
            self.first = Some(DiagnosticEntry { fields: info, time: self.date_and_time(), place: None });
            return Reaction::Stop(StopReason { event, place: None });
        }
        if self.system.class(machine).delayed > 0 {
            return Reaction::Continue;
        }
        let class = self.class(machine);
        let Some(Request { info, raised_us }) = self.interrupts.take(class.rank()) else { return Reaction::Continue };
        self.interrupts.run_times.begin(u16::from(info.block), machine.frames.len(), raised_us, (self.time.now_us, self.time.source));
        self.system.interrupt(machine, info);
        Reaction::Enter { block: BlockId::ob(u16::from(info.block)), start_information: info.bytes(self.date_and_time()) }
    }

    /// Aborts the priority class: OB 88 where there is one, STOP otherwise.
    fn abort(&mut self, class: StartInformation, info: StartInformation, stop_event: u16, place: FaultPlace) -> Reaction {
        let event = if self.cpu_type.has_ob88 { 0x4570 } else { stop_event };
        if self.cpu_type.has_ob88 && !self.testing && class.rank() < 28 && self.engine.has_block(ob::PROCESSING_ABORT) {
            self.abort = Some(info);
        }
        Reaction::Stop(StopReason { event, place: Some(place) })
    }
}
