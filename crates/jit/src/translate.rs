//! Writes the IR of a block as a function of Cranelift's IR.
//!
//! Registers of the CPU are variables while the block runs; they are stored where somebody else reads them: at calls, at the end
//! and where the Host is asked. A path on which something failed is cold code behind the function.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::mem::offset_of;

use cranelift_codegen::Context;
use cranelift_codegen::control::ControlPlane;
use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{self as clif, AbiParam, BlockArg, FuncRef, InstBuilder, MemFlagsData, Value};
use cranelift_codegen::isa::OwnedTargetIsa;
use cranelift_codegen::settings::{self, Configurable};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext, Variable};
use cranelift_jit::{ArenaMemoryProvider, JITBuilder, JITModule};
use cranelift_module::{FuncId, Linkage, Module, ModuleError, ModuleReloc};
use sieben_engine::Layout;
use sieben_engine::access::data_registers;
use sieben_engine::interpreter::weight;
use sieben_engine::ir::{DataRegister, Inst, Op, Place, Target, Var};
use sieben_engine::machine::{Register, Registers};
use sieben_model::address::Area;
use sieben_model::block::{BlockId, BlockKind};

use crate::ask::{GO_ON, LEAVE, Question};
use crate::entry::Generation;
use crate::jit::Native;
use crate::run::{LINKS, Run};

mod analysis;
mod bytes;
mod calls;
mod gates;
mod inline;
mod inlining;
mod inside;
mod instance;
mod instance_pointer;
mod intrinsics;
mod loops;
mod memory;
mod promote;
mod ranges;
mod sized;
mod value;
mod versions;
mod words;

use analysis::{SPARED, Summary, open_blocks, set_by_calls};
use bytes::Bytes;
use inlining::{Outer, Plan};
use instance::Instance;
use instance_pointer::InstancePointer;
use loops::Loop;
use promote::{Base, Promoted};
use ranges::Ranges;
use value::{Lazy, Val};
use versions::{Known, Versions};
use words::Words;

/// How a program is compiled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Options {
    /// Whether operations that have an inline form use it.
    pub(crate) inline: bool,
    /// Whether every status bit is calculated, also where no statement reads it, for those who look at the registers.
    pub(crate) exact: bool,
    /// Whether Cranelift optimizes: two to three times the time to compile, for code that is up to half as long.
    pub(crate) optimize: bool,
    /// Whether a data block that is not known beforehand may be protected when it is written.
    pub(crate) asks_before_writing: bool,
    /// Whether the code is kept as text, for people.
    pub(crate) lists: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { inline: true, exact: true, optimize: false, asks_before_writing: false, lists: false }
    }
}

/// Address space reserved for the code of a program, per IR instruction and at least.
/// It costs no memory until it is used; a call with exact status bits takes more than 1 KiB.
const RESERVED_BYTES_PER_INSTRUCTION: usize = 4096;
const RESERVED_BYTES_MIN: usize = 1 << 20;
/// What relative calls reach on every machine is more than the code of a program that becomes machine code takes.
const RESERVED_BYTES_MAX: usize = 1 << 30;

/// Native stack that a run may take; threads have 2 MiB and more.
const STACK_BYTES: usize = 1 << 20;
/// What an activation takes beside the frame of its function. The Rust code that enters interrupts comes on top, as often as machine
/// code nests them: see `INTERRUPTS`.
const STACK_BYTES_OF_A_CALL: usize = 1 << 10;
/// The instruction that makes room on the stack is among these bytes.
const PROLOGUE_BYTES: usize = 16;

/// Finds the index of a loaded block.
type Find<'a> = &'a dyn Fn(BlockId) -> Option<u32>;

/// The machine that code is for, with the given settings of Cranelift.
fn instruction_set(level: &str, algorithm: &str, machine: Machine) -> Result<OwnedTargetIsa, String> {
    let mut flags = settings::builder();
    let set = |flags: &mut settings::Builder, name: &str, value: &str| flags.set(name, value).map_err(|error| error.to_string());
    set(&mut flags, "opt_level", level)?;
    set(&mut flags, "regalloc_algorithm", algorithm)?;
    set(&mut flags, "use_colocated_libcalls", "false")?;
    set(&mut flags, "is_pic", "false")?;
    // Frames have a limit below, so that nobody has to look for the end of the stack.
    set(&mut flags, "enable_probestack", "false")?;
    let verified = cfg!(debug_assertions) || machine != Machine::This;
    set(&mut flags, "enable_verifier", if verified { "true" } else { "false" })?;
    // Nobody unwinds through machine code: what it calls never panics into it.
    set(&mut flags, "unwind_info", "false")?;
    let builder = match machine {
        Machine::This => cranelift_native::builder().map_err(|message| format!("this machine is not supported: {message}"))?,
        #[cfg(feature = "aarch64")]
        Machine::Aarch64 => {
            cranelift_codegen::isa::lookup_by_name("aarch64-unknown-linux-gnu").map_err(|error| format!("no aarch64: {error}"))?
        }
    };
    builder.finish(settings::Flags::new(flags)).map_err(|error| error.to_string())
}

/// The machine that code is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Machine {
    /// This one.
    This,
    /// Another one, whose code is checked and never runs.
    #[cfg(feature = "aarch64")]
    Aarch64,
}

/// The code of a program before it becomes executable.
struct Written {
    module: JITModule,
    /// The general version of each block, if somebody may enter it.
    blocks: Vec<Option<FuncId>>,
    bytes: usize,
    frame_max: usize,
    pinned: BTreeSet<u16>,
    /// Each block in Cranelift's IR and as instructions of the machine, if somebody wants to read it.
    listing: String,
}

/// Compiles all blocks, to be read and not to be run: as text.
pub(crate) fn listing(blocks: &[Native], find: Find<'_>, layout: &Layout, options: Options) -> Result<String, String> {
    Ok(write(blocks, find, layout, Options { lists: true, ..options }, Machine::This)?.listing)
}

/// Compiles all blocks. The code takes the data blocks with the returned numbers to be as they were loaded.
pub(crate) fn program(blocks: &[Native], find: Find<'_>, layout: &Layout, options: Options) -> Result<(Generation, BTreeSet<u16>), String> {
    let Written { mut module, blocks, bytes, frame_max, mut pinned, .. } = write(blocks, find, layout, options, Machine::This)?;
    module.finalize_definitions().map_err(|error| error.to_string())?;
    let levels = (STACK_BYTES / (frame_max + STACK_BYTES_OF_A_CALL)).min(LINKS);
    // Interrupts that come on top go to the interpreter.
    let needed = usize::from(layout.nesting_depth) + usize::from(layout.nesting_depth_error) + 2;
    if levels < needed {
        return Err(format!("its blocks need up to {frame_max} bytes of stack"));
    }
    pinned.remove(&0);
    Ok((Generation::new(module, &blocks, bytes, levels), pinned))
}

/// Compiles all blocks for aarch64 with Cranelift's checks, to see that it can be done; how many bytes of code there are.
#[cfg(feature = "aarch64")]
pub(crate) fn aarch64_bytes(blocks: &[Native], find: Find<'_>, layout: &Layout, options: Options) -> Result<usize, String> {
    Ok(write(blocks, find, layout, options, Machine::Aarch64)?.bytes)
}

/// Writes the code of all blocks for a machine.
fn write(blocks: &[Native], find: Find<'_>, layout: &Layout, options: Options, machine: Machine) -> Result<Written, String> {
    let isa = instruction_set("none", if options.optimize { "backtracking" } else { "single_pass" }, machine)?;
    // Cranelift's optimizations move calculations to where their results are used: good in a loop, bad in straight bit logic, where the
    // bytes that were read wait in registers until then.
    let for_loops = if options.optimize { Some(instruction_set("speed", "backtracking", machine)?) } else { None };
    let mut builder = JITBuilder::with_isa(isa, cranelift_module::default_libcall_names());
    let insts: usize = blocks.iter().map(|block| block.code.insts.len()).sum();
    let reserve = insts.saturating_mul(RESERVED_BYTES_PER_INSTRUCTION).clamp(RESERVED_BYTES_MIN, RESERVED_BYTES_MAX);
    builder.memory_provider(Box::new(ArenaMemoryProvider::new_with_size(reserve).map_err(|error| error.to_string())?));
    for &op in Op::ALL {
        builder.symbol(op.name(), op.shim());
    }
    for &question in Question::ALL {
        let ask = question.ask();
        builder.symbol(ask.name, ask.address);
    }
    let mut module = JITModule::new(builder);
    let functions = declare(&mut module).map_err(|error| error.to_string())?;
    let mut versions = Versions::new(&mut module, blocks, find, options.optimize).map_err(|error| error.to_string())?;
    let pointers = instance_pointer::follow(blocks, find);
    let summaries = analysis::summaries(blocks, find, options.exact);
    let plans = inlining::plan(blocks, find);
    let mut context = module.make_context();
    let mut frontend = FunctionBuilderContext::new();
    context.set_disasm(options.lists);
    let mut listing = String::new();
    let (mut bytes, mut frame_max) = (0, 0);
    let (mut pinned, mut asked) = (BTreeSet::new(), BTreeSet::new());
    while let Some((index, known, function)) = versions.next() {
        context.func.signature = block_signature(&module);
        let builder = FunctionBuilder::new(&mut context.func, &mut frontend);
        let target = module.target_config();
        let for_loops = for_loops.as_ref().filter(|_| plans[index].loops);
        let joins = for_loops.is_none();
        let program = Program {
            functions: &functions,
            blocks,
            summaries: &summaries,
            plans: &plans,
            pointers: &pointers,
            find,
            layout,
            options,
            joins,
        };
        let mut found = Translator::new(builder, &mut module, &mut versions, program, index).run(known, target);
        pinned.append(&mut found.pinned);
        asked.append(&mut found.asked);
        if options.lists {
            listing += &format!("{}\n{}\n{}\n", blocks[index].id, blocks[index].code, context.func.display());
        }
        define(&mut module, function, &mut context, for_loops).map_err(|error| format!("{}: {error}", blocks[index].id))?;
        listing += context.compiled_code().and_then(|code| code.vcode.as_deref()).unwrap_or_default();
        let code = context.compiled_code().map_or(&[][..], |code| code.code_buffer());
        bytes += code.len();
        frame_max = frame_max.max(frame_bytes(code));
        module.clear_context(&mut context);
    }
    bytes += gates::define(&mut module, &functions, &asked, &mut context, &mut frontend).map_err(|error| error.to_string())?;
    let blocks = (0..blocks.len()).map(|index| versions.general(index)).collect();
    Ok(Written { module, blocks, bytes, frame_max, pinned, listing })
}

/// Compiles a function, for the instruction set of the module or another one.
fn define(module: &mut JITModule, id: FuncId, context: &mut Context, other: Option<&OwnedTargetIsa>) -> Result<(), Box<ModuleError>> {
    let Some(isa) = other else { return Ok(module.define_function(id, context)?) };
    let code = context.compile(&**isa, &mut ControlPlane::default()).map_err(|error| Box::new(ModuleError::from(error)))?;
    let alignment = u64::from(code.buffer.alignment).max(u64::from(isa.function_alignment().minimum)).max(isa.symbol_alignment());
    let bytes = code.code_buffer().to_vec();
    let relocations: Vec<_> =
        code.buffer.relocs().to_vec().iter().map(|relocation| ModuleReloc::from_mach_reloc(relocation, &context.func, id)).collect();
    Ok(module.define_function_bytes(id, alignment, &bytes, &relocations)?)
}

/// Bytes of the native stack that a function takes, without what a call takes anyway: read from its first instructions.
fn frame_bytes(code: &[u8]) -> usize {
    if !cfg!(target_arch = "x86_64") {
        // Every value may have its place: at most one for each instruction.
        return 2 * code.len();
    }
    let beginning = &code[..code.len().min(PROLOGUE_BYTES)];
    let short = beginning.windows(4).find_map(|bytes| match bytes {
        [0x48, 0x83, 0xEC, size] => Some(usize::from(*size)),
        _ => None,
    });
    let long = beginning.windows(7).find_map(|bytes| match *bytes {
        [0x48, 0x81, 0xEC, a, b, c, d] => Some(u32::from_le_bytes([a, b, c, d]) as usize),
        _ => None,
    });
    long.or(short).unwrap_or(0)
}

/// All functions that code refers to, beside those of blocks.
struct Functions {
    ops: HashMap<Op, FuncId>,
    questions: HashMap<Question, FuncId>,
    /// The same for cold code: see `gates`.
    gates: HashMap<Question, FuncId>,
}

fn block_signature(module: &JITModule) -> clif::Signature {
    words_signature(module, 4)
}

fn words_signature(module: &JITModule, arguments: usize) -> clif::Signature {
    let mut signature = module.make_signature();
    signature.params = vec![AbiParam::new(I64); arguments];
    signature.returns.push(AbiParam::new(I64));
    signature
}

fn declare(module: &mut JITModule) -> Result<Functions, Box<ModuleError>> {
    let mut ops = HashMap::new();
    for &op in Op::ALL {
        let signature = words_signature(module, op.arity());
        ops.insert(op, module.declare_function(op.name(), Linkage::Import, &signature)?);
    }
    let mut questions = HashMap::new();
    for &question in Question::ALL {
        let ask = question.ask();
        let signature = words_signature(module, ask.arguments);
        questions.insert(question, module.declare_function(ask.name, Linkage::Import, &signature)?);
    }
    let gates = gates::declare(module)?;
    Ok(Functions { ops, questions, gates })
}

/// Whether a register holds one bit.
fn is_bit(register: Register) -> bool {
    use Register as R;
    matches!(register, R::Fc | R::Rlo | R::Sta | R::Or | R::Os | R::Ov | R::Cc0 | R::Cc1 | R::Br | R::Ma)
}

const fn bit_of(register: Register) -> u32 {
    1 << register as u32
}

/// The data block registers, which a call restores, and which access reads from memory.
const OPEN_BLOCKS: [Register; 6] =
    [Register::DbNumber, Register::DbBase, Register::DbLength, Register::DiNumber, Register::DiBase, Register::DiLength];
/// What a call sets, at the beginning of the callee and behind it.
const AFTER_CALL: [(Register, u64); 4] = [(Register::Os, 0), (Register::Or, 0), (Register::Sta, 1), (Register::Fc, 0)];

/// Whether an access may go to an open data block.
fn may_be_in_data_block(place: Place) -> bool {
    match place {
        Place::Fixed { area, .. } | Place::Indirect { area, .. } => matches!(area, Area::SharedData | Area::InstanceData),
        Place::Crossing { .. } => true,
    }
}

/// What a called block finds.
const AT_CALL: &[(Register, u64)] =
    &[(Register::Os, 0), (Register::Or, 0), (Register::Sta, 1), (Register::Fc, 0), (Register::Ma, 0), (Register::Nesting, 0)];

/// What is known where control flow arrives at a statement.
struct Arrival {
    block: clif::Block,
    /// Where the ways from behind it arrive, if it is the head of a loop: `block` is in front of the loop then.
    again: Option<clif::Block>,
    /// Some way here comes from behind it.
    backward: bool,
    /// Registers whose memory may be older than their variable.
    dirty: u32,
    /// Registers that hold a constant on every way here; `None` until one is known.
    known: Option<[Option<u64>; Register::COUNT]>,
}

/// Where a path goes on after the Host answered.
#[derive(Clone, Copy)]
enum After {
    /// At the next statement.
    NextStatement,
    /// At this block, with `run.value` as its argument.
    Deliver(clif::Block),
    /// Nowhere: the Host ends the run.
    Never,
}

/// What is compiled.
#[derive(Clone, Copy)]
struct Program<'a> {
    functions: &'a Functions,
    blocks: &'a [Native],
    summaries: &'a [Summary],
    plans: &'a [Plan],
    pointers: &'a [InstancePointer],
    find: Find<'a>,
    layout: &'a Layout,
    options: Options,
    /// Whether bits of one byte are written with one store.
    joins: bool,
}

/// What a function relies on.
struct Found {
    /// Data blocks that it takes to be as they were loaded.
    pinned: BTreeSet<u16>,
    /// What it asks in cold code.
    asked: BTreeSet<Question>,
}

struct Translator<'a> {
    b: FunctionBuilder<'a>,
    module: &'a mut JITModule,
    functions: &'a Functions,
    blocks: &'a [Native],
    summaries: &'a [Summary],
    plans: &'a [Plan],
    pointers: &'a [InstancePointer],
    versions: &'a mut Versions,
    index: usize,
    find: Find<'a>,
    layout: &'a Layout,
    options: Options,
    /// Data blocks that the code takes to be as they were loaded.
    pinned: BTreeSet<u16>,
    /// What is asked in cold code.
    asked: BTreeSet<Question>,
    lazies: Vec<Lazy>,
    /// The cold block that is being written, if it is one.
    cold: Option<clif::Block>,
    references: HashMap<FuncId, FuncRef>,
    variables: Vec<Variable>,
    /// Values of registers in the running piece of code; `None` = in the variable.
    current: [Option<Val>; Register::COUNT],
    /// Registers whose value here is newer than the variable.
    changed: u32,
    /// Registers whose memory may be older than their value.
    dirty: u32,
    temporaries: Vec<Option<Val>>,
    /// What is known of memory in the running piece of code.
    bytes: Bytes,
    words: Words,
    loops: Vec<Loop>,
    /// Memory for which registers stand, in the loops met so far.
    promoted: Vec<Promoted>,
    /// What is known of the values of the present block.
    ranges: Ranges,
    /// Ranges of values in the running statement.
    bounds: HashMap<Value, (u32, u32)>,
    /// Values in the running statement that the smallest loop around it does not change.
    fixed: HashSet<Value>,
    /// What loops write, by their block and first statement.
    writes: HashMap<(usize, u32), BTreeSet<(Base, i32)>>,
    /// Blocks in which memory is compared with what the code relies on, by the block in front of which they stand.
    verifying: HashMap<clif::Block, clif::Block>,
    /// Those that are still to be written, and for which statement.
    verify_later: Vec<(clif::Block, u32, clif::Block)>,
    /// Values whose bits above so many are 0.
    narrow: HashMap<Value, u32>,
    /// All registers that the block may change.
    written: u32,
    /// What AR2 held when the present block was entered.
    instance: Val,
    /// Where the instance of the present block lies, if it is inside its data block whatever AR2 holds.
    in_range: Option<Instance>,
    arrivals: HashMap<u32, Arrival>,
    statement: u32,
    /// Parameters passed and not yet taken.
    passed: Vec<Val>,
    /// Parameters that the caller of an inlined block passed.
    given: Vec<Val>,
    /// Blocks in which the present one is inlined, outermost first; that one alone has a function, and the link and local data below.
    outer: Vec<Outer>,
    /// Where the local data of the present block begin behind those of the outermost one, in bytes.
    local_offset: i32,
    /// Where the parameters of the present block end behind those of the outermost one, as their number.
    parameters_end: usize,
    /// IR instructions of inlined blocks so far.
    grown: usize,
    /// Safe points on ways back that are still to be written: the block, the statement, where it begins.
    ways: Vec<(clif::Block, u32, clif::Block)>,
    /// The running statement has not begun yet.
    arriving: bool,
    /// Nothing that follows is reached.
    ended: bool,
    leave: clif::Block,
    run: Value,
    arena: Value,
    local: Value,
    link: Value,
}

const TRUSTED: MemFlagsData = MemFlagsData::trusted();

fn register_offset(register: Register) -> i32 {
    (offset_of!(Run<'_, '_>, registers) + register.offset()) as i32
}

impl<'a> Translator<'a> {
    fn new(mut b: FunctionBuilder<'a>, module: &'a mut JITModule, versions: &'a mut Versions, program: Program<'a>, index: usize) -> Self {
        let Program { functions, blocks, summaries, plans, pointers, find, layout, options, joins } = program;
        let entry = b.create_block();
        b.append_block_params_for_function_params(entry);
        b.switch_to_block(entry);
        b.seal_block(entry);
        let &[run, arena, local, link] = b.block_params(entry) else { unreachable!("a block's function takes four arguments") };
        let variables = Register::ALL.iter().map(|&register| b.declare_var(if is_bit(register) { I32 } else { I64 })).collect();
        let leave = b.create_block();
        b.set_cold_block(leave);
        Self {
            b,
            module,
            functions,
            blocks,
            summaries,
            plans,
            pointers,
            versions,
            index,
            find,
            layout,
            options,
            pinned: BTreeSet::new(),
            asked: BTreeSet::new(),
            lazies: Vec::new(),
            cold: None,
            references: HashMap::new(),
            variables,
            current: [None; Register::COUNT],
            changed: 0,
            dirty: 0,
            temporaries: Vec::new(),
            bytes: Bytes::new(joins),
            words: Words::default(),
            loops: loops::find(&blocks[index].code),
            promoted: Vec::new(),
            ranges: Ranges::default(),
            bounds: HashMap::new(),
            fixed: HashSet::new(),
            writes: HashMap::new(),
            verifying: HashMap::new(),
            verify_later: Vec::new(),
            narrow: HashMap::new(),
            written: 0,
            instance: Val::Const(0),
            in_range: None,
            arrivals: HashMap::new(),
            statement: 0,
            passed: Vec::new(),
            given: Vec::new(),
            outer: Vec::new(),
            local_offset: 0,
            parameters_end: 0,
            grown: 0,
            ways: Vec::new(),
            arriving: false,
            ended: false,
            leave,
            run,
            arena,
            local,
            link,
        }
    }

    /// Whether the block is entered by calls and nothing else.
    fn called_only(&self) -> bool {
        self.native().id.kind != BlockKind::OrganizationBlock
    }

    fn native(&self) -> &'a Native {
        &self.blocks[self.index]
    }

    /// Writes the function.
    fn run(mut self, known: Known, target: cranelift_codegen::isa::TargetFrontendConfig) -> Found {
        self.find_registers_and_loops(known);
        self.ranges = self.find_ranges();
        self.keep_budget();
        self.enter_block();
        self.look_for_room();
        self.statements();
        debug_assert!(self.ended, "a block ends with a return");
        self.b.switch_to_block(self.leave);
        let leave = self.b.ins().iconst(I64, LEAVE as i64);
        self.b.ins().return_(&[leave]);
        self.b.seal_all_blocks();
        self.b.finalize(target);
        Found { pinned: self.pinned, asked: self.asked }
    }

    /// Writes the statements of the present block.
    fn statements(&mut self) {
        let code = &self.native().code;
        for statement in 0..code.statement_count() {
            if !self.ended {
                self.leave_loops(statement as u32);
            }
            self.statement = statement as u32;
            self.arrive();
            if self.ended {
                continue;
            }
            self.temporaries.clear();
            self.bounds.clear();
            self.fixed.clear();
            self.passed.clear();
            let first = code.statements[statement];
            for (index, inst) in (first..).zip(code.statement(statement)) {
                self.inst(index, inst);
                if self.ended {
                    break;
                }
            }
        }
    }

    /// Which registers the block mentions, and where it jumps back to.
    fn find_registers_and_loops(&mut self, known: Known) {
        let code = &self.native().code;
        let mut mentioned = 0;
        let mut back = Vec::new();
        for statement in 0..code.statement_count() {
            for inst in code.statement(statement) {
                back.extend(loops::targets(code, inst).filter(|&to| to as usize <= statement));
                if let Inst::Load { place, .. } | Inst::Store { place, .. } = *inst
                    && may_be_in_data_block(place)
                {
                    mentioned |= open_blocks();
                }
                let register = |var: Var| var.register().map_or(0, bit_of);
                let written = loops::written(inst);
                let written = if matches!(inst, Inst::Call { .. }) { analysis::ALL } else { written };
                self.written |= written;
                mentioned |= written | sieben_engine::ir::verify::reads(inst).into_iter().map(register).fold(0, |all, bit| all | bit);
            }
        }
        for to in back {
            self.expect_way_back(to);
        }
        if self.called_only() {
            // What is known there is not in memory.
            self.written |= AT_CALL.iter().fold(known.registers(), |all, &(register, _)| all | bit_of(register));
        }
        let at_call = if self.called_only() { AT_CALL } else { &[] };
        let mut known: Vec<(Register, u64)> = at_call.iter().copied().chain(known.iter()).collect();
        // An organization block begins with fresh registers, which are in memory.
        let begins = !self.called_only() && !self.options.exact;
        if begins {
            known = Register::ALL.iter().copied().zip(Registers::fresh().to_words()).collect();
        }
        for &register in Register::ALL {
            if let Some(&(_, value)) = known.iter().find(|&&(known, _)| known == register) {
                let ty = if is_bit(register) { I32 } else { I64 };
                let constant = self.b.ins().iconst(ty, value as i64);
                self.b.def_var(self.variables[register as usize], constant);
                self.current[register as usize] = Some(Val::Const(value));
                if !begins {
                    self.dirty |= bit_of(register);
                }
            } else if mentioned & bit_of(register) != 0 {
                let ty = if is_bit(register) { I32 } else { I64 };
                let value = self.b.ins().load(ty, TRUSTED, self.run, register_offset(register));
                self.b.def_var(self.variables[register as usize], value);
            }
        }
        self.instance = self.register(Register::Ar2);
    }

    /// Notes that a later statement jumps back to one.
    fn expect_way_back(&mut self, to: u32) {
        let again = self.loops.iter().any(|it| it.first == to).then(|| self.b.create_block());
        let arrival = self.arrival(to);
        arrival.backward = true;
        arrival.again = arrival.again.or(again);
    }

    fn arrival(&mut self, statement: u32) -> &mut Arrival {
        let b = &mut self.b;
        self.arrivals.entry(statement).or_insert_with(|| Arrival {
            block: b.create_block(),
            again: None,
            backward: false,
            dirty: 0,
            known: None,
        })
    }

    /// The safe point at the beginning of a block.
    fn enter_block(&mut self) {
        let weight = weight(self.native().code.statement_count());
        let go_on = self.b.create_block();
        self.count_down(weight, 0, go_on);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
    }

    /// Takes the weight of a safe point from the budget, asks the Host if it is used up, and goes on at `go_on`.
    fn count_down(&mut self, weight: u16, statement: u32, go_on: clif::Block) {
        let variable = self.budget();
        let budget = self.b.use_var(variable);
        let left = self.b.ins().iadd_imm_s(budget, -i64::from(weight));
        self.b.def_var(variable, left);
        let used_up = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, left, 0);
        let ask = self.cold_block();
        self.b.ins().brif(used_up, ask, &[], go_on, &[]);
        self.b.switch_to_block(ask);
        self.b.seal_block(ask);
        let before = self.cold.replace(ask);
        self.spill(self.dirty);
        let code = self.b.ins().iconst(I64, self.index as i64);
        let statement_of_head = statement;
        // The interpreter names the first statement that does something.
        let statement = self.first_with_code(statement);
        let statement = self.b.ins().iconst(I64, i64::from(statement));
        let answer = self.ask(Question::SafePoint, &[self.link, code, statement]);
        self.cold = before;
        let go_on = self.verified(statement_of_head, go_on);
        self.b.ins().brif(answer, self.leave, &[], go_on, &[]);
        self.write_verifications();
    }

    fn first_with_code(&self, statement: u32) -> u32 {
        let code = &self.native().code;
        (statement as usize..code.statement_count()).find(|&index| !code.statement(index).is_empty()).unwrap_or(0) as u32
    }

    /// A block for what happens seldom. Memory is as the program left it there.
    fn cold_block(&mut self) -> clif::Block {
        self.settle_bytes();
        let block = self.b.create_block();
        self.b.set_cold_block(block);
        block
    }

    /// Begins a piece of code at a statement, if something arrives there.
    fn arrive(&mut self) {
        if !self.arrivals.contains_key(&self.statement) {
            return;
        }
        if !self.ended {
            self.arriving = true;
            let block = self.edge(self.statement);
            self.arriving = false;
            self.b.ins().jump(block, &[]);
        }
        let statement = self.statement;
        let arrival = self.arrival(statement);
        let (block, known, dirty, again) = (arrival.block, arrival.known.unwrap_or_default(), arrival.dirty, arrival.again);
        self.b.switch_to_block(block);
        self.words.forget_all();
        self.changed = 0;
        self.current = known.map(|value| value.map(Val::Const));
        self.dirty = dirty;
        self.ended = false;
        if !self.arrivals[&statement].backward {
            self.know_instance_again();
            self.b.seal_block(block);
            return;
        }
        // A register that nothing in the loop changes is what it was in front of it.
        let inside = |it: &&Loop| it.contains(statement);
        let smallest = self.loops.iter().filter(inside).min_by_key(|it| it.last - it.first).cloned();
        let written = smallest.as_ref().map_or(self.written, |it| it.written);
        for &register in Register::ALL {
            if written & bit_of(register) != 0 {
                self.current[register as usize] = None;
            }
        }
        self.know_instance_again();
        // What is entered in the middle may be reached by a way on which less was stored.
        let changed = if again.is_some() { written & self.written } else { self.written };
        self.dirty |= changed & !self.dead_at(statement);
        if let Some(head) = again {
            self.b.seal_block(block);
            if let Some(it) = smallest {
                self.promote(&it);
            }
            self.b.ins().jump(head, &[]);
            self.b.switch_to_block(head);
        }
    }

    /// Makes the variables current and returns where the statement begins; the caller jumps there.
    fn edge(&mut self, statement: u32) -> clif::Block {
        self.settle_bytes();
        let dead = self.dead_at(statement);
        self.define_variables(!dead);
        let known = self.current.map(|value| match value {
            Some(Val::Const(value)) => Some(value),
            _ => None,
        });
        let dirty = self.dirty & !dead;
        let from_behind = statement <= self.statement && !self.arriving;
        let arrival = self.arrival(statement);
        if let (true, Some(head)) = (from_behind, arrival.again) {
            return head;
        }
        arrival.dirty |= dirty;
        arrival.known = Some(match arrival.known {
            None => known,
            Some(mut before) => {
                before.iter_mut().zip(known).for_each(|(before, now)| {
                    if *before != now {
                        *before = None;
                    }
                });
                before
            }
        });
        arrival.block
    }

    /// Status bits that nobody needs from a statement on.
    fn dead_at(&self, statement: u32) -> u32 {
        let live = &self.summaries[self.index].live;
        SPARED & !live.get(statement as usize).copied().unwrap_or(SPARED)
    }

    fn define_variables(&mut self, wanted: u32) {
        for &register in Register::ALL {
            if self.changed & wanted & bit_of(register) != 0
                && let Some(value) = self.current[register as usize]
            {
                let value = if is_bit(register) { self.flag(value) } else { self.word(value) };
                self.b.def_var(self.variables[register as usize], value);
            }
        }
        self.changed &= !wanted;
    }

    /// Stores registers where others read them.
    fn spill(&mut self, registers: u32) {
        for &register in Register::ALL {
            if registers & bit_of(register) != 0 {
                let value = self.register(register);
                let value = self.word(value);
                self.b.ins().store(TRUSTED, value, self.run, register_offset(register));
            }
        }
    }

    fn register(&mut self, register: Register) -> Val {
        if let Some(value) = self.current[register as usize] {
            return value;
        }
        let value = self.b.use_var(self.variables[register as usize]);
        if is_bit(register) { Val::Bit { value, clean: true } } else { Val::Word(value) }
    }

    fn get(&mut self, var: Var) -> Val {
        match var.register() {
            Some(register) => self.register(register),
            None => self.temporaries.get(usize::from(var.0) - Register::COUNT).copied().flatten().unwrap_or(Val::Const(0)),
        }
    }

    fn set(&mut self, var: Var, value: Val) {
        match var.register() {
            Some(register) => self.set_register(register, value),
            None => {
                let index = usize::from(var.0) - Register::COUNT;
                if self.temporaries.len() <= index {
                    self.temporaries.resize(index + 1, None);
                }
                self.temporaries[index] = Some(value);
            }
        }
    }

    /// AR2 at a statement where ways meet, if it is there what it was at the beginning of the block.
    fn know_instance_again(&mut self) {
        let Some(added) = self.pointers[self.index].at(self.statement) else { return };
        if added == 0 || self.instance.constant().is_some() {
            self.current[Register::Ar2 as usize] = Some(self.instance_and(added));
        }
    }

    /// So much more than AR2 held when the present block was entered.
    fn instance_and(&mut self, added: u32) -> Val {
        match self.instance {
            Val::Const(pointer) => Val::Const(u64::from((pointer as u32).wrapping_add(added))),
            pointer if added == 0 => pointer,
            pointer => {
                let pointer = self.int(pointer);
                Val::Int(self.b.ins().iadd_imm_u(pointer, i64::from(added)))
            }
        }
    }

    /// What is known of AR2 behind an instruction that wrote it.
    pub(super) fn know_instance_behind(&mut self, inst: u32) {
        if let Some(added) = self.pointers[self.index].after(inst) {
            let pointer = self.instance_and(added);
            self.set_register(Register::Ar2, pointer);
        }
    }

    fn set_register(&mut self, register: Register, value: Val) {
        self.current[register as usize] = Some(value);
        self.changed |= bit_of(register);
        self.dirty |= bit_of(register);
    }

    /// Calls a function; its result.
    fn call(&mut self, function: FuncId, arguments: &[Value]) -> Value {
        let reference = self.reference(function);
        let call = self.b.ins().call(reference, arguments);
        self.b.inst_results(call)[0]
    }

    fn reference(&mut self, function: FuncId) -> FuncRef {
        let (module, b) = (&mut *self.module, &mut self.b);
        *self.references.entry(function).or_insert_with(|| module.declare_func_in_func(function, b.func))
    }

    fn ask(&mut self, question: Question, arguments: &[Value]) -> Value {
        self.settle_bytes();
        self.store_promoted();
        let mut arguments: Vec<Value> = [self.run].iter().chain(arguments).copied().collect();
        // In an inlined block the link is another one.
        if let Some(link) = arguments.iter().position(|&argument| argument == self.link) {
            arguments[link] = self.shown_link();
        }
        let answer = match self.cold {
            Some(_) => self.ask_at_gate(question, &arguments),
            None => self.call(self.functions.questions[&question], &arguments),
        };
        self.take_promoted();
        answer
    }

    fn site(&mut self, inst: u32) -> Value {
        self.b.ins().iconst(I64, ((self.index as i64) << 32) | i64::from(inst))
    }

    fn load_run(&mut self, offset: usize) -> Value {
        self.b.ins().load(I64, TRUSTED, self.run, offset as i32)
    }

    fn result(&mut self) -> Value {
        self.load_run(offset_of!(Run<'_, '_>, value))
    }

    /// Goes on in cold code if the answer is not 0: asks the Host, who decides how the run goes on.
    fn unless_failed(&mut self, failed: Value, question: Question, arguments: &[Value], after: After) {
        let cold = self.cold_block();
        let go_on = self.b.create_block();
        self.b.ins().brif(failed, cold, &[], go_on, &[]);
        self.cold_path(cold, question, arguments, after);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
    }

    /// Fills a cold block: registers stored, the Host asked.
    fn cold_path(&mut self, cold: clif::Block, question: Question, arguments: &[Value], after: After) {
        self.b.switch_to_block(cold);
        self.b.seal_block(cold);
        let before = self.cold.replace(cold);
        self.spill(self.dirty);
        let answer = self.ask(question, arguments);
        match after {
            After::Never => {
                self.b.ins().jump(self.leave, &[]);
            }
            After::Deliver(block) => {
                let value = self.result();
                let param = self.b.block_params(block)[0];
                let value = if self.b.func.dfg.value_type(param) == I32 { self.b.ins().ireduce(I32, value) } else { value };
                self.b.ins().brif(answer, self.leave, &[], block, &[BlockArg::Value(value)]);
            }
            After::NextStatement => {
                let changed = self.changed;
                self.leave_loops(self.statement + 1);
                let next = self.edge(self.statement + 1);
                let next = self.verified(self.statement + 1, next);
                self.b.ins().brif(answer, self.leave, &[], next, &[]);
                self.write_verifications();
                self.changed = changed;
            }
        }
        self.cold = before;
    }

    fn inst(&mut self, index: u32, inst: &Inst) {
        self.write_inst(index, inst);
        self.forget_words_behind(inst);
        if sieben_engine::ir::verify::writes(inst) == Some(Register::Ar2.into()) {
            self.know_instance_behind(index);
        }
    }

    fn write_inst(&mut self, index: u32, inst: &Inst) {
        if !matches!(inst, Inst::Constant { .. } | Inst::Compute { .. } | Inst::Load { .. } | Inst::Store { .. }) {
            // What follows may have ways of its own, on which nothing may wait.
            self.settle_bytes();
        }
        match *inst {
            Inst::Constant { dst, value } => self.set(dst, Val::Const(value)),
            Inst::Compute { dst, .. }
                if let Some((least, most)) = self.ranges.result(index)
                    && least == most =>
            {
                self.set(dst, Val::Const(u64::from(least)));
            }
            Inst::Compute { op, dst, args } => {
                let result = self.compute(op, dst, args);
                self.note_range(index, result);
                self.set(dst, result);
            }
            Inst::Load { dst, .. } if self.pointers[self.index].loaded(index).is_some() => {
                let added = self.pointers[self.index].loaded(index).unwrap_or_default();
                let pointer = self.instance_and(added);
                self.set(dst, pointer);
            }
            Inst::Load { .. } | Inst::Store { .. } if self.access_instance(inst) => {}
            Inst::Load { dst, place, width, on_fault } => self.load(index, dst, place, width, on_fault),
            Inst::Store { place, width, src } => self.store(index, place, width, src),
            Inst::Move { from, to, bytes } if self.move_inside(index, (from, to, bytes)) => {}
            Inst::Move { from, to, .. } => {
                let pointers = [self.pointer(from), self.pointer(to)];
                self.store_open_blocks();
                let site = self.site(index);
                let failed = self.ask(Question::TryMove, &[self.link, site, pointers[0], pointers[1]]);
                self.unless_failed(failed, Question::Failed, &[self.link, site], After::NextStatement);
            }
            Inst::Text { dst, from, to, .. } => {
                let pointers = [self.pointer(from), self.pointer(to)];
                self.store_open_blocks();
                let site = self.site(index);
                let failed = self.ask(Question::TryText, &[self.link, site, pointers[0], pointers[1]]);
                self.unless_failed(failed, Question::Failed, &[self.link, site], After::NextStatement);
                let result = self.result();
                self.set(dst, Val::Word(result));
            }
            Inst::Parameter { dst, index } => self.parameter(dst, index),
            Inst::PassParameter { src } => self.pass_parameter(src),
            Inst::Intrinsic { dst, intrinsic, args } => self.intrinsic(index, dst, intrinsic, args),
            Inst::Require { .. } if self.ranges.is_met(index) => {}
            Inst::Require { condition, register, .. } => self.require(index, condition, Some(register), After::NextStatement),
            Inst::RequireStack { condition, .. } => self.require(index, condition, None, After::Never),
            Inst::Open { register, number } => {
                let number = self.get(number);
                if let Val::Const(number) = number
                    && self.open_known(register, number & 0xFFFF)
                {
                    return;
                }
                let number = self.word(number);
                self.store_open_blocks();
                let site = self.site(index);
                let failed = self.ask(Question::TryOpen, &[site, number]);
                self.unless_failed(failed, Question::Failed, &[self.link, site], After::NextStatement);
                for register in OPEN_BLOCKS {
                    self.reload(register);
                }
            }
            Inst::Jump { to } => {
                let block = self.way_to(to);
                self.b.ins().jump(block, &[]);
                self.fill_ways();
                self.ended = true;
            }
            Inst::Branch { condition, to } => {
                let condition = self.get(condition);
                let condition = self.force(condition);
                if let Val::Const(value) = condition {
                    if value & 1 != 0 {
                        self.inst(index, &Inst::Jump { to });
                    }
                    return;
                }
                let condition = self.flag(condition);
                let block = self.way_to(to);
                let go_on = self.b.create_block();
                self.b.ins().brif(condition, block, &[], go_on, &[]);
                self.fill_ways();
                self.b.switch_to_block(go_on);
                self.b.seal_block(go_on);
            }
            Inst::JumpTable { index, first, count, otherwise } => self.jump_table(index, first, count, otherwise),
            Inst::Call { callee, parameters } => self.call_block(index, callee, parameters),
            // Goes on in the caller.
            Inst::Return if !self.outer.is_empty() => {}
            Inst::Return => {
                self.settle_bytes();
                self.store_promoted();
                let set_by_calls = if self.called_only() { set_by_calls() } else { 0 };
                let nobody_needs = SPARED & !self.summaries[self.index].live_out;
                self.spill(self.dirty & !set_by_calls & !nobody_needs);
                let go_on = self.b.ins().iconst(I64, GO_ON as i64);
                self.b.ins().return_(&[go_on]);
                self.ended = true;
            }
        }
    }

    fn compute(&mut self, op: Op, dst: Var, args: [Var; 4]) -> Val {
        let args = args.map(|arg| self.get(arg));
        let used = &args[..op.arity()];
        if op == Op::Copy {
            return args[0];
        }
        // Most status bits are never read; an operation with a constant is often no operation.
        let spared = dst.register().is_some_and(|register| SPARED & bit_of(register) != 0);
        if spared && self.options.inline && used.iter().all(|arg| arg.constant().is_none()) {
            return self.later(op, args);
        }
        self.compute_now(op, used)
    }

    fn compute_now(&mut self, op: Op, args: &[Val]) -> Val {
        if let Some(constants) = args.iter().map(|arg| arg.constant()).collect::<Option<Vec<u64>>>() {
            let mut words = [0; 4];
            words[..constants.len()].copy_from_slice(&constants);
            return Val::Const(op.eval(words));
        }
        if self.options.inline
            && let Some(value) = self.inline(op, args)
        {
            return value;
        }
        let args: Vec<Value> = args.iter().map(|&arg| self.word(arg)).collect();
        Val::Word(self.call(self.functions.ops[&op], &args))
    }

    /// Takes a register from memory, where Rust code changed it.
    fn reload(&mut self, register: Register) {
        let value = if is_bit(register) {
            Val::Bit { value: self.b.ins().load(I32, TRUSTED, self.run, register_offset(register)), clean: true }
        } else {
            Val::Word(self.b.ins().load(I64, TRUSTED, self.run, register_offset(register)))
        };
        self.set_register(register, value);
        self.dirty &= !bit_of(register);
    }

    /// Opens a data block that the program has; whether that is known beforehand. The run makes sure that it is there.
    fn open_known(&mut self, register: DataRegister, number: u64) -> bool {
        let range = match number {
            0 => 0..0,
            _ => match u16::try_from(number).ok().and_then(|number| self.layout.data_blocks.get(&number)) {
                Some(range) => range.clone(),
                None => return false,
            },
        };
        let values = [number, range.start as u64, range.len() as u64];
        for (register, value) in data_registers(register).into_iter().zip(values) {
            self.set_register(register, Val::Const(value));
        }
        self.pinned.insert(number as u16);
        true
    }

    fn require(&mut self, index: u32, condition: Var, register: Option<Var>, after: After) {
        let condition = self.get(condition);
        if condition.constant().is_some_and(|value| value & 1 != 0) {
            return;
        }
        let condition = self.flag(condition);
        let unmet = self.b.ins().bxor_imm_u(condition, 1);
        let site = self.site(index);
        let register = register.map_or(Val::Const(0), |register| self.get(register));
        let register = self.word(register);
        self.unless_failed(unmet, Question::Unmet, &[self.link, site, register], after);
    }

    /// Where a jump goes: the statement itself, or the safe point in front of it if it lies behind.
    fn way_to(&mut self, Target(to): Target) -> clif::Block {
        let arrival = self.edge(to);
        if to > self.statement && !self.leaves_loop(to) {
            return arrival;
        }
        let way = self.b.create_block();
        self.ways.push((way, to, arrival));
        way
    }

    /// Fills the safe points on the ways back, after the jump that goes there.
    fn fill_ways(&mut self) {
        for (way, to, arrival) in std::mem::take(&mut self.ways) {
            self.b.switch_to_block(way);
            self.b.seal_block(way);
            self.leave_loops(to);
            if to > self.statement {
                self.b.ins().jump(arrival, &[]);
                continue;
            }
            let weight = weight((self.statement - to) as usize);
            // Who is asked there finds what the loops around both keep.
            let from = std::mem::replace(&mut self.statement, to);
            self.count_down(weight, to, arrival);
            self.statement = from;
        }
    }

    fn jump_table(&mut self, index: Var, first: u32, count: u32, otherwise: Target) {
        let index = self.get(index);
        let index = self.word(index);
        let targets = &self.native().code.tables[first as usize..(first + count) as usize];
        let mut blocks: HashMap<u32, clif::Block> = HashMap::new();
        let mut block_of = |this: &mut Self, target: Target| {
            if let Some(&block) = blocks.get(&target.0) {
                return block;
            }
            let block = this.way_to(target);
            blocks.insert(target.0, block);
            block
        };
        let otherwise = block_of(self, otherwise);
        let entries: Vec<clif::Block> = targets.iter().map(|&target| block_of(self, target)).collect();
        let inside = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, index, i64::from(count));
        let beyond = self.b.ins().iconst(I64, i64::from(count));
        let index = self.b.ins().select(inside, index, beyond);
        let index = self.b.ins().ireduce(I32, index);
        let default = self.b.func.dfg.block_call(otherwise, &[]);
        let entries: Vec<_> = entries.into_iter().map(|block| self.b.func.dfg.block_call(block, &[])).collect();
        let table = self.b.create_jump_table(clif::JumpTableData::new(default, &entries));
        self.b.ins().br_table(index, table);
        self.fill_ways();
        self.ended = true;
    }
}
