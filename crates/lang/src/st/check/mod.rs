//! Statements → typed tree: names, types, conversions, calls, and what is wrong with them.

mod arguments;
mod as_bytes;
mod calls;
pub mod construct;
mod contacts;
mod diagrams;
mod expressions;
mod flow;
mod functions;
mod instructions;
pub(crate) mod literals;
mod locals;
mod loops;
pub(crate) mod members;
mod memory;
mod moments;
pub mod names;
mod open_arrays;
mod operators;
mod own_errors;
pub(crate) mod places;
mod pointers;
mod queries;
mod ranges;
mod s5;
mod statements;
mod testing;
mod texts;
mod timers;
mod traps;
mod typed;
mod types;
mod untyped;
mod usage;
mod variants;
pub(crate) mod walk;

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use sieben_model::block::BlockId;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::testing::{Signal, WordCall};
use sieben_model::types::DataType;

use super::ast;
use super::dialect::{Construct, Dialect, Judgement, LostResults};
use super::tree;
use locals::Locals;
use names::{Names, Variable};
use ranges::Known;
use typed::Typed;

/// Problems of one block that are reported; what comes behind was likely caused by the first ones.
const DIAGNOSTICS_MAX: usize = 200;

/// Problems of a name that means nothing or something else, where a block uses it as often as it likes.
const NAMELESS: [Problem; 9] = [
    Problem::P3001,
    Problem::P3004,
    Problem::P3007,
    Problem::P3008,
    Problem::P3009,
    Problem::P6217,
    Problem::P6218,
    Problem::P6219,
    Problem::P6228,
];

/// Problems of a name that the block may inherit: where its base is lacking, that was told already.
const INHERITED: [Problem; 3] = [Problem::P3001, Problem::P3008, Problem::P6286];

/// What the checker has to know about a block besides its names.
#[derive(Clone, Debug, PartialEq)]
pub struct Block<'a> {
    /// The block.
    pub id: BlockId,
    /// Its dialect.
    pub dialect: Dialect,
    /// Its statements.
    pub body: &'a [ast::Statement],
    /// The labels that it declares.
    pub labels: &'a [ast::Name],
    /// Its actions: bodies that share its variables.
    pub actions: &'a [ast::Action],
    /// Its result.
    pub result: Option<Variable>,
    /// The place of its end.
    pub end: Span,
}

/// The body of a block, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Checked {
    /// The body; `None` if an error is among the diagnostics.
    pub body: Option<tree::Body>,
    /// What is to be said about it.
    pub diagnostics: Vec<Diagnostic>,
    /// The blocks that it calls.
    pub called: BTreeSet<BlockId>,
    /// The words of tests in it, by the first byte of their place.
    pub words: BTreeMap<u32, WordCall>,
    /// What a test writes at constant addresses, by the first byte of the place.
    pub writes: BTreeMap<u32, Signal>,
}

/// Checks the body of a block.
pub fn check(block: &Block<'_>, names: &dyn Names) -> Checked {
    let mut checker = Checker::new(block, names);
    checker.collect_labels(block.body);
    let statements = checker.statements(block.body);
    let local_size = checker.locals.bytes();
    let is_method = names.this().is_some_and(|this| this != block.id);
    let (uses_ok, tells_lost) = (checker.reads_ok, checker.lost != LostResults::None);
    let body =
        tree::Body { statements, locals: names.locals(), local_size, uses_ok, tells_lost, is_method, own_errors: checker.own_errors };
    if !checker.failed {
        checker.usage(&body);
        checker.traps(&body);
    }
    let Checker { failed, diagnostics, called, words, writes, .. } = checker;
    Checked { body: (!failed).then_some(body), diagnostics, called, words, writes }
}

/// Where a path outside all blocks leads: from where, bits from there, and the type; and what is wrong with it.
pub fn place_of(path: &ast::Expression, dialect: Dialect, names: &dyn Names) -> (Option<(tree::Base, u32, DataType)>, Vec<Diagnostic>) {
    let block = Block { id: BlockId::ob(1), dialect, body: &[], labels: &[], actions: &[], result: None, end: path.span };
    let mut checker = Checker::new(&block, names);
    let found = match checker.reach(path) {
        places::Reached::Target(target) if target.place.indexes.is_empty() => {
            Some((target.place.base, target.place.offset, target.data_type))
        }
        _ => None,
    };
    (found, checker.diagnostics)
}

impl<'a> Checker<'a> {
    fn new(block: &'a Block<'a>, names: &'a dyn Names) -> Self {
        let reads_ok = statements::mentions_ok(block);
        // A block that looks at ENO or OK handles what is lost; those of the library are not the user's.
        let told = !reads_ok && !names.is_of_library(names.this().unwrap_or(block.id));
        let lost = names.tells_lost().min(block.dialect.switches().lost_results);
        Checker {
            names,
            block,
            dialect: block.dialect,
            diagnostics: Vec::new(),
            failed: false,
            loops: Vec::new(),
            labels: HashMap::new(),
            known: Vec::new(),
            called: BTreeSet::new(),
            reads_ok,
            lost: if told { lost } else { LostResults::None },
            own_errors: own_errors::asks_for_errors(block, names),
            counts_characters: false,
            quiet: false,
            keeps_sign: false,
            held: None,
            long_signs: BTreeSet::new(),
            locals: Locals::new(names.local_size()),
            lists: Vec::new(),
            next_list: 0,
            noted: BTreeSet::new(),
            told: HashSet::new(),
            outside: HashSet::new(),
            inside_actions: Vec::new(),
            wires: HashMap::new(),
            words: BTreeMap::new(),
            writes: BTreeMap::new(),
        }
    }
}

/// A loop that is being checked.
struct Loop {
    /// The control variable of a FOR: what it is called and where it lies.
    control: Option<(String, tree::Place)>,
}

/// A label of the block.
struct Label {
    /// Its number in the tree.
    number: u32,
    /// The statement lists that it stands in, outermost first: jumps go only where one is inside.
    path: Vec<u32>,
}

/// The state while a body is checked.
struct Checker<'a> {
    names: &'a dyn Names,
    block: &'a Block<'a>,
    dialect: Dialect,
    diagnostics: Vec<Diagnostic>,
    /// Whether an error was found.
    failed: bool,
    loops: Vec<Loop>,
    labels: HashMap<String, Label>,
    /// What is known of the values of variables here.
    known: Vec<Known>,
    /// The blocks that are called.
    called: BTreeSet<BlockId>,
    /// Whether the block reads or writes ENO or OK, so that operations that fail must tell it.
    reads_ok: bool,
    /// Which results that are lost the block tells the Host.
    lost: LostResults,
    /// Whether the block asks for its errors, so that it handles them itself.
    own_errors: bool,
    /// Whether a pointer to a text became one to something else.
    counts_characters: bool,
    /// Whether messages are held back: an expression is looked at to see what it is.
    quiet: bool,
    /// A negative number stays one: it does not become the pattern of bits of a type without a sign.
    keeps_sign: bool,
    /// The last message that was held back: a place to write to.
    held: Option<Diagnostic>,
    /// The signs of differences whose LTIME is wanted, by their first byte.
    long_signs: BTreeSet<u32>,
    /// Local data for values that are kept.
    locals: Locals,
    /// The lists of statements around the current one, by the number that [`Label::path`] has.
    lists: Vec<u32>,
    next_list: u32,
    /// The constructs that were noted: once for a block is enough.
    noted: BTreeSet<u32>,
    /// What was said of names that mean nothing: once for a block is enough.
    told: HashSet<(Problem, String)>,
    /// Names that are declared among the statements.
    outside: HashSet<String>,
    /// The actions whose statements stand here.
    inside_actions: Vec<usize>,
    /// What the wires of the network carry.
    wires: HashMap<ast::Wire, diagrams::Carried>,
    /// The words of tests, by the first byte of their place.
    words: BTreeMap<u32, WordCall>,
    /// What a test writes, by the first byte of the place.
    writes: BTreeMap<u32, Signal>,
}

impl Checker<'_> {
    /// Reports a problem.
    fn report(&mut self, problem: Problem, span: Span, message: impl Into<String>) -> &mut Diagnostic {
        let diagnostic = Diagnostic::new(problem, span, message);
        // A name that is unknown is unknown everywhere in the block.
        let told = !self.quiet && NAMELESS.contains(&problem) && !self.told.insert((problem, diagnostic.message.clone()));
        let told = told || INHERITED.contains(&problem) && self.names.this().is_some_and(|this| self.names.objects().lacks_base(this));
        self.failed |= !self.quiet && diagnostic.severity() == sieben_model::diagnostic::Severity::Error;
        if told || self.quiet || self.diagnostics.len() > DIAGNOSTICS_MAX {
            return self.held.insert(diagnostic);
        }
        if self.diagnostics.len() == DIAGNOSTICS_MAX {
            let message = format!("this block has more than {DIAGNOSTICS_MAX} problems; the others are not shown");
            self.diagnostics.push(Diagnostic::new(Problem::P2199, span, message));
            return self.held.insert(diagnostic);
        }
        self.diagnostics.push(diagnostic);
        self.diagnostics.last_mut().expect("a diagnostic was pushed")
    }

    /// Says what the dialect thinks of a construct; whether it is part of it.
    fn judge(&mut self, construct: Construct, span: Span) -> bool {
        let row = construct.row();
        let title = self.dialect.title();
        match self.dialect.judge(construct) {
            Judgement::Accept => true,
            Judgement::Note if !self.noted.insert(construct as u32) => true,
            Judgement::Note => {
                let message = format!("{} is not usual in {title}", row.title);
                let help = format!("{}; the other places of this block are not listed.", sentence(row.instead));
                self.report(Problem::P6051, span, message).help = Some(help);
                true
            }
            Judgement::Reject => {
                let message = format!("{title} does not have {}", row.title);
                let help = format!("{}, or name the dialect of the file with `--dialect`.", sentence(row.instead));
                self.report(Problem::P6050, span, message).help = Some(help);
                false
            }
        }
    }

    /// A type in a message, in the words of the dialect.
    fn words(&self, data_type: &DataType) -> String {
        self.dialect.type_words(data_type)
    }

    /// Says that something valid is not built yet.
    fn not_built(&mut self, span: Span, what: &str) -> Typed {
        self.report(Problem::P6226, span, format!("{what} cannot be compiled yet"));
        Typed::Poison
    }
}

/// A row's advice as the beginning of a sentence.
fn sentence(advice: &str) -> String {
    let mut characters = advice.chars();
    characters.next().map(|first| first.to_uppercase().collect::<String>() + characters.as_str()).unwrap_or_default()
}
