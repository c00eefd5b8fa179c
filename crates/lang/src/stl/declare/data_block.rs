//! DATA_BLOCK sources → data blocks with their bytes.

use std::sync::Arc;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::literal::Value;
use sieben_model::problems::Problem;
use sieben_model::program::DataBlock;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::names::block_of_name;
use super::path::{FieldNames, follow};
use crate::declarations::data_block::{DataLayout, instance};
use crate::declarations::reuse::Knows;
use crate::declarations::types::{Types, describe};
use crate::declarations::values::{coerce, write};
use crate::stl::ast;

/// The layout of a data block, without its values.
pub(crate) fn layout<K: Knows>(types: &mut Types<'_, K>, number: u16, block: &ast::Block) -> Option<DataLayout> {
    let id = BlockId::db(number);
    match &block.body_type {
        Some(ast::TypeName { kind: ast::TypeKind::Struct(fields), span }) => {
            let structure = types.structure(fields, None, *span)?;
            Some(DataLayout { structure, based_on: None })
        }
        Some(name) => {
            let based_on = match &name.kind {
                ast::TypeKind::Block(kind, number) => {
                    let name = ast::BlockName::Absolute { kind: *kind, number: *number, span: name.span };
                    block_of_name(types.scope, &name)
                }
                ast::TypeKind::Symbol(symbol) => {
                    block_of_name(types.scope, &ast::BlockName::Symbol(ast::Word { text: symbol.clone(), span: name.span }))
                }
                ast::TypeKind::Missing => return None,
                _ => Err(format!("`{id}` consists of a STRUCT, or is based on a UDT or a function block")),
            };
            let based_on = match based_on {
                Ok(based_on) => based_on,
                Err(message) => {
                    let elsewhere = matches!(&name.kind, ast::TypeKind::Symbol(symbol) if types.scope.global(symbol).is_none());
                    types.report(Problem::P2210, name.span, message).may_be_elsewhere = elsewhere;
                    return None;
                }
            };
            let structure = match based_on.kind {
                BlockKind::UserDefinedType => types.udt(based_on.number, name.span)?,
                BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock => {
                    if !types.exists(based_on) {
                        types
                            .report(Problem::P3008, name.span, format!("`{based_on}`, of which `{id}` is an instance, does not exist"))
                            .may_be_elsewhere = true;
                        return None;
                    }
                    types.interface(based_on, name.span)?.instance
                }
                _ => {
                    let message = format!("a data block cannot be based on `{based_on}`; it takes a STRUCT, a UDT, an FB or an SFB");
                    types.report(Problem::P2210, name.span, message);
                    return None;
                }
            };
            Some(DataLayout { structure, based_on: Some(based_on) })
        }
        // Sources of newer tools declare the fields under VAR.
        None if !block.sections.is_empty() => {
            let fields: Vec<ast::Declaration> = block.sections.iter().flat_map(|section| section.declarations.iter().cloned()).collect();
            let structure = types.structure(&fields, None, block.name.span())?;
            Some(DataLayout { structure, based_on: None })
        }
        None => {
            let message = format!("`{id}` has no STRUCT and is not based on a UDT or a function block");
            types.report(Problem::P2210, block.name.span(), message);
            None
        }
    }
}

/// A data block with the values that it starts with.
pub(crate) fn fill<K: Knows>(
    types: &mut Types<'_, K>,
    names: &FieldNames,
    number: u16,
    block: &ast::Block,
    layout: &DataLayout,
) -> DataBlock {
    let flag = |name: &str| block.header.flags.iter().any(|flag| flag.text.eq_ignore_ascii_case(name));
    let whole = DataType::Struct(Arc::clone(&layout.structure));
    let mut data = instance(number, layout);
    data.read_only = flag("READ_ONLY");
    data.non_retain = flag("NON_RETAIN");
    data.unlinked = flag("UNLINKED");
    for assignment in &block.assignments {
        if let [ast::PathElement::Field(word)] = assignment.path.as_slice()
            && word.text.eq_ignore_ascii_case("ALL")
            && names.find(&layout.structure, &word.text).is_none()
        {
            assign_all(types, &mut data.image, &whole, assignment);
            continue;
        }
        match follow(types.scope, names, &whole, &assignment.path, assignment.span) {
            Err(diagnostic) => types.diagnostics.push(*diagnostic),
            Ok(reached) => {
                let values = types.initial(&assignment.values, &reached.data_type);
                if values.is_empty() {
                    continue;
                }
                let element = match &reached.data_type {
                    DataType::Array { element, .. } => element,
                    other => other,
                };
                for (index, value) in values.iter().enumerate() {
                    let position = reached.offset + reached.data_type.element_offset(index as u64);
                    write(&mut data.image, position, element, value);
                }
            }
        }
    }
    data
}

/// `ALL := value`: every elementary variable that can hold the value gets it.
fn assign_all<K: Knows>(types: &mut Types<'_, K>, image: &mut [u8], whole: &DataType, assignment: &ast::Assignment) {
    let [ast::Initial::Value(constant)] = assignment.values.as_slice() else {
        types.report(Problem::P4007, assignment.span, "`ALL` takes one value");
        return;
    };
    let Some(value) = &constant.value else { return };
    if !write_everywhere(image, 0, whole, value) {
        report_unused(types, constant.span, whole);
    }
}

fn report_unused<K: Knows>(types: &mut Types<'_, K>, span: Span, whole: &DataType) {
    types.report(Problem::P4006, span, format!("no variable of this {} can hold this constant", describe(whole)));
}

fn write_everywhere(image: &mut [u8], position: u64, data_type: &DataType, value: &Value) -> bool {
    match data_type {
        DataType::Struct(structure) | DataType::Instance { structure, .. } => {
            let mut written = false;
            for field in &structure.fields {
                written |= write_everywhere(image, position + u64::from(field.offset), &field.data_type, value);
            }
            written
        }
        DataType::Array { element, .. } => {
            let mut written = false;
            for index in 0..data_type.elements() {
                if !write_everywhere(image, position + data_type.element_offset(index), element, value) {
                    break;
                }
                written = true;
            }
            written
        }
        _ => match coerce(value, data_type) {
            Ok(value) => {
                write(image, position, data_type, &value);
                true
            }
            Err(_) => false,
        },
    }
}
