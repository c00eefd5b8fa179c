//! Seven-segment digits out of block characters.

/// Rows of a digit.
pub(crate) const HEIGHT: usize = 5;
/// Columns of a digit, with the gap behind it.
pub(crate) const WIDTH: usize = 6;

/// The segments of 0 to 9 and the dash of a nibble that is no digit, in the order a b c d e f g.
const SEGMENTS: [&[u8; 7]; 11] =
    [b"1111110", b"0110000", b"1101101", b"1111001", b"0110011", b"1011011", b"1011111", b"1110000", b"1111111", b"1111011", b"0000001"];

/// A cell of the display.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cell {
    /// Between the segments.
    Gap,
    /// A segment without light.
    Dark,
    /// A segment with light.
    Lit,
}

/// The cells of one row of a digit; `None` is a digit without any light, as leading zeros are.
pub(crate) fn row(digit: Option<u8>, row: usize) -> [Cell; WIDTH] {
    let segments = digit.map(|digit| SEGMENTS[usize::from(digit.min(10))]);
    let cell = |segment: usize| match segments {
        Some(segments) if segments[segment] == b'1' => Cell::Lit,
        _ => Cell::Dark,
    };
    // A corner has light if one of its two segments has.
    let corner = |a: usize, b: usize| if cell(a) == Cell::Lit { Cell::Lit } else { cell(b) };
    let [a, b, c, d, e, f, g] = [0, 1, 2, 3, 4, 5, 6];
    match row {
        0 => [corner(a, f), cell(a), cell(a), cell(a), corner(a, b), Cell::Gap],
        1 => [cell(f), Cell::Gap, Cell::Gap, Cell::Gap, cell(b), Cell::Gap],
        2 => {
            let (left, right) = (if cell(f) == Cell::Lit { f } else { e }, if cell(b) == Cell::Lit { b } else { c });
            [corner(g, left), cell(g), cell(g), cell(g), corner(g, right), Cell::Gap]
        }
        3 => [cell(e), Cell::Gap, Cell::Gap, Cell::Gap, cell(c), Cell::Gap],
        _ => [corner(d, e), cell(d), cell(d), cell(d), corner(d, c), Cell::Gap],
    }
}

/// The four digits of a BCD word; leading zeros are dark, a nibble above 9 is a dash.
pub(crate) fn of_word(word: u16) -> [Option<u8>; 4] {
    let nibbles = [12, 8, 4, 0].map(|shift| (word >> shift & 0xF) as u8);
    let mut leading = true;
    let mut position = 0;
    nibbles.map(|nibble| {
        position += 1;
        leading &= nibble == 0 && position < 4;
        (!leading).then_some(nibble)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(digit: Option<u8>) -> String {
        (0..HEIGHT)
            .map(|index| row(digit, index).map(|cell| if cell == Cell::Lit { '█' } else { ' ' }).iter().collect::<String>() + "\n")
            .collect()
    }

    #[test]
    fn digits_look_like_digits() {
        assert_eq!(picture(Some(2)), "█████ \n    █ \n█████ \n█     \n█████ \n");
        assert_eq!(picture(Some(4)), "█   █ \n█   █ \n█████ \n    █ \n    █ \n");
        assert_eq!(picture(Some(1)), "    █ \n    █ \n    █ \n    █ \n    █ \n");
        assert_eq!(picture(None), "      \n".repeat(HEIGHT));
    }

    #[test]
    fn leading_zeros_are_dark() {
        assert_eq!(of_word(0x0025), [None, None, Some(2), Some(5)]);
        assert_eq!(of_word(0x0000), [None, None, None, Some(0)]);
        assert_eq!(of_word(0x1A05), [Some(1), Some(10), Some(0), Some(5)]);
    }
}
