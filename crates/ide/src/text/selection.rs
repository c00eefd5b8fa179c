//! What a selection grows to: the word, the operand, the statement, the network, the block.

use rowan::{NodeOrToken, SyntaxNode, TextSize};

use super::{Place, Text, Tree, outline::Row, place_of};

impl Text<'_> {
    /// The places around a byte, each inside of the next one.
    pub fn around(&self, byte: usize) -> Vec<Place> {
        let mut places = match &self.tree {
            Tree::Stl(parsed) => around(&parsed.syntax(), byte),
            Tree::St(parsed) => around(&parsed.syntax(&self.text), byte),
        };
        collect(&self.outline(), byte, &mut places);
        places.sort_by_key(|&(start, end)| (end - start, start));
        places.dedup();
        // What does not lie around the one before it would not be a selection that grows.
        let mut kept: Vec<Place> = Vec::new();
        for place in places {
            if kept.last().is_none_or(|last| place.0 <= last.0 && last.1 <= place.1) {
                kept.push(place);
            }
        }
        kept
    }
}

fn collect(rows: &[Row], byte: usize, places: &mut Vec<Place>) {
    for row in rows.iter().filter(|row| row.whole.0 <= byte && byte <= row.whole.1) {
        places.push(row.whole);
        collect(&row.rows, byte, places);
    }
}

fn around<L: rowan::Language>(root: &SyntaxNode<L>, byte: usize) -> Vec<Place> {
    let end = u32::from(root.text_range().end());
    let at = TextSize::from(u32::try_from(byte).unwrap_or(u32::MAX).min(end));
    // Of two tokens that meet here the one with letters is meant.
    let tokens = root.token_at_offset(at);
    let has_letters = |text: &str| text.chars().any(|c| c.is_alphanumeric() || matches!(c, '"' | '#' | '_'));
    let token = tokens.clone().find(|token| has_letters(token.text())).or_else(|| tokens.left_biased());
    let Some(token) = token else { return vec![place_of(root.text_range())] };
    let mut places = Vec::new();
    if !token.text().trim().is_empty() {
        places.push(place_of(token.text_range()));
    }
    places.extend(token.parent_ancestors().map(|node| trimmed(&node)));
    places.push(place_of(root.text_range()));
    places.retain(|&(start, end)| start <= byte && byte <= end);
    places
}

/// A node without the blanks and line ends around it.
fn trimmed<L: rowan::Language>(node: &SyntaxNode<L>) -> Place {
    let (start, end) = place_of(node.text_range());
    let is_blank = |token: &rowan::SyntaxToken<L>| token.text().trim().is_empty();
    let mut tokens = node.descendants_with_tokens().filter_map(NodeOrToken::into_token).filter(|token| !is_blank(token));
    let first = tokens.next();
    let last = tokens.last().or_else(|| first.clone());
    match (first, last) {
        (Some(first), Some(last)) => (place_of(first.text_range()).0, place_of(last.text_range()).1),
        _ => (start, end),
    }
}
