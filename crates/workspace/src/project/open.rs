//! A project that stays open: its sources get other texts, and what is said about it is renewed.

use sieben_lang::encoding::{self, Encoding};
use sieben_lang::{Compiled, Database, Options, dialects};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::source::FileId;

use super::build::Order;
use super::{Build, Overrides, Project};
use crate::finding::Finding;

/// A project with what is known of its sources.
#[derive(Debug)]
pub struct Open {
    project: Project,
    order: Order,
    database: Database,
}

/// Whether the one that judged a dialect looks for another one that takes the program, which costs four times as much.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialects {
    /// Only the judged one.
    Judged,
    /// The others are tried, too.
    Tried,
}

impl Open {
    /// A project that was read.
    pub fn new(project: Project, overrides: Overrides, syntax_only: bool) -> Self {
        let order = Order::of(&project, overrides, syntax_only);
        let mut database = Database::new(project.symbols.clone(), order.options.clone());
        for (_, source) in project.texts.program.iter() {
            database.add(source.name.clone(), source.text.clone());
        }
        Self { project, order, database }
    }

    /// Its texts and settings.
    pub fn project(&self) -> &Project {
        &self.project
    }

    /// How it is compiled.
    pub fn options(&self) -> &Options {
        &self.order.options
    }

    /// Gives a source another text. Without an answer the project has to be read again: it became another kind of file.
    #[must_use]
    pub fn replace(&mut self, file: FileId, text: &str) -> Option<()> {
        let source = self.project.sources.iter_mut().find(|source| source.id == file && !source.embedded)?;
        let decoded = encoding::read_source_as(text.as_bytes(), Some(Encoding::Utf8)).ok().filter(|decoded| decoded.text == text)?;
        let was_lossy = source.decoded.had_errors;
        // That a source is empty is noticed where it is read.
        if decoded.had_errors || was_lossy || decoded.text.trim().is_empty() || source.decoded.text.trim().is_empty() {
            return None;
        }
        source.decoded = decoded;
        self.project.texts.program.replace(file, text);
        self.database.replace(file, text);
        Some(())
    }

    /// Everything that is wrong.
    pub fn findings(&mut self, others: Dialects) -> Vec<Finding> {
        let diagnostics = if self.order.nothing { Vec::new() } else { self.database.diagnostics() };
        self.found(diagnostics, others)
    }

    fn found(&self, mut diagnostics: Vec<Diagnostic>, others: Dialects) -> Vec<Finding> {
        if others == Dialects::Tried {
            dialects::name_another(&self.project.texts.program, &self.project.symbols, &self.order.options, &mut diagnostics);
        }
        self.project.found(&self.order, &diagnostics)
    }

    /// The project with its code, as far as it compiles.
    pub fn build(&mut self) -> Build {
        let compiled = if self.order.nothing { Compiled::default() } else { self.database.compiled() };
        self.project.clone().built(&self.order, compiled)
    }
}
