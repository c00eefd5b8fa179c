//! Pragmas: attributes, and conditions that switch parts of a source off.

use sieben_model::source::{FileId, Span};

use super::super::ast::{Attribute, Name};
use super::super::lexer::{Raw, Token};

/// What a pragma says, without its braces.
fn content<'t>(text: &'t str, token: &Token) -> (&'t str, usize) {
    let whole = &text[token.start as usize..token.end as usize];
    let inner = whole.strip_prefix('{').unwrap_or(whole);
    let inner = inner.strip_suffix('}').unwrap_or(inner);
    (inner, token.start as usize + 1)
}

/// A conditional pragma that is open.
struct Condition {
    /// A branch has been taken.
    taken: bool,
    /// The current branch is the taken one, and what is around it too.
    active: bool,
    /// What is around it is active.
    outer: bool,
}

/// Makes tokens in dead branches of `{IF defined (x)} … {ELSE} … {END_IF}` inactive.
pub(super) fn switch_off(text: &str, tokens: &mut [Token]) {
    let mut defined: Vec<String> = Vec::new();
    let mut open: Vec<Condition> = Vec::new();
    for token in tokens.iter_mut() {
        let active = open.last().is_none_or(|condition| condition.active);
        if token.raw != Raw::Pragma {
            if !active && !token.raw.is_trivia() && token.raw != Raw::End {
                (token.raw, token.keyword) = (Raw::Inactive, None);
            }
            continue;
        }
        let (inner, _) = content(text, token);
        let inner = inner.trim();
        let word = inner.split(|c: char| !(c.is_alphanumeric() || c == '_')).next().unwrap_or_default();
        let rest = inner[word.len()..].trim();
        match word.to_ascii_uppercase().as_str() {
            "IF" => {
                let value = active && holds(rest, &defined);
                open.push(Condition { taken: value, active: value, outer: active });
            }
            "ELSIF" => {
                if let Some(condition) = open.last_mut() {
                    condition.active = condition.outer && !condition.taken && holds(rest, &defined);
                    condition.taken |= condition.active;
                }
            }
            "ELSE" => {
                if let Some(condition) = open.last_mut() {
                    condition.active = condition.outer && !condition.taken;
                    condition.taken = true;
                }
            }
            "END_IF" => {
                open.pop();
            }
            "DEFINE" if active => defined.extend(rest.split_whitespace().next().map(str::to_uppercase)),
            "UNDEFINE" if active => defined.retain(|name| !name.eq_ignore_ascii_case(rest)),
            _ => {}
        }
    }
}

/// Whether a condition holds: `defined (x)`, NOT, AND, OR; whatever else it asks is false here.
fn holds(condition: &str, defined: &[String]) -> bool {
    let upper = condition.to_uppercase();
    // OR binds less than AND; brackets stand only around names in what people write.
    upper.split(" OR ").any(|part| {
        part.split(" AND ").all(|term| {
            let term = term.trim();
            let (negated, term) = match term.strip_prefix("NOT") {
                Some(rest) => (true, rest.trim()),
                None => (false, term),
            };
            let name = term.strip_prefix("DEFINED").map(|rest| rest.trim_matches(|c: char| c.is_whitespace() || c == '(' || c == ')'));
            let found = name.is_some_and(|name| defined.iter().any(|known| known == name));
            found != negated
        })
    })
}

/// The attributes that a pragma gives: `{attribute 'name' := 'value'}`, `{name := 'value'; name := 'value'}`.
pub(super) fn attributes(text: &str, file: FileId, token: Token) -> Vec<Attribute> {
    let (inner, start) = content(text, &token);
    let mut attributes = Vec::new();
    let mut at = 0;
    for part in parts(inner, ';') {
        let place = start + at;
        at += part.len() + 1;
        let lead = part.len() - part.trim_start().len();
        let trimmed = part.trim();
        let marked = trimmed.get(..9).is_some_and(|word| word.eq_ignore_ascii_case("attribute"));
        let pair = if marked { trimmed[9..].trim() } else { trimmed };
        let (name, value) = match pair.find(":=") {
            Some(sign) => (pair[..sign].trim(), Some(unquoted(pair[sign + 2..].trim()))),
            None if marked => (pair, None),
            None => continue,
        };
        if name.is_empty() {
            continue;
        }
        let begin = (place + lead) as u32;
        let span = Span::new(file, begin, begin + trimmed.len() as u32);
        let name = Name { text: unquoted(name), span, ..Name::default() };
        attributes.push(Attribute { name, value, span });
    }
    attributes
}

/// The parts between separators that do not stand in quotes.
fn parts(text: &str, separator: char) -> Vec<&str> {
    let mut quoted = false;
    text.split(|c: char| {
        quoted ^= c == '\'';
        c == separator && !quoted
    })
    .collect()
}

fn unquoted(text: &str) -> String {
    let text = text.trim_matches(|c: char| c == '\'' || c == '"');
    text.replace("$'", "'")
}
