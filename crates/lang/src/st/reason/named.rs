//! The variables that a statement of Structured Text names, with what they hold after it.

use sieben_model::block::BlockId;

use crate::sentences::text::one_line;
use crate::sentences::{Language, Moment, Named, Surroundings};
use crate::st::tree::visit::{self, Extent, Use, Visit};
use crate::st::tree::{Call, Callee, Place, Scalar, Statement, StatementKind, TypedBlock, Value};

use super::values::{Values, format_scalar};
use super::{Part, find, leaves};
/// The variables of the part of a statement that a step belongs to: its target first, then what it reads, each once.
pub(crate) fn named(around: Surroundings<'_>, block: &TypedBlock, moment: &Moment<'_>, language: Language) -> Vec<Named> {
    let place = moment.event.place;
    let Some(code) = around.program.code.get(&place.block) else { return Vec::new() };
    let index = place.statement as usize;
    let Some(&span) = code.spans.get(index) else { return Vec::new() };
    if leaves(code.code.statement(index)) {
        return Vec::new();
    }
    let Some(part) = find(&block.body.statements, span) else { return Vec::new() };
    let mut names = Names::default();
    names.part(part);
    let values = Values::new(around, moment, code);
    let mut found: Vec<Named> = Vec::new();
    // What a statement writes is what it is about.
    let (written, read): (Vec<_>, Vec<_>) = names.found.into_iter().partition(|one| one.is_target);
    let targets: Vec<String> = written.iter().map(|one: &Found<'_>| one_line(values.slice(one.place.span))).collect();
    for Found { place, scalar, instance_of, .. } in written.into_iter().chain(read) {
        let name = one_line(values.slice(place.span));
        // Which element was meant is no longer known once the index is another one.
        let is_lost = targets.iter().any(|target| *target != name && indexes_name(&name, target));
        if !is_name(&name) || is_lost || found.iter().any(|one| one.name.eq_ignore_ascii_case(&name)) {
            continue;
        }
        let bits = scalar.and_then(|scalar| Some((scalar, values.read_behind(place, scalar)?)));
        let value = bits.map(|(scalar, bits)| format_scalar(scalar, bits).of(language).to_owned());
        found.push(Named { name, value, instance_of });
    }
    found
}

/// Whether a piece of source is the name of a variable: what the compiler adds has the place of something else.
fn is_name(text: &str) -> bool {
    let outside = |text: &str| {
        let mut depth = 0_u32;
        text.chars().all(|c| {
            match c {
                '[' => depth += 1,
                ']' => depth = depth.saturating_sub(1),
                _ => {}
            }
            depth > 0 || c == ']' || c.is_alphanumeric() || matches!(c, '_' | '.' | '#' | '"' | '%' | '^')
        })
    };
    text.starts_with(|c: char| c.is_alphabetic() || matches!(c, '_' | '#' | '"' | '%')) && outside(text)
}

/// Whether the indexes of a name have this variable among them.
fn indexes_name(name: &str, variable: &str) -> bool {
    let Some((_, indexes)) = name.split_once('[') else { return false };
    indexes.split(|c: char| !(c.is_alphanumeric() || matches!(c, '_' | '.' | '#' | '"'))).any(|word| word.eq_ignore_ascii_case(variable))
}

/// A place that is named.
struct Found<'t> {
    place: &'t Place,
    scalar: Option<Scalar>,
    instance_of: Option<BlockId>,
    is_target: bool,
}

/// Collects what a part names, in the order of the source.
#[derive(Default)]
struct Names<'t> {
    found: Vec<Found<'t>>,
}

impl<'t> Names<'t> {
    /// A part of a body, without the statements inside it.
    fn part(&mut self, part: Part<'t>) {
        let statement = match part {
            Part::Condition(value) | Part::Until(value) => return self.value(value),
            Part::Next(one) => return self.place(&one.variable, Use::Write, Extent::Scalar(one.scalar)),
            Part::Statement(statement) => statement,
        };
        match &statement.kind {
            StatementKind::If { branches, .. } => branches.iter().take(1).for_each(|(condition, _)| self.value(condition)),
            StatementKind::Case { selector, .. } => self.value(selector),
            StatementKind::While { condition, .. } => self.value(condition),
            StatementKind::Repeat { until, .. } => self.value(until),
            StatementKind::For(one) => {
                self.place(&one.variable, Use::Write, Extent::Scalar(one.scalar));
                [&one.from, &one.to, &one.by].into_iter().for_each(|value| self.value(value));
            }
            StatementKind::Block(_) => {}
            _ => visit::statement(self, statement),
        }
    }
}

impl<'t> Visit<'t> for Names<'t> {
    /// What the compiler does before a value has no name in the source.
    fn step(&mut self, _: &'t Statement) {}

    fn value(&mut self, value: &'t Value) {
        visit::value(self, value);
    }

    fn call(&mut self, call: &'t Call) {
        if let Callee::Instance { block, instance, .. } = &call.callee {
            self.found.push(Found { place: instance, scalar: None, instance_of: Some(*block), is_target: false });
        }
        visit::call(self, call);
    }

    fn place(&mut self, place: &'t Place, how: Use, extent: Extent<'t>) {
        if how != Use::Instance {
            let scalar = if let Extent::Scalar(scalar) = extent { Some(scalar) } else { None };
            self.found.push(Found { place, scalar, instance_of: None, is_target: how == Use::Write });
        }
        visit::indexes(self, place);
    }
}
