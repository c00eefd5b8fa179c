//! The front end of a project that stays open: what it knows of each source and each block is kept, and a change renews only what it
//! touches.
//!
//! Four steps, each with a result of its own: a source is parsed ([`syntax`]), a project declared ([`declarations`]), a block checked
//! ([`check`]) and lowered ([`lower`]). What a step gave is taken again while its syntax is the same (*stamps*) and so is all that it asked
//! other blocks for (*versions*): a change in one block has that block checked again, and what depends on its interface.

mod attributes;
mod check;
mod data_blocks;
mod declarations;
mod fuzz;
mod headers;
mod lower;
mod syntax;
mod whole;

use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

use sieben_model::block::BlockId;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;

use crate::compiled::Compiled;
use crate::declarations::reuse::Layouts;
use crate::declarations::system::{System, system};
use crate::language::Language;
use crate::library::Linked;
use crate::options::Options;
use crate::st;
use crate::st::declare::{Demand, Needed, Own, StFile, library_file};
use crate::st::untold::Untold;
use crate::stl;
use check::Checked;
pub use fuzz::fuzz;
use lower::Lowered;
use syntax::{Stamps, Syntax, Tree};
use whole::Blocks;

/// The sources of a project, and what is known of them.
#[derive(Debug, Default)]
pub struct Database {
    sources: Sources,
    symbols: SymbolTable,
    options: Options,
    /// The blocks of the CPU itself.
    system: System,
    stamps: Stamps,
    /// What is known of each source.
    files: Vec<Parsed>,
    /// Parsed sources of the library by their path and place.
    library: HashMap<(&'static str, FileId), Arc<Syntax>>,
    /// What of the library the program needed last, and what the user's blocks used.
    needed: Needed,
    uses: Needed,
    memory: Memory,
    work: Work,
}

/// What is known of a source.
#[derive(Clone, Debug, Default)]
struct Parsed {
    /// The language that it was read in; `None` where its text is another one since then.
    language: Option<Language>,
    /// What was parsed last.
    syntax: Option<Arc<Syntax>>,
}

/// What is known of blocks.
#[derive(Debug, Default)]
struct Memory {
    layouts: Layouts<Own>,
    checked: Blocks<Checked>,
    lowered: Blocks<Lowered>,
}

/// What the last evaluation could not take from before.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Sources that were parsed.
    pub parsed: usize,
    /// Blocks whose statements were checked, in the order of their numbers.
    pub checked: BTreeSet<BlockId>,
    /// Blocks that were lowered.
    pub lowered: BTreeSet<BlockId>,
}

/// How far a project is compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Goal {
    /// Everything that is wrong is known.
    Diagnostics,
    /// Its blocks are code.
    Code,
    /// The same, and nothing is kept for a next time.
    CodeOnce,
}

impl Database {
    /// A project without sources.
    pub fn new(symbols: SymbolTable, options: Options) -> Self {
        Self { system: system(&options.system_blocks), symbols, options, ..Self::default() }
    }

    /// A project with these sources.
    pub(crate) fn of(sources: &Sources, symbols: &SymbolTable, options: &Options) -> Self {
        let files = vec![Parsed::default(); sources.iter().len()];
        Self { sources: sources.clone(), files, ..Self::new(symbols.clone(), options.clone()) }
    }

    /// Takes in a source.
    pub fn add(&mut self, name: impl Into<String>, text: impl Into<String>) -> FileId {
        self.files.push(Parsed::default());
        self.sources.add(name, text)
    }

    /// Gives a source another text.
    pub fn replace(&mut self, file: FileId, text: impl Into<String>) {
        self.sources.replace(file, text);
        self.files[file.0 as usize].language = None;
    }

    /// Gives the project another symbol table.
    pub fn set_symbols(&mut self, symbols: SymbolTable) {
        self.symbols = symbols;
        (self.memory, self.needed, self.uses) = (Memory::default(), Needed::default(), Needed::default());
    }

    /// The sources.
    pub fn sources(&self) -> &Sources {
        &self.sources
    }

    /// What the last evaluation could not take from before.
    pub fn work(&self) -> &Work {
        &self.work
    }

    /// All that there is to say about the project, in the order of files and places.
    pub fn diagnostics(&mut self) -> Vec<Diagnostic> {
        self.evaluate(Goal::Diagnostics).diagnostics
    }

    /// The whole project, compiled.
    pub fn compiled(&mut self) -> Compiled {
        self.evaluate(Goal::Code)
    }

    /// The same once and for all.
    pub(crate) fn into_compiled(mut self) -> Compiled {
        self.evaluate(Goal::CodeOnce)
    }

    /// Parses what has another text.
    fn parse(&mut self) {
        let languages: Vec<Language> = self
            .sources
            .iter()
            .zip(&self.files)
            .map(|((_, source), file)| match file.language {
                // The text says which language it is, and it is the same.
                Some(language) if !language.is_of_tests() => language,
                _ => Language::of(&source.name, &source.text, self.options.dialect),
            })
            .collect();
        // A test file is written in the dialect of the sources before it.
        let mut first = None;
        for ((id, source), language) in self.sources.iter().zip(languages) {
            let language = match language {
                Language::St(dialect) if language.is_of_tests() => Language::St(first.unwrap_or(dialect).for_tests()),
                other => other,
            };
            if let Language::St(dialect) = language
                && (self.options.tests || !language.is_of_tests())
            {
                first.get_or_insert(dialect);
            }
            let file = &mut self.files[id.0 as usize];
            if file.language == Some(language) {
                continue;
            }
            self.work.parsed += 1;
            let syntax = Syntax::parse(id, source, language, &self.options, file.syntax.as_deref(), &mut self.stamps);
            *file = Parsed { language: Some(language), syntax: Some(Arc::new(syntax)) };
        }
    }

    /// Compiles as far as the goal asks for. What a program needs of the library shows while it is declared and checked: then both are done
    /// again with that. What was needed last is tried first; when the blocks use something else now, the search begins with nothing.
    fn evaluate(&mut self, goal: Goal) -> Compiled {
        self.work = Work::default();
        self.parse();
        let guess = std::mem::take(&mut self.needed);
        if !guess.is_empty() {
            let (compiled, demands, uses) = self.round(goal, &guess);
            // What a source of STL does not name any more may be used all the same.
            if uses == self.uses && guess.has_all(&demands) {
                self.needed = guess;
                return self.finished(compiled);
            }
        }
        let mut needed = Needed::default();
        loop {
            let (compiled, demands, uses) = self.round(goal, &needed);
            if !needed.add(&demands) {
                (self.needed, self.uses) = (needed, uses);
                return self.finished(compiled);
            }
        }
    }

    /// Forgets sources of the library that are not there any more.
    fn finished(&mut self, compiled: Compiled) -> Compiled {
        let there = |path: &str, file: FileId| {
            let blocks = compiled.library.iter().any(|linked| (linked.block.path, linked.file) == (path, file));
            blocks || compiled.st_library.iter().any(|linked| (linked.source.path, linked.file) == (path, file))
        };
        self.library.retain(|&(path, file), _| there(path, file));
        compiled
    }

    /// Compiles with what the program is known to need of the library; tells what else it needs, and what it uses.
    fn round(&mut self, goal: Goal, needed: &Needed) -> (Compiled, Vec<Demand>, Needed) {
        let user = self.sources.iter().len();
        let mut files = Vec::with_capacity(user);
        let mut st = Vec::new();
        let mut untold = Untold::default();
        let mut mnemonics: Vec<(FileId, Mnemonics)> = Vec::new();
        for syntax in self.files.iter().filter_map(|file| file.syntax.as_ref()) {
            match &syntax.tree {
                Tree::Stl(file) => mnemonics.push((file.id, file.mnemonics)),
                Tree::St(file, of_file) => {
                    st.push(file.clone());
                    untold.add(of_file);
                }
                Tree::Test => {}
            }
            files.push(Arc::clone(syntax));
        }
        for (index, &source) in needed.sources.iter().enumerate() {
            let syntax = self.library_source(source, library_file(user, index));
            if let Tree::St(file, _) = &syntax.tree {
                st.push(file.clone());
            }
        }
        let parts =
            declarations::Parts { symbols: &self.symbols, system: &self.system, options: &self.options, files: &files, st: &st, needed };
        let mut diagnostics: Vec<Diagnostic> = files.iter().flat_map(|syntax| &syntax.diagnostics).cloned().collect();
        let mut names = declarations::Names::of(&parts, &mut diagnostics);
        let linked = names.linked(user + needed.sources.len());
        let linked_sources = needed.linked(&names.items, user);
        let library: Vec<(BlockId, Arc<Syntax>)> =
            linked.iter().map(|linked| (linked.id, library_block(&mut self.library, &mut self.stamps, linked))).collect();
        names.add_library(&library);
        let revision = whole::Revision {
            sources: &self.sources,
            options: &self.options,
            names: &names,
            untold: &untold,
            goal,
            needed,
            linked,
            linked_sources,
            has_sources: files.iter().any(|syntax| !matches!(syntax.tree, Tree::Test)),
        };
        let (mut compiled, demands, uses) = revision.compile(diagnostics, &mut self.memory, &mut self.work);
        compiled.mnemonics = mnemonics.into_iter().collect();
        (compiled, demands, uses)
    }

    /// A source of ST of the library, parsed.
    fn library_source(&mut self, source: &'static st::standard::Source, id: FileId) -> Arc<Syntax> {
        let Self { library, stamps, .. } = self;
        let parsed = library.entry((source.path, id)).or_insert_with(|| {
            let parsed = st::parser::parse(id, source.text, source.dialect);
            let file = Arc::new(st::declare::expand(parsed.file));
            let file = StFile { dialect: source.dialect, file, library: Some(source), stamps: Arc::from([]) };
            Arc::new(Syntax::of_st(source.text, file, Untold::default(), Vec::new(), None, stamps))
        });
        Arc::clone(parsed)
    }
}

/// A block of STL of the library, parsed.
fn library_block(library: &mut HashMap<(&'static str, FileId), Arc<Syntax>>, stamps: &mut Stamps, linked: &Linked) -> Arc<Syntax> {
    let parsed = library.entry((linked.block.path, linked.file)).or_insert_with(|| {
        let mut parsed = stl::parser::parse(linked.file, linked.block.text, Some(Mnemonics::English));
        parsed.diagnostics.clear();
        Arc::new(Syntax::of_stl(linked.file, linked.block.text, parsed, None, stamps))
    });
    Arc::clone(parsed)
}

#[cfg(test)]
mod tests;
