//! An engine that runs scripts: lists of what a program asks its CPU for, without a language.
#![allow(dead_code)] // Each test program needs a part of it.

use std::collections::BTreeMap;
use std::sync::Arc;

use sieben_cpu::{Cpu, Rack, Settings};
use sieben_engine::machine::{Frame, Origin, Registers};
use sieben_engine::{Context, Engine, Entry, Exit, Fault, FaultPlace, ImageWrites, Program, Reaction};
use sieben_model::address::{Address, Operand, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;

/// What a statement does.
#[derive(Clone, Debug)]
pub(crate) enum Step {
    /// `dst := constant`.
    Set(&'static str, u32),
    /// `dst := src`.
    Copy(&'static str, &'static str),
    /// A byte, word or double word of the start information, to the operand.
    StartInformation(usize, &'static str),
    /// Fails.
    Fault(Fault),
    /// Passes so many safe points.
    Loop(u64),
    /// Passes safe points for ever.
    Forever,
    /// Calls a system function.
    Sfc(u16),
    /// ACCU 1 + 1.
    Count,
    /// MW 0 := how many blocks run now, if that is more.
    Nest,
    /// The number of a block behind those recorded before, from MB 10 on; MB 9 counts them.
    Record(u16),
}

/// Scripts by block.
#[derive(Default)]
pub(crate) struct Script(pub(crate) BTreeMap<BlockId, Vec<Step>>);

impl Script {
    pub(crate) fn new(blocks: &[(u16, &[Step])]) -> Self {
        Self(blocks.iter().map(|(number, steps)| (BlockId::ob(*number), steps.to_vec())).collect())
    }

    fn push(&self, context: &mut Context<'_>, block: BlockId, start_information: &[u8; 20], origin: Origin) {
        let at = context.machine.memory.layout.local.start + 64 * context.machine.frames.len();
        context.machine.memory.arena[at..at + 20].copy_from_slice(start_information);
        let pushed = context.machine.push_frame(block, 0, 64, 0, origin);
        assert_eq!(pushed, Ok(()), "the script stays inside its local data");
    }

    /// Does what the Host answered; an exit if that ends the run.
    fn react(&self, context: &mut Context<'_>, reaction: Reaction) -> Option<Exit> {
        match reaction {
            Reaction::Continue | Reaction::Replace(_) | Reaction::Fail(_) => None,
            Reaction::Enter { block, start_information } => {
                assert!(self.has_block(block), "the Host may only enter loaded blocks");
                let registers = Box::new(context.machine.registers.clone());
                self.push(context, block, &start_information, Origin::Interrupt { registers, deliver: None });
                None
            }
            Reaction::Stop(reason) => Some(Exit::Stopped(reason)),
            Reaction::Suspend => Some(Exit::Suspended),
        }
    }

    fn go(&self, context: &mut Context<'_>) -> Exit {
        while let Some(frame) = context.machine.frames.last_mut() {
            let (block, statement, local) = (frame.block, frame.resume, frame.local_base as usize);
            frame.resume += 1;
            let place = FaultPlace { block, statement };
            let Some(step) = self.0[&block].get(statement as usize) else {
                let frame = context.machine.frames.pop();
                if let Some(Frame { origin: Origin::Interrupt { registers, .. }, .. }) = frame {
                    context.machine.registers = *registers;
                }
                continue;
            };
            let exit = match step {
                Step::Set(to, value) => self.write(context, place, to, *value),
                Step::Copy(to, from) => match self.read(context, place, from) {
                    Ok(value) => self.write(context, place, to, value),
                    Err(exit) => exit,
                },
                Step::StartInformation(byte, to) => {
                    let width = address(to).width;
                    let value = context.machine.memory.read_at(context.machine.memory.layout.local.start + local + byte, 0, width);
                    self.write(context, place, to, value)
                }
                Step::Fault(fault) => {
                    let reaction = context.host.fault(context.machine, fault, place);
                    self.react(context, reaction)
                }
                Step::Sfc(number) => {
                    let block = BlockId::new(BlockKind::SystemFunction, *number);
                    let reaction = context.host.system_function(context.machine, block, 0);
                    self.react(context, reaction)
                }
                Step::Nest => {
                    let depth = context.machine.frames.len() as u32;
                    let deepest = context.machine.memory.read(&operand("MW0")).unwrap_or_default().max(depth);
                    self.write(context, place, "MW0", deepest)
                }
                Step::Record(number) => {
                    let count = context.machine.memory.read(&operand("MB9")).unwrap_or_default();
                    let to = Operand::parse(&format!("MB{}", 10 + count)).expect("an operand");
                    assert!(context.machine.memory.write(&to, u32::from(*number)), "the record fits");
                    self.write(context, place, "MB9", count + 1)
                }
                Step::Count => {
                    context.machine.registers.accu1 += 1;
                    None
                }
                Step::Loop(_) | Step::Forever => self.pass(context, place, step),
            };
            if let Some(exit) = exit {
                return exit;
            }
        }
        Exit::Finished
    }

    /// Safe points; ACCU 2 counts those of the loop, so that it can be resumed.
    fn pass(&self, context: &mut Context<'_>, place: FaultPlace, step: &Step) -> Option<Exit> {
        let end = if let Step::Loop(count) = step { *count } else { u64::MAX };
        loop {
            if context.machine.registers.accu2 >= end {
                context.machine.registers.accu2 = 0;
                return None;
            }
            context.machine.registers.accu2 += 1;
            context.machine.budget -= 1;
            if context.machine.budget < 0 {
                let depth = context.machine.frames.len();
                context.machine.frames[depth - 1].resume = place.statement;
                let reaction = context.host.safe_point(context.machine, place);
                if reaction != Reaction::Continue {
                    let entered = matches!(reaction, Reaction::Enter { .. });
                    let exit = self.react(context, reaction);
                    if exit.is_some() || entered {
                        return exit;
                    }
                }
                context.machine.frames[depth - 1].resume = place.statement + 1;
            }
        }
    }

    fn read(&self, context: &mut Context<'_>, place: FaultPlace, from: &str) -> Result<u32, Option<Exit>> {
        let address = address(from);
        if !from.starts_with('P') {
            return Ok(context.machine.memory.read(&Operand::Address(address)).expect("the script stays inside the areas"));
        }
        context.host.peripheral_read(context.machine, address.byte, address.width).ok_or_else(|| {
            let fault = Fault::IoAccess { write: false, width: address.width, byte: address.byte };
            let reaction = context.host.fault(context.machine, &fault, place);
            self.react(context, reaction)
        })
    }

    fn write(&self, context: &mut Context<'_>, place: FaultPlace, to: &str, value: u32) -> Option<Exit> {
        let address = address(to);
        if !to.starts_with('P') {
            assert!(context.machine.memory.write(&Operand::Address(address), value), "the script stays inside the areas");
            return None;
        }
        if context.host.peripheral_write(context.machine, address.byte, address.width, value) {
            return None;
        }
        let fault = Fault::IoAccess { write: true, width: address.width, byte: address.byte };
        let reaction = context.host.fault(context.machine, &fault, place);
        self.react(context, reaction)
    }
}

impl Engine for Script {
    fn run(&self, context: &mut Context<'_>, entry: &Entry) -> Exit {
        context.machine.registers = entry.registers.as_deref().cloned().unwrap_or_else(Registers::fresh);
        self.push(context, entry.block, &entry.start_information, Origin::Start);
        self.go(context)
    }
    fn resume(&self, context: &mut Context<'_>) -> Exit {
        self.go(context)
    }
    fn go_on(&self, context: &mut Context<'_>) -> Exit {
        self.go(context)
    }
    fn image_writes(&self, _: &Program) -> ImageWrites {
        ImageWrites::anywhere()
    }
    fn has_block(&self, block: BlockId) -> bool {
        self.0.contains_key(&block)
    }
}

pub(crate) fn operand(text: &str) -> Operand {
    Operand::parse(text).unwrap_or_else(|| panic!("`{text}` is an operand"))
}

fn address(text: &str) -> Address {
    match operand(text) {
        Operand::Address(address) => address,
        other => panic!("{other:?} is no address"),
    }
}

/// A programming error with this code.
pub(crate) fn programming(code: u8) -> Step {
    Step::Fault(Fault::Programming { code, register: 7, access: 0x23 })
}

pub(crate) fn read_error(byte: u32) -> Step {
    Step::Fault(Fault::IoAccess { write: false, width: Width::Word, byte })
}

pub(crate) fn cpu_type(name: &str) -> &'static CpuType {
    CpuType::by_name(name).expect("a CPU type")
}

/// A CPU of the default type with the whole area simulated.
pub(crate) fn cpu(blocks: &[(u16, &[Step])], settings: Settings) -> Cpu {
    cpu_of("315-2PN/DP", blocks, settings)
}

pub(crate) fn cpu_of(name: &str, blocks: &[(u16, &[Step])], settings: Settings) -> Cpu {
    let cpu_type = cpu_type(name);
    Cpu::load(cpu_type, Arc::new(Program::default()), |_, _| Arc::new(Script::new(blocks)), Rack::simulated(cpu_type), settings)
}
