//! Types, and TYPE sections.

use sieben_model::problems::Problem;

use super::super::ast::{
    Access, Argument, Dimension, Expression, ExpressionKind, Header, Item, Modifiers, Name, Path, TypeDeclaration, TypeKind, TypeSpec,
};
use super::super::dialect::Construct;
use super::super::keywords::Keyword;
use super::super::lexer::Raw;
use super::declarations::Place;
use super::{Parser, SyntaxKind};

/// Types that an S7-300 does not have.
const LONG_TYPES: &[&str] = &[
    "SINT",
    "USINT",
    "UINT",
    "UDINT",
    "LINT",
    "ULINT",
    "LWORD",
    "LREAL",
    "LTIME",
    "LDATE",
    "LTOD",
    "LTIME_OF_DAY",
    "LDT",
    "LDATE_AND_TIME",
    "WSTRING",
    "WCHAR",
    "DTL",
];

/// Types that are whole numbers: an enumeration or a subrange may be based on them.
const WHOLE_TYPES: &[&str] = &["INT", "DINT", "SINT", "USINT", "UINT", "UDINT", "LINT", "ULINT", "BYTE", "WORD", "DWORD", "LWORD"];

impl Parser<'_> {
    /// A type; something is reported if none begins here.
    pub(super) fn type_spec(&mut self) -> TypeSpec {
        let start = self.here();
        self.start(SyntaxKind::TypeName);
        let kind = match self.deeper() {
            true => {
                let kind = self.type_kind();
                self.depth -= 1;
                kind
            }
            false => {
                self.skip_type();
                TypeKind::Missing
            }
        };
        self.finish();
        TypeSpec { kind, span: self.since(start) }
    }

    /// Skips a type that is nested too deeply.
    fn skip_type(&mut self) {
        let mut open = 0_usize;
        loop {
            match self.keyword() {
                Some(Keyword::Struct | Keyword::Union) => open += 1,
                Some(Keyword::EndStruct | Keyword::EndUnion) => open = open.saturating_sub(1),
                Some(keyword) if keyword.is_end() => return,
                _ if self.raw() == Raw::End => return,
                _ => {}
            }
            if open == 0 && self.raw() == Raw::Semicolon {
                return;
            }
            self.bump_unexpected();
        }
    }

    fn type_kind(&mut self) -> TypeKind {
        let token = self.token();
        match token.keyword {
            Some(Keyword::Array) => return self.array(),
            Some(Keyword::Struct) => return self.structure_type(Keyword::EndStruct),
            Some(Keyword::Union) => return self.structure_type(Keyword::EndUnion),
            _ => {}
        }
        match self.raw() {
            Raw::ParenOpen => return self.enumeration(None),
            Raw::BracketOpen => return self.array(),
            _ => {}
        }
        if self.at_word("STRING") || self.at_word("WSTRING") {
            return self.string();
        }
        if self.at_word("REF_TO") {
            self.judge(Construct::RefTo, token.start, token.end);
            self.bump(SyntaxKind::Keyword);
            return TypeKind::Reference(Box::new(self.type_spec()));
        }
        let leads = self.at_word("POINTER") || self.at_word("REFERENCE");
        let to = self.next_keyword() == Some(Keyword::To);
        if leads && (to || self.to_is_lost()) {
            let pointer = self.at_word("POINTER");
            self.judge(Construct::PointerTo, token.start, token.end);
            self.bump(SyntaxKind::Keyword);
            if to {
                self.bump(SyntaxKind::Keyword);
            } else {
                self.missing(Problem::P2020, " TO", format!("`TO` is missing between {} and {}", self.previous_text(), self.shown()));
            }
            let target = Box::new(self.type_spec());
            return if pointer { TypeKind::Pointer(target) } else { TypeKind::Alias(target) };
        }
        if self.structure_is_lost() {
            return self.without_struct();
        }
        if !self.at_name() {
            let shown = self.shown();
            self.unexpected(Problem::P2021, format!("a data type is wanted here, not {shown}"));
            return TypeKind::Missing;
        }
        if self.raw() == Raw::Word {
            let text = self.current();
            if LONG_TYPES.iter().any(|word| word.eq_ignore_ascii_case(text)) {
                self.judge(Construct::LongTypes, token.start, token.end);
            } else if text.eq_ignore_ascii_case("S5TIME") {
                self.judge(Construct::S5Time, token.start, token.end);
            }
        }
        let numbered = ["UDT", "FB", "SFB"].iter().any(|word| self.at_word(word));
        let mut path = self.path(SyntaxKind::TypeWord);
        if let ([_], true) = (path.names.as_slice(), numbered) {
            let name = path.names.remove(0);
            let name = self.with_number(name, SyntaxKind::TypeWord);
            path = Path { span: name.span, names: vec![name] };
        }
        match self.raw() {
            Raw::ParenOpen => self.behind_base(path),
            Raw::BracketOpen if self.constructs_elements() => {
                let mut elements = Vec::new();
                self.elements_constructed(&mut elements);
                TypeKind::Constructed { block: path, arguments: Vec::new(), elements }
            }
            // Attributes and types such as `REAL[0..10]` are unknown to every dialect.
            Raw::BracketOpen => {
                let shown = self.previous_text();
                self.unexpected(
                    Problem::P2021,
                    format!("{shown} has no length; an array is written `ARRAY [1..5] OF {}`", path.names[0].text),
                );
                self.skip_brackets();
                TypeKind::Named(path)
            }
            _ => TypeKind::Named(path),
        }
    }

    /// `INT(0..100)`, `INT (a := 1, b)`, `MyBlock(a := 1)`; the current token is the bracket.
    fn behind_base(&mut self, base: Path) -> TypeKind {
        let whole = base.single().is_some_and(|name| WHOLE_TYPES.iter().any(|word| name.is(word)));
        let first = self.behind(self.at);
        let second = self.behind(first);
        let named = self.is_name(first);
        let listed = named && matches!(self.tokens[second].raw, Raw::Comma | Raw::ParenClose | Raw::Becomes);
        if listed && whole {
            return self.enumeration(Some(base));
        }
        let ranged = {
            let mut index = self.at;
            let mut open = 0_usize;
            loop {
                match self.tokens[index].raw {
                    Raw::ParenOpen => open += 1,
                    Raw::ParenClose if open <= 1 => break false,
                    Raw::ParenClose => open -= 1,
                    Raw::Range => break true,
                    Raw::End | Raw::Semicolon => break false,
                    _ => {}
                }
                index = self.behind(index);
            }
        };
        if !ranged {
            let (arguments, _) = self.arguments();
            return TypeKind::Constructed { block: base, arguments, elements: Vec::new() };
        }
        let token = self.token();
        self.judge(Construct::Subrange, token.start, token.end);
        self.bump(SyntaxKind::Punctuation);
        let low = Box::new(self.expression());
        if !self.eat(Raw::Range, SyntaxKind::Operator) {
            self.missing(Problem::P2021, "..", "`..` is missing between the limits");
        }
        let high = Box::new(self.expression());
        self.close(Raw::ParenClose, ")");
        TypeKind::Subrange { base, low, high }
    }

    /// Whether arguments for each element of an array follow, `[(a := 1), (a := 2)]`; the current token is the bracket.
    fn constructs_elements(&self) -> bool {
        let next = self.tokens[self.behind(self.at)].raw;
        self.dialect.has_pointers() && matches!(next, Raw::ParenOpen | Raw::BracketOpen)
    }

    /// The arguments of each element, with a bracket for each dimension or one for all; the current token is the bracket.
    fn elements_constructed(&mut self, elements: &mut Vec<Vec<Argument>>) {
        if !self.deeper() {
            self.skip_brackets();
            return;
        }
        self.bump(SyntaxKind::Punctuation);
        loop {
            match self.raw() {
                Raw::ParenOpen => elements.push(self.arguments().0),
                Raw::BracketOpen => self.elements_constructed(elements),
                _ => break,
            }
            if !self.eat(Raw::Comma, SyntaxKind::Punctuation) {
                break;
            }
        }
        self.close(Raw::BracketClose, "]");
        self.depth -= 1;
    }

    fn enumeration(&mut self, base: Option<Path>) -> TypeKind {
        let token = self.token();
        self.judge(Construct::Enumeration, token.start, token.end);
        self.bump(SyntaxKind::Punctuation);
        let mut values: Vec<(Name, Option<Expression>)> = Vec::new();
        while self.at_name() || matches!(self.raw(), Raw::Comma | Raw::Becomes) || self.keyword().is_some_and(|keyword| !keyword.is_end()) {
            if self.raw() == Raw::Comma {
                self.unexpected(Problem::P2020, "the name of a value is wanted here, not `,`");
                self.bump_unexpected();
                continue;
            }
            if self.raw() == Raw::Becomes {
                self.unexpected(Problem::P2020, "the name of a value is wanted in front of `:=`");
                self.bump_unexpected();
                self.expression();
                self.eat(Raw::Comma, SyntaxKind::Punctuation);
                continue;
            }
            let Some(name) = self.declared_name("the name of a value") else { break };
            let value = match self.raw() {
                Raw::Becomes => {
                    self.bump(SyntaxKind::Operator);
                    if matches!(self.raw(), Raw::Comma | Raw::ParenClose) {
                        let shown = self.shown();
                        self.unexpected(Problem::P2020, format!("a value is missing behind `:=`: {shown} is none"));
                        None
                    } else {
                        Some(self.expression())
                    }
                }
                Raw::Number | Raw::Literal => {
                    self.missing(Problem::P2020, " :=", format!("`:=` is missing between {} and {}", self.previous_text(), self.shown()));
                    Some(self.expression())
                }
                _ => None,
            };
            values.push((name, value));
            if self.eat(Raw::Comma, SyntaxKind::Punctuation) {
                continue;
            }
            if !self.at_name() {
                break;
            }
            self.missing(Problem::P2020, ",", format!("`,` is missing between {} and {}", self.previous_text(), self.shown()));
        }
        self.close(Raw::ParenClose, ")");
        let behind = self.at_name() && !self.on_new_line() && base.is_none();
        let base = if behind { Some(self.path(SyntaxKind::TypeWord)) } else { base };
        TypeKind::Enumeration { base, values }
    }

    fn string(&mut self) -> TypeKind {
        let token = self.token();
        let wide = self.at_word("WSTRING");
        if wide {
            self.judge(Construct::LongTypes, token.start, token.end);
        }
        self.bump(SyntaxKind::TypeWord);
        let close = match self.raw() {
            Raw::BracketOpen => (Raw::BracketClose, "]"),
            Raw::ParenOpen => (Raw::ParenClose, ")"),
            _ => return TypeKind::String { wide, length: None },
        };
        self.bump(SyntaxKind::Punctuation);
        let length = Some(Box::new(self.expression()));
        self.close(close.0, close.1);
        TypeKind::String { wide, length }
    }

    /// `POINTER INT`: a type stands on the same line.
    fn to_is_lost(&self) -> bool {
        let next = self.behind(self.at);
        let between = self.text.get(self.token().end as usize..self.tokens[next].start as usize);
        let target = self.is_name(next) || self.next_keyword() == Some(Keyword::Array);
        target && between.is_some_and(|between| !between.contains('\n')) && self.dialect.has_pointers()
    }

    fn array(&mut self) -> TypeKind {
        if self.raw() == Raw::BracketOpen {
            self.missing(Problem::P2020, " ARRAY", format!("`ARRAY` is missing between {} and `[`", self.previous_text()));
        } else {
            self.bump(SyntaxKind::Keyword);
        }
        let mut dimensions = Vec::new();
        if self.raw() == Raw::BracketOpen {
            self.bump(SyntaxKind::Punctuation);
            self.dimensions(&mut dimensions);
        } else {
            let message = "`[` with the bounds is missing behind ARRAY, as in `ARRAY [1..5] OF INT`";
            self.missing(Problem::P2021, " [0..1]", message);
            if matches!(self.tokens[self.behind(self.at)].raw, Raw::Range) {
                self.dimensions(&mut dimensions);
            }
            // Bounds without their bracket.
            while !matches!(self.raw(), Raw::End | Raw::Semicolon) && self.keyword().is_none() && !self.on_new_line() {
                self.bump_unexpected();
            }
        }
        if !self.eat_keyword(Keyword::Of) {
            self.missing(Problem::P6056, " OF", format!("`OF` is missing behind {}", self.previous_text()));
        }
        let element = Box::new(self.type_spec());
        if dimensions.is_empty() { TypeKind::Missing } else { TypeKind::Array { dimensions, element } }
    }

    /// The bounds of an array up to their bracket.
    fn dimensions(&mut self, dimensions: &mut Vec<Dimension>) {
        loop {
            dimensions.push(self.dimension());
            if !self.eat(Raw::Comma, SyntaxKind::Punctuation) {
                break;
            }
        }
        self.close(Raw::BracketClose, "]");
    }

    fn dimension(&mut self) -> Dimension {
        if self.raw() == Raw::Star {
            let token = self.token();
            self.judge(Construct::OpenArray, token.start, token.end);
            self.bump(SyntaxKind::Operator);
            return Dimension::Open;
        }
        let low = self.expression();
        if !self.eat(Raw::Range, SyntaxKind::Operator) {
            let bound = low.span;
            self.missing(Problem::P2021, "..", format!("`..` and the upper bound are missing behind {}", self.previous_text()));
            let high = Expression { kind: ExpressionKind::Missing, span: bound };
            // `[1:5]` of other languages.
            let high = if self.raw() == Raw::Colon {
                self.bump_unexpected();
                self.expression()
            } else if matches!(self.raw(), Raw::BracketClose | Raw::Comma) {
                high
            } else {
                self.expression()
            };
            return Dimension::Bounds(Box::new((low, high)));
        }
        let high = self.expression();
        Dimension::Bounds(Box::new((low, high)))
    }

    /// STRUCT or UNION; the current token is its keyword.
    fn structure_type(&mut self, end: Keyword) -> TypeKind {
        let token = self.token();
        if end == Keyword::EndUnion {
            self.judge(Construct::Union, token.start, token.end);
        }
        self.start(SyntaxKind::Struct);
        self.bump(SyntaxKind::Keyword);
        let overlap = end == Keyword::EndStruct && self.next_raw() != Raw::Colon && self.eat_word("OVERLAP");
        let mut fields = Vec::new();
        self.declarations(&mut fields, Place::Struct);
        self.section_end(end, token.start);
        self.finish();
        match end {
            Keyword::EndUnion => TypeKind::Union(fields),
            _ => TypeKind::Struct { fields, overlap },
        }
    }

    /// The fields of a structure whose STRUCT is missing.
    pub(super) fn lost_structure(&mut self, start: u32) -> TypeSpec {
        self.start(SyntaxKind::Struct);
        let overlap = self.is_name(self.behind(self.at)) && self.eat_word("OVERLAP");
        let mut fields = Vec::new();
        self.declarations(&mut fields, Place::Struct);
        self.section_end(Keyword::EndStruct, start);
        self.finish();
        TypeSpec { kind: TypeKind::Struct { fields, overlap }, span: self.since(start) }
    }

    /// `TYPE … END_TYPE`; the current token is TYPE.
    pub(super) fn types(&mut self, items: &mut Vec<Item>) {
        let begun = self.token();
        let mut attributes = self.take_attributes();
        self.start(SyntaxKind::Section);
        self.first_keyword();
        let mut first = true;
        loop {
            attributes.extend(self.take_attributes());
            if self.raw() == Raw::End {
                break;
            }
            if matches!(self.keyword(), Some(Keyword::EndStruct | Keyword::EndUnion)) {
                let shown = self.shown();
                self.unexpected(Problem::P6059, format!("{shown} ends declarations that did not begin"));
                self.bump_unexpected();
                self.skip_declaration();
                continue;
            }
            if let Some(keyword) = self.keyword()
                && (keyword.is_end() || keyword.begins_section() || keyword.begins_block() && self.next_raw() != Raw::Colon)
            {
                break;
            }
            if self.eat(Raw::Semicolon, SyntaxKind::Semicolon) {
                continue;
            }
            let before = self.at;
            self.start(SyntaxKind::Declaration);
            if let Some(declaration) = self.type_declaration(std::mem::take(&mut attributes)) {
                items.push(Item::Type(Box::new(declaration)));
            }
            self.finish();
            first = false;
            if self.at == before {
                let shown = self.shown();
                self.unexpected(Problem::P2020, format!("{shown} begins no type, which is written `name : INT;`"));
                self.bump_unexpected();
            }
        }
        if first {
            let shown = self.shown();
            self.unexpected(Problem::P2020, format!("the name of a type is wanted behind TYPE, not {shown}"));
        }
        self.block_end(Keyword::EndType, begun.start, "TYPE");
        self.finish();
    }

    fn type_declaration(&mut self, mut attributes: Vec<super::super::ast::Attribute>) -> Option<TypeDeclaration> {
        let start = self.here();
        let mut modifiers = Modifiers::default();
        for (word, access) in [("PUBLIC", Access::Public), ("INTERNAL", Access::Internal)] {
            if self.at_word(word) && self.is_name(self.behind(self.at)) {
                modifiers = Modifiers { access: Some(access), span: self.bump(SyntaxKind::Keyword), ..modifiers };
            }
        }
        let of_objects = self.dialect.has_pointers();
        if of_objects && self.at_word("ABSTRACT") && self.is_name(self.behind(self.at)) {
            modifiers = Modifiers { is_abstract: true, span: self.bump(SyntaxKind::Keyword), ..modifiers };
        }
        let name = match self.raw() == Raw::Colon || self.at_keyword(Keyword::Struct) {
            true => self.block_name("TYPE"),
            false => {
                let name = self.declared_name("the name of a type")?;
                if name.is("UDT") { self.with_number(name, SyntaxKind::Declared) } else { name }
            }
        };
        let header: Header = self.header();
        let extends = match self.eat_word("EXTENDS") {
            true if self.at_name() => Some(self.path(SyntaxKind::TypeWord)),
            _ => None,
        };
        attributes.extend(self.take_attributes());
        let colon = self.eat(Raw::Colon, SyntaxKind::Punctuation);
        if !colon && !matches!(self.keyword(), Some(Keyword::Struct)) && !self.structure_is_lost() {
            let shown = self.shown();
            if self.keyword().is_some_and(|keyword| keyword.is_end()) || self.raw() == Raw::End {
                self.missing(Problem::P2020, " : INT", format!("`:` and a type are missing behind {}", self.previous_text()));
                return None;
            }
            self.missing(Problem::P2020, " :", format!("`:` is missing between {} and {shown}", self.previous_text()));
        }
        attributes.extend(self.take_attributes());
        let data_type = self.type_spec();
        let initial = self.initial();
        let span = self.since(start);
        self.declaration_end();
        let comment = self.comment_behind();
        Some(TypeDeclaration { name, modifiers, header, attributes, extends, data_type, initial, comment, span })
    }
}
