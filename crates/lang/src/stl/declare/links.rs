//! What the blocks of STL mention that may be a block of the library.

use std::collections::HashSet;

use sieben_model::block::BlockKind;

use crate::library::link::Mention;
use crate::scope::key;
use crate::stl::ast;

/// All that a block mentions, each once: types of instances, and what it calls.
pub(crate) fn mentions(block: &ast::Block) -> Vec<Mention> {
    let mut found = Vec::new();
    let mut locals = HashSet::new();
    for declaration in block.sections.iter().flat_map(|section| &section.declarations) {
        locals.extend(declaration.names.iter().map(|word| key(&word.text)));
        found.extend(type_name(&declaration.data_type));
    }
    found.extend(block.body_type.as_ref().and_then(type_name));
    // `UC` and `CC` pass no parameters, which every block of the library needs.
    for statement in &block.statements {
        if let ast::Operand::Call(call) = &statement.operand {
            found.extend(callee(&call.callee, &locals));
        }
    }
    let mut seen = HashSet::new();
    found.retain(|mention| seen.insert(mention.clone()));
    found
}

/// `FB 41` or `"CONT_C"` as the type of an instance.
fn type_name(name: &ast::TypeName) -> Option<Mention> {
    match &name.kind {
        ast::TypeKind::Block(kind, number) => Some(Mention::Number(*kind, *number)),
        ast::TypeKind::Symbol(symbol) => Some(Mention::Name(symbol.clone())),
        ast::TypeKind::Array { element, .. } => type_name(element),
        _ => None,
    }
}

/// What is called: by number or by name.
fn callee(operand: &ast::Operand, locals: &HashSet<String>) -> Option<Mention> {
    match operand {
        ast::Operand::Symbol { name, path } if path.is_empty() => Some(Mention::Name(name.text.clone())),
        ast::Operand::Name { word, path } if path.is_empty() && !locals.contains(&key(&word.text)) => {
            Some(Mention::Name(word.text.clone()))
        }
        ast::Operand::Absolute { letters, number, bit: None } => {
            BlockKind::from_abbreviation(letters).map(|kind| Mention::Number(kind, *number))
        }
        _ => None,
    }
}
