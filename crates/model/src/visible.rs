//! Characters that would command a terminal or turn the order of a text around, shown as what they are.
//!
//! Names and sources come from strangers: what stands in them is shown and never obeyed.

use std::borrow::Cow;

/// Whether a character acts instead of being seen: controls but for line ends and tabs, marks of writing direction, other line ends.
pub fn is_hidden(character: char) -> bool {
    match character {
        '\n' | '\t' => false,
        '\u{61C}' | '\u{200E}' | '\u{200F}' | '\u{2028}'..='\u{202E}' | '\u{2066}'..='\u{2069}' => true,
        _ => character.is_control(),
    }
}

/// Writes a hidden character as text: `␛`, or `<U+202E>` where no picture of it exists.
pub fn push(out: &mut String, character: char) {
    /// The pictures of the first 32 characters stand in their order.
    const PICTURES: u32 = 0x2400;
    let number = u32::from(character);
    match number {
        0..=0x1F => out.push(char::from_u32(PICTURES + number).unwrap_or(char::REPLACEMENT_CHARACTER)),
        0x7F => out.push('␡'),
        _ => out.push_str(&format!("<U+{number:04X}>")),
    }
}

/// A text with its hidden characters shown; the carriage return of a line end stays.
///
/// ```
/// use sieben_model::visible::visible;
/// assert_eq!(visible("a\u{1B}[2Jb\u{202E}c\r\nd\re"), "a␛[2Jb<U+202E>c\r\nd␍e");
/// ```
pub fn visible(text: &str) -> Cow<'_, str> {
    let mut out = String::new();
    let mut done = 0;
    for (at, character) in hidden(text) {
        out.push_str(&text[done..at]);
        push(&mut out, character);
        done = at + character.len_utf8();
    }
    if done == 0 {
        return Cow::Borrowed(text);
    }
    out.push_str(&text[done..]);
    Cow::Owned(out)
}

/// A name with its hidden characters shown, line ends and tabs among them: it stands in a sentence, and begins no line.
///
/// ```
/// assert_eq!(sieben_model::visible::name("a\n::error::b"), "a␊::error::b");
/// ```
pub fn name(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match is_hidden(character) || matches!(character, '\n' | '\t') {
            true => push(&mut out, character),
            false => out.push(character),
        }
    }
    out
}

/// The hidden characters of a text and where they stand.
pub fn hidden(text: &str) -> impl Iterator<Item = (usize, char)> {
    let of_line_end = |at: usize| text[at + 1..].starts_with('\n');
    text.char_indices().filter(move |&(at, character)| is_hidden(character) && !(character == '\r' && of_line_end(at)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_shown_hides_nothing_more() {
        for number in 0..0x1_1000 {
            let Some(character) = char::from_u32(number) else { continue };
            let text = format!("a{character}b");
            let shown = visible(&text);
            assert_eq!(hidden(&shown).count(), 0, "{number:X}");
            assert_eq!(shown == text, !is_hidden(character), "{number:X}");
        }
        assert_eq!(visible("ä „x“ \t\r\n"), "ä „x“ \t\r\n");
        assert_eq!(visible("\r"), "␍");
        assert_eq!(visible("\u{9B}31m\u{7F}\0"), "<U+009B>31m␡␀");
    }
}
