//! Declarations: the sections of variables, their initial values, the assignments of data blocks.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::Section;
use sieben_model::problems::Problem;
use sieben_model::types::DataType;

use super::Parser;
use super::blocks::Keyword;
use super::types::is_type;
use crate::scan::is_blank;
use crate::stl::ast::{Assignment, Block, Constant, Declaration, Initial, Operand, PathElement, TypeKind, TypeName, VarSection, Word};
use crate::stl::lexer::{Raw, token, trim_blanks};
use crate::stl::syntax::SyntaxKind;

impl Parser<'_> {
    pub(super) fn section(&mut self, section: Section) -> VarSection {
        let start = self.position;
        self.start(SyntaxKind::Section);
        let keyword = self.bump(SyntaxKind::Keyword);
        self.blanks();
        // TIA writes `VAR RETAIN`, `VAR NON_RETAIN`, `VAR CONSTANT`; a declaration would have a colon.
        if ["RETAIN", "NON_RETAIN"].into_iter().any(|word| self.at_word(word)) && self.raw_behind_blanks() != Raw::Colon {
            self.bump(SyntaxKind::Keyword);
        }
        let declarations = self.declarations(true);
        if self.keyword() == Some(Keyword::EndVar) {
            self.bump(SyntaxKind::Keyword);
        } else {
            let message = format!("this {} has no `END_VAR`", self.slice(keyword.0, keyword.1).to_uppercase());
            self.error(Problem::P2023, keyword.0, keyword.1, message);
        }
        let span = self.span(start, self.position);
        let behind = self.behind_blanks(self.position);
        if token(self.text, behind).0 == Raw::Semicolon {
            self.blanks();
            self.bump(SyntaxKind::Semicolon);
        }
        self.finish();
        VarSection { section, declarations, span }
    }

    /// Declarations up to a keyword that is none. The names of the outermost level are remembered.
    pub(super) fn declarations(&mut self, outermost: bool) -> Vec<Declaration> {
        let mut declarations = Vec::new();
        loop {
            self.trivia();
            match self.raw {
                Raw::End => return declarations,
                Raw::Semicolon => {
                    self.bump(SyntaxKind::Semicolon);
                }
                Raw::Word | Raw::Local | Raw::Symbol => {
                    if self.keyword().is_some() {
                        return declarations;
                    }
                    let declaration = self.declaration();
                    if outermost {
                        self.declared.extend(declaration.names.iter().map(|name| name.text.to_ascii_uppercase()));
                    }
                    declarations.push(declaration);
                }
                _ => {
                    let message = format!("{} is no name of a variable; write `name : INT;`", self.shown());
                    self.error(Problem::P2020, self.position, self.end, message);
                    self.skip_declaration();
                }
            }
        }
    }

    /// To the `;` or the end of the line; takes at least one token.
    fn skip_declaration(&mut self) {
        self.bump_unexpected();
        self.skip_statement();
        if self.raw == Raw::Semicolon {
            self.bump(SyntaxKind::Semicolon);
        }
    }

    fn declaration(&mut self) -> Declaration {
        let start = self.position;
        self.start(SyntaxKind::Declaration);
        self.comments.clear();
        let mut declaration = Declaration {
            names: Vec::new(),
            attributes: Vec::new(),
            data_type: TypeName { kind: TypeKind::Missing, span: self.span(start, start) },
            initial: Vec::new(),
            comment: String::new(),
            span: self.span(start, start),
        };
        loop {
            match self.raw {
                Raw::Word | Raw::Local | Raw::Symbol => declaration.names.push(self.name_word(SyntaxKind::Name)),
                _ => {
                    let message = format!("{} is no name of a variable", self.shown());
                    self.error(Problem::P2020, self.position, self.end, message);
                    break;
                }
            }
            self.blanks();
            if self.raw != Raw::Comma {
                break;
            }
            self.bump(SyntaxKind::Punctuation);
            self.trivia();
        }
        if self.raw == Raw::BraceOpen || (self.raw == Raw::Newline && self.raw_behind_trivia() == Raw::BraceOpen) {
            self.trivia();
            declaration.attributes = self.attributes();
        }
        self.blanks();
        if self.raw == Raw::Colon || (self.raw == Raw::Newline && self.raw_behind_trivia() == Raw::Colon) {
            self.trivia();
            self.bump(SyntaxKind::Punctuation);
            self.trivia();
            declaration.data_type = self.type_name();
            self.blanks();
            if self.raw == Raw::BraceOpen {
                declaration.attributes.extend(self.attributes());
                self.blanks();
            }
            if self.raw == Raw::Newline && self.raw_behind_trivia() == Raw::Becomes {
                self.trivia();
            }
            if self.becomes() {
                declaration.initial = self.initials(true);
            }
        } else if self.at_type() && self.text[..self.position].ends_with(is_blank) {
            let name_end = trim_blanks(&self.text[..self.position]).len();
            let (span, word) = (self.span(name_end, self.end), self.current());
            let message = format!("`:` is missing before `{word}`, the type of the variable");
            let place = self.span(self.position, self.end);
            self.report(Diagnostic::new(Problem::P2020, place, message).fix(span, format!(" : {word}"), "write `:` before the type"));
            declaration.data_type = self.type_name();
        } else if !self.glued_type(&mut declaration) {
            let message = format!("{} where a declaration goes on with `:` and a type", self.shown());
            self.error(Problem::P2020, self.position, self.end, message);
            self.skip_statement();
        }
        self.blanks();
        declaration.span = self.span(start, self.position);
        let missing_is_usual = self.at_statement_end() || self.keyword().is_some();
        if missing_is_usual {
            let behind = self.behind_trivia(self.position);
            if token(self.text, behind).0 == Raw::Semicolon {
                self.trivia();
                self.bump(SyntaxKind::Semicolon);
            }
        } else {
            let message = format!("{} does not belong here: a declaration ends with `;`", self.shown());
            self.error(Problem::P2020, self.position, self.end, message);
            self.skip_declaration();
        }
        self.blanks();
        if self.raw == Raw::LineComment {
            self.comments.push((self.position, self.end));
            self.bump(SyntaxKind::LineComment);
        }
        declaration.comment = self.take_comments();
        self.finish();
        declaration
    }

    /// `counterINT;`: a name with its type glued to it.
    fn glued_type(&mut self, declaration: &mut Declaration) -> bool {
        if declaration.names.len() != 1 || !self.at_statement_end() {
            return false;
        }
        let Some(name) = declaration.names.last() else { return false };
        let (written, span) = (name.text.clone(), name.span);
        let mut ways: Vec<(&str, &str)> =
            written.char_indices().skip(1).map(|(at, _)| written.split_at(at)).filter(|(_, word)| is_type(word)).collect();
        if ways.len() > 1 {
            // The name stands somewhere else in the source, too.
            let mentioned: Vec<_> = ways.iter().copied().filter(|(name, _)| self.mentions(name)).collect();
            if mentioned.len() == 1 {
                ways = mentioned;
            }
        }
        let Some(&(name, word)) = ways.first() else { return false };
        let message = format!("`{written}` is a name with its type glued to it: `:` is missing");
        let diagnostic = Diagnostic::new(Problem::P2020, span, message);
        let right = format!("{name} : {word}");
        self.report(match ways.as_slice() {
            [_] if self.is_glued(&written, name) => diagnostic.fix(span, right.clone(), format!("write `{right}`")),
            [_] => diagnostic.guess(span, right.clone(), format!("write `{right}`")),
            ways => {
                let ways: Vec<String> = ways.iter().map(|(name, word)| format!("`{name} : {word}`")).collect();
                diagnostic.help(format!("write {}", ways.join(" or ")))
            }
        });
        declaration.data_type = TypeName { kind: TypeKind::Word(word.to_ascii_uppercase()), span };
        declaration.names = vec![Word { text: name.to_owned(), span }];
        true
    }

    /// Whether a declared word can only be a name and its type: the type stands out by its capitals, no type of another dialect ends
    /// the word, and the word is no name that the source uses.
    fn is_glued(&self, written: &str, name: &str) -> bool {
        let word = &written[name.len()..];
        let stands_out = word.chars().all(|c| c.is_ascii_uppercase() || c == '_') && !name.ends_with(|c: char| c.is_ascii_uppercase());
        let longer = DataType::all_words().any(|other| other.len() > word.len() && written.len() > other.len() && written.ends_with(other));
        stands_out && !longer && self.times_mentioned(written) < 2
    }

    /// Constants with commas; a comma may end a line.
    fn initials(&mut self, outermost: bool) -> Vec<Initial> {
        let mut values = Vec::new();
        loop {
            self.trivia();
            match self.initial() {
                Some(value) => values.push(value),
                None => return values,
            }
            let behind = if outermost { self.behind_blanks(self.position) } else { self.behind_trivia(self.position) };
            let comma = token(self.text, behind).0 == Raw::Comma
                || (outermost && token(self.text, self.behind_trivia(self.position)).0 == Raw::Comma);
            if !comma {
                return values;
            }
            self.trivia();
            self.bump(SyntaxKind::Punctuation);
        }
    }

    fn initial(&mut self) -> Option<Initial> {
        let start = self.position;
        if self.raw == Raw::Number && self.raw_behind_trivia() == Raw::ParenOpen {
            let count = match self.current().parse::<u64>() {
                Ok(count) => count,
                Err(_) if self.current().bytes().all(|byte| byte.is_ascii_digit()) => u64::MAX,
                Err(_) => {
                    let message = format!("{} is no count; a repetition is written `3 (0)`", self.shown());
                    self.error(Problem::P2024, self.position, self.end, message);
                    1
                }
            };
            self.bump(SyntaxKind::Number);
            self.trivia();
            if !self.deeper() {
                return None;
            }
            self.bump(SyntaxKind::Punctuation);
            let values = self.initials(false);
            self.depth -= 1;
            self.trivia();
            if self.raw == Raw::ParenClose {
                self.bump(SyntaxKind::Punctuation);
            } else {
                let message = format!("{} where `)` ends the repeated values", self.shown());
                self.error(Problem::P2024, self.position, self.end, message);
            }
            return Some(Initial::Repeat { count, values, span: self.span(start, self.position) });
        }
        if self.at_constant() {
            return Some(Initial::Value(self.constant()));
        }
        if let Some(value) = self.named_number() {
            return Some(value);
        }
        let message = format!("{} where a constant stands, such as 5, TRUE, W#16#00FF or 3 (0)", self.shown());
        self.error(Problem::P2024, self.position, self.end, message);
        if self.keyword().is_some() || !matches!(self.raw, Raw::Word | Raw::Symbol | Raw::Local) {
            return None;
        }
        let (start, end) = self.bump(SyntaxKind::Unexpected);
        Some(Initial::Value(Constant { value: None, extended: false, span: self.span(start, end) }))
    }

    /// `T 5`, `Z 6`, `DB 5`, `SDB 1` or a symbol: what a TIMER, a COUNTER or a BLOCK_DB holds. Nothing is taken if it is none of them.
    fn named_number(&mut self) -> Option<Initial> {
        let start = self.position;
        let operand = match self.raw {
            Raw::Symbol => Operand::Symbol { name: self.name_word(SyntaxKind::Symbol), path: Vec::new() },
            Raw::Word if self.keyword().is_none() => {
                let word = self.current();
                let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
                match letters.eq_ignore_ascii_case("SDB") {
                    true => self.system_data_block(letters.len())?,
                    false => self.address()?,
                }
            }
            _ => return None,
        };
        // No other word of a data block tells the mnemonic language: both are taken.
        self.foreign.clear();
        Some(Initial::Number { operand, span: self.span(start, self.position) })
    }

    /// `SDB 5` or `SDB5`.
    fn system_data_block(&mut self, letters: usize) -> Option<Operand> {
        let start = self.position;
        let at = if letters < self.current().len() { start + letters } else { self.behind_blanks(self.end) };
        let digits = self.text[at..].bytes().take_while(u8::is_ascii_digit).count();
        if digits == 0 {
            return None;
        }
        let number = self.slice(at, at + digits).parse().unwrap_or(u64::MAX);
        self.bump_to(SyntaxKind::AddressLetters, start + letters);
        self.blanks();
        self.bump_to(SyntaxKind::Number, at + digits);
        Some(Operand::Absolute { letters: "SDB".to_owned(), number, bit: None })
    }

    /// The BEGIN section of a data block.
    pub(super) fn assignments(&mut self, block: &mut Block) {
        loop {
            self.trivia();
            match self.keyword() {
                Some(Keyword::BlockStart(_) | Keyword::BlockEnd(_)) => return,
                _ if self.raw == Raw::End => return,
                _ => {}
            }
            match self.raw {
                Raw::Semicolon => {
                    self.bump(SyntaxKind::Semicolon);
                }
                Raw::Word | Raw::Local | Raw::Symbol if self.keyword().is_none() => {
                    let start = self.position;
                    self.start(SyntaxKind::Assignment);
                    let mut path = vec![PathElement::Field(self.name_word(SyntaxKind::Name))];
                    self.path(&mut path);
                    self.blanks();
                    let mut values = Vec::new();
                    if self.becomes() {
                        values = self.initials(true);
                    } else {
                        let message = format!("{} where an assignment goes on with `:=`", self.shown());
                        self.error(Problem::P2017, self.position, self.end, message);
                        self.skip_statement();
                    }
                    block.assignments.push(Assignment { path, values, span: self.span(start, self.position) });
                    self.statement_end();
                    self.finish();
                }
                _ => {
                    let message = format!("{} is no assignment; a data block holds lines such as `name := 5;` here", self.shown());
                    self.error(Problem::P2017, self.position, self.end, message);
                    self.skip_declaration();
                }
            }
        }
    }
}
