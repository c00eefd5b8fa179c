//! Variables are read and written, all those of a job between the same two scans.

use sieben_cpu::{AccessError, Station};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::bcd;
use sieben_model::item::Item;
use sieben_model::value::{Content, Kind, Value};
use sieben_workspace::gate::Plant;

use crate::s7comm::job::{Assignment, Reply, TransportSize, Variable, VariableArea};
use crate::s7comm::wire::codes::ItemCode;

/// Digits of a timer or counter.
const DIGITS: u32 = 3;

/// Reads variables.
pub(super) fn read(plant: &Plant, variables: &[Result<Variable, ItemCode>]) -> Reply {
    let items: Vec<Item> = variables.iter().flatten().filter_map(|variable| item(variable, Direction::Read)).collect();
    let mut values = plant.cpu.read_items(&items).into_iter();
    let mut value = |variable: &Variable| match variable.area {
        VariableArea::Timer => numbers(variable)?.map(|number| timer(plant, number)).collect::<Result<Vec<_>, _>>().map(bytes_of),
        VariableArea::Counter => numbers(variable)?.map(|number| counter(plant, number)).collect::<Result<Vec<_>, _>>().map(bytes_of),
        _ => match values.next() {
            Some(Ok(Value { content: Content::Bits(bit), .. })) => Ok(Box::from([u8::from(bit != 0)])),
            Some(Ok(Value { content: Content::Bytes(bytes), .. })) => Ok(bytes),
            Some(Err(error)) => Err(code_of(error)),
            None => Err(ItemCode::HardwareFault),
        },
    };
    Reply::Values(variables.iter().map(|variable| variable.as_ref().map_err(|code| *code).and_then(&mut value)).collect())
}

/// Writes variables, one after the other.
pub(super) fn write(plant: &mut Plant, assignments: &[Result<Assignment, ItemCode>]) -> Reply {
    let code = |assignment: &Result<Assignment, ItemCode>| match assignment {
        Ok(assignment) => match write_one(plant, assignment) {
            Ok(()) => ItemCode::Done,
            Err(code) => code,
        },
        Err(code) => *code,
    };
    Reply::Written(assignments.iter().map(code).collect())
}

fn write_one(plant: &mut Plant, assignment: &Assignment) -> Result<(), ItemCode> {
    let Assignment { variable, bytes } = assignment;
    match variable.area {
        VariableArea::Timer | VariableArea::Counter => write_words(plant, variable, bytes),
        _ => {
            let item = item(variable, Direction::Write).ok_or(ItemCode::NotThere)?;
            let value = match (&item.kind, &**bytes) {
                (Kind::Bit, [bit]) => Value::bits(Kind::Bit, u64::from(*bit)),
                (_, bytes) => Value::bytes(bytes),
            };
            let result = plant.cpu.write_items(&[(item, value)]).pop();
            result.unwrap_or(Err(AccessError::NotAccessible)).map_err(code_of)
        }
    }
}

/// Timers take words of S5TIME, counters three decimal digits; either all of them are set or none.
fn write_words(plant: &mut Plant, variable: &Variable, bytes: &[u8]) -> Result<(), ItemCode> {
    let words: Vec<u32> = bytes.chunks_exact(2).map(|word| u32::from(word[0]) << 8 | u32::from(word[1])).collect();
    for (number, &word) in numbers(variable)?.zip(&words) {
        match variable.area {
            VariableArea::Timer => timer(plant, number)?,
            _ => counter(plant, number)?,
        };
        let rest = if variable.area == VariableArea::Timer { 0 } else { word >> (4 * DIGITS) };
        if rest != 0 || !bcd::is_decimal(word, DIGITS) {
            return Err(ItemCode::TypeInconsistent);
        }
    }
    for (number, &word) in numbers(variable)?.zip(&words) {
        let (operand, value) = match variable.area {
            VariableArea::Timer => (Operand::Timer(number), word),
            _ => (Operand::Counter(number), bcd::decode(word, DIGITS)),
        };
        plant.cpu.modify(&operand, value).map_err(code_of)?;
    }
    Ok(())
}

/// The numbers of timers or counters.
fn numbers(variable: &Variable) -> Result<impl Iterator<Item = u16> + use<>, ItemCode> {
    let first = u16::try_from(variable.address).map_err(|_| ItemCode::OutOfRange)?;
    let last = first.checked_add(variable.count.saturating_sub(1)).ok_or(ItemCode::OutOfRange)?;
    Ok(first..=last)
}

/// A timer as `LC` reads it: its time base and three decimal digits.
fn timer(plant: &Plant, number: u16) -> Result<u16, ItemCode> {
    let reading = plant.cpu.timer(number).ok_or(ItemCode::OutOfRange)?;
    Ok(u16::from(reading.base & 3) << (4 * DIGITS) | decimal(u32::from(reading.value)))
}

/// A counter as `LC` reads it: three decimal digits.
fn counter(plant: &Plant, number: u16) -> Result<u16, ItemCode> {
    plant.cpu.read(&Operand::Counter(number)).map(decimal).map_err(code_of)
}

fn decimal(value: u32) -> u16 {
    bcd::encode(value.min(999)) as u16
}

fn bytes_of(words: Vec<u16>) -> Box<[u8]> {
    words.into_iter().flat_map(u16::to_be_bytes).collect()
}

/// Whether a variable is read or written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Direction {
    Read,
    Write,
}

/// The item that a variable is; `None` for timers and counters.
fn item(variable: &Variable, direction: Direction) -> Option<Item> {
    let (area, db) = match variable.area {
        VariableArea::Peripheral if direction == Direction::Read => (Area::PeripheralInput, None),
        VariableArea::Peripheral => (Area::PeripheralOutput, None),
        VariableArea::Input => (Area::Input, None),
        VariableArea::Output => (Area::Output, None),
        VariableArea::BitMemory => (Area::BitMemory, None),
        VariableArea::DataBlock(number) => (Area::SharedData, Some(number)),
        VariableArea::Timer | VariableArea::Counter => return None,
    };
    let byte = variable.address / 8;
    if variable.size == TransportSize::Bit {
        let address = Address { area, width: Width::Bit, byte, bit: (variable.address % 8) as u8 };
        return Some(Item::operand(db.map_or(Operand::Address(address), |db| Operand::InDataBlock { db, address })));
    }
    let length = u32::try_from(variable.bytes()).unwrap_or(u32::MAX);
    Some(db.map_or_else(|| Item::area(area, byte, length), |db| Item::data(db, byte, length)))
}

/// The code of a variable that cannot be reached.
fn code_of(error: AccessError) -> ItemCode {
    match error {
        AccessError::Outside => ItemCode::OutOfRange,
        AccessError::NotLoaded | AccessError::NotAccessible => ItemCode::NotThere,
        AccessError::NoModule => ItemCode::HardwareFault,
        AccessError::Value => ItemCode::TypeInconsistent,
        AccessError::WriteProtected
        | AccessError::ReadOnly
        | AccessError::NotForced
        | AccessError::NotRunning(_)
        | AccessError::NoRegister => ItemCode::AccessRefused,
    }
}
