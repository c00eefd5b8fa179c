//! Steps into structured variables: `.field[3].x`.

use std::cell::RefCell;
use std::collections::HashMap;
use std::sync::Arc;

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, Structure};

use crate::declarations::types::describe;
use crate::scope::{Scope, did_you_mean, key};
use crate::stl::ast;

/// Structures with more fields than this get an index of their names.
const INDEXED_FIELDS: usize = 16;

/// Finds fields by name in constant time.
#[derive(Default)]
pub(crate) struct FieldNames {
    indexes: RefCell<HashMap<*const Structure, Index>>,
}

/// The fields of one structure by name.
struct Index {
    by_name: HashMap<String, usize>,
    /// Kept alive, so that its address stays its own.
    _structure: Arc<Structure>,
}

impl FieldNames {
    pub(crate) fn find(&self, structure: &Arc<Structure>, name: &str) -> Option<usize> {
        if structure.fields.len() <= INDEXED_FIELDS {
            return structure.fields.iter().position(|field| key(&field.name) == key(name));
        }
        let mut indexes = self.indexes.borrow_mut();
        let index = indexes.entry(Arc::as_ptr(structure)).or_insert_with(|| {
            let names = structure.fields.iter().enumerate().map(|(index, field)| (key(&field.name), index));
            Index { by_name: names.collect(), _structure: Arc::clone(structure) }
        });
        index.by_name.get(&key(name)).copied()
    }
}

/// Where a path leads from the start of a variable.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Reached {
    /// Position from the start of the variable, in bits.
    pub(crate) offset: u64,
    /// The type there.
    pub(crate) data_type: DataType,
}

/// Follows a path through a type.
pub(crate) fn follow(
    scope: &Scope,
    names: &FieldNames,
    start: &DataType,
    path: &[ast::PathElement],
    whole: Span,
) -> Result<Reached, Box<Diagnostic>> {
    let mut offset = 0u64;
    let mut at = start;
    let error = |problem, span, message: String| Err(Box::new(Diagnostic::new(problem, span, message)));
    for (step, element) in path.iter().enumerate() {
        match element {
            ast::PathElement::Field(word) => {
                let (DataType::Struct(structure) | DataType::Instance { structure, .. }) = at else {
                    let message = format!("{} has no field `{}`", describe(at), word.text);
                    return error(Problem::P4010, word.span, message);
                };
                let Some(index) = names.find(structure, &word.text) else {
                    let fields = structure.fields.iter().map(|field| field.name.as_str());
                    let message =
                        format!("{} has no field `{}`{}", describe(at), word.text, did_you_mean(scope.nearest(&word.text, fields)));
                    return error(Problem::P3007, word.span, message);
                };
                offset += u64::from(structure.fields[index].offset);
                at = &structure.fields[index].data_type;
            }
            ast::PathElement::Index(indexes, span) => match at {
                DataType::Array { bounds, element } => {
                    let Some(number) = at.element_number(indexes) else {
                        return error(Problem::P4005, *span, wrong_indexes(bounds, indexes));
                    };
                    offset += at.element_offset(number);
                    at = element;
                }
                // A character of a string, behind its two length bytes.
                DataType::String(length) if step + 1 == path.len() => {
                    let &[index] = indexes.as_slice() else {
                        return error(Problem::P4005, *span, "a character of a STRING has one index".to_owned());
                    };
                    if !(1..=i64::from(*length)).contains(&index) {
                        let message = format!("index {index} is outside 1..{length}");
                        return error(Problem::P4005, *span, message);
                    }
                    return Ok(Reached { offset: offset + (index as u64 + 1) * 8, data_type: DataType::Char });
                }
                other => {
                    let message = format!("{} is no array and takes no index", describe(other));
                    return error(Problem::P4010, if span.end > span.start { *span } else { whole }, message);
                }
            },
        }
    }
    Ok(Reached { offset, data_type: at.clone() })
}

/// Why an array has no element with these indexes.
fn wrong_indexes(bounds: &[(i32, i32)], indexes: &[i64]) -> String {
    let outside = bounds.iter().zip(indexes).find(|&(&(low, high), &index)| !(i64::from(low)..=i64::from(high)).contains(&index));
    match outside {
        Some(((low, high), index)) if bounds.len() == indexes.len() => format!("index {index} is outside {low}..{high}"),
        _ => format!("this array has {} dimensions, {} indexes are given", bounds.len(), indexes.len()),
    }
}
