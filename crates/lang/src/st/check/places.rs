//! Names, fields, elements, slices and addresses → where a variable lies.

use sieben_model::address::Area;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::Section;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, ReferenceKind};

use super::calls::after;
use super::members::{is_super, is_this};
use super::names::{Constant, Entity, Role};
use super::texts::text_room;
use super::typed::{Target, Through, Typed};
use super::types::{Class, Kind};
use super::{Checker, literals, operators};
use crate::scope::nearest;
use crate::st::ast::{self, Expression, ExpressionKind, LiteralKind, Name, Position, Quoting};
use crate::st::dialect::{AddressUnit, Construct, IndexFault};
use crate::st::open_arrays::is_open;
use crate::st::standard;
use crate::st::tree::{Base, Bounds, Index, Place, Scalar, Statement, Text, Value, ValueKind};

/// What a path leads to.
pub(super) enum Reached {
    /// A variable or a part of one.
    Target(Target),
    /// Anything else.
    Other(Typed),
}

const POISON: Reached = Reached::Other(Typed::Poison);

impl Checker<'_> {
    /// What a name, a path or an address leads to; other expressions are what they are.
    pub(super) fn reach(&mut self, expression: &Expression) -> Reached {
        let reached = self.reach_itself(expression);
        self.followed(reached, expression.span)
    }

    /// The same, where a REFERENCE TO is the variable that refers.
    pub(super) fn reach_itself(&mut self, expression: &Expression) -> Reached {
        let span = expression.span;
        match &expression.kind {
            ExpressionKind::Name(name) => self.name(name),
            ExpressionKind::Global(name) => match self.names.global(&name.text) {
                Some(entity) => self.entity(entity, name),
                None => self.unknown(name),
            },
            ExpressionKind::EnumValue { of, value } => self.enumeration_value(of, value),
            ExpressionKind::Address(address) => self.address(address),
            ExpressionKind::DataAddress(address) => self.data_address(address, span),
            ExpressionKind::Member(base, name) => self.member(base, name, span),
            ExpressionKind::Index(..) => self.index(expression),
            ExpressionKind::Dereference(base) => self.dereference(base, span),
            ExpressionKind::Slice(base, slice) => self.slice(base, slice, span),
            ExpressionKind::Parenthesized(inner) => self.reach(inner),
            ExpressionKind::Wire(wire) => self.of_wire(*wire, span),
            ExpressionKind::Contact(contact) => self.contact(contact),
            ExpressionKind::This => match self.this(span) {
                Some(target) => Reached::Target(target),
                None => POISON,
            },
            _ => Reached::Other(self.expression(expression)),
        }
    }

    /// A REFERENCE TO stands for what it refers to.
    fn followed(&mut self, reached: Reached, span: Span) -> Reached {
        match reached {
            Reached::Target(target) => match &target.data_type {
                DataType::Reference(reference) if reference.kind == ReferenceKind::Reference => {
                    let data_type = self.finished(&reference.target);
                    let pointer = Value { kind: ValueKind::Load(target.place.clone()), scalar: Scalar::U64, span };
                    let role = if target.role == Role::Input { Role::Global } else { target.role };
                    Reached::Target(Target { place: referred(pointer, span), data_type, role, through: Through::Reference, ..target })
                }
                _ => Reached::Target(Target { place: Place { span, ..target.place.clone() }, ..target }),
            },
            // What a function delivers has no name.
            Reached::Other(Typed::Scalar { value, data_type: DataType::Reference(reference) })
                if reference.kind == ReferenceKind::Reference =>
            {
                Reached::Target(self.behind_result(value, &reference.target, span))
            }
            other => other,
        }
    }

    /// What a variable holds.
    pub(super) fn load(&mut self, target: Target) -> Typed {
        let span = target.place.span;
        if target.place.base == Base::Area(Area::PeripheralOutput) {
            let message = format!("`{}` is a peripheral output, and these can only be written", target.name);
            self.report(Problem::P6231, span, message);
            return Typed::Poison;
        }
        if let Some(kind) = Kind::of(&target.data_type) {
            let scalar = kind.scalar(self.dialect);
            return Typed::Scalar { value: Value { kind: ValueKind::Load(target.place), scalar, span }, data_type: target.data_type };
        }
        match target.data_type {
            DataType::String(_) | DataType::WideString(_) => match text_room(&target) {
                Some(room) => Typed::Text(Text::Place { place: target.place, room }),
                None => Typed::Poison,
            },
            number if number.is_number() => {
                // A function gets the number itself, an instance keeps it in a word.
                let kind = match target.place.base {
                    Base::Parameter(index) | Base::ComplexParameter(index) => ValueKind::NumberParameter(index),
                    _ => ValueKind::Load(target.place),
                };
                Typed::Number { data_type: number, value: Value { kind, scalar: Scalar::U16, span } }
            }
            _ if !self.is_whole(&target) => Typed::Poison,
            _ => Typed::Aggregate(target),
        }
    }

    fn name(&mut self, name: &Name) -> Reached {
        let found = match name.quoting {
            Quoting::Local => self.names.local(&name.text),
            Quoting::Global => self.own_result(name).or_else(|| self.names.global(&name.text)),
            Quoting::Bare | Quoting::Backquoted => self.names.local(&name.text).or_else(|| self.names.global(&name.text)),
        };
        match found {
            Some(entity) if !self.may_see(&entity, name) => POISON,
            Some(entity) => self.entity(entity, name),
            None => match self.flag(name).or_else(|| self.own_property(name, name.span)) {
                Some(value) => Reached::Other(value),
                None => match standard::type_of_word(&name.text, self.dialect).filter(|_| name.quoting == Quoting::Bare) {
                    Some(data_type) => Reached::Other(Typed::Type(data_type)),
                    None => self.unknown(name),
                },
            },
        }
    }

    /// The result of the function that bears the name, in the function itself: `"Name" := 1`.
    fn own_result(&self, name: &Name) -> Option<Entity> {
        let own = self.names.local(&name.text)?;
        let is_result = matches!(&own, Entity::Variable(variable) if variable.role == Role::Result || variable.data_type == DataType::Void);
        is_result.then_some(own)
    }

    /// OK and ENO.
    fn flag(&mut self, name: &Name) -> Option<Typed> {
        let switches = self.dialect.switches();
        let kind = match () {
            () if name.quoting == Quoting::Global => return None,
            () if switches.ok_flag && name.is("OK") => ValueKind::Ok,
            () if switches.ok_flag && name.is("ENO") => ValueKind::Eno,
            () if switches.eno_variable && name.is("ENO") => ValueKind::Ok,
            () if switches.eno_variable && name.is("EN") => ValueKind::Constant(1),
            () => return None,
        };
        Some(Typed::Scalar { value: Value { kind, scalar: Scalar::Bool, span: name.span }, data_type: DataType::Bool })
    }

    fn unknown(&mut self, name: &Name) -> Reached {
        if self.is_declared_outside(name) {
            return POISON;
        }
        let nearest = self.names.nearest(&name.text);
        let message = match name.quoting {
            Quoting::Local => format!("`{}` is not declared in this block", name.text),
            Quoting::Global => format!("`\"{}\"` is neither a symbol nor a block of the project", name.text),
            Quoting::Bare | Quoting::Backquoted => format!("`{}` is not declared", name.text),
        };
        let diagnostic = self.report(Problem::P3001, name.span, message);
        diagnostic.may_be_elsewhere = name.quoting != Quoting::Local;
        if let Some(nearest) = nearest {
            let written = match name.quoting {
                Quoting::Local => format!("#{nearest}"),
                Quoting::Global => format!("\"{nearest}\""),
                Quoting::Bare | Quoting::Backquoted => nearest.clone(),
            };
            *diagnostic = diagnostic.clone().guess(name.span, written, format!("write `{nearest}`"));
            let place = match name.quoting {
                Quoting::Local => "in the VAR sections of the block",
                Quoting::Global => "in the symbol table",
                Quoting::Bare | Quoting::Backquoted => "in the symbol table or in the VAR sections of the block",
            };
            diagnostic.help = Some(format!("If `{nearest}` is not meant, declare it {place}."));
        }
        POISON
    }

    pub(super) fn entity(&mut self, entity: Entity, name: &Name) -> Reached {
        let span = name.span;
        Reached::Other(match entity {
            Entity::Variable(variable) if variable.data_type == DataType::Void => Typed::Poison,
            Entity::Variable(variable) => {
                return Reached::Target(Target {
                    place: Place { base: variable.base, offset: variable.offset, indexes: Vec::new(), span },
                    data_type: variable.data_type,
                    role: variable.role,
                    name: variable.name,
                    through: Through::Itself,
                });
            }
            Entity::Constant(constant) => self.constant(&constant, span),
            Entity::EnumValue { data_type, value } => self.named_value(data_type, value, span),
            Entity::Ambiguous(full) => {
                let full: Vec<String> = full.iter().map(|name| format!("`{name}`")).collect();
                let message = format!("`{}` is a value of several enumerations: write {}", name.text, full.join(" or "));
                self.report(Problem::P6230, span, message);
                Typed::Poison
            }
            Entity::Block(block) => Typed::Block(block),
            Entity::Type(data_type) => Typed::Type(data_type),
            Entity::Number { data_type, number } => Typed::Number { data_type, value: word(number, span) },
            Entity::Qualifier => Typed::Qualifier(vec![name.text.clone()]),
        })
    }

    /// A declared constant as an expression.
    fn constant(&mut self, constant: &Constant, span: Span) -> Typed {
        match &constant.data_type {
            None => self.literal(&constant.value, None, span),
            Some(DataType::String(_)) => match &constant.value {
                LiteralKind::Characters(text) => Typed::Text(Text::Constant(text.clone())),
                _ => Typed::Poison,
            },
            Some(DataType::WideString(_)) => match &constant.value {
                LiteralKind::WideCharacters(text) => Typed::Text(Text::WideConstant(text.clone())),
                LiteralKind::Characters(text) => Typed::Text(Text::WideConstant(text.iter().map(|&byte| byte.into()).collect())),
                _ => Typed::Poison,
            },
            Some(data_type) => {
                let Some(kind) = Kind::of(data_type) else { return self.literal(&constant.value, None, span) };
                match literals::bits(&constant.value, kind, self.dialect) {
                    Ok((bits, _)) => self.of_bits(bits, data_type.clone(), span),
                    // What does not fit was reported where it is declared.
                    Err(_) => Typed::Poison,
                }
            }
        }
    }

    fn of_bits(&self, bits: u64, data_type: DataType, span: Span) -> Typed {
        let scalar = Kind::of(&data_type).map_or(Scalar::U64, |kind| kind.scalar(self.dialect));
        Typed::Scalar { value: Value { kind: ValueKind::Constant(bits), scalar, span }, data_type }
    }

    fn named_value(&self, data_type: DataType, value: i128, span: Span) -> Typed {
        let bits = value as u64 & literals::mask(Kind::of(&data_type).map_or(16, |kind| kind.bits));
        self.of_bits(bits, data_type, span)
    }

    /// The value of an enumeration by its name, if the type has it.
    pub(super) fn value_of(&self, data_type: &DataType, name: &Name) -> Option<Typed> {
        let DataType::Enumeration(enumeration) = data_type else { return None };
        let value = enumeration.value(&name.text)?;
        Some(self.named_value(data_type.clone(), i128::from(value), name.span))
    }

    fn enumeration_value(&mut self, of: &ast::Path, value: &Name) -> Reached {
        let names: Vec<&str> = of.names.iter().map(|name| name.text.as_str()).collect();
        let found = match names.as_slice() {
            [single] => self.names.local(single).filter(|found| matches!(found, Entity::Type(_))).or_else(|| self.names.global(single)),
            _ => self.names.qualified(&names),
        };
        let unknown = found.is_none();
        match found {
            Some(Entity::Type(data_type)) => self.value_in(&data_type, value),
            _ => {
                let message = format!("`{}` is not the name of an enumeration", names.join("."));
                self.report(Problem::P3015, of.span, message).may_be_elsewhere = unknown;
                POISON
            }
        }
    }

    fn value_in(&mut self, data_type: &DataType, value: &Name) -> Reached {
        if let Some(found) = self.value_of(data_type, value) {
            return Reached::Other(found);
        }
        let DataType::Enumeration(enumeration) = data_type else {
            self.report(Problem::P4010, value.span, format!("{} is not an enumeration and has no named values", self.words(data_type)));
            return POISON;
        };
        let known: Vec<String> = enumeration.values.iter().take(12).map(|(name, _)| format!("`{name}`")).collect();
        let message = format!("{} has no value `{}`; it has {}", self.words(data_type), value.text, known.join(", "));
        self.report(Problem::P3007, value.span, message);
        POISON
    }

    fn member(&mut self, base: &Expression, name: &Name, span: Span) -> Reached {
        if is_this(base)
            && let Some(found) = self.field_of_this(name, span)
        {
            return found;
        }
        if is_super(base) {
            return match self.field_of_base(name, span) {
                Some(found) => found,
                None => Reached::Other(self.super_property(name, span)),
            };
        }
        let mut reached = self.reach(base);
        if let Reached::Other(Typed::Block(block)) = reached
            && self.has_members(block)
            && self.of_program(base, name).is_none()
        {
            reached = self.of_program_instance(reached, base.span);
        }
        if let Some(property) = self.property_in(&reached, name, span) {
            return Reached::Other(property);
        }
        match reached {
            Reached::Target(target) => match self.of_any(&target, name, span) {
                Some(found) => Reached::Other(found),
                None => self.field(target, name, span),
            },
            Reached::Other(Typed::Poison) => POISON,
            Reached::Other(Typed::Delivered(before, target)) => match self.field(target, name, span) {
                Reached::Target(field) => Reached::Other(self.delivered_part(before, field, span)),
                other => other,
            },
            Reached::Other(Typed::Block(block)) if block.kind == BlockKind::DataBlock => match self.data_block(block, base.span) {
                Some(target) => self.field(target, name, span),
                None => POISON,
            },
            Reached::Other(Typed::Qualifier(mut path)) => {
                path.push(name.text.clone());
                let names: Vec<&str> = path.iter().map(String::as_str).collect();
                match self.names.qualified(&names) {
                    Some(Entity::Qualifier) => Reached::Other(Typed::Qualifier(path)),
                    Some(entity) => self.entity(entity, &Name { span, ..name.clone() }),
                    None => {
                        let message = format!("`{}` has nothing of the name `{}`", path[..path.len() - 1].join("."), name.text);
                        self.report(Problem::P3001, name.span, message).may_be_elsewhere = true;
                        POISON
                    }
                }
            }
            // A variable of a program: `PLC_PRG.x`.
            Reached::Other(Typed::Block(block)) if self.of_program(base, name).is_some() => match self.of_program(base, name) {
                Some(entity) => self.entity(entity, &Name { span, ..name.clone() }),
                None => Reached::Other(Typed::Block(block)),
            },
            Reached::Other(Typed::Block(block) | Typed::Type(DataType::Instance { block, .. }))
                if let Some(constant) = self.names.constant_of(block, &name.text) =>
            {
                match self.judge(Construct::ForeignInternal, name.span) {
                    true => self.entity(constant, &Name { span, ..name.clone() }),
                    false => POISON,
                }
            }
            Reached::Other(Typed::Type(data_type)) => self.value_in(&data_type, name),
            Reached::Other(other) => {
                let what = self.what(&other);
                self.report(Problem::P4010, name.span, format!("{what} has no field `{}`", name.text));
                POISON
            }
        }
    }

    /// The variable of a program that is named before the point.
    fn of_program(&self, base: &Expression, name: &Name) -> Option<Entity> {
        let ExpressionKind::Name(program) = &base.kind else { return None };
        self.names.qualified(&[&program.text, &name.text]).filter(|entity| matches!(entity, Entity::Variable(_)))
    }

    /// A data block as a variable.
    pub(super) fn data_block(&mut self, block: BlockId, span: Span) -> Option<Target> {
        let Some(view) = self.names.data_block(block.number) else {
            if self.names.is_wrong_data(block.number) {
                self.failed = true;
                return None;
            }
            // One with a name may be declared and have a mistake of its own.
            let (name, number) = (self.names.block_name(block), block.to_string());
            let message = match name == number {
                true => format!("the data block {number} does not exist"),
                false => format!("the data block `{name}` does not exist, or its declaration has a mistake"),
            };
            self.report(Problem::P3008, span, message).may_be_elsewhere = true;
            return None;
        };
        let place = Place { base: Base::DataBlock(block.number), offset: 0, indexes: Vec::new(), span };
        let data_type = match view.based_on {
            Some(id) if matches!(id.kind, BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock) => {
                DataType::Instance { block: id, structure: view.structure }
            }
            _ => DataType::Struct(view.structure),
        };
        let name = self.names.block_name(block);
        Some(Target { place, data_type, role: Role::Global, name, through: Through::Itself })
    }

    fn field(&mut self, target: Target, name: &Name, span: Span) -> Reached {
        let (structure, through) = match &target.data_type {
            DataType::Struct(structure) => (structure, Through::Part),
            DataType::Instance { block, .. } if self.names.is_twice(*block, &name.text) => {
                self.failed = true;
                return POISON;
            }
            DataType::Instance { block, structure } => {
                let section = self.names.interface(*block).and_then(|interface| Some(interface.variable(&name.text)?.section));
                let through = match section {
                    Some(Section::Input | Section::InOut) => Through::InstanceInput,
                    Some(Section::Output) => Through::InstanceOutput,
                    _ if self.names.is_public(*block, &name.text) => Through::InstanceInput,
                    _ => Through::InstanceInternal,
                };
                (structure, through)
            }
            _ => return self.no_field(target, name, span),
        };
        let Some(field) = structure.field(&name.text) else {
            if let DataType::Instance { block, .. } = target.data_type
                && let Some(constant) = self.names.constant_of(block, &name.text)
                && self.judge(Construct::ForeignInternal, name.span)
            {
                return self.entity(constant, &Name { span, ..name.clone() });
            }
            if let DataType::Instance { block, .. } = target.data_type
                && self.names.objects().lacks_base(block)
            {
                self.failed = true;
                return POISON;
            }
            let nearest = nearest(&name.text, structure.fields.iter().map(|field| field.name.as_str()));
            let message = format!("{} has no field `{}`", self.words(&target.data_type), name.text);
            let diagnostic = self.report(Problem::P3007, name.span, message);
            if let Some(nearest) = nearest {
                *diagnostic = diagnostic.clone().guess(name.span, nearest.clone(), format!("write `{nearest}`"));
            }
            return POISON;
        };
        // An instance of the own block has no secrets.
        let own = |this: BlockId| matches!(&target.data_type, DataType::Instance { block, .. } if self.names.objects().is_a(this, *block));
        let through = match through {
            Through::InstanceInternal if self.names.this().is_some_and(own) => Through::Part,
            other => other,
        };
        if through == Through::InstanceInternal && !self.names.knows_instances() && !self.judge(Construct::ForeignInternal, name.span) {
            return POISON;
        }
        // What was reached through an instance stays part of it: `inst.out.x` is no more writable than `inst.out`.
        let through = match target.through {
            Through::Itself | Through::Part | Through::Reference => through,
            outer @ (Through::InstanceOutput | Through::InstanceInput) if through == Through::Part => outer,
            _ => through,
        };
        let (offset, data_type) = (field.offset, field.data_type.clone());
        Reached::Target(Target {
            place: Place { offset: target.place.offset.saturating_add(offset), span, ..target.place },
            data_type,
            role: target.role,
            name: format!("{}.{}", target.name, name.text),
            through,
        })
    }

    /// `x.name` of something without fields: with a constant it is the bit of that number.
    fn no_field(&mut self, target: Target, name: &Name, span: Span) -> Reached {
        let bits = Kind::of(&target.data_type).is_some_and(|kind| matches!(kind.class, Class::Bits | Class::Signed | Class::Unsigned));
        if bits && let Some(index) = self.constant_number(name) {
            if !self.judge(Construct::BitByNumber, name.span) {
                return POISON;
            }
            let slice = ast::Slice { bits: 1, index, percent: false, span: name.span };
            return self.slice_of(target, &slice, span);
        }
        let message = format!("`{}` is {} and has no field `{}`", target.name, self.words(&target.data_type), name.text);
        // A constant of another file may be the number of a bit.
        let elsewhere = bits
            && self.dialect.judge(Construct::BitByNumber) != crate::st::dialect::Judgement::Reject
            && self.names.local(&name.text).is_none()
            && self.names.global(&name.text).is_none();
        let has_pointers = self.dialect.has_pointers();
        let diagnostic = self.report(Problem::P4010, name.span, message);
        diagnostic.may_be_elsewhere = elsewhere;
        if target.data_type == DataType::Any && has_pointers {
            diagnostic.help = Some("An ANY has `TypeClass`, `pValue` and `diSize`.".to_owned());
        }
        POISON
    }

    fn constant_number(&mut self, name: &Name) -> Option<u64> {
        match self.names.local(&name.text).or_else(|| self.names.global(&name.text))? {
            Entity::Constant(Constant { value: LiteralKind::Integer { value, .. }, .. }) => u64::try_from(value).ok(),
            _ => None,
        }
    }

    fn slice(&mut self, base: &Expression, slice: &ast::Slice, span: Span) -> Reached {
        match self.reach(base) {
            Reached::Target(target) => self.slice_of(target, slice, span),
            Reached::Other(Typed::Poison) => POISON,
            Reached::Other(other) => {
                let what = self.what(&other);
                self.report(Problem::P6225, slice.span, format!("{what} is no variable, and only a variable has bits to take out"));
                POISON
            }
        }
    }

    /// A part of a value: which bytes it has follows from the byte order of the S7, the highest byte first.
    fn slice_of(&mut self, target: Target, slice: &ast::Slice, span: Span) -> Reached {
        let kind = Kind::of(&target.data_type).filter(|kind| matches!(kind.class, Class::Bits | Class::Signed | Class::Unsigned));
        let Some(kind) = kind.filter(|&kind| kind != Kind::BOOL) else {
            let message = format!("`{}` is {} and has no parts", target.name, self.words(&target.data_type));
            self.report(Problem::P6225, slice.span, message);
            return POISON;
        };
        let parts = u64::from(kind.bits / slice.bits.max(1));
        if slice.bits >= kind.bits || slice.index >= parts {
            let message = match parts {
                0 | 1 => format!("`{}` is {} and has no part of {} bits", target.name, self.words(&target.data_type), slice.bits),
                _ => format!("`{}` is {}: the number is 0 to {}", target.name, self.words(&target.data_type), parts - 1),
            };
            self.report(Problem::P6225, slice.span, message);
            return POISON;
        }
        let index = slice.index as u32;
        let offset = match slice.bits {
            1 => (kind.bits / 8 - 1 - index / 8) * 8 + index % 8,
            bits => kind.bits - (index + 1) * bits,
        };
        Reached::Target(Target {
            place: Place { offset: target.place.offset.saturating_add(offset), span, ..target.place },
            data_type: Kind { class: Class::Bits, bits: slice.bits }.data_type(),
            through: Through::Slice,
            ..target
        })
    }

    fn dereference(&mut self, base: &Expression, span: Span) -> Reached {
        if is_this(base) {
            return self.this(span).map_or(POISON, Reached::Target);
        }
        let reached = self.reach(base);
        let typed = match reached {
            Reached::Target(target) => {
                let name = target.name.clone();
                match self.load(target) {
                    Typed::Scalar { value, data_type: DataType::Reference(reference) } => {
                        return Reached::Target(Target {
                            place: referred(value, span),
                            data_type: self.finished(&reference.target),
                            role: Role::Global,
                            name: format!("{name}^"),
                            through: Through::Reference,
                        });
                    }
                    other => other,
                }
            }
            Reached::Other(Typed::Scalar { value, data_type: DataType::Reference(reference) })
                if matches!(reference.kind, ReferenceKind::RefTo | ReferenceKind::Pointer) =>
            {
                return Reached::Target(self.behind_result(value, &reference.target, span));
            }
            Reached::Other(typed) => typed,
        };
        if typed != Typed::Poison {
            let what = self.what(&typed);
            self.report(Problem::P6228, span, format!("{what} is no reference and cannot be followed with `^`"));
        }
        POISON
    }

    /// What a reference refers to: of a structure or a block that points to itself only the name is known to the reference.
    pub(super) fn finished(&self, data_type: &DataType) -> DataType {
        match data_type {
            DataType::Instance { block, structure } if structure.fields.is_empty() => {
                let structure = self.names.instance(*block).unwrap_or_else(|| structure.clone());
                DataType::Instance { block: *block, structure }
            }
            DataType::Struct(structure) if structure.fields.is_empty() => {
                let name = structure.name.as_deref().unwrap_or_default();
                let within = format!("{}{name}", self.names.namespace());
                let path: Vec<&str> = within.split('.').collect();
                match self.names.global(name).or_else(|| self.names.qualified(&path)) {
                    Some(Entity::Type(whole)) => whole,
                    _ => data_type.clone(),
                }
            }
            DataType::Array { bounds, element }
                if matches!(**element, DataType::Instance { .. } | DataType::Struct(_) | DataType::Array { .. }) =>
            {
                DataType::Array { bounds: bounds.clone(), element: Box::new(self.finished(element)) }
            }
            other => other.clone(),
        }
    }

    /// What a reference leads to that a function delivers.
    fn behind_result(&self, pointer: Value, data_type: &DataType, span: Span) -> Target {
        let (place, data_type, name) = (referred(pointer, span), self.finished(data_type), "the result".to_owned());
        Target { place, data_type, role: Role::Global, name, through: Through::Reference }
    }

    /// `a[i, j]`, `a[i][j]`: as many indexes as the array has dimensions, then those of its elements.
    fn index(&mut self, expression: &Expression) -> Reached {
        let mut groups = Vec::new();
        let mut base = expression;
        while let ExpressionKind::Index(inner, indexes) = &base.kind {
            groups.push((indexes, base.span));
            base = inner;
        }
        let mut before = Vec::new();
        let mut target = match self.reach(base) {
            Reached::Target(target) => target,
            Reached::Other(Typed::Delivered(statements, target)) => {
                before = statements;
                target
            }
            Reached::Other(Typed::Poison) => return POISON,
            Reached::Other(other) => {
                let what = self.what(&other);
                self.report(Problem::P4010, expression.span, format!("{what} has no elements"));
                return POISON;
            }
        };
        let indexes: Vec<&Expression> = groups.iter().rev().flat_map(|(indexes, _)| indexes.iter()).collect();
        let mut rest = indexes.as_slice();
        while let Some(first) = rest.first() {
            let reached = match &target.data_type {
                DataType::Array { bounds, .. } => {
                    let dimensions = bounds.len();
                    if rest.len() < dimensions {
                        let message = format!(
                            "`{}` has {dimensions} dimensions, and {} of them {} given",
                            target.name,
                            rest.len(),
                            if rest.len() == 1 { "is" } else { "are" }
                        );
                        self.report(Problem::P4005, expression.span, message);
                        return POISON;
                    }
                    let (own, behind) = rest.split_at(dimensions);
                    rest = behind;
                    if is_open(&target.data_type) {
                        match self.open_element(target, own, expression.span) {
                            Some(element) => target = element,
                            None => return POISON,
                        }
                        continue;
                    }
                    self.element(target, own, expression.span)
                }
                DataType::String(_) | DataType::WideString(_) => {
                    rest = &rest[1..];
                    self.character(target, first, expression.span)
                }
                DataType::Reference(reference) if reference.kind == ReferenceKind::Pointer => {
                    rest = &rest[1..];
                    let element = self.finished(&reference.target);
                    let step = element_step(&element);
                    let pointer = Value { kind: ValueKind::Load(target.place.clone()), scalar: Scalar::U64, span: first.span };
                    let Some((value, _)) = self.index_value(first) else { return POISON };
                    let mut place = referred(pointer, expression.span);
                    place.indexes.push(Index { value, low: 0, count: 0, step, check: Bounds::None });
                    Some(Target { place, data_type: element, through: Through::Reference, ..target })
                }
                other => {
                    let message = format!("`{}` is {} and has no elements", target.name, self.words(other));
                    self.report(Problem::P4010, first.span, message);
                    None
                }
            };
            match reached {
                Some(element) => target = element,
                None => return POISON,
            }
        }
        target.place.span = expression.span;
        if !before.is_empty() {
            return Reached::Other(self.delivered_part(before, target, expression.span));
        }
        Reached::Target(target)
    }

    /// A part of what a function delivers.
    fn delivered_part(&mut self, before: Vec<Statement>, part: Target, span: Span) -> Typed {
        match self.load(part) {
            Typed::Scalar { value, data_type } => Typed::Scalar { value: after(before, value), data_type },
            Typed::Aggregate(part) => Typed::Delivered(before, part),
            Typed::Text(text) => Typed::Text(Text::After(before, Box::new(text))),
            Typed::Poison => Typed::Poison,
            _ => self.not_built(span, "this part of a result"),
        }
    }

    fn element(&mut self, mut target: Target, indexes: &[&Expression], span: Span) -> Option<Target> {
        let DataType::Array { bounds, element } = target.data_type.clone() else { return None };
        let mut sound = true;
        let steps = dimension_steps(&bounds, &element);
        for ((index, &(low, high)), step) in indexes.iter().zip(&bounds).zip(steps) {
            let Some((value, (least, most))) = self.index_value(index) else {
                sound = false;
                continue;
            };
            let (low, high) = (i128::from(low), i128::from(high));
            if most < low || least > high {
                let message = match least == most {
                    true => format!("the index {least} is outside {low}..{high} of `{}`", target.name),
                    false => format!("the index is {least} to {most} here, outside {low}..{high} of `{}`", target.name),
                };
                self.report(Problem::P4005, index.span, message);
                sound = false;
            } else if least == most {
                let bits = (least - low) as u64 * u64::from(step);
                target.place.offset = target.place.offset.saturating_add(u32::try_from(bits).unwrap_or(u32::MAX));
            } else {
                let check = if low <= least && most <= high { Bounds::None } else { self.bounds_check() };
                let (low, count) = (low as i64, (high - low + 1) as u64);
                target.place.indexes.push(Index { value, low, count, step, check });
            }
        }
        if indexes.len() != bounds.len() || !sound {
            return None;
        }
        target.place.span = span;
        let through = if target.through == Through::Itself { Through::Part } else { target.through };
        Some(Target { data_type: *element, through, name: format!("{}[…]", target.name), ..target })
    }

    /// A character of a text.
    fn character(&mut self, mut target: Target, index: &Expression, span: Span) -> Option<Target> {
        let room = crate::st::tree::room_of(&target.data_type)?;
        let length = room.characters_max;
        let (value, (least, most)) = self.index_value(index)?;
        let first = i64::from(self.dialect.switches().string_first);
        let (low, high) = (i128::from(first), i128::from(first) + i128::from(length) - 1);
        if most < low || least > high {
            let message = format!("`{}` has the characters {low} to {high}", target.name);
            self.report(Problem::P4005, index.span, message);
            return None;
        }
        target.place.offset = target.place.offset.saturating_add(8 * room.head());
        let check = if low <= least && most <= high { Bounds::None } else { self.bounds_check() };
        target.place.indexes.push(Index { value, low: first, count: u64::from(length), step: 8 * room.unit(), check });
        target.place.span = span;
        let data_type = match (first == 0, room.wide) {
            (true, false) => DataType::Byte,
            (true, true) => DataType::Word,
            (false, false) => DataType::Char,
            (false, true) => DataType::WideChar,
        };
        Some(Target { data_type, through: Through::Part, name: format!("{}[…]", target.name), ..target })
    }

    pub(super) fn bounds_check(&mut self) -> Bounds {
        match self.dialect.switches().index_fault {
            _ if self.own_errors => Bounds::Skip,
            IndexFault::Skip => Bounds::Skip,
            IndexFault::CheckBounds if self.names.global("CheckBounds").is_some() => Bounds::Clamp,
            IndexFault::CheckBounds | IndexFault::ProgrammingError => Bounds::Fault,
        }
    }

    /// An index as I32 or I64, with the least and the greatest value that it can have.
    pub(super) fn index_value(&mut self, expression: &Expression) -> Option<(Value, (i128, i128))> {
        let typed = self.expression(expression);
        let (value, data_type) = self.scalar(typed, expression.span)?;
        let kind = Kind::of(&data_type)?;
        let counts = kind.is_integer() || kind.class == Class::Bits && kind != Kind::BOOL && self.dialect.switches().integer_bits_min > 8;
        let named = matches!(data_type, DataType::Enumeration(_));
        if !counts && !named {
            let message = format!("an index is an integer, not {}", self.words(&data_type));
            self.report(Problem::P6200, expression.span, message);
            return None;
        }
        let range = self.range_of(&value);
        let wide = matches!(value.scalar, Scalar::U32 | Scalar::I64 | Scalar::U64);
        Some((operators::convert(value, if wide { Scalar::I64 } else { Scalar::I32 }), range))
    }

    fn address(&mut self, address: &ast::Address) -> Reached {
        // A variable that is called like an address goes before the address.
        if !address.percent
            && let Some(reached) = self.called_like(address)
        {
            return reached;
        }
        // The address is declared itself, `AT %MW6 : INT`, and has the type that is written there.
        if address.percent
            && let Some(name) = address.plain()
            && let Some(entity @ Entity::Variable(_)) = self.names.local(&name).or_else(|| self.names.global(&name))
        {
            return self.entity(entity, &Name { text: name, span: address.span, ..Name::default() });
        }
        if matches!(address.area, ast::Area::Timer | ast::Area::Counter) {
            let data_type = if address.area == ast::Area::Timer { DataType::Timer } else { DataType::Counter };
            let value = match &address.position {
                Position::Fixed(numbers) => match numbers.as_slice() {
                    &[number] => u16::try_from(number).ok().map(|number| word(number, address.span)),
                    _ => None,
                },
                Position::Computed(indexes) => match indexes.as_slice() {
                    [index] => {
                        return match self.index_value(index) {
                            Some((value, _)) => Reached::Other(Typed::Number { data_type, value: operators::convert(value, Scalar::U16) }),
                            None => POISON,
                        };
                    }
                    _ => None,
                },
                Position::Open => None,
            };
            return match value {
                Some(value) => Reached::Other(Typed::Number { data_type, value }),
                None => {
                    let message = format!("`{}` needs one number from 0 to 65535", address.written.text);
                    self.report(Problem::P4015, address.span, message);
                    POISON
                }
            };
        }
        let area = match address.area {
            ast::Area::Input => Area::Input,
            ast::Area::Output => Area::Output,
            ast::Area::Memory => Area::BitMemory,
            ast::Area::PeripheralInput => Area::PeripheralInput,
            ast::Area::PeripheralOutput => Area::PeripheralOutput,
            ast::Area::Local => Area::Local,
            ast::Area::Timer | ast::Area::Counter => unreachable!("timers and counters were numbers above"),
        };
        let Some(place) = self.position(Base::Area(area), address.width, &address.position, address.percent, address.span) else {
            return POISON;
        };
        Reached::Target(Target {
            place,
            data_type: Kind { class: Class::Bits, bits: address.width.bits() }.data_type(),
            role: Role::Global,
            name: address.written.text.clone(),
            through: Through::Itself,
        })
    }

    /// A variable with the name of an address, such as an array `MW` in `MW[i]`.
    fn called_like(&mut self, address: &ast::Address) -> Option<Reached> {
        let variable = |found: &Entity| matches!(found, Entity::Variable(_) | Entity::Constant(_));
        let text = &address.written.text;
        let entity = self.names.local(text).filter(variable).or_else(|| self.names.global(text).filter(variable))?;
        let name = Expression { kind: ExpressionKind::Name(address.written.clone()), span: address.written.span };
        match &address.position {
            Position::Fixed(numbers) if numbers.len() < 2 => Some(self.entity(entity, &address.written)),
            Position::Fixed(numbers) => {
                let slice = ast::Slice { bits: 1, index: numbers[1], percent: false, span: address.span };
                Some(self.slice(&name, &slice, address.span))
            }
            Position::Computed(indexes) => {
                let element = Expression { kind: ExpressionKind::Index(Box::new(name), indexes.clone()), span: address.span };
                Some(self.index(&element))
            }
            Position::Open => None,
        }
    }

    /// Where an absolute address lies.
    fn position(&mut self, base: Base, width: ast::AddressWidth, position: &Position, percent: bool, span: Span) -> Option<Place> {
        let bits = width.bits();
        let unit = match self.dialect.switches().address_unit {
            AddressUnit::OwnWidth if percent => u64::from(bits.max(8)),
            _ => 8,
        };
        let place = |offset: u64, indexes| Place { base, offset: u32::try_from(offset).unwrap_or(u32::MAX), indexes, span };
        let incomplete = match (position, bits) {
            (Position::Fixed(numbers), 1) => match numbers.as_slice() {
                &[byte, bit] if bit < 8 => return self.within(place(byte.saturating_mul(8).saturating_add(bit), Vec::new())),
                [_, _] => "the bit is 0 to 7",
                _ => "a bit has two numbers, the byte and the bit, as in `0.5`",
            },
            (Position::Fixed(numbers), _) => match numbers.as_slice() {
                &[number] => return self.within(place(number.saturating_mul(unit), Vec::new())),
                _ => "a byte, word or double word has one number, that of its first byte",
            },
            (Position::Computed(indexes), _) => {
                let steps: &[u32] = if bits == 1 { &[8, 1] } else { &[8] };
                if indexes.len() == steps.len() {
                    let mut all = Vec::with_capacity(steps.len());
                    for (index, &step) in indexes.iter().zip(steps) {
                        let (value, _) = self.index_value(index)?;
                        all.push(Index { value, low: 0, count: 0, step, check: Bounds::None });
                    }
                    return Some(place(0, all));
                }
                if bits == 1 {
                    "a bit has two indexes, the byte and the bit"
                } else {
                    "a byte, word or double word has one index, its first byte"
                }
            }
            (Position::Open, _) => "an address with `*` stands only in a declaration, and VAR_CONFIG says where it lies",
        };
        self.report(Problem::P4015, span, format!("this address is not complete: {incomplete}"));
        None
    }

    /// Bytes of areas count from 0 to 65535.
    fn within(&mut self, place: Place) -> Option<Place> {
        if place.offset < 65536 * 8 {
            return Some(place);
        }
        self.report(Problem::P4001, place.span, "the bytes of an area count from 0 to 65535");
        None
    }

    fn data_address(&mut self, address: &ast::DataAddress, span: Span) -> Reached {
        let data_type = Kind { class: Class::Bits, bits: address.width.bits() }.data_type();
        let (base, name) = match self.reach(&address.block) {
            Reached::Other(Typed::Poison) => return POISON,
            Reached::Other(Typed::Block(block)) if block.kind == BlockKind::DataBlock && self.names.is_wrong_data(block.number) => {
                self.failed = true;
                return POISON;
            }
            Reached::Other(Typed::Block(block)) if block.kind == BlockKind::DataBlock => {
                // A field that is called like an address goes before the address.
                let view = self.names.data_block(block.number);
                if view.is_some_and(|view| view.structure.field(&address.written.text).is_some()) {
                    return self.named_like_an_address(address, span);
                }
                (Base::DataBlock(block.number), self.names.block_name(block))
            }
            Reached::Other(Typed::Number { data_type: DataType::BlockData, value }) => {
                (Base::ComputedDataBlock(Box::new(value)), "data block".to_owned())
            }
            Reached::Target(target) if target.data_type == DataType::BlockData => {
                let name = target.name.clone();
                match self.load(target) {
                    Typed::Number { value, .. } => (Base::ComputedDataBlock(Box::new(value)), name),
                    _ => return POISON,
                }
            }
            Reached::Target(_) => return self.named_like_an_address(address, span),
            Reached::Other(other) => {
                let what = self.what(&other);
                self.report(Problem::P4010, address.block.span, format!("{what} is no data block"));
                return POISON;
            }
        };
        let computed = matches!(address.position, Position::Computed(_));
        if computed && !self.judge(Construct::ComputedAddress, address.written.span) {
            return POISON;
        }
        let Some(place) = self.position(base, address.width, &address.position, false, span) else { return POISON };
        Reached::Target(Target { place, data_type, role: Role::Global, name, through: Through::Part })
    }

    /// `"Data".dw[4]`, `"Data".d0.1` where `dw` and `d0` are fields.
    fn named_like_an_address(&mut self, address: &ast::DataAddress, span: Span) -> Reached {
        let field = ExpressionKind::Member(Box::new(address.block.clone()), address.written.clone());
        let field = Box::new(Expression { kind: field, span: address.block.span.to(address.written.span) });
        let kind = match &address.position {
            Position::Computed(indexes) => ExpressionKind::Index(field, indexes.clone()),
            Position::Fixed(numbers) if let Some(&index) = numbers.get(1) => {
                ExpressionKind::Slice(field, ast::Slice { bits: 1, index, percent: false, span })
            }
            _ => field.kind,
        };
        self.reach(&Expression { kind, span })
    }

    /// What an expression is, for messages.
    pub(super) fn what(&self, typed: &Typed) -> String {
        match typed {
            Typed::Poison => "this".to_owned(),
            Typed::Integer { .. } | Typed::Real { .. } => "a number".to_owned(),
            Typed::Scalar { data_type, .. } | Typed::Number { data_type, .. } => format!("a value of type {}", self.words(data_type)),
            Typed::Text(text) if text.is_wide() => "a WSTRING".to_owned(),
            Typed::Text(_) => "a text".to_owned(),
            Typed::Delivered(_, target) => format!("a result of type {}", self.words(&target.data_type)),
            Typed::Aggregate(target) => format!("`{}` of type {}", target.name, self.words(&target.data_type)),
            Typed::Moment(_) => "a DATE_AND_TIME".to_owned(),
            Typed::Structured(..) => "a DTL".to_owned(),
            Typed::Pointer(_) => "a pointer".to_owned(),
            Typed::Null => "NULL".to_owned(),
            Typed::Block(block) => format!("the block `{}`", self.names.block_name(*block)),
            Typed::Type(data_type) => format!("the type {}", self.words(data_type)),
            Typed::Qualifier(path) => format!("`{}`", path.join(".")),
        }
    }
}

/// A STRING whose length only its first byte tells.
pub(super) fn unknown_length(place: &Place) -> bool {
    matches!(place.base, Base::ComplexParameter(_) | Base::InstancePointer(_) | Base::Reference(_)) && place.offset == 0
}

/// What a pointer leads to.
pub(super) fn referred(pointer: Value, span: Span) -> Place {
    Place { base: Base::Reference(Box::new(pointer)), offset: 0, indexes: Vec::new(), span }
}

/// A number of 16 bits.
fn word(number: u16, span: Span) -> Value {
    Value { kind: ValueKind::Constant(u64::from(number)), scalar: Scalar::U16, span }
}

/// Bits from one element to the next.
pub(crate) fn element_step(element: &DataType) -> u32 {
    if *element == DataType::Bool { 1 } else { u32::try_from(element.bits()).unwrap_or(u32::MAX) }
}

/// Bits from one index to the next, for each dimension.
pub(crate) fn dimension_steps(bounds: &[(i32, i32)], element: &DataType) -> Vec<u32> {
    let count = |&(low, high): &(i32, i32)| u64::try_from(i64::from(high) - i64::from(low) + 1).unwrap_or(0);
    let mut step = u64::from(element_step(element));
    let mut steps = Vec::with_capacity(bounds.len());
    for (position, dimension) in bounds.iter().enumerate().rev() {
        steps.push(u32::try_from(step).unwrap_or(u32::MAX));
        step = step.saturating_mul(count(dimension));
        // Rows of BOOL, BYTE and CHAR are padded to words.
        if position + 1 == bounds.len() && !element.word_aligned() {
            step = step.checked_next_multiple_of(16).unwrap_or(u64::MAX);
        }
    }
    steps.reverse();
    steps
}
