//! The audit log: what was done from outside, by whom and between which scans, one JSON object on each line.

use std::collections::BTreeMap;
use std::net::SocketAddr;

use serde_json::{Map, Value, json};
use sieben_cpu::DateAndTime;
use sieben_workspace::control;
use sieben_workspace::settings::servers::Writes;

use super::{Recorder, Sink, Way};
use crate::s7comm::job::{BlockName, TransportSize, Variable, VariableArea};
use crate::s7comm::session::{Event, What};

/// Writes of the same client to the same item are one record for this long, in microseconds.
const MERGED_US: u64 = 1_000_000;
/// Items whose writes are merged at a time; one more, and all of them are noted.
const MERGED_MAX: usize = 1_024;
/// Bytes of a written value that are noted.
const VALUE_BYTES_MAX: usize = 512;

/// Notes what is done from outside.
pub struct Audit {
    recorder: Recorder,
    writes: Writes,
    required: bool,
    /// Writes that have a record already, with what came after it.
    merged: BTreeMap<Key, Merged>,
}

/// Whose writes to what are merged.
type Key = (SocketAddr, String);

/// Writes to an item since the record about the first of them.
struct Merged {
    /// Until when writes are merged, in microseconds of the gate's clock.
    until_us: u64,
    times: u64,
    /// The last of them, as it is noted.
    last: Map<String, Value>,
}

/// When something happened: in microseconds since 1970, and on the gate's clock.
#[derive(Clone, Copy, Debug)]
pub struct At {
    /// In microseconds since 1970.
    pub wall_us: u64,
    /// In microseconds on the clock of the gate.
    pub gate_us: u64,
}

/// What happened to a connection as such.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// It was accepted.
    Connected,
    /// It has ended.
    Closed,
    /// It was refused because of a limit.
    Refused,
}

impl Change {
    fn word(self) -> &'static str {
        match self {
            Self::Connected => "connect",
            Self::Closed => "close",
            Self::Refused => "refuse",
        }
    }
}

impl Audit {
    /// Notes into this sink.
    ///
    /// # Errors
    /// The system has no room for another thread.
    pub fn start(sink: Sink, writes: Writes, required: bool) -> std::io::Result<Self> {
        let lost = |lost: u64| line(json!({ "what": "lost", "records": lost }).as_object().cloned().unwrap_or_default());
        Ok(Self { recorder: Recorder::start("s7 audit", sink, lost)?, writes, required, merged: BTreeMap::new() })
    }

    /// A way for what is done at the control socket.
    pub fn of_control(&self) -> ControlLog {
        ControlLog(self.recorder.way())
    }

    /// Notes what happened to a connection.
    pub fn connection(&mut self, peer: SocketAddr, change: Change, at: At) {
        if change == Change::Closed {
            let of_peer: Vec<Key> = self.merged.keys().filter(|(other, _)| *other == peer).cloned().collect();
            of_peer.iter().for_each(|key| self.end_merging(key));
        }
        let mut record = head(&peer.to_string(), at.wall_us);
        record.insert("what".to_owned(), change.word().into());
        self.recorder.put(line(record));
    }

    /// Notes an event of a session.
    pub fn event(&mut self, event: &Event, at: At) {
        let mut record = head(&event.peer.to_string(), at.wall_us);
        if let Some(scan) = event.scan {
            record.insert("scan".to_owned(), scan.into());
        }
        record.insert("job".to_owned(), event.pdu_reference.into());
        let object = describe(&event.what, &mut record);
        record.insert("result".to_owned(), if event.error == 0 { "ok".into() } else { format!("{:04X}", event.error).into() });
        match object {
            // What is refused is noted each time.
            Some(object) if self.writes == Writes::Merged && event.error == 0 => self.merge(event.peer, object, record, at),
            _ => self.recorder.put(line(record)),
        }
    }

    /// Notes the first write to an item, and counts the next ones.
    fn merge(&mut self, peer: SocketAddr, object: String, record: Map<String, Value>, at: At) {
        self.tick(at.gate_us);
        let key = (peer, object);
        if let Some(merged) = self.merged.get_mut(&key) {
            merged.times += 1;
            merged.last = record;
            return;
        }
        if self.merged.len() >= MERGED_MAX {
            let keys: Vec<Key> = self.merged.keys().cloned().collect();
            keys.iter().for_each(|key| self.end_merging(key));
        }
        self.recorder.put(line(record.clone()));
        self.merged.insert(key, Merged { until_us: at.gate_us.saturating_add(MERGED_US), times: 0, last: record });
    }

    /// Notes what was merged for long enough.
    pub fn tick(&mut self, now_us: u64) {
        let due: Vec<Key> = self.merged.iter().filter(|(_, merged)| merged.until_us <= now_us).map(|(key, _)| key.clone()).collect();
        due.iter().for_each(|key| self.end_merging(key));
    }

    /// When [`Self::tick`] is due.
    pub fn wake_us(&self) -> Option<u64> {
        self.merged.values().map(|merged| merged.until_us).min()
    }

    fn end_merging(&mut self, key: &Key) {
        if let Some(Merged { times: times @ 1.., mut last, .. }) = self.merged.remove(key) {
            last.insert("times".to_owned(), times.into());
            self.recorder.put(line(last));
        }
    }

    /// Whether what is not noted has to be refused, and nothing can be noted at the moment.
    pub fn refuses(&self) -> bool {
        self.required && !self.recorder.has_room()
    }

    /// How many records were lost.
    pub fn lost(&self) -> u64 {
        self.recorder.lost()
    }
}

/// Notes what is done at the control socket and at pages, as long as the audit log is open.
#[derive(Clone)]
pub struct ControlLog(Way);

impl ControlLog {
    /// Notes the changes that a peer made. The time is in microseconds since 1970.
    pub fn note(&self, peer: &str, changes: &[control::changes::Change], wall_us: u64) {
        for change in changes {
            let mut record = head(peer, wall_us);
            let mut put = |key: &str, value: Value| drop(record.insert(key.to_owned(), value));
            if let Some(scan) = change.scan {
                put("scan", scan.into());
            }
            put("what", change.what.into());
            if let Some(object) = &change.object {
                put("object", object.as_str().into());
            }
            if let Some(value) = &change.value {
                put("value", value.as_str().into());
            }
            put("result", change.refused.unwrap_or("ok").into());
            self.0.put(line(record));
        }
    }
}

impl Drop for Audit {
    fn drop(&mut self) {
        let keys: Vec<Key> = self.merged.keys().cloned().collect();
        keys.iter().for_each(|key| self.end_merging(key));
    }
}

/// What each record begins with.
fn head(peer: &str, wall_us: u64) -> Map<String, Value> {
    let time = DateAndTime::from_ms_since_1970(wall_us / 1_000);
    let mut record = Map::new();
    record.insert("time".to_owned(), format!("{}Z", time.display().replace(' ', "T")).into());
    record.insert("peer".to_owned(), peer.into());
    record
}

fn line(record: Map<String, Value>) -> Vec<u8> {
    let mut line = Value::Object(record).to_string().into_bytes();
    line.push(b'\n');
    line
}

/// Adds what was done; the item, if it is one that was written.
fn describe(what: &What, record: &mut Map<String, Value>) -> Option<String> {
    let mut put = |key: &str, value: Value| drop(record.insert(key.to_owned(), value));
    let (word, block) = match what {
        What::Setup(bytes) => {
            put("pdu", (*bytes).into());
            ("setup", None)
        }
        What::Write(variable, bytes) => {
            let object = object(variable);
            put("what", "write".into());
            put("object", object.clone().into());
            let shown = bytes.get(..VALUE_BYTES_MAX).unwrap_or(bytes);
            put("value", shown.iter().map(|byte| format!("{byte:02X}")).collect::<String>().into());
            return Some(object);
        }
        What::SetClock => ("set_clock", None),
        What::Stop => ("stop", None),
        What::Start(restart) => {
            put("restart", restart.word().into());
            ("start", None)
        }
        What::CopyRamToRom => ("copy_ram_to_rom", None),
        What::Compress => ("compress", None),
        What::MemoryReset => ("memory_reset", None),
        What::Upload(block) => ("upload", Some(block)),
        What::Download(block) => ("download", Some(block)),
        What::Link(block) => ("link", Some(block)),
        What::Delete(block) => ("delete", Some(block)),
        What::Password => ("password", None),
        What::PasswordCleared => ("password_cleared", None),
    };
    put("what", word.into());
    if let Some(block) = block {
        put("object", block_text(block).into());
    }
    None
}

fn block_text(block: &BlockName) -> String {
    let kind = block.block_type.kind().map_or("SDB", |kind| kind.abbreviation());
    format!("{kind} {}", block.number)
}

/// The address of a variable as people spell it, `IW 0`, whatever it was written as; of more than a double word as an ANY pointer names it.
pub(crate) fn address(variable: &Variable) -> String {
    let Variable { area, size, count, address } = *variable;
    let bytes = match size {
        TransportSize::Bit => 0,
        TransportSize::Byte | TransportSize::Char => 1,
        TransportSize::Word | TransportSize::Int => 2,
        TransportSize::DoubleWord | TransportSize::DoubleInt | TransportSize::Real => 4,
        TransportSize::Timer | TransportSize::Counter => return object(variable),
    };
    let (byte, bit) = (address / 8, address % 8);
    let width = match (bytes * u32::from(count), count) {
        (0, 1) => None,
        (1, _) if bit == 0 => Some('B'),
        (2, _) if bit == 0 => Some('W'),
        (4, _) if bit == 0 => Some('D'),
        _ => return object(variable),
    };
    let area = match area {
        VariableArea::DataBlock(number) => format!("DB{number}.DB"),
        VariableArea::Peripheral => "P".to_owned(),
        VariableArea::Input => "I".to_owned(),
        VariableArea::Output => "Q".to_owned(),
        VariableArea::BitMemory => "M".to_owned(),
        VariableArea::Timer | VariableArea::Counter => return object(variable),
    };
    match width {
        Some(width) => format!("{area}{width} {byte}"),
        None if area.ends_with(".DB") => format!("{area}X {byte}.{bit}"),
        None => format!("{area} {byte}.{bit}"),
    }
}

/// A variable as an ANY pointer of STL names it: `P#DB1.DBX0.0 WORD 3`.
fn object(variable: &Variable) -> String {
    let Variable { area, size, count, address } = variable;
    let (byte, bit) = (address / 8, address % 8);
    let place = match area {
        VariableArea::Timer => return numbered("T", *address, *count),
        VariableArea::Counter => return numbered("C", *address, *count),
        VariableArea::DataBlock(number) => format!("DB{number}.DBX"),
        VariableArea::Peripheral => "P".to_owned(),
        VariableArea::Input => "I".to_owned(),
        VariableArea::Output => "Q".to_owned(),
        VariableArea::BitMemory => "M".to_owned(),
    };
    let size = match size {
        TransportSize::Bit => "BOOL",
        TransportSize::Byte => "BYTE",
        TransportSize::Char => "CHAR",
        TransportSize::Word => "WORD",
        TransportSize::Int => "INT",
        TransportSize::DoubleWord => "DWORD",
        TransportSize::DoubleInt => "DINT",
        TransportSize::Real => "REAL",
        TransportSize::Timer => "TIMER",
        TransportSize::Counter => "COUNTER",
    };
    format!("P#{place}{byte}.{bit} {size} {count}")
}

fn numbered(letter: &str, first: u32, count: u16) -> String {
    match count {
        0 | 1 => format!("{letter} {first}"),
        _ => format!("{letter} {first}..{}", first.saturating_add(u32::from(count) - 1)),
    }
}

#[cfg(test)]
mod tests {
    use std::io::{self, Write};
    use std::sync::{Arc, Mutex};

    use super::*;

    #[derive(Clone, Default)]
    struct Memory(Arc<Mutex<Vec<u8>>>);

    impl Write for Memory {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.0.lock().expect("a test").extend_from_slice(bytes);
            Ok(bytes.len())
        }
        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    fn noted(writes: Writes, what: impl FnOnce(&mut Audit)) -> Vec<String> {
        let memory = Memory::default();
        let mut audit = Audit::start(Box::new(memory.clone()), writes, false).expect("a thread");
        what(&mut audit);
        drop(audit);
        let text = String::from_utf8(memory.0.lock().expect("a test").clone()).expect("text");
        text.lines().map(str::to_owned).collect()
    }

    fn at(gate_us: u64) -> At {
        At { wall_us: 1_764_354_000_123_000 + gate_us, gate_us }
    }

    #[test]
    fn what_is_done_at_the_control_socket_has_its_records() {
        let change = |what, object: Option<&str>, value: Option<&str>, scan, refused| control::changes::Change {
            what,
            object: object.map(str::to_owned),
            value: value.map(str::to_owned),
            scan,
            refused,
        };
        let lines = noted(Writes::Merged, |audit| {
            let log = audit.of_control();
            log.note(
                "control socket",
                &[change("write", Some("MW10"), Some("5"), Some(12), None), change("stop", None, None, None, Some("P7094"))],
                0,
            );
        });
        let expected = [
            r#"{"time":"1990-01-01T00:00:00.000Z","peer":"control socket","scan":12,"what":"write","object":"MW10","value":"5","result":"ok"}"#,
            r#"{"time":"1990-01-01T00:00:00.000Z","peer":"control socket","what":"stop","result":"P7094"}"#,
        ];
        assert_eq!(lines, expected);
    }

    fn write(address: u32, value: u8, error: u16) -> Event {
        let variable = Variable { area: VariableArea::DataBlock(1), size: TransportSize::Byte, count: 1, address };
        Event {
            peer: "127.0.0.1:5000".parse().expect("an address"),
            pdu_reference: 7,
            scan: Some(12),
            what: What::Write(variable, Box::new([value])),
            error,
        }
    }

    #[test]
    fn writes_of_a_second_are_two_records_and_refusals_one_each() {
        let lines = noted(Writes::Merged, |audit| {
            for value in 0..100 {
                audit.event(&write(80, value, 0), at(u64::from(value) * 1_000));
            }
            audit.event(&write(80, 1, 3), at(200_000));
            audit.event(&write(88, 9, 0), at(300_000));
            audit.tick(1_000_000);
            audit.event(&write(80, 200, 0), at(1_100_000));
        });
        let expected = [
            r#"{"time":"2025-11-28T18:20:00.123Z","peer":"127.0.0.1:5000","scan":12,"job":7,"what":"write","object":"P#DB1.DBX10.0 BYTE 1","value":"00","result":"ok"}"#,
            r#"{"time":"2025-11-28T18:20:00.323Z","peer":"127.0.0.1:5000","scan":12,"job":7,"what":"write","object":"P#DB1.DBX10.0 BYTE 1","value":"01","result":"0003"}"#,
            r#"{"time":"2025-11-28T18:20:00.423Z","peer":"127.0.0.1:5000","scan":12,"job":7,"what":"write","object":"P#DB1.DBX11.0 BYTE 1","value":"09","result":"ok"}"#,
            r#"{"time":"2025-11-28T18:20:00.222Z","peer":"127.0.0.1:5000","scan":12,"job":7,"what":"write","object":"P#DB1.DBX10.0 BYTE 1","value":"63","result":"ok","times":99}"#,
            r#"{"time":"2025-11-28T18:20:01.223Z","peer":"127.0.0.1:5000","scan":12,"job":7,"what":"write","object":"P#DB1.DBX10.0 BYTE 1","value":"C8","result":"ok"}"#,
        ];
        assert_eq!(lines, expected);
        let all = noted(Writes::All, |audit| (0..100).for_each(|value| audit.event(&write(80, value, 0), at(0))));
        assert_eq!(all.len(), 100);
    }

    #[test]
    fn an_address_is_spelled_as_people_spell_it() {
        use TransportSize::{Bit, Byte, Int, Real, Timer, Word};
        use VariableArea::{BitMemory, DataBlock, Input, Output};
        for (area, size, count, address, wanted) in [
            (Input, Byte, 2, 0, "IW 0"),
            (Input, Word, 1, 16, "IW 2"),
            (BitMemory, Byte, 1, 80, "MB 10"),
            (Output, Bit, 1, 35, "Q 4.3"),
            (DataBlock(7), Real, 1, 32, "DB7.DBD 4"),
            (DataBlock(7), Bit, 1, 33, "DB7.DBX 4.1"),
            (DataBlock(7), Int, 2, 0, "DB7.DBD 0"),
            (BitMemory, Byte, 6, 0, "P#M0.0 BYTE 6"),
            (VariableArea::Timer, Timer, 1, 4, "T 4"),
        ] {
            assert_eq!(super::address(&Variable { area, size, count, address }), wanted);
        }
    }

    #[test]
    fn no_number_of_items_takes_more_memory() {
        let lines = noted(Writes::Merged, |audit| {
            for address in 0..3 * MERGED_MAX as u32 {
                audit.event(&write(address * 8, 0, 0), at(0));
                assert!(audit.merged.len() <= MERGED_MAX);
            }
        });
        assert_eq!(lines.len(), 3 * MERGED_MAX);
    }

    #[test]
    fn a_connection_that_ends_leaves_nothing_merged() {
        let peer = "127.0.0.1:5000".parse().expect("an address");
        let lines = noted(Writes::Merged, |audit| {
            audit.connection(peer, Change::Connected, at(0));
            (0..3).for_each(|value| audit.event(&write(80, value, 0), at(0)));
            audit.connection(peer, Change::Closed, at(10));
            assert_eq!(audit.wake_us(), None);
        });
        let words: Vec<_> = lines.iter().map(|line| serde_json::from_str::<Value>(line).expect("JSON")["what"].to_string()).collect();
        assert_eq!(words, ["\"connect\"", "\"write\"", "\"write\"", "\"close\""]);
    }

    #[test]
    fn everything_that_is_done_has_a_word() {
        let block =
            BlockName { block_type: crate::s7comm::job::BlockType::DataBlock, number: 5, place: crate::s7comm::job::BlockPlace::Active };
        for (what, part) in [
            (What::Setup(240), r#""pdu":240,"what":"setup","#),
            (What::SetClock, r#""what":"set_clock""#),
            (What::Stop, r#""what":"stop""#),
            (What::Start(sieben_cpu::Restart::Cold), r#""restart":"cold","what":"start""#),
            (What::CopyRamToRom, r#""what":"copy_ram_to_rom""#),
            (What::Compress, r#""what":"compress""#),
            (What::MemoryReset, r#""what":"memory_reset""#),
            (What::Upload(block), r#""what":"upload","object":"DB 5""#),
            (What::Download(block), r#""what":"download","object":"DB 5""#),
            (What::Link(block), r#""what":"link","object":"DB 5""#),
            (What::Delete(block), r#""what":"delete","object":"DB 5""#),
            (What::Password, r#""what":"password""#),
            (What::PasswordCleared, r#""what":"password_cleared""#),
        ] {
            let event = Event { what, scan: None, ..write(0, 0, 0xD241) };
            let lines = noted(Writes::Merged, |audit| audit.event(&event, at(0)));
            assert!(lines[0].contains(part), "{} has no {part}", lines[0]);
            assert!(lines[0].ends_with(r#""result":"D241"}"#));
        }
        let timers = Variable { area: VariableArea::Timer, size: TransportSize::Timer, count: 3, address: 4 };
        assert_eq!(object(&timers), "T 4..6");
    }
}
