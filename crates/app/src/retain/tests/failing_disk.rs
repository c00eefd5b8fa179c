//! A disk in memory that ends a run at any byte, forgets what was not synced, tears writes and fills up.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard};

use super::super::disk::{Disk, Slotted};

/// Bytes that a power failure keeps or loses together. Far smaller than real ones, so that small records have many of them.
const SECTOR: usize = 16;
/// Bytes of a new file that count as one step: nobody looks at it before it has its name.
const NEW_FILE_STEP: usize = 4096;

/// A disk; clones are the same disk.
#[derive(Clone, Default)]
pub(crate) struct FailingDisk(Arc<Mutex<State>>);

#[derive(Clone, Default)]
struct State {
    nodes: Vec<Node>,
    /// Names as running programs see them, and as they are after a power failure.
    names: BTreeMap<PathBuf, usize>,
    names_on_disk: BTreeMap<PathBuf, usize>,
    /// Steps until the end of the run.
    steps_left: Option<u64>,
    /// Bytes that can still be written before the disk is full.
    room: Option<usize>,
    /// Whether syncs fail.
    sync_fails: bool,
}

#[derive(Clone, Default)]
struct Node {
    live: Vec<u8>,
    on_disk: Vec<u8>,
    /// Writes since the last sync.
    pending: Vec<(usize, Vec<u8>)>,
}

/// An open file.
pub(crate) struct FailingFile {
    disk: FailingDisk,
    node: usize,
}

fn dead() -> io::Error {
    io::Error::other("the run has ended")
}

impl FailingDisk {
    fn state(&self) -> MutexGuard<'_, State> {
        self.0.lock().expect("no test panics while it holds the disk")
    }

    /// Ends the run after so many steps: bytes written, syncs, renames.
    pub(crate) fn end_after(&self, steps: u64) {
        self.state().steps_left = Some(steps);
    }

    /// Whether the run has ended.
    pub(crate) fn ended(&self) -> bool {
        self.state().steps_left == Some(0)
    }

    /// Lets the disk be full after so many bytes, or not at all.
    pub(crate) fn set_room(&self, bytes: Option<usize>) {
        self.state().room = bytes;
    }

    /// Lets syncs fail, or not.
    pub(crate) fn set_sync_fails(&self, fails: bool) {
        self.state().sync_fails = fails;
    }

    /// Removes a file from under the run that writes it.
    pub(crate) fn remove(&self, path: &Path) {
        let mut state = self.state();
        state.names.remove(path);
        state.names_on_disk.remove(path);
    }

    /// Damages a byte of a file.
    pub(crate) fn damage(&self, path: &Path, at: usize) {
        let mut state = self.state();
        let node = state.names[path];
        state.nodes[node].live[at] ^= 0x40;
    }

    /// The disk as the next run finds it after this one was killed.
    pub(crate) fn after_kill(&self) -> Self {
        let state = State { steps_left: None, ..self.state().clone() };
        Self(Arc::new(Mutex::new(state)))
    }

    /// The disk after a power failure: of what was not synced, each sector is there or not as `chance` says.
    pub(crate) fn after_power_failure(&self, chance: &mut dyn FnMut() -> bool) -> Self {
        let state = self.state().clone();
        let mut names = state.names_on_disk.clone();
        for (path, &node) in &state.names {
            if state.names_on_disk.get(path) != Some(&node) && chance() {
                names.insert(path.clone(), node);
            }
        }
        let nodes = state.nodes.iter().map(|node| {
            let mut bytes = node.on_disk.clone();
            for (offset, written) in &node.pending {
                for (index, sector) in written.chunks(SECTOR).enumerate() {
                    if chance() {
                        put(&mut bytes, offset + index * SECTOR, sector);
                    }
                }
            }
            Node { live: bytes.clone(), on_disk: bytes, pending: Vec::new() }
        });
        let nodes = nodes.collect();
        Self(Arc::new(Mutex::new(State { nodes, names: names.clone(), names_on_disk: names, ..State::default() })))
    }
}

fn put(bytes: &mut Vec<u8>, offset: usize, written: &[u8]) {
    if bytes.len() < offset + written.len() {
        bytes.resize(offset + written.len(), 0);
    }
    bytes[offset..offset + written.len()].copy_from_slice(written);
}

impl State {
    /// Takes a step; whether there was one left.
    fn step(&mut self) -> io::Result<()> {
        match &mut self.steps_left {
            Some(0) => Err(dead()),
            Some(left) => {
                *left -= 1;
                Ok(())
            }
            None => Ok(()),
        }
    }

    /// Writes as many bytes as steps and room allow.
    fn write(&mut self, node: usize, offset: usize, bytes: &[u8], step_bytes: usize) -> io::Result<()> {
        let mut written = 0;
        let mut result = Ok(());
        for part in bytes.chunks(step_bytes) {
            let full = self.room.is_some_and(|room| room < part.len());
            result = if full { Err(io::ErrorKind::StorageFull.into()) } else { self.step() };
            if result.is_err() {
                break;
            }
            if let Some(room) = &mut self.room {
                *room -= part.len();
            }
            written += part.len();
        }
        let node = &mut self.nodes[node];
        put(&mut node.live, offset, &bytes[..written]);
        node.pending.push((offset, bytes[..written].to_vec()));
        result
    }

    fn sync(&mut self, node: usize) -> io::Result<()> {
        self.step()?;
        if self.sync_fails {
            return Err(io::Error::other("input/output error"));
        }
        let node = &mut self.nodes[node];
        node.on_disk.clone_from(&node.live);
        node.pending.clear();
        Ok(())
    }
}

impl Disk for FailingDisk {
    type File = FailingFile;

    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let state = self.state();
        state.names.get(path).map(|&node| state.nodes[node].live.clone()).ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn create(&self, path: &Path, content: &[u8]) -> io::Result<FailingFile> {
        let mut state = self.state();
        let node = state.nodes.len();
        state.nodes.push(Node::default());
        state.write(node, 0, content, NEW_FILE_STEP)?;
        state.sync(node)?;
        state.step()?;
        state.names.insert(path.to_path_buf(), node);
        state.step()?;
        state.names_on_disk = state.names.clone();
        Ok(FailingFile { disk: self.clone(), node })
    }

    fn has(&self, path: &Path, file: &FailingFile) -> bool {
        self.state().names.get(path) == Some(&file.node)
    }
}

impl FailingDisk {
    /// Whether there is such a file.
    pub(crate) fn is_there(&self, path: &Path) -> bool {
        self.state().names.contains_key(path)
    }
}

impl Slotted for FailingFile {
    fn write_at(&mut self, offset: u64, bytes: &[u8]) -> io::Result<()> {
        self.disk.state().write(self.node, offset as usize, bytes, 1)
    }

    fn sync(&mut self) -> io::Result<()> {
        self.disk.state().sync(self.node)
    }
}
