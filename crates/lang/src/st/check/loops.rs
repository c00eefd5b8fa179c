//! FOR and CASE.

use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::names::Entity;
use super::ranges::{Known, signed};
use super::typed::Typed;
use super::types::{Class, Kind, bounds};
use super::{Checker, Loop, walk};
use crate::st::ast::{self, AssignOperator, CaseArm, CaseLabel, Direction, Expression, ExpressionKind};
use crate::st::dialect::{Construct, ForBounds, Judgement};
use crate::st::tree::{Branch, For, Place, Statement, StatementKind, Value, ValueKind};

impl Checker<'_> {
    /// The body of a loop.
    pub(super) fn body_of_loop(&mut self, control: Option<(String, Place)>, body: &[ast::Statement]) -> Vec<Statement> {
        self.loops.push(Loop { control });
        let body = self.statements(body);
        self.loops.pop();
        body
    }

    /// FOR.
    pub(super) fn for_loop(
        &mut self,
        variable: &Expression,
        from: &Expression,
        to: &Expression,
        by: Option<&Expression>,
        body: &[ast::Statement],
    ) -> Option<StatementKind> {
        let target = self.target(variable);
        let Some(target) = target else {
            [from, to].into_iter().chain(by).for_each(|value| drop(self.expression(value)));
            self.body_of_loop(None, body);
            return None;
        };
        let kind = Kind::of(&target.data_type).filter(|kind| {
            kind.is_integer() || kind.class == Class::Bits && *kind != Kind::BOOL && self.dialect.switches().integer_bits_min > 8
        });
        let Some(kind) = kind.filter(|_| !matches!(target.data_type, DataType::Enumeration(_))) else {
            let message = format!("FOR counts with an integer, and `{}` is {}", target.name, self.words(&target.data_type));
            self.report(Problem::P6210, variable.span, message);
            self.body_of_loop(None, body);
            return None;
        };
        let scalar = kind.scalar(self.dialect);
        let (first, last) = (self.counted(from, &target.data_type), self.counted(to, &target.data_type));
        let step = match by {
            Some(by) => self.counted(by, &target.data_type),
            None => Some(Value { kind: ValueKind::Constant(1), scalar, span: variable.span }),
        };
        let ends = first.as_ref().zip(last.as_ref()).map(|(first, last)| (self.range_of(first), self.range_of(last)));
        let constant = |value: &Option<Value>| match value {
            Some(Value { kind: ValueKind::Constant(word), .. }) => Some(signed(*word, scalar)),
            _ => None,
        };
        if let (Some(0), Some(by)) = (constant(&step), by) {
            self.report(Problem::P6211, by.span, "a step of 0 never ends the loop");
        }
        let (low, high) = bounds(scalar);
        let up = constant(&step).filter(|&step| step != 0).map(|step| step > 0);
        let reaches_end = match (up, constant(&last)) {
            (Some(true), Some(last)) => last == high,
            (Some(false), Some(last)) => last == low,
            _ => false,
        };
        if reaches_end && self.dialect.switches().integer_bits_min > 8 {
            let message =
                format!("the last value is the end of {}: on other controllers this loop may never end", self.words(&target.data_type));
            self.report(Problem::P6212, to.span, message);
        }
        if let (Some(first), Some(last), Some(up)) = (constant(&first), constant(&last), up)
            && (if up { first > last } else { first < last })
        {
            let message = format!("this loop is never entered: it counts {} from {first} to {last}", if up { "up" } else { "down" });
            self.report(Problem::P6212, from.span.to(to.span), message);
        }
        let known = match (ends, up) {
            (Some(((least, _), (_, most))), Some(true)) => Some((least, most)),
            (Some(((_, most), (least, _))), Some(false)) => Some((least, most)),
            _ => None,
        };
        // The body of a loop that is never entered is not looked at for where it would lead.
        let known = known.filter(|(least, most)| least <= most);
        // What the body itself, or a block that it calls, may write is not known.
        let kept = target.place.indexes.is_empty() && !self.may_write(body, &target.name);
        let depth = self.known.len();
        if let Some(range) = known.filter(|_| kept) {
            self.known.push(Known { place: target.place.clone(), range });
        }
        let body = self.body_of_loop(Some((target.name.clone(), target.place.clone())), body);
        self.known.truncate(depth);
        let each_pass = self.dialect.switches().for_bounds == ForBounds::EachPass;
        Some(StatementKind::For(Box::new(For { variable: target.place, scalar, from: first?, to: last?, by: step?, each_pass, body })))
    }

    /// Whether statements may write a variable: by an assignment, by a call, through its address.
    fn may_write(&self, body: &[ast::Statement], name: &str) -> bool {
        let names = |expression: &Expression| root(expression).is_some_and(|root| root.is(name));
        // GET and SET of a property look like a variable and may write what the instance has.
        let local = || matches!(self.names.local(name), Some(Entity::Variable(variable)) if variable.role == super::names::Role::Temp);
        let mut written = !self.names.objects().is_without_properties() && !local();
        walk::statements(body, &mut |statement| match &statement.kind {
            ast::StatementKind::Assign { targets, operator, .. } => {
                written |= targets.iter().any(names) || *operator == AssignOperator::Refer;
            }
            ast::StatementKind::For(one) => written |= names(&one.variable),
            _ => {}
        });
        walk::expressions(body, &mut |expression| match &expression.kind {
            ExpressionKind::Call(call) => {
                let standard = match &call.callee.kind {
                    ExpressionKind::Name(callee) => {
                        let user = |found: Entity| matches!(found, Entity::Block(_) | Entity::Variable(_));
                        let known = self.names.local(&callee.text).is_some_and(user) || self.names.global(&callee.text).is_some_and(user);
                        !known
                            && !callee.is("ADR")
                            && !callee.is("REF")
                            && !self.block.actions.iter().any(|action| callee.is(&action.name.text))
                    }
                    _ => false,
                };
                if !standard {
                    let passed = call.arguments.iter().any(|argument| {
                        let value = argument.value.as_ref().is_some_and(names);
                        value && (argument.direction == Direction::Delivered || !self.is_input(call, argument))
                    });
                    // Others write what is not temporary, if they know it.
                    written |= passed || !local();
                }
            }
            ExpressionKind::Assign(target, _) => written |= names(target),
            _ => {}
        });
        written
    }

    /// Whether an argument goes to a VAR_INPUT, as far as the name of the parameter tells.
    fn is_input(&self, call: &ast::Call, argument: &ast::Argument) -> bool {
        let (ExpressionKind::Name(callee), Some(formal)) = (&call.callee.kind, &argument.name) else { return false };
        let block = match self.names.local(&callee.text).or_else(|| self.names.global(&callee.text)) {
            Some(Entity::Block(block)) => block,
            Some(Entity::Variable(super::names::Variable { data_type: DataType::Instance { block, .. }, .. })) => block,
            _ => return false,
        };
        let interface = self.names.interface(block);
        let section = interface.and_then(|interface| Some(interface.variable(&formal.text)?.section));
        section == Some(sieben_model::interface::Section::Input)
    }

    /// A value that is counted to or compared with: a negative one is none of a type without a sign.
    fn counted(&mut self, value: &Expression, data_type: &DataType) -> Option<Value> {
        let before = std::mem::replace(&mut self.keeps_sign, true);
        let value = self.value(value, data_type);
        self.keeps_sign = before;
        value
    }

    /// CASE.
    pub(super) fn case(&mut self, selector: &Expression, arms: &[CaseArm], otherwise: &[ast::Statement]) -> Option<StatementKind> {
        if self.asks_for_type(selector).is_some() {
            return self.case_of_type(selector, arms, otherwise);
        }
        let typed = self.expression(selector);
        let found = match typed {
            Typed::Text(text) => return self.case_of_text(text, selector, arms, otherwise),
            typed => self.scalar(typed, selector.span),
        };
        let found = found.and_then(|(value, data_type)| {
            let kind = Kind::of(&data_type)?;
            if kind.class == Class::Bits && kind != Kind::BOOL && !self.judge(Construct::CaseOfBits, selector.span) {
                return None;
            }
            if kind.is_integer() || kind.class == Class::Bits && kind != Kind::BOOL || kind.class == Class::Character {
                return Some((value, data_type));
            }
            self.report(Problem::P6233, selector.span, format!("CASE takes an integer or an enumeration, not {}", self.words(&data_type)));
            None
        });
        let mut taken: Vec<((i128, i128), Span)> = Vec::new();
        let mut branches = Vec::with_capacity(arms.len());
        let mut sound = found.is_some();
        let mut computed = false;
        for arm in arms {
            let mut ranges = Vec::with_capacity(arm.labels.len());
            for label in &arm.labels {
                let Some((_, data_type)) = &found else { continue };
                // Labels that are no constants stand in one section; the first one tells it.
                if computed {
                    continue;
                }
                let told = self.diagnostics.len();
                match self.label_range(label, &data_type.clone()) {
                    Some(range) => {
                        sound &= self.apart(range, label.span(), &mut taken);
                        ranges.push(range);
                    }
                    None => {
                        sound = false;
                        computed = self.diagnostics[told..].iter().any(|one| one.problem == Problem::P6229);
                    }
                }
            }
            let span = match (arm.labels.first(), arm.labels.last()) {
                (Some(first), Some(last)) => first.span().to(last.span()),
                _ => selector.span,
            };
            branches.push(Branch { ranges, span, body: self.statements(&arm.body) });
        }
        let otherwise = self.statements(otherwise);
        let (selector, data_type) = found.filter(|_| sound)?;
        let scalar = Kind::of(&data_type)?.scalar(self.dialect);
        let selector = super::operators::convert(selector, scalar);
        Some(StatementKind::Case { selector, branches, otherwise })
    }

    /// The values of a label.
    fn label_range(&mut self, label: &CaseLabel, data_type: &DataType) -> Option<(i128, i128)> {
        match label {
            CaseLabel::Value(value) => {
                let number = self.label_number(value, data_type)?;
                Some((number, number))
            }
            CaseLabel::Range(low, high) => {
                let (first, last) = (self.label_number(low, data_type), self.label_number(high, data_type));
                let (first, last) = (first?, last?);
                if first > last {
                    let message = format!("the range {first}..{last} is empty: the lower end comes first");
                    self.report(Problem::P6209, label.span(), message);
                    return None;
                }
                Some((first, last))
            }
        }
    }

    fn label_number(&mut self, expression: &Expression, data_type: &DataType) -> Option<i128> {
        let value = self.counted(expression, data_type)?;
        match value.kind {
            ValueKind::Constant(word) => Some(signed(word, value.scalar)),
            _ => {
                self.report(Problem::P6229, expression.span, "a label of CASE is a constant, and this is computed at run time");
                None
            }
        }
    }

    /// Whether a label has no value of an earlier one; the first one wins.
    fn apart(&mut self, range: (i128, i128), span: Span, taken: &mut Vec<((i128, i128), Span)>) -> bool {
        let at = taken.partition_point(|&((_, last), _)| last < range.0);
        let sound = match taken.get(at) {
            Some(&(earlier, first)) if earlier.0 <= range.1 => {
                let shared = range.0.max(earlier.0);
                let message = format!("{shared} is covered by an earlier label already");
                let judgement = self.dialect.judge(Construct::CaseOverlap);
                if judgement != Judgement::Accept {
                    let problem = if judgement == Judgement::Reject { Problem::P6207 } else { Problem::P6208 };
                    self.report(problem, span, message).related.push((first, "covered here".to_owned()));
                }
                judgement != Judgement::Reject
            }
            _ => true,
        };
        // Sorted by their ends, which the search needs.
        let at = taken.partition_point(|&((_, last), _)| last < range.1);
        taken.insert(at, (range, span));
        sound
    }
}

/// The variable that an expression is or belongs to.
fn root(expression: &Expression) -> Option<&ast::Name> {
    match &expression.kind {
        ExpressionKind::Name(name) | ExpressionKind::Global(name) => Some(name),
        ExpressionKind::Member(inner, _)
        | ExpressionKind::Index(inner, _)
        | ExpressionKind::Slice(inner, _)
        | ExpressionKind::Parenthesized(inner) => root(inner),
        ExpressionKind::Address(address) => Some(&address.written),
        _ => None,
    }
}
