//! A label of four characters for a longer one.

use sieben_lang::names::{DefId, DefinitionKind};

use super::{Action, At, Kind};

/// Most characters of a label of STEP 7.
const LABEL_MAX: usize = 4;
/// Labels that are tried: a block has fewer.
const TRIES_MAX: usize = 999;

/// Shortens the label at the cursor, and its jumps.
pub(super) fn action(at: &At<'_>) -> Option<Action> {
    if at.snapshot.language(at.text)?.dialect().is_some() {
        return None;
    }
    let (_, _, target @ DefId::Definition { text, index }) = at.snapshot.named(at.position())? else { return None };
    let names = at.snapshot.names();
    let source = names.text(text)?;
    let label = source.definition(index).filter(|one| one.kind == DefinitionKind::Label)?;
    if label.name.chars().count() <= LABEL_MAX {
        return None;
    }
    let others: Vec<String> = source
        .definition(label.parent?)?
        .members
        .iter()
        .filter_map(|&member| source.definition(member))
        .filter(|one| one.kind == DefinitionKind::Label)
        .map(|one| one.name.to_uppercase())
        .collect();
    let letters: String = label.name.chars().filter(|sign| sign.is_alphanumeric()).collect::<String>().to_uppercase();
    let cut: String = letters.chars().take(LABEL_MAX).collect();
    let first: String = letters.chars().take(1).filter(|sign| sign.is_alphabetic()).collect();
    let first = if first.is_empty() { "M".to_owned() } else { first };
    let numbered = (1..=TRIES_MAX).map(|number| format!("{first}{number:03}"));
    let begins_well = cut.starts_with(|sign: char| sign.is_alphabetic());
    let new_name = Some(cut).filter(|_| begins_well).into_iter().chain(numbered).find(|name| !others.contains(name))?;
    let uses = names.named_uses(target, Some(text));
    let edits =
        uses.into_iter().filter_map(|found| at.snapshot.place_of(found)).map(|place| at.edit(place.range, new_name.clone())).collect();
    Some(Action::new(Kind::QuickFix, format!("Shorten the label to `{new_name}`"), edits))
}
