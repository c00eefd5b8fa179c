//! The master control relay: random programs with nested zones, writes and calls.

use proptest::prelude::*;
use sieben_model::address::Area;

use super::bench::{Bench, with};

/// What a program does, one statement or zone after another.
#[derive(Clone, Debug)]
enum Item {
    Activate,
    Deactivate,
    /// Sets the RLO and does something with a bit: `=`, `S`, `R`.
    Bit(bool, usize, usize),
    /// Transfers a number to a byte.
    Byte(u8, usize),
    /// A zone whose condition is this RLO.
    Zone(bool, Vec<Item>),
    /// A call of the function that does this; it begins with the relay inactive.
    Call(Vec<Item>),
}

fn item(depth: u32) -> BoxedStrategy<Item> {
    let simple = prop_oneof![
        1 => Just(Item::Activate),
        1 => Just(Item::Deactivate),
        4 => (any::<bool>(), 0..3_usize, 0..16_usize).prop_map(|(rlo, word, bit)| Item::Bit(rlo, word, bit)),
        2 => (any::<u8>(), 2..4_usize).prop_map(|(value, byte)| Item::Byte(value, byte)),
    ];
    if depth == 0 {
        return simple.boxed();
    }
    let inner = move || prop::collection::vec(item(depth - 1), 0..6);
    prop_oneof![
        4 => simple,
        3 => (any::<bool>(), inner()).prop_map(|(rlo, items)| Item::Zone(rlo, items)),
        1 => inner().prop_map(Item::Call),
    ]
    .boxed()
}

/// The text of a piece; the functions that it calls are added to `pieces`.
fn write(items: &[Item], pieces: &mut Vec<String>) -> String {
    let mut out = String::new();
    let set = |rlo: bool| if rlo { "SET; " } else { "CLR; " };
    for item in items {
        match item {
            Item::Activate => out.push_str("MCRA;\n"),
            Item::Deactivate => out.push_str("MCRD;\n"),
            Item::Bit(rlo, word, bit) => out.push_str(&format!("{}{} M {}.{};\n", set(*rlo), ["=", "S", "R"][*word], bit / 8, bit % 8)),
            Item::Byte(value, byte) => out.push_str(&format!("L {value}; T MB {byte};\n")),
            Item::Zone(rlo, items) => {
                let inside = write(items, pieces);
                out.push_str(&format!("{}MCR(;\n{inside})MCR;\n", set(*rlo)));
            }
            Item::Call(items) => {
                let callee = write(items, pieces);
                pieces.push(callee);
                out.push_str(&format!("UC FC {};\n", pieces.len()));
            }
        }
    }
    out
}

/// The relay by the manual: active or not in this block, and the conditions of the zones, which blocks share.
fn run(items: &[Item], active: &mut bool, zones: &mut Vec<bool>, memory: &mut [u8; 4]) {
    for item in items {
        let on = !*active || zones.iter().all(|&zone| zone);
        match item {
            Item::Activate => *active = true,
            Item::Deactivate => *active = false,
            Item::Bit(rlo, word, bit) => {
                let mask = 1 << (bit % 8);
                let byte = &mut memory[bit / 8];
                match word {
                    0 if on && *rlo => *byte |= mask,
                    0 => *byte &= !mask,
                    1 if on && *rlo => *byte |= mask,
                    2 if on && *rlo => *byte &= !mask,
                    _ => {}
                }
            }
            Item::Byte(value, byte) => memory[*byte] = if on { *value } else { 0 },
            Item::Zone(rlo, items) => {
                zones.push(*rlo);
                run(items, active, zones, memory);
                zones.pop();
            }
            Item::Call(items) => run(items, &mut false, zones, memory),
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 120, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_master_control_relay(items in prop::collection::vec(item(5), 1..12), start in any::<[u8; 4]>()) {
        let mut pieces = Vec::new();
        let main = write(&items, &mut pieces);
        pieces.push(main.clone());
        let mut bench = Bench::new("315-2PN/DP", &pieces);
        bench.machine.memory.area_mut(Area::BitMemory)[..4].copy_from_slice(&start);
        bench.run(pieces.len() - 1, with(false, 0)).expect("at most five zones are open");
        let mut expected = start;
        run(&items, &mut false, &mut Vec::new(), &mut expected);
        prop_assert_eq!(&bench.machine.memory.area_mut(Area::BitMemory)[..4], &expected[..], "{}\n{:?}", main, pieces);
    }
}
