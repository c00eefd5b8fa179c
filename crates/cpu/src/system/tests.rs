//! Whatever a program passes, a system function answers; it never panics.

use proptest::prelude::*;
use sieben_model::block::BlockKind;
use sieben_model::cpu_type::CpuType;

use super::fuzz::with_host;
use super::*;

fn pointer() -> impl Strategy<Value = u32> {
    prop_oneof![
        any::<u32>(),
        (0x7E_u32..0x8A, 0_u32..0x400).prop_map(|(area, position)| area << 24 | position),
        (0x80_u32..0x88, 0_u32..0x40).prop_map(|(area, byte)| area << 24 | byte << 3),
        (0x80_u32..0x88, 0x1F_FF00_u32..=0x1F_FFFF).prop_map(|(area, byte)| area << 24 | byte << 3),
    ]
}

/// Memory that is full of ANYs and POINTERs.
fn memory() -> impl Strategy<Value = Vec<u8>> {
    let data = || (prop_oneof![0_u16..5, any::<u16>()], pointer());
    let area = (prop_oneof![Just(0x10), any::<u8>()], any::<u8>(), prop_oneof![0_u16..64, any::<u16>()], data());
    let area = area.prop_map(|(syntax, code, count, (db, pointer))| {
        let mut bytes = vec![syntax, code & 0x1F];
        bytes.extend(count.to_be_bytes());
        bytes.extend(db.to_be_bytes());
        bytes.extend(pointer.to_be_bytes());
        bytes
    });
    let place = data().prop_map(|(db, pointer)| [&db.to_be_bytes()[..], &pointer.to_be_bytes()[..]].concat());
    let bytes = prop::collection::vec(any::<u8>(), 1..8);
    prop::collection::vec(prop_oneof![area, place, bytes], 1..12).prop_map(|parts| parts.concat())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn no_parameter_makes_a_system_block_panic(
        memory in memory(),
        parameters in prop::collection::vec(pointer(), 0..6),
        ar2 in prop_oneof![Just(0), pointer()],
    ) {
        with_host(&CpuType::ALL[0], &memory, &parameters, ar2, |call| {
            let size = call.machine.memory.arena.len();
            // Twice: what the first round leaves behind is what the second one finds.
            for row in rows().chain(rows()) {
                row.run(call);
                assert_eq!(call.machine.memory.arena.len(), size, "{}", row.name);
                for entry in call.machine.memory.data_blocks.iter().flatten() {
                    assert!((entry.base + entry.length) as usize <= size, "{}", row.name);
                }
            }
        });
    }
}

#[test]
fn both_tables_are_sorted_and_have_nothing_in_common() {
    for table in [TABLE, unavailable::ROWS] {
        assert!(table.is_sorted_by(|a, b| a.block < b.block));
    }
    for row in rows() {
        let twice: Vec<_> = rows().filter(|other| other.block == row.block || other.name == row.name).map(|row| row.block).collect();
        assert_eq!(twice, [row.block]);
        assert!(row.parameters.is_sorted_by_key(|parameter| parameter.section), "{} is declared section by section", row.name);
    }
}

#[test]
fn created_data_blocks_never_overlap() {
    with_host(&CpuType::ALL[0], &[0], &[], 0, |call| {
        let (low, high, count, result, number) = (0x8300_0000_u32, 0x8300_0010, 0x8300_0020, 0x8300_0030, 0x8300_0040);
        for round in 0..400_u32 {
            let memory = &mut call.machine.memory;
            let at = memory.layout.bit_memory.start;
            for (word, value) in [(0, 10), (2, 60), (4, (round * 7919 % 5000) / 2 * 2)] {
                memory.write_at(at + word, 0, sieben_model::address::Width::Word, value);
            }
            call.machine.parameters = vec![low, high, count, result, number];
            run(BlockId::new(BlockKind::SystemFunction, 22), call);
            if round % 3 == 0 {
                let delete = 10 + round * 31 % 50;
                call.machine.memory.write_at(at, 0, sieben_model::address::Width::Word, delete);
                call.machine.parameters = vec![low, result];
                run(BlockId::new(BlockKind::SystemFunction, 23), call);
            }
            if round % 50 == 0 {
                call.machine.parameters = vec![result, 0x8300_0050, 0x8300_0051];
                run(BlockId::new(BlockKind::SystemFunction, 25), call);
            }
            let mut ranges: Vec<_> =
                call.machine.memory.data_blocks.iter().flatten().map(|entry| (entry.base, entry.base + entry.length)).collect();
            ranges.sort_unstable();
            assert!(ranges.windows(2).all(|pair| pair[0].1 <= pair[1].0), "round {round}: {ranges:?}");
        }
    });
}
