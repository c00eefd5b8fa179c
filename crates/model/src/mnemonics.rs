//! The two mnemonic languages of STL.

/// English (international) or German (SIMATIC) mnemonics.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Mnemonics {
    /// International: `A I 0.0`, `JC`, `OPN`.
    #[default]
    English,
    /// SIMATIC: `U E 0.0`, `SPB`, `AUF`.
    German,
}

impl Mnemonics {
    /// The other language.
    pub fn other(self) -> Self {
        match self {
            Self::English => Self::German,
            Self::German => Self::English,
        }
    }
}
