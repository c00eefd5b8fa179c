//! Group 3 of userdata: lists of blocks and their headers.

use super::codes::Refusal;
use super::names;
use super::userdata::Content;
use crate::s7comm::job::{BlockPlace, BlockType, Job, Reply};

/// Subfunctions.
const COUNTS: u8 = 1;
const LIST: u8 = 2;
const INFO: u8 = 3;
/// Bytes of a block in a list: its number, its flags, its language.
const ENTRY_BYTES: usize = 4;
/// Bytes of the information about a block after its type and this length itself.
const INFO_BYTES: u16 = 74;
/// Flags of a block that is linked, of one that is passive, and of a system block.
pub const LINKED: u8 = 0x22;
/// Flags of a block that is in the load memory only.
pub const PASSIVE: u8 = 0x12;
/// Flags of a block that belongs to the CPU.
pub const SYSTEM: u8 = 0x42;

/// The job that a request means; `data` are the bytes after `FF 09` and the length, none if the request has no data.
///
/// # Errors
/// Why it is refused.
pub fn read(subfunction: u8, data: &[u8]) -> Result<Job, Refusal> {
    match subfunction {
        COUNTS => Ok(Job::BlockCounts),
        LIST => {
            let characters = data.try_into().map_err(|_| Refusal::BlockParameterSyntax)?;
            BlockType::from_characters(characters).map(Job::BlockList).ok_or(Refusal::BlockNameSyntax)
        }
        INFO => names::read(data).map(Job::BlockInfo),
        _ => Err(Refusal::NotImplemented),
    }
}

/// The data of the answer.
///
/// # Errors
/// Why the job is refused.
pub fn write(job: &Job, reply: &Reply) -> Result<Content, Refusal> {
    match (job, reply) {
        (_, Reply::Refused(refusal)) => Err(*refusal),
        (Job::BlockCounts, Reply::BlockCounts(counts)) => {
            let entry = |&(block_type, count): &(BlockType, u16)| {
                let ([type_1, type_2], [high, low]) = (block_type.characters(), count.to_be_bytes());
                [type_1, type_2, high, low]
            };
            Ok(Content { bytes: counts.iter().flat_map(entry).collect(), grain: 0 })
        }
        (Job::BlockList(_), Reply::BlockList(entries)) => {
            let entry = |entry: &crate::s7comm::job::BlockEntry| {
                let [high, low] = entry.number.to_be_bytes();
                [high, low, entry.flags, entry.language]
            };
            // Clients count the blocks of each fragment.
            Ok(Content { bytes: entries.iter().flat_map(entry).collect(), grain: ENTRY_BYTES })
        }
        (Job::BlockInfo(_), Reply::BlockInfo { name, header, footer }) => {
            let flags = match name.place {
                _ if matches!(name.block_type, BlockType::SystemFunction | BlockType::SystemFunctionBlock) => SYSTEM,
                BlockPlace::Passive => PASSIVE,
                BlockPlace::Active | BlockPlace::Both => LINKED,
            };
            let bytes = [&name.block_type.characters()[..], &INFO_BYTES.to_be_bytes(), &[0, flags], header, footer].concat();
            Ok(Content { bytes, grain: 0 })
        }
        _ => Err(Refusal::CannotPerform),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::s7comm::job::{BlockEntry, BlockName};

    #[test]
    fn requests_name_a_type_or_a_block() {
        assert_eq!(read(1, &[]), Ok(Job::BlockCounts));
        assert_eq!(read(2, b"0A"), Ok(Job::BlockList(BlockType::DataBlock)));
        let name = BlockName { block_type: BlockType::OrganizationBlock, number: 1, place: BlockPlace::Active };
        assert_eq!(read(3, b"0800001A"), Ok(Job::BlockInfo(name)));
        let refused: [(u8, &[u8], Refusal); 6] = [
            (2, b"", Refusal::BlockParameterSyntax),
            (2, b"0A0", Refusal::BlockParameterSyntax),
            (2, b"0X", Refusal::BlockNameSyntax),
            (3, b"0800001", Refusal::BlockNameSyntax),
            (3, b"0A99999A", Refusal::BlockNumber),
            (4, b"", Refusal::NotImplemented),
        ];
        for (subfunction, data, refusal) in refused {
            assert_eq!(read(subfunction, data), Err(refusal), "{subfunction} {}", data.escape_ascii());
        }
    }

    #[test]
    fn counts_are_in_the_order_that_clients_know() {
        let counts = BlockType::all().map(|block_type| (block_type, 0x0102)).collect();
        let bytes = write(&Job::BlockCounts, &Reply::BlockCounts(counts)).expect("an answer").bytes;
        assert_eq!(bytes.len(), 28);
        let types: Vec<u8> = bytes.chunks(4).map(|entry| entry[1]).collect();
        assert_eq!(types, *b"8ECABDF");
        assert!(bytes.chunks(4).all(|entry| (entry[0], &entry[2..]) == (b'0', &[1, 2])));
    }

    #[test]
    fn a_list_is_cut_between_blocks() {
        let entries =
            vec![BlockEntry { number: 1, flags: LINKED, language: 5 }, BlockEntry { number: 0x0203, flags: PASSIVE, language: 1 }];
        let content = write(&Job::BlockList(BlockType::DataBlock), &Reply::BlockList(entries)).expect("an answer");
        assert_eq!(content, Content { bytes: vec![0, 1, 0x22, 5, 2, 3, 0x12, 1], grain: 4 });
    }

    #[test]
    fn information_is_78_bytes_with_header_and_footer() {
        for (block_type, place, flags) in [
            (BlockType::DataBlock, BlockPlace::Active, 0x22),
            (BlockType::DataBlock, BlockPlace::Passive, 0x12),
            (BlockType::SystemFunction, BlockPlace::Active, 0x42),
        ] {
            let name = BlockName { block_type, number: 7, place };
            let reply = Reply::BlockInfo { name, header: [1; 36], footer: [2; 36] };
            let bytes = write(&Job::BlockInfo(name), &reply).expect("an answer").bytes;
            let [type_1, type_2] = block_type.characters();
            assert_eq!(bytes[..6], [type_1, type_2, 0, 0x4A, 0, flags]);
            assert_eq!((bytes.len(), &bytes[6..42], &bytes[42..]), (78, &[1; 36][..], &[2; 36][..]));
        }
    }
}
