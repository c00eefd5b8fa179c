//! A CPU as it is at one moment, to go back to: between two scans, or between two statements of a paused one.

use std::sync::Arc;

use sieben_engine::Machine;
use sieben_engine::machine::data_block_table::DataBlockTable;
use sieben_engine::machine::known_layout::KnownLayout;
use sieben_engine::machine::{Counter, Frame, Layout, Memory, Registers, Timer};

use super::Cpu;
use super::pause::Pause;
use super::stack::Stack;
use super::stop::Held;
use crate::cycle::Cycle;
use crate::diagnostic_buffer::DiagnosticBuffer;
use crate::failed_statements::FailedStatements;
use crate::forcing::Forced;
use crate::host::{Slice, Watchdog};
use crate::interrupts::Interrupts;
use crate::io::RackSnapshot;
use crate::loaded_blocks::LoadTimes;
use crate::mode::{OperatingMode, Restart, StopCause};
use crate::process_image::{Failures, Overrides};
use crate::settings::Settings;
use crate::start_information::StartInformation;
use crate::system_state;

/// Bytes of the arena that snapshots share as long as nobody writes one of them.
const PAGE: usize = 1024;

/// The state of a machine, with all that did not change since an earlier one shared with it.
#[derive(Clone, Debug)]
struct MachineImage {
    pages: Vec<Arc<[u8]>>,
    layout: Arc<Layout>,
    data_blocks: Arc<DataBlockTable>,
    timers: Arc<Vec<Timer>>,
    counters: Arc<Vec<Counter>>,
    registers: Registers,
    frames: Vec<Frame>,
    parameters: Vec<u32>,
    clock_us: u64,
    budget: i64,
}

fn share<T: Clone + PartialEq>(now: &T, before: Option<&Arc<T>>) -> Arc<T> {
    match before {
        Some(before) if **before == *now => Arc::clone(before),
        _ => Arc::new(now.clone()),
    }
}

impl MachineImage {
    fn of(machine: &Machine, before: Option<&Self>) -> Self {
        let page = |(index, bytes): (usize, &[u8])| match before.and_then(|before| before.pages.get(index)) {
            Some(page) if **page == *bytes => Arc::clone(page),
            _ => Arc::from(bytes),
        };
        Self {
            pages: machine.memory.arena.chunks(PAGE).enumerate().map(page).collect(),
            layout: Arc::clone(&machine.memory.layout),
            data_blocks: share(&machine.memory.data_blocks, before.map(|before| &before.data_blocks)),
            timers: share(&machine.timers, before.map(|before| &before.timers)),
            counters: share(&machine.counters, before.map(|before| &before.counters)),
            registers: machine.registers.clone(),
            frames: machine.frames.clone(),
            parameters: machine.parameters.clone(),
            clock_us: machine.clock_us,
            budget: machine.budget,
        }
    }

    fn machine(&self) -> Machine {
        Machine {
            registers: self.registers.clone(),
            memory: Memory {
                arena: self.pages.concat(),
                layout: Arc::clone(&self.layout),
                data_blocks: DataBlockTable::clone(&self.data_blocks),
                known_layout: KnownLayout::default(),
            },
            timers: self.timers.to_vec(),
            counters: self.counters.to_vec(),
            frames: self.frames.clone(),
            parameters: self.parameters.clone(),
            clock_us: self.clock_us,
            budget: self.budget,
        }
    }

    /// Whether a machine is this one, between two scans: registers are gone there, and lean machine code leaves others in them than the
    /// interpreter does.
    fn is_of(&self, machine: &Machine) -> bool {
        self.clock_us == machine.clock_us
            && *self.timers == machine.timers
            && *self.counters == machine.counters
            && *self.data_blocks == machine.memory.data_blocks
            && self.pages.len() == machine.memory.arena.chunks(PAGE).len()
            && self.pages.iter().zip(machine.memory.arena.chunks(PAGE)).all(|(page, bytes)| **page == *bytes)
    }

    /// Bytes that it does not share with `before`.
    fn own_bytes(&self, before: Option<&Self>) -> usize {
        let shared =
            |index: usize| before.and_then(|before| before.pages.get(index)).is_some_and(|page| Arc::ptr_eq(page, &self.pages[index]));
        let pages: usize = (0..self.pages.len()).filter(|&index| !shared(index)).map(|index| self.pages[index].len()).sum();
        let timers = before.is_none_or(|before| !Arc::ptr_eq(&before.timers, &self.timers));
        let counters = before.is_none_or(|before| !Arc::ptr_eq(&before.counters, &self.counters));
        pages
            + self.pages.len() * size_of::<Arc<[u8]>>()
            + if timers { self.timers.len() * size_of::<Timer>() } else { 0 }
            + if counters { self.counters.len() * size_of::<Counter>() } else { 0 }
            + self.frames.len() * size_of::<Frame>()
    }
}

/// Declares [`State`], and how it is taken from a CPU and given back.
macro_rules! state {
    ($($field:ident: $Type:ty,)*) => {
        /// All that changes in a CPU beside its machine and its modules.
        #[derive(Clone, Debug)]
        struct State { $($field: $Type,)* }

        impl State {
            fn of(cpu: &Cpu) -> Self {
                Self { $($field: cpu.$field.clone(),)* }
            }
            fn put(&self, cpu: &mut Cpu) {
                $(cpu.$field.clone_from(&self.$field);)*
            }
        }
    };
}

state! {
    settings: Settings,
    mode: OperatingMode,
    restart: Restart,
    cycle: Cycle,
    diagnostics: DiagnosticBuffer,
    failed_statements: FailedStatements,
    cause: Option<StopCause>,
    now_us: u64,
    rack_us: u64,
    watchdog: Watchdog,
    class: StartInformation,
    held: Option<Held>,
    pause: Option<Pause>,
    preset: Option<Registers>,
    registers: Registers,
    overrides: Overrides,
    forced: Forced,
    image_failures: Failures,
    system: system_state::State,
    interrupts: Interrupts,
    requested_us: Option<u64>,
    slice: Option<Slice>,
    paused: Option<Stack>,
    background_began: bool,
    interrupted: Option<Stack>,
    warm_demanded: bool,
    torn: bool,
    load_times: LoadTimes,
}

/// A CPU at one moment: everything but its program, what other threads ask of it and the last image of its retentive data.
#[derive(Debug)]
pub struct Snapshot {
    machine: MachineImage,
    state: State,
    rack: RackSnapshot,
    bytes: usize,
}

impl Snapshot {
    /// Bytes that it takes beside those that it shares with the snapshot it was made like; an estimate.
    pub fn bytes(&self) -> usize {
        self.bytes
    }

    /// Whether it holds copies of all modules, so that the run can go on from here in another way than it did.
    pub fn has_modules(&self) -> bool {
        self.rack.has_modules()
    }
}

impl Snapshot {
    pub(super) fn layout(&self) -> Arc<Layout> {
        Arc::clone(&self.machine.layout)
    }

    pub(super) fn settings(&self) -> &Settings {
        &self.state.settings
    }

    /// Whether a CPU is what the snapshot was taken of, as far as a program can see it.
    pub(super) fn is_of(&self, cpu: &Cpu) -> bool {
        self.state.mode == cpu.mode && self.machine.is_of(&cpu.machine)
    }

    /// Whether a CPU has the layout that the snapshot was made with.
    pub(super) fn fits(&self, cpu: &Cpu) -> bool {
        Arc::ptr_eq(&self.machine.layout, &cpu.machine.memory.layout) || *self.machine.layout == *cpu.machine.memory.layout
    }
}

/// What a program can see of a CPU at one moment: its machine and its mode.
#[derive(Debug)]
pub struct EndState {
    machine: MachineImage,
    mode: OperatingMode,
}

impl EndState {
    pub(super) fn of(cpu: &Cpu, like: &Snapshot) -> Self {
        Self { machine: MachineImage::of(&cpu.machine, Some(&like.machine)), mode: cpu.mode }
    }

    /// Whether a CPU is in this state.
    pub(super) fn is_of(&self, cpu: &Cpu) -> bool {
        self.mode == cpu.mode && self.machine.is_of(&cpu.machine)
    }
}

impl Cpu {
    /// What the CPU is at this moment. What did not change since the snapshot `like` is shared with it.
    ///
    /// A run that goes on from here ([`Self::go_back_to`]) in virtual time is the same run, statement by statement. Modules that can be copied
    /// ([`crate::IoModule::copy`]) go back too. If there is another one among them all stay as they are, and after [`Self::record_modules`]
    /// the CPU hears again what they said.
    pub fn snapshot(&self, like: Option<&Snapshot>) -> Snapshot {
        self.snapshot_like(like.map(|like| &like.machine))
    }

    /// As [`Self::snapshot`], with what did not change since an end state.
    pub(super) fn snapshot_after(&self, like: Option<&EndState>) -> Snapshot {
        self.snapshot_like(like.map(|like| &like.machine))
    }

    fn snapshot_like(&self, before: Option<&MachineImage>) -> Snapshot {
        let machine = MachineImage::of(&self.machine, before);
        let rack = self.rack.snapshot();
        let bytes = machine.own_bytes(before) + rack.bytes() + size_of::<Snapshot>();
        Snapshot { machine, state: State::of(self), rack, bytes }
    }

    /// From now on snapshots of this CPU can be gone back to whatever its modules are: what those that cannot be copied say is kept.
    pub fn record_modules(&mut self) {
        self.rack.record();
    }

    /// Nobody goes back further than to this snapshot.
    pub fn forget_before(&mut self, snapshot: &Snapshot) {
        self.rack.forget_before(&snapshot.rack);
    }

    /// Bytes that the words of the modules take that cannot be copied; an estimate.
    pub fn recorded_bytes(&self) -> usize {
        self.rack.tape_bytes()
    }

    /// The CPU is again what it was when the snapshot was taken. The program must be the same one.
    ///
    /// # Panics
    /// If the snapshot is one of another program.
    pub fn go_back_to(&mut self, snapshot: &Snapshot) {
        assert!(*self.machine.memory.layout == *snapshot.machine.layout, "a snapshot is taken back by the program that it was made with");
        self.machine = snapshot.machine.machine();
        self.images.changed();
        snapshot.state.put(self);
        self.rack.go_back_to(&snapshot.rack);
        self.keeper.forget();
    }
}
