//! What a source is by its content: STL or Structured Text, and which dialect its words show.

use std::collections::{BTreeSet, HashMap};

use sieben_model::mnemonics::Mnemonics;

use crate::codesys_files::ends_in_comment;
use crate::st::diagrams::Language as Drawn;
use crate::st::dialect::Dialect;
use crate::stl::instructions::Instruction;

/// Bytes of a source that are looked at.
const LOOKED_AT: usize = 1 << 20;

/// Words that only one dialect writes, in upper case, each with the dialect that it shows for a file of another one.
const MARKS: &[(&str, Dialect, Dialect)] = &[
    ("S7_OPTIMIZED_ACCESS", Dialect::Scl, Dialect::Tia),
    ("END_REGION", Dialect::Scl, Dialect::Tia),
    ("INSTRUCTIONNAME", Dialect::Scl, Dialect::Tia),
    ("VAR CONSTANT", Dialect::Scl, Dialect::Tia),
    ("VAR RETAIN", Dialect::Scl, Dialect::Tia),
    ("END_REGION", Dialect::Iec, Dialect::Tia),
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

/// Types whose bits only codesys shifts.
const INTEGERS: [&str; 8] = ["SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT", "ULINT"];

/// The beginning of a text that is looked at.
fn beginning(text: &str) -> &str {
    let end = (0..=text.len().min(LOOKED_AT)).rev().find(|&end| text.is_char_boundary(end)).unwrap_or(0);
    &text[..end]
}

/// The dialect that a text shows, if it shows another one than the usual. What only TIA writes counts before what only codesys writes.
pub(super) fn shown(text: &str, usual: Dialect) -> Dialect {
    // Words are words however far apart they stand: a layout shows nothing.
    let spaced: Vec<String> = without_comments(beginning(text)).split_whitespace().map(str::to_ascii_uppercase).collect();
    let code = spaced.join(" ");
    if matches!(usual, Dialect::Scl | Dialect::Iec) && quotes_locals(&code) {
        return Dialect::Tia;
    }
    match MARKS.iter().find(|&&(mark, of, _)| of == usual && code.contains(mark)) {
        Some(&(_, _, dialect)) => dialect,
        None if usual == Dialect::Iec && is_codesys(&code) => Dialect::Codesys,
        None => usual,
    }
}

/// The dialect that a text of ST has by its blocks, where the name of the file does not say it.
pub(super) fn usual(text: &str) -> Dialect {
    let code = without_comments(beginning(text)).to_ascii_uppercase();
    let words = words(&code);
    let numbered = |block: &str| ["FC", "FB", "UDT"].iter().any(|kind| block.strip_prefix(kind).is_some_and(is_number_or_empty));
    let is_scl = words.windows(2).any(|pair| match pair[0] {
        "ORGANIZATION_BLOCK" | "DATA_BLOCK" => true,
        "FUNCTION" | "FUNCTION_BLOCK" | "TYPE" => numbered(pair[1]) || pair[1] == "\"",
        _ => false,
    });
    if is_scl { Dialect::Scl } else { Dialect::Iec }
}

fn is_number_or_empty(text: &str) -> bool {
    text.bytes().all(|byte| byte.is_ascii_digit())
}

/// Whether `#name` stands there, or a block whose name is quoted: TIA writes them.
fn quotes_locals(code: &str) -> bool {
    let local = code.match_indices('#').any(|(at, _)| {
        let before = code[..at].chars().next_back();
        let after = code[at + 1..].chars().next();
        !before.is_some_and(|c| c.is_alphanumeric() || c == '_') && after.is_some_and(|c| c.is_alphabetic() || c == '_' || c == '"')
    });
    let quoted = ["FUNCTION_BLOCK \"", "FUNCTION \"", "ORGANIZATION_BLOCK \"", "DATA_BLOCK \"", "TYPE \""].iter();
    local || quoted.into_iter().any(|header| code.contains(header))
}

/// The words and signs of a text.
fn words(code: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let mut rest = code.trim_start();
    while let Some(first) = rest.chars().next() {
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        let end = match first {
            _ if is_word(first) => rest.find(|c| !is_word(c)).unwrap_or(rest.len()),
            _ if rest.starts_with(":=") || rest.starts_with("=>") => 2,
            _ => first.len_utf8(),
        };
        words.push(&rest[..end]);
        rest = rest[end..].trim_start();
    }
    words
}

/// Whether the program is one of codesys by what it does: `PLC_PRG`, counters with its parameters, a count in a WORD, shifted integers.
fn is_codesys(code: &str) -> bool {
    let words = words(code);
    let counter = |word: &&str| matches!(*word, "CTU" | "CTD" | "CTUD");
    if words.contains(&"PLC_PRG") {
        return true;
    }
    // An argument follows a bracket or a comma: `RESET := TRUE;` is an assignment.
    let given = |names: &[&str]| words.windows(3).any(|part| matches!(part[0], "(" | ",") && names.contains(&part[1]) && part[2] == ":=");
    if words.iter().any(counter) && given(&["RESET", "LOAD"]) && !given(&["R", "LD"]) {
        return true;
    }
    let types = declared(&words);
    // What is given to `CV` and to shifts has to have such a type in all blocks of the file.
    let is_one_of = |name: &str, wanted: &[&str]| types.get(name).is_some_and(|found| found.iter().all(|one| wanted.contains(one)));
    words.windows(4).any(|part| match part {
        ["CV", "=>", name, _] => is_one_of(name, &["WORD"]),
        ["SHL" | "SHR" | "ROL" | "ROR", "(", name, ","] => is_one_of(name, &INTEGERS),
        _ => false,
    })
}

/// The types that names are declared with, `a, b : WORD`.
fn declared<'w>(words: &[&'w str]) -> HashMap<&'w str, BTreeSet<&'w str>> {
    let mut types: HashMap<&str, BTreeSet<&str>> = HashMap::new();
    for (at, pair) in words.windows(2).enumerate().filter(|(_, pair)| pair[0] == ":") {
        // From the colon backwards names and commas take turns.
        let mut name = at;
        while name > 0 {
            types.entry(words[name - 1]).or_default().insert(pair[1]);
            if name < 2 || words[name - 2] != "," {
                break;
            }
            name -= 2;
        }
    }
    types
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
            // To the next apostrophe, or to the end of the line where there is none.
            let end = rest[1..].find(['\'', '\n']).map_or(rest.len(), |end| end + 1);
            end + usize::from(rest[end..].starts_with('\''))
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

/// How many lines only one of the two kinds of languages has, and where the first of them lies.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Lines {
    pub(super) stl: usize,
    pub(super) st: usize,
    pub(super) first_stl: Option<(usize, usize)>,
    pub(super) first_st: Option<(usize, usize)>,
}

/// Words that begin a line of Structured Text and no line of STL.
#[rustfmt::skip] // A table.
const ST_WORDS: [&str; 17] = [
    "IF", "ELSIF", "END_IF", "CASE", "END_CASE", "FOR", "END_FOR", "WHILE", "END_WHILE", "REPEAT", "UNTIL", "END_REPEAT", "PROGRAM", "END_PROGRAM",
    "VAR_GLOBAL", "VAR_EXTERNAL", "END_REGION",
];

/// Counts the lines of a source that show its language. Lines of declarations, data blocks and parameter lists look alike in both.
pub(super) fn lines(text: &str) -> Lines {
    lines_until(text, |_| false)
}

/// The same up to the line after which enough is known.
pub(super) fn lines_until(text: &str, is_enough: impl Fn(&Lines) -> bool) -> Lines {
    let mut found = Lines::default();
    let (mut comment, mut declares, mut draws, mut at) = (false, false, false, 0);
    for line in beginning(text).split_inclusive('\n') {
        if is_enough(&found) {
            break;
        }
        let start = at;
        at += line.len();
        let code = if comment { "" } else { line.split("//").next().unwrap_or_default().split("(*").next().unwrap_or_default().trim() };
        comment = ends_in_comment(line, comment);
        let upper = code.to_ascii_uppercase();
        let first = upper.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).next().unwrap_or_default();
        // The lines of a body that is a diagram show nothing; its first word does.
        draws &= !begins_or_ends_block(first);
        if draws {
            continue;
        }
        draws = !declares && Drawn::of(first).is_some() && (upper == first || upper[first.len()..].trim_start().starts_with("NETWORK"));
        match first {
            _ if first.starts_with("VAR") || matches!(first, "STRUCT" | "DATA_BLOCK" | "TYPE" | "CONST") => {
                declares = !upper.contains("END_VAR");
                if !matches!(first, "VAR_GLOBAL" | "VAR_EXTERNAL") {
                    continue;
                }
            }
            "END_VAR" | "END_STRUCT" | "END_DATA_BLOCK" | "END_TYPE" | "END_CONST" | "FUNCTION" | "FUNCTION_BLOCK"
            | "ORGANIZATION_BLOCK" => {
                declares = false;
                continue;
            }
            _ => {}
        }
        let place = (start + line.len() - line.trim_start().len(), start + line.trim_end().len());
        let of_st = draws || ST_WORDS.contains(&first) || !declares && assigns(&upper);
        if of_st {
            found.st += 1;
            found.first_st.get_or_insert(place);
        } else if !declares && is_instruction(&upper) {
            found.stl += 1;
            found.first_stl.get_or_insert(place);
        }
    }
    found
}

/// Whether a line begins or ends a block, by its first word: a diagram ends before it.
fn begins_or_ends_block(first: &str) -> bool {
    let blocks = ["PROGRAM", "FUNCTION", "FUNCTION_BLOCK", "ORGANIZATION_BLOCK", "DATA_BLOCK", "TYPE", "METHOD", "ACTION", "CLASS"];
    let ended = first.strip_prefix("END_").unwrap_or(first);
    blocks.contains(&ended)
}

/// Whether a line assigns as Structured Text does: `x := 1;`, `#a.b[3] := 1;`, `"DB".x := 1;`.
fn assigns(line: &str) -> bool {
    let Some((target, _)) = line.split_once(":=").filter(|_| line.ends_with(';')) else { return false };
    let target = target.trim();
    let is_path = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '#' | '"' | '[' | ']' | '^' | '%' | ' ' | ',');
    !target.is_empty() && target.chars().all(is_path) && (target.contains('"') || !target.contains(' '))
}

/// Whether a line is a statement of STL: `U E 0.0`, `M001: L #x;`, `NETWORK`.
fn is_instruction(line: &str) -> bool {
    let labelled = line.split_once(':').filter(|(label, rest)| {
        label.len() <= 4 && !label.is_empty() && label.chars().all(|c| c.is_alphanumeric() || c == '_') && !rest.starts_with('=')
    });
    let statement = labelled.map_or(line, |(_, rest)| rest).trim();
    let end = statement.find(|c: char| c.is_whitespace() || matches!(c, ';' | '(')).unwrap_or(statement.len());
    let (word, rest) = (&statement[..end], statement[end..].trim_start());
    if matches!(word, "NETWORK" | "BEGIN" | "TITLE" | "RETURN" | "EXIT" | "NOT") {
        return word == "NETWORK";
    }
    // `U(` stands alone on its line; what has something in brackets is a call of Structured Text.
    if rest.starts_with('(') && !matches!(rest.trim_end_matches(';').trim_end(), "(") {
        return false;
    }
    let known = || [Mnemonics::English, Mnemonics::German].into_iter().any(|set| Instruction::candidates(word, set).next().is_some());
    !word.is_empty() && !rest.starts_with(":=") && !rest.starts_with(':') && !rest.contains(":=") && known()
}
