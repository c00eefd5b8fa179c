//! The syntax of an ST source as plain data: what the parser understood, with places. It is one for all dialects.
//!
//! Nothing is resolved here: names are text, types may not exist. Only literals are decoded, and they lie in the range
//! that their prefix gives them in the dialect of the file.

mod blocks;
mod configuration;
mod declarations;
mod diagrams;
mod expressions;
mod statements;

pub use blocks::{
    Access, Accessor, Action, Attribute, Block, BlockKind, DataBlock, Header, Interface, Member, MemberKind, Method, Modifiers, Namespace,
    Property, TestPart, TypeDeclaration,
};
pub use configuration::{Configuration, ProgramInstance, Resource, Task};
pub use declarations::{
    Declaration, DeclaredName, Dimension, Edge, Initializer, InitializerKind, Location, Qualifier, SectionKind, TypeKind, TypeSpec,
    VarSection,
};
pub use diagrams::{Contact, DiagramBox, GoesOn, NetworkNumber, Wire};
pub use expressions::{
    Address, AddressWidth, Area, Argument, BinaryOperator, Call, DataAddress, DateAndTimeForm, Direction, Expression, ExpressionKind,
    Literal, LiteralKind, Position, Slice, UnaryOperator,
};
pub use statements::{AssignOperator, Branch, CaseArm, CaseLabel, ForLoop, Statement, StatementKind};

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
