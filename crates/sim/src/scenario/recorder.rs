//! Writes a run down as a scenario: the inputs that came from modules, with their times, and behind every scan the outputs that the program had set.
//!
//! A run in virtual time is determined by its program, by the times of its scans and by what comes from outside. The recorder listens to the modules, copies what is done
//! to the CPU from outside, and writes an `always` line whenever an output has another value; whoever runs the scenario has the same run again, without the modules.
//! The text grows scan by scan and is taken piece by piece, each of which ends with a whole scan.

use std::collections::BTreeMap;
use std::fmt::Write;

use sieben_cpu::listening::{Heard, Said, Unrepeatable};
use sieben_cpu::{Cpu, OperatingMode};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::mnemonics::Mnemonics;

use super::spelling;
use super::{Deed, Happened, ImageErrors, Scenario};
use crate::names::{Name, Sample};

/// The first line of a recording, for whoever opens it.
const HEAD: &str =
    "// What went into a program and what came out of it. `sieben test PROGRAM --tests THIS` holds a program against it, scan by scan.\n";

/// Bits of a byte that change in one scan are written one by one up to so many; more are written as a byte.
const BITS_MAX: u32 = 2;

/// What a recording is of, and what it looks at.
#[derive(Clone, Debug, Default)]
pub struct Subject {
    /// [`crate::trace::identity`] of the sources.
    pub program: u64,
    /// What the program is called.
    pub title: String,
    /// The CPU type, where the project does not say it.
    pub cpu: Option<&'static str>,
    /// What inputs are called; one that stands earlier is preferred where several have the same bits.
    pub inputs: Vec<Name>,
    /// What is held against every scan. Outputs that are not among them are held from their first change on.
    pub outputs: Vec<Name>,
    /// Whether other outputs are no matter.
    pub chosen: bool,
    /// Whether the rack has modules with a life of their own.
    pub plants: bool,
    /// The language of addresses without a name.
    pub mnemonics: Mnemonics,
}

/// Something whose value is held.
struct Output {
    name: Name,
    spelled: String,
    last: Option<Sample>,
}

/// Writes a run down.
pub struct Recorder {
    subject: Subject,
    /// What the settings of the scenario are, as lines.
    settings: String,
    text: String,
    input_bytes: Vec<u8>,
    outputs: Vec<Output>,
    /// Output bytes behind the last scan: the process image, and behind its end what was put out directly.
    output_bytes: Vec<u8>,
    /// The bits of them that a name has.
    covered: Vec<u8>,
    begun: bool,
    cycle_us: u64,
    last_us: Option<u64>,
    next_us: u64,
    /// Scans that changed nothing and are not written yet.
    waiting: u64,
    scans: u64,
    stopped: bool,
    trouble: Option<String>,
}

impl Recorder {
    /// A recorder of a run that this scenario describes.
    pub fn new(subject: Subject, scenario: &Scenario) -> Self {
        let outputs: Vec<Output> = subject.outputs.iter().map(output).collect();
        Self {
            subject,
            settings: scenario.settings_lines(),
            text: String::new(),
            input_bytes: Vec::new(),
            outputs,
            output_bytes: Vec::new(),
            covered: Vec::new(),
            begun: false,
            cycle_us: scenario.cycle_us(),
            last_us: None,
            next_us: 0,
            waiting: 0,
            scans: 0,
            stopped: false,
            trouble: None,
        }
    }

    /// Bytes that wait to be taken.
    pub fn waiting(&self) -> usize {
        self.text.len()
    }

    /// Scans that were recorded.
    pub fn scans(&self) -> u64 {
        self.scans
    }

    /// What is held against every scan.
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// When the next scan would begin, in microseconds: as long as the run was.
    pub fn time_us(&self) -> u64 {
        if self.scans == 0 { 0 } else { self.next_us }
    }

    /// Why the run cannot be recorded any further.
    pub fn trouble(&self) -> Option<&str> {
        self.trouble.as_deref()
    }

    /// Takes note of what happens.
    pub fn see(&mut self, happened: Happened<'_>) {
        match happened {
            Happened::Began { cpu } => self.began(cpu),
            Happened::Did(deed) => self.did(deed),
            Happened::Scan { cpu, time_us, .. } => self.scan(cpu, time_us),
            Happened::Due { .. } | Happened::Differs(_) | Happened::Failed(_) => {}
        }
    }

    /// What was written since it was taken last. It ends with a whole scan, or with something that was done behind one.
    pub fn take(&mut self) -> String {
        self.flush();
        std::mem::take(&mut self.text)
    }

    /// The end of the recording.
    pub fn finish(mut self) -> String {
        let end = self.scans;
        let mut text = self.take();
        line(&mut text, format_args!("end {end}"));
        text
    }

    fn began(&mut self, cpu: &mut Cpu) {
        if std::mem::replace(&mut self.begun, true) {
            self.trouble = Some("it has several runs, and a recording is of one: a `table` begins anew with every row".to_owned());
            return;
        }
        self.text.push_str(HEAD);
        let title = self.subject.title.replace(['"', '\n', '\r'], "'");
        line(&mut self.text, format_args!("recorded {:016X} \"{title}\"", self.subject.program));
        if let Some(cpu) = self.subject.cpu {
            line(&mut self.text, format_args!("cpu {cpu}"));
        }
        self.text.push_str(&self.settings);
        let bytes = cpu.rack().outputs().len();
        (self.input_bytes, self.output_bytes, self.covered) = (vec![0; bytes], vec![0; bytes], vec![0; bytes]);
        let names: Vec<Name> = self.outputs.iter().map(|output| output.name.clone()).collect();
        names.iter().for_each(|name| self.cover(name));
        cpu.rack_mut().listen();
        let heard = cpu.rack_mut().take_heard();
        let there = self.inputs(&heard, cpu);
        if !there.is_empty() {
            line(&mut self.text, format_args!("start with{there}"));
        }
    }

    fn did(&mut self, deed: Deed<'_>) {
        let refusal = match deed {
            Deed::Line(did) => {
                self.flush();
                // A CPU that was started may go to STOP again.
                self.stopped &= !did.starts_with("restart") && did != "power failure";
                line(&mut self.text, format_args!("{did}"));
                return;
            }
            // What it does to the inputs is heard.
            Deed::Plant => return,
            Deed::Module(did) if !self.subject.plants => return self.did(Deed::Line(did)),
            Deed::PowerFailure if !self.subject.plants => {
                // The inputs of a fresh rack are 0.
                self.input_bytes.fill(0);
                return self.did(Deed::Line("power failure"));
            }
            Deed::Module(did) => format!("`{did}` is about a module of the project"),
            Deed::PowerFailure => "`power failure` lets the modules of the project begin anew".to_owned(),
        };
        self.trouble.get_or_insert(format!("{refusal}, and what replays a recording has other modules"));
    }

    fn scan(&mut self, cpu: &mut Cpu, time_us: u64) {
        if self.trouble.is_some() {
            return;
        }
        if let Some((at_us, why)) = cpu.rack().unrepeatable() {
            let at = spelling::time(at_us);
            self.trouble = Some(match why {
                Unrepeatable::Byte(byte) => format!("a module gave `PIB {byte}` two values at {at}, and a recording has one for each time"),
                Unrepeatable::AlarmInside => format!("a module raised an interrupt inside of the statement that wrote to it, at {at}"),
            });
            return;
        }
        if !cpu.rack().is_listening() {
            // Behind a power failure the rack is a fresh one.
            cpu.rack_mut().listen();
        }
        let mut lines = self.heard(cpu, time_us);
        let held = self.changed(cpu);
        if !held.is_empty() {
            line(&mut lines, format_args!("always{held}"));
        }
        let in_time = time_us == self.next_us;
        if !lines.is_empty() || !in_time {
            self.flush();
            self.text.push_str(&lines);
        }
        if in_time {
            self.waiting += 1;
        } else {
            line(&mut self.text, format_args!("scan at {}", spelling::time(time_us)));
        }
        self.scans += 1;
        self.last_us = Some(time_us);
        self.next_us = time_us.saturating_add(self.cycle_us);
        let stopped = cpu.mode() == OperatingMode::Stop;
        if stopped && !self.stopped {
            self.flush();
            let event = cpu.stop_cause().map_or(0, |cause| cause.first_event);
            line(&mut self.text, format_args!("expect stop 16#{event:04X}"));
        }
        self.stopped = stopped;
    }

    fn flush(&mut self) {
        match std::mem::take(&mut self.waiting) {
            0 => {}
            1 => self.text.push_str("scan\n"),
            mut scans => {
                while scans > 0 {
                    let some = scans.min(super::SCANS_MAX);
                    line(&mut self.text, format_args!("scan {some}"));
                    scans -= some;
                }
            }
        }
    }

    /// The lines of what modules said since the last scan.
    fn heard(&mut self, cpu: &mut Cpu, time_us: u64) -> String {
        let heard = cpu.rack_mut().take_heard();
        let mut lines = String::new();
        for group in heard.chunk_by(|left, right| left.at_us == right.at_us) {
            // What was there before, this scan is the first to see.
            let at_us = if self.last_us.is_some_and(|last| group[0].at_us <= last) { time_us } else { group[0].at_us };
            let at = spelling::time(at_us);
            let inputs = self.inputs(group, cpu);
            if !inputs.is_empty() {
                line(&mut lines, format_args!("at {at}{inputs}"));
            }
            for heard in group {
                if let Said::Alarm(alarm) = &heard.said {
                    line(&mut lines, format_args!("at {at} interrupt {}", spelling::interrupt(alarm)));
                }
            }
        }
        lines
    }

    /// ` NAME=VALUE` of the inputs that have changed.
    fn inputs(&mut self, heard: &[Heard], cpu: &Cpu) -> String {
        let mut changed: BTreeMap<u32, u8> = BTreeMap::new();
        for heard in heard {
            if let Said::Byte { byte, value } = heard.said
                && let Some(known) = self.input_bytes.get_mut(byte as usize)
            {
                *changed.entry(byte).or_default() |= *known ^ value;
                *known = value;
            }
        }
        let mut out = String::new();
        if changed.is_empty() {
            return out;
        }
        for name in &self.subject.inputs {
            let Some(address) = address(name) else { continue };
            let mut touched = false;
            for (byte, mask) in bytes_of(&address) {
                if let Some(bits) = changed.get_mut(&byte) {
                    touched |= *bits & mask != 0;
                    *bits &= !mask;
                }
            }
            if touched {
                let bits = value_at(&address, &self.input_bytes);
                push(&mut out, &spelling::name(name.text()), &spelling::bits_of(name, bits));
            }
        }
        let image = cpu.machine().memory.layout.inputs.len() as u32;
        for (byte, bits) in changed.into_iter().filter(|(_, bits)| *bits != 0) {
            let area = if byte < image { Area::Input } else { Area::PeripheralInput };
            for address in addresses(area, byte, bits) {
                let name = unnamed(address, self.subject.mnemonics);
                push(&mut out, name.text(), &spelling::bits_of(&name, value_at(&address, &self.input_bytes)));
            }
        }
        out
    }

    /// ` NAME=VALUE` of the outputs that have changed.
    fn changed(&mut self, cpu: &Cpu) -> String {
        if !self.subject.chosen {
            self.find_unnamed(cpu);
        }
        let mut out = String::new();
        for output in &mut self.outputs {
            let sample = output.name.sample(cpu).unwrap_or_default();
            if output.last.as_ref() == Some(&sample) {
                continue;
            }
            match spelling::value(&output.name, &sample) {
                Some(value) => push(&mut out, &output.spelled, &value),
                // It has none, so that none is expected.
                None if output.last.is_some() => push(&mut out, &output.spelled, "?"),
                None => {}
            }
            output.last = Some(sample);
        }
        out
    }

    /// Outputs without a name of their own get the name of their address when they change: a program may find them by pointers.
    fn find_unnamed(&mut self, cpu: &Cpu) {
        let image = cpu.machine().memory.area(Area::Output);
        let direct = cpu.rack().outputs();
        let length = image.len().min(direct.len());
        let parts = [(Area::Output, 0, &image[..length]), (Area::PeripheralOutput, length, &direct[length..])];
        for (area, first, now) in parts {
            let Some(known) = self.output_bytes.get_mut(first..first + now.len()) else { continue };
            if known == now {
                continue;
            }
            let mut found = Vec::new();
            for (index, (known, &now)) in known.iter_mut().zip(now).enumerate() {
                let byte = first + index;
                let bits = (*known ^ now) & !self.covered[byte];
                *known = now;
                found.extend(addresses(area, byte as u32, bits));
            }
            for address in found {
                let name = unnamed(address, self.subject.mnemonics);
                self.cover(&name);
                self.outputs.push(output(&name));
            }
        }
    }

    fn cover(&mut self, name: &Name) {
        let Some(address) = address(name).filter(|address| matches!(address.area, Area::Output | Area::PeripheralOutput)) else { return };
        for (byte, mask) in bytes_of(&address) {
            if let Some(covered) = self.covered.get_mut(byte as usize) {
                *covered |= mask;
            }
        }
    }
}

fn output(name: &Name) -> Output {
    Output { spelled: spelling::name(name.text()), name: name.clone(), last: None }
}

fn line(text: &mut String, what: std::fmt::Arguments<'_>) {
    // Writing to a text cannot fail.
    let _ = text.write_fmt(what);
    text.push('\n');
}

fn push(out: &mut String, name: &str, value: &str) {
    let _ = write!(out, " {name}={value}");
}

fn address(name: &Name) -> Option<Address> {
    match name.operand() {
        Some(Operand::Address(address)) => Some(*address),
        _ => None,
    }
}

fn unnamed(address: Address, mnemonics: Mnemonics) -> Name {
    let operand = Operand::Address(address);
    Name::at(operand.spell(mnemonics), operand, None)
}

/// The bytes of an address with the bits that belong to it.
fn bytes_of(address: &Address) -> impl Iterator<Item = (u32, u8)> {
    let mask = if address.width == Width::Bit { 1 << (address.bit & 7) } else { 0xFF };
    (0..address.width.bytes()).map(move |index| (address.byte.saturating_add(index), mask)).collect::<Vec<_>>().into_iter()
}

fn value_at(address: &Address, bytes: &[u8]) -> u64 {
    let value = bytes_of(address).fold(0, |value, (byte, _)| value << 8 | u64::from(bytes.get(byte as usize).copied().unwrap_or(0)));
    if address.width == Width::Bit { value >> (address.bit & 7) & 1 } else { value }
}

/// The addresses of some bits of a byte: one by one if they are few, else the byte. Beyond the process image there are no bits.
fn addresses(area: Area, byte: u32, bits: u8) -> Vec<Address> {
    let one_by_one = bits.count_ones() <= BITS_MAX && matches!(area, Area::Input | Area::Output);
    match one_by_one {
        true => (0..8).filter(|bit| bits >> bit & 1 != 0).map(|bit| Address { area, width: Width::Bit, byte, bit }).collect(),
        false => vec![Address { area, width: Width::Byte, byte, bit: 0 }],
    }
}

impl Scenario {
    /// What is said before the first scan, as lines.
    fn settings_lines(&self) -> String {
        let mut text = String::new();
        if let Some(cpu) = self.cpu {
            line(&mut text, format_args!("cpu {}", cpu.name));
        }
        line(&mut text, format_args!("cycle {}", spelling::time(self.cycle_us())));
        if self.min_cycle_us > 0 {
            line(&mut text, format_args!("min-cycle {}", spelling::time(self.min_cycle_us)));
        }
        if let Some((word, _)) = ImageErrors::NAMES.iter().find(|(_, how)| *how == self.image_errors).filter(|(word, _)| *word != "off") {
            line(&mut text, format_args!("image-errors {word}"));
        }
        for (number, cyclic) in &self.cyclic {
            line(&mut text, format_args!("cyclic OB {number} {}ms phase {}ms", cyclic.interval_ms, cyclic.phase_ms));
        }
        if let Some(areas) = &self.retain {
            let plain = |numbers: &sieben_cpu::retain::Numbers| numbers.to_string().replace(' ', "");
            let (memory, timers, counters) = (plain(&areas.bit_memory), plain(&areas.timers), plain(&areas.counters));
            line(&mut text, format_args!("retain m={memory} t={timers} c={counters}"));
        }
        match &self.modules {
            Some(bytes) if bytes.is_empty() => text.push_str("modules none\n"),
            Some(bytes) => line(&mut text, format_args!("modules {}..{}", bytes.start, bytes.end - 1)),
            None => {}
        }
        if let Some(start) = self.start {
            line(&mut text, format_args!("start {}", start.word()));
        }
        if let Some(clock) = self.clock {
            line(&mut text, format_args!("clock {}", spelling::clock(clock)));
        }
        text
    }
}
