//! Turns the IR of a block into steps: addresses resolved for a layout, jumps as step numbers, small constants joined.

use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::fault::Abort;
use crate::intrinsics::Intrinsic;
use crate::ir::{Callee, Code, DataRegister, Inst, OnFault, Op, Place, Target, TextAction, Var};
use crate::machine::{Layout, Register};
use crate::program::CodeBlock;
use crate::texts::Text;

/// One step of the interpreter. Arena addresses of constant places are final.
#[derive(Clone, Copy, Debug)]
pub(super) enum Step {
    /// `dst := value`.
    Constant { dst: u8, value: u32 },
    /// `dst := value` for a value of more than 32 bits, from the block's table.
    WideConstant { dst: u8, index: u32 },
    /// Up to four registers set to small values.
    Constants { count: u8, targets: [u8; 4], values: [u8; 4] },
    /// `dst := src`.
    Copy { dst: u8, src: u8 },
    /// A whole scan of a bit at an arena address: STA, RLO by `op`, OR := 0 or OR AND /FC, /FC := 1.
    Scan { op: Op, keeps_or: bool, bit: u8, at: u32 },
    /// A whole assignment of the RLO to a bit at an arena address: STA, OR := 0, /FC := 0.
    Assign { bit: u8, at: u32 },
    /// `dst := op(args)`.
    Compute { op: Op, dst: u8, args: [u8; 4] },
    /// A bit at an arena address.
    LoadBit { dst: u8, bit: u8, at: u32 },
    /// A byte at an arena address.
    LoadByte { dst: u8, at: u32 },
    /// A word at an arena address.
    LoadWord { dst: u8, at: u32 },
    /// A double word at an arena address.
    LoadDouble { dst: u8, at: u32 },
    /// A quad word at an arena address.
    LoadQuad { dst: u8, at: u32 },
    /// A bit at an arena address.
    StoreBit { src: u8, bit: u8, at: u32 },
    /// A byte at an arena address.
    StoreByte { src: u8, at: u32 },
    /// A word at an arena address.
    StoreWord { src: u8, at: u32 },
    /// A double word at an arena address.
    StoreDouble { src: u8, at: u32 },
    /// A quad word at an arena address.
    StoreQuad { src: u8, at: u32 },
    /// The local data of the block, at a byte that it has.
    LoadLocal { dst: u8, bit: u8, width: Width, byte: u32 },
    /// The local data of the block, at a byte that it has.
    StoreLocal { src: u8, bit: u8, width: Width, byte: u32 },
    /// The open data block, at a constant position.
    LoadData { dst: u8, register: DataRegister, width: Width, on_fault: OnFault, position: u32 },
    /// The open data block, at a constant position.
    StoreData { src: u8, register: DataRegister, width: Width, position: u32 },
    /// Anything else, from the block's table of places.
    LoadPlace { dst: u8, width: Width, on_fault: OnFault, place: u32 },
    /// Anything else, from the block's table of places.
    StorePlace { src: u8, width: Width, place: u32 },
    /// Bytes from one place to another, from the block's table of moves.
    Move { index: u32 },
    /// Works on two texts, from the block's table of texts.
    Text { dst: u8, index: u32 },
    /// Pointer of a parameter.
    Parameter { dst: u8, index: u16 },
    /// A parameter for the next call.
    PassParameter { src: u8 },
    /// A function over the machine.
    Intrinsic { dst: u8, args: [u8; 4], intrinsic: Intrinsic },
    /// Fails unless the condition holds.
    Require { condition: u8, code: u8, register: u8 },
    /// Aborts unless the condition holds.
    RequireStack { condition: u8, abort: Abort },
    /// Opens a data block.
    Open { register: DataRegister, number: u8 },
    /// Forward jump.
    Jump { to: u32 },
    /// Backward jump: a safe point.
    JumpBack { weight: u16, to: u32 },
    /// Forward jump if the condition is 1.
    Branch { condition: u8, to: u32 },
    /// Backward jump if the condition is 1: a safe point.
    BranchBack { condition: u8, weight: u16, to: u32 },
    /// Jump table, from the block's list of tables.
    JumpTable { index: u8, table: u32 },
    /// Enters a block of the engine's list.
    Call { code: u32, parameters: u16 },
    /// Enters a block by a computed number, or a system block, or fails because the block is not loaded.
    CallOther { callee: u32, parameters: u16 },
    /// Ends the block.
    Return,
}

/// A jump table with step numbers.
#[derive(Clone, Debug)]
pub(super) struct Table {
    /// Where each index goes; a way back is a safe point and has a weight.
    pub(super) targets: Vec<(u32, Option<u16>)>,
    /// Where every other index goes.
    pub(super) otherwise: (u32, Option<u16>),
}

/// A block ready to run.
#[derive(Clone, Debug)]
pub(super) struct Block {
    pub(super) id: BlockId,
    pub(super) local_size: u32,
    /// What entering it takes from the safe-point budget.
    pub(super) weight: u16,
    pub(super) steps: Vec<Step>,
    /// The first step of each statement.
    pub(super) statements: Vec<u32>,
    pub(super) places: Vec<Place>,
    /// From, to, number of bytes.
    pub(super) moves: Vec<(Place, Place, u32)>,
    /// What to do, to, from.
    pub(super) texts: Vec<(TextAction, Text, Text, [u8; 2])>,
    pub(super) callees: Vec<Callee>,
    pub(super) tables: Vec<Table>,
    pub(super) constants: Vec<u64>,
    /// Where the block goes on in the middle of a statement: an instruction of its IR, the step behind it.
    pub(super) behind: Vec<(u32, u32)>,
}

impl Block {
    /// The statement that a step belongs to.
    pub(super) fn statement_of(&self, step: usize) -> u32 {
        (self.statements.partition_point(|&first| first as usize <= step).saturating_sub(1)) as u32
    }
    /// The step behind the statement that a step belongs to.
    pub(super) fn behind_statement(&self, step: usize) -> usize {
        let statement = self.statement_of(step) as usize;
        self.statements.get(statement + 1).map_or(self.steps.len() - 1, |&first| first as usize)
    }
}

/// What a safe point takes from the budget: 1, and 1 more for every 64 statements of a block that is entered or that a
/// jump leads back over. Long blocks in an endless loop would keep the watchdog away for hours if all safe points were alike.
pub fn weight(statements: usize) -> u16 {
    u16::try_from(1 + statements / 64).unwrap_or(u16::MAX)
}

/// Prepares one block; `find` gives the index of a loaded block.
pub(super) fn prepare(id: BlockId, block: &CodeBlock, layout: &Layout, find: &dyn Fn(BlockId) -> Option<u32>) -> Block {
    let mut out = Block {
        id,
        local_size: block.local_size,
        weight: weight(block.code.statement_count()),
        steps: Vec::with_capacity(block.code.insts.len()),
        statements: Vec::with_capacity(block.code.statements.len()),
        places: Vec::new(),
        moves: Vec::new(),
        texts: Vec::new(),
        callees: Vec::new(),
        tables: Vec::new(),
        constants: Vec::new(),
        behind: Vec::new(),
    };
    for statement in 0..block.code.statement_count() {
        out.statements.push(out.steps.len() as u32);
        if let Some(whole) = whole_statement(block.code.statement(statement), layout) {
            out.steps.push(whole);
            continue;
        }
        let first = block.code.statements[statement];
        for (index, inst) in (first..).zip(block.code.statement(statement)) {
            let step = step(inst, statement, &block.code, layout, find, &mut out);
            push(&mut out.steps, step, *out.statements.last().unwrap_or(&0) as usize);
            if matches!(inst, Inst::Call { .. } | Inst::Load { on_fault: OnFault::DeliverZero, .. }) {
                out.behind.push((index, out.steps.len() as u32));
            }
        }
    }
    if out.steps.is_empty() {
        out.statements.push(0);
        out.steps.push(Step::Return);
    }
    // Targets were statement numbers until all statements had their first step.
    let last = out.steps.len() as u32 - 1;
    let statements = std::mem::take(&mut out.statements);
    let resolve = |to: u32| statements.get(to as usize).copied().unwrap_or(last);
    for step in &mut out.steps {
        match step {
            Step::Jump { to } | Step::JumpBack { to, .. } | Step::Branch { to, .. } | Step::BranchBack { to, .. } => *to = resolve(*to),
            _ => {}
        }
    }
    for table in &mut out.tables {
        for (to, _) in table.targets.iter_mut().chain([&mut table.otherwise]) {
            *to = resolve(*to);
        }
    }
    out.statements = statements;
    out
}

/// Bit logic on a constant address is one step per statement: exactly these instructions, done at once.
fn whole_statement(insts: &[Inst], layout: &Layout) -> Option<Step> {
    let var = |register: Register| Var::from(register);
    let (rlo, sta, or, fc) = (var(Register::Rlo), var(Register::Sta), var(Register::Or), var(Register::Fc));
    let zero = |dst| Inst::Constant { dst, value: 0 };
    match *insts {
        [
            Inst::Load { dst, place: Place::Fixed { area, position }, width: Width::Bit, .. },
            Inst::Compute { op, dst: result, args },
            rest,
            last,
        ] if dst == sta && result == rlo && last == (Inst::Constant { dst: fc, value: 1 }) => {
            let keeps_or = match args {
                [a, b, c, d] if op.arity() == 4 && [a, b, c, d] == [rlo, sta, or, fc] => {
                    let and = Inst::Compute { op: Op::And, dst: or, args: [or, fc, Var::default(), Var::default()] };
                    (rest == and).then_some(true)?
                }
                [a, b, c, _] if op.arity() == 3 && [a, b, c] == [rlo, sta, fc] => (rest == zero(or)).then_some(false)?,
                _ => return None,
            };
            let (at, bit) = fixed(area, position, Width::Bit, layout)?;
            Some(Step::Scan { op, keeps_or, bit, at })
        }
        [
            Inst::Store { place: Place::Fixed { area, position }, width: Width::Bit, src },
            Inst::Compute { op: Op::Copy, dst, args },
            first,
            second,
        ] if src == rlo && dst == sta && args[0] == rlo && first == zero(or) && second == zero(fc) => {
            let (at, bit) = fixed(area, position, Width::Bit, layout)?;
            Some(Step::Assign { bit, at })
        }
        _ => None,
    }
}

/// Adds a step, joined with the one before if both set small constants in the same statement.
fn push(steps: &mut Vec<Step>, step: Step, statement_start: usize) {
    if let Step::Constant { dst, value: value @ 0..=255 } = step
        && steps.len() > statement_start
    {
        match steps.last_mut() {
            Some(Step::Constants { count, targets, values }) if *count < 4 => {
                targets[usize::from(*count)] = dst;
                values[usize::from(*count)] = value as u8;
                *count += 1;
                return;
            }
            Some(last @ Step::Constant { .. }) => {
                if let Step::Constant { dst: first, value: before @ 0..=255 } = *last {
                    *last = Step::Constants { count: 2, targets: [first, dst, 0, 0], values: [before as u8, value as u8, 0, 0] };
                    return;
                }
            }
            _ => {}
        }
    }
    steps.push(step);
}

fn step(inst: &Inst, statement: usize, code: &Code, layout: &Layout, find: &dyn Fn(BlockId) -> Option<u32>, out: &mut Block) -> Step {
    match *inst {
        Inst::Constant { dst, value } => match u32::try_from(value) {
            Ok(value) => Step::Constant { dst: dst.0, value },
            Err(_) => {
                out.constants.push(value);
                Step::WideConstant { dst: dst.0, index: out.constants.len() as u32 - 1 }
            }
        },
        Inst::Compute { op: Op::Copy, dst, args: [src, ..] } => Step::Copy { dst: dst.0, src: src.0 },
        Inst::Compute { op, dst, args } => Step::Compute { op, dst: dst.0, args: args.map(|arg| arg.0) },
        Inst::Load { dst, place, width, on_fault } => load(dst, place, width, on_fault, layout, out),
        Inst::Store { place, width, src } => store(src, place, width, layout, out),
        Inst::Move { from, to, bytes } => {
            out.moves.push((from, to, bytes));
            Step::Move { index: out.moves.len() as u32 - 1 }
        }
        Inst::Text { action, dst, to, to_room, from, from_room, piece } => {
            let [to, from] = [(to, to_room), (from, from_room)].map(|(place, room)| Text { place, room });
            out.texts.push((action, to, from, piece.map(|var| var.0)));
            Step::Text { dst: dst.0, index: out.texts.len() as u32 - 1 }
        }
        Inst::Parameter { dst, index } => Step::Parameter { dst: dst.0, index },
        Inst::PassParameter { src } => Step::PassParameter { src: src.0 },
        Inst::Intrinsic { dst, intrinsic, args } => Step::Intrinsic { dst: dst.0, intrinsic, args: args.map(|arg| arg.0) },
        Inst::Require { condition, code, register } => Step::Require { condition: condition.0, code, register: register.0 },
        Inst::RequireStack { condition, abort } => Step::RequireStack { condition: condition.0, abort },
        Inst::Open { register, number } => Step::Open { register, number: number.0 },
        Inst::Jump { to: Target(to) } if to as usize <= statement => Step::JumpBack { weight: weight(statement - to as usize), to },
        Inst::Jump { to: Target(to) } => Step::Jump { to },
        Inst::Branch { condition, to: Target(to) } if to as usize <= statement => {
            Step::BranchBack { condition: condition.0, weight: weight(statement - to as usize), to }
        }
        Inst::Branch { condition, to: Target(to) } => Step::Branch { condition: condition.0, to },
        Inst::JumpTable { index, first, count, otherwise } => {
            let way = |&Target(to): &Target| (to, (to as usize <= statement).then(|| weight(statement - to as usize)));
            let targets = code.tables.iter().skip(first as usize).take(count as usize).map(way).collect();
            out.tables.push(Table { targets, otherwise: way(&otherwise) });
            Step::JumpTable { index: index.0, table: out.tables.len() as u32 - 1 }
        }
        Inst::Call { callee, parameters } => match callee {
            Callee::Block(block) if find(block).is_some() => Step::Call { code: find(block).unwrap_or_default(), parameters },
            _ => {
                out.callees.push(callee);
                Step::CallOther { callee: out.callees.len() as u32 - 1, parameters }
            }
        },
        Inst::Return => Step::Return,
    }
}

/// Byte and bit of a position in an area of this length, if the access lies inside and begins at a byte unless it is a bit.
fn inside(length: usize, position: u32, width: Width) -> Option<(u32, u8)> {
    let (byte, bit) = (position / 8, (position % 8) as u8);
    let aligned = width == Width::Bit || bit == 0;
    (aligned && (byte + width.bytes()) as usize <= length).then_some((byte, bit))
}

/// The arena address of a constant place in I, Q or M, if it lies inside the area.
fn fixed(area: Area, position: u32, width: Width, layout: &Layout) -> Option<(u32, u8)> {
    let range = layout.area(area)?;
    let (byte, bit) = inside(range.len(), position, width)?;
    Some((range.start as u32 + byte, bit))
}

/// What is known of a place before the program runs.
enum Prepared {
    /// An address in I, Q or M: arena byte and bit.
    Arena(u32, u8),
    /// An address in the local data of the block: byte and bit.
    Local(u32, u8),
    /// A position in the open data block.
    Data(DataRegister, u32),
    /// All else: the index of the place.
    Place(u32),
}

fn prepare_place(place: Place, width: Width, layout: &Layout, out: &mut Block) -> Prepared {
    if let Place::Fixed { area, position } = place {
        match area {
            Area::SharedData => return Prepared::Data(DataRegister::Shared, position),
            Area::InstanceData => return Prepared::Data(DataRegister::Instance, position),
            Area::Local => {
                if let Some((byte, bit)) = inside(out.local_size as usize, position, width) {
                    return Prepared::Local(byte, bit);
                }
            }
            _ => {
                if let Some((at, bit)) = fixed(area, position, width, layout) {
                    return Prepared::Arena(at, bit);
                }
            }
        }
    }
    out.places.push(place);
    Prepared::Place(out.places.len() as u32 - 1)
}

fn load(dst: Var, place: Place, width: Width, on_fault: OnFault, layout: &Layout, out: &mut Block) -> Step {
    let dst = dst.0;
    match prepare_place(place, width, layout, out) {
        Prepared::Arena(at, bit) => match width {
            Width::Bit => Step::LoadBit { dst, bit, at },
            Width::Byte => Step::LoadByte { dst, at },
            Width::Word => Step::LoadWord { dst, at },
            Width::DoubleWord => Step::LoadDouble { dst, at },
            Width::QuadWord => Step::LoadQuad { dst, at },
        },
        Prepared::Local(byte, bit) => Step::LoadLocal { dst, bit, width, byte },
        Prepared::Data(register, position) => Step::LoadData { dst, register, width, on_fault, position },
        Prepared::Place(place) => Step::LoadPlace { dst, width, on_fault, place },
    }
}

fn store(src: Var, place: Place, width: Width, layout: &Layout, out: &mut Block) -> Step {
    let src = src.0;
    match prepare_place(place, width, layout, out) {
        Prepared::Arena(at, bit) => match width {
            Width::Bit => Step::StoreBit { src, bit, at },
            Width::Byte => Step::StoreByte { src, at },
            Width::Word => Step::StoreWord { src, at },
            Width::DoubleWord => Step::StoreDouble { src, at },
            Width::QuadWord => Step::StoreQuad { src, at },
        },
        Prepared::Local(byte, bit) => Step::StoreLocal { src, bit, width, byte },
        Prepared::Data(register, position) => Step::StoreData { src, register, width, position },
        Prepared::Place(place) => Step::StorePlace { src, width, place },
    }
}
