//! Calls of the timers and counters of S5: `S_ODT(T_NO := T5, S := start, TV := T#5s, R := reset, BI := left, Q := done)`.

use sieben_engine::intrinsics::Intrinsic;
use sieben_model::literal::s5time_word;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::typed::Typed;
use super::types::Kind;
use super::{Checker, operators};
use crate::declarations::values::shortened_s5time;
use crate::st::ast::{self, Direction, Expression, Name};
use crate::st::dialect::Construct;
use crate::st::standard::s5::S5Function;
use crate::st::tree::{Scalar, Statement, StatementKind, Value, ValueKind};

impl Checker<'_> {
    /// What the call does, and its result; `None`: something is wrong, which is reported.
    pub(super) fn s5_function(
        &mut self,
        function: &'static S5Function,
        name: &Name,
        call: &ast::Call,
        span: Span,
    ) -> Option<(Vec<Statement>, Value)> {
        let arguments = self.s5_arguments(function, name, call)?;
        let given = |wanted: &str| arguments.iter().find(|(parameter, ..)| *parameter == wanted).map(|(_, value)| *value);
        let device = function.device;
        let Some(number) = given(device.number) else {
            self.report(Problem::P3010, span, format!("`{}` is called without `{}`", name.text, device.number));
            return None;
        };
        let mut out = Vec::new();
        let number = self.s5_number(number, &device.data_type, &mut out)?;
        for step in function.steps {
            let preset = step.preset.as_ref().map(|(preset, data_type)| (*preset, data_type, given(preset)));
            let trigger = match (given(step.trigger), &preset) {
                (None, Some((preset, _, Some(_)))) => {
                    let message = format!("`{}` is called with `{preset}`, but without `{}`", name.text, step.trigger);
                    self.report(Problem::P3010, span, message).help =
                        Some("Give both, or leave both out to ask only for the state.".to_owned());
                    return None;
                }
                (None, _) => continue,
                (Some(_), Some((preset, _, None))) => {
                    let message = format!("`{}` is called with `{}`, but without `{preset}`", name.text, step.trigger);
                    self.report(Problem::P3010, span, message).help =
                        Some("Give both, or leave both out to ask only for the state.".to_owned());
                    return None;
                }
                (Some(trigger), _) => trigger,
            };
            let mut args = vec![number.clone(), self.value(trigger, &DataType::Bool)?];
            if let Some((_, data_type, Some(preset))) = preset {
                args.push(self.s5_preset(preset, data_type)?);
            }
            out.push(Statement { kind: StatementKind::Intrinsic { intrinsic: step.intrinsic, args }, span });
        }
        let deliver = |intrinsic: Intrinsic, data_type: &DataType| {
            let scalar = if *data_type == DataType::Bool { Scalar::Bool } else { Scalar::U16 };
            Value { kind: ValueKind::Intrinsic { intrinsic, args: vec![number.clone()] }, scalar, span }
        };
        let mut sound = true;
        for (output, data_type, intrinsic) in device.outputs {
            if let Some(target) = given(output) {
                sound &= self.s5_output(target, data_type, deliver(*intrinsic, data_type), &mut out);
            }
        }
        let (data_type, intrinsic) = &device.result;
        sound.then(|| (out, deliver(*intrinsic, data_type)))
    }

    /// The arguments by the names of their parameters.
    fn s5_arguments<'c>(
        &mut self,
        function: &'static S5Function,
        name: &Name,
        call: &'c ast::Call,
    ) -> Option<Vec<(&'static str, &'c Expression)>> {
        let parameters = function.parameters();
        let outputs = function.device.outputs;
        let mut given: Vec<(&'static str, &Expression)> = Vec::new();
        for (index, argument) in call.arguments.iter().enumerate() {
            let parameter = match &argument.name {
                Some(name) => parameters.iter().copied().find(|parameter| name.is(parameter)),
                None => parameters.get(index).copied(),
            };
            let list = || parameters.iter().map(|parameter| format!("`{parameter}`")).collect::<Vec<_>>().join(", ");
            let Some(parameter) = parameter else {
                let shown = argument
                    .name
                    .as_ref()
                    .map_or_else(|| format!("so many parameters: {}", call.arguments.len()), |name| format!("parameter `{}`", name.text));
                self.report(Problem::P3009, argument.span, format!("`{}` does not have {shown}", name.text)).help =
                    Some(format!("It has {}.", list()));
                return None;
            };
            let Some(value) = &argument.value else { continue };
            let is_output = outputs.iter().any(|(output, ..)| *output == parameter);
            match argument.direction {
                Direction::Delivered if !is_output => {
                    let message = format!("`{parameter}` is no output, and `=>` takes a value out");
                    self.report(Problem::P6219, argument.span, message).help = Some(format!("Write `{parameter} := …`."));
                    return None;
                }
                Direction::Assigned if is_output && argument.name.is_some() && !self.judge(Construct::AssignedOutput, argument.span) => {
                    return None;
                }
                _ => {}
            }
            if given.iter().any(|(one, _)| *one == parameter) {
                self.report(Problem::P3011, argument.span, format!("the parameter `{parameter}` is given twice"));
                return None;
            }
            given.push((parameter, value));
        }
        Some(given)
    }

    /// T5, a parameter of type TIMER, or a computed number.
    fn s5_number(&mut self, expression: &Expression, wanted: &DataType, before: &mut Vec<Statement>) -> Option<Value> {
        let value = match self.expression(expression) {
            Typed::Number { data_type, value } if data_type == *wanted => value,
            typed @ (Typed::Integer { .. } | Typed::Scalar { .. }) => {
                let number = match &typed {
                    Typed::Scalar { data_type: DataType::Word, .. } => DataType::Word,
                    _ => DataType::Int,
                };
                operators::convert(self.coerce(typed, expression.span, &number)?, Scalar::U16)
            }
            Typed::Poison => return None,
            other => {
                let what = self.what(&other);
                let shown = if *wanted == DataType::Timer { "a timer such as `T5`" } else { "a counter such as `C5`" };
                self.report(Problem::P4011, expression.span, format!("{shown} or its number is wanted here, not {what}"));
                return None;
            }
        };
        Some(match value.kind {
            ValueKind::Constant(_) | ValueKind::NumberParameter(_) => value,
            _ => {
                let (statement, kept) = self.kept(value);
                before.push(statement);
                kept
            }
        })
    }

    /// The time or the count to begin with. A constant of type TIME stands for an S5TIME.
    fn s5_preset(&mut self, expression: &Expression, wanted: &DataType) -> Option<Value> {
        let typed = self.expression_for(expression, wanted);
        if let (Typed::Scalar { value: Value { kind: ValueKind::Constant(bits), .. }, data_type: DataType::Time }, DataType::S5Time) =
            (&typed, wanted)
        {
            let milliseconds = *bits as u32 as i32;
            let Some(word) = u64::try_from(milliseconds).ok().and_then(s5time_word) else {
                let message = format!("a time of {milliseconds} ms does not fit an S5TIME, which goes from 0 ms to 2h46m30s");
                self.report(Problem::P4001, expression.span, message);
                return None;
            };
            if let Some(message) = u64::try_from(milliseconds).ok().and_then(|time| shortened_s5time(&format!("T#{time}ms"), time)) {
                self.report(Problem::P5029, expression.span, message);
            }
            return Some(Value { kind: ValueKind::Constant(u64::from(word)), scalar: Scalar::U16, span: expression.span });
        }
        self.coerce(typed, expression.span, wanted)
    }

    fn s5_output(&mut self, expression: &Expression, data_type: &DataType, value: Value, out: &mut Vec<Statement>) -> bool {
        let Some(target) = self.target(expression) else { return false };
        if Kind::of(&target.data_type).is_none() {
            let message = format!("the output is {}, and `{}` is {}", self.words(data_type), target.name, self.words(&target.data_type));
            self.report(Problem::P4011, expression.span, message);
            return false;
        }
        let span = expression.span;
        let typed = Typed::Scalar { value: Value { span, ..value }, data_type: data_type.clone() };
        let Some(value) = self.coerce(typed, span, &target.data_type) else { return false };
        out.push(Statement { kind: StatementKind::Assign { target: target.place, value }, span });
        true
    }
}
