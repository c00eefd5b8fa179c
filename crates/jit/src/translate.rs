//! Code generation: the IR of a block becomes a function of Cranelift's IR.
//!
//! Registers of the CPU are variables while the block runs; they are stored where something else reads them: at calls, at the end and at
//! runtime calls. A path on which something failed is cold code at the end of the function.

use std::collections::BTreeSet;
use std::mem::offset_of;

use cranelift_codegen::cursor::{Cursor, FuncCursor};
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{self as clif, BlockArg, FuncRef, InstBuilder, InstructionData, MemFlagsData, Opcode, Value, ValueDef};
use cranelift_frontend::{FunctionBuilder, Variable};
use cranelift_jit::JITModule;
use cranelift_module::{FuncId, Module};
use rustc_hash::{FxHashMap, FxHashSet};
use sieben_engine::Layout;
use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Inst, Op, Place, Target, Var};
use sieben_engine::machine::{Register, Registers};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockKind;

use crate::jit::{Native, end};
use crate::run::Run;
use crate::runtime_calls::{GO_ON, LEAVE, RuntimeCall};

mod address_reuse;
mod bounds_checks;
mod bracket_promotion;
mod calls;
mod congruence;
mod decimal;
mod dereferenceable;
mod division_by_constants;
mod flow;
mod if_conversion;
mod inlining;
mod instance_bounds;
mod instruction_selection;
mod intrinsics;
mod live_range_splitting;
mod load_elimination;
mod load_sinking;
mod loop_optimizer;
mod memory;
mod memory_to_register;
mod mod_ref;
mod moves;
mod natural_loops;
mod open;
mod pointer_propagation;
mod preserved_block;
mod program;
mod range_analysis;
mod region_exits;
mod safepoint_coalescing;
mod scalar_promotion;
mod shifts;
mod sized;
mod slp_calls;
mod specialization;
mod status_liveness;
mod store_merging;
mod string_bytes;
mod string_comparison;
mod string_conversion;
mod string_lengths;
mod strings;
mod symbolic_summaries;
mod symbols;
mod thunks;
mod unrolling;
mod value;

use address_reuse::AvailableAddresses;
use flow::MergeState;
use if_conversion::Predicate;
use inlining::{CodeGrowth, InlineFrame, InlinePlan};
use instance_bounds::Instance;
use memory_to_register::LocalValues;
use mod_ref::ModRef;
use natural_loops::NaturalLoop;
pub(crate) use natural_loops::{made_by, targets};
use pointer_propagation::InstancePointer;
#[cfg(feature = "aarch64")]
pub(crate) use program::aarch64_bytes;
#[cfg(target_arch = "x86_64")]
pub(crate) use program::counted_bytes;
use program::{Find, block_signature, words_signature};
pub(crate) use program::{Options, listing, program};
use range_analysis::Ranges;
use region_exits::RegionExit;
use safepoint_coalescing::BudgetCheck;
use scalar_promotion::{Base, ComputedAddress, Promoted};
use slp_calls::SlpGroup;
use specialization::{Assumed, Specializations};
use status_liveness::{SPARED, Summary, open_blocks, set_by_calls};
use store_merging::AvailableBits;
use string_lengths::PromotedLength;
use symbolic_summaries::Reliance;
use symbols::{Functions, Symbol};
use value::{Constants, Lazy, Val};

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

/// Whether an operation compares, which takes more than one instruction with a constant, too.
fn compares(op: Op) -> bool {
    use Op as O;
    let integers = matches!(op, O::EqI16 | O::NeI16 | O::LtI16 | O::LeI16 | O::GtI16 | O::GeI16);
    let doubles = matches!(op, O::EqI32 | O::NeI32 | O::LtI32 | O::LeI32 | O::GtI32 | O::GeI32);
    let reals = matches!(op, O::EqF32 | O::NeF32 | O::LtF32 | O::LeF32 | O::GtF32 | O::GeF32 | O::UnorderedF32);
    integers || doubles || reals
}

/// Whether an operation says something about its arguments that nearly always goes to status bits alone.
fn tells(op: Op) -> bool {
    compares(op)
        || matches!(op, Op::OverflowsI16 | Op::OverflowsI32 | Op::PositiveI16 | Op::NegativeI16 | Op::PositiveI32 | Op::NegativeI32)
}

/// What a called block finds.
const AT_CALL: &[(Register, u64)] =
    &[(Register::Os, 0), (Register::Or, 0), (Register::Sta, 1), (Register::Fc, 0), (Register::Ma, 0), (Register::Nesting, 0)];

/// Where a path goes on after the Host answered.
#[derive(Clone, Copy)]
enum Continuation {
    /// At the next statement.
    NextStatement,
    /// At this block, with `run.value` as its argument.
    Deliver(clif::Block),
    /// At this block, inside the same statement.
    At(clif::Block),
    /// Nowhere: the Host ends the run.
    Never,
}

/// What is compiled.
#[derive(Clone, Copy)]
struct Program<'a> {
    functions: &'a Functions,
    blocks: &'a [Native],
    summaries: &'a [Summary],
    plans: &'a [InlinePlan],
    effects: &'a [Option<ModRef>],
    pointers: &'a [InstancePointer],
    find: Find<'a>,
    layout: &'a Layout,
    options: Options,
}

/// What a function relies on.
struct Assumptions {
    /// Data blocks that it takes to be as they were loaded.
    pinned: BTreeSet<u16>,
}

struct Translator<'a> {
    b: FunctionBuilder<'a>,
    module: &'a mut JITModule,
    functions: &'a Functions,
    blocks: &'a [Native],
    summaries: &'a [Summary],
    plans: &'a [InlinePlan],
    effects: &'a [Option<ModRef>],
    pointers: &'a [InstancePointer],
    versions: &'a mut Specializations,
    index: usize,
    find: Find<'a>,
    layout: &'a Layout,
    options: Options,
    /// Data blocks that the code takes to be as they were loaded.
    pinned: BTreeSet<u16>,
    lazies: Vec<Lazy>,
    constants: Constants,
    /// Constants that the beginning of the function names.
    of_function: FxHashMap<u64, Value>,
    /// The cold block that is being written, if it is one.
    cold: Option<clif::Block>,
    references: FxHashMap<FuncId, FuncRef>,
    variables: Vec<Variable>,
    /// Values of registers in the running piece of code; `None` = in the variable.
    current: [Option<Val>; Register::COUNT],
    /// Registers whose value here is newer than the variable.
    changed: u32,
    /// Registers whose memory may be older than their value.
    dirty: u32,
    temporaries: Vec<Option<Val>>,
    /// What is known of memory in the running piece of code.
    bytes: AvailableBits,
    words: LocalValues,
    /// Variables that hold numbers of local data where ways meet: offset and width.
    met: FxHashMap<(i32, Width), Variable>,
    /// Timers that are up to date in the running piece of code.
    fresh_timers: Vec<u64>,
    /// Counts of counters that are known in the running piece of code.
    counts: Vec<(u64, Value)>,
    /// Where timers and counters begin, if the running piece of code knows it.
    items: [Option<Value>; 2],
    /// Registers in whose memory something else than what they begin with may have been stored.
    stored: u32,
    /// What has been taken from the budget and not from its variable.
    taken: i64,
    /// The look at the budget on which blocks that are entered now rely.
    look: Option<usize>,
    looks: Vec<BudgetCheck>,
    /// Pieces around the running statement, and before it, that the interpreter does where it must.
    interpreted: Vec<RegionExit>,
    loops: Vec<NaturalLoop>,
    /// Memory for which registers stand, in the loops met so far.
    promoted: Vec<Promoted>,
    /// Lengths of texts that loops keep.
    kept_lengths: Vec<PromotedLength>,
    /// What is known of the values of the present block.
    ranges: Ranges,
    /// Ranges of values in the running statement.
    bounds: FxHashMap<Value, (u32, u32)>,
    /// Ranges of values that were computed for one instruction of the IR and nothing before: they hold wherever the value is used.
    bounds_of_results: FxHashMap<Value, (u32, u32)>,
    /// The bytes in their areas to which pointers lead that were read.
    bytes_of_pointers: FxHashMap<Value, Value>,
    /// The first value that the running instruction may have added.
    newest: u32,
    /// What remained of divisions: of which number of 32 bits with sign, and the divisor.
    rests: FxHashMap<Value, (Value, u32)>,
    /// Quotients and rests that are sums in machine code: their ranges are known, those of what they are made of do not count.
    divided: FxHashSet<Value>,
    /// Values in the running statement that the smallest loop around it does not change.
    fixed: FxHashSet<Value>,
    /// Whether iterations of a loop are being written that are done at once, one after the other.
    in_iterations: bool,
    /// What loops write, by their block and first statement.
    writes: FxHashMap<(usize, u32), BTreeSet<(Base, i32)>>,
    /// Blocks in which memory is compared with what the code relies on, by the block before which they stand.
    verifying: FxHashMap<clif::Block, clif::Block>,
    /// Those that are still to be written, and for which statement.
    verify_later: Vec<(clif::Block, u32, clif::Block, Option<usize>)>,
    /// Loops of the present block that have a fast version before them: first and last statement.
    at_once: Vec<(u32, u32)>,
    /// How many there are in the function, with those of all blocks that became part of it.
    loops_at_once: usize,
    /// Where vectors are written to so that they are put together at once, and the number of the next one there.
    together: Option<(clif::StackSlot, u32)>,
    /// Of masks, simpler ones that are their opposites.
    opposites: FxHashMap<Value, Value>,
    /// Of vectors of small numbers of 16 bits, the same numbers with 32.
    in_words: FxHashMap<Value, Vec<Value>>,
    /// Values whose bits above so many are 0.
    narrow: FxHashMap<Value, u32>,
    /// Numbers of 32 bits all of which are 0 but one, perhaps, and which that is.
    alone: FxHashMap<Value, u8>,
    /// All registers that the block may change.
    written: u32,
    /// What AR2 held when the present block was entered.
    instance: Val,
    /// Where the instance of the present block lies, if it is inside its data block whatever AR2 holds.
    in_range: Option<Instance>,
    /// How callers rely on the present block.
    reliance: Reliance,
    /// Addresses that were computed and are known to be there.
    computed: FxHashMap<Value, ComputedAddress>,
    elements: AvailableAddresses,
    arrivals: FxHashMap<u32, MergeState>,
    statement: u32,
    /// Parameters passed and not yet taken.
    passed: Vec<Val>,
    /// Parameters that the caller of an inlined block passed.
    given: Vec<Val>,
    /// Blocks in which the present one is inlined, outermost first; that one alone has a function, and the link and local data below.
    outer: Vec<InlineFrame>,
    /// Where the local data of the present block begin behind those of the outermost one, in bytes.
    local_offset: i32,
    /// Where the parameters of the present block end behind those of the outermost one, as their number.
    parameters_end: usize,
    /// IR instructions of inlined blocks so far.
    grown: CodeGrowth,
    /// Safe points on ways back that are still to be written: the block, the statement, where it begins.
    ways: Vec<(clif::Block, u32, clif::Block)>,
    /// Calls that were written side by side, of which the rest is still to be written.
    series: Option<SlpGroup>,
    /// The next value that is written stays away if this is not 0, or if it is.
    choice: Option<Predicate>,
    /// Where in its piece the running statement writes a bit last, if that is known: a good place to work on bits.
    aim: Option<u8>,
    /// The running statement has not begun yet.
    arriving: bool,
    /// Nothing that follows is reached.
    ended: bool,
    leave: clif::Block,
    run: Value,
    /// The arena as the running code has it, and as the function was given it.
    arena: Value,
    first_arena: Value,
    /// Where it is taken from again.
    arena_slot: Option<clif::StackSlot>,
    /// Where that was done last.
    arena_taken: Option<clif::Block>,
    local: Value,
    link: Value,
}

const TRUSTED: MemFlagsData = MemFlagsData::trusted();

fn register_offset(register: Register) -> i32 {
    register.offset() as i32
}

impl<'a> Translator<'a> {
    fn new(
        mut b: FunctionBuilder<'a>,
        module: &'a mut JITModule,
        versions: &'a mut Specializations,
        program: Program<'a>,
        index: usize,
    ) -> Self {
        let Program { functions, blocks, summaries, plans, effects, pointers, find, layout, options } = program;
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
            effects,
            pointers,
            versions,
            index,
            find,
            layout,
            options,
            pinned: BTreeSet::new(),
            lazies: Vec::new(),
            constants: Constants::default(),
            of_function: FxHashMap::default(),
            cold: None,
            references: FxHashMap::default(),
            variables,
            current: [None; Register::COUNT],
            changed: 0,
            dirty: 0,
            temporaries: Vec::new(),
            bytes: AvailableBits::default(),
            words: LocalValues::default(),
            met: FxHashMap::default(),
            fresh_timers: Vec::new(),
            counts: Vec::new(),
            items: [None; 2],
            stored: 0,
            taken: 0,
            look: None,
            looks: Vec::new(),
            interpreted: Vec::new(),
            loops: Vec::new(),
            promoted: Vec::new(),
            kept_lengths: Vec::new(),
            ranges: Ranges::default(),
            bounds: FxHashMap::default(),
            bounds_of_results: FxHashMap::default(),
            bytes_of_pointers: FxHashMap::default(),
            newest: 0,
            rests: FxHashMap::default(),
            divided: FxHashSet::default(),
            fixed: FxHashSet::default(),
            in_iterations: false,
            writes: FxHashMap::default(),
            verifying: FxHashMap::default(),
            verify_later: Vec::new(),
            at_once: Vec::new(),
            loops_at_once: 0,
            together: None,
            opposites: FxHashMap::default(),
            in_words: FxHashMap::default(),
            narrow: FxHashMap::default(),
            alone: FxHashMap::default(),
            written: 0,
            instance: Val::Const(0),
            in_range: None,
            reliance: Reliance::None,
            computed: FxHashMap::default(),
            elements: AvailableAddresses::default(),
            arrivals: FxHashMap::default(),
            statement: 0,
            passed: Vec::new(),
            given: Vec::new(),
            outer: Vec::new(),
            local_offset: 0,
            parameters_end: 0,
            grown: CodeGrowth::default(),
            ways: Vec::new(),
            series: None,
            choice: None,
            aim: None,
            arriving: false,
            ended: false,
            leave,
            run,
            arena,
            first_arena: arena,
            arena_slot: None,
            arena_taken: None,
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
    fn run(mut self, known: Assumed, target: cranelift_codegen::isa::TargetFrontendConfig) -> Assumptions {
        self.find_registers_and_loops(known);
        if known.inside {
            self.know_instance_inside(self.versions.needs(self.index));
        }
        self.ranges = self.find_ranges();
        self.keep_budget();
        self.keep_arena();
        self.enter_block();
        self.look_for_room();
        self.statements();
        debug_assert!(self.ended, "a block ends with a return");
        self.b.switch_to_block(self.leave);
        let leave = self.b.ins().iconst(I64, LEAVE as i64);
        self.b.ins().return_(&[leave]);
        self.b.seal_all_blocks();
        self.b.finalize(target);
        Assumptions { pinned: self.pinned }
    }

    /// Writes the statements of the present block.
    fn statements(&mut self) {
        self.note_bytes();
        let code = &self.native().code;
        for statement in 0..code.statement_count() {
            if !self.ended {
                self.leave_loops(statement as u32);
            }
            self.statement = statement as u32;
            self.arrive();
            if self.ended || self.has_more_iterations() {
                continue;
            }
            self.begin_iterations();
            self.temporaries.clear();
            self.bounds.clear();
            self.fixed.clear();
            self.passed.clear();
            self.forget_what_was_handed();
            self.look_at_budget();
            self.look_at_statements();
            self.begin_series();
            self.aim = self.written_bit(code.statement(statement));
            let first = code.statements[statement];
            for (index, inst) in (first..).zip(code.statement(statement)) {
                if self.is_in_series(index) {
                    continue;
                }
                if matches!(inst, Inst::Jump { .. } | Inst::Branch { .. } | Inst::JumpTable { .. }) {
                    let behind = &code.insts[index as usize + 1..code.statements[statement + 1] as usize];
                    self.drop_what_was_handed(behind);
                }
                self.inst(index, inst);
                if self.ended {
                    break;
                }
            }
            if !self.ended {
                self.drop_what_was_handed(&[]);
            }
            self.end_series();
        }
    }

    /// Which registers the block mentions, and where it jumps back to.
    fn find_registers_and_loops(&mut self, known: Assumed) {
        let code = &self.native().code;
        let mut mentioned = 0;
        let mut back = Vec::new();
        for statement in 0..code.statement_count() {
            for inst in code.statement(statement) {
                back.extend(natural_loops::targets(code, inst).filter(|&to| to as usize <= statement));
                if let Inst::Load { place, .. } | Inst::Store { place, .. } = *inst
                    && may_be_in_data_block(place)
                {
                    mentioned |= open_blocks();
                }
                let written = natural_loops::written(inst);
                let written = if matches!(inst, Inst::Call { .. }) { status_liveness::ALL } else { written };
                self.written |= written;
                mentioned |= written | status_liveness::effect(inst).reads;
            }
        }
        self.loops = self.find_loops(self.index);
        for to in back {
            self.expect_way_back(to);
        }
        if self.called_only() {
            // What is known there is not in memory.
            self.written |= AT_CALL.iter().fold(known.registers(), |all, &(register, _)| all | bit_of(register));
        }
        let at_call = if self.called_only() { AT_CALL } else { &[] };
        let mut known: Vec<(Register, u64)> = at_call.iter().copied().chain(known.iter()).collect();
        let begins = self.begins_fresh();
        if begins {
            known = Register::ALL.iter().copied().zip(Registers::fresh().to_words()).collect();
        }
        let registers = self.registers_in_memory();
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
                let value = self.b.ins().load(ty, TRUSTED, registers, register_offset(register));
                self.b.def_var(self.variables[register as usize], value);
            }
        }
        self.instance = self.register(Register::Ar2);
    }

    /// Whether the function begins with fresh registers, which are in memory: that of an organization block.
    fn begins_fresh(&self) -> bool {
        !self.called_only() && !self.options.exact
    }

    /// Registers that hold what they began with, and so does their memory on all ways to here.
    fn still_fresh(&self) -> u32 {
        // A way back brings along what is stored in code that is not written yet.
        if !self.begins_fresh() || self.plans[self.index].loops {
            return 0;
        }
        let fresh = Registers::fresh().to_words();
        let is_fresh = |register: Register| self.current[register as usize] == Some(Val::Const(fresh[register as usize]));
        let registers = Register::ALL.iter().filter(|&&register| is_fresh(register));
        registers.fold(0, |all, &register| all | bit_of(register)) & !self.stored
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
                let value = match value {
                    Val::Const(constant) if open_blocks() & bit_of(register) != 0 => self.constant_of_function(constant),
                    value if is_bit(register) => self.flag(value),
                    value => self.word(value),
                };
                self.b.def_var(self.variables[register as usize], value);
            }
        }
        self.changed &= !wanted;
    }

    /// A constant that is the same value in all of the function: where ways meet that open the same data block, nothing is chosen.
    fn constant_of_function(&mut self, constant: u64) -> Value {
        if let Some(&value) = self.of_function.get(&constant) {
            return value;
        }
        let Some(entry) = self.b.func.layout.entry_block().filter(|_| self.options.optimize) else {
            return self.word(Val::Const(constant));
        };
        let value = FuncCursor::new(self.b.func).at_first_insertion_point(entry).ins().iconst(I64, constant as i64);
        self.of_function.insert(constant, value);
        value
    }

    /// Stores registers where others read them.
    fn spill(&mut self, registers: u32) {
        if registers == 0 {
            return;
        }
        let memory = self.registers_in_memory();
        let fresh = Registers::fresh().to_words();
        for &register in Register::ALL {
            if registers & bit_of(register) != 0 {
                let value = self.register(register);
                if value != Val::Const(fresh[register as usize]) {
                    self.stored |= bit_of(register);
                }
                let value = self.word(value);
                self.b.ins().store(TRUSTED, value, memory, register_offset(register));
            }
        }
    }

    /// Address of the machine's registers.
    fn registers_in_memory(&mut self) -> Value {
        self.load_run(offset_of!(Run<'_, '_>, registers))
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
        let Some(added) = self.pointers[self.index].at(self.statement) else {
            if let Some(pointer) = self.ranges.instance_at(self.statement) {
                self.current[Register::Ar2 as usize] = Some(Val::Const(pointer));
            }
            return;
        };
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

    fn ask(&mut self, question: RuntimeCall, arguments: &[Value]) -> Value {
        match self.cold {
            Some(_) => debug_assert!(!self.anything_waits(), "nothing waits in cold code"),
            None => self.forget_what_was_asked(),
        }
        if matches!(question, RuntimeCall::TryLoad | RuntimeCall::TryStore | RuntimeCall::CallOther) {
            self.look = None;
        }
        // Nobody looks at memory where a data block is looked for.
        let looks = !matches!(question, RuntimeCall::TryOpen);
        if looks {
            self.store_promoted();
        }
        let mut arguments: Vec<Value> = [self.run].iter().chain(arguments).copied().collect();
        // In an inlined block the link is another one.
        if let Some(link) = arguments.iter().position(|&argument| argument == self.link) {
            arguments[link] = self.shown_link();
        }
        let answer = match self.cold {
            Some(_) => self.ask_at_gate(question, &arguments),
            None => {
                let function = self.functions.get(self.module, Symbol::Question(question));
                self.call(function, &arguments)
            }
        };
        if looks {
            self.take_promoted();
        }
        answer
    }

    fn site(&mut self, inst: u32) -> Value {
        let inst = self.native().named_inst(inst);
        self.b.ins().iconst(I64, ((self.index as i64) << 32) | i64::from(inst))
    }

    fn load_run(&mut self, offset: usize) -> Value {
        self.b.ins().load(I64, TRUSTED, self.run, offset as i32)
    }

    fn result(&mut self) -> Value {
        self.load_run(offset_of!(Run<'_, '_>, value))
    }

    /// Goes on in cold code if the answer is not 0: asks the Host, who decides how the run goes on.
    fn unless_failed(&mut self, failed: Value, question: RuntimeCall, arguments: &[Value], after: Continuation) {
        let cold = self.cold_block();
        let go_on = self.b.create_block();
        self.b.ins().brif(failed, cold, &[], go_on, &[]);
        self.cold_path(cold, question, arguments, after);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
        if matches!(after, Continuation::At(_)) {
            self.forget_what_was_asked();
        }
    }

    /// A constant that only cold code uses costs the hot code before it nothing.
    fn named_here(&mut self, value: Value) -> Value {
        let dfg = &self.b.func.dfg;
        let ValueDef::Result(inst, 0) = dfg.value_def(value) else { return value };
        match dfg.insts[inst] {
            InstructionData::UnaryImm { opcode: Opcode::Iconst, imm } => {
                let ty = dfg.value_type(value);
                self.b.ins().iconst(ty, imm)
            }
            _ => value,
        }
    }

    /// Fills a cold block: registers stored, the Host asked.
    fn cold_path(&mut self, cold: clif::Block, question: RuntimeCall, arguments: &[Value], after: Continuation) {
        self.b.switch_to_block(cold);
        self.b.seal_block(cold);
        let before = self.cold.replace(cold);
        self.spill(self.dirty);
        let arguments: Vec<_> = arguments.iter().map(|&argument| self.named_here(argument)).collect();
        let answer = self.ask(question, &arguments);
        if matches!(after, Continuation::At(_) | Continuation::Deliver(_)) {
            self.look = None;
        }
        match after {
            Continuation::NextStatement if self.rest_is_interpreted(answer) => {}
            Continuation::At(block) => {
                self.b.ins().brif(answer, self.leave, &[], block, &[]);
            }
            Continuation::Never => {
                self.b.ins().jump(self.leave, &[]);
            }
            Continuation::Deliver(block) => {
                let value = self.result();
                let param = self.b.block_params(block)[0];
                let value = if self.b.func.dfg.value_type(param) == I32 { self.b.ins().ireduce(I32, value) } else { value };
                self.b.ins().brif(answer, self.leave, &[], block, &[BlockArg::Value(value)]);
            }
            Continuation::NextStatement => {
                let (changed, taken) = (self.changed, self.taken);
                self.leave_loops(self.statement + 1);
                let next = self.edge(self.statement + 1);
                let next = self.verified(self.statement + 1, next);
                self.b.ins().brif(answer, self.leave, &[], next, &[]);
                self.write_verifications();
                (self.changed, self.taken) = (changed, taken);
            }
        }
        self.cold = before;
    }

    fn inst(&mut self, index: u32, inst: &Inst) {
        self.newest = self.b.func.dfg.num_values() as u32;
        self.write_inst(index, inst);
        self.forget_words_behind(index, inst);
        if sieben_engine::ir::verify::writes(inst) == Some(Register::Ar2.into()) {
            self.know_instance_behind(index);
        }
    }

    fn write_inst(&mut self, index: u32, inst: &Inst) {
        match *inst {
            Inst::Constant { dst, value } => self.set(dst, Val::Const(value)),
            Inst::Compute { .. } if self.summaries[self.index].needless[index as usize] => {}
            Inst::Compute { dst, .. }
                if let Some((least, most)) = self.ranges.result(index)
                    && least == most =>
            {
                self.set(dst, Val::Const(u64::from(least)));
            }
            Inst::Compute { op: Op::PassOnPointer, dst, args } if self.ranges.is_passed_on_as_it_is(index) => {
                let pointer = self.get(args[0]);
                self.set(dst, pointer);
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
            Inst::Load { dst, place, width, .. } if let Some(value) = self.constant_at(index, place, width) => {
                self.set(dst, Val::Const(value));
            }
            Inst::Load { .. } | Inst::Store { .. } if self.access_instance(index, inst) => {}
            Inst::Load { dst, place, width, on_fault } => self.load(index, dst, place, width, on_fault),
            Inst::Store { place, width, src } => {
                let value = self.get(src);
                let value = match self.choice.take() {
                    Some(choice) => self.chosen(choice, (place, width), index, value),
                    None => Some(value),
                };
                if let Some(value) = value {
                    self.store(index, place, width, value);
                }
            }
            Inst::Move { from, to, bytes } if self.move_inside(index, (from, to, bytes)) => {}
            Inst::Move { from, to, .. } => {
                let pointers = [self.pointer(from), self.pointer(to)];
                self.store_open_blocks();
                let site = self.site(index);
                let failed = self.ask(RuntimeCall::TryMove, &[self.link, site, pointers[0], pointers[1]]);
                self.unless_failed(failed, RuntimeCall::Failed, &[self.link, site], Continuation::NextStatement);
            }
            Inst::Text { .. } => self.text(index, inst),
            Inst::Parameter { dst, index } => self.parameter(dst, index),
            Inst::PassParameter { src } => self.pass_parameter(src),
            Inst::Intrinsic { dst, intrinsic, args } => self.intrinsic(index, dst, intrinsic, args),
            Inst::Require { condition, .. } if self.ranges.is_met(index) => {
                if condition.register().is_none() {
                    self.set(condition, Val::Const(1));
                }
            }
            Inst::Require { condition, .. } if self.ranges.is_interpreted(index) => self.require_or_interpret(condition),
            Inst::Require { condition, code, register } if code & NOTED != 0 => {
                let go_on = self.b.create_block();
                self.require(index, condition, Some(register), Continuation::At(go_on));
                self.b.ins().jump(go_on, &[]);
                self.b.switch_to_block(go_on);
                self.b.seal_block(go_on);
            }
            Inst::Require { condition, register, .. } => self.require(index, condition, Some(register), Continuation::NextStatement),
            Inst::RequireStack { condition, .. } => self.require(index, condition, None, Continuation::Never),
            Inst::Open { register, number } => self.open(index, register, number),
            // Between two statements one of which is chosen.
            Inst::Jump { .. } if self.choice.is_some() => {}
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
                if self.chooses(index, condition, to.0) {
                    return;
                }
                self.branch(condition, to);
            }
            Inst::JumpTable { index: selector, first, count, otherwise } => self.jump_table(selector, first, count, otherwise),
            Inst::Call { callee, parameters } => self.call_block(index, callee, parameters),
            Inst::Return if !self.outer.is_empty() => {
                if let Some(end) = end(&self.native().code).filter(|&end| end != self.statement) {
                    self.inst(index, &Inst::Jump { to: Target(end) });
                }
                // Goes on in the caller.
            }
            Inst::Return => {
                self.settle_bytes();
                self.store_promoted();
                let set_by_calls = if self.called_only() { set_by_calls() } else { 0 };
                let nobody_needs = SPARED & !self.summaries[self.index].live_out;
                self.spill(self.dirty & !set_by_calls & !nobody_needs & !self.still_fresh());
                let go_on = self.b.ins().iconst(I64, GO_ON as i64);
                self.b.ins().return_(&[go_on]);
                self.ended = true;
            }
        }
    }

    /// Jumps if a condition is 1.
    fn branch(&mut self, condition: Val, to: Target) {
        let (mut condition, mut negated) = self.condition(condition);
        if to.0 <= self.statement && !negated {
            // The way on which a loop ends is the one that jumps.
            (condition, negated) = (self.opposite(condition), true);
        }
        let block = self.way_to(to);
        let go_on = self.b.create_block();
        let (then, otherwise) = if negated { (go_on, block) } else { (block, go_on) };
        self.b.ins().brif(condition, then, &[], otherwise, &[]);
        self.fill_ways();
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
    }

    fn compute(&mut self, op: Op, dst: Var, args: [Var; 4]) -> Val {
        let args = args.map(|arg| self.get(arg));
        let used = &args[..op.arity()];
        if op == Op::Copy {
            return args[0];
        }
        // Most status bits are never read; an operation with a constant is often no operation.
        let spared = dst.register().map_or_else(|| tells(op), |register| SPARED & bit_of(register) != 0);
        let is_lazy = |arg: &Val| matches!(arg, Val::Lazy(_));
        let waits = used.iter().all(|arg| arg.constant().is_none())
            || compares(op) && used.iter().any(|arg| arg.constant().is_none())
            || used.iter().any(is_lazy);
        // What a bracket leaves in OR and BR is mostly known and costs nothing.
        let of_bracket = matches!(op, Op::NestingOr | Op::NestingBr);
        if spared && self.options.inline && waits && !of_bracket {
            return self.later(op, args);
        }
        if self.options.inline
            && let Some(value) = self.nesting(op, used)
        {
            return value;
        }
        if spared && self.options.inline && waits {
            return self.later(op, args);
        }
        // Whether a REAL overflowed is a question for Rust code, and nearly always nobody wants to know.
        if self.options.inline && matches!(op, Op::RealOverflow | Op::RealProductOverflow | Op::RealExpOverflow) {
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
        if op == Op::Copy {
            return args[0];
        }
        if self.options.inline
            && let Some(value) = self.inline(op, args)
        {
            return value;
        }
        let args: Vec<Value> = args.iter().map(|&arg| self.word(arg)).collect();
        let function = self.functions.get(self.module, Symbol::Op(op));
        Val::Word(self.call(function, &args))
    }

    /// Takes registers from memory, where others changed them.
    fn reload(&mut self, registers: u32) {
        if registers == 0 {
            return;
        }
        self.stored |= registers;
        let memory = self.registers_in_memory();
        for &register in Register::ALL.iter().filter(|&&register| registers & bit_of(register) != 0) {
            let value = if is_bit(register) {
                Val::Bit { value: self.b.ins().load(I32, TRUSTED, memory, register_offset(register)), clean: true }
            } else {
                Val::Word(self.b.ins().load(I64, TRUSTED, memory, register_offset(register)))
            };
            self.set_register(register, value);
            self.dirty &= !bit_of(register);
        }
    }

    fn require(&mut self, index: u32, condition: Var, register: Option<Var>, after: Continuation) {
        let condition = self.get(condition);
        if condition.constant().is_some_and(|value| value & 1 != 0) {
            return;
        }
        let condition = self.flag(condition);
        let site = self.site(index);
        let register = register.map_or(Val::Const(0), |register| self.get(register));
        let register = self.word(register);
        let cold = self.cold_block();
        let go_on = self.b.create_block();
        self.b.ins().brif(condition, go_on, &[], cold, &[]);
        self.cold_path(cold, RuntimeCall::Unmet, &[self.link, site, register], after);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
        if matches!(after, Continuation::At(_)) {
            self.forget_what_was_asked();
        }
    }
}
