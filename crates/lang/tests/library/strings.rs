//! The string functions of the library against a second model, written over slices from the words of the manual.

use crate::call::{Call, R, S1, S2};
use proptest::prelude::*;

/// What a function leaves: the string before it is cut, and whether nothing was wrong.
type Made = (Vec<u8>, bool);

fn left(text: &[u8], l: i16) -> Made {
    match usize::try_from(l) {
        Ok(l) => (text[..l.min(text.len())].to_vec(), true),
        Err(_) => (Vec::new(), false),
    }
}

fn right(text: &[u8], l: i16) -> Made {
    match usize::try_from(l) {
        Ok(l) => (text[text.len() - l.min(text.len())..].to_vec(), true),
        Err(_) => (Vec::new(), false),
    }
}

fn mid(text: &[u8], l: i16, p: i16) -> Made {
    if l < 1 || p < 1 || usize::try_from(p).is_ok_and(|p| p > text.len()) {
        return (Vec::new(), false);
    }
    let start = p as usize - 1;
    (text[start..text.len().min(start + l as usize)].to_vec(), true)
}

fn delete(text: &[u8], l: i16, p: i16) -> Made {
    if l < 0 || p < 0 {
        return (Vec::new(), false);
    }
    if l == 0 || p == 0 || p as usize > text.len() {
        return (text.to_vec(), true);
    }
    let start = p as usize - 1;
    let end = text.len().min(start + l as usize);
    ([&text[..start], &text[end..]].concat(), true)
}

fn insert(text: &[u8], other: &[u8], p: i16) -> Made {
    let Ok(p) = usize::try_from(p) else { return (Vec::new(), false) };
    let (head, tail) = text.split_at(p.min(text.len()));
    ([head, other, tail].concat(), true)
}

fn replace(text: &[u8], other: &[u8], l: i16, p: i16) -> Made {
    if l < 0 || p < 0 {
        return (Vec::new(), false);
    }
    if l == 0 {
        return (text.to_vec(), true);
    }
    let start = (p.max(1) as usize - 1).min(text.len());
    let end = text.len().min(start + l as usize);
    ([&text[..start], other, &text[end..]].concat(), true)
}

fn find(text: &[u8], other: &[u8]) -> i16 {
    if other.is_empty() || other.len() > text.len() {
        return 0;
    }
    text.windows(other.len()).position(|window| window == other).map_or(0, |at| at as i16 + 1)
}

/// A function that makes a string: its call with `R` in place of the result, and the model.
struct Maker {
    call: &'static str,
    model: fn(&[u8], &[u8], i16, i16) -> Made,
}

const MAKERS: &[Maker] = &[
    Maker { call: "\"CONCAT\" (IN1 := DB1.s1, IN2 := DB1.s2, RET_VAL := R)", model: |a, b, _, _| ([a, b].concat(), true) },
    Maker { call: "\"LEFT\" (IN := DB1.s1, L := MW 0, RET_VAL := R)", model: |a, _, l, _| left(a, l) },
    Maker { call: "\"RIGHT\" (IN := DB1.s1, L := MW 0, RET_VAL := R)", model: |a, _, l, _| right(a, l) },
    Maker { call: "\"MID\" (IN := DB1.s1, L := MW 0, P := MW 2, RET_VAL := R)", model: |a, _, l, p| mid(a, l, p) },
    Maker { call: "\"DELETE\" (IN := DB1.s1, L := MW 0, P := MW 2, RET_VAL := R)", model: |a, _, l, p| delete(a, l, p) },
    Maker { call: "\"INSERT\" (IN1 := DB1.s1, IN2 := DB1.s2, P := MW 2, RET_VAL := R)", model: |a, b, _, p| insert(a, b, p) },
    Maker {
        call: "\"REPLACE\" (IN1 := DB1.s1, IN2 := DB1.s2, L := MW 0, P := MW 2, RET_VAL := R)",
        model: |a, b, l, p| replace(a, b, l, p),
    },
];

/// Where the inputs and the result of a call lie: one variable may stand for several.
const PLACES: &[(&str, &str, usize)] =
    &[("DB1.s2", "DB1.r", R), ("DB1.s2", "DB1.s1", S1), ("DB1.s2", "DB1.s2", S2), ("DB1.s1", "DB1.r", R), ("DB1.s1", "DB1.s1", S1)];

fn text(longest: usize) -> impl Strategy<Value = Vec<u8>> {
    prop_oneof![
        proptest::collection::vec(b'a'..=b'c', 0..8),
        proptest::collection::vec(any::<u8>(), 0..=longest),
        proptest::collection::vec(any::<u8>(), longest..=longest),
    ]
}

fn number() -> impl Strategy<Value = i16> {
    prop_oneof![4 => -2_i16..12, 1 => 240_i16..260, 1 => any::<i16>(), 1 => prop_oneof![Just(i16::MIN), Just(i16::MAX)]]
}

#[test]
fn functions_that_make_strings_do_as_the_model_whatever_lies_where() {
    let calls: Vec<Vec<Call>> = MAKERS
        .iter()
        .map(|maker| {
            let place = |&(second, result, _): &(&str, &str, usize)| {
                Call::new(&maker.call.replace("DB1.s2", second).replace(":= R", &format!(":= {result}")))
            };
            PLACES.iter().map(place).collect()
        })
        .collect();
    let inputs = (text(254), text(254), prop_oneof![Just(254_u8), 0_u8..12, any::<u8>().prop_map(|max| max.min(254))], number(), number());
    let config = ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() };
    proptest!(config, |((first, second, maximum, l, p) in inputs)| {
        for (maker, calls) in MAKERS.iter().zip(&calls) {
            for (call, &(second_place, result_place, result)) in calls.iter().zip(PLACES) {
                let mut state = call.state();
                state.put_string(S1, 254, &first);
                state.put_string(S2, 254, &second);
                if result == R {
                    state.put_string(R, maximum, b"");
                }
                state.put(0, &l.to_be_bytes());
                state.put(2, &p.to_be_bytes());
                let before = state.data(0, 792).to_vec();
                let good = call.run(&mut state);
                let other = if second_place == "DB1.s1" { &first } else { &second };
                let (whole, well) = (maker.model)(&first, other, l, p);
                let room = usize::from(if result == R { maximum } else { 254 });
                let cut = &whole[..room.min(whole.len())];
                prop_assert_eq!(state.string(result), cut, "{} {} {}: {:?} {:?} {} {}", maker.call, second_place, result_place, &first, &second, l, p);
                prop_assert_eq!(good, well && whole.len() <= room, "BR of {}", maker.call);
                let end = result + 2 + room;
                prop_assert_eq!(&state.data(0, 792)[..result], &before[..result], "nothing in front of the result");
                prop_assert_eq!(&state.data(0, 792)[end..], &before[end..], "nothing behind the result");
            }
        }
    });
}

#[test]
fn comparisons_and_find_do_as_the_model() {
    type Compare = fn(&[u8], &[u8]) -> bool;
    let compares: &[(&str, Compare)] = &[
        ("EQ_STRNG", |a, b| a == b),
        ("NE_STRNG", |a, b| a != b),
        ("GT_STRNG", |a, b| a > b),
        ("GE_STRNG", |a, b| a >= b),
        ("LT_STRNG", |a, b| a < b),
        ("LE_STRNG", |a, b| a <= b),
    ];
    let calls: Vec<(Call, Compare)> = compares
        .iter()
        .map(|&(name, compare)| (Call::new(&format!("\"{name}\" (S1 := DB1.s1, S2 := DB1.s2, RET_VAL := M 10.0)")), compare))
        .collect();
    let finding = Call::new("\"FIND\" (IN1 := DB1.s1, IN2 := DB1.s2, RET_VAL := MW 10)");
    let length = Call::new("\"LEN\" (S := DB1.s1, RET_VAL := MW 10)");
    let config = ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() };
    let same_start = (text(254), 0_usize..6).prop_map(|(text, drop)| {
        let end = text.len().saturating_sub(drop);
        let part = text[drop.min(end)..end].to_vec();
        (text, part)
    });
    let pairs = prop_oneof![(text(254), text(254)), text(254).prop_map(|text| (text.clone(), text)), same_start];
    proptest!(config, |((first, second) in pairs)| {
        let run = |call: &Call| {
            let mut state = call.state();
            state.put_string(S1, 254, &first);
            state.put_string(S2, 254, &second);
            assert!(call.run(&mut state), "BR is 1");
            state
        };
        for (call, compare) in &calls {
            let result = run(call).double_word(10) >> 24;
            prop_assert_eq!(result == 1, compare(&first, &second));
        }
        prop_assert_eq!(run(&finding).word(10), find(&first, &second), "{:?} in {:?}", &second, &first);
        prop_assert_eq!(run(&length).word(10), first.len() as i16);
    });
}

#[test]
fn a_damaged_header_ends_no_call_and_writes_nothing_outside() {
    let config = ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() };
    let calls: Vec<Call> = MAKERS.iter().map(|maker| Call::new(&maker.call.replace(":= R", ":= DB1.r"))).collect();
    proptest!(config, |(headers in any::<[u8; 5]>(), room in 0_u8..=254, l in number(), p in number())| {
        for call in &calls {
            let mut state = call.state();
            state.data(S1, 2).copy_from_slice(&headers[..2]);
            state.data(S2, 2).copy_from_slice(&headers[2..4]);
            state.data(R, 2).copy_from_slice(&[room, headers[4]]);
            state.put(0, &l.to_be_bytes());
            state.put(2, &p.to_be_bytes());
            let before = state.data(0, 792).to_vec();
            call.run(&mut state);
            let length = state.data(R, 2)[1];
            prop_assert!(length <= room, "a length of {} in a string of {}", length, room);
            let end = R + 2 + usize::from(room);
            prop_assert_eq!(&state.data(0, 792)[..R], &before[..R]);
            prop_assert_eq!(&state.data(0, 792)[end..], &before[end..]);
        }
    });
}

#[test]
fn numbers_become_strings_and_strings_numbers_as_in_the_model() {
    let written: &[(&str, usize, i64, i64)] =
        &[("I_STRNG", 2, i64::from(i16::MIN), i64::from(i16::MAX)), ("DI_STRNG", 4, i64::from(i32::MIN), i64::from(i32::MAX))];
    let read: &[(&str, usize, i64, i64)] =
        &[("STRNG_I", 6, i64::from(i16::MIN), i64::from(i16::MAX)), ("STRNG_DI", 11, i64::from(i32::MIN), i64::from(i32::MAX))];
    let address = |bytes: usize, at: usize| format!("{} {at}", if bytes == 2 { "MW" } else { "MD" });
    let writers: Vec<Call> =
        written.iter().map(|(name, bytes, ..)| Call::new(&format!("\"{name}\" (I := {}, RET_VAL := DB1.r)", address(*bytes, 0)))).collect();
    let readers: Vec<Call> = read
        .iter()
        .map(|(name, longest, ..)| {
            Call::new(&format!("\"{name}\" (S := DB1.s1, RET_VAL := {})", address(if *longest == 6 { 2 } else { 4 }, 10)))
        })
        .collect();
    let config = ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() };
    let values = prop_oneof![any::<i32>(), -1000..1000_i32, Just(i32::MIN), Just(i32::MAX), Just(0)];
    let texts = prop_oneof![
        "[+-]?[0-9]{0,13}",
        "[+-]?[0-9]{1,5}",
        "[0-9+ -]{0,7}",
        "[+-]?(2147483647|2147483648|2147483649|32767|32768|32769|0{9}|65536)",
        "[\\x00-\\x7f]{0,12}",
    ];
    proptest!(config, |(value in values, room in 0_u8..16, text in texts)| {
        for (call, &(name, bytes, ..)) in writers.iter().zip(written) {
            let mut state = call.state();
            state.put(0, &value.to_be_bytes()[4 - bytes..]);
            state.put_string(R, room, b"");
            let good = call.run(&mut state);
            let value = if bytes == 2 { i64::from(value as i16) } else { i64::from(value) };
            let expected = format!("{value:+}");
            prop_assert_eq!(good, expected.len() <= usize::from(room), "{} of {}", name, value);
            prop_assert_eq!(state.string(R), if good { expected.into_bytes() } else { Vec::new() });
        }
        for (call, &(name, longest, low, high)) in readers.iter().zip(read) {
            let mut state = call.state();
            state.put(10, &[0x5A; 4]);
            state.put_string(S1, 254, text.as_bytes());
            let good = call.run(&mut state);
            let digits = text.strip_prefix(['+', '-']).unwrap_or(&text);
            let spelled = text.len() <= longest && !digits.is_empty() && digits.bytes().all(|c| c.is_ascii_digit());
            let number = spelled.then(|| text.parse::<i64>().expect("at most eleven characters"));
            let got = if longest == 6 { i64::from(state.word(10)) } else { i64::from(state.double_word(10) as i32) };
            let kept = if longest == 6 { 0x5A5A } else { 0x5A5A_5A5A };
            prop_assert_eq!(got, number.map_or(kept, |number| number.clamp(low, high)), "{} of {:?}", name, text);
            prop_assert_eq!(good, number.is_some_and(|number| (low..=high).contains(&number)), "BR of {} of {:?}", name, text);
        }
    });
}
