//! The call structure: which block calls which, with the local data of every path.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};

use sieben_lang::Compiled;
pub use sieben_lang::references::CallKind;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::source::Span;

use crate::cross_reference::{Reference, Usage};
use crate::target::{Indirect, Target};

/// A block, as far as it is known when the program is compiled.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Callee {
    /// This one.
    Block(BlockId),
    /// Computed at run time or given by a parameter: `FC [MW 0]`, `#block`.
    Unknown(Target),
}

/// One or more calls in a block that call the same in the same way.
#[derive(Clone, Debug, PartialEq)]
pub struct CallSite {
    /// What is called.
    pub callee: Callee,
    /// How.
    pub kind: CallKind,
    /// Its instance: a data block, or a variable of the caller.
    pub instance: Option<Target>,
    /// Where, in order: network, statement and place.
    pub places: Vec<(u32, usize, Span)>,
}

/// A code block in the call structure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Caller {
    /// Bytes of local data that it needs itself.
    pub local_data: u32,
    /// What it calls, in the order of the first call.
    pub calls: Vec<CallSite>,
    /// Most bytes of local data of a path that begins with it, itself included; without the repetition of a recursion.
    pub path_local_data: u32,
    /// Most blocks on a path that begins with it, itself included.
    pub path_depth: usize,
    /// It may call itself, directly or through others.
    pub recursive: bool,
}

/// Who calls whom.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CallStructure {
    /// All code blocks of the program.
    pub blocks: BTreeMap<BlockId, Caller>,
    /// Organization blocks: the CPU starts them.
    pub roots: Vec<BlockId>,
    /// Blocks that no organization block reaches and none of their own kind calls: the first of each tree.
    pub not_called: Vec<BlockId>,
}

/// A line of the printed structure.
#[derive(Clone, Debug, PartialEq)]
pub struct Line<'a> {
    /// How deep, the first block is 0.
    pub depth: usize,
    /// The block.
    pub callee: Callee,
    /// The call; `None` for the first block.
    pub site: Option<&'a CallSite>,
    /// Bytes of local data of the block itself.
    pub own: u32,
    /// Bytes of local data from the first block to this one.
    pub local_data: u32,
    /// What is special about it.
    pub mark: Mark,
}

/// What is special about a line of the structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Nothing.
    None,
    /// The block stands above on the same path: a recursion. What it calls is not repeated.
    Recursion,
    /// What the block calls stands above in the same tree.
    Above,
    /// The block is not in the program.
    Missing,
    /// A function of the CPU.
    System,
    /// Which block it is, is not known.
    Unknown,
}

impl CallStructure {
    /// The structure of a program.
    pub fn new(compiled: &Compiled) -> Self {
        let mut blocks = BTreeMap::new();
        for &id in compiled.bodies.keys() {
            let local_data = compiled.program.code.get(&id).map_or(0, |code| code.local_size);
            blocks.insert(id, Caller { local_data, calls: calls(&compiled.references(id)), ..Caller::default() });
        }
        let mut structure = Self { blocks, ..Self::default() };
        structure.measure();
        structure.roots = structure.blocks.keys().copied().filter(|id| id.kind == BlockKind::OrganizationBlock).collect();
        structure.not_called = structure.unreached(compiled);
        structure
    }

    /// The blocks of the program that a block calls, each once.
    fn callees(&self, id: BlockId) -> Vec<BlockId> {
        let mut callees = Vec::new();
        let mut known = BTreeSet::new();
        for site in self.blocks.get(&id).map_or(&[][..], |caller| &caller.calls) {
            if let Callee::Block(callee) = site.callee
                && self.blocks.contains_key(&callee)
                && known.insert(callee)
            {
                callees.push(callee);
            }
        }
        callees
    }

    /// Longest paths and recursions, by depth-first search; a call back to a block of the path is not followed.
    fn measure(&mut self) {
        let mut done: BTreeSet<BlockId> = BTreeSet::new();
        let mut order = Vec::with_capacity(self.blocks.len());
        for start in self.blocks.keys().copied().collect::<Vec<_>>() {
            // The blocks of the path, each with those that it calls and are still to be visited.
            let mut path: Vec<(BlockId, Vec<BlockId>)> = Vec::new();
            let mut entered = BTreeSet::from([start]);
            if !done.contains(&start) {
                path.push((start, self.callees(start)));
            }
            while let Some((id, rest)) = path.last_mut() {
                let id = *id;
                if let Some(next) = rest.pop() {
                    if !done.contains(&next) && entered.insert(next) {
                        path.push((next, self.callees(next)));
                    }
                    continue;
                }
                path.pop();
                done.insert(id);
                order.push(id);
                let below = self.callees(id).into_iter().filter_map(|callee| self.blocks.get(&callee));
                let (local_data, depth) = below.fold((0, 0), |(local_data, depth): (u32, usize), callee| {
                    (local_data.max(callee.path_local_data), depth.max(callee.path_depth))
                });
                if let Some(caller) = self.blocks.get_mut(&id) {
                    caller.path_local_data = caller.local_data.saturating_add(local_data);
                    caller.path_depth = depth + 1;
                }
            }
        }
        self.mark_recursions(&order);
    }

    /// Marks the blocks that reach themselves; `order` has every block behind those that only it reaches (Kosaraju).
    fn mark_recursions(&mut self, order: &[BlockId]) {
        let mut callers: BTreeMap<BlockId, Vec<BlockId>> = BTreeMap::new();
        let mut recursive = BTreeSet::new();
        for &id in order {
            for callee in self.callees(id) {
                callers.entry(callee).or_default().push(id);
                if callee == id {
                    recursive.insert(id);
                }
            }
        }
        let mut seen = BTreeSet::new();
        for &id in order.iter().rev() {
            let mut group = Vec::new();
            let mut waiting = vec![id];
            while let Some(id) = waiting.pop() {
                if seen.insert(id) {
                    group.push(id);
                    waiting.extend(callers.get(&id).into_iter().flatten().copied());
                }
            }
            if group.len() > 1 {
                recursive.extend(group);
            }
        }
        for (id, caller) in &mut self.blocks {
            caller.recursive = recursive.contains(id);
        }
    }

    /// The first blocks of the trees that no organization block reaches; not those that came with others from the library.
    fn unreached(&self, compiled: &Compiled) -> Vec<BlockId> {
        let mut reached = BTreeSet::new();
        self.reach(&self.roots, &mut reached);
        let rest: Vec<BlockId> = self.blocks.keys().copied().filter(|id| !reached.contains(id) && !compiled.is_of_library(*id)).collect();
        let called: BTreeSet<BlockId> =
            rest.iter().flat_map(|&id| self.callees(id).into_iter().filter(move |&callee| callee != id)).collect();
        let mut first: Vec<BlockId> = rest.iter().copied().filter(|id| !called.contains(id)).collect();
        self.reach(&first, &mut reached);
        // Blocks that only call one another have no first one: the lowest stands for them.
        for id in rest {
            if !reached.contains(&id) {
                first.push(id);
                self.reach(&[id], &mut reached);
            }
        }
        first.sort_unstable();
        first
    }

    fn reach(&self, from: &[BlockId], reached: &mut BTreeSet<BlockId>) {
        let mut waiting = from.to_vec();
        while let Some(id) = waiting.pop() {
            if reached.insert(id) {
                waiting.extend(self.callees(id));
            }
        }
    }

    /// The tree of a block, line by line. What a block calls is written once in a tree, so that the lines stay as many as the calls.
    pub fn tree(&self, root: BlockId) -> Vec<Line<'_>> {
        self.tree_below(root, &mut BTreeSet::new())
    }

    /// The trees of all blocks that no organization block reaches, one after another. What a block calls is written once in all of them.
    pub fn not_called_trees(&self) -> Vec<Vec<Line<'_>>> {
        let mut shown = BTreeSet::new();
        self.not_called.iter().map(|&root| self.tree_below(root, &mut shown)).collect()
    }

    fn tree_below(&self, root: BlockId, shown: &mut BTreeSet<BlockId>) -> Vec<Line<'_>> {
        let mut lines = Vec::new();
        let own = |id: BlockId| self.blocks.get(&id).map_or(0, |caller| caller.local_data);
        lines.push(Line { depth: 0, callee: Callee::Block(root), site: None, own: own(root), local_data: own(root), mark: Mark::None });
        shown.insert(root);
        let sites = |id: BlockId| self.blocks.get(&id).map_or(&[][..], |caller| &caller.calls).iter();
        let mut path = vec![(root, own(root), sites(root))];
        let mut on_path = BTreeSet::from([root]);
        while let Some((id, local_data, rest)) = path.last_mut() {
            let Some(site) = rest.next() else {
                on_path.remove(id);
                path.pop();
                continue;
            };
            let above = *local_data;
            let depth = path.len();
            let mut line = Line { depth, callee: site.callee.clone(), site: Some(site), own: 0, local_data: above, mark: Mark::None };
            match site.callee {
                Callee::Unknown(_) => line.mark = Mark::Unknown,
                Callee::Block(BlockId { kind: BlockKind::SystemFunction | BlockKind::SystemFunctionBlock, .. }) => line.mark = Mark::System,
                Callee::Block(id) if !self.blocks.contains_key(&id) => line.mark = Mark::Missing,
                Callee::Block(id) => {
                    line.own = own(id);
                    line.local_data = above.saturating_add(line.own);
                    let calls = self.blocks.get(&id).is_some_and(|caller| !caller.calls.is_empty());
                    if on_path.contains(&id) {
                        line.mark = Mark::Recursion;
                    } else if shown.insert(id) {
                        on_path.insert(id);
                        path.push((id, line.local_data, sites(id)));
                    } else if calls {
                        line.mark = Mark::Above;
                    }
                }
            }
            lines.push(line);
        }
        lines
    }
}

/// The calls of a block; the instance of a call stands behind its callee.
fn calls(references: &[Reference]) -> Vec<CallSite> {
    let mut calls: Vec<CallSite> = Vec::new();
    let mut known: BTreeMap<(Callee, CallKind, Option<Target>), usize> = BTreeMap::new();
    for (index, reference) in references.iter().enumerate() {
        let Usage::Call(kind) = reference.usage else { continue };
        let callee = match &reference.target {
            Target::Block(block) => Callee::Block(*block),
            other @ (Target::Indirect(Indirect { .. }) | Target::Local { .. }) => Callee::Unknown(other.clone()),
            Target::Memory(_) | Target::Timer(_) | Target::Counter(_) => continue,
        };
        let instance = references.get(index + 1).filter(|next| next.statement == reference.statement && next.usage == Usage::Instance);
        let instance = instance.map(|next| next.target.clone());
        let place = (reference.network, reference.statement, reference.span);
        match known.entry((callee.clone(), kind, instance.clone())) {
            Entry::Occupied(index) => calls[*index.get()].places.push(place),
            Entry::Vacant(index) => {
                index.insert(calls.len());
                calls.push(CallSite { callee, kind, instance, places: vec![place] });
            }
        }
    }
    calls
}
