//! The texts of a project, wherever they come from: sources, symbol tables, settings.

mod awlsim;
mod build;
pub mod open;
pub mod symbol_table;
mod test_files;
#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};

use sieben_lang::encoding::{self, Decoded, Encoding};
use sieben_lang::language::Language;
use sieben_lang::st::dialect::Dialect;
use sieben_model::problems::Problem;
use sieben_model::source::FileId;
use sieben_model::symbols::SymbolTable;

use crate::finding::{self, Finding, Texts};
use crate::refusal::Refusal;
use crate::settings::{self, Settings};
pub use build::{Build, Overrides};

/// A source with the file that it came from.
#[derive(Clone, Debug)]
pub struct SourceFile {
    /// Where it lies.
    pub path: PathBuf,
    /// Its identity among the texts of the program.
    pub id: FileId,
    /// Its text and how it was encoded.
    pub decoded: Decoded,
    /// It lies inside another file, which is not ours to write.
    pub embedded: bool,
}

impl SourceFile {
    /// The language that it is written in; `dialect` is what the user chose for sources of ST.
    pub fn language(&self, dialect: Option<Dialect>) -> Language {
        Language::of(&self.path.to_string_lossy(), &self.decoded.text, dialect)
    }
}

/// Everything read and decoded, nothing compiled.
///
/// Each text comes in by its path, which is what people call it, and its bytes: they were read from a disk, or made up.
#[derive(Clone, Debug, Default)]
pub struct Project {
    /// All texts.
    pub texts: Texts,
    /// The sources in the order of compilation.
    pub sources: Vec<SourceFile>,
    /// All symbols.
    pub symbols: SymbolTable,
    /// What `sieben.toml` says.
    pub settings: Settings,
    /// The folder with the `sieben.toml`, if there is one.
    pub home: Option<PathBuf>,
    /// What was noticed while reading.
    pub findings: Vec<Finding>,
    /// The files that `tests` names.
    pub tests: Vec<PathBuf>,
    /// The encoding that the user chose for its files.
    pub encoding: Option<Encoding>,
}

impl Project {
    /// A project without anything. `encoding` is that of texts without a byte order mark; none = guessed from each.
    pub fn new(encoding: Option<Encoding>) -> Self {
        Self { encoding, ..Self::default() }
    }

    /// Takes in a `sieben.toml`; what it says replaces what was said before. Patterns of files are a matter of the code that reads files.
    pub fn add_settings(&mut self, path: &Path, bytes: &[u8]) {
        let name = path.display().to_string();
        self.settings = match std::str::from_utf8(bytes) {
            Ok(text) => {
                let file = self.texts.documents.add(name, text.strip_prefix('\u{FEFF}').unwrap_or(text));
                let (parsed, diagnostics) = settings::parse(&self.texts.documents.file(file).text, file);
                self.findings.extend(diagnostics.into_iter().map(Finding::document));
                parsed
            }
            Err(_) => {
                let message = format!("`{name}` is not UTF-8 text");
                self.findings.push(Finding::file(Problem::P6007, name, message));
                Settings::default()
            }
        };
    }

    /// Takes in a source, in the order of compilation.
    pub fn add_source(&mut self, path: &Path, bytes: &[u8]) {
        let name = path.display().to_string();
        let decoded = match encoding::read_source_as(bytes, self.encoding) {
            Ok(decoded) => decoded,
            Err(unreadable) => {
                let message = format!("`{name}` cannot be a source: {unreadable}");
                self.findings.push(Finding::file(unreadable.problem(), name, message));
                return;
            }
        };
        if decoded.had_errors {
            self.findings.push(Finding::lost_bytes(&name, decoded.encoding));
        }
        if decoded.text.trim().is_empty() {
            self.findings.push(Finding::file(Problem::P6004, name.clone(), format!("`{name}` is empty")));
        }
        let id = self.texts.program.add(name, decoded.text.clone());
        self.sources.push(SourceFile { path: path.to_path_buf(), id, decoded, embedded: false });
    }

    /// Takes in a symbol table of any format.
    ///
    /// # Errors
    /// It is too large to be one.
    pub fn add_symbols(&mut self, path: &Path, bytes: &[u8]) -> Result<(), Refusal> {
        let name = path.display().to_string();
        let table = match symbol_table::read(&name, bytes, self.encoding, &mut self.texts.documents) {
            Ok(table) => table,
            // What lies inside the project is a matter of the project, not of the code that reads it.
            Err(refusal) if refusal.problem == Problem::P1101 => {
                self.findings.push(Finding::file(refusal.problem, name, refusal.message));
                return Ok(());
            }
            Err(refusal) => return Err(refusal),
        };
        self.findings.extend(table.findings);
        self.add_table(&name, &table.read.table);
        Ok(())
    }

    /// Takes in a symbol table. Twice in one table is found where the table is read; here are the tables before this one.
    pub fn add_table(&mut self, name: &str, table: &SymbolTable) {
        let before = self.symbols.clone();
        for symbol in table.symbols() {
            if let Some(other) = before.find(&symbol.name).filter(|other| other.operand() != symbol.operand()) {
                let message = format!(
                    "`{}` is `{}` in `{}` and `{}` in another symbol table",
                    symbol.name,
                    symbol.address.trim(),
                    name,
                    other.address.trim()
                );
                self.findings.push(Finding::file(Problem::P6101, name, message));
            }
            self.symbols.push(symbol.clone());
        }
    }

    /// A program needs at least one source with something in it; `paths` are what it was read from.
    pub fn require_text(&mut self, paths: &[PathBuf]) {
        let blank = |source: &SourceFile| source.decoded.text.trim().is_empty();
        if finding::has_errors(&self.findings) || !self.sources.iter().all(blank) {
            return;
        }
        self.findings.retain(|finding| finding.diagnostic.problem != Problem::P6004);
        let (path, message) = match (self.sources.as_slice(), paths) {
            ([], [path]) if path.as_os_str() == "." => (String::new(), "there is no STL source in this folder".to_owned()),
            ([], [path]) => (path.display().to_string(), format!("there is no STL source in `{}`", path.display())),
            ([], _) => (String::new(), "no STL source is among these files".to_owned()),
            ([source], _) => (source.path.display().to_string(), format!("`{}` is empty", source.path.display())),
            _ => (String::new(), "all sources are empty".to_owned()),
        };
        self.findings.push(Finding::file(Problem::P6005, path, message));
    }
}
