//! Blocks: headers, declarations, types, initial values, data block assignments.

use sieben_model::block::BlockKind;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::Section;
use sieben_model::problems::Problem;

use super::Parser;
use crate::stl::ast::{
    Assignment, Block, BlockName, Constant, Declaration, File, Header, Initial, Network, PathElement, TypeKind, TypeName, VarSection, Word,
};
use crate::stl::lexer::{Raw, token, trim_blanks};
use crate::stl::syntax::SyntaxKind;

/// The keywords that begin and end blocks.
const BLOCKS: [(&str, &str, BlockKind); 5] = [
    ("ORGANIZATION_BLOCK", "END_ORGANIZATION_BLOCK", BlockKind::OrganizationBlock),
    ("FUNCTION_BLOCK", "END_FUNCTION_BLOCK", BlockKind::FunctionBlock),
    ("FUNCTION", "END_FUNCTION", BlockKind::Function),
    ("DATA_BLOCK", "END_DATA_BLOCK", BlockKind::DataBlock),
    ("TYPE", "END_TYPE", BlockKind::UserDefinedType),
];

const SECTIONS: [(&str, Section); 5] = [
    ("VAR_INPUT", Section::Input),
    ("VAR_OUTPUT", Section::Output),
    ("VAR_IN_OUT", Section::InOut),
    ("VAR", Section::Static),
    ("VAR_TEMP", Section::Temp),
];

const HEADER_FLAGS: [&str; 6] = ["KNOW_HOW_PROTECT", "READ_ONLY", "UNLINKED", "NON_RETAIN", "STANDARD", "CODE_VERSION1"];

const HEADER_FIELDS: [&str; 4] = ["AUTHOR", "FAMILY", "NAME", "VERSION"];

/// What a word means where declarations or statements may stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Keyword {
    BlockStart(usize),
    BlockEnd(usize),
    Section(Section),
    EndVar,
    Struct,
    EndStruct,
    Begin,
    Network,
    Title,
}

fn keyword_of(word: &str) -> Option<Keyword> {
    let is = |keyword: &str| word.eq_ignore_ascii_case(keyword);
    // Every keyword is longer than most instructions: one comparison of lengths spares the table.
    if word.len() < 3 {
        return None;
    }
    if let Some(index) = BLOCKS.iter().position(|&(start, ..)| is(start)) {
        return Some(Keyword::BlockStart(index));
    }
    if let Some(index) = BLOCKS.iter().position(|&(_, end, _)| is(end)) {
        return Some(Keyword::BlockEnd(index));
    }
    if let Some(&(_, section)) = SECTIONS.iter().find(|&&(name, _)| is(name)) {
        return Some(Keyword::Section(section));
    }
    [
        ("END_VAR", Keyword::EndVar),
        ("STRUCT", Keyword::Struct),
        ("END_STRUCT", Keyword::EndStruct),
        ("BEGIN", Keyword::Begin),
        ("NETWORK", Keyword::Network),
        ("TITLE", Keyword::Title),
    ]
    .into_iter()
    .find_map(|(name, keyword)| is(name).then_some(keyword))
}

fn new_block(kind: BlockKind, name: BlockName, implicit: bool, span: sieben_model::source::Span) -> Block {
    Block {
        kind,
        name,
        implicit,
        return_type: None,
        header: Header::default(),
        sections: Vec::new(),
        body_type: None,
        assignments: Vec::new(),
        statements: Vec::new(),
        networks: Vec::new(),
        span,
    }
}

impl Parser<'_> {
    /// The keyword at the current word, unless a colon makes it a name.
    pub(super) fn keyword(&self) -> Option<Keyword> {
        if self.raw != Raw::Word {
            return None;
        }
        let keyword = keyword_of(self.current())?;
        match self.raw_behind_blanks() {
            // A block that has lost its name; no label is as long as the word.
            Raw::Colon if matches!(keyword, Keyword::BlockStart(_)) && self.current().len() > super::statements::LABEL_MAX => Some(keyword),
            Raw::Colon | Raw::Becomes | Raw::Comma => None,
            _ => Some(keyword),
        }
    }

    /// The whole source.
    pub(super) fn source(&mut self) -> File {
        let mut file = File::default();
        let mut implicit: Option<(usize, Block)> = None;
        loop {
            self.trivia();
            match self.keyword() {
                _ if self.raw == Raw::End => break,
                Some(Keyword::BlockStart(index)) => {
                    let block = self.block(index);
                    file.blocks.push(block);
                }
                Some(Keyword::BlockEnd(_)) => {
                    let message = format!("{} ends a block, but none is open here", self.shown());
                    self.error(Problem::P2013, self.position, self.end, message);
                    self.bump(SyntaxKind::Keyword);
                    self.statement_end();
                }
                _ => {
                    let start = self.position;
                    let span = self.span(start, start);
                    let outer = std::mem::take(&mut self.declared);
                    let (_, block) = implicit.get_or_insert_with(|| {
                        let name = BlockName::Absolute { kind: BlockKind::OrganizationBlock, number: 1, span };
                        (file.blocks.len(), new_block(BlockKind::OrganizationBlock, name, true, span))
                    });
                    self.code(block);
                    block.span = block.span.to(self.span(start, self.position));
                    self.declared = outer;
                }
            }
        }
        if let Some((index, mut block)) = implicit {
            self.check_labels(&mut block);
            file.blocks.insert(index, block);
        }
        file
    }

    fn block(&mut self, index: usize) -> Block {
        let (keyword, end_keyword, kind) = BLOCKS[index];
        let start = self.position;
        self.start(SyntaxKind::Block);
        self.declared.clear();
        self.comments.clear();
        let keyword_place = self.bump(SyntaxKind::Keyword);
        self.blanks();
        let name = self.block_name(keyword, kind);
        let mut block = new_block(kind, name, false, self.span(start, start));
        self.blanks();
        if self.raw == Raw::Colon {
            self.bump(SyntaxKind::Punctuation);
            self.blanks();
            block.return_type = Some(self.type_name());
        }
        let data = matches!(kind, BlockKind::DataBlock | BlockKind::UserDefinedType);
        if !data {
            self.end_of_first_line();
        }
        self.header(&mut block, data);
        if self.keyword() == Some(Keyword::Begin) {
            self.bump(SyntaxKind::Keyword);
            self.blanks();
            if self.raw == Raw::Semicolon {
                self.bump(SyntaxKind::Semicolon);
            }
        }
        match data {
            true => self.assignments(&mut block),
            false => self.code(&mut block),
        }
        self.trivia();
        match self.keyword() {
            Some(Keyword::BlockEnd(end)) => {
                if end != index {
                    let span = self.span(self.position, self.end);
                    let message = format!("{} ends another kind of block; this one ends with `{end_keyword}`", self.shown());
                    let opened = self.span(keyword_place.0, keyword_place.1);
                    self.report(
                        Diagnostic::new(Problem::P2012, span, message)
                            .fix(span, end_keyword, format!("write `{end_keyword}`"))
                            .related(opened, "it begins here"),
                    );
                }
                self.bump(SyntaxKind::Keyword);
                block.span = self.span(start, self.position);
                let behind = self.behind_blanks(self.position);
                if token(self.text, behind).0 == Raw::Semicolon {
                    self.blanks();
                    self.bump(SyntaxKind::Semicolon);
                }
            }
            _ => {
                let message = format!("this {keyword} has no `{end_keyword}`");
                self.error(Problem::P2011, keyword_place.0, keyword_place.1, message);
                block.span = self.span(start, self.position);
            }
        }
        self.finish();
        self.check_labels(&mut block);
        block
    }

    /// What stands behind name and type on their line must belong to the header.
    fn end_of_first_line(&mut self) {
        self.blanks();
        let belongs = match self.raw {
            Raw::BraceOpen => true,
            Raw::Word => {
                self.keyword().is_some()
                    || HEADER_FLAGS.iter().chain(&HEADER_FIELDS).any(|word| self.at_word(word))
                    || self.raw_behind_blanks() == Raw::Colon
            }
            _ => self.at_statement_end(),
        };
        if !belongs {
            let message = format!("{} does not belong behind the name of a block", self.shown());
            self.error(Problem::P2010, self.position, self.end, message);
            self.skip_statement();
        }
    }

    /// `FC 1`, `FC1`, `"Dosing"`.
    fn block_name(&mut self, keyword: &str, kind: BlockKind) -> BlockName {
        if self.raw == Raw::Symbol {
            return BlockName::Symbol(self.name_word(SyntaxKind::Symbol));
        }
        if let Some((kind, number, start, end)) = self.kind_and_number() {
            return BlockName::Absolute { kind, number, span: self.span(start, end) };
        }
        let (start, end) = (self.position, self.end);
        let message = match self.raw {
            Raw::Newline | Raw::End => format!("{keyword} needs a name: `{} 1` or a symbol in quotes", kind.abbreviation()),
            _ => format!("{} names no block; write `{} 1` or a symbol in quotes", self.shown(), kind.abbreviation()),
        };
        self.error(Problem::P2010, start, end, message);
        if self.raw == Raw::Word && self.keyword().is_none() {
            return BlockName::Symbol(self.name_word(SyntaxKind::Name));
        }
        BlockName::Symbol(Word { text: String::new(), span: self.span(start, start) })
    }

    /// `FC 1` or `FC1`: kind, number and place. Nothing is taken if it is something else.
    pub(super) fn kind_and_number(&mut self) -> Option<(BlockKind, u64, usize, usize)> {
        if self.raw != Raw::Word {
            return None;
        }
        let word = self.current();
        let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
        let kind = BlockKind::from_abbreviation(letters)?;
        let start = self.position;
        if letters.len() < word.len() {
            let number = word[letters.len()..].parse().unwrap_or(u64::MAX);
            self.bump_to(SyntaxKind::AddressLetters, start + letters.len());
            let end = start + word.len();
            self.bump_to(SyntaxKind::Number, end);
            return Some((kind, number, start, end));
        }
        let at = self.behind_blanks(self.end);
        if let Some((number, end)) = self.negative_number(letters, at) {
            self.bump(SyntaxKind::AddressLetters);
            self.blanks();
            self.bump_to(SyntaxKind::Number, end);
            return Some((kind, number, start, end));
        }
        let (raw, end) = token(self.text, at);
        if raw != Raw::Number || !self.text[at..end].bytes().all(|byte| byte.is_ascii_digit()) {
            return None;
        }
        self.bump(SyntaxKind::AddressLetters);
        self.blanks();
        let number = self.current().parse().unwrap_or(u64::MAX);
        let (_, end) = self.bump(SyntaxKind::Number);
        Some((kind, number, start, end))
    }

    /// Everything between the name and BEGIN.
    fn header(&mut self, block: &mut Block, data: bool) {
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
        self.blanks();
        let rest = &self.text[self.position..];
        let end = match self.raw {
            Raw::Characters => self.end,
            _ => self.position + rest.find(|c: char| c.is_whitespace() || c == ';').unwrap_or(rest.len()),
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

    /// `TITLE = text to the end of the line`.
    fn title(&mut self) -> Word {
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
    fn attributes(&mut self) -> Vec<(Word, Word)> {
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
    fn declarations(&mut self, outermost: bool) -> Vec<Declaration> {
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
        } else {
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

    fn type_name(&mut self) -> TypeName {
        let start = self.position;
        self.start(SyntaxKind::TypeName);
        let kind = if self.deeper() {
            let kind = self.type_kind();
            self.depth -= 1;
            kind
        } else {
            TypeKind::Missing
        };
        self.finish();
        TypeName { kind, span: self.span(start, self.position.max(start)) }
    }

    fn type_kind(&mut self) -> TypeKind {
        match self.raw {
            Raw::Symbol => return TypeKind::Symbol(self.name_word(SyntaxKind::Symbol).text),
            Raw::Word => {}
            _ => {
                let message = format!("{} is no data type; a type such as INT, STRUCT or ARRAY [1..5] OF INT stands here", self.shown());
                self.error(Problem::P2021, self.position, self.end, message);
                return TypeKind::Missing;
            }
        }
        if self.at_word("STRUCT") {
            return self.structure();
        }
        if self.keyword().is_some() {
            let message = format!("the data type is missing before {}", self.shown());
            self.error(Problem::P2021, self.position, self.end, message);
            return TypeKind::Missing;
        }
        if self.at_word("ARRAY") {
            return self.array();
        }
        if self.at_word("STRING") {
            self.bump(SyntaxKind::Keyword);
            let bracket = self.behind_blanks(self.position);
            if token(self.text, bracket).0 != Raw::BracketOpen {
                return TypeKind::String(None);
            }
            self.blanks();
            self.bump(SyntaxKind::Punctuation);
            self.blanks();
            let length = self.integer();
            if length.is_none() {
                let message = format!("{} is no length of a STRING; write `STRING [254]`", self.shown());
                self.error(Problem::P2021, self.position, self.end, message);
            }
            self.close_bracket();
            return TypeKind::String(length);
        }
        if let Some((kind, number, ..)) = self.kind_and_number() {
            return TypeKind::Block(kind, number);
        }
        let word = self.current().to_ascii_uppercase();
        self.bump(SyntaxKind::Keyword);
        TypeKind::Word(word)
    }

    fn close_bracket(&mut self) {
        self.blanks();
        if self.raw == Raw::BracketClose {
            self.bump(SyntaxKind::Punctuation);
            return;
        }
        let message = format!("{} where `]` closes the bracket", self.shown());
        self.error(Problem::P2016, self.position, self.end, message);
        while !self.at_statement_end() && self.raw != Raw::BracketClose {
            self.bump_unexpected();
        }
        if self.raw == Raw::BracketClose {
            self.bump(SyntaxKind::Punctuation);
        }
    }

    fn structure(&mut self) -> TypeKind {
        self.start(SyntaxKind::Struct);
        let keyword = self.bump(SyntaxKind::Keyword);
        let declarations = self.declarations(false);
        if self.keyword() == Some(Keyword::EndStruct) {
            self.bump(SyntaxKind::Keyword);
        } else {
            self.error(Problem::P2023, keyword.0, keyword.1, "this STRUCT has no `END_STRUCT`");
        }
        self.finish();
        TypeKind::Struct(declarations)
    }

    /// `ARRAY [1..5, 0..3] OF INT`.
    fn array(&mut self) -> TypeKind {
        self.bump(SyntaxKind::Keyword);
        self.trivia();
        let mut bounds = Vec::new();
        if self.raw == Raw::BracketOpen {
            self.bump(SyntaxKind::Punctuation);
            loop {
                self.trivia();
                let low = self.integer();
                self.trivia();
                let range = self.raw == Raw::Range;
                if range {
                    self.bump(SyntaxKind::Punctuation);
                }
                self.trivia();
                let high = if range { self.integer() } else { None };
                if let (Some(low), Some(high)) = (low, high) {
                    bounds.push((low, high));
                } else {
                    let message = format!("{} where the bounds of an array stand; write `ARRAY [1..5] OF INT`", self.shown());
                    self.error(Problem::P2021, self.position, self.end, message);
                    bounds.clear();
                    while !self.at_statement_end() && self.raw != Raw::BracketClose {
                        self.bump_unexpected();
                    }
                    break;
                }
                self.trivia();
                if self.raw != Raw::Comma {
                    break;
                }
                self.bump(SyntaxKind::Punctuation);
            }
            self.close_bracket();
        } else {
            let message = format!("{} where the bounds of an array stand; write `ARRAY [1..5] OF INT`", self.shown());
            self.error(Problem::P2021, self.position, self.end, message);
        }
        self.trivia();
        if self.at_word("OF") {
            self.bump(SyntaxKind::Keyword);
            self.trivia();
        } else {
            let message = format!("{} where `OF` and the type of the elements stand", self.shown());
            self.error(Problem::P2021, self.position, self.end, message);
            if bounds.is_empty() {
                return TypeKind::Missing;
            }
        }
        let element = Box::new(self.type_name());
        if bounds.is_empty() { TypeKind::Missing } else { TypeKind::Array { bounds, element } }
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
        let message = format!("{} where a constant stands, such as 5, TRUE, W#16#00FF or 3 (0)", self.shown());
        self.error(Problem::P2024, self.position, self.end, message);
        if self.keyword().is_some() || !matches!(self.raw, Raw::Word | Raw::Symbol | Raw::Local) {
            return None;
        }
        let (start, end) = self.bump(SyntaxKind::Unexpected);
        Some(Initial::Value(Constant { value: None, span: self.span(start, end) }))
    }

    /// The BEGIN section of a data block.
    fn assignments(&mut self, block: &mut Block) {
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

    /// `.field[1, 2]` as often as it comes, without blanks.
    pub(super) fn path(&mut self, path: &mut Vec<PathElement>) {
        loop {
            match self.raw {
                Raw::Point => {
                    let (raw, _) = token(self.text, self.end);
                    if !matches!(raw, Raw::Word | Raw::Symbol | Raw::Local | Raw::Number) {
                        let message = "a field name stands behind the point".to_owned();
                        self.error(Problem::P2018, self.position, self.end, message);
                        self.bump(SyntaxKind::Unexpected);
                        return;
                    }
                    self.bump(SyntaxKind::Punctuation);
                    path.push(PathElement::Field(self.name_word(SyntaxKind::Name)));
                }
                Raw::BracketOpen => {
                    let start = self.position;
                    self.bump(SyntaxKind::Punctuation);
                    let mut indices = Vec::new();
                    loop {
                        self.blanks();
                        match self.integer() {
                            Some(index) => indices.push(index),
                            None => {
                                self.no_index();
                                break;
                            }
                        }
                        self.blanks();
                        if self.raw != Raw::Comma {
                            break;
                        }
                        self.bump(SyntaxKind::Punctuation);
                    }
                    self.close_bracket();
                    path.push(PathElement::Index(indices, self.span(start, self.position)));
                }
                _ => return,
            }
        }
    }

    /// Something else than a whole number where an index stands, up to the end of the bracket.
    fn no_index(&mut self) {
        let message = format!("{} is no index; an index is a whole number", self.shown());
        let mut diagnostic = Diagnostic::new(Problem::P2018, self.span(self.position, self.end), message);
        if matches!(self.raw, Raw::Local | Raw::Symbol | Raw::Word) {
            diagnostic =
                diagnostic.help("STL has no variable indices: compute the address, load it with `LAR1`, and access with `[AR1,P#0.0]`");
        }
        self.report(diagnostic);
        while !self.at_statement_end() && !matches!(self.raw, Raw::BracketClose | Raw::Comma | Raw::ParenClose) {
            self.bump_unexpected();
        }
    }

    /// NETWORK with what follows on its line.
    pub(super) fn network(&mut self, block: &mut Block) {
        self.start(SyntaxKind::Network);
        self.comments.clear();
        let (start, end) = self.bump(SyntaxKind::Keyword);
        block.networks.push(Network { first_statement: block.statements.len(), span: self.span(start, end), ..Network::default() });
        self.finish();
    }

    /// TITLE in code: the title of the network before it.
    pub(super) fn network_title(&mut self, block: &mut Block) {
        let title = self.title();
        self.comments.clear();
        match block.networks.last_mut() {
            Some(network) => network.title = title.text,
            None if block.statements.is_empty() && block.header.title.is_none() => block.header.title = Some(title),
            None => {}
        }
    }
}
