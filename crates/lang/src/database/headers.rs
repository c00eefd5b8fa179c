//! Which blocks the sources of STL have, and which numbers.

use std::collections::{HashMap, HashSet};

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};

use super::syntax::{StlFile, Syntax};
use crate::declarations::reuse::Stamp;
use crate::library::link::Mention;
use crate::scope::Scope;
use crate::stl::ast;
use crate::stl::declare::names::block_of_name;

/// A block of a source with its identity.
#[derive(Clone, Copy)]
pub(super) struct Found<'a> {
    pub(super) id: BlockId,
    pub(super) block: &'a ast::Block,
    pub(super) mnemonics: Mnemonics,
    pub(super) stamp: Stamp,
    pub(super) mentions: &'a [Mention],
    /// Its statements that call an instance by its data block.
    pub(super) instances: &'a [usize],
    /// Its source.
    pub(super) syntax: &'a Syntax,
}

impl<'a> Found<'a> {
    /// All blocks of a source, before their numbers are known.
    pub(super) fn all(file: &'a StlFile, syntax: &'a Syntax) -> impl Iterator<Item = Self> {
        let blocks = file.file.blocks.iter().zip(&file.stamps).zip(file.mentions.iter().zip(&file.instances));
        blocks.map(move |((block, &stamp), (mentions, instances))| Self {
            id: BlockId::ob(0),
            block,
            mnemonics: file.mnemonics,
            stamp,
            mentions,
            instances,
            syntax,
        })
    }
}

/// The identities of all blocks; of two with the same number only the first is kept.
pub(super) fn find_blocks<'a>(
    blocks: impl Iterator<Item = Found<'a>>,
    scope: &Scope,
    cpu: &CpuType,
    replacing: Option<FileId>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Found<'a>> {
    let mut found: Vec<Found<'a>> = Vec::new();
    let mut places: HashMap<BlockId, Span> = HashMap::new();
    let mut doubled: HashSet<BlockId> = HashSet::new();
    for unnamed in blocks {
        let block = unnamed.block;
        let span = block.name.span();
        let id = match block_of_name(scope, &block.name) {
            Ok(id) => id,
            Err(message) => {
                let problem = match &block.name {
                    // The parser has reported a name that is missing.
                    ast::BlockName::Symbol(word) if word.text.is_empty() => continue,
                    ast::BlockName::Symbol(_) => Problem::P3003,
                    ast::BlockName::Absolute { .. } => Problem::P5003,
                };
                let diagnostic = Diagnostic::new(problem, span, message);
                diagnostics.push(if problem == Problem::P3003 { diagnostic.elsewhere() } else { diagnostic });
                continue;
            }
        };
        if id.kind != block.kind {
            let message = format!("`{id}` is not {}; this header begins {}", article(block.kind), article(block.kind));
            diagnostics.push(Diagnostic::new(Problem::P2200, span, message));
            continue;
        }
        let limit = match id.kind {
            BlockKind::DataBlock => cpu.db_number_max,
            BlockKind::Function | BlockKind::FunctionBlock => cpu.fc_number_max,
            _ => u16::MAX,
        };
        if id.number > limit {
            let message = format!("`{id}`: CPU {} has numbers up to {limit}", cpu.name);
            diagnostics.push(Diagnostic::new(Problem::P5003, span, message));
        }
        if id.kind == BlockKind::OrganizationBlock && !cpu.has_organization_block(id.number) {
            diagnostics.push(not_called(cpu, id.number, span));
        }
        if id == BlockId::db(0) {
            diagnostics.push(Diagnostic::new(Problem::P5003, span, "`DB 0` is reserved; data blocks begin with `DB 1`"));
            continue;
        }
        if let Some(&first) = places.get(&id) {
            if replacing == Some(first.file) && first.file != span.file {
                continue;
            }
            let message = |implicit: bool| match implicit {
                true => format!("these statements outside any block are `{id}`, which exists already"),
                false => format!("`{id}` exists twice"),
            };
            diagnostics.push(Diagnostic::new(Problem::P3002, span, message(block.implicit)).related(first, "the other one is here"));
            if doubled.insert(id) {
                diagnostics
                    .push(Diagnostic::new(Problem::P3002, first, format!("`{id}` exists twice")).related(span, "the other one is here"));
            }
            continue;
        }
        places.insert(id, span);
        found.push(Found { id, ..unnamed });
    }
    found
}

fn article(kind: BlockKind) -> &'static str {
    match kind {
        BlockKind::OrganizationBlock => "an organization block (OB)",
        BlockKind::Function => "a function (FC)",
        BlockKind::FunctionBlock => "a function block (FB)",
        BlockKind::DataBlock => "a data block (DB)",
        BlockKind::SystemFunction => "a system function (SFC)",
        BlockKind::SystemFunctionBlock => "a system function block (SFB)",
        BlockKind::UserDefinedType => "a user-defined type (UDT)",
    }
}

/// The warning about an organization block that never runs.
fn not_called(cpu: &CpuType, number: u16, span: Span) -> Diagnostic {
    let ranges = cpu.organization_blocks.iter().map(|&(first, last)| match last - first {
        0 => format!("{first}"),
        1 => format!("{first}, {last}"),
        _ => format!("{first} to {last}"),
    });
    let message = format!("the CPU {} never calls `OB {number}`; it calls OB {}", cpu.name, ranges.collect::<Vec<_>>().join(", "));
    let others: Vec<&str> = CpuType::ALL.iter().filter(|other| other.has_organization_block(number)).map(|other| other.name).collect();
    let diagnostic = Diagnostic::new(Problem::P5010, span, message);
    if others.is_empty() { diagnostic } else { diagnostic.help(format!("CPU types that call it: {}", others.join(", "))) }
}
