//! System functions with negative numbers: what extended programs call, and what the code of extension words asks.

use std::borrow::Cow;

use sieben_engine::{Reaction, StopReason};
use sieben_model::address::Width;
use sieben_model::block::BlockId;
use sieben_model::extension::{
    ASSERT_BYTES, ASSERTION_FAILED, Compared, FailedAssertion, NOTHING, NOTHING_WITH_INSTANCE, REBOOT, RESTART_CLOCK_MEMORY, Relation,
    SHUTDOWN, SLEEP, Side,
};
use sieben_model::types::DataType;

use super::parameters::{Place, locate};
use super::{Call, Parameter, Row, Run, input};

/// STOP by the test functions.
pub(crate) const STOP_BY_TEST: u16 = 0x4543;
/// STOP by the program.
const STOP_BY_PROGRAM: u16 = 0x457F;
/// The one type of `__REBOOT` that is known.
const RESTART_OF_CPU: u32 = 1;

/// The types of `__SHUTDOWN` that are known: the program is over, the CPU goes to STOP.
const END: u32 = 1;
const STOP: u32 = 2;

/// What programs call by number or name.
pub(super) static CALLED: &[Row] = &[
    Row { block: NOTHING, name: "__SFC_NOP", parameters: &[], run: Run::Reaction(nothing), only: None },
    Row { block: REBOOT, name: "__REBOOT", parameters: REBOOT_PARAMETERS, run: Run::Reaction(reboot), only: None },
    Row { block: SHUTDOWN, name: "__SHUTDOWN", parameters: SHUTDOWN_PARAMETERS, run: Run::Reaction(shutdown), only: None },
    Row { block: RESTART_CLOCK_MEMORY, name: "__CLKRST", parameters: &[], run: Run::Reaction(restart_clock_memory), only: None },
    Row { block: NOTHING_WITH_INSTANCE, name: "__SFB_NOP", parameters: &[], run: Run::Instance(|_| true), only: None },
];

const SHUTDOWN_PARAMETERS: &[Parameter] = &[input("SHUTDOWN_TYPE", DataType::Int)];
const REBOOT_PARAMETERS: &[Parameter] = &[input("REBOOT_TYPE", DataType::Int)];

/// The function behind a number that only the code of extension words calls; its parameters are values, not pointers.
pub(super) fn asked(block: BlockId) -> Option<fn(&mut Call<'_, '_>) -> Reaction> {
    match block {
        ASSERTION_FAILED => Some(assertion_failed),
        ASSERT_BYTES => Some(assert_bytes),
        SLEEP => Some(sleep),
        _ => None,
    }
}

fn nothing(call: &mut Call<'_, '_>) -> Reaction {
    call.machine.registers.br = 1;
    Reaction::Continue
}

fn reboot(call: &mut Call<'_, '_>) -> Reaction {
    match call.input(0, Width::Word) {
        Ok(RESTART_OF_CPU) => {
            call.host.system.reboot = true;
            Reaction::Stop(StopReason { event: STOP_BY_PROGRAM, place: None })
        }
        _ => {
            call.machine.registers.br = 0;
            Reaction::Continue
        }
    }
}

/// Without its parameter, as older programs call it, the program is over as well.
fn shutdown(call: &mut Call<'_, '_>) -> Reaction {
    let wanted = if value(call, 0) == 0 { Ok(END) } else { call.input(0, Width::Word) };
    match wanted {
        Ok(END | STOP) => Reaction::Stop(StopReason { event: STOP_BY_PROGRAM, place: None }),
        _ => {
            call.machine.registers.br = 0;
            Reaction::Continue
        }
    }
}

fn restart_clock_memory(call: &mut Call<'_, '_>) -> Reaction {
    call.host.read_time(call.machine);
    call.host.system.clock_memory_from_us = call.machine.clock_us;
    // The byte is 0 at once, not with the next scan.
    if let Some(byte) = call.host.system.clock_memory_byte {
        let bit_memory = call.machine.memory.layout.bit_memory.clone();
        let at = bit_memory.start + usize::from(byte);
        if at < bit_memory.end {
            call.machine.memory.arena[at] = 0;
            call.host.written.push(at..at + 1);
        }
    }
    call.machine.registers.br = 1;
    Reaction::Continue
}

/// A parameter that is a value.
fn value(call: &Call<'_, '_>, index: usize) -> u32 {
    call.machine.parameters.get(call.first + index).copied().unwrap_or(0)
}

fn stop(call: &mut Call<'_, '_>, failed: FailedAssertion) -> Reaction {
    call.host.system.failed_assertion = Some(failed);
    Reaction::Stop(StopReason { event: STOP_BY_TEST, place: None })
}

fn assertion_failed(call: &mut Call<'_, '_>) -> Reaction {
    let Some(Compared { relation, bits }) = Compared::from_word(value(call, 0)) else { return Reaction::Continue };
    let side = |value, bits| match relation {
        Relation::EqualReal => Side::Real(value),
        _ => Side::Number { value, bits },
    };
    let failed = FailedAssertion { relation, left: side(value(call, 1), bits[0]), right: side(value(call, 2), bits[1]) };
    stop(call, failed)
}

/// The bytes behind a POINTER that was passed; what cannot be read is empty.
fn bytes<'m>(call: &'m Call<'_, '_>, index: usize) -> Cow<'m, [u8]> {
    let length = value(call, index + 1);
    let Ok([d1, d0, p3, p2, p1, p0]) = call.passed::<6>(index, false) else { return Cow::default() };
    match locate(call.machine, u16::from_be_bytes([d1, d0]), u32::from_be_bytes([p3, p2, p1, p0]), length, false) {
        Ok(Place::Arena(at)) => call.machine.memory.arena[at..at + length as usize].into(),
        _ => Cow::default(),
    }
}

fn assert_bytes(call: &mut Call<'_, '_>) -> Reaction {
    let Some(relation) = u8::try_from(value(call, 0)).ok().and_then(Relation::from_code) else { return Reaction::Continue };
    let (left, right) = (bytes(call, 1), bytes(call, 3));
    if relation.holds(&left, &right) {
        return Reaction::Continue;
    }
    let failed = FailedAssertion { relation, left: Side::Bytes(left.into_owned()), right: Side::Bytes(right.into_owned()) };
    stop(call, failed)
}

fn sleep(call: &mut Call<'_, '_>) -> Reaction {
    let milliseconds = value(call, 0);
    call.host.wait(call.machine, u64::from(milliseconds) * 1000);
    Reaction::Continue
}
