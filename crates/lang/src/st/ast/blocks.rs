//! What a file consists of: blocks and their members, interfaces, namespaces, data blocks, types.

use super::{Expression, Initializer, Item, Name, Path, Statement, TypeSpec, VarSection};
use sieben_model::source::Span;

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
    /// INTERFACE as a block: it has methods without statements and nothing else. No parser makes it.
    Interface,
    /// A METHOD or an accessor of a PROPERTY as a block of its own: a function that works on an instance. No parser makes it.
    Method,
    /// SETUP, TEARDOWN or TEST of a test file.
    Test(TestPart),
}

/// The parts of a test file that have statements.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TestPart {
    /// SETUP: before each test.
    Setup,
    /// TEARDOWN: after each test.
    Teardown,
    /// TEST: one test. Its name is the title of the header of its block.
    Test,
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
    /// What a [`BlockKind::Method`] belongs to; nothing else has it.
    pub member: Option<Member>,
    /// The statements.
    pub body: Vec<Statement>,
    /// The keyword that ends it, or the end of the block where it is missing: the place of what happens at its end.
    pub end: Span,
    /// The whole block.
    pub span: Span,
}

impl Block {
    /// A block of this kind with nothing in it, which ends where it is.
    pub fn empty(kind: BlockKind, name: Name, span: Span) -> Self {
        Self {
            kind,
            name,
            modifiers: Modifiers::default(),
            header: Header::default(),
            attributes: Vec::new(),
            extends: Vec::new(),
            implements: Vec::new(),
            usings: Vec::new(),
            result: None,
            sections: Vec::new(),
            labels: Vec::new(),
            methods: Vec::new(),
            properties: Vec::new(),
            actions: Vec::new(),
            member: None,
            body: Vec::new(),
            end: span,
            span,
        }
    }
}

/// What makes a block a member of another one.
#[derive(Clone, Debug, PartialEq)]
pub struct Member {
    /// The block that it belongs to.
    pub of: Name,
    /// Its name there, which is also that of its result.
    pub name: Name,
    /// What it is.
    pub kind: MemberKind,
    /// VAR_INST: variables of the method that live in the instance, by the name that they have there.
    pub kept: Vec<(Name, String)>,
}

/// What calls a member.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum MemberKind {
    /// METHOD: a call.
    Method,
    /// GET of a PROPERTY: a read.
    Get,
    /// SET of a PROPERTY: an assignment.
    Set,
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

impl Modifiers {
    /// Notes a word; `false` if it is none of them.
    pub(crate) fn take(&mut self, word: &str) -> bool {
        match word.to_ascii_uppercase().as_str() {
            "PUBLIC" => self.access = Some(Access::Public),
            "PRIVATE" => self.access = Some(Access::Private),
            "PROTECTED" => self.access = Some(Access::Protected),
            "INTERNAL" => self.access = Some(Access::Internal),
            "ABSTRACT" => self.is_abstract = true,
            "FINAL" => self.is_final = true,
            "OVERRIDE" => self.is_override = true,
            _ => return false,
        }
        true
    }
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
