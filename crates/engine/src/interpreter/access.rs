//! Finds the byte that an access means, or the fault it is.

use sieben_model::address::{Area, Width};

use crate::fault::Fault;
use crate::ir::{DataRegister, Place};
use crate::machine::{CALLS_MASK, CALLS_SHIFT, Machine, Register};

/// The registers and temporaries while a block runs.
pub(super) type File = [u64; 256];

/// What an access means.
pub(super) enum Target {
    /// A byte of the arena, and the bit in it.
    Arena(usize, u8),
    /// A byte of a module.
    Peripheral(u32),
}

/// Registers of a data block register: number, base, length.
pub(super) fn data_registers(register: DataRegister) -> [Register; 3] {
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
        Width::DoubleWord => 3,
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
#[inline(always)]
pub(super) fn in_data_block(
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

/// What a place means now.
pub(super) fn locate(machine: &Machine, file: &File, place: Place, width: Width, write: bool) -> Result<Target, Fault> {
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
        Area::Local => machine.local_data(0),
        Area::CallerLocal => machine.local_data(1 + (position >> CALLS_SHIFT) as usize),
        Area::Input | Area::Output | Area::BitMemory => machine.memory.layout.area(area).unwrap_or(0..0),
    };
    if u64::from(byte) + u64::from(width.bytes()) > range.len() as u64 {
        return Err(outside(write, area, width, byte));
    }
    Ok(Target::Arena(range.start + byte as usize, (position & 7) as u8))
}

/// A pointer moved by an offset, with carry from the bit into the byte address; 24 bits.
fn moved(pointer: u64, offset: u32) -> u32 {
    ((pointer & 0x00FF_FFFF) + u64::from(offset)) as u32 & 0x00FF_FFFF
}

/// The area of an area-crossing pointer.
fn pointed_area(pointer: u64, write: bool) -> Result<Area, Fault> {
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
