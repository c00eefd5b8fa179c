//! What can be written in STL and in diagrams.

use sieben_lang::language::Language;
use sieben_lang::names::{Definition, DefinitionKind};
use sieben_lang::stl::instructions::Instruction;
use sieben_lang::stl::operands::OperandClass;
use sieben_model::address::{Operand, Width};
use sieben_model::types::DataType;

use super::super::context::{self, Quoting, call, line_before};
use super::super::signature;
use super::Kind;
use super::collect::{Collector, Rank, detail};

/// Lines that are looked through for the section that a position is in.
const SECTION_LINES_MAX: usize = 2_000;

/// What a declaration or a body of a source is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Section {
    Outside,
    Declarations,
    Statements,
}

pub(super) fn collect(to: &mut Collector<'_>, language: Language) {
    let Some(text) = to.snapshot.text(to.position.text) else { return };
    let text = &*text.text;
    if !to.typed.path.is_empty() {
        return to.members();
    }
    let line = line_before(text, to.typed.start);
    if section(text, to.position.offset) == Section::Declarations {
        if line.contains(':') {
            types(to);
        } else {
            ["END_VAR", "END_STRUCT"].into_iter().for_each(|word| keyword(to, word));
        }
        return;
    }
    if let Some(call) = call(to.snapshot, to.position) {
        if let Some(callee) = call.callee.filter(|_| !call.at_value) {
            let block = context::block_of(to.snapshot, callee);
            to.parameters(block, &call.given, |_| ":=");
            return;
        }
        to.locals("#", |_| true);
        to.symbols(|_| true);
        return blocks(to, |one| one.kind == DefinitionKind::DataBlock);
    }
    let statement = &line[line.rfind(';').map_or(0, |at| at + 1)..];
    let after_label = match statement.find(':') {
        Some(at) if !statement[at..].starts_with(":=") => &statement[at + 1..],
        _ => statement,
    };
    let words = after_label.trim_start();
    let is_begin = words.is_empty() && to.typed.word.quoting == Quoting::Bare;
    if is_begin {
        if language.drawing().is_none() {
            instructions(to);
        }
        return ["NETWORK", "TITLE", "BEGIN", "END_FUNCTION", "END_FUNCTION_BLOCK", "END_ORGANIZATION_BLOCK"]
            .into_iter()
            .for_each(|word| keyword(to, word));
    }
    let mnemonics = to.snapshot.mnemonics(to.position.text);
    let word = words.split_whitespace().next().unwrap_or_default();
    let classes: Vec<OperandClass> = Instruction::candidates(word, mnemonics).map(Instruction::operand).collect();
    if classes.is_empty() {
        // A diagram, or something half-typed: what has a name.
        to.locals("#", |_| true);
        to.symbols(|_| true);
        return callables(to, false);
    }
    let takes = |wanted: &[OperandClass]| classes.iter().any(|class| wanted.contains(class));
    use OperandClass as Class;
    if takes(&[Class::Label]) {
        to.labels();
    }
    if takes(&[Class::Call, Class::CallBlock]) {
        // After the comma of `CALL FB 1, ` stands a data block.
        match words.contains(',') {
            true => blocks(to, |one| one.kind == DefinitionKind::DataBlock),
            false => callables(to, takes(&[Class::Call])),
        }
    }
    if takes(&[Class::OpenBlock]) {
        blocks(to, |one| one.kind == DefinitionKind::DataBlock);
    }
    let bits = takes(&[Class::ScanBit, Class::AssignBit]);
    let words = takes(&[Class::Load, Class::Transfer]);
    let pointers = takes(&[Class::PointerSource, Class::PointerSourceWithoutAr2, Class::PointerTarget, Class::PointerTargetWithoutAr2]);
    let timers = takes(&[Class::ScanBit, Class::Load, Class::Timer, Class::TimerOrCounter]);
    let counters = takes(&[Class::ScanBit, Class::Load, Class::Counter, Class::TimerOrCounter]);
    if bits || words || pointers || timers || counters {
        to.locals("#", |one| fits(one, bits, words || pointers, timers, counters));
        to.symbols(|operand| match operand {
            Operand::Timer(_) => timers,
            Operand::Counter(_) => counters,
            Operand::Block(_) => false,
            Operand::Address(_) | Operand::InDataBlock { .. } => match operand.width() {
                Some(Width::Bit) => bits,
                Some(Width::DoubleWord) => words || pointers,
                _ => words,
            },
        });
        if bits || words {
            blocks(to, |one| one.kind == DefinitionKind::DataBlock);
        }
    }
}

/// Whether a variable is one that the instruction takes; those with members always are.
fn fits(one: &Definition, bits: bool, words: bool, timers: bool, counters: bool) -> bool {
    match one.data_type.to_ascii_uppercase().as_str() {
        "BOOL" => bits,
        "TIMER" => timers,
        "COUNTER" => counters,
        other => words || DataType::from_word(other).is_none(),
    }
}

fn keyword(to: &mut Collector<'_>, word: &str) {
    to.add(Rank::Word, Kind::Keyword, word, word.to_owned(), "keyword".to_owned(), String::new());
}

fn instructions(to: &mut Collector<'_>) {
    let mnemonics = to.snapshot.mnemonics(to.position.text);
    let mut last = "";
    for row in Instruction::ALL {
        let word = row.mnemonic(mnemonics);
        // Rows of one instruction stand one after another.
        if word != last {
            let documentation = format!("Operand: {}.", row.operand().describe());
            to.add(Rank::Fitting, Kind::Instruction, word, word.to_owned(), row.doc().to_owned(), documentation);
        }
        last = word;
    }
}

fn types(to: &mut Collector<'_>) {
    for word in DataType::words() {
        to.add(Rank::Fitting, Kind::Type, word, word.to_owned(), "type".to_owned(), String::new());
    }
    to.snippet(Rank::Fitting, Kind::Type, "ARRAY", "ARRAY [${1:1}..${2:10}] OF ${3:INT}".to_owned(), "array".to_owned());
    to.snippet(Rank::Fitting, Kind::Type, "STRUCT", "STRUCT\n\t$0\nEND_STRUCT".to_owned(), "structure".to_owned());
    blocks(to, |one| matches!(one.kind, DefinitionKind::Type | DefinitionKind::FunctionBlock));
}

/// The blocks that fit.
fn blocks(to: &mut Collector<'_>, fits: impl Fn(&Definition) -> bool) {
    for (written, definition, target) in to.globals(fits) {
        let kind = super::super::symbols::kind(definition.kind);
        let rank = to.rank(target);
        to.add(rank, kind, &written.clone(), written, detail(definition), definition.comment.clone());
    }
}

/// What can be called, with its parameters where it is a CALL.
fn callables(to: &mut Collector<'_>, with_parameters: bool) {
    let callable = |one: &Definition| matches!(one.kind, DefinitionKind::Function | DefinitionKind::FunctionBlock);
    for (written, definition, target) in to.globals(callable) {
        let kind = super::super::symbols::kind(definition.kind);
        if !with_parameters {
            let rank = to.rank(target);
            to.add(rank, kind, &written.clone(), written, detail(definition), definition.comment.clone());
            continue;
        }
        let mut place = 0;
        let mut next = || {
            place += 1;
            place
        };
        let is_block = definition.kind == DefinitionKind::FunctionBlock;
        let mut new_text = escaped(&written);
        if is_block {
            new_text.push_str(&format!(", ${{{}:DB 1}}", next()));
        }
        let parameters = signature::parameters(to.snapshot, target);
        if !parameters.is_empty() {
            let lines: Vec<String> =
                parameters.iter().map(|one| format!("\n\t{} := ${{{}:{}}}", escaped(&one.name), next(), escaped(&one.data_type))).collect();
            new_text.push_str(&format!(" ({})", lines.join(",")));
        }
        let rank = to.rank(target);
        to.snippet(rank, kind, &written, new_text, detail(definition));
    }
    if with_parameters {
        to.locals("#", |one| one.kind.is_variable() && DataType::from_word(&one.data_type.to_ascii_uppercase()).is_none());
    }
}

fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('$', "\\$").replace('}', "\\}")
}

/// What part of a block a byte lies in, by the words that begin the lines before it.
pub(super) fn section(text: &str, offset: usize) -> Section {
    let before = text.get(..offset).unwrap_or_default();
    let mut lines = before.rsplit(['\n', '\r']);
    lines.next();
    for line in lines.take(SECTION_LINES_MAX) {
        let word: String = line.trim_start().chars().take_while(|&sign| context::in_word(sign)).collect::<String>().to_ascii_uppercase();
        match word.as_str() {
            "VAR" | "VAR_INPUT" | "VAR_OUTPUT" | "VAR_IN_OUT" | "VAR_TEMP" | "VAR_GLOBAL" | "VAR_STAT" | "VAR_EXTERNAL" | "STRUCT" => {
                // A section on one line is over.
                if !line.to_ascii_uppercase().contains("END_VAR") {
                    return Section::Declarations;
                }
                return Section::Statements;
            }
            "END_VAR" | "BEGIN" | "NETWORK" => return Section::Statements,
            "END_FUNCTION" | "END_FUNCTION_BLOCK" | "END_ORGANIZATION_BLOCK" | "END_DATA_BLOCK" | "END_TYPE" | "END_PROGRAM" => {
                return Section::Outside;
            }
            _ => {}
        }
    }
    Section::Outside
}
