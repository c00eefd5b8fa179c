//! The names in a text of a project, whatever its language is.

use std::sync::{Arc, LazyLock};

use sieben_model::mnemonics::Mnemonics;

use crate::language::Language;
use crate::library;
use crate::names::SourceNames;
use crate::options::Options;
use crate::st;
use crate::st::standard::library::SOURCES;
use crate::stl;
use crate::symbols::{self, Format};

/// The names of a source in a language.
pub fn of_source(name: &str, text: &str, language: Language, options: &Options) -> SourceNames {
    match language {
        Language::Stl | Language::Diagram(_) => stl::names::names(text, options.mnemonics, language.drawing()),
        Language::St(dialect) => st::names::names(name, text, dialect),
    }
}

/// The names of a symbol table; none if it has no format that is known.
pub fn of_symbols(name: &str, text: &str) -> SourceNames {
    symbols::detect(name, text)
        .or_else(|| Format::from_name(name))
        .map_or_else(SourceNames::default, |format| symbols::names::names(text, format))
}

/// The names of the blocks that Sieben brings along.
pub fn of_library() -> &'static [Arc<SourceNames>] {
    static LIBRARY: LazyLock<Vec<Arc<SourceNames>>> = LazyLock::new(|| {
        let built_in = |mut names: SourceNames| {
            names.is_built_in = true;
            names.occurrences.clear();
            Arc::new(names)
        };
        let stl = library::ALL.iter().map(|block| {
            let mut names = stl::names::names(block.text, Some(Mnemonics::English), None);
            names.rename_first(block.name);
            built_in(names)
        });
        let st = SOURCES.iter().map(|source| built_in(st::names::names(source.path, source.text, source.dialect)));
        stl.chain(st).collect()
    });
    &LIBRARY
}
