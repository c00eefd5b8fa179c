//! Methods and properties as blocks of their own: what the declarations and the checker know how to handle.
//!
//! A METHOD `M` of `F` becomes a function `F.M` that works on an instance of `F`; GET and SET of a PROPERTY `P` become `F.P.GET` and
//! `F.P.SET`. An INTERFACE becomes a block that has methods without statements.

use crate::st::ast::{
    Accessor, Action, Block, BlockKind, Declaration, DeclaredName, Expression, ExpressionKind, File, Interface, Item, Location, Member,
    MemberKind, Method, Name, Property, Quoting, SectionKind, VarSection,
};

/// The file with its methods and properties behind the blocks that they belong to.
pub(crate) fn expand(file: File) -> File {
    File { items: items(file.items) }
}

fn items(all: Vec<Item>) -> Vec<Item> {
    let mut expanded = Vec::with_capacity(all.len());
    for item in all {
        match item {
            Item::Block(block) => owner(*block, &mut expanded),
            Item::Interface(interface) => owner(of_interface(*interface), &mut expanded),
            Item::Namespace(mut namespace) => {
                namespace.items = items(namespace.items);
                expanded.push(Item::Namespace(namespace));
            }
            other => expanded.push(other),
        }
    }
    expanded
}

fn of_interface(interface: Interface) -> Block {
    let Interface { name, extends, mut methods, mut properties, span } = interface;
    methods.iter_mut().for_each(|method| method.modifiers.is_abstract = true);
    for property in &mut properties {
        property.modifiers.is_abstract = true;
        // An interface may leave the accessors away: then it asks for both.
        if property.get.is_none() && property.set.is_none() {
            let accessor = Accessor { sections: Vec::new(), body: Vec::new(), span: property.span };
            (property.get, property.set) = (Some(accessor.clone()), Some(accessor));
        }
    }
    let mut block = Block::empty(BlockKind::Interface, name, span);
    block.extends = extends;
    block.modifiers.is_abstract = true;
    (block.methods, block.properties) = (methods, properties);
    block
}

/// A block, then what belongs to it.
fn owner(mut block: Block, expanded: &mut Vec<Item>) {
    if block.kind == BlockKind::Program {
        let (access, own) = std::mem::take(&mut block.sections).into_iter().partition(|section| section.kind == SectionKind::Access);
        block.sections = own;
        for section in access {
            expanded.push(Item::Globals(of_program(section, &block.name)));
        }
    }
    let (methods, properties) = (std::mem::take(&mut block.methods), std::mem::take(&mut block.properties));
    let mut members = Vec::new();
    for method in methods {
        let kept = kept(&method, &mut block);
        members.push(of_method(method, &block, kept));
    }
    for property in properties {
        of_property(property, &block, &mut members);
    }
    members.extend(of_actions(&block));
    expanded.push(Item::Block(Box::new(block)));
    expanded.extend(members.into_iter().map(|member| Item::Block(Box::new(member))));
}

/// VAR_ACCESS of a PROGRAM: its paths begin in the program.
fn of_program(mut section: VarSection, program: &Name) -> VarSection {
    for declaration in &mut section.declarations {
        if let Some(Location::Path(path)) = &mut declaration.location {
            begin_with(path, program);
        }
    }
    section
}

/// Writes a name before the first one of a path.
fn begin_with(path: &mut Expression, name: &Name) {
    match &mut path.kind {
        ExpressionKind::Member(inner, _)
        | ExpressionKind::Index(inner, _)
        | ExpressionKind::Slice(inner, _)
        | ExpressionKind::Dereference(inner) => begin_with(inner, name),
        ExpressionKind::Name(first) => {
            let first = std::mem::take(first);
            let program = Expression { kind: ExpressionKind::Name(Name { span: path.span, ..name.clone() }), span: path.span };
            path.kind = ExpressionKind::Member(Box::new(program), first);
        }
        _ => {}
    }
}

/// VAR_INST: the variables go to the instance, under a name that no other one has there.
fn kept(method: &Method, owner: &mut Block) -> Vec<(Name, String)> {
    let mut names = Vec::new();
    for section in method.sections.iter().filter(|section| section.kind == SectionKind::Instance) {
        let mut moved = VarSection { kind: SectionKind::Var, ..section.clone() };
        for declared in moved.declarations.iter_mut().flat_map(|declaration| &mut declaration.names) {
            let inside = format!("{}__{}", method.name.text, declared.name.text);
            names.push((declared.name.clone(), inside.clone()));
            declared.name.text = inside;
        }
        owner.sections.push(moved);
    }
    names
}

fn member(owner: &Block, name: &Name, kind: MemberKind, kept: Vec<(Name, String)>) -> (Name, Option<Member>) {
    let text = match kind {
        _ if name.text.is_empty() || owner.name.text.is_empty() => String::new(),
        MemberKind::Method => format!("{}.{}", owner.name.text, name.text),
        MemberKind::Get => format!("{}.{}.GET", owner.name.text, name.text),
        MemberKind::Set => format!("{}.{}.SET", owner.name.text, name.text),
    };
    let full = Name { text, quoting: Quoting::Bare, span: name.span };
    (full, Some(Member { of: owner.name.clone(), name: name.clone(), kind, kept }))
}

fn of_method(method: Method, owner: &Block, kept: Vec<(Name, String)>) -> Block {
    let (name, member) = member(owner, &method.name, MemberKind::Method, kept);
    let Method { modifiers, attributes, result, mut sections, body, end, span, .. } = method;
    sections.retain(|section| section.kind != SectionKind::Instance);
    Block { member, modifiers, attributes, result, sections, body, end, ..Block::empty(BlockKind::Method, name, span) }
}

/// Actions as methods, for calls from outside: `inst.Reset();`. What uses VAR_TEMP of the block has no method.
fn of_actions(block: &Block) -> Vec<Block> {
    if !matches!(block.kind, BlockKind::FunctionBlock | BlockKind::Program)
        || block.sections.iter().any(|section| section.kind == SectionKind::Temp)
    {
        return Vec::new();
    }
    let method = |action: &Action| {
        let (name, member) = member(block, &action.name, MemberKind::Method, Vec::new());
        let end = action.span;
        Block { member, body: action.body.clone(), end, ..Block::empty(BlockKind::Method, name, action.span) }
    };
    block.actions.iter().map(method).collect()
}

fn of_property(property: Property, owner: &Block, members: &mut Vec<Block>) {
    let Property { name: own, modifiers, attributes, data_type, get, set, .. } = property;
    if let Some(Accessor { sections, body, span }) = get {
        let (name, member) = member(owner, &own, MemberKind::Get, Vec::new());
        let result = Some(data_type.clone());
        let attributes = attributes.clone();
        members.push(Block { member, modifiers, attributes, result, sections, body, ..Block::empty(BlockKind::Method, name, span) });
    }
    if let Some(Accessor { sections: own_sections, body, span }) = set {
        let (name, member) = member(owner, &own, MemberKind::Set, Vec::new());
        let value = Declaration {
            names: vec![DeclaredName { qualifier: Vec::new(), name: own.clone(), elements: Vec::new() }],
            attributes: Vec::new(),
            location: None,
            data_type,
            edge: None,
            initial: None,
            writable: None,
            comment: String::new(),
            span: own.span,
        };
        let input = VarSection {
            kind: SectionKind::Input,
            qualifiers: Vec::new(),
            name: None,
            attributes: Vec::new(),
            declarations: vec![value],
            partial: false,
            nameless: false,
            span: own.span,
        };
        let sections = std::iter::once(input).chain(own_sections).collect();
        members.push(Block { member, modifiers, attributes, sections, body, ..Block::empty(BlockKind::Method, name, span) });
    }
}
