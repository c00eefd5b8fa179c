//! The diagnostic buffer: what happened to the CPU, newest first.

use std::collections::VecDeque;

use sieben_engine::FaultPlace;

use crate::clock::DateAndTime;
use crate::communication::Requester;
pub use crate::diagnostic_events::event_text;
use crate::start_information::StartInformation;

/// A place as the user counts: `OB 1, statement 3`.
pub fn place_text(place: FaultPlace) -> String {
    format!("{}, statement {}", place.block, u64::from(place.statement) + 1)
}

/// One entry.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DiagnosticEntry {
    /// Event ID, priority class, OB number, data ID and both info words: the fields of the 20 bytes.
    pub fields: StartInformation,
    /// When it happened.
    pub time: DateAndTime,
    /// The statement that caused it, if one did.
    pub place: Option<FaultPlace>,
}

impl DiagnosticEntry {
    /// The event ID.
    pub fn event(&self) -> u16 {
        self.fields.event
    }

    /// The 20 bytes as the CPU stores them.
    pub fn bytes(&self) -> [u8; 20] {
        self.fields.bytes(self.time)
    }

    /// What happened, in one line: text, detail and place.
    pub fn text(&self) -> String {
        let mut text = event_text(self.event()).to_owned();
        if let Some(detail) = self.detail() {
            text = format!("{text}: {detail}");
        }
        match self.place {
            Some(place) => format!("{text} ({})", place_text(place)),
            None => text,
        }
    }

    fn detail(&self) -> Option<String> {
        let StartInformation { event, data_id, info_1, info_2, .. } = self.fields;
        Some(match event {
            // No bit of the peripheral is ever accessed: this is an array index that was looked at before the access.
            0x2522 | 0x2523 if data_id & 0xFF == 0 => format!("index {} is outside its array", info_1 as i16),
            0x2522 | 0x2523 | 0x2528 | 0x2529 => {
                let area = match data_id & 0xF {
                    0 => "peripheral",
                    1 => "input",
                    2 => "output",
                    3 => "bit memory",
                    4 => "DB",
                    5 => "DI",
                    6 => "local data",
                    7 => "local data of the caller",
                    _ => return Some(format!("byte {info_1}")),
                };
                let width = match data_id >> 4 & 0xF {
                    0 => "bit",
                    1 => "byte",
                    2 => "word",
                    _ => "double word",
                };
                format!("{area} {width} at byte {info_1}")
            }
            0x2524 | 0x2525 => format!("area code 16#{info_1:02X}"),
            0x2526 => format!("T {info_1}"),
            0x2527 => format!("C {info_1}"),
            0x2530..=0x2533 | 0x253A => format!("DB {info_1}"),
            0x2534 | 0x253C => format!("FC {info_1}"),
            0x2535 | 0x253E => format!("FB {info_1}"),
            0x253D => format!("SFC {info_1}"),
            0x253F => format!("SFB {info_1}"),
            0x2942 | 0x2943 => {
                let letter = match data_id >> 4 & 0xF {
                    0 | 1 => "B",
                    2 => "W",
                    _ => "D",
                };
                format!("P{}{letter} {info_1}", if event == 0x2942 { "I" } else { "Q" })
            }
            0x3501 if info_1 > 0 => format!("{info_1} ms in OB {}", info_2 & 0xFF),
            0x3502 | 0x3507 => format!("OB {}", info_2 & 0xFF),
            0x3505 | 0x3506 => {
                let blocks: Vec<String> = (0..8).filter(|bit| info_1 >> bit & 1 == 1).map(|bit| format!("OB {}", 10 + bit)).collect();
                blocks.join(", ")
            }
            0x35A1 | 0x35A2 => format!("event 16#{:04X} while OB {} ran", info_2 >> 16, info_2 & 0xFF),
            0x3842 | 0x3942 | 0x3861..=0x3865 | 0x3961 | 0x38C1..=0x38C6 | 0x39C1..=0x39C6 => format!("address {info_1}"),
            0x1381 | 0x1383 | 0x1385 | 0x4304 | 0x4307 => format!("asked for by {}", Requester::read(data_id, info_2)?),
            0x4309 | 0x430E if data_id == 1 => "retentive data was damaged".to_owned(),
            0x4309 | 0x430E if data_id == 2 => "retentive data belonged to another program".to_owned(),
            _ => return None,
        })
    }
}

/// The buffer. It holds as many entries as the CPU type allows and forgets the oldest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DiagnosticBuffer {
    entries: VecDeque<DiagnosticEntry>,
    capacity: usize,
    /// How many entries there have ever been.
    number: u64,
}

impl DiagnosticBuffer {
    /// An empty buffer.
    pub fn new(capacity: u16) -> Self {
        Self { entries: VecDeque::new(), capacity: usize::from(capacity.max(1)), number: 0 }
    }

    /// The entries, newest first.
    pub fn entries(&self) -> impl DoubleEndedIterator<Item = &DiagnosticEntry> + ExactSizeIterator {
        self.entries.iter()
    }

    /// The newest entry.
    pub fn newest(&self) -> Option<&DiagnosticEntry> {
        self.entries.front()
    }

    /// The running number of the newest entry: they count from 1, and numbers of forgotten entries do not come again. 0 if there has been none.
    pub fn newest_number(&self) -> u64 {
        self.number
    }

    /// The entries after the one with this number, with their own, oldest first. Asked with the last number that was given, it leaves out none;
    /// a gap in the numbers says that entries were forgotten meanwhile.
    pub fn newer_than(&self, number: u64) -> impl Iterator<Item = (u64, &DiagnosticEntry)> {
        let newer = self.number.saturating_sub(number);
        let count = usize::try_from(newer).unwrap_or(usize::MAX).min(self.entries.len());
        let numbered = self.entries.iter().take(count).enumerate();
        numbered.rev().map(|(index, entry)| (self.number - index as u64, entry))
    }

    /// The whole buffer as text, one line per entry, newest first.
    pub fn text(&self) -> String {
        self.entries.iter().map(|entry| format!("{}  16#{:04X}  {}\n", entry.time.display(), entry.event(), entry.text())).collect()
    }

    pub(crate) fn push(&mut self, entry: DiagnosticEntry) {
        self.entries.truncate(self.capacity - 1);
        self.entries.push_front(entry);
        self.number += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_buffer_forgets_the_oldest_entries() {
        let mut buffer = DiagnosticBuffer::new(3);
        for event in 1..=5 {
            let fields = StartInformation { event, ..StartInformation::default() };
            buffer.push(DiagnosticEntry { fields, time: DateAndTime::DEFAULT, place: None });
        }
        assert_eq!(buffer.entries().map(DiagnosticEntry::event).collect::<Vec<_>>(), [5, 4, 3]);
    }

    #[test]
    fn who_asks_for_new_entries_misses_none_and_sees_what_was_forgotten() {
        let mut buffer = DiagnosticBuffer::new(3);
        let mut push = |event| {
            let fields = StartInformation { event, ..StartInformation::default() };
            buffer.push(DiagnosticEntry { fields, time: DateAndTime::DEFAULT, place: None });
            buffer.clone()
        };
        let newer = |buffer: &DiagnosticBuffer, number| {
            buffer.newer_than(number).map(|(number, entry)| (number, entry.event())).collect::<Vec<_>>()
        };
        assert_eq!((DiagnosticBuffer::new(3).newest_number(), newer(&DiagnosticBuffer::new(3), 0)), (0, vec![]));
        push(11);
        let buffer = push(12);
        assert_eq!(newer(&buffer, 0), [(1, 11), (2, 12)]);
        assert_eq!(newer(&buffer, 1), [(2, 12)]);
        for number in [2, 3, u64::MAX] {
            assert_eq!(newer(&buffer, number), [], "{number}");
        }
        (13..=15).for_each(|event| drop(push(event)));
        let buffer = push(16);
        assert_eq!(buffer.newest_number(), 6);
        assert_eq!(newer(&buffer, 2), [(4, 14), (5, 15), (6, 16)], "the third is forgotten");
    }

    #[test]
    fn an_index_that_was_looked_at_is_told_from_an_access() {
        let text = |data_id| {
            let fields = StartInformation { event: 0x2522, data_id, info_1: 0xFFFE, ..StartInformation::default() };
            DiagnosticEntry { fields, time: DateAndTime::DEFAULT, place: None }.text()
        };
        assert!(text(0).ends_with("index -2 is outside its array"), "{}", text(0));
        assert!(text(0x24).ends_with("DB word at byte 65534"), "{}", text(0x24));
    }
}
