//! What blocks that extend and implement others must keep to.

use sieben_model::block::BlockId;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::{Interface, Section, Variable};
use sieben_model::problems::Problem;
use sieben_model::source::Span;

use super::constructors::FB_INIT;
use super::environment::Environment;
use crate::scope::key;
use crate::st::ast::{Access, BlockKind, MemberKind};
use crate::st::dialect::{Construct, Judgement};
use crate::st::objects::{Member, Object};

/// Members that one message lists.
const LISTED_MAX: usize = 8;

impl Environment<'_> {
    /// Says what is missing in blocks, and which members do not fit those that they stand for.
    pub(super) fn object_rules(&self) -> Vec<Diagnostic> {
        let mut diagnostics = Vec::new();
        for (id, object) in self.items.objects.iter() {
            self.complete(id, object, &mut diagnostics);
            for member in object.members.values() {
                self.member(id, object, member, &mut diagnostics);
            }
        }
        diagnostics
    }

    /// Whether a block that has instances has all that its base and its interfaces ask for.
    fn complete(&self, id: BlockId, object: &Object, diagnostics: &mut Vec<Diagnostic>) {
        if object.is_abstract || object.kind == BlockKind::Interface {
            return;
        }
        let objects = &self.items.objects;
        let mut missing: Vec<&Member> = Vec::new();
        // What a base that is not there has, nobody knows.
        let above = if objects.lacks_base(id) { Vec::new() } else { objects.above(id) };
        for upper in above.into_iter().chain([id]).filter_map(|upper| objects.get(upper)) {
            for wanted in upper.members.values().filter(|member| member.is_abstract) {
                let has = objects.member(id, &wanted.name, wanted.kind).is_some_and(|found| !found.is_abstract);
                let told = missing.iter().any(|known| key(&known.name) == key(&wanted.name) && known.kind == wanted.kind);
                if !has && !told {
                    missing.push(wanted);
                }
            }
        }
        let Some(first) = missing.first() else { return };
        let mut names: Vec<String> = missing.iter().take(LISTED_MAX).map(|member| shown(member)).collect();
        if missing.len() > LISTED_MAX {
            names.push(format!("{} more", missing.len() - LISTED_MAX));
        }
        let own = first.of == id;
        let message = match own {
            true => format!("`{}` has no statements for {} and is not ABSTRACT", object.name, names.join(", ")),
            false => format!("`{}` lacks {}", object.name, names.join(", ")),
        };
        let related = if own { "ABSTRACT here" } else { "asked for here" };
        let help = match first.kind {
            MemberKind::Method => format!("Write `METHOD PUBLIC {} … END_METHOD` in `{}`, or make it ABSTRACT.", first.name, object.name),
            _ => format!("Write `PROPERTY PUBLIC {} … END_PROPERTY` in `{}`, or make it ABSTRACT.", first.name, object.name),
        };
        diagnostics.push(Diagnostic::new(Problem::P6281, object.span, message).related(first.span, related).help(help));
    }

    /// Whether a member fits what it stands for.
    fn member(&self, id: BlockId, object: &Object, member: &Member, diagnostics: &mut Vec<Diagnostic>) {
        let mut report = |problem, message: String, related: Option<(Span, &str)>, help: &str| {
            let mut diagnostic = Diagnostic::new(problem, member.span, message).help(help.to_owned());
            if let Some((span, label)) = related {
                diagnostic = diagnostic.related(span, label);
            }
            diagnostics.push(diagnostic);
        };
        let name = &member.name;
        if member.is_abstract && member.has_body {
            report(
                Problem::P6283,
                format!("{} is ABSTRACT and has statements", shown(member)),
                None,
                "Leave the statements away, or remove ABSTRACT.",
            );
        }
        let overridden = self.items.objects.overridden(id, name, member.kind);
        let inherited: Vec<&&Member> = overridden.iter().filter(|other| !self.items.objects.is_interface(other.of)).collect();
        if object.kind != BlockKind::Interface {
            match inherited.first() {
                None if member.is_override && !self.items.objects.lacks_base(id) => report(
                    Problem::P6283,
                    format!("{} overrides nothing: no block that `{}` extends has it", shown(member), object.name),
                    None,
                    "Remove OVERRIDE, or write the name as the base has it.",
                ),
                Some(base) if base.is_final => report(
                    Problem::P6283,
                    format!("{} is FINAL in `{}`, and nothing overrides it", shown(member), self.shown(base.of)),
                    Some((base.span, "declared here")),
                    "Give it another name, or remove FINAL there.",
                ),
                Some(base) if !member.is_override && object.dialect.judge(Construct::SilentOverride) == Judgement::Reject => {
                    let message = format!("{} overrides that of `{}` without saying so", shown(member), self.shown(base.of));
                    let at = Span { end: member.span.start, ..member.span };
                    let diagnostic = Diagnostic::new(Problem::P6283, member.span, message).related(base.span, "overridden here").fix(
                        at,
                        "OVERRIDE ",
                        "write `OVERRIDE`",
                    );
                    diagnostics.push(diagnostic);
                }
                _ => {}
            }
        }
        for other in overridden {
            let as_asked = member.access == other.access || member.access == Access::Public;
            if self.items.objects.is_interface(other.of) && !as_asked {
                let word = if other.access == Access::Internal { "INTERNAL" } else { "PUBLIC" };
                let message = format!("{} stands for that of `{}` and has to be {word}", shown(member), self.shown(other.of));
                diagnostics.push(Diagnostic::new(Problem::P6283, member.span, message).related(other.span, "asked for here"));
            }
            let (Some(own), Some(asked)) = (self.interface_of(member.function), self.interface_of(other.function)) else { continue };
            // What parameters a declaration has that is not understood, nobody knows.
            let broken = |function| self.declared(function).is_some_and(|declared| declared.broken);
            if broken(member.function) || broken(other.function) {
                continue;
            }
            // FB_Init of a block that extends another one may take more.
            if !member.name.eq_ignore_ascii_case(FB_INIT)
                && let Some(why) = difference(&own, &asked)
            {
                let message = format!("{} differs from that of `{}`: {why}", shown(member), self.shown(other.of));
                let help = "Give both the same parameters in the same order, with the same types, and the same result.";
                diagnostics
                    .push(Diagnostic::new(Problem::P6282, member.span, message).related(other.span, "the other one is here").help(help));
                // One message for one member.
                return;
            }
        }
    }

    fn shown(&self, id: BlockId) -> String {
        self.items.names.get(&id).cloned().unwrap_or_else(|| id.to_string())
    }
}

/// `the method `M``, `GET of the property `P``.
fn shown(member: &Member) -> String {
    match member.kind {
        MemberKind::Method => format!("the method `{}`", member.name),
        MemberKind::Get => format!("GET of the property `{}`", member.name),
        MemberKind::Set => format!("SET of the property `{}`", member.name),
    }
}

/// What makes two interfaces different; `None` if calls cannot tell them apart.
fn difference(own: &Interface, asked: &Interface) -> Option<String> {
    let (mut ours, mut theirs) = (own.parameters(), asked.parameters());
    loop {
        let (one, other) = match (ours.next(), theirs.next()) {
            (None, None) => return None,
            (Some(one), None) => return Some(format!("it has {} in addition", parameter(one))),
            (None, Some(other)) => return Some(format!("it lacks {}", parameter(other))),
            (Some(one), Some(other)) => (one, other),
        };
        // The result is the last of them.
        match (one.section == Section::Return, other.section == Section::Return) {
            (true, false) => return Some(format!("it lacks {}", parameter(other))),
            (false, true) => return Some(format!("it has {} in addition", parameter(one))),
            _ => {}
        }
        if !one.name.eq_ignore_ascii_case(&other.name) || one.section != other.section {
            return Some(format!("`{}` stands where the other one has `{}`", one.name, other.name));
        }
        if one.data_type != other.data_type {
            let what = if one.section == Section::Return { "its result".to_owned() } else { format!("`{}`", one.name) };
            return Some(format!("{what} is {} and not {}", one.data_type, other.data_type));
        }
    }
}

/// A parameter or the result, as messages name it.
fn parameter(one: &Variable) -> String {
    match one.section {
        Section::Input => format!("the input `{}`", one.name),
        Section::Output => format!("the output `{}`", one.name),
        Section::InOut => format!("the VAR_IN_OUT `{}`", one.name),
        Section::Return => "a result".to_owned(),
        _ => format!("`{}`", one.name),
    }
}
