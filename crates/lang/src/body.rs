//! The statements of a block after its check, in any language: what others ask about them, in one place.

use std::collections::BTreeMap;
use std::sync::Arc;

use sieben_engine::CodeBlock;
use sieben_model::address::Area;
use sieben_model::block::BlockId;
use sieben_model::interface::Interface;

use crate::coverage::Countable;
use crate::references::{Around, Reference};
use crate::sentences::table::Sentence;
use crate::sentences::{Language, Moment, Named, Surroundings};
use crate::st::tree::TypedBlock;
use crate::stl::lower::ResolvedBlock;

/// The bodies of a program. They are shared: a block that did not change has the same body in the next program.
pub type Bodies = BTreeMap<BlockId, Arc<CheckedBody>>;

/// A code block whose statements are checked and whose names are resolved.
///
/// Each language answers in its folder (`stl/body.rs`, `st/body.rs`); code outside of it need not know which one it is. Statements are those of the IR, by their number from 0.
#[derive(Clone, Debug, PartialEq)]
pub enum CheckedBody {
    /// A block of STL.
    Stl(ResolvedBlock),
    /// A block of ST, or an organization block that the compiler made for programs.
    St(TypedBlock),
}

/// Asks the language of the body.
macro_rules! ask {
    ($body:expr, $block:ident => $answer:expr) => {
        match $body {
            CheckedBody::Stl($block) => $answer,
            CheckedBody::St($block) => $answer,
        }
    };
}

impl CheckedBody {
    /// Its declarations.
    pub fn interface(&self) -> &Interface {
        ask!(self, block => &block.interface)
    }

    /// What its statements refer to, one after another; `id` is the block.
    pub fn references(&self, id: BlockId, around: Around<'_>) -> Vec<Reference> {
        ask!(self, block => block.references(id, around))
    }

    /// The networks of the statements; none in a language without networks.
    pub fn networks(&self) -> Vec<u32> {
        ask!(self, block => block.networks())
    }

    /// The titles of its networks, empty where one has none; none in a language without networks.
    pub fn network_titles(&self) -> &[String] {
        match self {
            Self::Stl(block) => &block.titles,
            Self::St(_) => &[],
        }
    }

    /// The network of a statement, from 1; that of the end of the block is the last one.
    pub fn network(&self, statement: u32) -> Option<u32> {
        ask!(self, block => block.network(statement))
    }

    /// Whether the source has a statement with this number: the end of a block need not be written.
    pub fn is_written(&self, statement: u32) -> bool {
        ask!(self, block => block.is_written(statement))
    }

    /// The operand or the target in the text of one of its statements, if it may be the name of a value.
    pub fn value_in<'t>(&self, text: &'t str) -> Option<&'t str> {
        ask!(self, block => block.value_in(text))
    }

    /// The statement of STL that an element of a diagram stands for; `None` where the source has the statement itself.
    pub fn stated(&self, statement: u32) -> Option<&str> {
        match self {
            Self::Stl(block) => block.stated(statement),
            Self::St(_) => None,
        }
    }

    /// Whether its variables are called by their names alone, without `#`.
    pub fn has_bare_names(&self) -> bool {
        ask!(self, block => block.has_bare_names())
    }

    /// Whether people call the block by the name in its source: the compiler gave it its number.
    pub fn is_called_by_name(&self) -> bool {
        ask!(self, block => block.is_called_by_name())
    }

    /// Whether its statements work on RLO, accumulators and address registers, so that these are worth a look.
    pub fn works_on_registers(&self) -> bool {
        ask!(self, block => block.works_on_registers())
    }

    /// The statements that store something only where the RLO is 1.
    pub fn stores_if_rlo(&self) -> Vec<u32> {
        ask!(self, block => block.stores_if_rlo())
    }

    /// The bits at constant addresses that its statements name: area and position.
    pub fn named_bits(&self) -> Vec<(Area, u32)> {
        ask!(self, block => block.named_bits())
    }

    /// Whether one of its statements is an assertion.
    pub fn has_assertion(&self) -> bool {
        ask!(self, block => block.has_assertion())
    }

    /// What can be counted in it by its IR; `None` in a language where only the lowering knows.
    pub(crate) fn countable(&self, code: &CodeBlock) -> Option<Countable> {
        ask!(self, block => block.countable(code))
    }

    /// Why a statement did what it did.
    pub(crate) fn why(&self, around: Surroundings<'_>, moment: &Moment<'_>, language: Language) -> String {
        ask!(self, block => block.why(around, moment, language))
    }

    /// The variables that a statement names, with what they hold after it; none in a language whose statements work on registers.
    pub(crate) fn named(&self, around: Surroundings<'_>, moment: &Moment<'_>, language: Language) -> Vec<Named> {
        match self {
            Self::Stl(_) => Vec::new(),
            Self::St(block) => block.named(around, moment, language),
        }
    }

    /// Which sentences that is made of; none in a language whose sentences are not chosen by the statement alone.
    pub(crate) fn forms(&self, around: Surroundings<'_>, moment: &Moment<'_>) -> Vec<Sentence> {
        ask!(self, block => block.forms(around, moment))
    }
}
