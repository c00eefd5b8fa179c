//! The boxes of LAD and FBD that stand for instructions: one row for each, and the kinds of timer and counter boxes.

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
    /// Bits of the inputs and the output; 0 for any.
    pub widths: &'static [u8],
}

const fn row(
    name: &'static str,
    instruction: &'static str,
    inputs: &'static [&'static str],
    overflows: bool,
    widths: &'static [u8],
) -> BoxRow {
    BoxRow { name, instruction, inputs, reversed: false, overflows, widths }
}

const fn shift(name: &'static str, instruction: &'static str, widths: &'static [u8]) -> BoxRow {
    BoxRow { name, instruction, inputs: &["IN", "N"], reversed: true, overflows: false, widths }
}

const ONE: &[&str] = &["IN"];
const TWO: &[&str] = &["IN1", "IN2"];
const W: &[u8] = &[16, 16, 16];
const D: &[u8] = &[32, 32, 32];

/// All boxes with EN and ENO that are no calls.
pub static BOXES: &[BoxRow] = &[
    row("MOVE", "", ONE, false, &[0, 0]),
    row("ADD_I", "+I", TWO, true, W),
    row("SUB_I", "-I", TWO, true, W),
    row("MUL_I", "*I", TWO, true, W),
    row("DIV_I", "/I", TWO, true, W),
    row("ADD_DI", "+D", TWO, true, D),
    row("SUB_DI", "-D", TWO, true, D),
    row("MUL_DI", "*D", TWO, true, D),
    row("DIV_DI", "/D", TWO, true, D),
    row("MOD_DI", "MOD", TWO, true, D),
    row("ADD_R", "+R", TWO, true, D),
    row("SUB_R", "-R", TWO, true, D),
    row("MUL_R", "*R", TWO, true, D),
    row("DIV_R", "/R", TWO, true, D),
    row("ABS", "ABS", ONE, false, &[32, 32]),
    row("SQR", "SQR", ONE, true, &[32, 32]),
    row("SQRT", "SQRT", ONE, true, &[32, 32]),
    row("LN", "LN", ONE, true, &[32, 32]),
    row("EXP", "EXP", ONE, true, &[32, 32]),
    row("SIN", "SIN", ONE, true, &[32, 32]),
    row("COS", "COS", ONE, true, &[32, 32]),
    row("TAN", "TAN", ONE, true, &[32, 32]),
    row("ASIN", "ASIN", ONE, true, &[32, 32]),
    row("ACOS", "ACOS", ONE, true, &[32, 32]),
    row("ATAN", "ATAN", ONE, true, &[32, 32]),
    row("BCD_I", "BTI", ONE, false, &[16, 16]),
    row("BCD_DI", "BTD", ONE, false, &[32, 32]),
    row("I_DINT", "ITD", ONE, false, &[16, 32]),
    row("DI_REAL", "DTR", ONE, false, &[32, 32]),
    row("I_BCD", "ITB", ONE, true, &[16, 16]),
    row("DI_BCD", "DTB", ONE, true, &[32, 32]),
    row("ROUND", "RND", ONE, true, &[32, 32]),
    row("TRUNC", "TRUNC", ONE, true, &[32, 32]),
    row("CEIL", "RND+", ONE, true, &[32, 32]),
    row("FLOOR", "RND-", ONE, true, &[32, 32]),
    row("NEG_I", "NEGI", ONE, true, &[16, 16]),
    row("NEG_DI", "NEGD", ONE, true, &[32, 32]),
    row("INV_I", "INVI", ONE, false, &[16, 16]),
    row("INV_DI", "INVD", ONE, false, &[32, 32]),
    row("NEG_R", "NEGR", ONE, false, &[32, 32]),
    row("WAND_W", "AW", TWO, false, W),
    row("WOR_W", "OW", TWO, false, W),
    row("WXOR_W", "XOW", TWO, false, W),
    row("WAND_DW", "AD", TWO, false, D),
    row("WOR_DW", "OD", TWO, false, D),
    row("WXOR_DW", "XOD", TWO, false, D),
    shift("SHL_W", "SLW", W),
    shift("SHR_W", "SRW", W),
    shift("SHL_DW", "SLD", &[32, 16, 32]),
    shift("SHR_DW", "SRD", &[32, 16, 32]),
    shift("SHR_I", "SSI", W),
    shift("SHR_DI", "SSD", &[32, 16, 32]),
    shift("ROL_DW", "RLD", &[32, 16, 32]),
    shift("ROR_DW", "RRD", &[32, 16, 32]),
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
