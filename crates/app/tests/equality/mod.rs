//! Programs that mean the same: a statement list and diagrams of it run side by side over the values of what they read, and their memory is compared after every scan.

use std::collections::BTreeSet;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use sieben_cpu::{Cpu, Settings, Station};
use sieben_engine::machine::{Counter, Machine, Timer};
use sieben_engine::{Layout, Program};
use sieben_lang::stl::ast::{self, Block};
use sieben_lang::stl::parser::parse;
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::cpu_type::CpuType;
use sieben_model::literal::Value;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::FileId;

use super::program;

/// Inputs up to so many bits are tried in all combinations.
const ALL_COMBINATIONS_BITS: usize = 16;

/// Inputs up to so many bits are tried with every change from one combination to another.
const ALL_CHANGES_BITS: usize = 6;

/// Distances from one combination to the next.
const STRIDES: [usize; 4] = [0x9E35, 0x5555, 0x6D3B, 0x7FFF];

/// Rows of a program that reads words, or more bits than that.
const EDGE_ROWS: usize = 2048;

/// From one row to the next: timers run out on the way.
const STEP_US: u64 = 70_000;

/// A program under its name.
pub(crate) type Variant = (String, Arc<Program>, Settings);

/// Where the areas lie that programs share; local data are their own affair.
fn areas(layout: &Layout) -> Vec<(String, std::ops::Range<usize>)> {
    let mut areas = vec![
        ("inputs".to_owned(), layout.inputs.clone()),
        ("outputs".to_owned(), layout.outputs.clone()),
        ("bit memory".to_owned(), layout.bit_memory.clone()),
    ];
    areas.extend(layout.data_blocks.iter().map(|(number, range)| (format!("DB {number}"), range.clone())));
    areas
}

/// What a machine holds, as one number for each area, timers and counters.
pub(crate) fn fingerprint(machine: &Machine) -> Vec<(String, u64)> {
    let hash = |value: &dyn Fn(&mut DefaultHasher)| {
        let mut hasher = DefaultHasher::new();
        value(&mut hasher);
        hasher.finish()
    };
    let mut all: Vec<(String, u64)> = areas(&machine.memory.layout)
        .into_iter()
        .map(|(name, range)| (name, hash(&|hasher| machine.memory.arena[range.clone()].hash(hasher))))
        .collect();
    // Those that were never touched are all alike, and there are hundreds of them.
    let timers = machine.timers.iter().enumerate().filter(|(_, timer)| **timer != Timer::default());
    let counters = machine.counters.iter().enumerate().filter(|(_, counter)| **counter != Counter::default());
    let (timers, counters) = (format!("{:?}", timers.collect::<Vec<_>>()), format!("{:?}", counters.collect::<Vec<_>>()));
    all.push(("timers".to_owned(), hash(&|hasher| timers.hash(hasher))));
    all.push(("counters".to_owned(), hash(&|hasher| counters.hash(hasher))));
    all
}

/// The first thing that two machines do not have in common.
fn difference(one: &Machine, other: &Machine) -> Option<String> {
    let (mine, yours) = (areas(&one.memory.layout), areas(&other.memory.layout));
    for ((name, at), (other_name, other_at)) in mine.into_iter().zip(yours) {
        let (left, right) = (&one.memory.arena[at], &other.memory.arena[other_at]);
        if name != other_name || left.len() != right.len() {
            return Some(format!("{name} and {other_name} are no pair"));
        }
        if left != right {
            let byte = left.iter().zip(right).position(|(left, right)| left != right).unwrap_or(0);
            return Some(format!("byte {byte} of the {name} is {:#04x}, not {:#04x}", right[byte], left[byte]));
        }
    }
    let timer = one.timers.iter().zip(&other.timers).position(|(left, right)| left != right);
    let counter = one.counters.iter().zip(&other.counters).position(|(left, right)| left != right);
    timer.map(|number| format!("T {number} differs")).or(counter.map(|number| format!("C {number} differs")))
}

/// What a program reads from outside: operands at constant addresses of I, Q and M that it does not write, and values worth trying for words.
#[derive(Debug, Default)]
pub(crate) struct Inputs {
    /// All of them, bits first.
    operands: Vec<Operand>,
    bits: usize,
    values: Vec<u32>,
}

impl Inputs {
    /// The inputs of a statement list in English mnemonics.
    pub(crate) fn of(stl: &str) -> Self {
        let (mut read, mut written, mut constants) = (BTreeSet::new(), Vec::new(), BTreeSet::new());
        for block in parse(FileId::default(), stl, Some(Mnemonics::English)).file.blocks {
            accesses(&block, &mut read, &mut written, &mut constants);
        }
        read.retain(|address| !written.iter().any(|other| overlap(address, other)));
        let mut read: Vec<Address> = read.into_iter().collect();
        read.sort_by_key(|address| address.width != Width::Bit);
        let bits = read.iter().filter(|address| address.width == Width::Bit).count();
        let near = constants.into_iter().flat_map(|value: u32| [value.wrapping_sub(1), value, value.wrapping_add(1)]);
        let edges = [0, 1, 0x12, 0x999, 0x7FFF, 0x8000, 0xFFFF, 0x7FFF_FFFF, 0x8000_0000, 0xFFFF_FFFF, 0x3F80_0000];
        let values: BTreeSet<u32> = near.chain(edges).collect();
        Self { operands: read.into_iter().map(Operand::Address).collect(), bits, values: values.into_iter().collect() }
    }

    /// Values of all operands, row by row, in an order that brings edges.
    pub(crate) fn rows(&self) -> Vec<Vec<u32>> {
        let words = self.operands.len() - self.bits;
        let bits_of = |combination: usize| (0..self.bits).map(|bit| (combination >> bit & 1) as u32).collect::<Vec<_>>();
        if words == 0 && self.bits <= ALL_COMBINATIONS_BITS {
            let all = 1_usize << self.bits;
            let order: Vec<usize> = match self.bits <= ALL_CHANGES_BITS {
                true => (0..all).flat_map(|from| (from + 1..all).flat_map(move |to| [from, to])).chain([all - 1, 0]).collect(),
                // One bit at a time, then many at once: an odd factor reaches every combination.
                false => {
                    let strides = (0..all)
                        .map(|row| row ^ row >> 1)
                        .chain(STRIDES.iter().flat_map(|stride| (0..all).map(move |row| row * stride % all)));
                    strides.collect()
                }
            };
            return order.into_iter().map(bits_of).collect();
        }
        let mut random = 0x2545_F491_4F6C_DD1D_u64;
        let mut next = || {
            random ^= random << 13;
            random ^= random >> 7;
            random ^= random << 17;
            (random >> 11) as usize
        };
        let row = |_| {
            let mut row = bits_of(next());
            row.extend((0..words).map(|_| self.values[next() % self.values.len()]));
            row
        };
        (0..EDGE_ROWS).map(row).collect()
    }
}

/// What the statements of a block read and write.
fn accesses(block: &Block, read: &mut BTreeSet<Address>, written: &mut Vec<Address>, constants: &mut BTreeSet<u32>) {
    for statement in &block.statements {
        let word = statement.mnemonic.text.to_ascii_uppercase();
        match &statement.operand {
            ast::Operand::Constant(constant) => constants.extend(constant.value.as_ref().and_then(bits)),
            ast::Operand::Call(call) => {
                for argument in &call.arguments {
                    let address = address(&argument.value);
                    // What a call does with bit memory depends on the block; setting it from outside is right for both.
                    match address {
                        Some(address) if address.area == Area::Output => written.push(address),
                        _ => read.extend(address),
                    }
                }
            }
            operand => match word.as_str() {
                "=" | "S" | "R" | "T" | "FP" | "FN" => written.extend(address(operand)),
                _ => read.extend(address(operand)),
            },
        }
    }
}

/// The bits of a constant that a word may be compared with.
fn bits(value: &Value) -> Option<u32> {
    match value {
        Value::Int(value) => Some(*value as u16 as u32),
        Value::DoubleInt(value) => Some(*value as u32),
        Value::Word(value) => Some(u32::from(*value)),
        _ => None,
    }
}

/// An address in I, Q or M.
fn address(operand: &ast::Operand) -> Option<Address> {
    let ast::Operand::Absolute { letters, number, bit } = operand else { return None };
    let mut letter = letters.chars();
    let area = match letter.next()? {
        'I' => Area::Input,
        'Q' => Area::Output,
        'M' => Area::BitMemory,
        _ => return None,
    };
    let width = match letter.as_str() {
        "" => Width::Bit,
        "B" => Width::Byte,
        "W" => Width::Word,
        "D" => Width::DoubleWord,
        _ => return None,
    };
    Some(Address { area, width, byte: u32::try_from(*number).ok()?, bit: u8::try_from(bit.unwrap_or(0)).ok()? })
}

fn overlap(one: &Address, other: &Address) -> bool {
    let bits = |address: &Address| {
        let first = address.byte * 8 + u32::from(address.bit);
        first..first + if address.width == Width::Bit { 1 } else { address.width.bytes() * 8 }
    };
    let (one_bits, other_bits) = (bits(one), bits(other));
    one.area == other.area && one_bits.start < other_bits.end && other_bits.start < one_bits.end
}

fn spell(operand: &Operand) -> String {
    match operand {
        Operand::Address(address) => address.spell(Mnemonics::English),
        other => format!("{other:?}"),
    }
}

/// Runs all programs over all rows and says where the first of the others does something else than the first.
pub(crate) fn first_difference(variants: &[Variant], inputs: &Inputs, cpu_type: &'static CpuType) -> Option<String> {
    let start = |(name, program, settings): &Variant, (engine, load): &(&str, program::Load)| {
        let mut cpu = program::cpu_with(program, cpu_type, *load, None, settings.clone());
        cpu.restart(sieben_cpu::Restart::Warm);
        (format!("{name}, {engine}"), cpu)
    };
    let fresh =
        || variants.iter().flat_map(|variant| program::ENGINES.iter().map(move |engine| start(variant, engine))).collect::<Vec<_>>();
    let mut cpus: Vec<(String, Cpu)> = fresh();
    let mut now_us = 0;
    for row in inputs.rows() {
        for (name, cpu) in &mut cpus {
            for (operand, value) in inputs.operands.iter().zip(&row) {
                let width = match operand {
                    Operand::Address(address) if address.width != Width::Bit => address.width.bytes() * 8,
                    _ => 32,
                };
                let value = if width < 32 { value & ((1 << width) - 1) } else { *value };
                if let Err(error) = cpu.modify(operand, value) {
                    return Some(format!("[{name}] {operand:?} cannot be set: {error}"));
                }
            }
            cpu.scan(now_us);
        }
        now_us += STEP_US;
        let (first, others) = cpus.split_first()?;
        for (name, cpu) in others {
            let differs = match first.1.mode() == cpu.mode() {
                true => difference(first.1.machine(), cpu.machine()),
                false => Some(format!("the CPU is in {:?}, not in {:?}", cpu.mode(), first.1.mode())),
            };
            if let Some(differs) = differs {
                let given: Vec<String> =
                    inputs.operands.iter().zip(&row).map(|(operand, value)| format!("{}={value:#x}", spell(operand))).collect();
                return Some(format!("[{name}] after a scan with {} {differs} as with {}", given.join(" "), first.0));
            }
        }
        // A program may stop the CPU; it begins anew.
        if first.1.mode() != sieben_cpu::OperatingMode::Run {
            cpus = fresh();
            now_us = 0;
        }
    }
    None
}
