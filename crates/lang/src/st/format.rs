//! `sieben fmt` for ST and SCL: indentation by structure, one statement and one declaration on a line, blanks around operators.
//!
//! Only blanks and line ends change; case, comments and the breaks inside a statement stay. A comment behind a statement keeps
//! its distance.

use rowan::{NodeOrToken, WalkEvent};
use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::source::FileId;

use super::diagrams;
use super::dialect::Dialect;
use super::parser::parse;
use super::syntax::{SyntaxKind, SyntaxToken};

/// Blanks per level.
const INDENT: usize = 2;

/// The source in standard layout; errors of syntax are returned instead.
pub fn format(text: &str, dialect: Dialect) -> Result<String, Vec<Diagnostic>> {
    let parsed = parse(FileId::default(), text, dialect);
    let errors: Vec<Diagnostic> =
        parsed.diagnostics.iter().filter(|diagnostic| diagnostic.severity() == Severity::Error).cloned().collect();
    if !errors.is_empty() {
        return Err(errors);
    }
    let tree = parsed.syntax(text);
    // Line ends inside comments do not count: they stay what they are.
    let line_end = tree.descendants_with_tokens().filter_map(NodeOrToken::into_token).find(|token| token.kind() == SyntaxKind::Newline);
    let newline = match line_end.as_ref().map(SyntaxToken::text) {
        Some("\r\n") => "\r\n",
        Some("\r") => "\r",
        _ => "\n",
    };
    let mut formatter = Formatter::new(text, newline);
    for event in tree.preorder_with_tokens() {
        match event {
            WalkEvent::Enter(NodeOrToken::Node(node)) => formatter.enter(node.kind()),
            WalkEvent::Leave(NodeOrToken::Node(node)) => formatter.leave(node.kind()),
            WalkEvent::Enter(NodeOrToken::Token(token)) => formatter.token(&token),
            WalkEvent::Leave(NodeOrToken::Token(_)) => {}
        }
    }
    Ok(formatter.finish())
}

/// A node that is open.
struct Open {
    kind: SyntaxKind,
    /// No token of it came yet.
    fresh: bool,
}

/// What stands before the next token on its line.
#[derive(Clone, Default)]
struct Before {
    kind: Option<SyntaxKind>,
    text: String,
    /// It is a sign of one operand.
    unary: bool,
}

struct Formatter {
    out: String,
    newline: &'static str,
    /// The line that is being put together.
    line: String,
    used: bool,
    before: Before,
    /// The last token that is neither blank nor comment, on whichever line.
    behind: Before,
    /// The blanks before the next token, as written.
    blank: String,
    /// Empty lines since the last line; at most one is kept.
    empty: usize,
    nodes: Vec<Open>,
    /// The next token that is no comment begins a line.
    break_next: bool,
    /// A body has ended, and only comments came since.
    after_body: bool,
    /// Behind a diagram, whose last line has its end already.
    after_diagram: bool,
    /// Behind TYPE, on its line: `TYPE "name"` is one header in TIA.
    after_type: bool,
}

impl Formatter {
    fn new(text: &str, newline: &'static str) -> Self {
        let mut out = String::with_capacity(text.len() + text.len() / 4);
        if text.starts_with('\u{feff}') {
            out.push('\u{feff}');
        }
        Self {
            out,
            newline,
            line: String::new(),
            used: false,
            before: Before::default(),
            behind: Before::default(),
            blank: String::new(),
            empty: 0,
            nodes: Vec::new(),
            break_next: false,
            after_body: false,
            after_diagram: false,
            after_type: false,
        }
    }

    fn enter(&mut self, kind: SyntaxKind) {
        use SyntaxKind::{Block, Body, CaseArm, Declaration, HeaderLine, Section, Statement};
        // The first statement of an arm of CASE may stay on the line of its label.
        let beside_label = kind == Statement && self.is_fresh_body_of_arm();
        let after_type = self.used && self.before.kind == Some(SyntaxKind::Keyword) && self.before.text.eq_ignore_ascii_case("TYPE");
        if kind == Declaration && after_type {
            self.after_type = true;
        } else if matches!(kind, Block | CaseArm | Declaration | HeaderLine | Section | Statement) && !beside_label {
            self.end_line();
        }
        if kind == Body && self.nodes.last().is_none_or(|node| node.kind != CaseArm) {
            self.break_next = true;
        }
        self.nodes.push(Open { kind, fresh: true });
    }

    fn is_fresh_body_of_arm(&self) -> bool {
        let mut open = self.nodes.iter().rev();
        let body = open.next().is_some_and(|node| node.kind == SyntaxKind::Body && node.fresh);
        body && open.next().is_some_and(|node| node.kind == SyntaxKind::CaseArm)
    }

    fn leave(&mut self, kind: SyntaxKind) {
        self.nodes.pop();
        match kind {
            SyntaxKind::Body => (self.break_next, self.after_body) = (true, true),
            SyntaxKind::Block | SyntaxKind::Section => self.break_next = true,
            _ => {}
        }
    }

    fn token(&mut self, token: &SyntaxToken) {
        let (kind, text) = (token.kind(), token.text());
        match kind {
            SyntaxKind::Blank => {
                self.blank.push_str(text.trim_start_matches('\u{feff}'));
                return;
            }
            SyntaxKind::Newline => {
                match self.used {
                    true => self.end_line(),
                    // A diagram has ended its last line itself.
                    false if std::mem::take(&mut self.after_diagram) => {}
                    false => self.empty += 1,
                }
                self.blank.clear();
                return;
            }
            SyntaxKind::Diagram => return self.diagram(text),
            SyntaxKind::LineComment | SyntaxKind::BlockComment | SyntaxKind::Pragma => {}
            _ if std::mem::take(&mut self.after_type) && self.used && !text.starts_with('"') => self.end_line(),
            SyntaxKind::Semicolon => self.break_next = false,
            _ => {
                let own_line = std::mem::take(&mut self.break_next) || (kind == SyntaxKind::Keyword && begins_line(text));
                if own_line && self.used {
                    self.end_line();
                }
            }
        }
        if !self.used {
            self.used = true;
            self.line = " ".repeat(self.indent(kind, text));
            self.before = Before::default();
        } else {
            self.space(kind, text);
        }
        let trivia = matches!(kind, SyntaxKind::LineComment | SyntaxKind::BlockComment | SyntaxKind::Pragma | SyntaxKind::Inactive);
        let unary = matches!(text, "-" | "+") && kind == SyntaxKind::Operator && self.operand_wanted();
        self.line.push_str(if kind == SyntaxKind::LineComment { text.trim_end() } else { text });
        self.before = Before { kind: Some(kind), text: text.to_owned(), unary };
        self.blank.clear();
        if !trivia {
            self.behind = self.before.clone();
            self.after_body = false;
            for node in &mut self.nodes {
                node.fresh = false;
            }
        }
    }

    /// The networks of a body that is a diagram, below its first word.
    fn diagram(&mut self, text: &str) {
        // The blanks of the first line tell how far it is indented.
        let written = std::mem::take(&mut self.blank) + text;
        self.end_line();
        self.empty = 0;
        let indent = " ".repeat(self.indent(SyntaxKind::Name, ""));
        for line in diagrams::layout::lines(&written) {
            if !line.is_empty() {
                self.out.push_str(&indent);
                self.out.push_str(&line);
            }
            self.out.push_str(self.newline);
        }
        (self.break_next, self.after_diagram) = (true, true);
    }

    /// Whether an operand stands next, and no operator between two.
    fn operand_wanted(&self) -> bool {
        let text = self.behind.text.as_str();
        match self.behind.kind {
            None => true,
            Some(SyntaxKind::Operator) => text != "^",
            Some(SyntaxKind::Keyword) => true,
            Some(SyntaxKind::Punctuation) => matches!(text, "(" | "[" | "," | ":"),
            _ => false,
        }
    }

    /// Puts the blanks between the last token and this one.
    fn space(&mut self, kind: SyntaxKind, text: &str) {
        use SyntaxKind::{
            Address, BlockComment, Declared, HeaderText, Inactive, Keyword, LineComment, Name, Number, Operator, Punctuation, Semicolon,
            TypeWord,
        };
        let before = &self.before;
        let free = |kind| matches!(kind, HeaderText | Inactive);
        if free(kind) && before.kind.is_some_and(free) || kind == Inactive {
            self.line.push_str(&self.blank);
            return;
        }
        if kind == LineComment || (kind == BlockComment && before.kind == Some(Semicolon)) {
            match self.blank.is_empty() {
                true => self.line.push(' '),
                false => self.line.push_str(&self.blank),
            }
            return;
        }
        let label = self
            .nodes
            .iter()
            .rev()
            .find(|node| !matches!(node.kind, SyntaxKind::Expression))
            .is_some_and(|node| matches!(node.kind, SyntaxKind::Statement | SyntaxKind::CaseArm));
        let word = before.text.as_str();
        let tight_before = match text {
            "." | ".." | "," | ")" | "]" => matches!(kind, Punctuation | Operator | Address),
            "^" => kind == Operator,
            ":" => kind == Punctuation && label,
            "[" => kind == Punctuation && !matches!(before.kind, Some(Operator)) && word != "(" && word != ",",
            "(" => {
                let called = matches!(before.kind, Some(Name | TypeWord | Declared | Number | Address)) || matches!(word, ")" | "]" | "^");
                let keyword = ["THIS", "SUPER", "__CATCH"].iter().any(|keyword| word.eq_ignore_ascii_case(keyword));
                kind == Punctuation && (called || (before.kind == Some(Keyword) && keyword))
            }
            // `S=`, `R=`, `REF=` are one operator.
            "=" => before.kind == Some(Operator) && self.blank.is_empty() && word.starts_with(|c: char| c.is_ascii_alphabetic()),
            _ => kind == Semicolon,
        };
        let tight_behind = match word {
            "(" | "[" | "." => before.kind == Some(Punctuation) || before.kind == Some(Address),
            ".." => true,
            _ => before.unary,
        };
        if !(tight_before || tight_behind) {
            self.line.push(' ');
        }
    }

    /// Blanks before a line that begins with this token.
    fn indent(&self, kind: SyntaxKind, text: &str) -> usize {
        use SyntaxKind::{Block, BlockComment, Body, Declaration, HeaderLine, Keyword, LineComment, Pragma, Section, Statement, Struct};
        let levels = self.nodes.iter().filter(|node| matches!(node.kind, Block | Body | Section | Struct)).count();
        let comment = matches!(kind, LineComment | BlockComment | Pragma);
        let owner =
            self.nodes.iter().rev().find(|node| {
                matches!(node.kind, Block | Body | Section | Struct | Statement | Declaration | HeaderLine | SyntaxKind::CaseArm)
            });
        let Some(owner) = owner else { return 0 };
        let edge = match owner.kind {
            Block | Section | Struct => {
                (owner.fresh && !comment) || (kind == Keyword && (ends(text) || text.eq_ignore_ascii_case("BEGIN")))
            }
            HeaderLine => true,
            _ => false,
        };
        let continues = matches!(owner.kind, Statement | Declaration)
            && !owner.fresh
            && !matches!(kind, Keyword | SyntaxKind::Semicolon)
            && text != ")";
        let extra = match continues {
            true if comment && (self.after_body || self.before_body()) => INDENT,
            true => 2 * INDENT,
            false => 0,
        };
        INDENT * levels.saturating_sub(usize::from(edge)) + extra
    }

    /// Whether a body begins behind the last token, and only comments came since.
    fn before_body(&self) -> bool {
        let opens = ["THEN", "ELSE", "DO", "REPEAT", "OF", "__TRY", "__FINALLY"];
        match self.behind.kind {
            Some(SyntaxKind::Keyword) => opens.iter().any(|word| self.behind.text.eq_ignore_ascii_case(word)),
            Some(SyntaxKind::HeaderText) => true,
            _ => false,
        }
    }

    fn end_line(&mut self) {
        self.blank.clear();
        if !std::mem::take(&mut self.used) {
            return;
        }
        if self.empty > 0 && !self.out.trim_start_matches('\u{feff}').is_empty() {
            self.out.push_str(self.newline);
        }
        self.empty = 0;
        let line = std::mem::take(&mut self.line);
        self.out.push_str(line.trim_end_matches([' ', '\t']));
        self.out.push_str(self.newline);
        self.before = Before::default();
    }

    fn finish(mut self) -> String {
        self.end_line();
        self.out
    }
}

fn ends(keyword: &str) -> bool {
    keyword.get(..4).is_some_and(|start| start.eq_ignore_ascii_case("END_")) || keyword.eq_ignore_ascii_case("__ENDTRY")
}

/// Keywords that stand at the beginning of a line.
fn begins_line(keyword: &str) -> bool {
    ends(keyword) || ["BEGIN", "ELSE", "ELSIF", "UNTIL", "__CATCH", "__FINALLY"].iter().any(|word| keyword.eq_ignore_ascii_case(word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_source_gets_its_layout_and_keeps_it() {
        let text = "FUNCTION_BLOCK  Pump\nVAR_INPUT start:BOOL; (* go *) n : ARRAY [1..3] OF INT:=[1,2,3];END_VAR\n\n\n\
            IF start AND(n[1]>-5)THEN n[ 2 ]:=-n[1]*( 2+n[ 3 ] );// why\n // last\nELSE t(IN:=start,\nPT:=T#1s);END_IF;\n\
            CASE n[1] OF 1,2..5: a:=1; b:=2;\n // other\n ELSE\n c := p^.x; END_CASE;\nx S= y; q.%X3 := s.3;\nEND_FUNCTION_BLOCK\n";
        let once = "FUNCTION_BLOCK Pump\n  VAR_INPUT\n    start : BOOL; (* go *)\n    n : ARRAY[1..3] OF INT := [1, 2, 3];\n  END_VAR\n\n\
            \x20 IF start AND (n[1] > -5) THEN\n    n[2] := -n[1] * (2 + n[3]); // why\n    // last\n  ELSE\n    t(IN := start,\n        PT := T#1s);\n  END_IF;\n\
            \x20 CASE n[1] OF\n    1, 2..5: a := 1;\n      b := 2;\n    // other\n    ELSE\n      c := p^.x;\n  END_CASE;\n  x S= y;\n  q.%X3 := s.3;\nEND_FUNCTION_BLOCK\n";
        let formatted = format(text, Dialect::Codesys).unwrap_or_else(|errors| panic!("{errors:?}"));
        assert_eq!(formatted, once);
        assert_eq!(format(&formatted, Dialect::Codesys).as_deref(), Ok(formatted.as_str()));
    }

    #[test]
    fn comments_before_a_body_stand_like_it_and_signs_on_a_new_line_keep_their_blank() {
        let text = "IF a THEN // yes\n// first\nx := 1\n+ 2 - -3;\nELSE // no\n(* other *)\nx := (\n-1);\nEND_IF;\n";
        let once = "IF a THEN // yes\n  // first\n  x := 1\n      + 2 - -3;\nELSE // no\n  (* other *)\n  x := (\n      -1);\nEND_IF;\n";
        assert_eq!(format(text, Dialect::Iec).as_deref(), Ok(once));
        assert_eq!(format(once, Dialect::Iec).as_deref(), Ok(once));
    }

    #[test]
    fn line_ends_are_those_of_the_code_and_not_of_a_comment() {
        let text = "\r\n(* a\rb *)\r\nx := 1;\r\n";
        assert_eq!(format(text, Dialect::Iec).as_deref(), Ok("(* a\rb *)\r\nx := 1;\r\n"));
    }

    #[test]
    fn a_diagram_gets_the_layout_of_form_a_and_keeps_it() {
        let text = "PROGRAM Main\nVAR a,b,x:BOOL;t:TON;END_VAR\n\nLD\nNETWORK\nTITLE = two  words\n// why\nOR\n  NO   a // left\nOR\n  NC b\nEND\nTON t\n PT:=T#2s\nCOIL x\n\nNETWORK   FBD\n  AND( a , b ) -> = x\nEND_PROGRAM\n";
        let once = "PROGRAM Main\n  VAR\n    a, b, x : BOOL;\n    t : TON;\n  END_VAR\n\n  LD\n  NETWORK\n  TITLE = two  words\n      // why\n      OR\n          NO  a  // left\n      OR\n          NC  b\n      END\n      TON t\n          PT:=T#2s\n      COIL  x\n\n  NETWORK FBD\n      AND( a , b ) -> = x\nEND_PROGRAM\n";
        let formatted = format(text, Dialect::Iec).unwrap_or_else(|errors| panic!("{errors:?}"));
        assert_eq!(formatted, once);
        assert_eq!(format(once, Dialect::Iec).as_deref(), Ok(once));
    }

    #[test]
    fn a_source_with_an_error_is_not_touched() {
        assert!(format("x := ;", Dialect::Iec).is_err());
    }
}
