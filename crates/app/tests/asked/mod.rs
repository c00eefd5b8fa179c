//! Runs programs with a Host that notes what it is asked.

use sieben_engine::{Context, Entry, Exit, Fault, FaultPlace, Host, Machine, Program, Reaction};
use sieben_model::address::Width;
use sieben_model::block::BlockId;

use crate::dice::Dice;
use crate::program::Load;

/// Notes what it is asked, and gives little budget.
#[derive(Default)]
struct Noting {
    asked: Vec<String>,
    dice: Option<Dice>,
}

impl Host for Noting {
    fn fault(&mut self, machine: &mut Machine, fault: &Fault, place: FaultPlace) -> Reaction {
        self.asked.push(format!("{fault:?} at {place:?} {} {:?}", machine.budget, machine.frames.len()));
        Reaction::Continue
    }
    fn peripheral_read(&mut self, _: &mut Machine, _: u32, _: Width) -> Option<u32> {
        None
    }
    fn peripheral_write(&mut self, _: &mut Machine, _: u32, _: Width, _: u32) -> bool {
        false
    }
    fn safe_point(&mut self, machine: &mut Machine, place: FaultPlace) -> Reaction {
        self.asked.push(format!("{place:?} {} {:?}", machine.budget, machine.frames.len()));
        machine.budget = self.dice.as_mut().map_or(1, |dice| 1 + dice.roll(60) as i64);
        Reaction::Continue
    }
    fn system_function(&mut self, _: &mut Machine, _: BlockId, _: usize) -> Reaction {
        Reaction::Continue
    }
}

/// `check` behind each scan, all that a Host was asked, and memory at the end without local data.
pub(crate) fn run(program: &Program, load: Load, (scans, seed): (i32, u64)) -> (Vec<i32>, Vec<String>, Vec<u8>) {
    let mut loaded = crate::side_by_side::load(program, load);
    let mut host = Noting { asked: Vec::new(), dice: Some(Dice(seed)) };
    let instance = program.data.iter().find(|(_, data)| data.image.len() > 8).map(|(&number, _)| number);
    let range = loaded.machine.memory.layout.data_blocks[&instance.expect("the instance of the program")].clone();
    let mut checks = Vec::new();
    for _ in 0..scans {
        loaded.machine.budget = 1 + host.dice.as_mut().map_or(0, |dice| dice.roll(60) as i64);
        let entry = Entry { block: BlockId::ob(1), start_information: [0; 20], registers: None };
        let exit = loaded.engine.run(&mut Context { machine: &mut loaded.machine, host: &mut host, tracer: None }, &entry);
        assert_eq!(exit, Exit::Finished);
        let bytes = &loaded.machine.memory.arena[range.start + 4..range.start + 8];
        checks.push(i32::from_be_bytes(bytes.try_into().expect("four bytes")));
    }
    let local = loaded.machine.memory.layout.local.clone();
    loaded.machine.memory.arena[local].fill(0);
    (checks, host.asked, loaded.machine.memory.arena.clone())
}
