//! What a campaign is asked for, as data: the keys of its file, read and judged for themselves; names of the program are not looked up yet.

use sieben_model::source::{FileId, Span};
pub use sieben_sim::scenario::property::PropertyKind;
use sieben_sim::wrap::FaultKind;

/// A string with its place in the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// The string.
    pub text: String,
    /// Where it stands: of an expression of one line the characters inside of its quotes, so that a place in it can be found.
    pub span: Span,
}

/// A value as the file has it.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// `true` or `false`.
    Boolean(bool),
    /// A number; it becomes that of the type which it goes to.
    Number(f64),
    /// Anything in the notation of the languages: `"T#5s"`, `"16#FF"`.
    Text(String),
}

/// All that the file says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spec {
    /// `campaign.name`; the name of the file where it is left out.
    pub name: Option<String>,
    /// `campaign.program`, or all of `matrix.program`: paths, as they are written; at least one.
    pub programs: Vec<Placed>,
    /// `campaign.for`: how long a scenario runs, in microseconds of virtual time.
    pub for_us: Option<u64>,
    /// `campaign.seed`.
    pub seed: u64,
    /// `campaign.samples`: draws at each point of the grid; at least 1.
    pub samples: u64,
    /// `campaign.settle`: time without faults at the end, in microseconds, beyond `for`.
    pub settle_us: u64,
    /// `campaign.keep`.
    pub keep: Option<Keep>,
    /// `campaign.replay`: a recorded scenario.
    pub replay: Option<Replay>,
    /// `[exhaustive]`.
    pub exhaustive: Option<Exhaustive>,
    /// `[set]`: values before the first scan.
    pub set: Vec<Set>,
    /// `[sweep]`: the grid; the last one runs fastest.
    pub sweep: Vec<Sweep>,
    /// `[draw]`: what is drawn in each scenario.
    pub draw: Vec<Draw>,
    /// `[[fault]]`.
    pub faults: Vec<FaultRow>,
    /// `[disturb]`.
    pub disturb: Option<Disturb>,
    /// `[swarm] faults = true`: each scenario draws first which faults are possible at all.
    pub swarm_faults: bool,
    /// `[[never]]`, `[[always]]`, `[[sometimes]]`, `[[response]]`, `[[finally]]`, `[[same]]`, in the order of the file.
    pub properties: Vec<Property>,
    /// `[[measure]]`.
    pub measures: Vec<Measure>,
}

impl Spec {
    /// What has one value in each scenario: the names of sweeps and of draws that do not walk, with their units, and the values that are possible.
    pub fn parameters(&self) -> impl Iterator<Item = Parameter<'_>> {
        let swept = self.sweep.iter().map(|Sweep { name, values, unit }| Parameter {
            name: &name.text,
            values: Some(values),
            unit: unit.as_deref(),
        });
        let drawn = self.draw.iter().filter_map(|Draw { name, drawn, unit }| {
            let values = match drawn {
                Drawn::Once(_) => None,
                Drawn::Choice(values) => Some(values),
                Drawn::Walk(_) => return None,
            };
            Some(Parameter { name: &name.text, values, unit: unit.as_deref() })
        });
        swept.chain(drawn)
    }

    /// Where what is said of all of it stands.
    pub fn span(&self) -> Span {
        self.programs.first().map_or(Span::new(FileId(0), 0, 0), |program| program.span)
    }
}

/// What has one value in each scenario.
#[derive(Clone, Copy, Debug)]
pub struct Parameter<'s> {
    /// Its name.
    pub name: &'s str,
    /// The values that are possible; none = any number.
    pub values: Option<&'s Vec<Value>>,
    /// Its unit, for reports.
    pub unit: Option<&'s str>,
}

/// Which scenarios have a row in the result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keep {
    /// All of them.
    All,
    /// Those that did not pass.
    Failures,
}

impl Keep {
    const ALL: [(Self, &'static str); 2] = [(Self::All, "all"), (Self::Failures, "failures")];

    /// The word of files.
    pub fn word(self) -> &'static str {
        Self::ALL.iter().find(|(keep, _)| *keep == self).map_or("", |(_, word)| word)
    }

    /// What a word means.
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.iter().find(|(_, known)| *known == word).map(|&(keep, _)| keep)
    }
}

/// `campaign.replay` and what belongs to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Replay {
    /// The path of the scenario, as it is written.
    pub scenario: Placed,
    /// `campaign.within`, in microseconds.
    pub within_us: u64,
    /// `campaign.tolerance`.
    pub tolerance: Option<f64>,
    /// `campaign.ignore`: names or patterns.
    pub ignore: Vec<String>,
}

/// `[exhaustive]`: every combination of bits, each from the state after the start.
#[derive(Clone, Debug, PartialEq)]
pub struct Exhaustive {
    /// The block whose inputs they are; none = the cycle, that is OB 1.
    pub block: Option<Placed>,
    /// The bits: names, addresses or ranges of addresses (`I 0.0..I 1.3`). The first is bit 0 of the number.
    pub inputs: Vec<Placed>,
}

/// A name with the value that it gets.
#[derive(Clone, Debug, PartialEq)]
pub struct Set {
    /// The name.
    pub name: Placed,
    /// The value.
    pub value: Value,
}

/// A name with all values that it goes through.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// The name of the program, or `PLANT.PARAMETER`.
    pub name: Placed,
    /// The values; at least one.
    pub values: Vec<Value>,
    /// The unit, for reports.
    pub unit: Option<String>,
}

/// A name with what is drawn for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Draw {
    /// The name of the program, or `PLANT.PARAMETER`.
    pub name: Placed,
    /// What is drawn.
    pub drawn: Drawn,
    /// The unit, for reports.
    pub unit: Option<String>,
}

/// What is drawn for a name.
#[derive(Clone, Debug, PartialEq)]
pub enum Drawn {
    /// One value for the whole scenario.
    Once(Law),
    /// One of these values.
    Choice(Vec<Value>),
    /// A walk: a new value again and again.
    Walk(Walk),
}

/// A distribution of numbers; of times in microseconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// Always this.
    Fixed(f64),
    /// From the first up to, but not including, the second.
    Uniform(f64, f64),
    /// Mean and standard deviation.
    Normal(f64, f64),
    /// As `Uniform`, of the logarithm; both are greater than 0.
    LogUniform(f64, f64),
}

/// `walk = { every = "2s", chance = 0.1 }`: a bit changes at such times with such a chance; a number moves by `step` then, within its limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Walk {
    /// From one chance to the next, in microseconds.
    pub every_us: u64,
    /// How likely a change is.
    pub chance: f64,
    /// By how much a number moves, up or down; a bit has none.
    pub step: Option<f64>,
    /// The least value of a number.
    pub least: f64,
    /// The greatest value of a number.
    pub most: f64,
}

/// `[[fault]]`.
#[derive(Clone, Debug, PartialEq)]
pub struct FaultRow {
    /// What its draws are called: its `name`, else the signal with how many rows of that signal are before it.
    pub stream: String,
    /// How likely it is in a scenario.
    pub chance: f64,
    /// The signal: `PLANT.SIGNAL`.
    pub signal: Placed,
    /// The kinds of which one is drawn; at least one.
    pub kinds: Vec<FaultKind>,
    /// When it begins, in microseconds.
    pub from: Law,
    /// How long it lasts, in microseconds; none = to the end.
    pub lasts: Option<Law>,
}

/// `[disturb]`: what happens to the inputs of a recording.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Disturb {
    /// By how much each line is moved in time, in microseconds.
    pub time: Option<Law>,
    /// How likely a changed bit bounces, and for how many microseconds.
    pub bounce: Option<(f64, u64)>,
    /// What is added to words.
    pub value: Option<Law>,
}

/// What has to hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Property {
    /// Its kind.
    pub kind: PropertyKind,
    /// What reports call it.
    pub name: String,
    /// Where it stands: its name, or its table.
    pub span: Span,
    /// The expression: `expr`, of a response `when`.
    pub expression: Placed,
    /// `then` of a response.
    pub then: Option<Placed>,
    /// `within` of a response, in microseconds.
    pub within_us: u64,
}

/// What is measured in each scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// What its column is called.
    pub name: String,
    /// Where it stands.
    pub span: Span,
    /// What of it.
    pub of: Of,
    /// The expression: a number, or a Boolean for what counts.
    pub expression: Placed,
    /// The unit, for reports.
    pub unit: Option<String>,
}

/// What is made of the values of an expression after all scans.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// The least value.
    Min,
    /// The greatest value.
    Max,
    /// The last value.
    Last,
    /// The mean over time.
    Mean,
    /// The sum over time, in units times seconds.
    Integral,
    /// Scans in which it is true.
    Count,
    /// How often it became true.
    Rises,
    /// When it was true first, in seconds; nothing if it never was.
    FirstTime,
}

impl Of {
    /// All of them with their words.
    pub const ALL: &[(Self, &'static str)] = &[
        (Self::Min, "min"),
        (Self::Max, "max"),
        (Self::Last, "last"),
        (Self::Mean, "mean"),
        (Self::Integral, "integral"),
        (Self::Count, "count"),
        (Self::Rises, "rises"),
        (Self::FirstTime, "first_time"),
    ];

    /// The word of files.
    pub fn word(self) -> &'static str {
        Self::ALL.iter().find(|(of, _)| *of == self).map_or("", |(_, word)| word)
    }

    /// What a word means.
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.iter().find(|(_, known)| *known == word).map(|&(of, _)| of)
    }

    /// Whether its expression is Boolean.
    pub fn counts(self) -> bool {
        matches!(self, Self::Count | Self::Rises | Self::FirstTime)
    }
}
