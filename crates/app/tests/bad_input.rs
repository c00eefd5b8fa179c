//! Programs that do everything wrong: each has a defined end, the same on every engine, and the diagnostic buffer says why.

#[allow(dead_code)] // The pages need more of it.
mod program;

use std::sync::Arc;

use program::{ENGINES, compile, cpu};
use sieben_cpu::retain::Adoption;
use sieben_cpu::{Cpu, OperatingMode, Restart, Station};
use sieben_engine::Program;
use sieben_model::address::{Area, Operand};
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;

const CYCLE_US: u64 = 10_000;

fn compiled(text: &str, cpu_type: &'static CpuType) -> Arc<Program> {
    Arc::new(compile(text, Mnemonics::English, cpu_type).unwrap_or_else(|error| panic!("{error}\n{text}")).program)
}

/// The program on every engine, in RUN or where its startup led.
fn started(text: &str, cpu_type: &'static CpuType) -> Vec<Cpu> {
    let program = compiled(text, cpu_type);
    ENGINES
        .iter()
        .map(|(_, load)| {
            let mut cpu = cpu(&program, cpu_type, *load, None);
            cpu.restart(Restart::Warm);
            cpu
        })
        .collect()
}

fn operand(text: &str) -> Operand {
    Operand::parse(text).unwrap_or_else(|| panic!("`{text}` is an operand"))
}

fn value(cpu: &Cpu, text: &str) -> u32 {
    cpu.read(&operand(text)).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn set(cpu: &mut Cpu, text: &str, value: u32) {
    cpu.modify(&operand(text), value).unwrap_or_else(|error| panic!("{text}: {error}"));
}

/// What programs and others can see of two CPUs.
fn assert_same(first: &Cpu, other: &Cpu, what: &str) {
    assert_eq!(first.mode(), other.mode(), "{what}");
    let data = |cpu: &Cpu| {
        let memory = &cpu.machine().memory;
        let blocks: Vec<Vec<u8>> = memory
            .data_blocks
            .iter()
            .map(|entry| entry.map_or(Vec::new(), |entry| memory.arena[entry.base as usize..(entry.base + entry.length) as usize].to_vec()))
            .collect();
        (memory.area(Area::BitMemory).to_vec(), memory.area(Area::Input).to_vec(), memory.area(Area::Output).to_vec(), blocks)
    };
    assert!(data(first) == data(other), "{what}: the memory of the engines differs");
    assert_eq!(first.machine().timers, other.machine().timers, "{what}");
    assert_eq!(first.machine().counters, other.machine().counters, "{what}");
    assert_eq!(first.stop_cause(), other.stop_cause(), "{what}");
}

/// Blocks that note the event of an error in MW 20 and count it in MW 22.
const NOTE_ERRORS: &str = "ORGANIZATION_BLOCK OB 121\nBEGIN\nL LW 0; T MW 20; L MW 22; +1; T MW 22;\nEND_ORGANIZATION_BLOCK\n\
    ORGANIZATION_BLOCK OB 122\nBEGIN\nL LW 0; T MW 20; L MW 22; +1; T MW 22;\nEND_ORGANIZATION_BLOCK\n";
const BLOCKS: &str = "DATA_BLOCK DB 1\nSTRUCT\n a : ARRAY [1..10] OF BYTE;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n\
    FUNCTION FC 1 : VOID\nBEGIN\nL MW 26; +1; T MW 26;\nEND_FUNCTION\n";

/// Accesses through AR1 that the pointer in MD 100 decides; DB 1 is open as DB and DI.
const ACCESSES: &[&str] = &[
    "L B [AR1,P#0.0]; T MB 30",
    "L W [AR1,P#0.0]; T MW 30",
    "L D [AR1,P#4095.7]; T MD 30",
    "L 7; T B [AR1,P#0.0]",
    "L 7; T W [AR1,P#0.0]",
    "L 7; T D [AR1,P#0.0]",
    "A [AR1,P#0.0]; = M 30.0",
    "SET; = [AR1,P#0.1]",
    "SET; S [AR1,P#0.0]; R [AR1,P#0.0]",
    "SET; FP [AR1,P#0.0]",
];

fn around(statements: &str) -> String {
    format!(
        "{BLOCKS}{{errors}}ORGANIZATION_BLOCK OB 1\nBEGIN\nOPN DB 1; OPN DI 1; LAR1 MD 100; {statements}; L MW 24; +1; T MW 24;\nEND_ORGANIZATION_BLOCK\n"
    )
}

/// Every area code that means something and some that do not, each with offsets at and around every limit.
fn wild_pointers(cpu_type: &CpuType) -> Vec<u32> {
    let mut bytes = vec![0, 1, 9, 10, 11, 127, 128, 4095, 8191, 32_767, 65_535];
    for size in [cpu_type.bit_memory, cpu_type.process_image, cpu_type.peripheral, cpu_type.local_data] {
        bytes.extend([size.saturating_sub(4), size.saturating_sub(1), size]);
    }
    let areas = [0x00, 0x01, 0x7F, 0x80, 0x81, 0x82, 0x83, 0x84, 0x85, 0x86, 0x87, 0x88, 0xFF];
    let mut pointers = Vec::new();
    for area in areas {
        for byte in &bytes {
            for bit in [0, 7] {
                // Above bit 18 a pointer has bits that no address has.
                pointers.push(area << 24 | byte << 3 & 0x7_FFFF | bit);
                pointers.push(area << 24 | 0xF8_0000 | byte << 3 & 0x7_FFFF);
            }
        }
    }
    pointers
}

#[test]
fn a_wild_pointer_is_a_fault_or_an_access() {
    let cpu_type = &CpuType::ALL[0];
    let mut faults = 0;
    for statements in ACCESSES {
        let mut cpus = started(&around(statements).replace("{errors}", NOTE_ERRORS), cpu_type);
        for (scan, pointer) in wild_pointers(cpu_type).into_iter().enumerate() {
            let what = format!("{statements} with 16#{pointer:08X}");
            for cpu in &mut cpus {
                for (name, value) in [("MD 100", pointer), ("MW 20", 0), ("MW 22", 0), ("MW 24", 0)] {
                    set(cpu, name, value);
                }
                cpu.scan(scan as u64 * CYCLE_US);
                assert_eq!(cpu.mode(), OperatingMode::Run, "{what}");
            }
            let (first, others) = cpus.split_first().expect("there is an engine");
            others.iter().for_each(|other| assert_same(first, other, &what));
            let (event, count) = (value(first, "MW 20"), value(first, "MW 22"));
            // The access may have hit the words that count: then they hold what was written.
            if count > 0 && count < 8 {
                faults += 1;
                assert!(matches!(event, 0x2522..=0x2525 | 0x2528 | 0x2529 | 0x2942 | 0x2943), "{what}: event 16#{event:04X}");
            }
        }
    }
    assert!(faults > 1000, "{faults} faults");
}

#[test]
fn a_wild_pointer_without_its_error_block_ends_in_stop() {
    let cpu_type = &CpuType::ALL[0];
    for statements in ACCESSES {
        let program = compiled(&around(statements).replace("{errors}", ""), cpu_type);
        for (_, load) in ENGINES {
            let mut cpu = cpu(&program, cpu_type, *load, Some(0..64));
            cpu.restart(Restart::Warm);
            let image = cpu.retain_image().cloned().expect("the startup is whole");
            // An area that does not exist.
            set(&mut cpu, "MD 100", 0x8800_0000);
            assert_eq!(cpu.scan(0).mode, OperatingMode::Stop, "{statements}");
            let cause = cpu.stop_cause().expect("a STOP has a cause");
            assert_eq!(cause.event, 0x4562, "{statements}: {}", cause.text);
            assert!(matches!(cause.first_event, 0x2524 | 0x2525), "{statements}: {}", cause.text);
            assert!(cpu.diagnostic_buffer().text().contains("area error"), "{statements}");
            cpu.restore(&image, Adoption::SameProgram).unwrap_or_else(|refusal| panic!("{refusal}"));
            assert_eq!(cpu.restart(Restart::Warm), OperatingMode::Run);
        }
    }
}

/// An array index out of range in `iec`: 0 is read, nothing is written, and the buffer names index and block.
const INDEXES: &str = "FUNCTION Take : INT\nVAR_INPUT i : INT; END_VAR\nVAR a : ARRAY[1..3] OF INT := [7, 8, 9]; END_VAR\n\
    Take := a[i];\na[i] := 5;\nEND_FUNCTION\n\
    FUNCTION Sum : INT\nVAR_IN_OUT a : ARRAY[*] OF INT; END_VAR\nVAR i : DINT; END_VAR\n\
    FOR i := 1 TO 4 DO Sum := Sum + a[i]; END_FOR;\nEND_FUNCTION\n\
    PROGRAM Main\nVAR x AT %MW0 : INT; y AT %MW2 : INT; z AT %MW4 : INT; n : INT := 2; b : ARRAY[1..3] OF INT := [3(10)]; END_VAR\n\
    n := n + 1; x := Take(n); y := Take(-n); z := Sum(a := b);\nEND_PROGRAM\n";

#[test]
fn an_index_out_of_range_that_stops_nothing_is_in_the_diagnostic_buffer() {
    let cpu_type = &CpuType::ALL[0];
    let compiled = program::compile_sources(&[("indexes.st", INDEXES)], None, None, cpu_type).unwrap_or_else(|error| panic!("{error}"));
    let program = Arc::new(compiled.program);
    let cpus: Vec<Cpu> = ENGINES
        .iter()
        .map(|(engine, load)| {
            let mut cpu = cpu(&program, cpu_type, *load, None);
            cpu.restart(Restart::Warm);
            let before = cpu.diagnostic_buffer().text().matches("is outside its array").count();
            assert_eq!(before, 0, "{engine}");
            assert_eq!(cpu.scan(0).mode, OperatingMode::Run, "{engine}");
            assert_eq!([value(&cpu, "MW 0"), value(&cpu, "MW 2"), value(&cpu, "MW 4")], [9, 0, 30], "{engine}");
            let text = cpu.diagnostic_buffer().text();
            assert_eq!(text.matches("index -3 is outside its array").count(), 2, "{engine}: {text}");
            assert_eq!(text.matches("index 4 is outside its array").count(), 1, "{engine}: {text}");
            assert_eq!(text.matches("is outside its array").count(), 3, "{engine}: {text}");
            cpu
        })
        .collect();
    for other in &cpus[1..] {
        assert_same(&cpus[0], other, "indexes");
    }
}

#[test]
fn wild_numbers_of_blocks_timers_and_counters_are_faults() {
    let cpu_type = &CpuType::ALL[0];
    for statements in [
        "OPN DB [MW 100]",
        "OPN DI [MW 100]",
        "UC FC [MW 100]",
        "SET; CC FC [MW 100]",
        "UC FB [MW 100]",
        "SET; L S5T#1S; SE T [MW 100]",
        "L T [MW 100]; T MW 30",
        "SET; CU C [MW 100]",
        "A C [MW 100]; = M 30.0",
        "OPN DB [MW 100]; L DBW 8; T DBW 2",
    ] {
        let mut cpus = started(&around(statements).replace("{errors}", NOTE_ERRORS), cpu_type);
        for (scan, number) in [0, 1, 2, 7, 8, 255, 256, 7999, 8000, 15_999, 16_000, 16_001, 32_767, 32_768, 65_535].into_iter().enumerate()
        {
            let what = format!("{statements} with {number}");
            for cpu in &mut cpus {
                set(cpu, "MW 100", number);
                cpu.scan(scan as u64 * CYCLE_US);
                assert_eq!(cpu.mode(), OperatingMode::Run, "{what}");
                let event = value(cpu, "MW 20");
                assert!(
                    event == 0 || matches!(event, 0x2522..=0x2527 | 0x2532..=0x2535 | 0x253A | 0x253C | 0x253E),
                    "{what}: 16#{event:04X}"
                );
            }
            let (first, others) = cpus.split_first().expect("there is an engine");
            others.iter().for_each(|other| assert_same(first, other, &what));
        }
        assert!(value(&cpus[0], "MW 22") > 0, "{statements} never failed");
    }
}

/// Makes and deletes 100 data blocks of rising lengths in every scan, every third stays; in the next one those are deleted.
const STORM: &str = "ORGANIZATION_BLOCK OB 1\nBEGIN\n\
    L 100; n: T MW 50;\n\
    L MW 50; L 8; *I; T MW 52;\n\
    CALL SFC 22 (LOW_LIMIT := W#16#64, UP_LIMIT := W#16#8C, COUNT := MW 52, RET_VAL := MW 54, DB_NUMBER := MW 56);\n\
    L MW 54; L 0; ==I; JCN f; L MD 60; L L#1; +D; T MD 60;\n\
    OPN DB [MW 56]; L MW 50; T DBW 0; OPN DB [MW 80];\n\
    L MW 50; L 3; /I; SRD 16; L 0; ==I; JC k;\n\
    CALL SFC 23 (DB_NUMBER := MW 56, RET_VAL := MW 54);\n\
    k: NOP 0; f: L MW 50; LOOP n;\n\
    A M 70.0; JCN e; L 100; T MW 58; d: CALL SFC 23 (DB_NUMBER := MW 58, RET_VAL := MW 54); L MW 58; +1; T MW 58; L 140; <=I; JC d;\n\
    e: AN M 70.0; = M 70.0;\nEND_ORGANIZATION_BLOCK\n";

#[test]
fn a_storm_of_created_data_blocks_leaks_nothing() {
    let cpu_type = &CpuType::ALL[0];
    let mut cpus = started(STORM, cpu_type);
    let mut made = 0;
    let mut images = 0;
    for scan in 0..60 {
        for cpu in &mut cpus {
            cpu.scan(scan * CYCLE_US);
            let event = cpu.stop_cause().map(|cause| cause.text.clone());
            assert_eq!(cpu.mode(), OperatingMode::Run, "{event:?}");
            images += usize::from(cpu.retain_image().is_some_and(sieben_cpu::RetainImage::is_sound));
        }
        let (first, others) = cpus.split_first().expect("there is an engine");
        others.iter().for_each(|other| assert_same(first, other, "the storm"));
        let now = value(first, "MD 60");
        assert!(now > made, "data blocks can still be made in scan {scan}");
        made = now;
        assert!(first.machine().memory.data_blocks.len() <= 141);
    }
    assert!(images > 0 && made > 3_000, "{made} data blocks, {images} images");
}

#[test]
fn data_blocks_made_in_a_storm_outlive_a_power_failure() {
    let cpu_type = &CpuType::ALL[0];
    for cpu in &mut started(STORM, cpu_type) {
        cpu.scan(0);
        let image = cpu.retain_image().cloned().expect("the scan has changed something");
        let blocks = |cpu: &Cpu| cpu.machine().memory.data_blocks.iter().filter(|entry| entry.is_some()).count();
        let before = (blocks(cpu), value(cpu, "DB100.DBW 0"));
        assert!(before.0 > 20, "{before:?}");
        cpu.memory_reset();
        assert_eq!(blocks(cpu), 0);
        cpu.restore(&image, Adoption::SameProgram).unwrap_or_else(|refusal| panic!("{refusal}"));
        assert_eq!((blocks(cpu), value(cpu, "DB100.DBW 0")), before);
        cpu.restart(Restart::Warm);
        assert_eq!(cpu.scan(CYCLE_US).mode, OperatingMode::Run);
    }
}

#[test]
fn endless_recursion_and_endless_loops_stop_the_cpu_and_keep_its_data() {
    for (name, event) in [("315-2PN/DP", 0x4575), ("416-3", 0x4570)] {
        let cpu_type = CpuType::by_name(name).expect("a CPU type");
        let recursion = "FUNCTION FC 1 : VOID\nVAR_TEMP\n a : ARRAY [1..100] OF INT;\nEND_VAR\nBEGIN\nL MW 0; +1; T MW 0; UC FC 1;\nEND_FUNCTION\n\
            ORGANIZATION_BLOCK OB 1\nBEGIN\nUC FC 1;\nEND_ORGANIZATION_BLOCK\n";
        let endless = "ORGANIZATION_BLOCK OB 1\nBEGIN\nL MW 0; +1; T MW 0;\nx: NOP 0; JU x;\nEND_ORGANIZATION_BLOCK\n";
        for (text, event) in [(recursion, event), (endless, 0x4568)] {
            let mut cpus = started(text, cpu_type);
            for cpu in &mut cpus {
                assert_eq!(cpu.scan(0).mode, OperatingMode::Stop, "{text}");
                let cause = cpu.stop_cause().expect("a STOP has a cause");
                assert_eq!(cause.event, event, "{text}: {}", cause.text);
                let counted = value(cpu, "MW 0");
                assert!(counted > 0);
                assert!(cpu.retain_image().is_some_and(|image| image.scan == 1), "what led to the STOP is kept");
                cpu.restart(Restart::Warm);
                assert_eq!(value(cpu, "MW 0"), counted);
            }
            let (first, others) = cpus.split_first().expect("there is an engine");
            others.iter().for_each(|other| assert_same(first, other, text));
        }
    }
}
