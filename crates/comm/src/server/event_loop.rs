//! The loop of a server: wait for sockets, take in what they have, enter the gate once for all jobs, send all answers.

use std::collections::{BTreeMap, VecDeque};
use std::io::{self, ErrorKind};
use std::net::{IpAddr, Ipv4Addr, Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::Ordering;

use rustix::event::epoll::EventFlags;
use sieben_cpu::{Communication, Station};
use sieben_model::cpu_type::CpuType;
use sieben_workspace::Gate;
use sieben_workspace::gate::{PORTION_JOBS, PORTION_US};

use super::connection::{Closing, Connection};
use super::sockets::{self, Input, Poll};
use super::view::{Counters, Written};
use super::{Common, Setup, WallClock};
use crate::config::{CONNECTIONS_OF_ADDRESS_MAX, Config};
use crate::recording::Recorders;
use crate::recording::audit::{At, Audit, Change, address};
use crate::recording::frames::Direction;
use crate::s7comm::guard::{Function, Rules, Writing};
use crate::s7comm::session::{Session, Shared, What};
use crate::s7comm::wire::cotp::{self, Partner};
use crate::s7comm::wire::tpkt;

/// What the handles are waited for as; connections are numbered from 1.
const LISTENER: u64 = 0;
const WAKE: u64 = u64::MAX;
/// Bytes that are read of a socket at a time.
const INPUT_BYTES: usize = 16 * 1024;
/// Connections that are accepted in a row.
const ACCEPTED_MAX: usize = 64;
/// How long nothing is accepted when the system has no room, in microseconds.
const NO_ROOM_US: u64 = 100_000;
/// How long a connection is drained that is being closed, in microseconds.
const CLOSING_US: u64 = 1_000_000;
/// Connections that are being closed at a time; the oldest one makes room.
const CLOSING_MAX: usize = 64;
/// Shortest wait for a moment that has passed already, in microseconds: what is due is done in the next iteration, and no mistake makes it spin.
const PATIENCE_US: u64 = 100;
/// Bytes of what a client wrote last that are shown.
const WRITTEN_BYTES_MAX: usize = 8;
/// The reference of a client that has not said its own yet.
const NO_REFERENCE: u16 = 0;

/// The loop of a server.
pub(super) struct EventLoop {
    poll: Poll,
    /// `None` as soon as the server ends.
    listener: Option<TcpListener>,
    address: SocketAddr,
    gate: Arc<Gate>,
    config: Config,
    names: Communication,
    /// The rules for all connections.
    rules: Arc<Rules>,
    /// Those that hold while nothing can be noted that has to be.
    rules_unnoted: Arc<Rules>,
    /// Whether these hold.
    is_unnoted: bool,
    /// Most connections at a time.
    connections_max: usize,
    shared: Shared,
    recorders: Recorders,
    clock: WallClock,
    common: Arc<Common>,
    connections: BTreeMap<u64, Connection>,
    /// Those that are being closed, the oldest first.
    closing: VecDeque<(u64, Closing)>,
    /// The number of the last connection or refusal.
    last: u64,
    /// Until when nothing is accepted.
    accepts_us: Option<u64>,
    /// What the CPU was told of the connections.
    told: Option<[u16; 3]>,
    /// The connection whose job comes first in the next entry of the gate.
    first: u64,
    /// The last scan that has been seen, and the time of the CPU then.
    scan: u64,
    time_us: u64,
    counters: Counters,
    buffer: Box<[u8]>,
}

impl EventLoop {
    pub(super) fn new(
        listener: TcpListener,
        cpu: &'static CpuType,
        gate: Arc<Gate>,
        setup: Setup,
        common: Arc<Common>,
    ) -> io::Result<Self> {
        let Setup { config, shared, mut names, recorders, clock } = setup;
        names.address = address_of(&listener);
        let poll = Poll::new()?;
        let rules = config.rules(cpu);
        listener.set_nonblocking(true)?;
        poll.add(&listener, LISTENER, EventFlags::IN)?;
        poll.add(&common.wake, WAKE, EventFlags::IN)?;
        Ok(Self {
            poll,
            address: listener.local_addr()?,
            listener: Some(listener),
            gate,
            rules_unnoted: Arc::new(Rules { writing: Writing::ReadOnly, ..rules.clone() }),
            rules: Arc::new(rules),
            is_unnoted: false,
            connections_max: if config.strict { usize::from(cpu.connections).min(config.connections_max) } else { config.connections_max },
            config,
            names,
            shared,
            recorders,
            clock,
            common,
            connections: BTreeMap::new(),
            closing: VecDeque::new(),
            last: 0,
            accepts_us: None,
            told: None,
            first: 0,
            scan: 0,
            time_us: 0,
            counters: Counters::default(),
            buffer: vec![0; INPUT_BYTES].into(),
        })
    }

    /// Serves until it is told to end, or the run is over.
    pub(super) fn run(&mut self) {
        let mut ready = Vec::new();
        loop {
            self.take_in(&ready);
            self.tick();
            self.serve();
            self.note_events();
            self.send();
            self.close_what_is_done();
            self.show();
            if self.listener.is_some() && (self.common.ends.load(Ordering::Acquire) || self.gate.is_closed()) {
                self.end();
            }
            if self.listener.is_none() && self.closing.is_empty() {
                return;
            }
            self.poll.wait(self.timeout_us(), &mut ready);
        }
    }

    fn at(&self, gate_us: u64) -> At {
        At { wall_us: (self.clock)(), gate_us }
    }

    /// The rules that hold now.
    fn rules(&self) -> &Arc<Rules> {
        if self.is_unnoted { &self.rules_unnoted } else { &self.rules }
    }

    /// Takes in what has come since the last iteration.
    fn take_in(&mut self, ready: &[(u64, EventFlags)]) {
        for &(token, flags) in ready {
            match token {
                LISTENER => self.accept(),
                WAKE => {
                    // Its only meaning is that the loop looks up.
                    let _ = rustix::io::read(&self.common.wake, &mut [0; 8]);
                }
                number => self.take_input(number, flags),
            }
        }
    }

    fn take_input(&mut self, number: u64, flags: EventFlags) {
        let now_us = self.gate.now_us();
        let Some(connection) = self.connections.get_mut(&number) else {
            let buffer = &mut self.buffer;
            self.closing.retain(|(other, closing)| *other != number || !closing.drain(buffer));
            return;
        };
        let is_lost = flags.intersects(EventFlags::ERR | EventFlags::HUP);
        if !flags.contains(EventFlags::IN) {
            // Both directions are closed: what is left to be sent has nowhere to go.
            connection.is_gone |= is_lost;
            return;
        }
        match sockets::read(&connection.stream, &mut self.buffer) {
            Input::Bytes(count) => {
                let bytes = self.buffer.get(..count).unwrap_or_default();
                connection.bytes_in += count as u64;
                connection.heard_us = now_us;
                self.counters.bytes_in += count as u64;
                if let (Some(frames), Some(flow)) = (&self.recorders.frames, &mut connection.flow) {
                    frames.bytes(flow, Direction::In, bytes, (self.clock)(), "");
                }
                let requests = &self.shared.requests;
                let before = (requests.of(Function::Read), requests.of(Function::Write));
                connection.session.receive(bytes, &mut self.shared, now_us);
                let requests = &self.shared.requests;
                connection.reads += requests.of(Function::Read).saturating_sub(before.0);
                connection.writes += requests.of(Function::Write).saturating_sub(before.1);
                connection.last = self.shared.requests.take_last().or(connection.last);
            }
            Input::Nothing => {}
            Input::End => connection.has_ended = true,
            Input::Gone => connection.is_gone = true,
        }
    }

    /// Accepts those who wait.
    fn accept(&mut self) {
        for _ in 0..ACCEPTED_MAX {
            let Some(listener) = &self.listener else { return };
            match listener.accept() {
                Ok((stream, peer)) => self.welcome(stream, SocketAddr::new(peer.ip().to_canonical(), peer.port())),
                Err(error) if error.kind() == ErrorKind::WouldBlock => return,
                Err(error) if sockets::has_no_room(&error) => {
                    self.poll.remove(listener);
                    self.accepts_us = Some(self.gate.now_us().saturating_add(NO_ROOM_US));
                    return;
                }
                // The one who came has gone already.
                Err(_) => {}
            }
        }
    }

    fn welcome(&mut self, stream: TcpStream, peer: SocketAddr) {
        self.last += 1;
        let (number, now_us) = (self.last, self.gate.now_us());
        let of_address = self.connections.values().filter(|other| other.peer.ip() == peer.ip()).count();
        let is_full = self.connections.len() >= self.connections_max || of_address >= CONNECTIONS_OF_ADDRESS_MAX;
        if sockets::prepare(&stream).is_err() {
            return;
        }
        if is_full {
            self.counters.refused += 1;
            self.note(peer, Change::Refused, now_us);
            let mut refusal = Vec::new();
            tpkt::frame(&mut refusal, |out| cotp::disconnect_request(out, NO_REFERENCE, cotp::CONGESTION));
            // Eleven bytes fit into the buffer of a socket that is new.
            let _ = sockets::write(&stream, &refusal);
            self.close(number, stream, now_us);
            return;
        }
        if self.poll.add(&stream, number, EventFlags::IN).is_err() {
            return;
        }
        self.counters.connections += 1;
        self.note(peer, Change::Connected, now_us);
        // A server that listens at all addresses was reached at one of them.
        let reached = stream.local_addr().unwrap_or(self.address).ip();
        let flow = self.recorders.frames.as_ref().map(|frames| frames.begin(peer, reached, (self.clock)()));
        let connection = Connection {
            number,
            session: Session::new(Arc::clone(self.rules()), peer, now_us),
            stream,
            peer,
            waits_for: EventFlags::IN,
            has_ended: false,
            is_gone: false,
            since_us: now_us,
            heard_us: now_us,
            last: None,
            reads: 0,
            writes: 0,
            written: None,
            bytes_in: 0,
            bytes_out: 0,
            flow,
        };
        self.connections.insert(number, connection);
    }

    /// Does what is due.
    fn tick(&mut self) {
        let now_us = self.gate.now_us();
        if let Some(listener) = &self.listener
            && self.accepts_us.is_some_and(|at| at <= now_us)
        {
            self.accepts_us = match self.poll.add(listener, LISTENER, EventFlags::IN) {
                Ok(()) => None,
                Err(_) => Some(now_us.saturating_add(NO_ROOM_US)),
            };
        }
        let is_unnoted = self.recorders.audit.as_ref().is_some_and(Audit::refuses);
        if is_unnoted != self.is_unnoted {
            self.is_unnoted = is_unnoted;
            let rules = Arc::clone(self.rules());
            self.connections.values_mut().for_each(|connection| connection.session.set_rules(Arc::clone(&rules)));
        }
        for connection in self.connections.values_mut() {
            if connection.session.wake_us().is_some_and(|at| at <= now_us) {
                connection.session.tick(&mut self.shared, now_us);
            }
        }
        if let Some(audit) = &mut self.recorders.audit {
            audit.tick(now_us);
        }
    }

    /// Enters the gate if a job waits there, or the CPU has to be told of connections; what a portion does not do waits for the next one.
    fn serve(&mut self) {
        let partners = self.partners();
        let is_news = self.told != Some(partners);
        let mut waiting: Vec<u64> = self.connections.values().filter(|one| one.session.wants_in()).map(|one| one.number).collect();
        if waiting.is_empty() && !is_news {
            return;
        }
        let first = waiting.partition_point(|&number| number < self.first);
        waiting.rotate_left(first);
        let news = is_news.then(|| self.communication(partners));
        let Self { gate, connections, shared, told, scan, time_us, .. } = self;
        let mut done = 0;
        let entered = gate.serve(|plant| {
            *scan = plant.scans;
            *time_us = plant.cpu.time_us();
            if let Some(communication) = news {
                plant.cpu.set_communication(communication);
                *told = Some(partners);
            }
            let now_us = gate.now_us();
            let end_us = now_us.saturating_add(PORTION_US);
            let mut more = !waiting.is_empty();
            let mut next = 0;
            while more {
                more = false;
                for &number in &waiting {
                    next = number + 1;
                    let Some(connection) = connections.get_mut(&number) else { continue };
                    if connection.session.wants_in() && connection.session.serve(plant, shared, now_us) {
                        more = true;
                        done += 1;
                    }
                    if done >= PORTION_JOBS || gate.now_us() >= end_us {
                        return (next, plant.is_about_to_start());
                    }
                }
            }
            (next, plant.is_about_to_start())
        });
        // A run that is over ends the server in this iteration.
        let Ok((next, is_about_to_start)) = entered else { return };
        self.first = next;
        self.counters.entries += 1;
        self.counters.jobs += done as u64;
        if is_about_to_start {
            self.gate.wake();
        }
    }

    /// How many connections there are of programming devices, of operator panels, and of others.
    fn partners(&self) -> [u16; 3] {
        let count = |partner| {
            let of_partner = self.connections.values().filter(|one| one.session.partner() == Some(partner)).count();
            u16::try_from(of_partner).unwrap_or(u16::MAX)
        };
        [Partner::ProgrammingDevice, Partner::OperatorPanel, Partner::Other].map(count)
    }

    /// What the CPU is told of the connections and of this server.
    fn communication(&self, [programming_devices, operator_panels, others]: [u16; 3]) -> Communication {
        Communication { programming_devices, operator_panels, others, protection: self.config.protection, ..self.names.clone() }
    }

    /// Notes what the sessions have done.
    fn note_events(&mut self) {
        if self.shared.events.is_empty() {
            return;
        }
        let at = self.at(self.gate.now_us());
        for event in self.shared.events.drain(..) {
            if let (What::Write(variable, bytes), 0, Some(scan)) = (&event.what, event.error, event.scan)
                && let Some(connection) = self.connections.values_mut().find(|connection| connection.peer == event.peer)
            {
                let bytes = bytes.get(..WRITTEN_BYTES_MAX).unwrap_or(bytes).to_vec();
                connection.written = Some(Written { address: address(variable), bytes, scan, time_us: self.time_us });
            }
            if let Some(audit) = &mut self.recorders.audit {
                audit.event(&event, at);
            }
        }
    }

    fn note(&mut self, peer: SocketAddr, change: Change, gate_us: u64) {
        let at = self.at(gate_us);
        if let Some(audit) = &mut self.recorders.audit {
            audit.connection(peer, change, at);
        }
    }

    /// Sends what waits, as far as the sockets take it.
    fn send(&mut self) {
        let now_us = self.gate.now_us();
        for connection in self.connections.values_mut() {
            let output = connection.session.output();
            if output.is_empty() || connection.is_gone {
                continue;
            }
            match sockets::write(&connection.stream, output) {
                None => connection.is_gone = true,
                Some(0) => {}
                Some(count) => {
                    if let (Some(frames), Some(flow)) = (&self.recorders.frames, &mut connection.flow) {
                        let sent = output.get(..count).unwrap_or_default();
                        frames.bytes(flow, Direction::Out, sent, (self.clock)(), &format!("after scan {}", self.scan));
                    }
                    connection.bytes_out += count as u64;
                    self.counters.bytes_out += count as u64;
                    connection.session.sent(count, now_us);
                    // There may be room again for what waits.
                    connection.session.tick(&mut self.shared, now_us);
                }
            }
        }
    }

    /// Takes leave of connections that are over or lost, and sets what the others are waited for.
    fn close_what_is_done(&mut self) {
        let now_us = self.gate.now_us();
        let mut leaving = Vec::new();
        for connection in self.connections.values_mut() {
            if connection.is_done() {
                leaving.push(connection.number);
                continue;
            }
            if connection.is_gone {
                // It stays for what has begun; its socket has nothing more to be waited for.
                self.poll.remove(&connection.stream);
                connection.session.end();
                continue;
            }
            let wants = connection.wants();
            if wants != connection.waits_for {
                match self.poll.modify(&connection.stream, connection.number, wants) {
                    Ok(()) => connection.waits_for = wants,
                    Err(_) => connection.is_gone = true,
                }
            }
        }
        leaving.into_iter().for_each(|number| self.part(number, now_us));
        self.closing.retain(|(_, closing)| closing.until_us > now_us);
    }

    /// Ends a connection.
    fn part(&mut self, number: u64, now_us: u64) {
        let Some(mut connection) = self.connections.remove(&number) else { return };
        self.note(connection.peer, Change::Closed, now_us);
        if let (Some(frames), Some(flow)) = (&self.recorders.frames, &mut connection.flow) {
            let time_us = (self.clock)();
            if connection.has_ended {
                frames.end(flow, Direction::In, time_us);
            }
            frames.end(flow, Direction::Out, time_us);
        }
        self.poll.remove(&connection.stream);
        if !connection.is_gone {
            self.close(number, connection.stream, now_us);
        }
    }

    /// Sends nothing any more, and reads what still comes for a moment.
    fn close(&mut self, number: u64, stream: TcpStream, now_us: u64) {
        if stream.shutdown(Shutdown::Write).is_err() || self.poll.add(&stream, number, EventFlags::IN).is_err() {
            return;
        }
        let closing = Closing { stream, until_us: now_us.saturating_add(CLOSING_US) };
        if closing.drain(&mut self.buffer) {
            return;
        }
        if self.closing.len() >= CLOSING_MAX {
            self.closing.pop_front();
        }
        self.closing.push_back((number, closing));
    }

    /// The server ends: no client is accepted any more, and all connections are closed in order.
    fn end(&mut self) {
        if let Some(listener) = self.listener.take() {
            self.poll.remove(&listener);
        }
        let now_us = self.gate.now_us();
        let numbers: Vec<u64> = self.connections.keys().copied().collect();
        numbers.into_iter().for_each(|number| self.part(number, now_us));
        self.show();
    }

    /// How long the loop may wait; `None` if nothing is due.
    fn timeout_us(&self) -> Option<u64> {
        if self.listener.is_some() && self.connections.values().any(|one| one.session.wants_in()) {
            return Some(0);
        }
        let dues = self.connections.values().filter_map(|one| one.session.wake_us());
        let dues = dues.chain(self.is_unnoted.then(|| self.gate.now_us().saturating_add(NO_ROOM_US)));
        let dues = dues.chain(self.closing.iter().map(|(_, closing)| closing.until_us)).chain(self.accepts_us);
        let due = dues.chain(self.recorders.audit.as_ref().and_then(|audit| audit.wake_us())).min()?;
        Some(due.saturating_sub(self.gate.now_us()).max(PATIENCE_US))
    }

    /// Shows what it is like now.
    fn show(&mut self) {
        self.counters.audit_lost = self.recorders.audit.as_ref().map_or(0, |audit| audit.lost());
        self.counters.frames_lost = self.recorders.frames.as_ref().map_or(0, |frames| frames.lost());
        self.counters.requests.clone_from(&self.shared.requests);
        let mut view = self.common.view();
        view.counters.clone_from(&self.counters);
        view.connections.clear();
        view.connections.extend(self.connections.values().map(Connection::view));
    }
}

/// The address that a server listens at, if it is one alone, of IPv4.
fn address_of(listener: &TcpListener) -> Option<Ipv4Addr> {
    match listener.local_addr().ok()?.ip().to_canonical() {
        IpAddr::V4(address) if !address.is_unspecified() => Some(address),
        IpAddr::V4(_) | IpAddr::V6(_) => None,
    }
}
