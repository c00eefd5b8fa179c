//! Where names are used, and the assignment table with how often they are.

use std::collections::BTreeMap;

use serde_json::{Value, json};
use sieben_ide::cross_reference::{CrossReference, Reference};
use sieben_ide::target::Target;
use sieben_model::address::Operand;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_workspace::Refusal;
use sieben_workspace::project::Build;

/// Each symbol with its address, type, comment, and in how many places it is used.
pub(super) fn symbols(build: &Build) -> Value {
    let references = CrossReference::new(&build.compiled);
    let used: BTreeMap<&Target, usize> = references.entries().map(|(target, uses)| (target, uses.len())).collect();
    let row = |symbol: &sieben_model::symbols::Symbol| {
        let operand = symbol.operand();
        let count = operand.map(Target::from).and_then(|target| used.get(&target).copied()).unwrap_or(0);
        let address = operand.map_or_else(|| symbol.address.trim().to_owned(), |operand| operand.spell(Mnemonics::English));
        json!({
            "symbol": symbol.name, "address": address, "type": symbol.data_type.trim(), "comment": symbol.comment.trim(), "used": count,
        })
    };
    build.project.symbols.symbols().iter().map(row).collect()
}

/// Where a name is used; all of the program without one.
pub(super) fn of(build: &Build, name: Option<&str>) -> Result<Value, Refusal> {
    let (places, references) = (super::places(build), CrossReference::new(&build.compiled));
    let entry = |(target, uses): (&Target, &[Reference])| {
        json!({
            "address": target.spell(places.mnemonics), "symbol": places.symbol(target), "indirect": matches!(target, Target::Indirect(_)),
            "references": uses.iter().map(|reference| places.reference_json(reference)).collect::<Value>(),
        })
    };
    let Some(name) = name else {
        return Ok(references.entries().filter(|(target, _)| !target.is_local()).map(entry).collect());
    };
    let plain = name.trim().trim_matches('"');
    let operand = build.project.symbols.operand(plain).or_else(|| Operand::parse(plain));
    let wanted = operand.map(Target::from);
    let unquoted = |text: &str| text.replace('"', "").to_lowercase();
    let is_called = |target: &Target| {
        let symbol = places.symbol(target);
        !symbol.is_empty() && unquoted(&symbol) == unquoted(plain)
    };
    let found: Vec<Value> = references
        .entries()
        .filter(|(target, _)| wanted.as_ref() == Some(*target) || wanted.is_none() && !target.is_local() && is_called(target))
        .map(entry)
        .collect();
    match found.is_empty() && wanted.is_none() {
        true => Err(Refusal::new(Problem::P7003, format!("`{plain}` is no address, symbol or variable of this program"))),
        false => Ok(Value::Array(found)),
    }
}
