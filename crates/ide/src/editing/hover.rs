//! What stands at a position, in a few lines of Markdown.

mod instruction;
mod timers;

use sieben_lang::names::{Access, DefId, Definition, DefinitionKind, Written};
use sieben_lang::st::standard::catalogue::page;
use sieben_model::address::Operand;

use super::{Bytes, Position, Role, Snapshot, context};

/// What is shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hover {
    /// What it is about, without quotes and `#`.
    pub range: Bytes,
    /// The lines, in Markdown.
    pub markdown: String,
}

/// An instruction with its status row; a name with its address, type, comment and uses; a timer with its signal diagram.
pub fn hover(snapshot: &Snapshot, position: Position) -> Option<Hover> {
    if let Some((_, one, target)) = snapshot.named(position) {
        return Some(Hover { range: one.span.into(), markdown: of_target(snapshot, position, one.written, target) });
    }
    let text = snapshot.text(position.text).filter(|text| text.role == Role::Source)?;
    let language = snapshot.language(position.text)?;
    let offset = snapshot.offset(position)?;
    if context::in_comment(&text.text, offset) {
        return None;
    }
    match language.dialect() {
        None => instruction::hover(&text.text, offset, snapshot.mnemonics(position.text)),
        Some(_) => {
            let range = word_at(&text.text, offset)?;
            let word = text.text.get(range.start..range.end)?;
            let page = page(word)?;
            let mut markdown = format!("**{}**: {}\n\n```st\n{}\n```\n", word.to_uppercase(), page.purpose, page.calls.join("\n"));
            if let Some(diagram) = timers::of_block(word) {
                markdown.push_str(&diagram);
            }
            Some(Hover { range, markdown })
        }
    }
}

/// The word around a byte.
fn word_at(text: &str, offset: usize) -> Option<Bytes> {
    let start = offset - text.get(..offset)?.chars().rev().take_while(|&sign| context::in_word(sign)).map(char::len_utf8).sum::<usize>();
    let end = offset + text.get(offset..)?.chars().take_while(|&sign| context::in_word(sign)).map(char::len_utf8).sum::<usize>();
    (start < end).then_some(Bytes { start, end })
}

fn of_target(snapshot: &Snapshot, position: Position, written: Written, target: DefId) -> String {
    let names = snapshot.names();
    let heads = names.heads(target);
    let definitions: Vec<&Definition> = heads.iter().filter_map(|at| names.definition_at(*at)).collect();
    let symbol = definitions.iter().find(|one| one.kind == DefinitionKind::Symbol).copied();
    let declared = definitions.iter().find(|one| one.kind != DefinitionKind::Symbol).copied();
    let mnemonics = snapshot.mnemonics(position.text);
    let operand = names.operand(target);
    let mut markdown = String::from("```\n");
    let name = symbol.or(declared).map_or_else(|| operand.map_or_else(String::new, |one| one.spell(mnemonics)), |one| one.name.clone());
    markdown.push_str(&name);
    if let Some(operand) = operand {
        let spelled = operand.spell(mnemonics);
        if !spelled.eq_ignore_ascii_case(&name) {
            markdown.push_str(&format!("  {spelled}"));
        }
    }
    // The type of a block that a symbol names is its number, which stands there already.
    let is_block = declared.is_some_and(|one| one.kind.is_code());
    let typed = [declared, symbol.filter(|_| !is_block)].into_iter().flatten();
    let data_type = typed.map(|one| one.data_type.as_str()).find(|written| !written.is_empty());
    if let Some(data_type) = data_type {
        markdown.push_str(&format!(" : {data_type}"));
    }
    markdown.push_str("\n```\n");
    let what = declared.map_or("symbol", |one| word(one.kind));
    let is_plain = declared.is_none() && symbol.is_none();
    if !is_plain {
        let owner = heads.iter().find_map(|at| {
            let definition = names.definition_at(*at).filter(|one| one.kind != DefinitionKind::Symbol)?;
            names.definition_at((at.0, definition.parent?)).map(|owner| owner.name.as_str())
        });
        markdown.push_str(
            &owner.filter(|owner| !owner.is_empty()).map_or_else(|| format!("{what}\n"), |owner| format!("{what} of `{owner}`\n")),
        );
    }
    let mut comments: Vec<&str> =
        [symbol, declared].into_iter().flatten().map(|one| one.comment.as_str()).filter(|one| !one.is_empty()).collect();
    comments.dedup();
    comments.iter().for_each(|comment| markdown.push_str(&format!("\n{comment}\n")));
    if let Some(block) = declared.filter(|one| one.kind.is_code()) {
        let parameters = super::signature::parameters(snapshot, target);
        if !parameters.is_empty() && block.kind.is_code() {
            markdown.push_str("\n| parameter | | type | |\n|---|---|---|---|\n");
            for one in parameters {
                markdown.push_str(&format!(
                    "| {} | {} | {} | {} |\n",
                    one.name,
                    word(one.kind),
                    one.data_type,
                    one.comment.replace('|', "\\|")
                ));
            }
        }
    }
    if let Written::Operand(Operand::Timer(_)) = written {
        markdown.push_str(&timers::of_statement(snapshot, position).unwrap_or_default());
    }
    if let Some(diagram) = symbol.is_none().then(|| timers::of_block(&name)).flatten() {
        markdown.push_str(&diagram);
    }
    markdown.push_str(&uses(snapshot, target));
    markdown
}

/// How often something is used, and how.
fn uses(snapshot: &Snapshot, target: DefId) -> String {
    let names = snapshot.names();
    let found = names.uses(target, None);
    let mut counts: Vec<(&str, usize)> = Vec::new();
    let mut overlaps = 0;
    for one in &found {
        let way = match names.access(one.text, one.occurrence) {
            _ if one.through == sieben_lang::names::Through::Pointer => "perhaps by a pointer",
            Access::Definition | Access::Path => continue,
            _ if one.through == sieben_lang::names::Through::Overlap => {
                overlaps += 1;
                continue;
            }
            Access::Read | Access::Argument => "read",
            Access::Write => "written",
            Access::ReadWrite => "read and written",
            Access::Call => "called",
            Access::Open => "opened",
            Access::Instance => "instance of a call",
            Access::Address => "its address taken",
            Access::Jump => "jumped to",
            Access::Type => "named as a type",
            Access::Parameter => "given in a call",
        };
        match counts.iter_mut().find(|(known, _)| *known == way) {
            Some((_, count)) => *count += 1,
            None => counts.push((way, 1)),
        }
    }
    let mut parts: Vec<String> = counts.iter().map(|(way, count)| format!("{way} {count}×")).collect();
    match overlaps {
        0 => {}
        1 => parts.push("another address has bits in common with it".to_owned()),
        _ => parts.push(format!("{overlaps} other addresses have bits in common with it")),
    }
    match parts.is_empty() {
        true => "\nnot used\n".to_owned(),
        false => format!("\n{}\n", parts.join(", ")),
    }
}

/// What a definition is, in a word.
pub(super) fn word(kind: DefinitionKind) -> &'static str {
    match kind {
        DefinitionKind::OrganizationBlock => "organization block",
        DefinitionKind::Program => "program",
        DefinitionKind::Function => "function",
        DefinitionKind::FunctionBlock => "function block",
        DefinitionKind::Interface => "interface",
        DefinitionKind::Method => "method",
        DefinitionKind::Property => "property",
        DefinitionKind::Action => "action",
        DefinitionKind::DataBlock => "data block",
        DefinitionKind::Type => "type",
        DefinitionKind::Input => "IN",
        DefinitionKind::Output => "OUT",
        DefinitionKind::InOut => "IN_OUT",
        DefinitionKind::Static => "static variable",
        DefinitionKind::Temp => "temporary variable",
        DefinitionKind::Result => "result",
        DefinitionKind::Global => "global variable",
        DefinitionKind::Constant => "constant",
        DefinitionKind::Field => "field",
        DefinitionKind::EnumValue => "value of an enumeration",
        DefinitionKind::Label => "label",
        DefinitionKind::Symbol => "symbol",
        DefinitionKind::Test => "test",
        DefinitionKind::Group => "group of names",
    }
}
