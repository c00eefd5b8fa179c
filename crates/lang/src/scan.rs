//! Where words, blanks and pointers end: what the lexers of all languages share.

use sieben_model::literal::any_type_code;

/// Whether a character can stand inside a word.
pub(crate) fn in_word(character: char) -> bool {
    character == '_' || character.is_alphanumeric()
}

/// Whether a character is a blank, but no end of a line.
pub(crate) fn is_blank(character: char) -> bool {
    // The last one is the end mark of DOS, which old tools still write.
    matches!(character, ' ' | '\t' | '\u{feff}' | '\u{a0}' | '\u{1a}')
}

/// The signs that a sign of typesetting stands for.
pub(crate) fn typeset_sign(sign: char) -> Option<&'static str> {
    Some(match sign {
        '≥' | '⩾' | '≧' => ">=",
        '≤' | '⩽' | '≦' => "<=",
        '≠' => "<>",
        '≔' => ":=",
        '⇒' | '→' => "=>",
        '×' | '·' | '⋅' | '∗' => "*",
        '÷' | '∕' | '⁄' => "/",
        '−' | '–' | '—' | '‐' | '‑' => "-",
        '＝' => "=",
        _ => return None,
    })
}

/// The straight quote that a quote of typesetting stands for.
pub(crate) fn straight_quote(quote: char) -> Option<char> {
    match quote {
        '‘' | '’' | '‚' | '‛' | '′' | '´' => Some('\''),
        '“' | '”' | '„' | '‟' | '″' | '«' | '»' => Some('"'),
        _ => None,
    }
}

/// The byte behind the characters that belong together, from byte `start` on.
pub(crate) fn while_in(text: &str, start: usize, belongs: impl Fn(char) -> bool) -> usize {
    let rest = &text[start..];
    start + rest.find(|character| !belongs(character)).unwrap_or(rest.len())
}

/// Whether the closing quote of a text is escaped; `text` has both its quotes.
pub(crate) fn ends_in_escape(text: &str) -> bool {
    text[1..text.len() - 1].bytes().rev().take_while(|&byte| byte == b'$').count() % 2 == 1
}

/// The byte behind a pointer: `P#1.0`, `P#M 1.0`, `P#DB10.DBX 12.0 REAL 20`; `start` is behind the `#`.
pub(crate) fn pointer(text: &str, start: usize) -> usize {
    let bytes = text.as_bytes();
    let blanks = |at: usize| while_in(text, at, |c| matches!(c, ' ' | '\t'));
    let mut end = start;
    let mut at = blanks(start);
    loop {
        let run = while_in(text, at, |c| in_word(c) || c == '.');
        if run == at {
            return end;
        }
        end = run;
        at = blanks(end);
        let complete = bytes[end - 1].is_ascii_digit();
        if complete || !bytes.get(at).is_some_and(u8::is_ascii_digit) {
            break;
        }
    }
    let type_end = while_in(text, at, in_word);
    let count = blanks(type_end);
    let known = any_type_code(&text[at..type_end]).is_some();
    if known && count > type_end && bytes.get(count).is_some_and(u8::is_ascii_digit) {
        end = while_in(text, count, |c| c.is_ascii_digit());
    }
    end
}
