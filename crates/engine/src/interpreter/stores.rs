//! Tells a tracer what statements store. Only a watched run comes here.

use sieben_model::address::Width;
use sieben_model::block::BlockId;

use crate::access::{File, Target, locate_far};
use crate::host::Context;
use crate::intrinsics::Intrinsic;
use crate::ir::Place as IrPlace;
use crate::tracer::Stored;

/// A value is about to be written at an arena byte.
pub(super) fn value(context: &mut Context<'_>, at: usize, bit: u8, width: Width) {
    let mask = if width == Width::Bit { 1 << (bit & 7) } else { 0xFF };
    tell(context, Stored::Memory { first: at, bytes: width.bytes() as usize, mask });
}

/// A value is about to be written to modules.
pub(super) fn peripheral(context: &mut Context<'_>, byte: u32, width: Width) {
    tell(context, Stored::Peripheral { first: byte, bytes: width.bytes() });
}

/// Bytes are about to be moved to a place.
pub(super) fn moved(context: &mut Context<'_>, file: &File, to: IrPlace, bytes: u32) {
    let machine = &*context.machine;
    if let Ok(Target::Arena(first, _)) = locate_far(machine, file, &|outwards| machine.local_data(outwards), to, Width::Byte, true) {
        tell(context, Stored::Memory { first, bytes: bytes as usize, mask: 0xFF });
    }
}

/// An intrinsic has done its work. Where the RLO has to be 1 for that, one with 0 stores nothing.
pub(super) fn intrinsic(context: &mut Context<'_>, intrinsic: Intrinsic, [number, rlo]: [u64; 2]) {
    let number = number as u16;
    let stored = match intrinsic {
        Intrinsic::TimerStart(_) => Stored::Timer(number),
        Intrinsic::TimerReset | Intrinsic::TimerEnable if rlo & 1 == 1 => Stored::Timer(number),
        Intrinsic::CounterUp | Intrinsic::CounterDown | Intrinsic::CounterSet | Intrinsic::CounterReset | Intrinsic::CounterEnable
            if rlo & 1 == 1 =>
        {
            Stored::Counter(number)
        }
        _ => return,
    };
    tell(context, stored);
}

/// A system function has written these bytes of the arena.
pub(super) fn system_function(context: &mut Context<'_>, block: BlockId) {
    for range in context.host.written(context.machine, block) {
        tell(context, Stored::Memory { first: range.start, bytes: range.len(), mask: 0xFF });
    }
}

fn tell(context: &mut Context<'_>, stored: Stored) {
    if let Some(tracer) = context.tracer.as_deref_mut() {
        tracer.stores(context.machine, stored);
    }
}
