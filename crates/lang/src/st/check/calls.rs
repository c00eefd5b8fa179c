//! Calls: what is called, and which actual parameter belongs to which formal one.

use std::collections::HashMap;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Interface, Section, Variable};
use sieben_model::literal::Value as Initial;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, ReferenceKind};

use super::expressions::same_type;
use super::members::is_super;
use super::names::{self, Entity, Role};
use super::places::Reached;
use super::typed::{Target, Through, Typed};
use super::types::{Class, Implicit, Kind, implicit};
use super::{Checker, literals};
use crate::calling::pointers::any_type;
use crate::library;
use crate::scope::nearest_parameter;
use crate::st::ast::{self, Direction, Expression, ExpressionKind, MemberKind, Name, Quoting};
use crate::st::declare::{initial, starting};
use crate::st::dialect::Construct;
use crate::st::dtl;
use crate::st::open_arrays::{is_bound, is_open};
use crate::st::standard;
use crate::st::standard::operators::{Beyond, Rounding, convert as steps};
use crate::st::tree::{
    Argument, Base, Call, Callee, Dispatch, Place, Scalar, Statement, StatementKind, Text, TextFunction, Value, ValueKind, room_of,
};
use crate::st::variants::is_told;

/// The output of system functions that is their result.
const RET_VAL: &str = "RET_VAL";

/// What the name of a parameter of the library ends with whose place belongs to another instruction with the same memory.
const OF_ANOTHER: &str = "_FREE";

/// What an expression in front of brackets calls.
pub(super) enum Called {
    /// FC or SFC.
    Function(BlockId),
    /// FB or SFB with its instance, which may say that it is of another block.
    Instance(BlockId, Target, Option<Dispatch>),
    /// A method: the function that gives the parameters.
    Method(BlockId, Callee),
    /// A standard function of this name, if there is one.
    Standard(Name),
    /// An action of the block.
    Action(usize),
    /// Nothing that can be called, which is reported.
    Nothing,
}

impl Checker<'_> {
    /// What is called.
    pub(super) fn called(&mut self, callee: &Expression) -> Called {
        if is_super(callee) {
            return self.called_super(callee.span);
        }
        match &callee.kind {
            ExpressionKind::Parenthesized(inner) => self.called(inner),
            ExpressionKind::Name(name) => self.called_name(name),
            ExpressionKind::Global(name) => match self.names.global(&name.text) {
                Some(Entity::Block(block)) => self.called_block(block, callee.span),
                _ => Called::Standard(name.clone()),
            },
            ExpressionKind::Member(base, name) => self.called_member(callee, base, name),
            // `FB10.DB20`: behind another block than a data block this is no data byte.
            ExpressionKind::DataAddress(address) if !address.percent => self.called_member(callee, &address.block, &address.written),
            ExpressionKind::Index(..) | ExpressionKind::Dereference(_) => match self.reach(callee) {
                Reached::Target(target) => self.called_target(target, callee.span),
                Reached::Other(typed) => self.not_callable(&typed, callee.span),
            },
            // `FB10.DB20` looks like a byte of a data block.
            ExpressionKind::DataAddress(address) => self.called_member(callee, &address.block, &address.written),
            ExpressionKind::Missing => Called::Nothing,
            ExpressionKind::This => match self.this(callee.span) {
                Some(target) => self.called_target(target, callee.span),
                None => Called::Nothing,
            },
            _ => {
                let typed = self.expression(callee);
                self.not_callable(&typed, callee.span)
            }
        }
    }

    fn called_name(&mut self, name: &Name) -> Called {
        if let Some(action) = self.block.actions.iter().position(|action| name.is(&action.name.text)) {
            return Called::Action(action);
        }
        if let Some(method) = self.own_member(name, MemberKind::Method) {
            return self.called_method(method, name.span);
        }
        let local = match name.quoting {
            Quoting::Global => None,
            // Inside a function its name is the result; with brackets it is a call of the function.
            _ => self.names.local(&name.text).filter(|found| !matches!(found, Entity::Variable(variable) if variable.role == Role::Result)),
        };
        let found = match name.quoting {
            Quoting::Local => local,
            _ => local.or_else(|| self.names.global(&name.text)),
        };
        if let Some(block) = self.bare_block_type(name, found.as_ref()) {
            self.needs_instance(&name.text, block, name.span);
            return Called::Nothing;
        }
        match found {
            // That a block of the S7 library is linked changes nothing for a dialect whose function of that name is another one.
            Some(Entity::Block(block))
                if library::by_name(&name.text).is_some_and(|known| known.block == block)
                    && standard::library::is_own(&name.text, self.dialect) =>
            {
                Called::Standard(name.clone())
            }
            Some(Entity::Block(block)) => self.called_block(block, name.span),
            // A variable may be called like a standard function; brackets behind it mean that one.
            Some(Entity::Variable(variable))
                if name.quoting == Quoting::Bare
                    && (Kind::of(&variable.data_type).is_some_and(|kind| kind.class != Class::Reference)
                        || room_of(&variable.data_type).is_some())
                    && standard::catalogue::page(&name.text).is_some() =>
            {
                Called::Standard(name.clone())
            }
            Some(Entity::Variable(variable)) => {
                let target = Target {
                    place: Place { base: variable.base, offset: variable.offset, indexes: Vec::new(), span: name.span },
                    data_type: variable.data_type,
                    role: variable.role,
                    name: variable.name,
                    through: Through::Itself,
                };
                self.called_target(target, name.span)
            }
            None | Some(Entity::Type(_) | Entity::EnumValue { .. } | Entity::Qualifier | Entity::Ambiguous(_)) => {
                Called::Standard(name.clone())
            }
            Some(Entity::Constant(_) | Entity::Number { .. }) => {
                self.report(
                    Problem::P6217,
                    name.span,
                    format!("`{}` cannot be called: it is neither a function nor an instance", name.text),
                );
                Called::Nothing
            }
        }
    }

    fn called_block(&mut self, block: BlockId, span: Span) -> Called {
        match block.kind {
            BlockKind::Function | BlockKind::SystemFunction => Called::Function(block),
            BlockKind::DataBlock => match self.data_block(block, span) {
                Some(target) => self.called_target(target, span),
                None => Called::Nothing,
            },
            BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock => {
                self.needs_instance(&self.names.block_name(block), block, span);
                Called::Nothing
            }
            BlockKind::OrganizationBlock | BlockKind::UserDefinedType => {
                self.report(Problem::P6217, span, format!("`{}` cannot be called: only the CPU starts it", self.names.block_name(block)));
                Called::Nothing
            }
        }
    }

    /// The function block that the dialect brings along under this name, where the project has nothing else of that name.
    fn bare_block_type(&mut self, name: &Name, found: Option<&Entity>) -> Option<BlockId> {
        let of_system = |block: &BlockId| matches!(block.kind, BlockKind::SystemFunctionBlock | BlockKind::SystemFunction);
        let free = match found {
            None | Some(Entity::Type(DataType::Instance { .. })) => true,
            Some(Entity::Block(block)) => of_system(block),
            Some(_) => false,
        };
        if !free || name.quoting == Quoting::Global || self.is_inner(&name.text) {
            return None;
        }
        let block = self.names.provided(&standard::library::block_type(&name.text, self.dialect)?)?;
        matches!(block.kind, BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock).then_some(block)
    }

    /// Says that a function block is not called by its own name.
    fn needs_instance(&mut self, name: &str, block: BlockId, span: Span) {
        let interface = self.names.interface(block);
        let inputs = interface.iter().flat_map(|interface| interface.parameters());
        let inputs = inputs.filter(|formal| formal.section == Section::Input).take(2).map(|formal| format!("{} := …", formal.name));
        let inputs = inputs.collect::<Vec<_>>().join(", ");
        let with_data_block = match self.dialect.judge(Construct::InstanceOfBlock) {
            crate::st::dialect::Judgement::Accept => format!(" Or call it with an instance data block, `{name}.DB20({inputs})`."),
            _ => String::new(),
        };
        let message = format!("`{name}` is a function block: what is called is an instance of it");
        let help = format!("Declare an instance, `VAR inst : {name}; END_VAR`, and call that: `inst({inputs})`.{with_data_block}");
        self.report(Problem::P6217, span, message).help = Some(help);
    }

    fn called_target(&mut self, target: Target, span: Span) -> Called {
        match target.data_type {
            DataType::Instance { block, .. } => {
                match self.without_body(block, span) || self.no_memory_instruction(block, &target, None, span) {
                    true => Called::Nothing,
                    false => {
                        let dispatch = self.dispatch_of(block, &target);
                        Called::Instance(block, target, dispatch)
                    }
                }
            }
            DataType::Void => Called::Nothing,
            _ => {
                let message = format!("`{}` is {} and cannot be called", target.name, self.words(&target.data_type));
                let hides = matches!(self.names.global(&target.name), Some(Entity::Block(_)));
                let diagnostic = self.report(Problem::P6217, span, message);
                if hides {
                    let help = format!("The variable hides the block `{}`: give one of them another name.", target.name);
                    diagnostic.help = Some(help);
                }
                if matches!(target.data_type, DataType::Array { .. } | DataType::String(_) | DataType::WideString(_)) {
                    diagnostic.help = Some("An element is written with square brackets, `a[1]`.".to_owned());
                }
                Called::Nothing
            }
        }
    }

    /// What a call of an instance may reach that was reached through a reference or an in-out.
    fn dispatch_of(&self, block: BlockId, target: &Target) -> Option<Dispatch> {
        let referred = matches!(target.place.base, Base::Reference(_) | Base::ComplexParameter(_) | Base::InstancePointer(_));
        let whole = target.place.offset == 0 && target.place.indexes.is_empty();
        (referred && whole).then(|| self.names.objects().dispatch_body(block)).flatten()
    }

    /// `FB10.DB20`, `inst.TON`, `Library.Function`, `inst.Method`.
    fn called_member(&mut self, callee: &Expression, base: &Expression, name: &Name) -> Called {
        if is_super(base) {
            return match self.super_member(name, MemberKind::Method, base.span) {
                Some(method) => self.called_method(method, callee.span),
                None => Called::Nothing,
            };
        }
        let reached = self.reach(base);
        if let Some(owner) = self.owner_of_reached(&reached, base.span)
            && let Some(method) = self.member_in(owner, &name.text, MemberKind::Method)
        {
            return self.called_method(method, callee.span);
        }
        match reached {
            Reached::Target(target) => {
                let DataType::Instance { block, structure } = &target.data_type else {
                    if let Some(block) = super::members::interface_of(&target.data_type) {
                        self.no_member(block, name);
                        return Called::Nothing;
                    }
                    return match self.reach(callee) {
                        Reached::Target(target) => self.called_target(target, callee.span),
                        Reached::Other(typed) => self.not_callable(&typed, callee.span),
                    };
                };
                if structure.field(&name.text).is_some() {
                    return match self.reach(callee) {
                        Reached::Target(target) => self.called_target(target, callee.span),
                        Reached::Other(_) => Called::Nothing,
                    };
                }
                // The instruction that an instance of a system type belongs to: `"T1".TON(…)`.
                let block = *block;
                let instruction = self.memory_instruction(block, name);
                if instruction.is_none() && self.no_memory_instruction(block, &target, Some(name), name.span) {
                    return Called::Nothing;
                }
                if let Some(block) = instruction.or_else(|| self.is_instruction(block, name).then_some(block)) {
                    return match self.judge(Construct::InstructionCall, name.span) {
                        true => Called::Instance(block, target, None),
                        false => Called::Nothing,
                    };
                }
                if self.has_members(block) || self.names.objects().lacks_base(block) {
                    self.no_member(block, name);
                    return Called::Nothing;
                }
                let message = format!("`{}` has neither an instance nor an instruction `{}` to call", target.name, name.text);
                self.report(Problem::P6217, name.span, message).help =
                    Some("Correct the name; an action of a block with VAR_TEMP is called inside that block only.".to_owned());
                Called::Nothing
            }
            Reached::Other(Typed::Poison) => Called::Nothing,
            Reached::Other(Typed::Block(block)) if matches!(block.kind, BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock) => {
                self.called_pair(block, name, callee.span)
            }
            Reached::Other(Typed::Type(DataType::Instance { block, .. })) => self.called_pair(block, name, callee.span),
            Reached::Other(Typed::Block(block)) if block.kind == BlockKind::DataBlock => match self.data_block(block, base.span) {
                // `"T1".TON(…)`: the data block is the instance.
                Some(target) if matches!(target.data_type, DataType::Instance { .. }) => {
                    let DataType::Instance { block, structure } = &target.data_type else { return Called::Nothing };
                    if structure.field(&name.text).is_none() {
                        let instruction = self.memory_instruction(*block, name);
                        if instruction.is_none() && self.no_memory_instruction(*block, &target, Some(name), name.span) {
                            return Called::Nothing;
                        }
                        if instruction.is_none() && self.names.is_of_library(*block) && !self.is_instruction(*block, name) {
                            let of = self.names.block_name(*block);
                            let message = format!("`{}` is {of}, which has no instruction `{}`", target.name, name.text);
                            let own = of.split('_').next().unwrap_or_default().to_owned();
                            self.report(Problem::P6217, name.span, message).help = Some(format!("Write `{}.{own}(…)`.", target.name));
                            return Called::Nothing;
                        }
                        let block = instruction.unwrap_or(*block);
                        return match self.judge(Construct::InstructionCall, name.span) {
                            true => Called::Instance(block, target, None),
                            false => Called::Nothing,
                        };
                    }
                    match self.reach(callee) {
                        Reached::Target(target) => self.called_target(target, callee.span),
                        Reached::Other(_) => Called::Nothing,
                    }
                }
                Some(_) => match self.reach(callee) {
                    Reached::Target(target) => self.called_target(target, callee.span),
                    Reached::Other(_) => Called::Nothing,
                },
                None => Called::Nothing,
            },
            Reached::Other(Typed::Qualifier(path)) => {
                let mut names: Vec<&str> = path.iter().map(String::as_str).collect();
                names.push(&name.text);
                match self.names.qualified(&names) {
                    Some(Entity::Block(block)) => self.called_block(block, callee.span),
                    Some(Entity::Variable(_)) => match self.reach(callee) {
                        Reached::Target(target) => self.called_target(target, callee.span),
                        Reached::Other(_) => Called::Nothing,
                    },
                    _ => Called::Standard(Name { span: callee.span, ..name.clone() }),
                }
            }
            Reached::Other(typed) => self.not_callable(&typed, callee.span),
        }
    }

    /// Whether a name is the instruction of a block: `TON` of TON_TIME, or of the block with that name.
    fn is_instruction(&self, block: BlockId, name: &Name) -> bool {
        let own = self.names.block_name(block);
        let typed = own.get(..name.text.len()).is_some_and(|start| name.is(start)) && own[name.text.len()..].starts_with('_');
        name.is(&own)
            || typed
            || match self.names.global(&name.text) {
                Some(Entity::Block(named) | Entity::Type(DataType::Instance { block: named, .. })) => named == block,
                _ => false,
            }
    }

    /// `FB10.DB20`.
    fn called_pair(&mut self, block: BlockId, name: &Name, span: Span) -> Called {
        if !self.judge(Construct::InstanceOfBlock, span) {
            return Called::Nothing;
        }
        let Some(Entity::Block(data)) =
            self.names.global(&name.text).filter(|found| matches!(found, Entity::Block(block) if block.kind == BlockKind::DataBlock))
        else {
            self.report(Problem::P3008, name.span, format!("`{}` is not a data block of the project", name.text)).may_be_elsewhere = true;
            return Called::Nothing;
        };
        let Some(target) = self.data_block(data, name.span) else { return Called::Nothing };
        match &target.data_type {
            DataType::Instance { block: of, .. } if *of == block => Called::Instance(block, target, None),
            _ => {
                let message = format!("`{}` is not an instance of `{}`", name.text, self.names.block_name(block));
                self.report(Problem::P3017, name.span, message);
                Called::Nothing
            }
        }
    }

    fn not_callable(&mut self, typed: &Typed, span: Span) -> Called {
        if *typed != Typed::Poison {
            let what = self.what(typed);
            self.report(Problem::P6217, span, format!("{what} cannot be called"));
        }
        Called::Nothing
    }

    /// A call inside an expression.
    pub(super) fn call_value(&mut self, call: &ast::Call, span: Span) -> Typed {
        if let ExpressionKind::Name(name) = &call.callee.kind
            && self.calls_wide(call)
        {
            return self.standard(name, call, span);
        }
        match self.called(&call.callee) {
            Called::Nothing => {
                // The arguments may have mistakes of their own.
                self.look_at(&call.arguments);
                Typed::Poison
            }
            Called::Standard(name) => self.standard(&name, call, span),
            Called::Action(_) => {
                self.report(Problem::P6218, span, "an action has no result");
                Typed::Poison
            }
            Called::Instance(..) => {
                self.report(Problem::P6218, span, "a function block has no result").help =
                    Some("Call it in a statement of its own, then read its outputs, `inst.Q`.".to_owned());
                Typed::Poison
            }
            called @ (Called::Function(_) | Called::Method(..)) => {
                let (block, callee) = match called {
                    Called::Method(block, callee) => (block, callee),
                    Called::Function(block) => (block, Callee::Function(block)),
                    _ => unreachable!("only these two come here"),
                };
                let Some(interface) = self.interface(block, call.callee.span) else {
                    self.look_at(&call.arguments);
                    return Typed::Poison;
                };
                let Some((call, before)) = self.arguments(callee, &interface, call, span) else { return Typed::Poison };
                match interface.variable(RET_VAL).filter(|formal| formal.section == Section::Output && call.result == DataType::Void) {
                    Some(formal) => self.delivered_result(formal, call, before, span),
                    None => self.result_of(call, before, span),
                }
            }
        }
    }

    /// The result of a system function, which is an output: it goes through a place in the local data.
    pub(super) fn delivered_result(&mut self, formal: &Variable, mut call: Call, mut before: Vec<Statement>, span: Span) -> Typed {
        let Some(kind) = Kind::of(&formal.data_type) else { return self.result_of(call, before, span) };
        let scalar = kind.scalar(self.dialect);
        let target = self.temporary_place(kind.bits.div_ceil(8), span);
        let load = Value { kind: ValueKind::Load(target.clone()), scalar, span };
        call.arguments.push(Argument::Output { parameter: formal.offset, scalar, target, convert: Vec::new(), converted: scalar });
        before.push(Statement { kind: StatementKind::Call(call), span });
        Typed::Scalar { value: after(before, load), data_type: formal.data_type.clone() }
    }

    /// The result of a call as an expression.
    pub(super) fn result_of(&mut self, call: Call, before: Vec<Statement>, span: Span) -> Typed {
        let data_type = call.result.clone();
        if let Some(kind) = Kind::of(&data_type) {
            let scalar = kind.scalar(self.dialect);
            let value = Value { kind: ValueKind::Call(Box::new(call)), scalar, span };
            return Typed::Scalar { value: after(before, value), data_type };
        }
        match data_type {
            DataType::Void => {
                self.report(Problem::P6218, span, "this function has no result");
                Typed::Poison
            }
            DataType::String(_) | DataType::WideString(_) => match room_of(&data_type) {
                Some(room) => {
                    let text = Text::Call { call: Box::new(call), room };
                    Typed::Text(if before.is_empty() { text } else { Text::After(before, Box::new(text)) })
                }
                None => Typed::Poison,
            },
            DataType::Struct(_) | DataType::Array { .. } | DataType::DateAndTime => {
                let interface = self.names.interface(call.callee.block());
                let result = interface.as_ref().and_then(|interface| interface.variables.iter().find(|one| one.section == Section::Return));
                let Some(parameter) = result.map(|result| result.offset) else { return Typed::Poison };
                let name = self.callee_name(&call.callee).trim_matches('`').to_owned();
                let place = self.temporary_place(u32::try_from(data_type.bits().div_ceil(8)).unwrap_or(u32::MAX), span);
                let mut call = Call { result: DataType::Void, ..call };
                call.arguments.push(Argument::OutputAggregate { parameter, target: place.clone(), data_type: data_type.clone() });
                let mut before = before;
                before.push(Statement { kind: StatementKind::Call(call), span });
                Typed::Delivered(before, Target { place, data_type, role: Role::Constant, name, through: Through::Itself })
            }
            _ => self.not_built(span, &format!("a result of type {} inside an expression", self.words(&data_type))),
        }
    }

    /// The interface of a block that is called.
    pub(super) fn interface(&mut self, block: BlockId, span: Span) -> Option<std::sync::Arc<Interface>> {
        let found = self.names.interface(block);
        match &found {
            Some(_) => {
                self.called.insert(block);
            }
            None => {
                self.report(Problem::P3008, span, format!("the block `{}` does not exist", self.names.block_name(block)))
                    .may_be_elsewhere = true;
            }
        }
        found
    }

    /// Looks at arguments for their own mistakes only.
    pub(super) fn look_at(&mut self, arguments: &[ast::Argument]) {
        for argument in arguments {
            if let Some(value) = &argument.value {
                self.expression(value);
            }
        }
    }

    /// A call as a statement.
    pub(super) fn call_statement(&mut self, call: &ast::Call, span: Span) -> Option<StatementKind> {
        // A word of tests goes before a block with the same name, which can be called in quotes.
        if let ExpressionKind::Name(name) = &call.callee.kind
            && let Some(word) = self.test_word(name)
            && !matches!(self.names.local(&name.text), Some(Entity::Variable(names::Variable { data_type: DataType::Instance { .. }, .. })))
        {
            return self.test_statement(word, call, span);
        }
        let (callee, interface) = match self.called(&call.callee) {
            Called::Nothing => {
                self.look_at(&call.arguments);
                return None;
            }
            Called::Action(index) => return self.action(index, call, span),
            Called::Standard(name) => return self.standard_statement(&name, call, span),
            Called::Function(block) => (Callee::Function(block), self.interface(block, call.callee.span)),
            Called::Method(block, callee) => (callee, self.interface(block, call.callee.span)),
            Called::Instance(block, target, dispatch) => {
                if target.role == Role::Input && target.through == Through::Itself {
                    self.judge(Construct::WrittenInput, call.callee.span);
                }
                (Callee::Instance { block, instance: target.place, dispatch }, self.interface(block, call.callee.span))
            }
        };
        let Some(interface) = interface else {
            self.look_at(&call.arguments);
            return None;
        };
        let (call, mut before) = self.arguments(callee, &interface, call, span)?;
        if before.is_empty() {
            return Some(StatementKind::Call(call));
        }
        before.push(Statement { kind: StatementKind::Call(call), span });
        Some(StatementKind::Block(before))
    }

    /// An action stands for its statements.
    fn action(&mut self, index: usize, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let action = &self.block.actions[index];
        if let Some(argument) = call.arguments.first() {
            self.report(Problem::P6219, argument.span, "an action has no parameters");
            return None;
        }
        if self.inside_actions.contains(&index) {
            self.report(Problem::P6217, span, format!("the action `{}` calls itself", action.name.text));
            return None;
        }
        if super::statements::has_return(&action.body) {
            self.not_built(span, "an action with RETURN");
            return None;
        }
        self.inside_actions.push(index);
        let loops = std::mem::take(&mut self.loops);
        // Lists of statements are counted for labels, and an action has none.
        let (lists, next) = (std::mem::take(&mut self.lists), self.next_list);
        let body = self.statements(&action.body);
        (self.lists, self.next_list) = (lists, next);
        self.loops = loops;
        self.inside_actions.pop();
        Some(StatementKind::Block(body))
    }

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
        let mut all = Arguments::new(interface, self.written_out(&callee, &call.callee));
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

    fn callee_name(&self, callee: &Callee) -> String {
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
                self.input(formal, typed, value.span, &mut all.arguments, &mut all.before)
            }
        }
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
    fn new(interface: &'a Interface, written_out: Option<TextFunction>) -> Self {
        let is_formal =
            |variable: &&Variable| variable.section != Section::Return && !is_bound(interface, variable) && !is_told(interface, variable);
        let mut formals: Vec<&Variable> = interface.parameters().filter(is_formal).collect();
        // The interface has its sections in order; arguments by position follow the source. Blocks without one keep their order.
        formals.sort_by_key(|variable| variable.span.start);
        Self { written_out, formals, interface, given: HashMap::new(), arguments: Vec::new(), enable: None, before: Vec::new() }
    }
}

/// Statements before a value.
pub(super) fn after(before: Vec<Statement>, value: Value) -> Value {
    if before.is_empty() {
        return value;
    }
    let (scalar, span) = (value.scalar, value.span);
    Value { kind: ValueKind::After(before, Box::new(value)), scalar, span }
}

pub(super) fn is_flow(argument: &ast::Argument) -> bool {
    argument.name.as_ref().is_some_and(|name| name.is("EN") || name.is("ENO"))
}

fn matches_block(wanted: &DataType, block: BlockId) -> bool {
    match wanted {
        DataType::BlockData | DataType::BlockSystemData => block.kind == BlockKind::DataBlock,
        DataType::BlockFunction => matches!(block.kind, BlockKind::Function | BlockKind::SystemFunction),
        DataType::BlockFunctionBlock => matches!(block.kind, BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock),
        _ => false,
    }
}

/// `1 parameter`, `3 parameters`, `no parameters`.
pub(super) fn counted(count: usize, noun: &str) -> String {
    match count {
        0 => format!("no {noun}s"),
        1 => format!("one {noun}"),
        count => format!("{count} {noun}s"),
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
