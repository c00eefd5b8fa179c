//! Compiles the sources of a project into a program.

use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

use crate::compiled::Compiled;
use crate::database::Database;
use crate::options::Options;

/// Compiles all sources of a project, in any order of blocks.
pub fn compile(sources: &Sources, symbols: &SymbolTable, options: &Options) -> Compiled {
    Database::of(sources, symbols, options).into_compiled()
}

/// Compiles any bytes as a source; for fuzzing.
pub fn fuzz(data: &[u8]) {
    let mut sources = Sources::default();
    sources.add("fuzz.awl", String::from_utf8_lossy(data));
    let compiled = compile(&sources, &SymbolTable::default(), &Options { extended: true, ..Options::default() });
    for (id, block) in &compiled.program.code {
        assert_eq!(sieben_engine::ir::verify(&block.code), Ok(()), "the code of {id} keeps the rules of the IR");
    }
}
