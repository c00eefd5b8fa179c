//! Organization blocks that call the programs of a project.

use std::collections::{BTreeMap, BTreeSet};

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use super::items::{Items, Program};
use crate::scope::key;
use crate::st::objects::MemberKey;
use crate::st::tree::{Base, Body, Call, Callee, Place, Statement, StatementKind};

/// What each block calls.
type Calls = BTreeMap<BlockId, BTreeSet<BlockId>>;

/// An organization block that no source writes.
#[derive(Clone, Debug)]
pub(crate) struct Generated {
    pub(crate) body: Body,
    /// How often it is called, in milliseconds; `None` for OB 1.
    pub(crate) interval_ms: Option<u16>,
}

/// The organization block that runs the programs where no CONFIGURATION says what does: OB 1, unless a source writes it.
pub(crate) fn organization_blocks(
    items: &Items<'_>,
    calls: &Calls,
    exists: &dyn Fn(BlockId) -> bool,
    diagnostics: &mut Vec<Diagnostic>,
) -> BTreeMap<BlockId, Generated> {
    let mut generated = BTreeMap::new();
    if items.programs.is_empty() {
        return generated;
    }
    let main = BlockId::ob(1);
    if exists(main) {
        for program in items.programs.iter().filter(|program| program.implicit) {
            let message = "these statements stand outside any block, and `OB 1` exists already";
            diagnostics.push(Diagnostic::new(Problem::P3002, program.span, message));
        }
        return generated;
    }
    // Of several programs of CODESYS only PLC_PRG runs by itself; those that others call run when they are called.
    let default = items.programs.iter().find(|program| key(&program.of) == "plc_prg");
    let running = running(items, calls);
    for program in &items.programs {
        if default.map_or(running.contains(&program.block), |default| default.block == program.block) {
            add(&mut generated, main, program);
        }
    }
    generated
}

/// The programs that run by themselves: what calls one of them, through whatever blocks, is called by it, too.
fn running(items: &Items<'_>, calls: &Calls) -> BTreeSet<BlockId> {
    let programs: BTreeSet<BlockId> = items.programs.iter().map(|program| program.block).collect();
    let organization_blocks = items.code.keys().copied().filter(|block| block.kind == BlockKind::OrganizationBlock);
    let mut alike: BTreeMap<_, Vec<BlockId>> = BTreeMap::new();
    for (name, member) in items.objects.iter().flat_map(|(_, object)| &object.members) {
        alike.entry(name).or_default().push(member.function);
    }
    let callers = programs.iter().copied().chain(organization_blocks);
    let reached: BTreeMap<BlockId, BTreeSet<BlockId>> =
        callers.map(|caller| (caller, reached(caller, items, calls, &alike).intersection(&programs).copied().collect())).collect();
    let runs = |program: &BlockId| {
        let mut by = reached.iter().filter(|(_, called)| called.contains(program));
        by.all(|(caller, _)| caller == program || reached[program].contains(caller))
    };
    programs.iter().copied().filter(runs).collect()
}

/// All that a block calls, and what that calls.
fn reached(block: BlockId, items: &Items<'_>, calls: &Calls, alike: &BTreeMap<&MemberKey, Vec<BlockId>>) -> BTreeSet<BlockId> {
    let (mut reached, mut open) = (BTreeSet::new(), vec![block]);
    while let Some(caller) = open.pop() {
        let mut see = |called: BlockId| {
            if reached.insert(called) {
                open.push(called);
            }
        };
        calls.get(&caller).into_iter().flatten().copied().for_each(&mut see);
        // A call by a base or an interface may reach each block below, and each member of that name.
        items.objects.concrete(caller).for_each(&mut see);
        if let Some(member) = items.code.get(&caller).and_then(|code| code.block.member.as_ref()) {
            alike.get(&(key(&member.name.text), member.kind)).into_iter().flatten().copied().for_each(&mut see);
        }
    }
    reached
}

/// Lets an organization block call a program.
fn add(generated: &mut BTreeMap<BlockId, Generated>, block: BlockId, program: &Program) {
    let span = program.span;
    let instance = Place { base: Base::DataBlock(program.instance), offset: 0, indexes: Vec::new(), span };
    let callee = Callee::Instance { block: program.block, instance, dispatch: None };
    let call = Call::plain(callee, Vec::new(), span);
    let one = generated.entry(block).or_insert_with(|| Generated { body: Body::default(), interval_ms: None });
    one.body.statements.push(Statement { kind: StatementKind::Call(call), span });
}
