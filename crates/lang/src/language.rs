//! The table of languages, and which one a source is written in.

pub mod role;

use sieben_model::diagnostic::Diagnostic;
use sieben_model::mnemonics::Mnemonics;

use crate::st::dialect::Dialect;
use crate::{st, stl};

/// The language of a source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// Statement list.
    Stl,
    /// Structured text or SCL.
    St(Dialect),
}

/// The new text, or why there is none.
pub type Rewritten = Result<String, Vec<Diagnostic>>;

/// A language as people meet it: what its files are called, and what is done with one of them alone.
///
/// What is done with a whole project, to parse, declare, check and lower, stands in [`crate::database`], each step in its file.
pub struct Row {
    /// Endings of its files, in lower case.
    pub endings: &'static [Ending],
    /// The text of a source in the usual layout.
    pub format: fn(&str, Language, Option<Mnemonics>) -> Rewritten,
    /// The text of a source in the other mnemonic language: from one, if it is known, to another. What has no mnemonics stays as it is.
    pub convert: fn(&str, Option<Mnemonics>, Mnemonics) -> Rewritten,
}

/// An ending of files.
pub struct Ending {
    /// Without its dot.
    pub ending: &'static str,
    /// The language, with the dialect that it has unless the text or the project says otherwise.
    language: Language,
    /// Whether such files are sources where a folder is searched, or only where they are named.
    pub in_folders: bool,
}

const fn ending(ending: &'static str, language: Language, in_folders: bool) -> Ending {
    Ending { ending, language, in_folders }
}

/// All languages.
pub const LANGUAGES: &[Row] = &[
    Row {
        endings: &[ending("awl", Language::Stl, true), ending("stl", Language::Stl, true)],
        format: |text, _, mnemonics| stl::format(text, mnemonics),
        convert: stl::convert::convert,
    },
    Row {
        endings: &[
            ending("st", Language::St(Dialect::Iec), true),
            ending("iecst", Language::St(Dialect::Iec), true),
            ending("scl", Language::St(Dialect::Scl), true),
            ending("exp", Language::St(Dialect::Codesys), false),
        ],
        format: |text, language, _| st::format(text, language.dialect().unwrap_or_default()),
        convert: |text, _, _| Ok(text.to_owned()),
    },
];

/// The row of an ending; a source with another one is read as STL.
fn found(ending: &str) -> Option<&'static Ending> {
    LANGUAGES.iter().flat_map(|row| row.endings).find(|known| known.ending.eq_ignore_ascii_case(ending))
}

/// Words that only one dialect writes, in upper case, each with the dialect that it shows for a file of another one.
const MARKS: &[(&str, Dialect, Dialect)] = &[
    ("S7_OPTIMIZED_ACCESS", Dialect::Scl, Dialect::Tia),
    ("END_REGION", Dialect::Scl, Dialect::Tia),
    ("INSTRUCTIONNAME", Dialect::Scl, Dialect::Tia),
    ("VAR CONSTANT", Dialect::Scl, Dialect::Tia),
    ("VAR RETAIN", Dialect::Scl, Dialect::Tia),
    ("END_UNION", Dialect::Iec, Dialect::Codesys),
    ("POINTER TO", Dialect::Iec, Dialect::Codesys),
    ("REFERENCE TO", Dialect::Iec, Dialect::Codesys),
    ("VAR_STAT", Dialect::Iec, Dialect::Codesys),
    ("END_PROPERTY", Dialect::Iec, Dialect::Codesys),
    ("{ATTRIBUTE", Dialect::Iec, Dialect::Codesys),
    ("AND_THEN", Dialect::Iec, Dialect::Codesys),
    ("OR_ELSE", Dialect::Iec, Dialect::Codesys),
    ("PERSISTENT", Dialect::Iec, Dialect::Codesys),
    ("__NEW", Dialect::Iec, Dialect::Codesys),
    ("__TRY", Dialect::Iec, Dialect::Codesys),
];

/// Bytes of a source that are looked at to find its dialect.
const LOOKED_AT: usize = 1 << 20;

impl Language {
    /// The language of a source by the ending of its name and what its text shows; `dialect` is what the user chose.
    pub fn of(name: &str, text: &str, dialect: Option<Dialect>) -> Self {
        let ending = name.rsplit(['/', '\\']).next().and_then(|file| file.rsplit_once('.')).map_or("", |(_, ending)| ending);
        let of_ending = found(ending).map_or(Self::Stl, |known| known.language);
        match of_ending {
            // Tests are written in ST, whatever their file is called.
            _ if role::is_test(name, text) => {
                let usual = of_ending.dialect().unwrap_or_default();
                Self::St(dialect.unwrap_or_else(|| shown(text, usual)).for_tests())
            }
            Self::Stl => Self::Stl,
            Self::St(usual) => Self::St(dialect.unwrap_or_else(|| shown(text, usual))),
        }
    }

    /// Its row in the table.
    pub fn row(self) -> &'static Row {
        let is_of =
            |row: &&Row| row.endings.iter().any(|one| matches!((one.language, self), (Self::Stl, Self::Stl) | (Self::St(_), Self::St(_))));
        LANGUAGES.iter().find(is_of).expect("every language has a row")
    }

    /// Whether a source in it is a test file.
    pub fn is_of_tests(self) -> bool {
        self.dialect().is_some_and(Dialect::is_test)
    }

    /// The dialect of a source of ST.
    pub fn dialect(self) -> Option<Dialect> {
        match self {
            Self::Stl => None,
            Self::St(dialect) => Some(dialect),
        }
    }
}

/// The dialect that a text shows, if it shows another one than the usual.
fn shown(text: &str, usual: Dialect) -> Dialect {
    let end = (0..=text.len().min(LOOKED_AT)).rev().find(|&end| text.is_char_boundary(end)).unwrap_or(0);
    let code = without_comments(&text[..end]).to_ascii_uppercase();
    if usual == Dialect::Scl && quotes_locals(&code) {
        return Dialect::Tia;
    }
    MARKS.iter().find(|&&(mark, of, _)| of == usual && code.contains(mark)).map_or(usual, |&(_, _, dialect)| dialect)
}

/// Whether `#name` stands there, or a block whose name is quoted: TIA writes them.
fn quotes_locals(code: &str) -> bool {
    let local = code.match_indices('#').any(|(at, _)| {
        let before = code[..at].chars().next_back();
        let behind = code[at + 1..].chars().next();
        !before.is_some_and(|c| c.is_alphanumeric() || c == '_') && behind.is_some_and(|c| c.is_alphabetic() || c == '_' || c == '"')
    });
    let quoted = ["FUNCTION_BLOCK \"", "FUNCTION \"", "ORGANIZATION_BLOCK \"", "DATA_BLOCK \"", "TYPE \""].iter();
    local || quoted.into_iter().any(|header| code.contains(header))
}

/// The text without comments and without what stands between apostrophes.
fn without_comments(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let skipped = if rest.starts_with("(*") {
            rest.find("*)").map_or(rest.len(), |end| end + 2)
        } else if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if c == '\'' {
            let line = rest.find('\n').unwrap_or(rest.len());
            rest[1..line.max(1)].find('\'').map_or(line.max(1), |end| end + 2)
        } else {
            out.push(c);
            rest = &rest[c.len_utf8()..];
            continue;
        };
        out.push(' ');
        rest = &rest[skipped.min(rest.len())..];
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ending_and_the_text_tell_the_dialect() {
        let st = Language::St;
        for (name, text, dialect, expected) in [
            ("a.awl", "x := 1;", None, Language::Stl),
            ("noending", "x := 1;", Some(Dialect::Scl), Language::Stl),
            ("dir.st/a.stl", "", None, Language::Stl),
            ("a.ST", "x := 1;", None, st(Dialect::Iec)),
            ("a.st", "VAR p : POINTER TO INT; END_VAR", None, st(Dialect::Codesys)),
            ("a.st", "(* POINTER TO *) x := 'POINTER TO'; // POINTER TO", None, st(Dialect::Iec)),
            ("a.scl", "FUNCTION FC1 : VOID x := W#16#FF; d := \"Data\".x;", None, st(Dialect::Scl)),
            ("a.scl", "#x := 1;", None, st(Dialect::Tia)),
            ("a.scl", "FUNCTION_BLOCK \"Motor\"", None, st(Dialect::Tia)),
            ("a.scl", "#x := 1;", Some(Dialect::Scl), st(Dialect::Scl)),
            ("a.exp", "", None, st(Dialect::Codesys)),
            ("a.Test.ST", "", None, st(Dialect::IecTest)),
            ("a.test.st", "", Some(Dialect::Scl), st(Dialect::SclTest)),
            ("a.txt", "TEST 'it runs'\nEND_TEST\n", None, st(Dialect::IecTest)),
            ("a.st", "'", None, st(Dialect::Iec)),
            ("a.st", "'ä", None, st(Dialect::Iec)),
        ] {
            assert_eq!(Language::of(name, text, dialect), expected, "{name}: {text}");
        }
    }
}
