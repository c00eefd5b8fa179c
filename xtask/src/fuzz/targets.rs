//! The fuzz targets: one row each.

use sieben_lang::Options;
use sieben_lang::stl::instructions::Instruction;
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

/// Mnemonics of both languages and the words between them.
fn stl_words() -> Vec<&'static str> {
    const WORDS: &[&str] = &[
        "ORGANIZATION_BLOCK OB 1",
        "FUNCTION FC 1 : VOID",
        "FUNCTION_BLOCK FB 1",
        "DATA_BLOCK DB 1",
        "TYPE UDT 1",
        "STRUCT",
        "END_STRUCT",
        "END_TYPE",
        "END_FUNCTION",
        "END_FUNCTION_BLOCK",
        "END_ORGANIZATION_BLOCK",
        "END_DATA_BLOCK",
        "BEGIN",
        "NETWORK",
        "TITLE =",
        "VERSION : 0.1",
        "AUTHOR : x",
        "KNOW_HOW_PROTECT",
        "VAR",
        "VAR_INPUT",
        "VAR_OUTPUT",
        "VAR_IN_OUT",
        "VAR_TEMP",
        "END_VAR",
        "ARRAY [1..3] OF INT",
        "STRING[10]",
        "UDT 1",
        "FB 1",
        "BOOL",
        "BYTE",
        "WORD",
        "DWORD",
        "INT",
        "DINT",
        "REAL",
        "S5TIME",
        "TIME",
        "DATE",
        "DATE_AND_TIME",
        "POINTER",
        "ANY",
        ":=",
        ":",
        ";",
        "..",
        "//",
        "(*",
        "I 0.0",
        "E 0.0",
        "Q 0.0",
        "A 0.0",
        "MW 10",
        "MD 4",
        "L 0.0",
        "DB1.DBW 0",
        "DBX 0.0",
        "DIW 2",
        "T 1",
        "C 1",
        "Z 1",
        "PIW 256",
        "PEW 256",
        "#x",
        "\"s\"",
        "\"s\".a[1]",
        "[AR1,P#0.0]",
        "[MD 4]",
        "P##x",
        "P#M 0.0 BYTE 4",
        "W#16#FFFF",
        "S5T#2H46M30S",
        "L#-1",
        "2#1",
        "B#(1,2,3,4)",
        "C#999",
        "1.0e10",
        "'abc'",
        "D#2024-2-29",
        "TOD#23:59:59.999",
        "DT#24-1-1-0:0:0",
        "T#-1ms",
        "==0",
        "UO",
        "AR2",
        "STW",
        "label:",
        "{ S7_m_c := 'true' }",
    ];
    let mnemonics = Instruction::ALL.iter().flat_map(|row| [row.english(), row.german()]);
    mnemonics.chain(WORDS.iter().copied()).collect()
}
