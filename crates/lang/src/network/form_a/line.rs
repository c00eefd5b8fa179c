//! The lines of a diagram in form A: how far they are indented, what they say, their comments.

use super::boxes::pin_of;
use crate::network::operand::{Operand, may_name_output};

/// How many columns a tab goes on at most, and by how many spaces `fmt` indents.
pub(super) const INDENT: usize = 4;

/// A line that is not empty.
#[derive(Clone, Copy, Debug)]
pub(super) struct TextLine<'t> {
    /// Columns before its first sign.
    pub indent: usize,
    /// Its first byte in the whole text, after the indentation.
    pub start: usize,
    /// What it says, without indentation and comment; empty if it has only a comment.
    pub content: &'t str,
    /// `// …`, as written.
    pub comment: Option<&'t str>,
    /// An empty line stands before it.
    pub after_empty: bool,
}

impl TextLine<'_> {
    /// The byte after its content.
    pub(super) fn end(&self) -> usize {
        self.start + self.content.len()
    }
}

/// The lines of a text with their ends: CR LF, LF, CR or a form feed.
pub fn written_lines(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let end = match rest.find(['\n', '\r', '\u{c}']) {
            Some(at) if rest[at..].starts_with("\r\n") => at + 2,
            Some(at) => at + 1,
            None => rest.len(),
        };
        let (line, more) = rest.split_at(end);
        rest = more;
        (!line.is_empty()).then_some(line)
    })
}

/// The lines of a part of a text.
pub(super) fn lines(text: &str, from: usize, to: usize) -> Vec<TextLine<'_>> {
    let mut out = Vec::new();
    let mut start = from;
    let mut after_empty = false;
    for line in written_lines(&text[from..to]) {
        let written = line.trim_end();
        let content = written.trim_start();
        let begin = start + (written.len() - content.len());
        let indent = written[..written.len() - content.len()].chars().fold(0, |column, sign| match sign {
            '\t' => (column / INDENT + 1) * INDENT,
            _ => column + 1,
        });
        match content.is_empty() {
            true => after_empty = !out.is_empty(),
            false => {
                let cut = comment_start(content).unwrap_or(content.len());
                let comment = content.get(cut..).filter(|comment| !comment.is_empty());
                out.push(TextLine { indent, start: begin, content: content[..cut].trim_end(), comment, after_empty });
                after_empty = false;
            }
        }
        start += line.len();
    }
    out
}

/// Where the comment of a line begins: outside of quotes.
pub fn comment_start(content: &str) -> Option<usize> {
    let mut quote = None;
    let bytes = content.as_bytes();
    for (at, sign) in content.char_indices() {
        match (quote, sign) {
            (Some(open), sign) if open == sign => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(sign),
            (None, '/') if bytes.get(at + 1) == Some(&b'/') => return Some(at),
            _ => {}
        }
    }
    None
}

/// A comment of a diagram.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Comment {
    /// `// …`.
    pub text: String,
    /// The first byte of the line that it belongs to; of a line of its own, where it stands.
    pub line: usize,
    /// It has a line of its own, and belongs to the next one.
    pub own_line: bool,
    /// It belongs to this pin of the box at `line`.
    pub pin: Option<String>,
}

/// The comments in a part of a text.
pub fn comments(text: &str, from: usize, to: usize) -> Vec<Comment> {
    let lines = lines(text, from, to);
    let mut out = Vec::new();
    for (index, line) in lines.iter().enumerate() {
        let Some(comment) = line.comment else { continue };
        let own_line = line.content.is_empty();
        let pin = lines.iter().enumerate().skip(index).find(|(_, next)| !next.content.is_empty()).and_then(|(at, next)| {
            let (name, ..) = pin_of(next.content)?;
            // Its box is the nearest line above that is not indented further, and no pin.
            let owner = lines
                .get(..at)?
                .iter()
                .rev()
                .find(|above| !above.content.is_empty() && above.indent <= next.indent && pin_of(above.content).is_none())?;
            Some((owner.start, name.trim_matches('"').to_owned()))
        });
        let (start, pin) = pin.map_or((line.start, None), |(owner, name)| (owner, Some(name)));
        out.push(Comment { text: comment.to_owned(), line: start, own_line, pin });
    }
    out
}

/// The first word of a line's content, and what follows it with its place in the content.
pub(super) fn first_word(content: &str) -> (&str, usize) {
    let is_sign = |sign: char| sign.is_alphanumeric() || matches!(sign, '_' | '<' | '>' | '/');
    let mut signs = content.find(|sign: char| !is_sign(sign)).unwrap_or(content.len());
    // A dot goes on in a name: `motor.Start`.
    while let Some(rest) =
        content[signs..].strip_prefix('.').filter(|rest| rest.starts_with(|sign: char| sign.is_alphabetic() || sign == '_'))
    {
        signs = content.len() - rest.len() + rest.find(|sign: char| !is_sign(sign)).unwrap_or(rest.len());
    }
    let rest = &content[signs..];
    (&content[..signs], content.len() - rest.trim_start().len())
}

/// One argument of a line: `IN1 := MW 10`, `MW 10 => MW 12`, `=> x`.
#[derive(Clone, Debug, Default)]
pub(super) struct Argument {
    /// The pin.
    pub name: Option<Operand>,
    /// What is wired to an input.
    pub input: Option<Input>,
    /// What an output is wired to.
    pub output: Option<Operand>,
    /// Its first byte.
    pub start: usize,
    /// The byte after its last one.
    pub end: usize,
}

/// What is wired to an input on the same line.
#[derive(Clone, Debug)]
pub(super) struct Input {
    /// The operand.
    pub operand: Operand,
    /// The sign before it.
    pub mark: Mark,
}

/// A sign before an operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mark {
    /// None.
    Plain,
    /// `/`: negated.
    Negated,
    /// `=`: handed on as it is.
    Direct,
}

/// The arguments of a text at a byte.
pub(super) fn arguments(text: &str, start: usize) -> Vec<Argument> {
    split(text, ",")
        .into_iter()
        .filter(|(from, part)| !(part.trim().is_empty() && text.trim().is_empty() && *from == 0))
        .map(|(from, part)| argument(part, start + from))
        .collect()
}

/// One argument.
fn argument(part: &str, start: usize) -> Argument {
    let begin = start + (part.len() - part.trim_start().len());
    let mut one = Argument { start: begin, end: begin + part.trim().len(), ..Argument::default() };
    let mut pieces = split(part, "=>").into_iter();
    let (_, before) = pieces.next().unwrap_or((0, ""));
    let outputs: Vec<(usize, &str)> = pieces.collect();
    if let Some(&(from, _)) = outputs.first() {
        one.output = Some(operand(&part[from..], start + from));
    }
    let has_output = one.output.is_some();
    match split(before, ":=").as_slice() {
        [(_, name), (from, _), ..] => {
            one.name = Some(operand(name, start));
            one.input = input(&before[*from..], start + from);
        }
        // `Q => x`: a name; `MW 10 => MW 12`: an input. Who knows the box decides.
        [(_, only)] if !only.trim().is_empty() => one.input = input(only, start),
        _ => {}
    }
    let may_be_name = |input: &Input| input.mark == Mark::Plain && names_output(&input.operand);
    if one.name.is_none() && has_output && one.input.as_ref().is_some_and(may_be_name) {
        // A word alone before `=>` may be the name of an output.
        one.name = one.input.take().map(|input| input.operand);
    }
    one
}

/// An operand from a part of a text.
pub(super) fn operand(part: &str, start: usize) -> Operand {
    Operand::read(part, start + (part.len() - part.trim_start().len()))
}

fn input(part: &str, start: usize) -> Option<Input> {
    let written = part.trim_start();
    let start = start + (part.len() - written.len());
    let (mark, written, start) = match written.chars().next()? {
        '/' => (Mark::Negated, &written[1..], start + 1),
        '=' if !written.starts_with("==") => (Mark::Direct, &written[1..], start + 1),
        _ => (Mark::Plain, written, start),
    };
    let operand = operand(written, start);
    (!operand.text.is_empty()).then_some(Input { operand, mark })
}

/// What stands before `=>` may be the name of an output.
fn names_output(written: &str) -> bool {
    is_name(written) && (written.starts_with('"') || may_name_output(written))
}

/// A word or a name in quotes, as pins are named.
pub(super) fn is_name(text: &str) -> bool {
    match text.strip_prefix('"') {
        Some(rest) => rest.ends_with('"') && !rest[..rest.len() - 1].contains('"'),
        None => {
            text.starts_with(|sign: char| sign.is_alphabetic() || sign == '_')
                && text.chars().all(|sign| sign.is_alphanumeric() || sign == '_')
        }
    }
}

/// Parts of a text between separators that stand outside of quotes and brackets, each with its first byte.
pub(super) fn split<'t>(text: &'t str, separator: &str) -> Vec<(usize, &'t str)> {
    let mut parts = Vec::new();
    let (mut from, mut depth, mut quote, mut skip) = (0, 0_usize, None, 0);
    for (at, sign) in text.char_indices() {
        if at < skip {
            continue;
        }
        match (quote, sign) {
            (Some(open), sign) if open == sign => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(sign),
            (None, '(' | '[') => depth += 1,
            (None, ')' | ']') => depth = depth.saturating_sub(1),
            // `<=>` is no separator of anything; `=>` after `<` or `>` would be an operator.
            (None, _) if depth == 0 && text[at..].starts_with(separator) => {
                parts.push((from, &text[from..at]));
                from = at + separator.len();
                skip = from;
            }
            _ => {}
        }
    }
    parts.push((from, &text[from..]));
    parts
}
