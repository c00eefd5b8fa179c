//! The diagnostic buffer: what happened to the CPU, newest first.

use std::collections::VecDeque;

use sieben_engine::FaultPlace;

use crate::clock::DateAndTime;
use crate::organization_blocks::StartInformation;

/// Event IDs with their texts, by number.
const EVENTS: &[(u16, &str)] = &[
    (0x1381, "request for a warm restart by hand"),
    (0x1382, "request for an automatic warm restart"),
    (0x1383, "request for a hot restart by hand"),
    (0x1384, "request for an automatic hot restart"),
    (0x1385, "request for a cold restart by hand"),
    (0x1386, "request for an automatic cold restart"),
    (0x2521, "BCD conversion error: a digit is greater than 9"),
    (0x2522, "area length error when reading"),
    (0x2523, "area length error when writing"),
    (0x2524, "area error when reading: the pointer names no area that can be read here"),
    (0x2525, "area error when writing: the pointer names no area that can be written here"),
    (0x2526, "timer number error: the CPU has no timer with this number"),
    (0x2527, "counter number error: the CPU has no counter with this number"),
    (0x2528, "alignment error when reading: the bit part of the address is not 0"),
    (0x2529, "alignment error when writing: the bit part of the address is not 0"),
    (0x2530, "write error: the shared data block is write-protected"),
    (0x2531, "write error: the instance data block is write-protected"),
    (0x2532, "DB number error: the number of the shared data block is too high"),
    (0x2533, "DI number error: the number of the instance data block is too high"),
    (0x2534, "FC number error: the number is too high"),
    (0x2535, "FB number error: the number is too high"),
    (0x253A, "the data block is not loaded"),
    (0x253C, "the FC is not loaded"),
    (0x253D, "the SFC does not exist"),
    (0x253E, "the FB is not loaded"),
    (0x253F, "the SFB does not exist"),
    (0x2942, "I/O access error when reading"),
    (0x2943, "I/O access error when writing"),
    (0x3501, "cycle time exceeded"),
    (0x3502, "the organization block was requested while it still ran"),
    (0x3505, "time-of-day interrupt skipped: the clock was set forward"),
    (0x3506, "time-of-day interrupt skipped when the CPU went to RUN"),
    (0x3507, "overflow of the request buffer of an organization block"),
    (0x3509, "interrupt lost: the interrupt load is too high"),
    (0x3571, "nesting stack error: too many open brackets, or one closed too many"),
    (0x3572, "MCR stack error: too many open MCR zones, or one closed too many"),
    (0x3573, "nesting of synchronous errors too deep"),
    (0x3574, "interrupt stack error: blocks nested too deep"),
    (0x3575, "block stack error: calls nested too deep"),
    (0x3576, "not enough local data"),
    (0x3578, "unknown instruction"),
    (0x357A, "a jump out of the block"),
    (0x3822, "backup works again: retentive data is kept"),
    (0x3922, "no backup: retentive data cannot be kept"),
    (0x4300, "power on with battery backup"),
    (0x4301, "mode change from STOP to STARTUP"),
    (0x4302, "mode change from STARTUP to RUN"),
    (0x4303, "STOP by the mode switch"),
    (0x4304, "STOP by a programming device or SFB 20"),
    (0x4305, "HOLD entered"),
    (0x4306, "HOLD left"),
    (0x4307, "memory reset started by a programming device"),
    (0x4308, "memory reset started by the mode switch"),
    (0x4309, "memory reset started automatically"),
    (0x430A, "mode change from HOLD to STOP"),
    (0x430E, "memory reset done"),
    (0x4541, "STOP by the priority class system"),
    (0x4543, "STOP by the test functions"),
    (0x4544, "STOP by the diagnostic system"),
    (0x4545, "STOP by the communication system"),
    (0x4546, "STOP by the memory management"),
    (0x4547, "STOP by the process image management"),
    (0x4548, "STOP by the I/O management"),
    (0x4555, "STOP: the restart took too long"),
    (0x4556, "STOP: memory reset requested"),
    (0x4562, "STOP: programming error, and OB 121 is not loaded"),
    (0x4563, "STOP: I/O access error, and OB 122 is not loaded"),
    (0x4568, "STOP: time error, and OB 80 is not loaded or the time was exceeded again"),
    (0x456A, "STOP: diagnostic interrupt, and OB 82 is not loaded"),
    (0x456B, "STOP: a module was inserted or removed, and OB 83 is not loaded"),
    (0x456C, "STOP: CPU hardware fault, and OB 84 is not loaded"),
    (0x456D, "STOP: priority class error, and OB 85 is not loaded"),
    (0x456E, "STOP: communication error, and OB 87 is not loaded"),
    (0x456F, "STOP: rack or station failure, and OB 86 is not loaded"),
    (0x4570, "STOP: processing of a block was aborted, and OB 88 is not loaded or was aborted itself"),
    (0x4571, "STOP: nesting stack error"),
    (0x4572, "STOP: MCR stack error"),
    (0x4573, "STOP: nesting of synchronous errors too deep"),
    (0x4574, "STOP: interrupt stack error"),
    (0x4575, "STOP: block stack error, calls nested too deep"),
    (0x4576, "STOP: not enough local data"),
    (0x4578, "STOP: unknown instruction"),
    (0x457A, "STOP: a jump out of the block"),
    (0x457F, "STOP by the program (SFC 46 STP)"),
    (0x4590, "STOP: overload"),
];

/// The text of an event ID.
pub fn event_text(event: u16) -> &'static str {
    match EVENTS.binary_search_by_key(&event, |row| row.0) {
        Ok(row) => EVENTS[row].1,
        Err(_) => "unknown event",
    }
}

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
}

impl DiagnosticBuffer {
    /// An empty buffer.
    pub fn new(capacity: u16) -> Self {
        Self { entries: VecDeque::new(), capacity: usize::from(capacity.max(1)) }
    }

    /// The entries, newest first.
    pub fn entries(&self) -> impl DoubleEndedIterator<Item = &DiagnosticEntry> + ExactSizeIterator {
        self.entries.iter()
    }

    /// The newest entry.
    pub fn newest(&self) -> Option<&DiagnosticEntry> {
        self.entries.front()
    }

    /// The whole buffer as text, one line per entry, newest first.
    pub fn text(&self) -> String {
        self.entries.iter().map(|entry| format!("{}  16#{:04X}  {}\n", entry.time.display(), entry.event(), entry.text())).collect()
    }

    pub(crate) fn push(&mut self, entry: DiagnosticEntry) {
        self.entries.truncate(self.capacity - 1);
        self.entries.push_front(entry);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_events_are_sorted_and_have_texts() {
        assert!(EVENTS.windows(2).all(|pair| pair[0].0 < pair[1].0));
        assert!(EVENTS.iter().all(|row| !row.1.is_empty() && event_text(row.0) == row.1));
        assert_eq!(event_text(0), "unknown event");
    }

    #[test]
    fn the_buffer_forgets_the_oldest_entries() {
        let mut buffer = DiagnosticBuffer::new(3);
        for event in 1..=5 {
            let fields = StartInformation { event, ..StartInformation::default() };
            buffer.push(DiagnosticEntry { fields, time: DateAndTime::DEFAULT, place: None });
        }
        assert_eq!(buffer.entries().map(DiagnosticEntry::event).collect::<Vec<_>>(), [5, 4, 3]);
    }
}
