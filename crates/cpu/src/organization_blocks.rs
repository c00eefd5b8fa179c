//! Organization blocks: priority, and what happens without them.

use sieben_engine::Abort;
use sieben_model::block::BlockId;

use crate::mode::Restart;

/// Cyclic program.
pub const CYCLE: BlockId = BlockId::ob(1);
/// Time error.
pub const TIME_ERROR: BlockId = BlockId::ob(80);
/// Priority class error.
pub const PRIORITY_CLASS_ERROR: BlockId = BlockId::ob(85);
/// Processing abort (S7-400).
pub const PROCESSING_ABORT: BlockId = BlockId::ob(88);
/// Background (S7-400).
pub const BACKGROUND: BlockId = BlockId::ob(90);
/// Programming error.
pub const PROGRAMMING_ERROR: BlockId = BlockId::ob(121);
/// I/O access error.
pub const IO_ACCESS_ERROR: BlockId = BlockId::ob(122);

/// What the CPU does if it needs an organization block that is not loaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Missing {
    /// It goes on.
    GoesOn,
    /// A priority class error, OB 85.
    PriorityClassError,
    /// STOP with this event.
    Stop(u16),
}

/// Some organization blocks of one kind.
struct Row {
    first: u16,
    last: u16,
    /// Priority class of the first one; 0 = that of the cause, or below OB 1.
    priority: u8,
    /// How much higher that of the next one is.
    step: u8,
    missing: Missing,
}

const fn row(first: u16, last: u16, priority: u8, step: u8, missing: Missing) -> Row {
    Row { first, last, priority, step, missing }
}

/// All of them, by number.
const TABLE: &[Row] = &[
    row(1, 1, 1, 0, Missing::GoesOn),
    row(10, 17, 2, 0, Missing::PriorityClassError),
    row(20, 23, 3, 1, Missing::PriorityClassError),
    row(30, 38, 7, 1, Missing::PriorityClassError),
    row(40, 47, 16, 1, Missing::PriorityClassError),
    row(55, 57, 2, 0, Missing::PriorityClassError),
    row(60, 60, 25, 0, Missing::GoesOn),
    row(80, 80, 26, 0, Missing::Stop(0x4568)),
    row(81, 81, 26, 0, Missing::GoesOn),
    row(82, 82, 26, 0, Missing::Stop(0x456A)),
    row(83, 83, 26, 0, Missing::Stop(0x456B)),
    row(84, 84, 26, 0, Missing::GoesOn),
    row(85, 85, 26, 0, Missing::Stop(0x456D)),
    row(86, 86, 26, 0, Missing::Stop(0x456F)),
    row(87, 87, 26, 0, Missing::GoesOn),
    row(88, 88, 28, 0, Missing::Stop(0x4570)),
    row(90, 90, 0, 0, Missing::GoesOn),
    row(100, 102, 27, 0, Missing::GoesOn),
    row(121, 121, 0, 0, Missing::Stop(0x4562)),
    row(122, 122, 0, 0, Missing::Stop(0x4563)),
];

fn row_of(number: u16) -> Option<&'static Row> {
    TABLE.iter().find(|row| (row.first..=row.last).contains(&number))
}

/// The priority class of an organization block, 1 to 28; 0 if it has that of its cause, or runs below OB 1.
pub fn priority(block: BlockId) -> u8 {
    row_of(block.number).map_or(0, |row| row.priority + row.step * (block.number - row.first) as u8)
}

/// What the CPU does if it needs this organization block and it is not loaded.
pub fn missing(block: BlockId) -> Missing {
    row_of(block.number).map_or(Missing::GoesOn, |row| row.missing)
}

/// The event with which the CPU goes to STOP if this organization block is needed and not loaded; 0 if it goes on.
pub fn stop_event(block: BlockId) -> u16 {
    match missing(block) {
        Missing::Stop(event) => event,
        Missing::GoesOn | Missing::PriorityClassError => 0,
    }
}

/// The event with which a CPU without OB 88 stops after an abort.
pub fn abort_stop_event(abort: Abort) -> u16 {
    match abort {
        Abort::NestingStack => 0x4571,
        Abort::McrStack => 0x4572,
        Abort::BlockStack => 0x4575,
        Abort::LocalData => 0x4576,
    }
}

/// Whether it is that of an asynchronous error, OB 80 to OB 87: in STARTUP these run too, in priority class 28.
pub fn is_asynchronous_error(number: u16) -> bool {
    (80..=87).contains(&number)
}

/// Whether an event can start it beside the cycle: what [`crate::Cpu::raise`] takes.
pub fn is_interrupt(number: u16) -> bool {
    matches!(number, 10..=17 | 20..=23 | 30..=38 | 40..=47 | 55..=57 | 60) || is_asynchronous_error(number)
}

/// The startup block of a kind of restart.
pub fn startup(restart: Restart) -> BlockId {
    BlockId::ob(match restart {
        Restart::Warm => 100,
        Restart::Hot => 101,
        Restart::Cold => 102,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn priorities_are_those_of_the_table() {
        let expected = [(1, 1), (10, 2), (17, 2), (20, 3), (23, 6), (30, 7), (35, 12), (38, 15), (40, 16), (47, 23), (55, 2), (57, 2)];
        for (number, priority) in expected.into_iter().chain([(60, 25), (80, 26), (87, 26), (88, 28), (90, 0), (101, 27), (121, 0), (9, 0)])
        {
            assert_eq!(super::priority(BlockId::ob(number)), priority, "OB {number}");
        }
    }

    #[test]
    fn every_block_of_every_cpu_type_has_a_row() {
        for cpu in sieben_model::cpu_type::CpuType::ALL {
            for number in cpu.organization_blocks.iter().flat_map(|&(first, last)| first..=last) {
                assert!(row_of(number).is_some(), "{}: OB {number}", cpu.name);
            }
        }
    }
}
