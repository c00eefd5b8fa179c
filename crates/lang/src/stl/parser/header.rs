//! Heads of blocks: title, author, attributes.

use sieben_model::problems::Problem;

use super::Parser;
use super::blocks::{Keyword, is_keyword};
use crate::stl::ast::{Block, Header, TypeKind, TypeName, Word};
use crate::stl::lexer::{Raw, is_terminated, token, trim_blanks};
use crate::stl::syntax::SyntaxKind;

/// Words of a head without a value.
pub(in crate::stl) const HEADER_FLAGS: [&str; 6] = ["KNOW_HOW_PROTECT", "READ_ONLY", "UNLINKED", "NON_RETAIN", "STANDARD", "CODE_VERSION1"];

/// Words of a head with a value.
pub(in crate::stl) const HEADER_FIELDS: [&str; 4] = ["AUTHOR", "FAMILY", "NAME", "VERSION"];

impl Parser<'_> {
    /// Whether a line of a head begins here: `AUTHOR`, `READ_ONLY`.
    pub(super) fn at_header_word(&self) -> bool {
        HEADER_FLAGS.iter().chain(&HEADER_FIELDS).any(|word| self.at_word(word))
    }

    /// Everything between the name and BEGIN.
    pub(super) fn header(&mut self, block: &mut Block, data: bool) {
        loop {
            self.trivia();
            if block.header.comment.is_empty() && block.header.title.is_some() && block.sections.is_empty() {
                block.header.comment = self.take_comments();
            }
            match self.raw {
                Raw::BraceOpen => {
                    let attributes = self.attributes();
                    block.header.attributes.extend(attributes);
                    continue;
                }
                Raw::Semicolon => {
                    self.bump(SyntaxKind::Semicolon);
                    continue;
                }
                Raw::Symbol if data && block.body_type.is_none() => {
                    block.body_type = Some(self.type_name());
                    continue;
                }
                Raw::Word => {}
                _ => return,
            }
            if self.header_line(&mut block.header) {
                continue;
            }
            match self.keyword() {
                Some(Keyword::Section(section)) => {
                    let section = self.section(section);
                    block.sections.push(section);
                }
                Some(Keyword::Struct) if data => block.body_type = Some(self.type_name()),
                Some(_) => return,
                None if data && block.body_type.is_none() && self.raw_behind_blanks() != Raw::Becomes => {
                    let checkpoint = self.builder.checkpoint();
                    match self.kind_and_number() {
                        Some((kind, number, start, end)) => {
                            self.start_at(checkpoint, SyntaxKind::TypeName);
                            self.finish();
                            block.body_type = Some(TypeName { kind: TypeKind::Block(kind, number), span: self.span(start, end) });
                        }
                        None => return,
                    }
                }
                None => return,
            }
        }
    }

    /// TITLE, AUTHOR, a flag …; `false` if the word is none.
    fn header_line(&mut self, header: &mut Header) -> bool {
        let is = |word: &str| self.at_word(word);
        if let Some(flag) = HEADER_FLAGS.into_iter().find(|flag| is(flag)) {
            let (start, end) = self.bump(SyntaxKind::Keyword);
            header.flags.push(Word { text: flag.to_owned(), span: self.span(start, end) });
            return true;
        }
        if is("TITLE") {
            header.title = Some(self.title());
            self.comments.clear();
            return true;
        }
        let Some(field) = HEADER_FIELDS.into_iter().find(|field| is(field)) else { return false };
        self.start(SyntaxKind::HeaderLine);
        self.bump(SyntaxKind::Keyword);
        self.blanks();
        match self.raw {
            Raw::Colon | Raw::Becomes => {
                self.bump(SyntaxKind::Punctuation);
            }
            Raw::Sign if self.current() == "=" => {
                self.bump(SyntaxKind::Punctuation);
            }
            _ => {
                let message = format!("`{field}` wants a colon and a text, not {}", self.shown());
                self.error(Problem::P2014, self.position, self.end, message);
            }
        }
        if self.raw == Raw::Blank {
            self.bump(SyntaxKind::Blank);
        }
        let rest = &self.text[self.position..];
        let end = match self.raw {
            Raw::Characters if is_terminated(self.raw, self.current()) => self.end,
            _ => self.position + self.header_text_end(rest),
        };
        let text = self.slice(self.position, end).trim_matches('\'').to_owned();
        let word = Word { text, span: self.span(self.position, end) };
        self.bump_to(SyntaxKind::HeaderText, end);
        self.finish();
        match field {
            "AUTHOR" => header.author = Some(word),
            "FAMILY" => header.family = Some(word),
            "NAME" => header.name = Some(word),
            _ => header.version = Some(word),
        }
        true
    }

    /// How many bytes of the rest of a line are the text of a header line: up to a `;` or a comment that ends it, without the spaces before.
    ///
    /// Several header lines may share one line: what stands behind a name of one word may be the next of them.
    fn header_text_end(&self, rest: &str) -> usize {
        let line = &rest[..rest.find(['\r', '\n']).unwrap_or(rest.len())];
        let first = line.find(|c: char| c.is_whitespace() || c == ';').unwrap_or(line.len());
        if self.header_word_at(self.behind_blanks(self.position + first)) {
            return first;
        }
        let comment = line.find("//").filter(|&at| at == 0 || line[..at].ends_with(char::is_whitespace));
        let text = &line[..comment.unwrap_or(line.len())];
        let text = trim_blanks(text);
        trim_blanks(text.strip_suffix(';').unwrap_or(text)).len()
    }

    /// Whether something else of a head begins at a byte: a flag, another header line, a section, BEGIN, the end of the line.
    fn header_word_at(&self, at: usize) -> bool {
        let (raw, end) = token(self.text, at);
        if matches!(raw, Raw::Newline | Raw::End | Raw::BraceOpen) {
            return true;
        }
        let word = &self.text[at..end];
        let is = |keyword: &&str| word.eq_ignore_ascii_case(keyword);
        if raw != Raw::Word {
            return false;
        }
        let followed = matches!(token(self.text, self.behind_blanks(end)).0, Raw::Colon | Raw::Sign | Raw::Becomes);
        match () {
            () if HEADER_FLAGS.iter().any(&is) => true,
            () if HEADER_FIELDS.iter().any(&is) || is(&"TITLE") => followed,
            () => is_keyword(word),
        }
    }

    /// `TITLE = text to the end of the line`.
    pub(super) fn title(&mut self) -> Word {
        self.start(SyntaxKind::HeaderLine);
        self.bump(SyntaxKind::Keyword);
        self.blanks();
        if matches!(self.raw, Raw::Colon | Raw::Becomes) || (self.raw == Raw::Sign && self.current() == "=") {
            self.bump(SyntaxKind::Punctuation);
        }
        if self.raw == Raw::Blank {
            self.bump(SyntaxKind::Blank);
        }
        let rest = &self.text[self.position..];
        let line = &rest[..rest.find(['\r', '\n']).unwrap_or(rest.len())];
        let end = self.position + trim_blanks(line).len();
        let word = Word { text: trim_blanks(line).to_owned(), span: self.span(self.position, end) };
        self.bump_to(SyntaxKind::HeaderText, end);
        self.finish();
        word
    }

    /// `{ S7_m_c := 'true'; … }`.
    pub(super) fn attributes(&mut self) -> Vec<(Word, Word)> {
        let mut attributes = Vec::new();
        let opened = (self.position, self.end);
        self.start(SyntaxKind::Attributes);
        self.bump(SyntaxKind::Punctuation);
        loop {
            self.trivia();
            match self.raw {
                Raw::BraceClose => {
                    self.bump(SyntaxKind::Punctuation);
                    break;
                }
                Raw::Word if self.raw_behind_trivia() == Raw::Becomes || self.raw_behind_trivia() == Raw::Sign => {
                    let name = self.name_word(SyntaxKind::Name);
                    self.trivia();
                    if !self.becomes() {
                        self.bump(SyntaxKind::Unexpected);
                    }
                    self.trivia();
                    let value = match self.raw {
                        Raw::Characters | Raw::Word | Raw::Number | Raw::Literal | Raw::Symbol => {
                            let text = self.current().trim_matches(['\'', '"']).to_owned();
                            let (start, end) = self.bump(SyntaxKind::Constant);
                            Word { text, span: self.span(start, end) }
                        }
                        _ => Word { text: String::new(), span: self.span(self.position, self.position) },
                    };
                    attributes.push((name, value));
                }
                Raw::Semicolon => {
                    self.bump(SyntaxKind::Semicolon);
                }
                Raw::Comma => {
                    self.bump(SyntaxKind::Punctuation);
                }
                Raw::End => {
                    self.error(Problem::P2015, opened.0, opened.1, "this attribute list has no `}`");
                    break;
                }
                _ if self.keyword().is_some() => {
                    self.error(Problem::P2015, opened.0, opened.1, "this attribute list has no `}`");
                    break;
                }
                _ => {
                    let message = format!("{} is no attribute; write `name := 'value'`", self.shown());
                    self.error(Problem::P2015, self.position, self.end, message);
                    self.bump_unexpected();
                }
            }
        }
        self.finish();
        attributes
    }
}
