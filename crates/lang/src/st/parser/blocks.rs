//! What a file consists of: blocks, data blocks, namespaces, and statements outside any of them.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use super::super::ast::{Block, BlockKind, DataBlock, Interface, Item, Name, Namespace, Path, TypeKind, TypeSpec};
use super::super::dialect::Construct;
use super::super::keywords::Keyword;
use super::super::lexer::Raw;
use super::{Parser, SyntaxKind};

impl Parser<'_> {
    /// The items of a file, or of a namespace that ends with a keyword.
    pub(super) fn items(&mut self, end: Option<Keyword>) -> Vec<Item> {
        let mut items = Vec::new();
        loop {
            let (token, at) = (self.token(), self.at);
            match token.keyword {
                _ if token.raw == Raw::End => return items,
                Some(keyword) if Some(keyword) == end => return items,
                Some(Keyword::Program) => self.block(&mut items, BlockKind::Program),
                Some(Keyword::Function) => self.block(&mut items, BlockKind::Function),
                Some(Keyword::FunctionBlock) => self.block(&mut items, BlockKind::FunctionBlock),
                Some(Keyword::Class) => self.block(&mut items, BlockKind::Class),
                Some(Keyword::OrganizationBlock) => self.block(&mut items, BlockKind::OrganizationBlock),
                Some(Keyword::DataBlock) => {
                    let block = self.data_block();
                    items.push(Item::DataBlock(Box::new(block)));
                }
                Some(Keyword::Type) => self.types(&mut items),
                Some(Keyword::VarGlobal | Keyword::VarConfig | Keyword::VarAccess) => {
                    let section = self.section();
                    items.push(Item::Globals(section));
                }
                Some(Keyword::Interface) => {
                    let interface = self.interface();
                    items.push(Item::Interface(Box::new(interface)));
                }
                Some(Keyword::Namespace) => self.namespace(&mut items),
                Some(Keyword::Using) => {
                    if let Some(path) = self.using() {
                        items.push(Item::Using(path));
                    }
                }
                Some(Keyword::Configuration) => {
                    let configuration = self.configuration();
                    items.push(Item::Configuration(Box::new(configuration)));
                }
                Some(Keyword::Setup | Keyword::Teardown | Keyword::Test) => self.test_part(&mut items),
                Some(Keyword::Var) if self.dialect.is_test() => self.test_variables(&mut items),
                Some(keyword @ (Keyword::Method | Keyword::Property | Keyword::Action)) => self.member_behind(&mut items, keyword),
                Some(keyword) if keyword.is_end() && self.dangling(keyword) => {}
                None if token.raw == Raw::Semicolon => {
                    self.bump(SyntaxKind::Semicolon);
                }
                _ if let Some(keyword) = self.lost_member() => self.member_behind(&mut items, keyword),
                _ => match self.lost_beginning() {
                    Some(Keyword::Type) => self.types(&mut items),
                    Some(Keyword::DataBlock) => {
                        let block = self.data_block();
                        items.push(Item::DataBlock(Box::new(block)));
                    }
                    Some(Keyword::Interface) => {
                        let interface = self.interface();
                        items.push(Item::Interface(Box::new(interface)));
                    }
                    Some(Keyword::Configuration) => {
                        let configuration = self.configuration();
                        items.push(Item::Configuration(Box::new(configuration)));
                    }
                    Some(Keyword::Program) => self.block(&mut items, BlockKind::Program),
                    Some(Keyword::Function) => self.block(&mut items, BlockKind::Function),
                    Some(Keyword::FunctionBlock) => self.block(&mut items, BlockKind::FunctionBlock),
                    Some(Keyword::Class) => self.block(&mut items, BlockKind::Class),
                    Some(_) => self.block(&mut items, BlockKind::OrganizationBlock),
                    None => self.implicit(&mut items),
                },
            }
            // What was taken for the lost beginning of something and is no part of it is left out.
            if self.at == at && self.raw() != Raw::End {
                self.bump_unexpected();
            }
        }
    }

    /// The first keyword of a block that is missing before the current name: its end comes before the beginning of another one.
    fn lost_beginning(&mut self) -> Option<Keyword> {
        if !self.at_name() || matches!(self.next_raw(), Raw::Becomes | Raw::ParenOpen | Raw::Point | Raw::BracketOpen | Raw::Semicolon) {
            return None;
        }
        let mut found = None;
        for index in self.at..self.tokens.len() {
            found = match self.tokens[index].keyword {
                // A program in a resource: `PROGRAM p WITH t : Main;`.
                Some(Keyword::Program) if self.tokens[self.behind(self.behind(index))].raw == Raw::Colon => continue,
                Some(Keyword::Program) if self.is_with(self.behind(self.behind(index))) => continue,
                Some(Keyword::EndProgram) => Some(Keyword::Program),
                Some(Keyword::EndFunction) => Some(Keyword::Function),
                Some(Keyword::EndFunctionBlock) => Some(Keyword::FunctionBlock),
                Some(Keyword::EndClass) => Some(Keyword::Class),
                Some(Keyword::EndOrganizationBlock) => Some(Keyword::OrganizationBlock),
                Some(Keyword::EndDataBlock) => Some(Keyword::DataBlock),
                Some(Keyword::EndType) => Some(Keyword::Type),
                Some(Keyword::EndConfiguration) => Some(Keyword::Configuration),
                Some(Keyword::EndInterface) => Some(Keyword::Interface),
                // A word of a title begins no block.
                Some(keyword) if keyword.begins_block() && self.begins_line(index) => None,
                _ => continue,
            };
            break;
        }
        let word = found?.word();
        let token = self.token();
        let at = self.span(token.start, token.start);
        let span = self.span(token.start, token.end);
        let message = format!("`{word}` is missing before {}", self.shown());
        self.report(Diagnostic::new(Problem::P6056, span, message).fix(at, format!("{word} "), format!("write `{word}`")));
        found
    }

    fn is_with(&self, index: usize) -> bool {
        self.slice(self.tokens[index]).eq_ignore_ascii_case("WITH")
    }

    /// Takes the first keyword of a block; where it is missing, that was said already.
    pub(super) fn first_keyword(&mut self) {
        if self.keyword().is_some() {
            self.bump(SyntaxKind::Keyword);
        }
    }

    /// An end keyword where nothing is open; `false` if statements go on behind it.
    fn dangling(&mut self, keyword: Keyword) -> bool {
        if keyword.ends_statement() {
            return false;
        }
        let shown = self.shown();
        let problem = if matches!(keyword, Keyword::EndVar | Keyword::EndStruct) { Problem::P6059 } else { Problem::P2013 };
        self.unexpected(problem, format!("{shown} ends something that did not begin"));
        self.bump_unexpected();
        self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
        true
    }

    /// An empty block of this kind.
    pub(super) fn new_block(&mut self, kind: BlockKind, name: Name, start: u32) -> Block {
        Block { end: self.span(self.previous, self.previous), ..Block::empty(kind, name, self.since(start)) }
    }

    /// A block that begins with a keyword.
    fn block(&mut self, items: &mut Vec<Item>, kind: BlockKind) {
        let attributes = self.take_attributes();
        let token = self.token();
        let (construct, end, what) = match kind {
            BlockKind::Program => (Some(Construct::Program), Keyword::EndProgram, "PROGRAM"),
            BlockKind::Function => (None, Keyword::EndFunction, "FUNCTION"),
            BlockKind::FunctionBlock => (None, Keyword::EndFunctionBlock, "FUNCTION_BLOCK"),
            BlockKind::Class => (Some(Construct::ClassAndNamespace), Keyword::EndClass, "CLASS"),
            _ => (Some(Construct::ControllerBlock), Keyword::EndOrganizationBlock, "ORGANIZATION_BLOCK"),
        };
        if let Some(construct) = construct {
            self.judge(construct, token.start, token.end);
        }
        self.start(SyntaxKind::Block);
        let lost = token.keyword.is_none();
        self.first_keyword();
        let modifiers = self.modifiers();
        let name = if lost && self.at_name() { self.name(SyntaxKind::Declared) } else { self.block_name(what) };
        let mut block = self.new_block(kind, name, token.start);
        block.modifiers = modifiers;
        block.attributes = attributes;
        self.declared.clear();
        self.labels.clear();
        self.awaited.clear();
        self.bases_of(&mut block);
        if matches!(kind, BlockKind::FunctionBlock | BlockKind::Class) {
            self.stray_base(&mut block);
            self.bases_of(&mut block);
        }
        if self.raw() == Raw::Colon && (kind == BlockKind::Function || !self.on_new_line()) {
            self.bump(SyntaxKind::Punctuation);
            block.result = self.result_type();
            if kind != BlockKind::Function {
                let message = format!("a {what} has no result; only a FUNCTION has");
                let span = self.since(token.start);
                self.push(Diagnostic::new(Problem::P2200, span, message));
            }
        } else if kind == BlockKind::Function && self.raw() == Raw::Word && self.keyword().is_none() && !self.on_new_line() {
            self.missing(Problem::P2020, " :", format!("`:` is missing between {} and {}", self.previous_text(), self.shown()));
            block.result = self.result_type();
        }
        block.header = self.header();
        self.lost_header(&mut block.header);
        self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
        // TIA Portal writes attributes before the header, some write them behind it.
        let attributes = self.take_attributes_before(self.here());
        block.attributes.extend(attributes);
        self.begin_diagrams_of(&block);
        self.block_parts(&mut block, Some(end));
        self.end_diagrams_of(&mut block);
        let last = self.token();
        self.block_end(end, token.start, what);
        block.end = self.span(last.start.min(self.previous), self.previous);
        block.span = self.since(token.start);
        self.finish();
        self.declared.clear();
        items.push(Item::Block(Box::new(block)));
    }

    /// The name of a block; empty with a message if there is none.
    pub(super) fn block_name(&mut self, what: &str) -> Name {
        let line = self.on_new_line();
        if self.at_name() && !(line && matches!(self.next_raw(), Raw::Colon | Raw::Becomes)) {
            let name = self.name(SyntaxKind::Declared);
            return self.with_number(name, SyntaxKind::Declared);
        }
        if self.keyword().is_some_and(|keyword| !keyword.begins_section() && !keyword.is_end()) && !line {
            return self.declared_name("the name of a block").unwrap_or_default();
        }
        let message = format!("a name is missing behind {what}");
        let at = self.span(self.previous, self.previous);
        let place = self.last_character();
        self.report(Diagnostic::new(Problem::P2010, place, message).help(format!("write `{what} Name`")));
        Name { span: at, ..Name::default() }
    }

    /// `FC 10` as STL writes it instead of `FC10`: the name and the number behind it in one.
    pub(super) fn with_number(&mut self, mut name: Name, kind: SyntaxKind) -> Name {
        if self.raw() == Raw::Number && !self.on_new_line() {
            name.text.push_str(self.current());
            let number = self.bump(kind);
            name.span = name.span.to(number);
        }
        name
    }

    /// The type behind `:`; VOID is none.
    pub(super) fn result_type(&mut self) -> Option<TypeSpec> {
        if self.at_word("VOID") {
            let token = self.token();
            self.judge(Construct::VoidResult, token.start, token.end);
            self.bump(SyntaxKind::TypeWord);
            return None;
        }
        Some(self.type_spec())
    }

    /// Declarations, members and statements of a block up to its end.
    pub(super) fn block_parts(&mut self, block: &mut Block, end: Option<Keyword>) {
        let mut begun = false;
        let mut late = false;
        loop {
            let token = self.token();
            match token.keyword {
                _ if token.raw == Raw::End => return,
                Some(keyword) if Some(keyword) == end => return,
                Some(Keyword::Label) => self.label_section(&mut block.labels),
                Some(Keyword::VarGlobal | Keyword::VarConfig | Keyword::VarAccess) if end.is_none() => return,
                Some(keyword) if keyword.begins_section() => {
                    // One message for all of them.
                    if !block.body.is_empty() && !std::mem::replace(&mut late, true) {
                        let shown = self.shown();
                        let message = format!("{shown} stands behind statements; declarations stand before the first one");
                        self.error(Problem::P2019, token.start, token.end, message);
                    }
                    let section = self.section();
                    block.sections.push(section);
                }
                Some(Keyword::Begin) => {
                    self.judge(Construct::Begin, token.start, token.end);
                    if begun {
                        let message = "a second BEGIN: a block has one, before its first statement";
                        self.error(Problem::P2019, token.start, token.end, message);
                    }
                    begun = true;
                    self.bump(SyntaxKind::Keyword);
                }
                Some(Keyword::Using) if end.is_some() => {
                    let path = self.using();
                    block.usings.extend(path);
                }
                Some(keyword @ (Keyword::Method | Keyword::Property | Keyword::Action)) if end.is_some() => self.member(block, keyword),
                Some(Keyword::Method | Keyword::Property | Keyword::Action) => return,
                Some(keyword) if keyword.begins_block() => return,
                Some(keyword) if keyword.is_end() && !keyword.ends_statement() => {
                    // The end of another kind of block; END_VAR and the like belong to nobody.
                    let section =
                        matches!(keyword, Keyword::EndVar | Keyword::EndStruct | Keyword::EndConst | Keyword::EndLabel | Keyword::EndUnion);
                    // The end of a method whose beginning is lost, with that of the block behind it.
                    let member = end.is_some_and(|end| end != keyword && is_end_of_member(keyword) && self.ends_with(end));
                    if !section && !member {
                        return;
                    }
                    let shown = self.shown();
                    let what = if section { "declarations" } else { "a part of the block" };
                    let problem = if section { Problem::P6059 } else { Problem::P2013 };
                    self.unexpected(problem, format!("{shown} ends {what} that did not begin"));
                    self.bump_unexpected();
                    self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
                }
                Some(_) if self.at_body_end() => self.stray(),
                _ if token.raw == Raw::DiagramWord => self.diagram_of(block),
                _ if self.begins_lost_declarations(&block.body) => {
                    let section = self.lost_section();
                    block.sections.push(section);
                }
                _ if end.is_some()
                    && let Some(keyword) = self.lost_member() =>
                {
                    self.member(block, keyword)
                }
                _ if self.other_language(&block.body) => {}
                _ => self.statement_into(&mut block.body),
            }
        }
    }

    /// Whether the end of this block is the next end of a block, before another one begins.
    fn ends_with(&self, end: Keyword) -> bool {
        let mut keywords = self.tokens[self.at + 1..].iter().filter_map(|token| token.keyword);
        keywords.find(|&keyword| keyword == end || keyword.begins_block() || is_end_of_block(keyword)) == Some(end)
    }

    /// ELSE, UNTIL or the end of a statement that did not begin.
    fn stray(&mut self) {
        let shown = self.shown();
        let end = self.keyword().is_some_and(|keyword| keyword.is_end());
        let (problem, message) = match end {
            true => (Problem::P6059, format!("{shown} ends a statement that did not begin")),
            false => (Problem::P6059, format!("{shown} belongs to a statement that did not begin")),
        };
        self.unexpected(problem, message);
        self.bump_unexpected();
        match end {
            true => {
                self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
            }
            // The condition of ELSIF and UNTIL.
            false if !self.on_new_line() && !self.at_body_end() => {
                self.skip_statement();
                if self.at_word("THEN") {
                    self.bump_unexpected();
                }
                self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
            }
            false => {}
        }
    }

    /// Takes the end keyword of a block, or says what is wrong.
    pub(super) fn block_end(&mut self, wanted: Keyword, start: u32, what: &str) {
        if self.eat_keyword(wanted) {
            return;
        }
        let word = wanted.word();
        // The first token of the block; what began it may be missing.
        let first = self.tokens.binary_search_by_key(&start, |token| token.start).map_or(start, |index| self.tokens[index].end);
        let begun = self.span(start, first);
        if let Some(keyword) = self.keyword().filter(|keyword| keyword.is_end()) {
            let token = self.token();
            let span = self.span(token.start, token.end);
            let message = format!("{what} ends with `{word}`, not with `{}`", keyword.word());
            self.report(Diagnostic::new(Problem::P2012, span, message).related(begun, "the block begins here").fix(
                span,
                word,
                format!("write `{word}`"),
            ));
            self.bump(SyntaxKind::Keyword);
            return;
        }
        let message = format!("{what} has no `{word}`");
        self.report(Diagnostic::new(Problem::P2011, begun, message).help(format!("write `{word}` behind its last line")));
    }

    /// Statements and VAR sections outside any block.
    fn implicit(&mut self, items: &mut Vec<Item>) {
        let start = self.here();
        let before = self.at;
        // What belongs to one implicit block may be interrupted by functions and types.
        let found = items.iter().position(|item| matches!(item, Item::Block(block) if block.kind == BlockKind::Implicit));
        let mut block = match found {
            Some(index) => match items.remove(index) {
                Item::Block(block) => *block,
                _ => return,
            },
            None => {
                self.declared.clear();
                self.labels.clear();
                self.new_block(BlockKind::Implicit, Name::default(), start)
            }
        };
        self.awaited.clear();
        let statements = block.body.len();
        let sections = block.sections.len();
        self.begin_diagrams_of(&block);
        self.block_parts(&mut block, None);
        self.end_diagrams_of(&mut block);
        if self.at == before {
            self.unexpected_here();
        }
        block.end = self.span(self.previous, self.previous);
        block.span = block.span.to(self.since(start));
        if found.is_some() || block.body.len() > statements || block.sections.len() > sections {
            items.push(Item::Block(Box::new(block)));
        }
    }

    /// Something that nothing knows what to do with.
    fn unexpected_here(&mut self) {
        let shown = self.shown();
        self.unexpected(Problem::P6054, format!("{shown} does not belong here"));
        self.bump_unexpected();
    }

    /// `LABEL a, b; END_LABEL`.
    fn label_section(&mut self, labels: &mut Vec<Name>) {
        let token = self.token();
        self.judge(Construct::LabelSection, token.start, token.end);
        self.start(SyntaxKind::Section);
        self.bump(SyntaxKind::Keyword);
        loop {
            if matches!(self.raw(), Raw::Comma | Raw::Semicolon) {
                let shown = self.shown();
                self.unexpected(Problem::P2020, format!("the name of a label is wanted here, not {shown}"));
                self.bump_unexpected();
                continue;
            }
            if !self.at_name() {
                break;
            }
            let name = self.name(SyntaxKind::Declared);
            self.labels.insert(name.key());
            labels.push(name);
            if !self.eat(Raw::Comma, SyntaxKind::Punctuation) {
                self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
            }
        }
        self.section_end(Keyword::EndLabel, token.start);
        self.finish();
    }

    /// DATA_BLOCK; the current token is its keyword.
    fn data_block(&mut self) -> DataBlock {
        let mut attributes = self.take_attributes();
        let token = self.token();
        self.judge(Construct::ControllerBlock, token.start, token.end);
        self.start(SyntaxKind::Block);
        self.first_keyword();
        self.declared.clear();
        self.awaited.clear();
        let name = self.block_name("DATA_BLOCK");
        let mut header = self.header();
        self.lost_header(&mut header);
        attributes.extend(self.take_attributes_before(self.here()));
        let missing = TypeSpec { kind: TypeKind::Missing, span: self.since(self.previous) };
        let mut block = DataBlock {
            name,
            header,
            attributes,
            data_type: missing,
            sections: Vec::new(),
            assignments: Vec::new(),
            span: self.since(token.start),
        };
        if self.at_name() && self.next_raw() == Raw::Colon {
            let start = self.here();
            let at = self.span(start, start);
            let span = self.span(start, self.token().end);
            let message = "`STRUCT` is missing before the first field";
            self.report(Diagnostic::new(Problem::P2210, span, message).fix(at, "STRUCT ", "write `STRUCT`"));
            block.data_type = self.lost_structure(start);
            self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
        } else if self.keyword() == Some(Keyword::Struct) || self.at_name() {
            block.data_type = self.type_spec();
            self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
            // Some write the flags behind the type.
            block.header.flags.extend(self.header().flags);
        }
        while self.keyword().is_some_and(|keyword| keyword.begins_section()) {
            let section = self.section();
            block.sections.push(section);
        }
        if block.sections.is_empty() && matches!(block.data_type.kind, TypeKind::Missing) {
            let message = "a data block has a STRUCT, VAR sections, or the FB or type that it is based on";
            self.unexpected(Problem::P2210, message);
        }
        self.eat_keyword(Keyword::Begin);
        self.only_names = true;
        while !self.at_body_end() {
            let before = self.at;
            self.start(SyntaxKind::Statement);
            if !self.eat(Raw::Semicolon, SyntaxKind::Semicolon) {
                let target = self.target();
                match self.initial() {
                    Some(value) => {
                        block.assignments.push((target, value));
                        self.declaration_end();
                    }
                    None => {
                        let shown = self.shown();
                        self.unexpected(Problem::P2017, format!("`:=` with a value is wanted here, not {shown}"));
                        self.skip_declaration();
                    }
                }
            }
            self.finish();
            if self.at == before {
                self.unexpected_here();
            }
        }
        self.only_names = false;
        self.block_end(Keyword::EndDataBlock, token.start, "DATA_BLOCK");
        block.span = self.since(token.start);
        self.finish();
        block
    }

    fn interface(&mut self) -> Interface {
        let token = self.token();
        self.judge(Construct::ObjectOrientation, token.start, token.end);
        self.take_attributes();
        self.start(SyntaxKind::Block);
        self.first_keyword();
        let name = self.block_name("INTERFACE");
        let extends = if self.at_word("EXTENDS") { self.bases() } else { Vec::new() };
        let mut holder = self.new_block(BlockKind::Class, Name::default(), token.start);
        loop {
            match self.keyword() {
                Some(keyword @ (Keyword::Method | Keyword::Property)) => self.member(&mut holder, keyword),
                None if let Some(keyword) = self.lost_member() => self.member(&mut holder, keyword),
                _ => break,
            }
            self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
        }
        self.block_end(Keyword::EndInterface, token.start, "INTERFACE");
        let span = self.since(token.start);
        self.finish();
        Interface { name, extends, methods: holder.methods, properties: holder.properties, span }
    }

    fn namespace(&mut self, items: &mut Vec<Item>) {
        let token = self.token();
        self.judge(Construct::ClassAndNamespace, token.start, token.end);
        if !self.deeper() {
            self.bump_unexpected();
            return;
        }
        self.start(SyntaxKind::Block);
        self.bump(SyntaxKind::Keyword);
        let is_internal = self.eat_word("INTERNAL");
        let name = match self.at_name() {
            true => {
                let path = self.path(SyntaxKind::Declared);
                if self.eat(Raw::Point, SyntaxKind::Punctuation) {
                    let message = "the name of a namespace is missing behind the point";
                    self.report(Diagnostic::new(Problem::P2010, self.last_character(), message));
                }
                path
            }
            false => {
                let name = self.block_name("NAMESPACE");
                Path { span: name.span, names: vec![name] }
            }
        };
        let inner = self.items(Some(Keyword::EndNamespace));
        self.block_end(Keyword::EndNamespace, token.start, "NAMESPACE");
        let span = self.since(token.start);
        self.finish();
        self.depth -= 1;
        items.push(Item::Namespace(Namespace { name, is_internal, items: inner, span }));
    }

    fn using(&mut self) -> Option<Path> {
        let token = self.token();
        self.judge(Construct::ClassAndNamespace, token.start, token.end);
        self.start(SyntaxKind::Statement);
        self.bump(SyntaxKind::Keyword);
        let path = match self.at_name() {
            true => Some(self.path(SyntaxKind::Name)),
            false => {
                let shown = self.shown();
                self.unexpected(Problem::P2010, format!("the name of a namespace is wanted behind USING, not {shown}"));
                None
            }
        };
        if path.is_some() {
            self.declaration_end();
        }
        self.finish();
        path
    }
}

/// The words behind the methods, properties and actions of a block.
fn is_end_of_member(keyword: Keyword) -> bool {
    matches!(keyword, Keyword::EndMethod | Keyword::EndProperty | Keyword::EndGet | Keyword::EndSet | Keyword::EndAction)
}

/// The words behind blocks with statements.
pub(super) fn is_end_of_block(keyword: Keyword) -> bool {
    use Keyword::{EndClass, EndFunction, EndFunctionBlock, EndInterface, EndOrganizationBlock, EndProgram};
    matches!(keyword, EndClass | EndFunction | EndFunctionBlock | EndInterface | EndOrganizationBlock | EndProgram)
}
