//! The instances of programs that a CONFIGURATION makes, and what its tasks with SINGLE remember.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use sieben_model::types::{DataType, Field, Structure};

use super::ast;
use super::items::{Collector, Items, KEPT, Pending, Space, joined};
use super::numbers::Wanted;
use crate::declarations::NESTING_MAX;
use crate::declarations::data_block::DataLayout;
use crate::scope::key;
use crate::st::ast::BlockKind;
use crate::st::dialect::Dialect;

/// What the data block of the tasks is called.
const TASKS: &str = "TASKS";
/// What is remembered of each task with SINGLE: what it is now, what it was before, and its edge.
pub(super) const REMEMBERED: [&str; 3] = ["NOW", "WAS", "EDGE"];

impl<'a> Collector<'a, '_> {
    /// Gives each instance of a CONFIGURATION a data block of its own name; the first of a PROGRAM takes the one that every PROGRAM has.
    pub(super) fn configured_instances(&mut self) {
        let (mut claimed, mut own_names) = (HashSet::new(), HashSet::new());
        let configurations: Vec<&'a ast::Configuration> = self.items.configurations.iter().map(|&(one, _)| one).collect();
        for configuration in configurations {
            self.items.qualifiers.insert(key(&configuration.name.text));
            for resource in &configuration.resources {
                self.items.qualifiers.insert(key(&resource.name.text));
                for instance in &resource.programs {
                    self.configured_instance(instance, &mut claimed, &mut own_names);
                }
            }
        }
        if let Some(span) = single_tasks(&self.items).next().map(|task| task.name.span) {
            let wanted =
                Wanted { name: self.free_name(TASKS), kind: sieben_model::block::BlockKind::DataBlock, fixed: None, span, library: None };
            self.pending.push((wanted, Pending::Tasks));
        }
    }

    /// Gives functions and methods with instances among their variables a data block that keeps these, where the dialect has that.
    pub(super) fn local_instances(&mut self) {
        let of_kind =
            |pending: &Pending<'_>, kinds: &[BlockKind]| matches!(pending, Pending::Code(code) if kinds.contains(&code.block.kind));
        let is_block = |(_, pending): &&(Wanted, Pending<'_>)| of_kind(pending, &[BlockKind::FunctionBlock, BlockKind::Class]);
        let blocks: HashSet<String> = self.pending.iter().filter(is_block).map(|(wanted, _)| last_of(&wanted.name)).collect();
        let types = self.items.types.iter().map(|(name, found)| (last_of(name), &found.declaration.data_type));
        let mut known = Holders { blocks: &blocks, types: types.collect(), done: HashMap::new(), depth: 0 };
        let kept: HashSet<usize> = self
            .pending
            .iter()
            .filter_map(|(_, pending)| match pending {
                Pending::Kept(owner) => Some(*owner),
                _ => None,
            })
            .collect();
        let mut wanted = Vec::new();
        for (index, (name, pending)) in self.pending.iter().enumerate() {
            let Pending::Code(code) = pending else { continue };
            if !of_kind(pending, &[BlockKind::Function, BlockKind::Method]) || !code.dialect.has_local_instances() || kept.contains(&index)
            {
                continue;
            }
            let local = |section: &&ast::VarSection| matches!(section.kind, ast::SectionKind::Var | ast::SectionKind::Temp);
            let mut declarations = code.block.sections.iter().filter(local).flat_map(|section| &section.declarations);
            if declarations.any(|declaration| known.holds(&declaration.data_type, code.dialect)) {
                let name = Wanted {
                    name: format!("{}{KEPT}", name.name),
                    kind: sieben_model::block::BlockKind::DataBlock,
                    fixed: None,
                    ..name.clone()
                };
                wanted.push((name, Pending::Kept(index)));
            }
        }
        self.pending.append(&mut wanted);
    }

    fn configured_instance(&mut self, instance: &'a ast::ProgramInstance, claimed: &mut HashSet<usize>, own_names: &mut HashSet<String>) {
        let wanted = key(&joined(&instance.program));
        let is_program = |(name, pending): &(Wanted, Pending<'_>)| match pending {
            Pending::Code(code) => code.block.kind == BlockKind::Program && key(&name.name) == wanted,
            _ => false,
        };
        // What names no PROGRAM is reported where the tasks are made.
        let Some(program) = self.pending.iter().position(is_program) else { return };
        let name = &instance.name;
        // One instance may be called like its PROGRAM.
        let same = key(&name.text) == wanted && own_names.insert(wanted);
        if name.text.is_empty() || !same && !self.declare(Space::Block, &name.text, name.span) {
            return;
        }
        self.items.qualifiers.insert(key(&name.text));
        if let Some((qualifier, _)) = instance.retain {
            self.items.retained.insert(key(&name.text), qualifier == ast::Qualifier::Retain);
        }
        let own = self.pending.iter().position(|(_, pending)| matches!(pending, Pending::Instance(owner) if *owner == program));
        let Some(own) = own else { return };
        if claimed.insert(own) {
            let wanted = &mut self.pending[own].0;
            wanted.name.clone_from(&name.text);
            wanted.span = name.span;
        } else {
            let wanted = Wanted { name: name.text.clone(), span: name.span, ..self.pending[own].0.clone() };
            self.pending.push((wanted, Pending::Instance(program)));
        }
    }
}

/// The tasks with SINGLE, in the order of the sources.
pub(super) fn single_tasks<'a>(items: &Items<'a>) -> impl Iterator<Item = &'a ast::Task> {
    let configurations: Vec<&'a ast::Configuration> = items.configurations.iter().map(|&(one, _)| one).collect();
    let tasks = configurations.into_iter().flat_map(|one| one.resources.iter().flat_map(|resource| &resource.tasks));
    tasks.filter(|task| task.argument("SINGLE").is_some())
}

/// Lays out what the tasks remember: three BOOLs for each.
pub(super) fn tasks(items: &Items<'_>, data: &mut HashMap<u16, DataLayout>) {
    let Some(number) = items.tasks else { return };
    let mut structure = Structure { name: Some(TASKS.to_owned()), ..Structure::default() };
    for task in single_tasks(items) {
        for word in REMEMBERED {
            structure.fields.push(Field {
                name: format!("{}__{word}", task.name.text),
                data_type: DataType::Bool,
                offset: structure.fields.len() as u32,
                initial: Vec::new(),
                comment: String::new(),
            });
        }
    }
    structure.size = (structure.fields.len().next_multiple_of(16) / 8) as u32;
    data.insert(number, DataLayout { structure: Arc::new(structure), based_on: None });
}

/// The key of the last part of a name with namespaces.
fn last_of(name: &str) -> String {
    key(name.rsplit('.').next().unwrap_or(name))
}

/// What is known of types that may hold instances of function blocks.
struct Holders<'k, 'a> {
    /// The function blocks, by the keys of their names without namespaces.
    blocks: &'k HashSet<String>,
    /// The types of the project, likewise.
    types: HashMap<String, &'a ast::TypeSpec>,
    /// What was found out, likewise.
    done: HashMap<String, bool>,
    /// How many types are looked through one in another.
    depth: usize,
}

impl Holders<'_, '_> {
    /// Whether a variable of a type may hold an instance of a function block, as far as names tell.
    fn holds(&mut self, spec: &ast::TypeSpec, dialect: Dialect) -> bool {
        match &spec.kind {
            ast::TypeKind::Constructed { .. } => true,
            ast::TypeKind::Array { element, .. } => self.holds(element, dialect),
            ast::TypeKind::Struct { fields, .. } => fields.iter().any(|field| self.holds(&field.data_type, dialect)),
            ast::TypeKind::Named(path) => {
                let Some(last) = path.names.last().map(|name| key(&name.text)) else { return false };
                if let Some(&known) = self.done.get(&last) {
                    return known;
                }
                // A type that contains itself holds nothing more.
                self.done.insert(last.clone(), false);
                let holds = self.blocks.contains(&last)
                    || match self.types.get(&last).copied() {
                        // Types that are nested deeper are reported.
                        Some(_) if self.depth >= NESTING_MAX => false,
                        Some(found) => {
                            self.depth += 1;
                            let holds = self.holds(found, dialect);
                            self.depth -= 1;
                            holds
                        }
                        None => crate::st::standard::library::block_type(&last, dialect).is_some(),
                    };
                self.done.insert(last, holds);
                holds
            }
            _ => false,
        }
    }
}
