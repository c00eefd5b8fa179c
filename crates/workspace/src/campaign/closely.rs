//! A scenario that breaks something, looked at closely: where it breaks, which statement wrote what the property says, and what was around it.

use std::collections::VecDeque;

use sieben_campaign::row::Verdict;
use sieben_campaign::shrinking::{Break, Signature};
use sieben_cpu::Cpu;
use sieben_engine::Tracer;
use sieben_model::address::{Address, Area, Width};
use sieben_model::testing::Signal;
use sieben_model::types::DataType;
use sieben_sim::names::{Name, Sample};
use sieben_sim::runner::{Watcher as _, Writers, Written};
use sieben_sim::scenario::{Happened, Onlooker, Rules, Scenario};
use sieben_sim::timing_diagram::Mark;
use sieben_sim::trace::{Channel, Keep, Memory, Moment, Origin, Recorder, Trace};

use super::running::{self, Looking};
use super::{Campaign, Subject, Way, watching};
use crate::last_change;

/// Scans before the break that are drawn.
const BEFORE: u64 = 40;
/// Signals that are drawn.
const LANES_MAX: usize = 10;

/// How a scenario breaks.
#[derive(Debug)]
pub struct Found {
    /// Where, and in which way.
    pub broken: Break,
    /// What is wrong, in one sentence.
    pub message: String,
    /// The values of what the property says, and who wrote them last.
    pub reasons: Vec<String>,
    /// The scans before the break, with its mark.
    pub diagram: Option<(Trace, Mark)>,
}

/// What a word names in the program, if it has a place there.
fn named(word: &str, subject: &Subject) -> Option<Name> {
    let (symbols, program) = (&subject.build.project.symbols, &subject.build.compiled.program);
    Name::parse(word, symbols, program).ok().filter(|name| !name.is_register() && name.operand().is_some())
}

/// The names of the program in an expression, each once.
fn operands(expression: &str, subject: &Subject) -> Vec<Name> {
    let mut names: Vec<Name> = Vec::new();
    for name in watching::words(expression).into_iter().filter_map(|word| named(word, subject)) {
        if names.iter().all(|known| known.text() != name.text()) {
            names.push(name);
        }
    }
    names
}

/// A variable as the writers know it; one without a place is written by no statement.
fn signal(name: &Name) -> Signal {
    last_change::signal(name).unwrap_or_else(|| Signal {
        name: name.text().to_owned(),
        data_block: None,
        address: Address { area: Area::Local, width: Width::Bit, byte: 0, bit: 0 },
        data_type: DataType::Bool,
    })
}

/// The first look: where it breaks, and in which scans what matters changed last.
struct First<'s> {
    looking: Looking<'s>,
    operands: &'s [Name],
    values: Vec<Option<u64>>,
    since: Vec<Option<u64>>,
}

impl Onlooker for First<'_> {
    fn see(&mut self, happened: Happened<'_>) {
        if let Happened::Scan { cpu, .. } = &happened
            && self.looking.end.is_none()
        {
            let machine = cpu.machine();
            for (index, name) in self.operands.iter().enumerate() {
                let value = name.bits_in(machine, &machine.registers);
                if self.values[index] != value {
                    // What it is before the first scan nothing wrote.
                    let is_first = self.values[index].is_none() && value == Some(0);
                    (self.values[index], self.since[index]) = (value, if is_first { None } else { Some(self.looking.scans) });
                }
            }
        }
        self.looking.see(happened);
    }
    fn may_go_on(&mut self) -> bool {
        self.looking.may_go_on()
    }
}

/// The second look, up to the break.
struct Second<'s> {
    writers: Option<Writers>,
    signals: Vec<Signal>,
    since: &'s [Option<u64>],
    lanes: &'s [Name],
    rows: VecDeque<(Moment, Vec<Sample>)>,
    scan: u64,
    end: u64,
    written: Vec<Option<Written>>,
}

impl Onlooker for Second<'_> {
    fn see(&mut self, happened: Happened<'_>) {
        match happened {
            Happened::Began { cpu } => self.writers = Some(Writers::new(&self.signals, cpu)),
            Happened::Due { cpu, .. } => {
                if let Some(writers) = &mut self.writers {
                    writers.before_scan(cpu);
                }
            }
            Happened::Scan { cpu, time_us, .. } => {
                let moment = Moment { scan: self.scan, time_us };
                self.scan += 1;
                let sample = |name: &Name, cpu: &Cpu| name.sample(cpu).unwrap_or_default();
                self.rows.push_back((moment, self.lanes.iter().map(|name| sample(name, cpu)).collect()));
                if self.rows.len() as u64 > BEFORE {
                    self.rows.pop_front();
                }
                if let Some(writers) = &self.writers {
                    // What comes in from outside is there before the first statement, which has not written it.
                    let from_outside = |signal: &Signal| matches!(signal.address.area, Area::Input | Area::PeripheralInput);
                    let written = writers.written().zip(&self.signals);
                    self.written = written.map(|(written, signal)| written.filter(|_| !from_outside(signal))).collect();
                }
            }
            _ => {}
        }
    }
    fn may_go_on(&mut self) -> bool {
        self.scan <= self.end
    }
    fn tracer(&mut self) -> Option<&mut dyn Tracer> {
        let scan = self.scan;
        self.writers.as_mut().filter(|_| self.since.contains(&Some(scan))).map(|writers| writers as &mut dyn Tracer)
    }
}

/// Runs a scenario on a program of a campaign; how it breaks, if it does. What is around the break is looked at where it is wanted.
pub(super) fn look(
    campaign: &Campaign,
    subject: &Subject,
    scenario: &Scenario,
    wants_diagram: bool,
    may_go_on: &dyn Fn() -> bool,
) -> Option<Found> {
    let spec = &campaign.spec;
    // What all properties and the recording say: which of them breaks is not known yet.
    let mut all: Vec<Name> = Vec::new();
    let expressions = spec.properties.iter().flat_map(|property| std::iter::once(&property.expression).chain(&property.then));
    let recorded = scenario.held().into_iter().flat_map(|name| named(name, subject));
    for name in expressions.flat_map(|expression| operands(&expression.text, subject)).chain(recorded) {
        if all.iter().all(|known| known.text() != name.text()) {
            all.push(name);
        }
    }
    let looking = Looking::new(spec, subject, None, false, may_go_on);
    let mut first = First { looking, operands: &all, values: vec![None; all.len()], since: vec![None; all.len()] };
    go(campaign, subject, scenario, &mut first)?;
    first.looking.ended();
    if first.looking.given_up {
        return None;
    }
    let (verdict, broken, message) = first.looking.end.take()?;
    let differs = first.looking.differs.take().filter(|_| broken.is_none());
    let at = broken.map(|broken| broken.at).or(differs.as_ref().map(|difference| difference.moment)).or(first.looking.last)?;
    let property = broken.and_then(|broken| spec.properties.get(broken.property));
    let (what, message) = match (property, verdict) {
        (Some(property), _) => {
            (property.name.clone(), format!("\"{}\": `{}` {} after {at}", property.name, property.expression.text, property.kind.demand()))
        }
        (None, Verdict::Stop) => ("stop".to_owned(), format!("the CPU went to STOP: {}", message.clone().unwrap_or_default())),
        (None, _) => {
            let what = differs
                .as_ref()
                .map_or_else(|| "recording".to_owned(), |difference| format!("{} as recorded", difference.name.trim_matches('"')));
            (what, message.clone().unwrap_or_default())
        }
    };
    let names: Vec<Name> = match (property, &differs) {
        (Some(property), _) => {
            let texts = std::iter::once(&property.expression).chain(&property.then);
            texts.flat_map(|text| operands(&text.text, subject)).collect()
        }
        (None, Some(difference)) => named(&difference.name, subject).into_iter().collect(),
        (None, None) => Vec::new(),
    };
    let said: Vec<usize> = (0..all.len()).filter(|&index| names.iter().any(|name| name.text() == all[index].text())).collect();
    // A STOP has its place in what it says.
    let place_of_stop = if verdict == Verdict::Stop { Some(message.clone()) } else { None };
    let lanes = lanes(subject, scenario, said.iter().map(|&index| &all[index]));
    let since: Vec<Option<u64>> = said.iter().map(|&index| first.since[index]).collect();
    let signals: Vec<Signal> = said.iter().map(|&index| signal(&all[index])).collect();
    let mut second = Second {
        writers: None,
        signals,
        since: &since,
        lanes: if wants_diagram { &lanes } else { &[] },
        rows: VecDeque::new(),
        scan: 0,
        end: at.scan,
        written: vec![None; said.len()],
    };
    if wants_diagram || since.iter().any(Option::is_some) {
        go(campaign, subject, scenario, &mut second)?;
    }
    let last = second.written.iter().flatten().max_by_key(|written| written.scan);
    let place = last.map(|written| format!("{} statement {}", written.place.block, u64::from(written.place.statement) + 1));
    let reasons = said.iter().zip(&second.written).map(|(&index, written)| {
        let name = &all[index];
        let value = first.values[index].map_or_else(|| "?".to_owned(), |bits| name.show_bits(bits).to_string());
        let area = signal(name).address.area;
        format!("{} = {value}; {}", name.text(), last_change::sentence(&subject.build, name.text().trim_matches('"'), area, *written))
    });
    let reasons = reasons.collect();
    let signature = Signature { what, place: place.or(place_of_stop) };
    let label = match (property, differs) {
        (Some(property), _) => property.name.clone(),
        (None, Some(difference)) => difference.name.trim_matches('"').to_owned(),
        (None, None) => "here".to_owned(),
    };
    let diagram = if wants_diagram { drawn(&second.rows, &lanes, at, label) } else { None };
    Some(Found { broken: Break { signature, at }, message, reasons, diagram })
}

/// Runs it on a fresh CPU.
fn go(campaign: &Campaign, subject: &Subject, scenario: &Scenario, onlooker: &mut dyn Onlooker) -> Option<()> {
    let mut rack = Some(running::rack(campaign, subject, scenario).ok()?);
    let mut fresh = || subject.fresh(Way::Chosen, rack.take().unwrap_or_else(|| sieben_cpu::Rack::simulated(subject.cpu)));
    scenario.run_with(&subject.build.project.symbols, &Rules::default(), &mut fresh, onlooker);
    Some(())
}

/// What is drawn: what the property says, then what the scenario does to the program.
fn lanes<'n>(subject: &Subject, scenario: &Scenario, said: impl Iterator<Item = &'n Name>) -> Vec<Name> {
    let mut lanes: Vec<Name> = said.cloned().collect();
    let (symbols, program) = (&subject.build.project.symbols, &subject.build.compiled.program);
    for (_, name) in scenario.names() {
        if lanes.len() >= LANES_MAX {
            break;
        }
        if let Ok(name) = Name::parse(name, symbols, program)
            && !name.is_register()
            && lanes.iter().all(|known| known.operand() != name.operand())
        {
            lanes.push(name);
        }
    }
    lanes.truncate(LANES_MAX);
    lanes
}

fn drawn(rows: &VecDeque<(Moment, Vec<Sample>)>, lanes: &[Name], at: Moment, label: String) -> Option<(Trace, Mark)> {
    let channels = lanes.iter().map(|name| Channel { name: name.text().trim_matches('"').to_owned(), kind: name.recorded() }).collect();
    let mut recorder = Recorder::of_channels(channels, Keep::All, Origin::default(), Box::new(Memory::default())).ok()?;
    for (moment, values) in rows {
        recorder.put(*moment, values).ok()?;
    }
    Some((recorder.finish().ok()?, Mark { moment: at, label }))
}
