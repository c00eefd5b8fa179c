//! The networks of the bodies of a source, for those who draw them.

use std::collections::HashMap;
use std::ops::Range;

use sieben_model::source::{FileId, Span};

use super::Language;
use super::read;
use crate::network::flavour::Drawing;
use crate::network::model::Network;
use crate::st::ast::{Block, Item};
use crate::st::declare::expand;
use crate::st::dialect::Dialect;
use crate::st::lexer::{Raw, Token};
use crate::st::parser::parse;

/// A network of a body.
#[derive(Clone, Debug)]
pub struct DrawnNetwork {
    /// The full name of the block, as its source has it: `Plant.Pump`, `Pump.Start` for a method; empty for a body without one.
    pub block: String,
    /// Its number in the block, from 1: an action that is a part of its block goes on counting.
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
    let bodies = bodies(parsed.tokens(), text);
    // Methods and actions as the blocks that they are compiled to.
    let expanded = expand(parsed.file);
    let mut blocks = Vec::new();
    collect(&expanded.items, "", &mut blocks);
    let mut counted: HashMap<String, u32> = HashMap::new();
    let mut out = Vec::new();
    for (body, word) in bodies {
        let inside = |(_, block): &&(String, &Block)| block.span.start as usize <= body.start && body.end <= block.span.end as usize;
        let block = blocks.iter().filter(inside).min_by_key(|(_, block)| block.span.end - block.span.start);
        let name = block.map_or_else(String::new, |(name, _)| name.clone());
        let number = counted.entry(name.to_lowercase()).or_default();
        for written in read::networks(text, body.clone(), word).networks {
            *number += 1;
            let head = text.get(written.place.first as usize..written.place.last as usize).unwrap_or_default();
            let below = text.get(written.place.last as usize..body.end).unwrap_or_default();
            let (title, comment) = head_of(head, below);
            out.push(DrawnNetwork {
                block: name.clone(),
                number: *number,
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

/// The bodies of a source that are diagrams, each with the word that it began with.
fn bodies(tokens: &[Token], text: &str) -> Vec<(Range<usize>, Language)> {
    let mut word = Language::Ladder;
    let mut bodies = Vec::new();
    for token in tokens {
        let place = token.start as usize..token.end as usize;
        word = text.get(place.clone()).and_then(Language::of).unwrap_or(word);
        if token.raw == Raw::Diagram {
            bodies.push((place, word));
        }
    }
    bodies
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

/// All blocks with their full names; methods and actions are blocks of their own.
fn collect<'i>(items: &'i [Item], namespace: &str, blocks: &mut Vec<(String, &'i Block)>) {
    for item in items {
        match item {
            Item::Block(block) => blocks.push((format!("{namespace}{}", block.name.text), block)),
            Item::Namespace(inner) => {
                let names: Vec<&str> = inner.name.names.iter().map(|name| name.text.as_str()).collect();
                collect(&inner.items, &format!("{namespace}{}.", names.join(".")), blocks);
            }
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

    fn blocks_of(text: &str, dialect: Dialect) -> Vec<String> {
        networks(FileId(0), text, dialect).iter().map(|one| format!("{} {}", one.block, one.number)).collect()
    }

    const BODY: &str = "LD\nNETWORK\n    NO a\n    COIL b\n";

    #[test]
    fn networks_of_members_belong_to_them() {
        let block = |temporary: &str| {
            format!(
                "FUNCTION_BLOCK Pump\nVAR a, b : BOOL; END_VAR\n{temporary}METHOD Go\n{BODY}NETWORK\n    NO b\n    COIL a\nEND_METHOD\n\
                 ACTION Reset:\n{BODY}END_ACTION\n{BODY}END_FUNCTION_BLOCK\n"
            )
        };
        assert_eq!(blocks_of(&block(""), Dialect::Codesys), ["Pump.Go 1", "Pump.Go 2", "Pump.Reset 1", "Pump 1"]);
        // Such an action has no block of its own: its networks are counted with those of the body.
        let with_temporary = blocks_of(&block("VAR_TEMP t : BOOL; END_VAR\n"), Dialect::Codesys);
        assert_eq!(with_temporary, ["Pump.Go 1", "Pump.Go 2", "Pump 1", "Pump 2"]);
    }

    #[test]
    fn blocks_of_a_namespace_have_its_name() {
        let text =
            format!("NAMESPACE Plant.West\nFUNCTION_BLOCK Pump\nVAR a, b : BOOL; END_VAR\n{BODY}END_FUNCTION_BLOCK\nEND_NAMESPACE\n");
        assert_eq!(blocks_of(&text, Dialect::Iec), ["Plant.West.Pump 1"]);
    }
}
