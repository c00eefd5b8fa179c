//! VAR_GLOBAL: each list becomes a data block, constants need none, and variables with an address lie there.

use std::collections::HashMap;
use std::sync::Arc;

use sieben_model::address::Area;
use sieben_model::block::BlockId;
use sieben_model::problems::Problem;
use sieben_model::types::{DataType, Field, Structure, place};

use super::interface::{is_constant, unknown};
use super::items::Items;
use super::types::Resolver;
use super::{Located, Types, ast};
use crate::declarations::BLOCK_BYTES_MAX;
use crate::declarations::data_block::DataLayout;
use crate::scope::key;
use crate::st::check::names::{Entity, Role, Variable};
use crate::st::dialect::AddressUnit;
use crate::st::tree::Base;

/// Global variables and constants by the key of their names, without and with the name of their list.
pub(crate) type Globals = HashMap<String, Entity>;

/// Lays out all lists of global variables.
pub(super) fn globals<'a>(types: &mut Types<'a>, items: &'a Items<'a>, data: &mut HashMap<u16, DataLayout>) -> Globals {
    let mut globals = Globals::new();
    for list in &items.lists {
        let mut resolver = Resolver { list: Some(&list.name), ..Resolver::new(types, items, list.dialect) };
        let mut structure = Structure { name: Some(list.name.clone()), ..Structure::default() };
        let mut cursor = 0;
        let constant = list.section.has(ast::Qualifier::Constant);
        for declaration in &list.section.declarations {
            if is_constant(list.section, declaration) {
                for declared in &declaration.names {
                    let full = key(&format!("{}.{}", list.name, declared.name.text));
                    let entity = match resolver.global_constant(&full, declared.name.span) {
                        Some(constant) => Entity::Constant(constant),
                        None => unknown(&declared.name),
                    };
                    add(&mut globals, items, &list.name, &declared.name, entity);
                }
                continue;
            }
            let Some((data_type, named)) = resolver.type_and_initial(&declaration.data_type) else {
                for declared in &declaration.names {
                    add(&mut globals, items, &list.name, &declared.name, unknown(&declared.name));
                }
                continue;
            };
            if data_type == DataType::Void || data_type.is_number() {
                let message = format!("{} may not stand here: it is only for parameters", resolver.dialect.type_words(&data_type));
                resolver.report(Problem::P4009, declaration.data_type.span, message);
                continue;
            }
            resolver.no_abstract(&data_type, declaration.data_type.span);
            resolver.later = resolver.begins_later(declaration.location.is_none());
            let initial = match &declaration.initial {
                Some(initializer) => resolver.initial(initializer, &data_type),
                None => named,
            };
            for declared in &declaration.names {
                let name = &declared.name;
                let (base, offset) = match resolver.linked(declaration.location.as_ref(), name.span) {
                    Some(ast::Location::Address(address)) => {
                        let Some(found) = located(&mut resolver, address, &data_type) else {
                            add(&mut globals, items, &list.name, name, unknown(name));
                            continue;
                        };
                        found
                    }
                    _ => {
                        let (offset, behind) = place(cursor, &data_type);
                        if behind > BLOCK_BYTES_MAX * 8 {
                            let message = format!("with `{}` these variables need more than {BLOCK_BYTES_MAX} bytes", name.text);
                            resolver.report(Problem::P5002, name.span, message);
                            break;
                        }
                        cursor = behind;
                        structure.fields.push(Field {
                            name: name.text.clone(),
                            data_type: data_type.clone(),
                            offset: offset as u32,
                            initial: initial.clone(),
                            comment: declaration.comment.clone(),
                        });
                        (Base::DataBlock(list.number), offset as u32)
                    }
                };
                let role = if constant { Role::Constant } else { Role::Global };
                let variable = Variable { name: name.text.clone(), role, data_type: data_type.clone(), base, offset, span: name.span };
                if declaration.location.is_some() && declaration.initial.is_some() {
                    let retain = list.section.has(ast::Qualifier::Retain);
                    resolver.types.known.located.push(Located { variable: variable.clone(), initial: initial.clone(), retain });
                }
                add(&mut globals, items, &list.name, name, Entity::Variable(variable));
            }
        }
        structure.size = (cursor.next_multiple_of(16) / 8) as u32;
        if structure.size > 0 {
            data.insert(list.number, DataLayout { structure: Arc::new(structure), based_on: None::<BlockId> });
        }
    }
    // Which of the two is meant where the name is used, nobody knows.
    for name in &items.twice_global {
        globals
            .iter_mut()
            .filter(|(known, _)| *known == name || known.rsplit_once('.').is_some_and(|(_, last)| last == name))
            .for_each(|(_, entity)| *entity = unknown(&ast::Name { text: name.clone(), ..ast::Name::default() }));
    }
    globals
}

fn add(globals: &mut Globals, items: &Items<'_>, list: &str, name: &ast::Name, entity: Entity) {
    globals.insert(key(&format!("{list}.{}", name.text)), entity.clone());
    if items.globals.contains_key(&key(&name.text)) {
        globals.entry(key(&name.text)).or_insert(entity);
    }
}

/// Where a variable with an address lies; `None` if it cannot lie there, which is reported.
pub(super) fn located(resolver: &mut Resolver<'_, '_>, address: &ast::Address, data_type: &DataType) -> Option<(Base, u32)> {
    let span = address.span;
    let area = match address.area {
        ast::Area::Input => Area::Input,
        ast::Area::Output => Area::Output,
        ast::Area::Memory => Area::BitMemory,
        ast::Area::PeripheralInput => Area::PeripheralInput,
        ast::Area::PeripheralOutput => Area::PeripheralOutput,
        _ => {
            resolver.report(Problem::P6127, span, "a variable can lie among the inputs, the outputs and the bit memory only");
            return None;
        }
    };
    let numbers: Vec<u64> = match &address.position {
        ast::Position::Fixed(numbers) => numbers.clone(),
        ast::Position::Open => {
            let message = "an address that VAR_CONFIG tells is for variables in VAR of a PROGRAM or FUNCTION_BLOCK";
            resolver.report(Problem::P6127, span, message);
            return None;
        }
        ast::Position::Computed(_) => {
            resolver.report(Problem::P6127, span, "the address of a variable is a number");
            return None;
        }
    };
    let width = u64::from(address.width.bits());
    let aggregate = !data_type.is_elementary() && !data_type.is_long();
    if !aggregate && data_type.bits() != width {
        let message = format!(
            "{} has {} bits, and the address `{}` has {width}",
            resolver.dialect.type_words(data_type),
            data_type.bits(),
            address.written.text
        );
        resolver.report(Problem::P6127, span, message);
        return None;
    }
    let unit = match resolver.dialect.switches().address_unit {
        AddressUnit::Byte => 1,
        AddressUnit::OwnWidth => (width / 8).max(1),
    };
    let position = match (numbers.as_slice(), width) {
        (&[byte, bit], 1) if bit < 8 => byte.checked_mul(8).map(|bits| bits + bit),
        (&[byte], 8..) => byte.checked_mul(unit * 8),
        _ => None,
    };
    match position.and_then(|position| u32::try_from(position).ok()).filter(|position| *position < 65_536 * 8) {
        Some(position) => Some((Base::Area(area), position)),
        None => {
            let help = "A bit is written `%IX0.7` with a bit number up to 7, all else with one number up to 65535.";
            resolver.report(Problem::P6127, span, "there is no such address").help = Some(help.to_owned());
            None
        }
    }
}
