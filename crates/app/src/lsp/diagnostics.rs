//! What is wrong with the texts, as clients are told of it.

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use sieben_lang::encoding::MAX_SOURCE_BYTES;
use sieben_model::diagnostic::Severity;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Sources, Span};
use sieben_sim::scenario::Scenario;
use sieben_workspace::finding::{Finding, Origin, Texts, help_of};

use super::documents::{Document, Documents};
use super::positions::{Columns, Lines};
use super::uri::{self, Place};
use crate::paths;

/// What clients call the origin of a diagnostic.
const SOURCE: &str = "sieben";
/// Diagnostics of one file at most: after the first thousand the rest is mostly their consequence.
pub(super) const OF_FILE_MAX: usize = 1_000;

/// The address of the page of a problem, if the client does not say where they are: a text of our own.
pub(super) const PAGES: &str = "sieben:problems/";

/// How diagnostics are told.
#[derive(Clone, Debug)]
pub(super) struct Telling {
    /// How the client counts columns.
    pub(super) columns: Columns,
    /// What the address of the page of a problem begins with.
    pub(super) pages: String,
    /// Whether the client shows related places.
    pub(super) related: bool,
}

/// The diagnostics of each text.
pub(super) type Told = BTreeMap<Place, Vec<Value>>;

/// Collects the diagnostics of all texts.
pub(super) struct Collecting<'a> {
    telling: &'a Telling,
    documents: &'a Documents,
    told: Told,
    /// What belongs to no file that there is.
    pub(super) homeless: Vec<String>,
}

impl<'a> Collecting<'a> {
    /// With what is too large, and open scenarios.
    pub(super) fn new(telling: &'a Telling, documents: &'a Documents) -> Self {
        let mut told = Told::new();
        for (place, _) in documents.iter().filter(|(_, document)| document.is_too_large()) {
            let message = format!("this text is larger than {} MiB and is not looked at", MAX_SOURCE_BYTES >> 20);
            told.entry(place.clone()).or_default().push(whole(Problem::P1104, Severity::Error, &message, telling));
        }
        let mut collecting = Self { telling, documents, told, homeless: Vec::new() };
        let is_scenario = |place: &Place| place.path().is_some_and(paths::is_scenario);
        for (place, document) in documents.iter().filter(|(place, document)| is_scenario(place) && !document.is_too_large()) {
            collecting.scenario(place, document);
        }
        collecting
    }

    /// Adds the lines of an open scenario that are not understood.
    fn scenario(&mut self, place: &Place, document: &Document) {
        for error in Scenario::parse(document.text()).err().into_iter().flatten() {
            let (start, end) = document.lines().bytes(document.text(), error.line.saturating_sub(1));
            let mut told = whole(Problem::P6260, Severity::Error, &error.message, self.telling);
            told["range"] = json!(document.lines().range(document.text(), start, end, self.telling.columns));
            self.push(place.clone(), told);
        }
    }

    /// Adds what is wrong with the texts of a folder, or with one text that belongs to none.
    pub(super) fn add(&mut self, alone: Option<&Place>, findings: &[Finding], texts: &Texts) {
        let mut lines: HashMap<(bool, FileId), (Place, Lines)> = HashMap::new();
        for finding in findings {
            let sources = match (&finding.origin, texts.of(&finding.origin)) {
                (Origin::File(path), _) => {
                    self.of_file(alone, path, finding);
                    continue;
                }
                (_, None) => continue,
                (_, Some(sources)) => sources,
            };
            let file = finding.diagnostic.span.file;
            let Some(source) = text_of(sources, file) else { continue };
            let key = (finding.origin == Origin::Program, file);
            let (place, lines) = lines.entry(key).or_insert_with(|| (self.place(alone, &source.name), Lines::of(&source.text)));
            let place = place.clone();
            let told = told(finding, sources, lines, self.telling, &|name| self.uri(&self.place(alone, name)));
            self.push(place, told);
        }
    }

    /// The place that a name of a text stands for.
    fn place(&self, alone: Option<&Place>, name: &str) -> Place {
        match alone {
            Some(place) => place.clone(),
            None => {
                let path = PathBuf::from(name);
                // A source inside of another file is shown at its beginning.
                match name.rsplit_once(" (").filter(|_| !path.exists()) {
                    Some((outer, _)) if Path::new(outer).is_file() => Place::File(uri::known(Path::new(outer))),
                    _ => Place::File(uri::known(&path)),
                }
            }
        }
    }

    /// The URI of a place: as the client spells it, if it has it open.
    fn uri(&self, place: &Place) -> String {
        uri_of(place, self.documents)
    }

    /// What is wrong with a whole file.
    fn of_file(&mut self, alone: Option<&Place>, path: &str, finding: &Finding) {
        let place = match alone {
            Some(place) => Some(place.clone()),
            None => Some(self.place(None, path)).filter(|place| {
                let is_there = place.path().is_some_and(Path::exists) && !path.is_empty();
                is_there || self.documents.get(place).is_some()
            }),
        };
        let message = sentence(finding);
        match place {
            Some(place) => {
                let told = whole(finding.diagnostic.problem, finding.severity(), &message, self.telling);
                self.push(place, told);
            }
            None => self.homeless.push(format!("[{}] {message}", finding.diagnostic.problem.code())),
        }
    }

    fn push(&mut self, place: Place, told: Value) {
        let list = self.told.entry(place).or_default();
        // Folders that a client has open may lie in each other.
        if list.len() < OF_FILE_MAX && !list.contains(&told) {
            list.push(told);
        }
    }

    /// All of them.
    pub(super) fn finish(self) -> (Told, Vec<String>) {
        (self.told, self.homeless)
    }
}

/// The URI of a place: as the client spells it, if it has it open.
pub(super) fn uri_of(place: &Place, documents: &Documents) -> String {
    match (documents.get(place), place) {
        (Some(Document { uri, .. }), _) => uri.clone(),
        (None, Place::File(path)) => uri::of_path(path),
        (None, Place::Untitled(uri) | Place::Other(uri)) => uri.clone(),
    }
}

fn text_of(sources: &Sources, file: FileId) -> Option<&sieben_model::source::SourceFile> {
    sources.iter().find(|(id, _)| *id == file).map(|(_, source)| source)
}

/// What is wrong, and what to do.
fn sentence(finding: &Finding) -> String {
    match help_of(&finding.diagnostic) {
        Some(help) => format!("{}\n{help}", finding.message()),
        None => finding.message(),
    }
}

fn severity(severity: Severity) -> u32 {
    match severity {
        Severity::Error => 1,
        Severity::Warning => 2,
    }
}

/// A diagnostic of a whole text, at its beginning.
fn whole(problem: Problem, how_bad: Severity, message: &str, telling: &Telling) -> Value {
    json!({
        "range": { "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } },
        "severity": severity(how_bad), "code": problem.code(), "source": SOURCE, "message": message,
        "codeDescription": { "href": format!("{}{}", telling.pages, problem.code()) },
    })
}

/// A diagnostic with its place.
fn told(finding: &Finding, sources: &Sources, lines: &Lines, telling: &Telling, uri: &dyn Fn(&str) -> String) -> Value {
    let diagnostic = &finding.diagnostic;
    let mut told = whole(diagnostic.problem, finding.severity(), &sentence(finding), telling);
    let range = |span: Span, lines: &Lines| {
        let text = text_of(sources, span.file).map_or("", |source| source.text.as_str());
        json!(lines.range(text, span.start as usize, span.end as usize, telling.columns))
    };
    told["range"] = range(diagnostic.span, lines);
    if telling.related && !diagnostic.related.is_empty() {
        let related = diagnostic.related.iter().filter_map(|(span, word)| {
            let source = text_of(sources, span.file)?;
            let range = range(*span, &Lines::of(&source.text));
            Some(json!({ "location": { "uri": uri(&source.name), "range": range }, "message": word }))
        });
        told["relatedInformation"] = related.collect();
    }
    told
}
