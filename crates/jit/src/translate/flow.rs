//! Merges of the control-flow graph: what is available where paths arrive at a statement, and the safe points on them.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{self as clif, InstBuilder, Value};
use rustc_hash::FxHashMap;
use sieben_engine::ir::{Target, Var};
use sieben_engine::machine::Register;

use super::natural_loops::NaturalLoop;
use super::status_liveness::restored;
use super::store_merging::AvailableMemory;
use super::value::Val;
use super::{Translator, bit_of};
use crate::runtime_calls::RuntimeCall;

/// What is known where control flow arrives at a statement.
pub(super) struct MergeState {
    pub(super) block: clif::Block,
    /// Where the ways from behind it arrive, if it is the head of a loop: `block` is before the loop then.
    pub(super) again: Option<clif::Block>,
    /// Some way here comes from behind it.
    pub(super) backward: bool,
    /// Registers whose memory may be older than their variable.
    pub(super) dirty: u32,
    /// Registers that hold a constant on every way here; `None` until one is known.
    pub(super) known: Option<[Option<u64>; Register::COUNT]>,
    /// What is known of memory on every way here; `None` until one is known.
    pub(super) memory: Option<AvailableMemory>,
    /// What the budget's variable lacks on every way here; `None` until one is known.
    pub(super) taken: Option<i64>,
    /// The look at the budget that is before every way here; `None` until one is known.
    pub(super) look: Option<Option<usize>>,
}

impl Translator<'_> {
    /// Notes that a later statement jumps back to one.
    pub(super) fn expect_way_back(&mut self, to: u32) {
        let again = self.loops.iter().any(|it| it.first == to).then(|| self.b.create_block());
        let arrival = self.arrival(to);
        arrival.backward = true;
        arrival.again = arrival.again.or(again);
        arrival.taken = Some(0);
    }

    pub(super) fn arrival(&mut self, statement: u32) -> &mut MergeState {
        let b = &mut self.b;
        self.arrivals.entry(statement).or_insert_with(|| MergeState {
            block: b.create_block(),
            again: None,
            backward: false,
            dirty: 0,
            known: None,
            memory: None,
            taken: None,
            look: None,
        })
    }

    /// The safe point at the beginning of a block.
    pub(super) fn enter_block(&mut self) {
        let weight = i64::from(self.native().weight());
        if self.is_looked_at(weight) {
            self.taken += weight;
            return;
        }
        if self.looks_at_the_beginning() {
            return self.enter_and_look(weight);
        }
        let go_on = self.b.create_block();
        let variable = self.budget();
        let budget = self.b.use_var(variable);
        self.taken += weight;
        let used_up = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, budget, self.taken);
        self.ask_if_used_up(used_up, 0, go_on, go_on);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
        self.forget_what_was_asked();
    }

    /// Takes the weight of a safe point from the budget, asks the Host if it is used up, and goes on at `go_on`, or at `asked` if the
    /// Host was asked.
    pub(super) fn count_down(&mut self, weight: u16, statement: u32, go_on: clif::Block, asked: clif::Block) {
        self.taken += i64::from(weight);
        self.take_from_budget(self.taken);
        let variable = self.budget();
        let left = self.b.use_var(variable);
        if let Some(iteration) = self.iteration_of(statement) {
            return self.look_at_next_iteration(iteration, left, go_on);
        }
        let used_up = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, left, 0);
        self.ask_if_used_up(used_up, statement, go_on, asked);
    }

    /// Asks the Host on a condition, before a statement, and goes on at `go_on`, or at `asked` if the Host was asked.
    fn ask_if_used_up(&mut self, used_up: Value, statement: u32, go_on: clif::Block, asked: clif::Block) {
        let ask = self.cold_block();
        self.b.ins().brif(used_up, ask, &[], go_on, &[]);
        self.ask_at_safe_point(ask, statement, asked);
    }

    /// Fills a cold block that asks the Host at a safe point before a statement, and goes on at `asked`.
    pub(super) fn ask_at_safe_point(&mut self, ask: clif::Block, statement: u32, asked: clif::Block) {
        self.b.switch_to_block(ask);
        self.b.seal_block(ask);
        let before = self.cold.replace(ask);
        self.spill(self.dirty);
        let code = self.b.ins().iconst(I64, self.index as i64);
        let statement_of_head = statement;
        // The interpreter names the first statement that does something.
        let statement = self.first_named(statement);
        let statement = self.b.ins().iconst(I64, i64::from(statement));
        let answer = self.ask(RuntimeCall::SafePoint, &[self.link, code, statement]);
        self.cold = before;
        let asked = self.verified(statement_of_head, asked);
        self.b.ins().brif(answer, self.leave, &[], asked, &[]);
        self.write_verifications();
    }

    /// Where a loop goes on behind a safe point at which the Host was asked: with a new budget, iterations can be done at once again.
    fn behind_question(&self, to: u32, arrival: clif::Block) -> clif::Block {
        let begins = self.at_once.iter().any(|&(first, _)| first == to);
        self.arrivals.get(&to).filter(|it| begins && it.again == Some(arrival)).map_or(arrival, |it| it.block)
    }

    /// The number in the program of the first statement, from one on, that does something.
    pub(super) fn first_named(&self, statement: u32) -> u32 {
        self.first_named_in(self.index, statement)
    }

    /// The same in another block.
    pub(super) fn first_named_in(&self, index: usize, statement: u32) -> u32 {
        self.blocks[index].named(self.first_with_code_in(index, statement))
    }

    /// The first statement of a block, from one on, that does something.
    pub(super) fn first_with_code_in(&self, index: usize, statement: u32) -> u32 {
        let code = &self.blocks[index].code;
        (statement as usize..code.statement_count()).find(|&index| !code.statement(index).is_empty()).unwrap_or(0) as u32
    }

    /// A block for what happens seldom. Memory is as the program left it there.
    pub(super) fn cold_block(&mut self) -> clif::Block {
        self.store_waiting();
        let block = self.b.create_block();
        self.b.set_cold_block(block);
        block
    }

    /// Begins a piece of code at a statement, if something arrives there.
    pub(super) fn arrive(&mut self) {
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
        self.take_arena();
        let arrival = self.arrival(statement);
        let (memory, backward, taken, look) = (arrival.memory.take(), arrival.backward, arrival.taken, arrival.look);
        (self.taken, self.look) = (taken.unwrap_or(0), look.flatten());
        let mut known_in_front = None;
        match memory {
            Some(memory) if !backward => self.know_memory(memory),
            memory => {
                known_in_front = memory;
                self.forget_memory();
            }
        }
        self.changed = 0;
        self.current = known.map(|value| value.map(Val::Const));
        self.dirty = dirty;
        self.ended = false;
        if !self.arrivals[&statement].backward {
            self.know_instance_again();
            self.b.seal_block(block);
            return;
        }
        self.look = None;
        // A register that nothing in the loop changes is what it was before it.
        let inside = |it: &&NaturalLoop| it.contains(statement);
        let smallest = self.loops.iter().filter(inside).min_by_key(|it| it.last - it.first).cloned();
        let (written, touched) = smallest.as_ref().map_or((self.written, self.written), |it| (it.written, it.touched));
        for &register in Register::ALL {
            if written & bit_of(register) != 0 {
                self.current[register as usize] = None;
            }
        }
        self.know_instance_again();
        // What is entered in the middle may be reached by a way on which less was stored.
        let changed = match &smallest {
            // What a call restores is in memory as the called block had it, if somebody was asked there.
            Some(it) if again.is_some() && !it.calls_nothing => (touched | restored()) & self.written,
            _ if again.is_some() => touched & self.written,
            _ => self.written,
        };
        self.dirty |= changed & !self.dead_at(statement);
        if let Some(head) = again {
            // A loop that keeps lengths has no other one inside: it has ended.
            self.kept_lengths.clear();
            // Behind a safe point the loop may begin again: see `behind_question`.
            let mut idle = None;
            if let Some(it) = smallest {
                self.promote(&it);
                if let Some(known) = known_in_front {
                    self.know_in_loop(&it, known);
                }
                let words = self.words.clone();
                idle = self.iterations_at_once(&it);
                self.words = words;
                self.look_at_iteration(&it);
                if idle.is_none() && !self.is_at_once(&it) {
                    self.keep_lengths_in(&it);
                }
            }
            self.b.ins().jump(head, &[]);
            self.b.switch_to_block(head);
            if let Some(idle) = idle {
                self.pass_idle_iterations(&idle);
            }
            self.know_kept_lengths(statement);
        }
    }

    /// Makes the variables current and returns where the statement begins; the caller jumps there.
    pub(super) fn edge(&mut self, statement: u32) -> clif::Block {
        self.drop_what_was_taken();
        self.store_waiting();
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
            self.tell_kept_lengths(statement);
            return head;
        }
        self.meet_budget(statement);
        let (memory, look) = (self.known_memory(), self.look);
        if self.cold.is_none() {
            self.hold_what_is_known();
        }
        let arrival = self.arrival(statement);
        match &mut arrival.memory {
            Some(common) => common.meet(&memory),
            None => arrival.memory = Some(memory),
        }
        arrival.look = Some(arrival.look.map_or(look, |other| look.filter(|_| other == look)));
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

    /// Where a jump goes: the statement itself, or the safe point before it if it lies behind.
    pub(super) fn way_to(&mut self, Target(to): Target) -> clif::Block {
        let arrival = self.edge(to);
        if to > self.statement && !self.leaves_loop(to) {
            return arrival;
        }
        let way = self.b.create_block();
        self.ways.push((way, to, arrival));
        way
    }

    /// Fills the safe points on the ways back, after the jump that goes there.
    pub(super) fn fill_ways(&mut self) {
        for (way, to, arrival) in std::mem::take(&mut self.ways) {
            self.b.switch_to_block(way);
            self.b.seal_block(way);
            let taken = self.taken;
            self.leave_loops(to);
            if to > self.statement {
                self.b.ins().jump(arrival, &[]);
                continue;
            }
            let weight = self.native().weight_of_jump((self.statement, to));
            // Who is asked there finds what the loops around both keep.
            let from = std::mem::replace(&mut self.statement, to);
            let look = self.look.take();
            let asked = self.behind_question(to, arrival);
            self.count_down(weight, to, arrival, asked);
            (self.statement, self.taken, self.look) = (from, taken, look);
        }
    }

    pub(super) fn jump_table(&mut self, index: Var, first: u32, count: u32, otherwise: Target) {
        let index = self.get(index);
        let index = self.force(index);
        let targets = &self.native().code.tables[first as usize..(first + count) as usize];
        let mut blocks: FxHashMap<u32, clif::Block> = FxHashMap::default();
        // Ways lead to places where the budget's variable lacks different weights.
        self.take_from_budget(self.taken);
        let mut lacking = Vec::new();
        let mut block_of = |this: &mut Self, target: Target| {
            if let Some(&block) = blocks.get(&target.0) {
                return block;
            }
            let lacks = this.arrivals.get(&target.0).and_then(|arrival| arrival.taken).unwrap_or(0);
            this.taken = lacks;
            let mut block = this.way_to(target);
            this.taken = 0;
            if lacks != 0 {
                let way = this.b.create_block();
                lacking.push((way, lacks, block));
                block = way;
            }
            blocks.insert(target.0, block);
            block
        };
        let otherwise = block_of(self, otherwise);
        let entries: Vec<clif::Block> = targets.iter().map(|&target| block_of(self, target)).collect();
        let index = match index {
            // The table looks at it itself.
            Val::Int(index) => index,
            index => {
                let index = self.word(index);
                let inside = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, index, i64::from(count));
                let beyond = self.b.ins().iconst(I64, i64::from(count));
                let index = self.b.ins().select(inside, index, beyond);
                self.b.ins().ireduce(I32, index)
            }
        };
        let default = self.b.func.dfg.block_call(otherwise, &[]);
        let entries: Vec<_> = entries.into_iter().map(|block| self.b.func.dfg.block_call(block, &[])).collect();
        let table = self.b.create_jump_table(clif::JumpTableData::new(default, &entries));
        self.b.ins().br_table(index, table);
        for (way, lacks, block) in lacking {
            self.b.switch_to_block(way);
            self.b.seal_block(way);
            self.take_from_budget(-lacks);
            self.taken = 0;
            self.b.ins().jump(block, &[]);
        }
        self.fill_ways();
        self.ended = true;
    }
}
