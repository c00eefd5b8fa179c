//! A diagram that is laid out: symbols, labels and lines on a grid of characters, top left is column 0 of line 0.

use sieben_lang::network::model::Place;

/// A diagram that is laid out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    /// Columns.
    pub columns: usize,
    /// Lines.
    pub lines: usize,
    /// What stands in it, in the order drawn.
    pub symbols: Vec<Symbol>,
    /// Pieces of line.
    pub wires: Vec<Wire>,
    /// Where current comes from.
    pub rails: Vec<Rail>,
    /// What is one line electrically; each depends only on those before it.
    pub nets: Vec<Net>,
}

/// Which net: a place in [`Layout::nets`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NetId(pub u32);

/// A symbol with its labels.
#[derive(Clone, Debug, PartialEq)]
pub struct Symbol {
    /// What it is: `contact`, `coil`, `box`.
    pub kind: &'static str,
    /// Its name in this diagram, `contact-120`; empty for what is no element, such as the mark where a row goes on.
    pub element: String,
    /// Where it comes from.
    pub place: Place,
    /// What it looks like.
    pub outline: Outline,
    /// What is written in it and around it.
    pub labels: Vec<Label>,
    /// The line that enters it, if one does.
    pub before: Option<NetId>,
    /// The line that leaves it, if one does.
    pub after: Option<NetId>,
    /// The value of its operand, if it is known.
    pub value: Option<String>,
}

/// The outline of a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outline {
    /// Labels alone.
    None,
    /// `┤ ├` around what is written between: first and last column, line.
    Contact {
        /// The column of `┤`.
        from: usize,
        /// The column of `├`.
        to: usize,
        /// The line of its wire.
        line: usize,
        /// With a stroke through it: normally closed.
        closed: bool,
    },
    /// `( )` around what is written between.
    Coil {
        /// The column of `(`.
        from: usize,
        /// The column of `)`.
        to: usize,
        /// The line of its wire.
        line: usize,
    },
    /// A box: the columns of its sides, the lines of its edges; pins are labels.
    Box {
        /// The column of its left side.
        from: usize,
        /// The column of its right side.
        to: usize,
        /// The line of its upper edge, in which its title stands.
        top: usize,
        /// The line of its lower edge.
        bottom: usize,
    },
}

/// A piece of writing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Its first column.
    pub column: usize,
    /// Its line.
    pub line: usize,
    /// What is written; no character of it is hidden.
    pub text: String,
    /// What it is.
    pub role: Role,
}

/// What a label is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// An operand or name.
    Name,
    /// The value of an operand.
    Value,
    /// The title of a box.
    Title,
    /// The name of a pin, inside of a box.
    Pin,
    /// What stands in a contact or coil.
    Mark,
    /// Where a row goes on, or a line that is drawn elsewhere.
    Stub,
    /// The tick of a pin at the left side of a box; nothing is written.
    TickLeft,
    /// The tick of a pin at the right side of a box.
    TickRight,
    /// The circle of a pin that is negated.
    Circle,
    /// The label that jumps name.
    Jump,
}

/// A piece of line, horizontal or vertical, from the middle of one character to the middle of another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wire {
    /// Which line it is a piece of.
    pub net: NetId,
    /// Column and line of its upper or left end.
    pub from: (usize, usize),
    /// Column and line of its other end.
    pub to: (usize, usize),
}

/// A piece of rail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rail {
    /// Its column.
    pub column: usize,
    /// Its first line.
    pub from: usize,
    /// Its last line.
    pub to: usize,
    /// The lines that leave it.
    pub side: Side,
}

/// At which side of the diagram a rail stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Lines begin there.
    Left,
    /// Coils end there.
    Right,
}

/// What is one line electrically, and what it carries.
#[derive(Clone, Debug, PartialEq)]
pub enum Net {
    /// A line that begins at the rail or at a branch: 1 where the statements of the place were executed.
    Start(Place),
    /// A rail: 1 if a statement of the network was executed.
    Rail,
    /// After a contact: the line before AND what was found.
    After {
        /// The line before.
        before: NetId,
        /// What was found there.
        place: Place,
        /// Found is negated.
        negated: bool,
    },
    /// After a box or an edge: what was found.
    Found(Place),
    /// Where a sub-rung begins: the logic after the statement that reads the tapped line. It is another than that of the line before while a zone of the
    /// master control relay is off, and after SAVE in the branch above.
    Tapped {
        /// The line that is tapped, if no such statement is known.
        before: NetId,
        /// The statement.
        place: Place,
    },
    /// After a NOT: the line before, negated.
    Not(NetId),
    /// After branches in parallel: the line before AND any of the branches.
    Join {
        /// The line before.
        before: NetId,
        /// The ends of the branches.
        branches: Vec<NetId>,
    },
    /// After a gate: its inputs, each with whether it is negated.
    Gate {
        /// What it does.
        gate: Gate,
        /// Its inputs.
        inputs: Vec<(NetId, bool)>,
    },
}

/// What a gate does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gate {
    /// `&`.
    And,
    /// `>=1`.
    Or,
    /// `XOR`.
    Xor,
}
