//! A revision of a project, put together of its blocks.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use sieben_model::block::{BlockAttributes, BlockId, BlockLanguage};
use sieben_model::diagnostic::{Certainty, Diagnostic};
use sieben_model::problems::Problem;
use sieben_model::source::Sources;

use super::attributes::attributes;
use super::check::{Checked, Checking, exists, has_statements};
use super::declarations::Names;
use super::headers::Found;
use super::lower::{self, Lowered};
use super::{Goal, Memory, Work};
use crate::body::CheckedBody;
use crate::compiled::Compiled;
use crate::coverage::Countable;
use crate::library::Linked;
use crate::options::Options;
use crate::scope::Scope;
use crate::st::declare::{Bodies, Demand, Environment, Needed, environment};
use crate::st::lower::mocking;
use crate::st::standard::LinkedSource;
use crate::st::untold::Untold;

/// What a revision is made of.
pub(super) struct Revision<'a> {
    pub(super) sources: &'a Sources,
    pub(super) options: &'a Options,
    pub(super) names: &'a Names<'a>,
    /// What is not said because declarations cannot be read.
    pub(super) untold: &'a Untold,
    pub(super) goal: Goal,
    /// What of the library is there.
    pub(super) needed: &'a Needed,
    pub(super) linked: Vec<Linked>,
    pub(super) linked_sources: Vec<LinkedSource>,
    /// Whether there is any source.
    pub(super) has_sources: bool,
}

impl Revision<'_> {
    /// Compiles as far as the goal asks for; tells what of the library is needed and not there, and what is used.
    pub(super) fn compile(
        mut self,
        mut diagnostics: Vec<Diagnostic>,
        memory: &mut Memory,
        work: &mut Work,
    ) -> (Compiled, Vec<Demand>, Needed) {
        let names = self.names;
        let (library, st_library) = (std::mem::take(&mut self.linked), std::mem::take(&mut self.linked_sources));
        let mut compiled = Compiled { library, st_library, ..Compiled::default() };
        let mut sources = self.sources.clone();
        compiled.add_library_sources(&mut sources);
        let mut declared = names.declare(&memory.layouts);
        diagnostics.append(&mut declared.diagnostics);
        let (known, globals) = (std::mem::take(&mut declared.known), std::mem::take(&mut declared.globals));
        let mut uses = Needed::default();
        uses.add(&known.uses);
        let environment = environment(&names.items, (&names.scope, &names.links), &declared.interfaces, &declared.data, known, globals);
        let mut hasher = DefaultHasher::new();
        (names.surroundings, &declared.layouts.asked_outside).hash(&mut hasher);
        let around_st = hasher.finish();
        let checking =
            Checking { sources: &sources, options: self.options, names, declared: &declared, environment: &environment, around_st };

        let checked = check_all(&checking, &memory.checked);
        let mut bodies = Bodies::default();
        for found in names.found.iter().filter(|found| !compiled.is_of_library(found.id)) {
            // What a check finds in a block of the library is no matter of the user's; that there are no errors is a test.
            diagnostics.extend(checked.get(&found.id).into_iter().flat_map(|done| &done.diagnostics).cloned());
        }
        for (&id, &code) in &names.items.code {
            let Some(done) = checked.get(&id) else { continue };
            bodies.diagnostics.extend(done.diagnostics.iter().cloned());
            if let Some(told) = &done.told {
                bodies.add(id, code.dialect.is_test(), told);
            }
            // What the library uses of itself is needed only while the user needs it.
            if !compiled.is_of_library(id) {
                uses.add(&done.uses);
            }
        }
        environment.finish(&names.cpu, &|id| exists(names, &declared, id), &mut bodies);
        uses.add(&names.items.uses);
        let of_bodies = std::mem::take(&mut bodies.diagnostics);
        diagnostics.extend(of_bodies.into_iter().filter(|diagnostic| compiled.is_of_user(diagnostic.span.file)));
        compiled.program.names = environment.program_names(&|id| compiled.is_of_library(id), &mut diagnostics);
        diagnostics.extend(self.without_main(&compiled, &checked, &bodies));
        for fix in diagnostics.iter_mut().filter(|diagnostic| diagnostic.problem == Problem::P2046).filter_map(|found| found.fix.as_mut()) {
            // The parser does not know the symbol table.
            let name = fix.replacement.strip_prefix('"').and_then(|name| name.strip_suffix('"'));
            if name.is_some_and(|name| names.scope.global(name).is_some()) {
                fix.certainty = Certainty::Certain;
            }
        }
        if self.options.syntax_only {
            diagnostics.retain(|diagnostic| !diagnostic.may_be_elsewhere);
        }
        diagnostics.retain(|diagnostic| self.untold.lets_through(diagnostic, self.sources));
        settle(&mut diagnostics);
        diagnostics.sort_by_key(|diagnostic| (diagnostic.span.file, diagnostic.span.start));
        compiled.diagnostics = diagnostics;
        let demands = environment.demands();
        // A block of the library is missing: the caller begins again with it.
        if self.goal != Goal::Diagnostics && self.needed.has_all(&demands) {
            let lowered = lower_all(names, &environment, &checked, self.options.counted, &memory.lowered);
            work.lowered.extend(renewed(&lowered, &memory.lowered));
            if self.goal == Goal::Code {
                memory.lowered.clone_from(&lowered);
            }
            compiled.program.attributes = attributes(names);
            compiled.take_in(lowered, &checked, bodies);
            compiled.block_names = block_names(&names.found, &names.scope);
            compiled.block_names.extend(names.items.names.iter().map(|(&id, name)| (id, name.clone())));
        }
        work.checked.extend(renewed(&checked, &memory.checked));
        compiled.program.data = std::mem::take(&mut declared.filled);
        memory.layouts = declared.layouts;
        memory.checked = checked;
        (compiled, demands, uses)
    }

    /// The warning that nothing runs in the cycle.
    fn without_main(&self, compiled: &Compiled, checked: &Blocks<Checked>, bodies: &Bodies) -> Option<Diagnostic> {
        let (names, main) = (self.names, BlockId::ob(1));
        let of_source = names.blocks.contains_key(&main) || checked.get(&main).is_some_and(|checked| checked.body.is_some());
        let has_main = of_source || bodies.code.contains_key(&main) || bodies.failed;
        // Tasks of a CONFIGURATION may all have intervals.
        let configured = names.items.configurations.iter().any(|(configuration, _)| !configuration.resources.is_empty());
        if !self.has_sources || has_main || configured {
            return None;
        }
        let stl = names.found.iter().find(|found| !compiled.is_of_library(found.id)).map(|found| found.block.name.span());
        let place = stl
            .or_else(|| names.items.code.iter().find(|(id, _)| !names.items.is_of_library(**id)).map(|(_, code)| code.block.name.span))
            .unwrap_or_default();
        Some(Diagnostic::new(Problem::P3013, place, "there is no OB 1, so nothing runs in the cycle").elsewhere())
    }
}

/// What a step gave, by block.
pub(super) type Blocks<T> = HashMap<BlockId, Arc<T>>;

/// Checks all blocks, as far as nothing of before holds.
fn check_all(checking: &Checking<'_>, before: &Blocks<Checked>) -> Blocks<Checked> {
    let names = checking.names;
    let stl = names.found.iter().filter(|found| has_statements(found.id.kind));
    let stl = stl.map(|found| (found.id, checking.stl(found, before.get(&found.id))));
    stl.chain(names.items.code.iter().map(|(&id, &code)| (id, checking.st(id, code, before.get(&id))))).collect()
}

/// Lowers all blocks that could be checked, as far as nothing of before holds.
fn lower_all(
    names: &Names<'_>,
    environment: &Environment<'_>,
    checked: &Blocks<Checked>,
    counted: bool,
    before: &Blocks<Lowered>,
) -> Blocks<Lowered> {
    let lowered =
        |(&id, checked): (&BlockId, &Arc<Checked>)| Some((id, lower::block(names, environment, id, checked, counted, before.get(&id))?));
    checked.iter().filter_map(lowered).collect()
}

/// The blocks of which a step gave something else than before.
fn renewed<T>(now: &Blocks<T>, before: &Blocks<T>) -> impl Iterator<Item = BlockId> {
    let is_new = |(&id, one): (&BlockId, &Arc<T>)| before.get(&id).is_none_or(|before| !Arc::ptr_eq(before, one)).then_some(id);
    now.iter().filter_map(is_new)
}

impl Compiled {
    /// Takes in the blocks with their code.
    fn take_in(&mut self, lowered: Blocks<Lowered>, checked: &Blocks<Checked>, bodies: Bodies) {
        let Bodies { code, made, intervals, tests, .. } = bodies;
        (self.intervals, self.tests) = (intervals, tests);
        for (id, lowered) in lowered {
            let Lowered { code, countable, .. } = Arc::unwrap_or_clone(lowered);
            self.program.code.insert(id, code);
            let is_mine = !self.is_of_library(id) && !self.tests.blocks.contains(&id);
            self.countable.extend(countable.filter(|_| is_mine).map(|countable| (id, countable)));
        }
        for &id in code.keys() {
            self.program.attributes.entry(id).or_insert(BlockAttributes::of(BlockLanguage::St));
        }
        self.program.code.extend(code);
        self.bodies = checked.iter().filter_map(|(&id, checked)| Some((id, Arc::clone(checked.body.as_ref()?)))).collect();
        self.bodies.extend(made.into_iter().map(|(id, typed)| (id, Arc::new(CheckedBody::St(typed)))));
        for moved in mocking::prepare(&mut self.program, &self.tests) {
            self.countable.entry(moved).and_modify(Countable::moved_by_one);
        }
    }
}

/// Drops guesses of the parser where the checker, which knows the names, is certain of the same place.
fn settle(diagnostics: &mut Vec<Diagnostic>) {
    let certainty = |one: &Diagnostic| one.fix.as_ref().map(|fix| fix.certainty);
    let of_signs = diagnostics.iter().filter(|one| one.problem == Problem::P2007);
    let settled: HashSet<_> = of_signs.filter(|one| certainty(one) == Some(Certainty::Certain)).map(|one| one.span).collect();
    diagnostics.retain(|one| one.problem != Problem::P2007 || certainty(one) != Some(Certainty::Guess) || !settled.contains(&one.span));
}

/// Names of blocks for display: their symbols, else the NAME of their header.
fn block_names(found: &[Found<'_>], scope: &Scope) -> BTreeMap<BlockId, String> {
    let headers = found.iter().filter_map(|found| Some((found.id, found.block.header.name.as_ref()?.text.clone())));
    let mut names: BTreeMap<BlockId, String> = headers.collect();
    names.extend(scope.blocks().map(|(block, name)| (block, name.to_owned())));
    names
}
