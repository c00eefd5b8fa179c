//! What a program of ST needs of the library: known while its declarations and statements are looked at.

use std::sync::Arc;

use sieben_model::source::FileId;

use super::StFile;
use super::items::Items;
use crate::library::LibraryBlock;
use crate::st::parser::parse;
use crate::st::standard::{LinkedSource, Source};

/// Something of the library that a program needs.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Demand {
    /// A block in STL.
    Block(&'static LibraryBlock),
    /// A source of ST.
    Source(&'static Source),
}

/// What is known to be needed.
#[derive(Debug, Default)]
pub(crate) struct Needed {
    pub(crate) blocks: Vec<&'static LibraryBlock>,
    pub(crate) sources: Vec<&'static Source>,
}

impl Needed {
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

    /// The user's files, `user` sources in all languages, and behind them those of the library.
    pub(crate) fn with_library(&self, files: &[StFile], user: usize) -> Vec<StFile> {
        let library = self.sources.iter().enumerate().map(|(index, source)| {
            let id = file(user, index);
            StFile {
                id,
                dialect: source.dialect,
                file: Arc::new(super::expand(parse(id, source.text, source.dialect).file)),
                library: Some(source),
            }
        });
        files.iter().cloned().chain(library).collect()
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

fn file(user: usize, index: usize) -> FileId {
    FileId(u32::try_from(user + index).expect("fewer than 2^32 source files"))
}
