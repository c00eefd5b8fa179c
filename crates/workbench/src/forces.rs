//! Why operands are forced: who did it when, and the reason that was given, for everyone to see.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, Mutex};

use serde_json::{Value as Json, json};
use sieben_cpu::Station;
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::mnemonics::Mnemonics;

use crate::hub::Hub;
use crate::lock;

/// Bits whose reasons are kept.
const REASONS_MAX: usize = 8_192;
/// Longest reason, in bytes.
pub(crate) const REASON_BYTES_MAX: usize = 500;

/// A reason with where it came from.
#[derive(Clone, Debug)]
pub(crate) struct Reason {
    /// The reason as it was written.
    pub(crate) text: String,
    /// The peer that forced.
    pub(crate) by: String,
    /// The time of the CPU.
    pub(crate) since: String,
    /// The last scan before.
    pub(crate) scan: u64,
}

/// A bit: its area, byte and number.
type Bit = (Area, u32, u8);

/// Reasons by bit: a word is forced as bytes, and a byte can be forced bit by bit.
#[derive(Default)]
pub(crate) struct Forces(Mutex<BTreeMap<Bit, Arc<Reason>>>);

/// A bit or byte that is forced.
struct Forced {
    address: Address,
    value: u8,
}

impl Forces {
    /// Keeps the reason for an address.
    pub(crate) fn note(&self, address: Address, reason: Reason) {
        let (mut reasons, reason) = (lock(&self.0), Arc::new(reason));
        for bit in bits(address) {
            if reasons.len() < REASONS_MAX || reasons.contains_key(&bit) {
                reasons.insert(bit, Arc::clone(&reason));
            }
        }
    }

    /// Another CPU runs: nothing is forced there yet.
    pub(crate) fn forget(&self) {
        lock(&self.0).clear();
    }

    /// What is forced, with what is at the terminal, and why.
    pub(crate) fn json(&self, hub: &Hub) -> Json {
        let facts = hub.facts.facts();
        // What is noted from now on belongs to a force that may not be seen yet.
        let mut reasons = lock(&self.0);
        let Ok(forced) = hub.gate.look(|plant| {
            let forced: Vec<Forced> = plant.cpu.forced().bytes().flat_map(|byte| parts(byte, &reasons)).collect();
            let terminal = |forced: &Forced| {
                // The process image has what is forced; what the module has is peripheral.
                let area = match forced.address.area {
                    Area::Input => Area::PeripheralInput,
                    Area::Output => Area::PeripheralOutput,
                    area => area,
                };
                let byte = Address { area, width: Width::Byte, byte: forced.address.byte, bit: 0 };
                let value = plant.cpu.read(&Operand::Address(byte)).ok()?;
                Some(if forced.address.width == Width::Bit { value >> forced.address.bit & 1 } else { value })
            };
            let terminals: Vec<Option<u32>> = forced.iter().map(terminal).collect();
            forced.into_iter().zip(terminals).collect::<Vec<_>>()
        }) else {
            return json!([]);
        };
        // A reason ends with its force, by whatever way that ended.
        let held: BTreeSet<Bit> = forced.iter().flat_map(|(one, _)| bits(one.address)).collect();
        reasons.retain(|bit, _| held.contains(bit));
        let row = |(forced, terminal): &(Forced, Option<u32>)| {
            let symbol =
                facts.symbols.find_operand(&Operand::Address(forced.address)).map_or_else(String::new, |symbol| symbol.name.clone());
            let shown = |value: u32| if forced.address.width == Width::Bit { value.to_string() } else { format!("16#{value:02X}") };
            let reason = bits(forced.address).next().and_then(|bit| reasons.get(&bit));
            json!({
                "name": symbol, "address": forced.address.spell(Mnemonics::English), "value": shown(u32::from(forced.value)), "terminal": terminal.map(shown),
                "reason": reason.map_or("", |reason| &reason.text), "by": reason.map_or("", |reason| &reason.by),
                "since": reason.map_or("", |reason| &reason.since), "n": reason.map(|reason| reason.scan),
            })
        };
        forced.iter().map(row).collect()
    }
}

/// The bits of an address.
fn bits(Address { area, width, byte, bit }: Address) -> impl Iterator<Item = Bit> {
    let numbers = if width == Width::Bit { bit..bit + 1 } else { 0..8 };
    (byte..byte.saturating_add(width.bytes())).flat_map(move |byte| numbers.clone().map(move |bit| (area, byte, bit)))
}

/// A whole byte, or its forced bits; a byte whose bits are forced for different reasons is shown bit by bit.
fn parts((area, byte, mask, value): (Area, u32, u8, u8), reasons: &BTreeMap<Bit, Arc<Reason>>) -> Vec<Forced> {
    let whole = Address { area, width: Width::Byte, byte, bit: 0 };
    let reason = |bit: u8| reasons.get(&(area, byte, bit)).map(Arc::as_ptr);
    if mask == u8::MAX && (1..8).all(|bit| reason(bit) == reason(0)) {
        return vec![Forced { address: whole, value }];
    }
    let forced = (0..8_u8).filter(|bit| mask >> bit & 1 == 1);
    forced.map(|bit| Forced { address: Address { width: Width::Bit, bit, ..whole }, value: value >> bit & 1 }).collect()
}
