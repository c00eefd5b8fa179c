//! Diagnostics for people and for programs: the edge where places become lines and columns.

pub(crate) mod lines;
pub(crate) mod several;

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;

use ariadne::{Cache, CharSet, Color, Config, IndexType, Label, LabelAttach, Report, ReportKind, Source};
use serde_json::{Value, json};
use sieben_lang::encoding::Encoding;
use sieben_model::diagnostic::{Certainty, Diagnostic, Severity};
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, SourceFile, Sources, Span};
use sieben_model::visible::{self, visible};

use sieben_workspace::refusal::capitalized;

use crate::failure::Failure;
use crate::output;

/// Most diagnostics shown on a terminal: behind the first hundred the rest is mostly their consequence.
const SHOWN_MAX: usize = 100;
/// Longest line that is drawn, in bytes: a binary or minified file may be one line of megabytes.
const LINE_MAX: usize = 2_000;

/// Where the span of a finding points into.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Origin {
    /// A whole file, by the path that was given.
    File(String),
    /// A file of the project that is no program: `sieben.toml` or a symbol table.
    Document,
    /// A source of the program.
    Program,
}

/// A diagnostic with what its span belongs to.
#[derive(Clone, Debug)]
pub(crate) struct Finding {
    /// What is wrong; for [`Origin::File`] the span means nothing.
    pub(crate) diagnostic: Diagnostic,
    /// What the span points into.
    pub(crate) origin: Origin,
    /// What STEP 7 refuses is an error, too.
    pub(crate) strict: bool,
    /// The programs that have it, where there are several.
    pub(crate) programs: Vec<String>,
    /// In which of the programs that share the file, if not in all of them.
    pub(crate) note: Option<String>,
}

impl Finding {
    /// A finding about a whole file.
    pub(crate) fn file(problem: Problem, path: impl Into<String>, message: impl Into<String>) -> Self {
        Self::of(Diagnostic::new(problem, Span::default(), message), Origin::File(path.into()))
    }
    /// A file with bytes that mean nothing in its encoding.
    pub(crate) fn lost_bytes(path: &str, encoding: Encoding) -> Self {
        Self::file(Problem::P1102, path, format!("`{path}` holds bytes that mean nothing in {}", encoding.name()))
    }
    /// A link that leaves the folder, and is not followed.
    pub(crate) fn outside(path: &str) -> Self {
        Self::file(Problem::P6010, path, format!("`{path}` is a link to a file outside the project folder"))
    }
    /// A finding in a file that is no program.
    pub(crate) fn document(diagnostic: Diagnostic) -> Self {
        Self::of(diagnostic, Origin::Document)
    }
    /// A finding in a source of the program.
    pub(crate) fn program(diagnostic: Diagnostic) -> Self {
        Self::of(diagnostic, Origin::Program)
    }
    fn of(diagnostic: Diagnostic, origin: Origin) -> Self {
        Self { diagnostic, origin, programs: Vec::new(), note: None, strict: false }
    }
    /// What is wrong, and in which programs if that is not clear from the file.
    pub(crate) fn message(&self) -> String {
        let message = &self.diagnostic.message;
        self.note.as_ref().map_or_else(|| message.clone(), |note| format!("{message} ({note})"))
    }
    /// Error or warning.
    pub(crate) fn severity(&self) -> Severity {
        match self.diagnostic.problem {
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
pub(crate) struct Texts {
    /// Sources of the program.
    pub(crate) program: Sources,
    /// `sieben.toml` and symbol tables.
    pub(crate) documents: Sources,
}

impl Texts {
    fn get(&self, id: TextId) -> &SourceFile {
        match id.shelf {
            Shelf::Documents => self.documents.file(id.file),
            Shelf::Program => self.program.file(id.file),
        }
    }
    fn of(&self, origin: &Origin) -> Option<&Sources> {
        match origin {
            Origin::File(_) => None,
            Origin::Document => Some(&self.documents),
            Origin::Program => Some(&self.program),
        }
    }
}

/// Whether any of them keeps the program from running.
pub(crate) fn has_errors(findings: &[Finding]) -> bool {
    findings.iter().any(|finding| finding.severity() == Severity::Error)
}

/// Puts findings into the order of files and places and drops repetitions.
pub(crate) fn sort(findings: &mut Vec<Finding>) {
    findings.sort_by(|a, b| a.key().cmp(&b.key()));
    findings.dedup_by(|a, b| a.key() == b.key() && a.diagnostic.message == b.diagnostic.message);
}

/// Prints findings where messages go.
pub(crate) fn print(findings: &[Finding], texts: &Texts, json: bool) {
    match json {
        true => output::message_json(&to_json(findings, texts)),
        false => output::styled(&render(findings, texts, output::colour())),
    }
}

/// Findings as people read them, with a count at the end; empty if there are none.
pub(crate) fn render(findings: &[Finding], texts: &Texts, colour: bool) -> String {
    let mut text = pieces(findings, texts, colour).concat();
    if findings.len() > SHOWN_MAX {
        text.push_str(&format!("… and {} more; `--json` lists all of them.\n", findings.len() - SHOWN_MAX));
    }
    text.push_str(&count(findings));
    text
}

/// Findings as people read them, each for itself, and their count.
pub(crate) fn parts(findings: &[Finding], texts: &Texts) -> Vec<String> {
    let mut parts = pieces(findings, texts, false);
    parts.push(count(findings));
    parts
}

/// The first findings as people read them, each for itself.
pub(crate) fn pieces(findings: &[Finding], texts: &Texts, colour: bool) -> Vec<String> {
    let mut cache = TextCache { texts, sources: BTreeMap::new() };
    let mut piece = |finding: &Finding| {
        let mut out = Vec::new();
        render_one(finding, &mut cache, colour, &mut out);
        // Ariadne pads its lines; spaces at the end of a line only disturb whoever copies it.
        String::from_utf8_lossy(&out).lines().flat_map(|line| [line.trim_end(), "\n"]).collect()
    };
    findings.iter().take(SHOWN_MAX).map(&mut piece).collect()
}

/// `2 errors, 1 warning. …`, with how to learn more; empty if there are no findings.
fn count(findings: &[Finding]) -> String {
    let Some(first) = findings.iter().find(|finding| finding.severity() == Severity::Error).or(findings.first()) else {
        return String::new();
    };
    format!("{}. `sieben explain {}` says more.\n", tally(findings), first.diagnostic.problem.code())
}

/// `2 errors, 1 warning`, or `no errors`.
pub(crate) fn tally(findings: &[Finding]) -> String {
    let errors = findings.iter().filter(|finding| finding.severity() == Severity::Error).count();
    let warnings = findings.len() - errors;
    let plural = |count: usize, word: &str| match count {
        1 => format!("1 {word}"),
        count => format!("{count} {word}s"),
    };
    match (errors, warnings) {
        (0, 0) => "no errors".to_owned(),
        (0, warnings) => plural(warnings, "warning"),
        (errors, 0) => plural(errors, "error"),
        (errors, warnings) => format!("{}, {}", plural(errors, "error"), plural(warnings, "warning")),
    }
}

fn render_one(finding: &Finding, cache: &mut TextCache<'_>, colour: bool, out: &mut Vec<u8>) {
    let diagnostic = &finding.diagnostic;
    let (kind, shade) = match finding.severity() {
        Severity::Error => (ReportKind::Error, Color::Red),
        Severity::Warning => (ReportKind::Warning, Color::Yellow),
    };
    let help = help_of(diagnostic);
    let place = Place::of(&finding.origin, diagnostic.span, cache.texts);
    let drawable = place.as_ref().is_some_and(|place| place.is_drawable(cache.texts));
    let Some(place) = place.filter(|_| drawable) else {
        render_plain(finding, cache.texts, colour, out);
        return;
    };
    let config = Config::new()
        .with_index_type(IndexType::Byte)
        .with_color(colour)
        .with_char_set(CharSet::Unicode)
        .with_label_attach(LabelAttach::Start)
        .with_compact(false);
    let mut report = Report::build(kind, cache.shown(&place))
        .with_config(config)
        .with_code(diagnostic.problem.code())
        .with_message(visible(&finding.message()));
    if let Some(help) = help {
        report = report.with_help(visible(&help));
    }
    let title = diagnostic.fix.as_ref().map_or("here", |fix| fix.title.as_str());
    let mut labels = vec![(place, shade, title)];
    labels.extend(diagnostic.related.iter().filter_map(|(span, word)| {
        let place = Place::of(&finding.origin, *span, cache.texts).filter(|place| place.is_drawable(cache.texts))?;
        Some((place, Color::Fixed(147), word.as_str()))
    }));
    // Lines of one text in their order are drawn as one piece.
    labels.sort_by_key(|(place, ..)| place.start);
    for (place, shade, word) in labels {
        report = report.with_label(Label::new(cache.shown(&place)).with_color(shade).with_message(visible(word)));
    }
    let start = out.len();
    if report.finish().write(&mut *cache, &mut *out).is_err() {
        out.truncate(start);
        render_plain(finding, cache.texts, colour, out);
    }
}

/// Without the source lines: for whole files and for lines too long to draw.
fn render_plain(finding: &Finding, texts: &Texts, colour: bool, out: &mut Vec<u8>) {
    let diagnostic = &finding.diagnostic;
    let (word, shade) = match finding.severity() {
        Severity::Error => ("Error", "\x1b[31m"),
        Severity::Warning => ("Warning", "\x1b[33m"),
    };
    let (shade, plain) = if colour { (shade, "\x1b[0m") } else { ("", "") };
    let place = match &finding.origin {
        Origin::File(_) => String::new(),
        origin => texts.of(origin).map_or_else(String::new, |sources| {
            let (line, column) = sources.line_column(diagnostic.span);
            format!(" ({}:{line}:{column})", visible(&sources.file(diagnostic.span.file).name))
        }),
    };
    let code = diagnostic.problem.code();
    out.extend_from_slice(format!("{shade}[{code}] {word}:{plain} {}{place}\n", visible(&finding.message())).as_bytes());
    if let Some(help) = help_of(diagnostic) {
        out.extend_from_slice(format!("  Help: {}\n", visible(&help)).as_bytes());
    }
}

/// What to do, if that is more than the message and the title of the fix say already.
fn help_of(diagnostic: &Diagnostic) -> Option<String> {
    let help = diagnostic.help.as_deref().unwrap_or(diagnostic.problem.help());
    let said = diagnostic.fix.as_ref().map_or(diagnostic.message.clone(), |fix| format!("{} {}", diagnostic.message, fix.title));
    let refers = diagnostic.fix.is_some() && help.ends_with("the message names.");
    (!refers && !repeats(help, &said)).then(|| capitalized(help))
}

/// Words of a help that tell nothing by themselves.
const EMPTY_WORDS: [&str; 29] = [
    "write", "use", "give", "name", "names", "named", "what", "that", "this", "the", "a", "an", "it", "its", "is", "are", "of", "or",
    "and", "in", "to", "with", "for", "here", "message", "instead", "did", "you", "mean",
];

/// Whether a help says nothing that was not said already: each of its words that tell something was.
fn repeats(help: &str, said: &str) -> bool {
    let words = |text: &str| -> Vec<String> {
        let pieces = text.split(|c: char| c.is_whitespace() || matches!(c, '`' | ',' | '.' | ';' | '?' | '"'));
        pieces.filter(|piece| !piece.is_empty()).map(str::to_lowercase).collect()
    };
    let said = words(said);
    // A sign such as `;` tells something, although no word is left of it.
    let has_signs = help.split('`').skip(1).step_by(2).any(|quoted| words(quoted).is_empty());
    !has_signs && words(help).iter().all(|word| EMPTY_WORDS.contains(&word.as_str()) || said.contains(word))
}

/// A command that cannot go on, as a list with one finding, which is how `--json` prints all that is wrong.
pub(crate) fn failure_to_json(failure: &Failure) -> Value {
    let mut finding = Finding::file(failure.refusal.problem, String::new(), failure.refusal.message.clone());
    finding.diagnostic.help.clone_from(&failure.refusal.help);
    to_json(&[finding], &Texts::default())
}

/// Findings as programs read them.
pub(crate) fn to_json(findings: &[Finding], texts: &Texts) -> Value {
    let mut lines = BTreeMap::new();
    Value::Array(findings.iter().map(|finding| one_to_json(finding, texts, &mut lines)).collect())
}

/// The first byte of each line of each file, so that a long list does not count lines from the top each time.
type Lines = BTreeMap<(Origin, FileId), Vec<usize>>;

fn one_to_json(finding: &Finding, texts: &Texts, lines: &mut Lines) -> Value {
    let diagnostic = &finding.diagnostic;
    let severity = match finding.severity() {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    let mut place = |span: Span, end: bool| -> (Value, Value) {
        let Some(sources) = texts.of(&finding.origin) else { return (Value::Null, Value::Null) };
        let text = &sources.file(span.file).text;
        let starts = lines.entry((finding.origin.clone(), span.file)).or_insert_with(|| line_starts(text));
        let at = clamp(text, if end { span.end } else { span.start });
        let line = starts.partition_point(|&start| start <= at) - 1;
        (json!(line + 1), json!(text[starts[line]..at].chars().count() + 1))
    };
    let (line, column) = place(diagnostic.span, false);
    let (end_line, end_column) = place(diagnostic.span, true);
    let fix = diagnostic.fix.as_ref().map(|fix| {
        let (line, column) = place(fix.span, false);
        let (end_line, end_column) = place(fix.span, true);
        json!({ "title": fix.title, "replacement": fix.replacement, "certain": fix.certainty == Certainty::Certain,
                "line": line, "column": column, "end_line": end_line, "end_column": end_column })
    });
    let file = match &finding.origin {
        Origin::File(path) => path.clone(),
        origin => texts.of(origin).map_or_else(String::new, |sources| sources.file(diagnostic.span.file).name.clone()),
    };
    let mut json = json!({
        "code": diagnostic.problem.code(), "severity": severity, "file": file,
        "line": line, "column": column, "end_line": end_line, "end_column": end_column,
        "message": diagnostic.message, "help": help_of(diagnostic), "fix": fix,
    });
    if !finding.programs.is_empty() {
        json["programs"] = json!(finding.programs);
    }
    json
}

fn line_starts(text: &str) -> Vec<usize> {
    std::iter::once(0).chain(text.bytes().enumerate().filter(|&(_, byte)| byte == b'\n').map(|(at, _)| at + 1)).collect()
}

/// A place in a text that is certainly on a character boundary.
fn clamp(text: &str, at: u32) -> usize {
    let mut at = (at as usize).min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// Which of the two collections of [`Texts`] a text belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Shelf {
    Documents,
    Program,
}

/// A text by its collection and its number there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct TextId {
    shelf: Shelf,
    file: FileId,
}

/// A span of one text, as ariadne wants it.
#[derive(Clone, Debug)]
struct Place {
    id: TextId,
    start: usize,
    end: usize,
}

impl Place {
    fn of(origin: &Origin, span: Span, texts: &Texts) -> Option<Self> {
        let sources = texts.of(origin)?;
        let text = &sources.iter().find(|(id, _)| *id == span.file)?.1.text;
        let start = clamp(text, span.start);
        // One statement may run over lines; its first line is enough to find it.
        let end = clamp(text, span.end).max(start);
        let end = text[start..end].find(['\r', '\n']).map_or(end, |at| start + at);
        let shelf = if *origin == Origin::Program { Shelf::Program } else { Shelf::Documents };
        Some(Self { id: TextId { shelf, file: span.file }, start, end })
    }
    fn is_drawable(&self, texts: &Texts) -> bool {
        let text = &texts.get(self.id).text;
        if text.is_empty() {
            return false;
        }
        let before = self.start - text[..self.start].rfind('\n').map_or(0, |at| at + 1);
        let after = text[self.start..].find('\n').unwrap_or(text.len() - self.start);
        before + after <= LINE_MAX
    }
}

impl ariadne::Span for Place {
    type SourceId = TextId;
    fn source(&self) -> &Self::SourceId {
        &self.id
    }
    fn start(&self) -> usize {
        self.start
    }
    fn end(&self) -> usize {
        self.end
    }
}

/// The texts cut into lines for ariadne, each once, with nothing in them that a terminal would obey.
struct TextCache<'a> {
    texts: &'a Texts,
    sources: BTreeMap<TextId, Shown<'a>>,
}

/// A text as it is shown.
struct Shown<'a> {
    source: Source<Cow<'a, str>>,
    /// Where a hidden character ends in the text, and by how many bytes all that stand up to there are longer as they are shown.
    shifts: Vec<(usize, usize)>,
}

impl<'a> Shown<'a> {
    fn of(text: &'a str) -> Self {
        let mut shift = 0;
        let mut picture = String::new();
        let shifts = visible::hidden(text).map(|(at, character)| {
            picture.clear();
            visible::push(&mut picture, character);
            shift += picture.len() - character.len_utf8();
            (at + character.len_utf8(), shift)
        });
        Self { shifts: shifts.collect(), source: Source::from(visible(text)) }
    }

    fn at(&self, offset: usize) -> usize {
        let before = self.shifts.partition_point(|&(end, _)| end <= offset);
        offset + before.checked_sub(1).map_or(0, |last| self.shifts[last].1)
    }
}

impl<'a> TextCache<'a> {
    fn text(&mut self, id: TextId) -> &Shown<'a> {
        self.sources.entry(id).or_insert_with(|| Shown::of(&self.texts.get(id).text))
    }

    /// The place in the text as it is shown.
    fn shown(&mut self, place: &Place) -> Place {
        let text = self.text(place.id);
        Place { id: place.id, start: text.at(place.start), end: text.at(place.end) }
    }
}

impl<'a> Cache<TextId> for TextCache<'a> {
    type Storage = Cow<'a, str>;

    fn fetch(&mut self, id: &TextId) -> Result<&Source<Cow<'a, str>>, impl fmt::Debug> {
        Ok::<_, &str>(&self.text(*id).source)
    }

    fn display<'b>(&self, id: &'b TextId) -> Option<impl fmt::Display + 'b> {
        Some(visible(&self.texts.get(*id).name).into_owned())
    }
}
