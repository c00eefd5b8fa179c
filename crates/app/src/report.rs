//! Diagnostics for people and for programs: the edge where places become lines and columns.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;

use ariadne::{Cache, CharSet, Color, Config, IndexType, Label, LabelAttach, Report, ReportKind, Source};
use sieben_model::diagnostic::Severity;
use sieben_model::language::{Language, Text, fill, pick};
use sieben_model::source::{FileId, SourceFile, Span};
use sieben_model::visible::{self, visible};
use sieben_workspace::finding::{Finding, Origin, Texts, clamp, help_in, said_in, tally, to_json};

use crate::{failure, language, output};

/// Most diagnostics shown on a terminal: behind the first hundred the rest is mostly their consequence.
const SHOWN_MAX: usize = 100;
/// Longest line that is drawn, in bytes: a binary or minified file may be one line of megabytes.
const LINE_MAX: usize = 2_000;

/// Prints findings where messages go.
pub(crate) fn print(findings: &[Finding], texts: &Texts, json: bool) {
    match json {
        true => output::message_json(&to_json(findings, texts)),
        false => output::styled(&render(findings, texts, output::colour(), language::spoken())),
    }
}

/// Findings as people read them, with a count at the end; empty if there are none.
pub(crate) fn render(findings: &[Finding], texts: &Texts, colour: bool, language: Language) -> String {
    let mut text = pieces(findings, texts, colour, language).concat();
    if findings.len() > SHOWN_MAX {
        text.push_str(&fill(language, AND_MORE, &[&(findings.len() - SHOWN_MAX)]));
    }
    text.push_str(&count(findings, language));
    text
}

const AND_MORE: Text = ["… and {0} more; `--json` lists all of them.\n", "… und {0} weitere; `--json` zeigt alle.\n"];
const SAYS_MORE: Text = ["{0}. `sieben explain {1}` says more.\n", "{0}. `sieben explain {1}` sagt mehr dazu.\n"];
const HERE: Text = ["here", "hier"];
const WARNING: Text = ["Warning", "Warnung"];
/// Stands before the help while ariadne draws it, whose word for it is always the same: no source has this character where that word is.
const HELP_BEGINS: char = '\u{E007}';

/// Findings as people read them, each for itself, and their count.
pub(crate) fn parts(findings: &[Finding], texts: &Texts, language: Language) -> Vec<String> {
    let mut parts = pieces(findings, texts, false, language);
    parts.push(count(findings, language));
    parts
}

/// The first findings as people read them, each for itself.
pub(crate) fn pieces(findings: &[Finding], texts: &Texts, colour: bool, language: Language) -> Vec<String> {
    let mut cache = TextCache { texts, sources: BTreeMap::new() };
    let mut piece = |finding: &Finding| {
        let mut out = Vec::new();
        render_one(finding, &mut cache, colour, language, &mut out);
        // Ariadne pads its lines; spaces at the end of a line only disturb whoever copies it.
        String::from_utf8_lossy(&out).lines().flat_map(|line| [line.trim_end(), "\n"]).collect()
    };
    findings.iter().take(SHOWN_MAX).map(&mut piece).collect()
}

/// `2 errors, 1 warning. …`, with how to learn more; empty if there are no findings.
fn count(findings: &[Finding], language: Language) -> String {
    let Some(first) = findings.iter().find(|finding| finding.severity() == Severity::Error).or(findings.first()) else {
        return String::new();
    };
    fill(language, SAYS_MORE, &[&tally(findings, language), &first.diagnostic.problem.code()])
}

fn render_one(finding: &Finding, cache: &mut TextCache<'_>, colour: bool, language: Language, out: &mut Vec<u8>) {
    let diagnostic = &finding.diagnostic;
    let (kind, word, shade) = match finding.severity() {
        Severity::Error => (ReportKind::Error, failure::ERROR, Color::Red),
        Severity::Warning => (ReportKind::Warning, WARNING, Color::Yellow),
    };
    let help = help_in(language, diagnostic);
    let place = Place::of(&finding.origin, diagnostic.span, cache.texts);
    let drawable = place.as_ref().is_some_and(|place| place.is_drawable(cache.texts));
    let Some(place) = place.filter(|_| drawable) else {
        render_plain(finding, cache.texts, colour, language, out);
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
        .with_message(visible(&said_in(language, diagnostic.problem, &finding.message())));
    if let Some(help) = help {
        let lines: Vec<_> = help.lines().map(visible).collect();
        report = report.with_help(format!("{HELP_BEGINS}{}", lines.join("\n ")));
    }
    let title = diagnostic.fix.as_ref().map_or(pick(language, HERE), |fix| fix.title.as_str());
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
    let mut drawn = Vec::new();
    match report.finish().write(&mut *cache, &mut drawn) {
        Ok(()) => out.extend_from_slice(in_words(&String::from_utf8_lossy(&drawn), word, language).as_bytes()),
        Err(_) => render_plain(finding, cache.texts, colour, language, out),
    }
}

/// A drawn report with what it is, which stands first, and its help named in the language.
fn in_words(drawn: &str, word: Text, language: Language) -> String {
    let drawn = drawn.replacen(word[0], pick(language, word), 1);
    let Some((before, help)) = drawn.rsplit_once(HELP_BEGINS) else { return drawn };
    let (before, separator) = before.rsplit_once(failure::HELP[0]).unwrap_or((before, ""));
    format!("{before}{}{separator}{help}", pick(language, failure::HELP))
}

/// Without the source lines: for whole files and for lines too long to draw.
fn render_plain(finding: &Finding, texts: &Texts, colour: bool, language: Language, out: &mut Vec<u8>) {
    let diagnostic = &finding.diagnostic;
    let (word, shade) = match finding.severity() {
        Severity::Error => (failure::ERROR, "\x1b[31m"),
        Severity::Warning => (WARNING, "\x1b[33m"),
    };
    let word = pick(language, word);
    let (shade, plain) = if colour { (shade, "\x1b[0m") } else { ("", "") };
    let place = match &finding.origin {
        Origin::File(_) => String::new(),
        origin => texts.of(origin).map_or_else(String::new, |sources| {
            let (line, column) = sources.line_column(diagnostic.span);
            format!(" ({}:{line}:{column})", visible(&sources.file(diagnostic.span.file).name))
        }),
    };
    let code = diagnostic.problem.code();
    let message = said_in(language, diagnostic.problem, &finding.message());
    out.extend_from_slice(format!("{shade}[{code}] {word}:{plain} {}{place}\n", visible(&message)).as_bytes());
    if let Some(help) = help_in(language, diagnostic) {
        let lines: Vec<_> = help.lines().map(visible).collect();
        out.extend_from_slice(format!("  {}: {}\n", pick(language, failure::HELP), lines.join("\n  ")).as_bytes());
    }
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

impl TextId {
    fn text(self, texts: &Texts) -> &SourceFile {
        match self.shelf {
            Shelf::Documents => texts.documents.file(self.file),
            Shelf::Program => texts.program.file(self.file),
        }
    }
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
        let text = &self.id.text(texts).text;
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
        self.sources.entry(id).or_insert_with(|| Shown::of(&id.text(self.texts).text))
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
        Some(visible(&id.text(self.texts).name).into_owned())
    }
}
