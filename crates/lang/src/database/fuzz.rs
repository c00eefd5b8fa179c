//! Any bytes as sources that change; for fuzzing.

use sieben_model::source::FileId;
use sieben_model::symbols::SymbolTable;

use super::Database;
use crate::options::Options;

/// Endings of the sources, each a language or dialect.
const ENDINGS: [&str; 4] = ["awl", "scl", "st", "exp"];

/// Takes the bytes as two sources and changes one after the other: each time a database has the diagnostics of the whole project compiled from scratch.
pub fn fuzz(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let (first, second) = lines.split_at(lines.len() / 2);
    let options = Options { extended: true, ..Options::default() };
    let mut database = Database::new(SymbolTable::default(), options.clone());
    let ending = |index: usize| ENDINGS[(data.len() + index) % ENDINGS.len()];
    for (index, lines) in [first, second].into_iter().enumerate() {
        database.add(format!("{index}.{}", ending(index)), lines.concat());
    }
    database.diagnostics();
    // Without its middle, with another blank before its end, and as it was.
    for (file, lines) in [(FileId(0), first), (FileId(1), second)] {
        let (begin, rest) = lines.split_at(lines.len() / 3);
        let end = &rest[rest.len() / 2..];
        for text in [[begin.concat(), end.concat()].concat(), [begin.concat(), " ".to_owned(), rest.concat()].concat(), lines.concat()] {
            database.replace(file, text);
            let expected = Database::of(database.sources(), &SymbolTable::default(), &options).into_compiled();
            assert_eq!(database.diagnostics(), expected.diagnostics, "what a change leaves to be said is what the whole says");
        }
    }
}
