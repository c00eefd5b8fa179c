//! Chooses the instruction of each statement and checks what only the whole block shows: labels, brackets, lists, ends.

mod accumulators;
mod flow;
mod logic;
mod pins;
mod temporaries;
mod traps;

use std::collections::HashMap;
use std::sync::Arc;

use sieben_model::address::Area;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::interface::{Interface, Section};
use sieben_model::literal::Value;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::origin::Origin;
use sieben_model::problems::Problem;
use sieben_model::source::Span;

use super::ast;
use super::diagrams::first_scratch_bit;
use super::extension;
use super::instructions::Instruction;
use super::lower::{ResolvedBlock, Statement};
use super::operands::{BlockOperand, Location, NumberOperand, Operand, OperandClass, StatusScan};
use super::parser::DIAGNOSTICS_MAX;
use super::resolve::{Known, Resolver};
use crate::network::write::scratch_bit;
use accumulators::Operands;
use pins::Wired;
pub use temporaries::TemporaryReads;

/// Brackets that may be open at once.
const BRACKETS_MAX: usize = 7;

/// MCR zones that may be open at once.
const MCR_ZONES_MAX: usize = 8;

/// Entries that a jump list may have: its index is a byte.
const JUMP_LIST_MAX: usize = 255;

/// Resolves and checks the statements of a code block.
pub(crate) fn block(
    known: &Known<'_>,
    id: BlockId,
    source: &ast::Block,
    interface: &Interface,
    mnemonics: Mnemonics,
    reported: &dyn Fn(Span) -> bool,
) -> Checked {
    let mut diagnostics = Vec::new();
    let mut whole = true;
    let labels = labels(source, &mut diagnostics);
    let mut resolver = Resolver::new(known, id, interface, &labels.targets);
    let mut statements = Vec::with_capacity(source.statements.len() + 1);
    let mut operands = Operands { types: Vec::new(), wired: Vec::new() };
    let titles: Vec<String> = source.networks.iter().map(|network| network.title.clone()).collect();
    let mut networks = source.networks.iter().peekable();
    let mut network = 0u32;
    for (index, statement) in source.statements.iter().enumerate() {
        while networks.next_if(|next| next.first_statement <= index).is_some() {
            network += 1;
        }
        if statement.mnemonic.text.is_empty() {
            continue;
        }
        let before = resolver.diagnostics.len();
        resolver.declared = None;
        if before >= DIAGNOSTICS_MAX {
            let message = format!("`{id}` has more than {DIAGNOSTICS_MAX} problems; the others are not shown");
            resolver.diagnostics.push(Diagnostic::new(Problem::P2199, statement.span, message));
            diagnostics.append(&mut resolver.diagnostics);
            return Checked { block: ResolvedBlock { id, interface: interface.clone(), statements, titles }, diagnostics, whole: false };
        }
        let wired = Wired::of(source, network, index);
        let chosen = choose(known, &mut resolver, statement, wired, mnemonics);
        if let (Some(wired), Some(said)) = (wired, resolver.diagnostics.get_mut(before..)) {
            said.iter_mut().filter(|one| one.problem == Problem::P4002).for_each(|one| one.message = wired.about(&one.message));
        }
        // An element may have its operand in several statements.
        if let [before @ .., last] = resolver.diagnostics.as_slice()
            && wired.is_some()
            && before.iter().any(|one| one.span == last.span && one.problem == last.problem && one.message == last.message)
        {
            resolver.diagnostics.pop();
        }
        whole &= chosen.is_some();
        if let (ast::Operand::Call(call), Some((_, Operand::Call(resolved)))) = (&statement.operand, &chosen) {
            resolver.diagnostics.extend(pins::lost(source, network, call, resolved));
        }
        // What the parser could not read is reported; guesses about the rest of that statement would only confuse.
        let next = source.statements.get(index + 1).map_or(source.span.end, |next| next.span.start.max(statement.span.start));
        if resolver.diagnostics.len() > before && reported(Span { end: next, ..statement.span }) {
            resolver.diagnostics.truncate(before);
            whole = false;
        }
        // The place of a statement that is wrong stays taken, so that labels keep their numbers.
        let (instruction, operand) = chosen.unwrap_or((Instruction::Nop0, Operand::Constant(Value::Int(0))));
        let origin = origin(source, index, network, statements.last());
        let stated = origin.element().map(|_| stated(known, id, interface, statement));
        statements.push(Statement { instruction, operand, origin, stated });
        operands.types.push(resolver.declared.take());
        operands.wired.push(wired);
    }
    // A label at the end of the block stands before its end.
    if let Some(span) = labels.at_end {
        let origin = Origin::Text { span, network: network.max(1) };
        statements.push(Statement { instruction: Instruction::BlockEnd, operand: Operand::None, origin, stated: None });
        operands.types.push(None);
        operands.wired.push(None);
    }
    diagnostics.append(&mut resolver.diagnostics);
    structure(&statements, &labels, &mut diagnostics);
    for statement in &statements {
        calls(known, statement, &mut diagnostics);
        edge_memory(statement, &mut diagnostics);
        unavailable(known, statement, &mut diagnostics);
        missing_instructions(known, statement, &mut diagnostics);
    }
    whole &= !diagnostics.iter().any(|diagnostic| diagnostic.severity() == Severity::Error);
    let block = ResolvedBlock { id, interface: interface.clone(), statements, titles };
    // What follows paths through the block would guess where a statement is missing.
    if whole {
        temporaries::check(&block, known.temporaries, &mut diagnostics);
        accumulators::check(&block.statements, &operands, known.cpu.accumulators == 4, &mut diagnostics);
        logic::check(&block, &mut diagnostics);
        traps::check(&block, known.extended, &mut diagnostics);
    }
    Checked { block, diagnostics, whole }
}

/// Where a statement comes from; `before` is the one before it.
fn origin(source: &ast::Block, index: usize, network: u32, before: Option<&Statement>) -> Origin {
    let span = source.statements[index].span;
    let own = network.checked_sub(1).and_then(|at| source.networks.get(at as usize)).filter(|own| own.drawing.is_some());
    let Some(own) = own else { return Origin::Text { span, network: network.max(1) } };
    let element = match before.map(|before| before.origin) {
        Some(Origin::Element { span: last, element, .. }) if own.first_statement < index => element + u32::from(last != span),
        _ => 1,
    };
    Origin::Element { span, network, element }
}

/// The statement that an element of a diagram stands for, as it would be written.
fn stated(known: &Known<'_>, id: BlockId, interface: &Interface, statement: &ast::Statement) -> Arc<str> {
    let mnemonic = &statement.mnemonic.text;
    let operand = match &statement.operand {
        ast::Operand::None => String::new(),
        ast::Operand::Scratch { bit } => scratch_bit(first_scratch_bit(interface, id.kind).saturating_add(*bit)).text,
        // Labels that boxes need are called otherwise inside, so that nothing that is written can name them.
        ast::Operand::Name { word, .. } => word.text.replacen('·', "_", 1),
        ast::Operand::Constant(ast::Constant { value: Some(Value::Int(number)), span, .. }) if *span == statement.span => {
            number.to_string()
        }
        ast::Operand::Call(call) => {
            let slice = |span: Span| known.sources.slice(span).trim();
            let instance = call.instance.as_ref().map(|(_, span)| format!(", {}", slice(*span))).unwrap_or_default();
            format!("{}{instance}", slice(call.callee_span))
        }
        _ => known.sources.slice(statement.operand_span).split_whitespace().collect::<Vec<_>>().join(" "),
    };
    format!("{mnemonic} {operand}").trim_end().into()
}

/// A block whose statements were looked at.
pub(crate) struct Checked {
    pub(crate) block: ResolvedBlock,
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// Every statement was understood, so that the block has a meaning.
    pub(crate) whole: bool,
}

/// The labels of a block.
struct Labels {
    /// The statement that each label stands before.
    targets: HashMap<String, u32>,
    /// Whether a label stands before a statement.
    labelled: Vec<bool>,
    /// A label behind the last statement.
    at_end: Option<Span>,
}

fn labels(source: &ast::Block, diagnostics: &mut Vec<Diagnostic>) -> Labels {
    let mut targets = HashMap::new();
    let mut places: HashMap<&str, Span> = HashMap::new();
    let mut labelled = Vec::with_capacity(source.statements.len());
    let (mut next, mut waiting) = (0u32, None);
    for statement in &source.statements {
        if let Some(label) = &statement.label {
            waiting = Some(label.span);
            match places.get(label.text.as_str()) {
                Some(&first) => diagnostics.push(
                    Diagnostic::new(Problem::P3005, label.span, format!("the label `{}` stands in this block twice", label.text))
                        .related(first, "first here"),
                ),
                None => {
                    places.insert(&label.text, label.span);
                    targets.insert(label.text.clone(), next);
                }
            }
        }
        if !statement.mnemonic.text.is_empty() {
            next += 1;
            labelled.push(waiting.take().is_some());
        }
    }
    labelled.push(waiting.is_some());
    Labels { targets, labelled, at_end: waiting }
}

/// The row of the instruction table that takes the operand.
fn choose(
    known: &Known<'_>,
    resolver: &mut Resolver<'_>,
    statement: &ast::Statement,
    wired: Option<Wired>,
    mnemonics: Mnemonics,
) -> Option<(Instruction, Operand)> {
    let word = statement.mnemonic.text.as_str();
    if let Some(word) = extension::Word::from_spelling(word) {
        return Some((Instruction::Extension, resolver.extension(word, statement)?));
    }
    let mut rows: Vec<Instruction> = Instruction::candidates(word, mnemonics).collect();
    if rows.is_empty() {
        // A word of the other language was reported by the parser; its meaning is clear all the same.
        rows = Instruction::candidates(word, mnemonics.other()).collect();
    }
    if rows.is_empty() {
        let message = format!("`{word}` is not an instruction");
        resolver.diagnostics.push(Diagnostic::new(Problem::P2001, statement.mnemonic.span, message));
        return None;
    }
    let place = if matches!(statement.operand, ast::Operand::None) { statement.span } else { statement.operand_span };
    let operand = match rows[0].operand() {
        OperandClass::Label => resolver.label(&statement.operand, place)?,
        OperandClass::Call => match &statement.operand {
            ast::Operand::Call(call) => resolver.call(call)?,
            ast::Operand::Error => return None,
            _ => {
                let message = format!("`{word}` takes {}", OperandClass::Call.describe());
                resolver.diagnostics.push(Diagnostic::new(Problem::P4002, place, message));
                return None;
            }
        },
        _ => resolver.operand(&statement.operand, place)?,
    };
    if let Some(diagnostic) = wired.and_then(|wired| wired.misfit(&operand, known.sources.slice(place).trim(), place)) {
        resolver.diagnostics.push(diagnostic);
        return None;
    }
    if let Some(&row) = rows.iter().find(|row| row.operand().accepts(&operand)) {
        return Some((row, operand));
    }
    let mut classes: Vec<&str> = Vec::new();
    for row in &rows {
        let words = row.operand().describe();
        if !classes.contains(&words) {
            classes.push(words);
        }
    }
    // "Nothing, or …" says already what "no operand" says.
    if classes.iter().any(|words| words.starts_with("nothing")) {
        classes.retain(|&words| words != OperandClass::None.describe());
    }
    let takes = classes.join("; or ");
    if let (Some(wired), false) = (wired, operand == Operand::None) {
        resolver.diagnostics.push(wired.refused(&takes, known.sources.slice(place).trim(), place));
        return None;
    }
    let message = match &operand {
        Operand::None => format!("`{word}` needs an operand: {takes}"),
        _ => format!("`{word}` does not take `{}`; it takes {takes}", known.sources.slice(place).trim()),
    };
    let constants = |class: OperandClass| {
        matches!(
            class,
            OperandClass::ByteConstant
                | OperandClass::IntConstant
                | OperandClass::DoubleIntConstant
                | OperandClass::ShiftCount16
                | OperandClass::ShiftCount32
                | OperandClass::OptionalPointerOffset
                | OperandClass::OptionalConstant16
                | OperandClass::OptionalConstant32
                | OperandClass::Zero
                | OperandClass::One
        )
    };
    let out_of_range = matches!(operand, Operand::Constant(_)) && rows.iter().any(|row| constants(row.operand()));
    let problem = if out_of_range { Problem::P4001 } else { Problem::P4002 };
    let mut diagnostic = Diagnostic::new(problem, place, message);
    diagnostic.help = area_missing(&rows, &operand, known.sources.slice(place).trim(), mnemonics);
    resolver.diagnostics.push(diagnostic);
    None
}

/// `A 128.0`: what may have been meant by a byte and a bit without their area.
fn area_missing(rows: &[Instruction], operand: &Operand, written: &str, mnemonics: Mnemonics) -> Option<String> {
    let (byte, bit) = written.split_once('.')?;
    let bit_wanted = rows.iter().any(|row| matches!(row.operand(), OperandClass::ScanBit | OperandClass::AssignBit));
    let bit_written = byte.parse::<u16>().is_ok() && matches!(bit, "0" | "1" | "2" | "3" | "4" | "5" | "6" | "7");
    if !matches!(operand, Operand::Constant(_)) || !bit_wanted || !bit_written {
        return None;
    }
    let [input, output, memory] = [Area::Input, Area::Output, Area::BitMemory].map(|area| area.prefix(mnemonics));
    Some(format!("An address begins with its area: `{input} {written}`, `{output} {written}` or `{memory} {written}`."))
}

fn opens_bracket(instruction: Instruction) -> bool {
    matches!(
        instruction,
        Instruction::AndOpen
            | Instruction::AndNotOpen
            | Instruction::OrOpen
            | Instruction::OrNotOpen
            | Instruction::XorOpen
            | Instruction::XorNotOpen
    )
}

fn ends_block(instruction: Instruction) -> bool {
    matches!(instruction, Instruction::BlockEnd | Instruction::BlockEndUnconditional)
}

/// Brackets, MCR zones, jump lists, jumps across brackets and statements that are never reached.
fn structure(statements: &[Statement], labels: &Labels, diagnostics: &mut Vec<Diagnostic>) {
    let mut report = |problem, span, message: String| diagnostics.push(Diagnostic::new(problem, span, message));
    let lists = jump_lists(statements, &mut report);
    // The innermost open bracket of each statement, by the statement that opened it.
    let mut brackets: Vec<usize> = Vec::new();
    let mut innermost: Vec<Option<usize>> = Vec::with_capacity(statements.len());
    let mut zones: Vec<usize> = Vec::new();
    let mut too_deep = false;
    for (index, statement) in statements.iter().enumerate() {
        innermost.push(brackets.last().copied());
        match statement.instruction {
            opening if opens_bracket(opening) => {
                brackets.push(index);
                if brackets.len() > BRACKETS_MAX && !too_deep {
                    too_deep = true;
                    let message = format!("this is bracket number {}; a CPU nests at most {BRACKETS_MAX}", brackets.len());
                    report(Problem::P2205, statement.span(), message);
                }
            }
            Instruction::CloseBracket if brackets.pop().is_none() => {
                report(Problem::P2204, statement.span(), "`)` closes a bracket that was never opened".to_owned());
            }
            Instruction::McrOpen => {
                zones.push(index);
                if zones.len() == MCR_ZONES_MAX + 1 {
                    let message = format!("this is MCR zone number {}; a CPU nests at most {MCR_ZONES_MAX}", zones.len());
                    report(Problem::P2207, statement.span(), message);
                }
            }
            Instruction::McrClose if zones.pop().is_none() => {
                report(Problem::P2207, statement.span(), "`)MCR` closes a zone that was not opened in this block".to_owned());
            }
            Instruction::BlockEnd | Instruction::BlockEndUnconditional | Instruction::BlockEndConditional if !brackets.is_empty() => {
                report(Problem::P2213, statement.span(), "the block ends inside a bracket".to_owned());
            }
            Instruction::Call | Instruction::CallUnconditional | Instruction::CallConditional
                if !brackets.is_empty() && !is_in_chain(&statements[index..]) =>
            {
                report(Problem::P2214, statement.span(), "a block is called inside a bracket".to_owned());
            }
            _ => {}
        }
        let ends = ends_block(statement.instruction) || (statement.instruction == Instruction::Jump && !lists[index]);
        if ends
            && let Some(next) = statements.get(index + 1)
            && !labels.labelled[index + 1]
            && !ends_block(next.instruction)
            && !matches!(next.instruction, Instruction::Nop0 | Instruction::Nop1 | Instruction::Blank)
        {
            report(Problem::P2208, next.span(), "this statement is never reached: no label stands before it".to_owned());
        }
    }
    for &open in &brackets {
        report(Problem::P2203, statements[open].span(), "this bracket is never closed".to_owned());
    }
    for &open in &zones {
        report(Problem::P2207, statements[open].span(), "this MCR zone is not closed in this block".to_owned());
    }
    for (index, statement) in statements.iter().enumerate() {
        if let Operand::Label(target) = statement.operand
            && let Some(&inside) = innermost.get(target as usize)
            && inside != innermost[index]
        {
            let message = match (innermost[index], inside) {
                (Some(_), None) => "this jump leaves a bracket",
                (None, Some(_)) => "this jump leads into a bracket",
                _ => "this jump leads from one bracket into another",
            };
            report(Problem::P2206, statement.span(), message.to_owned());
        }
    }
}

/// A call in a chain of boxes, where the next box hangs on its ENO: so LAD and FBD write it, `A( …; CALL FC 1; A BR; )`.
fn is_in_chain(from_call: &[Statement]) -> bool {
    let [call, rest @ ..] = from_call else { return false };
    let is_enable_output =
        |one: &Statement| one.instruction == Instruction::And && one.operand == Operand::Status(StatusScan::BinaryResult);
    call.origin.element().is_some() || (call.instruction == Instruction::Call && rest.first().is_some_and(is_enable_output))
}

/// Which statements are entries of a jump list.
fn jump_lists(statements: &[Statement], report: &mut dyn FnMut(Problem, Span, String)) -> Vec<bool> {
    let mut entries = vec![false; statements.len()];
    for (index, statement) in statements.iter().enumerate() {
        let (Instruction::JumpList, &Operand::Label(target)) = (statement.instruction, &statement.operand) else { continue };
        let target = target as usize;
        if target <= index {
            report(
                Problem::P2209,
                statement.span(),
                "the label of the jump list stands directly behind the list, not before it".to_owned(),
            );
            continue;
        }
        let end = target.min(statements.len());
        if end - index - 1 > JUMP_LIST_MAX {
            let message = format!("this jump list has {} entries; it may have {JUMP_LIST_MAX}", end - index - 1);
            report(Problem::P2209, statement.span(), message);
        }
        for entry in index + 1..end {
            if statements[entry].instruction == Instruction::Jump {
                entries[entry] = true;
            } else {
                let message = "only unconditional jumps may stand between the jump list and its label".to_owned();
                report(Problem::P2209, statements[entry].span(), message);
                break;
            }
        }
    }
    entries
}

/// Calls and openings without parameters: what they name should exist and need none.
fn calls(known: &Known<'_>, statement: &Statement, diagnostics: &mut Vec<Diagnostic>) {
    let Operand::Block(BlockOperand { kind, number: NumberOperand::Fixed(number), .. }) = statement.operand else { return };
    let id = BlockId::new(kind, number);
    // Number 0 closes the register, it is no block.
    if id == BlockId::db(0) {
        return;
    }
    if !known.blocks.exists(id) {
        let message = match kind {
            BlockKind::DataBlock => format!("`{id}` does not exist; the statement fails unless the program creates it"),
            _ => format!("`{id}` does not exist; the call fails at run time"),
        };
        diagnostics.push(Diagnostic::new(Problem::P3018, statement.span(), message).elsewhere());
        return;
    }
    if kind == BlockKind::DataBlock {
        return;
    }
    let Some(callee) = known.blocks.interface(id) else { return };
    let parameters: Vec<&str> = callee.interface.parameters().map(|parameter| parameter.name.as_str()).collect();
    let statics = callee.interface.variables.iter().any(|variable| variable.section == Section::Static);
    if !parameters.is_empty() {
        let message = format!("`{id}` has parameters ({}), but this call passes none", parameters.join(", "));
        diagnostics.push(Diagnostic::new(Problem::P4013, statement.span(), message));
    } else if statics {
        let message = format!("`{id}` has static variables, but this call opens no instance");
        diagnostics.push(Diagnostic::new(Problem::P4013, statement.span(), message));
    }
}

/// Edge memory has to keep its value until the next cycle.
fn edge_memory(statement: &Statement, diagnostics: &mut Vec<Diagnostic>) {
    if let (Instruction::EdgePositive | Instruction::EdgeNegative, Operand::Memory(access)) = (statement.instruction, &statement.operand)
        && matches!(access.location, Location::Fixed { area: Area::Local, .. })
    {
        let message = "this edge memory lies in temporary data, which the next cycle does not find again".to_owned();
        diagnostics.push(Diagnostic::new(Problem::P4016, statement.span(), message));
    }
}

/// A system block that needs other hardware: the call compiles and fails at run time.
fn unavailable(known: &Known<'_>, statement: &Statement, diagnostics: &mut Vec<Diagnostic>) {
    let id = match &statement.operand {
        Operand::Call(call) => call.callee,
        Operand::Block(BlockOperand { kind, number: NumberOperand::Fixed(number), .. }) => BlockId::new(*kind, *number),
        _ => return,
    };
    let Some((name, only)) = known.blocks.only(id) else { return };
    let message = format!("`{id}` ({name}) is not available on this CPU: it needs {only}; the call answers with an error");
    diagnostics.push(Diagnostic::new(Problem::P5020, statement.span(), message));
}

/// `ENT` and `LEAVE` are instructions of CPUs with four accumulators.
fn missing_instructions(known: &Known<'_>, statement: &Statement, diagnostics: &mut Vec<Diagnostic>) {
    if known.cpu.accumulators < 4 && matches!(statement.instruction, Instruction::Enter | Instruction::Leave) {
        let message = format!("CPU {} has two accumulators, so that this statement does nothing", known.cpu.name);
        diagnostics.push(Diagnostic::new(Problem::P5008, statement.span(), message));
    }
}
