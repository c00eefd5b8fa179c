//! DATA_BLOCK sources of ST → layouts and bytes of data blocks.

use std::collections::HashMap;
use std::sync::Arc;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::problems::Problem;
use sieben_model::program::DataBlock;
use sieben_model::types::{DataType, Structure, place};

use super::items::{Data, Items};
use super::types::{FieldLayout, Resolver, instance_of};
use super::{Types, access, ast, globals, instances};
use crate::declarations::data_block::{DataLayout, instance};
use crate::scope::{did_you_mean, key};
use crate::st::ast::{Expression, ExpressionKind};

/// Lays out the data blocks of ST: DATA_BLOCKs, instances of programs, lists of global variables, what functions keep.
pub(crate) fn layouts<'a>(types: &mut Types<'a>, items: &'a Items<'a>, data: &mut HashMap<u16, DataLayout>) -> globals::Globals {
    for (&number, &block) in &items.data {
        if let Some(layout) = layout(types, items, block) {
            data.insert(number, layout);
        }
    }
    for (block, instance, span) in items.own_instances() {
        if let Some(interface) = types.interface(block, span) {
            data.insert(instance, DataLayout { structure: interface.instance, based_on: Some(block) });
        }
    }
    types.reuse.begin_shared();
    let globals = globals::globals(types, items, data);
    types.reuse.end_shared();
    instances::tasks(items, data);
    access::rootless(types, items);
    for (number, structure) in &types.known.statics {
        data.insert(*number, DataLayout { structure: Arc::clone(structure), based_on: None });
    }
    globals
}

fn layout<'a>(types: &mut Types<'a>, items: &'a Items<'a>, data: Data<'a>) -> Option<DataLayout> {
    let block = data.block;
    let mut resolver = Resolver::new(types, items, data.dialect);
    if !block.sections.is_empty() {
        let fields: Vec<ast::Declaration> = block.sections.iter().flat_map(|section| section.declarations.iter().cloned()).collect();
        let structure = resolver.structure(&fields, None, None, FieldLayout::Sequence, block.name.span)?;
        return Some(DataLayout { structure, based_on: None });
    }
    if matches!(block.data_type.kind, ast::TypeKind::Missing) {
        return None;
    }
    let data_type = resolver.data_type(&block.data_type)?;
    let numbered = match &block.data_type.kind {
        ast::TypeKind::Named(path) => path.single().and_then(|name| number_of_type(items, &name.text)),
        _ => None,
    };
    match &data_type {
        DataType::Struct(structure) => Some(DataLayout { structure: Arc::clone(structure), based_on: numbered }),
        DataType::Instance { structure, .. } => Some(DataLayout { structure: Arc::clone(structure), based_on: instance_of(&data_type) }),
        // A data block of newer tools may be an array or a single value.
        other => {
            let (offset, behind) = place(0, other);
            let field = sieben_model::types::Field {
                name: "THIS".to_owned(),
                data_type: other.clone(),
                offset: offset as u32,
                initial: Vec::new(),
                comment: String::new(),
            };
            let size = (behind.next_multiple_of(16) / 8) as u32;
            Some(DataLayout {
                structure: Arc::new(Structure { name: None, fields: vec![field], size, index: Default::default() }),
                based_on: None,
            })
        }
    }
}

/// The UDT that a type is by its number.
fn number_of_type(items: &Items<'_>, name: &str) -> Option<BlockId> {
    let wanted = key(name);
    let found = items.numbered_types.iter().find(|(_, known)| **known == wanted);
    found.map(|(&number, _)| BlockId::new(BlockKind::UserDefinedType, number))
}

/// Whether the variables of a data block that was made for a program or for global variables begin anew at a warm restart:
/// without RETAIN they do. A data block is the smallest thing that keeps its values, so that one RETAIN keeps all of them.
pub(super) fn non_retain(items: &Items<'_>, number: u16) -> bool {
    if let Some(retain) = items.programs.iter().find(|program| program.instance == number).and_then(|program| program.retain) {
        return !retain;
    }
    if items.tasks == Some(number) {
        return true;
    }
    let keeps = |section: &ast::VarSection| section.has(ast::Qualifier::Retain) || section.has(ast::Qualifier::Persistent);
    let program = items.own_instances().find(|&(_, instance, _)| instance == number).and_then(|(block, ..)| items.code.get(&block));
    let kept = items.kept.iter().find(|(_, kept)| **kept == number).and_then(|(owner, _)| items.code.get(owner));
    match (program.or(kept), items.lists.iter().find(|list| list.number == number)) {
        (Some(code), _) => !code.block.sections.iter().any(keeps),
        (None, Some(list)) => !keeps(list.section),
        (None, None) => false,
    }
}

/// The bytes of a data block of ST.
pub(crate) fn fill<'a>(types: &mut Types<'a>, items: &'a Items<'a>, number: u16, layout: &DataLayout) -> Option<DataBlock> {
    let Some(&Data { block, dialect }) = items.data.get(&number) else {
        return Some(access::configured(types, items, number, layout));
    };
    let flag = |name: &str| block.header.flags.iter().any(|flag| flag.is(name));
    let mut data = instance(number, layout);
    data.read_only = flag("READ_ONLY");
    data.non_retain = flag("NON_RETAIN");
    data.unlinked = flag("UNLINKED");
    let whole = DataType::Struct(Arc::clone(&layout.structure));
    let mut resolver = Resolver::new(types, items, dialect);
    for (target, value) in &block.assignments {
        if let Some((position, data_type)) = resolver.reached(&whole, target) {
            resolver.fill(&mut data.image, position, &data_type, value);
        }
    }
    Some(data)
}

impl Resolver<'_, '_> {
    /// Position in bits and type of `a.b[3].c` in a structure; `None` if there is no such field, which is reported.
    fn reached(&mut self, whole: &DataType, path: &Expression) -> Option<(u64, DataType)> {
        match &path.kind {
            ExpressionKind::Name(name) => self.field(0, whole, name),
            ExpressionKind::Member(base, name) => {
                let (position, data_type) = self.reached(whole, base)?;
                self.field(position, &data_type, name)
            }
            ExpressionKind::Index(base, indexes) => {
                let (position, data_type) = self.reached(whole, base)?;
                let DataType::Array { element, bounds } = &data_type else {
                    self.report(
                        Problem::P4010,
                        path.span,
                        format!("{} is no array and takes no index", self.dialect.type_words(&data_type)),
                    );
                    return None;
                };
                let mut numbers = Vec::with_capacity(indexes.len());
                for index in indexes {
                    numbers.push(i64::try_from(self.integer(index)?).unwrap_or(i64::MAX));
                }
                let Some(number) = data_type.element_number(&numbers) else {
                    let bounds: Vec<String> = bounds.iter().map(|(low, high)| format!("{low}..{high}")).collect();
                    self.report(Problem::P4005, path.span, format!("the array has no such element; its indexes are {}", bounds.join(", ")));
                    return None;
                };
                Some((position + data_type.element_offset(number), (**element).clone()))
            }
            ExpressionKind::Missing => None,
            _ => {
                self.report(Problem::P4010, path.span, "this is no variable of the data block");
                None
            }
        }
    }

    fn field(&mut self, position: u64, data_type: &DataType, name: &ast::Name) -> Option<(u64, DataType)> {
        let (DataType::Struct(structure) | DataType::Instance { structure, .. }) = data_type else {
            self.report(Problem::P4010, name.span, format!("{} has no field `{}`", self.dialect.type_words(data_type), name.text));
            return None;
        };
        match structure.field(&name.text) {
            Some(field) => Some((position + u64::from(field.offset), field.data_type.clone())),
            None => {
                let nearest = self.types.scope.nearest(&name.text, structure.fields.iter().map(|field| field.name.as_str()));
                let message = format!("{} has no field `{}`{}", self.dialect.type_words(data_type), name.text, did_you_mean(nearest));
                self.report(Problem::P3007, name.span, message);
                None
            }
        }
    }
}
