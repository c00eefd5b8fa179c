//! Runs under a Host that notes what it is asked and answers as a test says.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::{Register, Registers};
use sieben_engine::{CodeBlock, Context, Engine, Entry, Exit, Fault, FaultPlace, Host, Interpreter, Layout, Machine, Program, Reaction};
use sieben_jit::{Jit, StatusBits};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;

/// What the Host was asked, and the machine that the run left.
#[derive(Debug, PartialEq)]
pub(crate) struct Outcome {
    pub(crate) asked: Vec<String>,
    pub(crate) exit: Exit,
    pub(crate) arena: Vec<u8>,
    pub(crate) registers: Registers,
    pub(crate) budget: i64,
}

impl Outcome {
    /// Both were asked the same, left the same memory and ended in the same way; registers are for the caller to compare, who knows which
    /// count.
    pub(crate) fn assert_ends_as(&self, expected: &Self, what: &dyn Fn() -> String) {
        assert_eq!(self.asked, expected.asked, "{}", what());
        assert_eq!(self.arena.len(), expected.arena.len(), "{}", what());
        if self.arena != expected.arena {
            let differ = self.arena.iter().zip(&expected.arena).position(|(got, expected)| got != expected);
            panic!("memory differs at {differ:?}: {}", what());
        }
        assert_eq!((&self.exit, self.budget), (&expected.exit, expected.budget), "{}", what());
    }
}

/// A Host that notes what it is asked and answers as a test says.
pub(crate) struct Noting<'a> {
    asked: Vec<String>,
    answer: &'a dyn Fn(&mut Machine, &str, usize) -> Reaction,
}

impl Noting<'_> {
    fn ask(&mut self, machine: &mut Machine, what: String) -> Reaction {
        let before = self.asked.len();
        let reaction = (self.answer)(machine, &what, before);
        self.asked.push(what);
        reaction
    }
}

impl Host for Noting<'_> {
    fn fault(&mut self, machine: &mut Machine, fault: &Fault, place: FaultPlace) -> Reaction {
        self.ask(machine, format!("{fault:?} at {} {}", place.block, place.statement))
    }
    fn peripheral_read(&mut self, _: &mut Machine, _: u32, _: Width) -> Option<u32> {
        None
    }
    fn peripheral_write(&mut self, _: &mut Machine, _: u32, _: Width, _: u32) -> bool {
        false
    }
    fn safe_point(&mut self, machine: &mut Machine, place: FaultPlace) -> Reaction {
        machine.budget = 1;
        self.ask(machine, format!("safe point at {} {}", place.block, place.statement))
    }
    fn system_function(&mut self, machine: &mut Machine, block: BlockId, _: usize) -> Reaction {
        self.ask(machine, block.to_string())
    }
}

/// Whether a question tells of an index that is noted: who is told of that changes nothing.
pub(crate) fn is_noted(what: &str) -> bool {
    what.contains(&format!("code: {}", NOTED | 0x22))
}

pub(crate) type Blocks<'a> = &'a [(BlockId, u32, &'a dyn Fn(&mut Builder))];
pub(crate) type Answer<'a> = &'a dyn Fn(&mut Machine, &str, usize) -> Reaction;

pub(crate) fn program(blocks: Blocks<'_>) -> Program {
    let mut code = BTreeMap::new();
    for &(id, local_size, build) in blocks {
        let mut builder = Builder::default();
        build(&mut builder);
        code.insert(id, CodeBlock { code: builder.finish(), local_size, ..CodeBlock::default() });
    }
    Program { code, ..Program::default() }
}

/// A layout in which data block 1 has 16 bytes, with room behind them.
pub(crate) fn layout(program: &Program) -> Layout {
    let mut layout = Layout::new(CpuType::by_name("315-2PN/DP").expect("a CPU type"), program);
    layout.size += 64;
    layout.data_blocks.insert(1, layout.size - 64..layout.size - 48);
    layout
}

/// A layout in which data block 1 has so many bytes.
pub(crate) fn layout_with(program: &Program, bytes: usize) -> Layout {
    let mut layout = layout(program);
    layout.size += bytes;
    layout.data_blocks.insert(1, layout.size - bytes..layout.size);
    layout
}

/// Opens data block 1 twice and calls a function block whose instance begins there.
pub(crate) fn begin_with_instance(b: &mut Builder, function_block: u16) {
    b.begin_statement();
    for register in [DataRegister::Instance, DataRegister::Shared] {
        let number = b.constant(1);
        b.push(Inst::Open { register, number });
    }
    b.set(Register::Ar2, 0x8400_0000);
    b.push(Inst::Call { callee: Callee::Block(BlockId::fb(function_block)), parameters: 0 });
}

/// Ends a block that counts iterations: see [`next_iteration`].
pub(crate) fn count_on(b: &mut Builder, counter: Place, limit: (Op, u64), first: Target) {
    next_iteration(b, counter, limit, first);
    b.begin_statement();
    b.push(Inst::Return);
}

/// The next number, and the first statement of an iteration again if that holds, compared with a limit.
pub(crate) fn next_iteration(b: &mut Builder, counter: Place, (op, limit): (Op, u64), first: Target) {
    let (number, one) = (b.load(counter, Width::Word, OnFault::SkipStatement), b.constant(1));
    let next = b.compute(Op::AddU16, &[number, one]);
    b.store(counter, Width::Word, next);
    let limit = b.constant(limit);
    let again = b.compute(op, &[next, limit]);
    b.push(Inst::Branch { condition: again, to: first });
}

/// A variable in bit memory that begins with a byte.
pub(crate) fn fixed(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

/// What it holds.
pub(crate) fn get(b: &mut Builder, byte: u32, width: Width) -> Var {
    b.load(fixed(byte), width, OnFault::SkipStatement)
}

/// The element of an array at the beginning of bit memory whose number is in a variable.
pub(crate) fn element_at(b: &mut Builder, counter: u32, width: Width) -> Var {
    let counter = get(b, counter, Width::DoubleWord);
    let bits = b.constant(u64::from(8 * width.bytes()));
    let pointer = b.compute(Op::MulU32, &[counter, bits]);
    b.load(Place::Indirect { area: Area::BitMemory, pointer, offset: 0 }, width, OnFault::SkipStatement)
}

/// `FOR counter := 0 TO last DO … END_FOR`; what is in it begins with statement 1 and says where it ends.
pub(crate) fn counted(b: &mut Builder, counter: u32, last: u64, iteration: impl FnOnce(&mut Builder) -> u32) {
    b.begin_statement();
    let zero = b.constant(0);
    b.store(fixed(counter), Width::DoubleWord, zero);
    iteration(b);
    b.begin_statement();
    let number = get(b, counter, Width::DoubleWord);
    let one = b.constant(1);
    let next = b.compute(Op::AddU32, &[number, one]);
    b.store(fixed(counter), Width::DoubleWord, next);
    let last = b.constant(last);
    let condition = b.compute(Op::LeI32, &[next, last]);
    b.push(Inst::Branch { condition, to: Target(1) });
    b.begin_statement();
    b.push(Inst::Return);
}

pub(crate) fn run(engine: &dyn Engine, layout: &Layout, entry: &Entry, prepare: &dyn Fn(&mut Machine), answer: Answer<'_>) -> Outcome {
    let mut machine = Machine::new(Arc::new(layout.clone()));
    machine.budget = 1;
    prepare(&mut machine);
    let mut host = Noting { asked: Vec::new(), answer };
    let exit = engine.run(&mut Context { machine: &mut machine, host: &mut host, tracer: None }, entry);
    Outcome { asked: host.asked, exit, arena: machine.memory.arena, registers: machine.registers, budget: machine.budget }
}

/// The same beside somebody who meddles with the machine whenever it asks, as dice tell.
pub(crate) fn run_beside<D>(
    engine: &dyn Engine,
    layout: &Layout,
    entry: &Entry,
    prepare: &dyn Fn(&mut Machine),
    dice: D,
    meddle: &dyn Fn(&mut Machine, &str, &mut D, usize) -> Reaction,
) -> Outcome {
    let dice = RefCell::new(dice);
    run(engine, layout, entry, prepare, &|machine, what, asked| meddle(machine, what, &mut dice.borrow_mut(), asked))
}

/// A program in the interpreter and as machine code, with all status bits and with those that are needed.
pub(crate) struct Engines<'a> {
    program: &'a Program,
    layout: &'a Layout,
    reference: Arc<dyn Engine>,
    native: [(StatusBits, Arc<dyn Engine>); 2],
}

/// Compiles a program for all engines.
pub(crate) fn engines<'a>(program: &'a Program, layout: &'a Layout) -> Engines<'a> {
    let native = |status| (status, Jit::compiled(program, layout, status).expect("machine code"));
    Engines { program, layout, reference: Interpreter::load(program, layout), native: [StatusBits::All, StatusBits::Needed].map(native) }
}

/// Runs a program on all engines: all have to end alike, with all status bits in their `registers` too if these count. What the interpreter
/// left.
pub(crate) fn all_engines_agree(
    engines: &Engines<'_>,
    registers: bool,
    outcome: &dyn Fn(Arc<dyn Engine>) -> Outcome,
    what: &dyn Fn() -> String,
) -> Outcome {
    let expected = outcome(engines.reference.clone());
    for (status, engine) in &engines.native {
        let got = outcome(engine.clone());
        got.assert_ends_as(&expected, &|| format!("{status:?} {}", what()));
        if registers && *status == StatusBits::All {
            assert_eq!(got.registers, expected.registers, "{}", what());
        }
    }
    expected
}

/// Runs a program from so many memories on all engines, with answers that change nothing: all have to end alike. In how many of these runs
/// the Host was asked nothing.
pub(crate) fn all_engines_agree_from(
    (program, layout): (&Program, &Layout),
    memories: u64,
    prepare: &dyn Fn(&mut Machine, u64),
    what: &str,
) -> u64 {
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    let engines = engines(program, layout);
    let code = || program.code.iter().map(|(id, block)| format!("\n{id}\n{}", block.code)).collect::<String>();
    let mut silent = 0;
    for memory in 0..memories {
        let prepare = |machine: &mut Machine| prepare(machine, memory);
        let outcome = |engine: Arc<dyn Engine>| run(engine.as_ref(), layout, &entry, &prepare, &|_, _, _| Reaction::Continue);
        let expected = all_engines_agree(&engines, false, &outcome, &|| format!("{what}, memory {memory}{}", code()));
        silent += u64::from(expected.asked.is_empty());
    }
    silent
}

/// The same as [`all_engines_agree`] for a random run of OB 1: beside each engine somebody meddles with the machine whenever it asks, as
/// dice that begin again tell.
pub(crate) fn all_engines_agree_beside<D>(
    engines: &Engines<'_>,
    prepare: &dyn Fn(&mut Machine),
    dice: &dyn Fn() -> D,
    meddle: &dyn Fn(&mut Machine, &mut D, usize) -> Reaction,
    what: &str,
) -> Outcome {
    let block = BlockId::ob(1);
    let entry = Entry { block, start_information: [7; 20], registers: None };
    let outcome = |engine: Arc<dyn Engine>| {
        run_beside(engine.as_ref(), engines.layout, &entry, prepare, dice(), &|machine, _, dice, asked| meddle(machine, dice, asked))
    };
    let what = || format!("{what}\n{}", engines.program.code[&block].code);
    all_engines_agree(engines, true, &outcome, &what)
}

/// The same for a program that asks one question, behind which it may go on for long.
pub(crate) fn all_engines_ask_once(program: &Program, layout: &Layout, what: &str) {
    let prepare = |machine: &mut Machine| machine.budget = 1000;
    let answer = |machine: &mut Machine, (): &mut (), _: usize| {
        machine.budget = 1000;
        Reaction::Continue
    };
    let ended = all_engines_agree_beside(&engines(program, layout), &prepare, &|| (), &answer, what);
    assert_eq!(ended.asked.len(), 1, "{:?}", ended.asked);
}
