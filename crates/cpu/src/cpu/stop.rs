//! STOP and HOLD: why, by whom, and what then holds.

use std::sync::Arc;
use std::sync::atomic::Ordering;

use sieben_engine::{FaultPlace, StopReason};

use super::Cpu;
use crate::communication::Requester;
use crate::diagnostic_buffer::DiagnosticEntry;
use crate::host::Requests;
use crate::mode::{OperatingMode, StopCause};
use crate::organization_blocks as ob;
use crate::start_information::StartInformation;

/// Sends a CPU to STOP (as its mode switch does) or HOLD from another thread; seen at the next safe point.
#[derive(Clone, Debug)]
pub struct StopRequest(Arc<Requests>);

impl StopRequest {
    /// Asks for STOP.
    pub fn stop(&self) {
        self.0.stop.store(true, Ordering::Relaxed);
    }
    /// Asks for an end of the time that OB 90 has now: somebody wants to come in.
    pub fn let_in(&self) {
        self.0.visit.store(true, Ordering::Relaxed);
    }
    /// Asks for HOLD.
    pub fn hold(&self) {
        self.0.hold.store(true, Ordering::Relaxed);
    }
}

/// What was suspended by HOLD.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Held {
    Startup,
    Cycle,
    /// An interrupt between two cycles.
    Interrupt,
    /// OB 90, or an interrupt of it.
    Background,
}

impl Cpu {
    /// Sends the CPU to STOP as its mode switch does.
    pub fn stop(&mut self) {
        self.stop_with(StartInformation { event: 0x4303, ..self.class });
    }

    /// A handle that sends the CPU to STOP or HOLD from another thread.
    pub fn stop_request(&self) -> StopRequest {
        StopRequest(Arc::clone(&self.requests))
    }

    /// This CPU takes the place of another one: what is asked of that one from other threads is asked of this one from now on.
    pub fn take_requests_of(&mut self, other: &Self) {
        self.requests = Arc::clone(&other.requests);
    }

    /// The same at a request from outside.
    pub(super) fn stop_for(&mut self, by: Requester) {
        let (data_id, info_2) = by.fields(self.class.info_2);
        self.stop_with(StartInformation { event: 0x4304, data_id, info_2, ..self.class });
    }

    fn stop_with(&mut self, fields: StartInformation) {
        match self.mode {
            OperatingMode::Stop => return,
            OperatingMode::Hold => {
                self.log(StartInformation { event: 0x430A, ..self.class }, None);
            }
            OperatingMode::Startup | OperatingMode::Run => {}
        }
        self.enter_stop_with(fields, None, None);
    }

    pub(super) fn enter_stop(&mut self, reason: StopReason, first: Option<DiagnosticEntry>) {
        let StopReason { event, place } = reason;
        self.enter_stop_with(StartInformation { event, ..self.class }, place, first);
    }

    fn enter_stop_with(&mut self, fields: StartInformation, place: Option<FaultPlace>, first: Option<DiagnosticEntry>) {
        let event = fields.event;
        let entry = self.log(fields, place);
        let first_event = first.as_ref().map_or(event, DiagnosticEntry::event);
        let text = match &first {
            Some(first) => format!("{}; {}", first.text(), crate::diagnostic_buffer::event_text(event)),
            None => entry.text(),
        };
        let text = match &self.system.failed_assertion {
            Some(failed) => format!("an assertion is false: {failed}; {text}"),
            None => text,
        };
        let place = place.or(first.and_then(|first| first.place));
        // Nobody knows which statements came before a STOP from outside: what they wrote is not a scan's.
        self.torn = matches!(event, 0x4303 | 0x4304) && !self.machine.frames.is_empty();
        self.cause = Some(StopCause { event, first_event, place, text });
        let in_run = self.mode == OperatingMode::Run || matches!(self.held, Some(Held::Cycle | Held::Interrupt));
        // OB 90 begins again after every restart.
        let in_background = self.machine.frames.first().is_some_and(|frame| frame.block == ob::BACKGROUND);
        self.interrupted = if in_run && !in_background && self.cpu_type.has_ob88 { self.take_stack() } else { None };
        self.paused = None;
        self.mode = OperatingMode::Stop;
        self.held = None;
        self.pause = None;
        self.machine.frames.clear();
        self.machine.parameters.clear();
        self.interrupts.clear();
        self.rack.enable_outputs(false);
    }

    pub(super) fn hold(&mut self, held: Held) {
        self.held = Some(held);
        self.mode = OperatingMode::Hold;
        self.log(StartInformation { event: 0x4305, ..self.class }, None);
    }

    pub(super) fn log(&mut self, fields: StartInformation, place: Option<FaultPlace>) -> DiagnosticEntry {
        let entry = DiagnosticEntry { fields, time: self.date_and_time(), place };
        self.diagnostics.push(entry.clone());
        entry
    }
}
