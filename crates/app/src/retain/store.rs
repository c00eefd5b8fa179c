//! Writes records to the two files: at once to the one, by a thread to the other.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use sieben_cpu::RetainImage;

use super::disk::{Disk, with_ending};
use super::record;
use super::slots::{Slots, Sync};

/// How long after a failed write the next one is tried.
const RETRY: Duration = Duration::from_secs(1);
/// How often the files are looked for: they may be removed while the CPU runs.
const LOOK: Duration = Duration::from_secs(1);
/// Room that a file has for data blocks that the program makes later (64 KB in the CPU), so that it seldom has to be made anew.
const ROOM: usize = 80 * 1024;

/// The path of the file that survives a power failure.
pub(crate) fn synced_path(path: &Path) -> PathBuf {
    with_ending(path, "synced")
}

/// Whether keeping works, told when it changes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Change {
    /// It fails from now on, and why.
    Failed(String),
    /// It works again.
    Works,
    /// A file was gone, and is there again.
    MadeAgain(PathBuf),
}

/// Both files.
pub(crate) struct Store<D: Disk> {
    foreground: Kept<D>,
    background: Option<Background>,
    sequence: u64,
    record: Vec<u8>,
    /// The record is not in its file yet.
    unwritten: bool,
    /// When the last write failed, and why.
    failed: Option<(Instant, String)>,
    /// What was told last.
    told_failed: bool,
    /// When the file was looked for last.
    looked: Option<Instant>,
    /// It was gone, which is not told yet.
    gone: bool,
}

impl<D: Disk + 'static> Store<D> {
    /// A store that writes beside `path`, with records behind `sequence`. With `sync` = 0 every record is on the disk before the next scan.
    pub(crate) fn new(disk: &Arc<D>, path: &Path, sync: Duration, sequence: u64) -> Self {
        let synced = || Kept::new(disk, &synced_path(path), Sync::EveryWrite, ROOM);
        let background = (!sync.is_zero()).then(|| Background::start(synced(), sync)).and_then(Result::ok);
        // Without a thread (by wish, or because the system has none left) the run waits for the disk itself.
        let foreground = match background {
            Some(_) => Kept::new(disk, path, Sync::Never, ROOM),
            None => synced(),
        };
        Self {
            foreground,
            background,
            sequence,
            record: Vec::new(),
            unwritten: false,
            failed: None,
            told_failed: false,
            looked: None,
            gone: false,
        }
    }

    /// Keeps an image, or what could not be kept before. Says when failing begins and ends.
    pub(crate) fn keep(&mut self, image: Option<&RetainImage>, now: Instant) -> Option<Change> {
        if let Some(image) = image {
            self.sequence += 1;
            record::write(&mut self.record, self.sequence, image);
            self.unwritten = true;
        }
        if self.looked.is_none_or(|at| now.saturating_duration_since(at) >= LOOK) {
            self.look(now);
        }
        let waits = self.failed.as_ref().is_some_and(|(at, _)| now.saturating_duration_since(*at) < RETRY);
        if self.unwritten && !waits {
            self.failed = self.foreground.write(&self.record).err().map(|error| (now, self.foreground.describe(&error)));
            self.unwritten = self.failed.is_some();
        }
        if let Some(background) = self.background.as_ref().filter(|_| image.is_some()) {
            background.hand_over(self.sequence, &self.record);
        }
        self.change()
    }

    /// A file that is gone is written again, with what is known.
    fn look(&mut self, now: Instant) {
        self.looked = Some(now);
        if self.foreground.leave_lost() {
            (self.unwritten, self.gone) = (true, true);
        }
    }

    /// Brings everything to the disk. Says if that fails.
    pub(crate) fn close(&mut self, now: Instant) -> Option<Change> {
        self.look(now);
        if self.unwritten {
            self.failed = self.foreground.write(&self.record).err().map(|error| (now, self.foreground.describe(&error)));
            self.unwritten = self.failed.is_some();
        }
        if let Some(background) = &mut self.background {
            background.close();
        }
        self.change()
    }

    fn change(&mut self) -> Option<Change> {
        let foreground = self.failed.as_ref().map(|(_, why)| why);
        let failing = foreground.is_some() || self.background.as_ref().is_some_and(|background| background.shared.failing());
        if failing == self.told_failed {
            let gone = std::mem::take(&mut self.gone).then(|| self.foreground.path.clone());
            return gone.or_else(|| self.background.as_ref()?.shared.lock().made_again.take()).filter(|_| !failing).map(Change::MadeAgain);
        }
        self.told_failed = failing;
        let why = || foreground.cloned().or_else(|| self.background.as_ref()?.shared.lock().failed.clone()).unwrap_or_default();
        Some(if failing { Change::Failed(why()) } else { Change::Works })
    }
}

/// One file, made when it is first written.
pub(crate) struct Kept<D: Disk> {
    disk: Arc<D>,
    path: PathBuf,
    file: Option<Slots<D::File>>,
    synced: Sync,
    room: usize,
}

impl<D: Disk> Kept<D> {
    /// A file that takes records which are so many bytes longer than the first one.
    pub(crate) fn new(disk: &Arc<D>, path: &Path, synced: Sync, room: usize) -> Self {
        Self { disk: Arc::clone(disk), path: path.to_path_buf(), file: None, synced, room }
    }

    /// Writes a record.
    pub(crate) fn write(&mut self, record: &[u8]) -> io::Result<()> {
        match &mut self.file {
            Some(file) if file.takes(record) => file.write(record, self.synced),
            _ => {
                self.file = Some(Slots::create(&*self.disk, &self.path, record.len() + self.room, record)?);
                Ok(())
            }
        }
    }

    /// Lets go of a file that has lost its name, so that the next record makes it anew; whether it had.
    fn leave_lost(&mut self) -> bool {
        let lost = self.file.as_ref().is_some_and(|slots| !self.disk.has(&self.path, slots.file()));
        if lost {
            self.file = None;
        }
        lost
    }

    fn describe(&self, error: &io::Error) -> String {
        format!("`{}` cannot be written: {error}", self.path.display())
    }
}

/// What run and thread share.
struct Shared {
    state: Mutex<State>,
    wake: Condvar,
    failing: AtomicBool,
}

#[derive(Default)]
struct State {
    sequence: u64,
    record: Vec<u8>,
    closing: bool,
    failed: Option<String>,
    /// The file, after it was gone and made again.
    made_again: Option<PathBuf>,
}

impl Shared {
    fn lock(&self) -> MutexGuard<'_, State> {
        // A thread that panicked leaves whole values behind: each is replaced in one step.
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
    fn failing(&self) -> bool {
        self.failing.load(Ordering::Relaxed)
    }
}

/// The thread that waits for the disk.
struct Background {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

impl Background {
    fn start<D: Disk + 'static>(kept: Kept<D>, every: Duration) -> io::Result<Self> {
        let shared = Arc::new(Shared { state: Mutex::default(), wake: Condvar::new(), failing: AtomicBool::new(false) });
        let theirs = Arc::clone(&shared);
        let thread = std::thread::Builder::new().name("retentive data".to_owned()).spawn(move || work(&theirs, kept, every))?;
        Ok(Self { shared, thread: Some(thread) })
    }

    fn hand_over(&self, sequence: u64, record: &[u8]) {
        let mut state = self.shared.lock();
        state.sequence = sequence;
        record.clone_into(&mut state.record);
    }

    fn close(&mut self) {
        self.shared.lock().closing = true;
        self.shared.wake.notify_one();
        if let Some(thread) = self.thread.take() {
            // A panic of the thread was reported where it happened; the other file has the data.
            let _ = thread.join();
        }
    }
}

impl Drop for Background {
    fn drop(&mut self) {
        self.close();
    }
}

/// Brings the newest record to the disk, again and again, and a last time at the end.
fn work<D: Disk>(shared: &Shared, mut kept: Kept<D>, every: Duration) {
    let mut done = 0;
    let mut record = Vec::new();
    loop {
        let (state, _) =
            shared.wake.wait_timeout_while(shared.lock(), every, |state| !state.closing).unwrap_or_else(PoisonError::into_inner);
        let (sequence, closing) = (state.sequence, state.closing);
        if sequence != done {
            state.record.clone_into(&mut record);
        }
        drop(state);
        let lost = kept.leave_lost();
        if sequence != done || lost {
            let failed = kept.write(&record).err().map(|error| kept.describe(&error));
            // What could not be written is written the next time, also when nothing has changed since.
            done = if failed.is_some() { 0 } else { sequence };
            shared.failing.store(failed.is_some(), Ordering::Relaxed);
            let mut state = shared.lock();
            if lost && failed.is_none() {
                state.made_again = Some(kept.path.clone());
            }
            state.failed = failed;
        }
        if closing {
            return;
        }
    }
}
