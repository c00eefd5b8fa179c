//! What a program of ST needs of the library: known while its declarations and statements are looked at.

use sieben_model::source::FileId;

use super::items::Items;
use crate::library::LibraryBlock;
use crate::st::standard::{LinkedSource, Source};

/// Something of the library that a program needs.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Demand {
    /// A block in STL.
    Block(&'static LibraryBlock),
    /// A source of ST.
    Source(&'static Source),
}

/// What is known to be needed, each once, in the order in which it was asked for.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Needed {
    pub(crate) blocks: Vec<&'static LibraryBlock>,
    pub(crate) sources: Vec<&'static Source>,
}

impl Needed {
    /// Whether nothing is needed.
    pub(crate) fn is_empty(&self) -> bool {
        self.blocks.is_empty() && self.sources.is_empty()
    }

    /// Whether this is known to be needed.
    pub(crate) fn has(&self, demand: Demand) -> bool {
        match demand {
            Demand::Block(block) => self.blocks.contains(&block),
            Demand::Source(source) => self.sources.iter().any(|known| std::ptr::eq(*known, source)),
        }
    }

    /// Whether all of this is known to be needed.
    pub(crate) fn has_all(&self, demands: &[Demand]) -> bool {
        demands.iter().all(|&demand| self.has(demand))
    }

    /// Takes in what is needed; whether something is new.
    pub(crate) fn add(&mut self, demands: &[Demand]) -> bool {
        let mut is_new = false;
        for &demand in demands {
            if self.has(demand) {
                continue;
            }
            is_new = true;
            match demand {
                Demand::Block(block) => self.blocks.push(block),
                Demand::Source(source) => self.sources.push(source),
            }
        }
        is_new
    }

    /// The sources of the library with their blocks.
    pub(crate) fn linked(&self, items: &Items<'_>, user: usize) -> Vec<LinkedSource> {
        let linked = self.sources.iter().enumerate().map(|(index, &source)| {
            let id = file(user, index);
            let blocks = items.code.iter().filter(|(_, code)| code.block.span.file == id).map(|(&block, _)| block);
            LinkedSource { file: id, source, blocks: blocks.collect() }
        });
        linked.collect()
    }
}

/// The place of a source of the library, after those of the user.
pub(crate) fn file(user: usize, index: usize) -> FileId {
    FileId(u32::try_from(user + index).expect("fewer than 2^32 source files"))
}
