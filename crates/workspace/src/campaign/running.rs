//! The run of one scenario: nothing of it depends on the thread, on the time of day or on the scenarios before it.

use sieben_campaign::disturbed::{Replayed, Width, disturbed};
use sieben_campaign::draws::Stream;
use sieben_campaign::given::Given;
use sieben_campaign::judge::{Broken, Judge};
use sieben_campaign::row::{Row, Verdict};
use sieben_campaign::slots;
use sieben_campaign::spec::{Disturb, PropertyKind, Spec, Value};
use sieben_cpu::{Cpu, OperatingMode, Rack};
use sieben_model::address::Area;
use sieben_sim::names::{Name, Setting};
use sieben_sim::scenario::made::Parts;
use sieben_sim::scenario::property::PropertyLine;
use sieben_sim::scenario::{Difference, Happened, Onlooker, PlantLine, Rules, Scenario};
use sieben_sim::trace::Moment;

use super::targets::{self, Rounding, Target};
use super::{Campaign, Subject, Way};
use crate::controller;
use crate::settings::modules;

impl Subject {
    /// The scenario that is made of what is given.
    pub(super) fn scenario(&self, campaign: &Campaign, given: &Given) -> Result<Scenario, String> {
        match campaign.recording {
            Some(_) => self.scenario_of(campaign, &self.case(campaign, given)?),
            None => Ok(Scenario::made(self.parts(campaign, given)?)),
        }
    }

    /// What a scenario consists of beside its recording.
    pub(super) fn parts(&self, campaign: &Campaign, given: &Given) -> Result<Parts, String> {
        let spec = &campaign.spec;
        let mut set = self.set.clone();
        let mut plants = self.plants(given.seed);
        for (name, index) in self.bits.iter().zip(0..) {
            set.push(
                Setting::new(name.clone(), if given.point.combination >> index & 1 != 0 { "1" } else { "0" }).map_err(|e| e.to_string())?,
            );
        }
        let sweeps = spec.sweep.len();
        for (index, value) in &given.values {
            let rounding = if *index < sweeps { Rounding::Never } else { Rounding::Nearest };
            match &self.targets[*index] {
                Target::Name(name) => set.push(targets::setting(name, value, rounding)?),
                Target::Plant(module, parameter) => {
                    let kind = self.build.project.settings.modules[*module].device.kind;
                    let parameter = &kind.parameters[*parameter];
                    // What is drawn beyond the range of a parameter is its end.
                    let value = match value {
                        Value::Number(number) if rounding == Rounding::Nearest => number.clamp(parameter.least, parameter.most),
                        value => targets::parameter(parameter, value)?,
                    };
                    plants[*module].parameters.push((parameter.name.to_owned(), value));
                }
            }
        }
        let mut at = Vec::new();
        for walk in &given.walks {
            let Target::Name(name) = &self.targets[walk.index] else { continue };
            for (time, value) in &walk.changes {
                at.push((*time, targets::setting(name, value, Rounding::Nearest)?));
            }
        }
        Ok(Parts {
            cycle_us: self.cycle_us,
            scans: self.scans,
            plants,
            set,
            at,
            faults: given.faults.iter().map(|(_, fault)| fault.clone()).collect(),
        })
    }

    /// The inputs of a recording, each as it comes in a scenario.
    pub(super) fn replayed(&self, recording: &Scenario, spec: &Spec, given: &Given) -> Vec<Replayed> {
        let width = |name: &str| {
            let parsed = Name::parse(name, &self.build.project.symbols, &self.build.compiled.program);
            match parsed.map_or(16, |name| name.item().width()) {
                1 => Width::Bit,
                bits => Width::Word(bits),
            }
        };
        disturbed(&recording.timed(), spec.disturb.as_ref().unwrap_or(&Disturb::default()), given.seed, &width)
    }

    /// The plants, each with the seed that it has in the scenario.
    fn plants(&self, seed: u64) -> Vec<PlantLine> {
        let modules = &self.build.project.settings.modules;
        let mut lines: Vec<PlantLine> = modules
            .iter()
            .map(|module| PlantLine {
                module: module.device.name.clone(),
                // Files of projects have signed numbers.
                seed: Some(Stream::new(seed, &format!("plant {}", module.device.name)).next_u64() >> 1),
                parameters: Vec::new(),
            })
            .collect();
        for &(module, parameter, value) in &self.fixed {
            lines[module].parameters.push((modules[module].device.kind.parameters[parameter].name.to_owned(), value));
        }
        lines
    }

    /// A CPU in STOP with the plants of a scenario.
    pub(super) fn fresh(&self, way: Way, rack: Rack) -> Cpu {
        Cpu::new(self.loaded(way).clone(), rack, self.settings.clone())
    }
}

/// What has to hold of one run, as lines of its scenario.
pub(super) fn properties(spec: &Spec) -> Vec<PropertyLine> {
    let of_one_run = spec.properties.iter().filter(|property| !matches!(property.kind, PropertyKind::Sometimes | PropertyKind::Same));
    of_one_run
        .map(|property| PropertyLine {
            line: 0,
            kind: property.kind,
            name: property.name.clone(),
            expression: property.expression.text.clone(),
            then: property.then.as_ref().map(|then| then.text.clone()),
            within_us: property.within_us,
        })
        .collect()
}

/// The row of a scenario that nothing has come of yet.
fn blank(spec: &Spec, given: &Given) -> Row {
    Row {
        scenario: given.number,
        seed: given.seed,
        verdict: Verdict::Pass,
        property: None,
        at: None,
        scans: 0,
        virtual_us: 0,
        margin: None,
        trace_hash: 0,
        parameters: given.values.iter().map(|(_, value)| value.clone()).collect(),
        faults: (0..spec.faults.len())
            .map(|index| given.faults.iter().find(|(row, _)| *row == index).map(|(_, fault)| fault.how()))
            .collect(),
        measures: vec![None; spec.measures.len()],
        came: vec![false; spec.properties.len()],
        message: None,
    }
}

/// The row of a scenario that could not be run.
pub(super) fn not_run(campaign: &Campaign, given: &Given, message: String) -> Row {
    Row { verdict: Verdict::Error, message: Some(message), ..blank(&campaign.spec, given) }
}

/// Runs a scenario on all programs of a campaign.
pub(super) fn run(campaign: &Campaign, given: &Given, way: Way, may_go_on: &dyn Fn() -> bool) -> Result<Row, u64> {
    let spec = &campaign.spec;
    let mut row = blank(spec, given);
    let mut kept = None;
    for (index, subject) in campaign.programs.iter().enumerate() {
        let mut looking = Looking::new(spec, subject, kept.take(), campaign.programs.len() > 1, may_go_on);
        match scenario(campaign, subject, given) {
            Ok((scenario, rack)) => {
                let mut rack = Some(rack);
                // A scenario that code makes has one CPU.
                let mut fresh = || subject.fresh(way, rack.take().unwrap_or_else(|| Rack::simulated(subject.cpu)));
                scenario.run_with(&subject.build.project.symbols, &Rules::default(), &mut fresh, &mut looking);
                looking.ended();
            }
            Err(message) => looking.end = Some((Verdict::Error, None, Some(message))),
        }
        if looking.given_up {
            return Err(looking.scans);
        }
        row.margin = nearer(row.margin, looking.margin);
        if index == 0 {
            row.measures = looking.judge.measured();
            row.came = looking.judge.came().to_vec();
            (row.scans, row.virtual_us, row.trace_hash) = (looking.scans, looking.last.map_or(0, |scan| scan.time_us), looking.hash);
        }
        if let Some((verdict, broken, message)) = looking.end {
            row.verdict = verdict;
            row.property = broken.map(|broken| broken.property);
            let differs = looking.differs.as_ref().map(|difference| difference.moment);
            row.at = broken.map(|broken| broken.at).or(differs).or(looking.last);
            row.message = match campaign.programs.len() {
                1 => message,
                _ => Some(format!("in `{}`{}", subject.path, message.map_or(String::new(), |message| format!(": {message}")))),
            };
            return Ok(row);
        }
        kept = looking.kept.take();
    }
    Ok(row)
}

/// The less of two distances to a break.
fn nearer(one: Option<f64>, other: Option<f64>) -> Option<f64> {
    one.into_iter().chain(other).min_by(f64::total_cmp)
}

/// The scenario with the modules that it runs with.
fn scenario(campaign: &Campaign, subject: &Subject, given: &Given) -> Result<(Scenario, Rack), String> {
    let scenario = subject.scenario(campaign, given)?;
    let rack = rack(campaign, subject, &scenario)?;
    Ok((scenario, rack))
}

/// The modules that a scenario runs with.
pub(super) fn rack(campaign: &Campaign, subject: &Subject, scenario: &Scenario) -> Result<Rack, String> {
    if campaign.recording.is_some() {
        return Ok(Rack::simulated(subject.cpu));
    }
    let modules = modules::with_plants(&subject.build.project.settings.modules, scenario.plants())?;
    Ok(modules::rack(&modules, subject.cpu))
}

/// Whether it may go on is asked every so many scans.
const ASKED_EVERY: u64 = 1_000;

/// How a scenario ended, with the property that did not hold and what is to be said.
pub(super) type End = (Verdict, Option<Broken>, Option<String>);

/// Looks on while a scenario runs.
pub(super) struct Looking<'s> {
    subject: &'s Subject,
    judge: Judge<'s>,
    values: Vec<f64>,
    outputs: Vec<u8>,
    hash: u64,
    /// The least distance of a property to its break.
    margin: Option<f64>,
    pub(super) scans: u64,
    pub(super) last: Option<Moment>,
    pub(super) end: Option<End>,
    may_go_on: &'s dyn Fn() -> bool,
    pub(super) given_up: bool,
    /// What differs from the recording first.
    pub(super) differs: Option<Difference>,
    /// What the program before this one came to, scan by scan, and what this one does.
    before: Option<Vec<f64>>,
    kept: Option<Vec<f64>>,
    same: Vec<(usize, usize)>,
}

impl<'s> Looking<'s> {
    pub(super) fn new(
        spec: &'s Spec,
        subject: &'s Subject,
        before: Option<Vec<f64>>,
        keeps: bool,
        may_go_on: &'s dyn Fn() -> bool,
    ) -> Self {
        let slots = slots::of_properties(spec).into_iter().enumerate();
        let is_same = |(index, _): &(usize, usize)| spec.properties.get(*index).is_some_and(|property| property.kind == PropertyKind::Same);
        let same: Vec<(usize, usize)> = slots.filter(is_same).collect();
        Self {
            subject,
            judge: Judge::new(spec, subject.cycle_us),
            values: Vec::new(),
            outputs: Vec::new(),
            hash: 0,
            margin: None,
            scans: 0,
            last: None,
            end: None,
            may_go_on,
            given_up: false,
            differs: None,
            before,
            kept: (keeps && !same.is_empty()).then(Vec::new),
            same,
        }
    }

    fn scanned(&mut self, cpu: &mut Cpu, at_us: u64) {
        let scan = Moment { scan: self.scans, time_us: at_us };
        self.scans += 1;
        self.last = Some(scan);
        if cpu.mode() == OperatingMode::Stop {
            let message = cpu.stop_cause().map(|cause| controller::named(&self.subject.build, &cause.text, cause.place));
            self.end = Some((Verdict::Stop, None, message));
            return;
        }
        self.hash_outputs(cpu, scan.scan);
        if !self.subject.watching.look(cpu, &mut self.values) {
            let message =
                "an expression of the campaign cannot be computed here, such as an element beyond the end of its array".to_owned();
            self.end = Some((Verdict::Error, None, Some(message)));
            return;
        }
        self.margin = nearer(self.margin, self.subject.watching.distance(&self.values));
        if let Some(broken) = self.judge.scanned(scan, &self.values).or_else(|| self.compared(scan)) {
            self.end = Some((Verdict::Fail, Some(broken), None));
        }
    }

    /// What has to be the same as in the program before, and is not.
    fn compared(&mut self, scan: Moment) -> Option<Broken> {
        let begin = self.same.len() * scan.scan as usize;
        let differs = self.same.iter().enumerate().find(|&(place, &(_, slot))| {
            let before = self.before.as_ref().and_then(|before| before.get(begin + place));
            // What is no number is the same as itself.
            before.is_some_and(|before| before.to_bits() != self.values[slot].to_bits() && *before != self.values[slot])
        });
        if let Some(kept) = &mut self.kept {
            kept.extend(self.same.iter().map(|&(_, slot)| self.values[slot]));
        }
        differs.map(|(_, &(property, _))| Broken { property, at: scan })
    }

    /// Takes the outputs that changed into the hash, each with its scan.
    fn hash_outputs(&mut self, cpu: &Cpu, scan: u64) {
        let outputs = cpu.machine().memory.area(Area::Output);
        if self.outputs == outputs {
            return;
        }
        if self.outputs.is_empty() {
            self.outputs = vec![0; outputs.len()];
        }
        for (byte, (before, now)) in (0_u64..).zip(self.outputs.iter().zip(outputs)).filter(|(_, (before, now))| before != now) {
            let changed = byte << 16 | u64::from(*before) << 8 | u64::from(*now);
            self.hash = sieben_campaign::draws::mix(self.hash ^ sieben_campaign::draws::mix(scan) ^ changed);
        }
        self.outputs.copy_from_slice(outputs);
    }

    pub(super) fn ended(&mut self) {
        if self.end.is_none()
            && let Some(broken) = self.judge.ended(&self.values)
        {
            self.end = Some((Verdict::Fail, Some(broken), None));
        }
    }
}

impl Onlooker for Looking<'_> {
    fn see(&mut self, happened: Happened<'_>) {
        match happened {
            Happened::Scan { cpu, time_us, .. } if self.end.is_none() => self.scanned(cpu, time_us),
            Happened::Differs(difference) if self.differs.is_none() => self.differs = Some(difference.clone()),
            Happened::Failed(error) if self.end.is_none() => {
                let verdict = if self.differs.is_some() { Verdict::Fail } else { Verdict::Error };
                self.end = Some((verdict, None, Some(error.message.clone())));
            }
            _ => {}
        }
    }

    fn may_go_on(&mut self) -> bool {
        // To ask takes longer than many a scan.
        if self.scans % ASKED_EVERY == ASKED_EVERY - 1 && !(self.may_go_on)() {
            self.given_up = true;
        }
        self.end.is_none() && !self.given_up
    }
}
