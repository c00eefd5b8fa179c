//! From ST text to the plain syntax, the lossless tree and the diagnostics.
//!
//! One recursive descent makes the plain data, and writes down which tokens belong to which node, so that the tree can be built
//! when somebody asks for it. It never gives up: what is not understood becomes an `Unexpected` token and a diagnostic, and
//! parsing goes on behind it. At one token there is at most one message.

mod addresses;
mod blocks;
mod configuration;
mod declarations;
mod diagrams;
mod expressions;
mod header;
mod in_one_word;
mod lost;
mod members;
mod other_languages;
mod pragmas;
mod statements;
mod testing;
#[cfg(test)]
mod tests;

mod types;

use std::collections::HashSet;
use std::ops::Range;

pub(in crate::st) use declarations::name_is_lost;
pub(in crate::st) use diagrams::fragment;

use rowan::{GreenNode, GreenNodeBuilder};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};

use super::ast;
use super::diagrams::EdgeMemory;
use super::dialect::{Construct, Dialect, Judgement};
use super::keywords::Keyword;
use super::lexer::{Raw, Token, is_terminated, quotes_names, straightened, tokens, typeset_sign};
use super::syntax::{SyntaxKind, SyntaxNode};
use crate::scan::straight_quote;

/// More diagnostics than this help nobody; one more says that there are others.
pub const DIAGNOSTICS_MAX: usize = 200;

/// Statements, blocks, types and brackets inside each other, so that whoever walks the syntax may recurse.
pub const NESTING_MAX: usize = 100;

/// The height of an expression: brackets, and operators one behind the other. Chains of one logical operator do not count, they
/// are balanced.
pub const EXPRESSION_HEIGHT_MAX: u32 = 250;

/// What the parser understood of one source.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// What the source declares.
    pub file: ast::File,
    /// What is wrong, in the order of places.
    pub diagnostics: Vec<Diagnostic>,
    tokens: Vec<Token>,
    events: Vec<Event>,
    /// Nodes that began before it was known what they are: the event that they begin before.
    wraps: Vec<(u32, SyntaxKind)>,
}

/// A step in building the tree.
#[derive(Clone, Copy, Debug)]
enum Event {
    Start(SyntaxKind),
    Token(SyntaxKind),
    Finish,
}

impl Parsed {
    /// The tokens of the source in order.
    pub(in crate::st) fn tokens(&self) -> &[Token] {
        &self.tokens
    }

    /// The lossless tree; `text` is the one that was parsed.
    pub fn tree(&self, text: &str) -> GreenNode {
        let mut builder = GreenNodeBuilder::new();
        let mut wraps: Vec<(u32, SyntaxKind)> = self.wraps.iter().rev().copied().collect();
        // Of two nodes that begin at one place the one that was made later is the outer one.
        wraps.sort_by_key(|&(event, _)| event);
        let mut wraps = wraps.into_iter().peekable();
        let mut tokens = self.tokens.iter();
        builder.start_node(SyntaxKind::File.into());
        for (index, event) in self.events.iter().enumerate() {
            while let Some((_, kind)) = wraps.next_if(|&(event, _)| event as usize == index) {
                builder.start_node(kind.into());
            }
            match event {
                Event::Start(kind) => builder.start_node((*kind).into()),
                Event::Finish => builder.finish_node(),
                Event::Token(kind) => {
                    let token = tokens.next().expect("an event for each token");
                    let slice = text.get(token.start as usize..token.end as usize).unwrap_or_default();
                    builder.token((*kind).into(), slice);
                }
            }
        }
        builder.finish_node();
        builder.finish()
    }

    /// The tree with parents and places; `text` is the one that was parsed.
    pub fn syntax(&self, text: &str) -> SyntaxNode {
        SyntaxNode::new_root(self.tree(text))
    }
}

/// Parses a source in a dialect.
pub fn parse(file: FileId, text: &str, dialect: Dialect) -> Parsed {
    let mut tokens = tokens(text, dialect);
    let mut diagnostics = Vec::new();
    pragmas::switch_off(text, &mut tokens);
    if dialect.is_test() {
        testing::keywords(text, &mut tokens);
    }
    ends_without_underline(file, text, &mut tokens, dialect, &mut diagnostics);
    else_if_in_one_word(file, text, &mut tokens, &mut diagnostics);
    in_one_word::read(file, text, &mut tokens, &mut diagnostics);
    typeset(file, text, &tokens, &mut diagnostics);
    let mut parser = Parser::new(file, text, dialect, tokens);
    parser.diagnostics = diagnostics;
    parser.skip_trivia();
    let mut items = parser.items(None);
    parser.flush();
    if dialect.is_test() {
        parser.test_file(&mut items);
    }
    let mut diagnostics = parser.diagnostics;
    diagnostics.sort_by_key(|diagnostic| (diagnostic.problem == Problem::P2199, diagnostic.span.start));
    Parsed { file: ast::File { items }, diagnostics, tokens: parser.tokens, events: parser.events, wraps: parser.wraps }
}

/// Reads `ENDIF;` as `END_IF;`, with a message, where no name could stand alone.
fn ends_without_underline(file: FileId, text: &str, tokens: &mut [Token], dialect: Dialect, diagnostics: &mut Vec<Diagnostic>) {
    let mut before = None;
    for index in 0..tokens.len() {
        let token = tokens[index];
        if token.raw.is_trivia() {
            continue;
        }
        let begins = before.is_some_and(|before: Token| before.raw == Raw::Semicolon || before.keyword.is_some());
        before = Some(token);
        let word = &text[token.start as usize..token.end as usize];
        let alone = || tokens[index + 1..].iter().find(|next| !next.raw.is_trivia()).is_some_and(|next| next.raw == Raw::Semicolon);
        if !begins || token.raw != Raw::Word || token.keyword.is_some() || word.len() > 9 || !alone() {
            continue;
        }
        let right = match word.split_at_checked(3) {
            Some((end, rest)) if end.eq_ignore_ascii_case("END") => format!("END_{}", rest.to_ascii_uppercase()),
            _ => continue,
        };
        let Some(keyword) = Keyword::of(&right, dialect).filter(|keyword| keyword.ends_statement()) else { continue };
        tokens[index].keyword = Some(keyword);
        let span = Span::new(file, token.start, token.end);
        let message = format!("`{word}` ends nothing: did you mean `{right}`?");
        diagnostics.push(Diagnostic::new(Problem::P6058, span, message).fix(span, &right, format!("write `{right}`")));
    }
}

/// Reads `ELSEIF x THEN` and `ELIF x THEN` as ELSIF, with a message.
fn else_if_in_one_word(file: FileId, text: &str, tokens: &mut [Token], diagnostics: &mut Vec<Diagnostic>) {
    for index in 0..tokens.len() {
        let token = tokens[index];
        let word = &text[token.start as usize..token.end as usize];
        let other = ["ELSEIF", "ELIF", "ELSE_IF"].iter().any(|other| word.eq_ignore_ascii_case(other));
        if token.raw != Raw::Word || !other {
            continue;
        }
        let mut behind = tokens[index + 1..].iter().take_while(|next| !matches!(next.raw, Raw::Semicolon | Raw::Becomes | Raw::Colon));
        if !behind.any(|next| next.keyword == Some(Keyword::Then)) {
            continue;
        }
        tokens[index].keyword = Some(Keyword::Elsif);
        let span = Span::new(file, token.start, token.end);
        let message = format!("`{word}` is no word of ST: did you mean `ELSIF`?");
        diagnostics.push(Diagnostic::new(Problem::P6061, span, message).fix(span, "ELSIF", "write `ELSIF`"));
    }
}

/// The reserved words of all dialects.
pub fn words() -> impl Iterator<Item = &'static str> {
    Keyword::words()
}

/// Survives any bytes: parses them in every dialect, formats them twice, and checks what must always hold.
pub fn fuzz(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    for dialect in Dialect::ALL.into_iter().chain(Dialect::ALL.map(Dialect::for_tests)) {
        let parsed = parse(FileId::default(), &text, dialect);
        assert!(parsed.syntax(&text).text() == text.as_ref(), "the tree holds every byte of the source");
        for diagnostic in &parsed.diagnostics {
            let places = [Some(diagnostic.span), diagnostic.fix.as_ref().map(|fix| fix.span)];
            for span in places.into_iter().flatten() {
                assert!(text.get(span.start as usize..span.end as usize).is_some(), "a place lies in the text: {diagnostic:?}");
            }
        }
        let Ok(once) = super::format::format(&text, dialect) else { continue };
        assert_eq!(significant(&once, dialect), significant(&text, dialect), "formatting changes blanks and line ends only");
        let twice = super::format::format(&once, dialect);
        assert_eq!(twice.as_deref(), Ok(once.as_str()), "formatting a formatted source changes nothing");
    }
}

/// The texts of all tokens but blanks and line ends; those of diagrams without any blanks.
fn significant(text: &str, dialect: Dialect) -> Vec<String> {
    let tokens = tokens(text, dialect).into_iter().filter(|token| !matches!(token.raw, Raw::Blank | Raw::Newline));
    let shown = |token: Token| match (token.raw, &text[token.start as usize..token.end as usize]) {
        (Raw::Diagram, networks) => networks.split_whitespace().collect(),
        (_, other) => other.trim_end().to_owned(),
    };
    tokens.map(shown).collect()
}

struct Parser<'t> {
    text: &'t str,
    file: FileId,
    dialect: Dialect,
    tokens: Vec<Token>,
    /// The current token, which is no trivia.
    at: usize,
    /// The first token that has no event yet.
    emitted: usize,
    /// One behind the last token that was taken.
    previous: u32,
    events: Vec<Event>,
    wraps: Vec<(u32, SyntaxKind)>,
    diagnostics: Vec<Diagnostic>,
    /// The token at which the last error was reported.
    reported: usize,
    /// Constructs that a note was given for: one note for each in a file.
    noted: HashSet<u32>,
    /// Upper-case names that the current block declares.
    declared: HashSet<String>,
    /// Fields of a data block stand here, such as `m`, and no addresses, such as `M[1, 2]`.
    only_names: bool,
    /// Upper-case names of its LABEL sections.
    labels: HashSet<String>,
    /// Pragmas that were passed and belong to nothing yet, by token.
    pragmas: Vec<usize>,
    /// The end keywords that enclosing statements wait for.
    awaited: Vec<Keyword>,
    /// Places of `ELSE IF` on one line.
    else_ifs: Vec<(u32, u32)>,
    /// Where the end of a member was looked for, and that of which one comes next.
    member_end: Option<(Range<usize>, Option<Keyword>)>,
    /// Keywords that were refused as names: what uses them says nothing new.
    refused: Vec<Keyword>,
    /// The block whose instance remembers what the edges of diagrams need.
    owner: Option<String>,
    /// What the diagrams of the current block need.
    edges: Vec<EdgeMemory>,
    depth: usize,
    /// An expression of the current statement was too high.
    too_high: bool,
}

/// A place in the events where a node may begin later.
#[derive(Clone, Copy)]
struct Checkpoint(u32);

impl<'t> Parser<'t> {
    fn new(file: FileId, text: &'t str, dialect: Dialect, tokens: Vec<Token>) -> Self {
        Parser {
            text,
            file,
            dialect,
            at: 0,
            emitted: 0,
            previous: 0,
            events: Vec::with_capacity(tokens.len() * 2),
            tokens,
            wraps: Vec::new(),
            diagnostics: Vec::new(),
            reported: usize::MAX,
            noted: HashSet::new(),
            declared: HashSet::new(),
            only_names: false,
            labels: HashSet::new(),
            pragmas: Vec::new(),
            awaited: Vec::new(),
            else_ifs: Vec::new(),
            member_end: None,
            refused: Vec::new(),
            owner: None,
            edges: Vec::new(),
            depth: 0,
            too_high: false,
        }
    }

    // The current token.

    fn token(&self) -> Token {
        self.tokens[self.at]
    }
    fn raw(&self) -> Raw {
        self.tokens[self.at].raw
    }
    fn keyword(&self) -> Option<Keyword> {
        self.tokens[self.at].keyword
    }
    fn at_keyword(&self, keyword: Keyword) -> bool {
        self.keyword() == Some(keyword)
    }
    fn current(&self) -> &'t str {
        self.slice(self.token())
    }
    fn slice(&self, token: Token) -> &'t str {
        &self.text[token.start as usize..token.end as usize]
    }
    /// The current token is a word, whether reserved or not, without regard to case.
    fn at_word(&self, word: &str) -> bool {
        self.raw() == Raw::Word && self.current().eq_ignore_ascii_case(word)
    }
    /// The current token is a name that somebody could have declared.
    fn at_name(&self) -> bool {
        self.is_name(self.at)
    }
    fn is_name(&self, index: usize) -> bool {
        let token = self.tokens[index];
        match token.raw {
            Raw::Word => token.keyword.is_none(),
            Raw::Local | Raw::Backquoted => true,
            Raw::Quoted => quotes_names(self.dialect),
            _ => false,
        }
    }
    /// The index of the token behind this one that is no trivia; the end of the source is behind itself.
    fn behind(&self, index: usize) -> usize {
        let mut index = index + 1;
        while self.tokens.get(index).is_some_and(|token| token.raw.is_trivia()) {
            index += 1;
        }
        index.min(self.tokens.len() - 1)
    }
    fn next_raw(&self) -> Raw {
        self.tokens[self.behind(self.at)].raw
    }
    fn next_keyword(&self) -> Option<Keyword> {
        self.tokens[self.behind(self.at)].keyword
    }
    /// The token behind the current one stands directly behind it and looks like this.
    fn joined_with(&self, raw: Raw) -> bool {
        self.tokens.get(self.at + 1).is_some_and(|token| token.raw == raw)
    }
    /// Whether the current token begins a line of its own.
    fn on_new_line(&self) -> bool {
        self.text[self.previous as usize..self.token().start as usize].contains(['\n', '\r'])
    }
    /// The current token, or a word for the end of the source, for messages.
    fn shown(&self) -> String {
        match self.raw() {
            Raw::End => "the end of the source".to_owned(),
            _ => {
                let short: String = self.current().chars().take(40).collect();
                format!("`{}`", short.escape_debug().to_string().replace("\\'", "'").replace("\\\"", "\""))
            }
        }
    }

    // Going on.

    fn skip_trivia(&mut self) {
        loop {
            let token = self.tokens[self.at];
            match token.raw {
                Raw::Pragma => self.pragmas.push(self.at),
                Raw::BlockComment if self.slice(token).starts_with('/') => {
                    self.judge(Construct::SlashComment, token.start, token.end);
                }
                raw if raw.is_trivia() => {}
                _ => return,
            }
            if !is_terminated(token.raw, self.slice(token)) {
                let (problem, message, end) = match token.raw {
                    Raw::BlockComment => (Problem::P1004, "this comment has no end, the rest of the source belongs to it", token.start + 2),
                    _ => (Problem::P6066, "this pragma has no `}`", token.end),
                };
                self.error(problem, token.start, end, message);
            }
            self.at += 1;
        }
    }

    /// Writes down the trivia before the current token.
    fn flush(&mut self) {
        while self.emitted < self.at {
            let kind = match self.tokens[self.emitted].raw {
                Raw::Blank => SyntaxKind::Blank,
                Raw::Newline => SyntaxKind::Newline,
                Raw::LineComment => SyntaxKind::LineComment,
                Raw::BlockComment => SyntaxKind::BlockComment,
                Raw::Pragma => SyntaxKind::Pragma,
                _ => SyntaxKind::Inactive,
            };
            self.events.push(Event::Token(kind));
            self.emitted += 1;
        }
    }

    /// Takes the current token and says where it stood.
    fn bump(&mut self, kind: SyntaxKind) -> Span {
        let token = self.token();
        if token.raw == Raw::End {
            return self.span(token.start, token.end);
        }
        self.flush();
        self.events.push(Event::Token(kind));
        self.emitted = self.at + 1;
        if !is_terminated(token.raw, self.slice(token)) {
            let (problem, message) = match token.raw {
                Raw::Characters | Raw::Literal => (Problem::P1002, "these characters have no closing `'` on their line"),
                _ => (Problem::P1003, "this name has no closing quote on its line"),
            };
            self.error(problem, token.start, token.end, message);
        }
        let terminated = is_terminated(token.raw, self.slice(token));
        self.previous = token.end;
        self.at += 1;
        self.skip_trivia();
        if !terminated {
            // It has swallowed what is missing next.
            self.reported = self.at;
        }
        self.span(token.start, token.end)
    }

    /// Takes a token as free text, whatever it looks like.
    fn bump_text(&mut self) {
        self.flush();
        self.events.push(Event::Token(SyntaxKind::HeaderText));
        self.emitted = self.at + 1;
        self.previous = self.token().end;
        self.at += 1;
        self.skip_trivia();
    }

    fn bump_unexpected(&mut self) -> Span {
        let kind = if self.raw() == Raw::Semicolon { SyntaxKind::Semicolon } else { SyntaxKind::Unexpected };
        self.bump(kind)
    }

    fn start(&mut self, kind: SyntaxKind) {
        self.flush();
        self.events.push(Event::Start(kind));
    }
    fn finish(&mut self) {
        self.events.push(Event::Finish);
    }
    fn checkpoint(&mut self) -> Checkpoint {
        self.flush();
        Checkpoint(self.events.len() as u32)
    }
    fn start_at(&mut self, checkpoint: Checkpoint, kind: SyntaxKind) {
        self.wraps.push((checkpoint.0, kind));
    }

    // Places.

    fn span(&self, start: u32, end: u32) -> Span {
        Span::new(self.file, start, end.max(start))
    }
    /// From a byte to the end of the last token that was taken.
    fn since(&self, start: u32) -> Span {
        self.span(start, self.previous.max(start))
    }
    /// The last character that was taken: it shows a place better than an empty span.
    fn last_character(&self) -> Span {
        let before = &self.text[..self.previous as usize];
        let start = before.char_indices().next_back().map_or(0, |(at, _)| at as u32);
        self.span(start, self.previous)
    }
    fn here(&self) -> u32 {
        self.token().start
    }

    // Messages.

    fn push(&mut self, diagnostic: Diagnostic) {
        if self.diagnostics.len() < DIAGNOSTICS_MAX {
            self.diagnostics.push(diagnostic);
        } else if self.diagnostics.len() == DIAGNOSTICS_MAX {
            let message = format!("this file has more than {DIAGNOSTICS_MAX} problems; the others are not shown");
            self.diagnostics.push(Diagnostic::new(Problem::P2199, diagnostic.span, message));
        }
    }

    /// Reports an error, unless there was one at the current token already: what follows from it tells nothing new.
    fn report(&mut self, diagnostic: Diagnostic) {
        if self.reported != self.at {
            self.reported = self.at;
            self.push(diagnostic);
        }
    }

    /// Reports an error about a token or text that has been understood, which leads to no others.
    fn error(&mut self, problem: Problem, start: u32, end: u32, message: impl Into<String>) {
        let span = self.span(start, end);
        self.push(Diagnostic::new(problem, span, message));
    }

    /// An error about the current token.
    fn unexpected(&mut self, problem: Problem, message: impl Into<String>) {
        let token = self.token();
        let span = match token.raw {
            Raw::End => self.span(self.previous, self.previous),
            _ => self.span(token.start, token.end),
        };
        let (problem, message) = match token.raw {
            Raw::Unknown => (Problem::P1001, format!("{} is no character of ST", self.shown())),
            _ => (problem, message.into()),
        };
        self.report(Diagnostic::new(problem, span, message));
    }

    /// Something is missing behind the last token; `text` would mend it.
    fn missing(&mut self, problem: Problem, text: &str, message: impl Into<String>) {
        let at = self.span(self.previous, self.previous);
        self.report(Diagnostic::new(problem, self.last_character(), message).fix(at, text, format!("write `{}`", text.trim())));
    }

    /// What the dialect says to a construct: nothing, a note, or an error.
    fn judge(&mut self, construct: Construct, start: u32, end: u32) {
        let row = construct.row();
        let title = self.dialect.title();
        let (problem, message) = match self.dialect.judge(construct) {
            Judgement::Accept => return,
            Judgement::Note if !self.noted.insert(construct as u32) => return,
            Judgement::Note => (Problem::P6051, format!("{} is not usual in {title}", row.title)),
            Judgement::Reject => (Problem::P6050, format!("{title} does not have {}", row.title)),
        };
        let help = match problem {
            Problem::P6051 => format!("{}; the other places of this file are not listed", row.instead),
            _ => format!("{}, or name the dialect of the file with `--dialect`", row.instead),
        };
        let span = self.span(start, end);
        self.push(Diagnostic::new(problem, span, message).help(help));
    }

    /// `right` in the place of a slip of the pen.
    fn slip(&mut self, problem: Problem, span: Span, right: &str, message: impl Into<String>) {
        self.push(Diagnostic::new(problem, span, message).fix(span, right, format!("write `{right}`")));
    }

    // Small parts.

    /// Takes a token if it is there.
    fn eat(&mut self, raw: Raw, kind: SyntaxKind) -> bool {
        let there = self.raw() == raw;
        if there {
            self.bump(kind);
        }
        there
    }
    fn eat_keyword(&mut self, keyword: Keyword) -> bool {
        let there = self.at_keyword(keyword);
        if there {
            self.bump(SyntaxKind::Keyword);
        }
        there
    }
    fn eat_word(&mut self, word: &str) -> bool {
        let there = self.at_word(word);
        if there {
            self.bump(SyntaxKind::Keyword);
        }
        there
    }

    /// Takes a keyword, or says that it is missing.
    fn expect_keyword(&mut self, keyword: Keyword, behind: &str) {
        if !self.eat_keyword(keyword) {
            let word = keyword.word();
            self.missing(Problem::P6056, &format!(" {word}"), format!("`{word}` is missing behind {behind}"));
        }
    }

    /// A name without quotes; the current token is one.
    fn name(&mut self, kind: SyntaxKind) -> ast::Name {
        let token = self.token();
        let straight = straightened(self.slice(token));
        let text = straight.as_ref();
        let (text, quoting) = match token.raw {
            Raw::Quoted => (unquoted(text, '"'), ast::Quoting::Global),
            Raw::Backquoted => (unquoted(text, '`'), ast::Quoting::Backquoted),
            Raw::Local => (unquoted(&text[1..], '"'), ast::Quoting::Local),
            _ => (text, ast::Quoting::Bare),
        };
        let construct = match token.raw {
            Raw::Quoted => Some(Construct::QuotedName),
            Raw::Local => Some(Construct::LocalMark),
            Raw::Word if text.starts_with("__") => Some(Construct::SystemName),
            Raw::Word if text.contains("__") => Some(Construct::DoubleUnderscore),
            Raw::Word if !text.is_ascii() => Some(Construct::ForeignLetter),
            _ if kind == SyntaxKind::Declared && text.chars().count() > 24 => Some(Construct::LongName),
            _ => None,
        };
        // Names that begin with `__` are functions of the system; only who declares one is told.
        let construct = construct.filter(|&construct| construct != Construct::SystemName || kind == SyntaxKind::Declared);
        if let Some(construct) = construct {
            self.judge(construct, token.start, token.end);
        }
        let text = text.to_owned();
        let span = self.bump(kind);
        ast::Name { text, quoting, span }
    }

    /// A name for something new; a keyword in its place is reported and taken if that helps.
    fn declared_name(&mut self, what: &str) -> Option<ast::Name> {
        if self.at_name() {
            return Some(self.name(SyntaxKind::Declared));
        }
        if let Some(keyword) = self.keyword() {
            let shown = self.shown();
            let likely = matches!(self.next_raw(), Raw::Colon | Raw::Comma | Raw::Becomes)
                || !(keyword.begins_section() || keyword.is_end() || keyword.begins_block() || keyword == Keyword::Begin);
            self.unexpected(Problem::P6060, format!("{shown} is a keyword of {} and cannot be {what}", self.dialect.title()));
            if likely {
                self.refused.push(keyword);
                let name = ast::Name { text: self.current().to_owned(), ..ast::Name::default() };
                let span = self.bump(SyntaxKind::Declared);
                return Some(ast::Name { span, ..name });
            }
            return None;
        }
        let shown = self.shown();
        self.unexpected(Problem::P2010, format!("{what} is wanted here, not {shown}"));
        None
    }

    /// `a.b.c`; the current token is a name.
    fn path(&mut self, kind: SyntaxKind) -> ast::Path {
        let start = self.here();
        let mut names = vec![self.name(kind)];
        while self.raw() == Raw::Point && self.is_name(self.behind(self.at)) {
            self.bump(SyntaxKind::Punctuation);
            names.push(self.name(kind));
        }
        ast::Path { names, span: self.since(start) }
    }

    /// Goes one level deeper; `false` with a message if that is too deep.
    fn deeper(&mut self) -> bool {
        if self.depth >= NESTING_MAX {
            let shown = self.shown();
            self.unexpected(Problem::P6063, format!("{shown} is nested more than {NESTING_MAX} levels deep"));
            return false;
        }
        self.depth += 1;
        true
    }

    /// Skips a bracketed part that is too deep, from its opening bracket.
    fn skip_brackets(&mut self) {
        let mut open = 0_usize;
        loop {
            match self.raw() {
                Raw::ParenOpen | Raw::BracketOpen => open += 1,
                Raw::ParenClose | Raw::BracketClose => open = open.saturating_sub(1),
                Raw::End | Raw::Semicolon => return,
                _ if self.keyword().is_some_and(|keyword| keyword.is_end()) => return,
                _ => {}
            }
            self.bump_unexpected();
            if open == 0 {
                return;
            }
        }
    }
}

/// Reports the signs and quotes that a word processor puts in place of those of ST; the tokens are what they stand for.
fn typeset(file: FileId, text: &str, tokens: &[Token], diagnostics: &mut Vec<Diagnostic>) {
    for token in tokens.iter().filter(|token| !token.raw.is_trivia()) {
        let (start, end) = (token.start as usize, token.end as usize);
        let written = &text[start..end];
        let Some(first) = written.chars().next().filter(|first| !first.is_ascii()) else { continue };
        let (right, message) = match typeset_sign(first) {
            Some((_, sign)) => (sign.to_owned(), format!("`{written}` is a sign of typesetting: ST writes `{sign}`")),
            None if straight_quote(first).is_some() => {
                let straight = straightened(written).into_owned();
                let message = format!("`{first}` is a quote of typesetting: ST writes `{}`", &straight[..1]);
                (straight, message)
            }
            None => continue,
        };
        let span = Span::new(file, token.start, token.end);
        diagnostics.push(Diagnostic::new(Problem::P1005, span, message).fix(span, right.clone(), format!("write `{right}`")));
        if diagnostics.len() > DIAGNOSTICS_MAX {
            return;
        }
    }
}

/// A name without its quotes; the closing one may be missing.
fn unquoted(text: &str, quote: char) -> &str {
    match text.strip_prefix(quote) {
        Some(inner) => inner.strip_suffix(quote).unwrap_or(inner),
        None => text,
    }
}
