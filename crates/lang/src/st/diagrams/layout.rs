//! The networks of a body in the usual layout.

use super::read::{self, Part};
use crate::network::flavour::Flavour;
use crate::network::form_a;

/// How far elements are indented below NETWORK.
const INDENT: &str = "    ";

/// The lines of the networks of a body, without line ends; what is not understood stays as it is.
pub(in crate::st) fn lines(text: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for part in read::parts(text, 0..text.len()) {
        let Part { head, elements, .. } = part;
        let was_apart = text[..head.start].lines().next_back().is_some_and(|line| line.trim().is_empty());
        if was_apart && !head.is_empty() && !lines.is_empty() {
            lines.push(String::new());
        }
        lines.extend(text[head].lines().map(str::trim).filter(|line| !line.is_empty()).map(one_space));
        let written = &text[elements.clone()];
        if !form_a::is_form_a(written, Flavour::Iec) {
            lines.extend(written.lines().map(str::trim).filter(|line| !line.is_empty()).map(|line| format!("{INDENT}{line}")));
            continue;
        }
        let parsed = form_a::parse(text, elements.start, elements.end, Flavour::Iec);
        match parsed.mistakes.is_empty() {
            true => lines.extend(form_a::format(text, elements.start, elements.end, &parsed).lines().map(str::to_owned)),
            false => lines.extend(written.lines().map(|line| line.trim_end().to_owned())),
        }
    }
    lines
}

/// `NETWORK   LAD`: one space between words; a title keeps its own.
fn one_space(line: &str) -> String {
    match line.get(..7) {
        Some(word) if word.eq_ignore_ascii_case("NETWORK") && !line.contains("//") => line.split_whitespace().collect::<Vec<_>>().join(" "),
        _ => line.to_owned(),
    }
}
