//! What changed: the operands of the symbol table, compared from scan to scan.

use std::collections::VecDeque;

use sieben_cpu::Station;
use sieben_model::address::{Operand, Width};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::symbols::SymbolTable;

/// Changes that are kept: more than any screen shows, and no growth in a run of weeks.
pub(crate) const KEPT: usize = 200;

/// An operand under observation.
#[derive(Clone, Debug)]
pub(crate) struct Watched {
    /// What is read.
    pub(crate) operand: Operand,
    /// `Q 0.0`.
    pub(crate) address: String,
    /// `VALVE`.
    pub(crate) symbol: String,
    /// `Dosing valve`.
    pub(crate) comment: String,
    /// Raw bits, or the count of a counter.
    pub(crate) value: u32,
}

impl Watched {
    /// A value of this operand as the log writes it.
    pub(crate) fn show(&self, value: u32) -> String {
        match &self.operand {
            Operand::Address(address) => match address.width {
                Width::Bit => value.to_string(),
                Width::Byte => format!("16#{value:02X}"),
                Width::Word => format!("16#{value:04X}"),
                Width::DoubleWord | Width::QuadWord => format!("16#{value:08X}"),
            },
            _ => value.to_string(),
        }
    }
}

/// Something worth telling.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Entry {
    /// The scan after which it was seen.
    pub(crate) scan: u64,
    /// The time of the plant in milliseconds.
    pub(crate) time_ms: u64,
    /// What happened.
    pub(crate) event: Event,
}

/// The kinds of entries.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Event {
    /// An operand changed.
    Change {
        /// `Q 0.0`.
        address: String,
        /// `0→1`.
        values: String,
        /// `Dosing valve`.
        comment: String,
    },
    /// The plant, the CPU or the story did something.
    Note(String),
}

/// The observed operands and the newest changes.
#[derive(Clone, Debug)]
pub(crate) struct Changes {
    /// In the order of the symbol table.
    watched: Vec<Watched>,
    /// The newest entry last, at most [`KEPT`].
    pub(crate) entries: VecDeque<Entry>,
    /// Entries since the beginning.
    pub(crate) count: u64,
}

impl Changes {
    /// Observes every symbol that has a value.
    pub(crate) fn new(symbols: &SymbolTable, station: &dyn Station) -> Self {
        let watch = |symbol: &sieben_model::symbols::Symbol| {
            let operand = symbol.operand()?;
            Some(Watched {
                address: operand.spell(Mnemonics::English),
                symbol: symbol.name.clone(),
                comment: symbol.comment.clone(),
                value: station.read(&operand).ok()?,
                operand,
            })
        };
        Self { watched: symbols.symbols().iter().filter_map(watch).collect(), entries: VecDeque::new(), count: 0 }
    }

    /// Compares all operands with the scan before.
    pub(crate) fn observe(&mut self, station: &dyn Station, scan: u64, time_ms: u64) {
        let mut seen = Vec::new();
        for watched in &mut self.watched {
            let Ok(value) = station.read(&watched.operand) else { continue };
            if value != watched.value {
                let values = format!("{}→{}", watched.show(watched.value), watched.show(value));
                seen.push(Event::Change { address: watched.address.clone(), values, comment: watched.comment.clone() });
                watched.value = value;
            }
        }
        seen.into_iter().for_each(|event| self.push(Entry { scan, time_ms, event }));
    }

    /// Adds an entry and forgets the oldest beyond [`KEPT`].
    pub(crate) fn push(&mut self, entry: Entry) {
        if self.entries.len() == KEPT {
            self.entries.pop_front();
        }
        self.entries.push_back(entry);
        self.count += 1;
    }

    /// The operand with this address, in English letters.
    pub(crate) fn watched(&self, address: &str) -> Option<&Watched> {
        self.watched.iter().find(|watched| watched.address == address)
    }
}

/// `1204` as `1,204`.
pub(crate) fn thousands(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// `12.04 s` or `1:02:03.4`.
pub(crate) fn clock(time_ms: u64) -> String {
    let (minutes, seconds) = (time_ms / 60_000, time_ms % 60_000 / 1_000);
    match minutes {
        0 => format!("{seconds}.{:02} s", time_ms % 1_000 / 10),
        1..60 => format!("{minutes}:{seconds:02}.{} min", time_ms % 1_000 / 100),
        _ => format!("{}:{:02}:{seconds:02} h", minutes / 60, minutes % 60),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_times_are_easy_to_read() {
        assert_eq!(["0", "999", "1,204", "12,345,678"], [0, 999, 1_204, 12_345_678].map(thousands)[..]);
        assert_eq!(["12.04 s", "2:03.4 min", "1:02:03 h"], [12_040, 123_400, 3_723_000].map(clock)[..]);
    }
}
