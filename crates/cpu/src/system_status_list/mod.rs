//! The system status list (SZL): what a CPU tells about itself, list by list. SFC 51 and protocols read it here.

mod communication;
mod diagnosis;
mod identification;
pub mod memory;
mod modules;
mod operation;

use std::collections::BTreeMap;
use std::fmt;

use sieben_engine::Program;
use sieben_model::cpu_type::CpuType;

use crate::clock::DateAndTime;
use crate::communication::Communication;
use crate::diagnostic_buffer::DiagnosticBuffer;
use crate::forcing::Forces;
use crate::io::Rack;
use crate::mode::OperatingMode;
use crate::start_information::StartInformation;

/// What the list is made from.
#[derive(Clone, Copy)]
pub struct SystemStatus<'a> {
    /// What the CPU is.
    pub cpu_type: &'static CpuType,
    /// What is loaded.
    pub program: &'a Program,
    /// The modules.
    pub rack: &'a Rack,
    /// What happened.
    pub diagnostics: &'a DiagnosticBuffer,
    /// What the CPU is doing.
    pub mode: OperatingMode,
    /// Start information of the last startup.
    pub startup: StartInformation,
    /// Start information of the last start of every organization block, by its number.
    pub started: &'a BTreeMap<u16, StartInformation>,
    /// The time of day.
    pub time: DateAndTime,
    /// What is known about the clock: bit 15 = behind the base time, bits 14 to 10 half hours of difference, bit 9 = change
    /// announced, bit 8 = daylight saving time.
    pub clock_status: u16,
    /// Run-time meters in hours.
    pub meters: [u32; 8],
    /// Which of them run, meter 0 in bit 0.
    pub meters_running: u8,
    /// What servers have told of connections, protection and names.
    pub communication: &'a Communication,
    /// Whether anything is forced.
    pub forces: Forces,
}

/// A partial list as it was asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartialList {
    /// SZL_ID.
    pub id: u16,
    /// INDEX.
    pub index: u16,
    /// LENTHDR: bytes of one record.
    pub record_bytes: u16,
    /// The records.
    pub records: Vec<Vec<u8>>,
    /// N_DR: how many records there are. More than `records` where only the header was asked for.
    pub count: u16,
}

/// Why there is no such list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoList {
    /// The CPU has no list of this SZL_ID.
    Id,
    /// The list has nothing under this INDEX.
    Index,
}

impl fmt::Display for NoList {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Id => "the CPU has no status list with this ID",
            Self::Index => "the status list has nothing under this index",
        })
    }
}

impl std::error::Error for NoList {}

/// How the records of a list are chosen.
#[derive(Clone, Copy)]
enum Records {
    /// All of them (extract 0), that of an index, which stands in its first two bytes (extract 1), or only the header (extract F).
    Indexed(fn(&SystemStatus<'_>) -> Vec<Vec<u8>>),
    /// As above, but the index says nothing: all records (extract 0), only the header (extract F).
    Whole(fn(&SystemStatus<'_>) -> Vec<Vec<u8>>),
    /// This extract alone, by an index that it understands; `None` if it does not.
    By(fn(&SystemStatus<'_>, u16) -> Option<Vec<Vec<u8>>>),
}

/// One row: SZL_ID (with extract 0 where there are several), bytes of a record, its records.
struct List {
    id: u16,
    record_bytes: u16,
    records: Records,
}

const fn list(id: u16, record_bytes: u16, records: Records) -> List {
    List { id, record_bytes, records }
}

/// All lists, by number.
static LISTS: &[List] = &[
    list(0x0000, 2, Records::Whole(ids)),
    list(0x0011, 28, Records::Indexed(identification::module)),
    list(0x0012, 2, Records::Whole(identification::features)),
    list(0x0112, 2, Records::By(identification::features_of_group)),
    list(0x0013, 36, Records::Indexed(memory::areas)),
    list(0x0014, 8, Records::Indexed(memory::system_areas)),
    list(0x0015, 10, Records::Indexed(memory::block_types)),
    list(0x0019, 4, Records::Indexed(operation::lights)),
    list(0x001C, 34, Records::Indexed(identification::component)),
    list(0x0022, 28, Records::Whole(operation::organization_blocks)),
    list(0x0222, 28, Records::By(operation::organization_block)),
    list(0x0024, 20, Records::Whole(operation::mode_changes)),
    list(0x0124, 20, Records::By(operation::last_mode_change)),
    list(0x0424, 20, Records::By(operation::mode)),
    list(0x0037, 48, Records::Indexed(communication::ethernet)),
    list(0x0074, 4, Records::Indexed(operation::lights)),
    list(0x0090, 14, Records::Whole(modules::dp_masters)),
    list(0x0091, 16, Records::Whole(modules::all)),
    list(0x0591, 16, Records::By(modules::all_of_index_0)),
    list(0x0A91, 16, Records::By(modules::dp_masters_of_index_0)),
    list(0x0C91, 16, Records::By(modules::at_address)),
    list(0x0D91, 16, Records::By(modules::in_rack)),
    list(0x0092, 16, Records::By(modules::configured_racks)),
    list(0x0292, 16, Records::By(modules::configured_racks)),
    list(0x0692, 16, Records::By(modules::faulty_racks)),
    list(0x00A0, 20, Records::Whole(diagnosis::buffer)),
    list(0x01A0, 20, Records::By(diagnosis::newest)),
    list(0x0131, 40, Records::By(communication::capability)),
    list(0x0132, 40, Records::By(communication::status)),
    list(0x0232, 40, Records::By(communication::protection)),
];

/// The extract that stands for the header alone.
const HEADER: u16 = 0x0F00;

impl SystemStatus<'_> {
    /// The partial list of an SZL_ID and an INDEX.
    ///
    /// # Errors
    /// There is no such list, or it has nothing under the index.
    pub fn read(&self, id: u16, index: u16) -> Result<PartialList, NoList> {
        let extract = id & 0x0F00;
        // Bits 12 to 15 are the class of the module: 0 is the CPU.
        if let Some(row) = LISTS.iter().find(|row| row.id == id) {
            let records = match row.records {
                Records::Indexed(all) | Records::Whole(all) => all(self),
                Records::By(of) => of(self, index).ok_or(NoList::Index)?,
            };
            return Ok(whole(id, index, row, records));
        }
        let row = LISTS.iter().find(|row| row.id == id & 0x00FF).ok_or(NoList::Id)?;
        match (row.records, extract) {
            (Records::Indexed(all), 0x0100) => {
                let of_index = |record: &Vec<u8>| record.starts_with(&index.to_be_bytes());
                let records: Vec<Vec<u8>> = all(self).into_iter().filter(of_index).collect();
                if records.is_empty() { Err(NoList::Index) } else { Ok(whole(id, index, row, records)) }
            }
            (Records::Indexed(all) | Records::Whole(all), HEADER) => {
                let count = u16::try_from(all(self).len()).unwrap_or(u16::MAX);
                Ok(PartialList { id, index, record_bytes: row.record_bytes, records: Vec::new(), count })
            }
            _ => Err(NoList::Id),
        }
    }
}

fn whole(id: u16, index: u16, row: &List, records: Vec<Vec<u8>>) -> PartialList {
    let count = u16::try_from(records.len()).unwrap_or(u16::MAX);
    PartialList { id, index, record_bytes: row.record_bytes, records, count }
}

/// List 16#0000: every SZL_ID.
fn ids(_: &SystemStatus<'_>) -> Vec<Vec<u8>> {
    let extracts = |row: &List| -> Vec<u16> {
        match row.records {
            Records::Indexed(_) => vec![row.id, row.id | 0x0100, row.id | HEADER],
            Records::Whole(_) => vec![row.id, row.id | HEADER],
            Records::By(_) => vec![row.id],
        }
    };
    let mut ids: Vec<u16> = LISTS.iter().flat_map(extracts).collect();
    ids.sort_unstable();
    ids.into_iter().map(|id| id.to_be_bytes().to_vec()).collect()
}

/// A record put together field by field, filled up with zeros or cut to its length.
fn record(bytes: usize, fields: &[&[u8]]) -> Vec<u8> {
    let mut record = fields.concat();
    record.resize(bytes, 0);
    record
}

/// A record of words.
fn words(bytes: usize, fields: &[u16]) -> Vec<u8> {
    let fields: Vec<u8> = fields.iter().flat_map(|field| field.to_be_bytes()).collect();
    record(bytes, &[&fields])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_status(check: impl FnOnce(&SystemStatus<'_>)) {
        let cpu_type: &'static CpuType = &CpuType::ALL[0];
        let (program, rack, diagnostics) = (Program::default(), Rack::simulated(cpu_type), DiagnosticBuffer::new(10));
        check(&SystemStatus {
            cpu_type,
            program: &program,
            rack: &rack,
            diagnostics: &diagnostics,
            mode: OperatingMode::Run,
            startup: StartInformation::default(),
            started: &BTreeMap::new(),
            time: DateAndTime::DEFAULT,
            clock_status: 0,
            meters: [0; 8],
            meters_running: 0,
            communication: &Communication::default(),
            forces: Forces::None,
        });
    }

    #[test]
    fn every_record_of_every_list_has_the_length_of_its_header() {
        with_status(|status| {
            for id in ids(status) {
                let id = u16::from_be_bytes([id[0], id[1]]);
                for index in (0..=0x20).chain([0x50, 0x0100, 0x0800, 0x0A00, 0xFFFF]) {
                    let Ok(list) = status.read(id, index) else { continue };
                    assert!(list.records.iter().all(|record| record.len() == usize::from(list.record_bytes)), "16#{id:04X}");
                    assert!(usize::from(list.count) >= list.records.len(), "16#{id:04X}");
                }
            }
        });
    }

    #[test]
    fn no_id_and_no_index_panics() {
        with_status(|status| {
            for id in 0..=u16::MAX {
                let _ = status.read(id, id.rotate_left(5));
            }
            assert_eq!(status.read(0x7777, 0), Err(NoList::Id));
            assert_eq!(status.read(0x0111, 99), Err(NoList::Index));
        });
    }

    #[test]
    fn the_order_number_and_the_mode_are_where_clients_look() {
        with_status(|status| {
            let identification = status.read(0x0011, 0).expect("a list");
            assert_eq!(&identification.records[0][..22], b"\0\x016ES7 315-2EH14-0AB0 ");
            let last = identification.records.last().expect("a record");
            assert_eq!(last[0..2], [0, 7], "the firmware stands last");
            let mode = status.read(0x0424, 0).expect("a list");
            assert_eq!(mode.records[0][3], 8, "RUN");
            assert_eq!(status.read(0x0F11, 0).map(|list| (list.records.len(), list.count)), Ok((0, 3)));
        });
    }
}
