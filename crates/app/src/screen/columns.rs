//! Texts in columns of the terminal: a character of a Chinese symbol takes two of them, a combining one none.

use ratatui::text::Span;
use sieben_model::visible::visible;
use unicode_width::UnicodeWidthChar;

/// Columns that a text takes.
pub(super) fn columns(text: &str) -> usize {
    Span::raw(text).width()
}

/// A text in so many columns at most: longer ones end in `…`.
pub(super) fn fitted(text: &str, width: usize) -> String {
    let text = visible(text);
    if columns(&text) <= width {
        return text.into_owned();
    }
    let mut left = width;
    let fits = |character: &char| {
        // One column is for the `…`.
        let room = left.checked_sub(character.width().unwrap_or_default()).filter(|&room| room > 0);
        left = room.unwrap_or_default();
        room.is_some()
    };
    let mut short: String = text.chars().take_while(fits).collect();
    if width > 0 {
        short.push('…');
    }
    short
}

/// A text in exactly so many columns, from the left.
pub(super) fn padded(text: &str, width: usize) -> String {
    let mut text = fitted(text, width);
    let missing = width.saturating_sub(columns(&text));
    text.extend(std::iter::repeat_n(' ', missing));
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_takes_the_columns_it_has() {
        for (text, width, wanted) in [
            ("Motor", 5, "Motor"),
            ("Motor", 4, "Mot…"),
            ("Motor", 1, "…"),
            ("Motor", 0, ""),
            ("漢字の数", 8, "漢字の数"),
            ("漢字の数", 7, "漢字の…"),
            ("漢字の数", 6, "漢字…"),
            ("e\u{301}e\u{301}", 2, "e\u{301}e\u{301}"),
        ] {
            assert_eq!(fitted(text, width), wanted, "{text} in {width}");
        }
        for text in ["漢字の数", "Motor", "", "👩\u{200d}👩\u{200d}👧", "e\u{301}e\u{301}"] {
            for width in 0..12 {
                assert_eq!(columns(&padded(text, width)), width, "{text} in {width}");
            }
        }
    }
}
