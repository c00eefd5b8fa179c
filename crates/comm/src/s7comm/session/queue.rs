//! Jobs of one connection that wait, in the order in which they came.

use std::collections::VecDeque;

use crate::s7comm::job::{Job, Pending};
use crate::s7comm::wire::security::PasswordRequest;
use crate::s7comm::wire::setup::JOBS_MAX;
use crate::s7comm::wire::userdata::Address;

/// How often a job is looked at that takes longer, in microseconds.
const LOOK_US: u64 = 5_000;

/// How a job was asked, which says how it is answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// Variables.
    Variables,
    /// Jobs 28 and 29.
    Service,
    /// Userdata.
    Userdata(Address),
    /// Job 1D.
    Upload,
    /// The end of a download.
    Download,
}

/// What is done about a job.
#[derive(Debug)]
pub(super) enum Work {
    /// Its answer is there.
    Answer(Vec<u8>),
    /// Its answer is there and is sent at this time.
    Held(Vec<u8>, u64),
    /// It has to be judged.
    Job { job: Job, form: Form },
    /// It waits for the gate.
    Ready { job: Job, form: Form },
    /// It has begun and takes longer.
    Pending { job: Job, form: Form, pending: Box<dyn Pending>, until_us: u64, look_us: u64, is_due: Due },
    /// A password.
    Password { request: PasswordRequest, address: Address },
}

/// Whether a job that takes longer is to be looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Due {
    /// At the next entry of the gate.
    Now,
    /// Later.
    Later,
}

/// A job that waits.
#[derive(Debug)]
pub(super) struct Task {
    pub(super) reference: u16,
    pub(super) work: Work,
}

/// The jobs that wait.
#[derive(Debug, Default)]
pub(super) struct Queue {
    tasks: VecDeque<Task>,
}

impl Queue {
    /// Adds a job at the end.
    pub(super) fn push(&mut self, reference: u16, work: Work) {
        self.tasks.push_back(Task { reference, work });
    }

    /// Puts the first one back.
    pub(super) fn put_back(&mut self, reference: u16, work: Work) {
        self.tasks.push_front(Task { reference, work });
    }

    /// The first one takes longer.
    pub(super) fn pend(&mut self, reference: u16, job: Job, form: Form, pending: Box<dyn Pending>, until_us: u64, now_us: u64) {
        let look_us = now_us.saturating_add(LOOK_US);
        self.put_back(reference, Work::Pending { job, form, pending, until_us, look_us, is_due: Due::Later });
    }

    /// Takes the first one.
    pub(super) fn pop(&mut self) -> Option<Task> {
        self.tasks.pop_front()
    }

    /// Takes the first one if it waits for the gate.
    pub(super) fn take_for_gate(&mut self) -> Option<Task> {
        if self.wants_in() { self.tasks.pop_front() } else { None }
    }

    pub(super) fn wants_in(&self) -> bool {
        matches!(self.tasks.front(), Some(Task { work: Work::Ready { .. } | Work::Pending { is_due: Due::Now, .. }, .. }))
    }

    /// Whether the first one has begun and takes longer.
    pub(super) fn has_begun(&self) -> bool {
        matches!(self.tasks.front(), Some(Task { work: Work::Pending { .. }, .. }))
    }

    /// Forgets what has not begun.
    pub(super) fn keep_begun(&mut self) {
        self.tasks.truncate(usize::from(self.has_begun()));
    }

    pub(super) fn is_empty(&self) -> bool {
        self.tasks.is_empty()
    }

    pub(super) fn has_room(&self) -> bool {
        self.tasks.len() < usize::from(JOBS_MAX)
    }

    /// When the first one is due.
    pub(super) fn wake_us(&self) -> Option<u64> {
        match &self.tasks.front()?.work {
            Work::Held(_, until_us) => Some(*until_us),
            Work::Pending { look_us, until_us, is_due: Due::Later, .. } => Some(*look_us.min(until_us)),
            _ => None,
        }
    }
}
