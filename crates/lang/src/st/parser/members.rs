//! Methods, properties and actions.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use super::super::ast::{Accessor, Action, Block, BlockKind, Item, Method, Modifiers, Name, Path, Property, TypeKind, TypeSpec};
use super::super::dialect::{Construct, Judgement};
use super::super::keywords::Keyword;
use super::super::lexer::{Raw, Token};
use super::{Parser, SyntaxKind};

impl Parser<'_> {
    /// PUBLIC, ABSTRACT and the like before a name.
    pub(super) fn modifiers(&mut self) -> Modifiers {
        let start = self.here();
        let mut modifiers = Modifiers::default();
        loop {
            // `METHOD final : INT` is a method of that name. Who may use it stands in front of a name, which may be lost.
            let access = ["PUBLIC", "PRIVATE", "PROTECTED", "INTERNAL"].iter().any(|word| self.at_word(word));
            let section = self.next_keyword().is_some_and(Keyword::begins_section);
            if !(self.is_name(self.behind(self.at)) || access && section) {
                break;
            }
            if !modifiers.take(self.current()) {
                break;
            }
            self.bump(SyntaxKind::Keyword);
        }
        if modifiers.is_abstract && modifiers.is_final {
            let span = self.span(start, self.previous);
            let help = "write one of them: what is ABSTRACT is there to be extended";
            self.push(Diagnostic::new(Problem::P6283, span, "ABSTRACT and FINAL exclude one another").help(help));
        }
        modifiers.span = self.span(start, self.previous.max(start));
        modifiers
    }

    /// A word behind the name of a block that stands at the wrong place, or whose EXTENDS or IMPLEMENTS is missing.
    pub(super) fn stray_base(&mut self, block: &mut Block) {
        let alone = self.raw() == Raw::Word && self.keyword().is_none() && !self.on_new_line();
        let begins = matches!(self.next_raw(), Raw::Becomes | Raw::ParenOpen | Raw::Semicolon | Raw::Equal | Raw::Colon);
        if !alone || begins || self.dialect.judge(Construct::ObjectOrientation) == Judgement::Reject {
            return;
        }
        let shown = self.shown();
        if block.modifiers.take(self.current()) {
            self.unexpected(Problem::P2010, format!("{shown} belongs in front of the name of the block"));
            self.bump(SyntaxKind::Keyword);
            return;
        }
        let interface = format!("INTERFACE {}", self.current()).to_ascii_uppercase();
        let interface = self.text.to_ascii_uppercase().contains(&interface);
        let word = if interface { "IMPLEMENTS" } else { "EXTENDS" };
        self.missing(Problem::P2010, &format!(" {word}"), format!("{word} is missing in front of {shown}"));
        let bases = self.names_of_bases();
        *if interface { &mut block.implements } else { &mut block.extends } = bases;
    }

    /// EXTENDS and IMPLEMENTS with their names, if they are there.
    pub(super) fn bases_of(&mut self, block: &mut Block) {
        if self.at_word("EXTENDS") {
            block.extends = self.bases();
        }
        if self.at_word("IMPLEMENTS") {
            block.implements = self.bases();
        }
    }

    /// The names behind EXTENDS or IMPLEMENTS.
    pub(super) fn bases(&mut self) -> Vec<Path> {
        let token = self.token();
        self.judge(Construct::ObjectOrientation, token.start, token.end);
        self.bump(SyntaxKind::Keyword);
        let bases = self.names_of_bases();
        if bases.is_empty() {
            let shown = self.shown();
            self.unexpected(Problem::P2010, format!("a name is wanted behind {}, not {shown}", self.previous_text()));
            return vec![Path { names: Vec::new(), span: self.since(self.previous) }];
        }
        bases
    }

    fn names_of_bases(&mut self) -> Vec<Path> {
        let mut bases = Vec::new();
        while self.at_name() {
            bases.push(self.path(SyntaxKind::TypeWord));
            if !self.eat(Raw::Comma, SyntaxKind::Punctuation) {
                break;
            }
        }
        bases
    }

    /// A member of a block: METHOD, PROPERTY or ACTION, which is the current token unless it is missing.
    pub(super) fn member(&mut self, block: &mut Block, keyword: Keyword) {
        match keyword {
            Keyword::Method => {
                let method = self.method();
                block.methods.push(method);
            }
            Keyword::Property => {
                let property = self.property();
                block.properties.push(property);
            }
            _ => {
                let action = self.action();
                block.actions.push(action);
            }
        }
    }

    /// A member that stands behind its block, as text exports write them.
    pub(super) fn member_behind(&mut self, items: &mut [Item], keyword: Keyword) {
        let owner = items.iter_mut().rev().find_map(|item| match item {
            Item::Block(block) if matches!(block.kind, BlockKind::FunctionBlock | BlockKind::Program | BlockKind::Class) => Some(block),
            _ => None,
        });
        if let Some(block) = owner {
            self.begin_diagrams_of(block);
            self.member(block, keyword);
            self.end_diagrams_of(block);
            return;
        }
        let token = self.token();
        let shown = self.shown();
        self.error(
            Problem::P2019,
            token.start,
            token.end,
            format!("{shown} belongs to a FUNCTION_BLOCK, PROGRAM or CLASS, and none is before it"),
        );
        match keyword {
            Keyword::Method => drop(self.method()),
            Keyword::Property => drop(self.property()),
            _ => drop(self.action()),
        }
    }

    fn method(&mut self) -> Method {
        let attributes = self.take_attributes();
        let token = self.token();
        self.judge(Construct::ObjectOrientation, token.start, token.end);
        self.start(SyntaxKind::Block);
        self.first_keyword();
        let modifiers = self.modifiers();
        let name = self.member_name(token, "METHOD");
        let result = match self.eat(Raw::Colon, SyntaxKind::Punctuation) {
            true => self.result_type(),
            // `METHOD Reset s := 0;` has no result.
            false
                if self.at_name()
                    && !self.on_new_line()
                    && !matches!(self.next_raw(), Raw::Becomes | Raw::ParenOpen | Raw::Point | Raw::BracketOpen) =>
            {
                self.missing(Problem::P2020, " :", format!("`:` is missing between {} and {}", self.previous_text(), self.shown()));
                self.result_type()
            }
            false => None,
        };
        self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
        let owner = self.owner.take();
        let (sections, body) = self.sections_and_body();
        self.owner = owner;
        let last = self.token();
        self.block_end(Keyword::EndMethod, token.start, "METHOD");
        let end = self.span(last.start.min(self.previous), self.previous);
        self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
        let span = self.since(token.start);
        self.finish();
        Method { name, modifiers, attributes, result, sections, body, end, span }
    }

    /// The name of a member that begins with this token; its keyword may be missing.
    fn member_name(&mut self, first: Token, what: &str) -> Name {
        let lost = first.keyword.is_none() && self.at_name();
        if lost { self.name(SyntaxKind::Declared) } else { self.block_name(what) }
    }

    /// VAR sections and statements up to an end keyword of a block.
    fn sections_and_body(&mut self) -> (Vec<super::super::ast::VarSection>, Vec<super::super::ast::Statement>) {
        let (mut sections, mut body) = (Vec::new(), Vec::new());
        loop {
            match self.keyword() {
                Some(keyword) if keyword.begins_section() && keyword != Keyword::Label => {
                    let section = self.section();
                    sections.push(section);
                }
                _ if self.at_body_end() => return (sections, body),
                _ if self.raw() == Raw::DiagramWord => self.diagram_into(&mut body, &mut Vec::new()),
                _ if self.begins_lost_declarations(&body) => {
                    let section = self.lost_section();
                    sections.push(section);
                }
                _ => self.statement_into(&mut body),
            }
        }
    }

    fn property(&mut self) -> Property {
        let attributes = self.take_attributes();
        let token = self.token();
        self.judge(Construct::Property, token.start, token.end);
        self.start(SyntaxKind::Block);
        self.first_keyword();
        let modifiers = self.modifiers();
        let name = self.member_name(token, "PROPERTY");
        let data_type = match self.eat(Raw::Colon, SyntaxKind::Punctuation) {
            true if self.on_new_line() && (self.at_word("GET") || self.at_word("SET")) => {
                self.report(Diagnostic::new(Problem::P2021, self.last_character(), "the type of the property is missing behind `:`"));
                TypeSpec { kind: TypeKind::Missing, span: self.since(self.previous) }
            }
            true => self.type_spec(),
            false if self.at_name() && !self.on_new_line() => {
                self.missing(Problem::P2020, " :", format!("`:` is missing between {} and {}", self.previous_text(), self.shown()));
                self.type_spec()
            }
            false => {
                self.missing(Problem::P2020, " : INT", "`:` with the type of the property is missing");
                TypeSpec { kind: TypeKind::Missing, span: self.since(self.previous) }
            }
        };
        self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
        let (mut get, mut set) = (None, None);
        loop {
            let before = self.at;
            if self.at_word("GET") {
                get = Some(self.accessor(Keyword::EndGet));
            } else if self.at_word("SET") {
                set = Some(self.accessor(Keyword::EndSet));
            } else if let Some(end) = self.lost_accessor() {
                let accessor = self.accessor_behind(end);
                *if end == Keyword::EndGet { &mut get } else { &mut set } = Some(accessor);
            } else {
                break;
            }
            if self.at == before {
                break;
            }
        }
        self.block_end(Keyword::EndProperty, token.start, "PROPERTY");
        self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
        let span = self.since(token.start);
        self.finish();
        Property { name, modifiers, attributes, data_type, get, set, span }
    }

    fn accessor(&mut self, end: Keyword) -> Accessor {
        let start = self.here();
        self.start(SyntaxKind::Block);
        self.bump(SyntaxKind::Keyword);
        self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
        let accessor = self.accessor_inside(start, end);
        self.finish();
        accessor
    }

    /// An accessor whose GET or SET is missing.
    fn accessor_behind(&mut self, end: Keyword) -> Accessor {
        let start = self.here();
        self.start(SyntaxKind::Block);
        let accessor = self.accessor_inside(start, end);
        self.finish();
        accessor
    }

    fn accessor_inside(&mut self, start: u32, end: Keyword) -> Accessor {
        let (mut sections, mut body) = (Vec::new(), Vec::new());
        let owner = self.owner.take();
        loop {
            // Without END_GET, SET begins the next accessor and END_PROPERTY ends it.
            let next =
                (self.at_word("SET") || self.at_word("GET")) && !matches!(self.next_raw(), Raw::Becomes | Raw::ParenOpen | Raw::Point);
            match self.keyword() {
                _ if next => break,
                Some(keyword) if keyword.begins_section() && keyword != Keyword::Label => {
                    let section = self.section();
                    sections.push(section);
                }
                _ if self.at_body_end() => break,
                _ if self.raw() == Raw::DiagramWord => self.diagram_into(&mut body, &mut Vec::new()),
                _ => self.statement_into(&mut body),
            }
        }
        self.owner = owner;
        if self.eat_keyword(end) {
            self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
        }
        Accessor { sections, body, span: self.since(start) }
    }

    fn action(&mut self) -> Action {
        let token = self.token();
        self.judge(Construct::Action, token.start, token.end);
        self.take_attributes();
        self.start(SyntaxKind::Block);
        self.first_keyword();
        let name = self.member_name(token, "ACTION");
        self.eat(Raw::Colon, SyntaxKind::Punctuation);
        self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
        let (_, body) = self.sections_and_body();
        self.block_end(Keyword::EndAction, token.start, "ACTION");
        self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
        let span = self.since(token.start);
        self.finish();
        Action { name, body, span }
    }
}
