//! CONFIGURATION: resources, tasks, programs.

use sieben_model::problems::Problem;

use super::super::ast::{Argument, Configuration, Direction, Name, Path, ProgramInstance, Qualifier, Resource, Task};
use super::super::dialect::Construct;
use super::super::keywords::Keyword;
use super::super::lexer::Raw;
use super::{Parser, SyntaxKind};

impl Parser<'_> {
    /// CONFIGURATION; the current token is its keyword.
    pub(super) fn configuration(&mut self) -> Configuration {
        let token = self.token();
        self.judge(Construct::Configuration, token.start, token.end);
        self.take_attributes();
        self.start(SyntaxKind::Block);
        self.first_keyword();
        self.declared.clear();
        let name = self.block_name("CONFIGURATION");
        let mut configuration = Configuration { name, sections: Vec::new(), resources: Vec::new(), span: self.since(token.start) };
        let mut unnamed = Resource { span: self.since(self.previous), ..Resource::default() };
        loop {
            match self.keyword() {
                Some(keyword) if keyword.begins_section() && keyword != Keyword::Label => {
                    let section = self.section();
                    configuration.sections.push(section);
                }
                _ if self.at_word("RESOURCE") => {
                    let resource = self.resource();
                    configuration.resources.push(resource);
                }
                _ if self.resource_part(&mut unnamed) => {}
                _ if self.foreign_part(Keyword::EndConfiguration) => {}
                _ => break,
            }
        }
        if !(unnamed.tasks.is_empty() && unnamed.programs.is_empty()) {
            configuration.resources.push(unnamed);
        }
        self.block_end(Keyword::EndConfiguration, token.start, "CONFIGURATION");
        configuration.span = self.since(token.start);
        self.finish();
        configuration
    }

    fn resource(&mut self) -> Resource {
        let start = self.here();
        self.start(SyntaxKind::Block);
        self.bump(SyntaxKind::Keyword);
        let mut resource = Resource { name: self.block_name("RESOURCE"), ..Resource::default() };
        if self.eat_word("ON") && self.at_name() {
            resource.on = Some(self.name(SyntaxKind::TypeWord));
        }
        loop {
            match self.keyword() {
                Some(keyword) if keyword.begins_section() && keyword != Keyword::Label => {
                    let section = self.section();
                    resource.sections.push(section);
                }
                _ if self.resource_part(&mut resource) => {}
                _ if self.foreign_part(Keyword::EndResource) => {}
                _ => break,
            }
        }
        self.block_end(Keyword::EndResource, start, "RESOURCE");
        resource.span = self.since(start);
        self.finish();
        resource
    }

    /// Skips what does not belong into a configuration or resource that ends with this keyword; `false` if something ends here.
    fn foreign_part(&mut self, end: Keyword) -> bool {
        let ends = match self.keyword() {
            Some(Keyword::EndVar | Keyword::EndResource) => self.at_keyword(end),
            Some(keyword) => keyword.is_end() || keyword.begins_block(),
            None => self.raw() == Raw::End,
        };
        if ends {
            return false;
        }
        let shown = self.shown();
        self.unexpected(Problem::P2019, format!("{shown} begins neither a TASK nor a PROGRAM nor declarations"));
        let end = self.keyword().is_some_and(|keyword| keyword.is_end());
        self.bump_unexpected();
        if !end {
            self.skip_declaration();
        }
        true
    }

    /// A task, a program, or `;`; `false` if none begins here.
    fn resource_part(&mut self, resource: &mut Resource) -> bool {
        if self.eat(Raw::Semicolon, SyntaxKind::Semicolon) {
            return true;
        }
        self.take_attributes();
        let start = self.here();
        if self.at_word("TASK") {
            self.start(SyntaxKind::Statement);
            self.bump(SyntaxKind::Keyword);
            let name = self.block_name("TASK");
            let arguments = match self.raw() {
                Raw::ParenOpen => self.arguments().0,
                _ => Vec::new(),
            };
            let span = self.since(start);
            self.declaration_end();
            self.finish();
            resource.tasks.push(Task { name, arguments, span });
            return true;
        }
        if !self.at_keyword(Keyword::Program) {
            return false;
        }
        self.start(SyntaxKind::Statement);
        self.bump(SyntaxKind::Keyword);
        let retain = [("RETAIN", Qualifier::Retain), ("NON_RETAIN", Qualifier::NonRetain)].into_iter().find(|(word, _)| self.at_word(word));
        let retain = retain.map(|(_, qualifier)| (qualifier, self.bump(SyntaxKind::Keyword)));
        let name = self.block_name("PROGRAM");
        let task = match self.eat_word("WITH") {
            true => Some(self.block_name("WITH")),
            false => None,
        };
        if !self.eat(Raw::Colon, SyntaxKind::Punctuation) {
            self.missing(Problem::P2020, " :", "`:` with the name of the PROGRAM is missing");
        }
        let program = match self.at_name() {
            true => self.path(SyntaxKind::TypeWord),
            false => {
                let name = self.block_name("`:`");
                Path { span: name.span, names: vec![name] }
            }
        };
        let (mut arguments, mut bound) = (Vec::new(), Vec::new());
        if self.raw() == Raw::ParenOpen {
            self.program_arguments(&mut arguments, &mut bound);
        }
        let span = self.since(start);
        self.declaration_end();
        self.finish();
        resource.programs.push(ProgramInstance { name, retain, task, program, arguments, bound, span });
        true
    }

    /// `(in := x, out => y, fb1 WITH t)`.
    fn program_arguments(&mut self, arguments: &mut Vec<Argument>, bound: &mut Vec<(Name, Name)>) {
        self.start(SyntaxKind::Arguments);
        self.bump(SyntaxKind::Punctuation);
        while self.at_name() {
            let start = self.here();
            let name = self.name(SyntaxKind::Name);
            if self.eat_word("WITH") {
                bound.push((name, self.block_name("WITH")));
            } else {
                let direction = if self.raw() == Raw::Delivers { Direction::Delivered } else { Direction::Assigned };
                if !matches!(self.raw(), Raw::Delivers | Raw::Becomes) {
                    let shown = self.shown();
                    self.unexpected(Problem::P2030, format!("`:=`, `=>` or `WITH` is wanted here, not {shown}"));
                    break;
                }
                self.bump(SyntaxKind::Operator);
                let value = Some(self.expression());
                arguments.push(Argument { name: Some(name), direction, value, span: self.since(start) });
            }
            if !self.eat(Raw::Comma, SyntaxKind::Punctuation) {
                break;
            }
        }
        self.close(Raw::ParenClose, ")");
        self.finish();
    }
}
