//! Interrupts and asynchronous errors: where they come from, which one waits, which one is next.

mod cyclic;
mod delay;
mod interrupt;
mod run_times;
mod time_of_day;

use std::collections::VecDeque;

use sieben_engine::Machine;
use sieben_model::block::BlockId;

use crate::clock::DateAndTime;
use crate::organization_blocks::{self as ob, Missing};
use crate::start_information::StartInformation;

use cyclic::Cyclic;
pub use cyclic::CyclicInterrupt;
pub(crate) use delay::Delays;
pub use interrupt::{Coming, Exchange, Interrupt, ModuleAddress, StatusKind};
pub(crate) use run_times::RunTimes;
pub(crate) use time_of_day::{Again, Period, Refusal, TimesOfDay};

/// Requests of one organization block that can wait; one more is a time error 16#3507.
/// The real number differs from CPU to CPU; 16 alarms of one kind at the same moment are beyond what any of them serves.
pub(crate) const REQUESTS_MAX: usize = 16;

/// One above the greatest number of an organization block that an event starts.
const NUMBERS: usize = 128;

/// A point in time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Now {
    /// Since the CPU exists, in microseconds.
    pub(crate) now_us: u64,
    /// CPU clock, in microseconds: it stands still in STOP and HOLD.
    pub(crate) clock_us: u64,
    /// Time of day at `now_us` = 0.
    pub(crate) start: DateAndTime,
}

impl Now {
    /// The time of day.
    pub(crate) fn date_and_time(&self) -> DateAndTime {
        self.start.plus_us(self.now_us)
    }

    /// When the CPU clock shows this, or has shown it, if the CPU stays in RUN.
    fn at_clock(&self, clock_us: u64) -> u64 {
        let ahead = clock_us.saturating_sub(self.clock_us);
        self.now_us.saturating_add(ahead).saturating_sub(self.clock_us.saturating_sub(clock_us))
    }

    /// When the time of day is this, in milliseconds since 1990.
    fn at_date(&self, ms: u64) -> u64 {
        ms.saturating_sub(self.start.ms()).saturating_mul(1000)
    }
}

/// Whether events of an organization block are lost (SFC 39).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Lock {
    #[default]
    Open,
    /// Lost; errors still enter the diagnostic buffer.
    Lost,
    /// Lost without a trace.
    LostSilently,
}

/// An event that waits for its organization block to run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Request {
    pub(crate) info: StartInformation,
    /// When it came, in microseconds.
    pub(crate) raised_us: u64,
}

/// Where a timed event comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Source {
    TimeOfDay(u16),
    Delay(u16),
    Cyclic(u16),
}

/// All interrupts of a CPU.
#[derive(Clone, Debug)]
pub(crate) struct Interrupts {
    /// Blocks that are loaded and that the CPU type calls.
    available: [bool; NUMBERS],
    locks: [Lock; NUMBERS],
    /// Blocks of STARTUP are interrupted by asynchronous errors only.
    startup: bool,
    waiting: Vec<Request>,
    pub(crate) cyclic: Cyclic,
    pub(crate) delays: Delays,
    pub(crate) times_of_day: TimesOfDay,
    pub(crate) run_times: RunTimes,
    /// Events that come at a safe point of the next cycle, by its number from 1.
    scheduled: VecDeque<(u64, Interrupt)>,
    /// What the diagnostic buffer has to learn.
    entries: Vec<StartInformation>,
    /// STOP with this event, and what led to it.
    stop: Option<(u16, StartInformation)>,
}

impl Interrupts {
    /// `available` tells whether an organization block is loaded and the CPU type calls it.
    pub(crate) fn new(available: impl Fn(u16) -> bool) -> Self {
        Self {
            available: std::array::from_fn(|number| available(number as u16)),
            locks: [Lock::Open; NUMBERS],
            startup: false,
            waiting: Vec::new(),
            cyclic: Cyclic::default(),
            delays: Delays::default(),
            times_of_day: TimesOfDay::default(),
            run_times: RunTimes::default(),
            scheduled: VecDeque::new(),
            entries: Vec::new(),
            stop: None,
        }
    }

    /// Whether OB `number` is loaded and the CPU type calls it.
    pub(crate) fn is_available(&self, number: u16) -> bool {
        self.available.get(usize::from(number)).copied().unwrap_or(false)
    }

    /// Other organization blocks are loaded now; what waited for one that has gone is forgotten.
    pub(crate) fn set_available(&mut self, available: impl Fn(u16) -> bool) {
        self.available = std::array::from_fn(|number| available(number as u16));
        let Self { available, waiting, .. } = self;
        waiting.retain(|request| available.get(usize::from(request.info.block)).copied().unwrap_or(false));
    }

    /// Nothing waits any more.
    pub(crate) fn clear(&mut self) {
        self.waiting.clear();
        self.entries.clear();
        self.stop = None;
        self.cyclic = Cyclic::default();
    }

    /// STARTUP begins. Only a hot restart keeps what the program has set.
    pub(crate) fn startup(&mut self, hot: bool) {
        self.clear();
        self.startup = true;
        if !hot {
            self.delays = Delays::default();
            self.times_of_day = TimesOfDay::default();
            self.locks = [Lock::Open; NUMBERS];
        }
    }

    /// RUN begins.
    pub(crate) fn run(&mut self, cyclic: impl Iterator<Item = (u16, CyclicInterrupt)>, clock_us: u64) {
        self.startup = false;
        self.cyclic.start(cyclic, clock_us);
        for request in &mut self.waiting {
            request.info.priority = ob::priority(BlockId::ob(u16::from(request.info.block)));
        }
    }

    /// Whether blocks of STARTUP run, which only asynchronous errors interrupt.
    pub(crate) fn in_startup(&self) -> bool {
        self.startup
    }

    /// Whether OB `number` waits or runs.
    pub(crate) fn is_busy(&self, number: u16, machine: &Machine) -> bool {
        self.waits(number) > 0 || machine.frames.iter().any(|frame| frame.begins_class() && frame.block == BlockId::ob(number))
    }

    /// Whether anything waits, has to be told or stops the CPU.
    pub(crate) fn is_idle(&self) -> bool {
        self.waiting.is_empty() && self.entries.is_empty() && self.stop.is_none()
    }

    /// Whether nothing waits, and nothing comes by itself.
    pub(crate) fn is_quiet(&self) -> bool {
        self.is_idle() && self.times_of_day.next().is_none() && self.delays.next().is_none() && self.cyclic.next().is_none()
    }

    /// What has to enter the diagnostic buffer.
    pub(crate) fn take_entries(&mut self) -> Vec<StartInformation> {
        std::mem::take(&mut self.entries)
    }

    /// The STOP that a missing block leads to: its event, and what the block was needed for.
    pub(crate) fn take_stop(&mut self) -> Option<(u16, StartInformation)> {
        self.stop.take()
    }

    fn waits(&self, number: u16) -> usize {
        self.waiting.iter().filter(|request| u16::from(request.info.block) == number).count()
    }

    /// When the oldest request of OB `number` that waits came.
    pub(crate) fn waits_since(&self, number: u16) -> Option<u64> {
        self.waiting.iter().find(|request| u16::from(request.info.block) == number).map(|request| request.raised_us)
    }

    /// An event happens while `active` runs.
    pub(crate) fn raise(&mut self, info: StartInformation, active: &StartInformation, now_us: u64) {
        let number = u16::from(info.block);
        let error = ob::is_asynchronous_error(number);
        let lock = self.locks.get(usize::from(number)).copied().unwrap_or_default();
        if error && lock != Lock::LostSilently {
            self.entries.push(info);
        }
        self.request(info, active, now_us);
    }

    /// The same for an event that is in the diagnostic buffer already.
    pub(crate) fn request(&mut self, mut info: StartInformation, active: &StartInformation, now_us: u64) {
        let number = u16::from(info.block);
        if self.is_locked(number) {
            return;
        }
        if !self.is_available(number) {
            return match ob::missing(BlockId::ob(number)) {
                Missing::GoesOn => {}
                Missing::PriorityClassError => self.raise(StartInformation::block_not_loaded(&info, active), active, now_us),
                Missing::Stop(event) => {
                    self.stop.get_or_insert((event, info));
                }
            };
        }
        if ob::is_asynchronous_error(number) && self.startup {
            info.priority = 28;
        }
        if self.waits(number) < REQUESTS_MAX {
            self.waiting.push(Request { info, raised_us: now_us });
        } else if number == ob::TIME_ERROR.number {
            self.stop.get_or_insert((ob::stop_event(ob::TIME_ERROR), info));
        } else {
            self.time_error(0x3507, &info, active, now_us);
        }
    }

    /// A time error for a request, unless the same one waits already.
    fn time_error(&mut self, event: u16, request: &StartInformation, active: &StartInformation, now_us: u64) {
        let error = StartInformation::time_error(event, request);
        let same = |waiting: &Request| waiting.info.event == error.event && waiting.info.info_2 == error.info_2;
        if !self.waiting.iter().any(same) {
            self.raise(error, active, now_us);
        }
    }

    /// A priority class was aborted inside others: OB 88 comes first of all.
    pub(crate) fn abort(&mut self, info: StartInformation, now_us: u64) {
        self.waiting.push(Request { info, raised_us: now_us });
    }

    /// The request that may interrupt a block of priority class `above`: the highest class, the oldest first.
    pub(crate) fn take(&mut self, above: u8) -> Option<Request> {
        let may = |request: &Request| {
            let number = u16::from(request.info.block);
            let error = ob::is_asynchronous_error(number) || number == ob::PROCESSING_ABORT.number;
            request.info.priority > above && (!self.startup || error)
        };
        let highest = self.waiting.iter().filter(|request| may(request)).map(|request| request.info.priority).max()?;
        let index = self.waiting.iter().position(|request| request.info.priority == highest && may(request))?;
        Some(self.waiting.remove(index))
    }

    fn next(&self, now: &Now) -> Option<(u64, Source)> {
        let time_of_day = self.times_of_day.next().map(|(ms, number)| (now.at_date(ms), Source::TimeOfDay(number)));
        let delay = self.delays.next().map(|(clock, number)| (now.at_clock(clock), Source::Delay(number)));
        let cyclic = self.cyclic.next().map(|(clock, number)| (now.at_clock(clock), Source::Cyclic(number)));
        [time_of_day, delay, cyclic].into_iter().flatten().min_by_key(|&(at, _)| at)
    }

    /// When the next timed event comes, in microseconds like `now_us`.
    pub(crate) fn next_us(&self, now: &Now) -> Option<u64> {
        self.next(now).map(|(at, _)| at)
    }

    /// All timed events up to now happen, in the order of their times.
    pub(crate) fn gather(&mut self, now: &Now, machine: &Machine, active: &StartInformation) {
        while let Some((at, source)) = self.next(now).filter(|&(at, _)| at <= now.now_us) {
            let (Source::TimeOfDay(number) | Source::Delay(number) | Source::Cyclic(number)) = source;
            let waits = self.waits(number) > 0;
            let busy = self.is_busy(number, machine);
            // Without a block to run, all that were missed are one event: the clock may have jumped by hours.
            let lost = busy || self.is_locked(number) || !self.is_available(number);
            let info = match source {
                Source::TimeOfDay(number) => self.times_of_day.fire(number, now.date_and_time()),
                Source::Delay(number) => self.delays.fire(number),
                Source::Cyclic(number) => self.cyclic.fire(number, lost.then_some(now.clock_us)),
            };
            if busy {
                self.time_error(0x3502, &info, active, now.now_us);
            }
            // What still runs is started once more when it has ended; what waits already is not started twice.
            if !waits {
                self.raise(info, active, at);
            }
        }
    }

    /// The time of day jumped, or passed while the CPU did not run: time-of-day interrupts that were skipped are a time error.
    pub(crate) fn clock_set(&mut self, event: u16, now: &Now, again: Again, active: &StartInformation) {
        let skipped = self.times_of_day.clock_set(now.date_and_time(), again);
        if skipped != 0 {
            self.raise(StartInformation::times_skipped(event, skipped), active, now.now_us);
        }
    }

    /// Locks or opens these blocks (SFC 39, SFC 40).
    pub(crate) fn lock(&mut self, numbers: std::ops::RangeInclusive<u16>, lock: Lock) {
        for number in numbers {
            if let Some(slot) = self.locks.get_mut(usize::from(number)) {
                *slot = lock;
            }
        }
    }

    /// Whether events of OB `number` are lost.
    pub(crate) fn is_locked(&self, number: u16) -> bool {
        self.locks.get(usize::from(number)).is_some_and(|&lock| lock != Lock::Open)
    }

    /// An event comes at a safe point of the next cycle.
    pub(crate) fn schedule(&mut self, point: u64, interrupt: Interrupt) {
        let index = self.scheduled.partition_point(|&(earlier, _)| earlier <= point);
        self.scheduled.insert(index, (point, interrupt));
    }

    /// The next safe point at which an event comes.
    pub(crate) fn next_point(&self) -> Option<u64> {
        self.scheduled.front().map(|&(point, _)| point)
    }

    /// The next event that comes at this safe point or came before it.
    pub(crate) fn take_scheduled(&mut self, point: u64) -> Option<Interrupt> {
        self.scheduled.pop_front_if(|&mut (at, _)| at <= point).map(|(_, interrupt)| interrupt)
    }

    /// Drops what was to come at safe points that the cycle did not reach; how many there were.
    pub(crate) fn drop_scheduled(&mut self) -> usize {
        let dropped = self.scheduled.len();
        self.scheduled.clear();
        dropped
    }
}
