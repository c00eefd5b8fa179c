//! Names and scenarios over a CPU whose program does nothing: what is set is what is there.

use std::sync::Arc;

use sieben_cpu::{AccessError, Cpu, Rack, Restart, Settings, Station};
use sieben_engine::machine::Register;
use sieben_engine::{Interpreter, Program};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::cpu_type::CpuType;
use sieben_model::item::Item;
use sieben_model::program::DataBlock;
use sieben_model::symbols::{Symbol, SymbolTable};
use sieben_model::types::{DataType, Field, Structure};
use sieben_model::value::{Content, Kind, Value};
use sieben_sim::names::{Name, assignments};
use sieben_sim::scenario::Scenario;

fn field(name: &str, data_type: DataType, offset: u32) -> Field {
    Field { name: name.to_owned(), data_type, offset: offset * 8, initial: Vec::new(), comment: String::new() }
}

/// DB 7 with a field of many types.
fn program() -> Program {
    let inner = Structure {
        name: None,
        fields: vec![field("deep", DataType::Int, 0), field("flag", DataType::Bool, 2)],
        size: 4,
        index: Default::default(),
    };
    let array = DataType::Array { bounds: vec![(1, 3)], element: Box::new(DataType::Int) };
    let fields = vec![
        field("speed", DataType::Real, 0),
        field("count", DataType::DoubleInt, 4),
        field("list", array, 8),
        field("sub", DataType::Struct(Arc::new(inner)), 14),
        field("when", DataType::DateAndTime, 18),
        field("word", DataType::String(4), 26),
        field("pause", DataType::Time, 32),
        field("tiny", DataType::String(2), 36),
        field("six", DataType::String(6), 40),
    ];
    let structure = Arc::new(Structure { name: None, fields, size: 48, index: Default::default() });
    let mut image = vec![0; 48];
    image[26..32].copy_from_slice(&[4, 2, b'a', b'b', 0, 0]);
    image[36..40].copy_from_slice(&[2, 1, b'x', 0]);
    image[40..48].copy_from_slice(&[6, 3, b'a', b'b', b'c', 0, 0, 0]);
    let block = DataBlock { number: 7, based_on: None, structure, image, read_only: false, non_retain: false, unlinked: false };
    Program { data: [(7, block)].into(), ..Program::default() }
}

fn cpu(cpu_type: &'static CpuType) -> Cpu {
    let program = Arc::new(program());
    Cpu::load(cpu_type, program, Interpreter::load, Rack::simulated(cpu_type), Settings::default())
}

fn symbols() -> SymbolTable {
    let symbol = |name: &str, address: &str, data_type: &str| Symbol {
        name: name.to_owned(),
        address: address.to_owned(),
        data_type: data_type.to_owned(),
        ..Symbol::default()
    };
    SymbolTable::new(vec![
        symbol("Motor on", "A 4.0", "BOOL"),
        symbol("Level", "MW 20", "INT"),
        symbol("Store", "DB 7", "DB 7"),
        symbol("Broken", "somewhere", "BOOL"),
    ])
}

#[test]
fn what_is_set_is_shown_by_its_type() {
    let mut cpu = cpu(&CpuType::ALL[0]);
    cpu.restart(Restart::Warm);
    for (name, value, shown) in [
        ("M 0.3", "1", "1"),
        ("M0.3", "TRUE", "1"),
        ("mb 1", "16#A5", "16#A5"),
        ("MB1", "-1", "16#FF"),
        ("MW10", "-5", "16#FFFB"),
        ("MD 12", "-5", "16#FFFF_FFFB"),
        ("MD12", "DW#16#0102_0304", "16#0102_0304"),
        ("MD12", "1.5", "16#3FC0_0000"),
        ("EW 0", "W#16#0102", "16#0102"),
        ("PIW 0", "300", "16#012C"),
        ("AB 4", "2#1010", "16#0A"),
        ("C 1", "42", "42"),
        ("Z 1", "C#123", "123"),
        ("T 1", "S5T#2S", "200"),
        ("DB7.DBD 4", "L#70000", "16#0001_1170"),
        ("DB7.count", "-7", "-7"),
        ("DB7.speed", "5", "5.0e+000"),
        ("DB7.speed", "-2.5", "-2.5e+000"),
        ("DB7.speed", "-INF", "-INF"),
        ("DB7.list[2]", "-3", "-3"),
        ("DB7.sub.deep", "9", "9"),
        ("DB7.sub.flag", "1", "1"),
        ("DB7.pause", "T#1S", "T#1S"),
        ("\"Motor on\"", "1", "1"),
        ("Level", "-12", "-12"),
        ("\"Store\".list[3]", "8", "8"),
        ("Store.count", "L#-70000", "-70000"),
        ("DB7.word", "'xyz'", "'xyz'"),
        ("DB7.six", "''", "''"),
        ("P#M 40.0 BYTE 4", "16#01 02 03 FF", "01 02 03 FF"),
        ("P#DB7.DBX 44.0 BYTE 2", "6162", "61 62"),
        ("P#E 2.0 BYTE 1", "16#A5", "A5"),
    ] {
        let parsed = Name::parse(name, &symbols(), cpu.program()).unwrap_or_else(|error| panic!("{name}: {error}"));
        parsed.write(&mut cpu, value).unwrap_or_else(|error| panic!("{name}={value}: {error}"));
        // Inputs come into the process image with the next scan.
        cpu.scan(0);
        assert_eq!(parsed.read(&cpu).unwrap_or_else(|error| panic!("{name}: {error}")).to_string(), shown, "{name}={value}");
        assert_eq!(parsed.holds(&cpu, value).ok(), Some(name != "T 1"), "{name}={value}");
    }
    for (name, shown) in [("DB7.word", "'xyz'"), ("DB7.tiny", "'x'"), ("DB7.six", "''")] {
        let text = Name::parse(name, &symbols(), cpu.program()).expect("a name");
        assert_eq!(text.read(&cpu).map(|text| text.to_string()).as_deref(), Ok(shown), "{name}");
        assert_eq!(text.holds(&cpu, shown), Ok(true), "{name}");
    }
}

#[test]
fn what_is_no_name_or_no_value_is_said_in_the_users_words() {
    let mut cpu = cpu(&CpuType::ALL[0]);
    cpu.restart(Restart::Warm);
    for (name, value, word) in [
        ("nonsense", "1", "nothing is called `nonsense`"),
        ("", "1", "nothing is called"),
        ("M 0.8", "1", "the bits of a byte are 0 to 7"),
        ("DB7.speed", "1e39", "`1e39` is outside -3.402823E+38"),
        ("STW.XX", "1", "no bit `XX`"),
        ("DB7.nothing", "1", "no `nothing`"),
        ("DB7.list[9]", "1", "no `list[9]`"),
        ("DB7.list[1,1]", "1", "no `list[1,1]`"),
        ("DB7.list", "1", "no single value"),
        ("DB9.x", "1", "no `DB 9`"),
        ("FC 1", "1", "is a block"),
        ("Store", "1", "is DB 7"),
        ("Broken", "1", "which is none"),
        ("M 0.0", "2", "write 0 or 1"),
        ("MB 0", "256", "8 bits"),
        ("MB 0", "16#FFF", "8 bits"),
        ("MW 0", "1.5", "16 bits"),
        ("MW 0", "soon", "not a constant"),
        ("MW 60000", "1", "outside"),
        ("DB7.DBW 48", "1", "outside"),
        ("DB8.DBW 0", "1", "not loaded"),
        ("LW 0", "1", "between two scans"),
        ("T1.q", "1", "only be read"),
        ("T 999", "S5T#1S", "outside"),
        ("C 1", "1000", "999"),
        ("ACCU3", "1", "accumulators 1 and 2"),
        ("DBNO", "1", "only be read"),
        ("STW", "11", "nine characters"),
        ("DB7.word", "'vwxyz'", "holds 4 characters"),
        ("DB7.word", "5", "in single quotes"),
        ("P#M 0.1 BYTE 2", "0000", "names no bytes"),
        ("P#M 0.0 WORD 2", "0000", "names no bytes"),
        ("P#DB7.DBX 40.0 BYTE 9", "16#010203040506070809", "outside"),
        ("P#M 0.0 BYTE 2", "16#01", "2 bytes as hex digits"),
    ] {
        let error = match Name::parse(name, &symbols(), cpu.program()).and_then(|name| name.write(&mut cpu, value)) {
            Ok(()) => panic!("{name}={value} was taken"),
            Err(error) => error.to_string(),
        };
        assert!(error.contains(word), "{name}={value}: {error}");
    }
}

#[test]
fn a_list_of_items_is_read_and_written_each_for_itself() {
    let mut cpu = cpu(&CpuType::ALL[0]);
    cpu.restart(Restart::Warm);
    let quad = Operand::Address(Address { area: Area::BitMemory, width: Width::QuadWord, byte: 100, bit: 0 });
    let items = [
        Item::area(Area::BitMemory, 10, 4),
        Item::data(7, 0, 48),
        Item::data(7, 40, 9),
        Item::data(8, 0, 1),
        Item::operand(quad),
        Item::typed(quad, Some(&DataType::LongInt)),
        Item::area(Area::Local, 0, 1),
        Item::area(Area::BitMemory, u32::MAX, u32::MAX),
        Item::register(Register::Accu3),
    ];
    let values = [
        (items[0].clone(), Value::bytes([1, 2, 3, 4])),
        (items[2].clone(), Value::bytes([0; 9])),
        (items[5].clone(), items[5].value("-2").expect("a number")),
        (Item::timer_status(1), Value::bits(Kind::Bit, 1)),
        (items[0].clone(), Value::bytes([0; 5])),
        (Item::operand(Operand::Counter(1)), Value::bits(Kind::Number, 1_000)),
        (Item::area(Area::Output, 4, 2), Value::bytes([0x12, 0x34])),
    ];
    assert_eq!(
        cpu.write_items(&values),
        [Ok(()), Err(AccessError::Outside), Ok(()), Err(AccessError::ReadOnly), Err(AccessError::Value), Err(AccessError::Value), Ok(())]
    );
    let read = cpu.read_items(&items);
    assert_eq!(read[0], Ok(Value::bytes([1, 2, 3, 4])));
    assert_eq!(read[1].as_ref().map(|value| value.content.clone()), Ok(Content::Bytes(program().data[&7].image.clone().into())));
    assert_eq!(read[2], Err(AccessError::Outside));
    assert_eq!(read[3], Err(AccessError::NotLoaded));
    assert_eq!(read[4], Ok(Value::bits(Kind::Bits(64), u64::MAX - 1)));
    assert_eq!(read[5].as_ref().map(|value| value.shown().to_string()).as_deref(), Ok("-2"));
    assert_eq!(read[6], Err(AccessError::NotAccessible));
    assert_eq!(read[7], Err(AccessError::Outside));
    assert_eq!(read[8], Err(AccessError::NoRegister));
    assert_eq!(cpu.read(&Operand::parse("AW 4").expect("an address")), Ok(0x1234));
}

#[test]
fn assignments_are_split_at_blanks_outside_of_values() {
    let split =
        |text: &str| assignments(text).map(|pairs| pairs.into_iter().map(|(name, value)| format!("{name}|{value}")).collect::<Vec<_>>());
    assert_eq!(
        split("I 0.0=1 MW10 = 16#0102 MD4=B#(1, 2, 3, 4) \"a = b\"='x y'"),
        Ok(vec!["I 0.0|1".to_owned(), "MW10|16#0102".to_owned(), "MD4|B#(1, 2, 3, 4)".to_owned(), "\"a = b\"|'x y'".to_owned()])
    );
    assert!(split("I 0.0").is_err() && split("=1").is_err() && split("I 0.0=").is_err());
}

fn run(text: &str) -> Vec<String> {
    let scenario = Scenario::parse(text).unwrap_or_else(|errors| panic!("{errors:?}"));
    let cpu_type = scenario.cpu.unwrap_or(&CpuType::ALL[0]);
    scenario.run(&symbols(), &mut || cpu(cpu_type)).iter().map(ToString::to_string).collect()
}

#[test]
fn a_scenario_that_comes_true_says_nothing() {
    for text in [
        "set MW0=5\nscan\nexpect MW0=5 Level=0",
        "at 15ms I 0.0=1\nscan 2\nexpect I 0.0=0\nscan\nexpect I 0.0=1",
        "cycle 100ms\nat 250ms M 0.0=1\nscan until 200ms\nexpect M 0.0=0\nexpect M 0.0=1 within 200ms",
        "table MW0 MW2 -> MW2 MW0\n1 2 2 1\n3 4 4 3",
        "cpu 416-3\nset ACCU4=7\nexpect mode RUN",
        "set DB7.count=3\nrestart cold\nexpect DB7.count=0",
    ] {
        assert_eq!(run(text), Vec::<String>::new(), "{text}");
    }
}

#[test]
fn a_scenario_that_does_not_come_true_says_where_and_what() {
    for (text, line, word) in [
        ("set MW0=5\nscan\nexpect MW0=6", 3, "expected MW0 = 6, got 16#0005 (5) after the scan at 0ms"),
        ("set MD20=16#41200000\nscan\nexpect MD20:REAL=5", 3, "expected MD20:REAL = 5, got 10.0 after"),
        ("set IW4:BCD=-142\nscan\nexpect IW4=0", 3, "expected IW4 = 0, got 16#F142 (-3774) after"),
        ("set T1=S5T#5S\nscan\nexpect T1=S5T#3S", 3, "got S5T#5S after"),
        ("set T1=S5T#5S\nscan\nexpect T1=3", 3, "got 500 (S5T#5S) after"),
        ("scan\nexpect MB3:REAL=1", 2, "`MB3` is a byte, and REAL shows a double word"),
        ("scan\nexpect MD0:REL=1", 2, "`REL`, asked for with `MD0`, is no format"),
        ("expect MW0=6", 1, "before the first scan"),
        ("scan\nexpect nobody=1", 2, "nothing is called `nobody`"),
        ("scan\nexpect M 0.0=1 within 50ms", 2, "after the scan at 50ms"),
        ("scan\nexpect stop 16#2522", 2, "but the CPU is in RUN"),
        ("scan\nexpect mode STOP", 2, "expected the mode STOP, got RUN"),
        ("scan 3\nat 10ms I 0.0=1\nscan", 2, "the last scan was already at 20ms"),
        ("at 500ms I 0.0=1\nscan", 1, "no scan came at 500ms"),
        ("scan at 50ms\nscan at 20ms", 2, "already at 50ms"),
        ("interrupt OB 40 at safe point 17\nscan", 2, "safe points"),
        ("table MW0 -> MW2\n1 0\n2 9", 3, "expected MW2 = 9"),
        ("set ACCU3=1", 1, "accumulators 1 and 2"),
        ("cycle 1us\nscan until 1h", 2, "more than 1000000 scans"),
    ] {
        let failures = run(text);
        assert!(
            failures.iter().any(|failure| failure.starts_with(&format!("line {line}:")) && failure.contains(word)),
            "{text}: {failures:?}"
        );
    }
}
