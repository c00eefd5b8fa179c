//! The engine: a program as machine code, with an interpreter for what machine code cannot do.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use sieben_engine::interpreter::weight;
use sieben_engine::ir::{Callee, Code, Inst, Place};
use sieben_engine::machine::memory::DataBlockEntry;
use sieben_engine::machine::{Memory, Registers};
use sieben_engine::{CodeBlock, Context, Engine, Entry, Exit, Interpreter, Layout, Machine, Program};
use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};

use crate::entry::{Function, Generation};
use crate::passes::{Pass, PassSet};
use crate::run::{Areas, Limits, OpenTable, Room, Run, Scratch, areas, open_table};
use crate::stack_lifetimes;
use crate::translate::{self, Options};
use crate::unrolling::{Unrolled, UnrolledLoop, write_out};

/// More parameters at one call are left to the interpreter: every activation has room for as many.
const PARAMETERS_MAX: usize = 256;
/// Programs with more statements are left to the interpreter: they would compile for seconds.
const STATEMENTS_MAX: usize = 200_000;
/// Blocks with more IR instructions are left to the interpreter, with the whole program: the time to compile a function and the
/// memory that it takes grow faster than its length.
const BLOCK_INSTRUCTIONS_MAX: usize = 400_000;

/// Blocks with more loops are left to the interpreter: the time to compile them grows with the square of their number.
const LOOPS_MAX: usize = 1_000;
/// Longer programs are compiled without Cranelift's optimizations: they would keep a core busy for seconds.
const OPTIMIZED_STATEMENTS_MAX: usize = 50_000;
/// Blocks with more loops in one another are compiled without them too: a hundred take Cranelift a second, eight hundred a minute.
const OPTIMIZED_NESTED_MAX: usize = 32;
/// Blocks with more accesses by computed addresses are compiled without them too. Most of these are known to be inside where a block knows
/// its instance and where its pointers lead; a function in which many ask is left to the first tier by itself.
const OPTIMIZED_ACCESSES_MAX: usize = 40_000;

/// A block as machine code needs it.
#[derive(Clone, Debug)]
pub(crate) struct Native {
    pub(crate) id: BlockId,
    pub(crate) local_size: u32,
    pub(crate) code: Code,
    /// Values in the local data that only their constant address reaches, in order: position in bits and width.
    pub(crate) private: Vec<(u32, Width)>,
    /// Bytes of the local data that nobody needs between statements, in order.
    pub(crate) handed: Vec<Range<u32>>,
    /// Bits of the local data beside which nobody needs anything in their byte, in order.
    pub(crate) single_bits: Vec<u32>,
    /// What its numbers are in the program, if loops are written out.
    pub(crate) written_out: Option<Unrolled>,
}

impl Native {
    /// The same with its loops of few iterations written out.
    fn with_iterations_written_out(&self) -> Self {
        let Some((code, written_out)) = write_out(&self.code) else { return self.clone() };
        Self { code, written_out: Some(written_out), ..self.clone() }
    }

    /// The bit that stands alone in a byte of the local data, if there is one.
    pub(crate) fn single_bit_in(&self, byte: u32) -> Option<u32> {
        let next = self.single_bits.partition_point(|&bit| bit < 8 * byte);
        self.single_bits.get(next).copied().filter(|bit| bit / 8 == byte)
    }

    /// The number of a statement in the program.
    pub(crate) fn named(&self, statement: u32) -> u32 {
        self.written_out.as_ref().map_or(statement, |it| it.statement(statement))
    }

    /// The number of an instruction in the program.
    pub(crate) fn named_inst(&self, inst: u32) -> u32 {
        self.written_out.as_ref().map_or(inst, |it| it.inst(inst))
    }

    /// Loops that are written out.
    pub(crate) fn iterations(&self) -> &[UnrolledLoop] {
        self.written_out.as_ref().map_or(&[], Unrolled::iterations)
    }

    /// What entering it takes from the budget.
    pub(crate) fn weight(&self) -> u16 {
        weight(self.named(self.code.statement_count() as u32) as usize)
    }

    /// What a jump back takes from the budget.
    pub(crate) fn weight_of_jump(&self, (from, to): (u32, u32)) -> u16 {
        weight((self.named(from) - self.named(to)) as usize)
    }

    /// Whether nobody needs so many bytes of the local data between statements.
    pub(crate) fn is_handed(&self, at: i32, bytes: u32) -> bool {
        let Ok(at) = u32::try_from(at) else { return false };
        let index = self.handed.partition_point(|piece| piece.end <= at);
        self.handed.get(index).is_some_and(|piece| piece.start <= at && at + bytes <= piece.end)
    }

    /// The statement of an instruction.
    pub(crate) fn statement_of(&self, inst: usize) -> u32 {
        // The last entry marks the end of the code.
        let firsts = &self.code.statements[..self.code.statement_count()];
        firsts.partition_point(|&first| first as usize <= inst).saturating_sub(1) as u32
    }

    /// How many parameters the statement has passed before this instruction, without those that a call in it took.
    pub(crate) fn passed_before(&self, inst: usize) -> usize {
        let first = self.code.statements[self.statement_of(inst) as usize] as usize;
        passed(&self.code.insts[first..inst])
    }
}

/// Parameters passed and not taken by a call.
fn passed(insts: &[Inst]) -> usize {
    insts.iter().fold(0usize, |passed, inst| match inst {
        Inst::PassParameter { .. } => passed + 1,
        Inst::Call { parameters, .. } => passed.saturating_sub(usize::from(*parameters)),
        _ => passed,
    })
}

/// What all machine code of a program has in common, in whichever way it is compiled.
#[derive(Debug)]
pub(crate) struct Source {
    interpreter: Arc<Interpreter>,
    blocks: Arc<[Native]>,
    layout: Layout,
    parameters_max: usize,
    asks_before_writing: bool,
    forgets_locals: bool,
}

impl Source {
    /// Prepares a program; one that cannot become machine code is refused, with the reason as the end of a sentence.
    pub(crate) fn new(program: &Program, layout: &Layout, interpreter: Arc<Interpreter>) -> Result<Self, String> {
        let parameters_max = limits(program)?;
        let native = |(&id, block): (&BlockId, &CodeBlock)| {
            let mut code = block.code.clone();
            if code.insts.is_empty() {
                code = sieben_engine::ir::Builder::default().finish();
            }
            let mut private = block.private.clone();
            private.sort_unstable();
            let handed = stack_lifetimes::of_one_statement(block);
            let single_bits = stack_lifetimes::single_bits(block, &handed);
            Native { id, local_size: block.local_size, code, private, handed, single_bits, written_out: None }
        };
        let blocks: Arc<[Native]> = program.code.iter().map(native).collect();
        let asks_before_writing = !layout.read_only.is_empty() || makes_protected_blocks(&blocks);
        let entered = entered(program);
        let forgets_locals = entered.iter().all(|block| block.reads_own_locals || !reads_locals(&block.code));
        Ok(Self { interpreter, blocks, layout: layout.clone(), parameters_max, asks_before_writing, forgets_locals })
    }

    /// Whether Cranelift's optimizations take a bounded time.
    pub(crate) fn may_optimize(&self) -> bool {
        let statements: usize = self.blocks.iter().map(|block| block.code.statement_count()).sum();
        let nested = self.blocks.iter().map(|block| nested_loops(&block.code)).max().unwrap_or(0);
        let few_accesses = |block: &Native| computed_accesses(&block.code) <= OPTIMIZED_ACCESSES_MAX;
        statements <= OPTIMIZED_STATEMENTS_MAX && nested <= OPTIMIZED_NESTED_MAX && self.blocks.iter().all(few_accesses)
    }

    /// Organization blocks that may begin as machine code, by number. In others the interpreter looks at each call whether it has room.
    fn outermost(&self, rooms: &[Room], generation: &Generation) -> Box<[Option<Outermost>]> {
        let limits = Limits::new(&self.layout);
        let mut outermost = Vec::new();
        for (code, (block, &room)) in self.blocks.iter().zip(rooms).enumerate() {
            let local_size = block.local_size as usize;
            if block.id.kind == BlockKind::OrganizationBlock
                && limits.have(local_size, room)
                && let Some(function) = generation.function(code)
            {
                let number = usize::from(block.id.number);
                outermost.resize(outermost.len().max(number + 1), None);
                let information = local_size.min(START_INFORMATION_BYTES);
                outermost[number] = Some(Outermost { code: code as u64, information, function });
            }
        }
        outermost.into_boxed_slice()
    }

    /// The blocks as they are compiled.
    fn blocks(&self, options: Options) -> Cow<'_, [Native]> {
        match options.does(Pass::Unrolling) && !options.exact {
            true => self.blocks.iter().map(Native::with_iterations_written_out).collect(),
            false => Cow::Borrowed(&self.blocks),
        }
    }

    /// What is known of the program beside what is wanted. Who looks at the registers finds the local data, too.
    fn options(&self, wanted: Options) -> Options {
        Options {
            asks_before_writing: self.asks_before_writing,
            forgets_locals: self.forgets_locals && !wanted.exact && wanted.passes.has(Pass::StackLifetimes),
            ..wanted
        }
    }

    /// Compiles all blocks.
    pub(crate) fn compile(&self, options: Options) -> Result<Jit, String> {
        let options = self.options(options);
        let (generation, pinned, rooms) =
            translate::program(&self.blocks(options), &|id| self.interpreter.code(id), &self.layout, options)?;
        let entry = |number: u16| {
            let range = &self.layout.data_blocks[&number];
            let read_only = self.layout.read_only.contains(&number);
            (number, DataBlockEntry { base: range.start as u32, length: range.len() as u32, read_only })
        };
        let compiled = Compiled {
            outermost: self.outermost(&rooms, &generation),
            rooms,
            scratch_parameters: Scratch::parameters(self.parameters_max),
            limits: Limits::new(&self.layout),
            interpreter: Arc::clone(&self.interpreter),
            blocks: Arc::clone(&self.blocks),
            generation,
            pinned: pinned.into_iter().map(entry).collect(),
            asks_before_writing: self.asks_before_writing,
            parameters_max: self.parameters_max,
            areas: areas(&self.layout),
            open_table: open_table(&self.layout),
            any_registers: options.exact,
        };
        Ok(Jit { compiled, layout: self.layout.clone(), number: ENGINES.fetch_add(1, Ordering::Relaxed) })
    }
}

/// Bytes of the start information of an organization block.
const START_INFORMATION_BYTES: usize = 20;

/// An organization block that may begin as machine code.
#[derive(Clone, Copy, Debug)]
struct Outermost {
    /// Its place in the list.
    code: u64,
    /// Bytes of the start information for which its local data have room.
    information: usize,
    function: Function,
}

/// A program in both forms.
#[derive(Debug)]
pub(crate) struct Compiled {
    /// Organization blocks that may begin as machine code, by number.
    outermost: Box<[Option<Outermost>]>,
    /// By block, what a function needs where it begins.
    pub(crate) rooms: Vec<Room>,
    /// Parameters for which a run needs room.
    scratch_parameters: usize,
    pub(crate) limits: Limits,
    pub(crate) interpreter: Arc<Interpreter>,
    pub(crate) blocks: Arc<[Native]>,
    pub(crate) generation: Generation,
    /// Data blocks that the code takes to be as they were loaded.
    pinned: Vec<(u16, DataBlockEntry)>,
    /// Whether the code asks before it writes to a data block that it does not know.
    asks_before_writing: bool,
    pub(crate) parameters_max: usize,
    pub(crate) areas: Areas,
    /// The data blocks of the layout, for machine code that opens them by numbers that it computes.
    pub(crate) open_table: OpenTable,
    /// Whether organization blocks begin with the registers that they are given; otherwise with fresh ones.
    any_registers: bool,
}

impl Compiled {
    /// Whether the data blocks are as the code takes them to be.
    pub(crate) fn fits(&self, memory: &Memory) -> bool {
        memory.data_blocks.is_as_laid_out()
            || self.pinned.iter().all(|&(number, entry)| memory.data_block(u64::from(number)) == Some(entry))
    }

    /// Whether no data block is protected, or the code asks before it writes. One may have been restored that SFC 85 made in another
    /// program.
    fn protects(&self, memory: &Memory) -> bool {
        self.asks_before_writing || !memory.data_blocks.iter().flatten().any(|entry| entry.read_only)
    }
}

/// Which status bits machine code calculates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StatusBits {
    /// All, wherever somebody may look at the registers: in STOP they are those of the real CPU.
    All,
    /// Those that a statement reads. To who looks at the registers, /FC, STA, OR, OS, OV, CC 0 and CC 1 may show an older value: in STOP
    /// and HOLD, and when an organization block has ended.
    Needed,
}

/// A loaded program as machine code; shared by any number of CPUs of the same layout.
#[derive(Debug)]
pub struct Jit {
    compiled: Compiled,
    layout: Layout,
    /// By which a machine knows it that has run here, so that its layout is not compared again.
    number: u64,
}

/// Numbers of engines that were given away.
static ENGINES: AtomicU64 = AtomicU64::new(0);

impl Jit {
    /// Compiles all blocks of a program for a layout. A program that cannot become machine code is interpreted.
    pub fn load(program: &Program, layout: &Layout) -> Arc<dyn Engine> {
        Self::compiled(program, layout, StatusBits::All).unwrap_or_else(|_| Interpreter::load(program, layout))
    }

    /// Compiles all blocks of a program for a layout.
    ///
    /// # Errors
    /// Why the program cannot become machine code, as the end of a sentence: it is too large, or the machine is not supported.
    pub fn compiled(program: &Program, layout: &Layout, status: StatusBits) -> Result<Arc<dyn Engine>, String> {
        Self::compiled_with(program, layout, status, PassSet::default())
    }

    /// The same with some of the optimizations.
    ///
    /// # Errors
    /// Why the program cannot become machine code, as the end of a sentence.
    pub fn compiled_with(program: &Program, layout: &Layout, status: StatusBits, passes: PassSet) -> Result<Arc<dyn Engine>, String> {
        let source = Source::new(program, layout, Arc::new(Interpreter::new(program, layout)))?;
        let may_optimize = source.may_optimize();
        let optimize = status == StatusBits::Needed && may_optimize;
        let options = Options { exact: status == StatusBits::All, optimize, passes, ..Options::default() };
        let jit = match source.compile(options) {
            // Optimized code keeps fewer values on the stack.
            Err(_) if may_optimize && !optimize => source.compile(Options { optimize: true, ..options })?,
            other => other?,
        };
        Ok(Arc::new(jit))
    }

    /// All blocks as text, for people: the IR, Cranelift's IR of the optimized tier and the instructions of this machine.
    ///
    /// # Errors
    /// Why the program cannot become machine code, as the end of a sentence.
    pub fn listing(program: &Program, layout: &Layout) -> Result<String, String> {
        let source = Source::new(program, layout, Arc::new(Interpreter::new(program, layout)))?;
        let options = source.options(Options { exact: false, optimize: true, ..Options::default() });
        translate::listing(&source.blocks(options), &|id| source.interpreter.code(id), &source.layout, options)
    }

    /// The bytes of all blocks as optimized code for a fixed x86-64 processor: the same on every computer.
    ///
    /// # Errors
    /// Why the program cannot become machine code, as the end of a sentence.
    #[cfg(target_arch = "x86_64")]
    pub fn counted_bytes(program: &Program, layout: &Layout) -> Result<usize, String> {
        let source = Source::new(program, layout, Arc::new(Interpreter::new(program, layout)))?;
        let options = source.options(Options { exact: false, optimize: true, ..Options::default() });
        translate::counted_bytes(&source.blocks(options), &|id| source.interpreter.code(id), layout, options)
    }

    /// Compiles all blocks for aarch64 in every tier, with Cranelift's checks on, and throws the code away; bytes of all tiers.
    ///
    /// # Errors
    /// What Cranelift found, or why the program cannot become machine code.
    #[cfg(feature = "aarch64")]
    pub fn check_aarch64(program: &Program, layout: &Layout) -> Result<usize, String> {
        let source = Source::new(program, layout, Arc::new(Interpreter::new(program, layout)))?;
        let find = |id| source.interpreter.code(id);
        let mut bytes = 0;
        for (exact, optimize) in [(true, false), (false, false), (false, true)] {
            let options = source.options(Options { exact, optimize, ..Options::default() });
            bytes += translate::aarch64_bytes(&source.blocks(options), &find, layout, options)?;
        }
        Ok(bytes)
    }

    /// The same with every operation called instead of written out: what the inlined ones are compared with.
    pub fn load_without_inlining(program: &Program, layout: &Layout) -> Arc<dyn Engine> {
        let interpreter = Arc::new(Interpreter::new(program, layout));
        let source = Source::new(program, layout, Arc::clone(&interpreter));
        match source.and_then(|source| source.compile(Options { inline: false, ..Options::default() })) {
            Ok(jit) => Arc::new(jit),
            Err(_) => interpreter,
        }
    }

    /// Whether this run can be machine code: nobody watches statements, and the machine is laid out as the code was compiled for.
    fn fits(&self, machine: &mut Machine) -> bool {
        let memory = &mut machine.memory;
        (memory.known_layout.is_known(self.number, &memory.layout) || self.is_my_layout(memory))
            // Data blocks that another program created may lie behind what this one knows.
            && memory.arena.len() >= self.layout.size
            && machine.timers.len() == usize::from(self.layout.timers)
            && machine.counters.len() == usize::from(self.layout.counters)
            && (memory.data_blocks.is_as_laid_out() || self.compiled.fits(memory) && self.compiled.protects(memory))
    }

    /// Whether a layout is the one that the code was compiled for.
    #[cold]
    fn is_my_layout(&self, memory: &mut Memory) -> bool {
        let is_it = *memory.layout == self.layout;
        if is_it {
            memory.known_layout.note(self.number, &memory.layout);
        }
        is_it
    }

    /// Whether machine code may begin with these registers: the open data blocks lie inside the arena, and the code of organization blocks
    /// relies on no others.
    fn begins_with(&self, registers: &Registers, arena: usize) -> bool {
        let inside = |base: u64, length: u64| base.checked_add(length).is_some_and(|end| end <= arena as u64);
        (self.compiled.any_registers || *registers == Registers::fresh())
            && inside(registers.db_base, registers.db_length)
            && inside(registers.di_base, registers.di_length)
    }

    /// The organization block, if it may begin as machine code on this machine.
    fn begins(&self, context: &mut Context<'_>, entry: &Entry) -> Option<&Outermost> {
        let machine = &mut *context.machine;
        let block = self.compiled.outermost.get(usize::from(entry.block.number))?.as_ref()?;
        // The code of other blocks relies on a caller.
        let begins = entry.block.kind == BlockKind::OrganizationBlock
            && entry.registers.as_ref().is_none_or(|registers| self.begins_with(registers, machine.memory.arena.len()))
            && context.tracer.is_none()
            && self.fits(machine);
        begins.then_some(block)
    }

    #[inline]
    fn run_native(&self, context: &mut Context<'_>, block: &Outermost, entry: &Entry) -> Exit {
        let mut scratch = Scratch::take(self.compiled.scratch_parameters);
        context.machine.registers = Registers::fresh();
        if let Some(registers) = &entry.registers {
            begin_with(&mut context.machine.registers, registers);
        }
        let information = &mut context.machine.memory.arena[self.layout.local.start..];
        match information.first_chunk_mut() {
            // Of a length that is known it is two instructions.
            Some(whole) if block.information == START_INFORMATION_BYTES => *whole = entry.start_information,
            _ => write_first(information, &entry.start_information[..block.information]),
        }
        let mut run = Run::new(context, &self.compiled, &mut scratch);
        let (local, link, parameters) = (run.local_start(), run.link_address(0), run.parameters_start());
        let first = &mut run.scratch.links[0];
        (first.code, first.site, first.local) = (block.code, 0, local as u64);
        (first.parameters, first.parameters_end) = (parameters, parameters);
        let left = Generation::enter(block.function, &mut run, local, link);
        if left {
            return self.leave(run.exit.take(), run.budget, scratch, context);
        }
        let machine = &mut *run.context.machine;
        machine.budget = run.budget;
        // Whoever was asked was shown frames.
        clear_frames(machine);
        scratch.keep();
        Exit::Finished
    }

    /// The end of a run that was left.
    #[cold]
    fn leave(&self, exit: Option<Exit>, budget: i64, scratch: Box<Scratch>, context: &mut Context<'_>) -> Exit {
        context.machine.budget = budget;
        scratch.keep();
        match exit {
            Some(exit) => exit,
            // Where the interpreter takes over is no safe point: nobody is to see that it does.
            None => self.compiled.interpreter.go_on(context),
        }
    }
}

/// Takes away frames and parameters of a run that has ended; mostly there are none.
#[inline]
fn clear_frames(machine: &mut Machine) {
    #[cold]
    #[inline(never)]
    fn clear(machine: &mut Machine) {
        machine.frames.clear();
        machine.parameters.clear();
    }
    if !(machine.frames.is_empty() && machine.parameters.is_empty()) {
        clear(machine);
    }
}

/// Begins with other registers than fresh ones: an organization block that goes on.
#[cold]
#[inline(never)]
fn begin_with(registers: &mut Registers, with: &Registers) {
    registers.clone_from(with);
}

/// Writes the first bytes of memory. Apart from the code that knows how many they are, which would not be two instructions otherwise.
#[cold]
#[inline(never)]
fn write_first(memory: &mut [u8], bytes: &[u8]) {
    memory[..bytes.len()].copy_from_slice(bytes);
}

impl Engine for Jit {
    fn run(&self, context: &mut Context<'_>, entry: &Entry) -> Exit {
        clear_frames(context.machine);
        match self.begins(context, entry) {
            Some(block) => self.run_native(context, block, entry),
            None if self.compiled.interpreter.has_block(entry.block) => self.compiled.interpreter.run(context, entry),
            None => Exit::Finished,
        }
    }

    fn resume(&self, context: &mut Context<'_>) -> Exit {
        // A suspended run has all its frames in the machine, as the interpreter keeps them.
        self.compiled.interpreter.resume(context)
    }

    fn go_on(&self, context: &mut Context<'_>) -> Exit {
        self.compiled.interpreter.go_on(context)
    }

    fn has_block(&self, block: BlockId) -> bool {
        self.compiled.interpreter.has_block(block)
    }

    fn code_bytes(&self) -> usize {
        self.compiled.generation.bytes()
    }
}

/// Whether a block calls SFC 85, which may make protected data blocks.
fn makes_protected_blocks(blocks: &[Native]) -> bool {
    let crea_db = BlockId::new(BlockKind::SystemFunction, 85);
    let is_it = |inst: &Inst| matches!(inst, Inst::Call { callee: Callee::Block(id), .. } if *id == crea_db);
    blocks.iter().any(|block| block.code.insts.iter().any(is_it))
}

/// The last statement of a block, if it is nothing but its end: who ends the block in the middle may as well go there.
pub(crate) fn end(code: &Code) -> Option<u32> {
    let last = code.statement_count().checked_sub(1)?;
    (code.statement(last) == [Inst::Return]).then_some(last as u32)
}

/// Each jump back of a block: from where, and to where.
pub(crate) fn jumps_back(code: &Code) -> Vec<(usize, u32)> {
    let mut jumps = Vec::new();
    for statement in 0..code.statement_count() {
        let targets = code.statement(statement).iter().flat_map(|inst| translate::targets(code, inst));
        jumps.extend(targets.filter(|&to| to as usize <= statement).map(|to| (statement, to)));
    }
    jumps
}

/// The statements to which a block jumps back.
pub(crate) fn loop_heads(code: &Code) -> BTreeSet<u32> {
    jumps_back(code).into_iter().map(|(_, to)| to).collect()
}

/// How many loops of a block contain the same statement at most.
fn nested_loops(code: &Code) -> usize {
    let mut last = BTreeMap::new();
    for (from, to) in jumps_back(code) {
        let last = last.entry(to as usize).or_insert(from);
        *last = from.max(*last);
    }
    let mut running: Vec<usize> = Vec::new();
    let mut most = 0;
    for (first, last) in last {
        running.retain(|&last| last >= first);
        running.push(last);
        most = most.max(running.len());
    }
    most
}

/// The blocks that a run may enter: organization blocks, and what they call.
fn entered(program: &Program) -> Vec<&CodeBlock> {
    let is_begun = |id: &&BlockId| id.kind == BlockKind::OrganizationBlock;
    let mut waiting: Vec<BlockId> = program.code.keys().filter(is_begun).copied().collect();
    let mut entered = BTreeMap::new();
    while let Some(id) = waiting.pop() {
        let Some(block) = program.code.get(&id) else { continue };
        if entered.insert(id, block).is_some() {
            continue;
        }
        for inst in &block.code.insts {
            match *inst {
                Inst::Call { callee: Callee::Block(id), .. } => waiting.push(id),
                // It may be any of its kind.
                Inst::Call { callee: Callee::Number(kind, _), .. } => {
                    waiting.extend(program.code.keys().filter(|id| id.kind == kind && !entered.contains_key(id)));
                }
                _ => {}
            }
        }
    }
    entered.into_values().collect()
}

/// Whether a block may read local data: its own, or those of a caller through a pointer.
fn reads_locals(code: &Code) -> bool {
    let is_local = |place: &Place| match place {
        Place::Fixed { area, .. } | Place::Indirect { area, .. } => *area == Area::Local,
        Place::Crossing { .. } => true,
    };
    code.insts.iter().any(|inst| match inst {
        Inst::Load { place, .. } => is_local(place),
        Inst::Move { .. } | Inst::Text { .. } | Inst::Intrinsic { .. } => true,
        _ => false,
    })
}

/// How many loads and stores of a block compute their address.
fn computed_accesses(code: &Code) -> usize {
    let computed = |place: &Place| usize::from(!matches!(place, Place::Fixed { .. }));
    let accesses = code.insts.iter().map(|inst| match inst {
        Inst::Load { place, .. } | Inst::Store { place, .. } => computed(place),
        Inst::Move { from, to, .. } => computed(from) + computed(to),
        _ => 0,
    });
    accesses.sum()
}

/// Checks the limits of machine code; the greatest number of parameters that a statement passes.
fn limits(program: &Program) -> Result<usize, String> {
    let statements: usize = program.code.values().map(|block| block.code.statement_count()).sum();
    if statements > STATEMENTS_MAX {
        return Err(format!("it has {statements} statements, and {STATEMENTS_MAX} is the most that become machine code"));
    }
    let mut most = 0;
    for (id, block) in &program.code {
        if block.code.insts.len() > BLOCK_INSTRUCTIONS_MAX {
            return Err(format!("{id} is too long for machine code"));
        }
        let loops = loop_heads(&block.code).len();
        if loops > LOOPS_MAX {
            return Err(format!("{id} jumps back to {loops} places, and {LOOPS_MAX} is the most that become machine code"));
        }
        for statement in 0..block.code.statement_count() {
            let insts = block.code.statement(statement);
            for (index, inst) in insts.iter().enumerate() {
                let before = passed(&insts[..index]);
                match inst {
                    Inst::PassParameter { .. } => most = most.max(before + 1),
                    Inst::Parameter { index, .. } => most = most.max(usize::from(*index) + 1),
                    Inst::Call { parameters, .. } if usize::from(*parameters) > before => {
                        return Err(format!("{id} calls with more parameters than it passes"));
                    }
                    _ => {}
                }
            }
        }
    }
    if most > PARAMETERS_MAX {
        return Err(format!("a block has {most} parameters, and {PARAMETERS_MAX} is the most that become machine code"));
    }
    Ok(most)
}
