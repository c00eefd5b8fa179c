//! What is known of the statements before they are read: which can be refused at once, which brackets match, who reads what.

use std::collections::{HashMap, HashSet};

use super::{Mode, Surroundings};
use crate::network::boxes::{BoxRow, COMPARISONS, TimerKind};
use crate::network::reasons::{Reason, Refusal};
use crate::network::statement::Statement;

/// Statements to read, without the marks that say nothing.
pub(super) struct Prepared<'s> {
    pub(super) statements: Vec<&'s Statement>,
    /// Where each of them stands in the network, counted from 0.
    pub(super) originals: Vec<usize>,
    /// For each opening bracket the closing one.
    pub(super) closing: Vec<Option<usize>>,
    /// Labels, and where they stand.
    pub(super) labels: HashMap<&'s str, usize>,
    /// Bits of local data that are actual parameters of calls.
    pub(super) handed_over: HashSet<u32>,
    /// The last statement that reads an operand as a bit.
    pub(super) last_read: HashMap<&'s str, usize>,
    /// How many statements write an operand.
    pub(super) writes: HashMap<&'s str, usize>,
}

const CHECKS: [&str; 6] = ["A", "AN", "O", "ON", "X", "XN"];
const OPENING: [&str; 6] = ["A(", "AN(", "O(", "ON(", "X(", "XN("];

/// A check of a bit: `A x`, and no bare `O`.
pub(super) fn is_check(statement: &Statement) -> bool {
    CHECKS.contains(&statement.mnemonic) && !statement.operand.is_empty()
}

/// A check that opens a bracket.
pub(super) fn is_opening(statement: &Statement) -> bool {
    OPENING.contains(&statement.mnemonic)
}

pub(super) fn prepare<'s>(statements: &'s [Statement], around: &dyn Surroundings, mode: Mode) -> Result<Prepared<'s>, Refusal> {
    let end = statements.iter().rposition(|one| one.mnemonic != "BE").map_or(0, |last| last + 1);
    let statements = statements.get(..end).unwrap_or_default();
    look(statements, mode)?;
    let mut prepared = Prepared {
        statements: Vec::with_capacity(statements.len()),
        originals: Vec::with_capacity(statements.len()),
        closing: Vec::new(),
        labels: HashMap::new(),
        handed_over: HashSet::new(),
        last_read: HashMap::new(),
        writes: HashMap::new(),
    };
    for (index, statement) in statements.iter().enumerate() {
        if statement.mnemonic == "BLD" && statement.label.is_none() {
            let before = index.checked_sub(1).and_then(|before| statements.get(before)).map_or("", |one| one.mnemonic);
            let after = statements.get(index + 1).map_or("", |one| one.mnemonic);
            let says_something = match &*statement.operand {
                "100" => before == "A" && matches!(after, "FP" | "FN"),
                "101" => true,
                "103" => before == "=",
                _ => false,
            };
            if !says_something {
                continue;
            }
        }
        prepared.statements.push(statement);
        prepared.originals.push(index);
    }
    prepared.tables(around);
    Ok(prepared)
}

impl Prepared<'_> {
    fn tables(&mut self, around: &dyn Surroundings) {
        self.closing = vec![None; self.statements.len()];
        let mut open = Vec::new();
        for (index, statement) in self.statements.iter().enumerate() {
            if let Some(label) = &statement.label {
                self.labels.entry(label.text.as_str()).or_insert(index);
            }
            if is_opening(statement) {
                open.push(index);
            } else if statement.mnemonic == ")"
                && let Some(begin) = open.pop()
                && let Some(closing) = self.closing.get_mut(begin)
            {
                *closing = Some(index);
            } else if is_check(statement) {
                self.last_read.insert(statement.operand.text.as_str(), index);
            } else if matches!(statement.mnemonic, "=" | "S" | "R" | "T" | "FP" | "FN") {
                *self.writes.entry(statement.operand.text.as_str()).or_default() += 1;
            }
            for parameter in &statement.parameters {
                self.handed_over.extend(around.scratch(&parameter.actual));
                // A call may write what is handed to it.
                *self.writes.entry(parameter.actual.text.as_str()).or_default() += 1;
            }
        }
    }
}

/// What can be refused without reading.
fn look(statements: &[Statement], mode: Mode) -> Result<(), Refusal> {
    let labels: HashSet<&str> = statements.iter().filter_map(|one| one.label.as_deref()).collect();
    let mut before = "";
    for (index, one) in statements.iter().enumerate() {
        let next = statements.get(index + 1).map_or("", |next| next.mnemonic);
        let refuse = |reason| Err(Refusal::new(reason, index));
        match one.mnemonic {
            "JU" | "JC" | "JCN" if labels.contains(&*one.operand) && mode == Mode::Strict => return refuse(Reason::Jump),
            "JU" | "JC" | "JCN" | "JNB" => {}
            name if name.starts_with('J') || name == "LOOP" => return refuse(Reason::Jump),
            "SET" if next == "SAVE" => {}
            "CLR" if before == "SAVE" => {}
            "BEC" if before == "SAVE" => {}
            "SET" | "CLR" if mode == Mode::RewritingConstants && matches!(next, "=" | "S" | "R") => {}
            "L" if one.operand == "STW" => return refuse(Reason::Opcode),
            "NOP" if one.operand != "0" => return refuse(Reason::Opcode),
            name if has_element(name) => {}
            _ => return refuse(Reason::Opcode),
        }
        if is_indirect(&one.operand) || one.parameters.iter().any(|parameter| is_indirect(&parameter.actual)) {
            return refuse(Reason::Indirect);
        }
        before = one.mnemonic;
    }
    Ok(())
}

/// An element, or a part of one, stands for the instruction.
fn has_element(name: &str) -> bool {
    const OTHERS: [&str; 23] = [
        ")", "NOT", "FP", "FN", "=", "S", "R", "SAVE", "CU", "CD", "L", "LC", "T", "OPN", "UC", "CC", "CALL", "MCR(", ")MCR", "MCRA",
        "MCRD", "NOP", "BLD",
    ];
    CHECKS.contains(&name)
        || OPENING.contains(&name)
        || OTHERS.contains(&name)
        || TimerKind::of(name).is_some()
        || COMPARISONS.contains(&name)
        || (!name.is_empty() && BoxRow::of_instruction(name).is_some())
}

/// `M [MD 10]`, `DBX [AR1,P#0.0]`, `#p[AR1, …]`: a bracket that holds an address, and no index of an array.
fn is_indirect(operand: &str) -> bool {
    let Some((before, rest)) = operand.split_once('[') else { return false };
    let area = before.trim_end();
    let inside = rest.split(']').next().unwrap_or_default().trim_start();
    let computed = ["AR1", "AR2", "P#", "#", "MD", "LD", "DBD", "DID", "MW", "LW", "DBW", "DIW"];
    let begins = computed.iter().any(|begin| inside.get(..begin.len()).is_some_and(|own| own.eq_ignore_ascii_case(begin)));
    // An array has a name before its index; an area has letters only.
    begins || (area.len() <= 3 && area.bytes().all(|byte| byte.is_ascii_alphabetic()))
}
