//! Files of two dialects in one program: each finds the blocks of its own library under the same names.

#[allow(dead_code)] // The pages need more of it.
mod program;

use std::sync::Arc;

use sieben_cpu::Restart;
use sieben_lang::Options;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Severity;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;
use sieben_sim::names::Name;

/// With PT = 0 the TON of iec is a wire, and that of scl (SFB 4) stays off.
const IEC: &str = "FUNCTION_BLOCK Late
VAR_INPUT x : BOOL; END_VAR
VAR_OUTPUT q : BOOL; END_VAR
VAR t : TON; END_VAR
t(IN := x, PT := T#0s, Q => q);
END_FUNCTION_BLOCK
";

const SCL: &str = "FUNCTION_BLOCK FB10
VAR_INPUT x : BOOL; END_VAR
VAR_OUTPUT q : BOOL; END_VAR
VAR t : TON; END_VAR
BEGIN
t(IN := x, PT := T#0s);
q := t.Q;
END_FUNCTION_BLOCK
DATA_BLOCK DB10 FB10
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB11 Late
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB1
VAR_TEMP start : ARRAY[1..20] OF BYTE; END_VAR
BEGIN
FB10.DB10(x := M0.0);
Late.DB11(x := M0.0);
M1.0 := DB10.q;
M1.1 := DB11.q;
END_ORGANIZATION_BLOCK
";

#[test]
fn each_file_has_the_timers_of_its_dialect() {
    for files in [[("late.iecst", IEC), ("main.scl", SCL)], [("main.scl", SCL), ("late.iecst", IEC)]] {
        let mut sources = Sources::default();
        for (name, text) in files {
            sources.add(name, text);
        }
        let cpu_type = CpuType::by_name("416-3").expect("a CPU");
        let options = Options { cpu: Some(cpu_type), system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
        let compiled = sieben_lang::compile(&sources, &SymbolTable::default(), &options);
        let errors = compiled.diagnostics.iter().filter(|one| one.severity() == Severity::Error);
        let errors: Vec<String> = errors.map(|one| format!("{}: {}", one.problem.code(), one.message)).collect();
        assert!(errors.is_empty(), "{errors:?}");
        let program = Arc::new(compiled.program);
        for (engine, load) in program::ENGINES {
            let mut cpu = program::cpu(&program, cpu_type, *load, None);
            cpu.restart(Restart::Warm);
            let name = |text: &str| Name::parse(text, &SymbolTable::default(), &program).expect("an address");
            name("M0.0").write(&mut cpu, "1").expect("a bit");
            cpu.scan(0);
            cpu.scan(10_000);
            let read = |text: &str| name(text).read(&cpu).expect("a bit").to_string();
            assert_eq!([read("M1.0"), read("M1.1")], ["0", "1"], "[{engine}] scl, iec");
        }
    }
}
