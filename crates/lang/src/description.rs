//! What the sources of the library say about its blocks.

use sieben_model::interface::Interface;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;

use crate::library::LibraryBlock;
use crate::options::Options;
use crate::project::compile;
use crate::stl::ast::Word;
use crate::stl::parser::parse;

/// What the source of a block says about it.
#[derive(Clone, Debug, Default)]
pub struct Description {
    /// Its TITLE: what it does, in one line.
    pub title: String,
    /// The comment below the title, one line each.
    pub comment: String,
    /// Its FAMILY.
    pub family: String,
    /// Its VERSION.
    pub version: String,
    /// Its parameters and local data.
    pub interface: Interface,
    /// Bytes of local data that a call of it needs.
    pub local_bytes: u32,
}

/// Reads what the source of a block says about it.
pub fn describe(block: &LibraryBlock, options: &Options) -> Description {
    let parsed = parse(FileId::default(), block.text, Some(Mnemonics::English));
    let header = parsed.file.blocks.first().map(|block| block.header.clone()).unwrap_or_default();
    let text = |word: Option<Word>| word.map(|word| word.text.trim().to_owned()).unwrap_or_default();
    let mut sources = Sources::default();
    sources.add(block.path, block.text);
    let options = Options { mnemonics: Some(Mnemonics::English), ..options.clone() };
    let compiled = compile(&sources, &SymbolTable::default(), &options);
    Description {
        title: text(header.title),
        comment: header.comment,
        family: text(header.family),
        version: text(header.version),
        interface: compiled.bodies.get(&block.block).map(|body| body.interface().clone()).unwrap_or_default(),
        local_bytes: compiled.program.code.get(&block.block).map_or(0, |block| block.local_size),
    }
}
