//! Power flow: what each line of a diagram carries at one moment, from what its statements did.
//!
//! Lines from the rail and at the start of a branch carry 1; after a contact the line before AND the contact; after branches in parallel the
//! line before AND any of them; after a box its ENO or Q. What was not executed carries nothing.

use sieben_lang::network::model::Place;

use super::layout::{Gate, Layout, Net, NetId};

/// What a line carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flow {
    /// 1.
    One,
    /// 0.
    Zero,
    /// The statements that make it were not executed.
    NotRun,
    /// Nothing is known.
    Unknown,
}

impl Flow {
    /// All of them, with the word that `data-flow` and the classes of a picture say.
    pub const ALL: [(Self, &'static str); 4] = [(Self::One, "1"), (Self::Zero, "0"), (Self::NotRun, "not-run"), (Self::Unknown, "unknown")];

    /// The word that `data-flow` says.
    pub fn word(self) -> &'static str {
        Self::ALL.iter().find(|row| row.0 == self).map_or("unknown", |row| row.1)
    }

    fn of(value: Option<bool>) -> Self {
        match value {
            Some(true) => Self::One,
            Some(false) => Self::Zero,
            None => Self::Unknown,
        }
    }

    fn negated(self) -> Self {
        match self {
            Self::One => Self::Zero,
            Self::Zero => Self::One,
            other => other,
        }
    }

    /// 0 decides; then what was not executed, then what is unknown.
    fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Zero, _) | (_, Self::Zero) => Self::Zero,
            (Self::NotRun, _) | (_, Self::NotRun) => Self::NotRun,
            (Self::Unknown, _) | (_, Self::Unknown) => Self::Unknown,
            _ => Self::One,
        }
    }

    /// 1 decides; branches that were not executed say nothing.
    fn or(self, other: Self) -> Self {
        match (self, other) {
            (Self::One, _) | (_, Self::One) => Self::One,
            (Self::Unknown, _) | (_, Self::Unknown) => Self::Unknown,
            (Self::Zero, _) | (_, Self::Zero) => Self::Zero,
            _ => Self::NotRun,
        }
    }

    fn xor(self, other: Self) -> Self {
        match (self, other) {
            (Self::NotRun, other) | (other, Self::NotRun) => other,
            (Self::Unknown, _) | (_, Self::Unknown) => Self::Unknown,
            _ => Self::of(Some((self == Self::One) != (other == Self::One))),
        }
    }
}

/// What the statements of a network did at one moment.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Status {
    /// One for each statement of the network, in their order.
    pub statements: Vec<Executed>,
}

/// What a statement did.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Executed {
    /// It was executed.
    pub ran: bool,
    /// What it found itself: the bit that it checks, before a negation; the result of a comparison; the pulse of an edge. `None` for all others.
    pub found: Option<bool>,
    /// The result of logic after a check of a bit.
    pub logic: Option<bool>,
    /// Values: of an operand by what is written, of a pin by its name.
    pub values: Vec<(String, String)>,
}

/// What is written where nothing was executed.
pub const NO_VALUE: &str = "–";

impl Status {
    /// The statements of a place.
    fn of(&self, place: Place) -> &[Executed] {
        let count = self.statements.len();
        let from = (place.first as usize).min(count);
        let to = (place.last as usize).saturating_add(1).clamp(from, count);
        &self.statements[from..to]
    }

    /// A statement of the network was executed.
    fn ran_at_all(&self) -> Flow {
        if self.statements.iter().any(|one| one.ran) { Flow::One } else { Flow::NotRun }
    }

    /// A statement of the place was executed.
    fn ran(&self, place: Place) -> Flow {
        match self.of(place) {
            [] => Flow::Unknown,
            [first, ..] if first.ran => Flow::One,
            _ => Flow::NotRun,
        }
    }

    /// What the last statement of a place that finds something found.
    fn found(&self, place: Place) -> Flow {
        let statements = self.of(place);
        match statements.iter().rev().find(|one| one.ran && one.found.is_some()) {
            Some(one) => Flow::of(one.found),
            None if statements.iter().any(|one| one.ran) || statements.is_empty() => Flow::Unknown,
            None => Flow::NotRun,
        }
    }

    /// The result of logic after the statement of a place; `None` if there is no such statement. None of them is the first of its network.
    fn logic(&self, place: Place) -> Option<Flow> {
        let [only] = self.of(place) else { return None };
        match (place.last, only.ran) {
            (0, _) => None,
            (_, false) => Some(Flow::NotRun),
            (_, true) => only.logic.map(|logic| Flow::of(Some(logic))),
        }
    }

    /// The value of an operand or pin of an element.
    pub(super) fn value(&self, place: Place, name: &str) -> Option<String> {
        let statements = self.of(place);
        let with_value = statements.iter().filter(|one| one.ran).flat_map(|one| &one.values).find(|(own, _)| own == name);
        match with_value {
            Some((_, value)) => (value != name).then(|| sieben_model::visible::name(value)),
            None => (!statements.is_empty() && statements.iter().all(|one| !one.ran)).then(|| NO_VALUE.to_owned()),
        }
    }
}

/// What each net of a diagram carries; without a status nothing is known of any.
pub fn flows(layout: &Layout, status: Option<&Status>) -> Vec<Flow> {
    let Some(status) = status else { return vec![Flow::Unknown; layout.nets.len()] };
    let rail = status.ran_at_all();
    let mut flows: Vec<Flow> = Vec::with_capacity(layout.nets.len());
    for net in &layout.nets {
        let of = |id: &NetId| flows.get(id.0 as usize).copied().unwrap_or(Flow::Unknown);
        let flow = match net {
            Net::Rail => rail,
            Net::Start(place) => status.ran(*place),
            Net::After { before, place, negated } => {
                let found = status.found(*place);
                let own = if *negated { found.negated() } else { found };
                if own == Flow::NotRun { own } else { of(before).and(own) }
            }
            Net::Found(place) => status.found(*place),
            Net::Tapped { before, place } => status.logic(*place).unwrap_or_else(|| of(before)),
            Net::Not(before) => of(before).negated(),
            Net::Join { before, branches } => branches.iter().map(of).fold(Flow::NotRun, Flow::or).and(of(before)),
            Net::Gate { gate, inputs } => {
                let inputs = inputs.iter().map(|(id, negated)| if *negated { of(id).negated() } else { of(id) });
                match gate {
                    Gate::And => inputs.fold(Flow::One, Flow::and),
                    Gate::Or => inputs.fold(Flow::NotRun, Flow::or),
                    Gate::Xor => inputs.fold(Flow::NotRun, Flow::xor),
                }
            }
        };
        flows.push(flow);
    }
    flows
}
