//! The folders that a client works in, with the programs that they hold: read as `sieben check` reads them, with open texts in the place of files.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use sieben_ide::editing::Snapshot;
use sieben_lang::encoding;
use sieben_model::problems::Problem;
use sieben_workspace::finding::several::Several;
use sieben_workspace::finding::{Finding, Texts};
use sieben_workspace::project::{Overrides, Project};
use sieben_workspace::settings;

use super::documents::{Document, Documents};
use super::programs::{Program, Tests};
use super::uri::{self, Place};
use crate::failure::Failure;
use crate::files::OpenTexts;
use crate::programs::{Chosen, Folder};
use crate::{files, paths, project};

/// What became of a text that was to be taken in.
enum Taken {
    /// It is in all programs that have it.
    In,
    /// A program has it, and has to be read again.
    NotIn,
    /// No program has it.
    Unknown,
}

/// A folder.
pub(super) struct Root {
    /// As the client spells it.
    pub(super) path: PathBuf,
    /// With links resolved.
    key: PathBuf,
    /// The client has named it; else it is there for an open text.
    named: bool,
    /// It has to be read again.
    stale: bool,
    /// The open texts that its programs were made with.
    seen: OpenTexts,
    programs: Vec<Program>,
    /// What is wrong with it beside its programs.
    findings: Vec<Finding>,
}

impl Root {
    fn new(path: PathBuf, named: bool) -> Self {
        Self { key: uri::known(&path), path, named, stale: true, seen: OpenTexts::new(), programs: Vec::new(), findings: Vec::new() }
    }

    /// Whether a file lies in it.
    fn holds(&self, path: &Path) -> bool {
        path.starts_with(&self.key)
    }

    /// Reads it again.
    fn read(&mut self, documents: &Documents, overrides: Overrides) {
        self.stale = false;
        self.findings.clear();
        let mut open = documents.over_files();
        open.retain(|path, _| path.starts_with(&self.key));
        self.seen = open.clone();
        let read = || read_programs(std::slice::from_ref(&self.path), overrides);
        match files::with_open(open, read) {
            Ok((programs, findings)) => {
                self.programs = programs;
                self.findings = findings;
            }
            Err(failure) => {
                self.programs.clear();
                self.findings.push(Finding::refused(paths::shown(&self.path.join(settings::FILE_NAME)), failure.refusal));
            }
        }
    }

    /// Takes in the open texts as they are now; reads everything again where that does not do.
    fn renew(&mut self, documents: &Documents, overrides: Overrides) {
        let mut open = documents.over_files();
        open.retain(|path, _| path.starts_with(&self.key));
        let closed: Vec<PathBuf> = self.seen.keys().filter(|path| !open.contains_key(*path)).cloned().collect();
        for path in closed {
            let text = self.seen.remove(&path);
            self.stale |= matters(&path) && !text.is_some_and(|text| is_saved(&path, &text));
        }
        for (path, text) in open {
            let before = self.seen.insert(path.clone(), Arc::clone(&text));
            if self.stale || before.as_ref().is_some_and(|before| Arc::ptr_eq(before, &text) || *before == text) {
                continue;
            }
            self.stale = match self.take_in(&path, &text) {
                Taken::In => false,
                Taken::NotIn => true,
                Taken::Unknown => matters(&path) && (before.is_some() || !is_saved(&path, &text)),
            };
        }
        if self.stale {
            self.read(documents, overrides);
        }
    }

    /// Gives an open text to the programs that have it.
    fn take_in(&mut self, path: &Path, text: &str) -> Taken {
        let mut taken = Taken::Unknown;
        for program in &mut self.programs {
            if let Some(file) = program.file(path) {
                if program.replace(file, text).is_none() {
                    return Taken::NotIn;
                }
                taken = Taken::In;
            } else if program.has_test(path) {
                // It is looked at as it is open.
                taken = Taken::In;
            }
        }
        taken
    }

    /// Everything that is wrong, and the texts that it is wrong in.
    fn found(&mut self) -> (Vec<Finding>, Texts) {
        if let ([program], []) = (self.programs.as_mut_slice(), self.findings.as_slice()) {
            return (program.findings().to_vec(), program.project().texts.clone());
        }
        let mut several = Several::default();
        for program in &mut self.programs {
            let own = program.findings().to_vec();
            several.add(&program.name, Vec::new(), &own, &program.project().texts);
        }
        let (findings, texts, _) = several.finish(self.findings.clone());
        (findings, texts)
    }
}

/// The programs of paths, and what is wrong beside them.
fn read_programs(paths: &[PathBuf], overrides: Overrides) -> Result<(Vec<Program>, Vec<Finding>), Failure> {
    let chosen = Chosen::of(paths, None)?;
    let mut programs = Vec::new();
    for program in &chosen.programs {
        let project = project::load(&program.paths, None)?;
        programs.push(Program::new(program.name.clone(), project, overrides, false));
    }
    Ok((programs, chosen.folders.iter().flat_map(Folder::findings).collect()))
}

/// All folders, and the texts that belong to none.
pub(super) struct Folders {
    roots: Vec<Root>,
    /// Programs of one text each.
    alone: BTreeMap<Place, Program>,
    /// How programs are compiled.
    pub(super) overrides: Overrides,
}

impl Folders {
    /// None, with programs that are compiled in this way.
    pub(super) fn new(overrides: Overrides) -> Self {
        Self { roots: Vec::new(), alone: BTreeMap::new(), overrides }
    }

    /// The client works in a folder; its project may begin further up.
    pub(super) fn add(&mut self, path: &Path) {
        let home = home_of(path).unwrap_or_else(|| path.to_path_buf());
        let key = uri::known(&home);
        match self.roots.iter_mut().find(|root| root.key == key) {
            Some(root) => root.named = true,
            None => self.roots.push(Root::new(home, true)),
        }
    }

    /// The client no longer works in a folder.
    pub(super) fn remove(&mut self, path: &Path) {
        let key = uri::known(&home_of(path).unwrap_or_else(|| path.to_path_buf()));
        if let Some(root) = self.roots.iter_mut().find(|root| root.key == key) {
            root.named = false;
        }
    }

    /// Whether a folder has to be read before questions can be answered.
    pub(super) fn has_unread(&self) -> bool {
        self.roots.iter().any(|root| root.stale)
    }

    /// A file was changed, made or removed by another program.
    pub(super) fn changed_outside(&mut self, path: &Path) {
        self.roots.iter_mut().filter(|root| root.holds(path)).for_each(|root| root.stale = true);
    }

    /// Files are read again before the next answer.
    pub(super) fn read_again(&mut self) {
        self.roots.iter_mut().for_each(|root| root.stale = true);
    }

    /// All of it has to be read again.
    pub(super) fn forget(&mut self) {
        self.roots.iter_mut().for_each(|root| {
            root.programs.clear();
            root.stale = true;
        });
        self.alone.clear();
    }

    /// Takes in the open texts as they are now.
    pub(super) fn renew(&mut self, documents: &Documents) {
        self.find_roots(documents);
        for root in &mut self.roots {
            root.renew(documents, self.overrides);
        }
        self.find_inner_roots(documents);
        self.renew_alone(documents);
    }

    /// A project inside of a folder that is open, and that the programs of the folder leave out.
    fn find_inner_roots(&mut self, documents: &Documents) {
        for path in documents.iter().filter_map(|(place, _)| place.path()) {
            let Some(home) = home_of(paths::folder_of(path)) else { continue };
            let key = uri::known(&home);
            if self.roots.iter().any(|root| root.key == key || has(root, path)) {
                continue;
            }
            let mut root = Root::new(home, false);
            root.renew(documents, self.overrides);
            self.roots.push(root);
        }
    }

    /// Each open file has the folder with the `sieben.toml` above it.
    fn find_roots(&mut self, documents: &Documents) {
        let open: Vec<&Path> = documents.iter().filter_map(|(place, _)| place.path()).collect();
        for path in &open {
            if self.roots.iter().any(|root| root.holds(path)) {
                continue;
            }
            if let Some(home) = home_of(paths::folder_of(path)) {
                self.roots.push(Root::new(home, false));
            }
        }
        self.roots.retain(|root| root.named || open.iter().any(|path| root.holds(path)));
    }

    /// Texts that are part of no program are programs by themselves.
    fn renew_alone(&mut self, documents: &Documents) {
        let is_one = |place: &Place, document: &Document| match place {
            Place::Other(_) => false,
            _ if document.is_too_large() => false,
            Place::Untitled(_) => true,
            Place::File(path) => is_source_alone(path, document) && !self.roots.iter().any(|root| has(root, path)),
        };
        let wanted: BTreeSet<Place> =
            documents.iter().filter(|(place, document)| is_one(place, document)).map(|(place, _)| place.clone()).collect();
        self.alone.retain(|place, _| wanted.contains(place));
        for place in wanted {
            let Some(document) = documents.get(&place) else { continue };
            let in_folder = place.path().is_some_and(|path| self.roots.iter().any(|root| root.holds(path)));
            let text = document.text();
            let kept = self.alone.get_mut(&place).is_some_and(|program| {
                let file = program.project().sources.first().map(|source| source.id);
                file.is_some_and(|file| program.replace(file, text).is_some())
            });
            if !kept {
                let mut project = Project::new(None);
                project.add_source(&name_alone(&place, document), text.as_bytes());
                // What a folder leaves out may need what is there: only its syntax is looked at.
                let program = Program::new(String::new(), project, self.overrides, in_folder);
                self.alone.insert(place, program);
            }
        }
    }

    /// Everything that is wrong, by the texts that it is wrong in: a list for each folder and each text that belongs to none.
    pub(super) fn found(&mut self, documents: &Documents, tests: Tests) -> Vec<(Option<Place>, Vec<Finding>, Texts)> {
        let mut all: Vec<(Option<Place>, Vec<Finding>, Texts)> = Vec::new();
        for root in &mut self.roots {
            let (mut findings, texts) = root.found();
            if root.programs.iter().all(|program| program.project().sources.is_empty()) && !root.path.join(settings::FILE_NAME).is_file() {
                // Not every folder that is open has a program.
                findings.retain(|finding| finding.diagnostic.problem != Problem::P6005);
            }
            all.push((None, findings, texts));
            let found = root.programs.iter_mut().flat_map(|program| program.tests(documents, tests));
            all.extend(found.map(|(findings, texts)| (None, findings, texts)));
        }
        for (place, program) in &mut self.alone {
            let findings = program.findings().to_vec();
            all.push((Some(place.clone()), findings, program.project().texts.clone()));
        }
        all
    }

    /// Whether test files are to be looked at again.
    pub(super) fn has_old_tests(&self) -> bool {
        self.roots.iter().flat_map(|root| &root.programs).any(Program::has_old_tests)
    }

    /// The first program that has a text, and which of its sources it is.
    pub(super) fn program_of(&mut self, place: &Place) -> Option<(&mut Program, sieben_model::source::FileId)> {
        if let Some(path) = place.path() {
            let of_roots = self.roots.iter_mut().flat_map(|root| &mut root.programs);
            let found = of_roots.filter_map(|program| program.file(path).map(|file| (program, file))).next();
            if found.is_some() {
                return found;
            }
        }
        let program = self.alone.get_mut(place)?;
        let file = program.project().sources.first()?.id;
        Some((program, file))
    }

    /// The texts of the program that has a text: as a source, a symbol table or a test.
    pub(super) fn snapshot_of(&mut self, place: &Place, documents: &Documents) -> Option<Snapshot> {
        if let Some((program, _)) = self.program_of(place) {
            return Some(program.snapshot(documents));
        }
        let path = place.path()?;
        let is_it = |name: &str| uri::known(Path::new(name)) == path;
        let has_it = |program: &&mut Program| {
            let project = program.project();
            project.texts.documents.iter().any(|(_, document)| is_it(&document.name)) || program.has_test(path)
        };
        self.roots.iter_mut().flat_map(|root| &mut root.programs).find(has_it).map(|program| program.snapshot(documents))
    }

    /// Where the program of a text is run: the folder of its `sieben.toml`, or else the folder that the client has named.
    pub(super) fn home_of(&self, place: &Place) -> Option<PathBuf> {
        let path = place.path()?;
        let root = self.roots.iter().find(|root| root.holds(path))?;
        path.parent().and_then(home_of).or_else(|| Some(root.path.clone()))
    }

    /// The texts of all programs.
    pub(super) fn snapshots(&mut self, documents: &Documents) -> Vec<Snapshot> {
        let all = self.roots.iter_mut().flat_map(|root| &mut root.programs).chain(self.alone.values_mut());
        all.map(|program| program.snapshot(documents)).collect()
    }
}

/// Whether a program of a folder has a file.
fn has(root: &Root, path: &Path) -> bool {
    root.programs.iter().any(|program| program.file(path).is_some() || program.has_test(path))
}

/// Whether a file that is no source of any program may change what the programs are.
fn matters(path: &Path) -> bool {
    let is_settings = path.file_name().is_some_and(|name| name == settings::FILE_NAME);
    is_settings || paths::is_source(path) || paths::is_symbols(path) || paths::is_awlsim_project(path)
}

/// Whether a text is that of a file on the disk.
fn is_saved(path: &Path, text: &str) -> bool {
    files::read_saved(path).is_ok_and(|bytes| encoding::read_source(&bytes).is_ok_and(|decoded| decoded.text == text))
}

/// The folder with a `sieben.toml` that a folder lies in, or is.
fn home_of(folder: &Path) -> Option<PathBuf> {
    folder.ancestors().find(|folder| folder.join(settings::FILE_NAME).is_file()).map(Path::to_path_buf)
}

/// Whether a file is looked at as a source where no program has it.
pub(super) fn is_source_alone(path: &Path, document: &Document) -> bool {
    let is_known =
        matches!(document.language.as_str(), "awl" | "stl" | "scl" | "st" | "lad" | "fbd" | "s7db" | "s7udt" | "structured-text");
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
    let is_other = paths::is_symbols(path) || paths::is_scenario(path) || paths::is_awlsim_project(path) || paths::is_test(path);
    !is_other && (paths::is_source(path) || matches!(ending.as_str(), "db" | "udt" | "exp") || is_known && ending != "toml")
}

/// The name that a text has as a program by itself: its ending tells the language.
pub(super) fn name_alone(place: &Place, document: &Document) -> PathBuf {
    match place {
        Place::File(path) => path.clone(),
        Place::Untitled(_) | Place::Other(_) => {
            let ending = match document.language.as_str() {
                "scl" => ".scl",
                "st" | "structured-text" | "61131-3-st" => ".st",
                "lad" => ".lad",
                "fbd" => ".fbd",
                "s7db" => ".db",
                "s7udt" => ".udt",
                "awl" | "stl" => ".awl",
                _ => "",
            };
            PathBuf::from(format!("untitled{ending}"))
        }
    }
}
