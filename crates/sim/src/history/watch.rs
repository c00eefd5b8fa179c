//! Breakpoints: at a statement, when a value changes, when a condition becomes true.

use std::cmp::Ordering;

use sieben_engine::machine::Registers;
use sieben_engine::{FaultPlace, Machine, StatementEvent};

use super::drive::Watch;
use crate::names::{Name, NameError};

/// How a condition compares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// `=`
    Equal,
    /// `<>`
    NotEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
}

impl Relation {
    /// All of them with their signs, longer signs first.
    pub const ALL: [(&'static str, Self); 8] = [
        ("<>", Self::NotEqual),
        ("!=", Self::NotEqual),
        (">=", Self::GreaterOrEqual),
        ("<=", Self::LessOrEqual),
        ("==", Self::Equal),
        (">", Self::Greater),
        ("<", Self::Less),
        ("=", Self::Equal),
    ];

    fn holds(self, ordering: Option<Ordering>) -> bool {
        match self {
            Self::Equal => ordering == Some(Ordering::Equal),
            Self::NotEqual => ordering != Some(Ordering::Equal),
            Self::Greater => ordering == Some(Ordering::Greater),
            Self::GreaterOrEqual => matches!(ordering, Some(Ordering::Greater | Ordering::Equal)),
            Self::Less => ordering == Some(Ordering::Less),
            Self::LessOrEqual => matches!(ordering, Some(Ordering::Less | Ordering::Equal)),
        }
    }
}

/// `MW10 > 5`.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    name: Name,
    relation: Relation,
    bits: u64,
}

impl Condition {
    /// Reads `MW10 > 5`; `parse` reads the name.
    ///
    /// # Errors
    /// It is no comparison, or the name or the value are of no use.
    pub fn parse(text: &str, parse: impl FnOnce(&str) -> Result<Name, NameError>) -> Result<Self, NameError> {
        let found = text.char_indices().find_map(|(at, _)| {
            let sign = Relation::ALL.iter().find(|(sign, _)| text[at..].starts_with(sign))?;
            Some((at, sign))
        });
        let Some((at, &(sign, relation))) = found else {
            return Err(NameError::new(format!("`{text}` is no condition; write a name, one of =, <>, >, >=, <, <= and a value")));
        };
        let name = parse(text[..at].trim())?;
        let bits = name.value(text[at + sign.len()..].trim())?;
        Ok(Self { name, relation, bits })
    }

    /// Whether it holds.
    pub fn holds(&self, machine: &Machine, registers: &Registers) -> bool {
        let value = self.name.bits_in(machine, registers);
        value.is_some_and(|value| self.relation.holds(self.name.compare(value, self.bits)))
    }
}

/// What a breakpoint waits for.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// Before one of these statements of a block: the first and the last.
    Statement(FaultPlace, u32),
    /// A value changes, whoever changes it.
    Change(Name),
    /// A condition becomes true.
    Condition(Condition),
}

/// A breakpoint.
#[derive(Clone, Debug)]
pub struct Breakpoint {
    /// Its number, from 1.
    pub number: u32,
    /// As the user wrote it.
    pub text: String,
    /// What it waits for.
    pub target: Target,
    /// It pauses only while this holds.
    pub only_if: Option<Condition>,
    /// It pauses at every so many-th time; 1 = every time.
    pub every: u64,
    /// How often what it waits for has happened since the breakpoint was set, going forwards.
    pub times: u64,
}

/// A breakpoint that pauses the run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hit {
    /// The number of the breakpoint.
    pub number: u32,
    /// The bits before and after, of a value that has changed.
    pub change: Option<(Option<u64>, Option<u64>)>,
    /// The statement that did it: the last one, or the one whose call has returned and that goes on. `None` if it was none: the process image,
    /// a value set from outside, or the CPU itself.
    pub by: Option<FaultPlace>,
}

/// What is remembered of a breakpoint from statement to statement.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    value: Option<u64>,
    held: bool,
}

/// Breakpoints as a watcher.
pub struct Breakpoints<'b> {
    breakpoints: &'b mut [Breakpoint],
    seen: Vec<Seen>,
    registers: Registers,
    /// The last statement of every block that runs, outermost first.
    running: Vec<Option<FaultPlace>>,
    /// Those that wanted the pause.
    pub hits: Vec<Hit>,
}

impl<'b> Breakpoints<'b> {
    /// Watches for these; the registers are those at the beginning of the movement.
    pub fn new(breakpoints: &'b mut [Breakpoint], registers: &Registers) -> Self {
        Self { breakpoints, seen: Vec::new(), registers: registers.clone(), running: Vec::new(), hits: Vec::new() }
    }

    fn look(&mut self, machine: &Machine, place: Option<FaultPlace>, by: Option<FaultPlace>) -> bool {
        let mut hits = Vec::new();
        for (breakpoint, seen) in self.breakpoints.iter_mut().zip(&mut self.seen) {
            let (happened, change) = match &breakpoint.target {
                Target::Statement(first, last) => {
                    let here =
                        place.is_some_and(|place| place.block == first.block && (first.statement..=*last).contains(&place.statement));
                    (here, None)
                }
                Target::Change(name) => {
                    let value = name.bits_in(machine, &self.registers);
                    let before = std::mem::replace(&mut seen.value, value);
                    (before != value, Some((before, value)))
                }
                Target::Condition(condition) => {
                    let holds = condition.holds(machine, &self.registers);
                    let held = std::mem::replace(&mut seen.held, holds);
                    (holds && !held, None)
                }
            };
            if !happened || breakpoint.only_if.as_ref().is_some_and(|condition| !condition.holds(machine, &self.registers)) {
                continue;
            }
            breakpoint.times += 1;
            if breakpoint.times.is_multiple_of(breakpoint.every.max(1)) {
                hits.push(Hit { number: breakpoint.number, change, by });
            }
        }
        if hits.is_empty() {
            return false;
        }
        self.hits = hits;
        true
    }
}

impl Watch for Breakpoints<'_> {
    fn begin(&mut self, machine: &Machine) {
        let registers = &self.registers;
        let seen = |breakpoint: &Breakpoint| match &breakpoint.target {
            Target::Statement(..) => Seen::default(),
            Target::Change(name) => Seen { value: name.bits_in(machine, registers), held: false },
            Target::Condition(condition) => Seen { value: None, held: condition.holds(machine, registers) },
        };
        self.seen = self.breakpoints.iter().map(seen).collect();
        self.running.clear();
    }

    fn before(&mut self, machine: &Machine, place: FaultPlace) -> bool {
        let depth = machine.frames.len().max(1);
        // A statement that calls goes on when the block has ended, with what it does with the result.
        let returned = if self.running.len() > depth { self.running[depth - 1] } else { None };
        self.running.resize(depth, None);
        self.running[depth - 1] = Some(place);
        self.look(machine, Some(place), returned)
    }

    fn after(&mut self, machine: &Machine, event: &StatementEvent) -> bool {
        self.registers.clone_from(&event.after);
        self.look(machine, None, Some(event.place))
    }
}
