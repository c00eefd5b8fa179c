//! Reading symbol tables from files.

use std::path::Path;

use sieben_lang::encoding::{self, Encoding};
use sieben_lang::symbols::{self, Format};
use sieben_model::problems::Problem;
use sieben_model::source::Sources;
use sieben_workspace::finding::Finding;

use crate::failure::Failure;
use crate::files;

/// A symbol table as it lies on the disk.
pub(crate) struct SymbolFile {
    /// What was read.
    pub(crate) read: symbols::Read,
    /// How it was encoded.
    pub(crate) encoding: Encoding,
    /// What is wrong with it.
    pub(crate) findings: Vec<Finding>,
}

/// Reads a symbol table of any format and adds its text to the documents.
pub(crate) fn read(path: &Path, chosen: Option<Encoding>, documents: &mut Sources) -> Result<SymbolFile, Failure> {
    let name = path.display().to_string();
    let decoded = encoding::read_source_as(&files::read(path)?, chosen)
        .map_err(|unreadable| Failure::usage(unreadable.problem(), format!("`{name}` cannot be a symbol table: {unreadable}")))?;
    let format = symbols::detect(&name, &decoded.text).unwrap_or(Format::Csv);
    let file = documents.add(name.clone(), decoded.text);
    let read = symbols::read(file, &documents.file(file).text, format);
    let mut findings: Vec<Finding> = read.diagnostics.iter().cloned().map(Finding::document).collect();
    if let Some(named) = Format::from_name(&name).filter(|&named| named != format) {
        let message = format!("`{name}` is no .{} but a .{}, and was read as such", named.extension(), format.extension());
        findings.push(Finding::file(Problem::P6113, name.clone(), message));
    }
    if decoded.had_errors {
        findings.push(Finding::lost_bytes(&name, decoded.encoding));
    }
    Ok(SymbolFile { read, encoding: decoded.encoding, findings })
}
