//! One network in another form, and what it replaces in its source.

use std::collections::{BTreeSet, HashMap, HashSet};

use sieben_model::block::BlockId;

use super::comments::Comments;
use super::{AnswerKind, Form, Redrawing, RedrawnNetwork, Source, Target, statement_line};
use crate::network::flavour::{Drawing, Flavour};
use crate::network::model::Network;
use crate::network::operand::Operand;
use crate::network::read::{Answer, Mode};
use crate::network::reasons::{Reason, Refusal, Rewrite};
use crate::network::{form_a, form_b, to_lad::to_lad};
use crate::stl::ast;
use crate::stl::diagrams::{DrawnNetwork, StatementComment};
use crate::stl::mnemonics::notation_after;

/// A network that is redrawn.
pub(super) struct One<'a> {
    pub(super) source: &'a Source<'a>,
    pub(super) redrawing: &'a Redrawing,
    pub(super) network: &'a DrawnNetwork,
    pub(super) diagrams: &'a [(usize, usize)],
}

/// A replacement: from byte, to byte, the new text.
pub(super) type Edit = (usize, usize, String);

impl One<'_> {
    pub(super) fn redraw(&self, block: BlockId, labels: &mut Labels) -> (RedrawnNetwork, Option<Edit>) {
        let target = self.redrawing.target;
        let drawing = match target {
            Target::Diagram(drawing, _) => Some(drawing),
            Target::Statements => None,
        };
        let drawn = match drawing {
            Some(drawing) => self.answer(drawing),
            None => Drawn { kind: AnswerKind::Exact, codes: BTreeSet::new(), refusal: None, networks: Vec::new() },
        };
        let diagrams = match target {
            Target::Diagram(drawing, form) if drawn.kind != AnswerKind::No => Some(self.diagrams(&drawn.networks, drawing, form)),
            _ => None,
        };
        let has_form = self.has_head() || self.network.statements.is_empty();
        let same = self.network.drawing == drawing && has_form && !matches!(target, Target::Diagram(_, Form::B));
        let rewritten = drawn.kind == AnswerKind::Equivalent && self.redrawing.mode == Mode::Strict;
        let stays = same || drawn.kind == AnswerKind::No || rewritten;
        let text = diagrams.as_ref().map_or_else(|| self.statements(), |diagrams| diagrams.join("\n"));
        let statement = drawn.refusal.as_ref().and_then(|refusal| self.network.spans.get(refusal.statement));
        let span = statement.copied().unwrap_or(self.network.span);
        let edit = (!stays).then(|| {
            // What is counted through the block is counted again.
            let bodies = diagrams.unwrap_or_else(|| vec![self.renumbered(labels)]);
            self.edit(&bodies, drawing)
        });
        let redrawn = RedrawnNetwork {
            block,
            number: self.network.number,
            answer: drawn.kind,
            codes: drawn.codes,
            refusal: drawn.refusal,
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
    fn answer(&self, drawing: Drawing) -> Drawn {
        let (mut kind, networks, mut codes, mut refusal) = match &self.network.answer {
            Answer::Exact(network) => (AnswerKind::Exact, vec![network.clone()], BTreeSet::new(), None),
            Answer::Equivalent(reading, refusal) => {
                (AnswerKind::Equivalent, reading.networks.clone(), reading.rewrites.clone(), refusal.clone())
            }
            Answer::No(refusal) => (AnswerKind::No, Vec::new(), BTreeSet::new(), Some(refusal.clone())),
        };
        if drawing != Drawing::Lad {
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
    fn diagrams(&self, networks: &[Network], drawing: Drawing, form: Form) -> Vec<String> {
        let comments = Comments::new(self.comments());
        let mut texts: Vec<String> = networks
            .iter()
            .map(|network| match form {
                Form::A => form_a::print(network, drawing, &|place, pin| comments.of(place, pin)),
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
                true => StatementComment { statement, before: vec![comment.text], after: None, pin: comment.pin },
                false => StatementComment { statement, before: Vec::new(), after: Some(comment.text), pin: comment.pin },
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
    fn edit(&self, bodies: &[String], drawing: Option<Drawing>) -> Edit {
        let text = self.source.text;
        let word = match drawing {
            usual if usual == self.source.drawing => String::new(),
            Some(drawing) => format!(" {}", drawing.word()),
            None => " STL".to_owned(),
        };
        let head = self.network.span.start as usize;
        let has_head = self.has_head();
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
        (begin, to, new)
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
        let mut names = HashMap::new();
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
pub(super) struct Labels {
    count: u32,
    taken: HashSet<String>,
}

impl Labels {
    pub(super) fn of(block: &ast::Block) -> Self {
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
