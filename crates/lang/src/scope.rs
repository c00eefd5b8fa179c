//! The global names of a project: symbols, blocks, and suggestions for names that do not exist.

use std::cell::Cell;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

use sieben_model::address::Operand;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::SystemBlock;
use sieben_model::symbols::SymbolTable;

/// Suggestions cost a look at every name; a source full of unknown names gets this many.
const SUGGESTIONS_MAX: u32 = 100;

/// A name as a key: names compare without regard to case.
pub(crate) fn key(name: &str) -> String {
    if name.is_ascii() { name.to_ascii_lowercase() } else { name.to_lowercase() }
}

/// What a symbol stands for.
#[derive(Clone, Debug)]
pub(crate) struct Global {
    /// The name as the table spells it.
    pub(crate) name: String,
    /// Its address; `None` if the table has none that can be read.
    pub(crate) operand: Option<Operand>,
    /// The address as written.
    pub(crate) address: String,
    /// The type as written.
    pub(crate) data_type: String,
    /// The name stands in the table again with another address.
    pub(crate) ambiguous: bool,
}

impl Global {
    /// Whether it is a block of the CPU itself.
    fn is_of_system(&self) -> bool {
        let Some(Operand::Block(block)) = self.operand else { return false };
        matches!(block.kind, BlockKind::SystemFunction | BlockKind::SystemFunctionBlock)
    }
}

/// Which results that are lost the CPU is told of, where the block does not look at ENO or OK.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum LostResults {
    /// None.
    #[default]
    None,
    /// Integers divided by 0.
    Quotients,
    /// All that clear ENO: overflows and conversions too.
    All,
}

/// The global names.
#[derive(Debug, Default)]
pub(crate) struct Scope {
    globals: HashMap<String, Global>,
    /// Whether the program may use the words and notations of extended programs.
    pub(crate) extended: bool,
    suggestions: Cell<u32>,
    /// Which lost results the code of Structured Text tells the Host of, where the dialect does not call them right.
    pub(crate) tells_lost: LostResults,
}

impl Scope {
    /// The symbols of the table; names of system blocks stand for these unless the table says otherwise.
    pub(crate) fn new(symbols: &SymbolTable, system: &[SystemBlock]) -> Self {
        let mut globals: HashMap<String, Global> = HashMap::with_capacity(symbols.symbols().len());
        // Rows of an assignment table may have no symbol.
        for symbol in symbols.symbols().iter().filter(|symbol| !symbol.name.trim().is_empty()) {
            let operand = symbol.operand();
            globals.entry(key(symbol.name.trim())).and_modify(|first| first.ambiguous |= first.operand != operand).or_insert_with(|| {
                Global {
                    name: symbol.name.trim().to_owned(),
                    operand,
                    address: symbol.address.trim().to_owned(),
                    data_type: symbol.data_type.trim().to_ascii_uppercase(),
                    ambiguous: false,
                }
            });
        }
        let mut scope = Self { globals, extended: false, suggestions: Cell::new(0), tells_lost: LostResults::None };
        // Of blocks that the CPU does not have only the numbers count: `"START"` and `"COUNT"` are everybody's words.
        for block in system.iter().filter(|block| block.only.is_none()) {
            scope.add_block(block.name, block.block);
        }
        scope
    }

    /// Lets a name stand for a block unless it stands for something already.
    pub(crate) fn add_block(&mut self, name: &str, block: BlockId) {
        self.globals.entry(key(name)).or_insert_with(|| Global {
            name: name.to_owned(),
            operand: Some(Operand::Block(block)),
            address: block.to_string(),
            data_type: block.to_string(),
            ambiguous: false,
        });
    }

    /// Lets a name stand for a block of the project, unless the symbol table says otherwise.
    pub(crate) fn define_block(&mut self, wanted: &str, name: &str, block: BlockId) {
        let global = Global {
            name: name.to_owned(),
            operand: Some(Operand::Block(block)),
            address: block.to_string(),
            data_type: block.to_string(),
            ambiguous: false,
        };
        match self.globals.entry(key(wanted)) {
            Entry::Occupied(mut entry) if entry.get().is_of_system() => drop(entry.insert(global)),
            Entry::Occupied(_) => {}
            Entry::Vacant(entry) => drop(entry.insert(global)),
        }
    }

    /// The block that the symbol table gives a name to; names of system blocks do not count.
    pub(crate) fn own_block(&self, name: &str) -> Option<BlockId> {
        match self.global(name).filter(|global| !global.is_of_system())?.operand? {
            Operand::Block(block) => Some(block),
            _ => None,
        }
    }

    /// Everything that has a name.
    pub(crate) fn operands(&self) -> impl Iterator<Item = Operand> {
        self.globals.values().filter_map(|global| global.operand)
    }

    /// All names.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.globals.values().map(|global| global.name.as_str())
    }

    /// All blocks with a symbol.
    pub(crate) fn blocks(&self) -> impl Iterator<Item = (BlockId, &str)> {
        self.globals.values().filter_map(|global| match global.operand {
            Some(Operand::Block(block)) => Some((block, global.name.as_str())),
            _ => None,
        })
    }

    /// What the symbol stands for.
    pub(crate) fn global(&self, name: &str) -> Option<&Global> {
        self.globals.get(&key(name))
    }

    /// The block that a symbol names.
    pub(crate) fn block(&self, name: &str) -> Option<BlockId> {
        match self.global(name)?.operand? {
            Operand::Block(block) => Some(block),
            _ => None,
        }
    }

    /// The symbol that looks most like `name`.
    pub(crate) fn nearest_symbol(&self, name: &str) -> Option<String> {
        self.nearest(name, self.globals.values().map(|global| global.name.as_str()))
    }

    /// The same without the system functions of the CPU: for a name that is not called.
    pub(crate) fn nearest_variable(&self, name: &str) -> Option<String> {
        let of_system = |global: &&Global| {
            let Some(Operand::Block(block)) = global.operand else { return false };
            matches!(block.kind, BlockKind::SystemFunction | BlockKind::SystemFunctionBlock)
        };
        self.nearest(name, self.globals.values().filter(|global| !of_system(global)).map(|global| global.name.as_str()))
    }

    /// The candidate that looks most like `name`, if any looks like it.
    pub(crate) fn nearest<'a>(&self, name: &str, candidates: impl Iterator<Item = &'a str>) -> Option<String> {
        let made = self.suggestions.get();
        self.suggestions.set(made.saturating_add(1));
        if made < SUGGESTIONS_MAX { nearest(name, candidates) } else { None }
    }

    /// The parameter that a name stands for, see [`nearest_parameter`].
    pub(crate) fn nearest_parameter<'a>(&self, name: &str, candidates: impl Iterator<Item = &'a str> + Clone) -> Option<String> {
        let made = self.suggestions.get();
        self.suggestions.set(made.saturating_add(1));
        if made < SUGGESTIONS_MAX { nearest_parameter(name, candidates) } else { None }
    }

    /// How many suggestions were asked for: there is a limit, so that an answer depends on the questions before it.
    pub(crate) fn suggestions(&self) -> u32 {
        self.suggestions.get()
    }

    /// Forgets the suggestions since there were so many: they do not count, because nothing that they are part of is reported.
    pub(crate) fn take_back_suggestions(&self, made: u32) {
        self.suggestions.set(made);
    }
}

/// The candidate that looks most like `name`, if any looks like it.
pub(crate) fn nearest<'a>(name: &str, candidates: impl Iterator<Item = &'a str>) -> Option<String> {
    let wanted = key(name);
    let length = wanted.chars().count();
    let limit = match length {
        0 => return None,
        1..=2 => 1,
        3..=5 => 2,
        _ => length / 3,
    };
    candidates
        .filter_map(|candidate| {
            let other = key(candidate);
            if other.chars().count().abs_diff(length) > limit || other.is_empty() {
                return None;
            }
            let distance = strsim::osa_distance(&wanted, &other);
            // Of words at the same distance the one with the same letters, then the one with more letters that were only exchanged.
            (distance <= limit && distance < length).then(|| {
                let exchanged = strsim::levenshtein(&wanted, &other) - distance;
                (distance, other_letters(&wanted, &other), std::cmp::Reverse(exchanged), candidate)
            })
        })
        .min()
        .map(|(.., candidate)| candidate.to_owned())
}

/// Whether a candidate looks more like `name` than another one does.
pub(crate) fn is_nearer(name: &str, candidate: &str, other: &str) -> bool {
    let distance = |candidate: &str| strsim::osa_distance(&key(name), &key(candidate));
    distance(candidate) < distance(other)
}

/// How many letters one of two words has and the other has not; 0 if they have the same ones in another order.
fn other_letters(one: &str, other: &str) -> usize {
    let mut left: Vec<char> = other.chars().collect();
    let unmatched = one.chars().filter(|letter| match left.iter().position(|other| other == letter) {
        Some(at) => {
            left.swap_remove(at);
            false
        }
        None => true,
    });
    unmatched.count() + left.len()
}

/// The parameter that a name stands for: one of which it is a short or a long form (`R` and `RESET`, `LD` and `LOAD`), else the nearest.
pub(crate) fn nearest_parameter<'a>(name: &str, candidates: impl Iterator<Item = &'a str> + Clone) -> Option<String> {
    let mut forms = candidates.clone().filter(|candidate| is_short_for(name, candidate) || is_short_for(candidate, name));
    match (forms.next(), forms.next()) {
        (Some(form), None) => Some(form.to_owned()),
        _ => nearest(name, candidates),
    }
}

/// Whether a word is made of letters of a longer one, with its first and, of several letters, its last.
fn is_short_for(short: &str, long: &str) -> bool {
    let (short, long) = (key(short), key(long));
    if long.len() < short.len() + 2 || short.chars().next() != long.chars().next() {
        return false;
    }
    if short.chars().count() > 1 && short.chars().last() != long.chars().last() {
        return false;
    }
    let mut rest = long.chars();
    !short.is_empty() && short.chars().all(|letter| rest.any(|other| other == letter))
}

/// `; did you mean `Start`?`, or nothing.
pub(crate) fn did_you_mean(name: Option<String>) -> String {
    name.map_or_else(String::new, |name| format!("; did you mean `{name}`?"))
}
