//! An end of a link as it is written: `station[i+1].IB 0`, `master."Start"`.

use sieben_campaign::spec::Placed;
use sieben_model::source::Span;

/// One end of a link.
#[derive(Clone, Debug, PartialEq)]
pub struct Endpoint {
    /// The controllers.
    pub controller: Placed,
    /// Which of them.
    pub index: Index,
    /// What of it: an address, a symbol, a field of a data block.
    pub name: Placed,
}

/// Which controllers of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Index {
    /// The only one: `master`.
    Only,
    /// This one: `station[3]`.
    At(u32),
    /// Each of them, with so much added to `i`: `station[i]`, `station[i+1]`, `station[i-1]`.
    Each(i64),
}

/// Greatest number that is added to `i`.
const OFFSET_MAX: i64 = u32::MAX as i64;

impl Endpoint {
    /// Reads one.
    ///
    /// # Errors
    /// It is none; the message says what is missing.
    pub fn parse(placed: &Placed) -> Result<Self, String> {
        const HOW: &str = "write a controller, a point, and what of it: `station[i].QB 0`";
        let text = &placed.text;
        let end = text.find(['[', '.']).ok_or_else(|| format!("`{text}` names nothing of a controller; {HOW}"))?;
        let controller = part(placed, 0, end);
        if controller.text.is_empty() {
            return Err(format!("`{text}` begins without a controller; {HOW}"));
        }
        let (index, after) = match text[end..].strip_prefix('[') {
            None => (Index::Only, end),
            Some(rest) => {
                let length = rest.find(']').ok_or_else(|| format!("`{text}` has a `[` without its `]`"))?;
                (index(&rest[..length])?, end + 1 + length + 1)
            }
        };
        let Some(name) = text[after..].trim_start().strip_prefix('.') else {
            return Err(format!("`{text}` does not say what of the controller; {HOW}"));
        };
        let name = part(placed, text.len() - name.len(), text.len());
        if name.text.is_empty() {
            return Err(format!("`{text}` does not say what of the controller; {HOW}"));
        }
        Ok(Self { controller, index, name })
    }
}

/// A part of a string without the spaces around it, at its place.
fn part(placed: &Placed, from: usize, to: usize) -> Placed {
    let slice = &placed.text[from..to];
    let text = slice.trim().to_owned();
    let start = from + (slice.len() - slice.trim_start().len());
    // One that is written with escapes has other bytes in the file.
    let span = if (placed.span.end - placed.span.start) as usize == placed.text.len() {
        Span::new(placed.span.file, placed.span.start + start as u32, placed.span.start + (start + text.len()) as u32)
    } else {
        placed.span
    };
    Placed { text, span }
}

/// What stands in the brackets.
fn index(text: &str) -> Result<Index, String> {
    let compact: String = text.split_whitespace().collect();
    let wrong = || format!("`[{text}]` is no index: write `[i]`, `[i+1]`, `[i-1]` or a number as `[3]`");
    let number = |digits: &str| {
        let all_digits = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
        digits.parse().ok().filter(|&number: &i64| all_digits && number <= OFFSET_MAX).ok_or_else(wrong)
    };
    match compact.strip_prefix('i') {
        Some("") => Ok(Index::Each(0)),
        Some(rest) => match rest.split_at_checked(1) {
            Some(("+", digits)) => number(digits).map(Index::Each),
            Some(("-", digits)) => number(digits).map(|number| Index::Each(-number)),
            _ => Err(wrong()),
        },
        None => number(&compact).map(|number| Index::At(number as u32)),
    }
}

#[cfg(test)]
mod tests {
    use sieben_model::source::FileId;

    use super::*;

    fn parse(text: &str) -> Result<(String, Index, String), String> {
        let placed = Placed { text: text.to_owned(), span: Span::new(FileId(0), 100, 100 + text.len() as u32) };
        let endpoint = Endpoint::parse(&placed)?;
        for part in [&endpoint.controller, &endpoint.name] {
            let (start, end) = (part.span.start as usize - 100, part.span.end as usize - 100);
            assert_eq!(text[start..end], part.text, "a part has its place");
        }
        Ok((endpoint.controller.text, endpoint.index, endpoint.name.text))
    }

    #[test]
    fn controllers_have_a_name_an_index_and_something_of_them() {
        for (text, controller, index, name) in [
            ("station[i].QB 0", "station", Index::Each(0), "QB 0"),
            ("station[i+1].IB 0", "station", Index::Each(1), "IB 0"),
            (" station [ i - 12 ] . Q 0.0 ", "station", Index::Each(-12), "Q 0.0"),
            ("station[3].DB1.speed", "station", Index::At(3), "DB1.speed"),
            ("master.\"Motor on\"", "master", Index::Only, "\"Motor on\""),
            ("Förderer_2.QW 4", "Förderer_2", Index::Only, "QW 4"),
        ] {
            assert_eq!(parse(text), Ok((controller.to_owned(), index, name.to_owned())), "{text}");
        }
    }

    #[test]
    fn what_is_no_end_of_a_link_is_said_to_be_none() {
        for text in [
            "",
            "station",
            ".QB 0",
            "station[i.QB 0",
            "station[i]",
            "station[i].",
            "station[].QB 0",
            "station[j].QB 0",
            "station[i*2].QB 0",
            "station[i+].QB 0",
            "station[-1].QB 0",
            "station[i--1].QB 0",
            "station[99999999999].QB 0",
            "station[i+é].QB 0",
            "[i].QB 0",
        ] {
            assert!(parse(text).is_err(), "{text}");
        }
    }
}
