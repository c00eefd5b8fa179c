//! Whole programs on both engines: whatever a program does, interpreter and machine code leave the same memory, registers,
//! timers, counters, budget and diagnostic buffer.
//!
//! The input chooses the statements of a program that compiles: bit logic, arithmetic, indirect addressing that may miss its area,
//! calls, loops, interrupts by faults and at any safe point, system functions, HOLD, STOP and a restart. An input that is itself a
//! program is run too.

use std::cell::Cell;
use std::fmt::Write as _;
use std::hash::{DefaultHasher, Hasher as _};
use std::sync::{Arc, Mutex, PoisonError};

use sieben_cpu::{Cpu, Interrupt, OperatingMode, Rack, Restart, Settings};
use sieben_engine::machine::{Origin, Register, Registers};
use sieben_engine::{Context, Engine, Entry, Exit, Fault, FaultPlace, Host, Interpreter, Layout, Machine, Program, Reaction};
use sieben_jit::{Jit, StatusBits, Tier, Tiers};
use sieben_lang::Options;
use sieben_model::address::Width;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Severity;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

/// Safe points that a program may pass in one scan.
const SAFE_POINTS_MAX: i64 = 3_000;
/// Scans that are compared.
const SCANS: u64 = 4;
/// Statements of one block at most.
const STATEMENTS_MAX: usize = 160;
/// Labels of a block, spread over it.
const LABELS: usize = 6;

/// Runs the input if it is text, else the program that it chooses.
pub fn fuzz(data: &[u8]) {
    match std::str::from_utf8(data) {
        Ok(text) if text.contains(';') => compare(text, data),
        _ => compare(&chosen(data), data),
    }
}

/// What happens to the CPU from outside in one scan.
struct Outside {
    /// An organization block, and the safe point at which its event comes; more than once is a storm.
    interrupts: Vec<(u64, u16)>,
    /// Somebody asks for HOLD, and for going on after it.
    hold: bool,
}

/// Organization blocks that are interrupted by each other.
const INTERRUPTS: [u16; 5] = [40, 35, 20, 82, 80];

/// What happens in a scan, chosen by bytes of the input.
fn outside(data: &[u8], scan: u64) -> Outside {
    let at = |index: usize| data.get((data.len() / 2 + 8 * scan as usize + index) % data.len().max(1)).copied().unwrap_or(0);
    let ob = |index: usize| INTERRUPTS[usize::from(at(index)) % INTERRUPTS.len()];
    let interrupts = match at(0) % 4 {
        0 => Vec::new(),
        1 => (1..=60).map(|point| (point, 40)).collect(),
        _ => (1..4).map(|index| (1 + u64::from(at(2 * index) % 48), ob(2 * index + 1))).collect(),
    };
    Outside { interrupts, hold: at(1) % 5 == 0 }
}

/// One scan with what happens in it. A CPU that went to STOP is started again, hot if it can.
fn scan(cpu: &mut Cpu, number: u64, outside: &Outside) {
    if cpu.mode() == OperatingMode::Stop {
        cpu.restart(Restart::Hot);
    }
    for &(point, ob) in &outside.interrupts {
        cpu.raise_at_safe_point(point, Interrupt::usual(ob).expect("events start it"));
    }
    if outside.hold {
        cpu.stop_request().hold();
    }
    cpu.scan(number * 10_000);
    // A HOLD may come again: the last request is answered by the first safe point after it.
    for later in 1..=2 {
        cpu.resume(number * 10_000 + later);
    }
}

/// Runs a program on both engines, if it compiles.
fn compare(text: &str, data: &[u8]) {
    let cpu_type = &CpuType::ALL[data.len() % CpuType::ALL.len()];
    let mut sources = Sources::default();
    sources.add("fuzz.awl", text);
    let options = Options { cpu: Some(cpu_type), system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
    let compiled = sieben_lang::compile(&sources, &SymbolTable::default(), &options);
    if compiled.diagnostics.iter().any(|diagnostic| diagnostic.severity() == Severity::Error) {
        return;
    }
    let program = Arc::new(compiled.program);
    let load = |load: &dyn Fn(&Program, &Layout) -> Arc<dyn Engine>| {
        let settings = Settings { virtual_safe_points: SAFE_POINTS_MAX, ..Settings::default() };
        let mut cpu = Cpu::load(cpu_type, Arc::clone(&program), load, Rack::simulated(cpu_type), settings);
        cpu.restart(Restart::Warm);
        cpu
    };
    let expected = Arc::<Mutex<Seen>>::default();
    let seen_by =
        |engine: Arc<dyn Engine>, seen: &Arc<Mutex<Seen>>| -> Arc<dyn Engine> { Arc::new(Watched { engine, seen: Arc::clone(seen) }) };
    let mut interpreted = load(&|program, layout| seen_by(Interpreter::load(program, layout), &expected));
    let mut natives = [StatusBits::All, StatusBits::Needed].map(|status| {
        let seen = Arc::<Mutex<Seen>>::default();
        let machine_code = |program: &Program, layout: &Layout| {
            let engine = Jit::compiled(program, layout, status).unwrap_or_else(|reason| {
                // A program may be too large; but what is translated is right.
                assert!(!reason.contains("Compilation"), "the program becomes machine code: {reason}");
                Interpreter::load(program, layout)
            });
            seen_by(engine, &seen)
        };
        (status, load(&machine_code), seen)
    });
    let tiers = Cell::new(None);
    let mut tiered = load(&|program, layout| {
        let loaded = Tiers::load(program, layout, StatusBits::All);
        let engine = loaded.engine();
        tiers.set(Some(loaded));
        engine
    });
    let tiers = tiers.take().expect("the program was loaded");
    let mut stops = 0;
    for number in 0..SCANS {
        let outside = outside(data, number);
        scan(&mut interpreted, number, &outside);
        let tier = Tier::ALL[usize::from(data.get(number as usize).copied().unwrap_or(0)) % Tier::ALL.len()];
        if let Err(reason) = tiers.compile(tier) {
            assert!(!reason.contains("Compilation"), "the program becomes machine code: {reason}");
        }
        scan(&mut tiered, number, &outside);
        if let Some(what) = difference(&interpreted, &tiered, StatusBits::All) {
            panic!("after scan {number}, which began in another tier ({:?}), the engines differ in {what}:\n{text}", tiers.tier());
        }
        for (status, native, seen) in &mut natives {
            scan(native, number, &outside);
            if let Some(what) = difference_in_what_was_seen(&expected, seen) {
                panic!("in scan {number} the engines ({status:?}) show different machines:\n{what}\n{text}");
            }
            if let Some(what) = difference(&interpreted, native, *status) {
                panic!("after scan {number} the engines ({status:?}) differ in {what}:\n{text}");
            }
        }
        stops += u64::from(interpreted.mode() != OperatingMode::Run);
        // What a hot restart goes on with may depend on status bits that nobody calculated.
        if stops > 1 {
            return;
        }
    }
}

/// What a Host has seen of the machine when it was asked: the newest questions as text, and how many there were.
#[derive(Default)]
struct Seen {
    count: usize,
    questions: Vec<String>,
}

/// Questions that are compared: each is a page of text and a look at all memory.
const SEEN_MAX: usize = 40;

/// The first question in which two Hosts saw something else.
fn difference_in_what_was_seen(expected: &Mutex<Seen>, got: &Mutex<Seen>) -> Option<String> {
    let [expected, got] = [expected, got].map(|seen| seen.lock().unwrap_or_else(PoisonError::into_inner));
    let pairs = expected.questions.iter().zip(&got.questions);
    if let Some((expected, got)) = pairs.clone().find(|(expected, got)| expected != got) {
        return Some(format!("{expected}\n{got}\n"));
    }
    (expected.count != got.count).then(|| format!("{} questions and {}", expected.count, got.count))
}

/// An engine whose Host notes what it is shown.
struct Watched {
    engine: Arc<dyn Engine>,
    seen: Arc<Mutex<Seen>>,
}

/// The Host of the CPU, and somebody who looks over its shoulder.
struct Shoulder<'a> {
    host: &'a mut dyn Host,
    seen: &'a Mutex<Seen>,
}

impl Shoulder<'_> {
    fn note(&self, question: std::fmt::Arguments<'_>, machine: &Machine, of_module: bool) {
        let mut seen = self.seen.lock().unwrap_or_else(PoisonError::into_inner);
        seen.count += 1;
        if seen.questions.len() >= SEEN_MAX {
            return;
        }
        // A module is read and written without a look at the registers.
        let mut registers = if of_module { Registers::fresh() } else { machine.registers.clone() };
        // Where nobody reads them, they may be old.
        SPARED.into_iter().for_each(|register| registers.set(register, 0));
        let mut sum = DefaultHasher::new();
        sum.write(&machine.memory.arena);
        let sum = sum.finish();
        let Machine { parameters, budget, .. } = machine;
        let mut frames = machine.frames.clone();
        for frame in &mut frames {
            if let Origin::Interrupt { registers, .. } = &mut frame.origin {
                SPARED.into_iter().for_each(|register| registers.set(register, 0));
            }
        }
        // Where the newest goes on is for the engine to remember until it is left.
        if let Some(newest) = frames.last_mut() {
            newest.resume = 0;
        }
        seen.questions.push(format!("{question}: memory {sum:X}, budget {budget}, parameters {parameters:X?}\n{registers:?}\n{frames:?}"));
    }
}

impl Host for Shoulder<'_> {
    fn fault(&mut self, machine: &mut Machine, fault: &Fault, place: FaultPlace) -> Reaction {
        self.note(format_args!("{fault:?} at {place:?}"), machine, false);
        self.host.fault(machine, fault, place)
    }
    fn peripheral_read(&mut self, machine: &mut Machine, byte: u32, width: Width) -> Option<u32> {
        self.note(format_args!("read of {byte}, {width:?}"), machine, true);
        self.host.peripheral_read(machine, byte, width)
    }
    fn peripheral_write(&mut self, machine: &mut Machine, byte: u32, width: Width, value: u32) -> bool {
        self.note(format_args!("write of {byte}, {width:?}, {value:X}"), machine, true);
        self.host.peripheral_write(machine, byte, width, value)
    }
    fn safe_point(&mut self, machine: &mut Machine, place: FaultPlace) -> Reaction {
        self.note(format_args!("safe point at {place:?}"), machine, false);
        self.host.safe_point(machine, place)
    }
    fn system_function(&mut self, machine: &mut Machine, block: BlockId, first_parameter: usize) -> Reaction {
        self.note(format_args!("call of {block} with {first_parameter}"), machine, false);
        self.host.system_function(machine, block, first_parameter)
    }
    fn has_system_function(&self, block: BlockId) -> bool {
        self.host.has_system_function(block)
    }
}

impl Engine for Watched {
    fn run(&self, context: &mut Context<'_>, entry: &Entry) -> Exit {
        let mut host = Shoulder { host: context.host, seen: &self.seen };
        self.engine.run(&mut Context { machine: context.machine, host: &mut host, tracer: None }, entry)
    }
    fn resume(&self, context: &mut Context<'_>) -> Exit {
        let mut host = Shoulder { host: context.host, seen: &self.seen };
        self.engine.resume(&mut Context { machine: context.machine, host: &mut host, tracer: None })
    }
    fn go_on(&self, context: &mut Context<'_>) -> Exit {
        self.engine.go_on(context)
    }
    fn has_block(&self, block: BlockId) -> bool {
        self.engine.has_block(block)
    }
    fn code_bytes(&self) -> usize {
        self.engine.code_bytes()
    }
}

/// Status bits that are calculated only where they are needed.
const SPARED: [Register; 7] = [Register::Fc, Register::Sta, Register::Or, Register::Os, Register::Ov, Register::Cc0, Register::Cc1];

/// In what two CPUs differ.
fn difference(interpreted: &Cpu, native: &Cpu, status: StatusBits) -> Option<String> {
    let (expected, got) = (interpreted.machine(), native.machine());
    if expected.memory != got.memory {
        let at = expected.memory.arena.iter().zip(&got.memory.arena).position(|(expected, got)| expected != got);
        return Some(format!("memory, arena byte {at:?}"));
    }
    let shown = |registers: &Registers| {
        let mut registers = registers.clone();
        if status == StatusBits::Needed {
            SPARED.into_iter().for_each(|register| registers.set(register, 0));
        }
        registers
    };
    if shown(&expected.registers) != shown(&got.registers) {
        return Some(format!("registers:\n{:?}\n{:?}\n", expected.registers, got.registers));
    }
    if (&expected.timers, &expected.counters) != (&got.timers, &got.counters) {
        return Some("timers or counters".to_owned());
    }
    if expected.budget != got.budget {
        return Some(format!("budget: {} and {}", expected.budget, got.budget));
    }
    if interpreted.stop_cause() != native.stop_cause() {
        return Some(format!("the cause of STOP: {:?} and {:?}", interpreted.stop_cause(), native.stop_cause()));
    }
    let [expected, got] = [interpreted, native].map(|cpu| cpu.diagnostic_buffer().entries().cloned().collect::<Vec<_>>());
    (expected != got).then(|| "the diagnostic buffer".to_owned())
}

/// Bytes that choose.
struct Choices<'a>(std::slice::Iter<'a, u8>);

impl Choices<'_> {
    fn more(&self) -> bool {
        self.0.len() > 0
    }
    fn below(&mut self, limit: usize) -> usize {
        self.0.next().map_or(0, |&byte| usize::from(byte) % limit.max(1))
    }
    fn of<'t>(&mut self, words: &[&'t str]) -> &'t str {
        words[self.below(words.len())]
    }
}

/// The program that an input chooses.
fn chosen(data: &[u8]) -> String {
    let mut choices = Choices(data.iter());
    let mut text = String::from(
        "DATA_BLOCK DB 1\nSTRUCT\n a : ARRAY [0..31] OF WORD;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n\
         DATA_BLOCK DB 2\nSTRUCT\n a : ARRAY [0..7] OF DINT;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n\
         DATA_BLOCK DB 3\nREAD_ONLY\nSTRUCT\n a : ARRAY [0..7] OF WORD;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n",
    );
    let handlers = choices.below(16);
    let mut blocks = vec![FC_11, FB_11, FC_12, FB_12, FC_1, FB_1, FC_2];
    for (bit, numbers) in [(1, &[121][..]), (2, &[122, 80]), (4, &[40, 35]), (8, &[20, 82])] {
        if handlers & bit != 0 {
            blocks.extend(numbers.iter().map(|&number| Head { number, ..OB }));
        }
    }
    blocks.push(Head { number: 1, ..OB });
    let share = (data.len() / blocks.len()).max(1);
    for (index, block) in blocks.iter().enumerate() {
        let last = index + 1 == blocks.len();
        let end = choices.0.len().saturating_sub(share);
        let mut statements = Vec::new();
        while choices.more() && (last || choices.0.len() > end) && statements.len() < STATEMENTS_MAX {
            statements.push(statement(&mut choices, block, statements.len()));
        }
        let _ = writeln!(text, "{} {}{}", block.kind, block.number, block.declarations);
        text.push_str("BEGIN\n");
        for label in 0..LABELS {
            let (from, to) = (label * statements.len() / LABELS, (label + 1) * statements.len() / LABELS);
            let _ = writeln!(text, "l{label}: NOP 0;");
            statements[from..to].iter().for_each(|statement| text.push_str(statement));
        }
        let _ = writeln!(text, "END_{}", block.kind.split(' ').next().unwrap_or_default());
    }
    for (db, fb) in [(4, 1), (11, 11), (12, 12), (13, 11)] {
        let _ = writeln!(text, "DATA_BLOCK DB {db}\nFB {fb}\nBEGIN\nEND_DATA_BLOCK");
    }
    text
}

/// What a block may call.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Calls {
    /// Nothing: it is small enough to become part of its callers.
    Nothing,
    /// Blocks that call nothing.
    Leaves,
    /// Everything, itself too.
    Everything,
}

/// A block without its statements.
struct Head {
    kind: &'static str,
    number: u16,
    declarations: &'static str,
    /// Whether it has `#n`, `#b` and `#w`.
    parameters: bool,
    /// Whether it has all other kinds of parameters too.
    all_kinds: bool,
    calls: Calls,
}

const OB: Head = Head {
    kind: "ORGANIZATION_BLOCK OB",
    number: 1,
    declarations: "\nVAR_TEMP\n i : ARRAY [0..19] OF BYTE;\n t : ARRAY [0..9] OF WORD;\nEND_VAR",
    parameters: false,
    all_kinds: false,
    calls: Calls::Everything,
};
const FC_1: Head = Head {
    kind: "FUNCTION FC",
    number: 1,
    declarations: " : VOID\nVAR_INPUT\n n : INT;\n b : BOOL;\nEND_VAR\nVAR_IN_OUT\n w : WORD;\nEND_VAR\nVAR_TEMP\n t : ARRAY [0..9] OF WORD;\nEND_VAR",
    parameters: true,
    all_kinds: false,
    calls: Calls::Everything,
};
const FB_1: Head = Head {
    kind: "FUNCTION_BLOCK FB",
    number: 1,
    declarations: "\nVAR_INPUT\n n : INT;\n b : BOOL;\nEND_VAR\nVAR_IN_OUT\n w : WORD;\nEND_VAR\nVAR\n s : ARRAY [0..9] OF WORD;\nEND_VAR\nVAR_TEMP\n t : ARRAY [0..9] OF WORD;\nEND_VAR",
    parameters: true,
    all_kinds: false,
    calls: Calls::Everything,
};
const FC_2: Head = Head {
    kind: "FUNCTION FC",
    number: 2,
    declarations: " : VOID\nVAR_TEMP\n t : ARRAY [0..9] OF WORD;\nEND_VAR",
    parameters: false,
    all_kinds: false,
    calls: Calls::Everything,
};
const FC_11: Head = Head {
    kind: "FUNCTION FC",
    number: 11,
    declarations: " : INT\nVAR_INPUT\n n : INT;\n b : BOOL;\n t : TIMER;\n c : COUNTER;\n a : ANY;\n p : POINTER;\n f : BLOCK_FC;\nEND_VAR\nVAR_OUTPUT\n q : BOOL;\n d : DWORD;\nEND_VAR\nVAR_IN_OUT\n w : WORD;\nEND_VAR\nVAR_TEMP\n l : ARRAY [0..9] OF WORD;\nEND_VAR",
    parameters: true,
    all_kinds: true,
    calls: Calls::Nothing,
};
const FB_11: Head = Head {
    kind: "FUNCTION_BLOCK FB",
    number: 11,
    declarations: "\nVAR_INPUT\n n : INT;\n b : BOOL;\n t : TIMER;\n c : COUNTER;\n a : ANY;\n p : POINTER;\n f : BLOCK_FC;\nEND_VAR\nVAR_OUTPUT\n q : BOOL;\n d : DWORD;\nEND_VAR\nVAR_IN_OUT\n w : WORD;\nEND_VAR\nVAR\n s : ARRAY [0..9] OF WORD;\nEND_VAR\nVAR_TEMP\n l : ARRAY [0..9] OF WORD;\nEND_VAR",
    parameters: true,
    all_kinds: true,
    calls: Calls::Nothing,
};
const FC_12: Head = Head {
    kind: "FUNCTION FC",
    number: 12,
    declarations: " : VOID\nVAR_INPUT\n n : INT;\n b : BOOL;\nEND_VAR\nVAR_IN_OUT\n w : WORD;\nEND_VAR\nVAR_TEMP\n t : ARRAY [0..9] OF WORD;\nEND_VAR",
    parameters: true,
    all_kinds: false,
    calls: Calls::Leaves,
};
const FB_12: Head = Head {
    kind: "FUNCTION_BLOCK FB",
    number: 12,
    declarations: "\nVAR_INPUT\n n : INT;\n b : BOOL;\nEND_VAR\nVAR_IN_OUT\n w : WORD;\nEND_VAR\nVAR\n i1 : FB 11;\n i2 : FB 11;\n s : ARRAY [0..9] OF WORD;\nEND_VAR\nVAR_TEMP\n t : ARRAY [0..9] OF WORD;\nEND_VAR",
    parameters: true,
    all_kinds: false,
    calls: Calls::Leaves,
};

/// A call of a block that calls nothing, with actual parameters of all kinds.
fn leaf_call(choices: &mut Choices<'_>, block: &Head) -> String {
    let mut word = |own: &'static str| match choices.below(7) {
        0 | 1 if block.parameters => own.to_owned(),
        0 => "DB1.DBW 60".to_owned(),
        1 => "DB1.DBW 70".to_owned(),
        2 => "LW 4".to_owned(),
        3 => "MW 12".to_owned(),
        4 => "DBW 2".to_owned(),
        5 => "PIW 2".to_owned(),
        _ => "IW 2".to_owned(),
    };
    let (n, mut w) = (word("#n"), word("#w"));
    if matches!(w.as_str(), "PIW 2" | "DB1.DBW 70") {
        w = "QW 2".to_owned();
    }
    let n = if n == "DB1.DBW 70" { "17".to_owned() } else { n };
    let b = if block.parameters { choices.of(&["#b", "M 1.0", "L 2.1"]) } else { choices.of(&["M 1.0", "L 2.1", "DB1.DBX 3.1", "TRUE"]) };
    let rest = format!(
        "n := {n}, b := {b}, t := T {}, c := C {}, a := {}, p := {}, f := FC 9, q := {}, d := {}, w := {w}",
        choices.below(4),
        choices.below(4),
        choices.of(&["P#M 4.0 BYTE 4", "P#DB1.DBX 2.0 WORD 2", "MW 4", "LW 6", "DB2.DBD 0"]),
        choices.of(&["P#M 6.0", "P#DB1.DBX 4.0", "MW 8", "LW 8"]),
        choices.of(&["Q 1.2", "M 3.3", "L 3.0", "DBX 1.1"]),
        choices.of(&["MD 16", "LD 8", "DB2.DBD 4", "DBD 60", "DID 4"]),
    );
    match choices.below(3) {
        0 => format!("CALL FB 11, DB {} ({rest})", choices.of(&["11", "13"])),
        1 if block.number == 12 && block.kind == FB_12.kind => format!("CALL #{} ({rest})", choices.of(&["i1", "i2"])),
        _ => format!("CALL FC 11 ({rest}, RET_VAL := MW 26)"),
    }
}

/// What a block does with parameters of all kinds.
const WITH_ALL_KINDS: &[&str] = &[
    "A #t",
    "ON #c",
    "L #t",
    "LC #t",
    "L #c",
    "LC #c",
    "L S5T#30MS;\n SP #t",
    "L S5T#10MS;\n SD #t",
    "L S5T#40MS;\n SE #t",
    "SF #t",
    "SS #t",
    "R #t",
    "FR #t",
    "CU #c",
    "CD #c",
    "L C#5;\n S #c",
    "R #c",
    "FR #c",
    "= #q",
    "A #q",
    "S #q",
    "T #d",
    "L #d",
    "L P##a;\n LAR1;\n L W [AR1, P#4.0];\n T MW 2",
    "L P##a;\n LAR1;\n L D [AR1, P#6.0];\n LAR1;\n L W [AR1, P#0.0]",
    "L P##p;\n LAR1;\n L D [AR1, P#2.0];\n LAR1;\n A [AR1, P#0.3]",
    "L P##p;\n LAR1;\n L W [AR1, P#0.0];\n T MW 2;\n OPN DB [MW 2]",
    "UC #f",
];

const DATA: &[&str] = &["I", "Q", "M", "M", "L", "DB", "DB", "DI"];
const OPEN: &[&str] = &["DB 1", "DB 2", "DB 3", "DB 4", "DI 1", "DI 2", "DI 4", "DB 9", "DB [MW 2]", "DI [MW 2]"];

/// An address of a bit, byte, word or double word.
fn address(choices: &mut Choices<'_>, width: usize, parameters: bool) -> String {
    let letter = ["X", "B", "W", "D"][width];
    let area = choices.of(DATA);
    let name = if matches!(area, "DB" | "DI") || width > 0 { format!("{area}{letter}") } else { area.to_owned() };
    let (byte, bit) = (choices.below(40), choices.below(8));
    let dot = if width == 0 { format!(".{bit}") } else { String::new() };
    match choices.below(12) {
        0 => format!("{name} [MD {}]", 4 * choices.below(6)),
        1 => format!("{name} [AR1, P#{}.{}]", choices.below(20), if width == 0 { bit } else { 0 }),
        2 => format!("{name} [AR2, P#{}.{}]", choices.below(20), if width == 0 { bit } else { 0 }),
        3 => format!("{} [AR1, P#{}.{}]", if width == 0 { "" } else { letter }, choices.below(20), if width == 0 { bit } else { 0 }),
        4 if parameters && width == 0 => "#b".to_owned(),
        4 if parameters && width == 2 => choices.of(&["#n", "#w", "#w"]).to_owned(),
        4 => format!("DB1.DB{letter} {byte}{dot}"),
        5 if area == "L" => format!("L{} {}{dot}", if width == 0 { "" } else { letter }, 20 + choices.below(18)),
        _ if area == "L" => format!("L{} {}{dot}", if width == 0 { "" } else { letter }, choices.below(16)),
        _ => format!("{name} {byte}{dot}"),
    }
}

/// Calls of system functions: locks of interrupts and errors, data blocks made and deleted, blocks of bytes moved, STOP.
const SYSTEM_CALLS: &[&str] = &[
    "CALL SFC 41 (RET_VAL := MW 20)",
    "CALL SFC 42 (RET_VAL := MW 20)",
    "CALL SFC 39 (MODE := B#16#0, OB_NR := 0, RET_VAL := MW 20)",
    "CALL SFC 40 (MODE := B#16#0, OB_NR := 0, RET_VAL := MW 20)",
    "CALL SFC 36 (PRGFLT_SET_MASK := MD 4, ACCFLT_SET_MASK := MD 8, RET_VAL := MW 20, PRGFLT_MASKED := MD 24, ACCFLT_MASKED := MD 28)",
    "CALL SFC 36 (PRGFLT_SET_MASK := DW#16#FFFFFFFF, ACCFLT_SET_MASK := DW#16#FFFFFFFF, RET_VAL := MW 20, PRGFLT_MASKED := MD 24, ACCFLT_MASKED := MD 28)",
    "CALL SFC 37 (PRGFLT_RESET_MASK := DW#16#FFFFFFFF, ACCFLT_RESET_MASK := MD 8, RET_VAL := MW 20, PRGFLT_MASKED := MD 24, ACCFLT_MASKED := MD 28)",
    "CALL SFC 44 (VAL := MD 4, RET_VAL := MW 20)",
    "CALL SFC 22 (LOW_LIMIT := W#16#9, UP_LIMIT := W#16#A, COUNT := W#16#20, RET_VAL := MW 20, DB_NUMBER := MW 2)",
    "CALL SFC 85 (LOW_LIMIT := W#16#9, UP_LIMIT := W#16#A, COUNT := W#16#20, ATTRIB := B#16#2, RET_VAL := MW 20, DB_NUM := MW 2)",
    "CALL SFC 23 (DB_NUMBER := W#16#9, RET_VAL := MW 20)",
    "CALL SFC 23 (DB_NUMBER := MW 2, RET_VAL := MW 20)",
    "CALL SFC 20 (SRCBLK := P#M 0.0 BYTE 12, RET_VAL := MW 20, DSTBLK := P#DB1.DBX 2.0 BYTE 12)",
    "CALL SFC 20 (SRCBLK := P#DB1.DBX 0.0 BYTE 8, RET_VAL := MW 20, DSTBLK := P#L 20.0 BYTE 8)",
    "CALL SFC 21 (BVAL := P#M 0.0 BYTE 3, RET_VAL := MW 20, BLK := P#DB9.DBX 0.0 BYTE 20)",
    "CALL SFC 32 (OB_NR := 20, DTIME := T#3MS, SIGN := MW 2, RET_VAL := MW 20)",
    "CALL SFC 47 (WT := 200)",
    "CALL SFC 43 ()",
    "CALL SFC 46 ()",
];

/// A loop that counts down and goes through an area by a pointer in memory: its turns may be done at once, unless what it reads or
/// writes is its own counter or pointer, or lies outside.
fn counted_loop(choices: &mut Choices<'_>, parameters: bool, number: usize) -> String {
    let pointer = choices.of(&["MD 4", "MD 8", "MD 16", "MD 36"]);
    let counter = choices.of(&["MW 2", "MW 30", "LW 2", "MW 6", "DBW 4"]);
    let step = choices.of(&["P#2.0", "P#2.0", "P#4.0", "P#1.0", "P#0.1", "L#-16"]);
    let first = choices.of(&["P#0.0", "P#0.0", "P#2.0", "P#40.0", "P#60.0", "P#0.3"]);
    let count = choices.of(&["1", "5", "8", "16", "17", "30", "31", "32", "100", "0", "L#65540"]);
    let mut body = String::new();
    for _ in 0..=choices.below(3) {
        let one = match choices.below(10) {
            0 => format!("L DBW [{pointer}];\n + 7;\n T DBW [{pointer}]"),
            1 => format!("L {counter};\n L 7;\n *I;\n L MW 20;\n +I;\n T DBW [{pointer}]"),
            2 => format!("L DBW [{pointer}];\n ITD;\n L MD 24;\n +D;\n T MD 24"),
            3 => format!("L DBD [{pointer}];\n L MD 32;\n +R;\n T MD 32"),
            4 => format!("L DBD [{pointer}];\n L {pointer};\n -D;\n T DID [{pointer}]"),
            5 => format!("A DBX [{pointer}];\n = M 40.1"),
            6 => format!("L {};\n T MW [{pointer}]", address(choices, 2, parameters)),
            7 => format!("L DBW [{pointer}];\n T {}", address(choices, 2, parameters)),
            8 => format!("L DBW [{pointer}];\n T DIW [{pointer}]"),
            _ => format!("SET;\n S DBX [{pointer}]"),
        };
        let _ = writeln!(body, " {one};");
    }
    let open = choices.of(&["OPN DB 1;\n OPN DI 2", "OPN DB 1", "OPN DB 2;\n OPN DI 1", "NOP 0"]);
    format!(
        " {open};\n L {first};\n T {pointer};\n L {count};\nk{number}: T {counter};\n{body} L {pointer};\n L {step};\n +D;\n T {pointer};\n L {counter};\n LOOP k{number};\n"
    )
}

/// One statement, the one with this number.
fn statement(choices: &mut Choices<'_>, block: &Head, number: usize) -> String {
    let parameters = block.parameters;
    if choices.below(14) == 0 {
        return counted_loop(choices, parameters, number);
    }
    if block.all_kinds && choices.below(4) == 0 {
        return format!(" {};\n", choices.of(WITH_ALL_KINDS));
    }
    let word = match choices.below(46) {
        0..=8 => {
            let scan = choices.of(&["A", "AN", "O", "ON", "X", "XN", "A", "AN", "O"]);
            match choices.below(10) {
                0 => format!(
                    "{scan} {}",
                    choices.of(&["T 1", "T 2", "C 1", "C 2", "OV", "OS", "==0", "<>0", ">0", "<0", ">=0", "<=0", "UO", "BR"])
                ),
                _ => format!("{scan} {}", address(choices, 0, parameters)),
            }
        }
        9..=12 => format!("{} {}", choices.of(&["=", "=", "S", "R", "FP", "FN"]), address(choices, 0, parameters)),
        13 => match choices.below(3) {
            0 => format!(
                "{};\n O {};\n {} {};\n )",
                choices.of(&["A(", "AN(", "O(", "ON(", "X(", "XN("]),
                address(choices, 0, parameters),
                choices.of(&["A", "ON", "X"]),
                address(choices, 0, parameters)
            ),
            _ => choices.of(&["O", "NOT", "SET", "CLR", "SAVE"]).to_owned(),
        },
        14..=18 => {
            let width = 1 + choices.below(3);
            format!("L {}", address(choices, width, parameters))
        }
        19..=21 => {
            let width = 1 + choices.below(3);
            format!("T {}", address(choices, width, parameters))
        }
        22 => format!(
            "L {}",
            choices.of(&[
                "0",
                "1",
                "-1",
                "32767",
                "-32768",
                "L#100000",
                "L#-2147483648",
                "L#2147483647",
                "W#16#0999",
                "DW#16#80000000",
                "1.5",
                "-0.0",
                "3.402823e+038",
                "DW#16#00000001",
                "DW#16#7FC00000",
                "P#0.0",
                "P#2.3",
                "P#M 4.0",
                "P#DBX 2.0",
                "P#L 0.0",
                "B#16#7F",
                "S5T#30MS",
                "C#25",
            ])
        ),
        23..=26 => choices
            .of(&[
                "+I", "-I", "*I", "/I", "+D", "-D", "*D", "/D", "MOD", "+R", "-R", "*R", "/R", "==I", "<>I", ">I", "<I", ">=I", "<=I",
                "==D", "<>D", ">D", "<D", ">=D", "<=D", "==R", "<>R", ">R", "<R", ">=R", "<=R",
            ])
            .to_owned(),
        27 => choices
            .of(&[
                "ITD", "DTR", "RND", "RND+", "RND-", "TRUNC", "BTI", "ITB", "BTD", "DTB", "INVI", "INVD", "NEGI", "NEGD", "NEGR", "ABS",
                "CAW", "CAD", "TAK", "PUSH", "POP", "SQR", "SQRT",
            ])
            .to_owned(),
        28 => match choices.below(4) {
            0 => choices
                .of(&["AW", "OW", "XOW", "AD", "OD", "XOD", "SLW", "SRW", "SLD", "SRD", "SSI", "SSD", "RLD", "RRD", "RLDA", "RRDA"])
                .to_owned(),
            1 => format!("{} {}", choices.of(&["SLW", "SRW", "SSI"]), choices.below(16)),
            2 => format!("{} {}", choices.of(&["SLD", "SRD", "SSD", "RLD", "RRD"]), choices.below(33)),
            _ => format!("{} W#16#{:X}", choices.of(&["AW", "OW", "XOW"]), choices.below(256)),
        },
        29 => format!("{} {}", choices.of(&["INC", "DEC", "+"]), choices.below(128)),
        30 => choices
            .of(&[
                "LAR1",
                "LAR2",
                "TAR1",
                "TAR2",
                "CAR",
                "TAR1 AR2",
                "LAR1 AR2",
                "LAR1 P#2.0",
                "LAR1 P#M 3.0",
                "LAR1 P#DBX 1.0",
                "LAR2 P#4.0",
                "+AR1",
                "+AR1 P#1.1",
                "+AR2 P#2.0",
                "LAR1 MD 8",
                "TAR1 MD 8",
            ])
            .to_owned(),
        31 | 32 => match choices.below(8) {
            0 => "CDB".to_owned(),
            1 => choices.of(&["L DBNO", "L DINO", "L DBLG", "L DILG"]).to_owned(),
            _ => format!("OPN {}", choices.of(OPEN)),
        },
        33 => format!(
            "{} l{}",
            choices.of(&[
                "JU", "JC", "JCN", "JCB", "JNB", "JBI", "JNBI", "JO", "JOS", "JZ", "JN", "JP", "JM", "JPZ", "JMZ", "JUO", "LOOP", "LOOP"
            ]),
            choices.below(LABELS)
        ),
        34 | 42..=45 => match choices.below(12) {
            4 => choices.of(&["BEC", "BEU", "BE"]).to_owned(),
            _ if block.calls == Calls::Nothing => "NOP 1".to_owned(),
            9..=11 => leaf_call(choices, block),
            _ if block.calls == Calls::Leaves => leaf_call(choices, block),
            0 | 1 if !parameters => choices
                .of(&["CALL FC 1 (n := MW 10, b := M 1.0, w := DB1.DBW 4)", "CALL FC 12 (n := DBW 10, b := L 3.0, w := MW 4)"])
                .to_owned(),
            2 | 3 if !parameters => choices
                .of(&[
                    "CALL FB 1, DB 4 (n := DB1.DBW 2, b := Q 1.1, w := MW 12)",
                    "CALL FB 12, DB 12 (n := LW 2, b := DBX 1.1, w := DB1.DBW 12)",
                    "CALL FB 12, DB 12 ()",
                ])
                .to_owned(),
            5 => format!("{} FC [MW {}]", choices.of(&["UC", "CC"]), 2 * choices.below(4)),
            6 if parameters => choices.of(&["CALL FC 1 (n := #n, b := #b, w := #w)", "CALL FC 12 (n := #n, b := #b, w := #w)"]).to_owned(),
            _ => format!("{} FC 2", choices.of(&["UC", "CC", "CALL"])),
        },
        35 => match choices.below(4) {
            0 => format!("L S5T#20MS;\n {} T {}", choices.of(&["SP", "SE", "SD", "SS", "SF"]), choices.below(4)),
            1 => format!("{} T {}", choices.of(&["R", "FR", "L", "LC"]), choices.below(4)),
            2 => format!("{} C {}", choices.of(&["CU", "CD", "S", "R", "FR", "L", "LC"]), choices.below(4)),
            _ => "L C#7;\n S C 1".to_owned(),
        },
        36 => choices.of(&["MCRA", "MCRD", "MCR(", ")MCR"]).to_owned(),
        37 => choices.of(&["L STW", "T STW", "NOP 0", "NOP 1"]).to_owned(),
        38 => format!(
            "{} {}",
            choices.of(&["L PIW", "L PIB", "T PQW", "T PQD", "L PID"]),
            choices.of(&["0", "4", "300", "2046", "65000", "8190"])
        ),
        39 => choices.of(SYSTEM_CALLS).to_owned(),
        40 if choices.below(4) == 0 => choices.of(SYSTEM_CALLS).to_owned(),
        _ => choices.of(&["ENT", "LEAVE", "TAK", "L MW 2", "T MW 2", "T MD 4", "T MD 8", "L 3;\n T MW 2", "L P#3.0;\n T MD 8"]).to_owned(),
    };
    format!(" {word};\n")
}

#[cfg(test)]
mod tests {
    use super::{Options, chosen, fuzz};

    /// Numbers that look random, the same on every run.
    fn noise(seed: u32, length: usize) -> Vec<u8> {
        let mut state = seed.wrapping_mul(2_654_435_761).wrapping_add(1);
        (0..length)
            .map(|_| {
                state ^= state << 13;
                state ^= state >> 17;
                state ^= state << 5;
                (state >> 11) as u8
            })
            .collect()
    }

    /// What the compiler refuses in a program.
    fn errors(text: &str) -> Vec<String> {
        let mut sources = sieben_model::source::Sources::default();
        sources.add("fuzz.awl", text);
        let options = Options { system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
        let compiled = sieben_lang::compile(&sources, &Default::default(), &options);
        let errors = compiled.diagnostics.iter().filter(|found| found.severity() == sieben_model::diagnostic::Severity::Error);
        errors.map(|found| format!("{} in `{}`", found.message, sources.slice(found.span))).collect()
    }

    #[test]
    fn most_chosen_programs_compile() {
        let mut refused = std::collections::BTreeSet::new();
        let mut good = 0;
        for seed in 0..50 {
            let wrong = errors(&chosen(&noise(seed, 200)));
            good += usize::from(wrong.is_empty());
            refused.extend(wrong);
        }
        assert!(good >= 45, "{good} of 50 compile:\n{refused:#?}");
    }

    #[test]
    fn engines_agree_on_chosen_programs() {
        for seed in 0..120 {
            fuzz(&noise(seed, 60 + seed as usize));
        }
    }

    /// Runs a program on the CPU types that differ.
    fn on_several_types(text: &str) {
        assert_eq!(errors(text), Vec::<String>::new(), "{text}");
        for blanks in 0..3 {
            fuzz(format!("{text}{}", " ".repeat(blanks)).as_bytes());
        }
    }

    const ERROR_BLOCK: &str = "ORGANIZATION_BLOCK OB 121\nVAR_TEMP\n i : ARRAY [0..19] OF BYTE;\nEND_VAR\nBEGIN\n L MW 90; INC 1; T MW 90; L LW 8; T MW 92; OPN DB 1; L DBW 0; T MW 94;\nEND_ORGANIZATION_BLOCK\n";
    const DATA: &str = "DATA_BLOCK DB 1\nSTRUCT\n a : ARRAY [0..9] OF WORD;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n";

    #[test]
    fn small_blocks_nest_as_deep_as_any() {
        for (last, depth) in [("", 6), (" T DBW 200;", 7), (" L PIW 300;", 8), (" UC FC 9;", 9), (" UC FC 1;", 20)] {
            let mut text = format!("{ERROR_BLOCK}{DATA}");
            for number in 1..depth {
                let next = if number + 1 == depth { format!("OPN DB 1;{last}") } else { format!("UC FC {};", number + 1) };
                text.push_str(&format!(
                    "FUNCTION FC {number} : VOID\nBEGIN\n L MW 2; INC 1; T MW 2; {next} L MW 4; INC 1; T MW 4;\nEND_FUNCTION\n"
                ));
            }
            text.push_str("ORGANIZATION_BLOCK OB 1\nBEGIN\n L 5; OPN DB 1; UC FC 3; T MW 6; L DBNO; T MW 8; UC FC 1; T MW 10;\nEND_ORGANIZATION_BLOCK\n");
            on_several_types(&text);
        }
    }

    #[test]
    fn small_blocks_take_local_data_as_any() {
        // The last ones need more than a priority class has, or nest deeper than a CPU lets them, though no block is too large.
        for (bytes, blocks) in [(10, 4), (200, 4), (250, 4), (260, 4), (1000, 4), (2000, 4), (2000, 12), (2000, 20)] {
            let mut text = format!("{ERROR_BLOCK}{DATA}");
            for number in 1..=blocks {
                let next = if number == blocks { "T DBW 300; T LW 2;".to_owned() } else { format!("CALL FC {} (p := LW 4);", number + 1) };
                text.push_str(&format!(
                    "FUNCTION FC {number} : VOID\nVAR_IN_OUT\n p : WORD;\nEND_VAR\nVAR_TEMP\n t : ARRAY [1..{bytes}] OF BYTE;\nEND_VAR\nBEGIN\n L #p; INC 1; T #p; T LW 4; {next} L LW 4; T #p;\nEND_FUNCTION\n"
                ));
            }
            text.push_str("ORGANIZATION_BLOCK OB 1\nBEGIN\n CALL FC 1 (p := MW 2); CALL FC 2 (p := MW 4);\nEND_ORGANIZATION_BLOCK\n");
            on_several_types(&text);
        }
    }

    #[test]
    fn whoever_is_asked_in_a_small_block_sees_its_callers() {
        let fails = [
            "L DBW 300",
            "T DBW 300",
            "L W [AR1, P#0.0]",
            "L PIW 300",
            "T PQW 300",
            "OPN DB 77",
            "L S5T#10MS; SD T [MW 98]",
            "UC FC 77",
            "L B [AR2, P#0.0]",
        ];
        for fail in fails {
            let text = format!(
                "{ERROR_BLOCK}ORGANIZATION_BLOCK OB 122\nBEGIN\n L MW 96; INC 1; T MW 96;\nEND_ORGANIZATION_BLOCK\n{DATA}\
                 FUNCTION FC 1 : VOID\nVAR_INPUT\n n : INT;\nEND_VAR\nVAR_OUTPUT\n o : INT;\nEND_VAR\nBEGIN\n L #n; LAR1 P#Q 9.1; {fail}; + 1; T #o;\nEND_FUNCTION\n\
                 FUNCTION_BLOCK FB 1\nVAR_INPUT\n n : INT;\nEND_VAR\nVAR_OUTPUT\n o : INT;\nEND_VAR\nVAR\n s : INT;\nEND_VAR\nVAR_TEMP\n t : INT;\nEND_VAR\nBEGIN\n \
                 CALL FC 1 (n := #n, o := #t); L #t; T #s; {fail}; CALL FC 1 (n := #s, o := #o);\nEND_FUNCTION_BLOCK\n\
                 FUNCTION_BLOCK FB 2\nVAR\n i : FB 1;\n j : FB 1;\nEND_VAR\nBEGIN\n CALL #i (n := MW 20, o := MW 22); CALL #j (n := 3, o := LW 0);\nEND_FUNCTION_BLOCK\n\
                 DATA_BLOCK DB 2\nFB 2\nBEGIN\nEND_DATA_BLOCK\n\
                 ORGANIZATION_BLOCK OB 1\nBEGIN\n L L#70000; L 7; OPN DB 1; A M 0.0; CALL FB 2, DB 2 (); T MW 30; CALL FC 1 (n := DB1.DBW 2, o := DB1.DBW 4); T MW 32;\nEND_ORGANIZATION_BLOCK\n"
            );
            on_several_types(&text);
        }
    }

    /// What a block may do to AR2 and to what its callers have saved of it, in blocks that become part of others and in long ones.
    #[test]
    fn instances_are_where_ar2_points() {
        let tricks = [
            "NOP 0",
            "+AR2 P#2.0",
            "LAR2 P#6.0",
            "TAR1 AR2",
            "L 7; T W [AR1, P#0.0]",
            "L L#3; T #p",
            "JL last; JU last; JU last; last: NOP 0",
            "OPN DI 4; L DIW 0; T MW 60",
            "OPN DI 77",
            "L DIW 300",
            "CALL SFC 23 (DB_NUMBER := W#16#3, RET_VAL := MW 20)",
        ];
        for (length, trick) in [0, 30].into_iter().flat_map(|length| tricks.map(|trick| (length, trick))) {
            let long = " L #w; INC 1; T #w;".repeat(length);
            let text = format!(
                "{ERROR_BLOCK}{DATA}\
                 FUNCTION FC 1 : VOID\nVAR_IN_OUT\n p : DINT;\nEND_VAR\nBEGIN\n L #p; + 1; T #p; {trick};\nEND_FUNCTION\n\
                 FUNCTION_BLOCK FB 1\nVAR_IN_OUT\n p : DINT;\nEND_VAR\nVAR\n w : INT;\n x : INT;\nEND_VAR\nBEGIN\n{long} L #w; + 1; T #w; A M 0.0; JC m; {trick};\n\
                 m: L #x; L #w; +I; T #x;\nEND_FUNCTION_BLOCK\n\
                 FUNCTION_BLOCK FB 2\nVAR\n i : FB 1;\n j : FB 1;\n p : DINT;\n n : INT;\nEND_VAR\nVAR_TEMP\n t : DINT;\nEND_VAR\nBEGIN\n \
                 L 3;\nl: T #n; CALL #i (p := #t); A M 0.1; JC k; CALL #j (p := #p);\nk: L #i.w; T MW 40; CALL FC 1 (p := #t); CALL FC 1 (p := #p); CALL FB 1, DB 4 (p := #p);\n \
                 T LD 12; L #n; LOOP l; L #j.x; T MW 42;\nEND_FUNCTION_BLOCK\n\
                 DATA_BLOCK DB 2\nFB 2\nBEGIN\nEND_DATA_BLOCK\nDATA_BLOCK DB 3\nFB 2\nBEGIN\nEND_DATA_BLOCK\nDATA_BLOCK DB 4\nFB 1\nBEGIN\nEND_DATA_BLOCK\n\
                 ORGANIZATION_BLOCK OB 1\nBEGIN\n LAR1 P#M 50.0; AN M 0.1; = M 0.1; CALL FB 2, DB 2 (); CALL FB 2, DB 3 (); AN M 0.0; = M 0.0; TAR2; T MD 70;\n \
                 CALL FB 2, DB 2 (); OPN DI 3; LAR2 P#2.0; UC FB 2; OPN DI 2; LAR2 P#DBX 0.0; UC FB 2; OPN DI 4; UC FB 1; L 1; T MW 2; UC FB [MW 2];\nEND_ORGANIZATION_BLOCK\n"
            );
            assert_eq!(errors(&text), Vec::<String>::new(), "{text}");
            fuzz(text.as_bytes());
        }
    }

    #[test]
    fn a_program_of_calls_becomes_machine_code() {
        let mut text = String::new();
        for number in 1..60 {
            let calls = (number + 1..60).map(|callee| format!(" UC FC {callee};\n")).collect::<String>();
            text.push_str(&format!("FUNCTION FC {number} : VOID\nBEGIN\n A M 0.0; BEC;\n{calls}END_FUNCTION\n"));
        }
        text.push_str("ORGANIZATION_BLOCK OB 1\nBEGIN\n SET; = M 0.0; CALL FC 1; CLR; = M 0.0; CALL FC 40;\nEND_ORGANIZATION_BLOCK\n");
        fuzz(text.as_bytes());
    }
}
