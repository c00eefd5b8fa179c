//! Temporary variables that are read before anything is written to them: VAR_TEMP holds what earlier blocks left there.

use std::collections::{BTreeMap, BTreeSet};

use sieben_model::address::{Area, Width};
use sieben_model::block::BlockKind;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::{Interface, Section};
use sieben_model::literal::Value;
use sieben_model::problems::Problem;
use sieben_model::types::DataType;

use super::flow;
use crate::stl::instructions::Instruction;
use crate::stl::lower::{ResolvedBlock, Statement};
use crate::stl::operands::{Access, Actual, Direction, Location, NumberOperand, Operand};

/// Bits of start information that an organization block finds in its local data.
const START_INFORMATION_BITS: u32 = 160;
/// States times pieces that are looked at: a block of 65,536 statements with hundreds of variables. What is larger was made by a program.
const WORK_MAX: usize = 1 << 26;

/// How much is reported.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TemporaryReads {
    /// Only reads that no write comes before on any path: nothing speaks for them.
    #[default]
    Certain,
    /// Also reads that a write comes before on some paths only. A program may know why the others are not taken.
    Possible,
}

/// What a statement does to bits of the local data.
struct Use {
    writes: bool,
    first: u32,
    behind: u32,
}

/// Reports reads of local data that were not written before.
pub(super) fn check(block: &ResolvedBlock, reads: TemporaryReads, diagnostics: &mut Vec<Diagnostic>) {
    let Some(known) = known_from_the_start(block) else { return };
    let uses: Vec<Vec<Use>> = block.statements.iter().map(uses).collect();
    // All local data fall into pieces, of which each use has some wholly.
    let ends: BTreeSet<u32> = uses.iter().flatten().chain(&known).flat_map(|one| [one.first, one.behind]).collect();
    let pieces: BTreeMap<u32, usize> = ends.into_iter().enumerate().map(|(index, end)| (end, index)).collect();
    let words = pieces.len().div_ceil(64);
    if uses.iter().flatten().all(|one| one.writes) || words * block.statements.len() > WORK_MAX / 64 {
        return;
    }
    let range = |one: &Use| pieces[&one.first]..pieces[&one.behind];
    let mut start = vec![0_u64; words];
    known.iter().for_each(|one| set(&mut start, range(one)));
    let written = |index: usize, state: &Vec<u64>| {
        let mut state = state.clone();
        uses[index].iter().filter(|one| one.writes).for_each(|one| set(&mut state, range(one)));
        state
    };
    let or = |known: &mut Vec<u64>, more: &Vec<u64>| merge(known, more, |a, b| a | b);
    let and = |known: &mut Vec<u64>, more: &Vec<u64>| merge(known, more, |a, b| a & b);
    let somewhere = flow::states(&block.statements, start.clone(), written, or);
    let everywhere = match reads {
        TemporaryReads::Certain => Vec::new(),
        TemporaryReads::Possible => flow::states(&block.statements, start, written, and),
    };
    // Each variable is reported at its first read.
    let mut reported = vec![0_u64; words];
    for (index, statement) in block.statements.iter().enumerate() {
        for one in uses[index].iter().filter(|one| !one.writes) {
            let bits = range(one);
            let Some(state) = &somewhere[index] else { continue };
            let certain = bits.clone().all(|bit| !is_set(state, bit));
            let possible = everywhere.get(index).and_then(Option::as_ref).is_some_and(|state| bits.clone().any(|bit| !is_set(state, bit)));
            if !(certain || possible) || bits.clone().any(|bit| is_set(&reported, bit)) {
                continue;
            }
            set(&mut reported, bits);
            let name = name(&block.interface, one);
            diagnostics.push(if certain {
                let message = format!("{name} is read here, and nothing in this block has written it before");
                Diagnostic::new(Problem::P4020, statement.span(), message)
            } else {
                Diagnostic::new(
                    Problem::P4021,
                    statement.span(),
                    format!("{name} is read here, but not written on every path to this statement"),
                )
            });
        }
    }
}

/// What has a value when the block begins; `None` if the block writes its local data through pointers, so that nobody can say.
fn known_from_the_start(block: &ResolvedBlock) -> Option<Vec<Use>> {
    let mut known = Vec::new();
    if block.id.kind == BlockKind::OrganizationBlock {
        known.push(Use { writes: true, first: 0, behind: START_INFORMATION_BITS });
    }
    let takes_addresses = block.statements.iter().any(takes_address);
    for statement in &block.statements {
        let writes = !matches!(statement.instruction.direction(), Some(Direction::Read) | None);
        match &statement.operand {
            Operand::Memory(Access { location, .. }) if writes => match location {
                Location::MemoryIndirect { area: Area::Local, .. } | Location::RegisterIndirect { area: Some(Area::Local), .. } => {
                    return None;
                }
                Location::RegisterIndirect { area: None, .. } if takes_addresses => return None,
                _ => {}
            },
            // `P##name`: from here on the variable is written in ways that no one sees.
            Operand::Constant(Value::Pointer(pointer)) if local(*pointer) => known.push(variable_at(&block.interface, *pointer)?),
            Operand::Constant(Value::DoubleWord(word)) if local(*word) => return None,
            Operand::Call(call) => {
                for parameter in &call.parameters {
                    match &parameter.actual {
                        Some(Actual::Constant(Value::Any(any))) if any[6] == Area::Local.pointer_code() => return None,
                        Some(Actual::Constant(Value::Pointer(pointer) | Value::DataPointer { pointer, .. })) if local(*pointer) => {
                            return None;
                        }
                        _ => {}
                    }
                }
            }
            _ => {}
        }
    }
    Some(known)
}

/// Whether a statement takes the address of a variable: what the block writes through an address register may then lie there.
fn takes_address(statement: &Statement) -> bool {
    matches!(statement.operand, Operand::Constant(Value::Pointer(pointer)) if local(pointer))
}

/// Whether a pointer leads into the local data.
fn local(pointer: u32) -> bool {
    pointer >> 24 == u32::from(Area::Local.pointer_code())
}

/// The variable of VAR_TEMP that a pointer points to; `None` if it points somewhere else.
fn variable_at(interface: &Interface, pointer: u32) -> Option<Use> {
    let position = pointer & 0x00FF_FFFF;
    let mut temporaries = interface.variables.iter().filter(|variable| variable.section == Section::Temp);
    let variable = temporaries.find(|variable| variable.offset == position)?;
    Some(Use { writes: true, first: position, behind: position + bits(&variable.data_type) })
}

fn bits(data_type: &DataType) -> u32 {
    u32::try_from(data_type.bits()).unwrap_or(u32::MAX / 2).max(1)
}

/// What a statement does with local data that it names itself.
fn uses(statement: &Statement) -> Vec<Use> {
    let mut uses = Vec::new();
    match &statement.operand {
        Operand::Memory(access) => {
            pointer_read(&access.location, &mut uses);
            // S and R keep the bit on some paths; which ones, the program knows. FP and FN have a warning of their own.
            let writes = !matches!(statement.instruction.direction(), Some(Direction::Read));
            direct(access, writes, &mut uses);
        }
        Operand::Timer(number) | Operand::Counter(number) => number_read(number, &mut uses),
        Operand::Block(block) => number_read(&block.number, &mut uses),
        Operand::Call(call) => {
            // Inputs are read before outputs are written.
            for parameter in &call.parameters {
                match &parameter.actual {
                    Some(Actual::Memory(access)) => {
                        pointer_read(&access.location, &mut uses);
                        if parameter.section == Section::Input {
                            direct(access, false, &mut uses);
                        }
                    }
                    Some(Actual::Timer(number) | Actual::Counter(number) | Actual::Block(number)) => number_read(number, &mut uses),
                    _ => {}
                }
            }
            for parameter in &call.parameters {
                match &parameter.actual {
                    Some(Actual::Memory(access)) if parameter.section != Section::Input => direct(access, true, &mut uses),
                    // Behind a pointer the called block may write, whatever the section is called; an array may be filled in part.
                    Some(Actual::Complex { location: Location::Fixed { area: Area::Local, position }, data_type }) => {
                        uses.push(Use { writes: true, first: *position, behind: position.saturating_add(bits(data_type)) });
                    }
                    _ => {}
                }
            }
        }
        _ => {}
    }
    debug_assert!(uses.iter().all(|one| one.first < one.behind), "a use of local data has at least one bit");
    if statement.instruction == Instruction::Nop0 { Vec::new() } else { uses }
}

fn direct(access: &Access, writes: bool, uses: &mut Vec<Use>) {
    if let Location::Fixed { area: Area::Local, position } = access.location {
        let bits = if access.width == Width::Bit { 1 } else { access.width.bytes() * 8 };
        uses.push(Use { writes, first: position, behind: position + bits });
    }
}

fn pointer_read(location: &Location, uses: &mut Vec<Use>) {
    if let Location::MemoryIndirect { pointer, .. } = location {
        direct(&Access { width: Width::DoubleWord, location: (**pointer).clone() }, false, uses);
    }
}

fn number_read(number: &NumberOperand, uses: &mut Vec<Use>) {
    if let NumberOperand::Indirect(location) = number {
        direct(&Access { width: Width::Word, location: (**location).clone() }, false, uses);
    }
}

/// The variable that lies there, else the address.
fn name(interface: &Interface, one: &Use) -> String {
    let temporaries = interface.variables.iter().filter(|variable| variable.section == Section::Temp);
    let inside = |offset: u32, size: u32| offset <= one.first && one.first < offset.saturating_add(size);
    match temporaries.rev().find(|variable| inside(variable.offset, bits(&variable.data_type))) {
        Some(variable) if variable.offset == one.first => format!("`#{}`", variable.name),
        Some(variable) => format!("a part of `#{}`", variable.name),
        None if one.behind - one.first == 1 => format!("`L {}.{}`", one.first / 8, one.first % 8),
        None => format!("byte {} of the local data", one.first / 8),
    }
}

fn set(state: &mut [u64], bits: std::ops::Range<usize>) {
    bits.for_each(|bit| state[bit / 64] |= 1 << (bit % 64));
}

fn is_set(state: &[u64], bit: usize) -> bool {
    state[bit / 64] >> (bit % 64) & 1 == 1
}

fn merge(known: &mut [u64], more: &[u64], with: impl Fn(u64, u64) -> u64) -> bool {
    let mut changed = false;
    for (known, more) in known.iter_mut().zip(more) {
        let joined = with(*known, *more);
        changed |= joined != *known;
        *known = joined;
    }
    changed
}
