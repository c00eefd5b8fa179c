//! R_STRNG, STRNG_R and the functions of selection and scaling against a second model.

use crate::call::{Call, R, S1};
use proptest::prelude::*;

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

/// All patterns of a REAL, the edges often.
fn real() -> impl Strategy<Value = f32> {
    prop_oneof![
        4 => any::<u32>().prop_map(f32::from_bits),
        2 => (-100_000..100_000_i32).prop_map(|number| number as f32 / 64.0),
        1 => (0_u32..40).prop_map(f32::from_bits),
        1 => proptest::sample::select(vec![0.0, -0.0, 1.0, -1.0, 10.0, 9.999_999, 0.1, f32::MAX, f32::MIN, f32::MIN_POSITIVE]),
    ]
}

/// The 14 characters by school arithmetic over all decimal digits that the number has; halves away from zero.
fn spelled(value: f32) -> String {
    let sign = if value.is_sign_negative() { '-' } else { '+' };
    if value == 0.0 {
        return format!("{sign}0.0000000E+00");
    }
    // A REAL has at most 149 digits behind the point, and Rust writes all of them.
    let text = format!("{:.150}", f64::from(value.abs()));
    let point = text.find('.').expect("a point was asked for") as i32;
    let digits: Vec<u32> = text.chars().filter_map(|c| c.to_digit(10)).collect();
    let first = digits.iter().position(|&digit| digit > 0).expect("it is not 0");
    let mut power = point - 1 - first as i32;
    let eight = digits.iter().skip(first).chain([&0; 9]).take(8).fold(0_u64, |number, &digit| number * 10 + u64::from(digit));
    let ninth = digits.get(first + 8).copied().unwrap_or(0);
    let mut number = eight + u64::from(ninth >= 5);
    if number == 100_000_000 {
        number = 10_000_000;
        power += 1;
    }
    format!("{sign}{}.{:07}E{}{:02}", number / 10_000_000, number % 10_000_000, if power < 0 { '-' } else { '+' }, power.abs())
}

#[test]
fn a_real_is_spelled_with_eight_exact_digits() {
    let call = Call::new("\"R_STRNG\" (IN := MD 0, RET_VAL := DB1.r)");
    let run = |value: f32, room: u8| {
        let mut state = call.state();
        state.put(0, &value.to_bits().to_be_bytes());
        state.put_string(R, room, b"");
        let good = call.run(&mut state);
        (String::from_utf8(state.string(R)).expect("only digits"), good)
    };
    assert_eq!(run(0.1, 14), ("+1.0000000E-01".to_owned(), true));
    assert_eq!(run(-1_048_576.0 - 0.25, 14), ("-1.0485763E+06".to_owned(), true), "a half goes away from zero");
    assert_eq!(run(f32::from_bits(1), 254), ("+1.4012985E-45".to_owned(), true));
    assert_eq!(run(f32::MAX, 14), ("+3.4028235E+38".to_owned(), true));
    proptest!(config(600), |(value in real(), room in prop_oneof![Just(14_u8), 12_u8..17])| {
        let (text, good) = run(value, room);
        prop_assert_eq!(good, room >= 14 && value.is_finite());
        prop_assert_eq!(text, if good { spelled(value) } else { String::new() }, "{:e}", value);
    });
}

#[test]
fn a_string_is_read_as_the_nearest_real() {
    let call = Call::new("\"STRNG_R\" (S := DB1.s1, RET_VAL := MD 10)");
    const KEPT: u32 = 0x5A5A_5A5A;
    let run = |text: &str| {
        let mut state = call.state();
        state.put(10, &KEPT.to_be_bytes());
        state.put_string(S1, 254, text.as_bytes());
        let good = call.run(&mut state);
        (state.double_word(10), good)
    };
    let check = |text: &str| {
        let (bits, good) = run(text);
        let form = text.bytes().zip("+0.0000000E+00".bytes()).all(|(c, form)| match form {
            b'0' => c.is_ascii_digit(),
            b'+' => c == b'+' || c == b'-',
            other => c == other,
        });
        // Rust reads decimal numbers to the nearest, halves to the even one.
        let expected = text.parse::<f32>().ok().filter(|value| form && text.len() == 14 && value.is_finite());
        assert_eq!((bits, good), (expected.map_or(KEPT, f32::to_bits), expected.is_some()), "{text}");
    };
    for text in [
        "+0.0000000E+00",
        "-0.0000000E-99",
        "+0.0000000E+99",
        "+1.0000000E+00",
        "-1.2500000E+03",
        "+3.4028235E+38",
        "+3.4028236E+38",
        "+3.4028234E+38",
        "+9.9999999E+99",
        "+0.0000034E+44",
        "+0.0000001E+45",
        "+1.1754944E-38",
        "+1.1754942E-38",
        "+1.4012985E-45",
        "+0.7006492E-45",
        "+0.7006493E-45",
        "+2.1019476E-45",
        "+1.0000000E-99",
        "+1.6777217E+07",
        "+1.6777219E+07",
        "",
        "+1.0000000E+0",
        "+1.0000000E+000",
        "1.00000000E+00",
        "+1,0000000E+00",
        "+1.0000000e+00",
        "+1.0000000E 00",
        "+1.00000a0E+00",
        "+1.0000000E+0x",
    ] {
        check(text);
    }
    proptest!(config(600), |(value in real(), form in "[+-][0-9]\\.[0-9]{7}E[+-][0-5][0-9]", change in 0_usize..14, by in any::<u8>())| {
        check(&form);
        if value.is_finite() {
            let text = spelled(value);
            check(&text);
            let mut bytes = text.into_bytes();
            bytes[change] = by & 0x7F;
            check(&String::from_utf8(bytes).expect("below 128"));
        }
    });
}

#[test]
fn analog_values_are_scaled_as_the_formula_says() {
    let scale = Call::new("\"SCALE\" (IN := MW 0, HI_LIM := MD 2, LO_LIM := MD 6, BIPOLAR := M 10.0, RET_VAL := MW 12, OUT := MD 14)");
    let unscale = Call::new("\"UNSCALE\" (IN := MD 14, HI_LIM := MD 2, LO_LIM := MD 6, BIPOLAR := M 10.0, RET_VAL := MW 12, OUT := MW 0)");
    let limits = (-1000.0_f32..1000.0, 1.0_f32..1000.0, any::<bool>());
    proptest!(config(500), |(input in prop_oneof![any::<i16>(), -27650..=27650_i16], (low, span, turned) in limits, bipolar in any::<bool>())| {
        let (low, high) = if turned { (low + span, low) } else { (low, low + span) };
        let first = if bipolar { -27648.0_f64 } else { 0.0 };
        let mut state = scale.state();
        state.put(0, &input.to_be_bytes());
        state.put(2, &high.to_bits().to_be_bytes());
        state.put(6, &low.to_bits().to_be_bytes());
        state.put(10, &[u8::from(bipolar)]);
        let good = scale.run(&mut state);
        let inside = (first..=27648.0).contains(&f64::from(input));
        prop_assert_eq!((good, state.word(12)), (inside, if inside { 0 } else { 8 }));
        let out = f32::from_bits(state.double_word(14));
        let part = ((f64::from(input) - first) / (27648.0 - first)).clamp(0.0, 1.0);
        let exact = part * (f64::from(high) - f64::from(low)) + f64::from(low);
        // Four operations in REAL on numbers up to 2000.
        prop_assert!((f64::from(out) - exact).abs() < 1.0E-3, "{} {}", out, exact);
        if inside {
            let mut back = unscale.state();
            for at in [2, 6, 14] {
                back.put(at, &state.double_word(at).to_be_bytes());
            }
            back.put(10, &[u8::from(bipolar)]);
            let good = unscale.run(&mut back);
            // What lies at the end of the range may have been rounded beyond it.
            let at_end = !(1.0E-4..=1.0 - 1.0E-4).contains(&part);
            prop_assert!(at_end || good && back.word(12) == 0);
            prop_assert!((i32::from(back.word(0)) - i32::from(input)).abs() <= 55296 / span as i32 / 500 + 6, "{} {}", back.word(0), input);
        }
    });
}

#[test]
fn bits_are_counted_and_complemented_as_in_the_model() {
    let count = Call::new("\"BITSUM\" (IN := MD 0, RET_VAL := MW 10)");
    let encode = Call::new("\"ENCO\" (IN := MD 0, RET_VAL := MW 10)");
    let decode = Call::new("\"DECO\" (IN := MW 0, RET_VAL := MD 10)");
    let complement = Call::new("\"BCDCPL\" (IN := MD 0, RET_VAL := MD 10)");
    proptest!(config(300), |(bits in any::<u32>(), shift in 0_u32..32, number in 0_u32..10_000_000)| {
        let run = |call: &Call, input: u32| {
            let mut state = call.state();
            state.put(0, &input.to_be_bytes());
            let good = call.run(&mut state);
            (state, good)
        };
        for input in [bits, bits << shift, bits >> shift, 0] {
            let (state, good) = run(&count, input);
            prop_assert_eq!((state.word(10) as u32, good), (input.count_ones(), true));
            let (state, good) = run(&encode, input);
            prop_assert_eq!((state.word(10) as u32, good), (if input == 0 { 0 } else { input.trailing_zeros() }, input != 0));
            let (state, _) = run(&decode, input);
            prop_assert_eq!(state.double_word(10), 1 << ((input >> 16) % 32));
        }
        let bcd = |number: u32| u32::from_str_radix(&number.to_string(), 16).expect("decimal digits");
        let (state, _) = run(&complement, bcd(number));
        prop_assert_eq!(state.double_word(10), bcd(10_000_000 - number));
    });
}

/// Bytes of bit memory as a number of a type: INT and DINT as they are, REAL without what is no number.
fn number(data_type: &str, bits: u32) -> Option<f64> {
    match data_type {
        "INT" => Some(f64::from((bits >> 16) as u16 as i16)),
        "DINT" => Some(f64::from(bits as i32)),
        _ => Some(f64::from(f32::from_bits(bits))).filter(|number| number.is_finite()),
    }
}

#[test]
fn selections_choose_as_the_model_does() {
    const KEPT: u32 = 0x5A5A_5A5A;
    let bits = || {
        prop_oneof![any::<u32>(), real().prop_map(f32::to_bits), (-3_i16..3).prop_map(|small| u32::from(small as u16) << 16 | 1), 0_u32..4]
    };
    for data_type in ["INT", "DINT", "REAL"] {
        let place = |byte: u32| format!("P#M {byte}.0 {data_type} 1");
        let (a, b, c, out) = (place(0), place(4), place(8), place(12));
        let limit = Call::new(&format!("\"LIMIT\" (MN := {a}, IN := {b}, MX := {c}, RET_VAL := {out})"));
        let max = Call::new(&format!("\"MAX\" (IN1 := {a}, IN2 := {b}, IN3 := {c}, RET_VAL := {out})"));
        let min = Call::new(&format!("\"MIN\" (IN1 := {a}, IN2 := {b}, IN3 := {c}, RET_VAL := {out})"));
        let select = Call::new(&format!("\"SEL\" (G := M 16.0, IN0 := {a}, IN1 := {b}, RET_VAL := {out})"));
        proptest!(config(300), |(values in [bits(), bits(), bits()], gate in any::<bool>())| {
            let run = |call: &Call| {
                let mut state = call.state();
                for (at, value) in [0, 4, 8].into_iter().zip(values) {
                    state.put(at, &value.to_be_bytes());
                }
                state.put(12, &KEPT.to_be_bytes());
                state.put(16, &[u8::from(gate)]);
                let good = call.run(&mut state);
                (state.double_word(12), good)
            };
            let numbers: Option<Vec<f64>> = values.iter().map(|&value| number(data_type, value)).collect();
            let largest = numbers.as_ref().map(|all| all.iter().copied().fold(f64::MIN, f64::max));
            let smallest = numbers.as_ref().map(|all| all.iter().copied().fold(f64::MAX, f64::min));
            let between = numbers.as_ref().filter(|all| all[0] <= all[2]).map(|all| all[1].clamp(all[0], all[2]));
            for (name, call, expected) in [("MAX", &max, largest), ("MIN", &min, smallest), ("LIMIT", &limit, between)] {
                let (bits, good) = run(call);
                prop_assert_eq!(good, expected.is_some(), "{} {} {:X?}", name, data_type, values);
                match expected {
                    Some(_) => prop_assert_eq!(number(data_type, bits), expected, "{} {} {:X?}", name, data_type, values),
                    None => prop_assert_eq!(bits, KEPT, "{} {} {:X?}", name, data_type, values),
                }
            }
            // SEL compares nothing: every pattern goes through.
            let (bits, good) = run(&select);
            let chosen = values[usize::from(gate)];
            let expected = if data_type == "INT" { chosen & 0xFFFF_0000 | KEPT & 0xFFFF } else { chosen };
            prop_assert_eq!((bits, good), (expected, true), "SEL {} {:X?}", data_type, values);
        });
    }
}
