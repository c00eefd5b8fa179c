//! Properties of a scenario: held against its scans as those of a campaign are.

use sieben_campaign::judge::{Broken, Judge};
use sieben_campaign::slots;
use sieben_campaign::spec::{Placed, Property, Spec};
use sieben_cpu::Cpu;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};
use sieben_sim::scenario::{Scenario, ScenarioError};
use sieben_sim::trace::Moment;

use super::{Conditions, Verdict};
use crate::campaign::watching::{self, Failed, Watched, Watching};
use crate::project::{Overrides, Project};
use crate::refusal::Refusal;

/// The properties of a scenario, as a campaign has them.
pub(super) fn spec(scenario: &Scenario) -> Spec {
    let placed = |text: &str| Placed { text: text.to_owned(), span: Span::new(FileId(0), 0, 0) };
    let properties = scenario.properties().iter().map(|property| Property {
        kind: property.kind,
        name: property.name.clone(),
        span: Span::new(FileId(0), 0, 0),
        expression: placed(&property.expression),
        then: property.then.as_deref().map(placed),
        within_us: property.within_us,
    });
    Spec { properties: properties.collect(), ..Spec::default() }
}

/// The program with the properties of a scenario, which is called so.
///
/// # Errors
/// One of them does not compile.
pub(super) fn compile(
    project: &Project,
    spec: &Spec,
    (scenario, file): (&Scenario, &str),
    overrides: Overrides,
    conditions: &Conditions,
) -> Result<Watched, Verdict> {
    let slots = slots::of_properties(spec);
    let line_of = |slot: usize| {
        let property = slots.partition_point(|&begin| begin <= slot).saturating_sub(1);
        scenario.properties().get(property).map_or(0, |property| property.line)
    };
    watching::compile(project, spec, overrides).map_err(|failed| match failed {
        Failed::Program(build) => Verdict::DoesNotCompile(conditions.outside.show(&build.findings, &build.project.texts)),
        Failed::Expressions(wrong) => {
            let refusal = |(slot, diagnostic): (usize, sieben_model::diagnostic::Diagnostic)| {
                Refusal::new(Problem::P7160, format!("{file}:{}: {}", line_of(slot), diagnostic.message))
            };
            Verdict::Misread(wrong.into_iter().map(refusal).collect())
        }
    })
}

/// Holds the properties of a scenario against its scans.
pub(super) struct Holding<'a> {
    scenario: &'a Scenario,
    spec: &'a Spec,
    watching: &'a Watching,
    judge: Judge<'a>,
    values: Vec<f64>,
    is_over: bool,
}

impl<'a> Holding<'a> {
    /// From the first scan on.
    pub(super) fn new(scenario: &'a Scenario, spec: &'a Spec, watching: &'a Watching) -> Self {
        let judge = Judge::new(spec, scenario.cycle_us());
        Self { scenario, spec, watching, judge, values: Vec::new(), is_over: false }
    }

    /// After a scan: the first property that does not hold, once.
    pub(super) fn scanned(&mut self, cpu: &mut Cpu, at: Moment) -> Option<ScenarioError> {
        if self.is_over {
            return None;
        }
        if !self.watching.look(cpu, &mut self.values) {
            self.is_over = true;
            let line = self.scenario.properties().first().map_or(0, |property| property.line);
            let message = "a property cannot be computed here, such as an element beyond the end of its array".to_owned();
            return Some(ScenarioError { line, message });
        }
        let broken = self.judge.scanned(at, &self.values)?;
        Some(self.told(broken))
    }

    /// After the last scan.
    pub(super) fn ended(&mut self) -> Option<ScenarioError> {
        let broken = if self.is_over { None } else { self.judge.ended(&self.values) }?;
        Some(self.told(broken))
    }

    fn told(&mut self, broken: Broken) -> ScenarioError {
        self.is_over = true;
        let property = &self.spec.properties[broken.property];
        let line = self.scenario.properties()[broken.property].line;
        let moment = broken.at;
        ScenarioError {
            line,
            message: format!("\"{}\": `{}` {} after {moment}", property.name, property.expression.text, property.kind.demand()),
        }
    }
}
