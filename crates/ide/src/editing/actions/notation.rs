//! Addresses for symbols, and symbols for addresses.

use sieben_lang::names::{Access, DefId, DefinitionKind, Written};
use sieben_lang::source_names::is_identifier;
use sieben_lang::st::Dialect;
use sieben_model::address::Operand;

use super::super::context::quotes_names;
use super::{Action, At, Bytes, Edit, Kind, Snapshot};

/// Writes what is selected by symbols, and by addresses.
pub(super) fn actions(at: &At<'_>) -> Vec<Action> {
    let Some(source) = at.snapshot.of_text(at.text) else { return Vec::new() };
    let Some(language) = at.snapshot.language(at.text) else { return Vec::new() };
    let names = at.snapshot.names();
    let quotes = quotes_names(language);
    let mnemonics = at.snapshot.mnemonics(at.text);
    let (mut symbolic, mut absolute) = (Vec::new(), Vec::new());
    let first = source.occurrences.partition_point(|one| (one.span.end as usize) < at.range.start);
    for (index, one) in source.occurrences.iter().enumerate().skip(first) {
        let span = Bytes::from(one.span);
        if span.start > at.range.end {
            break;
        }
        if matches!(one.access, Access::Definition) {
            continue;
        }
        match one.written {
            Written::Operand(operand) => {
                let Some(symbol) = names.symbol_of(operand) else { continue };
                let is_percent = span.start > 0 && at.content().get(span.start - 1..span.start) == Some("%");
                let range = Bytes { start: span.start - usize::from(is_percent), ..span };
                let new_text = match quotes {
                    true => format!("\"{}\"", symbol.name),
                    false if is_identifier(&symbol.name, language) => symbol.name.clone(),
                    false => continue,
                };
                symbolic.push((index as u32, at.edit(range, new_text)));
            }
            Written::Global(_) | Written::Plain(_) => {
                let is_symbol = |target: &DefId| match *target {
                    DefId::Block(block) => names.symbol_of(Operand::Block(block)).is_some(),
                    DefId::Definition { text, index } => {
                        names.definition_at((text, index)).is_some_and(|one| one.kind == DefinitionKind::Symbol)
                    }
                    DefId::Operand(_) => false,
                };
                let Some(target) = names.resolve(at.text.0 as u32, index as u32).filter(is_symbol) else { continue };
                let Some(operand) = names.operand(target) else { continue };
                let quote = |start: usize| usize::from(at.content().get(start..start + 1) == Some("\""));
                let range = Bytes { start: span.start - span.start.checked_sub(1).map_or(0, quote), end: span.end + quote(span.end) };
                // A block with its instance has one notation for both.
                let is_pair = at.content().get(range.end..).is_some_and(|rest| rest.starts_with(".\""))
                    || at.content().get(..range.start).is_some_and(|before| before.ends_with('.'));
                if is_pair {
                    continue;
                }
                let spelled = operand.spell(mnemonics);
                let new_text = match (language.dialect(), operand) {
                    (None, _) => spelled,
                    (Some(_), Operand::Block(_)) => spelled.replace(' ', ""),
                    (Some(_), Operand::Timer(_) | Operand::Counter(_)) => spelled.replace(' ', ""),
                    // S7-SCL writes addresses as STL does.
                    (Some(dialect), _) if dialect.base() == Dialect::Scl => spelled.replace(' ', ""),
                    (Some(_), _) => format!("%{}", spelled.replace(' ', "")),
                };
                absolute.push((index as u32, at.edit(range, new_text)));
            }
            _ => {}
        }
    }
    let (symbolic, absolute) = (of_same(at, symbolic), of_same(at, absolute));
    let mut actions = Vec::new();
    if !symbolic.is_empty() {
        actions.push(Action::new(Kind::Rewrite, "Write symbols for addresses", symbolic));
    }
    if !absolute.is_empty() {
        actions.push(Action::new(Kind::Rewrite, "Write addresses for symbols", absolute));
    }
    actions
}

/// The edits after which their occurrences stand for the operands that they stand for now; none if the text is read in another way.
fn of_same(at: &At<'_>, edits: Vec<(u32, Edit)>) -> Vec<Edit> {
    let text = at.text.0 as u32;
    let operand = |snapshot: &Snapshot, index: u32| snapshot.names().resolve(text, index).and_then(|of| snapshot.names().operand(of));
    let mut edits = edits;
    // What is left is read once more, without the edits that were dropped.
    for _ in 0..2 {
        if edits.is_empty() {
            break;
        }
        let all: Vec<Edit> = edits.iter().map(|(_, edit)| edit.clone()).collect();
        let after = at.snapshot.with_edits(&all);
        let length = |snapshot: &Snapshot| snapshot.of_text(at.text).map(|names| names.occurrences.len());
        if length(at.snapshot) != length(&after) {
            return Vec::new();
        }
        let count = edits.len();
        edits.retain(|(index, _)| operand(&after, *index) == operand(at.snapshot, *index));
        if edits.len() == count {
            break;
        }
    }
    edits.into_iter().map(|(_, edit)| edit).collect()
}
