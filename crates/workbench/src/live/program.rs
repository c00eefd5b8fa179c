//! The program that runs, as pages need it: blocks by their words, and the lines of their statements.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

use serde_json::{Value as Json, json};
use sieben_engine::FaultPlace;
use sieben_lang::reason::Language;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::FileId;
use sieben_workspace::control::{Facts, listing};
use sieben_workspace::status::{Calls, Written};

use crate::{fnv_1a, lock};

/// How sentences for a page are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Speech {
    /// Their language.
    pub language: Language,
    /// The mnemonics of the addresses in them; `None`: those of the source.
    pub mnemonics: Option<Mnemonics>,
}

impl Speech {
    /// All ways to write a sentence.
    pub fn all() -> impl Iterator<Item = Self> {
        let mnemonics = [None, Some(Mnemonics::English), Some(Mnemonics::German)];
        mnemonics.into_iter().flat_map(|mnemonics| Language::ALL.map(|language| Self { language, mnemonics }))
    }
}

/// Why a statement did what it did, in all ways to write it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Said(Vec<String>);

impl Said {
    /// Says something in all ways.
    pub fn new(say: impl FnMut(Speech) -> String) -> Self {
        Self(Speech::all().map(say).collect())
    }

    /// What is said in one of them.
    pub fn text(&self, speech: Speech) -> &str {
        let at = Speech::all().position(|one| one == speech);
        at.and_then(|at| self.0.get(at)).map_or("", String::as_str)
    }
}

/// A block as pages call it: `OB1`.
pub fn word(block: BlockId) -> String {
    block.to_string().split_whitespace().collect()
}

/// A program with what was looked up in it.
pub struct Known {
    /// Which program of the run it is.
    pub version: u64,
    /// What is known of it.
    pub facts: Arc<Facts>,
    /// One mnemonic language for all files, in the order of [`Mnemonics`].
    spelled: [BTreeMap<FileId, Mnemonics>; 2],
    lines: Mutex<BTreeMap<BlockId, Arc<[u32]>>>,
    written: Mutex<BTreeMap<BlockId, Written>>,
}

impl Known {
    /// The program with this version.
    pub fn new(version: u64, facts: Arc<Facts>) -> Self {
        let spelled = [Mnemonics::English, Mnemonics::German].map(|one| facts.sources.iter().map(|(file, _)| (file, one)).collect());
        Self { version, facts, spelled, lines: Mutex::default(), written: Mutex::default() }
    }

    /// The mnemonics of each file, where addresses are spelled in these.
    pub fn spelled(&self, mnemonics: Mnemonics) -> &BTreeMap<FileId, Mnemonics> {
        let [english, german] = &self.spelled;
        if mnemonics == Mnemonics::German { german } else { english }
    }

    /// The mnemonics of most sources.
    pub fn mnemonics(&self) -> Mnemonics {
        let german = self.facts.mnemonics.values().filter(|&&one| one == Mnemonics::German).count();
        if german * 2 > self.facts.mnemonics.len() { Mnemonics::German } else { Mnemonics::English }
    }

    /// What a page means: a block, or its calls with an instance data block; `None` if there is no such block.
    pub fn calls(&self, block: &str, instance: Option<&str>) -> Option<Calls> {
        let block = self.facts.block(block)?;
        let Some(name) = instance.filter(|name| !name.is_empty()) else { return Some(block.into()) };
        let instance = self.facts.block(name).filter(|found| found.kind == BlockKind::DataBlock)?;
        Some(Calls { block, instance: Some(instance.number) })
    }

    /// Whether the source has this statement: the end of a block need not be written.
    pub fn is_written(&self, place: FaultPlace) -> bool {
        let body = self.facts.build.as_ref().and_then(|build| build.compiled.bodies.get(&place.block));
        body.is_none_or(|body| body.is_written(place.statement))
    }

    /// The network of a statement, from 1.
    pub fn network(&self, place: FaultPlace) -> Option<u32> {
        self.facts.build.as_ref()?.compiled.bodies.get(&place.block)?.network(place.statement)
    }

    /// Where a statement stands, as pages take it.
    pub fn place_json(&self, place: FaultPlace, line: Option<u32>) -> Json {
        json!({ "block": word(place.block), "network": self.network(place), "line": line })
    }

    /// A word for this program: another one for each that takes over, and for other sources in another run.
    pub fn hash(&self) -> String {
        let texts = self.facts.sources.iter().flat_map(|(_, file)| [file.name.as_str(), file.text.as_str()]);
        format!("{:016x}{:x}", fnv_1a(texts.flat_map(str::bytes)), self.version)
    }

    /// The variables that the assignments of a block of Structured Text write.
    pub fn written(&self, block: BlockId) -> Written {
        let mut known = lock(&self.written);
        Arc::clone(known.entry(block).or_insert_with(|| listing::written(&self.facts, block)))
    }

    /// The line of each statement of a block; 0 for one that the compiler made.
    pub fn lines(&self, block: BlockId) -> Arc<[u32]> {
        let mut known = lock(&self.lines);
        let lines = known.entry(block).or_insert_with(|| {
            let count = self.facts.program.code.get(&block).map_or(0, |code| code.spans.len());
            let mut places = self.facts.places();
            let mut line = |statement| places.of(FaultPlace { block, statement }).line.map_or(0, |(_, line)| line);
            (0..u32::try_from(count).unwrap_or(u32::MAX)).map(&mut line).collect()
        });
        Arc::clone(lines)
    }
}
