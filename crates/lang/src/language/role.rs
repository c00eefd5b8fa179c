//! What a source is for among others in a folder: it holds tests, is a program, or has blocks for programs.

use sieben_model::block::BlockKind;
use sieben_model::source::FileId;

use super::Language;
use crate::codesys_files;
use crate::st::ast::{self, Item};
use crate::st::{declare::usual_organization_block, dialect::Dialect};
use crate::stl::ast::BlockName;
use crate::{st, stl};

/// The ending of the name of a test file.
const TEST_ENDING: &str = ".test.st";
/// What a name has before its ending, or at its beginning, where a file that is a test by its text says what it tests.
const TEST_AFFIXES: [(&str, &str); 3] = [("", ".test"), ("", "_test"), ("test_", "")];

/// What a source brings along.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Role {
    /// It makes OB 1: an organization block with this number, or statements outside any block.
    pub cycle: bool,
    /// Organization blocks with names that only a symbol table gives a number.
    pub named: Vec<String>,
    /// The names of its PROGRAMs, in lower case.
    pub programs: Vec<String>,
}

/// Whether a source is a test file: by its name, or by its text, whatever its name is.
pub fn is_test(name: &str, text: &str) -> bool {
    is_test_name(name) || holds_tests(text)
}

/// Whether a file is a test file by the ending of its name alone.
pub fn is_test_name(name: &str) -> bool {
    let start = name.len().saturating_sub(TEST_ENDING.len());
    name.get(start..).is_some_and(|ending| ending.eq_ignore_ascii_case(TEST_ENDING))
}

/// The name, without endings, of what a test file of this name tests: `pump` for `pump.test.st`, `pump_test.st` and `test_pump.st`.
pub fn tested(file_name: &str) -> &str {
    let stem = file_name.rsplit_once('.').map_or(file_name, |(stem, _)| stem);
    let lower = stem.to_ascii_lowercase();
    let found =
        TEST_AFFIXES.iter().find(|(begin, end)| lower.starts_with(begin) && lower.ends_with(end) && stem.len() > begin.len() + end.len());
    found.map_or(stem, |(begin, end)| &stem[begin.len()..stem.len() - end.len()])
}

/// Whether the text has a test: `TEST 'name'` at the beginning of a line, or SETUP or TEARDOWN at its own.
pub fn holds_tests(text: &str) -> bool {
    let text = text.trim_start_matches('\u{FEFF}');
    let mut words = Words { rest: text, line_begins: true };
    let mut first = true;
    while let Some((word, after)) = words.next_of_line() {
        let after = after.trim_start_matches([' ', '\t']);
        match word.to_ascii_uppercase().as_str() {
            "TEST" if after.starts_with(['\'', '"']) => return true,
            // `setup: A I 0.0` and `Setup := 1;` are neither.
            part @ ("SETUP" | "TEARDOWN") if first && !after.starts_with([':', '.', '(', '[', ',']) => {
                return has_word(after, &format!("END_{part}"));
            }
            _ => first = false,
        }
    }
    false
}

/// Whether a word stands in the text, in any case.
fn has_word(text: &str, word: &str) -> bool {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_')).any(|found| found.eq_ignore_ascii_case(word))
}

/// The first words of lines, without comments.
struct Words<'a> {
    rest: &'a str,
    line_begins: bool,
}

impl<'a> Words<'a> {
    /// The next word that begins a line, with what follows it; an empty word where something else begins the line.
    fn next_of_line(&mut self) -> Option<(&'a str, &'a str)> {
        while let Some(c) = self.rest.chars().next() {
            let skipped = if self.rest.starts_with("(*") {
                self.rest.find("*)").map_or(self.rest.len(), |end| end + 2)
            } else if self.rest.starts_with("//") {
                self.rest.find('\n').unwrap_or(self.rest.len())
            } else if c.is_whitespace() {
                self.line_begins |= c == '\n' || c == '\r';
                c.len_utf8()
            } else if c == '\'' || c == '"' {
                self.line_begins = false;
                // To the next such quote, or to the end of the line where there is none.
                let end = self.rest[1..].find([c, '\n']).map_or(self.rest.len(), |end| end + 1);
                end + usize::from(self.rest[end..].starts_with(c))
            } else if self.line_begins {
                self.line_begins = false;
                let end = self.rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(self.rest.len());
                let (word, after) = self.rest.split_at(end);
                self.rest = if end == 0 { &after[c.len_utf8()..] } else { after };
                return Some((word, after));
            } else {
                c.len_utf8()
            };
            self.rest = self.rest.get(skipped..).unwrap_or_default();
        }
        None
    }
}

impl Role {
    /// The role of a source; `dialect` is what the user chose for ST.
    pub fn of(name: &str, text: &str, dialect: Option<Dialect>) -> Self {
        match Language::of(name, text, dialect) {
            language @ (Language::Stl | Language::Diagram(_)) => Self::of_stl(text, language),
            Language::St(dialect) => match codesys_files::read(FileId(0), name, text) {
                Some(read) => Self::of_st(&read.text, dialect),
                None => Self::of_st(text, dialect),
            },
        }
    }

    fn of_stl(text: &str, language: Language) -> Self {
        let mut role = Self::default();
        let blocks = stl::parser::parse_as(FileId(0), text, None, language.drawing()).file.blocks;
        for block in &blocks {
            match &block.name {
                _ if block.kind != BlockKind::OrganizationBlock => {}
                // What is not understood between blocks makes no program of them.
                _ if block.implicit => role.cycle |= !block.statements.is_empty() || blocks.len() == 1,
                BlockName::Absolute { number, .. } => role.cycle |= *number == 1,
                BlockName::Symbol(word) => role.name(&word.text, None),
            }
        }
        role
    }

    fn of_st(text: &str, dialect: Dialect) -> Self {
        let mut role = Self::default();
        role.take(&st::parser::parse(FileId(0), text, dialect).file.items);
        role
    }

    fn take(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Namespace(namespace) => self.take(&namespace.items),
                Item::Block(block) => match block.kind {
                    ast::BlockKind::Program => self.programs.push(block.name.text.to_lowercase()),
                    ast::BlockKind::Implicit => self.cycle |= !block.body.is_empty() || items.len() == 1,
                    ast::BlockKind::OrganizationBlock => self.name(&block.name.text, usual_organization_block(&block.name.text)),
                    _ => {}
                },
                _ => {}
            }
        }
    }

    /// An organization block with this name, and the number that it is known to mean.
    fn name(&mut self, name: &str, known: Option<u16>) {
        match known {
            Some(number) => self.cycle |= number == 1,
            None => self.named.push(name.to_owned()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_test_file_is_known_by_its_name_or_its_text() {
        for (name, text, expected) in [
            ("a.test.st", "", true),
            ("a.Test.ST", "x := 1;", true),
            ("test_a.st", "PROGRAM p\nEND_PROGRAM\n", false),
            ("a.st", "\u{FEFF}// why\n(* how\n *)\n  test 'it runs'\nEND_TEST\n", true),
            ("a.txt", "TEST \"it runs\"\nEND_TEST\n", true),
            ("a.st", "SETUP\n  x := 1;\nEND_SETUP\n", true),
            ("a.st", "TEARDOWN // what\nEND_TEARDOWN\n", true),
            ("a.st", "FUNCTION_BLOCK B\nEND_FUNCTION_BLOCK\nTEST 'b'\nEND_TEST\n", true),
            ("a.st", "TEST := TRUE;\n", false),
            ("a.st", "Test(IN := x);\n", false),
            ("a.awl", "SETUP: A I 0.0\n= Q 0.0\n", false),
            ("a.awl", "SETUP: A I 0.0\n// END_SETUP\n", false),
            ("a.st", "setup.x := 1;\n(* END_SETUP *)\n", false),
            ("a.st", "x := 'a\nTEST b';\n", false),
            ("a.st", "x := 1; TEST 'no line of its own'\n", false),
            ("a.st", "(* TEST 'a'", false),
            ("a.st", "'", false),
            ("a.st", "ä 'ö", false),
            ("", "", false),
        ] {
            assert_eq!(is_test(name, text), expected, "{name}: {text}");
        }
    }

    #[test]
    fn the_name_of_a_test_file_says_what_it_tests() {
        for (name, expected) in [
            ("pump.test.st", "pump"),
            ("Pump_Test.st", "Pump"),
            ("test_pump.st", "pump"),
            ("pump.scenario", "pump"),
            ("test_.st", "test_"),
            ("test.st", "test"),
            ("ue1.v2.test.st", "ue1.v2"),
            ("pump", "pump"),
        ] {
            assert_eq!(tested(name), expected, "{name}");
        }
    }

    #[test]
    fn a_source_makes_the_cycle_a_program_or_blocks() {
        let cycle = || Role { cycle: true, ..Role::default() };
        let named = |name: &str| Role { named: vec![name.to_owned()], ..Role::default() };
        let programs = |names: &[&str]| Role { programs: names.iter().map(|&name| name.to_owned()).collect(), ..Role::default() };
        for (name, text, expected) in [
            ("a.awl", "A I 0.0\n= Q 0.0\n", cycle()),
            ("a.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK\n", cycle()),
            ("a.awl", "ORGANIZATION_BLOCK OB 100\nBEGIN\nEND_ORGANIZATION_BLOCK\n", Role::default()),
            ("a.awl", "ORGANIZATION_BLOCK \"Cycle\"\nBEGIN\nEND_ORGANIZATION_BLOCK\n", named("Cycle")),
            ("a.awl", "FUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\n", Role::default()),
            ("a.awl", "DATA_BLOCK DB 1\nSTRUCT\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n", Role::default()),
            ("a.awl", "// nothing\n", Role::default()),
            ("a.awl", "nonsense\n", cycle()),
            ("a.awl", "FUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\nnonsense\n", Role::default()),
            ("a.scl", "ORGANIZATION_BLOCK OB1\nBEGIN\nEND_ORGANIZATION_BLOCK\n", cycle()),
            ("a.scl", "ORGANIZATION_BLOCK \"Main\"\nBEGIN\nEND_ORGANIZATION_BLOCK\n", cycle()),
            ("a.scl", "ORGANIZATION_BLOCK OB35\nBEGIN\nEND_ORGANIZATION_BLOCK\n", Role::default()),
            ("a.st", "VAR x : INT; END_VAR\nx := x + 1;\n", cycle()),
            ("a.st", "PROGRAM Main\nEND_PROGRAM\nPROGRAM b\nEND_PROGRAM\n", programs(&["main", "b"])),
            ("a.st", "NAMESPACE n\nPROGRAM p\nEND_PROGRAM\nEND_NAMESPACE\n", programs(&["p"])),
            ("a.st", "TYPE t : STRUCT a : INT; END_STRUCT; END_TYPE\nVAR_GLOBAL g : INT; END_VAR\n", Role::default()),
            ("a.st", "", Role::default()),
        ] {
            assert_eq!(Role::of(name, text, None), expected, "{name}: {text}");
        }
    }
}
