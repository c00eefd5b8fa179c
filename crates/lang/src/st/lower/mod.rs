//! From the typed tree to IR.
//!
//! One IR statement per step of the source, more where it branches. A temporary lives inside one IR statement, so that a value
//! which must outlive a call or a branch is put into *hidden local data*. Behind a failed statement the program goes on with the next
//! IR statement; where that would be the middle of the same source statement, a guard leads to its end.

mod arithmetic;
mod calls;
mod constants;
mod counting;
mod hidden;
mod loops;
pub(crate) mod mocking;
mod places;
mod pointers;
mod private;
mod statements;
mod text_functions;
mod texts;
mod usage;
mod values;

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use sieben_engine::CodeBlock;
use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, Callee, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::extension::HANDLE_ERRORS;
use sieben_model::interface::{Interface, Section};
use sieben_model::source::Span;

use super::tree::{Body, Scalar};
use crate::coverage::Countable;
use crate::declarations::interface::START_INFORMATION_BYTES;
use hidden::Hidden;
use private::Seen;
use sieben_model::address::{Area, Width};

/// More local data than any CPU has: a block that needs more cannot be entered.
const LOCAL_BYTES_MAX: u32 = 1 << 20;

/// What lowering must know of the blocks that are called.
pub struct Known<'a> {
    /// The interface of a block.
    pub interface: &'a dyn Fn(BlockId) -> Option<Arc<Interface>>,
    /// Whether a block is one of STL: it may look at the data block registers.
    pub is_stl: &'a dyn Fn(BlockId) -> bool,
}

/// The IR of a block: its body, and what `known` says of the blocks that it calls.
pub fn lower(id: BlockId, interface: &Interface, body: &Body, known: &Known<'_>) -> CodeBlock {
    let mut l = Lowering::new(id, interface, body, known);
    l.entry(interface);
    l.statements(&body.statements);
    l.finish(interface)
}

/// The same, and what can be counted in it: with an IR statement for each outcome of a decision.
pub fn lower_counted(id: BlockId, interface: &Interface, body: &Body, known: &Known<'_>) -> (CodeBlock, Countable) {
    let mut l = Lowering::new(id, interface, body, known);
    l.counted = Some(Countable::default());
    l.entry(interface);
    l.statements(&body.statements);
    let counted = l.counted.take().map_or_else(Countable::default, counting::in_order);
    (l.finish(interface), counted)
}

/// A place in the code that is jumped to; where it is becomes known later.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Label(u32);

/// Not bound yet.
const NOWHERE: u32 = u32::MAX;

/// A loop around the statement being lowered.
#[derive(Clone, Copy)]
struct Loop {
    /// Behind it.
    end: Label,
    /// The end of its body.
    next: Label,
}

/// A parameter in the local data.
#[derive(Clone, Copy)]
struct Copied {
    position: u32,
    width: Width,
    back: bool,
}

/// What is known while a block is lowered.
struct Lowering<'a> {
    b: Builder,
    body: &'a Body,
    known: &'a Known<'a>,
    /// DI and AR2 are the instance of the block: it is a function block or a method.
    has_instance: bool,
    /// The parameters are those of a function.
    is_function: bool,
    /// Where each IR statement comes from.
    spans: Vec<Span>,
    span: Span,
    /// The place of the source statement being lowered.
    statement: Span,
    /// What can be counted, if somebody counts.
    counted: Option<Countable>,
    /// The IR statement being built has no instruction yet.
    empty: bool,
    /// Temporaries that were used in this IR statement and are free again.
    free: Vec<Var>,
    /// Temporaries that were used in this IR statement.
    temporaries: usize,
    /// The statement of each label.
    labels: Vec<u32>,
    hidden: Hidden,
    seen: Seen,
    /// Position of ENO/OK in the local data, if the block uses it.
    ok: Option<u32>,
    /// The end of the block.
    exit: Label,
    /// The end of the source statement being lowered.
    behind: Label,
    /// Something in this IR statement may fail although the program is sound.
    fallible: bool,
    loops: Vec<Loop>,
    gotos: HashMap<u32, Label>,
    /// Elementary parameters of a function that are copied to local data: where to, and whether they are copied back.
    copies: BTreeMap<u16, Copied>,
    /// The data block that the DB register is known to hold in this IR statement.
    open: Option<u16>,
    /// Position in the local data of the result of the last call, if it has one.
    result: Option<u32>,
}

impl<'a> Lowering<'a> {
    fn new(id: BlockId, interface: &Interface, body: &'a Body, known: &'a Known<'a>) -> Self {
        let start_information = if id.kind == BlockKind::OrganizationBlock { START_INFORMATION_BYTES } else { 0 };
        let variables = body.locals.iter().map(|local| local.position / 8 + bytes(&local.data_type)).max().unwrap_or(0);
        let base = interface.local_size.max(body.local_size).max(start_information).max(variables);
        let mut hidden = Hidden::behind(base);
        let ok = body.uses_ok.then(|| hidden.scalar(Width::Bit));
        hidden.keep();
        let span = body.statements.first().map_or(Span::default(), |statement| statement.span);
        Self {
            b: Builder::default(),
            body,
            known,
            has_instance: body.is_method || matches!(id.kind, BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock),
            is_function: id.kind == BlockKind::Function,
            spans: Vec::new(),
            span,
            statement: span,
            counted: None,
            empty: false,
            free: Vec::new(),
            temporaries: 0,
            labels: vec![NOWHERE; 2],
            hidden,
            seen: Seen::default(),
            ok,
            exit: Label(0),
            behind: Label(1),
            fallible: false,
            loops: Vec::new(),
            gotos: HashMap::new(),
            copies: BTreeMap::new(),
            open: None,
            result: None,
        }
    }

    /// OK := 1, the initial values of the local variables, parameters that are used more than once.
    fn entry(&mut self, interface: &Interface) {
        self.begin();
        if self.body.own_errors {
            self.push(Inst::Call { callee: Callee::Block(HANDLE_ERRORS), parameters: 0 });
            self.begin();
        }
        self.copy_parameters(interface);
        if let Some(ok) = self.ok {
            let one = self.constant(1);
            self.store_local(ok, Width::Bit, one);
        }
        for local in &self.body.locals {
            if let Some(initial) = &local.initial {
                self.initialize(local, initial);
            }
        }
    }

    /// Copies elementary parameters that are used more than once, and inputs that the function changes: the variable of a caller
    /// stays as it is.
    fn copy_parameters(&mut self, interface: &Interface) {
        if !self.is_function {
            return;
        }
        let usage = usage::parameters(&self.body.statements);
        for (index, formal) in (0_u16..).zip(interface.parameters()) {
            let (Some(usage), Some(width)) = (usage.get(&index), formal.data_type.width()) else { continue };
            let back = matches!(formal.section, Section::Output | Section::Return);
            let often = usage.reads + usage.writes > 1 || usage.writes > 0 && formal.section == Section::Input;
            if usage.addressed || !often || formal.section == Section::InOut || !formal.data_type.is_elementary() {
                continue;
            }
            let position = self.hidden.scalar(width);
            let pointer = self.parameter(index);
            let value = self.temporary();
            let place = Place::Crossing { pointer, offset: 0 };
            self.push(Inst::Load { dst: value, place, width, on_fault: OnFault::SkipStatement });
            self.release(pointer);
            self.store_local(position, width, value);
            self.copies.insert(index, Copied { position, width, back });
        }
        self.hidden.keep();
    }

    /// Gives the outputs that were copied to the caller.
    fn copy_back(&mut self) {
        let copies: Vec<(u16, Copied)> =
            self.copies.iter().filter(|(_, copied)| copied.back).map(|(&index, &copied)| (index, copied)).collect();
        for (index, Copied { position, width, .. }) in copies {
            let value = self.load_local(position, width);
            let pointer = self.parameter(index);
            self.push(Inst::Store { place: Place::Crossing { pointer, offset: 0 }, width, src: value });
            self.release(pointer);
            self.release(value);
        }
    }

    /// The end of the block: BR is ENO for whoever called.
    fn finish(mut self, interface: &Interface) -> CodeBlock {
        self.span = self.body.statements.last().map_or(self.span, |statement| statement.span);
        let exit = self.exit;
        self.bind(exit);
        self.copy_back();
        match self.ok {
            Some(ok) => {
                let ok = self.load_local(ok, Width::Bit);
                self.push(Inst::Compute { op: Op::Copy, dst: Register::Br.into(), args: arguments(&[ok]) });
            }
            None => self.push(Inst::Constant { dst: Register::Br.into(), value: 1 }),
        }
        self.spans.push(self.span);
        let mut code = self.b.finish();
        let last = code.statement_count() as u32 - 1;
        let labels = &self.labels;
        let resolve = |target: &mut Target| {
            let statement = labels.get(target.0 as usize).copied().unwrap_or(NOWHERE);
            target.0 = if statement == NOWHERE { last } else { statement };
        };
        for inst in &mut code.insts {
            match inst {
                Inst::Jump { to } | Inst::Branch { to, .. } | Inst::JumpTable { otherwise: to, .. } => resolve(to),
                _ => {}
            }
        }
        code.tables.iter_mut().for_each(resolve);
        CodeBlock {
            code,
            interface: interface.clone(),
            local_size: self.hidden.end().min(LOCAL_BYTES_MAX).next_multiple_of(2),
            private: self.seen.private(),
            handed: self.hidden.all_shown(),
            reads_own_locals: self.body.locals.iter().all(|local| local.initial.is_some()),
            mc7_bytes: None,
            spans: self.spans,
        }
    }

    // Statements and labels.

    /// Begins an IR statement.
    fn begin(&mut self) {
        self.b.begin_statement();
        self.spans.push(self.span);
        self.empty = true;
        self.free.clear();
        self.temporaries = 0;
        self.fallible = false;
        self.open = None;
    }

    /// Begins an IR statement unless the one being built is still empty.
    fn fresh(&mut self) {
        if self.empty {
            if let Some(span) = self.spans.last_mut() {
                *span = self.span;
            }
        } else {
            self.begin();
        }
    }

    /// Begins the next part of the same source statement: if the part before failed, the rest is left out.
    fn part(&mut self) {
        if self.fallible {
            let go_on = self.label();
            self.leave_unless_failed(go_on);
            self.labels[go_on.0 as usize] = self.b.here().0;
        } else {
            self.fresh();
        }
    }

    /// Goes to the label; what failed in the IR statement that ends here leaves out the rest of its source statement.
    fn leave_unless_failed(&mut self, to: Label) {
        self.jump(to);
        self.begin();
        self.jump(self.behind);
        self.begin();
    }

    fn label(&mut self) -> Label {
        self.labels.push(NOWHERE);
        Label(self.labels.len() as u32 - 1)
    }

    /// The label is here; whatever comes before goes on here too.
    fn bind(&mut self, label: Label) {
        self.fresh();
        self.labels[label.0 as usize] = self.b.here().0;
    }

    /// The label is where the next IR statement begins.
    fn bind_behind(&mut self, label: Label) {
        let target = if self.empty { self.b.here() } else { self.b.next() };
        self.labels[label.0 as usize] = target.0;
    }

    fn jump(&mut self, to: Label) {
        self.push(Inst::Jump { to: Target(to.0) });
    }

    /// Goes to the label from an IR statement of its own, so that a failure before it does not miss it.
    fn leave_to(&mut self, to: Label) {
        self.fresh();
        self.jump(to);
        self.begin();
    }

    // Instructions.

    fn push(&mut self, inst: Inst) {
        self.seen.note(&inst);
        self.empty = false;
        self.b.push(inst);
    }

    /// A temporary that nobody uses.
    fn temporary(&mut self) -> Var {
        self.free.pop().unwrap_or_else(|| {
            self.temporaries += 1;
            Var::temporary(self.temporaries - 1).expect("values are spilled before temporaries run out")
        })
    }

    /// Nobody reads the variable any more.
    fn release(&mut self, var: Var) {
        if var.register().is_none() && !self.free.contains(&var) {
            self.free.push(var);
        }
    }

    /// How many temporaries hold values.
    fn in_use(&self) -> usize {
        self.temporaries - self.free.len()
    }

    fn constant(&mut self, value: u64) -> Var {
        let dst = self.temporary();
        self.push(Inst::Constant { dst, value });
        dst
    }

    /// The result of an operation; the arguments stay.
    fn compute_from(&mut self, op: Op, args: &[Var]) -> Var {
        let dst = self.temporary();
        self.push(Inst::Compute { op, dst, args: arguments(args) });
        dst
    }

    /// The result of an operation that uses its arguments up.
    fn compute(&mut self, op: Op, args: &[Var]) -> Var {
        for &arg in args {
            self.release(arg);
        }
        self.compute_from(op, args)
    }

    /// `op(a, constant)`, which uses `a` up.
    fn compute_with(&mut self, op: Op, a: Var, constant: u64) -> Var {
        let b = self.constant(constant);
        self.compute(op, &[a, b])
    }

    fn load_local(&mut self, position: u32, width: Width) -> Var {
        let dst = self.temporary();
        self.push(Inst::Load { dst, place: Place::Fixed { area: Area::Local, position }, width, on_fault: OnFault::SkipStatement });
        dst
    }

    /// Stores a value in the local data and uses it up.
    fn store_local(&mut self, position: u32, width: Width, src: Var) {
        self.push(Inst::Store { place: Place::Fixed { area: Area::Local, position }, width, src });
        self.release(src);
    }

    /// ENO/OK stays as it is if the condition holds, and is cleared if not.
    fn keep_ok_if(&mut self, condition: Var) {
        if let Some(ok) = self.ok {
            let old = self.load_local(ok, Width::Bit);
            let new = self.compute_from(Op::And, &[old, condition]);
            self.release(old);
            self.store_local(ok, Width::Bit, new);
        }
    }

    /// ENO/OK is cleared if the condition holds; a block that does not look at it tells the Host, with a number that says more.
    fn lost_if(&mut self, condition: Var, code: u8, shown: Var) {
        if self.ok.is_some() {
            return self.clear_ok_if(condition);
        }
        if self.body.tells_lost {
            let good = self.compute_from(Op::Not, &[condition]);
            self.push(Inst::Require { condition: good, code: NOTED | code, register: shown });
            self.release(good);
        }
    }

    /// ENO/OK is cleared if the condition holds.
    fn clear_ok_if(&mut self, condition: Var) {
        if let Some(ok) = self.ok {
            let old = self.load_local(ok, Width::Bit);
            let new = self.compute_from(Op::AndNot, &[old, condition]);
            self.release(old);
            self.store_local(ok, Width::Bit, new);
        }
    }
}

/// As many arguments as an instruction has room for.
fn arguments(args: &[Var]) -> [Var; 4] {
    let mut all = [Var::default(); 4];
    all[..args.len()].copy_from_slice(args);
    all
}

/// How much a value of this type reads or writes.
fn width(scalar: Scalar) -> Width {
    width_of_bits(scalar.bits())
}

fn width_of_bits(bits: u32) -> Width {
    match bits {
        1 => Width::Bit,
        8 => Width::Byte,
        16 => Width::Word,
        32 => Width::DoubleWord,
        _ => Width::QuadWord,
    }
}

/// Bytes of a type, saturating.
fn bytes(data_type: &sieben_model::types::DataType) -> u32 {
    u32::try_from(data_type.bits().div_ceil(8)).unwrap_or(u32::MAX / 16)
}
