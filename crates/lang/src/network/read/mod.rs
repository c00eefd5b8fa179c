//! Statements → diagrams, by the grammar of what LAD and FBD can show.

mod boxes;
pub mod compare;
mod logic;
mod prepare;
mod rung;

use std::collections::BTreeSet;

use super::model::{Content, Network};
use super::reasons::{Reason, Refusal, Rewrite};
use super::rules;
use super::statement::Statement;
use super::write::write;
use rung::{Named, Reader};

/// What is known of the block that a network stands in.
pub trait Surroundings {
    /// The number of a bit of local data that no variable names: its byte times 8, and the bit.
    fn scratch(&self, operand: &str) -> Option<u32>;
    /// A temporary variable of type BOOL that only this network touches.
    fn is_temporary(&self, operand: &str) -> bool;
    /// What an operand is, if it is known.
    fn class(&self, operand: &str) -> Class;
    /// Two operands may share memory.
    fn overlap(&self, left: &str, right: &str) -> bool;
    /// After the network something reads the branch result before it is written, or the caller of the block may.
    fn branch_result_matters(&self) -> bool;
}

/// What an operand is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// A timer.
    Timer,
    /// A counter.
    Counter,
    /// Something of so many bits.
    Bits(u8),
    /// Not known, or a constant that fits any width.
    Unknown,
}

/// Whether statements are rewritten where they do not fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Mode {
    /// Nothing is rewritten that needs another statement.
    Strict,
    /// What keeps the meaning is rewritten.
    Rewriting,
    /// Constants of the RLO are rewritten as well, which makes elements that no one draws.
    RewritingConstants,
}

/// Diagrams, and which rewrites made them.
#[derive(Clone, Debug)]
pub struct Reading {
    /// One, or more after [`Rewrite::Split`].
    pub networks: Vec<Network>,
    /// The statement, counted from 0, that each of them begins with.
    pub starts: Vec<usize>,
    /// The rewrites.
    pub rewrites: BTreeSet<Rewrite>,
}

/// Whether statements can be drawn.
#[derive(Clone, Debug)]
pub enum Answer {
    /// Writing the diagram gives the same statements.
    Exact(Network),
    /// The diagrams mean the same; with the reason why the statements as they are cannot be drawn, if there is one.
    Equivalent(Reading, Option<Refusal>),
    /// They stay STL.
    No(Refusal),
}

/// Draws the statements of a network. `scratch` is the first free bit of local data of the block.
pub fn draw(statements: &[Statement], around: &dyn Surroundings, scratch: u32, mode: Mode) -> Answer {
    let strict = read(statements, around, Mode::Strict);
    let strict = strict.and_then(within_limits);
    let refusal = match strict {
        Ok(mut reading) => {
            let Some(network) = reading.networks.first() else { return Answer::Exact(Network::default()) };
            let written = write(network, scratch, &mut 0).statements;
            let is_empty = statements.is_empty() && network.content == Content::Empty;
            let difference = if is_empty { Some(BTreeSet::new()) } else { compare::difference(statements, &written, around) };
            if reading.rewrites.is_empty() {
                match difference {
                    Some(codes) if codes.is_empty() => return Answer::Exact(reading.networks.swap_remove(0)),
                    Some(codes) => reading.rewrites = codes,
                    // Every statement was read for what it does: what is left are brackets and checks written in another way.
                    None => {
                        reading.rewrites.insert(Rewrite::Brackets);
                    }
                }
            }
            return Answer::Equivalent(renumbered(reading, statements, around, scratch), None);
        }
        Err(refusal) => refusal,
    };
    match read(statements, around, mode.max(Mode::Rewriting)).and_then(within_limits) {
        Ok(reading) => Answer::Equivalent(renumbered(reading, statements, around, scratch), Some(refusal)),
        Err(_) => Answer::No(refusal),
    }
}

/// Says so if the bits of T-branches and pins are others when the diagrams are written.
fn renumbered(mut reading: Reading, statements: &[Statement], around: &dyn Surroundings, scratch: u32) -> Reading {
    let bits = |statements: &[Statement]| -> Vec<u32> {
        statements.iter().filter(|one| one.mnemonic == "=").filter_map(|one| around.scratch(&one.operand)).collect()
    };
    let before = bits(statements);
    let after: Vec<u32> = reading.networks.iter().flat_map(|network| bits(&write(network, scratch, &mut 0).statements)).collect();
    if !before.is_empty() && before != after && !reading.rewrites.contains(&Rewrite::NamedBranch) {
        reading.rewrites.insert(Rewrite::Renumber);
    }
    reading
}

/// What the text forms can hold: a diagram that is written down must be read again.
fn within_limits(reading: Reading) -> Result<Reading, Refusal> {
    for (network, start) in reading.networks.iter().zip(&reading.starts) {
        if let Some(limit) = rules::limit(network) {
            let reason = if limit == rules::Limit::Elements { Reason::Size } else { Reason::Depth };
            return Err(Refusal::new(reason, *start));
        }
    }
    Ok(reading)
}

/// Reads the statements of a network. With [`Mode::Strict`] they make one diagram.
///
/// # Errors
///
/// The first statement that does not fit, and why.
pub fn read(statements: &[Statement], around: &dyn Surroundings, mode: Mode) -> Result<Reading, Refusal> {
    let prepared = prepare::prepare(statements, around, mode)?;
    let branches = networks(Reader::new(&prepared, around, mode, Named::Branches));
    match branches {
        Err(_) if mode > Mode::Strict => networks(Reader::new(&prepared, around, mode, Named::Midlines)),
        other => other,
    }
}

fn networks(mut reader: Reader<'_>) -> Result<Reading, Refusal> {
    let (mut networks, mut starts) = (Vec::new(), Vec::new());
    loop {
        starts.push(reader.original(reader.at));
        networks.push(reader.network()?);
        if reader.ended() {
            break;
        }
        let labelled = reader.current().is_some_and(|one| one.label.is_some());
        let reason = match reader.peek() {
            ")" => Reason::Bracket,
            _ if labelled => Reason::Label,
            _ => Reason::Two,
        };
        if reader.mode == Mode::Strict || reason == Reason::Bracket {
            return reader.here(reason);
        }
        if !labelled && reader.skip_placeholders() {
            break;
        }
        reader.rewrite(Rewrite::Split);
    }
    reader.check_labels()?;
    Ok(Reading { networks, starts, rewrites: reader.rewrites })
}
