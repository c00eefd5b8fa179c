//! Tells a tracer what happens to the local data. Only a watched run comes here.

use sieben_model::address::Width;
use sieben_model::block::BlockKind;

use crate::access::{File, Target, locate};
use crate::fault::Place;
use crate::host::Context;
use crate::ir::Place as IrPlace;
use crate::tracer::LocalAccess;

/// Bytes of start information in the local data of an organization block.
const START_INFORMATION: u32 = 20;
/// Bytes that a parameter of a system function may have behind its pointer: an ANY, the largest.
const PARAMETER_BYTES: u32 = 10;
/// Bytes of a POINTER.
const POINTER_BYTES: usize = 6;

/// The newest block has begun.
pub(super) fn entered(context: &mut Context<'_>) {
    let Some(frame) = context.machine.frames.last() else { return };
    let known = if frame.block.kind == BlockKind::OrganizationBlock { START_INFORMATION } else { 0 };
    let place = Place { block: frame.block, statement: 0 };
    tell(context, place, LocalAccess::Entered { first: frame.local_base, bytes: frame.local_size, known });
}

/// A value is about to be read at an arena byte.
pub(super) fn read(context: &mut Context<'_>, place: Place, at: usize, bit: u8, width: Width) {
    if let Some(first) = byte(context, at) {
        tell(context, place, LocalAccess::Read { first, bytes: width.bytes(), mask: mask(bit, width) });
    }
}

/// A value is about to be written at an arena byte.
pub(super) fn written(context: &mut Context<'_>, place: Place, at: usize, bit: u8, width: Width) {
    if let Some(first) = byte(context, at) {
        tell(context, place, LocalAccess::Written { first, bytes: width.bytes(), mask: mask(bit, width) });
    }
}

/// Bytes are about to be moved. A structure may have been filled in part, so that moving it reads nothing.
pub(super) fn moved(context: &mut Context<'_>, file: &File, place: Place, (_, to, bytes): (IrPlace, IrPlace, u32)) {
    let machine = &*context.machine;
    if let Ok(Target::Arena(at, _)) = locate(machine, file, &|outwards| machine.local_data(outwards), to, Width::Byte, true)
        && let Some(first) = byte(context, at)
    {
        tell(context, place, LocalAccess::Written { first, bytes, mask: 0xFF });
    }
}

/// A system function is about to be called: what its parameters point to may be written by it.
pub(super) fn given(context: &mut Context<'_>, place: Place, parameters: u16) {
    let start = context.machine.parameters.len().saturating_sub(usize::from(parameters));
    let pointers = context.machine.parameters[start..].to_vec();
    for pointer in pointers {
        let Some((first, left)) = local_byte(context, pointer) else { continue };
        tell(context, place, LocalAccess::Written { first, bytes: left.min(PARAMETER_BYTES), mask: 0xFF });
        // Behind the pointer may stand an ANY to local data: 10 type count DB pointer.
        let arena = &context.machine.memory.arena;
        let at = context.machine.memory.layout.local.start + first as usize;
        // For a structure there stands a POINTER: DB pointer. It does not tell the size.
        if let Some(&[0, 0, a, b, c, d]) = arena.get(at..at + POINTER_BYTES)
            && let Some((first, left)) = local_byte(context, u32::from_be_bytes([a, b, c, d]))
        {
            tell(context, place, LocalAccess::Written { first, bytes: left, mask: 0xFF });
            continue;
        }
        let Some(&[0x10, kind, high, low, _, _, a, b, c, d]) = arena.get(at..at + PARAMETER_BYTES as usize) else { continue };
        let Some((first, left)) = local_byte(context, u32::from_be_bytes([a, b, c, d])) else { continue };
        let unit = match kind {
            0x01 => 1,
            0x04 | 0x05 => 2,
            0x06..=0x08 => 4,
            _ => 1,
        };
        let bytes = left.min(u32::from(u16::from_be_bytes([high, low])) * unit);
        tell(context, place, LocalAccess::Written { first, bytes, mask: 0xFF });
    }
}

/// The byte of the local data that a pointer means for a system function, and how many follow in the same block.
fn local_byte(context: &Context<'_>, pointer: u32) -> Option<(u32, u32)> {
    let outwards = match pointer >> 24 {
        0x86 => 0,
        0x87 => (pointer & 0x00FF_FFFF) >> crate::machine::CALLS_SHIFT,
        _ => return None,
    };
    let range = context.machine.local_data(outwards as usize);
    let at = range.start + ((pointer & crate::machine::CALLS_MASK) >> 3) as usize;
    let first = range.contains(&at).then(|| byte(context, at)).flatten()?;
    Some((first, (range.end - at) as u32))
}

/// The byte of the local data at an arena byte.
fn byte(context: &Context<'_>, at: usize) -> Option<u32> {
    let local = &context.machine.memory.layout.local;
    local.contains(&at).then(|| (at - local.start) as u32)
}

fn mask(bit: u8, width: Width) -> u8 {
    if width == Width::Bit { 1 << (bit & 7) } else { 0xFF }
}

fn tell(context: &mut Context<'_>, place: Place, access: LocalAccess) {
    if let Some(tracer) = context.tracer.as_deref_mut() {
        tracer.local_data(context.machine, place, access);
    }
}
