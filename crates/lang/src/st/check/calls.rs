//! Calls: what is called, and what comes of it.

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Interface, Section, Variable};
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::Checker;
use super::members::is_super;
use super::names::{self, Entity, Role};
use super::places::Reached;
use super::typed::{Target, Through, Typed};
use super::types::{Class, Kind};
use crate::library;
use crate::st::ast::{self, Expression, ExpressionKind, MemberKind, Name, Quoting};
use crate::st::dialect::Construct;
use crate::st::standard;
use crate::st::tree::{Argument, Base, Call, Callee, Dispatch, Place, Statement, StatementKind, Text, Value, ValueKind, room_of};

/// The output of system functions that is their result.
pub(super) const RET_VAL: &str = "RET_VAL";

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
        let method = self.own_member(name, MemberKind::Method);
        if let Some(action) = self.block.actions.iter().position(|action| name.is(&action.name.text)) {
            // RETURN leaves the action alone, as it leaves a method.
            if method.is_none() || !super::statements::has_return(&self.block.actions[action].body) {
                return Called::Action(action);
            }
        }
        if let Some(method) = method {
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
            BlockKind::FunctionBlock if self.names.program(block).is_some() => match self.program_instance(block, span) {
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

    /// A PROGRAM as the variable that its only instance is, where the dialect calls programs by their names.
    fn program_instance(&mut self, block: BlockId, span: Span) -> Option<Target> {
        let data = self.names.program(block)?;
        let target = self.judge(Construct::ProgramCall, span).then(|| self.data_block(data, span))??;
        Some(Target { name: self.names.block_name(block), ..target })
    }

    /// A path that leads to a PROGRAM leads to its instance, of which something is called or read.
    pub(super) fn of_program_instance(&mut self, reached: Reached, span: Span) -> Reached {
        match reached {
            Reached::Other(Typed::Block(block)) if self.names.program(block).is_some() => match self.program_instance(block, span) {
                Some(target) => Reached::Target(target),
                None => Reached::Other(Typed::Poison),
            },
            other => other,
        }
    }

    /// The function block that the dialect brings along under this name, where the project has nothing else of that name.
    pub(super) fn bare_block_type(&mut self, name: &Name, found: Option<&Entity>) -> Option<BlockId> {
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
        if self.names.objects().get(block).is_some_and(|object| object.kind == crate::st::ast::BlockKind::Program) {
            let message =
                format!("`{name}` is a PROGRAM, and a CONFIGURATION makes several instances of it, or none: its name means none of them");
            self.report(Problem::P6217, span, message).help =
                Some(format!("Leave the call to the tasks, or write `FUNCTION_BLOCK {name}` and declare instances of it."));
            return;
        }
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
            DataType::Instance { .. } if target.role == Role::Result => self.calls_result(&target, span),
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

    /// Says that an instance in the own result is not called: it may lie in local data of the caller.
    fn calls_result(&mut self, target: &Target, span: Span) -> Called {
        let message = format!("the instance in the result `{}` does not last, and is not called", target.name);
        self.report(Problem::P6217, span, message).help = Some("Call an instance of VAR, and assign it to the result.".to_owned());
        Called::Nothing
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
        let reached = self.of_program_instance(reached, base.span);
        if let Some(owner) = self.owner_of_reached(&reached, base.span)
            && let Some(method) = self.member_in(owner, &name.text, MemberKind::Method)
        {
            if let Reached::Target(target) = &reached
                && target.role == Role::Result
                && matches!(target.data_type, DataType::Instance { .. })
            {
                return self.calls_result(target, callee.span);
            }
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
            DataType::Struct(_) | DataType::Array { .. } | DataType::DateAndTime | DataType::Instance { .. } => {
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
                if target.role == Role::Constant {
                    self.report(Problem::P6204, call.callee.span, format!("`{}` is a constant, and a call changes it", target.name)).help =
                        Some("Declare the instance without CONSTANT.".to_owned());
                    self.look_at(&call.arguments);
                    return None;
                }
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
        let (wires, held) = (std::mem::take(&mut self.wires), self.locals.enter());
        let body = self.statements(&action.body);
        self.locals.leave(held);
        self.wires = wires;
        (self.lists, self.next_list) = (lists, next);
        self.loops = loops;
        self.inside_actions.pop();
        Some(StatementKind::Block(body))
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

/// `1 parameter`, `3 parameters`, `no parameters`.
pub(super) fn counted(count: usize, noun: &str) -> String {
    match count {
        0 => format!("no {noun}s"),
        1 => format!("one {noun}"),
        count => format!("{count} {noun}s"),
    }
}
