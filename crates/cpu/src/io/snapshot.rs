//! A rack at one moment, and back to it.

use std::fmt;

use super::{IoModule, Rack};
use crate::interrupts::Interrupt;
use crate::listening::Orders;

/// What a rack is at one moment.
pub(crate) struct RackSnapshot {
    /// `None` if one of the modules cannot be copied.
    modules: Option<Vec<Box<dyn IoModule>>>,
    outputs: Vec<u8>,
    enabled: bool,
    alarms: Vec<Interrupt>,
    alarmed: bool,
    tape: u64,
    now_us: u64,
    orders: Orders,
}

impl fmt::Debug for RackSnapshot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RackSnapshot").field("has_modules", &self.has_modules()).finish_non_exhaustive()
    }
}

impl RackSnapshot {
    pub(crate) fn has_modules(&self) -> bool {
        self.modules.is_some()
    }

    /// An estimate of the memory that it takes.
    pub(crate) fn bytes(&self) -> usize {
        let addresses = |module: &dyn IoModule| module.inputs().len() + module.outputs().len();
        self.outputs.len() + self.modules.iter().flatten().map(|module| addresses(&**module)).sum::<usize>()
    }
}

impl Rack {
    pub(crate) fn snapshot(&self) -> RackSnapshot {
        let modules = self.modules.iter().map(|module| module.copy()).collect();
        RackSnapshot {
            modules,
            outputs: self.outputs.clone(),
            enabled: self.enabled,
            alarms: self.alarms.clone(),
            alarmed: self.alarmed,
            tape: self.tape.position(),
            now_us: self.now_us,
            orders: self.orders.clone(),
        }
    }

    /// Forgets what the modules said before a snapshot.
    pub(crate) fn forget_before(&mut self, snapshot: &RackSnapshot) {
        self.tape.forget_before(snapshot.tape);
    }

    /// If one module could not be copied, all stay as they are, and the tape says what they said.
    pub(crate) fn go_back_to(&mut self, snapshot: &RackSnapshot) {
        let copied = snapshot.modules.as_ref().and_then(|modules| modules.iter().map(|module| module.copy()).collect());
        match copied {
            Some(modules) => {
                self.modules = modules;
                self.alarms.clone_from(&snapshot.alarms);
                self.now_us = snapshot.now_us;
                self.orders.clone_from(&snapshot.orders);
            }
            None => self.tape.go_to(snapshot.tape),
        }
        self.changed = true;
        self.alarmed = snapshot.alarmed;
        self.outputs.clone_from(&snapshot.outputs);
        self.enabled = snapshot.enabled;
    }
}
