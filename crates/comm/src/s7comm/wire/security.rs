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

/// What a request means; `data` are the bytes after `FF 09` and the length, none if the request has no data.
///
/// # Errors
/// Why it is refused.
pub fn read(subfunction: u8, data: &[u8]) -> Result<PasswordRequest, Refusal> {
    let _ = (subfunction, data);
    Err(Refusal::NotImplemented)
}
