//! Types, interfaces and user-defined types of all languages, each resolved once.

use std::collections::HashMap;
use std::sync::Arc;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::interface::Interface;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, Structure};

use super::NESTING_MAX;
use super::reuse::{Knows, Layout, Reuse, Stamp};
use super::system::System;
use crate::scope::Scope;

/// The interface of a function block with the layout of its instances.
#[derive(Clone, Debug)]
pub(crate) struct BlockInterface {
    pub(crate) interface: Arc<Interface>,
    pub(crate) instance: Arc<Structure>,
}

impl BlockInterface {
    /// Whether another interface has the same variables at the same addresses; where their names stand does not matter.
    pub(crate) fn has_shape_of(&self, other: &Self) -> bool {
        let same = Arc::ptr_eq(&self.interface, &other.interface) || self.interface.has_shape_of(&other.interface);
        same && (Arc::ptr_eq(&self.instance, &other.instance) || self.instance == other.instance)
    }
}

/// How far something is that is resolved once.
pub(crate) enum State<T> {
    InProgress,
    Done(Option<T>),
}

/// What the sources of one language declare. A language resolves its own syntax; the others see the result.
pub(crate) trait Declares<'a, K: Knows> {
    /// Which syntax a block or type has that it [has](Self::has).
    fn stamp(&self, block: BlockId) -> Stamp;
    /// Whether a source declares this block.
    fn has(&self, block: BlockId) -> bool;
    /// The structure of a user-defined type; `None` if no source declares it, `Some(None)` if it is wrong, which is reported.
    fn user_defined(&'a self, types: &mut Types<'a, K>, number: u16, span: Span) -> Option<Option<Arc<Structure>>>;
    /// The interface of a block that it [has](Self::has); `None` if it cannot be laid out, which is reported.
    fn interface(&'a self, types: &mut Types<'a, K>, block: BlockId) -> Option<BlockInterface>;
}

/// Resolves types and interfaces, each once.
pub(crate) struct Types<'a, K: Knows> {
    pub(crate) scope: &'a Scope,
    /// The languages of the project; of two that have a block the first counts.
    languages: &'a [&'a dyn Declares<'a, K>],
    system: &'a System,
    udts: HashMap<u16, State<Arc<Structure>>>,
    interfaces: HashMap<BlockId, State<BlockInterface>>,
    depth: usize,
    /// What the languages themselves have found out so far.
    pub(crate) known: K,
    /// What was laid out before and still holds.
    pub(crate) reuse: Reuse<'a, K::Own>,
    pub(crate) diagnostics: Vec<Diagnostic>,
}

impl<'a, K: Knows> Types<'a, K> {
    pub(crate) fn new(scope: &'a Scope, languages: &'a [&'a dyn Declares<'a, K>], system: &'a System, reuse: Reuse<'a, K::Own>) -> Self {
        let (udts, interfaces, known, diagnostics) = (HashMap::new(), HashMap::new(), K::default(), Vec::new());
        Self { scope, languages, system, udts, interfaces, depth: 0, known, reuse, diagnostics }
    }

    /// The number of errors so far.
    pub(crate) fn errors(&self) -> usize {
        self.diagnostics.iter().filter(|diagnostic| diagnostic.severity() == Severity::Error).count()
    }

    pub(crate) fn report(&mut self, problem: Problem, span: Span, message: impl Into<String>) -> &mut Diagnostic {
        self.diagnostics.push(Diagnostic::new(problem, span, message));
        self.diagnostics.last_mut().expect("one was pushed")
    }

    /// The structure of a user-defined type.
    pub(crate) fn udt(&mut self, number: u16, span: Span) -> Option<Arc<Structure>> {
        let id = BlockId::new(BlockKind::UserDefinedType, number);
        self.reuse.ask(id);
        match self.udts.get(&number) {
            Some(State::Done(done)) => return done.clone(),
            Some(State::InProgress) => {
                self.report(Problem::P3016, span, format!("`{id}` contains itself"));
                return None;
            }
            None => {}
        }
        for language in self.languages {
            if let Some(structure) = language.user_defined(self, number, span) {
                return structure;
            }
        }
        let diagnostic = self.report(Problem::P3015, span, format!("`{id}` does not exist"));
        diagnostic.may_be_elsewhere = true;
        diagnostic.help = Some(format!("Add its source: `TYPE {id} STRUCT … END_STRUCT; END_TYPE`."));
        None
    }

    /// Resolves a user-defined type, unless it is nested too deep, and keeps what came of it.
    pub(crate) fn keep_udt(
        &mut self,
        number: u16,
        stamp: Stamp,
        span: Span,
        resolve: impl FnOnce(&mut Self) -> Option<Arc<Structure>>,
    ) -> Option<Arc<Structure>> {
        if !self.enter(span) {
            return None;
        }
        self.udts.insert(number, State::InProgress);
        let id = BlockId::new(BlockKind::UserDefinedType, number);
        let structure = match self.layout(id, stamp, span, |types| Layout::Type(resolve(types))) {
            Layout::Type(structure) => structure,
            Layout::Block(_) => None,
        };
        self.leave();
        self.udts.insert(number, State::Done(structure.clone()));
        structure
    }

    /// The layout of before, if it still holds; else a new one, which can be taken again if nothing was said about it.
    fn layout(&mut self, id: BlockId, stamp: Stamp, span: Span, lay_out: impl FnOnce(&mut Self) -> Layout) -> Layout {
        let since = self.known.mark();
        if let Some((before, own)) = self.as_before(id, stamp, span) {
            self.known.take_in(id, own, &since);
            return before.clone();
        }
        self.reuse.begin();
        let (said, since) = (self.diagnostics.len(), self.known.mark());
        let layout = lay_out(self);
        let own = self.known.own(id, &since).filter(|_| self.diagnostics.len() == said);
        self.reuse.end(id, stamp, layout.clone(), own);
        layout
    }

    /// The layout of before, if it still holds: its syntax is the same, and so is all that it asked for.
    fn as_before(&mut self, id: BlockId, stamp: Stamp, span: Span) -> Option<(&'a Layout, &'a K::Own)> {
        for &(asked, version) in self.reuse.candidate(id, stamp)? {
            match asked.kind {
                BlockKind::UserDefinedType => drop(self.udt(asked.number, span)),
                _ => drop(self.interface(asked, span)),
            }
            if self.reuse.version(asked) != version {
                return None;
            }
        }
        self.reuse.keep(id)
    }

    /// The interface of a code block or system block; `None` if it does not exist (nothing is reported) or cannot be laid out.
    pub(crate) fn interface(&mut self, id: BlockId, span: Span) -> Option<BlockInterface> {
        self.reuse.ask(id);
        match self.interfaces.get(&id) {
            Some(State::Done(done)) => return done.clone(),
            Some(State::InProgress) => {
                let name = self.scope.blocks().filter(|(block, _)| *block == id).map(|(_, name)| name.to_owned()).min();
                let name = name.unwrap_or_else(|| id.to_string());
                self.report(Problem::P3016, span, format!("`{name}` contains an instance of itself"));
                return None;
            }
            None => {}
        }
        let laid_out = if let Some(language) = self.languages.iter().find(|language| language.has(id)) {
            if !self.enter(span) {
                return None;
            }
            self.interfaces.insert(id, State::InProgress);
            let laid_out = match self.layout(id, language.stamp(id), span, |types| Layout::Block(language.interface(types, id))) {
                Layout::Block(laid_out) => laid_out,
                Layout::Type(_) => None,
            };
            self.leave();
            laid_out
        } else {
            Some(self.system.get(&id)?.interface.clone())
        };
        self.interfaces.insert(id, State::Done(laid_out.clone()));
        laid_out
    }

    /// A STRUCT whose fields are placed, up to this bit; `None` if it has none, which is reported.
    pub(crate) fn closed(&mut self, mut structure: Structure, end: u64, span: Span) -> Option<Arc<Structure>> {
        if structure.fields.is_empty() {
            self.report(Problem::P2211, span, "this STRUCT has no fields");
            return None;
        }
        structure.size = (end.next_multiple_of(16) / 8) as u32;
        Some(Arc::new(structure))
    }

    /// Goes one level deeper; `false` if that is too deep, which is reported.
    pub(crate) fn enter(&mut self, span: Span) -> bool {
        if self.depth >= NESTING_MAX {
            let message = format!("types are nested in one another deeper than {NESTING_MAX} levels here");
            self.report(Problem::P4008, span, message);
            return false;
        }
        self.depth += 1;
        true
    }

    /// Comes back from a deeper level.
    pub(crate) fn leave(&mut self) {
        self.depth -= 1;
    }

    /// Whether a block has a source or is one of the CPU's.
    pub(crate) fn exists(&self, block: BlockId) -> bool {
        self.languages.iter().any(|language| language.has(block)) || self.system.contains_key(&block)
    }

    /// The type that a block is: a UDT, or an FB or SFB for an instance.
    pub(crate) fn type_of_block(&mut self, block: BlockId, span: Span) -> Option<DataType> {
        match block.kind {
            BlockKind::UserDefinedType => self.udt(block.number, span).map(DataType::Struct),
            BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock => {
                if !self.exists(block) {
                    self.report(Problem::P3008, span, format!("`{block}` does not exist")).may_be_elsewhere = true;
                    return None;
                }
                let structure = self.interface(block, span)?.instance;
                Some(DataType::Instance { block, structure })
            }
            _ => {
                let message = format!("`{block}` is not a type; a type is a UDT, or an FB or SFB for an instance");
                self.report(Problem::P3015, span, message);
                None
            }
        }
    }
}

/// The type in the user's words.
pub(crate) fn describe(data_type: &DataType) -> String {
    data_type.to_string()
}
