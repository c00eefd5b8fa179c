//! Files of CODESYS and TwinCAT that hold Structured Text among other things: the XML of TwinCAT, and exports of CoDeSys 2.3.
//!
//! What is read of one is a text in which everything but Structured Text is a space: each place in it is the same place in the file.

mod export;
mod twincat;

use std::ops::Range;

use sieben_model::diagnostic::Diagnostic;
use sieben_model::source::FileId;

pub(crate) use export::ends_in_comment;

/// Endings of the files of TwinCAT, in lower case: blocks, types, global variables, interfaces.
pub const TWINCAT_ENDINGS: [&str; 4] = ["tcpou", "tcdut", "tcgvl", "tcio"];
/// Bytes of a file that are looked at for the first element of TwinCAT.
const HEAD: usize = 4096;

/// What a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// XML of TwinCAT.
    TwinCat,
    /// An export of CoDeSys 2.3.
    Export,
}

/// The Structured Text of a file.
#[derive(Clone, Debug)]
pub struct Read {
    /// Each byte of it lies where it lies in the file; the end of the last block may lie behind the file.
    pub text: String,
    /// What of the file is not read.
    pub diagnostics: Vec<Diagnostic>,
}

/// What a file is by its name and its text; `None` if it is a source like any other.
pub fn kind(name: &str, text: &str) -> Option<Kind> {
    let is_xml = text.trim_start().starts_with('<');
    let by_name = name.rsplit_once('.').is_some_and(|(_, ending)| TWINCAT_ENDINGS.iter().any(|known| known.eq_ignore_ascii_case(ending)));
    let head = text.as_bytes().get(..HEAD.min(text.len())).unwrap_or_default();
    if is_xml && (by_name || String::from_utf8_lossy(head).contains("<TcPlcObject")) {
        return Some(Kind::TwinCat);
    }
    export::is_export(text).then_some(Kind::Export)
}

/// The Structured Text of such a file; `None` if it is a source like any other.
pub fn read(file: FileId, name: &str, text: &str) -> Option<Read> {
    Some(match kind(name, text)? {
        Kind::TwinCat => twincat::read(file, text),
        Kind::Export => export::read(file, text),
    })
}

/// A text of spaces as long as a file, into which what is read is put.
struct View {
    bytes: Vec<u8>,
}

impl View {
    fn blank(text: &str) -> Self {
        Self { bytes: text.bytes().map(|byte| if matches!(byte, b'\n' | b'\r') { byte } else { b' ' }).collect() }
    }

    /// Takes over a part of the file.
    fn keep(&mut self, text: &str, range: Range<usize>) {
        self.bytes[range.clone()].copy_from_slice(&text.as_bytes()[range]);
    }

    /// Writes a word into the first room for it in a range, with a space before it; where it ends, if there is room.
    fn write(&mut self, range: Range<usize>, word: &str) -> Option<usize> {
        let wanted = word.len() + 1;
        let mut run = 0;
        for at in range {
            run = if matches!(self.bytes[at], b'\n' | b'\r') { 0 } else { run + 1 };
            if run == wanted {
                self.bytes[at + 1 - word.len()..=at].copy_from_slice(word.as_bytes());
                return Some(at + 1);
            }
        }
        None
    }

    /// Writes a line behind everything.
    fn append(&mut self, word: &str) {
        self.bytes.push(b'\n');
        self.bytes.extend(word.as_bytes());
        self.bytes.push(b'\n');
    }

    fn finish(self) -> String {
        String::from_utf8_lossy(&self.bytes).into_owned()
    }
}

/// Survives any bytes: what is read lies where it lies in the file.
pub fn fuzz(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    for name in ["fuzz.TcPOU", "fuzz.exp"] {
        let Some(read) = read(FileId::default(), name, &text) else { continue };
        assert!(read.text.len() >= text.len(), "nothing is cut off");
        for diagnostic in &read.diagnostics {
            assert!(text.get(diagnostic.span.start as usize..diagnostic.span.end as usize).is_some(), "the place lies in the file");
        }
    }
}

#[cfg(test)]
mod tests;
