//! A large project for the measurement: 500 files with 100,000 statements of STL and SCL.

use std::fmt::Write as _;

use sieben_model::source::Sources;
use sieben_model::symbols::{Symbol, SymbolTable};

/// Files of the project; each has a function and a function block of 100 statements.
pub(crate) const FILES: usize = 500;
/// Statements of one block.
pub(crate) const BLOCK_STATEMENTS: usize = 100;
/// Every this many files one is written in SCL.
const SCL_EVERY: usize = 3;

/// What the measurement compiles.
pub(crate) struct Project {
    /// Its sources: `FILES` of them, and one with OB 1 and the instances.
    pub(crate) sources: Sources,
    /// Its symbol table.
    pub(crate) symbols: SymbolTable,
}

/// The text of one file. With `edited` the last statement of its function block has another constant.
pub(crate) fn file(number: usize, edited: Option<usize>) -> String {
    if is_scl(number) { scl(number, edited) } else { stl(number, edited) }
}

/// Whether a file is written in SCL.
pub(crate) fn is_scl(number: usize) -> bool {
    number.is_multiple_of(SCL_EVERY)
}

fn callee(number: usize) -> usize {
    // Each function calls the one before it in groups of ten, so that nesting stays shallow.
    if number.is_multiple_of(10) { number } else { number - 1 }
}

fn stl(number: usize, edited: Option<usize>) -> String {
    let block = number + 1;
    let mut text =
        format!("FUNCTION FC {block} : INT\nVAR_INPUT\n a : INT;\n b : INT;\nEND_VAR\nVAR_TEMP\n t : INT;\nEND_VAR\nBEGIN\nNETWORK\n");
    body(&mut text, number, BLOCK_STATEMENTS - 2, "t");
    text += "L #a;\nT #RET_VAL;\nEND_FUNCTION\n\n";
    let _ = write!(
        text,
        "FUNCTION_BLOCK FB {block}\nVAR_INPUT\n start : BOOL;\n speed : INT;\nEND_VAR\nVAR_OUTPUT\n run : BOOL;\n sum : INT;\nEND_VAR\nVAR\n count : INT;\n edge : BOOL;\n values : ARRAY[0..9] OF INT;\nEND_VAR\nVAR_TEMP\n t : INT;\nEND_VAR\nBEGIN\nNETWORK\n"
    );
    body(&mut text, number, BLOCK_STATEMENTS - 3, "t");
    let callee = callee(number) + 1;
    let _ = write!(
        text,
        "CALL FC {callee} (a := #speed, b := #count, RET_VAL := #sum);\nL {};\nT #count;\nEND_FUNCTION_BLOCK\n",
        edited.unwrap_or(0)
    );
    text
}

fn body(text: &mut String, number: usize, statements: usize, local: &str) {
    for index in 0..statements {
        let line = match index % 7 {
            0 => format!("A \"signal_{}\"", (number * 13 + index) % 1000),
            1 => format!("AN M {}.{}", index % 200, index % 8),
            2 => format!("= Q {}.{}", index % 100, index % 8),
            3 => format!("L DB{}.DBW {}", (number + index) % FILES + 1, 2 * (index % 3)),
            4 => format!("L {index}"),
            5 => "+I".to_owned(),
            _ => format!("T #{local}"),
        };
        let _ = writeln!(text, "      {line};");
    }
}

fn scl(number: usize, edited: Option<usize>) -> String {
    let block = number + 1;
    let mut text = format!("FUNCTION FC{block} : INT\nVAR_INPUT\n a : INT;\n b : INT;\nEND_VAR\nVAR_TEMP\n t : INT;\nEND_VAR\nBEGIN\n");
    scl_body(&mut text, number, BLOCK_STATEMENTS - 1);
    let _ = write!(text, "FC{block} := a;\nEND_FUNCTION\n\n");
    let _ = write!(
        text,
        "FUNCTION_BLOCK FB{block}\nVAR_INPUT\n start : BOOL;\n speed : INT;\nEND_VAR\nVAR_OUTPUT\n run : BOOL;\n sum : INT;\nEND_VAR\nVAR\n count : INT;\n edge : BOOL;\n values : ARRAY[0..9] OF INT;\nEND_VAR\nVAR_TEMP\n t : INT;\nEND_VAR\nBEGIN\n"
    );
    scl_body(&mut text, number, BLOCK_STATEMENTS - 2);
    let callee = callee(number) + 1;
    let _ = write!(text, "sum := FC{callee}(a := speed, b := count);\ncount := {};\nEND_FUNCTION_BLOCK\n", edited.unwrap_or(0));
    text
}

fn scl_body(text: &mut String, number: usize, statements: usize) {
    for index in 0..statements {
        let line = match index % 5 {
            0 => format!("t := t + {index}"),
            1 => format!("IF \"signal_{}\" THEN t := t - 1; END_IF", (number * 13 + index) % 1000),
            2 => format!("M{}.{} := \"signal_{}\" AND NOT Q{}.0", index % 200, index % 8, index % 1000, index % 100),
            3 => format!("t := t + DB{}.sum * {index}", (number + index) % FILES + 1),
            _ => "t := t * 3".to_owned(),
        };
        let _ = writeln!(text, "   {line};");
    }
}

/// The whole project.
pub(crate) fn project() -> Project {
    let mut sources = Sources::default();
    for number in 0..FILES {
        let ending = if is_scl(number) { "scl" } else { "awl" };
        sources.add(format!("file_{number:03}.{ending}"), file(number, None));
    }
    let mut main = String::new();
    for number in 1..=FILES {
        let _ = writeln!(main, "DATA_BLOCK DB {number}\nFB {number}\nBEGIN\nEND_DATA_BLOCK\n");
    }
    main += "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY[1..20] OF BYTE;\nEND_VAR\nBEGIN\n";
    for number in 1..=FILES {
        let _ = writeln!(main, "CALL FB {number}, DB {number} (start := TRUE, speed := 3);");
    }
    main += "END_ORGANIZATION_BLOCK\n";
    sources.add("main.awl", main);
    let mut symbols = SymbolTable::default();
    for number in 0..1000 {
        symbols.push(Symbol {
            name: format!("signal_{number}"),
            address: format!("I {}.{}", number / 8, number % 8),
            data_type: "BOOL".to_owned(),
            ..Symbol::default()
        });
    }
    Project { sources, symbols }
}
