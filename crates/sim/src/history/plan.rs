//! What comes from outside when nobody says otherwise: the startup, then one scan after the other, and what is set at its time.

use sieben_cpu::Restart;

use crate::names::Setting;

/// Something from outside.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// The CPU starts.
    Restart(Restart),
    /// One scan.
    Scan {
        /// When it begins, in microseconds.
        now_us: u64,
    },
    /// A value is set.
    Set(Setting),
}

/// What comes when.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// From one scan to the next, in microseconds.
    pub cycle_us: u64,
    /// How many scans there are; `None` = as many as are wanted.
    pub scans: Option<u64>,
    /// Values that are set: by the first scan that begins at this time, in microseconds, or later. In the order of their times.
    pub timed: Vec<(u64, Setting)>,
    started: bool,
    done: u64,
    /// When the last scan began.
    last_us: Option<u64>,
    set: usize,
}

impl Plan {
    /// Scans every so many microseconds, and what is set at its time.
    pub fn new(cycle_us: u64, scans: Option<u64>, mut timed: Vec<(u64, Setting)>) -> Self {
        timed.sort_by_key(|(time, ..)| *time);
        Self { cycle_us, scans, timed, ..Self::default() }
    }

    /// What is still to be set, as names of another program; what `again` does not find there is left out.
    pub(super) fn rename(&mut self, mut again: impl FnMut(&Setting) -> Option<Setting>) {
        let ahead = self.timed.split_off(self.set.min(self.timed.len()));
        self.timed = ahead.into_iter().filter_map(|(time, setting)| Some((time, again(&setting)?))).collect();
        self.set = 0;
    }

    /// What comes next, up to the next scan; nothing if all scans are done.
    pub(super) fn next(&mut self) -> Vec<Action> {
        if !std::mem::replace(&mut self.started, true) {
            return vec![Action::Restart(Restart::Warm)];
        }
        if self.scans.is_some_and(|scans| self.done >= scans) {
            return Vec::new();
        }
        let now_us = self.last_us.map_or(0, |last| last.saturating_add(self.cycle_us));
        let mut actions = Vec::new();
        while let Some((_, setting)) = self.timed.get(self.set).filter(|(time, _)| *time <= now_us) {
            actions.push(Action::Set(setting.clone()));
            self.set += 1;
        }
        actions.push(Action::Scan { now_us });
        self.done += 1;
        self.last_us = Some(now_us);
        actions
    }

    /// Whether the CPU has been started: until then it is in STOP without having come there.
    pub(super) fn has_started(&self) -> bool {
        self.started
    }

    /// The run stands after the beginning of the startup and of so many scans, the last of which began at this time.
    pub(super) fn rewind(&mut self, started: bool, scans: u64, last_us: Option<u64>) {
        self.started = started;
        self.done = scans;
        self.last_us = last_us;
        self.set = last_us.map_or(0, |last| self.timed.partition_point(|(time, ..)| *time <= last));
    }
}
