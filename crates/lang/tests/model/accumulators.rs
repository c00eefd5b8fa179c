//! Random sequences of instructions that move accumulators, on CPUs with two and with four.

use proptest::prelude::*;
use sieben_engine::machine::Registers;

use super::bench::Bench;

/// Words whose whole effect is on the accumulators.
const WORDS: [&str; 21] = [
    "TAK",
    "PUSH",
    "POP",
    "CAW",
    "CAD",
    "INC 200",
    "DEC 7",
    "+ -3",
    "+ L#70000",
    "INVI",
    "INVD",
    "L 5",
    "L L#-1",
    "TAR1",
    "+D",
    "-I",
    "*I",
    "/D",
    "AW",
    "XOD",
    "ITD",
];
const WORDS_OF_FOUR: [&str; 2] = ["ENT", "LEAVE"];

fn low(value: u32) -> i128 {
    i128::from(value as u16 as i16)
}

/// What a word does with the accumulators.
fn step(accu: &mut [u32; 4], word: &str, four: bool) {
    let [one, two, three, fourth] = *accu;
    let keep_high = |low: i128| one & 0xFFFF_0000 | low as u32 & 0xFFFF;
    let keep_upper = |low: i128| one & 0xFFFF_FF00 | low as u32 & 0xFF;
    let signed = |value: u32| i128::from(value as i32);
    let load = |value: u32| [value, one, three, fourth];
    // Arithmetic with two operands closes the gap on a CPU with four accumulators.
    let result = |value: u32| if four { [value, three, fourth, fourth] } else { [value, two, three, fourth] };
    *accu = match word {
        "TAK" => [two, one, three, fourth],
        "PUSH" if four => [one, one, two, three],
        "PUSH" => [one, one, three, fourth],
        "POP" if four => [two, three, fourth, fourth],
        "POP" => [two, two, three, fourth],
        "ENT" => [one, two, two, three],
        "LEAVE" => [one, three, fourth, fourth],
        "CAW" => [one & 0xFFFF_0000 | (one & 0xFF) << 8 | one >> 8 & 0xFF, two, three, fourth],
        "CAD" => [(one & 0xFF) << 24 | (one & 0xFF00) << 8 | one >> 8 & 0xFF00 | one >> 24, two, three, fourth],
        "INC 200" => [keep_upper(i128::from(one) + 200), two, three, fourth],
        "DEC 7" => [keep_upper(i128::from(one) - 7), two, three, fourth],
        "+ -3" => [keep_high(low(one) - 3), two, three, fourth],
        "+ L#70000" => [(signed(one) + 70_000) as u32, two, three, fourth],
        "INVI" => [keep_high(i128::from(!one)), two, three, fourth],
        "INVD" => [!one, two, three, fourth],
        "L 5" => load(5),
        "L L#-1" => load(u32::MAX),
        "TAR1" => load(0x8300_0190),
        "+D" => result((signed(two) + signed(one)) as u32),
        "-I" => result(keep_high(low(two) - low(one))),
        "*I" => result((low(two) * low(one)) as u32),
        // What the accumulators hold behind a division by zero is not said: see the decision on it.
        "/D" if one == 0 => result(one),
        "/D" => result((signed(two) / signed(one)) as u32),
        "AW" => [keep_high(i128::from(two & one)), two, three, fourth],
        "XOD" => [two ^ one, two, three, fourth],
        "ITD" => [low(one) as u32, two, three, fourth],
        other => unreachable!("{other} is no word of the list"),
    };
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn accumulators(start in any::<[u32; 4]>(), chosen in prop::collection::vec(0..WORDS.len() + WORDS_OF_FOUR.len(), 1..30)) {
        for (cpu, four) in [("315-2PN/DP", false), ("416-3", true)] {
            let words: Vec<&str> = WORDS.into_iter().chain(WORDS_OF_FOUR.into_iter().filter(|_| four)).collect();
            let piece: Vec<&str> = chosen.iter().map(|&index| words[index % words.len()]).collect();
            let mut expected = start;
            for word in &piece {
                step(&mut expected, word, four);
            }
            let mut bench = Bench::new(cpu, &[piece.join("; ") + ";"]);
            let [accu1, accu2, accu3, accu4] = start.map(u64::from);
            let after = bench.run(0, Registers { accu1, accu2, accu3, accu4, ar1: 0x8300_0190, ..Registers::fresh() }).expect("nothing here fails");
            let got = [after.accu1, after.accu2, after.accu3, after.accu4];
            let shown = if four { 4 } else { 2 };
            prop_assert_eq!(&got[..shown], &expected.map(u64::from)[..shown], "{}: {}", cpu, piece.join("; "));
        }
    }
}
