//! What codesys asks of interfaces and references: `__QUERYINTERFACE`, `__QUERYPOINTER`, `__ISVALIDREF`; and what has no place here, such as
//! `__NEW`.

use sieben_engine::ir::Op;
use sieben_model::block::BlockId;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, ReferenceKind};

use super::Checker;
use super::calls::after;
use super::members::interface_of;
use super::names::Role;
use super::places::Reached;
use super::typed::{Target, Through, Typed};
use crate::st::ast::{self, Expression, Name};
use crate::st::tree::{Base, Place, Scalar, Statement, StatementKind, Value, ValueKind};

/// Functions of the system that are not there, and what does the same.
const ABSENT: &[(&str, &str)] = &[
    ("__NEW", "Declare an array of them, and keep which elements are in use: a CPU has no memory that is made while the program runs."),
    ("__DELETE", "Declare an array of them, and keep which elements are in use: a CPU has no memory that is made while the program runs."),
    ("__VARINFO", "Write the name, the type or the address as a constant."),
    ("__POUNAME", "Write the name as a text."),
    ("__POSITION", "Write the place as a text."),
    ("__CURRENTTASK", "Give each task a variable that says which one it is."),
    ("__XADD", "Write `x := x + y`: a task is interrupted between two statements, never in one."),
    ("TEST_AND_SET", "Write `old := x; x := TRUE`, or use SEMA."),
];

/// The same of tia.
const ABSENT_OF_TIA: &[(&str, &str)] = &[
    ("TypeOfDB", "Give the data block itself as VARIANT and ask TypeOf."),
    ("JOIN", "Join the texts with CONCAT."),
    ("SPLIT", "Look for the separator with FIND and take the parts with MID."),
    ("GetSymbolName", "Write the name as a text."),
    ("GetInstanceName", "Write the name as a text."),
    ("GetInstancePath", "Write the name as a text."),
];

impl Checker<'_> {
    /// A query; `None` for other names.
    pub(super) fn query(&mut self, name: &Name, call: &ast::Call, span: Span) -> Option<Typed> {
        if self.has_memory_functions()
            && let Some((absent, help)) = ABSENT_OF_TIA.iter().find(|(absent, _)| name.is(absent))
        {
            self.look_at(&call.arguments);
            self.report(Problem::P6323, name.span, format!("`{absent}` does not exist here")).help = Some((*help).to_owned());
            return Some(Typed::Poison);
        }
        if !self.dialect.has_pointers() {
            return None;
        }
        if let Some((absent, help)) = ABSENT.iter().find(|(absent, _)| name.is(absent)) {
            self.report(Problem::P6323, name.span, format!("`{absent}` does not exist here")).help = Some((*help).to_owned());
            return Some(Typed::Poison);
        }
        let found = match name.text.to_ascii_uppercase().as_str() {
            "__QUERYINTERFACE" => self.query_interface(call, span),
            "__QUERYPOINTER" => self.query_pointer(call, span),
            "__ISVALIDREF" => self.is_valid_reference(call, span),
            _ => return None,
        };
        Some(found.unwrap_or(Typed::Poison))
    }

    /// Whether what an interface refers to has another one too, to which the second argument refers from then on.
    fn query_interface(&mut self, call: &ast::Call, span: Span) -> Option<Typed> {
        let [from, to] = self.two_arguments("__QUERYINTERFACE", call, span)?;
        let (mut before, source, of) = self.queried("__QUERYINTERFACE", from)?;
        let target = self.interface_variable("__QUERYINTERFACE", to)?;
        let place = target.place.clone();
        let kind = self.attempted(target, source, Some(of), span)?;
        before.push(Statement { kind, span });
        Some(is_set(before, place, span))
    }

    /// A pointer to what an interface refers to.
    fn query_pointer(&mut self, call: &ast::Call, span: Span) -> Option<Typed> {
        let [from, to] = self.two_arguments("__QUERYPOINTER", call, span)?;
        let (mut before, value, _) = self.queried("__QUERYPOINTER", from)?;
        let target = self.target(to)?;
        if !matches!(&target.data_type, DataType::Reference(reference) if reference.kind == ReferenceKind::Pointer) {
            let message = format!("`__QUERYPOINTER` writes a POINTER, and `{}` is {}", target.name, self.words(&target.data_type));
            self.report(Problem::P4011, to.span, message);
            return None;
        }
        let kind = StatementKind::Assign { target: target.place.clone(), value };
        before.push(Statement { kind, span });
        Some(is_set(before, target.place, span))
    }

    /// Whether a REFERENCE TO refers to something.
    fn is_valid_reference(&mut self, call: &ast::Call, span: Span) -> Option<Typed> {
        let [ast::Argument { value: Some(argument), .. }] = call.arguments.as_slice() else {
            self.look_at(&call.arguments);
            self.report(Problem::P6219, span, "`__ISVALIDREF` takes one parameter, a REFERENCE TO");
            return None;
        };
        let is_alias =
            |data_type: &DataType| matches!(data_type, DataType::Reference(reference) if reference.kind == ReferenceKind::Reference);
        let typed = match self.reach_itself(argument) {
            Reached::Target(target) if is_alias(&target.data_type) => return Some(is_set(Vec::new(), target.place, span)),
            // What a function or a property delivers.
            Reached::Other(Typed::Scalar { value, data_type }) if is_alias(&data_type) => return Some(is_not_null(value, span)),
            // A call gives every VAR_IN_OUT a variable.
            Reached::Target(Target { role, through: Through::Itself, place, .. })
                if role == Role::InOut || matches!(place.base, Base::ComplexParameter(_) | Base::InstancePointer(_)) =>
            {
                let value = Value { kind: ValueKind::Constant(1), scalar: Scalar::Bool, span };
                return Some(Typed::Scalar { value, data_type: DataType::Bool });
            }
            Reached::Target(_) => Typed::Null,
            Reached::Other(typed) => typed,
        };
        if typed != Typed::Poison {
            self.report(Problem::P4011, argument.span, "`__ISVALIDREF` takes a variable that is declared as REFERENCE TO").help =
                Some("A pointer is compared with 0, an interface too.".to_owned());
        }
        None
    }

    fn two_arguments<'c>(&mut self, function: &str, call: &'c ast::Call, span: Span) -> Option<[&'c Expression; 2]> {
        if let [ast::Argument { value: Some(from), .. }, ast::Argument { value: Some(to), .. }] = call.arguments.as_slice() {
            return Some([from, to]);
        }
        self.look_at(&call.arguments);
        self.report(Problem::P6219, span, format!("`{function}` takes two parameters"));
        None
    }

    /// What is asked for an interface or a pointer: an interface, whatever delivers it, or an instance. The statements that keep it, its
    /// address, and the block that it is known to be.
    fn queried(&mut self, function: &str, expression: &Expression) -> Option<(Vec<Statement>, Value, BlockId)> {
        let span = expression.span;
        let (value, block) = match self.expression(expression) {
            Typed::Poison => return None,
            Typed::Scalar { value, data_type } if let Some(block) = interface_of(&data_type) => (value, block),
            Typed::Aggregate(Target { place, data_type: DataType::Instance { block, .. }, .. }) => {
                (Value { kind: ValueKind::AddressOf(place), scalar: Scalar::U64, span }, block)
            }
            other => {
                let message = format!("`{function}` takes an interface or an instance, and this is {}", self.what(&other));
                self.report(Problem::P4011, span, message);
                return None;
            }
        };
        if matches!(value.kind, ValueKind::Load(_)) {
            return Some((Vec::new(), value, block));
        }
        let (statement, kept) = self.kept(value);
        Some((vec![statement], kept, block))
    }

    /// A variable that is an interface.
    fn interface_variable(&mut self, function: &str, expression: &Expression) -> Option<Target> {
        let target = self.target(expression)?;
        if interface_of(&target.data_type).is_none() {
            let message =
                format!("`{function}` takes a variable that is an interface, and `{}` is {}", target.name, self.words(&target.data_type));
            self.report(Problem::P4011, expression.span, message);
            return None;
        }
        Some(target)
    }
}

/// Whether a reference is not NULL after the statements.
fn is_set(before: Vec<Statement>, place: Place, span: Span) -> Typed {
    let load = Value { kind: ValueKind::Load(place), scalar: Scalar::U64, span };
    match is_not_null(load, span) {
        Typed::Scalar { value, data_type } => Typed::Scalar { value: after(before, value), data_type },
        other => other,
    }
}

/// Whether a reference refers to something.
fn is_not_null(reference: Value, span: Span) -> Typed {
    let null = Value { kind: ValueKind::Constant(0), scalar: Scalar::U64, span };
    let value = Value { kind: ValueKind::Compute { op: Op::Differ, args: vec![reference, null] }, scalar: Scalar::Bool, span };
    Typed::Scalar { value, data_type: DataType::Bool }
}
