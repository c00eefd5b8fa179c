//! Every picture at moments of its plant, at both sizes, and over whatever is there.

use std::collections::BTreeMap;

use proptest::prelude::*;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use sieben_cpu::IoModule;
use sieben_sim::devices::{DeviceSettings, Kind};
use sieben_sim::wrap::{Fault, Plant};

use super::*;

/// A moment that is worth a picture: parameters, then steps of bytes put out and of seconds that pass.
struct Row {
    kind: &'static str,
    title: &'static str,
    parameters: &'static [(&'static str, f64)],
    faults: &'static [&'static str],
    steps: &'static [Step],
}

enum Step {
    /// The CPU puts these bytes out.
    Out(&'static [u8]),
    /// An input bit is set from outside: byte, mask, value.
    Set(u32, u8, u8),
    /// Milliseconds pass.
    Wait(u64),
}
use Step::{Out, Set, Wait};

const MOMENTS: [Row; 20] = [
    Row { kind: "conveyor", title: "at rest", parameters: &[], faults: &[], steps: &[Wait(1)] },
    Row {
        kind: "conveyor",
        title: "three parts on their way, the horn sounds",
        parameters: &[("gap", 1.0)],
        faults: &[],
        steps: &[Set(0, 0x10, 0x10), Out(&[0xA0]), Wait(4_000)],
    },
    Row {
        kind: "conveyor",
        title: "to the left with a barrier that is stuck",
        parameters: &[("gap", 2.0)],
        faults: &["conveyor.middle stuck=1"],
        steps: &[Out(&[0x20]), Wait(5_000), Out(&[0x40]), Wait(2_000)],
    },
    Row { kind: "dosing", title: "at rest", parameters: &[("supply", 250.0), ("vessel", 30.0)], faults: &[], steps: &[Wait(1)] },
    Row {
        kind: "dosing",
        title: "a dose on its way",
        parameters: &[("flow", 2.5), ("supply", 250.0), ("vessel", 30.0)],
        faults: &[],
        steps: &[Out(&[1, 0, 0, 0, 0, 0x16]), Wait(4_000)],
    },
    Row {
        kind: "dosing",
        title: "the flow meter has failed and the vessel runs over",
        parameters: &[("flow", 10.0), ("supply", 250.0), ("vessel", 30.0)],
        faults: &["dosing.flow stuck=0"],
        steps: &[Out(&[1, 0, 0, 0, 0x12, 0xA4]), Wait(5_000)],
    },
    Row { kind: "elevator", title: "at floor 1", parameters: &[], faults: &[], steps: &[Wait(1)] },
    Row {
        kind: "elevator",
        title: "on its way up, called to floor 4",
        parameters: &[("floor", 2.0)],
        faults: &[],
        steps: &[Set(1, 0x88, 0x88), Out(&[0x05, 0x08, 0, 2]), Wait(1_700)],
    },
    Row {
        kind: "elevator",
        title: "the door opens at floor 3 and a person stands in it",
        parameters: &[("floor", 3.0)],
        faults: &["elevator.door_open stuck=0"],
        steps: &[Set(2, 2, 2), Out(&[0x08, 0x04, 0, 3]), Wait(1_400)],
    },
    Row {
        kind: "junction",
        title: "the main road goes, others wait",
        parameters: &[("main_gap", 1.0), ("side_gap", 2.0), ("walk_gap", 5.0)],
        faults: &[],
        steps: &[Out(&[0x49]), Wait(12_000), Out(&[0x4C]), Wait(2_700)],
    },
    Row {
        kind: "junction",
        title: "pedestrians walk and a lamp is broken",
        parameters: &[("main_gap", 2.0), ("side_gap", 2.0), ("walk_gap", 3.0)],
        faults: &["junction.main_red_lit stuck=0"],
        steps: &[Out(&[0x49]), Wait(9_000), Out(&[0x89]), Wait(1_500)],
    },
    Row { kind: "motor", title: "at rest", parameters: &[], faults: &[], steps: &[Wait(1)] },
    Row { kind: "motor", title: "in star", parameters: &[], faults: &[], steps: &[Out(&[3]), Wait(1_500)] },
    Row {
        kind: "motor",
        title: "a short circuit has blown the fuse",
        parameters: &[],
        faults: &["motor.star stuck=1"],
        steps: &[Out(&[5]), Wait(500)],
    },
    Row {
        kind: "panel",
        title: "thumbwheel and display, the horn sounds",
        parameters: &[],
        faults: &["panel.lamp_0_1 stuck=0"],
        steps: &[
            Set(0, 0xFF, 0x12),
            Set(3, 1, 1),
            Set(4, 0xFF, 0x12),
            Set(5, 0xFF, 0x34),
            Out(&[3, 0, 0, 0x80, 0, 0, 0, 0, 0x09, 0xA5]),
            Wait(10),
        ],
    },
    Row {
        kind: "panel",
        title: "without buttons and thumbwheel, with selectors",
        parameters: &[("buttons", -1.0), ("thumbwheel", -1.0), ("selectors", 8.0), ("lamps", 8.0), ("motor_left", -1.0)],
        faults: &[],
        steps: &[Set(0, 0xFF, 0x81), Set(8, 0xFF, 0x81), Out(&[3, 0, 0, 0, 0, 0x42]), Wait(10)],
    },
    Row {
        kind: "tank",
        title: "it fills and is drawn from",
        parameters: &[("level", 55.0)],
        faults: &[],
        steps: &[Out(&[3, 0, 0, 0]), Wait(600), Wait(700)],
    },
    Row {
        kind: "tank",
        title: "it runs over because the level is stuck",
        parameters: &[("level", 95.0)],
        faults: &["tank.level stuck=50", "tank.high stuck=0"],
        steps: &[Out(&[0, 0, 0x6C, 0]), Wait(9_000)],
    },
    Row {
        kind: "thermal",
        title: "it heats up with 60 per cent",
        parameters: &[],
        faults: &[],
        steps: &[Out(&[0x40, 0xCC, 0, 0]), Wait(40_000)],
    },
    Row {
        kind: "thermal",
        title: "it is too hot and the fan runs",
        parameters: &[],
        faults: &["thermal.temperature drift=1"],
        steps: &[Out(&[0, 0, 1, 0]), Wait(95_000), Out(&[0, 0, 2, 0]), Wait(1_000)],
    },
];

fn kind(name: &str) -> &'static Kind {
    Kind::by_name(name).expect("a kind")
}

/// The plant of a row at its moment.
fn look(row: &Row) -> (PlantLook, Moment) {
    let kind = kind(row.kind);
    let mut settings = DeviceSettings::new(kind);
    for (name, value) in row.parameters {
        settings.parameters[kind.parameters.iter().position(|parameter| parameter.name == *name).expect("a parameter")] = *value;
    }
    let mut plant = Plant::new(settings);
    for fault in row.faults {
        plant.inject(&Fault::parse(fault).expect("a fault")).expect("it fits");
    }
    let (mut outputs, mut time_ms) = (vec![0; plant.outputs().len()], 0);
    for step in row.steps {
        match step {
            Out(bytes) => {
                outputs = bytes.to_vec();
                plant.write(0, bytes);
            }
            Set(byte, mask, value) => assert!(plant.set_input(*byte, *mask, *value)),
            Wait(ms) => {
                plant.advance(ms * 1_000);
                time_ms += ms;
            }
        }
    }
    let mut inputs = vec![0; plant.inputs().len()];
    plant.read(0, &mut inputs);
    let symbols = [("I 0.0", "START"), ("Q 0.0", "Y1"), ("I 0.1", "A_very_long_symbol_indeed")];
    let settings = plant.device().settings();
    let state = plant.device().state().into_iter().chain(plant.device().shown(&[0x80; 21]));
    let look = PlantLook {
        kind,
        name: settings.name.clone(),
        input: plant.inputs().start,
        output: plant.outputs().start,
        parameters: settings.parameters.clone(),
        inputs,
        outputs,
        state: state.map(|(name, value, _)| (name.to_owned(), value)).collect(),
        faults: plant.acting_faults().map(ToString::to_string).collect(),
        symbols: symbols.into_iter().map(|(address, name)| (address.to_owned(), name.to_owned())).collect(),
    };
    (look, Moment { time_ms })
}

fn drawn(plant: &PlantLook, moment: Moment, size: Size) -> String {
    let mut buffer = Buffer::empty(Rect::new(0, 0, size.width, size.height));
    let area = buffer.area;
    draw(&mut buffer, area, plant, moment, Palette::Plain);
    let rows = (0..size.height).map(|y| (0..size.width).map(|x| buffer[(x, y)].symbol()).collect::<String>());
    rows.map(|row| format!("│{row}│\n")).collect()
}

#[test]
fn every_kind_has_a_picture_that_fits_where_it_must() {
    for kind in Kind::ALL {
        let picture = picture(kind);
        assert_eq!(picture.kind, kind.name);
        let Sizes { least, best } = size(kind);
        assert!(least.width <= 40 && least.height <= 11 && best.width <= 60 && best.height <= 22, "{kind:?}");
        assert!(MOMENTS.iter().any(|row| row.kind == kind.name), "{kind:?} has no moment");
    }
    assert_eq!(PICTURES.len(), Kind::ALL.len());
}

#[test]
fn pictures_show_what_is_there() {
    let mut text = String::new();
    for row in &MOMENTS {
        let (plant, moment) = look(row);
        let steps: Vec<String> = row
            .steps
            .iter()
            .map(|step| match step {
                Out(bytes) => format!("put out {bytes:02X?}"),
                Set(byte, mask, value) => format!("set input {byte} {mask:02X} to {value:02X}"),
                Wait(ms) => format!("{ms} ms"),
            })
            .collect();
        text += &format!("{}: {}\n{:?} {:?} {}\n", row.kind, row.title, row.parameters, row.faults, steps.join(", "));
        let Sizes { least, best } = size(plant.kind);
        for size in [least, best] {
            text += &drawn(&plant, moment, size);
        }
        text.push('\n');
    }
    insta::assert_snapshot!(text);
}

/// Every bit is seen: with another value the picture is another one, at the smallest size too.
#[test]
fn every_terminal_is_in_the_picture() {
    for kind in Kind::ALL {
        let row = MOMENTS.iter().find(|row| row.kind == kind.name).expect("a moment");
        let (plant, moment) = look(row);
        let Sizes { least, best } = size(kind);
        for size in [least, best] {
            let before = drawn(&plant, moment, size);
            let terminals = kind.terminals(&plant.parameters).expect("they go together");
            for signal in terminals.signals.iter() {
                let mut other = plant.clone();
                let bytes = if signal.is_input() { &mut other.inputs } else { &mut other.outputs };
                let zero = signal.raw(bytes) == 0;
                signal.put(bytes, if zero { 0x1234 } else { 0 });
                assert_ne!(drawn(&other, moment, size), before, "{kind:?} {} at {size:?}", signal.name);
                let mut failing = plant.clone();
                failing.faults = vec![format!("{}.{} stuck", plant.name, signal.name)];
                let picture = drawn(&failing, moment, size);
                assert!(picture.contains(&format!("✗ {}.{} stuck", plant.name, signal.name)), "{kind:?} {}\n{picture}", signal.name);
                assert!(picture.matches('✗').count() > 1, "{kind:?} {} is not marked\n{picture}", signal.name);
            }
        }
    }
}

/// A long symbol of wide characters ends with dots where its column ends.
#[test]
fn wide_symbols_end_in_their_column() {
    let row = MOMENTS.iter().find(|row| row.kind == "conveyor").expect("a moment");
    let (mut plant, moment) = look(row);
    plant.symbols = (0..5).map(|bit| (format!("I 0.{bit}"), "非常停止押釦安全回路確認済".to_owned())).collect();
    let least = size(plant.kind).least;
    let picture = drawn(&plant, moment, least);
    // A cell is a character here, and the outputs stand in the right half.
    let ends: Vec<usize> = picture.lines().filter_map(|line| line.chars().position(|cell| cell == '…')).collect();
    assert!(ends.len() == 5 && ends.iter().all(|&end| end <= usize::from(least.width / 2)), "{ends:?}\n{picture}");
}

fn any_look() -> impl Strategy<Value = (PlantLook, Moment)> {
    let numbers = || {
        prop_oneof![
            4 => -1e3..1e3_f64,
            1 => prop::num::f64::ANY,
            1 => Just(f64::NAN),
            1 => Just(f64::INFINITY),
            1 => Just(f64::MAX),
        ]
    };
    let bytes = || prop::collection::vec(any::<u8>(), 0..20);
    let list = || prop::collection::vec(numbers(), 0..12);
    let faults = prop::collection::vec("[a-z]{0,4}.?[a-z_0-9]{0,8} ?.{0,60}", 0..4);
    (0..Kind::ALL.len(), bytes(), bytes(), list(), list(), any::<(u32, u32, u64)>(), faults, any::<bool>()).prop_map(
        |(index, inputs, outputs, parameters, values, (input, output, time_ms), faults, complete)| {
            let kind = Kind::ALL[index];
            let device = sieben_sim::devices::Device::new(DeviceSettings::new(kind));
            let state = device.state().into_iter().enumerate();
            let state = state.filter_map(|(index, (name, ..))| Some((name.to_owned(), *values.get(index)?))).collect();
            let parameters = if complete { DeviceSettings::new(kind).parameters } else { parameters };
            let name = kind.name.to_owned();
            let symbols = BTreeMap::from([(format!("I {input}.0"), "Überlauf_des_Behälters_ganz_oben_links".to_owned())]);
            (PlantLook { kind, name, input, output, parameters, inputs, outputs, state, faults, symbols }, Moment { time_ms })
        },
    )
}

proptest! {
    /// No bytes, state, parameters or area panic, and nothing is drawn outside of the area.
    #[test]
    fn a_picture_of_anything_stays_in_its_area(
        (plant, moment) in any_look(),
        (x, y, width, height) in (0_u16..20, 0_u16..20, 0_u16..300, 0_u16..100),
        palette in prop_oneof![Just(Palette::Colours), Just(Palette::Plain)],
    ) {
        let mut buffer = Buffer::filled(Rect::new(0, 0, 120, 60), ratatui::buffer::Cell::new("~"));
        let area = Rect::new(x, y, width, height);
        draw(&mut buffer, area, &plant, moment, palette);
        for row in 0..60 {
            for column in 0..120 {
                if !area.contains((column, row).into()) {
                    prop_assert_eq!(buffer[(column, row)].symbol(), "~");
                }
            }
        }
        let sizes = size(plant.kind);
        for size in [sizes.least, sizes.best] {
            drawn(&plant, moment, size);
        }
    }
}
