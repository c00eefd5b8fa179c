//! Warnings about variables: never used, read before they are written, a result that is not set.

use std::collections::BTreeSet;

use sieben_model::address::Area;
use sieben_model::block::BlockKind;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::names::{Role, Variable};
use super::{Checker, walk};
use crate::declarations::interface::START_INFORMATION_BYTES;
use crate::scope::key;
use crate::st::ast::{self, ExpressionKind};
use crate::st::tree::visit::{self, Extent, Use, Visit};
use crate::st::tree::{Argument, Base, Body, Call, Place, Statement, StatementKind, Text, Value};

impl Checker<'_> {
    /// Says what is odd about the variables of a block without errors.
    pub(super) fn usage(&mut self, body: &Body) {
        self.unused();
        if !self.dialect.switches().temporaries_initialised {
            self.unwritten(body);
            self.result_unset(body);
        }
    }

    /// Temporary variables that no statement names.
    fn unused(&mut self) {
        let mut named = BTreeSet::new();
        let mut see = |expression: &ast::Expression| match &expression.kind {
            ExpressionKind::Name(name) => drop(named.insert(key(&name.text))),
            // `x.n`: a bit whose number is a constant.
            ExpressionKind::Member(_, name) => drop(named.insert(key(&name.text))),
            ExpressionKind::Address(address) => drop(named.insert(key(&address.written.text))),
            _ => {}
        };
        walk::expressions(self.block.body, &mut see);
        self.block.actions.iter().for_each(|action| walk::expressions(&action.body, &mut see));
        for variable in self.names.declared() {
            // Views of one variable share its bytes: one of the names is enough, and declarations do not tell.
            // The first bytes of an organization block are written by the CPU.
            if variable.role == Role::Temp
                && !self.of_start_information(&variable)
                && !named.contains(&key(&variable.name))
                && !self.overlaid(&variable)
            {
                let message = format!("`{}` is never used", variable.name);
                self.report(Problem::P6222, variable.span, message);
            }
        }
    }

    /// Whether a variable is part of the start information of an organization block.
    fn of_start_information(&self, variable: &Variable) -> bool {
        self.block.id.kind == BlockKind::OrganizationBlock
            && variable.base == Base::Area(Area::Local)
            && variable.offset < START_INFORMATION_BYTES * 8
    }

    /// Whether another variable lies in the same bytes.
    fn overlaid(&self, variable: &Variable) -> bool {
        let end = |one: &Variable| u64::from(one.offset) + one.data_type.bits();
        self.names.declared().iter().any(|other| {
            other.base == variable.base
                && other.name != variable.name
                && u64::from(other.offset) < end(variable)
                && u64::from(variable.offset) < end(other)
        })
    }

    /// Temporary variables that are read although nothing before can have written them.
    fn unwritten(&mut self, body: &Body) {
        let variables: Vec<Variable> =
            self.names.declared().into_iter().filter(|one| one.role == Role::Temp && one.base == Base::Area(Area::Local)).collect();
        let variables: Vec<Variable> = variables.into_iter().filter(|one| !self.of_start_information(one)).collect();
        let has_labels = {
            let mut found = false;
            walk::statements(self.block.body, &mut |statement| found |= matches!(statement.kind, ast::StatementKind::Label(_)));
            found
        };
        if variables.is_empty() || has_labels {
            return;
        }
        let mut walk = Walk { variables: &variables, written: vec![false; variables.len()], reads: Vec::new() };
        visit::statements(&mut walk, &body.statements);
        for (index, span) in walk.reads {
            let variable = &variables[index];
            if self.overlaid(variable) {
                continue;
            }
            let message = format!("`{}` is read here, and nothing in this block has written it before", variable.name);
            self.report(Problem::P4020, span, message);
        }
    }

    /// A result that is not set on some way through the function.
    fn result_unset(&mut self, body: &Body) {
        let Some(result) = &self.block.result else { return };
        if result.data_type == DataType::Void {
            return;
        }
        let place =
            (result.base.clone(), result.offset, result.offset.saturating_add(u32::try_from(result.data_type.bits()).unwrap_or(u32::MAX)));
        let mut returns = true;
        let set = sets(&body.statements, &place, false, &mut returns);
        if !set.unwrap_or(true) || !returns {
            let message = format!("the result of `{}` is not set on every path", self.names.block_name(self.block.id));
            self.report(Problem::P6223, self.block.end, message);
        }
    }
}

/// Whether statements set the result on every way; `None`: they do not come to their end. `returns` becomes false at a RETURN without it.
fn sets(statements: &[Statement], result: &(Base, u32, u32), before: bool, returns: &mut bool) -> Option<bool> {
    let mut set = before;
    let written = |place: &Place| place.base == result.0 && place.offset >= result.1 && place.offset < result.2.max(result.1 + 1);
    for statement in statements {
        match &statement.kind {
            StatementKind::Assign { target, .. } | StatementKind::Copy { target, .. } | StatementKind::AssignString { target, .. } => {
                set |= written(target);
            }
            StatementKind::Call(call) => set |= outputs(call).any(written),
            StatementKind::For(one) => {
                set |= written(&one.variable);
                sets(&one.body, result, set, returns);
            }
            StatementKind::While { body, .. } => drop(sets(body, result, set, returns)),
            StatementKind::Repeat { body, .. } => set |= sets(body, result, set, returns).unwrap_or(true),
            StatementKind::Block(body) => set = sets(body, result, set, returns)?,
            StatementKind::If { branches, otherwise } => {
                let ways = branches.iter().map(|(_, body)| body).chain([otherwise]);
                set = all_ways(ways, result, set, returns)?;
            }
            StatementKind::Case { branches, otherwise, .. } => {
                let ways = branches.iter().map(|branch| &branch.body).chain([otherwise]);
                set = all_ways(ways, result, set, returns)?;
            }
            StatementKind::Return => {
                *returns &= set;
                return None;
            }
            StatementKind::Exit { .. } | StatementKind::Continue { .. } | StatementKind::Goto(_) => return None,
            // Where a jump leads to is not followed: it may come from behind an assignment.
            StatementKind::Label(_) => set = true,
            StatementKind::SetOk(_) | StatementKind::Intrinsic { .. } => {}
        }
    }
    Some(set)
}

fn all_ways<'a>(
    ways: impl Iterator<Item = &'a Vec<Statement>>,
    result: &(Base, u32, u32),
    before: bool,
    returns: &mut bool,
) -> Option<bool> {
    let ends: Vec<Option<bool>> = ways.map(|body| sets(body, result, before, returns)).collect();
    ends.into_iter().flatten().reduce(|a, b| a && b)
}

/// The variables that a call writes to.
fn outputs(call: &Call) -> impl Iterator<Item = &Place> {
    call.arguments.iter().filter_map(output)
}

/// The variable that is written through an argument.
fn output(argument: &Argument) -> Option<&Place> {
    match argument {
        Argument::Output { target, .. }
        | Argument::OutputText { target, .. }
        | Argument::OutputAggregate { target, .. }
        | Argument::Eno { target } => Some(target),
        Argument::InOut { place, .. } | Argument::Pointer { place, .. } => Some(place),
        Argument::Value { .. } | Argument::Number { .. } | Argument::Text { .. } | Argument::Aggregate { .. } => None,
    }
}

/// Goes through a body and notes first reads of variables that nothing has written.
struct Walk<'a> {
    variables: &'a [Variable],
    written: Vec<bool>,
    reads: Vec<(usize, Span)>,
}

impl Walk<'_> {
    fn variable(&self, place: &Place) -> Option<usize> {
        if place.base != Base::Area(Area::Local) {
            return None;
        }
        let position = u64::from(place.offset);
        self.variables.iter().position(|one| {
            let first = u64::from(one.offset);
            (first..first + one.data_type.bits().max(1)).contains(&position)
        })
    }

    /// Inside a loop an earlier pass may have written what stands further down.
    fn repeated(&mut self, body: &[Statement]) {
        let reads = self.reads.len();
        let mut ahead = Walk { variables: self.variables, written: self.written.clone(), reads: Vec::new() };
        visit::statements(&mut ahead, body);
        // The first statements of the first pass still read what nothing has written.
        let certain: Vec<(usize, Span)> =
            ahead.reads.iter().copied().filter(|&(index, _)| !assigned(self.variables, body, index)).collect();
        self.written = ahead.written;
        self.reads.truncate(reads);
        self.reads.extend(certain);
    }
}

impl<'t> Visit<'t> for Walk<'_> {
    fn statement(&mut self, statement: &'t Statement) {
        match &statement.kind {
            StatementKind::For(one) => {
                self.value(&one.from);
                self.place(&one.variable, Use::Write, Extent::Scalar(one.scalar));
                [&one.to, &one.by].into_iter().for_each(|value| self.value(value));
                self.repeated(&one.body);
            }
            StatementKind::While { condition, body } => {
                self.value(condition);
                self.repeated(body);
            }
            StatementKind::Repeat { body, until } => {
                self.repeated(body);
                self.value(until);
            }
            _ => visit::statement(self, statement),
        }
    }

    fn call(&mut self, call: &'t Call) {
        call.enable.iter().for_each(|value| self.value(value));
        call.callee.instance().into_iter().for_each(|instance| visit::indexes(self, instance));
        // What an in-out does with a variable only the block knows.
        let (delivers, goes_in): (Vec<_>, Vec<_>) = call.arguments.iter().partition(|argument| output(argument).is_some());
        goes_in.into_iter().chain(delivers).for_each(|argument| self.argument(argument));
    }

    fn place(&mut self, place: &'t Place, how: Use, _: Extent<'t>) {
        visit::indexes(self, place);
        match how {
            Use::Read => {
                visit::base(self, place);
                if let Some(index) = self.variable(place)
                    && !std::mem::replace(&mut self.written[index], true)
                {
                    self.reads.push((index, place.span));
                }
            }
            // Where an address was taken it may be written in ways that no one sees.
            Use::Write | Use::ReadWrite | Use::Address | Use::Instance => {
                if let Some(index) = self.variable(place) {
                    self.written[index] = true;
                }
            }
        }
    }
}

/// Whether an assignment or a call names a variable as its target.
fn assigned(variables: &[Variable], statements: &[Statement], index: usize) -> bool {
    let walk = Walk { variables, written: Vec::new(), reads: Vec::new() };
    let mut targets = Targets { walk, index, found: false };
    visit::statements(&mut targets, statements);
    targets.found
}

/// Goes through the statements of a body, not into values, and looks for a variable among the targets.
struct Targets<'a> {
    walk: Walk<'a>,
    index: usize,
    found: bool,
}

impl<'t> Visit<'t> for Targets<'_> {
    fn value(&mut self, _: &'t Value) {}

    fn text(&mut self, _: &'t Text) {}

    fn call(&mut self, call: &'t Call) {
        self.found |= outputs(call).any(|place| self.walk.variable(place) == Some(self.index));
    }

    fn place(&mut self, place: &'t Place, how: Use, _: Extent<'t>) {
        self.found |= how != Use::Read && self.walk.variable(place) == Some(self.index);
    }
}
