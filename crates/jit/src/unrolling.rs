//! Full unrolling: the iterations of a loop of few are written one after the other, so that the loop variable is a constant in each of
//! them.
//!
//! The code of a block with such loops has other numbers of statements and instructions than the program; the number in the program is
//! found here. What a loop does stays the same, whatever its iterations do with the loop variable: each of them ends as the program says,
//! and if there are more than were unrolled, the interpreter goes on.

use std::ops::Range;

use sieben_engine::interpreter::weight;
use sieben_engine::ir::{Code, Inst, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_model::address::Width;

use crate::jit::jumps_back;
use crate::translate::{made_by, targets};

/// Iterations of a loop that is written out.
const ITERATIONS_MAX: u32 = 5;
/// Iterations of one that works with few variables, each at its own address, as those for the bits of a check sum: nothing of it is done
/// side by side.
const ITERATIONS_MAX_OF_VARIABLES: u32 = 8;
/// IR instructions of such an iteration.
const VARIABLES_INSTRUCTIONS_MAX: usize = 40;
/// IR instructions of all iterations of a loop.
const INSTRUCTIONS_MAX: usize = 4_000;
/// IR instructions by which a block may grow.
const GROWTH_MAX: usize = 8_000;

/// A loop that is written out.
#[derive(Clone, Debug)]
pub(crate) struct UnrolledLoop {
    /// Its first statement, as it is written.
    pub(crate) first: u32,
    /// Statements of an iteration, with one more behind it.
    length: u32,
    /// Iterations.
    count: u32,
    /// What going on with the next iteration takes from the budget.
    pub(crate) weight: u16,
}

impl UnrolledLoop {
    /// The statement behind the last iteration: who comes there has more iterations to make than are written.
    pub(crate) fn more(&self) -> u32 {
        self.first + self.count * self.length
    }

    /// What all iterations take from the budget.
    pub(crate) fn weight_of_all(&self) -> i64 {
        i64::from(self.weight) * i64::from(self.count - 1)
    }

    fn begins(&self, statement: u32) -> bool {
        statement > self.first && statement < self.more() && (statement - self.first).is_multiple_of(self.length)
    }
}

/// What the numbers of a block's code are in the program.
#[derive(Clone, Debug)]
pub(crate) struct Unrolled {
    /// For each statement, and for the end.
    statements: Vec<u32>,
    insts: Vec<u32>,
    /// In their order.
    iterations: Vec<UnrolledLoop>,
}

impl Unrolled {
    /// The number of a statement in the program.
    pub(crate) fn statement(&self, statement: u32) -> u32 {
        self.statements.get(statement as usize).or(self.statements.last()).copied().unwrap_or(statement)
    }

    /// The number of an instruction in the program.
    pub(crate) fn inst(&self, inst: u32) -> u32 {
        self.insts[inst as usize]
    }

    /// All loops that are written out.
    pub(crate) fn iterations(&self) -> &[UnrolledLoop] {
        &self.iterations
    }

    /// The loop whose next iteration begins with a statement.
    pub(crate) fn next_iteration(&self, statement: u32) -> Option<&UnrolledLoop> {
        self.at(statement).filter(|iterations| iterations.begins(statement))
    }

    /// The loop of which somebody who comes to a statement has more iterations to make than are written.
    pub(crate) fn more(&self, statement: u32) -> Option<&UnrolledLoop> {
        self.at(statement).filter(|iterations| iterations.more() == statement)
    }

    /// The loop that begins with a statement.
    pub(crate) fn first(&self, statement: u32) -> Option<&UnrolledLoop> {
        self.at(statement).filter(|iterations| iterations.first == statement)
    }

    /// The last loop that does not begin behind a statement.
    fn at(&self, statement: u32) -> Option<&UnrolledLoop> {
        let next = self.iterations.partition_point(|iterations| iterations.first <= statement);
        self.iterations[..next].last()
    }
}

/// A loop as the program has it.
struct Loop {
    statements: Range<u32>,
    count: u32,
    /// By how much what follows is further behind when this loop and those before it are written out.
    growth: u32,
}

impl Loop {
    /// Statements of an iteration as it is written: behind each there is one more, for who has no other iteration to make.
    fn length(&self) -> u32 {
        self.statements.len() as u32 + 1
    }
}

/// Writes out the iterations of a block's loops; `None` if it has none for which that is worth it.
pub(crate) fn write_out(code: &Code) -> Option<(Code, Unrolled)> {
    let loops = loops_of_few_iterations(code);
    if loops.is_empty() {
        return None;
    }
    let written_out = Unrolled { statements: Vec::new(), insts: Vec::new(), iterations: Vec::new() };
    let mut writer = Writer { code, out: Code::default(), written_out };
    let place = |to: u32| {
        let before = loops.partition_point(|it| it.statements.end <= to);
        to + loops[..before].last().map_or(0, |it| it.growth)
    };
    let count = code.statement_count() as u32;
    let mut statement = 0;
    for it in &loops {
        (statement..it.statements.start).for_each(|statement| writer.statement(statement, &place));
        writer.iterations(it, &place);
        statement = it.statements.end;
    }
    (statement..count).for_each(|statement| writer.statement(statement, &place));
    writer.out.statements.push(writer.out.insts.len() as u32);
    writer.written_out.statements.push(count);
    Some((writer.out, writer.written_out))
}

struct Writer<'c> {
    code: &'c Code,
    out: Code,
    written_out: Unrolled,
}

impl Writer<'_> {
    fn iterations(&mut self, it: &Loop, outside: &dyn Fn(u32) -> u32) {
        let Range { start, end } = it.statements;
        let (length, first) = (it.length(), self.written_out.statements.len() as u32);
        let leave = Inst::Jump { to: Target(outside(end)) };
        let back = self.code.statements[end as usize] - 1;
        for iteration in 0..it.count {
            let own = first + iteration * length;
            for statement in start..end {
                let is_last = statement + 1 == end;
                let place = |to: u32| match to {
                    _ if to == start && is_last => own + length,
                    _ if it.statements.contains(&to) => own + (to - start),
                    _ => outside(to),
                };
                self.statement(statement, &place);
            }
            self.begin(end);
            self.inst(back, leave);
        }
        // For who reads the code only: see `UnrolledLoop::more`.
        self.begin(end - 1);
        self.inst(back, leave);
        let weight = weight((end - 1 - start) as usize);
        self.written_out.iterations.push(UnrolledLoop { first, length, count: it.count, weight });
    }

    fn begin(&mut self, statement: u32) {
        self.out.statements.push(self.out.insts.len() as u32);
        self.written_out.statements.push(statement);
    }

    fn inst(&mut self, number: u32, inst: Inst) {
        self.out.insts.push(inst);
        self.written_out.insts.push(number);
    }

    fn statement(&mut self, statement: u32, place: &dyn Fn(u32) -> u32) {
        self.begin(statement);
        let first = self.code.statements[statement as usize];
        for (number, inst) in (first..).zip(self.code.statement(statement as usize)) {
            self.moved(number, inst, place);
        }
    }

    fn moved(&mut self, number: u32, inst: &Inst, place: &dyn Fn(u32) -> u32) {
        let moved = |Target(to): Target| Target(place(to));
        let inst = match *inst {
            Inst::Jump { to } => Inst::Jump { to: moved(to) },
            Inst::Branch { condition, to } => Inst::Branch { condition, to: moved(to) },
            Inst::JumpTable { index, first, count, otherwise } => {
                let own = self.out.tables.len() as u32;
                let entries = self.code.tables[first as usize..(first + count) as usize].iter().map(|&to| moved(to));
                self.out.tables.extend(entries);
                Inst::JumpTable { index, first: own, count, otherwise: moved(otherwise) }
            }
            other => other,
        };
        self.inst(number, inst);
    }
}

/// Loops whose iterations are to be written out, in their order.
fn loops_of_few_iterations(code: &Code) -> Vec<Loop> {
    let back = jumps_back(code);
    let mut grown = 0;
    let mut loops = Vec::new();
    for &(last, first) in &back {
        let statements = first..last as u32 + 1;
        let inside = |statement: u32| statements.contains(&statement);
        // It is the only one with these statements, is entered at its first one, and has no loop in it.
        let alone = back.iter().filter(|&&(from, to)| inside(from as u32) || inside(to)).count() == 1;
        let size: usize = statements.clone().map(|statement| code.statement(statement as usize).len()).sum();
        let of_variables = size <= VARIABLES_INSTRUCTIONS_MAX && works_with_variables(code, &statements);
        let most = if of_variables { ITERATIONS_MAX_OF_VARIABLES } else { ITERATIONS_MAX };
        let Some(count) = alone.then(|| iterations_of(code, &statements, most)).flatten() else { continue };
        let all = size * count as usize;
        if all > INSTRUCTIONS_MAX || grown + all > GROWTH_MAX || !is_entered_at_its_beginning(code, &statements) {
            continue;
        }
        grown += all;
        loops.push(Loop { statements, count, growth: 0 });
    }
    loops.sort_by_key(|it| it.statements.start);
    loops.iter_mut().fold(0, |before, it| {
        it.growth = before + it.length() * it.count + 1 - it.statements.len() as u32;
        it.growth
    });
    loops
}

/// Whether a loop reaches no place whose address is computed.
fn works_with_variables(code: &Code, statements: &Range<u32>) -> bool {
    let instance = Var::from(Register::Ar2);
    let is_variable = |inst: &Inst| match *inst {
        Inst::Load { place, .. } | Inst::Store { place, .. } => match place {
            Place::Fixed { .. } => true,
            Place::Indirect { pointer, .. } => pointer == instance,
            Place::Crossing { .. } => false,
        },
        Inst::JumpTable { .. } => false,
        _ => true,
    };
    statements.clone().all(|statement| code.statement(statement as usize).iter().all(is_variable))
}

/// Whether no jump enters a loop, and it calls no block. What pointers in memory lead to is found once for all iterations of a loop that
/// is not written out.
fn is_entered_at_its_beginning(code: &Code, statements: &Range<u32>) -> bool {
    let calls = |inst: &Inst| match inst {
        Inst::Load { place, .. } | Inst::Store { place, .. } => matches!(place, Place::Crossing { .. }),
        Inst::Call { .. } | Inst::Return | Inst::PassParameter { .. } | Inst::Parameter { .. } => true,
        Inst::Intrinsic { .. } | Inst::Text { .. } | Inst::Open { .. } | Inst::Move { .. } => true,
        _ => false,
    };
    let jumps_in = |from: u32| {
        let mut to = code.statement(from as usize).iter().flat_map(|inst| targets(code, inst));
        to.any(|to| statements.contains(&to))
    };
    !statements.clone().any(|statement| code.statement(statement as usize).iter().any(calls))
        && !(0..code.statement_count() as u32).filter(|from| !statements.contains(from)).any(jumps_in)
}

/// How many iterations a loop has, if it counts from a constant to a constant and nothing else is seen.
fn iterations_of(code: &Code, statements: &Range<u32>, most: u32) -> Option<u32> {
    let [.., Inst::Branch { condition, to }] = *code.statement(statements.end as usize - 1) else { return None };
    if to != Target(statements.start) || condition.register().is_some() || statements.start == 0 {
        return None;
    }
    let (place, width, step, limit, compare) = step_of(code.statement(statements.end as usize - 1), condition)?;
    let from = first_value(code.statement(statements.start as usize - 1), (place, width))?;
    // All numbers are far from the ends of what they are calculated with.
    let bits = Some(width.bits()).filter(|&bits| bits <= 32)?;
    let signed = |value: u64| (value as i64) << (64 - bits) >> (64 - bits);
    let goes_on = |value: i64| match compare {
        Op::LeI16 | Op::LeI32 => value <= signed(limit),
        Op::GeI16 | Op::GeI32 => value >= signed(limit),
        _ => false,
    };
    let mut value = signed(from);
    for count in 1..=most {
        value += signed(step);
        if !goes_on(value) {
            return (count > 1).then_some(count);
        }
    }
    None
}

/// What the last statement of a loop counts, by how much, and with which constant it compares it how.
fn step_of(insts: &[Inst], condition: Var) -> Option<(Place, Width, u64, u64, Op)> {
    let store = insts.iter().rposition(|inst| matches!(inst, Inst::Store { .. }))?;
    let Inst::Store { place, width, src: sum } = insts[store] else { return None };
    let (add, Inst::Compute { op: Op::AddU16 | Op::AddU32, args: [a, b, ..], .. }) = made_by(&insts[..store], sum)? else { return None };
    let is_read = |var: Var| {
        let made = made_by(&insts[..add], var);
        made.is_some_and(|(_, inst)| matches!(inst, Inst::Load { place: from, width: own, .. } if (from, own) == (place, width)))
    };
    let step = match (is_read(a), is_read(b)) {
        (true, _) => constant(&insts[..add], b)?,
        (_, true) => constant(&insts[..add], a)?,
        _ => return None,
    };
    let (at, Inst::Compute { op: compare, args: [value, limit, ..], .. }) = made_by(insts, condition)? else { return None };
    (value == sum).then_some((place, width, step, constant(&insts[..at], limit)?, compare))
}

/// The constant that a statement writes to a place.
fn first_value(insts: &[Inst], (place, width): (Place, Width)) -> Option<u64> {
    let writes = |inst: &Inst| matches!(*inst, Inst::Store { place: to, width: own, .. } if (to, own) == (place, width));
    let store = insts.iter().rposition(writes)?;
    let Inst::Store { src, .. } = insts[store] else { return None };
    constant(&insts[..store], src)
}

/// The constant that a variable is behind some instructions.
fn constant(insts: &[Inst], var: Var) -> Option<u64> {
    match made_by(insts, var)? {
        (_, Inst::Constant { value, .. }) => Some(value),
        _ => None,
    }
}
