//! Reading symbol tables from files.

use std::path::Path;

use sieben_lang::encoding::Encoding;
use sieben_model::source::Sources;
use sieben_workspace::project::symbol_table::{self, ReadTable};

use crate::failure::Failure;
use crate::files;
use crate::paths::shown;

/// Reads a symbol table of any format and adds its text to the documents.
pub(crate) fn read(path: &Path, chosen: Option<Encoding>, documents: &mut Sources) -> Result<ReadTable, Failure> {
    Ok(symbol_table::read(&shown(path), &files::read(path)?, chosen, documents)?)
}
