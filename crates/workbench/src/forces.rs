//! Why operands are forced: who did it when, and the reason that was given, for everyone to see.

use std::collections::BTreeMap;
use std::sync::Mutex;

use serde_json::{Value as Json, json};
use sieben_cpu::Station;
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::mnemonics::Mnemonics;

use crate::hub::Hub;
use crate::lock;

/// Reasons that are kept.
const REASONS_MAX: usize = 1_000;
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

/// Reasons by address.
#[derive(Default)]
pub(crate) struct Forces(Mutex<BTreeMap<String, Reason>>);

/// A bit or byte that is forced.
struct Forced {
    address: Address,
    value: u8,
}

impl Forces {
    /// Keeps the reason for an address.
    pub(crate) fn note(&self, address: String, reason: Reason) {
        let mut reasons = lock(&self.0);
        if reasons.len() < REASONS_MAX || reasons.contains_key(&address) {
            reasons.insert(address, reason);
        }
    }

    /// Another CPU runs: nothing is forced there yet.
    pub(crate) fn forget(&self) {
        lock(&self.0).clear();
    }

    /// What is forced, with what is at the terminal, and why.
    pub(crate) fn json(&self, hub: &Hub) -> Json {
        let facts = hub.facts.facts();
        let Ok(forced) = hub.gate.look(|plant| {
            let forced: Vec<Forced> = plant.cpu.forced().bytes().flat_map(parts).collect();
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
        let mut reasons = lock(&self.0);
        let spelled = |forced: &Forced| forced.address.spell(Mnemonics::English);
        // A reason ends with its force, by whatever way that ended.
        reasons.retain(|address, _| forced.iter().any(|(one, _)| spelled(one) == *address));
        let row = |(forced, terminal): &(Forced, Option<u32>)| {
            let address = spelled(forced);
            let symbol =
                facts.symbols.find_operand(&Operand::Address(forced.address)).map_or_else(String::new, |symbol| symbol.name.clone());
            let shown = |value: u32| if forced.address.width == Width::Bit { value.to_string() } else { format!("16#{value:02X}") };
            let reason = reasons.get(&address);
            json!({
                "name": symbol, "address": address, "value": shown(u32::from(forced.value)), "terminal": terminal.map(shown),
                "reason": reason.map_or("", |reason| &reason.text), "by": reason.map_or("", |reason| &reason.by),
                "since": reason.map_or("", |reason| &reason.since), "n": reason.map(|reason| reason.scan),
            })
        };
        forced.iter().map(row).collect()
    }
}

/// A whole byte, or its forced bits.
fn parts((area, byte, mask, value): (Area, u32, u8, u8)) -> Vec<Forced> {
    if mask == u8::MAX {
        return vec![Forced { address: Address { area, width: Width::Byte, byte, bit: 0 }, value }];
    }
    let bits = (0..8_u8).filter(|bit| mask >> bit & 1 == 1);
    bits.map(|bit| Forced { address: Address { area, width: Width::Bit, byte, bit }, value: value >> bit & 1 }).collect()
}
