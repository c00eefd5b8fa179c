//! A zip file of a few files: stored as they are, with no time, so that the same files always give the same bytes.

use std::fmt::Write as _;

/// A file in it.
pub(super) struct Entry {
    /// Its path, with `/`.
    pub(super) path: String,
    /// What is in it.
    pub(super) bytes: Vec<u8>,
    /// Whether it is a program.
    pub(super) program: bool,
}

/// 1 January 1980, the first day that a zip file knows.
const FIRST_DAY: u16 = (1 << 5) | 1;
/// Paths are UTF-8.
const UTF8: u16 = 1 << 11;
/// Made on a system with the modes of Unix, so that a program stays one.
const UNIX: u16 = 3 << 8 | 20;

/// The bytes of the file; an error if it would be too large for a zip file.
pub(super) fn zip(entries: &[Entry]) -> Result<Vec<u8>, String> {
    let mut out = Vec::new();
    let mut directory = Vec::new();
    for entry in entries {
        let offset = size(out.len())?;
        let length = size(entry.bytes.len())?;
        let name = u16::try_from(entry.path.len()).map_err(|_| format!("{}: the path is too long", entry.path))?;
        let mut common = Vec::new();
        // Version, flags, method 0 (stored), time and day; checksum and both lengths; lengths of the name and of further fields.
        for word in [20, UTF8, 0, 0, FIRST_DAY] {
            common.extend(u16::to_le_bytes(word));
        }
        for word in [crc32fast::hash(&entry.bytes), length, length] {
            common.extend(word.to_le_bytes());
        }
        common.extend(name.to_le_bytes());
        common.extend(0_u16.to_le_bytes());
        out.extend(b"PK\x03\x04");
        out.extend(&common);
        out.extend(entry.path.as_bytes());
        out.extend(&entry.bytes);
        let mode: u32 = if entry.program { 0o100_755 } else { 0o100_644 };
        directory.extend(b"PK\x01\x02");
        directory.extend(UNIX.to_le_bytes());
        directory.extend(&common);
        // No comment, disk 0, no text; the mode; where it begins.
        directory.extend([0; 6]);
        directory.extend((mode << 16).to_le_bytes());
        directory.extend(offset.to_le_bytes());
        directory.extend(entry.path.as_bytes());
    }
    let count = u16::try_from(entries.len()).map_err(|_| "a zip file has at most 65,535 files".to_owned())?;
    let (begin, length) = (size(out.len())?, size(directory.len())?);
    out.append(&mut directory);
    out.extend(b"PK\x05\x06");
    out.extend([0; 4]);
    out.extend(count.to_le_bytes());
    out.extend(count.to_le_bytes());
    out.extend(length.to_le_bytes());
    out.extend(begin.to_le_bytes());
    out.extend([0; 2]);
    Ok(out)
}

fn size(bytes: usize) -> Result<u32, String> {
    u32::try_from(bytes).map_err(|_| "a zip file has at most 4 GiB".to_owned())
}

/// Text that may stand in an attribute or element of XML.
pub(super) fn xml(text: &str) -> String {
    let mut out = String::new();
    for character in text.chars() {
        match character {
            '&' | '<' | '>' | '"' | '\'' => {
                let _ = write!(out, "&#{};", u32::from(character));
            }
            character => out.push(character),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_zip_file_says_what_is_in_it_and_where() {
        let entry = |path: &str, text: &str, program| Entry { path: path.to_owned(), bytes: text.as_bytes().to_vec(), program };
        let bytes = zip(&[entry("a.txt", "123456789", false), entry("bin/ä", "", true)]).expect("it is small");
        // The checksum of these digits is known.
        assert_eq!(bytes[14..18], 0xCBF4_3926_u32.to_le_bytes());
        assert_eq!(&bytes[30..44], b"a.txt123456789");
        let end = bytes.len() - 22;
        assert_eq!(&bytes[end..end + 4], b"PK\x05\x06");
        assert_eq!(bytes[end + 10], 2);
        let directory = u32::from_le_bytes(bytes[end + 16..end + 20].try_into().expect("four bytes")) as usize;
        assert_eq!(&bytes[directory..directory + 4], b"PK\x01\x02");
        assert_eq!(xml("a & \"b\""), "a &#38; &#34;b&#34;");
    }
}
