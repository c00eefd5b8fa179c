//! The parameters of the call around a position.

use sieben_lang::names::{DefId, Definition, DefinitionKind};
use sieben_lang::st::standard::catalogue::page;

use super::{Bytes, Position, Snapshot, context};

/// A call.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    /// `Dosing(amount : INT, start : BOOL) : BOOL`.
    pub label: String,
    /// What the block says about itself, in Markdown; may be empty.
    pub documentation: String,
    /// The parameters in the order of the label.
    pub parameters: Vec<Parameter>,
    /// Which parameter the position belongs to.
    pub active: Option<usize>,
}

/// A parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// The bytes of the label that are the parameter.
    pub label: Bytes,
    /// Its comment; may be empty.
    pub documentation: String,
}

/// The call around a position.
pub fn signature(snapshot: &Snapshot, position: Position) -> Option<Signature> {
    let call = context::call(snapshot, position)?;
    let Some(callee) = call.callee.filter(|callee| !snapshot.names().heads(*callee).is_empty()) else {
        return of_standard(&call);
    };
    let block = context::block_of(snapshot, callee);
    let is_st = snapshot.language(position.text).is_some_and(|language| language.dialect().is_some());
    let mut parameters = parameters(snapshot, block);
    // In ST the result of a function is its value and no parameter.
    let result = parameters.iter().find(|one| one.kind == DefinitionKind::Result).map(|one| one.data_type.clone());
    parameters.retain(|one| !is_st || one.kind != DefinitionKind::Result);
    let mut label = format!("{}(", call.word);
    let mut shown = Vec::new();
    for (index, parameter) in parameters.iter().enumerate() {
        if index > 0 {
            label.push_str(", ");
        }
        let start = label.len();
        label.push_str(&format!("{} : {}", parameter.name, parameter.data_type));
        shown.push(Parameter { label: Bytes { start, end: label.len() }, documentation: parameter.comment.clone() });
    }
    label.push(')');
    let heads = snapshot.names().heads(block);
    let head = heads.iter().filter_map(|at| snapshot.names().definition_at(*at)).find(|one| one.kind != DefinitionKind::Symbol);
    let result = result.or_else(|| head.map(|head| head.data_type.clone())).filter(|result| is_st && !result.is_empty());
    if let Some(result) = result {
        label.push_str(&format!(" : {result}"));
    }
    let documentation = head.map(|head| head.comment.clone()).unwrap_or_default();
    let by_name = call.name.as_ref().and_then(|name| parameters.iter().position(|one| one.name.eq_ignore_ascii_case(name)));
    let by_place = (call.name.is_none() && call.argument < parameters.len()).then_some(call.argument);
    Some(Signature { label, documentation, parameters: shown, active: by_name.or(by_place) })
}

/// The parameters of a block, in the order of a call.
pub(super) fn parameters(snapshot: &Snapshot, block: DefId) -> Vec<&Definition> {
    let names = snapshot.names();
    let all = names.members(block).into_iter().filter_map(|at| names.definition_at(at));
    let mut parameters: Vec<&Definition> = all.filter(|one| one.kind.is_parameter()).collect();
    parameters.sort_by_key(|one| one.kind);
    parameters
}

/// A function that every program has: its page says how it is called.
fn of_standard(call: &context::Call) -> Option<Signature> {
    let page = page(&call.word)?;
    let fits = |form: &&&str| {
        let form = form.split_once(": ").filter(|(dialects, _)| !dialects.contains('(')).map_or(**form, |(_, form)| form);
        form.split('(').next().is_some_and(|name| name.eq_ignore_ascii_case(&call.word))
    };
    let label = (*page.calls.iter().find(fits).or(page.calls.first())?).to_owned();
    let open = label.find('(')? + 1;
    let close = label.rfind(')').filter(|close| *close >= open)?;
    let mut parameters = Vec::new();
    let mut start = open;
    for part in label[open..close].split(';') {
        let from = start + (part.len() - part.trim_start().len());
        parameters.push(Parameter { label: Bytes { start: from, end: from + part.trim().len() }, documentation: String::new() });
        start += part.len() + 1;
    }
    let named = call.name.as_ref().and_then(|name| {
        parameters.iter().position(|one| {
            let written = &label[one.label.start..one.label.end];
            written.split([':', '=', ' ']).next().is_some_and(|word| word.eq_ignore_ascii_case(name))
        })
    });
    let active = named.or((call.argument < parameters.len()).then_some(call.argument));
    Some(Signature { label: label.clone(), documentation: page.purpose.to_owned(), parameters, active })
}
