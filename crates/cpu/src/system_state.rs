//! What system functions remember from call to call.

use std::collections::{BTreeMap, BTreeSet};

use sieben_engine::machine::Origin;
use sieben_engine::{FaultPlace, Machine};
use sieben_model::address::Width;
use sieben_model::block::BlockId;
use sieben_model::extension::FailedAssertion;

use crate::start_information::StartInformation;

/// What a priority class has set; its end forgets it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Class {
    /// Masked programming and access errors (SFC 36).
    pub(crate) masked: [u32; 2],
    /// Masked errors that happened (SFC 38).
    pub(crate) happened: [u32; 2],
    /// How often interrupts were delayed (SFC 41).
    pub(crate) delayed: u16,
}

/// What a run-time meter counts.
pub(crate) const HOUR_US: u64 = 3_600_000_000;

/// A run-time meter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Meter {
    /// What it shows, in microseconds, when it was set or stopped.
    pub(crate) shown_us: u64,
    /// CPU clock when it was started, while it runs.
    pub(crate) since_us: Option<u64>,
}

/// A block that runs and handles its errors itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Handler {
    /// How many frames there are with its own.
    pub(crate) depth: usize,
    pub(crate) block: BlockId,
    /// The first error since it began or was asked.
    pub(crate) first: Option<OwnError>,
}

/// An error and the statement that had it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct OwnError {
    pub(crate) event: u16,
    pub(crate) reaction: u8,
    pub(crate) place: FaultPlace,
}

/// Values that a word of a test may have.
pub(crate) const VALUES: usize = 3;

/// What a test asks for; the run of the test is suspended until it is done.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Asked {
    /// The row of the plan.
    pub row: u32,
    /// Its values: eight bytes behind each pointer, as many of them as the type has count.
    pub values: [[u8; 8]; VALUES],
    /// Its texts, if it is about texts.
    pub texts: Option<[Vec<u8>; 2]>,
}

/// A block whose calls a test replaces or counts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Mock {
    pub(crate) block: BlockId,
    /// The instance: data block and first byte; `None` for a function.
    pub(crate) instance: Option<(u16, u32)>,
    /// Where the result of a function goes: the index of the parameter, its width, its value.
    pub(crate) result: Option<(usize, Width, u64)>,
    /// How often it was called.
    pub(crate) calls: u64,
}

/// What belongs to the blocks that run.
#[derive(Clone, Debug)]
pub(crate) struct Running {
    classes: BTreeMap<u16, Class>,
    interrupts: Vec<(usize, StartInformation)>,
    handlers: Vec<Handler>,
}

/// The memory of the system functions of a CPU.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct State {
    /// Run-time meters.
    pub(crate) meters: [Meter; 8],
    /// Priority classes by the number of their organization block.
    classes: BTreeMap<u16, Class>,
    /// Start information of the last startup.
    pub(crate) startup: StartInformation,
    /// Organization blocks that interrupt others: number of frames below, start information.
    interrupts: Vec<(usize, StartInformation)>,
    /// Blocks that run and handle their errors themselves, outermost first; some may have ended.
    pub(crate) handlers: Vec<Handler>,
    /// The last start of every organization block since the restart, by its number.
    pub(crate) started: BTreeMap<u16, StartInformation>,
    /// The assertion of an extension word that was false.
    pub(crate) failed_assertion: Option<FailedAssertion>,
    /// The program asked for a reboot (SFC -2).
    pub(crate) reboot: bool,
    /// CPU clock when the clock memory began (SFC -4).
    pub(crate) clock_memory_from_us: u64,
    /// The byte of bit memory that holds the clock memory.
    pub(crate) clock_memory_byte: Option<u16>,
    /// CPU clock at the last restart that was no hot one.
    pub(crate) restarted_us: u64,
    /// Jobs of functions that run over several calls: the function and the area that it works on.
    pub(crate) jobs: Vec<(u16, [u8; 10])>,
    /// Data blocks whose bytes in the load memory the program has changed (SFC 84).
    pub(crate) load_memory: BTreeMap<u16, Vec<u8>>,
    /// Created data blocks that a warm or cold restart clears (SFC 85).
    pub(crate) non_retain: BTreeSet<u16>,
    /// What SFC 100 said about the clock.
    pub(crate) clock: ClockStatus,
    /// What the test that was suspended asks for.
    pub(crate) asked: Option<Asked>,
    /// Blocks that the test mocks.
    pub(crate) mocks: Vec<Mock>,
}

/// What the program knows about the clock of the CPU.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct ClockStatus {
    /// Difference to the base time in half hours, -24 to 26.
    pub(crate) correction: i8,
    /// Daylight saving time.
    pub(crate) summer: bool,
    /// The hour before a change between summer and winter time.
    pub(crate) announced: bool,
}

impl ClockStatus {
    /// The status as one word: bit 15 = behind the base time, bits 14 to 10 half hours, bit 9 announced, bit 8 summer.
    pub(crate) fn word(self) -> u16 {
        u16::from(self.correction < 0) << 15
            | u16::from(self.correction.unsigned_abs() & 0x1F) << 10
            | u16::from(self.announced) << 9
            | u16::from(self.summer) << 8
    }
}

impl State {
    /// The CPU starts. Run-time meters keep what they show and stand still until the program starts them.
    pub(crate) fn restart(&mut self, now_us: u64, hot: bool, startup: StartInformation) {
        self.startup = startup;
        self.failed_assertion = None;
        self.reboot = false;
        self.classes.clear();
        self.interrupts.clear();
        self.handlers.clear();
        self.jobs.clear();
        if !hot {
            self.started.clear();
            self.restarted_us = now_us;
            for meter in &mut self.meters {
                meter.stop(now_us);
            }
        }
    }

    /// An organization block starts as an own priority class.
    pub(crate) fn begin(&mut self, info: StartInformation) {
        let number = u16::from(info.block);
        if !self.classes.is_empty() {
            self.classes.remove(&number);
        }
        self.interrupts.clear();
        self.handlers.clear();
        // To look for what is there mostly is faster than to insert it.
        match self.started.get_mut(&number) {
            Some(last) => *last = info,
            None => drop(self.started.insert(number, info)),
        }
    }

    /// Hands out what belongs to the blocks that run, to be put aside with them.
    pub(crate) fn take_running(&mut self) -> Running {
        Running {
            classes: std::mem::take(&mut self.classes),
            interrupts: std::mem::take(&mut self.interrupts),
            handlers: std::mem::take(&mut self.handlers),
        }
    }

    /// Takes it back.
    pub(crate) fn put_running(&mut self, running: Running) {
        self.classes = running.classes;
        self.interrupts = running.interrupts;
        self.handlers = running.handlers;
    }

    /// An organization block interrupts another.
    pub(crate) fn interrupt(&mut self, machine: &Machine, info: StartInformation) {
        let depth = machine.frames.len();
        self.interrupts.retain(|&(below, _)| below < depth);
        self.interrupts.push((depth, info));
        self.started.insert(u16::from(info.block), info);
        if info.block != 121 && info.block != 122 {
            self.classes.remove(&u16::from(info.block));
        }
    }

    /// What the running priority class has set. Organization blocks of synchronous errors belong to the class of their cause.
    pub(crate) fn class(&mut self, machine: &Machine) -> &mut Class {
        let own = machine.frames.iter().rfind(|frame| frame.begins_class());
        self.classes.entry(own.map_or(0, |frame| frame.block.number)).or_default()
    }

    /// What the run-time meters show, in hours.
    pub(crate) fn meter_hours(&self, now_us: u64) -> [u32; 8] {
        self.meters.map(|meter| u32::try_from(meter.now(now_us) / HOUR_US).unwrap_or(u32::MAX))
    }

    /// Which run-time meters run, meter 0 in bit 0.
    pub(crate) fn meters_running(&self) -> u8 {
        self.meters.iter().enumerate().fold(0, |bits, (index, meter)| bits | u8::from(meter.since_us.is_some()) << index)
    }

    /// Start information of the organization block that interrupts others on top of this many frames.
    pub(crate) fn started_at(&self, below: usize) -> Option<StartInformation> {
        self.interrupts.iter().rev().find(|one| one.0 == below).map(|&(_, info)| info)
    }

    /// Start information of the innermost organization block, if it interrupts another.
    pub(crate) fn innermost(&self, machine: &Machine) -> Option<StartInformation> {
        // One that has ended is still in the list; another block may run where it was.
        let runs = |below: usize| machine.frames.get(below).is_some_and(|frame| matches!(frame.origin, Origin::Interrupt { .. }));
        self.interrupts.iter().rev().find(|&&(below, _)| runs(below)).map(|&(_, info)| info)
    }
}

impl Meter {
    /// What it shows now, in microseconds.
    pub(crate) fn now(&self, now_us: u64) -> u64 {
        self.since_us.map_or(self.shown_us, |since| self.shown_us.saturating_add(now_us.saturating_sub(since)))
    }

    /// Stands still and keeps what it shows.
    pub(crate) fn stop(&mut self, now_us: u64) {
        *self = Self { shown_us: self.now(now_us), since_us: None };
    }
}
