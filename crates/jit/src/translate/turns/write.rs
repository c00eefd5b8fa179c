//! Writes turns of a loop that nobody looks at between them.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{Block, BlockArg, InstBuilder, Value};
use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::super::Translator;
use super::super::loops::Loop;
use super::super::promote::Base;
use super::super::value::Val;
use super::alike::Alike;
use super::count::Progress;
use super::divide::greatest;
use super::handed::Handed;
use super::kernel::{Access, Cell, Kept, Kernel, Level, Node, Step, What};
use super::line::{Carried, Line, Sum};
use super::pieces::{self, Gathered, Piece, Place};
use super::records::Records;
use super::spread::Apart;
use super::vector::Lanes;
use super::{Plan, Writes};

/// What one of the loops has while its turns are written.
#[derive(Clone, Default)]
pub(super) struct Scope {
    pub(super) values: HashMap<Node, Lanes>,
    /// What cells hold when a turn begins.
    pub(super) starts: HashMap<Cell, Lanes>,
    /// Addresses that are counted on, by their pointers and offsets.
    pub(super) addresses: HashMap<(Base, Node, u32), Value>,
    /// Bytes of which one bit was read or written, by their addresses and accesses to them: one of each turn, or vectors of them.
    pub(super) bytes: Vec<(Value, i32, usize, Vec<Value>)>,
    /// Where turns side by side have read what lies apart, by the accesses.
    pub(super) sources: Vec<(usize, Apart)>,
}

/// Writes one version of the turns of a loop.
pub(super) struct Writing<'t, 'a, 'k> {
    pub(super) t: &'t mut Translator<'a>,
    pub(super) plan: &'k Plan,
    pub(super) kernel: &'k Kernel,
    /// Turns side by side.
    pub(super) lanes: u32,
    /// Accesses whose bits make whole bytes, if eight turns are written behind one another.
    pub(super) gathered: Option<Gathered>,
    /// Those that make whole bytes in turns behind these ones: single turns are made up to the first bit of a byte.
    up_to: Option<Gathered>,
    /// How turns side by side are done that all go the same way.
    pub(super) alike: Option<&'k Alike>,
    /// Which of these turns is written, and their bytes so far.
    pub(super) turn: u32,
    pub(super) pieces: BTreeMap<Place, Piece>,
    /// Structures and instances whose fields are read and written together.
    pub(super) records: Records,
    pub(super) outer: Scope,
    pub(super) inner: Scope,
    /// What was written since the running turns began.
    pub(super) written: Vec<usize>,
    /// What single turns of those side by side have made.
    pub(super) in_lanes: HashMap<(Node, u32), Val>,
    /// What cells hold in front of the loop.
    pub(super) before: HashMap<Cell, Val>,
    sums: HashMap<Cell, Vec<Value>>,
    /// Choices that leave the less or greater of two REALs or LREALs for the next turn.
    pub(super) extremes: BTreeSet<Node>,
    /// What blocks have taken from the budget that not all turns enter.
    pub(super) taken: Option<Val>,
    /// How many turns the inner loop makes in each turn of the outer one.
    pub(super) inner_turns: Option<Value>,
    /// How many turns of the outer loop are made, and where it is.
    progress: Option<(Value, Progress)>,
}

impl<'t, 'a, 'k> Writing<'t, 'a, 'k> {
    /// Writes turns, as many as there are and as nobody asks about, and goes on where more turns may follow. Goes to the statement
    /// behind the loop if there are none.
    pub(super) fn write(t: &'t mut Translator<'a>, plan: &'k Plan, it: &Loop, writes: Writes<'k>) {
        Self::new(t, plan, writes).version(it);
    }

    pub(super) fn new(t: &'t mut Translator<'a>, plan: &'k Plan, Writes { lanes, gathered, up_to, alike }: Writes<'k>) -> Self {
        let kernel = &plan.kernel;
        Writing {
            t,
            plan,
            kernel,
            lanes,
            gathered,
            up_to,
            alike,
            turn: 0,
            pieces: BTreeMap::new(),
            records: kernel.records(lanes),
            outer: Scope::default(),
            inner: Scope::default(),
            written: Vec::new(),
            in_lanes: HashMap::new(),
            before: HashMap::new(),
            sums: HashMap::new(),
            extremes: BTreeSet::new(),
            taken: None,
            inner_turns: None,
            progress: None,
        }
    }

    fn version(&mut self, it: &Loop) {
        self.t.settle_bytes();
        self.take_before();
        let (turns, guard, all) = self.how_many();
        let [enter, go_on] = [self.t.b.create_block(), self.t.b.create_block()];
        self.t.b.ins().brif(guard, enter, &[], go_on, &[]);
        self.t.b.switch_to_block(enter);
        self.t.b.seal_block(enter);
        self.read_ahead();
        let done = self.turns(Level::Outer, turns);
        debug_assert!(done.is_empty() || self.lanes > 1);
        self.finish(turns);
        self.leave_whole(it, (turns, all), go_on);
    }

    /// Takes what cells hold in front of the loop.
    fn take_before(&mut self) {
        for cell in self.kernel.cells_at_start() {
            let value = self.t.cell_before(self.kernel, cell);
            self.before.insert(cell, value);
        }
    }

    /// Takes turns from the budget and goes where more turns may follow, or behind the loop if these were all.
    fn leave_whole(&mut self, it: &Loop, (turns, all): (Value, Value), go_on: Block) {
        let weight = i64::from(self.kernel.outer.weight);
        let left = self.take_budget(turns);
        let budget = self.t.budget();
        let ended = self.t.b.ins().icmp(IntCC::Equal, turns, all);
        let leave = self.t.b.create_block();
        self.t.b.def_var(budget, left);
        self.t.b.ins().brif(ended, leave, &[], go_on, &[]);
        self.t.leave_behind(it, leave, left, weight);
        self.t.b.switch_to_block(go_on);
        self.t.b.seal_block(go_on);
        self.t.forget_memory();
    }

    /// How many turns are made here, whether any are, and how many the loop has.
    fn how_many(&mut self) -> (Value, Value, Value) {
        let count = self.plan.count;
        let counter = self.value_before(count.counter);
        let limit = count.limit.map_or(Val::Const(0), |limit| self.value_before(limit));
        let (all, inside) = self.t.turns(count, counter, limit);
        let inner_inside = self.count_inner_turns();
        let [_, most] = self.weights();
        let turns = self.t.within_budget(all, most);
        let turns = match self.lanes * self.behind_one_another() {
            1 => turns,
            together => self.t.b.ins().band_imm_s(turns, -i64::from(together)),
        };
        let turns = match self.up_to.take() {
            Some(pieces) => self.turns_up_to_byte(&pieces, turns),
            None => turns,
        };
        let mut guard = self.t.b.ins().icmp_imm_s(IntCC::SignedGreaterThan, turns, 0);
        let mut also = |this: &mut Self, condition: Value| guard = this.t.b.ins().band(guard, condition);
        for inside in [inside, inner_inside].into_iter().flatten() {
            also(self, inside);
        }
        for &cell in self.before.clone().keys() {
            let line = self.kernel.cell_line(Level::Outer, cell);
            if line.is_some_and(|line| line.bits == 16) && matches!(self.kernel.kept(cell), Kept::Register(_)) {
                let value = self.before[&cell];
                let value = self.t.int(value);
                let short = self.t.b.ins().icmp_imm_u(IntCC::UnsignedLessThanOrEqual, value, 0xFFFF);
                also(self, short);
            }
        }
        for access in self.kernel.accesses.iter().filter(|access| !access.sure) {
            let inside = self.stays_inside(access, turns);
            also(self, inside);
        }
        for begins in self.pieces_begin_bytes() {
            also(self, begins);
        }
        for &(number, limit) in &self.kernel.required {
            let stays_below = self.stays_below((number, Level::Outer), limit, turns);
            also(self, stays_below);
        }
        for &(condition, holds) in &self.kernel.settled {
            let condition = self.value_before(condition);
            let condition = self.t.flag(condition);
            let is_so = self.t.b.ins().icmp_imm_u(IntCC::Equal, condition, i64::from(holds));
            also(self, is_so);
        }
        let guard = self.look_at_numbers(turns, guard);
        (turns, guard, all)
    }

    /// Turns that are written behind one another.
    fn behind_one_another(&self) -> u32 {
        if self.gathered.is_some() { pieces::TURNS } else { 1 }
    }

    /// Whether a number on a line of a loop stays below a limit for so many turns of it.
    pub(super) fn stays_below(&mut self, (number, level): (Node, Level), limit: u32, turns: Value) -> Value {
        let line = self.kernel.line(number, level).unwrap_or(Line::SAME);
        let first = self.value_before(number);
        let first = self.t.int(first);
        let first = self.t.b.ins().uextend(I64, first);
        let below = self.t.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, first, i64::from(limit));
        if line.is_same() {
            return below;
        }
        let more = self.t.b.ins().iadd_imm_s(turns, -1);
        let way = self.t.b.ins().imul_imm_s(more, i64::from(line.step as i32));
        let last = self.t.b.ins().iadd(first, way);
        let last = self.t.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, last, i64::from(limit));
        self.t.b.ins().band(below, last)
    }

    /// Whether an access whose pointer is on a line stays inside its area for so many turns.
    fn stays_inside(&mut self, access: &Access, turns: Value) -> Value {
        let line = self.kernel.line(access.pointer, Level::Outer).unwrap_or(Line::SAME);
        let position = self.position_before(access.pointer, access.offset);
        let whole = self.t.b.ins().uextend(I64, position);
        // On the ways that lead to it, it may be known to go to a part of the area.
        let (_, start, length) = access.area;
        let area = 0..length as i64;
        let bytes = access.inside.as_ref().map_or(area, |inside| inside.start - i64::from(start)..inside.end - i64::from(start));
        let first = if bytes.start == 0 { whole } else { self.t.b.ins().iadd_imm_s(whole, -8 * bytes.start) };
        let more = self.t.b.ins().iadd_imm_s(turns, -1);
        let way = self.t.b.ins().imul_imm_s(more, i64::from(line.step as i32));
        let last = self.t.b.ins().iadd(first, way);
        let (low, high) = if (line.step as i32) < 0 { (last, first) } else { (first, last) };
        let bits = if access.width == Width::Bit { 1 } else { i64::from(access.width.bytes()) * 8 };
        let end = (bytes.end - bytes.start) * 8 - bits;
        let low = self.t.b.ins().icmp_imm_s(IntCC::SignedGreaterThanOrEqual, low, 0);
        let high = self.t.b.ins().icmp_imm_s(IntCC::SignedLessThanOrEqual, high, end);
        let both = self.t.b.ins().band(low, high);
        if access.width == Width::Bit {
            return both;
        }
        let odd = self.t.b.ins().band_imm_u(position, 7);
        let even = self.t.b.ins().icmp_imm_u(IntCC::Equal, odd, 0);
        self.t.b.ins().band(both, even)
    }

    /// A pointer with its offset, 24 bits, as it is in the first turn.
    pub(super) fn position_before(&mut self, pointer: Node, offset: u32) -> Value {
        let pointer = self.value_before(pointer);
        self.position(pointer, offset)
    }

    pub(super) fn position(&mut self, pointer: Val, offset: u32) -> Value {
        let pointer = self.t.int(pointer);
        let moved = if offset == 0 { pointer } else { self.t.b.ins().iadd_imm_u(pointer, i64::from(offset)) };
        self.t.b.ins().band_imm_u(moved, 0x00FF_FFFF)
    }

    /// A value as it is in the first turn of the loop, in front of it. It rests on no memory that the loop reads.
    pub(super) fn value_before(&mut self, node: Node) -> Val {
        match self.kernel.what(node) {
            What::Constant(value) => Val::Const(value),
            What::Start(Level::Outer, cell) => self.before[&cell],
            What::Start(Level::Inner, cell) => {
                let entry = self.plan.entry(cell);
                self.value_before(entry)
            }
            What::Compute(op, args) => {
                let args: Vec<Val> = args[..op.arity()].iter().map(|&arg| self.value_before(arg)).collect();
                self.t.compute_now(op, &args)
            }
            What::After(_) | What::Read(_) => unreachable!("a value on a line rests on no memory"),
        }
    }

    /// The same for the inner loop, in a turn of the outer one.
    pub(super) fn value_at_entry(&mut self, node: Node) -> Val {
        if let What::Start(Level::Inner, cell) = self.kernel.what(node) {
            let entry = self.plan.entry(cell);
            return self.first(entry, Level::Outer);
        }
        match self.kernel.what(node) {
            What::Compute(op, args) => {
                let args: Vec<Val> = args[..op.arity()].iter().map(|&arg| self.value_at_entry(arg)).collect();
                self.t.compute_now(op, &args)
            }
            _ => self.first(node, Level::Outer),
        }
    }

    /// A value of the first of the turns side by side.
    pub(super) fn first(&mut self, node: Node, level: Level) -> Val {
        match self.value(node, level) {
            Lanes::One(value) | Lanes::Line(value, _) => value,
            _ => unreachable!("addresses are on a line"),
        }
    }

    pub(super) fn scope(&mut self, level: Level) -> &mut Scope {
        match level {
            Level::Outer => &mut self.outer,
            Level::Inner => &mut self.inner,
        }
    }

    /// Writes turns of a loop; the vectors of its sums behind it.
    pub(super) fn turns(&mut self, level: Level, turns: Value) -> Vec<Value> {
        let step = if level == Level::Outer { self.lanes } else { 1 };
        let handed = self.handed(level);
        // An address that is counted on tells when the last turn was made, if it has one.
        let counting = handed.iter().enumerate().find_map(|(at, one)| match *one {
            Handed::Address(.., step) if step != 0 && level == Level::Outer && self.lanes == 1 => Some((at, step)),
            _ => None,
        });
        let mut first = if counting.is_some() { Vec::new() } else { vec![turns] };
        let others = first.len();
        for one in &handed {
            self.first_of(level, one, &mut first);
        }
        let end = counting.map(|(at, step)| {
            let way = self.t.b.ins().imul_imm_s(turns, step);
            self.t.b.ins().iadd(first[others + at], way)
        });
        let head = self.t.b.create_block();
        let arguments: Vec<BlockArg> = first.iter().map(|&value| BlockArg::Value(value)).collect();
        self.t.b.ins().jump(head, &arguments);
        self.t.b.switch_to_block(head);
        let parameters: Vec<Value> = first
            .iter()
            .map(|&value| {
                let ty = self.t.b.func.dfg.value_type(value);
                self.t.b.append_block_param(head, ty)
            })
            .collect();
        let together = if level == Level::Outer { self.behind_one_another() } else { 1 };
        self.written.clear();
        self.in_lanes.clear();
        let mut now = parameters;
        for turn in 0..together {
            self.turn = turn;
            if turn > 0 {
                self.outer = Scope::default();
            }
            let progress = match counting {
                Some((at, step)) => Progress::Address { now: now[others + at], first: first[others + at], step },
                None => Progress::Left(now[0]),
            };
            if level == Level::Outer {
                self.progress = Some((turns, progress));
                self.t.in_turns = self.lanes == 1;
            }
            self.begin(level, &handed, &now[others..]);
            let next_of_turn = match self.alike {
                Some(alike) if level == Level::Outer => Some(self.turns_alike(alike, &handed, &now)),
                _ => {
                    self.steps_of_turn(level);
                    None
                }
            };
            if level == Level::Outer {
                self.t.in_turns = false;
            }
            if let Some(next) = next_of_turn {
                now = next;
                continue;
            }
            let mut next = match counting {
                Some(_) => Vec::new(),
                None => vec![self.t.b.ins().iadd_imm_s(now[0], -i64::from(step))],
            };
            for (one, own) in handed.iter().zip(self.owned(&handed, &now[others..])) {
                self.next_of(level, one, &own, &mut next);
            }
            now = next;
        }
        if level == Level::Outer {
            self.store_pieces();
        }
        let next = now;
        let again = match (counting, end) {
            (Some((at, _)), Some(end)) => self.t.b.ins().icmp(IntCC::NotEqual, next[others + at], end),
            _ => next[0],
        };
        let behind = self.t.b.create_block();
        let arguments: Vec<BlockArg> = next.iter().map(|&value| BlockArg::Value(value)).collect();
        self.t.b.ins().brif(again, head, &arguments, behind, &[]);
        self.t.b.seal_block(head);
        self.t.b.switch_to_block(behind);
        self.t.b.seal_block(behind);
        let mut all = Vec::new();
        let mut at = others;
        for one in &handed {
            let count = self.count_of(one);
            if let Handed::Sum(cell, ..) | Handed::Extreme(cell, ..) = one {
                self.sums.insert(*cell, next[at..at + count].to_vec());
                all.extend(&next[at..at + count]);
            }
            at += count;
        }
        all
    }

    /// Does what a turn does, or several of them side by side.
    pub(super) fn steps_of_turn(&mut self, level: Level) {
        let mut steps = self.kernel.turn(level).steps.iter().copied().peekable();
        while let Some(step) = steps.next() {
            match step {
                Step::Copy(first) => {
                    let mut numbers = vec![first];
                    while let Some(&Step::Copy(next)) = steps.peek()
                        && self.kernel.copies[next].reached == self.kernel.copies[first].reached
                    {
                        numbers.push(next);
                        steps.next();
                    }
                    self.copy_whole(&numbers);
                }
                // It was read to look where the turns go.
                Step::Access(access) if self.was_read_first(access) => {}
                Step::Access(access) => {
                    self.access(access, level);
                    self.written.extend(self.kernel.accesses[access].value.is_some().then_some(access));
                }
                Step::Inner => {
                    let turns = self.all_inner_turns();
                    self.inner = Scope::default();
                    self.turns(Level::Inner, turns);
                    self.outer.bytes.clear();
                }
            }
        }
        self.write_records();
    }

    /// What a cell holds in front of a loop.
    pub(super) fn entry(&mut self, level: Level, cell: Cell) -> Lanes {
        match level {
            Level::Outer => Lanes::One(self.before[&cell]),
            Level::Inner => {
                let entry = self.plan.entry(cell);
                self.value(entry, Level::Outer)
            }
        }
    }

    /// What a cell holds when the first of the running turns begins.
    pub(super) fn start(&mut self, cell: Cell) -> Lanes {
        match self.outer.starts.get(&cell) {
            Some(value) => value.clone(),
            None => self.entry(Level::Outer, cell),
        }
    }

    /// The address to which a pointer goes, without the first byte of its area.
    pub(super) fn address(&mut self, base: Base, value: Val, offset: u32) -> Value {
        let position = self.position(value, offset);
        let byte = self.t.b.ins().ushr_imm_u(position, 3);
        let byte = self.t.b.ins().uextend(I64, byte);
        let base = self.base(base);
        self.t.b.ins().iadd(base, byte)
    }

    pub(super) fn base(&self, base: Base) -> Value {
        self.t.address_of_base(base)
    }

    /// A value in the running turn.
    pub(super) fn value(&mut self, node: Node, level: Level) -> Lanes {
        if let Some(value) = self.outer.values.get(&node) {
            return value.clone();
        }
        if level == Level::Inner
            && let Some(value) = self.inner.values.get(&node)
        {
            return value.clone();
        }
        if self.lanes > 1 && self.kernel.in_order.nodes.contains(&node) {
            let value = self.made_in_order(node);
            self.scope(level).values.insert(node, value.clone());
            return value;
        }
        let value = match self.kernel.what(node) {
            What::Constant(value) => return Lanes::One(Val::Const(value)),
            What::Start(of, cell) => {
                let known = self.scope(of).starts.get(&cell).cloned();
                match known {
                    Some(value) => value,
                    None if of == Level::Outer
                        && self.lanes == 1
                        && let (Some(line), Some((turns, progress))) = (self.kernel.cell_line(of, cell), self.progress)
                        && !line.is_same() =>
                    {
                        let made = self.t.turns_made(progress, turns);
                        Lanes::One(self.t.behind(self.before[&cell], line, made))
                    }
                    None => {
                        let same = self.kernel.cell_line(of, cell).is_some_and(Line::is_same);
                        assert!(same, "what a turn begins with is handed on where turns change it");
                        self.entry(of, cell)
                    }
                }
            }
            What::After(cell) => {
                let end = self.kernel.turn(Level::Inner).ends[&cell];
                self.value(end, Level::Inner)
            }
            What::Read(_) => unreachable!("what is read is read in its turn"),
            What::Compute(op, args) => {
                let args: Vec<Lanes> = args[..op.arity()].iter().map(|&arg| self.value(arg, level)).collect();
                self.compute(node, op, &args, level)
            }
        };
        self.scope(level).values.insert(node, value.clone());
        value
    }

    pub(super) fn set_value(&mut self, node: Node, value: Lanes) {
        self.outer.values.insert(node, value);
    }

    fn compute(&mut self, node: Node, op: Op, args: &[Lanes], level: Level) -> Lanes {
        let firsts: Option<Vec<Val>> = args
            .iter()
            .map(|arg| match arg {
                Lanes::One(value) | Lanes::Line(value, _) => Some(*value),
                _ => None,
            })
            .collect();
        if let Some(firsts) = firsts {
            if args.iter().all(|arg| matches!(arg, Lanes::One(_))) {
                if self.extremes.contains(&node)
                    && let Some((extreme, _, ty)) = self.kernel.extreme_of_reals(node)
                {
                    return Lanes::One(self.t.exact_extreme(extreme, [firsts[1], firsts[2]], ty));
                }
                self.note_bounds(node, &firsts);
                return Lanes::One(self.t.compute_now(op, &firsts));
            }
            if let Some(line) = self.kernel.line(node, Level::Outer) {
                if line.is_same() {
                    return Lanes::One(self.t.compute_now(op, &firsts));
                }
                return Lanes::Line(self.t.compute_now(op, &firsts), line);
            }
        }
        let shape = self.kernel.shape(node).expect("the shapes were looked at");
        if self.kernel.is_one_by_one(node) {
            let bounds = match self.kernel.what(node) {
                What::Compute(_, [number, ..]) => self.kernel.bounds.get(&number).copied(),
                _ => None,
            };
            return self.t.compute_one_by_one(op, shape, args, bounds, self.lanes);
        }
        if let (Some(most), &[ref number, Lanes::One(Val::Const(divisor))]) = (greatest(op), args) {
            let range = self.range_of_divided(node, most);
            return self.t.divide_lanes(op, number, divisor as u32, range, self.lanes);
        }
        if op == Op::F64ToI32
            && let What::Compute(_, [lreal, ..]) = self.kernel.what(node)
            && let What::Compute(_, [real, ..]) = self.kernel.what(lreal)
        {
            let reals = self.value(real, level);
            return self.t.cut_lanes(&reals, self.lanes);
        }
        self.t.compute_lanes(op, shape, args, self.lanes)
    }

    /// Notes the bounds that are known of the first number that an operation takes in one turn.
    pub(super) fn note_bounds(&mut self, node: Node, args: &[Val]) {
        if let What::Compute(_, [number, ..]) = self.kernel.what(node)
            && let (Some(&bounds), Some(&Val::Int(value))) = (self.kernel.bounds.get(&number), args.first())
        {
            self.t.bounds.insert(value, bounds);
        }
    }

    /// The range of the numbers that an operation divides, which are at most so great.
    fn range_of_divided(&self, node: Node, most: u64) -> (i64, i64) {
        let What::Compute(_, [number, ..]) = self.kernel.what(node) else { unreachable!("something divides") };
        if let Some(&(least, most)) = self.kernel.bounds.get(&number) {
            return (least.into(), most.into());
        }
        let most = match self.kernel.what(number) {
            What::Compute(Op::Extend16, _) => i16::MAX.into(),
            _ => most as i64,
        };
        (-most - 1, most)
    }

    /// What cells hold behind the turns.
    pub(super) fn ends(&mut self, turns: Value) -> Vec<(Cell, Val)> {
        let mut last = Vec::new();
        // What a sum was when the last turn began.
        let mut before_last: Vec<(Cell, Sum)> = Vec::new();
        for (cell, end, carried) in self.kernel.carried(Level::Outer) {
            if matches!(self.kernel.kept(cell), Kept::Ahead { .. }) {
                continue;
            }
            let value = match carried {
                Carried::Line(line) => {
                    let before = self.before[&cell];
                    self.t.behind(before, line, turns)
                }
                Carried::Sum { bits, .. } if self.lanes > 1 => {
                    let vectors = self.sums.get(&cell).cloned().unwrap_or_default();
                    let sum = self.t.sum_of_lanes(&vectors, self.lanes);
                    let before = self.before[&cell];
                    let before = self.t.int(before);
                    let sum = self.t.b.ins().iadd(before, sum);
                    self.t.on_line(sum, Line { step: 0, bits })
                }
                Carried::Extreme { extreme, bits, .. } if self.lanes > 1 => {
                    let vectors = self.sums.get(&cell).cloned().unwrap_or_default();
                    let found = self.t.extreme_in_lanes(extreme, &vectors, self.lanes);
                    self.t.on_line(found, Line { step: 0, bits })
                }
                Carried::Nothing
                    if self.lanes > 1
                        && let Some(sum) = self.kernel.sum_at_start(end) =>
                {
                    before_last.push((cell, sum));
                    continue;
                }
                Carried::Chain if self.lanes > 1 && self.kernel.in_order.cells.contains(&cell) => self.in_lane(end, self.lanes - 1),
                _ => {
                    let value = self.value(end, Level::Outer);
                    self.t.last_lane(&value, self.lanes)
                }
            };
            last.push((cell, value));
        }
        for (cell, Sum { of, added, bits }) in before_last {
            let added = self.value(added, Level::Outer);
            let added = self.t.last_lane(&added, self.lanes);
            let whole = last.iter().find(|(cell, _)| *cell == of).map(|&(_, value)| value);
            let (whole, added) = (self.t.int(whole.expect("a sum is left")), self.t.int(added));
            let before = self.t.b.ins().isub(whole, added);
            last.push((cell, self.t.on_line(before, Line { step: 0, bits })));
        }
        last
    }

    /// Writes what cells hold behind the turns.
    fn finish(&mut self, turns: Value) {
        for (cell, value) in self.ends(turns) {
            if self.kernel.kept(cell) == Kept::Budget {
                self.taken = Some(value);
            }
            self.t.write_cell(self.kernel, cell, value);
        }
        self.t.settle_bytes();
    }
}
