//! A scan of the past as pages see it: all of it, or up to one of its statements.

use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

use serde_json::Value as Json;
use sieben_cpu::{Cpu, OperatingMode};
use sieben_engine::{FaultPlace, Machine, StatementEvent, Tracer};
use sieben_model::item::Item;
use sieben_workspace::Refusal;
use sieben_workspace::past::{Mark, Seen, Viewer};
use sieben_workspace::status::{Calls, Instances, Sample, Statements, keep, value_written};

use crate::cpu::{Lamps, lamps, leds};
use crate::hub::{Hub, item_of, reasons_of, see};
use crate::live::content::Content;
use crate::live::message::Common;
use crate::live::program::{Known, Said, word};
use crate::live::shot::{Head, Position, Shot};
use crate::live::wanted::Wanted;
use crate::past::not_kept;

/// What of the past is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Moment {
    /// A scan.
    pub(crate) scan: u64,
    /// So many of its statements, in all blocks; `None`: all of it.
    pub(crate) statements: Option<u64>,
}

/// Reasons of statements.
pub(crate) type Reasons = HashMap<(Calls, u32), Arc<Said>>;

/// What the statements of a scan did, up to one of them.
struct Told<'h> {
    wanted: &'h Wanted,
    program: &'h Known,
    instances: Instances,
    statements: Statements,
    reasons: Reasons,
    /// Statements so far, in all blocks.
    count: u64,
    /// The scan is shown up to this one.
    until: Option<u64>,
    /// Blocks that run where the next statement stands.
    depth: usize,
    /// Blocks that ran where the last statement that is shown stands: it has ended when so many run again.
    ends_at: Option<usize>,
    last: Option<(FaultPlace, Arc<Said>)>,
}

impl<'h> Told<'h> {
    fn new(wanted: &'h Wanted, program: &'h Known, until: Option<u64>) -> Self {
        Self {
            wanted,
            program,
            instances: Instances::default(),
            statements: Statements::new(),
            reasons: Reasons::new(),
            count: 0,
            until,
            depth: 0,
            ends_at: None,
            last: None,
        }
    }
}

/// Whether steps stop at a statement of these calls: they do in the blocks that are shown, and in all where none is.
pub(crate) fn is_counted(wanted: &Wanted, mut calls: impl Iterator<Item = Calls>) -> bool {
    wanted.rows.is_empty() || calls.any(|calls| wanted.rows.contains(&calls))
}

impl Tracer for Told<'_> {
    fn pauses_before(&mut self, machine: &Machine, place: FaultPlace) -> bool {
        self.instances.before(machine);
        self.depth = machine.frames.len();
        // What a call leads to belongs to it, unless it is stepped through itself.
        self.ends_at.is_some_and(|depth| self.depth <= depth || is_counted(self.wanted, self.instances.calls(place.block)))
    }

    fn statement(&mut self, machine: &Machine, event: &StatementEvent) {
        self.count += 1;
        let number = event.place.statement;
        for calls in self.instances.calls(event.place.block) {
            if self.wanted.calls.contains(&calls) {
                let value = value_written(&self.program.written(calls.block), machine, event);
                keep(&mut self.statements, (calls, number), event, value);
            }
            if self.wanted.reasons.contains(&(calls, number))
                && let Some(said) = reasons_of(self.program, machine, event)
            {
                self.reasons.insert((calls, number), said);
            }
        }
        if self.until == Some(self.count) {
            self.ends_at = Some(self.depth);
            self.last = Some((event.place, reasons_of(self.program, machine, event).unwrap_or_default()));
        }
    }
}

/// Which statements of the calls that are looked at run after some others.
struct Later<'h> {
    wanted: &'h Wanted,
    instances: Instances,
    count: u64,
    from: u64,
    places: BTreeSet<(Calls, u32)>,
}

impl Tracer for Later<'_> {
    fn pauses_before(&mut self, machine: &Machine, _: FaultPlace) -> bool {
        self.instances.before(machine);
        false
    }

    fn statement(&mut self, _: &Machine, event: &StatementEvent) {
        self.count += 1;
        if self.count > self.from {
            let calls = self.instances.calls(event.place.block).filter(|calls| self.wanted.calls.contains(calls));
            self.places.extend(calls.map(|calls| (calls, event.place.statement)));
        }
    }
}

/// What the statements that are wanted did in a scan, and why.
///
/// # Errors
/// It is not kept.
pub(crate) fn statements(
    hub: &Hub,
    viewer: &mut Viewer,
    scan: u64,
    (wanted, program): (&Wanted, &Known),
) -> Result<(Sample, Reasons), Refusal> {
    let mut told = Told::new(wanted, program, None);
    let Seen { mark, .. } = viewer.traced(hub.desk.past(), scan, &mut told).map_err(not_kept)?;
    Ok((sample(wanted, mark, told.statements), told.reasons))
}

fn sample(wanted: &Wanted, Mark { scan, time_us }: Mark, statements: Statements) -> Sample {
    Sample { scan, time_us, same: true, calls: wanted.calls.iter().copied().collect(), statements }
}

/// What is read at one moment.
struct Read {
    mark: Mark,
    tags: HashMap<String, Json>,
    plant: Option<Content>,
    mode: OperatingMode,
    lamps: Lamps,
}

impl Read {
    fn at(mark: Mark, cpu: &Cpu, items: &[(String, Option<Item>)], wanted: &Wanted) -> Self {
        let (tags, plant) = see(cpu, items, wanted);
        Self { mark, tags, plant, mode: cpu.mode(), lamps: lamps(cpu) }
    }
}

/// A moment of the past with all that a page wants of it; how the run goes is that of now.
///
/// # Errors
/// It is not kept.
pub(crate) fn shot(hub: &Hub, viewer: &mut Viewer, moment: Moment, wanted: &Wanted) -> Result<Shot, Refusal> {
    let program = hub.program();
    let items: Vec<(String, Option<Item>)> = wanted.names.iter().map(|name| (name.clone(), item_of(name, &program))).collect();
    let mut told = Told::new(wanted, &program, moment.statements);
    let Seen { mark, cpu } = viewer.traced(hub.desk.past(), moment.scan, &mut told).map_err(not_kept)?;
    let time_us = if cpu.is_paused() { cpu.time_us() } else { mark.time_us };
    let Read { mark, tags, plant, mode, lamps } = Read::at(Mark { time_us, ..mark }, cpu, &items, wanted);
    let Told { statements, reasons, count, last, .. } = told;
    let pending = match last {
        Some(_) => Arc::new(pending(hub, viewer, (moment.scan, count), (wanted, &statements))?),
        None => Arc::default(),
    };
    let position = last.map(|(place, reason)| Position {
        block: word(place.block),
        index: place.statement,
        line: program.lines(place.block).get(place.statement as usize).copied().unwrap_or_default(),
        reason,
    });
    let newest = hub.looks().borrow().as_ref().map(|shot| (shot.head.clone(), shot.common.clone()));
    let (now, mut common) = newest.unwrap_or_default();
    if let Some(plant) = plant {
        common.insert(Common::Plant, plant);
    }
    common.insert(Common::Leds, leds(mode, lamps));
    let sample = sample(wanted, mark, statements);
    let flows = hub.flows(wanted, &program, Some(&sample), None);
    let head = Head { scan: mark.scan, time_us: mark.time_us, mode, same: true, why: None, ..now };
    Ok(Shot { head, program, sample: Some(Arc::new(sample)), position, pending, reasons, flows, tags, common })
}

/// Statements that a scan has still to do after some, with what they did in the scan before. Of a block that goes on these are all that stand
/// after the one that it did last: which of them it leaves out is not decided yet.
fn pending(
    hub: &Hub,
    viewer: &mut Viewer,
    (scan, count): (u64, u64),
    (wanted, done): (&Wanted, &Statements),
) -> Result<Statements, Refusal> {
    let mut later = Later { wanted, instances: Instances::default(), count: 0, from: count, places: BTreeSet::new() };
    viewer.traced(hub.desk.past(), scan, &mut later).map_err(not_kept)?;
    let program = hub.program();
    let before = match scan.checked_sub(1) {
        // Of the oldest scan nothing is known of the one before.
        Some(before) => statements(hub, viewer, before, (wanted, &program)).map(|(sample, _)| sample.statements).unwrap_or_default(),
        None => Statements::new(),
    };
    let goes_on: BTreeSet<Calls> = later.places.iter().map(|&(calls, _)| calls).collect();
    let is_pending = |&(calls, number): &(Calls, u32)| {
        let last = done.range((calls, 0)..=(calls, u32::MAX)).next_back().map(|(&(_, last), _)| last);
        later.places.contains(&(calls, number)) || goes_on.contains(&calls) && last.is_none_or(|last| number > last)
    };
    Ok(before.into_iter().filter(|(place, _)| !done.contains_key(place) && is_pending(place)).collect())
}
