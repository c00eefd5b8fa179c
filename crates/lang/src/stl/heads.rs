//! The heads of networks in a source that goes into a file with another ending: what they do not say, they have to say there.

use sieben_model::source::FileId;

use super::ast;
use super::mnemonics::notation_after;
use super::parser::parse_as;
use crate::network::flavour::Drawing;

/// The keyword that a network begins with.
const KEYWORD: &str = "NETWORK";

/// The source with the word `LAD`, `FBD` or `STL` at each network that has none, so that it means the same where another one is usual.
/// `drawing` is how its networks are written that do not say it.
pub fn with_words(text: &str, drawing: Option<Drawing>) -> String {
    let parsed = parse_as(FileId(0), text, None, drawing);
    let line_end = if text.contains("\r\n") { "\r\n" } else { "\n" };
    let mut words: Vec<(usize, String)> = Vec::new();
    let mut head = |start: usize, drawing: Option<Drawing>| {
        let word = drawing.map_or("STL", Drawing::word);
        let end = start + KEYWORD.len();
        match text.get(start..end).is_some_and(|keyword| keyword.eq_ignore_ascii_case(KEYWORD)) {
            true if notation_after(text, end) == end => words.push((end, format!(" {word}"))),
            true => {}
            false => {
                let line = text[..start].rfind(['\n', '\r']).map_or(0, |at| at + 1);
                let place = if text[line..start].trim().is_empty() { line } else { start };
                words.push((place, format!("{KEYWORD} {word}{line_end}")));
            }
        }
    };
    for block in &parsed.file.blocks {
        if let Some(start) = start_without_head(block) {
            head(start, None);
        }
        block.networks.iter().for_each(|network| head(network.span.start as usize, network.drawing));
    }
    words.sort_by_key(|word| word.0);
    let mut out = String::with_capacity(text.len() + words.iter().map(|(_, word)| word.len()).sum::<usize>());
    let mut at = 0;
    for (place, word) in words {
        out.push_str(text.get(at..place).unwrap_or_default());
        out.push_str(&word);
        at = place;
    }
    out.push_str(text.get(at..).unwrap_or_default());
    out
}

/// Where the statements begin that stand before the first network of a block; a diagram always is a network.
fn start_without_head(block: &ast::Block) -> Option<usize> {
    let first = block.statements.first()?;
    let has_head = block.networks.first().is_some_and(|network| network.first_statement == 0);
    let label = first.label.as_ref().map_or(first.span.start, |label| label.span.start.min(first.span.start));
    (!has_head).then_some(label as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_network_says_how_it_is_written() {
        for (drawing, source, expected) in [
            (None, "NETWORK\nTITLE = a\nA I 0.0;\n= Q 4.0;\n", "NETWORK STL\nTITLE = a\nA I 0.0;\n= Q 4.0;\n"),
            (None, "// first\n  m1: A I 0.0;\n= Q 4.0;\n", "// first\nNETWORK STL\n  m1: A I 0.0;\n= Q 4.0;\n"),
            (
                None,
                "FUNCTION FC 1 : VOID\nBEGIN A I 0.0; = Q 4.0;\nNETWORK lad\nNO I 0.0\nCOIL Q 4.0\nEND_FUNCTION\n",
                "FUNCTION FC 1 : VOID\nBEGIN NETWORK STL\nA I 0.0; = Q 4.0;\nNETWORK lad\nNO I 0.0\nCOIL Q 4.0\nEND_FUNCTION\n",
            ),
            (
                Some(Drawing::Lad),
                "I 0.0 -> = Q 4.0\r\nI 0.1 -> = Q 4.1\r\n",
                "NETWORK LAD\r\nI 0.0 -> = Q 4.0\r\nNETWORK LAD\r\nI 0.1 -> = Q 4.1\r\n",
            ),
            (
                Some(Drawing::Fbd),
                "OR\n    NO I 0.0\nOR\n    NO I 0.1\nEND\nCOIL Q 4.0\n",
                "NETWORK FBD\nOR\n    NO I 0.0\nOR\n    NO I 0.1\nEND\nCOIL Q 4.0\n",
            ),
            (
                Some(Drawing::Lad),
                "NETWORK STL\nA I 0.0;\n= Q 4.0;\nNETWORK\nNO I 0.0\nCOIL Q 4.1\n",
                "NETWORK STL\nA I 0.0;\n= Q 4.0;\nNETWORK LAD\nNO I 0.0\nCOIL Q 4.1\n",
            ),
        ] {
            assert_eq!(with_words(source, drawing), expected);
        }
    }
}
