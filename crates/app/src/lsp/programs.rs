//! One program that stays open: its sources with what is wrong with them, renewed with each change.

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

use sieben_ide::editing::{Role, Snapshot, Text};
use sieben_lang::language::role;
use sieben_lang::{LostResults, encoding};
use sieben_model::source::FileId;
use sieben_workspace::finding::{self, Finding, Texts};
use sieben_workspace::project::open::{Dialects, Open};
use sieben_workspace::project::{Build, Overrides, Project};

use super::documents::Documents;
use super::uri::{self, Place};
use crate::{files, paths};

/// Bytes of a program that is tried in other dialects with each change; a larger one when it is read.
const TRIED_BYTES_MAX: usize = 64 << 10;

/// Which test files are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tests {
    /// All whose text or program is another one than it was: that may take long.
    All,
    /// Open ones whose text is another one: what was found in the others stands.
    Typed,
}

/// A program.
pub(super) struct Program {
    /// What reports call it, where there are several.
    pub(super) name: String,
    open: Open,
    /// Its sources by their paths.
    files: BTreeMap<PathBuf, FileId>,
    findings: Option<Vec<Finding>>,
    build: Option<Rc<Build>>,
    snapshot: Option<Snapshot>,
    /// What is wrong with its test files, by their paths, with the texts that they had.
    tests: BTreeMap<PathBuf, (Arc<str>, Vec<Finding>, Texts)>,
    /// The program changed since they were looked at, or they were not yet.
    old_tests: bool,
    /// Nothing was changed since it was read.
    is_new: bool,
    /// What each source is for, where a folder without a `sieben.toml` was looked through; filled as sources change.
    roles: Option<BTreeMap<FileId, role::Role>>,
    overrides: Overrides,
}

impl Program {
    /// A program that was read.
    pub(super) fn new(name: String, project: Project, overrides: Overrides, syntax_only: bool) -> Self {
        let files = project.sources.iter().filter(|source| !source.embedded).map(|source| (uri::known(&source.path), source.id)).collect();
        let roles = project.home.is_none().then(BTreeMap::new);
        Self {
            name,
            open: Open::new(project, overrides, syntax_only),
            files,
            findings: None,
            build: None,
            snapshot: None,
            tests: BTreeMap::new(),
            old_tests: true,
            is_new: true,
            roles,
            overrides,
        }
    }

    /// Its texts and settings.
    pub(super) fn project(&self) -> &Project {
        self.open.project()
    }

    /// One of its sources.
    pub(super) fn file(&self, path: &Path) -> Option<FileId> {
        self.files.get(path).copied()
    }

    /// Gives a source another text. Without an answer the program has to be read again.
    #[must_use]
    pub(super) fn replace(&mut self, file: FileId, text: &str) -> Option<()> {
        let source = self.open.project().texts.program.file(file);
        if source.text == text {
            return Some(());
        }
        // Which files make a program depends on what each is for.
        let mut is_same = role::holds_tests(&source.text) == role::holds_tests(text);
        if let Some(roles) = &mut self.roles {
            let role = |text: &str| role::Role::of(&source.name, text, None);
            let before = roles.remove(&file).unwrap_or_else(|| role(&source.text));
            let after = role(text);
            is_same &= before == after;
            roles.insert(file, after);
        }
        self.open.replace(file, text).filter(|()| is_same)?;
        (self.findings, self.build, self.is_new) = (None, None, false);
        self.old_tests |= self.bytes() <= TRIED_BYTES_MAX;
        Some(())
    }

    fn bytes(&self) -> usize {
        self.project().texts.program.iter().map(|(_, source)| source.text.len()).sum()
    }

    /// Everything that is wrong with it.
    pub(super) fn findings(&mut self) -> &[Finding] {
        let Self { open, is_new, findings, .. } = self;
        findings.get_or_insert_with(|| {
            let bytes = || open.project().texts.program.iter().map(|(_, source)| source.text.len()).sum::<usize>();
            let others = if *is_new || bytes() <= TRIED_BYTES_MAX { Dialects::Tried } else { Dialects::Judged };
            open.findings(others)
        })
    }

    /// Whether a file is one of its tests.
    pub(super) fn has_test(&self, path: &Path) -> bool {
        self.project().tests.iter().any(|test| uri::known(test) == path)
    }

    /// Whether there are test files that were not looked at since the program changed.
    pub(super) fn has_old_tests(&self) -> bool {
        self.old_tests && !self.project().tests.is_empty()
    }

    /// Everything that is wrong with its test files, and the texts that it is wrong in. In a large program a test file is looked at again
    /// when it changes, in a small one when the program does, too.
    pub(super) fn tests(&mut self, documents: &Documents, which: Tests) -> Vec<(Vec<Finding>, Texts)> {
        if finding::has_errors(self.findings()) {
            return Vec::new();
        }
        let mut known = std::mem::take(&mut self.tests);
        if which == Tests::All && std::mem::take(&mut self.old_tests) {
            known.clear();
        }
        let project = self.open.project();
        for test in project.tests.iter().filter(|test| !paths::is_scenario(test)) {
            let open = documents.get(&Place::File(uri::known(test))).map(|document| Arc::clone(document.text()));
            if which == Tests::Typed && open.is_none() {
                self.tests.extend(known.remove_entry(test));
                continue;
            }
            let saved = || Some(Arc::from(encoding::read_source(&files::read_saved(test).ok()?).ok()?.text));
            let Some(text) = open.or_else(saved) else { continue };
            let kept = known.remove(test).filter(|(before, ..)| *before == text);
            let found = kept.unwrap_or_else(|| {
                let mut texts = Texts::default();
                let is_test = role::is_test(&paths::shown(test), &text);
                let findings = match is_test {
                    true => project.findings_of_test(test, text.as_bytes(), self.overrides, &mut texts),
                    false => Vec::new(),
                };
                (Arc::clone(&text), findings, texts)
            });
            self.tests.insert(test.clone(), found);
        }
        self.tests.values().map(|(_, findings, texts)| (findings.clone(), texts.clone())).collect()
    }

    /// Its texts with the names in them: sources, symbol tables, test files.
    pub(super) fn snapshot(&mut self, documents: &Documents) -> Snapshot {
        let project = self.open.project();
        let mut texts: Vec<Text> = Vec::new();
        let before = self.snapshot.as_ref().map_or(&[][..], Snapshot::texts);
        let known: HashMap<&str, &Arc<str>> = before.iter().map(|text| (text.name.as_str(), &text.text)).collect();
        let lossy: Vec<&Place> = documents.iter().filter(|(_, document)| document.is_lossy).map(|(place, _)| place).collect();
        let mut add = |name: &str, text: &str, role: Role| {
            let known = known.get(name).filter(|known| ****known == *text);
            let text = known.map_or_else(|| Arc::from(text), |known| Arc::clone(known));
            let is_lossy = !lossy.is_empty() && lossy.contains(&&Place::File(uri::known(Path::new(name))));
            let fixed = is_lossy.then(|| format!("`{name}` is open with the wrong encoding: reopen it with its own, and try again"));
            texts.push(Text { name: name.to_owned(), text, role, fixed });
        };
        for (_, source) in project.texts.program.iter() {
            add(&source.name, &source.text, Role::Source);
        }
        for (_, document) in project.texts.documents.iter() {
            let role = if paths::is_symbols(Path::new(&document.name)) { Role::Symbols } else { Role::Other };
            add(&document.name, &document.text, role);
        }
        for test in project.tests.iter().filter(|test| !paths::is_scenario(test)) {
            let open = documents.get(&Place::File(uri::known(test))).map(|document| document.text().to_string());
            let text = open.or_else(|| Some(encoding::read_source(&files::read(test).ok()?).ok()?.text));
            if let Some(text) = text {
                add(&paths::shown(test), &text, Role::Source);
            }
        }
        let options = self.open.options();
        let snapshot = match &self.snapshot {
            Some(before) if before.texts() == texts => before.clone(),
            Some(before) => before.changed(texts, options),
            None => Snapshot::new(texts, options),
        };
        self.snapshot = Some(snapshot.clone());
        snapshot
    }

    /// It with its code, as far as it compiles.
    pub(super) fn build(&mut self) -> Rc<Build> {
        let Self { open, build, .. } = self;
        Rc::clone(build.get_or_insert_with(|| Rc::new(open.build())))
    }
}

/// How programs are compiled unless the client says something else: as `sieben check` does.
pub(super) fn usual() -> Overrides {
    Overrides { tells_lost: LostResults::All, ..Overrides::default() }
}
