//! What a picture of the demo shows: copied inside of the gate, drawn outside of it.

use std::sync::Arc;
use std::time::Duration;

use sieben_cpu::OperatingMode;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_workspace::status::{Look, Sample};
use sieben_workspace::{Closed, Speed};

use super::changes::{Entry, Watched};
use super::listing::{Line, Seen};
use super::operator::{ScanTime, dosing};
use super::plant::DosingTank;
use super::session::Session;

/// One moment of the demo.
pub(crate) struct Picture<'s> {
    /// What the CPU is.
    pub(crate) cpu_type: &'static CpuType,
    /// What it does.
    pub(crate) mode: OperatingMode,
    /// Scans since the beginning.
    pub(crate) scans: u64,
    /// From one scan to the next; 0 before the second one.
    pub(crate) cycle_us: u64,
    /// The time of the plant in milliseconds.
    pub(crate) time_ms: u64,
    /// How fast it goes.
    pub(crate) speed: Speed,
    /// It stands still.
    pub(crate) paused: bool,
    /// What the computer needs for a scan, in microseconds.
    pub(crate) scan_us: Option<f64>,
    /// The plant.
    pub(crate) dosing: DosingTank,
    /// Seconds until the story presses START; `None` if it will not.
    pub(crate) seconds_to_story: Option<u64>,
    /// The newest changes, the oldest of them first.
    pub(crate) entries: Vec<Arc<Entry>>,
    /// The statements of OB 1.
    pub(crate) lines: &'s [Line],
    watched: Arc<[Watched]>,
    values: Vec<u32>,
    status: Option<Arc<Sample>>,
}

impl Picture<'_> {
    /// The operand with this address, in English letters, and its value.
    pub(crate) fn watched(&self, address: &str) -> Option<(&Watched, u32)> {
        let at = self.watched.iter().position(|watched| watched.address == address)?;
        Some((self.watched.get(at)?, *self.values.get(at)?))
    }

    /// What a statement of OB 1 left when it was executed last; `None` if it was not.
    pub(crate) fn seen(&self, statement: u32) -> Option<Seen> {
        let after = &self.status.as_ref()?.statements.get(&(BlockId::ob(1), statement))?.after;
        Some(Seen { sta: after.sta == 1, rlo: after.rlo == 1, accu1: after.accu1 as u32 })
    }
}

/// Takes one picture after another.
pub(crate) struct Viewer<'s> {
    session: &'s Session,
    _look: Look<'s>,
    /// The number of the newest sample, and the sample.
    status: (u64, Option<Arc<Sample>>),
    scan_us: Option<f64>,
}

impl<'s> Viewer<'s> {
    /// Looks at OB 1 of a demo from now on.
    pub(crate) fn new(session: &'s Session) -> Self {
        Self { session, _look: session.desk.look([BlockId::ob(1)]), status: (session.desk.number(), None), scan_us: None }
    }

    /// A picture with room for so many changes.
    ///
    /// # Errors
    /// The demo is over.
    pub(crate) fn picture(&mut self, room: usize) -> Result<Picture<'s>, Closed> {
        if let Some((number, sample)) = self.session.desk.wait_for_sample(self.status.0, Duration::ZERO) {
            self.status = (number, sample.ok());
        }
        let status = self.status.1.clone();
        let (mut picture, ScanTime { total, scans }) = self.session.look(|plant, operator| {
            let cpu = &plant.cpu;
            let picture = Picture {
                cpu_type: self.session.cpu_type,
                mode: cpu.mode(),
                scans: plant.scans,
                cycle_us: cpu.cycle_times().last,
                time_ms: operator.time_ms(),
                speed: plant.pace.speed(),
                paused: plant.pace.is_paused(),
                scan_us: None,
                dosing: dosing(cpu).clone(),
                seconds_to_story: operator.seconds_to_story(cpu),
                entries: operator.changes.newest(room).cloned().collect(),
                lines: &self.session.lines,
                watched: Arc::clone(&operator.changes.watched),
                values: operator.changes.values.clone(),
                status,
            };
            (picture, operator.take_scan_time())
        })?;
        if scans > 0 {
            let us = total.as_secs_f64() * 1e6 / f64::from(scans);
            // Smoothed, so that the number can be read.
            self.scan_us = Some(self.scan_us.map_or(us, |before| before * 0.9 + us * 0.1));
        }
        picture.scan_us = self.scan_us;
        Ok(picture)
    }
}
