//! What names mean to the statements of a block: the seam between declarations and checker.

use std::sync::Arc;

use sieben_model::address::Area;
use sieben_model::block::BlockId;
use sieben_model::interface::Interface;
use sieben_model::source::Span;
use sieben_model::types::{DataType, Structure};

use crate::library::LibraryBlock;
use crate::scope::LostResults;
use crate::st::ast::{Access, LiteralKind};
use crate::st::objects::Objects;
use crate::st::standard::Provided;
use crate::st::tree::{Base, Local};

/// What a name stands for.
#[derive(Clone, Debug, PartialEq)]
pub enum Entity {
    /// A variable of the block, a global variable, or a symbol with an address in I, Q, M, PI, PQ.
    Variable(Variable),
    /// A constant that needs no memory: CONST, VAR CONSTANT of an elementary type or STRING.
    Constant(Constant),
    /// A value of an enumeration, written without its type.
    EnumValue {
        /// The enumeration.
        data_type: DataType,
        /// The number behind the value.
        value: i128,
    },
    /// A value that several enumerations have: how each is written in full.
    Ambiguous(Vec<String>),
    /// A block with statements or a data block.
    Block(BlockId),
    /// A data type, also a function block as the type of an instance.
    Type(DataType),
    /// A timer or a counter by its symbol.
    Number {
        /// [`DataType::Timer`] or [`DataType::Counter`].
        data_type: DataType,
        /// Its number.
        number: u16,
    },
    /// A namespace, a library or a list of global variables: the name before a point only.
    Qualifier,
}

impl Entity {
    /// Whether the methods of a block, and blocks that extend it, know it: everything but what lasts for one call.
    pub fn is_of_instance(&self) -> bool {
        match self {
            Self::Variable(variable) => variable.is_of_instance(),
            _ => true,
        }
    }
}

/// A variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Its name as declared.
    pub name: String,
    /// Its section.
    pub role: Role,
    /// Its type.
    pub data_type: DataType,
    /// From where its position counts.
    pub base: Base,
    /// Bits from the base.
    pub offset: u32,
    /// The place of its declaration.
    pub span: Span,
}

impl Variable {
    /// Whether it lasts longer than one call.
    pub fn is_of_instance(&self) -> bool {
        !matches!(self.role, Role::Temp | Role::Result)
            && !matches!(self.base, Base::Area(Area::Local) | Base::Parameter(_) | Base::ComplexParameter(_))
    }
}

/// Where a variable is declared: what may be done with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    /// VAR_INPUT of the block.
    Input,
    /// VAR_OUTPUT of the block.
    Output,
    /// VAR_IN_OUT of the block.
    InOut,
    /// VAR of a function block or program.
    Static,
    /// VAR_TEMP, VAR of a function.
    Temp,
    /// The result of the function.
    Result,
    /// VAR_GLOBAL, a symbol, a variable of another block.
    Global,
    /// CONSTANT with memory of its own (array, structure).
    Constant,
}

/// The value of a constant.
#[derive(Clone, Debug, PartialEq)]
pub struct Constant {
    /// The value, in the form of a literal.
    pub value: LiteralKind,
    /// Its type; `None` takes the type that a literal would take in its place.
    pub data_type: Option<DataType>,
}

/// A data block as names see it.
#[derive(Clone, Debug, PartialEq)]
pub struct DataBlockView {
    /// What it is an instance of, or the UDT that it has.
    pub based_on: Option<BlockId>,
    /// Its fields.
    pub structure: Arc<Structure>,
}

/// What the checker asks the declarations. Names compare without regard to case.
pub trait Names {
    /// What the block itself declares under this name (`#name`): variables, constants, its result under the name of the function.
    fn local(&self, name: &str) -> Option<Entity>;
    /// What the project has under this name (`"name"`, `.name`): blocks, types, global variables, constants, values of enumerations,
    /// symbols; also blocks by number, `DB10`, `FC5`, `SFC20`.
    fn global(&self, name: &str) -> Option<Entity>;
    /// The same for a name with qualifiers in front: `GVL.x`, `Standard.TON`, `a.b.f`.
    fn qualified(&self, path: &[&str]) -> Option<Entity>;
    /// The interface of a block of the project, its libraries or the system.
    fn interface(&self, block: BlockId) -> Option<Arc<Interface>>;
    /// The fields of a data block; `None` if there is none of this number.
    fn data_block(&self, number: u16) -> Option<DataBlockView>;
    /// How a block is shown in messages: its name or its number.
    fn block_name(&self, block: BlockId) -> String;
    /// The name in sight that looks most like this one.
    fn nearest(&self, name: &str) -> Option<String>;
    /// The variables of the block in the local data, with what they hold when it begins.
    fn locals(&self) -> Vec<Local>;
    /// The data block of the only instance of a PROGRAM; `None` for everything else.
    fn program(&self, block: BlockId) -> Option<BlockId>;
    /// The number of a block that comes with Sieben and does a standard function; the program has it from now on.
    fn provided(&self, block: &Provided) -> Option<BlockId>;
    /// Whether a block comes with Sieben: as part of the language it tells its caller's ENO/OK that it failed.
    fn is_of_library(&self, block: BlockId) -> bool;
    /// Which results that are lost are told to the Host.
    fn tells_lost(&self) -> LostResults;
    /// The block of the S7 library that has this number.
    fn linked(&self, block: BlockId) -> Option<&'static LibraryBlock>;
    /// Bytes of the declared variables in the local data.
    fn local_size(&self) -> u32;
    /// The variables that the block declares, in order: for warnings about those that nothing uses.
    fn declared(&self) -> Vec<Variable>;
    /// What blocks extend and implement, and their members.
    fn objects(&self) -> &Objects;
    /// The namespace that the block belongs to, with a point behind it; empty outside any.
    fn namespace(&self) -> &str;
    /// The function block whose instance the block works on: itself, or what it is a method of.
    fn this(&self) -> Option<BlockId>;
    /// What the instance has under this name, whatever a method declares.
    fn of_instance(&self, name: &str) -> Option<Entity>;
    /// The block that declares a variable of a block, which may be one that it extends, and who may use it, if the section says so.
    fn access_of(&self, block: BlockId, variable: &str) -> Option<(BlockId, Option<Access>)>;
    /// A constant that a block, or one that it extends, declares.
    fn constant_of(&self, block: BlockId, name: &str) -> Option<Entity>;
    /// Whether a variable of a block is declared PUBLIC.
    fn is_public(&self, block: BlockId, variable: &str) -> bool {
        self.access_of(block, variable).is_some_and(|(_, access)| access == Some(Access::Public))
    }
    /// Whether a variable of a block is VAR_IN_OUT CONSTANT: it is only read, and a call gives it any value.
    fn is_read_only(&self, block: BlockId, variable: &str) -> bool;
    /// Whether something in the declarations of a block is wrong, which is told there.
    fn is_broken(&self, block: BlockId) -> bool;
    /// Whether the declaration of a data block is wrong, which is told there.
    fn is_wrong_data(&self, number: u16) -> bool;
    /// Whether a block declares a name twice, which is told there.
    fn is_twice(&self, block: BlockId, variable: &str) -> bool;
    /// Whether the declaration of a variable of a block gives it an initial value.
    fn has_initial(&self, block: BlockId, variable: &str) -> bool;
    /// Whether the names are those of a CONFIGURATION, which knows the inside of every instance.
    fn knows_instances(&self) -> bool;
    /// The fields of the instances of a function block.
    fn instance(&self, block: BlockId) -> Option<Arc<Structure>>;
}
