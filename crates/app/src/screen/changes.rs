//! What changed: the operands of the symbol table, compared from scan to scan.

use std::collections::VecDeque;
use std::sync::Arc;

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
    pub(crate) watched: Arc<[Watched]>,
    /// Their raw bits, or the count of a counter.
    pub(crate) values: Vec<u32>,
    /// The newest entry last, at most [`KEPT`].
    entries: VecDeque<Arc<Entry>>,
    /// Entries since the beginning.
    pub(crate) count: u64,
}

impl Changes {
    /// Observes every symbol that has a value.
    pub(crate) fn new(symbols: &SymbolTable, station: &dyn Station) -> Self {
        let watch = |symbol: &sieben_model::symbols::Symbol| {
            let operand = symbol.operand()?;
            let value = station.read(&operand).ok()?;
            let (address, symbol, comment) = (operand.spell(Mnemonics::English), symbol.name.clone(), symbol.comment.clone());
            Some((Watched { operand, address, symbol, comment }, value))
        };
        let (watched, values): (Vec<_>, Vec<_>) = symbols.symbols().iter().filter_map(watch).unzip();
        Self { watched: watched.into(), values, entries: VecDeque::new(), count: 0 }
    }

    /// Compares all operands with the scan before.
    pub(crate) fn observe(&mut self, station: &dyn Station, scan: u64, time_ms: u64) {
        let watched = Arc::clone(&self.watched);
        for (index, watched) in watched.iter().enumerate() {
            let Ok(value) = station.read(&watched.operand) else { continue };
            let before = std::mem::replace(&mut self.values[index], value);
            if value != before {
                let values = format!("{}→{}", watched.show(before), watched.show(value));
                let event = Event::Change { address: watched.address.clone(), values, comment: watched.comment.clone() };
                self.push(Entry { scan, time_ms, event });
            }
        }
    }

    /// Adds an entry and forgets the oldest beyond [`KEPT`].
    pub(crate) fn push(&mut self, entry: Entry) {
        if self.entries.len() == KEPT {
            self.entries.pop_front();
        }
        self.entries.push_back(Arc::new(entry));
        self.count += 1;
    }

    /// How many entries there is memory for.
    #[cfg(test)]
    pub(crate) fn room(&self) -> usize {
        self.entries.capacity()
    }

    /// The newest entries that are kept, so many at most, the oldest of them first.
    pub(crate) fn newest(&self, most: usize) -> impl Iterator<Item = &Arc<Entry>> {
        self.entries.iter().skip(self.entries.len().saturating_sub(most))
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
