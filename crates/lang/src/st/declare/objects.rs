//! Which block extends or implements which one.

use std::collections::BTreeMap;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::Span;

use super::ast;
use super::items::{Code, Items, joined};
use super::needed::Demand;
use crate::scope::{Scope, did_you_mean, key};
use crate::st::dialect::{Construct, Judgement};
use crate::st::objects::{Member, Object, Objects};
use crate::st::standard::Provided;
use crate::st::standard::library::block_type;

/// How many blocks may extend one another in a row: no program needs more, and each costs a look at every call.
const DEPTH_MAX: usize = 64;
/// How deep the search for circles goes.
const SEARCH_MAX: usize = 3 * DEPTH_MAX;

/// Finds the objects among the blocks, what they extend and implement, and their members.
///
/// `library` gets the sources of the library that blocks extend and that are not there yet, and all that they extend.
pub(super) fn objects(
    items: &Items<'_>,
    scope: &Scope,
    diagnostics: &mut Vec<Diagnostic>,
    library: (&mut Vec<Demand>, &mut Vec<Demand>),
) -> Objects {
    let mut all = BTreeMap::new();
    for (&id, &code) in items.code.iter().filter(|(id, _)| id.kind == BlockKind::FunctionBlock) {
        all.insert(id, object(items, scope, id, code, (diagnostics, library.0, library.1)));
    }
    for (&id, code) in &items.code {
        let Some(member) = &code.block.member else { continue };
        let owner = items.block_in(code.space, &member.of.text).filter(|owner| owner.kind == BlockKind::FunctionBlock);
        let Some((of, object)) = owner.and_then(|owner| Some((owner, all.get_mut(&owner)?))) else { continue };
        let modifiers = &code.block.modifiers;
        let member = Member {
            function: id,
            of,
            name: member.name.text.clone(),
            kind: member.kind,
            access: modifiers.access.unwrap_or(ast::Access::Public),
            is_abstract: modifiers.is_abstract,
            is_final: modifiers.is_final,
            is_override: modifiers.is_override,
            has_body: !code.block.body.is_empty(),
            span: member.name.span,
        };
        object.members.insert((key(&member.name), member.kind), member);
    }
    Circles { all: &mut all, depths: BTreeMap::new(), diagnostics }.cut();
    Objects::new(all)
}

fn object(
    items: &Items<'_>,
    scope: &Scope,
    id: BlockId,
    code: Code<'_>,
    (diagnostics, demands, uses): (&mut Vec<Diagnostic>, &mut Vec<Demand>, &mut Vec<Demand>),
) -> Object {
    let block = code.block;
    let interface = block.kind == ast::BlockKind::Interface;
    let mut object = Object {
        name: items.names.get(&id).cloned().unwrap_or_else(|| id.to_string()),
        span: block.name.span,
        dialect: code.dialect,
        kind: block.kind,
        base: None,
        interfaces: Vec::new(),
        // What the dialect does not have is told at EXTENDS.
        lacks_base: !block.extends.is_empty() && code.dialect.judge(Construct::ObjectOrientation) == Judgement::Reject,
        is_abstract: block.modifiers.is_abstract,
        is_final: block.modifiers.is_final,
        namespace: items.spaces.get(code.space).map(|space| space.prefix.clone()).unwrap_or_default(),
        members: BTreeMap::new(),
    };
    // `__SYSTEM.IQueryInterface` of codesys has what every interface has here.
    let of_system = |path: &ast::Path| joined(path).eq_ignore_ascii_case("__SYSTEM.IQueryInterface");
    let of_system = |path: &ast::Path| interface && of_system(path) && code.dialect.has_pointers();
    for (index, path) in block.extends.iter().enumerate().filter(|(_, path)| !of_system(path)) {
        let found = match of_library(items, code, path) {
            Some((demand, found)) => {
                if !items.is_of_library(id) {
                    uses.push(demand);
                }
                if found.is_none() {
                    demands.push(demand);
                }
                found
            }
            None if path.names.is_empty() || items.is_twice(code.space, &joined(path)) => None,
            None => upper(items, scope, code, path, diagnostics),
        };
        let Some(found) = found else {
            object.lacks_base = true;
            continue;
        };
        let known = (object.base, object.interfaces.len());
        let of = items.code.get(&found).map(|code| code.block);
        let name = joined(path);
        match of.map(|of| of.kind) {
            Some(ast::BlockKind::Interface) if interface => object.interfaces.push(found),
            Some(ast::BlockKind::Interface) => {
                wrong(
                    diagnostics,
                    path.span,
                    format!("`{name}` is an interface, and a block implements it"),
                    &format!("Write `IMPLEMENTS {name}`."),
                );
            }
            Some(_) if interface => {
                wrong(
                    diagnostics,
                    path.span,
                    format!("`{name}` is no interface, and an interface extends only interfaces"),
                    "Name an INTERFACE.",
                );
            }
            Some(_) if index > 0 => {
                wrong(
                    diagnostics,
                    path.span,
                    format!("`{}` extends one block already", object.name),
                    "Implement interfaces for what else it can do.",
                );
            }
            Some(ast::BlockKind::Program | ast::BlockKind::Implicit) | None => {
                wrong(
                    diagnostics,
                    path.span,
                    format!("`{name}` is no function block that can be extended"),
                    "Name a FUNCTION_BLOCK or a CLASS.",
                );
            }
            Some(_) if of.is_some_and(|of| of.modifiers.is_final) => {
                wrong(
                    diagnostics,
                    path.span,
                    format!("`{name}` is FINAL, and nothing extends it"),
                    "Declare an instance of it, or remove FINAL there.",
                );
            }
            Some(_) => object.base = Some(found),
        }
        object.lacks_base |= known == (object.base, object.interfaces.len());
    }
    // The name behind IMPLEMENTS is missing, which the parser told.
    object.lacks_base |= block.implements.iter().any(|path| path.names.is_empty());
    let written = |path: &&ast::Path| !path.names.is_empty() && !items.is_twice(code.space, &joined(path));
    for path in block.implements.iter().filter(written) {
        let Some(found) = upper(items, scope, code, path, diagnostics) else { continue };
        let name = joined(path);
        if items.code.get(&found).is_some_and(|of| of.block.kind == ast::BlockKind::Interface) {
            object.interfaces.push(found);
        } else {
            wrong(
                diagnostics,
                path.span,
                format!("`{name}` is no interface, and only interfaces are implemented"),
                &format!("Write `EXTENDS {name}`."),
            );
        }
    }
    object
}

/// What is needed to have the function block of the library that a path behind EXTENDS names, and the block, if it is there; `None` if it
/// names none, or one of the project.
fn of_library(items: &Items<'_>, code: Code<'_>, path: &ast::Path) -> Option<(Demand, Option<BlockId>)> {
    let name = joined(path);
    if items.block_in(code.space, &name).is_some() {
        return None;
    }
    let Provided::Source { name, source } = block_type(&name, code.dialect)? else { return None };
    let found = items.library.get(&(source.path, key(name))).copied();
    Some((Demand::Source(source), found))
}

/// Says what is wrong with a path behind EXTENDS or IMPLEMENTS.
fn wrong<'d>(diagnostics: &'d mut Vec<Diagnostic>, span: Span, message: String, help: &str) -> &'d mut Diagnostic {
    diagnostics.push(Diagnostic::new(Problem::P6280, span, message).help(help));
    diagnostics.last_mut().expect("one was pushed")
}

/// The block that a path behind EXTENDS or IMPLEMENTS names.
fn upper(items: &Items<'_>, scope: &Scope, code: Code<'_>, path: &ast::Path, diagnostics: &mut Vec<Diagnostic>) -> Option<BlockId> {
    let name = joined(path);
    match items.block_in(code.space, &name) {
        Some(id) if items.code.contains_key(&id) && id.kind == BlockKind::FunctionBlock => Some(id),
        Some(_) => {
            wrong(diagnostics, path.span, format!("`{name}` is no function block"), "Name a FUNCTION_BLOCK, a CLASS or an INTERFACE.");
            None
        }
        None => {
            let blocks = items.names.iter().filter(|(id, _)| id.kind == BlockKind::FunctionBlock && items.code.contains_key(id));
            let near = did_you_mean(scope.nearest(&name, blocks.map(|(_, name)| name.as_str())));
            let message = format!("there is no block `{name}` in the sources of this project{near}");
            wrong(
                diagnostics,
                path.span,
                message,
                "Name a FUNCTION_BLOCK, a CLASS or an INTERFACE of the project, or a function block that the dialect brings along, such as TON.",
            )
            .may_be_elsewhere = true;
            None
        }
    }
}

/// The search for blocks that extend themselves.
struct Circles<'o> {
    all: &'o mut BTreeMap<BlockId, Object>,
    /// How many blocks lie above each one that is done; `None` while it is looked at.
    depths: BTreeMap<BlockId, Option<usize>>,
    diagnostics: &'o mut Vec<Diagnostic>,
}

impl Circles<'_> {
    /// Takes away what makes a circle, or is too deep.
    fn cut(mut self) {
        let ids: Vec<BlockId> = self.all.keys().copied().collect();
        for id in ids {
            self.look(id, 0);
        }
    }

    fn look(&mut self, id: BlockId, level: usize) {
        if self.depths.contains_key(&id) {
            return;
        }
        self.depths.insert(id, None);
        let Some(object) = self.all.get(&id) else { return };
        let uppers: Vec<BlockId> = object.base.iter().chain(&object.interfaces).copied().collect();
        let (mut depth, mut wrong) = (0, Vec::new());
        for upper in uppers {
            if level < SEARCH_MAX {
                self.look(upper, level + 1);
            }
            match self.depths.get(&upper) {
                Some(Some(above)) if above + 1 < DEPTH_MAX => depth = depth.max(above + 1),
                Some(None) => wrong.push((upper, true)),
                _ => wrong.push((upper, false)),
            }
        }
        for &(upper, circle) in &wrong {
            let above = self.all.get(&upper).map_or_else(String::new, |object| object.name.clone());
            let Some(object) = self.all.get_mut(&id) else { continue };
            let message = match circle {
                true => format!("`{}` extends itself through `{above}`", object.name),
                false => format!("`{}` extends more than {DEPTH_MAX} blocks in a row", object.name),
            };
            self.diagnostics.push(Diagnostic::new(Problem::P6280, object.span, message).help("Remove one of the EXTENDS.".to_owned()));
            object.lacks_base = true;
            object.base = object.base.filter(|&base| base != upper);
            object.interfaces.retain(|&interface| interface != upper);
        }
        self.depths.insert(id, Some(depth));
    }
}
