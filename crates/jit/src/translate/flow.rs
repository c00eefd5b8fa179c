//! Where control flow arrives at a statement, what is known there, and the safe points on the ways to it.

use std::collections::HashMap;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{self as clif, InstBuilder};
use sieben_engine::interpreter::weight;
use sieben_engine::ir::{Target, Var};
use sieben_engine::machine::Register;

use super::loops::Loop;
use super::value::Val;
use super::{Translator, bit_of};
use crate::ask::Question;

/// What is known where control flow arrives at a statement.
pub(super) struct Arrival {
    pub(super) block: clif::Block,
    /// Where the ways from behind it arrive, if it is the head of a loop: `block` is in front of the loop then.
    pub(super) again: Option<clif::Block>,
    /// Some way here comes from behind it.
    pub(super) backward: bool,
    /// Registers whose memory may be older than their variable.
    pub(super) dirty: u32,
    /// Registers that hold a constant on every way here; `None` until one is known.
    pub(super) known: Option<[Option<u64>; Register::COUNT]>,
}

impl Translator<'_> {
    /// Notes that a later statement jumps back to one.
    pub(super) fn expect_way_back(&mut self, to: u32) {
        let again = self.loops.iter().any(|it| it.first == to).then(|| self.b.create_block());
        let arrival = self.arrival(to);
        arrival.backward = true;
        arrival.again = arrival.again.or(again);
    }

    pub(super) fn arrival(&mut self, statement: u32) -> &mut Arrival {
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
    pub(super) fn enter_block(&mut self) {
        let weight = weight(self.native().code.statement_count());
        let go_on = self.b.create_block();
        self.count_down(weight, 0, go_on, go_on);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
    }

    /// Takes the weight of a safe point from the budget, asks the Host if it is used up, and goes on at `go_on`, or at `asked` if the
    /// Host was asked.
    pub(super) fn count_down(&mut self, weight: u16, statement: u32, go_on: clif::Block, asked: clif::Block) {
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
        let asked = self.verified(statement_of_head, asked);
        self.b.ins().brif(answer, self.leave, &[], asked, &[]);
        self.write_verifications();
    }

    /// Where a loop goes on behind a safe point at which the Host was asked: with a new budget, turns can be done at once again.
    fn behind_question(&self, to: u32, arrival: clif::Block) -> clif::Block {
        let begins = self.at_once.iter().any(|&(index, first, _)| (index, first) == (self.index, to));
        self.arrivals.get(&to).filter(|it| begins && it.again == Some(arrival)).map_or(arrival, |it| it.block)
    }

    pub(super) fn first_with_code(&self, statement: u32) -> u32 {
        let code = &self.native().code;
        (statement as usize..code.statement_count()).find(|&index| !code.statement(index).is_empty()).unwrap_or(0) as u32
    }

    /// A block for what happens seldom. Memory is as the program left it there.
    pub(super) fn cold_block(&mut self) -> clif::Block {
        self.settle_bytes();
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
            // Behind a safe point the loop may begin anew: see `behind_question`.
            if let Some(it) = smallest {
                self.promote(&it);
                self.turns_at_once(&it);
            }
            self.b.ins().jump(head, &[]);
            self.b.switch_to_block(head);
        }
    }

    /// Makes the variables current and returns where the statement begins; the caller jumps there.
    pub(super) fn edge(&mut self, statement: u32) -> clif::Block {
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

    /// Where a jump goes: the statement itself, or the safe point in front of it if it lies behind.
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
            self.leave_loops(to);
            if to > self.statement {
                self.b.ins().jump(arrival, &[]);
                continue;
            }
            let weight = weight((self.statement - to) as usize);
            // Who is asked there finds what the loops around both keep.
            let from = std::mem::replace(&mut self.statement, to);
            let asked = self.behind_question(to, arrival);
            self.count_down(weight, to, arrival, asked);
            self.statement = from;
        }
    }

    pub(super) fn jump_table(&mut self, index: Var, first: u32, count: u32, otherwise: Target) {
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
