//! Instructions of tia that take any variable as its bytes, which a block of the library works on: ATH, HTA, SCATTER_BLK, GATHER_BLK.

use sieben_model::interface::Interface;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::Checker;
use super::memory::{number, two};
use super::operators::convert;
use super::places::Reached;
use super::typed::Typed;
use super::types::{Class, Kind};
use crate::st::ast::{self, Expression};
use crate::st::open_arrays::{End, bound_name};
use crate::st::standard::operators::Operation;
use crate::st::tree::{Argument, Call, Callee, Place, Scalar, Statement, StatementKind, TextRoom, Value, ValueKind, room_of};

/// A parameter that a block of the library has for a number.
type Numbers<'n, const N: usize> = [(&'n str, Value); N];

/// An array that goes into a parameter ARRAY[*] of one dimension: its place, its first and its last index.
struct Array {
    place: Place,
    data_type: DataType,
    bounds: [Value; 2],
}

impl Checker<'_> {
    /// ATH: hexadecimal digits as bytes; HTA: the other way. The result is 0 or the number of an error.
    pub(super) fn hexadecimal(&mut self, function: &str, call: &ast::Call, span: Span) -> Option<(Vec<Statement>, Call)> {
        let given = self.named(function, call, &["IN", "N", "OUT"], span)?;
        let to_digits = function == "HTA";
        let mut before = Vec::new();
        let (source, from_text) = self.bytes_or_text(function, given[0], !to_digits, &mut before)?;
        self.target(given[2])?;
        let (target, to_text) = self.bytes_or_text(function, given[2], to_digits, &mut before)?;
        let (count, _) = self.index_value(given[1])?;
        let text = Value { kind: ValueKind::Constant(u64::from(from_text || to_text)), scalar: Scalar::Bool, span };
        let numbers = [("N", convert(count, Scalar::I32)), ("TEXT", text)];
        let block = if to_digits { "TIA_HTA" } else { "TIA_ATH" };
        let call = self.call_with_arrays(block, numbers, [("SRC", source), ("DST", target)], span)?;
        Some((before, call))
    }

    /// The bytes of a variable; the digits may be a STRING.
    fn bytes_or_text(
        &mut self,
        function: &str,
        expression: &Expression,
        digits: bool,
        before: &mut Vec<Statement>,
    ) -> Option<(Array, bool)> {
        let span = expression.span;
        let target = match self.reach(expression) {
            Reached::Target(target) => target,
            Reached::Other(Typed::Poison) => return None,
            // A text that is no variable gets a place.
            Reached::Other(Typed::Text(text)) if digits && !text.is_wide() => {
                let room = TextRoom::narrow(sieben_model::types::STRING_LENGTH_MAX);
                let place = self.temporary_place(room.bytes(), span);
                // The head says how much room there is.
                let head = Value { kind: ValueKind::Constant(u64::from(room.characters_max)), scalar: Scalar::U8, span };
                let assign = StatementKind::Assign { target: place.clone(), value: head };
                before.push(Statement { kind: assign, span });
                before.push(Statement { kind: StatementKind::AssignString { target: place.clone(), room, source: text }, span });
                return Some((bytes_at(place, room.bytes(), span), true));
            }
            Reached::Other(other) => return self.is_no_variable(function, &other, span),
        };
        if !self.is_whole(&target) {
            return None;
        }
        let (element, _) = crate::st::variants::elements(&target.data_type);
        let of_bytes = Kind::of(element).is_some_and(|kind| kind.bits == 8);
        let fits = match &target.data_type {
            DataType::String(_) => digits,
            DataType::Array { bounds, .. } => bounds.len() == 1 && of_bytes,
            other if digits => Kind::of(other).is_some_and(|kind| kind.class == Class::Character && kind.bits == 8),
            other => Kind::of(other).is_some_and(|kind| kind.bits >= 8 && (kind.is_integer() || kind.class == Class::Bits)),
        };
        if !fits {
            let wanted = if digits { "a STRING or an array of CHAR or BYTE" } else { "bits, a whole number, or an array of BYTE" };
            let message = format!("`{function}` takes {wanted} here, and `{}` is {}", target.name, self.words(&target.data_type));
            self.report(Problem::P4011, span, message);
            return None;
        }
        let is_text = room_of(&target.data_type).is_some();
        let bytes = match &target.data_type {
            // How long the STRING of a caller is, its head says.
            DataType::String(_) => u32::from(sieben_model::types::STRING_LENGTH_MAX) + 2,
            DataType::Array { bounds, .. } => bounds.first().map_or(0, |(low, high)| (i64::from(*high) - i64::from(*low) + 1) as u32),
            other => u32::try_from(other.bits() / 8).unwrap_or(u32::MAX),
        };
        Some((bytes_at(target.place, bytes, span), is_text))
    }

    /// SCATTER_BLK and GATHER_BLK: the bits of several elements.
    pub(super) fn scattered_block(&mut self, function: &str, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let scatter = function == "SCATTER_BLK";
        let given = self.named(function, call, &["IN", if scatter { "COUNT_IN" } else { "COUNT_OUT" }, "OUT"], span)?;
        let (bits_at, words_at) = if scatter { (given[2], given[0]) } else { (given[0], given[2]) };
        self.target(given[2])?;
        let words = self.part(function, words_at)?;
        let bits = self.part(function, bits_at)?;
        let kind = Kind::of(&words.element).filter(|kind| kind.bits >= 8 && kind.class == Class::Bits);
        let (Some(kind), true) = (kind, bits.element == DataType::Bool) else {
            let message = format!(
                "`{function}` is for an array of BYTE, WORD, DWORD or LWORD and one of BOOL, and these are {} and {}",
                self.words(&words.element),
                self.words(&bits.element)
            );
            self.report(Problem::P4011, span, message);
            return None;
        };
        let bytes_each = number(i64::from(kind.bits / 8), Scalar::I64, span);
        let [low, high] = words.bounds;
        let one = number(1, Scalar::I64, span);
        let elements = two(Operation::Add, two(Operation::Subtract, high, low.clone(), span), one.clone(), span);
        let last = two(Operation::Subtract, two(Operation::Multiply, elements, bytes_each, span), one, span);
        let bytes = Array { place: words.place, data_type: DataType::Byte, bounds: [number(0, Scalar::I64, span), last] };
        let bools = Array { place: bits.place, data_type: DataType::Bool, bounds: bits.bounds };
        let (count, _) = self.index_value(given[1])?;
        let numbers = [
            ("WIDTH", number(i64::from(kind.bits), Scalar::I32, span)),
            ("COUNT", convert(count, Scalar::I32)),
            ("FIRST", convert(two(Operation::Subtract, words.first, low, span), Scalar::I32)),
            ("PLACE", convert(bits.first, Scalar::I32)),
        ];
        let (source, target) = if scatter { (bytes, bools) } else { (bools, bytes) };
        let block = if scatter { "TIA_SCATTER" } else { "TIA_GATHER" };
        let call = self.call_with_arrays(block, numbers, [("SRC", source), ("DST", target)], span)?;
        Some(StatementKind::Call(call))
    }

    /// A call of a block of the library with arrays that are what they are: bytes of a variable, or the array itself.
    fn call_with_arrays<const N: usize>(
        &mut self,
        block: &str,
        numbers: Numbers<'_, N>,
        arrays: [(&str, Array); 2],
        span: Span,
    ) -> Option<Call> {
        let Some(block) = self.of_library(block) else {
            self.not_built(span, "this instruction");
            return None;
        };
        let interface = self.interface(block, span)?;
        let parameter = |interface: &Interface, name: &str| interface.variable(name).map(|formal| formal.offset);
        let mut arguments = Vec::new();
        for (name, value) in numbers {
            arguments.push(Argument::Value { parameter: parameter(&interface, name)?, value });
        }
        for (name, array) in arrays {
            for (end, bound) in End::BOTH.into_iter().zip(array.bounds) {
                let parameter = parameter(&interface, &bound_name(name, 1, end))?;
                arguments.push(Argument::Value { parameter, value: convert(bound, Scalar::I32) });
            }
            let data_type = DataType::Array { bounds: vec![crate::st::open_arrays::OPEN], element: Box::new(array.data_type) };
            arguments.push(Argument::InOut { parameter: parameter(&interface, name)?, place: array.place, data_type });
        }
        let result = interface.variables.iter().find(|variable| variable.section == sieben_model::interface::Section::Return);
        let result = result.map_or(DataType::Void, |result| result.data_type.clone());
        let callee = Callee::Function(block);
        Some(Call { callee, arguments, enable: None, result, clears_ok: self.reads_ok, of_library: true, written_out: None, span })
    }
}

/// So many bytes from a place on.
fn bytes_at(place: Place, bytes: u32, span: Span) -> Array {
    let bounds = [0, i64::from(bytes) - 1].map(|bound| number(bound, Scalar::I64, span));
    Array { place, data_type: DataType::Byte, bounds }
}
