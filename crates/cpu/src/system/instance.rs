//! The instance of a system function block: DI register and AR2.

use sieben_engine::Machine;
use sieben_model::address::Width;

/// Where the instance begins in the arena.
pub(super) struct Instance<'a> {
    machine: &'a mut Machine,
    start: usize,
}

impl<'a> Instance<'a> {
    /// The instance of `bytes` bytes; `None` if no such block is open, it is too short or the program may not write it.
    pub(super) fn open(machine: &'a mut Machine, bytes: u32) -> Option<Self> {
        let entry = machine.memory.data_block(machine.registers.di_number)?;
        let pointer = machine.registers.ar2 & 0x00FF_FFFF;
        let start = (pointer >> 3) as u32;
        let fits = start.checked_add(bytes).is_some_and(|end| end <= entry.length);
        (fits && pointer & 7 == 0 && !entry.read_only).then(|| Self { start: (entry.base + start) as usize, machine })
    }

    pub(super) fn bit(&self, byte: usize, bit: u8) -> bool {
        self.machine.memory.read_at(self.start + byte, bit, Width::Bit) == 1
    }

    pub(super) fn set_bit(&mut self, byte: usize, bit: u8, value: bool) {
        self.machine.memory.write_at(self.start + byte, bit, Width::Bit, u32::from(value));
    }

    /// A bit as it is now; `new` takes its place. True if it goes from 0 to 1.
    pub(super) fn rising(&mut self, byte: usize, bit: u8, new: bool) -> bool {
        let old = self.bit(byte, bit);
        self.set_bit(byte, bit, new);
        new && !old
    }

    pub(super) fn int(&self, byte: usize) -> i16 {
        self.machine.memory.read_at(self.start + byte, 0, Width::Word) as u16 as i16
    }

    pub(super) fn set_int(&mut self, byte: usize, value: i16) {
        self.machine.memory.write_at(self.start + byte, 0, Width::Word, u32::from(value as u16));
    }

    pub(super) fn time(&self, byte: usize) -> i32 {
        self.machine.memory.read_at(self.start + byte, 0, Width::DoubleWord) as i32
    }

    pub(super) fn set_time(&mut self, byte: usize, value: i32) {
        self.machine.memory.write_at(self.start + byte, 0, Width::DoubleWord, value as u32);
    }

    pub(super) fn byte(&self, byte: usize) -> u8 {
        self.machine.memory.read_at(self.start + byte, 0, Width::Byte) as u8
    }

    pub(super) fn set_byte(&mut self, byte: usize, value: u8) {
        self.machine.memory.write_at(self.start + byte, 0, Width::Byte, u32::from(value));
    }

    pub(super) fn word(&self, byte: usize) -> u16 {
        self.machine.memory.read_at(self.start + byte, 0, Width::Word) as u16
    }

    pub(super) fn set_word(&mut self, byte: usize, value: u16) {
        self.machine.memory.write_at(self.start + byte, 0, Width::Word, u32::from(value));
    }

    pub(super) fn double_word(&self, byte: usize) -> u32 {
        self.machine.memory.read_at(self.start + byte, 0, Width::DoubleWord)
    }

    pub(super) fn set_double_word(&mut self, byte: usize, value: u32) {
        self.machine.memory.write_at(self.start + byte, 0, Width::DoubleWord, value);
    }

    pub(super) fn real(&self, byte: usize) -> f32 {
        f32::from_bits(self.double_word(byte))
    }

    pub(super) fn set_real(&mut self, byte: usize, value: f32) {
        self.set_double_word(byte, value.to_bits());
    }

    /// A TIME in seconds.
    pub(super) fn seconds(&self, byte: usize) -> f32 {
        self.time(byte) as f32 / 1000.0
    }

    /// The time that IEC timers count by, in milliseconds: 31 bits, then from 0 again.
    pub(super) fn now(&self) -> i32 {
        (self.machine.clock_us / 1000 % (1 << 31)) as i32
    }
}
