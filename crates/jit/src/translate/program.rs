//! The compile driver: declares the functions of all blocks of a program, has each one written, and makes machine code of it.

use std::collections::BTreeSet;

use cranelift_codegen::Context;
use cranelift_codegen::control::ControlPlane;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{self as clif, AbiParam};
use cranelift_codegen::isa::{OwnedTargetIsa, TargetIsa};
use cranelift_codegen::settings::{self, Configurable};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{ArenaMemoryProvider, JITBuilder, JITModule};
use cranelift_module::{FuncId, Module, ModuleError, ModuleReloc};
use sieben_engine::Layout;
use sieben_model::block::BlockId;

use super::specialization::Specializations;
use super::symbols::{self, Functions};
use super::{Program, Translator, dereferenceable, inlining, load_sinking, mod_ref, pointer_propagation, status_liveness, thunks};
use crate::entry::Generation;
use crate::jit::Native;
use crate::passes::{Pass, PassSet};
use crate::run::{LINKS, Room};

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
    /// Whether no block sees what one that has ended has left in its local data.
    pub(crate) forgets_locals: bool,
    /// Whether the code is kept as text, for people.
    pub(crate) lists: bool,
    /// Which optimizations are used.
    pub(crate) passes: PassSet,
}

impl Options {
    /// Whether an optimization is used.
    pub(crate) fn does(&self, pass: Pass) -> bool {
        self.optimize && self.passes.has(pass)
    }
}

impl Default for Options {
    fn default() -> Self {
        Self {
            inline: true,
            exact: true,
            optimize: false,
            asks_before_writing: false,
            forgets_locals: false,
            lists: false,
            passes: PassSet::default(),
        }
    }
}

/// Address space reserved for the code of a program, for each IR instruction.
/// It costs no memory until it is used; a call with exact status bits takes more than 1 KiB.
const RESERVED_BYTES_PER_INSTRUCTION: usize = 4096;
/// Address space reserved for the code of any program.
const RESERVED_BYTES_MIN: usize = 1 << 20;
/// Address space reserved for the code of a program at most: relative calls reach that far on every machine, and no program that becomes
/// machine code needs more.
const RESERVED_BYTES_MAX: usize = 1 << 30;

/// A function with more pieces of code, most of which ask somebody, is written again as in the first tier: the time to share out the
/// registers of such functions grows with the square of their number.
const OPTIMIZED_PIECES_MAX: usize = 20_000;

/// Native stack that a run may take; threads have 2 MiB and more.
const STACK_BYTES: usize = 1 << 20;
/// What an activation takes beside the frame of its function. The Rust code that enters interrupts comes on top, as often as machine
/// code nests them: see `INTERRUPTS`.
const STACK_BYTES_OF_A_CALL: usize = 1 << 10;
/// The instruction that makes room on the stack is among these bytes.
const PROLOGUE_BYTES: usize = 16;

/// Finds the index of a loaded block.
pub(super) type Find<'a> = &'a dyn Fn(BlockId) -> Option<u32>;

/// The machine that code is for, with the given settings of Cranelift.
fn instruction_set(level: &str, algorithm: &str, machine: Target) -> Result<OwnedTargetIsa, String> {
    let mut flags = settings::builder();
    let set = |flags: &mut settings::Builder, name: &str, value: &str| flags.set(name, value).map_err(|error| error.to_string());
    set(&mut flags, "opt_level", level)?;
    set(&mut flags, "regalloc_algorithm", algorithm)?;
    set(&mut flags, "use_colocated_libcalls", "false")?;
    set(&mut flags, "is_pic", "false")?;
    // Frames have a limit below, so that nobody has to look for the end of the stack.
    set(&mut flags, "enable_probestack", "false")?;
    let verified = match machine {
        Target::This => cfg!(debug_assertions),
        #[cfg(target_arch = "x86_64")]
        Target::Counted => false,
        #[cfg(feature = "aarch64")]
        Target::Aarch64 => true,
    };
    set(&mut flags, "enable_verifier", if verified { "true" } else { "false" })?;
    // Nobody unwinds through machine code: what it calls never panics into it.
    set(&mut flags, "unwind_info", "false")?;
    let builder = match machine {
        Target::This => cranelift_native::builder().map_err(|message| format!("this machine is not supported: {message}"))?,
        #[cfg(target_arch = "x86_64")]
        Target::Counted => {
            let mut builder =
                cranelift_codegen::isa::lookup_by_name("x86_64-unknown-linux-gnu").map_err(|error| format!("no x86-64: {error}"))?;
            for feature in COUNTED_FEATURES {
                builder.set(feature, "true").map_err(|error| error.to_string())?;
            }
            builder
        }
        #[cfg(feature = "aarch64")]
        Target::Aarch64 => {
            cranelift_codegen::isa::lookup_by_name("aarch64-unknown-linux-gnu").map_err(|error| format!("no aarch64: {error}"))?
        }
    };
    builder.finish(settings::Flags::new(flags)).map_err(|error| error.to_string())
}

/// The features of the x86-64 processor for which code is counted: those of processors since 2013.
#[cfg(target_arch = "x86_64")]
const COUNTED_FEATURES: [&str; 11] = [
    "has_sse3",
    "has_ssse3",
    "has_sse41",
    "has_sse42",
    "has_popcnt",
    "has_avx",
    "has_avx2",
    "has_fma",
    "has_bmi1",
    "has_bmi2",
    "has_lzcnt",
];

/// The machine that code is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Target {
    /// This one.
    This,
    /// A fixed one, so that the bytes of code are the same wherever they are counted; the code never runs.
    #[cfg(target_arch = "x86_64")]
    Counted,
    /// Another one, whose code is checked and never runs.
    #[cfg(feature = "aarch64")]
    Aarch64,
}

/// The code of a program before it becomes executable.
struct EmittedCode {
    module: JITModule,
    /// The general version of each block, if somebody may enter it.
    blocks: Vec<Option<FuncId>>,
    bytes: usize,
    frame_max: usize,
    pinned: BTreeSet<u16>,
    /// What each block needs where it begins.
    rooms: Vec<Room>,
    /// Each block in Cranelift's IR and as instructions of the machine, if somebody wants to read it.
    listing: String,
}

/// Compiles all blocks, to be read and not to be run: as text.
pub(crate) fn listing(blocks: &[Native], find: Find<'_>, layout: &Layout, options: Options) -> Result<String, String> {
    Ok(write(blocks, find, layout, Options { lists: true, ..options }, Target::This)?.listing)
}

/// Compiles all blocks. The code takes the data blocks with the returned numbers to be as they were loaded.
pub(crate) fn program(
    blocks: &[Native],
    find: Find<'_>,
    layout: &Layout,
    options: Options,
) -> Result<(Generation, BTreeSet<u16>, Vec<Room>), String> {
    let EmittedCode { mut module, blocks, bytes, frame_max, mut pinned, rooms, .. } = write(blocks, find, layout, options, Target::This)?;
    module.finalize_definitions().map_err(|error| error.to_string())?;
    let levels = (STACK_BYTES / (frame_max + STACK_BYTES_OF_A_CALL)).min(LINKS);
    if levels < levels_needed(layout) {
        return Err(format!("its blocks need up to {frame_max} bytes of stack"));
    }
    pinned.remove(&0);
    Ok((Generation::new(module, &blocks, bytes, levels), pinned, rooms))
}

/// How many activations have to find room on the stack. Interrupts that come on top go to the interpreter.
fn levels_needed(layout: &Layout) -> usize {
    usize::from(layout.nesting_depth) + usize::from(layout.nesting_depth_error) + 2
}

/// Compiles all blocks for aarch64 with Cranelift's checks, to see that it can be done; how many bytes of code there are.
#[cfg(feature = "aarch64")]
pub(crate) fn aarch64_bytes(blocks: &[Native], find: Find<'_>, layout: &Layout, options: Options) -> Result<usize, String> {
    Ok(write(blocks, find, layout, options, Target::Aarch64)?.bytes)
}

/// The bytes of the code of all blocks for a fixed processor.
#[cfg(target_arch = "x86_64")]
pub(crate) fn counted_bytes(blocks: &[Native], find: Find<'_>, layout: &Layout, options: Options) -> Result<usize, String> {
    Ok(write(blocks, find, layout, options, Target::Counted)?.bytes)
}

/// Writes the code of all blocks for a machine.
fn write(blocks: &[Native], find: Find<'_>, layout: &Layout, options: Options, machine: Target) -> Result<EmittedCode, String> {
    let isa = instruction_set("none", if options.optimize { "backtracking" } else { "single_pass" }, machine)?;
    // Cranelift's optimizations move calculations to where their results are used: good in a loop, bad in straight bit logic, where the
    // bytes that were read wait in registers until then.
    let for_loops = if options.optimize { Some(instruction_set("speed", "backtracking", machine)?) } else { None };
    // The allocator of the first tier gives each value that leaves its piece of code a place of its own, the other one shares them; and
    // optimized code of thousands of statements in a row keeps what it has read until it is used.
    let for_room = instruction_set("none", "backtracking", machine)?;
    // What is too long for the other allocator is written as in the first tier.
    let quick = if options.optimize { Some(instruction_set("none", "single_pass", machine)?) } else { None };
    let frame_limit = STACK_BYTES / levels_needed(layout) - STACK_BYTES_OF_A_CALL;
    let mut builder = JITBuilder::with_isa(isa, cranelift_module::default_libcall_names());
    let passes = options.passes;
    let plans = if passes.has(Pass::Inlining) { inlining::plan(blocks, find) } else { vec![inlining::InlinePlan::default(); blocks.len()] };
    let insts = inlining::instructions_max(blocks, find, &plans);
    let reserve = insts.saturating_mul(RESERVED_BYTES_PER_INSTRUCTION).clamp(RESERVED_BYTES_MIN, RESERVED_BYTES_MAX);
    builder.memory_provider(Box::new(ArenaMemoryProvider::new_with_size(reserve).map_err(|error| error.to_string())?));
    builder.symbol_lookup_fn(Box::new(symbols::address));
    let mut module = JITModule::new(builder);
    let functions = Functions::default();
    let pointers = pointer_propagation::follow(blocks, find);
    let needs = dereferenceable::find(blocks, &pointers, find);
    let mut versions = Specializations::new(&mut module, blocks, find, needs, options.optimize).map_err(|error| error.to_string())?;
    let summaries = status_liveness::summaries(blocks, find, options.exact);
    let effects = match passes.has(Pass::ModRef) {
        true => mod_ref::find(blocks, find, (layout, passes), &plans, &pointers),
        false => vec![None; blocks.len()],
    };
    let mut context = module.make_context();
    let mut frontend = FunctionBuilderContext::new();
    let mut listing = String::new();
    if options.lists {
        // Blocks that only become part of others have no function.
        blocks.iter().for_each(|block| listing += &format!("{}\n{}\n", block.id, block.code));
    }
    let (mut bytes, mut frame_max) = (0, 0);
    let mut pinned = BTreeSet::new();
    while let Some((index, known, function)) = versions.next() {
        // Whoever clears the context forgets it.
        context.set_disasm(options.lists);
        context.func.signature = block_signature(&module);
        let target = module.target_config();
        let mut for_loops = for_loops.as_ref().filter(|_| plans[index].loops && !plans[index].is_long);
        let mut program = Program {
            functions: &functions,
            blocks,
            summaries: &summaries,
            plans: &plans,
            effects: &effects,
            pointers: &pointers,
            find,
            layout,
            options,
        };
        let mut translate = |context: &mut Context, program: Program<'_>| {
            let builder = FunctionBuilder::new(&mut context.func, &mut frontend);
            Translator::new(builder, &mut module, &mut versions, program, index).run(known, target)
        };
        let mut found = translate(&mut context, program);
        let is_too_long = options.optimize && context.func.layout.blocks().count() > OPTIMIZED_PIECES_MAX;
        if is_too_long {
            let signature = context.func.signature.clone();
            context.func.clear();
            context.func.signature = signature;
            program.options.optimize = false;
            for_loops = None;
            found = translate(&mut context, program);
        }
        pinned.append(&mut found.pinned);
        if options.lists {
            listing += &format!("{}\n{}\n", blocks[index].id, context.func.display());
        }
        let quick = quick.as_ref().filter(|_| is_too_long);
        let sets = Sets { other: for_loops, for_room: &for_room, frame_limit, quick, passes };
        define(&mut module, function, &mut context, sets).map_err(|error| format!("{}: {error}", blocks[index].id))?;
        listing += context.compiled_code().and_then(|code| code.vcode.as_deref()).unwrap_or_default();
        let code = context.compiled_code().map_or(&[][..], |code| code.code_buffer());
        bytes += code.len();
        frame_max = frame_max.max(frame_bytes(code));
        module.clear_context(&mut context);
    }
    bytes += thunks::define(&mut module, &functions, &mut context, &mut frontend).map_err(|error| error.to_string())?;
    let blocks = (0..blocks.len()).map(|index| versions.general(index)).collect();
    let rooms = plans.iter().map(inlining::InlinePlan::room).collect();
    Ok(EmittedCode { module, blocks, bytes, frame_max, pinned, rooms, listing })
}

/// The instruction sets that a function may be compiled for beside that of the module.
struct Sets<'a> {
    /// What it is compiled for if it is written as in the first tier though others are not.
    quick: Option<&'a OwnedTargetIsa>,
    /// What it is optimized for, if it is.
    other: Option<&'a OwnedTargetIsa>,
    /// What it is compiled for if it is optimized, or if its frame has more bytes than this.
    for_room: &'a OwnedTargetIsa,
    frame_limit: usize,
    passes: PassSet,
}

/// Compiles a function.
fn define(module: &mut JITModule, id: FuncId, context: &mut Context, sets: Sets<'_>) -> Result<(), Box<ModuleError>> {
    let compile = |context: &mut Context, isa: &dyn TargetIsa| match context.compile(isa, &mut ControlPlane::default()) {
        Ok(code) => Ok(frame_bytes(code.code_buffer())),
        Err(error) => Err(Box::new(ModuleError::from(error))),
    };
    // Optimizations move calculations and reads, and nothing moves them back.
    let as_written = sets.other.map(|_| context.func.clone());
    let mut isa = match sets.other {
        None => sets.quick.map_or(module.isa(), |quick| &**quick),
        Some(other) => {
            context.optimize(&**other, &mut ControlPlane::default()).map_err(ModuleError::from)?;
            if sets.passes.has(Pass::LoadSinking) {
                load_sinking::bring_nearer(&mut context.func);
            }
            // It is optimized.
            &**sets.for_room
        }
    };
    let frame = compile(context, isa)?;
    if frame > sets.frame_limit {
        isa = &**sets.for_room;
        if let Some(function) = as_written {
            context.func = function;
        }
        compile(context, isa)?;
    }
    let code = context.compiled_code().expect("it was compiled");
    let alignment = u64::from(code.buffer.alignment).max(u64::from(isa.function_alignment().minimum)).max(isa.symbol_alignment());
    let bytes = code.code_buffer().to_vec();
    let relocations: Vec<_> =
        code.buffer.relocs().iter().map(|relocation| ModuleReloc::from_mach_reloc(relocation, &context.func, id)).collect();
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

pub(super) fn block_signature(module: &JITModule) -> clif::Signature {
    words_signature(module, 4)
}

pub(super) fn words_signature(module: &JITModule, arguments: usize) -> clif::Signature {
    let mut signature = module.make_signature();
    signature.params = vec![AbiParam::new(I64); arguments];
    signature.returns.push(AbiParam::new(I64));
    signature
}
