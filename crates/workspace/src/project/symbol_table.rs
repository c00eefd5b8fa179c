//! Symbol tables of any format, from bytes.

use sieben_lang::encoding::{self, Encoding};
use sieben_lang::symbols::{self, Format};
use sieben_model::problems::Problem;
use sieben_model::source::Sources;

use crate::finding::Finding;
use crate::refusal::Refusal;

/// A symbol table with how it was written.
pub struct ReadTable {
    /// What was read.
    pub read: symbols::Read,
    /// How it was encoded.
    pub encoding: Encoding,
    /// What is wrong with it.
    pub findings: Vec<Finding>,
}

/// Reads a symbol table and adds its text to the documents; its name tells the format where its text does not.
///
/// # Errors
/// It is no text.
pub fn read(name: &str, bytes: &[u8], chosen: Option<Encoding>, documents: &mut Sources) -> Result<ReadTable, Refusal> {
    let decoded = encoding::read_source_as(bytes, chosen)
        .map_err(|unreadable| Refusal::new(unreadable.problem(), format!("`{name}` cannot be a symbol table: {unreadable}")))?;
    let format = symbols::detect(name, &decoded.text).unwrap_or(Format::Csv);
    let file = documents.add(name, decoded.text);
    let read = symbols::read(file, &documents.file(file).text, format);
    let mut findings: Vec<Finding> = read.diagnostics.iter().cloned().map(Finding::document).collect();
    if let Some(named) = Format::from_name(name).filter(|&named| named != format) {
        let message = format!("`{name}` is no .{} but a .{}, and was read as such", named.extension(), format.extension());
        findings.push(Finding::file(Problem::P6113, name, message));
    }
    if decoded.had_errors {
        findings.push(Finding::lost_bytes(name, decoded.encoding));
    }
    Ok(ReadTable { read, encoding: decoded.encoding, findings })
}
