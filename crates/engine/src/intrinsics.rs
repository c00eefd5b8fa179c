//! Functions over the machine that both engines call: what is larger than an expression.

use sieben_model::bcd;

use crate::fault::Fault;
use crate::machine::{Machine, TimerKind};

/// One function over the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Intrinsic {
    /// Starts a timer: number, RLO, S5TIME word.
    TimerStart(TimerKind),
    /// Resets a timer if the RLO is 1: number, RLO.
    TimerReset,
    /// FR: number, RLO.
    TimerEnable,
    /// Status bit of a timer: number.
    TimerStatus,
    /// Remaining value of a timer, binary: number.
    TimerValue,
    /// Remaining value of a timer with time base, BCD: number.
    TimerBcd,
    /// CU: number, RLO.
    CounterUp,
    /// CD: number, RLO.
    CounterDown,
    /// S: number, RLO, BCD preset.
    CounterSet,
    /// Resets a counter if the RLO is 1: number, RLO.
    CounterReset,
    /// FR: number, RLO.
    CounterEnable,
    /// Whether the count is not 0: number.
    CounterStatus,
    /// The count, binary: number.
    CounterValue,
    /// The count, BCD: number.
    CounterBcd,
    /// Milliseconds that the CPU has spent in STARTUP and RUN, modulo 2^32.
    Clock,
}

impl Intrinsic {
    /// How many arguments it takes.
    pub fn arity(self) -> usize {
        match self {
            Self::TimerStart(_) | Self::CounterSet => 3,
            Self::TimerReset | Self::TimerEnable | Self::CounterUp | Self::CounterDown | Self::CounterReset | Self::CounterEnable => 2,
            Self::Clock => 0,
            Self::TimerStatus | Self::TimerValue | Self::TimerBcd | Self::CounterStatus | Self::CounterValue | Self::CounterBcd => 1,
        }
    }

    /// Runs it. A failed one has changed nothing.
    ///
    /// # Errors
    /// A timer or counter number that the CPU does not have; BCD digits above 9 on a starting edge.
    pub fn run(self, machine: &mut Machine, args: [u64; 4]) -> Result<u64, Fault> {
        let [number, rlo, word, _] = args;
        let (rlo, word) = (rlo & 1 != 0, word as u16);
        let now = machine.clock_us;
        let index = usize::try_from(number).unwrap_or(usize::MAX);
        let no_timer = Fault::programming(0x26, number as u16);
        let no_counter = Fault::programming(0x27, number as u16);
        let bad_digit = Fault::programming(0x21, 0);
        match self {
            Self::TimerStart(kind) => {
                let timer = machine.timers.get_mut(index).ok_or(no_timer)?;
                let starts = if kind == TimerKind::OffDelay { !rlo && timer.start_edge } else { rlo && !timer.start_edge };
                if starts && !bcd::is_decimal(u32::from(word), 3) {
                    return Err(bad_digit);
                }
                timer.start(kind, rlo, word, now);
            }
            Self::TimerReset => {
                let timer = machine.timers.get_mut(index).ok_or(no_timer)?;
                if rlo {
                    timer.reset();
                }
            }
            Self::TimerEnable => machine.timers.get_mut(index).ok_or(no_timer)?.enable(rlo),
            Self::TimerStatus => {
                let timer = machine.timers.get_mut(index).ok_or(no_timer)?;
                timer.refresh(now);
                return Ok(u64::from(timer.status));
            }
            Self::TimerValue => {
                let timer = machine.timers.get_mut(index).ok_or(no_timer)?;
                timer.refresh(now);
                return Ok(u64::from(timer.remaining(now)));
            }
            Self::TimerBcd => {
                let timer = machine.timers.get_mut(index).ok_or(no_timer)?;
                timer.refresh(now);
                return Ok(u64::from(timer.bcd(now)));
            }
            Self::CounterUp => machine.counters.get_mut(index).ok_or(no_counter)?.up(rlo),
            Self::CounterDown => machine.counters.get_mut(index).ok_or(no_counter)?.down(rlo),
            Self::CounterSet => {
                let counter = machine.counters.get_mut(index).ok_or(no_counter)?;
                if rlo && !counter.set_edge && !bcd::is_decimal(u32::from(word), 3) {
                    return Err(bad_digit);
                }
                counter.set(rlo, word);
            }
            Self::CounterReset => {
                let counter = machine.counters.get_mut(index).ok_or(no_counter)?;
                if rlo {
                    counter.reset();
                }
            }
            Self::CounterEnable => machine.counters.get_mut(index).ok_or(no_counter)?.enable(rlo),
            Self::CounterStatus => return Ok(u64::from(machine.counters.get(index).ok_or(no_counter)?.count > 0)),
            Self::CounterValue => return Ok(u64::from(machine.counters.get(index).ok_or(no_counter)?.count)),
            Self::Clock => return Ok(u64::from((now / 1_000) as u32)),
            Self::CounterBcd => return Ok(u64::from(machine.counters.get(index).ok_or(no_counter)?.bcd())),
        }
        Ok(0)
    }
}
