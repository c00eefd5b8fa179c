//! Declaration sections, types as written, initial values.

use super::{Access, Address, Argument, Attribute, Expression, Name, Path};
use sieben_model::source::Span;

/// The kinds of declaration sections.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SectionKind {
    /// VAR.
    Var,
    /// VAR_INPUT.
    Input,
    /// VAR_OUTPUT.
    Output,
    /// VAR_IN_OUT.
    InOut,
    /// VAR_TEMP.
    Temp,
    /// VAR_STAT: static in functions and methods too.
    Static,
    /// VAR_INST: a variable of a method that lives in the instance.
    Instance,
    /// VAR_GLOBAL.
    Global,
    /// VAR_EXTERNAL.
    External,
    /// VAR_CONFIG.
    Config,
    /// VAR_ACCESS.
    Access,
    /// CONST … END_CONST of scl: declarations without types.
    Const,
}

/// Words behind VAR.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Qualifier {
    /// CONSTANT.
    Constant,
    /// RETAIN.
    Retain,
    /// NON_RETAIN.
    NonRetain,
    /// PERSISTENT.
    Persistent,
    /// DB_SPECIFIC.
    DbSpecific,
    /// PUBLIC, PRIVATE, PROTECTED, INTERNAL.
    Access(Access),
}

/// One VAR section.
#[derive(Clone, Debug, PartialEq)]
pub struct VarSection {
    /// Which one.
    pub kind: SectionKind,
    /// CONSTANT, RETAIN …
    pub qualifiers: Vec<(Qualifier, Span)>,
    /// The name of a list of global variables, which codesys exports write.
    pub name: Option<Name>,
    /// Pragmas before it.
    pub attributes: Vec<Attribute>,
    /// Its declarations.
    pub declarations: Vec<Declaration>,
    /// Whether something in it was not understood, so that declarations may be missing.
    pub partial: bool,
    /// Whether the name itself is missing in a declaration, so that any name may be declared here.
    pub nameless: bool,
    /// The whole section.
    pub span: Span,
}

impl VarSection {
    /// Whether a word stands behind VAR.
    pub fn has(&self, qualifier: Qualifier) -> bool {
        self.qualifiers.iter().any(|&(written, _)| written == qualifier)
    }
}

/// `a, b AT %MW0 : INT := 5; // comment`.
#[derive(Clone, Debug, PartialEq)]
pub struct Declaration {
    /// The names; at least one.
    pub names: Vec<DeclaredName>,
    /// Pragmas before it, attributes behind the names or the type.
    pub attributes: Vec<Attribute>,
    /// AT.
    pub location: Option<Location>,
    /// The type; [`TypeKind::Inferred`] in CONST.
    pub data_type: TypeSpec,
    /// R_EDGE or F_EDGE.
    pub edge: Option<Edge>,
    /// The initial value.
    pub initial: Option<Initializer>,
    /// READ_ONLY (`false`) or READ_WRITE (`true`) of VAR_ACCESS.
    pub writable: Option<bool>,
    /// The comment beside it, without its marks.
    pub comment: String,
    /// The whole declaration.
    pub span: Span,
}

/// A name in a declaration.
#[derive(Clone, Debug, PartialEq)]
pub struct DeclaredName {
    /// What the name is qualified by in VAR_CONFIG and VAR_ACCESS: resource, program, instance.
    pub qualifier: Vec<Name>,
    /// The name.
    pub name: Name,
    /// Elements of arrays on the way, in VAR_CONFIG: behind which of the names, the qualifiers first, and the indexes.
    pub elements: Vec<(usize, Vec<Expression>)>,
}

/// What AT says.
#[derive(Clone, Debug, PartialEq)]
pub enum Location {
    /// `x AT %MW0`: the variable lies there.
    Address(Address),
    /// `x AT %B2` in a STRUCT: bits from its begin, and how many.
    Relative {
        /// Where the field begins; `None` if the numbers make no sense.
        offset: Option<u64>,
        /// The width that the address names, in bits.
        bits: u32,
        /// The place.
        span: Span,
    },
    /// `view AT x`: the same bytes as this variable.
    View(Name),
    /// `name : resource.program.x : INT` of VAR_ACCESS: what the name gives access to.
    Path(Expression),
}

/// The edge that an input waits for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Edge {
    /// R_EDGE.
    Rising,
    /// F_EDGE.
    Falling,
}

/// A type as written.
#[derive(Clone, Debug, PartialEq)]
pub struct TypeSpec {
    /// What is written.
    pub kind: TypeKind,
    /// The place.
    pub span: Span,
}

/// The forms of a type.
#[derive(Clone, Debug, PartialEq)]
pub enum TypeKind {
    /// `INT`, `DATE_AND_TIME`, `Recipe`, `"Recipe"`, `FB10`, `UDT3`, `BLOCK_DB`, `Standard.TON`; `ANY`, `VARIANT`.
    Named(Path),
    /// `STRING`, `STRING[20]`, `STRING(20)`, `WSTRING[20]`.
    String {
        /// WSTRING.
        wide: bool,
        /// The length, a constant expression.
        length: Option<Box<Expression>>,
    },
    /// `ARRAY [1..5, 0..3] OF INT`, `ARRAY[*] OF INT`.
    Array {
        /// The dimensions, at least one.
        dimensions: Vec<Dimension>,
        /// The element.
        element: Box<TypeSpec>,
    },
    /// `STRUCT … END_STRUCT`.
    Struct {
        /// The fields.
        fields: Vec<Declaration>,
        /// OVERLAP: fields may share bytes by their AT.
        overlap: bool,
    },
    /// `UNION … END_UNION`.
    Union(Vec<Declaration>),
    /// `INT(0..100)`.
    Subrange {
        /// The type that it is a part of.
        base: Path,
        /// The lowest value, a constant expression.
        low: Box<Expression>,
        /// The highest value, a constant expression.
        high: Box<Expression>,
    },
    /// `(red, green := 5)`, with a base type `INT (red, green)` or `(red, green) INT`.
    Enumeration {
        /// The type of the values.
        base: Option<Path>,
        /// The names, with their values if they are written.
        values: Vec<(Name, Option<Expression>)>,
    },
    /// `MyBlock(a := 1)`: an instance of a function block of codesys with the parameters of its FB_init.
    Constructed {
        /// The function block.
        block: Path,
        /// The parameters.
        arguments: Vec<Argument>,
        /// Those of each element of an array, `MyBlock[(a := 1), (a := 2)]`.
        elements: Vec<Vec<Argument>>,
    },
    /// `REF_TO INT`.
    Reference(Box<TypeSpec>),
    /// `POINTER TO INT`.
    Pointer(Box<TypeSpec>),
    /// `REFERENCE TO INT`: used without `^`.
    Alias(Box<TypeSpec>),
    /// Nothing is written: a constant of CONST, or of VAR CONSTANT without a type, has the type of its value.
    Inferred,
    /// Not understood; a diagnostic was given.
    Missing,
}

/// One dimension of an array.
#[derive(Clone, Debug, PartialEq)]
pub enum Dimension {
    /// `1..5`, constant expressions.
    Bounds(Box<(Expression, Expression)>),
    /// `*`.
    Open,
}

/// An initial value.
#[derive(Clone, Debug, PartialEq)]
pub struct Initializer {
    /// What is written.
    pub kind: InitializerKind,
    /// The place.
    pub span: Span,
}

/// The forms of an initial value.
#[derive(Clone, Debug, PartialEq)]
pub enum InitializerKind {
    /// `5`, `a + 1`.
    Expression(Expression),
    /// `[1, 2, 3(0)]`, or `1, 2, 3(0)` without brackets.
    List {
        /// The elements; repetitions are among them.
        elements: Vec<Initializer>,
        /// `[ … ]` is written.
        bracketed: bool,
    },
    /// `3(0, 1)`: the values three times. `n(0)` with a constant `n` arrives as a call in an [`InitializerKind::Expression`].
    Repeat {
        /// How often.
        count: u64,
        /// What; empty `3()` means the default.
        values: Vec<Initializer>,
    },
    /// `(a := 1, b := (c := 2))`.
    Structure(Vec<(Name, Initializer)>),
}
