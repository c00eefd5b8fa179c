//! GET_ERROR and GET_ERR_ID of tia: a block with one of them handles its errors itself.

use sieben_engine::ir::Op;
use sieben_model::extension::FIRST_ERROR;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::calls::after;
use super::memory::number;
use super::names::Names;
use super::typed::Typed;
use super::types::Kind;
use super::{Block, Checker, walk};
use crate::st::ast::{self, ExpressionKind, Quoting};
use crate::st::dialect::{Construct, Judgement};
use crate::st::error_struct::{BYTES, TOLD, is_error_struct};
use crate::st::standard::build::compute;
use crate::st::tree::{Argument, Call, Callee, Place, Scalar, Statement, StatementKind, Value, ValueKind};

/// The functions that ask for the first error.
pub(super) const NUMBER: &str = "GET_ERR_ID";
pub(super) const STRUCTURE: &str = "GET_ERROR";

/// Whether a call of the block asks for its first error, and not for a block of this name.
pub(super) fn asks_for_errors(block: &Block<'_>, names: &dyn Names) -> bool {
    let mut found = false;
    if block.dialect.judge(Construct::PeekPoke) != Judgement::Accept {
        return false;
    }
    let mut see = |expression: &ast::Expression| {
        if let ExpressionKind::Call(call) = &expression.kind
            && let ExpressionKind::Name(name) = &call.callee.kind
        {
            found |=
                name.quoting != Quoting::Global && [NUMBER, STRUCTURE].iter().any(|word| name.is(word) && names.global(word).is_none());
        }
    };
    walk::expressions(block.body, &mut see);
    block.actions.iter().for_each(|action| walk::expressions(&action.body, &mut see));
    found
}

impl Checker<'_> {
    /// The number of the first error.
    pub(super) fn error_number(&mut self, call: &ast::Call, span: Span) -> Option<Typed> {
        self.named(NUMBER, call, &[], span)?;
        let (asked, place) = self.first_error(span)?;
        let value = Value { kind: ValueKind::Load(place), scalar: Scalar::U16, span };
        Some(Typed::Scalar { value: after(vec![asked], value), data_type: DataType::Word })
    }

    /// The first error as a structure, which stays as it is if there was none.
    pub(super) fn error_as_structure(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let given = self.named(STRUCTURE, call, &["ERROR"], span)?;
        let target = self.target(given[0])?;
        if !is_error_struct(&target.data_type) {
            let message =
                format!("`{STRUCTURE}` tells an error as an ErrorStruct, and `{}` is {}", target.name, self.words(&target.data_type));
            self.report(Problem::P4011, given[0].span, message).help =
                Some(format!("Declare it as ErrorStruct, or take the number alone: `id := {NUMBER}();`."));
            return None;
        }
        let (asked, source) = self.first_error(span)?;
        let id = Value { kind: ValueKind::Load(source.clone()), scalar: Scalar::U16, span };
        let none = compute(Op::Equal, vec![id, number(0, Scalar::U16, span)], Scalar::Bool, span);
        let copy = Statement { kind: StatementKind::Copy { target: target.place, source, bytes: BYTES }, span };
        let told = StatementKind::If { branches: vec![(none, Vec::new())], otherwise: vec![copy] };
        Some(StatementKind::Block(vec![asked, Statement { kind: told, span }]))
    }

    /// Asks for the first error: it lies in the local data behind the statement, all 0 if there was none.
    fn first_error(&mut self, span: Span) -> Option<(Statement, Place)> {
        let interface = self.interface(FIRST_ERROR, span)?;
        let place = self.temporary_place(BYTES, span);
        let arguments = interface.parameters().zip(TOLD).filter_map(|(formal, byte)| {
            let scalar = Kind::of(&formal.data_type)?.scalar(self.dialect);
            let target = Place { offset: place.offset + byte * 8, ..place.clone() };
            Some(Argument::Output { parameter: formal.offset, scalar, target, convert: Vec::new(), converted: scalar })
        });
        let call = Call::plain(Callee::Function(FIRST_ERROR), arguments.collect(), span);
        Some((Statement { kind: StatementKind::Call(call), span }, place))
    }
}
