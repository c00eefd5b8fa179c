//! CPU registers: one table for the struct, the IR's variables and their layout.

use std::fmt;

macro_rules! registers {
    ($($(#[doc = $doc:literal])* $Name:ident $field:ident,)*) => {
        /// The CPU registers, one 64-bit word each; a status bit is 0 or 1.
        #[repr(C)]
        #[derive(Clone, Debug, Default, PartialEq, Eq)]
        pub struct Registers { $($(#[doc = $doc])* pub $field: u64,)* }

        /// A register by name.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[repr(u8)]
        pub enum Register { $($(#[doc = $doc])* $Name,)* }

        impl Register {
            /// All registers, in the order of the struct.
            pub const ALL: &[Self] = &[$(Self::$Name),*];
            /// How many there are.
            pub const COUNT: usize = Self::ALL.len();
            /// The name of the field.
            pub fn name(self) -> &'static str { match self { $(Self::$Name => stringify!($field)),* } }
            /// Offset in [`Registers`], for machine code.
            pub fn offset(self) -> usize { match self { $(Self::$Name => std::mem::offset_of!(Registers, $field)),* } }
        }

        impl Registers {
            const ZERO: Self = Self { $($field: 0),* };
            /// The value of a register.
            pub fn get(&self, register: Register) -> u64 { match register { $(Register::$Name => self.$field),* } }
            /// Sets a register.
            pub fn set(&mut self, register: Register, value: u64) { match register { $(Register::$Name => self.$field = value),* } }
            /// All values in the order of [`Register::ALL`].
            #[inline]
            pub const fn to_words(&self) -> [u64; Register::COUNT] { [$(self.$field),*] }
            /// Registers from their values.
            #[inline]
            pub fn from_words(words: &[u64; Register::COUNT]) -> Self {
                let [$($field),*] = *words;
                Self { $($field),* }
            }
        }
    };
}

registers! {
    /// Accumulator 1.
    Accu1 accu1,
    /// Accumulator 2.
    Accu2 accu2,
    /// Accumulator 3 (S7-400).
    Accu3 accu3,
    /// Accumulator 4 (S7-400).
    Accu4 accu4,
    /// Address register 1.
    Ar1 ar1,
    /// Address register 2.
    Ar2 ar2,
    /// First check: 0 = the next scan begins a new logic string.
    Fc fc,
    /// Result of logic operation.
    Rlo rlo,
    /// Status: the bit that was scanned or written last.
    Sta sta,
    /// OR: the left side of an AND-before-OR.
    Or or,
    /// Stored overflow.
    Os os,
    /// Overflow.
    Ov ov,
    /// Condition code 0.
    Cc0 cc0,
    /// Condition code 1.
    Cc1 cc1,
    /// Binary result.
    Br br,
    /// Nesting stack: one byte per open bracket, the newest lowest.
    Nesting nesting,
    /// MCR stack: a 1 followed by one bit per open zone, the newest lowest.
    Mcr mcr,
    /// Whether the MCR is active in this block (MCRA).
    Ma ma,
    /// Number of the open shared data block, 0 = none.
    DbNumber db_number,
    /// Its first byte in the arena.
    DbBase db_base,
    /// Its length in bytes.
    DbLength db_length,
    /// Number of the open instance data block, 0 = none.
    DiNumber di_number,
    /// Its first byte in the arena.
    DiBase di_base,
    /// Its length in bytes.
    DiLength di_length,
}

/// The status bits in the order of the status word, bit 0 first.
pub const STATUS_BITS: [Register; 9] =
    [Register::Fc, Register::Rlo, Register::Sta, Register::Or, Register::Os, Register::Ov, Register::Cc0, Register::Cc1, Register::Br];

/// An empty MCR stack.
pub const MCR_EMPTY: u64 = 1;

/// The nine status bits as one value: bit 0 = /FC … bit 8 = BR.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct StatusWord(pub u16);

impl StatusWord {
    /// Reads nine characters in the order BR CC1 CC0 OV OS OR STA RLO /FC.
    pub fn parse(text: &str) -> Option<Self> {
        if text.len() != 9 || !text.bytes().all(|byte| matches!(byte, b'0' | b'1')) {
            return None;
        }
        u16::from_str_radix(text, 2).ok().map(Self)
    }
    /// The value of one bit; false for a register that is no status bit.
    pub fn bit(self, register: Register) -> bool {
        STATUS_BITS.iter().position(|&bit| bit == register).is_some_and(|bit| self.0 >> bit & 1 == 1)
    }
}

impl fmt::Display for StatusWord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:09b}", self.0 & 0x1FF)
    }
}

impl Registers {
    /// The registers at the start of a priority class: BR = 1, all else 0, no block open.
    pub const fn fresh() -> Self {
        Self { br: 1, mcr: MCR_EMPTY, ..Self::ZERO }
    }
    /// The status word.
    pub fn status(&self) -> StatusWord {
        StatusWord(STATUS_BITS.iter().enumerate().fold(0, |word, (bit, &register)| word | ((self.get(register) & 1) as u16) << bit))
    }
    /// Sets all nine status bits.
    pub fn set_status(&mut self, status: StatusWord) {
        for (bit, &register) in STATUS_BITS.iter().enumerate() {
            self.set(register, u64::from(status.0 >> bit & 1));
        }
    }
}
