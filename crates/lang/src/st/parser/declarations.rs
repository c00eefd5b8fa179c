//! VAR sections, declarations, initial values.

use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::problems::Problem;

use super::super::ast::{
    Access, Attribute, Declaration, DeclaredName, Edge, Expression, ExpressionKind, Initializer, InitializerKind, Location, Name,
    Qualifier, SectionKind, TypeKind, TypeSpec, VarSection,
};
use super::super::dialect::Construct;
use super::super::keywords::Keyword;
use super::super::lexer::Raw;
use super::expressions::key;
use super::{Parser, SyntaxKind};

/// The words behind VAR, and the constructs that they are.
#[rustfmt::skip] // A table.
const QUALIFIERS: &[(&str, Qualifier, Option<Construct>)] = &[
    ("CONSTANT", Qualifier::Constant, Some(Construct::VarConstant)),
    ("RETAIN", Qualifier::Retain, Some(Construct::Retain)),
    ("NON_RETAIN", Qualifier::NonRetain, Some(Construct::Retain)),
    ("PERSISTENT", Qualifier::Persistent, Some(Construct::Persistent)),
    ("DB_SPECIFIC", Qualifier::DbSpecific, Some(Construct::DbSpecific)),
    ("PUBLIC", Qualifier::Access(Access::Public), None),
    ("PRIVATE", Qualifier::Access(Access::Private), None),
    ("PROTECTED", Qualifier::Access(Access::Protected), None),
    ("INTERNAL", Qualifier::Access(Access::Internal), None),
];

/// Where declarations stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    Section(SectionKind),
    Struct,
}

/// Whether a message says that a declaration lacks its name: all else that is missing in one has a fix.
pub(in crate::st) fn name_is_lost(diagnostic: &Diagnostic) -> bool {
    diagnostic.problem == Problem::P2020 && diagnostic.fix.is_none()
}

impl Parser<'_> {
    /// A VAR section; the current token is its keyword.
    pub(super) fn section(&mut self) -> VarSection {
        let attributes = self.take_attributes();
        let reported = self.diagnostics.len();
        self.start(SyntaxKind::Section);
        let token = self.token();
        let (kind, construct) = match token.keyword {
            Some(Keyword::VarInput) => (SectionKind::Input, None),
            Some(Keyword::VarOutput) => (SectionKind::Output, None),
            Some(Keyword::VarInOut) => (SectionKind::InOut, None),
            Some(Keyword::VarTemp) => (SectionKind::Temp, None),
            Some(Keyword::VarStat) => (SectionKind::Static, Some(Construct::StaticSection)),
            Some(Keyword::VarInst) => (SectionKind::Instance, Some(Construct::StaticSection)),
            Some(Keyword::VarGlobal) => (SectionKind::Global, Some(Construct::GlobalVariables)),
            Some(Keyword::VarExternal) => (SectionKind::External, Some(Construct::GlobalVariables)),
            Some(Keyword::VarConfig) => (SectionKind::Config, Some(Construct::Configuration)),
            Some(Keyword::VarAccess) => (SectionKind::Access, Some(Construct::Configuration)),
            Some(Keyword::Const) => (SectionKind::Const, Some(Construct::ConstSection)),
            _ => (SectionKind::Var, None),
        };
        if let Some(construct) = construct {
            self.judge(construct, token.start, token.end);
        }
        self.bump(SyntaxKind::Keyword);
        let mut section = VarSection {
            kind,
            qualifiers: Vec::new(),
            name: None,
            attributes,
            declarations: Vec::new(),
            partial: false,
            nameless: false,
            span: self.since(token.start),
        };
        if kind != SectionKind::Const {
            self.qualifiers(&mut section);
        }
        self.declarations(&mut section.declarations, Place::Section(kind));
        let end = if kind == SectionKind::Const { Keyword::EndConst } else { Keyword::EndVar };
        self.section_end(end, token.start);
        section.span = self.since(token.start);
        section.partial = self.diagnostics.iter().skip(reported).any(|one| one.severity() == Severity::Error);
        section.nameless = self.diagnostics.iter().skip(reported).any(name_is_lost);
        self.finish();
        section
    }

    /// Declarations whose VAR is missing.
    pub(super) fn lost_section(&mut self) -> VarSection {
        let token = self.token();
        let (start, at) = (token.start, self.span(token.start, token.start));
        let message = "`VAR` is missing before these declarations";
        let span = self.span(start, token.end);
        self.report(Diagnostic::new(Problem::P2020, span, message).fix(at, "VAR ", "write `VAR`"));
        self.start(SyntaxKind::Section);
        let mut section = VarSection {
            kind: SectionKind::Var,
            qualifiers: Vec::new(),
            name: None,
            attributes: Vec::new(),
            declarations: Vec::new(),
            partial: true,
            nameless: false,
            span: self.since(start),
        };
        self.qualifiers(&mut section);
        self.declarations(&mut section.declarations, Place::Section(SectionKind::Var));
        self.section_end(Keyword::EndVar, start);
        self.finish();
        section.span = self.since(start);
        section
    }

    /// Whether a word such as CONSTANT, which stands behind VAR, begins this line, and declarations stand behind it.
    pub(super) fn at_lost_qualifier(&self) -> bool {
        let next = self.behind(self.at);
        let declares = self.is_name(next) && matches!(self.tokens[self.behind(next)].raw, Raw::Colon | Raw::Comma);
        declares && QUALIFIERS.iter().any(|(word, ..)| self.at_word(word))
    }

    fn qualifiers(&mut self, section: &mut VarSection) {
        loop {
            let found = QUALIFIERS.iter().find(|(word, ..)| self.at_word(word));
            // `retain : BOOL` is a variable.
            let Some(&(_, qualifier, construct)) = found.filter(|_| !matches!(self.next_raw(), Raw::Colon | Raw::Comma)) else { break };
            let token = self.token();
            if let Some(construct) = construct {
                self.judge(construct, token.start, token.end);
            }
            let retains = |qualifier: Qualifier| matches!(qualifier, Qualifier::Retain | Qualifier::NonRetain);
            let odd = match section.kind {
                SectionKind::InOut | SectionKind::Temp => retains(qualifier) || qualifier == Qualifier::Constant,
                SectionKind::Input | SectionKind::Output => qualifier == Qualifier::Constant,
                _ => {
                    let constant = |one: Qualifier| one == Qualifier::Constant;
                    let other = |test: &dyn Fn(Qualifier) -> bool| section.qualifiers.iter().any(|&(one, _)| test(one));
                    retains(qualifier) && other(&constant) || constant(qualifier) && other(&retains)
                }
            };
            if odd {
                self.judge(Construct::SectionQualifier, token.start, token.end);
            }
            let span = self.bump(SyntaxKind::Keyword);
            section.qualifiers.push((qualifier, span));
        }
        // Exports of V2.3 write the name of the list behind VAR_GLOBAL.
        let next_line = |parser: &Self| {
            parser.text[parser.token().end as usize..parser.tokens[parser.behind(parser.at)].start as usize].contains(['\n', '\r'])
        };
        if section.kind == SectionKind::Global && self.at_name() && !self.on_new_line() && next_line(self) {
            section.name = Some(self.name(SyntaxKind::Declared));
        }
    }

    /// Takes the end keyword of a section, or says what is wrong.
    pub(super) fn section_end(&mut self, wanted: Keyword, start: u32) {
        if self.eat_keyword(wanted) {
            // Some write `;` behind it.
            if matches!(wanted, Keyword::EndVar | Keyword::EndConst | Keyword::EndLabel) {
                self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
            }
            return;
        }
        let word = wanted.word();
        let other = matches!(
            self.keyword(),
            Some(Keyword::EndVar | Keyword::EndConst | Keyword::EndLabel | Keyword::EndStruct | Keyword::EndUnion)
        );
        if other {
            let token = self.token();
            let span = self.span(token.start, token.end);
            let message = format!("{} stands where the declarations end with `{word}`", self.shown());
            self.slip(Problem::P6058, span, word, message);
            self.bump(SyntaxKind::Keyword);
            return;
        }
        let begun = self.span(start, start);
        let shown = self.shown();
        let place = self.last_character();
        let message = format!("`{word}` is missing before {shown}");
        let at = self.span(self.previous, self.previous);
        self.report(Diagnostic::new(Problem::P2023, place, message).related(begun, "the declarations begin here").fix(
            at,
            format!("\n{word}"),
            format!("write `{word}`"),
        ));
    }

    /// Declarations up to a keyword that ends them.
    pub(super) fn declarations(&mut self, declarations: &mut Vec<Declaration>, place: Place) {
        while !self.at_declarations_end(place) {
            let before = self.at;
            self.start(SyntaxKind::Declaration);
            if let Some(declaration) = self.declaration(place) {
                if matches!(place, Place::Section(_)) {
                    self.declared.extend(declaration.names.iter().map(|name| key(&name.name.text)));
                }
                declarations.push(declaration);
            }
            self.finish();
            if self.at == before {
                let shown = self.shown();
                self.unexpected(Problem::P2020, format!("{shown} begins no declaration, which is written `name : INT;`"));
                self.bump_unexpected();
            }
        }
    }

    fn at_declarations_end(&self, place: Place) -> bool {
        if self.raw() == Raw::End {
            return true;
        }
        if let Some(keyword) = self.keyword() {
            // A keyword as a name is reported as such.
            if matches!(self.next_raw(), Raw::Colon | Raw::Comma) {
                return false;
            }
            return keyword.is_end()
                || keyword.begins_block()
                || keyword.begins_section()
                || keyword.begins_statement()
                || matches!(keyword, Keyword::Begin | Keyword::Method | Keyword::Property | Keyword::Action | Keyword::Resource);
        }
        // Statements begin: the end of the section is missing. Behind VAR_CONFIG there are none.
        let constant = matches!(place, Place::Section(SectionKind::Const | SectionKind::Config));
        let statement = self.at_name() && !constant && place != Place::Struct;
        statement && self.is_statement_start()
    }

    /// `x := …`, `f(…)`, `a.b`, `a[1]` where a declaration should begin.
    fn is_statement_start(&self) -> bool {
        let next = self.behind(self.at);
        match self.tokens[next].raw {
            Raw::ParenOpen => true,
            // `x S= y`.
            Raw::Word => self.tokens.get(next + 1).is_some_and(|token| token.raw == Raw::Equal),
            Raw::Becomes | Raw::BracketOpen | Raw::Point => {
                // `x := INT;` is a slip of a declaration, as `x. : INT` is.
                let mut index = next;
                while !matches!(self.tokens[index].raw, Raw::End | Raw::Semicolon | Raw::Colon) {
                    index += 1;
                }
                let to_end = self.tokens[index].raw == Raw::Semicolon && self.no_end_var_behind(index);
                self.tokens[next].raw != Raw::Becomes && self.tokens[index].raw != Raw::Colon || to_end
            }
            _ => false,
        }
    }

    /// Whether statements and no END_VAR follow.
    fn no_end_var_behind(&self, index: usize) -> bool {
        let keyword = self.tokens[index..].iter().find_map(|token| {
            token.keyword.filter(|keyword| !matches!(keyword, Keyword::Array | Keyword::Of | Keyword::True | Keyword::False))
        });
        keyword != Some(Keyword::EndVar)
    }

    fn declaration(&mut self, place: Place) -> Option<Declaration> {
        let mut attributes = self.take_attributes();
        let start = self.here();
        if self.raw() == Raw::Semicolon {
            self.bump(SyntaxKind::Semicolon);
            return None;
        }
        let constant = matches!(place, Place::Section(SectionKind::Const));
        let mut names = Vec::new();
        loop {
            // `a, , b : INT`: the others are declared all the same. What is in `: STRUCT a : INT; END_STRUCT` is read.
            let with_parts = matches!(self.next_keyword(), Some(Keyword::Struct | Keyword::Array));
            let lost = self.raw() == Raw::Comma || self.raw() == Raw::Colon && (!names.is_empty() || with_parts);
            if lost {
                let shown = self.shown();
                self.unexpected(Problem::P2020, format!("the name of a variable is wanted here, not {shown}"));
            } else {
                names.push(self.declared(place)?);
            }
            if self.eat(Raw::Comma, SyntaxKind::Punctuation) {
                continue;
            }
            let another = !lost && self.at_name() && !self.on_new_line() && matches!(self.next_raw(), Raw::Comma | Raw::Colon);
            if !another {
                break;
            }
            self.missing(Problem::P2020, ",", format!("`,` is missing between {} and {}", self.previous_text(), self.shown()));
        }
        let location = self.location();
        let mut declaration = Declaration {
            names,
            attributes: Vec::new(),
            location,
            data_type: TypeSpec { kind: TypeKind::Inferred, span: self.since(self.previous) },
            edge: None,
            initial: None,
            writable: None,
            comment: String::new(),
            span: self.since(start),
        };
        if self.raw() == Raw::Colon {
            self.bump(SyntaxKind::Punctuation);
            if matches!(place, Place::Section(SectionKind::Access)) {
                declaration.location = Some(Location::Path(self.expression()));
                if !self.eat(Raw::Colon, SyntaxKind::Punctuation) {
                    self.missing(Problem::P2020, " :", "`:` with the type is missing behind the access path");
                }
            }
            declaration.data_type = self.type_spec();
        } else if constant && matches!(self.raw(), Raw::Becomes | Raw::Equal) {
            // A constant of CONST has no type.
        } else if self.raw() == Raw::Becomes && self.type_begins_behind() {
            let token = self.token();
            let span = self.span(token.start, token.end);
            self.slip(Problem::P2020, span, ":", "the type of a variable stands behind `:`, not `:=`");
            self.bump(SyntaxKind::Punctuation);
            declaration.data_type = self.type_spec();
        } else if self.at_name() && !self.on_new_line() || matches!(self.keyword(), Some(Keyword::Array | Keyword::Struct)) {
            self.missing(Problem::P2020, " :", format!("`:` is missing between {} and {}", self.previous_text(), self.shown()));
            declaration.data_type = self.type_spec();
        } else {
            self.missing(Problem::P2020, " : INT", format!("`:` and a type are missing behind {}", self.previous_text()));
            declaration.data_type.kind = TypeKind::Missing;
        }
        if self.at_word("R_EDGE") || self.at_word("F_EDGE") {
            let token = self.token();
            self.judge(Construct::EdgeInput, token.start, token.end);
            declaration.edge = Some(if self.at_word("R_EDGE") { Edge::Rising } else { Edge::Falling });
            self.bump(SyntaxKind::Keyword);
        }
        declaration.initial = self.initial();
        if let Place::Section(SectionKind::Access) = place {
            declaration.writable = [("READ_WRITE", true), ("READ_ONLY", false)]
                .into_iter()
                .find(|(word, _)| self.eat_word(word))
                .map(|(_, writable)| writable);
        }
        declaration.span = self.since(start);
        attributes.extend(self.take_attributes_before(self.previous));
        declaration.attributes = attributes;
        self.declaration_end();
        declaration.comment = self.comment_behind();
        Some(declaration).filter(|declaration| !declaration.names.is_empty())
    }

    /// One name of a declaration.
    fn declared(&mut self, place: Place) -> Option<DeclaredName> {
        let (mut qualifier, mut elements) = (Vec::new(), Vec::new());
        let config = matches!(place, Place::Section(SectionKind::Config));
        if config {
            while self.at_name() && matches!(self.next_raw(), Raw::Point | Raw::BracketOpen) {
                let name = self.name(SyntaxKind::Name);
                if self.raw() == Raw::BracketOpen {
                    elements.push((qualifier.len(), self.element_indexes()));
                }
                if self.raw() != Raw::Point {
                    return Some(DeclaredName { qualifier, name, elements });
                }
                qualifier.push(name);
                self.bump(SyntaxKind::Punctuation);
            }
        }
        let name = if matches!(place, Place::Section(_))
            && self.at_word("AT")
            && let Some(name) = self.unnamed_address()
        {
            // `AT %MW6 : WORD`: the address is declared itself.
            name
        } else if self.at_name() {
            self.name(SyntaxKind::Declared)
        } else if self.keyword().is_some() {
            self.declared_name("the name of a variable")?
        } else {
            let shown = self.shown();
            self.unexpected(Problem::P2020, format!("the name of a variable is wanted here, not {shown}"));
            self.skip_declaration();
            return None;
        };
        Some(DeclaredName { qualifier, name, elements })
    }

    /// `[1, 2]` behind a name of VAR_CONFIG, also `[1][2]`.
    fn element_indexes(&mut self) -> Vec<Expression> {
        let mut indexes = Vec::new();
        while self.raw() == Raw::BracketOpen {
            self.bump(SyntaxKind::Punctuation);
            indexes.push(self.expression());
            while self.eat(Raw::Comma, SyntaxKind::Punctuation) {
                indexes.push(self.expression());
            }
            self.close(Raw::BracketClose, "]");
        }
        indexes
    }

    /// AT with an address or a variable.
    fn location(&mut self) -> Option<Location> {
        if !self.at_word("AT") {
            return None;
        }
        let token = self.token();
        self.bump(SyntaxKind::Keyword);
        if self.raw() == Raw::Percent {
            if let Some(relative) = self.relative_address() {
                return Some(relative);
            }
            self.judge(Construct::LocatedAt, token.start, token.end);
            return self.located_address().map(Location::Address);
        }
        if self.at_name() {
            if let Some(Expression { kind: ExpressionKind::Address(address), .. }) = self.bare_address() {
                return Some(Location::Address(address));
            }
            self.judge(Construct::ViewAt, token.start, token.end);
            return Some(Location::View(self.name(SyntaxKind::Name)));
        }
        let shown = self.shown();
        self.unexpected(Problem::P2005, format!("an address such as `%MW10` is wanted behind AT, not {shown}"));
        None
    }

    fn type_begins_behind(&self) -> bool {
        let token = self.tokens[self.behind(self.at)];
        matches!(token.keyword, Some(Keyword::Array | Keyword::Struct))
            || (token.raw == Raw::Word && sieben_model::types::DataType::from_word(self.slice(token)).is_some())
    }

    /// `:= value`.
    pub(super) fn initial(&mut self) -> Option<Initializer> {
        self.initial_sign().then(|| self.initializer())
    }

    /// Takes `:=`, or a slip for it.
    fn initial_sign(&mut self) -> bool {
        match self.raw() {
            Raw::Becomes => {}
            Raw::Equal => {
                let token = self.token();
                let exchanged = self.joined_with(Raw::Colon);
                let span = self.span(token.start, token.end + u32::from(exchanged));
                let message = format!(
                    "`{}` is no assignment sign; an initial value is written `:=`",
                    &self.text[span.start as usize..span.end as usize]
                );
                self.slip(Problem::P2007, span, ":=", message);
                if exchanged {
                    self.bump(SyntaxKind::Operator);
                }
            }
            _ => return false,
        }
        self.bump(SyntaxKind::Operator);
        true
    }

    /// An initial value, also several without brackets.
    pub(super) fn initializer(&mut self) -> Initializer {
        self.start(SyntaxKind::Initializer);
        let start = self.here();
        let first = self.initial_element();
        let bare = self.raw() == Raw::Comma || matches!(first.kind, InitializerKind::Repeat { .. });
        if !bare {
            self.finish();
            return first;
        }
        if self.previous > start {
            self.judge(Construct::BareList, start, self.previous);
        }
        let mut elements = vec![first];
        while self.eat(Raw::Comma, SyntaxKind::Punctuation) {
            elements.push(self.initial_element());
        }
        self.finish();
        Initializer { kind: InitializerKind::List { elements, bracketed: false }, span: self.since(start) }
    }

    fn initial_element(&mut self) -> Initializer {
        let start = self.here();
        let next = self.behind(self.at);
        let kind = match self.raw() {
            Raw::Number if self.tokens[next].raw == Raw::ParenOpen => self.repetition(),
            Raw::BracketOpen => self.bracketed(),
            Raw::ParenOpen if self.is_name(next) && matches!(self.tokens[self.behind(next)].raw, Raw::Becomes) => self.structure(),
            _ => InitializerKind::Expression(self.expression()),
        };
        Initializer { kind, span: self.since(start) }
    }

    /// `3(0, 1)`.
    fn repetition(&mut self) -> InitializerKind {
        let token = self.token();
        let text = self.current();
        let count = match text.replace('_', "").parse() {
            Ok(count) => count,
            Err(_) => {
                self.error(
                    Problem::P2024,
                    token.start,
                    token.end,
                    format!("`{text}` is no number of repetitions, which is a whole number"),
                );
                0
            }
        };
        self.bump(SyntaxKind::Number);
        let values = self.list(Raw::ParenClose, ")");
        InitializerKind::Repeat { count, values }
    }

    fn bracketed(&mut self) -> InitializerKind {
        InitializerKind::List { elements: self.list(Raw::BracketClose, "]"), bracketed: true }
    }

    /// Values between brackets.
    fn list(&mut self, close: Raw, text: &str) -> Vec<Initializer> {
        if !self.deeper() {
            self.skip_brackets();
            return Vec::new();
        }
        self.bump(SyntaxKind::Punctuation);
        let mut elements = Vec::new();
        while !matches!(self.raw(), Raw::End | Raw::Semicolon) && self.raw() != close {
            elements.push(self.initial_element());
            if !self.eat(Raw::Comma, SyntaxKind::Punctuation) {
                break;
            }
        }
        self.close(close, text);
        self.depth -= 1;
        elements
    }

    /// `(a := 1, b := (c := 2))`.
    fn structure(&mut self) -> InitializerKind {
        if !self.deeper() {
            self.skip_brackets();
            return InitializerKind::Structure(Vec::new());
        }
        self.bump(SyntaxKind::Punctuation);
        let mut fields: Vec<(Name, Initializer)> = Vec::new();
        while self.at_name() {
            let name = self.name(SyntaxKind::Name);
            match self.initial_sign() {
                true => {
                    let value = self.initial_element();
                    fields.push((name, value));
                }
                false => self.missing(Problem::P2024, " :=", format!("`:=` is missing behind {}", self.previous_text())),
            }
            if !self.eat(Raw::Comma, SyntaxKind::Punctuation) {
                break;
            }
        }
        self.close(Raw::ParenClose, ")");
        self.depth -= 1;
        InitializerKind::Structure(fields)
    }

    /// Takes the `;` of a declaration, or says where it is missing.
    pub(super) fn declaration_end(&mut self) {
        if self.eat(Raw::Semicolon, SyntaxKind::Semicolon) {
            return;
        }
        let behind = self.previous_text();
        // STRUCT … END_STRUCT stands without a semicolon in many sources.
        if self.behind_structure() {
            return;
        }
        if self.on_new_line() || self.raw() == Raw::End || self.keyword().is_some_and(|keyword| keyword.is_end()) {
            self.missing(Problem::P6053, ";", format!("`;` is missing behind {behind}"));
            return;
        }
        if self.at_name() && matches!(self.next_raw(), Raw::Colon | Raw::Comma) {
            self.missing(Problem::P6053, ";", format!("`;` is missing behind {behind}"));
            return;
        }
        let shown = self.shown();
        self.unexpected(Problem::P2020, format!("{shown} does not belong here: the declaration ends with `;` behind {behind}"));
        self.skip_declaration();
    }

    /// Whether the last token that was taken is END_STRUCT or END_UNION.
    pub(super) fn behind_structure(&self) -> bool {
        let last = self.tokens[..self.emitted].last();
        last.is_some_and(|token| matches!(token.keyword, Some(Keyword::EndStruct | Keyword::EndUnion)))
    }

    /// Skips to the end of a declaration.
    pub(super) fn skip_declaration(&mut self) {
        loop {
            match self.raw() {
                Raw::End => return,
                Raw::Semicolon => {
                    self.bump(SyntaxKind::Semicolon);
                    return;
                }
                _ if self.keyword().is_some_and(|keyword| {
                    keyword.is_end() || keyword.begins_section() || keyword.begins_block() || keyword == Keyword::Begin
                }) =>
                {
                    return;
                }
                _ if self.on_new_line() && self.at_name() && matches!(self.next_raw(), Raw::Colon | Raw::Comma) => return,
                _ => self.bump_unexpected(),
            };
        }
    }

    /// The comment that stands behind a declaration on its line, without its marks.
    pub(super) fn comment_behind(&self) -> String {
        let from = self.previous;
        for token in self.tokens[..self.at].iter().rev().take_while(|token| token.start >= from).collect::<Vec<_>>().into_iter().rev() {
            match token.raw {
                Raw::Blank => {}
                Raw::LineComment | Raw::BlockComment => return plain_comment(self.slice(*token)),
                _ => return String::new(),
            }
        }
        String::new()
    }

    // Attributes.

    /// The attributes of all pragmas that were passed and belong to nothing yet.
    pub(super) fn take_attributes(&mut self) -> Vec<Attribute> {
        self.take_attributes_before(u32::MAX)
    }

    /// Those of pragmas before a place.
    pub(super) fn take_attributes_before(&mut self, place: u32) -> Vec<Attribute> {
        let count = self.pragmas.iter().take_while(|&&token| self.tokens[token].start < place).count();
        let taken: Vec<usize> = self.pragmas.drain(..count).collect();
        taken.into_iter().flat_map(|token| super::pragmas::attributes(self.text, self.file, self.tokens[token])).collect()
    }
}

/// The text of a comment.
fn plain_comment(text: &str) -> String {
    let text = text.strip_prefix("//").unwrap_or(text);
    let text = text.strip_prefix("(*").or_else(|| text.strip_prefix("(/*")).or_else(|| text.strip_prefix("/*")).unwrap_or(text);
    let text = text.strip_suffix("*/)").or_else(|| text.strip_suffix("*)")).or_else(|| text.strip_suffix("*/")).unwrap_or(text);
    text.trim().to_owned()
}
