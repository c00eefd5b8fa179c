//! Networks that are written as diagrams: `NETWORK LAD`, `NETWORK FBD`, and files of diagrams alone.
//!
//! A diagram becomes the statements that STEP 7 makes of it. Each has the place of its element, and its operands are read where they are written.

use std::collections::HashMap;

use sieben_model::diagnostic::Diagnostic;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::source::Span;

use super::Parser;
use super::blocks::{Keyword, keyword_of};
use crate::network::flavour::{Drawing, Flavour};
use crate::network::form_a;
use crate::network::form_b;
use crate::network::memories::memories;
use crate::network::mistake::{Mistake, MistakeKind};
use crate::network::model::{Content, Network};
use crate::network::operand::Operand as Written;
use crate::network::statement::Statement;
use crate::network::{rules, write};
use crate::stl::ast::{self, Argument, Block, Call, Constant, Operand, Word};
use crate::stl::instructions::Instruction;
use crate::stl::lexer::Raw;
use crate::stl::mnemonics::{NOTATIONS, instruction_in, status_in};
use crate::stl::syntax::SyntaxKind;

/// Operands of a diagram that were read, by their first byte.
type Operands = HashMap<u32, (Operand, Span)>;

/// How much of a network was understood.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Read {
    Whole,
    /// Elements are missing: nothing is said of wires that end where they stood.
    InPart,
}

impl Parser<'_> {
    /// The word after NETWORK that says how the network is written; without one it is as the file's name says.
    pub(super) fn notation(&mut self) -> Option<Drawing> {
        let at = self.behind_blanks(self.position);
        let (raw, end) = crate::stl::lexer::token(self.text, at);
        let known = NOTATIONS.iter().find(|(word, _)| raw == Raw::Word && self.slice(at, end).eq_ignore_ascii_case(word));
        match known {
            Some(&(_, drawing)) => {
                self.blanks();
                self.bump(SyntaxKind::Keyword);
                drawing
            }
            None => self.drawing,
        }
    }

    /// How the network at the current token is written.
    pub(super) fn drawing_here(&self, block: &Block) -> Option<Drawing> {
        match block.networks.last() {
            Some(network) => network.drawing,
            None => self.drawing,
        }
    }

    /// Something that is no keyword of a source stands at the current token.
    pub(super) fn at_diagram(&self) -> bool {
        self.raw != Raw::End && self.keyword().is_none()
    }

    /// The diagram from the current token up to the next network or the end of the block.
    pub(super) fn diagram(&mut self, block: &mut Block, drawing: Drawing) {
        let from = self.text[..self.position].rfind(['\n', '\r']).map_or(0, |at| at + 1);
        let from = if self.text[from..self.position].trim().is_empty() { from } else { self.position };
        // What begins a diagram belongs to it, whatever it is.
        let to = self.diagram_end().max(self.end);
        let start = self.position;
        self.bump_to(SyntaxKind::Diagram, to);
        let under_network = !block.networks.is_empty();
        if let Some(length) = statement_of_stl(self.slice(start, to), self.mnemonics) {
            let message = format!("{} network {}: statements of STL stand here", drawing.word(), block.networks.len().max(1));
            let help = "begin the network with `NETWORK STL`";
            self.report(Diagnostic::new(Problem::P2409, self.span(start, start + length), message).help(help));
            return;
        }
        if form_a::is_form_a(self.slice(from, to), Flavour::S7) {
            let parsed = form_a::parse(self.text, from, to, Flavour::S7);
            let read = if parsed.mistakes.is_empty() { Read::Whole } else { Read::InPart };
            if !under_network {
                self.network_without_head(block, drawing, start);
            }
            parsed.mistakes.into_iter().for_each(|mistake| self.mistake(mistake, drawing, block));
            self.network_of(block, &parsed.network, drawing, read);
            return;
        }
        // On one line: each line is a network, unless the networks are told apart by their keyword.
        let mut first = true;
        for (line_start, line) in one_line_networks(self.text, start, to, under_network) {
            if !first || !under_network {
                self.network_without_head(block, drawing, line_start);
            }
            first = false;
            match form_b::parse(&line, line_start, Flavour::S7) {
                Ok(network) => self.network_of(block, &network, drawing, Read::Whole),
                Err(mistake) => self.mistake(mistake, drawing, block),
            }
        }
    }

    /// A network that begins with its first line.
    fn network_without_head(&self, block: &mut Block, drawing: Drawing, start: usize) {
        let (first_statement, span) = (block.statements.len(), self.span(start, start));
        block.networks.push(ast::Network { first_statement, drawing: Some(drawing), span, ..ast::Network::default() });
    }

    /// Where the lines of a diagram end: before the line that begins another network or ends the block, without the empty lines and comments before it.
    fn diagram_end(&self) -> usize {
        let mut at = self.position;
        let mut end = at;
        for line in form_a::written_lines(&self.text[self.position..]) {
            let content = line.trim();
            let word = content.split(|sign: char| !(sign.is_alphanumeric() || sign == '_')).next().unwrap_or_default();
            let is_pin = [":=", "=>"].iter().any(|sign| content[word.len()..].trim_start().starts_with(sign));
            if !is_pin
                && matches!(keyword_of(word), Some(Keyword::BlockStart(_) | Keyword::BlockEnd(_) | Keyword::Network | Keyword::Title))
            {
                break;
            }
            if !content.is_empty() {
                end = at + line.trim_end().len();
            }
            at += line.len();
        }
        end
    }

    fn mistake(&mut self, mistake: Mistake, drawing: Drawing, block: &Block) {
        let message = format!("{} network {}: {}", drawing.word(), block.networks.len().max(1), mistake.message);
        let diagnostic = Diagnostic::new(mistake.kind.problem(), self.span(mistake.start, mistake.end), message);
        self.report(match mistake.help {
            Some(help) => diagnostic.help(help),
            None => diagnostic,
        });
    }

    /// The statements of a network.
    fn network_of(&mut self, block: &mut Block, network: &Network, drawing: Drawing, read: Read) {
        let mut mistakes = rules::mistakes(network, Flavour::S7, Some(drawing));
        if read == Read::InPart {
            mistakes.retain(|mistake| !matches!(mistake.kind, MistakeKind::Open | MistakeKind::Short | MistakeKind::Position));
        }
        mistakes.into_iter().for_each(|mistake| self.mistake(mistake, drawing, block));
        if network.content == Content::Empty && network.label.is_none() {
            return;
        }
        self.remembers(network, drawing, block);
        let written = write::write(network, 0, &mut self.generated_labels);
        let mut read = Operands::new();
        for (statement, pin) in written.statements.into_iter().zip(written.pins) {
            let statement = self.statement_of(&statement, &mut read);
            block.statements.push(statement);
            if let Some(network) = block.networks.last_mut() {
                network.pins.push(pin);
            }
        }
    }

    /// Warns where a second element uses a timer, a counter or an edge memory.
    fn remembers(&mut self, network: &Network, drawing: Drawing, block: &Block) {
        let number = block.networks.len().max(1);
        for (memory, operand, place) in memories(network) {
            let span = self.span(place.first as usize, place.last as usize);
            let name: String = operand.chars().filter(|sign| !sign.is_whitespace()).flat_map(char::to_uppercase).collect();
            let key = (memory, name);
            let Some(&(first, network)) = self.memories.get(&key) else {
                self.memories.insert(key, (span, number));
                continue;
            };
            let message = format!("{} network {number}: {}, first used in network {network}", drawing.word(), memory.used_twice(operand));
            let mut diagnostic = Diagnostic::new(Problem::P2443, span, message).help(memory.instead());
            diagnostic.related.push((first, "first used here".to_owned()));
            self.report(diagnostic);
        }
    }

    fn statement_of(&mut self, statement: &Statement, read: &mut Operands) -> ast::Statement {
        // Of a network that has only a label its statement stands where the label does.
        let labelled = statement
            .label
            .as_ref()
            .filter(|_| statement.place.last == 0)
            .and_then(|label| Some((label.start? as usize, label.text.len())));
        let span = match labelled {
            Some((start, length)) => self.span(start, start + length),
            None => self.span(statement.place.first as usize, statement.place.last as usize),
        };
        let label = statement.label.as_ref().map(|label| self.label_word(label, span));
        let mnemonic = Word { text: instruction_in(statement.mnemonic, self.mnemonics).to_owned(), span };
        let (operand, operand_span) = match statement.mnemonic {
            "CALL" => (self.call_of(statement, span, read), span),
            "JU" | "JC" | "JCN" | "JNB" => {
                let word = self.label_word(&statement.operand, span);
                let span = word.span;
                (Operand::Name { word, path: Vec::new() }, span)
            }
            _ => self.written_operand(&statement.operand, span, read),
        };
        ast::Statement { label, mnemonic, operand, operand_span, span }
    }

    /// A label that is written, or one of those that boxes need, which nothing that is written can name.
    fn label_word(&self, label: &Written, span: Span) -> Word {
        match label.start {
            Some(start) => Word { text: label.text.clone(), span: self.span(start as usize, start as usize + label.text.len()) },
            None => Word { text: label.text.replacen('_', "·", 1), span },
        }
    }

    /// An operand, read where it is written.
    fn written_operand(&mut self, operand: &Written, span: Span, read: &mut Operands) -> (Operand, Span) {
        let Some(start) = operand.start else { return (self.made_up(operand, span), span) };
        if let Some(known) = read.get(&start) {
            return known.clone();
        }
        let begin = start as usize;
        let (value, end, diagnostics) = self.try_at(begin, |parser| parser.operand(false));
        diagnostics.into_iter().for_each(|diagnostic| self.report(diagnostic));
        // A status bit may be written in brackets of form B; it is read like any other operand.
        let expected = end_of(&self.text[begin..], &operand.text) + begin;
        let value = if end < expected {
            let message =
                format!("`{}` does not belong to the operand `{}`", self.slice(end, expected).trim(), self.slice(begin, end).trim());
            self.error(Problem::P2402, end, expected, message);
            Operand::Error
        } else {
            value
        };
        let known = (value, self.span(begin, end));
        read.insert(start, known.clone());
        known
    }

    /// An operand that is written nowhere: a scratch bit, a status bit, a number.
    fn made_up(&self, operand: &Written, span: Span) -> Operand {
        let text = operand.text.as_str();
        if text.is_empty() {
            return Operand::None;
        }
        if let Some(bit) = write::scratch_number(text) {
            return Operand::Scratch { bit };
        }
        if let Ok(number) = text.parse::<i16>() {
            return Operand::Constant(Constant { value: Some(sieben_model::literal::Value::Int(number)), extended: false, span });
        }
        Operand::Name { word: Word { text: status_in(text, self.mnemonics).to_owned(), span }, path: Vec::new() }
    }

    fn call_of(&mut self, statement: &Statement, span: Span, read: &mut Operands) -> Operand {
        let (callee, callee_span) = self.written_operand(&statement.operand, span, read);
        let instance = statement.instance.as_ref().map(|instance| self.written_operand(instance, span, read));
        let arguments = statement
            .parameters
            .iter()
            .map(|parameter| {
                let name = &parameter.name;
                let start = name.start.map_or(span.start as usize, |start| start as usize);
                let text = super::unquoted(&name.text).to_owned();
                let name = Word { text, span: self.span(start, start + name.text.len()) };
                let (value, span) = self.written_operand(&parameter.actual, name.span, read);
                Argument { name, value, span }
            })
            .collect();
        Operand::Call(Box::new(Call { callee, callee_span, instance, arguments }))
    }
}

/// The text of a diagram that was parsed without mistakes, with the blanks before its first line, in the usual layout: one element on each line, four spaces for
/// each level.
pub(in crate::stl) fn layout(text: &str) -> String {
    if form_a::is_form_a(text, Flavour::S7) {
        return form_a::format(text, 0, text.len(), &form_a::parse(text, 0, text.len(), Flavour::S7));
    }
    form_a::written_lines(text).map(|line| format!("{}\n", line.trim())).collect()
}

/// Where an operand ends in the text that it was read from: it may have more spaces there.
fn end_of(text: &str, operand: &str) -> usize {
    let mut wanted = operand.chars().filter(|sign| !sign.is_whitespace()).peekable();
    let mut end = 0;
    for (at, sign) in text.char_indices() {
        if wanted.peek().is_none() {
            break;
        }
        if !sign.is_whitespace() {
            wanted.next();
            end = at + sign.len_utf8();
        }
    }
    end
}

/// The length of the first line, if that is a statement of STL: an instruction and a semicolon at the end, and no T-branch that holds one.
fn statement_of_stl(diagram: &str, mnemonics: Mnemonics) -> Option<usize> {
    let code = |line: &str| line[..form_a::comment_start(line).unwrap_or(line.len())].trim_end().len();
    let first = form_a::written_lines(diagram).map(|line| &line[..code(line)]).find(|line| !line.is_empty())?;
    let statement = first.split_once(": ").map_or(first, |(_, statement)| statement.trim_start());
    let word = statement.split(|sign: char| sign.is_whitespace() || sign == ';').next().unwrap_or_default();
    let is_statement = first.ends_with(';') && !first.contains('{') && Instruction::candidates(word, mnemonics).next().is_some();
    is_statement.then_some(first.len())
}

/// The networks of a diagram on one line, each with its first byte: every line is one, or all of them together are.
fn one_line_networks(text: &str, from: usize, to: usize, together: bool) -> Vec<(usize, String)> {
    let mut networks: Vec<(usize, String)> = Vec::new();
    let mut at = from;
    for line in form_a::written_lines(&text[from..to]) {
        let content = line[..form_a::comment_start(line).unwrap_or(line.len())].trim_end();
        let blank = content.len() - content.trim_start().len();
        match networks.last_mut() {
            // The lines keep their lengths, so that places stay right.
            Some((start, all)) if together => {
                let missing = (at - *start) - all.len();
                all.extend(std::iter::repeat_n(' ', missing));
                all.push_str(content);
            }
            _ if content.is_empty() => {}
            _ => networks.push((at + blank, content[blank..].to_owned())),
        }
        at += line.len();
    }
    networks
}
