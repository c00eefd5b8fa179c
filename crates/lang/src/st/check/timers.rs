//! IEC timers and counters of tia: IEC_TIMER, IEC_COUNTER and their like, whose calls say which one it is, RESET_TIMER and PRESET_TIMER.

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

/// A type that is the memory of several instructions.
struct Memory {
    name: &'static str,
    instructions: &'static [&'static str],
    /// What stands behind the instruction in the name of its block.
    suffix: &'static str,
    /// How a call of the first instruction looks.
    example: &'static str,
}

const TIMERS: &[&str] = &["TON", "TOF", "TP", "TONR"];
const COUNTERS: &[&str] = &["CTU", "CTD", "CTUD"];
const TIMER: &str = "IN := …, PT := …";
const COUNTER: &str = "CU := …, R := …, PV := …";

/// These types.
const MEMORIES: &[Memory] = &[
    Memory { name: "IEC_TIMER", instructions: TIMERS, suffix: "", example: TIMER },
    Memory { name: "IEC_LTIMER", instructions: TIMERS, suffix: "_LTIME", example: TIMER },
    Memory { name: "IEC_COUNTER", instructions: COUNTERS, suffix: "_INT", example: COUNTER },
    Memory { name: "IEC_SCOUNTER", instructions: COUNTERS, suffix: "_SINT", example: COUNTER },
    Memory { name: "IEC_DCOUNTER", instructions: COUNTERS, suffix: "_DINT", example: COUNTER },
    Memory { name: "IEC_USCOUNTER", instructions: COUNTERS, suffix: "_USINT", example: COUNTER },
    Memory { name: "IEC_UCOUNTER", instructions: COUNTERS, suffix: "_UINT", example: COUNTER },
    Memory { name: "IEC_UDCOUNTER", instructions: COUNTERS, suffix: "_UDINT", example: COUNTER },
];

impl Checker<'_> {
    /// What instances of a block are the memory of.
    fn memory(&self, block: BlockId) -> Option<&'static Memory> {
        let name = self.names.is_of_library(block).then(|| self.names.block_name(block))?;
        MEMORIES.iter().find(|memory| name.eq_ignore_ascii_case(memory.name))
    }

    /// The block that `name` makes of an IEC_TIMER or an IEC_COUNTER: `TON` of `t.TON(…)`.
    pub(super) fn memory_instruction(&mut self, block: BlockId, name: &Name) -> Option<BlockId> {
        let memory = self.memory(block)?;
        let instruction = memory.instructions.iter().find(|instruction| name.is(instruction))?;
        // Counters have one layout here, which is none of those that they have by themselves.
        let family = if memory.instructions == COUNTERS { "IEC_" } else { "" };
        self.of_library(&format!("{family}{instruction}{}", memory.suffix))
    }

    /// Whether a call does not say which instruction works on such a memory, or names none; that is said.
    pub(super) fn no_memory_instruction(&mut self, block: BlockId, target: &Target, name: Option<&Name>, span: Span) -> bool {
        let Some(memory) = self.memory(block) else { return false };
        let message = match name {
            Some(name) => format!("`{}` is an {}, which has no instruction `{}`", target.name, memory.name, name.text),
            None => format!("`{}` is an {}, and the call does not say which instruction it is", target.name, memory.name),
        };
        let first = memory.instructions[0];
        let help = format!("Write `{}.{first}({})`; there are {}.", target.name, memory.example, memory.instructions.join(", "));
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
