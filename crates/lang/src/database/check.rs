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
use crate::declarations::interface::too_much_local_data;
use crate::declarations::reuse::{Layouts, Stamp};
use crate::declarations::types::BlockInterface;
use crate::options::Options;
use crate::st::declare::{CheckedStatements, Code, Demand, Environment, Own, Questions, Told};
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
    pub(super) told: Option<Told>,
    asked: Asked,
    /// What of the library its statements use.
    pub(super) uses: Vec<Demand>,
}

/// What the statements of a block depend on.
#[derive(Clone, Debug)]
struct Asked {
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
    fn holds(&self, block: &Subject, layouts: &Layouts<Own>) -> bool {
        let same = |&(id, version): &(BlockId, u64)| layouts.version(id) == version;
        !self.passing
            && layouts.is_whole(block.id)
            && (self.stamp, self.around) == (block.stamp, block.around)
            && self.blocks.iter().all(same)
    }
}

/// A block that is to be checked.
struct Subject {
    id: BlockId,
    stamp: Stamp,
    /// The whole block.
    span: Span,
    /// Which blocks and names there are, and what does not belong to one block.
    around: u64,
}

/// What a check gives.
struct Outcome {
    body: Option<CheckedBody>,
    diagnostics: Vec<Diagnostic>,
    told: Option<Told>,
    questions: Questions,
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
        self.names.system.get(&id).and_then(|resident| Some((resident.name, resident.only?)))
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
        let names = self.names;
        let subject = Subject { id: found.id, stamp: found.stamp, span: found.block.span, around: names.surroundings };
        self.renewed(&subject, before, || {
            let blocks = Noting { names, declared: self.declared, asked: RefCell::default() };
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
            let (body, diagnostics) = match self.declared.interfaces.get(&found.id) {
                Some(BlockInterface { interface, .. }) => statements(&known, found, interface),
                None => (None, Vec::new()),
            };
            let questions = Questions { blocks: blocks.asked.into_inner(), ..Questions::default() };
            Outcome { body, diagnostics, told: None, questions }
        })
    }

    /// A block of ST.
    pub(super) fn st(&self, id: BlockId, code: Code<'_>, before: Option<&Arc<Checked>>) -> Arc<Checked> {
        let subject = Subject { id, stamp: code.stamp, span: code.block.span, around: self.around_st };
        self.renewed(&subject, before, || {
            drop(self.environment.take_questions());
            let CheckedStatements { typed, diagnostics, told } = self.environment.check_block(id, code, &self.names.cpu);
            let questions = self.environment.take_questions();
            Outcome { body: typed.map(CheckedBody::St), diagnostics, told: Some(told), questions }
        })
    }

    /// What is known of a block from before, if it still holds; else the outcome of a check, with what it depends on.
    fn renewed(&self, block: &Subject, before: Option<&Arc<Checked>>, check: impl FnOnce() -> Outcome) -> Arc<Checked> {
        let layouts = &self.declared.layouts;
        if let Some(before) = before.filter(|before| before.asked.holds(block, layouts)) {
            return Arc::clone(before);
        }
        let suggestions = self.names.scope.suggestions();
        let Outcome { body, diagnostics, told, questions } = check();
        let suggested = questions.names || self.names.scope.suggestions() != suggestions;
        let asked = questions.blocks.into_iter().chain([block.id]);
        let asked = Asked {
            stamp: block.stamp,
            around: block.around,
            blocks: asked.map(|id| (id, layouts.version(id))).collect(),
            passing: suggested || !stays_inside(&diagnostics, block.span),
        };
        Arc::new(Checked { body: body.map(Arc::new), diagnostics, told, asked, uses: questions.uses })
    }
}

/// Checks the statements of a block of STL.
fn statements(known: &Known<'_>, found: &Found<'_>, interface: &Interface) -> (Option<CheckedBody>, Vec<Diagnostic>) {
    let &Found { id, block, mnemonics, syntax, .. } = found;
    let cpu = known.cpu;
    let too_much = too_much_local_data(|| id.to_string(), interface, cpu, block.name.span(), false);
    let mut diagnostics: Vec<Diagnostic> = too_much.into_iter().collect();
    let mut checked = check::block(known, id, block, interface, mnemonics, &|span| syntax.is_reported(span));
    diagnostics.append(&mut checked.diagnostics);
    let bytes = code_bytes(&checked.block.statements);
    if bytes > u64::from(cpu.block_size_max) {
        let message =
            format!("`{id}` has at least {bytes} bytes of code in a CPU; a block of CPU {} has at most {}", cpu.name, cpu.block_size_max);
        diagnostics.push(Diagnostic::new(Problem::P5009, block.name.span(), message));
    }
    (checked.whole.then_some(CheckedBody::Stl(checked.block)), diagnostics)
}
