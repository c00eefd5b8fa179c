//! What a program of ST needs of the library: known while its declarations and statements are looked at.

use sieben_model::source::FileId;

use super::items::Items;
use crate::library::LibraryBlock;
use crate::st::standard::{LinkedSource, Source};

/// Something of the library that a program needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Demand {
    /// A block in STL.
    Block(&'static LibraryBlock),
    /// A source of ST.
    Source(&'static Source),
}

/// What is known to be needed.
#[derive(Clone, Debug, Default)]
pub(crate) struct Needed {
    pub(crate) blocks: Vec<&'static LibraryBlock>,
    pub(crate) sources: Vec<&'static Source>,
}

impl Needed {
    /// Whether nothing is needed.
    pub(crate) fn is_empty(&self) -> bool {
        self.blocks.is_empty() && self.sources.is_empty()
    }

    /// Whether all of this is known to be needed.
    pub(crate) fn has_all(&self, demands: &[Demand]) -> bool {
        !self.clone().add(demands)
    }

    /// Takes in what is needed; whether something is new.
    pub(crate) fn add(&mut self, demands: &[Demand]) -> bool {
        let before = (self.blocks.len(), self.sources.len());
        for demand in demands {
            match *demand {
                Demand::Block(block) if !self.blocks.contains(&block) => self.blocks.push(block),
                Demand::Source(source) if !self.sources.iter().any(|known| std::ptr::eq(*known, source)) => self.sources.push(source),
                _ => {}
            }
        }
        before != (self.blocks.len(), self.sources.len())
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

pub(crate) fn file(user: usize, index: usize) -> FileId {
    FileId(u32::try_from(user + index).expect("fewer than 2^32 source files"))
}
