//! A program whose dialect was judged and not chosen: where it has errors, whether another dialect has none.

use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

use crate::compiled::Compiled;
use crate::language::{Language, role};
use crate::options::Options;
use crate::project;
use crate::st::dialect::Dialect;

/// Bytes of a program that is compiled again in other dialects: where it is larger, one who waits for its errors would wait four times as long.
const BYTES_MAX: usize = 1 << 20;
/// What the help of a construct that a dialect lacks ends with.
const UNNAMED: &str = ", or name the dialect of the file with `--dialect`.";

/// Compiles all sources of a project. After errors in a judged dialect the first of them names the dialect that has none.
pub fn compile(sources: &Sources, symbols: &SymbolTable, options: &Options) -> Compiled {
    let mut compiled = project::compile(sources, symbols, options);
    name_another(sources, symbols, options, &mut compiled.diagnostics);
    compiled
}

/// Has the first error in a judged dialect name the dialect that has none.
pub fn name_another(sources: &Sources, symbols: &SymbolTable, options: &Options, diagnostics: &mut [Diagnostic]) {
    let is_error = |diagnostic: &Diagnostic| diagnostic.severity() == Severity::Error;
    let bytes: usize = sources.iter().map(|(_, source)| source.text.len()).sum();
    if options.dialect.is_some() || bytes > BYTES_MAX || !diagnostics.iter().any(is_error) {
        return;
    }
    let judged: Vec<Option<Dialect>> = sources.iter().map(|(_, source)| Language::of(&source.name, &source.text, None).dialect()).collect();
    let is_st = |diagnostic: &Diagnostic| judged.get(diagnostic.span.file.0 as usize).is_some_and(Option::is_some);
    let Some(first) = diagnostics.iter().position(|one| is_error(one) && is_st(one)) else { return };
    // Test files are written in the dialect of what they test.
    if sources.iter().any(|(_, source)| role::is_test(&source.name, &source.text)) {
        return;
    }
    let others = [Dialect::Codesys, Dialect::Tia, Dialect::Scl, Dialect::Iec].into_iter();
    let takes_it = others.filter(|&other| judged.iter().flatten().any(|&own| own != other)).find(|&other| {
        let options = Options { dialect: Some(other), ..options.clone() };
        !project::compile(sources, symbols, &options).diagnostics.iter().any(is_error)
    });
    if let Some(other) = takes_it {
        let word = other.name();
        let diagnostic = &mut diagnostics[first];
        let help = diagnostic.help.as_deref().unwrap_or_else(|| diagnostic.problem.help());
        let own = help.strip_suffix(UNNAMED).map_or_else(|| help.to_owned(), |own| format!("{own}."));
        diagnostic.help = Some(format!("{own} `--dialect {word}` takes it."));
    }
}
