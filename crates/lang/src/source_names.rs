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

/// A name as a key: names compare without regard to case.
pub fn key(name: &str) -> String {
    crate::scope::key(name)
}

/// Whether a name can stand in a source without quotation marks: letters, digits and `_`, no digit first, and no word of the language.
pub fn is_identifier(name: &str, language: Language) -> bool {
    let is_word = name.chars().next().is_some_and(|first| first.is_alphabetic() || first == '_')
        && name.chars().all(|one| one.is_alphanumeric() || one == '_');
    match language {
        Language::Stl | Language::Diagram(_) => is_word,
        Language::St(dialect) => {
            let is_ascii = name.is_ascii() || dialect.base() == st::Dialect::Scl || dialect.base() == st::Dialect::Tia;
            let is_type = sieben_model::types::DataType::from_word(&name.to_ascii_uppercase()).is_some();
            let is_address = sieben_model::address::Operand::parse(name).is_some();
            is_word && is_ascii && !is_type && !is_address && !st::standard::catalogue::is_keyword(name, dialect)
        }
    }
}
