//! Whether a diagram is written in form A, or on one line.

use super::line::{first_word, lines};
use crate::network::elements;
use crate::network::flavour::Flavour;

/// Whether a network has one element on each line: its first line begins with the word of an element, or no line of it looks like form B.
pub fn is_form_a(text: &str, flavour: Flavour) -> bool {
    let lines = lines(text, 0, text.len());
    let mut contents = lines.iter().map(|line| line.content).filter(|content| !content.is_empty());
    let Some(first) = contents.next() else { return true };
    match flavour {
        Flavour::Iec => !is_form_b(first) && (begins_with_word(first) || !contents.any(is_form_b)),
        Flavour::S7 => !contents.clone().any(has_outputs) && begins_form_a(first, contents),
    }
}

/// An arrow to outputs, or a box straight on the rail, is in no line of form A.
fn has_outputs(line: &str) -> bool {
    line.starts_with("|-") || line.contains("->")
}

/// The first line of a network of STEP 7 is one of form A.
fn begins_form_a<'l>(first: &'l str, mut rest: impl Iterator<Item = &'l str>) -> bool {
    let (word, at) = first_word(first);
    let after = &first[at.min(first.len())..];
    // `MOVE(1 => MW 0)`, `SR[M 0.0](…)`.
    let touches = first[word.len()..].starts_with(['(', '[']) && !word.is_empty();
    if has_outputs(first) || touches {
        return false;
    }
    if word == "LABEL" {
        return after.ends_with(':') && !after.trim_end_matches(':').contains(':');
    }
    let plain = |line: &str| begins_with_word(line) && !matches!(first_word(line).0, "S" | "R" | "P" | "N");
    elements::begins_line(word) || (!word.is_empty() && after.is_empty()) || plain(first) || rest.any(plain)
}

/// Whether a line of a diagram of IEC 61131-3 can only be one of form B.
fn is_form_b(line: &str) -> bool {
    has_outputs(line) || line.starts_with(['{', '(', '[', '!', '/']) && !begins_with_word(line)
}

/// Whether a line begins with the word of an element, as form A has it: `NO x`, `/OR`.
fn begins_with_word(line: &str) -> bool {
    elements::begins_line(line.split(char::is_whitespace).next().unwrap_or_default())
}
