//! The networks of the bodies of a source, for those who draw them.

use sieben_model::source::{FileId, Span};

use super::Language;
use super::read;
use crate::network::flavour::Drawing;
use crate::network::model::Network;
use crate::st::ast::{Block, Item};
use crate::st::dialect::Dialect;
use crate::st::lexer::Raw;
use crate::st::parser::parse;

/// A network of a body.
#[derive(Clone, Debug)]
pub struct DrawnNetwork {
    /// The name of the block, as its source has it; empty for a body without one.
    pub block: String,
    /// Its number in the body, from 1.
    pub number: u32,
    /// TITLE.
    pub title: String,
    /// The comment under the title, one line each.
    pub comment: String,
    /// What it draws; the places of its elements are bytes of the source.
    pub network: Network,
    /// What it is drawn in.
    pub drawing: Drawing,
    /// Its first line.
    pub span: Span,
}

/// The networks of all bodies of a source that are diagrams, in the order of the text.
pub fn networks(file: FileId, text: &str, dialect: Dialect) -> Vec<DrawnNetwork> {
    let parsed = parse(file, text, dialect);
    let mut blocks = Vec::new();
    collect(&parsed.file.items, &mut blocks);
    let mut out = Vec::new();
    let mut word = Language::Ladder;
    for token in parsed.tokens() {
        let written = text.get(token.start as usize..token.end as usize).unwrap_or_default();
        word = Language::of(written).unwrap_or(word);
        if token.raw != Raw::Diagram {
            continue;
        }
        let inside = |block: &&&Block| block.span.start <= token.start && token.end <= block.span.end;
        let block = blocks.iter().filter(inside).min_by_key(|block| block.span.end - block.span.start);
        let name = block.map_or_else(String::new, |block| block.name.text.clone());
        for (written, number) in read::networks(text, token.start as usize..token.end as usize, word).networks.into_iter().zip(1..) {
            let head = text.get(written.place.first as usize..written.place.last as usize).unwrap_or_default();
            let below = text.get(written.place.last as usize..token.end as usize).unwrap_or_default();
            let (title, comment) = head_of(head, below);
            out.push(DrawnNetwork {
                block: name.clone(),
                number,
                title,
                comment,
                network: written.network,
                drawing: written.language.drawing(),
                span: Span::new(file, written.place.first, written.place.last),
            });
        }
    }
    out
}

/// Title and comment of a network.
fn head_of(head: &str, below: &str) -> (String, String) {
    let lines = head.lines().map(str::trim);
    let title = lines.clone().find_map(|line| {
        let (word, title) = line.split_once('=')?;
        word.trim().eq_ignore_ascii_case("TITLE").then(|| title.trim().to_owned())
    });
    let below = below.lines().map(str::trim).take_while(|line| line.starts_with("//"));
    let comments: Vec<&str> = lines.chain(below).filter_map(|line| line.strip_prefix("//")).map(str::trim).collect();
    (title.unwrap_or_default(), comments.join("\n"))
}

fn collect<'i>(items: &'i [Item], blocks: &mut Vec<&'i Block>) {
    for item in items {
        match item {
            Item::Block(block) => blocks.push(block),
            Item::Namespace(namespace) => collect(&namespace.items, blocks),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_network_is_found_with_its_block_and_its_head() {
        let text = "PROGRAM Main\nVAR a, b : BOOL; END_VAR\nLD\nNETWORK\nTITLE = One\n// why\n    NO a\n    COIL b\nNETWORK FBD\n    NO b\n    COIL a\nEND_PROGRAM\n";
        let all = networks(FileId(0), text, Dialect::Iec);
        let seen: Vec<_> =
            all.iter().map(|one| (one.block.as_str(), one.number, one.title.as_str(), one.comment.as_str(), one.drawing)).collect();
        assert_eq!(seen, [("Main", 1, "One", "why", Drawing::Lad), ("Main", 2, "", "", Drawing::Fbd)]);
    }
}
