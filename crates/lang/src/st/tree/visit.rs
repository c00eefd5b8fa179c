//! One walk through the typed tree, in the order of the source: a visitor overrides the steps that it is about.

use sieben_model::types::DataType;

use super::{Argument, Base, Call, Place, Scalar, Statement, StatementKind, Text, TextRoom, Value, ValueKind};

/// What is done with a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Use {
    /// Its value is read.
    Read,
    /// It gets a value.
    Write,
    /// Both.
    ReadWrite,
    /// Its address is taken.
    Address,
    /// A called block works on it as its instance.
    Instance,
}

/// How much of a place is used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent<'t> {
    /// A scalar.
    Scalar(Scalar),
    /// A text.
    Text(TextRoom),
    /// Bytes of an array or a structure.
    Bytes(u32),
    /// A value of a type.
    Type(&'t DataType),
    /// From there on; how far is not known.
    Unknown,
}

/// A visitor of the tree. Each step goes on into what belongs to it, unless it is overridden; an overriding one may do the same with the function of this module that has its name.
pub trait Visit<'t> {
    /// A statement of a body.
    fn statement(&mut self, statement: &'t Statement) {
        self::statement(self, statement);
    }

    /// A statement that a value or a text needs before it: the source does not have it as a statement.
    fn step(&mut self, statement: &'t Statement) {
        self.statement(statement);
    }

    /// A value.
    fn value(&mut self, value: &'t Value) {
        self::value(self, value);
    }

    /// A text.
    fn text(&mut self, text: &'t Text) {
        self::text(self, text);
    }

    /// A call.
    fn call(&mut self, call: &'t Call) {
        self::call(self, call);
    }

    /// An actual parameter.
    fn argument(&mut self, argument: &'t Argument) {
        self::argument(self, argument);
    }

    /// A place that is used.
    fn place(&mut self, place: &'t Place, how: Use, extent: Extent<'t>) {
        let _ = (how, extent);
        base(self, place);
        indexes(self, place);
    }
}

/// The statements of a body, one after another.
pub fn statements<'t>(visit: &mut (impl Visit<'t> + ?Sized), statements: &'t [Statement]) {
    statements.iter().for_each(|statement| visit.statement(statement));
}

/// What belongs to a statement.
pub fn statement<'t>(visit: &mut (impl Visit<'t> + ?Sized), statement: &'t Statement) {
    match &statement.kind {
        StatementKind::Assign { target, value } => {
            visit.value(value);
            visit.place(target, Use::Write, Extent::Scalar(value.scalar));
        }
        StatementKind::Copy { target, source, bytes } => {
            visit.place(source, Use::Read, Extent::Bytes(*bytes));
            visit.place(target, Use::Write, Extent::Bytes(*bytes));
        }
        StatementKind::AssignString { target, room, source } => {
            visit.text(source);
            visit.place(target, Use::Write, Extent::Text(*room));
        }
        StatementKind::Call(call) => visit.call(call),
        StatementKind::If { branches, otherwise } => {
            for (condition, body) in branches {
                visit.value(condition);
                statements(visit, body);
            }
            statements(visit, otherwise);
        }
        StatementKind::Case { selector, branches, otherwise } => {
            visit.value(selector);
            branches.iter().for_each(|branch| statements(visit, &branch.body));
            statements(visit, otherwise);
        }
        StatementKind::For(one) => {
            [&one.from, &one.to, &one.by].into_iter().for_each(|value| visit.value(value));
            visit.place(&one.variable, Use::ReadWrite, Extent::Scalar(one.scalar));
            statements(visit, &one.body);
        }
        StatementKind::While { condition, body } => {
            visit.value(condition);
            statements(visit, body);
        }
        StatementKind::Repeat { body, until } => {
            statements(visit, body);
            visit.value(until);
        }
        StatementKind::SetOk(value) => visit.value(value),
        StatementKind::Intrinsic { args, .. } => args.iter().for_each(|value| visit.value(value)),
        StatementKind::Block(body) => statements(visit, body),
        StatementKind::Exit { .. }
        | StatementKind::Continue { .. }
        | StatementKind::Return
        | StatementKind::Label(_)
        | StatementKind::Goto(_) => {}
    }
}

/// What belongs to a value.
pub fn value<'t>(visit: &mut (impl Visit<'t> + ?Sized), value: &'t Value) {
    match &value.kind {
        ValueKind::Load(place) => visit.place(place, Use::Read, Extent::Scalar(value.scalar)),
        ValueKind::AddressOf(place) => visit.place(place, Use::Address, Extent::Unknown),
        ValueKind::Compute { args, .. } | ValueKind::Checked { args, .. } | ValueKind::Intrinsic { args, .. } => {
            args.iter().for_each(|value| visit.value(value));
        }
        ValueKind::AndThen(a, b) | ValueKind::OrElse(a, b) => [a, b].into_iter().for_each(|value| visit.value(value)),
        ValueKind::Choose { condition, a, b } => [condition, a, b].into_iter().for_each(|value| visit.value(value)),
        ValueKind::Call(call) => visit.call(call),
        ValueKind::CompareTexts(a, b) => [a, b].into_iter().for_each(|text| visit.text(text)),
        ValueKind::Length(text) => visit.text(text),
        ValueKind::After(steps, value) => {
            steps.iter().for_each(|statement| visit.step(statement));
            visit.value(value);
        }
        ValueKind::Constant(_) | ValueKind::NumberParameter(_) | ValueKind::Ok | ValueKind::Eno => {}
    }
}

/// What belongs to a text.
pub fn text<'t>(visit: &mut (impl Visit<'t> + ?Sized), text: &'t Text) {
    match text {
        Text::Constant(_) | Text::WideConstant(_) => {}
        Text::Place { place, room } => visit.place(place, Use::Read, Extent::Text(*room)),
        Text::Character(value) => visit.value(value),
        Text::Call { call, .. } => visit.call(call),
        Text::Converted(text) => visit.text(text),
        Text::After(steps, text) => {
            steps.iter().for_each(|statement| visit.step(statement));
            visit.text(text);
        }
    }
}

/// What belongs to a call.
pub fn call<'t>(visit: &mut (impl Visit<'t> + ?Sized), call: &'t Call) {
    call.enable.iter().for_each(|value| visit.value(value));
    if let Some(instance) = call.callee.instance() {
        visit.place(instance, Use::Instance, Extent::Unknown);
    }
    call.arguments.iter().for_each(|argument| visit.argument(argument));
}

/// What belongs to an actual parameter.
pub fn argument<'t>(visit: &mut (impl Visit<'t> + ?Sized), argument: &'t Argument) {
    match argument {
        Argument::Value { value, .. } | Argument::Number { value, .. } => visit.value(value),
        Argument::Text { text, .. } => visit.text(text),
        Argument::Aggregate { source, data_type, .. } => visit.place(source, Use::Read, Extent::Type(data_type)),
        Argument::Output { target, converted, .. } => visit.place(target, Use::Write, Extent::Scalar(*converted)),
        Argument::OutputText { target, target_room, .. } => visit.place(target, Use::Write, Extent::Text(*target_room)),
        Argument::OutputAggregate { target, data_type, .. } => visit.place(target, Use::Write, Extent::Type(data_type)),
        Argument::InOut { place, data_type, .. } => visit.place(place, Use::ReadWrite, Extent::Type(data_type)),
        Argument::Pointer { place, data_type, .. } => visit.place(place, Use::Address, Extent::Type(data_type)),
        Argument::Eno { target } => visit.place(target, Use::Write, Extent::Scalar(Scalar::Bool)),
    }
}

/// What the base of a place is computed from.
pub fn base<'t>(visit: &mut (impl Visit<'t> + ?Sized), place: &'t Place) {
    match &place.base {
        Base::ComputedDataBlock(value) | Base::Reference(value) => visit.value(value),
        Base::Area(_) | Base::DataBlock(_) | Base::Instance | Base::Parameter(_) | Base::ComplexParameter(_) | Base::InstancePointer(_) => {
        }
    }
}

/// The indexes of a place.
pub fn indexes<'t>(visit: &mut (impl Visit<'t> + ?Sized), place: &'t Place) {
    place.indexes.iter().for_each(|index| visit.value(&index.value));
}

#[cfg(test)]
mod tests {
    use sieben_model::address::Area;
    use sieben_model::source::Span;

    use super::*;
    use crate::st::tree::{Bounds, Index};

    /// Every use, as it is come by.
    #[derive(Default)]
    struct Uses(Vec<(u32, Use)>);

    impl<'t> Visit<'t> for Uses {
        fn place(&mut self, place: &'t Place, how: Use, _: Extent<'t>) {
            indexes(self, place);
            self.0.push((place.offset, how));
        }
    }

    fn place(offset: u32) -> Place {
        Place { base: Base::Area(Area::BitMemory), offset, indexes: Vec::new(), span: Span::default() }
    }

    fn load(place: Place) -> Value {
        Value { kind: ValueKind::Load(place), scalar: Scalar::I32, span: Span::default() }
    }

    fn assign(target: Place, value: Value) -> Statement {
        Statement { kind: StatementKind::Assign { target, value }, span: Span::default() }
    }

    #[test]
    fn a_walk_comes_by_every_place_in_the_order_in_which_it_is_used() {
        let index = Index { value: load(place(3)), low: 0, count: 4, step: 8, check: Bounds::Fault };
        let indexed = Place { indexes: vec![index], ..place(4) };
        let step = assign(place(1), load(place(0)));
        let kind = ValueKind::After(vec![step], Box::new(load(place(2))));
        let after = Value { kind, scalar: Scalar::I32, span: Span::default() };
        let body = [Statement { kind: StatementKind::Block(vec![assign(indexed, after)]), span: Span::default() }];
        let mut uses = Uses::default();
        statements(&mut uses, &body);
        assert_eq!(uses.0, [(0, Use::Read), (1, Use::Write), (2, Use::Read), (3, Use::Read), (4, Use::Write)]);
    }
}
