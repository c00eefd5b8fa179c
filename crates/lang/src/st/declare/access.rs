//! VAR_CONFIG and VAR_ACCESS: addresses and initial values of variables inside instances, and names for those who look in from outside.

use std::collections::HashSet;

use sieben_engine::program::Names as ProgramNames;
use sieben_model::address::{Address, Operand, Width};
use sieben_model::block::BlockId;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::program::DataBlock;
use sieben_model::source::Span;
use sieben_model::types::{DataType, Reference, ReferenceKind, Structure};

use super::data::non_retain;
use super::environment::{BlockNames, Environment};
use super::globals::located;
use super::items::Items;
use super::types::Resolver;
use super::{Declared, Types, ast};
use crate::declarations::data_block::{DataLayout, instance};
use crate::declarations::types::describe;
use crate::scope::key;
use crate::st::ast::{Location, SectionKind};
use crate::st::check::place_of;
use crate::st::check::places::dimension_steps;
use crate::st::dialect::Dialect;
use crate::st::tree::Base;

/// A variable whose address VAR_CONFIG tells: `x AT %I* : BOOL`.
#[derive(Clone, Debug)]
pub(crate) struct OpenAddress {
    /// The block that declares it.
    pub(crate) block: BlockId,
    /// Its name.
    pub(crate) name: String,
    pub(crate) data_type: DataType,
    /// Where it may lie.
    pub(crate) area: ast::Area,
    pub(crate) span: Span,
}

impl OpenAddress {
    /// An address that it could have.
    fn example(&self) -> String {
        let area = match self.area {
            ast::Area::Input => "I",
            ast::Area::Output => "Q",
            _ => "M",
        };
        match self.data_type.bits() {
            1 => format!("%{area}X0.0"),
            8 => format!("%{area}B0"),
            16 => format!("%{area}W0"),
            _ => format!("%{area}D0"),
        }
    }
}

/// What a variable is whose address VAR_CONFIG tells: a reference to it, which its name stands for.
pub(super) fn open_type(data_type: &DataType) -> DataType {
    DataType::Reference(std::sync::Arc::new(Reference { target: data_type.clone(), kind: ReferenceKind::Reference }))
}

/// One variable of VAR_CONFIG.
struct Entry<'a> {
    dialect: Dialect,
    declaration: &'a ast::Declaration,
    /// Resource, program, instances, variable.
    path: Vec<&'a ast::Name>,
    /// Elements of arrays on the way: behind which of the names, and the indexes.
    elements: &'a [(usize, Vec<ast::Expression>)],
}

impl Entry<'_> {
    fn shown(&self) -> String {
        self.path.iter().map(|name| name.text.as_str()).collect::<Vec<_>>().join(".")
    }

    fn span(&self) -> Span {
        let (first, last) = (self.path[0].span, self.path[self.path.len() - 1].span);
        Span { end: last.end, ..first }
    }
}

fn entries<'a>(items: &Items<'a>) -> Vec<Entry<'a>> {
    let mut found = Vec::new();
    for &(section, dialect) in items.access.iter().filter(|(section, _)| section.kind == SectionKind::Config) {
        for declaration in &section.declarations {
            for declared in &declaration.names {
                let path = declared.qualifier.iter().chain([&declared.name]).collect();
                found.push(Entry { dialect, declaration, path, elements: &declared.elements });
            }
        }
    }
    found
}

/// The data block that a path of VAR_CONFIG begins in, and how many of its names stand for it.
fn root(items: &Items<'_>, path: &[&ast::Name]) -> Option<(u16, usize)> {
    let of = |name: &ast::Name| {
        let wanted = key(&name.text);
        let list = || items.lists.iter().find(|list| key(&list.name) == wanted).map(|list| list.number);
        items.program(&wanted).map(|program| program.instance).or_else(list)
    };
    let is_space = |name: &ast::Name| {
        let resources =
            |one: &&ast::Configuration| one.name.is(&name.text) || one.resources.iter().any(|resource| resource.name.is(&name.text));
        items.configurations.iter().map(|&(one, _)| one).any(|one| resources(&one))
    };
    let spaces = path.iter().take_while(|name| is_space(name)).count().min(path.len() - 1);
    // An instance may be called like the resource that it stands in.
    (0..=spaces).rev().find_map(|skipped| Some((of(path[skipped])?, skipped + 1)))
}

/// Says what of VAR_CONFIG leads nowhere.
pub(super) fn rootless(types: &mut Types<'_>, items: &Items<'_>) {
    for entry in entries(items) {
        if root(items, &entry.path).is_none() {
            let message = format!("`{}` begins with no instance of a PROGRAM", entry.shown());
            types.report(Problem::P6311, entry.span(), message).may_be_elsewhere = true;
        }
    }
}

impl Resolver<'_, '_> {
    /// Where a variable lies; one `AT %I*` without any VAR_CONFIG lies where others do, if the dialect has it so.
    pub(super) fn linked<'l>(&mut self, location: Option<&'l Location>, span: Span) -> Option<&'l Location> {
        let open = matches!(location, Some(Location::Address(address)) if address.position == ast::Position::Open);
        let told = || self.items.access.iter().any(|(section, _)| section.kind == SectionKind::Config);
        if !open || !self.dialect.switches().unlinked_is_memory || told() {
            return location;
        }
        self.is_memory(span);
        None
    }

    /// Says once in a program that a variable without an address is memory.
    pub(super) fn is_memory(&mut self, span: Span) {
        if !std::mem::replace(&mut self.types.known.unlinked, true) {
            let message = "no VAR_CONFIG tells this address: the variable is memory of its own";
            let diagnostic = self.report(Problem::P6330, span, message);
            diagnostic.may_be_elsewhere = true;
            diagnostic.help = Some("Write the address of a variable of a block, as in `AT %IX0.0`; other variables of the program, and fields, are not listed.".to_owned());
        }
    }
}

/// The bytes of a data block that a program, its globals or a CONFIGURATION have, with what VAR_CONFIG says of it.
pub(super) fn configured<'a>(types: &mut Types<'a>, items: &'a Items<'a>, number: u16, layout: &DataLayout) -> DataBlock {
    let mut data = DataBlock { non_retain: non_retain(items, number), ..instance(number, layout) };
    let mut given: HashSet<u64> = HashSet::new();
    for entry in entries(items) {
        let Some((of, skipped)) = root(items, &entry.path) else { continue };
        if of == number {
            entry_of(types, items, &entry, skipped, layout, &mut data, &mut given);
        }
    }
    if !types.known.open.is_empty() {
        let shown = items.names.get(&BlockId::db(number)).cloned().unwrap_or_else(|| BlockId::db(number).to_string());
        let mut missing = Vec::new();
        missing_in(types, items, &layout.structure, layout.based_on, 0, &shown, &given, &mut missing);
        for (path, open) in missing {
            let span = open.span;
            let message = format!("no VAR_CONFIG gives `{path}` an address");
            let help = format!(
                "Write it into a CONFIGURATION: `VAR_CONFIG {path} AT {} : {}; END_VAR`, or write the address where it is declared.",
                open.example(),
                describe(&open.data_type)
            );
            let diagnostic = types.report(Problem::P6310, span, message);
            diagnostic.may_be_elsewhere = true;
            diagnostic.help = Some(help);
        }
    }
    data
}

fn entry_of<'a>(
    types: &mut Types<'a>,
    items: &'a Items<'a>,
    entry: &Entry<'_>,
    skipped: usize,
    layout: &DataLayout,
    data: &mut DataBlock,
    given: &mut HashSet<u64>,
) {
    let mut owner = layout.based_on;
    let mut structure = std::sync::Arc::clone(&layout.structure);
    let mut position = 0;
    let mut found = None;
    for (index, name) in entry.path.iter().enumerate().skip(skipped) {
        let Some(field) = structure.field(&name.text).cloned() else {
            let message = format!("`{}` has no variable `{}`", shown_until(entry, index), name.text);
            types.report(Problem::P6311, name.span, message);
            return;
        };
        position += u64::from(field.offset);
        let open =
            types.known.open.iter().find(|open| Some(open.block) == owner_of(items, owner, open.block) && name.is(&open.name)).cloned();
        let mut data_type = field.data_type.clone();
        if let Some((_, indexes)) = entry.elements.iter().find(|(behind, _)| *behind == index) {
            let Some((element, offset)) = element_of(types, items, entry, (index, &data_type), indexes) else { return };
            position += offset;
            data_type = element;
        }
        found = Some((data_type.clone(), open));
        match &data_type {
            DataType::Instance { block, structure: inside } => {
                owner = Some(*block);
                structure = std::sync::Arc::clone(inside);
            }
            DataType::Struct(inside) => {
                owner = None;
                structure = std::sync::Arc::clone(inside);
            }
            other if index + 1 < entry.path.len() => {
                let message =
                    format!("`{}` is {} and has no variables inside", shown_until(entry, index + 1), entry.dialect.type_words(other));
                types.report(Problem::P6311, name.span, message);
                return;
            }
            _ => {}
        }
    }
    let Some((data_type, open)) = found else {
        types.report(Problem::P6311, entry.span(), format!("`{}` names no variable of the instance", entry.shown()));
        return;
    };
    let mut resolver = Resolver::new(types, items, entry.dialect);
    let target = match (&data_type, &open) {
        (DataType::Reference(reference), Some(_)) => reference.target.clone(),
        _ => data_type.clone(),
    };
    let written = &entry.declaration.data_type;
    if let Some(own) = resolver.data_type(written)
        && own != target
    {
        let message = format!(
            "`{}` is {} where it is declared, not {}",
            entry.shown(),
            entry.dialect.type_words(&target),
            entry.dialect.type_words(&own)
        );
        resolver.report(Problem::P4006, written.span, message);
        return;
    }
    match (&entry.declaration.location, open) {
        (Some(Location::Address(address)), Some(open)) => {
            if address.area != open.area {
                let message = format!("`{}` waits for an address in another area than `{}`", entry.shown(), address.written.text);
                resolver.report(Problem::P6127, address.span, message).related.push((open.span, "declared here".to_owned()));
                return;
            }
            let Some((Base::Area(area), offset)) = located(&mut resolver, address, &target) else { return };
            let pointer = u32::from(area.pointer_code()) << 24 | offset;
            let first = (position / 8) as usize;
            data.image[first..first + 8].copy_from_slice(&u64::from(pointer).to_be_bytes());
            given.insert(position);
            if let Some(initial) = &entry.declaration.initial {
                let help = "Write the initial value where a program assigns it.";
                resolver.report(Problem::P2212, initial.span, "a variable that VAR_CONFIG gives an address has no initial value").help =
                    Some(help.to_owned());
            }
        }
        (Some(_), None) => {
            let message = format!("`{}` is not declared with an open address such as `AT %I*`", entry.shown());
            resolver.report(Problem::P6311, entry.span(), message);
        }
        (None, _) => match &entry.declaration.initial {
            Some(initial) => resolver.fill(&mut data.image, position, &data_type, initial),
            None => {
                let message = format!("VAR_CONFIG gives `{}` neither an address nor an initial value", entry.shown());
                resolver.report(Problem::P6311, entry.span(), message);
            }
        },
        _ => {}
    }
}

/// The element of an array that VAR_CONFIG names, and how many bits behind the begin of the array it lies.
fn element_of<'a>(
    types: &mut Types<'a>,
    items: &'a Items<'a>,
    entry: &Entry<'_>,
    (name, array): (usize, &DataType),
    indexes: &[ast::Expression],
) -> Option<(DataType, u64)> {
    let (mut data_type, mut offset, mut rest) = (array.clone(), 0, indexes);
    while let Some(first) = rest.first() {
        let DataType::Array { bounds, element } = &data_type else {
            let message = format!("`{}` is {} and has no elements", shown_until(entry, name + 1), entry.dialect.type_words(&data_type));
            types.report(Problem::P6311, first.span, message);
            return None;
        };
        if rest.len() < bounds.len() {
            let message = format!("`{}` has {} dimensions", shown_until(entry, name + 1), bounds.len());
            types.report(Problem::P4005, first.span, message);
            return None;
        }
        let (own, behind) = rest.split_at(bounds.len());
        for ((index, &(low, high)), step) in own.iter().zip(bounds).zip(dimension_steps(bounds, element)) {
            let mut resolver = Resolver::new(types, items, entry.dialect);
            let number = resolver.integer(index)?;
            if number < i128::from(low) || number > i128::from(high) {
                let message = format!("the index {number} is outside {low}..{high} of `{}`", shown_until(entry, name + 1));
                types.report(Problem::P4005, index.span, message);
                return None;
            }
            offset += (number - i128::from(low)) as u64 * u64::from(step);
        }
        rest = behind;
        data_type = (**element).clone();
    }
    Some((data_type, offset))
}

/// The block itself where a field is one that the block, or one that it extends, declares.
fn owner_of(items: &Items<'_>, owner: Option<BlockId>, declares: BlockId) -> Option<BlockId> {
    let mut block = owner;
    while let Some(one) = block {
        if one == declares {
            return Some(one);
        }
        block = items.objects.get(one).and_then(|object| object.base);
    }
    None
}

fn shown_until(entry: &Entry<'_>, end: usize) -> String {
    entry.path[..end].iter().map(|name| name.text.as_str()).collect::<Vec<_>>().join(".")
}

/// The variables with an open address that were given none: path and declaration.
#[allow(clippy::too_many_arguments)]
fn missing_in(
    types: &Types<'_>,
    items: &Items<'_>,
    structure: &Structure,
    owner: Option<BlockId>,
    position: u64,
    path: &str,
    given: &HashSet<u64>,
    missing: &mut Vec<(String, OpenAddress)>,
) {
    for field in &structure.fields {
        let (here, path) = (position + u64::from(field.offset), format!("{path}.{}", field.name));
        let is_open = |open: &&OpenAddress| open.name == field.name && owner_of(items, owner, open.block).is_some();
        if let Some(open) = types.known.open.iter().find(is_open) {
            if !given.contains(&here) {
                missing.push((path, open.clone()));
            }
            continue;
        }
        missing_inside(types, items, &field.data_type, here, &path, given, missing);
    }
}

/// The same of what lies in a variable.
fn missing_inside(
    types: &Types<'_>,
    items: &Items<'_>,
    data_type: &DataType,
    here: u64,
    path: &str,
    given: &HashSet<u64>,
    missing: &mut Vec<(String, OpenAddress)>,
) {
    match data_type {
        DataType::Instance { block, structure } => missing_in(types, items, structure, Some(*block), here, path, given, missing),
        DataType::Struct(structure) => missing_in(types, items, structure, None, here, path, given, missing),
        DataType::Array { bounds, element }
            if matches!(**element, DataType::Instance { .. } | DataType::Struct(_) | DataType::Array { .. }) =>
        {
            let (before, steps) = (missing.len(), dimension_steps(bounds, element));
            for number in 0..data_type.elements() {
                let (mut rest, mut offset, mut indexes) = (number, 0, Vec::with_capacity(bounds.len()));
                for (&(low, high), &step) in bounds.iter().zip(&steps).rev() {
                    let count = (i64::from(high) - i64::from(low) + 1).max(1) as u64;
                    offset += rest % count * u64::from(step);
                    indexes.push((i64::from(low) + (rest % count) as i64).to_string());
                    rest /= count;
                }
                indexes.reverse();
                let path = format!("{path}[{}]", indexes.join(", "));
                missing_inside(types, items, element, here + offset, &path, given, missing);
                // One element without an address speaks for those behind it.
                if missing.len() > before {
                    break;
                }
            }
        }
        _ => {}
    }
}

impl Environment<'_> {
    /// The names that VAR_ACCESS gives to variables.
    pub(super) fn access_names(&self, names: &mut ProgramNames, diagnostics: &mut Vec<Diagnostic>) {
        let declared = Declared::default();
        for &(section, dialect) in self.items.access.iter().filter(|(section, _)| section.kind == SectionKind::Access) {
            let outside = BlockNames::outside(self, &declared, BlockId::ob(1), dialect);
            for declaration in &section.declarations {
                let Some(Location::Path(path)) = &declaration.location else { continue };
                let (found, mut told) = place_of(path, dialect, &outside);
                let failed = !told.is_empty();
                diagnostics.append(&mut told);
                let Some((base, offset, data_type)) = found else {
                    if !failed {
                        diagnostics.push(Diagnostic::new(Problem::P6311, path.span, "this leads to no variable of the project"));
                    }
                    continue;
                };
                if let ast::TypeKind::Named(written) = &declaration.data_type.kind
                    && let Some(word) = written.single().and_then(|name| DataType::from_any_word(&name.text))
                    && word.is_elementary()
                    && dialect.type_words(&word) != dialect.type_words(&data_type)
                {
                    let message =
                        format!("this is {} where it is declared, not {}", dialect.type_words(&data_type), dialect.type_words(&word));
                    diagnostics.push(Diagnostic::new(Problem::P4006, declaration.data_type.span, message));
                    continue;
                }
                let operand = data_type.width().and_then(|width| operand(&base, offset, width));
                let Some(operand) = operand else {
                    let message =
                        format!("{} has no name of its own for those outside: it has more than 32 bits", dialect.type_words(&data_type));
                    let help = "Name its parts, or call it by the name of the instance.";
                    diagnostics.push(Diagnostic::new(Problem::P6311, path.span, message).help(help));
                    continue;
                };
                for declared in &declaration.names {
                    names.located.insert(key(&declared.name.text), (operand, data_type.clone()));
                }
            }
        }
    }
}

/// A place as people write it.
pub(super) fn operand(base: &Base, offset: u32, width: Width) -> Option<Operand> {
    let bit = if width == Width::Bit { (offset % 8) as u8 } else { 0 };
    match *base {
        Base::Area(area) => Some(Operand::Address(Address { area, width, byte: offset / 8, bit })),
        Base::DataBlock(db) => {
            let address = Address { area: sieben_model::address::Area::SharedData, width, byte: offset / 8, bit };
            Some(Operand::InDataBlock { db, address })
        }
        _ => None,
    }
}
