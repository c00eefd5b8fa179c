//! Why a network cannot be drawn, and what is rewritten so that it can.

use std::fmt;

macro_rules! reasons {
    ($( $(#[doc = $doc:literal])* $Name:ident { code: $code:literal, problem: $problem:literal, sentence: $sentence:literal, fix: $fix:literal } )*) => {
        /// Why a network stays STL.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Reason {
            $($(#[doc = $doc])* $Name,)*
        }

        impl Reason {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$Name),*];
            /// Its code: `R-TWO`.
            pub fn code(self) -> &'static str { match self { $(Self::$Name => $code,)* } }
            /// The number of its problem code: 9001 of P9001.
            pub fn problem(self) -> u16 { match self { $(Self::$Name => $problem,)* } }
            /// What is in the way, as one sentence without a full stop.
            pub fn sentence(self) -> &'static str { match self { $(Self::$Name => $sentence,)* } }
            /// What to do about it, as a command; empty if nothing in the network helps.
            pub fn fix(self) -> &'static str { match self { $(Self::$Name => $fix,)* } }
        }
    };
}

reasons! {
    /// A second string that is not connected.
    Two { code: "R-TWO", problem: 9001, sentence: "a second string of logic begins here, and one network of a diagram holds one", fix: "split into 2 networks here" }
    /// Logic that leads nowhere, or comes from nowhere.
    Logic { code: "R-LOGIC", problem: 9002, sentence: "this logic leads to no output, or has no beginning", fix: "end it with an output such as `=`" }
    /// A jump that has no coil, or stays in its network.
    Jump { code: "R-JUMP", problem: 9003, sentence: "a diagram jumps with JC, JCN or JU at the end of a network, to the start of another one", fix: "move the target to a network of its own" }
    /// A label in the middle.
    Label { code: "R-LABEL", problem: 9004, sentence: "a label stands in the middle of the network", fix: "begin a network with it" }
    /// An instruction without an element.
    Opcode { code: "R-OPCODE", problem: 9005, sentence: "no element of a diagram stands for this instruction", fix: "" }
    /// An address that is computed.
    Indirect { code: "R-INDIRECT", problem: 9006, sentence: "an element of a diagram takes no address that is computed at run time", fix: "" }
    /// It is executed whatever the logic before it says.
    Unconditional { code: "R-UNCOND", problem: 9007, sentence: "this is executed whatever the logic before it says, and a diagram would make it depend on that", fix: "give the box an EN with JNB, or put it into a network of its own" }
    /// A result that is not stored once.
    Store { code: "R-STORE", problem: 9008, sentence: "the result of a box is stored by exactly one T", fix: "store it with one T" }
    /// Two operations without a store between.
    Chain { code: "R-CHAIN", problem: 9009, sentence: "two operations follow each other without a T between them, and each box stores its result", fix: "store the first result in a temporary variable" }
    /// A placeholder is missing.
    Nop { code: "R-NOP", problem: 9010, sentence: "a slot of the box is neither used nor marked as open", fix: "add NOP 0" }
    /// Slots in another order.
    Order { code: "R-ORDER", problem: 9011, sentence: "the parts of a timer or counter stand in another order than its box has them", fix: "put them into the order of the box: start with its value, R, L, LC, and the check of the output last" }
    /// An end of a box that is none.
    Eno { code: "R-ENO", problem: 9012, sentence: "the end of a box with EN is NOP 0, or SAVE and CLR and `A BR` after `AN OV` or SET", fix: "write the end of the box as its kind has it" }
    /// Brackets that do not match.
    Bracket { code: "R-BRACKET", problem: 9013, sentence: "a bracket is empty, closes nothing or stays open", fix: "match the brackets" }
    /// Too many brackets inside of one another.
    Depth { code: "R-DEPTH", problem: 9014, sentence: "more than 7 brackets stand inside of one another", fix: "split the logic with a midline output" }
    /// A bit of local data that nothing reads.
    BitLeft { code: "R-BITLEFT", problem: 9015, sentence: "a bit of local data is stored like that of a T-branch, and no branch reads it", fix: "declare a temporary variable for it" }
    /// A line that would run backwards.
    Back { code: "R-BACK", problem: 9016, sentence: "ladder cannot lead a tapped line into another branch, because a line does not run backwards", fix: "draw it as FBD" }
    /// An edge or a NOT of a part of a line.
    Neg { code: "R-NEG", problem: 9017, sentence: "ladder has no edge, NOT or box for a part in the middle of a line", fix: "draw it as FBD" }
    /// Operands whose width the box does not take.
    Width { code: "R-WIDTH", problem: 9018, sentence: "this operand does not fit the pin", fix: "use an operand of that type, or move it to one first" }
    /// Logic of the network before goes on.
    Carried { code: "R-CARRY", problem: 9022, sentence: "the network before it leaves its logic open (SAVE, or no output), and written in another way this one would do something else with it", fix: "end the network before with an output" }
    /// More elements than a diagram has.
    Size { code: "R-SIZE", problem: 9021, sentence: "the network has more elements than a diagram may have", fix: "divide it into several networks" }
    /// A comparison with an EN.
    Mix { code: "R-MIX", problem: 9019, sentence: "a comparison is a contact and has no EN", fix: "take JNB away" }
}

impl fmt::Display for Reason {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(self.code())
    }
}

/// A refusal: why, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// Why.
    pub reason: Reason,
    /// The first statement that does not fit, counted from 0.
    pub statement: usize,
    /// What exactly, if the reason leaves it open: `R of S_ODT`.
    pub detail: String,
}

impl Refusal {
    /// Without a detail.
    pub fn new(reason: Reason, statement: usize) -> Self {
        Self { reason, statement, detail: String::new() }
    }

    /// The sentence, with what exactly is in the way.
    pub fn message(&self) -> String {
        if self.detail.is_empty() { self.reason.sentence().to_owned() } else { format!("{}: {}", self.reason.sentence(), self.detail) }
    }
}

macro_rules! rewrites {
    ($( $(#[doc = $doc:literal])* $Name:ident { code: $code:literal, sentence: $sentence:literal } )*) => {
        /// A rewrite that keeps the meaning.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Rewrite {
            $($(#[doc = $doc])* $Name,)*
        }

        impl Rewrite {
            /// All of them, by their numbers.
            pub const ALL: &[Self] = &[$(Self::$Name),*];
            /// Its code: `W3`.
            pub fn code(self) -> &'static str { match self { $(Self::$Name => $code,)* } }
            /// What is written instead, as a sentence.
            pub fn sentence(self) -> &'static str { match self { $(Self::$Name => $sentence,)* } }
        }
    };
}

rewrites! {
    /// Placeholders of open slots.
    Placeholder { code: "W1", sentence: "`NOP 0` is added for each open slot of a box and at its end." }
    /// A parallel before more logic.
    ParallelBracket { code: "W2", sentence: "Branches in parallel before more logic stand in brackets: `A( O a; O b ) A c`." }
    /// The NOT of a bracket.
    NegatedBracket { code: "W3", sentence: "A negated bracket becomes the bracket with NOT after it, at the left end of its line." }
    /// The first check of a string.
    FirstCheck { code: "W4", sentence: "The first check of a string is written with `A` in a series and with `O` in a parallel; both give the same." }
    /// A constant RLO.
    Constant { code: "W5", sentence: "`SET` becomes a parallel that is always 1, `CLR` a series that is always 0." }
    /// Several networks.
    Split { code: "W6", sentence: "Each string gets a network of its own." }
    /// Other bits of local data.
    Renumber { code: "W7", sentence: "The bits of local data of T-branches and pins are numbered again after the declared temporary variables." }
    /// Two stores.
    TwoMoves { code: "W8", sentence: "Two stores of one load become two MOVE boxes." }
    /// A jump around boxes.
    Enable { code: "W9", sentence: "A jump around boxes becomes their EN." }
    /// A named bit of a T-branch.
    NamedBranch { code: "W10", sentence: "A temporary variable that holds a line for several rungs becomes a T-branch." }
    /// Marks that do nothing.
    Marks { code: "W11", sentence: "The BLD marks of elements are set as the elements have them; they do nothing at run time." }
    /// Brackets that change nothing.
    Brackets { code: "W12", sentence: "Brackets that do not change the value are added or taken away." }
    /// An exclusive OR in ladder.
    ExclusiveOr { code: "W13", sentence: "An exclusive OR of two operands becomes two branches in parallel." }
}

impl fmt::Display for Rewrite {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(self.code())
    }
}
