//! Statements that failed.

use sieben_engine::machine::{Machine, Origin};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::literal::Value;

use super::operands::Named;
use super::telling::Telling;
use crate::sentences::memory::{Found, Trouble};
use crate::sentences::table::Sentence as S;
use crate::sentences::text::{Clause, Words};
use crate::stl::operands::Operand;
use crate::stl::why::Why;

/// Events of a programming error, an access error and an abort.
const OURS: [std::ops::RangeInclusive<u16>; 3] = [0x2521..=0x253F, 0x2942..=0x2943, 0x3571..=0x3576];

/// What a statement failed for, if it did.
pub(super) fn clause(telling: &Telling<'_>, named: &Named) -> Option<Clause> {
    let block = telling.event().place.block;
    let (event, reaction) = if let Some((event, handler)) = error_block(telling.moment.after, block) {
        (event, Clause::new(S::ReactionBlock).with("block", handler.to_string()))
    } else if let Some(event) = telling.moment.fault.filter(|event| OURS.iter().any(|ours| ours.contains(event))) {
        (event, Clause::new(S::ReactionStop))
    } else {
        (foreseen(telling, named)?, Clause::new(S::Nothing))
    };
    let none = |_: &str| None;
    let reaction = if reaction.sentence == S::Nothing { "".into() } else { reaction.words(&none) };
    let zero = if telling.why() == Why::Load { S::ReactionZero } else { S::ReactionNothing };
    let sentence = match event {
        0x2521 => S::FaultBcd,
        0x2522 | 0x2523 => S::FaultLength,
        0x2524 | 0x2525 => S::FaultArea,
        0x2526 => S::FaultTimer,
        0x2527 => S::FaultCounter,
        0x2528 | 0x2529 => S::FaultAlignment,
        0x2530 | 0x2531 => S::FaultProtected,
        0x2532..=0x2535 => S::FaultNumber,
        0x253A..=0x253F => S::FaultMissing,
        0x2942 | 0x2943 => S::FaultAccess,
        0x3571..=0x3576 => S::FaultAbort,
        _ => S::FaultOther,
    };
    let clause = Clause::new(sentence).with("reaction", reaction).with("zero", Clause::new(zero).words(&none));
    Some(clause.with("event", Words::from(format!("{event:04X}"))))
}

/// The event in the start information of an error block that this statement has called.
fn error_block(machine: &Machine, block: BlockId) -> Option<(u16, BlockId)> {
    let frame = machine.frames.last()?;
    let is_handler = frame.block.kind == BlockKind::OrganizationBlock && matches!(frame.block.number, 121 | 122);
    if !is_handler || frame.block == block || !matches!(frame.origin, Origin::Interrupt { .. }) {
        return None;
    }
    let at = machine.memory.layout.local.start + frame.local_base as usize;
    let bytes = machine.memory.arena.get(at..at + 2)?;
    Some((u16::from_be_bytes([bytes[0], bytes[1]]), frame.block))
}

/// The event of a failure that leaves no trace, as where the program has masked it: what the operand alone tells.
fn foreseen(telling: &Telling<'_>, named: &Named) -> Option<u16> {
    let reader = telling.reader();
    match telling.operand() {
        Operand::Memory(access) => match named.found? {
            Err(Trouble::Fault(event)) => Some(event),
            Ok(found) => outside(telling, found, access.width),
            Err(Trouble::Unknown) => None,
        },
        Operand::Timer(number) => (usize::from(reader.number(number)?) >= reader.machine.timers.len()).then_some(0x2526),
        Operand::Counter(number) => (usize::from(reader.number(number)?) >= reader.machine.counters.len()).then_some(0x2527),
        Operand::Block(block) if telling.why() == Why::OpenBlock => {
            let number = u64::from(reader.number(&block.number)?);
            (number != 0 && reader.machine.memory.data_block(number).is_none()).then_some(0x253A)
        }
        // `BTI` of what is no BCD number leaves everything as it was.
        Operand::None if matches!(telling.why(), Why::FromBcd(_)) => {
            let bits = telling.before().accu1 as u32;
            let digits = if matches!(telling.why(), Why::FromBcd(crate::stl::why::Number::Int)) { 3 } else { 7 };
            (!sieben_model::bcd::is_decimal(bits, digits)).then_some(0x2521)
        }
        Operand::Constant(Value::Pointer(_)) | Operand::None => None,
        _ => None,
    }
}

fn outside(telling: &Telling<'_>, found: Found, width: sieben_model::address::Width) -> Option<u16> {
    use sieben_model::address::Width;
    if width != Width::Bit && found.position & 7 != 0 {
        return Some(0x2528);
    }
    (!telling.reader().is_inside(&found, width)).then_some(0x2522)
}
