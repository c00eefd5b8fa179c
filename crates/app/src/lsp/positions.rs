//! Places in a text: bytes, and lines with columns as a client counts them.

use lsp_types::{Position, Range};

/// How a client counts the columns of a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Columns {
    /// Bytes of UTF-8.
    Utf8,
    /// Units of UTF-16, as every client can.
    #[default]
    Utf16,
}

/// Where the lines of a text begin. A line ends with LF, CR LF or CR.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Lines {
    starts: Vec<u32>,
}

impl Lines {
    /// Looks through a text.
    pub(super) fn of(text: &str) -> Self {
        let mut starts = vec![0];
        let bytes = text.as_bytes();
        for (at, byte) in bytes.iter().enumerate() {
            let ends = match byte {
                b'\n' => true,
                b'\r' => bytes.get(at + 1) != Some(&b'\n'),
                _ => false,
            };
            if ends {
                starts.push(u32::try_from(at + 1).unwrap_or(u32::MAX));
            }
        }
        Self { starts }
    }

    /// The line of a byte, from 0.
    pub(super) fn line_of(&self, byte: usize) -> usize {
        self.starts.partition_point(|&start| start as usize <= byte).saturating_sub(1)
    }

    /// The bytes of a line, without its end; those at the end of the text if there is no such line.
    pub(super) fn bytes(&self, text: &str, line: usize) -> (usize, usize) {
        let Some(&start) = self.starts.get(line) else { return (text.len(), text.len()) };
        let start = (start as usize).min(text.len());
        let next = self.starts.get(line + 1).map_or(text.len(), |&next| (next as usize).min(text.len()));
        let body = text.get(start..next).unwrap_or_default();
        let body = body.strip_suffix('\n').unwrap_or(body);
        let body = body.strip_suffix('\r').unwrap_or(body);
        (start, start + body.len())
    }

    /// The byte of a position. Past the end of a line is its end, past the last line the end of the text; inside of a character is its
    /// beginning.
    pub(super) fn byte(&self, text: &str, position: Position, columns: Columns) -> usize {
        let line = position.line as usize;
        let (start, end) = self.bytes(text, line);
        let body = text.get(start..end).unwrap_or_default();
        let wanted = position.character as usize;
        match columns {
            Columns::Utf8 => start + floor(body, wanted.min(body.len())),
            Columns::Utf16 if body.is_ascii() => start + wanted.min(body.len()),
            Columns::Utf16 => {
                let mut units = 0;
                for (at, character) in body.char_indices() {
                    units += character.len_utf16();
                    if units > wanted {
                        return start + at;
                    }
                }
                end
            }
        }
    }

    /// The position of a byte.
    pub(super) fn position(&self, text: &str, byte: usize, columns: Columns) -> Position {
        let byte = floor(text, byte.min(text.len()));
        let line = self.line_of(byte);
        let (start, end) = self.bytes(text, line);
        let before = text.get(start..byte.min(end)).unwrap_or_default();
        Position::new(u32::try_from(line).unwrap_or(u32::MAX), length(before, columns))
    }

    /// The range of bytes.
    pub(super) fn range(&self, text: &str, start: usize, end: usize, columns: Columns) -> Range {
        Range::new(self.position(text, start, columns), self.position(text, end.max(start), columns))
    }
}

/// How long a piece of a line is for a client.
pub(super) fn length(text: &str, columns: Columns) -> u32 {
    let length = match columns {
        Columns::Utf8 => text.len(),
        Columns::Utf16 if text.is_ascii() => text.len(),
        Columns::Utf16 => text.chars().map(char::len_utf16).sum(),
    };
    u32::try_from(length).unwrap_or(u32::MAX)
}

/// The beginning of the character that a byte lies in.
pub(super) fn floor(text: &str, mut byte: usize) -> usize {
    byte = byte.min(text.len());
    while !text.is_char_boundary(byte) {
        byte -= 1;
    }
    byte
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "a\r\nTür 😀b\rc\u{2028}d\n\r\n";

    #[test]
    fn a_line_ends_with_lf_cr_lf_or_cr() {
        let lines = Lines::of(TEXT);
        let all: Vec<&str> = (0..lines.starts.len()).map(|line| lines.bytes(TEXT, line)).map(|(start, end)| &TEXT[start..end]).collect();
        assert_eq!(all, ["a", "Tür 😀b", "c\u{2028}d", "", ""]);
        assert_eq!(Lines::of("").starts.len(), 1);
    }

    #[test]
    fn a_position_and_its_byte_are_the_same_place() {
        let lines = Lines::of(TEXT);
        for columns in [Columns::Utf8, Columns::Utf16] {
            for (byte, _) in TEXT.char_indices() {
                let position = lines.position(TEXT, byte, columns);
                let back = lines.byte(TEXT, position, columns);
                // The end of a line is one place, however many bytes it has.
                assert!(back == byte || TEXT[back..byte].bytes().all(|byte| byte == b'\r'), "{byte} {columns:?}");
            }
        }
        assert_eq!(lines.position(TEXT, TEXT.find('b').unwrap_or(0), Columns::Utf16), Position::new(1, 6));
        assert_eq!(lines.position(TEXT, TEXT.find('b').unwrap_or(0), Columns::Utf8), Position::new(1, 9));
    }

    #[test]
    fn a_position_out_of_range_is_the_nearest_one() {
        let lines = Lines::of(TEXT);
        let smiley = TEXT.find('😀').unwrap_or(0);
        for (line, character, columns, expected) in [
            (0, 99, Columns::Utf16, 1),
            (99, 0, Columns::Utf16, TEXT.len()),
            (u32::MAX, u32::MAX, Columns::Utf8, TEXT.len()),
            // Inside of a pair, and inside of a character.
            (1, 5, Columns::Utf16, smiley),
            (1, 6, Columns::Utf8, smiley),
            (1, 2, Columns::Utf8, 4),
        ] {
            assert_eq!(lines.byte(TEXT, Position::new(line, character), columns), expected, "{line}:{character} {columns:?}");
        }
    }
}
