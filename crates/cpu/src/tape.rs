//! What the modules of a rack said, in the order in which they were asked: a run that goes back hears it again.

use std::collections::VecDeque;
use std::ops::Range;
use std::sync::Arc;

use crate::interrupts::Interrupt;

/// What came of one question, or of something that was done to the modules.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Reading {
    /// It was done.
    Done,
    /// Whether it could be done.
    Could(bool),
    /// A value from a module, if one answers.
    Value(Option<u32>),
    /// Whether modules took a value, and whether one has raised an interrupt.
    Taken { taken: bool, alarms: bool },
    /// The input image, and the bytes of modules that do not answer.
    Image { bytes: Arc<[u8]>, failed: Vec<Range<usize>> },
    /// The output bytes of modules that do not answer.
    Failed(Vec<Range<usize>>),
    /// The interrupts that modules have raised.
    Alarms(Vec<Interrupt>),
}

impl Reading {
    /// Bytes that it takes.
    pub(crate) fn bytes(&self) -> usize {
        size_of::<Self>()
            + match self {
                Self::Image { bytes, failed } => bytes.len() + failed.len() * size_of::<Range<usize>>(),
                Self::Failed(failed) => failed.len() * size_of::<Range<usize>>(),
                Self::Alarms(alarms) => alarms.len() * size_of::<Interrupt>(),
                Self::Done | Self::Could(_) | Self::Value(_) | Self::Taken { .. } => 0,
            }
    }
}

/// A recording of readings. Where it has been taken back it plays; at its end it records.
#[derive(Debug, Default)]
pub(crate) struct Tape {
    on: bool,
    /// Whoever hears it may ask in another order than the one it was recorded of.
    is_loose: bool,
    readings: VecDeque<Reading>,
    /// Readings before the first one that is kept.
    dropped: u64,
    /// The next reading, counted over all.
    next: u64,
    bytes: usize,
    last_image: Option<Arc<[u8]>>,
}

impl Tape {
    /// Begins to record.
    pub(crate) fn start(&mut self) {
        self.on = true;
    }

    /// A tape that plays these readings to a run that may be another one.
    pub(crate) fn of(readings: Vec<Reading>) -> Self {
        Self { on: true, is_loose: true, readings: readings.into(), ..Self::default() }
    }

    /// Ends what [`Self::start`] began: what was recorded since a position, which is forgotten unless the tape was on before.
    pub(crate) fn cut(&mut self, since: u64, was_on: bool) -> Vec<Reading> {
        let first = usize::try_from(since.saturating_sub(self.dropped)).unwrap_or(usize::MAX);
        let readings = self.readings.iter().skip(first).cloned().collect();
        if !was_on {
            *self = Self::default();
        }
        readings
    }

    /// What is said to a question that was another one when it was recorded.
    ///
    /// # Panics
    /// If this is a run that has gone back: the CPU asks in the same order each time it runs the same way.
    pub(crate) fn unexpected<T: Default>(&self, reading: &Reading) -> T {
        assert!(self.is_loose, "a run that has gone back asks its modules what it asked before, but {reading:?} was recorded here");
        T::default()
    }

    pub(crate) fn is_on(&self) -> bool {
        self.on
    }

    /// Where it stands.
    pub(crate) fn position(&self) -> u64 {
        self.next
    }

    /// Bytes that the recording takes, without those of images that it has several times.
    pub(crate) fn bytes(&self) -> usize {
        self.bytes
    }

    /// Takes it back, or on again.
    pub(crate) fn go_to(&mut self, position: u64) {
        self.next = position.clamp(self.dropped, self.dropped + self.readings.len() as u64);
    }

    /// Forgets what lies before a position.
    pub(crate) fn forget_before(&mut self, position: u64) {
        while self.dropped < position.min(self.next)
            && let Some(reading) = self.readings.pop_front()
        {
            self.bytes -= self.cost(&reading).min(self.bytes);
            self.dropped += 1;
        }
    }

    /// The reading that was recorded here, if the tape plays.
    pub(crate) fn play(&mut self) -> Option<Reading> {
        let reading = self.readings.get(usize::try_from(self.next - self.dropped).ok()?)?.clone();
        self.next += 1;
        Some(reading)
    }

    /// Records a reading, if it is on.
    pub(crate) fn record(&mut self, reading: &Reading) {
        if self.on {
            self.bytes += self.cost(reading);
            self.readings.push_back(reading.clone());
            self.next += 1;
        }
    }

    /// The image to record: the last one, if it is the same.
    pub(crate) fn image(&mut self, image: &[u8]) -> Arc<[u8]> {
        match &self.last_image {
            Some(last) if **last == *image => Arc::clone(last),
            _ => {
                let new: Arc<[u8]> = Arc::from(image);
                self.last_image = Some(Arc::clone(&new));
                new
            }
        }
    }

    fn cost(&self, reading: &Reading) -> usize {
        match reading {
            // One that others share costs nothing more.
            Reading::Image { bytes, failed } if Arc::strong_count(bytes) > 2 => size_of::<Reading>() + failed.len() * 16,
            reading => reading.bytes(),
        }
    }
}
