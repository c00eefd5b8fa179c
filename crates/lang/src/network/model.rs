//! A network as a diagram: what LAD and FBD both draw.
//!
//! The tree is series-parallel with T-branches. It keeps what statements need to come back the same.

use super::boxes::{BoxRow, CounterKind, TimerKind};
use super::operand::Operand;

/// A network.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Network {
    /// The label that jumps name.
    pub label: Option<Operand>,
    /// What it consists of.
    pub content: Content,
}

/// What a network consists of.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Content {
    /// Nothing.
    #[default]
    Empty,
    /// An element that stands alone, straight on the rail.
    Alone(Alone, Place),
    /// One rung.
    Rung(Rung),
}

/// An element that takes no logic and shares its network with nothing.
#[derive(Clone, Debug, PartialEq)]
pub enum Alone {
    /// `OPN DB 10`.
    Open(Operand),
    /// `MCRA`.
    McrActivate,
    /// `MCRD`.
    McrDeactivate,
    /// `)MCR`.
    McrEnd,
    /// `JU label`.
    Jump(Operand),
    /// `UC FC 1`.
    Call(Operand),
    /// RETURN; only in diagrams of IEC 61131-3.
    Return,
}

/// Where an element comes from: of a network that was read from statements the first and the last statement that make it, counted from 0;
/// of a diagram that is written as text its bytes, from and to.
#[derive(Clone, Copy, Debug, Default)]
pub struct Place {
    /// The first statement, or the first byte.
    pub first: u32,
    /// The last statement, or the byte after the last one.
    pub last: u32,
}

impl Place {
    /// From one to another.
    pub fn new(first: usize, last: usize) -> Self {
        Self { first: u32::try_from(first).unwrap_or(u32::MAX), last: u32::try_from(last).unwrap_or(u32::MAX) }
    }
}

impl PartialEq for Place {
    /// Where something came from makes no difference to what it is.
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// From the rail, or from the line that a T-branch taps, to its end.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rung {
    /// Elements in series.
    pub line: Line,
    /// What stands at the right.
    pub end: End,
    /// Of a sub-rung that was read from statements and begins with the tapped line the statement that reads it; otherwise nothing stands there.
    pub tap: Place,
}

impl Rung {
    /// A rung that was not read from statements, or begins at the rail.
    pub fn new(line: Line, end: End) -> Self {
        Self { line, end, tap: Place::default() }
    }
}

/// Elements in series; each acts on the line that comes from the left.
pub type Line = Vec<Element>;

/// The right end of a rung.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum End {
    /// A box whose output feeds nothing.
    #[default]
    Open,
    /// Coils, top to bottom.
    Outputs(Vec<Output>),
    /// A T-branch: sub-rungs, top to bottom.
    Branches(Vec<Rung>),
}

/// A coil with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Which one.
    pub kind: OutputKind,
    /// Where it comes from.
    pub place: Place,
}

/// Coils.
#[derive(Clone, Debug, PartialEq)]
pub enum OutputKind {
    /// `= x`.
    Assign(Operand),
    /// `(/)`: the negated line; only in diagrams of IEC 61131-3.
    AssignNegated(Operand),
    /// `(P)`, `(N)`: 1 for one scan after an edge of the line; only in diagrams of IEC 61131-3.
    AssignEdge {
        /// From 1 to 0.
        falling: bool,
        /// What is written.
        operand: Operand,
    },
    /// `S x`.
    Set(Operand),
    /// `R x`, also of a timer or counter.
    Reset(Operand),
    /// `SAVE`.
    Save,
    /// `SAVE; BEC`.
    Return,
    /// `JC label`.
    Jump(Operand),
    /// `JCN label`.
    JumpNot(Operand),
    /// `CC FC 1`.
    Call(Operand),
    /// `MCR(`.
    McrStart,
    /// A timer coil.
    Timer {
        /// How it starts.
        kind: TimerKind,
        /// `T 5`.
        timer: Operand,
        /// Its time value.
        value: Operand,
    },
    /// `L pv; S C n`.
    SetCounter {
        /// `C 5`.
        counter: Operand,
        /// Its value.
        value: Operand,
    },
    /// `CU C n`.
    CountUp(Operand),
    /// `CD C n`.
    CountDown(Operand),
}

impl OutputKind {
    /// At its place.
    pub fn at(self, place: Place) -> Output {
        Output { kind: self, place }
    }
}

/// An element with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// Which one.
    pub kind: Kind,
    /// Where it comes from.
    pub place: Place,
}

/// Elements of a line.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// A contact or binary input: an operand, or a status bit such as `OV` or `==0`. At a pin of a box of IEC 61131-3 an expression of any type.
    Contact {
        /// What is read.
        operand: Operand,
        /// Normally closed.
        negated: bool,
    },
    /// A comparison: `>I`.
    Compare {
        /// Its instruction.
        operation: &'static str,
        /// IN1.
        left: Operand,
        /// IN2.
        right: Operand,
        /// With a circle; only in FBD.
        negated: bool,
    },
    /// Branches in parallel.
    Parallel {
        /// Top to bottom.
        branches: Vec<Branch>,
        /// With a circle; only in FBD.
        negated: bool,
    },
    /// Exclusive OR; only in FBD.
    Xor {
        /// Top to bottom.
        inputs: Vec<XorInput>,
        /// With a circle.
        negated: bool,
    },
    /// A part of a series that is evaluated by itself; only in FBD.
    Group {
        /// The part.
        line: Line,
        /// With a circle.
        negated: bool,
    },
    /// The tapped line, read where it does not come from the left; only in FBD.
    Tap {
        /// With a circle.
        negated: bool,
    },
    /// `-(P)-`, `-(N)-`: an edge of the line.
    Edge {
        /// From 1 to 0.
        falling: bool,
        /// The edge memory bit.
        memory: Operand,
    },
    /// POS, NEG: an edge of an operand.
    EdgeBox {
        /// From 1 to 0.
        falling: bool,
        /// What is watched.
        operand: Operand,
        /// The edge memory bit; diagrams of IEC 61131-3 have none: `|P|`, `|N|`.
        memory: Option<Operand>,
    },
    /// `-|NOT|-`.
    Not,
    /// `-(#)-`.
    Midline {
        /// What is written.
        operand: Operand,
        /// What goes on to the right is negated; only in FBD.
        negated: bool,
    },
    /// A box of the table with EN and ENO.
    Box {
        /// Its row.
        row: &'static BoxRow,
        /// What is wired to its inputs, in the order of the row.
        inputs: Vec<Operand>,
        /// What is wired to OUT.
        output: Operand,
    },
    /// SR or RS; the line from the left is its first input.
    FlipFlop {
        /// RS: set wins.
        reset_first: bool,
        /// The bit.
        operand: Operand,
        /// Logic at the second input.
        second: Option<Line>,
    },
    /// A timer box; the line from the left is S.
    Timer(Box<Timer>),
    /// A counter box; the line from the left is CU, or CD of S_CD.
    Counter(Box<Counter>),
    /// A call of a block of the S7.
    Call {
        /// `FC 1`, `FB 3`, `SFC 20`, `#motor`.
        block: Operand,
        /// The instance data block.
        instance: Option<Operand>,
        /// Its pins, in the order of the interface.
        pins: Vec<Pin>,
    },
    /// A function or function block of IEC 61131-3.
    Named(Box<NamedBox>),
}

/// A branch of a parallel.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// Its elements.
    pub line: Line,
    /// It stands in `O( )` although a bare `O` would do, as a source had it.
    pub bracketed: bool,
}

/// An input of an XOR.
#[derive(Clone, Debug, PartialEq)]
pub struct XorInput {
    /// Its logic.
    pub line: Line,
    /// With a circle.
    pub negated: bool,
}

/// A timer box of the S7.
#[derive(Clone, Debug, PartialEq)]
pub struct Timer {
    /// How it starts.
    pub kind: TimerKind,
    /// `T 5`.
    pub timer: Operand,
    /// TV.
    pub value: Operand,
    /// R.
    pub reset: Option<Line>,
    /// BI.
    pub binary: Option<Operand>,
    /// BCD.
    pub bcd: Option<Operand>,
}

/// A counter box of the S7.
#[derive(Clone, Debug, PartialEq)]
pub struct Counter {
    /// S_CU, S_CD or S_CUD.
    pub kind: CounterKind,
    /// `C 5`.
    pub counter: Operand,
    /// CD of S_CUD.
    pub down: Option<Line>,
    /// S with PV.
    pub set: Option<(Line, Operand)>,
    /// R.
    pub reset: Option<Line>,
    /// CV.
    pub value: Option<Operand>,
    /// CV_BCD.
    pub bcd: Option<Operand>,
}

/// A pin of a called block.
#[derive(Clone, Debug, PartialEq)]
pub struct Pin {
    /// The parameter.
    pub name: Operand,
    /// What is wired to it.
    pub actual: Actual,
}

/// What is wired to a pin.
#[derive(Clone, Debug, PartialEq)]
pub enum Actual {
    /// An operand or constant, which is handed on as it is.
    Direct(Operand),
    /// Logic, which is evaluated before the call.
    Logic(Line),
    /// An output, which is written to an operand after the call.
    Output(Operand),
}

impl Actual {
    /// What an operand alone is at a pin: the address of a bit is a contact, everything else is handed on as it is.
    pub fn of_operand(operand: Operand, contact: Line) -> Self {
        if operand.is_bit_address() { Self::Logic(contact) } else { Self::Direct(operand) }
    }

    /// Logic that is one contact of a variable, which, written alone, would be handed on as it is.
    pub fn is_name_of_bit(&self) -> bool {
        let Self::Logic(line) = self else { return false };
        matches!(line.as_slice(), [Element { kind: Kind::Contact { operand, negated: false }, .. }] if !operand.is_bit_address())
    }
}

/// A box of IEC 61131-3: a function, an operator or a function block.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedBox {
    /// `ADD`, `TON`, `Mixer`.
    pub name: Operand,
    /// The instance of a function block.
    pub instance: Option<Operand>,
    /// Its inputs, in the order written. A pin without a name is the next one of the interface.
    pub inputs: Vec<NamedInput>,
    /// Its outputs that are wired: name, if one is written, and what is written.
    pub outputs: Vec<(Option<Operand>, Operand)>,
    /// The input that the line from the left enters, if it is said: `IN := .`.
    pub power: Option<Operand>,
    /// The output that the line goes on from, if it is said: `Q => .`.
    pub flow: Option<Operand>,
}

/// An input of a box of IEC 61131-3.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedInput {
    /// The parameter.
    pub name: Option<Operand>,
    /// With a circle.
    pub negated: bool,
    /// An expression is a contact, of any type.
    pub line: Line,
}

impl Kind {
    /// A contact.
    pub fn contact(operand: impl Into<Operand>, negated: bool) -> Self {
        Self::Contact { operand: operand.into(), negated }
    }

    /// At its place.
    pub fn at(self, place: Place) -> Element {
        Element { kind: self, place }
    }

    /// It carries out more than the logic of a line: a box with outputs of its own.
    pub fn is_box(&self) -> bool {
        matches!(self, Self::Box { .. } | Self::FlipFlop { .. } | Self::Timer(_) | Self::Counter(_) | Self::Call { .. } | Self::Named(_))
    }

    /// It acts on all that stands to its left.
    pub fn acts_on_line(&self) -> bool {
        matches!(self, Self::Edge { .. } | Self::Not | Self::Midline { .. }) || self.is_box()
    }

    /// It has a circle, or is a normally closed contact.
    pub fn is_negated(&self) -> bool {
        match self {
            Self::Contact { negated, .. }
            | Self::Compare { negated, .. }
            | Self::Parallel { negated, .. }
            | Self::Xor { negated, .. }
            | Self::Group { negated, .. }
            | Self::Tap { negated } => *negated,
            _ => false,
        }
    }

    /// Negates it once more; says whether it can be negated by itself.
    pub fn negate(&mut self) -> bool {
        match self {
            Self::Contact { negated, .. }
            | Self::Compare { negated, .. }
            | Self::Parallel { negated, .. }
            | Self::Xor { negated, .. }
            | Self::Group { negated, .. }
            | Self::Tap { negated } => {
                *negated = !*negated;
                true
            }
            _ => false,
        }
    }

    /// It, or something in it, is an edge.
    pub fn holds_edge(&self) -> bool {
        let in_line = |line: &Line| line.iter().any(|one| one.kind.holds_edge());
        match self {
            Self::Edge { .. } | Self::EdgeBox { .. } => true,
            Self::Parallel { branches, .. } => branches.iter().any(|branch| in_line(&branch.line)),
            Self::Group { line, .. } => in_line(line),
            Self::Xor { inputs, .. } => inputs.iter().any(|input| in_line(&input.line)),
            _ => false,
        }
    }
}
