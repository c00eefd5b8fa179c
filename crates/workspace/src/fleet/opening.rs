//! From the file of a fleet and its programs to a fleet that can be run.

use std::sync::{Arc, Mutex};

use sieben_campaign::document::at_most;
use sieben_campaign::draws::Stream;
use sieben_cpu::{Cpu, Loaded, Rack, Settings};
use sieben_engine::ImageWrites;
use sieben_model::address::{Area, Operand};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::value::Value;
use sieben_sim::names::Name;
use sieben_sim::scenario::PlantLine;

use super::endpoint::Endpoint;
use super::instance::{self, Counts, Instance};
use super::spec::{Controllers, Link, Spec};
use super::wiring::{Wire, area, carried};
use super::{Fleet, Group, Program};
pub use crate::campaign::Failed;
use crate::campaign::{Factory, Files};
use crate::project::{Build, Overrides};
use crate::settings::modules;
use crate::{controller, duration, finding, schedule};

/// Compiles a fleet with its programs; each controller is in STOP.
///
/// # Errors
/// See [`Failed`].
pub fn open(spec: Spec, files: &dyn Files, overrides: Overrides, engine: &Factory<'_>) -> Result<Fleet, Failed> {
    let mut programs: Vec<Program> = Vec::new();
    let mut groups: Vec<Group> = Vec::new();
    let mut first = 0;
    for controllers in &spec.controllers {
        let path = &controllers.program.text;
        let program = match programs.iter().position(|program| program.path == *path) {
            Some(known) => known,
            None => {
                programs.push(program(path, files, overrides, engine)?);
                programs.len() - 1
            }
        };
        groups.push(Group { program, first, count: controllers.len(), incoming: Vec::new() });
        first += controllers.len();
    }
    let mut probes: Vec<Cpu> = programs.iter().map(|program| program.cpu(controller::rack(&program.build))).collect();
    let mut wires = Vec::new();
    let mut wrong = Vec::new();
    for link in &spec.links {
        match wire(link, &spec.controllers, &groups, &programs, &mut probes) {
            Ok(wire) => {
                let number = wires.len() as u32;
                groups[wire.to].incoming.push(number);
                wires.push(wire);
            }
            Err(diagnostics) => wrong.extend(diagnostics),
        }
    }
    if !wrong.is_empty() {
        return Err(Failed::Spec(at_most(wrong, Problem::P7172)));
    }
    let mut instances = Vec::with_capacity(first as usize);
    for (group, controllers) in groups.iter().zip(&spec.controllers) {
        let program = &programs[group.program];
        for index in 0..group.count {
            let rack = program
                .rack(&spec, &controllers.name_of(index))
                .map_err(|message| Failed::Spec(vec![Diagnostic::new(Problem::P7171, controllers.program.span, message)]))?;
            let sends = |(number, wire): (u32, &Wire)| {
                let is_sender = groups[wire.from].first == group.first && wire.sends(index, groups[wire.to].count);
                is_sender.then_some((number, 0))
            };
            instances.push(Mutex::new(Instance {
                cpu: program.cpu(rack),
                number: group.first + index,
                outgoing: (0..).zip(&wires).filter_map(sends).collect(),
                inbox: std::collections::VecDeque::new(),
                started: false,
                counts: Counts::default(),
                stop: None,
                recorder: None,
            }));
        }
    }
    // Without links there is nothing to be kept.
    let boxes = || if wires.is_empty() { Vec::new() } else { instances.iter().map(|_| Mutex::default()).collect() };
    let outboxes = [boxes(), boxes()];
    // The program of the first controller says how often all of them scan, if the file does not.
    let usual = programs.first().map(|program| duration::micros(schedule::going_cycle(None, &program.build.project.settings)));
    let cycle_us = spec.cycle_us.or(usual).unwrap_or(10_000).max(1);
    Ok(Fleet { spec, cycle_us, programs, groups, wires, instances, outboxes })
}

fn program(path: &str, files: &dyn Files, overrides: Overrides, engine: &Factory<'_>) -> Result<Program, Failed> {
    let build = files.project(path).map_err(Failed::Refused)?.compile(overrides, false);
    if finding::has_errors(&build.findings) {
        return Err(Failed::Program(Box::new(build)));
    }
    let program = Arc::new(build.compiled.program.clone());
    let output_bytes = ImageWrites::of(&program).outputs.end;
    let loaded = Loaded::new(build.cpu, program, |program, layout| engine(program, layout));
    let settings = controller::settings(&build);
    Ok(Program { path: path.to_owned(), build, loaded, settings, output_bytes })
}

impl Program {
    fn cpu(&self, rack: Rack) -> Cpu {
        Cpu::new(self.loaded.clone(), rack, Settings::clone(&self.settings))
    }

    /// The modules of one controller: each plant draws from a seed of its own, by the name of its controller and its own.
    fn rack(&self, spec: &Spec, controller: &str) -> Result<Rack, String> {
        let all = &self.build.project.settings.modules;
        if all.is_empty() {
            return Ok(controller::rack(&self.build));
        }
        let line = |module: &modules::Module| PlantLine {
            module: module.device.name.clone(),
            // Files of projects have signed numbers.
            seed: Some(Stream::new(spec.seed, &format!("plant {controller}.{}", module.device.name)).next_u64() >> 1),
            parameters: Vec::new(),
        };
        let lines: Vec<PlantLine> = all.iter().map(line).collect();
        Ok(modules::rack(&modules::with_plants(all, &lines)?, self.build.cpu))
    }
}

/// A link with its names looked up.
fn wire(link: &Link, spec: &[Controllers], groups: &[Group], programs: &[Program], probes: &mut [Cpu]) -> Result<Wire, Vec<Diagnostic>> {
    let group = |endpoint: &Endpoint| spec.iter().position(|controllers| controllers.name.text == endpoint.controller.text).unwrap_or(0);
    let (from, to) = (group(&link.from), group(&link.to));
    let (sending, receiving) = (groups[from].program, groups[to].program);
    let source = looked_up(&link.from, &programs[sending].build).and_then(|(_, source, width)| {
        match instance::is_there(&probes[sending], &source) {
            true => Ok((source, width)),
            false => Err(told(&link.from, format!("`{}` lies outside what `{}` has", link.from.name.text, link.from.controller.text))),
        }
    });
    let target = looked_up(&link.to, &programs[receiving].build).and_then(|(name, target, width)| {
        if matches!(area(&target), Some(Area::Output | Area::PeripheralOutput)) {
            let message = format!("`{}` is an output, which only the program of `{}` sets", link.to.name.text, link.to.controller.text);
            let help = "let the link go to an input, bit memory or a data block";
            return Err(Box::new(told(&link.to, message).help(help)));
        }
        let zero = Value::bits(name.kind().clone(), 0);
        match name.set_at(&mut probes[receiving], &zero, 0) {
            Ok(()) => Ok((name, width)),
            Err(error) => Err(told(&link.to, error.to_string())),
        }
    });
    let ((source, from_width), (target, to_width)) = match (source, target) {
        (Ok(source), Ok(target)) => (source, target),
        (source, target) => return Err(source.err().into_iter().chain(target.err()).map(|told| *told).collect()),
    };
    if from_width != to_width {
        let bits = |width: u32| if width == 1 { "a bit".to_owned() } else { format!("{width} bits") };
        let message = format!(
            "`{}` has {} and `{}` has {}: both ends of a link have the same width",
            link.from.name.text,
            bits(from_width),
            link.to.name.text,
            bits(to_width)
        );
        return Err(vec![Diagnostic::new(Problem::P7172, link.to.name.span, message)]);
    }
    let is_output = matches!(area(&source), Some(Area::Output | Area::PeripheralOutput));
    let (from_index, to_index, latency_us) = (link.from.index, link.to.index, link.latency_us);
    let wire = Wire { from, from_index, source, is_output, to, to_index, target, latency_us };
    if !(0..groups[from].count).any(|index| wire.sends(index, groups[to].count)) {
        let message = "this link connects no two controllers: all its indices lie outside";
        return Err(vec![Diagnostic::new(Problem::P7172, link.to.controller.span, message)]);
    }
    Ok(wire)
}

fn looked_up(endpoint: &Endpoint, build: &Build) -> Result<(Name, Operand, u32), Box<Diagnostic>> {
    let text = &endpoint.name.text;
    let name = Name::parse(text, &build.project.symbols, &build.compiled.program).map_err(|error| told(endpoint, error.to_string()))?;
    let (operand, width) = carried(&name).map_err(|message| told(endpoint, message))?;
    Ok((name, operand, width))
}

fn told(endpoint: &Endpoint, message: String) -> Box<Diagnostic> {
    Box::new(Diagnostic::new(Problem::P7172, endpoint.name.span, message))
}
