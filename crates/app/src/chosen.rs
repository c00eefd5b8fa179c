//! The project of a page: which examples may run instead, how one of them takes its place, and the watch tables beside its program.

use std::ffi::OsStr;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use sieben_model::problems::Problem;
use sieben_workbench::{Listed, Projects};
use sieben_workspace::exchange::Next;
use sieben_workspace::project::{Build, Overrides, Project};
use sieben_workspace::watch_table::{ENDING, WATCH_BYTES_MAX};
use sieben_workspace::{Closed, Gate, Refusal, finding};

use crate::examples::{self, Example};
use crate::files;
use crate::folder::{Folder, Foreign};

/// How long the thread that scans may take before another CPU is there.
const TAKEN_WAIT: Duration = Duration::from_secs(10);
/// How long it is waited before it is looked whether the run is over.
const LOOK_AGAIN: Duration = Duration::from_millis(200);
/// Entries of a folder that are looked through for watch tables.
const WATCH_ENTRIES_MAX: usize = 10_000;
/// Watch tables that are listed.
const WATCH_TABLES_MAX: usize = 200;

/// An example that is to run instead.
pub(crate) struct Change {
    /// Which one.
    pub(crate) example: &'static Example,
    /// Its program.
    pub(crate) build: Build,
    /// Its CPU.
    pub(crate) next: Next,
}

/// Makes the CPU of an example, as this run has it.
pub(crate) type Prepare = Box<dyn Fn(&'static Example) -> Result<Change, Refusal> + Send + Sync>;

/// Which projects a page shows.
pub(crate) enum Choice {
    /// Any of the examples: the run began with this one.
    Examples(&'static Example),
    /// This one alone, by its name.
    Alone(String),
}

/// The project of a page, and the way to the thread that scans.
pub(crate) struct Chosen {
    choice: Choice,
    prepare: Prepare,
    /// The example that runs, where the page may change it, and how often that was done.
    runs: Mutex<(Option<&'static Example>, u64)>,
    /// The folder of the project that the run began with; none after a change.
    home: Mutex<Option<PathBuf>>,
    /// Only one change at a time.
    changing: Mutex<()>,
    wanted: Mutex<Option<Change>>,
    is_wanted: AtomicBool,
    taken: Condvar,
    gate: Arc<Gate>,
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Chosen {
    /// The project that a run begins with, and the folder that it was read from.
    pub(crate) fn new(choice: Choice, home: Option<&Path>, gate: &Arc<Gate>, prepare: Prepare) -> Self {
        let example = if let Choice::Examples(example) = choice { Some(example) } else { None };
        Self {
            choice,
            prepare,
            runs: Mutex::new((example, 0)),
            // Wherever it was named from, it is shown as it lies on the disk.
            home: Mutex::new(home.map(|home| std::fs::canonicalize(home).unwrap_or_else(|_| home.to_path_buf()))),
            changing: Mutex::default(),
            wanted: Mutex::default(),
            is_wanted: AtomicBool::default(),
            taken: Condvar::new(),
            gate: Arc::clone(gate),
        }
    }

    /// The example that is to run instead, for the thread that scans; it calls [`Self::took`] as soon as that runs.
    pub(crate) fn take(&self) -> Option<Change> {
        // No lock as long as none is wanted, which is nearly always.
        if !self.is_wanted.load(Ordering::Acquire) {
            return None;
        }
        self.is_wanted.store(false, Ordering::Release);
        lock(&self.wanted).take()
    }

    /// An example runs from now on.
    pub(crate) fn took(&self, example: &'static Example) {
        *lock(&self.home) = None;
        let mut runs = lock(&self.runs);
        *runs = (Some(example), runs.1 + 1);
        self.taken.notify_all();
    }

    /// The example that runs, where it may be changed.
    pub(crate) fn example(&self) -> Option<&'static Example> {
        lock(&self.runs).0
    }

    /// Waits until more than so many changes are done, as long as that makes sense.
    fn wait(&self, before: u64) -> Result<(), Refusal> {
        let deadline = Instant::now() + TAKEN_WAIT;
        let mut runs = lock(&self.runs);
        while runs.1 <= before {
            if self.gate.is_closed() {
                return Err(Closed.into());
            }
            if Instant::now() >= deadline {
                drop(lock(&self.wanted).take());
                return Err(Refusal::new(Problem::P7093, "the scan of the project that runs has not ended")
                    .help("stop the CPU, and change over then"));
            }
            (runs, _) = self.taken.wait_timeout(runs, LOOK_AGAIN).unwrap_or_else(PoisonError::into_inner);
        }
        Ok(())
    }
}

impl Projects for Chosen {
    fn listed(&self) -> Listed {
        let path = lock(&self.home).as_deref().map(crate::paths::shown);
        match &self.choice {
            Choice::Alone(name) => Listed { name: name.clone(), path, examples: Vec::new() },
            Choice::Examples(first) => {
                let name = self.example().unwrap_or(first).name.to_owned();
                Listed { name, path, examples: examples::ALL.iter().map(|example| (example.name, example.about)).collect() }
            }
        }
    }

    fn change(&self, wanted: &str) -> Result<(), Refusal> {
        if let Choice::Alone(name) = &self.choice {
            return Err(Refusal::new(Problem::P7145, format!("this page shows the project `{name}` alone")));
        }
        let names = || examples::ALL.iter().map(|example| example.name).collect::<Vec<_>>().join(", ");
        let example = Example::by_name(wanted)
            .ok_or_else(|| Refusal::new(Problem::P7145, "there is no such example").help(format!("there are {}", names())))?;
        let _changing = lock(&self.changing);
        if self.gate.is_closed() {
            return Err(Closed.into());
        }
        let change = (self.prepare)(example)?;
        let before = lock(&self.runs).1;
        *lock(&self.wanted) = Some(change);
        self.is_wanted.store(true, Ordering::Release);
        self.gate.wake();
        self.wait(before)
    }

    fn watch_tables(&self) -> Result<Vec<String>, Refusal> {
        let home = lock(&self.home).clone();
        let mut names: Vec<String> = match (home, self.example()) {
            (Some(home), _) => {
                let entries = std::fs::read_dir(&home).map_err(|error| unreadable(&home, &error))?.take(WATCH_ENTRIES_MAX).flatten();
                let plain = entries.filter(|entry| entry.file_type().is_ok_and(|kind| kind.is_file()));
                plain.filter_map(|entry| entry.file_name().into_string().ok()).filter(|name| is_watch_table(name)).collect()
            }
            (None, Some(example)) => example.files.iter().map(|&(name, _)| name.to_owned()).filter(|name| is_watch_table(name)).collect(),
            (None, None) => Vec::new(),
        };
        names.sort();
        names.truncate(WATCH_TABLES_MAX);
        Ok(names)
    }

    fn watch_table(&self, name: &str) -> Result<Vec<u8>, Refusal> {
        let none = |why: &str| {
            let shown: String = name.chars().take(60).collect();
            Refusal::new(Problem::P7147, format!("there is no watch table `{shown}`{why}"))
        };
        // A name with a folder in it would lead elsewhere.
        if !is_watch_table(name) || Path::new(name).file_name() != Some(OsStr::new(name)) {
            return Err(none(""));
        }
        let home = lock(&self.home).clone();
        match (home, self.example()) {
            (Some(home), _) => {
                let failed = |error: io::Error| match (error.kind(), Foreign::of(&error)) {
                    (io::ErrorKind::NotFound | io::ErrorKind::InvalidInput, _) => none(""),
                    (_, Some(foreign)) => none(&format!(": {foreign}")),
                    _ => unreadable(&home.join(name), &error),
                };
                let file = Folder::open(&home).and_then(|folder| folder.read(OsStr::new(name))).map_err(failed)?;
                let mut bytes = Vec::new();
                // One byte more than there may be says that it is too long.
                file.take(WATCH_BYTES_MAX as u64 + 1).read_to_end(&mut bytes).map_err(failed)?;
                Ok(bytes)
            }
            (None, Some(example)) => {
                let file = example.files.iter().find(|&&(known, _)| known == name);
                file.map(|(_, content)| content.as_bytes().to_vec()).ok_or_else(|| none(""))
            }
            (None, None) => Err(none("")),
        }
    }
}

fn is_watch_table(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|ending| ending.eq_ignore_ascii_case(ENDING))
}

fn unreadable(path: &Path, error: &io::Error) -> Refusal {
    files::unreadable(path, error).refusal
}

/// The example that a project is, if all that runs of it is as it came.
pub(crate) fn example_of(project: &Project) -> Option<&'static Example> {
    let home = project.home.as_deref()?;
    let example = Example::by_name(project.settings.name.as_deref()?)?;
    let is_same = |(path, content): &(&str, &str)| files::read(&home.join(path)).is_ok_and(|bytes| bytes == content.as_bytes());
    let came = project.sources.len() == example.project().sources.len();
    (came && example.compiled().all(is_same)).then_some(example)
}

/// The program of an example, with what the command line says about programs.
pub(crate) fn build(example: &'static Example, overrides: Overrides) -> Result<Build, Refusal> {
    let build = example.project().compile(overrides, false);
    match finding::has_errors(&build.findings) {
        false => Ok(build),
        true => {
            let name = example.name;
            Err(Refusal::new(Problem::P7145, format!("the example `{name}` does not compile with the options of this run")))
        }
    }
}
