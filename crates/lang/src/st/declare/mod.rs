//! Declarations of ST: blocks and their numbers, types, constants, interfaces, global variables, data blocks.
//!
//! Everything becomes what an S7 has: FUNCTION an FC, FUNCTION_BLOCK an FB, PROGRAM an FB with an instance data block that an
//! organization block calls, VAR_GLOBAL a data block. Types, interfaces and data blocks are the same ones that STL works with,
//! so that each language calls the blocks of the other.

mod access;
mod bodies;
mod configured;
mod constants;
mod constructors;
mod data;
mod declaring;
mod environment;
mod globals;
pub(crate) mod initial;
mod instances;
mod interface;
mod items;
mod members;
mod needed;
mod numbers;
mod object_rules;
mod objects;
mod program_names;
mod programs;
mod sizes;
mod tests;
mod types;

use std::collections::HashMap;
use std::sync::Arc;

use sieben_model::block::BlockId;
use sieben_model::literal::Value;
use sieben_model::source::Span;
use sieben_model::types::{DataType, Structure};

use super::ast;
use super::check::names::{Constant, Entity, Variable};
use super::dialect::Dialect;
use super::standard::Source;
use super::tree::Local;
use crate::declarations::reuse::{Knows, Stamp};
use crate::declarations::types::{self as shared, BlockInterface, Declares, State};

pub(crate) use bodies::{Bodies, CheckedStatements, Told};
pub(crate) use data::{fill, layouts};
pub(crate) use environment::{Environment, Globals, Questions, environment, starting};
pub(crate) use items::{Code, Items, collect, usual_organization_block};
pub(crate) use members::expand;
pub(crate) use needed::{Demand, Needed, file as library_file};
use programs::organization_blocks;
pub(crate) use types::all_types;

/// A source of ST that is parsed.
#[derive(Clone, Debug)]
pub(crate) struct StFile {
    /// Its dialect.
    pub(crate) dialect: Dialect,
    /// Its syntax, which every attempt to compile reads and none changes.
    pub(crate) file: Arc<ast::File>,
    /// Which source of the library it is; `None` = the user's.
    pub(crate) library: Option<&'static Source>,
    /// The stamps of its blocks, in their order.
    pub(crate) stamps: Arc<[Stamp]>,
}

/// Gives the lists of global variables of a file that has nothing else the name of the file, as each list of codesys has one.
pub(crate) fn name_lists(file: &mut ast::File, path: &str) {
    let stem = path.rsplit(['/', '\\']).next().and_then(|name| name.split('.').next()).unwrap_or_default();
    let is_name = stem.starts_with(|first: char| first.is_ascii_alphabetic() || first == '_')
        && stem.chars().all(|one| one.is_ascii_alphanumeric() || one == '_');
    if !is_name || !file.items.iter().all(|item| matches!(item, ast::Item::Globals(_))) {
        return;
    }
    for item in &mut file.items {
        if let ast::Item::Globals(section) = item
            && section.kind == ast::SectionKind::Global
            && section.name.is_none()
        {
            section.name = Some(ast::Name { text: stem.to_owned(), span: section.span, ..ast::Name::default() });
        }
    }
}

/// A type with the initial values that its name brings along.
#[derive(Clone, Debug)]
pub(crate) struct Named {
    pub(crate) data_type: DataType,
    pub(crate) initial: Vec<Value>,
}

/// What a block of ST declares.
#[derive(Clone, Debug, Default)]
pub(crate) struct Declared {
    /// What its names stand for.
    pub(crate) names: HashMap<String, Entity>,
    /// Its variables in order.
    pub(crate) variables: Vec<Variable>,
    /// Its variables in the local data.
    pub(crate) locals: Vec<Local>,
    /// The result of a function and what it holds at the start.
    pub(crate) result: Option<(Variable, Vec<Value>)>,
    /// Outputs of a function with what they hold at the start.
    pub(crate) outputs: Vec<(Variable, Vec<Value>)>,
    /// Inputs of which the statements see the edges.
    pub(crate) edges: Vec<WatchedEdge>,
    /// The input of an organization block that tells of its first call, and what remembers that it was called.
    pub(crate) first_call: Option<(Variable, Variable)>,
    /// Instances that do not last, with what they begin with at each call.
    pub(crate) begin_again: Vec<(Variable, Variable)>,
    /// Something was wrong with a declaration, so that its statements cannot be understood whole.
    pub(crate) broken: bool,
    /// The name itself is missing in a declaration: a name that means something outside may be the lost one.
    pub(crate) nameless: bool,
}

/// A BOOL input with R_EDGE or F_EDGE.
#[derive(Clone, Debug)]
pub(crate) struct WatchedEdge {
    /// What a call gives.
    pub(crate) input: Variable,
    /// What makes the edge: the input at the call before, turned round for F_EDGE.
    pub(crate) was: Variable,
    /// What the statements see.
    pub(crate) now: Variable,
    pub(crate) edge: ast::Edge,
}

/// The types and interfaces of all languages while ST keeps what it knows among them.
pub(crate) type Types<'a> = shared::Types<'a, Known>;

impl<'a> Declares<'a, Known> for Items<'a> {
    fn stamp(&self, block: BlockId) -> Stamp {
        self.code.get(&block).map_or(Stamp::default(), |code| code.stamp)
    }

    fn has(&self, block: BlockId) -> bool {
        self.code.contains_key(&block)
    }

    fn user_defined(&'a self, types: &mut Types<'a>, number: u16, span: Span) -> Option<Option<Arc<Structure>>> {
        types::user_defined(types, self, number, span)
    }

    fn interface(&'a self, types: &mut Types<'a>, block: BlockId) -> Option<BlockInterface> {
        let uses = types.known.uses.len();
        let laid_out = interface::interface_of(types, self, block);
        if self.is_of_library(block) {
            // What the library uses of itself is needed only while the user needs it.
            types.known.uses.truncate(uses);
        }
        laid_out
    }
}

/// What is known of ST while types are resolved; lives in [`shared::Types`].
#[derive(Default)]
pub(crate) struct Known {
    /// Types of TYPE sections by the key of their names.
    pub(crate) named: HashMap<String, State<Arc<Named>>>,
    /// Global constants by key.
    pub(crate) constants: HashMap<String, State<Constant>>,
    /// What each block declares.
    pub(crate) blocks: HashMap<BlockId, Arc<Declared>>,
    /// Data blocks that functions keep their VAR_STAT in: structure and initial values come from the declarations.
    pub(crate) statics: Vec<(u16, Arc<Structure>)>,
    /// What of the library is needed and not there yet.
    pub(crate) demands: Vec<Demand>,
    /// What of the library the user's blocks need, there or not.
    pub(crate) uses: Vec<Demand>,
    /// Variables with an address that begin with a value.
    pub(crate) located: Vec<Located>,
    /// The references and pointers that begin with an address, by the initial value of the variable that they are or belong to.
    pub(crate) addresses: HashMap<Span, Vec<InitialAddress>>,
    /// Variables whose address VAR_CONFIG tells.
    pub(crate) open: Vec<access::OpenAddress>,
    /// It was said that a variable whose address nobody tells is memory.
    pub(crate) unlinked: bool,
}

/// What ST knows of a block besides its interface.
#[derive(Clone, Debug)]
pub(crate) struct Own {
    declared: Option<Arc<Declared>>,
    /// What of the library it uses.
    uses: Vec<Demand>,
}

/// How much the declarations of blocks have left in lists that all of them write.
pub(crate) struct Mark {
    /// What belongs to no single block.
    shared: [usize; 5],
    uses: usize,
}

impl Knows for Known {
    type Own = Own;
    type Mark = Mark;

    fn mark(&self) -> Mark {
        let shared = [self.statics.len(), self.demands.len(), self.located.len(), self.open.len(), self.addresses.len()];
        Mark { shared, uses: self.uses.len() }
    }

    fn own(&self, block: BlockId, since: &Mark) -> Option<Own> {
        let own = Own { declared: self.blocks.get(&block).cloned(), uses: self.uses[since.uses..].to_vec() };
        (!self.unlinked && self.has_only_blocks_since(since)).then_some(own)
    }

    fn take_in(&mut self, block: BlockId, own: &Own, since: &Mark) {
        self.blocks.extend(own.declared.iter().map(|declared| (block, Arc::clone(declared))));
        // The blocks that it asks for were looked at first; when it was laid out, they had their turn at their places in it.
        let asked = self.uses.split_off(since.uses);
        self.uses.extend_from_slice(&own.uses);
        self.uses.extend(asked);
    }
}

impl Known {
    /// Whether nothing was found out since then but what belongs to single blocks.
    fn has_only_blocks_since(&self, since: &Mark) -> bool {
        self.mark().shared == since.shared
    }
}

/// A reference or a pointer that begins with an address.
#[derive(Clone, Debug)]
pub(crate) struct InitialAddress {
    /// How many bits behind the begin of the variable it lies.
    pub(crate) offset: u64,
    pub(crate) data_type: DataType,
    pub(crate) value: ast::Expression,
}

/// A variable with an address and an initial value, which a restart writes.
#[derive(Clone, Debug)]
pub(crate) struct Located {
    pub(crate) variable: Variable,
    pub(crate) initial: Vec<Value>,
    /// RETAIN: only a cold restart writes it.
    pub(crate) retain: bool,
}
