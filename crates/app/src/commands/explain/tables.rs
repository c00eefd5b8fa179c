//! Tables over all instructions: what each does to the status word, and when each jump jumps.

use std::fmt::Write;

use sieben_lang::stl::instructions::Instruction;
use sieben_lang::stl::operands::OperandClass;
use sieben_model::format::ROWS;

use super::status_columns;

/// The effect of every instruction on every bit of the status word.
pub(super) fn status() -> String {
    let mut out = format!("{:<7} {:<7} {:<20} {}\n", "English", "German", "operand", "BR CC1 CC0 OV OS OR STA RLO /FC");
    for row in Instruction::ALL {
        let operand = match row.operand() {
            OperandClass::None => "",
            OperandClass::ScanBit | OperandClass::AssignBit => "bit",
            OperandClass::Timer => "timer",
            OperandClass::Counter => "counter",
            OperandClass::TimerOrCounter => "timer or counter",
            OperandClass::StatusWord => "STW",
            OperandClass::DataBlockInfo => "DBLG, DBNO, …",
            OperandClass::Label => "label",
            OperandClass::Call | OperandClass::CallBlock | OperandClass::OpenBlock => "block",
            OperandClass::Load | OperandClass::Transfer => "byte, word, dword",
            OperandClass::PointerSource
            | OperandClass::PointerSourceWithoutAr2
            | OperandClass::PointerTarget
            | OperandClass::PointerTargetWithoutAr2
            | OperandClass::OptionalPointerOffset => "pointer",
            _ => "constant",
        };
        let _ = writeln!(out, "{:<7} {:<7} {operand:<20} {}", row.english(), row.german(), status_columns(row.status_row()));
    }
    out.push_str("\n- not changed, 0 or 1 always that, x written with a result. `sieben explain RLO` and so on say what a bit holds.\n");
    out
}

/// Every jump, when it jumps, and what it does to the status word.
pub(super) fn jumps() -> String {
    let mut out = format!("{:<7} {:<7} {:<33} what it does\n", "English", "German", "BR CC1 CC0 OV OS OR STA RLO /FC");
    for row in Instruction::ALL.iter().filter(|row| row.operand() == OperandClass::Label) {
        let _ = writeln!(out, "{:<7} {:<7} {:<33} {}", row.english(), row.german(), status_columns(row.status_row()), row.doc());
    }
    out
}

/// Every format that a value can be shown in.
pub(super) fn formats() -> String {
    let mut out = String::from("A format follows a name after a colon: `--show MD20:REAL,MW24:INT,MB3:BIN`.\n\n");
    for row in ROWS {
        let names = [row.name].into_iter().chain(row.also.iter().copied()).collect::<Vec<_>>().join(", ");
        let fits = row.fits.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        out.push_str(&format!("  {names:<18} {:<34} of {fits}\n", row.notation));
    }
    out.push_str("\nOf a register a format of 16 bits shows the low word. Bits that a format does not know are shown in hex with a mark: `W#16#0A00 (no S5TIME)`.\n");
    out
}
