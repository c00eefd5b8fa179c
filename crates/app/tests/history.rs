//! The history of a run: going back and on again is the same run, bit for bit.

#[allow(dead_code)] // The pages need more of it.
mod program;

use std::sync::Arc;

use program::{ENGINES, compile};
use sieben_cpu::{Cpu, Interrupt, IoModule, Rack, Restart, Settings};
use sieben_engine::{FaultPlace, Machine, StatementEvent, Tracer};
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;
use sieben_sim::history::{Halt, History, Plan, Until, Unwatched};

/// Blocks, loops, local data, interrupts in time and by the program, errors of both kinds, timers, peripheral access, a data block that
/// is made and deleted, OB 90 and a delay.
const EVERYTHING: &str = "DATA_BLOCK DB 5
STRUCT
 sum : DINT;
 turns : INT;
END_STRUCT
BEGIN
END_DATA_BLOCK
FUNCTION FC 1 : VOID
VAR_INPUT
 n : INT;
END_VAR
VAR_TEMP
 i : INT;
 ret : INT;
 number : WORD;
END_VAR
BEGIN
L #n; T #i;
next: L DB5.DBD 0; L #i; ITD; +D; T DB5.DBD 0;
L #i; + -1; T #i; L 0; >I; JC next;
CALL SFC 22 (LOW_LIMIT := 100, UP_LIMIT := 103, COUNT := 20, RET_VAL := #ret, DB_NUMBER := #number);
OPN DB [#number];
L MW 2; T DBW 0;
L MB 1; L 3; AW; L 0; ==I; JCN out;
CALL SFC 23 (DB_NUMBER := #number, RET_VAL := #ret);
out: NOP 0;
END_FUNCTION
FUNCTION FC 2 : VOID
VAR_TEMP
 ret : INT;
END_VAR
BEGIN
L MW 2; + 1; T MW 2;
CALL SFC 32 (OB_NR := 20, DTIME := T#5MS, SIGN := W#16#1, RET_VAL := #ret);
END_FUNCTION
ORGANIZATION_BLOCK OB 1
VAR_TEMP
 info : ARRAY[1..20] OF BYTE;
 ret : INT;
END_VAR
BEGIN
A I 0.0; L S5T#30MS; SE T 1; A T 1; = Q 4.0;
CALL FC 1 (n := 7);
UC FC 2;
L PIW 2; T PQW 6;
L PIW 3000; T MW 20;
L P#500.0; LAR1; L MW [AR1, P#4000.0]; T MW 22;
L MW 22; SLW 3; T MW 22;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 20
VAR_TEMP
 info : ARRAY[1..20] OF BYTE;
END_VAR
BEGIN
L MW 30; + 1; T MW 30;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 35
VAR_TEMP
 info : ARRAY[1..20] OF BYTE;
END_VAR
BEGIN
L MW 32; + 1; T MW 32; UC FC 2;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 40
VAR_TEMP
 info : ARRAY[1..20] OF BYTE;
END_VAR
BEGIN
L MW 40; + 1; T MW 40; L PIB 7; T MB 42;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 100
VAR_TEMP
 info : ARRAY[1..20] OF BYTE;
END_VAR
BEGIN
L 100; T MW 2; UC FC 2;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 121
VAR_TEMP
 info : ARRAY[1..20] OF BYTE;
END_VAR
BEGIN
L MW 34; + 1; T MW 34; L LB 3; T MB 36;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 122
VAR_TEMP
 info : ARRAY[1..20] OF BYTE;
 ret : INT;
END_VAR
BEGIN
L MW 38; + 1; T MW 38;
CALL SFC 44 (VAL := DW#16#1234, RET_VAL := #ret);
END_ORGANIZATION_BLOCK
";

/// Whether the modules of a CPU can be copied, or what they say must be kept.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Modules {
    Copied,
    Recorded,
}

/// A module whose process nobody can take back: its inputs count what happens to it, and now and then it raises an interrupt.
struct Wild(Vec<u8>, u32);

impl IoModule for Wild {
    fn name(&self) -> &str {
        "wild"
    }
    fn inputs(&self) -> std::ops::Range<u32> {
        0..8
    }
    fn outputs(&self) -> std::ops::Range<u32> {
        0..8
    }
    fn read(&self, offset: u32, into: &mut [u8]) {
        into.copy_from_slice(&self.0[offset as usize..offset as usize + into.len()]);
    }
    fn write(&mut self, offset: u32, from: &[u8]) {
        self.1 += 1;
        self.0[7 - offset as usize % 8] ^= from.iter().fold(self.1 as u8, |sum, byte| sum.wrapping_mul(31).wrapping_add(*byte));
    }
    fn advance(&mut self, dt_us: u64) {
        self.0[0] = self.0[0].wrapping_add((dt_us / 1000) as u8) | 1;
    }
    fn alarms(&mut self) -> Vec<Interrupt> {
        if self.1.is_multiple_of(3) {
            vec![Interrupt::hardware(0, sieben_cpu::interrupts::ModuleAddress::Input(0), self.1)]
        } else {
            Vec::new()
        }
    }
    fn answers(&self) -> bool {
        !self.1.is_multiple_of(11)
    }
}

fn load(text: &str, cpu_type: &str, engine: usize, modules: Modules) -> Cpu {
    let cpu_type = CpuType::by_name(cpu_type).expect("a CPU type");
    let compiled = compile(text, Mnemonics::English, cpu_type).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let rack = match modules {
        Modules::Copied => Rack::simulated(cpu_type),
        Modules::Recorded => Rack::with_background(cpu_type, vec![Box::new(Wild(vec![0; 8], 0))]).expect("the module lies in the area"),
    };
    Cpu::load(cpu_type, Arc::new(compiled.program), ENGINES[engine].1, rack, Settings::default())
}

/// All moments of a run: every event, and the machine before every statement.
#[derive(Default)]
struct All {
    events: Vec<StatementEvent>,
    machines: Vec<Machine>,
}

impl Tracer for All {
    fn statement(&mut self, _machine: &Machine, event: &StatementEvent) {
        self.events.push(event.clone());
    }
    fn pauses_before(&mut self, machine: &Machine, _place: FaultPlace) -> bool {
        self.machines.push(machine.clone());
        false
    }
}

/// All that a program can see of a machine but the registers, which the event has.
fn same(left: &Machine, right: &Machine) -> bool {
    left.memory == right.memory && left.timers == right.timers && left.counters == right.counters && left.clock_us == right.clock_us
}

fn whole_run(text: &str, cpu_type: &str, scans: u64, modules: Modules) -> (All, Cpu) {
    let mut cpu = load(text, cpu_type, 0, modules);
    let mut all = All::default();
    cpu.restart_with(Restart::Warm, &mut || 0, Some(&mut all));
    for scan in 0..scans {
        cpu.scan_traced(scan * 37_000, &mut all);
    }
    (all, cpu)
}

/// Pauses before every statement.
struct EveryOne {
    first: bool,
    events: Vec<StatementEvent>,
}

impl Tracer for EveryOne {
    fn statement(&mut self, _machine: &Machine, event: &StatementEvent) {
        self.events.push(event.clone());
    }
    fn pauses_before(&mut self, _machine: &Machine, _place: FaultPlace) -> bool {
        !std::mem::take(&mut self.first)
    }
}

#[test]
fn a_run_that_is_paused_before_every_statement_is_the_same_run() {
    for cpu_type in ["315-2PN/DP", "416-3"] {
        let (all, through) = whole_run(EVERYTHING, cpu_type, 12, Modules::Copied);
        for (engine, &(engine_name, _)) in ENGINES.iter().enumerate() {
            let mut cpu = load(EVERYTHING, cpu_type, engine, Modules::Copied);
            let mut events = Vec::new();
            let mut one = |cpu: &mut Cpu, go: &mut dyn FnMut(&mut Cpu, &mut EveryOne)| {
                let mut tracer = EveryOne { first: false, events: Vec::new() };
                go(cpu, &mut tracer);
                events.append(&mut tracer.events);
                while cpu.is_paused() {
                    tracer.first = true;
                    // Taking it back at once changes nothing.
                    let snapshot = cpu.snapshot(None);
                    cpu.go_back_to(&snapshot);
                    cpu.go_on(Some(&mut tracer));
                    events.append(&mut tracer.events);
                }
            };
            one(&mut cpu, &mut |cpu, tracer| {
                cpu.restart_with(Restart::Warm, &mut || 0, Some(tracer));
            });
            for scan in 0..12 {
                one(&mut cpu, &mut |cpu, tracer| {
                    cpu.scan_traced(scan * 37_000, tracer);
                });
            }
            assert_eq!(events.len(), all.events.len());
            for (index, (event, expected)) in events.iter().zip(&all.events).enumerate() {
                assert_eq!(event, expected, "statement {index} on {}", engine_name);
            }
            assert!(cpu.machine() == through.machine(), "{}", engine_name);
            assert_eq!(cpu.diagnostic_buffer().entries().count(), through.diagnostic_buffer().entries().count());
        }
    }
}

#[test]
fn every_position_of_a_history_is_the_moment_of_the_whole_run() {
    for (cpu_type, modules) in [("315-2PN/DP", Modules::Copied), ("416-3", Modules::Copied), ("416-3", Modules::Recorded)] {
        let (all, through) = whole_run(EVERYTHING, cpu_type, 12, modules);
        let mut history = History::new(load(EVERYTHING, cpu_type, 0, modules), Plan::new(37_000, Some(12), Vec::new()));
        let halt = history.run(Until { statements: u64::MAX, scans: u64::MAX }, &mut Unwatched);
        assert_eq!(halt, Halt::NoMoreScans);
        assert_eq!(history.end(), all.events.len() as u64);
        assert!(history.cpu().machine() == through.machine());
        let count = all.events.len() as u64;
        let (mut at, mut paused) = (count, 0);
        // In leaps over the whole run, backwards and forwards.
        for leap in 0..120_u64 {
            at = (at + leap * 7919 + 1) % count + 1;
            assert_eq!(history.go_to(at), Halt::Reached);
            assert_eq!(history.position().statements, at);
            assert_eq!(history.last(), all.events.get(at as usize - 1), "after statement {at}");
            assert!(
                same(&history.around().expect("the machine around it").before, &all.machines[at as usize - 1]),
                "before statement {at}"
            );
            if history.cpu().is_paused() {
                assert!(same(history.cpu().machine(), &all.machines[at as usize]), "after statement {at}");
                paused += 1;
            }
        }
        assert!(paused > 80, "{paused} positions lay inside a scan");
        history.go_to(count);
        assert!(history.is_at_present() && history.cpu().machine() == through.machine());
    }
}
