//! The networks of a source in another form: as LAD, as FBD or as statements, in the same file. Everything else keeps its bytes.

mod comments;
mod network;

use std::collections::BTreeSet;

use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Span};

use super::ast;
use super::diagrams::{DrawnNetwork, networks};
use super::lower::ResolvedBlock;
use super::mnemonics::{instruction_in, status_in};
use super::parser::{Parsed, parse_as};
use super::syntax::SyntaxKind;
use crate::network::flavour::Drawing;
use crate::network::read::Mode;
use crate::network::reasons::{Refusal, Rewrite};
use crate::network::statement::Statement;
use network::{Edit, Labels, One};

/// What networks become.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A diagram.
    Diagram(Drawing, Form),
    /// Statements.
    Statements,
}

/// The text forms of a diagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// One element on each line.
    A,
    /// One line.
    B,
}

/// How networks are redrawn.
#[derive(Clone, Copy, Debug)]
pub struct Redrawing {
    /// What they become.
    pub target: Target,
    /// Only this block.
    pub block: Option<BlockId>,
    /// What keeps the meaning is rewritten, instead of being listed.
    pub mode: Mode,
}

/// What came of a network.
#[derive(Clone, Debug)]
pub struct RedrawnNetwork {
    /// Its block.
    pub block: BlockId,
    /// Its number, from 1.
    pub number: u32,
    /// Which of the three answers.
    pub answer: AnswerKind,
    /// The rewrites that it needs.
    pub codes: BTreeSet<Rewrite>,
    /// Why it cannot be drawn as it is.
    pub refusal: Option<Refusal>,
    /// Where the statement stands that is in the way, or the network.
    pub span: Span,
    /// The network in the form that was asked for; of one that cannot be drawn its statements.
    pub text: String,
    /// It stays as it was.
    pub stays: bool,
}

/// The three answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnswerKind {
    /// Written as statements again it is the same.
    Exact,
    /// It means the same.
    Equivalent,
    /// It cannot be drawn.
    No,
}

impl AnswerKind {
    /// `exact`, `equivalent`, `no`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Equivalent => "equivalent",
            Self::No => "no",
        }
    }
}

/// A source whose networks were redrawn.
#[derive(Clone, Debug)]
pub struct Redrawn {
    /// Its new text.
    pub text: String,
    /// What came of each network.
    pub networks: Vec<RedrawnNetwork>,
}

/// A source with its blocks after their check.
pub struct Source<'a> {
    /// Which file it is.
    pub file: FileId,
    /// Its text.
    pub text: &'a str,
    /// The mnemonic language that was found out or chosen.
    pub mnemonics: Mnemonics,
    /// How its networks are written that do not say it.
    pub drawing: Option<Drawing>,
    /// The blocks of the program.
    pub blocks: Vec<&'a ResolvedBlock>,
}

/// A block of a source with its networks.
#[derive(Clone, Debug)]
pub struct SourceBlock {
    /// Which one.
    pub id: BlockId,
    /// Its title, its comment and the rest of its header.
    pub header: ast::Header,
    /// Its networks.
    pub networks: Vec<DrawnNetwork>,
}

impl Source<'_> {
    /// Its blocks with their networks, in the order of the text.
    pub fn blocks(&self, mode: Mode) -> Vec<SourceBlock> {
        let parsed = self.parse();
        let block = |(block, resolved): (&ast::Block, &ResolvedBlock)| SourceBlock {
            id: resolved.id,
            header: block.header.clone(),
            networks: networks(self.text, block, resolved, self.mnemonics, mode),
        };
        self.blocks_of(&parsed).map(block).collect()
    }

    fn parse(&self) -> Parsed {
        parse_as(self.file, self.text, Some(self.mnemonics), self.drawing)
    }

    /// The blocks of the source with what came of them; one without statements is known by its number.
    fn blocks_of<'p>(&'p self, parsed: &'p Parsed) -> impl Iterator<Item = (&'p ast::Block, &'p ResolvedBlock)> {
        let starts = self.blocks.iter().filter_map(|resolved| {
            let span = resolved.statements.first()?.span();
            (span.file == self.file).then_some((span.start, *resolved))
        });
        let mut starts: Vec<(u32, &ResolvedBlock)> = starts.collect();
        starts.sort_by_key(|(start, _)| *start);
        parsed.file.blocks.iter().filter_map(move |block| {
            let next = starts.partition_point(|(start, _)| *start < block.span.start);
            let by_place = starts.get(next).filter(|(start, _)| *start <= block.span.end).map(|(_, resolved)| *resolved);
            let by_number = || match &block.name {
                ast::BlockName::Absolute { kind, number, .. } => {
                    let id = BlockId::new(*kind, u16::try_from(*number).ok()?);
                    self.blocks.iter().find(|resolved| resolved.id == id).copied()
                }
                ast::BlockName::Symbol(_) => None,
            };
            Some((block, by_place.or_else(by_number)?))
        })
    }

    /// The source with its networks in another form.
    pub fn redraw(&self, redrawing: &Redrawing) -> Redrawn {
        let parsed = self.parse();
        let diagrams = diagram_places(&parsed);
        let mut edits: Vec<Edit> = Vec::new();
        let mut out = Vec::new();
        for (block, resolved) in self.blocks_of(&parsed) {
            if redrawing.block.is_some_and(|wanted| wanted != resolved.id) {
                continue;
            }
            let mut labels = Labels::of(block);
            for network in networks(self.text, block, resolved, self.mnemonics, redrawing.mode) {
                let one = One { source: self, redrawing, network: &network, diagrams: &diagrams };
                let (redrawn, edit) = one.redraw(resolved.id, &mut labels);
                out.push(redrawn);
                edits.extend(edit);
            }
        }
        edits.sort_by_key(|edit| edit.0);
        let mut text = String::with_capacity(self.text.len());
        let mut at = 0;
        for (from, to, new) in edits {
            text.push_str(self.text.get(at..from).unwrap_or_default());
            text.push_str(&new);
            at = to.max(from);
        }
        text.push_str(self.text.get(at..).unwrap_or_default());
        Redrawn { text, networks: out }
    }
}

/// Where the diagrams of a source stand.
fn diagram_places(parsed: &Parsed) -> Vec<(usize, usize)> {
    let tokens = parsed.syntax().descendants_with_tokens().filter_map(|element| element.into_token());
    let diagrams = tokens.filter(|token| token.kind() == SyntaxKind::Diagram);
    diagrams.map(|token| (usize::from(token.text_range().start()), usize::from(token.text_range().end()))).collect()
}

/// A statement in the usual columns.
pub fn statement_line(statement: &Statement, mnemonics: Mnemonics) -> String {
    let label = statement.label.as_ref().map(|label| format!("{label}:")).unwrap_or_default();
    let mnemonic = instruction_in(statement.mnemonic, mnemonics);
    // A label may look like an address.
    let operand = match statement.mnemonic {
        jump if jump.starts_with('J') || jump == "LOOP" => statement.operand.text.clone(),
        _ if status_in(&statement.operand, mnemonics) != statement.operand.text => status_in(&statement.operand, mnemonics).to_owned(),
        _ => statement.operand.spaced(),
    };
    let mut line = format!("{label:<6}{mnemonic:<6}{operand}");
    if statement.mnemonic == "CALL" {
        line = format!("{label:<6}CALL  {operand}");
        if let Some(instance) = &statement.instance {
            line.push_str(&format!(", {}", instance.spaced()));
        }
        if !statement.parameters.is_empty() {
            let parameters: Vec<String> =
                statement.parameters.iter().map(|one| format!("        {} := {}", one.name.as_name(), one.actual.spaced())).collect();
            line.push_str(&format!(" (\n{})", parameters.join(",\n")));
        }
    }
    format!("{};", line.trim_end())
}
