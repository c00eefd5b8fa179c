//! What can be asked of a running project and done to it: requests and answers as data, and as lines of JSON.
//!
//! Who carries the lines (a socket, a page) is no matter of this module. One [`Control`] serves one client.

pub mod answer;
pub mod changes;
pub mod facts;
pub mod listing;
pub mod plants;
pub mod request;
mod status;
pub mod table;

use std::collections::HashMap;
use std::sync::Arc;
use std::time::Duration;

pub use answer::{Answer, line};
use answer::{Blocks, Changes, Diagnostics, Done, Entry, Mode, State, Stop, Time, Values};
pub use facts::{Client, Clients, Connection, CurrentFacts, Facts, LastWrite};
use request::shortened;
pub use request::{FaultChange, LINE_BYTES_MAX, ModeChange, Request, TimeChange, Wait, parse, too_long};
use sieben_cpu::communication::Requester;
use sieben_cpu::diagnostic_buffer::place_text;
use sieben_cpu::{AccessError, OperatingMode, Restart, Station};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::block::BlockId;
use sieben_model::item::{Item, Place};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::value::{Kind, Value};
use sieben_sim::names::{Name, NameError};
use sieben_sim::wrap::Fault;
pub use table::watched;

use crate::gate::{Closed, Gate, ITEMS_MAX, ListError, Plant};
use crate::refusal::Refusal;
use crate::status::{Desk, Written};

/// Longest name that is kept, in bytes.
const NAME_BYTES_MAX: usize = 200;
/// Names that a client's control keeps; more of them are read again each time.
const NAMES_MAX: usize = 10_000;
/// Bytes of values that one request reads or writes: an answer stays below a megabyte.
const VALUE_BYTES_MAX: u64 = 64 * 1024;
/// Blocks in one answer.
const BLOCKS_MAX: usize = 1_000;
/// How often a request begins again because an online change came between its names and its values.
const TRIES_MAX: usize = 10;
/// How long a request waits for what it asked for to be done.
const WAIT_MAX: Duration = Duration::from_secs(2);
/// How long it waits before it looks again.
const LOOK: Duration = Duration::from_millis(100);

/// The peer of what comes over the control socket.
const SOCKET: &str = "control socket";

/// One client of a run: it remembers what names mean.
pub struct Control {
    /// What it is called in the log of changes.
    peer: String,
    current: Arc<CurrentFacts>,
    facts: Arc<Facts>,
    version: u64,
    names: HashMap<String, Result<Name, NameError>>,
    /// The variables that blocks of ST write.
    written: HashMap<BlockId, Written>,
}

/// Names with what they mean, or why they mean nothing.
type Meant<T> = Vec<(String, Result<T, Refusal>)>;

/// Values that are to be written.
struct Writing {
    pairs: Vec<(Name, Value)>,
    list: Vec<(Item, Value)>,
    items: Vec<Item>,
}

impl From<Closed> for Refusal {
    fn from(closed: Closed) -> Self {
        Self::new(Problem::P7094, closed.to_string())
    }
}

impl From<ListError> for Refusal {
    fn from(error: ListError) -> Self {
        match error {
            ListError::Closed => Closed.into(),
            ListError::TooLong(_) => Self::new(Problem::P7092, error.to_string()),
        }
    }
}

fn unknown(error: &NameError) -> Refusal {
    crate::names::refused(error)
}

fn unfit(error: &NameError) -> Refusal {
    Refusal::new(crate::names::problem_of_value(error), error.to_string())
}

/// Something changed while it was asked for.
fn changing() -> Refusal {
    Refusal::new(Problem::P7093, "the program is changed again and again; ask once more")
}

impl Control {
    /// A client of a run whose program is known by these facts.
    pub fn new(current: Arc<CurrentFacts>) -> Self {
        Self::of_peer(current, SOCKET.to_owned())
    }

    /// The same for a client that comes from elsewhere.
    pub fn of_peer(current: Arc<CurrentFacts>, peer: String) -> Self {
        let (version, facts) = (current.version(), current.facts());
        Self { peer, current, facts, version, names: HashMap::new(), written: HashMap::new() }
    }

    /// Answers one line of JSON with another.
    pub fn answer_line(&mut self, gate: &Gate, desk: &Desk, line: &[u8]) -> String {
        let (id, request) = parse(line);
        let answer = request.and_then(|request| self.answer(gate, desk, &request));
        answer::line(&id, &answer)
    }

    /// Answers a request. It takes as long as the gate lets it wait; a start, scans that were asked for and a status take up to two seconds.
    ///
    /// # Errors
    /// The request cannot be met; nothing was changed.
    pub fn answer(&mut self, gate: &Gate, desk: &Desk, request: &Request) -> Result<Answer, Refusal> {
        self.refresh();
        let answer = self.answer_now(gate, desk, request);
        self.current.tell_changes(&self.peer, || changes::of(request, &answer));
        answer
    }

    fn answer_now(&mut self, gate: &Gate, desk: &Desk, request: &Request) -> Result<Answer, Refusal> {
        match request {
            Request::State => self.state(gate).map(|state| Answer::State(Box::new(state))),
            Request::Read(names) => self.read(gate, names).map(Answer::Values),
            Request::Write(values) => self.write(gate, values).map(Answer::Done),
            Request::Force(values) => self.force(gate, values).map(Answer::Done),
            Request::Unforce(names) => self.unforce(gate, names).map(Answer::Done),
            Request::UnforceAll => {
                let scan = gate.enter(|plant| {
                    plant.cpu.unforce_all();
                    plant.scans
                })?;
                Ok(Answer::Done(Done { scan: Some(scan), items: Vec::new() }))
            }
            Request::Diagnostics { after } => self.diagnostics(gate, *after).map(Answer::Diagnostics),
            Request::Blocks { from } => self.blocks(gate, *from).map(Answer::Blocks),
            Request::Status { block, after, from, wait } => {
                status::status(gate, desk, (&self.facts, &mut self.written), (block, *after, *from, *wait))
                    .map(|status| Answer::Status(Box::new(status)))
            }
            Request::Mode(change) => mode(gate, *change).map(Answer::Mode),
            Request::Time(change) => time(gate, *change).map(Answer::Time),
            Request::Faults(change) => plants::faults(gate, change).map(Answer::Faults),
            Request::Plants => Ok(Answer::Plants(plants::plants(gate, &self.facts)?)),
            Request::Listing { block, from } => listing::listing(&self.facts, block.as_deref(), *from).map(Answer::Listing),
            Request::Names { from } => Ok(Answer::Names(table::table(gate, &self.facts, *from)?)),
            Request::Changes { after } => self.changes(gate, desk, *after).map(Answer::Changes),
            Request::Press { items, ms } => self.press(gate, items, *ms).map(Answer::Done),
        }
    }

    /// Takes the newest facts; what names meant in another program is forgotten.
    fn refresh(&mut self) {
        let version = self.current.version();
        if version != self.version {
            self.facts = self.current.facts();
            self.version = version;
            self.names.clear();
            self.written.clear();
        }
    }

    /// What a name means.
    fn name(&mut self, text: &str) -> Result<Name, Refusal> {
        if let Some(known) = self.names.get(text) {
            return known.clone().map_err(|error| unknown(&error));
        }
        let name = Name::parse(text, &self.facts.symbols, &self.facts.program);
        if text.len() <= NAME_BYTES_MAX {
            if self.names.len() >= NAMES_MAX {
                self.names.clear();
            }
            self.names.insert(text.to_owned(), name.clone());
        }
        name.map_err(|error| unknown(&error))
    }

    fn named<'a>(&mut self, names: impl IntoIterator<Item = &'a String>) -> Result<Meant<Name>, Refusal> {
        let meant: Meant<Name> = names.into_iter().map(|text| (text.clone(), self.name(text))).collect();
        let bytes: u64 = meant.iter().filter_map(|(_, name)| name.as_ref().ok()).map(|name| bytes_of(name.item())).sum();
        match bytes > VALUE_BYTES_MAX {
            true => Err(Refusal::new(
                Problem::P7092,
                format!("these items have {bytes} bytes; one request reads or writes at most {VALUE_BYTES_MAX}"),
            )),
            false => Ok(meant),
        }
    }

    /// Names with their values, all of which have to be right.
    fn settings(&mut self, values: &[(String, String)]) -> Result<Meant<(Name, Value)>, Refusal> {
        let names = self.named(values.iter().map(|(name, _)| name))?;
        let texts = values.iter().map(|(_, text)| text.as_str());
        Ok(names.into_iter().zip(texts).map(|((name, meant), text)| (name, meant.and_then(|meant| setting(meant, text)))).collect())
    }

    /// Does something with what names mean in the program that runs. Where an online change comes between the names and the work, both begin
    /// again. Work that changes something says so ([`Plant::touch`]).
    ///
    /// # Errors
    /// What `mean` answers instead, without any work; or the refusal.
    fn at_one_program<N, R, A>(
        &mut self,
        gate: &Gate,
        mean: impl Fn(&mut Self) -> Result<N, Result<A, Refusal>>,
        work: impl Fn(&N, &mut Plant) -> R,
    ) -> Result<(N, R), Result<A, Refusal>> {
        for _ in 0..TRIES_MAX {
            let names = mean(self)?;
            let is_current = || self.current.version() == self.version;
            let done = gate.serve(|plant| is_current().then(|| work(&names, plant))).map_err(|closed| Err(closed.into()))?;
            match done {
                Some(done) => return Ok((names, done)),
                None => self.refresh(),
            }
        }
        Err(Err(changing()))
    }

    /// Names with their values, or the answer that nothing was done as some of them are wrong.
    fn right_settings(&mut self, values: &[(String, String)]) -> Result<Vec<(Name, Value)>, Result<Done, Refusal>> {
        let meant = self.settings(values).map_err(Err)?;
        all_right(&meant).ok_or_else(|| Ok(nothing_done(meant)))
    }

    fn state(&self, gate: &Gate) -> Result<State, Refusal> {
        let (mut state, cause, forced) = gate.look(|plant| {
            let cpu = &plant.cpu;
            let state = State {
                project: None,
                page: None,
                run: self.facts.run,
                version: self.version,
                cpu: cpu.cpu_type().name,
                mode: cpu.mode(),
                stop: None,
                scans: plant.scans,
                time_us: plant.pace.time_us(gate.now_us()).min(plant.pace.end_us),
                clock: cpu.clock().display(),
                cycle: cpu.cycle_times(),
                speed: plant.pace.speed(),
                paused: plant.pace.is_paused(),
                forced: Vec::new(),
                forced_count: 0,
                connections: 0,
                clients: Vec::new(),
                newest_entry: cpu.diagnostic_buffer().newest_number(),
            };
            let cause = cpu.stop_cause().filter(|_| cpu.mode() == OperatingMode::Stop).cloned();
            (state, cause, cpu.forced().bytes().collect::<Vec<_>>())
        })?;
        state.project.clone_from(&self.facts.project);
        state.page = self.current.page();
        state.connections = self.current.connections();
        state.clients = self.current.clients();
        state.stop = cause.map(|cause| Stop {
            event: cause.event,
            first_event: cause.first_event,
            place: cause.place.map(|place| self.facts.places().of(place)),
            text: self.called(&cause.text, cause.place),
        });
        let mut all: Vec<(String, String)> = forced.into_iter().flat_map(forced_texts).collect();
        state.forced_count = all.len();
        all.truncate(ITEMS_MAX);
        state.forced = all;
        Ok(state)
    }

    /// What the CPU says, with the block as people call it: the CPU knows no names.
    fn called(&self, text: &str, place: Option<sieben_engine::FaultPlace>) -> String {
        let named = place.and_then(|place| Some((place, self.facts.block_names.get(&place.block)?)));
        named.map_or_else(|| text.to_owned(), |(place, name)| text.replace(&place_text(place), &format!("in `{name}`")))
    }

    fn read(&mut self, gate: &Gate, names: &[String]) -> Result<Values, Refusal> {
        let mean = |this: &mut Self| {
            let meant = this.named(names).map_err(Err)?;
            // To people a timer is the time that it has left.
            let items: Vec<Item> = meant.iter().filter_map(|(_, name)| Some(name.as_ref().ok()?.item().clone().readable())).collect();
            Ok((meant, items))
        };
        let read =
            |(_, items): &(Meant<Name>, Vec<Item>), plant: &mut Plant| (plant.scans, plant.cpu.read_items(items), plant.cpu.cpu_type());
        let ((meant, _), (scan, values, cpu_type)) = match self.at_one_program(gate, mean, read) {
            Ok(done) => done,
            Err(early) => return early,
        };
        let mut values = values.into_iter();
        let value = |(text, name): (String, Result<Name, Refusal>)| {
            let value = name.and_then(|name| {
                let value = values.next().unwrap_or(Err(AccessError::NotAccessible));
                value.map_err(|error| unknown(&name.refused("read", error, cpu_type)))
            });
            (text, value)
        };
        Ok(Values { scan, items: meant.into_iter().map(value).collect() })
    }

    /// Writes all of the values, or none: a name that means nothing, a value that does not fit and an item that is not there keep back all
    /// others. What can be read and not be set is told when it is tried; the others are set then.
    fn write(&mut self, gate: &Gate, values: &[(String, String)]) -> Result<Done, Refusal> {
        let mean = |this: &mut Self| {
            let pairs = this.right_settings(values)?;
            let list: Vec<(Item, Value)> = pairs.iter().map(|(name, value)| (name.item().clone(), value.clone())).collect();
            let items: Vec<Item> = list.iter().map(|(item, _)| item.clone()).collect();
            Ok(Writing { pairs, list, items })
        };
        let write = |writing: &Writing, plant: &mut Plant| {
            plant.touch();
            let there = plant.cpu.read_items(&writing.items);
            let absent = there.iter().any(Result::is_err);
            let outcomes =
                if absent { there.into_iter().map(|value| value.map(drop)).collect() } else { plant.cpu.write_items(&writing.list) };
            ((!absent).then_some(plant.scans), outcomes, plant.cpu.cpu_type())
        };
        let (Writing { pairs, .. }, (scan, outcomes, cpu_type)) = match self.at_one_program(gate, mean, write) {
            Ok(done) => done,
            Err(early) => return early,
        };
        let outcome = |((name, _), outcome): (&(Name, Value), Result<(), AccessError>)| {
            let refused = |error| match error {
                AccessError::Value => unfit(&name.refused("set", error, cpu_type)),
                error => unknown(&name.refused("set", error, cpu_type)),
            };
            (name.text().to_owned(), outcome.map_err(refused))
        };
        Ok(Done { scan, items: pairs.iter().zip(outcomes).map(outcome).collect() })
    }

    /// Forces all of the items, or none where a name or a value is wrong. What the CPU type does not force is told for itself.
    fn force(&mut self, gate: &Gate, values: &[(String, String)]) -> Result<Done, Refusal> {
        let force = |pairs: &Vec<(Name, Value)>, plant: &mut Plant| {
            plant.touch();
            let force = |(name, value): &(Name, Value)| {
                (name.text().to_owned(), name.force(&mut plant.cpu, value).map_err(|error| unknown(&error)))
            };
            Done { items: pairs.iter().map(force).collect(), scan: Some(plant.scans) }
        };
        self.at_one_program(gate, |this| this.right_settings(values), force).map_or_else(|early| early, |(_, done)| Ok(done))
    }

    fn unforce(&mut self, gate: &Gate, names: &[String]) -> Result<Done, Refusal> {
        let unforce = |meant: &Meant<Name>, plant: &mut Plant| {
            plant.touch();
            let unforce = |(text, name): &(String, Result<Name, Refusal>)| {
                let done = name.clone().and_then(|name| name.unforce(&mut plant.cpu).map_err(|error| unknown(&error)));
                (text.clone(), done)
            };
            Done { items: meant.iter().map(unforce).collect(), scan: Some(plant.scans) }
        };
        self.at_one_program(gate, |this| this.named(names).map_err(Err), unforce).map_or_else(|early| early, |(_, done)| Ok(done))
    }

    /// Gives bits the other value, and the one that they had after a while; those that are pressed already are left alone.
    fn press(&mut self, gate: &Gate, names: &[String], ms: u64) -> Result<Done, Refusal> {
        let press = |meant: &Meant<Name>, plant: &mut Plant| {
            plant.touch();
            let now_us = plant.pace.time_us(gate.now_us()).max(plant.cpu.time_us());
            plant.pressed.retain(|_, until_us| *until_us > now_us);
            let until_us = now_us.saturating_add(ms.saturating_mul(1_000));
            let press = |(text, name): &(String, Result<Name, Refusal>)| {
                (text.clone(), name.clone().and_then(|name| press(&name, plant, until_us)))
            };
            Done { items: meant.iter().map(press).collect(), scan: Some(plant.scans) }
        };
        self.at_one_program(gate, |this| this.named(names).map_err(Err), press).map_or_else(|early| early, |(_, done)| Ok(done))
    }

    /// What changed, which is looked for from now on.
    fn changes(&self, gate: &Gate, desk: &Desk, after: u64) -> Result<Changes, Refusal> {
        if gate.is_closed() {
            return Err(Closed.into());
        }
        desk.observed.look(self.version, || watched(&self.facts), gate.now_us());
        let (newest, entries) = desk.observed.newer_than(after);
        Ok(Changes { newest, entries })
    }

    fn diagnostics(&self, gate: &Gate, after: u64) -> Result<Diagnostics, Refusal> {
        let (newest, entries) = gate.look(|plant| {
            let buffer = plant.cpu.diagnostic_buffer();
            (buffer.newest_number(), buffer.newer_than(after).map(|(number, entry)| (number, entry.clone())).collect::<Vec<_>>())
        })?;
        let mut places = self.facts.places();
        let entry = |(number, entry): (u64, sieben_cpu::DiagnosticEntry)| Entry {
            number,
            time: entry.time.display(),
            event: entry.event(),
            text: self.called(&entry.text(), entry.place),
            place: entry.place.map(|place| places.of(place)),
        };
        Ok(Diagnostics { newest, entries: entries.into_iter().map(entry).collect() })
    }

    fn blocks(&self, gate: &Gate, from: usize) -> Result<Blocks, Refusal> {
        let ids = gate.look(|plant| plant.cpu.blocks())?;
        let total = ids.len();
        let wanted = ids.into_iter().skip(from).take(BLOCKS_MAX);
        let views = gate.look_for_each(wanted, |plant, id| plant.cpu.block(id))?;
        let next = from.saturating_add(views.len());
        let named = |view: sieben_cpu::BlockView| {
            let name = self.facts.block_names.get(&view.id).cloned();
            (view, name)
        };
        Ok(Blocks { total, next: (next < total).then_some(next), blocks: views.into_iter().flatten().map(named).collect() })
    }
}

/// Gives a bit the other value until this time of the CPU, unless it is pressed already.
fn press(name: &Name, plant: &mut Plant, until_us: u64) -> Result<(), Refusal> {
    let Some(&Operand::Address(Address { area: Area::Input | Area::PeripheralInput, width: Width::Bit, byte, bit: number })) =
        name.operand()
    else {
        return Err(Refusal::new(Problem::P7104, format!("`{}` is no input bit, which alone can be pressed", shortened(name.text()))));
    };
    if plant.pressed.contains_key(&(byte, number)) {
        return Ok(());
    }
    let refused = |error: NameError| unknown(&error);
    let bit = |value: bool| Value::bits(Kind::Bit, u64::from(value));
    // The module has what the process image only sees with the next scan.
    let is_on = match plant.cpu.rack().peripheral_read(byte, Width::Byte) {
        Some(byte) => byte >> number & 1 == 1,
        None => name.content(&plant.cpu).map_err(refused)?.bits().is_some_and(|bits| bits != 0),
    };
    name.set(&mut plant.cpu, &bit(!is_on)).map_err(refused)?;
    name.set_at(&mut plant.cpu, &bit(is_on), until_us).map_err(refused)?;
    plant.pressed.insert((byte, number), until_us);
    Ok(())
}

/// A name with the value that a text means for it.
fn setting(name: Name, text: &str) -> Result<(Name, Value), Refusal> {
    match name.value(text) {
        Ok(value) => Ok((name, value)),
        Err(error) => Err(unfit(&error)),
    }
}

/// All names with their values, if none of them is wrong.
fn all_right(meant: &Meant<(Name, Value)>) -> Option<Vec<(Name, Value)>> {
    meant.iter().map(|(_, setting)| setting.as_ref().ok().cloned()).collect()
}

fn nothing_done(meant: Meant<(Name, Value)>) -> Done {
    Done { scan: None, items: meant.into_iter().map(|(text, setting)| (text, setting.map(drop))).collect() }
}

/// Bytes that the value of an item has at most.
fn bytes_of(item: &Item) -> u64 {
    match (&item.place, item.kind.plain()) {
        (Place::Bytes(bytes), _) => u64::from(bytes.length),
        (_, Kind::Typed(data_type)) => data_type.bits().div_ceil(8),
        _ => 8,
    }
}

/// Forced bits of a byte as people write them.
fn forced_texts((area, byte, mask, value): (Area, u32, u8, u8)) -> Vec<(String, String)> {
    let text = |width, bit| Address { area, width, byte, bit }.spell(Mnemonics::English);
    if mask == u8::MAX {
        return vec![(text(Width::Byte, 0), format!("16#{value:02X}"))];
    }
    let bits = (0..8_u8).filter(|bit| mask >> bit & 1 == 1);
    bits.map(|bit| (text(Width::Bit, bit), (value >> bit & 1).to_string())).collect()
}

/// The CPU does not do this in its mode.
fn not_now(error: impl std::fmt::Display) -> Refusal {
    Refusal::new(Problem::P7093, error.to_string())
}

fn mode(gate: &Gate, change: ModeChange) -> Result<Mode, Refusal> {
    let now = |plant: &Plant| Mode { mode: plant.cpu.mode(), scans: plant.scans };
    match change {
        ModeChange::Stop => Ok(gate.command(|plant| {
            plant.stop(Requester::default());
            now(plant)
        })?),
        ModeChange::MemoryReset => {
            gate.command(|plant| Station::memory_reset(&mut plant.cpu, Requester::default()).map(|()| now(plant)).map_err(not_now))?
        }
        ModeChange::Run(restart) => start(gate, restart),
    }
}

/// Starts a CPU in STOP and waits for what comes of it.
fn start(gate: &Gate, restart: Restart) -> Result<Mode, Refusal> {
    gate.command(|plant| match plant.cpu.mode() {
        OperatingMode::Stop => {
            plant.ask_for_start(restart, Requester::default());
            Ok(())
        }
        OperatingMode::Hold => Err(not_now(sieben_cpu::StartRefused::Held)),
        OperatingMode::Run | OperatingMode::Startup => Err(not_now(sieben_cpu::StartRefused::Running)),
    })??;
    wait(gate, |plant| plant.start.is_none().then(|| Mode { mode: plant.cpu.mode(), scans: plant.scans }))?
        .ok_or_else(|| not_now("the start takes longer than two seconds; ask for `state`"))
}

/// Looks at the plant until there is something to be seen, for two seconds at most.
fn wait<R>(gate: &Gate, mut look: impl FnMut(&Plant) -> Option<R>) -> Result<Option<R>, Refusal> {
    let end = gate.now_us().saturating_add(u64::try_from(WAIT_MAX.as_micros()).unwrap_or(u64::MAX));
    loop {
        let points = gate.points();
        if let Some(seen) = gate.look(&mut look)? {
            return Ok(Some(seen));
        }
        if gate.now_us() >= end {
            return Ok(None);
        }
        gate.wait_for_point(points, LOOK);
    }
}

fn time(gate: &Gate, change: TimeChange) -> Result<Time, Refusal> {
    let now = |plant: &Plant| Time {
        paused: plant.pace.is_paused(),
        speed: plant.pace.speed(),
        scans: plant.scans,
        time_us: plant.pace.time_us(gate.now_us()).min(plant.pace.end_us),
        scans_left: plant.pace.steps_left(),
    };
    let changed = gate.command(|plant| {
        let real_us = gate.now_us();
        match change {
            TimeChange::Pause => plant.pace.pause(real_us),
            TimeChange::Go => plant.pace.go(real_us),
            TimeChange::Step(scans) => plant.pace.step(scans, real_us),
            TimeChange::Speed(speed) => plant.pace.set_speed(speed, real_us),
        }
        now(plant)
    })?;
    match change {
        TimeChange::Step(_) => match wait(gate, |plant| (!plant.pace.has_steps()).then(|| now(plant)))? {
            Some(done) => Ok(done),
            None => Ok(gate.look(now)?),
        },
        _ => Ok(changed),
    }
}

/// Reads the input as lines of requests, and their names and values as those of an empty program: a target of the fuzzer.
pub fn fuzz(data: &[u8]) {
    let mut control = Control::new(Arc::new(CurrentFacts::default()));
    for request in data.split(|&byte| byte == b'\n') {
        let (id, request) = parse(request);
        let answer = match &request {
            Ok(Request::Read(names) | Request::Unforce(names) | Request::Press { items: names, .. }) => control.named(names).map(|meant| {
                let none = |(text, name): (String, Result<Name, Refusal>)| (text, name.and_then(|_| Err(changing())));
                Answer::Values(Values { scan: 0, items: meant.into_iter().map(none).collect() })
            }),
            Ok(Request::Write(values) | Request::Force(values)) => control.settings(values).map(|meant| Answer::Done(nothing_done(meant))),
            Ok(Request::Faults(FaultChange::Inject(fault))) => Err(Refusal::new(
                Problem::P6272,
                match Fault::parse(fault) {
                    Ok(fault) => fault.to_string(),
                    Err(message) => message,
                },
            )),
            Ok(Request::Status { block, .. } | Request::Listing { block: Some(block), .. }) => {
                listing::listing(&control.facts, Some(block), 0).map(Answer::Listing)
            }
            Ok(_) => Err(changing()),
            Err(refusal) => Err(refusal.clone()),
        };
        let line = line(&id, &answer);
        assert_eq!(line.matches('\n').count(), 1, "an answer is one line");
        assert!(serde_json::from_str::<serde_json::Value>(&line).is_ok_and(|answer| answer["id"] == id), "an answer is JSON");
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use sieben_cpu::{Cpu, Rack, Settings};
    use sieben_engine::Interpreter;
    use sieben_model::cpu_type::CpuType;

    use super::*;
    use crate::pace::{Pace, Speed};

    #[test]
    fn a_request_begins_again_where_an_online_change_comes_in_between() {
        let rack = Rack::with_background(&CpuType::ALL[0], Vec::new()).expect("an empty rack");
        let cpu = Cpu::load(&CpuType::ALL[0], Arc::default(), Interpreter::load, rack, Settings::default());
        let gate = Gate::new(Plant::new(cpu, Pace::new(Speed::Max, 10_000, u64::MAX, 0)), Box::new(|| 0));
        let ask = |changes: usize| {
            let mut control = Control::new(Arc::default());
            let (meant, done) = (Cell::new(0), Cell::new(0));
            let mean = |control: &mut Control| {
                meant.set(meant.get() + 1);
                if meant.get() <= changes {
                    control.current.replace(Facts::default());
                }
                Ok::<_, Result<(), Refusal>>(meant.get())
            };
            let asked = control.at_one_program(&gate, mean, |_, _| done.set(done.get() + 1));
            (asked.map(|(meant, ())| meant).map_err(|early| early.map_err(|refusal| refusal.problem)), done.get())
        };
        assert_eq!(ask(0), (Ok(1), 1));
        assert_eq!(ask(3), (Ok(4), 1), "work is done once, with the names of the last program");
        assert_eq!(ask(TRIES_MAX), (Err(Err(Problem::P7093)), 0));
        gate.close();
        assert_eq!(ask(0), (Err(Err(Problem::P7094)), 0));
    }
}
