//! A revision of a project, put together of its blocks.

use std::collections::{BTreeMap, HashMap};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use sieben_model::block::BlockId;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::Sources;

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
use crate::st::declare::{Bodies, Demand, Needed, environment};
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
        self,
        mut diagnostics: Vec<Diagnostic>,
        memory: &mut Memory,
        work: &mut Work,
    ) -> (Compiled, Vec<Demand>, Vec<Demand>) {
        let Self { options, names, .. } = self;
        let mut compiled = Compiled { library: self.linked, st_library: self.linked_sources, ..Compiled::default() };
        let mut sources = self.sources.clone();
        compiled.add_library_sources(&mut sources);
        let mut declared = names.declare(&memory.layouts);
        diagnostics.append(&mut declared.diagnostics);
        let (known, globals) = (std::mem::take(&mut declared.known), std::mem::take(&mut declared.globals));
        let mut uses = known.uses.clone();
        let environment = environment(&names.items, (&names.scope, &names.links), &declared.interfaces, &declared.data, known, globals);
        let mut hasher = DefaultHasher::new();
        (names.surroundings, &declared.layouts.asked_outside).hash(&mut hasher);
        let around_st = hasher.finish();
        let checking = Checking { sources: &sources, options, names, declared: &declared, environment: &environment, around_st };

        let mut checked: HashMap<BlockId, Arc<Checked>> = HashMap::new();
        for found in names.found.iter().filter(|found| has_statements(found.id.kind)) {
            let done = checking.stl(found, memory.checked.get(&found.id));
            // What a check finds in a block of the library is no matter of the user's; that there are no errors is a test.
            if !compiled.is_of_library(found.id) {
                diagnostics.extend(done.diagnostics.iter().cloned());
            }
            checked.insert(found.id, done);
        }
        let mut bodies = Bodies::default();
        for (&id, &code) in &names.items.code {
            let done = checking.st(id, code, memory.checked.get(&id));
            bodies.diagnostics.extend(done.diagnostics.iter().cloned());
            if let Some(st) = &done.st {
                bodies.add(id, code.dialect.is_test(), st);
            }
            // What the library uses of itself is needed only while the user needs it.
            if !compiled.is_of_library(id) {
                uses.extend_from_slice(&done.uses);
            }
            checked.insert(id, done);
        }
        environment.finish(&names.cpu, &|id| exists(names, &declared, id), &mut bodies);
        uses.extend_from_slice(&names.items.uses);

        let has_code = |id: BlockId| {
            let of_source = checked.get(&id).is_some_and(|checked| checked.body.is_some());
            of_source || bodies.code.contains_key(&id)
        };
        let has_main = names.blocks.contains_key(&BlockId::ob(1)) || has_code(BlockId::ob(1)) || bodies.failed;
        diagnostics
            .extend(std::mem::take(&mut bodies.diagnostics).into_iter().filter(|diagnostic| compiled.is_of_user(diagnostic.span.file)));
        compiled.program.names = environment.program_names(&mut diagnostics);
        // Tasks of a CONFIGURATION may all have intervals.
        let configured = names.items.configurations.iter().any(|(configuration, _)| !configuration.resources.is_empty());
        if self.has_sources && !has_main && !configured {
            let stl = names.found.iter().find(|found| !compiled.is_of_library(found.id)).map(|found| found.block.name.span());
            let place = stl.or_else(|| names.items.code.values().next().map(|code| code.block.name.span)).unwrap_or_default();
            diagnostics.push(Diagnostic::new(Problem::P3013, place, "there is no OB 1, so nothing runs in the cycle"));
        }
        if options.syntax_only {
            diagnostics.retain(|diagnostic| !needs_other_files(diagnostic.problem));
        }
        diagnostics.retain(|diagnostic| self.untold.lets_through(diagnostic, self.sources));
        diagnostics.sort_by_key(|diagnostic| (diagnostic.span.file, diagnostic.span.start));
        compiled.diagnostics = diagnostics;
        let demands = environment.demands();
        // A block of the library is missing: the caller begins again with it.
        if self.goal != Goal::Diagnostics && self.needed.has_all(&demands) {
            let mut lowered: HashMap<BlockId, Arc<Lowered>> = HashMap::with_capacity(checked.len());
            for (&id, checked) in &checked {
                let before = memory.lowered.get(&id);
                if let Some(code) = lower::block(names, &environment, id, checked, options.counted, before) {
                    if before.is_none_or(|before| !Arc::ptr_eq(before, &code)) {
                        work.lowered.insert(id);
                    }
                    lowered.insert(id, code);
                }
            }
            if self.goal == Goal::Code {
                memory.lowered.clone_from(&lowered);
            }
            compiled.take_in(lowered, &checked, bodies);
            compiled.block_names = block_names(&names.found, &names.scope);
            compiled.block_names.extend(names.items.names.iter().map(|(&id, name)| (id, name.clone())));
        }
        let is_new = |(&id, checked): (&BlockId, &Arc<Checked>)| {
            memory.checked.get(&id).is_none_or(|before| !Arc::ptr_eq(before, checked)).then_some(id)
        };
        work.checked.extend(checked.iter().filter_map(is_new));
        compiled.program.data = std::mem::take(&mut declared.filled);
        memory.layouts = declared.layouts;
        memory.checked = checked;
        (compiled, demands, once(uses))
    }
}

/// Each once, in the order of their first places.
fn once(uses: Vec<Demand>) -> Vec<Demand> {
    let mut once: Vec<Demand> = Vec::new();
    for demand in uses {
        if !once.contains(&demand) {
            once.push(demand);
        }
    }
    once
}

impl Compiled {
    /// Takes in the blocks with their code.
    fn take_in(&mut self, lowered: HashMap<BlockId, Arc<Lowered>>, checked: &HashMap<BlockId, Arc<Checked>>, bodies: Bodies) {
        let Bodies { code, made, intervals, tests, .. } = bodies;
        for (id, lowered) in lowered {
            let Lowered { code, countable, .. } = Arc::unwrap_or_clone(lowered);
            self.program.code.insert(id, code);
            self.countable.extend(countable.map(|countable| (id, countable)));
        }
        self.program.code.extend(code);
        self.bodies = checked.iter().filter_map(|(&id, checked)| Some((id, Arc::clone(checked.body.as_ref()?)))).collect();
        self.bodies.extend(made.into_iter().map(|(id, typed)| (id, Arc::new(CheckedBody::St(typed)))));
        (self.intervals, self.tests) = (intervals, tests);
        let strangers = |id: &BlockId| self.library.iter().any(|linked| linked.id == *id) || self.tests.blocks.contains(id);
        let of_library = |id: &BlockId| self.st_library.iter().any(|linked| linked.blocks.contains(id));
        self.countable.retain(|id, _| !strangers(id) && !of_library(id));
        for moved in mocking::prepare(&mut self.program, &self.tests) {
            self.countable.entry(moved).and_modify(Countable::moved_by_one);
        }
    }
}

/// Problems that may come of files that were not given.
fn needs_other_files(problem: Problem) -> bool {
    matches!(
        problem,
        Problem::P3003
            | Problem::P3008
            | Problem::P3013
            | Problem::P3014
            | Problem::P3015
            | Problem::P3018
            | Problem::P3020
            | Problem::P3021
    )
}

/// Names of blocks for display: their symbols, else the NAME of their header.
fn block_names(found: &[Found<'_>], scope: &Scope) -> BTreeMap<BlockId, String> {
    let headers = found.iter().filter_map(|found| Some((found.id, found.block.header.name.as_ref()?.text.clone())));
    let mut names: BTreeMap<BlockId, String> = headers.collect();
    names.extend(scope.blocks().map(|(block, name)| (block, name.to_owned())));
    names
}
