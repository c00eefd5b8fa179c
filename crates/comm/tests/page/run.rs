//! Runs the telegrams of a section through a session, before a CPU with the program of the section.

use std::net::SocketAddr;
use std::sync::Arc;

use sieben_comm::s7comm::session::{Session, Shared};
use sieben_cpu::{Cpu, IoModule, Rack, Restart, Settings, SimulatedModule};
use sieben_engine::{Interpreter, Program};
use sieben_lang::Options;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Severity;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;
use sieben_sim::names::Name;
use sieben_workspace::{Pace, Plant, Speed};

use super::{Expected, Line, Section, Telegrams};

/// What a section without a program has.
const NOTHING: &str = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNOP 0;\nEND_ORGANIZATION_BLOCK\n";
/// Connect request with rack 0 slot 2, and setup with eight jobs and 480 bytes.
const CONNECT: &[u8] = &[3, 0, 0, 0x16, 0x11, 0xE0, 0, 0, 0, 1, 0, 0xC0, 1, 0x0A, 0xC1, 2, 1, 0, 0xC2, 2, 1, 2];
const SETUP: &[u8] = &[3, 0, 0, 0x19, 2, 0xF0, 0x80, 0x32, 1, 0, 0, 0, 1, 0, 8, 0, 0, 0xF0, 0, 0, 8, 0, 8, 1, 0xE0];
/// From one scan to the next, in microseconds.
const CYCLE_US: u64 = 10_000;
const PEER: &str = "192.0.2.7:50000";

/// What is wrong with a section.
pub(crate) fn failures(section: &Section) -> Vec<String> {
    run_section(section, usize::MAX)
}

/// What is wrong with it when its bytes come one by one.
pub(crate) fn failures_byte_by_byte(section: &Section) -> Vec<String> {
    run_section(section, 1)
}

fn run_section(section: &Section, piece: usize) -> Vec<String> {
    let mut failures = Vec::new();
    for (first, text) in &section.telegrams {
        let run = || {
            let telegrams = Telegrams::parse(text, *first)?;
            let program = compile(&section.stl, telegrams.rules.cpu)?;
            let mut run = Run::new(&telegrams, &program);
            run.piece = piece;
            telegrams.lines.iter().try_for_each(|(number, line)| run.line(line).map_err(|message| format!("line {number}: {message}")))?;
            run.nothing().map_err(|message| format!("at the end: {message}"))
        };
        if let Err(message) = run() {
            failures.push(format!("{}: {message}", section.name));
        }
    }
    failures
}

fn compile(stl: &str, cpu: &'static CpuType) -> Result<Arc<Program>, String> {
    let mut sources = Sources::default();
    sources.add("page.awl", if stl.is_empty() { NOTHING } else { stl });
    let options = Options { cpu: Some(cpu), system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
    let compiled = sieben_lang::compile(&sources, &SymbolTable::default(), &options);
    match compiled.diagnostics.iter().find(|diagnostic| diagnostic.severity() == Severity::Error) {
        Some(error) => Err(format!("the program does not compile: {}", error.message)),
        None => Ok(Arc::new(compiled.program)),
    }
}

struct Run {
    plant: Plant,
    program: Arc<Program>,
    session: Session,
    shared: Shared,
    now_us: u64,
    /// Bytes that are handed over at a time.
    piece: usize,
    /// What came and was not looked at yet.
    received: Vec<u8>,
}

impl Run {
    fn new(telegrams: &Telegrams, program: &Arc<Program>) -> Self {
        let cpu_type = telegrams.rules.cpu;
        let rack = match &telegrams.modules {
            None => Rack::simulated(cpu_type),
            Some(bytes) => {
                let module: Box<dyn IoModule> = Box::new(SimulatedModule::new("simulated", bytes.clone()));
                Rack::with_only(cpu_type, vec![module]).expect("the modules of a page lie inside the peripheral area")
            }
        };
        let mut cpu = Cpu::load(cpu_type, Arc::clone(program), Interpreter::load, rack, Settings::default());
        cpu.restart(Restart::Warm);
        cpu.scan(0);
        let peer: SocketAddr = PEER.parse().expect("it is an address");
        Self {
            plant: Plant::new(cpu, Pace::new(Speed::Max, CYCLE_US, u64::MAX, 0)),
            program: Arc::clone(program),
            session: Session::new(Arc::new(telegrams.rules.clone()), peer, 0),
            shared: Shared::default(),
            now_us: 0,
            piece: usize::MAX,
            received: Vec::new(),
        }
    }

    fn line(&mut self, line: &Line) -> Result<(), String> {
        match line {
            Line::Connect => {
                for bytes in [CONNECT, SETUP] {
                    self.send(bytes)?;
                }
                self.received.clear();
                if self.session.is_ready() { Ok(()) } else { Err("the connection is not set up".to_owned()) }
            }
            Line::Send(bytes) => {
                self.nothing()?;
                self.send(bytes)
            }
            Line::Answer(expected) => self.answer(expected),
            Line::Nothing if self.session.is_over() => Err("the connection is closed".to_owned()),
            Line::Nothing => self.nothing(),
            Line::Closed if self.session.is_over() => self.nothing(),
            Line::Closed => Err("the connection goes on".to_owned()),
            Line::Scan => {
                self.now_us += CYCLE_US;
                self.plant.cpu.scan(self.now_us);
                self.plant.scans += 1;
                Ok(())
            }
            Line::Wait(time_us) => self.wait(self.now_us + time_us),
            Line::Set(name, value) => self.name(name)?.write(&mut self.plant.cpu, value).map_err(|error| error.to_string()),
            Line::Expect(name, value) => {
                let name = self.name(name)?;
                let expected = name.expected(value).map_err(|error| error.to_string())?;
                let found = name.content(&self.plant.cpu).map_err(|error| error.to_string())?;
                if found == expected.content { Ok(()) } else { Err(format!("{} is {found:?}", name.text())) }
            }
        }
    }

    fn name(&self, text: &str) -> Result<Name, String> {
        Name::parse(text, &SymbolTable::default(), &self.program).map_err(|error| error.to_string())
    }

    fn send(&mut self, bytes: &[u8]) -> Result<(), String> {
        for piece in bytes.chunks(self.piece) {
            if self.session.is_over() {
                return Ok(());
            }
            self.session.receive(piece, &mut self.shared, self.now_us);
            self.serve()?;
        }
        Ok(())
    }

    /// Goes from deadline to deadline.
    fn wait(&mut self, until_us: u64) -> Result<(), String> {
        while let Some(wake_us) = self.session.wake_us().filter(|&wake_us| wake_us <= until_us) {
            let later = wake_us > self.now_us;
            self.now_us = self.now_us.max(wake_us);
            self.session.tick(&mut self.shared, self.now_us);
            self.serve()?;
            if !later && self.session.wake_us() == Some(wake_us) {
                return Err("a deadline does not pass".to_owned());
            }
        }
        self.now_us = until_us;
        Ok(())
    }

    /// What a server does after each wake.
    fn serve(&mut self) -> Result<(), String> {
        while self.session.wants_in() {
            if !self.session.serve(&mut self.plant, &mut self.shared, self.now_us) {
                return Err("a session wants in and does nothing there".to_owned());
            }
        }
        self.received.extend_from_slice(self.session.output());
        self.session.sent(self.session.output().len(), self.now_us);
        Ok(())
    }

    fn nothing(&self) -> Result<(), String> {
        if self.received.is_empty() { Ok(()) } else { Err(format!("there is an answer more: {}", shown(&self.received))) }
    }

    fn answer(&mut self, expected: &[Expected]) -> Result<(), String> {
        let length = match *self.received {
            [_, _, high, low, ..] => usize::from(u16::from_be_bytes([high, low])),
            _ => return Err("nothing is answered".to_owned()),
        };
        let frame: Vec<u8> = self.received.drain(..length.min(self.received.len())).collect();
        let same =
            frame.len() == expected.len() && frame.iter().zip(expected).all(|(found, expected)| expected.is_none_or(|one| one == *found));
        if same {
            return Ok(());
        }
        let wanted: Vec<String> = expected.iter().map(|byte| byte.map_or("..".to_owned(), |byte| format!("{byte:02X}"))).collect();
        Err(format!("the answer is\n  {}\nand not\n  {}", shown(&frame), wanted.join(" ")))
    }
}

fn shown(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" ")
}
