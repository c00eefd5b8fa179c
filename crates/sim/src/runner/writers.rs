//! Which statement changed a variable last.

use std::ops::Range;

use sieben_cpu::Cpu;
use sieben_engine::machine::Memory;
use sieben_engine::{FaultPlace, Machine, StatementEvent, Tracer};
use sieben_model::address::Area;
use sieben_model::testing::Signal;

use super::Watcher;

/// The statement that changed a variable last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Written {
    /// The statement.
    pub place: FaultPlace,
    /// Scans that had been begun by then, 0 = before the first one.
    pub scan: u64,
    /// The CPU clock in microseconds.
    pub time_us: u64,
}

/// Compares the bytes of variables before and after every statement of a run in the interpreter.
#[derive(Debug, Default)]
pub struct Writers {
    spots: Vec<Spot>,
    /// The last statement of each block that runs, the calling one first.
    running: Vec<FaultPlace>,
    scan: u64,
    /// A restart clears memory, which no statement has done.
    restarts: bool,
}

#[derive(Debug)]
struct Spot {
    bytes: Range<usize>,
    /// The bits that belong to the variable.
    mask: u8,
    before: Vec<u8>,
    written: Option<Written>,
}

impl Writers {
    /// Looks at these variables of a CPU that was just loaded. One that has no place is never written.
    pub fn new(signals: &[Signal], cpu: &Cpu) -> Self {
        let memory = &cpu.machine().memory;
        let spots = signals.iter().map(|signal| {
            let bytes = place(signal, memory).unwrap_or(0..0);
            let bit = signal.address.width == sieben_model::address::Width::Bit;
            let mask = if bit { 1 << (signal.address.bit & 7) } else { 0xFF };
            Spot { before: memory.arena[bytes.clone()].to_vec(), bytes, mask, written: None }
        });
        Self { spots: spots.collect(), ..Self::default() }
    }

    /// Who wrote each variable last, in the order given.
    pub fn written(&self) -> impl Iterator<Item = Option<Written>> {
        self.spots.iter().map(|spot| spot.written)
    }

    /// What changes between two statements is nobody's: inputs are read, the clock memory goes on, a restart clears.
    fn settle(&mut self, machine: &Machine) {
        self.running.clear();
        for spot in &mut self.spots {
            spot.before.copy_from_slice(&machine.memory.arena[spot.bytes.clone()]);
        }
    }

    /// What has changed since the last look was changed by this statement.
    fn look(&mut self, machine: &Machine, place: FaultPlace) {
        let (scan, time_us) = (self.scan, machine.clock_us);
        for spot in &mut self.spots {
            let now = &machine.memory.arena[spot.bytes.clone()];
            if now.iter().zip(&spot.before).any(|(now, before)| (now ^ before) & spot.mask != 0) {
                spot.written = Some(Written { place, scan, time_us });
            }
            spot.before.copy_from_slice(now);
        }
    }

    /// Whether a block is among those that run; then those that it called have ended.
    fn back_in(&mut self, place: &FaultPlace) -> bool {
        let Some(index) = self.running.iter().rposition(|running| running.block == place.block) else { return false };
        self.running.truncate(index + 1);
        true
    }
}

/// The bytes of a variable in the arena.
fn place(signal: &Signal, memory: &Memory) -> Option<Range<usize>> {
    let first = match signal.data_block {
        Some(number) => {
            let block = memory.data_block(u64::from(number))?;
            let end = u64::from(signal.address.byte) + u64::from(signal.address.width.bytes());
            (end <= u64::from(block.length)).then_some(block.base as usize)?
        }
        None => match signal.address.area {
            Area::Input | Area::Output | Area::BitMemory => {
                let area = memory.layout.area(signal.address.area)?;
                let end = signal.address.byte as usize + signal.address.width.bytes() as usize;
                (end <= area.len()).then_some(area.start)?
            }
            _ => return None,
        },
    };
    let start = first + signal.address.byte as usize;
    let bytes = start..start + signal.address.width.bytes() as usize;
    (bytes.end <= memory.arena.len()).then_some(bytes)
}

impl Tracer for Writers {
    fn statement(&mut self, machine: &Machine, event: &StatementEvent) {
        if std::mem::take(&mut self.restarts) {
            return self.settle(machine);
        }
        self.look(machine, event.place);
        match self.back_in(&event.place) {
            true => self.running.pop(),
            false => None,
        };
        self.running.push(event.place);
    }

    /// What a call gives a block, and what it takes back when the block has ended, is written between two statements: by the call.
    fn pauses_before(&mut self, machine: &Machine, place: FaultPlace) -> bool {
        let same_block = self.running.last().is_none_or(|last| last.block == place.block);
        if !same_block && !self.restarts {
            self.back_in(&place);
            if let Some(&call) = self.running.last() {
                self.look(machine, call);
            }
        }
        false
    }
}

impl Watcher for Writers {
    fn before_scan(&mut self, cpu: &Cpu) {
        self.scan += 1;
        self.settle(cpu.machine());
    }
    fn before_restart(&mut self) {
        self.restarts = true;
    }
    fn restarted(&mut self, cpu: &Cpu) {
        self.restarts = false;
        self.settle(cpu.machine());
    }
    fn tracer(&mut self) -> Option<&mut dyn Tracer> {
        Some(self)
    }
}
