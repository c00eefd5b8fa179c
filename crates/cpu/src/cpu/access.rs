//! How everyone outside reads and modifies operands.

use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::bcd;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::item::{Item, Place};
use sieben_model::program::DataBlock;
use sieben_model::value::Value;

use super::Cpu;
use crate::clock::{ClockRefused, DateAndTime};
use crate::communication::{Communication, Requester};
use crate::cycle::CycleTimes;
use crate::data_block_replacement::ReplaceRefused;
use crate::diagnostic_buffer::DiagnosticBuffer;
use crate::forcing::Forced;
use crate::items::timer_of;
use crate::loaded_blocks::BlockView;
use crate::mode::{NotInStop, OperatingMode, Restart, StartRefused, StopCause};
use crate::station::{AccessError, Station, TimerReading};
use crate::system_status_list::{NoList, PartialList};

impl Station for Cpu {
    fn cpu_type(&self) -> &'static CpuType {
        self.cpu_type
    }

    fn mode(&self) -> OperatingMode {
        self.mode
    }

    fn read(&self, operand: &Operand) -> Result<u32, AccessError> {
        check_bit(operand)?;
        match operand {
            Operand::Address(Address { area: Area::PeripheralInput, byte, width, bit }) => {
                let value = self.rack.peripheral_read(*byte, *width).ok_or(AccessError::NoModule)?;
                Ok(if *width == Width::Bit { value >> (bit & 7) & 1 } else { value })
            }
            Operand::Address(Address { area: Area::PeripheralOutput, byte, width, bit }) => {
                let value = self.rack.peripheral_output(*byte, *width).ok_or(AccessError::NoModule)?;
                Ok(if *width == Width::Bit { value >> (bit & 7) & 1 } else { value })
            }
            Operand::Timer(number) => self.timer(*number).map(|timer| u32::from(timer.value)).ok_or(AccessError::Outside),
            Operand::Counter(number) => {
                self.machine.counters.get(usize::from(*number)).map(|counter| u32::from(counter.count)).ok_or(AccessError::Outside)
            }
            _ => self.machine.memory.read(operand).ok_or_else(|| self.why_not(operand)),
        }
    }

    fn modify(&mut self, operand: &Operand, value: u32) -> Result<(), AccessError> {
        self.is_writable(operand_db(operand))?;
        self.modify_operand(operand, value)
    }

    fn read_items(&self, items: &[Item]) -> Vec<Result<Value, AccessError>> {
        items.iter().map(|item| self.value(item)).collect()
    }

    fn write_items(&mut self, values: &[(Item, Value)]) -> Vec<Result<(), AccessError>> {
        values.iter().map(|(item, value)| self.is_writable(item_db(item)).and_then(|()| self.set(item, &value.content))).collect()
    }

    fn forced(&self) -> &Forced {
        Self::forced(self)
    }

    fn force(&mut self, operand: &Operand, value: u32) -> Result<(), AccessError> {
        Self::force(self, operand, value)
    }

    fn unforce(&mut self, operand: &Operand) -> Result<bool, AccessError> {
        Self::unforce(self, operand)
    }

    fn unforce_all(&mut self) {
        Self::unforce_all(self);
    }

    fn timer(&self, number: u16) -> Option<TimerReading> {
        let timer = timer_of(&self.machine, number)?;
        let value = timer.remaining(self.machine.clock_us);
        Some(TimerReading { status: timer.status, value, base: timer.base, running: timer.running })
    }

    fn diagnostic_buffer(&self) -> &DiagnosticBuffer {
        &self.diagnostics
    }

    fn stop_cause(&self) -> Option<&StopCause> {
        self.cause.as_ref()
    }

    fn cycle_times(&self) -> CycleTimes {
        self.cycle.times
    }

    fn stop_by(&mut self, by: Requester) {
        self.stop_for(by);
    }

    fn restart(&mut self, restart: Restart) -> OperatingMode {
        Self::restart(self, restart)
    }

    fn start(&mut self, restart: Restart, by: Requester) -> Result<OperatingMode, StartRefused> {
        self.start_by(restart, by)
    }

    fn memory_reset(&mut self, by: Requester) -> Result<(), NotInStop> {
        self.memory_reset_by(by)
    }

    fn clock(&self) -> DateAndTime {
        self.date_and_time()
    }

    fn set_clock(&mut self, wanted: DateAndTime) -> Result<(), ClockRefused> {
        self.set_date_and_time(wanted)
    }

    fn blocks(&self) -> Vec<BlockId> {
        self.loaded_blocks().all()
    }

    fn block(&self, id: BlockId) -> Option<BlockView> {
        self.loaded_blocks().view(id)
    }

    fn replace_data_block(&mut self, block: &DataBlock) -> Result<(), ReplaceRefused> {
        self.replace_values(block)
    }

    fn data_block_values(&self, number: u16) -> Option<Vec<u8>> {
        self.values_of(number)
    }

    fn delete_created_data_block(&mut self, number: u16) -> bool {
        self.delete_created(number)
    }

    fn copy_ram_to_rom(&mut self) -> usize {
        self.ram_to_rom()
    }

    fn status_list(&self, id: u16, index: u16) -> Result<PartialList, NoList> {
        self.system_status().read(id, index)
    }

    fn set_communication(&mut self, communication: Communication) {
        self.communication = communication;
    }
}

/// Which bits of its bytes an address means, and their values; right-justified in four bytes.
fn masks_and_values(address: &Address, value: u32) -> ([u8; 4], [u8; 4]) {
    if address.width == Width::Bit {
        ([0, 0, 0, 1 << (address.bit & 7)], [0, 0, 0, ((value & 1) << (address.bit & 7)) as u8])
    } else {
        ([0xFF; 4], value.to_be_bytes())
    }
}

/// A bit number above 7 is no address.
fn check_bit(operand: &Operand) -> Result<(), AccessError> {
    match operand {
        Operand::Address(address) | Operand::InDataBlock { address, .. } if address.bit > 7 => Err(AccessError::Outside),
        _ => Ok(()),
    }
}

/// The data block that an operand lies in.
fn operand_db(operand: &Operand) -> Option<u16> {
    match operand {
        Operand::InDataBlock { db, .. } => Some(*db),
        Operand::Address(_) | Operand::Timer(_) | Operand::Counter(_) | Operand::Block(_) => None,
    }
}

/// The data block that an item lies in.
fn item_db(item: &Item) -> Option<u16> {
    match &item.place {
        Place::Operand(operand) => operand_db(operand),
        Place::Bytes(bytes) => bytes.db,
        Place::TimerStatus(_) | Place::Local(_) | Place::Register(_) | Place::Status | Place::Constant(_) => None,
    }
}

impl Cpu {
    /// What is forced.
    pub fn forced(&self) -> &Forced {
        &self.forced
    }

    /// Forces an operand to a value (raw bits) from the next cycle control point on, until [`Self::unforce`]; a restart does not end it.
    ///
    /// Outputs take it when they go to the modules, inputs and bit memory when the inputs have come; inside a scan the program may write
    /// something else there. Direct access to peripherals is not forced.
    ///
    /// # Errors
    /// The CPU type does not force this operand, or it lies outside its area.
    pub fn force(&mut self, operand: &Operand, value: u32) -> Result<(), AccessError> {
        let address = self.forcible(operand)?;
        if self.forced.set(&address, value) { Ok(()) } else { Err(AccessError::NotForced) }
    }

    /// Ends the forcing of an operand, or of its bits that are forced; `false` if none of it was. It keeps the value until something writes it.
    ///
    /// # Errors
    /// The CPU type does not force this operand, or it lies outside its area.
    pub fn unforce(&mut self, operand: &Operand) -> Result<bool, AccessError> {
        let address = self.forcible(operand)?;
        Ok(self.forced.clear(&address))
    }

    /// Ends all forcing.
    pub fn unforce_all(&mut self) {
        self.forced = Forced::default();
    }

    fn forcible(&self, operand: &Operand) -> Result<Address, AccessError> {
        check_bit(operand)?;
        match operand {
            Operand::Address(address @ Address { area: Area::Input | Area::Output, .. }) => self.inside(address),
            // The families differ in more than OB 88, but nothing else tells them apart.
            Operand::Address(address @ Address { area: Area::BitMemory, .. }) if self.cpu_type.has_ob88 => self.inside(address),
            _ => Err(AccessError::NotForced),
        }
    }

    fn inside(&self, address: &Address) -> Result<Address, AccessError> {
        match self.machine.memory.locate(&Operand::Address(*address)) {
            Some(_) => Ok(*address),
            None => Err(AccessError::Outside),
        }
    }

    /// Gives an operand a value, in a READ_ONLY data block too, as tests and scenarios do.
    pub(super) fn modify_operand(&mut self, operand: &Operand, value: u32) -> Result<(), AccessError> {
        check_bit(operand)?;
        match operand {
            Operand::Address(address @ Address { area: Area::Input | Area::PeripheralInput, .. }) => self.modify_input(address, value),
            Operand::Address(address @ Address { area: Area::PeripheralOutput, .. }) => self.modify_output(address, value),
            Operand::Timer(number) => {
                let now = self.machine.clock_us;
                let timer = self.machine.timers.get_mut(usize::from(*number)).ok_or(AccessError::Outside)?;
                let word = u16::try_from(value).map_err(|_| AccessError::Value)?;
                if !bcd::is_decimal(u32::from(word), 3) {
                    return Err(AccessError::Value);
                }
                timer.refresh(now);
                timer.base = (word >> 12 & 3) as u8;
                timer.value = bcd::decode(u32::from(word), 3) as u16;
                timer.started_us = now;
                timer.refresh(now);
                Ok(())
            }
            Operand::Counter(number) => {
                let counter = self.machine.counters.get_mut(usize::from(*number)).ok_or(AccessError::Outside)?;
                counter.count = u16::try_from(value).ok().filter(|&count| count <= 999).ok_or(AccessError::Value)?;
                Ok(())
            }
            _ if self.machine.memory.write(operand, value) => {
                if matches!(operand, Operand::Address(Address { area: Area::Output, .. })) {
                    self.images.changed();
                }
                Ok(())
            }
            _ => Err(self.why_not(operand)),
        }
    }

    /// Whether those outside may write to a data block.
    fn is_writable(&self, db: Option<u16>) -> Result<(), AccessError> {
        let entry = db.and_then(|db| self.machine.memory.data_block(u64::from(db)));
        if entry.is_some_and(|entry| entry.read_only) { Err(AccessError::WriteProtected) } else { Ok(()) }
    }

    /// Why an operand of the data memory has no value.
    pub(super) fn why_not(&self, operand: &Operand) -> AccessError {
        match operand {
            Operand::InDataBlock { db, .. } if self.machine.memory.data_block(u64::from(*db)).is_none() => AccessError::NotLoaded,
            Operand::InDataBlock { .. } => AccessError::Outside,
            Operand::Address(address) if self.machine.memory.layout.area(address.area).is_some() => AccessError::Outside,
            _ => AccessError::NotAccessible,
        }
    }

    /// Sets an input in its module at a time to come, in microseconds like the time of a scan: an interrupt before that time does not see it.
    ///
    /// # Errors
    /// It is no input, or no module has it.
    pub fn modify_input_at(&mut self, at_us: u64, operand: &Operand, value: u32) -> Result<(), AccessError> {
        check_bit(operand)?;
        let Operand::Address(address @ Address { area: Area::Input | Area::PeripheralInput, .. }) = operand else {
            return Err(AccessError::NotAccessible);
        };
        let (masks, values) = masks_and_values(address, value);
        for index in 0..self.input_bytes(address)? {
            let at = (4 - address.width.bytes() + index) as usize;
            if !self.rack.set_input_at(at_us, address.byte + index, masks[at], values[at]) {
                return Err(AccessError::NoModule);
            }
        }
        Ok(())
    }

    /// How many bytes an input has, if it lies inside its area.
    fn input_bytes(&self, address: &Address) -> Result<u32, AccessError> {
        let length = address.width.bytes();
        let limit = match address.area {
            Area::Input => self.machine.memory.layout.inputs.len() as u32,
            _ => self.cpu_type.peripheral,
        };
        if address.byte.checked_add(length).is_none_or(|end| end > limit) { Err(AccessError::Outside) } else { Ok(length) }
    }

    /// Sets an input: in its module if that is simulated, else in the process image of the next scan.
    fn modify_input(&mut self, address: &Address, value: u32) -> Result<(), AccessError> {
        let length = self.input_bytes(address)?;
        let (masks, values) = masks_and_values(address, value);
        for index in 0..length {
            let at = (4 - length + index) as usize;
            let byte = address.byte + index;
            if self.rack.set_input(byte, masks[at], values[at]) {
                continue;
            }
            if address.area == Area::PeripheralInput {
                return Err(AccessError::NoModule);
            }
            let (mask, old) = self.overrides.entry(byte).or_default();
            *mask |= masks[at];
            *old = *old & !masks[at] | values[at];
        }
        Ok(())
    }

    /// Sets a peripheral output and, as `T PQW` does, the process image, or the next cycle control point would undo it.
    fn modify_output(&mut self, address: &Address, value: u32) -> Result<(), AccessError> {
        let (width, value) = if address.width == Width::Bit {
            let old = self.rack.peripheral_output(address.byte, Width::Byte).ok_or(AccessError::NoModule)?;
            (Width::Byte, old & !(1 << address.bit) | (value & 1) << address.bit)
        } else {
            (address.width, value)
        };
        if !self.rack.peripheral_write(address.byte, width, value) {
            return Err(AccessError::NoModule);
        }
        self.machine.memory.write(&Operand::Address(Address { area: Area::Output, width, byte: address.byte, bit: 0 }), value);
        Ok(())
    }
}
