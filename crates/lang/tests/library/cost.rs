//! How many statements a call takes: for usual values, and for the worst that the memory can hold.

use crate::call::{Call, R, S1, S2};

/// A call, its statements for two strings of 20 characters and small numbers, and a limit that no content of the memory exceeds.
const COSTS: &[(&str, usize, usize)] = &[
    ("\"LEN\" (S := DB1.s1, RET_VAL := MW 10)", 20, 20),
    ("\"CONCAT\" (IN1 := DB1.s1, IN2 := DB1.s2, RET_VAL := DB1.r)", 400, 2_500),
    ("\"LEFT\" (IN := DB1.s1, L := MW 0, RET_VAL := DB1.r)", 120, 2_000),
    ("\"MID\" (IN := DB1.s1, L := MW 0, P := MW 2, RET_VAL := DB1.r)", 120, 1_500),
    ("\"DELETE\" (IN := DB1.s1, L := MW 0, P := MW 2, RET_VAL := DB1.r)", 300, 2_200),
    ("\"INSERT\" (IN1 := DB1.s1, IN2 := DB1.s2, P := MW 2, RET_VAL := DB1.r)", 500, 2_500),
    ("\"REPLACE\" (IN1 := DB1.s1, IN2 := DB1.s2, L := MW 0, P := MW 2, RET_VAL := DB1.r)", 500, 2_500),
    ("\"EQ_STRNG\" (S1 := DB1.s1, S2 := DB1.s2, RET_VAL := M 10.0)", 300, 2_500),
    // Every place of IN1, and at each all characters of IN2 but the last.
    ("\"FIND\" (IN1 := DB1.s1, IN2 := DB1.s2, RET_VAL := MW 10)", 400, 170_000),
    ("\"STRNG_DI\" (S := DB1.s1, RET_VAL := MD 10)", 300, 400),
    ("\"DI_STRNG\" (I := MD 0, RET_VAL := DB1.r)", 300, 450),
    ("\"R_STRNG\" (IN := MD 0, RET_VAL := DB1.r)", 9_000, 18_000),
    ("\"STRNG_R\" (S := DB1.s1, RET_VAL := MD 10)", 2_000, 25_000),
    ("\"AD_DT_TM\" (T := DB1.t1, D := MD 0, RET_VAL := DB1.t)", 300, 300),
    ("\"SB_DT_DT\" (DT1 := DB1.t1, DT2 := DB1.t2, RET_VAL := MD 10)", 300, 300),
    ("\"GT_DT\" (DT1 := DB1.t1, DT2 := DB1.t2, RET_VAL := M 10.0)", 40, 40),
    ("\"TIM_S5TI\" (IN := MD 0, RET_VAL := MW 10)", 60, 70),
];

#[test]
fn no_call_takes_more_statements_than_its_strings_can_explain() {
    let mut failures = Vec::new();
    let fill = |length: usize, last: u8| [vec![b'a'; length - 1], vec![last]].concat();
    for &(call, usual, most) in COSTS {
        let program = Call::new(call);
        let mut state = program.state();
        let number: &[u8] = if call.contains("STRNG_R") { b"+1.2345678E+05" } else { b"-1234567890" };
        match call.contains("\"STRNG_") {
            true => state.put_string(S1, 254, number),
            false => state.put_string(S1, 254, &fill(20, b'x')),
        }
        state.put_string(S2, 254, &fill(20, b'x'));
        state.put_string(R, 254, b"");
        state.put(0, if call.contains("R_STRNG") { &[0x47, 0xF1, 0x20, 0x9A] } else { &[0, 5, 0, 4] });
        let statements = program.statements(&mut state);
        // The worst: the longest strings that agree as far as possible, headers that claim the most, any numbers.
        let mut worst = statements;
        for (first, second) in [(254, 254), (254, 127), (255, 255), (1, 254), (0, 0)] {
            for numbers in [[0, 127, 0, 127], [0x7F; 4], [0xFF, 0x7F, 0xFF, 0xFF], [0x80, 0, 0, 0], [0, 0, 0, 1], [0, 1, 0, 1], [0; 4]] {
                for text in [None, Some("+9.9999999E+38"), Some("+1.0000000E-45"), Some("+0.0000001E+45")] {
                    let mut state = program.state();
                    state.data(S1, 256).fill(b'a');
                    state.data(S2, 256).fill(b'a');
                    state.data(S1, 2).copy_from_slice(&[first.max(254), first]);
                    state.data(S2, 2).copy_from_slice(&[second.max(254), second]);
                    if second > 1 {
                        state.data(S2 + 1 + usize::from(second.min(254)), 1).fill(b'x');
                    }
                    state.data(R, 2).copy_from_slice(&[254, 255]);
                    if let Some(text) = text {
                        state.put_string(S1, 254, text.as_bytes());
                    }
                    state.put(0, &numbers);
                    worst = worst.max(program.statements(&mut state));
                }
            }
        }
        // A limit that is far away would guard nothing.
        if statements > usual || statements * 2 < usual || worst > most || worst * 2 < most {
            failures.push(format!("{call}: {statements} statements (limit {usual}), at worst {worst} (limit {most})"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
