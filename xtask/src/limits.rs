//! The page of limits: every constant of the code whose name has MAX or MIN in it, with its value and its sentence.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use crate::generate::{GENERATED, cell};
use crate::workspace::TextFile;

/// Where the page lies.
pub(crate) const PATH: &str = "docs/reference/limits.md";

/// A chapter of the page.
struct Chapter {
    title: &'static str,
    about: &'static str,
    /// Files whose paths begin so belong to it, unless a longer beginning belongs to another chapter.
    paths: &'static [&'static str],
}

/// The chapters in the order of the page.
const CHAPTERS: &[Chapter] = &[
    Chapter {
        title: "Languages",
        about: "What sources may contain, and how much of a mistake is reported. What a CPU type adds is a row of `crates/model/src/cpu_type.rs`.",
        paths: &["crates/lang/", "crates/model/"],
    },
    Chapter { title: "CPU", about: "The controller and its system functions.", paths: &["crates/cpu/"] },
    Chapter { title: "Engine", about: "What running code may do.", paths: &["crates/engine/"] },
    Chapter { title: "Simulation", about: "Simulated plants, their faults, and scenarios.", paths: &["crates/sim/"] },
    Chapter {
        title: "Tests",
        about: "Unit tests, programs that check themselves, coverage, and scenarios as tests.",
        paths: &[
            "crates/model/src/testing",
            "crates/sim/src/runner",
            "crates/workspace/src/coverage",
            "crates/workspace/src/testing",
            "crates/app/src/testing",
        ],
    },
    Chapter {
        title: "Traces",
        about: "Traces, recordings and timing diagrams.",
        paths: &[
            "crates/sim/src/trace",
            "crates/sim/src/timing_diagram",
            "crates/workspace/src/tracing",
            "crates/app/src/tracing",
            "crates/app/src/commands/trace",
            "crates/app/src/commands/record",
        ],
    },
    Chapter {
        title: "Stepping",
        about: "`sieben step` and the history of a run.",
        paths: &["crates/sim/src/history", "crates/workspace/src/session", "crates/app/src/stepping"],
    },
    Chapter {
        title: "Files and the command line",
        about: "Projects, files, retentive data, and what the verbs print.",
        paths: &["crates/"],
    },
    Chapter {
        title: "Machine code",
        about: "Where the compiler stops to optimize. None of them changes what a program does; beyond one of them it takes more time.",
        paths: &["crates/jit/"],
    },
];

/// A constant as the source declares it.
#[derive(Debug, PartialEq, Eq)]
struct Constant<'a> {
    path: &'a str,
    name: &'a str,
    expression: &'a str,
    /// The first sentence of its doc comment; empty if it has none.
    sentence: String,
}

/// The page, from all files of the project.
pub(crate) fn page(files: &[TextFile]) -> TextFile {
    let sources: Vec<&TextFile> = files.iter().filter(|file| is_source(&file.path)).collect();
    let constants: Vec<Constant<'_>> = sources.iter().flat_map(|file| constants_of(&file.path, &file.text)).collect();
    let values = Values::of(&constants);
    let mut text = GENERATED.to_owned();
    text.push_str(
        "# Limits\n\n\
         Every constant of the code that is the most or the least of something: its name has `MAX` or `MIN` in it. `cargo xtask generate` reads names, values and \
         sentences from the sources; a line in bold says what the file is that has them. Limits of a CPU type (`sieben explain cpu`) and of the manual stand where they are explained.\n",
    );
    for (index, chapter) in CHAPTERS.iter().enumerate() {
        let _ = write!(text, "\n## {}\n\n{}\n\n| limit | value | constant |\n|---|---|---|\n", chapter.title, chapter.about);
        for file in sources.iter().filter(|file| chapter_of(&file.path) == index) {
            let of_file = constants.iter().filter(|constant| constant.path == file.path && is_limit(constant.name));
            for (row, constant) in of_file.enumerate() {
                if row == 0 {
                    let name = file.path.rsplit_once("/src/").map_or(file.path.as_str(), |(_, name)| name);
                    let _ = writeln!(text, "| **{}** [`{name}`](../../{}) | | |", cell(&subject(&file.text)), file.path);
                }
                let _ = writeln!(text, "| {} | {} | `{}` |", cell(&constant.sentence), values.shown(constant), constant.name);
            }
        }
    }
    TextFile { path: PATH.to_owned(), text }
}

/// Whether a path is a source of the product: neither a test nor a target of the fuzzer.
fn is_source(path: &str) -> bool {
    let parts: Vec<&str> = path.split('/').collect();
    let is_of_product = parts.first() == Some(&"crates") && parts.get(2) == Some(&"src");
    is_of_product && path.ends_with(".rs") && !parts.iter().any(|part| matches!(*part, "tests" | "tests.rs" | "fuzz.rs"))
}

/// What a source says that it is.
fn subject(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map_while(|line| line.strip_prefix("//!")).map(str::trim).collect();
    first_sentence(&lines.join("\n"))
}

/// Whether a name says that it is the most or the least of something.
fn is_limit(name: &str) -> bool {
    name.split('_').any(|word| matches!(word, "MAX" | "MIN"))
}

/// The chapter with the longest beginning of this path.
fn chapter_of(path: &str) -> usize {
    let length = |chapter: &Chapter| chapter.paths.iter().filter(|start| path.starts_with(**start)).map(|start| start.len()).max();
    (0..CHAPTERS.len()).max_by_key(|&index| length(&CHAPTERS[index])).unwrap_or_default()
}

/// All constants of a source, up to the tests at its end.
fn constants_of<'a>(path: &'a str, text: &'a str) -> Vec<Constant<'a>> {
    let mut constants = Vec::new();
    let mut paragraph = String::new();
    let mut documented = false;
    for line in text.lines().map(str::trim).take_while(|line| *line != "#[cfg(test)]") {
        if let Some(words) = line.strip_prefix("///") {
            if !documented {
                paragraph.clear();
            }
            documented = true;
            let _ = writeln!(paragraph, "{}", words.trim());
        } else if !line.starts_with("#[") {
            if let Some((name, expression)) = declared(line) {
                let sentence = if documented { first_sentence(&paragraph) } else { String::new() };
                constants.push(Constant { path, name, expression, sentence });
            }
            documented = false;
        }
    }
    constants
}

/// Name and expression of `const NAME: TYPE = EXPRESSION;`.
fn declared(line: &str) -> Option<(&str, &str)> {
    let line = ["pub(crate) ", "pub(super) ", "pub "].iter().find_map(|start| line.strip_prefix(start)).unwrap_or(line);
    let (name, rest) = line.strip_prefix("const ")?.split_once(": ")?;
    let (_, expression) = rest.split_once(" = ")?;
    Some((name, expression.strip_suffix(';')?))
}

/// The first sentence of a doc comment, with links to code as code.
fn first_sentence(paragraph: &str) -> String {
    let lines: Vec<&str> = paragraph.lines().take_while(|line| !line.is_empty()).collect();
    let text = lines.join(" ");
    let end = text.match_indices(". ").map(|(at, _)| at + 1).find(|&at| text[at + 1..].starts_with(char::is_uppercase));
    text[..end.unwrap_or(text.len())].replace("[`", "`").replace("`]", "`")
}

/// The expressions of all constants: by file and name, and by name alone.
struct Values<'a> {
    in_file: BTreeMap<(&'a str, &'a str), &'a str>,
    anywhere: BTreeMap<&'a str, (&'a str, &'a str)>,
}

impl<'a> Values<'a> {
    fn of(constants: &[Constant<'a>]) -> Self {
        let in_file = constants.iter().map(|constant| ((constant.path, constant.name), constant.expression)).collect();
        let anywhere = constants.iter().map(|constant| (constant.name, (constant.path, constant.expression))).collect();
        Self { in_file, anywhere }
    }

    /// The value as a person reads it; the expression where it cannot be calculated.
    fn shown(&self, constant: &Constant<'_>) -> String {
        let expression = constant.expression;
        for (start, unit) in [("Duration::from_secs(", "s"), ("Duration::from_millis(", "ms")] {
            if let Some(number) = expression.strip_prefix(start).and_then(|rest| rest.strip_suffix(')')) {
                return self.value(constant.path, number, 0).map_or_else(|| format!("`{expression}`"), |value| with_unit(value, unit));
            }
        }
        let Some(value) = self.value(constant.path, expression, 0) else { return format!("`{expression}`") };
        if let Some(digits) = expression.strip_prefix("0x") {
            return format!("16#{digits}");
        }
        let unit = constant.name.split('_').find_map(|word| UNITS.iter().find(|(known, _)| *known == word));
        with_unit(value, unit.map_or("", |(_, unit)| unit))
    }

    /// The value of an expression of numbers, names of constants and the operators of [`OPERATORS`].
    fn value(&self, path: &str, expression: &str, depth: u32) -> Option<i128> {
        let tokens = tokens(expression)?;
        let mut at = 0;
        let value = self.operation(path, &tokens, &mut at, 0, depth)?;
        (at == tokens.len()).then_some(value)
    }

    /// Operators of at least this level.
    fn operation(&self, path: &str, tokens: &[&str], at: &mut usize, level: usize, depth: u32) -> Option<i128> {
        let Some(operators) = OPERATORS.get(level) else { return self.operand(path, tokens, at, depth) };
        let mut left = self.operation(path, tokens, at, level + 1, depth)?;
        while let Some((_, apply)) = tokens.get(*at).and_then(|token| operators.iter().find(|(known, _)| known == token)) {
            *at += 1;
            let right = self.operation(path, tokens, at, level + 1, depth)?;
            left = apply(left, right)?;
        }
        Some(left)
    }

    /// A number, a name or brackets, and the types that it is converted to.
    fn operand(&self, path: &str, tokens: &[&str], at: &mut usize, depth: u32) -> Option<i128> {
        let token = *tokens.get(*at)?;
        *at += 1;
        let value = if token == "(" {
            let value = self.operation(path, tokens, at, 0, depth)?;
            (tokens.get(*at) == Some(&")")).then(|| *at += 1)?;
            value
        } else if token.starts_with(|first: char| first.is_ascii_digit()) {
            number(token)?
        } else {
            self.named(path, token, depth)?
        };
        while tokens.get(*at) == Some(&"as") {
            *at += 2;
        }
        Some(value)
    }

    /// The value of a constant of this file or, with any path before its name, of another one.
    fn named(&self, path: &str, name: &str, depth: u32) -> Option<i128> {
        if let Some((_, largest)) = LARGEST.iter().find(|(known, _)| *known == name) {
            return Some(*largest);
        }
        let name = name.rsplit("::").next()?;
        let (path, expression) = match self.in_file.get(&(path, name)) {
            Some(expression) => (path, *expression),
            None => *self.anywhere.get(name)?,
        };
        if depth > REFERENCES_MAX { None } else { self.value(path, expression, depth + 1) }
    }
}

/// So many constants may lead to each other; a circle ends here.
const REFERENCES_MAX: u32 = 8;

/// An operator, and what it does unless the result is too large.
type Operator = (&'static str, fn(i128, i128) -> Option<i128>);

/// Those that bind least come first.
const OPERATORS: &[&[Operator]] = &[
    &[("<<", |a, b| a.checked_mul(1_i128.checked_shl(u32::try_from(b).ok()?)?))],
    &[("+", i128::checked_add), ("-", i128::checked_sub)],
    &[("*", i128::checked_mul), ("/", i128::checked_div)],
];

/// The largest numbers of types.
const LARGEST: &[(&str, i128)] = &[
    ("u8::MAX", u8::MAX as i128),
    ("u16::MAX", u16::MAX as i128),
    ("u32::MAX", u32::MAX as i128),
    ("i16::MAX", i16::MAX as i128),
    ("i32::MAX", i32::MAX as i128),
];

/// Units by the word of a name that says them.
const UNITS: &[(&str, &str)] = &[("BYTES", "bytes"), ("BITS", "bits"), ("MS", "ms"), ("US", "µs")];

/// The words, numbers and signs of an expression.
fn tokens(expression: &str) -> Option<Vec<&str>> {
    let mut tokens = Vec::new();
    let mut rest = expression.trim_start();
    while let Some(first) = rest.chars().next() {
        let length = if first.is_ascii_alphanumeric() || first == '_' {
            rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == ':' || c == '.')).unwrap_or(rest.len())
        } else if rest.starts_with("<<") {
            2
        } else if "+-*/()".contains(first) {
            1
        } else {
            return None;
        };
        tokens.push(&rest[..length]);
        rest = rest[length..].trim_start();
    }
    Some(tokens)
}

/// A number as Rust writes it; one with a fraction has no value here.
fn number(token: &str) -> Option<i128> {
    let digits = token.replace('_', "");
    if let Some(hexadecimal) = digits.strip_prefix("0x") {
        return i128::from_str_radix(hexadecimal, 16).ok();
    }
    if let Ok(whole) = digits.parse() {
        return Some(whole);
    }
    let real: f64 = digits.parse().ok()?;
    (real.fract() == 0.0 && real.abs() < 1e15).then_some(real as i128)
}

/// The number with its unit; bytes in the largest binary unit that divides them.
fn with_unit(value: i128, unit: &str) -> String {
    let (value, unit) = match unit {
        "bytes" if value != 0 && value % (1 << 30) == 0 => (value >> 30, "GiB"),
        "bytes" if value != 0 && value % (1 << 20) == 0 => (value >> 20, "MiB"),
        "bytes" if value != 0 && value % (1 << 10) == 0 => (value >> 10, "KiB"),
        unit => (value, unit),
    };
    let digits = value.unsigned_abs().to_string();
    let mut grouped = if value < 0 { "-".to_owned() } else { String::new() };
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index) % 3 == 0 {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    if unit.is_empty() { grouped } else { format!("{grouped} {unit}") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::workspace;

    /// What the page says of a source of `lang`: limit, value and constant of each row.
    fn rows(text: &str) -> Vec<String> {
        let file = TextFile { path: "crates/lang/src/x.rs".to_owned(), text: text.to_owned() };
        let rows = page(&[file]).text;
        rows.lines().filter(|line| line.ends_with("` |") || line.contains("](")).map(str::to_owned).collect()
    }

    #[test]
    fn a_limit_has_its_sentence_its_value_and_its_name() {
        let source = "\
//! What blocks have. And what not.

/// A block has no more bytes. More would not fit.
pub const BLOCK_BYTES_MAX: usize = 32 << 20;
/// Blocks and their [`parts`]
/// together.
#[allow(dead_code)]
const PARTS_MAX: u32 = (BLOCK_BYTES_MAX as u32 - 1) / 3 + 2 * 0x10;
/// No limit.
const WIDTH: usize = 80;
impl X {
    /// The shortest pause.
    pub(crate) const WAIT_MIN: Duration = Duration::from_millis(1_500);
}
#[cfg(test)]
const TEST_MAX: usize = 1;
";
        assert_eq!(
            rows(source),
            [
                "| **What blocks have.** [`x.rs`](../../crates/lang/src/x.rs) | | |",
                "| A block has no more bytes. | 32 MiB | `BLOCK_BYTES_MAX` |",
                "| Blocks and their `parts` together. | 11,184,842 | `PARTS_MAX` |",
                "| The shortest pause. | 1,500 ms | `WAIT_MIN` |",
            ]
        );
    }

    #[test]
    fn what_cannot_be_calculated_is_shown_as_it_stands() {
        assert_eq!(rows("/// One.\nconst A_MAX: u32 = f(7);\n")[1..], ["| One. | `f(7)` | `A_MAX` |"]);
        let circle = rows("/// One.\nconst A_MAX: u32 = B_MAX;\n/// Two.\nconst B_MAX: u32 = A_MAX;\n");
        assert_eq!(circle[1..], ["| One. | `B_MAX` | `A_MAX` |", "| Two. | `A_MAX` | `B_MAX` |"]);
    }

    #[test]
    fn a_doc_comment_belongs_to_the_constant_below_it() {
        let constants = constants_of("x.rs", "/// Of another item.\nfn f() {}\nconst A_MAX: u32 = 1;\n");
        assert_eq!(constants[0].sentence, "");
    }

    #[test]
    fn the_more_exact_path_decides_the_chapter() {
        assert_eq!(CHAPTERS[chapter_of("crates/model/src/testing.rs")].title, "Tests");
        assert_eq!(CHAPTERS[chapter_of("crates/model/src/types.rs")].title, "Languages");
        assert_eq!(CHAPTERS[chapter_of("crates/ide/src/lib.rs")].title, "Files and the command line");
    }

    #[test]
    fn every_limit_of_the_project_has_a_sentence_and_a_value() {
        let files = workspace::text_files(&workspace::root());
        let sources = files.iter().filter(|file| is_source(&file.path));
        let constants: Vec<_> = sources.flat_map(|file| constants_of(&file.path, &file.text)).collect();
        let values = Values::of(&constants);
        let poor: Vec<String> = constants
            .iter()
            .filter(|constant| is_limit(constant.name))
            .filter(|constant| !constant.sentence.ends_with(['.', ':']) || values.shown(constant).contains('`'))
            .map(|constant| format!("{}: {} = {}: {}", constant.path, constant.name, constant.expression, constant.sentence))
            .collect();
        assert!(poor.is_empty(), "\n{}\n", poor.join("\n"));
    }
}
