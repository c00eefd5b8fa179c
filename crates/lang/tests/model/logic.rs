//! Random logic with brackets against plain boolean evaluation.

use proptest::prelude::*;
use sieben_model::address::Area;

use super::bench::{Bench, with};

/// A logic string, as one writes it down.
#[derive(Clone, Debug)]
enum Text {
    /// Operands one after another, each combined with what stands before it.
    Chain(Vec<(Word, Operand)>),
    /// AND strings joined by `O` alone.
    Sum(Vec<Vec<(bool, Operand)>>),
}

#[derive(Clone, Debug)]
enum Operand {
    Bit(usize),
    Bracket(Text),
    Not(Box<Operand>),
}

#[derive(Clone, Copy, Debug)]
enum Word {
    And,
    Or,
    Xor,
}

fn write(text: &Text, out: &mut String) {
    match text {
        Text::Chain(parts) => {
            for (word, operand) in parts {
                let letter = match word {
                    Word::And => "A",
                    Word::Or => "O",
                    Word::Xor => "X",
                };
                one(letter, operand, out);
            }
        }
        Text::Sum(products) => {
            for (index, product) in products.iter().enumerate() {
                if index > 0 {
                    out.push_str("O;\n");
                }
                for (negated, operand) in product {
                    one(if *negated { "AN" } else { "A" }, operand, out);
                }
            }
        }
    }
}

fn one(word: &str, operand: &Operand, out: &mut String) {
    match operand {
        Operand::Bit(bit) => out.push_str(&format!("{word} M {}.{};\n", bit / 8, bit % 8)),
        Operand::Bracket(text) => {
            out.push_str(&format!("{word}(;\n"));
            write(text, out);
            out.push_str(");\n");
        }
        Operand::Not(inner) => one(&format!("{word}N"), inner, out),
    }
}

fn value(text: &Text, bits: u16) -> bool {
    match text {
        Text::Chain(parts) => {
            let mut result = None;
            for (word, operand) in parts {
                let next = operand_value(operand, bits);
                result = Some(match (result, word) {
                    (None, _) => next,
                    (Some(before), Word::And) => before && next,
                    (Some(before), Word::Or) => before || next,
                    (Some(before), Word::Xor) => before != next,
                });
            }
            result.unwrap_or(false)
        }
        Text::Sum(products) => {
            products.iter().any(|product| product.iter().all(|(negated, operand)| operand_value(operand, bits) != *negated))
        }
    }
}

fn operand_value(operand: &Operand, bits: u16) -> bool {
    match operand {
        Operand::Bit(bit) => bits >> bit & 1 == 1,
        Operand::Bracket(text) => value(text, bits),
        Operand::Not(inner) => !operand_value(inner, bits),
    }
}

/// Brackets at most `depth` deep.
fn text(depth: u32) -> BoxedStrategy<Text> {
    let operand = || {
        let bit = (0..16_usize).prop_map(Operand::Bit);
        if depth == 0 {
            return bit.boxed();
        }
        prop_oneof![2 => bit, 1 => text(depth - 1).prop_map(Operand::Bracket)].boxed()
    };
    let word = prop::sample::select(vec![Word::And, Word::Or, Word::Xor]);
    let negated = (any::<bool>(), operand()).prop_map(|(not, operand)| if not { Operand::Not(Box::new(operand)) } else { operand });
    prop_oneof![
        prop::collection::vec((word, negated), 1..4).prop_map(Text::Chain),
        prop::collection::vec(prop::collection::vec((any::<bool>(), operand()), 1..4), 1..4).prop_map(Text::Sum),
    ]
    .boxed()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn logic_strings(text in prop_oneof![text(0), text(2), text(5), text(7)], states in prop::collection::vec(any::<u16>(), 12), rlo in any::<bool>()) {
        let mut piece = String::new();
        write(&text, &mut piece);
        let mut bench = Bench::new("315-2PN/DP", std::slice::from_ref(&piece));
        for bits in states {
            bench.machine.memory.area_mut(Area::BitMemory)[..2].copy_from_slice(&bits.to_le_bytes());
            // The RLO before a first check is of no importance.
            let after = bench.run(0, with(rlo, 0)).expect("logic does not fail");
            prop_assert_eq!(after.rlo == 1, value(&text, bits), "{:016b}\n{}", bits, piece);
        }
    }
}
