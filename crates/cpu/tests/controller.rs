//! What the CPU does with what a program asks for.

mod outside;
mod script;

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;
use std::time::Duration;

use proptest::prelude::*;
use script::{Script, Step, cpu, cpu_of, cpu_type, operand, programming, read_error};
use sieben_cpu::{
    AccessError, Cpu, DiagnosticEntry, IoModule, OperatingMode, Rack, RackError, Restart, Settings, SimulatedModule, Station, TimeSource,
};
use sieben_engine::machine::Registers;
use sieben_engine::{Abort, Fault, Program};
use sieben_model::block::BlockId;
use sieben_model::program::DataBlock;

fn events(cpu: &Cpu) -> Vec<u16> {
    cpu.diagnostic_buffer().entries().map(DiagnosticEntry::event).collect()
}

fn value(cpu: &Cpu, text: &str) -> u32 {
    cpu.read(&operand(text)).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn abort(abort: Abort) -> Step {
    Step::Fault(Fault::Abort(abort))
}

#[test]
fn startup_runs_ob_100_and_then_the_cycle() {
    let mut cpu = cpu(&[(100, &[Step::Set("MB0", 1), Step::Set("QB0", 9)]), (1, &[Step::Copy("MB1", "IB0")])], Settings::default());
    assert_eq!(cpu.mode(), OperatingMode::Stop);
    assert!(!cpu.scan(0).executed, "in STOP only time passes");
    cpu.modify(&operand("I 0.2"), 1).unwrap();
    assert_eq!(cpu.restart(Restart::Warm), OperatingMode::Run);
    assert_eq!((value(&cpu, "MB0"), value(&cpu, "PQB0")), (1, 0), "outputs wait for the first cycle control point");
    let report = cpu.scan(10_000);
    assert!(report.executed && report.number == 1);
    assert_eq!((value(&cpu, "MB1"), value(&cpu, "PQB0")), (4, 9));
    assert_eq!(events(&cpu), [0x4302, 0x4301]);
    Cpu::stop(&mut cpu);
    assert_eq!(events(&cpu)[0], 0x4303);
}

/// One output byte.
#[derive(Debug, Default)]
struct Lamps(u8);

impl IoModule for Lamps {
    fn name(&self) -> &str {
        "lamps"
    }
    fn inputs(&self) -> Range<u32> {
        0..0
    }
    fn outputs(&self) -> Range<u32> {
        4..5
    }
    fn read(&self, _: u32, _: &mut [u8]) {}
    fn write(&mut self, _: u32, from: &[u8]) {
        self.0 = from[0];
    }
}

#[test]
fn modules_see_outputs_in_run_only() {
    let blocks: &[(u16, &[Step])] = &[(100, &[Step::Set("QB4", 9)]), (1, &[])];
    let cpu_type = cpu_type("315-2PN/DP");
    let rack = Rack::with_background(cpu_type, vec![Box::new(Lamps::default())]).unwrap();
    let mut cpu = Cpu::load(cpu_type, Arc::default(), |_, _| Arc::new(Script::new(blocks)), rack, Settings::default());
    let lamps = |cpu: &Cpu| cpu.rack().module::<Lamps>().unwrap().0;
    cpu.restart(Restart::Warm);
    assert_eq!((value(&cpu, "QB4"), lamps(&cpu)), (9, 0), "STARTUP holds the outputs");
    cpu.scan(10_000);
    assert_eq!(lamps(&cpu), 9);
    Cpu::stop(&mut cpu);
    assert_eq!(lamps(&cpu), 0, "STOP disables the outputs");
}

#[test]
fn ob_1_reads_its_start_information() {
    let steps: Vec<Step> = (0..20)
        .zip([
            "MB0", "MB1", "MB2", "MB3", "MB4", "MB5", "MB6", "MB7", "MB8", "MB9", "MB10", "MB11", "MB12", "MB13", "MB14", "MB15", "MB16",
            "MB17", "MB18", "MB19",
        ])
        .map(|(byte, to)| Step::StartInformation(byte, to))
        .collect();
    let mut cpu = cpu(&[(1, &steps)], Settings::default());
    cpu.restart(Restart::Warm);
    let mut see = |now: u64| {
        cpu.scan(now * 1000);
        cpu.machine().memory.area(sieben_model::address::Area::BitMemory)[..20].to_vec()
    };
    assert_eq!(see(0), [0x11, 0x01, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0x94, 1, 1, 0, 0, 0, 0, 7]);
    assert_eq!(see(10), [0x11, 0x03, 1, 1, 0, 0, 0, 10, 0, 10, 0, 10, 0x94, 1, 1, 0, 0, 0, 0x01, 7]);
    assert_eq!(see(310), [0x11, 0x03, 1, 1, 0, 0, 1, 44, 0, 10, 1, 44, 0x94, 1, 1, 0, 0, 0, 0x31, 7]);
    assert_eq!(see(315), [0x11, 0x03, 1, 1, 0, 0, 0, 5, 0, 5, 1, 44, 0x94, 1, 1, 0, 0, 0, 0x31, 0x57]);
    cpu.restart(Restart::Cold);
    cpu.scan(400_000);
    assert_eq!(value(&cpu, "MW0"), 0x1104);
}

#[test]
fn startup_blocks_read_why_the_cpu_stopped() {
    for (restart, number, low) in [(Restart::Warm, 100, 0x81), (Restart::Hot, 101, 0x83), (Restart::Cold, 102, 0x85)] {
        let steps = [Step::StartInformation(0, "MD0"), Step::StartInformation(6, "MW4")];
        let mut cpu = cpu_of("416-3", &[(number, &steps), (1, &[Step::Sfc(46)])], Settings::default());
        // The first start after loading is no hot one.
        assert_eq!(cpu.restart(Restart::Warm), OperatingMode::Run);
        cpu.restart(restart);
        assert_eq!(value(&cpu, "MD0"), 0x1300_1B00 | low << 16 | u32::from(number));
        cpu.scan(0);
        assert_eq!(cpu.stop_cause().unwrap().event, 0x457F);
        cpu.restart(restart);
        assert_eq!(value(&cpu, "MW4"), 0x457F);
    }
    let mut cpu = cpu(&[(100, &[Step::Set("MB0", 1)])], Settings::default());
    cpu.restart(Restart::Hot);
    assert_eq!(value(&cpu, "MB0"), 1, "an S7-300 has no hot restart and does a warm one");
}

/// A fault, the CPU type, which error OBs are loaded; then the STOP (0 = RUN), the first cause, the events on top of the buffer.
#[test]
fn faults_lead_to_their_organization_block_or_to_stop() {
    type Case<'a> = (&'a str, Step, &'a [u16], u16, u16, &'a [u16]);
    let cases: &[Case] = &[
        ("315-2PN/DP", programming(0x28), &[], 0x4562, 0x2528, &[0x4562, 0x2528]),
        ("315-2PN/DP", programming(0x28), &[122], 0x4562, 0x2528, &[0x4562, 0x2528]),
        ("315-2PN/DP", programming(0x28), &[121], 0, 0, &[0x2528]),
        ("315-2PN/DP", read_error(256), &[121], 0x4563, 0x2942, &[0x4563, 0x2942]),
        ("315-2PN/DP", read_error(256), &[122], 0, 0, &[0x2942]),
        ("315-2PN/DP", abort(Abort::NestingStack), &[88], 0x4571, 0x3571, &[0x4571, 0x3571]),
        ("315-2PN/DP", abort(Abort::McrStack), &[], 0x4572, 0x3572, &[0x4572, 0x3572]),
        ("315-2PN/DP", abort(Abort::BlockStack), &[], 0x4575, 0x3575, &[0x4575, 0x3575]),
        ("315-2PN/DP", abort(Abort::LocalData), &[], 0x4576, 0x3576, &[0x4576, 0x3576]),
        ("416-3", abort(Abort::BlockStack), &[], 0x4570, 0x3575, &[0x4570, 0x3575]),
        ("416-3", abort(Abort::BlockStack), &[88], 0, 0, &[0x3575]),
    ];
    for (name, step, loaded, stop, first, top) in cases {
        let program = [step.clone(), Step::Set("MB100", 1)];
        let mut blocks: Vec<(u16, &[Step])> = vec![(1, &program)];
        let handler = [Step::StartInformation(0, "MD0"), Step::StartInformation(4, "MD4"), Step::StartInformation(8, "MD8")];
        blocks.extend(loaded.iter().map(|&number| (number, &handler[..])));
        let mut cpu = cpu_of(name, &blocks, Settings::default());
        cpu.restart(Restart::Warm);
        cpu.scan(0);
        let title = format!("{name}, {step:?}, loaded {loaded:?}");
        assert_eq!(cpu.mode(), if *stop == 0 { OperatingMode::Run } else { OperatingMode::Stop }, "{title}");
        assert_eq!(&events(&cpu)[..top.len()], *top, "{title}");
        match cpu.stop_cause() {
            Some(cause) => {
                assert_eq!((cause.event, cause.first_event), (*stop, *first), "{title}");
                assert_eq!(cause.place.map(|place| (place.block, place.statement)), Some((BlockId::ob(1), 0)), "{title}");
                assert!(cause.text.contains("(OB 1, statement 1); STOP"), "{}", cause.text);
            }
            None => assert_eq!(value(&cpu, "MB100"), u32::from(loaded[0] != 88), "{title}: the program goes on behind the fault"),
        }
    }
}

#[test]
fn error_blocks_read_what_happened() {
    let handler = [Step::StartInformation(0, "MD0"), Step::StartInformation(4, "MD4"), Step::StartInformation(8, "MD8")];
    let see = |name: &str, step: Step| {
        let mut cpu = cpu_of(name, &[(1, &[Step::Count, step]), (121, &handler), (122, &handler), (88, &handler)], Settings::default());
        cpu.restart(Restart::Warm);
        cpu.scan(0);
        [value(&cpu, "MD0"), value(&cpu, "MD4"), value(&cpu, "MD8")]
    };
    assert_eq!(see("315-2PN/DP", programming(0x22)), [0x2522_0179, 0x8823_0007, 0x0001_0001]);
    assert_eq!(see("315-2PN/DP", read_error(256)), [0x2942_017A, 0x8820_0100, 0x0001_0001]);
    assert_eq!(see("416-3", abort(Abort::McrStack)), [0x3572_1C58, 0x8800_0101, 0x0001_0001]);
}

#[test]
fn a_fault_inside_an_error_block_stops_the_cpu() {
    for (name, stop, top) in
        [("315-2PN/DP", 0x4573, &[0x4573, 0x2942, 0x2521][..]), ("416-3", 0x4570, &[0x4570, 0x3573, 0x2942, 0x2521][..])]
    {
        let mut cpu = cpu_of(name, &[(1, &[programming(0x21)]), (121, &[read_error(0)]), (122, &[])], Settings::default());
        cpu.restart(Restart::Warm);
        cpu.scan(0);
        let cause = cpu.stop_cause().unwrap();
        assert_eq!((cause.event, cause.first_event, cause.place.unwrap().block), (stop, 0x2942, BlockId::ob(121)));
        assert_eq!(&events(&cpu)[..top.len()], top);
    }
}

#[test]
fn the_watchdog_counts_safe_points_in_virtual_time() {
    let settings = Settings { virtual_safe_points: 5000, ..Settings::default() };
    let run = |count: u64, loaded: &[(u16, &[Step])]| {
        let program = [Step::Loop(count)];
        let mut blocks: Vec<(u16, &[Step])> = vec![(1, &program)];
        blocks.extend_from_slice(loaded);
        let mut cpu = cpu(&blocks, settings.clone());
        cpu.restart(Restart::Warm);
        let report = cpu.scan(0);
        (report.mode, report.safe_points, cpu.stop_cause().map(|cause| (cause.event, cause.first_event)))
    };
    assert_eq!(run(5000, &[]), (OperatingMode::Run, 5000, None));
    assert_eq!(run(5001, &[]), (OperatingMode::Stop, 5001, Some((0x4568, 0x3501))));
    assert_eq!(run(10_000, &[(80, &[])]), (OperatingMode::Run, 10_000, None), "OB 80 lets the cycle take its time once");
    assert_eq!(run(10_002, &[(80, &[])]), (OperatingMode::Stop, 10_002, Some((0x4568, 0x3501))));
}

#[test]
fn re_trigr_starts_the_monitoring_again() {
    let settings = Settings { virtual_safe_points: 100, ..Settings::default() };
    let mut cpu = cpu(&[(1, &[Step::Loop(100), Step::Sfc(43), Step::Loop(100)])], settings);
    cpu.restart(Restart::Warm);
    assert_eq!(cpu.scan(0).mode, OperatingMode::Run);
}

#[test]
fn in_real_time_the_watchdog_is_the_clock() {
    for (limit_us, stops) in [(450, true), (50_000, false)] {
        let settings = Settings { time: TimeSource::Real, watchdog: Duration::from_micros(limit_us), ..Settings::default() };
        let mut cpu = cpu(&[(1, &[Step::Loop(10_000)])], settings);
        cpu.restart(Restart::Warm);
        let mut now = 0;
        let mut clock = || {
            now += 150;
            now
        };
        let report = cpu.scan_with(&mut clock, None);
        assert_eq!(report.mode == OperatingMode::Stop, stops);
        assert_eq!(report.execution_us, if stops { 750 } else { 1500 });
        assert_eq!(cpu.stop_cause().map(|cause| cause.event), stops.then_some(0x4568));
    }
}

#[test]
fn slow_loops_ask_the_clock_more_often_than_fast_ones() {
    let asked = |us: u64| {
        let settings = Settings { time: TimeSource::Real, watchdog: Duration::from_secs(60), ..Settings::default() };
        let mut cpu = cpu(&[(1, &[Step::Loop(50_000)])], settings);
        cpu.restart(Restart::Warm);
        let (mut now, mut asked) = (0, 0);
        let mut clock = || {
            asked += 1;
            now += us;
            now
        };
        assert_eq!(cpu.scan_with(&mut clock, None).mode, OperatingMode::Run);
        asked
    };
    assert!(asked(1) < 15, "budgets grow to 65,536: {}", asked(1));
    assert!((45..60).contains(&asked(100)), "budgets stay at 1,024: {}", asked(100));
    assert!((1400..1600).contains(&asked(1000)), "budgets shrink to 32: {}", asked(1000));
}

#[test]
fn nothing_hangs_in_virtual_time() {
    let settings = Settings { virtual_safe_points: 1000, ..Settings::default() };
    let mut cpu = cpu(&[(100, &[Step::Forever]), (1, &[])], settings);
    assert_eq!(cpu.restart(Restart::Warm), OperatingMode::Stop);
    assert_eq!(cpu.stop_cause().unwrap().event, 0x4555);
}

#[test]
fn a_request_is_seen_at_the_next_safe_point() {
    let settings = Settings { time: TimeSource::Real, watchdog: Duration::MAX, ..Settings::default() };
    let mut cpu = cpu(&[(1, &[Step::Forever])], settings);
    cpu.restart(Restart::Warm);
    let request = cpu.stop_request();
    let mut now = 0;
    let mut clock = || {
        now += 1;
        if now == 10 {
            request.stop();
        }
        now
    };
    assert_eq!(cpu.scan_with(&mut clock, None).mode, OperatingMode::Stop);
    assert_eq!(cpu.stop_cause().map(|cause| cause.event), Some(0x4303));
    let report = cpu.scan(20);
    assert!(!report.executed && report.safe_points == 0);
}

#[test]
fn hold_suspends_and_resume_goes_on() {
    let mut cpu = cpu(&[(1, &[Step::Count, Step::Loop(3), Step::Count])], Settings::default());
    cpu.restart(Restart::Warm);
    cpu.stop_request().hold();
    assert_eq!(cpu.scan(0).mode, OperatingMode::Hold);
    assert_eq!(cpu.registers().accu1, 1);
    assert!(!cpu.scan(10_000).executed);
    assert_eq!(cpu.machine().clock_us, 0, "no time passes for timers in HOLD");
    assert_eq!(cpu.resume(20_000).mode, OperatingMode::Run);
    assert_eq!(cpu.registers().accu1, 2);
    assert_eq!(events(&cpu)[..2], [0x4306, 0x4305]);
    assert!(!cpu.resume(20_000).executed, "there is nothing to resume in RUN");
}

#[test]
fn preset_registers_hold_for_one_scan() {
    let mut cpu = cpu(&[(1, &[Step::Count])], Settings::default());
    cpu.restart(Restart::Warm);
    cpu.preset_registers(Registers { accu1: 41, ..Registers::fresh() });
    cpu.scan(0);
    assert_eq!(cpu.registers().accu1, 42);
    cpu.scan(1);
    assert_eq!(cpu.registers().accu1, 1);
}

#[test]
fn direct_access_reads_and_writes_the_module() {
    let steps = [Step::Copy("MW0", "PIW256"), Step::Copy("MB4", "PIB0"), Step::Set("PQW2", 0x1234), Step::Copy("MW2", "QW2")];
    let mut cpu = cpu(&[(1, &steps)], Settings::default());
    cpu.restart(Restart::Warm);
    cpu.modify(&operand("PIW256"), 0xABCD).unwrap();
    cpu.modify(&operand("IB0"), 5).unwrap();
    cpu.scan(0);
    assert_eq!([value(&cpu, "MW0"), value(&cpu, "MB4"), value(&cpu, "MW2"), value(&cpu, "PQW2")], [0xABCD, 5, 0x1234, 0x1234]);
    cpu.modify(&operand("PQB2"), 0xFF).unwrap();
    cpu.scan(1);
    assert_eq!(value(&cpu, "PQW2"), 0x1234, "the program writes it again");
    cpu.modify(&operand("PQB8"), 0x55).unwrap();
    cpu.scan(2);
    assert_eq!([value(&cpu, "PQB8"), value(&cpu, "QB8")], [0x55, 0x55], "a modified peripheral output survives the cycle control point");
}

#[test]
fn an_address_without_a_module_is_an_access_error() {
    let cpu_type = cpu_type("315-2PN/DP");
    let rack = Rack::with_only(cpu_type, vec![Box::new(SimulatedModule::new("inputs", 0..4))]).unwrap();
    let steps = [Step::Copy("MW0", "PIW2"), Step::Copy("MW2", "PIW4"), Step::Set("PQB4", 1)];
    let script = Script::new(&[(1, &steps), (122, &[Step::StartInformation(0, "MW8")])]);
    let mut cpu = Cpu::load(cpu_type, Arc::new(Program::default()), |_, _| Arc::new(script), rack, Settings::default());
    cpu.restart(Restart::Warm);
    assert_eq!(cpu.modify(&operand("PIW4"), 1), Err(AccessError::NoModule));
    assert_eq!(cpu.read(&operand("PQD2")), Err(AccessError::NoModule));
    cpu.scan(0);
    assert_eq!(cpu.mode(), OperatingMode::Run);
    assert_eq!(events(&cpu)[..2], [0x2943, 0x2942]);
    assert_eq!(value(&cpu, "MW8"), 0x2943);
    cpu.modify(&operand("I 8.0"), 1).unwrap();
    assert_eq!(value(&cpu, "I 8.0"), 0);
    cpu.scan(1);
    assert_eq!(value(&cpu, "I 8.0"), 1, "an input without a simulated module is modified in the process image");
}

#[test]
fn modules_may_not_overlap_or_reach_beyond_the_area() {
    let cpu_type = cpu_type("315-2PN/DP");
    let module = |name: &str, range| Box::new(SimulatedModule::new(name, range)) as _;
    let error = Rack::with_only(cpu_type, vec![module("a", 0..4), module("b", 3..5)]).unwrap_err();
    assert_eq!(error, RackError::Overlap { first: "a".into(), second: "b".into(), input: true, byte: 3 });
    assert_eq!((error.problem().code(), error.to_string().contains("`PIB 3`")), ("P8002", true));
    let error = Rack::with_background(cpu_type, vec![module("c", 2047..2049)]).unwrap_err();
    assert_eq!((error.problem().code(), error), ("P8003", RackError::Beyond { module: "c".into(), end: 2049, limit: 2048 }));
    let rack = Rack::with_background(cpu_type, vec![module("a", 0..4), module("b", 4..5)]).unwrap();
    assert_eq!(rack.modules().map(|module| module.name().to_owned()).collect::<Vec<_>>(), ["simulated", "a", "b"]);
}

fn with_data() -> Cpu {
    let block = |number, non_retain, unlinked, read_only| DataBlock {
        number,
        based_on: None,
        structure: Arc::default(),
        image: vec![number as u8; 4],
        read_only,
        non_retain,
        unlinked,
    };
    let data = BTreeMap::from([
        (1, block(1, false, false, false)),
        (2, block(2, true, false, false)),
        (3, block(3, false, true, false)),
        (4, block(4, false, false, true)),
    ]);
    let program = Arc::new(Program { data, ..Program::default() });
    let cpu_type = cpu_type("315-2PN/DP");
    Cpu::load(cpu_type, program, |_, _| Arc::new(Script::new(&[(1, &[])])), Rack::simulated(cpu_type), Settings::default())
}

#[test]
fn a_restart_clears_what_it_should() {
    for (restart, expected) in [(Restart::Warm, [0, 0, 0, 9, 0x0202]), (Restart::Cold, [0, 0, 0, 0x0101, 0x0202])] {
        let mut cpu = with_data();
        cpu.restart(Restart::Warm);
        let operands = ["MW16", "C 8", "QW4", "DB1.DBW0", "DB2.DBW2"].map(operand);
        for operand in &operands {
            cpu.modify(operand, 9).unwrap();
            assert_eq!(cpu.read(operand), Ok(9));
        }
        cpu.restart(restart);
        assert_eq!(operands.map(|operand| cpu.read(&operand).unwrap()), expected, "{restart:?}");
    }
}

#[test]
fn a_station_says_why_there_is_no_value() {
    let mut cpu = with_data();
    let cases = [
        ("MB2048", AccessError::Outside),
        ("MD2045", AccessError::Outside),
        ("I 5000.0", AccessError::Outside),
        ("T 256", AccessError::Outside),
        ("C 9999", AccessError::Outside),
        ("DB1.DBW3", AccessError::Outside),
        ("DB3.DBW0", AccessError::NotLoaded),
        ("DB9.DBW0", AccessError::NotLoaded),
        ("LW0", AccessError::NotAccessible),
        ("FC 1", AccessError::NotAccessible),
        ("PIW5000", AccessError::NoModule),
    ];
    for (text, error) in cases {
        assert_eq!(cpu.read(&operand(text)), Err(error), "{text}");
        let error = if text == "PIW5000" { AccessError::Outside } else { error };
        assert_eq!(cpu.modify(&operand(text), 1), Err(error), "{text}");
    }
    assert_eq!(cpu.modify(&operand("C 1"), 1000), Err(AccessError::Value));
    assert_eq!(cpu.modify(&operand("T 1"), 0x00A0), Err(AccessError::Value));
    assert_eq!(cpu.modify(&operand("T 1"), 0x2123), Ok(()));
    assert_eq!(cpu.timer(1).map(|timer| (timer.value, timer.base, timer.status)), Some((123, 2, false)));
    assert!(cpu.machine().memory.data_block(4).unwrap().read_only);
}

#[test]
fn timers_stand_still_in_stop() {
    let mut cpu = cpu(&[(1, &[])], Settings::default());
    cpu.restart(Restart::Warm);
    cpu.scan(10_000);
    Cpu::stop(&mut cpu);
    cpu.scan(500_000);
    assert_eq!(cpu.machine().clock_us, 10_000);
    cpu.restart(Restart::Warm);
    cpu.scan(510_000);
    assert_eq!(cpu.machine().clock_us, 20_000);
}

#[test]
fn clock_memory_changes_at_the_cycle_control_point() {
    let mut cpu = cpu(&[(1, &[])], Settings { clock_memory_byte: Some(100), ..Settings::default() });
    cpu.restart(Restart::Warm);
    let seen: Vec<u32> = (0..6).map(|scan| (cpu.scan(scan * 50_000), value(&cpu, "MB100")).1).collect();
    assert_eq!(seen, [0, 1, 2, 3, 4, 0b1101]);
}

#[test]
fn the_diagnostic_buffer_has_a_bound_and_reads_well() {
    let mut cpu = cpu(&[(1, &[Step::Count, Step::Count, programming(0x22)]), (121, &[])], Settings::default());
    cpu.restart(Restart::Warm);
    for scan in 0..1000 {
        cpu.scan(scan * 10_000);
    }
    assert_eq!(cpu.diagnostic_buffer().entries().len(), 100);
    let newest = cpu.diagnostic_buffer().newest().unwrap();
    assert_eq!(newest.text(), "area length error when reading: bit memory word at byte 7 (OB 1, statement 3)");
    assert_eq!(newest.bytes()[..12], [0x25, 0x22, 1, 121, 0x88, 0x23, 0, 7, 0, 1, 0, 2]);
    assert!(cpu.diagnostic_buffer().text().starts_with("1994-01-01 00:00:09.990  16#2522  area length error"));
}

#[test]
fn every_system_block_has_an_interface() {
    let blocks = sieben_cpu::system::numbered();
    let numbers: Vec<_> = blocks.iter().map(|block| block.block).collect();
    assert!(numbers.is_sorted_by(|a, b| a < b), "by number, functions first: {numbers:?}");
    for block in &blocks {
        let function = block.block.kind == sieben_model::block::BlockKind::SystemFunction;
        let without = ["RE_TRIGR", "STP", "WAIT"].contains(&block.name);
        assert_eq!(block.interface.variable("RET_VAL").is_some(), function && !without, "{}", block.name);
        assert_eq!(block.interface.instance_size > 0, !function, "{}", block.name);
    }
}

#[derive(Clone, Debug)]
enum Action {
    Scan(u64),
    Resume(u64),
    Stop,
    RequestStop,
    RequestHold,
    Restart(Restart),
    Modify(&'static str, u32),
}

fn action() -> impl Strategy<Value = Action> {
    let operands =
        ["I 0.0", "IB3000", "IW2047", "QW0", "MD0", "PIW256", "PQW8", "PQD2046", "T 1", "C 1", "DB1.DBD0", "DB1.DBX3.7", "L 0.0", "OB 1"];
    prop_oneof![
        4 => prop_oneof![0..1_000_000u64, any::<u64>()].prop_map(Action::Scan),
        1 => any::<u64>().prop_map(Action::Resume),
        1 => Just(Action::Stop),
        1 => Just(Action::RequestStop),
        1 => Just(Action::RequestHold),
        2 => prop::sample::select(vec![Restart::Warm, Restart::Hot, Restart::Cold]).prop_map(Action::Restart),
        3 => (prop::sample::select(operands.to_vec()), any::<u32>()).prop_map(|(operand, value)| Action::Modify(operand, value)),
    ]
}

fn step() -> impl Strategy<Value = Step> {
    prop_oneof![
        Just(Step::Set("QB0", 3)),
        Just(Step::Copy("MB0", "PIB2047")),
        Just(Step::Copy("MD0", "PID2046")),
        Just(Step::Set("PQW100", 3)),
        Just(programming(0x22)),
        Just(read_error(u32::MAX)),
        Just(abort(Abort::LocalData)),
        (0..5000u64).prop_map(Step::Loop),
        Just(Step::Forever),
        Just(Step::Sfc(43)),
        Just(Step::Sfc(46)),
        Just(Step::Sfc(999)),
    ]
}

proptest! {
    #[test]
    fn no_sequence_of_actions_panics(
        s7_400 in any::<bool>(),
        real in any::<bool>(),
        blocks in prop::collection::btree_map(
            prop::sample::select(vec![1u16, 80, 88, 100, 101, 102, 121, 122]),
            prop::collection::vec(step(), 0..4),
            0..8,
        ),
        actions in prop::collection::vec(action(), 0..30),
    ) {
        let time = if real { TimeSource::Real } else { TimeSource::Virtual };
        let settings = Settings { virtual_safe_points: 2000, time, clock_memory_byte: Some(2047), ..Settings::default() };
        let blocks: Vec<(u16, &[Step])> = blocks.iter().map(|(&number, steps)| (number, &steps[..])).collect();
        let mut cpu = cpu_of(if s7_400 { "416-3" } else { "315-2PN/DP" }, &blocks, settings);
        for action in actions {
            // Real clocks go on: that is what ends a loop in real time. STARTUP has no cycle time, so it is asked to stop.
            let request = cpu.stop_request();
            let mut asked = 0u64;
            let mut clock = |start: u64| {
                asked += 1;
                if asked > 1000 {
                    request.stop();
                }
                start.saturating_add(asked * 1000)
            };
            match action {
                Action::Scan(now) => { cpu.scan_with(&mut || clock(now), None); }
                Action::Resume(now) => { cpu.resume_with(&mut || clock(now), None); }
                Action::Stop => Station::stop(&mut cpu),
                Action::RequestStop => cpu.stop_request().stop(),
                Action::RequestHold => cpu.stop_request().hold(),
                Action::Restart(restart) => { cpu.restart_with(restart, &mut || clock(0), None); }
                Action::Modify(text, value) => { let _ = cpu.modify(&operand(text), value); }
            }
            prop_assert_eq!(cpu.mode() == OperatingMode::Stop, cpu.machine().frames.is_empty() && cpu.mode() != OperatingMode::Run);
            let _ = cpu.diagnostic_buffer().text();
        }
    }
}
