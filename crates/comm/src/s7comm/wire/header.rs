//! The header of S7: what kind of message it is, its reference, and where parameters and data begin.

use super::Broken;
use super::codes::Refusal;

/// The protocol ID.
const PROTOCOL: u8 = 0x32;
/// Bytes of the header of a request.
pub const HEAD: usize = 10;
/// Bytes of the header of an answer, which has an error class and code.
pub const ANSWER_HEAD: usize = 12;

/// The kind of a message (ROSCTR).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// 1, Job: a request.
    Job,
    /// 2, Ack: an answer without parameters and data.
    Ack,
    /// 3, Ack_Data: an answer.
    AckData,
    /// 7, Userdata: requests and answers of the second kind.
    Userdata,
}

/// The kinds with their numbers.
const KINDS: &[(Kind, u8)] = &[(Kind::Job, 1), (Kind::Ack, 2), (Kind::AckData, 3), (Kind::Userdata, 7)];

/// A message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Message<'a> {
    /// Its kind.
    pub kind: Kind,
    /// The reference that an answer repeats.
    pub reference: u16,
    /// Error class and code of an answer; 0 in a request.
    pub error: u16,
    /// The parameters.
    pub parameters: &'a [u8],
    /// The data.
    pub data: &'a [u8],
}

/// A message that is answered, but whose parts cannot be told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Misfit {
    /// Its reference.
    pub reference: u16,
    /// Why.
    pub refusal: Refusal,
}

/// Reads a message.
///
/// # Errors
/// It is no message of this protocol at all, or an answer with wrong lengths: the connection is closed. If it is one, but of an unknown kind or with wrong lengths, the inner
/// error is what it is answered with.
pub fn read(bytes: &[u8]) -> Result<Result<Message<'_>, Misfit>, Broken> {
    let &[PROTOCOL, kind, _, _, reference_high, reference_low, parameters_high, parameters_low, data_high, data_low, ref rest @ ..] = bytes
    else {
        return Err(Broken);
    };
    let reference = u16::from_be_bytes([reference_high, reference_low]);
    let misfit = |refusal| Ok(Err(Misfit { reference, refusal }));
    let Some(&(kind, _)) = KINDS.iter().find(|row| row.1 == kind) else { return misfit(Refusal::NotImplemented) };
    let (error, rest) = match (kind, rest) {
        (Kind::Job | Kind::Userdata, rest) => (0, rest),
        (_, [class, code, rest @ ..]) => (u16::from_be_bytes([*class, *code]), rest),
        _ => return Err(Broken),
    };
    let parameter_bytes = usize::from(u16::from_be_bytes([parameters_high, parameters_low]));
    let data_bytes = usize::from(u16::from_be_bytes([data_high, data_low]));
    match rest.split_at_checked(parameter_bytes) {
        Some((parameters, data)) if data.len() == data_bytes => Ok(Ok(Message { kind, reference, error, parameters, data })),
        // An answer is not answered.
        _ if matches!(kind, Kind::Ack | Kind::AckData) => Err(Broken),
        _ => misfit(Refusal::WrongFrame),
    }
}

/// Writes a message; the error is sent with answers only.
pub fn write(message: &Message<'_>) -> Vec<u8> {
    let Message { kind, reference, error, parameters, data } = message;
    let mut out = Vec::with_capacity(ANSWER_HEAD + parameters.len() + data.len());
    let number = KINDS.iter().find(|row| row.0 == *kind).map_or(0, |row| row.1);
    out.extend_from_slice(&[PROTOCOL, number, 0, 0]);
    out.extend_from_slice(&reference.to_be_bytes());
    // Both are bounded by the PDU that was agreed on.
    out.extend_from_slice(&(parameters.len() as u16).to_be_bytes());
    out.extend_from_slice(&(data.len() as u16).to_be_bytes());
    if matches!(kind, Kind::Ack | Kind::AckData) {
        out.extend_from_slice(&error.to_be_bytes());
    }
    out.extend_from_slice(parameters);
    out.extend_from_slice(data);
    out
}

/// An answer that refuses a job.
pub fn refuse(reference: u16, refusal: Refusal) -> Vec<u8> {
    write(&Message { kind: Kind::Ack, reference, error: refusal.code(), parameters: &[], data: &[] })
}

/// An answer to a job.
pub fn answer(reference: u16, parameters: &[u8], data: &[u8]) -> Vec<u8> {
    write(&Message { kind: Kind::AckData, reference, error: 0, parameters, data })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_is_written_as_it_was_read() {
        let messages = [
            Message { kind: Kind::Job, reference: 0x0501, error: 0, parameters: &[4, 0], data: &[] },
            Message { kind: Kind::Ack, reference: 1, error: 0x8104, parameters: &[], data: &[] },
            Message { kind: Kind::AckData, reference: 0xFFFF, error: 0, parameters: &[4, 1], data: &[0xFF, 3, 0, 1, 1] },
            Message { kind: Kind::Userdata, reference: 7, error: 0, parameters: &[0, 1, 0x12], data: &[10, 0, 0, 0] },
        ];
        for message in messages {
            assert_eq!(read(&write(&message)), Ok(Ok(message)));
        }
    }

    #[test]
    fn wrong_lengths_and_kinds_are_answered_and_other_protocols_are_not() {
        let misfit = |reference, refusal| Ok(Err(Misfit { reference, refusal }));
        assert_eq!(read(&[0x32, 1, 0, 0, 0, 5, 0, 2, 0, 0, 4]), misfit(5, Refusal::WrongFrame));
        assert_eq!(read(&[0x32, 1, 0, 0, 0, 5, 0, 1, 0, 0, 4, 0]), misfit(5, Refusal::WrongFrame));
        assert_eq!(read(&[0x32, 9, 0, 0, 0, 6, 0, 0, 0, 0]), misfit(6, Refusal::NotImplemented));
        assert_eq!(read(&[0x72, 1, 0, 0, 0, 5, 0, 0, 0, 0]), Err(Broken));
        assert_eq!(read(&[0x32, 3, 0, 0, 0, 5, 0, 0, 0, 0, 0]), Err(Broken));
        assert_eq!(read(&[0x32, 3, 0, 0, 0, 5, 0, 1, 0, 0, 0, 0]), Err(Broken));
        assert_eq!(read(&[0x32, 1]), Err(Broken));
    }
}
