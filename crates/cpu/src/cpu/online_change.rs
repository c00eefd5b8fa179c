//! Another program takes over between two scans, with the data of the first.

use std::collections::BTreeSet;
use std::fmt;
use std::sync::Arc;

use sieben_engine::machine::Registers;
use sieben_engine::{Machine, Program};
use sieben_model::address::Area;
use sieben_model::block::BlockId;
use sieben_model::program::DataBlock;

use super::{Cpu, Loaded, available};
use crate::created_data_blocks;
use crate::data_block_change::DataBlockChange;
use crate::mode::OperatingMode;
use crate::online_change::{BlockChange, OnlineChange};
use crate::process_image::Images;

/// Why a program does not take over. The other one goes on unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChangeRefused {
    /// It was loaded for another CPU type: memory and limits are different.
    OtherCpuType,
    /// The CPU is in the middle of a scan or startup (HOLD): blocks that run have no place in another program.
    Running,
    /// Another program has taken over since the change was begun.
    OtherProgram,
    /// A data block was to have the values of the new program, and there is none with this number in either of them.
    NoDataBlock(u16),
}

impl fmt::Display for ChangeRefused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OtherCpuType => f.write_str("another CPU type needs a restart"),
            Self::Running => f.write_str("the CPU is in the middle of a scan"),
            Self::OtherProgram => f.write_str("another program has taken over meanwhile"),
            Self::NoDataBlock(number) => write!(f, "no program has the DB{number} whose values are to be taken over"),
        }
    }
}

impl std::error::Error for ChangeRefused {}

impl Cpu {
    /// What would change, and what of the data cannot be kept, if this program took over now. Nothing changes.
    pub fn plan_change(&self, new: &Loaded) -> OnlineChange {
        self.plan_change_taking(new, &BTreeSet::new())
    }

    /// The same where these data blocks keep no value: they have those of the new program, as after a download.
    pub fn plan_change_taking(&self, new: &Loaded, new_values: &BTreeSet<u16>) -> OnlineChange {
        let created: Vec<u16> =
            created_data_blocks::created(&self.machine, &self.system.non_retain).iter().map(|block| block.number).collect();
        OnlineChange::between_taking(&self.program, &new.program, &created, new_values)
    }

    /// Another program takes over, between two scans. Inputs, outputs, bit memory, timers and counters stay, and with them edges and
    /// times that run; so do the values of data blocks, by name and type. The operating mode stays too: no startup block runs.
    ///
    /// OB 90 begins anew, and a CPU in STOP makes no hot restart after it. Answers what has changed.
    ///
    /// # Errors
    /// Why not; then nothing has changed.
    pub fn change_online(&mut self, new: Loaded) -> Result<OnlineChange, ChangeRefused> {
        self.change_online_taking(new, &BTreeSet::new())
    }

    /// The same where these data blocks keep no value: they have those of the new program, also in the load memory.
    ///
    /// # Errors
    /// Why not; then nothing has changed.
    pub fn change_online_taking(&mut self, new: Loaded, new_values: &BTreeSet<u16>) -> Result<OnlineChange, ChangeRefused> {
        if *self.cpu_type != *new.cpu_type {
            return Err(ChangeRefused::OtherCpuType);
        }
        if !matches!(self.mode, OperatingMode::Run | OperatingMode::Stop) || !self.machine.frames.is_empty() {
            return Err(ChangeRefused::Running);
        }
        let is_nowhere = |number: &&u16| !self.program.data.contains_key(number) && !new.program.data.contains_key(number);
        if let Some(&number) = new_values.iter().find(is_nowhere) {
            return Err(ChangeRefused::NoDataBlock(number));
        }
        let change = self.plan_change_taking(&new, new_values);
        let Loaded { program, layout, engine, declarations, image_writes, .. } = new;
        let old_program = std::mem::replace(&mut self.program, program);
        let old = std::mem::replace(&mut self.machine, Machine::new(layout));
        self.engine = engine;
        self.declarations = declarations;
        self.images = Images::new(image_writes);
        self.keeper.forget();
        self.forget_other_load_memory(&old_program);
        self.system.load_memory.retain(|number, _| !new_values.contains(number));
        self.load_data_blocks(|_| true);
        self.take_memory(&old);
        self.take_data(&old, &old_program, &change);
        let (cpu_type, engine) = (self.cpu_type, Arc::clone(&self.engine));
        self.interrupts.set_available(|number| available(cpu_type, &*engine, number));
        if self.mode == OperatingMode::Run {
            let cyclic = self.all_cyclic();
            self.interrupts.cyclic.change(cyclic.into_iter(), self.machine.clock_us);
        }
        (self.paused, self.background_began) = (None, false);
        self.warm_demanded |= self.interrupted.take().is_some();
        let now = self.date_and_time();
        for &(id, what) in &change.blocks {
            match what {
                BlockChange::Added | BlockChange::Changed => self.load_times.later(id, now),
                BlockChange::Removed => self.load_times.forget(id),
            }
        }
        for &number in change.new_values.iter().filter(|number| self.program.data.contains_key(number)) {
            self.load_times.later(BlockId::db(number), now);
        }
        Ok(change)
    }

    /// Begins a change of data blocks: `put` come to the program or take the place of others, `removed` go. [`Loaded::changed`] makes the
    /// program of it, away from the CPU, and [`Self::change_data_blocks`] lets that take over.
    pub fn data_block_change(&self, put: Vec<DataBlock>, removed: BTreeSet<u16>) -> DataBlockChange {
        DataBlockChange::new(Arc::clone(&self.program), self.cpu_type, put, removed)
    }

    /// The program of a change of data blocks takes over, as [`Self::change_online_taking`]: its data blocks keep no value. Retentive data stays
    /// that of the program that was loaded, which the next start has again: data blocks that came, went or are declared differently now have no part in it.
    ///
    /// # Errors
    /// Why not; then nothing has changed.
    pub fn change_data_blocks(&mut self, new: Loaded, change: &DataBlockChange) -> Result<OnlineChange, ChangeRefused> {
        if !Arc::ptr_eq(&self.program, &change.base) {
            return Err(ChangeRefused::OtherProgram);
        }
        let of_sources = Arc::clone(&self.declarations);
        let made = self.change_online_taking(new, &change.taken())?;
        self.declarations = Arc::new(of_sources.after_change(&self.declarations));
        Ok(made)
    }

    /// What the program wrote to the load memory goes where the sources bring other values.
    fn forget_other_load_memory(&mut self, old: &Program) {
        let new = &self.program;
        let image = |program: &Program, number: u16| program.data.get(&number).map(|block| block.image.clone());
        self.system.load_memory.retain(|&number, _| image(old, number) == image(new, number));
    }

    /// All that has the same place in every program of a CPU type.
    fn take_memory(&mut self, old: &Machine) {
        let machine = &mut self.machine;
        for area in [Area::Input, Area::Output, Area::BitMemory] {
            machine.memory.area_mut(area).copy_from_slice(old.memory.area(area));
        }
        machine.timers.clone_from(&old.timers);
        machine.counters.clone_from(&old.counters);
        (machine.clock_us, machine.budget) = (old.clock_us, old.budget);
        machine.registers = Registers::fresh();
    }

    /// The values of data blocks, and the data blocks that the program has made.
    fn take_data(&mut self, old: &Machine, old_program: &Program, change: &OnlineChange) {
        let memory = &mut self.machine.memory;
        for &number in old_program.data.keys() {
            let [then, now] = [&old.memory, &*memory].map(|memory| memory.data_block(u64::from(number)));
            let (Some(then), Some(now)) = (then, now) else { continue };
            let values = &old.memory.arena[then.base as usize..(then.base + then.length) as usize];
            let range = now.base as usize..(now.base + now.length) as usize;
            change.carry_over(number, values, &mut memory.arena[range]);
        }
        for block in created_data_blocks::created(old, &self.system.non_retain) {
            let values = &old.memory.arena[block.base as usize..(block.base + block.length) as usize];
            if self.program.data.contains_key(&block.number) {
                self.system.non_retain.remove(&block.number);
            } else {
                created_data_blocks::create(&mut self.machine, block.number, values, block.attributes.read_only);
            }
        }
    }
}
