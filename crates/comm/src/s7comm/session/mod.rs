//! The state of one connection, without I/O: bytes come in, bytes go out, time is an argument.

mod dispatch;
mod events;
mod input;
mod output;
mod passwords;
mod queue;
mod remainders;
mod shared;
mod transfers;

use std::net::{IpAddr, SocketAddr};
use std::sync::Arc;

use sieben_cpu::Requester;
use sieben_workspace::gate::Plant;

use super::answer;
use super::guard::{Legitimation, Rules};
use super::job::Reply;
use super::wire::codes::Refusal;
use super::wire::cotp;
use super::wire::cotp::Partner;
pub use events::{Event, What};
use input::{Arrived, Input};
use output::Output;
use queue::{Queue, Work};
use remainders::Remainders;
pub use shared::{Requests, Shared};
use transfers::{Incoming, Uploads};

/// How long a job may take that needs several entries of the gate, in microseconds; then it is refused.
pub const PENDING_US_MAX: u64 = 3_000_000;
/// How long a client may take to connect and to set up the communication, in microseconds.
const SETUP_US_MAX: u64 = 10_000_000;
/// The slot of the CPU in an S7-300, and those that it may have in an S7-400.
const SLOTS_300: std::ops::RangeInclusive<u8> = 2..=2;
const SLOTS_400: std::ops::RangeInclusive<u8> = 2..=4;

/// How far a connection has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// Nothing has come yet.
    Begun,
    /// It is connected; TPDUs have so many bytes.
    Connected { tpdu_bytes: usize },
    /// Communication is set up: PDUs have so many bytes.
    Ready { tpdu_bytes: usize, pdu_bytes: usize },
    /// It is over: what waits is sent, and nothing is read any more.
    Over,
}

/// One connection.
#[derive(Debug)]
pub struct Session {
    rules: Arc<Rules>,
    peer: SocketAddr,
    begun_us: u64,
    stage: Stage,
    partner: Option<Partner>,
    input: Input,
    output: Output,
    queue: Queue,
    /// What waits until all jobs before it are done: a setup, which changes how they are answered, or the end of the connection.
    barrier: Option<Arrived>,
    legitimation: Legitimation,
    remainders: Remainders,
    uploads: Uploads,
    download: Option<Incoming>,
    /// The reference of the last job of the CPU.
    own_reference: u16,
}

impl Session {
    /// A connection that has just been accepted.
    pub fn new(rules: Arc<Rules>, peer: SocketAddr, now_us: u64) -> Self {
        Self {
            rules,
            peer,
            begun_us: now_us,
            stage: Stage::Begun,
            partner: None,
            input: Input::default(),
            output: Output::default(),
            queue: Queue::default(),
            barrier: None,
            legitimation: Legitimation::None,
            remainders: Remainders::default(),
            uploads: Uploads::default(),
            download: None,
            own_reference: 0,
        }
    }

    /// Who is on the other side.
    pub fn peer(&self) -> SocketAddr {
        self.peer
    }

    /// Whether it is set up.
    pub fn is_ready(&self) -> bool {
        matches!(self.stage, Stage::Ready { .. })
    }

    /// From now on these rules hold for what comes.
    pub fn set_rules(&mut self, rules: Arc<Rules>) {
        self.rules = rules;
    }

    /// What the other side is, once it is connected.
    pub fn partner(&self) -> Option<Partner> {
        self.partner
    }

    /// How many bytes its PDUs have, once it is set up.
    pub fn pdu_bytes(&self) -> Option<usize> {
        match self.stage {
            Stage::Ready { pdu_bytes, .. } => Some(pdu_bytes),
            _ => None,
        }
    }

    /// Takes bytes that came. Jobs that need the CPU wait for [`Self::serve`], everything else is answered.
    pub fn receive(&mut self, bytes: &[u8], shared: &mut Shared, now_us: u64) {
        if self.is_over() {
            return;
        }
        match self.input.take(bytes) {
            Ok(()) => self.go_on(shared, now_us),
            Err(_) => self.end(),
        }
    }

    /// Whether a job waits for an entry of the gate.
    pub fn wants_in(&self) -> bool {
        self.queue.wants_in()
    }

    /// Does one job at the cycle control point; whether it was one. A server asks its sessions in turn within one entry of the gate.
    pub fn serve(&mut self, plant: &mut Plant, shared: &mut Shared, now_us: u64) -> bool {
        let by = self.requester();
        let Some(task) = self.queue.take_for_gate() else { return false };
        let scan = plant.scans;
        let (job, form, reply, until_us) = match task.work {
            Work::Ready { job, form } => {
                let reply = answer::perform(&job, plant, &mut shared.around, by);
                (job, form, reply, now_us.saturating_add(PENDING_US_MAX))
            }
            Work::Pending { job, form, mut pending, until_us, .. } => match pending.poll(plant, &mut shared.around) {
                // What has ended meanwhile is answered, however late it is.
                None if now_us >= until_us => (job, form, Reply::Refused(Refusal::CannotPerform), until_us),
                None => {
                    self.queue.pend(task.reference, job, form, pending, until_us, now_us);
                    return true;
                }
                Some(reply) => (job, form, reply, until_us),
            },
            other => {
                self.queue.put_back(task.reference, other);
                return false;
            }
        };
        match reply {
            Reply::Later(pending) => self.queue.pend(task.reference, job, form, pending, until_us, now_us),
            reply => {
                events::of(self.peer, task.reference, Some(scan), &job, &reply, &mut shared.events);
                let answer = self.answer(task.reference, &job, form, reply, now_us);
                self.send(&answer, now_us);
            }
        }
        self.go_on(shared, now_us);
        true
    }

    /// Bytes that wait to be sent: whole frames, each of which should go out in one piece.
    pub fn output(&self) -> &[u8] {
        self.output.waiting()
    }

    /// So many bytes of the output have been sent.
    pub fn sent(&mut self, bytes: usize, now_us: u64) {
        self.output.sent(bytes, now_us);
    }

    /// Whether more bytes may come in: with too much output or too many jobs the other side has to wait.
    pub fn reads(&self) -> bool {
        !self.is_over() && self.listens()
    }

    /// When [`Self::tick`] is due, if it is.
    pub fn wake_us(&self) -> Option<u64> {
        let setup_us = (!self.is_ready() && !self.is_over()).then(|| self.begun_us.saturating_add(SETUP_US_MAX));
        let input_us = if self.is_over() { None } else { self.input.given_up_us() };
        // There is room again for what came before: at once.
        let room_us = (self.input.waits && self.reads()).then_some(0);
        [room_us, setup_us, input_us, self.output.given_up_us(), self.queue.wake_us()].into_iter().flatten().min()
    }

    /// Looks at the time: deadlines, answers that were held back, jobs that take longer; also whether there is room again for what waits.
    pub fn tick(&mut self, shared: &mut Shared, now_us: u64) {
        let passed = |deadline_us: Option<u64>| deadline_us.is_some_and(|deadline_us| now_us >= deadline_us);
        let setup_us = (!self.is_ready()).then(|| self.begun_us.saturating_add(SETUP_US_MAX));
        if passed(self.output.given_up_us()) {
            // The client does not take it.
            let waiting = self.output.waiting().len();
            self.output.sent(waiting, now_us);
            self.end();
        } else if !self.is_over() && (passed(setup_us) || passed(self.input.given_up_us())) {
            self.end();
        } else {
            self.go_on(shared, now_us);
        }
    }

    /// Whether the connection is to be closed, as soon as its output has been sent: in order, never by a reset.
    pub fn is_over(&self) -> bool {
        self.stage == Stage::Over
    }

    /// Whether a job has begun that takes longer: what comes of it is noted, even if its client is gone.
    pub fn has_begun(&self) -> bool {
        self.queue.has_begun()
    }

    /// Whether all that was asked has been answered, as far as it has come whole.
    pub fn is_idle(&self) -> bool {
        self.queue.is_empty() && self.barrier.is_none()
    }

    /// Ends the connection from our side: what is done is answered, what has begun goes on, what waits is not done.
    pub fn end(&mut self) {
        self.stage = Stage::Over;
        self.queue.keep_begun();
        self.barrier = None;
        self.download = None;
        self.uploads = Uploads::default();
        self.remainders = Remainders::default();
    }

    /// Who asks, as the diagnostic buffer keeps it.
    fn requester(&self) -> Requester {
        match self.peer.ip().to_canonical() {
            IpAddr::V4(address) => Requester { address: Some(address) },
            IpAddr::V6(_) => Requester::default(),
        }
    }

    fn listens(&self) -> bool {
        self.queue.has_room() && self.barrier.is_none() && !self.output.is_full()
    }

    /// Looks at what has come and answers what needs no CPU, as far as the order of the jobs and the room for answers allow.
    fn go_on(&mut self, shared: &mut Shared, now_us: u64) {
        loop {
            self.advance(shared, now_us);
            if self.is_over() {
                return;
            }
            if self.queue.is_empty()
                && let Some(arrived) = self.barrier.take()
            {
                self.arrived(arrived, shared, now_us);
                continue;
            }
            if !self.listens() {
                self.input.wait();
                return;
            }
            match self.input.next(now_us) {
                Ok(Some(arrived)) => self.arrived(arrived, shared, now_us),
                Ok(None) => return,
                Err(_) => return self.end(),
            }
        }
    }

    fn arrived(&mut self, arrived: Arrived, shared: &mut Shared, now_us: u64) {
        match (arrived, self.stage) {
            (Arrived::Connect { source, confirmed, tpdu_bytes, rack_and_slot, partner }, Stage::Begun) => {
                if self.rules.strict_slot && !self.has_slot(rack_and_slot) {
                    self.output.control(now_us, |out| cotp::disconnect_request(out, source, cotp::ADDRESS_UNKNOWN));
                    return self.end();
                }
                self.output.control(now_us, |out| out.extend_from_slice(&confirmed));
                self.stage = Stage::Connected { tpdu_bytes };
                self.partner = Some(partner);
            }
            (arrived @ Arrived::Disconnect { .. }, _) if !self.queue.is_empty() => self.barrier = Some(arrived),
            (Arrived::Disconnect { source }, Stage::Connected { .. } | Stage::Ready { .. }) => {
                self.output.control(now_us, |out| cotp::disconnect_confirm(out, source));
                self.end();
            }
            (Arrived::Message(message), Stage::Connected { .. } | Stage::Ready { .. }) => self.message(message, shared, now_us),
            _ => self.end(),
        }
    }

    fn has_slot(&self, rack_and_slot: Option<(u8, u8)>) -> bool {
        let slots = if self.rules.cpu.accumulators == 4 { SLOTS_400 } else { SLOTS_300 };
        rack_and_slot.is_some_and(|(rack, slot)| rack == 0 && slots.contains(&slot))
    }

    fn send(&mut self, message: &[u8], now_us: u64) {
        if let Stage::Connected { tpdu_bytes } | Stage::Ready { tpdu_bytes, .. } = self.stage {
            self.output.message(now_us, message, tpdu_bytes);
        }
    }

    fn next_own_reference(&mut self) -> u16 {
        self.own_reference = self.own_reference.wrapping_add(1);
        self.own_reference
    }
}
