//! Group 5 of userdata: entering and clearing the password of a connection.

use super::codes::Refusal;

/// What a client asks for; the session answers, and no CPU is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PasswordRequest {
    /// It enters a password of eight characters, filled up with spaces.
    Enter([u8; 8]),
    /// It takes the password back.
    Clear,
}

/// What hides the characters of a password.
const MASK: u8 = 0x55;

/// What a request means; `data` are the bytes after `FF 09` and the length, none if the request has no data.
///
/// # Errors
/// Why it is refused.
pub fn read(subfunction: u8, data: &[u8]) -> Result<PasswordRequest, Refusal> {
    match subfunction {
        1 => data.try_into().map(|hidden| PasswordRequest::Enter(reveal(hidden))).map_err(|_| Refusal::PasswordSyntax),
        2 => Ok(PasswordRequest::Clear),
        _ => Err(Refusal::NotImplemented),
    }
}

/// The characters of a hidden password: each is mixed with a constant and, from the third on, with the hidden one two places before.
fn reveal(hidden: [u8; 8]) -> [u8; 8] {
    std::array::from_fn(|at| hidden[at] ^ MASK ^ if at < 2 { 0 } else { hidden[at - 2] })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As clients hide a password.
    fn hide(password: [u8; 8]) -> [u8; 8] {
        let mut hidden = [0; 8];
        for at in 0..8 {
            hidden[at] = password[at] ^ MASK ^ if at < 2 { 0 } else { hidden[at - 2] };
        }
        hidden
    }

    #[test]
    fn a_password_is_read_as_it_was_hidden() {
        // `AB` and six spaces: 41⊕55, 42⊕55, then 20⊕55⊕ the one two places before.
        let hidden = [0x14, 0x17, 0x61, 0x62, 0x14, 0x17, 0x61, 0x62];
        assert_eq!(read(1, &hidden), Ok(PasswordRequest::Enter(*b"AB      ")));
        for password in [*b"SECRET1 ", *b"        ", *b"12345678", [0xFF; 8]] {
            assert_eq!(read(1, &hide(password)), Ok(PasswordRequest::Enter(password)));
        }
    }

    #[test]
    fn a_password_has_eight_characters() {
        for data in [&[0; 7][..], &[0; 9], &[]] {
            assert_eq!(read(1, data), Err(Refusal::PasswordSyntax));
        }
        assert_eq!(read(2, &[]), Ok(PasswordRequest::Clear));
        assert_eq!(read(3, &[0; 8]), Err(Refusal::NotImplemented));
    }
}
