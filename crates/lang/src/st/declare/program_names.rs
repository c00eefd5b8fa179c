//! What people call the variables and constants of a program from outside.

use sieben_engine::program::{Constant as NamedConstant, Names as ProgramNames};
use sieben_model::address::Area;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::types::DataType;
use sieben_model::value::Content;

use super::access::operand;
use super::ast::LiteralKind;
use super::environment::Environment;
use super::initial::{bytes, value_of};
use crate::scope::key;
use crate::st::check::literals::natural;
use crate::st::check::names::{Constant, Entity, Variable};
use crate::st::dialect::{Calendar, Dialect};
use crate::st::tree::Base;

impl Environment<'_> {
    /// What people call the variables and constants of the program; the library has none that they would call.
    pub(crate) fn program_names(&self, is_of_library: &dyn Fn(BlockId) -> bool, diagnostics: &mut Vec<Diagnostic>) -> ProgramNames {
        let mut names = ProgramNames::default();
        for (id, name) in &self.items.names {
            if id.kind == BlockKind::DataBlock {
                names.blocks.insert(key(name), id.number);
            }
        }
        for program in &self.items.programs {
            // The name of a PROGRAM is enough where it has one instance.
            if self.items.program(&key(&program.of)).is_some_and(|only| only.instance == program.instance) {
                names.blocks.entry(key(&program.of)).or_insert(program.instance);
            }
            names.open.push(program.instance);
            if let Some(declared) = self.declared(program.block) {
                declared.variables.iter().for_each(|variable| locate(&mut names, &program.name, variable));
            }
        }
        names.open.extend(self.items.lists.iter().map(|list| list.number));
        for (name, entity) in &self.globals {
            if let (Some((list, _)), Entity::Variable(variable)) = (name.rsplit_once('.'), entity) {
                locate(&mut names, list, variable);
            }
        }
        self.constants(is_of_library, &mut names);
        let mut own = self.items.code.iter().filter(|(id, _)| !is_of_library(**id));
        names.short_dates = own.any(|(_, code)| code.dialect.switches().calendar == Calendar::Long);
        self.access_names(&mut names, diagnostics);
        names
    }

    /// Those of programs and of lists are called by their names alone, as those are where a block has its own; that of a block goes before.
    fn constants(&self, is_of_library: &dyn Fn(BlockId) -> bool, names: &mut ProgramNames) {
        let programs: Vec<BlockId> = self.items.programs.iter().map(|program| program.block).collect();
        let mut add = |block: Option<BlockId>, name: String, constant: &NamedConstant| {
            names.constants.entry((block, name)).or_insert_with(|| constant.clone());
        };
        for list in &self.items.lists {
            let before = format!("{}.", key(&list.name));
            for (name, entity) in self.globals.iter().filter(|(name, _)| name.starts_with(&before)) {
                let Some(constant) = constant(entity, list.dialect) else { continue };
                add(None, name.clone(), &constant);
                add(None, name[before.len()..].to_owned(), &constant);
            }
        }
        for (&id, code) in self.items.code.iter().filter(|(id, _)| !is_of_library(**id)) {
            let Some(declared) = self.declared(id) else { continue };
            for (name, entity) in &declared.names {
                let Some(constant) = constant(entity, code.dialect) else { continue };
                add(Some(id), name.clone(), &constant);
                add(None, format!("{}.{name}", key(&code.block.name.text)), &constant);
                if programs.contains(&id) {
                    add(None, name.clone(), &constant);
                }
            }
        }
    }
}

/// A constant with its type; one without a declared type has that of its literal.
fn constant(entity: &Entity, dialect: Dialect) -> Option<NamedConstant> {
    let Entity::Constant(Constant { value, data_type }) = entity else { return None };
    let data_type = data_type.clone().or_else(|| natural(value, dialect)).or_else(|| plain(value))?;
    let image = bytes(&data_type, &[value_of(value, &data_type, dialect).ok()?]);
    let content = match data_type.bits() {
        1 => Content::Bits(u64::from(*image.first()? & 1)),
        2..=64 if !data_type.stands_in_bytes() => Content::Bits(image.iter().fold(0, |bits, &byte| bits << 8 | u64::from(byte))),
        _ => Content::Bytes(image.into()),
    };
    Some(NamedConstant { data_type, content })
}

/// The type of a constant whose literal leaves it open.
fn plain(value: &LiteralKind) -> Option<DataType> {
    Some(match value {
        LiteralKind::Integer { value, .. } => match value {
            -0x8000..=0x7FFF => DataType::Int,
            -0x8000_0000..=0x7FFF_FFFF => DataType::DoubleInt,
            _ => DataType::LongInt,
        },
        LiteralKind::Real { .. } => DataType::Real,
        LiteralKind::Characters(text) => DataType::String(u8::try_from(text.len()).ok()?),
        LiteralKind::WideCharacters(text) => DataType::WideString(u16::try_from(text.len()).ok()?),
        _ => return None,
    })
}

/// Takes in the name of a variable with an address, alone and with that of its program or list.
fn locate(names: &mut ProgramNames, owner: &str, variable: &Variable) {
    let Base::Area(area) = variable.base else { return };
    let Some(width) = variable.data_type.width().filter(|_| area != Area::Local) else { return };
    if let Some(operand) = operand(&variable.base, variable.offset, width) {
        for name in [key(&variable.name), key(&format!("{owner}.{}", variable.name))] {
            names.located.entry(name).or_insert((operand, variable.data_type.clone()));
        }
    }
}
