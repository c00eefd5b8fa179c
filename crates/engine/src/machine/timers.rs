//! The five S5 timers, computed from time stamps.
//!
//! One edge memory serves all start instructions of a timer, as the manuals do not say otherwise (docs/decisions).

use sieben_model::bcd;

/// What starts a timer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum TimerKind {
    /// SP: pulse.
    #[default]
    Pulse,
    /// SE: extended pulse.
    ExtendedPulse,
    /// SD: on delay.
    OnDelay,
    /// SS: retentive on delay.
    RetentiveOnDelay,
    /// SF: off delay.
    OffDelay,
}

/// One S5 timer. Machine code reaches its fields through their offsets; they are in an order without gaps.
#[repr(C)]
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Timer {
    /// CPU clock at the start, in microseconds.
    pub started_us: u64,
    /// How it was started last.
    pub kind: TimerKind,
    /// Whether the value counts down.
    pub running: bool,
    /// The status bit as it stood when the timer was last touched.
    pub status: bool,
    /// The value when it was started or stopped, 0 to 999.
    pub value: u16,
    /// Time base, 0 to 3: 10 ms, 100 ms, 1 s, 10 s.
    pub base: u8,
    /// Edge memory of the start instructions.
    pub start_edge: bool,
    /// Edge memory of FR.
    pub enable_edge: bool,
}

/// Microseconds of one unit of each time base.
pub const BASE_US: [u64; 4] = [10_000, 100_000, 1_000_000, 10_000_000];

impl Timer {
    /// Brings value and status up to now.
    pub fn refresh(&mut self, now_us: u64) {
        if self.running && self.remaining(now_us) == 0 {
            self.running = false;
            self.value = 0;
            self.status = match self.kind {
                TimerKind::Pulse | TimerKind::ExtendedPulse | TimerKind::OffDelay => false,
                TimerKind::OnDelay | TimerKind::RetentiveOnDelay => true,
            };
        }
    }

    /// The remaining value, 0 to 999.
    pub fn remaining(&self, now_us: u64) -> u16 {
        if !self.running {
            return self.value;
        }
        let elapsed = now_us.saturating_sub(self.started_us) / BASE_US[usize::from(self.base & 3)];
        self.value.saturating_sub(u16::try_from(elapsed).unwrap_or(u16::MAX))
    }

    /// A start instruction with this RLO and S5TIME word. The digits were checked before.
    pub fn start(&mut self, kind: TimerKind, rlo: bool, s5time: u16, now_us: u64) {
        self.refresh(now_us);
        let rising = rlo && !self.start_edge;
        let falling = !rlo && self.start_edge;
        self.start_edge = rlo;
        match kind {
            TimerKind::OffDelay => {
                if rising {
                    self.stop(now_us);
                    self.status = true;
                } else if falling {
                    self.begin(kind, s5time, now_us);
                    self.status = self.running;
                }
            }
            _ if rising => {
                let was = self.status;
                self.begin(kind, s5time, now_us);
                self.status = match kind {
                    TimerKind::Pulse | TimerKind::ExtendedPulse => self.running,
                    TimerKind::RetentiveOnDelay => was || !self.running,
                    _ => !self.running,
                };
            }
            TimerKind::Pulse | TimerKind::OnDelay if !rlo => {
                self.stop(now_us);
                self.status = false;
            }
            _ => {}
        }
    }

    fn begin(&mut self, kind: TimerKind, s5time: u16, now_us: u64) {
        self.kind = kind;
        self.base = (s5time >> 12 & 3) as u8;
        self.value = bcd::decode(u32::from(s5time), 3) as u16;
        self.started_us = now_us;
        self.running = self.value > 0;
    }

    fn stop(&mut self, now_us: u64) {
        self.value = self.remaining(now_us);
        self.running = false;
    }

    /// R with RLO = 1.
    pub fn reset(&mut self) {
        self.running = false;
        self.value = 0;
        self.base = 0;
        self.status = false;
    }

    /// FR with this RLO.
    pub fn enable(&mut self, rlo: bool) {
        if rlo && !self.enable_edge {
            self.start_edge = false;
        }
        self.enable_edge = rlo;
    }

    /// The value as LC delivers it: time base in bits 12 and 13, three BCD digits.
    pub fn bcd(&self, now_us: u64) -> u16 {
        u16::from(self.base & 3) << 12 | bcd::encode(u32::from(self.remaining(now_us))) as u16
    }
}
