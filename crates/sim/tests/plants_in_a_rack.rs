//! The dosing plant behind a CPU.

use std::sync::Arc;

use sieben_cpu::{Cpu, IoModule, OperatingMode, Rack, Restart, Settings, Station};
use sieben_engine::{Interpreter, Program};
use sieben_model::address::Operand;
use sieben_model::cpu_type::CpuType;
use sieben_sim::devices::{Button, DosingPlant, DosingSettings};

fn operand(text: &str) -> Operand {
    Operand::parse(text).expect("an operand")
}

fn plant(settings: DosingSettings) -> Result<Cpu, sieben_cpu::RackError> {
    let cpu_type = CpuType::by_name("315-2PN/DP").expect("a CPU type");
    let program = Arc::new(Program::default());
    let rack = Rack::with_background(cpu_type, vec![Box::new(DosingPlant::new(settings))])?;
    Ok(Cpu::load(cpu_type, program, Interpreter::load, rack, Settings::default()))
}

#[test]
fn an_hour_of_dosing_gives_one_pulse_per_litre() {
    let mut cpu = plant(DosingSettings { supply_litres: 100_000, ..DosingSettings::default() }).expect("a rack");
    cpu.restart(Restart::Warm);
    cpu.modify(&operand("Q 0.0"), 1).expect("an output");
    cpu.modify(&operand("QW 4"), 0x1234).expect("an output");
    let (mut pulses, mut last) = (0, 0);
    for scan in 0..360_000 {
        cpu.scan(scan * 10_000);
        let pulse = cpu.read(&operand("I 0.7")).expect("an input");
        pulses += u64::from(pulse == 1 && last == 0);
        last = pulse;
    }
    let tank: &DosingPlant = cpu.rack().module().expect("the tank");
    assert_eq!(pulses, tank.litres_delivered() as u64);
    assert!((17_000..19_000).contains(&pulses), "{pulses} litres at 5 l/s");
    assert_eq!(tank.display_number(), Some(1234));
}

#[test]
fn buttons_reach_the_process_image_and_stop_closes_the_valve() {
    let mut cpu = plant(DosingSettings::default()).expect("a rack");
    cpu.restart(Restart::Warm);
    cpu.modify(&operand("Q 0.0"), 1).expect("an output");
    cpu.modify(&operand("I 1.0"), 1).expect("an input of the simulated rest");
    cpu.rack_mut().module_mut::<DosingPlant>().expect("the tank").press(Button::Start);
    cpu.scan(0);
    assert_eq!(cpu.read(&operand("IW 0")), Ok(0x0301));
    assert!(cpu.rack().module::<DosingPlant>().expect("the tank").valve_open());
    Station::stop(&mut cpu);
    assert!(!cpu.rack().module::<DosingPlant>().expect("the tank").valve_open());
    assert_eq!(Station::mode(&cpu), OperatingMode::Stop);
}

#[test]
fn a_tank_beyond_the_area_is_refused() {
    for (input, output) in [(2048, 0), (0, 2043), (u32::MAX, 0), (0, u32::MAX)] {
        let settings = DosingSettings { input, output, ..DosingSettings::default() };
        assert_eq!(DosingPlant::new(settings.clone()).name(), "tank");
        assert_eq!(plant(settings).err().map(|error| error.problem().code()), Some("P8003"), "{input}, {output}");
    }
}
