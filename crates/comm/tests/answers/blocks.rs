//! Counts, lists, headers, upload and download.

use sieben_comm::s7comm::job::{BlockPlace, BlockType, Job, Reply};
use sieben_comm::s7comm::wire::codes::Refusal;

use crate::{Station, data, downloaded, image, named};

const ALL: [BlockType; 7] = [
    BlockType::OrganizationBlock,
    BlockType::FunctionBlock,
    BlockType::Function,
    BlockType::DataBlock,
    BlockType::SystemDataBlock,
    BlockType::SystemFunction,
    BlockType::SystemFunctionBlock,
];

fn counts(station: &mut Station) -> Vec<u16> {
    match station.ends(&Job::BlockCounts) {
        Reply::BlockCounts(counts) => {
            assert_eq!(counts.iter().map(|row| row.0).collect::<Vec<_>>(), ALL);
            counts.into_iter().map(|row| row.1).collect()
        }
        reply => panic!("{reply:?}"),
    }
}

fn list(station: &mut Station, block_type: BlockType) -> Vec<(u16, u8, u8)> {
    match station.ends(&Job::BlockList(block_type)) {
        Reply::BlockList(entries) => entries.into_iter().map(|entry| (entry.number, entry.flags, entry.language)).collect(),
        Reply::Refused(Refusal::NoFurtherBlock) => Vec::new(),
        reply => panic!("{reply:?}"),
    }
}

/// Place, header and footer.
fn info(station: &mut Station, block_type: BlockType, number: u16) -> Option<(BlockPlace, Vec<u8>, Vec<u8>)> {
    match station.ends(&Job::BlockInfo(named(block_type, number, BlockPlace::Active))) {
        Reply::BlockInfo { name, header, footer } => Some((name.place, header.to_vec(), footer.to_vec())),
        Reply::Refused(Refusal::BlockNotFound) => None,
        reply => panic!("{reply:?}"),
    }
}

#[test]
fn the_blocks_of_the_program_are_counted_and_listed() {
    let mut station = Station::new();
    let counted = counts(&mut station);
    assert_eq!(counted[..5], [1, 1, 1, 6, 0]);
    assert!(counted[5] > 50 && counted[6] > 5, "system functions: {counted:?}");
    for (block_type, count) in ALL.into_iter().zip(counted) {
        assert_eq!(list(&mut station, block_type).len(), usize::from(count), "{block_type:?}");
    }
    assert_eq!(list(&mut station, BlockType::Function), [(1, 0x22, 1)]);
    let blocks = [(1, 0x22, 5), (2, 0x22, 5), (3, 0x22, 5), (4, 0x22, 5), (5, 0x12, 5), (7, 0x22, 5)];
    assert_eq!(list(&mut station, BlockType::DataBlock), blocks);
    assert!(list(&mut station, BlockType::SystemFunction).contains(&(51, 0x42, 1)));
}

#[test]
fn a_header_says_what_is_known_of_a_block() {
    let mut station = Station::new();
    let (place, header, footer) = info(&mut station, BlockType::Function, 1).expect("FC 1");
    assert_eq!(place, BlockPlace::Active);
    assert_eq!(header[..8], *b"pp\x01\x01\x01\x0C\x00\x01");
    // Loaded at midnight of 1994-01-01, ten years with three leap days after 1984; no machine code, so neither a length nor a checksum.
    assert_eq!(header[8..16], [0, 0, 0, 72, 0, 0, 0, 0]);
    assert_eq!(header[16..28], [0, 0, 0, 0, 0x0E, 0x45, 0, 0, 0, 0, 0x0E, 0x45]);
    assert_eq!(header[28..], [0, 0, 0, 0, 0, 2, 0, 0]);
    assert_eq!(footer[..24], *b"Meyer\0\0\0pumps\0\0\0adder\0\0\0");
    assert_eq!(footer[24..], [0x23, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
    let (_, header, _) = info(&mut station, BlockType::FunctionBlock, 1).expect("FB 1");
    assert_eq!((header[3], &header[12..16]), (0b1001, &[0, 0, 0, 3][..]), "KNOW_HOW_PROTECT");
    let (_, header, _) = info(&mut station, BlockType::DataBlock, 3).expect("DB 3");
    assert_eq!((header[3], &header[8..12], &header[34..]), (0b10_0001, &[0, 0, 0, 81][..], &[0, 2][..]), "NON_RETAIN");
    let (place, header, _) = info(&mut station, BlockType::DataBlock, 5).expect("DB 5");
    assert_eq!((place, header[3]), (BlockPlace::Passive, 0), "UNLINKED");
    let (_, _, footer) = info(&mut station, BlockType::SystemFunction, 51).expect("SFC 51");
    assert_eq!(footer[16..24], *b"RDSYSST\0");
    for (block_type, number) in [(BlockType::DataBlock, 6), (BlockType::Function, 2), (BlockType::SystemDataBlock, 0)] {
        assert_eq!(info(&mut station, block_type, number), None, "{block_type:?} {number}");
    }
}

#[test]
fn the_image_of_a_data_block_has_the_values_of_this_moment() {
    let mut station = Station::new();
    for (at_ms, value) in [(10, 7), (20, 8)] {
        station.scan(at_ms);
        let image = station.image(named(BlockType::DataBlock, 1, BlockPlace::Active));
        let (header, footer) = match station.ends(&Job::BlockInfo(named(BlockType::DataBlock, 1, BlockPlace::Active))) {
            Reply::BlockInfo { header, footer, .. } => (header, footer),
            reply => panic!("{reply:?}"),
        };
        assert_eq!(image, [&header[..], &[0, value, 0x12, 0x34], &[5, 0, 0, 0, 0, 0, 0], &footer].concat());
        assert_eq!(image[8..12], [0, 0, 0, 83]);
    }
    assert_eq!(station.image(data(5))[36..38], [0x55, 0x55], "UNLINKED: the values of the load memory");
}

#[test]
fn code_that_was_made_from_a_source_is_not_given_away() {
    let mut station = Station::new();
    let of = |block_type, number| Job::Upload(named(block_type, number, BlockPlace::Active));
    assert_eq!(station.refusal(&of(BlockType::OrganizationBlock, 1)), Some(Refusal::Protected));
    assert_eq!(station.refusal(&of(BlockType::FunctionBlock, 1)), Some(Refusal::Protected));
    assert_eq!(station.refusal(&of(BlockType::SystemFunction, 51)), Some(Refusal::Protected));
    assert_eq!(station.refusal(&of(BlockType::Function, 9)), Some(Refusal::BlockNotFound));
    assert_eq!(station.refusal(&of(BlockType::DataBlock, 9)), Some(Refusal::BlockNotFound));
}

/// FC 9 with machine code and its checksum 0: none.
fn function() -> Vec<u8> {
    let mut image = image(9, &[0x65, 0, 0x65, 1]);
    (image[4], image[5]) = (1, 0x0C);
    image
}

#[test]
fn a_code_block_that_comes_is_kept_listed_given_back_and_does_not_run() {
    let mut station = Station::new();
    let name = named(BlockType::Function, 9, BlockPlace::Passive);
    let before = counts(&mut station);
    assert!(matches!(station.ends(&downloaded(name, function())), Reply::Done));
    let after = counts(&mut station);
    assert_eq!((after[2], &after[..2], &after[3..]), (before[2] + 1, &before[..2], &before[3..]));
    assert_eq!(list(&mut station, BlockType::Function), [(1, 0x22, 1), (9, 0x12, 1)]);
    let (place, header, footer) = info(&mut station, BlockType::Function, 9).expect("FC 9");
    assert_eq!((place, header, footer), (BlockPlace::Passive, function()[..36].to_vec(), function()[43..].to_vec()));
    for place in [BlockPlace::Passive, BlockPlace::Active, BlockPlace::Both] {
        assert_eq!(station.image(named(BlockType::Function, 9, place)), function(), "byte for byte");
    }
    assert_eq!(station.refusal(&Job::Link(vec![name])), Some(Refusal::TestNotSupported));
    assert!(!station.plant.cpu.program().code.contains_key(&sieben_model::block::BlockId::fc(9)));
    assert!(matches!(station.ends(&Job::Delete(vec![named(BlockType::Function, 9, BlockPlace::Both)])), Reply::Done));
    assert_eq!(counts(&mut station), before);
    // System data has no meaning here, and comes back as well.
    let system_data = named(BlockType::SystemDataBlock, 1000, BlockPlace::Passive);
    let mut block = image(1000, &[1, 2, 3]);
    block[5] = 0x0B;
    assert!(matches!(station.ends(&downloaded(system_data, block.clone())), Reply::Done));
    assert_eq!(station.image(system_data), block);
    assert_eq!(counts(&mut station)[4], 1);
}

#[test]
fn what_is_no_block_for_this_cpu_is_refused_and_not_kept() {
    let mut station = Station::new();
    let typed = |code: u8, number: u16| {
        let mut image = image(number, &[1, 2]);
        image[5] = code;
        image
    };
    let whole = image(8, &[1, 2]);
    let mut checked = function();
    let at = checked.len() - 9;
    checked[at] = 1;
    let fc = named(BlockType::Function, 9, BlockPlace::Passive);
    let cases = [
        (data(8), whole[..whole.len() - 1].to_vec(), Refusal::BlockLengths),
        (data(8), Vec::new(), Refusal::BlockLengths),
        (data(8), whole[2..].to_vec(), Refusal::BlockStructure),
        (data(8), image(8, &[]), Refusal::BlockLengths),
        (data(8), image(8, &[1, 2, 3]), Refusal::BlockLengths),
        (data(9), whole.clone(), Refusal::BlockStructure),
        (fc, whole.clone(), Refusal::BlockStructure),
        (fc, checked, Refusal::BlockChecksum),
        (data(0), image(0, &[1, 2]), Refusal::BlockNumber),
        (data(16_001), image(16_001, &[1, 2]), Refusal::BlockNumber),
        (named(BlockType::Function, 8000, BlockPlace::Passive), typed(0x0C, 8000), Refusal::BlockNumber),
        (named(BlockType::OrganizationBlock, 2, BlockPlace::Passive), typed(0x08, 2), Refusal::BlockNumber),
        (named(BlockType::SystemFunction, 1, BlockPlace::Passive), typed(0x0D, 1), Refusal::Protected),
    ];
    let before = counts(&mut station);
    for (name, image, refusal) in cases {
        let reply = station.refusal(&downloaded(name, image.clone()));
        assert_eq!(reply, Some(refusal), "{name:?} {} bytes", image.len());
    }
    assert_eq!(counts(&mut station), before);
}
