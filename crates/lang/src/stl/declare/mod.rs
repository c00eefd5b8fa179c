//! Declarations of STL: types, interfaces and data blocks from its syntax.

pub(crate) mod data_block;
mod interface;
pub(crate) mod links;
pub(crate) mod names;
pub(crate) mod path;
mod types;

use std::collections::HashMap;
use std::sync::Arc;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::source::Span;
use sieben_model::types::Structure;

use super::ast;
use crate::declarations::interface::lay_out_or_report;
use crate::declarations::reuse::{Knows, Stamp};
use crate::declarations::types::{BlockInterface, Declares, Types};

/// The blocks of all sources of STL with their stamps; of a number that exists twice the first.
pub(crate) type Blocks<'a> = HashMap<BlockId, (&'a ast::Block, Stamp)>;

impl<'a, K: Knows> Declares<'a, K> for Blocks<'_> {
    fn has(&self, block: BlockId) -> bool {
        self.contains_key(&block)
    }

    fn stamp(&self, block: BlockId) -> Stamp {
        self.get(&block).map_or(Stamp::default(), |&(_, stamp)| stamp)
    }

    fn user_defined(&'a self, types: &mut Types<'a, K>, number: u16, span: Span) -> Option<Option<Arc<Structure>>> {
        let id = BlockId::new(BlockKind::UserDefinedType, number);
        let &(block, stamp) = self.get(&id)?;
        Some(types.keep_udt(number, stamp, span, |types| types::user_defined(types, id, block)))
    }

    fn interface(&'a self, types: &mut Types<'a, K>, id: BlockId) -> Option<BlockInterface> {
        let &(block, _) = self.get(&id)?;
        let declared = interface::declared_of(types, id, block);
        lay_out_or_report(types, id, declared, block.name.span())
    }
}
