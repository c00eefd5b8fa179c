//! What instructions do against a second model, written from the manual's words with i128 and f64 and without a type of
//! the engine. Values are random; edges come often. Arithmetic, comparison, shift and conversion stand here.

mod accumulators;
mod addresses;
mod bench;
mod jumps;
mod logic;
mod relay;
mod timers_and_counters;

use std::collections::HashMap;
use std::sync::{Arc, LazyLock, Mutex};

use proptest::prelude::*;
use sieben_engine::machine::Registers;
use sieben_engine::{Context, Engine, Entry, Exit, Layout, Machine, Program};
use sieben_lang::stl::instructions::Instruction;
use sieben_lang::stl::lower::{ResolvedBlock, Statement, lower};
use sieben_lang::stl::operands::Operand;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::interface::Interface;
use sieben_model::literal::Value;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::origin::Origin;
use sieben_model::source::Span;

use crate::strict::Strict;

/// What an instruction leaves: ACCU 1, CC 1, CC 0, OV, RLO (where it writes them), or a fault.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Outcome {
    accu1: u32,
    cc: Option<(bool, bool)>,
    overflow: Option<bool>,
    rlo: Option<bool>,
    fault: bool,
}

/// Loaded one-statement programs by word and constant.
type Cache = HashMap<(String, Option<i16>), Arc<(Arc<dyn Engine>, Arc<Layout>)>>;

static LOADED: LazyLock<Mutex<Cache>> = LazyLock::new(Default::default);

/// Runs one instruction through table, IR and interpreter.
fn engine(word: &str, operand: Option<i16>, accu1: u32, accu2: u32) -> Outcome {
    let mut cache = LOADED.lock().expect("no panic while loading");
    let loaded = Arc::clone(cache.entry((word.to_owned(), operand)).or_insert_with(|| {
        let operand = operand.map_or(Operand::None, |value| Operand::Constant(Value::Int(value)));
        let instruction = Instruction::candidates(word, Mnemonics::English)
            .find(|row| row.operand().accepts(&operand))
            .unwrap_or_else(|| panic!("`{word}` is in the table"));
        let statements = vec![Statement { instruction, operand, origin: Origin::Text { span: Span::default(), network: 1 }, stated: None }];
        let block = ResolvedBlock { id: BlockId::ob(1), interface: Interface::default(), statements, titles: Vec::new() };
        let mut program = Program::default();
        program.code.insert(block.id, lower(&block, &CpuType::default()));
        let layout = Arc::new(Layout::new(&CpuType::default(), &program));
        Arc::new((crate::LOAD(&program, &layout), layout))
    }));
    drop(cache);
    let mut machine = Machine::new(loaded.1.clone());
    let registers = Registers { accu1: u64::from(accu1), accu2: u64::from(accu2), ..Registers::fresh() };
    let entry = Entry { block: BlockId::ob(1), start_information: [0; 20], registers: Some(Box::new(registers)) };
    let exit = loaded.0.run(&mut Context { machine: &mut machine, host: &mut Strict, tracer: None }, &entry);
    let after = &machine.registers;
    Outcome {
        accu1: after.accu1 as u32,
        cc: Some((after.cc1 == 1, after.cc0 == 1)),
        overflow: Some(after.ov == 1),
        rlo: Some(after.rlo == 1),
        fault: exit != Exit::Finished,
    }
}

fn low(value: u32) -> i128 {
    i128::from(value as u16 as i16)
}

fn whole(value: u32) -> i128 {
    i128::from(value as i32)
}

fn sign(value: i128) -> (bool, bool) {
    (value > 0, value < 0)
}

/// The number that stays when only so many bits are kept.
fn wrap(value: i128, bits: u32) -> i128 {
    let modulus = 1_i128 << bits;
    let rest = value.rem_euclid(modulus);
    if rest >= modulus / 2 { rest - modulus } else { rest }
}

fn fits(value: i128, bits: u32) -> bool {
    wrap(value, bits) == value
}

/// Integer arithmetic by the manual; `None` for words that are not integer arithmetic.
fn integer(word: &str, accu1: u32, accu2: u32) -> Option<Outcome> {
    let high = accu1 & 0xFFFF_0000;
    let with_low = |value: i128| high | (value as u32 & 0xFFFF);
    let outcome = |accu1, cc, overflow| Outcome { accu1, cc: Some(cc), overflow: Some(overflow), ..Outcome::default() };
    let by_zero = outcome(accu1, (true, true), true);
    Some(match word {
        "+I" | "-I" => {
            let exact = if word == "+I" { low(accu2) + low(accu1) } else { low(accu2) - low(accu1) };
            outcome(with_low(exact), sign(wrap(exact, 16)), !fits(exact, 16))
        }
        "*I" => {
            let exact = low(accu2) * low(accu1);
            outcome(exact as u32, sign(exact), !fits(exact, 16))
        }
        "/I" if low(accu1) == 0 => by_zero,
        "/I" => {
            let (quotient, remainder) = (low(accu2) / low(accu1), low(accu2) % low(accu1));
            outcome((remainder as u32) << 16 | quotient as u32 & 0xFFFF, sign(quotient), !fits(quotient, 16))
        }
        "+D" | "-D" => {
            let exact = if word == "+D" { whole(accu2) + whole(accu1) } else { whole(accu2) - whole(accu1) };
            outcome(exact as u32, sign(wrap(exact, 32)), !fits(exact, 32))
        }
        "*D" => {
            let exact = whole(accu2) * whole(accu1);
            outcome(exact as u32, sign(exact), !fits(exact, 32))
        }
        "/D" | "MOD" if accu1 == 0 => by_zero,
        "/D" => {
            let exact = whole(accu2) / whole(accu1);
            outcome(exact as u32, sign(exact), !fits(exact, 32))
        }
        "MOD" => {
            let exact = whole(accu2) % whole(accu1);
            outcome(exact as u32, sign(exact), false)
        }
        "NEGI" => outcome(with_low(-low(accu1)), sign(wrap(-low(accu1), 16)), !fits(-low(accu1), 16)),
        "NEGD" => outcome(-whole(accu1) as u32, sign(wrap(-whole(accu1), 32)), !fits(-whole(accu1), 32)),
        _ => return None,
    })
}

/// Shifts and rotations bit by bit.
fn shift(word: &str, accu1: u32, count: u32) -> Outcome {
    let width = if word.ends_with('W') || word == "SSI" { 16 } else { 32 };
    let mask = if width == 16 { 0xFFFF } else { u32::MAX };
    let mut value = accu1 & mask;
    let negative = value >> (width - 1) & 1;
    let mut out = 0;
    for _ in 0..count {
        match word {
            "SLW" | "SLD" => {
                out = value >> (width - 1) & 1;
                value = value << 1 & mask;
            }
            "SRW" | "SRD" => {
                out = value & 1;
                value >>= 1;
            }
            "SSI" | "SSD" => {
                out = value & 1;
                value = value >> 1 | negative << (width - 1);
            }
            "RLD" => {
                out = value >> 31;
                value = value << 1 | out;
            }
            _ => {
                out = value & 1;
                value = value >> 1 | out << 31;
            }
        }
    }
    Outcome { accu1: accu1 & !mask | value, cc: Some((out == 1, false)), overflow: Some(false), ..Outcome::default() }
}

fn compare(word: &str, accu1: u32, accu2: u32) -> Outcome {
    let (a, b) = if word.ends_with('I') { (low(accu2), low(accu1)) } else { (whole(accu2), whole(accu1)) };
    let rlo = match &word[..word.len() - 1] {
        "==" => a == b,
        "<>" => a != b,
        ">" => a > b,
        "<" => a < b,
        ">=" => a >= b,
        _ => a <= b,
    };
    Outcome { accu1, cc: Some((a > b, a < b)), overflow: Some(false), rlo: Some(rlo), fault: false }
}

/// REAL arithmetic: exact in f64 up to one rounding for sums and products of singles, so rounding once more gives the single.
fn real(word: &str, accu1: u32, accu2: u32) -> Outcome {
    let (a, b) = (f64::from(f32::from_bits(accu2)), f64::from(f32::from_bits(accu1)));
    let exact = match word {
        "+R" => a + b,
        "-R" => a - b,
        "*R" => a * b,
        _ => a / b,
    };
    let single = exact as f32;
    let tiny = single != 0.0 && single.abs() < f32::MIN_POSITIVE;
    let vanished = single == 0.0 && exact != 0.0;
    let invalid = exact.is_nan();
    let cc = match () {
        () if invalid => (true, true),
        () if tiny || single == 0.0 => (false, false),
        () => (single > 0.0, single < 0.0),
    };
    let overflow = invalid || single.is_infinite() || tiny || vanished;
    let accu1 = if invalid { 0x7FC0_0000 } else { single.to_bits() };
    Outcome { accu1, cc: Some(cc), overflow: Some(overflow), ..Outcome::default() }
}

/// Digits of a decimal number as BCD.
fn digits(mut value: u32, count: u32) -> u32 {
    let mut bcd = 0;
    for digit in 0..count {
        bcd |= (value % 10) << (4 * digit);
        value /= 10;
    }
    bcd
}

/// Values at the edges of every type, and any other.
fn accumulator() -> impl Strategy<Value = u32> {
    prop_oneof![
        any::<u32>(),
        any::<u16>().prop_map(u32::from),
        prop::sample::select(vec![
            0,
            1,
            2,
            0x7FFF,
            0x8000,
            0x8001,
            0xFFFF,
            0x7FFF_FFFF,
            0x8000_0000,
            0xFFFF_FFFF,
            0x0001_0000,
            0x3F80_0000,
            0xBF80_0000,
            0x0080_0000,
            0x007F_FFFF,
            0x0000_0001,
            0x7F7F_FFFF,
            0x7F80_0000,
            0xFF80_0000,
            0x7FC0_0000,
        ]),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn integers(accu1 in accumulator(), accu2 in accumulator()) {
        for word in ["+I", "-I", "*I", "/I", "+D", "-D", "*D", "/D", "MOD", "NEGI", "NEGD"] {
            let expected = integer(word, accu1, accu2).expect("integer arithmetic");
            let got = Outcome { rlo: None, ..engine(word, None, accu1, accu2) };
            prop_assert_eq!(got, expected, "{} on {:#x}, {:#x}", word, accu1, accu2);
        }
    }

    #[test]
    fn shifts(accu1 in accumulator(), accu2 in any::<u32>(), count in prop_oneof![0..40_u32, 0..256_u32]) {
        for word in ["SLW", "SRW", "SSI", "SLD", "SRD", "SSD", "RLD", "RRD"] {
            let accu2 = accu2 & !0xFF | count;
            let got = Outcome { rlo: None, ..engine(word, None, accu1, accu2) };
            let mut expected = shift(word, accu1, count);
            if count == 0 {
                expected.cc = Some((false, false));
            }
            prop_assert_eq!(got, expected, "{} of {:#x} by {}", word, accu1, count);
            let constant = i16::try_from(count).ok().filter(|&count| count <= if word.ends_with('W') || word == "SSI" { 15 } else { 32 });
            if let Some(constant) = constant {
                let got = Outcome { rlo: None, ..engine(word, Some(constant), accu1, 0) };
                prop_assert_eq!(got, expected, "{} {} of {:#x}", word, constant, accu1);
            }
        }
    }

    #[test]
    fn comparisons(accu1 in accumulator(), accu2 in accumulator()) {
        for word in ["==I", "<>I", ">I", "<I", ">=I", "<=I", "==D", "<>D", ">D", "<D", ">=D", "<=D"] {
            prop_assert_eq!(engine(word, None, accu1, accu2), compare(word, accu1, accu2), "{} on {:#x}, {:#x}", word, accu1, accu2);
        }
    }

    #[test]
    fn reals(accu1 in accumulator(), accu2 in accumulator()) {
        for word in ["+R", "-R", "*R", "/R"] {
            let got = Outcome { rlo: None, ..engine(word, None, accu1, accu2) };
            prop_assert_eq!(got, real(word, accu1, accu2), "{} on {:#x}, {:#x}", word, accu1, accu2);
        }
    }

    #[test]
    fn real_comparisons(accu1 in accumulator(), accu2 in accumulator()) {
        let (a, b) = (f64::from(f32::from_bits(accu2)), f64::from(f32::from_bits(accu1)));
        let unordered = a.is_nan() || b.is_nan();
        for (word, holds) in [("==R", a == b), ("<>R", a != b), (">R", a > b), ("<R", a < b), (">=R", a >= b), ("<=R", a <= b)] {
            let expected = Outcome {
                accu1,
                cc: Some(if unordered { (true, true) } else { (a > b, a < b) }),
                overflow: Some(unordered),
                // A number that is none is not even unequal.
                rlo: Some(holds && !unordered),
                fault: false,
            };
            prop_assert_eq!(engine(word, None, accu1, accu2), expected, "{} on {:#x}, {:#x}", word, accu1, accu2);
        }
    }

    #[test]
    fn words_and_signs(accu1 in accumulator(), accu2 in accumulator()) {
        let high = accu1 & 0xFFFF_0000;
        for (word, result) in [
            ("AW", high | accu1 & accu2 & 0xFFFF),
            ("OW", high | (accu1 | accu2) & 0xFFFF),
            ("XOW", high | (accu1 ^ accu2) & 0xFFFF),
            ("AD", accu1 & accu2),
            ("OD", accu1 | accu2),
            ("XOD", accu1 ^ accu2),
        ] {
            let counted = if word.ends_with('W') { result & 0xFFFF } else { result };
            let expected = Outcome { accu1: result, cc: Some((counted != 0, false)), overflow: Some(false), ..Outcome::default() };
            prop_assert_eq!(Outcome { rlo: None, ..engine(word, None, accu1, accu2) }, expected, "{} on {:#x}, {:#x}", word, accu1, accu2);
        }
        for (word, result) in [
            ("ABS", accu1 & 0x7FFF_FFFF),
            ("NEGR", accu1 ^ 0x8000_0000),
            ("INVI", accu1 ^ 0xFFFF),
            ("INVD", !accu1),
            ("ITD", low(accu1) as u32),
            ("DTR", (whole(accu1) as f64 as f32).to_bits()),
        ] {
            let got = engine(word, None, accu1, accu2);
            prop_assert_eq!((got.accu1, got.cc, got.overflow), (result, Some((false, false)), Some(false)), "{} on {:#x}", word, accu1);
        }
    }

    #[test]
    fn rotations_through_cc1(accu1 in any::<u32>(), before in any::<u16>()) {
        for (word, left) in [("RLDA", true), ("RRDA", false)] {
            let mut bench = bench::Bench::new("416-3", &[format!("{word};")]);
            let mut registers = Registers { accu1: u64::from(accu1), ..Registers::fresh() };
            registers.set_status(sieben_engine::machine::StatusWord(before & 0x1FF));
            let cc1 = before >> 7 & 1 == 1;
            // A ring of 33 bits: ACCU 1 and CC 1.
            let (result, out) = if left {
                (accu1 << 1 | u32::from(cc1), accu1 >> 31 == 1)
            } else {
                (accu1 >> 1 | u32::from(cc1) << 31, accu1 & 1 == 1)
            };
            let after = bench.run(0, registers).expect("a rotation does not fail");
            prop_assert_eq!((after.accu1, after.cc1 == 1, after.cc0, after.ov), (u64::from(result), out, 0, 0), "{} of {:#x}", word, accu1);
        }
    }

    #[test]
    fn bcd_there_and_back(accu1 in accumulator(), number in -1_100_i32..1_100, large in -11_000_000_i32..11_000_000) {
        let high = accu1 & 0xFFFF_0000;
        let magnitude = number.unsigned_abs();
        let got = engine("ITB", None, high | number as u32 & 0xFFFF, 0);
        let bcd = digits(magnitude, 3) | if number < 0 { 0xF000 } else { 0 };
        let expected = if magnitude > 999 { number as u32 & 0xFFFF } else { bcd };
        prop_assert_eq!((got.accu1, got.overflow), (high | expected, Some(magnitude > 999)));
        if magnitude <= 999 {
            prop_assert_eq!(engine("BTI", None, high | bcd, 0).accu1, high | number as u32 & 0xFFFF);
        }
        let magnitude = large.unsigned_abs();
        let got = engine("DTB", None, large as u32, 0);
        let bcd = digits(magnitude, 7) | if large < 0 { 0xF000_0000 } else { 0 };
        let expected = if magnitude > 9_999_999 { large as u32 } else { bcd };
        prop_assert_eq!((got.accu1, got.overflow), (expected, Some(magnitude > 9_999_999)));
        if magnitude <= 9_999_999 {
            prop_assert_eq!(engine("BTD", None, bcd, 0).accu1, large as u32);
        }
        let seven = (0..7).all(|digit| accu1 >> (4 * digit) & 0xF <= 9);
        prop_assert_eq!(engine("BTD", None, accu1, 0).fault, !seven, "a bad digit in {:#x}", accu1);
        let valid = (0..3).all(|digit| accu1 >> (4 * digit) & 0xF <= 9);
        prop_assert_eq!(engine("BTI", None, accu1, 0).fault, !valid, "a bad digit in {:#x}", accu1);
    }

    #[test]
    fn roundings(accu1 in prop_oneof![accumulator(), (-3_000_000_i32..3_000_000).prop_map(|half| (half as f32 / 2.0).to_bits())]) {
        let value = f64::from(f32::from_bits(accu1));
        for (word, rounded) in [("RND+", value.ceil()), ("RND-", value.floor()), ("TRUNC", value.trunc()), ("RND", {
            let floor = value.floor();
            let up = if value - floor == 0.5 { floor % 2.0 != 0.0 } else { value - floor > 0.5 };
            if up { floor + 1.0 } else { floor }
        })] {
            let fits = (-2_147_483_648.0..=2_147_483_647.0).contains(&rounded);
            let got = engine(word, None, accu1, 0);
            let expected = if fits { rounded as i64 as u32 } else { accu1 };
            prop_assert_eq!((got.accu1, got.overflow), (expected, Some(!fits)), "{} of {}", word, value);
        }
    }
}
