//! Blocks that become active or go: new values in place, everything else as an online change.

use std::collections::BTreeSet;
use std::fmt;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError};

use sieben_cpu::{ChangeRefused, DataBlockChange, DataBlockInUse, Loaded, Station, undeclared};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::program::DataBlock;
use sieben_workspace::gate::Plant;

use super::{STORED_BYTES_MAX, Surroundings};
use crate::s7comm::job::{BlockName, BlockPlace, BlockType, Pending, Reply};
use crate::s7comm::wire::block_image::Image;
use crate::s7comm::wire::codes::Refusal;

/// Makes a changed program ready to run, away from the CPU: it takes an engine, which no server knows.
pub trait Linker: fmt::Debug + Send + Sync {
    /// Begins; what comes of it is received when it is there. A sender that is dropped has failed.
    fn prepare(&self, change: Arc<DataBlockChange>) -> Receiver<Result<Loaded, DataBlockInUse>>;
}

/// A change that is being prepared.
#[derive(Debug)]
struct Linking {
    change: Arc<DataBlockChange>,
    prepared: Receiver<Result<Loaded, DataBlockInUse>>,
    ready: Option<Ready>,
    /// The images that are stored no longer afterwards.
    done: Vec<(BlockType, u16)>,
}

/// A program that can take over.
struct Ready(Loaded);

impl fmt::Debug for Ready {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Ready")
    }
}

impl Pending for Linking {
    fn poll(&mut self, plant: &mut Plant, around: &mut Surroundings) -> Option<Reply> {
        if self.ready.is_none() {
            self.ready = match self.prepared.try_recv() {
                Ok(Ok(loaded)) => Some(Ready(loaded)),
                Ok(Err(DataBlockInUse { .. })) => return Some(Reply::Refused(Refusal::BlockCoordination)),
                Err(TryRecvError::Empty) => None,
                Err(TryRecvError::Disconnected) => return Some(Reply::Refused(Refusal::CannotPerform)),
            };
        }
        let Ready(loaded) = self.ready.as_ref()?;
        match plant.cpu.change_data_blocks(loaded.clone(), &self.change) {
            Ok(_) => {
                for &(block_type, number) in &self.done {
                    around.stored.forget(block_type, number);
                }
                Some(Reply::Done)
            }
            // In HOLD; it may go on.
            Err(ChangeRefused::Running) => None,
            Err(ChangeRefused::OtherProgram) => Some(Reply::Refused(Refusal::BlockCoordination)),
            Err(ChangeRefused::OtherCpuType | ChangeRefused::NoDataBlock(_)) => Some(Reply::Refused(Refusal::CannotPerform)),
        }
    }
}

/// Begins an online change.
fn begin(
    plant: &Plant,
    around: &Surroundings,
    (put, removed): (Vec<DataBlock>, BTreeSet<u16>),
    done: Vec<(BlockType, u16)>,
) -> Result<Reply, Refusal> {
    let linker = around.linker.as_ref().ok_or(Refusal::CannotPerform)?;
    let change = Arc::new(plant.cpu.data_block_change(put, removed));
    let prepared = linker.prepare(Arc::clone(&change));
    Ok(Reply::Later(Box::new(Linking { change, prepared, ready: None, done })))
}

/// Links blocks that were downloaded, all of them or none.
pub(super) fn link(plant: &mut Plant, around: &mut Surroundings, names: &[BlockName]) -> Reply {
    try_link(plant, around, names).unwrap_or_else(Reply::Refused)
}

fn try_link(plant: &mut Plant, around: &mut Surroundings, names: &[BlockName]) -> Result<Reply, Refusal> {
    let names: BTreeSet<(BlockType, u16)> = names.iter().map(|name| (name.block_type, name.number)).collect();
    let mut blocks = Vec::new();
    for &(block_type, number) in &names {
        let image = around.stored.image(block_type, number).ok_or(Refusal::BlockNotFound)?;
        // Machine code does not run yet.
        if block_type != BlockType::DataBlock {
            return Err(Refusal::TestNotSupported);
        }
        blocks.push(declared(plant, &Image::read(image)?)?);
    }
    let is_only_values = |block: &DataBlock| {
        let old = plant.cpu.program().data.get(&block.number);
        old.is_some_and(|old| (old.image.len(), old.non_retain) == (block.image.len(), block.non_retain))
    };
    let done: Vec<(BlockType, u16)> = names.into_iter().collect();
    if !blocks.iter().all(is_only_values) {
        has_room(plant, &blocks)?;
        return begin(plant, around, (blocks, BTreeSet::new()), done);
    }
    for block in &blocks {
        // The first one is refused or none: what could differ is the mode.
        plant.cpu.replace_data_block(block).map_err(|_| Refusal::CannotPerform)?;
    }
    for (block_type, number) in done {
        around.stored.forget(block_type, number);
    }
    Ok(Reply::Done)
}

/// Whether the load memory has room for data blocks that come to those that are there. A program that was larger from the beginning may stay so.
fn has_room(plant: &Plant, blocks: &[DataBlock]) -> Result<(), Refusal> {
    let data = &plant.cpu.program().data;
    let length = |block: &DataBlock| block.image.len();
    let before: usize = data.values().map(length).sum();
    let gone: usize = blocks.iter().filter_map(|block| data.get(&block.number)).map(length).sum();
    let after = before - gone + blocks.iter().map(length).sum::<usize>();
    if after > STORED_BYTES_MAX.max(before) { Err(Refusal::NoMemory) } else { Ok(()) }
}

/// The data block that an image means: with the declaration of the one that is there, if the length fits, else bytes without names.
fn declared(plant: &Plant, image: &Image<'_>) -> Result<DataBlock, Refusal> {
    let (values, non_retain) = (image.body.to_vec(), image.non_retain);
    let Some(old) = plant.cpu.program().data.get(&image.number) else {
        return Ok(DataBlock { non_retain, ..undeclared(image.number, values) });
    };
    if old.image.len() == values.len() {
        return Ok(DataBlock { image: values, non_retain, ..old.clone() });
    }
    let of_block = old.based_on.is_some_and(|id| matches!(id.kind, BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock));
    if of_block {
        return Err(Refusal::InstanceMismatch);
    }
    // READ_ONLY and UNLINKED are in no image.
    Ok(DataBlock { non_retain, read_only: old.read_only, unlinked: old.unlinked, ..undeclared(image.number, values) })
}

/// Deletes blocks, all of them or none.
pub(super) fn delete(plant: &mut Plant, around: &mut Surroundings, names: &[BlockName]) -> Reply {
    try_delete(plant, around, names).unwrap_or_else(Reply::Refused)
}

fn try_delete(plant: &mut Plant, around: &mut Surroundings, names: &[BlockName]) -> Result<Reply, Refusal> {
    let (mut stored, mut removed, mut created) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
    for name in names {
        let passive = name.place != BlockPlace::Active && around.stored.image(name.block_type, name.number).is_some();
        let id = name.block_type.kind().map(|kind| BlockId::new(kind, name.number));
        let active = id.filter(|_| name.place != BlockPlace::Passive).and_then(|id| plant.cpu.block(id));
        match active {
            Some(view) if view.id.kind != BlockKind::DataBlock => return Err(Refusal::Protected),
            Some(view) if plant.cpu.program().data.contains_key(&view.id.number) => removed.insert(view.id.number),
            Some(view) => created.insert(view.id.number),
            None if passive => true,
            None => return Err(Refusal::BlockNotFound),
        };
        if passive {
            stored.insert((name.block_type, name.number));
        }
    }
    let stored: Vec<(BlockType, u16)> = stored.into_iter().collect();
    let change = if removed.is_empty() { None } else { Some(begin(plant, around, (Vec::new(), removed), stored.clone())?) };
    for &number in &created {
        // What could refuse it is the mode, and that refuses the first.
        if !plant.cpu.delete_created_data_block(number) {
            return Err(Refusal::CannotPerform);
        }
    }
    if let Some(change) = change {
        return Ok(change);
    }
    for (block_type, number) in stored {
        around.stored.forget(block_type, number);
    }
    Ok(Reply::Done)
}
