//! Breakpoints: at a statement, when a value changes, when a condition becomes true.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use sieben_engine::machine::Registers;
use sieben_engine::{FaultPlace, Machine, StatementEvent, Stored};
use sieben_model::block::BlockId;
use sieben_model::value::Content;

use super::drive::Watch;
use super::plan::Action;
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
        let text = text[at + sign.len()..].trim();
        let Content::Bits(bits) = name.value(text)?.content else {
            return Err(NameError::new(format!("`{}` has more than 64 bits, so it can only change", name.text())));
        };
        Ok(Self { name, relation, bits })
    }

    /// The value that is compared.
    pub fn name(&self) -> &Name {
        &self.name
    }

    /// Whether it holds.
    pub fn holds(&self, machine: &Machine, registers: &Registers) -> bool {
        let value = self.name.bits_in(machine, registers);
        value.is_some_and(|value| self.relation.holds(self.name.kind().compare(value, self.bits)))
    }
}

/// What a breakpoint waits for.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// Before one of these statements of a block: the first and the last.
    Statement(FaultPlace, u32),
    /// A value changes, whoever changes it.
    Change(Name),
    /// A value is written, even with what it was before.
    Write(Name),
    /// A condition becomes true.
    Condition(Condition),
}

impl Target {
    /// The value that is looked at.
    pub fn name(&self) -> Option<&Name> {
        match self {
            Self::Change(name) | Self::Write(name) => Some(name),
            Self::Condition(condition) => Some(&condition.name),
            Self::Statement(..) => None,
        }
    }
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

/// Who did something to a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// A statement: the last one, or the one whose call has returned and that goes on.
    Statement(FaultPlace),
    /// The process image of the inputs, which was read at the beginning of a scan.
    ProcessImage,
    /// Somebody set it from outside.
    Set,
    /// The CPU itself: it cleared memory, a timer ran on, a module answered.
    Cpu,
}

/// A breakpoint that pauses the run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hit {
    /// The number of the breakpoint.
    pub number: u32,
    /// The bits before and after, of a value that has changed or was written.
    pub change: Option<(Option<u64>, Option<u64>)>,
    /// Who did it.
    pub by: By,
}

/// What is remembered of a breakpoint from statement to statement.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    value: Option<u64>,
    held: bool,
    /// Something was stored where the value lies.
    stored: bool,
    /// What came from outside since the last statement.
    outside: Option<By>,
}

/// Statements that store something only where the RLO is 1: `S` and `R`.
pub type StoreIfRlo = BTreeSet<(BlockId, u32)>;

/// Breakpoints as a watcher.
pub struct Breakpoints<'b> {
    breakpoints: &'b mut [Breakpoint],
    if_rlo: &'b StoreIfRlo,
    seen: Vec<Seen>,
    registers: Registers,
    /// The last statement of every block that runs, outermost first.
    running: Vec<Option<FaultPlace>>,
    /// Those that wanted the pause.
    pub hits: Vec<Hit>,
}

/// A moment at which breakpoints are looked at.
struct Now {
    /// The statement that comes next.
    place: Option<FaultPlace>,
    /// The statement that did what has happened.
    by: Option<FaultPlace>,
    /// It stores nothing, whatever it did to the memory.
    idle: bool,
    /// Variables of this block are where its registers say; `None` = of all that run.
    only: Option<BlockId>,
}

impl<'b> Breakpoints<'b> {
    /// Watches for these.
    pub fn new(breakpoints: &'b mut [Breakpoint], if_rlo: &'b StoreIfRlo) -> Self {
        Self { breakpoints, if_rlo, seen: Vec::new(), registers: Registers::fresh(), running: Vec::new(), hits: Vec::new() }
    }

    fn look(&mut self, machine: &Machine, now: &Now) -> bool {
        let mut hits = Vec::new();
        let registers = &self.registers;
        for (breakpoint, seen) in self.breakpoints.iter_mut().zip(&mut self.seen) {
            let outside = seen.outside.take();
            let block = breakpoint.target.name().and_then(Name::block);
            if block.is_some_and(|block| now.only.is_some_and(|only| only != block)) {
                // Told before the next statement, when the registers are its again.
                seen.outside = outside;
                continue;
            }
            let stored = std::mem::take(&mut seen.stored) && !now.idle;
            let (happened, change) = match &breakpoint.target {
                Target::Statement(first, last) => {
                    let here =
                        now.place.is_some_and(|place| place.block == first.block && (first.statement..=*last).contains(&place.statement));
                    (here, None)
                }
                Target::Change(name) | Target::Write(name) => {
                    let value = name.bits_in(machine, registers);
                    // A variable of a block begins and ends with it, which is no change.
                    if block.is_some() && value.is_none() {
                        continue;
                    }
                    let before = std::mem::replace(&mut seen.value, value);
                    let begins = block.is_some() && before.is_none();
                    let is_write = matches!(breakpoint.target, Target::Write(_));
                    // What runs on by itself is not written.
                    let changed = before != value && !begins && !(is_write && name.is_timer());
                    (changed || is_write && stored, Some((before, value)))
                }
                Target::Condition(condition) => {
                    if block.is_some() && condition.name.bits_in(machine, registers).is_none() {
                        continue;
                    }
                    let holds = condition.holds(machine, registers);
                    let held = std::mem::replace(&mut seen.held, holds);
                    (holds && !held, None)
                }
            };
            if !happened || breakpoint.only_if.as_ref().is_some_and(|condition| !condition.holds(machine, registers)) {
                continue;
            }
            breakpoint.times += 1;
            if breakpoint.times.is_multiple_of(breakpoint.every.max(1)) {
                let by = now.by.map_or(outside.unwrap_or(By::Cpu), By::Statement);
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
        self.registers.clone_from(&machine.registers);
        let registers = &self.registers;
        let seen = |breakpoint: &Breakpoint| match &breakpoint.target {
            Target::Statement(..) => Seen::default(),
            Target::Change(name) | Target::Write(name) => Seen { value: name.bits_in(machine, registers), ..Seen::default() },
            Target::Condition(condition) => Seen { held: condition.holds(machine, registers), ..Seen::default() },
        };
        self.seen = self.breakpoints.iter().map(seen).collect();
        self.running.clear();
    }

    fn before(&mut self, machine: &Machine, place: FaultPlace) -> bool {
        self.registers.clone_from(&machine.registers);
        let depth = machine.frames.len().max(1);
        // A statement that calls goes on when the block has ended, with what it does with the result.
        let returned = if self.running.len() > depth { self.running[depth - 1] } else { None };
        self.running.resize(depth, None);
        self.running[depth - 1] = Some(place);
        self.look(machine, &Now { place: Some(place), by: returned, idle: false, only: None })
    }

    fn outside(&mut self, machine: &Machine, action: &Action) {
        for (breakpoint, seen) in self.breakpoints.iter().zip(&mut self.seen) {
            let Some(name) = breakpoint.target.name() else { continue };
            let inputs = &machine.memory.layout.inputs;
            let stored = |stored: &Stored| name.is_stored(machine, &machine.registers, stored);
            match action {
                Action::Scan { .. } if stored(&Stored::Memory { first: inputs.start, bytes: inputs.len(), mask: 0xFF }) => {
                    seen.outside = Some(By::ProcessImage);
                    seen.stored = true;
                }
                Action::Set(set) if set.name.stores(machine).is_some_and(|place| stored(&place)) => {
                    seen.outside = Some(By::Set);
                    seen.stored = true;
                }
                Action::Scan { .. } | Action::Restart(_) | Action::Set(_) => {}
            }
        }
    }

    fn stores(&mut self, machine: &Machine, stored: Stored) {
        for (breakpoint, seen) in self.breakpoints.iter().zip(&mut self.seen) {
            if let Target::Write(name) = &breakpoint.target
                && !seen.stored
            {
                // Inside a statement the registers may be on their way: DI and AR2 of a block that is called are set by the call.
                seen.stored = name.is_stored(machine, &machine.registers, &stored);
            }
        }
    }

    fn after(&mut self, machine: &Machine, event: &StatementEvent) -> bool {
        self.registers.clone_from(&event.after);
        let place = event.place;
        let newest = machine.frames.last().map(|frame| frame.block);
        // Where a block begins or ends the registers are not yet those of the block that runs.
        let only = if newest == Some(place.block) { None } else { Some(place.block).filter(|_| newest.is_some()) };
        let idle = event.before.rlo & 1 == 0 && self.if_rlo.contains(&(place.block, place.statement));
        self.look(machine, &Now { place: None, by: Some(place), idle, only })
    }
}
