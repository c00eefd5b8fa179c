//! The syntax of an ST source as plain data: what the parser understood, with places. It is one for all dialects.
//!
//! Nothing is resolved here: names are text, types may not exist. Only literals are decoded, and they lie in the range
//! that their prefix gives them in the dialect of the file.

use sieben_model::literal::Value;
use sieben_model::source::Span;

/// How a name is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Quoting {
    /// `name`: local if it is declared, otherwise global.
    #[default]
    Bare,
    /// `"name"`: something global in scl and tia: a block, a symbol of the symbol table, a type.
    Global,
    /// `#name` or `#"name"`: something that the block declares.
    Local,
    /// `` `name` ``: a name of codesys that could be mistaken for a keyword.
    Backquoted,
}

/// A name as written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Name {
    /// The text without quotes or `#`; case is kept and means nothing.
    pub text: String,
    /// What stands around it.
    pub quoting: Quoting,
    /// The place, with quotes or `#`.
    pub span: Span,
}

impl Name {
    /// Whether it is this name, without regard to case.
    pub fn is(&self, name: &str) -> bool {
        self.text.eq_ignore_ascii_case(name)
    }
    /// The name in upper case, as the key of a table of names.
    pub fn key(&self) -> String {
        self.text.to_uppercase()
    }
}

/// A name with what it is qualified by, `Standard.TON`; never empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path {
    /// Its parts.
    pub names: Vec<Name>,
    /// The whole path.
    pub span: Span,
}

impl Path {
    /// The only name of an unqualified path.
    pub fn single(&self) -> Option<&Name> {
        match self.names.as_slice() {
            [name] => Some(name),
            _ => None,
        }
    }
}

/// A whole source file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct File {
    /// What it declares, in order.
    pub items: Vec<Item>,
}

/// What a file, or a namespace, consists of.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// PROGRAM, FUNCTION, FUNCTION_BLOCK, CLASS, ORGANIZATION_BLOCK, or statements outside any of them.
    Block(Box<Block>),
    /// DATA_BLOCK.
    DataBlock(Box<DataBlock>),
    /// One type of a TYPE section.
    Type(Box<TypeDeclaration>),
    /// VAR_GLOBAL outside a configuration, or VAR_CONFIG, VAR_ACCESS.
    Globals(VarSection),
    /// INTERFACE.
    Interface(Box<Interface>),
    /// NAMESPACE.
    Namespace(Namespace),
    /// `USING a.b;`.
    Using(Path),
    /// CONFIGURATION.
    Configuration(Box<Configuration>),
}

/// The kinds of blocks with statements.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BlockKind {
    /// PROGRAM.
    Program,
    /// FUNCTION.
    Function,
    /// FUNCTION_BLOCK.
    FunctionBlock,
    /// CLASS.
    Class,
    /// ORGANIZATION_BLOCK.
    OrganizationBlock,
    /// Statements and VAR sections outside any block: the body of OB 1; it has no name.
    Implicit,
}

/// A block with statements.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Which keyword began it.
    pub kind: BlockKind,
    /// Its name: `Mixer`, `"Mixer"`, `FC10`; empty for an implicit block and where it was missing.
    pub name: Name,
    /// ABSTRACT, FINAL, PUBLIC …
    pub modifiers: Modifiers,
    /// TITLE, AUTHOR, VERSION …
    pub header: Header,
    /// Pragmas before it and attributes behind its name.
    pub attributes: Vec<Attribute>,
    /// EXTENDS: one base at most is valid.
    pub extends: Vec<Path>,
    /// IMPLEMENTS.
    pub implements: Vec<Path>,
    /// USING inside the block.
    pub usings: Vec<Path>,
    /// The result type of a FUNCTION; VOID is `None`.
    pub result: Option<TypeSpec>,
    /// VAR sections, also CONST, in the order written.
    pub sections: Vec<VarSection>,
    /// The names of LABEL sections.
    pub labels: Vec<Name>,
    /// METHODs.
    pub methods: Vec<Method>,
    /// PROPERTYs.
    pub properties: Vec<Property>,
    /// ACTIONs.
    pub actions: Vec<Action>,
    /// The statements.
    pub body: Vec<Statement>,
    /// The keyword that ends it, or the end of the block where it is missing: the place of what happens at its end.
    pub end: Span,
    /// The whole block.
    pub span: Span,
}

/// Words before a name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Modifiers {
    /// PUBLIC, PRIVATE, PROTECTED, INTERNAL.
    pub access: Option<Access>,
    /// ABSTRACT.
    pub is_abstract: bool,
    /// FINAL.
    pub is_final: bool,
    /// OVERRIDE.
    pub is_override: bool,
    /// The place of the words, empty if there are none.
    pub span: Span,
}

/// Who may use a member.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Access {
    /// PUBLIC: everybody.
    Public,
    /// PRIVATE: the block alone.
    Private,
    /// PROTECTED: the block and what extends it.
    Protected,
    /// INTERNAL: the namespace.
    Internal,
}

/// What stands between a name and the declarations in scl and tia.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Header {
    /// TITLE.
    pub title: Option<Name>,
    /// AUTHOR.
    pub author: Option<Name>,
    /// FAMILY.
    pub family: Option<Name>,
    /// NAME.
    pub name: Option<Name>,
    /// VERSION.
    pub version: Option<Name>,
    /// KNOW_HOW_PROTECT, UNLINKED, READ_ONLY, NON_RETAIN …, as written.
    pub flags: Vec<Name>,
}

/// `{attribute 'qualified_only'}`, `{S7_Optimized_Access := 'TRUE'}`: one name with its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Attribute {
    /// The name without quotes.
    pub name: Name,
    /// The value without quotes.
    pub value: Option<String>,
    /// The whole pair.
    pub span: Span,
}

/// METHOD, of a block or an interface.
#[derive(Clone, Debug, PartialEq)]
pub struct Method {
    /// The name.
    pub name: Name,
    /// PUBLIC, OVERRIDE …
    pub modifiers: Modifiers,
    /// Pragmas before it.
    pub attributes: Vec<Attribute>,
    /// The type of its result.
    pub result: Option<TypeSpec>,
    /// VAR sections.
    pub sections: Vec<VarSection>,
    /// The statements; none in an interface or an abstract method.
    pub body: Vec<Statement>,
    /// The keyword that ends it.
    pub end: Span,
    /// The whole method.
    pub span: Span,
}

/// PROPERTY, of a block or an interface.
#[derive(Clone, Debug, PartialEq)]
pub struct Property {
    /// The name.
    pub name: Name,
    /// PUBLIC, ABSTRACT …
    pub modifiers: Modifiers,
    /// Pragmas before it.
    pub attributes: Vec<Attribute>,
    /// The type of its value.
    pub data_type: TypeSpec,
    /// GET: reads the property; assigns to its name.
    pub get: Option<Accessor>,
    /// SET: reads the new value by the name of the property.
    pub set: Option<Accessor>,
    /// The whole property.
    pub span: Span,
}

/// GET or SET of a property.
#[derive(Clone, Debug, PartialEq)]
pub struct Accessor {
    /// VAR sections.
    pub sections: Vec<VarSection>,
    /// The statements.
    pub body: Vec<Statement>,
    /// The whole accessor.
    pub span: Span,
}

/// ACTION: a body that shares the variables of its block.
#[derive(Clone, Debug, PartialEq)]
pub struct Action {
    /// The name.
    pub name: Name,
    /// The statements.
    pub body: Vec<Statement>,
    /// The whole action.
    pub span: Span,
}

/// INTERFACE.
#[derive(Clone, Debug, PartialEq)]
pub struct Interface {
    /// The name.
    pub name: Name,
    /// The interfaces that it extends.
    pub extends: Vec<Path>,
    /// Its methods, without bodies.
    pub methods: Vec<Method>,
    /// Its properties, without bodies.
    pub properties: Vec<Property>,
    /// The whole interface.
    pub span: Span,
}

/// NAMESPACE.
#[derive(Clone, Debug, PartialEq)]
pub struct Namespace {
    /// Its name, `a.b`.
    pub name: Path,
    /// INTERNAL.
    pub is_internal: bool,
    /// What is inside.
    pub items: Vec<Item>,
    /// The whole namespace.
    pub span: Span,
}

/// DATA_BLOCK.
#[derive(Clone, Debug, PartialEq)]
pub struct DataBlock {
    /// `DB5`, `"Recipe"`.
    pub name: Name,
    /// TITLE, VERSION …
    pub header: Header,
    /// `{ S7_Optimized_Access := 'TRUE' }`.
    pub attributes: Vec<Attribute>,
    /// STRUCT, or the FB or UDT that it is based on; `Missing` if there is none, or if it has VAR sections.
    pub data_type: TypeSpec,
    /// VAR … END_VAR of a tia data block.
    pub sections: Vec<VarSection>,
    /// The assignments behind BEGIN: target and value.
    pub assignments: Vec<(Expression, Initializer)>,
    /// The whole data block.
    pub span: Span,
}

/// One type of a TYPE section.
#[derive(Clone, Debug, PartialEq)]
pub struct TypeDeclaration {
    /// Its name: `Recipe`, `"Recipe"`, `UDT3`.
    pub name: Name,
    /// PUBLIC, INTERNAL.
    pub modifiers: Modifiers,
    /// TITLE, VERSION …
    pub header: Header,
    /// Pragmas before it and attributes behind its name.
    pub attributes: Vec<Attribute>,
    /// The structure that it extends (codesys).
    pub extends: Option<Path>,
    /// What it is.
    pub data_type: TypeSpec,
    /// The initial value that its variables have.
    pub initial: Option<Initializer>,
    /// The comment beside it.
    pub comment: String,
    /// The whole declaration.
    pub span: Span,
}

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
}

/// What AT says.
#[derive(Clone, Debug, PartialEq)]
pub enum Location {
    /// `x AT %MW0`: the variable lies there.
    Address(Address),
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

/// One statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// What it does.
    pub kind: StatementKind,
    /// The whole statement without its `;`.
    pub span: Span,
}

/// The statements.
#[derive(Clone, Debug, PartialEq)]
pub enum StatementKind {
    /// `;`.
    Empty,
    /// `a := x`, `a := b := x`, `a += x`.
    Assign {
        /// What is written to, from left to right; more than one only with [`AssignOperator::Becomes`].
        targets: Vec<Expression>,
        /// How.
        operator: AssignOperator,
        /// The value.
        value: Expression,
    },
    /// A call, or another expression where a statement stands (which is an error unless it is a call).
    Expression(Expression),
    /// IF.
    If {
        /// IF and each ELSIF; at least one.
        branches: Vec<Branch>,
        /// ELSE.
        otherwise: Option<Vec<Statement>>,
    },
    /// CASE.
    Case {
        /// What is compared.
        selector: Expression,
        /// The arms in order.
        arms: Vec<CaseArm>,
        /// ELSE.
        otherwise: Option<Vec<Statement>>,
    },
    /// FOR.
    For(Box<ForLoop>),
    /// WHILE.
    While {
        /// Tested before each pass.
        condition: Expression,
        /// The statements.
        body: Vec<Statement>,
    },
    /// REPEAT.
    Repeat {
        /// The statements.
        body: Vec<Statement>,
        /// UNTIL: tested behind each pass.
        until: Expression,
    },
    /// EXIT.
    Exit,
    /// CONTINUE.
    Continue,
    /// RETURN.
    Return,
    /// `GOTO label`, `JMP label`.
    Goto(Name),
    /// `label:` before a statement.
    Label(Name),
    /// `REGION name … END_REGION`.
    Region {
        /// The rest of its first line.
        name: String,
        /// The statements.
        body: Vec<Statement>,
    },
    /// `__TRY … __CATCH … __FINALLY … __ENDTRY`.
    Try {
        /// The statements.
        body: Vec<Statement>,
        /// The variable of `__CATCH(x)`.
        exception: Option<Expression>,
        /// The statements behind `__CATCH`.
        catch: Vec<Statement>,
        /// The statements behind `__FINALLY`.
        finally: Vec<Statement>,
    },
    /// Not understood; a diagnostic was given.
    Missing,
}

/// FOR.
#[derive(Clone, Debug, PartialEq)]
pub struct ForLoop {
    /// The control variable.
    pub variable: Expression,
    /// The first value.
    pub from: Expression,
    /// The last value.
    pub to: Expression,
    /// BY; 1 if it is not written.
    pub by: Option<Expression>,
    /// The statements.
    pub body: Vec<Statement>,
    /// END_FOR: the place of the step.
    pub end: Span,
}

/// The ways to assign.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AssignOperator {
    /// `:=`.
    Becomes,
    /// `+=`.
    Add,
    /// `-=`.
    Subtract,
    /// `*=`.
    Multiply,
    /// `/=`.
    Divide,
    /// `?=`: the assignment attempt of references, NULL where the types do not match.
    Attempt,
    /// `S=`: set the target if the value is TRUE, else keep it.
    Set,
    /// `R=`: reset the target if the value is TRUE, else keep it.
    Reset,
    /// `REF=`: let a REFERENCE TO refer to the variable.
    Refer,
}

/// IF or ELSIF with its statements.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// The condition.
    pub condition: Expression,
    /// The statements.
    pub body: Vec<Statement>,
}

/// `1, 3, 5..9: …`.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseArm {
    /// The labels; at least one.
    pub labels: Vec<CaseLabel>,
    /// The statements.
    pub body: Vec<Statement>,
}

/// A label of CASE.
#[derive(Clone, Debug, PartialEq)]
pub enum CaseLabel {
    /// `5`, a constant expression.
    Value(Expression),
    /// `5..9`, constant expressions.
    Range(Expression, Expression),
}

impl CaseLabel {
    /// The place.
    pub fn span(&self) -> Span {
        match self {
            Self::Value(value) => value.span,
            Self::Range(low, high) => low.span.to(high.span),
        }
    }
}

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

/// CONFIGURATION.
#[derive(Clone, Debug, PartialEq)]
pub struct Configuration {
    /// The name.
    pub name: Name,
    /// VAR_GLOBAL, VAR_CONFIG, VAR_ACCESS.
    pub sections: Vec<VarSection>,
    /// RESOURCEs; tasks and programs without one stand in a resource without a name.
    pub resources: Vec<Resource>,
    /// The whole configuration.
    pub span: Span,
}

/// RESOURCE.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Resource {
    /// The name; empty if none is written.
    pub name: Name,
    /// ON: the type of the controller.
    pub on: Option<Name>,
    /// VAR_GLOBAL.
    pub sections: Vec<VarSection>,
    /// TASKs.
    pub tasks: Vec<Task>,
    /// PROGRAMs.
    pub programs: Vec<ProgramInstance>,
    /// The whole resource.
    pub span: Span,
}

/// `TASK t(INTERVAL := T#10ms, PRIORITY := 1);`.
#[derive(Clone, Debug, PartialEq)]
pub struct Task {
    /// The name.
    pub name: Name,
    /// SINGLE, INTERVAL, PRIORITY.
    pub arguments: Vec<Argument>,
    /// The whole task.
    pub span: Span,
}

/// `PROGRAM p1 WITH t : MainProg(in := x, fb1 WITH t2);`.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramInstance {
    /// The name of the instance.
    pub name: Name,
    /// RETAIN or NON_RETAIN.
    pub retain: Option<(Qualifier, Span)>,
    /// WITH: the task.
    pub task: Option<Name>,
    /// The PROGRAM.
    pub program: Path,
    /// What its inputs, outputs and in-outs are tied to.
    pub arguments: Vec<Argument>,
    /// Function blocks of the program that another task runs: instance and task.
    pub bound: Vec<(Name, Name)>,
    /// The whole line.
    pub span: Span,
}
