//! A block of STL as networks that can be drawn: its statements as the reader of diagrams takes them, and what is known of the block.

use std::collections::{BTreeSet, HashMap, HashSet};

use sieben_model::address::{Area, Width};
use sieben_model::block::BlockKind;
use sieben_model::interface::{Interface, Section};
use sieben_model::literal::Value;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::ast;
use super::lower::ResolvedBlock;
use super::mnemonics::translate_status;
use super::operands::{Access, Call, Location, NumberOperand, Operand};
use crate::declarations::interface::START_INFORMATION_BYTES;
use crate::network::flavour::Drawing;
use crate::network::model::Place;
use crate::network::operand::{Operand as Written, STATUS_BITS};
use crate::network::pin_types::{Class, Constant};
use crate::network::read::{Answer, Mode, Surroundings, carries, draw, reads_before_writing};
use crate::network::statement::{Parameter, Passing, Statement};
use crate::network::write::{scratch_bit, scratch_number};

/// A network of a block.
#[derive(Clone, Debug)]
pub struct DrawnNetwork {
    /// Its number, from 1.
    pub number: u32,
    /// TITLE.
    pub title: String,
    /// The comment under the title, one line each.
    pub comment: String,
    /// The drawing that the source has of it; `None` for statements.
    pub drawing: Option<Drawing>,
    /// From its keyword, or its first statement, to the end of its last statement.
    pub span: Span,
    /// From its first to the end of its last statement; empty at the end of its head if it has none.
    pub body: Span,
    /// Its statements.
    pub statements: Vec<Statement>,
    /// The number of each in the block, from 0.
    pub numbers: Vec<u32>,
    /// Where each is written.
    pub spans: Vec<Span>,
    /// Comments, by the index of the statement that they belong to.
    pub comments: Vec<StatementComment>,
    /// The network before ends its string of logic.
    pub is_fresh: bool,
    /// Whether it can be drawn.
    pub answer: Answer,
}

/// What the networks of a block find where they begin.
struct Known {
    /// The one before has ended its string of logic.
    fresh: Vec<bool>,
    /// Bits of local data that they read before they write them.
    reads: Vec<BTreeSet<u32>>,
}

/// The comments of a statement.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct StatementComment {
    /// Which statement of the network, from 0.
    pub statement: usize,
    /// Lines before it, `// …`.
    pub before: Vec<String>,
    /// The comment on its own line.
    pub after: Option<String>,
    /// The pin that they belong to, if it is one of a box of a diagram.
    pub pin: Option<String>,
}

/// The networks of a block. `text` is the whole source, `block` what was read of it, `resolved` the same block after its check.
pub fn networks(text: &str, block: &ast::Block, resolved: &ResolvedBlock, mnemonics: Mnemonics, mode: Mode) -> Vec<DrawnNetwork> {
    let reader = Reader::new(text, block, resolved, mnemonics);
    let heads = reader.heads();
    let count = heads.len();
    let ends = (0..count).map(|index| heads.get(index + 1).map_or(block.statements.len(), |next| next.first_statement));
    let all: Vec<Vec<Statement>> =
        heads.iter().zip(ends).map(|(head, end)| reader.statements(head.first_statement.min(end), end)).collect();
    // What each network finds in the string of logic and in local data.
    let mut known = Known { fresh: Vec::with_capacity(count), reads: Vec::with_capacity(count) };
    let mut fresh = true;
    for statements in &all {
        known.fresh.push(fresh);
        fresh = match carries(statements) {
            Some(carried) => !carried,
            None => fresh,
        };
        known.reads.push(reads_before_writing(statements, &Around { reader: &reader, network: 0, known: None }));
    }
    all.into_iter().enumerate().map(|(index, statements)| reader.network(index, &heads[index], statements, &known, mode)).collect()
}

/// The first free bit of the local data of a block: after its declared temporary variables.
pub(crate) fn first_scratch_bit(interface: &Interface, kind: BlockKind) -> u32 {
    let start = if kind == BlockKind::OrganizationBlock { START_INFORMATION_BYTES * 8 } else { 0 };
    let ends = interface
        .variables
        .iter()
        .filter(|variable| variable.section == Section::Temp)
        .map(|variable| variable.offset.saturating_add(u32::try_from(variable.data_type.bits_used()).unwrap_or(u32::MAX)));
    ends.fold(start, u32::max).checked_next_multiple_of(8).unwrap_or(u32::MAX)
}

struct Reader<'a> {
    text: &'a str,
    block: &'a ast::Block,
    resolved: &'a ResolvedBlock,
    mnemonics: Mnemonics,
    /// For each statement of the source its number after the check; `None` for a label alone.
    numbers: Vec<Option<u32>>,
    /// What the operands are that the statements name.
    classes: HashMap<String, Class>,
    /// Where operands lie that have a constant address.
    extents: HashMap<String, Extent>,
    /// The networks, from 1, that touch a temporary variable.
    touched: HashMap<String, HashSet<u32>>,
    /// The networks that read the branch result.
    branch_results: HashSet<u32>,
    scratch: u32,
}

impl<'a> Reader<'a> {
    fn new(text: &'a str, block: &'a ast::Block, resolved: &'a ResolvedBlock, mnemonics: Mnemonics) -> Self {
        let mut next = 0;
        let number = |statement: &ast::Statement| {
            let written = !statement.mnemonic.text.is_empty();
            let number = written.then_some(next);
            next += u32::from(written);
            number
        };
        let numbers: Vec<Option<u32>> = block.statements.iter().map(number).collect();
        let mut reader = Self {
            text,
            block,
            resolved,
            mnemonics,
            numbers,
            classes: HashMap::new(),
            extents: HashMap::new(),
            touched: HashMap::new(),
            branch_results: HashSet::new(),
            scratch: first_scratch_bit(&resolved.interface, resolved.id.kind),
        };
        reader.look();
        reader
    }

    /// Notes what the operands are.
    fn look(&mut self) {
        for (index, statement) in self.block.statements.iter().enumerate() {
            let Some(resolved) = self.resolved(index) else { continue };
            let network = resolved.origin.network();
            if resolved.instruction.mnemonic(Mnemonics::English) == "L" && resolved.operand == Operand::StatusWord
                || resolved.operand == Operand::Status(super::operands::StatusScan::BinaryResult)
            {
                self.branch_results.insert(network);
            }
            let mut named =
                vec![(self.operand(&statement.operand, statement.operand_span), class(&resolved.operand), Extent::of(&resolved.operand))];
            if let (ast::Operand::Call(call), Operand::Call(resolved)) = (&statement.operand, &resolved.operand) {
                named =
                    call.arguments.iter().map(|one| (self.operand(&one.value, one.span), passed(resolved, &one.name.text), None)).collect();
            }
            for (name, class, extent) in named {
                if name.starts_with('#') {
                    self.touched.entry(name.to_ascii_uppercase()).or_default().insert(network);
                }
                if let Some(extent) = extent {
                    self.extents.insert(name.clone(), extent);
                }
                self.classes
                    .entry(name)
                    .and_modify(|known| {
                        if *known == Class::Unknown {
                            *known = class
                        }
                    })
                    .or_insert(class);
            }
        }
    }

    fn resolved(&self, index: usize) -> Option<&'a super::lower::Statement> {
        self.resolved.statements.get((*self.numbers.get(index)?)? as usize)
    }

    /// Where the networks begin; statements before the first keyword are a network as well.
    fn heads(&self) -> Vec<ast::Network> {
        let mut heads = self.block.networks.clone();
        let first = heads.first().map_or(self.block.statements.len(), |network| network.first_statement);
        if first > 0 {
            let start = self.block.statements.first().map_or(self.block.span, |statement| statement.span);
            let drawing = None;
            heads.insert(
                0,
                ast::Network { first_statement: 0, drawing, span: Span { end: start.start, ..start }, ..ast::Network::default() },
            );
        }
        heads
    }

    fn statements(&self, from: usize, to: usize) -> Vec<Statement> {
        (from..to).map(|at| self.statement(at, at - from)).collect()
    }

    fn network(&self, index: usize, head: &ast::Network, statements: Vec<Statement>, known: &Known, mode: Mode) -> DrawnNetwork {
        let number = index as u32 + 1;
        let (mut numbers, mut spans) = (Vec::new(), Vec::new());
        for at in head.first_statement..head.first_statement + statements.len() {
            numbers.push(self.numbers[at].unwrap_or_default());
            spans.push(self.block.statements[at].span);
        }
        let around = Around { reader: self, network: number, known: Some(known) };
        let answer = draw(&statements, &around, self.scratch, mode);
        let empty = Span { start: head.span.end, ..head.span };
        let body = match (spans.first(), spans.last()) {
            (Some(first), Some(_)) => spans.iter().fold(self.labelled(head.first_statement, *first), |all, span| all.to(*span)),
            _ => empty,
        };
        let comments = self.comments(head, &spans);
        DrawnNetwork {
            number,
            title: head.title.clone(),
            comment: head.comment.clone(),
            drawing: head.drawing,
            span: head.span.to(body),
            body,
            statements,
            numbers,
            spans,
            comments,
            is_fresh: around.begins_fresh(),
            answer,
        }
    }

    /// The place of a statement with its label.
    fn labelled(&self, index: usize, span: Span) -> Span {
        let label = self.block.statements.get(index).and_then(|statement| statement.label.as_ref());
        label.map_or(span, |label| if label.span.start < span.start { label.span.to(span) } else { span })
    }

    fn statement(&self, index: usize, at: usize) -> Statement {
        let written = &self.block.statements[index];
        let place = Place::new(at, at);
        let label = written.label.as_ref().map(|label| Written::from(label.text.replacen('·', "_", 1)));
        let Some(resolved) = self.resolved(index) else {
            return Statement { label, place, ..Statement::new("NOP", "0") };
        };
        let mnemonic = resolved.instruction.mnemonic(Mnemonics::English);
        let statement = match (&written.operand, &resolved.operand) {
            (ast::Operand::Call(call), Operand::Call(known)) => self.call(call, known),
            (operand, _) => Statement::new(mnemonic, self.operand(operand, written.operand_span)),
        };
        Statement { label, place, ..statement }
    }

    fn call(&self, call: &ast::Call, known: &Call) -> Statement {
        let parameters = call.arguments.iter().map(|one| {
            let section =
                known.parameters.iter().find(|parameter| parameter.name.eq_ignore_ascii_case(&one.name.text)).map(|one| one.section);
            let passing = match section {
                Some(Section::Output | Section::Return) => Passing::Out,
                _ => Passing::In,
            };
            Parameter { name: one.name.text.as_str().into(), actual: self.operand(&one.value, one.span).into(), passing }
        });
        Statement {
            instance: call.instance.as_ref().map(|(operand, span)| self.operand(operand, *span).into()),
            parameters: parameters.collect(),
            ..Statement::new("CALL", self.operand(&call.callee, call.callee_span))
        }
    }

    /// An operand in its usual notation, in the mnemonic language of the source.
    fn operand(&self, operand: &ast::Operand, span: Span) -> String {
        match operand {
            ast::Operand::None => String::new(),
            ast::Operand::Scratch { bit } => scratch_bit(self.scratch.saturating_add(*bit)).text,
            ast::Operand::Absolute { letters, number, bit } => {
                format!("{letters} {number}{}", bit.map_or_else(String::new, |bit| format!(".{bit}")))
            }
            ast::Operand::Name { word, path } if path.is_empty() => {
                let text = word.text.replacen('·', "_", 1);
                let english = match self.mnemonics {
                    Mnemonics::German => translate_status(&text, Mnemonics::German),
                    Mnemonics::English => None,
                };
                let status = english.map_or(text.clone(), str::to_owned);
                let local = self.resolved.interface.variable(&text).is_some() && !STATUS_BITS.contains(&status.as_str());
                if local { format!("#{text}") } else { status }
            }
            // Numbers of NOP and BLD that a diagram makes are written nowhere.
            ast::Operand::Constant(ast::Constant { value: Some(Value::Int(number)), .. }) if self.is_made_up(span) => number.to_string(),
            _ => Written::read(&self.slice(span), 0).spaced(),
        }
    }

    /// The place is that of a whole element of a diagram, not of an operand.
    fn is_made_up(&self, span: Span) -> bool {
        let first = self.text.get(span.start as usize..span.end as usize).unwrap_or_default();
        !first.starts_with(|sign: char| sign.is_ascii_digit() || matches!(sign, '+' | '-'))
    }

    /// A part of the source in one line.
    fn slice(&self, span: Span) -> String {
        let text = self.text.get(span.start as usize..span.end as usize).unwrap_or_default();
        if text.contains(['\'', '"']) { text.trim().to_owned() } else { text.split_whitespace().collect::<Vec<_>>().join(" ") }
    }

    fn comments(&self, head: &ast::Network, spans: &[Span]) -> Vec<StatementComment> {
        let mut out: Vec<StatementComment> = Vec::new();
        let mut end = head.span.end;
        for (statement, span) in spans.iter().enumerate() {
            let begin = self.labelled(head.first_statement + statement, *span).start;
            // The elements of a diagram need not stand in the order of their statements.
            if begin < end {
                continue;
            }
            let between = self.text.get(end as usize..begin as usize).unwrap_or_default();
            let mut lines = between.split('\n');
            if let Some(comment) = lines.next().and_then(comment_of)
                && let Some(before) = statement.checked_sub(1)
            {
                out.push(StatementComment { statement: before, after: Some(comment), ..StatementComment::default() });
            }
            // The lines before the first statement are the comment of the network.
            let before: Vec<String> = if statement == 0 { Vec::new() } else { lines.filter_map(comment_of).collect() };
            if !before.is_empty() {
                out.push(StatementComment { statement, before, ..StatementComment::default() });
            }
            end = span.end;
        }
        if let Some(last) = spans.len().checked_sub(1) {
            let rest = self.text.get(end as usize..).unwrap_or_default();
            if let Some(comment) = rest.split('\n').next().and_then(comment_of) {
                out.push(StatementComment { statement: last, after: Some(comment), ..StatementComment::default() });
            }
        }
        out
    }
}

/// The comment of a line; nothing else but the end of a statement stands before it.
fn comment_of(line: &str) -> Option<String> {
    let line = line.trim_start().trim_start_matches(';').trim();
    line.starts_with("//").then(|| line.to_owned())
}

/// What an operand is by its meaning.
pub(crate) fn class(operand: &Operand) -> Class {
    match operand {
        Operand::Timer(_) => Class::Timer,
        Operand::Counter(_) => Class::Counter,
        Operand::Memory(Access { width, .. }) => bits(*width),
        Operand::Constant(value) => constant(value).map_or(Class::Unknown, Class::Constant),
        _ => Class::Unknown,
    }
}

/// What a constant is that is loaded.
fn constant(value: &Value) -> Option<Constant> {
    Some(match value {
        value if value.accumulator() == Some(0) => Constant::Zero,
        Value::Int(number) if *number < 0 => Constant::NegativeInt,
        Value::Int(_) => Constant::Int,
        Value::DoubleInt(_) | Value::Time(_) | Value::TimeOfDay(_) => Constant::DoubleInt,
        Value::Real(_) => Constant::Real,
        Value::S5Time(_) => Constant::S5Time,
        Value::Counter(_) => Constant::Count,
        Value::Byte(_) => Constant::Bits(8),
        Value::Word(_) | Value::Date(_) => Constant::Bits(16),
        Value::DoubleWord(_) | Value::Pointer(_) => Constant::Bits(32),
        Value::Characters(text) => Constant::Bits(if text.len() > 2 { 32 } else { 16 }),
        Value::Bool(_) | Value::DateAndTime(_) | Value::DataPointer { .. } | Value::Any(_) | Value::Image(_) => return None,
    })
}

/// What an actual parameter is by the type of its parameter.
fn passed(call: &Call, name: &str) -> Class {
    match call.parameters.iter().find(|parameter| parameter.name.eq_ignore_ascii_case(name)).map(|one| &one.data_type) {
        Some(DataType::Timer) => Class::Timer,
        Some(DataType::Counter) => Class::Counter,
        Some(data_type) => data_type.width().map_or(Class::Unknown, bits),
        None => Class::Unknown,
    }
}

fn bits(width: Width) -> Class {
    Class::Bits(width.bits() as u8)
}

/// Something at a constant address that shares memory only with what lies in the same area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Extent {
    /// Area and bits, from and to.
    Memory(Area, u32, u32),
    /// A timer.
    Timer(u16),
    /// A counter.
    Counter(u16),
}

impl Extent {
    fn of(operand: &Operand) -> Option<Self> {
        match operand {
            // Data blocks are reached in several ways, and the peripheral outputs have a place in the process image.
            Operand::Memory(Access {
                width,
                location: Location::Fixed { area: area @ (Area::Input | Area::Output | Area::BitMemory | Area::Local), position },
            }) => Some(Self::Memory(*area, *position, position.saturating_add(width.bits()))),
            Operand::Timer(NumberOperand::Fixed(number)) => Some(Self::Timer(*number)),
            Operand::Counter(NumberOperand::Fixed(number)) => Some(Self::Counter(*number)),
            _ => None,
        }
    }

    fn overlaps(self, other: Self) -> bool {
        match (self, other) {
            (Self::Memory(area, from, to), Self::Memory(other, begin, end)) => area == other && from < end && begin < to,
            (one, other) => one == other,
        }
    }
}

/// What is known of the block that a network stands in.
struct Around<'r, 'a> {
    reader: &'r Reader<'a>,
    network: u32,
    known: Option<&'r Known>,
}

impl Surroundings for Around<'_, '_> {
    fn scratch(&self, operand: &str) -> Option<u32> {
        scratch_number(operand).filter(|position| *position >= self.reader.scratch)
    }

    fn is_temporary(&self, operand: &str) -> bool {
        let Some(name) = operand.strip_prefix('#') else { return false };
        let name = name.trim_matches('"');
        let declared = self.reader.resolved.interface.variable(name);
        let is_bit = declared.is_some_and(|variable| variable.section == Section::Temp && variable.data_type == DataType::Bool);
        let networks = self.reader.touched.get(&operand.to_ascii_uppercase());
        is_bit && networks.is_none_or(|networks| networks.iter().all(|network| *network == self.network))
    }

    fn class(&self, operand: &str) -> Class {
        self.reader.classes.get(operand).copied().unwrap_or(Class::Unknown)
    }

    fn overlap(&self, left: &str, right: &str) -> bool {
        let extents = &self.reader.extents;
        match (extents.get(left), extents.get(right)) {
            (Some(left), Some(right)) => left.overlaps(*right),
            _ => true,
        }
    }

    fn begins_fresh(&self) -> bool {
        let own = self.known.and_then(|known| known.fresh.get(self.network.checked_sub(1)? as usize));
        own.copied().unwrap_or(true)
    }

    fn is_read_elsewhere(&self, bit: u32) -> bool {
        let others = self.known.map_or(&[][..], |known| &known.reads).iter().zip(1..);
        others.into_iter().any(|(reads, number)| number != self.network && reads.contains(&bit))
    }

    fn branch_result_matters(&self) -> bool {
        // Who calls the block may look at it, and a jump may lead back.
        self.reader.resolved.id.kind != BlockKind::OrganizationBlock
            || self.reader.branch_results.iter().any(|network| *network != self.network)
    }
}
