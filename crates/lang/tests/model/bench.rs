//! Pieces of program on a machine: text in, registers and memory out.

use std::fmt::Write as _;
use std::sync::Arc;

use sieben_engine::machine::Registers;
use sieben_engine::{Context, Engine, Entry, Exit, Layout, Machine};
use sieben_lang::{Options, compile};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

use crate::strict::Strict;

/// A machine with pieces of program; piece n is OB n + 1, where a run begins with any registers, and FC n + 1 for calls.
pub(crate) struct Bench {
    engine: Arc<dyn Engine>,
    pub(crate) machine: Machine,
}

impl Bench {
    pub(crate) fn new(cpu: &str, pieces: &[String]) -> Self {
        let mut text = String::new();
        for (index, piece) in pieces.iter().enumerate() {
            let _ = writeln!(text, "FUNCTION FC {0} : VOID\nBEGIN\n{piece}\nEND_FUNCTION", index + 1);
            let _ = writeln!(text, "ORGANIZATION_BLOCK OB {0}\nBEGIN\n{piece}\nEND_ORGANIZATION_BLOCK", index + 1);
        }
        let cpu = CpuType::by_name(cpu).expect("a CPU type of the table");
        let mut sources = Sources::default();
        sources.add("pieces.awl", text);
        let options = Options { cpu: Some(cpu), mnemonics: Some(sieben_model::mnemonics::Mnemonics::English), ..Options::default() };
        let compiled = compile(&sources, &SymbolTable::default(), &options);
        let errors: Vec<_> =
            compiled.diagnostics.iter().filter(|diagnostic| diagnostic.severity() == sieben_model::diagnostic::Severity::Error).collect();
        assert!(errors.is_empty(), "{errors:?}\n{}", sources.iter().next().map_or("", |(_, source)| source.text.as_str()));
        let layout = Arc::new(Layout::new(cpu, &compiled.program));
        let engine = crate::LOAD(&compiled.program, &layout);
        Self { engine, machine: Machine::new(layout) }
    }

    /// Runs a piece with these registers; those behind it, or `None` if a statement failed.
    pub(crate) fn run(&mut self, piece: usize, before: Registers) -> Option<Registers> {
        let block = BlockId::ob(u16::try_from(piece + 1).expect("few pieces"));
        let entry = Entry { block, start_information: [0; 20], registers: Some(Box::new(before)) };
        let exit = self.engine.run(&mut Context { machine: &mut self.machine, host: &mut Strict, tracer: None }, &entry);
        (exit == Exit::Finished).then(|| self.machine.registers.clone())
    }
}

/// Fresh registers with this RLO and ACCU 1.
pub(crate) fn with(rlo: bool, accu1: u32) -> Registers {
    Registers { rlo: u64::from(rlo), accu1: u64::from(accu1), ..Registers::fresh() }
}
