//! DTL in expressions, and the instructions of tia whose result has the type of what it is assigned to: T_CONV, T_COMBINE, S_CONV.

use sieben_model::block::BlockId;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::Checker;
use super::expressions::same_type;
use super::places::Reached;
use super::statements::moment;
use super::typed::Typed;
use crate::st::ast::{self, Expression, ExpressionKind, Name, Quoting};
use crate::st::dtl;
use crate::st::standard::{self, library};
use crate::st::tree::{Place, Scalar, Statement, StatementKind, Value, ValueKind};

/// Instructions whose result has the type of what it is assigned to.
const BY_TARGET: [&str; 3] = ["T_CONV", "T_COMBINE", "S_CONV"];

/// Instructions that deliver a DTL, and the block of the library that does it.
const DTL_FUNCTIONS: [(&str, &str); 3] = [("T_COMBINE", "TIA_COMBINE_DTL"), ("T_ADD", "TIA_ADD_DTL"), ("T_SUB", "TIA_SUB_DTL")];

/// The word of a type in the names of conversions of tia.
fn word(data_type: &DataType) -> Option<&'static str> {
    match data_type.base() {
        DataType::DateAndTime => Some("DT"),
        DataType::TimeOfDay => Some("TOD"),
        DataType::String(_) => Some("STRING"),
        DataType::WideString(_) => Some("WSTRING"),
        other if dtl::is_dtl(other) => Some(dtl::WORD),
        other => other.word(),
    }
}

impl Checker<'_> {
    /// The statements that write a constant of type DTL.
    pub(super) fn write_dtl(target: &Place, bytes: [u8; dtl::BYTES], span: Span) -> Vec<Statement> {
        let [a, b, c, d, e, f, g, h, i, j, k, l] = bytes;
        let mut all = moment(target, [a, b, c, d, e, f, g, h], span);
        let value = Value { kind: ValueKind::Constant(u64::from(u32::from_be_bytes([i, j, k, l]))), scalar: Scalar::U32, span };
        let target = Place { offset: target.offset + 64, ..target.clone() };
        all.push(Statement { kind: StatementKind::Assign { target, value }, span });
        all
    }

    /// A DTL as an LDT, which can be compared and computed with; anything else as it is.
    pub(super) fn dtl_as_number(&mut self, typed: Typed, span: Span) -> Typed {
        match typed {
            Typed::Structured(nanoseconds, _) => {
                let value = Value { kind: ValueKind::Constant(nanoseconds), scalar: Scalar::U64, span };
                Typed::Scalar { value, data_type: DataType::LongDateAndTime }
            }
            Typed::Aggregate(target) if dtl::is_dtl(&target.data_type) => {
                self.by_block("DTL_TO_LDT", vec![(Typed::Aggregate(target), span)], span)
            }
            other => other,
        }
    }

    /// Whether something is a DTL.
    pub(super) fn is_dtl(typed: &Typed) -> bool {
        match typed {
            Typed::Structured(..) => true,
            Typed::Aggregate(target) => dtl::is_dtl(&target.data_type),
            _ => false,
        }
    }

    /// What a function of the library that is written in ST makes of arguments by position.
    pub(super) fn by_block(&mut self, function: &str, arguments: Vec<(Typed, Span)>, span: Span) -> Typed {
        let Some(block) = self.of_library(function) else { return self.not_built(span, "this instruction") };
        let Some(interface) = self.interface(block, span) else { return Typed::Poison };
        let unnamed =
            |(_, span): &(Typed, Span)| ast::Argument { name: None, direction: ast::Direction::Assigned, value: None, span: *span };
        let call =
            ast::Call { callee: Expression { kind: ExpressionKind::Missing, span }, arguments: arguments.iter().map(unnamed).collect() };
        self.block_function((block, None), &interface, &call, arguments, span)
    }

    /// A function of the library by its name.
    pub(super) fn of_library(&mut self, function: &str) -> Option<BlockId> {
        let provided = library::function(function, self.dialect)?;
        self.names.provided(&provided)
    }

    /// The block that delivers a structure where a standard function is assigned to one.
    pub(super) fn structured_function(&mut self, name: &Name, wanted: &DataType) -> Option<BlockId> {
        if name.quoting == Quoting::Global || self.is_inner(&name.text) {
            return None;
        }
        let by_type = DTL_FUNCTIONS.iter().find(|(one, _)| name.is(one) && dtl::is_dtl(wanted) && self.has_memory_functions());
        let provided = library::function(by_type.map_or(&name.text, |(_, block)| block), self.dialect)?;
        matches!(provided, standard::Provided::Source { .. }).then_some(())?;
        self.names.provided(&provided)
    }

    /// A call of T_CONV and its like as the call of the conversion that the wanted type asks for; `None` for anything else.
    pub(super) fn by_target(&mut self, expression: &Expression, wanted: &DataType) -> Option<Expression> {
        if !self.has_memory_functions() {
            return None;
        }
        let (name, call) = called_by_target(expression)?;
        let function = match name.text.to_ascii_uppercase().as_str() {
            "T_COMBINE" => match wanted {
                DataType::LongDateAndTime => "CONCAT_DATE_LTOD".to_owned(),
                DataType::DateAndTime => "CONCAT_DATE_TOD".to_owned(),
                _ => return None,
            },
            _ => {
                let [ast::Argument { value: Some(value), .. }] = call.arguments.as_slice() else { return None };
                let given = self.quietly(|checker| checker.type_of(value))?;
                if same_type(&given, wanted) {
                    return Some(value.clone());
                }
                format!("{}_TO_{}", word(&given)?, word(wanted)?)
            }
        };
        let callee = Name { text: function, ..name.clone() };
        let callee = Expression { kind: ExpressionKind::Name(callee), span: call.callee.span };
        let kind = ExpressionKind::Call(Box::new(ast::Call { callee, arguments: call.arguments.clone() }));
        Some(Expression { kind, span: expression.span })
    }

    /// The type of an expression that has one.
    fn type_of(&mut self, expression: &Expression) -> Option<DataType> {
        match self.reach(expression) {
            Reached::Target(target) => Some(target.data_type),
            Reached::Other(typed) => match super::functions::kind_of(&typed) {
                standard::GivenKind::Typed(data_type) => Some(data_type),
                standard::GivenKind::Integer { .. } => Some(DataType::DoubleInt),
                standard::GivenKind::Real => Some(DataType::Real),
                standard::GivenKind::Unknown => None,
            },
        }
    }

    /// T_CONV and its like where nothing says what their result is.
    pub(super) fn without_target(&mut self, name: &str, call: &ast::Call, span: Span) -> Option<Typed> {
        if !BY_TARGET.contains(&name) {
            return None;
        }
        self.look_at(&call.arguments);
        let message = format!("`{name}` has the type of what it is assigned to, and here nothing says what that is");
        self.report(Problem::P6320, span, message).help =
            Some("Assign it to a variable first, or write the conversion by its name, such as `DTL_TO_LDT`.".to_owned());
        Some(Typed::Poison)
    }

    /// A call of T_CONV and its like with OUT, as the assignment that it is; `None` for anything else.
    pub(super) fn by_output(&mut self, name: &Name, call: &ast::Call, span: Span) -> Option<Option<StatementKind>> {
        if !BY_TARGET.iter().any(|one| name.is(one)) || !self.has_memory_functions() {
            return None;
        }
        let is_output = |argument: &&ast::Argument| argument.name.as_ref().is_some_and(|name| name.is("OUT"));
        let target = call.arguments.iter().find(is_output).and_then(|argument| argument.value.clone())?;
        let arguments = call.arguments.iter().filter(|argument| !is_output(argument)).cloned().collect();
        let kind = ExpressionKind::Call(Box::new(ast::Call { callee: call.callee.clone(), arguments }));
        Some(self.assign(&target, &Expression { kind, span }, span))
    }
}

/// The name and the call, if an expression calls T_CONV or its like.
fn called_by_target(expression: &Expression) -> Option<(&Name, &ast::Call)> {
    let ExpressionKind::Call(call) = &expression.kind else { return None };
    let ExpressionKind::Name(name) = &call.callee.kind else { return None };
    (name.quoting != Quoting::Global && BY_TARGET.iter().any(|one| name.is(one))).then_some((name, call))
}
