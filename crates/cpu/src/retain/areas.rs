//! Which bytes of bit memory, timers and counters are retentive.

use std::fmt;
use std::ops::RangeInclusive;

/// Numbers of bytes, timers or counters, as ranges in rising order that neither overlap nor touch.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Numbers(Vec<RangeInclusive<u16>>);

impl Numbers {
    /// One range, both ends included.
    pub fn range(range: RangeInclusive<u16>) -> Self {
        Self(if range.is_empty() { Vec::new() } else { vec![range] })
    }

    /// Reads `0..15`, `7`, or several of them with commas; an empty text is no number at all.
    ///
    /// # Errors
    /// One sentence that says what can be written instead.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut ranges = Vec::new();
        for part in text.split(',').map(str::trim) {
            if part.is_empty() && text.trim().is_empty() {
                break;
            }
            let (first, last) = part.split_once("..").unwrap_or((part, part));
            let number = |word: &str| word.trim().parse::<u16>().ok().filter(|_| word.trim().bytes().all(|byte| byte.is_ascii_digit()));
            let (Some(first), Some(last)) = (number(first), number(last)) else {
                return Err(format!("`{part}` is no range of numbers from 0 to 65535; write `0..15`, or `0..15, 20` for several"));
            };
            if first > last {
                return Err(format!("`{part}` runs backwards; write `{last}..{first}`"));
            }
            ranges.push(first..=last);
        }
        ranges.sort_by_key(|range| *range.start());
        let mut joined: Vec<RangeInclusive<u16>> = Vec::new();
        for range in ranges {
            match joined.last_mut() {
                Some(before) if u32::from(*range.start()) <= u32::from(*before.end()) + 1 => {
                    *before = *before.start()..=*before.end().max(range.end());
                }
                _ => joined.push(range),
            }
        }
        Ok(Self(joined))
    }

    /// Whether a number is one of them.
    pub fn contains(&self, number: u16) -> bool {
        self.0.iter().any(|range| range.contains(&number))
    }

    /// The ranges, in rising order.
    pub fn ranges(&self) -> impl Iterator<Item = RangeInclusive<u16>> {
        self.0.iter().cloned()
    }

    /// The greatest number.
    pub fn last(&self) -> Option<u16> {
        self.0.last().map(|range| *range.end())
    }

    /// Those that lie below `count`, as ranges of indexes.
    pub(crate) fn below(&self, count: usize) -> impl Iterator<Item = std::ops::Range<usize>> {
        self.0
            .iter()
            .map(move |range| usize::from(*range.start())..(usize::from(*range.end()) + 1).min(count))
            .filter(|range| !range.is_empty())
    }

    /// Resets everything below `all.len()` that is not one of them.
    pub(crate) fn clear_others<T: Default + Clone>(&self, all: &mut [T]) {
        let mut cursor = 0;
        for range in self.below(all.len()) {
            all[cursor..range.start].fill(T::default());
            cursor = range.end;
        }
        all[cursor..].fill(T::default());
    }
}

impl fmt::Display for Numbers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, range) in self.0.iter().enumerate() {
            let comma = if index > 0 { ", " } else { "" };
            match range.start() == range.end() {
                true => write!(f, "{comma}{}", range.start())?,
                false => write!(f, "{comma}{}..{}", range.start(), range.end())?,
            }
        }
        Ok(())
    }
}

/// What is retentive beside the data blocks. The default is that of the CPU types: MB 0 to MB 15, C 0 to C 7, no timer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RetentiveAreas {
    /// Bytes of bit memory.
    pub bit_memory: Numbers,
    /// S5 timers.
    pub timers: Numbers,
    /// S5 counters.
    pub counters: Numbers,
}

impl Default for RetentiveAreas {
    fn default() -> Self {
        Self { bit_memory: Numbers::range(0..=15), timers: Numbers::default(), counters: Numbers::range(0..=7) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_read_joined_and_written() {
        for (text, expected) in [
            ("0..15", "0..15"),
            ("", ""),
            ("  ", ""),
            ("7", "7"),
            ("20, 0..15", "0..15, 20"),
            ("0..5,3..9", "0..9"),
            ("0..5,6..9", "0..9"),
            ("0..9,2..3", "0..9"),
            ("65535, 65534", "65534..65535"),
            ("0..65535,65535", "0..65535"),
        ] {
            let numbers = Numbers::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
            assert_eq!(numbers.to_string(), expected, "{text}");
        }
        for text in ["a", "0..", "..5", "-1", "0..65536", "5..2", "1,,2", "1,", "+3", "0...5", "0..=5", "MB0", "1 2"] {
            assert!(Numbers::parse(text).is_err(), "{text}");
        }
        assert_eq!(Numbers::parse("5..2").unwrap_err(), "`5..2` runs backwards; write `2..5`");
    }

    #[test]
    fn only_what_is_not_retentive_is_cleared() {
        let numbers = Numbers::parse("1..2, 4, 9..20").unwrap();
        let mut all = [1u8; 12];
        numbers.clear_others(&mut all);
        assert_eq!(all, [0, 1, 1, 0, 1, 0, 0, 0, 0, 1, 1, 1]);
        for (index, &byte) in all.iter().enumerate() {
            assert_eq!(numbers.contains(index as u16), byte == 1);
        }
        let mut none = [1u8; 2];
        Numbers::default().clear_others(&mut none);
        assert_eq!(none, [0, 0]);
        Numbers::parse("5").unwrap().clear_others(&mut none);
        assert_eq!(Numbers::parse("5").unwrap().below(2).count(), 0);
    }
}
