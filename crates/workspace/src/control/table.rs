//! The assignment table as people who operate a program need it: symbols, addresses, comments, and who drives an input.

use serde_json::{Value as Json, json};
use sieben_cpu::{Cpu, IoModule, Station};
use sieben_model::address::{Address, Area, Operand};
use sieben_model::item::Item;
use sieben_model::mnemonics::Mnemonics;
use sieben_sim::devices::{Direction, Operated, Place, Signal};
use sieben_sim::names::{Name, catalogue};
use sieben_sim::wrap;

use super::facts::Facts;
use crate::gate::{Closed, Gate};
use crate::observed::Watched;

/// Rows in one answer.
const ROWS_MAX: usize = 1_000;
/// Fields of data blocks in the table: those of a small program, and not all of a large one.
const FIELDS_MAX: usize = 300;

/// A part of the assignment table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    /// How many rows there are.
    pub total: usize,
    /// Where the list goes on.
    pub next: Option<usize>,
    /// The rows.
    pub rows: Vec<Row>,
}

/// A row of the assignment table: something that has a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// The symbol; empty if there is none.
    pub symbol: String,
    /// The address, with English mnemonics.
    pub address: String,
    /// What can be asked for to read it.
    pub item: String,
    /// The data type of the symbol as it is written.
    pub data_type: String,
    /// The comment.
    pub comment: String,
    /// Whose terminal it is, if a plant has one there.
    pub terminal: Option<Terminal>,
}

/// A terminal of a plant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Terminal {
    /// The plant, as the project calls it.
    pub module: String,
    /// What faults call the signal.
    pub signal: &'static str,
    /// Which way it goes.
    pub direction: &'static str,
    /// What people do with it, if it is theirs.
    pub operated: Option<&'static str>,
}

/// The word for a direction.
pub(super) fn direction(direction: Direction) -> &'static str {
    match direction {
        Direction::Sensor => "sensor",
        Direction::Hand { .. } => "hand",
        Direction::Actuator => "actuator",
    }
}

/// The word for what people do with a signal that is theirs.
pub(super) fn operated(direction: Direction) -> Option<&'static str> {
    match direction {
        Direction::Hand { operated: Operated::Button, .. } => Some("button"),
        Direction::Hand { operated: Operated::Switch, .. } => Some("switch"),
        Direction::Sensor | Direction::Actuator => None,
    }
}

/// The bits of a signal among all bytes of its direction: the first one, and how many.
fn bits(signal: &Signal, base: u32) -> (u64, u64) {
    let at = |byte: u32| u64::from(base.saturating_add(byte)) * 8;
    match signal.place {
        Place::Bit(byte, bit) => (at(byte) + u64::from(bit), 1),
        Place::Word(byte) => (at(byte), 16),
    }
}

/// The terminal of a plant that has a bit in common with an input or output; a sensor before all others.
fn terminal(cpu: &Cpu, address: &Address) -> Option<Terminal> {
    let is_input = matches!(address.area, Area::Input | Area::PeripheralInput);
    if !is_input && !matches!(address.area, Area::Output | Area::PeripheralOutput) {
        return None;
    }
    let first = u64::from(address.byte) * 8 + u64::from(address.bit);
    let end = first + u64::from(address.width.bits());
    let mut found = None;
    for plant in wrap::plants(cpu.rack()) {
        let base = if is_input { plant.inputs().start } else { plant.outputs().start };
        for signal in plant.device().signals().iter().filter(|signal| signal.is_input() == is_input) {
            let (begin, count) = bits(signal, base);
            if begin < end && first < begin + count {
                let terminal = || Terminal {
                    module: plant.name().to_owned(),
                    signal: signal.name,
                    direction: direction(signal.direction),
                    operated: operated(signal.direction),
                };
                if signal.direction == Direction::Sensor {
                    return Some(terminal());
                }
                found.get_or_insert_with(terminal);
            }
        }
    }
    found
}

/// The row of what has no symbol.
fn without_symbol(operand: &Operand) -> (Operand, Row) {
    let address = operand.spell(Mnemonics::English);
    let row =
        Row { symbol: String::new(), item: address.clone(), address, data_type: String::new(), comment: String::new(), terminal: None };
    (*operand, row)
}

/// Symbol, address, item, type and comment of all that has a value: the table of symbols, then what the program uses without a symbol.
fn known(facts: &Facts) -> impl Iterator<Item = (Operand, Row)> + '_ {
    let of_symbol = |symbol: &sieben_model::symbols::Symbol| {
        let operand = symbol.operand().filter(|operand| !matches!(operand, Operand::Block(_)))?;
        let address = operand.spell(Mnemonics::English);
        let quoted = format!("\"{}\"", symbol.name);
        let is_called = Name::parse(&quoted, &facts.symbols, &facts.program).is_ok_and(|name| name.operand() == Some(&operand));
        let row = Row {
            symbol: symbol.name.clone(),
            item: if is_called { quoted } else { address.clone() },
            address,
            data_type: symbol.data_type.clone(),
            comment: symbol.comment.clone(),
            terminal: None,
        };
        Some((operand, row))
    };
    facts.symbols.symbols().iter().filter_map(of_symbol).chain(facts.used.iter().map(without_symbol))
}

/// Fields of data blocks that are of at most 64 bits: variables of ST, values of the program.
fn fields(facts: &Facts) -> impl Iterator<Item = (Item, Row)> {
    let fields = catalogue(&facts.symbols, &facts.program).into_iter().filter(|name| name.data_block().is_some());
    let short = fields.filter(|name| matches!(name.item().width(), 1..=64));
    short.take(FIELDS_MAX).map(|name| {
        let text = name.text().to_owned();
        let row = Row {
            symbol: String::new(),
            address: text.clone(),
            item: text,
            data_type: name.kind().type_word().unwrap_or_default(),
            comment: String::new(),
            terminal: None,
        };
        (name.item().clone(), row)
    })
}

/// What people operate at the plants: the terminals that are theirs, by their addresses.
fn hands(cpu: &Cpu) -> Vec<Operand> {
    let of_plant = |plant: &wrap::Plant| {
        let base = plant.inputs().start;
        let hands = plant.device().signals().iter().filter(|signal| matches!(signal.direction, Direction::Hand { .. }));
        hands.filter_map(|signal| Operand::parse(&signal.address(base))).collect::<Vec<_>>()
    };
    wrap::plants(cpu.rack()).flat_map(of_plant).take(ROWS_MAX).collect()
}

/// The assignment table; `from` rows are left out.
pub(super) fn table(gate: &Gate, facts: &Facts, from: usize) -> Result<Table, Closed> {
    let known: Vec<(Operand, Row)> = known(facts).collect();
    let is_new = |operand: &Operand| !known.iter().any(|(other, _)| other == operand);
    let hands = gate.look(|plant| hands(&plant.cpu))?;
    let hands: Vec<(Operand, Row)> = hands.iter().filter(|operand| is_new(operand)).map(without_symbol).collect();
    let rows = known.into_iter().chain(hands).map(|(operand, row)| (Item::operand(operand), row));
    let all: Vec<(Item, Row)> = rows.chain(fields(facts)).collect();
    let total = all.len();
    let rows = gate.look_for_each(all.into_iter().skip(from).take(ROWS_MAX), |plant, (item, row)| {
        let terminal = match item.as_operand() {
            Some(Operand::Address(address)) => terminal(&plant.cpu, address),
            _ => None,
        };
        // What this CPU does not have has no value.
        let is_there = plant.cpu.read_items(std::slice::from_ref(&item)).iter().all(Result::is_ok);
        is_there.then_some(Row { terminal, ..row })
    })?;
    let next = from.saturating_add(rows.len());
    Ok(Table { total, next: (next < total).then_some(next), rows: rows.into_iter().flatten().collect() })
}

/// What is compared from scan to scan: without the clock memory, which changes by itself.
pub fn watched(facts: &Facts) -> Vec<Watched> {
    let watched = |(operand, row): (Operand, Row)| {
        let named = Name::parse(&row.item, &facts.symbols, &facts.program).ok();
        let item = named.map_or_else(|| Item::operand(operand), |name| name.readable().item().clone());
        Watched { name: row.symbol, address: row.address, comment: row.comment, item: item.readable() }
    };
    let is_clock = |operand: &Operand| matches!(operand, Operand::Address(Address { area: Area::BitMemory, byte, .. }) if Some(*byte) == facts.clock_memory_byte);
    known(facts).filter(|(operand, _)| !is_clock(operand)).map(watched).collect()
}

impl Table {
    /// The fields of the answer.
    pub(super) fn json(&self) -> Json {
        let terminal = |terminal: &Terminal| json!({ "module": terminal.module, "signal": terminal.signal, "direction": terminal.direction, "operated": terminal.operated });
        let row = |row: &Row| {
            json!({
                "symbol": row.symbol, "address": row.address, "item": row.item, "type": row.data_type, "comment": row.comment,
                "terminal": row.terminal.as_ref().map(terminal),
            })
        };
        json!({ "total": self.total, "next": self.next, "rows": self.rows.iter().map(row).collect::<Json>() })
    }
}
