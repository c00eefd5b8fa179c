//! From STL text to the lossless tree, the plain syntax and the diagnostics.
//!
//! One recursive descent builds the tree and the plain data together. It never gives up: what is
//! not understood becomes an `Unexpected` token and a diagnostic, and parsing goes on behind it.

pub(super) mod blocks;
mod declarations;
mod diagrams;
mod extension;
pub(super) mod header;
pub(super) mod operands;
mod paths;
mod printed;
mod slips;
mod statements;
mod step5;
mod types;

use std::cell::OnceCell;
use std::collections::{HashMap, HashSet};

use rowan::{Checkpoint, GreenNode, GreenNodeBuilder};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::literal;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};
use sieben_model::visible::visible;

use super::ast;
use super::lexer::{Raw, in_word, is_terminated, token};
use super::look_alikes::{self, OTHER_ALPHABET, latin};
use super::mnemonics::{Drawn, judge};
use super::syntax::{SyntaxKind, SyntaxNode};
use crate::declarations::values::shortened_s5time;
use crate::network::flavour::Drawing;
use crate::network::memories::Memory;
use crate::scan::{is_blank, straight_quote};

/// More diagnostics than this help nobody; one more says that there are others.
pub const DIAGNOSTICS_MAX: usize = 200;

/// Structures, arrays, value groups and brackets inside each other; STEP 7 allows 8 levels.
pub const NESTING_MAX: usize = 32;

/// What the parser understood of one source.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// The blocks.
    pub file: ast::File,
    /// The mnemonic language, as given or judged. Instruction words and address letters of `file` are in it.
    pub mnemonics: Mnemonics,
    /// What is wrong, in the order of places.
    pub diagnostics: Vec<Diagnostic>,
    /// The lossless tree.
    pub tree: GreenNode,
}

impl Parsed {
    /// The tree with parents and places.
    pub fn syntax(&self) -> SyntaxNode {
        SyntaxNode::new_root(self.tree.clone())
    }
}

/// Parses a source; without `mnemonics` its language is judged over the whole text.
pub fn parse(file: FileId, text: &str, mnemonics: Option<Mnemonics>) -> Parsed {
    parse_as(file, text, mnemonics, None)
}

/// Parses a source whose networks are drawn, unless they say something else.
pub fn parse_as(file: FileId, text: &str, mnemonics: Option<Mnemonics>, drawing: Option<Drawing>) -> Parsed {
    let mut ambiguous = None;
    let mnemonics = mnemonics.unwrap_or_else(|| {
        let judgement = judge(text, if drawing.is_some() { Drawn::Yes } else { Drawn::No });
        ambiguous = judgement.ambiguous.filter(|_| judgement.is_open());
        judgement.mnemonics()
    });
    let mut parser = Parser {
        text,
        file,
        mnemonics,
        position: 0,
        raw: Raw::End,
        end: 0,
        builder: GreenNodeBuilder::new(),
        forgets: false,
        diagnostics: Vec::new(),
        declared: HashSet::new(),
        foreign: Vec::new(),
        comments: Vec::new(),
        depth: 0,
        statement_over: false,
        trials: 0,
        block_start: 0,
        labels: None,
        jumps: None,
        names: OnceCell::new(),
        headed: None,
        drawing,
        generated_labels: 0,
        memories: HashMap::new(),
    };
    parser.advance(0);
    if let Some((start, end)) = ambiguous {
        let word = &text[start..end];
        parser.report(
            Diagnostic::new(
                Problem::P2003,
                parser.span(start, end),
                format!("`{word}` exists in both mnemonic languages, and no other word of the file tells which one it is"),
            )
            .help("it is read as an international mnemonic; say `--mnemonics de` if it is SIMATIC"),
        );
    }
    parser.builder.start_node(SyntaxKind::File.into());
    let file = parser.source();
    parser.builder.finish_node();
    let mut diagnostics = parser.diagnostics;
    diagnostics.sort_by_key(|diagnostic| (diagnostic.problem == Problem::P2199, diagnostic.span.start));
    Parsed { file, mnemonics, diagnostics, tree: parser.builder.finish() }
}

/// The text of a diagram in the usual layout.
pub(super) use diagrams::layout as diagram_layout;

/// Survives any bytes: parses, formats and converts them, and checks what must always hold.
pub fn fuzz(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let parsed = parse(FileId::default(), &text, None);
    assert!(parsed.syntax().text() == text.as_ref(), "the tree holds every byte of the source");
    if let Ok(once) = super::format::format(&text, None) {
        let twice = super::format::format(&once, None);
        assert_eq!(twice.as_deref(), Ok(once.as_str()), "formatting a formatted source changes nothing");
    }
    let _ = super::convert::convert(&text, None, parsed.mnemonics.other());
}

/// The same for a source whose networks are diagrams: in the usual layout they are the same statements.
pub fn fuzz_diagrams(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    for drawing in [Drawing::Lad, Drawing::Fbd] {
        let parsed = parse_as(FileId::default(), &text, None, Some(drawing));
        assert!(parsed.syntax().text() == text.as_ref(), "the tree holds every byte of the source");
        if let Ok(once) = super::format::format_as(&text, Some(parsed.mnemonics), Some(drawing)) {
            let twice = super::format::format_as(&once, Some(parsed.mnemonics), Some(drawing));
            assert_eq!(twice.as_deref(), Ok(once.as_str()), "formatting a formatted source changes nothing");
            let again = parse_as(FileId::default(), &once, Some(parsed.mnemonics), Some(drawing));
            assert_eq!(statements(&again, &once), statements(&parsed, &text), "the layout changes no statement:\n{text}\nbecomes\n{once}");
        }
        let _ = super::convert::convert_as(&text, None, parsed.mnemonics.other(), Some(drawing));
    }
}

/// The statements of a source as words, each with its operand as it is written.
fn statements(parsed: &Parsed, text: &str) -> Vec<(String, String)> {
    let written = |span: Span| text[span.start as usize..span.end as usize].split_whitespace().collect::<String>();
    let all = parsed.file.blocks.iter().flat_map(|block| &block.statements);
    all.map(|statement| (statement.mnemonic.text.clone(), written(statement.operand_span))).collect()
}

/// A word in the other mnemonic language and what it should be.
struct Foreign {
    start: usize,
    end: usize,
    replacement: String,
}

struct Parser<'t> {
    text: &'t str,
    file: FileId,
    mnemonics: Mnemonics,
    /// First byte of the current token.
    position: usize,
    raw: Raw,
    /// One behind the current token.
    end: usize,
    builder: GreenNodeBuilder<'static>,
    /// Something is read that is forgotten again: nothing of it goes into the tree.
    forgets: bool,
    diagnostics: Vec<Diagnostic>,
    /// Upper-case names that the current block declares.
    declared: HashSet<String>,
    /// Words of the other language in the current statement.
    foreign: Vec<Foreign>,
    /// Line comments since they were last taken.
    comments: Vec<(usize, usize)>,
    depth: usize,
    /// A parameter list without its end was reported; the next statement begins at the current token.
    statement_over: bool,
    /// Readings that are being tried, inside each other.
    trials: usize,
    /// First byte of the current block.
    block_start: usize,
    /// The labels of a block, once they were needed.
    labels: Option<slips::Labels>,
    /// The words behind the jumps of the source, once they were needed.
    jumps: Option<HashSet<String>>,
    /// How often each name stands in the source, once it was asked.
    names: OnceCell<HashMap<String, usize>>,
    /// The end that a block still needs which began with a heading.
    headed: Option<printed::Headed>,
    /// How networks are written that do not say it.
    drawing: Option<Drawing>,
    /// Labels that the boxes of diagrams needed in the current block.
    generated_labels: u32,
    /// The counters and edge memories of the diagrams of the current block: where each was used first, in which network.
    memories: HashMap<(Memory, String), (Span, usize)>,
}

impl<'t> Parser<'t> {
    fn span(&self, start: usize, end: usize) -> Span {
        Span::new(self.file, start as u32, end as u32)
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        if self.diagnostics.len() < DIAGNOSTICS_MAX {
            self.diagnostics.push(diagnostic);
        } else if self.diagnostics.len() == DIAGNOSTICS_MAX {
            let message = format!("this file has more than {DIAGNOSTICS_MAX} problems; the others are not shown");
            self.diagnostics.push(Diagnostic::new(Problem::P2199, diagnostic.span, message));
        }
    }

    fn error(&mut self, problem: Problem, start: usize, end: usize, message: impl Into<String>) {
        let span = self.span(start, end);
        self.report(Diagnostic::new(problem, span, message));
    }

    /// Makes the token at a byte the current one.
    fn advance(&mut self, position: usize) {
        self.position = position;
        (self.raw, self.end) = token(self.text, position);
    }

    fn current(&self) -> &'t str {
        &self.text[self.position..self.end]
    }

    fn slice(&self, start: usize, end: usize) -> &'t str {
        &self.text[start..end]
    }

    /// The current token, or a word for the end of a line or the source, for messages.
    fn shown(&self) -> String {
        match self.raw {
            Raw::End => "the end of the source".to_owned(),
            Raw::Newline => "the end of the line".to_owned(),
            _ => {
                let text = self.current();
                let short: String = text.chars().take(40).collect();
                format!("`{}`", visible(&short))
            }
        }
    }

    /// Puts the text up to `end` into the tree and goes on behind it.
    fn bump_to(&mut self, kind: SyntaxKind, end: usize) {
        if end > self.position && !self.forgets {
            self.builder.token(kind.into(), &self.text[self.position..end]);
        }
        self.advance(end);
    }

    /// Puts the current token into the tree and says where it stood.
    fn bump(&mut self, kind: SyntaxKind) -> (usize, usize) {
        let place = (self.position, self.end);
        if !is_terminated(self.raw, self.current()) {
            let (problem, message) = match self.raw {
                Raw::BlockComment => (Problem::P1004, "this comment has no `*)`, the rest of the source belongs to it"),
                Raw::Characters => (Problem::P1002, "these characters have no closing `'` on their line"),
                _ => (Problem::P1003, "this name has no closing `\"` on its line"),
            };
            let end = if self.raw == Raw::BlockComment { place.0 + 2 } else { place.1 };
            self.error(problem, place.0, end, message);
        }
        if matches!(self.raw, Raw::Characters | Raw::Symbol)
            && let Some(right) = look_alikes::straightened(self.current())
        {
            self.slip(Problem::P1005, place.0, place.1, &right, "has quotes of typesetting");
        }
        self.bump_to(kind, place.1);
        place
    }

    /// Puts the current token into the tree as something that does not belong there, without a message.
    fn bump_unexpected(&mut self) {
        let kind = match self.raw {
            Raw::Blank => SyntaxKind::Blank,
            Raw::Newline => SyntaxKind::Newline,
            Raw::LineComment => SyntaxKind::LineComment,
            Raw::BlockComment => SyntaxKind::BlockComment,
            Raw::Semicolon => SyntaxKind::Semicolon,
            _ => SyntaxKind::Unexpected,
        };
        self.bump(kind);
    }

    fn blanks(&mut self) {
        loop {
            match self.raw {
                Raw::Blank => self.bump_to(SyntaxKind::Blank, self.end),
                Raw::BlockComment => {
                    self.bump(SyntaxKind::BlockComment);
                }
                _ => return,
            }
        }
    }

    /// Blanks, comments and line ends.
    fn trivia(&mut self) {
        loop {
            self.blanks();
            match self.raw {
                Raw::Newline => self.bump_to(SyntaxKind::Newline, self.end),
                Raw::LineComment => {
                    self.comments.push((self.position, self.end));
                    self.bump_to(SyntaxKind::LineComment, self.end);
                }
                _ => return,
            }
        }
    }

    /// The first byte that is no blank, comment or line end.
    fn behind_trivia(&self, mut position: usize) -> usize {
        loop {
            match token(self.text, position) {
                (Raw::Blank | Raw::BlockComment | Raw::Newline | Raw::LineComment, end) => position = end,
                _ => return position,
            }
        }
    }

    /// The first byte that is no blank or block comment.
    fn behind_blanks(&self, mut position: usize) -> usize {
        loop {
            match token(self.text, position) {
                (Raw::Blank | Raw::BlockComment, end) => position = end,
                _ => return position,
            }
        }
    }

    fn raw_behind_blanks(&self) -> Raw {
        token(self.text, self.behind_blanks(self.end)).0
    }

    fn raw_behind_trivia(&self) -> Raw {
        token(self.text, self.behind_trivia(self.end)).0
    }

    /// The line comments since the last call, joined, without slashes.
    fn take_comments(&mut self) -> String {
        let comments = std::mem::take(&mut self.comments);
        let lines: Vec<&str> = comments.iter().map(|&(start, end)| comment_text(self.slice(start, end))).collect();
        lines.join("\n")
    }

    /// The current word is this one, without regard to case.
    fn at_word(&self, word: &str) -> bool {
        self.raw == Raw::Word && self.current().eq_ignore_ascii_case(word)
    }

    fn at_statement_end(&self) -> bool {
        matches!(self.raw, Raw::Semicolon | Raw::Newline | Raw::LineComment | Raw::End)
    }

    fn start(&mut self, kind: SyntaxKind) {
        if !self.forgets {
            self.builder.start_node(kind.into());
        }
    }

    fn start_at(&mut self, checkpoint: Checkpoint, kind: SyntaxKind) {
        if !self.forgets {
            self.builder.start_node_at(checkpoint, kind.into());
        }
    }

    fn finish(&mut self) {
        if !self.forgets {
            self.builder.finish_node();
        }
    }

    /// Goes one level deeper; `false` with a message if that is too deep.
    fn deeper(&mut self) -> bool {
        if self.depth >= NESTING_MAX {
            let message = format!("{} is nested more than {NESTING_MAX} levels deep", self.shown());
            self.error(Problem::P2022, self.position, self.end, message);
            return false;
        }
        self.depth += 1;
        true
    }

    /// Skips to the end of the statement; brackets do not matter.
    fn skip_statement(&mut self) {
        while !self.at_statement_end() {
            self.bump_unexpected();
        }
    }

    /// Takes a `;` if there is one; something else before the end of the line is reported and skipped.
    fn statement_end(&mut self) {
        self.blanks();
        if !self.at_statement_end() {
            let (start, shown) = (self.position, self.shown());
            let (problem, message) = match self.raw {
                Raw::Unknown => (Problem::P1001, format!("{shown} is no character of STL")),
                _ => (Problem::P2004, format!("{shown} does not belong here: the statement ends before it")),
            };
            let end = self.end;
            // `Q 0,1` and `2,5`: the comma of the languages in which most of these programs were commented.
            let decimal = self.raw == Raw::Comma
                && self.text[..start].ends_with(|before: char| before.is_ascii_digit())
                && self.text[end..].starts_with(|behind: char| behind.is_ascii_digit());
            self.skip_statement();
            if decimal {
                let span = self.span(start, end);
                let message = "a comma where STL writes a point: did you mean `.`?";
                self.report(Diagnostic::new(problem, span, message).fix(span, ".", "write `.`"));
            } else {
                self.error(problem, start, end, message);
            }
        }
        if self.raw == Raw::Semicolon {
            self.bump(SyntaxKind::Semicolon);
        }
    }

    /// Reads the text between two bytes as a constant.
    fn constant_of(&mut self, start: usize, end: usize) -> ast::Constant {
        let span = self.span(start, end);
        // Its quotes were reported as it was taken.
        let straight = look_alikes::straightened(self.slice(start, end));
        let text = straight.as_deref().unwrap_or(self.slice(start, end));
        let (value, extended) = match literal::parse(text) {
            Ok(value) => {
                if let literal::Value::S5Time(_) = value
                    && let Some(message) = literal::written_milliseconds(text).and_then(|time| shortened_s5time(text, time))
                {
                    self.report(Diagnostic::new(Problem::P5029, span, message));
                }
                (Some(value), false)
            }
            Err(error) => match (literal::parse_extended(text), look_alikes::meant_constant(text)) {
                (Some(value), _) => (Some(value), true),
                (None, Some((right, why))) => {
                    self.slip(Problem::P1005, start, end, &right, why);
                    (literal::parse(&right).ok(), false)
                }
                (None, None) => {
                    self.report(Diagnostic::new(error.problem(), span, error.to_string()));
                    (None, false)
                }
            },
        };
        ast::Constant { value, extended, span }
    }

    /// Whether a constant begins here: a number, a sign with a number, a notation with `#`, characters, TRUE or FALSE.
    fn at_constant(&self) -> bool {
        match self.raw {
            Raw::Number | Raw::Literal | Raw::Characters => true,
            Raw::Word => self.at_word("TRUE") || self.at_word("FALSE") || self.at_underscored_time(),
            Raw::Sign => matches!(self.current(), "+" | "-") && self.raw_behind_blanks() == Raw::Number,
            Raw::Unknown => self.typeset_sign() == Some("-") && self.raw_behind_blanks() == Raw::Number,
            _ => false,
        }
    }

    /// `T#_1S`, which a lexer takes for `T` and a local name: an instruction has no such operand without a space.
    fn at_underscored_time(&self) -> bool {
        let is_time = |end: usize| literal::parse_extended(self.slice(self.position, end)).is_some();
        self.at_word("T")
            && matches!(token(self.text, self.end), (Raw::Local, end) if self.text[self.end..].starts_with("#_") && is_time(end))
    }

    /// The signs that the current character of typesetting stands for.
    fn typeset_sign(&self) -> Option<&'static str> {
        match self.raw {
            Raw::Unknown => self.current().chars().next().and_then(look_alikes::typeset_sign),
            _ => None,
        }
    }

    /// Where the number at the current token ends if its letters O and l are read as digits.
    fn number_with_letters(&self) -> Option<usize> {
        let rest = &self.text[self.end..];
        if self.raw != Raw::Number || !rest.starts_with(['O', 'o', 'l']) {
            return None;
        }
        let run = rest.find(|c: char| !(c.is_ascii_digit() || matches!(c, 'O' | 'o' | 'l' | '_' | '.'))).unwrap_or(rest.len());
        let end = self.end + run;
        let over = matches!(
            token(self.text, self.behind_blanks(end)).0,
            Raw::Semicolon | Raw::Newline | Raw::LineComment | Raw::End | Raw::Comma | Raw::ParenClose | Raw::BracketClose
        );
        (over && look_alikes::meant_constant(self.slice(self.position, end)).is_some()).then_some(end)
    }

    fn constant(&mut self) -> ast::Constant {
        let start = self.position;
        if self.at_underscored_time() {
            let end = token(self.text, self.end).1;
            self.bump_to(SyntaxKind::Constant, end);
            return self.constant_of(start, end);
        }
        if self.raw == Raw::Sign {
            self.bump(SyntaxKind::Constant);
            self.blanks();
        } else if self.raw == Raw::Unknown {
            let (sign, sign_end) = self.bump(SyntaxKind::Constant);
            self.slip(Problem::P1005, sign, sign_end, "-", "is a dash of typesetting");
            self.blanks();
            let (_, end) = self.bump(SyntaxKind::Constant);
            let value = literal::parse(&format!("-{}", self.slice(sign_end, end).trim_start())).ok();
            return ast::Constant { value, extended: false, span: self.span(start, end) };
        }
        if let Some(end) = self.number_with_letters() {
            self.bump_to(SyntaxKind::Constant, end);
            return self.constant_of(start, end);
        }
        let terminated = is_terminated(self.raw, self.current());
        // `B# (1, 10)`.
        if self.raw == Raw::Literal
            && let Some((letters, list)) = self.current().split_once('#')
            && list.starts_with(is_blank)
            && list.trim_start().starts_with('(')
        {
            let right = format!("{letters}#{}", list.trim_start());
            self.slip(Problem::P2008, self.position, self.end, &right, "has a space inside");
        }
        let comma = self.decimal_comma();
        let (_, mut end) = self.bump(SyntaxKind::Constant);
        if let Some((behind, right)) = comma {
            self.slip(Problem::P2004, end, end + 1, ".", "stands where STL writes a decimal point");
            self.bump_to(SyntaxKind::Constant, behind);
            end = behind;
            return ast::Constant { value: literal::parse(&right).ok(), extended: false, span: self.span(start, end) };
        }
        match terminated {
            true => self.constant_of(start, end),
            false => ast::Constant { value: None, extended: false, span: self.span(start, end) },
        }
    }

    /// `P#25,3`: where the pointer ends whose point is a comma, and what it should be.
    fn decimal_comma(&self) -> Option<(usize, String)> {
        let written = self.current();
        if self.raw != Raw::Literal || !written.starts_with(['P', 'p']) || written.contains('.') {
            return None;
        }
        let bit = self.text[self.end..].strip_prefix(',')?.chars().next().filter(|bit| matches!(bit, '0'..='7'))?;
        let end = self.end + 2;
        let right = format!("{written}.{bit}");
        (!self.text[end..].starts_with(in_word) && literal::parse(&right).is_ok()).then_some((end, right))
    }

    /// A whole number with a sign, for bounds and indices.
    fn integer(&mut self) -> Option<i64> {
        let negative = self.raw == Raw::Sign && self.current() == "-";
        if self.raw == Raw::Sign && matches!(self.current(), "+" | "-") && self.raw_behind_blanks() == Raw::Number {
            self.bump(SyntaxKind::Number);
            self.blanks();
        }
        if self.raw != Raw::Number || !self.current().bytes().all(|byte| byte.is_ascii_digit()) {
            return None;
        }
        let value = self.current().parse::<i64>().unwrap_or(i64::MAX);
        self.bump(SyntaxKind::Number);
        Some(if negative { -value } else { value })
    }

    /// The text of a name without quotes and `#`.
    fn name_text(&self) -> &'t str {
        unquoted(self.current())
    }

    fn name_word(&mut self, kind: SyntaxKind) -> ast::Word {
        let text = self.name_text().to_owned();
        let (start, end) = self.bump(kind);
        ast::Word { text, span: self.span(start, end) }
    }

    /// `:=`; a slip for it (`=:`, `=>`, `:=>`, `=`) is reported and taken.
    fn becomes(&mut self) -> bool {
        let rest = &self.text[self.position..];
        let slip = match self.raw {
            Raw::Becomes if rest.starts_with(":=>") => 3,
            Raw::Becomes => {
                self.bump(SyntaxKind::Punctuation);
                return true;
            }
            _ if rest.starts_with("=:") || rest.starts_with("=>") => 2,
            _ => return false,
        };
        let (start, end) = (self.position, self.position + slip);
        let span = self.span(start, end);
        let message = format!("`{}` is no assignment sign; an assignment is written `:=`", self.slice(start, end));
        self.report(Diagnostic::new(Problem::P2007, span, message).fix(span, ":=", "write `:=`"));
        self.bump_to(SyntaxKind::Punctuation, end);
        true
    }

    fn slip(&mut self, problem: Problem, start: usize, end: usize, right: &str, why: &str) {
        let span = self.span(start, end);
        let message = format!("`{}` {why}: did you mean `{right}`?", self.slice(start, end));
        self.report(Diagnostic::new(problem, span, message).fix(span, right, format!("write `{right}`")));
    }

    /// Remembers a word of the other language until the statement is over.
    fn foreign(&mut self, start: usize, end: usize, replacement: &str) {
        let replacement = super::convert::in_case_of(self.slice(start, end), replacement);
        self.foreign.push(Foreign { start, end, replacement });
    }

    /// Reports the words of the other language since `statement` as one problem with one fix.
    fn report_foreign(&mut self) {
        let words = std::mem::take(&mut self.foreign);
        let (Some(first), Some(last)) = (words.first(), words.last()) else { return };
        let span = self.span(first.start, last.end);
        let mut right = String::new();
        let mut at = first.start;
        for word in &words {
            right.push_str(self.slice(at, word.start));
            right.push_str(&word.replacement);
            at = word.end;
        }
        let (other, this) = match self.mnemonics {
            Mnemonics::English => ("SIMATIC (German)", "international"),
            Mnemonics::German => ("international (English)", "SIMATIC (German)"),
        };
        let written = self.slice(first.start, last.end);
        let message = format!("`{written}` is written with {other} mnemonics, the file with {this} ones: here it is `{right}`");
        self.report(Diagnostic::new(Problem::P2002, span, message).fix(span, right.clone(), format!("write `{right}`")));
    }
}

/// A line comment without its slashes.
fn comment_text(comment: &str) -> &str {
    let text = comment.strip_prefix("//").unwrap_or(comment);
    text.strip_prefix(' ').unwrap_or(text)
}

/// A name without quotes and `#`.
fn unquoted(text: &str) -> &str {
    let text = text.strip_prefix('#').unwrap_or(text);
    if text.starts_with(|first| first == '"' || straight_quote(first).is_some()) && look_alikes::straightened(text).is_some() {
        let quote = |c: char| c == '"' || straight_quote(c) == Some('"');
        return text.strip_prefix(quote).map_or(text, |inner| inner.strip_suffix(quote).unwrap_or(inner));
    }
    match text.strip_prefix('"') {
        Some(inner) => inner.strip_suffix('"').unwrap_or(inner),
        None => text,
    }
}
