//! Which jump is taken: every conditional jump with every status word, every index of a jump list, LOOP.

use sieben_engine::machine::{Registers, StatusWord};

use super::bench::Bench;

/// Whether a jump is taken, by the bits that the manual names.
fn taken(word: &str, status: u16) -> bool {
    let bit = |number: u32| status >> number & 1 == 1;
    let (rlo, ov, os, cc0, cc1, br) = (bit(1), bit(5), bit(4), bit(6), bit(7), bit(8));
    match word {
        "JU" => true,
        "JC" | "JCB" => rlo,
        "JCN" | "JNB" => !rlo,
        "JBI" => br,
        "JNBI" => !br,
        "JO" => ov,
        "JOS" => os,
        "JZ" => !cc1 && !cc0,
        "JN" => cc1 != cc0,
        "JP" => cc1 && !cc0,
        "JM" => !cc1 && cc0,
        "JPZ" => !cc0,
        "JMZ" => !cc1,
        "JUO" => cc1 && cc0,
        other => unreachable!("{other} is no jump of the list"),
    }
}

const JUMPS: [&str; 16] = ["JU", "JC", "JCN", "JCB", "JNB", "JBI", "JNBI", "JO", "JOS", "JZ", "JN", "JP", "JM", "JPZ", "JMZ", "JUO"];

#[test]
fn conditional_jumps() {
    let pieces: Vec<String> = JUMPS.iter().map(|word| format!("{word} lab; L 1; BEU; lab: L 2;")).collect();
    let mut bench = Bench::new("416-3", &pieces);
    for (index, word) in JUMPS.iter().enumerate() {
        for status in 0..512 {
            let mut before = Registers::fresh();
            before.set_status(StatusWord(status));
            let after = bench.run(index, before).expect("a jump does not fail");
            assert_eq!(after.accu1, if taken(word, status) { 2 } else { 1 }, "{word} with {status:09b}");
        }
    }
}

#[test]
fn jump_lists() {
    for entries in [1_u32, 2, 17, 255] {
        let mut piece = "JL lab;\n".to_owned();
        for entry in 0..entries {
            piece.push_str(&format!("JU a{entry:03};\n"));
        }
        piece.push_str("lab: L 999; BEU;\n");
        for entry in 0..entries {
            piece.push_str(&format!("a{entry:03}: L {entry}; BEU;\n"));
        }
        let mut bench = Bench::new("315-2PN/DP", &[piece]);
        for index in 0..=255_u32 {
            // Only the lowest byte counts.
            let accu1 = u64::from(0xABCD_EF00 | index);
            let after = bench.run(0, Registers { accu1, ..Registers::fresh() }).expect("a jump does not fail");
            assert_eq!(after.accu1, u64::from(if index < entries { index } else { 999 }), "{index} of {entries}");
        }
    }
}

#[test]
fn loops() {
    let piece = "next: L MD 0; + L#1; T MD 0; TAK; LOOP next;".to_owned();
    for (start, rounds) in [(1_u64, 1_u32), (2, 2), (300, 300), (0xFFFF, 65_535), (0, 65_536), (0xABCD_0003, 3)] {
        let mut bench = Bench::new("315-2PN/DP", std::slice::from_ref(&piece));
        let after = bench.run(0, Registers { accu1: start, ..Registers::fresh() }).expect("a loop does not fail");
        let counted = bench.machine.memory.area_mut(sieben_model::address::Area::BitMemory)[..4]
            .iter()
            .fold(0, |sum, &byte| sum << 8 | u32::from(byte));
        assert_eq!((counted, after.accu1), (rounds, start & 0xFFFF_0000), "{start:#x}");
    }
}
