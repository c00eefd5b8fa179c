//! The fuzz targets: one row each.

use sieben_lang::Options;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

/// Something that must survive any input.
pub struct Target {
    /// The name on the command line.
    pub name: &'static str,
    /// Runs it on one input.
    pub fuzz: fn(&[u8]),
    /// The folder of its first inputs, in `fuzz-corpus/`.
    pub corpus: &'static str,
    /// Fences of the pages in `spec/` that are first inputs too.
    pub fences: &'static [&'static str],
    /// Words that its inputs are made of.
    pub words: fn() -> Vec<&'static str>,
}

/// All targets.
pub const TARGETS: &[Target] = &[Target { name: "lang-compile", fuzz: compile, corpus: "stl", fences: &["stl"], words: stl_words }];

/// Compiles the input as the only source of a project.
fn compile(data: &[u8]) {
    let mut sources = Sources::default();
    sources.add("fuzz.awl", String::from_utf8_lossy(data));
    sieben_lang::compile(&sources, &SymbolTable::default(), &Options::default());
}

fn stl_words() -> Vec<&'static str> {
    Vec::new()
}
