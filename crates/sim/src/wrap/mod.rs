//! Faults around a module: what its sensors say and what its actuators get, changed between two times.

mod fault;

use std::any::Any;
use std::collections::VecDeque;
use std::ops::Range;

use sieben_cpu::{IoModule, Rack};

use crate::devices::random::Random;
use crate::devices::{Attention, Device, DeviceSettings, Kind, Place, Signal};
pub use fault::{Fault, FaultKind};

/// Faults of one module: more is a slip of the pen.
pub const FAULTS_MAX: usize = 100;

/// Values that a late signal remembers: one per change, 100 s of a signal that changes every scan of 10 ms.
const MEMORY_MAX: usize = 10_000;

/// A device whose signals can fail.
#[derive(Clone)]
pub struct Plant {
    device: Device,
    faults: Vec<Active>,
    /// What the CPU has put out.
    commands: Vec<u8>,
    /// What the CPU reads, while a fault is there.
    seen: Vec<u8>,
    now_us: u64,
}

/// A fault with what it remembers.
#[derive(Clone)]
struct Active {
    fault: Fault,
    signal: Signal,
    from_us: u64,
    /// The value at the beginning: what is stuck stays there.
    first: Option<i16>,
    /// The true value that was seen last.
    last: Option<i16>,
    bouncing_until_us: u64,
    memory: VecDeque<(u64, i16)>,
    random: Random,
}

impl Active {
    fn acts(&self, now_us: u64) -> bool {
        now_us >= self.from_us && self.fault.until_us.is_none_or(|until| now_us < until)
    }

    /// What comes through of a value.
    fn change(&mut self, now_us: u64, value: i16) -> i16 {
        if let FaultKind::Late(delay_us) = self.fault.kind {
            if self.memory.back().is_none_or(|&(_, last)| last != value) {
                self.memory.push_back((now_us, value));
            }
            while self.memory.len() > MEMORY_MAX || self.memory.get(1).is_some_and(|&(at, _)| at.saturating_add(delay_us) <= now_us) {
                self.memory.pop_front();
            }
        }
        let before = self.last.replace(value);
        if !self.acts(now_us) {
            return value;
        }
        let first = *self.first.get_or_insert(value);
        match self.fault.kind {
            FaultKind::Stuck(at) => at.map_or(first, |at| self.signal_raw(at)),
            FaultKind::Drift(per_second) => {
                let seconds = (now_us - self.from_us) as f64 / 1e6;
                // Conversion of a float saturates.
                (f64::from(value) + per_second * seconds * self.signal.per_unit).round() as i16
            }
            FaultKind::Late(_) => self.memory.front().map_or(value, |&(_, old)| old),
            FaultKind::Bounce(time_us) => {
                if before.is_some_and(|before| before != value) {
                    self.bouncing_until_us = now_us.saturating_add(time_us);
                }
                if now_us < self.bouncing_until_us { (self.random.next() & 1) as i16 } else { value }
            }
        }
    }

    /// A number in the unit of the signal as its terminal has it.
    fn signal_raw(&self, value: f64) -> i16 {
        (value * self.signal.per_unit).round() as i16
    }
}

impl Plant {
    /// A device without a fault.
    pub fn new(settings: DeviceSettings) -> Self {
        let device = Device::new(settings);
        let (commands, seen) = (vec![0; device.outputs().len()], vec![0; device.inputs().len()]);
        Self { device, faults: Vec::new(), commands, seen, now_us: 0 }
    }
    /// The device.
    pub fn device(&self) -> &Device {
        &self.device
    }
    /// What it is.
    pub fn kind(&self) -> &'static Kind {
        self.device.settings().kind
    }
    /// The world around it does something for it.
    pub fn attend(&mut self, attention: Attention) {
        self.device.attend(attention);
    }
    /// The output bytes as the CPU wrote them.
    pub fn commands(&self) -> &[u8] {
        &self.commands
    }
    /// Its faults, those too whose time has not come or is over.
    pub fn faults(&self) -> impl Iterator<Item = &Fault> {
        self.faults.iter().map(|active| &active.fault)
    }

    /// Those of its faults whose time it is.
    pub fn acting_faults(&self) -> impl Iterator<Item = &Fault> {
        self.faults.iter().filter(|active| active.acts(self.now_us)).map(|active| &active.fault)
    }

    /// From its time on, one without a time from now on, a signal fails.
    ///
    /// # Errors
    /// The device has no such signal, the fault does not fit it, or there are too many; the message says which there are.
    pub fn inject(&mut self, fault: &Fault) -> Result<(), String> {
        let signal = fault.fits(self.kind(), self.device.signals())?;
        if self.faults.len() >= FAULTS_MAX {
            return Err(format!("`{}` has {FAULTS_MAX} faults already", self.name()));
        }
        let from_us = fault.from_us.unwrap_or(self.now_us);
        // Every fault has a row of random numbers of its own.
        let seed = self.device.settings().seed.rotate_left(17) ^ (self.faults.len() as u64 + 1);
        self.faults.push(Active {
            fault: fault.clone(),
            signal,
            from_us,
            first: None,
            last: None,
            bouncing_until_us: 0,
            memory: VecDeque::new(),
            random: Random::new(seed),
        });
        self.look();
        Ok(())
    }

    /// Takes the faults of a signal away, or of all; `false` if there was none.
    pub fn mend(&mut self, signal: Option<&str>) -> bool {
        let before = self.faults.len();
        self.faults.retain(|active| signal.is_some_and(|name| active.fault.signal != name));
        self.look();
        self.faults.len() < before
    }

    fn has_faults(&self, inputs: bool) -> bool {
        self.faults.iter().any(|active| active.signal.is_input() == inputs)
    }

    fn apply(&mut self, inputs: bool, bytes: &mut [u8]) {
        let now_us = self.now_us;
        for active in self.faults.iter_mut().filter(|active| active.signal.is_input() == inputs) {
            let value = active.signal.raw(bytes);
            let changed = active.change(now_us, value);
            active.signal.put(bytes, changed);
        }
    }

    /// Reads the sensors, through the faults.
    fn look(&mut self) {
        if self.has_faults(true) {
            let mut bytes = self.device.input_bytes();
            self.apply(true, &mut bytes);
            self.seen = bytes;
        }
    }
}

impl IoModule for Plant {
    fn copy(&self) -> Option<Box<dyn IoModule>> {
        Some(Box::new(self.clone()))
    }
    fn name(&self) -> &str {
        self.device.name()
    }
    fn inputs(&self) -> Range<u32> {
        self.device.inputs()
    }
    fn outputs(&self) -> Range<u32> {
        self.device.outputs()
    }
    fn read(&self, offset: u32, into: &mut [u8]) {
        if self.has_faults(true) {
            let start = offset as usize;
            into.copy_from_slice(&self.seen[start..start + into.len()]);
        } else {
            self.device.read(offset, into);
        }
    }
    fn write(&mut self, offset: u32, from: &[u8]) {
        let start = offset as usize;
        self.commands[start..start + from.len()].copy_from_slice(from);
        // With a fault the commands arrive when time passes.
        if !self.has_faults(false) {
            self.device.write(offset, from);
        }
    }
    fn advance(&mut self, dt_us: u64) {
        if self.has_faults(false) {
            let mut bytes = self.commands.clone();
            self.apply(false, &mut bytes);
            self.device.write(0, &bytes);
        }
        self.device.advance(dt_us);
        self.now_us = self.now_us.saturating_add(dt_us);
        self.look();
    }
    fn answers(&self) -> bool {
        self.device.answers()
    }
    fn set_answering(&mut self, answers: bool) -> bool {
        self.device.set_answering(answers)
    }
    fn set_input(&mut self, offset: u32, mask: u8, value: u8) -> bool {
        let set = self.device.set_input(offset, mask, value);
        self.look();
        set
    }
}

/// The plants in a rack.
pub fn plants(rack: &Rack) -> impl Iterator<Item = &Plant> {
    rack.modules().filter_map(|module| (module as &dyn Any).downcast_ref())
}

/// Lets a signal of one of the plants in a rack fail.
///
/// # Errors
/// There is no such plant or signal, or the fault does not fit; the message says what there is.
pub fn inject(rack: &mut Rack, fault: &Fault) -> Result<(), String> {
    plant(rack, &fault.module)?.inject(fault)
}

/// Takes the faults of `plant.signal`, or of a whole `plant`, away.
///
/// # Errors
/// There is no such plant, or it has no such fault.
pub fn mend(rack: &mut Rack, name: &str) -> Result<(), String> {
    let (module, signal) = name.split_once('.').map_or((name, None), |(module, signal)| (module, Some(signal)));
    let mended = plant(rack, module.trim())?.mend(signal.map(str::trim));
    if mended { Ok(()) } else { Err(format!("`{name}` has no fault that could be mended")) }
}

fn plant<'a>(rack: &'a mut Rack, name: &str) -> Result<&'a mut Plant, String> {
    let names: Vec<String> = rack.modules().map(|module| module.name().to_owned()).collect();
    let plants: Vec<&mut Plant> = rack.modules_mut().collect();
    let known: Vec<String> = plants.iter().map(|plant| format!("`{}`", plant.name())).collect();
    let found = plants.into_iter().find(|plant| plant.name() == name);
    found.ok_or_else(|| match (known.is_empty(), names.iter().any(|other| other == name)) {
        (_, true) => format!("`{name}` is a module whose signals cannot fail"),
        (true, _) => format!("there is no plant `{name}`: the project has no `[[module]]`"),
        (false, _) => format!("there is no plant `{name}`; the project has {}", known.join(", ")),
    })
}

/// Whether a signal can fail in this way.
fn check(signal: &Signal, kind: &FaultKind) -> Result<(), String> {
    let bit = matches!(signal.place, Place::Bit(..));
    match kind {
        FaultKind::Drift(_) if bit => Err(format!("`{}` is a bit and cannot drift; it can be stuck, late, or bounce", signal.name)),
        FaultKind::Bounce(_) if !bit => Err(format!("`{}` is a word and cannot bounce; it can be stuck, late, or drift", signal.name)),
        FaultKind::Stuck(Some(at)) if bit && !(*at == 0.0 || *at == 1.0) => {
            Err(format!("`{}` is a bit: it can be stuck at 0 or at 1", signal.name))
        }
        _ => Ok(()),
    }
}

impl Fault {
    /// The signal that it is about, if it is among those of a device and can fail like that.
    ///
    /// # Errors
    /// It does not; the message says what would.
    pub fn fits(&self, kind: &Kind, signals: &[Signal]) -> Result<Signal, String> {
        let signal = signals.iter().find(|signal| signal.name == self.signal).copied().ok_or_else(|| {
            let names = |inputs| {
                let names = signals.iter().filter(|signal| signal.is_input() == inputs).map(|signal| format!("`{}`", signal.name));
                names.collect::<Vec<_>>().join(", ")
            };
            format!("a {} has no signal `{}`; it has the inputs {} and the outputs {}", kind.name, self.signal, names(true), names(false))
        })?;
        check(&signal, &self.kind).map(|()| signal)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A plant with one fault, and the values of its signal every 10 ms.
    fn run(kind: &str, fault: &str, signal: &str, scans: u64, mut operate: impl FnMut(u64, &mut Plant)) -> Vec<i16> {
        let kind = Kind::by_name(kind).expect("a kind");
        let mut plant = Plant::new(DeviceSettings::new(kind));
        if !fault.is_empty() {
            plant.inject(&Fault::parse(fault).expect("a fault")).expect("a fault that fits");
        }
        let signal = kind.signal(signal).expect("a signal");
        (0..scans)
            .map(|scan| {
                operate(scan, &mut plant);
                plant.advance(10_000);
                let mut bytes = vec![0; plant.inputs().len()];
                plant.read(0, &mut bytes);
                signal.raw(&bytes)
            })
            .collect()
    }

    #[test]
    fn what_is_stuck_stays_between_its_times() {
        let fill = |_: u64, plant: &mut Plant| plant.write(0, &[1, 0, 0, 0]);
        let sound = run("tank", "", "level", 1000, fill);
        let stuck = run("tank", "tank.level stuck@2s..5s", "level", 1000, fill);
        assert_eq!((&stuck[..198], &stuck[500..]), (&sound[..198], &sound[500..]));
        assert!(stuck[200..498].iter().all(|value| *value == stuck[200]) && sound[400] != sound[200]);
        let at = run("tank", "tank.level stuck=50", "level", 3, fill);
        assert_eq!(at, [13_824; 3]);
    }

    #[test]
    fn what_drifts_goes_away_evenly() {
        let sound = run("tank", "", "level", 600, |_, _| {});
        let drifting = run("tank", "tank.level drift=2@1s", "level", 600, |_, _| {});
        // 2 % per second are 552.96 counts; after 4 s 2212.
        assert_eq!(i32::from(drifting[499]) - i32::from(sound[499]), 2212);
        assert_eq!(drifting[..99], sound[..99]);
    }

    #[test]
    fn what_is_late_is_the_same_later() {
        let press = |scan: u64, plant: &mut Plant| {
            plant.set_input(0, 1, u8::from((scan / 7).is_multiple_of(2)));
        };
        let sound = run("dosing", "", "start", 300, press);
        let late = run("dosing", "dosing.start late=50ms", "start", 300, press);
        // The button moves between two scans: 50 ms later is before the fifth one.
        assert_eq!(late[4..], sound[..296]);
    }

    #[test]
    fn what_bounces_settles() {
        let press = |scan: u64, plant: &mut Plant| {
            plant.set_input(0, 1, u8::from(scan >= 100));
        };
        let bouncing = run("dosing", "dosing.start bounce=200ms", "start", 300, press);
        assert!(bouncing[..99].iter().all(|value| *value == 0) && bouncing[121..].iter().all(|value| *value == 1));
        let edges = bouncing.windows(2).filter(|pair| pair[0] != pair[1]).count();
        assert!(edges > 2, "{edges} edges");
        assert_eq!(bouncing, run("dosing", "dosing.start bounce=200ms", "start", 300, press));
    }

    #[test]
    fn an_actuator_can_fail_too_and_be_mended() {
        let kind = Kind::by_name("motor").expect("a kind");
        let mut plant = Plant::new(DeviceSettings::new(kind));
        plant.inject(&Fault::parse("motor.line stuck=0").expect("a fault")).expect("fits");
        plant.write(0, &[0b011]);
        for _ in 0..100 {
            plant.advance(10_000);
        }
        assert_eq!(plant.device().value("speed"), Some(0.0));
        assert!(plant.mend(Some("line")) && !plant.mend(Some("line")));
        plant.write(0, &[0b011]);
        for _ in 0..500 {
            plant.advance(10_000);
        }
        assert!(plant.device().value("speed").is_some_and(|speed| speed > 80.0));
    }

    #[test]
    fn a_fault_that_does_not_fit_is_said_in_the_users_words() {
        let kind = Kind::by_name("tank").expect("a kind");
        for (text, word) in [
            ("tank.levle stuck", "no signal `levle`; it has the inputs `low`"),
            ("tank.low drift=1", "is a bit and cannot drift"),
            ("tank.low stuck=2", "stuck at 0 or at 1"),
            ("tank.level bounce=1s", "is a word and cannot bounce"),
        ] {
            let error = Fault::parse(text).expect("a fault").fits(kind, kind.signals).expect_err(text);
            assert!(error.contains(word), "{text}: {error}");
        }
    }
}
