//! One controller of a fleet at work: its scans, what arrives for it and what it sends.

use std::collections::VecDeque;

use sieben_cpu::{Cpu, OperatingMode, Restart, StopCause};
use sieben_model::address::{Area, Operand, Width};
use sieben_model::value::Value;
use sieben_sim::scenario::recorder::Recorder;
use sieben_sim::scenario::{Deed, Happened, Holding};

use super::windows::Window;
use super::wiring::{Message, Wire, area};

/// One controller.
pub(super) struct Instance {
    pub(super) cpu: Cpu,
    /// Which one it is in the whole fleet.
    pub(super) number: u32,
    /// The wires out of it, each with the last value that was sent over it.
    pub(super) outgoing: Box<[(u32, u32)]>,
    /// What is under way to it, the next one first.
    pub(super) inbox: VecDeque<Message>,
    pub(super) started: bool,
    pub(super) counts: Counts,
    pub(super) stop: Option<Stopped>,
    /// Who writes down what goes into it.
    pub(super) recorder: Option<Box<Recorder>>,
}

/// What a controller has done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Scans that ran.
    pub scans: u64,
    /// Messages that it has sent.
    pub sent: u64,
    /// Messages that have arrived.
    pub received: u64,
    /// The longest scan, in nanoseconds of real time.
    pub longest_ns: u64,
}

/// Why a controller is in STOP.
#[derive(Clone, Debug)]
pub struct Stopped {
    /// The scan that it went to STOP in, counted from 0; none = at its start.
    pub scan: Option<u64>,
    /// When that scan began, in microseconds.
    pub at_us: u64,
    /// The cause; none if the CPU says none.
    pub cause: Option<StopCause>,
}

impl Instance {
    /// Its scans of a window. What it sends goes to `outbox`. `clock` shows nanoseconds of real time.
    pub(super) fn run(&mut self, window: &Window, all: &[Wire], outbox: &mut Vec<Message>, clock: &dyn Fn() -> u64) {
        if !std::mem::replace(&mut self.started, true) {
            self.start();
        }
        if self.stop.is_some() {
            return;
        }
        let mut before = clock();
        for scan in window.from..window.to {
            let at_us = window.begin_us(scan);
            self.deliver(at_us, all);
            self.cpu.scan(at_us);
            let now = clock();
            self.counts.longest_ns = self.counts.longest_ns.max(now.saturating_sub(before));
            before = now;
            self.counts.scans += 1;
            if let Some(recorder) = &mut self.recorder {
                recorder.see(Happened::Scan { cpu: &mut self.cpu, time_us: at_us, held: Holding::NOTHING });
            }
            let stopped = self.cpu.mode() == OperatingMode::Stop;
            if stopped {
                self.stop = Some(Stopped { scan: Some(scan), at_us, cause: self.cpu.stop_cause().cloned() });
            }
            self.send(at_us, all, outbox);
            if stopped {
                return;
            }
        }
    }

    fn start(&mut self) {
        if let Some(recorder) = &mut self.recorder {
            recorder.see(Happened::Began { cpu: &mut self.cpu });
        }
        if self.cpu.restart(Restart::Warm) == OperatingMode::Stop {
            self.stop = Some(Stopped { scan: None, at_us: 0, cause: self.cpu.stop_cause().cloned() });
        }
    }

    /// What has arrived by the time of a scan: inputs change at their times, all else before the scan.
    fn deliver(&mut self, at_us: u64, all: &[Wire]) {
        while let Some(message) = self.inbox.pop_front_if(|message| message.at_us <= at_us) {
            let name = &all[message.wire as usize].target;
            let value = Value::bits(name.kind().clone(), u64::from(message.value));
            self.counts.received += 1;
            let is_input = name.operand().and_then(area).is_some_and(|area| matches!(area, Area::Input | Area::PeripheralInput));
            if let Some(recorder) = self.recorder.as_mut().filter(|_| !is_input) {
                recorder.see(Happened::Did(Deed::Line(&format!("set {}={}", name.text(), value.shown()))));
            }
            // It was tried when the fleet was opened; a data block that the program has deleted since takes nothing.
            let _ = name.set_at(&mut self.cpu, &value, message.at_us);
        }
    }

    /// Sends what has changed.
    fn send(&mut self, at_us: u64, all: &[Wire], outbox: &mut Vec<Message>) {
        for (wire, last) in &mut self.outgoing {
            let wire = *wire;
            let Wire { source, is_output, latency_us, .. } = &all[wire as usize];
            let value = if *is_output && self.stop.is_some() { 0 } else { read(&self.cpu, source) };
            if value != *last {
                *last = value;
                let at_us = at_us.saturating_add(*latency_us);
                outbox.push(Message { at_us, sender: self.number, number: self.counts.sent, wire, value });
                self.counts.sent += 1;
            }
        }
    }

    /// Puts what is under way in the order in which it arrives: of messages at one moment by sender and number.
    pub(super) fn sort(&mut self) {
        self.inbox.make_contiguous().sort_unstable();
    }
}

/// The value of what is sent; 0 if it is not there any more.
fn read(cpu: &Cpu, source: &Operand) -> u32 {
    match source {
        Operand::Address(address) if address.area == Area::PeripheralOutput => {
            cpu.rack().peripheral_output(address.byte, address.width).unwrap_or(0)
        }
        Operand::Address(address) if address.area == Area::PeripheralInput => {
            cpu.rack().peripheral_read(address.byte, address.width).unwrap_or(0)
        }
        source => cpu.machine().memory.read(source).unwrap_or(0),
    }
}

/// The bytes that a controller has put out, as far as its program writes any.
pub(super) fn outputs(cpu: &Cpu, bytes: usize) -> &[u8] {
    let outputs = cpu.machine().memory.area(Area::Output);
    &outputs[..bytes.min(outputs.len())]
}

/// Whether such a value can be read.
pub(super) fn is_there(cpu: &Cpu, source: &Operand) -> bool {
    match source {
        Operand::Address(address) if address.area == Area::PeripheralOutput => {
            cpu.rack().peripheral_output(address.byte, address.width.max(Width::Byte)).is_some()
        }
        Operand::Address(address) if address.area == Area::PeripheralInput => {
            cpu.rack().peripheral_read(address.byte, address.width).is_some()
        }
        source => cpu.machine().memory.read(source).is_some(),
    }
}
