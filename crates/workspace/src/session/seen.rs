//! The statement that is shown as the last one: of a call into the library that is over, the call itself.

use std::sync::Arc;

use sieben_engine::{FaultPlace, Machine, StatementEvent};
use sieben_lang::compiled::Compiled;
use sieben_lang::reason::{Language, Moment, Named, Reasons};
use sieben_model::block::BlockId;
use sieben_model::interface::Section;
use sieben_model::value::{Kind, Shown};
use sieben_sim::history::{Around, Position, Until, Unwatched, Watch};
use sieben_sim::names::Name;

use super::{Session, scope};
use crate::project::Build;

/// A call into the library that is over where the run stands.
#[derive(Clone, Debug)]
pub(super) struct Returned {
    /// Where the run stands.
    position: Position,
    event: StatementEvent,
    around: Around,
}

/// Pauses where the user's own program stands.
pub(super) struct OutOfLibrary<'c>(pub(super) &'c Compiled);

impl Watch for OutOfLibrary<'_> {
    fn before(&mut self, _: &Machine, place: FaultPlace) -> bool {
        !self.0.is_of_library(place.block)
    }
}

impl Session {
    /// Whether a statement stands in a block of the library.
    pub(super) fn in_library(&self, place: FaultPlace) -> bool {
        self.build.compiled.is_of_library(place.block)
    }

    /// Makes known what the last statement did, and of a call into the library what the whole call did.
    pub(super) fn look_closely(&mut self) {
        self.history.look_closely();
        let here = self.history.position();
        if self.returned.as_ref().is_some_and(|returned| returned.position == here) {
            return;
        }
        self.returned = None;
        let Some(last) = self.history.last().filter(|event| self.in_library(event.place)) else { return };
        let after = last.after.clone();
        if self.history.next_place().is_none_or(|place| self.in_library(place)) {
            return;
        }
        let build = Arc::clone(&self.build);
        let Ok(call) = self.history.find_back(false, &mut OutOfLibrary(&build.compiled)) else { return };
        self.history.go_to_position(call);
        self.history.run(Until { statements: 1, scans: 1 }, &mut Unwatched);
        self.history.look_closely();
        let called = self.history.last().cloned().zip(self.history.around().map(|around| around.before.clone()));
        self.history.go_to_position(here);
        if let Some((event, before)) = called {
            let event = StatementEvent { after, ..event };
            let around = Around { before, after: self.history.cpu().machine().clone() };
            self.returned = Some(Returned { position: here, event, around });
        }
    }

    /// The statement that is shown as the last one, and the machine around it if it was looked at closely.
    pub(super) fn executed(&self) -> Option<(&StatementEvent, Option<&Around>)> {
        let here = self.history.position();
        match self.returned.as_ref().filter(|returned| returned.position == here) {
            Some(returned) => Some((&returned.event, Some(&returned.around))),
            None => Some((self.history.last()?, self.history.around())),
        }
    }

    /// The variables that the last statement names, with their values now; none in STL.
    pub(super) fn values_after(&self) -> Vec<(String, String)> {
        let Some((event, around)) = self.executed() else { return Vec::new() };
        let machine = around.map_or(self.cpu().machine(), |around| &around.after);
        LineValues::new(self).of(event, machine)
    }
}

/// Reads the variables that statements of ST and SCL name, at any moment of a run.
pub struct LineValues {
    build: Arc<Build>,
    language: Language,
}

/// Outputs of an instance of the library that stand after its call at most.
const OUTPUTS_MAX: usize = 4;

impl LineValues {
    /// For the program of a session.
    pub fn new(session: &Session) -> Self {
        Self { build: Arc::clone(&session.build), language: session.language }
    }

    /// Whether a statement works on registers, as those of STL do.
    pub fn on_registers(&self, place: FaultPlace) -> bool {
        self.build.compiled.bodies.get(&place.block).is_none_or(|body| body.works_on_registers())
    }

    /// The variables that a statement names, with what they hold in this machine, which may be a later one: that of the return from a call.
    pub fn of(&self, event: &StatementEvent, machine: &Machine) -> Vec<(String, String)> {
        let Self { build, language } = self;
        let moment = Moment { event, before: None, after: machine, fault: None };
        let reasons = Reasons::new(&build.compiled, &build.project.texts.program, &build.project.symbols);
        let mut values = Vec::new();
        for Named { name, value, instance_of } in reasons.named(&moment, *language) {
            if let Some(block) = instance_of {
                for output in outputs(build, block) {
                    let name = format!("{name}.{output}");
                    values.extend(self.typed(&name, event, machine).map(|value| (name, value)));
                }
                continue;
            }
            let of_element = || self.typed(&self.with_numbers(&name, event, machine)?, event, machine);
            let shown = self.typed(&name, event, machine).or_else(of_element).or(value);
            values.extend(shown.map(|value| (name, value)));
        }
        values
    }

    /// `list[2].x` for `list[i].x`; `None` if an index is no variable or number.
    fn with_numbers(&self, name: &str, event: &StatementEvent, machine: &Machine) -> Option<String> {
        let mut numbered = String::new();
        let mut rest = name;
        while let Some((before, indexes)) = rest.split_once('[') {
            let (indexes, after) = indexes.split_once(']')?;
            let number = |index: &str| match index.trim().parse::<i64>() {
                Ok(number) => Some(number),
                Err(_) => self.typed(index.trim(), event, machine)?.parse().ok(),
            };
            let numbers: Option<Vec<String>> = indexes.split(',').map(|index| number(index).map(|number| number.to_string())).collect();
            numbered.push_str(&format!("{before}[{}]", numbers?.join(",")));
            rest = after;
        }
        Some(numbered + rest)
    }

    /// A value in the notation of its type. The block has its instance and its pointers where it had them before the statement.
    fn typed(&self, name: &str, event: &StatementEvent, machine: &Machine) -> Option<String> {
        let Build { compiled, project, .. } = &*self.build;
        let name = Name::parse_in(name, scope(&self.build, Some(event.place.block)), &project.symbols, &compiled.program).ok()?.readable();
        let shown = name.shown_in(machine, &event.before)?;
        Some(match (name.kind(), &shown) {
            // As ST writes it.
            (Kind::Bit, Shown::Bit(bit)) => if *bit { "TRUE" } else { "FALSE" }.to_owned(),
            _ => shown.readable(),
        })
    }
}

/// The outputs of a block of the library, which its source does not show.
fn outputs(build: &Build, block: BlockId) -> impl Iterator<Item = &str> {
    let code = build.compiled.program.code.get(&block).filter(|_| build.compiled.is_of_library(block));
    let variables = code.map_or(&[][..], |code| &code.interface.variables);
    let outputs = variables.iter().filter(|variable| variable.section == Section::Output && variable.data_type.is_elementary());
    outputs.map(|variable| variable.name.as_str()).take(OUTPUTS_MAX)
}
