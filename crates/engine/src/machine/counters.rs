//! The S5 counters.

use sieben_model::bcd;

/// Greatest count.
pub const COUNT_MAX: u16 = 999;

/// One S5 counter. Machine code reaches its fields through their offsets.
#[repr(C)]
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Counter {
    /// The count, 0 to 999.
    pub count: u16,
    /// Edge memory of S.
    pub set_edge: bool,
    /// Edge memory of CU.
    pub up_edge: bool,
    /// Edge memory of CD.
    pub down_edge: bool,
    /// Edge memory of FR.
    pub enable_edge: bool,
}

impl Counter {
    /// CU with this RLO.
    pub fn up(&mut self, rlo: bool) {
        if rlo && !self.up_edge && self.count < COUNT_MAX {
            self.count += 1;
        }
        self.up_edge = rlo;
    }
    /// CD with this RLO.
    pub fn down(&mut self, rlo: bool) {
        if rlo && !self.down_edge && self.count > 0 {
            self.count -= 1;
        }
        self.down_edge = rlo;
    }
    /// S with this RLO and BCD preset. The digits were checked before.
    pub fn set(&mut self, rlo: bool, preset: u16) {
        if rlo && !self.set_edge {
            self.count = bcd::decode(u32::from(preset), 3) as u16;
        }
        self.set_edge = rlo;
    }
    /// R with RLO = 1.
    pub fn reset(&mut self) {
        self.count = 0;
    }
    /// FR with this RLO.
    pub fn enable(&mut self, rlo: bool) {
        if rlo && !self.enable_edge {
            self.set_edge = false;
            self.up_edge = false;
            self.down_edge = false;
        }
        self.enable_edge = rlo;
    }
    /// The count as LC delivers it, three BCD digits.
    pub fn bcd(&self) -> u16 {
        bcd::encode(u32::from(self.count)) as u16
    }
}
