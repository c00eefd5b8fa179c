//! What the code of tests asks the CPU: the words of test files, and whether a block is mocked.

use sieben_engine::Reaction;
use sieben_engine::machine::{CALLS_SHIFT, Machine};
use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Interface, Section};
use sieben_model::testing::{HOLD_INPUT, MOCKED, SET_INPUT, TEXTS, WORD};
use sieben_model::types::DataType;

use super::parameters::{Place, locate};
use super::{Call, Parameter, Row, Run, input};
use crate::system_state::Asked;

/// What programs of tests call. Their parameters are passed as pointers to values of whatever width the question has.
pub(super) static CALLED: &[Row] = &[
    Row { block: WORD, name: "__TEST_WORD", parameters: WORD_PARAMETERS, run: Run::Reaction(word), only: None },
    Row { block: TEXTS, name: "__TEST_TEXTS", parameters: TEXT_PARAMETERS, run: Run::Reaction(texts), only: None },
    Row { block: MOCKED, name: "__TEST_MOCKED", parameters: &[input("ANSWER", DataType::Byte)], run: Run::Reaction(mocked), only: None },
    Row { block: SET_INPUT, name: "__TEST_SET_INPUT", parameters: INPUT_PARAMETERS, run: Run::Reaction(set_input), only: None },
    Row { block: HOLD_INPUT, name: "__TEST_HOLD_INPUT", parameters: HOLD_PARAMETERS, run: Run::Reaction(hold_input), only: None },
];

const WORD_PARAMETERS: &[Parameter] = &[
    input("ROW", DataType::DoubleWord),
    input("HOLDS", DataType::Bool),
    input("A", DataType::DoubleWord),
    input("B", DataType::DoubleWord),
    input("C", DataType::DoubleWord),
];
const TEXT_PARAMETERS: &[Parameter] =
    &[input("ROW", DataType::DoubleWord), input("A", DataType::String(254)), input("B", DataType::String(254))];
const INPUT_PARAMETERS: &[Parameter] =
    &[input("BYTE", DataType::DoubleWord), input("BYTES", DataType::DoubleWord), input("VALUE", DataType::DoubleWord)];
const HOLD_PARAMETERS: &[Parameter] = &[input("FIRST", DataType::DoubleWord), input("BITS", DataType::DoubleWord)];

/// The place of the result of a function: index among its parameters and width.
pub(crate) fn result_of(interface: &Interface) -> Option<(usize, Width)> {
    let is_result = |variable: &sieben_model::interface::Variable| {
        variable.section == Section::Return || variable.section == Section::Output && variable.name.eq_ignore_ascii_case("RET_VAL")
    };
    let (index, result) = interface.parameters().enumerate().find(|(_, variable)| is_result(variable))?;
    Some((index, result.data_type.width()?))
}

/// Bytes of the arena behind a pointer that was passed; what cannot be read is 0.
fn bytes_behind(call: &Call<'_, '_>, index: usize) -> [u8; 8] {
    let mut bytes = [0; 8];
    let Some(&pointer) = call.machine.parameters.get(call.first + index) else { return bytes };
    let Ok(Place::Arena(at)) = locate(call.machine, 0, pointer, 1, false) else { return bytes };
    for (byte, &source) in bytes.iter_mut().zip(call.machine.memory.arena.get(at..).unwrap_or_default()) {
        *byte = source;
    }
    bytes
}

fn number(call: &Call<'_, '_>, index: usize) -> u32 {
    let [a, b, c, d, ..] = bytes_behind(call, index);
    u32::from_be_bytes([a, b, c, d])
}

fn word(call: &mut Call<'_, '_>) -> Reaction {
    let holds = match call.input(1, Width::Bit) {
        Ok(bit) => bit == 1,
        Err(_) => false,
    };
    if holds {
        return Reaction::Continue;
    }
    let asked = Asked { row: number(call, 0), values: [bytes_behind(call, 2), bytes_behind(call, 3), bytes_behind(call, 4)], texts: None };
    ask(call, asked)
}

fn texts(call: &mut Call<'_, '_>) -> Reaction {
    let text = |index: usize| call.text(index).unwrap_or_default();
    let asked = Asked { row: number(call, 0), texts: Some([text(1), text(2)]), ..Asked::default() };
    ask(call, asked)
}

/// Puts the test aside. Outside of one nobody answers: the question is left out.
fn ask(call: &mut Call<'_, '_>, asked: Asked) -> Reaction {
    if !call.host.testing {
        return Reaction::Continue;
    }
    call.host.system.asked = Some(asked);
    Reaction::Suspend
}

/// Whether the block that asks is mocked: counts the call, and writes the result of a function.
fn mocked(call: &mut Call<'_, '_>) -> Reaction {
    let answer = match call.machine.frames.last().map(|frame| frame.block) {
        Some(block) => answer(call, block, None),
        None => false,
    };
    // The answer lies in the local data of the block, which nobody writes to.
    let _ = call.output(0, Width::Byte, u32::from(answer));
    Reaction::Continue
}

/// The same for a system function, where it is called. `first_parameter` is that of the call.
pub(crate) fn system_function(call: &mut Call<'_, '_>, block: BlockId) -> bool {
    let first = call.first;
    answer(call, block, Some(first))
}

fn answer(call: &mut Call<'_, '_>, block: BlockId, system: Option<usize>) -> bool {
    let instance = matches!(block.kind, BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock).then(|| instance(call.machine));
    let Some(mock) = call.host.system.mocks.iter_mut().find(|mock| mock.block == block && mock.instance == instance) else { return false };
    mock.calls += 1;
    if let Some((index, width, value)) = mock.result {
        write_result(call.machine, system, index, width, value);
    }
    // A call that is left out has not failed.
    call.machine.registers.br = 1;
    true
}

/// The instance that a block works on: its data block and first byte.
fn instance(machine: &Machine) -> (u16, u32) {
    (machine.registers.di_number as u16, (machine.registers.ar2 as u32 & 0x00FF_FFFF) >> 3)
}

/// Writes the result of the running function, or of a system function with its first parameter.
fn write_result(machine: &mut Machine, system: Option<usize>, index: usize, width: Width, value: u64) {
    let first = match (system, machine.frames.last()) {
        (Some(first), _) => first,
        (None, Some(frame)) => frame.parameters as usize,
        (None, None) => return,
    };
    let Some(&pointer) = machine.parameters.get(first + index) else { return };
    // V of the function is the local data of its caller, one block further out than that of who asks.
    let of_caller = system.is_none() && pointer >> 24 == u32::from(Area::CallerLocal.pointer_code());
    let pointer = if of_caller { pointer + (1 << CALLS_SHIFT) } else { pointer };
    let Ok(Place::Arena(at)) = locate(machine, 0, pointer, width.bytes(), true) else { return };
    machine.memory.write_wide(at, (pointer & 7) as u8, width, value);
}

/// Sets a peripheral input of a simulated module.
fn set_input(call: &mut Call<'_, '_>) -> Reaction {
    let (byte, bytes, value) = (number(call, 0), number(call, 1).min(4) as usize, number(call, 2));
    let value = value.to_be_bytes();
    for (index, &one) in value[4 - bytes..].iter().enumerate() {
        let at = byte.saturating_add(index as u32);
        call.host.rack.set_input(at, 0xFF, one);
        // The process image shows it too, as that of an input which the test writes.
        if let Some(image) = call.machine.memory.area_mut(Area::Input).get_mut(at as usize) {
            *image = one;
        }
    }
    Reaction::Continue
}

/// Holds inputs of a simulated module at what the test has just written to the process image, even if that is what they were.
fn hold_input(call: &mut Call<'_, '_>) -> Reaction {
    let first = number(call, 0);
    let end = first.saturating_add(number(call, 1));
    for byte in first / 8..end.div_ceil(8) {
        // An address behind the process image was a fault of the statement that wrote it.
        let Some(&image) = call.machine.memory.area(Area::Input).get(byte as usize) else { break };
        let mask = (0..8).filter(|bit| (first..end).contains(&(byte * 8 + bit))).fold(0, |mask, bit| mask | 1 << bit);
        call.host.rack.set_input(byte, mask, image);
    }
    Reaction::Continue
}
