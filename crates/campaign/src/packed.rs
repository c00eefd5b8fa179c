//! A campaign as bytes: all that another machine needs to run any scenario of it.

use crate::identity::{Bundle, Identity};

/// A campaign with its programs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Packed {
    /// The file of the campaign.
    pub spec: String,
    /// The seed, which need not be that of the file.
    pub seed: u64,
    /// All files of its programs.
    pub bundle: Bundle,
}

impl Packed {
    /// As bytes.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = format!("sieben campaign 1\n{}\n{}\n{}", self.seed, self.spec.len(), self.spec).into_bytes();
        bytes.extend(self.bundle.bytes());
        bytes
    }

    /// What was written by [`Self::bytes`].
    pub fn read(bytes: &[u8]) -> Option<Self> {
        let rest = std::str::from_utf8(bytes).ok()?.strip_prefix("sieben campaign 1\n")?;
        let (seed, rest) = rest.split_once('\n')?;
        let (length, rest) = rest.split_once('\n')?;
        let (spec, rest) = rest.split_at_checked(length.parse().ok()?)?;
        Some(Self { spec: spec.to_owned(), seed: seed.parse().ok()?, bundle: Bundle::read(rest.as_bytes())? })
    }

    /// What identifies it.
    pub fn identity(&self) -> Identity {
        self.bundle.identity(&self.spec, self.seed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_read_as_it_was_written() {
        let mut bundle = Bundle::default();
        bundle.add("./main.awl", "A I 0.0;\n");
        let packed = Packed { spec: "# Prüfung\n".to_owned(), seed: 7, bundle };
        assert_eq!(Packed::read(&packed.bytes()), Some(packed.clone()));
        assert_eq!(Packed::read(b"sieben campaign 1\n7\n99999999\n"), None);
        assert_eq!(Packed::read(&packed.bytes()[..30]), None);
    }
}
