//! Machine code grows with the program and not faster, whatever the statements are.

#[allow(dead_code)] // The pages need more of it.
mod program;

use program::compile;
use sieben_engine::{Layout, Program};
use sieben_jit::{Jit, StatusBits};
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;

/// Statements that a program may have any number of, one after the other.
const STATEMENTS: &[&str] = &[
    "A I 0.1;",
    "A(; O I 0.1; );",
    "AN(; A I 0.1; );",
    "O(; A I 0.1; );",
    "ON(; O I 0.1; );",
    "X(; O I 0.1; );",
    "XN(; AN I 0.1; );",
    "A(; X(; O(; A I 0.1; ); ); );",
    "O; A I 0.1;",
    "O; A(; O I 0.1; );",
    "A I 0.1; S Q 0.1; = Q 0.2; NOT; FP M 1.0;",
    "L MW 2; L MW 4; +I; T MW 2; A OV; O <0; = Q 0.3;",
    "L MD 8; L MD 12; *R; T MD 8; AN UO; = Q 0.3;",
    "L MD 8; L MD 12; >D; S Q 0.4; PUSH; TAK;",
    "L MW 2; SLW 3; RLD 5; T MD 12; A ==0; = Q 0.5;",
    "A I 0.0; SAVE; A BR; = Q 0.6; L STW; T MW 20;",
    "A I 0.0; L S5T#1S; SD T 1; A T 1; CU C 1; L C 1; T MW 22;",
    "A I 0.1; MCR(; = Q 0.7; )MCR;",
];

fn bytes(statements: &str, count: usize, compiled: fn(&Program, &Layout, StatusBits) -> usize, status: StatusBits) -> usize {
    let cpu = CpuType::by_name("315-2PN/DP").expect("a CPU type");
    let body = format!("MCRA;\n{}MCRD;\n", format!("{statements}\n").repeat(count));
    let text = format!(
        "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n  info : ARRAY [1..20] OF BYTE;\nEND_VAR\nBEGIN\nNETWORK\n{body}END_ORGANIZATION_BLOCK\n"
    );
    let program = compile(&text, Mnemonics::English, cpu).expect("the program compiles").program;
    compiled(&program, &Layout::new(cpu, &program), status)
}

fn optimized(program: &Program, layout: &Layout, status: StatusBits) -> usize {
    Jit::compiled(program, layout, status).expect("it becomes machine code").code_bytes()
}

#[test]
fn four_times_as_many_statements_take_about_four_times_as_many_bytes() {
    for statements in STATEMENTS {
        for status in [StatusBits::All, StatusBits::Needed] {
            let few = bytes(statements, 25, optimized, status);
            let many = bytes(statements, 100, optimized, status);
            assert!(many < few * 5, "{statements} {status:?}: {few} bytes 25 times, {many} bytes 100 times");
        }
    }
}
