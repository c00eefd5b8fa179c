//! The file of a campaign or of a fleet, and the files around it.

use std::path::{Path, PathBuf};

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::FileId;
use sieben_workspace::campaign::{Failed, Files};
use sieben_workspace::finding::{self, Finding, Texts};
use sieben_workspace::project::Project;
use sieben_workspace::refusal::Refusal;

use crate::arguments::ProgramArguments;
use crate::failure::{Exit, Failure};
use crate::{files, project, report};

/// The file of a campaign or of a fleet.
pub(super) struct SpecFile {
    texts: Texts,
    text: String,
    file: FileId,
    stem: String,
    json: bool,
}

impl SpecFile {
    /// Reads it; if it is no text this is the problem.
    ///
    /// # Errors
    /// It cannot be read.
    pub(super) fn read(path: &Path, no_text: Problem, json: bool) -> Result<Self, Failure> {
        let bytes = files::read(path)?;
        let text = String::from_utf8(bytes).map_err(|_| Failure::usage(no_text, format!("`{}` is not UTF-8 text", path.display())))?;
        let text = text.strip_prefix('\u{FEFF}').unwrap_or(&text).to_owned();
        let mut texts = Texts::default();
        let file = texts.documents.add(path.display().to_string(), &text);
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let stem = [".campaign", ".fleet"].iter().find_map(|ending| stem.strip_suffix(ending)).unwrap_or(&stem).to_owned();
        Ok(Self { texts, text, file, stem, json })
    }

    /// Its text, without a byte order mark.
    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// What diagnostics of it call it.
    pub(super) fn file(&self) -> FileId {
        self.file
    }

    /// What it is called where it does not say so itself.
    pub(super) fn stem(&self) -> String {
        self.stem.clone()
    }

    /// Prints what there is to say about it.
    pub(super) fn tell(&self, diagnostics: Vec<Diagnostic>) {
        if diagnostics.is_empty() {
            return;
        }
        let mut findings: Vec<Finding> = diagnostics.into_iter().map(Finding::document).collect();
        finding::sort(&mut findings);
        report::print(&findings, &self.texts, self.json);
    }

    /// Prints why it cannot be opened, after what was said of it before.
    ///
    /// # Errors
    /// Something around it is refused.
    pub(super) fn tell_failed(&self, mut before: Vec<Diagnostic>, failed: Failed) -> Result<Exit, Failure> {
        match failed {
            Failed::Spec(wrong) => {
                before.extend(wrong);
                self.tell(before);
            }
            Failed::Program(build) => report::print(&build.findings, &build.project.texts, self.json),
            Failed::Refused(refusal) => return Err(refusal.into()),
        }
        Ok(Exit::DoesNotCompile)
    }
}

/// The files around that of a campaign or of a fleet.
pub(super) struct Around<'a> {
    /// The folder that its paths count from.
    pub(super) folder: PathBuf,
    program: &'a ProgramArguments,
}

impl<'a> Around<'a> {
    /// Those around this file.
    pub(super) fn of(path: &Path, program: &'a ProgramArguments) -> Self {
        Self { folder: path.parent().map(Path::to_path_buf).unwrap_or_default(), program }
    }
}

impl Files for Around<'_> {
    fn project(&self, path: &str) -> Result<Project, Refusal> {
        let here = self.folder.as_os_str().is_empty();
        let at = match path {
            "." if here => PathBuf::from("."),
            "." => self.folder.clone(),
            path => self.folder.join(path),
        };
        project::load(&[at], self.program.encoding()).map_err(|failure| failure.refusal)
    }

    fn text(&self, path: &str) -> Result<String, Refusal> {
        let bytes = files::read(&self.folder.join(path)).map_err(|failure| failure.refusal)?;
        String::from_utf8(bytes).map_err(|_| Refusal::new(Problem::P7163, format!("`{path}` is not UTF-8 text")))
    }
}
