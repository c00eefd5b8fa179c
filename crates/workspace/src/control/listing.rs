//! A block as it is listed: its statements with networks, symbols and comments, or the lines of its source.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde_json::{Value as Json, json};
use sieben_engine::CodeBlock;
use sieben_model::address::Operand;
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, SourceFile, Span};
use sieben_sim::names::{Name, Scope};

use super::facts::Facts;
use super::request::shortened;
use crate::refusal::Refusal;
use crate::status::Written;

/// Lines in one answer.
const LINES_MAX: usize = 1_000;

/// A part of the listing of a block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Listing {
    /// The block.
    pub block: BlockId,
    /// What people call it, if it has a name of its own.
    pub name: Option<String>,
    /// How it is listed.
    pub form: Form,
    /// Where the list goes on: how many lines are left out then.
    pub next: Option<usize>,
    /// The lines.
    pub lines: Vec<Line>,
}

/// How a block is listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Statement by statement.
    Statements,
    /// As its source: lines in which statements begin.
    Source,
}

/// A line of a listing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Line {
    /// A network begins.
    Network {
        /// Its number, from 1.
        number: u32,
        /// Its title.
        title: String,
    },
    /// A statement.
    Statement {
        /// Its number, from 1.
        statement: u64,
        /// As it is written, without its label and comment.
        text: String,
        /// The symbol of its operand.
        symbol: Option<String>,
        /// The comment of the symbol.
        comment: Option<String>,
        /// Where it stands.
        at: (String, u32),
    },
    /// A line of a source.
    Source {
        /// The line.
        text: String,
        /// The statements that begin in it, from 1.
        statements: Vec<u64>,
        /// Where it stands.
        at: (String, u32),
    },
}

fn not_listed(message: String) -> Refusal {
    Refusal::new(Problem::P7095, message)
}

/// Lists a block, or the one that a screen begins with; `from` lines are left out.
pub(super) fn listing(facts: &Facts, name: Option<&str>, from: usize) -> Result<Listing, Refusal> {
    let block = match name {
        Some(name) => facts.block(name).ok_or_else(|| not_listed(format!("there is no block `{}`", shortened(name))))?,
        None => facts.first_block().ok_or_else(|| not_listed("the program has no block with statements".to_owned()))?,
    };
    let code = facts.program.code.get(&block).ok_or_else(|| not_listed(format!("{block} has no statements in this program")))?;
    let form = if facts.text_blocks.contains_key(&block) { Form::Source } else { Form::Statements };
    let all = match form {
        Form::Statements => statements(facts, block, code),
        Form::Source => source_lines(facts, code),
    };
    let lines: Vec<Line> = all.iter().skip(from).take(LINES_MAX).cloned().collect();
    let next = from.saturating_add(lines.len());
    Ok(Listing { block, name: facts.block_names.get(&block).cloned(), form, next: (next < all.len()).then_some(next), lines })
}

/// A text of the program.
fn file(facts: &Facts, id: FileId) -> Option<&SourceFile> {
    facts.sources.iter().find(|&(other, _)| other == id).map(|(_, file)| file)
}

/// What stands at a place.
fn slice(facts: &Facts, span: Span) -> Option<&str> {
    file(facts, span.file)?.text.get(span.start as usize..span.end as usize)
}

/// The statements of a block with the titles of its networks.
fn statements(facts: &Facts, block: BlockId, code: &CodeBlock) -> Vec<Line> {
    let mut lines = Vec::new();
    let mut places = facts.places();
    let networks = facts.networks.get(&block);
    let (mut after, mut begun): (Option<Span>, u32) = (None, 0);
    for (number, &span) in (0_u32..).zip(&code.spans) {
        let Some(text) = slice(facts, span) else { continue };
        let stated = facts.stated.get(&(block, number));
        let text = stated.map_or_else(|| text.trim().trim_end_matches(';').trim_end(), String::as_str);
        // The end of the block, which need not be written, has the place of the last statement.
        let is_new = after.is_none_or(|after| after.file != span.file || span.start >= after.end);
        if text.is_empty() || !(is_new || stated.is_some()) {
            continue;
        }
        if let Some((network, title)) = networks.and_then(|networks| networks.of(number)).filter(|&(network, _)| network > begun) {
            begun = network;
            lines.push(Line::Network { number: network, title: title.to_owned() });
        }
        after = Some(span);
        let mnemonics = facts.mnemonics.get(&span.file).copied().unwrap_or(Mnemonics::English);
        let (text, symbol) = spelled(facts, text, mnemonics);
        let Some(at) = places.line_of(block, number) else { continue };
        lines.push(Line::Statement {
            statement: u64::from(number) + 1,
            text,
            comment: symbol.as_ref().and_then(|name| facts.symbols.find(name)).map(|symbol| symbol.comment.clone()),
            symbol,
            at,
        });
    }
    lines
}

/// A statement on one line with its operand as an address, and the symbol of that.
fn spelled(facts: &Facts, text: &str, mnemonics: Mnemonics) -> (String, Option<String>) {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let Some((mnemonic, operand)) = text.split_once(' ') else { return (text, None) };
    let operand = operand.trim();
    let quoted = operand.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
    let meant = match quoted {
        Some(name) => facts.symbols.operand(name),
        None => Operand::parse(operand),
    };
    let Some(meant) = meant else { return (text, None) };
    let symbol = facts.symbols.find_operand(&meant).map(|symbol| symbol.name.clone());
    // An address stays as the user wrote it, in either mnemonic language.
    let address = if quoted.is_some() { meant.spell(mnemonics) } else { operand.to_owned() };
    (format!("{mnemonic} {address}"), symbol)
}

/// The lines of the source of a block from its first statement to its last one.
fn source_lines(facts: &Facts, code: &CodeBlock) -> Vec<Line> {
    let Some(first) = code.spans.iter().find(|span| file(facts, span.file).is_some()) else { return Vec::new() };
    let Some(file) = file(facts, first.file) else { return Vec::new() };
    let mut starts: BTreeMap<u32, Vec<u64>> = BTreeMap::new();
    for (number, span) in (1_u64..).zip(&code.spans) {
        if span.file == first.file && span.start < span.end {
            starts.entry(span.start).or_default().push(number);
        }
    }
    let (Some(begin), Some(end)) = (starts.keys().next().copied(), starts.keys().next_back().copied()) else { return Vec::new() };
    let mut lines = Vec::new();
    let mut at = 0_u32;
    for (number, text) in (1_u32..).zip(file.text.split_inclusive('\n')) {
        let next = at.saturating_add(u32::try_from(text.len()).unwrap_or(u32::MAX));
        if next > begin && at <= end {
            let statements = starts.range(at..next).flat_map(|(_, numbers)| numbers.iter().copied()).collect();
            lines.push(Line::Source { text: text.trim_end().to_owned(), statements, at: (file.name.clone(), number) });
        }
        at = next;
    }
    lines
}

/// The variables that the assignments of a block of ST write.
pub fn written(facts: &Facts, block: BlockId) -> Written {
    let mut written = BTreeMap::new();
    if let (Some(&scope), Some(code)) = (facts.text_blocks.get(&block), facts.program.code.get(&block)) {
        for (number, &span) in (0_u32..).zip(&code.spans) {
            let name = slice(facts, span).and_then(|text| assigned(facts, scope, text));
            written.extend(name.map(|name| (number, name)));
        }
    }
    Arc::new(written)
}

/// The variable before the `:=` of an assignment.
fn assigned(facts: &Facts, scope: Scope, text: &str) -> Option<Name> {
    let (variable, _) = text.split_once(":=")?;
    let variable = variable.trim();
    let is_name = !variable.is_empty() && !variable.contains(['(', '\n', ';']);
    let variable = variable.strip_prefix('%').unwrap_or(variable);
    is_name.then(|| Name::parse_in(variable, Some(scope), &facts.symbols, &facts.program).ok())?.map(Name::readable)
}

impl Listing {
    /// The fields of the answer.
    pub(super) fn json(&self) -> Json {
        let form = match self.form {
            Form::Statements => "statements",
            Form::Source => "source",
        };
        json!({
            "block": self.block.to_string(), "name": self.name, "form": form, "next": self.next,
            "lines": self.lines.iter().map(Line::json).collect::<Json>(),
        })
    }
}

impl Line {
    fn json(&self) -> Json {
        match self {
            Self::Network { number, title } => json!({ "network": number, "title": title }),
            Self::Statement { statement, text, symbol, comment, at: (file, line) } => json!({
                "statement": statement, "text": text, "symbol": symbol, "comment": comment, "file": file, "line": line,
            }),
            Self::Source { text, statements, at: (file, line) } => {
                json!({ "text": text, "statements": statements, "file": file, "line": line })
            }
        }
    }
}
