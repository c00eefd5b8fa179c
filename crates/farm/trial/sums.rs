//! Scenarios that are numbers, and a ledger that adds them up.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io::Write;
use std::ops::Range;
use std::path::Path;
use std::time::Duration;

use sieben_farm::{Came, Ledger, Work};

/// What comes of a scenario.
fn value(number: u64) -> u64 {
    number.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 20
}

/// What the result of a scenario that was given up begins with.
const GIVEN_UP: &[u8] = b"given up";

/// Scenarios that are numbers.
pub(crate) struct Sums {
    /// How long one takes.
    time: Duration,
    /// Bytes that a result has besides.
    pad: usize,
    /// The scenario that kills its worker.
    poison: Option<u64>,
}

impl Sums {
    pub(crate) fn read(bundle: &[u8]) -> Result<Self, String> {
        let text = String::from_utf8_lossy(bundle);
        let word = |name: &str| text.split(' ').find_map(|word| word.strip_prefix(name)).ok_or_else(|| format!("no {name}"));
        let number = |name: &str| word(name).and_then(|word| word.parse::<u64>().map_err(|_| format!("{name} is no number")));
        Ok(Self {
            time: Duration::from_micros(number("us=")?),
            pad: usize::try_from(number("pad=")?).map_err(|_| "too much")?,
            poison: word("poison=")?.parse().ok(),
        })
    }
}

impl Work for Sums {
    fn run(&self, range: Range<u64>, is_over: &dyn Fn() -> bool) -> Option<Vec<u8>> {
        let mut sum = 0_u64;
        for number in range {
            if is_over() {
                return None;
            }
            if self.poison == Some(number) {
                std::process::abort();
            }
            std::thread::sleep(self.time);
            sum = sum.wrapping_add(value(number));
        }
        let mut bytes = sum.to_le_bytes().to_vec();
        bytes.resize(bytes.len() + self.pad, 7);
        Some(bytes)
    }

    fn given_up(&self, number: u64) -> Vec<u8> {
        [GIVEN_UP, &number.to_le_bytes()].concat()
    }
}

/// A ledger in a file: one line for each result.
pub(crate) struct Book {
    count: u64,
    range: u64,
    next: u64,
    /// Ends the run with so many results.
    enough: u64,
    results: BTreeMap<u64, (u64, Vec<u8>)>,
    covered: BTreeSet<u64>,
    file: Option<File>,
    /// Results that were there at the beginning.
    kept: usize,
}

impl Book {
    pub(crate) fn open(count: u64, range: u64, enough: u64, path: Option<&Path>) -> Self {
        let mut book = Self { count, range, next: 0, enough, results: BTreeMap::new(), covered: BTreeSet::new(), file: None, kept: 0 };
        if let Some(path) = path {
            let text = fs::read_to_string(path).unwrap_or_default();
            for line in text.lines() {
                let words: Vec<&str> = line.split(' ').collect();
                // A line that was torn by a kill is a result that is missing.
                if let [start, end, bytes, "."] = words[..] {
                    let bytes = (0..bytes.len() / 2).map(|index| u8::from_str_radix(&bytes[2 * index..2 * index + 2], 16).expect("a byte"));
                    book.take(start.parse().expect("a number")..end.parse().expect("a number"), bytes.collect());
                }
            }
            book.kept = book.results.len();
            book.file = Some(File::options().append(true).create(true).open(path).expect("a file"));
        }
        book
    }

    fn take(&mut self, range: Range<u64>, bytes: Vec<u8>) {
        self.covered.extend(range.clone());
        self.results.insert(range.start, (range.end, bytes));
    }

    pub(crate) fn kept(&self) -> usize {
        self.kept
    }

    /// The sum of all scenarios that were not given up, as a difference from what it should be.
    pub(crate) fn sum(&self) -> String {
        let sum = |numbers: &mut dyn Iterator<Item = u64>| numbers.fold(0_u64, u64::wrapping_add);
        let got = sum(&mut self
            .results
            .values()
            .filter(|(_, bytes)| !bytes.starts_with(GIVEN_UP))
            .map(|(_, bytes)| u64::from_le_bytes(bytes[..8].try_into().expect("eight bytes"))));
        let given_up = self.results.iter().filter(|(_, (_, bytes))| bytes.starts_with(GIVEN_UP)).map(|(number, _)| *number);
        let given_up: BTreeSet<u64> = given_up.collect();
        let wanted = sum(&mut (0..self.count).filter(|number| !given_up.contains(number)).map(value));
        if got == wanted { "right".to_owned() } else { format!("{got}-instead-of-{wanted}") }
    }
}

impl Ledger for Book {
    fn next(&mut self) -> Option<Range<u64>> {
        while self.next < self.count && self.covered.contains(&self.next) {
            self.next += 1;
        }
        let start = self.next;
        let most = self.count.min(start + self.range);
        let end = self.covered.range(start..most).next().copied().unwrap_or(most);
        self.next = end;
        (start < end).then_some(start..end)
    }

    fn missing(&mut self) -> Vec<Range<u64>> {
        let mut missing: Vec<Range<u64>> = Vec::new();
        for number in (0..self.next).filter(|number| !self.covered.contains(number)) {
            match missing.last_mut() {
                Some(last) if last.end == number && !number.is_multiple_of(self.range) => last.end += 1,
                _ => missing.push(number..number + 1),
            }
        }
        missing
    }

    fn came(&mut self, range: Range<u64>, result: &[u8]) -> Came {
        if range.end > self.count || result.len() < 8 {
            return Came::Unreadable;
        }
        let known = self.covered.range(range.clone()).next().is_some();
        match self.results.get(&range.start) {
            Some((end, bytes)) if *end == range.end && bytes == result => Came::Same,
            _ if known => Came::Other,
            _ => {
                if let Some(file) = &mut self.file {
                    let digits: String = result.iter().map(|byte| format!("{byte:02x}")).collect();
                    writeln!(file, "{} {} {digits} .", range.start, range.end).expect("written");
                }
                self.take(range, result.to_vec());
                Came::New
            }
        }
    }

    fn is_whole(&self) -> bool {
        self.covered.len() as u64 == self.count
    }

    fn is_over(&self) -> bool {
        self.results.len() as u64 >= self.enough
    }
}
