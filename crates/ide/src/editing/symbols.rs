//! Names of the whole project, found by some of their letters.

use sieben_lang::names::{At, DefinitionKind};

use super::completion::Kind;
use super::{Place, Snapshot};

/// A name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// The name.
    pub name: String,
    /// What it is.
    pub kind: Kind,
    /// What it belongs to, or its address; may be empty.
    pub container: String,
    /// Where it is defined.
    pub place: Place,
}

/// The names that have these letters in this order, the best first, `limit` at most; all of them without letters.
pub fn workspace_symbols(snapshot: &Snapshot, letters: &str, limit: usize) -> Vec<Symbol> {
    let letters: Vec<char> = letters.to_lowercase().chars().filter(|letter| !letter.is_whitespace()).collect();
    let mut found: Vec<(usize, String, At)> = Vec::new();
    for (text, source) in snapshot.names().texts().iter().enumerate().take(snapshot.texts().len()) {
        for (index, definition) in source.definitions.iter().enumerate() {
            let is_local = matches!(definition.kind, DefinitionKind::Label | DefinitionKind::Temp);
            if is_local || definition.name.is_empty() {
                continue;
            }
            if let Some(score) = score(&definition.name, &letters) {
                found.push((score, definition.name.to_lowercase(), (text as u32, index as u32)));
            }
        }
    }
    found.sort();
    found.truncate(limit);
    let names = snapshot.names();
    let symbol = |(_, _, at): (usize, String, At)| {
        let definition = names.definition_at(at)?;
        let (place, whole) = snapshot.places_of(at)?;
        let parent = definition.parent.and_then(|parent| names.definition_at((at.0, parent))).map(|parent| parent.name.clone());
        let address = definition.operand.map(|operand| operand.spell(snapshot.usual_mnemonics()));
        let place = if place.range.start < place.range.end { place } else { Place { range: whole.range, ..place } };
        Some(Symbol {
            name: definition.name.clone(),
            kind: kind(definition.kind),
            container: parent.or(address).unwrap_or_default(),
            place,
        })
    };
    found.into_iter().filter_map(symbol).collect()
}

/// How far a name is from the letters, if it has them in this order.
pub(super) fn score(name: &str, letters: &[char]) -> Option<usize> {
    if letters.is_empty() {
        return Some(0);
    }
    let (mut at, mut gaps, mut last, mut first) = (0, 0, None, 0);
    for (index, sign) in name.chars().flat_map(char::to_lowercase).enumerate() {
        if letters.get(at) == Some(&sign) {
            match last {
                Some(last) => gaps += index - last - 1,
                None => first = index,
            }
            last = Some(index);
            at += 1;
        }
    }
    (at == letters.len()).then_some(first * 2 + gaps * 4)
}

/// What a definition is in lists.
pub(super) fn kind(kind: DefinitionKind) -> Kind {
    match kind {
        DefinitionKind::OrganizationBlock
        | DefinitionKind::Program
        | DefinitionKind::Function
        | DefinitionKind::Method
        | DefinitionKind::Property
        | DefinitionKind::Action
        | DefinitionKind::Test => Kind::Function,
        DefinitionKind::FunctionBlock | DefinitionKind::Interface => Kind::FunctionBlock,
        DefinitionKind::DataBlock | DefinitionKind::Group => Kind::DataBlock,
        DefinitionKind::Type => Kind::Type,
        DefinitionKind::Input | DefinitionKind::Output | DefinitionKind::InOut | DefinitionKind::Result => Kind::Parameter,
        DefinitionKind::Static | DefinitionKind::Temp | DefinitionKind::Global => Kind::Variable,
        DefinitionKind::Constant | DefinitionKind::EnumValue => Kind::Constant,
        DefinitionKind::Field => Kind::Field,
        DefinitionKind::Label => Kind::Label,
        DefinitionKind::Symbol => Kind::Symbol,
    }
}
