//! VAR sections of a block → the variables that it declares.

use std::collections::HashMap;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Section, Variable};
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::types::Usage;
use crate::declarations::interface::Declared;
use crate::declarations::reuse::Knows;
use crate::declarations::types::{Types, describe};
use crate::scope::key;
use crate::stl::ast;

fn keyword(section: Section) -> &'static str {
    match section {
        Section::Input => "VAR_INPUT",
        Section::Output => "VAR_OUTPUT",
        Section::InOut => "VAR_IN_OUT",
        Section::Static => "VAR",
        Section::Temp => "VAR_TEMP",
        Section::Return => "the result",
    }
}

fn allowed(kind: BlockKind) -> &'static [Section] {
    match kind {
        BlockKind::OrganizationBlock => &[Section::Temp],
        BlockKind::Function => &[Section::Input, Section::Output, Section::InOut, Section::Temp],
        _ => &[Section::Input, Section::Output, Section::InOut, Section::Static, Section::Temp],
    }
}

/// All variables that a code block declares, sections in the order of the manual.
pub(super) fn declared_of<K: Knows>(types: &mut Types<'_, K>, id: BlockId, block: &ast::Block) -> Vec<Declared> {
    let mut all = Vec::new();
    let mut names: HashMap<String, Span> = HashMap::new();
    for section in &block.sections {
        if !allowed(id.kind).contains(&section.section) {
            let valid: Vec<&str> = allowed(id.kind).iter().map(|&section| keyword(section)).collect();
            let message =
                format!("`{}` has no place in an {}; it takes {}", keyword(section.section), id.kind.abbreviation(), valid.join(", "));
            types.report(Problem::P2201, section.span, message);
        }
        for declaration in &section.declarations {
            let usage = Usage::Variable(id.kind, section.section);
            let Some(data_type) = types.data_type(&declaration.data_type, usage) else {
                // The name stays declared, so that its uses are not reported too.
                for word in &declaration.names {
                    names.entry(key(&word.text)).or_insert(word.span);
                    all.push(variable(word.text.clone(), word.span, section.section, DataType::Void));
                }
                continue;
            };
            let kept = match section.section {
                Section::Temp => false,
                _ => id.kind != BlockKind::Function,
            };
            let mut initial = types.initial(&declaration.initial, &data_type);
            if !kept && !declaration.initial.is_empty() {
                let message = format!("{} of an {} keeps no initial value", keyword(section.section), id.kind.abbreviation());
                types.report(Problem::P2212, declaration.span, message);
                initial.clear();
            }
            for word in &declaration.names {
                if let Some(&first) = names.get(&key(&word.text)) {
                    let message = format!("`{}` is declared twice in `{id}`", word.text);
                    types.report(Problem::P3006, word.span, message).related.push((first, "first declared here".to_owned()));
                    continue;
                }
                names.insert(key(&word.text), word.span);
                all.push(Variable {
                    initial: initial.clone(),
                    comment: declaration.comment.clone(),
                    ..variable(word.text.clone(), word.span, section.section, data_type.clone())
                });
            }
        }
    }
    if id.kind == BlockKind::Function
        && let Some(name) = &block.return_type
        && !matches!(&name.kind, ast::TypeKind::Word(word) if word == "VOID")
    {
        let usage = Usage::Variable(id.kind, Section::Output);
        if let Some(data_type) = types.data_type(name, usage) {
            if let Some(&first) = names.get("ret_val") {
                let message = format!("`RET_VAL` is the name of the result of `{id}`");
                types.report(Problem::P3006, first, message);
            } else if matches!(data_type, DataType::Array { .. }) {
                types.report(Problem::P4009, name.span, format!("a function cannot have {} as its result", describe(&data_type)));
            } else {
                all.push(variable("RET_VAL".to_owned(), name.span, Section::Return, data_type));
            }
        }
    }
    all.into_iter().map(Declared::from_variable).collect()
}

/// A variable that has no place, value or comment yet.
fn variable(name: String, span: Span, section: Section, data_type: DataType) -> Variable {
    Variable { name, section, data_type, offset: 0, initial: Vec::new(), comment: String::new(), span }
}
