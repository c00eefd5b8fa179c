//! Names as they are written in a diagram: how wide they are, and over how many lines a long one goes.

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

/// Columns of a name above a contact before it goes on in the next line.
pub(super) const NAME_COLUMNS_MAX: usize = 16;
/// Columns of what is wired to a pin before it goes on in the next line.
pub(super) const PIN_COLUMNS_MAX: usize = 32;

/// Columns of a text.
pub(super) fn width(text: &str) -> usize {
    UnicodeWidthStr::width(text)
}

/// A name without hidden characters, in as many lines as it needs; no character is left out.
pub(super) fn wrapped(text: &str, columns: usize) -> Vec<String> {
    let text = sieben_model::visible::name(text);
    if text.is_empty() {
        return Vec::new();
    }
    let mut lines = Vec::new();
    let mut rest = text.as_str();
    while width(rest) > columns {
        let (mut used, mut last, mut joint) = (0, 0, None);
        for (at, character) in rest.char_indices() {
            used += character.width().unwrap_or(0);
            if used > columns && at > 0 {
                break;
            }
            last = at + character.len_utf8();
            if matches!(character, '_' | '.' | ' ' | '-' | ',' | '/') {
                joint = Some(last);
            }
        }
        // A joint in the first half would leave most of the line empty.
        let end = joint.filter(|&joint| joint * 2 > last).unwrap_or(last);
        lines.push(rest[..end].to_owned());
        rest = &rest[end..];
        if end == 0 {
            break;
        }
    }
    if !rest.is_empty() {
        lines.push(rest.to_owned());
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_name_goes_over_lines_and_stays_whole() {
        let cases = [
            ("I 0.0", 16, &["I 0.0"][..]),
            ("", 16, &[]),
            ("Conveyor_Left_Motor_Running", 16, &["Conveyor_Left_", "Motor_Running"]),
            ("ABCDEFGHIJKLMNOPQRSTUVWXYZ", 10, &["ABCDEFGHIJ", "KLMNOPQRST", "UVWXYZ"]),
            ("水泵启动按钮", 8, &["水泵启动", "按钮"]),
            ("水", 1, &["水"]),
            ("a\u{1b}[2J", 16, &["a␛[2J"]),
        ];
        for (text, columns, wanted) in cases {
            assert_eq!(wrapped(text, columns), wanted, "{text}");
        }
    }
}
