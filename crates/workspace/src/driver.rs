//! The run loop: when scans begin, in real and in virtual time, and when the run ends.

use sieben_cpu::{Cpu, OperatingMode, Restart, TimeSource};

use crate::gate::{Gate, PORTION_US, Plant};
use crate::pace::{Missed, Pace, Speed};
use crate::status::Desk;

/// Scans in virtual time that are run without opening the gate.
const SCANS_AT_ONCE: u64 = 64;
/// What communication gets of the time of a CPU that scans without a pause, in percent.
const COMMUNICATION_LOAD: u64 = 20;
/// Longest pause without a look around, in microseconds.
const PAUSE_US_MAX: u64 = 1_000_000;
/// Shortest pause where every cycle is made up for, in microseconds: of shorter cycles several are scanned after each other.
const PAUSE_US_MIN: u64 = 1_000;

/// What stands around a run.
pub trait Surroundings {
    /// Before anything else of an iteration: [another CPU](crate::exchange) may take the place of this one.
    fn exchange(&mut self, plant: &mut Plant) {
        let _ = plant;
    }
    /// Retentive data is kept: after each scan, before the next one releases its outputs.
    fn keep(&mut self, cpu: &mut Cpu) {
        let _ = cpu;
    }
    /// The cycle control point, before a scan or a pause: changed sources take over, something is shown.
    fn at_point(&mut self, plant: &mut Plant) {
        let _ = plant;
    }
    /// Right before each scan, also of a CPU in STOP, which only lets its plants live on.
    fn before_scan(&mut self, plant: &mut Plant) {
        let _ = plant;
    }
    /// Right after each of them.
    fn after_scan(&mut self, plant: &mut Plant) {
        let _ = plant;
    }
    /// Whether the run has been ended from outside.
    fn is_ended(&self) -> bool;
}

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The CPU is in STOP.
    Stopped,
    /// Its time is over.
    Over,
    /// It was ended from outside.
    Ended,
}

/// What the loop does next.
enum Next {
    /// It ends.
    End(End),
    /// It waits so many microseconds of the computer's time.
    Rest(u64),
    /// It opens the gate for the threads that want in.
    Open,
    /// It goes on at once after what took so many microseconds.
    Again(u64),
}

/// The thread that scans.
pub struct Driver<'g> {
    gate: &'g Gate,
    desk: &'g Desk,
    surroundings: &'g mut dyn Surroundings,
    /// How long it has scanned since the gate was open last, in microseconds.
    worked_us: u64,
}

impl<'g> Driver<'g> {
    /// A driver for the plant of a gate. `desk` is where the status of scans is asked for.
    pub fn new(gate: &'g Gate, desk: &'g Desk, surroundings: &'g mut dyn Surroundings) -> Self {
        Self { gate, desk, surroundings, worked_us: 0 }
    }

    /// Starts the CPU and runs it to the end. The gate stays open.
    pub fn run(&mut self, restart: Restart) -> End {
        self.gate.scan(|plant| plant.switch_on(restart));
        self.go_on()
    }

    /// Runs a CPU to the end that was started or switched on before.
    pub fn go_on(&mut self) -> End {
        let gate = self.gate;
        loop {
            match gate.scan(|plant| self.iteration(plant)) {
                Next::End(end) => return end,
                Next::Rest(us) => {
                    self.worked_us = 0;
                    gate.rest(us.min(PAUSE_US_MAX));
                }
                Next::Open => drop(gate.rest(PORTION_US)),
                Next::Again(us) => self.communicate(us),
            }
        }
    }

    /// Without pauses between scans: those outside have their share of the time as soon as that is worth a portion.
    fn communicate(&mut self, us: u64) {
        self.worked_us = self.worked_us.saturating_add(us);
        let share = self.worked_us * COMMUNICATION_LOAD / 100;
        if share >= PORTION_US {
            self.worked_us = 0;
            if self.gate.is_wanted() {
                self.gate.rest(share);
            }
        }
    }

    fn start(&mut self, plant: &mut Plant, restart: Restart) {
        let mut clock = self.clock(&plant.pace);
        plant.cpu.restart_with(restart, &mut clock, None);
        plant.touch();
        self.surroundings.keep(&mut plant.cpu);
        if plant.pace.missed == Missed::LeftOut {
            plant.pace.due_us = plant.pace.time_us(self.gate.now_us());
        }
    }

    /// The clock of a startup: where every cycle is made up for, it shows the time of the next one.
    fn clock(&self, pace: &Pace) -> impl FnMut() -> u64 + use<'g> {
        let (gate, pace) = (self.gate, pace.clone());
        move || match pace.missed {
            Missed::LeftOut => pace.time_us(gate.now_us()),
            Missed::MadeUp => pace.due_us,
        }
    }

    fn iteration(&mut self, plant: &mut Plant) -> Next {
        self.surroundings.exchange(plant);
        if let Some(restart) = plant.power_on.take() {
            self.start(plant, restart);
        }
        if let Some((restart, by)) = plant.start.take() {
            let mut clock = self.clock(&plant.pace);
            plant.waits_in_stop = false;
            // A start of a CPU that runs already asks for what is there.
            let _ = plant.cpu.start_with(restart, by, &mut clock, None);
            plant.touch();
            self.surroundings.keep(&mut plant.cpu);
        }
        self.desk.observed.see_mode(plant);
        let source = if plant.pace.is_real() { TimeSource::Real } else { TimeSource::Virtual };
        if plant.cpu.set_time_source(source) != source {
            plant.touch();
        }
        match (plant.pace.speed(), plant.pace.missed) {
            _ if plant.pace.is_paused() => self.paused(plant),
            (Speed::Max, _) => self.virtual_time(plant),
            (Speed::Factor(_), Missed::MadeUp) => self.every_cycle(plant),
            (Speed::Factor(_), Missed::LeftOut) => self.timed(plant),
        }
    }

    /// Whether the run ends before a scan at this time.
    fn end(&self, plant: &Plant, now_us: u64) -> Option<End> {
        if plant.cpu.mode() == OperatingMode::Stop && !(plant.waits_in_stop || plant.stays_in_stop) {
            return Some(End::Stopped);
        }
        if now_us >= plant.pace.end_us {
            return Some(End::Over);
        }
        self.surroundings.is_ended().then_some(End::Ended)
    }

    /// Time stands still: only scans that are asked for.
    fn paused(&mut self, plant: &mut Plant) -> Next {
        let now_us = plant.pace.time_us(self.gate.now_us());
        if let Some(end) = self.end(plant, now_us) {
            return Next::End(end);
        }
        self.surroundings.at_point(plant);
        if !plant.pace.take_step() {
            return Next::Rest(PAUSE_US_MAX);
        }
        if plant.pace.missed == Missed::LeftOut {
            plant.pace.due_us = plant.pace.due_us.max(now_us);
        }
        plant.pace.jump_to_scan();
        let began = self.gate.now_us();
        let at_us = plant.pace.due_us;
        self.scan(plant, &mut || at_us);
        plant.pace.due_us = at_us.saturating_add(plant.pace.cycle_us);
        Next::Again(self.gate.now_us().saturating_sub(began))
    }

    /// Scans one after another; the clock jumps from scan to scan.
    fn virtual_time(&mut self, plant: &mut Plant) -> Next {
        let began = self.gate.now_us();
        if plant.pace.missed == Missed::MadeUp {
            plant.pace.jump_to_scan();
        }
        for _ in 0..SCANS_AT_ONCE {
            let now_us = plant.pace.time_us(0);
            if let Some(end) = self.end(plant, now_us) {
                return Next::End(end);
            }
            // Time goes from scan to scan: without scans it stands still.
            if plant.cpu.mode() == OperatingMode::Stop {
                self.surroundings.at_point(plant);
                return Next::Rest(PAUSE_US_MAX);
            }
            self.scan(plant, &mut || now_us);
            // A cycle of 0 would never pass any time.
            plant.pace.pass(plant.pace.cycle_us.max(1));
            plant.pace.due_us = plant.pace.time_us(0);
        }
        self.surroundings.at_point(plant);
        Next::Again(self.gate.now_us().saturating_sub(began))
    }

    /// Scans every cycle at its own time, as in virtual time, when the clock has come to it.
    fn every_cycle(&mut self, plant: &mut Plant) -> Next {
        let gate = self.gate;
        let began = gate.now_us();
        let (now_us, due_us) = (plant.pace.wait_for_scans(began), plant.pace.due_us);
        if let Some(end) = self.end(plant, now_us.min(due_us)) {
            return Next::End(end);
        }
        self.surroundings.at_point(plant);
        if now_us < due_us {
            let until = due_us.min(plant.pace.end_us);
            return Next::Rest(plant.pace.real_until(until, began).unwrap_or(PAUSE_US_MAX).max(PAUSE_US_MIN));
        }
        self.scan(plant, &mut || due_us);
        plant.pace.due_us = due_us.saturating_add(plant.pace.cycle_us.max(1));
        Next::Again(gate.now_us().saturating_sub(began))
    }

    /// Scans when the clock says so. A late scan begins at once, and the next one a whole cycle after it: nothing is made up for.
    fn timed(&mut self, plant: &mut Plant) -> Next {
        let (gate, pace) = (self.gate, plant.pace.clone());
        let mut clock = || pace.time_us(gate.now_us());
        let real = pace.speed().is_real();
        let now_us = clock();
        if let Some(end) = self.end(plant, now_us) {
            return Next::End(end);
        }
        self.surroundings.at_point(plant);
        let until = pace.due_us.min(pace.end_us);
        if now_us < until {
            if real && plant.cpu.has_background() {
                gate.in_background(|| plant.cpu.background_with(until, &mut clock));
                plant.touch();
                self.surroundings.keep(&mut plant.cpu);
                return if gate.is_wanted() { Next::Open } else { Next::Again(0) };
            }
            // An interrupt that comes while the CPU waits runs at its own time.
            let wake_us = plant.cpu.next_interrupt_us().map_or(until, |next| next.clamp(now_us, until));
            if now_us < wake_us {
                return Next::Rest(pace.real_until(wake_us, gate.now_us()).unwrap_or(PAUSE_US_MAX));
            }
        }
        let interrupts = plant.cpu.next_interrupt_us().is_some_and(|next| next <= now_us);
        if interrupts || now_us < until {
            // What it writes to the process image goes out with the outputs of the last scan.
            let woken_us = now_us;
            let mut still = || woken_us;
            self.desk.serve(plant, if real { &mut clock } else { &mut still });
            self.surroundings.keep(&mut plant.cpu);
        }
        if now_us < until {
            return Next::Again(0);
        }
        let began = gate.now_us();
        if real {
            self.scan(plant, &mut clock);
        } else {
            self.scan(plant, &mut || now_us);
        }
        plant.pace.due_us = pace.due_us.saturating_add(pace.cycle_us).max(now_us);
        Next::Again(gate.now_us().saturating_sub(began))
    }

    fn scan(&mut self, plant: &mut Plant, clock: &mut dyn FnMut() -> u64) {
        // A CPU in STOP only lets its plants live on.
        let scans = plant.cpu.mode() != OperatingMode::Stop;
        self.surroundings.before_scan(plant);
        let now_us = self.gate.now_us();
        self.desk.scan(plant, clock, now_us);
        plant.scans += u64::from(scans);
        self.desk.observed.observe(plant, now_us);
        let took_us = plant.cpu.cycle_times().execution_last;
        // In virtual time nothing is measured.
        if scans && took_us > 0 {
            plant.scan_times.add(took_us, plant.pace.cycle_us);
        }
        self.surroundings.keep(&mut plant.cpu);
        self.surroundings.after_scan(plant);
    }
}
