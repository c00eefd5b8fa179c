//! Jobs 1A to 1F: blocks that are downloaded, where the CPU asks for the pieces, and uploaded, where the client does.

use super::More;
use super::codes::Refusal;
use super::header::{self, Kind, Message};
use super::names;
use crate::s7comm::job::BlockName;

/// Function codes.
pub mod function {
    /// A client wants to download a block.
    pub const REQUEST_DOWNLOAD: u8 = 0x1A;
    /// The CPU asks for the next piece.
    pub const DOWNLOAD: u8 = 0x1B;
    /// The CPU has all of it.
    pub const DOWNLOAD_ENDED: u8 = 0x1C;
    /// A client wants to upload a block.
    pub const START_UPLOAD: u8 = 0x1D;
    /// The client asks for the next piece.
    pub const UPLOAD: u8 = 0x1E;
    /// The client has all of it.
    pub const END_UPLOAD: u8 = 0x1F;
}

/// Bytes of a piece before its content: length, 0, 16#FB.
const PIECE_HEAD: usize = 4;
/// Bytes that a message with a piece has besides its content: header, parameters, head of the piece.
pub const PIECE_OVERHEAD: usize = header::ANSWER_HEAD + 2 + PIECE_HEAD;
/// What comes before the content of a piece, after its length.
const PIECE_MARK: [u8; 2] = [0x00, 0xFB];
/// More pieces follow.
const MORE: u8 = 1;
/// The sender has met an error.
const ERROR: u8 = 2;

/// What a client announces before a download.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Announced {
    /// The block.
    pub name: BlockName,
    /// Bytes of load memory: the whole image.
    pub load_bytes: u32,
    /// Bytes of its MC7 code or of its values.
    pub code_bytes: u32,
}

/// The name of a file: `_`, the name of the block.
fn file_name(characters: &[u8]) -> Result<BlockName, Refusal> {
    match characters.split_first() {
        Some((b'_', name)) => names::read(name),
        _ => Err(Refusal::BlockNameSyntax),
    }
}

/// Job 1A.
///
/// # Errors
/// Why it is refused.
pub fn read_request_download(parameters: &[u8]) -> Result<Announced, Refusal> {
    let rest = parameters.get(8..).ok_or(Refusal::WrongFrame)?;
    let (&length, rest) = rest.split_first().ok_or(Refusal::WrongFrame)?;
    let (name, rest) = rest.split_at_checked(usize::from(length)).ok_or(Refusal::WrongFrame)?;
    let &[length, b'1', ref digits @ ..] = rest else { return Err(Refusal::BlockParameterSyntax) };
    if length != 13 || digits.len() != 12 {
        return Err(Refusal::BlockParameterSyntax);
    }
    let (load, code) = digits.split_at(6);
    let number = |digits: &[u8]| names::decimal(digits).ok_or(Refusal::BlockParameterSyntax);
    Ok(Announced { name: file_name(name)?, load_bytes: number(load)?, code_bytes: number(code)? })
}

/// Job 1D.
///
/// # Errors
/// Why it is refused.
pub fn read_start_upload(parameters: &[u8]) -> Result<BlockName, Refusal> {
    let rest = parameters.get(8..).ok_or(Refusal::WrongFrame)?;
    let (&length, name) = rest.split_first().ok_or(Refusal::WrongFrame)?;
    if name.len() == usize::from(length) { file_name(name) } else { Err(Refusal::WrongFrame) }
}

/// The parameters of the answer to job 1D: clients read the ID from its last byte.
pub fn start_upload_answer(id: u8, length: usize) -> Vec<u8> {
    let mut parameters = vec![function::START_UPLOAD, 0, 1, 0, 0, 0, 0, id, 7];
    parameters.extend_from_slice(format!("{length:07}").as_bytes());
    parameters
}

/// The ID in the parameters of jobs 1E and 1F.
///
/// # Errors
/// Why it is refused.
pub fn read_upload_id(parameters: &[u8]) -> Result<u8, Refusal> {
    match *parameters {
        [_, _, _, _, 0, 0, 0, id] => Ok(id),
        [_, _, _, _, _, _, _, _] => Err(Refusal::WrongSequence),
        _ => Err(Refusal::WrongFrame),
    }
}

/// The answer to job 1E.
pub fn upload_answer(reference: u16, content: &[u8], more: More) -> Vec<u8> {
    let mut data = Vec::with_capacity(PIECE_HEAD + content.len());
    // A piece fits a PDU.
    data.extend_from_slice(&(content.len() as u16).to_be_bytes());
    data.extend_from_slice(&PIECE_MARK);
    data.extend_from_slice(content);
    header::answer(reference, &[function::UPLOAD, if more == More::Follow { MORE } else { 0 }], &data)
}

/// A job 1B or 1C of the CPU.
pub fn own_job(reference: u16, code: u8, error: Option<Refusal>, name: BlockName) -> Vec<u8> {
    let [high, low] = error.map_or(0, Refusal::code).to_be_bytes();
    let mut parameters = vec![code, if error.is_some() { ERROR } else { 0 }, high, low, 0, 0, 0, 0, 9, b'_'];
    parameters.extend_from_slice(&names::write(name));
    header::write(&Message { kind: Kind::Job, reference, error: 0, parameters: &parameters, data: &[] })
}

/// The content of the answer of a client to job 1B, and whether more follows.
///
/// # Errors
/// It is none, or the client has met an error: the download ends.
pub fn read_piece<'a>(message: &Message<'a>) -> Result<(&'a [u8], More), Refusal> {
    let &[function::DOWNLOAD, status] = message.parameters else { return Err(Refusal::WrongSequence) };
    if message.error != 0 || status & ERROR != 0 {
        return Err(Refusal::WrongSequence);
    }
    let (&[high, low, _, _], content) = message.data.split_first_chunk().ok_or(Refusal::WrongFrame)?;
    let length = usize::from(u16::from_be_bytes([high, low]));
    match content.get(..length) {
        Some(content) if !content.is_empty() => Ok((content, if status & MORE == 0 { More::None } else { More::Follow })),
        _ => Err(Refusal::WrongFrame),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::s7comm::job::{BlockPlace, BlockType};

    const DB_12: BlockName = BlockName { block_type: BlockType::DataBlock, number: 12, place: BlockPlace::Passive };

    #[test]
    fn a_download_says_what_comes() {
        let parameters = [&[0x1A, 0, 1, 0, 0, 0, 0, 0, 9][..], b"_0A00012P", &[13], b"1000120000044"].concat();
        assert_eq!(read_request_download(&parameters), Ok(Announced { name: DB_12, load_bytes: 120, code_bytes: 44 }));
        for length in 0..parameters.len() {
            assert!(read_request_download(&parameters[..length]).is_err(), "{length}");
        }
    }

    #[test]
    fn an_upload_is_named_by_its_id() {
        assert_eq!(start_upload_answer(7, 120), b"\x1D\x00\x01\x00\x00\x00\x00\x07\x070000120");
        assert_eq!(read_upload_id(&[0x1E, 0, 0, 0, 0, 0, 0, 7]), Ok(7));
        assert_eq!(read_upload_id(&[0x1E, 0, 0, 0, 0, 0, 1, 7]), Err(Refusal::WrongSequence));
        assert_eq!(read_upload_id(&[0x1E, 0, 0, 0, 0, 0, 1]), Err(Refusal::WrongFrame));
    }

    #[test]
    fn the_cpu_asks_for_pieces_by_name() {
        let job = own_job(0x0300, function::DOWNLOAD, None, DB_12);
        assert_eq!(job, b"\x32\x01\x00\x00\x03\x00\x00\x12\x00\x00\x1B\x00\x00\x00\x00\x00\x00\x00\x09_0A00012P");
        let message = |parameters, data| Message { kind: Kind::AckData, reference: 0x300, error: 0, parameters, data };
        assert_eq!(read_piece(&message(&[0x1B, 1], &[0, 2, 0, 0xFB, 5, 6])), Ok((&[5, 6][..], More::Follow)));
        assert_eq!(read_piece(&message(&[0x1B, 0], &[0, 2, 0, 0xFB, 5])), Err(Refusal::WrongFrame));
        assert_eq!(read_piece(&message(&[0x1B, 3], &[0, 2, 0, 0xFB, 5, 6])), Err(Refusal::WrongSequence));
    }
}
