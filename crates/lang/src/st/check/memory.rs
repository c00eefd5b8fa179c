//! Functions of tia on absolute memory and on parts of arrays: PEEK, POKE, MOVE_BLK, FILL_BLK and their kin.

use sieben_engine::ir::Op;
use sieben_model::address::Area;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::Checker;
use super::calls::after;
use super::expressions::same_type;
use super::operators::convert;
use super::places::{Reached, element_step};
use super::typed::{Target, Typed};
use super::types::{Class, Kind};
use crate::scope::nearest;
use crate::st::ast::{self, Expression, ExpressionKind, Name};
use crate::st::dialect::{Construct, Judgement, LostResults};
use crate::st::open_arrays::End;
use crate::st::standard::build::compute;
use crate::st::standard::operators::{Operation, compares, op_for};
use crate::st::tree::{Base, Bounds, For, Index, Place, Scalar, Statement, StatementKind, Text, TextRoom, Value, ValueKind, room_of};

/// What PEEK delivers by its name, in bits.
const PEEKS: &[(&str, u32)] = &[("PEEK", 8), ("PEEK_BYTE", 8), ("PEEK_WORD", 16), ("PEEK_DWORD", 32), ("PEEK_LWORD", 64), ("PEEK_BOOL", 1)];
/// The areas of PEEK and POKE: their number, the process image or memory that they are, and how messages show them.
const AREAS: &[(u64, Option<Area>, &str)] = &[
    (0x81, Some(Area::Input), "16#81 (inputs)"),
    (0x82, Some(Area::Output), "16#82 (outputs)"),
    (0x83, Some(Area::BitMemory), "16#83 (bit memory)"),
    (0x84, None, "16#84 (data block)"),
];

/// Where PEEK and POKE go.
enum Somewhere {
    /// The area is a constant.
    Known(Place),
    /// By the value of the area; what is none of these is nowhere.
    Asked { area: Value, places: Vec<(u64, Place)> },
}

/// A part of an array: its elements from one on.
pub(super) struct Part {
    /// Where the array lies.
    pub(super) place: Place,
    pub(super) element: DataType,
    /// The first element, as I64.
    pub(super) first: Value,
    /// The first and the last index of the array, as I64.
    pub(super) bounds: [Value; 2],
}

/// Elements that go from one array to another one.
pub(super) struct Moved {
    /// Whether all of them are in the source.
    pub(super) fits: Value,
    /// The same, and there is room for all of them in the target.
    pub(super) all_fit: Value,
    /// What moves them.
    pub(super) repeated: Statement,
}

impl Checker<'_> {
    pub(super) fn has_memory_functions(&self) -> bool {
        self.dialect.judge(Construct::PeekPoke) != Judgement::Reject
    }

    /// PEEK and its kin; `None` for other names.
    pub(super) fn peek(&mut self, name: &Name, call: &ast::Call, span: Span) -> Option<Typed> {
        let &(word, bits) = PEEKS.iter().find(|(word, _)| name.is(word)).filter(|_| self.has_memory_functions())?;
        let with_bit = ["area", "dbNumber", "byteOffset", "bitOffset"];
        let parameters = if bits == 1 { &with_bit[..] } else { &with_bit[..3] };
        let Some(given) = self.named(word, call, parameters, span) else { return Some(Typed::Poison) };
        let mut before = Vec::new();
        let place = self.somewhere([given[0], given[1], given[2]], given.get(3).copied(), &mut before, span);
        let Some(place) = place else { return Some(Typed::Poison) };
        let kind = Kind { class: Class::Bits, bits };
        let scalar = kind.scalar(self.dialect);
        let load = |place: Place| Value { kind: ValueKind::Load(place), scalar, span };
        let value = match place {
            Somewhere::Known(place) => load(place),
            Somewhere::Asked { area, places } => places.into_iter().rev().fold(number(0, scalar, span), |otherwise, (code, place)| {
                let condition = compute(Op::Equal, vec![area.clone(), number(code as i64, Scalar::U32, span)], Scalar::Bool, span);
                let kind = ValueKind::Choose { condition: Box::new(condition), a: Box::new(load(place)), b: Box::new(otherwise) };
                Value { kind, scalar, span }
            }),
        };
        Some(Typed::Scalar { value: after(before, value), data_type: kind.data_type() })
    }

    /// POKE, MOVE_BLK, FILL_BLK and their kin; `None` for other names, `Some(None)` if something was wrong.
    pub(super) fn memory_statement(&mut self, name: &Name, call: &ast::Call, span: Span) -> Option<Option<StatementKind>> {
        if !self.has_memory_functions() {
            return None;
        }
        if let Some(done) = self.by_output(name, call, span) {
            return Some(done);
        }
        let upper = name.text.to_ascii_uppercase();
        Some(match upper.as_str() {
            "POKE" => self.poke(call, span),
            "POKE_BOOL" => self.poke_bool(call, span),
            "POKE_BLK" => self.poke_block(call, span),
            "MOVE_BLK" | "UMOVE_BLK" => self.move_block(&upper, call, span),
            "FILL_BLK" | "UFILL_BLK" => self.fill_block(&upper, call, span),
            _ => return self.instruction_statement(&upper, call, span),
        })
    }

    /// The arguments of a call by the names of its parameters, all of which are needed.
    pub(super) fn named<'c>(
        &mut self,
        function: &str,
        call: &'c ast::Call,
        parameters: &[&str],
        span: Span,
    ) -> Option<Vec<&'c Expression>> {
        let mut found: Vec<Option<&Expression>> = vec![None; parameters.len()];
        for (position, argument) in call.arguments.iter().enumerate() {
            let index = match &argument.name {
                Some(name) => parameters.iter().position(|parameter| name.is(parameter)),
                None => Some(position).filter(|position| *position < parameters.len()),
            };
            let (Some(index), Some(value)) = (index, &argument.value) else {
                let near = argument.name.as_ref().and_then(|name| nearest(&name.text, parameters.iter().copied()));
                let help = match near {
                    Some(near) => format!("Write `{near}`; it has {}.", parameters.join(", ")),
                    None => format!("It has {}.", parameters.join(", ")),
                };
                match &argument.name {
                    Some(name) => self.report(Problem::P3009, argument.span, format!("`{function}` has no parameter `{}`", name.text)),
                    None => {
                        let takes = super::calls::counted(parameters.len(), "parameter");
                        self.report(Problem::P6219, argument.span, format!("`{function}` takes {takes}"))
                    }
                }
                .help = Some(help);
                return None;
            };
            if let Some(first) = found[index].replace(value) {
                let message = format!("the parameter `{}` is given twice", parameters[index]);
                self.report(Problem::P3011, argument.span, message).related.push((first.span, "first given here".to_owned()));
                return None;
            }
        }
        let missing: Vec<String> =
            parameters.iter().zip(&found).filter(|(_, given)| given.is_none()).map(|(name, _)| format!("`{name}`")).collect();
        if !missing.is_empty() {
            self.report(Problem::P3010, span, format!("the call of `{function}` leaves out {}", missing.join(", ")));
            return None;
        }
        Some(found.into_iter().flatten().collect())
    }

    /// Where a byte or a bit lies: area, data block, byte, bit.
    fn somewhere(
        &mut self,
        [area, db, byte]: [&Expression; 3],
        bit: Option<&Expression>,
        before: &mut Vec<Statement>,
        span: Span,
    ) -> Option<Somewhere> {
        let area_value = self.value(area, &DataType::Byte)?;
        let (db_value, _) = self.index_value(db)?;
        let mut indexes = Vec::new();
        for (index, step) in [(Some(byte), 8), (bit, 1)] {
            let Some(index) = index else { continue };
            let (value, _) = self.index_value(index)?;
            indexes.push((convert(value, Scalar::I32), step));
        }
        let constant = match area_value.kind {
            ValueKind::Constant(bits) => Some(bits),
            _ => None,
        };
        let mut keep = |checker: &mut Self, value: Value| {
            if constant.is_some() || matches!(value.kind, ValueKind::Constant(_)) {
                return value;
            }
            let (statement, value) = checker.kept(value);
            before.push(statement);
            value
        };
        let area_value = keep(self, convert(area_value, Scalar::U32));
        let db_value = keep(self, convert(db_value, Scalar::U16));
        let indexes: Vec<Index> = indexes
            .into_iter()
            .map(|(value, step)| Index { value: keep(self, value), low: 0, count: 0, step, check: Bounds::None })
            .collect();
        let place = |base: Base| Place { base, offset: 0, indexes: indexes.clone(), span };
        let base = |area: Option<Area>| match (area, &db_value.kind) {
            (Some(area), _) => Base::Area(area),
            (None, ValueKind::Constant(number)) => Base::DataBlock(*number as u16),
            (None, _) => Base::ComputedDataBlock(Box::new(db_value.clone())),
        };
        let Some(code) = constant else {
            let places = AREAS.iter().map(|&(code, area, _)| (code, place(base(area)))).collect();
            return Some(Somewhere::Asked { area: area_value, places });
        };
        let Some(&(_, known, _)) = AREAS.iter().find(|(known, ..)| *known == code) else {
            let known: Vec<&str> = AREAS.iter().map(|&(.., shown)| shown).collect();
            self.report(Problem::P4001, area.span, format!("16#{code:X} is no area")).help =
                Some(format!("It is one of {}.", known.join(", ")));
            return None;
        };
        if let (None, ValueKind::Constant(number)) = (known, &db_value.kind)
            && self.names.data_block(*number as u16).is_none()
        {
            self.report(Problem::P3008, db.span, format!("the data block DB {number} does not exist")).may_be_elsewhere = true;
            return None;
        }
        Some(Somewhere::Known(place(base(known))))
    }

    fn poke(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let given = self.named("POKE", call, &["area", "dbNumber", "byteOffset", "value"], span)?;
        let value = match self.expression(given[3]) {
            Typed::Poison => return None,
            // A number without a type is as wide as it needs to be.
            typed @ Typed::Integer { value, .. } => {
                let bits = [8, 16, 32].into_iter().find(|&bits| value >> bits == 0).unwrap_or(64);
                self.coerce(typed, given[3].span, &Kind { class: Class::Bits, bits }.data_type())?
            }
            typed => {
                let what = self.what(&typed);
                let (value, data_type) = self.scalar(typed, given[3].span)?;
                match Kind::of(&data_type).is_some_and(|kind| kind.bits >= 8) {
                    true => value,
                    false => {
                        let help = "Use POKE_BOOL for a BOOL.";
                        self.report(Problem::P4011, given[3].span, format!("POKE writes bytes, words and double words, not {what}")).help =
                            Some(help.to_owned());
                        return None;
                    }
                }
            }
        };
        self.poked([given[0], given[1], given[2]], None, value, span)
    }

    fn poke_bool(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let given = self.named("POKE_BOOL", call, &["area", "dbNumber", "byteOffset", "bitOffset", "value"], span)?;
        let value = self.condition(given[4])?;
        self.poked([given[0], given[1], given[2]], Some(given[3]), value, span)
    }

    fn poked(&mut self, at: [&Expression; 3], bit: Option<&Expression>, value: Value, span: Span) -> Option<StatementKind> {
        let mut statements = Vec::new();
        match self.somewhere(at, bit, &mut statements, span)? {
            Somewhere::Known(target) => statements.push(Statement { kind: StatementKind::Assign { target, value }, span }),
            Somewhere::Asked { area, places } => {
                let (keep, value) = self.kept(value);
                statements.push(keep);
                let branches = places.into_iter().map(|(code, target)| {
                    let condition = compute(Op::Equal, vec![area.clone(), number(code as i64, Scalar::U32, span)], Scalar::Bool, span);
                    let kind = StatementKind::Assign { target, value: value.clone() };
                    (condition, vec![Statement { kind, span }])
                });
                let kind = StatementKind::If { branches: branches.collect(), otherwise: self.not_ok(span) };
                statements.push(Statement { kind, span });
            }
        }
        Some(StatementKind::Block(statements))
    }

    fn poke_block(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let parameters = ["area_src", "dbNumber_src", "byteOffset_src", "area_dest", "dbNumber_dest", "byteOffset_dest", "count"];
        let given = self.named("POKE_BLK", call, &parameters, span)?;
        let mut statements = Vec::new();
        let source = self.somewhere([given[0], given[1], given[2]], None, &mut statements, span)?;
        let target = self.somewhere([given[3], given[4], given[5]], None, &mut statements, span)?;
        let (Somewhere::Known(mut source), Somewhere::Known(mut target)) = (source, target) else {
            self.report(Problem::P6229, span, "the areas of POKE_BLK are constants, such as 16#84");
            return None;
        };
        for place in [&mut source, &mut target] {
            for index in &mut place.indexes {
                let (keep, value) = self.kept(index.value.clone());
                statements.push(keep);
                index.value = value;
            }
        }
        let (count, _) = self.index_value(given[6])?;
        let copy = |source: Place, target: Place| {
            let value = Value { kind: ValueKind::Load(source), scalar: Scalar::U8, span };
            StatementKind::Assign { target, value }
        };
        statements.push(self.for_each(
            convert(count, Scalar::I64),
            [(target, 8), (source, 8)],
            |[target, source]| copy(source, target),
            span,
        ));
        Some(StatementKind::Block(statements))
    }

    /// `FOR n := 0 TO count - 1`: a statement with places that move on by their steps.
    fn for_each<const N: usize>(
        &mut self,
        count: Value,
        places: [(Place, u32); N],
        body: impl Fn([Place; N]) -> StatementKind,
        span: Span,
    ) -> Statement {
        let variable = self.temporary_place(4, span);
        let value = Value { kind: ValueKind::Load(variable.clone()), scalar: Scalar::I32, span };
        let places = places.map(|(mut place, step)| {
            place.indexes.push(Index { value: value.clone(), low: 0, count: 0, step, check: Bounds::None });
            place
        });
        let last = convert(two(Operation::Subtract, count, number(1, Scalar::I64, span), span), Scalar::I32);
        let repeated = For {
            variable,
            scalar: Scalar::I32,
            from: number(0, Scalar::I32, span),
            to: last,
            by: number(1, Scalar::I32, span),
            each_pass: false,
            body: vec![Statement { kind: body(places), span }],
        };
        Statement { kind: StatementKind::For(Box::new(repeated)), span }
    }

    /// ENO is FALSE from here on, if the block looks at it; else the Host is told, if it is told of all that is lost.
    pub(super) fn not_ok(&self, span: Span) -> Vec<Statement> {
        let no = number(0, Scalar::Bool, span);
        let failed = match self.lost {
            _ if self.reads_ok => no,
            LostResults::All => {
                Value { kind: ValueKind::Checked { op: Op::Copy, failed: Op::Not, args: vec![no] }, scalar: Scalar::Bool, span }
            }
            _ => return Vec::new(),
        };
        vec![Statement { kind: StatementKind::SetOk(failed), span }]
    }

    /// An element of an array as the first of several.
    pub(super) fn part(&mut self, function: &str, expression: &Expression) -> Option<Part> {
        let span = expression.span;
        let (inner, index) = match &expression.kind {
            ExpressionKind::Index(inner, indexes) if indexes.len() == 1 => (&**inner, &indexes[0]),
            _ => {
                let help = "Write `a[0]`, an element of an array with one dimension.";
                self.report(Problem::P4011, span, format!("`{function}` begins at an element of an array")).help = Some(help.to_owned());
                return None;
            }
        };
        let array = match self.reach(inner) {
            Reached::Target(target) => target,
            Reached::Other(Typed::Poison) => return None,
            Reached::Other(other) => {
                let what = self.what(&other);
                self.report(Problem::P4010, inner.span, format!("{what} has no elements"));
                return None;
            }
        };
        let element = match &array.data_type {
            DataType::Array { bounds, element } if bounds.len() == 1 => (**element).clone(),
            other => {
                let message =
                    format!("`{}` is {}, and `{function}` takes elements of an array with one dimension", array.name, self.words(other));
                self.report(Problem::P4011, span, message);
                return None;
            }
        };
        let (first, _) = self.index_value(index)?;
        let bounds = self.both_bounds(&array, span)?;
        Some(Part { place: array.place, element, first: convert(first, Scalar::I64), bounds })
    }

    /// Where the part begins, and whether so many elements from there on are in the array.
    fn elements(&mut self, part: Part, count: &Value, statements: &mut Vec<Statement>, span: Span) -> Option<(Place, Value)> {
        let [low, high] = part.bounds;
        let (keep, first) = self.kept(part.first);
        statements.push(keep);
        let above = two(Operation::GreaterEqual, first.clone(), low.clone(), span);
        let behind = two(Operation::Add, first.clone(), count.clone(), span);
        let end = two(Operation::Add, high, number(1, Scalar::I64, span), span);
        let below = two(Operation::LessEqual, behind, end, span);
        let inside = compute(Op::And, vec![above, below], Scalar::Bool, span);
        let mut place = part.place;
        let value = two(Operation::Subtract, first, low, span);
        place.indexes.push(Index { value, low: 0, count: 0, step: element_step(&part.element), check: Bounds::None });
        Some((place, inside))
    }

    /// The first and the last index of an array of one dimension, as I64.
    pub(super) fn both_bounds(&mut self, array: &Target, span: Span) -> Option<[Value; 2]> {
        let [low, high] = [self.bound(array, 1, End::Low, span)?, self.bound(array, 1, End::High, span)?];
        Some([low, high].map(|value| convert(value, Scalar::I64)))
    }

    pub(super) fn count(&mut self, expression: &Expression, statements: &mut Vec<Statement>) -> Option<Value> {
        let (count, _) = self.index_value(expression)?;
        let (keep, count) = self.kept(convert(count, Scalar::I64));
        statements.push(keep);
        Some(count)
    }

    fn move_block(&mut self, function: &str, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let given = self.named(function, call, &["IN", "COUNT", "OUT"], span)?;
        let source = self.part(function, given[0])?;
        let target = self.part(function, given[2])?;
        self.target(given[2])?;
        let mut statements = Vec::new();
        let moved = self.moved_elements(function, source, target, given[1], given[2].span, &mut statements, span)?;
        Some(self.if_it_fits(moved.all_fit, statements, moved.repeated, span))
    }

    /// COUNT elements from one part of an array to another one.
    #[allow(clippy::too_many_arguments)] // Both sides of a copy, and where it is written.
    pub(super) fn moved_elements(
        &mut self,
        function: &str,
        source: Part,
        target: Part,
        count: &Expression,
        at: Span,
        statements: &mut Vec<Statement>,
        span: Span,
    ) -> Option<Moved> {
        if !same_type(&source.element, &target.element) {
            let message =
                format!("`{function}` copies elements of one type, not {} to {}", self.words(&source.element), self.words(&target.element));
            self.report(Problem::P4011, at, message);
            return None;
        }
        let count = self.count(count, statements)?;
        self.moved_counted(source, target, count, statements, span)
    }

    /// The same of two parts of one type, by a number that was computed.
    pub(super) fn moved_counted(
        &mut self,
        source: Part,
        target: Part,
        count: Value,
        statements: &mut Vec<Statement>,
        span: Span,
    ) -> Option<Moved> {
        let element = target.element.clone();
        let (source, fits) = self.elements(source, &count, statements, span)?;
        let (target, also) = self.elements(target, &count, statements, span)?;
        let step = element_step(&element);
        let kind = Kind::of(&element).map(|kind| kind.scalar(self.dialect));
        let copy = |[target, source]: [Place; 2]| match (&element, kind) {
            (_, Some(scalar)) => StatementKind::Assign { target, value: Value { kind: ValueKind::Load(source), scalar, span } },
            (text, _) if let Some(room) = room_of(text) => {
                StatementKind::AssignString { target, room, source: Text::Place { place: source, room } }
            }
            (other, _) => StatementKind::Copy { target, source, bytes: (other.bits() / 8) as u32 },
        };
        let repeated = self.for_each(count, [(target, step), (source, step)], copy, span);
        let all_fit = compute(Op::And, vec![fits.clone(), also], Scalar::Bool, span);
        Some(Moved { fits, all_fit, repeated })
    }

    fn fill_block(&mut self, function: &str, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let given = self.named(function, call, &["IN", "COUNT", "OUT"], span)?;
        let target = self.part(function, given[2])?;
        self.target(given[2])?;
        let element = target.element.clone();
        let mut statements = Vec::new();
        let count = self.count(given[1], &mut statements)?;
        let step = element_step(&element);
        let typed = self.expression_for(given[0], &element);
        enum What {
            Value(Value),
            Text(Text, TextRoom),
            Whole(Place),
        }
        let what = match (&element, typed) {
            (_, Typed::Poison) => return None,
            (text, typed) if let Some(room) = room_of(text) => What::Text(self.text_of(typed, given[0].span, room.wide)?, room),
            (_, typed) if Kind::of(&element).is_some() => {
                let value = self.coerce(typed, given[0].span, &element)?;
                let (keep, value) = self.kept(value);
                statements.push(keep);
                What::Value(value)
            }
            (_, Typed::Aggregate(source)) if same_type(&source.data_type, &element) => What::Whole(source.place),
            (_, other) => {
                let message = format!("the elements are {}, and this is {}", self.words(&element), self.what(&other));
                self.report(Problem::P4011, given[0].span, message);
                return None;
            }
        };
        let (target, fits) = self.elements(target, &count, &mut statements, span)?;
        let bytes = (element.bits() / 8) as u32;
        let fill = |[target]: [Place; 1]| match &what {
            What::Value(value) => StatementKind::Assign { target, value: value.clone() },
            What::Text(text, room) => StatementKind::AssignString { target, room: *room, source: text.clone() },
            What::Whole(source) => StatementKind::Copy { target, source: source.clone(), bytes },
        };
        let repeated = self.for_each(count, [(target, step)], fill, span);
        Some(self.if_it_fits(fits, statements, repeated, span))
    }

    /// What moves elements stays undone if they do not all fit.
    fn if_it_fits(&mut self, fits: Value, mut statements: Vec<Statement>, repeated: Statement, span: Span) -> StatementKind {
        let kind = StatementKind::If { branches: vec![(fits, vec![repeated])], otherwise: self.not_ok(span) };
        statements.push(Statement { kind, span });
        StatementKind::Block(statements)
    }
}

pub(super) fn number(value: i64, scalar: Scalar, span: Span) -> Value {
    let bits = if scalar.bits() == 32 { u64::from(value as u32) } else { value as u64 };
    Value { kind: ValueKind::Constant(bits), scalar, span }
}

/// An operation on two numbers of 64 bits.
pub(super) fn two(operation: Operation, a: Value, b: Value, span: Span) -> Value {
    let op = op_for(operation, Scalar::I64).expect("64-bit integers have the operation");
    compute(op, vec![a, b], if compares(operation) { Scalar::Bool } else { Scalar::I64 }, span)
}
