//! What is known of the program that runs beside what the CPU has of it: names, and places in the sources.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use sieben_engine::{FaultPlace, Program};
use sieben_model::address::Operand;
use sieben_model::block::BlockId;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;

use super::changes::{Change, Listener};
use crate::controller;
use crate::project::Build;

/// A program as people know it.
#[derive(Clone, Debug, Default)]
pub struct Facts {
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
}

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
        let named = program.code.keys().filter_map(|&id| Some((id, controller::name_in_source(build, id)?.to_owned())));
        Self {
            project: build.project.settings.name.clone(),
            symbols: build.project.symbols.clone(),
            block_names: named.collect(),
            sources: build.project.texts.program.clone(),
            program: Arc::clone(program),
            build: Some(Arc::new(build.clone())),
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

impl Places<'_> {
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
        let facts = Arc::new(facts);
        *self.facts.lock().unwrap_or_else(PoisonError::into_inner) = facts;
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

    /// From now on this hears what requests change.
    pub fn add_listener(&self, listener: Listener) {
        self.listeners.lock().unwrap_or_else(PoisonError::into_inner).push(listener);
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
