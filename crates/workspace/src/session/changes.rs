//! What a statement has changed: values of memory, timers and counters, registers.

use std::ops::Range;

use sieben_cpu::Moment;
use sieben_engine::machine::{Register, Registers};
use sieben_engine::{Machine, Program};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::item::Item;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::value::{Content, Kind};
use sieben_sim::names::Name;

/// Changes of memory that are told; a block move changes more than a person reads.
const CHANGES_MAX: usize = 32;

/// Something that has changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// What.
    pub name: String,
    /// Its value before.
    pub before: String,
    /// Its value now.
    pub after: String,
}

/// What differs between two machines; `written` is the operand of the statement, if it has one that means a single value.
/// `fields` are the variables of data blocks that are called by their names. Hidden local data, which the compiler needs for calls, are left
/// out: they have no name in the source.
pub(super) fn of_memory(
    before: &Machine,
    after: &Machine,
    written: Option<&Name>,
    fields: &[Name],
    program: &Program,
    mnemonics: Mnemonics,
) -> Vec<Change> {
    let mut changes = Vec::new();
    let mut covered: Vec<Range<usize>> = Vec::new();
    // Where a variable of a block lies is known before the statement: it may call or end the block.
    let registers = &before.registers;
    if let Some((name, (range, _))) = written.and_then(|name| Some((name, name.extent(before, registers)?)))
        && let Some(old) = name.shown_in(before, registers)
        && let Some(new) = name.shown_in(after, registers)
        && old != new
    {
        covered.push(range);
        changes.push(Change { name: name.text().to_owned(), before: old.readable(), after: new.readable() });
    }
    let (old, new) = (&before.memory.arena, &after.memory.arena);
    for field in fields {
        let Some((range, mask)) = field.extent(after, registers) else { continue };
        let differs = || {
            old.get(range.clone()).zip(new.get(range.clone())).is_some_and(|(old, new)| match (old, new) {
                ([old], [new]) => (old ^ new) & mask != 0,
                _ => old != new,
            })
        };
        if changes.len() >= CHANGES_MAX || !differs() || covered.iter().any(|known| mask == u8::MAX && known.contains(&range.start)) {
            continue;
        }
        if let Some((old, new)) = field.shown_in(before, registers).zip(field.shown_in(after, registers)) {
            changes.push(Change { name: field.text().to_owned(), before: old.readable(), after: new.readable() });
            covered.push(range);
        }
    }
    let covers = |byte: usize| covered.iter().any(|range| range.contains(&byte));
    let mut at = 0;
    let length = old.len().min(new.len());
    while at < length && changes.len() < CHANGES_MAX {
        // Most of the memory is the same: pieces are compared, not bytes.
        let piece = (length - at).min(256);
        if at.is_multiple_of(256) && old[at..at + piece] == new[at..at + piece] {
            at += piece;
            continue;
        }
        if old[at] == new[at] || covers(at) {
            at += 1;
            continue;
        }
        let run = (at..length.min(at + 4)).take_while(|&byte| old[byte] != new[byte] && !covers(byte)).count();
        if !is_hidden(after, at, program) {
            changes.extend(bytes(after, at, if run == 3 { 2 } else { run }, old, new, mnemonics));
        }
        at += if run == 3 { 2 } else { run };
    }
    for (number, (old, new)) in (0_u16..).zip(before.timers.iter().zip(&after.timers)) {
        if old != new && changes.len() < CHANGES_MAX {
            let shown = |machine: &Machine, timer: &sieben_engine::machine::Timer| {
                let mut timer = timer.clone();
                timer.refresh(machine.clock_us);
                let state = if timer.running { "running" } else { "stopped" };
                let item = Item::operand(Operand::Timer(number)).readable();
                let left =
                    Moment { machine, registers: &machine.registers }.content(&item).map(|content| item.kind.show(&content).readable());
                format!("{} ({state}, {})", left.unwrap_or_default(), u8::from(timer.status))
            };
            let (before, after) = (shown(before, old), shown(after, new));
            // Of a timer that has run out, only what it remembers may be new.
            if before != after {
                changes.push(Change { name: Operand::Timer(number).spell(mnemonics), before, after });
            }
        }
    }
    for (number, (old, new)) in (0_u16..).zip(before.counters.iter().zip(&after.counters)) {
        if old.count != new.count && changes.len() < CHANGES_MAX {
            changes.push(Change {
                name: Operand::Counter(number).spell(mnemonics),
                before: old.count.to_string(),
                after: new.count.to_string(),
            });
        }
    }
    changes
}

/// Whether an arena byte is one of the local data that the block has not declared.
fn is_hidden(machine: &Machine, at: usize, program: &Program) -> bool {
    let local = &machine.memory.layout.local;
    let Some(at) = local.contains(&at).then(|| at - local.start) else { return false };
    let frame = machine.frames.iter().rev().find(|frame| frame.local_base as usize <= at);
    frame.is_some_and(|frame| {
        let declared = program.code.get(&frame.block).map_or(0, |code| code.interface.local_size as usize);
        at - frame.local_base as usize >= declared
    })
}

/// Bytes next to each other that have changed, under the address that people give them.
fn bytes(machine: &Machine, at: usize, count: usize, old: &[u8], new: &[u8], mnemonics: Mnemonics) -> Option<Change> {
    let layout = &machine.memory.layout;
    let width = match count {
        1 => Width::Byte,
        2 => Width::Word,
        _ => Width::DoubleWord,
    };
    let areas = [(Area::Input, &layout.inputs), (Area::Output, &layout.outputs), (Area::BitMemory, &layout.bit_memory)];
    let in_area = areas.into_iter().find(|(_, range)| range.contains(&at)).map(|(area, range)| (None, area, at - range.start));
    let in_local = || {
        layout.local.contains(&at).then(|| {
            let base = machine.frames.iter().rev().map(|frame| frame.local_base as usize).find(|&base| base <= at - layout.local.start);
            (None, Area::Local, at - layout.local.start - base.unwrap_or_default())
        })
    };
    let in_block = || {
        machine.memory.data_blocks.iter().enumerate().find_map(|(number, entry)| {
            let entry = entry.as_ref()?;
            let range = entry.base as usize..(entry.base + entry.length) as usize;
            range.contains(&at).then(|| (Some(number as u16), Area::SharedData, at - range.start))
        })
    };
    let (db, area, byte) = in_area.or_else(in_local).or_else(in_block)?;
    let flipped = old[at] ^ new[at];
    let (width, bit) = if count == 1 && flipped.count_ones() == 1 { (Width::Bit, flipped.trailing_zeros() as u8) } else { (width, 0) };
    let address = Address { area, width, byte: byte as u32, bit };
    let operand = db.map_or(Operand::Address(address), |db| Operand::InDataBlock { db, address });
    let value = |bytes: &[u8]| match width {
        Width::Bit => (bytes[at] >> bit & 1).to_string(),
        _ => {
            let bits = bytes[at..at + width.bytes() as usize].iter().fold(0, |bits, &byte| bits << 8 | u64::from(byte));
            Kind::Bits(width.bits()).show(&Content::Bits(bits)).readable()
        }
    };
    Some(Change { name: operand.spell(mnemonics), before: value(old), after: value(new) })
}

/// Registers as people call them, in the order of the columns, with their values.
pub(super) fn registers(registers: &Registers, accumulators: u8) -> Vec<(&'static str, String)> {
    let bit = |value: u64| (value & 1).to_string();
    let hex = |value: u64| format!("16#{:08X}", value as u32);
    let number = |value: u64| if value == 0 { "-".to_owned() } else { value.to_string() };
    let mut all = vec![
        ("RLO", bit(registers.rlo)),
        ("STA", bit(registers.sta)),
        ("/FC", bit(registers.fc)),
        ("OR", bit(registers.or)),
        ("CC", format!("{}{}", registers.cc1 & 1, registers.cc0 & 1)),
        ("OV", bit(registers.ov)),
        ("OS", bit(registers.os)),
        ("BR", bit(registers.br)),
        ("ACCU1", hex(registers.accu1)),
        ("ACCU2", hex(registers.accu2)),
    ];
    if accumulators > 2 {
        all.extend([("ACCU3", hex(registers.accu3)), ("ACCU4", hex(registers.accu4))]);
    }
    all.extend([
        ("AR1", pointer(registers.get(Register::Ar1))),
        ("AR2", pointer(registers.get(Register::Ar2))),
        ("DB", number(registers.db_number)),
        ("DI", number(registers.di_number)),
    ]);
    all
}

/// `P#12.3`, or all digits if an area stands in it.
fn pointer(value: u64) -> String {
    let value = value as u32;
    if value >> 24 == 0 { format!("P#{}.{}", value >> 3, value & 7) } else { format!("16#{value:08X}") }
}

/// Registers that differ.
pub(super) fn of_registers(before: &Registers, after: &Registers, accumulators: u8) -> Vec<Change> {
    let both = registers(before, accumulators).into_iter().zip(registers(after, accumulators));
    both.filter(|((_, before), (_, after))| before != after)
        .map(|((name, before), (_, after))| Change { name: name.to_owned(), before, after })
        .collect()
}
