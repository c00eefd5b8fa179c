//! Statements: assignments, IF, calls, jumps; loops and CASE have their own file.

use std::collections::HashSet;

use sieben_model::address::Area;
use sieben_model::block::BlockKind;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, ReferenceKind};

use super::calls::Called;
use super::expressions::same_type;
use super::functions::{ends_with_block, stays};
use super::names::{Entity, Role};
use super::places::Reached;
use super::ranges::same_place;
use super::testing::and_hold;
use super::texts::text_room;
use super::typed::{Target, Through, Typed};
use super::types::Kind;
use super::{Block, Checker, Label, operators, walk};
use crate::st::ast::{self, AssignOperator, BinaryOperator, Expression, ExpressionKind, Name, StatementKind as Kinds};
use crate::st::dialect::{Construct, IndexFault, Judgement};
use crate::st::dtl;
use crate::st::objects::TYPE_NUMBER_BITS;
use crate::st::standard;
use crate::st::tree::{Argument, Call, Callee, Place, Scalar, Statement, StatementKind, Text, Value, ValueKind, room_of};

impl Checker<'_> {
    /// A list of statements.
    pub(super) fn statements(&mut self, statements: &[ast::Statement]) -> Vec<Statement> {
        self.lists.push(self.next_list);
        self.next_list += 1;
        let mut all = Vec::with_capacity(statements.len());
        let mut left: Option<&'static str> = None;
        let mut label: Option<&Name> = None;
        for statement in statements {
            if let Some(word) = left
                && !matches!(statement.kind, Kinds::Empty | Kinds::Missing | Kinds::Label(_))
            {
                let message = format!("this statement is never reached: {word} comes before it");
                self.report(Problem::P2208, statement.span, message).help =
                    Some("Remove it, or put the statement before it under a condition.".into());
                left = None;
            }
            self.locals.release();
            if self.declared_outside(label.take(), statement) {
                continue;
            }
            if let Kinds::Label(name) = &statement.kind {
                label = Some(name);
            }
            if let Some(kind) = self.statement(statement) {
                all.push(Statement { kind, span: statement.span });
            }
            left = match statement.kind {
                Kinds::Exit => Some("EXIT"),
                Kinds::Continue => Some("CONTINUE"),
                Kinds::Return => Some("RETURN"),
                Kinds::Goto(_) => Some("the jump"),
                Kinds::Label(_) => None,
                _ => left,
            };
        }
        self.lists.pop();
        all
    }

    fn statement(&mut self, statement: &ast::Statement) -> Option<StatementKind> {
        let span = statement.span;
        match &statement.kind {
            Kinds::Empty | Kinds::Missing => None,
            Kinds::Assign { targets, operator, value } => self.assignment(targets, *operator, value, span),
            Kinds::Expression(expression) => self.expression_statement(expression, span),
            Kinds::If { branches, otherwise } => {
                let branches: Vec<(Option<Value>, Vec<Statement>)> = branches
                    .iter()
                    .map(|branch| {
                        let condition = self.condition(&branch.condition);
                        (condition, self.statements(&branch.body))
                    })
                    .collect();
                let otherwise = self.statements(otherwise.as_deref().unwrap_or_default());
                let branches = branches.into_iter().map(|(condition, body)| Some((condition?, body))).collect::<Option<Vec<_>>>()?;
                Some(StatementKind::If { branches, otherwise })
            }
            Kinds::Case { selector, arms, otherwise } => self.case(selector, arms, otherwise.as_deref().unwrap_or_default()),
            Kinds::For(one) => self.for_loop(&one.variable, &one.from, &one.to, one.by.as_ref(), &one.body),
            Kinds::While { condition, body } => {
                let condition = self.condition(condition);
                let body = self.body_of_loop(None, body);
                Some(StatementKind::While { condition: condition?, body })
            }
            Kinds::Repeat { body, until } => {
                let body = self.body_of_loop(None, body);
                let until = self.condition(until)?;
                Some(StatementKind::Repeat { body, until })
            }
            Kinds::Exit | Kinds::Continue if self.loops.is_empty() => {
                let word = if matches!(statement.kind, Kinds::Exit) { "EXIT" } else { "CONTINUE" };
                let message = format!("{word} stands outside of a loop");
                self.report(Problem::P6213, span, message).help = Some("RETURN leaves the block.".to_owned());
                None
            }
            Kinds::Exit => Some(StatementKind::Exit { depth: 0 }),
            Kinds::Continue => Some(StatementKind::Continue { depth: 0 }),
            Kinds::Return => Some(StatementKind::Return),
            Kinds::Goto(name) => self.jump(name),
            Kinds::Label(name) => self.labels.get(&name.key()).map(|label| StatementKind::Label(label.number)),
            Kinds::Wire(wire, value) => self.wire(*wire, value, span),
            Kinds::Box(one) => self.diagram_box(one, span),
            Kinds::Region { body, .. } => Some(StatementKind::Block(self.statements(body))),
            Kinds::Try { body, catch, finally, .. } => {
                self.not_built(Span { end: span.start + 5, ..span }, "__TRY");
                for body in [body, catch, finally] {
                    self.statements(body);
                }
                None
            }
        }
    }

    /// Whether a statement is the declaration of an instance, `delay : TON;`, which reads like a label and a name; that is said.
    fn declared_outside(&mut self, label: Option<&Name>, statement: &ast::Statement) -> bool {
        let Kinds::Expression(expression) = &statement.kind else { return false };
        let ExpressionKind::Name(name) = &expression.kind else { return false };
        let is_type = self.names.local(&name.text).is_none()
            && match self.names.global(&name.text) {
                Some(Entity::Block(block)) => {
                    let of_system = block.kind == BlockKind::SystemFunctionBlock || self.names.is_of_library(block);
                    of_system || label.is_some() && block.kind == BlockKind::FunctionBlock
                }
                Some(Entity::Type(DataType::Instance { .. })) => true,
                Some(_) => false,
                None => standard::library::block_type(&name.text, self.dialect).is_some(),
            };
        if !is_type {
            return false;
        }
        let variable = label.map_or("x", |label| label.text.as_str());
        let message = match label {
            Some(label) => format!("`{} : {}` is a declaration, and it stands among the statements", label.text, name.text),
            None => format!("`{}` is a type, and no variable is declared among the statements", name.text),
        };
        let span = label.map_or(statement.span, |label| label.span.to(statement.span));
        self.report(Problem::P6216, span, message).help = Some(format!("Write `VAR {variable} : {}; END_VAR` before them.", name.text));
        self.outside.extend(label.map(Name::key));
        true
    }

    /// Whether a name is declared where no declaration can stand, which was said.
    pub(super) fn is_declared_outside(&self, name: &Name) -> bool {
        self.outside.contains(&name.key())
    }

    fn expression_statement(&mut self, expression: &Expression, span: Span) -> Option<StatementKind> {
        match &expression.kind {
            ExpressionKind::Call(call) => {
                match self.with_flow(expression, span, |checker, plain| checker.expression_statement(plain, span)) {
                    Some(done) => done,
                    None => self.call_statement(call, span),
                }
            }
            ExpressionKind::Parenthesized(inner) => self.expression_statement(inner, span),
            ExpressionKind::Missing => None,
            ExpressionKind::Binary(BinaryOperator::Equal, sign, ..) => {
                let diagnostic = self.report(Problem::P6216, span, "this compares and does nothing with the result");
                *diagnostic = diagnostic.clone().help("An assignment is written with `:=`.").fix(*sign, ":=", "write `:=`");
                None
            }
            ExpressionKind::Name(name) if self.names.local(&name.text).is_none() && DataType::from_any_word(&name.text).is_some() => {
                let message = format!("`{}` is a type, and no variable is declared among the statements", name.text);
                self.report(Problem::P6216, span, message).help = Some(format!("Write `VAR x : {}; END_VAR` before them.", name.text));
                None
            }
            _ => {
                let before = self.diagnostics.len();
                if let Some(done) = self.value_statement(expression, span) {
                    return done;
                }
                match self.reach(expression) {
                    Reached::Target(Target { data_type: DataType::Instance { .. }, name, .. }) => {
                        let end = Span { start: expression.span.end, ..expression.span };
                        let diagnostic = self.report(Problem::P6216, span, format!("a call of `{name}` needs brackets"));
                        *diagnostic = diagnostic.clone().fix(end, "()", "write `()`");
                    }
                    Reached::Other(Typed::Block(block)) => {
                        let end = Span { start: expression.span.end, ..expression.span };
                        let message = format!("a call of `{}` needs brackets", self.names.block_name(block));
                        let diagnostic = self.report(Problem::P6216, span, message);
                        *diagnostic = diagnostic.clone().fix(end, "()", "write `()`");
                    }
                    _ if self.diagnostics.len() > before => {}
                    _ => {
                        self.report(Problem::P6216, span, "this is a value and no statement: nothing happens with it");
                    }
                }
                None
            }
        }
    }

    /// A value that stands alone, where the dialect takes it: a property is read, a call without brackets is a call, all else does nothing.
    /// `None` for what is no such statement.
    fn value_statement(&mut self, expression: &Expression, span: Span) -> Option<Option<StatementKind>> {
        if !matches!(expression.kind, ExpressionKind::Name(_) | ExpressionKind::Member(..) | ExpressionKind::Index(..))
            || self.dialect.judge(Construct::ValueStatement) == Judgement::Reject
        {
            return None;
        }
        // An action, a method or a PROGRAM that is called without brackets.
        let call = ast::Call { callee: expression.clone(), arguments: Vec::new() };
        let called = self.quietly(|checker| checker.called(expression));
        let is_program = matches!(&called, Called::Instance(block, ..) if self.names.program(*block).is_some());
        if is_program || matches!(called, Called::Method(..) | Called::Action(_)) {
            self.judge(Construct::BareCall, expression.span);
            return Some(self.call_statement(&call, span));
        }
        match self.quietly(|checker| checker.reach(expression)) {
            Reached::Other(Typed::Scalar { value, .. }) => {
                self.judge(Construct::ValueStatement, expression.span);
                self.reach(expression);
                let (statement, _) = self.kept(value);
                Some(Some(statement.kind))
            }
            Reached::Target(Target { data_type, .. }) if !matches!(data_type, DataType::Instance { .. } | DataType::Void) => {
                self.judge(Construct::ValueStatement, expression.span);
                Some(None)
            }
            _ => None,
        }
    }

    fn assignment(&mut self, targets: &[Expression], operator: AssignOperator, value: &Expression, span: Span) -> Option<StatementKind> {
        let (last, others) = targets.split_last()?;
        let binary = match operator {
            AssignOperator::Becomes if others.is_empty() => return self.assign(last, value, span),
            AssignOperator::Becomes => {
                let mut all = vec![Statement { kind: self.assign(last, value, span)?, span }];
                let mut source = last;
                for target in others.iter().rev() {
                    all.push(Statement { kind: self.assign(target, source, span)?, span });
                    source = target;
                }
                return Some(StatementKind::Block(all));
            }
            AssignOperator::Add => BinaryOperator::Add,
            AssignOperator::Subtract => BinaryOperator::Subtract,
            AssignOperator::Multiply => BinaryOperator::Multiply,
            AssignOperator::Divide => BinaryOperator::Divide,
            AssignOperator::Attempt => return self.attempt(last, value, span),
            AssignOperator::Set => return self.set(last, true, value, span),
            AssignOperator::Reset => return self.set(last, false, value, span),
            AssignOperator::Coil(network) | AssignOperator::SetCoil(network) | AssignOperator::ResetCoil(network) => {
                if !self.is_bit_of_coil(last, network) {
                    self.for_nothing(value);
                    return None;
                }
                return match operator {
                    AssignOperator::SetCoil(_) => self.set(last, true, value, span),
                    AssignOperator::ResetCoil(_) => self.set(last, false, value, span),
                    _ => self.assign(last, value, span),
                };
            }
            AssignOperator::Refer => return self.refer(last, value, span),
        };
        // `a += b` is `a := a + b`.
        let boxed = |expression: &Expression| Box::new(expression.clone());
        let sign = Span { start: last.span.end, end: value.span.start, ..last.span };
        let sum = Expression { kind: ExpressionKind::Binary(binary, sign, boxed(last), boxed(value)), span };
        self.assign(last, &sum, span)
    }

    /// `x S= c`, `x R= c`.
    fn set(&mut self, target: &Expression, bit: bool, value: &Expression, span: Span) -> Option<StatementKind> {
        let condition = self.condition(value);
        let target = self.target(target)?;
        if target.data_type != DataType::Bool {
            let message = format!("`{}` is {}, and only a BOOL is set and reset", target.name, self.words(&target.data_type));
            self.report(Problem::P6200, target.place.span, message);
            return None;
        }
        let value = Value { kind: ValueKind::Constant(u64::from(bit)), scalar: Scalar::Bool, span };
        let assign = Statement { kind: StatementKind::Assign { target: target.place, value }, span };
        Some(StatementKind::If { branches: vec![(condition?, vec![assign])], otherwise: Vec::new() })
    }

    /// `r REF= x`: the reference itself is written, not what it refers to.
    fn refer(&mut self, target: &Expression, value: &Expression, span: Span) -> Option<StatementKind> {
        let reference = match self.reach_itself(target) {
            Reached::Target(found) => match &found.data_type {
                DataType::Reference(reference) if reference.kind == ReferenceKind::Reference => {
                    let data_type = self.finished(&reference.target);
                    // An input of codesys that is a REFERENCE TO is set from inside and outside.
                    let sound = found.role == Role::Input && found.through == Through::Itself || self.writable(&found, target.span);
                    Some((sound.then_some(found.place), data_type))
                }
                _ => None,
            },
            Reached::Other(Typed::Poison) => return None,
            Reached::Other(_) => None,
        };
        let Some((place, data_type)) = reference else {
            self.report(Problem::P6204, target.span, "`REF=` takes a variable that is declared as REFERENCE TO");
            return None;
        };
        let place = place?;
        // `r REF= 0` lets it refer to nothing.
        if let Typed::Integer { value: 0, .. } | Typed::Null = self.quietly(|checker| checker.expression(value)) {
            let value = Value { kind: ValueKind::Constant(0), scalar: Scalar::U64, span };
            return Some(StatementKind::Assign { target: place, value });
        }
        if let Reached::Target(source) = self.quietly(|checker| checker.reach(value))
            && ends_with_block(&source.place)
            && stays(&place)
        {
            self.dangles(&source.name, value.span);
            return None;
        }
        self.refer_to(place, &data_type, value, span)
    }

    /// Lets the reference at a place refer to a variable of a type.
    pub(super) fn refer_to(&mut self, place: Place, data_type: &DataType, value: &Expression, span: Span) -> Option<StatementKind> {
        let source = self.target(value)?;
        let value = Value { span, ..self.reference_to(source, data_type, value.span)? };
        Some(StatementKind::Assign { target: place, value })
    }

    /// The address of a variable of a type, or of a block that extends it.
    pub(super) fn reference_to(&mut self, source: Target, wanted: &DataType, span: Span) -> Option<Value> {
        let extends = match (&source.data_type, wanted) {
            (DataType::Instance { block, .. }, DataType::Instance { block: base, .. }) => self.names.objects().is_a(*block, *base),
            _ => false,
        };
        if !extends && !same_type(&source.data_type, wanted) {
            self.no_conversion(&source.data_type, wanted, span);
            return None;
        }
        Some(Value { kind: ValueKind::AddressOf(source.place), scalar: Scalar::U64, span })
    }

    /// What an expression writes to; whether it can be written is said.
    pub(super) fn target(&mut self, expression: &Expression) -> Option<Target> {
        let target = match self.reach(expression) {
            Reached::Target(target) => target,
            Reached::Other(Typed::Poison) => return None,
            Reached::Other(other) => {
                let message = match &expression.kind {
                    ExpressionKind::Name(Name { text, .. }) => {
                        format!("`{text}` is {}: it cannot be assigned to", self.constant_words(&other))
                    }
                    _ => format!("{} cannot be assigned to", self.what(&other)),
                };
                self.report(Problem::P6204, expression.span, message);
                return None;
            }
        };
        self.writable(&target, expression.span).then_some(target)
    }

    fn constant_words(&self, typed: &Typed) -> String {
        match typed {
            Typed::Integer { .. }
            | Typed::Real { .. }
            | Typed::Scalar { .. }
            | Typed::Text(_)
            | Typed::Moment(_)
            | Typed::Structured(..) => "a constant".to_owned(),
            other => self.what(other),
        }
    }

    /// Whether a variable can be assigned to.
    fn writable(&mut self, target: &Target, span: Span) -> bool {
        let name = &target.name;
        if let Some(control) = self.loops.iter().filter_map(|one| one.control.as_ref()).find(|(_, place)| same_place(place, &target.place))
        {
            let control = control.0.clone();
            if !self.judge(Construct::WrittenControl, span) {
                return false;
            }
            self.known.retain(|known| !same_place(&known.place, &target.place));
            let _ = control;
        }
        match (target.role, target.through) {
            (_, Through::Reference) => true,
            (Role::Constant, _) => {
                let message = match target.place.base {
                    crate::st::tree::Base::ComplexParameter(_) | crate::st::tree::Base::InstancePointer(_) => {
                        format!("`{name}` belongs to the caller: here it is only read")
                    }
                    _ => format!("`{name}` is a constant: it cannot be assigned to"),
                };
                self.report(Problem::P6204, span, message);
                false
            }
            // A test writes the outputs of what it mocks.
            (_, Through::InstanceOutput) if !self.dialect.is_test() => {
                let message = format!("`{name}` is an output, and only the block itself writes it");
                self.report(Problem::P6204, span, message);
                false
            }
            (_, Through::InstanceInternal)
                if !self.names.knows_instances() && !self.dialect.is_test() && !self.judge(Construct::WrittenInternal, span) =>
            {
                false
            }
            (Role::Input, _) => self.judge(Construct::WrittenInput, span),
            _ if target.place.base == crate::st::tree::Base::Area(Area::PeripheralInput) && !self.dialect.is_test() => {
                let message = format!("`{name}` is a peripheral input, and these can only be read");
                self.report(Problem::P6204, span, message);
                false
            }
            _ => true,
        }
    }

    /// `target := value`.
    pub(super) fn assign(&mut self, target: &Expression, value: &Expression, span: Span) -> Option<StatementKind> {
        // OK and ENO.
        if let ExpressionKind::Name(name) = &target.kind
            && (name.is("OK") || name.is("ENO"))
            && let Reached::Other(Typed::Scalar { value: Value { kind: ValueKind::Ok | ValueKind::Eno, .. }, .. }) = self.reach(target)
        {
            return Some(StatementKind::SetOk(self.value(value, &DataType::Bool)?));
        }
        if let Some(done) = self.with_flow(value, span, |checker, plain| checker.assign(target, plain, span)) {
            return done;
        }
        let written = target;
        if let Some(kind) = self.assign_property(target, value, span) {
            return kind;
        }
        let reached = self.target(target);
        let Some(target) = reached else {
            // The value may have mistakes of its own.
            self.for_nothing(value);
            return None;
        };
        if target.data_type == DataType::Void {
            self.for_nothing(value);
            return None;
        }
        if target.place.base == crate::st::tree::Base::Area(Area::PeripheralInput) {
            return self.set_peripheral(&target, value, span);
        }
        if let Some(kind) = self.result_into(&target, value, span) {
            return kind;
        }
        let typed = self.expression_for(value, &target.data_type);
        let (target, typed) = self.beside_address(target, written, value, typed);
        self.end_of_text(&target, &typed, value.span);
        if !self.dialect.is_test() {
            return self.store(target, typed, value.span, span);
        }
        let (place, data_type) = (target.place.clone(), target.data_type.clone());
        Some(and_hold(&place, &data_type, self.store(target, typed, value.span, span)?, span))
    }

    /// A function whose result is an array or a structure writes it to the target itself.
    fn result_into(&mut self, target: &Target, value: &Expression, span: Span) -> Option<Option<StatementKind>> {
        // Elementary values and texts come as expressions.
        if Kind::of(&target.data_type).is_some() || room_of(&target.data_type).is_some() {
            return None;
        }
        // An instance stays one of its own block, whatever the function delivers.
        if matches!(target.data_type, DataType::Instance { .. }) {
            return None;
        }
        let conversion = match self.by_target(value, &target.data_type) {
            Some(Some(conversion)) => Some(conversion),
            Some(None) => return Some(None),
            None => None,
        };
        let value = conversion.as_ref().unwrap_or(value);
        let ExpressionKind::Call(call) = &value.kind else { return None };
        let (block, callee) = match self.quietly(|checker| checker.called(&call.callee)) {
            Called::Function(block) => (block, Callee::Function(block)),
            Called::Method(block, callee) => (block, callee),
            Called::Standard(name) => {
                let block = self.structured_function(&name, &target.data_type)?;
                (block, Callee::Function(block))
            }
            _ => return None,
        };
        let interface = self.names.interface(block)?;
        let result = interface.variables.iter().find(|variable| variable.section == sieben_model::interface::Section::Return)?.clone();
        if Kind::of(&result.data_type).is_some() || room_of(&result.data_type).is_some() {
            return None;
        }
        self.called.insert(block);
        if !same_type(&result.data_type, &target.data_type) {
            self.no_conversion(&result.data_type, &target.data_type, value.span);
            return Some(None);
        }
        let (call, mut before) = match self.arguments(callee, &interface, call, value.span) {
            Some(found) => found,
            None => return Some(None),
        };
        let bytes = u32::try_from(target.data_type.bits().div_ceil(8)).unwrap_or(u32::MAX);
        // The function begins with an empty result: what it reads of the target must still be there.
        let read = call.arguments.iter().filter_map(Argument::place).any(|place| may_overlap(place, &target.place, bytes));
        let into = if read { self.temporary_place(bytes, span) } else { target.place.clone() };
        let output = Argument::OutputAggregate { parameter: result.offset, target: into.clone(), data_type: target.data_type.clone() };
        let mut arguments = call.arguments;
        arguments.push(output);
        let call = Call { arguments, result: DataType::Void, ..call };
        before.push(Statement { kind: StatementKind::Call(call), span });
        if read {
            let kind = StatementKind::Copy { target: target.place.clone(), source: into, bytes };
            before.push(Statement { kind, span });
        }
        Some(Some(StatementKind::Block(before)))
    }

    /// Writes a value to a variable.
    pub(super) fn store(&mut self, target: Target, typed: Typed, from: Span, span: Span) -> Option<StatementKind> {
        if Kind::of(&target.data_type).is_some() {
            let value = self.coerce(typed, from, &target.data_type)?;
            if let ValueKind::AddressOf(place) = &value.kind
                && ends_with_block(place)
                && stays(&target.place)
            {
                let message = "this variable lives only until the block ends, and a pointer to it longer";
                self.report(Problem::P6204, from, message).help = Some("Point to a variable of an instance or a global one.".to_owned());
                return None;
            }
            return Some(self.limited(target, value, span));
        }
        match (&target.data_type, typed) {
            (_, Typed::Poison) => None,
            (DataType::String(_) | DataType::WideString(_), typed) => {
                let room = text_room(&target)?;
                let source = self.text_of(typed, from, room.wide)?;
                if let Text::Constant(_) | Text::WideConstant(_) = &source
                    && let (long, most) = (source.room().characters_max, room_of(&target.data_type)?.characters_max)
                    && long > most
                {
                    let message = format!("this text has {long} characters and is cut to the {most} of `{}`", target.name);
                    self.report(Problem::P6201, from, message).help =
                        Some(format!("Declare it with room for {long} characters, or write a shorter text."));
                }
                Some(StatementKind::AssignString { target: target.place, room, source })
            }
            (DataType::DateAndTime, Typed::Moment(bytes)) => Some(StatementKind::Block(moment(&target.place, bytes, span))),
            (wanted, Typed::Structured(_, bytes)) if dtl::is_dtl(wanted) => {
                Some(StatementKind::Block(Self::write_dtl(&target.place, bytes, span)))
            }
            (wanted, Typed::Delivered(mut before, source))
                if same_type(wanted, &source.data_type) || self.is_extended_by(wanted, &source.data_type) =>
            {
                before.push(Statement { kind: self.copied(&target, source.place), span });
                Some(StatementKind::Block(before))
            }
            (wanted, Typed::Aggregate(source))
                if same_type(wanted, &source.data_type) || self.is_extended_by(wanted, &source.data_type) =>
            {
                if matches!(wanted, DataType::Instance { .. }) && !self.dialect.switches().temporaries_initialised {
                    let message = format!("`{}` is an instance, and instances are not copied", target.name);
                    self.report(Problem::P6204, target.place.span, message);
                    return None;
                }
                Some(self.copied(&target, source.place))
            }
            (wanted, other) => {
                let wanted = wanted.clone();
                match other {
                    Typed::Aggregate(source) | Typed::Delivered(_, source) => self.no_conversion(&source.data_type, &wanted, from),
                    other => {
                        let what = self.what(&other);
                        self.report(Problem::P6200, from, format!("`{}` is {}, and this is {what}", target.name, self.words(&wanted)));
                    }
                }
                None
            }
        }
    }

    /// Whether a value of the second type is an instance of a block that extends the first one.
    pub(super) fn is_extended_by(&self, wanted: &DataType, data_type: &DataType) -> bool {
        match (wanted, data_type) {
            (DataType::Instance { block: wanted, .. }, DataType::Instance { block, .. }) => self.names.objects().is_a(*block, *wanted),
            _ => false,
        }
    }

    /// A copy of a structure, an array or an instance, which stays one of its own block.
    fn copied(&self, target: &Target, source: Place) -> StatementKind {
        let bytes = u32::try_from(target.data_type.bits().div_ceil(8)).unwrap_or(u32::MAX);
        let typed = matches!(target.data_type, DataType::Instance { block, .. } if self.names.objects().is_typed(block));
        let skipped = if typed { TYPE_NUMBER_BITS } else { 0 };
        let behind = |place: Place| Place { offset: place.offset.saturating_add(skipped), ..place };
        StatementKind::Copy { target: behind(target.place.clone()), source: behind(source), bytes: bytes.saturating_sub(skipped / 8) }
    }

    /// An assignment to a subrange: a value outside its limits is not stored.
    fn limited(&mut self, target: Target, value: Value, span: Span) -> StatementKind {
        let plain = |value| StatementKind::Assign { target: target.place.clone(), value };
        let DataType::Subrange(subrange) = &target.data_type else { return plain(value) };
        let (least, most) = self.range_of(&value);
        if self.dialect.switches().index_fault != IndexFault::Skip || least >= subrange.low && most <= subrange.high {
            return plain(value);
        }
        let scalar = value.scalar;
        let (keep, value) = self.kept(value);
        let limit = |bound: i128| Value { kind: ValueKind::Constant(bound as u64 & super::literals::mask(scalar.bits())), scalar, span };
        let holds = |operator, bound| {
            let (op, _) = operators::binary(operator, scalar)?;
            Some(operators::compute(op, vec![value.clone(), limit(bound)], Scalar::Bool))
        };
        let Some((above, below)) = holds(BinaryOperator::GreaterEqual, subrange.low).zip(holds(BinaryOperator::LessEqual, subrange.high))
        else {
            return plain(value);
        };
        let inside = Value { kind: ValueKind::AndThen(Box::new(above), Box::new(below)), scalar: Scalar::Bool, span };
        let store = Statement { kind: plain(value), span };
        let otherwise = self.not_ok(span);
        let choice = Statement { kind: StatementKind::If { branches: vec![(inside, vec![store])], otherwise }, span };
        StatementKind::Block(vec![keep, choice])
    }

    fn jump(&mut self, name: &Name) -> Option<StatementKind> {
        let Some(label) = self.labels.get(&name.key()) else {
            // Where there are no jumps at all, the parser has said so.
            if [Construct::Goto, Construct::Jmp].iter().all(|&construct| self.dialect.judge(construct) == Judgement::Reject) {
                return None;
            }
            self.report(Problem::P3004, name.span, format!("the label `{}` does not exist in this block", name.text));
            return None;
        };
        // A jump leaves statements, it does not enter them.
        let (number, inside) = (label.number, self.lists.starts_with(&label.path));
        if !inside {
            let message = format!("`{}` stands inside a loop, an IF or a CASE that this jump is outside of", name.text);
            self.report(Problem::P6215, name.span, message);
            return None;
        }
        Some(StatementKind::Goto(number))
    }

    /// Numbers the labels of the block. Lists of statements are counted as [`Self::statements`] goes through them.
    pub(super) fn collect_labels(&mut self, statements: &[ast::Statement]) {
        let declared: HashSet<String> = self.block.labels.iter().map(|name| name.text.to_ascii_lowercase()).collect();
        let mut next = 0;
        self.labels_of(statements, &declared, &mut Vec::new(), &mut next);
    }

    fn labels_of(&mut self, statements: &[ast::Statement], declared: &HashSet<String>, path: &mut Vec<u32>, next: &mut u32) {
        path.push(*next);
        *next += 1;
        for statement in statements {
            match &statement.kind {
                Kinds::Label(name) => self.label(name, declared, path),
                Kinds::If { branches, otherwise } => {
                    branches.iter().for_each(|branch| self.labels_of(&branch.body, declared, path, next));
                    self.labels_of(otherwise.as_deref().unwrap_or_default(), declared, path, next);
                }
                Kinds::Case { arms, otherwise, .. } => {
                    arms.iter().for_each(|arm| self.labels_of(&arm.body, declared, path, next));
                    self.labels_of(otherwise.as_deref().unwrap_or_default(), declared, path, next);
                }
                Kinds::For(one) => self.labels_of(&one.body, declared, path, next),
                Kinds::While { body, .. } | Kinds::Repeat { body, .. } | Kinds::Region { body, .. } => {
                    self.labels_of(body, declared, path, next);
                }
                Kinds::Try { body, catch, finally, .. } => {
                    [body, catch, finally].into_iter().for_each(|body| self.labels_of(body, declared, path, next));
                }
                _ => {}
            }
        }
        path.pop();
    }

    fn label(&mut self, name: &Name, declared: &HashSet<String>, path: &[u32]) {
        if self.labels.contains_key(&name.key()) {
            self.report(Problem::P3005, name.span, format!("the label `{}` stands twice in this block", name.text));
            return;
        }
        if !declared.contains(&name.text.to_ascii_lowercase()) {
            self.judge(Construct::UndeclaredLabel, name.span);
        }
        let number = u32::try_from(self.labels.len()).unwrap_or(u32::MAX);
        self.labels.insert(name.key(), Label { number, path: path.to_vec() });
    }

    /// Looks at something without saying anything about it.
    pub(super) fn quietly<T>(&mut self, look: impl FnOnce(&mut Self) -> T) -> T {
        let before = std::mem::replace(&mut self.quiet, true);
        let result = look(self);
        self.quiet = before;
        result
    }
}

/// Whether what a call is given may have bytes in common with the variable that it writes.
fn may_overlap(given: &Place, written: &Place, bytes: u32) -> bool {
    use crate::st::tree::Base as B;
    let known = |base: &B| matches!(base, B::Area(_) | B::DataBlock(_));
    if given.base != written.base {
        // Two areas, or two data blocks, have nothing in common; the instance is a part of some data block.
        let refers = |base: &B| matches!(base, B::Reference(_));
        let local = [given, written].iter().any(|place| place.base == B::Area(Area::Local));
        return refers(&given.base) || refers(&written.base) || !(local || known(&given.base) && known(&written.base));
    }
    // What lies behind the variable is something else; how long what lies before it is, is not asked.
    let behind = written.indexes.is_empty() && given.offset >= written.offset.saturating_add(bytes.saturating_mul(8));
    !behind
}

/// The statements that write the eight bytes of a DATE_AND_TIME.
pub(super) fn moment(target: &Place, bytes: [u8; 8], span: Span) -> Vec<Statement> {
    let half = |offset: u32, bytes: [u8; 4]| {
        let value = Value { kind: ValueKind::Constant(u64::from(u32::from_be_bytes(bytes))), scalar: Scalar::U32, span };
        let target = Place { offset: target.offset + offset, ..target.clone() };
        Statement { kind: StatementKind::Assign { target, value }, span }
    };
    let [a, b, c, d, e, f, g, h] = bytes;
    vec![half(0, [a, b, c, d]), half(32, [e, f, g, h])]
}

/// Whether a body leaves its block.
pub(super) fn has_return(statements: &[ast::Statement]) -> bool {
    let mut found = false;
    walk::statements(statements, &mut |statement| found |= matches!(statement.kind, Kinds::Return));
    found
}

/// Whether a block mentions OK or ENO as a variable of its own.
pub(super) fn mentions_ok(block: &Block<'_>) -> bool {
    let switches = block.dialect.switches();
    let mut found = false;
    let mut see = |expression: &Expression| {
        found |= super::flow::asks_eno(expression);
        if let ExpressionKind::Name(name) = &expression.kind {
            found |= switches.ok_flag && name.is("OK") || (switches.eno_variable || switches.ok_flag) && name.is("ENO");
        }
    };
    walk::expressions(block.body, &mut see);
    block.actions.iter().for_each(|action| walk::expressions(&action.body, &mut see));
    let mut see = |statement: &ast::Statement| found |= super::diagrams::asks_eno(statement);
    walk::statements(block.body, &mut see);
    block.actions.iter().for_each(|action| walk::statements(&action.body, &mut see));
    found
}
