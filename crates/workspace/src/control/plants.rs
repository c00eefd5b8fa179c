//! The simulated plants of a run at one moment: their bytes, what only they know, their faults and their terminals.

use serde_json::{Value as Json, json};
use sieben_cpu::IoModule;
use sieben_model::address::Operand;
use sieben_sim::wrap;

use super::facts::Facts;
use super::table::direction;
use crate::gate::{Closed, Gate};

/// Plants in one answer.
const PLANTS_MAX: usize = 100;

/// A plant with its faults.
#[derive(Clone, Debug)]
pub struct PlantFaults {
    /// Its name.
    pub module: String,
    /// What it is.
    pub kind: &'static str,
    /// The signals that can fail.
    pub signals: Vec<&'static str>,
    /// Its faults, as they are injected.
    pub faults: Vec<String>,
}

/// A plant at one moment.
#[derive(Clone, Debug)]
pub struct PlantView {
    /// Its name.
    pub module: String,
    /// What it is.
    pub kind: &'static str,
    /// Its first input byte.
    pub input: u32,
    /// Its first output byte.
    pub output: u32,
    /// Its parameters, in the order of its kind.
    pub parameters: Vec<f64>,
    /// Its input bytes as the CPU reads them.
    pub inputs: Vec<u8>,
    /// Its output bytes as the CPU wrote them.
    pub outputs: Vec<u8>,
    /// What only the plant knows: name, value, unit.
    pub state: Vec<(&'static str, f64, &'static str)>,
    /// Its faults, as they are injected.
    pub faults: Vec<String>,
    /// Its terminals.
    pub signals: Vec<SignalView>,
}

/// A terminal of a plant.
#[derive(Clone, Debug)]
pub struct SignalView {
    /// What faults call it.
    pub name: &'static str,
    /// Its address.
    pub address: String,
    /// Which way it goes.
    pub direction: &'static str,
    /// The symbol of the address.
    pub symbol: Option<String>,
    /// What it says.
    pub about: &'static str,
}

pub(super) fn plant_faults(plant: &wrap::Plant) -> PlantFaults {
    PlantFaults {
        module: plant.name().to_owned(),
        kind: plant.kind().name,
        signals: plant.kind().signals.iter().map(|signal| signal.name).collect(),
        faults: plant.faults().map(ToString::to_string).collect(),
    }
}

fn view(plant: &wrap::Plant) -> PlantView {
    let kind = plant.kind();
    let mut inputs = vec![0; kind.input_bytes as usize];
    plant.read(0, &mut inputs);
    let signal = |signal: &'static sieben_sim::devices::Signal| SignalView {
        name: signal.name,
        address: signal.address(if signal.is_input() { plant.inputs().start } else { plant.outputs().start }),
        direction: direction(signal.direction),
        symbol: None,
        about: signal.about,
    };
    PlantView {
        module: plant.name().to_owned(),
        kind: kind.name,
        input: plant.inputs().start,
        output: plant.outputs().start,
        parameters: plant.device().settings().parameters.clone(),
        inputs,
        outputs: plant.commands().to_vec(),
        state: plant.device().state(),
        faults: plant.faults().map(ToString::to_string).collect(),
        signals: kind.signals.iter().map(signal).collect(),
    }
}

/// All plants of a run.
pub(super) fn plants(gate: &Gate, facts: &Facts) -> Result<Vec<PlantView>, Closed> {
    let mut views: Vec<PlantView> = gate.enter(|plant| wrap::plants(plant.cpu.rack()).take(PLANTS_MAX).map(view).collect())?;
    for signal in views.iter_mut().flat_map(|view| &mut view.signals) {
        let operand = Operand::parse(&signal.address);
        signal.symbol = operand.and_then(|operand| facts.symbols.find_operand(&operand)).map(|symbol| symbol.name.clone());
    }
    Ok(views)
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02X}")).collect()
}

impl PlantFaults {
    pub(super) fn json(&self) -> Json {
        json!({ "module": self.module, "kind": self.kind, "signals": self.signals, "faults": self.faults })
    }
}

impl PlantView {
    pub(super) fn json(&self) -> Json {
        let state = |&(name, value, unit): &(&str, f64, &str)| json!({ "name": name, "value": value, "unit": unit });
        let signal = |signal: &SignalView| {
            json!({
                "name": signal.name, "address": signal.address, "direction": signal.direction, "symbol": signal.symbol, "about": signal.about,
            })
        };
        json!({
            "module": self.module, "kind": self.kind, "input": self.input, "output": self.output, "parameters": self.parameters,
            "inputs": hex(&self.inputs), "outputs": hex(&self.outputs), "state": self.state.iter().map(state).collect::<Json>(),
            "faults": self.faults, "signals": self.signals.iter().map(signal).collect::<Json>(),
        })
    }
}
