//! From the file of a campaign and its programs to a campaign that can be run.

use std::path::Path;
use std::sync::{Arc, OnceLock};
use std::time::Duration;

use sieben_campaign::identity::Bundle;
use sieben_campaign::numbering::Numbering;
use sieben_campaign::spec::{Draw, Drawn, Replay, Spec, Value};
use sieben_cpu::Loaded;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_sim::names::Name;
use sieben_sim::scenario::rules::Tolerance;
use sieben_sim::scenario::{Allowed, Scenario};

use super::targets::{self, Rounding, Target};
use super::watching::{self, Failed as NotCompiled, Watched};
use super::{Campaign, Factory, Subject};
use crate::project::{Build, Overrides, Project};
use crate::refusal::Refusal;
use crate::{controller, duration, schedule};

/// Most lines of a recording that are told of.
const ERRORS_MAX: usize = 10;

/// Where a campaign gets its files from: paths count from its folder.
pub trait Files {
    /// The program at a path.
    ///
    /// # Errors
    /// It cannot be read.
    fn project(&self, path: &str) -> Result<Project, Refusal>;
    /// The text of a file.
    ///
    /// # Errors
    /// It cannot be read.
    fn text(&self, path: &str) -> Result<String, Refusal>;
}

/// Why a campaign cannot be run.
pub enum Failed {
    /// Something in its file, with the place.
    Spec(Vec<Diagnostic>),
    /// A program of it does not compile.
    Program(Box<Build>),
    /// A program of it cannot be read.
    Refused(Refusal),
}

/// Compiles a campaign, whose file has this text, with its programs.
///
/// # Errors
/// See [`Failed`].
pub fn open(spec: Spec, text: &str, files: &dyn Files, overrides: Overrides, engine: &Factory<'_>) -> Result<Campaign, Failed> {
    let mut programs: Vec<Subject> = Vec::new();
    let mut bundle = Bundle::default();
    let recording = spec.replay.as_ref().map(|replay| recording(replay, files, &mut bundle)).transpose()?;
    let overrides = Overrides { cpu: overrides.cpu.or(recording.as_ref().and_then(|recording| recording.cpu)), ..overrides };
    for path in &spec.programs {
        let project = files.project(&path.text).map_err(Failed::Refused)?;
        take_in(&mut bundle, &path.text, &project);
        let watched = watching::compile(&project, &spec, overrides).map_err(|failed| match failed {
            NotCompiled::Program(build) => Failed::Program(build),
            NotCompiled::Expressions(wrong) => Failed::Spec(wrong.into_iter().map(|(_, diagnostic)| diagnostic).collect()),
        })?;
        programs.push(subject(&spec, path.text.clone(), watched, recording.as_ref(), engine).map_err(Failed::Spec)?);
    }
    let bits = programs.first().map_or(0, |program| program.bits.len());
    let numbering = Numbering::new(&spec, bits).map_err(|diagnostic| Failed::Spec(vec![*diagnostic]))?;
    let identity = bundle.identity(text, spec.seed);
    let warnings = watching::constants(&spec);
    Ok(Campaign { spec, numbering, identity, bundle, programs, warnings, recording })
}

/// The recording that a campaign replays.
fn recording(replay: &Replay, files: &dyn Files, bundle: &mut Bundle) -> Result<Scenario, Failed> {
    let path = &replay.scenario.text;
    let text = files.text(path).map_err(Failed::Refused)?;
    bundle.add(path.as_str(), &text);
    let told = |message: String| Diagnostic::new(Problem::P7163, replay.scenario.span, message);
    let scenario = Scenario::parse(&text).map_err(|errors| {
        let all = errors.iter().take(ERRORS_MAX).map(|error| told(format!("`{path}`, line {}: {}", error.line, error.message)));
        Failed::Spec(all.collect())
    })?;
    if scenario.has_tables() {
        let message = format!("`{path}` has a table, whose rows are scenarios of their own");
        return Err(Failed::Spec(vec![told(message).help("let `[sweep]` or `[exhaustive]` go through its values")]));
    }
    // What the recording allows itself holds where the campaign does not say more.
    let own = scenario.allowed();
    let allowed = Allowed {
        within_us: own.within_us.max(replay.within_us),
        tolerance: replay.tolerance.map(Tolerance::Absolute).or(own.tolerance),
        ignored: own.ignored.iter().chain(&replay.ignore).cloned().collect(),
    };
    Ok(scenario.allowing(allowed))
}

/// Names of the recording that the program does not have.
fn missing(spec: &Spec, scenario: &Scenario, build: &Build) -> Vec<Diagnostic> {
    let Some(replay) = &spec.replay else { return Vec::new() };
    let missing = |(line, name): (usize, &str)| {
        let error =
            Name::parse(name, &build.project.symbols, &build.compiled.program).err().filter(|_| !scenario.allowed().ignores(name))?;
        Some(Diagnostic::new(Problem::P7161, replay.scenario.span, format!("`{}`, line {line}: {error}", replay.scenario.text)))
    };
    scenario.names().into_iter().filter_map(missing).take(ERRORS_MAX).collect()
}

fn subject(
    spec: &Spec,
    path: String,
    watched: Watched,
    recording: Option<&Scenario>,
    engine: &Factory<'_>,
) -> Result<Subject, Vec<Diagnostic>> {
    let Watched { build, watching, cpu } = watched;
    let mut wrong = Vec::new();
    let mut set = Vec::new();
    let mut fixed = Vec::new();
    for one in &spec.set {
        let done = match Target::of(&one.name, &build) {
            Err(diagnostic) => {
                wrong.push(*diagnostic);
                continue;
            }
            Ok(Target::Name(name)) => targets::setting(&name, &one.value, Rounding::Never).map(|setting| set.push(setting)),
            Ok(Target::Plant(module, parameter)) => {
                let row = &build.project.settings.modules[module].device.kind.parameters[parameter];
                targets::parameter(row, &one.value).map(|value| fixed.push((module, parameter, value)))
            }
        };
        wrong.extend(done.err().map(|message| unfit(&one.name.text, one.name.span, &message)));
    }
    let mut all = Vec::new();
    for sweep in &spec.sweep {
        match Target::of(&sweep.name, &build) {
            Err(diagnostic) => wrong.push(*diagnostic),
            Ok(target) => {
                let unfit = |value| {
                    fits(&target, value, &build, Rounding::Never).err().map(|message| unfit(&sweep.name.text, sweep.name.span, &message))
                };
                wrong.extend(sweep.values.iter().find_map(unfit));
                all.push(target);
            }
        }
    }
    for draw in &spec.draw {
        match Target::of(&draw.name, &build) {
            Err(diagnostic) => wrong.push(*diagnostic),
            Ok(target) => {
                wrong.extend(unfit_draw(draw, &target, &build));
                all.push(target);
            }
        }
    }
    for row in &spec.faults {
        wrong.extend(unfit_fault(row, &build));
    }
    let bits = match &spec.exhaustive {
        None => Vec::new(),
        Some(exhaustive) => {
            if let Some(block) = &exhaustive.block {
                let message = format!("`block = \"{}\"` is not there yet: every combination goes through OB 1", block.text);
                let help = "leave `block` out, and name the inputs and outputs that OB 1 gives the block";
                wrong.push(Diagnostic::new(Problem::P7159, block.span, message).help(help));
            }
            targets::bits(exhaustive, &build).unwrap_or_else(|diagnostics| {
                wrong.extend(diagnostics);
                Vec::new()
            })
        }
    };
    if let Some(scenario) = recording {
        wrong.extend(missing(spec, scenario, &build));
        let plant = all.iter().any(|target| matches!(target, Target::Plant(..)));
        if plant || !fixed.is_empty() || !spec.faults.is_empty() {
            let place = spec.replay.as_ref().map_or_else(|| spec.span(), |replay| replay.scenario.span);
            let message = "a recording brings the inputs of its plants along: their parameters and faults have nothing to do in it";
            wrong.push(
                Diagnostic::new(Problem::P7159, place, message).help("`[disturb]` moves the inputs, lets them bounce, and adds to words"),
            );
        }
    }
    if !wrong.is_empty() {
        return Err(wrong);
    }
    let loaded = Loaded::new(cpu, Arc::new(build.compiled.program.clone()), |program, layout| engine(program, layout));
    let cycle_us = match recording {
        Some(scenario) => scenario.cycle_us(),
        None => duration::micros(schedule::going_cycle(None, &build.project.settings)).max(1),
    };
    let scans = recording.map_or_else(|| scans(spec, cycle_us), Scenario::scans);
    let settings = controller::settings(&build);
    let interpreted = OnceLock::new();
    Ok(Subject { path, cpu, loaded, interpreted, settings, watching, cycle_us, scans, set, fixed, targets: all, bits, build })
}

/// How many scans begin before a scenario ends: one, if nothing is said and every combination is tried.
fn scans(spec: &Spec, cycle_us: u64) -> u64 {
    let usual = if spec.exhaustive.is_some() { cycle_us } else { duration::micros(Duration::from_secs(10)) };
    spec.for_us.unwrap_or(usual).saturating_add(spec.settle_us).div_ceil(cycle_us).max(1)
}

fn unfit(name: &str, span: sieben_model::source::Span, message: &str) -> Diagnostic {
    Diagnostic::new(Problem::P7162, span, format!("`{name}`: {message}"))
}

/// Whether a value fits what it goes to.
fn fits(target: &Target, value: &Value, build: &Build, rounding: Rounding) -> Result<(), String> {
    match (target, target.parameter(build)) {
        (Target::Name(name), _) => targets::setting(name, value, rounding).map(drop),
        (_, Some(parameter)) => targets::parameter(parameter, value).map(drop),
        (_, None) => Ok(()),
    }
}

/// What is wrong with a draw for what it goes to.
fn unfit_draw(draw: &Draw, target: &Target, build: &Build) -> Option<Diagnostic> {
    let (name, span) = (&draw.name.text, draw.name.span);
    let is_bit = matches!(target, Target::Name(name) if name.item().width() == 1);
    match (&draw.drawn, target) {
        (Drawn::Choice(values), _) => {
            values.iter().find_map(|value| fits(target, value, build, Rounding::Never).err()).map(|message| unfit(name, span, &message))
        }
        (Drawn::Walk(_), Target::Plant(..)) => {
            Some(unfit(name, span, "a parameter of a plant is what it is from the beginning; only values of the program walk"))
        }
        (Drawn::Walk(walk), _) if walk.step.is_none() != is_bit => {
            let message = if is_bit {
                "a bit has no `step`"
            } else {
                "a number needs a `step` to walk by: `walk = { every = \"2s\", chance = 0.1, step = 5 }`"
            };
            Some(unfit(name, span, message))
        }
        (Drawn::Once(_), Target::Name(_)) if is_bit => Some(unfit(name, span, "a bit is drawn by `choice = [true, false]`, or walks")),
        // Whether a number fits the type: the middle of it does, or none.
        (Drawn::Once(_), Target::Name(_)) => {
            fits(target, &Value::Number(0.0), build, Rounding::Nearest).err().map(|message| unfit(name, span, &message))
        }
        _ => None,
    }
}

/// What is wrong with a fault for the signal that it names.
fn unfit_fault(row: &sieben_campaign::spec::FaultRow, build: &Build) -> Option<Diagnostic> {
    let modules = &build.project.settings.modules;
    let wrong = |message: String| Diagnostic::new(Problem::P7161, row.signal.span, message);
    let Some((plant, signal)) = row.signal.text.split_once('.') else {
        return Some(wrong(format!("`{}` is no signal of a plant; write `PLANT.SIGNAL`", row.signal.text)));
    };
    let Some(module) = modules.iter().find(|module| module.device.name == plant) else {
        let known: Vec<&str> = modules.iter().map(|module| module.device.name.as_str()).collect();
        let known = if known.is_empty() { "has none".to_owned() } else { format!("has {}", sieben_model::nearest::one_of(known)) };
        return Some(wrong(format!("there is no plant `{plant}`; the project {known}")));
    };
    let signals = module.device.terminals().ok()?.signals;
    let fault = |kind| sieben_sim::wrap::Fault { module: plant.to_owned(), signal: signal.to_owned(), kind, from_us: None, until_us: None };
    row.kinds.iter().find_map(|&kind| fault(kind).fits(module.device.kind, &signals).err()).map(wrong)
}

/// Takes all texts of a program in, by names that count from its folder.
fn take_in(bundle: &mut Bundle, path: &str, project: &Project) {
    let texts = &project.texts;
    for source in texts.program.iter().chain(texts.documents.iter()).map(|(_, file)| file) {
        let name = Path::new(&source.name);
        let name = project.home.as_ref().and_then(|home| name.strip_prefix(home).ok()).unwrap_or(name);
        bundle.add(format!("{path}/{}", name.display()).replace('\\', "/"), &source.text);
    }
}
