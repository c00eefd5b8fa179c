//! Splits lists of `NAME=VALUE`.

use super::NameError;

/// Splits `I 0.0=1 MW10=16#0102` into names and values; blanks around `=` and inside names are free.
///
/// # Errors
/// A part has no `=`, no name or no value; the message says which.
pub fn assignments(text: &str) -> Result<Vec<(String, String)>, NameError> {
    let mut out = Vec::new();
    let mut rest = text.trim();
    while !rest.is_empty() {
        let Some((name, behind)) = split_at_equals(rest) else {
            return Err(NameError::new(format!("`{rest}` is no `NAME=VALUE`")));
        };
        let behind = behind.trim_start();
        let end = value_end(behind);
        let (value, next) = behind.split_at(end);
        if name.trim().is_empty() || value.is_empty() {
            return Err(NameError::new(format!("`{}` is no `NAME=VALUE`", rest.trim())));
        }
        out.push((name.trim().to_owned(), value.to_owned()));
        rest = next.trim_start();
    }
    Ok(out)
}

/// Splits at the first `=` outside of quotes.
fn split_at_equals(text: &str) -> Option<(&str, &str)> {
    let mut quoted = false;
    let at = text.char_indices().find_map(|(at, c)| {
        quoted ^= c == '"';
        (c == '=' && !quoted).then_some(at)
    })?;
    Some((&text[..at], &text[at + 1..]))
}

/// Where a value ends: at the next blank that is not inside apostrophes or brackets.
fn value_end(text: &str) -> usize {
    let (mut quoted, mut depth) = (false, 0_u32);
    for (at, c) in text.char_indices() {
        match c {
            '\'' => quoted = !quoted,
            '(' if !quoted => depth += 1,
            ')' if !quoted => depth = depth.saturating_sub(1),
            c if c.is_whitespace() && !quoted && depth == 0 => return at,
            _ => {}
        }
    }
    text.len()
}
