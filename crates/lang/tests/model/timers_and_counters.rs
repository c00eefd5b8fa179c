//! S5 timers and counters in random histories of RLO and time.

use proptest::prelude::*;

use super::bench::{Bench, with};

/// A timer as the manual draws it: a level S, a time that runs, and what is kept when it has run out.
#[derive(Clone, Debug, Default)]
struct Timer {
    /// RLO of the last start instruction, unless FR has cleared it.
    seen: bool,
    /// RLO of the last FR.
    enable_seen: bool,
    /// S, until R or the next change.
    level: bool,
    /// Start of the running time and the units it was given.
    running: Option<(i128, i128)>,
    /// The value that a stopped timer shows.
    rest: i128,
    base: usize,
    elapsed: bool,
}

const UNIT_US: [i128; 4] = [10_000, 100_000, 1_000_000, 10_000_000];

impl Timer {
    fn value(&self, now: i128) -> i128 {
        match self.running {
            Some((start, units)) => (units - (now - start) / UNIT_US[self.base]).max(0),
            None => self.rest,
        }
    }

    fn tick(&mut self, now: i128) {
        if self.running.is_some() && self.value(now) == 0 {
            self.running = None;
            self.rest = 0;
            self.elapsed = true;
        }
    }

    fn stop(&mut self, now: i128) {
        self.rest = self.value(now);
        self.running = None;
    }

    /// One of SP SE SD SS SF; `false` is a BCD error, which changes nothing.
    fn start(&mut self, kind: &str, rlo: bool, word: u32, now: i128) -> bool {
        let (rising, falling) = (rlo && !self.seen, !rlo && self.seen);
        let starts = if kind == "SF" { falling } else { rising };
        let digits = [word & 0xF, word >> 4 & 0xF, word >> 8 & 0xF];
        if starts && digits.iter().any(|&digit| digit > 9) {
            return false;
        }
        self.seen = rlo;
        if starts {
            self.base = (word >> 12 & 3) as usize;
            self.running = Some((now, i128::from(digits[0] + 10 * digits[1] + 100 * digits[2])));
            // What had run out shows until the new time has run out only with SS.
            if kind != "SS" {
                self.elapsed = false;
            }
        }
        match kind {
            "SP" if !rlo => self.stop(now),
            "SD" if !rlo => {
                self.stop(now);
                self.elapsed = false;
            }
            "SF" if rising => self.stop(now),
            _ => {}
        }
        if rising || !rlo && (kind != "SF" || falling) {
            self.level = rlo;
        }
        self.tick(now);
        true
    }

    fn reset(&mut self, rlo: bool) {
        if rlo {
            *self = Self { seen: self.seen, enable_seen: self.enable_seen, ..Self::default() };
        }
    }

    fn enable(&mut self, rlo: bool) {
        if rlo && !self.enable_seen {
            self.seen = false;
        }
        self.enable_seen = rlo;
    }

    fn status(&self, kind: &str) -> bool {
        match kind {
            "SP" | "SE" => self.running.is_some(),
            "SD" => self.elapsed && self.level,
            "SS" => self.elapsed,
            _ => self.level || self.running.is_some(),
        }
    }
}

/// A decimal number as BCD.
fn bcd(value: i128) -> u64 {
    format!("{value}").bytes().fold(0, |bcd, digit| bcd << 4 | u64::from(digit - b'0'))
}

/// One step: time that passes (ms), what is done, the RLO, ACCU 1.
fn steps(actions: usize) -> impl Strategy<Value = Vec<(u64, usize, bool, u32)>> {
    let time = prop_oneof![3 => 0..40_u64, 1 => 0..3_000_u64, 1 => Just(0)];
    let word = prop_oneof![
        6 => (0..4_u32, 0..30_u32).prop_map(|(base, value)| base << 12 | (value / 10) << 4 | (value % 10)),
        1 => any::<u32>(),
        1 => Just(0_u32),
        1 => Just(0x0999_u32),
    ];
    // The start instruction comes most often.
    let action = prop_oneof![2 => Just(0), 2 => 0..actions];
    prop::collection::vec((time, action, any::<bool>(), word), 1..60)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn timers(history in steps(3)) {
        for kind in ["SP", "SE", "SD", "SS", "SF"] {
            let pieces = [format!("{kind} T 7;"), "R T 7;".to_owned(), "FR T 7;".to_owned(), "L T 7;".to_owned(), "LC T 7;".to_owned(), "A T 7;".to_owned()];
            let mut bench = Bench::new("315-2PN/DP", &pieces);
            let mut model = Timer::default();
            let mut now = 0;
            for (index, &(ms, action, rlo, word)) in history.iter().enumerate() {
                bench.machine.clock_us += ms * 1000;
                now += i128::from(ms) * 1000;
                model.tick(now);
                let fine = match action {
                    0 => model.start(kind, rlo, word, now),
                    1 => { model.reset(rlo); true }
                    _ => { model.enable(rlo); true }
                };
                prop_assert_eq!(bench.run(action, with(rlo, word)).is_some(), fine, "{} step {}: {:?}", kind, index, history);
                let shown = (3..6).map(|piece| bench.run(piece, with(false, 0)).expect("reading never fails")).collect::<Vec<_>>();
                let expected = (model.value(now) as u64, (model.base as u64) << 12 | bcd(model.value(now)), model.status(kind));
                prop_assert_eq!((shown[0].accu1, shown[1].accu1, shown[2].rlo == 1), expected, "{} step {}: {:?}\n{:?}", kind, index, history, model);
            }
        }
    }

    #[test]
    fn counters(history in steps(5)) {
        let pieces = ["S C 5;", "CU C 5;", "CD C 5;", "R C 5;", "FR C 5;", "L C 5;", "LC C 5;", "A C 5;"].map(str::to_owned);
        let mut bench = Bench::new("416-3", &pieces);
        // S, CU, CD, R (none) and FR have an edge memory each.
        let mut seen = [false; 5];
        let mut count = 0_i128;
        for &(_, action, rlo, word) in &history {
            let edge = rlo && !seen[action];
            let digits = [word & 0xF, word >> 4 & 0xF, word >> 8 & 0xF];
            let fine = !(action == 0 && edge && digits.iter().any(|&digit| digit > 9));
            if fine {
                seen[action] = rlo;
                match action {
                    0 if edge => count = i128::from(digits[0] + 10 * digits[1] + 100 * digits[2]),
                    1 if edge => count = (count + 1).min(999),
                    2 if edge => count = (count - 1).max(0),
                    3 if rlo => count = 0,
                    4 if edge => seen[..3].fill(false),
                    _ => {}
                }
            }
            prop_assert_eq!(bench.run(action, with(rlo, word)).is_some(), fine);
            let shown: Vec<_> = (5..8).map(|piece| bench.run(piece, with(false, 0)).expect("reading never fails")).collect();
            prop_assert_eq!((shown[0].accu1, shown[1].accu1, shown[2].rlo == 1), (count as u64, bcd(count), count > 0), "{:?}", history);
        }
    }
}
