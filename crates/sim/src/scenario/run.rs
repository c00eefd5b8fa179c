//! A CPU on its way through a scenario.

use std::cell::RefCell;
use std::collections::{HashMap, VecDeque};

use sieben_cpu::retain::Adoption;
use sieben_cpu::{Cpu, OperatingMode, Restart};
use sieben_model::symbols::SymbolTable;

use super::held::{Difference, Held, Holding};
use super::spelling::{self, is_input};
use super::{Assignment, Assignments, Command, Deed, Happened, Onlooker, Rules, SCANS_MAX, Scenario, ScenarioError};
use crate::names::{Name, NameError, Sample, Setting, Shown};
use crate::trace::Moment;
use crate::wrap;

/// A CPU on its way through a scenario.
pub(super) struct Run<'a, 'o> {
    cpu: Cpu,
    rules: &'a Rules,
    symbols: &'a SymbolTable,
    cycle_us: u64,
    /// When the last scan began.
    last_us: Option<u64>,
    /// When the next scan begins.
    next_us: u64,
    /// Changes to come in the order of their times, with the line that orders them.
    changes: VecDeque<(u64, usize, Assignments)>,
    /// The line that is carried out.
    pub(super) line: usize,
    stop_expected: bool,
    pub(super) failures: Vec<ScenarioError>,
    onlooker: &'a RefCell<&'o mut (dyn Onlooker + 'o)>,
    /// Scans that were run.
    scans: u64,
    /// What is held against every scan.
    held: Vec<Held>,
    /// Names that were read before.
    names: HashMap<String, Name>,
    given_up: bool,
}

impl<'a, 'o> Run<'a, 'o> {
    pub(super) fn start(
        cpu: Cpu,
        scenario: &Scenario,
        symbols: &'a SymbolTable,
        rules: &'a Rules,
        onlooker: &'a RefCell<&'o mut (dyn Onlooker + 'o)>,
    ) -> Self {
        let mut run = Self {
            cpu,
            rules,
            symbols,
            cycle_us: scenario.cycle_us(),
            last_us: None,
            next_us: 0,
            changes: VecDeque::new(),
            line: 1,
            stop_expected: false,
            failures: Vec::new(),
            onlooker,
            scans: 0,
            held: Vec::new(),
            names: HashMap::new(),
            given_up: false,
        };
        run.set_silently(&scenario.start_with);
        run.onlooker.borrow_mut().see(Happened::Began { cpu: &mut run.cpu });
        run.tell_assignments("start with", &scenario.start_with);
        let mut onlooker = run.onlooker.borrow_mut();
        run.cpu.restart_with(scenario.start(), &mut || 0, onlooker.tracer());
        drop(onlooker);
        run
    }

    /// Whether who looks on has ended the run.
    pub(super) fn is_given_up(&self) -> bool {
        self.given_up
    }

    /// What a name of the scenario means in this program.
    fn setting(&mut self, assignment: &Assignment) -> Result<Setting, NameError> {
        match &assignment.meant {
            Some(setting) => Ok(setting.clone()),
            None => Setting::new(self.name(&assignment.name)?, &assignment.value),
        }
    }

    fn name(&mut self, text: &str) -> Result<Name, NameError> {
        if let Some(name) = self.names.get(text) {
            return Ok(name.clone());
        }
        let name = Name::parse(self.rules.name(text), self.symbols, self.cpu.program())?;
        self.names.insert(text.to_owned(), name.clone());
        Ok(name)
    }

    fn tell(&self, line: &str) {
        self.onlooker.borrow_mut().see(Happened::Did(Deed::Line(line)));
    }

    /// Tells of what is set, without inputs: those come from modules.
    fn tell_assignments(&mut self, word: &str, assignments: &Assignments) {
        let others: Assignments =
            assignments.iter().filter(|one| !self.name(&one.name).is_ok_and(|name| is_input(&name))).cloned().collect();
        if !others.is_empty() {
            self.tell(&format!("{word}{}", spelling::assignments(&others)));
        }
    }

    fn fail(&mut self, message: impl Into<String>) {
        let error = ScenarioError { line: self.line, message: message.into() };
        self.onlooker.borrow_mut().see(Happened::Failed(&error));
        self.failures.push(error);
    }

    pub(super) fn command(&mut self, command: &Command) {
        match command {
            Command::Set(assignments) => self.set(assignments),
            Command::Force(assignments) => self.force(assignments),
            Command::Always(_) | Command::Expect(..) | Command::ExpectMode(_) if self.rules.expects_nothing => {}
            Command::ExpectStop(_) if self.rules.expects_nothing => self.stop_expected = true,
            Command::Always(assignments) => self.always(assignments),
            Command::Unforce(None) => {
                self.tell("unforce");
                self.cpu.unforce_all();
            }
            Command::Unforce(Some(name)) => {
                self.tell(&format!("unforce {name}"));
                let done = self.name(name).and_then(|name| name.unforce(&mut self.cpu));
                done.unwrap_or_else(|error| self.fail(error.to_string()));
            }
            Command::Scan(count) => {
                for _ in 0..*count {
                    self.scan();
                    if self.given_up {
                        break;
                    }
                }
            }
            Command::ScanUntil(end) => {
                if self.reachable(*end) {
                    while self.next_us <= *end && !self.given_up {
                        self.scan();
                    }
                }
            }
            Command::ScanAt(time) => match self.last_us {
                Some(last) if *time < last => self.fail(format!("the last scan was already at {}", spelling::time(last))),
                _ => {
                    self.next_us = *time;
                    self.scan();
                }
            },
            Command::At(time, assignments) => match self.last_us {
                Some(last) if *time <= last => {
                    self.fail(format!(
                        "the last scan was already at {}; write `at` before the scan that shall see it",
                        spelling::time(last)
                    ));
                }
                _ => {
                    self.tell_assignments(&format!("at {}", spelling::time(*time)), assignments);
                    let place = self.changes.partition_point(|change| change.0 <= *time);
                    self.changes.insert(place, (*time, self.line, assignments.clone()));
                }
            },
            Command::InterruptAt(time, interrupt) => match self.last_us {
                Some(last) if *time <= last => {
                    self.fail(format!(
                        "the last scan was already at {}; write `at` before the scan that shall see it",
                        spelling::time(last)
                    ));
                }
                _ => self.cpu.rack_mut().raise_at(*time, *interrupt),
            },
            Command::Interrupt(interrupt, None) => {
                self.tell(&format!("interrupt {}", spelling::interrupt(interrupt)));
                self.cpu.raise(*interrupt);
            }
            Command::Interrupt(interrupt, Some(point)) => {
                self.tell(&format!("interrupt {} at safe point {point}", spelling::interrupt(interrupt)));
                self.cpu.raise_at_safe_point(*point, *interrupt);
            }
            Command::Module(byte, answers) => {
                let line = format!("module {byte} {}", if *answers { "answers" } else { "fails" });
                self.onlooker.borrow_mut().see(Happened::Did(Deed::Module(&line)));
                if !self.cpu.rack_mut().set_answering(*byte, *answers) {
                    self.fail(format!("no module has the byte {byte}"));
                }
            }
            Command::Fault(_) | Command::Mend(_) => {
                self.onlooker.borrow_mut().see(Happened::Did(Deed::Plant));
                self.plant(command);
            }
            Command::Restart(restart) => {
                self.tell(&format!("restart {}", restart.word()));
                self.restart(*restart);
            }
            Command::Expect(assignments, within) => self.expect(assignments, *within),
            Command::ExpectStop(event) => self.expect_stop(*event),
            Command::ExpectMode(mode) => {
                self.stop_expected |= *mode == OperatingMode::Stop;
                if self.cpu.mode() != *mode {
                    let got = self.cpu.mode();
                    self.fail(format!("expected the mode {mode}, got {got}{}", self.why_stopped()));
                }
            }
            // These need more than one CPU.
            Command::PowerFailure | Command::Table { .. } => {}
        }
    }

    fn plant(&mut self, command: &Command) {
        let done = match command {
            Command::Fault(fault) => wrap::inject(self.cpu.rack_mut(), fault),
            Command::Mend(name) => wrap::mend(self.cpu.rack_mut(), name),
            _ => Ok(()),
        };
        done.unwrap_or_else(|message| self.fail(message));
    }

    fn restart(&mut self, restart: Restart) {
        let now_us = self.cpu.time_us();
        let mut onlooker = self.onlooker.borrow_mut();
        self.cpu.restart_with(restart, &mut || now_us, onlooker.tracer());
        drop(onlooker);
        self.stop_expected = false;
    }

    /// From the next scan on these are held against every scan.
    fn always(&mut self, assignments: &Assignments) {
        for Assignment { name: text, value, .. } in
            assignments.iter().filter(|one| !self.rules.is_ignored(&one.name)).cloned().collect::<Vec<_>>()
        {
            let line = self.line;
            let known = self.held.iter().position(|held| held.text() == text);
            let index = match (known, self.name(&text)) {
                (Some(index), _) => index,
                (None, Ok(name)) => {
                    self.held.push(Held::new(&text, name, self.rules));
                    self.held.len() - 1
                }
                (None, Err(error)) => {
                    self.fail(error.to_string());
                    continue;
                }
            };
            if let Err(error) = self.held[index].expect(line, &value) {
                self.fail(error.to_string());
            }
        }
    }

    /// Says of a name that it is not what it always should be: the first time, with both values.
    fn differs(&mut self, index: usize, difference: &Difference) {
        let held = &self.held[index];
        // A row of scans that differ is one difference.
        if held.differs > 1 {
            return;
        }
        let (expected, actual) = (held.show(&difference.expected), held.show(&difference.actual));
        let moment = difference.moment;
        let of = difference.name.trim_matches('"');
        let here =
            if difference.place.text().trim_matches('"') == of { String::new() } else { format!(", here `{}`,", difference.place.text()) };
        let message = match difference.missed {
            true => format!("`{of}`{here} should come to {expected} after {moment}, and did not"),
            false => format!("`{of}`{here} should be {expected} after {moment}, and is {actual}"),
        };
        let line = std::mem::replace(&mut self.line, difference.line);
        self.onlooker.borrow_mut().see(Happened::Differs(difference));
        self.fail(message);
        self.line = line;
    }

    /// The retentive data of the CPU goes to a fresh one, which starts at the time that it is.
    pub(super) fn power_failure(&mut self, mut fresh: Cpu) {
        self.onlooker.borrow_mut().see(Happened::Did(Deed::PowerFailure));
        let Some(image) = self.cpu.retain_image().cloned() else {
            return self.fail("a scan is not at its end, and only whole scans are kept");
        };
        if let Err(refusal) = fresh.restore(&image, Adoption::SameProgram) {
            return self.fail(format!("the retentive data is not taken back: {refusal}"));
        }
        let now_us = self.last_us.unwrap_or(0);
        fresh.restart_with(Restart::Warm, &mut || now_us, None);
        self.cpu = fresh;
        self.stop_expected = false;
    }

    pub(super) fn set(&mut self, assignments: &Assignments) {
        self.tell_assignments("set", assignments);
        self.set_silently(assignments);
    }

    fn set_silently(&mut self, assignments: &Assignments) {
        for assignment in assignments {
            let done = self.setting(assignment).and_then(|setting| setting.apply(&mut self.cpu));
            if let Err(error) = done {
                self.fail(error.to_string());
            }
        }
    }

    fn force(&mut self, assignments: &Assignments) {
        self.tell(&format!("force{}", spelling::assignments(assignments)));
        for assignment in assignments {
            let done = self.setting(assignment).and_then(|setting| setting.name.force(&mut self.cpu, &setting.value));
            if let Err(error) = done {
                self.fail(error.to_string());
            }
        }
    }

    /// Whether a time can be reached with a bearable number of scans; says so if not.
    fn reachable(&mut self, end: u64) -> bool {
        let bearable = end.saturating_sub(self.next_us) / self.cycle_us <= SCANS_MAX && end < u64::MAX;
        if !bearable {
            self.fail(format!("that is more than {SCANS_MAX} scans; choose a longer cycle"));
        }
        bearable
    }

    pub(super) fn scan(&mut self) {
        let now = self.next_us;
        self.given_up |= !self.onlooker.borrow_mut().may_go_on();
        // What always is has nothing to say about a CPU that stands still.
        self.given_up |= !self.held.is_empty() && !self.check_stop();
        if self.given_up {
            return;
        }
        let line = self.line;
        while let Some((time, line, assignments)) = self.changes.pop_front_if(|change| change.0 <= now) {
            self.line = line;
            for assignment in &assignments {
                let done = self.setting(assignment).and_then(|setting| setting.name.set_at(&mut self.cpu, &setting.value, time));
                if let Err(error) = done {
                    self.fail(error.to_string());
                }
            }
        }
        self.line = line;
        let mut onlooker = self.onlooker.borrow_mut();
        onlooker.see(Happened::Due { cpu: &mut self.cpu, time_us: now });
        let report = match onlooker.tracer() {
            Some(tracer) => self.cpu.scan_traced(now, tracer),
            None => self.cpu.scan(now),
        };
        onlooker.see(Happened::Scan { cpu: &mut self.cpu, time_us: now, held: Holding(&self.held) });
        drop(onlooker);
        let moment = Moment { scan: self.scans, time_us: now };
        self.scans += 1;
        for index in 0..self.held.len() {
            if let Some(difference) = self.held[index].scanned(&self.cpu, moment) {
                self.differs(index, &difference);
            }
        }
        if report.events_missed > 0 {
            let passed = report.safe_points;
            self.fail(format!("the scan passed only {passed} safe points (backward jumps and block entries); the interrupt never came"));
        }
        self.last_us = Some(now);
        self.next_us = now.saturating_add(self.cycle_us);
    }

    pub(super) fn expect(&mut self, assignments: &Assignments, within: Option<u64>) {
        let deadline = self.last_us.unwrap_or(self.next_us).saturating_add(within.unwrap_or(0));
        if within.is_some() && !self.reachable(deadline) {
            return;
        }
        loop {
            let wrong: Vec<(String, Option<Difference>)> =
                assignments.iter().filter_map(|one| self.is_not(&one.name, &one.value)).collect();
            if wrong.is_empty() {
                self.check_stop();
                return;
            }
            if self.given_up {
                return;
            }
            if within.is_none() || self.next_us > deadline {
                let when = self
                    .last_us
                    .map_or_else(|| "before the first scan".to_owned(), |last| format!("after the scan at {}", spelling::time(last)));
                let (messages, differences): (Vec<String>, Vec<Option<Difference>>) = wrong.into_iter().unzip();
                for difference in differences.iter().flatten() {
                    self.onlooker.borrow_mut().see(Happened::Differs(difference));
                }
                self.fail(format!("{} {when}{}", messages.join(", "), self.why_stopped()));
                self.stop_expected = true;
                return;
            }
            self.scan();
        }
    }

    /// How a value differs from the expected one.
    fn is_not(&mut self, name: &str, expected: &str) -> Option<(String, Option<Difference>)> {
        let compared = self.name(name).and_then(|parsed| match parsed.holds(&self.cpu, expected)? {
            true => Ok(None),
            false => Ok(Some((format!("expected {name} = {expected}, got {}", readable(&parsed, expected, &self.cpu)?), parsed))),
        });
        match compared {
            Ok(None) => None,
            Ok(Some((message, parsed))) => {
                let difference = self.last_us.map(|time_us| Difference {
                    name: name.to_owned(),
                    line: self.line,
                    moment: Moment { scan: self.scans.saturating_sub(1), time_us },
                    expected: parsed.expected(expected).map_or_else(|_| Sample::text(expected), |value| Sample::of(&value)),
                    actual: parsed.sample(&self.cpu).unwrap_or_default(),
                    since: None,
                    missed: false,
                    place: parsed,
                });
                Some((message, difference))
            }
            Err(error) => Some((error.to_string(), None)),
        }
    }

    fn expect_stop(&mut self, event: u16) {
        self.stop_expected = true;
        match self.cpu.stop_cause() {
            Some(cause) if cause.first_event == event || cause.event == event => {}
            Some(cause) => {
                let got = cause.first_event;
                self.fail(format!("expected STOP with 16#{event:04X}, got 16#{got:04X}{}", self.why_stopped()));
            }
            None => self.fail(format!("expected STOP with 16#{event:04X}, but the CPU is in {}", self.cpu.mode())),
        }
    }

    /// A STOP that no line expects is a failure; `false` then.
    fn check_stop(&mut self) -> bool {
        let surprise = self.cpu.mode() == OperatingMode::Stop && !self.stop_expected;
        if surprise {
            self.stop_expected = true;
            let moment = |time_us| Moment { scan: self.scans.saturating_sub(1), time_us };
            let when = self.last_us.map_or_else(String::new, |last| format!(", after {}", moment(last)));
            self.fail(format!("{}{}", self.why_stopped().trim_start_matches("; "), if self.held.is_empty() { "" } else { &when }));
        }
        !surprise
    }

    fn why_stopped(&self) -> String {
        match self.cpu.stop_cause() {
            Some(cause) if self.cpu.mode() == OperatingMode::Stop => {
                format!("; the CPU is in STOP, event 16#{:04X}: {}", cause.first_event, cause.text)
            }
            _ => String::new(),
        }
    }

    pub(super) fn finish(&mut self) {
        for index in 0..self.held.len() {
            for difference in self.held[index].finish() {
                self.differs(index, &difference);
            }
        }
        self.check_stop();
        let changes = std::mem::take(&mut self.changes);
        let given_up = self.given_up;
        for (time, line, _) in changes.into_iter().filter(|_| !given_up) {
            self.line = line;
            self.fail(format!("no scan came at {} or later", spelling::time(time)));
        }
    }
}

/// A value as a message shows it, beside what was expected of it: a timer as a time, with its count where one was expected.
fn readable(name: &Name, expected: &str, cpu: &Cpu) -> Result<String, NameError> {
    let shown = name.read(cpu)?;
    if !name.is_timer() || !matches!(shown, Shown::Number(_)) {
        return Ok(shown.readable());
    }
    let time = name.clone().readable().read(cpu)?.readable();
    Ok(if expected.contains('#') { time } else { format!("{shown} ({time})") })
}
