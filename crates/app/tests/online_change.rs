//! Online change: another program takes over between two scans, on every engine, and data stays where it can.

#[allow(dead_code)] // The pages need more of it.
mod program;

use std::sync::Arc;

use program::{ENGINES, Load, compile, cpu};
use sieben_cpu::online_change::LossReason;
use sieben_cpu::retain::Adoption;
use sieben_cpu::{ChangeRefused, Cpu, DateAndTime, Loaded, OnlineChange, OperatingMode, ReplaceRefused, Restart, Station};
use sieben_engine::Program;
use sieben_model::address::{Area, Operand, Width};
use sieben_model::block::{BlockId, BlockLanguage};
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::program::DataBlock;

fn cpu_type() -> &'static CpuType {
    CpuType::by_name("416-3").expect("a CPU type")
}

fn built(text: &str) -> Arc<Program> {
    Arc::new(compile(text, Mnemonics::English, cpu_type()).expect("the program compiles").program)
}

/// A CPU in RUN that has made so many scans, 10 ms apart.
fn running(text: &str, load: Load, scans: u64) -> Cpu {
    let mut cpu = cpu(&built(text), cpu_type(), load, None);
    cpu.restart(Restart::Warm);
    (0..scans).for_each(|scan| run(&mut cpu, scan));
    cpu
}

fn run(cpu: &mut Cpu, scan: u64) {
    cpu.scan(scan * 10_000);
    assert_eq!(cpu.mode(), OperatingMode::Run, "{:?}", cpu.stop_cause());
}

fn change(cpu: &mut Cpu, text: &str, load: Load) -> OnlineChange {
    let loaded = Loaded::new(cpu_type(), built(text), load);
    let planned = cpu.plan_change(&loaded);
    let done = cpu.change_online(loaded).expect("between two scans");
    assert_eq!(planned, done, "what is listed before is what happens");
    done
}

fn word(cpu: &Cpu, operand: &Operand) -> u32 {
    cpu.read(operand).unwrap_or_else(|error| panic!("{operand:?}: {error:?}"))
}

fn mw(byte: u32) -> Operand {
    Operand::Address(address(Area::BitMemory, Width::Word, byte))
}

fn dbw(db: u16, byte: u32) -> Operand {
    Operand::InDataBlock { db, address: address(Area::SharedData, Width::Word, byte) }
}

fn address(area: Area, width: Width, byte: u32) -> sieben_model::address::Address {
    sieben_model::address::Address { area, width, byte, bit: 0 }
}

fn losses(change: &OnlineChange) -> Vec<String> {
    change.losses.iter().map(ToString::to_string).collect()
}

fn blocks(change: &OnlineChange) -> Vec<String> {
    change.blocks.iter().map(|(id, what)| format!("{id} {}", what.word())).collect()
}

/// Wraps statements into OB 1.
fn ob1(statements: &str) -> String {
    format!("ORGANIZATION_BLOCK OB 1\nVAR_TEMP info : ARRAY [0..19] OF BYTE; END_VAR\nBEGIN\n{statements}\nEND_ORGANIZATION_BLOCK\n")
}

#[test]
fn a_changed_block_takes_over_and_edges_timers_and_counters_run_on() {
    let before = "AN M 9.0; = M 9.0; L S5T#500MS; SE T 1; A M 8.0; FP M 8.1; CU C 1; L MW 20; INC 1; T MW 20; T QW 4;";
    let after = "A M 8.0; FP M 8.1; CU C 1; L MW 20; L 100; +I; T MW 20; A T 1; = M 30.0;";
    for &(engine, load) in ENGINES {
        let mut cpu = running(&ob1(before), load, 1);
        cpu.modify(&Operand::Address(sieben_model::address::Address { bit: 0, ..address(Area::BitMemory, Width::Bit, 8) }), 1)
            .expect("M 8.0");
        (1..11).for_each(|scan| run(&mut cpu, scan));
        let timer = cpu.timer(1).expect("T 1");
        assert!(timer.running, "{engine}");
        assert_eq!((word(&cpu, &mw(20)), word(&cpu, &Operand::Counter(1))), (11, 1), "{engine}");
        let done = change(&mut cpu, &ob1(after), load);
        assert_eq!(blocks(&done), ["OB 1 changed"]);
        assert_eq!(losses(&done), [""; 0]);
        assert_eq!(cpu.mode(), OperatingMode::Run);
        assert_eq!(cpu.timer(1), Some(timer), "{engine}: the time goes on");
        run(&mut cpu, 11);
        // The edge was seen by the old program: no second one.
        assert_eq!((word(&cpu, &mw(20)), word(&cpu, &Operand::Counter(1))), (111, 1), "{engine}");
        let outputs = Operand::Address(address(Area::Output, Width::Word, 4));
        assert_eq!(word(&cpu, &outputs), 11, "{engine}: outputs that nobody writes keep their values");
        (12..65).for_each(|scan| run(&mut cpu, scan));
        assert!(!cpu.timer(1).expect("T 1").running, "{engine}: the time has run out");
    }
}

const OLD_DATA: &str = "
TYPE UDT 1
STRUCT speed : INT := 5; gone : WORD; on : BOOL; END_STRUCT;
END_TYPE
DATA_BLOCK DB 1
STRUCT
 a : INT; flag1 : BOOL; flag2 : BOOL; motor : UDT 1; list : ARRAY [1..4] OF INT; bits : ARRAY [0..11] OF BOOL;
 name : STRING [6]; kind : INT; rows : ARRAY [0..1, 1..3] OF UDT 1;
END_STRUCT;
BEGIN
END_DATA_BLOCK
";

const NEW_DATA: &str = "
TYPE UDT 1
STRUCT on : BOOL; extra : INT := 77; speed : INT := 9; END_STRUCT;
END_TYPE
DATA_BLOCK DB 1
STRUCT
 first : DINT := L#42; flag2 : BOOL; motor : UDT 1; list : ARRAY [2..9] OF INT; bits : ARRAY [0..15] OF BOOL;
 A : INT; name : STRING [6]; kind : REAL := 1.5; rows : ARRAY [0..1, 1..3] OF UDT 1;
END_STRUCT;
BEGIN
END_DATA_BLOCK
";

#[test]
fn data_blocks_keep_their_values_by_name_and_type() {
    let write = "
OPN DB 1;
L 1234; T DBW 0; SET; = DBX 2.1; = DB1.motor.on; L 55; T DB1.motor.speed;
L 11; T DB1.list[1]; L 12; T DB1.list[2]; L 14; T DB1.list[4];
SET; = DB1.bits[3]; = DB1.bits[11]; L 'ab'; T DB1.name[1];
L 900; T DB1.kind; L 23; T DB1.rows[1, 2].speed; SET; = DB1.rows[1, 2].on;";
    for &(engine, load) in ENGINES {
        let mut cpu = running(&format!("{OLD_DATA}{}", ob1(write)), load, 1);
        // Each value is read through the new declaration.
        let read = "
L DB1.A; T MW 0; A DB1.flag2; = M 2.0; A DB1.motor.on; = M 2.1; L DB1.motor.speed; T MW 4; L DB1.motor.extra; T MW 6;
L DB1.list[2]; T MW 8; L DB1.list[4]; T MW 10; L DB1.list[9]; T MW 12; A DB1.bits[3]; = M 2.2; A DB1.bits[11]; = M 2.3; A DB1.bits[12]; = M 2.4;
L DB1.rows[1, 2].speed; T MW 14; A DB1.rows[1, 2].on; = M 2.5; L DB1.first; T MD 16; L DB1.kind; T MD 20; L DB1.name[1]; T MW 24;
L DB1.rows[0, 3].speed; T MW 26;";
        let done = change(&mut cpu, &format!("{NEW_DATA}{}", ob1(read)), load);
        assert_eq!(
            losses(&done),
            [
                "DB1.flag1 (BOOL): it is not in the new sources",
                "DB1.motor.gone (WORD): it is not in the new sources",
                "DB1.list (ARRAY[1..4] OF INT → ARRAY[2..9] OF INT): the array has fewer elements",
                "DB1.kind (INT → REAL): its type changes, so it begins with its initial value",
                "DB1.rows[*].gone (WORD): it is not in the new sources",
            ],
            "{engine}"
        );
        assert_eq!(blocks(&done), ["OB 1 changed", "DB 1 changed"]);
        run(&mut cpu, 1);
        let got = [0, 4, 6, 8, 10, 12, 14, 26].map(|byte| word(&cpu, &mw(byte)));
        assert_eq!(got, [1234, 55, 77, 12, 14, 0, 23, 5], "{engine}");
        let flags = word(&cpu, &Operand::Address(address(Area::BitMemory, Width::Byte, 2)));
        assert_eq!(flags, 0b10_1111, "{engine}");
        let double = |byte| word(&cpu, &Operand::Address(address(Area::BitMemory, Width::DoubleWord, byte)));
        assert_eq!((double(16), f32::from_bits(double(20))), (42, 1.5), "{engine}");
    }
}

#[test]
fn instances_and_multi_instances_keep_their_values() {
    let text = |inner: &str, outer: &str, initial: u32| {
        format!(
            "FUNCTION_BLOCK FB 1\nVAR_INPUT n : INT; END_VAR\nVAR {inner} sum : INT := {initial}; END_VAR\nBEGIN\nL #sum; L #n; +I; T #sum;\nEND_FUNCTION_BLOCK
FUNCTION_BLOCK FB 2\nVAR {outer} one : FB 1; two : FB 1; wait : SFB 4; END_VAR\nBEGIN
CALL #one (n := 1);\nCALL #two (n := 10);\nCALL #wait (IN := TRUE, PT := T#100MS);\nEND_FUNCTION_BLOCK
DATA_BLOCK DB 2 FB 2\nBEGIN\nEND_DATA_BLOCK\n{}",
            ob1("CALL FB 2, DB 2;\nL DB2.two.sum; T MW 0; L DB2.one.sum; T MW 2;\nA DB2.wait.Q; = M 4.0;")
        )
    };
    for &(engine, load) in ENGINES {
        let mut cpu = running(&text("", "", 0), load, 5);
        assert_eq!([0, 2].map(|byte| word(&cpu, &mw(byte))), [50, 5], "{engine}");
        let done = change(&mut cpu, &text("more : ARRAY [1..3] OF BOOL;", "before : DINT;", 3), load);
        assert_eq!(losses(&done), [""; 0]);
        // OB 1 has the addresses of the variables in its code.
        assert_eq!(blocks(&done), ["OB 1 changed", "FB 1 changed", "FB 2 changed", "DB 2 changed"]);
        run(&mut cpu, 5);
        assert_eq!([0, 2].map(|byte| word(&cpu, &mw(byte))), [60, 6], "{engine}");
        (6..9).for_each(|scan| run(&mut cpu, scan));
        let elapsed = |cpu: &Cpu| word(cpu, &Operand::Address(address(Area::BitMemory, Width::Byte, 4)));
        assert_eq!(elapsed(&cpu), 0, "{engine}: 80 ms have passed");
        (9..12).for_each(|scan| run(&mut cpu, scan));
        assert_eq!(elapsed(&cpu), 1, "{engine}: the time began under the old program");
    }
}

#[test]
fn blocks_come_and_go() {
    let db = |words: u32| format!("DATA_BLOCK DB 5\nSTRUCT a : ARRAY [1..{words}] OF WORD; END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n");
    let fc = "FUNCTION FC 1 : VOID\nBEGIN\nL MW 0; INC 1; T MW 0;\nEND_FUNCTION\n";
    let ob = |number: u32, statements: &str| {
        format!(
            "ORGANIZATION_BLOCK OB {number}\nVAR_TEMP info : ARRAY [0..19] OF BYTE; END_VAR\nBEGIN\n{statements}\nEND_ORGANIZATION_BLOCK\n"
        )
    };
    let faults = ob(121, "L MW 10; INC 1; T MW 10;");
    for &(engine, load) in ENGINES {
        let first = format!(
            "{}{fc}{faults}{}{}",
            db(10),
            ob(35, "L MW 2; INC 1; T MW 2;"),
            ob1("UC FC 1;\nOPN DB 5; L 7; T DBW 18; L DBW 0; INC 1; T DBW 0;")
        );
        let mut cpu = running(&first, load, 30);
        assert_eq!([0, 2, 10].map(|byte| word(&cpu, &mw(byte))), [30, 2, 0], "{engine}");
        // The data block becomes shorter, the function goes although it is called, another cyclic interrupt comes.
        let second = format!(
            "{}{faults}{}{}",
            db(5),
            ob(38, "L MW 4; INC 1; T MW 4;"),
            ob1("UC FC 1;\nOPN DB 5; L 7; T DBW 18; L DBW 0; INC 1; T DBW 0;")
        );
        let done = change(&mut cpu, &second, load);
        assert_eq!(losses(&done), ["DB5.a (ARRAY[1..10] OF WORD → ARRAY[1..5] OF WORD): the array has fewer elements"]);
        (30..50).for_each(|scan| run(&mut cpu, scan));
        assert_eq!(word(&cpu, &dbw(5, 0)), 50, "{engine}");
        // Two programming errors in each scan: the missing function, and the data block that ends before byte 18.
        assert_eq!([0, 2, 10].map(|byte| word(&cpu, &mw(byte))), [30, 2, 40], "{engine}: OB 35 is gone, OB 121 was called");
        let fast = word(&cpu, &mw(4));
        assert!((19..=20).contains(&fast), "{engine}: OB 38 every 10 ms, {fast} times");
        assert!(cpu.read(&dbw(5, 18)).is_err(), "{engine}");
        // And back: longer again, with what was cut off gone.
        let done = change(&mut cpu, &first, load);
        assert_eq!(losses(&done), [""; 0]);
        assert_eq!(word(&cpu, &dbw(5, 18)), 0, "{engine}");
        run(&mut cpu, 50);
        assert_eq!((word(&cpu, &dbw(5, 0)), word(&cpu, &dbw(5, 18)), word(&cpu, &mw(0))), (51, 7, 31), "{engine}");
    }
}

#[test]
fn a_removed_data_block_is_listed_and_a_new_initial_value_waits() {
    let block =
        |number: u32, initial: u32| format!("DATA_BLOCK DB {number}\nSTRUCT a : INT := {initial}; END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n");
    for &(engine, load) in ENGINES {
        let main = ob1("L MW 0; T MW 0;");
        let mut cpu = running(&format!("{}{}{main}", block(1, 5), block(2, 6)), load, 2);
        let done = change(&mut cpu, &format!("{}{main}", block(1, 8)), load);
        assert_eq!(blocks(&done), ["DB 2 removed"]);
        assert_eq!(done.losses.iter().map(|loss| (loss.data_block, loss.reason)).collect::<Vec<_>>(), [(2, LossReason::Removed)]);
        assert_eq!(done.initial_values, [1]);
        assert_eq!(word(&cpu, &dbw(1, 0)), 5, "{engine}");
        assert!(cpu.read(&dbw(2, 0)).is_err());
        cpu.restart(Restart::Cold);
        assert_eq!(word(&cpu, &dbw(1, 0)), 8, "{engine}: a cold restart brings it");
    }
}

#[test]
fn data_blocks_that_the_program_made_stay() {
    let block = |number: u32| format!("DATA_BLOCK DB {number}\nSTRUCT a : INT := 5; END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n");
    let make = "A M 0.0; JC done; SET; = M 0.0;
CALL SFC 22 (LOW_LIMIT := W#16#10, UP_LIMIT := W#16#20, COUNT := W#16#8, RET_VAL := MW 2, DB_NUMBER := MW 4);
CALL SFC 22 (LOW_LIMIT := W#16#10, UP_LIMIT := W#16#20, COUNT := W#16#8, RET_VAL := MW 2, DB_NUMBER := MW 6);
done: OPN DB [MW 6]; L DBW 2; INC 1; T DBW 2;";
    for &(engine, load) in ENGINES {
        let mut cpu = running(&format!("{}{}", block(3), ob1(make)), load, 3);
        assert_eq!([4, 6, 2].map(|byte| word(&cpu, &mw(byte))), [16, 17, 0], "{engine}");
        let done = change(&mut cpu, &format!("{}{}{}{}", block(2), block(3), block(16), ob1(make)), load);
        assert_eq!(done.losses.iter().map(|loss| (loss.data_block, loss.reason)).collect::<Vec<_>>(), [(16, LossReason::NumberTaken)]);
        run(&mut cpu, 3);
        assert_eq!((word(&cpu, &dbw(17, 2)), word(&cpu, &dbw(16, 0))), (4, 5), "{engine}");
        // Also in a program that makes none, which has no room for them of its own.
        change(&mut cpu, &format!("{}{}", block(3), ob1("OPN DB 17; L DBW 2; L 10; +I; T DBW 2;")), load);
        run(&mut cpu, 3);
        assert_eq!(word(&cpu, &dbw(17, 2)), 14, "{engine}");
    }
}

#[test]
fn retentive_data_belongs_to_the_new_program_after_a_change() {
    let block = |fields: &str| format!("DATA_BLOCK DB 1\nSTRUCT {fields} END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n");
    let count = ob1("L DB1.n; INC 1; T DB1.n;");
    for &(engine, load) in ENGINES {
        let mut cpu = running(&format!("{}{count}", block("n : INT;")), load, 3);
        assert!(cpu.retain_image().is_some());
        let second = format!("{}{count}", block("before : DINT; n : INT;"));
        change(&mut cpu, &second, load);
        run(&mut cpu, 3);
        let image = cpu.retain_image().expect("the data is other data now").clone();
        let mut next = running(&second, load, 0);
        next.restore(&image, Adoption::SameProgram).expect("it is the image of the new program");
        assert_eq!(word(&next, &dbw(1, 4)), 4, "{engine}");
        let mut old = running(&format!("{}{count}", block("n : INT;")), load, 0);
        assert!(old.restore(&image, Adoption::SameProgram).is_err(), "{engine}: and not that of the old one");
    }
}

#[test]
fn between_two_scans_only_and_on_the_same_cpu_type_only() {
    for &(_, load) in ENGINES {
        let text = ob1("more: L MW 0; INC 1; T MW 0; L MB 1; L 100; <I; JC more;");
        let mut cpu = running(&text, load, 1);
        cpu.stop_request().hold();
        cpu.scan(10_000);
        assert_eq!(cpu.mode(), OperatingMode::Hold);
        let refused = cpu.change_online(Loaded::new(cpu_type(), built(&text), load)).expect_err("in the middle of a scan");
        assert_eq!(refused, ChangeRefused::Running);
        cpu.stop();
        let other = CpuType::by_name("315-2PN/DP").expect("a CPU type");
        let program = Arc::new(compile(&text, Mnemonics::English, other).expect("the program compiles").program);
        let refused = cpu.change_online(Loaded::new(other, program, load)).expect_err("other limits");
        assert_eq!(refused, ChangeRefused::OtherCpuType);
        // In STOP a program may be changed; then there is no scan that a hot restart could go on with.
        cpu.change_online(Loaded::new(cpu_type(), built(&text), load)).expect("in STOP");
        assert_eq!(cpu.restart(Restart::Hot), OperatingMode::Run);
        run(&mut cpu, 5);
    }
}

#[test]
fn the_same_program_changes_nothing() {
    let text = format!("{OLD_DATA}{}", ob1("L DB1.a; INC 1; T DB1.a; T MW 40;"));
    for &(engine, load) in ENGINES {
        let mut twin = running(&text, load, 4);
        let mut cpu = running(&text, load, 4);
        let spaced = text.replace("; ", " ;  // as before\n");
        let done = change(&mut cpu, &spaced, load);
        assert!(done.is_empty(), "{engine}: {done:?}");
        for scan in 4..9 {
            run(&mut cpu, scan);
            run(&mut twin, scan);
            assert!(cpu.machine() == twin.machine(), "{engine}, scan {scan}");
        }
    }
}

#[test]
fn data_blocks_take_new_values_where_that_is_asked_for() {
    let block = |number: u32, fields: &str| format!("DATA_BLOCK DB {number}\nSTRUCT {fields} END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n");
    let count = ob1("L DB1.DBW 0; INC 1; T DB1.DBW 0; L DB2.DBW 0; INC 1; T DB2.DBW 0; L DB3.DBW 0; INC 1; T DB3.DBW 0;");
    let first =
        [block(1, "a : INT := 10;"), block(2, "a : INT := 20;"), block(3, "a : INT := 30;"), block(4, "a : INT;")].concat() + &count;
    // DB 1 has another initial value, DB 2 is longer, DB 4 goes, DB 5 is new; DB 3 stays as it is.
    let second =
        [block(1, "a : INT := 100;"), block(2, "a : INT := 200; b : INT := 7;"), block(3, "a : INT := 30;"), block(5, "a : INT := 5;")];
    let second = second.concat() + &count;
    for &(engine, load) in ENGINES {
        let loaded = || Loaded::new(cpu_type(), built(&second), load);
        let mut kept = running(&first, load, 3);
        let change = kept.change_online(loaded()).expect("between two scans");
        assert_eq!((change.initial_values.clone(), change.new_values.clone()), (vec![1, 2], vec![]), "{engine}");
        assert_eq!([1, 2, 3].map(|db| word(&kept, &dbw(db, 0))), [13, 23, 33], "{engine}: without being asked every value stays");

        let mut cpu = running(&first, load, 3);
        let loaded_at = cpu.date_and_time();
        run(&mut cpu, 3);
        let taken = [1, 2, 3, 4, 5].into();
        let planned = cpu.plan_change_taking(&loaded(), &taken);
        let done = cpu.change_online_taking(loaded(), &taken).expect("between two scans");
        assert_eq!(planned, done);
        assert_eq!(losses(&done), [""; 0], "{engine}: what is asked for is no loss");
        assert_eq!((done.initial_values.clone(), done.new_values.clone()), (vec![], vec![1, 2, 3, 4, 5]));
        assert_eq!(blocks(&done), ["DB 1 changed", "DB 2 changed", "DB 4 removed", "DB 5 added"]);
        assert_eq!([(1, 0), (2, 0), (2, 2), (3, 0), (5, 0)].map(|(db, byte)| word(&cpu, &dbw(db, byte))), [100, 200, 7, 30, 5], "{engine}");
        assert!(cpu.read(&dbw(4, 0)).is_err(), "{engine}");
        let loaded_times = [BlockId::ob(1), BlockId::db(3)].map(|id| cpu.block(id).map(|block| block.loaded));
        assert_eq!(loaded_times, [Some(DateAndTime::DEFAULT), Some(cpu.date_and_time())], "{engine}");
        assert!(cpu.date_and_time() > loaded_at);
        run(&mut cpu, 4);
        assert_eq!([1, 2, 3].map(|db| word(&cpu, &dbw(db, 0))), [101, 201, 31], "{engine}");
        // Values alone need no change of the program: the next scan has them.
        let mut only_values = cpu.program().data[&3].clone();
        only_values.image = vec![1, 0];
        cpu.replace_data_block(&only_values).expect("only values");
        run(&mut cpu, 5);
        assert_eq!(word(&cpu, &dbw(3, 0)), 0x0101, "{engine}");
        // What came from outside into the load memory gives way to the values of the program too.
        let mut block = cpu.program().data[&1].clone();
        block.image = vec![0x11; 2];
        cpu.replace_data_block(&block).expect("only values");
        cpu.change_online_taking(loaded(), &[1].into()).expect("between two scans");
        assert_eq!(word(&cpu, &dbw(1, 0)), 100, "{engine}");
        cpu.restart(Restart::Cold);
        assert_eq!(word(&cpu, &dbw(1, 0)), 100, "{engine}");
        let refused = cpu.change_online_taking(loaded(), &[1, 77].into()).expect_err("there is no DB 77");
        assert_eq!(refused, ChangeRefused::NoDataBlock(77));
    }
}

#[test]
fn data_blocks_that_the_program_made_are_listed_and_not_replaced() {
    let block = "DATA_BLOCK DB 3\nAUTHOR : Meyer\nSTRUCT a : INT := 5; END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
    let make = "A M 0.0; JC done; SET; = M 0.0;
CALL SFC 22 (LOW_LIMIT := W#16#2, UP_LIMIT := W#16#20, COUNT := W#16#8, RET_VAL := MW 2, DB_NUMBER := MW 4);
done: NOP 0;";
    for &(engine, load) in ENGINES {
        let mut cpu = running(&format!("{block}{}", ob1(make)), load, 2);
        assert_eq!(cpu.blocks(), [BlockId::ob(1), BlockId::db(2), BlockId::db(3)], "{engine}");
        let made = cpu.block(BlockId::db(2)).expect("DB 2");
        assert_eq!((made.attributes.language, made.data_bytes, made.load_memory_bytes), (BlockLanguage::CreatedData, 8, None), "{engine}");
        assert_eq!(cpu.block(BlockId::db(3)).map(|block| block.attributes.author).as_deref(), Some("Meyer"));
        assert!(cpu.block(BlockId::ob(1)).is_some_and(|main| main.code_bytes.is_some_and(|bytes| bytes > 20)));
        let other = DataBlock { number: 2, image: vec![1; 8], ..cpu.program().data[&3].clone() };
        assert_eq!(cpu.replace_data_block(&other), Err(ReplaceRefused::Created(2)), "{engine}");
        // A block of the sources with this number takes its place, and that was asked for.
        let loaded = Loaded::new(cpu_type(), built(&format!("{block}{}{}", block.replace("DB 3", "DB 2"), ob1(make))), load);
        let done = cpu.change_online_taking(loaded, &[2].into()).expect("between two scans");
        assert_eq!((losses(&done), done.new_values), (vec![], vec![2]), "{engine}");
        assert_eq!(
            (word(&cpu, &dbw(2, 0)), cpu.block(BlockId::db(2)).map(|block| block.attributes.language)),
            (5, Some(BlockLanguage::Data))
        );
    }
}
