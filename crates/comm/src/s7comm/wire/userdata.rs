//! The envelope of userdata: groups, subfunctions and answers in fragments.

use super::More;
use super::codes::Refusal;
use super::header::{self, Kind, Message};

/// What parameters begin with.
const HEAD: [u8; 3] = [0, 1, 0x12];
/// The method of a request; clients set the bits of the type as they like.
const REQUEST: u8 = 0x11;
/// The method of an answer, and of a request for the next fragment.
const ANSWER: u8 = 0x12;
/// Bytes of the parameters after the length byte: those of a first request, and of an answer.
const SHORT: u8 = 4;
const LONG: u8 = 8;
/// The bits of the type that mean an answer.
const ANSWER_TYPE: u8 = 0x80;
/// Bytes that come before those of a fragment: the header, the parameters of an answer, and the head of its data.
pub const FRAGMENT_HEAD: usize = header::HEAD + 12 + DATA_HEAD;
/// Bytes before the data: code, type, length.
const DATA_HEAD: usize = 4;
/// Data without anything: what requests and answers have that say all in their parameters.
const NO_DATA: [u8; DATA_HEAD] = [0x0A, 0, 0, 0];

/// Groups of functions.
pub mod group {
    /// Test and installation: variable status, force, block status.
    pub const TEST: u8 = 1;
    /// Cyclic data.
    pub const CYCLIC: u8 = 2;
    /// Blocks.
    pub const BLOCKS: u8 = 3;
    /// System status lists and messages.
    pub const CPU: u8 = 4;
    /// Passwords.
    pub const SECURITY: u8 = 5;
    /// Clock.
    pub const CLOCK: u8 = 7;
}

/// The data of an answer.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Content {
    /// Its bytes after `FF 09` and the length; none for an answer without data (`0A 00 00 00`).
    pub bytes: Vec<u8>,
    /// An answer that is longer than the PDU is cut at multiples of so many bytes; 0 or 1 for anywhere.
    pub grain: usize,
}

impl Content {
    /// An answer without data.
    pub fn none() -> Self {
        Self::default()
    }
}

/// What a request says of itself, which its answer repeats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Address {
    /// The group, without the bits of the type.
    pub group: u8,
    /// The subfunction.
    pub subfunction: u8,
    /// The sequence number: 0 in most first requests, that of the answer in a request for its next fragment.
    pub sequence: u8,
}

/// A request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Request<'a> {
    /// What it asks for.
    pub address: Address,
    /// Whether it may ask for the next fragment of an answer, which the long form with a sequence number does.
    pub form: Form,
    /// The bytes after `FF 09` and the length.
    pub data: Result<&'a [u8], Refusal>,
}

/// The form of a request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A request of its own.
    First,
    /// It asks for the next fragment.
    Next,
}

/// Reads a request.
///
/// # Errors
/// It is none.
pub fn read<'a>(message: &Message<'a>) -> Result<Request<'a>, Refusal> {
    let (&HEAD, parameters) = message.parameters.split_first_chunk().ok_or(Refusal::WrongFrame)? else {
        return Err(Refusal::NotImplemented);
    };
    let &[length, method, group, subfunction, sequence, ref rest @ ..] = parameters else { return Err(Refusal::WrongFrame) };
    let form = match (length, method, rest.len()) {
        (SHORT, REQUEST, 0) => Form::First,
        (LONG, REQUEST | ANSWER, 4) if sequence != 0 => Form::Next,
        (LONG, REQUEST, 4) => Form::First,
        (SHORT | LONG, REQUEST | ANSWER, _) => return Err(Refusal::WrongFrame),
        _ => return Err(Refusal::NotImplemented),
    };
    Ok(Request { address: Address { group: group & 0x3F, subfunction, sequence }, form, data: data(message.data) })
}

/// The bytes of the data of a request.
fn data(data: &[u8]) -> Result<&[u8], Refusal> {
    match data {
        [] => Ok(&[]),
        &[code, _, high, low, ref rest @ ..] => {
            let length = usize::from(u16::from_be_bytes([high, low]));
            let fills = rest.len() == length || rest.len() == length + 1 && length % 2 == 1;
            match code {
                0xFF if fills => Ok(&rest[..length]),
                0x0A if length == 0 && rest.is_empty() => Ok(&[]),
                _ => Err(Refusal::WrongFrame),
            }
        }
        _ => Err(Refusal::WrongFrame),
    }
}

/// Where a fragment stands in its answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Place {
    /// A number that all fragments of an answer share; 0 for an answer in one piece.
    pub unit: u8,
    /// Whether more follow.
    pub more: More,
}

/// An answer, or a fragment of one; without bytes it has no data.
pub fn answer(reference: u16, address: Address, place: Place, bytes: &[u8]) -> Vec<u8> {
    let mut data = Vec::with_capacity(DATA_HEAD + bytes.len());
    if bytes.is_empty() {
        data.extend_from_slice(&NO_DATA);
    } else {
        data.extend_from_slice(&[0xFF, 9]);
        // A fragment fits a PDU.
        data.extend_from_slice(&(bytes.len() as u16).to_be_bytes());
        data.extend_from_slice(bytes);
    }
    message(reference, address, place, 0, &data)
}

/// An answer that refuses.
pub fn refuse(reference: u16, address: Address, refusal: Refusal) -> Vec<u8> {
    message(reference, address, Place::default(), refusal.code(), &NO_DATA)
}

fn message(reference: u16, address: Address, place: Place, error: u16, data: &[u8]) -> Vec<u8> {
    let Address { group, subfunction, sequence } = address;
    let [error_high, error_low] = error.to_be_bytes();
    let more = u8::from(place.more == More::Follow);
    let [a, b, c] = HEAD;
    let parameters = [a, b, c, LONG, ANSWER, ANSWER_TYPE | group, subfunction, sequence, place.unit, more, error_high, error_low];
    header::write(&Message { kind: Kind::Userdata, reference, error: 0, parameters: &parameters, data })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn request<'a>(parameters: &'a [u8], data: &'a [u8]) -> Result<Request<'a>, Refusal> {
        read(&Message { kind: Kind::Userdata, reference: 1, error: 0, parameters, data })
    }

    #[test]
    fn a_request_is_known_by_its_method() {
        for group in [0x44, 0x04, 0x84] {
            let address = Address { group: 4, subfunction: 1, sequence: 1 };
            let parameters = [0, 1, 0x12, 4, 0x11, group, 1, 1];
            let found = request(&parameters, &[0xFF, 9, 0, 4, 0, 0x11, 0, 0]);
            assert_eq!(found, Ok(Request { address, form: Form::First, data: Ok(&[0, 0x11, 0, 0]) }));
        }
    }

    #[test]
    fn the_long_form_asks_for_the_next_fragment_if_it_has_a_sequence_number() {
        let form =
            |method, sequence| request(&[0, 1, 0x12, 8, method, 0x44, 1, sequence, 0, 0, 0, 0], &[10, 0, 0, 0]).map(|request| request.form);
        assert_eq!(form(0x12, 3), Ok(Form::Next));
        assert_eq!(form(0x11, 3), Ok(Form::Next));
        assert_eq!(form(0x11, 0), Ok(Form::First));
        assert_eq!(form(0x12, 0), Err(Refusal::WrongFrame));
    }

    #[test]
    fn a_request_keeps_within_its_lengths() {
        let short = [0, 1, 0x12, 4, 0x11, 0x44, 1, 0];
        for length in 0..short.len() {
            assert!(request(&short[..length], &[]).is_err(), "{length}");
        }
        for data in [&[0xFF][..], &[0xFF, 9, 0, 4, 1], &[0xFF, 9, 0, 1, 1, 2, 3], &[10, 0, 0, 1], &[1, 9, 0, 1, 1]] {
            assert_eq!(request(&short, data).map(|request| request.data), Ok(Err(Refusal::WrongFrame)), "{data:02X?}");
        }
        assert_eq!(request(&[0, 1, 0x12, 6, 0x13, 0, 1, 0], &[]), Err(Refusal::NotImplemented));
    }
}
