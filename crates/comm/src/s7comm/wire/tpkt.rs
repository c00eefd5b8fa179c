//! TPKT (RFC 1006): frames in a stream of bytes.

use super::Broken;

/// Bytes of the head of a frame: version 3, a reserved byte, the length of all of it.
pub const HEAD: usize = 4;
/// Version of the protocol.
const VERSION: u8 = 3;
/// The shortest frame: its head and the head of a TPDU.
const BYTES_MIN: usize = 7;

/// The first frame of a stream, without its head, and how many bytes it has with it; `None` while it is not complete.
///
/// # Errors
/// These bytes are no frame, whatever follows.
pub fn split(stream: &[u8]) -> Result<Option<(&[u8], usize)>, Broken> {
    match stream {
        [] => Ok(None),
        [version, ..] if *version != VERSION => Err(Broken),
        [_, _, high, low, ..] => {
            let length = usize::from(u16::from_be_bytes([*high, *low]));
            if length < BYTES_MIN {
                return Err(Broken);
            }
            Ok(stream.get(HEAD..length).map(|tpdu| (tpdu, length)))
        }
        _ => Ok(None),
    }
}

/// Puts a frame around a TPDU that `write` appends.
pub fn frame(out: &mut Vec<u8>, write: impl FnOnce(&mut Vec<u8>)) {
    let start = out.len();
    out.extend_from_slice(&[VERSION, 0, 0, 0]);
    write(out);
    let length = u16::try_from(out.len() - start).expect("a TPDU that is sent has at most 1,024 bytes");
    if let Some(place) = out.get_mut(start + 2..start + HEAD) {
        place.copy_from_slice(&length.to_be_bytes());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frame_is_taken_when_it_is_complete() {
        let stream = [3, 0, 0, 7, 2, 0xF0, 0x80, 3];
        for length in 0..7 {
            assert_eq!(split(&stream[..length]), Ok(None));
        }
        assert_eq!(split(&stream), Ok(Some((&stream[4..7], 7))));
    }

    #[test]
    fn what_is_no_frame_is_known_at_once() {
        assert_eq!(split(b"G"), Err(Broken));
        assert_eq!(split(&[3, 0, 0, 6]), Err(Broken));
        assert_eq!(split(&[3, 0, 0, 0, 0]), Err(Broken));
    }
}
