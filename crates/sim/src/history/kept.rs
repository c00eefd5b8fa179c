//! The snapshots of a history: dense where somebody is likely to go back to, thin far behind, and never more than a limit.

use sieben_cpu::{Cpu, Snapshot};
use sieben_engine::StatementEvent;

use super::Position;

/// Statements between two snapshots: going back runs half as many again, on average. A release build runs about ten million
/// watched statements in a second, one without optimization a million.
pub(super) const EVERY: u64 = 20_000;
/// Actions between two snapshots: scans with few statements cost time too.
const EVERY_ACTIONS: usize = 2_000;
/// The last statements of a run, where no snapshot is left out.
const DENSE: u64 = 1_100_000;
/// Further back a gap may be as long as this part of its age.
const THIN: u64 = 16;
/// Snapshots take at most so many bytes, by their own estimate.
const BYTES_MAX: usize = 256 << 20;
/// Actions that are kept at most: some hours of scans every 10 ms.
const ACTIONS_MAX: usize = 2_000_000;

/// A snapshot and where it was taken.
#[derive(Debug)]
pub(super) struct One {
    pub(super) position: Position,
    pub(super) scans: u64,
    pub(super) last: Option<StatementEvent>,
    pub(super) snapshot: Snapshot,
}

/// All of them, oldest first; never empty.
#[derive(Debug)]
pub(super) struct Kept {
    all: Vec<One>,
}

impl Kept {
    pub(super) fn new(cpu: &Cpu) -> Self {
        Self::from(cpu, Position { statements: 0, actions: 0 }, 0)
    }

    /// Those of a history that goes no further back than to this position.
    pub(super) fn from(cpu: &Cpu, position: Position, scans: u64) -> Self {
        Self { all: vec![One { position, scans, last: None, snapshot: cpu.snapshot(None) }] }
    }

    pub(super) fn first(&self) -> Position {
        self.all[0].position
    }

    pub(super) fn oldest(&self) -> &Snapshot {
        &self.all[0].snapshot
    }

    pub(super) fn bytes(&self) -> usize {
        self.all.iter().map(|one| one.snapshot.bytes()).sum()
    }

    /// Whether the run can go on from a snapshot in another way than it did.
    pub(super) fn has_modules(&self) -> bool {
        self.all.iter().all(|one| one.snapshot.has_modules())
    }

    /// Where the next snapshot is due, in statements, if the run stands here.
    pub(super) fn next_at(&self, position: Position) -> u64 {
        (self.newest().statements + EVERY).max(position.statements + 1)
    }

    fn newest(&self) -> Position {
        self.all[self.all.len() - 1].position
    }

    /// Whether a snapshot is due at this position.
    pub(super) fn is_due(&self, position: Position) -> bool {
        let newest = self.newest();
        position > newest && (position.statements >= newest.statements + EVERY || position.actions >= newest.actions + EVERY_ACTIONS)
    }

    pub(super) fn keep(&mut self, cpu: &Cpu, position: Position, scans: u64, last: Option<&StatementEvent>, end: u64) {
        let snapshot = cpu.snapshot(self.all.last().map(|one| &one.snapshot));
        self.all.push(One { position, scans, last: last.cloned(), snapshot });
        self.thin(end);
    }

    fn thin(&mut self, end: u64) {
        let mut index = 1;
        while index + 1 < self.all.len() {
            let behind = self.all[index + 1].position;
            let age = end.saturating_sub(behind.statements);
            let gap = behind.statements - self.all[index - 1].position.statements;
            let few_actions = behind.actions - self.all[index - 1].position.actions < EVERY_ACTIONS * 16;
            if age > DENSE && gap <= age / THIN && few_actions {
                self.all.remove(index);
            } else {
                index += 1;
            }
        }
    }

    /// Forgets the oldest snapshots until all of them, and the actions since the oldest, fit.
    /// What modules have said takes as much room as `recorded` bytes.
    pub(super) fn bound(&mut self, actions: usize, recorded: usize) {
        let end = self.first().actions + actions;
        let mut bytes = self.bytes();
        let mut forgotten = 0;
        // The words of modules go with the snapshots before them.
        let too_much = |forgotten: usize, bytes: usize| {
            let part = recorded / self.all.len() * (self.all.len() - forgotten);
            bytes + part > BYTES_MAX
        };
        while forgotten + 2 < self.all.len() && (too_much(forgotten, bytes) || end - self.all[forgotten].position.actions > ACTIONS_MAX) {
            bytes -= self.all[forgotten].snapshot.bytes();
            forgotten += 1;
        }
        self.all.drain(..forgotten);
    }

    /// Forgets those behind a position.
    pub(super) fn forget_behind(&mut self, position: Position) {
        let count = self.all.partition_point(|one| one.position <= position).max(1);
        self.all.truncate(count);
    }

    pub(super) fn get(&self, index: usize) -> &One {
        &self.all[index]
    }

    /// The newest one before a position.
    pub(super) fn before(&self, position: Position) -> usize {
        self.all.partition_point(|one| one.position < position).max(1) - 1
    }

    /// The newest one at or before a position.
    pub(super) fn at_or_before(&self, position: Position) -> usize {
        let count =
            self.all.partition_point(|one| one.position.statements <= position.statements && one.position.actions <= position.actions);
        count.max(1) - 1
    }
}
