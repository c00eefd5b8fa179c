//! The simulated plants of a run at one moment: their bytes, what only they know, their faults and their terminals.

use serde_json::{Value as Json, json};
use sieben_cpu::{IoModule, Rack};
use sieben_model::address::Operand;
use sieben_model::problems::Problem;
use sieben_sim::devices::Signal;
use sieben_sim::wrap::{self, Fault};

use super::facts::Facts;
use super::request::{FaultChange, shortened};
use super::table::{direction, operated};
use crate::gate::{Closed, Gate};
use crate::refusal::Refusal;

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
    /// Those of them whose time it is.
    pub acting: Vec<String>,
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
    /// What people do with it, if it is theirs.
    pub operated: Option<&'static str>,
    /// The symbol of the address.
    pub symbol: Option<String>,
    /// What it says.
    pub about: &'static str,
}

fn plant_faults(plant: &wrap::Plant) -> PlantFaults {
    PlantFaults {
        module: plant.name().to_owned(),
        kind: plant.kind().name,
        signals: plant.device().signals().iter().map(|signal| signal.name).collect(),
        faults: plant.faults().map(ToString::to_string).collect(),
    }
}

/// Injects a fault or mends one, if that is asked for; the plants with their faults.
pub(super) fn faults(gate: &Gate, change: &FaultChange) -> Result<Vec<PlantFaults>, Refusal> {
    let refused = |message: String| Refusal::new(Problem::P6272, message);
    let all = |rack: &Rack| wrap::plants(rack).map(plant_faults).collect();
    let changed = |change: &dyn Fn(&mut Rack) -> Result<(), Refusal>| {
        gate.enter(|plant| change(plant.cpu.rack_mut()).map(|()| all(plant.cpu.rack())))?
    };
    match change {
        FaultChange::None => Ok(gate.look(|plant| all(plant.cpu.rack()))?),
        FaultChange::Inject(text) => {
            let fault = Fault::parse(text).map_err(refused)?;
            changed(&|rack| wrap::inject(rack, &fault).map_err(refused))
        }
        FaultChange::Mend(name) => changed(&|rack| wrap::mend(rack, name).map_err(|message| refused(shortened(&message)))),
    }
}

/// A plant as it is now; `put_out` are all bytes that the CPU has put out, some of which a plant may show that are not its own.
fn view(plant: &wrap::Plant, put_out: &[u8]) -> PlantView {
    let mut inputs = vec![0; plant.inputs().len()];
    plant.read(0, &mut inputs);
    let signal = |signal: &Signal| SignalView {
        name: signal.name,
        address: signal.address(if signal.is_input() { plant.inputs().start } else { plant.outputs().start }),
        direction: direction(signal.direction),
        operated: operated(signal.direction),
        symbol: None,
        about: signal.about,
    };
    PlantView {
        module: plant.name().to_owned(),
        kind: plant.kind().name,
        input: plant.inputs().start,
        output: plant.outputs().start,
        parameters: plant.device().settings().parameters.clone(),
        inputs,
        outputs: plant.commands().to_vec(),
        state: plant.device().state().into_iter().chain(plant.device().shown(put_out)).collect(),
        faults: plant.faults().map(ToString::to_string).collect(),
        acting: plant.acting_faults().map(ToString::to_string).collect(),
        signals: plant.device().signals().iter().map(signal).collect(),
    }
}

/// All plants of a run.
pub(super) fn plants(gate: &Gate, facts: &Facts) -> Result<Vec<PlantView>, Closed> {
    let mut views: Vec<PlantView> = gate.look(|plant| {
        let rack = plant.cpu.rack();
        wrap::plants(rack).take(PLANTS_MAX).map(|plant| view(plant, rack.outputs())).collect()
    })?;
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
                "name": signal.name, "address": signal.address, "direction": signal.direction, "operated": signal.operated, "symbol": signal.symbol, "about": signal.about,
            })
        };
        json!({
            "module": self.module, "kind": self.kind, "input": self.input, "output": self.output, "parameters": self.parameters,
            "inputs": hex(&self.inputs), "outputs": hex(&self.outputs), "state": self.state.iter().map(state).collect::<Json>(),
            "faults": self.faults, "acting": self.acting, "signals": self.signals.iter().map(signal).collect::<Json>(),
        })
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use sieben_cpu::{Cpu, Settings};
    use sieben_engine::Interpreter;
    use sieben_model::cpu_type::CpuType;

    use super::*;
    use crate::gate::Plant;
    use crate::pace::{Pace, Speed};

    #[test]
    fn to_ask_for_faults_is_no_change_of_the_run() {
        let cpu_type = &CpuType::ALL[0];
        let rack = Rack::with_background(cpu_type, Vec::new()).expect("an empty rack");
        let cpu = Cpu::load(cpu_type, Arc::default(), Interpreter::load, rack, Settings::default());
        let gate = Gate::new(Plant::new(cpu, Pace::new(Speed::Max, 10_000, u64::MAX, 0)), Box::new(|| 0));
        let is_touched = || gate.look(|plant| plant.touched).expect("the gate is open");
        assert!(faults(&gate, &FaultChange::None).is_ok_and(|plants| plants.is_empty()) && !is_touched());
        assert!(faults(&gate, &FaultChange::Mend("tank".to_owned())).is_err() && is_touched());
    }
}
