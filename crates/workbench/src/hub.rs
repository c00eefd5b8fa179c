//! What all pages look at: one look at the CPU for all of them, as often as pages can show it.
//!
//! Values come from where the replay of a scan ends, so that all of a message belongs to one scan, and the scan itself is held up by one copy.
//! Where no scan runs they are read at the gate.

use std::collections::{BTreeMap, HashMap};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use serde_json::{Value as Json, json};
use sieben_cpu::{Cpu, OperatingMode, Station};
use sieben_engine::{Machine, StatementEvent};
use sieben_lang::reason as lang;
use sieben_model::block::BlockId;
use sieben_model::item::Item;
use sieben_model::value::Value;
use sieben_sim::names::{Name, Shown};
use sieben_sim::wrap;
use sieben_workspace::control::CurrentFacts;
use sieben_workspace::names::shown_json;
use sieben_workspace::past::Viewer;
use sieben_workspace::refusal::capitalized;
use sieben_workspace::status::{Calls, Desk, Look, Onlooker, Sample, Written};
use sieben_workspace::{Closed, Gate, Plant, Speed};
use tokio::sync::watch;

use crate::changes::Authors;
use crate::clients::Rates;
use crate::cpu::{lamps, leds};
use crate::forces::Forces;
use crate::live::content::Content;
use crate::live::message::Common;
use crate::live::program::{Known, Said, Speech};
use crate::live::shot::{Head, Shot};
use crate::live::wanted::{AllWanted, Wanted};
use crate::lock;
use crate::moment::{Reasons, statements};
use crate::reference::{Reference, View};

/// Time between two looks, in milliseconds: pages are sent 20 messages a second.
const LOOK_MS: u64 = 50;
/// How long a scan that is due is waited for before values are read without one.
const WAIT: Duration = Duration::from_millis(2 * LOOK_MS);
/// What is asked for seldom is looked at every so many looks.
const SELDOM: u64 = 10;
/// Pages that are connected at most.
pub const PAGES_MAX: usize = 100;
/// Places among them that are kept for pages that may change something.
const PROGRAM_PAGES: usize = 10;

/// A page that is connected.
#[derive(Clone, Debug)]
pub(crate) struct Visitor {
    /// Its address and port.
    pub(crate) peer: String,
    /// What it may do.
    pub(crate) role: crate::access::Role,
}

/// What names mean in a program.
#[derive(Default)]
struct Meant {
    version: u64,
    names: HashMap<String, Option<Item>>,
}

/// What was seen where a scan ended.
struct Seen {
    /// The version of the program that ran.
    version: u64,
    sample: Option<Arc<Sample>>,
    tags: HashMap<String, Json>,
    plant: Option<Content>,
    mode: OperatingMode,
    scan: u64,
    time_us: u64,
}

/// The last scan as it was run again while no other came.
#[derive(Default)]
struct Stood {
    /// The version of the program that ran.
    version: u64,
    viewer: Viewer,
    known: Option<(u64, Wanted, Arc<Sample>, Reasons)>,
}

/// What all pages look at.
pub(crate) struct Hub {
    /// The way in to the CPU.
    pub(crate) gate: Arc<Gate>,
    /// Where the status of scans is asked for.
    pub(crate) desk: Arc<Desk>,
    /// What is known of the program.
    pub(crate) facts: Arc<CurrentFacts>,
    /// Answers questions about the program as a whole.
    pub(crate) reference: Arc<dyn Reference>,
    /// What pages want.
    pub(crate) wanted: AllWanted,
    /// Why operands are forced.
    pub(crate) forces: Forces,
    /// How often clients ask.
    rates: Rates,
    /// Who changed what.
    pub(crate) authors: Arc<Authors>,
    visitors: Mutex<BTreeMap<u64, Visitor>>,
    next: AtomicU64,
    program: Mutex<Arc<Known>>,
    meant: Mutex<Meant>,
    reasons: Mutex<Reasons>,
    stood: Mutex<Stood>,
    seen: Mutex<Option<Seen>>,
    newest: watch::Sender<Option<Arc<Shot>>>,
    ends: AtomicBool,
}

/// A value as pages take it: bits as true and false.
fn value_json(value: &Value) -> Json {
    match value.shown() {
        Shown::Bit(bit) => json!(bit),
        shown => shown_json(&shown),
    }
}

impl Hub {
    /// Pages of a run.
    pub(crate) fn new(gate: Arc<Gate>, desk: Arc<Desk>, facts: Arc<CurrentFacts>, reference: Arc<dyn Reference>) -> Self {
        let program = Mutex::new(Arc::new(Known::new(facts.version(), facts.facts())));
        Self {
            gate,
            desk,
            facts,
            reference,
            wanted: AllWanted::default(),
            forces: Forces::default(),
            rates: Rates::default(),
            authors: Arc::default(),
            visitors: Mutex::default(),
            next: AtomicU64::new(1),
            program,
            meant: Mutex::default(),
            reasons: Mutex::default(),
            stood: Mutex::default(),
            seen: Mutex::default(),
            newest: watch::Sender::new(None),
            ends: AtomicBool::new(false),
        }
    }

    /// The program that runs.
    pub(crate) fn program(&self) -> Arc<Known> {
        let version = self.facts.version();
        let mut program = lock(&self.program);
        if program.version != version {
            let known = Known::new(version, self.facts.facts());
            if known.facts.run != program.facts.run {
                // What was forced and seen was on another CPU.
                self.forces.forget();
                lock(&self.reasons).clear();
            }
            *program = Arc::new(known);
        }
        Arc::clone(&program)
    }

    /// Tells of each new look.
    pub(crate) fn looks(&self) -> watch::Receiver<Option<Arc<Shot>>> {
        self.newest.subscribe()
    }

    /// A page comes; `None` if there are too many.
    pub(crate) fn enter(&self, visitor: Visitor) -> Option<u64> {
        let mut visitors = lock(&self.visitors);
        let places = if visitor.role == crate::access::Role::Program { PAGES_MAX } else { PAGES_MAX - PROGRAM_PAGES };
        (visitors.len() < places).then(|| {
            let page = self.next.fetch_add(1, Ordering::Relaxed);
            visitors.insert(page, visitor);
            self.wanted.set(page, Some(Wanted::default()));
            page
        })
    }

    /// A page goes.
    pub(crate) fn leave(&self, page: u64) {
        lock(&self.visitors).remove(&page);
        self.wanted.set(page, None);
    }

    /// Ends the looks soon.
    pub(crate) fn end(&self) {
        self.ends.store(true, Ordering::Release);
    }

    /// Whether the run or the server is over.
    pub(crate) fn is_over(&self) -> bool {
        self.ends.load(Ordering::Acquire) || self.gate.is_closed()
    }

    /// Looks at the CPU until the end: the body of a thread.
    pub(crate) fn watch(&self) {
        let (mut number, mut looks) = (0, 0_u64);
        let mut look: Option<(Arc<Wanted>, Look<'_>)> = None;
        while !self.is_over() {
            if self.wanted.pages() == 0 {
                look = None;
                std::thread::sleep(Duration::from_millis(LOOK_MS));
                continue;
            }
            let began_us = self.gate.now_us();
            let wanted = self.wanted.together();
            if !wanted.needs_replay() {
                look = None;
            } else if look.as_ref().is_none_or(|(before, _)| before.calls != wanted.calls) {
                // The new look begins before the old one ends.
                look = Some((Arc::clone(&wanted), self.desk.look(wanted.calls.iter().copied())));
            }
            let waited = look.as_ref().and_then(|_| self.desk.wait_for_sample(number, WAIT));
            if let Some((newest, _)) = &waited {
                number = *newest;
            }
            looks += 1;
            match self.look(&wanted, waited.is_some(), looks) {
                Ok(shot) => drop(self.newest.send_replace(Some(Arc::new(shot)))),
                Err(Closed) => break,
            }
            let took_us = self.gate.now_us().saturating_sub(began_us);
            let rest = (LOOK_MS * 1_000).saturating_sub(took_us);
            if rest > 0 {
                std::thread::sleep(Duration::from_micros(rest));
            }
        }
        self.newest.send_replace(None);
    }

    /// One look: at what the replay has seen, else at the CPU as it stands.
    fn look(&self, wanted: &Wanted, was_replayed: bool, looks: u64) -> Result<Shot, Closed> {
        let taken = if was_replayed { lock(&self.seen).take() } else { None };
        let (program, before, is_replayed, (mut head, standing, lamps)) = loop {
            let program = self.program();
            let before = self.before(&program);
            let items = self.items(wanted, &program);
            // A replay that is slower than the looks before it is not shown after them.
            let is_next = |seen: &Seen| before.as_ref().is_none_or(|shot| shot.head.scan <= seen.scan);
            let is_replayed = taken.as_ref().is_some_and(|seen| seen.version == program.version && is_next(seen));
            let looked = self.gate.look(|plant| {
                // Programs take over between two scans: at the gate it is certain which one runs.
                (self.facts.version() == program.version).then(|| {
                    let standing = (!is_replayed).then(|| see(&plant.cpu, &items, wanted));
                    (self.head(plant), standing, lamps(&plant.cpu))
                })
            })?;
            if let Some(looked) = looked {
                break (program, before, is_replayed, looked);
            }
        };
        let replayed = taken.filter(|_| is_replayed);
        let mut reasons = lock(&self.reasons).clone();
        let seen = match replayed {
            // A CPU in STOP shows its last scan: what is replayed then has no statements.
            Some(seen) if seen.mode == OperatingMode::Stop => {
                Seen { sample: self.last_sample(head.newest, (wanted, &program), &mut reasons), ..seen }
            }
            Some(seen) => seen,
            None => {
                let (tags, plant) = standing.unwrap_or_default();
                let newest = self.last_sample(head.newest, (wanted, &program), &mut reasons);
                Seen { version: program.version, sample: newest, tags, plant, mode: head.mode, scan: head.newest, time_us: head.newest_us }
            }
        };
        head.scan = seen.scan;
        head.time_us = seen.time_us;
        head.mode = seen.mode;
        head.same = seen.sample.as_ref().is_none_or(|sample| sample.same);
        let mut common = self.common(wanted, &program, looks);
        if let Some(plant) = seen.plant {
            common.insert(Common::Plant, plant);
        }
        if wanted.common.contains(&Common::Leds) {
            common.insert(Common::Leds, leds(seen.mode, lamps));
        }
        let flows = self.flows(wanted, &program, seen.sample.as_deref(), before.as_deref());
        let (position, pending) = Default::default();
        Ok(Shot { head, program, sample: seen.sample, position, pending, reasons, flows, tags: seen.tags, common })
    }

    /// What the lines of networks carry in a scan; where their block did what it did before they carry the same.
    pub(crate) fn flows(
        &self,
        wanted: &Wanted,
        program: &Known,
        sample: Option<&Sample>,
        before: Option<&Shot>,
    ) -> HashMap<(Calls, View, u32), Json> {
        let (Some(build), Some(sample)) = (&program.facts.build, sample) else { return HashMap::new() };
        let before = before.filter(|before| before.program.version == program.version);
        let known = |of: &(Calls, View, u32)| {
            let before = before?;
            let same = before.sample.as_ref()?.of(of.0).eq(sample.of(of.0));
            before.flows.get(of).filter(|_| same).cloned()
        };
        let flow = |&of: &(Calls, View, u32)| {
            let (calls, view, network) = of;
            let mut after = sample.of(calls).map(|(number, status)| (number, status.after.clone()));
            (of, known(&of).unwrap_or_else(|| self.reference.flow(build, (calls.block, network, view), &mut after)))
        };
        wanted.flows.iter().filter(|(calls, ..)| sample.calls.contains(calls)).map(flow).collect()
    }

    /// The look before, if it was at the same CPU.
    fn before(&self, program: &Known) -> Option<Arc<Shot>> {
        self.newest.borrow().clone().filter(|shot| shot.program.facts.run == program.facts.run)
    }

    /// The last scan where no new one came: what was seen of it, else it is run again. While time stands still other blocks are looked at too.
    fn last_sample(&self, newest: u64, (wanted, program): (&Wanted, &Known), reasons: &mut Reasons) -> Option<Arc<Sample>> {
        if wanted.calls.is_empty() {
            return None;
        }
        let has_all = |sample: &Sample, reasons: &Reasons| {
            let said = |place: &(Calls, u32)| reasons.contains_key(place) || !sample.statements.contains_key(place);
            sample.scan == newest
                && !sample.statements.is_empty()
                && wanted.calls.iter().all(|calls| sample.calls.contains(calls))
                && wanted.reasons.iter().all(said)
        };
        let seen = self.before(program).and_then(|shot| shot.sample.clone());
        if let Some(sample) = seen.filter(|sample| has_all(sample, reasons)) {
            return Some(sample);
        }
        let mut stood = lock(&self.stood);
        if stood.version != program.version {
            *stood = Stood { version: program.version, ..Stood::default() };
        }
        let Stood { viewer, known, .. } = &mut *stood;
        let same = |known: &(u64, Wanted, Arc<Sample>, Reasons)| {
            known.0 == newest && known.1.calls == wanted.calls && known.1.reasons == wanted.reasons
        };
        if !known.as_ref().is_some_and(same) {
            let run = statements(self, viewer, newest, (wanted, program)).ok();
            *known = run.map(|(sample, said)| (newest, wanted.clone(), Arc::new(sample), said));
        }
        let (_, _, sample, said) = known.as_ref()?;
        reasons.clone_from(said);
        lock(&self.reasons).clone_from(said);
        Some(Arc::clone(sample))
    }

    fn head(&self, plant: &Plant) -> Head {
        let cpu = &plant.cpu;
        let stopped = cpu.stop_cause().filter(|_| cpu.mode() == OperatingMode::Stop);
        Head {
            scan: plant.scans,
            time_us: cpu.time_us(),
            mode: cpu.mode(),
            oldest: self.desk.past().range().map_or(plant.scans, |(first, _)| first.scan.min(plant.scans)),
            newest: plant.scans,
            newest_us: cpu.time_us(),
            paused: plant.pace.is_paused(),
            speed: match plant.pace.speed() {
                Speed::Factor(factor) => factor,
                Speed::Max => 0.0,
            },
            same: true,
            why: stopped.map(|cause| cause.text.clone()),
        }
    }

    /// Names with the items that they mean in this program.
    fn items(&self, wanted: &Wanted, program: &Known) -> Vec<(String, Option<Item>)> {
        let mut meant = lock(&self.meant);
        if meant.version != program.version {
            *meant = Meant { version: program.version, ..Meant::default() };
        }
        meant.names.retain(|name, _| wanted.names.contains(name));
        let item = |name: &String| {
            let known = meant.names.entry(name.clone()).or_insert_with(|| item_of(name, program));
            (name.clone(), known.clone())
        };
        wanted.names.iter().map(item).collect()
    }

    /// What is the same for all pages.
    fn common(&self, wanted: &Wanted, program: &Known, looks: u64) -> BTreeMap<Common, Content> {
        let before = self.before(program);
        let mut common = BTreeMap::new();
        for &one in &wanted.common {
            // What moves slowly, and takes more than a look, is the one of before most of the time.
            let known = before.as_ref().and_then(|shot| shot.common.get(&one).cloned());
            let content = match (one, known) {
                (Common::Plant | Common::Leds, _) => continue,
                (Common::Changes, _) => self.changes(program),
                (_, Some(known)) if !looks.is_multiple_of(SELDOM) => known,
                (Common::Clients, _) => Content::Whole(self.clients()),
                (Common::Diagnostics, _) => Content::Whole(self.diagnostics(program)),
                (Common::Cycle, _) => self.cycle(),
                (Common::Forces, _) => Content::Whole(self.forces.json(self)),
            };
            common.insert(one, content);
        }
        common
    }

    /// Clients of servers, and pages.
    pub(crate) fn clients(&self) -> Json {
        let servers = self.rates.json(self.facts.clients(), &self.facts.facts(), self.gate.now_us());
        let page = |(number, visitor): (&u64, &Visitor)| {
            json!({
                "id": format!("page {number}"), "name": "page", "protocol": "HTTP", "peer": visitor.peer, "role": visitor.role.word(),
                "reads": 0, "writes": 0,
            })
        };
        servers.into_iter().chain(lock(&self.visitors).iter().map(page)).collect()
    }
}

/// What is read at one moment: values by name, and the plants.
pub(crate) fn see(cpu: &Cpu, items: &[(String, Option<Item>)], wanted: &Wanted) -> (HashMap<String, Json>, Option<Content>) {
    let list: Vec<Item> = items.iter().filter_map(|(_, item)| item.clone()).collect();
    let mut values = cpu.read_items(&list).into_iter();
    let tags = items.iter().map(|(name, item)| {
        let value = item.as_ref().and_then(|_| values.next()).and_then(Result::ok);
        let is_formatted = name.contains(',');
        let json = match value {
            Some(value) if is_formatted => json!(value.shown().readable()),
            Some(value) => value_json(&value),
            None => Json::Null,
        };
        (name.clone(), json)
    });
    let plant = wanted.common.contains(&Common::Plant).then(|| {
        let put_out = cpu.rack().outputs();
        Content::Whole(wrap::plants(cpu.rack()).map(|plant| plant_json(plant, put_out)).collect())
    });
    (tags.collect(), plant)
}

/// What a name means: `MW 10`, or `MW 10,HEX` with the format of a watch table.
pub(crate) fn item_of(name: &str, program: &Known) -> Option<Item> {
    let facts = &program.facts;
    let meant = match name.rsplit_once(',') {
        Some((plain, format)) if !format.contains(']') => {
            let formatted = if format.trim().is_empty() { plain.to_owned() } else { format!("{plain}:{format}") };
            Name::parse(&formatted, &facts.symbols, &facts.program)
        }
        _ => Name::parse(name, &facts.symbols, &facts.program),
    };
    meant.ok().map(|name| name.readable().item().clone())
}

/// A plant as it is now; `put_out` are all bytes that the CPU has put out, some of which a plant may show that are not its own.
fn plant_json(plant: &wrap::Plant, put_out: &[u8]) -> Json {
    use sieben_cpu::IoModule;
    let mut inputs = vec![0_u8; plant.inputs().len()];
    plant.read(0, &mut inputs);
    let state = plant.device().state().into_iter().chain(plant.device().shown(put_out));
    json!({
        "kind": plant.kind().name, "name": plant.name(), "input": plant.inputs().start, "output": plant.outputs().start,
        "parameters": plant.device().settings().parameters, "inputs": inputs, "outputs": plant.commands(),
        "state": state.map(|(name, value, unit)| json!([name, value, unit])).collect::<Json>(),
        "faults": plant.faults().map(ToString::to_string).collect::<Vec<_>>(),
        "acting": plant.acting_faults().map(ToString::to_string).collect::<Vec<_>>(),
    })
}

/// Why a statement did what it did.
pub(crate) fn reasons_of(program: &Known, machine: &Machine, event: &StatementEvent) -> Option<Arc<Said>> {
    let build = program.facts.build.as_ref()?;
    let reasons = lang::Reasons::new(&build.compiled, &build.project.texts.program, &build.project.symbols);
    let moment = lang::Moment { event, before: None, after: machine, fault: None };
    let say = |speech: Speech| {
        let reasons = speech.mnemonics.map_or(reasons, |mnemonics| reasons.spelled(program.spelled(mnemonics)));
        format!("{}.", capitalized(&reasons.sentence(&moment, speech.language)))
    };
    Some(Arc::new(Said::new(say)))
}

impl Onlooker for Hub {
    fn statement(&self, calls: Calls, machine: &Machine, event: &StatementEvent) {
        let place = (calls, event.place.statement);
        if !self.wanted.together().reasons.contains(&place) {
            return;
        }
        if let Some(said) = reasons_of(&self.program(), machine, event) {
            lock(&self.reasons).insert(place, said);
        }
    }

    fn written(&self, block: BlockId) -> Option<Written> {
        Some(self.program().written(block))
    }

    fn ended(&self, cpu: &Cpu, sample: &Arc<Sample>) {
        let wanted = self.wanted.together();
        let program = self.program();
        let items = self.items(&wanted, &program);
        let (tags, plant) = see(cpu, &items, &wanted);
        lock(&self.reasons).retain(|place, _| wanted.reasons.contains(place) && sample.statements.contains_key(place));
        let version = program.version;
        let seen =
            Seen { version, sample: Some(Arc::clone(sample)), tags, plant, mode: cpu.mode(), scan: sample.scan, time_us: sample.time_us };
        *lock(&self.seen) = Some(seen);
    }
}
