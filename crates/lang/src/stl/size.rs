//! How many bytes a code block has at least on a real CPU: the shortest MC7 encoding of each statement.
//!
//! It is a lower bound: STEP 7 may write more, above all around calls with parameters. So a block that is too large here is too large there.

use sieben_model::address::Area;
use sieben_model::block::BlockKind;
use sieben_model::literal::Value;

use super::instructions::Instruction;
use super::lower::Statement;
use super::operands::{Access, Actual, BlockOperand, Call, CallInstance, Location, NumberOperand, Operand};

/// An instruction without an address: opcode and one byte.
const SHORT: u64 = 2;
/// An instruction with a 16-bit address, number, offset or distance.
const LONG: u64 = 4;
/// An instruction with a 32-bit constant.
const WIDE: u64 = 6;
/// Behind each call of a function without parameters: a jump over an empty list.
const LIST_HEAD: u64 = 4;
/// Around each `CALL`: two brackets of the editor, and the RLO saved between them.
const CALL_FRAME: u64 = 2 * SHORT + LONG;

/// The bytes of all statements, with the end of the block that may be implied.
pub(crate) fn code_bytes(statements: &[Statement]) -> u64 {
    let ended = statements.last().is_some_and(|last| last.instruction == Instruction::BlockEnd);
    statements.iter().map(|statement| statement_bytes(statement.instruction, &statement.operand)).sum::<u64>()
        + if ended { 0 } else { SHORT }
}

/// The bytes of one statement.
pub(crate) fn statement_bytes(instruction: Instruction, operand: &Operand) -> u64 {
    let word = instruction.english();
    match operand {
        Operand::None | Operand::StatusWord | Operand::DataBlockInfo(_) | Operand::AddressRegister2 | Operand::Status(_) => SHORT,
        Operand::Memory(access) => access_bytes(word, access),
        Operand::Timer(number) | Operand::Counter(number) => match number {
            NumberOperand::Fixed(0..=255) if !matches!(word, "X" | "XN") => SHORT,
            _ => LONG,
        },
        Operand::Constant(value) => constant_bytes(word, value),
        Operand::Label(_) | Operand::ParameterAddress(_) => LONG,
        Operand::Block(block) => block_bytes(block),
        Operand::Call(call) => call_bytes(call),
        // Words that no real CPU has.
        Operand::Register(_) | Operand::Extension(_) => 0,
    }
}

fn access_bytes(word: &str, access: &Access) -> u64 {
    let short = matches!(word, "A" | "O" | "S" | "=" | "AN" | "ON" | "R" | "L" | "T");
    match access.location {
        Location::Fixed { area: Area::Input | Area::Output, position } if short && position / 8 < 128 => SHORT,
        Location::Fixed { area: Area::BitMemory, position } if short && position / 8 < 256 => SHORT,
        Location::InDataBlock { db, .. } => open_bytes(db) + LONG,
        Location::InInstanceBlock { .. } => 2 * LONG,
        _ => LONG,
    }
}

/// `OPN DB n`; `OPN DI n` has no short form.
fn open_bytes(db: u16) -> u64 {
    if db < 256 { SHORT } else { LONG }
}

fn constant_bytes(word: &str, value: &Value) -> u64 {
    match (word, value.width()) {
        // A shift count, a number of BLD or NOP, a byte: in the second byte of the instruction.
        ("SLW" | "SRW" | "SSI" | "SLD" | "SRD" | "SSD" | "RLD" | "RRD" | "INC" | "DEC" | "BLD" | "NOP", _) => SHORT,
        ("+AR1" | "+AR2", _) => LONG,
        ("LAR1" | "LAR2", _) => WIDE,
        ("L", ..=8) => SHORT,
        (_, ..=16) => LONG,
        _ => WIDE,
    }
}

fn block_bytes(block: &BlockOperand) -> u64 {
    let short = matches!(block.number, NumberOperand::Fixed(0..=255)) && !block.instance;
    match block.kind {
        BlockKind::Function => LIST_HEAD + if short { SHORT } else { LONG },
        BlockKind::SystemFunction => LIST_HEAD + LONG,
        BlockKind::FunctionBlock | BlockKind::DataBlock if short => SHORT,
        _ => LONG,
    }
}

fn call_bytes(call: &Call) -> u64 {
    let number = NumberOperand::Fixed(call.callee.number);
    let called = block_bytes(&BlockOperand { kind: call.callee.kind, instance: false, number });
    let given = call.parameters.iter().filter_map(|parameter| parameter.actual.as_ref());
    match call.instance {
        None => CALL_FRAME + called + LONG * call.parameters.len() as u64 + given.map(copied_bytes).sum::<u64>(),
        // AR2 saved, set and restored, the registers exchanged before and after, the instance opened; each value loaded and stored.
        Some(instance) => {
            let open = match instance {
                CallInstance::DataBlock(_) => LONG + WIDE,
                CallInstance::Multi(_) => SHORT + 3 * LONG,
            };
            CALL_FRAME + called + 2 * SHORT + 2 * LONG + open + given.map(|actual| load_bytes(actual) + LONG).sum::<u64>()
        }
    }
}

/// What a function cannot reach through a pointer to the place itself is copied into local data first.
fn copied_bytes(actual: &Actual) -> u64 {
    match actual {
        Actual::Memory(Access { location: Location::Fixed { area: Area::Input | Area::Output | Area::BitMemory, .. }, .. })
        | Actual::Timer(_)
        | Actual::Counter(_)
        | Actual::Block(_) => 0,
        _ => load_bytes(actual) + LONG,
    }
}

fn load_bytes(actual: &Actual) -> u64 {
    match actual {
        Actual::Memory(access) => access_bytes("L", access),
        Actual::Constant(value) => constant_bytes("L", value).min(WIDE),
        Actual::Timer(_) | Actual::Counter(_) | Actual::Block(_) => LONG,
        // A POINTER: the number of the data block and a pointer, loaded and stored.
        Actual::Complex { .. } => LONG + WIDE,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::Options;
    use crate::project::compile;
    use sieben_model::block::BlockId;
    use sieben_model::source::Sources;
    use sieben_model::symbols::SymbolTable;

    /// Bytes of a single statement of OB 1.
    fn bytes(statement: &str) -> u64 {
        let mut sources = Sources::default();
        let others = "FUNCTION FC 1 : VOID\nVAR_INPUT\n i : INT;\nEND_VAR\nBEGIN\nEND_FUNCTION\nFUNCTION FC 300 : VOID\nBEGIN\nEND_FUNCTION\n\
            FUNCTION_BLOCK FB 1\nVAR_INPUT\n i : INT;\nEND_VAR\nBEGIN\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 5 FB 1\nBEGIN\nEND_DATA_BLOCK\n\
            DATA_BLOCK DB 300 STRUCT\n w : WORD;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n";
        sources.add("size.awl", format!("{others}ORGANIZATION_BLOCK OB 1\nBEGIN\nx: {statement};\nEND_ORGANIZATION_BLOCK\n"));
        let compiled = compile(&sources, &SymbolTable::default(), &Options::default());
        assert!(!compiled.has_errors(), "{statement}: {:?}", compiled.diagnostics);
        let crate::CheckedBody::Stl(block) = &*compiled.bodies[&BlockId::ob(1)] else { unreachable!("the source is STL") };
        let statements = &block.statements;
        assert_eq!(code_bytes(statements), statement_bytes(statements[0].instruction, &statements[0].operand) + 2, "{statement} and BE");
        statement_bytes(statements[0].instruction, &statements[0].operand)
    }

    #[test]
    fn statements_have_the_sizes_of_their_encodings() {
        for (size, statements) in [
            (
                2,
                &[
                    "NOP 0",
                    "BLD 102",
                    "A I 0.0",
                    "= Q 127.7",
                    "R M 255.0",
                    "L MW 10",
                    "T QB 4",
                    "SD T 5",
                    "L T 255",
                    "A C 3",
                    "OPN DB 5",
                    "SLW 3",
                    "INC 5",
                    "+I",
                    "L B#16#10",
                    "AW",
                    "L STW",
                    "L DBNO",
                    "A ==0",
                    "+AR1",
                    "LAR1 AR2",
                    "CAR",
                    "SET",
                    "SAVE",
                ][..],
            ),
            (
                4,
                &[
                    "A I 128.0",
                    "X I 0.0",
                    "FP M 1.0",
                    "L MW 256",
                    "L PIW 256",
                    "L DBW 0",
                    "T LW 4",
                    "L 5",
                    "L W#16#1",
                    "L S5T#1S",
                    "L C#1",
                    "L 'ab'",
                    "+ 5",
                    "AW W#16#FF",
                    "JU x",
                    "LOOP x",
                    "SD T 256",
                    "X T 5",
                    "OPN DI 5",
                    "OPN DB 300",
                    "A M [MD 4]",
                    "L W [AR1,P#2.0]",
                    "= DBX [AR2,P#0.1]",
                    "LAR1 MD 4",
                    "+AR1 P#1.0",
                    "L T [MW 2]",
                ],
            ),
            (6, &["L L#5", "L 1.5", "L T#1S", "L P#M 1.0", "L 'abcd'", "+ L#5", "AD DW#16#1", "LAR1 P#10.0", "UC FC 1", "L DB5.DBW 0"]),
            (8, &["UC FC 300", "L DB300.DBW 0"]),
            // Frame, call, list head, one pointer.
            (18, &["CALL FC 1 (i := MW 0)"]),
            (26, &["CALL FC 1 (i := 5)"]),
            (38, &["CALL FB 1, DB 5 (i := MW 0)"]),
        ] {
            for statement in statements {
                assert_eq!(bytes(statement), size, "{statement}");
            }
        }
    }
}
