//! Another name for something, in all blocks, languages, symbol tables and tests.

mod meanings;

use std::collections::HashMap;
use std::ops::Range;

use sieben_lang::names::{At, DefId, DefinitionKind, Found, Occurrence, Through, Written};
use sieben_lang::source_names::{is_identifier, key};
use sieben_lang::symbols::{self, Format, NAME_MAX};
use sieben_model::address::Operand;

use super::{Bytes, Edit, Place, Position, Role, Snapshot, TextId};

/// Most characters of a label.
const LABEL_MAX: usize = 4;

/// A name that can be another one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Renamable {
    /// The name, without quotes and `#`.
    pub range: Bytes,
    /// The name as it is.
    pub name: String,
}

/// What would be renamed at a position, or a sentence that says why not.
pub fn prepare(snapshot: &Snapshot, position: Position) -> Result<Renamable, String> {
    let (one, _) = target(snapshot, position)?;
    let range = Bytes::from(one.span);
    Ok(Renamable { range, name: snapshot.slice(position.text, range).to_owned() })
}

/// The edits that give it the new name everywhere, by text and place, or a sentence that says why not.
pub fn rename(snapshot: &Snapshot, position: Position, new_name: &str) -> Result<Vec<Edit>, String> {
    let (one, target) = target(snapshot, position)?;
    let old_name = snapshot.slice(position.text, one.span.into()).to_owned();
    let new_name = new_name.trim();
    let (old_key, new_key) = (key(&old_name), key(new_name));
    if new_name.is_empty() {
        return Err("a name has at least one character".to_owned());
    }
    if new_name == old_name {
        return Ok(Vec::new());
    }
    let names = snapshot.names();
    let uses: Vec<(Found, Place, Occurrence)> = names
        .named_uses(target, None)
        .into_iter()
        .filter(|found| found.through == Through::Name)
        .filter_map(|found| {
            let place = snapshot.place_of(found)?;
            let one = *snapshot.of_text(place.text)?.occurrence(found.occurrence)?;
            (key(snapshot.slice(place.text, place.range)) == old_key).then_some((found, place, one))
        })
        .collect();
    if let Some(fixed) = uses.iter().find_map(|(_, place, _)| snapshot.text(place.text)?.fixed.as_ref()) {
        return Err(fixed.clone());
    }
    if old_key != new_key || is_exact(snapshot, target) {
        is_free(snapshot, target, new_name, &uses)?;
    }
    let mut edits = Vec::with_capacity(uses.len());
    let mut padded = HashMap::new();
    for (_, place, one) in &uses {
        is_allowed(snapshot, place, one, new_name)?;
        edits.push(edit(snapshot, place, new_name, &mut padded)?);
    }
    edits.sort_by_key(|edit| edit.place.clone());
    edits.dedup();
    if old_key != new_key {
        meanings::are_kept(snapshot, &edits, &old_name, new_name)?;
    }
    Ok(edits)
}

/// The name at a position and what it stands for, if that can have another one.
fn target(snapshot: &Snapshot, position: Position) -> Result<(Occurrence, DefId), String> {
    let Some((_, one, target)) = snapshot.named(position) else {
        let unknown = snapshot.offset(position).and_then(|offset| {
            let names = snapshot.of_text(position.text)?;
            let one = names.occurrence(names.at(offset)?)?;
            Some(snapshot.slice(position.text, one.span.into()).to_owned())
        });
        return Err(match unknown {
            Some(name) => format!("`{name}` is not declared anywhere in the project"),
            None => "nothing here has a name".to_owned(),
        });
    };
    let name = snapshot.slice(position.text, one.span.into());
    let names = snapshot.names();
    let heads = names.heads(target);
    let definitions: Vec<_> = heads.iter().filter_map(|at| names.definition_at(*at)).collect();
    let is_number = match one.written {
        Written::Operand(_) | Written::InBlock(..) | Written::Range(..) | Written::Indirect(_) => true,
        Written::Definition(index) => snapshot
            .of_text(position.text)
            .and_then(|names| names.definition(index))
            .is_some_and(|one| one.kind != DefinitionKind::Symbol && matches!(one.operand, Some(Operand::Block(_)))),
        _ => false,
    };
    if is_number {
        let symbol = names.operand(target).and_then(|operand| names.symbol_of(operand));
        return Err(match symbol {
            Some(symbol) => format!("`{name}` is an address and no name; its symbol `{}` can be renamed where it stands", symbol.name),
            None => format!("`{name}` is an address and no name; it has no symbol"),
        });
    }
    if heads.iter().all(|at| snapshot.places_of(*at).is_none()) {
        return Err(format!("`{name}` is no name of this project: it comes with the controller or its library"));
    }
    if definitions.iter().any(|one| one.kind == DefinitionKind::Test) {
        return Err("the name of a test is a sentence that stands nowhere else; it can be changed where it stands".to_owned());
    }
    if definitions.iter().any(|one| one.kind == DefinitionKind::Result && one.name == "RET_VAL") {
        return Err("`RET_VAL` is the name that the result of every function has".to_owned());
    }
    Ok((one, target))
}

/// Whether upper and lower case are different names: of labels of STL.
fn is_exact(snapshot: &Snapshot, target: DefId) -> bool {
    let names = snapshot.names();
    let is_label = |at: &At| names.definition_at(*at).is_some_and(|one| one.kind == DefinitionKind::Label);
    names.heads(target).iter().any(|at| is_label(at) && names.text(at.0).is_some_and(|text| text.mnemonics.is_some()))
}

/// Whether nothing else has the new name where it would stand.
fn is_free(snapshot: &Snapshot, target: DefId, new_name: &str, uses: &[(Found, Place, Occurrence)]) -> Result<(), String> {
    let names = snapshot.names();
    let new_key = key(new_name);
    let heads = names.heads(target);
    let definition = |at: &At| names.definition_at(*at);
    let is_label = heads.iter().filter_map(definition).any(|one| one.kind == DefinitionKind::Label);
    let is_exact = is_exact(snapshot, target);
    let is_same = |one: &str, other: &str| if is_exact { one == other } else { key(one) == key(other) };
    let owners: Vec<At> = heads.iter().filter_map(|at| Some((at.0, definition(at)?.parent?))).collect();
    for owner in &owners {
        let Some(of) = names.of_definition(*owner) else { continue };
        let same_kind = |at: &At| definition(at).is_some_and(|one| (one.kind == DefinitionKind::Label) == is_label);
        let taken = names
            .members(of)
            .into_iter()
            .filter(|at| !heads.contains(at))
            .filter(same_kind)
            .any(|at| definition(&at).is_some_and(|one| is_same(&one.name, new_name)));
        let twice =
            |at: &At| definition(at).zip(heads.first().and_then(definition)).is_some_and(|(one, own)| is_same(&one.name, &own.name));
        if names.members(of).into_iter().filter(|at| !heads.contains(at)).filter(same_kind).any(|at| twice(&at)) {
            let name = definition(owner).map_or("", |one| one.name.as_str());
            return Err(format!("`{name}` declares this name twice, so that it is not clear what would be renamed"));
        }
        if taken {
            let name = definition(owner).map_or("", |one| one.name.as_str());
            return Err(format!("`{name}` has something with the name `{new_name}` already"));
        }
    }
    let is_global = owners.is_empty() || owners.iter().filter_map(definition).any(|owner| owner.kind == DefinitionKind::Group);
    if is_global && names.names_of(target).iter().any(|name| names.all_global(name).len() > 1) {
        return Err("the project has several things with this name, so that it is not clear what would be renamed".to_owned());
    }
    // A name of the library is free while nothing uses it.
    let counts = |other: DefId| {
        let is_own = names.heads(other).iter().any(|at| snapshot.places_of(*at).is_some());
        other != target && (is_own || !names.named_uses(other, None).is_empty())
    };
    if is_global && names.global(&new_key).is_some_and(counts) {
        return Err(format!("the project has something with the name `{new_name}` already"));
    }
    if is_label {
        return Ok(());
    }
    extension_is_free(snapshot, &heads, new_name)?;
    for (found, place, one) in uses {
        let Some(source) = names.text(found.text) else { continue };
        let Some(id) = source.id(&new_key) else { continue };
        // A bare name means what its block declares, first of all.
        if is_global
            && matches!(one.written, Written::Plain(_))
            && names.local(found.text, one.scope, id).is_some_and(|other| other != target)
        {
            let block = one.scope.and_then(|scope| source.definition(scope)).map_or("", |block| block.name.as_str());
            return Err(format!("`{block}` declares `{new_name}` itself, so that it would mean something else there"));
        }
        // What has the new name already and means something global would mean the variable, where that is declared.
        if !is_global && !matches!(one.written, Written::Member(..) | Written::Parameter(..)) {
            let captured = source.occurrences_of(&new_key).iter().filter_map(|&index| Some((index, source.occurrence(index)?)));
            let mut captured = captured.filter(|(_, other)| other.scope == one.scope && matches!(other.written, Written::Plain(_)));
            if captured.any(|(index, _)| names.resolve(found.text, index).is_none_or(|other| other != target)) {
                let name = snapshot.text(place.text).map_or("", |text| text.name.as_str());
                return Err(format!("`{new_name}` stands in this block of `{name}` already and means something else"));
            }
        }
    }
    Ok(())
}

/// Whether nothing that extends the owner declares the new name.
fn extension_is_free(snapshot: &Snapshot, heads: &[At], new_name: &str) -> Result<(), String> {
    let names = snapshot.names();
    let new_key = key(new_name);
    for (text, source) in names.texts().iter().enumerate() {
        for &index in source.definitions_of(&new_key) {
            let Some(parent) = source.definition(index).and_then(|one| one.parent) else { continue };
            let Some(block) = source.definition(parent).filter(|block| !block.extends.is_empty()) else { continue };
            let all = names.of_definition((text as u32, parent)).map(|block| names.members(block)).unwrap_or_default();
            if heads.iter().any(|head| all.contains(head)) {
                return Err(format!("`{}` has it by what it extends, and has something with the name `{new_name}` already", block.name));
            }
        }
    }
    Ok(())
}

/// Whether the new name can be written at a place.
fn is_allowed(snapshot: &Snapshot, place: &Place, one: &Occurrence, new_name: &str) -> Result<(), String> {
    let Some(text) = snapshot.text(place.text) else { return Ok(()) };
    if new_name.chars().any(|sign| sign == '"' || sign.is_control()) {
        return Err(format!("`{}` cannot be a name: quotation marks and line ends belong to none", new_name.escape_debug()));
    }
    if text.role == Role::Symbols {
        let format = symbols::detect(&text.name, &text.text);
        if format.is_some_and(|format| format != Format::Csv) && new_name.chars().count() > NAME_MAX {
            return Err(format!("a symbol in `{}` has at most {NAME_MAX} characters", text.name));
        }
        let is_quoted = text.text.get(..place.range.start).is_some_and(|before| before.trim_end_matches(' ').ends_with('"'));
        if !is_quoted && new_name.contains([',', ';', '\t']) {
            return Err(format!("`{new_name}` cannot stand in `{}`, where a comma, a semicolon or a tabulator ends a cell", text.name));
        }
        return Ok(());
    }
    let is_label = match one.written {
        Written::Label(_) => true,
        Written::Definition(index) => snapshot
            .of_text(place.text)
            .and_then(|names| names.definition(index))
            .is_some_and(|definition| definition.kind == DefinitionKind::Label),
        _ => false,
    };
    let Some(language) = snapshot.language(place.text) else { return Ok(()) };
    let is_quoted = text.text.get(..place.range.start).is_some_and(|before| before.ends_with(['"', '`', '“', '„']));
    if is_label && language.dialect().is_none() {
        let is_word = is_identifier(new_name, language) && new_name.chars().count() <= LABEL_MAX;
        return if is_word {
            Ok(())
        } else {
            Err(format!("`{new_name}` is no label: a label has at most {LABEL_MAX} letters and digits and begins with a letter"))
        };
    }
    if !is_quoted && !is_identifier(new_name, language) {
        return Err(format!(
            "`{new_name}` is no name that can stand without quotation marks in `{}`: letters, digits and `_`, no digit first, and no word of the language",
            text.name
        ));
    }
    Ok(())
}

/// Where rows of tables with fixed columns have their symbols, with the padding after each: by the first byte.
type Padding = HashMap<TextId, HashMap<usize, (Range<usize>, usize)>>;

fn edit(snapshot: &Snapshot, place: &Place, new_name: &str, padded: &mut Padding) -> Result<Edit, String> {
    let plain = Edit { place: place.clone(), new_text: new_name.to_owned() };
    let Some(text) = snapshot.text(place.text).filter(|text| text.role == Role::Symbols) else { return Ok(plain) };
    let rows = padded.entry(place.text).or_insert_with(|| match symbols::detect(&text.name, &text.text) {
        Some(format) if format != Format::Csv && format != Format::Seq => {
            let rows = symbols::names::rows(&text.text, format).into_iter();
            rows.filter_map(|row| row.name.map(|name| (name.start, (name, row.padding)))).collect()
        }
        _ => HashMap::new(),
    });
    let Some((name, padding)) = rows.get(&place.range.start).filter(|(_, padding)| *padding > 0) else { return Ok(plain) };
    // The field keeps its width in characters.
    let width = text.text.get(name.clone()).map_or(0, |name| name.chars().count()) + padding;
    let length = new_name.chars().count();
    let is_full = width >= NAME_MAX;
    let (end, room) = if is_full { (name.end + padding, width) } else { (name.end, 0) };
    let new_text = format!("{new_name}{}", " ".repeat(room.saturating_sub(length)));
    Ok(Edit { place: Place { text: place.text, range: (name.start..end).into() }, new_text })
}
