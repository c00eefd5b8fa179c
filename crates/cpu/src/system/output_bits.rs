//! What SFC 79 and 80 have in common: a run of output bits.

use sieben_engine::Host;
use sieben_model::address::{Area, Width};
use sieben_model::types::DataType;

use super::parameters::{Answer, Refused};
use super::{Call, Parameter, input, output, ret_val};

pub(super) const PARAMETERS: &[Parameter] = &[input("N", DataType::Int), ret_val(), output("SA", DataType::Pointer)];

/// Sets or resets N bits of the peripheral outputs from SA on, as `S` and `R` do: not while the MCR is off.
pub(super) fn write(call: &mut Call<'_, '_>, value: bool) -> Answer {
    let count = call.input(0, Width::Word)? as u16 as i16;
    let [_, _, p3, p2, p1, p0] = call.passed::<6>(2, true)?;
    let pointer = u32::from_be_bytes([p3, p2, p1, p0]);
    // The process image means the same outputs: whoever writes one writes the other.
    if ![Area::PeripheralOutput, Area::Output].iter().any(|area| u32::from(area.pointer_code()) == pointer >> 24) {
        return Err(Refused::AREA.when(true).of(2));
    }
    let count = u32::try_from(count).map_err(|_| Refused::LENGTH.of(0))?;
    let first = pointer & 0x00FF_FFFF;
    let end = first + count;
    if end > call.machine.memory.layout.peripheral * 8 {
        return Err(Refused::LENGTH.when(true).of(2));
    }
    let registers = &call.machine.registers;
    if count == 0 || (registers.ma == 1 && registers.mcr & 1 == 0) {
        return Ok(0);
    }
    let bytes = first / 8..end.div_ceil(8);
    let old = |call: &Call<'_, '_>, byte| call.host.rack.peripheral_output(byte, Width::Byte);
    if bytes.clone().any(|byte| old(call, byte).is_none()) {
        return Err(Refused::PERIPHERAL.when(true).of(2));
    }
    for byte in bytes {
        let bits = (0..8).filter(|bit| (first..end).contains(&(byte * 8 + bit))).fold(0, |bits, bit| bits | 1 << bit);
        let before = old(call, byte).unwrap_or_default();
        let after = if value { before | bits } else { before & !bits };
        if !call.host.peripheral_write(call.machine, byte, Width::Byte, after) {
            return Err(Refused::PERIPHERAL.when(true).of(2));
        }
    }
    Ok(0)
}
