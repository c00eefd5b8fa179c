//! SFB 41 to 43 against the formulas of their diagrams, written once more in f64.

use proptest::prelude::*;
use sieben_model::cpu_type::CpuType;

use super::fuzz::with_host;
use super::instance::Instance;
use super::{Call, sfb041_cont_c, sfb042_cont_s, sfb043_pulsegen};

/// Runs a block once and reads from its instance, which begins at DB 1.
fn run(call: &mut Call<'_, '_>, row: &super::Row, before: impl FnOnce(&mut Instance<'_>)) {
    let mut instance = Instance::open(call.machine, 200).expect("DB 1 is long enough");
    before(&mut instance);
    row.run(call);
    assert_eq!(call.machine.registers.br, 1, "{} has its instance", row.name);
}

fn read<T>(call: &mut Call<'_, '_>, get: impl FnOnce(&Instance<'_>) -> T) -> T {
    get(&Instance::open(call.machine, 200).expect("DB 1 is long enough"))
}

/// A PID controller: the continuous laws, sampled by the trapezoid rule (I) and as a lag (D).
#[derive(Default)]
struct Pid {
    integral: f64,
    lagged: f64,
    product: f64,
    limited: [bool; 2],
}

/// Seconds: cycle, TI, TD, TM_LAG.
struct Times([f64; 4]);

impl Pid {
    fn step(&mut self, error: f64, gain: f64, &Times([cycle, ti, td, lag]): &Times, limits: [f64; 2]) -> f64 {
        let product = gain * error;
        let step = cycle / ti.max(cycle / 2.0) * (product + self.product) / 2.0;
        if !(step > 0.0 && self.limited[1] || step < 0.0 && self.limited[0]) {
            self.integral += step;
        }
        self.product = product;
        let derivative = (product - self.lagged) * td.max(cycle) / (cycle / 2.0 + lag.max(cycle / 2.0));
        self.lagged += derivative * cycle / td.max(cycle);
        let sum = product + self.integral + derivative;
        self.limited = [sum <= limits[0], sum >= limits[1]];
        sum.clamp(limits[0], limits[1])
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn cont_c_is_the_controller_of_its_diagram(
        gain in -8.0..8.0_f32,
        times in [10_i32..2000, 10..60_000, 10..60_000, 10..10_000],
        setpoints in prop::collection::vec(-50.0..50.0_f32, 1..40),
    ) {
        with_host(&CpuType::ALL[0], &[0], &[], 0, |call| {
            let mut model = Pid::default();
            let seconds = Times(times.map(|ms| f64::from(ms) / 1000.0));
            for setpoint in setpoints {
                run(call, &sfb041_cont_c::ROW, |instance| {
                    // P_SEL, I_SEL and D_SEL.
                    instance.set_byte(0, 0b1001_1000);
                    instance.set_real(6, setpoint);
                    instance.set_real(20, gain);
                    for (byte, ms) in [2, 24, 28, 32].into_iter().zip(times) {
                        instance.set_time(byte, ms);
                    }
                    for (byte, value) in [(40, 100.0), (44, -100.0), (56, 1.0)] {
                        instance.set_real(byte, value);
                    }
                });
                let wanted = model.step(f64::from(setpoint), f64::from(gain), &seconds, [-100.0, 100.0]);
                let (found, limited) = read(call, |instance| (f64::from(instance.real(72)), instance.byte(78)));
                // Next to a limit rounding decides whether it is reached, and the integral action with it.
                if (wanted.abs() - 100.0).abs() < 0.01 && found.abs() != wanted.abs() {
                    return;
                }
                assert!((found - wanted).abs() <= 0.01 + wanted.abs() * 1e-3, "{found} is not {wanted}");
                assert_eq!([limited & 2 != 0, limited & 1 != 0], model.limited);
            }
        });
    }

    #[test]
    fn a_period_of_pulsegen_has_as_many_calls_with_a_pulse_as_its_share(
        percent in -150.0..150.0_f32,
        calls in 2_i32..200,
        cycle in 1_i32..500,
        shortest in 0_i32..100,
    ) {
        with_host(&CpuType::ALL[0], &[0], &[], 0, |call| {
            let period = calls * cycle;
            let mut counted = [0, 0];
            // The second period: it has to be like the first.
            for number in 0..2 * calls {
                run(call, &sfb043_pulsegen::ROW, |instance| {
                    instance.set_real(0, percent);
                    instance.set_time(4, period);
                    instance.set_time(8, shortest);
                    instance.set_real(12, 1.0);
                    // STEP3_ON.
                    instance.set_byte(16, 1);
                    instance.set_time(18, cycle);
                });
                let outputs = read(call, |instance| [instance.bit(22, 0), instance.bit(22, 1)]);
                assert_ne!(outputs, [true, true]);
                if number >= calls {
                    counted = [counted[0] + i32::from(outputs[0]), counted[1] + i32::from(outputs[1])];
                }
            }
            let share = |percent: f64| {
                let ms = (percent / 100.0).clamp(0.0, 1.0) * f64::from(period);
                let ms = if ms < f64::from(shortest) { 0.0 } else if ms > f64::from(period - shortest) { f64::from(period) } else { ms };
                ms / f64::from(cycle)
            };
            for (counted, percent) in counted.into_iter().zip([f64::from(percent), -f64::from(percent)]) {
                // A pulse is as long as the calls in which it has begun.
                assert!((f64::from(counted) - share(percent)).abs() <= 1.01, "{counted} calls are not {}", share(percent));
            }
        });
    }

    #[test]
    fn cont_s_brings_the_valve_to_where_it_is_wanted(wanted in -80.0..80.0_f32, cycle in 100_i32..1000) {
        with_host(&CpuType::ALL[0], &[0], &[], 0, |call| {
            // With gain 1 and no integral action the valve should move by as many percent as the error has.
            let mut position = 0.0;
            let travel = 100.0 * cycle as f32 / 60_000.0;
            let mut last = [false, false];
            for _ in 0..2000 {
                position += if last[0] { travel } else if last[1] { -travel } else { 0.0 };
                run(call, &sfb042_cont_s::ROW, |instance| {
                    instance.set_byte(0, 0);
                    instance.set_time(2, cycle);
                    instance.set_real(6, wanted);
                    instance.set_real(16, 1.0);
                    instance.set_time(20, i32::MAX);
                    instance.set_time(36, cycle);
                    instance.set_time(40, cycle);
                    instance.set_time(44, 60_000);
                });
                let next = read(call, |instance| [instance.bit(52, 0), instance.bit(52, 1)]);
                assert_ne!(next, [true, true]);
                last = next;
            }
            // The integral action of 2000 calls is below a percent; the dead zone is half of a pulse.
            assert!((position - wanted).abs() <= travel + 1.0, "{position} is not {wanted}");
        });
    }
}
