//! The table of languages, and which one a source is written in.

mod content;
pub mod role;

use sieben_model::diagnostic::Diagnostic;
use sieben_model::mnemonics::Mnemonics;

use crate::codesys_files;
use crate::network::flavour::Drawing;
use crate::st::dialect::Dialect;
use crate::{st, stl};

/// The language of a source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// Statement list.
    Stl,
    /// Statement list whose networks are diagrams unless they say something else.
    Diagram(Drawing),
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
    pub convert: fn(&str, Language, Option<Mnemonics>, Mnemonics) -> Rewritten,
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
        convert: |text, language, from, to| stl::convert::convert_as(text, from, to, language.drawing()),
    },
    Row {
        endings: &[ending("lad", Language::Diagram(Drawing::Lad), true), ending("fbd", Language::Diagram(Drawing::Fbd), true)],
        format: |text, language, mnemonics| stl::format::format_as(text, mnemonics, language.drawing()),
        convert: |text, language, from, to| stl::convert::convert_as(text, from, to, language.drawing()),
    },
    Row {
        endings: &[
            ending("st", Language::St(Dialect::Iec), true),
            ending("iecst", Language::St(Dialect::Iec), true),
            ending("scl", Language::St(Dialect::Scl), true),
            ending("exp", Language::St(Dialect::Codesys), false),
            ending("tcpou", Language::St(Dialect::Codesys), true),
            ending("tcdut", Language::St(Dialect::Codesys), true),
            ending("tcgvl", Language::St(Dialect::Codesys), true),
            ending("tcio", Language::St(Dialect::Codesys), true),
            ending("udt", Language::St(Dialect::Scl), false),
            ending("db", Language::St(Dialect::Scl), false),
        ],
        format: |text, language, _| st::format(text, language.dialect().unwrap_or_default()),
        convert: |text, _, _, _| Ok(text.to_owned()),
    },
];

/// The row of an ending; a source with another one is read as STL.
fn found(ending: &str) -> Option<&'static Ending> {
    LANGUAGES.iter().flat_map(|row| row.endings).find(|known| known.ending.eq_ignore_ascii_case(ending))
}

/// Lines that a source whose name says another language has to have of its own language, and none of the other one.
const LINES_AGAINST_NAME: usize = 2;

/// What is told of a source whose content is not what its name says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Contradiction {
    /// The first bytes that show it, from and to.
    pub place: (usize, usize),
    /// What it is.
    pub is: &'static str,
    /// What its name says.
    pub named: &'static str,
}

/// What a source is by its name alone; `None` if its ending is unknown.
fn by_name(name: &str) -> Option<Language> {
    let ending = name.rsplit(['/', '\\']).next().and_then(|file| file.rsplit_once('.')).map_or("", |(_, ending)| ending);
    found(ending).map(|known| known.language)
}

/// Whether the content of a source is without doubt another language than its name says: it is read as what it is.
pub fn contradiction(name: &str, text: &str) -> Option<Contradiction> {
    let named = by_name(name)?;
    // One line of the language that the name says settles it, in most sources the first.
    let found = match named {
        Language::Stl => {
            let lines = content::lines_until(text, |lines| lines.stl > 0);
            (lines.stl == 0 && lines.st >= LINES_AGAINST_NAME).then_some((lines.first_st?, "Structured Text", "STL"))
        }
        Language::St(_) => {
            let lines = content::lines_until(text, |lines| lines.st > 0);
            (lines.st == 0 && lines.stl >= LINES_AGAINST_NAME).then_some((lines.first_stl?, "STL", "Structured Text"))
        }
        Language::Diagram(_) => None,
    };
    let (place, is, named) = found?;
    (!role::is_test(name, text) && codesys_files::kind(name, text).is_none()).then_some(Contradiction { place, is, named })
}

impl Language {
    /// The language of a source by the ending of its name and by its content; `dialect` is what the user chose.
    pub fn of(name: &str, text: &str, dialect: Option<Dialect>) -> Self {
        let st = |usual: Dialect| dialect.unwrap_or_else(|| content::shown(text, usual));
        // Tests are written in ST, whatever their file is called.
        if role::is_test(name, text) {
            let usual = by_name(name).and_then(Self::dialect).unwrap_or_default();
            return Self::St(st(usual).for_tests());
        }
        if codesys_files::kind(name, text).is_some() {
            return Self::St(dialect.unwrap_or(Dialect::Codesys));
        }
        match (by_name(name), contradiction(name, text)) {
            (Some(Self::Diagram(drawing)), _) => Self::Diagram(drawing),
            (Some(Self::Stl), None) | (Some(Self::St(_)), Some(_)) => Self::Stl,
            (Some(Self::St(usual)), None) => Self::St(st(usual)),
            (Some(Self::Stl), Some(_)) => Self::St(st(content::usual(text))),
            // The content of a file with another ending says what it is.
            (None, _) => {
                let lines = content::lines(text);
                if lines.st > lines.stl { Self::St(st(content::usual(text))) } else { Self::Stl }
            }
        }
    }

    /// Its row in the table.
    pub fn row(self) -> &'static Row {
        let is_of = |row: &&Row| {
            row.endings
                .iter()
                .any(|one| one.language.drawing() == self.drawing() && one.language.dialect().is_some() == self.dialect().is_some())
        };
        LANGUAGES.iter().find(is_of).expect("every language has a row")
    }

    /// Whether a source in it is a test file.
    pub fn is_of_tests(self) -> bool {
        self.dialect().is_some_and(Dialect::is_test)
    }

    /// The dialect of a source of ST.
    pub fn dialect(self) -> Option<Dialect> {
        match self {
            Self::Stl | Self::Diagram(_) => None,
            Self::St(dialect) => Some(dialect),
        }
    }

    /// How the networks of a source are drawn that do not say it themselves.
    pub fn drawing(self) -> Option<Drawing> {
        match self {
            Self::Diagram(drawing) => Some(drawing),
            Self::Stl | Self::St(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_of_nothing_but_signs_is_judged_at_once() {
        for part in ["SHL(a,", "CV => a,", "a, ", "a : ", "(* ", "#", "'", "U(\n", "x := 1;\n", "CTU(RESET", "\"TYPE ", "TYPE \""] {
            let text = part.repeat((1 << 18) / part.len());
            for name in ["a.st", "a.txt"] {
                let _ = Language::of(name, &text, None);
            }
        }
    }

    #[test]
    fn the_ending_and_the_text_tell_the_dialect() {
        let st = Language::St;
        for (name, text, dialect, expected) in [
            ("a.awl", "x := 1;", None, Language::Stl),
            ("noending", "U E 0.0\n= A 4.0", Some(Dialect::Scl), Language::Stl),
            ("noending", "x := 1;", Some(Dialect::Scl), st(Dialect::Scl)),
            ("a.txt", "FUNCTION F : INT\nF := 1;\nEND_FUNCTION", None, st(Dialect::Iec)),
            ("a.txt", "FUNCTION FC1 : INT\nBEGIN\nFC1 := 1;\nEND_FUNCTION", None, st(Dialect::Scl)),
            ("a.txt", "FUNCTION \"F\" : Int\nBEGIN\n#F := 1;\nEND_FUNCTION", None, st(Dialect::Tia)),
            (
                "a.txt",
                "FUNCTION FC 1 : VOID\nVAR_INPUT\nx : INT;\nEND_VAR\nBEGIN\nCALL FC 2 (\na := 1);\nM1: L #x;\nEND_FUNCTION",
                None,
                Language::Stl,
            ),
            ("a.udt", "TYPE \"T\"\nVERSION : 0.1\nSTRUCT\na : Int;\nEND_STRUCT;\nEND_TYPE", None, st(Dialect::Tia)),
            ("a.awl", "FUNCTION FC1 : INT\nBEGIN\nIF x THEN\nFC1 := 1;\nEND_IF;\nEND_FUNCTION", None, st(Dialect::Scl)),
            ("a.st", "FUNCTION FC 1 : VOID\nBEGIN\nU E 0.0;\n= A 4.0;\nEND_FUNCTION", None, Language::Stl),
            ("a.st", "FUNCTION_BLOCK F\nCU(a);\nCD(b);\nEND_FUNCTION_BLOCK", None, st(Dialect::Iec)),
            ("a.st", "FUNCTION FC 1 : VOID\nBEGIN\nU(;\nO E 0.1;\n);\n= A 4.0;\nEND_FUNCTION", None, Language::Stl),
            ("a.scl", "(* U E 0.0\n= A 4.0 *) x := 1;", None, st(Dialect::Scl)),
            ("a.st", "PROGRAM PLC_PRG\nEND_PROGRAM", None, st(Dialect::Codesys)),
            ("a.st", "VAR c : CTU; END_VAR c(CU := x, RESET:=y);", None, st(Dialect::Codesys)),
            ("a.st", "VAR c : CTU; reset : BOOL; END_VAR reset := TRUE; c(CU := x, R := reset);", None, st(Dialect::Iec)),
            ("a.st", "VAR n : INT; END_VAR VAR n : DWORD; END_VAR n := SHR(n, 3);", None, st(Dialect::Iec)),
            ("a.st", "VAR c : CTU; n, m : WORD; END_VAR c(CU := x, CV => n);", None, st(Dialect::Codesys)),
            ("a.st", "VAR c : CTU; n, m : INT; END_VAR c(CU := x, CV => n);", None, st(Dialect::Iec)),
            ("a.st", "VAR n : DINT; END_VAR n := SHR(n, 3);", None, st(Dialect::Codesys)),
            ("a.st", "VAR n : DWORD; END_VAR n := SHR(n, 3);", None, st(Dialect::Iec)),
            ("a.st", "FUNCTION_BLOCK \"Motor\"", None, st(Dialect::Tia)),
            ("a.st", "#n := INT#3;", None, st(Dialect::Tia)),
            ("a.st", "c := Color#Red; d := 16#FF;", None, st(Dialect::Iec)),
            ("a.TcPOU", "<TcPlcObject/>", None, st(Dialect::Codesys)),
            ("a.txt", "(* @NESTEDCOMMENTS := 'Yes' *)", None, st(Dialect::Codesys)),
            ("dir.st/a.stl", "", None, Language::Stl),
            ("a.ST", "x := 1;", None, st(Dialect::Iec)),
            ("a.st", "VAR p : POINTER TO INT; END_VAR", None, st(Dialect::Codesys)),
            ("a.st", "(* POINTER TO *) x := 'POINTER TO'; // POINTER TO", None, st(Dialect::Iec)),
            ("a.scl", "FUNCTION FC1 : VOID x := W#16#FF; d := \"Data\".x;", None, st(Dialect::Scl)),
            ("a.scl", "#x := 1;", None, st(Dialect::Tia)),
            ("a.scl", "FUNCTION_BLOCK \"Motor\"", None, st(Dialect::Tia)),
            ("a.scl", "TYPE\n  \"Motor\"\n", None, st(Dialect::Tia)),
            ("a.scl", "VAR\t  CONSTANT", None, st(Dialect::Tia)),
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
