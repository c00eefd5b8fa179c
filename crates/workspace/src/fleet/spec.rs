//! What the file of a fleet says, as data; names of programs are not looked up yet.

use sieben_campaign::spec::Placed;
use sieben_model::source::Span;

use super::endpoint::Endpoint;

/// All that the file says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spec {
    /// `fleet.name`; the name of the file where it is left out.
    pub name: Option<String>,
    /// `fleet.cycle`: from one scan of a controller to the next, in microseconds.
    pub cycle_us: Option<u64>,
    /// `fleet.seed`: what the plants of all controllers draw from.
    pub seed: u64,
    /// `[[controller]]`; at least one.
    pub controllers: Vec<Controllers>,
    /// `[[link]]`.
    pub links: Vec<Link>,
}

/// Controllers that run the same program.
#[derive(Clone, Debug, PartialEq)]
pub struct Controllers {
    /// What they are called: `station`.
    pub name: Placed,
    /// How many there are; none = a single one, which is called without a number.
    pub count: Option<u32>,
    /// The path of the program, as it is written.
    pub program: Placed,
}

/// What goes from one controller to another.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// Where it comes from.
    pub from: Endpoint,
    /// Where it goes.
    pub to: Endpoint,
    /// How long it is under way, in microseconds; at least [`LATENCY_US_MIN`].
    pub latency_us: u64,
    /// Where all of it stands.
    pub span: Span,
}

/// Most controllers of a fleet.
pub const CONTROLLERS_MAX: u32 = 100_000;
/// Most links of a fleet; a link between groups counts once.
pub const LINKS_MAX: usize = 1000;
/// Shortest time that a link takes, in microseconds: controllers run so long without looking at one another.
pub const LATENCY_US_MIN: u64 = 1000;
/// Longest time that a link takes, in microseconds: what is under way has to be kept.
pub const LATENCY_US_MAX: u64 = 60_000_000;

impl Controllers {
    /// How many there are.
    pub fn len(&self) -> u32 {
        self.count.unwrap_or(1)
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// What one of them is called.
    pub fn name_of(&self, index: u32) -> String {
        match self.count {
            Some(_) => format!("{}[{index}]", self.name.text),
            None => self.name.text.clone(),
        }
    }
}
