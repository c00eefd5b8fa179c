//! What every engine does the same way: finds the byte that an access means, opens data blocks, keeps registers in a file.

use std::ops::Range;

use sieben_model::address::{Area, Width};

use crate::fault::Fault;
use crate::host::Context;
use crate::ir::{DataRegister, Place};
use crate::machine::{CALLS_MASK, CALLS_SHIFT, CallerRegisters, Machine, Register, Registers};

/// The registers and temporaries while a block runs: the registers in the order of [`Register::ALL`], then the temporaries.
pub type File = [u64; 256];

/// What an access means.
pub enum Target {
    /// A byte of the arena, and the bit in it.
    Arena(usize, u8),
    /// A byte of a module.
    Peripheral(u32),
}

/// Registers of a data block register: number, base, length.
pub fn data_registers(register: DataRegister) -> [Register; 3] {
    match register {
        DataRegister::Shared => [Register::DbNumber, Register::DbBase, Register::DbLength],
        DataRegister::Instance => [Register::DiNumber, Register::DiBase, Register::DiLength],
    }
}

/// Code of the access in OB121_RESERVED_1: kind of access (bits 7 to 4) and area (bits 3 to 0).
fn access_code(area: Area, width: Width) -> u8 {
    let kind = match width {
        Width::Bit => 0,
        Width::Byte => 1,
        Width::Word => 2,
        Width::DoubleWord | Width::QuadWord => 3,
    };
    kind << 4 | area.pointer_code() & 7
}

fn fault(read: u8, write: bool, area: Area, width: Width, byte: u32) -> Fault {
    Fault::Programming { code: read + u8::from(write), register: byte as u16, access: access_code(area, width) }
}

/// Area length error.
fn outside(write: bool, area: Area, width: Width, byte: u32) -> Fault {
    fault(0x22, write, area, width, byte)
}

/// The arena byte at a position (in bits) of an open data block.
///
/// # Errors
/// The programming error of an access outside the block, not at the beginning of a byte, or of writing a protected block.
#[inline(always)]
pub fn in_data_block(
    machine: &Machine,
    file: &File,
    register: DataRegister,
    position: u32,
    width: Width,
    write: bool,
) -> Result<(usize, u8), Fault> {
    let [number, base, length] = data_registers(register);
    let byte = position >> 3;
    let area = match register {
        DataRegister::Shared => Area::SharedData,
        DataRegister::Instance => Area::InstanceData,
    };
    if width != Width::Bit && position & 7 != 0 {
        return Err(fault(0x28, write, area, width, byte));
    }
    if u64::from(byte) + u64::from(width.bytes()) > file[length as usize] {
        return Err(outside(write, area, width, byte));
    }
    if write && machine.memory.data_block(file[number as usize]).is_some_and(|entry| entry.read_only) {
        let code = if register == DataRegister::Shared { 0x30 } else { 0x31 };
        return Err(Fault::programming(code, file[number as usize] as u16));
    }
    Ok((file[base as usize] as usize + byte as usize, (position & 7) as u8))
}

/// What a place means now. `local` gives the local data of the running block (0), its caller (1) and so on, as ranges of the arena.
///
/// # Errors
/// The programming error of an access outside its area, in an unknown area or not at the beginning of a byte.
pub fn locate(
    machine: &Machine,
    file: &File,
    local: &dyn Fn(usize) -> Range<usize>,
    place: Place,
    width: Width,
    write: bool,
) -> Result<Target, Fault> {
    let (area, position) = match place {
        Place::Fixed { area, position } => (area, position),
        Place::Indirect { area, pointer, offset } => (area, moved(file[usize::from(pointer.0)], offset)),
        Place::Crossing { pointer, offset } => {
            let pointer = file[usize::from(pointer.0)];
            (pointed_area(pointer, write)?, moved(pointer, offset))
        }
    };
    let byte = match area {
        Area::CallerLocal => position & CALLS_MASK,
        _ => position,
    } >> 3;
    if width != Width::Bit && position & 7 != 0 {
        return Err(fault(0x28, write, area, width, byte));
    }
    let range = match area {
        Area::PeripheralInput | Area::PeripheralOutput => return Ok(Target::Peripheral(byte)),
        Area::SharedData => {
            return in_data_block(machine, file, DataRegister::Shared, position, width, write).map(|(at, bit)| Target::Arena(at, bit));
        }
        Area::InstanceData => {
            return in_data_block(machine, file, DataRegister::Instance, position, width, write).map(|(at, bit)| Target::Arena(at, bit));
        }
        Area::Local => local(0),
        Area::CallerLocal => local(1 + (position >> CALLS_SHIFT) as usize),
        Area::Input | Area::Output | Area::BitMemory => machine.memory.layout.area(area).unwrap_or(0..0),
    };
    if u64::from(byte) + u64::from(width.bytes()) > range.len() as u64 {
        return Err(outside(write, area, width, byte));
    }
    Ok(Target::Arena(range.start + byte as usize, (position & 7) as u8))
}

/// As [`locate`], for a pointer that may hold the number of its data block in bits 32 to 47.
///
/// # Errors
/// Those of [`locate`]; the data block is not loaded.
pub fn locate_far(
    machine: &Machine,
    file: &File,
    local: &dyn Fn(usize) -> Range<usize>,
    place: Place,
    width: Width,
    write: bool,
) -> Result<Target, Fault> {
    if let Place::Crossing { pointer, offset } = place
        && let pointer = file[usize::from(pointer.0)]
        && let number = pointer >> 32 & 0xFFFF
        && number != 0
        && (pointer >> 24) as u8 == Area::SharedData.pointer_code()
    {
        let position = moved(pointer, offset);
        let entry = machine.memory.data_block(number).ok_or(Fault::programming(0x3A, number as u16))?;
        let byte = position >> 3;
        if width != Width::Bit && position & 7 != 0 {
            return Err(fault(0x28, write, Area::SharedData, width, byte));
        }
        if u64::from(byte) + u64::from(width.bytes()) > u64::from(entry.length) {
            return Err(outside(write, Area::SharedData, width, byte));
        }
        if write && entry.read_only {
            return Err(Fault::programming(0x30, number as u16));
        }
        return Ok(Target::Arena(entry.base as usize + byte as usize, (position & 7) as u8));
    }
    locate(machine, file, local, place, width, write)
}

/// The arena byte at which so many bytes begin, if all of them are known to be there without asking about each, and may be written.
#[inline(always)]
pub fn bytes_far(
    machine: &Machine,
    file: &File,
    local: &dyn Fn(usize) -> Range<usize>,
    place: Place,
    bytes: u32,
    write: bool,
) -> Option<usize> {
    let entry = |number: u64| machine.memory.data_block(number).filter(|entry| !(write && entry.read_only));
    let open = |register: DataRegister| {
        let [number, base, length] = data_registers(register).map(|register| file[register as usize]);
        (!write || number == 0 || entry(number).is_some()).then_some((base as usize, length as usize))
    };
    let in_area = |area: Area, position: u32| match area {
        Area::SharedData => open(DataRegister::Shared).map(|range| (range, position)),
        Area::InstanceData => open(DataRegister::Instance).map(|range| (range, position)),
        Area::CallerLocal => {
            let range = local(1 + (position >> CALLS_SHIFT) as usize);
            Some(((range.start, range.len()), position & CALLS_MASK))
        }
        Area::PeripheralInput | Area::PeripheralOutput => None,
        _ => {
            let range = if area == Area::Local { local(0) } else { machine.memory.layout.area(area)? };
            Some(((range.start, range.len()), position))
        }
    };
    let ((start, length), position) = match place {
        Place::Fixed { area, position } => in_area(area, position)?,
        Place::Indirect { area, pointer, offset } => in_area(area, moved(file[usize::from(pointer.0)], offset))?,
        Place::Crossing { pointer, offset } => {
            let pointer = file[usize::from(pointer.0)];
            let position = moved(pointer, offset);
            match pointed_area(pointer, write).ok()? {
                Area::SharedData if pointer >> 32 & 0xFFFF != 0 => {
                    let entry = entry(pointer >> 32 & 0xFFFF)?;
                    ((entry.base as usize, entry.length as usize), position)
                }
                area => in_area(area, position)?,
            }
        }
    };
    let byte = (position >> 3) as usize;
    (position & 7 == 0 && byte + bytes as usize <= length).then_some(start + byte)
}

/// A pointer moved by an offset, with carry from the bit into the byte address; 24 bits.
fn moved(pointer: u64, offset: u32) -> u32 {
    ((pointer & 0x00FF_FFFF) + u64::from(offset)) as u32 & 0x00FF_FFFF
}

/// The area of an area-crossing pointer.
///
/// # Errors
/// Programming error 16#24 (read) or 16#25 (write) with the code of the area, if there is none of this code.
pub fn pointed_area(pointer: u64, write: bool) -> Result<Area, Fault> {
    Ok(match (pointer >> 24) as u8 {
        0x80 if write => Area::PeripheralOutput,
        0x80 => Area::PeripheralInput,
        0x81 => Area::Input,
        0x82 => Area::Output,
        0x83 => Area::BitMemory,
        0x84 => Area::SharedData,
        0x85 => Area::InstanceData,
        0x86 => Area::Local,
        0x87 => Area::CallerLocal,
        code => return Err(Fault::programming(0x24 + u8::from(write), u16::from(code))),
    })
}

/// The arena bytes at which a move of so many bytes begins, from and to.
///
/// # Errors
/// The fault of the end that lies outside; then nothing may be moved.
pub fn plan_move(
    machine: &Machine,
    file: &File,
    local: &dyn Fn(usize) -> Range<usize>,
    (from, to, bytes): (Place, Place, u32),
) -> Result<Option<(usize, usize)>, Fault> {
    let Some(last) = bytes.checked_sub(1) else { return Ok(None) };
    let ends = [(from, false), (to, true)];
    for (place, write) in ends {
        locate_far(machine, file, local, place.moved(last), Width::Byte, write)?;
    }
    let [from, to] =
        [locate_far(machine, file, local, from, Width::Byte, false)?, locate_far(machine, file, local, to, Width::Byte, true)?];
    match (from, to) {
        (Target::Arena(from, _), Target::Arena(to, _)) => Ok(Some((from, to))),
        (Target::Peripheral(byte), _) => Err(Fault::IoAccess { write: false, width: Width::Byte, byte }),
        (_, Target::Peripheral(byte)) => Err(Fault::IoAccess { write: true, width: Width::Byte, byte }),
    }
}

/// Moves bytes that [`plan_move`] found, overlapping or not.
pub fn move_bytes(machine: &mut Machine, plan: Option<(usize, usize)>, bytes: u32) {
    if let Some((from, to)) = plan {
        machine.memory.arena.copy_within(from..from + bytes as usize, to);
    }
}

/// Reads the peripheral. A quad word is two double words, the high one first; `None` if no module answers.
pub fn read_peripheral(context: &mut Context<'_>, byte: u32, width: Width) -> Option<u64> {
    if width != Width::QuadWord {
        return context.host.peripheral_read(context.machine, byte, width).map(u64::from);
    }
    let high = context.host.peripheral_read(context.machine, byte, Width::DoubleWord)?;
    let low = context.host.peripheral_read(context.machine, byte.saturating_add(4), Width::DoubleWord)?;
    Some(u64::from(high) << 32 | u64::from(low))
}

/// Writes the peripheral. A quad word is two double words, the high one first; `false` if no module answers.
pub fn write_peripheral(context: &mut Context<'_>, byte: u32, width: Width, value: u64) -> bool {
    if width != Width::QuadWord {
        return context.host.peripheral_write(context.machine, byte, width, value as u32);
    }
    context.host.peripheral_write(context.machine, byte, Width::DoubleWord, (value >> 32) as u32)
        && context.host.peripheral_write(context.machine, byte.saturating_add(4), Width::DoubleWord, value as u32)
}

/// The file at the beginning of a run: these registers, all temporaries 0.
pub fn load_file(registers: &Registers) -> File {
    let mut file = [0; 256];
    file[..Register::COUNT].copy_from_slice(&registers.to_words());
    file
}

/// The registers in a file, or in the part of one that holds them.
pub fn registers<const N: usize>(file: &[u64; N]) -> Registers {
    let mut words = [0; Register::COUNT];
    words.copy_from_slice(&file[..Register::COUNT]);
    Registers::from_words(&words)
}

/// Shows the registers of the file in the machine.
pub fn store_file<const N: usize>(machine: &mut Machine, file: &[u64; N]) {
    machine.registers = registers(file);
}

/// What the end of a block that is called now restores.
pub fn caller_registers<const N: usize>(file: &[u64; N]) -> CallerRegisters {
    CallerRegisters {
        shared: data_registers(DataRegister::Shared).map(|register| file[register as usize]),
        instance: data_registers(DataRegister::Instance).map(|register| file[register as usize]),
        mcr_active: file[Register::Ma as usize],
        nesting: file[Register::Nesting as usize],
    }
}

/// Restores them.
pub fn restore_caller<const N: usize>(file: &mut [u64; N], caller: &CallerRegisters) {
    for (register, value) in data_registers(DataRegister::Shared).into_iter().zip(caller.shared) {
        file[register as usize] = value;
    }
    for (register, value) in data_registers(DataRegister::Instance).into_iter().zip(caller.instance) {
        file[register as usize] = value;
    }
    file[Register::Ma as usize] = caller.mcr_active;
    file[Register::Nesting as usize] = caller.nesting;
}

/// Status at the start of a called block and behind a call: OS, OR and /FC are 0, STA is 1.
pub fn after_call<const N: usize>(file: &mut [u64; N]) {
    file[Register::Os as usize] = 0;
    file[Register::Or as usize] = 0;
    file[Register::Sta as usize] = 1;
    file[Register::Fc as usize] = 0;
}

/// Opens data block `number`; 0 closes the register.
///
/// # Errors
/// There is no such block, or no CPU of this type can have it.
pub fn open<const N: usize>(machine: &Machine, file: &mut [u64; N], register: DataRegister, number: u64) -> Result<(), Fault> {
    let number = number & 0xFFFF;
    let (base, length) = if number == 0 {
        (0, 0)
    } else if let Some(entry) = machine.memory.data_block(number) {
        (u64::from(entry.base), u64::from(entry.length))
    } else {
        let too_high = number > u64::from(machine.memory.layout.db_number_max);
        let code = match register {
            DataRegister::Shared if too_high => 0x32,
            DataRegister::Instance if too_high => 0x33,
            _ => 0x3A,
        };
        return Err(Fault::programming(code, number as u16));
    };
    for (register, value) in data_registers(register).into_iter().zip([number, base, length]) {
        file[register as usize] = value;
    }
    Ok(())
}

/// The first 20 bytes of the local data of an organization block.
pub fn write_start_information(machine: &mut Machine, information: &[u8; 20]) {
    let Some(frame) = machine.frames.last() else { return };
    let start = machine.memory.layout.local.start + frame.local_base as usize;
    let length = information.len().min(frame.local_size as usize);
    machine.memory.arena[start..start + length].copy_from_slice(&information[..length]);
}
