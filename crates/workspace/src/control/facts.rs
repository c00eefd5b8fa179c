//! What is known of the program that runs beside what the CPU has of it: names, and places in the sources.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use sieben_engine::{FaultPlace, Program};
use sieben_lang::body::CheckedBody;
use sieben_lang::references::Usage;
use sieben_lang::references::target::{Extent, Memory, Target};
use sieben_model::address::{Address, Area, Operand};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;
use sieben_sim::names::Scope;

use super::changes::{Change, Listener};
use crate::controller;
use crate::project::Build;

/// A program as people know it.
#[derive(Clone, Debug, Default)]
pub struct Facts {
    /// Which CPU of the run it is in, from 0: [another one](crate::exchange) may take the place of the first.
    pub run: u64,
    /// The name of the project, if it has one.
    pub project: Option<String>,
    /// Its symbols.
    pub symbols: SymbolTable,
    /// Blocks that people call by a name.
    pub block_names: BTreeMap<BlockId, String>,
    /// The texts.
    pub sources: Sources,
    /// The program, with the spans of its statements.
    pub program: Arc<Program>,
    /// All that the compiler knows of it, where that was kept.
    pub build: Option<Arc<Build>>,
    /// Blocks that are listed as their source, with what their variables are called by: those of ST.
    pub text_blocks: BTreeMap<BlockId, Scope>,
    /// Statements of STL that elements of diagrams stand for.
    pub stated: BTreeMap<(BlockId, u32), String>,
    /// The networks of blocks of STL.
    pub networks: BTreeMap<BlockId, Networks>,
    /// Inputs, outputs, bit memory, timers and counters that the program names and that have no symbol.
    pub used: Vec<Operand>,
    /// Blocks that a block calls, each once, in their order.
    pub calls: BTreeMap<BlockId, Vec<BlockId>>,
    /// The byte of bit memory that the CPU counts its clock in, which no program changes.
    pub clock_memory_byte: Option<u32>,
    /// Blocks of the library.
    pub library: BTreeSet<BlockId>,
    /// The mnemonic language of each source.
    pub mnemonics: BTreeMap<FileId, Mnemonics>,
}

/// The networks of a block of STL.
#[derive(Clone, Debug, Default)]
pub struct Networks {
    /// The network of each statement, from 1.
    pub of_statements: Vec<u32>,
    /// The title of each network; none where the block names no network.
    pub titles: Vec<String>,
}

impl Networks {
    /// The network of a statement, which is counted from 0, with its title; `None` where the block names no network.
    pub fn of(&self, statement: u32) -> Option<(u32, &str)> {
        let network = *self.of_statements.get(statement as usize)?;
        Some((network, self.titles.get((network as usize).checked_sub(1)?)?))
    }
}

/// Statements of a program whose references are looked through: in larger ones only what has a symbol is listed.
const SEARCHED_STATEMENTS_MAX: usize = 20_000;

/// OB 1 is short beside a block that has more than so many times its statements.
const SHORT: usize = 3;
/// Organization blocks that run once, at a start.
const STARTUPS: [u16; 3] = [100, 101, 102];

/// A statement as people find it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Placed {
    /// Its block.
    pub block: BlockId,
    /// Its number, from 1.
    pub statement: u64,
    /// File and line; `None` for a statement that the compiler made.
    pub line: Option<(String, u32)>,
}

impl Facts {
    /// What a build knows of the program that a CPU runs.
    pub fn of(build: &Build, program: &Arc<Program>) -> Self {
        let mut facts = Self::named(build, program);
        facts.clock_memory_byte = build.project.settings.clock_memory_byte.map(u32::from);
        facts.mnemonics.clone_from(&build.compiled.mnemonics);
        facts.library = program.code.keys().copied().filter(|&block| build.compiled.is_of_library(block)).collect();
        for (&block, body) in &build.compiled.bodies {
            match body.as_ref() {
                CheckedBody::St(_) => {
                    facts.text_blocks.insert(block, Scope { block, bare: body.has_bare_names() });
                }
                CheckedBody::Stl(_) => {
                    let count = program.code.get(&block).map_or(0, |code| u32::try_from(code.spans.len()).unwrap_or(u32::MAX));
                    let stated = (0..count).filter_map(|number| Some(((block, number), body.stated(number)?.to_owned())));
                    facts.stated.extend(stated);
                    facts.networks.insert(block, Networks { of_statements: body.networks(), titles: body.network_titles().to_vec() });
                }
            }
        }
        if program.code.values().map(|code| code.spans.len()).sum::<usize>() <= SEARCHED_STATEMENTS_MAX {
            facts.search(build);
        }
        facts
    }

    /// Looks through all references: what is used without a symbol, and who calls whom.
    fn search(&mut self, build: &Build) {
        let mut used = BTreeSet::new();
        for &block in build.compiled.bodies.keys().filter(|&&block| !self.library.contains(&block)) {
            for reference in build.compiled.references(block) {
                match (reference.usage, &reference.target) {
                    (Usage::Call(_), Target::Block(callee)) => {
                        let calls = self.calls.entry(block).or_default();
                        if !calls.contains(callee) {
                            calls.push(*callee);
                        }
                    }
                    (Usage::Access(_), target) => {
                        used.insert(target.clone());
                    }
                    _ => {}
                }
            }
        }
        let without_symbol = |operand: &Operand| self.symbols.find_operand(operand).is_none();
        self.used = used.iter().filter_map(operand).filter(without_symbol).collect();
    }

    /// Where a screen begins: OB 1, or the longest block that an organization block reaches, if OB 1 is short beside it. Blocks of the library
    /// are no matter of the user.
    pub fn first_block(&self) -> Option<BlockId> {
        let statements = |block: &BlockId| self.program.code.get(block).map_or(0, |code| code.spans.len());
        let is_root = |block: &&BlockId| block.kind == BlockKind::OrganizationBlock && !STARTUPS.contains(&block.number);
        let mut reached: Vec<BlockId> = self.program.code.keys().filter(is_root).copied().collect();
        let mut at = 0;
        while let Some(block) = reached.get(at).copied() {
            at += 1;
            let called = self.calls.get(&block).into_iter().flatten();
            let new: Vec<BlockId> = called.filter(|block| !self.library.contains(block) && !reached.contains(block)).copied().collect();
            reached.extend(new);
        }
        let cycle = BlockId::ob(1);
        let longest = reached.into_iter().rev().max_by_key(statements)?;
        let is_short = statements(&cycle) * SHORT < statements(&longest);
        Some(if is_short || !self.program.code.contains_key(&cycle) { longest } else { cycle })
    }

    /// The names of a program and its texts.
    fn named(build: &Build, program: &Arc<Program>) -> Self {
        let named = program.code.keys().filter_map(|&id| Some((id, controller::name_in_source(build, id)?.to_owned())));
        Self {
            project: build.project.settings.name.clone(),
            symbols: build.project.symbols.clone(),
            block_names: named.collect(),
            sources: build.project.texts.program.clone(),
            program: Arc::clone(program),
            build: Some(Arc::new(build.clone())),
            ..Self::default()
        }
    }

    /// The block that a user means: `OB1`, `FC 5`, a symbol, a name of Structured Text.
    pub fn block(&self, text: &str) -> Option<BlockId> {
        let text = text.trim();
        let plain = text.trim_matches('"');
        let named = || self.block_names.iter().find(|(_, name)| name.eq_ignore_ascii_case(plain)).map(|(&id, _)| id);
        match Operand::parse(text).or_else(|| self.symbols.operand(plain)) {
            Some(Operand::Block(id)) => Some(id),
            _ => named(),
        }
    }

    /// Finds places.
    pub fn places(&self) -> Places<'_> {
        Places { facts: self, lines: BTreeMap::new() }
    }
}

/// Finds the lines of statements; each text is counted once.
pub struct Places<'f> {
    facts: &'f Facts,
    /// Where the lines of a text begin.
    lines: BTreeMap<FileId, Vec<u32>>,
}

/// What can be read at a target of the program.
fn operand(target: &Target) -> Option<Operand> {
    match target {
        Target::Memory(Memory { area, db: None, position, extent: Extent::Width(width) }) => {
            let is_shown = matches!(area, Area::Input | Area::Output | Area::BitMemory | Area::PeripheralInput | Area::PeripheralOutput);
            let bit = (position % 8) as u8;
            is_shown.then_some(Operand::Address(Address { area: *area, width: *width, byte: position / 8, bit }))
        }
        Target::Timer(number) => Some(Operand::Timer(*number)),
        Target::Counter(number) => Some(Operand::Counter(*number)),
        _ => None,
    }
}

impl Places<'_> {
    /// File and line of a statement, by its number from 0.
    pub fn line_of(&mut self, block: BlockId, statement: u32) -> Option<(String, u32)> {
        self.line(FaultPlace { block, statement })
    }

    /// The place of a statement.
    pub fn of(&mut self, place: FaultPlace) -> Placed {
        Placed { block: place.block, statement: u64::from(place.statement) + 1, line: self.line(place) }
    }

    fn line(&mut self, place: FaultPlace) -> Option<(String, u32)> {
        let span = *self.facts.program.code.get(&place.block)?.spans.get(place.statement as usize)?;
        let (_, file) = self.facts.sources.iter().find(|&(id, _)| id == span.file)?;
        let begins = self.lines.entry(span.file).or_insert_with(|| {
            let ends = file.text.bytes().enumerate().filter(|&(_, byte)| byte == b'\n');
            ends.map(|(at, _)| u32::try_from(at + 1).unwrap_or(u32::MAX)).collect()
        });
        let before = begins.partition_point(|&begin| begin <= span.start);
        Some((file.name.clone(), u32::try_from(before + 1).unwrap_or(u32::MAX)))
    }
}

/// A client of a server over the network, as people see it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Client {
    /// What it speaks.
    pub protocol: &'static str,
    /// Its address and port.
    pub peer: String,
    /// What it says it is: `PG`, `OP`, `other`; `None` before it has said so.
    pub partner: Option<&'static str>,
    /// For how long it has been connected, in microseconds.
    pub for_us: u64,
    /// What it asked for last.
    pub last: Option<&'static str>,
    /// How long its PDUs are, once it is set up.
    pub pdu_bytes: Option<usize>,
    /// How often it has read values.
    pub reads: u64,
    /// How often it has written values.
    pub writes: u64,
    /// What it wrote last.
    pub written: Option<LastWrite>,
}

/// The last write of a client.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LastWrite {
    /// To what, as people spell it: `IW 0`.
    pub name: String,
    /// What, as people read it.
    pub value: String,
    /// How many scans had ended.
    pub scan: u64,
    /// The time of the CPU in microseconds.
    pub time_us: u64,
}

/// Tells the clients of all servers.
pub type Clients = Box<dyn Fn() -> Vec<Client> + Send + Sync>;

/// The facts of the program that runs now, for everyone who asks: an online change brings others.
#[derive(Default)]
pub struct CurrentFacts {
    /// Grows with each online change.
    version: AtomicU64,
    facts: Mutex<Arc<Facts>>,
    /// How many are connected.
    connections: AtomicUsize,
    /// Who is connected to servers, if there are any.
    clients: OnceLock<Clients>,
    /// Where the page of the run is.
    page: OnceLock<String>,
    /// Hear what requests change.
    listeners: Mutex<Vec<Listener>>,
}

/// A client is connected as long as this is there.
pub struct Connection(Arc<CurrentFacts>);

impl Drop for Connection {
    fn drop(&mut self) {
        self.0.connections.fetch_sub(1, Ordering::AcqRel);
    }
}

impl CurrentFacts {
    /// The facts that a run begins with.
    pub fn new(facts: Facts) -> Self {
        Self { facts: Mutex::new(Arc::new(facts)), ..Self::default() }
    }

    /// Another program runs from now on. To be called at the cycle control point where it took over.
    pub fn replace(&self, facts: Facts) {
        let run = self.facts().run;
        self.put(Facts { run, ..facts });
    }

    /// Another CPU runs from now on.
    pub(crate) fn reset(&self, facts: Facts) {
        let run = self.facts().run + 1;
        self.put(Facts { run, ..facts });
    }

    fn put(&self, facts: Facts) {
        *self.facts.lock().unwrap_or_else(PoisonError::into_inner) = Arc::new(facts);
        self.version.fetch_add(1, Ordering::AcqRel);
    }

    /// Which facts are the newest.
    pub fn version(&self) -> u64 {
        self.version.load(Ordering::Acquire)
    }

    /// The newest facts.
    pub fn facts(&self) -> Arc<Facts> {
        Arc::clone(&self.facts.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// One more is connected; `None` if there are `most` already.
    pub fn connect(self: &Arc<Self>, most: usize) -> Option<Connection> {
        let one_more = |count| (count < most).then_some(count + 1);
        self.connections.fetch_update(Ordering::AcqRel, Ordering::Acquire, one_more).ok().map(|_| Connection(Arc::clone(self)))
    }

    /// From now on this tells the clients of servers; what was said first holds.
    pub fn set_clients(&self, clients: Clients) {
        // The second call has nothing to add.
        let _ = self.clients.set(clients);
    }

    /// From now on the run has a page, at this address; what was said first holds.
    pub fn set_page(&self, address: String) {
        // The second call has nothing to add.
        let _ = self.page.set(address);
    }

    /// Where the page of the run is, if it has one.
    pub fn page(&self) -> Option<String> {
        self.page.get().cloned()
    }

    /// From now on this hears what requests change.
    pub fn add_listener(&self, listener: Listener) {
        self.listeners.lock().unwrap_or_else(PoisonError::into_inner).push(listener);
    }

    /// Tells of a change that no request of the control socket makes.
    pub fn tell(&self, peer: &str, change: Change) {
        self.tell_changes(peer, || vec![change]);
    }

    /// Tells what a request of a peer has changed.
    pub(super) fn tell_changes(&self, peer: &str, changes: impl FnOnce() -> Vec<Change>) {
        let listeners = self.listeners.lock().unwrap_or_else(PoisonError::into_inner);
        if listeners.is_empty() {
            return;
        }
        let changes = changes();
        if !changes.is_empty() {
            listeners.iter().for_each(|listener| listener(peer, &changes));
        }
    }

    /// The clients of servers.
    pub fn clients(&self) -> Vec<Client> {
        self.clients.get().map_or_else(Vec::new, |clients| clients())
    }

    /// How many are connected.
    pub fn connections(&self) -> usize {
        self.connections.load(Ordering::Acquire)
    }
}
