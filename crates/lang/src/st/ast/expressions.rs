//! Expressions: operators, calls, addresses, constants.

use super::{Contact, Name, Path, Wire};
use sieben_model::literal::Value;
use sieben_model::source::Span;

/// An expression; no deeper than 250 levels, so that it can be walked recursively.
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    /// What is written.
    pub kind: ExpressionKind,
    /// The place.
    pub span: Span,
}

/// The forms of an expression.
#[derive(Clone, Debug, PartialEq)]
pub enum ExpressionKind {
    /// A constant.
    Literal(Literal),
    /// `x`, `"Motor"`, `#x`: variable, constant, enumeration value, function, block `DB10`, `FB10`, also `OK`, `ENO` and
    /// the name of a type where a function takes one.
    Name(Name),
    /// `.x` of codesys: the global variable.
    Global(Name),
    /// `Color#red`.
    EnumValue {
        /// The type.
        of: Path,
        /// The value.
        value: Name,
    },
    /// `%IX0.0`, `MW10`, `MW[i]`, `T5`.
    Address(Address),
    /// `a.b`; also `FB10.DB20`, `"T1".TON`.
    Member(Box<Expression>, Name),
    /// `a[i, j]`; at least one index.
    Index(Box<Expression>, Vec<Expression>),
    /// `a^`.
    Dereference(Box<Expression>),
    /// `a.%X3`, `a.%B1`, `a.3`.
    Slice(Box<Expression>, Slice),
    /// `DB10.DW4`, `"Motor".DBX0.0`, `dbparam.DW[i]`, `%DB10.DBX0.0`.
    DataAddress(Box<DataAddress>),
    /// THIS.
    This,
    /// SUPER.
    Super,
    /// `f(a, IN := b, Q => c)`.
    Call(Box<Call>),
    /// `-a`, `NOT a`.
    Unary(UnaryOperator, Box<Expression>),
    /// `a + b`; the span is that of the operator.
    Binary(BinaryOperator, Span, Box<Expression>, Box<Expression>),
    /// `(a)`: brackets change no meaning but that of types of intermediate results.
    Parenthesized(Box<Expression>),
    /// `(a := b)` inside an expression (codesys).
    Assign(Box<Expression>, Box<Expression>),
    /// The value of a wire of a diagram.
    Wire(Wire),
    /// What a contact of a diagram reads, which must be a BOOL.
    Contact(Box<Contact>),
    /// Not understood; a diagnostic was given.
    Missing,
}

/// A part of a value.
#[derive(Clone, Debug, PartialEq)]
pub struct Slice {
    /// The width of the part: 1 (`%X` or nothing), 8 (`%B`), 16 (`%W`), 32 (`%D`), 64 (`%L`).
    pub bits: u32,
    /// Which one, from the least significant; unchecked. `x.name` with a constant arrives as [`ExpressionKind::Member`].
    pub index: u64,
    /// `%` is written.
    pub percent: bool,
    /// The place behind the point.
    pub span: Span,
}

/// Operators before their operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum UnaryOperator {
    /// `-`.
    Minus,
    /// `+`.
    Plus,
    /// NOT.
    Not,
}

/// Operators between their operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BinaryOperator {
    /// `**`.
    Power,
    /// `*`.
    Multiply,
    /// `/`.
    Divide,
    /// `DIV`: the division of integers.
    IntegerDivide,
    /// `MOD`.
    Modulo,
    /// `+`.
    Add,
    /// `-`.
    Subtract,
    /// `<`.
    Less,
    /// `<=`.
    LessEqual,
    /// `>`.
    Greater,
    /// `>=`.
    GreaterEqual,
    /// `=`.
    Equal,
    /// `<>`.
    NotEqual,
    /// `AND`, `&`.
    And,
    /// `XOR`.
    Xor,
    /// `OR`.
    Or,
    /// `AND_THEN`: the right side is evaluated only if the left one is TRUE.
    AndThen,
    /// `OR_ELSE`: the right side is evaluated only if the left one is FALSE.
    OrElse,
}

impl BinaryOperator {
    /// Whether it compares its operands.
    pub fn compares(self) -> bool {
        matches!(self, Self::Less | Self::LessEqual | Self::Greater | Self::GreaterEqual | Self::Equal | Self::NotEqual)
    }

    /// How it is written.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Power => "**",
            Self::Multiply => "*",
            Self::Divide => "/",
            Self::IntegerDivide => "DIV",
            Self::Modulo => "MOD",
            Self::Add => "+",
            Self::Subtract => "-",
            Self::Less => "<",
            Self::LessEqual => "<=",
            Self::Greater => ">",
            Self::GreaterEqual => ">=",
            Self::Equal => "=",
            Self::NotEqual => "<>",
            Self::And => "AND",
            Self::Xor => "XOR",
            Self::Or => "OR",
            Self::AndThen => "AND_THEN",
            Self::OrElse => "OR_ELSE",
        }
    }
}

/// A call.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    /// What is called: `SIN`, `inst`, `a[1].inst`, `FB10.DB20`, `inst.Method`, `SUPER^`, `"T1".TON`, `AND` as a function.
    pub callee: Expression,
    /// The arguments in the order written.
    pub arguments: Vec<Argument>,
}

/// One argument of a call.
#[derive(Clone, Debug, PartialEq)]
pub struct Argument {
    /// The formal parameter; `None` for an argument by position.
    pub name: Option<Name>,
    /// `:=` or `=>`; `:=` for an argument by position.
    pub direction: Direction,
    /// The actual one; `None` in `Q =>` and `IN :=` with nothing behind.
    pub value: Option<Expression>,
    /// The whole argument.
    pub span: Span,
}

/// How an argument is tied to its parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// `:=`: an input, an in-out, and in scl also an output.
    Assigned,
    /// `=>`: an output.
    Delivered,
    /// `:=>`, a slip for one of them, which is reported: the place of the sign.
    Unclear(Span),
}

/// The areas of direct addresses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Area {
    /// `I`, `E`.
    Input,
    /// `Q`, `A`.
    Output,
    /// `M`.
    Memory,
    /// `PI`, `PE`, `%I…:P`.
    PeripheralInput,
    /// `PQ`, `PA`, `%Q…:P`.
    PeripheralOutput,
    /// `L`: the local data of the block.
    Local,
    /// `T`.
    Timer,
    /// `C`, `Z`.
    Counter,
}

/// The width of an addressed value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AddressWidth {
    /// `X`, or no letter.
    Bit,
    /// `B`.
    Byte,
    /// `W`.
    Word,
    /// `D`.
    DoubleWord,
    /// `L`.
    LongWord,
}

impl AddressWidth {
    /// The width in bits.
    pub fn bits(self) -> u32 {
        match self {
            Self::Bit => 1,
            Self::Byte => 8,
            Self::Word => 16,
            Self::DoubleWord => 32,
            Self::LongWord => 64,
        }
    }
}

/// A direct address.
#[derive(Clone, Debug, PartialEq)]
pub struct Address {
    /// Which area.
    pub area: Area,
    /// How wide; meaningless for timers and counters.
    pub width: AddressWidth,
    /// Where.
    pub position: Position,
    /// `%` is written; without it a declared variable of this name goes first.
    pub percent: bool,
    /// What is written before a bracket or a point, such as `T5`, `MW` of `MW[i]`, `M0` of `M0.1`, with `%`.
    pub written: Name,
    /// The whole address.
    pub span: Span,
}

impl Address {
    /// The address as text, in one spelling for each: the name of a variable that has no other. `None` where its numbers are not written.
    pub fn plain(&self) -> Option<String> {
        let Position::Fixed(numbers) = &self.position else { return None };
        let area = match self.area {
            Area::Input => "I",
            Area::Output => "Q",
            Area::Memory => "M",
            Area::PeripheralInput => "PI",
            Area::PeripheralOutput => "PQ",
            _ => return None,
        };
        let width = match self.width {
            AddressWidth::Bit => "",
            AddressWidth::Byte => "B",
            AddressWidth::Word => "W",
            AddressWidth::DoubleWord => "D",
            AddressWidth::LongWord => "L",
        };
        let numbers: Vec<String> = numbers.iter().map(u64::to_string).collect();
        Some(format!("%{area}{width}{}", numbers.join(".")))
    }
}

/// Where an address lies.
#[derive(Clone, Debug, PartialEq)]
pub enum Position {
    /// `10`, `0.1`: numbers from left to right, unchecked: unit and bit; codesys targets may have more. At least one.
    Fixed(Vec<u64>),
    /// `[i]` or `[i, j]`: byte and bit.
    Computed(Vec<Expression>),
    /// `*`: told in VAR_CONFIG.
    Open,
}

/// A place in a data block by its number.
#[derive(Clone, Debug, PartialEq)]
pub struct DataAddress {
    /// The block: `DB10`, `"Motor"`, a parameter of type BLOCK_DB, `WORD_TO_BLOCK_DB(w)`.
    pub block: Expression,
    /// How wide.
    pub width: AddressWidth,
    /// Where.
    pub position: Position,
    /// `%` is written before `DB10`.
    pub percent: bool,
    /// What is written behind the point up to a bracket or a further point, such as `DW4`, `DW`, `DBX0`: a field of
    /// this name goes first.
    pub written: Name,
}

/// A constant.
#[derive(Clone, Debug, PartialEq)]
pub struct Literal {
    /// Its value.
    pub kind: LiteralKind,
    /// The type that its prefix names, by its long word in upper case: `INT` for `INT#5`, `DINT` for `L#5`, `WORD` for `W#16#1`
    /// and `B#(1,2)`, `REAL` for `REAL#1`; kinds that say their type by themselves have none.
    pub prefix: Option<&'static str>,
}

/// The values of constants.
#[derive(Clone, Debug, PartialEq)]
pub enum LiteralKind {
    /// `TRUE`, `BOOL#1`.
    Bool(bool),
    /// `12`, `16#FF`, `INT#-5`, `CHAR#65`. A `-` before an untyped number is [`UnaryOperator::Minus`], so that this is negative only
    /// behind a prefix; from -2^63 to 2^64 - 1.
    Integer {
        /// The value.
        value: i128,
        /// 2, 8, 10 or 16.
        radix: u8,
    },
    /// `1.5`, `REAL#1`; as the nearest LREAL; `single` is the nearest REAL (which is not always the LREAL rounded again).
    Real {
        /// As LREAL.
        value: f64,
        /// As REAL; may be infinite where the value is too large for it.
        single: f32,
    },
    /// `'text'`: one byte for each character, in the code page that holds them all.
    Characters(Vec<u8>),
    /// `"text"` of iec and codesys, `WSTRING#'text'`: UTF-16.
    WideCharacters(Vec<u16>),
    /// `T#5s`, `LTIME#5us` (`long`), in nanoseconds; without `long` a whole number of milliseconds.
    Duration {
        /// The value.
        nanoseconds: i64,
        /// LT#, LTIME#.
        long: bool,
    },
    /// `S5T#2s`, as its word: base and BCD value.
    S5Time(u16),
    /// `D#2024-01-31`, `LDATE#…` (`long`), in days since 1970-01-01.
    Date {
        /// The value, 0 or more.
        days: u32,
        /// LD#, LDATE#.
        long: bool,
    },
    /// `TOD#12:34:56.789`, `LTOD#…` (`long`), in nanoseconds since midnight.
    TimeOfDay {
        /// The value, below one day.
        nanoseconds: u64,
        /// LTOD#, LTIME_OF_DAY#.
        long: bool,
    },
    /// `DT#2024-01-31-12:34:56.789`, in nanoseconds since 1970-01-01.
    DateAndTime {
        /// The value; up to 2262.
        nanoseconds: i64,
        /// Which type the prefix names.
        form: DateAndTimeForm,
    },
    /// `C#100`: a BCD word.
    Counter(u16),
    /// `P#M0.0`, `P#DB10.DBX0.0 BYTE 20`: one of `Pointer`, `DataPointer`, `Any`.
    Pointer(Value),
    /// NULL, NIL.
    Null,
}

/// The types of a point in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DateAndTimeForm {
    /// DT#, DATE_AND_TIME#.
    Short,
    /// LDT#, LDATE_AND_TIME#.
    Long,
    /// DTL#.
    Structured,
}
