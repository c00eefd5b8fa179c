//! The functions of dates and durations against a second model that counts days one by one, as a calendar on the wall does.

use std::sync::LazyLock;

use crate::call::{Call, T, T1, T2};
use proptest::prelude::*;

const DAY_MS: i64 = 86_400_000;
/// Days from 1990-01-01 to 2089-12-31.
const LAST_DAY: i64 = 36_524;

/// Year, month, day and day of the week (1 = Sunday) of every day from 1990 to 2089.
static CALENDAR: LazyLock<Vec<(u16, u8, u8, u8)>> = LazyLock::new(|| {
    let mut days = Vec::new();
    // The first of January 1990 was a Monday.
    let mut weekday = 2;
    for year in 1990..=2089 {
        let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
        let lengths = [31, if leap { 29 } else { 28 }, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
        for (month, length) in (1..).zip(lengths) {
            for day in 1..=length {
                days.push((year, month, day, weekday));
                weekday = weekday % 7 + 1;
            }
        }
    }
    days
});

fn bcd(number: i64) -> u8 {
    (number / 10 * 16 + number % 10) as u8
}

/// The eight bytes of a point in time.
fn date_and_time(day: i64, ms: i64) -> [u8; 8] {
    let (year, month, date, weekday) = CALENDAR[day as usize];
    let ms_bcd = (((ms % 1000 / 100) << 8) | ((ms % 100 / 10) << 4) | (ms % 10)) as u16;
    let [high, low] = ((ms_bcd << 4) | u16::from(weekday)).to_be_bytes();
    let fields = [i64::from(year) % 100, i64::from(month), i64::from(date), ms / 3_600_000, ms / 60_000 % 60, ms / 1000 % 60].map(bcd);
    [fields[0], fields[1], fields[2], fields[3], fields[4], fields[5], high, low]
}

fn day() -> impl Strategy<Value = i64> {
    prop_oneof![4 => 0..=LAST_DAY, 1 => 0..40_i64, 1 => LAST_DAY - 40..=LAST_DAY, 1 => 3640..3720_i64]
}

fn time_of_day() -> impl Strategy<Value = i64> {
    prop_oneof![4 => 0..DAY_MS, 1 => Just(0_i64), 1 => Just(DAY_MS - 1)]
}

fn duration() -> impl Strategy<Value = i32> {
    prop_oneof![any::<i32>(), -100_000_000..100_000_000_i32, Just(i32::MIN), Just(i32::MAX), Just(0), Just(1), Just(-1)]
}

fn config() -> ProptestConfig {
    ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() }
}

#[test]
fn the_calendar_of_the_model_ends_where_it_should() {
    assert_eq!(CALENDAR.len() as i64, LAST_DAY + 1);
    assert_eq!(CALENDAR[LAST_DAY as usize], (2089, 12, 31, 7), "the last day is a Saturday");
}

#[test]
fn durations_are_added_and_subtracted_as_in_the_model() {
    let calls = [
        (Call::new("\"AD_DT_TM\" (T := DB1.t1, D := MD 0, RET_VAL := DB1.t)"), 1_i64, T),
        (Call::new("\"SB_DT_TM\" (T := DB1.t1, D := MD 0, RET_VAL := DB1.t)"), -1, T),
        (Call::new("\"AD_DT_TM\" (T := DB1.t1, D := MD 0, RET_VAL := DB1.t1)"), 1, T1),
        (Call::new("\"SB_DT_TM\" (T := DB1.t1, D := MD 0, RET_VAL := DB1.t1)"), -1, T1),
    ];
    proptest!(config(), |(day in day(), ms in time_of_day(), duration in duration())| {
        for (call, sign, result) in &calls {
            let mut state = call.state();
            state.data(T1, 8).copy_from_slice(&date_and_time(day, ms));
            state.put(0, &duration.to_be_bytes());
            let good = call.run(&mut state);
            let exact = day * DAY_MS + ms + sign * i64::from(duration);
            let limited = exact.clamp(0, (LAST_DAY + 1) * DAY_MS - 1);
            prop_assert_eq!(state.data(*result, 8), date_and_time(limited / DAY_MS, limited % DAY_MS));
            prop_assert_eq!(good, exact == limited);
        }
    });
}

#[test]
fn points_in_time_are_taken_apart_and_put_together_as_in_the_model() {
    let date = Call::new("\"DT_DATE\" (IN := DB1.t1, RET_VAL := MW 10)");
    let weekday = Call::new("\"DT_DAY\" (IN := DB1.t1, RET_VAL := MW 10)");
    let time = Call::new("\"DT_TOD\" (IN := DB1.t1, RET_VAL := MD 10)");
    let together = Call::new("\"D_TOD_DT\" (IN1 := MW 0, IN2 := MD 2, RET_VAL := DB1.t)");
    proptest!(config(), |(day in day(), ms in time_of_day(), digit in 0_u8..16)| {
        let run = |call: &Call| {
            let mut state = call.state();
            let mut bytes = date_and_time(day, ms);
            // The digit of the day of the week is not believed.
            bytes[7] = (bytes[7] & 0xF0) | digit;
            state.data(T1, 8).copy_from_slice(&bytes);
            state.put(0, &(day as u16).to_be_bytes());
            state.put(2, &(ms as u32).to_be_bytes());
            assert!(call.run(&mut state), "BR is 1");
            state
        };
        prop_assert_eq!(i64::from(run(&date).word(10) as u16), day);
        prop_assert_eq!(run(&weekday).word(10), i16::from(CALENDAR[day as usize].3));
        prop_assert_eq!(i64::from(run(&time).double_word(10)), ms);
        prop_assert_eq!(run(&together).data(T, 8).to_vec(), date_and_time(day, ms).to_vec());
    });
}

#[test]
fn points_in_time_are_subtracted_and_compared_as_in_the_model() {
    type Compare = fn(&i64, &i64) -> bool;
    let compares: &[(&str, Compare)] =
        &[("EQ_DT", i64::eq), ("NE_DT", i64::ne), ("GT_DT", i64::gt), ("GE_DT", i64::ge), ("LT_DT", i64::lt), ("LE_DT", i64::le)];
    let compares: Vec<(Call, Compare)> = compares
        .iter()
        .map(|&(name, compare)| (Call::new(&format!("\"{name}\" (DT1 := DB1.t1, DT2 := DB1.t2, RET_VAL := M 10.0)")), compare))
        .collect();
    let difference = Call::new("\"SB_DT_DT\" (DT1 := DB1.t1, DT2 := DB1.t2, RET_VAL := MD 10)");
    let near = (day(), time_of_day(), -2_600_000_000_i64..2_600_000_000).prop_map(|(day, ms, apart)| {
        let first = day * DAY_MS + ms;
        (first, (first + apart).clamp(0, (LAST_DAY + 1) * DAY_MS - 1))
    });
    let far = (day(), time_of_day(), day(), time_of_day()).prop_map(|(day, ms, other, time)| (day * DAY_MS + ms, other * DAY_MS + time));
    let limits =
        (30..=LAST_DAY - 30, time_of_day(), prop_oneof![Just(i32::MAX), Just(i32::MIN)], -1..=1_i64).prop_map(|(day, ms, limit, more)| {
            let second = day * DAY_MS + ms;
            (second + i64::from(limit) + more, second)
        });
    let same = (day(), time_of_day()).prop_map(|(day, ms)| (day * DAY_MS + ms, day * DAY_MS + ms));
    proptest!(config(), |((first, second) in prop_oneof![near, far, limits, same], digits in any::<[u8; 2]>())| {
        let run = |call: &Call| {
            let mut state = call.state();
            for (at, point, digit) in [(T1, first, digits[0]), (T2, second, digits[1])] {
                let mut bytes = date_and_time(point / DAY_MS, point % DAY_MS);
                bytes[7] = (bytes[7] & 0xF0) | (digit & 0x0F);
                state.data(at, 8).copy_from_slice(&bytes);
            }
            let good = call.run(&mut state);
            (state, good)
        };
        let (state, good) = run(&difference);
        let exact = first - second;
        let limited = exact.clamp(i64::from(i32::MIN), i64::from(i32::MAX));
        prop_assert_eq!(i64::from(state.double_word(10) as i32), limited);
        prop_assert_eq!(good, exact == limited);
        for (call, compare) in &compares {
            let (state, good) = run(call);
            prop_assert!(good);
            prop_assert_eq!(state.double_word(10) >> 24 == 1, compare(&first, &second));
        }
    });
}

#[test]
fn bytes_that_are_no_point_in_time_end_no_call() {
    let calls = [
        "\"AD_DT_TM\" (T := DB1.t1, D := MD 0, RET_VAL := DB1.t)",
        "\"SB_DT_TM\" (T := DB1.t1, D := MD 0, RET_VAL := DB1.t)",
        "\"SB_DT_DT\" (DT1 := DB1.t1, DT2 := DB1.t2, RET_VAL := MD 10)",
        "\"D_TOD_DT\" (IN1 := MW 0, IN2 := MD 2, RET_VAL := DB1.t)",
        "\"DT_DATE\" (IN := DB1.t1, RET_VAL := MW 10)",
        "\"DT_DAY\" (IN := DB1.t1, RET_VAL := MW 10)",
        "\"DT_TOD\" (IN := DB1.t1, RET_VAL := MD 10)",
        "\"GT_DT\" (DT1 := DB1.t1, DT2 := DB1.t2, RET_VAL := M 10.0)",
    ]
    .map(Call::new);
    proptest!(config(), |(first in any::<[u8; 8]>(), second in any::<[u8; 8]>(), memory in any::<[u8; 6]>())| {
        for (index, call) in calls.iter().enumerate() {
            let mut state = call.state();
            state.data(T1, 8).copy_from_slice(&first);
            state.data(T2, 8).copy_from_slice(&second);
            state.put(0, &memory);
            call.run(&mut state);
            // A point in time that the library makes is one, whatever it is made from.
            if matches!(index, 0 | 1 | 3) {
                let made = state.data(T, 8).to_vec();
                prop_assert!(made.iter().take(7).all(|byte| byte >> 4 < 10 && byte & 15 < 10), "{:02X?}", made);
                prop_assert!((1..=0x12).contains(&made[1]) && (1..=0x31).contains(&made[2]), "{:02X?}", made);
                prop_assert!(made[3] < 0x24 && made[4] < 0x60 && made[5] < 0x60 && (1..=7).contains(&(made[7] & 15)), "{:02X?}", made);
            }
            if index == 5 {
                prop_assert!((1..=7).contains(&state.word(10)));
            }
        }
    });
}

#[test]
fn every_s5time_and_every_time_is_converted_as_in_the_model() {
    let to_time = Call::new("\"S5TI_TIM\" (IN := MW 0, RET_VAL := MD 10)");
    let mut state = to_time.state();
    for word in 0..=u16::MAX {
        let digits = [(word >> 8) & 15, (word >> 4) & 15, word & 15];
        // The model speaks of BCD digits only; others are tried below.
        if digits.iter().all(|&digit| digit < 10) {
            state.put(0, &word.to_be_bytes());
            assert!(to_time.run(&mut state));
            let base = [10, 100, 1000, 10_000][usize::from((word >> 12) & 3)];
            let count = u32::from(digits[0]) * 100 + u32::from(digits[1]) * 10 + u32::from(digits[2]);
            assert_eq!(state.double_word(10), count * base, "{word:04X}");
        }
    }
    let to_s5 = Call::new("\"TIM_S5TI\" (IN := MD 0, RET_VAL := MW 10)");
    let times = prop_oneof![any::<i32>(), 0..12_000, 0..10_500_000, 9_989_990..9_990_020, -3..3_i32, Just(i32::MAX), Just(i32::MIN)];
    proptest!(config(), |(time in times, word in any::<u16>())| {
        let mut state = to_s5.state();
        state.put(0, &time.to_be_bytes());
        let good = to_s5.run(&mut state);
        let limited = time.clamp(0, 9_990_000);
        let (base, unit) = (0_u16..).zip([10, 100, 1000, 10_000]).find(|(_, unit)| limited / unit <= 999).expect("999 times 10 s");
        let count = (limited / unit) as u16;
        let expected = (base << 12) | ((count / 100) << 8) | ((count / 10 % 10) << 4) | (count % 10);
        prop_assert_eq!(state.word(10) as u16, expected, "{} ms", time);
        prop_assert_eq!(good, time == limited);
        let mut state = to_time.state();
        state.put(0, &word.to_be_bytes());
        to_time.run(&mut state);
    });
}
