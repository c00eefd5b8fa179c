//! Inlining: small blocks become part of the functions that call them.
//!
//! Inside, parameters are the pointers that the caller passed, mostly constants, and so are the data block registers and AR2 of a function
//! block with its instance: access through them is access to a constant address. An observer sees the same activations as without inlining:
//! their links are written where they are shown.

use std::mem::offset_of;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{InstBuilder, Value};
use rustc_hash::FxHashMap;
use sieben_engine::ir::{Callee, Code, Inst, Place};
use sieben_engine::machine::{CALLS_MASK, CALLS_SHIFT, Register};
use sieben_model::address::Width;

use super::instance_bounds::Instance;
use super::natural_loops::{self, NaturalLoop};
use super::range_analysis::{Fact, Interval, Ranges};
use super::safepoint_coalescing::WEIGHT_MAX;
use super::scalar_promotion::Promoted;
use super::specialization::callees;
use super::status_liveness::ALL;
use super::symbolic_summaries::{Reliance, SymbolicSummary};
use super::value::Val;
use super::{AFTER_CALL, AT_CALL, Continuation, Find, MergeState, OPEN_BLOCKS, TRUSTED, Translator, bit_of};
use crate::jit::{Native, end, loop_heads};
use crate::run::{Link, Room, Run};
use crate::runtime_calls::RuntimeCall;
use crate::unrolling::UnrolledLoop;

/// Rounds in which blocks are chosen: an inlined block has others inlined in it, and so on, as deep as this.
const DEPTH_MAX: usize = 16;
/// IR instructions of an inlined block with all that is inlined in it. A call costs little beside so long a block, but its instance is
/// known only where the block becomes part of its caller.
const INSTRUCTIONS_MAX: usize = 1_200;
/// Jumps back of an inlined block: loops take the compiler long.
const LOOPS_MAX: usize = 4;
/// IR instructions of an inlined block that is handed pointers: only their caller knows where these lead, and to look at it at each access
/// takes longer and more code than anything else.
const INSTRUCTIONS_MAX_WITH_POINTERS: usize = 40_000;
/// Jumps back of an inlined block that is handed pointers.
const LOOPS_MAX_WITH_POINTERS: usize = 64;
/// IR instructions that a function may grow by, for each of its own.
const GROWTH: usize = 8;
/// IR instructions that any function may grow by besides those: one of few instructions may call much.
const GROWTH_MIN: usize = 2_000;
/// IR instructions that a function may grow by in all: the time to compile grows faster than a function.
const GROWTH_MAX: usize = 100_000;
/// IR instructions of a block beside its loops from which on Cranelift's optimizations cost more than they bring in the loops.
const BESIDE_LOOPS_MAX: usize = 8_000;

/// What a call restores for the caller.
pub(super) const RESTORED: [Register; 8] =
    [OPEN_BLOCKS[0], OPEN_BLOCKS[1], OPEN_BLOCKS[2], OPEN_BLOCKS[3], OPEN_BLOCKS[4], OPEN_BLOCKS[5], Register::Ma, Register::Nesting];
/// Where a link keeps it.
pub(super) const KEPT_IN: [usize; 8] = [
    offset_of!(Link, shared),
    offset_of!(Link, shared) + 8,
    offset_of!(Link, shared) + 16,
    offset_of!(Link, instance),
    offset_of!(Link, instance) + 8,
    offset_of!(Link, instance) + 16,
    offset_of!(Link, mcr_active),
    offset_of!(Link, nesting),
];

/// How a block takes part.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct InlinePlan {
    /// IR instructions that it adds to its caller; `None` = it is always called.
    inlined: Option<usize>,
    /// Activations below it that its function may enter itself.
    depth: usize,
    /// Bytes of local data that these take behind its own.
    local: usize,
    /// Whether its function has a loop.
    pub(super) loops: bool,
    /// Whether so much lies beside its own loops that what is optimized in these would cost more there.
    pub(super) is_long: bool,
    /// Whether only its caller knows where pointers lead through which it reads and writes.
    with_pointers: bool,
    /// What it takes from the budget with all that becomes part of it, at most.
    weight: i64,
}

impl InlinePlan {
    /// IR instructions that the block adds to its caller, if it becomes part of that.
    pub(super) fn inlined(&self) -> Option<usize> {
        self.inlined
    }

    /// What the block takes from the budget with all that becomes part of it, at most.
    pub(super) fn weight(&self) -> i64 {
        self.weight
    }

    /// What a function needs where it begins.
    pub(super) fn room(&self) -> Room {
        Room { depth: self.depth, local: self.local }
    }
}

/// IR instructions of all blocks that became part of a function: of those that are handed pointers, and of others.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct CodeGrowth {
    with_pointers: usize,
    others: usize,
}

impl CodeGrowth {
    /// With another block, if that becomes part of the function.
    fn with(self, plan: &InlinePlan) -> Self {
        let more = plan.inlined.unwrap_or(0);
        match plan.with_pointers {
            true => Self { with_pointers: self.with_pointers + more, ..self },
            false => Self { others: self.others + more, ..self },
        }
    }
}

/// Decides for all blocks. A block that calls itself, however far around, is never inlined.
pub(super) fn plan(blocks: &[Native], find: Find<'_>) -> Vec<InlinePlan> {
    let callees = callees(blocks, find);
    let mut plans = vec![InlinePlan::default(); blocks.len()];
    let mut decided = vec![false; blocks.len()];
    for _ in 0..DEPTH_MAX {
        let before = decided.clone();
        for (index, block) in blocks.iter().enumerate() {
            if before[index] || !callees[index].iter().all(|&callee| before[callee]) {
                continue;
            }
            decided[index] = true;
            plans[index] = reach(&plans, blocks, index, &callees[index]);
            let inner = callees[index].iter().filter_map(|&callee| plans[callee].inlined);
            let size = inner.fold(block.code.insts.len(), usize::saturating_add);
            let returns = block.code.insts.iter().filter(|inst| matches!(inst, Inst::Return)).count();
            let ends_once = returns == 1 && block.code.insts.last() == Some(&Inst::Return);
            let has_an_end = ends_once || end(&block.code).is_some();
            let fits = if plans[index].with_pointers {
                size <= INSTRUCTIONS_MAX_WITH_POINTERS && loop_heads(&block.code).len() <= LOOPS_MAX_WITH_POINTERS
            } else {
                // One look at the budget has to serve for all of it: behind a question little is known.
                size <= INSTRUCTIONS_MAX && loop_heads(&block.code).len() <= LOOPS_MAX && plans[index].weight <= WEIGHT_MAX
            };
            if fits && has_an_end {
                plans[index].inlined = Some(size);
            }
        }
    }
    for index in (0..blocks.len()).filter(|&index| !decided[index]) {
        plans[index] = reach(&plans, blocks, index, &callees[index]);
    }
    plans
}

/// IR instructions of all blocks, with all that may become part of them.
pub(super) fn instructions_max(blocks: &[Native], find: Find<'_>, plans: &[InlinePlan]) -> usize {
    let inlined = |&callee: &usize| plans[callee].inlined;
    let each = blocks.iter().zip(callees(blocks, find)).map(|(block, callees)| {
        let growth = callees.iter().filter_map(inlined).fold(0, usize::saturating_add);
        block.code.insts.len() + growth.min(2 * GROWTH_MAX)
    });
    each.sum()
}

/// Whether a block is handed pointers, as parameters or in its instance, or goes where others lead that it computes.
fn takes_pointers(code: &Code) -> bool {
    let crosses = |place: &Place| matches!(place, Place::Crossing { .. });
    code.insts.iter().any(|inst| match inst {
        Inst::Parameter { .. } => true,
        Inst::Load { place, .. } | Inst::Store { place, .. } => crosses(place),
        Inst::Move { from, to, .. } => crosses(from) || crosses(to),
        _ => false,
    })
}

/// The plan of a block that is not inlined itself.
fn reach(plans: &[InlinePlan], blocks: &[Native], index: usize, callees: &[usize]) -> InlinePlan {
    let own = &blocks[index].code;
    let own = InlinePlan {
        loops: !loop_heads(own).is_empty() || !blocks[index].iterations().is_empty(),
        is_long: natural_loops::instructions_beside(own) > BESIDE_LOOPS_MAX,
        with_pointers: takes_pointers(own),
        weight: i64::from(blocks[index].weight()) + blocks[index].iterations().iter().map(UnrolledLoop::weight_of_all).sum::<i64>(),
        ..InlinePlan::default()
    };
    callees.iter().fold(own, |all, &callee| {
        let inner = if plans[callee].inlined.is_some() { plans[callee] } else { InlinePlan::default() };
        InlinePlan {
            inlined: None,
            depth: all.depth.max(1 + inner.depth),
            local: all.local.max(blocks[callee].local_size as usize + inner.local),
            loops: all.loops || inner.loops,
            is_long: all.is_long,
            with_pointers: all.with_pointers,
            weight: all.weight.saturating_add(inner.weight),
        }
    })
}

/// A block that waits for one that is inlined in it.
pub(super) struct InlineFrame {
    index: usize,
    statement: u32,
    /// The call.
    inst: u32,
    arrivals: FxHashMap<u32, MergeState>,
    /// A loop that calls a block keeps nothing in registers for it but the budget.
    loops: Vec<NaturalLoop>,
    /// Those of the called block are others in each place where it is called.
    at_once: Vec<(u32, u32)>,
    promoted: Vec<Promoted>,
    ranges: Ranges,
    /// Pointers in the instance of the called block.
    elements: Vec<Fact>,
    passed: Vec<Val>,
    given: Vec<Val>,
    restored: [Val; RESTORED.len()],
    instance: Val,
    written: u32,
    in_range: Option<Instance>,
    reliance: Reliance,
    local_offset: i32,
    parameters_end: usize,
}

impl InlineFrame {
    /// What the code behind the call relies on.
    pub(super) fn facts_over_call(&self) -> impl Iterator<Item = &Fact> {
        self.ranges.facts_over_call(self.inst).iter().chain(&self.elements)
    }

    /// How the block is relied on, and how the called one is, if that is looked at alone.
    pub(super) fn reliance_on_called(&self, alone: Option<&SymbolicSummary>) -> Reliance {
        match self.reliance {
            _ if self.ranges.is_kept(self.inst) => Reliance::OnFacts,
            Reliance::None => Reliance::None,
            // Nothing is known here of the pointers that count.
            _ if alone.is_some_and(|alone| alone.is_kept(self.inst)) => Reliance::OnSilence,
            _ => Reliance::None,
        }
    }

    /// Whether nobody may be asked while the block runs.
    pub(super) fn needs_silence(&self) -> bool {
        self.reliance == Reliance::OnSilence
    }

    /// What is known before the call.
    pub(super) fn facts_at_call(&self) -> impl Iterator<Item = &Fact> {
        self.ranges.facts_at_call(self.inst).iter().chain(&self.elements)
    }

    /// What AR2 holds in the call.
    pub(super) fn instance(&self) -> Option<Interval> {
        self.ranges.instance(self.inst)
    }

    /// The block, the statement that calls, the call, and where its local data begin.
    pub(super) fn call(&self) -> (usize, u32, u32, i32) {
        (self.index, self.statement, self.inst, self.local_offset)
    }

    /// The block, and the statement that calls.
    pub(super) fn place(&self) -> (usize, u32) {
        (self.index, self.statement)
    }

    /// Whether the call is in a loop.
    pub(super) fn is_in_loop(&self) -> bool {
        self.loops.iter().any(|it| it.contains(self.statement))
    }
}

impl Translator<'_> {
    /// Whether a call of this block becomes its code.
    pub(super) fn inlines(&self, code: usize) -> bool {
        let plan = &self.plans[code];
        // What becomes part of a block that became part of this function is counted with that.
        self.inlines_at_all() && plan.inlined.is_some() && (!self.outer.is_empty() || self.has_room_for(CodeGrowth::default().with(plan)))
    }

    /// Whether the function may grow by this, too.
    fn has_room_for(&self, more: CodeGrowth) -> bool {
        let own = self.outer.first().map_or(self.index, |outermost| outermost.index);
        let most = (self.blocks[own].code.insts.len() * GROWTH + GROWTH_MIN).min(GROWTH_MAX);
        self.grown.others + more.others <= most && self.grown.with_pointers + more.with_pointers <= GROWTH_MAX
    }

    fn inlines_at_all(&self) -> bool {
        // Code that has to be there at once is for the time until better code is there.
        let quick = !self.options.optimize && !self.options.exact;
        self.options.inline && !quick
    }

    /// Whether each call of the present block, which is still to be written, becomes its code if the called block can.
    pub(super) fn inlines_all_calls(&self) -> bool {
        let called = |inst: &Inst| match inst {
            Inst::Call { callee: Callee::Block(id), .. } => (self.find)(*id).map(|code| &self.plans[code as usize]),
            _ => None,
        };
        let all = self.native().code.insts.iter().filter_map(called).fold(CodeGrowth::default(), CodeGrowth::with);
        self.inlines_at_all() && (!self.outer.is_empty() || self.has_room_for(all))
    }

    /// Looks at the beginning of a function whether all that it calls itself has room. If not, the interpreter goes on, which looks at
    /// each call. Who enters an organization block has looked before.
    pub(super) fn look_for_room(&mut self) {
        let InlinePlan { depth, local, .. } = self.plans[self.index];
        if depth == 0 || !self.called_only() {
            return;
        }
        let link = self.b.ins().iadd_imm_u(self.link, (depth * size_of::<Link>()) as i64);
        let local = self.native().local_size as usize + local;
        let end = self.b.ins().iadd_imm_u(self.local, local as i64);
        let link_max = self.load_run(offset_of!(Run<'_, '_>, link_max));
        let local_end = self.load_run(offset_of!(Run<'_, '_>, local_end));
        let too_deep = self.b.ins().icmp(IntCC::UnsignedGreaterThan, link, link_max);
        let too_long = self.b.ins().icmp(IntCC::UnsignedGreaterThan, end, local_end);
        let no_room = self.b.ins().bor(too_deep, too_long);
        let code = self.b.ins().iconst(I64, self.index as i64);
        let statement = self.first_named(0);
        let statement = self.b.ins().iconst(I64, i64::from(statement));
        self.unless_failed(no_room, RuntimeCall::Interpret, &[self.link, code, statement], Continuation::Never);
    }

    /// Where the local data of a block that is called now begin, from those of the outermost block of this function, in bytes.
    pub(super) fn local_behind(&self) -> i64 {
        i64::from(self.local_offset) + i64::from(self.native().local_size)
    }

    /// Address behind the parameters of the block that is written now.
    pub(super) fn own_parameters_end(&mut self) -> Value {
        let end = self.b.ins().load(I64, TRUSTED, self.link, offset_of!(Link, parameters_end) as i32);
        if self.parameters_end == 0 { end } else { self.b.ins().iadd_imm_u(end, 4 * self.parameters_end as i64) }
    }

    /// Writes the code of a called block in place of the call.
    pub(super) fn call_inlined(&mut self, index: u32, code: usize, parameters: usize) {
        if self.outer.is_empty() {
            self.grown = self.grown.with(&self.plans[code]);
        }
        let restored = RESTORED.map(|register| {
            let value = self.register(register);
            self.force(value)
        });
        for &(register, value) in AT_CALL {
            self.set_register(register, Val::Const(value));
        }
        let instance = self.register(Register::Ar2);
        let parameters_end = self.parameters_end + self.passed.len();
        let given = self.passed.split_off(self.passed.len().saturating_sub(parameters));
        let local_offset = self.local_behind() as i32;
        let promoted = self.keep_in_block();
        let at_call = self.ranges.instance(index);
        let inside = self.find_loops(code);
        let loops = std::mem::replace(&mut self.loops, inside);
        self.outer.push(InlineFrame {
            index: self.index,
            statement: self.statement,
            inst: index,
            arrivals: std::mem::take(&mut self.arrivals),
            loops,
            at_once: std::mem::take(&mut self.at_once),
            promoted,
            ranges: std::mem::take(&mut self.ranges),
            elements: Vec::new(),
            passed: std::mem::take(&mut self.passed),
            given: std::mem::replace(&mut self.given, given),
            restored,
            instance: self.instance,
            written: self.written,
            in_range: self.in_range,
            reliance: self.reliance,
            local_offset: self.local_offset,
            parameters_end: self.parameters_end,
        });
        (self.index, self.local_offset, self.parameters_end) = (code, local_offset, parameters_end);
        self.instance = instance;
        self.written = self.written_in_block();
        self.in_range = self.instance_in_range(at_call);
        self.know_elements();
        self.statement = 0;
        for to in loop_heads(&self.native().code) {
            self.expect_way_back(to);
        }
        self.ranges = self.find_ranges();
        self.rely_on_block();
        self.enter_block();
        self.take_arena();
        self.statements();
        self.leave_interpreted();
        let Some(outer) = self.outer.pop() else { unreachable!("it was pushed above") };
        let written = self.summaries[code].written;
        (self.index, self.statement, self.arrivals) = (outer.index, outer.statement, outer.arrivals);
        (self.loops, self.promoted, self.ranges) = (outer.loops, outer.promoted, outer.ranges);
        self.at_once = outer.at_once;
        (self.passed, self.given) = (outer.passed, outer.given);
        (self.instance, self.in_range, self.written) = (outer.instance, outer.in_range, outer.written);
        self.reliance = outer.reliance;
        (self.local_offset, self.parameters_end) = (outer.local_offset, outer.parameters_end);
        self.drop_what_waits_behind();
        for (register, value) in RESTORED.into_iter().zip(outer.restored) {
            if !OPEN_BLOCKS.contains(&register) || written & bit_of(register) != 0 {
                self.set_register(register, value);
            }
        }
        for (register, value) in AFTER_CALL {
            self.set_register(register, Val::Const(value));
        }
        if written & bit_of(Register::Ar2) != 0 && self.pointers[code].kept {
            self.set_register(Register::Ar2, instance);
        }
    }

    /// Notes what is known of the instance of the block that begins now.
    fn know_elements(&mut self) {
        let Some(InlineFrame { ranges, inst, .. }) = self.outer.last() else { return };
        let elements = ranges.elements(*inst).to_vec();
        if elements.is_empty() {
            return;
        }
        let (base, first) = self.instance_base();
        let fact = |(offset, width, range)| Fact { variable: (base, first + (offset / 8) as i32, width), range };
        let facts = elements.into_iter().map(fact).collect();
        if let Some(outer) = self.outer.last_mut() {
            outer.elements = facts;
        }
    }

    /// All registers that the present block may change.
    fn written_in_block(&self) -> u32 {
        let written = |inst: &Inst| if matches!(inst, Inst::Call { .. }) { ALL } else { natural_loops::written(inst) };
        self.native().code.insts.iter().fold(0, |all, inst| all | written(inst))
    }

    /// The link of the block that is written now, for an observer: those of inlined blocks are written first.
    pub(super) fn shown_link(&mut self) -> Value {
        if self.outer.is_empty() {
            return self.link;
        }
        let end = self.b.ins().load(I64, TRUSTED, self.link, offset_of!(Link, parameters_end) as i32);
        for level in 1..=self.outer.len() {
            let (code, given, local_offset, parameters_end) = match self.outer.get(level) {
                Some(outer) => (outer.index, outer.given.clone(), outer.local_offset, outer.parameters_end),
                None => (self.index, self.given.clone(), self.local_offset, self.parameters_end),
            };
            let InlineFrame { index: caller, inst, restored, .. } = self.outer[level - 1];
            let site = self.blocks[caller].named_inst(inst);
            let first_given = parameters_end - given.len();
            let code = self.b.ins().iconst(I64, code as i64);
            let site = self.b.ins().iconst(I64, i64::from(site));
            let local = self.b.ins().iadd_imm_u(self.local, i64::from(local_offset));
            let first = self.b.ins().iadd_imm_u(end, 4 * first_given as i64);
            let last = self.b.ins().iadd_imm_u(end, 4 * parameters_end as i64);
            let mut fields = vec![
                (code, offset_of!(Link, code)),
                (site, offset_of!(Link, site)),
                (local, offset_of!(Link, local)),
                (first, offset_of!(Link, parameters)),
                (last, offset_of!(Link, parameters_end)),
            ];
            for (value, offset) in restored.into_iter().zip(KEPT_IN) {
                fields.push((self.word(value), offset));
            }
            for (value, offset) in fields {
                self.b.ins().store(TRUSTED, value, self.link, (level * size_of::<Link>() + offset) as i32);
            }
            for (index, pointer) in given.into_iter().enumerate() {
                let pointer = self.int(pointer);
                self.b.ins().store(TRUSTED, pointer, end, 4 * (first_given + index) as i32);
            }
        }
        self.b.ins().iadd_imm_u(self.link, (self.outer.len() * size_of::<Link>()) as i64)
    }

    /// The local data of the caller, as bytes behind the local data of the outermost block of this function: first and number. `None` = the
    /// caller is another function.
    pub(super) fn caller_local(&self, calls: usize) -> Option<(i32, usize)> {
        let level = self.outer.len().checked_sub(1 + calls)?;
        let caller = &self.outer[level];
        Some((caller.local_offset, self.blocks[caller.index].local_size as usize))
    }

    /// Where a pointer to the local data of a caller goes, if that caller is in this function: byte behind the local data of its outermost
    /// block, and bit. Not if the access would fail.
    pub(super) fn way_to_caller(&self, position: u32, width: Width) -> Option<(i32, u8)> {
        let caller = self.caller_local((position >> CALLS_SHIFT) as usize)?;
        way_into(position, width, caller)
    }
}

/// Where a pointer to the local data of a caller goes: first byte and number of bytes of these are known.
pub(super) fn way_into(position: u32, width: Width, (first, bytes): (i32, usize)) -> Option<(i32, u8)> {
    let (byte, bit) = ((position & CALLS_MASK) / 8, (position % 8) as u8);
    let inside = byte as usize + width.bytes() as usize <= bytes;
    (inside && (width == Width::Bit || bit == 0)).then_some((first + byte as i32, bit))
}
