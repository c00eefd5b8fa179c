//! Tiers of machine code: when code changes under a running program, nothing else does.

use std::cell::Cell;
use std::sync::Arc;

use sieben_cpu::{Cpu, OperatingMode, Restart, Settings, Station};
use sieben_engine::{Interpreter, Program};
use sieben_jit::{StatusBits, Tier, Tiers};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;

#[allow(dead_code)] // The pages need more of it.
mod program;

/// Scans of a run.
const SCANS: u64 = 400;

/// Programs of all kinds, each on the CPU type that it is for.
const PROGRAMS: [(&str, &str, &str); 4] = [
    ("dosing", "315-2PN/DP", include_str!("../../../examples/dosing/dosing.awl")),
    ("arithmetic loop", "315-2PN/DP", include_str!("../../../benches/arithmetic_loop.awl")),
    ("calls mix", "315-2PN/DP", include_str!("../../../benches/calls_mix.awl")),
    ("interrupts", "416-3", INTERRUPTS),
];

/// Blocks that interrupt each other, faults with OB 121, edges, timers, counters and a loop.
const INTERRUPTS: &str = "
DATA_BLOCK DB 1
STRUCT a : ARRAY [0..19] OF INT; END_STRUCT;
BEGIN
END_DATA_BLOCK
FUNCTION FC 1 : VOID
VAR_INPUT n : INT; END_VAR
VAR_IN_OUT sum : INT; END_VAR
BEGIN
L #n; L #sum; +I; T #sum;
END_FUNCTION
ORGANIZATION_BLOCK OB 1
VAR_TEMP info : ARRAY [0..19] OF BYTE; i : INT; END_VAR
BEGIN
A I 0.0; FP M 0.0; CU C 1; = Q 0.0;
A I 0.1; L S5T#300MS; SD T 1; A T 1; = Q 0.1;
OPN DB 1;
L 24;
next: T #i;
L #i; SLD 4; T MD 20; L DBW [MD 20]; INC 3; T DBW [MD 20];
CALL FC 1 (n := #i, sum := MW 30);
L #i; LOOP next;
L MW 40; L 7; +I; T MW 40;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 35
VAR_TEMP info : ARRAY [0..19] OF BYTE; END_VAR
BEGIN
L MW 50; INC 1; T MW 50; L MW 40; L MW 50; XOW; T MW 52;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 121
VAR_TEMP info : ARRAY [0..19] OF BYTE; END_VAR
BEGIN
L MW 60; INC 1; T MW 60;
END_ORGANIZATION_BLOCK
";

/// A sequence without pattern.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit
    }
}

fn compiled(text: &str, cpu_type: &'static CpuType) -> Arc<Program> {
    Arc::new(program::compile(text, Mnemonics::English, cpu_type).expect("the program compiles").program)
}

/// A CPU whose program is in the interpreter, and what brings it into other tiers.
fn tiered(program: &Arc<Program>, cpu_type: &'static CpuType, status: StatusBits) -> (Cpu, Arc<Tiers>) {
    let tiers = Cell::new(None);
    let load = |program: &Program, layout: &_| {
        let loaded = Tiers::load(program, layout, status);
        let engine = loaded.engine();
        tiers.set(Some(loaded));
        engine
    };
    let rack = sieben_cpu::Rack::simulated(cpu_type);
    let cpu = Cpu::load(cpu_type, Arc::clone(program), load, rack, Settings::default());
    (cpu, tiers.take().expect("the program was loaded"))
}

#[test]
fn a_program_does_the_same_whenever_its_code_changes() {
    for (name, cpu_type, text) in PROGRAMS {
        let cpu_type = CpuType::by_name(cpu_type).expect("a CPU type");
        let program = compiled(text, cpu_type);
        let mut random = Random(7);
        let mut interpreted = program::cpu(&program, cpu_type, Interpreter::load, None);
        let (mut cpu, tiers) = tiered(&program, cpu_type, StatusBits::All);
        let mut seen = [0; 3];
        for cpu in [&mut interpreted, &mut cpu] {
            assert_eq!(cpu.restart(Restart::Warm), OperatingMode::Run, "{name}");
        }
        for scan in 0..SCANS {
            if random.below(8) == 0 {
                let tier = Tier::ALL[random.below(3)];
                tiers.compile(tier).expect("the program becomes machine code");
                assert_eq!(tiers.tier(), tier);
            }
            seen[tiers.tier() as usize] += 1;
            let (byte, value) = (random.below(4) as u32, random.below(256) as u32);
            let input = Operand::Address(Address { area: Area::Input, width: Width::Byte, byte, bit: 0 });
            for cpu in [&mut interpreted, &mut cpu] {
                cpu.modify(&input, value).expect("a simulated input");
                cpu.scan(scan * 10_000);
                assert_eq!(cpu.mode(), OperatingMode::Run, "{name}, scan {scan}: {:?}", cpu.stop_cause());
            }
            assert!(interpreted.machine() == cpu.machine(), "{name}: after scan {scan} in tier {:?} the machines differ", tiers.tier());
            assert_eq!(interpreted.registers(), cpu.registers(), "{name}, scan {scan}");
        }
        assert!(seen.iter().all(|&scans| scans > 20), "{name}: all tiers ran: {seen:?}");
    }
}

/// Bytes of address space of this process.
#[cfg(target_os = "linux")]
fn address_space() -> usize {
    let pages = std::fs::read_to_string("/proc/self/statm").expect("Linux tells it");
    pages.split(' ').next().and_then(|pages| pages.parse::<usize>().ok()).expect("a number of pages") * 4096
}

#[test]
#[cfg(target_os = "linux")]
fn a_generation_that_no_cpu_runs_is_freed() {
    let cpu_type = &CpuType::ALL[0];
    let program = compiled(PROGRAMS[2].2, cpu_type);
    let (mut cpu, tiers) = tiered(&program, cpu_type, StatusBits::Needed);
    cpu.restart(Restart::Warm);
    let mut scan = 0;
    let mut generations = |count: u64| {
        for tier in [Tier::Quick, Tier::Optimized].into_iter().cycle().take(count as usize) {
            tiers.compile(tier).expect("machine code");
            cpu.scan(scan * 10_000);
            scan += 1;
        }
        address_space()
    };
    let few = generations(10);
    let many = generations(60);
    // Each generation reserves 1 MiB of addresses at least.
    assert!(many < few + (20 << 20), "{few} bytes of addresses after 10 generations, {many} after 70");
    drop(cpu);
    assert_eq!(Arc::strong_count(&tiers), 1, "nobody runs the program");
}
