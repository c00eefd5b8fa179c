//! The layout of form A: four spaces for each level, operands below each other.

use super::boxes::pin_of;
use super::line::{INDENT, first_word, lines};
use super::parse::Parsed;
use crate::network::elements;

/// A line before it is laid out.
#[derive(Clone, Debug, Default)]
pub(super) struct FormLine {
    /// How deep it lies.
    pub level: usize,
    /// What it says; empty for a line that has only a comment.
    pub content: String,
    /// `// …`.
    pub comment: Option<String>,
    /// An empty line stands before it.
    pub after_empty: bool,
}

/// The text of lines, each with its end.
pub(super) fn layout(lines: &[FormLine]) -> String {
    let mut out = String::new();
    let mut at = 0;
    while at < lines.len() {
        let run = lines[at..].iter().take_while(|line| line.level == lines[at].level && aligned(&line.content).is_some()).count();
        let width = lines[at..at + run].iter().filter_map(|line| aligned(&line.content)).map(|(word, _)| word.len()).max().unwrap_or(0);
        for line in &lines[at..at + run.max(1)] {
            one(&mut out, line, width);
        }
        at += run.max(1);
    }
    out
}

fn one(out: &mut String, line: &FormLine, width: usize) {
    if line.after_empty {
        out.push('\n');
    }
    let begin = out.len();
    out.extend(std::iter::repeat_n(' ', (line.level + 1) * INDENT));
    match aligned(&line.content) {
        Some((word, "")) => out.push_str(word),
        Some((word, rest)) => {
            out.push_str(word);
            out.extend(std::iter::repeat_n(' ', width + 2 - word.len()));
            out.push_str(rest);
        }
        None => out.push_str(&line.content),
    }
    if let Some(comment) = &line.comment {
        if !line.content.is_empty() {
            out.push_str("  ");
        }
        out.push_str(comment);
    }
    let end = out.trim_end().len();
    out.truncate(end.max(begin));
    out.push('\n');
}

/// The word and the operand of a line whose operand is aligned with those of the lines around it.
fn aligned(content: &str) -> Option<(&str, &str)> {
    let (word, rest) = first_word(content);
    let alone = matches!(word, "OR" | "/OR" | "AND" | "/AND" | "XOR" | "/XOR" | "END" | "BRANCH" | "LABEL");
    (elements::begins_line(word) && !elements::is_box(word) && !alone && pin_of(content).is_none()).then(|| (word, &content[rest..]))
}

/// A part of a text that was parsed without mistakes, in the usual layout.
pub fn format(text: &str, from: usize, to: usize, parsed: &Parsed) -> String {
    let mut levels = parsed.levels.iter().copied();
    let mut out: Vec<FormLine> = Vec::new();
    // Comments lie as deep as the line after them.
    let mut waiting = 0;
    for line in lines(text, from, to) {
        let mut formed =
            FormLine { level: 0, content: spaced(line.content), comment: line.comment.map(str::to_owned), after_empty: line.after_empty };
        if line.content.is_empty() {
            waiting += 1;
        } else {
            formed.level = levels.next().unwrap_or(0);
            let first = out.len() - waiting;
            out[first..].iter_mut().for_each(|comment| comment.level = formed.level);
            waiting = 0;
        }
        out.push(formed);
    }
    layout(&out)
}

/// One space where there were several, outside of quotes.
fn spaced(content: &str) -> String {
    let mut out = String::with_capacity(content.len());
    let mut quote = None;
    for sign in content.chars() {
        match (quote, sign) {
            (Some(open), sign) if open == sign => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(sign),
            (None, ' ' | '\t') => {
                if !out.ends_with(' ') {
                    out.push(' ');
                }
                continue;
            }
            _ => {}
        }
        out.push(sign);
    }
    out.truncate(out.trim_end().len());
    out
}
