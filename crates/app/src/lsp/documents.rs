//! The texts that a client has open.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use lsp_types::{Range, TextDocumentContentChangeEvent};
use sieben_lang::encoding::{self, Encoding, MAX_SOURCE_BYTES};

use super::positions::{Columns, Lines};
use super::uri::Place;
use crate::files;

/// An open text.
#[derive(Clone, Debug)]
pub(super) struct Document {
    /// As the client spells it.
    pub(super) uri: String,
    /// What the client calls its language.
    pub(super) language: String,
    /// The number that the client gave this text.
    pub(super) version: i32,
    text: Arc<str>,
    lines: Arc<Lines>,
    /// The client has read a code page as UTF-8, and saving would lose characters.
    pub(super) is_lossy: bool,
    /// The text as the client has it, where it was repaired.
    given: Option<String>,
}

/// The character that stands for bytes that mean nothing.
const LOST: char = '\u{FFFD}';

impl Document {
    fn new(place: &Place, uri: String, language: String, version: i32, text: String, columns: Columns) -> Self {
        let (text, is_lossy, given) = match place.path().and_then(|path| repaired(path, &text, columns)) {
            Some(own) => (own, true, Some(text)),
            None => {
                let is_utf8 = |path: &std::path::Path| files::read_saved(path).is_ok_and(|bytes| str::from_utf8(&bytes).is_ok());
                let is_lossy = text.contains(LOST) && place.path().is_some_and(|path| !is_utf8(path));
                (text, is_lossy, None)
            }
        };
        let lines = Arc::new(Lines::of(&text));
        Self { uri, language, version, text: text.into(), lines, is_lossy, given }
    }

    /// Its text.
    pub(super) fn text(&self) -> &Arc<str> {
        &self.text
    }

    /// Where its lines begin.
    pub(super) fn lines(&self) -> &Arc<Lines> {
        &self.lines
    }

    /// Whether it is larger than any source.
    pub(super) fn is_too_large(&self) -> bool {
        self.text.len() > MAX_SOURCE_BYTES
    }

    /// Takes in changes, one after another.
    fn change(&mut self, version: Option<i32>, changes: &[TextDocumentContentChangeEvent], columns: Columns) {
        self.version = version.unwrap_or(self.version);
        let mut text = changed(&self.text, changes, columns);
        if self.is_lossy {
            // What was repaired has as many units as what the client has: the same changes fit both.
            let given = self.given.take().map_or_else(|| text.clone(), |given| changed(&given, changes, columns));
            self.is_lossy = given.contains(LOST);
            match self.is_lossy {
                true => self.given = Some(given),
                false => text = given,
            }
        }
        self.lines = Arc::new(Lines::of(&text));
        self.text = text.into();
    }
}

/// A text after changes, one after another.
fn changed(text: &str, changes: &[TextDocumentContentChangeEvent], columns: Columns) -> String {
    let mut text = text.to_owned();
    // Clients send many changes from the last one to the first: the lines before a change stay where they are.
    let mut known: Option<(Lines, usize)> = None;
    for change in changes {
        let Some(Range { start, end }) = change.range else {
            text.clone_from(&change.text);
            known = None;
            continue;
        };
        let line = start.line.max(end.line) as usize;
        let kept = known.take().filter(|&(_, first)| line < first);
        let (lines, _) = kept.unwrap_or_else(|| (Lines::of(&text), usize::MAX));
        let (start, end) = (lines.byte(&text, start, columns), lines.byte(&text, end, columns));
        let bytes = start.min(end)..end.max(start);
        let first = lines.line_of(bytes.start);
        text.replace_range(bytes, &change.text);
        known = Some((lines, first));
    }
    text
}

/// The text of a file in a code page that the client has decoded as UTF-8: what it could not decode, as it is in the file. Only where
/// columns are units of UTF-16 it has the places of the client.
fn repaired(path: &std::path::Path, text: &str, columns: Columns) -> Option<String> {
    if columns != Columns::Utf16 || !text.contains(LOST) {
        return None;
    }
    let bytes = files::read_saved(path).ok()?;
    let decoded = encoding::read_source_as(&bytes, None).ok()?;
    if !matches!(decoded.encoding, Encoding::Cp1250 | Encoding::Cp1251 | Encoding::Cp1252) {
        return None;
    }
    let same = |(given, own): (char, char)| given == own || given == LOST && !own.is_ascii();
    let is_same = text.chars().count() == decoded.text.chars().count() && text.chars().zip(decoded.text.chars()).all(same);
    is_same.then_some(decoded.text)
}

/// All open texts, by what they are.
#[derive(Debug, Default)]
pub(super) struct Documents {
    open: BTreeMap<Place, Document>,
}

impl Documents {
    /// Takes in a text.
    pub(super) fn open(&mut self, uri: String, language: String, version: i32, text: String, columns: Columns) -> Place {
        let place = Place::of(&uri);
        self.open.insert(place.clone(), Document::new(&place, uri, language, version, text, columns));
        place
    }

    /// Takes in changes; `None` if the text is not open.
    pub(super) fn change(
        &mut self,
        uri: &str,
        version: Option<i32>,
        changes: Vec<TextDocumentContentChangeEvent>,
        columns: Columns,
    ) -> Option<Place> {
        let place = Place::of(uri);
        self.open.get_mut(&place)?.change(version, &changes, columns);
        Some(place)
    }

    /// Forgets a text; `None` if it was not open.
    pub(super) fn close(&mut self, uri: &str) -> Option<(Place, Document)> {
        self.open.remove_entry(&Place::of(uri))
    }

    /// The text of a place, if it is open.
    pub(super) fn get(&self, place: &Place) -> Option<&Document> {
        self.open.get(place)
    }

    /// All of them.
    pub(super) fn iter(&self) -> impl Iterator<Item = (&Place, &Document)> {
        self.open.iter()
    }

    /// The texts that take the place of files. What is too large for a source is left as it is on the disk.
    pub(super) fn over_files(&self) -> BTreeMap<PathBuf, Arc<str>> {
        let files = self.open.iter().filter(|(_, document)| !document.is_too_large());
        files.filter_map(|(place, document)| Some((place.path()?.to_path_buf(), Arc::clone(document.text())))).collect()
    }
}

#[cfg(test)]
mod tests {
    use lsp_types::Position;

    use super::*;

    fn change(range: Option<[u32; 4]>, text: &str) -> TextDocumentContentChangeEvent {
        let range = range.map(|[line, from, last, to]| Range::new(Position::new(line, from), Position::new(last, to)));
        TextDocumentContentChangeEvent { range, range_length: None, text: text.to_owned() }
    }

    #[test]
    fn changes_apply_one_after_another() {
        let mut documents = Documents::default();
        let uri = "untitled:a".to_owned();
        let place = documents.open(uri.clone(), "awl".to_owned(), 1, "Tür\r\nb".to_owned(), Columns::Utf16);
        let changes = vec![change(Some([0, 1, 0, 2]), "o"), change(Some([0, 3, 1, 1]), "!\n"), change(Some([9, 9, 9, 9]), "end")];
        assert!(documents.change(&uri, Some(7), changes, Columns::Utf16).is_some());
        let document = documents.get(&place).expect("it is open");
        assert_eq!((&**document.text(), document.version), ("Tor!\nend", 7));
        assert_eq!(**document.lines(), Lines::of("Tor!\nend"));
        // From the last line to the first, with lines that come and go.
        let changes = vec![change(Some([1, 0, 1, 1]), "E\n"), change(Some([0, 1, 0, 2]), "a\r"), change(Some([0, 0, 0, 0]), "<")];
        assert!(documents.change(&uri, None, changes, Columns::Utf16).is_some());
        assert_eq!(documents.get(&place).map(|document| document.text().to_string()).as_deref(), Some("<Ta\rr!\nE\nnd"));
        // Backwards, and a whole text.
        let changes = vec![change(Some([2, 1, 1, 0]), ""), change(None, "new"), change(Some([0, 0, 0, 1]), "N")];
        assert!(documents.change(&uri, Some(3), changes, Columns::Utf16).is_some());
        assert_eq!(documents.get(&place).map(|document| document.text().to_string()).as_deref(), Some("New"));
        assert!(documents.change("untitled:b", Some(1), Vec::new(), Columns::Utf16).is_none());
        assert!(documents.close(&uri).is_some() && documents.close(&uri).is_none());
    }
}
