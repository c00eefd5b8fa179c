//! Interrupts in numbers: storms, every class inside every lower one, whatever mixture.

mod script;

use proptest::prelude::*;
use script::{Step, cpu_of};
use sieben_cpu::interrupts::{ModuleAddress, StatusKind};
use sieben_cpu::{Cpu, CyclicInterrupt, Interrupt, OperatingMode, Restart, Settings, Station, TimeSource};
use sieben_model::address::Operand;

/// Every block that an event can start on a 416-3, lowest class first.
fn blocks() -> Vec<u16> {
    let mut blocks: Vec<u16> = (10..=87).filter(|&number| Interrupt::usual(number).is_some()).collect();
    blocks.sort_by_key(|&number| sieben_cpu::organization_blocks::priority(sieben_model::block::BlockId::ob(number)));
    blocks
}

fn interrupt(number: u16) -> Interrupt {
    Interrupt::usual(number).unwrap_or_else(|| panic!("an event starts OB {number}"))
}

fn value(cpu: &Cpu, text: &str) -> u32 {
    cpu.read(&Operand::parse(text).expect("an operand")).expect("a value")
}

#[test]
fn every_class_interrupts_every_lower_one() {
    let priority = |number: u16| sieben_cpu::organization_blocks::priority(sieben_model::block::BlockId::ob(number));
    let mut classes = blocks();
    classes.dedup_by_key(|number| priority(*number));
    assert!(classes.len() > 20, "{classes:?}");
    let steps = |number: u16| vec![Step::Loop(5), Step::Nest, Step::Loop(1000), Step::Record(number)];
    let steps: Vec<(u16, Vec<Step>)> = [1].into_iter().chain(classes.iter().copied()).map(|number| (number, steps(number))).collect();
    let refs: Vec<(u16, &[Step])> = steps.iter().map(|(number, steps)| (*number, steps.as_slice())).collect();
    let mut cpu = cpu_of("416-3", &refs, Settings::default());
    cpu.restart(Restart::Warm);
    for (index, &number) in classes.iter().enumerate() {
        cpu.raise_at_safe_point(10 + 10 * index as u64, interrupt(number));
    }
    cpu.scan(0);
    assert_eq!(cpu.mode(), OperatingMode::Run, "{:?}", Cpu::stop_cause(&cpu));
    // Each began while all lower ones were still running, and they ended in the opposite order.
    assert_eq!(value(&cpu, "MW0"), classes.len() as u32 + 1, "blocks nested");
    let ended: Vec<u32> = (0..=classes.len()).map(|index| value(&cpu, &format!("MB{}", 10 + index))).collect();
    let expected: Vec<u32> = classes.iter().rev().copied().chain([1]).map(u32::from).collect();
    assert_eq!(ended, expected);
}

#[test]
fn a_storm_ends_in_a_time_error() {
    for (with_ob_80, event) in [(false, 0x3507), (true, 0x3501)] {
        let mut blocks: Vec<(u16, &[Step])> = vec![(1, &[Step::Loop(2_000_000)]), (40, &[Step::Loop(40)])];
        if with_ob_80 {
            blocks.push((80, &[]));
        }
        let mut cpu = cpu_of("416-3", &blocks, Settings { virtual_safe_points: 20_000, ..Settings::default() });
        cpu.restart(Restart::Warm);
        for point in 1..=60_000 {
            cpu.raise_at_safe_point(point, interrupt(40));
        }
        cpu.scan(0);
        let cause = Cpu::stop_cause(&cpu).expect("a STOP");
        assert_eq!((cause.event, cause.first_event), (0x4568, event), "OB 80 loaded: {with_ob_80}");
        assert!(cpu.diagnostic_buffer().entries().any(|entry| entry.event() == 0x3507), "OB 80 loaded: {with_ob_80}");
    }
}

/// A clock that moves on by a step whenever it is read.
fn ticking(step_us: u64) -> impl FnMut() -> u64 {
    let mut now_us = 0;
    move || {
        now_us += step_us;
        now_us
    }
}

#[test]
fn in_real_time_the_background_fills_the_pause_and_goes_on_in_the_next() {
    let settings = || Settings { time: TimeSource::Real, min_cycle: std::time::Duration::from_millis(50), ..Settings::default() };
    // Too long for one pause: it ends at the time of the next cycle and keeps its place.
    let mut cpu = cpu_of("416-3", &[(1, &[Step::Count]), (90, &[Step::Set("MB1", 7), Step::Forever])], settings());
    let mut clock = ticking(1000);
    cpu.restart_with(Restart::Warm, &mut clock, None);
    for pause in 1..=3_u64 {
        cpu.scan_with(&mut clock, None);
        let until_us = pause * 50_000;
        cpu.background_with(until_us, &mut clock);
        assert_eq!(cpu.mode(), OperatingMode::Run, "{:?}", Cpu::stop_cause(&cpu));
        let end_us = clock();
        assert!((until_us..until_us + 10_000).contains(&end_us), "pause {pause} ended at {end_us} us");
        assert_eq!(value(&cpu, "MB1"), if pause == 1 { 7 } else { 0 }, "OB 90 does not begin again");
        cpu.modify(&Operand::parse("MB1").expect("an operand"), 0).expect("bit memory");
    }
    // A short one begins again and again until the time has come.
    let mut cpu = cpu_of("416-3", &[(1, &[]), (90, &[Step::Copy("MB2", "MB3"), Step::Record(90)])], settings());
    let mut clock = ticking(5000);
    cpu.restart_with(Restart::Warm, &mut clock, None);
    cpu.scan_with(&mut clock, None);
    cpu.background_with(100_000, &mut clock);
    let count = value(&cpu, "MB9");
    assert!((3..40).contains(&count), "{count} turns of OB 90");
}

#[test]
fn in_real_time_interrupts_come_inside_the_background() {
    let settings = Settings {
        time: TimeSource::Real,
        min_cycle: std::time::Duration::from_millis(1),
        cyclic: [(35, CyclicInterrupt { interval_ms: 100, phase_ms: 0 })].into(),
        ..Settings::default()
    };
    let blocks: &[(u16, &[Step])] = &[(1, &[]), (35, &[Step::Record(35), Step::Nest]), (90, &[Step::Forever])];
    let mut cpu = cpu_of("416-3", blocks, settings);
    let mut clock = ticking(1000);
    cpu.restart_with(Restart::Warm, &mut clock, None);
    cpu.scan_with(&mut clock, None);
    cpu.background_with(1_050_000, &mut clock);
    assert_eq!(cpu.mode(), OperatingMode::Run, "{:?}", Cpu::stop_cause(&cpu));
    assert!((9..=10).contains(&value(&cpu, "MB9")), "OB 35 has run {} times in 1 s", value(&cpu, "MB9"));
    assert!(cpu.machine().frames.is_empty(), "OB 90 is put away while the cycle runs");
}

#[test]
fn the_three_interrupts_of_a_dpv1_slave_have_events_of_their_own() {
    for (kind, number) in [(StatusKind::Status, 55), (StatusKind::Update, 56), (StatusKind::Manufacturer, 57)] {
        let event = Interrupt::status(kind, ModuleAddress::Input(4), [1, 2, 3, 4]).start_information().event;
        assert_eq!(event, interrupt(number).start_information().event, "OB {number}");
        assert_eq!(event, 0x1155 + (number - 55), "OB {number}");
    }
}

/// A CPU with OB 90 that never ends, in real time whose clock moves 20 µs whenever it is asked. OB 35 comes every 10 ms.
fn with_background(ob_35: &[Step]) -> (Cpu, impl FnMut() -> u64 + use<>) {
    let settings = Settings {
        time: TimeSource::Real,
        watchdog: std::time::Duration::from_millis(5),
        min_cycle: std::time::Duration::from_millis(100),
        cyclic: [(35, CyclicInterrupt { interval_ms: 10, phase_ms: 0 })].into(),
        ..Settings::default()
    };
    let blocks: [(u16, &[Step]); 3] = [(1, &[Step::Record(3)]), (35, ob_35), (90, &[Step::Forever])];
    let mut cpu = cpu_of("416-3", &blocks, settings);
    let mut now_us = 0;
    let mut clock = move || {
        now_us += 20;
        now_us
    };
    cpu.restart_with(Restart::Warm, &mut clock, None);
    (cpu, clock)
}

#[test]
fn an_interrupt_of_the_background_ends_before_the_next_cycle() {
    let (mut cpu, mut clock) = with_background(&[Step::Record(1), Step::Loop(1), Step::Loop(10_000), Step::Record(2)]);
    // OB 35 lasts 200 µs: the pause ends in the middle of it.
    cpu.background_with(10_100, &mut clock);
    cpu.scan_with(&mut clock, None);
    let recorded: Vec<u32> = (10..13).map(|byte| value(&cpu, &format!("MB{byte}"))).collect();
    assert_eq!(recorded, [1, 2, 3]);
    assert_eq!(cpu.mode(), OperatingMode::Run);
}

#[test]
fn a_clock_that_jumps_makes_one_event_of_all_that_no_block_serves() {
    let settings =
        Settings { time: TimeSource::Real, cyclic: [(35, CyclicInterrupt { interval_ms: 1, phase_ms: 0 })].into(), ..Settings::default() };
    let mut cpu = cpu_of("416-3", &[(1, &[]), (85, &[Step::Record(85)])], settings);
    cpu.restart_with(Restart::Warm, &mut || 0, None);
    // The computer slept for an hour, and OB 35 is configured but not loaded.
    cpu.serve_with(&mut || 3_600_000_000, None);
    assert_eq!((cpu.mode(), value(&cpu, "MB9")), (OperatingMode::Run, 1));
    cpu.serve_with(&mut || 3_600_001_000, None);
    assert_eq!(value(&cpu, "MB9"), 2);
}

#[test]
fn the_watchdog_sees_an_interrupt_of_the_background() {
    let (mut cpu, mut clock) = with_background(&[Step::Forever]);
    cpu.background_with(18_000, &mut clock);
    assert_eq!(Cpu::stop_cause(&cpu).map(|cause| (cause.event, cause.first_event)), Some((0x4568, 0x3501)));
}

#[test]
fn hold_in_the_background_ends_with_the_next_scan_to_come() {
    for hot in [false, true] {
        let (mut cpu, mut clock) = with_background(&[]);
        cpu.background_with(500, &mut clock);
        cpu.stop_request().hold();
        cpu.background_with(900, &mut clock);
        assert_eq!(cpu.mode(), OperatingMode::Hold);
        if hot {
            cpu.restart_with(Restart::Hot, &mut clock, None);
        } else {
            cpu.resume_with(&mut clock, None);
        }
        assert_eq!(cpu.mode(), OperatingMode::Run);
        assert!(cpu.scan_with(&mut clock, None).executed);
        assert_eq!(value(&cpu, "MB10"), 3);
        cpu.background_with(12_000, &mut clock);
        assert_eq!(cpu.mode(), OperatingMode::Run);
    }
}

#[derive(Clone, Debug)]
enum Action {
    Scan(u64),
    Raise(usize),
    At(u64, usize),
    Restart(Restart),
    Hold,
    Resume,
    Reset,
}

fn action() -> impl Strategy<Value = Action> {
    prop_oneof![
        4 => (0_u64..300_000).prop_map(Action::Scan),
        3 => any::<prop::sample::Index>().prop_map(|index| Action::Raise(index.index(blocks().len()))),
        3 => (1_u64..60, any::<prop::sample::Index>()).prop_map(|(point, index)| Action::At(point, index.index(blocks().len()))),
        1 => prop_oneof![Just(Restart::Warm), Just(Restart::Hot), Just(Restart::Cold)].prop_map(Action::Restart),
        1 => Just(Action::Hold),
        1 => Just(Action::Resume),
        1 => Just(Action::Reset),
    ]
}

fn steps() -> impl Strategy<Value = Vec<Step>> {
    let step = prop_oneof![
        (1_u64..40).prop_map(Step::Loop),
        Just(Step::Count),
        Just(Step::Sfc(41)),
        Just(Step::Sfc(42)),
        Just(Step::Sfc(43)),
        Just(Step::Sfc(46)),
        Just(script::programming(0x22)),
        Just(script::read_error(5000)),
        Just(Step::Fault(sieben_engine::Fault::Abort(sieben_engine::Abort::NestingStack))),
    ];
    prop::collection::vec(step, 0..4)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn no_mixture_of_interrupts_hangs_or_panics(
        programs in prop::collection::vec((any::<prop::sample::Index>(), steps()), 0..12),
        actions in prop::collection::vec(action(), 1..20),
        cpu_type in prop_oneof![Just("315-2PN/DP"), Just("416-3")],
        interval_ms in 0_u16..50,
    ) {
        let numbers: Vec<u16> = [1, 1, 1, 80, 82, 85, 88, 90, 100, 101, 121, 122].into_iter().chain(blocks()).collect();
        let mut programs: Vec<(u16, Vec<Step>)> = programs.into_iter().map(|(index, steps)| (*index.get(&numbers), steps)).collect();
        // OB 90 may take as long as it likes.
        for (_, steps) in programs.iter_mut().filter(|one| one.0 == 90) {
            steps.push(Step::Forever);
        }
        let refs: Vec<(u16, &[Step])> = programs.iter().map(|(number, steps)| (*number, steps.as_slice())).collect();
        let settings = Settings {
            virtual_safe_points: 2000,
            min_cycle: std::time::Duration::from_millis(5),
            cyclic: [(35, CyclicInterrupt { interval_ms, phase_ms: 3 })].into(),
            ..Settings::default()
        };
        let mut cpu = cpu_of(cpu_type, &refs, settings);
        cpu.restart(Restart::Warm);
        let mut now_us = 0;
        for action in actions {
            match action {
                Action::Scan(us) => {
                    now_us += us;
                    cpu.scan(now_us);
                }
                Action::Raise(index) => cpu.raise(interrupt(blocks()[index])),
                Action::At(point, index) => cpu.raise_at_safe_point(point, interrupt(blocks()[index])),
                Action::Restart(kind) => {
                    cpu.restart(kind);
                }
                Action::Hold => cpu.stop_request().hold(),
                Action::Resume => {
                    cpu.resume(now_us);
                }
                Action::Reset => cpu.memory_reset(),
            }
            if cpu.mode() != OperatingMode::Hold {
                prop_assert!(cpu.machine().frames.is_empty(), "{:?}", cpu.machine().frames);
            }
            prop_assert!((cpu.mode() == OperatingMode::Stop) == Cpu::stop_cause(&cpu).is_some());
        }
    }
}
