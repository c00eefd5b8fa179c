//! What is shown between the words of a text: the address of a symbol, the symbol of an address, names of parameters.

use sieben_lang::names::{Access, DefId, DefinitionKind, Written};
use sieben_model::address::Operand;

use super::{Bytes, Role, Snapshot, TextId, context};

/// What a hint says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// The address of a symbol.
    Address,
    /// The symbol of an address.
    Symbol,
    /// The name of a parameter that is given by position.
    Parameter,
    /// Nothing by itself: an address without a symbol, of which only the value is worth a hint.
    Value,
}

/// A hint.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hint {
    /// The byte that it is shown at.
    pub offset: usize,
    /// What is shown.
    pub label: String,
    /// What it says.
    pub kind: Kind,
    /// What the name or address stands for, if it has a value that a running controller can be asked for.
    pub operand: Option<Operand>,
}

/// The hints of some bytes of a text.
pub fn hints(snapshot: &Snapshot, text: TextId, range: Bytes) -> Vec<Hint> {
    let Some(source) = snapshot.of_text(text) else { return Vec::new() };
    if snapshot.text(text).is_none_or(|text| text.role != Role::Source) {
        return Vec::new();
    }
    let names = snapshot.names();
    let number = text.0 as u32;
    let mut hints = Vec::new();
    let first = source.occurrences.partition_point(|one| (one.span.end as usize) < range.start);
    for (index, one) in source.occurrences.iter().enumerate().skip(first) {
        if one.span.start as usize > range.end {
            break;
        }
        if matches!(one.access, Access::Definition | Access::Path | Access::Type | Access::Parameter) {
            continue;
        }
        let end = one.span.end as usize;
        let is_quoted = snapshot.slice(text, Bytes { start: end, end: end + 1 }) == "\"";
        let offset = end + usize::from(is_quoted);
        match (one.written, names.resolve(number, index as u32)) {
            (Written::Operand(operand), _) => match (names.symbol_of(operand), value_of(operand)) {
                (Some(symbol), value) => {
                    hints.push(Hint { offset, label: format!("\"{}\"", symbol.name), kind: Kind::Symbol, operand: value });
                }
                (None, Some(_)) => hints.push(Hint { offset, label: String::new(), kind: Kind::Value, operand: value_of(operand) }),
                (None, None) => {}
            },
            (Written::Global(_) | Written::Plain(_), Some(target)) => {
                let is_symbol = match target {
                    DefId::Block(block) => names.symbol_of(Operand::Block(block)).is_some(),
                    DefId::Definition { text, index } => names
                        .definition_at((text, index))
                        .is_some_and(|one| matches!(one.kind, DefinitionKind::Symbol | DefinitionKind::Global)),
                    DefId::Operand(_) => false,
                };
                if let Some(operand) = names.operand(target).filter(|_| is_symbol) {
                    let label = operand.spell(snapshot.mnemonics(text));
                    hints.push(Hint { offset, label, kind: Kind::Address, operand: value_of(operand) });
                }
            }
            _ => {}
        }
    }
    for call in &source.calls {
        if call.whole.start as usize > range.end || (call.whole.end as usize) < range.start || call.arguments.iter().all(|one| one.1) {
            continue;
        }
        let Some(target) = names.resolve(number, call.callee) else { continue };
        let parameters = super::signature::parameters(snapshot, context::block_of(snapshot, target));
        for ((bytes, _), parameter) in call.arguments.iter().zip(&parameters).filter(|((_, is_named), _)| !is_named) {
            let written = snapshot.slice(text, (*bytes).into());
            if !written.eq_ignore_ascii_case(&parameter.name) {
                let label = format!("{} :=", parameter.name);
                hints.push(Hint { offset: bytes.start as usize, label, kind: Kind::Parameter, operand: None });
            }
        }
    }
    hints.retain(|hint| range.start <= hint.offset && hint.offset <= range.end);
    hints.sort_by_key(|hint| hint.offset);
    hints
}

/// What has a value.
fn value_of(operand: Operand) -> Option<Operand> {
    Some(operand).filter(|operand| !matches!(operand, Operand::Block(_)))
}
