//! Interrupts in whole programs: what pages cannot show, on every engine.

#[allow(dead_code)] // The pages need more of it.
mod program;

use std::sync::Arc;

use program::{ENGINES, compile, cpu};
use sieben_cpu::{Cpu, DateAndTime, DiagnosticEntry, Interrupt, OperatingMode, Restart, Station};
use sieben_model::address::Operand;
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;

/// A CPU of the type with the program, once for each engine, in RUN.
fn each(cpu_type: &str, text: &str, mut test: impl FnMut(&str, Cpu)) {
    let cpu_type = CpuType::by_name(cpu_type).expect("a CPU type");
    let compiled = compile(text, Mnemonics::English, cpu_type).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let program = Arc::new(compiled.program);
    for &(engine, load) in ENGINES {
        let mut cpu = cpu(&program, cpu_type, load, None);
        assert_eq!(cpu.restart(Restart::Warm), OperatingMode::Run, "{engine}");
        test(engine, cpu);
    }
}

fn value(cpu: &Cpu, text: &str) -> u32 {
    cpu.read(&Operand::parse(text).expect("an operand")).expect("a value")
}

/// OB 1, OB 40 and OB 41 make a data block each, fill it, look at it again behind many safe points and delete it.
/// MW 0 counts rounds, MW 2 creations that failed, MW 4 contents of others, MW 6 deletions that failed.
fn making_and_deleting(last: u16) -> String {
    format!(
        "FUNCTION FC 1 : VOID
VAR_INPUT
 mark : INT;
END_VAR
VAR_TEMP
 ret : INT;
 number : WORD;
 turns : INT;
END_VAR
BEGIN
L MW 0; + 1; T MW 0;
CALL SFC 22 (LOW_LIMIT := 100, UP_LIMIT := {last}, COUNT := 20, RET_VAL := #ret, DB_NUMBER := #number);
L #ret; L 0; ==I; JC made;
L MW 2; + 1; T MW 2; BEU;
made: OPN DB [#number];
L #mark; T DBW 0; T DBW 18;
L 10;
next: T #turns; L #turns; LOOP next;
L DBW 0; L #mark; <>I; JC bad;
L DBW 18; L #mark; ==I; JC good;
bad: L MW 4; + 1; T MW 4;
good: L 0; T #turns; OPN DB [#turns];
CALL SFC 23 (DB_NUMBER := #number, RET_VAL := #ret);
L #ret; L 0; ==I; BEC;
L MW 6; + 1; T MW 6;
END_FUNCTION
ORGANIZATION_BLOCK OB 40
BEGIN
CALL FC 1 (mark := 40);
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 41
BEGIN
CALL FC 1 (mark := 41);
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
L 60;
next: T MW 10;
CALL FC 1 (mark := 1);
L MW 10; LOOP next;
CALL SFC 24 (DB_NUMBER := 100, RET_VAL := MW 12, DB_LENGTH := MW 14, WRITE_PROT := M 16.0);
END_ORGANIZATION_BLOCK
"
    )
}

#[test]
fn data_blocks_made_in_interrupts_belong_to_who_made_them() {
    // With one number for three classes an interrupt inside another class finds none free; with enough of them nothing ever fails.
    for (last, always_room) in [(110, true), (100, false)] {
        for distance in [23, 40, 57] {
            each("416-3", &making_and_deleting(last), |engine, mut cpu| {
                let case = format!("{engine}, DB 100 to {last}, every {distance} safe points");
                for index in 0..200 {
                    let number = if index % 2 == 0 { 40 } else { 41 };
                    cpu.raise_at_safe_point(5 + index * distance, Interrupt::usual(number).expect("an interrupt"));
                }
                cpu.scan(0);
                assert_eq!(cpu.mode(), OperatingMode::Run, "{case}: {:?}", Cpu::stop_cause(&cpu));
                let [rounds, refused, mixed, kept] = ["MW0", "MW2", "MW4", "MW6"].map(|word| value(&cpu, word));
                assert!(rounds > 65, "{case}: {rounds} rounds");
                assert_eq!((mixed, kept), (0, 0), "{case}");
                assert_eq!(refused == 0, always_room, "{case}: {refused} refused");
                assert_eq!(value(&cpu, "MW12"), 0x80B1, "{case}: the last one is deleted");
            });
        }
    }
}

#[test]
fn a_time_of_day_that_passes_in_hold_is_a_time_error() {
    let text = "ORGANIZATION_BLOCK OB 100
VAR_TEMP
 info : ARRAY [0..19] OF BYTE;
 ret : INT;
 first : DATE_AND_TIME;
END_VAR
BEGIN
CALL SFC 1 (RET_VAL := #ret, CDT := #first);
CALL SFC 28 (OB_NR := 10, SDT := #first, PERIOD := W#16#0201, RET_VAL := MW 20);
CALL SFC 30 (OB_NR := 10, RET_VAL := MW 22);
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 10
BEGIN
L MW 0; + 1; T MW 0;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 80
BEGIN
L MW 2; + 1; T MW 2; L LW 0; T MW 4; L LW 6; T MW 6;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
L MW 8; + 1; T MW 8;
END_ORGANIZATION_BLOCK
";
    each("315-2PN/DP", text, |engine, mut cpu| {
        let second = 1_000_000;
        cpu.scan(0);
        cpu.scan(61 * second);
        assert_eq!((value(&cpu, "MW20"), value(&cpu, "MW22"), value(&cpu, "MW2")), (0, 0, 0), "{engine}");
        let before = value(&cpu, "MW0");
        assert!(before >= 1, "{engine}: OB 10 has come");
        cpu.stop_request().hold();
        cpu.scan(62 * second);
        assert_eq!(cpu.mode(), OperatingMode::Hold, "{engine}");
        cpu.resume(400 * second);
        cpu.scan(401 * second);
        assert_eq!(cpu.mode(), OperatingMode::Run, "{engine}: {:?}", Cpu::stop_cause(&cpu));
        // Five times passed in HOLD: one error for all of them, with the bit of OB 10, and none comes late.
        assert_eq!([value(&cpu, "MW2"), value(&cpu, "MW4"), value(&cpu, "MW6")], [1, 0x3506, 1], "{engine}");
        assert_eq!(value(&cpu, "MW0"), before, "{engine}");
        assert!(cpu.diagnostic_buffer().entries().map(DiagnosticEntry::event).any(|event| event == 0x3506), "{engine}");
        cpu.scan(430 * second);
        assert_eq!(value(&cpu, "MW0"), before + 1, "{engine}: the next time comes again");
    });
}

#[test]
fn a_time_of_day_that_passes_in_hold_stops_a_cpu_without_ob_80() {
    let text = "ORGANIZATION_BLOCK OB 10
BEGIN
L MW 0; + 1; T MW 0;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 1
VAR_TEMP
 info : ARRAY [0..19] OF BYTE;
 ret : INT;
 first : DATE_AND_TIME;
END_VAR
BEGIN
A M 9.0; JC on;
CALL SFC 1 (RET_VAL := #ret, CDT := #first);
CALL SFC 28 (OB_NR := 10, SDT := #first, PERIOD := W#16#0201, RET_VAL := MW 20);
CALL SFC 30 (OB_NR := 10, RET_VAL := MW 22);
SET; = M 9.0;
on: NOP 0;
END_ORGANIZATION_BLOCK
";
    each("315-2PN/DP", text, |engine, mut cpu| {
        cpu.scan(1_000_000);
        cpu.stop_request().hold();
        cpu.scan(2_000_000);
        cpu.resume(200_000_000);
        cpu.scan(200_010_000);
        let cause = Cpu::stop_cause(&cpu).unwrap_or_else(|| panic!("{engine}: a STOP"));
        assert_eq!((cause.event, cause.first_event), (0x4568, 0x3506), "{engine}");
    });
}

/// OB 100 activates OB 10 for each hour, OB 10 counts in MW 0, OB 80 keeps the event of its start.
const HOURLY: &str = "ORGANIZATION_BLOCK OB 100
VAR_TEMP info : ARRAY [0..19] OF BYTE; ret : INT; at : DATE_AND_TIME; END_VAR
BEGIN
L B#16#94; T LB 22; L B#16#1; T LB 23; T LB 24; T LB 25; L 0; T LB 26; T LB 27; T LB 28; T LB 29;
CALL SFC 28 (OB_NR := 10, SDT := #at, PERIOD := W#16#401, RET_VAL := MW 10);
CALL SFC 30 (OB_NR := 10, RET_VAL := MW 12);
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 10
VAR_TEMP info : ARRAY [0..19] OF BYTE; END_VAR
BEGIN
L MW 0; INC 1; T MW 0;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 80
VAR_TEMP info : ARRAY [0..19] OF BYTE; END_VAR
BEGIN
L LW 0; T MW 2; L MW 4; INC 1; T MW 4;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 1
VAR_TEMP info : ARRAY [0..19] OF BYTE; at : DATE_AND_TIME; ret : INT; END_VAR
BEGIN
A I 0.0; R I 0.0; JCN done;
L B#16#94; T LB 20; L B#16#1; T LB 21; T LB 22; L B#16#5; T LB 23; L B#16#30; T LB 24; L 0; T LB 25; T LB 26; T LB 27;
CALL SFC 0 (PDT := #at, RET_VAL := MW 14);
done: NOP 0;
END_ORGANIZATION_BLOCK
";

#[test]
fn setting_the_clock_from_outside_is_what_sfc_0_does() {
    let later = |minutes: u64| DateAndTime::DEFAULT.plus_us(minutes * 60_000_000);
    for cpu_type in ["315-2PN/DP", "416-3"] {
        let mut results = Vec::new();
        each(cpu_type, HOURLY, |engine, mut cpu| {
            cpu.scan(10_000);
            assert_eq!([10, 12].map(|byte| value(&cpu, &format!("MW {byte}"))), [0, 0], "{engine}: OB 10 is active");
            if results.is_empty() {
                cpu.modify(&Operand::parse("I 0.0").expect("an operand"), 1).expect("an input");
                cpu.scan(20_000);
                assert_eq!(value(&cpu, "MW 14"), 0, "{engine}");
            } else {
                cpu.scan(20_000);
                cpu.set_clock(later(330)).expect("a time");
            }
            cpu.scan(30_000);
            let events: Vec<u16> = cpu.diagnostic_buffer().entries().map(DiagnosticEntry::event).collect();
            results.push((engine.to_owned(), [0, 2, 4].map(|byte| value(&cpu, &format!("MW {byte}"))), events));
        });
        for (engine, memory, events) in &results {
            assert_eq!(memory, &[0, 0x3505, 1], "{cpu_type}, {engine}: what came meanwhile was skipped");
            assert_eq!(events[0], 0x3505, "{cpu_type}, {engine}");
            assert_eq!(events, &results[0].2, "{cpu_type}, {engine}");
        }
    }
}

#[test]
fn status_lists_from_outside_are_those_of_sfc_51() {
    let ask = "ORGANIZATION_BLOCK OB 1
VAR_TEMP info : ARRAY [0..19] OF BYTE; header : STRUCT LENTHDR : WORD; N_DR : WORD; END_STRUCT; END_VAR
BEGIN
CALL SFC 51 (REQ := TRUE, SZL_ID := MW 20, INDEX := MW 22, RET_VAL := MW 24, BUSY := M 0.0, SZL_HEADER := #header, DR := P#DB1.DBX0.0 BYTE 8000);
L #header.LENTHDR; T MW 26; L #header.N_DR; T MW 28;
END_ORGANIZATION_BLOCK
DATA_BLOCK DB 1
STRUCT bytes : ARRAY [1..8000] OF BYTE; END_STRUCT;
BEGIN
END_DATA_BLOCK
";
    each("315-2PN/DP", ask, |engine, mut cpu| {
        let ids: Vec<u16> =
            (cpu.status_list(0, 0).expect("all lists").records.iter()).map(|id| u16::from_be_bytes([id[0], id[1]])).collect();
        assert!(ids.len() > 40, "{engine}");
        for (scan, (id, index)) in ids.into_iter().flat_map(|id| [0, 1, 4, 6].map(|index| (id, index))).enumerate() {
            for (byte, word) in [(20, id), (22, index)] {
                cpu.modify(&Operand::parse(&format!("MW {byte}")).expect("an operand"), u32::from(word)).expect("bit memory");
            }
            cpu.scan(scan as u64);
            let place = format!("{engine}, list 16#{id:04X}, index {index}");
            match cpu.status_list(id, index) {
                Ok(list) => {
                    assert_eq!(value(&cpu, "MW 24"), 0, "{place}");
                    assert_eq!(value(&cpu, "MW 26"), u32::from(list.record_bytes), "{place}");
                    assert_eq!(value(&cpu, "MW 28"), u32::from(list.count), "{place}");
                    let bytes = list.records.concat();
                    let entry = cpu.machine().memory.data_block(1).expect("DB 1");
                    let read = &cpu.machine().memory.arena[entry.base as usize..][..bytes.len()];
                    assert!(read == bytes, "{place}: {read:02X?} is not {bytes:02X?}");
                }
                Err(_) => assert!(value(&cpu, "MW 24") > 0x8000, "{place}"),
            }
        }
    });
}
