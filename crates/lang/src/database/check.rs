//! The third step: the statements of one block.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::sync::Arc;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::Interface;
use sieben_model::problems::Problem;
use sieben_model::source::{Sources, Span};

use super::declarations::{Declared, Names};
use super::headers::Found;
use crate::body::CheckedBody;
use crate::declarations::data_block::DataLayout;
use crate::declarations::reuse::{Layouts, Stamp};
use crate::declarations::types::BlockInterface;
use crate::options::Options;
use crate::st::declare::{CheckedStatements, Code, Demand, Environment, Own};
use crate::stl::check;
use crate::stl::resolve::{Blocks, Known};
use crate::stl::size::code_bytes;

/// A block whose statements were checked, with all that this depends on.
#[derive(Clone, Debug)]
pub(super) struct Checked {
    /// The statements with all names resolved, if all of them were understood.
    pub(super) body: Option<Arc<CheckedBody>>,
    /// What there is to say about them.
    pub(super) diagnostics: Vec<Diagnostic>,
    /// What a block of ST tells besides.
    pub(super) st: Option<CheckedStatements>,
    pub(super) asked: Asked,
    /// What of the library its statements use.
    pub(super) uses: Vec<Demand>,
}

/// What the statements of a block depend on.
#[derive(Clone, Debug)]
pub(super) struct Asked {
    stamp: Stamp,
    /// Which blocks and names there were, and what does not belong to one block.
    around: u64,
    /// The blocks that were asked for, with their versions.
    blocks: Vec<(BlockId, u64)>,
    /// Whether it holds for no other revision: something is said about other places, or depends on what was asked before.
    passing: bool,
}

impl Asked {
    /// Whether everything is as it was when the statements of the block were checked.
    pub(super) fn holds(&self, id: BlockId, stamp: Stamp, around: u64, layouts: &Layouts<Own>) -> bool {
        let same = |&(id, version): &(BlockId, u64)| layouts.version(id) == version;
        !self.passing && layouts.is_whole(id) && self.stamp == stamp && self.around == around && self.blocks.iter().all(same)
    }

    fn new(stamp: Stamp, around: u64, blocks: impl IntoIterator<Item = BlockId>, layouts: &Layouts<Own>, passing: bool) -> Self {
        let blocks = blocks.into_iter().map(|id| (id, layouts.version(id))).collect();
        Self { stamp, around, blocks, passing }
    }
}

/// Whether all that is said is about a place in the block.
fn stays_inside(diagnostics: &[Diagnostic], block: Span) -> bool {
    let inside = |span: Span| span.file == block.file && block.start <= span.start && span.end <= block.end;
    diagnostics.iter().all(|one| inside(one.span) && one.related.iter().all(|(span, _)| inside(*span)))
}

/// The blocks as one block of STL sees them; what it asks for is noted.
struct Noting<'a> {
    names: &'a Names<'a>,
    declared: &'a Declared,
    asked: RefCell<BTreeSet<BlockId>>,
}

impl Noting<'_> {
    fn note(&self, id: BlockId) {
        self.asked.borrow_mut().insert(id);
    }
}

impl Blocks for Noting<'_> {
    fn interface(&self, id: BlockId) -> Option<&BlockInterface> {
        self.note(id);
        self.declared.interfaces.get(&id)
    }

    fn exists(&self, id: BlockId) -> bool {
        self.note(id);
        exists(self.names, self.declared, id)
    }

    fn data(&self, number: u16) -> Option<&DataLayout> {
        self.note(BlockId::db(number));
        self.declared.data.get(&number)
    }

    fn only(&self, id: BlockId) -> Option<(&'static str, &'static str)> {
        self.names.system.get(&id).and_then(|block| Some((block.name, block.only?)))
    }
}

/// Whether a block exists, laid out or not.
pub(super) fn exists(names: &Names<'_>, declared: &Declared, id: BlockId) -> bool {
    names.blocks.contains_key(&id)
        || names.system.contains_key(&id)
        || names.items.code.contains_key(&id)
        || (id.kind == BlockKind::DataBlock && declared.data.contains_key(&id.number))
}

/// Whether a block of STL has statements that are checked.
pub(super) fn has_statements(kind: BlockKind) -> bool {
    matches!(kind, BlockKind::OrganizationBlock | BlockKind::Function | BlockKind::FunctionBlock)
}

/// Checks the statements of blocks of one revision.
pub(super) struct Checking<'a> {
    pub(super) sources: &'a Sources,
    pub(super) options: &'a Options,
    pub(super) names: &'a Names<'a>,
    pub(super) declared: &'a Declared,
    pub(super) environment: &'a Environment<'a>,
    /// What blocks of ST depend on that does not belong to one block.
    pub(super) around_st: u64,
}

impl Checking<'_> {
    /// A block of STL.
    pub(super) fn stl(&self, found: &Found<'_>, before: Option<&Arc<Checked>>) -> Arc<Checked> {
        let (names, layouts) = (self.names, &self.declared.layouts);
        let around = names.surroundings;
        if let Some(before) = before.filter(|before| before.asked.holds(found.id, found.stamp, around, layouts)) {
            return Arc::clone(before);
        }
        let asked = RefCell::new(BTreeSet::from([found.id]));
        let blocks = Noting { names, declared: self.declared, asked };
        let known = Known {
            sources: self.sources,
            scope: &names.scope,
            cpu: &names.cpu,
            blocks: &blocks,
            field_names: &self.declared.field_names,
            temporaries: self.options.temporaries,
            library: &names.links,
            selection: &self.options.library,
            extended: self.options.extended,
        };
        let suggestions = names.scope.suggestions();
        let (body, diagnostics) = match self.declared.interfaces.get(&found.id) {
            Some(BlockInterface { interface, .. }) => self.statements(&known, found, interface),
            None => (None, Vec::new()),
        };
        let passing = names.scope.suggestions() != suggestions || !stays_inside(&diagnostics, found.block.span);
        let asked = Asked::new(found.stamp, around, blocks.asked.into_inner(), layouts, passing);
        Arc::new(Checked { body, diagnostics, st: None, asked, uses: Vec::new() })
    }

    fn statements(&self, known: &Known<'_>, found: &Found<'_>, interface: &Interface) -> (Option<Arc<CheckedBody>>, Vec<Diagnostic>) {
        let &Found { id, block, mnemonics, syntax, .. } = found;
        let cpu = known.cpu;
        let mut diagnostics = Vec::new();
        if interface.local_size > cpu.local_data_block {
            let message = format!(
                "`{id}` declares {} bytes of local data; CPU {} has {} for a block",
                interface.local_size, cpu.name, cpu.local_data_block
            );
            diagnostics.push(Diagnostic::new(Problem::P5007, block.name.span(), message));
        }
        let mut checked = check::block(known, id, block, interface, mnemonics, &|span| syntax.is_reported(span));
        let bytes = code_bytes(&checked.block.statements);
        if bytes > u64::from(cpu.block_size_max) {
            let message = format!(
                "`{id}` has at least {bytes} bytes of code in a CPU; a block of CPU {} has at most {}",
                cpu.name, cpu.block_size_max
            );
            checked.diagnostics.push(Diagnostic::new(Problem::P5009, block.name.span(), message));
        }
        diagnostics.append(&mut checked.diagnostics);
        (checked.whole.then(|| Arc::new(CheckedBody::Stl(checked.block))), diagnostics)
    }

    /// A block of ST.
    pub(super) fn st(&self, id: BlockId, code: Code<'_>, before: Option<&Arc<Checked>>) -> Arc<Checked> {
        let layouts = &self.declared.layouts;
        if let Some(before) = before.filter(|before| before.asked.holds(id, code.stamp, self.around_st, layouts)) {
            return Arc::clone(before);
        }
        drop(self.environment.take_questions());
        let suggestions = self.names.scope.suggestions();
        let mut st = self.environment.check_block(id, code, &self.names.cpu);
        let diagnostics = std::mem::take(&mut st.diagnostics);
        let body = st.typed.take().map(|typed| Arc::new(CheckedBody::St(typed)));
        let questions = self.environment.take_questions();
        let passing = questions.names || self.names.scope.suggestions() != suggestions || !stays_inside(&diagnostics, code.block.span);
        let asked = questions.blocks.into_iter().chain([id]);
        let asked = Asked::new(code.stamp, self.around_st, asked, layouts, passing);
        Arc::new(Checked { body, diagnostics, st: Some(st), asked, uses: questions.uses })
    }
}
