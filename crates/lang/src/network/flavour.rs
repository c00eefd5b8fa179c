//! Which kind of diagram it is: what it may hold, and which drawing of it is meant.

/// Whose elements a diagram is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flavour {
    /// Those of STEP 7, each of which stands for statements of STL.
    S7,
    /// Those of IEC 61131-3: functions and function blocks of Structured Text.
    Iec,
}

/// Which of the two drawings of a network.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Drawing {
    /// Ladder: contacts and coils.
    Lad,
    /// Function block diagram: boxes with inputs.
    Fbd,
}

impl Drawing {
    /// Its abbreviation: `LAD`, `FBD`.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Lad => "LAD",
            Self::Fbd => "FBD",
        }
    }
}
