//! Numbers for blocks that have only a name.

use std::collections::{HashMap, HashSet};

use sieben_model::address::Operand;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};

use crate::scope::{Scope, key};

/// A block that needs a number.
#[derive(Clone, Debug)]
pub(crate) struct Wanted {
    /// Its name; empty if its number is its name.
    pub(crate) name: String,
    pub(crate) kind: BlockKind,
    /// The number that its name or the symbol table gives it.
    pub(crate) fixed: Option<BlockId>,
    /// The place of its name.
    pub(crate) span: Span,
    /// The path of its source, if it is a block of the library: these get their numbers behind all others.
    pub(crate) library: Option<&'static str>,
}

/// The number of each block, in the order given; `None` if it cannot have one, which is reported.
///
/// Numbers are given downwards from the greatest of the CPU type, in the order of the names: they do not change when sources are
/// moved about, and they stay clear of those that people choose.
pub(crate) fn assign(
    wanted: &[&Wanted],
    scope: &Scope,
    cpu: &CpuType,
    replacing: Option<FileId>,
    taken: &mut HashMap<BlockId, Span>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Option<BlockId>> {
    let mut numbers: Vec<Option<BlockId>> = vec![None; wanted.len()];
    for (number, one) in numbers.iter_mut().zip(wanted) {
        let Some(id) = one.fixed else { continue };
        if let Some(&first) = taken.get(&id) {
            if replacing == Some(first.file) && first.file != one.span.file {
                continue;
            }
            let message = format!("`{id}` exists twice");
            diagnostics.push(Diagnostic::new(Problem::P3002, one.span, message).related(first, "the other one is here"));
            continue;
        }
        if id == BlockId::db(0) {
            diagnostics.push(Diagnostic::new(Problem::P5003, one.span, "`DB 0` is reserved; data blocks begin with `DB 1`"));
            continue;
        }
        if id.number > limit(id.kind, cpu) {
            let message = format!("`{id}`: CPU {} has numbers up to {}", cpu.name, limit(id.kind, cpu));
            diagnostics.push(Diagnostic::new(Problem::P5003, one.span, message));
        }
        taken.insert(id, one.span);
        *number = Some(id);
    }
    let symbols: HashSet<BlockId> =
        scope.operands().filter_map(|operand| if let Operand::Block(id) = operand { Some(id) } else { None }).collect();
    let mut order: Vec<usize> = (0..wanted.len()).filter(|&index| wanted[index].fixed.is_none()).collect();
    order.sort_by_cached_key(|&index| (wanted[index].library, key(&wanted[index].name), index));
    let mut next: HashMap<BlockKind, u32> = HashMap::new();
    for index in order {
        let one = wanted[index];
        let next = next.entry(one.kind).or_insert_with(|| u32::from(limit(one.kind, cpu)));
        let free = std::iter::from_fn(|| {
            let number = u16::try_from(*next).ok().filter(|&number| number > 0)?;
            *next -= 1;
            Some(BlockId::new(one.kind, number))
        })
        .find(|id| !taken.contains_key(id) && !symbols.contains(id));
        match free {
            Some(id) => {
                taken.insert(id, one.span);
                numbers[index] = Some(id);
            }
            None => {
                let message = format!(
                    "there is no free number for `{}`: CPU {} has {} up to {}",
                    one.name,
                    cpu.name,
                    one.kind.abbreviation(),
                    limit(one.kind, cpu)
                );
                diagnostics.push(Diagnostic::new(Problem::P5003, one.span, message));
            }
        }
    }
    numbers
}

/// The greatest number of a block of this kind.
fn limit(kind: BlockKind, cpu: &CpuType) -> u16 {
    match kind {
        BlockKind::DataBlock => cpu.db_number_max,
        BlockKind::Function | BlockKind::FunctionBlock => cpu.fc_number_max,
        _ => u16::MAX,
    }
}
