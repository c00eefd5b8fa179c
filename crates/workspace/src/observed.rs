//! What changed: values of a program, compared from scan to scan as long as they are asked for, and notes about the run.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, AtomicU8, AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use sieben_cpu::Station;
use sieben_model::item::Item;
use sieben_model::value::{Kind, Value};

use crate::gate::Plant;

/// Entries that are kept: more than any screen shows, and no growth in a run of weeks.
pub const ENTRIES_MAX: usize = 200;
/// Values that are compared: as many as one list of items has.
pub const WATCHED_MAX: usize = crate::gate::ITEMS_MAX;
/// How long values are compared after they were asked for last, in microseconds of the computer's time.
const LOOK_US: u64 = 5_000_000;
/// A value of more than a bit that changes again sooner than this, in microseconds of the CPU's time, is on the move …
const MOVES_US: u64 = 250_000;
/// … and reported only so often.
const REPORT_US: u64 = 1_000_000;
/// The digits of a time of S5TIME: 0 there is a timer that has run off.
const TIME_DIGITS: u64 = 0x0FFF;
/// No mode was seen yet.
const NO_MODE: u8 = u8::MAX;

/// A value that is compared.
#[derive(Clone, Debug, PartialEq)]
pub struct Watched {
    /// Its symbol; empty if it has none.
    pub name: String,
    /// `Q 0.0`.
    pub address: String,
    /// The comment of its symbol.
    pub comment: String,
    /// What is read.
    pub item: Item,
}

/// Something that is reported.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Its running number, from 1.
    pub number: u64,
    /// The scan after which it was seen.
    pub scan: u64,
    /// The time of the CPU in microseconds.
    pub time_us: u64,
    /// What happened.
    pub event: Event,
}

/// The kinds of entries.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Event {
    /// A value changed.
    Change {
        /// Its symbol; empty if it has none.
        name: String,
        /// `Q 0.0`.
        address: String,
        /// The value that was reported before, as people read it.
        before: String,
        /// The value now.
        after: String,
        /// The comment of the symbol.
        comment: String,
    },
    /// Something about the run: a mode, a changed program, what the plant does.
    Note(String),
}

/// A watched value as it was reported last.
#[derive(Clone, Debug, Default)]
struct Seen {
    reported: Option<Value>,
    /// When that was.
    reported_us: u64,
    /// As it was at the last look, and when it changed last.
    last: Option<Value>,
    changed_us: u64,
}

/// Compares values from scan to scan.
#[derive(Clone, Debug, Default)]
pub struct Observer {
    watched: Vec<Watched>,
    seen: Vec<Seen>,
    items: Vec<Item>,
}

impl Observer {
    /// Compares these, from the next look on.
    pub fn new(mut watched: Vec<Watched>) -> Self {
        watched.truncate(WATCHED_MAX);
        let items = watched.iter().map(|one| one.item.clone()).collect();
        Self { seen: vec![Seen::default(); watched.len()], items, watched }
    }

    /// Forgets all values: the next look finds no change.
    fn forget(&mut self) {
        self.seen.fill(Seen::default());
    }

    /// Compares all values with those of the look before.
    pub fn observe(&mut self, station: &dyn Station, time_us: u64, report: &mut dyn FnMut(Event)) {
        let values = station.read_items(&self.items);
        for ((watched, seen), value) in self.watched.iter().zip(&mut self.seen).zip(values) {
            let Ok(value) = value else { continue };
            let Some(last) = seen.last.replace(value.clone()) else {
                (seen.reported, seen.reported_us) = (Some(value), time_us);
                continue;
            };
            let moves = last != value && time_us.saturating_sub(seen.changed_us) < MOVES_US;
            if last != value {
                seen.changed_us = time_us;
            }
            let Some(reported) = &seen.reported else { continue };
            if *reported == value || !is_news(reported, &value, moves, time_us.saturating_sub(seen.reported_us)) {
                continue;
            }
            let (before, after) = (reported.shown().readable(), value.shown().readable());
            (seen.reported, seen.reported_us) = (Some(value), time_us);
            let Watched { name, address, comment, .. } = watched.clone();
            report(Event::Change { name, address, before, after, comment });
        }
    }
}

/// Whether a value that differs from the one that was reported last is reported: of a timer its start and its end, of what moves one value a second.
fn is_news(reported: &Value, now: &Value, moves: bool, since_us: u64) -> bool {
    let left = |value: &Value| value.content.bits().unwrap_or_default() & TIME_DIGITS;
    match now.kind {
        Kind::Bit => true,
        Kind::TimeLeft => (left(reported) == 0) != (left(now) == 0),
        _ => !moves && since_us >= MOVES_US || since_us >= REPORT_US,
    }
}

/// The newest entries of a run.
#[derive(Debug, Default)]
struct Entries {
    /// Which facts the observer was made of.
    version: Option<u64>,
    observer: Observer,
    /// The newest last.
    entries: VecDeque<Entry>,
    count: u64,
}

impl Entries {
    fn push(&mut self, scan: u64, time_us: u64, event: Event) {
        if self.entries.len() >= ENTRIES_MAX {
            self.entries.pop_front();
        }
        self.count += 1;
        self.entries.push_back(Entry { number: self.count, scan, time_us, event });
    }
}

/// Where changes are asked for. Without onlookers a run pays nothing for it.
#[derive(Debug)]
pub struct Observed {
    /// Until when values are compared, in the computer's time.
    until_us: AtomicU64,
    /// Values have not been compared for a while.
    is_stale: AtomicBool,
    mode: AtomicU8,
    entries: Mutex<Entries>,
}

impl Default for Observed {
    fn default() -> Self {
        Self { until_us: AtomicU64::default(), is_stale: AtomicBool::default(), mode: AtomicU8::new(NO_MODE), entries: Mutex::default() }
    }
}

impl Observed {
    fn entries(&self) -> MutexGuard<'_, Entries> {
        self.entries.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Adds a note; to be called at the cycle control point.
    pub fn note(&self, plant: &Plant, text: impl Into<String>) {
        let time_us = plant.cpu.time_us();
        self.entries().push(plant.scans, time_us, Event::Note(text.into()));
    }

    /// Another CPU runs from now on: what the one before did is forgotten, also its mode. Numbers go on.
    pub(crate) fn reset(&self) {
        self.mode.store(NO_MODE, Ordering::Relaxed);
        let mut entries = self.entries();
        *entries = Entries { count: entries.count, ..Entries::default() };
    }

    /// Notes another mode: a key, a request or the program may have caused it.
    pub(crate) fn see_mode(&self, plant: &Plant) {
        let mode = plant.cpu.mode();
        // Only the thread that scans writes it.
        let before = self.mode.load(Ordering::Relaxed);
        if before == mode as u8 {
            return;
        }
        self.mode.store(mode as u8, Ordering::Relaxed);
        if before != NO_MODE {
            self.note(plant, format!("CPU in {mode}"));
        }
    }

    /// After a scan: compares values if they were asked for lately.
    pub(crate) fn observe(&self, plant: &Plant, real_us: u64) {
        if self.until_us.load(Ordering::Acquire) <= real_us {
            return;
        }
        let mut entries = self.entries();
        let Entries { observer, .. } = &mut *entries;
        if self.is_stale.swap(false, Ordering::AcqRel) {
            observer.forget();
        }
        let (mut events, time_us) = (Vec::new(), plant.cpu.time_us());
        observer.observe(&plant.cpu, time_us, &mut |event| events.push(event));
        events.into_iter().for_each(|event| entries.push(plant.scans, time_us, event));
    }

    /// Values are compared from now on, for a while. `watched` are those of the program with these facts.
    pub fn look(&self, version: u64, watched: impl FnOnce() -> Vec<Watched>, real_us: u64) {
        if self.entries().version != Some(version) {
            // A scan may stand at the lock: what takes its time is done before.
            let observer = Observer::new(watched());
            let mut entries = self.entries();
            entries.version = Some(version);
            entries.observer = observer;
        }
        let before = self.until_us.swap(real_us.saturating_add(LOOK_US), Ordering::AcqRel);
        if before <= real_us {
            self.is_stale.store(true, Ordering::Release);
        }
    }

    /// The number of the newest entry, and the entries after `after`, oldest first.
    pub fn newer_than(&self, after: u64) -> (u64, Vec<Entry>) {
        let entries = self.entries();
        (entries.count, entries.entries.iter().filter(|entry| entry.number > after).cloned().collect())
    }
}

#[cfg(test)]
mod tests {
    use sieben_cpu::{Cpu, Rack, Settings};
    use sieben_engine::Interpreter;
    use sieben_model::address::Operand;
    use sieben_model::cpu_type::CpuType;

    use super::*;
    use crate::pace::{Pace, Speed};

    fn plant() -> Plant {
        let rack = Rack::with_background(&CpuType::ALL[0], Vec::new()).expect("an empty rack");
        let cpu = Cpu::load(&CpuType::ALL[0], std::sync::Arc::default(), Interpreter::load, rack, Settings::default());
        Plant::new(cpu, Pace::new(Speed::Max, 10_000, u64::MAX, 0))
    }

    fn watched(address: &str) -> Watched {
        let operand = Operand::parse(address).expect("an address");
        Watched { name: String::new(), address: address.to_owned(), comment: String::new(), item: Item::operand(operand).readable() }
    }

    /// Changes of a word that has these values, one each 10 ms.
    fn reported(values: impl IntoIterator<Item = u32>) -> Vec<(u64, String, String)> {
        let mut plant = plant();
        let mut observer = Observer::new(vec![watched("MW 10")]);
        let operand = Operand::parse("MW 10").expect("an address");
        let mut reported = Vec::new();
        for (time_us, value) in (0..).step_by(10_000).zip(values) {
            plant.cpu.modify(&operand, value).expect("bit memory");
            observer.observe(&plant.cpu, time_us, &mut |event| {
                if let Event::Change { before, after, .. } = event {
                    reported.push((time_us / 1_000, before, after));
                }
            });
        }
        reported
    }

    #[test]
    fn what_moves_is_reported_once_a_second_and_what_jumps_at_once() {
        let moving = reported(0..250);
        assert_eq!(moving.iter().map(|(ms, ..)| *ms).collect::<Vec<_>>(), [1_000, 2_000]);
        assert_eq!(moving[1].1, moving[0].2, "each change begins where the one before ended");
        let jumping = reported((0..100).map(|scan| scan / 40));
        assert_eq!(jumping.iter().map(|(ms, ..)| *ms).collect::<Vec<_>>(), [400, 800]);
        // What has come to rest is reported, too.
        assert_eq!(reported((0..300).map(|scan: u32| scan.min(20))).len(), 1);
    }

    #[test]
    fn only_what_is_asked_for_is_compared_and_a_pause_is_no_change() {
        let mut plant = plant();
        let observed = Observed::default();
        let operand = Operand::parse("M 0.0").expect("an address");
        let set = |plant: &mut Plant, value| plant.cpu.modify(&operand, value).expect("bit memory");
        let look = |now_us| observed.look(1, || vec![watched("M 0.0")], now_us);
        observed.observe(&plant, 0);
        look(0);
        observed.observe(&plant, 1);
        set(&mut plant, 1);
        observed.observe(&plant, 2);
        assert_eq!(observed.newer_than(0).0, 1);
        set(&mut plant, 0);
        observed.observe(&plant, LOOK_US + 1);
        look(LOOK_US + 2);
        observed.observe(&plant, LOOK_US + 3);
        assert_eq!(observed.newer_than(0).0, 1);
        (0..300).for_each(|number| observed.note(&plant, number.to_string()));
        let (newest, kept) = observed.newer_than(0);
        assert_eq!((newest, kept.len(), kept[0].number), (301, ENTRIES_MAX, 102));
        assert_eq!(observed.newer_than(300).1.len(), 1);
    }
}
