//! What a run of a fleet has come to so far.

use std::sync::PoisonError;

use sieben_campaign::draws::mix;
use sieben_cpu::OperatingMode;
use sieben_engine::Machine;

use super::instance::{self, Counts, Instance, Stopped};
use super::{Fleet, Program};
use crate::controller;

/// What all controllers have come to.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    /// Each controller, in the order of the file.
    pub rows: Vec<Row>,
    /// What the program of every controller can see, as one number: the same for every number of threads, every engine and every speed.
    pub state_hash: u64,
}

/// What one controller has come to.
#[derive(Clone, Debug)]
pub struct Row {
    /// The name of its group.
    pub controller: String,
    /// Which of the group it is; none = the only one.
    pub index: Option<u32>,
    /// What it has done.
    pub counts: Counts,
    /// Statements that failed while the program went on.
    pub failed_statements: u64,
    /// Why it is in STOP, if it is.
    pub stop: Option<Stopped>,
    /// The process image of the outputs, as far as the program writes it.
    pub outputs: Box<[u8]>,
    /// Bytes that it takes for itself.
    pub bytes: usize,
    /// What of them is data blocks and plants.
    pub data_bytes: usize,
}

impl Row {
    /// What it is called.
    pub fn name(&self) -> String {
        self.index.map_or_else(|| self.controller.clone(), |index| format!("{}[{index}]", self.controller))
    }
}

impl Summary {
    /// Scans of all controllers.
    pub fn scans(&self) -> u64 {
        self.rows.iter().map(|row| row.counts.scans).sum()
    }

    /// Messages that have been sent.
    pub fn messages(&self) -> u64 {
        self.rows.iter().map(|row| row.counts.sent).sum()
    }

    /// Those that are in STOP.
    pub fn stopped(&self) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(|row| row.stop.is_some())
    }

    /// The controller with the longest scan.
    pub fn longest(&self) -> Option<&Row> {
        // Of several the first.
        self.rows.iter().rev().max_by_key(|row| row.counts.longest_ns)
    }

    /// Bytes that a controller takes for itself, on average.
    pub fn bytes_per_instance(&self) -> usize {
        self.rows.iter().map(|row| row.bytes).sum::<usize>().div_ceil(self.rows.len().max(1))
    }
}

impl Fleet {
    /// What the controllers have come to; between two windows.
    pub fn summary(&self) -> Summary {
        let mut summary = Summary::default();
        let mut hash = mix(self.instances.len() as u64);
        for (group, controllers) in self.groups.iter().zip(&self.spec.controllers) {
            let program = &self.programs[group.program];
            for index in 0..group.count {
                let instance = self.instances[(group.first + index) as usize].lock().unwrap_or_else(PoisonError::into_inner);
                hash = mix(hash ^ state(&instance));
                summary.rows.push(Row {
                    controller: controllers.name.text.clone(),
                    index: controllers.count.map(|_| index),
                    ..row(&instance, program)
                });
            }
        }
        summary.state_hash = hash;
        summary
    }
}

fn row(instance: &Instance, program: &Program) -> Row {
    let cpu = &instance.cpu;
    let written = instance::outputs(cpu, program.output_bytes);
    // Of a program that may write anywhere the bytes up to the last that is not 0.
    let is_known = program.output_bytes <= written.len();
    let length = if is_known { written.len() } else { written.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1) };
    let mut stop = instance.stop.clone();
    if let Some(cause) = stop.as_mut().and_then(|stop| stop.cause.as_mut()) {
        cause.text = controller::named(&program.build, &cause.text, cause.place);
    }
    let bytes = cpu.bytes();
    let own = size_of::<Instance>() - size_of_val(cpu)
        + size_of_val(&*instance.outgoing)
        + instance.inbox.capacity() * size_of::<super::wiring::Message>();
    Row {
        controller: String::new(),
        index: None,
        counts: instance.counts,
        failed_statements: cpu.failed_statements().count,
        stop,
        outputs: written[..length].into(),
        bytes: bytes.total() + own,
        data_bytes: bytes.data_blocks + bytes.plants,
    }
}

/// What the program of a controller can see, as one number: all memory but local data, which is dead between two scans.
fn state(instance: &Instance) -> u64 {
    let cpu = &instance.cpu;
    let machine: &Machine = cpu.machine();
    let memory = &machine.memory;
    let local = &memory.layout.local;
    let mut hash = Hash(mix(instance.counts.scans));
    hash.add(match cpu.mode() {
        OperatingMode::Stop => 0,
        OperatingMode::Startup => 1,
        OperatingMode::Run => 2,
        OperatingMode::Hold => 3,
    });
    hash.add(instance.stop.as_ref().and_then(|stop| stop.cause.as_ref()).map_or(0, |cause| u64::from(cause.event)));
    hash.add(instance.counts.sent);
    hash.add(machine.clock_us);
    hash.bytes(&memory.arena[..local.start.min(memory.arena.len())]);
    hash.bytes(&memory.arena[local.end.min(memory.arena.len())..]);
    for timer in &machine.timers {
        let flags = [timer.running, timer.status, timer.start_edge, timer.enable_edge];
        let flags = flags.iter().fold(timer.kind as u64, |bits, &flag| bits << 1 | u64::from(flag));
        hash.add(flags << 32 | u64::from(timer.base) << 16 | u64::from(timer.value));
        hash.add(timer.started_us);
    }
    for counter in &machine.counters {
        let edges = [counter.set_edge, counter.up_edge, counter.down_edge, counter.enable_edge];
        hash.add(edges.iter().fold(u64::from(counter.count), |bits, &edge| bits << 1 | u64::from(edge)));
    }
    hash.0
}

struct Hash(u64);

impl Hash {
    fn add(&mut self, word: u64) {
        self.0 = mix(self.0 ^ word);
    }

    fn bytes(&mut self, bytes: &[u8]) {
        let (words, rest) = bytes.as_chunks::<8>();
        words.iter().for_each(|word| self.add(u64::from_le_bytes(*word)));
        let mut last = [0; 8];
        last[..rest.len()].copy_from_slice(rest);
        self.add(u64::from_le_bytes(last));
    }
}
