//! VARIANT: what a call tells of it, TypeOf, IS_ARRAY, VariantGet and their kin, which ask at run time what was given.

use std::sync::Arc;

use sieben_engine::ir::Op;
use sieben_model::block::BlockKind;
use sieben_model::interface::{Interface, Variable};
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, Reference, ReferenceKind, STRING_LENGTH_MAX, Structure};

use super::Checker;
use super::expressions::same_type;
use super::memory::{Part, number, two};
use super::names::Entity;
use super::operators::convert;
use super::places::{Reached, referred};
use super::typed::{Target, Typed};
use crate::st::ast::{self, BinaryOperator, CaseArm, CaseLabel, Expression, ExpressionKind};
use crate::st::standard::build::compute;
use crate::st::standard::operators::Operation;
use crate::st::tree::{Argument, Place, Scalar, Statement, StatementKind, Value, ValueKind};
use crate::st::type_class::{self, class_of};
use crate::st::variants::{self, Told, told_name, type_number};

/// Where the number of the data block and the pointer lie in an ANY, in bits.
const NUMBER_AT: u32 = 32;
const POINTER_AT: u32 = 48;

/// A variable whose type is asked at run time.
pub(super) struct Described {
    /// The number of its type, of an array that of its elements, as U64.
    pub(super) type_number: Value,
    /// How many elements it has, as U32; 0 = it is no array.
    pub(super) count: Value,
    /// The variable itself: with [`DataType::Any`] the VARIANT.
    target: Target,
    /// Where it lies.
    place: Place,
}

impl Described {
    /// Whether the type is known only at run time.
    pub(super) fn is_variant(&self) -> bool {
        self.target.data_type == DataType::Any
    }

    /// How many bits an element has, as U64; 0 of texts.
    pub(super) fn bits(&self, span: Span) -> Value {
        let low = number(0xFFFF_FFFF, Scalar::U64, span);
        compute(Op::AndU64, vec![self.type_number.clone(), low], Scalar::U64, span)
    }

    /// A part of it as if it were an array of such elements, of which `size` make one of its own.
    pub(super) fn part(&self, element: &DataType, first: Value, size: &Value, span: Span) -> Part {
        let count = two(Operation::Multiply, convert(self.count.clone(), Scalar::I64), size.clone(), span);
        let high = two(Operation::Subtract, count, number(1, Scalar::I64, span), span);
        Part { place: self.place.clone(), element: element.clone(), first, bounds: [number(0, Scalar::I64, span), high] }
    }

    /// What it is if it has this type.
    fn as_type(&self, data_type: &DataType) -> Target {
        let data_type = match data_type {
            DataType::String(_) => DataType::String(STRING_LENGTH_MAX),
            DataType::WideString(_) => DataType::WideString(u16::from(STRING_LENGTH_MAX)),
            other => other.clone(),
        };
        match self.is_variant() {
            true => Target { place: self.place.clone(), data_type, ..self.target.clone() },
            false => self.target.clone(),
        }
    }
}

/// One side of a comparison of types.
struct Side {
    type_number: Value,
    /// `None` if it does not matter whether it is an array.
    count: Option<Value>,
}

impl Checker<'_> {
    /// What a call tells of the VARIANT that it just gave to a parameter; whether that is known.
    pub(super) fn tell(&mut self, interface: &Interface, formal: &Variable, given: &Expression, arguments: &mut Vec<Argument>) -> bool {
        let told = Told::BOTH.map(|told| interface.variable(&told_name(&formal.name, told)));
        let [Some(of_type), Some(of_count)] = told else { return true };
        let Some(Argument::Pointer { place, data_type, .. }) = arguments.last() else { return true };
        let span = given.span;
        let found = match data_type {
            DataType::Any => {
                let name = match self.quietly(|checker| checker.reach(given)) {
                    Reached::Target(target) => target.name,
                    Reached::Other(_) => String::new(),
                };
                match self.told_of(&name, span) {
                    Some(found) => found,
                    None => {
                        self.any_is_no_variant(&name, span);
                        return false;
                    }
                }
            }
            known if self.dialect.has_pointers() => {
                let bytes = known.bits_used().div_ceil(8).min(u64::from(u32::MAX));
                let class = u64::from(class_of(known)) << 32 | bytes;
                [number(class as i64, Scalar::U64, place.span), number(0, Scalar::U32, place.span)]
            }
            known => constants(known, place.span),
        };
        for (formal, value) in [of_type, of_count].into_iter().zip(found) {
            arguments.push(Argument::Value { parameter: formal.offset, value });
        }
        true
    }

    fn any_is_no_variant(&mut self, name: &str, span: Span) {
        let message = format!("`{name}` is an ANY, and of what it points to only the number of bytes is known");
        self.report(Problem::P6324, span, message).help =
            Some("Declare it as VARIANT in VAR_INPUT or VAR_IN_OUT, or use the variable itself.".to_owned());
    }

    /// What the caller told of a VARIANT of the block.
    fn told_of(&self, variant: &str, span: Span) -> Option<[Value; 2]> {
        let read = |told: Told, scalar: Scalar| {
            let Some(Entity::Variable(variable)) = self.names.local(&told_name(variant, told)) else { return None };
            let place = Place { base: variable.base, offset: variable.offset, indexes: Vec::new(), span };
            Some(Value { kind: ValueKind::Load(place), scalar, span })
        };
        Some([read(Told::Type, Scalar::U64)?, read(Told::Count, Scalar::U32)?])
    }

    /// TypeClass, diSize and pValue of an ANY in codesys; `None` for other names, and for an ANY that no call gave.
    pub(super) fn of_any(&mut self, any: &Target, name: &ast::Name, span: Span) -> Option<Typed> {
        if any.data_type != DataType::Any || !self.dialect.has_pointers() {
            return None;
        }
        let [told, _] = self.told_of(&any.name, span)?;
        let scalar = |value: Value, data_type: DataType| Some(Typed::Scalar { value: Value { span, ..value }, data_type });
        match () {
            () if name.is("TypeClass") => {
                let class = compute(Op::Shr64, vec![told, number(32, Scalar::U32, span)], Scalar::U64, span);
                scalar(convert(class, Scalar::I16), type_class::data_type())
            }
            () if name.is("diSize") => {
                let bytes = compute(Op::AndU64, vec![told, number(0xFFFF_FFFF, Scalar::U64, span)], Scalar::U64, span);
                scalar(convert(bytes, Scalar::I32), DataType::DoubleInt)
            }
            () if name.is("pValue") => {
                let byte = Reference { target: DataType::Byte, kind: ReferenceKind::Pointer };
                scalar(pointer_of_any(&any.place, span), DataType::Reference(Arc::new(byte)))
            }
            () => None,
        }
    }

    /// Whether an expression is a VARIANT of the block.
    pub(super) fn is_variant_parameter(&mut self, expression: &Expression) -> bool {
        match self.quietly(|checker| checker.reach(expression)) {
            Reached::Target(target) => target.data_type == DataType::Any,
            Reached::Other(_) => false,
        }
    }

    /// A variable, or a VARIANT, of which a function wants to know the type.
    pub(super) fn described(&mut self, function: &str, expression: &Expression) -> Option<Described> {
        let span = expression.span;
        let target = match self.reach(expression) {
            Reached::Target(target) => target,
            Reached::Other(Typed::Poison) => return None,
            Reached::Other(Typed::Block(block)) if block.kind == BlockKind::DataBlock => self.data_block(block, span)?,
            Reached::Other(other) => {
                let what = self.what(&other);
                self.report(Problem::P4011, span, format!("`{function}` takes a VARIANT or a variable, not {what}"));
                return None;
            }
        };
        if !self.is_whole(&target) {
            return None;
        }
        if target.data_type != DataType::Any {
            let [type_number, count] = constants(&target.data_type, span);
            return Some(Described { type_number, count, place: target.place.clone(), target });
        }
        let Some([type_number, count]) = self.told_of(&target.name, span) else {
            self.any_is_no_variant(&target.name, span);
            return None;
        };
        let pointer = pointer_of_any(&target.place, span);
        Some(Described { type_number, count, place: referred(pointer, span), target })
    }

    /// IS_ARRAY, IS_NULL, NOT_NULL.
    pub(super) fn variant_question(&mut self, function: &str, call: &ast::Call, span: Span) -> Option<Typed> {
        let [ast::Argument { value: Some(given), .. }] = call.arguments.as_slice() else {
            self.look_at(&call.arguments);
            self.report(Problem::P6219, span, format!("`{function}` takes one parameter, a VARIANT"));
            return None;
        };
        let described = self.described(function, given)?;
        let (op, value) = match function {
            "IS_ARRAY" => (Op::Differ, described.count),
            "IS_NULL" => (Op::Equal, described.type_number),
            _ => (Op::Differ, described.type_number),
        };
        let none = number(0, value.scalar, span);
        Some(Typed::Scalar { value: compute(op, vec![value, none], Scalar::Bool, span), data_type: DataType::Bool })
    }

    /// VariantGet: the value of a VARIANT to a variable of its type.
    pub(super) fn variant_get(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let given = self.named("VariantGet", call, &["SRC", "DST"], span)?;
        let source = self.described("VariantGet", given[0])?;
        let target = self.target(given[1])?;
        self.moved_if_same("VariantGet", (&source, given[0].span), (target, given[1].span), true, span)
    }

    /// VariantPut: the other way.
    pub(super) fn variant_put(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let given = self.named("VariantPut", call, &["SRC", "DST"], span)?;
        let target = self.described("VariantPut", given[1])?;
        let source = match self.reach(given[0]) {
            Reached::Target(source) => source,
            Reached::Other(Typed::Poison) => return None,
            Reached::Other(other) => return self.is_no_variable("VariantPut", &other, given[0].span),
        };
        self.moved_if_same("VariantPut", (&target, given[1].span), (source, given[0].span), false, span)
    }

    /// Moves a value between a VARIANT and a variable if they are of one type; else ENO is FALSE.
    fn moved_if_same(
        &mut self,
        function: &str,
        (variant, at): (&Described, Span),
        (variable, variable_at): (Target, Span),
        get: bool,
        span: Span,
    ) -> Option<StatementKind> {
        if !self.is_whole(&variable) {
            return None;
        }
        if variable.data_type == DataType::Any {
            let message = format!("`{function}` moves a value, and what `{}` is, only its caller knows", variable.name);
            self.report(Problem::P6324, variable_at, message).help =
                Some("Give a variable of the type that is expected; TypeOf tells which one it is.".to_owned());
            return None;
        }
        if !variant.is_variant() && !same_type(&variant.target.data_type, &variable.data_type) {
            let (one, other) = (self.words(&variant.target.data_type), self.words(&variable.data_type));
            let message = format!("`{}` is {one}, and `{}` is {other}", variant.target.name, variable.name);
            self.report(Problem::P4011, at, message).help = Some(format!("`{function}` moves values of one type."));
            return None;
        }
        let [type_number, count] = constants(&variable.data_type, span);
        let equal = |a: &Value, b: Value| compute(Op::Equal, vec![a.clone(), b], Scalar::Bool, span);
        let same = compute(Op::And, vec![equal(&variant.type_number, type_number), equal(&variant.count, count)], Scalar::Bool, span);
        let other = variant.as_type(&variable.data_type);
        let (source, target) = if get { (other, variable) } else { (variable, other) };
        let typed = self.load(source);
        let kind = self.store(target, typed, variable_at, span)?;
        Some(StatementKind::If { branches: vec![(same, vec![Statement { kind, span }])], otherwise: self.not_ok(span) })
    }

    /// A part of the array that a VARIANT is, beside one whose elements are known.
    pub(super) fn part_of_variant(&self, variant: &Described, element: &DataType, index: Value, span: Span) -> Part {
        let count = convert(variant.count.clone(), Scalar::I64);
        let same = compute(
            Op::Equal,
            vec![variant.type_number.clone(), number(type_number(element) as i64, Scalar::U64, span)],
            Scalar::Bool,
            span,
        );
        // An array of other elements has none of these.
        let kind = ValueKind::Choose { condition: Box::new(same), a: Box::new(count), b: Box::new(number(0, Scalar::I64, span)) };
        let count = Value { kind, scalar: Scalar::I64, span };
        let high = two(Operation::Subtract, count, number(1, Scalar::I64, span), span);
        Part { place: variant.place.clone(), element: element.clone(), first: index, bounds: [number(0, Scalar::I64, span), high] }
    }

    /// Whether an expression asks for a type: TypeOf, TypeOfElements.
    pub(super) fn asks_for_type<'e>(&self, expression: &'e Expression) -> Option<(&'static str, &'e ast::Call)> {
        if !self.has_memory_functions() {
            return None;
        }
        match &expression.kind {
            ExpressionKind::Parenthesized(inner) => self.asks_for_type(inner),
            ExpressionKind::Call(call) => {
                let ExpressionKind::Name(name) = &call.callee.kind else { return None };
                let function = ["TypeOf", "TypeOfElements"].into_iter().find(|function| name.is(function))?;
                self.names.global(&name.text).is_none().then_some((function, &**call))
            }
            _ => None,
        }
    }

    /// `TypeOf(a) = INT`, `TypeOf(a) = TypeOf(b)`.
    pub(super) fn compared_types(&mut self, operator: BinaryOperator, left: &Expression, right: &Expression) -> Option<Typed> {
        let span = left.span.to(right.span);
        let [a, b] = [left, right].map(|side| self.type_side(side));
        let (a, b) = (a?, b?);
        let op = match operator {
            BinaryOperator::Equal => Op::Equal,
            BinaryOperator::NotEqual => Op::Differ,
            other => {
                let message = format!("`{}` takes values, and a type is none", other.sign());
                self.report(Problem::P6325, span, message).help = Some("Write `TypeOf(v) = INT` or `TypeOf(v) <> INT`.".to_owned());
                return None;
            }
        };
        let equal = same_types(a, b, span);
        let value = match op {
            Op::Equal => equal,
            _ => compute(Op::Not, vec![equal], Scalar::Bool, span),
        };
        Some(Typed::Scalar { value, data_type: DataType::Bool })
    }

    /// CASE of TypeOf: IF and ELSIF.
    pub(super) fn case_of_type(&mut self, selector: &Expression, arms: &[CaseArm], otherwise: &[ast::Statement]) -> Option<StatementKind> {
        let asked = self.type_side(selector);
        let mut sound = asked.is_some();
        let mut branches = Vec::with_capacity(arms.len());
        for arm in arms {
            let mut condition: Option<Value> = None;
            for label in &arm.labels {
                let CaseLabel::Value(value) = label else {
                    self.report(Problem::P6325, label.span(), "types have no order, so that there is no range of them");
                    sound = false;
                    continue;
                };
                let (Some(asked), Some(wanted)) = (&asked, self.type_side(value)) else {
                    sound = false;
                    continue;
                };
                let asked = Side { type_number: asked.type_number.clone(), count: asked.count.clone() };
                let equal = same_types(asked, wanted, label.span());
                condition = Some(match condition {
                    Some(before) => compute(Op::Or, vec![before, equal], Scalar::Bool, label.span()),
                    None => equal,
                });
            }
            let body = self.statements(&arm.body);
            branches.extend(condition.map(|condition| (condition, body)));
        }
        let otherwise = self.statements(otherwise);
        sound.then_some(StatementKind::If { branches, otherwise })
    }

    fn type_side(&mut self, expression: &Expression) -> Option<Side> {
        let span = expression.span;
        if let Some((function, call)) = self.asks_for_type(expression) {
            let [ast::Argument { value: Some(given), .. }] = call.arguments.as_slice() else {
                self.look_at(&call.arguments);
                self.report(Problem::P6219, span, format!("`{function}` takes one parameter, a VARIANT"));
                return None;
            };
            let described = self.described(function, given)?;
            let count = (function == "TypeOf").then_some(described.count);
            return Some(Side { type_number: described.type_number, count });
        }
        let data_type = match self.reach(expression) {
            Reached::Other(Typed::Type(data_type)) => data_type,
            Reached::Other(Typed::Block(block)) if block.kind == BlockKind::FunctionBlock => {
                DataType::Instance { block, structure: std::sync::Arc::new(Structure::default()) }
            }
            Reached::Other(Typed::Poison) => return None,
            _ => {
                let help = "Write the name of a type, `TypeOf(v) = INT` or `TypeOf(v) = \"Recipe\"`, or another TypeOf.";
                self.report(Problem::P6325, span, "a type is compared with a type").help = Some(help.to_owned());
                return None;
            }
        };
        let [type_number, count] = constants(&data_type, span);
        Some(Side { type_number, count: Some(count) })
    }
}

/// The pointer in an ANY.
fn pointer_of_any(any: &Place, span: Span) -> Value {
    let load = |at: u32, scalar: Scalar| {
        let place = Place { base: any.base.clone(), offset: any.offset + at, indexes: Vec::new(), span };
        convert(Value { kind: ValueKind::Load(place), scalar, span }, Scalar::U64)
    };
    let block = compute(Op::Shl64, vec![load(NUMBER_AT, Scalar::U16), number(32, Scalar::U32, span)], Scalar::U64, span);
    compute(Op::OrU64, vec![block, load(POINTER_AT, Scalar::U32)], Scalar::U64, span)
}

/// Whether two types are the same one.
fn same_types(a: Side, b: Side, span: Span) -> Value {
    let equal = compute(Op::Equal, vec![a.type_number, b.type_number], Scalar::Bool, span);
    match (a.count, b.count) {
        (Some(x), Some(y)) => {
            let counts = compute(Op::Equal, vec![x, y], Scalar::Bool, span);
            compute(Op::And, vec![equal, counts], Scalar::Bool, span)
        }
        _ => equal,
    }
}

/// The number of a type and of its elements, which are known.
fn constants(data_type: &DataType, span: Span) -> [Value; 2] {
    let (element, count) = variants::elements(data_type);
    [number(type_number(element) as i64, Scalar::U64, span), number(i64::from(count), Scalar::U32, span)]
}
