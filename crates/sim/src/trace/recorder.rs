//! Records: looks at a CPU behind every scan and writes down what changed.

use std::collections::VecDeque;

use sieben_cpu::Cpu;

use super::code::Encoder;
use super::recording::{self, Block};
use super::{Channel, Moment, Origin, SCANS_MAX, Scans, Store, Summary, Trace, TraceError, Trigger};
use crate::names::{Name, Sample};

/// Bytes after which a block is written: large enough that its first scan, which names all channels, weighs little.
const BLOCK_BYTES: usize = 64 << 10;

/// Most scans that wait for a trigger: they are in memory, some 100 bytes each where many channels change.
pub const BEFORE_MAX: u64 = 200_000;

/// Which scans are kept.
#[derive(Clone, Debug, PartialEq)]
pub enum Keep {
    /// All of them.
    All,
    /// The last ones, at most [`BEFORE_MAX`].
    Last(u64),
    /// The one in which the trigger comes, with so many before (at most [`BEFORE_MAX`]) and behind it.
    Around(Trigger, u64, u64),
}

/// Where the recording stands.
#[derive(Debug)]
enum State {
    /// Scans wait for the trigger, or for being too old.
    Waiting { scans_max: u64 },
    /// They are written, so many more or all.
    Writing { left: Option<u64> },
    /// All that was asked for is written.
    Complete,
}

/// A scan that waits: what it changed.
#[derive(Debug)]
struct Waiting {
    moment: Moment,
    changes: Box<[(u32, Sample)]>,
}

/// Records a run.
pub struct Recorder {
    names: Vec<Name>,
    channels: Vec<Channel>,
    origin: Origin,
    values: Vec<Sample>,
    changed: Vec<usize>,
    last: Option<Moment>,
    state: State,
    trigger: Option<Trigger>,
    /// The value that the trigger looks at, in the scan before.
    watched: Option<Sample>,
    came: Option<Moment>,
    ring: VecDeque<Waiting>,
    writer: Writer,
}

impl Recorder {
    /// A recorder of these names, at most [`super::CHANNELS_MAX`].
    ///
    /// # Errors
    /// The store does not take the head of the recording.
    pub fn new(names: Vec<Name>, keep: Keep, origin: Origin, store: Box<dyn Store>) -> Result<Self, TraceError> {
        let channels: Vec<Channel> = names.iter().map(Channel::new).collect();
        Ok(Self { names, ..Self::of_channels(channels, keep, origin, store)? })
    }

    /// A recorder of channels whose values are [given](Self::put).
    ///
    /// # Errors
    /// As of [`Self::new`].
    pub fn of_channels(channels: Vec<Channel>, keep: Keep, origin: Origin, mut store: Box<dyn Store>) -> Result<Self, TraceError> {
        recording::write_head(&mut *store, &origin, &channels)?;
        let (state, trigger) = match keep {
            Keep::All => (State::Writing { left: None }, None),
            Keep::Last(scans) => (State::Waiting { scans_max: scans.clamp(1, BEFORE_MAX) }, None),
            Keep::Around(trigger, before, behind) => {
                // The scan of the trigger itself waits, too.
                (State::Waiting { scans_max: before.min(BEFORE_MAX) + 1 }, Some((trigger, behind)))
            }
        };
        let (trigger, behind) = trigger.map_or((None, 0), |(trigger, behind)| (Some(trigger), behind));
        let values = vec![Sample::Absent; channels.len()];
        let writer = Writer {
            encoder: Encoder::default(),
            summary: Summary::new(channels.len()),
            values: values.clone(),
            blocks: Vec::new(),
            store,
            behind,
        };
        Ok(Self {
            names: Vec::new(),
            channels,
            origin,
            values,
            changed: Vec::new(),
            last: None,
            state,
            trigger,
            watched: None,
            came: None,
            ring: VecDeque::new(),
            writer,
        })
    }

    /// Whether everything that was to be kept is written, so that the run can end.
    pub fn is_complete(&self) -> bool {
        matches!(self.state, State::Complete)
    }

    /// Whether the trigger came, or none was asked for.
    pub fn was_triggered(&self) -> bool {
        self.trigger.is_none() || self.came.is_some()
    }

    /// Looks at a CPU behind a scan. A scan whose number is not above that of the scan before is left out; time does not run backwards.
    ///
    /// # Errors
    /// The store is full, or the trace would be too long.
    pub fn scan(&mut self, cpu: &Cpu, scan: u64, time_us: u64) -> Result<(), TraceError> {
        if self.is_complete() || self.last.is_some_and(|last| scan <= last.scan) {
            return Ok(());
        }
        let moment = Moment { scan, time_us: self.last.map_or(time_us, |last| last.time_us.max(time_us)) };
        self.last = Some(moment);
        self.changed.clear();
        for (index, (name, value)) in self.names.iter().zip(&mut self.values).enumerate() {
            let sample = name.sample(cpu).unwrap_or_default();
            if *value != sample {
                *value = sample;
                self.changed.push(index);
            }
        }
        let comes = self.came.is_none() && self.comes(cpu, moment);
        self.keep(moment, comes)
    }

    /// Takes the values of all channels behind a scan, as [`Self::scan`] does from a CPU; no trigger comes.
    ///
    /// # Errors
    /// As of [`Self::scan`].
    pub fn put(&mut self, moment: Moment, values: &[Sample]) -> Result<(), TraceError> {
        if self.is_complete() || self.last.is_some_and(|last| moment.scan <= last.scan) {
            return Ok(());
        }
        self.last = Some(moment);
        self.changed.clear();
        for (index, (value, new)) in self.values.iter_mut().zip(values).enumerate() {
            if value != new {
                value.clone_from(new);
                self.changed.push(index);
            }
        }
        self.keep(moment, false)
    }

    fn keep(&mut self, moment: Moment, comes: bool) -> Result<(), TraceError> {
        match &mut self.state {
            State::Waiting { scans_max } => {
                let changes = self.changed.iter().map(|&index| (index as u32, self.values[index].clone())).collect();
                self.ring.push_back(Waiting { moment, changes });
                if self.ring.len() as u64 > *scans_max
                    && let Some(old) = self.ring.pop_front()
                {
                    self.writer.skip(&old);
                }
                if comes {
                    self.came = Some(moment);
                    self.release()?;
                    let left = self.writer.behind;
                    self.state = if left == 0 { State::Complete } else { State::Writing { left: Some(left) } };
                }
                Ok(())
            }
            State::Writing { left } => {
                let complete = left.as_mut().is_some_and(|left| {
                    *left -= 1;
                    *left == 0
                });
                self.writer.copy(&self.changed, &self.values);
                self.writer.write(moment, &self.changed)?;
                if complete {
                    self.state = State::Complete;
                }
                Ok(())
            }
            State::Complete => Ok(()),
        }
    }

    /// Whether the trigger comes in this scan.
    fn comes(&mut self, cpu: &Cpu, moment: Moment) -> bool {
        let Some(trigger) = &self.trigger else { return false };
        let value = trigger.name().map_or(Sample::Absent, |name| name.sample(cpu).unwrap_or_default());
        let comes = trigger.comes(moment, self.watched.as_ref(), &value);
        self.watched = Some(value);
        comes
    }

    /// Writes the scans that waited.
    fn release(&mut self) -> Result<(), TraceError> {
        for waiting in std::mem::take(&mut self.ring) {
            let changed = self.writer.apply(&waiting);
            self.writer.write(waiting.moment, &changed)?;
        }
        Ok(())
    }

    /// The trace. What still waits is part of it: the last scans of a run in which the trigger did not come.
    ///
    /// # Errors
    /// The store is full.
    pub fn finish(mut self) -> Result<Trace, TraceError> {
        self.release()?;
        let Writer { mut encoder, summary, mut blocks, mut store, .. } = self.writer;
        if let Some((first_scan, bytes)) = encoder.take() {
            blocks.push(recording::write_block(&mut *store, first_scan, &bytes)?);
        }
        recording::write_end(&mut *store, summary.scans, self.came)?;
        Ok(Trace { origin: self.origin, channels: self.channels, summary, trigger: self.came, whole: true, blocks, store })
    }
}

/// Puts scans into blocks, and blocks into the store.
struct Writer {
    encoder: Encoder,
    summary: Summary,
    /// The values behind the last scan that was written or skipped.
    values: Vec<Sample>,
    blocks: Vec<Block>,
    store: Box<dyn Store>,
    /// Scans to be written behind the trigger.
    behind: u64,
}

impl Writer {
    /// Takes over what a scan changed, without writing it.
    fn skip(&mut self, waiting: &Waiting) {
        for (channel, value) in &waiting.changes {
            self.values[*channel as usize] = value.clone();
        }
    }

    /// Takes over what a scan changed, and says which channels these are.
    fn apply(&mut self, waiting: &Waiting) -> Vec<usize> {
        self.skip(waiting);
        waiting.changes.iter().map(|&(channel, _)| channel as usize).collect()
    }

    fn copy(&mut self, changed: &[usize], values: &[Sample]) {
        for &channel in changed {
            self.values[channel] = values[channel].clone();
        }
    }

    fn write(&mut self, moment: Moment, changed: &[usize]) -> Result<(), TraceError> {
        if self.summary.scans >= SCANS_MAX {
            return Err(TraceError::TooLong);
        }
        self.encoder.scan(moment, &self.values, changed);
        self.summary.add(&Scans { first: moment, count: 1, step_us: 0, values: &self.values, changed });
        if self.encoder.len() >= BLOCK_BYTES
            && let Some((first_scan, bytes)) = self.encoder.take()
        {
            self.blocks.push(recording::write_block(&mut *self.store, first_scan, &bytes)?);
        }
        Ok(())
    }
}
