//! Statements → diagrams, by the grammar of what LAD and FBD can show.

mod boxes;
pub mod compare;
mod logic;
pub mod notation;
mod prepare;
mod rung;

use std::collections::BTreeSet;

use super::boxes::COMPARISONS;
use super::model::{Content, Network};
pub use super::pin_types::Class;
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
    /// The statement before the network ends a string of logic, so that the first check begins a new one.
    fn begins_fresh(&self) -> bool;
    /// Another network reads this bit of local data before it writes it.
    fn is_read_elsewhere(&self, bit: u32) -> bool;
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
    let refusal = match read(statements, around, Mode::Strict).and_then(within_limits) {
        Ok(reading) => return without_rewriting(reading, statements, around, scratch),
        Err(refusal) => refusal,
    };
    let rewritten = read(statements, around, mode.max(Mode::Rewriting)).and_then(within_limits);
    // What is read with rewrites only, and needs none of them, is not understood.
    let rewritten = rewritten.ok().filter(|reading| !reading.rewrites.is_empty());
    match rewritten.and_then(|reading| safe(reading, statements, around, scratch)) {
        Some(reading) => Answer::Equivalent(reading, Some(refusal)),
        None => Answer::No(refusal),
    }
}

/// The answer for statements that are read as they are.
fn without_rewriting(mut reading: Reading, statements: &[Statement], around: &dyn Surroundings, scratch: u32) -> Answer {
    if reading.rewrites.is_empty() {
        let Some(network) = reading.networks.first() else { return Answer::Exact(Network::default()) };
        let is_empty = statements.is_empty() && network.content == Content::Empty;
        let difference = match is_empty {
            true => Some(BTreeSet::new()),
            false => compare::difference(statements, &write(network, scratch, &mut 0).statements, around),
        };
        match difference {
            Some(codes) if codes.is_empty() => return Answer::Exact(reading.networks.swap_remove(0)),
            Some(codes) => reading.rewrites = codes,
            // Every statement was read for what it does: what is left are brackets and checks written in another way.
            None => {
                reading.rewrites.insert(Rewrite::Brackets);
            }
        }
    }
    let start = reading.starts.first().copied().unwrap_or(0);
    match safe(reading, statements, around, scratch) {
        Some(reading) => Answer::Equivalent(reading, None),
        None => Answer::No(Refusal::new(Reason::Carried, start)),
    }
}

/// The bits of local data that statements store.
fn stored(statements: &[Statement], around: &dyn Surroundings) -> Vec<u32> {
    statements.iter().filter(|one| one.mnemonic == "=").filter_map(|one| around.scratch(&one.operand)).collect()
}

/// The reading, if none of its rewrites can be seen from outside of the network; it says so if the bits of T-branches and pins are others
/// when the diagrams are written.
fn safe(mut reading: Reading, statements: &[Statement], around: &dyn Surroundings, scratch: u32) -> Option<Reading> {
    let before = stored(statements, around);
    let write_one = |network| stored(&write(network, scratch, &mut 0).statements, around);
    let after: Vec<u32> = reading.networks.iter().flat_map(write_one).collect();
    if !before.is_empty() && before != after && !reading.rewrites.contains(&Rewrite::NamedBranch) {
        reading.rewrites.insert(Rewrite::Renumber);
    }
    let has = |rewrite: Rewrite| reading.rewrites.contains(&rewrite);
    let parts: Vec<&[Statement]> = reading
        .starts
        .iter()
        .enumerate()
        .map(|(index, start)| {
            let end = reading.starts.get(index + 1).copied().unwrap_or(statements.len());
            statements.get(*start..end.max(*start)).unwrap_or_default()
        })
        .collect();
    // Where the RLO is carried in, only marks and placeholders do not touch it.
    let harmless = [Rewrite::Placeholder, Rewrite::Marks, Rewrite::Renumber];
    let carried = !around.begins_fresh() && reading.rewrites.iter().any(|rewrite| !harmless.contains(rewrite));
    let after_save = parts.iter().rev().skip(1).any(|part| carries(part) == Some(true));
    let branch_result =
        around.branch_result_matters() && (has(Rewrite::TwoMoves) || has(Rewrite::Brackets) && writes_branch_result(statements));
    // Bits of local data that something else reads stay where they are.
    let moved = has(Rewrite::Renumber) && before.iter().chain(&after).any(|bit| around.is_read_elsewhere(*bit));
    let parted = has(Rewrite::Split) && parts.iter().any(|part| !reads_before_writing(part, around).is_empty());
    (!carried && !after_save && !branch_result && !moved && !parted).then_some(reading)
}

/// Whether after these statements the next check goes on with their string of logic; `None` if they leave it as it was.
pub fn carries(statements: &[Statement]) -> Option<bool> {
    // What is not named here leaves the string as it is.
    let step = |one: &Statement| match one.mnemonic {
        "=" | "S" | "R" | "CU" | "CD" | "SP" | "SE" | "SD" | "SS" | "SF" | "FR" | "JC" | "JCN" | "JNB" | "JCB" | "JU" | "BEC" | "BEU"
        | "CC" | "UC" | "CALL" | "MCR(" | ")MCR" | "SET" | "CLR" => Some(false),
        // `O x` is a check, a bare `O` waits for one.
        "A" | "AN" | "O" | "ON" | "X" | "XN" | ")" | "NOT" | "FP" | "FN" => Some(true),
        name if COMPARISONS.contains(&name) => Some(true),
        _ => None,
    };
    statements.iter().rev().find_map(step)
}

/// Something among the statements stores the branch result.
fn writes_branch_result(statements: &[Statement]) -> bool {
    statements.iter().any(|one| matches!(one.mnemonic, "SAVE" | "JNB" | "JCB"))
}

/// The bits of local data that the statements read before they write them.
pub fn reads_before_writing(statements: &[Statement], around: &dyn Surroundings) -> BTreeSet<u32> {
    let (mut written, mut read) = (BTreeSet::new(), BTreeSet::new());
    for one in statements {
        let operands = std::iter::once(&one.operand).chain(one.parameters.iter().map(|parameter| &parameter.actual));
        for bit in operands.filter_map(|operand| around.scratch(operand)) {
            match one.mnemonic {
                "=" => {
                    written.insert(bit);
                }
                _ if !written.contains(&bit) => {
                    read.insert(bit);
                }
                _ => {}
            }
        }
    }
    read
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
