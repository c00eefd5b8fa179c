//! Interfaces and types that were laid out before and still hold.
//!
//! Each block has a *stamp*, which is another one as soon as its syntax is, and each layout a *version*, which is another one as soon as
//! its shape is. A layout holds while its stamp is the same and all that it asked for has the version that it had.

use std::collections::{HashMap, HashSet};
use std::fmt::Debug;
use std::sync::Arc;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::types::Structure;

use super::data_block::DataLayout;
use super::types::BlockInterface;

/// Which syntax a block has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Stamp {
    /// Another one as soon as anything of the block, or its place, is another one.
    pub(crate) syntax: u64,
    /// How it is written: messages quote the source, and another spelling may be the same syntax.
    pub(crate) text: u64,
    /// What its declarations read, wherever they stand.
    pub(crate) declarations: u64,
}

/// The version of what does not exist.
const ABSENT: u64 = 0;

/// What a language finds out while it lays out blocks, besides their interfaces.
pub(crate) trait Knows: Default {
    /// What of it belongs to one block.
    type Own: Clone + Debug;
    /// How much was known before a block was laid out.
    type Mark;
    /// How much is known.
    fn mark(&self) -> Self::Mark;
    /// What was found out about a block since then; `None` if more was found out than this can hold.
    fn own(&self, block: BlockId, since: &Self::Mark) -> Option<Self::Own>;
    /// Takes in what was found out about a block that is as before; `since` is what was known before the blocks that it asks for.
    fn take_in(&mut self, block: BlockId, own: &Self::Own, since: &Self::Mark);
}

/// The layout of a block or type, with what it was made of.
#[derive(Clone, Debug)]
pub(crate) struct LaidOut<O> {
    stamp: Stamp,
    /// The blocks and types that it asked for, with their versions.
    asked: Vec<(BlockId, u64)>,
    /// What it is.
    is: Layout,
    /// What its language found out besides; `None` if it cannot be taken again because something was said about it, or found out that
    /// does not belong to it alone.
    own: Option<O>,
    /// Changes with the shape.
    version: u64,
}

/// What is laid out.
#[derive(Clone, Debug)]
pub(crate) enum Layout {
    Type(Option<Arc<Structure>>),
    Block(Option<BlockInterface>),
}

impl Layout {
    /// Whether another layout has the same shape; where names stand does not matter.
    fn has_shape_of(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Type(one), Self::Type(other)) => one == other,
            (Self::Block(Some(one)), Self::Block(Some(other))) => one.has_shape_of(other),
            (Self::Block(one), Self::Block(other)) => one.is_none() && other.is_none(),
            _ => false,
        }
    }
}

/// The layouts of a revision.
#[derive(Debug)]
pub(crate) struct Layouts<O> {
    all: HashMap<BlockId, LaidOut<O>>,
    /// The data blocks with their versions.
    data: HashMap<u16, (DataLayout, u64)>,
    /// What named types, constants and global variables asked for.
    pub(crate) asked_outside: Vec<(BlockId, u64)>,
    /// Which blocks and names there were, if what they declare may be taken again: nothing is wrong, and the order does not matter.
    pub(crate) surroundings: Option<u64>,
    /// Whether something that several blocks share left more than its layout, so that it matters which of them asks first.
    pub(crate) depends_on_order: bool,
    /// The last version that was given away.
    last_version: u64,
}

impl<O> Default for Layouts<O> {
    fn default() -> Self {
        let (all, data, asked_outside) = (HashMap::new(), HashMap::new(), Vec::new());
        Self { all, data, asked_outside, surroundings: None, depends_on_order: false, last_version: ABSENT }
    }
}

impl<O> Layouts<O> {
    /// The version of a block, a type or a data block.
    pub(crate) fn version(&self, id: BlockId) -> u64 {
        match id.kind {
            BlockKind::DataBlock => self.data.get(&id.number).map_or(ABSENT, |(_, version)| *version),
            _ => self.all.get(&id).map_or(ABSENT, |laid_out| laid_out.version),
        }
    }

    /// Whether a block declares nothing beyond its interface, so that its version stands for all of it.
    pub(crate) fn is_whole(&self, id: BlockId) -> bool {
        self.all.get(&id).is_some_and(|laid_out| laid_out.own.is_some())
    }

    /// Gives the data blocks their versions.
    pub(crate) fn version_data(&mut self, before: &Self, data: &HashMap<u16, DataLayout>) {
        let last = &mut self.last_version;
        let versioned = data.iter().map(|(&number, layout)| {
            let same = |other: &DataLayout| {
                let same_fields = Arc::ptr_eq(&other.structure, &layout.structure) || other.structure == layout.structure;
                other.based_on == layout.based_on && same_fields
            };
            let version = match before.data.get(&number) {
                Some((other, version)) if same(other) => *version,
                _ => {
                    *last += 1;
                    *last
                }
            };
            (number, (layout.clone(), version))
        });
        self.data = versioned.collect();
    }
}

/// What is known of layouts while types are resolved: those of before, and those of now.
#[derive(Debug)]
pub(crate) struct Reuse<'a, O> {
    before: &'a Layouts<O>,
    /// Whether layouts of before are taken at all.
    trusting: bool,
    now: Layouts<O>,
    /// What the layouts that are being made asked for, outermost first; `None` for what several blocks share.
    frames: Vec<Option<Vec<BlockId>>>,
    outside: HashSet<BlockId>,
}

impl<'a, O: Clone> Reuse<'a, O> {
    /// With `trusting` what was laid out before is taken where it holds; else all is laid out again, and what has the same shape
    /// has the same version.
    pub(crate) fn new(before: &'a Layouts<O>, trusting: bool) -> Self {
        let now = Layouts { last_version: before.last_version, ..Layouts::default() };
        // What is asked for only in order to have all of it is of no matter.
        Self { before, trusting, now, frames: vec![Some(Vec::new())], outside: HashSet::new() }
    }

    /// A block or type is asked for.
    pub(crate) fn ask(&mut self, id: BlockId) {
        match self.frames.last_mut() {
            Some(Some(frame)) => {
                if !frame.contains(&id) {
                    frame.push(id);
                }
            }
            Some(None) | None => drop(self.outside.insert(id)),
        }
    }

    /// Something begins that several blocks share: a named type, a constant.
    pub(crate) fn begin_shared(&mut self) {
        self.frames.push(None);
    }

    /// It ends.
    pub(crate) fn end_shared(&mut self) {
        self.frames.pop();
    }

    /// What ended left more than its layout.
    pub(crate) fn depends_on_order(&mut self) {
        self.now.depends_on_order = true;
    }

    /// The layout of before whose syntax is the same, and what it asked for; whether that is the same, the caller finds out.
    pub(crate) fn candidate(&self, id: BlockId, stamp: Stamp) -> Option<&'a [(BlockId, u64)]> {
        let before = self.before.all.get(&id)?;
        (self.trusting && before.own.is_some() && before.stamp == stamp).then_some(&before.asked)
    }

    /// The version that a block or type has now.
    pub(crate) fn version(&self, id: BlockId) -> u64 {
        self.now.version(id)
    }

    /// The layout of before is that of now.
    pub(crate) fn keep(&mut self, id: BlockId) -> Option<(&'a Layout, &'a O)> {
        let before = self.before.all.get(&id)?;
        self.now.all.insert(id, before.clone());
        Some((&before.is, before.own.as_ref()?))
    }

    /// A layout begins.
    pub(crate) fn begin(&mut self) {
        self.frames.push(Some(Vec::new()));
    }

    /// It ends; gets its version.
    pub(crate) fn end(&mut self, id: BlockId, stamp: Stamp, is: Layout, own: Option<O>) {
        let asked = self.frames.pop().flatten().unwrap_or_default();
        let asked = asked.into_iter().map(|id| (id, self.version(id))).collect();
        let same = |before: &LaidOut<O>| {
            own.is_some() == before.own.is_some() && before.stamp.declarations == stamp.declarations && before.is.has_shape_of(&is)
        };
        let version = match self.before.all.get(&id) {
            Some(before) if same(before) => before.version,
            _ => {
                self.now.last_version += 1;
                self.now.last_version
            }
        };
        self.now.all.insert(id, LaidOut { stamp, asked, is, own, version });
    }

    /// The layouts of now.
    pub(crate) fn finish(mut self) -> Layouts<O> {
        let mut outside: Vec<(BlockId, u64)> = self.outside.iter().map(|&id| (id, self.version(id))).collect();
        outside.sort_unstable();
        self.now.asked_outside = outside;
        self.now
    }
}
