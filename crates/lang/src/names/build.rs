//! Collects the names of a text.

use std::collections::HashMap;

use sieben_model::address::Operand;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::Span;

use super::{Access, Bytes, CallSite, Definition, DefinitionKind, NameId, Occurrence, SourceNames, TypeRef, Written};
use crate::scope::key;

/// What collects them.
pub(crate) struct Builder<'t> {
    text: &'t str,
    names: SourceNames,
    /// The occurrence of each definition that has one.
    places: HashMap<u32, u32>,
    /// The block that the names stand in.
    pub(crate) scope: Option<u32>,
    /// What definitions belong to.
    pub(crate) parent: Option<u32>,
}

impl<'t> Builder<'t> {
    pub(crate) fn new(text: &'t str, mnemonics: Option<Mnemonics>) -> Self {
        Self { text, names: SourceNames { mnemonics, ..SourceNames::default() }, places: HashMap::new(), scope: None, parent: None }
    }

    pub(crate) fn text(&self) -> &'t str {
        self.text
    }

    /// The number of a name.
    pub(crate) fn id(&mut self, name: &str) -> NameId {
        self.intern(key(name))
    }

    fn intern(&mut self, key: String) -> NameId {
        if let Some(&id) = self.names.ids.get(key.as_str()) {
            return id;
        }
        let id = self.names.names.len() as NameId;
        self.names.names.push(key.as_str().into());
        self.names.ids.insert(key.into(), id);
        id
    }

    /// Where the name itself stands in its place, which may have quotes or `#`; `None` if it is not written there.
    pub(crate) fn locate(&self, span: Span, name: &str) -> Option<Bytes> {
        let (start, end) = (span.start as usize, span.end as usize);
        let slice = self.text.get(start..end)?;
        if name.is_empty() {
            return None;
        }
        let bytes = |from: usize, length: usize| Bytes { start: (start + from) as u32, end: (start + from + length) as u32 };
        if slice == name {
            return Some(bytes(0, slice.len()));
        }
        let inner = slice.trim_start_matches("P#").trim_start_matches('#').trim_matches(['"', '`', '“', '”', '„']);
        let at = inner.as_ptr() as usize - slice.as_ptr() as usize;
        if key(inner) == key(name) {
            return Some(bytes(at, inner.len()));
        }
        let lower = slice.to_lowercase();
        // Other cases have the same length, or nothing is found.
        let found = (lower.len() == slice.len()).then(|| lower.find(&name.to_lowercase())).flatten()?;
        slice.get(found..found + name.len()).map(|name| bytes(found, name.len()))
    }

    /// A definition at the place of its name.
    pub(crate) fn define(&mut self, kind: DefinitionKind, name: &str, span: Span, whole: Span) -> u32 {
        let place = self.locate(span, name).unwrap_or(Bytes { start: span.start, end: span.start });
        self.define_at(kind, name, place, Bytes { start: whole.start, end: whole.end })
    }

    /// The same where the place is known.
    pub(crate) fn define_at(&mut self, kind: DefinitionKind, name: &str, span: Bytes, whole: Bytes) -> u32 {
        let index = self.names.definitions.len() as u32;
        let id = if kind == DefinitionKind::Label { self.label_id(name) } else { self.id(name) };
        if self.names.defined.len() <= id as usize {
            self.names.defined.resize_with(id as usize + 1, Vec::new);
        }
        self.names.defined[id as usize].push(index);
        self.names.definitions.push(Definition {
            id,
            name: name.to_owned(),
            kind,
            parent: self.parent,
            span,
            whole: Bytes { start: whole.start.min(span.start), end: whole.end.max(span.end) },
            data_type: String::new(),
            of: TypeRef::None,
            extends: Vec::new(),
            comment: String::new(),
            operand: None,
            body: Bytes::default(),
            members: Vec::new(),
        });
        if let Some(parent) = self.parent {
            self.names.definitions[parent as usize].members.push(index);
        }
        if span.start < span.end {
            let place = self.push(span, Written::Definition(index), Access::Definition);
            self.places.insert(index, place);
        }
        index
    }

    /// A definition that was begun.
    pub(crate) fn definition(&mut self, index: u32) -> &mut Definition {
        &mut self.names.definitions[index as usize]
    }

    /// Gives a definition the type of another one: names that are declared together share it, and its names stand there once.
    pub(crate) fn share_type(&mut self, index: u32, first: u32) {
        let Definition { data_type, of, members, .. } = self.definition(first).clone();
        let definition = self.definition(index);
        (definition.data_type, definition.of, definition.members) = (data_type, of, members);
    }

    /// The occurrence of a definition.
    pub(crate) fn occurrence_of(&self, definition: u32) -> Option<u32> {
        self.places.get(&definition).copied()
    }

    /// A member of what definitions belong to, by its name.
    pub(crate) fn member(&self, name: &str) -> Option<u32> {
        self.member_of(self.parent?, self.names.id(&key(name))?)
    }

    fn member_of(&self, of: u32, id: NameId) -> Option<u32> {
        self.names.definitions[of as usize].members.iter().copied().find(|&member| self.names.definitions[member as usize].id == id)
    }

    /// What the block or what it belongs to declares under a name.
    pub(crate) fn variable(&self, name: &str) -> Option<u32> {
        let id = self.names.id(&key(name))?;
        let mut scope = self.scope;
        while let Some(of) = scope {
            if let Some(member) = self.member_of(of, id) {
                return Some(member);
            }
            scope = self.names.definitions[of as usize].parent;
        }
        None
    }

    /// A call with brackets.
    pub(crate) fn call(&mut self, callee: u32, whole: Bytes, arguments: Vec<(Bytes, bool)>) {
        self.names.calls.push(CallSite { callee, whole, arguments });
    }

    /// A place where something is written.
    pub(crate) fn push(&mut self, span: Bytes, written: Written, access: Access) -> u32 {
        let index = self.names.occurrences.len() as u32;
        self.names.occurrences.push(Occurrence { span, written, access, scope: self.scope });
        index
    }

    /// Changes how the last thing is used.
    pub(crate) fn use_as(&mut self, occurrence: u32, access: Access) {
        if let Some(one) = self.names.occurrences.get_mut(occurrence as usize) {
            one.access = access;
        }
    }

    /// A name at its place; `None` if it is not written there.
    pub(crate) fn name(&mut self, name: &str, span: Span, written: impl FnOnce(NameId) -> Written, access: Access) -> Option<u32> {
        let place = self.locate(span, name)?;
        let id = self.id(name);
        Some(self.push(place, written(id), access))
    }

    /// A jump to a label of STL.
    pub(crate) fn label(&mut self, name: &str, span: Span) {
        if let Some(place) = self.locate(span, name) {
            let id = self.label_id(name);
            self.push(place, Written::Label(id), Access::Jump);
        }
    }

    /// The number of a label: in STL its case matters, and no other name has its key.
    fn label_id(&mut self, name: &str) -> NameId {
        match self.names.mnemonics {
            Some(_) => self.intern(format!(":{name}")),
            None => self.id(name),
        }
    }

    /// An address, a timer, a counter or a block.
    pub(crate) fn operand(&mut self, operand: Operand, span: Span, access: Access) -> Option<u32> {
        let place = Bytes { start: span.start, end: span.end };
        self.text.get(place.start as usize..place.end as usize).filter(|text| !text.is_empty())?;
        Some(self.push(place, Written::Operand(operand), access))
    }

    /// All that was collected.
    pub(crate) fn finish(mut self) -> SourceNames {
        let all = &self.names.occurrences;
        let mut order: Vec<u32> = (0..all.len() as u32).collect();
        order.sort_by_key(|&index| {
            let one = &all[index as usize];
            (one.span.start, std::cmp::Reverse(one.span.end), index)
        });
        // Elements of a diagram may stand for several statements: each place counts once.
        let mut moved = vec![0; all.len()];
        let mut kept: Vec<Occurrence> = Vec::with_capacity(all.len());
        let mut places: HashMap<Bytes, u32> = HashMap::new();
        for index in order {
            let one = all[index as usize];
            let same = places.get(&one.span).copied();
            match same.and_then(|same| Some((same, kept.get_mut(same as usize)?))) {
                Some((same, known)) => {
                    known.access = both(known.access, one.access);
                    moved[index as usize] = same;
                }
                None => {
                    moved[index as usize] = kept.len() as u32;
                    places.insert(one.span, kept.len() as u32);
                    kept.push(one);
                }
            }
        }
        let mut by_name = vec![Vec::new(); self.names.names.len()];
        let mut addresses = Vec::new();
        for (index, one) in kept.iter_mut().enumerate() {
            let index = index as u32;
            one.written = match one.written {
                Written::Member(of, name) => Written::Member(moved[of as usize], name),
                Written::Parameter(of, name) => Written::Parameter(moved[of as usize], name),
                Written::InBlock(of, address) => Written::InBlock(moved[of as usize], address),
                other => other,
            };
            match one.written {
                Written::Local(id)
                | Written::Plain(id)
                | Written::Global(id)
                | Written::Member(_, id)
                | Written::Parameter(_, id)
                | Written::Label(id) => by_name[id as usize].push(index),
                Written::Definition(definition) => {
                    by_name[self.names.definitions[definition as usize].id as usize].push(index);
                    if self.names.definitions[definition as usize].operand.is_some() {
                        addresses.push(index);
                    }
                }
                Written::Operand(_) | Written::InBlock(..) | Written::Range(..) | Written::Indirect(_) => addresses.push(index),
            }
        }
        self.names.occurrences = kept;
        self.names.calls.iter_mut().for_each(|call| call.callee = moved[call.callee as usize]);
        self.names.calls.sort_by_key(|call| call.callee);
        self.names.by_name = by_name;
        self.names.addresses = addresses;
        self.names
    }
}

/// Both of two ways to use something.
fn both(one: Access, other: Access) -> Access {
    match (one, other) {
        (one, other) if one == other => one,
        (Access::Read | Access::ReadWrite, Access::Write | Access::ReadWrite) | (Access::Write | Access::ReadWrite, Access::Read) => {
            Access::ReadWrite
        }
        (one, _) => one,
    }
}
