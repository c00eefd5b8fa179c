//! What others ask of the CPU as a whole, through its station.

use std::net::Ipv4Addr;
use std::sync::Arc;

use sieben_cpu::{
    AccessError, ClockRefused, Communication, Cpu, DateAndTime, DiagnosticEntry, NoList, NotInStop, OperatingMode, ProtectionLevel, Rack,
    ReplaceRefused, Requester, Restart, Settings, StartRefused, Station,
};
use sieben_engine::{CodeBlock, Program};
use sieben_model::block::{BlockAttributes, BlockId, BlockKind, BlockLanguage};
use sieben_model::item::Item;
use sieben_model::program::DataBlock;
use sieben_model::types::{DataType, Field, Structure};
use sieben_model::value::{Content, Value};

use crate::script::{Script, Step, cpu, cpu_of, cpu_type, operand};
use crate::{events, value};

fn texts(cpu: &Cpu, after: u64) -> Vec<String> {
    cpu.diagnostic_buffer().newer_than(after).map(|(_, entry)| format!("{:04X} {}", entry.event(), entry.text())).collect()
}

/// Everything as somebody has it who knows nothing but the trait.
fn station(cpu: &mut Cpu) -> &mut dyn Station {
    cpu
}

const PEER: Requester = Requester { address: Some(Ipv4Addr::new(192, 168, 0, 5)) };

#[test]
fn a_start_is_refused_in_run_and_the_buffer_keeps_who_asked() {
    let mut cpu = cpu(&[(1, &[])], Settings::default());
    assert_eq!(station(&mut cpu).start(Restart::Warm, PEER), Ok(OperatingMode::Run));
    assert_eq!(
        texts(&cpu, 0),
        [
            "1381 request for a warm restart by hand: asked for by 192.168.0.5",
            "4301 mode change from STOP to STARTUP",
            "4302 mode change from STARTUP to RUN",
        ]
    );
    let newest = cpu.diagnostic_buffer().newest_number();
    assert_eq!(station(&mut cpu).start(Restart::Warm, PEER), Err(StartRefused::Running));
    assert_eq!(station(&mut cpu).memory_reset(PEER), Err(NotInStop(OperatingMode::Run)));
    assert_eq!(cpu.diagnostic_buffer().newest_number(), newest, "nothing has changed");
    station(&mut cpu).stop_by(PEER);
    station(&mut cpu).stop_by(PEER);
    assert_eq!(texts(&cpu, newest), ["4304 STOP by a programming device or SFB 20: asked for by 192.168.0.5"], "the second asks in vain");
    assert!(cpu.stop_cause().is_some_and(|cause| cause.event == 0x4304 && cause.text.ends_with("192.168.0.5")));
    let entry = cpu.diagnostic_buffer().newest().map(DiagnosticEntry::bytes).expect("an entry");
    assert_eq!(entry[4..12], [0, 1, 0, 0, 192, 168, 0, 5][..], "the place is in info 2");
    let newest = cpu.diagnostic_buffer().newest_number();
    cpu.modify(&operand("MB 0"), 9).expect("MB 0");
    assert_eq!(station(&mut cpu).memory_reset(PEER), Ok(()));
    assert_eq!(value(&cpu, "MB 0"), 0);
    assert_eq!(
        texts(&cpu, newest),
        ["4307 memory reset started by a programming device: asked for by 192.168.0.5", "430E memory reset done"]
    );
}

#[test]
fn a_request_without_an_address_says_no_place() {
    let mut cpu = cpu(&[(1, &[])], Settings::default());
    assert_eq!(station(&mut cpu).start(Restart::Cold, Requester::default()), Ok(OperatingMode::Run));
    station(&mut cpu).stop();
    assert_eq!(station(&mut cpu).memory_reset(Requester::default()), Ok(()));
    assert_eq!(events(&cpu), [0x430E, 0x4307, 0x4304, 0x4302, 0x4301, 0x1385]);
    assert!(texts(&cpu, 0).iter().all(|text| !text.contains("asked")), "{:?}", texts(&cpu, 0));
}

#[test]
fn a_hot_start_is_what_the_cpu_type_makes_of_it() {
    for (name, first, second) in [("315-2PN/DP", 0x1381, 0x1381), ("416-3", 0x1381, 0x1383)] {
        let mut cpu = cpu_of(name, &[(1, &[])], Settings::default());
        for expected in [first, second] {
            let before = cpu.diagnostic_buffer().newest_number();
            assert_eq!(station(&mut cpu).start(Restart::Hot, PEER), Ok(OperatingMode::Run));
            let asked = cpu.diagnostic_buffer().newer_than(before).map(|(_, entry)| entry.event()).next();
            assert_eq!(asked, Some(expected), "{name}: there is nothing to go on with at first");
            cpu.scan(cpu.time_us() + 10_000);
            station(&mut cpu).stop();
        }
    }
}

#[test]
fn in_hold_nothing_of_it_is_done() {
    let mut cpu = cpu(&[(1, &[Step::Loop(3)])], Settings::default());
    cpu.restart(Restart::Warm);
    cpu.stop_request().hold();
    assert_eq!(cpu.scan(0).mode, OperatingMode::Hold);
    let block = DataBlock {
        number: 1,
        based_on: None,
        structure: Arc::default(),
        image: Vec::new(),
        read_only: false,
        non_retain: false,
        unlinked: false,
    };
    assert_eq!(station(&mut cpu).start(Restart::Warm, PEER), Err(StartRefused::Held));
    assert_eq!(station(&mut cpu).memory_reset(PEER), Err(NotInStop(OperatingMode::Hold)));
    assert_eq!(station(&mut cpu).replace_data_block(&block), Err(ReplaceRefused::Running));
    assert_eq!(cpu.mode(), OperatingMode::Hold);
}

#[test]
fn the_clock_is_set_in_every_mode_and_only_to_what_it_shows() {
    let mut cpu = cpu(&[(1, &[Step::Loop(3)])], Settings::default());
    let wanted = DateAndTime::from_bytes([0x26, 0x11, 0x28, 0x15, 0x30, 0, 0x12, 0x37]).expect("a time");
    let set = |cpu: &mut Cpu, what: &str| {
        let before = cpu.diagnostic_buffer().newest_number();
        assert_eq!(station(cpu).set_clock(DateAndTime::DEFAULT), Ok(()), "{what}");
        assert_eq!(station(cpu).set_clock(wanted), Ok(()), "{what}");
        assert_eq!(station(cpu).clock(), wanted, "{what}");
        let last = DateAndTime::from_bytes([0x89, 0x12, 0x31, 0x23, 0x59, 0x59, 0x99, 0x91]).expect("the last time of all");
        for beyond in [last.plus_us(1_000), DateAndTime::from_ms_since_1990(u64::MAX)] {
            assert_eq!(station(cpu).set_clock(beyond), Err(ClockRefused), "{what}");
        }
        assert_eq!(station(cpu).clock(), wanted, "{what}");
        assert_eq!(cpu.diagnostic_buffer().newest_number(), before, "{what}: no entry, as SFC 0 makes none");
    };
    set(&mut cpu, "STOP");
    cpu.restart(Restart::Warm);
    cpu.scan(123_456);
    set(&mut cpu, "RUN");
    cpu.scan(1_123_456);
    assert_eq!(cpu.clock(), wanted.plus_us(1_000_000), "it goes on");
    cpu.stop_request().hold();
    cpu.scan(2_000_000);
    set(&mut cpu, "HOLD");
}

fn field(name: &str, data_type: DataType, offset: u32) -> Field {
    Field { name: name.to_owned(), data_type, offset, initial: Vec::new(), comment: String::new() }
}

fn structure(fields: Vec<Field>, size: u32) -> Arc<Structure> {
    Arc::new(Structure { name: None, fields, size, index: Default::default() })
}

/// DB 1 shared, DB 2 an instance, DB 3 NON_RETAIN, DB 4 UNLINKED, DB 5 READ_ONLY; blocks of tests beyond what the CPU type has.
fn with_blocks() -> Cpu {
    let two = || structure(vec![field("a", DataType::Int, 0), field("b", DataType::Word, 16)], 4);
    let block = |number: u16| DataBlock {
        number,
        based_on: (number == 2).then_some(BlockId::fb(7)),
        structure: two(),
        image: vec![number as u8; 4],
        read_only: number == 5,
        non_retain: number == 3,
        unlinked: number == 4,
    };
    let code = |mc7_bytes| CodeBlock { local_size: 24, mc7_bytes, ..CodeBlock::default() };
    let program = Program {
        code: [
            (BlockId::ob(1), code(Some(120))),
            (BlockId::fb(7), code(None)),
            (BlockId::fc(9000), code(None)),
            (BlockId::ob(200), code(None)),
        ]
        .into(),
        data: [1, 2, 3, 4, 5, 16_001].map(|number| (number, block(number))).into(),
        attributes: [(
            BlockId::fb(7),
            BlockAttributes {
                author: "Meyer".to_owned(),
                version: (1, 2),
                know_how_protected: true,
                ..BlockAttributes::of(BlockLanguage::Scl)
            },
        )]
        .into(),
        ..Program::default()
    };
    let cpu_type = cpu_type("315-2PN/DP");
    Cpu::load(cpu_type, Arc::new(program), |_, _| Arc::new(Script::new(&[(1, &[])])), Rack::simulated(cpu_type), Settings::default())
}

#[test]
fn blocks_are_shown_with_what_is_known_of_them() {
    let mut cpu = with_blocks();
    let station = station(&mut cpu);
    let ids: Vec<String> = station.blocks().iter().map(ToString::to_string).collect();
    assert_eq!(ids, ["OB 1", "FB 7", "DB 1", "DB 2", "DB 3", "DB 4", "DB 5"]);
    for id in station.blocks() {
        let view = station.block(id).expect("what is listed is there");
        assert_eq!((view.id, view.loaded), (id, DateAndTime::DEFAULT));
    }
    for id in [BlockId::fc(1), BlockId::fc(9000), BlockId::db(16_001), BlockId::ob(200), BlockId::new(BlockKind::SystemFunction, 1)] {
        assert_eq!(station.block(id), None, "{id}");
    }
    let main = station.block(BlockId::ob(1)).expect("OB 1");
    assert_eq!(
        (main.attributes, main.local_bytes, main.code_bytes, main.data_bytes),
        (BlockAttributes::of(BlockLanguage::Stl), 24, Some(120), 0)
    );
    let block = station.block(BlockId::fb(7)).expect("FB 7");
    assert_eq!((block.attributes.author.as_str(), block.attributes.version, block.attributes.know_how_protected), ("Meyer", (1, 2), true));
    assert_eq!((block.attributes.language, block.load_memory_bytes), (BlockLanguage::Scl, None));
    let data = station.block(BlockId::db(2)).expect("DB 2");
    assert_eq!((data.based_on, data.data_bytes, data.load_memory_bytes), (Some(BlockId::fb(7)), 4, Some(4)));
    assert_eq!(data.attributes, BlockAttributes::of(BlockLanguage::Data));
    let flags = |number| station.block(BlockId::db(number)).map(|block| (block.read_only, block.non_retain, block.unlinked));
    assert_eq!(
        [1, 3, 4, 5].map(flags),
        [(false, false, false), (false, true, false), (false, false, true), (true, false, false)].map(Some)
    );
}

#[test]
fn new_values_of_a_data_block_are_there_at_once_and_after_a_restart() {
    let mut cpu = with_blocks();
    cpu.restart(Restart::Warm);
    cpu.scan(0);
    let program = Arc::clone(cpu.program());
    let with = |number: u16, image: [u8; 4]| DataBlock { image: image.to_vec(), ..program.data[&number].clone() };
    let read = |cpu: &Cpu, number: u16| value(cpu, &format!("DB{number}.DBD 0"));
    let later = DateAndTime::DEFAULT.plus_us(10_000);
    cpu.scan(10_000);
    for number in [1, 2, 3, 4, 5] {
        assert_eq!(station(&mut cpu).replace_data_block(&with(number, [9, 9, 9, number as u8])), Ok(()), "DB {number}");
        assert_eq!(cpu.block(BlockId::db(number)).map(|block| block.loaded), Some(later));
        if number != 4 {
            assert_eq!(read(&cpu, number), 0x0909_0900 + u32::from(number));
        }
    }
    for number in [1, 3] {
        cpu.modify(&operand(&format!("DB{number}.DBD 0")), 7).expect("a data block");
    }
    cpu.restart(Restart::Warm);
    assert_eq!([1, 3].map(|number| read(&cpu, number)), [7, 0x0909_0903], "NON_RETAIN comes from the load memory");
    let image = cpu.retain_image().expect("an image").clone();
    cpu.stop();
    cpu.memory_reset();
    assert_eq!(read(&cpu, 1), 0x0909_0901, "the load memory is not reset");
    let mut next = with_blocks();
    next.restore(&image, sieben_cpu::retain::Adoption::SameProgram).expect("the same program");
    next.restart(Restart::Cold);
    assert_eq!(read(&next, 1), 0x0909_0901, "a power failure does not forget it");
    // The values of the sources again: nothing of the load memory is other than they are.
    assert_eq!(station(&mut next).replace_data_block(&with(1, [1; 4])), Ok(()));
    next.restart(Restart::Cold);
    assert_eq!(read(&next, 1), 0x0101_0101);
}

#[test]
fn a_data_block_that_is_not_only_values_is_refused() {
    let mut cpu = with_blocks();
    cpu.restart(Restart::Warm);
    let program = Arc::clone(cpu.program());
    let of = |number: u16| program.data[&number].clone();
    let other_names = structure(vec![field("x", DataType::Int, 0), field("y", DataType::Word, 16)], 4);
    let other_types = structure(vec![field("a", DataType::Word, 0), field("b", DataType::Word, 16)], 4);
    let cases = [
        (DataBlock { number: 77, ..of(1) }, Err(ReplaceRefused::NotLoaded(77))),
        (DataBlock { image: vec![0; 6], ..of(1) }, Err(ReplaceRefused::Length(1, 4, 6))),
        (DataBlock { image: Vec::new(), ..of(1) }, Err(ReplaceRefused::Length(1, 4, 0))),
        (DataBlock { non_retain: true, ..of(1) }, Err(ReplaceRefused::Attributes(1))),
        (DataBlock { read_only: false, ..of(5) }, Err(ReplaceRefused::Attributes(5))),
        (DataBlock { structure: other_types.clone(), ..of(2) }, Err(ReplaceRefused::Structure(2))),
        (DataBlock { based_on: Some(BlockId::fb(8)), ..of(2) }, Err(ReplaceRefused::Structure(2))),
        (DataBlock { based_on: None, ..of(2) }, Err(ReplaceRefused::Structure(2))),
        (DataBlock { based_on: Some(BlockId::fb(7)), ..of(1) }, Err(ReplaceRefused::Structure(1))),
        // Names do not matter, and nor do the types of a shared data block.
        (DataBlock { structure: other_names, image: vec![2; 4], ..of(2) }, Ok(())),
        (DataBlock { structure: other_types, image: vec![1; 4], ..of(1) }, Ok(())),
    ];
    for (block, expected) in cases {
        let before = cpu.machine().clone();
        assert_eq!(station(&mut cpu).replace_data_block(&block), expected, "{block:?}");
        assert!(*cpu.machine() == before, "{block:?}: the values are the same");
    }
    for refused in [ReplaceRefused::Created(3), ReplaceRefused::Length(1, 4, 6), ReplaceRefused::Running] {
        assert!(!refused.to_string().is_empty());
    }
}

#[test]
fn a_read_only_data_block_is_written_by_none_of_those_outside() {
    let mut cpu = with_blocks();
    cpu.restart(Restart::Warm);
    let item = Item::operand(operand("DB5.DBW 2"));
    let values = [(item.clone(), Value { kind: item.kind.clone(), content: Content::Bits(7) })];
    let before = cpu.machine().clone();
    assert_eq!(cpu.modify(&operand("DB5.DBW 2"), 7), Err(AccessError::WriteProtected));
    assert_eq!(cpu.modify(&operand("DB5.DBX 0.0"), 1), Err(AccessError::WriteProtected));
    assert_eq!(cpu.modify(&operand("DB5.DBW 4"), 7), Err(AccessError::WriteProtected), "whatever its address");
    assert_eq!(cpu.write_items(&values), [Err(AccessError::WriteProtected)]);
    assert!(*cpu.machine() == before);
    assert!(cpu.read_items(&[item]).iter().all(Result::is_ok));
    assert_eq!(cpu.modify(&operand("DB1.DBW 2"), 7), Ok(()));
    // A scenario or a step tries things out.
    assert_eq!(cpu.set(&values[0].0, &values[0].1.content), Ok(()));
    assert_eq!(value(&cpu, "DB5.DBW 2"), 7);
}

#[test]
fn ram_copied_to_rom_comes_back_at_a_cold_restart_and_a_memory_reset() {
    let mut cpu = with_blocks();
    cpu.restart(Restart::Warm);
    let set = |cpu: &mut Cpu, number: u16, value: u32| {
        cpu.modify(&operand(&format!("DB{number}.DBD 0")), value).expect("a data block");
    };
    let read = |cpu: &Cpu| [1, 2, 3].map(|number| value(cpu, &format!("DB{number}.DBD 0")));
    for number in [1, 3] {
        set(&mut cpu, number, 7);
    }
    assert_eq!(station(&mut cpu).copy_ram_to_rom(), 2);
    assert_eq!(station(&mut cpu).copy_ram_to_rom(), 0, "nothing has changed since");
    for number in [1, 2, 3] {
        set(&mut cpu, number, 8);
    }
    cpu.restart(Restart::Warm);
    assert_eq!(read(&cpu), [8, 8, 7], "NON_RETAIN comes from the load memory");
    cpu.restart(Restart::Cold);
    assert_eq!(read(&cpu), [7, 0x0202_0202, 7]);
    let image = cpu.retain_image().expect("an image").clone();
    let mut next = with_blocks();
    next.restore(&image, sieben_cpu::retain::Adoption::SameProgram).expect("the same program");
    next.restart(Restart::Cold);
    assert_eq!(read(&next), [7, 0x0202_0202, 7], "a power failure does not forget it");
    // The values of the sources again.
    set(&mut cpu, 1, 0x0101_0101);
    assert_eq!(station(&mut cpu).copy_ram_to_rom(), 1);
    assert_eq!(station(&mut cpu).data_block_values(1), Some(vec![1; 4]));
    assert_eq!(station(&mut cpu).data_block_values(4), Some(vec![4; 4]), "UNLINKED: those of the load memory");
    assert_eq!(station(&mut cpu).data_block_values(9), None);
    assert!(!station(&mut cpu).delete_created_data_block(1), "it is one of the program");
    assert!(!station(&mut cpu).delete_created_data_block(9));
}

#[test]
fn status_lists_show_what_servers_have_told() {
    let mut cpu = cpu(&[(1, &[])], Settings::default());
    cpu.restart(Restart::Warm);
    let words = |cpu: &mut Cpu, id: u16, index: u16| -> Vec<u16> {
        let list = station(cpu).status_list(id, index).expect("a list");
        list.records[0].chunks(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]])).collect()
    };
    let names = |cpu: &mut Cpu| -> Vec<String> {
        let list = station(cpu).status_list(0x001C, 0).expect("a list");
        let text = |record: &Vec<u8>| String::from_utf8_lossy(&record[2..]).trim_end_matches('\0').to_owned();
        list.records[..3].iter().map(text).collect()
    };
    assert_eq!(words(&mut cpu, 0x0132, 1)[..9], [1, 1, 1, 0, 0, 0, 0, 14, 0]);
    assert_eq!(words(&mut cpu, 0x0232, 4)[..6], [4, 1, 0, 1, 1, 2]);
    assert_eq!(names(&mut cpu), ["Sieben", "CPU 315-2 PN/DP", ""]);
    let told = Communication {
        programming_devices: 2,
        operator_panels: 0,
        others: 5,
        protection: ProtectionLevel::ReadWriteProtected,
        system_name: "Halle Süd".to_owned(),
        module_name: "a name of far more than twenty-four characters".to_owned(),
        plant_name: "=A1+漢".to_owned(),
        address: Some("192.168.0.7".parse().expect("an address")),
    };
    station(&mut cpu).set_communication(told.clone());
    assert_eq!(*cpu.communication(), told);
    let ethernet = station(&mut cpu).status_list(0x0037, 0).expect("a list").records;
    assert_eq!(ethernet.iter().map(|record| record[..6].to_vec()).collect::<Vec<_>>(), [[0x07, 0xFE, 192, 168, 0, 7]]);
    assert_eq!(words(&mut cpu, 0x0132, 1)[..9], [1, 1, 1, 2, 0, 0, 0, 8, 5]);
    for list in [words(&mut cpu, 0x0132, 4), words(&mut cpu, 0x0232, 4)] {
        assert_eq!(list[..6], [4, 1, 3, 3, 1, 2]);
    }
    assert_eq!(names(&mut cpu), ["Halle S\u{FFFD}d", "a name of far more than ", "=A1+?"], "one byte for each character");
    station(&mut cpu).set_communication(Communication { others: u16::MAX, programming_devices: u16::MAX, ..told });
    assert_eq!(words(&mut cpu, 0x0132, 1)[..9], [1, 1, 1, u16::MAX, 0, 0, 0, 0, u16::MAX]);
    assert_eq!(station(&mut cpu).status_list(0x7777, 0), Err(NoList::Id));
    assert_eq!(station(&mut cpu).status_list(0x0111, 99), Err(NoList::Index));
}

#[test]
fn the_light_frce_is_on_while_something_is_forced() {
    let mut cpu = cpu(&[(1, &[])], Settings::default());
    cpu.restart(Restart::Warm);
    let light = |cpu: &mut Cpu| [0x0174, 0x0119].map(|id| station(cpu).status_list(id, 6).expect("a light").records[0][2]);
    assert_eq!(light(&mut cpu), [0, 0]);
    station(&mut cpu).force(&operand("I 0.0"), 1).expect("an input");
    assert_eq!(station(&mut cpu).forced().bytes().count(), 1);
    assert_eq!(light(&mut cpu), [1, 1]);
    cpu.stop();
    assert_eq!(light(&mut cpu), [1, 1], "in STOP too");
    assert_eq!(station(&mut cpu).unforce(&operand("I 0.0")), Ok(true));
    assert_eq!(light(&mut cpu), [0, 0]);
    station(&mut cpu).force(&operand("QB 0"), 1).expect("outputs");
    station(&mut cpu).unforce_all();
    assert_eq!(light(&mut cpu), [0, 0]);
}

#[test]
fn a_status_list_says_the_mode_as_it_is() {
    let mut cpu = cpu(&[(1, &[Step::Loop(3)])], Settings::default());
    let mode = |cpu: &mut Cpu| station(cpu).status_list(0x0424, 0).expect("a list").records[0][3];
    assert_eq!(mode(&mut cpu), 4);
    cpu.restart(Restart::Warm);
    assert_eq!(mode(&mut cpu), 8);
    cpu.stop_request().hold();
    cpu.scan(0);
    assert_eq!(mode(&mut cpu), 0xA);
}
