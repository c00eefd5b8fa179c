//! Calls one block of the library with parameters in a data block and in bit memory.

use std::sync::Arc;

use sieben_engine::tracer::{StatementEvent, Tracer};
use sieben_engine::{Context, Engine, Entry, Exit, Interpreter, Layout, Machine};
use sieben_lang::{Options, compile};
use sieben_model::address::Width;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

use crate::strict::Strict;

/// The data block of every program: strings whose headers the test writes, and dates.
const DATA: &str = "DATA_BLOCK DB 1 STRUCT s1 : STRING; s2 : STRING; r : STRING; t1 : DATE_AND_TIME; t2 : DATE_AND_TIME; t : DATE_AND_TIME; \
                    END_STRUCT BEGIN END_DATA_BLOCK\nDATA_BLOCK DB 2 STRUCT w : WORD; END_STRUCT BEGIN END_DATA_BLOCK\n";
/// Where the strings begin in DB 1: each has room for 254 characters.
pub(crate) const S1: usize = 0;
pub(crate) const S2: usize = 256;
pub(crate) const R: usize = 512;
/// Where the dates begin.
pub(crate) const T1: usize = 768;
pub(crate) const T2: usize = 776;
pub(crate) const T: usize = 784;

/// A loaded program that calls one block.
pub(crate) struct Call {
    engine: Arc<dyn Engine>,
    layout: Arc<Layout>,
    text: String,
}

/// The memory before or after a call.
#[derive(Clone)]
pub(crate) struct State {
    machine: Machine,
}

/// Counts the statements of functions.
#[derive(Default)]
struct Counter {
    statements: usize,
}

impl Tracer for Counter {
    fn statement(&mut self, _: &Machine, event: &StatementEvent) {
        self.statements += usize::from(event.place.block.kind == BlockKind::Function);
    }
}

impl Call {
    /// `call` is the CALL statement. Around it stands what shows that the block gives AR2 and DI back.
    pub(crate) fn new(call: &str) -> Self {
        let text = format!(
            "{DATA}ORGANIZATION_BLOCK OB 1\nBEGIN\n  OPN DI 2; LAR2 P#DBX 77.0;\n  CALL {call};\n  A BR; = M 1000.0; TAR2 MD 1004; \
             L DINO; T MW 1008;\nEND_ORGANIZATION_BLOCK\n"
        );
        let mut sources = Sources::default();
        sources.add("call.awl", text.as_str());
        let options = Options { mnemonics: Some(Mnemonics::English), ..Options::default() };
        let compiled = compile(&sources, &SymbolTable::default(), &options);
        assert!(compiled.diagnostics.is_empty(), "{text}{:?}", compiled.diagnostics);
        let layout = Arc::new(Layout::new(&CpuType::default(), &compiled.program));
        Self { engine: Interpreter::load(&compiled.program, &layout), layout, text }
    }

    /// Cleared memory.
    pub(crate) fn state(&self) -> State {
        State { machine: Machine::new(Arc::clone(&self.layout)) }
    }

    /// Runs OB 1 once; the BR that the block left.
    pub(crate) fn run(&self, state: &mut State) -> bool {
        let exit = self.engine.run(&mut Context { machine: &mut state.machine, host: &mut Strict, tracer: None }, &entry());
        self.ended(state, &exit)
    }

    /// Runs OB 1 once; how many statements the block executes.
    pub(crate) fn statements(&self, state: &mut State) -> usize {
        let mut counter = Counter::default();
        let tracer: Option<&mut dyn Tracer> = Some(&mut counter);
        let exit = self.engine.run(&mut Context { machine: &mut state.machine, host: &mut Strict, tracer }, &entry());
        self.ended(state, &exit);
        counter.statements
    }

    fn ended(&self, state: &State, exit: &Exit) -> bool {
        assert_eq!(*exit, Exit::Finished, "{}", self.text);
        assert_eq!(state.bit_memory(1004, Width::DoubleWord), 0x8400_0000 | (77 << 3), "AR2 is the caller's again");
        assert_eq!(state.bit_memory(1008, Width::Word), 2, "DI is the caller's again");
        state.bit_memory(1000, Width::Byte) == 1
    }
}

fn entry() -> Entry {
    Entry { block: BlockId::ob(1), start_information: [0; 20], registers: None }
}

impl State {
    /// Bytes of DB 1.
    pub(crate) fn data(&mut self, at: usize, length: usize) -> &mut [u8] {
        let base = self.machine.memory.data_block(1).expect("DB 1 is loaded").base as usize;
        &mut self.machine.memory.arena[base + at..base + at + length]
    }

    /// Writes a string with its header into DB 1.
    pub(crate) fn put_string(&mut self, at: usize, maximum: u8, text: &[u8]) {
        self.data(at, 2).copy_from_slice(&[maximum, text.len() as u8]);
        self.data(at + 2, text.len()).copy_from_slice(text);
    }

    /// The string that DB 1 holds there.
    pub(crate) fn string(&mut self, at: usize) -> Vec<u8> {
        let length = usize::from(self.data(at, 2)[1]);
        self.data(at + 2, length).to_vec()
    }

    fn bit_memory(&self, at: usize, width: Width) -> u32 {
        self.machine.memory.read_at(self.layout().bit_memory.start + at, 0, width)
    }

    fn layout(&self) -> &Layout {
        &self.machine.memory.layout
    }

    /// A word of bit memory as a number with sign.
    pub(crate) fn word(&self, at: usize) -> i16 {
        self.bit_memory(at, Width::Word) as u16 as i16
    }

    /// A double word of bit memory.
    pub(crate) fn double_word(&self, at: usize) -> u32 {
        self.bit_memory(at, Width::DoubleWord)
    }

    /// Writes bytes of bit memory.
    pub(crate) fn put(&mut self, at: usize, bytes: &[u8]) {
        let start = self.layout().bit_memory.start + at;
        self.machine.memory.arena[start..start + bytes.len()].copy_from_slice(bytes);
    }
}
