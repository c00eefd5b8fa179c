//! One CPU: its state and what can be done with it.

use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Duration;

use sieben_engine::machine::Registers;
use sieben_engine::{Context, Engine, Entry, Exit, FaultPlace, Layout, Machine, Program, StopReason, Tracer};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::bcd;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;

use crate::clock::{DateAndTime, clock_memory};
use crate::cycle::{Cycle, CycleTimes};
use crate::diagnostic_buffer::{DiagnosticBuffer, DiagnosticEntry};
use crate::host::{CpuHost, Requests, Time, Watchdog};
use crate::io::Rack;
use crate::mode::{OperatingMode, Restart};
use crate::organization_blocks::{self as ob, StartInformation};
use crate::process_image::{self, Overrides};
use crate::station::{AccessError, Station, TimerReading};
use crate::system;

/// Where time comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TimeSource {
    /// The clock stands still inside a scan and the watchdog counts safe points: every run is the same.
    #[default]
    Virtual,
    /// The clock is asked inside a scan too, for the watchdog, for timers and for times of day.
    Real,
}

/// How a CPU is set up.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Greatest cycle time, in real time.
    pub watchdog: Duration,
    /// Where time comes from.
    pub time: TimeSource,
    /// Greatest number of safe points (backward jumps and block entries) in one cycle, in virtual time.
    pub virtual_safe_points: i64,
    /// The byte of bit memory that holds the clock memory.
    pub clock_memory_byte: Option<u16>,
    /// Time of day when the clock shows 0.
    pub date_and_time: DateAndTime,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            watchdog: Duration::from_millis(150),
            time: TimeSource::Virtual,
            virtual_safe_points: 10_000_000,
            clock_memory_byte: None,
            date_and_time: DateAndTime::DEFAULT,
        }
    }
}

/// Why the CPU is in STOP.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StopCause {
    /// The event of the STOP itself, such as 16#4562.
    pub event: u16,
    /// The first cause, such as 16#2528; the same as `event` if nothing came before.
    pub first_event: u16,
    /// The statement that caused it, counted from 0, if one did.
    pub place: Option<FaultPlace>,
    /// Cause, place and consequence in words.
    pub text: String,
}

/// What a scan did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScanReport {
    /// The cycle, counted from 1 since the last restart.
    pub number: u64,
    /// Whether the cycle ran; not in STOP and HOLD.
    pub executed: bool,
    /// The mode after the scan.
    pub mode: OperatingMode,
    /// How long the CPU worked, in microseconds; 0 in virtual time.
    pub execution_us: u64,
    /// Safe points that the program passed.
    pub safe_points: u64,
}

/// Sends a CPU to STOP (as its mode switch does) or HOLD from another thread; seen at the next safe point.
#[derive(Clone, Debug)]
pub struct StopRequest(Arc<Requests>);

impl StopRequest {
    /// Asks for STOP.
    pub fn stop(&self) {
        self.0.stop.store(true, Ordering::Relaxed);
    }
    /// Asks for HOLD.
    pub fn hold(&self) {
        self.0.hold.store(true, Ordering::Relaxed);
    }
}

/// What was suspended by HOLD.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Held {
    Startup,
    Cycle,
}

/// How the run of an organization block ended.
enum Outcome {
    Finished,
    Suspended,
    Stopped(StopReason, Option<DiagnosticEntry>),
}

/// A controller.
pub struct Cpu {
    cpu_type: &'static CpuType,
    program: Arc<Program>,
    engine: Arc<dyn Engine>,
    rack: Rack,
    settings: Settings,
    machine: Machine,
    mode: OperatingMode,
    restart: Restart,
    cycle: Cycle,
    diagnostics: DiagnosticBuffer,
    cause: Option<StopCause>,
    now_us: u64,
    rack_us: u64,
    watchdog: Watchdog,
    class: StartInformation,
    held: Option<Held>,
    preset: Option<Registers>,
    registers: Registers,
    requests: Arc<Requests>,
    overrides: Overrides,
    system: system::State,
}

impl Cpu {
    /// A CPU in STOP with a loaded program. `load` makes the engine for the program and the layout that it has on the CPU type.
    pub fn load(
        cpu_type: &'static CpuType,
        program: Arc<Program>,
        load: impl FnOnce(&Program, &Layout) -> Arc<dyn Engine>,
        rack: Rack,
        settings: Settings,
    ) -> Self {
        let layout = Arc::new(Layout::new(cpu_type, &program));
        let engine = load(&program, &layout);
        let machine = Machine::new(layout);
        let registers = machine.registers.clone();
        let mut cpu = Self {
            cpu_type,
            program,
            engine,
            rack,
            settings,
            machine,
            mode: OperatingMode::Stop,
            restart: Restart::Warm,
            cycle: Cycle::default(),
            diagnostics: DiagnosticBuffer::new(cpu_type.diagnostic_buffer),
            cause: None,
            now_us: 0,
            rack_us: 0,
            watchdog: Watchdog::default(),
            class: StartInformation::default(),
            held: None,
            preset: None,
            registers,
            requests: Arc::default(),
            overrides: Overrides::new(),
            system: system::State::default(),
        };
        cpu.load_data_blocks(|_| true);
        cpu
    }

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
        // Hot restart is a matter of the S7-400, as is OB 88.
        self.restart = if restart == Restart::Hot && !self.cpu_type.has_ob88 { Restart::Warm } else { restart };
        self.clear();
        let stop_event = self.cause.take().map_or(0, |cause| cause.event);
        self.cycle = Cycle::default();
        self.class = StartInformation::startup(self.restart, stop_event, self.cpu_type.has_ob88);
        self.system.restart(self.machine.clock_us, self.restart == Restart::Hot, self.class);
        self.mode = OperatingMode::Startup;
        self.log(StartInformation { event: 0x4301, ..self.class }, None);
        self.watchdog = Watchdog::new(true, self.now_us, self.watchdog_us(), self.settings.virtual_safe_points);
        let block = ob::startup(self.restart);
        let outcome = if self.engine.has_block(block) { self.run(Some(self.entry(block, None)), clock, tracer) } else { Outcome::Finished };
        self.after_startup(outcome);
        self.mode
    }

    /// One cycle at a point in time, in microseconds of a clock that began at 0; the clock stands still inside the scan.
    /// In STOP and HOLD only time passes.
    pub fn scan(&mut self, now_us: u64) -> ScanReport {
        self.scan_with(&mut || now_us, None)
    }

    /// As [`Self::scan`], with someone who is told of every statement.
    pub fn scan_traced(&mut self, now_us: u64, tracer: &mut dyn Tracer) -> ScanReport {
        self.scan_with(&mut || now_us, Some(tracer))
    }

    /// One cycle with a clock (microseconds), which is asked again inside the scan in real time.
    pub fn scan_with(&mut self, clock: &mut dyn FnMut() -> u64, tracer: Option<&mut dyn Tracer>) -> ScanReport {
        self.advance(clock());
        if self.mode == OperatingMode::Run && self.requests.stop.swap(false, Ordering::Relaxed) {
            self.stop();
        }
        if self.mode != OperatingMode::Run {
            return self.report(false, 0);
        }
        self.cycle.begin(self.now_us);
        self.cycle_control_point();
        self.watchdog = Watchdog::new(false, self.now_us, self.watchdog_us(), self.settings.virtual_safe_points);
        self.class = StartInformation::cycle(self.restart, self.cycle.number, &self.cycle.times);
        let registers = self.preset.take();
        let outcome = if self.engine.has_block(ob::CYCLE) {
            self.run(Some(self.entry(ob::CYCLE, registers)), clock, tracer)
        } else {
            Outcome::Finished
        };
        self.after_cycle(outcome, clock)
    }

    /// Goes on after HOLD; in other modes nothing happens.
    pub fn resume(&mut self, now_us: u64) -> ScanReport {
        self.resume_with(&mut || now_us, None)
    }

    /// As [`Self::resume`], with a clock and someone who watches statements.
    pub fn resume_with(&mut self, clock: &mut dyn FnMut() -> u64, tracer: Option<&mut dyn Tracer>) -> ScanReport {
        let held_at = self.now_us;
        self.advance(clock());
        let Some(held) = self.held.take() else { return self.report(false, 0) };
        // Neither timers nor the cycle time count in HOLD.
        self.watchdog.started_us = self.watchdog.started_us.saturating_add(self.now_us - held_at);
        self.log(StartInformation { event: 0x4306, ..self.class }, None);
        self.mode = if held == Held::Startup { OperatingMode::Startup } else { OperatingMode::Run };
        let outcome = self.run(None, clock, tracer);
        match held {
            Held::Startup => {
                self.after_startup(outcome);
                self.report(true, 0)
            }
            Held::Cycle => self.after_cycle(outcome, clock),
        }
    }

    /// Sends the CPU to STOP as its mode switch does.
    pub fn stop(&mut self) {
        self.stop_by(0x4303);
    }

    /// A handle that sends the CPU to STOP or HOLD from another thread.
    pub fn stop_request(&self) -> StopRequest {
        StopRequest(Arc::clone(&self.requests))
    }

    /// What the CPU is doing.
    pub fn mode(&self) -> OperatingMode {
        self.mode
    }

    /// Why it is in STOP; `None` in other modes and before the first start.
    pub fn stop_cause(&self) -> Option<&StopCause> {
        self.cause.as_ref()
    }

    /// The registers that OB 1 of the next scan begins with.
    pub fn preset_registers(&mut self, registers: Registers) {
        self.preset = Some(registers);
    }

    /// The registers that OB 1 of the next scan begins with, to change: at first those of a fresh priority class.
    pub fn preset_registers_mut(&mut self) -> &mut Registers {
        self.preset.get_or_insert_with(Registers::fresh)
    }

    /// The registers after the last run of OB 1, before its end took effect.
    pub fn registers(&self) -> &Registers {
        &self.registers
    }

    /// What the CPU is.
    pub fn cpu_type(&self) -> &'static CpuType {
        self.cpu_type
    }

    /// What is loaded.
    pub fn program(&self) -> &Arc<Program> {
        &self.program
    }

    /// All state that the program can touch.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// The modules.
    pub fn rack(&self) -> &Rack {
        &self.rack
    }

    /// The modules, to press their buttons.
    pub fn rack_mut(&mut self) -> &mut Rack {
        &mut self.rack
    }

    /// How long the cycle takes.
    pub fn cycle_times(&self) -> CycleTimes {
        self.cycle.times
    }

    /// The diagnostic buffer.
    pub fn diagnostic_buffer(&self) -> &DiagnosticBuffer {
        &self.diagnostics
    }

    /// The CPU's time of day.
    pub fn date_and_time(&self) -> DateAndTime {
        self.settings.date_and_time.plus_us(self.now_us)
    }

    /// Time passes: modules go on in every mode, the CPU clock in STARTUP and RUN.
    fn advance(&mut self, now_us: u64) {
        let now = now_us.max(self.now_us);
        if matches!(self.mode, OperatingMode::Startup | OperatingMode::Run) {
            self.machine.clock_us = self.machine.clock_us.saturating_add(now - self.now_us);
        }
        self.now_us = now;
        self.rack.advance(now - self.rack_us);
        self.rack_us = now;
    }

    fn cycle_control_point(&mut self) {
        process_image::exchange(&mut self.machine, &mut self.rack, &mut self.overrides);
        if let Some(byte) = self.settings.clock_memory_byte
            && let Some(byte) = self.machine.memory.area_mut(Area::BitMemory).get_mut(usize::from(byte))
        {
            *byte = clock_memory(self.machine.clock_us);
        }
    }

    /// What a restart clears.
    fn clear(&mut self) {
        self.machine.frames.clear();
        self.machine.parameters.clear();
        if self.restart == Restart::Hot {
            return;
        }
        for area in [Area::Input, Area::Output, Area::BitMemory] {
            self.machine.memory.area_mut(area).fill(0);
        }
        self.machine.timers.fill(Default::default());
        self.machine.counters.fill(Default::default());
        self.rack.clear_outputs();
        let cold = self.restart == Restart::Cold;
        self.load_data_blocks(|non_retain| cold || non_retain);
    }

    /// Copies data blocks from load memory, those whose NON_RETAIN attribute `which` wants.
    fn load_data_blocks(&mut self, which: impl Fn(bool) -> bool) {
        for (&number, block) in self.program.data.iter().filter(|(_, block)| which(block.non_retain)) {
            let Some(Some(entry)) = self.machine.memory.data_blocks.get_mut(usize::from(number)) else { continue };
            entry.read_only = block.read_only;
            let start = entry.base as usize;
            let length = block.image.len().min(entry.length as usize);
            self.machine.memory.arena[start..start + length].copy_from_slice(&block.image[..length]);
        }
    }

    fn entry(&self, block: BlockId, registers: Option<Registers>) -> Entry {
        Entry { block, start_information: self.class.bytes(self.date_and_time()), registers }
    }

    /// Runs an organization block, or goes on with a suspended one; and OB 88 if the run was aborted.
    fn run(&mut self, entry: Option<Entry>, clock: &mut dyn FnMut() -> u64, mut tracer: Option<&mut dyn Tracer>) -> Outcome {
        let engine = Arc::clone(&self.engine);
        let mut entry = entry;
        let mut resume = entry.is_none();
        let mut saved: Option<Registers> = None;
        loop {
            let source = self.settings.time;
            let mut host = CpuHost {
                cpu_type: self.cpu_type,
                engine: &*engine,
                rack: &mut self.rack,
                diagnostics: &mut self.diagnostics,
                requests: &self.requests,
                time: Time { source, clock: &mut *clock, now_us: self.now_us, start: self.settings.date_and_time },
                watchdog: &mut self.watchdog,
                class: self.class,
                first: None,
                abort: None,
                program: &self.program,
                system: &mut self.system,
            };
            if !resume {
                if let Some(entry) = &entry {
                    host.system.begin(entry.block.number);
                }
                self.machine.frames.clear();
                self.machine.parameters.clear();
            }
            host.watchdog.begin(source, &mut self.machine, &self.requests);
            let tracer: Option<&mut dyn Tracer> = match &mut tracer {
                Some(tracer) => Some(&mut **tracer),
                None => None,
            };
            let mut context = Context { machine: &mut self.machine, host: &mut host, tracer };
            let exit = match &entry {
                Some(entry) if !resume => engine.run(&mut context, entry),
                _ => engine.resume(&mut context),
            };
            let (abort, first, now_us, start) = (host.abort, host.first, host.time.now_us, host.time.start);
            self.watchdog.settle(&self.machine);
            self.now_us = now_us;
            self.settings.date_and_time = start;
            let registers = saved.get_or_insert_with(|| self.machine.registers.clone());
            match exit {
                Exit::Stopped(_) if abort.is_some() => {
                    self.class = abort.unwrap_or_default();
                    entry = Some(self.entry(ob::PROCESSING_ABORT, None));
                    resume = false;
                }
                Exit::Suspended => return Outcome::Suspended,
                exit => {
                    // OB 88 has registers of its own; those of the aborted block are the ones to show.
                    self.machine.registers = registers.clone();
                    return match exit {
                        Exit::Stopped(reason) => Outcome::Stopped(reason, first),
                        _ => Outcome::Finished,
                    };
                }
            }
        }
    }

    fn after_startup(&mut self, outcome: Outcome) {
        match outcome {
            Outcome::Finished => {
                self.log(StartInformation { event: 0x4302, ..self.class }, None);
                self.mode = OperatingMode::Run;
                self.rack.enable_outputs(true);
            }
            Outcome::Suspended => self.hold(Held::Startup),
            Outcome::Stopped(reason, first) => self.enter_stop(reason, first),
        }
    }

    fn after_cycle(&mut self, outcome: Outcome, clock: &mut dyn FnMut() -> u64) -> ScanReport {
        self.registers = self.machine.registers.clone();
        match outcome {
            Outcome::Finished => {}
            Outcome::Suspended => self.hold(Held::Cycle),
            Outcome::Stopped(reason, first) => self.enter_stop(reason, first),
        }
        let end = match self.settings.time {
            TimeSource::Virtual => self.now_us,
            TimeSource::Real => clock().max(self.now_us),
        };
        let execution = self.cycle.end(end);
        self.report(true, execution)
    }

    fn hold(&mut self, held: Held) {
        self.held = Some(held);
        self.mode = OperatingMode::Hold;
        self.log(StartInformation { event: 0x4305, ..self.class }, None);
    }

    fn stop_by(&mut self, event: u16) {
        match self.mode {
            OperatingMode::Stop => return,
            OperatingMode::Hold => {
                self.log(StartInformation { event: 0x430A, ..self.class }, None);
            }
            OperatingMode::Startup | OperatingMode::Run => {}
        }
        self.enter_stop(StopReason { event, place: None }, None);
    }

    fn enter_stop(&mut self, reason: StopReason, first: Option<DiagnosticEntry>) {
        let StopReason { event, place } = reason;
        let entry = self.log(StartInformation { event, ..self.class }, place);
        let first_event = first.as_ref().map_or(event, DiagnosticEntry::event);
        let text = match &first {
            Some(first) => format!("{}; {}", first.text(), crate::diagnostic_buffer::event_text(event)),
            None => entry.text(),
        };
        let place = place.or(first.and_then(|first| first.place));
        self.cause = Some(StopCause { event, first_event, place, text });
        self.mode = OperatingMode::Stop;
        self.held = None;
        self.machine.frames.clear();
        self.machine.parameters.clear();
        self.rack.enable_outputs(false);
    }

    fn log(&mut self, fields: StartInformation, place: Option<FaultPlace>) -> DiagnosticEntry {
        let entry = DiagnosticEntry { fields, time: self.date_and_time(), place };
        self.diagnostics.push(entry.clone());
        entry
    }

    fn report(&self, executed: bool, execution_us: u64) -> ScanReport {
        let safe_points = if executed { self.watchdog.total } else { 0 };
        ScanReport { number: self.cycle.number, executed, mode: self.mode, execution_us, safe_points }
    }

    fn watchdog_us(&self) -> u64 {
        u64::try_from(self.settings.watchdog.as_micros()).unwrap_or(u64::MAX)
    }

    /// Sets an input: in its module if that is simulated, else in the process image of the next scan.
    fn modify_input(&mut self, address: &Address, value: u32) -> Result<(), AccessError> {
        let length = address.width.bytes();
        let limit = match address.area {
            Area::Input => self.machine.memory.layout.inputs.len() as u32,
            _ => self.cpu_type.peripheral,
        };
        if address.byte.checked_add(length).is_none_or(|end| end > limit) {
            return Err(AccessError::Outside);
        }
        let (masks, values) = if address.width == Width::Bit {
            ([0, 0, 0, 1 << (address.bit & 7)], [0, 0, 0, ((value & 1) << (address.bit & 7)) as u8])
        } else {
            ([0xFF; 4], value.to_be_bytes())
        };
        for index in 0..length {
            let at = (4 - length + index) as usize;
            let byte = address.byte + index;
            if self.rack.set_input(byte, masks[at], values[at]) {
                continue;
            }
            if address.area == Area::PeripheralInput {
                return Err(AccessError::NoModule);
            }
            let (mask, old) = self.overrides.entry(byte).or_default();
            *mask |= masks[at];
            *old = *old & !masks[at] | values[at];
        }
        Ok(())
    }

    /// Sets a peripheral output and, as `T PQW` does, the process image, or the next cycle control point would undo it.
    fn modify_output(&mut self, address: &Address, value: u32) -> Result<(), AccessError> {
        let (width, value) = if address.width == Width::Bit {
            let old = self.rack.peripheral_output(address.byte, Width::Byte).ok_or(AccessError::NoModule)?;
            (Width::Byte, old & !(1 << address.bit) | (value & 1) << address.bit)
        } else {
            (address.width, value)
        };
        if !self.rack.peripheral_write(address.byte, width, value) {
            return Err(AccessError::NoModule);
        }
        self.machine.memory.write(&Operand::Address(Address { area: Area::Output, width, byte: address.byte, bit: 0 }), value);
        Ok(())
    }
}

/// A bit number above 7 is no address.
fn check_bit(operand: &Operand) -> Result<(), AccessError> {
    match operand {
        Operand::Address(address) | Operand::InDataBlock { address, .. } if address.bit > 7 => Err(AccessError::Outside),
        _ => Ok(()),
    }
}

impl Station for Cpu {
    fn cpu_type(&self) -> &'static CpuType {
        self.cpu_type
    }

    fn mode(&self) -> OperatingMode {
        self.mode
    }

    fn read(&self, operand: &Operand) -> Result<u32, AccessError> {
        check_bit(operand)?;
        match operand {
            Operand::Address(Address { area: Area::PeripheralInput, byte, width, bit }) => {
                let value = self.rack.peripheral_read(*byte, *width).ok_or(AccessError::NoModule)?;
                Ok(if *width == Width::Bit { value >> (bit & 7) & 1 } else { value })
            }
            Operand::Address(Address { area: Area::PeripheralOutput, byte, width, bit }) => {
                let value = self.rack.peripheral_output(*byte, *width).ok_or(AccessError::NoModule)?;
                Ok(if *width == Width::Bit { value >> (bit & 7) & 1 } else { value })
            }
            Operand::Timer(number) => self.timer(*number).map(|timer| u32::from(timer.value)).ok_or(AccessError::Outside),
            Operand::Counter(number) => {
                self.machine.counters.get(usize::from(*number)).map(|counter| u32::from(counter.count)).ok_or(AccessError::Outside)
            }
            _ => self.machine.memory.read(operand).ok_or_else(|| self.why_not(operand)),
        }
    }

    fn modify(&mut self, operand: &Operand, value: u32) -> Result<(), AccessError> {
        check_bit(operand)?;
        match operand {
            Operand::Address(address @ Address { area: Area::Input | Area::PeripheralInput, .. }) => self.modify_input(address, value),
            Operand::Address(address @ Address { area: Area::PeripheralOutput, .. }) => self.modify_output(address, value),
            Operand::Timer(number) => {
                let now = self.machine.clock_us;
                let timer = self.machine.timers.get_mut(usize::from(*number)).ok_or(AccessError::Outside)?;
                let word = u16::try_from(value).map_err(|_| AccessError::Value)?;
                if !bcd::is_decimal(u32::from(word), 3) {
                    return Err(AccessError::Value);
                }
                timer.refresh(now);
                timer.base = (word >> 12 & 3) as u8;
                timer.value = bcd::decode(u32::from(word), 3) as u16;
                timer.started_us = now;
                timer.refresh(now);
                Ok(())
            }
            Operand::Counter(number) => {
                let counter = self.machine.counters.get_mut(usize::from(*number)).ok_or(AccessError::Outside)?;
                counter.count = u16::try_from(value).ok().filter(|&count| count <= 999).ok_or(AccessError::Value)?;
                Ok(())
            }
            _ if self.machine.memory.write(operand, value) => Ok(()),
            _ => Err(self.why_not(operand)),
        }
    }

    fn timer(&self, number: u16) -> Option<TimerReading> {
        let mut timer = self.machine.timers.get(usize::from(number))?.clone();
        let now = self.machine.clock_us;
        timer.refresh(now);
        Some(TimerReading { status: timer.status, value: timer.remaining(now), base: timer.base, running: timer.running })
    }

    fn diagnostic_buffer(&self) -> &DiagnosticBuffer {
        &self.diagnostics
    }

    fn stop_cause(&self) -> Option<&StopCause> {
        self.cause.as_ref()
    }

    fn cycle_times(&self) -> CycleTimes {
        self.cycle.times
    }

    fn stop(&mut self) {
        self.stop_by(0x4304);
    }

    fn restart(&mut self, restart: Restart) -> OperatingMode {
        Self::restart(self, restart)
    }
}

impl Cpu {
    /// Why an operand of the data memory has no value.
    fn why_not(&self, operand: &Operand) -> AccessError {
        match operand {
            Operand::InDataBlock { db, .. } if self.machine.memory.data_block(u64::from(*db)).is_none() => AccessError::NotLoaded,
            Operand::InDataBlock { .. } => AccessError::Outside,
            Operand::Address(address) if self.machine.memory.layout.area(address.area).is_some() => AccessError::Outside,
            _ => AccessError::NotAccessible,
        }
    }
}
