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
}

/// The character that stands for bytes that mean nothing.
const LOST: char = '\u{FFFD}';

impl Document {
    fn new(place: &Place, uri: String, language: String, version: i32, text: String, columns: Columns) -> Self {
        let (text, is_lossy) = match place.path().and_then(|path| repaired(path, &text, columns)) {
            Some(text) => (text, true),
            None => {
                let is_lossy = text.contains(LOST) && place.path().is_some();
                (text, is_lossy)
            }
        };
        let lines = Arc::new(Lines::of(&text));
        Self { uri, language, version, text: text.into(), lines, is_lossy }
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
    fn change(&mut self, version: i32, changes: Vec<TextDocumentContentChangeEvent>, columns: Columns) {
        self.version = version;
        let mut text = String::from(&*self.text);
        let mut lines = None;
        for change in changes {
            match change.range {
                None => text = change.text,
                Some(Range { start, end }) => {
                    let known = lines.get_or_insert_with(|| Lines::of(&text));
                    let (start, end) = (known.byte(&text, start, columns), known.byte(&text, end, columns));
                    text.replace_range(start.min(end)..end.max(start), &change.text);
                }
            }
            lines = None;
        }
        self.lines = Arc::new(lines.unwrap_or_else(|| Lines::of(&text)));
        self.text = text.into();
    }
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
        version: i32,
        changes: Vec<TextDocumentContentChangeEvent>,
        columns: Columns,
    ) -> Option<Place> {
        let place = Place::of(uri);
        self.open.get_mut(&place)?.change(version, changes, columns);
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
        assert!(documents.change(&uri, 7, changes, Columns::Utf16).is_some());
        let document = documents.get(&place).expect("it is open");
        assert_eq!((&**document.text(), document.version), ("Tor!\nend", 7));
        assert_eq!(**document.lines(), Lines::of("Tor!\nend"));
        // Backwards, and a whole text.
        let changes = vec![change(Some([1, 3, 1, 0]), ""), change(None, "new"), change(Some([0, 0, 0, 1]), "N")];
        assert!(documents.change(&uri, 3, changes, Columns::Utf16).is_some());
        assert_eq!(documents.get(&place).map(|document| document.text().to_string()).as_deref(), Some("New"));
        assert!(documents.change("untitled:b", 1, Vec::new(), Columns::Utf16).is_none());
        assert!(documents.close(&uri).is_some() && documents.close(&uri).is_none());
    }
}
