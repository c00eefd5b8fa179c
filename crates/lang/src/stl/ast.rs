//! The syntax of an STL source as plain data: what the parser understood, with places.
//!
//! Nothing is resolved here: names are text, numbers may be out of range, types may not exist.

use sieben_model::block::BlockKind;
use sieben_model::interface::Section;
use sieben_model::literal::Value;
use sieben_model::source::Span;

use crate::network::flavour::Drawing;
use crate::network::pin_types::TypedPin;

/// A text with its place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Word {
    /// The text, without quotes or `#`.
    pub text: String,
    /// The place, with quotes or `#`.
    pub span: Span,
}

/// A whole source file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct File {
    /// Its blocks in order. Statements outside any block become one implicit OB 1.
    pub blocks: Vec<Block>,
}

/// A block, data block or user-defined type.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Which keyword began it.
    pub kind: BlockKind,
    /// `FC 1` or `"Dosing"`.
    pub name: BlockName,
    /// No header was written: the bare statements of the file.
    pub implicit: bool,
    /// The result type of a FUNCTION.
    pub return_type: Option<TypeName>,
    /// TITLE, AUTHOR, attributes and flags.
    pub header: Header,
    /// VAR sections, in the order written.
    pub sections: Vec<VarSection>,
    /// What a DATA_BLOCK or TYPE consists of: a STRUCT, or `FB 1` / `UDT 2`.
    pub body_type: Option<TypeName>,
    /// Assignments of the BEGIN section of a data block.
    pub assignments: Vec<Assignment>,
    /// Statements of a code block.
    pub statements: Vec<Statement>,
    /// NETWORK titles and comments.
    pub networks: Vec<Network>,
    /// The whole block.
    pub span: Span,
}

/// How a block is named.
#[derive(Clone, Debug, PartialEq)]
pub enum BlockName {
    /// `FC 1`: kind (which may differ from the keyword's) and number, unchecked.
    Absolute {
        /// The kind that is written.
        kind: BlockKind,
        /// The number; values above 65535 are kept for the diagnostic.
        number: u64,
        /// The place.
        span: Span,
    },
    /// `"Dosing"`.
    Symbol(Word),
}

impl BlockName {
    /// The place of the name.
    pub fn span(&self) -> Span {
        match self {
            Self::Absolute { span, .. } => *span,
            Self::Symbol(word) => word.span,
        }
    }
}

/// What stands between the block name and its declarations.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Header {
    /// TITLE.
    pub title: Option<Word>,
    /// The comment behind the title.
    pub comment: String,
    /// AUTHOR.
    pub author: Option<Word>,
    /// FAMILY.
    pub family: Option<Word>,
    /// NAME.
    pub name: Option<Word>,
    /// VERSION, `1.0`.
    pub version: Option<Word>,
    /// `{ S7_m_c := 'true' }`.
    pub attributes: Vec<(Word, Word)>,
    /// KNOW_HOW_PROTECT, READ_ONLY, UNLINKED, NON_RETAIN, STANDARD, CODE_VERSION1, upper-case text.
    pub flags: Vec<Word>,
}

/// One VAR section.
#[derive(Clone, Debug, PartialEq)]
pub struct VarSection {
    /// Which one.
    pub section: Section,
    /// Its declarations.
    pub declarations: Vec<Declaration>,
    /// The whole section.
    pub span: Span,
}

/// `a, b : INT := 5; // comment`.
#[derive(Clone, Debug, PartialEq)]
pub struct Declaration {
    /// The names.
    pub names: Vec<Word>,
    /// `{ S7_visible := 'false' }`.
    pub attributes: Vec<(Word, Word)>,
    /// The type.
    pub data_type: TypeName,
    /// Initial values.
    pub initial: Vec<Initial>,
    /// The comment behind it.
    pub comment: String,
    /// The whole declaration.
    pub span: Span,
}

/// A type as written.
#[derive(Clone, Debug, PartialEq)]
pub struct TypeName {
    /// What is written.
    pub kind: TypeKind,
    /// The place.
    pub span: Span,
}

/// The forms of a type.
#[derive(Clone, Debug, PartialEq)]
pub enum TypeKind {
    /// `INT`, `DATE_AND_TIME`, `BLOCK_FB`, `VOID` …, upper-case.
    Word(String),
    /// `STRING` or `STRING [10]`; the length unchecked.
    String(Option<i64>),
    /// `ARRAY [1..5, 0..3] OF INT`; bounds unchecked.
    Array {
        /// Lower and upper bounds.
        bounds: Vec<(i64, i64)>,
        /// The element.
        element: Box<TypeName>,
    },
    /// `STRUCT … END_STRUCT`.
    Struct(Vec<Declaration>),
    /// `UDT 7`, `FB 3`, `SFB 4`.
    Block(BlockKind, u64),
    /// `"MyType"`.
    Symbol(String),
    /// Not understood; a diagnostic was given.
    Missing,
}

/// An initial value, or a repeated group: `3 (0, 1)`.
#[derive(Clone, Debug, PartialEq)]
pub enum Initial {
    /// One constant.
    Value(Constant),
    /// `T 5`, `C 6`, `DB 5` or a symbol: the number that a TIMER, a COUNTER or a BLOCK_DB holds.
    Number {
        /// What is named.
        operand: Operand,
        /// The place.
        span: Span,
    },
    /// Values `count` times.
    Repeat {
        /// How often; unchecked.
        count: u64,
        /// What.
        values: Vec<Initial>,
        /// The place.
        span: Span,
    },
}

/// A constant; `None` if it was not understood (a diagnostic was given).
#[derive(Clone, Debug, PartialEq)]
pub struct Constant {
    /// Its value.
    pub value: Option<Value>,
    /// Its notation is one that only extended programs have.
    pub extended: bool,
    /// The place.
    pub span: Span,
}

/// `a.b[3] := 5;` of a data block.
#[derive(Clone, Debug, PartialEq)]
pub struct Assignment {
    /// The path; `ALL` is one name.
    pub path: Vec<PathElement>,
    /// The values.
    pub values: Vec<Initial>,
    /// The whole assignment.
    pub span: Span,
}

/// A step into a structured variable.
#[derive(Clone, Debug, PartialEq)]
pub enum PathElement {
    /// `.name`.
    Field(Word),
    /// `[1, 2]`; unchecked.
    Index(Vec<i64>, Span),
}

/// A network begins.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Network {
    /// Index of its first statement.
    pub first_statement: usize,
    /// TITLE.
    pub title: String,
    /// The comment under the title.
    pub comment: String,
    /// It is written as a diagram.
    pub drawing: Option<Drawing>,
    /// Of a diagram the pins that the operands of its statements are wired to, from its first statement on.
    pub pins: Vec<Option<TypedPin>>,
    /// The place of the keyword.
    pub span: Span,
}

/// One statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// Its label.
    pub label: Option<Word>,
    /// The instruction word as written: `A`, `A(`, `+I`, `==I`, `=`, `)MCR`; empty if only a label stands here.
    pub mnemonic: Word,
    /// Its operand.
    pub operand: Operand,
    /// The place of the operand; empty behind the mnemonic if there is none.
    pub operand_span: Span,
    /// The statement without its label.
    pub span: Span,
}

/// An operand as written.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Operand {
    /// None.
    #[default]
    None,
    /// Not understood; a diagnostic was given.
    Error,
    /// A constant, also `P#...`.
    Constant(Constant),
    /// `P##name`.
    AddressOf(Word),
    /// `P#DB3.row[2].q`, `P#"Sym".a`: a pointer to a variable, as only extended programs write it.
    PointerTo {
        /// The variable.
        target: Box<Operand>,
        /// Its place, without the `P#`.
        span: Span,
    },
    /// `MW 10`, `I 0.0`, `T 5`, `C 3`, `FC 1`, `DB 5`, `DBX 2.5`: letters upper-case, numbers unchecked.
    Absolute {
        /// `MW`, `I`, `T`, `FC`.
        letters: String,
        /// The number before the point.
        number: u64,
        /// The number behind it.
        bit: Option<u64>,
    },
    /// `DB10.DBW 2`, `"DB".DBW 2`, `DI4.DIX 1.0`.
    InBlock {
        /// `DB 10`, `"DB"`, `DI 4` (then kind DB and `instance`).
        block: BlockName,
        /// Written with DI.
        instance: bool,
        /// `DBW`.
        letters: String,
        /// The number before the point.
        number: u64,
        /// The number behind it.
        bit: Option<u64>,
    },
    /// `DB10.field[3]` (a number with a path).
    BlockField {
        /// The block.
        block: BlockName,
        /// The path.
        path: Vec<PathElement>,
    },
    /// `"Start"`, `"DB".field.sub[3]`.
    Symbol {
        /// The name without quotes.
        name: Word,
        /// The path behind it.
        path: Vec<PathElement>,
    },
    /// `#local`, `#array[2].x`.
    Local {
        /// The name without `#`.
        name: Word,
        /// The path behind it.
        path: Vec<PathElement>,
    },
    /// `[MD 4]` behind letters: `MW [MD 4]`, `T [MW 2]`, `DB [MW 4]`, `FC [LW 0]`; a bit access has the letters `M`.
    Indirect {
        /// `MW`, `T`, `DB`, `FC`.
        letters: String,
        /// What stands in the brackets.
        pointer: Box<Operand>,
        /// The place of the pointer.
        pointer_span: Span,
    },
    /// `[AR1,P#2.0]` behind letters, empty letters for a bit with its area in the register, `W` for a word.
    RegisterIndirect {
        /// `MW`, `W`, ``.
        letters: String,
        /// `AR1` or `AR2`.
        register: Word,
        /// The offset.
        offset: Constant,
    },
    /// A word that is none of these: a label, `STW`, `DBLG`, `==0`, `OV`, `BR`, `AR2`, or a name without quotes or `#`
    /// (with a path: a variable).
    Name {
        /// The word as written.
        word: Word,
        /// A path behind it, if any.
        path: Vec<PathElement>,
    },
    /// `__ACCU 1`, `__STW VKE`, `__CNST_PI`: an operand that only extended programs have.
    Register {
        /// The name, upper-case.
        name: Word,
        /// The number behind it, or that of the status bit; 0 for a constant.
        number: u32,
    },
    /// A bit of local data that a diagram needs: which one of its network, counted from 0.
    Scratch {
        /// Bits after those that are declared.
        bit: u32,
    },
    /// The operands of an extension word, with their places.
    List(Vec<(Operand, Span)>),
    /// What CALL calls.
    Call(Box<Call>),
}

/// The operand of CALL.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    /// `FC 1`, `"fb"`, `#inst`, `SFB 4`.
    pub callee: Operand,
    /// The place of the callee.
    pub callee_span: Span,
    /// `DB 2`, `"db"`, and its place.
    pub instance: Option<(Operand, Span)>,
    /// The parameters.
    pub arguments: Vec<Argument>,
}

/// `name := operand`.
#[derive(Clone, Debug, PartialEq)]
pub struct Argument {
    /// The formal parameter.
    pub name: Word,
    /// The actual one.
    pub value: Operand,
    /// The place of the actual one.
    pub span: Span,
}
