//! The boxes of LAD and FBD that stand for instructions: one row for each, and the kinds of timer and counter boxes.

use super::pin_types::PinType;

/// A box with EN and ENO that is no call.
#[derive(Debug, PartialEq)]
pub struct BoxRow {
    /// Its name in LAD.
    pub name: &'static str,
    /// The instruction between load and transfer; empty for MOVE.
    pub instruction: &'static str,
    /// Names of the inputs.
    pub inputs: &'static [&'static str],
    /// The inputs are loaded in the other order: N before IN.
    pub reversed: bool,
    /// ENO tells overflow.
    pub overflows: bool,
    /// What the inputs take, and the output.
    pub types: &'static [PinType],
}

const fn row(
    name: &'static str,
    instruction: &'static str,
    inputs: &'static [&'static str],
    overflows: bool,
    types: &'static [PinType],
) -> BoxRow {
    BoxRow { name, instruction, inputs, reversed: false, overflows, types }
}

const fn shift(name: &'static str, instruction: &'static str, types: &'static [PinType]) -> BoxRow {
    BoxRow { name, instruction, inputs: &["IN", "N"], reversed: true, overflows: false, types }
}

const ONE: &[&str] = &["IN"];
const TWO: &[&str] = &["IN1", "IN2"];
const INT: PinType = PinType::Int;
const DINT: PinType = PinType::DoubleInt;
const REAL: PinType = PinType::Real;
const WORD: PinType = PinType::Word;
const DWORD: PinType = PinType::DoubleWord;
const INTS: &[PinType] = &[INT, INT, INT];
const DINTS: &[PinType] = &[DINT, DINT, DINT];
const REALS: &[PinType] = &[REAL, REAL, REAL];
const ONE_REAL: &[PinType] = &[REAL, REAL];
const WORDS: &[PinType] = &[WORD, WORD, WORD];
const DWORDS: &[PinType] = &[DWORD, DWORD, DWORD];

/// All boxes with EN and ENO that are no calls.
pub static BOXES: &[BoxRow] = &[
    row("MOVE", "", ONE, false, &[PinType::Any, PinType::Any]),
    row("ADD_I", "+I", TWO, true, INTS),
    row("SUB_I", "-I", TWO, true, INTS),
    row("MUL_I", "*I", TWO, true, INTS),
    row("DIV_I", "/I", TWO, true, INTS),
    row("ADD_DI", "+D", TWO, true, DINTS),
    row("SUB_DI", "-D", TWO, true, DINTS),
    row("MUL_DI", "*D", TWO, true, DINTS),
    row("DIV_DI", "/D", TWO, true, DINTS),
    row("MOD_DI", "MOD", TWO, true, DINTS),
    row("ADD_R", "+R", TWO, true, REALS),
    row("SUB_R", "-R", TWO, true, REALS),
    row("MUL_R", "*R", TWO, true, REALS),
    row("DIV_R", "/R", TWO, true, REALS),
    row("ABS", "ABS", ONE, false, ONE_REAL),
    row("SQR", "SQR", ONE, true, ONE_REAL),
    row("SQRT", "SQRT", ONE, true, ONE_REAL),
    row("LN", "LN", ONE, true, ONE_REAL),
    row("EXP", "EXP", ONE, true, ONE_REAL),
    row("SIN", "SIN", ONE, true, ONE_REAL),
    row("COS", "COS", ONE, true, ONE_REAL),
    row("TAN", "TAN", ONE, true, ONE_REAL),
    row("ASIN", "ASIN", ONE, true, ONE_REAL),
    row("ACOS", "ACOS", ONE, true, ONE_REAL),
    row("ATAN", "ATAN", ONE, true, ONE_REAL),
    row("BCD_I", "BTI", ONE, false, &[WORD, INT]),
    row("BCD_DI", "BTD", ONE, false, &[DWORD, DINT]),
    row("I_DINT", "ITD", ONE, false, &[INT, DINT]),
    row("DI_REAL", "DTR", ONE, false, &[DINT, REAL]),
    row("I_BCD", "ITB", ONE, true, &[INT, WORD]),
    row("DI_BCD", "DTB", ONE, true, &[DINT, DWORD]),
    row("ROUND", "RND", ONE, true, &[REAL, DINT]),
    row("TRUNC", "TRUNC", ONE, true, &[REAL, DINT]),
    row("CEIL", "RND+", ONE, true, &[REAL, DINT]),
    row("FLOOR", "RND-", ONE, true, &[REAL, DINT]),
    row("NEG_I", "NEGI", ONE, true, &[INT, INT]),
    row("NEG_DI", "NEGD", ONE, true, &[DINT, DINT]),
    row("INV_I", "INVI", ONE, false, &[INT, INT]),
    row("INV_DI", "INVD", ONE, false, &[DINT, DINT]),
    row("NEG_R", "NEGR", ONE, false, ONE_REAL),
    row("WAND_W", "AW", TWO, false, WORDS),
    row("WOR_W", "OW", TWO, false, WORDS),
    row("WXOR_W", "XOW", TWO, false, WORDS),
    row("WAND_DW", "AD", TWO, false, DWORDS),
    row("WOR_DW", "OD", TWO, false, DWORDS),
    row("WXOR_DW", "XOD", TWO, false, DWORDS),
    shift("SHL_W", "SLW", WORDS),
    shift("SHR_W", "SRW", WORDS),
    shift("SHL_DW", "SLD", &[DWORD, WORD, DWORD]),
    shift("SHR_DW", "SRD", &[DWORD, WORD, DWORD]),
    shift("SHR_I", "SSI", &[INT, WORD, INT]),
    shift("SHR_DI", "SSD", &[DINT, WORD, DINT]),
    shift("ROL_DW", "RLD", &[DWORD, WORD, DWORD]),
    shift("ROR_DW", "RRD", &[DWORD, WORD, DWORD]),
];

impl BoxRow {
    /// The box of an instruction; the empty one is MOVE.
    pub fn of_instruction(instruction: &str) -> Option<&'static Self> {
        BOXES.iter().find(|row| row.instruction == instruction)
    }
    /// The box of a name.
    pub fn of_name(name: &str) -> Option<&'static Self> {
        BOXES.iter().find(|row| row.name == name)
    }
}

/// The comparisons.
pub const COMPARISONS: [&str; 18] =
    ["==I", "<>I", ">I", "<I", ">=I", "<=I", "==D", "<>D", ">D", "<D", ">=D", "<=D", "==R", "<>R", ">R", "<R", ">=R", "<=R"];

/// How a timer starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimerKind {
    /// SP, S_PULSE.
    Pulse,
    /// SE, S_PEXT.
    ExtendedPulse,
    /// SD, S_ODT.
    OnDelay,
    /// SS, S_ODTS.
    StoredOnDelay,
    /// SF, S_OFFDT.
    OffDelay,
}

impl TimerKind {
    /// All kinds: instruction, box.
    pub const ALL: [(Self, &'static str, &'static str); 5] = [
        (Self::Pulse, "SP", "S_PULSE"),
        (Self::ExtendedPulse, "SE", "S_PEXT"),
        (Self::OnDelay, "SD", "S_ODT"),
        (Self::StoredOnDelay, "SS", "S_ODTS"),
        (Self::OffDelay, "SF", "S_OFFDT"),
    ];
    /// The instruction that starts it.
    pub fn instruction(self) -> &'static str {
        Self::ALL[self as usize].1
    }
    /// The name of its box.
    pub fn box_name(self) -> &'static str {
        Self::ALL[self as usize].2
    }
    /// The kind that an instruction starts.
    pub fn of(instruction: &str) -> Option<Self> {
        Self::ALL.iter().find(|row| row.1 == instruction).map(|row| row.0)
    }
}

/// Which counter box.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CounterKind {
    /// S_CU.
    Up,
    /// S_CD.
    Down,
    /// S_CUD.
    UpDown,
}

impl CounterKind {
    /// All kinds: box, and the pin that the line from the left enters.
    pub const ALL: [(Self, &'static str, &'static str); 3] =
        [(Self::Up, "S_CU", "CU"), (Self::Down, "S_CD", "CD"), (Self::UpDown, "S_CUD", "CU")];

    /// The name of its box.
    pub fn box_name(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// The pin that the line from the left enters.
    pub fn power_pin(self) -> &'static str {
        Self::ALL[self as usize].2
    }
}

/// The pins of a function block of IEC 61131-3 that a line enters, and that it goes on from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PowerPins {
    /// What the names of the blocks begin with.
    pub blocks: &'static [&'static str],
    /// The input, as its block calls it first; others may call it by another of these names.
    pub input: &'static [&'static str],
    /// The output.
    pub output: &'static str,
}

/// The function blocks of the standard whose line enters another pin than EN. Where several begin alike, the longer name stands first.
pub const POWER_PINS: &[PowerPins] = &[
    PowerPins { blocks: &["TONR", "TON", "TOF", "TP", "LTON", "LTOF", "LTP"], input: &["IN"], output: "Q" },
    PowerPins { blocks: &["CTUD", "LCTUD"], input: &["CU"], output: "QU" },
    PowerPins { blocks: &["CTU", "LCTU"], input: &["CU"], output: "Q" },
    PowerPins { blocks: &["CTD", "LCTD"], input: &["CD"], output: "Q" },
    PowerPins { blocks: &["R_TRIG", "F_TRIG"], input: &["CLK"], output: "Q" },
    PowerPins { blocks: &["SR"], input: &["S1", "SET1"], output: "Q1" },
    PowerPins { blocks: &["RS"], input: &["S", "SET"], output: "Q1" },
];

impl PowerPins {
    /// Those of a block by its name: `TON`, `TON_TIME`.
    pub fn of(block: &str) -> Option<&'static Self> {
        let is_of = |base: &&str| {
            let own = block.get(..base.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(base));
            own && matches!(block.as_bytes().get(base.len()), None | Some(b'_'))
        };
        POWER_PINS.iter().find(|row| row.blocks.iter().any(is_of))
    }
}
