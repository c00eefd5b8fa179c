//! Traps: a timer that is called twice on one path, and inputs that are written.

use sieben_engine::intrinsics::Intrinsic;
use sieben_model::address::Area;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::Section;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::Checker;
use crate::st::tree::visit::{self, Extent, Use, Visit};
use crate::st::tree::{Argument, Base, Body, Call, Callee, Place, Statement, StatementKind, Value, ValueKind};

impl Checker<'_> {
    /// Says which statements of a block without errors do something else than they seem to. Tests write inputs and call what they like.
    pub(super) fn traps(&mut self, body: &Body) {
        if self.dialect.is_test() {
            return;
        }
        let mut inputs = Inputs::default();
        visit::statements(&mut inputs, &body.statements);
        for span in inputs.written {
            self.report(Problem::P5028, span, "an input is written: the CPU reads the inputs anew before the next scan");
        }
        let mut has_labels = HasLabels(false);
        visit::statements(&mut has_labels, &body.statements);
        if !has_labels.0 {
            self.driven(&body.statements, &mut Vec::new());
        }
    }

    /// Reports timers that are driven again after `before`; whether the statements come to their end.
    fn driven<'t>(&mut self, statements: &'t [Statement], before: &mut Vec<Driven<'t>>) -> bool {
        for statement in statements {
            match &statement.kind {
                StatementKind::Call(call) => self.called_again(call, before),
                StatementKind::Intrinsic { intrinsic: Intrinsic::TimerStart(_), args } => self.started_again(statement.span, args, before),
                // A function of S5 in an expression: its steps come before the value.
                StatementKind::Assign { value: Value { kind: ValueKind::After(steps, _), .. }, .. } => {
                    self.driven(steps, before);
                }
                StatementKind::Return | StatementKind::Exit { .. } | StatementKind::Continue { .. } => return false,
                _ => {}
            }
            // What an arm drives comes before what follows, but before no other arm: their conditions may exclude each other.
            let certain: Vec<Driven<'t>> = before.iter().filter(|one| !one.in_arm).cloned().collect();
            let mut after = Vec::new();
            for body in statement.kind.bodies() {
                let mut inside = certain.clone();
                if self.driven(body, &mut inside) {
                    after.extend(inside.drain(certain.len()..).map(|one| Driven { in_arm: true, ..one }));
                }
            }
            before.extend(after);
        }
        true
    }

    /// The call of an instance of an IEC timer or counter whose trigger is computed; a constant makes it ready for the next time.
    fn called_again<'t>(&mut self, call: &'t Call, before: &mut Vec<Driven<'t>>) {
        let Callee::Instance { block, instance, dispatch: None } = &call.callee else { return };
        if !self.is_iec_timer(*block) || !instance.indexes.is_empty() || call.enable.is_some() {
            return;
        }
        for (parameter, trigger) in self.triggers(*block, call) {
            let what = What::Instance { base: &instance.base, offset: instance.offset, parameter };
            let first = before.iter().find(|one| one.what == what && one.trigger.is_some_and(|other| differ(other, trigger)));
            match first.map(|first| first.span) {
                Some(first) => {
                    let message = "this instance is called twice on this path: each time it sees the edges that the other call makes";
                    self.report(Problem::P5022, call.span, message).related.push((first, "the first time".to_owned()));
                }
                None => before.push(Driven { what, trigger: Some(trigger), span: call.span, in_arm: false }),
            }
        }
    }

    /// A timer of S5 that is started again.
    fn started_again<'t>(&mut self, span: Span, args: &'t [Value], before: &mut Vec<Driven<'t>>) {
        let Some(&Value { kind: ValueKind::Constant(number), .. }) = args.first() else { return };
        let what = What::Timer(number);
        match before.iter().find(|one| one.what == what).map(|first| first.span) {
            Some(first) => {
                let message = format!("`T{number}` is started twice on this path: each time it sees the edges that the other start makes");
                self.report(Problem::P5022, span, message).related.push((first, "the first time".to_owned()));
            }
            None => before.push(Driven { what, trigger: None, span, in_arm: false }),
        }
    }

    fn is_iec_timer(&self, block: BlockId) -> bool {
        // CTU, CTD, CTUD, TP, TON, TOF.
        let of_system = block.kind == BlockKind::SystemFunctionBlock && block.number <= 5;
        of_system
            || self.names.is_of_library(block) && {
                let name = self.names.block_name(block).to_ascii_uppercase();
                ["TP", "TON", "TOF", "TONR", "CTU", "CTD", "CTUD"]
                    .iter()
                    .any(|family| name.strip_prefix(family).is_some_and(|rest| rest.is_empty() || rest.starts_with('_')))
            }
    }

    /// The computed values of the inputs whose edges count.
    fn triggers<'t>(&self, block: BlockId, call: &'t Call) -> Vec<(u32, &'t Value)> {
        let Some(interface) = self.names.interface(block) else { return Vec::new() };
        let counts = |position: u32| {
            interface.parameters().any(|one| {
                let name = one.name.to_ascii_uppercase();
                one.section == Section::Input
                    && one.data_type == DataType::Bool
                    && one.offset == position
                    && matches!(&*name, "IN" | "CU" | "CD")
            })
        };
        let given = call.arguments.iter().filter_map(|argument| match argument {
            Argument::Value { parameter, value } if counts(*parameter) && !matches!(value.kind, ValueKind::Constant(_)) => {
                Some((*parameter, value))
            }
            _ => None,
        });
        given.collect()
    }
}

/// Something that was driven.
#[derive(Clone)]
struct Driven<'t> {
    what: What<'t>,
    trigger: Option<&'t Value>,
    span: Span,
    /// It was driven in an arm of an IF or CASE, or in a loop.
    in_arm: bool,
}

/// A timer, or an input of an instance.
#[derive(Clone, PartialEq)]
enum What<'t> {
    Timer(u64),
    Instance { base: &'t Base, offset: u32, parameter: u32 },
}

/// Whether two values are certain to be written differently: other variables, or other operations.
fn differ(one: &Value, other: &Value) -> bool {
    match (&one.kind, &other.kind) {
        (ValueKind::Load(one), ValueKind::Load(other)) => one.base != other.base || one.offset != other.offset,
        (ValueKind::Compute { op, args }, ValueKind::Compute { op: other_op, args: other_args }) => {
            op != other_op || args.iter().zip(other_args).any(|(one, other)| differ(one, other))
        }
        (ValueKind::Load(_), ValueKind::Compute { .. }) | (ValueKind::Compute { .. }, ValueKind::Load(_)) => true,
        (ValueKind::Constant(one), ValueKind::Constant(other)) => one != other,
        _ => false,
    }
}

/// The places in I that are written.
#[derive(Default)]
struct Inputs {
    written: Vec<Span>,
}

impl<'t> Visit<'t> for Inputs {
    fn place(&mut self, place: &'t Place, how: Use, _: Extent<'t>) {
        if how == Use::Write && place.base == Base::Area(Area::Input) && !self.written.contains(&place.span) {
            self.written.push(place.span);
        }
        visit::indexes(self, place);
    }
}

/// Whether a body has labels: jumps make paths that the order of the source does not show.
struct HasLabels(bool);

impl<'t> Visit<'t> for HasLabels {
    fn statement(&mut self, statement: &'t Statement) {
        self.0 |= matches!(statement.kind, StatementKind::Label(_));
        visit::statement(self, statement);
    }
}
