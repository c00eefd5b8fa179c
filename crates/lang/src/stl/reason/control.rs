//! Reasons of jumps, calls, block ends and data blocks.

use sieben_engine::machine::Origin;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::Section;

use super::telling::Telling;
use crate::sentences::memory::Reader;
use crate::sentences::table::Sentence as S;
use crate::sentences::text::{Clause, Words, loose_words, one_line, typed};
use crate::stl::extension::Extension;
use crate::stl::instructions::Instruction;
use crate::stl::meaning::jumps::list_entries;
use crate::stl::operands::{Actual, CallParameter, DataBlockInfo, Operand};
use crate::stl::why::Why;

/// Parameters of a call that a sentence shows.
const PARAMETERS_SHOWN: usize = 6;

/// Jumps.
pub(super) fn jump(telling: &Telling<'_>, why: Why) -> Vec<Clause> {
    let before = telling.before();
    let label = telling.operand_text();
    let taken = why.condition().is_some_and(|condition| condition.value(before) == 1);
    let sentence = |[jump, stay]: [S; 2]| Clause::new(if taken { jump } else { stay });
    let clause = match why {
        Why::JumpIfRlo | Why::JumpIfNotRlo => {
            let saves = telling
                .statement
                .is_some_and(|statement| matches!(statement.instruction, Instruction::JumpIfRloSave | Instruction::JumpIfNotRloSave));
            let saved = match saves {
                true => Words([format!(" (BR takes {})", before.rlo), format!(" (BIE übernimmt {})", before.rlo)]),
                false => "".into(),
            };
            sentence([S::JumpRlo, S::StayRlo]).with("saved", saved)
        }
        Why::JumpIfBr | Why::JumpIfNotBr => sentence([S::JumpBr, S::StayBr]),
        Why::JumpIfOverflow => sentence([S::JumpOv, S::StayOv]),
        Why::JumpIfStoredOverflow => sentence([S::JumpOs, S::StayOs]),
        Why::JumpIf(_) => {
            let status = match (before.cc1 == 1, before.cc0 == 1) {
                (false, false) => ["zero or equal", "null oder gleich"],
                (true, false) => ["above 0, greater or not 0", "größer (als 0) oder nicht 0"],
                (false, true) => ["below 0 or less", "kleiner (als 0)"],
                (true, true) => ["no valid result", "kein gültiges Ergebnis"],
            };
            sentence([S::JumpStatus, S::StayStatus]).with("status", status)
        }
        Why::JumpList => return vec![jump_list(telling)],
        Why::Loop => {
            let count = telling.after().accu1 & 0xFFFF;
            let clause = sentence([S::LoopAgain, S::LoopEnds]);
            clause.with("a", before.accu1 & 0xFFFF).with("result", count)
        }
        _ => Clause::new(S::Jump),
    };
    vec![clause.with("label", label)]
}

/// `JL`: the run of `JU` behind it, as far as its label.
fn jump_list(telling: &Telling<'_>) -> Clause {
    let value = telling.before().accu1 & 0xFF;
    let list = list_entries(&telling.block.statements, telling.event().place.statement as usize);
    match list.get(value as usize) {
        Some(entry) => {
            let text = one_line(telling.around.slice(entry.span()));
            let label = text.rsplit(' ').next().unwrap_or_default().to_owned();
            Clause::new(S::JumpList).with("value", value).with("label", label)
        }
        None => {
            let last = match list.len().checked_sub(1) {
                Some(last) => Words::from(last as u64),
                None => ["nothing", "nichts"].into(),
            };
            Clause::new(S::JumpListBeyond).with("value", value).with("last", last).with("label", telling.operand_text())
        }
    }
}

/// Calls and block ends.
pub(super) fn call_or_end(telling: &Telling<'_>, why: Why) -> Vec<Clause> {
    let rlo = telling.before().rlo;
    vec![match why {
        Why::Call => call(telling),
        Why::CallBlock => Clause::new(S::Call).with("block", called(telling)),
        Why::CallIfRlo => Clause::new(if rlo == 1 { S::CallRlo } else { S::CallNot }).with("block", called(telling)),
        Why::EndIfRlo => Clause::new(if rlo == 1 { S::EndRlo } else { S::EndNot }),
        _ => end(telling),
    }]
}

/// `FC 1 "Dosing"`.
fn block_name(telling: &Telling<'_>, block: BlockId) -> String {
    match telling.around.block_names.get(&block) {
        Some(name) => format!("{block} \"{name}\""),
        None => block.to_string(),
    }
}

/// The block that `UC` or `CC` names.
fn called(telling: &Telling<'_>) -> String {
    match telling.operand() {
        Operand::Block(block) => match telling.reader().number(&block.number) {
            Some(number) => block_name(telling, BlockId::new(block.kind, number)),
            None => telling.operand_text(),
        },
        _ => telling.operand_text(),
    }
}

fn call(telling: &Telling<'_>) -> Clause {
    let Operand::Call(call) = telling.operand() else { return Clause::new(S::Call).with("block", telling.operand_text()) };
    let name = block_name(telling, call.callee);
    let reader = telling.reader();
    // A system function has run when the statement is over: what it was given may have changed.
    let has_run = matches!(call.callee.kind, BlockKind::SystemFunction | BlockKind::SystemFunctionBlock);
    let known = !has_run || telling.moment.before.is_some();
    let mut parameters: Vec<Words> = call.parameters.iter().filter_map(|parameter| passed(&reader, parameter, known, telling)).collect();
    let more = parameters.len() > PARAMETERS_SHOWN;
    parameters.truncate(PARAMETERS_SHOWN);
    if parameters.is_empty() {
        return Clause::new(S::Call).with("block", name);
    }
    let joined = |language: usize| {
        let mut text = parameters.iter().map(|words| words.0[language].as_str()).collect::<Vec<_>>().join(", ");
        if more {
            text.push_str(", …");
        }
        text
    };
    Clause::new(S::CallWith).with("block", name).with("parameters", Words([joined(0), joined(1)]))
}

/// `START = 1`, `LEVEL => MW 10`.
fn passed(reader: &Reader<'_>, parameter: &CallParameter, known: bool, telling: &Telling<'_>) -> Option<Words> {
    let name = &parameter.name;
    let written = one_line(telling.around.slice(parameter.span));
    // An output of a box is written with an arrow.
    let written = written.split_once(":=").or_else(|| written.split_once("=>")).map_or(written.as_str(), |(_, actual)| actual.trim());
    let text = |value: &Words| Words([format!("{name} = {}", value.0[0]), format!("{name} = {}", value.0[1])]);
    if matches!(parameter.section, Section::Output | Section::Return) {
        return Some(format!("{name} => {written}").into());
    }
    match parameter.actual.as_ref()? {
        Actual::Constant(value) => Some(format!("{name} = {}", value.spell()).into()),
        Actual::Memory(access) if known => {
            let bits = reader.find(&access.location, false).ok().and_then(|found| reader.read(&found, access.width));
            Some(match bits {
                Some(bits) if parameter.data_type.width() == Some(access.width) => text(&typed(&parameter.data_type, bits)),
                Some(bits) => text(&loose_words(bits)),
                None => format!("{name} := {written}").into(),
            })
        }
        _ => Some(format!("{name} := {written}").into()),
    }
}

fn end(telling: &Telling<'_>) -> Clause {
    let frames = &telling.moment.after.frames;
    let below = frames.len().checked_sub(2).and_then(|index| frames.get(index));
    match (frames.last().map(|frame| &frame.origin), below) {
        (Some(Origin::Call(_)), Some(caller)) => Clause::new(S::End).with("block", block_name(telling, caller.block)),
        (Some(Origin::Interrupt { .. }), Some(other)) => Clause::new(S::EndInterrupt).with("block", block_name(telling, other.block)),
        _ => Clause::new(S::EndOuter),
    }
}

/// `OPN`.
pub(super) fn open_block(telling: &Telling<'_>) -> Vec<Clause> {
    let after = telling.after();
    let instance = matches!(telling.operand(), Operand::Block(block) if block.instance);
    let (register, number, length) = match instance {
        true => ("DI", after.di_number, after.di_length),
        false => ("DB", after.db_number, after.db_length),
    };
    let sentence = if number == 0 { S::CloseBlock } else { S::OpenBlock };
    vec![Clause::new(sentence).with("register", register).with("value", number).with("length", length)]
}

/// `L DBLG` and its like.
pub(super) fn data_block_info(telling: &Telling<'_>) -> Vec<Clause> {
    let before = telling.before();
    let Operand::DataBlockInfo(info) = telling.operand() else { return Vec::new() };
    let (register, number, sentence) = match info {
        DataBlockInfo::SharedLength => ("DB", before.db_number, S::LoadLength),
        DataBlockInfo::SharedNumber => ("DB", before.db_number, S::LoadNumber),
        DataBlockInfo::InstanceLength => ("DI", before.di_number, S::LoadLength),
        DataBlockInfo::InstanceNumber => ("DI", before.di_number, S::LoadNumber),
    };
    let sentence = if number == 0 { S::LoadNoBlock } else { sentence };
    vec![Clause::new(sentence).with("register", register).with("value", telling.after().accu1)]
}

/// A word of extended programs.
pub(super) fn extension(telling: &Telling<'_>) -> Vec<Clause> {
    let sentence = match telling.operand() {
        Operand::Extension(extension) => match &**extension {
            Extension::Assert { .. } => S::AssertHolds,
            Extension::StatusReset => S::StatusReset,
            Extension::Sleep(_) => S::Sleep,
            Extension::Feature { .. } => S::Feature,
        },
        _ => S::Nothing,
    };
    vec![Clause::new(sentence).with("value", telling.after().accu1)]
}
