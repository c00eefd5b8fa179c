//! Compiles the sources of a project into a program.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::Arc;

use sieben_engine::Program;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::interface::SystemBlock;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Sources, Span};
use sieben_model::symbols::SymbolTable;
use sieben_model::testing::TestPlan;

use crate::body::{Bodies, CheckedBody};
use crate::coverage::Countable;
use crate::declarations::data_block::{DataLayout, instance};
use crate::declarations::types::{BlockInterface, Declares};
use crate::language::Language;
use crate::language::is_test_file;
use crate::library::link::{Links, link};
use crate::library::{Linked, Selection};
use crate::references::{Around, Reference};
use crate::scope::Scope;
use crate::st;
use crate::st::declare::{Demand, Items, Needed, StFile, Types, collect, expand};
use crate::st::dialect::Dialect;
use crate::st::lower::mocking;
use crate::st::standard::LinkedSource;
use crate::st::untold::Untold;
use crate::stl::ast;
use crate::stl::check;
use crate::stl::declare::Blocks;
use crate::stl::declare::data_block::{fill, layout};
use crate::stl::declare::links::mentions;
use crate::stl::declare::names::block_of_name;
use crate::stl::declare::path::FieldNames;
use crate::stl::extension;
use crate::stl::lower::{lower, lower_counted};
use crate::stl::parser::{Parsed, parse};
use crate::stl::resolve::{Known, plain_callee, plain_data_block};
use crate::stl::size::code_bytes;

/// Bytes that all data blocks of a project may have together: the work memory of the largest CPU type.
const DATA_BYTES_MAX: usize = 32 << 20;

/// How to compile.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The CPU type; `None` = the default.
    pub cpu: Option<&'static CpuType>,
    /// The mnemonic language; `None` = judged over each whole file.
    pub mnemonics: Option<Mnemonics>,
    /// Report only what one file alone can tell.
    pub syntax_only: bool,
    /// A source, the first one, whose blocks take the place of those that others have with the same number: a test.
    pub replacing: Option<FileId>,
    /// Whether extension words may be used.
    pub extended: bool,
    /// The system blocks of the CPU.
    pub system_blocks: Vec<SystemBlock>,
    /// Which reads of temporary variables that may not be written are reported.
    pub temporaries: check::TemporaryReads,
    /// What the program may take from the library.
    pub library: Selection,
    /// The dialect of all sources of ST; `None` = judged over each whole file.
    pub dialect: Option<Dialect>,
    /// Whether test files among the sources are compiled; else they are told to be none of a program.
    pub tests: bool,
    /// Whether it is known of each statement and each decision how to count it ([`Compiled::countable`]): for the coverage of tests.
    pub counted: bool,
}

/// What came of it. With an error among the diagnostics the program holds what could be compiled and must not be run.
#[derive(Clone, Debug, Default)]
pub struct Compiled {
    /// The program.
    pub program: Program,
    /// All diagnostics, in the order of files and places.
    pub diagnostics: Vec<Diagnostic>,
    /// The mnemonic language of each file.
    pub mnemonics: BTreeMap<FileId, Mnemonics>,
    /// The statements of every code block of the program with all names resolved, for reference data, reasons and editors.
    pub bodies: Bodies,
    /// Symbols of blocks and their comments, for display: `FC 1` → `Dosing`.
    pub block_names: BTreeMap<BlockId, String>,
    /// The blocks of the library that belong to the program because something there names them.
    pub library: Vec<Linked>,
    /// Sources of ST of the library that belong to the program because something there needs them.
    pub st_library: Vec<LinkedSource>,
    /// How often the cyclic interrupts are called that run the tasks of a CONFIGURATION: organization block and milliseconds.
    pub intervals: BTreeMap<u16, u16>,
    /// The tests of the test file among the sources.
    pub tests: TestPlan,
    /// What can be counted in the blocks of the user, if the options ask for it.
    pub countable: BTreeMap<BlockId, Countable>,
}

impl Compiled {
    /// Whether an error is among the diagnostics, so that the program must not be run.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|diagnostic| diagnostic.severity() == Severity::Error)
    }

    /// Whether a block comes from the library.
    pub fn is_of_library(&self, block: BlockId) -> bool {
        self.library.iter().any(|linked| linked.id == block) || self.st_library.iter().any(|linked| linked.blocks.contains(&block))
    }

    /// What the statements of a block refer to, one after another; nothing if the program has no such block.
    pub fn references(&self, block: BlockId) -> Vec<Reference> {
        let interface = |block: BlockId| self.bodies.get(&block).map(|body| body.interface());
        let around = Around { interface: &interface, data: &self.program.data };
        self.bodies.get(&block).map_or_else(Vec::new, |body| body.references(block, around))
    }

    /// Whether a file is one of the user's.
    fn is_of_user(&self, file: FileId) -> bool {
        !self.library.iter().any(|linked| linked.file == file) && !self.st_library.iter().any(|linked| linked.file == file)
    }

    /// Adds the sources of the linked library blocks to those that were compiled, so that every place of the program can be shown.
    pub fn add_library_sources(&self, sources: &mut Sources) {
        for linked in &self.st_library {
            if sources.iter().len() == linked.file.0 as usize {
                sources.add(linked.source.path, linked.source.text);
            }
        }
        for linked in &self.library {
            if sources.iter().len() == linked.file.0 as usize {
                sources.add(linked.block.path, linked.block.text);
            }
        }
    }
}

/// A block of a source with its identity.
struct Found<'a> {
    id: BlockId,
    block: &'a ast::Block,
    mnemonics: Mnemonics,
}

/// Compiles all sources of a project, in any order of blocks.
pub fn compile(sources: &Sources, symbols: &SymbolTable, options: &Options) -> Compiled {
    let mut files = Vec::new();
    let mut st = Vec::new();
    let mut untold = Untold::default();
    let mut diagnostics = Vec::new();
    for (id, source) in sources.iter() {
        match Language::of(&source.name, &source.text, options.dialect) {
            Language::Stl => {
                let mut parsed = parse(id, &source.text, options.mnemonics);
                diagnostics.append(&mut parsed.diagnostics);
                files.push(SyntaxOfFile { id, file: parsed.file, mnemonics: parsed.mnemonics });
            }
            Language::St(_) if is_test_file(&source.name) && !options.tests => {
                let message = format!("`{}` is a test file, and tests are no part of a program", source.name);
                diagnostics.push(Diagnostic::new(Problem::P6240, Span::new(id, 0, 0), message));
            }
            Language::St(dialect) => {
                // A test file is written in the dialect of the program.
                let dialect = match is_test_file(&source.name) {
                    true => st.first().map_or(dialect, |first: &StFile| first.dialect).for_tests(),
                    false => dialect,
                };
                let mut parsed = st::parser::parse(id, &source.text, dialect);
                untold.look(&parsed, &source.text);
                diagnostics.append(&mut parsed.diagnostics);
                if dialect == Dialect::Codesys {
                    st::declare::name_lists(&mut parsed.file, &source.name);
                }
                st.push(StFile { id, dialect, file: Arc::new(expand(parsed.file)), library: None });
            }
        }
    }
    let of_st: HashSet<FileId> = st.iter().map(|file| file.id).collect();
    let mut compiled = compile_languages(sources, &files, st, &diagnostics, symbols, options);
    compiled.diagnostics.retain(|diagnostic| !of_st.contains(&diagnostic.span.file) || untold.lets_through(diagnostic, sources));
    compiled
}

/// A source that is parsed already.
#[derive(Clone, Debug)]
pub struct SyntaxOfFile {
    /// Which source.
    pub id: FileId,
    /// Its syntax.
    pub file: ast::File,
    /// Its mnemonic language.
    pub mnemonics: Mnemonics,
}

/// Compiles sources of STL that are parsed already; `diagnostics` are those of the parser.
pub fn compile_syntax(
    sources: &Sources,
    files: &[SyntaxOfFile],
    diagnostics: Vec<Diagnostic>,
    symbols: &SymbolTable,
    options: &Options,
) -> Compiled {
    compile_languages(sources, files, Vec::new(), &diagnostics, symbols, options)
}

/// Compiles sources of all languages that are parsed already. What a program needs of the library shows while it is checked: then
/// all begins anew with that.
fn compile_languages(
    sources: &Sources,
    files: &[SyntaxOfFile],
    st: Vec<StFile>,
    diagnostics: &[Diagnostic],
    symbols: &SymbolTable,
    options: &Options,
) -> Compiled {
    let mut needed = Needed::default();
    loop {
        let (compiled, demands) = attempt(sources, files, &st, diagnostics.to_vec(), symbols, options, &needed);
        if !needed.add(&demands) {
            return compiled;
        }
    }
}

/// Compiles once, with what the program is known to need of the library; tells what else it needs.
fn attempt(
    sources: &Sources,
    files: &[SyntaxOfFile],
    st: &[StFile],
    mut diagnostics: Vec<Diagnostic>,
    symbols: &SymbolTable,
    options: &Options,
    needed: &Needed,
) -> (Compiled, Vec<Demand>) {
    let mut cpu = options.cpu.copied().unwrap_or_default();
    if options.extended {
        cpu.accumulators = accumulators(&cpu, files, &mut diagnostics);
    }
    let mnemonics = files.iter().map(|file| (file.id, file.mnemonics)).collect();
    let mut compiled = Compiled { mnemonics, ..Compiled::default() };
    // Where the parser found something wrong, by file and first byte.
    let errors = diagnostics.iter().filter(|diagnostic| diagnostic.severity() == Severity::Error);
    let mut reported: Vec<(FileId, u32)> = errors.map(|diagnostic| (diagnostic.span.file, diagnostic.span.start)).collect();
    reported.sort_unstable();
    let reported = |span: Span| {
        let first = reported.partition_point(|&place| place < (span.file, span.start));
        reported.get(first).is_some_and(|&place| place < (span.file, span.end.max(span.start + 1)))
    };

    let mut scope = Scope::new(symbols, &options.system_blocks);
    let mut found = find_blocks(files, &scope, &cpu, options.replacing, &mut diagnostics);
    let mut taken: HashMap<BlockId, Span> = found.iter().map(|found| (found.id, found.block.name.span())).collect();
    let all_st = needed.with_library(st, sources.iter().len());
    let items = collect(&all_st, &mut scope, &cpu, options.replacing, &mut taken, &mut diagnostics);
    let defined: HashSet<BlockId> = taken.keys().copied().collect();
    // One file alone does not tell whether another one defines the block.
    let selection = Selection { enabled: options.library.enabled && !options.syntax_only, ..options.library.clone() };
    let links = link(found.iter().flat_map(|found| mentions(found.block)), &needed.blocks, &defined, &mut scope, &selection, &cpu);
    compiled.library = linked(&links, sources.iter().len() + needed.sources.len());
    compiled.st_library = needed.linked(&items, sources.iter().len());
    let library: Vec<Parsed> =
        compiled.library.iter().map(|linked| parse(linked.file, linked.block.text, Some(Mnemonics::English))).collect();
    for (linked, parsed) in compiled.library.iter().zip(&library) {
        let [block] = parsed.file.blocks.as_slice() else { unreachable!("each source of the library holds one block") };
        found.push(Found { id: linked.id, block, mnemonics: Mnemonics::English });
    }
    let mut with_library;
    let sources = match compiled.library.is_empty() && compiled.st_library.is_empty() {
        true => sources,
        false => {
            with_library = sources.clone();
            compiled.add_library_sources(&mut with_library);
            &with_library
        }
    };
    let blocks: Blocks<'_> = found.iter().map(|found| (found.id, found.block)).collect();
    let system: HashMap<BlockId, &SystemBlock> = options.system_blocks.iter().map(|block| (block.block, block)).collect();

    // First pass: everything that is declared. The order of the sources does not matter, types resolve one another.
    let languages: [&dyn Declares<'_, _>; 2] = [&items, &blocks];
    let mut types = Types::new(&scope, &languages, &system);
    let mut interfaces: HashMap<BlockId, BlockInterface> = HashMap::new();
    let mut data: HashMap<u16, DataLayout> = HashMap::new();
    for &block in system.keys() {
        if let Some(interface) = types.interface(block, Span::default()) {
            interfaces.insert(block, interface);
        }
    }
    for Found { id, block, .. } in &found {
        match id.kind {
            BlockKind::UserDefinedType => {
                types.udt(id.number, block.name.span());
            }
            BlockKind::DataBlock => {
                if let Some(layout) = layout(&mut types, id.number, block) {
                    data.insert(id.number, layout);
                }
            }
            _ => {
                if let Some(interface) = types.interface(*id, block.name.span()) {
                    interfaces.insert(*id, interface);
                }
            }
        }
    }
    for (&id, code) in &items.code {
        if let Some(interface) = types.interface(id, code.block.name.span) {
            interfaces.insert(id, interface);
        }
    }
    let globals = st::declare::layouts(&mut types, &items, &mut data);
    st::declare::all_types(&mut types, &items);
    let generated = missing_instances(&found, &items, &scope, &interfaces, &mut data, &blocks, &mut types.diagnostics);
    let field_names = FieldNames::default();
    fill_data(&mut types, &field_names, &found, &items, &data, &generated, &mut compiled.program);
    diagnostics.append(&mut types.diagnostics);
    let known = std::mem::take(&mut types.known);
    let environment = st::declare::environment(&items, (&scope, &links), &interfaces, &data, known, globals);

    // Second pass: statements.
    let exists = |id: BlockId| {
        blocks.contains_key(&id)
            || system.contains_key(&id)
            || items.code.contains_key(&id)
            || (id.kind == BlockKind::DataBlock && data.contains_key(&id.number))
    };
    let only = |id: BlockId| system.get(&id).and_then(|block| Some((block.name, block.only?)));
    let known = Known {
        sources,
        scope: &scope,
        cpu: &cpu,
        interfaces: &interfaces,
        exists: &exists,
        only: &only,
        data: &data,
        field_names: &field_names,
        temporaries: options.temporaries,
        library: &links,
        selection: &options.library,
        extended: options.extended,
    };
    for Found { id, block, mnemonics } in &found {
        if !has_statements(id.kind) {
            continue;
        }
        let Some(BlockInterface { interface, .. }) = interfaces.get(id) else { continue };
        if interface.local_size > cpu.local_data_block {
            let message = format!(
                "`{id}` declares {} bytes of local data; CPU {} has {} for a block",
                interface.local_size, cpu.name, cpu.local_data_block
            );
            diagnostics.push(Diagnostic::new(Problem::P5007, block.name.span(), message));
        }
        let mut checked = check::block(&known, *id, block, interface, *mnemonics, &reported);
        let bytes = code_bytes(&checked.block.statements);
        if bytes > u64::from(cpu.block_size_max) {
            let message = format!(
                "`{id}` has at least {bytes} bytes of code in a CPU; a block of CPU {} has at most {}",
                cpu.name, cpu.block_size_max
            );
            checked.diagnostics.push(Diagnostic::new(Problem::P5009, block.name.span(), message));
        }
        // What a check finds in a block of the library is no matter of the user's; that there are no errors is a test.
        if !compiled.is_of_library(*id) {
            diagnostics.append(&mut checked.diagnostics);
        }
        if checked.whole {
            let lower = if options.counted { lower_counted } else { lower };
            compiled.program.code.insert(*id, lower(&checked.block, &cpu));
            compiled.bodies.insert(*id, Arc::new(CheckedBody::Stl(checked.block)));
        }
    }
    let mut bodies = environment.compile(&cpu, &exists, options.counted);
    compiled.program.code.append(&mut bodies.code);
    compiled.intervals = bodies.intervals;
    compiled.bodies.extend(bodies.typed.into_iter().map(|(id, block)| (id, Arc::new(CheckedBody::St(block)))));
    compiled.tests = bodies.tests;
    if options.counted {
        compiled.countable = bodies.countable;
        let known = compiled.bodies.iter().filter_map(|(id, body)| Some((*id, body.countable(compiled.program.code.get(id)?)?)));
        compiled.countable.extend(known);
        let not_mine = |id: BlockId| compiled.is_of_library(id) || compiled.tests.blocks.contains(&id);
        let strangers: Vec<BlockId> = compiled.countable.keys().copied().filter(|&id| not_mine(id)).collect();
        strangers.iter().for_each(|id| drop(compiled.countable.remove(id)));
    }
    for moved in mocking::prepare(&mut compiled.program, &compiled.tests) {
        compiled.countable.entry(moved).and_modify(Countable::moved_by_one);
    }
    diagnostics.extend(bodies.diagnostics.into_iter().filter(|diagnostic| compiled.is_of_user(diagnostic.span.file)));
    compiled.program.names = environment.program_names(&mut diagnostics);
    let has_main = blocks.contains_key(&BlockId::ob(1)) || compiled.program.code.contains_key(&BlockId::ob(1)) || bodies.failed;
    let nothing = files.is_empty() && st.is_empty();
    // Tasks of a CONFIGURATION may all have intervals.
    let configured = items.configurations.iter().any(|(configuration, _)| !configuration.resources.is_empty());
    if !nothing && !has_main && !configured {
        let stl = found.iter().find(|found| !compiled.is_of_library(found.id)).map(|found| found.block.name.span());
        let place = stl.or_else(|| items.code.values().next().map(|code| code.block.name.span)).unwrap_or_default();
        diagnostics.push(Diagnostic::new(Problem::P3013, place, "there is no OB 1, so nothing runs in the cycle"));
    }

    if options.syntax_only {
        diagnostics.retain(|diagnostic| !needs_other_files(diagnostic.problem));
    }
    diagnostics.sort_by_key(|diagnostic| (diagnostic.span.file, diagnostic.span.start));
    compiled.diagnostics = diagnostics;
    compiled.block_names = block_names(&found, &scope);
    compiled.block_names.extend(items.names.iter().map(|(&id, name)| (id, name.clone())));
    let demands = environment.demands();
    (compiled, demands)
}

/// The accumulators of the CPU type, or those that the program asks for with `__FEATURE 0`.
///
/// Code is made for one number of them. A program that asks for both gets what its CPU type has, and the other only in the
/// same block behind the statement that asks.
fn accumulators(cpu: &CpuType, files: &[SyntaxOfFile], diagnostics: &mut Vec<Diagnostic>) -> u8 {
    let asked = extension::accumulators_asked(files.iter().flat_map(|file| &file.file.blocks));
    let Some(&(first, first_span)) = asked.first() else { return cpu.accumulators };
    let Some(&(_, span)) = asked.iter().find(|&&(other, _)| other != first) else { return first };
    let message =
        "this asks for another number of accumulators than the program did before; it holds for the statements behind it in this block";
    diagnostics.push(Diagnostic::new(Problem::P2042, span, message).related(first_span, "the other one is asked for here"));
    cpu.accumulators
}

/// Problems that may come of files that were not given.
fn needs_other_files(problem: Problem) -> bool {
    matches!(
        problem,
        Problem::P3003
            | Problem::P3008
            | Problem::P3013
            | Problem::P3014
            | Problem::P3015
            | Problem::P3018
            | Problem::P3020
            | Problem::P3021
    )
}

/// The linked blocks with their places behind the user's sources.
fn linked(links: &Links, first: usize) -> Vec<Linked> {
    let file = |index: usize| FileId(u32::try_from(first + index).expect("fewer than 2^32 source files"));
    links.iter().enumerate().map(|(index, (&id, &block))| Linked { id, block, file: file(index) }).collect()
}

fn has_statements(kind: BlockKind) -> bool {
    matches!(kind, BlockKind::OrganizationBlock | BlockKind::Function | BlockKind::FunctionBlock)
}

/// The identities of all blocks; of two with the same number only the first is kept.
fn find_blocks<'a>(
    files: &'a [SyntaxOfFile],
    scope: &Scope,
    cpu: &CpuType,
    replacing: Option<FileId>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Found<'a>> {
    let mut found: Vec<Found<'a>> = Vec::new();
    let mut places: HashMap<BlockId, Span> = HashMap::new();
    let mut doubled: HashSet<BlockId> = HashSet::new();
    for SyntaxOfFile { file, mnemonics, .. } in files {
        for block in &file.blocks {
            let span = block.name.span();
            let id = match block_of_name(scope, &block.name) {
                Ok(id) => id,
                Err(message) => {
                    let problem = match &block.name {
                        // The parser has reported a name that is missing.
                        ast::BlockName::Symbol(word) if word.text.is_empty() => continue,
                        ast::BlockName::Symbol(_) => Problem::P3003,
                        ast::BlockName::Absolute { .. } => Problem::P5003,
                    };
                    diagnostics.push(Diagnostic::new(problem, span, message));
                    continue;
                }
            };
            if id.kind != block.kind {
                let message = format!("`{id}` is not {}; this header begins {}", article(block.kind), article(block.kind));
                diagnostics.push(Diagnostic::new(Problem::P2200, span, message));
                continue;
            }
            let limit = match id.kind {
                BlockKind::DataBlock => cpu.db_number_max,
                BlockKind::Function | BlockKind::FunctionBlock => cpu.fc_number_max,
                _ => u16::MAX,
            };
            if id.number > limit {
                let message = format!("`{id}`: CPU {} has numbers up to {limit}", cpu.name);
                diagnostics.push(Diagnostic::new(Problem::P5003, span, message));
            }
            if id.kind == BlockKind::OrganizationBlock && !cpu.has_organization_block(id.number) {
                diagnostics.push(not_called(cpu, id.number, span));
            }
            if id == BlockId::db(0) {
                diagnostics.push(Diagnostic::new(Problem::P5003, span, "`DB 0` is reserved; data blocks begin with `DB 1`"));
                continue;
            }
            if let Some(&first) = places.get(&id) {
                if replacing == Some(first.file) && first.file != span.file {
                    continue;
                }
                let message = |implicit: bool| match implicit {
                    true => format!("these statements outside any block are `{id}`, which exists already"),
                    false => format!("`{id}` exists twice"),
                };
                diagnostics.push(Diagnostic::new(Problem::P3002, span, message(block.implicit)).related(first, "the other one is here"));
                if doubled.insert(id) {
                    diagnostics.push(
                        Diagnostic::new(Problem::P3002, first, format!("`{id}` exists twice")).related(span, "the other one is here"),
                    );
                }
                continue;
            }
            places.insert(id, span);
            found.push(Found { id, block, mnemonics: *mnemonics });
        }
    }
    found
}

fn article(kind: BlockKind) -> &'static str {
    match kind {
        BlockKind::OrganizationBlock => "an organization block (OB)",
        BlockKind::Function => "a function (FC)",
        BlockKind::FunctionBlock => "a function block (FB)",
        BlockKind::DataBlock => "a data block (DB)",
        BlockKind::SystemFunction => "a system function (SFC)",
        BlockKind::SystemFunctionBlock => "a system function block (SFB)",
        BlockKind::UserDefinedType => "a user-defined type (UDT)",
    }
}

/// Instance data blocks that calls name and no source defines, in the order of their numbers.
fn missing_instances(
    found: &[Found<'_>],
    items: &Items<'_>,
    scope: &Scope,
    interfaces: &HashMap<BlockId, BlockInterface>,
    data: &mut HashMap<u16, DataLayout>,
    blocks: &Blocks<'_>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<u16> {
    let mut generated = Vec::new();
    let statements = found.iter().flat_map(|found| &found.block.statements);
    let of_stl = statements.filter_map(|statement| {
        let ast::Operand::Call(call) = &statement.operand else { return None };
        let (operand, span) = call.instance.as_ref()?;
        Some((plain_callee(scope, &call.callee)?, plain_data_block(scope, operand)?, *span))
    });
    let calls: Vec<(BlockId, u16, Span)> = of_stl.chain(items.instances_called()).collect();
    for (callee, number, span) in calls {
        if number == 0 || data.contains_key(&number) || blocks.contains_key(&BlockId::db(number)) {
            continue;
        }
        let Some(BlockInterface { instance, .. }) = interfaces.get(&callee) else { continue };
        if matches!(callee.kind, BlockKind::Function | BlockKind::SystemFunction) {
            continue;
        }
        data.insert(number, DataLayout { structure: instance.clone(), based_on: Some(callee) });
        generated.push(number);
        let message = format!("`DB {number}` has no source; it is made as an instance of `{callee}`");
        diagnostics.push(Diagnostic::new(Problem::P3014, span, message));
    }
    generated.sort_unstable();
    generated
}

fn fill_data<'a>(
    types: &mut Types<'a>,
    field_names: &FieldNames,
    found: &[Found<'_>],
    items: &'a Items<'a>,
    data: &HashMap<u16, DataLayout>,
    generated: &[u16],
    program: &mut Program,
) {
    let mut total = 0;
    for Found { id, block, .. } in found {
        if id.kind != BlockKind::DataBlock {
            continue;
        }
        let Some(layout) = data.get(&id.number) else { continue };
        total += layout.structure.size as usize;
        if total > DATA_BYTES_MAX {
            let message = format!("with `{id}` the data blocks have more than {} MB", DATA_BYTES_MAX >> 20);
            types.report(Problem::P5006, block.name.span(), message);
            return;
        }
        program.data.insert(id.number, fill(types, field_names, id.number, block, layout));
    }
    let mut of_st: Vec<u16> =
        data.keys().copied().filter(|number| !program.data.contains_key(number) && !generated.contains(number)).collect();
    of_st.sort_unstable();
    for number in generated.iter().chain(&of_st) {
        let Some(layout) = data.get(number) else { continue };
        total += layout.structure.size as usize;
        if total > DATA_BYTES_MAX {
            let message = format!("with `DB {number}` the data blocks have more than {} MB", DATA_BYTES_MAX >> 20);
            types.report(Problem::P5006, Span::default(), message);
            return;
        }
        let block = st::declare::fill(types, items, *number, layout);
        program.data.insert(*number, block.unwrap_or_else(|| instance(*number, layout)));
    }
}

/// Names of blocks for display: their symbols, else the NAME of their header.
fn block_names(found: &[Found<'_>], scope: &Scope) -> BTreeMap<BlockId, String> {
    let headers = found.iter().filter_map(|found| Some((found.id, found.block.header.name.as_ref()?.text.clone())));
    let mut names: BTreeMap<BlockId, String> = headers.collect();
    names.extend(scope.blocks().map(|(block, name)| (block, name.to_owned())));
    names
}

/// Compiles any bytes as a source; for fuzzing.
pub fn fuzz(data: &[u8]) {
    let mut sources = Sources::default();
    sources.add("fuzz.awl", String::from_utf8_lossy(data));
    let compiled = compile(&sources, &SymbolTable::default(), &Options { extended: true, ..Options::default() });
    for (id, block) in &compiled.program.code {
        assert_eq!(sieben_engine::ir::verify(&block.code), Ok(()), "the code of {id} keeps the rules of the IR");
    }
}

/// The warning about an organization block that never runs.
fn not_called(cpu: &CpuType, number: u16, span: Span) -> Diagnostic {
    let ranges = cpu.organization_blocks.iter().map(|&(first, last)| match last - first {
        0 => format!("{first}"),
        1 => format!("{first}, {last}"),
        _ => format!("{first} to {last}"),
    });
    let message = format!("the CPU {} never calls `OB {number}`; it calls OB {}", cpu.name, ranges.collect::<Vec<_>>().join(", "));
    let others: Vec<&str> = CpuType::ALL.iter().filter(|other| other.has_organization_block(number)).map(|other| other.name).collect();
    let diagnostic = Diagnostic::new(Problem::P5010, span, message);
    if others.is_empty() { diagnostic } else { diagnostic.help(format!("CPU types that call it: {}", others.join(", "))) }
}

#[cfg(test)]
mod tests {
    use sieben_model::block::BlockKind;
    use sieben_model::interface::{Interface, Section, SystemBlock, Variable};
    use sieben_model::source::Span;
    use sieben_model::types::DataType;

    use super::*;

    /// A block that names something which its source does not list is missing from the program, and nobody is told.
    /// A system function for the clock, as the CPU has it.
    fn clock(name: &'static str, number: u16, parameter: &str) -> SystemBlock {
        let variable = |(offset, name, section, data_type): (u32, &str, Section, DataType)| Variable {
            name: name.to_owned(),
            section,
            data_type,
            offset,
            initial: Vec::new(),
            comment: String::new(),
            span: Span::default(),
        };
        let section = if number == 0 { Section::Input } else { Section::Output };
        let parameters = [(0, parameter, section, DataType::DateAndTime), (1, "RET_VAL", Section::Output, DataType::Int)];
        let interface = Interface { variables: parameters.into_iter().map(variable).collect(), instance_size: 0, local_size: 0 };
        SystemBlock { block: BlockId::new(BlockKind::SystemFunction, number), name, interface, only: None }
    }

    #[test]
    fn every_block_of_the_library_in_st_compiles() {
        let options = Options { system_blocks: vec![clock("SET_CLK", 0, "PDT"), clock("READ_CLK", 1, "CDT")], ..Options::default() };
        for &source in st::standard::library::SOURCES {
            let mut needed = Needed { blocks: Vec::new(), sources: vec![source] };
            let compiled = loop {
                let (compiled, demands) = attempt(&Sources::default(), &[], &[], Vec::new(), &SymbolTable::default(), &options, &needed);
                if !needed.add(&demands) {
                    break compiled;
                }
            };
            for linked in &compiled.st_library {
                assert!(!linked.blocks.is_empty(), "{} holds blocks", linked.source.path);
                for block in &linked.blocks {
                    let name = compiled.block_names.get(block).cloned().unwrap_or_default();
                    assert!(compiled.program.code.contains_key(block), "`{name}` of {} compiles", linked.source.path);
                }
            }
        }
    }
}
