//! IEC timers of tia: IEC_TIMER, whose calls say which timer it is, RESET_TIMER and PRESET_TIMER.

use sieben_model::block::BlockId;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::Checker;
use super::places::Reached;
use super::typed::{Target, Typed};
use super::types::Kind;
use crate::st::ast::{self, Expression, Name};
use crate::st::tree::{Place, Statement, StatementKind, Value, ValueKind};

/// The type that is the memory of any timer.
const ANY_TIMER: &str = "IEC_TIMER";

/// The instructions that work on it.
const INSTRUCTIONS: [&str; 4] = ["TON", "TOF", "TP", "TONR"];

impl Checker<'_> {
    /// Whether instances of a block are the memory of any timer.
    fn is_any_timer(&self, block: BlockId) -> bool {
        self.names.is_of_library(block) && self.names.block_name(block).eq_ignore_ascii_case(ANY_TIMER)
    }

    /// The timer that `name` makes of an IEC_TIMER: `TON` of `t.TON(…)`.
    pub(super) fn timer_instruction(&mut self, block: BlockId, name: &Name) -> Option<BlockId> {
        if !self.is_any_timer(block) {
            return None;
        }
        let instruction = INSTRUCTIONS.iter().find(|instruction| name.is(instruction))?;
        self.of_library(instruction)
    }

    /// Whether a call does not say which timer an IEC_TIMER is, or names none; that is said.
    pub(super) fn no_timer_instruction(&mut self, block: BlockId, target: &Target, span: Span) -> bool {
        if !self.is_any_timer(block) {
            return false;
        }
        let message = format!("`{}` is an IEC_TIMER, and the call does not say which timer it is to be", target.name);
        let help = format!("Write `{}.TON(IN := …, PT := …)`; there are TON, TOF, TP and TONR.", target.name);
        self.report(Problem::P6321, span, message).help = Some(help);
        true
    }

    /// `RESET_TIMER(t)`: the timer begins anew, as if it had never run.
    pub(super) fn reset_timer(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let given = self.named("RESET_TIMER", call, &["TIMER"], span)?;
        let timer = self.timer("RESET_TIMER", given[0])?;
        let DataType::Instance { structure, .. } = &timer.data_type else { return None };
        let clear = |field: &sieben_model::types::Field| {
            let scalar = Kind::of(&field.data_type)?.scalar(self.dialect);
            let value = Value { kind: ValueKind::Constant(0), scalar, span };
            Some(Statement { kind: StatementKind::Assign { target: field_of(&timer, field.offset), value }, span })
        };
        Some(StatementKind::Block(structure.fields.iter().filter_map(clear).collect()))
    }

    /// `PRESET_TIMER(PT := d, TIMER := t)`: another duration, from now on.
    pub(super) fn preset_timer(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let given = self.named("PRESET_TIMER", call, &["PT", "TIMER"], span)?;
        let timer = self.timer("PRESET_TIMER", given[1])?;
        let DataType::Instance { structure, .. } = &timer.data_type else { return None };
        let preset = structure.field("PT")?;
        let value = self.value(given[0], &preset.data_type)?;
        let (keep, value) = self.kept(value);
        let fields = ["PT", "LIMIT_PT"].into_iter().filter_map(|name| structure.field(name));
        let write = |field: &sieben_model::types::Field| Statement {
            kind: StatementKind::Assign { target: field_of(&timer, field.offset), value: value.clone() },
            span,
        };
        let mut statements = vec![keep];
        statements.extend(fields.map(write));
        Some(StatementKind::Block(statements))
    }

    /// An instance of a timer of the library.
    fn timer(&mut self, function: &str, expression: &Expression) -> Option<Target> {
        let target = match self.reach(expression) {
            Reached::Target(target) => target,
            Reached::Other(Typed::Block(block)) => self.data_block(block, expression.span)?,
            Reached::Other(Typed::Poison) => return None,
            Reached::Other(other) => {
                let what = self.what(&other);
                self.report(Problem::P4011, expression.span, format!("`{function}` takes an IEC timer, not {what}"));
                return None;
            }
        };
        if let DataType::Instance { block, structure } = &target.data_type
            && self.names.is_of_library(*block)
            && structure.field("LIMIT_PT").is_some()
        {
            return Some(target);
        }
        let message = format!("`{function}` takes an IEC timer, and `{}` is {}", target.name, self.words(&target.data_type));
        self.report(Problem::P4011, expression.span, message).help =
            Some("IEC timers are TON, TOF, TP and TONR, their forms with a type, and IEC_TIMER.".to_owned());
        None
    }
}

/// Where a field of an instance lies.
fn field_of(instance: &Target, offset: u32) -> Place {
    Place { offset: instance.place.offset + offset, ..instance.place.clone() }
}
