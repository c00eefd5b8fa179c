//! `run --watch`: looks for changed sources, compiles them beside the running program, and lets them take over between two scans.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{BufRead, IsTerminal};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, SyncSender, TryRecvError, channel, sync_channel};
use std::time::{Duration, SystemTime};

use sieben_cpu::{Cpu, Loaded, OnlineChange};
use sieben_jit::StatusBits;
use sieben_model::cpu_type::CpuType;
use sieben_model::visible::visible;
use sieben_workspace::finding;
use sieben_workspace::online_change;
use sieben_workspace::project::{Build, Overrides};
use sieben_workspace::settings::{FILE_NAME, Settings};

use crate::arguments::ProgramArguments;
use crate::engines::EngineArgument;
use crate::failure::Failure;
use crate::{language, output, paths, report};

/// How often the files are looked at. A change is taken when the next look finds it finished.
const LOOK_PERIOD: Duration = Duration::from_millis(250);

/// What the thread that looks found.
enum Found {
    /// Diagnostics of sources that do not compile, ready to be shown, or why they cannot be read.
    Broken(String),
    /// A program that can take over.
    Ready(Box<Prepared>),
}

/// A program that is ready to take over.
struct Prepared {
    build: Build,
    loaded: Loaded,
}

/// What is said about a change, by the one who knows where it is shown.
pub(crate) type Say<'a> = &'a mut dyn FnMut(&str);

/// What becomes of a change that values are lost by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Losses {
    /// It is taken over.
    Accepted,
    /// The user is asked, where a terminal is there.
    Asked,
    /// It is not taken over: a screen has the terminal.
    Refused,
}

/// The watched sources of a run.
pub(crate) struct Watch {
    found: Receiver<Found>,
    /// Lines that a user types, if somebody is there to be asked.
    answers: Option<Receiver<String>>,
    /// Whether what cannot be kept is given up without asking.
    accept_losses: bool,
    /// A program that waits for an answer.
    pending: Option<Box<Prepared>>,
    /// Programs that took over.
    pub(crate) changes: u64,
}

impl Watch {
    /// Begins to look at the files of a program that is about to run; `stamps` are those from before it was read.
    pub(crate) fn start(
        stamps: Stamps,
        paths: &[PathBuf],
        (program, overrides): (&ProgramArguments, Overrides),
        engine: EngineArgument,
        build: &Build,
        losses: Losses,
    ) -> Result<Self, Failure> {
        let (sender, found) = sync_channel(0);
        let looking = Looking {
            paths: paths.to_vec(),
            program: program.clone(),
            overrides,
            engine,
            cpu: build.cpu,
            settings: build.project.settings.clone(),
            sources: sources(build),
        };
        // Nobody waits for the thread: it ends with the process, or when the run no longer listens.
        let _ = std::thread::Builder::new().name("watch".to_owned()).spawn(move || looking.look(stamps, &sender));
        Ok(Self {
            found,
            answers: (losses == Losses::Asked && std::io::stdin().is_terminal()).then(lines),
            accept_losses: losses == Losses::Accepted,
            pending: None,
            changes: 0,
        })
    }

    /// Between two scans: takes over what is ready. `build` is that of the running program.
    pub(crate) fn poll(&mut self, cpu: &mut Cpu, build: &mut Build, say: Say<'_>) {
        match self.found.try_recv() {
            Ok(Found::Broken(text)) => {
                self.pending = None;
                say(&format!("{text}The sources have changed and do not compile: the program that runs goes on unchanged.\n"));
            }
            Ok(Found::Ready(prepared)) => self.ready(prepared, cpu, build, say),
            Err(TryRecvError::Empty | TryRecvError::Disconnected) => {}
        }
        let Some(answer) = self.answers.as_ref().and_then(|answers| answers.try_recv().ok()) else { return };
        let Some(prepared) = self.pending.take() else { return };
        if matches!(answer.trim().to_ascii_lowercase().as_str(), "y" | "yes") {
            self.take_over(prepared, cpu, build, say);
        } else {
            say("Not taken over: the program that runs goes on unchanged.\n");
        }
    }

    fn ready(&mut self, prepared: Box<Prepared>, cpu: &mut Cpu, build: &mut Build, say: Say<'_>) {
        let change = cpu.plan_change(&prepared.loaded);
        self.pending = None;
        if change.is_empty() {
            // Comments, spaces, names: the lines of the sources are others all the same.
            self.take_over(prepared, cpu, build, &mut |_| ());
            return;
        }
        say(&visible(&format!("The sources have changed: {}.\n{}", online_change::blocks(&change), online_change::details(&change))));
        if change.losses.is_empty() || self.accept_losses {
            self.take_over(prepared, cpu, build, say);
        } else if self.answers.is_some() {
            say("Take it over and lose these values? Type y or n, then Enter.\n");
            self.pending = Some(prepared);
        } else {
            say("Not taken over: values would be lost. `--accept-losses` takes it over all the same.\n");
        }
    }

    fn take_over(&mut self, prepared: Box<Prepared>, cpu: &mut Cpu, build: &mut Build, say: Say<'_>) {
        let Prepared { build: new, loaded } = *prepared;
        match cpu.change_online(loaded) {
            Ok(OnlineChange { losses, .. }) => {
                *build = new;
                self.changes += 1;
                say(if losses.is_empty() { "Taken over; all values are kept.\n" } else { "Taken over; all other values are kept.\n" });
            }
            Err(refused) => say(&visible(&format!("Not taken over: {refused}.\n"))),
        }
    }
}

/// Lines of standard input, until it ends.
fn lines() -> Receiver<String> {
    let (sender, receiver) = channel();
    let read = move || {
        for line in std::io::stdin().lock().lines() {
            if line.ok().and_then(|line| sender.send(line).ok()).is_none() {
                return;
            }
        }
    };
    let _ = std::thread::Builder::new().name("answers".to_owned()).spawn(read);
    receiver
}

/// The files that a program was made of.
fn sources(build: &Build) -> BTreeSet<PathBuf> {
    build.project.sources.iter().map(|source| source.path.clone()).collect()
}

/// A file as it was when somebody looked: length and time; `None` = it is not there.
type Stamp = Option<(u64, Option<SystemTime>)>;

/// All files of a program.
pub(crate) type Stamps = BTreeMap<PathBuf, Stamp>;

/// The files that the command line names as they are now; taken before they are read, so that no change is missed.
pub(crate) fn stamps(paths: &[PathBuf]) -> Stamps {
    let here = [PathBuf::from(".")];
    let paths = if paths.is_empty() { here.as_slice() } else { paths };
    let mut files: BTreeSet<PathBuf> = BTreeSet::new();
    for path in paths {
        if path.is_dir() {
            files.insert(path.join(FILE_NAME));
            let below = paths::files_below(path).unwrap_or_default();
            files.extend(below.into_iter().filter(|file| paths::is_program(file) || paths::is_test(file) || paths::is_symbols(file)));
        } else {
            files.insert(path.clone());
        }
    }
    files.into_iter().map(|path| (path.clone(), stamp(&path))).collect()
}

/// Waits until the files differ from these, and somebody has finished writing.
pub(crate) fn wait_for_change(paths: &[PathBuf], taken: &Stamps) {
    let mut before = taken.clone();
    loop {
        std::thread::sleep(LOOK_PERIOD);
        let now = stamps(paths);
        if now != *taken && now == before {
            return;
        }
        before = now;
    }
}

fn stamp(path: &Path) -> Stamp {
    fs::metadata(path).ok().map(|file| (file.len(), file.modified().ok()))
}

/// What the thread needs to know.
struct Looking {
    paths: Vec<PathBuf>,
    program: ProgramArguments,
    overrides: Overrides,
    engine: EngineArgument,
    cpu: &'static CpuType,
    settings: Settings,
    /// The sources of the last build; a project may name files that do not look like sources.
    sources: BTreeSet<PathBuf>,
}

impl Looking {
    /// Looks until nobody listens.
    fn look(mut self, mut taken: Stamps, sender: &SyncSender<Found>) {
        for path in &self.sources {
            taken.entry(path.clone()).or_insert_with(|| stamp(path));
        }
        let mut before = taken.clone();
        loop {
            std::thread::sleep(LOOK_PERIOD);
            let now = self.stamps();
            // An editor may be in the middle of writing.
            if now != taken && now == before {
                taken.clone_from(&now);
                if sender.send(self.compile()).is_err() {
                    return;
                }
            }
            before = now;
        }
    }

    fn stamps(&self) -> Stamps {
        let mut stamps = stamps(&self.paths);
        for path in &self.sources {
            stamps.entry(path.clone()).or_insert_with(|| stamp(path));
        }
        stamps
    }

    fn compile(&mut self) -> Found {
        let project = match self.program.load(&self.paths) {
            Ok(project) => project,
            Err(failure) => return Found::Broken(format!("{}\n", visible(&failure.refusal.message))),
        };
        let build = project.compile(self.overrides, false);
        self.sources = sources(&build);
        if finding::has_errors(&build.findings) {
            return Found::Broken(report::render(&build.findings, &build.project.texts, output::colour(), language::spoken()));
        }
        if *build.cpu != *self.cpu {
            return Found::Broken("The CPU type is another one, which needs a restart.\n".to_owned());
        }
        if self.settings != build.project.settings {
            self.settings = build.project.settings.clone();
            output::message(&format!("What `{}` says beside the files takes effect with the next start.\n", FILE_NAME));
        }
        let program = Arc::new(build.compiled.program.clone());
        let load = |program: &_, layout: &_| self.engine.load(program, layout, StatusBits::Needed);
        let loaded = Loaded::new(build.cpu, program, load);
        Found::Ready(Box::new(Prepared { build, loaded }))
    }
}
