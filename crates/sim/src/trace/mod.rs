//! Traces: the values of chosen channels, one sample per scan, kept as changes.
//!
//! A [`Recorder`] looks at a CPU behind every scan and writes blocks of changes to a [`Store`]; what is kept in memory does not grow with
//! the length of the trace. A finished [`Trace`] is read from its blocks again, scan by scan, with [`Trace::visit`].

mod code;
pub mod csv;
pub mod moment;
pub mod recorder;
pub mod recording;
pub mod store;
mod summary;
pub mod trigger;
pub mod vcd;

use std::fmt;
use std::ops::RangeInclusive;

pub use moment::Moment;
pub use recorder::{Keep, Recorder};
pub use store::{Memory, Store, StoreError};
pub use summary::Summary;
pub use trigger::Trigger;

use crate::names::{Kind, Name, Sample};

/// Most channels of a trace: more than anyone looks at, few enough that one scan of all of them fits into a block.
pub const CHANNELS_MAX: usize = 4096;

/// Most scans of a trace: eleven days at a cycle of 10 ms.
pub const SCANS_MAX: u64 = 100_000_000;

/// One thing that is recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// As the user calls it.
    pub name: String,
    /// How its values are shown.
    pub kind: Kind,
}

impl Channel {
    /// The channel of a name.
    pub fn new(name: &Name) -> Self {
        Self { name: name.text().to_owned(), kind: name.recorded() }
    }
}

/// Which program was recorded, and where.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Origin {
    /// What the program is called: files or a project.
    pub title: String,
    /// A number that another program hardly has; 0 if nobody asked.
    pub program: u64,
    /// The CPU type.
    pub cpu: String,
}

/// A number for the sources of a program, without regard to their order and to blanks: another one for nearly every other program.
pub fn identity<'a>(texts: impl IntoIterator<Item = &'a str>) -> u64 {
    // FNV-1a; the sum does not know an order.
    let hash = |text: &str| {
        let words = text.split_whitespace().flat_map(|word| word.bytes().chain([b' ']));
        words.fold(0xCBF2_9CE4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01B3))
    };
    texts.into_iter().fold(0, |sum, text| sum.wrapping_add(hash(text)))
}

/// Some scans in a row that saw the same values.
#[derive(Clone, Copy, Debug)]
pub struct Scans<'a> {
    /// The first of them.
    pub first: Moment,
    /// How many they are, at least 1.
    pub count: u64,
    /// The time from one of them to the next, in microseconds.
    pub step_us: u64,
    /// The values of all channels.
    pub values: &'a [Sample],
    /// The channels whose value the first of these scans changed; at the beginning of a visit all of them.
    pub changed: &'a [usize],
}

impl Scans<'_> {
    /// Each of the scans.
    pub fn moments(&self) -> impl Iterator<Item = Moment> {
        let (first, step_us) = (self.first, self.step_us);
        (0..self.count)
            .map(move |index| Moment { scan: first.scan + index, time_us: first.time_us.saturating_add(step_us.saturating_mul(index)) })
    }

    /// The last of the scans.
    pub fn last(&self) -> Moment {
        let further = self.count - 1;
        Moment {
            scan: self.first.scan.saturating_add(further),
            time_us: self.first.time_us.saturating_add(self.step_us.saturating_mul(further)),
        }
    }

    /// Those of the scans whose numbers are in a range.
    fn within(self, range: &RangeInclusive<u64>) -> Option<Self> {
        let (first, last) = (self.first.scan.max(*range.start()), self.last().scan.min(*range.end()));
        let skipped = first - self.first.scan;
        (first <= last).then(|| Self {
            first: Moment { scan: first, time_us: self.first.time_us.saturating_add(self.step_us.saturating_mul(skipped)) },
            count: last - first + 1,
            ..self
        })
    }
}

/// Why a trace cannot be written or read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TraceError {
    /// Its store does not take or give what it should.
    Store(StoreError),
    /// It is no recording, or damaged; what is wrong, in one sentence.
    Damaged(String),
    /// What was rendered from it cannot be written.
    Output,
    /// It would have more than [`SCANS_MAX`] scans.
    TooLong,
}

impl fmt::Display for TraceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Store(error) => error.fmt(f),
            Self::Damaged(what) => f.write_str(what),
            Self::Output => f.write_str("the output cannot be written"),
            Self::TooLong => write!(f, "the trace has more than {SCANS_MAX} scans; take a longer cycle or a trigger"),
        }
    }
}

impl std::error::Error for TraceError {}

impl From<StoreError> for TraceError {
    fn from(error: StoreError) -> Self {
        Self::Store(error)
    }
}

impl From<fmt::Error> for TraceError {
    fn from(_: fmt::Error) -> Self {
        Self::Output
    }
}

/// A finished trace.
pub struct Trace {
    origin: Origin,
    channels: Vec<Channel>,
    summary: Summary,
    trigger: Option<Moment>,
    whole: bool,
    blocks: Vec<recording::Block>,
    store: Box<dyn Store>,
}

impl fmt::Debug for Trace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Trace").field("channels", &self.channels).field("summary", &self.summary).finish_non_exhaustive()
    }
}

impl Trace {
    /// Which program was recorded.
    pub fn origin(&self) -> &Origin {
        &self.origin
    }

    /// What was recorded.
    pub fn channels(&self) -> &[Channel] {
        &self.channels
    }

    /// How much was recorded.
    pub fn summary(&self) -> &Summary {
        &self.summary
    }

    /// The scan in which the trigger came.
    pub fn trigger(&self) -> Option<Moment> {
        self.trigger
    }

    /// Whether the trace was finished; one that was cut off has only its first blocks.
    pub fn is_whole(&self) -> bool {
        self.whole
    }

    /// All scans.
    pub fn all(&self) -> RangeInclusive<u64> {
        self.summary.first.scan..=self.summary.last.scan
    }

    /// Shows all scans of a range, in their order.
    ///
    /// # Errors
    /// The store or the visitor fails.
    pub fn visit(&self, range: &RangeInclusive<u64>, see: &mut dyn FnMut(&Scans<'_>) -> Result<(), TraceError>) -> Result<(), TraceError> {
        let every: Vec<usize> = (0..self.channels.len()).collect();
        let mut decoder = code::Decoder::new(&self.channels);
        let mut begun = false;
        // A block begins with the values of all channels, so those before the range are not read.
        let first = self.blocks.iter().rposition(|block| block.first_scan <= *range.start()).unwrap_or(0);
        for block in &self.blocks[first.min(self.blocks.len())..] {
            if block.first_scan > *range.end() {
                break;
            }
            let bytes = recording::read_block(&*self.store, block)?;
            decoder.block(&bytes, &mut |scans| {
                let Some(mut scans) = scans.within(range) else { return Ok(()) };
                if !begun {
                    begun = true;
                    scans.changed = &every;
                }
                see(&scans)
            })?;
        }
        Ok(())
    }
}
