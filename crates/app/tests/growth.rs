//! What a source costs grows with its size and not with its square, whatever there is many of in it.
#![cfg(unix)]

use std::fmt::Write as _;

use rustix::time::{ClockId, clock_gettime};
use sieben_lang::symbols::{self, Format};
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;

/// Of each thing there are so many, and then eight times as many.
const FEW: usize = 1_200;
const TIMES: usize = 8;
/// Eight times the size may take so many times the time; with the square of the size it would be 64.
const GROWTH_MAX: f64 = 16.0;
/// How often a source is measured before it is said to grow too much.
const TRIES: usize = 3;

/// Processor time of this thread in seconds: what else the computer does plays no part.
fn spent() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 / 1e9
}

fn check(name: &str, text: &str) {
    let mut sources = Sources::default();
    sources.add(name, text);
    let options = sieben_lang::Options { system_blocks: sieben_cpu::system::interfaces(), ..Default::default() };
    let _ = sieben_lang::compile(&sources, &SymbolTable::default(), &options);
}

/// `begin`, so many lines of which `{n}` stands for the number, and `end`.
fn many(count: usize, begin: &str, line: &str, end: &str) -> String {
    let mut text = begin.to_owned();
    for number in 0..count {
        let _ = writeln!(text, "{}", line.replace("{n}", &number.to_string()));
    }
    text + end
}

/// The name of a kind of source, and one with so many of the thing.
type Kind = (&'static str, fn(usize) -> String);

const KINDS: &[Kind] = &[
    ("variables.st", |n| many(n, "FUNCTION_BLOCK FB1\nVAR\n", "b{n} : BOOL;", "END_VAR\nb0 := b1;\nEND_FUNCTION_BLOCK\n")),
    ("variables of a program.st", |n| many(n, "PROGRAM P\nVAR\n", "b{n} : BOOL;", "END_VAR\nb0 := b1;\nEND_PROGRAM\n")),
    ("undeclared names.st", |n| many(n, "PROGRAM P\nVAR\n", "b{n} : BOOL;", "END_VAR\n") + &many(n, "", "x{n} := TRUE;", "END_PROGRAM\n")),
    ("labels.scl", |n| many(n, "FUNCTION FC1 : VOID\nLABEL\n", "l{n};", "END_LABEL\nBEGIN\n") + &many(n, "", "l{n}: ;", "END_FUNCTION\n")),
    ("gotos.scl", |n| {
        many(n, "FUNCTION FC1 : VOID\nLABEL\n", "l{n};", "END_LABEL\nBEGIN\n") + &many(n, "", "GOTO l{n}; l{n}: ;", "END_FUNCTION\n")
    }),
    ("parameters of a block.st", |n| {
        many(n, "FUNCTION_BLOCK F\nVAR_INPUT\n", "p{n} : BOOL;", "END_VAR\n;\nEND_FUNCTION_BLOCK\n")
            + &many(n, "PROGRAM P\nVAR f : F; END_VAR\nf(", "p{n} := TRUE,", "p0 := TRUE);\nEND_PROGRAM\n")
    }),
    ("fields.st", |n| {
        many(n, "TYPE S : STRUCT\n", "e{n} : INT;", "END_STRUCT; END_TYPE\n")
            + &many(n, "PROGRAM P\nVAR a : S; END_VAR\n", "a.e{n} := 1;", "END_PROGRAM\n")
    }),
    ("enumeration.st", |n| {
        many(n, "TYPE E : (", "e{n},", "last); END_TYPE\n") + &many(n, "PROGRAM P\nVAR a : E; END_VAR\n", "a := e{n};", "END_PROGRAM\n")
    }),
    ("instances.st", |n| {
        many(n, "FUNCTION_BLOCK F\nVAR x : INT; END_VAR\nx := 1;\nEND_FUNCTION_BLOCK\nPROGRAM P\nVAR\n", "f{n} : F;", "END_VAR\n")
            + &many(n, "", "f{n}();", "END_PROGRAM\n")
    }),
    ("case.st", |n| many(n, "PROGRAM P\nVAR a : DINT; END_VAR\nCASE a OF\n", "{n}: a := {n};", "END_CASE;\nEND_PROGRAM\n")),
    ("constants.st", |n| many(n, "PROGRAM P\nVAR CONSTANT\n", "c{n} : DINT := {n};", "END_VAR\n;\nEND_PROGRAM\n")),
    ("strings.st", |n| many(n, "PROGRAM P\nVAR s : STRING; END_VAR\n", "s := 'text {n}';", "END_PROGRAM\n")),
    ("types.st", |n| many(n, "TYPE\n", "T{n} : STRUCT a : INT; END_STRUCT;", "END_TYPE\n")),
    ("pragmas.st", |n| many(n, "PROGRAM P\nVAR\n", "{attribute 'x'} v{n} : INT;", "END_VAR\n;\nEND_PROGRAM\n")),
    ("comments.st", |n| "PROGRAM P\n".to_owned() + &"(*".repeat(n) + &"*)".repeat(n) + "\nEND_PROGRAM\n"),
    ("broken.st", |n| many(n, "PROGRAM P\n", "IF a ] THEN {n} := ;", "")),
    ("fields.awl", |n| {
        many(n, "DATA_BLOCK DB 1\nSTRUCT\n", "f{n} : BOOL ;", "END_STRUCT\nBEGIN\n") + &many(n, "", "f{n} := TRUE;", "END_DATA_BLOCK\n")
    }),
    ("conditions.awl", |n| many(n, "", "A I 0.0;\nL MW 0;\nT MW 2;\n= Q 0.0;", "")),
    ("functions.awl", |n| many(n, "", "FUNCTION FC {n} : VOID\nBEGIN\nNOP 0;\nEND_FUNCTION", "")),
    ("networks.awl", |n| many(n, "FUNCTION FC 1 : VOID\nBEGIN\n", "NETWORK\nTITLE = x\nA I 0.0;\n= Q 4.0;", "END_FUNCTION\n")),
    ("jumps.awl", |n| many(n, "FUNCTION FC 1 : VOID\nBEGIN\n", "JU m{n};\nm{n}: NOP 0;", "END_FUNCTION\n")),
    ("parameters.awl", |n| {
        many(n, "FUNCTION FC 1 : VOID\nVAR_INPUT\n", "p{n} : BOOL;", "END_VAR\nBEGIN\nNOP 0;\nEND_FUNCTION\n")
            + &many(n, "ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1 (", "p{n} := TRUE,", "p0 := TRUE);\nEND_ORGANIZATION_BLOCK\n")
    }),
];

#[test]
fn no_source_costs_the_square_of_its_size() {
    let mut wrong = Vec::new();
    for (name, source) in KINDS {
        let (few, many) = (source(FEW), source(FEW * TIMES));
        let cost = |text: &str| {
            let begin = spent();
            check(name, text);
            spent() - begin
        };
        cost(&few);
        let few = cost(&few).max(cost(&few)).max(0.002);
        // Other work on the machine only ever adds time: what grows too much does so each time.
        let growth = (0..TRIES).map(|_| cost(&many) / few).find(|growth| *growth <= GROWTH_MAX);
        let growth = growth.unwrap_or_else(|| cost(&many) / few);
        if growth > GROWTH_MAX {
            wrong.push(format!("{name}: {growth:.0} times the time ({few:.3} s before)"));
        }
    }
    assert!(wrong.is_empty(), "{TIMES} times the size takes\n{}", wrong.join("\n"));
}

#[test]
fn no_symbol_table_costs_the_square_of_its_size() {
    let table = |n: usize| {
        let mut text = "symbol,address,type,comment\n".to_owned();
        for number in 0..n {
            let _ = writeln!(text, "s{number},M {}.{},BOOL,c", number / 8, number % 8);
        }
        text
    };
    let cost = |text: &str| {
        let begin = spent();
        let read = symbols::read(FileId(0), text, Format::Csv);
        assert!(read.diagnostics.is_empty());
        spent() - begin
    };
    let (few, many) = (table(FEW), table(FEW * TIMES));
    cost(&few);
    let growth = cost(&many) / cost(&few).max(0.002);
    assert!(growth <= GROWTH_MAX, "{growth:.0} times the time");
}
