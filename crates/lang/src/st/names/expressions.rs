//! The names in the statements and expressions of Structured Text.

use sieben_model::address::{Address as Memory, Area, Operand, Width};

use super::{Collector, bytes, numbered, written};
use crate::names::{Access, Bytes, DefinitionKind, Written};
use crate::st::ast::{
    self, Address, AddressWidth, Argument, AssignOperator, Call, CaseLabel, DataAddress, DiagramBox, Direction, Expression, ExpressionKind,
    Name, Position, Quoting, Statement, StatementKind,
};

impl Address {
    /// The address as it is written, without `%`.
    pub(super) fn written_text<'t>(&self, text: &'t str) -> &'t str {
        text.get(self.span.start as usize..self.span.end as usize).unwrap_or_default().trim_start_matches('%')
    }
}

impl Collector<'_> {
    /// The labels of statements, so that jumps before them find them.
    pub(super) fn labels(&mut self, statements: &[Statement]) {
        for statement in statements {
            match &statement.kind {
                StatementKind::Label(name) => {
                    if self.to.member(&name.text).is_none_or(|index| self.to.definition(index).kind != DefinitionKind::Label) {
                        self.to.define(DefinitionKind::Label, &name.text, name.span, name.span);
                    } else {
                        self.to.name(&name.text, name.span, Written::Label, Access::Path);
                    }
                }
                kind => bodies(kind).into_iter().for_each(|body| self.labels(body)),
            }
        }
    }

    pub(super) fn statements(&mut self, statements: &[Statement]) {
        statements.iter().for_each(|statement| self.statement(statement));
    }

    fn statement(&mut self, statement: &Statement) {
        match &statement.kind {
            StatementKind::Empty
            | StatementKind::Exit
            | StatementKind::Continue
            | StatementKind::Return
            | StatementKind::Label(_)
            | StatementKind::Missing => {}
            StatementKind::Assign { targets, operator, value } => {
                let access = match operator {
                    AssignOperator::Becomes
                    | AssignOperator::Attempt
                    | AssignOperator::Set
                    | AssignOperator::Reset
                    | AssignOperator::Refer
                    | AssignOperator::Coil(_)
                    | AssignOperator::SetCoil(_)
                    | AssignOperator::ResetCoil(_) => Access::Write,
                    AssignOperator::Add | AssignOperator::Subtract | AssignOperator::Multiply | AssignOperator::Divide => Access::ReadWrite,
                };
                targets.iter().for_each(|target| _ = self.expression(target, access));
                self.expression(value, Access::Read);
            }
            StatementKind::Expression(value) | StatementKind::Wire(_, value) => _ = self.expression(value, Access::Read),
            StatementKind::If { branches, otherwise } => {
                for branch in branches {
                    self.expression(&branch.condition, Access::Read);
                    self.statements(&branch.body);
                }
                otherwise.iter().for_each(|body| self.statements(body));
            }
            StatementKind::Case { selector, arms, otherwise } => {
                self.expression(selector, Access::Read);
                for arm in arms {
                    for label in &arm.labels {
                        match label {
                            CaseLabel::Value(value) => _ = self.expression(value, Access::Read),
                            CaseLabel::Range(low, high) => {
                                self.expression(low, Access::Read);
                                self.expression(high, Access::Read);
                            }
                        }
                    }
                    self.statements(&arm.body);
                }
                otherwise.iter().for_each(|body| self.statements(body));
            }
            StatementKind::For(one) => {
                self.expression(&one.variable, Access::ReadWrite);
                for value in [&one.from, &one.to].into_iter().chain(&one.by) {
                    self.expression(value, Access::Read);
                }
                self.statements(&one.body);
            }
            StatementKind::While { condition, body } => {
                self.expression(condition, Access::Read);
                self.statements(body);
            }
            StatementKind::Repeat { body, until } => {
                self.statements(body);
                self.expression(until, Access::Read);
            }
            StatementKind::Goto(name) => _ = self.to.name(&name.text, name.span, Written::Label, Access::Jump),
            StatementKind::Region { body, .. } => self.statements(body),
            StatementKind::Try { body, exception, catch, finally } => {
                self.statements(body);
                exception.iter().for_each(|exception| _ = self.expression(exception, Access::Write));
                self.statements(catch);
                self.statements(finally);
            }
            StatementKind::Box(one) => self.diagram_box(one),
        }
    }

    fn diagram_box(&mut self, one: &DiagramBox) {
        let callee = self.expression(&one.of, if one.instance.is_some() { Access::Type } else { Access::Call });
        if let Some(instance) = &one.instance {
            self.expression(instance, Access::Instance);
        }
        one.power.iter().for_each(|power| _ = self.expression(power, Access::Read));
        self.arguments(callee, &one.inputs);
        self.arguments(callee, &one.outputs);
    }

    /// The arguments of a call.
    pub(super) fn arguments(&mut self, callee: Option<u32>, arguments: &[Argument]) {
        for argument in arguments {
            let mut access = if argument.direction == Direction::Delivered { Access::Write } else { Access::Read };
            if let (Some(name), Some(callee)) = (&argument.name, callee)
                && self.to.name(&name.text, name.span, |id| Written::Parameter(callee, id), Access::Parameter).is_some()
                && argument.direction != Direction::Delivered
            {
                access = Access::Argument;
            }
            argument.value.iter().for_each(|value| _ = self.expression(value, access));
        }
    }

    /// The block and the data block of `FB10.DB20(…)`: where the first name is none of the block's own, there is nothing else that it may be.
    fn called_with<'e>(&self, callee: &'e Expression) -> Option<(&'e Expression, &'e Name)> {
        let ExpressionKind::Member(block, data) = &callee.kind else { return None };
        let is_block = match &block.kind {
            ExpressionKind::Name(name) => name.quoting != Quoting::Local && self.to.variable(&name.text).is_none(),
            ExpressionKind::Global(_) => true,
            _ => false,
        };
        (self.calls_with_data_blocks && is_block).then_some((&**block, data))
    }

    fn call(&mut self, call: &Call, span: Bytes) -> Option<u32> {
        let callee = match self.called_with(&call.callee) {
            Some((block, data)) => {
                let callee = self.expression(block, Access::Call);
                self.named(data, Access::Instance);
                callee
            }
            None => self.expression(&call.callee, Access::Call),
        };
        if let Some(callee) = callee {
            let argument = |argument: &Argument| (bytes(argument.span), argument.name.is_some());
            self.to.call(callee, span, call.arguments.iter().map(argument).collect());
        }
        self.arguments(callee, &call.arguments);
        callee
    }

    /// A name: a block by its number, where no variable is called so.
    fn named(&mut self, name: &Name, access: Access) -> Option<u32> {
        match numbered(name).filter(|_| self.to.variable(&name.text).is_none()) {
            Some(operand) => self.to.operand(operand, name.span, access),
            None => self.to.name(&name.text, name.span, written(name), access),
        }
    }

    /// The names of an expression; gives the last one of its path.
    pub(super) fn expression(&mut self, expression: &Expression, access: Access) -> Option<u32> {
        match &expression.kind {
            ExpressionKind::Literal(_)
            | ExpressionKind::This
            | ExpressionKind::Super
            | ExpressionKind::Wire(_)
            | ExpressionKind::Missing => None,
            ExpressionKind::Name(name) => self.named(name, access),
            ExpressionKind::Global(name) => self.to.name(&name.text, name.span, Written::Global, access),
            ExpressionKind::EnumValue { of, value } => {
                let of = self.type_path(of, Access::Type)?;
                self.to.name(&value.text, value.span, |id| Written::Member(of, id), access)
            }
            ExpressionKind::Address(address) => self.address(address, access),
            ExpressionKind::Member(of, name) => {
                // Members of the block itself are found from the block on.
                let is_this = matches!(without_dereference(of).kind, ExpressionKind::This | ExpressionKind::Super);
                if is_this {
                    return self.to.name(&name.text, name.span, Written::Local, access);
                }
                let of = self.expression(of, access)?;
                let member = self.to.name(&name.text, name.span, |id| Written::Member(of, id), access)?;
                self.to.use_as(of, Access::Path);
                Some(member)
            }
            ExpressionKind::Index(of, indexes) => {
                let of = self.expression(of, access);
                indexes.iter().for_each(|index| _ = self.expression(index, Access::Read));
                of
            }
            ExpressionKind::Dereference(of) | ExpressionKind::Slice(of, _) | ExpressionKind::Parenthesized(of) => {
                self.expression(of, access)
            }
            ExpressionKind::DataAddress(address) => self.data_address(address, access),
            ExpressionKind::Call(call) => self.call(call, bytes(expression.span)),
            ExpressionKind::Unary(_, value) => self.expression(value, Access::Read).and(None),
            ExpressionKind::Binary(_, _, one, other) => {
                self.expression(one, Access::Read);
                self.expression(other, Access::Read);
                None
            }
            ExpressionKind::Assign(target, value) => {
                self.expression(target, Access::Write);
                self.expression(value, Access::Read);
                None
            }
            ExpressionKind::Contact(contact) => self.expression(&contact.operand, access),
        }
    }

    /// What a data block assigns to: a member of its own.
    pub(super) fn assigned(&mut self, target: &Expression) -> Option<u32> {
        match &target.kind {
            ExpressionKind::Name(name) => self.to.name(&name.text, name.span, Written::Local, Access::Write),
            ExpressionKind::Member(of, name) => {
                let of = self.assigned(of)?;
                let member = self.to.name(&name.text, name.span, |id| Written::Member(of, id), Access::Write)?;
                self.to.use_as(of, Access::Path);
                Some(member)
            }
            ExpressionKind::Index(of, _) => self.assigned(of),
            _ => self.expression(target, Access::Write),
        }
    }

    fn address(&mut self, address: &Address, access: Access) -> Option<u32> {
        if !address.percent && self.to.variable(&address.written.text).is_some() {
            return self.to.name(&address.written.text, address.written.span, Written::Plain, access);
        }
        match &address.position {
            Position::Fixed(_) => {
                let text = address.written_text(self.to.text());
                let text = text.strip_suffix(":P").or_else(|| text.strip_suffix(":p")).unwrap_or(text);
                let operand = Operand::parse(text)?;
                self.to.operand(operand, address.span, access)
            }
            Position::Computed(indexes) => {
                let area = match address.area {
                    ast::Area::Input => Some(Area::Input),
                    ast::Area::Output => Some(Area::Output),
                    ast::Area::Memory => Some(Area::BitMemory),
                    _ => None,
                };
                let outer = self.to.push(bytes(address.span), Written::Indirect(area), access);
                indexes.iter().for_each(|index| _ = self.expression(index, Access::Read));
                Some(outer)
            }
            Position::Open => None,
        }
    }

    fn data_address(&mut self, address: &DataAddress, access: Access) -> Option<u32> {
        let of = self.expression(&address.block, Access::Open)?;
        let width = match address.width {
            AddressWidth::Bit => Width::Bit,
            AddressWidth::Byte => Width::Byte,
            AddressWidth::Word => Width::Word,
            AddressWidth::DoubleWord => Width::DoubleWord,
            AddressWidth::LongWord => Width::QuadWord,
        };
        match &address.position {
            Position::Fixed(numbers) => {
                let byte = numbers.first().and_then(|&byte| u32::try_from(byte).ok())?;
                let bit = numbers.get(1).map_or(Some(0), |&bit| u8::try_from(bit).ok().filter(|&bit| bit < 8))?;
                let memory = Memory { area: Area::SharedData, width, byte, bit };
                Some(self.to.push(bytes(address.written.span), Written::InBlock(of, memory), access))
            }
            Position::Computed(indexes) => {
                indexes.iter().for_each(|index| _ = self.expression(index, Access::Read));
                Some(of)
            }
            Position::Open => Some(of),
        }
    }
}

/// The statements inside of a statement.
fn bodies(kind: &StatementKind) -> Vec<&[Statement]> {
    match kind {
        StatementKind::If { branches, otherwise } => {
            branches.iter().map(|branch| branch.body.as_slice()).chain(otherwise.as_deref()).collect()
        }
        StatementKind::Case { arms, otherwise, .. } => arms.iter().map(|arm| arm.body.as_slice()).chain(otherwise.as_deref()).collect(),
        StatementKind::For(one) => vec![&one.body],
        StatementKind::While { body, .. } | StatementKind::Repeat { body, .. } | StatementKind::Region { body, .. } => vec![body],
        StatementKind::Try { body, catch, finally, .. } => vec![body, catch, finally],
        _ => Vec::new(),
    }
}

fn without_dereference(expression: &Expression) -> &Expression {
    match &expression.kind {
        ExpressionKind::Dereference(inner) | ExpressionKind::Parenthesized(inner) => without_dereference(inner),
        _ => expression,
    }
}
