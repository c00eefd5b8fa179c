//! How long programs take to become the machine code that a run begins with.

use std::fmt::Write as _;

use sieben_engine::Layout;
use sieben_jit::{StatusBits, Tier, Tiers};

use super::side_by_side::{compiled, cpu_type, now_ns};

/// Compilations of each program.
const TIMES: usize = 100;

/// Random numbers, the same in each run.
struct Dice(u32);

impl Dice {
    fn roll(&mut self, below: u32) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 8) % below
    }

    fn of<'a>(&mut self, words: &[&'a str]) -> &'a str {
        words[self.roll(words.len() as u32) as usize]
    }

    fn bit(&mut self) -> String {
        format!("{} {}.{}", self.of(&["I", "Q", "M"]), self.roll(64), self.roll(8))
    }

    fn flag(&mut self) -> String {
        format!("M {}.{}", 200 + self.roll(20), self.roll(8))
    }

    fn word(&mut self) -> String {
        format!("MW {}", 2 * self.roll(100))
    }

    fn double(&mut self) -> String {
        format!("MD {}", 4 * self.roll(50))
    }
}

/// A network of a kind of programs.
type Network = fn(&mut Dice) -> String;

fn bits(dice: &mut Dice) -> String {
    format!("A {}; AN {}; O {}; = Q {}.{};", dice.bit(), dice.bit(), dice.bit(), dice.roll(64), dice.roll(8))
}

fn words(dice: &mut Dice) -> String {
    match dice.roll(5) {
        0 => format!("L {}; L {}; {}; T {};", dice.word(), dice.word(), dice.of(&["+I", "-I", "*I"]), dice.word()),
        1 => format!("L {}; L {}; {}; T {};", dice.double(), dice.double(), dice.of(&["+R", "-R", "*R"]), dice.double()),
        2 => format!("L {}; L {}; {}; = {};", dice.word(), dice.word(), dice.of(&[">I", "<I", "==I"]), dice.flag()),
        3 => format!("L {}; L {}; {}; = {};", dice.double(), dice.double(), dice.of(&[">R", "<=R"]), dice.flag()),
        _ => format!("A(; O {}; O {}; ); A {}; = {};", dice.bit(), dice.bit(), dice.bit(), dice.flag()),
    }
}

fn brackets(dice: &mut Dice) -> String {
    let [a, b, c, d, e] = std::array::from_fn(|_| dice.bit());
    format!("A(; O {a}; O(; A {b}; AN {c}; ); ); A(; O {d}; ON {e}; ); = {};", dice.flag())
}

/// Prints the time for 1,000 statements of each kind of programs.
pub(crate) fn print() {
    println!("{:<28} {:>10} {:>9} {:>9} {:>9}", "first tier, 1,000 statements", "statements", "first ms", "best ms", "median ms");
    let kinds: [(&str, Network, usize); 3] =
        [("bit logic", bits, 252), ("words, REAL, comparisons", words, 252), ("brackets", brackets, 84)];
    for (name, network, networks) in kinds {
        for times in [1, 10] {
            let mut dice = Dice(12_345);
            let mut text = String::new();
            for _ in 0..times * networks {
                let _ = writeln!(text, "{}", network(&mut dice));
            }
            row(name, &text);
        }
    }
}

fn row(name: &str, text: &str) {
    let program = compiled("bench.awl", text).expect("it compiles");
    let layout = Layout::new(cpu_type(), &program);
    let statements: usize = program.code.values().map(|block| block.code.statement_count()).sum();
    let mut times: Vec<f64> = (0..TIMES)
        .map(|_| {
            let tiers = Tiers::load(&program, &layout, StatusBits::Needed);
            let start = now_ns();
            tiers.compile(Tier::Quick).expect("machine code");
            (now_ns() - start) / 1e3 / statements as f64
        })
        .collect();
    let first = times[0];
    times.sort_by(f64::total_cmp);
    println!("{name:<28} {statements:>10} {first:>9.2} {:>9.2} {:>9.2}", times[0], times[TIMES / 2]);
}
