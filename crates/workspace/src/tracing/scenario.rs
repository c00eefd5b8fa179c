//! Scenarios of a project: reading one, the modules that it runs with, and the program that was recorded.

use sieben_cpu::{IoModule, Rack, SimulatedModule};
use sieben_model::problems::Problem;
use sieben_sim::scenario::{Scenario, ScenarioError};
use sieben_sim::trace::{self, Origin};

use crate::controller;
use crate::project::Build;
use crate::refusal::Refusal;
use crate::settings::modules;

/// Reads a scenario that is called so.
///
/// # Errors
/// What is wrong, line by line.
pub fn read(name: &str, text: &str) -> Result<Scenario, Vec<Refusal>> {
    Scenario::parse(text).map_err(|errors| {
        let refusal = |error: ScenarioError| Refusal::new(Problem::P6260, format!("{name}:{}: {}", error.line, error.message));
        errors.into_iter().map(refusal).collect()
    })
}

/// The modules that a scenario runs with: those of the project, unless it says itself which bytes have one. A recording brings the inputs of its modules along.
pub fn rack(build: &Build, scenario: &Scenario) -> Rack {
    let Some(bytes) = &scenario.modules else {
        if scenario.recorded.is_some() {
            return Rack::simulated(build.cpu);
        }
        let modules = &build.project.settings.modules;
        // Plants that the project does not have were told before.
        return modules::with_plants(modules, scenario.plants())
            .map_or_else(|_| controller::rack(build), |all| modules::rack(&all, build.cpu));
    };
    let bytes = bytes.start.min(build.cpu.peripheral)..bytes.end.min(build.cpu.peripheral);
    let module: Box<dyn IoModule> = Box::new(SimulatedModule::new("simulated", bytes));
    // One module inside the peripheral area always fits.
    Rack::with_only(build.cpu, vec![module]).unwrap_or_else(|_| Rack::simulated(build.cpu))
}

/// What a scenario says of plants that the project does not have.
pub fn without_plant(build: &Build, name: &str, scenario: &Scenario) -> Option<Refusal> {
    let message = modules::with_plants(&build.project.settings.modules, scenario.plants()).err()?;
    Some(Refusal::new(Problem::P6292, format!("{name}: {message}")))
}

/// What identifies a program.
pub fn origin(build: &Build) -> Origin {
    let sources = &build.project.texts.program;
    let names: Vec<&str> = build.project.sources.iter().map(|source| sources.file(source.id).name.as_str()).collect();
    let texts = build.project.sources.iter().map(|source| sources.file(source.id).text.as_str());
    Origin { title: names.join(" "), program: trace::identity(texts), cpu: build.cpu.name.to_owned() }
}

/// What is to be said about a recording that has no end.
pub fn cut_off(name: &str, scenario: &Scenario) -> Option<String> {
    scenario.recorded.as_ref().filter(|recorded| recorded.cut_off)?;
    Some(format!("`{name}` was cut off: it ends with its last whole scan"))
}
