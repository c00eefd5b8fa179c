//! Instructions of tia that know the types of what they work on: DEMUX, MOVE_BLK_VARIANT, Serialize, SCATTER, CountOfElements and their kin.

use sieben_engine::ir::Op;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::Checker;
use super::calls::after;
use super::memory::{Moved, Part, number, two};
use super::operators::convert;
use super::own_errors;
use super::places::{Reached, element_step};
use super::texts::text_room;
use super::typed::{Target, Typed};
use super::types::{Class, Kind};
use super::variants::Described;
use crate::st::ast::{self, Expression, Name};
use crate::st::open_arrays::End;
use crate::st::standard::build::compute;
use crate::st::standard::operators::Operation;
use crate::st::tree::{Bounds, Branch, Callee, Index, Place, Scalar, Statement, StatementKind, Value, ValueKind, room_of};

/// Elements from the first one on that are not all in the source, in the target.
const SOURCE_TOO_SHORT: u64 = 0x8383;
const TARGET_TOO_SHORT: u64 = 0x8483;
/// Elements of two VARIANTs that are not of one type, or texts, whose lengths a VARIANT does not tell.
const OTHER_ELEMENTS: u64 = 0x80B4;
/// A position outside the array of bytes, and one behind which there is not enough room.
const POSITION_OUTSIDE: u64 = 0x8382;
const ARRAY_TOO_SHORT: u64 = 0x8383;

/// Functions that are a system function with other names: name, SFC, its parameter, what the parameter is called here.
const CLOCKS: &[(&str, u16, &str, &str)] =
    &[("RD_SYS_T", 1, "CDT", "OUT"), ("RD_LOC_T", 1, "CDT", "OUT"), ("WR_SYS_T", 0, "PDT", "IN"), ("WR_LOC_T", 0, "PDT", "IN")];

impl Checker<'_> {
    /// What delivers a value; `None` for other names.
    pub(super) fn instruction(&mut self, name: &Name, call: &ast::Call, span: Span) -> Option<Typed> {
        if !self.has_memory_functions() {
            return None;
        }
        let upper = name.text.to_ascii_uppercase();
        let found = match upper.as_str() {
            "T_ADD" | "T_SUB" | "T_DIFF" => self.sum(&upper, call, false, span),
            "COUNTOFELEMENTS" => self.count_of_elements(call, span),
            "MAX_LEN" => self.max_len(call, span),
            own_errors::NUMBER => self.error_number(call, span),
            "RUNTIME" => self.runtime(call, span),
            "ATH" | "HTA" => self.hexadecimal(&upper, call, span).map(|(before, call)| self.result_of(call, before, span)),
            "IS_ARRAY" | "IS_NULL" | "NOT_NULL" => self.variant_question(&upper, call, span),
            "TYPEOF" | "TYPEOFELEMENTS" => {
                self.look_at(&call.arguments);
                self.report(Problem::P6325, span, "a type is no value: it is compared with another type").help =
                    Some(format!("Write `IF {}(v) = INT THEN` or `CASE {}(v) OF`.", name.text, name.text));
                None
            }
            "MOVE_BLK_VARIANT" => self.move_variant(call, span).map(|(statements, place)| delivered(statements, place, span)),
            "SERIALIZE" => self.serialize(call, span).map(|(statements, place)| delivered(statements, place, span)),
            "DESERIALIZE" => self.deserialize(call, span).map(|(statements, place)| delivered(statements, place, span)),
            "DEMUX"
            | "S_MOVE"
            | "STRG_VAL"
            | "VAL_STRG"
            | "SCATTER"
            | "GATHER"
            | "SCATTER_BLK"
            | "GATHER_BLK"
            | "VARIANTGET"
            | "VARIANTPUT"
            | "RESET_TIMER"
            | "PRESET_TIMER"
            | own_errors::STRUCTURE => {
                self.look_at(&call.arguments);
                self.report(Problem::P6218, span, format!("`{upper}` has no result")).help =
                    Some("Call it in a statement of its own.".to_owned());
                None
            }
            _ => return self.without_target(&upper, call, span).or_else(|| self.clock(&upper, call, span)),
        };
        Some(found.unwrap_or(Typed::Poison))
    }

    /// What is a statement, or has a result that nobody takes; `None` for other names.
    pub(super) fn instruction_statement(&mut self, name: &str, call: &ast::Call, span: Span) -> Option<Option<StatementKind>> {
        Some(match name {
            "DEMUX" => self.demux(call, span),
            "S_MOVE" => self.string_move(call, span),
            "STRG_VAL" => self.value_of_text(call, span),
            "VAL_STRG" => self.value_in_text(call, span),
            "SCATTER" => self.scatter(call, span),
            "GATHER" => self.gather(call, span),
            "SCATTER_BLK" | "GATHER_BLK" => self.scattered_block(name, call, span),
            "ATH" | "HTA" => self.hexadecimal(name, call, span).map(|(mut before, call)| {
                before.push(Statement { kind: StatementKind::Call(call), span });
                StatementKind::Block(before)
            }),
            "VARIANTGET" => self.variant_get(call, span),
            "VARIANTPUT" => self.variant_put(call, span),
            own_errors::STRUCTURE => self.error_as_structure(call, span),
            "RESET_TIMER" => self.reset_timer(call, span),
            "PRESET_TIMER" => self.preset_timer(call, span),
            "MOVE_BLK_VARIANT" => self.move_variant(call, span).map(|(statements, _)| StatementKind::Block(statements)),
            "SERIALIZE" => self.serialize(call, span).map(|(statements, _)| StatementKind::Block(statements)),
            "DESERIALIZE" => self.deserialize(call, span).map(|(statements, _)| StatementKind::Block(statements)),
            _ => return None,
        })
    }

    /// The seconds since the call before with the same variable.
    fn runtime(&mut self, call: &ast::Call, span: Span) -> Option<Typed> {
        let given = self.named("RUNTIME", call, &["MEM"], span)?;
        let target = self.target(given[0])?;
        if target.data_type != DataType::LongReal {
            let message = format!("`RUNTIME` keeps the time in an LREAL, and `{}` is {}", target.name, self.words(&target.data_type));
            self.report(Problem::P4011, given[0].span, message);
            return None;
        }
        let block = self.of_library("TIA_RUNTIME")?;
        let interface = self.interface(block, span)?;
        let (call, before) = self.arguments(Callee::Function(block), &interface, call, span)?;
        Some(self.result_of(call, before, span))
    }

    /// RD_SYS_T and its like: a system function whose result says whether it went well.
    fn clock(&mut self, name: &str, call: &ast::Call, span: Span) -> Option<Typed> {
        let &(_, number, own, given) = CLOCKS.iter().find(|(one, ..)| *one == name)?;
        if let Some(typed) = self.clock_of_type(name, given, call, span) {
            return Some(typed);
        }
        let block = BlockId::new(BlockKind::SystemFunction, number);
        let mut renamed = call.clone();
        if renamed.arguments.len() > 1 {
            self.look_at(&call.arguments);
            self.report(Problem::P6219, call.arguments[1].span, format!("`{name}` takes one parameter, {given}")).help =
                Some(format!("Write `x := {name}({given} {} y);`.", if given == "OUT" { "=>" } else { ":=" }));
            return Some(Typed::Poison);
        }
        for argument in &mut renamed.arguments {
            match &mut argument.name {
                Some(name) if name.is(given) => own.clone_into(&mut name.text),
                Some(_) => {}
                None => {
                    argument.name = Some(Name { text: own.to_owned(), span: argument.span, quoting: ast::Quoting::Bare });
                    argument.direction = if given == "OUT" { ast::Direction::Delivered } else { ast::Direction::Assigned };
                }
            }
        }
        let Some(interface) = self.interface(block, call.callee.span) else { return Some(Typed::Poison) };
        let Some((done, before)) = self.arguments(Callee::Function(block), &interface, &renamed, span) else { return Some(Typed::Poison) };
        let result = interface.variable("RET_VAL")?;
        Some(self.delivered_result(result, done, before, span))
    }

    /// The clock as a DTL or an LDT, which a block of the library makes of the DATE_AND_TIME that the CPU has.
    fn clock_of_type(&mut self, name: &str, parameter: &str, call: &ast::Call, span: Span) -> Option<Typed> {
        let [ast::Argument { value: Some(value), name: given, .. }] = call.arguments.as_slice() else { return None };
        if given.as_ref().is_some_and(|given| !given.is(parameter)) {
            return None;
        }
        let data_type = match self.quietly(|checker| checker.reach(value)) {
            Reached::Target(target) => target.data_type,
            Reached::Other(Typed::Structured(..)) => crate::st::dtl::data_type(),
            Reached::Other(Typed::Scalar { data_type, .. }) => data_type,
            Reached::Other(_) => return None,
        };
        let function = match (&data_type, parameter) {
            (DataType::LongDateAndTime, "OUT") => "TIA_READ_LDT",
            (DataType::LongDateAndTime, _) => "TIA_WRITE_LDT",
            (other, "OUT") if crate::st::dtl::is_dtl(other) => "TIA_READ_DTL",
            (other, _) if crate::st::dtl::is_dtl(other) => "TIA_WRITE_DTL",
            (DataType::DateAndTime | DataType::Void, _) => return None,
            (other, _) => {
                let does = if parameter == "OUT" { "writes the clock to" } else { "sets the clock from" };
                let message = format!("`{name}` {does} a DTL, an LDT or a DATE_AND_TIME, and this is {}", self.words(other));
                self.report(Problem::P4011, value.span, message).help =
                    Some("Use a variable of one of these types, and T_CONV for what you need of it.".to_owned());
                return Some(Typed::Poison);
            }
        };
        let Some(block) = self.of_library(function) else { return Some(self.not_built(span, "this instruction")) };
        let Some(interface) = self.interface(block, span) else { return Some(Typed::Poison) };
        let Some((done, before)) = self.arguments(Callee::Function(block), &interface, call, span) else { return Some(Typed::Poison) };
        Some(self.result_of(done, before, span))
    }

    fn count_of_elements(&mut self, call: &ast::Call, span: Span) -> Option<Typed> {
        let [ast::Argument { value: Some(array), .. }] = call.arguments.as_slice() else {
            self.report(Problem::P6219, span, "`CountOfElements` takes one array");
            return None;
        };
        if self.is_variant_parameter(array) {
            let described = self.described("CountOfElements", array)?;
            return Some(Typed::Scalar { value: described.count, data_type: DataType::UnsignedDoubleInt });
        }
        let target = self.whole_array("CountOfElements", array)?;
        let DataType::Array { bounds, .. } = &target.data_type else { return None };
        let mut all = number(1, Scalar::I64, span);
        for dimension in 1..=bounds.len() {
            let [low, high] = [self.bound(&target, dimension, End::Low, span)?, self.bound(&target, dimension, End::High, span)?];
            let [low, high] = [low, high].map(|value| convert(value, Scalar::I64));
            let distance = two(Operation::Subtract, high, low, span);
            let count = two(Operation::Add, distance, number(1, Scalar::I64, span), span);
            all = two(Operation::Multiply, all, count, span);
        }
        let data_type = DataType::UnsignedDoubleInt;
        Some(Typed::Scalar { value: convert(all, Scalar::U32), data_type })
    }

    /// A variable that is an array.
    fn whole_array(&mut self, function: &str, expression: &Expression) -> Option<Target> {
        match self.reach(expression) {
            Reached::Target(target) if matches!(target.data_type, DataType::Array { .. }) => Some(target),
            Reached::Target(target) => {
                let message = format!("`{function}` takes an array here, and `{}` is {}", target.name, self.words(&target.data_type));
                self.report(Problem::P4011, expression.span, message);
                None
            }
            Reached::Other(Typed::Poison) => None,
            Reached::Other(other) => {
                let what = self.what(&other);
                self.report(Problem::P4011, expression.span, format!("`{function}` takes an array here, not {what}"));
                None
            }
        }
    }

    /// How many characters a text has room for.
    fn max_len(&mut self, call: &ast::Call, span: Span) -> Option<Typed> {
        let given = self.named("MAX_LEN", call, &["IN"], span)?;
        let target = match self.reach(given[0]) {
            Reached::Target(target) => target,
            Reached::Other(Typed::Poison) => return None,
            Reached::Other(other) => {
                let what = self.what(&other);
                self.report(Problem::P4011, given[0].span, format!("`MAX_LEN` takes a variable, not {what}"));
                return None;
            }
        };
        let Some(room) = text_room(&target) else {
            let message = format!("`MAX_LEN` takes a text, and `{}` is {}", target.name, self.words(&target.data_type));
            self.report(Problem::P4011, given[0].span, message);
            return None;
        };
        let value = if room.is_unknown() {
            let scalar = if room.wide { Scalar::U16 } else { Scalar::U8 };
            convert(Value { kind: ValueKind::Load(target.place), scalar, span }, Scalar::I32)
        } else {
            number(room.characters_max.into(), Scalar::I32, span)
        };
        Some(Typed::Scalar { value, data_type: DataType::DoubleInt })
    }

    /// A text to a variable of its kind.
    fn string_move(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let given = self.named("S_MOVE", call, &["IN", "OUT"], span)?;
        let typed = self.expression(given[0]);
        let target = self.target(given[1])?;
        if room_of(&target.data_type).is_none() {
            let message = format!("`S_MOVE` writes a text, and `{}` is {}", target.name, self.words(&target.data_type));
            self.report(Problem::P4011, given[1].span, message);
            return None;
        }
        self.store(target, typed, given[0].span, span)
    }

    /// `DEMUX(K := n, IN := x, OUT0 => a, OUT1 => b, OUTELSE => c)`: one of the outputs gets the value.
    fn demux(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let (mut selector, mut input, mut otherwise) = (None, None, None);
        let mut outputs: Vec<(i128, &Expression)> = Vec::new();
        for argument in &call.arguments {
            let (Some(name), Some(value)) = (&argument.name, &argument.value) else {
                self.report(Problem::P6219, argument.span, "`DEMUX` takes its parameters by name").help =
                    Some("Write `DEMUX(K := n, IN := x, OUT0 => a, OUT1 => b, OUTELSE => c)`.".to_owned());
                return None;
            };
            let upper = name.text.to_ascii_uppercase();
            match upper.as_str() {
                "K" => selector = Some(value),
                "IN" => input = Some(value),
                "OUTELSE" => otherwise = Some(value),
                other => match other.strip_prefix("OUT").and_then(|number| number.parse::<u16>().ok()) {
                    Some(number) if !outputs.iter().any(|(known, _)| *known == i128::from(number)) => {
                        outputs.push((number.into(), value));
                    }
                    Some(_) => {
                        self.report(Problem::P3011, name.span, format!("`{}` of `DEMUX` is given twice", name.text));
                        return None;
                    }
                    None => {
                        self.report(Problem::P3009, name.span, format!("`DEMUX` has no parameter `{}`", name.text)).help =
                            Some("It has K, IN, OUT0, OUT1 and so on, and OUTELSE.".to_owned());
                        return None;
                    }
                },
            }
        }
        let (Some(selector), Some(input), false) = (selector, input, outputs.is_empty()) else {
            self.report(Problem::P3010, span, "the call of `DEMUX` leaves out `K`, `IN` or all outputs");
            return None;
        };
        let (number, _) = self.index_value(selector)?;
        let number = convert(number, Scalar::I64);
        let mut statements = Vec::new();
        let mut typed = self.expression(input);
        if let Typed::Scalar { value, data_type } = typed {
            let (keep, value) = self.kept(value);
            statements.push(keep);
            typed = Typed::Scalar { value, data_type };
        }
        let mut branches = Vec::with_capacity(outputs.len());
        for (number, output) in outputs {
            let target = self.target(output)?;
            let kind = self.store(target, typed.clone(), input.span, span)?;
            branches.push(Branch { ranges: vec![(number, number)], span: output.span, body: vec![Statement { kind, span }] });
        }
        let mut last = Vec::new();
        if let Some(otherwise) = otherwise {
            let target = self.target(otherwise)?;
            let kind = self.store(target, typed, input.span, span)?;
            last.push(Statement { kind, span });
        }
        last.extend(self.not_ok(span));
        statements.push(Statement { kind: StatementKind::Case { selector: number, branches, otherwise: last }, span });
        Some(StatementKind::Block(statements))
    }

    /// Elements of one array to another one, both counted from 0; the statements, and where the result lies.
    fn move_variant(&mut self, call: &ast::Call, span: Span) -> Option<(Vec<Statement>, Place)> {
        const NAME: &str = "MOVE_BLK_VARIANT";
        let given = self.named(NAME, call, &["SRC", "COUNT", "SRC_INDEX", "DEST_INDEX", "DEST"], span)?;
        self.target(given[4])?;
        let [source, target] = match [given[0], given[4]].map(|array| self.is_variant_parameter(array)) {
            [false, false] => [self.counted_part(NAME, given[0], given[2], span)?, self.counted_part(NAME, given[4], given[3], span)?],
            [true, false] => {
                let target = self.counted_part(NAME, given[4], given[3], span)?;
                [self.variant_part(NAME, given[0], given[2], &target.element, span)?, target]
            }
            [false, true] => {
                let source = self.counted_part(NAME, given[0], given[2], span)?;
                let target = self.variant_part(NAME, given[4], given[3], &source.element, span)?;
                [source, target]
            }
            [true, true] => return self.moved_between_variants(NAME, &given, span),
        };
        let mut statements = Vec::new();
        let moved = self.moved_elements(NAME, source, target, given[1], given[4].span, &mut statements, span)?;
        let place = self.temporary_place(2, span);
        statements.push(self.answered(moved, &place, span));
        Some((statements, place))
    }

    /// Moves the elements if all fit; 0, or which array is too short, goes to the place.
    fn answered(&self, moved: Moved, place: &Place, span: Span) -> Statement {
        let answer = |code: u64| answer(place, code, span);
        let mut refused = self.not_ok(span);
        let too_few = compute(Op::Not, vec![moved.fits], Scalar::Bool, span);
        let which =
            StatementKind::If { branches: vec![(too_few, vec![answer(SOURCE_TOO_SHORT)])], otherwise: vec![answer(TARGET_TOO_SHORT)] };
        refused.push(Statement { kind: which, span });
        let kind = StatementKind::If { branches: vec![(moved.all_fit, vec![moved.repeated, answer(0)])], otherwise: refused };
        Statement { kind, span }
    }

    /// Elements of one VARIANT to another one: as bits if they are BOOL, else as the bytes that their type has.
    fn moved_between_variants(&mut self, function: &str, given: &[&Expression], span: Span) -> Option<(Vec<Statement>, Place)> {
        let [source, target] = [self.described(function, given[0])?, self.described(function, given[4])?];
        let mut statements = Vec::new();
        let [count, from, to] = [given[1], given[2], given[3]].map(|value| self.count(value, &mut statements));
        let (count, from, to) = (count?, from?, to?);
        let place = self.temporary_place(2, span);
        let bits = convert(source.bits(span), Scalar::I64);
        let equal = |a: Value, b: Value| compute(Op::Equal, vec![a, b], Scalar::Bool, span);
        let same = equal(source.type_number.clone(), target.type_number.clone());
        let mut branches = Vec::new();
        let bytes = two(Operation::Divide, bits.clone(), number(8, Scalar::I64, span), span);
        for (element, size, condition) in [
            (DataType::Bool, number(1, Scalar::I64, span), equal(bits.clone(), number(1, Scalar::I64, span))),
            (DataType::Byte, bytes, two(Operation::Greater, bits, number(1, Scalar::I64, span), span)),
        ] {
            let times = |value: &Value| two(Operation::Multiply, value.clone(), size.clone(), span);
            let part = |described: &Described, first: &Value| described.part(&element, times(first), &size, span);
            let mut body = Vec::new();
            let (keep, all) = self.kept(times(&count));
            body.push(keep);
            let moved = self.moved_counted(part(&source, &from), part(&target, &to), all, &mut body, span)?;
            body.push(self.answered(moved, &place, span));
            branches.push((compute(Op::And, vec![same.clone(), condition], Scalar::Bool, span), body));
        }
        let mut otherwise = self.not_ok(span);
        otherwise.push(answer(&place, OTHER_ELEMENTS, span));
        statements.push(Statement { kind: StatementKind::If { branches, otherwise }, span });
        Some((statements, place))
    }

    /// The part of an array that begins so many elements behind its first.
    fn counted_part(&mut self, function: &str, array: &Expression, index: &Expression, span: Span) -> Option<Part> {
        let array_span = array.span;
        let array = self.whole_array(function, array)?;
        let DataType::Array { bounds, element } = &array.data_type else { return None };
        if bounds.len() != 1 {
            let message = format!("`{function}` takes arrays with one dimension, and `{}` has {}", array.name, bounds.len());
            self.report(Problem::P4011, array_span, message);
            return None;
        }
        let element = (**element).clone();
        let (index, _) = self.index_value(index)?;
        let bounds = self.both_bounds(&array, span)?;
        let first = two(Operation::Add, convert(index, Scalar::I64), bounds[0].clone(), span);
        Some(Part { place: array.place, element, first, bounds })
    }

    /// The same of a VARIANT, if it is an array of such elements.
    fn variant_part(&mut self, function: &str, variant: &Expression, index: &Expression, element: &DataType, span: Span) -> Option<Part> {
        let described = self.described(function, variant)?;
        let (index, _) = self.index_value(index)?;
        Some(self.part_of_variant(&described, element, convert(index, Scalar::I64), span))
    }

    /// The bytes of a variable to a place in an array of bytes.
    fn serialize(&mut self, call: &ast::Call, span: Span) -> Option<(Vec<Statement>, Place)> {
        let given = self.named("Serialize", call, &["SRC_VARIABLE", "DEST_ARRAY", "POS"], span)?;
        let source = self.bytes_of("Serialize", given[0])?;
        self.target(given[1])?;
        self.in_bytes("Serialize", (given[1], given[2]), source, true, span)
    }

    /// The other way.
    fn deserialize(&mut self, call: &ast::Call, span: Span) -> Option<(Vec<Statement>, Place)> {
        let given = self.named("Deserialize", call, &["SRC_ARRAY", "DEST_VARIABLE", "POS"], span)?;
        self.target(given[1])?;
        let target = self.bytes_of("Deserialize", given[1])?;
        self.in_bytes("Deserialize", (given[0], given[2]), target, false, span)
    }

    /// Says that a function takes a variable where something else stands.
    pub(super) fn is_no_variable<T>(&mut self, function: &str, other: &Typed, span: Span) -> Option<T> {
        let what = self.what(other);
        self.report(Problem::P4011, span, format!("`{function}` takes a variable here, not {what}"));
        None
    }

    /// A variable of whole bytes.
    fn bytes_of(&mut self, function: &str, expression: &Expression) -> Option<Target> {
        let span = expression.span;
        let target = match self.reach(expression) {
            Reached::Target(target) => target,
            Reached::Other(Typed::Poison) => return None,
            Reached::Other(other) => return self.is_no_variable(function, &other, span),
        };
        if !self.is_whole(&target) {
            return None;
        }
        if target.data_type == DataType::Bool || matches!(target.data_type, DataType::Instance { .. } | DataType::Reference(_)) {
            let message = format!("`{function}` copies bytes, and `{}` is {}", target.name, self.words(&target.data_type));
            self.report(Problem::P4011, span, message).help = Some("Put it into a structure.".to_owned());
            return None;
        }
        Some(target)
    }

    fn in_bytes(
        &mut self,
        function: &str,
        (array, position): (&Expression, &Expression),
        other: Target,
        into: bool,
        span: Span,
    ) -> Option<(Vec<Statement>, Place)> {
        let array_span = array.span;
        let array = self.whole_array(function, array)?;
        let byte = |data_type: &DataType| Kind::of(data_type).is_some_and(|kind| kind.bits == 8);
        match &array.data_type {
            DataType::Array { bounds, element } if bounds.len() == 1 && byte(element) => {}
            wrong => {
                let message =
                    format!("`{function}` takes an array of bytes with one dimension, and `{}` is {}", array.name, self.words(wrong));
                self.report(Problem::P4011, array_span, message);
                return None;
            }
        }
        let position_target = self.target(position)?;
        let Some(kind) = Kind::of(&position_target.data_type).filter(|kind| kind.is_integer()) else {
            let message = format!("`POS` is a whole number, and `{}` is {}", position_target.name, self.words(&position_target.data_type));
            self.report(Problem::P4011, position.span, message);
            return None;
        };
        let mut statements = Vec::new();
        let load = Value { kind: ValueKind::Load(position_target.place.clone()), scalar: kind.scalar(self.dialect), span };
        let (keep, at) = self.kept(convert(load, Scalar::I64));
        statements.push(keep);
        let [low, high] = [self.bound(&array, 1, End::Low, span)?, self.bound(&array, 1, End::High, span)?];
        let [low, high] = [low, high].map(|value| convert(value, Scalar::I64));
        let distance = two(Operation::Subtract, high, low, span);
        let length = two(Operation::Add, distance, number(1, Scalar::I64, span), span);
        let size = i64::try_from(other.data_type.bits().div_ceil(8)).unwrap_or(i64::MAX);
        let behind = two(Operation::Add, at.clone(), number(size, Scalar::I64, span), span);
        let not_before = two(Operation::GreaterEqual, at.clone(), number(0, Scalar::I64, span), span);
        let starts = two(Operation::LessEqual, at.clone(), length.clone(), span);
        let inside = compute(Op::And, vec![not_before, starts], Scalar::Bool, span);
        let ends = two(Operation::LessEqual, behind.clone(), length, span);
        let mut bytes = array.place;
        bytes.indexes.push(Index { value: at, low: 0, count: 0, step: element_step(&DataType::Byte), check: Bounds::None });
        let (source, target) = if into { (other.place, bytes) } else { (bytes, other.place) };
        let copy = match Kind::of(&other.data_type) {
            Some(kind) => {
                let scalar = kind.scalar(self.dialect);
                StatementKind::Assign { target, value: Value { kind: ValueKind::Load(source), scalar, span } }
            }
            None => StatementKind::Copy { target, source, bytes: u32::try_from(size).unwrap_or(u32::MAX) },
        };
        let place = self.temporary_place(2, span);
        let further = StatementKind::Assign { target: position_target.place, value: convert(behind, kind.scalar(self.dialect)) };
        let mut done: Vec<Statement> = [copy, further].into_iter().map(|kind| Statement { kind, span }).collect();
        done.push(answer(&place, 0, span));
        let mut refused = self.not_ok(span);
        let which = StatementKind::If {
            branches: vec![(inside.clone(), vec![answer(&place, ARRAY_TOO_SHORT, span)])],
            otherwise: vec![answer(&place, POSITION_OUTSIDE, span)],
        };
        refused.push(Statement { kind: which, span });
        let fits = compute(Op::And, vec![inside, ends], Scalar::Bool, span);
        statements.push(Statement { kind: StatementKind::If { branches: vec![(fits, done)], otherwise: refused }, span });
        Some((statements, place))
    }

    /// The bits of a value to the elements of an array of BOOL, the lowest first.
    fn scatter(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let given = self.named("SCATTER", call, &["IN", "OUT"], span)?;
        self.target(given[1])?;
        let (bits, place) = self.bits_of_array("SCATTER", given[1])?;
        let wanted = Kind { class: Class::Bits, bits };
        let value = self.value(given[0], &wanted.data_type())?;
        Some(StatementKind::Assign { target: place, value: mirrored(value, span) })
    }

    /// The elements of an array of BOOL as the bits of a value, the lowest first.
    fn gather(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let given = self.named("GATHER", call, &["IN", "OUT"], span)?;
        let (bits, place) = self.bits_of_array("GATHER", given[0])?;
        let kind = Kind { class: Class::Bits, bits };
        let load = Value { kind: ValueKind::Load(place), scalar: kind.scalar(self.dialect), span };
        let typed = Typed::Scalar { value: mirrored(load, span), data_type: kind.data_type() };
        let target = self.target(given[1])?;
        self.store(target, typed, given[0].span, span)
    }

    /// How many bits an array of BOOL has that is as long as a bit string, and where they lie.
    fn bits_of_array(&mut self, function: &str, expression: &Expression) -> Option<(u32, Place)> {
        let target = self.whole_array(function, expression)?;
        if let DataType::Array { bounds, element } = &target.data_type
            && let [(low, high)] = bounds.as_slice()
            && **element == DataType::Bool
            && let Some(bits) = [8, 16, 32, 64].into_iter().find(|&bits| i64::from(*high) - i64::from(*low) + 1 == i64::from(bits))
        {
            return Some((bits, target.place));
        }
        let message =
            format!("`{function}` takes an array of 8, 16, 32 or 64 BOOL, and `{}` is {}", target.name, self.words(&target.data_type));
        self.report(Problem::P4011, expression.span, message);
        None
    }
}

/// The bytes of a bit string in the other order: an array of BOOL begins with the lowest bit of its first byte.
fn mirrored(value: Value, span: Span) -> Value {
    let scalar = value.scalar;
    match scalar.bits() {
        16 => compute(Op::Swap16, vec![value], scalar, span),
        32 => compute(Op::Swap32, vec![value], scalar, span),
        64 => compute(Op::Swap64, vec![value], scalar, span),
        _ => value,
    }
}

/// The result of an instruction: 0 or the number of an error.
fn answer(place: &Place, code: u64, span: Span) -> Statement {
    let value = Value { kind: ValueKind::Constant(code), scalar: Scalar::I16, span };
    Statement { kind: StatementKind::Assign { target: place.clone(), value }, span }
}

/// The result behind the statements that make it.
fn delivered(statements: Vec<Statement>, place: Place, span: Span) -> Typed {
    let value = Value { kind: ValueKind::Load(place), scalar: Scalar::I16, span };
    Typed::Scalar { value: after(statements, value), data_type: DataType::Int }
}
