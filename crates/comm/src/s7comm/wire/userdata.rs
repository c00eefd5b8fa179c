//! The envelope of userdata: groups, subfunctions and answers in fragments.

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
