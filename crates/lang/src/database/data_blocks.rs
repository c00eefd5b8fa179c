//! The bytes of all data blocks, and the instances that no source writes.

use std::collections::{BTreeMap, HashMap};

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::program::DataBlock;
use sieben_model::source::Span;

use super::headers::Found;
use crate::declarations::data_block::{DataLayout, instance};
use crate::declarations::types::BlockInterface;
use crate::scope::Scope;
use crate::st;
use crate::st::declare::{Items, Types};
use crate::stl::ast;
use crate::stl::declare::Blocks;
use crate::stl::declare::data_block::fill;
use crate::stl::declare::path::FieldNames;
use crate::stl::resolve::{plain_callee, plain_data_block};

/// Bytes that all data blocks of a project may have together: the work memory of the largest CPU type.
const DATA_BYTES_MAX: usize = 32 << 20;

/// Instance data blocks that calls name and no source defines, in the order of their numbers.
pub(super) fn missing_instances(
    found: &[Found<'_>],
    items: &Items<'_>,
    scope: &Scope,
    interfaces: &HashMap<BlockId, BlockInterface>,
    data: &mut HashMap<u16, DataLayout>,
    blocks: &Blocks<'_>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<u16> {
    let mut generated = Vec::new();
    let statements = found.iter().flat_map(|found| found.instances.iter().filter_map(|&index| found.block.statements.get(index)));
    let of_stl = statements.filter_map(|statement| {
        let ast::Operand::Call(call) = &statement.operand else { return None };
        let (operand, span) = call.instance.as_ref()?;
        Some((plain_callee(scope, &call.callee)?, plain_data_block(scope, operand)?, *span))
    });
    let calls: Vec<(BlockId, u16, Span)> = of_stl.chain(items.instances_called()).collect();
    for (callee, number, span) in calls {
        if number == 0 || data.contains_key(&number) || blocks.contains_key(&BlockId::db(number)) {
            continue;
        }
        let Some(BlockInterface { instance, .. }) = interfaces.get(&callee) else { continue };
        if matches!(callee.kind, BlockKind::Function | BlockKind::SystemFunction) {
            continue;
        }
        data.insert(number, DataLayout { structure: instance.clone(), based_on: Some(callee) });
        generated.push(number);
        let message = format!("`DB {number}` has no source; it is made as an instance of `{callee}`");
        diagnostics.push(Diagnostic::new(Problem::P3014, span, message).elsewhere());
    }
    generated.sort_unstable();
    generated
}

pub(super) fn fill_data<'a>(
    types: &mut Types<'a>,
    field_names: &FieldNames,
    found: &[Found<'_>],
    items: &'a Items<'a>,
    data: &HashMap<u16, DataLayout>,
    generated: &[u16],
    program: &mut BTreeMap<u16, DataBlock>,
) {
    let mut total = 0;
    for Found { id, block, .. } in found {
        if id.kind != BlockKind::DataBlock {
            continue;
        }
        let Some(layout) = data.get(&id.number) else { continue };
        total += layout.structure.size as usize;
        if total > DATA_BYTES_MAX {
            let message = format!("with `{id}` the data blocks have more than {} MB", DATA_BYTES_MAX >> 20);
            types.report(Problem::P5006, block.name.span(), message);
            return;
        }
        program.insert(id.number, fill(types, field_names, id.number, block, layout));
    }
    let mut of_st: Vec<u16> = data.keys().copied().filter(|number| !program.contains_key(number) && !generated.contains(number)).collect();
    of_st.sort_unstable();
    for number in generated.iter().chain(&of_st) {
        let Some(layout) = data.get(number) else { continue };
        total += layout.structure.size as usize;
        if total > DATA_BYTES_MAX {
            let message = format!("with `DB {number}` the data blocks have more than {} MB", DATA_BYTES_MAX >> 20);
            types.report(Problem::P5006, Span::default(), message);
            return;
        }
        let block = st::declare::fill(types, items, *number, layout);
        program.insert(*number, block.unwrap_or_else(|| instance(*number, layout)));
    }
}
