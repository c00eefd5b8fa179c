//! One CPU: its state and what can be done with it.

mod access;
mod background;
mod bytes;
mod extension;
mod from_outside;
mod interrupting;
mod items;
mod loaded;
mod online_change;
mod pause;
mod replay;
mod restart;
mod retentive;
mod run;
mod scan;
mod snapshot;
mod stack;
mod stop;
mod testing;

use std::sync::Arc;

use sieben_engine::machine::Registers;
use sieben_engine::{Engine, Layout, Machine, Program};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;

use crate::clock::{BcdClock, DateAndTime};
use crate::communication::Communication;
use crate::cycle::{Cycle, CycleTimes};
use crate::diagnostic_buffer::DiagnosticBuffer;
use crate::failed_statements::FailedStatements;
use crate::forcing::Forced;
use crate::host::{Requests, Slice, Watchdog};
use crate::interrupts::Interrupts;
use crate::io::Rack;
use crate::loaded_blocks::LoadTimes;
use crate::mode::{OperatingMode, Restart, StopCause};
use crate::process_image::{Failures, Images, Overrides};
use crate::retain::{Declarations, Keeper};
use crate::settings::Settings;
use crate::start_information::StartInformation;
use crate::system_state;

pub use bytes::CpuBytes;
pub use loaded::Loaded;
pub use online_change::ChangeRefused;
pub use replay::{NotReplayed, RecordedScan, RecordedStep, Recording, Replayer, Step};
pub use retentive::DataLoss;
pub use scan::ScanReport;
pub use snapshot::{EndState, Snapshot};
use stack::Stack;
use stop::Held;
pub use stop::StopRequest;
pub use testing::TestStep;

/// Whether organization block `number` is loaded and the CPU type calls it.
fn available(cpu_type: &CpuType, engine: &dyn Engine, number: u16) -> bool {
    cpu_type.has_organization_block(number) && engine.has_block(BlockId::ob(number))
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
    failed_statements: FailedStatements,
    cause: Option<StopCause>,
    now_us: u64,
    bcd_clock: BcdClock,
    rack_us: u64,
    watchdog: Watchdog,
    class: StartInformation,
    held: Option<Held>,
    /// What a tracer has paused.
    pause: Option<pause::Pause>,
    preset: Option<Registers>,
    registers: Registers,
    requests: Arc<Requests>,
    overrides: Overrides,
    forced: Forced,
    images: Images,
    /// What the last cycle control point could not exchange.
    image_failures: Failures,
    system: system_state::State,
    interrupts: Interrupts,
    /// When the event came whose block starts next, in microseconds.
    requested_us: Option<u64>,
    /// How long OB 90 may run now.
    slice: Option<Slice>,
    /// OB 90, while the cycle runs.
    paused: Option<Stack>,
    /// OB 90 has begun since the start.
    background_began: bool,
    /// The cycle that a STOP interrupted: a hot restart goes on with it.
    interrupted: Option<Stack>,
    /// The program was loaded, or the memory reset: there is nothing that a hot restart could go on with.
    warm_demanded: bool,
    declarations: Arc<Declarations>,
    keeper: Keeper,
    /// A STOP from outside has ended the last cycle in the middle, or a hot restart is to end it.
    torn: bool,
    /// A test runs now.
    testing: bool,
    /// The test that waits for something.
    suspended_test: Option<Stack>,
    communication: Communication,
    load_times: LoadTimes,
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
        Self::new(Loaded::new(cpu_type, program, load), rack, settings)
    }

    /// A CPU in STOP with a program that others may run too.
    pub fn new(loaded: Loaded, rack: Rack, settings: Settings) -> Self {
        let Loaded { cpu_type, program, layout, engine, declarations, image_writes } = loaded;
        let machine = Machine::new(layout);
        let registers = machine.registers.clone();
        let load_times = LoadTimes::at(settings.date_and_time);
        let interrupts = Interrupts::new(|number| available(cpu_type, &*engine, number));
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
            failed_statements: FailedStatements::default(),
            cause: None,
            now_us: 0,
            bcd_clock: BcdClock::default(),
            rack_us: 0,
            watchdog: Watchdog::default(),
            class: StartInformation::default(),
            held: None,
            pause: None,
            preset: None,
            registers,
            requests: Arc::default(),
            overrides: Overrides::new(),
            forced: Forced::default(),
            images: Images::new(image_writes),
            image_failures: Failures::new(),
            system: system_state::State::default(),
            interrupts,
            requested_us: None,
            slice: None,
            paused: None,
            background_began: false,
            interrupted: None,
            warm_demanded: true,
            declarations,
            keeper: Keeper::default(),
            torn: false,
            testing: false,
            suspended_test: None,
            communication: Communication::default(),
            load_times,
        };
        cpu.load_data_blocks(|_| true);
        cpu
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

    /// The registers that OB 1 of the next scan begins with, to change: at first those of a fresh priority class. While the CPU is paused
    /// between two statements, those that the next statement finds.
    pub fn preset_registers_mut(&mut self) -> &mut Registers {
        if self.is_paused() {
            return &mut self.machine.registers;
        }
        self.preset.get_or_insert_with(Registers::fresh)
    }

    /// The registers after the last run of OB 1, before its end took effect; while the CPU is paused between two statements, those of this moment.
    pub fn registers(&self) -> &Registers {
        if self.is_paused() { &self.machine.registers } else { &self.registers }
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

    /// The statements that failed while the program went on.
    pub fn failed_statements(&self) -> &FailedStatements {
        &self.failed_statements
    }

    /// The time up to which the CPU has run, in microseconds of the clock that its scans are given.
    pub fn time_us(&self) -> u64 {
        self.now_us
    }

    /// The CPU's time of day.
    pub fn date_and_time(&self) -> DateAndTime {
        self.settings.date_and_time.plus_us(self.now_us)
    }
}
