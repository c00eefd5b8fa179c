//! Jobs 04 and 05: variables that are read and written.
//!
//! Each variable is judged for itself and has a code of its own; only what makes the rest of the frame unreadable, or the answer longer than the PDU,
//! refuses the job as a whole.

use super::codes::{ItemCode, Refusal};
use super::header::ANSWER_HEAD;
use crate::s7comm::job::{Assignment, TransportSize, Variable, VariableArea};

/// Function code of a read job.
pub const READ: u8 = 4;
/// Function code of a write job.
pub const WRITE: u8 = 5;
/// A variable begins with this byte in the parameters.
const SPECIFICATION: u8 = 0x12;
/// Its syntax is that of an ANY pointer.
const SYNTAX_ANY: u8 = 0x10;
/// Bytes before the values of a variable in the data: code, type, length.
const ITEM_HEAD: usize = 4;

/// How the length of values is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Counted {
    InBits,
    InBytes,
}

/// A transport size: its code in a request, its bytes, the code of the data in an answer and how their length is counted.
struct Row {
    size: TransportSize,
    code: u8,
    bytes: u8,
    data_code: u8,
    counted: Counted,
}

#[rustfmt::skip] // A table.
const SIZES: &[Row] = &[
    Row { size: TransportSize::Bit,        code: 0x01, bytes: 1, data_code: 0x03, counted: Counted::InBits },
    Row { size: TransportSize::Byte,       code: 0x02, bytes: 1, data_code: 0x04, counted: Counted::InBits },
    Row { size: TransportSize::Char,       code: 0x03, bytes: 1, data_code: 0x09, counted: Counted::InBytes },
    Row { size: TransportSize::Word,       code: 0x04, bytes: 2, data_code: 0x04, counted: Counted::InBits },
    Row { size: TransportSize::Int,        code: 0x05, bytes: 2, data_code: 0x05, counted: Counted::InBits },
    Row { size: TransportSize::DoubleWord, code: 0x06, bytes: 4, data_code: 0x04, counted: Counted::InBits },
    Row { size: TransportSize::DoubleInt,  code: 0x07, bytes: 4, data_code: 0x05, counted: Counted::InBits },
    Row { size: TransportSize::Real,       code: 0x08, bytes: 4, data_code: 0x07, counted: Counted::InBytes },
    Row { size: TransportSize::Counter,    code: 0x1C, bytes: 2, data_code: 0x09, counted: Counted::InBytes },
    Row { size: TransportSize::Timer,      code: 0x1D, bytes: 2, data_code: 0x09, counted: Counted::InBytes },
];

/// How the length of values that come is counted, by the code of their type; `None` for a code that does not exist.
fn counted(data_code: u8) -> Option<Counted> {
    match data_code {
        0x03..=0x05 => Some(Counted::InBits),
        0x06 | 0x07 | 0x09 => Some(Counted::InBytes),
        _ => None,
    }
}

fn row(size: TransportSize) -> &'static Row {
    SIZES.iter().find(|row| row.size == size).expect("each size has its row")
}

impl Variable {
    /// Bytes of its value in a frame.
    pub fn bytes(&self) -> usize {
        usize::from(self.count) * usize::from(row(self.size).bytes)
    }
}

/// Reads the parameters of a read job, function code included, and makes sure that the answer fits a PDU.
///
/// # Errors
/// The job as a whole is refused.
pub fn read_request(parameters: &[u8], pdu_bytes: usize) -> Result<Vec<Result<Variable, ItemCode>>, Refusal> {
    // A client asks like this to see whether the CPU answers.
    if parameters == [READ] {
        return Ok(Vec::new());
    }
    let variables = variables(parameters)?;
    let answer = |variable: &Result<Variable, ItemCode>| ITEM_HEAD + variable.map_or(0, |variable| variable.bytes().next_multiple_of(2));
    let all = variables.iter().map(answer).fold(ANSWER_HEAD + 2, usize::saturating_add);
    // No fill byte comes after the last one.
    let last_is_odd = variables.last().is_some_and(|last| last.is_ok_and(|last| last.bytes() % 2 == 1));
    if all - usize::from(last_is_odd) > pdu_bytes { Err(Refusal::WrongFrame) } else { Ok(variables) }
}

/// Reads parameters and data of a write job, function code included.
///
/// # Errors
/// The job as a whole is refused.
pub fn write_request(parameters: &[u8], mut data: &[u8]) -> Result<Vec<Result<Assignment, ItemCode>>, Refusal> {
    let variables = variables(parameters)?;
    let mut assignments = Vec::with_capacity(variables.len());
    for variable in variables {
        let (&[_, code, high, low], rest) = data.split_first_chunk().ok_or(Refusal::WrongFrame)?;
        let length = usize::from(u16::from_be_bytes([high, low]));
        let counted = counted(code);
        let length = if counted == Some(Counted::InBits) { length.div_ceil(8) } else { length };
        let (bytes, rest) = rest.split_at_checked(length).ok_or(Refusal::WrongFrame)?;
        // Whether the last one is filled up is up to the client.
        data = if length % 2 == 1 && !rest.is_empty() { &rest[1..] } else { rest };
        assignments.push(variable.and_then(|variable| assignment(variable, bytes, counted)));
    }
    if data.is_empty() { Ok(assignments) } else { Err(Refusal::WrongFrame) }
}

fn assignment(variable: Variable, bytes: &[u8], counted: Option<Counted>) -> Result<Assignment, ItemCode> {
    match bytes {
        _ if bytes.len() != variable.bytes() || counted.is_none() => Err(ItemCode::TypeInconsistent),
        [bit] if variable.size == TransportSize::Bit => Ok(Assignment { variable, bytes: Box::new([u8::from(*bit != 0)]) }),
        _ => Ok(Assignment { variable, bytes: bytes.into() }),
    }
}

/// The variables that parameters name: the function code, how many, and one after the other.
fn variables(parameters: &[u8]) -> Result<Vec<Result<Variable, ItemCode>>, Refusal> {
    let &[_, count, ref rest @ ..] = parameters else { return Err(Refusal::WrongFrame) };
    let mut rest = rest;
    let mut variables = Vec::new();
    for _ in 0..count {
        let &[SPECIFICATION, length, ref after @ ..] = rest else { return Err(Refusal::WrongFrame) };
        let (item, after) = after.split_at_checked(usize::from(length)).ok_or(Refusal::WrongFrame)?;
        variables.push(variable(item));
        // One of odd length is filled up, except the last.
        rest = if length % 2 == 1 && !after.is_empty() { &after[1..] } else { after };
    }
    if rest.is_empty() { Ok(variables) } else { Err(Refusal::WrongFrame) }
}

/// The variable that an item names, without its first two bytes.
fn variable(item: &[u8]) -> Result<Variable, ItemCode> {
    // Symbols of newer CPUs, packed data blocks and drives have a syntax of their own.
    let &[SYNTAX_ANY, size, count_high, count_low, db_high, db_low, area, high, middle, low] = item else {
        return Err(if item.first() == Some(&SYNTAX_ANY) { ItemCode::TypeNotSupported } else { ItemCode::NotThere });
    };
    let size = SIZES.iter().find(|row| row.code == size).ok_or(ItemCode::TypeNotSupported)?.size;
    let count = u16::from_be_bytes([count_high, count_low]);
    let address = u32::from_be_bytes([0, high, middle, low]);
    let area = area_of(area, u16::from_be_bytes([db_high, db_low])).ok_or(ItemCode::NotThere)?;
    let has_number = match (area, size) {
        (VariableArea::Timer, TransportSize::Timer) | (VariableArea::Counter, TransportSize::Counter) => true,
        (VariableArea::Timer | VariableArea::Counter, _) | (_, TransportSize::Timer | TransportSize::Counter) => {
            return Err(ItemCode::TypeNotSupported);
        }
        _ => false,
    };
    match size {
        TransportSize::Bit if count != 1 => Err(ItemCode::TypeNotSupported),
        _ if count == 0 => Err(ItemCode::OutOfRange),
        TransportSize::Bit => Ok(Variable { area, size, count, address }),
        _ if !has_number && !address.is_multiple_of(8) => Err(ItemCode::OutOfRange),
        _ => Ok(Variable { area, size, count, address }),
    }
}

/// The area with this code. Local data and the instance of a running block mean nothing outside of the program.
fn area_of(code: u8, db: u16) -> Option<VariableArea> {
    Some(match code {
        0x80 => VariableArea::Peripheral,
        0x81 => VariableArea::Input,
        0x82 => VariableArea::Output,
        0x83 => VariableArea::BitMemory,
        0x84 => VariableArea::DataBlock(db),
        0x1C => VariableArea::Counter,
        0x1D => VariableArea::Timer,
        _ => return None,
    })
}

/// The data of the answer to a read job: each variable with its code, filled up to an even length but for the last.
pub fn values(variables: &[Result<Variable, ItemCode>], values: &[Result<Box<[u8]>, ItemCode>]) -> Vec<u8> {
    let mut out = Vec::new();
    for (index, variable) in variables.iter().enumerate() {
        if out.len() % 2 == 1 {
            out.push(0);
        }
        let value = values.get(index).map_or(Err(ItemCode::HardwareFault), |value| value.as_deref().map_err(|code| *code));
        match variable.and_then(|variable| value.map(|value| (variable, value))) {
            Ok((variable, value)) if value.len() == variable.bytes() => {
                let Row { data_code, counted, .. } = row(variable.size);
                let length = match (variable.size, counted) {
                    (TransportSize::Bit, _) => 1,
                    (_, Counted::InBits) => value.len() * 8,
                    (_, Counted::InBytes) => value.len(),
                };
                // The value fits a PDU.
                let [high, low] = (length as u16).to_be_bytes();
                out.extend_from_slice(&[ItemCode::Done.code(), *data_code, high, low]);
                out.extend_from_slice(value);
            }
            Ok(_) => out.extend_from_slice(&[ItemCode::TypeInconsistent.code(), 0, 0, 0]),
            Err(code) => out.extend_from_slice(&[code.code(), 0, 0, 0]),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn any(size: u8, count: u16, db: u16, area: u8, address: u32) -> Vec<u8> {
        let [count_high, count_low] = count.to_be_bytes();
        let [db_high, db_low] = db.to_be_bytes();
        let [_, high, middle, low] = address.to_be_bytes();
        vec![0x12, 10, 0x10, size, count_high, count_low, db_high, db_low, area, high, middle, low]
    }

    fn read_job(items: &[Vec<u8>]) -> Vec<u8> {
        [vec![READ, items.len() as u8], items.concat()].concat()
    }

    #[test]
    fn sizes_and_areas_that_do_not_go_together_are_refused_one_by_one() {
        let rows = [
            (any(1, 2, 0, 0x83, 0), ItemCode::TypeNotSupported),
            (any(1, 0, 0, 0x83, 0), ItemCode::TypeNotSupported),
            (any(2, 0, 0, 0x83, 0), ItemCode::OutOfRange),
            (any(2, 1, 0, 0x83, 1), ItemCode::OutOfRange),
            (any(4, 1, 0, 0x83, 7), ItemCode::OutOfRange),
            (any(9, 1, 0, 0x83, 0), ItemCode::TypeNotSupported),
            (any(0x0F, 1, 1, 0x84, 0), ItemCode::TypeNotSupported),
            (any(0, 1, 1, 0x84, 0), ItemCode::TypeNotSupported),
            (any(2, 1, 0, 0x1D, 0), ItemCode::TypeNotSupported),
            (any(0x1C, 1, 0, 0x1D, 0), ItemCode::TypeNotSupported),
            (any(0x1D, 1, 0, 0x83, 0), ItemCode::TypeNotSupported),
            (any(2, 1, 1, 0x85, 0), ItemCode::NotThere),
            (any(2, 1, 0, 0x86, 0), ItemCode::NotThere),
            (any(2, 1, 0, 0x00, 0), ItemCode::NotThere),
            (vec![0x12, 4, 0xB0, 1, 2, 3], ItemCode::NotThere),
            (vec![0x12, 0], ItemCode::NotThere),
            (vec![0x12, 2, 0x10, 2], ItemCode::TypeNotSupported),
        ];
        for (item, code) in rows {
            let good = any(2, 1, 0, 0x83, 8);
            let expected = Variable { area: VariableArea::BitMemory, size: TransportSize::Byte, count: 1, address: 8 };
            let found = read_request(&read_job(&[item.clone(), good]), 240);
            assert_eq!(found, Ok(vec![Err(code), Ok(expected)]), "{item:02X?}");
        }
    }

    #[test]
    fn an_item_of_odd_length_is_followed_by_a_fill_byte_but_not_at_the_end() {
        let good = any(2, 1, 0, 0x83, 8);
        let odd = vec![0x12, 3, 0xB2, 0, 0];
        let padded = [odd.clone(), vec![0]].concat();
        assert_eq!(read_request(&read_job(&[padded, good.clone()]), 240).map(|items| items.len()), Ok(2));
        assert_eq!(read_request(&read_job(&[good, odd]), 240).map(|items| items.len()), Ok(2));
    }

    #[test]
    fn an_answer_that_no_pdu_holds_is_refused_before_anything_is_copied() {
        let one = |count| read_request(&read_job(&[any(2, count, 1, 0x84, 0)]), 240);
        assert!(one(222).is_ok());
        assert_eq!(one(223), Err(Refusal::WrongFrame));
        assert_eq!(one(u16::MAX), Err(Refusal::WrongFrame));
        let many: Vec<_> = (0..18).map(|_| any(8, u16::MAX, 1, 0x84, 0)).collect();
        assert_eq!(read_request(&read_job(&many), 240), Err(Refusal::WrongFrame));
        // 12 + 2 and eighteen times 4 + 8 with the fill byte, which the last one does not have.
        let odd: Vec<_> = (0..18).map(|_| any(2, 7, 1, 0x84, 0)).collect();
        assert!(read_request(&read_job(&odd), 230).is_ok());
        assert_eq!(read_request(&read_job(&odd), 228), Err(Refusal::WrongFrame));
    }

    #[test]
    fn a_job_that_does_not_keep_its_promises_is_refused() {
        let item = any(2, 1, 0, 0x83, 8);
        for parameters in [
            vec![],
            vec![READ, 1],
            [vec![READ, 255], item.clone()].concat(),
            [vec![READ, 0], item.clone()].concat(),
            [vec![READ, 1, 0x13], item[1..].to_vec()].concat(),
            [vec![READ, 1], item[..11].to_vec()].concat(),
        ] {
            assert_eq!(read_request(&parameters, 240), Err(Refusal::WrongFrame), "{parameters:02X?}");
        }
        assert_eq!(write_request(&[WRITE, 255, 0x12], &[0, 4, 0, 8, 1]), Err(Refusal::WrongFrame));
        let one = [vec![WRITE, 1], item].concat();
        for data in [&[][..], &[0, 4, 0, 8], &[0, 4, 0, 16, 1], &[0, 4, 0, 8, 1, 0, 0], &[0, 9, 0xFF, 0xFF, 1]] {
            assert_eq!(write_request(&one, data), Err(Refusal::WrongFrame), "{data:02X?}");
        }
        for data in [&[0, 4, 0, 8, 7][..], &[0, 4, 0, 8, 7, 0], &[0, 9, 0, 1, 7]] {
            let bytes = write_request(&one, data).map(|items| items.iter().flatten().flat_map(|item| item.bytes.to_vec()).collect());
            assert_eq!(bytes, Ok(vec![7]), "{data:02X?}");
        }
        assert_eq!(write_request(&one, &[0, 4, 0, 16, 7, 7]), Ok(vec![Err(ItemCode::TypeInconsistent)]));
        assert_eq!(write_request(&one, &[0, 8, 0, 1, 7]), Ok(vec![Err(ItemCode::TypeInconsistent)]));
    }
}
