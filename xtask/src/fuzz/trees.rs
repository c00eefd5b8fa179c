//! Typed trees of Structured Text that the input chooses: interpreter, machine code and a model that walks over the tree leave the
//! same memory.

use std::collections::BTreeMap;
use std::sync::Arc;

use sieben_engine::ir::{Op, verify};
use sieben_engine::{Context, Engine, Entry, Exit, Fault, FaultPlace, Host, Interpreter, Layout, Machine, Program, Reaction, StopReason};
use sieben_jit::{Jit, StatusBits};
use sieben_lang::st::lower::{Known, lower};
use sieben_lang::st::tree::{
    Argument, Base, Body, Bounds, Branch, Call, Callee, For, Index, Local, Place, Scalar, Statement, StatementKind, Value, ValueKind,
};
use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;
use sieben_model::interface::{Interface, Section, Variable};
use sieben_model::program::DataBlock;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::tree_model::{Blocks, LOCAL, Model, REGION};

/// Safe points after which a run is stopped.
const SAFE_POINTS_MAX: usize = 400;
/// Expressions and statements inside one another.
const DEPTH_MAX: u32 = 6;

/// Types that values have, each with the first byte of its variables and how many there are.
const TYPES: [(Scalar, u32, u64); 5] =
    [(Scalar::Bool, 0, 8), (Scalar::U8, 2, 8), (Scalar::I16, 10, 8), (Scalar::I32, 26, 8), (Scalar::I64, 58, 8)];

/// Which block is being made.
#[derive(Clone, Copy, PartialEq)]
enum Inside {
    Main,
    Function,
    FunctionBlock,
}

struct Generator<'a> {
    data: &'a [u8],
    at: usize,
    inside: Inside,
    depth: u32,
    loops: u32,
    uses_ok: bool,
}

impl Generator<'_> {
    /// The next byte of the input, modulo `limit`; 0 at its end.
    fn choose(&mut self, limit: u8) -> u8 {
        let byte = self.data.get(self.at).copied().unwrap_or(0);
        self.at += 1;
        byte % limit
    }

    fn scalar(&mut self) -> Scalar {
        TYPES[usize::from(self.choose(TYPES.len() as u8))].0
    }

    /// A number: small, or at an edge.
    fn constant(&mut self, scalar: Scalar) -> Value {
        let small = self.choose(24);
        let bits = match small {
            20 => u64::MAX,
            21 => 1 << (scalar.bits() - 1),
            22 => (1 << (scalar.bits() - 1)) - 1,
            23 => u64::from(self.choose(255)).wrapping_mul(0x0101_0101_0101_0101),
            small => u64::from(small).wrapping_sub(4),
        };
        value(ValueKind::Constant(bits & (u64::MAX >> (64 - scalar.bits()))), scalar)
    }

    fn place(&mut self, scalar: Scalar) -> Place {
        let (_, first, count) = TYPES.into_iter().find(|row| row.0 == scalar).unwrap_or(TYPES[0]);
        let kind = self.choose(5);
        let (base, start) = match (kind, self.inside) {
            (0, _) => (Base::Area(Area::BitMemory), 0),
            (1 | 2, _) => (Base::Area(Area::Local), LOCAL),
            (3, _) => (Base::DataBlock(1), 0),
            (_, Inside::FunctionBlock) => (Base::Instance, 0),
            (_, Inside::Function) if scalar == Scalar::I16 => return place(Base::Parameter(2 * u16::from(self.choose(2))), 0),
            (_, Inside::Function) if scalar == Scalar::I32 => {
                let index = [1, 3, 4][usize::from(self.choose(3))];
                return place(Base::Parameter(index), 0);
            }
            _ => (Base::Area(Area::BitMemory), 0),
        };
        let step = if scalar == Scalar::Bool { 1 } else { scalar.bits() };
        let offset = 8 * (start + first);
        if self.choose(4) == 0 && self.depth < DEPTH_MAX {
            let low = i64::from(self.choose(3)) - 1;
            let check = [Bounds::Fault, Bounds::Skip, Bounds::Clamp][usize::from(self.choose(3))];
            let long = self.choose(4) == 0;
            let index = self.value(if long { Scalar::I64 } else { Scalar::I32 });
            return Place { indexes: vec![Index { value: index, low, count, step, check }], ..place(base, offset) };
        }
        place(base, offset + step * u32::from(self.choose(count as u8)))
    }

    fn value(&mut self, scalar: Scalar) -> Value {
        self.depth += 1;
        let leaf = self.depth > DEPTH_MAX || self.at >= self.data.len();
        let kind = if leaf {
            match self.choose(2) {
                0 => self.constant(scalar).kind,
                _ => ValueKind::Load(self.place(scalar)),
            }
        } else {
            match self.choose(14) {
                0 | 1 => self.constant(scalar).kind,
                2..=4 => ValueKind::Load(self.place(scalar)),
                5 => ValueKind::Choose {
                    condition: Box::new(self.value(Scalar::Bool)),
                    a: Box::new(self.value(scalar)),
                    b: Box::new(self.value(scalar)),
                },
                6 if scalar == Scalar::Bool => ValueKind::AndThen(Box::new(self.value(scalar)), Box::new(self.value(scalar))),
                7 if scalar == Scalar::Bool => ValueKind::OrElse(Box::new(self.value(scalar)), Box::new(self.value(scalar))),
                8 if scalar == Scalar::Bool => ValueKind::Ok,
                6 if scalar == Scalar::I32 && self.inside != Inside::Function => ValueKind::Call(Box::new(self.function_call(true))),
                7 if scalar == Scalar::I16 => {
                    ValueKind::Checked { op: Op::AddU16, failed: Op::AddOverflowsI16, args: vec![self.value(scalar), self.value(scalar)] }
                }
                8 => {
                    let loops = std::mem::take(&mut self.loops);
                    let statements = self.statements(2);
                    self.loops = loops;
                    ValueKind::After(statements, Box::new(self.value(scalar)))
                }
                9 if scalar == Scalar::I32 => ValueKind::Compute { op: Op::Extend16, args: vec![self.value(Scalar::I16)] },
                9 if scalar == Scalar::I64 => ValueKind::Compute { op: Op::ExtendI32I64, args: vec![self.value(Scalar::I32)] },
                _ => self.operation(scalar),
            }
        };
        self.depth -= 1;
        value(kind, scalar)
    }

    fn operation(&mut self, scalar: Scalar) -> ValueKind {
        let (ops, operands): (&[Op], Scalar) = match scalar {
            Scalar::Bool => match self.choose(5) {
                0 => (&[Op::And, Op::Or, Op::Xor, Op::Equal], Scalar::Bool),
                1 => (&[Op::LtI16, Op::Equal, Op::GeI16, Op::Differ], Scalar::I16),
                2 => (&[Op::LtI32, Op::Equal, Op::GeI32, Op::GtI32], Scalar::I32),
                3 => (&[Op::LtI64, Op::Equal, Op::LeI64, Op::GtI64], Scalar::I64),
                _ => (&[Op::Below, Op::LeU64, Op::GtU64, Op::GeU64], Scalar::U8),
            },
            Scalar::U8 => (&[Op::AddU8, Op::SubU8, Op::MulU8, Op::DivU64], scalar),
            Scalar::I16 => (&[Op::AddU16, Op::SubU16, Op::MulU16, Op::DivI16], scalar),
            Scalar::I32 => (&[Op::AddU32, Op::SubU32, Op::MulU32, Op::RemI32], scalar),
            _ => (&[Op::AddU64, Op::SubU64, Op::MulU64, Op::DivI64], scalar),
        };
        let op = ops[usize::from(self.choose(ops.len() as u8))];
        if scalar == Scalar::Bool && self.choose(6) == 0 {
            return ValueKind::Compute { op: Op::Not, args: vec![self.value(Scalar::Bool)] };
        }
        ValueKind::Compute { op, args: vec![self.value(operands), self.value(operands)] }
    }

    fn function_call(&mut self, result: bool) -> Call {
        let mut arguments = vec![
            Argument::Value { parameter: 0, value: self.value(Scalar::I16) },
            Argument::Value { parameter: 1, value: self.value(Scalar::I32) },
        ];
        if self.choose(2) == 0 {
            let target = self.place(Scalar::I16);
            arguments.push(Argument::Output { parameter: 2, scalar: Scalar::I16, target, convert: Vec::new(), converted: Scalar::I16 });
        }
        // By copying: a place that the function changes by itself too would be seen at once if it were passed by reference.
        let place = Place { base: Base::DataBlock(1), ..self.place_in_data() };
        arguments.push(Argument::InOut { parameter: 3, place, data_type: DataType::DoubleInt });
        let enable = (self.choose(4) == 0).then(|| self.value(Scalar::Bool));
        if self.choose(3) == 0 {
            arguments.push(Argument::Eno { target: self.place(Scalar::Bool) });
        }
        let result = if result { DataType::DoubleInt } else { DataType::Void };
        Call {
            callee: Callee::Function(BlockId::fc(1)),
            arguments,
            enable,
            result,
            clears_ok: self.choose(2) == 0,
            of_library: false,
            written_out: None,
            span: Span::default(),
        }
    }

    fn place_in_data(&mut self) -> Place {
        let number = u32::from(self.choose(8));
        place(Base::DataBlock(1), 8 * (26 + 4 * number))
    }

    fn instance_call(&mut self) -> Call {
        let mut arguments = vec![Argument::Value { parameter: 80, value: self.value(Scalar::I16) }];
        if self.choose(2) == 0 {
            let target = self.place(Scalar::I32);
            arguments.push(Argument::Output { parameter: 240, scalar: Scalar::I32, target, convert: Vec::new(), converted: Scalar::I32 });
        }
        let enable = (self.choose(4) == 0).then(|| self.value(Scalar::Bool));
        Call {
            callee: Callee::Instance { block: function_block(), instance: place(Base::DataBlock(2), 0), dispatch: None },
            arguments,
            enable,
            result: DataType::Void,
            clears_ok: self.choose(2) == 0,
            of_library: false,
            written_out: None,
            span: Span::default(),
        }
    }

    fn statements(&mut self, count_max: u8) -> Vec<Statement> {
        self.depth += 1;
        let count = 1 + self.choose(count_max);
        let statements = (0..count).map(|_| self.statement()).collect();
        self.depth -= 1;
        statements
    }

    fn statement(&mut self) -> Statement {
        let simple = self.depth > DEPTH_MAX || self.at >= self.data.len();
        let kind = match if simple { 0 } else { self.choose(16) } {
            6 => {
                let branches = (0..=self.choose(3)).map(|_| (self.value(Scalar::Bool), self.statements(3))).collect();
                let otherwise = if self.choose(2) == 0 { Vec::new() } else { self.statements(2) };
                StatementKind::If { branches, otherwise }
            }
            7 => self.case(),
            8 | 9 => self.for_loop(),
            10 => StatementKind::While { condition: self.value(Scalar::Bool), body: self.body() },
            11 => StatementKind::Repeat { body: self.body(), until: self.value(Scalar::Bool) },
            12 if self.loops > 0 => StatementKind::Exit { depth: u32::from(self.choose(self.loops as u8)) },
            13 if self.loops > 0 => StatementKind::Continue { depth: u32::from(self.choose(self.loops as u8)) },
            14 if self.inside != Inside::Function => StatementKind::Call(self.function_call(false)),
            14 if self.choose(4) == 0 => StatementKind::Return,
            15 if self.inside == Inside::Main => StatementKind::Call(self.instance_call()),
            15 if self.uses_ok => StatementKind::SetOk(self.value(Scalar::Bool)),
            _ => {
                let scalar = self.scalar();
                let target = self.place(scalar);
                StatementKind::Assign { value: self.value(scalar), target }
            }
        };
        Statement { kind, span: Span::default() }
    }

    fn body(&mut self) -> Vec<Statement> {
        self.loops += 1;
        let body = self.statements(3);
        self.loops -= 1;
        body
    }

    fn case(&mut self) -> StatementKind {
        let scalar = [Scalar::I16, Scalar::U8, Scalar::I64][usize::from(self.choose(3))];
        let step = i128::from(1 + 7 * self.choose(3));
        let mut low = if scalar == Scalar::U8 { 0 } else { -4 };
        let count = 1 + self.choose(12);
        let branches = (0..count)
            .map(|_| {
                let high = low + i128::from(self.choose(3));
                let ranges = vec![(low, high)];
                low = high + step - i128::from(self.choose(2));
                Branch { ranges, span: Span::default(), body: self.statements(1) }
            })
            .collect();
        let otherwise = if self.choose(2) == 0 { Vec::new() } else { self.statements(1) };
        StatementKind::Case { selector: self.value(scalar), branches, otherwise }
    }

    fn for_loop(&mut self) -> StatementKind {
        let scalar = [Scalar::I16, Scalar::I32, Scalar::I64, Scalar::U8][usize::from(self.choose(4))];
        let (from, to, by) = match self.choose(3) {
            0 => (self.value(scalar), self.value(scalar), self.value(scalar)),
            1 => (self.constant(scalar), self.value(scalar), value(ValueKind::Constant(1), scalar)),
            _ => (self.constant(scalar), self.constant(scalar), self.constant(scalar)),
        };
        StatementKind::For(Box::new(For { variable: self.place(scalar), scalar, from, to, by, each_pass: false, body: self.body() }))
    }
}

fn value(kind: ValueKind, scalar: Scalar) -> Value {
    Value { kind, scalar, span: Span::default() }
}

fn place(base: Base, offset: u32) -> Place {
    Place { base, offset, indexes: Vec::new(), span: Span::default() }
}

fn function_block() -> BlockId {
    BlockId::new(BlockKind::FunctionBlock, 1)
}

/// FC 1 (x0 : INT, x1 : DINT; x2 : INT out; x3 : DINT in-out) : DINT.
fn function_interface() -> Interface {
    let variables = [
        (Section::Input, DataType::Int),
        (Section::Input, DataType::DoubleInt),
        (Section::Output, DataType::Int),
        (Section::InOut, DataType::DoubleInt),
        (Section::Return, DataType::DoubleInt),
    ];
    let variable = |(index, (section, data_type)): (usize, (Section, DataType))| Variable {
        name: format!("x{index}"),
        section,
        data_type,
        offset: index as u32,
        initial: Vec::new(),
        comment: String::new(),
        span: Span::default(),
    };
    Interface { variables: variables.into_iter().enumerate().map(variable).collect(), ..Interface::default() }
}

fn body(statements: Vec<Statement>, uses_ok: bool) -> Body {
    let bytes = DataType::Array { bounds: vec![(1, REGION as i32)], element: Box::new(DataType::Byte) };
    let local = Local { position: 8 * LOCAL, data_type: bytes, initial: Some(vec![0; REGION]) };
    Body { statements, locals: vec![local], local_size: LOCAL + REGION as u32, uses_ok, ..Body::default() }
}

struct Quiet {
    /// Faults that end a statement, and those that are only told: the model has none of these.
    faults: usize,
    noted: usize,
    safe_points: usize,
}

impl Host for Quiet {
    fn fault(&mut self, _: &mut Machine, fault: &Fault, _: FaultPlace) -> Reaction {
        *if fault.is_noted() { &mut self.noted } else { &mut self.faults } += 1;
        Reaction::Continue
    }
    fn peripheral_read(&mut self, _: &mut Machine, _: u32, _: Width) -> Option<u32> {
        None
    }
    fn peripheral_write(&mut self, _: &mut Machine, _: u32, _: Width, _: u32) -> bool {
        false
    }
    fn safe_point(&mut self, machine: &mut Machine, _: FaultPlace) -> Reaction {
        machine.budget = 10;
        self.safe_points += 1;
        if self.safe_points < SAFE_POINTS_MAX { Reaction::Continue } else { Reaction::Stop(StopReason { event: 0x4303, place: None }) }
    }
    fn system_function(&mut self, _: &mut Machine, _: BlockId, _: usize) -> Reaction {
        Reaction::Continue
    }
}

/// What a run leaves.
#[derive(Clone, Debug, PartialEq)]
struct Left {
    exit: Exit,
    arena: Vec<u8>,
    br: u64,
    budget: i64,
    faults: usize,
    noted: usize,
}

/// Compares both engines, and the model unless the program takes too long.
pub fn fuzz(data: &[u8]) {
    let flags = data.first().copied().unwrap_or(0);
    let mut generator = Generator { data, at: 1, inside: Inside::Function, depth: 0, loops: 0, uses_ok: false };
    let mut uses_ok = [false; 3];
    let mut make = |inside: Inside, bit: usize| {
        uses_ok[bit] = flags >> bit & 1 != 0;
        (generator.inside, generator.uses_ok) = (inside, uses_ok[bit]);
        // What is left of the input is shared by the blocks that come.
        generator.statements(if inside == Inside::Main { 20 } else { 5 })
    };
    let function = make(Inside::Function, 1);
    let block = make(Inside::FunctionBlock, 2);
    let main = make(Inside::Main, 0);

    let parameters = Arc::new(function_interface());
    let known = |id: BlockId| (id == BlockId::fc(1)).then(|| Arc::clone(&parameters));
    let mut code = BTreeMap::new();
    for (id, interface, statements, uses_ok) in [
        (BlockId::ob(1), Interface::default(), main.clone(), uses_ok[0]),
        (BlockId::fc(1), function_interface(), function.clone(), uses_ok[1]),
        (function_block(), Interface::default(), block.clone(), uses_ok[2]),
    ] {
        let lowered = lower(id, &interface, &body(statements, uses_ok), &Known { interface: &known, is_stl: &|_| false });
        assert_eq!(verify(&lowered.code), Ok(()), "{id}\n{}", lowered.code);
        assert_eq!(lowered.spans.len(), lowered.code.statement_count(), "every statement has its place");
        code.insert(id, lowered);
    }
    let data_block = |number: u16| DataBlock {
        number,
        based_on: None,
        structure: Arc::default(),
        image: vec![0; REGION],
        read_only: false,
        non_retain: false,
        unlinked: false,
    };
    let data_blocks = (1..=2).map(|number| (number, data_block(number))).collect();
    let program = Program { code, data: data_blocks, ..Program::default() };
    let layout = Layout::new(CpuType::by_name("317-2PN/DP").unwrap_or(&CpuType::ALL[0]), &program);

    let mut memory = [0; REGION];
    for (index, byte) in memory.iter_mut().enumerate() {
        *byte = data.get(data.len() / 3 + index).map_or(0, |byte| byte % 7);
    }
    let run = |engine: &dyn Engine, local: u8| {
        let mut machine = Machine::new(Arc::new(layout.clone()));
        machine.budget = 10;
        machine.memory.arena[layout.local.clone()].fill(local);
        machine.memory.area_mut(Area::BitMemory)[..REGION].copy_from_slice(&memory);
        let mut host = Quiet { faults: 0, noted: 0, safe_points: 0 };
        let entry = Entry { block: BlockId::ob(1), start_information: [0; 20], registers: None };
        let exit = engine.run(&mut Context { machine: &mut machine, host: &mut host, tracer: None }, &entry);
        let left = Left {
            exit,
            arena: machine.memory.arena.clone(),
            br: machine.registers.br,
            budget: machine.budget,
            faults: host.faults,
            noted: host.noted,
        };
        (left, machine)
    };
    let (interpreted, machine) = run(Interpreter::load(&program, &layout).as_ref(), 0);
    let blocks = || program.code.iter().map(|(id, block)| format!("{id}\n{}\n", block.code)).collect::<String>();
    match Jit::compiled(&program, &layout, StatusBits::All) {
        Ok(native) => {
            assert_eq!(run(native.as_ref(), 0).0, interpreted, "machine code does what the interpreter does\n{}", blocks());
        }
        // A program may be too large; but what is translated is right.
        Err(reason) => assert!(!reason.contains("Compilation"), "the program becomes machine code: {reason}"),
    }
    // Blocks that read of their local data only what they have written do not see what others left there.
    if program.code.values().all(|block| block.reads_own_locals)
        && let Ok(native) = Jit::compiled(&program, &layout, StatusBits::Needed)
    {
        let seen = |left: Left| {
            let mut arena = left.arena;
            arena[layout.local.clone()].fill(0);
            (left.exit, arena, left.budget, left.faults)
        };
        let [wanted, got] = [seen(interpreted.clone()), seen(run(native.as_ref(), 0xA5).0)];
        assert_eq!(got, wanted, "optimized machine code does what the interpreter does\n{}", blocks());
    }
    if interpreted.exit != Exit::Finished {
        return;
    }
    let mut model = Model::new(Blocks { main: &main, function: &function, function_block: &block, uses_ok }, memory);
    let Some(br) = model.run() else { return };
    let data_of = |number: u64| {
        let entry = machine.memory.data_block(number).expect("the program has it");
        &machine.memory.arena[entry.base as usize..][..REGION]
    };
    let shown = || {
        let spell =
            |statements: &[Statement]| format!("{statements:?}").replace(", span: Span { file: SourceId(0), start: 0, end: 0 }", "");
        format!("{}\nOB {}\nFC {}\nFB {}", program.code[&BlockId::ob(1)].code, spell(&main), spell(&function), spell(&block))
    };
    assert_eq!(machine.memory.area(Area::BitMemory)[..REGION], model.memory, "bit memory is what the model says\n{}", shown());
    assert_eq!(*data_of(1), model.data, "DB 1 is what the model says\n{}", shown());
    assert_eq!(*data_of(2), model.instance, "DB 2 is what the model says\n{}", shown());
    assert_eq!((interpreted.faults, interpreted.br), (model.faults, u64::from(br)), "faults and BR are what the model says\n{}", shown());
}
