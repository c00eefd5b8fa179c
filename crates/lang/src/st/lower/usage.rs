//! How often a function uses its elementary parameters: what is used more than once is copied to local data at its begin, and
//! outputs back at its end, instead of following the pointer of the caller each time.

use std::collections::HashMap;

use crate::st::tree::{Argument, Base, Call, Place, Statement, StatementKind, Text, Value, ValueKind};

/// What a function does with a parameter. Uses in a loop count twice.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Usage {
    pub(super) reads: u32,
    pub(super) writes: u32,
    /// A pointer to it is needed.
    pub(super) addressed: bool,
}

/// How a place is used.
#[derive(Clone, Copy)]
enum Use {
    Read,
    Write,
    Address,
}

/// The uses of all elementary parameters, by their index.
pub(super) fn parameters(statements: &[Statement]) -> HashMap<u16, Usage> {
    let mut counter = Counter { weight: 1, uses: HashMap::new() };
    counter.statements(statements);
    counter.uses
}

struct Counter {
    weight: u32,
    uses: HashMap<u16, Usage>,
}

impl Counter {
    fn statements(&mut self, statements: &[Statement]) {
        for statement in statements {
            self.statement(&statement.kind);
        }
    }

    fn in_loop(&mut self, count: impl FnOnce(&mut Self)) {
        let outside = std::mem::replace(&mut self.weight, 2);
        count(self);
        self.weight = outside;
    }

    fn statement(&mut self, kind: &StatementKind) {
        match kind {
            StatementKind::Assign { target, value } => {
                self.value(value);
                self.place(target, Use::Write);
            }
            StatementKind::Copy { target, source, .. } => {
                self.place(source, Use::Address);
                self.place(target, Use::Address);
            }
            StatementKind::AssignString { target, source, .. } => {
                self.text(source);
                self.place(target, Use::Address);
            }
            StatementKind::Call(call) => self.call(call),
            StatementKind::If { branches, otherwise } => {
                for (condition, body) in branches {
                    self.value(condition);
                    self.statements(body);
                }
                self.statements(otherwise);
            }
            StatementKind::Case { selector, branches, otherwise } => {
                self.value(selector);
                branches.iter().for_each(|branch| self.statements(&branch.body));
                self.statements(otherwise);
            }
            StatementKind::For(for_loop) => {
                self.value(&for_loop.from);
                self.in_loop(|this| {
                    this.value(&for_loop.to);
                    this.value(&for_loop.by);
                    this.place(&for_loop.variable, Use::Read);
                    this.place(&for_loop.variable, Use::Write);
                    this.statements(&for_loop.body);
                });
            }
            StatementKind::While { condition, body } | StatementKind::Repeat { body, until: condition } => self.in_loop(|this| {
                this.value(condition);
                this.statements(body);
            }),
            StatementKind::SetOk(value) => self.value(value),
            StatementKind::Intrinsic { args, .. } => args.iter().for_each(|arg| self.value(arg)),
            // A jump back makes a loop of what lies between.
            StatementKind::Label(_) => self.weight = 2,
            StatementKind::Block(statements) => self.statements(statements),
            StatementKind::Exit { .. } | StatementKind::Continue { .. } | StatementKind::Return | StatementKind::Goto(_) => {}
        }
    }

    fn value(&mut self, value: &Value) {
        match &value.kind {
            ValueKind::Constant(_) | ValueKind::NumberParameter(_) | ValueKind::Ok | ValueKind::Eno => {}
            ValueKind::Load(place) => self.place(place, Use::Read),
            ValueKind::Compute { args, .. } | ValueKind::Checked { args, .. } | ValueKind::Intrinsic { args, .. } => {
                args.iter().for_each(|arg| self.value(arg));
            }
            ValueKind::AndThen(a, b) | ValueKind::OrElse(a, b) => [a, b].into_iter().for_each(|value| self.value(value)),
            ValueKind::Choose { condition, a, b } => [condition, a, b].into_iter().for_each(|value| self.value(value)),
            ValueKind::Call(call) => self.call(call),
            ValueKind::CompareTexts(a, b) => [a, b].into_iter().for_each(|text| self.text(text)),
            ValueKind::Length(text) => self.text(text),
            ValueKind::AddressOf(place) => self.place(place, Use::Address),
            ValueKind::After(statements, value) => {
                self.statements(statements);
                self.value(value);
            }
        }
    }

    fn text(&mut self, text: &Text) {
        match text {
            Text::Constant(_) | Text::WideConstant(_) => {}
            Text::Converted(text) => self.text(text),
            Text::After(statements, text) => {
                self.statements(statements);
                self.text(text);
            }
            Text::Place { place, .. } => self.place(place, Use::Address),
            Text::Character(value) => self.value(value),
            Text::Call { call, .. } => self.call(call),
        }
    }

    fn call(&mut self, call: &Call) {
        if let Some(enable) = &call.enable {
            self.value(enable);
        }
        if let Some(instance) = call.callee.instance() {
            self.place(instance, Use::Address);
        }
        for argument in &call.arguments {
            match argument {
                Argument::Value { value, .. } | Argument::Number { value, .. } => self.value(value),
                Argument::Text { text, .. } => self.text(text),
                Argument::Output { target, .. } | Argument::Eno { target } => self.place(target, Use::Write),
                Argument::InOut { place, data_type, .. } if data_type.is_elementary() => {
                    self.place(place, Use::Read);
                    self.place(place, Use::Write);
                }
                Argument::Aggregate { source: place, .. }
                | Argument::OutputText { target: place, .. }
                | Argument::OutputAggregate { target: place, .. }
                | Argument::InOut { place, .. }
                | Argument::Pointer { place, .. } => self.place(place, Use::Address),
            }
        }
    }

    fn place(&mut self, place: &Place, how: Use) {
        match &place.base {
            Base::Parameter(index) => {
                let usage = self.uses.entry(*index).or_default();
                match how {
                    Use::Read => usage.reads += self.weight,
                    Use::Write => usage.writes += self.weight,
                    Use::Address => usage.addressed = true,
                }
            }
            Base::ComputedDataBlock(value) | Base::Reference(value) => self.value(value),
            _ => {}
        }
        for index in &place.indexes {
            self.value(&index.value);
        }
    }
}
