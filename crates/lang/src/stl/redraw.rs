//! The networks of a source in another form: as LAD, as FBD or as statements, in the same file. Everything else keeps its bytes.

use std::cell::RefCell;
use std::collections::{BTreeSet, HashSet};

use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Span};

use super::ast;
use super::diagrams::{DrawnNetwork, StatementComment, networks};
use super::lower::ResolvedBlock;
use super::mnemonics::{notation_after, translate_instruction};
use super::parser::{Parsed, parse_as};
use super::syntax::SyntaxKind;
use crate::network::flavour::{Drawing, Flavour};
use crate::network::model::{Network, Place};
use crate::network::operand::{Operand, STATUS_BITS};
use crate::network::read::{Answer, Mode};
use crate::network::reasons::{Reason, Refusal, Rewrite};
use crate::network::statement::Statement;
use crate::network::{form_a, form_b, to_lad::to_lad};

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
        let mut edits: Vec<(usize, usize, String)> = Vec::new();
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

/// A network that is redrawn.
struct One<'a> {
    source: &'a Source<'a>,
    redrawing: &'a Redrawing,
    network: &'a DrawnNetwork,
    diagrams: &'a [(usize, usize)],
}

/// A replacement: from byte, to byte, the new text.
type Edit = (usize, usize, String);

impl One<'_> {
    fn redraw(&self, block: BlockId, labels: &mut Labels) -> (RedrawnNetwork, Option<Edit>) {
        let drawing = match self.redrawing.target {
            Target::Diagram(drawing, _) => Some(drawing),
            Target::Statements => None,
        };
        let mut answer = self.answer(drawing);
        let has_form = self.has_head() || self.network.statements.is_empty();
        let same = self.network.drawing == drawing
            && has_form
            && self.redrawing.target != Target::Diagram(drawing.unwrap_or(Drawing::Lad), Form::B);
        if drawing.is_none() {
            answer = Drawn { kind: AnswerKind::Exact, codes: BTreeSet::new(), refusal: None, networks: Vec::new() };
        }
        let rewritten = answer.kind == AnswerKind::Equivalent && self.redrawing.mode == Mode::Strict;
        let stays = same || answer.kind == AnswerKind::No || rewritten;
        let text = match (drawing, answer.kind) {
            (Some(drawing), AnswerKind::Exact | AnswerKind::Equivalent) => self.diagrams(&answer.networks, drawing).join("\n"),
            _ => self.statements(),
        };
        let statement = answer.refusal.as_ref().and_then(|refusal| self.network.spans.get(refusal.statement));
        let span = statement.copied().unwrap_or(self.network.span);
        let edit = (!stays).then(|| self.edit(&answer.networks, drawing, labels)).flatten();
        let redrawn = RedrawnNetwork {
            block,
            number: self.network.number,
            answer: answer.kind,
            codes: answer.codes,
            refusal: answer.refusal,
            span,
            text,
            stays,
        };
        (redrawn, edit)
    }

    /// The network begins with its keyword.
    fn has_head(&self) -> bool {
        let head = self.network.span.start as usize;
        self.source.text.get(head..head + "NETWORK".len()).is_some_and(|keyword| keyword.eq_ignore_ascii_case("NETWORK"))
    }

    /// What can be drawn, in the drawing that was asked for.
    fn answer(&self, drawing: Option<Drawing>) -> Drawn {
        let (mut kind, networks, mut codes, mut refusal) = match &self.network.answer {
            Answer::Exact(network) => (AnswerKind::Exact, vec![network.clone()], BTreeSet::new(), None),
            Answer::Equivalent(reading, refusal) => {
                (AnswerKind::Equivalent, reading.networks.clone(), reading.rewrites.clone(), refusal.clone())
            }
            Answer::No(refusal) => (AnswerKind::No, Vec::new(), BTreeSet::new(), Some(refusal.clone())),
        };
        if drawing != Some(Drawing::Lad) {
            return Drawn { kind, codes, refusal, networks };
        }
        let mut ladders = Vec::new();
        for network in &networks {
            match to_lad(network) {
                Ok((_, more)) if !more.is_empty() && !self.network.is_fresh => {
                    refusal = Some(Refusal::new(Reason::Carried, 0));
                    return Drawn { kind: AnswerKind::No, codes: BTreeSet::new(), refusal, networks: Vec::new() };
                }
                Ok((ladder, more)) => {
                    if !more.is_empty() && kind == AnswerKind::Exact {
                        kind = AnswerKind::Equivalent;
                    }
                    codes.extend(more);
                    ladders.push(ladder);
                }
                Err(why) => {
                    refusal = Some(why);
                    return Drawn { kind: AnswerKind::No, codes: BTreeSet::new(), refusal, networks: Vec::new() };
                }
            }
        }
        Drawn { kind, codes, refusal, networks: ladders }
    }

    /// The text of each diagram, without its head.
    fn diagrams(&self, networks: &[Network], drawing: Drawing) -> Vec<String> {
        let comments = Comments::new(self.comments());
        let form = match self.redrawing.target {
            Target::Diagram(_, form) => form,
            Target::Statements => Form::A,
        };
        let mut texts: Vec<String> = networks
            .iter()
            .map(|network| match form {
                Form::A => form_a::print(network, drawing, &|place| comments.of(place)),
                Form::B => {
                    let line = form_b::print(network, drawing);
                    if line == "empty network" { String::new() } else { format!("    {line}\n") }
                }
            })
            .collect();
        // A comment whose element is not drawn is not lost.
        let left = comments.left();
        if !left.is_empty() {
            let lines: String = left.iter().map(|comment| format!("    {comment}\n")).collect();
            match (form, texts.first_mut()) {
                (Form::B, Some(first)) => first.insert_str(0, &lines),
                (Form::A, Some(_)) => {
                    if let Some(last) = texts.last_mut() {
                        last.push_str(&lines);
                    }
                }
                (_, None) => texts.push(lines),
            }
        }
        texts
    }

    /// The comments of the network; those of a diagram belong to its lines.
    fn comments(&self) -> Vec<StatementComment> {
        let Some((from, to)) = self.diagram() else { return self.network.comments.clone() };
        let network = self.network;
        let mut out = Vec::new();
        for comment in form_a::comments(self.source.text, from, to) {
            let statement = self.statement_at(comment.line).unwrap_or(network.statements.len());
            out.push(match comment.own_line {
                true => StatementComment { statement, before: vec![comment.text], after: None },
                false => StatementComment { statement, before: Vec::new(), after: Some(comment.text) },
            });
        }
        out
    }

    /// A statement of the element that stands at a byte or after it. Brackets around an element belong to what is around it.
    fn statement_at(&self, byte: usize) -> Option<usize> {
        let spans = self.network.spans.iter().map(|span| span.start as usize);
        let start = spans.clone().filter(|start| *start >= byte).min()?;
        let of_element = || spans.clone().enumerate().filter(move |(_, one)| *one == start).map(|(index, _)| index);
        let is_bracket = |index: &usize| {
            let mnemonic = self.network.statements.get(*index).map_or("", |statement| statement.mnemonic);
            mnemonic == ")" || (mnemonic.ends_with('(') && mnemonic != "MCR(")
        };
        // One in the middle: what stands around it belongs to EN and ENO.
        let own: Vec<usize> = of_element().filter(|index| !is_bracket(index)).collect();
        own.get(own.len() / 2).copied().or_else(|| of_element().next())
    }

    /// Where the diagram of the network stands, from the beginning of its first line.
    fn diagram(&self) -> Option<(usize, usize)> {
        self.network.drawing?;
        let body = self.network.body;
        // The first place after the body, so the one before may hold it.
        let after = self.diagrams.partition_point(|(from, _)| *from <= body.start as usize);
        let (from, to) = *self.diagrams.get(after.checked_sub(1)?).filter(|(_, to)| body.end as usize <= *to)?;
        // Of networks on one line each without their keyword the line is all there is.
        let whole = self.has_head() || form_a::is_form_a(self.source.text.get(from..to)?, Flavour::S7);
        whole.then_some((from, to))
    }

    /// The statements as they are written in the usual layout.
    fn statements(&self) -> String {
        let mut out = String::new();
        let comments = self.comments();
        for (index, statement) in self.network.statements.iter().enumerate() {
            let own = || comments.iter().filter(|comment| comment.statement == index);
            for line in own().flat_map(|comment| &comment.before) {
                out.push_str(&format!("      {line}\n"));
            }
            let mut line = statement_line(statement, self.source.mnemonics);
            for comment in own().filter_map(|comment| comment.after.as_ref()) {
                let spaces = 40_usize.saturating_sub(line.chars().count()).max(1);
                line.extend(std::iter::repeat_n(' ', spaces));
                line.push_str(comment);
            }
            out.push_str(&line);
            out.push('\n');
        }
        let count = self.network.statements.len();
        for comment in comments.iter().filter(|comment| comment.statement >= count) {
            for line in comment.before.iter().chain(&comment.after) {
                out.push_str(&format!("      {line}\n"));
            }
        }
        out
    }

    /// The replacement of the network with its head.
    fn edit(&self, networks: &[Network], drawing: Option<Drawing>, labels: &mut Labels) -> Option<Edit> {
        let text = self.source.text;
        let usual = self.source.drawing == drawing;
        let word = match (usual, drawing) {
            (true, _) => String::new(),
            (false, Some(drawing)) => format!(" {}", drawing.word()),
            (false, None) => " STL".to_owned(),
        };
        let head = self.network.span.start as usize;
        let has_head = self.has_head();
        let bodies: Vec<String> = match drawing {
            Some(drawing) => self.diagrams(networks, drawing),
            None => {
                // What is counted through the block is counted again.
                let renumbered = self.renumbered(labels);
                vec![renumbered]
            }
        };
        // A network without statements has its place after the word that says how it is written.
        let head_end = if has_head { notation_after(text, head + "NETWORK".len()) } else { 0 };
        let (from, to) = self.extent();
        let (from, to) = (from.max(head_end), to.max(head_end));
        let mut new = String::new();
        let keyword_end = head + "NETWORK".len();
        let begin = if has_head { keyword_end } else { from };
        if has_head {
            new.push_str(&word);
            new.push_str(text.get(head_end..from).unwrap_or_default());
        } else {
            new.push_str(&format!("NETWORK{word}\n"));
        }
        for (index, body) in bodies.iter().enumerate() {
            if index > 0 {
                new.push_str(&format!("\nNETWORK{word}\n"));
            }
            new.push_str(body);
        }
        let rest = text.get(to..).unwrap_or_default();
        // The line end of the last line stays.
        if rest.starts_with(['\n', '\r']) || rest.is_empty() {
            let end = new.trim_end_matches('\n').len();
            new.truncate(end);
            if rest.is_empty() {
                new.push('\n');
            }
        }
        // The line ends are those that the network has.
        let line_end = text.get(begin..).and_then(|rest| rest.split_inclusive('\n').next()).filter(|line| line.ends_with("\r\n"));
        let new = if line_end.is_some() { new.replace("\r\n", "\n").replace('\n', "\r\n") } else { new };
        Some((begin, to, new))
    }

    /// Where the statements or the elements stand: whole lines, with the comment after the last one.
    fn extent(&self) -> (usize, usize) {
        let text = self.source.text;
        let body = self.network.body;
        let (from, mut to) = self.diagram().unwrap_or((body.start as usize, body.end as usize));
        let line = text[..from].rfind('\n').map_or(0, |at| at + 1);
        let from = if text[line..from].trim().is_empty() { line } else { from };
        let rest = text.get(to..).unwrap_or_default();
        let end_of_line = rest.find(['\n', '\r']).unwrap_or(rest.len());
        let after = rest[..end_of_line].trim_start().trim_start_matches(';').trim_start();
        if after.is_empty() || after.starts_with("//") {
            to += end_of_line;
        } else if let Some(semicolon) = rest[..end_of_line].find(';') {
            to += semicolon + 1;
        }
        (from, to)
    }

    /// The statements with the labels of boxes counted through the block.
    fn renumbered(&self, labels: &mut Labels) -> String {
        let mut this = self.network.clone();
        let mut names = std::collections::HashMap::new();
        for statement in &this.statements {
            let generated = statement.mnemonic == "JNB" && statement.operand.starts_with('_') && self.network.drawing.is_some();
            if generated {
                names.insert(statement.operand.text.clone(), labels.next());
            }
        }
        for statement in &mut this.statements {
            if let Some(new) = names.get(statement.operand.text.as_str()).filter(|_| statement.mnemonic == "JNB") {
                statement.operand = Operand::from(new.clone());
            }
            if let Some(new) = statement.label.as_ref().and_then(|label| names.get(label.text.as_str())) {
                statement.label = Some(Operand::from(new.clone()));
            }
        }
        One { network: &this, ..*self }.statements()
    }
}

/// The labels of boxes in a block, counted through it past those that are written.
struct Labels {
    count: u32,
    taken: HashSet<String>,
}

impl Labels {
    fn of(block: &ast::Block) -> Self {
        let labels = block.statements.iter().filter_map(|statement| statement.label.as_ref());
        Self { count: 0, taken: labels.map(|label| label.text.clone()).collect() }
    }

    fn next(&mut self) -> String {
        loop {
            self.count += 1;
            let name = format!("_{:03x}", self.count);
            if !self.taken.contains(&name) {
                return name;
            }
        }
    }
}

/// What came of drawing a network.
struct Drawn {
    kind: AnswerKind,
    codes: BTreeSet<Rewrite>,
    refusal: Option<Refusal>,
    networks: Vec<Network>,
}

/// Comments by statement, each given out once.
struct Comments {
    all: Vec<StatementComment>,
    given: RefCell<HashSet<usize>>,
}

impl Comments {
    fn new(all: Vec<StatementComment>) -> Self {
        Self { all, given: RefCell::default() }
    }

    /// Those of an element: the lines before it, and the one on its line.
    fn of(&self, place: Place) -> (Vec<String>, Option<String>) {
        let (mut before, mut after) = (Vec::new(), None);
        let mut given = self.given.borrow_mut();
        for (index, comment) in self.all.iter().enumerate() {
            let inside = (place.first as usize..=place.last as usize).contains(&comment.statement);
            if !inside || !given.insert(index) {
                continue;
            }
            before.extend(comment.before.iter().cloned());
            match (&comment.after, &after) {
                (Some(text), None) => after = Some(text.clone()),
                (Some(text), Some(_)) => before.push(text.clone()),
                (None, _) => {}
            }
        }
        (before, after)
    }

    /// Those that no element took.
    fn left(&self) -> Vec<String> {
        let given = self.given.borrow();
        let left = self.all.iter().enumerate().filter(|(index, _)| !given.contains(index));
        left.flat_map(|(_, comment)| comment.before.iter().chain(&comment.after)).cloned().collect()
    }
}

/// A statement in the usual columns.
pub fn statement_line(statement: &Statement, mnemonics: Mnemonics) -> String {
    let label = statement.label.as_ref().map(|label| format!("{label}:")).unwrap_or_default();
    let mnemonic = match mnemonics {
        Mnemonics::English => statement.mnemonic,
        Mnemonics::German => translate_instruction(statement.mnemonic, Mnemonics::English).unwrap_or(statement.mnemonic),
    };
    // A label may look like an address.
    let operand = match statement.mnemonic {
        jump if jump.starts_with('J') || jump == "LOOP" => statement.operand.text.clone(),
        _ => in_language_of(&statement.operand, mnemonics).spaced(),
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

/// Status bits are called otherwise in SIMATIC.
fn in_language_of(operand: &Operand, mnemonics: Mnemonics) -> Operand {
    match mnemonics {
        Mnemonics::German if STATUS_BITS.contains(&operand.text.as_str()) => {
            super::mnemonics::translate_status(&operand.text, Mnemonics::English).map_or_else(|| operand.clone(), Operand::from)
        }
        _ => operand.clone(),
    }
}
