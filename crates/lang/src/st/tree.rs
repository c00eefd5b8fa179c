//! The typed tree of a body: what the checker hands to the lowering.
//!
//! All names are resolved, every conversion is written out, every operation is an [`Op`] of the engine. A scalar is a value of at
//! most 64 bits as a variable of the IR holds it (an integer zero-extended from its width, a BOOL as 0 or 1, a REAL as its bits).

pub mod visit;

use std::sync::Arc;

pub use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::Op;
pub use sieben_engine::ir::TextRoom;
use sieben_model::address::Area;
use sieben_model::block::BlockId;
use sieben_model::interface::Interface;
use sieben_model::source::Span;
use sieben_model::types::DataType;

pub use super::objects::Dispatch;
pub use super::standard::texts::TextFunction;

/// What an elementary value is for the operations of the engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)] // The names are those of Rust's types.
pub enum Scalar {
    Bool,
    U8,
    U16,
    U32,
    U64,
    I8,
    I16,
    I32,
    I64,
    F32,
    F64,
}

impl Scalar {
    /// Bits in memory: 1, 8, 16, 32 or 64.
    pub fn bits(self) -> u32 {
        match self {
            Self::Bool => 1,
            Self::U8 | Self::I8 => 8,
            Self::U16 | Self::I16 => 16,
            Self::U32 | Self::I32 | Self::F32 => 32,
            Self::U64 | Self::I64 | Self::F64 => 64,
        }
    }
}

/// A block of ST whose names are resolved, for reference data and editors.
#[derive(Clone, Debug, PartialEq)]
pub struct TypedBlock {
    /// Its parameters and variables.
    pub interface: Arc<Interface>,
    /// Its statements as they are written.
    pub body: Body,
}

/// The body of a block.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Body {
    /// Its statements.
    pub statements: Vec<Statement>,
    /// Declared local variables that live in the local data (VAR_TEMP, VAR of a function), in the order of their positions there.
    pub locals: Vec<Local>,
    /// Bytes of local data that the declared variables and values kept by the checker take together, always even; what the lowering
    /// keeps lies behind them.
    pub local_size: u32,
    /// Whether anything in the block reads or writes ENO/OK, or computes something that may clear it; else BR is 1 at its end.
    pub uses_ok: bool,
    /// Whether the Host is told of what [`ValueKind::Checked`] finds, where ENO/OK is not looked at.
    pub tells_lost: bool,
    /// Whether it is a function that works on an instance of a function block: a method.
    pub is_method: bool,
    /// Whether it handles its synchronous errors itself.
    pub own_errors: bool,
}

/// A variable in the local data of the block.
#[derive(Clone, Debug, PartialEq)]
pub struct Local {
    /// Position in bits in the local data.
    pub position: u32,
    /// Its type.
    pub data_type: DataType,
    /// What it holds when the block begins: elementary values and strings in the bytes of the S7 layout, as long as the type;
    /// `None` if the dialect leaves it as it is.
    pub initial: Option<Vec<u8>>,
}

/// One statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// What it does.
    pub kind: StatementKind,
    /// What steps, breakpoints and messages show.
    pub span: Span,
}

/// The statements.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The fields are named in the sentence of each variant.
pub enum StatementKind {
    /// `target := value`, a scalar. The value is computed first, then the indexes of the target.
    Assign { target: Place, value: Value },
    /// `target := source` for arrays and structures of one type; `bytes` is even. As if through a temporary if they overlap.
    Copy { target: Place, source: Place, bytes: u32 },
    /// `target := source` for texts: cut to the room there.
    AssignString { target: Place, room: TextRoom, source: Text },
    /// A call whose result nobody uses.
    Call(Call),
    /// IF, ELSIF, ELSE.
    If { branches: Vec<(Value, Vec<Statement>)>, otherwise: Vec<Statement> },
    /// CASE: the first branch with a matching range.
    Case { selector: Value, branches: Vec<Branch>, otherwise: Vec<Statement> },
    /// FOR.
    For(Box<For>),
    /// WHILE.
    While { condition: Value, body: Vec<Statement> },
    /// REPEAT … UNTIL.
    Repeat { body: Vec<Statement>, until: Value },
    /// Leaves the loop that is `depth` loops further out; 0 = the innermost.
    Exit { depth: u32 },
    /// Goes to the end of the body of that loop.
    Continue { depth: u32 },
    /// Leaves the block.
    Return,
    /// A place to jump to.
    Label(u32),
    /// GOTO, JMP.
    Goto(u32),
    /// ENO/OK of this block := value.
    SetOk(Value),
    /// A function over the machine that delivers nothing: starts a timer, counts.
    Intrinsic { intrinsic: Intrinsic, args: Vec<Value> },
    /// Statements that share a place in the source but no scope of their own.
    Block(Vec<Statement>),
}

impl StatementKind {
    /// The bodies inside it, in the order of the source.
    pub fn bodies(&self) -> Vec<&[Statement]> {
        match self {
            Self::If { branches, otherwise } => branches.iter().map(|(_, body)| body.as_slice()).chain([otherwise.as_slice()]).collect(),
            Self::Case { branches, otherwise, .. } => {
                branches.iter().map(|branch| branch.body.as_slice()).chain([otherwise.as_slice()]).collect()
            }
            Self::For(one) => vec![&one.body],
            Self::While { body, .. } | Self::Repeat { body, .. } | Self::Block(body) => vec![body],
            Self::Assign { .. }
            | Self::Copy { .. }
            | Self::AssignString { .. }
            | Self::Call(_)
            | Self::Exit { .. }
            | Self::Continue { .. }
            | Self::Return
            | Self::Label(_)
            | Self::Goto(_)
            | Self::SetOk(_)
            | Self::Intrinsic { .. } => Vec::new(),
        }
    }
}

/// A branch of CASE.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// Lowest and highest value of each label, as numbers of the selector's type.
    pub ranges: Vec<(i128, i128)>,
    /// Where the labels are written.
    pub span: Span,
    /// Its statements.
    pub body: Vec<Statement>,
}

/// FOR variable := from TO to BY by.
#[derive(Clone, Debug, PartialEq)]
pub struct For {
    /// The control variable; its indexes are computed once.
    pub variable: Place,
    /// Its type, an integer.
    pub scalar: Scalar,
    /// First value.
    pub from: Value,
    /// Last value.
    pub to: Value,
    /// Step; a constant or computed. 0 at run time: the loop is skipped and ENO/OK is cleared if the block uses it.
    pub by: Value,
    /// Whether `to` and `by` are computed before each pass instead of once.
    pub each_pass: bool,
    /// The body.
    pub body: Vec<Statement>,
}

/// A scalar value.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// How it comes about.
    pub kind: ValueKind,
    /// Its type.
    pub scalar: Scalar,
    /// Where it is written.
    pub span: Span,
}

/// How a value comes about. Operands are computed from left to right.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The fields are named in the sentence of each variant.
pub enum ValueKind {
    /// A constant: its bits.
    Constant(u64),
    /// What a place holds.
    Load(Place),
    /// An operation of the engine.
    Compute { op: Op, args: Vec<Value> },
    /// The same, and ENO/OK of the block is cleared if `failed(args)` is true; where the block does not look at it the Host is told.
    Checked { op: Op, failed: Op, args: Vec<Value> },
    /// AND_THEN: `b` is computed only if `a` is 1.
    AndThen(Box<Value>, Box<Value>),
    /// OR_ELSE: `b` is computed only if `a` is 0.
    OrElse(Box<Value>, Box<Value>),
    /// `a` if the condition holds, else `b`; only the chosen one is computed.
    Choose { condition: Box<Value>, a: Box<Value>, b: Box<Value> },
    /// The result of a function.
    Call(Box<Call>),
    /// Whether two texts are in this order: −1, 0 or 1 as I32.
    CompareTexts(Box<Text>, Box<Text>),
    /// Actual length of a text, as I16.
    Length(Box<Text>),
    /// ENO/OK of this block.
    Ok,
    /// ENO of the call before.
    Eno,
    /// The pointer to a place: data block number (0 = none) in bits 32 to 47, area-crossing pointer in bits 0 to 31.
    AddressOf(Place),
    /// The number that a parameter of a function holds which is a timer, a counter or a block, by its index, as U16.
    NumberParameter(u16),
    /// What a function over the machine delivers: a timer, a counter, or the clock that timers count with.
    Intrinsic { intrinsic: Intrinsic, args: Vec<Value> },
    /// Several steps before the value, which belong to it (a function written out).
    After(Vec<Statement>, Box<Value>),
}

/// A text (STRING or WSTRING) as a value.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The fields are named in the sentence of each variant.
pub enum Text {
    /// Characters of a literal, at most 254.
    Constant(Vec<u8>),
    /// Characters of a literal of a WSTRING.
    WideConstant(Vec<u16>),
    /// A variable; a parameter says itself how many characters it has room for.
    Place { place: Place, room: TextRoom },
    /// One character: of 16 bits that of a WSTRING.
    Character(Box<Value>),
    /// The result of a function.
    Call { call: Box<Call>, room: TextRoom },
    /// A STRING as WSTRING, or the other way; ENO/OK of the block is cleared if a STRING does not know one of the characters.
    Converted(Box<Text>),
    /// A text that statements make first.
    After(Vec<Statement>, Box<Text>),
}

impl Text {
    /// Whether it is a WSTRING.
    pub fn is_wide(&self) -> bool {
        match self {
            Self::Constant(_) => false,
            Self::WideConstant(_) => true,
            Self::Place { room, .. } | Self::Call { room, .. } => room.wide,
            Self::Character(value) => value.scalar.bits() == 16,
            Self::Converted(text) => !text.is_wide(),
            Self::After(_, text) => text.is_wide(),
        }
    }
    /// What it has room for, or how long it is.
    pub fn room(&self) -> TextRoom {
        match self {
            Self::Constant(text) => TextRoom::narrow(u8::try_from(text.len()).unwrap_or(u8::MAX)),
            Self::WideConstant(text) => TextRoom::wide(u16::try_from(text.len()).unwrap_or(u16::MAX)),
            Self::Place { room, .. } | Self::Call { room, .. } => *room,
            Self::Character(_) => TextRoom { characters_max: 1, wide: self.is_wide() },
            Self::Converted(text) => TextRoom { wide: self.is_wide(), ..text.room() },
            Self::After(_, text) => text.room(),
        }
    }
}

/// What a variable of a type of texts has room for; `None` for other types.
pub fn room_of(data_type: &DataType) -> Option<TextRoom> {
    match data_type {
        DataType::String(length) => Some(TextRoom::narrow(*length)),
        DataType::WideString(length) => Some(TextRoom::wide(*length)),
        _ => None,
    }
}

/// Where a variable lies: a base, a constant offset, and indexes computed at run time.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// From where.
    pub base: Base,
    /// Bits from the base.
    pub offset: u32,
    /// What indexes add.
    pub indexes: Vec<Index>,
    /// Where it is written.
    pub span: Span,
}

/// What an offset counts from.
#[derive(Clone, Debug, PartialEq)]
pub enum Base {
    /// The begin of an area: I, Q, M, PI, PQ; with [`Area::Local`] the local data of this block.
    Area(Area),
    /// A shared or instance data block.
    DataBlock(u16),
    /// The data block with a computed number (16 bits).
    ComputedDataBlock(Box<Value>),
    /// The instance data of this block: DI at AR2.
    Instance,
    /// The actual parameter of an elementary parameter (at most 32 bits) of a function, by its index in the interface.
    Parameter(u16),
    /// The actual parameter of any other parameter of a function, by its index.
    ComplexParameter(u16),
    /// Where the POINTER at this position (in bits) of the instance data points: a complex VAR_IN_OUT of a function block.
    InstancePointer(u32),
    /// Where a pointer value points ([`ValueKind::AddressOf`]); 0 is NULL, and using it is a fault.
    Reference(Box<Value>),
}

/// What an index adds.
#[derive(Clone, Debug, PartialEq)]
pub struct Index {
    /// The index, I32 or I64.
    pub value: Value,
    /// The lowest index.
    pub low: i64,
    /// How many there are; 0 = unknown, not checked (absolute indexed addresses).
    pub count: u64,
    /// Bits from one to the next.
    pub step: u32,
    /// What an index out of range does.
    pub check: Bounds,
}

/// What an index out of range does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bounds {
    /// Programming error (OB 121), the statement counts as NOP.
    Fault,
    /// The access is skipped or reads 0, and ENO/OK is cleared.
    Skip,
    /// The nearest valid index is taken.
    Clamp,
    /// Proven to be in range, or not looked at.
    None,
}

/// A call.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    /// What is called.
    pub callee: Callee,
    /// All arguments in the order they are computed. A parameter of a function that is missing here gets its type's default.
    pub arguments: Vec<Argument>,
    /// EN: without it always.
    pub enable: Option<Value>,
    /// Type of the result; `DataType::Void` if there is none.
    pub result: DataType,
    /// Whether ENO/OK of this block is cleared if the called one fails (leaves BR = 0).
    pub clears_ok: bool,
    /// Whether it is a function that comes with Sieben: it changes nothing but its outputs.
    pub of_library: bool,
    /// The function of texts that it is, which is written out instead of called.
    pub written_out: Option<TextFunction>,
    /// Where it is written.
    pub span: Span,
}

impl Call {
    /// A call that stands for itself: without EN, and nobody asks for a result.
    pub(crate) fn plain(callee: Callee, arguments: Vec<Argument>, span: Span) -> Self {
        let (enable, result, written_out) = (None, DataType::Void, None);
        Self { callee, arguments, enable, result, clears_ok: false, of_library: false, written_out, span }
    }
}

/// What is called.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The fields are named in the sentence of each variant.
pub enum Callee {
    /// FC or SFC.
    Function(BlockId),
    /// FB or SFB with the place of its instance: a whole data block, a part of an instance, or an element of an array of them. With
    /// `dispatch` the instance says which FB it is.
    Instance { block: BlockId, instance: Place, dispatch: Option<Dispatch> },
    /// A function that works on an instance: a method. With `dispatch` the instance says which function it is.
    Method { block: BlockId, instance: Place, dispatch: Option<Dispatch> },
}

impl Callee {
    /// The block whose interface the call has.
    pub fn block(&self) -> BlockId {
        match self {
            Self::Function(block) | Self::Instance { block, .. } | Self::Method { block, .. } => *block,
        }
    }
    /// The instance that the call works on.
    pub fn instance(&self) -> Option<&Place> {
        match self {
            Self::Function(_) => None,
            Self::Instance { instance, .. } | Self::Method { instance, .. } => Some(instance),
        }
    }
    /// Whether the parameters are passed as those of a function are.
    pub fn is_function(&self) -> bool {
        !matches!(self, Self::Instance { .. })
    }
}

/// An actual parameter. For a function `parameter` is the index in its interface, for a function block the position in bits in the instance.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The fields are named in the sentence of each variant.
pub enum Argument {
    /// A scalar by value.
    Value { parameter: u32, value: Value },
    /// A text by value.
    Text { parameter: u32, text: Text, room: TextRoom },
    /// An array or structure by value.
    Aggregate { parameter: u32, source: Place, data_type: DataType },
    /// An output of type `scalar`: after the call the place, of type `converted`, gets the value, converted by these operations.
    Output { parameter: u32, scalar: Scalar, target: Place, convert: Vec<Op>, converted: Scalar },
    /// A text as output.
    OutputText { parameter: u32, room: TextRoom, target: Place, target_room: TextRoom },
    /// An array or structure as output.
    OutputAggregate { parameter: u32, target: Place, data_type: DataType },
    /// An in-out parameter: the place itself.
    InOut { parameter: u32, place: Place, data_type: DataType },
    /// The number of a timer, counter or block as actual parameter.
    Number { parameter: u32, value: Value },
    /// A POINTER or ANY to a place.
    /// Of an ANY with the code of its type and the count that it says.
    Pointer { parameter: u32, place: Place, data_type: DataType, any: Option<(u8, u32)> },
    /// ENO: after the call the place gets BR.
    Eno { target: Place },
}

impl Argument {
    /// The variable that goes in as a whole, if one does.
    pub fn place(&self) -> Option<&Place> {
        match self {
            Self::Aggregate { source: place, .. } | Self::InOut { place, .. } | Self::Pointer { place, .. } => Some(place),
            _ => None,
        }
    }

    /// The parameter that it is for; `None` for ENO.
    pub fn parameter(&self) -> Option<u32> {
        match self {
            Self::Value { parameter, .. }
            | Self::Text { parameter, .. }
            | Self::Aggregate { parameter, .. }
            | Self::Output { parameter, .. }
            | Self::OutputText { parameter, .. }
            | Self::OutputAggregate { parameter, .. }
            | Self::InOut { parameter, .. }
            | Self::Number { parameter, .. }
            | Self::Pointer { parameter, .. } => Some(*parameter),
            Self::Eno { .. } => None,
        }
    }
}
