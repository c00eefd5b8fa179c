//! The names in the sources of a project: what each text defines, where each name stands, and what it stands for.
//!
//! A text alone gives [`SourceNames`], also where it has errors: its definitions, and the places of its names with what is written there.
//! What a name stands for is asked of all texts of a project ([`Names`]). A language joins in by its file `names.rs`.

mod build;
mod project;
mod system;

use std::collections::HashMap;

use sieben_model::address::{Area, Operand};
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;

pub(crate) use build::Builder;
pub use project::{At, DefId, Found, Names, Through};
pub use system::of_system;

/// A range of bytes of a text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Bytes {
    /// The first byte.
    pub start: u32,
    /// One after the last byte.
    pub end: u32,
}

impl Bytes {
    /// Whether a byte lies in it or right after it.
    pub fn touches(self, offset: usize) -> bool {
        self.start as usize <= offset && offset <= self.end as usize
    }
}

/// A name of a text by its number there.
pub type NameId = u32;

/// What a definition defines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum DefinitionKind {
    /// An organization block, or a program.
    OrganizationBlock,
    /// A PROGRAM.
    Program,
    /// A function.
    Function,
    /// A function block, also a class.
    FunctionBlock,
    /// An interface that function blocks implement.
    Interface,
    /// A METHOD, or an accessor of a PROPERTY.
    Method,
    /// A PROPERTY.
    Property,
    /// An ACTION.
    Action,
    /// A data block.
    DataBlock,
    /// A UDT or a type of a TYPE section.
    Type,
    /// VAR_INPUT.
    Input,
    /// VAR_OUTPUT.
    Output,
    /// VAR_IN_OUT.
    InOut,
    /// VAR of a block with an instance.
    Static,
    /// VAR_TEMP, and VAR of a function.
    Temp,
    /// The result of a function.
    Result,
    /// A global variable.
    Global,
    /// A constant.
    Constant,
    /// A field of a structure.
    Field,
    /// A value of an enumeration.
    EnumValue,
    /// A label.
    Label,
    /// A row of a symbol table.
    Symbol,
    /// SETUP, TEARDOWN or TEST of a test file.
    Test,
    /// A namespace, a list of global variables, a configuration or a part of one.
    Group,
}

impl DefinitionKind {
    /// Whether it has statements.
    pub fn is_code(self) -> bool {
        use DefinitionKind::*;
        matches!(self, OrganizationBlock | Program | Function | FunctionBlock | Method | Property | Action | Test)
    }

    /// Whether a caller gives it a value or takes one from it.
    pub fn is_parameter(self) -> bool {
        matches!(self, Self::Input | Self::Output | Self::InOut | Self::Result)
    }

    /// Whether it is a variable, a parameter or a field.
    pub fn is_variable(self) -> bool {
        use DefinitionKind::*;
        matches!(self, Input | Output | InOut | Static | Temp | Result | Global | Field)
    }
}

/// Where the members of something are declared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TypeRef {
    /// It has none.
    #[default]
    None,
    /// In its own declaration: a structure or an enumeration.
    Inline,
    /// With the type or block of this name.
    Named(NameId),
    /// With the block of this number.
    Block(BlockId),
}

/// A definition.
#[derive(Clone, Debug, PartialEq)]
pub struct Definition {
    /// The number of its name.
    pub id: NameId,
    /// The name as written, without quotes; `FC 1` for a block with a number.
    pub name: String,
    /// What it is.
    pub kind: DefinitionKind,
    /// What it is defined in, among the definitions of the text.
    pub parent: Option<u32>,
    /// The name.
    pub span: Bytes,
    /// The whole definition.
    pub whole: Bytes,
    /// Its type as written, on one line; empty if it has none.
    pub data_type: String,
    /// Where its members are declared; those of an array are those of its element.
    pub of: TypeRef,
    /// Blocks and interfaces that it extends.
    pub extends: Vec<NameId>,
    /// What the source says about it: a comment, or the title of a block.
    pub comment: String,
    /// The number of a block, or the address of a symbol or variable.
    pub operand: Option<Operand>,
    /// The first and one after the last statement, as bytes: the body of a block; empty if it has none.
    pub body: Bytes,
    /// The names of its members, in their order.
    pub members: Vec<u32>,
}

/// A call in the text.
#[derive(Clone, Debug, PartialEq)]
pub struct CallSite {
    /// The occurrence that is called.
    pub callee: u32,
    /// From the callee to the end of the arguments.
    pub whole: Bytes,
    /// Each argument, and whether its parameter is named.
    pub arguments: Vec<(Bytes, bool)>,
}

/// How something is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Access {
    /// Its definition.
    Definition,
    /// It is read.
    Read,
    /// It is written.
    Write,
    /// Both.
    ReadWrite,
    /// It is called.
    Call,
    /// The data block is opened, or named as what a variable lies in.
    Open,
    /// It is the instance of a call.
    Instance,
    /// Its address or number is taken.
    Address,
    /// A label is jumped to.
    Jump,
    /// It is named as a type.
    Type,
    /// It is a formal parameter.
    Parameter,
    /// It is an actual parameter: the parameter before it says how it is used.
    Argument,
    /// A member of it is used.
    Path,
}

/// What is written at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Written {
    /// The name of a definition, by its number.
    Definition(u32),
    /// `#name`: something that the block declares.
    Local(NameId),
    /// `name`: something that the block declares, or else something global.
    Plain(NameId),
    /// `"name"`: something global.
    Global(NameId),
    /// `.name` after another occurrence.
    Member(u32, NameId),
    /// The formal parameter of the call whose callee is another occurrence.
    Parameter(u32, NameId),
    /// A label of the block.
    Label(NameId),
    /// An address, a timer, a counter or a block by its number.
    Operand(Operand),
    /// `.DBW 2` after another occurrence.
    InBlock(u32, sieben_model::address::Address),
    /// Memory from a bit on: `P#M 10.0 BYTE 4`.
    Range(Area, Option<u16>, u32, u32),
    /// An address that is computed: the area, if it is known.
    Indirect(Option<Area>),
}

/// A place where a name stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Occurrence {
    /// The name without quotes and marks, or the address.
    pub span: Bytes,
    /// What is written.
    pub written: Written,
    /// How it is used.
    pub access: Access,
    /// The block it stands in, among the definitions of the text.
    pub scope: Option<u32>,
}

/// The names of a text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SourceNames {
    /// The mnemonic language of a source that has one.
    pub mnemonics: Option<Mnemonics>,
    /// Nothing of it is the user's: blocks of the CPU and of the library.
    pub is_built_in: bool,
    /// It is a test file: what it declares is its own.
    pub is_test: bool,
    /// What it defines.
    pub definitions: Vec<Definition>,
    /// Where names stand, in the order of their places.
    pub occurrences: Vec<Occurrence>,
    /// Its calls with brackets, in the order of their callees.
    pub calls: Vec<CallSite>,
    /// The names, as keys.
    names: Vec<Box<str>>,
    /// The number of a name.
    ids: HashMap<Box<str>, NameId>,
    /// The occurrences of a name that has these letters, by number of the name.
    by_name: Vec<Vec<u32>>,
    /// The occurrences that are addresses.
    addresses: Vec<u32>,
    /// The definitions of a name, by number of the name.
    defined: Vec<Vec<u32>>,
}

impl SourceNames {
    /// A name, as a key.
    pub fn name(&self, id: NameId) -> &str {
        self.names.get(id as usize).map_or("", |name| name)
    }

    /// The number of a name; `None` if the text does not have it.
    pub fn id(&self, key: &str) -> Option<NameId> {
        self.ids.get(key).copied()
    }

    /// The occurrences of a name, whatever it stands for.
    pub fn occurrences_of(&self, key: &str) -> &[u32] {
        self.id(key).and_then(|id| self.by_name.get(id as usize)).map_or(&[], Vec::as_slice)
    }

    /// The occurrences that are addresses.
    pub fn addresses(&self) -> &[u32] {
        &self.addresses
    }

    /// The definitions of a name.
    pub fn definitions_of(&self, key: &str) -> &[u32] {
        self.id(key).and_then(|id| self.defined.get(id as usize)).map_or(&[], Vec::as_slice)
    }

    /// The occurrence at a byte, or right before it.
    pub fn at(&self, offset: usize) -> Option<u32> {
        let end = self.occurrences.partition_point(|one| one.span.start as usize <= offset);
        let mut found = None;
        // A pointer lies in the brackets of an indirect address: the inner one counts.
        for index in (0..end).rev().take(8) {
            let span = self.occurrences[index].span;
            if span.touches(offset) {
                let is_inside = (offset as u32) < span.end;
                match found {
                    None => found = Some((index, is_inside)),
                    Some((_, false)) if is_inside => found = Some((index, true)),
                    Some(_) => {}
                }
            }
        }
        found.map(|(index, _)| index as u32)
    }

    /// The innermost block with statements around a byte.
    pub fn scope_at(&self, offset: usize) -> Option<u32> {
        let around = |(_, one): &(usize, &Definition)| {
            (one.kind.is_code() || one.kind == DefinitionKind::DataBlock) && one.whole.touches(offset) && one.whole.start < one.whole.end
        };
        let size = |(_, one): &(usize, &Definition)| one.whole.end - one.whole.start;
        self.definitions.iter().enumerate().filter(around).min_by_key(size).map(|(index, _)| index as u32)
    }

    /// Gives the first definition another name: a block that is known by it.
    pub(crate) fn rename_first(&mut self, name: &str) {
        let Some(first) = self.definitions.first_mut() else { return };
        name.clone_into(&mut first.name);
        let key: Box<str> = crate::scope::key(name).into();
        first.id = match self.ids.get(&key) {
            Some(&id) => id,
            None => {
                let id = self.names.len() as NameId;
                self.names.push(key.clone());
                self.ids.insert(key, id);
                id
            }
        };
    }

    /// A definition.
    pub fn definition(&self, index: u32) -> Option<&Definition> {
        self.definitions.get(index as usize)
    }

    /// An occurrence.
    pub fn occurrence(&self, index: u32) -> Option<&Occurrence> {
        self.occurrences.get(index as usize)
    }
}
