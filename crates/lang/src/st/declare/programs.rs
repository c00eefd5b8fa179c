//! Organization blocks that call the programs of a project.

use std::collections::BTreeMap;

use sieben_model::block::BlockId;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use super::items::{Items, Program};
use crate::scope::key;
use crate::st::tree::{Base, Body, Call, Callee, Place, Statement, StatementKind};

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
    // Of several programs of CODESYS only PLC_PRG runs by itself.
    let default = items.programs.iter().find(|program| key(&program.of) == "plc_prg");
    for program in &items.programs {
        if default.is_none_or(|default| default.block == program.block) {
            add(&mut generated, main, program);
        }
    }
    generated
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
