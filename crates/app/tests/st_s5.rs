//! The timers and counters of S5 called as functions do in every scan what the same boxes written in STL do.

#[allow(dead_code)] // The pages need more of it.
mod program;

use std::sync::Arc;

use sieben_cpu::{Cpu, Restart};
use sieben_engine::Program;
use sieben_lang::Options;
use sieben_lang::st::dialect::Dialect;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Severity;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;
use sieben_sim::names::Name;

const SCANS: u32 = 400;
/// Where the remaining time goes: a variable of its type.
const KEPT: &str = "DATA_BLOCK DB9\nSTRUCT\nx : S5TIME;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n";

fn cpu_type() -> &'static CpuType {
    CpuType::by_name("416-3").expect("a CPU")
}

fn compile(file: &str, text: &str) -> (Arc<Program>, Vec<String>) {
    let mut sources = Sources::default();
    sources.add(file, text);
    let dialect = file.ends_with(".scl").then_some(Dialect::Scl);
    let options = Options { cpu: Some(cpu_type()), dialect, system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
    let compiled = sieben_lang::compile(&sources, &SymbolTable::default(), &options);
    let errors = compiled.diagnostics.iter().filter(|one| one.severity() == Severity::Error);
    let errors = errors.map(|one| format!("{}: {}", one.problem.code(), one.message)).collect();
    (Arc::new(compiled.program), errors)
}

fn in_ob1(variables: &str, statements: &str) -> String {
    format!(
        "{}ORGANIZATION_BLOCK OB1\nVAR_TEMP\nstart : ARRAY[1..20] OF BYTE;\n{variables}END_VAR\nBEGIN\n{statements}\nEND_ORGANIZATION_BLOCK\n",
        if statements.contains("FC1(") || statements.contains("FB1.") || statements.contains("DB9") { KEPT } else { "" }
    )
}

/// What both deliver: the result, BI or CV, Q.
fn outputs(cpu: &mut Cpu, program: &Program) -> Vec<String> {
    let name = |text: &str| Name::parse(text, &SymbolTable::default(), program).expect("an address");
    ["MW10", "MW12", "M14.0"].map(|text| name(text).read(cpu).map_or_else(|error| error.to_string(), |value| value.to_string())).to_vec()
}

fn lockstep(stl: &str, scl: &str) {
    let (stl, errors) = compile("box.awl", &in_ob1("", stl));
    assert!(errors.is_empty(), "{errors:?}");
    let (scl, errors) = compile("box.scl", scl);
    assert!(errors.is_empty(), "{errors:?}");
    for (engine, load) in program::ENGINES {
        let mut pair = [&stl, &scl].map(|program| {
            let mut cpu = program::cpu(program, cpu_type(), *load, None);
            cpu.restart(Restart::Warm);
            (cpu, program)
        });
        let mut state = 0x2545_F491_u32;
        let mut seen = std::collections::BTreeSet::new();
        for scan in 0..SCANS {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            let results = pair.each_mut().map(|(cpu, program)| {
                // S of a counter and R seldom: M 0.2 and M 0.3.
                let inputs = state >> 8
                    & match state >> 20 & 15 {
                        0 => 0b1011,
                        1 | 2 => 0b0111,
                        _ => 0b0011,
                    };
                for bit in 0..4 {
                    let name = Name::parse(&format!("M0.{bit}"), &SymbolTable::default(), program).expect("an address");
                    name.write(cpu, if inputs >> bit & 1 != 0 { "1" } else { "0" }).expect("a bit");
                }
                cpu.scan(u64::from(scan) * 70_000);
                outputs(cpu, program)
            });
            assert_eq!(results[0], results[1], "[{engine}] scan {scan}");
            seen.insert(results[0].clone());
        }
        assert!(seen.len() > 3, "[{engine}] the inputs do too little: {seen:?}");
    }
}

fn timer(stl: &str, scl: &str) {
    let stl = format!("A M 0.0;\nL S5T#250MS;\n{stl} T 5;\nA M 0.3;\nR T 5;\nL T 5;\nT MW 12;\nLC T 5;\nT MW 10;\nA T 5;\n= M 14.0;");
    for (variables, number, before) in [("", "T5", ""), ("n : INT;\n", "n", "n := 5;"), ("n : WORD;\n", "T[n]", "n := 5;")] {
        let variables = variables.replace("WORD", "INT");
        let call = format!(
            "{before} DB9.x := {scl}(T_NO := {number}, S := M0.0, TV := T#250ms, R := M0.3, BI := MW12, Q := M14.0); MW10 := DB9.DW0;"
        );
        lockstep(&stl, &in_ob1(&variables, &call));
    }
    // Through a parameter of a function and of a function block.
    let call = format!("DB9.x := {scl}(T_NO := t, S := M0.0, TV := S5T#250ms, R := M0.3, BI => MW12, Q => M14.0); MW10 := DB9.DW0;");
    let function = format!("FUNCTION FC1 : VOID\nVAR_INPUT\nt : TIMER;\nEND_VAR\nBEGIN\n{call}\nEND_FUNCTION\n");
    lockstep(&stl, &format!("{function}{}", in_ob1("", "FC1(t := T5);")));
    let block = format!("FUNCTION_BLOCK FB1\nVAR_INPUT\nt : TIMER;\nEND_VAR\nBEGIN\n{call}\nEND_FUNCTION_BLOCK\n");
    lockstep(&stl, &format!("{block}DATA_BLOCK DB1 FB1\nBEGIN\nEND_DATA_BLOCK\n{}", in_ob1("", "FB1.DB1(t := T5);")));
}

#[test]
fn timers_do_what_those_of_stl_do() {
    for (stl, english, german) in [
        ("SP", "S_PULSE", "S_IMPULS"),
        ("SE", "S_PEXT", "S_VIMP"),
        ("SD", "S_ODT", "S_EVERZ"),
        ("SS", "S_ODTS", "S_SEVERZ"),
        ("SF", "S_OFFDT", "S_AVERZ"),
    ] {
        timer(stl, english);
        timer(stl, german);
    }
}

#[test]
fn counters_do_what_those_of_stl_do() {
    for (steps, inputs, english, german) in [
        ("A M 0.0;\nCU C 3;\n", "CU := M0.0, ", "S_CU", "Z_VORW"),
        ("A M 0.1;\nCD C 3;\n", "CD := M0.1, ", "S_CD", "Z_RUECK"),
        ("A M 0.0;\nCU C 3;\nA M 0.1;\nCD C 3;\n", "CU := M0.0, CD := M0.1, ", "S_CUD", "ZAEHLER"),
    ] {
        let stl = format!("{steps}A M 0.2;\nL C#12;\nS C 3;\nA M 0.3;\nR C 3;\nL C 3;\nT MW 12;\nLC C 3;\nT MW 10;\nA C 3;\n= M 14.0;");
        for (name, preset) in [(english, "C#12"), (german, "16#0012")] {
            let call = format!("MW10 := {name}(C_NO := C3, {inputs}S := M0.2, PV := {preset}, R := M0.3, CV := MW12, Q := M14.0);");
            lockstep(&stl, &in_ob1("", &call));
        }
    }
}

#[test]
fn what_is_left_out_is_not_done() {
    let stl = "A M 0.0;\nL S5T#250MS;\nSD T 5;\nL T 5;\nT MW 12;\nLC T 5;\nT MW 10;\nA T 5;\n= M 14.0;";
    let scl = "S_ODT(T_NO := T5, S := M0.0, TV := T#250ms); DB9.x := S_ODT(T_NO := T5, BI := MW12, Q := M14.0); MW10 := DB9.DW0;";
    lockstep(stl, &in_ob1("", scl));
}

#[test]
fn a_wrong_call_is_refused() {
    for (call, code) in [
        ("S_ODT(S := M0.0, TV := T#1s);", "P3010"),
        ("S_ODT(T_NO := T5, S := M0.0);", "P3010"),
        ("S_ODT(T_NO := T5, TV := T#1s);", "P3010"),
        ("S_ODT(T_NO := C5);", "P4011"),
        ("S_ODT(T_NO := T5, X := 1);", "P3009"),
        ("S_ODT(T_NO := T5, T_NO := T6);", "P3011"),
        ("S_ODT(T_NO := T5, S => M0.0);", "P6219"),
        ("S_ODT(T_NO := T5, S := M0.0, TV := T#3h);", "P4001"),
        ("S_CU(C_NO := C5, CU := 1.5);", "P6200"),
        ("S_CU(C_NO := C5, CV => 5);", "P6"),
    ] {
        let (_, errors) = compile("wrong.scl", &in_ob1("", call));
        assert!(errors.iter().any(|error| error.starts_with(code)), "{call}: {errors:?}");
    }
}
