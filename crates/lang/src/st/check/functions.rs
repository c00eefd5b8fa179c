//! Standard functions: what the arguments are, and what the function makes of them.

use std::sync::Arc;

use sieben_engine::ir::Op;
use sieben_model::address::Area;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Interface, Section, Variable};
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::testing::Word;
use sieben_model::types::{DataType, Reference, ReferenceKind, STRING_LENGTH_MAX};

use super::memory::two;
use super::names::Role;
use super::places::Reached;
use super::typed::{Target, Typed};
use super::types::{Class, Implicit, Kind, implicit};
use super::{Checker, literals, operators};
use crate::scope::{is_nearer, nearest};
use crate::st::ast::{self, Direction, Expression, ExpressionKind, Name};
use crate::st::dialect::{Construct, Judgement, LostResults};
use crate::st::open_arrays::End;
use crate::st::standard::operators::Operation;
use crate::st::standard::s5::S5Function;
use crate::st::standard::{self, Building, Given, GivenKind, Meaning, Refusal, Resolved};
use crate::st::tree::{Argument, Base, Call, Callee, Place, Scalar, Statement, StatementKind, Text, TextFunction, Value, ValueKind};

/// Names that look alike and are asked for one after the other.
const CANDIDATES_MAX: usize = 8;
/// Up to here a REAL has all integers.
const EXACT_INTEGERS: u128 = 1 << f32::MANTISSA_DIGITS;

impl Checker<'_> {
    /// A call of a standard function.
    pub(super) fn standard(&mut self, name: &Name, call: &ast::Call, span: Span) -> Typed {
        if self.test_word(name).is_some() && self.misplaced_word(name) {
            self.look_at(&call.arguments);
            return Typed::Poison;
        }
        if let Some(typed) = self.value_with_flow(call, span) {
            return typed;
        }
        if let Some(typed) = self.peek(name, call, span) {
            return typed;
        }
        if let Some(typed) = self.instruction(name, call, span) {
            return typed;
        }
        if let Some(typed) = self.query(name, call, span) {
            return typed;
        }
        if let Some(typed) = self.built_in(name, call, span) {
            return typed;
        }
        if let Some(function) = S5Function::find(&name.text, self.dialect) {
            return match self.s5_function(function, name, call, span) {
                Some((before, value)) => {
                    Typed::Scalar { value: super::calls::after(before, value), data_type: function.device.result.0.clone() }
                }
                None => Typed::Poison,
            };
        }
        let mut arguments: Vec<(Typed, Span)> = call
            .arguments
            .iter()
            .map(|argument| match &argument.value {
                Some(value) => (self.expression(value), value.span),
                None => (Typed::Poison, argument.span),
            })
            .collect();
        if let Some(typed) = self.name_of_enumeration(name, call, &arguments, span) {
            return typed;
        }
        let of_enumeration = self.number_of_enumeration(name, &mut arguments);
        let name = of_enumeration.as_ref().unwrap_or(name);
        let given: Vec<Given<'_>> = call
            .arguments
            .iter()
            .zip(&arguments)
            .map(|(argument, (typed, _))| Given { name: argument.name.as_ref().map(|name| name.text.as_str()), kind: kind_of(typed) })
            .collect();
        if self.converts_to_itself(name, &arguments)
            && let Some((typed, _)) = arguments.pop()
        {
            return typed;
        }
        if let Some(typed) = self.of_number(name, &arguments) {
            return typed;
        }
        if let Some(typed) = self.of_times(name, call, &arguments, span) {
            return typed;
        }
        if let Some(typed) = self.wide_function(name, call, &arguments, span) {
            return typed;
        }
        if let Some(typed) = self.of_literals(name, &given, &arguments) {
            return typed;
        }
        let resolved = match self.is_inner(&name.text) {
            true => None,
            false => standard::resolve(&name.text, self.dialect, &given),
        };
        match resolved {
            None if self.misplaced_word(name) || self.is_declared_outside(name) => Typed::Poison,
            None => {
                let message = format!("there is no function `{}`", name.text);
                if standard::catalogue::page(&name.text).is_some() {
                    let title = self.dialect.title();
                    let diagnostic = self.report(Problem::P3008, name.span, message);
                    diagnostic.may_be_elsewhere = true;
                    diagnostic.help = Some(format!(
                        "{title} does not have it; `sieben explain {}` says which dialects have it and what the others take.",
                        name.text.to_ascii_uppercase()
                    ));
                    return Typed::Poison;
                }
                let nearest = self.nearest_function(&name.text);
                let diagnostic = self.report(Problem::P3008, name.span, message);
                diagnostic.may_be_elsewhere = true;
                diagnostic.help = Some(
                    "Correct the name, or add the source of the function; `sieben explain functions` lists those that need none."
                        .to_owned(),
                );
                if let Some(nearest) = nearest {
                    *diagnostic = diagnostic.clone().guess(name.span, nearest.clone(), format!("write `{nearest}`"));
                }
                Typed::Poison
            }
            // What is wrong with an argument was said; that the function does not take it says nothing new.
            Some(_)
                if call
                    .arguments
                    .iter()
                    .zip(&arguments)
                    .any(|(argument, (typed, _))| argument.value.is_some() && *typed == Typed::Poison) =>
            {
                Typed::Poison
            }
            Some(Err(refusal)) => self.refused(refusal, &arguments, span),
            Some(Ok(resolved)) => self.composed(&name.text, resolved, call, arguments, span),
        }
    }

    /// `TO_STRING('abc')`: a text stays what it is.
    fn converts_to_itself(&self, name: &Name, arguments: &[(Typed, Span)]) -> bool {
        let [(Typed::Text(text), _)] = arguments else { return false };
        let upper = name.text.to_ascii_uppercase();
        let word = if text.is_wide() { "WSTRING" } else { "STRING" };
        let from = upper.strip_suffix(word).and_then(|rest| rest.strip_suffix("TO_"));
        let general = self.dialect.switches().operators_as_functions;
        match from {
            Some("") => general,
            Some("ANY_") => general && self.dialect.has_pointers(),
            Some(from) => from.strip_suffix('_') == Some(word),
            None => false,
        }
    }

    /// `MOVE(5)` and `ABS(-5)`: a number without a type stays one.
    fn of_number(&self, name: &Name, arguments: &[(Typed, Span)]) -> Option<Typed> {
        let [(typed @ (Typed::Integer { .. } | Typed::Real { .. }), _)] = arguments else { return None };
        let moves = name.is("MOVE") && self.dialect.switches().operators_as_functions;
        match typed {
            _ if moves => Some(typed.clone()),
            Typed::Integer { value, radix } if name.is("ABS") => {
                Some(Typed::Integer { value: value.checked_abs().unwrap_or(i128::MAX), radix: *radix })
            }
            Typed::Real { value, single } if name.is("ABS") => Some(Typed::Real { value: value.abs(), single: single.abs() }),
            _ => None,
        }
    }

    /// ADD, SUB, MUL and DIV of durations and dates are what the operators are; `None` for all else.
    fn of_times(&mut self, name: &Name, call: &ast::Call, arguments: &[(Typed, Span)], span: Span) -> Option<Typed> {
        let operator = match name.text.to_ascii_uppercase().as_str() {
            "ADD" => ast::BinaryOperator::Add,
            "SUB" => ast::BinaryOperator::Subtract,
            "MUL" => ast::BinaryOperator::Multiply,
            "DIV" => ast::BinaryOperator::Divide,
            _ => return None,
        };
        let timed = |typed: &Typed| match typed {
            Typed::Scalar { data_type, .. } => Kind::of(data_type)
                .is_some_and(|kind| matches!(kind.class, Class::Duration | Class::Date | Class::TimeOfDay | Class::DateAndTime)),
            _ => false,
        };
        let has_functions = self.dialect.switches().operators_as_functions;
        let folds = matches!(operator, ast::BinaryOperator::Add | ast::BinaryOperator::Multiply);
        if !has_functions || arguments.len() < 2 || arguments.len() > 2 && !folds || !arguments.iter().any(|(typed, _)| timed(typed)) {
            return None;
        }
        let mut ordered: Vec<Option<&(Typed, Span)>> = vec![None; arguments.len()];
        for (index, (argument, typed)) in call.arguments.iter().zip(arguments).enumerate() {
            let slot = match &argument.name {
                Some(name) => (0..arguments.len()).find(|slot| name.is(&format!("IN{}", slot + 1)))?,
                None => index,
            };
            *ordered.get_mut(slot)? = Some(typed);
        }
        let mut ordered = ordered.into_iter().collect::<Option<Vec<_>>>()?.into_iter();
        let (first, at) = ordered.next()?.clone();
        Some(ordered.fold(first, |sum, next| match sum {
            Typed::Poison => Typed::Poison,
            sum => self.arithmetic(operator, span, (sum, at), next.clone()),
        }))
    }

    /// `TO_INT(color)` and `Color_TO_INT(color)`: the number of a value of an enumeration, as that of the type which holds it.
    fn number_of_enumeration(&self, name: &Name, arguments: &mut [(Typed, Span)]) -> Option<Name> {
        let [(Typed::Scalar { data_type, .. }, _)] = arguments else { return None };
        let DataType::Enumeration(enumeration) = &*data_type else { return None };
        let upper = name.text.to_ascii_uppercase();
        let own = enumeration.name.as_ref().and_then(|own| upper.strip_prefix(&format!("{}_TO_", own.to_ascii_uppercase())));
        let target = own.or_else(|| upper.strip_prefix("TO_"))?;
        let is_number = |kind: Kind| kind.is_number() || kind.class == Class::Bits;
        standard::type_of_word(target, self.dialect).and_then(|target| Kind::of(&target)).filter(|&kind| is_number(kind))?;
        let general = format!("TO_{target}");
        *data_type = enumeration.base.base().clone();
        Some(Name { text: general, ..name.clone() })
    }

    /// `TO_STRING(color)` where the type has the attribute 'to_string': the name of the value, or its number if it has none.
    fn name_of_enumeration(&mut self, name: &Name, call: &ast::Call, arguments: &[(Typed, Span)], span: Span) -> Option<Typed> {
        let [(Typed::Scalar { value, data_type: DataType::Enumeration(enumeration) }, place)] = arguments else { return None };
        let upper = name.text.to_ascii_uppercase();
        let own = enumeration.name.as_ref().and_then(|own| upper.strip_prefix(&format!("{}_TO_", own.to_ascii_uppercase())));
        let wide = match own.or_else(|| upper.strip_prefix("TO_"))? {
            "STRING" => false,
            "WSTRING" => true,
            _ => return None,
        };
        if !enumeration.named {
            return None;
        }
        let (keep, number) = self.kept(value.clone());
        let mut first = Some(keep);
        let base = enumeration.base.base().clone();
        let of_number = vec![(Typed::Scalar { value: number.clone(), data_type: base }, *place)];
        let mut found = self.text_function("TO_STRING", of_number, span);
        let groups = names_in_one_text(&enumeration.values);
        for (index, group) in groups.iter().enumerate().rev() {
            // The outermost choice comes first: it keeps the number for those inside.
            let kept = if index == 0 { first.take() } else { None };
            let asked = super::calls::after(kept.into_iter().collect(), number.clone());
            let all: Vec<u8> = group.iter().flat_map(|(_, text, _)| text.iter().copied()).collect();
            let of = |number: &Value, part: fn(&(i64, &[u8], usize)) -> u64| picked(group, number, part, span);
            let length = of(&number, |(_, text, _)| text.len() as u64);
            let at = of(&number, |(_, _, at)| *at as u64 + 1);
            let whole = |value: Value| Typed::Scalar { value: operators::convert(value, Scalar::I16), data_type: DataType::Int };
            let name = vec![(Typed::Text(Text::Constant(all)), span), (whole(length), span), (whole(at), span)];
            let name = self.text_function("MID", name, span);
            let is_named = operators::compute(Op::IsNonzero, vec![of(&asked, |_| 1)], Scalar::Bool);
            let is_named = Typed::Scalar { value: Value { span, ..is_named }, data_type: DataType::Bool };
            found = self.text_function("SEL", vec![(is_named, span), (found, span), (name, span)], span);
        }
        if !wide || found == Typed::Poison {
            return Some(found);
        }
        let to_wide = Name { text: "STRING_TO_WSTRING".to_owned(), ..name.clone() };
        self.wide_function(&to_wide, call, &[(found, span)], span)
    }

    /// A call of a standard function of texts with these arguments by position.
    fn text_function(&mut self, name: &str, arguments: Vec<(Typed, Span)>, span: Span) -> Typed {
        if arguments.iter().any(|(typed, _)| *typed == Typed::Poison) {
            return Typed::Poison;
        }
        let given: Vec<Given<'_>> = arguments.iter().map(|(typed, _)| Given { name: None, kind: kind_of(typed) }).collect();
        let by_position = ast::Argument { name: None, direction: Direction::Assigned, value: None, span };
        let callee = Expression { kind: ExpressionKind::Missing, span };
        let call = ast::Call { callee, arguments: vec![by_position; arguments.len()] };
        match standard::resolve(name, self.dialect, &given) {
            Some(Ok(resolved)) => self.composed(name, resolved, &call, arguments, span),
            Some(Err(refusal)) => self.refused(refusal, &arguments, span),
            None => self.not_built(span, "the name of a value"),
        }
    }

    /// `SIN(0.5)`: a number without a type as its argument is, so that an LREAL gets all its digits.
    fn of_literals(&self, name: &Name, given: &[Given<'_>], arguments: &[(Typed, Span)]) -> Option<Typed> {
        let mut numbers = Vec::with_capacity(given.len());
        for (given, (typed, _)) in given.iter().zip(arguments) {
            numbers.push(match typed {
                Typed::Integer { value, .. } if value.unsigned_abs() <= EXACT_INTEGERS => (given.name, *value as f64),
                Typed::Real { value, .. } => (given.name, *value),
                _ => return None,
            });
        }
        let value = standard::of_literals(&name.text, self.dialect, &numbers)?;
        Some(Typed::Real { value, single: value as f32 })
    }

    /// A call of a standard function whose result nobody uses.
    pub(super) fn standard_statement(&mut self, name: &Name, call: &ast::Call, span: Span) -> Option<StatementKind> {
        if let Some(word) = self.test_word(name) {
            return self.test_statement(word, call, span);
        }
        if let Some(function) = S5Function::find(&name.text, self.dialect) {
            return self.s5_function(function, name, call, span).map(|(statements, _)| StatementKind::Block(statements));
        }
        if let Some(done) = self.memory_statement(name, call, span).or_else(|| self.library_statement(name, call, span)) {
            return done;
        }
        match self.standard(name, call, span) {
            Typed::Poison => None,
            Typed::Scalar { value, .. } => Some(match value.kind {
                ValueKind::Call(call) => StatementKind::Call(*call),
                _ => {
                    let message = format!("the result of `{}` is not used", name.text);
                    self.report(Problem::P6232, span, message);
                    StatementKind::Block(Vec::new())
                }
            }),
            Typed::Text(Text::Call { call, .. }) => Some(StatementKind::Call(*call)),
            _ => Some(StatementKind::Block(Vec::new())),
        }
    }

    /// Says why a block of the library is not there: the program has another one with its number, or it is not built.
    fn not_provided(&mut self, provided: &standard::Provided, span: Span) -> Typed {
        let standard::Provided::Library(library) = provided else { return self.not_built(span, "this function") };
        if self.names.interface(library.block).is_none() {
            return self.not_built(span, "this function");
        }
        let (name, number) = (self.names.block_name(library.block), library.block);
        let own = if name == number.to_string() { "one of its own".to_owned() } else { format!("`{name}`") };
        let message = format!("`{}` is {number} of the library, and the program has {own} with this number", library.name);
        self.report(Problem::P6329, span, message);
        Typed::Poison
    }

    /// A call of a block of the library that has outputs; `None` if it has none, or is no block.
    fn library_statement(&mut self, name: &Name, call: &ast::Call, span: Span) -> Option<Option<StatementKind>> {
        let provided = standard::library::function(&name.text, self.dialect).filter(|_| !self.is_inner(&name.text))?;
        let standard::Provided::Source { .. } = provided else { return None };
        let Some(block) = self.names.provided(&provided) else {
            self.not_provided(&provided, span);
            return Some(None);
        };
        let interface = self.interface(block, call.callee.span)?;
        interface.parameters().find(|formal| matches!(formal.section, Section::Output | Section::InOut))?;
        let Some((call, mut before)) = self.arguments(Callee::Function(block), &interface, call, span) else { return Some(None) };
        before.push(Statement { kind: StatementKind::Call(call), span });
        Some(Some(StatementKind::Block(before)))
    }

    /// The name in sight that looks most like this one; in a test file its words are in sight.
    fn nearest_function(&mut self, name: &str) -> Option<String> {
        let words = Word::ALL.iter().map(|word| word.text()).filter(|_| self.dialect.is_test());
        let word = nearest(&name.to_uppercase(), words);
        word.or_else(|| {
            // What the program declares goes before a function that is no nearer.
            match (self.names.nearest(name), self.nearest_standard(name)) {
                (Some(own), Some(standard)) if is_nearer(name, &standard, &own) => Some(standard),
                (own, standard) => own.or(standard),
            }
        })
    }

    /// The standard function of the dialect whose name looks most like this one.
    fn nearest_standard(&mut self, name: &str) -> Option<String> {
        if self.quiet {
            return None;
        }
        let mut names: Vec<&'static str> = standard::catalogue::names().collect();
        for _ in 0..CANDIDATES_MAX {
            let near = nearest(name, names.iter().copied())?;
            if self.has_function(&near) {
                return Some(near);
            }
            names.retain(|one| *one != near);
        }
        None
    }

    /// Whether the dialect has a standard function with this name: the checker is asked.
    fn has_function(&mut self, name: &str) -> bool {
        let span = self.block.end;
        let call = ast::Call { callee: Expression { kind: ExpressionKind::Missing, span }, arguments: Vec::new() };
        let name = Name { text: name.to_owned(), span, quoting: ast::Quoting::Bare };
        let held = self.held.take();
        self.quietly(|checker| checker.standard(&name, &call, span));
        let unknown = std::mem::replace(&mut self.held, held).is_some_and(|held| held.problem == Problem::P3008);
        !unknown
    }

    /// Whether a name is that of a block that only other blocks of the library call.
    pub(super) fn is_inner(&self, name: &str) -> bool {
        standard::library::is_inner(name, self.dialect) && !self.names.is_of_library(self.block.id)
    }

    pub(super) fn refused(&mut self, refusal: Refusal, arguments: &[(Typed, Span)], span: Span) -> Typed {
        let place = refusal.argument.and_then(|index| arguments.get(index)).map_or(span, |&(_, span)| span);
        let diagnostic = self.report(refusal.problem, place, refusal.message);
        if !refusal.help.is_empty() {
            diagnostic.help = Some(refusal.help);
        }
        Typed::Poison
    }

    pub(super) fn composed(
        &mut self,
        name: &str,
        resolved: Resolved,
        call: &ast::Call,
        arguments: Vec<(Typed, Span)>,
        span: Span,
    ) -> Typed {
        match resolved.meaning {
            Meaning::Length => {
                let Some((typed, place)) = arguments.into_iter().next() else { return Typed::Poison };
                let Some(text) = self.text(typed, place) else { return Typed::Poison };
                let value = Value { kind: ValueKind::Length(Box::new(text)), scalar: Scalar::I16, span };
                Typed::Scalar { value, data_type: resolved.result }
            }
            Meaning::CompareTexts(operation) => {
                let Some(op) = standard::operators::op_for(operation, Scalar::I32) else { return Typed::Poison };
                if arguments.len() > 2 {
                    let mut rest: Vec<Option<(Typed, Span)>> = arguments.into_iter().map(Some).collect();
                    let order = order_of(&resolved.parameters, call).into_iter();
                    let ordered = order.filter_map(|index| rest.get_mut(index).and_then(Option::take)).collect();
                    return self.texts_in_order(op, ordered, span);
                }
                let Ok([a, b]) = <[(Typed, Span); 2]>::try_from(arguments) else { return Typed::Poison };
                let Some((a, b)) = self.two_texts(a, b) else { return Typed::Poison };
                Typed::Scalar { value: super::texts::compared(op, a, b, span), data_type: DataType::Bool }
            }
            Meaning::Build(build) => {
                let mut rest: Vec<Option<(Typed, Span)>> = arguments.into_iter().map(Some).collect();
                let mut values = Vec::with_capacity(resolved.parameters.len());
                for (index, parameter) in order_of(&resolved.parameters, call).into_iter().zip(&resolved.parameters) {
                    let Some((mut typed, place)) = rest.get_mut(index).and_then(Option::take) else { continue };
                    if let Some(written) = call.arguments.get(index).and_then(|argument| argument.value.as_ref())
                        && self.truncates(written)
                    {
                        typed = self.expression_for(written, &parameter.data_type);
                    }
                    match self.coerce(typed, place, &parameter.data_type) {
                        Some(value) => values.push(value),
                        None => return Typed::Poison,
                    }
                }
                if values.len() != resolved.parameters.len() {
                    return Typed::Poison;
                }
                let (checked, quotients) = (self.reads_ok || self.lost == LostResults::All, self.lost != LostResults::None);
                let locals = &mut self.locals;
                let mut temporary = |scalar: Scalar| locals.place(scalar.bits().div_ceil(8), span);
                let value = build(values, &mut Building { span, checked, quotients, temporary: &mut temporary });
                Typed::Scalar { value: Value { span, ..value }, data_type: resolved.result }
            }
            Meaning::Choose { block, inputs, last } => self.chosen_text((block, inputs, last), &resolved.parameters, call, arguments, span),
            Meaning::Fold(provided) => {
                let Some(block) = self.names.provided(&provided) else {
                    return self.not_provided(&provided, span);
                };
                let Some(interface) = self.interface(block, call.callee.span) else { return Typed::Poison };
                let written_out = TextFunction::of(&provided, name, self.dialect).filter(|_| self.names.is_of_library(block));
                let order = order_of(&resolved.parameters, call);
                let mut arguments: Vec<Option<(Typed, Span)>> = arguments.into_iter().map(Some).collect();
                let mut texts = order.into_iter().filter_map(|index| arguments.get_mut(index).and_then(Option::take));
                let Some((mut folded, mut place)) = texts.next() else { return Typed::Poison };
                let inputs: Vec<&Variable> = interface.parameters().filter(|formal| formal.section == Section::Input).collect();
                if call.arguments.len() < inputs.len() {
                    let takes = super::calls::counted(inputs.len(), "text");
                    let message = format!("`{name}` takes at least {takes}, and this is one");
                    self.report(Problem::P3010, span, message).help = Some("Give every input a value.".to_owned());
                    return Typed::Poison;
                }
                for (next, next_place) in texts {
                    let (mut passed, mut before) = (Vec::new(), Vec::new());
                    for (formal, (typed, place)) in inputs.iter().zip([(folded, place), (next, next_place)]) {
                        if !self.input(formal, typed, place, &mut passed, &mut before) {
                            return Typed::Poison;
                        }
                    }
                    folded = self.result_of_function((block, written_out), &interface, passed, before, span);
                    place = span;
                }
                folded
            }
            Meaning::Block(provided) => {
                let Some(block) = self.names.provided(&provided) else {
                    return self.not_provided(&provided, span);
                };
                let Some(interface) = self.interface(block, call.callee.span) else { return Typed::Poison };
                let written_out = TextFunction::of(&provided, name, self.dialect).filter(|_| self.names.is_of_library(block));
                self.block_function((block, written_out), &interface, call, arguments, span)
            }
        }
    }

    /// Whether each two neighbouring texts are in this order.
    fn texts_in_order(&mut self, op: Op, arguments: Vec<(Typed, Span)>, span: Span) -> Typed {
        let mut texts = Vec::with_capacity(arguments.len());
        for (typed, place) in arguments {
            let Some(text) = self.text(typed, place) else { return Typed::Poison };
            texts.push((text, place));
        }
        let wide = texts.iter().any(|(text, _)| text.is_wide());
        let mut before = Vec::new();
        let mut kept: Vec<Text> = Vec::with_capacity(texts.len());
        for (text, place) in texts {
            let Some(text) = self.text_of(Typed::Text(text), place, wide) else { return Typed::Poison };
            // Each is looked at twice, and computed once.
            kept.push(match text {
                text @ (Text::Constant(_) | Text::WideConstant(_) | Text::Place { .. }) => text,
                source => {
                    let room = super::texts::known_room(&source);
                    let target = self.temporary_place(room.bytes(), span);
                    before.push(Statement { kind: StatementKind::AssignString { target: target.clone(), room, source }, span });
                    Text::Place { place: target, room }
                }
            });
        }
        let pairs = kept.windows(2).map(|pair| super::texts::compared(op, pair[0].clone(), pair[1].clone(), span));
        let all = pairs.reduce(|all, next| Value { span, ..operators::compute(Op::And, vec![all, next], Scalar::Bool) });
        match all {
            Some(value) => Typed::Scalar { value: super::calls::after(before, value), data_type: DataType::Bool },
            None => Typed::Poison,
        }
    }

    /// MUX of texts.
    fn chosen_text(
        &mut self,
        (provided, inputs, last): (standard::Provided, usize, bool),
        parameters: &[standard::Parameter],
        call: &ast::Call,
        arguments: Vec<(Typed, Span)>,
        span: Span,
    ) -> Typed {
        let Some(block) = self.names.provided(&provided) else {
            return self.not_provided(&provided, span);
        };
        let Some(interface) = self.interface(block, call.callee.span) else { return Typed::Poison };
        let mut rest: Vec<Option<(Typed, Span)>> = arguments.into_iter().map(Some).collect();
        let mut given = order_of(parameters, call).into_iter().filter_map(|index| rest.get_mut(index).and_then(Option::take));
        let (Some((number, place)), Some(first)) = (given.next(), parameters.first()) else { return Typed::Poison };
        let Some(number) = self.coerce(number, place, &first.data_type) else { return Typed::Poison };
        let (keep, number) = self.kept(number);
        let mut texts: Vec<(Typed, Span)> = given.collect();
        let otherwise = if texts.len() > inputs || last { texts.pop() } else { None };
        let (mut found, mut place) = otherwise.unwrap_or((Typed::Text(Text::Constant(Vec::new())), span));
        let formals: Vec<&Variable> = interface.parameters().filter(|formal| formal.section == Section::Input).collect();
        for (index, (text, text_place)) in texts.into_iter().enumerate().rev() {
            let this = Value { kind: ValueKind::Constant(index as u64), scalar: number.scalar, span };
            // The outermost call comes first: it keeps the number for those inside.
            let number = if index == 0 { super::calls::after(vec![keep.clone()], number.clone()) } else { number.clone() };
            let equal = operators::compute(sieben_engine::ir::Op::Equal, vec![number, this], Scalar::Bool);
            let condition = Typed::Scalar { value: Value { span, ..equal }, data_type: DataType::Bool };
            let (mut passed, mut before) = (Vec::new(), Vec::new());
            for (formal, (typed, place)) in formals.iter().zip([(condition, span), (found, place), (text, text_place)]) {
                if !self.input(formal, typed, place, &mut passed, &mut before) {
                    return Typed::Poison;
                }
            }
            found = self.result_of_function((block, None), &interface, passed, before, span);
            place = span;
        }
        found
    }

    /// A standard function that is a block: all its parameters but the result are inputs.
    pub(super) fn block_function(
        &mut self,
        (block, written_out): (BlockId, Option<TextFunction>),
        interface: &Arc<Interface>,
        call: &ast::Call,
        arguments: Vec<(Typed, Span)>,
        span: Span,
    ) -> Typed {
        let formals: Vec<&Variable> = interface.parameters().filter(|formal| formal.section == Section::Input).collect();
        let (mut passed, mut before) = (Vec::new(), Vec::new());
        let mut given: Vec<(&str, Span)> = Vec::new();
        for (index, (argument, (typed, place))) in call.arguments.iter().zip(arguments).enumerate() {
            let formal = match &argument.name {
                // The one input of a conversion is IN, whatever the block of the library calls it.
                Some(name) if name.is("IN") && formals.len() == 1 => formals.first().copied(),
                Some(name) => formals.iter().copied().find(|formal| name.is(&formal.name)),
                None => formals.get(index).copied(),
            };
            let Some(formal) = formal else {
                let takes = super::calls::counted(formals.len(), "parameter");
                let inputs = formals.iter().map(|formal| format!("`{}`", formal.name)).collect::<Vec<_>>().join(", ");
                self.report(Problem::P6219, argument.span, format!("this function takes {takes}: {inputs}"));
                return Typed::Poison;
            };
            if let Some(&(_, first)) = given.iter().find(|(name, _)| *name == formal.name) {
                let message = format!("the parameter `{}` is given twice", formal.name);
                self.report(Problem::P3011, argument.span, message).related.push((first, "first given here".to_owned()));
                return Typed::Poison;
            }
            given.push((&formal.name, argument.span));
            let typed = if written_out.is_some() { self.number_in_text(formal, typed) } else { typed };
            let typed = if is_joined(&call.callee) { self.part_of_date(formal, typed, place) } else { typed };
            if !self.input(formal, typed, place, &mut passed, &mut before) {
                return Typed::Poison;
            }
        }
        let missing = formals.iter().filter(|formal| !given.iter().any(|(name, _)| *name == formal.name));
        let missing: Vec<String> = missing.map(|formal| format!("`{}`", formal.name)).collect();
        if !missing.is_empty() {
            let message = format!("the call of {} leaves out {}", self.name_in(call, &Callee::Function(block)), missing.join(", "));
            self.report(Problem::P3010, span, message).help = Some("Give every input a value.".to_owned());
            return Typed::Poison;
        }
        self.result_of_function((block, written_out), interface, passed, before, span)
    }

    /// An integer of any type where a part of a date is a DINT: one that is none of a date stays none.
    fn part_of_date(&mut self, formal: &Variable, typed: Typed, span: Span) -> Typed {
        let Typed::Scalar { value, data_type } = typed else { return typed };
        let kind = Kind::of(&data_type).filter(|kind| kind.is_integer());
        let wanted = Kind::of(&formal.data_type).filter(|wanted| *wanted == Kind::DINT);
        let Some((kind, _)) = kind.zip(wanted).filter(|&(kind, wanted)| implicit(kind, wanted, self.dialect) != Implicit::Yes) else {
            return Typed::Scalar { value, data_type };
        };
        let limit = |number: i64, scalar| Value { kind: ValueKind::Constant(number as u64), scalar, span };
        let scalar = if kind.class == Class::Signed { Scalar::I64 } else { Scalar::U64 };
        let wide = operators::convert(value, scalar);
        let (least, most) = (limit(i64::from(i32::MIN), scalar), limit(i64::from(i32::MAX), scalar));
        let inside = match kind.class {
            Class::Signed => two(Operation::Minimum, two(Operation::Maximum, wide, least, span), most, span),
            _ => operators::compute(Op::MinU64, vec![wide, most], scalar),
        };
        let value = operators::convert(inside, Scalar::I32);
        Typed::Scalar { value, data_type: DataType::DoubleInt }
    }

    fn result_of_function(
        &mut self,
        (block, written_out): (BlockId, Option<TextFunction>),
        interface: &Interface,
        passed: Vec<Argument>,
        before: Vec<Statement>,
        span: Span,
    ) -> Typed {
        let result = interface.variables.iter().find(|variable| variable.section == Section::Return);
        let result = result.map_or(DataType::Void, |result| result.data_type.clone());
        let callee = Callee::Function(block);
        let of_library = self.names.is_of_library(block);
        let call = Call { callee, arguments: passed, enable: None, result, clears_ok: self.reads_ok, of_library, written_out, span };
        self.result_of(call, before, span)
    }

    /// Functions of variables and types instead of values: REF, ADR, SIZEOF, WORD_TO_BLOCK_DB.
    fn built_in(&mut self, name: &Name, call: &ast::Call, span: Span) -> Option<Typed> {
        let upper = name.text.to_ascii_uppercase();
        let construct = match upper.as_str() {
            "REF" => Some(Construct::RefTo),
            "ADR" => Some(Construct::PointerTo),
            "LOWER_BOUND" if self.dialect.judge(Construct::OpenArray) != Judgement::Reject => {
                return Some(self.bound_function(End::Low, call, span));
            }
            "UPPER_BOUND" if self.dialect.judge(Construct::OpenArray) != Judgement::Reject => {
                return Some(self.bound_function(End::High, call, span));
            }
            "SIZEOF" => None,
            "WORD_TO_BLOCK_DB" | "BLOCK_DB_TO_WORD" if self.dialect.switches().s5_functions => None,
            _ => return None,
        };
        let [ast::Argument { value: Some(argument), direction: Direction::Assigned, .. }] = call.arguments.as_slice() else {
            self.look_at(&call.arguments);
            self.report(Problem::P6219, span, format!("`{upper}` takes one parameter"));
            return Some(Typed::Poison);
        };
        if construct.is_some_and(|construct| !self.judge(construct, span)) {
            return Some(Typed::Poison);
        }
        Some(match upper.as_str() {
            "REF" | "ADR" => match self.reach(argument) {
                Reached::Target(target) => self.address_of(target, &upper, span),
                Reached::Other(Typed::Poison) => Typed::Poison,
                Reached::Other(other) => {
                    let what = self.what(&other);
                    self.report(Problem::P6204, argument.span, format!("`{upper}` takes a variable, not {what}"));
                    Typed::Poison
                }
            },
            "SIZEOF" => {
                let is_type = |block: BlockId| matches!(block.kind, BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock);
                let data_type = match self.reach(argument) {
                    Reached::Target(target) if !self.is_whole(&target) => return Some(Typed::Poison),
                    Reached::Target(target) => target.data_type,
                    Reached::Other(Typed::Type(data_type)) => data_type,
                    Reached::Other(Typed::Block(block)) if is_type(block) => {
                        let block = self.brought_along(argument).unwrap_or(block);
                        let Some(structure) = self.names.instance(block) else { return Some(Typed::Poison) };
                        DataType::Instance { block, structure }
                    }
                    Reached::Other(other) => match self.scalar(other, argument.span) {
                        Some((_, data_type)) => data_type,
                        None => return Some(Typed::Poison),
                    },
                };
                Typed::Integer { value: i128::from(data_type.bits_used().div_ceil(8)), radix: 10 }
            }
            "WORD_TO_BLOCK_DB" => match self.value(argument, &DataType::Word) {
                Some(value) => Typed::Number { data_type: DataType::BlockData, value },
                None => Typed::Poison,
            },
            _ => match self.expression(argument) {
                Typed::Number { data_type: DataType::BlockData, value } => Typed::Scalar { value, data_type: DataType::Word },
                Typed::Block(block) if block.kind == BlockKind::DataBlock => Typed::Scalar {
                    value: Value { kind: ValueKind::Constant(u64::from(block.number)), scalar: Scalar::U16, span },
                    data_type: DataType::Word,
                },
                Typed::Poison => Typed::Poison,
                other => {
                    let what = self.what(&other);
                    self.report(Problem::P4011, argument.span, format!("`{upper}` takes a data block, not {what}"));
                    Typed::Poison
                }
            },
        })
    }

    /// The function block that the dialect brings along, where a name means one of the system: `TON`.
    fn brought_along(&mut self, expression: &Expression) -> Option<BlockId> {
        let ExpressionKind::Name(name) = &expression.kind else { return None };
        let found = self.names.global(&name.text);
        self.bare_block_type(name, found.as_ref())
    }

    /// REF and ADR.
    fn address_of(&mut self, target: Target, function: &str, span: Span) -> Typed {
        if function == "REF" && is_temporary(&target) {
            self.dangles(&target.name, span);
            return Typed::Poison;
        }
        let kind = if function == "REF" { ReferenceKind::RefTo } else { ReferenceKind::Pointer };
        let data_type = DataType::Reference(Arc::new(Reference { target: target.data_type, kind }));
        Typed::Scalar { value: Value { kind: ValueKind::AddressOf(target.place), scalar: Scalar::U64, span }, data_type }
    }

    /// Says that a reference would be there longer than what it refers to.
    pub(super) fn dangles(&mut self, name: &str, span: Span) {
        let message = format!("`{name}` lives only until the block ends, and a reference to it longer");
        self.report(Problem::P6204, span, message).help = Some("Refer to a variable of an instance or a data block.".to_owned());
    }

    /// A place in the local data of the block for a value of so many bytes, until the statement ends.
    pub(super) fn temporary_place(&mut self, bytes: u32, span: Span) -> Place {
        self.locals.place(bytes, span)
    }

    /// A value that is used more than once: the statement that keeps it, and a value that reads it.
    pub(super) fn kept(&mut self, value: Value) -> (Statement, Value) {
        let (scalar, span) = (value.scalar, value.span);
        let place = self.temporary_place(scalar.bits().div_ceil(8), span);
        let load = Value { kind: ValueKind::Load(place.clone()), scalar, span };
        (Statement { kind: StatementKind::Assign { target: place, value }, span }, load)
    }
}

/// Whether a function joins the parts of a date.
fn is_joined(callee: &Expression) -> bool {
    let ExpressionKind::Name(name) = &callee.kind else { return false };
    name.text.get(..7).is_some_and(|start| start.eq_ignore_ascii_case("CONCAT_"))
}

/// Which argument each parameter gets: by its name, else by its position.
pub(super) fn order_of(parameters: &[standard::Parameter], call: &ast::Call) -> Vec<usize> {
    let position = |(index, parameter): (usize, &standard::Parameter)| {
        let named = |argument: &ast::Argument| argument.name.as_ref().is_some_and(|name| name.is(&parameter.name));
        call.arguments.iter().position(named).unwrap_or(index)
    };
    parameters.iter().enumerate().map(position).collect()
}

/// What an argument is for the choice of a standard function.
pub(super) fn kind_of(typed: &Typed) -> GivenKind {
    match typed {
        Typed::Integer { value, radix } => GivenKind::Integer { value: *value, radix: *radix },
        Typed::Real { .. } => GivenKind::Real,
        Typed::Scalar { data_type, .. } | Typed::Number { data_type, .. } => GivenKind::Typed(data_type.clone()),
        Typed::Text(text @ Text::Character(_)) => GivenKind::Typed(if text.is_wide() { DataType::WideChar } else { DataType::Char }),
        Typed::Text(text) => GivenKind::Typed(super::texts::type_of_room(text.room())),
        Typed::Aggregate(target) | Typed::Delivered(_, target) => GivenKind::Typed(target.data_type.clone()),
        Typed::Moment(_) => GivenKind::Typed(DataType::DateAndTime),
        Typed::Structured(..) => GivenKind::Typed(crate::st::dtl::data_type()),
        Typed::Pointer(pointer) => {
            let literal = ast::LiteralKind::Pointer(pointer.clone());
            literals::natural(&literal, crate::st::dialect::Dialect::Scl).map_or(GivenKind::Unknown, GivenKind::Typed)
        }
        Typed::Poison | Typed::Null | Typed::Block(_) | Typed::Type(_) | Typed::Qualifier(_) => GivenKind::Unknown,
    }
}

/// The names of an enumeration put together into as few texts as possible: of each name its number and where it begins in its text. Of
/// several names of one number the first counts.
fn names_in_one_text(values: &[(String, i64)]) -> Vec<Vec<(i64, &[u8], usize)>> {
    let mut groups: Vec<Vec<(i64, &[u8], usize)>> = Vec::new();
    let mut seen = std::collections::HashSet::new();
    for (name, number) in values.iter().filter(|(_, number)| seen.insert(*number)) {
        let text = &name.as_bytes()[..name.len().min(usize::from(STRING_LENGTH_MAX))];
        let at = groups.last().and_then(|group| group.last()).map_or(usize::MAX, |(_, text, at)| at + text.len());
        match groups.last_mut() {
            Some(group) if at + text.len() <= usize::from(STRING_LENGTH_MAX) => group.push((*number, text, at)),
            _ => groups.push(vec![(*number, text, 0)]),
        }
    }
    groups
}

/// A part of the row whose number the value is, or 0: the sum over all rows, of which one at most counts.
fn picked(group: &[(i64, &[u8], usize)], number: &Value, part: fn(&(i64, &[u8], usize)) -> u64, span: Span) -> Value {
    let whole = |value| Value { kind: ValueKind::Constant(value), scalar: Scalar::U32, span };
    match group {
        [] => whole(0),
        [row] => {
            let bits = number.scalar.bits();
            let own = if bits < 64 { row.0 as u64 & ((1 << bits) - 1) } else { row.0 as u64 };
            let own = Value { kind: ValueKind::Constant(own), scalar: number.scalar, span };
            let equal = operators::compute(Op::Equal, vec![number.clone(), own], Scalar::Bool);
            Value { span, ..operators::compute(Op::Select, vec![equal, whole(part(row)), whole(0)], Scalar::U32) }
        }
        _ => {
            let (left, right) = group.split_at(group.len() / 2);
            // What is done before the number is read is done once.
            let (before, again) = match &number.kind {
                ValueKind::After(_, read) => (number, (**read).clone()),
                _ => (number, number.clone()),
            };
            let sides = vec![picked(left, before, part, span), picked(right, &again, part, span)];
            Value { span, ..operators::compute(Op::AddU32, sides, Scalar::U32) }
        }
    }
}

/// Whether a variable is there only while the block runs: local data, and what a function or method was given. A structured VAR_IN_OUT is
/// the variable of the caller.
fn is_temporary(target: &Target) -> bool {
    match target.place.base {
        Base::ComplexParameter(_) => target.role != Role::InOut,
        _ => ends_with_block(&target.place),
    }
}

/// Whether a place is in the local data of the block or in those of its caller.
pub(super) fn ends_with_block(place: &Place) -> bool {
    matches!(place.base, Base::Area(Area::Local) | Base::Parameter(_))
}

/// Whether a place is there after the block. What goes out as a parameter or behind a pointer is looked at when the block ends.
pub(super) fn stays(place: &Place) -> bool {
    matches!(place.base, Base::DataBlock(_) | Base::ComputedDataBlock(_) | Base::Instance)
}
