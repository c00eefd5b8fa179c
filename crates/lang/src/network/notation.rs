//! How a diagram is to be read: which drawing it is, and of which world its blocks are.

/// The two drawings of a network.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Drawing {
    /// Ladder.
    Lad,
    /// Function block diagram.
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

/// Whose elements a diagram has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flavour {
    /// Those of STEP 7, which stand for statements of STL.
    S7,
    /// Those of IEC 61131-3: functions and function blocks by their names.
    Iec,
}
