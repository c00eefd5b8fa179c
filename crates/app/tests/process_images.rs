//! The cycle control point leaves alone what nobody has written: whoever writes the process images, and however, it must not be seen.

#[allow(dead_code)] // The pages need more of it.
mod program;

use std::sync::Arc;

use program::{ENGINES, Load, compile, cpu};
use proptest::prelude::*;
use sieben_cpu::{Cpu, OperatingMode, Restart, SimulatedModule, Station};
use sieben_engine::image_writes::ANYWHERE;
use sieben_engine::{ImageWrites, Program};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;

/// Bytes of both images that the test looks at and writes.
const BYTES: u32 = 24;

fn built(text: &str) -> Arc<Program> {
    let cpu = CpuType::by_name("315-2PN/DP").expect("a CPU type");
    Arc::new(compile(text, Mnemonics::English, cpu).expect("the program compiles").program)
}

fn organization_block(body: &str) -> String {
    format!("ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n  info : ARRAY [1..20] OF BYTE;\nEND_VAR\nBEGIN\nNETWORK\n{body}\nEND_ORGANIZATION_BLOCK\n")
}

fn writes(text: &str) -> ImageWrites {
    ImageWrites::of(&built(text))
}

#[test]
fn what_a_program_may_write_of_the_images() {
    let function = "FUNCTION FC 1 : VOID\nVAR_OUTPUT\n  out : WORD;\nEND_VAR\nBEGIN\nNETWORK\nL 7; T #out;\nEND_FUNCTION\n";
    let cases: &[(&str, ImageWrites)] = &[
        ("L IW 4; T MW 0;", ImageWrites::default()),
        ("A I 1.0; = Q 9.5; S Q 3.1;", ImageWrites { inputs: 0..0, outputs: 3..10 }),
        ("L 1; T IW 6;", ImageWrites { inputs: 6..8, outputs: 0..0 }),
        ("L 1; T QD 6;", ImageWrites { inputs: 0..0, outputs: 6..10 }),
        ("LAR1 P#4.0; L 1; T QB [AR1,P#0.0];", ImageWrites { inputs: 0..0, outputs: ANYWHERE }),
        ("LAR1 P#Q 4.0; L 1; T B [AR1,P#0.0];", ImageWrites::anywhere()),
        ("CALL FC 1 ( out := MW 0 );", ImageWrites::default()),
        // One more, as if bits could make a byte.
        ("CALL FC 1 ( out := QW 4 );", ImageWrites { inputs: 0..0, outputs: 4..7 }),
    ];
    for (body, expected) in cases {
        assert_eq!(writes(&format!("{function}{}", organization_block(body))), *expected, "{body}");
    }
}

/// What happens between two scans.
#[derive(Clone, Debug)]
enum Event {
    Nothing,
    Input(u32, u8),
    Module(u32, u8),
    Output(u32, u8),
    Peripheral(u32, u8),
    Force(Area, u32, u8),
    Unforce(Area, u32),
    Fail,
    Answer,
    Restart,
    MemoryReset,
    GoBack,
    OtherProgram,
}

fn event() -> impl Strategy<Value = Event> {
    let byte = 0..BYTES;
    let area = || prop_oneof![Just(Area::Input), Just(Area::Output)];
    prop_oneof![
        4 => Just(Event::Nothing),
        3 => (byte.clone(), any::<u8>()).prop_map(|(byte, value)| Event::Input(byte, value)),
        2 => (byte.clone(), any::<u8>()).prop_map(|(byte, value)| Event::Module(byte, value)),
        2 => (byte.clone(), any::<u8>()).prop_map(|(byte, value)| Event::Output(byte, value)),
        2 => (byte.clone(), any::<u8>()).prop_map(|(byte, value)| Event::Peripheral(byte, value)),
        1 => (area(), byte.clone(), any::<u8>()).prop_map(|(area, byte, value)| Event::Force(area, byte, value)),
        1 => (area(), byte).prop_map(|(area, byte)| Event::Unforce(area, byte)),
        1 => Just(Event::Fail),
        1 => Just(Event::Answer),
        1 => Just(Event::Restart),
        1 => Just(Event::MemoryReset),
        1 => Just(Event::GoBack),
        1 => Just(Event::OtherProgram),
    ]
}

/// What a scan writes.
fn statement() -> impl Strategy<Value = String> {
    let byte = 0..BYTES - 4;
    prop_oneof![
        3 => (byte.clone(), byte.clone()).prop_map(|(from, to)| format!("L IB {from}; L MB 0; +I; T QB {to};")),
        1 => byte.clone().prop_map(|to| format!("L MW 0; T QW {to};")),
        1 => byte.clone().prop_map(|to| format!("L MB 0; T IB {to};")),
        1 => byte.clone().prop_map(|to| format!("L P#{to}.0; T MD 4; L MB 0; T QB [MD 4];")),
        1 => byte.clone().prop_map(|to| format!("LAR1 P#Q {to}.0; L MB 0; T B [AR1,P#1.0];")),
        1 => byte.clone().prop_map(|to| format!("LAR1 P#I {to}.0; L MB 0; T B [AR1,P#1.0];")),
        1 => byte.clone().prop_map(|to| format!("L MB 0; T PQB {to};")),
        1 => byte.clone().prop_map(|to| format!("CALL FC 1 ( out := QW {to} );")),
        1 => byte.clone().prop_map(|to| format!("CALL SFC 20 ( SRCBLK := P#M 0.0 BYTE 2, RET_VAL := MW 8, DSTBLK := P#Q {to}.0 BYTE 2 );")),
        1 => byte.clone().prop_map(|to| format!("CALL SFC 21 ( BVAL := MB 0, RET_VAL := MW 8, BLK := P#I {to}.0 BYTE 3 );")),
        1 => Just("CALL SFC 26 ( PART := B#16#0, RET_VAL := MW 8, FLADDR := MW 10 );".to_owned()),
        1 => Just("CALL SFC 27 ( PART := B#16#0, RET_VAL := MW 8, FLADDR := MW 10 );".to_owned()),
    ]
}

fn text(statements: &[String]) -> String {
    let function = "FUNCTION FC 1 : VOID\nVAR_OUTPUT\n  out : WORD;\nEND_VAR\nBEGIN\nNETWORK\nL MW 0; T #out;\nEND_FUNCTION\n";
    format!("{function}{}", organization_block(&format!("L MW 0; L 259; +I; T MW 0;\n{}", statements.join("\n"))))
}

fn at(area: Area, byte: u32) -> Operand {
    Operand::Address(Address { area, width: Width::Byte, byte, bit: 0 })
}

/// A CPU, and one whose images are exchanged whole.
struct Both([Cpu; 2]);

impl Both {
    fn each(&mut self, mut act: impl FnMut(&mut Cpu)) {
        self.0.iter_mut().for_each(&mut act);
    }

    fn scan(&mut self, now_us: u64) {
        // Whoever asks for a module to change it may change anything.
        self.0[1].rack_mut().module_mut::<SimulatedModule>().expect("all modules are simulated");
        self.each(|cpu| {
            cpu.scan(now_us);
        });
    }

    fn assert_alike(&self, scan: usize) {
        let [found, expected] = &self.0;
        assert_eq!(found.rack().outputs(), expected.rack().outputs(), "outputs behind scan {scan}");
        for area in [Area::Input, Area::Output] {
            for byte in 0..BYTES {
                assert_eq!(found.read(&at(area, byte)), expected.read(&at(area, byte)), "{area:?} {byte} behind scan {scan}");
            }
        }
    }
}

fn happen(both: &mut Both, event: &Event, programs: &[Arc<Program>; 2], load: Load) {
    let cpu_type = CpuType::by_name("315-2PN/DP").expect("a CPU type");
    match *event {
        Event::Nothing => {}
        Event::Input(byte, value) => both.each(|cpu| cpu.modify(&at(Area::Input, byte), value.into()).expect("an input")),
        Event::Module(byte, value) => both.each(|cpu| assert!(cpu.rack_mut().set_input(byte, 0x5A, value), "a byte of the module")),
        Event::Output(byte, value) => both.each(|cpu| cpu.modify(&at(Area::Output, byte), value.into()).expect("an output")),
        // Not while the modules have failed.
        Event::Peripheral(byte, value) => {
            let [first, second] = both.0.each_mut().map(|cpu| cpu.modify(&at(Area::PeripheralOutput, byte), value.into()));
            assert_eq!(first, second);
        }
        Event::Force(area, byte, value) => both.each(|cpu| cpu.force(&at(area, byte), value.into()).expect("a byte to force")),
        Event::Unforce(area, byte) => both.each(|cpu| assert!(cpu.unforce(&at(area, byte)).is_ok(), "a byte")),
        Event::Fail => both.each(|cpu| assert!(cpu.rack_mut().set_answering(3, false), "a byte of the module")),
        Event::Answer => both.each(|cpu| assert!(cpu.rack_mut().set_answering(3, true), "a byte of the module")),
        Event::Restart => both.each(|cpu| assert_eq!(Cpu::restart(cpu, Restart::Warm), OperatingMode::Run)),
        Event::MemoryReset => both.each(|cpu| {
            cpu.memory_reset();
            Cpu::restart(cpu, Restart::Warm);
        }),
        Event::GoBack => both.each(|cpu| {
            let snapshot = cpu.snapshot(None);
            cpu.scan(1_000_000_000);
            cpu.go_back_to(&snapshot);
        }),
        Event::OtherProgram => both.each(|cpu| {
            let loaded = sieben_cpu::Loaded::new(cpu_type, Arc::clone(&programs[1]), load);
            drop(cpu.change_online(loaded));
        }),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn nobody_sees_that_bytes_were_left_alone(
        first in prop::collection::vec(statement(), 0..4),
        second in prop::collection::vec(statement(), 0..4),
        events in prop::collection::vec(event(), 1..24),
    ) {
        let programs = [built(&text(&first)), built(&text(&second))];
        let cpu_type = CpuType::by_name("315-2PN/DP").expect("a CPU type");
        for &(_, load) in ENGINES {
            let fresh = || cpu(&programs[0], cpu_type, load, None);
            let mut both = Both([fresh(), fresh()]);
            both.each(|cpu| assert_eq!(Cpu::restart(cpu, Restart::Warm), OperatingMode::Run));
            for (number, event) in events.iter().enumerate() {
                happen(&mut both, event, &programs, load);
                both.scan(number as u64 * 10_000);
                both.assert_alike(number);
            }
        }
    }
}
