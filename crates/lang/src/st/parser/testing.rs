//! What only test files have: SETUP, TEARDOWN, TEST, variables of the file, MOCK.

use std::collections::HashMap;

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::testing::TESTS_MAX;

use super::super::ast::{Argument, BlockKind, Call, Direction, Expression, ExpressionKind, Item, Name, Quoting, SectionKind};
use super::super::ast::{StatementKind, TestPart};
use super::super::keywords::Keyword;
use super::super::lexer::{Raw, Token};
use super::{Parser, SyntaxKind, unquoted};

/// Makes keywords of the words that begin and end parts of a test file, where no name could stand.
pub(super) fn keywords(text: &str, tokens: &mut [Token]) {
    let significant: Vec<usize> = (0..tokens.len()).filter(|&index| !tokens[index].raw.is_trivia()).collect();
    for (at, &index) in significant.iter().enumerate() {
        let token = tokens[index];
        if token.raw != Raw::Word || token.keyword.is_some() {
            continue;
        }
        let Some(keyword) = Keyword::of_test_file(&text[token.start as usize..token.end as usize]) else { continue };
        let before = at.checked_sub(1).map(|before| tokens[significant[before]]);
        let behind = significant.get(at + 1).map(|&behind| tokens[behind].raw);
        let begins = before.is_none_or(|before| {
            let new_line = text[before.end as usize..token.start as usize].contains(['\n', '\r']);
            // Behind a text too: `TEST 'nothing yet' END_TEST`.
            matches!(before.raw, Raw::Semicolon | Raw::Characters | Raw::Quoted) || before.keyword.is_some() || new_line
        });
        let name = matches!(behind, Some(Raw::Becomes | Raw::Colon | Raw::Comma | Raw::Point | Raw::ParenOpen | Raw::BracketOpen));
        if begins && !name {
            tokens[index].keyword = Some(keyword);
        }
    }
}

impl Parser<'_> {
    /// SETUP, TEARDOWN or TEST with its variables and statements; the current token is its keyword.
    pub(super) fn test_part(&mut self, items: &mut Vec<Item>) {
        let token = self.token();
        let (part, end, word) = match token.keyword {
            Some(Keyword::Setup) => (TestPart::Setup, Keyword::EndSetup, "SETUP"),
            Some(Keyword::Teardown) => (TestPart::Teardown, Keyword::EndTeardown, "TEARDOWN"),
            _ => (TestPart::Test, Keyword::EndTest, "TEST"),
        };
        self.start(SyntaxKind::Block);
        let keyword = self.bump(SyntaxKind::Keyword);
        let title = if part == TestPart::Test { Some(self.test_name(keyword)) } else { None };
        // No other block can have this name: it has a blank. The number keeps apart what has the same one.
        let number = items.iter().filter(|item| matches!(item, Item::Block(block) if matches!(block.kind, BlockKind::Test(_)))).count();
        let shown = title.as_ref().map_or(String::new(), |title| format!(" '{}'", title.text));
        let span = title.as_ref().map_or(keyword, |title| title.span);
        let name = Name { text: format!("{word} {number}{shown}"), quoting: Quoting::Global, span };
        let mut block = self.new_block(BlockKind::Test(part), name, token.start);
        block.header.title = title;
        self.declared.clear();
        self.labels.clear();
        self.awaited.clear();
        self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
        self.block_parts(&mut block, Some(end));
        let last = self.token();
        self.block_end(end, token.start, word);
        self.eat(Raw::Semicolon, SyntaxKind::Semicolon);
        block.end = self.span(last.start.min(self.previous), self.previous);
        block.span = self.since(token.start);
        self.finish();
        self.declared.clear();
        if part == TestPart::Setup {
            // What SETUP declares is there for the tests: else it could prepare nothing of its own.
            for mut section in block.sections.extract_if(.., |section| section.kind == SectionKind::Var) {
                section.kind = SectionKind::Global;
                items.push(Item::Globals(section));
            }
        }
        items.push(Item::Block(Box::new(block)));
    }

    /// The name of a test: a text in quotes.
    fn test_name(&mut self, keyword: Span) -> Name {
        let token = self.token();
        let text = self.slice(token);
        if matches!(token.raw, Raw::Characters | Raw::Quoted) && !self.on_new_line() {
            let quote = if token.raw == Raw::Quoted { '"' } else { '\'' };
            let text = unquoted(text, quote).replace("$'", "'").replace("$\"", "\"").replace("$$", "$");
            let span = self.bump(SyntaxKind::Declared);
            if text.trim().is_empty() {
                let message = "a TEST has a name that says what is true when it passes";
                self.report(Diagnostic::new(Problem::P2300, span, message).help("Write `TEST 'the motor starts'`."));
            }
            return Name { text, quoting: Quoting::Bare, span };
        }
        if self.at_name() && !self.on_new_line() {
            let name = self.name(SyntaxKind::Declared);
            let right = format!("'{}'", name.text);
            let message = format!("the name of a TEST stands in quotes: {right}");
            self.report(Diagnostic::new(Problem::P2300, name.span, message).fix(name.span, right.clone(), format!("write `{right}`")));
            return name;
        }
        self.report(Diagnostic::new(Problem::P2300, keyword, "this TEST has no name").help("Write `TEST 'the motor starts'`."));
        Name { text: String::new(), quoting: Quoting::Bare, span: keyword }
    }

    /// `VAR … END_VAR` outside of everything: variables of the whole file.
    pub(super) fn test_variables(&mut self, items: &mut Vec<Item>) {
        let mut section = self.section();
        section.kind = SectionKind::Global;
        items.push(Item::Globals(section));
    }

    /// `MOCK instance;` and `MOCK_FUNCTION name RETURNS value;`, as calls of a function with that name.
    pub(super) fn mock(&mut self) -> Option<StatementKind> {
        let function = self.at_word("MOCK_FUNCTION");
        if !self.dialect.is_test() || !(function || self.at_word("MOCK")) || !self.is_name(self.behind(self.at)) {
            return None;
        }
        let start = self.here();
        let text = self.current().to_ascii_uppercase();
        let word = self.bump(SyntaxKind::Keyword);
        let callee = Expression { kind: ExpressionKind::Name(Name { text, quoting: Quoting::Bare, span: word }), span: word };
        let argument = |value: Expression| Argument { name: None, direction: Direction::Assigned, span: value.span, value: Some(value) };
        let mut arguments = vec![argument(self.expression())];
        if function && self.eat_word("RETURNS") {
            arguments.push(argument(self.expression()));
        }
        let kind = ExpressionKind::Call(Box::new(Call { callee, arguments }));
        Some(StatementKind::Expression(Expression { kind, span: self.since(start) }))
    }

    /// What must hold of a test file as a whole: names of tests are there once, SETUP and TEARDOWN at most once, no statements outside.
    pub(super) fn test_file(&mut self, items: &mut Vec<Item>) {
        self.outside(items);
        let blocks = || items.iter().filter_map(|item| if let Item::Block(block) = item { Some(&**block) } else { None });
        let mut names: HashMap<&str, Span> = HashMap::new();
        let mut parts: HashMap<TestPart, Span> = HashMap::new();
        for block in blocks() {
            match (block.kind, &block.header.title) {
                (BlockKind::Test(TestPart::Test), Some(title)) if !title.text.is_empty() => match names.get(title.text.as_str()) {
                    Some(&first) => {
                        let message = format!("there are two tests with the name `{}`", title.text);
                        self.push(Diagnostic::new(Problem::P2301, title.span, message).related(first, "the other one is here"));
                    }
                    None => drop(names.insert(&title.text, title.span)),
                },
                (BlockKind::Test(part @ (TestPart::Setup | TestPart::Teardown)), _) => match parts.get(&part) {
                    Some(&first) => {
                        let word = if part == TestPart::Setup { "SETUP" } else { "TEARDOWN" };
                        let message = format!("there are two `{word}`; a test file has one at most");
                        self.push(Diagnostic::new(Problem::P2301, block.name.span, message).related(first, "the other one is here"));
                    }
                    None => drop(parts.insert(part, block.name.span)),
                },
                _ => {}
            }
        }
        let tests = blocks().filter(|block| block.kind == BlockKind::Test(TestPart::Test));
        let too_many = tests.skip(TESTS_MAX).map(|block| block.name.span).next();
        if names.is_empty() && self.diagnostics.is_empty() {
            let message = "this test file has no TEST";
            let span = self.span(0, 0);
            self.push(Diagnostic::new(Problem::P2302, span, message).help("Write `TEST 'what is true' … END_TEST`."));
        }
        if let Some(span) = too_many {
            let message = format!("a test file has at most {TESTS_MAX} tests");
            self.push(Diagnostic::new(Problem::P2302, span, message).help("Write the others into a file of their own."));
            let mut left = TESTS_MAX;
            items.retain(|item| match item {
                Item::Block(block) if block.kind == BlockKind::Test(TestPart::Test) => {
                    left = left.saturating_sub(1);
                    left > 0
                }
                _ => true,
            });
        }
    }

    /// Statements outside of everything, and variables whose VAR is missing: those belong to the file.
    fn outside(&mut self, items: &mut Vec<Item>) {
        let outside = |item: &Item| matches!(item, Item::Block(block) if block.kind == BlockKind::Implicit);
        while let Some(index) = items.iter().position(outside) {
            let Item::Block(block) = items.remove(index) else { return };
            // A part without its beginning was told already.
            if let (Some(first), true) = (block.body.first(), self.diagnostics.is_empty()) {
                let message = "a statement of a test file stands inside `TEST`, `SETUP` or `TEARDOWN`";
                self.push(Diagnostic::new(Problem::P2303, first.span, message));
            }
            for mut section in block.sections {
                section.kind = SectionKind::Global;
                items.push(Item::Globals(section));
            }
        }
    }
}
