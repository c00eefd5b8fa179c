//! Arguments of a call: which actual parameter belongs to which formal one, and what is passed for it.

use std::collections::HashMap;
use std::sync::Arc;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Interface, Section, Variable};
use sieben_model::literal::Value as Initial;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, ReferenceKind};

use super::calls::{RET_VAL, counted, is_flow};
use super::expressions::same_type;
use super::names::{self, Role};
use super::places::Reached;
use super::typed::Typed;
use super::types::{Class, Implicit, Kind, implicit};
use super::{Checker, literals};
use crate::calling::pointers::any_type;
use crate::scope::nearest_parameter;
use crate::st::ast::{self, Direction, Expression, ExpressionKind, Name, Quoting};
use crate::st::declare::{initial, starting};
use crate::st::dialect::Construct;
use crate::st::dtl;
use crate::st::objects::TYPE_NUMBER_BITS;
use crate::st::open_arrays::{is_bound, is_open};
use crate::st::standard::operators::{Beyond, Rounding, convert as steps};
use crate::st::tree::{Argument, Call, Callee, Place, Scalar, Statement, StatementKind, Text, TextFunction, Value, ValueKind, room_of};
use crate::st::variants::is_told;

/// What the name of a parameter of the library ends with whose place belongs to another instruction with the same memory.
const OF_ANOTHER: &str = "_FREE";

impl Checker<'_> {
    /// All actual parameters of a call, and what has to happen before it.
    pub(super) fn arguments(
        &mut self,
        callee: Callee,
        interface: &Interface,
        call: &ast::Call,
        span: Span,
    ) -> Option<(Call, Vec<Statement>)> {
        // What fits parameters of which one was not understood, nobody knows.
        if self.names.is_broken(callee.block()) {
            self.look_at(&call.arguments);
            self.failed = true;
            return None;
        }
        let function = callee.is_function();
        let told = self.diagnostics.len();
        let mut all = Arguments::new(callee.block(), interface, self.written_out(&callee, &call.callee));
        if self.names.is_of_library(callee.block()) {
            all.formals.retain(|formal| !formal.name.ends_with(OF_ANOTHER));
        }
        let mut sound = true;
        let by_position = call.arguments.iter().filter(|argument| argument.name.is_none()).count();
        if by_position > 0 {
            let mixed = by_position < call.arguments.iter().filter(|argument| !is_flow(argument)).count();
            if mixed {
                sound &= self.judge(Construct::MixedArguments, span);
            }
            if !function {
                sound &= self.judge(Construct::PositionalFbCall, call.arguments[0].span);
            }
        }
        let by_name: HashMap<String, &Variable> =
            all.formals.iter().rev().map(|formal| (formal.name.to_ascii_lowercase(), *formal)).collect();
        let mut next = 0;
        for argument in &call.arguments {
            if let Some(name) = &argument.name
                && (name.is("EN") || name.is("ENO"))
                && interface.variable(&name.text).is_none()
            {
                sound &= self.flow_argument(name, argument, &mut all);
                continue;
            }
            let formal = match &argument.name {
                Some(name) => match by_name.get(&name.text.to_ascii_lowercase()) {
                    Some(&formal) => formal,
                    None => {
                        self.unknown_parameter(name, argument, call, &all.formals, &callee);
                        argument.value.iter().for_each(|value| drop(self.expression(value)));
                        sound = false;
                        continue;
                    }
                },
                None => {
                    let Some(&formal) = all.formals.get(next) else {
                        let count = all.formals.len();
                        let message = format!("{} takes {}", self.callee_name(&callee), counted(count, "parameter"));
                        self.report(Problem::P6219, argument.span, message);
                        sound = false;
                        break;
                    };
                    next += 1;
                    formal
                }
            };
            if let Some(&first) = all.given.get(&formal.name.to_ascii_lowercase()) {
                let message = format!("the parameter `{}` is given twice", formal.name);
                let diagnostic = self.report(Problem::P3011, argument.span, message);
                diagnostic.related.push((first, "first given here".to_owned()));
                sound = false;
                continue;
            }
            all.given.insert(formal.name.to_ascii_lowercase(), argument.span);
            let Some(value) = &argument.value else { continue };
            sound &= self.argument(formal, argument, value, &mut all);
        }
        sound &= self.omitted(&callee, call, &mut all, span);
        // A block of the S7 library is no word of the dialect: another file may have a function of that name.
        let is_word = |linked: &crate::library::LibraryBlock| crate::st::standard::catalogue::page(linked.name).is_some();
        let elsewhere = self.names.linked(callee.block()).is_some_and(|linked| !is_word(linked));
        if function && elsewhere && !self.dialect.switches().numbered_blocks {
            self.diagnostics.iter_mut().skip(told).for_each(|diagnostic| diagnostic.may_be_elsewhere = true);
        }
        let result = interface
            .variables
            .iter()
            .find(|variable| variable.section == Section::Return)
            .map_or(DataType::Void, |result| result.data_type.clone());
        let Arguments { arguments, enable, before, written_out, .. } = all;
        let of_library = matches!(callee, Callee::Function(block) if self.names.is_of_library(block));
        let clears_ok = self.reads_ok && of_library;
        sound.then_some((Call { callee, arguments, enable, result, clears_ok, of_library, written_out, span }, before))
    }

    /// The function of texts that a call of a block of the S7 library is. A name in quotation marks calls the block.
    fn written_out(&self, callee: &Callee, written: &Expression) -> Option<TextFunction> {
        let (Callee::Function(block), ExpressionKind::Name(name)) = (callee, &written.kind) else { return None };
        let linked = self.names.linked(*block)?;
        let by_name = name.quoting != Quoting::Global && name.is(linked.name);
        by_name.then(|| TextFunction::of_block(linked.name)).flatten()
    }

    pub(super) fn callee_name(&self, callee: &Callee) -> String {
        format!("`{}`", self.names.block_name(callee.block()))
    }

    /// The name that a call of a function gives it: `LEFT` and not `FC 20`.
    pub(super) fn name_in(&self, call: &ast::Call, callee: &Callee) -> String {
        match &call.callee.kind {
            ast::ExpressionKind::Name(name) if callee.is_function() => format!("`{}`", name.text),
            _ => self.callee_name(callee),
        }
    }

    fn unknown_parameter(&mut self, name: &Name, argument: &ast::Argument, call: &ast::Call, formals: &[&Variable], callee: &Callee) {
        if self.names.objects().lacks_base(callee.block()) {
            self.failed = true;
            return;
        }
        let block = self.callee_name(callee);
        // What takes a value out is no input, and what the call gives already is not meant.
        let fits = |formal: &Variable| match argument.direction {
            Direction::Delivered => formal.section != Section::Input,
            _ => formal.section != Section::Output,
        };
        let given = |formal: &Variable| call.arguments.iter().any(|one| one.name.as_ref().is_some_and(|name| name.is(&formal.name)));
        let candidates = formals.iter().filter(|formal| fits(formal) && !given(formal));
        let nearest = nearest_parameter(&name.text, candidates.map(|formal| formal.name.as_str()));
        let known: Vec<String> = formals.iter().take(12).map(|formal| format!("`{}`", formal.name)).collect();
        let help = match known.as_slice() {
            [] => "It has no parameters.".to_owned(),
            known => format!("It has {}.", known.join(", ")),
        };
        let diagnostic = self.report(Problem::P3009, name.span, format!("{block} has no parameter `{}`", name.text));
        diagnostic.help = Some(help);
        if let Some(nearest) = nearest {
            *diagnostic = diagnostic.clone().guess(name.span, nearest.clone(), format!("write `{nearest}`"));
        }
    }

    /// EN and ENO.
    fn flow_argument(&mut self, name: &Name, argument: &ast::Argument, all: &mut Arguments<'_>) -> bool {
        if !self.judge(Construct::EnEno, argument.span) {
            return false;
        }
        let Some(value) = &argument.value else { return true };
        if name.is("EN") {
            match self.condition(value) {
                Some(value) => all.enable = Some(value),
                None => return false,
            }
            return true;
        }
        let Some(target) = self.target(value) else { return false };
        if target.data_type != DataType::Bool {
            self.report(Problem::P4011, value.span, format!("ENO is BOOL, and `{}` is {}", target.name, self.words(&target.data_type)));
            return false;
        }
        all.arguments.push(Argument::Eno { target: target.place });
        true
    }

    /// `:=>` is `=>` for an output and `:=` for any other parameter: what was a guess of the parser is certain now.
    fn settle(&mut self, formal: &Variable, section: Section, sign: Span) {
        let (right, what) = match section {
            Section::Output => ("=>", "an output"),
            Section::InOut => (":=", "an in-out parameter"),
            _ => (":=", "an input"),
        };
        let message = format!("`{}` is {what}, which is given with `{right}`", formal.name);
        let diagnostic = self.report(Problem::P2007, sign, message);
        *diagnostic = diagnostic.clone().fix(sign, right, format!("write `{right}`"));
    }

    /// One actual parameter; whether it fits.
    fn argument(&mut self, formal: &Variable, argument: &ast::Argument, value: &Expression, all: &mut Arguments<'_>) -> bool {
        // The declaration of the parameter was wrong, which is reported there.
        if formal.data_type == DataType::Void {
            self.expression(value);
            return false;
        }
        match (formal.section, argument.direction) {
            (section, Direction::Unclear(sign)) => self.settle(formal, section, sign),
            (Section::Output, Direction::Assigned) if argument.name.is_some() && !self.judge(Construct::AssignedOutput, argument.span) => {
                return false;
            }
            (Section::Input | Section::InOut, Direction::Delivered) => {
                let message = format!("`{}` is no output, and `=>` takes a value out", formal.name);
                self.report(Problem::P6219, argument.span, message).help = Some(format!("Write `{} := …`.", formal.name));
                return false;
            }
            _ => {}
        }
        // A pointer goes in, whatever the block does with what it points to.
        let pointer = matches!(formal.data_type, DataType::Pointer | DataType::Any);
        match formal.section {
            _ if pointer => {
                let typed = self.expression_for(value, &formal.data_type);
                let sound = self.input(formal, typed, value.span, &mut all.arguments, &mut all.before);
                sound && self.tell(all.interface, formal, value, &mut all.arguments)
            }
            Section::Output => self.output(formal, value, all),
            Section::InOut => self.in_out(formal, value, all),
            _ if is_open(&formal.data_type) => self.open_input(formal, value, all),
            _ if matches!(&formal.data_type, DataType::Reference(reference) if reference.kind == ReferenceKind::Reference) => {
                self.referred_input(formal, value, all)
            }
            _ => {
                let typed = self.expression_for(value, &formal.data_type);
                let typed = if all.written_out.is_some() { self.number_in_text(formal, typed) } else { typed };
                if all.block.kind == BlockKind::Function && self.is_passing_instance(formal, &typed, value.span) {
                    return false;
                }
                if let Some(argument) = self.instance_argument(formal, &typed, all) {
                    all.arguments.push(argument);
                    return true;
                }
                self.input(formal, typed, value.span, &mut all.arguments, &mut all.before)
            }
        }
    }

    /// Whether a result with an instance in it would be passed on where it lies, which is said: in local data no method of it can be called.
    fn is_passing_instance(&mut self, formal: &Variable, typed: &Typed, span: Span) -> bool {
        let Typed::Delivered(_, result) = typed else { return false };
        if !result.data_type.holds_instance() {
            return false;
        }
        let message = format!("the instance in the result of `{}` does not last, and `{}` works on it", result.name, formal.name);
        self.report(Problem::P4011, span, message).help = Some("Put the result into a variable first, and pass that.".to_owned());
        true
    }

    /// An instance for a parameter that is one of the same block, or of one that it extends. What is copied into an instance leaves the
    /// number there that says of which block the parameter is.
    fn instance_argument(&mut self, formal: &Variable, typed: &Typed, all: &Arguments<'_>) -> Option<Argument> {
        let DataType::Instance { block: wanted, structure } = &formal.data_type else { return None };
        let Typed::Aggregate(target) = typed else { return None };
        let DataType::Instance { block, .. } = &target.data_type else { return None };
        if !self.names.objects().is_typed(*wanted) || !self.names.objects().is_a(*block, *wanted) {
            return None;
        }
        if all.block.kind == BlockKind::Function {
            let (source, data_type) = (target.place.clone(), formal.data_type.clone());
            return Some(Argument::Aggregate { parameter: formal.offset, source, data_type });
        }
        let mut rest = (**structure).clone();
        rest.fields.retain(|field| field.offset >= TYPE_NUMBER_BITS);
        rest.fields.iter_mut().for_each(|field| field.offset -= TYPE_NUMBER_BITS);
        rest.size = rest.size.saturating_sub(TYPE_NUMBER_BITS / 8);
        let behind = |offset: u32| offset.saturating_add(TYPE_NUMBER_BITS);
        let source = Place { offset: behind(target.place.offset), ..target.place.clone() };
        Some(Argument::Aggregate { parameter: behind(formal.offset), source, data_type: DataType::Struct(Arc::new(rest)) })
    }

    /// A variable for a parameter that is REFERENCE TO.
    fn referred_input(&mut self, formal: &Variable, value: &Expression, all: &mut Arguments<'_>) -> bool {
        let DataType::Reference(reference) = &formal.data_type else { return false };
        let target = match self.reach(value) {
            Reached::Target(target) => target,
            Reached::Other(Typed::Poison) => return false,
            Reached::Other(other) => {
                let message = format!("`{}` refers to a variable, and this is {}", formal.name, self.what(&other));
                self.report(Problem::P4011, value.span, message).help = Some("Put the value into a variable first.".to_owned());
                return false;
            }
        };
        let wanted = self.finished(&reference.target);
        let Some(value) = self.reference_to(target, &wanted, value.span) else { return false };
        all.arguments.push(Argument::Value { parameter: formal.offset, value });
        true
    }

    /// An actual parameter that is read.
    pub(super) fn input(
        &mut self,
        formal: &Variable,
        typed: Typed,
        span: Span,
        arguments: &mut Vec<Argument>,
        before: &mut Vec<Statement>,
    ) -> bool {
        if typed == Typed::Poison {
            return false;
        }
        let parameter = formal.offset;
        let argument = match &formal.data_type {
            DataType::String(_) | DataType::WideString(_) => {
                let Some(room) = room_of(&formal.data_type) else { return false };
                let Some(text) = self.text_of(typed, span, room.wide) else { return false };
                Argument::Text { parameter, text, room }
            }
            DataType::Pointer | DataType::Any => {
                let written = match &typed {
                    Typed::Pointer(literal) => literals::written_any(literal),
                    _ => None,
                };
                let Some((place, data_type)) = self.pointed(typed, span, formal) else { return false };
                let any = (formal.data_type == DataType::Any).then(|| written.unwrap_or_else(|| any_type(&data_type)));
                Argument::Pointer { parameter, place, data_type, any }
            }
            number if number.is_number() => {
                let wanted = number.clone();
                let value = match typed {
                    Typed::Number { data_type, value } if data_type == wanted => value,
                    Typed::Block(block) if matches_block(&wanted, block) => {
                        Value { kind: ValueKind::Constant(u64::from(block.number)), scalar: Scalar::U16, span }
                    }
                    other => {
                        self.wrong_argument(formal, &other, span);
                        return false;
                    }
                };
                Argument::Number { parameter, value }
            }
            wanted if Kind::of(wanted).is_some() => {
                let Some(value) = self.coerce(typed, span, wanted) else { return false };
                Argument::Value { parameter, value }
            }
            wanted => match typed {
                Typed::Aggregate(target) if same_type(&target.data_type, wanted) => {
                    Argument::Aggregate { parameter, source: target.place, data_type: target.data_type }
                }
                Typed::Delivered(mut statements, target) if same_type(&target.data_type, wanted) => {
                    self.keep_arguments(arguments, before);
                    before.append(&mut statements);
                    Argument::Aggregate { parameter, source: target.place, data_type: target.data_type }
                }
                Typed::Structured(_, bytes) if dtl::is_dtl(wanted) => {
                    let source = self.temporary_place(dtl::BYTES as u32, span);
                    before.extend(Self::write_dtl(&source, bytes, span));
                    Argument::Aggregate { parameter, source, data_type: wanted.clone() }
                }
                Typed::Moment(bytes) if *wanted == DataType::DateAndTime => {
                    let source = self.temporary_place(8, span);
                    before.extend(super::statements::moment(&source, bytes, span));
                    Argument::Aggregate { parameter, source, data_type: DataType::DateAndTime }
                }
                other => {
                    self.wrong_argument(formal, &other, span);
                    return false;
                }
            },
        };
        arguments.push(argument);
        true
    }

    /// Arguments that statements in front of the call come behind keep what they are: `Both(n, Next())` is given the n from before.
    fn keep_arguments(&mut self, arguments: &mut [Argument], before: &mut Vec<Statement>) {
        for argument in arguments {
            match argument {
                Argument::Value { value, .. } | Argument::Number { value, .. } if !matches!(value.kind, ValueKind::Constant(_)) => {
                    let (statement, kept) = self.kept(value.clone());
                    before.push(statement);
                    *value = kept;
                }
                Argument::Text { text, .. } if !matches!(text, Text::Constant(_) | Text::WideConstant(_)) => {
                    let (room, span) = (super::texts::known_room(text), before.last().map_or(self.block.end, |last| last.span));
                    let target = self.temporary_place(room.bytes(), span);
                    let kept = Text::Place { place: target.clone(), room };
                    let source = std::mem::replace(text, kept);
                    before.push(Statement { kind: StatementKind::AssignString { target, room, source }, span });
                }
                Argument::Aggregate { source, data_type, .. } => {
                    let bytes = u32::try_from(data_type.bits().div_ceil(8)).unwrap_or(u32::MAX);
                    let span = source.span;
                    let target = self.temporary_place(bytes, span);
                    let source = std::mem::replace(source, target.clone());
                    before.push(Statement { kind: StatementKind::Copy { target, source, bytes }, span });
                }
                _ => {}
            }
        }
    }

    fn wrong_argument(&mut self, formal: &Variable, typed: &Typed, span: Span) {
        if *typed != Typed::Poison {
            let what = self.what(typed);
            let message = format!("the parameter `{}` is {}, and this is {what}", formal.name, self.words(&formal.data_type));
            self.report(Problem::P4011, span, message);
        }
    }

    /// What a POINTER or ANY points to.
    fn pointed(&mut self, typed: Typed, span: Span, formal: &Variable) -> Option<(Place, DataType)> {
        match typed {
            Typed::Aggregate(target) => Some((target.place, target.data_type)),
            Typed::Scalar { value: Value { kind: ValueKind::Load(place), .. }, data_type } => Some((place, data_type)),
            Typed::Text(Text::Place { place, room }) => Some((place, super::texts::type_of_room(room))),
            Typed::Pointer(pointer) => match literals::pointed(&pointer, span) {
                Some(found) => Some(found),
                None => {
                    self.not_built(span, "this pointer");
                    None
                }
            },
            Typed::Block(block) if block.kind == BlockKind::DataBlock => {
                let target = self.data_block(block, span)?;
                Some((target.place, target.data_type))
            }
            other => {
                self.wrong_argument(formal, &other, span);
                None
            }
        }
    }

    /// An actual parameter that is written after the call.
    fn output(&mut self, formal: &Variable, value: &Expression, all: &mut Arguments<'_>) -> bool {
        let Some(target) = self.target(value) else { return false };
        let parameter = formal.offset;
        let rooms = room_of(&formal.data_type).zip(super::texts::text_room(&target)).filter(|(from, to)| from.wide == to.wide);
        let argument = match (&formal.data_type, &target.data_type) {
            _ if let Some((room, target_room)) = rooms => Argument::OutputText { parameter, room, target_room, target: target.place },
            (from, to) => match (Kind::of(from), Kind::of(to)) {
                (Some(source), Some(kind)) => {
                    let exact = from == to || same_type(from, to);
                    // An output is converted by operations on one value, which cannot count nanoseconds instead of milliseconds.
                    let longer = source.class == kind.class
                        && source.bits != kind.bits
                        && matches!(source.class, Class::Duration | Class::TimeOfDay | Class::Date);
                    match if longer {
                        Implicit::No
                    } else if exact {
                        Implicit::Yes
                    } else {
                        implicit(source, kind, self.dialect)
                    } {
                        Implicit::Yes => {}
                        // The parts of a date are any integers.
                        Implicit::No
                            if source.is_integer()
                                && kind.is_integer()
                                && all.block.kind == BlockKind::Function
                                && self.names.is_of_library(all.block) =>
                        {
                            let large = ["YEAR", "MILLISECOND", "MICROSECOND", "NANOSECOND"].contains(&formal.name.as_str());
                            if large && kind.bits < 16 {
                                let message = format!("`{}` may be more than {} holds", formal.name, self.words(to));
                                self.report(Problem::P6201, value.span, message);
                            }
                        }
                        Implicit::Warned(loss) => {
                            let message = format!("{} becomes {} here: {}", self.words(from), self.words(to), loss.words());
                            self.report(Problem::P6201, value.span, message);
                        }
                        Implicit::No => {
                            let message = format!(
                                "the output `{}` is {}, and `{}` is {}",
                                formal.name,
                                self.words(from),
                                target.name,
                                self.words(to)
                            );
                            self.report(Problem::P4011, value.span, message);
                            return false;
                        }
                    }
                    let (scalar, wanted) = (source.scalar(self.dialect), kind.scalar(self.dialect));
                    let convert = steps(scalar, wanted, Rounding::HalfEven, Beyond::Nearest);
                    Argument::Output { parameter, scalar, target: target.place, convert, converted: wanted }
                }
                _ if same_type(from, to) => Argument::OutputAggregate { parameter, target: target.place, data_type: to.clone() },
                _ => {
                    let message =
                        format!("the output `{}` is {}, and `{}` is {}", formal.name, self.words(from), target.name, self.words(to));
                    self.report(Problem::P4011, value.span, message);
                    return false;
                }
            },
        };
        all.arguments.push(argument);
        true
    }

    /// A variable that the block works on itself.
    fn in_out(&mut self, formal: &Variable, value: &Expression, all: &mut Arguments<'_>) -> bool {
        if matches!(formal.data_type, DataType::Pointer | DataType::Any) || formal.data_type.is_number() {
            let typed = self.expression(value);
            return self.input(formal, typed, value.span, &mut all.arguments, &mut all.before);
        }
        if self.names.is_read_only(all.block, &formal.name) {
            return self.read_in_out(formal, value, all);
        }
        // A data block is the variable that it holds.
        let of_block = match self.quietly(|checker| checker.reach(value)) {
            Reached::Other(Typed::Block(block)) if block.kind == BlockKind::DataBlock => Some(block),
            _ => None,
        };
        let target = match of_block {
            Some(block) => self.data_block(block, value.span),
            None => self.target(value),
        };
        let Some(target) = target else { return false };
        if is_open(&formal.data_type)
            && let Some(mut bounds) = self.bounds_of(formal, &target, all.interface)
        {
            all.arguments.append(&mut bounds);
            all.arguments.push(Argument::InOut { parameter: formal.offset, place: target.place, data_type: target.data_type });
            return true;
        }
        let lengths = room_of(&formal.data_type).zip(room_of(&target.data_type)).is_some_and(|(a, b)| a.wide == b.wide);
        let extends = match (&formal.data_type, &target.data_type) {
            (DataType::Instance { block: wanted, .. }, DataType::Instance { block, .. }) => self.names.objects().is_a(*block, *wanted),
            _ => false,
        };
        if !lengths && !extends && !same_type(&formal.data_type, &target.data_type) {
            let message = format!(
                "`{}` is an in-out parameter of type {} and takes a variable of that type, and `{}` is {}",
                formal.name,
                self.words(&formal.data_type),
                target.name,
                self.words(&target.data_type)
            );
            self.report(Problem::P4011, value.span, message).help =
                Some("Copy it to a variable of the right type, and back after the call.".into());
            return false;
        }
        all.arguments.push(Argument::InOut { parameter: formal.offset, place: target.place, data_type: target.data_type });
        true
    }

    /// A value for VAR_IN_OUT CONSTANT: a variable that fits is given itself, all else is kept in one first.
    fn read_in_out(&mut self, formal: &Variable, value: &Expression, all: &mut Arguments<'_>) -> bool {
        let span = value.span;
        let parameter = formal.offset;
        let fits = |checker: &Self, data_type: &DataType| {
            let lengths = room_of(&formal.data_type).zip(room_of(data_type)).is_some_and(|(a, b)| a.wide == b.wide);
            let extends = match (&formal.data_type, data_type) {
                (DataType::Instance { block: wanted, .. }, DataType::Instance { block, .. }) => {
                    checker.names.objects().is_a(*block, *wanted)
                }
                _ => false,
            };
            lengths || extends || same_type(&formal.data_type, data_type)
        };
        if let Reached::Target(target) = self.quietly(|checker| checker.reach(value)) {
            if is_open(&formal.data_type)
                && let Some(mut bounds) = self.bounds_of(formal, &target, all.interface)
            {
                all.arguments.append(&mut bounds);
                all.arguments.push(Argument::InOut { parameter, place: target.place, data_type: target.data_type });
                return true;
            }
            if fits(self, &target.data_type) {
                all.arguments.push(Argument::InOut { parameter, place: target.place, data_type: target.data_type });
                return true;
            }
        }
        let typed = self.expression_for(value, &formal.data_type);
        let (place, data_type, kind) = match typed {
            Typed::Poison => return false,
            typed if self.is_passing_instance(formal, &typed, span) => return false,
            Typed::Delivered(mut statements, target) if fits(self, &target.data_type) => {
                all.before.append(&mut statements);
                all.arguments.push(Argument::InOut { parameter, place: target.place, data_type: target.data_type });
                return true;
            }
            typed if let Some(wanted) = room_of(&formal.data_type) => {
                let Some(source) = self.text_of(typed, span, wanted.wide) else { return false };
                let room = super::texts::known_room(&source);
                let place = self.temporary_place(room.bytes(), span);
                let kind = StatementKind::AssignString { target: place.clone(), room, source };
                (place, super::texts::type_of_room(room), kind)
            }
            typed if let Some(kind) = Kind::of(&formal.data_type) => {
                let Some(value) = self.coerce(typed, span, &formal.data_type) else { return false };
                let place = self.temporary_place(kind.bits.div_ceil(8), span);
                (place.clone(), formal.data_type.clone(), StatementKind::Assign { target: place, value })
            }
            other => {
                self.wrong_argument(formal, &other, span);
                return false;
            }
        };
        all.before.push(Statement { kind, span });
        all.arguments.push(Argument::InOut { parameter, place, data_type });
        true
    }

    /// An array for ARRAY[*] of VAR_INPUT: the function reads that of the caller.
    fn open_input(&mut self, formal: &Variable, value: &Expression, all: &mut Arguments<'_>) -> bool {
        let target = match self.reach(value) {
            Reached::Target(target) => target,
            Reached::Other(Typed::Poison) => return false,
            Reached::Other(other) => {
                self.wrong_argument(formal, &other, value.span);
                return false;
            }
        };
        let Some(mut bounds) = self.bounds_of(formal, &target, all.interface) else {
            let message = format!(
                "the parameter `{}` is {}, and `{}` is {}",
                formal.name,
                self.words(&formal.data_type),
                target.name,
                self.words(&target.data_type)
            );
            self.report(Problem::P4011, value.span, message);
            return false;
        };
        all.arguments.append(&mut bounds);
        all.arguments.push(Argument::InOut { parameter: formal.offset, place: target.place, data_type: target.data_type });
        true
    }

    /// A text, an array or a structure that a call of a function leaves out: what its declaration says.
    fn initial_argument(&mut self, formal: &Variable, all: &mut Arguments<'_>, span: Span) {
        let parameter = formal.offset;
        let text = match &formal.data_type {
            DataType::String(_) => {
                let image = initial::bytes(&formal.data_type, &formal.initial);
                Text::Constant(image[2..].iter().copied().take(usize::from(image[1])).collect())
            }
            DataType::WideString(_) => {
                let image = initial::bytes(&formal.data_type, &formal.initial);
                let units: Vec<u16> = image.chunks_exact(2).map(|unit| u16::from_be_bytes([unit[0], unit[1]])).collect();
                Text::WideConstant(units[2..].iter().copied().take(usize::from(units[1])).collect())
            }
            DataType::Struct(_) | DataType::Array { .. } | DataType::DateAndTime => {
                let image = initial::bytes(&formal.data_type, &formal.initial);
                if image.iter().all(|&byte| byte == 0) {
                    return;
                }
                let place = self.temporary_place(u32::try_from(image.len()).unwrap_or(u32::MAX), span);
                let (name, role, data_type) = (formal.name.clone(), Role::Temp, formal.data_type.clone());
                let variable =
                    names::Variable { name, role, data_type: data_type.clone(), base: place.base.clone(), offset: place.offset, span };
                all.before.extend(starting(&variable, &formal.initial, span));
                return all.arguments.push(Argument::Aggregate { parameter, source: place, data_type });
            }
            _ => return,
        };
        if let Some(room) = room_of(&formal.data_type).filter(|_| text.room().characters_max > 0) {
            all.arguments.push(Argument::Text { parameter, text, room });
        }
    }

    /// What a call leaves out: an initial value, nothing, or an error.
    fn omitted(&mut self, callee: &Callee, call: &ast::Call, all: &mut Arguments<'_>, span: Span) -> bool {
        let function = callee.is_function();
        let accepts = |construct| self.dialect.judge(construct) == crate::st::dialect::Judgement::Accept;
        let needs_all = !accepts(Construct::OmittedInput);
        // In an instance of S7 an in-out parameter of an elementary type is a value, which stays there.
        let needs_in_outs = function || !accepts(Construct::OmittedInOut);
        // A standard function has no input that could be left out, however it is built.
        let needs_inputs = needs_all || matches!(callee, Callee::Function(block) if self.names.is_of_library(*block));
        // A call by position gives every input, as the standard has it: who leaves one out counts wrong. What is declared with a value of
        // its own is made to be left out.
        let by_position = function && call.arguments.iter().any(|argument| argument.name.is_none() && !is_flow(argument));
        let mut missing = Vec::new();
        let mut inputs = true;
        for formal in all.formals.clone() {
            let given = all.given.contains_key(&formal.name.to_ascii_lowercase());
            if given || formal.section == Section::Output && formal.name.eq_ignore_ascii_case(RET_VAL) {
                continue;
            }
            match formal.section {
                Section::Input if is_open(&formal.data_type) => missing.push(format!("`{}`", formal.name)),
                Section::InOut if needs_in_outs || Kind::of(&formal.data_type).is_none() => {
                    missing.push(format!("`{}`", formal.name));
                    inputs = false;
                }
                Section::Input if function => {
                    if let Some(kind) = Kind::of(&formal.data_type)
                        && let Some(bits) = initial_bits(&formal.initial, kind)
                    {
                        let value = Value { kind: ValueKind::Constant(bits), scalar: kind.scalar(self.dialect), span };
                        all.arguments.push(Argument::Value { parameter: formal.offset, value });
                    } else if Kind::of(&formal.data_type).is_none() {
                        self.initial_argument(formal, all, span);
                    }
                    if needs_inputs || by_position && !self.names.has_initial(callee.block(), &formal.name) {
                        missing.push(format!("`{}`", formal.name));
                    }
                }
                Section::Output if function && needs_all => {
                    missing.push(format!("`{}`", formal.name));
                }
                _ => {}
            }
        }
        if missing.is_empty() {
            return true;
        }
        let block = self.name_in(call, callee);
        let message = format!("the call of {block} leaves out {}", missing.join(", "));
        let diagnostic = self.report(Problem::P3010, span, message);
        if !inputs {
            diagnostic.help = Some("An in-out parameter needs a variable in every call.".to_owned());
        } else if by_position && !needs_all {
            diagnostic.help = Some("Give every input a value, or name those that are given, `name := value`.".to_owned());
        }
        false
    }
}

/// The parameters of a call while they are collected.
pub(super) struct Arguments<'a> {
    /// The block that is called.
    block: BlockId,
    /// The function of texts that is called.
    written_out: Option<TextFunction>,
    /// The formal ones in the order of their declaration.
    formals: Vec<&'a Variable>,
    interface: &'a Interface,
    /// Those that are given, by their names in lower case.
    given: HashMap<String, Span>,
    arguments: Vec<Argument>,
    enable: Option<Value>,
    before: Vec<Statement>,
}

impl<'a> Arguments<'a> {
    fn new(block: BlockId, interface: &'a Interface, written_out: Option<TextFunction>) -> Self {
        let is_formal =
            |variable: &&Variable| variable.section != Section::Return && !is_bound(interface, variable) && !is_told(interface, variable);
        let mut formals: Vec<&Variable> = interface.parameters().filter(is_formal).collect();
        // The interface has its sections in order; arguments by position follow the source. Blocks without one keep their order.
        formals.sort_by_key(|variable| variable.span.start);
        Self { block, written_out, formals, interface, given: HashMap::new(), arguments: Vec::new(), enable: None, before: Vec::new() }
    }
}

fn matches_block(wanted: &DataType, block: BlockId) -> bool {
    match wanted {
        DataType::BlockData | DataType::BlockSystemData => block.kind == BlockKind::DataBlock,
        DataType::BlockFunction => matches!(block.kind, BlockKind::Function | BlockKind::SystemFunction),
        DataType::BlockFunctionBlock => matches!(block.kind, BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock),
        _ => false,
    }
}

/// The bits of the initial value of a declaration.
fn initial_bits(initial: &[Initial], kind: Kind) -> Option<u64> {
    let bits = match initial {
        [Initial::Image(bytes)] if bytes.len() <= 8 => bytes.iter().fold(0, |word, &byte| word << 8 | u64::from(byte)),
        [value] => value.bits()?,
        _ => return None,
    };
    Some(bits & literals::mask(kind.bits))
}
