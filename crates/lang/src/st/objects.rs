//! Blocks as objects: what they extend and implement, and which members they have.

use std::collections::{BTreeMap, BTreeSet};

use sieben_model::block::BlockId;
use sieben_model::source::Span;

use super::ast::{Access, BlockKind, MemberKind};
use super::dialect::Dialect;
use crate::scope::key;

/// The variable at the begin of an instance that says of which block it is.
///
/// Blocks that extend others, are extended or implement an interface have it; its value is the number of the function block.
pub const TYPE_NUMBER: &str = "__TYPE";
/// Bits of that number, with which an instance begins.
pub const TYPE_NUMBER_BITS: u32 = 16;

/// By the key of the name and how it is called.
pub type MemberKey = (String, MemberKind);

/// A METHOD, or GET or SET of a PROPERTY.
#[derive(Clone, Debug, PartialEq)]
pub struct Member {
    /// The function that it is.
    pub function: BlockId,
    /// The block that declares it.
    pub of: BlockId,
    /// Its name.
    pub name: String,
    /// What calls it.
    pub kind: MemberKind,
    /// Who may use it; everybody unless it says otherwise.
    pub access: Access,
    /// It has no statements.
    pub is_abstract: bool,
    /// Nothing may override it.
    pub is_final: bool,
    /// It says that it overrides another one.
    pub is_override: bool,
    /// It has statements.
    pub has_body: bool,
    /// The place of its name.
    pub span: Span,
}

/// A function block, a program, a class or an interface.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Its name.
    pub name: String,
    /// The place of its name.
    pub span: Span,
    /// Its dialect.
    pub dialect: Dialect,
    /// What it is.
    pub kind: BlockKind,
    /// What it extends.
    pub base: Option<BlockId>,
    /// What it implements, or what an interface extends.
    pub interfaces: Vec<BlockId>,
    /// It extends what could not be found or extended, and what it inherits from there is not known.
    pub lacks_base: bool,
    /// It has no instances of its own.
    pub is_abstract: bool,
    /// Nothing may extend it.
    pub is_final: bool,
    /// The namespace that it belongs to, with a point behind it; empty outside any.
    pub namespace: String,
    /// What it declares itself.
    pub members: BTreeMap<MemberKey, Member>,
}

/// The function that a call by a base or an interface reaches, for each block that an instance may be of.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Dispatch {
    /// Numbers of function blocks and of what is called for their instances.
    pub targets: Vec<(u16, u16)>,
}

/// All objects of a program.
#[derive(Clone, Debug, Default)]
pub struct Objects {
    all: BTreeMap<BlockId, Object>,
    /// Blocks that extend each block or implement each interface, at any distance.
    below: BTreeMap<BlockId, BTreeSet<BlockId>>,
    /// Blocks whose instances say of which block they are.
    typed: BTreeSet<BlockId>,
    /// No block has methods or properties.
    memberless: bool,
    /// No block has properties.
    propertyless: bool,
}

impl Objects {
    /// Puts the relations of the blocks together; none of them extends itself, at any distance.
    pub(crate) fn new(all: BTreeMap<BlockId, Object>) -> Self {
        let memberless = all.values().all(|object| object.members.is_empty());
        let mut members = all.values().flat_map(|object| object.members.values());
        let propertyless = members.all(|member| member.kind == MemberKind::Method);
        let mut objects = Self { all, memberless, propertyless, ..Self::default() };
        for (&id, object) in &objects.all {
            let above = objects.above(id);
            if !above.is_empty() || object.kind == BlockKind::Interface || object.is_abstract {
                objects.typed.insert(id);
                objects.typed.extend(above.iter().copied());
            }
            for upper in above {
                objects.below.entry(upper).or_default().insert(id);
            }
        }
        objects
    }

    /// The object, if the block is one.
    pub fn get(&self, block: BlockId) -> Option<&Object> {
        self.all.get(&block)
    }
    /// All objects by block.
    pub fn iter(&self) -> impl Iterator<Item = (BlockId, &Object)> {
        self.all.iter().map(|(&id, object)| (id, object))
    }
    /// Whether the block is an interface.
    pub fn is_interface(&self, block: BlockId) -> bool {
        self.get(block).is_some_and(|object| object.kind == BlockKind::Interface)
    }
    /// Whether an instance of the block says at its begin of which block it is.
    pub fn is_typed(&self, block: BlockId) -> bool {
        self.typed.contains(&block)
    }
    /// Whether the first block is the second one, extends it or implements it.
    pub fn is_a(&self, block: BlockId, of: BlockId) -> bool {
        block == of || self.below.get(&of).is_some_and(|below| below.contains(&block))
    }
    /// Whether the block or one above it lacks its base, so that it may have more than is known.
    pub fn lacks_base(&self, block: BlockId) -> bool {
        std::iter::once(block).chain(self.above(block)).any(|one| self.get(one).is_some_and(|object| object.lacks_base))
    }
    /// Whether anything extends or implements the block.
    pub fn is_extended(&self, block: BlockId) -> bool {
        self.below.contains_key(&block)
    }
    /// What an instance of a block that is known as this one may be of: no interfaces, nothing abstract.
    pub fn concrete(&self, block: BlockId) -> impl Iterator<Item = BlockId> {
        let below = self.below.get(&block).into_iter().flatten().copied();
        std::iter::once(block).chain(below).filter(|&one| self.get(one).is_some_and(|object| !object.is_abstract))
    }

    /// Whether no block has methods or properties.
    pub fn is_without_members(&self) -> bool {
        self.memberless
    }

    /// Whether no block has properties.
    pub fn is_without_properties(&self) -> bool {
        self.propertyless
    }

    /// Everything that a block extends or implements, the nearest first.
    pub fn above(&self, block: BlockId) -> Vec<BlockId> {
        let mut found = Vec::new();
        let mut seen = BTreeSet::from([block]);
        let mut next = vec![block];
        while let Some(one) = next.pop() {
            let Some(object) = self.get(one) else { continue };
            for upper in object.interfaces.iter().rev().chain(&object.base).copied() {
                if seen.insert(upper) {
                    found.push(upper);
                    next.push(upper);
                }
            }
        }
        found
    }

    /// The member that a block has under a name, its own or the nearest of those above.
    pub fn member(&self, block: BlockId, name: &str, kind: MemberKind) -> Option<&Member> {
        let wanted = (key(name), kind);
        let mut at = Some(block);
        // Bases first: what a base has counts for the interfaces of those that extend it.
        while let Some(object) = at.and_then(|at| self.get(at)) {
            if let Some(member) = object.members.get(&wanted) {
                return Some(member);
            }
            at = object.base;
        }
        self.above(block).into_iter().find_map(|upper| self.get(upper)?.members.get(&wanted))
    }

    /// What of this kind and name the blocks above declare.
    pub fn overridden(&self, block: BlockId, name: &str, kind: MemberKind) -> Vec<&Member> {
        let wanted = (key(name), kind);
        self.above(block).into_iter().filter_map(|upper| self.get(upper)?.members.get(&wanted)).collect()
    }

    /// What a call through a base or an interface may reach beside the function that is known; `None` if it is always that one.
    pub fn dispatch(&self, block: BlockId, member: &Member) -> Option<Dispatch> {
        let all = self.concrete(block).filter_map(|one| {
            let found = self.member(one, &member.name, member.kind)?;
            Some((one.number, found.function))
        });
        let targets: Vec<(u16, BlockId)> = all.collect();
        let single = !member.is_abstract && targets.iter().all(|(_, function)| *function == member.function);
        (!single).then(|| Dispatch { targets: targets.into_iter().map(|(of, function)| (of, function.number)).collect() })
    }

    /// What a call of an instance through a base may reach: the blocks themselves.
    pub fn dispatch_body(&self, block: BlockId) -> Option<Dispatch> {
        let targets: Vec<(u16, u16)> = self.concrete(block).map(|one| (one.number, one.number)).collect();
        (targets != [(block.number, block.number)]).then_some(Dispatch { targets })
    }
}
