//! CPU types: areas, accumulators, limits.

/// What a CPU type has and allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CpuType {
    /// The name that `--cpu` takes.
    pub name: &'static str,
    /// 2 (S7-300) or 4 (S7-400) accumulators.
    pub accumulators: u8,
    /// Bytes of the process image of the inputs, and of the outputs.
    pub process_image: u32,
    /// Bytes of peripheral addresses, inputs and outputs each.
    pub peripheral: u32,
    /// Bytes of bit memory.
    pub bit_memory: u32,
    /// Number of S5 timers.
    pub timers: u16,
    /// Number of S5 counters.
    pub counters: u16,
    /// Bytes of local data that a priority class may use.
    pub local_data: u32,
    /// Whether all priority classes share these bytes (S7-400) or each has its own (S7-300).
    pub local_data_shared: bool,
    /// Bytes of local data per block.
    pub local_data_block: u32,
    /// Only what blocks declare counts as local data, and not what a call or an expression needs beside it.
    pub local_data_declared: bool,
    /// Greatest number of a data block.
    pub db_number_max: u16,
    /// Greatest number of an FC or FB.
    pub fc_number_max: u16,
    /// Bytes a block may have.
    pub block_size_max: u32,
    /// Nested block calls per priority class.
    pub nesting_depth: u8,
    /// Additional nested block calls inside a synchronous-error OB.
    pub nesting_depth_error: u8,
    /// Numbers of the organization blocks that the operating system calls, from and to.
    pub organization_blocks: &'static [(u16, u16)],
    /// Whether OB 88 exists; without it a processing abort is STOP 16#457x.
    pub has_ob88: bool,
    /// `L STW` and `T STW` move all nine status bits (S7-400) or not /FC, STA and OR (S7-300).
    pub status_word_whole: bool,
    /// Every start of a CPU with four accumulators that has OB 102 is a cold restart, see [`crate::profile`].
    pub starts_cold: bool,
    /// REAL numbers compare by their difference instead of their values, see [`crate::profile`].
    pub compares_real_by_difference: bool,
    /// Entries of the diagnostic buffer.
    pub diagnostic_buffer: u16,
    /// Bytes of the longest PDU of S7 communication.
    pub pdu: u16,
    /// Connections of S7 communication.
    pub connections: u16,
}

/// One time-of-day interrupt, two delays, four cyclic interrupts, one hardware interrupt; no multicomputing, no background, no hot restart.
const S7_300_BLOCKS: &[(u16, u16)] =
    &[(1, 1), (10, 10), (20, 21), (32, 35), (40, 40), (55, 57), (80, 80), (82, 83), (85, 87), (100, 100), (102, 102), (121, 122)];
const S7_400_BLOCKS: &[(u16, u16)] =
    &[(1, 1), (10, 17), (20, 23), (30, 38), (40, 47), (55, 57), (60, 60), (80, 88), (90, 90), (100, 102), (121, 122)];

const S7_300: CpuType = CpuType {
    name: "315-2PN/DP",
    accumulators: 2,
    process_image: 2048,
    peripheral: 2048,
    bit_memory: 2048,
    timers: 256,
    counters: 256,
    local_data: 32 * 1024,
    local_data_shared: false,
    local_data_block: 2048,
    local_data_declared: false,
    db_number_max: 16_000,
    fc_number_max: 7999,
    block_size_max: 65_536,
    nesting_depth: 16,
    nesting_depth_error: 4,
    organization_blocks: S7_300_BLOCKS,
    has_ob88: false,
    status_word_whole: false,
    starts_cold: false,
    compares_real_by_difference: false,
    diagnostic_buffer: 100,
    pdu: 240,
    connections: 16,
};
const S7_400: CpuType = CpuType {
    name: "416-3",
    accumulators: 4,
    process_image: 16_384,
    peripheral: 16_384,
    bit_memory: 16_384,
    timers: 2048,
    counters: 2048,
    local_data: 32 * 1024,
    local_data_shared: true,
    local_data_block: 65_536,
    local_data_declared: false,
    nesting_depth: 24,
    nesting_depth_error: 2,
    organization_blocks: S7_400_BLOCKS,
    has_ob88: true,
    status_word_whole: true,
    diagnostic_buffer: 500,
    pdu: 480,
    connections: 64,
    ..S7_300
};

impl CpuType {
    /// All CPU types, the default first. Figures of the data sheets; those of the 315 V3 and 416/417 V7 are
    /// from knowledge of the data sheets without the text at hand, see docs/decisions.
    pub const ALL: &[Self] = &[
        S7_300,
        CpuType { name: "317-2PN/DP", process_image: 8192, peripheral: 8192, bit_memory: 4096, timers: 512, counters: 512, ..S7_300 },
        CpuType { name: "319-3PN/DP", process_image: 8192, peripheral: 8192, bit_memory: 8192, timers: 2048, counters: 2048, ..S7_300 },
        S7_400,
        CpuType { name: "417-4", local_data: 64 * 1024, ..S7_400 },
    ];

    /// Whether the operating system of this CPU type calls OB `number`.
    pub fn has_organization_block(&self, number: u16) -> bool {
        self.organization_blocks.iter().any(|&(first, last)| (first..=last).contains(&number))
    }

    /// The CPU type with this name, without regard to case and blanks.
    pub fn by_name(name: &str) -> Option<&'static Self> {
        let plain = |text: &str| text.chars().filter(|c| c.is_ascii_alphanumeric()).collect::<String>().to_ascii_lowercase();
        Self::ALL.iter().find(|cpu| plain(cpu.name) == plain(name))
    }
}

impl Default for CpuType {
    fn default() -> Self {
        Self::ALL[0]
    }
}
