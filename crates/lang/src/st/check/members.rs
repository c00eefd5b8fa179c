//! THIS and SUPER, methods and properties.

use sieben_engine::ir::Op;
use sieben_model::block::BlockId;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, ReferenceKind};

use super::Checker;
use super::calls::Called;
use super::names::{Entity, Role};
use super::places::{Reached, referred};
use super::typed::{Target, Through, Typed};
use crate::scope::nearest;
use crate::st::ast::{self, Access, BlockKind, Expression, ExpressionKind, MemberKind, Name};
use crate::st::objects::Member;
use crate::st::tree::{Base, Callee, Place, Scalar, Statement, StatementKind, Value, ValueKind};

/// An instance of which something is a member.
pub(super) struct Owner {
    /// What it is known to be.
    block: BlockId,
    /// Where it lies.
    place: Place,
    /// It may be an instance of a block that extends what it is known to be.
    open: bool,
}

/// A member with the instance that it works on.
pub(super) struct Used {
    member: Member,
    owner: Owner,
}

/// The block that a reference or an interface refers to.
fn refers(data_type: &DataType) -> Option<BlockId> {
    match data_type {
        DataType::Reference(reference) => match reference.target {
            DataType::Instance { block, .. } => Some(block),
            _ => None,
        },
        _ => None,
    }
}

/// THIS and `THIS^`.
pub(super) fn is_this(expression: &Expression) -> bool {
    match &expression.kind {
        ExpressionKind::This => true,
        ExpressionKind::Dereference(inner) | ExpressionKind::Parenthesized(inner) => is_this(inner),
        _ => false,
    }
}

/// SUPER and `SUPER^`.
pub(crate) fn is_super(expression: &Expression) -> bool {
    match &expression.kind {
        ExpressionKind::Super => true,
        ExpressionKind::Dereference(inner) | ExpressionKind::Parenthesized(inner) => is_super(inner),
        _ => false,
    }
}

/// The interface that a variable of this type refers to an implementation of.
pub(super) fn interface_of(data_type: &DataType) -> Option<BlockId> {
    match data_type {
        DataType::Reference(reference) if reference.kind == ReferenceKind::Interface => match reference.target {
            DataType::Instance { block, .. } => Some(block),
            _ => None,
        },
        _ => None,
    }
}

impl Checker<'_> {
    /// The instance that the block works on, as a variable.
    pub(super) fn this(&mut self, span: Span) -> Option<Target> {
        let found = self.names.this().and_then(|block| Some((block, self.names.instance(block)?)));
        let Some((block, structure)) = found else {
            self.report(Problem::P6286, span, "there is no THIS here: this block has no instance");
            return None;
        };
        Some(Target {
            place: Place { base: Base::Instance, offset: 0, indexes: Vec::new(), span },
            data_type: DataType::Instance { block, structure },
            role: Role::Static,
            name: "THIS".to_owned(),
            through: Through::Itself,
        })
    }

    /// The block that the one extends whose instance is worked on.
    fn base(&mut self, span: Span) -> Option<BlockId> {
        let this = self.this(span)?;
        let DataType::Instance { block, .. } = this.data_type else { return None };
        let base = self.names.objects().get(block).and_then(|object| object.base);
        if base.is_none() {
            let message = format!("there is no SUPER here: `{}` extends nothing", self.names.block_name(block));
            self.report(Problem::P6286, span, message);
        }
        base
    }

    /// `SUPER^()`: the statements of the base on the own instance.
    pub(super) fn called_super(&mut self, span: Span) -> Called {
        let Some((base, target)) = self.base(span).and_then(|base| Some((base, self.this(span)?))) else { return Called::Nothing };
        Called::Instance(base, target, None)
    }

    /// `THIS^.x`: what the instance has, whatever the method declares.
    pub(super) fn field_of_this(&mut self, name: &Name, span: Span) -> Option<Reached> {
        let entity = self.names.of_instance(&name.text)?;
        if !self.may_see(&entity, name) {
            return Some(Reached::Other(Typed::Poison));
        }
        Some(self.entity(entity, &Name { span, ..name.clone() }))
    }

    /// `SUPER^.x`: a variable that the block has from its base.
    pub(super) fn field_of_base(&mut self, name: &Name, span: Span) -> Option<Reached> {
        let base = self.names.objects().get(self.names.this()?)?.base?;
        self.names.instance(base)?.field(&name.text)?;
        self.field_of_this(name, span)
    }

    /// Whether a variable that the block has from another one may be used in it; else that is said.
    pub(super) fn may_see(&mut self, entity: &Entity, name: &Name) -> bool {
        let (Entity::Variable(variable), Some(this)) = (entity, self.names.this()) else { return true };
        let extends = self.names.objects().get(this).is_some_and(|object| object.base.is_some());
        if !extends || !entity.is_of_instance() {
            return true;
        }
        let Some((of, access)) = self.names.access_of(this, &name.text).filter(|(of, _)| *of != this) else { return true };
        let (word, who) = match access {
            Some(Access::Private) => ("PRIVATE", "only the block itself uses it"),
            Some(Access::Internal)
                if self.names.objects().get(of).is_some_and(|object| object.namespace.as_str() != self.names.namespace()) =>
            {
                ("INTERNAL", "only its namespace uses it")
            }
            _ => return true,
        };
        let (message, declared) = (format!("`{}` of `{}` is {word}: {who}", variable.name, self.names.block_name(of)), variable.span);
        self.report(Problem::P6284, name.span, message).related.push((declared, "declared here".to_owned()));
        false
    }

    /// The instance that a variable is or refers to.
    fn owner_of(&self, target: &Target) -> Option<Owner> {
        match &target.data_type {
            DataType::Instance { block, .. } => {
                let whole = target.place.offset == 0 && target.place.indexes.is_empty();
                let this = target.place.base == Base::Instance && whole;
                let passed = matches!(target.place.base, Base::ComplexParameter(_) | Base::InstancePointer(_)) && whole;
                let referred = matches!(target.place.base, Base::Reference(_)) && whole;
                Some(Owner { block: *block, place: target.place.clone(), open: this || passed || referred })
            }
            reference => {
                let block = interface_of(reference)?;
                let pointer = Value { kind: ValueKind::Load(target.place.clone()), scalar: Scalar::U64, span: target.place.span };
                Some(Owner { block, place: referred(pointer, target.place.span), open: true })
            }
        }
    }

    /// The own instance as what its base sees of it, for `SUPER^.M`.
    fn owner_super(&mut self, span: Span) -> Option<Owner> {
        let block = self.base(span)?;
        let place = Place { base: Base::Instance, offset: 0, indexes: Vec::new(), span };
        Some(Owner { block, place, open: false })
    }

    /// The instance that stands in front of a point, as far as it was looked at.
    pub(super) fn owner_of_reached(&self, reached: &Reached, span: Span) -> Option<Owner> {
        match reached {
            Reached::Target(target) => self.owner_of(target),
            Reached::Other(Typed::Scalar { value, data_type }) => {
                let block = interface_of(data_type)?;
                Some(Owner { block, place: referred(value.clone(), span), open: true })
            }
            Reached::Other(_) => None,
        }
    }

    /// A member of an instance that has no field of the name.
    pub(super) fn member_in(&self, owner: Owner, name: &str, kind: MemberKind) -> Option<Used> {
        if self.names.instance(owner.block).is_some_and(|structure| structure.field(name).is_some()) {
            return None;
        }
        let member = self.names.objects().member(owner.block, name, kind)?.clone();
        Some(Used { member, owner })
    }

    /// A member of the own instance by its name alone, unless the method or the block declares the name.
    pub(super) fn own_member(&self, name: &Name, kind: MemberKind) -> Option<Used> {
        let block = self.names.this()?;
        let member = self.names.objects().member(block, &name.text, kind)?.clone();
        let hidden = match self.names.local(&name.text) {
            None => false,
            // The name of the method itself is its result; with brackets it is a call.
            Some(Entity::Variable(variable)) => !(kind == MemberKind::Method && variable.role == Role::Result),
            Some(_) => true,
        };
        let place = Place { base: Base::Instance, offset: 0, indexes: Vec::new(), span: name.span };
        (!hidden).then_some(Used { member, owner: Owner { block, place, open: true } })
    }

    /// A member that the base has, for `SUPER^.M`; what is wrong is said.
    pub(super) fn super_member(&mut self, name: &Name, kind: MemberKind, span: Span) -> Option<Used> {
        let owner = self.owner_super(span)?;
        let block = owner.block;
        let found = self.names.objects().member(block, &name.text, kind).cloned();
        if found.is_none() {
            self.no_member(block, name);
        }
        Some(Used { member: found?, owner })
    }

    /// Whether the member may be used here; else that is said.
    fn may_use(&mut self, member: &Member, span: Span) -> bool {
        let objects = self.names.objects();
        let this = self.names.this();
        let allowed = match member.access {
            Access::Public => true,
            Access::Private => this == Some(member.of),
            Access::Protected => this.is_some_and(|this| objects.is_a(this, member.of)),
            Access::Internal => {
                let of = objects.get(member.of).map(|object| object.namespace.as_str());
                of == Some(self.names.namespace())
            }
        };
        if !allowed {
            let (word, who) = match member.access {
                Access::Private => ("PRIVATE", "only the block itself uses it"),
                Access::Protected => ("PROTECTED", "only the block itself and those that extend it use it"),
                _ => ("INTERNAL", "only its namespace uses it"),
            };
            let message = format!("`{}` of `{}` is {word}: {who}", member.name, self.names.block_name(member.of));
            self.report(Problem::P6284, span, message).related.push((member.span, "declared here".to_owned()));
        }
        allowed
    }

    /// The callee of a call of a member.
    fn callee(&mut self, used: Used, span: Span) -> Option<Callee> {
        let Used { member, owner } = used;
        if !self.may_use(&member, span) {
            return None;
        }
        let dispatch = match owner.open {
            true => self.names.objects().dispatch(owner.block, &member),
            false => None,
        };
        if dispatch.is_none() && member.is_abstract {
            let message = format!("`{}` of `{}` is ABSTRACT: there is nothing to call", member.name, self.names.block_name(member.of));
            self.report(Problem::P6284, span, message).related.push((member.span, "declared here".to_owned()));
            return None;
        }
        Some(Callee::Method { block: member.function, instance: owner.place, dispatch })
    }

    /// A method as what is called.
    pub(super) fn called_method(&mut self, used: Used, span: Span) -> Called {
        let function = used.member.function;
        match self.callee(used, span) {
            Some(callee) => Called::Method(function, callee),
            None => Called::Nothing,
        }
    }

    /// Says that an instance has no such member.
    pub(super) fn no_member(&mut self, block: BlockId, name: &Name) {
        let objects = self.names.objects();
        if objects.lacks_base(block) {
            self.failed = true;
            return;
        }
        let blocks = std::iter::once(block).chain(objects.above(block));
        let members = blocks.filter_map(|block| objects.get(block)).flat_map(|object| object.members.values());
        let near = nearest(&name.text, members.map(|member| member.name.as_str()));
        let message = format!("`{}` has no method `{}`", self.names.block_name(block), name.text);
        let diagnostic = self.report(Problem::P6217, name.span, message);
        if let Some(near) = near {
            *diagnostic = diagnostic.clone().guess(name.span, near.clone(), format!("write `{near}`"));
        }
    }

    /// Whether a block, or one that it extends, has members.
    pub(super) fn has_members(&self, block: BlockId) -> bool {
        let objects = self.names.objects();
        let has = |block: BlockId| objects.get(block).is_some_and(|object| !object.members.is_empty());
        has(block) || objects.above(block).into_iter().any(has)
    }

    /// What a property of an instance holds: its GET is called. `None` if the instance has no such property.
    pub(super) fn property_in(&mut self, reached: &Reached, name: &Name, span: Span) -> Option<Typed> {
        if self.names.objects().is_without_members() {
            return None;
        }
        if let Some(used) = self.owner_of_reached(reached, span).and_then(|owner| self.member_in(owner, &name.text, MemberKind::Get)) {
            return Some(self.get(used, span));
        }
        let set = self.owner_of_reached(reached, span).and_then(|owner| self.member_in(owner, &name.text, MemberKind::Set))?;
        Some(self.no_get(&set, span))
    }

    /// What a property of the own instance holds.
    pub(super) fn own_property(&mut self, name: &Name, span: Span) -> Option<Typed> {
        if let Some(used) = self.own_member(name, MemberKind::Get) {
            return Some(self.get(used, span));
        }
        let set = self.own_member(name, MemberKind::Set)?;
        Some(self.no_get(&set, span))
    }

    /// What a property of the base holds.
    pub(super) fn super_property(&mut self, name: &Name, span: Span) -> Typed {
        match self.super_member(name, MemberKind::Get, span) {
            Some(used) => self.get(used, span),
            None => Typed::Poison,
        }
    }

    fn no_get(&mut self, set: &Used, span: Span) -> Typed {
        let message = format!("the property `{}` has no GET and cannot be read", set.member.name);
        self.report(Problem::P6287, span, message).related.push((set.member.span, "declared here".to_owned()));
        Typed::Poison
    }

    fn get(&mut self, used: Used, span: Span) -> Typed {
        let function = used.member.function;
        let Some(callee) = self.callee(used, span) else { return Typed::Poison };
        let Some(interface) = self.interface(function, span) else { return Typed::Poison };
        let call = ast::Call { callee: Expression { kind: ExpressionKind::Missing, span }, arguments: Vec::new() };
        match self.arguments(callee, &interface, &call, span) {
            Some((call, before)) => self.result_of(call, before, span),
            None => Typed::Poison,
        }
    }

    /// `property := value`: its SET is called. `None` if the target is no property.
    pub(super) fn assign_property(&mut self, target: &Expression, value: &Expression, span: Span) -> Option<Option<StatementKind>> {
        if self.names.objects().is_without_members() {
            return None;
        }
        let found = |checker: &mut Self, kind| match &target.kind {
            ExpressionKind::Name(name) => checker.own_member(name, kind),
            ExpressionKind::Member(base, name) if is_super(base) => checker.quietly(|checker| checker.super_member(name, kind, base.span)),
            ExpressionKind::Member(base, name) => {
                let reached = checker.quietly(|checker| {
                    let reached = checker.reach(base);
                    checker.of_program_instance(reached, base.span)
                });
                let owner = checker.owner_of_reached(&reached, base.span)?;
                checker.member_in(owner, &name.text, kind)
            }
            _ => None,
        };
        let Some(used) = found(self, MemberKind::Set) else {
            let get = found(self, MemberKind::Get)?;
            let message = format!("the property `{}` has no SET and cannot be assigned to", get.member.name);
            self.report(Problem::P6287, target.span, message).related.push((get.member.span, "declared here".to_owned()));
            self.expression(value);
            return Some(None);
        };
        let function = used.member.function;
        let argument = ast::Argument { name: None, direction: ast::Direction::Assigned, value: Some(value.clone()), span: value.span };
        let call = ast::Call { callee: target.clone(), arguments: vec![argument] };
        let Some(callee) = self.callee(used, target.span) else { return Some(None) };
        let Some(interface) = self.interface(function, target.span) else { return Some(None) };
        let Some((call, mut before)) = self.arguments(callee, &interface, &call, span) else { return Some(None) };
        if before.is_empty() {
            return Some(Some(StatementKind::Call(call)));
        }
        before.push(Statement { kind: StatementKind::Call(call), span });
        Some(Some(StatementKind::Block(before)))
    }

    /// Whether the block is a class or an interface, which have no statements to call; that is said.
    pub(super) fn without_body(&mut self, block: BlockId, span: Span) -> bool {
        let Some(object) = self.names.objects().get(block) else { return false };
        let what = match object.kind {
            BlockKind::Class => "a CLASS",
            BlockKind::Interface => "an INTERFACE",
            _ => return false,
        };
        let message = format!("`{}` is {what} and has no statements of its own to call", object.name);
        self.report(Problem::P6217, span, message).help = Some("Call one of its methods, `inst.Method()`.".to_owned());
        true
    }

    /// An instance, or a reference to one, where a reference to something that it extends or implements is wanted.
    #[allow(clippy::result_large_err)] // What is no reference goes on to the other conversions.
    pub(super) fn upwards(&mut self, typed: Typed, span: Span, wanted: &DataType) -> Result<Value, Typed> {
        let DataType::Reference(reference) = wanted else { return Err(typed) };
        let DataType::Instance { block: upper, .. } = reference.target else { return Err(typed) };
        let fits = |data_type: &DataType| matches!(data_type, DataType::Instance { block, .. } if self.names.objects().is_a(*block, upper));
        match typed {
            Typed::Aggregate(target) if fits(&target.data_type) => {
                let this = target.place.base == Base::Instance && target.name == "THIS";
                if reference.kind == ReferenceKind::Interface || this {
                    return Ok(Value { kind: ValueKind::AddressOf(target.place), scalar: Scalar::U64, span });
                }
                Err(Typed::Aggregate(target))
            }
            Typed::Scalar { value, data_type: DataType::Reference(from) } if fits(&from.target) => Ok(value),
            // What it implements is not known.
            Typed::Aggregate(Target { data_type: DataType::Instance { block, .. }, .. }) if self.names.objects().lacks_base(block) => {
                self.failed = true;
                Err(Typed::Poison)
            }
            other => Err(other),
        }
    }

    /// `target ?= source`: the reference if what it refers to is of the wanted block, else NULL.
    pub(super) fn attempt(&mut self, target: &Expression, source: &Expression, span: Span) -> Option<StatementKind> {
        let to = self.target(target)?;
        let typed = self.expression(source);
        let (value, from) = match typed {
            Typed::Poison => return None,
            Typed::Scalar { value: value @ Value { kind: ValueKind::Load(_), .. }, data_type } => (value, refers(&data_type)),
            _ => {
                let message = "`?=` takes a variable that is a reference or an interface";
                self.report(Problem::P6200, source.span, message);
                return None;
            }
        };
        self.attempted(to, value, from, span)
    }

    /// The same for a reference that is known to refer to a block.
    pub(super) fn attempted(&mut self, to: Target, value: Value, from: Option<BlockId>, span: Span) -> Option<StatementKind> {
        let (Some(from), Some(wanted)) = (from, refers(&to.data_type)) else {
            let message = "`?=` is for references to blocks and for interfaces";
            self.report(Problem::P6200, span, message).help = Some("Write `:=`.".to_owned());
            return None;
        };
        let objects = self.names.objects();
        if objects.is_a(from, wanted) {
            return Some(StatementKind::Assign { target: to.place, value });
        }
        let numbers: Vec<u16> = objects.concrete(wanted).filter(|&one| objects.is_a(one, from)).map(|one| one.number).collect();
        if numbers.is_empty() {
            let message = format!("nothing is both `{}` and `{}`", self.names.block_name(from), self.names.block_name(wanted));
            self.report(Problem::P6200, span, message);
            return None;
        }
        let word = |kind, scalar| Value { kind, scalar, span };
        let equal = |a: Value, number: u64, scalar| {
            word(ValueKind::Compute { op: Op::Equal, args: vec![a, word(ValueKind::Constant(number), scalar)] }, Scalar::Bool)
        };
        let of = || word(ValueKind::Load(referred(value.clone(), span)), Scalar::U16);
        let mut is = word(ValueKind::Constant(0), Scalar::Bool);
        for number in numbers {
            is = word(ValueKind::OrElse(Box::new(equal(of(), u64::from(number), Scalar::U16)), Box::new(is)), Scalar::Bool);
        }
        let null = equal(value.clone(), 0, Scalar::U64);
        let there = word(ValueKind::Compute { op: Op::Not, args: vec![null] }, Scalar::Bool);
        let condition = Box::new(word(ValueKind::AndThen(Box::new(there), Box::new(is)), Scalar::Bool));
        let (a, b) = (Box::new(value.clone()), Box::new(word(ValueKind::Constant(0), Scalar::U64)));
        let value = word(ValueKind::Choose { condition, a, b }, Scalar::U64);
        Some(StatementKind::Assign { target: to.place, value })
    }
}
