//! What stands between the name of a block and its declarations in scl and tia: TITLE, AUTHOR, VERSION, flags.

use sieben_model::problems::Problem;

use super::super::ast::{Header, Name, Quoting};
use super::super::lexer::Raw;
use super::{Parser, SyntaxKind};

/// Words that stand alone.
const FLAGS: &[&str] =
    &["KNOW_HOW_PROTECT", "UNLINKED", "READ_ONLY", "NON_RETAIN", "STANDARD", "CODE_VERSION1", "RETAIN", "DB_SPECIFIC", "NOT_RETAIN"];

impl Parser<'_> {
    /// Lines of a header whose first word is missing.
    pub(super) fn lost_header(&mut self, header: &mut Header) {
        while matches!(self.raw(), Raw::Colon | Raw::Equal) {
            let shown = self.shown();
            self.unexpected(
                Problem::P2014,
                format!("{shown} begins no line of a header, which is written `AUTHOR : name` or `TITLE = text`"),
            );
            let from = self.here();
            self.rest_of_line(from);
            let more = self.header();
            header.flags.extend(more.flags);
            header.version = header.version.take().or(more.version);
        }
    }

    /// The lines of a header, none if there are none.
    pub(super) fn header(&mut self) -> Header {
        let mut header = Header::default();
        while self.raw() == Raw::Word {
            let next = self.next_raw();
            let behind = self.tokens[self.behind(self.at)];
            let same_line = !self.text[self.token().end as usize..behind.start as usize].contains(['\n', '\r']);
            // `TITLE Filling of the tank`, but no name of that word.
            let unsigned = same_line && matches!(next, Raw::Characters | Raw::Word) && behind.keyword.is_none();
            if self.at_word("TITLE") && (next == Raw::Equal || unsigned) {
                self.start(SyntaxKind::HeaderLine);
                self.bump(SyntaxKind::Keyword);
                let sign = if unsigned { self.previous } else { self.token().end };
                match unsigned {
                    true => self.missing(Problem::P2014, " =", "`=` is missing behind `TITLE`"),
                    false => {
                        self.bump(SyntaxKind::Punctuation);
                    }
                }
                let line = self.on_new_line();
                let from = self.here();
                let text = if line { String::new() } else { self.rest_of_line(sign) };
                let text = text.trim_matches('\'').to_owned();
                header.title = Some(Name { text, quoting: Quoting::Bare, span: self.since(from) });
                self.finish();
                continue;
            }
            let line = ["AUTHOR", "FAMILY", "NAME", "VERSION"].into_iter().position(|word| self.at_word(word));
            let value = matches!(next, Raw::Number | Raw::Characters);
            if let Some(line) = line.filter(|_| value || matches!(next, Raw::Colon | Raw::Equal)) {
                self.start(SyntaxKind::HeaderLine);
                self.bump(SyntaxKind::Keyword);
                match value {
                    true => self.missing(Problem::P2014, " :", format!("`:` is missing behind {}", self.previous_text())),
                    false => {
                        self.bump(SyntaxKind::Punctuation);
                    }
                }
                let from = self.here();
                let mut text = String::new();
                while !self.on_new_line() && !matches!(self.raw(), Raw::End | Raw::Semicolon) {
                    text.push_str(self.current());
                    self.bump_text();
                }
                let text = text.trim_matches(|c| matches!(c, '\'' | '"')).to_owned();
                let value = Some(Name { text, quoting: Quoting::Bare, span: self.since(from) });
                match line {
                    0 => header.author = value,
                    1 => header.family = value,
                    2 => header.name = value,
                    _ => header.version = value,
                }
                self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
                self.finish();
                continue;
            }
            let flag = FLAGS.iter().any(|word| self.at_word(word));
            if flag && !matches!(next, Raw::Colon | Raw::Becomes | Raw::Comma | Raw::Point | Raw::ParenOpen) {
                self.start(SyntaxKind::HeaderLine);
                let name = self.name(SyntaxKind::HeaderText);
                header.flags.push(name);
                self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
                self.finish();
                continue;
            }
            break;
        }
        header
    }
}
