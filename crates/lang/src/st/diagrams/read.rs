//! The networks of a body as they are written: in form A, each begun by NETWORK, or in form B, each on a line.

use std::ops::Range;

use sieben_model::diagnostic::Diagnostic;
use sieben_model::source::{FileId, Span};

use super::Language;
use crate::network::flavour::{Drawing, Flavour};
use crate::network::form_a;
use crate::network::mistake::Mistake;
use crate::network::model::{Content, Network, Place};
use crate::network::{form_b, rules};

/// A network of a body.
pub(in crate::st) struct Written {
    /// What it draws.
    pub(in crate::st) network: Network,
    /// What it is drawn in: the body says it, or its own first line.
    pub(in crate::st) language: Language,
    /// Its first line.
    pub(in crate::st) place: Place,
}

/// The networks of a body, and what is wrong with them.
#[derive(Default)]
pub(in crate::st) struct Read {
    /// Those that were understood, at least in part.
    pub(in crate::st) networks: Vec<Written>,
    /// What was not.
    pub(in crate::st) mistakes: Vec<Mistake>,
}

/// A part of a body: its head, and the bytes of its elements.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::st) struct Part {
    /// The line NETWORK with what belongs to it; empty where there is none.
    pub(in crate::st) head: Range<usize>,
    /// Its elements.
    pub(in crate::st) elements: Range<usize>,
    /// The language that its head names.
    pub(in crate::st) language: Option<Language>,
}

/// The networks in these bytes of a text.
pub(in crate::st) fn networks(text: &str, body: Range<usize>, language: Language) -> Read {
    let mut read = Read::default();
    // How far the first line is indented tells what belongs to it.
    let line = text[..body.start].rfind(['\n', '\r']).map_or(0, |end| end + 1);
    let start = if text[line..body.start].trim().is_empty() { line } else { body.start };
    for part in parts(text, start..body.end) {
        let language = part.language.unwrap_or(language);
        if form_a::is_form_a(&text[part.elements.clone()], Flavour::Iec) {
            let parsed = form_a::parse(text, part.elements.start, part.elements.end, Flavour::Iec);
            read.report(parsed.mistakes);
            let place = if part.head.is_empty() { &part.elements } else { &part.head };
            read.add(parsed.network, language, Place::new(place.start, place.end));
        } else {
            read.form_b(text, &part, language);
        }
    }
    read
}

impl Read {
    /// What is wrong with the next network.
    fn report(&mut self, mistakes: Vec<Mistake>) {
        let number = self.networks.len() + 1;
        self.mistakes
            .extend(mistakes.into_iter().map(|mistake| Mistake { message: format!("network {number}: {}", mistake.message), ..mistake }));
    }

    fn add(&mut self, network: Network, language: Language, place: Place) {
        self.report(rules::mistakes(&network, Flavour::Iec, Some(language.drawing())));
        self.networks.push(Written { network, language, place });
    }

    /// Form B: below NETWORK all lines are one network, otherwise each line is one.
    fn form_b(&mut self, text: &str, part: &Part, language: Language) {
        let lines = part.elements.clone();
        if !part.head.is_empty() {
            // Blanks in place of comments and line ends keep all places.
            let joined: String = text[lines.clone()].split_inclusive('\n').map(without_comment_in_place).collect();
            return self.line_of_form_b(&joined, lines.start, language, Some(part.head.clone()));
        }
        let mut start = lines.start;
        for line in text[lines].split_inclusive('\n') {
            self.line_of_form_b(without_comment(line), start, language, None);
            start += line.len();
        }
    }

    fn line_of_form_b(&mut self, line: &str, start: usize, language: Language, head: Option<Range<usize>>) {
        let written = line.trim_end();
        let content = written.trim_start();
        let from = start + (written.len() - content.len());
        let to = from + content.len();
        if content.is_empty() {
            return;
        }
        match form_b::parse(content, from, Flavour::Iec) {
            Ok(network) => {
                let place = head.unwrap_or(from..to);
                self.add(network, language, Place::new(place.start, place.end));
            }
            Err(mistake) => {
                self.report(vec![mistake]);
                // Those after it keep their numbers.
                let place = head.unwrap_or(from..to);
                let network = Network { label: None, content: Content::Empty };
                self.networks.push(Written { network, language, place: Place::new(place.start, place.end) });
            }
        }
    }
}

/// A line with spaces in place of its comment and its end.
fn without_comment_in_place(line: &str) -> String {
    let written = without_comment(line).trim_end_matches(['\r', '\n']);
    let mut line_of_spaces = String::with_capacity(line.len());
    line_of_spaces.push_str(written);
    line_of_spaces.extend(std::iter::repeat_n(' ', line.len() - written.len()));
    line_of_spaces
}

/// A line up to its comment.
fn without_comment(line: &str) -> &str {
    &line[..form_a::comment_start(line).unwrap_or(line.len())]
}

impl Language {
    /// The drawing of the networks.
    pub(in crate::st) fn drawing(self) -> Drawing {
        match self {
            Self::Ladder => Drawing::Lad,
            Self::FunctionBlocks => Drawing::Fbd,
        }
    }
}

/// The networks of a body, apart from each other.
pub(in crate::st) fn parts(text: &str, body: Range<usize>) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    let mut start = body.start;
    // Lines that belong to the head of the last network.
    let mut in_head = false;
    for line in text[body.clone()].split_inclusive('\n') {
        let (end, content) = (start + line.len(), line.trim());
        let word = first_word(content);
        if word.eq_ignore_ascii_case("NETWORK") {
            let rest = content[word.len()..].trim_start();
            let language = Language::of(first_word(rest));
            parts.push(Part { head: start..end, elements: end..end, language });
            in_head = true;
        } else if in_head && (content.is_empty() || content.starts_with("//") || is_title(content)) {
            if let Some(part) = parts.last_mut() {
                (part.head.end, part.elements) = (end, end..end);
            }
            in_head &= !is_title(content);
        } else {
            in_head = false;
            match parts.last_mut() {
                Some(part) => part.elements.end = end,
                None => parts.push(Part { head: start..start, elements: start..end, language: None }),
            }
        }
        start = end;
    }
    parts
}

fn is_title(content: &str) -> bool {
    let word = first_word(content);
    word.eq_ignore_ascii_case("TITLE") && content[word.len()..].trim_start().starts_with('=')
}

fn first_word(content: &str) -> &str {
    content.find(|sign: char| !(sign.is_alphanumeric() || sign == '_')).map_or(content, |end| &content[..end])
}

/// What is to be said about a mistake.
pub(in crate::st) fn diagnostic(mistake: &Mistake, file: FileId) -> Diagnostic {
    let place = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
    let span = Span::new(file, place(mistake.start), place(mistake.end.max(mistake.start)));
    let diagnostic = Diagnostic::new(mistake.kind.problem(), span, mistake.message.clone());
    match &mistake.help {
        Some(help) => diagnostic.help(help.clone()),
        None => diagnostic,
    }
}
