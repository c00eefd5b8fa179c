//! `sieben fmt`: columns for label, instruction, operand and comment; blocks and declarations indented.
//!
//! Only blanks and line ends change. A line of the source stays a line, but each statement and each
//! declaration begins one of its own.

use rowan::{NodeOrToken, WalkEvent};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::FileId;

use super::convert::stops_rewriting;
use super::parser::{diagram_layout, parse_as};
use super::syntax::{SyntaxKind, SyntaxToken};
use crate::network::flavour::Drawing;

/// Blanks per level.
const INDENT: usize = 2;
/// Width of the label and of the instruction: `M001: `, `LAR1  `.
const COLUMN: usize = 6;
/// Where the comment behind a statement or declaration begins, if the line is short enough.
const COMMENT_COLUMN: usize = 40;

/// The source in standard layout; errors of syntax are returned instead. A misprint with a known meaning is none of them.
pub fn format(text: &str, mnemonics: Option<Mnemonics>) -> Result<String, Vec<Diagnostic>> {
    format_as(text, mnemonics, None)
}

/// The same for a source whose networks are drawn, unless they say something else.
pub fn format_as(text: &str, mnemonics: Option<Mnemonics>, drawing: Option<Drawing>) -> Result<String, Vec<Diagnostic>> {
    let parsed = parse_as(FileId::default(), text, mnemonics, drawing);
    let errors: Vec<Diagnostic> = parsed.diagnostics.iter().filter(|diagnostic| stops_rewriting(diagnostic)).cloned().collect();
    if !errors.is_empty() {
        return Err(errors);
    }
    let mut formatter = Formatter::new(text);
    for event in parsed.syntax().preorder_with_tokens() {
        match event {
            WalkEvent::Enter(NodeOrToken::Node(node)) => formatter.enter(node.kind()),
            WalkEvent::Leave(NodeOrToken::Node(node)) => formatter.leave(node.kind()),
            WalkEvent::Enter(NodeOrToken::Token(token)) => formatter.token(&token),
            WalkEvent::Leave(NodeOrToken::Token(_)) => {}
        }
    }
    Ok(formatter.finish())
}

/// The line that is being put together.
#[derive(Default)]
struct Line {
    /// Blanks before it.
    indent: usize,
    /// Label with colon, if it is the line of a statement.
    label: String,
    /// The instruction word.
    mnemonic: String,
    /// Everything else.
    rest: String,
    comment: String,
    /// It has a statement in columns.
    columns: bool,
    used: bool,
}

struct Formatter {
    out: String,
    newline: &'static str,
    line: Line,
    /// A blank stood before the next token.
    blank: bool,
    /// That blank as it is written.
    written_blank: String,
    /// Empty lines since the last line; at most one is kept.
    empty: usize,
    nodes: Vec<SyntaxKind>,
    /// No token of the innermost node came yet.
    fresh_node: bool,
    /// Behind BEGIN or the first statement.
    code: bool,
    /// Behind NETWORK or its TITLE, before the first statement.
    fresh_network: bool,
    /// Before the end of the last line of a diagram, which is written already.
    after_diagram: bool,
}

impl Formatter {
    fn new(text: &str) -> Self {
        let newline = match text.find(['\r', '\n']) {
            Some(at) if text[at..].starts_with("\r\n") => "\r\n",
            Some(at) if text[at..].starts_with('\r') => "\r",
            _ => "\n",
        };
        let mut out = String::with_capacity(text.len() * 2);
        if text.starts_with('\u{feff}') {
            out.push('\u{feff}');
        }
        Self {
            out,
            newline,
            line: Line::default(),
            blank: false,
            written_blank: String::new(),
            empty: 0,
            nodes: Vec::new(),
            fresh_node: false,
            code: false,
            fresh_network: false,
            after_diagram: false,
        }
    }

    fn enter(&mut self, kind: SyntaxKind) {
        use SyntaxKind::{Assignment, Block, Declaration, HeaderLine, Network, Section, Statement};
        if matches!(kind, Assignment | Block | Declaration | HeaderLine | Network | Section | Statement) {
            self.end_line();
        }
        match kind {
            Block => self.code = false,
            Network => (self.code, self.fresh_network) = (true, true),
            Statement => (self.code, self.fresh_network) = (true, false),
            _ => {}
        }
        self.nodes.push(kind);
        self.fresh_node = true;
    }

    fn leave(&mut self, kind: SyntaxKind) {
        self.nodes.pop();
        self.fresh_node = false;
        if kind == SyntaxKind::Block {
            self.code = false;
        }
    }

    fn token(&mut self, token: &SyntaxToken) {
        let kind = token.kind();
        let text = token.text();
        match kind {
            SyntaxKind::Blank => {
                self.blank = true;
                text.clone_into(&mut self.written_blank);
                return;
            }
            SyntaxKind::Diagram => {
                // The blank before the first element says how deep it lies.
                let indentation = std::mem::take(&mut self.written_blank);
                return self.diagram(&(indentation + text));
            }
            SyntaxKind::Newline => {
                self.written_blank.clear();
                match self.line.used {
                    _ if std::mem::take(&mut self.after_diagram) => {}
                    true => self.end_line(),
                    false => self.empty += 1,
                }
                return;
            }
            _ => {}
        }
        self.written_blank.clear();
        if kind == SyntaxKind::Keyword && self.line.used && begins_line(text) {
            self.end_line();
        }
        if !self.line.used {
            self.line.used = true;
            self.line.indent = self.indent(kind, text);
            self.blank = false;
        }
        self.place(kind, text);
        self.blank = false;
        self.fresh_node = false;
        if kind == SyntaxKind::Keyword && text.eq_ignore_ascii_case("BEGIN") {
            self.code = true;
        }
    }

    /// The lines of a diagram.
    fn diagram(&mut self, text: &str) {
        self.end_line();
        if self.empty > 0 && !self.out.trim_start_matches('\u{feff}').is_empty() {
            self.out.push_str(self.newline);
        }
        self.empty = 0;
        for line in diagram_layout(text).lines() {
            self.out.push_str(line);
            self.out.push_str(self.newline);
        }
        self.fresh_network = false;
        self.after_diagram = true;
    }

    /// Puts a token into its column.
    fn place(&mut self, kind: SyntaxKind, text: &str) {
        let line = &mut self.line;
        let starts_statement = line.label.is_empty() && line.mnemonic.is_empty() && line.rest.is_empty();
        match kind {
            SyntaxKind::Label if starts_statement => {
                line.columns = true;
                line.label.push_str(text);
            }
            SyntaxKind::Punctuation if line.columns && line.mnemonic.is_empty() && line.rest.is_empty() && text == ":" => {
                line.label.push_str(text);
            }
            SyntaxKind::Mnemonic if line.rest.is_empty() => {
                line.columns = true;
                if self.blank && !line.mnemonic.is_empty() {
                    line.mnemonic.push(' ');
                }
                line.mnemonic.push_str(text);
            }
            SyntaxKind::LineComment if line.columns || !line.rest.is_empty() => line.comment.push_str(text),
            _ => {
                let closes = matches!(kind, SyntaxKind::Semicolon) || text == ",";
                if self.blank && !line.rest.is_empty() && !closes {
                    line.rest.push(' ');
                }
                line.rest.push_str(text);
            }
        }
    }

    /// Blanks before a line that begins with this token.
    fn indent(&self, kind: SyntaxKind, text: &str) -> usize {
        use SyntaxKind::{Assignment, Attributes, Block, Declaration, Section, Statement, Struct};
        let inside = |kind| self.nodes.contains(&kind);
        let base = if inside(Block) { INDENT } else { 0 };
        let levels = self.nodes.iter().filter(|kind| matches!(kind, Section | Struct)).count();
        let comment = matches!(kind, SyntaxKind::LineComment | SyntaxKind::BlockComment);
        if levels > 0 {
            let innermost = self.nodes.iter().rev().find(|kind| matches!(kind, Section | Struct | Declaration));
            let edge = kind == SyntaxKind::Keyword && (is(text, "END_VAR") || is(text, "END_STRUCT"));
            let opens = self.fresh_node && matches!(innermost, Some(Section | Struct));
            let continues = innermost == Some(&Declaration) && !self.fresh_node;
            return base + INDENT * (levels - usize::from(edge || opens)) + if continues { 2 * INDENT } else { 0 };
        }
        if inside(Statement) {
            let begins = self.fresh_node && self.nodes.last() == Some(&Statement);
            return if begins || kind == SyntaxKind::Mnemonic { base } else { base + 2 * COLUMN };
        }
        if inside(Assignment) {
            return if self.fresh_node { base } else { base + INDENT };
        }
        if inside(Attributes) && !self.fresh_node && text != "}" {
            return INDENT;
        }
        match () {
            () if comment && self.code && !self.fresh_network => base + COLUMN,
            () if kind == SyntaxKind::Semicolon && self.code => base + COLUMN,
            () => 0,
        }
    }

    fn end_line(&mut self) {
        let line = std::mem::take(&mut self.line);
        self.blank = false;
        if !line.used {
            return;
        }
        if self.empty > 0 && !self.out.trim_start_matches('\u{feff}').is_empty() {
            self.out.push_str(self.newline);
        }
        self.empty = 0;
        let mut text = " ".repeat(line.indent);
        if line.columns {
            text.push_str(&line.label);
            let column = line.indent + COLUMN;
            if !line.mnemonic.is_empty() {
                pad(&mut text, column, !line.label.is_empty());
                text.push_str(&line.mnemonic);
            }
            let ends = line.rest.starts_with(';');
            if !line.rest.is_empty() {
                if !ends {
                    pad(&mut text, if line.mnemonic.is_empty() { column } else { column + COLUMN }, true);
                }
                text.push_str(&line.rest);
            }
        } else {
            text.push_str(&line.rest);
        }
        if !line.comment.is_empty() {
            pad(&mut text, COMMENT_COLUMN, true);
            text.push_str(&line.comment);
        }
        self.out.push_str(super::lexer::trim_blanks(&text));
        self.out.push_str(self.newline);
    }

    fn finish(mut self) -> String {
        self.end_line();
        self.out
    }
}

/// Blanks up to a column, at least one if `separate`.
fn pad(text: &mut String, column: usize, separate: bool) {
    let width = text.rsplit(['\n', '\r']).next().unwrap_or_default().chars().count();
    let blanks = column.saturating_sub(width).max(usize::from(separate));
    text.extend(std::iter::repeat_n(' ', blanks));
}

fn is(text: &str, keyword: &str) -> bool {
    text.eq_ignore_ascii_case(keyword)
}

/// Keywords that stand at the beginning of a line.
fn begins_line(keyword: &str) -> bool {
    is(keyword, "BEGIN") || keyword.get(..4).is_some_and(|start| is(start, "END_"))
}
