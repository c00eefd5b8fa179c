//! What identifies a campaign: its programs, its file, its seed, and what the same code means in this version.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde_json::Value as Json;
use sha2::{Digest, Sha256};

/// Rises with every change of what a program does or what a number of a scenario means: results of another one are not those of this one.
pub const MEANING: u32 = 2;

/// All files of the programs of a campaign, by names that do not say where the folder lies.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Bundle {
    files: BTreeMap<String, String>,
}

/// What identifies a campaign; hashes are in hexadecimal digits.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Identity {
    /// SHA-256 of the bundle.
    pub program: String,
    /// SHA-256 of the file of the campaign.
    pub spec: String,
    /// The seed.
    pub seed: u64,
    /// SHA-256 of the bundle, the file of the campaign, the seed and [`MEANING`].
    pub campaign: String,
}

impl Bundle {
    /// Takes a file in; its line ends become `\n`.
    pub fn add(&mut self, name: impl Into<String>, text: &str) {
        self.files.insert(name.into(), normal(text));
    }

    /// All files in the order of their names, uncompressed.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = b"sieben bundle 1\n".to_vec();
        for (name, text) in &self.files {
            bytes.extend(format!("{}\n{}\n", Json::from(name.as_str()), text.len()).as_bytes());
            bytes.extend(text.as_bytes());
        }
        bytes
    }

    /// What was written by [`Self::bytes`].
    pub fn read(bytes: &[u8]) -> Option<Self> {
        let mut rest = std::str::from_utf8(bytes).ok()?.strip_prefix("sieben bundle 1\n")?;
        let mut files = BTreeMap::new();
        while !rest.is_empty() {
            let (name, after) = rest.split_once('\n')?;
            let (length, after) = after.split_once('\n')?;
            let name = serde_json::from_str(name).ok()?;
            let (text, after) = after.split_at_checked(length.parse().ok()?)?;
            files.insert(name, text.to_owned());
            rest = after;
        }
        Some(Self { files })
    }

    /// The files with their names, in order.
    pub fn files(&self) -> impl Iterator<Item = (&str, &str)> {
        self.files.iter().map(|(name, text)| (name.as_str(), text.as_str()))
    }

    /// What identifies a campaign with these programs.
    pub fn identity(&self, spec: &str, seed: u64) -> Identity {
        let program = Sha256::digest(self.bytes());
        let mut all = Sha256::new();
        all.update(program);
        all.update(normal(spec));
        all.update(seed.to_be_bytes());
        all.update(MEANING.to_be_bytes());
        Identity { program: hex(&program), spec: of_text(spec), seed, campaign: hex(&all.finalize()) }
    }
}

/// What identifies a file of a campaign: SHA-256 of its text, whatever its line ends are.
pub fn of_text(text: &str) -> String {
    hex(&Sha256::digest(normal(text)))
}

fn normal(text: &str) -> String {
    text.trim_start_matches('\u{FEFF}').replace("\r\n", "\n")
}

/// Bytes as hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        // Writing to a string cannot fail.
        let _ = write!(text, "{byte:02x}");
        text
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_depends_on_what_is_said_and_on_nothing_else() {
        let bundle = |text: &str| {
            let mut bundle = Bundle::default();
            bundle.add("b.awl", text);
            bundle.add("a.toml", "");
            bundle
        };
        let identity = bundle("A I 0.0;\n").identity("seed = 1\n", 1);
        assert_eq!(identity, bundle("\u{FEFF}A I 0.0;\r\n").identity("seed = 1\r\n", 1));
        assert_eq!((identity.program.len(), identity.campaign.len()), (64, 64));
        let others = [
            bundle("A I 0.1;\n").identity("seed = 1\n", 1),
            bundle("A I 0.0;\n").identity("", 1),
            bundle("A I 0.0;\n").identity("seed = 1\n", 2),
        ];
        assert!(others.iter().all(|other| other.campaign != identity.campaign));
        assert_eq!(others[1].program, identity.program);
        let whole = bundle("// Größe\n");
        assert_eq!(Bundle::read(&whole.bytes()), Some(whole.clone()));
        let bytes = whole.bytes();
        for cut in 0..bytes.len() {
            // A file at the end may be left out whole; nothing else can be cut off.
            assert_ne!(Bundle::read(&bytes[..cut]), Some(whole.clone()));
        }
    }
}
