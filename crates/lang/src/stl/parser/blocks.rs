//! Sources and their blocks: where each begins and ends, its name, its networks.

use sieben_model::block::BlockKind;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::Section;
use sieben_model::problems::Problem;

use super::Parser;
use crate::stl::ast::{Block, BlockName, File, Header, Network, Word};
use crate::stl::lexer::{Raw, token};
use crate::stl::syntax::SyntaxKind;

/// The keywords that begin and end blocks.
pub(in crate::stl) const BLOCKS: [(&str, &str, BlockKind); 5] = [
    ("ORGANIZATION_BLOCK", "END_ORGANIZATION_BLOCK", BlockKind::OrganizationBlock),
    ("FUNCTION_BLOCK", "END_FUNCTION_BLOCK", BlockKind::FunctionBlock),
    ("FUNCTION", "END_FUNCTION", BlockKind::Function),
    ("DATA_BLOCK", "END_DATA_BLOCK", BlockKind::DataBlock),
    ("TYPE", "END_TYPE", BlockKind::UserDefinedType),
];

/// The keywords that begin sections of declarations.
pub(in crate::stl) const SECTIONS: [(&str, Section); 5] = [
    ("VAR_INPUT", Section::Input),
    ("VAR_OUTPUT", Section::Output),
    ("VAR_IN_OUT", Section::InOut),
    ("VAR", Section::Static),
    ("VAR_TEMP", Section::Temp),
];

/// The other keywords.
pub(in crate::stl) const OTHERS: [(&str, Keyword); 6] = [
    ("END_VAR", Keyword::EndVar),
    ("STRUCT", Keyword::Struct),
    ("END_STRUCT", Keyword::EndStruct),
    ("BEGIN", Keyword::Begin),
    ("NETWORK", Keyword::Network),
    ("TITLE", Keyword::Title),
];

/// What a word means where declarations or statements may stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::stl) enum Keyword {
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

pub(super) fn keyword_of(word: &str) -> Option<Keyword> {
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
    OTHERS.iter().find_map(|&(name, keyword)| is(name).then_some(keyword))
}

/// Whether a word begins or ends a block, a section or the statements.
pub(in crate::stl) fn is_keyword(word: &str) -> bool {
    keyword_of(word).is_some()
}

pub(super) fn new_block(kind: BlockKind, name: BlockName, implicit: bool, span: sieben_model::source::Span) -> Block {
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
            if self.drawing.is_none() && self.at_heading() {
                if let Some(block) = self.headed_block() {
                    file.blocks.push(block);
                }
                continue;
            }
            if self.drawing.is_none() && self.raw != Raw::End && self.printed_line() {
                continue;
            }
            match self.keyword() {
                _ if self.raw == Raw::End => break,
                Some(Keyword::BlockStart(index)) => {
                    self.end_headed();
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
                    self.block_start = start;
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
        self.end_headed();
        if let Some((index, mut block)) = implicit {
            self.check_labels(&mut block);
            file.blocks.insert(index, block);
        }
        file
    }

    fn block(&mut self, index: usize) -> Block {
        let (keyword, end_keyword, kind) = BLOCKS[index];
        let start = self.position;
        self.block_start = start;
        self.start(SyntaxKind::Block);
        self.declared.clear();
        self.comments.clear();
        self.generated_labels = 0;
        self.memories.clear();
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
            Raw::Word => self.keyword().is_some() || self.at_header_word() || self.raw_behind_blanks() == Raw::Colon,
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

    /// NETWORK with what follows on its line.
    pub(super) fn network(&mut self, block: &mut Block) {
        self.start(SyntaxKind::Network);
        self.comments.clear();
        let (start, end) = self.bump(SyntaxKind::Keyword);
        let drawing = self.notation();
        block.networks.push(Network {
            first_statement: block.statements.len(),
            span: self.span(start, end),
            drawing,
            ..Network::default()
        });
        self.finish();
        self.numbered_network(start, block);
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
