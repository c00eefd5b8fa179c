//! The instruction table: the single source of truth for STL.
//!
//! A row reads like a row of an instruction list. From `en` and `de` come parser, printer and conversion;
//! from `operand` the operand's grammar; from `status` the manual page and a test; from `why` the sentence that says in words why a
//! statement did what it did; from `meaning` the IR.

use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Inst, Op};
use sieben_engine::machine::{Register, TimerKind};
use sieben_model::extension::Relation;
use sieben_model::mnemonics::Mnemonics;

use super::lower::Lowering;
use super::meaning::accumulators::ACCU1;
use super::meaning::{
    accumulators, address_registers, bit_logic, compare, conversion, counters, data_blocks, extension, integer_math, jumps, load_transfer,
    logic_control, mcr, null, real_math, shift_rotate, timers, word_logic,
};
use super::operands::{Direction, Operand, OperandClass, StatusScan};
use crate::stl::why::{Joint, Number, Rounding, Sense, Sign, Way, Why};

/// What one status bit experiences: the manual's `-`, `0`, `1`, `x`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// `-`: not changed.
    Unaffected,
    /// `0`: always cleared.
    Cleared,
    /// `1`: always set.
    SetTo1,
    /// `x`: written with a result.
    Written,
}

/// The nine columns of a status row, in the order of the manual.
pub const STATUS_COLUMNS: [Register; 9] =
    [Register::Br, Register::Cc1, Register::Cc0, Register::Ov, Register::Os, Register::Or, Register::Sta, Register::Rlo, Register::Fc];

const fn effects(row: &str) -> [Effect; 9] {
    let bytes = row.as_bytes();
    assert!(bytes.len() == 17, "nine columns: BR CC1 CC0 OV OS OR STA RLO /FC");
    let mut out = [Effect::Unaffected; 9];
    let mut i = 0;
    while i < 9 {
        out[i] = match bytes[2 * i] {
            b'-' => Effect::Unaffected,
            b'0' => Effect::Cleared,
            b'1' => Effect::SetTo1,
            b'x' => Effect::Written,
            _ => panic!("a status column is one of - 0 1 x"),
        };
        i += 1;
    }
    out
}

macro_rules! instructions {
    ($( $(#[doc = $doc:literal])* $Name:ident { en: $en:literal, de: $de:literal, operand: $operand:ident, status: $status:literal, why: $why:expr, meaning: $meaning:expr } )*) => {
        /// One row of the instruction table. Instructions with several operand forms (`S M 1.0`, `S C 1`) have a row each.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Instruction {
            $($(#[doc = $doc])* $Name,)*
            /// A word of extended programs, which is no instruction of a CPU and therefore not in [`Self::ALL`]; its operand says which.
            Extension,
        }

        impl Instruction {
            /// All rows, by chapter.
            pub const ALL: &[Self] = &[$(Self::$Name),*];
            /// The name of the row.
            pub fn name(self) -> &'static str { match self { $(Self::$Name => stringify!($Name),)* Self::Extension => "Extension" } }
            /// The international mnemonic.
            pub fn english(self) -> &'static str { match self { $(Self::$Name => $en,)* Self::Extension => super::extension::PREFIX } }
            /// The SIMATIC mnemonic.
            pub fn german(self) -> &'static str { match self { $(Self::$Name => $de,)* Self::Extension => super::extension::PREFIX } }
            /// What it does, in one sentence.
            pub fn doc(self) -> &'static str { match self { $(Self::$Name => concat!($($doc),*).trim_ascii(),)* Self::Extension => "A word of extended programs." } }
            /// What operand it takes.
            pub fn operand(self) -> OperandClass { match self { $(Self::$Name => OperandClass::$operand,)* Self::Extension => OperandClass::Extension } }
            /// The status row: BR CC1 CC0 OV OS OR STA RLO /FC.
            pub fn status_row(self) -> &'static str { match self { $(Self::$Name => $status,)* Self::Extension => super::extension::STATUS } }
            /// The status row by column, see [`STATUS_COLUMNS`].
            pub fn status(self) -> [Effect; 9] { match self { $(Self::$Name => const { effects($status) },)* Self::Extension => const { effects(super::extension::STATUS) } } }
            /// The kind of reason that says why a statement with this instruction did what it did.
            pub fn why(self) -> Why { use Why::*; match self { $(Self::$Name => $why,)* Self::Extension => Why::Extension } }
            /// Writes the IR of a statement with this instruction.
            pub(crate) fn lower(self, lowering: &mut Lowering<'_>, operand: &Operand) {
                let meaning: fn(&mut Lowering<'_>, &Operand) = match self { $(Self::$Name => $meaning,)* Self::Extension => extension::lower };
                meaning(lowering, operand);
            }
        }
    };
}

impl Instruction {
    /// What a statement with this instruction does with its variable; `None` if its operand is none.
    pub fn direction(self) -> Option<Direction> {
        match self {
            // The edge memory is compared with the RLO before it takes it.
            Self::EdgePositive | Self::EdgeNegative => Some(Direction::ReadWrite),
            _ => self.operand().direction(),
        }
    }

    /// The mnemonic in a language.
    pub fn mnemonic(self, mnemonics: Mnemonics) -> &'static str {
        match mnemonics {
            Mnemonics::English => self.english(),
            Mnemonics::German => self.german(),
        }
    }

    /// All rows with this mnemonic (without regard to case) in a language.
    pub fn candidates(word: &str, mnemonics: Mnemonics) -> impl Iterator<Item = Self> + use<'_> {
        static INDEX: std::sync::LazyLock<[std::collections::HashMap<&'static str, Vec<Instruction>>; 2]> =
            std::sync::LazyLock::new(|| {
                [Mnemonics::English, Mnemonics::German].map(|mnemonics| {
                    let mut index = std::collections::HashMap::<_, Vec<_>>::new();
                    for &instruction in Instruction::ALL {
                        index.entry(instruction.mnemonic(mnemonics)).or_default().push(instruction);
                    }
                    index
                })
            });
        let index = &INDEX[usize::from(mnemonics == Mnemonics::German)];
        let rows = match index.get(word) {
            Some(rows) => Some(rows),
            None => index.get(word.to_ascii_uppercase().as_str()),
        };
        rows.into_iter().flatten().copied()
    }
}

instructions! {

// Bit logic.
/// AND: combines the RLO with a bit, or begins a logic string with it.
And { en: "A", de: "U", operand: ScanBit, status: "- - - - - x x x 1", why: Scan(Joint::And, Sense::Plain), meaning: |l, o| bit_logic::scan(l, o, Op::ScanAnd) }
/// AND NOT: combines the RLO with an inverted bit, or begins a logic string with it.
AndNot { en: "AN", de: "UN", operand: ScanBit, status: "- - - - - x x x 1", why: Scan(Joint::And, Sense::Inverted), meaning: |l, o| bit_logic::scan(l, o, Op::ScanAndNot) }
/// OR: combines the RLO with a bit, or begins a logic string with it.
Or { en: "O", de: "O", operand: ScanBit, status: "- - - - - 0 x x 1", why: Scan(Joint::Or, Sense::Plain), meaning: |l, o| bit_logic::scan(l, o, Op::ScanOr) }
/// OR NOT: combines the RLO with an inverted bit, or begins a logic string with it.
OrNot { en: "ON", de: "ON", operand: ScanBit, status: "- - - - - 0 x x 1", why: Scan(Joint::Or, Sense::Inverted), meaning: |l, o| bit_logic::scan(l, o, Op::ScanOrNot) }
/// Exclusive OR of the RLO and a bit, or begins a logic string with the bit.
Xor { en: "X", de: "X", operand: ScanBit, status: "- - - - - 0 x x 1", why: Scan(Joint::Xor, Sense::Plain), meaning: |l, o| bit_logic::scan(l, o, Op::ScanXor) }
/// Exclusive OR of the RLO and an inverted bit, or begins a logic string with the inverted bit.
XorNot { en: "XN", de: "XN", operand: ScanBit, status: "- - - - - 0 x x 1", why: Scan(Joint::Xor, Sense::Inverted), meaning: |l, o| bit_logic::scan(l, o, Op::ScanXorNot) }
/// AND before OR: joins two AND strings by OR.
OrSeparator { en: "O", de: "O", operand: None, status: "- - - - - x 1 - x", why: OrSeparator, meaning: |l, _| bit_logic::or_separator(l) }
/// Opens a bracket whose result is combined by AND.
AndOpen { en: "A(", de: "U(", operand: None, status: "- - - - - 0 1 - 0", why: Open(Joint::And, Sense::Plain), meaning: |l, _| bit_logic::open_bracket(l, 0) }
/// Opens a bracket whose result is combined by AND NOT.
AndNotOpen { en: "AN(", de: "UN(", operand: None, status: "- - - - - 0 1 - 0", why: Open(Joint::And, Sense::Inverted), meaning: |l, _| bit_logic::open_bracket(l, 1) }
/// Opens a bracket whose result is combined by OR.
OrOpen { en: "O(", de: "O(", operand: None, status: "- - - - - 0 1 - 0", why: Open(Joint::Or, Sense::Plain), meaning: |l, _| bit_logic::open_bracket(l, 2) }
/// Opens a bracket whose result is combined by OR NOT.
OrNotOpen { en: "ON(", de: "ON(", operand: None, status: "- - - - - 0 1 - 0", why: Open(Joint::Or, Sense::Inverted), meaning: |l, _| bit_logic::open_bracket(l, 3) }
/// Opens a bracket whose result is combined by exclusive OR.
XorOpen { en: "X(", de: "X(", operand: None, status: "- - - - - 0 1 - 0", why: Open(Joint::Xor, Sense::Plain), meaning: |l, _| bit_logic::open_bracket(l, 4) }
/// Opens a bracket whose result is combined by exclusive OR NOT.
XorNotOpen { en: "XN(", de: "XN(", operand: None, status: "- - - - - 0 1 - 0", why: Open(Joint::Xor, Sense::Inverted), meaning: |l, _| bit_logic::open_bracket(l, 5) }
/// Closes a bracket and combines its result with the RLO saved when it was opened.
CloseBracket { en: ")", de: ")", operand: None, status: "x - - - - x 1 x 1", why: Close, meaning: |l, _| bit_logic::close_bracket(l) }
/// Assigns the RLO to a bit (0 in a switched-off MCR zone).
Assign { en: "=", de: "=", operand: AssignBit, status: "- - - - - 0 x - 0", why: Assign, meaning: |l, o| bit_logic::assign(l, o) }
/// Sets a bit to 1 if the RLO is 1.
Set { en: "S", de: "S", operand: AssignBit, status: "- - - - - 0 x - 0", why: Set, meaning: |l, o| bit_logic::set_reset(l, o, Op::SetBit) }
/// Resets a bit to 0 if the RLO is 1.
Reset { en: "R", de: "R", operand: AssignBit, status: "- - - - - 0 x - 0", why: Reset, meaning: |l, o| bit_logic::set_reset(l, o, Op::ResetBit) }
/// Negates the RLO.
Not { en: "NOT", de: "NOT", operand: None, status: "- - - - - - 1 x -", why: Not, meaning: |l, _| bit_logic::not(l) }
/// Sets the RLO to 1.
SetRlo { en: "SET", de: "SET", operand: None, status: "- - - - - 0 1 1 0", why: ConstantRlo, meaning: |l, _| bit_logic::constant_rlo(l, 1) }
/// Clears the RLO to 0.
ClearRlo { en: "CLR", de: "CLR", operand: None, status: "- - - - - 0 0 0 0", why: ConstantRlo, meaning: |l, _| bit_logic::constant_rlo(l, 0) }
/// Saves the RLO in the BR bit.
Save { en: "SAVE", de: "SAVE", operand: None, status: "x - - - - - - - -", why: Save, meaning: |l, _| l.b.copy(Register::Br, Register::Rlo) }
/// Positive edge: the RLO is 1 if it was 0 in the edge memory bit and is 1 now.
EdgePositive { en: "FP", de: "FP", operand: AssignBit, status: "- - - - - 0 x x 1", why: Rising, meaning: |l, o| bit_logic::edge(l, o, true) }
/// Negative edge: the RLO is 1 if it was 1 in the edge memory bit and is 0 now.
EdgeNegative { en: "FN", de: "FN", operand: AssignBit, status: "- - - - - 0 x x 1", why: Falling, meaning: |l, o| bit_logic::edge(l, o, false) }

// Mcr.
/// Activates the master control relay in this block.
McrActivate { en: "MCRA", de: "MCRA", operand: None, status: "- - - - - - - - -", why: McrActivate, meaning: |l, _| l.b.set(Register::Ma, 1) }
/// Deactivates the master control relay in this block.
McrDeactivate { en: "MCRD", de: "MCRD", operand: None, status: "- - - - - - - - -", why: McrDeactivate, meaning: |l, _| l.b.set(Register::Ma, 0) }
/// Opens an MCR zone that the RLO switches on or off.
McrOpen { en: "MCR(", de: "MCR(", operand: None, status: "- - - - - 0 1 - 0", why: McrOpen, meaning: |l, _| mcr::open(l) }
/// Closes the newest MCR zone.
McrClose { en: ")MCR", de: ")MCR", operand: None, status: "- - - - - 0 1 - 0", why: McrClose, meaning: |l, _| mcr::close(l) }

// Load transfer.
/// Loads a value into ACCU 1; ACCU 2 receives the old ACCU 1.
Load { en: "L", de: "L", operand: Load, status: "- - - - - - - - -", why: Load, meaning: |l, o| load_transfer::load(l, o) }
/// Loads the status word into ACCU 1 (S7-300: without /FC, STA and OR).
LoadStatusWord { en: "L", de: "L", operand: StatusWord, status: "- - - - - - - - -", why: LoadStatusWord, meaning: |l, _| load_transfer::load_status_word(l) }

// Data blocks.
/// Loads number or length of an open data block into ACCU 1.
LoadDataBlockInfo { en: "L", de: "L", operand: DataBlockInfo, status: "- - - - - - - - -", why: LoadDataBlockInfo, meaning: |l, o| data_blocks::load_data_block_info(l, o) }

// Load transfer.
/// Loads the value of a timer (with time base) or counter as BCD number.
LoadBcd { en: "LC", de: "LC", operand: TimerOrCounter, status: "- - - - - - - - -", why: LoadBcd, meaning: |l, o| load_transfer::load_bcd(l, o) }
/// Transfers ACCU 1 to memory (0 in a switched-off MCR zone).
Transfer { en: "T", de: "T", operand: Transfer, status: "- - - - - - - - -", why: Transfer, meaning: |l, o| load_transfer::transfer(l, o) }
/// Transfers ACCU 1 to the status word (S7-300: not to /FC, STA and OR).
TransferStatusWord { en: "T", de: "T", operand: StatusWord, status: "x x x x x x x x x", why: TransferStatusWord, meaning: |l, _| load_transfer::transfer_status_word(l) }

// Address registers.
/// Loads AR1 with ACCU 1.
LoadAr1 { en: "LAR1", de: "LAR1", operand: None, status: "- - - - - - - - -", why: LoadPointer(Register::Ar1), meaning: |l, _| l.b.copy(Register::Ar1, Register::Accu1) }
/// Loads AR1 with a double word, a pointer or AR2.
LoadAr1From { en: "LAR1", de: "LAR1", operand: PointerSource, status: "- - - - - - - - -", why: LoadPointer(Register::Ar1), meaning: |l, o| address_registers::load(l, o, Register::Ar1) }
/// Transfers AR1 to ACCU 1; ACCU 2 receives the old ACCU 1.
TransferAr1 { en: "TAR1", de: "TAR1", operand: None, status: "- - - - - - - - -", why: StorePointer(Register::Ar1), meaning: |l, _| address_registers::to_accumulator(l, Register::Ar1) }
/// Transfers AR1 to a double word or to AR2.
TransferAr1To { en: "TAR1", de: "TAR1", operand: PointerTarget, status: "- - - - - - - - -", why: StorePointer(Register::Ar1), meaning: |l, o| address_registers::transfer(l, o, Register::Ar1) }
/// Loads AR2 with ACCU 1.
LoadAr2 { en: "LAR2", de: "LAR2", operand: None, status: "- - - - - - - - -", why: LoadPointer(Register::Ar2), meaning: |l, _| l.b.copy(Register::Ar2, Register::Accu1) }
/// Loads AR2 with a double word or a pointer.
LoadAr2From { en: "LAR2", de: "LAR2", operand: PointerSourceWithoutAr2, status: "- - - - - - - - -", why: LoadPointer(Register::Ar2), meaning: |l, o| address_registers::load(l, o, Register::Ar2) }
/// Transfers AR2 to ACCU 1; ACCU 2 receives the old ACCU 1.
TransferAr2 { en: "TAR2", de: "TAR2", operand: None, status: "- - - - - - - - -", why: StorePointer(Register::Ar2), meaning: |l, _| address_registers::to_accumulator(l, Register::Ar2) }
/// Transfers AR2 to a double word.
TransferAr2To { en: "TAR2", de: "TAR2", operand: PointerTargetWithoutAr2, status: "- - - - - - - - -", why: StorePointer(Register::Ar2), meaning: |l, o| address_registers::transfer(l, o, Register::Ar2) }
/// Exchanges AR1 and AR2.
SwapAr { en: "CAR", de: "TAR", operand: None, status: "- - - - - - - - -", why: SwapPointers, meaning: |l, _| address_registers::swap(l) }
/// Adds ACCU 1 (16 bit, signed) or a pointer constant to AR1.
AddAr1 { en: "+AR1", de: "+AR1", operand: OptionalPointerOffset, status: "- - - - - - - - -", why: AddPointer(Register::Ar1), meaning: |l, o| address_registers::add(l, o, Register::Ar1) }
/// Adds ACCU 1 (16 bit, signed) or a pointer constant to AR2.
AddAr2 { en: "+AR2", de: "+AR2", operand: OptionalPointerOffset, status: "- - - - - - - - -", why: AddPointer(Register::Ar2), meaning: |l, o| address_registers::add(l, o, Register::Ar2) }

// Accumulators.
/// Exchanges ACCU 1 and ACCU 2.
Swap { en: "TAK", de: "TAK", operand: None, status: "- - - - - - - - -", why: Swap, meaning: |l, _| accumulators::swap(l) }
/// Copies ACCU 1 to ACCU 2 (4 accumulators: the others move up).
Push { en: "PUSH", de: "PUSH", operand: None, status: "- - - - - - - - -", why: Push, meaning: |l, _| accumulators::push(l) }
/// Copies ACCU 2 to ACCU 1 (4 accumulators: the others move down).
Pop { en: "POP", de: "POP", operand: None, status: "- - - - - - - - -", why: Pop, meaning: |l, _| accumulators::pop(l) }
/// Copies ACCU 3 to ACCU 4 and ACCU 2 to ACCU 3 (4 accumulators only).
Enter { en: "ENT", de: "ENT", operand: None, status: "- - - - - - - - -", why: Enter, meaning: |l, _| accumulators::enter(l) }
/// Copies ACCU 3 to ACCU 2 and ACCU 4 to ACCU 3 (4 accumulators only).
Leave { en: "LEAVE", de: "LEAVE", operand: None, status: "- - - - - - - - -", why: Leave, meaning: |l, _| accumulators::leave(l) }
/// Exchanges the bytes of the low word of ACCU 1.
SwapBytesWord { en: "CAW", de: "TAW", operand: None, status: "- - - - - - - - -", why: SwapBytes(Number::Int), meaning: |l, _| l.b.compute_into(Register::Accu1, Op::Swap16, &[ACCU1]) }
/// Reverses the bytes of ACCU 1.
SwapBytesDouble { en: "CAD", de: "TAD", operand: None, status: "- - - - - - - - -", why: SwapBytes(Number::Double), meaning: |l, _| l.b.compute_into(Register::Accu1, Op::Swap32, &[ACCU1]) }
/// Adds a constant to the low byte of ACCU 1.
Increment { en: "INC", de: "INC", operand: ByteConstant, status: "- - - - - - - - -", why: Step(Sign::Add), meaning: |l, o| accumulators::increment(l, o, Op::AddU32) }
/// Subtracts a constant from the low byte of ACCU 1.
Decrement { en: "DEC", de: "DEC", operand: ByteConstant, status: "- - - - - - - - -", why: Step(Sign::Subtract), meaning: |l, o| accumulators::increment(l, o, Op::SubU32) }

// Integer math.
/// Adds a 16-bit integer constant to the low word of ACCU 1.
AddIntConstant { en: "+", de: "+", operand: IntConstant, status: "- - - - - - - - -", why: AddConstant(Number::Int), meaning: |l, o| integer_math::add_constant16(l, o) }
/// Adds a 32-bit integer constant to ACCU 1.
AddDoubleConstant { en: "+", de: "+", operand: DoubleIntConstant, status: "- - - - - - - - -", why: AddConstant(Number::Double), meaning: |l, o| integer_math::add_constant32(l, o) }
/// Adds ACCU 2 and ACCU 1 as 16-bit integers.
AddInt { en: "+I", de: "+I", operand: None, status: "- x x x x - - - -", why: Arithmetic(Number::Int, Sign::Add), meaning: |l, _| integer_math::add16(l, Op::AddI16Wide) }
/// Subtracts ACCU 1 from ACCU 2 as 16-bit integers.
SubtractInt { en: "-I", de: "-I", operand: None, status: "- x x x x - - - -", why: Arithmetic(Number::Int, Sign::Subtract), meaning: |l, _| integer_math::add16(l, Op::SubI16Wide) }
/// Multiplies ACCU 2 by ACCU 1 as 16-bit integers; the product has 32 bits.
MultiplyInt { en: "*I", de: "*I", operand: None, status: "- x x x x - - - -", why: Arithmetic(Number::Int, Sign::Multiply), meaning: |l, _| integer_math::multiply16(l) }
/// Divides ACCU 2 by ACCU 1 as 16-bit integers: quotient in the low word, remainder in the high word of ACCU 1.
DivideInt { en: "/I", de: "/I", operand: None, status: "- x x x x - - - -", why: Arithmetic(Number::Int, Sign::Divide), meaning: |l, _| integer_math::divide16(l) }
/// Adds ACCU 2 and ACCU 1 as 32-bit integers.
AddDouble { en: "+D", de: "+D", operand: None, status: "- x x x x - - - -", why: Arithmetic(Number::Double, Sign::Add), meaning: |l, _| integer_math::add32(l, Op::AddI32Wide) }
/// Subtracts ACCU 1 from ACCU 2 as 32-bit integers.
SubtractDouble { en: "-D", de: "-D", operand: None, status: "- x x x x - - - -", why: Arithmetic(Number::Double, Sign::Subtract), meaning: |l, _| integer_math::add32(l, Op::SubI32Wide) }
/// Multiplies ACCU 2 by ACCU 1 as 32-bit integers.
MultiplyDouble { en: "*D", de: "*D", operand: None, status: "- x x x x - - - -", why: Arithmetic(Number::Double, Sign::Multiply), meaning: |l, _| integer_math::multiply32(l) }
/// Divides ACCU 2 by ACCU 1 as 32-bit integers, without remainder.
DivideDouble { en: "/D", de: "/D", operand: None, status: "- x x x x - - - -", why: Arithmetic(Number::Double, Sign::Divide), meaning: |l, _| integer_math::divide32(l, Op::DivI32Wide) }
/// Remainder of ACCU 2 divided by ACCU 1 as 32-bit integers.
Modulo { en: "MOD", de: "MOD", operand: None, status: "- x x x x - - - -", why: Arithmetic(Number::Double, Sign::Modulo), meaning: |l, _| integer_math::divide32(l, Op::RemI32Wide) }

// Conversion.
/// Negates the low word of ACCU 1 (two's complement).
NegateInt { en: "NEGI", de: "NEGI", operand: None, status: "- x x x x - - - -", why: Negate(Number::Int), meaning: |l, _| conversion::negate16(l) }
/// Negates ACCU 1 (two's complement).
NegateDouble { en: "NEGD", de: "NEGD", operand: None, status: "- x x x x - - - -", why: Negate(Number::Double), meaning: |l, _| conversion::negate32(l) }
/// Inverts all bits of the low word of ACCU 1.
InvertInt { en: "INVI", de: "INVI", operand: None, status: "- - - - - - - - -", why: Invert(Number::Int), meaning: |l, _| conversion::invert(l, 0xFFFF) }
/// Inverts all bits of ACCU 1.
InvertDouble { en: "INVD", de: "INVD", operand: None, status: "- - - - - - - - -", why: Invert(Number::Double), meaning: |l, _| conversion::invert(l, 0xFFFF_FFFF) }

// Real math.
/// Adds ACCU 2 and ACCU 1 as REAL.
AddReal { en: "+R", de: "+R", operand: None, status: "- x x x x - - - -", why: Arithmetic(Number::Real, Sign::Add), meaning: |l, _| real_math::binary(l, Op::AddF32) }
/// Subtracts ACCU 1 from ACCU 2 as REAL.
SubtractReal { en: "-R", de: "-R", operand: None, status: "- x x x x - - - -", why: Arithmetic(Number::Real, Sign::Subtract), meaning: |l, _| real_math::binary(l, Op::SubF32) }
/// Multiplies ACCU 2 by ACCU 1 as REAL.
MultiplyReal { en: "*R", de: "*R", operand: None, status: "- x x x x - - - -", why: Arithmetic(Number::Real, Sign::Multiply), meaning: |l, _| real_math::binary(l, Op::MulF32) }
/// Divides ACCU 2 by ACCU 1 as REAL.
DivideReal { en: "/R", de: "/R", operand: None, status: "- x x x x - - - -", why: Arithmetic(Number::Real, Sign::Divide), meaning: |l, _| real_math::binary(l, Op::DivF32) }
/// Absolute value of the REAL in ACCU 1.
AbsoluteReal { en: "ABS", de: "ABS", operand: None, status: "- - - - - - - - -", why: Absolute, meaning: |l, _| real_math::sign(l, Op::AbsF32) }
/// Negates the REAL in ACCU 1.
NegateReal { en: "NEGR", de: "NEGR", operand: None, status: "- - - - - - - - -", why: Negate(Number::Real), meaning: |l, _| real_math::sign(l, Op::NegF32) }
/// Square of the REAL in ACCU 1.
Square { en: "SQR", de: "SQR", operand: None, status: "- x x x x - - - -", why: Function("SQR"), meaning: |l, _| real_math::function(l, Op::SqrF32) }
/// Square root of the REAL in ACCU 1.
SquareRoot { en: "SQRT", de: "SQRT", operand: None, status: "- x x x x - - - -", why: Function("SQRT"), meaning: |l, _| real_math::function(l, Op::SqrtF32) }
/// Exponential value (base e) of the REAL in ACCU 1.
Exponential { en: "EXP", de: "EXP", operand: None, status: "- x x x x - - - -", why: Function("EXP"), meaning: |l, _| real_math::function(l, Op::ExpF32) }
/// Natural logarithm of the REAL in ACCU 1.
Logarithm { en: "LN", de: "LN", operand: None, status: "- x x x x - - - -", why: Function("LN"), meaning: |l, _| real_math::function(l, Op::LnF32) }
/// Sine (radians) of the REAL in ACCU 1.
Sine { en: "SIN", de: "SIN", operand: None, status: "- x x x x - - - -", why: Function("SIN"), meaning: |l, _| real_math::function(l, Op::SinF32) }
/// Cosine (radians) of the REAL in ACCU 1.
Cosine { en: "COS", de: "COS", operand: None, status: "- x x x x - - - -", why: Function("COS"), meaning: |l, _| real_math::function(l, Op::CosF32) }
/// Tangent (radians) of the REAL in ACCU 1.
Tangent { en: "TAN", de: "TAN", operand: None, status: "- x x x x - - - -", why: Function("TAN"), meaning: |l, _| real_math::function(l, Op::TanF32) }
/// Arc sine (radians) of the REAL in ACCU 1.
ArcSine { en: "ASIN", de: "ASIN", operand: None, status: "- x x x x - - - -", why: Function("ASIN"), meaning: |l, _| real_math::function(l, Op::AsinF32) }
/// Arc cosine (radians) of the REAL in ACCU 1.
ArcCosine { en: "ACOS", de: "ACOS", operand: None, status: "- x x x x - - - -", why: Function("ACOS"), meaning: |l, _| real_math::function(l, Op::AcosF32) }
/// Arc tangent (radians) of the REAL in ACCU 1.
ArcTangent { en: "ATAN", de: "ATAN", operand: None, status: "- x x x x - - - -", why: Function("ATAN"), meaning: |l, _| real_math::function(l, Op::AtanF32) }

// Conversion.
/// Converts a three-digit BCD number in ACCU 1 to a 16-bit integer.
BcdToInt { en: "BTI", de: "BTI", operand: None, status: "- - - - - - - - -", why: FromBcd(Number::Int), meaning: |l, _| conversion::bcd_to_integer(l, Op::IsBcd16, Op::BcdToI16, true) }
/// Converts a seven-digit BCD number in ACCU 1 to a 32-bit integer.
BcdToDouble { en: "BTD", de: "BTD", operand: None, status: "- - - - - - - - -", why: FromBcd(Number::Double), meaning: |l, _| conversion::bcd_to_integer(l, Op::IsBcd32, Op::BcdToI32, false) }
/// Converts a 16-bit integer in ACCU 1 to a three-digit BCD number.
IntToBcd { en: "ITB", de: "ITB", operand: None, status: "- - - x x - - - -", why: ToBcd(Number::Int), meaning: |l, _| conversion::integer_to_bcd(l, Op::OverflowsBcd16, Op::I16ToBcd, true) }
/// Converts a 32-bit integer in ACCU 1 to a seven-digit BCD number.
DoubleToBcd { en: "DTB", de: "DTB", operand: None, status: "- - - x x - - - -", why: ToBcd(Number::Double), meaning: |l, _| conversion::integer_to_bcd(l, Op::OverflowsBcd32, Op::I32ToBcd, false) }
/// Extends a 16-bit integer in ACCU 1 to 32 bits with its sign.
IntToDouble { en: "ITD", de: "ITD", operand: None, status: "- - - - - - - - -", why: Widen, meaning: |l, _| l.b.compute_into(Register::Accu1, Op::Extend16, &[ACCU1]) }
/// Converts a 32-bit integer in ACCU 1 to a REAL.
DoubleToReal { en: "DTR", de: "DTR", operand: None, status: "- - - - - - - - -", why: ToReal, meaning: |l, _| l.b.compute_into(Register::Accu1, Op::I32ToF32, &[ACCU1]) }
/// Converts the REAL in ACCU 1 to a 32-bit integer, rounded to the nearest (even) integer.
Round { en: "RND", de: "RND", operand: None, status: "- - - x x - - - -", why: Round(Rounding::Nearest), meaning: |l, _| conversion::round(l, Op::RoundF32) }
/// Converts the REAL in ACCU 1 to a 32-bit integer, rounded up to the next greater integer.
RoundUp { en: "RND+", de: "RND+", operand: None, status: "- - - x x - - - -", why: Round(Rounding::Up), meaning: |l, _| conversion::round(l, Op::CeilF32) }
/// Converts the REAL in ACCU 1 to a 32-bit integer, rounded down to the next smaller integer.
RoundDown { en: "RND-", de: "RND-", operand: None, status: "- - - x x - - - -", why: Round(Rounding::Down), meaning: |l, _| conversion::round(l, Op::FloorF32) }
/// Converts the REAL in ACCU 1 to a 32-bit integer, rounded towards zero.
Truncate { en: "TRUNC", de: "TRUNC", operand: None, status: "- - - x x - - - -", why: Round(Rounding::Zero), meaning: |l, _| conversion::round(l, Op::TruncF32) }

// Shift rotate.
/// Shifts the low word of ACCU 1 right, filling with the sign. The count is a constant or the low byte of ACCU 2.
ShiftSignedInt { en: "SSI", de: "SSI", operand: ShiftCount16, status: "- x x x - - - - -", why: ShiftSigned(Number::Int), meaning: |l, o| shift_rotate::shift(l, o, Op::Sar16, Op::Sar16Out, true) }
/// Shifts ACCU 1 right, filling with the sign. The count is a constant or the low byte of ACCU 2.
ShiftSignedDouble { en: "SSD", de: "SSD", operand: ShiftCount32, status: "- x x x - - - - -", why: ShiftSigned(Number::Double), meaning: |l, o| shift_rotate::shift(l, o, Op::Sar32, Op::Sar32Out, false) }
/// Shifts the low word of ACCU 1 left. The count is a constant or the low byte of ACCU 2.
ShiftLeftWord { en: "SLW", de: "SLW", operand: ShiftCount16, status: "- x x x - - - - -", why: Shift(Number::Int, Way::Left), meaning: |l, o| shift_rotate::shift(l, o, Op::Shl16, Op::Shl16Out, true) }
/// Shifts the low word of ACCU 1 right. The count is a constant or the low byte of ACCU 2.
ShiftRightWord { en: "SRW", de: "SRW", operand: ShiftCount16, status: "- x x x - - - - -", why: Shift(Number::Int, Way::Right), meaning: |l, o| shift_rotate::shift(l, o, Op::Shr16, Op::Shr16Out, true) }
/// Shifts ACCU 1 left. The count is a constant or the low byte of ACCU 2.
ShiftLeftDouble { en: "SLD", de: "SLD", operand: ShiftCount32, status: "- x x x - - - - -", why: Shift(Number::Double, Way::Left), meaning: |l, o| shift_rotate::shift(l, o, Op::Shl32, Op::Shl32Out, false) }
/// Shifts ACCU 1 right. The count is a constant or the low byte of ACCU 2.
ShiftRightDouble { en: "SRD", de: "SRD", operand: ShiftCount32, status: "- x x x - - - - -", why: Shift(Number::Double, Way::Right), meaning: |l, o| shift_rotate::shift(l, o, Op::Shr32, Op::Shr32Out, false) }
/// Rotates ACCU 1 left. The count is a constant or the low byte of ACCU 2.
RotateLeft { en: "RLD", de: "RLD", operand: ShiftCount32, status: "- x x x - - - - -", why: Rotate(Way::Left), meaning: |l, o| shift_rotate::rotate(l, o, Op::Rol32, Op::LowestBit) }
/// Rotates ACCU 1 right. The count is a constant or the low byte of ACCU 2.
RotateRight { en: "RRD", de: "RRD", operand: ShiftCount32, status: "- x x x - - - - -", why: Rotate(Way::Right), meaning: |l, o| shift_rotate::rotate(l, o, Op::Ror32, Op::HighestBit) }
/// Rotates ACCU 1 left by one bit through CC 1.
RotateLeftThroughCc { en: "RLDA", de: "RLDA", operand: None, status: "- x 0 0 - - - - -", why: RotateThrough(Way::Left), meaning: |l, _| shift_rotate::rotate_through_cc1(l, Op::Rol33, Op::HighestBit) }
/// Rotates ACCU 1 right by one bit through CC 1.
RotateRightThroughCc { en: "RRDA", de: "RRDA", operand: None, status: "- x 0 0 - - - - -", why: RotateThrough(Way::Right), meaning: |l, _| shift_rotate::rotate_through_cc1(l, Op::Ror33, Op::LowestBit) }

// Word logic.
/// Combines the low words of ACCU 1 and ACCU 2 (or a constant) by AND.
AndWord { en: "AW", de: "UW", operand: OptionalConstant16, status: "- x 0 0 - - - - -", why: WordLogic(Joint::And, Number::Int), meaning: |l, o| word_logic::combine(l, o, Op::AndU32, true) }
/// Combines the low words of ACCU 1 and ACCU 2 (or a constant) by OR.
OrWord { en: "OW", de: "OW", operand: OptionalConstant16, status: "- x 0 0 - - - - -", why: WordLogic(Joint::Or, Number::Int), meaning: |l, o| word_logic::combine(l, o, Op::OrU32, true) }
/// Combines the low words of ACCU 1 and ACCU 2 (or a constant) by exclusive OR.
XorWord { en: "XOW", de: "XOW", operand: OptionalConstant16, status: "- x 0 0 - - - - -", why: WordLogic(Joint::Xor, Number::Int), meaning: |l, o| word_logic::combine(l, o, Op::XorU32, true) }
/// Combines all bits of ACCU 1 and ACCU 2 (or a constant) by AND.
AndDouble { en: "AD", de: "UD", operand: OptionalConstant32, status: "- x 0 0 - - - - -", why: WordLogic(Joint::And, Number::Double), meaning: |l, o| word_logic::combine(l, o, Op::AndU32, false) }
/// Combines all bits of ACCU 1 and ACCU 2 (or a constant) by OR.
OrDouble { en: "OD", de: "OD", operand: OptionalConstant32, status: "- x 0 0 - - - - -", why: WordLogic(Joint::Or, Number::Double), meaning: |l, o| word_logic::combine(l, o, Op::OrU32, false) }
/// Combines all bits of ACCU 1 and ACCU 2 (or a constant) by exclusive OR.
XorDouble { en: "XOD", de: "XOD", operand: OptionalConstant32, status: "- x 0 0 - - - - -", why: WordLogic(Joint::Xor, Number::Double), meaning: |l, o| word_logic::combine(l, o, Op::XorU32, false) }

// Compare.
/// Compares: the RLO is 1 if ACCU 2 is equal to ACCU 1, as 16-bit integers.
EqualInt { en: "==I", de: "==I", operand: None, status: "- x x 0 - 0 x x 1", why: Compare(Number::Int, Relation::Equal), meaning: |l, _| compare::integer(l, Op::EqI16, Op::GtI16, Op::LtI16) }
/// Compares: the RLO is 1 if ACCU 2 is not equal to ACCU 1, as 16-bit integers.
NotEqualInt { en: "<>I", de: "<>I", operand: None, status: "- x x 0 - 0 x x 1", why: Compare(Number::Int, Relation::NotEqual), meaning: |l, _| compare::integer(l, Op::NeI16, Op::GtI16, Op::LtI16) }
/// Compares: the RLO is 1 if ACCU 2 is greater than ACCU 1, as 16-bit integers.
GreaterInt { en: ">I", de: ">I", operand: None, status: "- x x 0 - 0 x x 1", why: Compare(Number::Int, Relation::Greater), meaning: |l, _| compare::integer(l, Op::GtI16, Op::GtI16, Op::LtI16) }
/// Compares: the RLO is 1 if ACCU 2 is less than ACCU 1, as 16-bit integers.
LessInt { en: "<I", de: "<I", operand: None, status: "- x x 0 - 0 x x 1", why: Compare(Number::Int, Relation::Less), meaning: |l, _| compare::integer(l, Op::LtI16, Op::GtI16, Op::LtI16) }
/// Compares: the RLO is 1 if ACCU 2 is greater than or equal to ACCU 1, as 16-bit integers.
GreaterEqualInt { en: ">=I", de: ">=I", operand: None, status: "- x x 0 - 0 x x 1", why: Compare(Number::Int, Relation::GreaterEqual), meaning: |l, _| compare::integer(l, Op::GeI16, Op::GtI16, Op::LtI16) }
/// Compares: the RLO is 1 if ACCU 2 is less than or equal to ACCU 1, as 16-bit integers.
LessEqualInt { en: "<=I", de: "<=I", operand: None, status: "- x x 0 - 0 x x 1", why: Compare(Number::Int, Relation::LessEqual), meaning: |l, _| compare::integer(l, Op::LeI16, Op::GtI16, Op::LtI16) }
/// Compares: the RLO is 1 if ACCU 2 is equal to ACCU 1, as 32-bit integers.
EqualDouble { en: "==D", de: "==D", operand: None, status: "- x x 0 - 0 x x 1", why: Compare(Number::Double, Relation::Equal), meaning: |l, _| compare::integer(l, Op::EqI32, Op::GtI32, Op::LtI32) }
/// Compares: the RLO is 1 if ACCU 2 is not equal to ACCU 1, as 32-bit integers.
NotEqualDouble { en: "<>D", de: "<>D", operand: None, status: "- x x 0 - 0 x x 1", why: Compare(Number::Double, Relation::NotEqual), meaning: |l, _| compare::integer(l, Op::NeI32, Op::GtI32, Op::LtI32) }
/// Compares: the RLO is 1 if ACCU 2 is greater than ACCU 1, as 32-bit integers.
GreaterDouble { en: ">D", de: ">D", operand: None, status: "- x x 0 - 0 x x 1", why: Compare(Number::Double, Relation::Greater), meaning: |l, _| compare::integer(l, Op::GtI32, Op::GtI32, Op::LtI32) }
/// Compares: the RLO is 1 if ACCU 2 is less than ACCU 1, as 32-bit integers.
LessDouble { en: "<D", de: "<D", operand: None, status: "- x x 0 - 0 x x 1", why: Compare(Number::Double, Relation::Less), meaning: |l, _| compare::integer(l, Op::LtI32, Op::GtI32, Op::LtI32) }
/// Compares: the RLO is 1 if ACCU 2 is greater than or equal to ACCU 1, as 32-bit integers.
GreaterEqualDouble { en: ">=D", de: ">=D", operand: None, status: "- x x 0 - 0 x x 1", why: Compare(Number::Double, Relation::GreaterEqual), meaning: |l, _| compare::integer(l, Op::GeI32, Op::GtI32, Op::LtI32) }
/// Compares: the RLO is 1 if ACCU 2 is less than or equal to ACCU 1, as 32-bit integers.
LessEqualDouble { en: "<=D", de: "<=D", operand: None, status: "- x x 0 - 0 x x 1", why: Compare(Number::Double, Relation::LessEqual), meaning: |l, _| compare::integer(l, Op::LeI32, Op::GtI32, Op::LtI32) }
/// Compares: the RLO is 1 if ACCU 2 is equal to ACCU 1, as REAL numbers.
EqualReal { en: "==R", de: "==R", operand: None, status: "- x x x x 0 x x 1", why: Compare(Number::Real, Relation::Equal), meaning: |l, _| compare::real(l, Op::EqF32) }
/// Compares: the RLO is 1 if ACCU 2 is not equal to ACCU 1, as REAL numbers.
NotEqualReal { en: "<>R", de: "<>R", operand: None, status: "- x x x x 0 x x 1", why: Compare(Number::Real, Relation::NotEqual), meaning: |l, _| compare::real(l, Op::NeF32) }
/// Compares: the RLO is 1 if ACCU 2 is greater than ACCU 1, as REAL numbers.
GreaterReal { en: ">R", de: ">R", operand: None, status: "- x x x x 0 x x 1", why: Compare(Number::Real, Relation::Greater), meaning: |l, _| compare::real(l, Op::GtF32) }
/// Compares: the RLO is 1 if ACCU 2 is less than ACCU 1, as REAL numbers.
LessReal { en: "<R", de: "<R", operand: None, status: "- x x x x 0 x x 1", why: Compare(Number::Real, Relation::Less), meaning: |l, _| compare::real(l, Op::LtF32) }
/// Compares: the RLO is 1 if ACCU 2 is greater than or equal to ACCU 1, as REAL numbers.
GreaterEqualReal { en: ">=R", de: ">=R", operand: None, status: "- x x x x 0 x x 1", why: Compare(Number::Real, Relation::GreaterEqual), meaning: |l, _| compare::real(l, Op::GeF32) }
/// Compares: the RLO is 1 if ACCU 2 is less than or equal to ACCU 1, as REAL numbers.
LessEqualReal { en: "<=R", de: "<=R", operand: None, status: "- x x x x 0 x x 1", why: Compare(Number::Real, Relation::LessEqual), meaning: |l, _| compare::real(l, Op::LeF32) }

// Jumps.
/// Jumps unconditionally.
Jump { en: "JU", de: "SPA", operand: Label, status: "- - - - - - - - -", why: Jump, meaning: |l, o| jumps::always(l, o) }
/// Jumps if the RLO is 1.
JumpIfRlo { en: "JC", de: "SPB", operand: Label, status: "- - - - - 0 1 1 0", why: JumpIfRlo, meaning: |l, o| jumps::on_rlo(l, o, true, false) }
/// Jumps if the RLO is 0.
JumpIfNotRlo { en: "JCN", de: "SPBN", operand: Label, status: "- - - - - 0 1 1 0", why: JumpIfNotRlo, meaning: |l, o| jumps::on_rlo(l, o, false, false) }
/// Jumps if the RLO is 1 and saves the RLO in BR.
JumpIfRloSave { en: "JCB", de: "SPBB", operand: Label, status: "x - - - - 0 1 1 0", why: JumpIfRlo, meaning: |l, o| jumps::on_rlo(l, o, true, true) }
/// Jumps if the RLO is 0 and saves the RLO in BR.
JumpIfNotRloSave { en: "JNB", de: "SPBNB", operand: Label, status: "x - - - - 0 1 1 0", why: JumpIfNotRlo, meaning: |l, o| jumps::on_rlo(l, o, false, true) }
/// Jumps if BR is 1.
JumpIfBr { en: "JBI", de: "SPBI", operand: Label, status: "- - - - - 0 1 - 0", why: JumpIfBr, meaning: |l, o| jumps::on_br(l, o, true) }
/// Jumps if BR is 0.
JumpIfNotBr { en: "JNBI", de: "SPBIN", operand: Label, status: "- - - - - 0 1 - 0", why: JumpIfNotBr, meaning: |l, o| jumps::on_br(l, o, false) }
/// Jumps if OV is 1.
JumpIfOverflow { en: "JO", de: "SPO", operand: Label, status: "- - - - - - - - -", why: JumpIfOverflow, meaning: |l, o| jumps::on_bit(l, o, Register::Ov) }
/// Jumps if OS is 1 and clears OS.
JumpIfStoredOverflow { en: "JOS", de: "SPS", operand: Label, status: "- - - - 0 - - - -", why: JumpIfStoredOverflow, meaning: |l, o| jumps::on_stored_overflow(l, o) }
/// Jumps if the result is zero (CC 1 = 0, CC 0 = 0).
JumpIfZero { en: "JZ", de: "SPZ", operand: Label, status: "- - - - - - - - -", why: JumpIf(StatusScan::Zero), meaning: |l, o| jumps::on_status(l, o, StatusScan::Zero) }
/// Jumps if the result is not zero (CC 1 and CC 0 differ).
JumpIfNotZero { en: "JN", de: "SPN", operand: Label, status: "- - - - - - - - -", why: JumpIf(StatusScan::NonZero), meaning: |l, o| jumps::on_status(l, o, StatusScan::NonZero) }
/// Jumps if the result is positive (CC 1 = 1, CC 0 = 0).
JumpIfPositive { en: "JP", de: "SPP", operand: Label, status: "- - - - - - - - -", why: JumpIf(StatusScan::Positive), meaning: |l, o| jumps::on_status(l, o, StatusScan::Positive) }
/// Jumps if the result is negative (CC 1 = 0, CC 0 = 1).
JumpIfNegative { en: "JM", de: "SPM", operand: Label, status: "- - - - - - - - -", why: JumpIf(StatusScan::Negative), meaning: |l, o| jumps::on_status(l, o, StatusScan::Negative) }
/// Jumps if the result is positive or zero (CC 0 = 0).
JumpIfNotNegative { en: "JPZ", de: "SPPZ", operand: Label, status: "- - - - - - - - -", why: JumpIf(StatusScan::NotNegative), meaning: |l, o| jumps::on_status(l, o, StatusScan::NotNegative) }
/// Jumps if the result is negative or zero (CC 1 = 0).
JumpIfNotPositive { en: "JMZ", de: "SPMZ", operand: Label, status: "- - - - - - - - -", why: JumpIf(StatusScan::NotPositive), meaning: |l, o| jumps::on_status(l, o, StatusScan::NotPositive) }
/// Jumps if the result is invalid (CC 1 = 1, CC 0 = 1).
JumpIfUnordered { en: "JUO", de: "SPU", operand: Label, status: "- - - - - - - - -", why: JumpIf(StatusScan::Unordered), meaning: |l, o| jumps::on_status(l, o, StatusScan::Unordered) }
/// Jump distributor: jumps to entry ACCU 1 (low byte) of the list of JU statements behind it, or to its label.
JumpList { en: "JL", de: "SPL", operand: Label, status: "- - - - - - - - -", why: JumpList, meaning: |l, o| jumps::list(l, o) }
/// Decrements the low word of ACCU 1 and jumps if it is not 0.
Loop { en: "LOOP", de: "LOOP", operand: Label, status: "- - - - - - - - -", why: Loop, meaning: |l, o| jumps::looping(l, o) }

// Logic control.
/// Calls a block with its parameters.
Call { en: "CALL", de: "CALL", operand: Call, status: "- - - - 0 0 1 - 0", why: Call, meaning: |l, o| logic_control::call(l, o) }
/// Calls a block without parameters.
CallUnconditional { en: "UC", de: "UC", operand: CallBlock, status: "- - - - 0 0 1 - 0", why: CallBlock, meaning: |l, o| logic_control::unconditional(l, o) }
/// Calls a block without parameters if the RLO is 1.
CallConditional { en: "CC", de: "CC", operand: CallBlock, status: "- - - - 0 0 1 1 0", why: CallIfRlo, meaning: |l, o| logic_control::conditional(l, o) }
/// Ends the block.
BlockEnd { en: "BE", de: "BE", operand: None, status: "- - - - 0 0 1 - 0", why: End, meaning: |l, _| l.b.push(Inst::Return) }
/// Ends the block unconditionally.
BlockEndUnconditional { en: "BEU", de: "BEA", operand: None, status: "- - - - 0 0 1 - 0", why: End, meaning: |l, _| l.b.push(Inst::Return) }
/// Ends the block if the RLO is 1.
BlockEndConditional { en: "BEC", de: "BEB", operand: None, status: "- - - - x 0 1 1 0", why: EndIfRlo, meaning: |l, _| logic_control::block_end_conditional(l) }

// Timers.
/// Starts a timer as a pulse with the S5TIME in ACCU 1 on an edge of the RLO.
TimerPulse { en: "SP", de: "SI", operand: Timer, status: "- - - - - 0 - - 0", why: Timer(TimerKind::Pulse), meaning: |l, o| timers::start(l, o, TimerKind::Pulse) }
/// Starts a timer as an extended pulse with the S5TIME in ACCU 1 on an edge of the RLO.
TimerExtendedPulse { en: "SE", de: "SV", operand: Timer, status: "- - - - - 0 - - 0", why: Timer(TimerKind::ExtendedPulse), meaning: |l, o| timers::start(l, o, TimerKind::ExtendedPulse) }
/// Starts a timer as an on delay with the S5TIME in ACCU 1 on an edge of the RLO.
TimerOnDelay { en: "SD", de: "SE", operand: Timer, status: "- - - - - 0 - - 0", why: Timer(TimerKind::OnDelay), meaning: |l, o| timers::start(l, o, TimerKind::OnDelay) }
/// Starts a timer as a retentive on delay with the S5TIME in ACCU 1 on an edge of the RLO.
TimerRetentiveOnDelay { en: "SS", de: "SS", operand: Timer, status: "- - - - - 0 - - 0", why: Timer(TimerKind::RetentiveOnDelay), meaning: |l, o| timers::start(l, o, TimerKind::RetentiveOnDelay) }
/// Starts a timer as an off delay with the S5TIME in ACCU 1 on an edge of the RLO.
TimerOffDelay { en: "SF", de: "SA", operand: Timer, status: "- - - - - 0 - - 0", why: Timer(TimerKind::OffDelay), meaning: |l, o| timers::start(l, o, TimerKind::OffDelay) }
/// Resets a timer if the RLO is 1.
TimerReset { en: "R", de: "R", operand: Timer, status: "- - - - - 0 - - 0", why: TimerReset, meaning: |l, o| timers::with_rlo(l, o, Intrinsic::TimerReset) }
/// Enables a timer to start again on a rising RLO.
TimerEnable { en: "FR", de: "FR", operand: Timer, status: "- - - - - 0 - - 0", why: TimerEnable, meaning: |l, o| timers::with_rlo(l, o, Intrinsic::TimerEnable) }

// Counters.
/// Counts up by one on a rising RLO, to 999.
CounterUp { en: "CU", de: "ZV", operand: Counter, status: "- - - - - 0 - - 0", why: CounterUp, meaning: |l, o| counters::with_rlo(l, o, Intrinsic::CounterUp) }
/// Counts down by one on a rising RLO, to 0.
CounterDown { en: "CD", de: "ZR", operand: Counter, status: "- - - - - 0 - - 0", why: CounterDown, meaning: |l, o| counters::with_rlo(l, o, Intrinsic::CounterDown) }
/// Sets a counter to the BCD number in ACCU 1 on a rising RLO.
CounterSet { en: "S", de: "S", operand: Counter, status: "- - - - - 0 - - 0", why: CounterSet, meaning: |l, o| counters::set(l, o) }
/// Resets a counter to 0 if the RLO is 1.
CounterReset { en: "R", de: "R", operand: Counter, status: "- - - - - 0 - - 0", why: CounterReset, meaning: |l, o| counters::with_rlo(l, o, Intrinsic::CounterReset) }
/// Enables a counter to count or be set again on a rising RLO.
CounterEnable { en: "FR", de: "FR", operand: Counter, status: "- - - - - 0 - - 0", why: CounterEnable, meaning: |l, o| counters::with_rlo(l, o, Intrinsic::CounterEnable) }

// Data blocks.
/// Opens a data block in the DB or DI register.
OpenBlock { en: "OPN", de: "AUF", operand: OpenBlock, status: "- - - - - - - - -", why: OpenBlock, meaning: |l, o| data_blocks::open(l, o) }
/// Exchanges the DB and DI registers.
SwapDataBlocks { en: "CDB", de: "TDB", operand: None, status: "- - - - - - - - -", why: SwapDataBlocks, meaning: |l, _| data_blocks::swap(l) }

// Null.
/// Does nothing (bit pattern of zeros).
Nop0 { en: "NOP", de: "NOP", operand: Zero, status: "- - - - - - - - -", why: Nothing, meaning: |_, _| null::nothing() }
/// Does nothing (bit pattern of ones).
Nop1 { en: "NOP", de: "NOP", operand: One, status: "- - - - - - - - -", why: Nothing, meaning: |_, _| null::nothing() }
/// Display information for the programming device; does nothing.
Blank { en: "BLD", de: "BLD", operand: ByteConstant, status: "- - - - - - - - -", why: Nothing, meaning: |_, _| null::nothing() }}
