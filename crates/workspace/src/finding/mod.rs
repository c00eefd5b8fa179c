//! What is wrong with a project: diagnostics with what their places belong to.

mod help;
mod json;
pub mod lines;
pub mod several;

use sieben_lang::encoding::Encoding;
use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::language::{Language, Text, pick};
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Sources, Span};

use crate::refusal::Refusal;
pub use help::{german_help, help_in, help_of, said_in};
pub use json::to_json;

/// Where the span of a finding points into.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Origin {
    /// A whole file, by the path that was given.
    File(String),
    /// A file of the project that is no program: `sieben.toml` or a symbol table.
    Document,
    /// A source of the program.
    Program,
}

/// A diagnostic with what its span belongs to.
#[derive(Clone, Debug)]
pub struct Finding {
    /// What is wrong; for [`Origin::File`] the span means nothing.
    pub diagnostic: Diagnostic,
    /// What the span points into.
    pub origin: Origin,
    /// What STEP 7 refuses is an error, too.
    pub strict: bool,
    /// It is in a test file, without which the program runs: it is a warning.
    pub of_test: bool,
    /// The programs that have it, where there are several.
    pub programs: Vec<String>,
    /// In which of the programs that share the file, if not in all of them.
    pub note: Option<String>,
}

impl Finding {
    /// A finding about a whole file.
    pub fn file(problem: Problem, path: impl Into<String>, message: impl Into<String>) -> Self {
        Self::of(Diagnostic::new(problem, Span::default(), message), Origin::File(path.into()))
    }
    /// Something about a file, or about none if the path is empty, that is refused.
    pub fn refused(path: impl Into<String>, refusal: Refusal) -> Self {
        let mut finding = Self::file(refusal.problem, path, refusal.message);
        finding.diagnostic.help = refusal.help;
        finding
    }
    /// A file with bytes that mean nothing in its encoding.
    pub fn lost_bytes(path: &str, encoding: Encoding) -> Self {
        Self::file(Problem::P1102, path, format!("`{path}` holds bytes that mean nothing in {}", encoding.name()))
    }
    /// A link that leaves the folder, and is not followed.
    pub fn outside(path: &str) -> Self {
        Self::file(Problem::P6010, path, format!("`{path}` is a link to a file outside the project folder"))
    }
    /// A finding in a file that is no program.
    pub fn document(diagnostic: Diagnostic) -> Self {
        Self::of(diagnostic, Origin::Document)
    }
    /// A finding in a source of the program.
    pub fn program(diagnostic: Diagnostic) -> Self {
        Self::of(diagnostic, Origin::Program)
    }
    fn of(diagnostic: Diagnostic, origin: Origin) -> Self {
        Self { diagnostic, origin, programs: Vec::new(), note: None, strict: false, of_test: false }
    }
    /// The same in a test file.
    #[must_use]
    pub fn in_test(self) -> Self {
        Self { of_test: true, ..self }
    }
    /// What is wrong, and in which programs if that is not clear from the file.
    pub fn message(&self) -> String {
        let message = &self.diagnostic.message;
        self.note.as_ref().map_or_else(|| message.clone(), |note| format!("{message} ({note})"))
    }
    /// Error or warning.
    pub fn severity(&self) -> Severity {
        match self.diagnostic.problem {
            _ if self.of_test && !self.strict => Severity::Warning,
            problem if self.strict && problem.is_refused() => Severity::Error,
            problem => problem.severity(),
        }
    }
    fn key(&self) -> (&Origin, FileId, u32, u32, Problem) {
        let span = self.diagnostic.span;
        (&self.origin, span.file, span.start, span.end, self.diagnostic.problem)
    }
}

/// The texts that findings point into.
#[derive(Clone, Debug, Default)]
pub struct Texts {
    /// Sources of the program.
    pub program: Sources,
    /// `sieben.toml` and symbol tables.
    pub documents: Sources,
}

impl Texts {
    /// The texts that findings of this origin point into; none for whole files.
    pub fn of(&self, origin: &Origin) -> Option<&Sources> {
        match origin {
            Origin::File(_) => None,
            Origin::Document => Some(&self.documents),
            Origin::Program => Some(&self.program),
        }
    }
}

/// Whether any of them keeps the program from running.
pub fn has_errors(findings: &[Finding]) -> bool {
    findings.iter().any(|finding| finding.severity() == Severity::Error)
}

/// Puts findings into the order of files and places and drops repetitions.
pub fn sort(findings: &mut Vec<Finding>) {
    findings.sort_by(|a, b| a.key().cmp(&b.key()));
    findings.dedup_by(|a, b| a.key() == b.key() && a.diagnostic.message == b.diagnostic.message);
}

/// `2 errors, 1 warning`, or `no errors`.
pub fn tally(findings: &[Finding], language: Language) -> String {
    let errors = findings.iter().filter(|finding| finding.severity() == Severity::Error).count();
    let warnings = findings.len() - errors;
    let counted = |count: usize, [one, several]: [Text; 2]| match count {
        1 => format!("1 {}", pick(language, one)),
        count => format!("{count} {}", pick(language, several)),
    };
    match (errors, warnings) {
        (0, 0) => pick(language, ["no errors", "keine Fehler"]).to_owned(),
        (0, warnings) => counted(warnings, WARNINGS),
        (errors, 0) => counted(errors, ERRORS),
        (errors, warnings) => format!("{}, {}", counted(errors, ERRORS), counted(warnings, WARNINGS)),
    }
}

/// One of them, and several.
const ERRORS: [Text; 2] = [["error", "Fehler"], ["errors", "Fehler"]];
const WARNINGS: [Text; 2] = [["warning", "Warnung"], ["warnings", "Warnungen"]];

/// A place in a text that is certainly on a character boundary.
pub fn clamp(text: &str, at: u32) -> usize {
    let mut at = (at as usize).min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}
