//! A file of TOML that is read key by key: its values, and what is wrong with them, each with its place.

use std::borrow::Cow;

use sieben_model::diagnostic::Diagnostic;
use sieben_model::nearest::{nearest, one_of};
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};
use sieben_sim::duration;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::spec::Placed;

/// Most that is told of one file: after the first hundred the rest is mostly their consequence.
const DIAGNOSTICS_MAX: usize = 100;

/// A value with its place.
pub type Value<'i> = Spanned<DeValue<'i>>;
/// A key with its place.
pub type Key<'i> = Spanned<Cow<'i, str>>;

/// A file that is being read.
pub struct Document<'t> {
    text: &'t str,
    file: FileId,
    problem: Problem,
    /// What was wrong so far.
    pub diagnostics: Vec<Diagnostic>,
}

/// The entries of a table in the order of the file.
pub fn in_order<'a, 'i>(table: &'a DeTable<'i>) -> Vec<(&'a Key<'i>, &'a Value<'i>)> {
    let mut all: Vec<_> = table.iter().collect();
    all.sort_by_key(|(key, _)| key.span().start);
    all
}

/// A number as the file has it; one that is not finite is none.
pub fn number(value: &Value<'_>) -> Option<f64> {
    match value.get_ref() {
        DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix()).ok().map(|number| number as f64),
        DeValue::Float(float) => float.as_str().parse().ok().filter(|number: &f64| number.is_finite()),
        _ => None,
    }
}

/// What is told of diagnostics, in the order of the file; of very many the first, and how many more there are.
pub fn at_most(mut diagnostics: Vec<Diagnostic>, problem: Problem) -> Vec<Diagnostic> {
    diagnostics.sort_by_key(|diagnostic| diagnostic.span.start);
    if let Some(more) = diagnostics.len().checked_sub(DIAGNOSTICS_MAX).filter(|&more| more > 0) {
        diagnostics.truncate(DIAGNOSTICS_MAX);
        let last = diagnostics[DIAGNOSTICS_MAX - 1].span;
        diagnostics.push(Diagnostic::new(problem, last, format!("and {more} more after this one")));
    }
    diagnostics
}

impl<'t> Document<'t> {
    /// A file with this text; `problem` is what a key or value is that is not understood.
    pub fn new(text: &'t str, file: FileId, problem: Problem) -> Self {
        Self { text, file, problem, diagnostics: Vec::new() }
    }

    /// Its tables, or else it is said that it has none.
    pub fn tables(&mut self, unreadable: Problem) -> Option<Spanned<DeTable<'t>>> {
        match DeTable::parse(self.text) {
            Ok(table) => Some(table),
            Err(error) => {
                let message = format!("the file is not valid TOML: {}", error.message().replace('\n', "; "));
                let span = self.span(error.span().unwrap_or(0..0));
                self.diagnostics.push(Diagnostic::new(unreadable, span, message));
                None
            }
        }
    }

    /// What was wrong, in the order of the file; of very many only the first are told.
    pub fn finish(self) -> Vec<Diagnostic> {
        at_most(self.diagnostics, self.problem)
    }

    /// A place of it.
    pub fn span(&self, range: std::ops::Range<usize>) -> Span {
        // Files above 64 MiB are refused before, so that offsets fit.
        Span::new(self.file, range.start as u32, range.end as u32)
    }

    /// Says what is wrong with a value.
    pub fn wrong(&mut self, value: &Value<'_>, message: impl Into<String>) {
        self.wrong_at(self.span(value.span()), message);
    }

    /// Says what is wrong at a place.
    pub fn wrong_at(&mut self, span: Span, message: impl Into<String>) {
        self.diagnostics.push(Diagnostic::new(self.problem, span, message));
    }

    /// Says that a table has no such key.
    pub fn unknown(&mut self, table: &str, key: &Key<'_>, known: &[&str]) {
        let place = if table.is_empty() { String::new() } else { format!(" in `[{table}]`") };
        let diagnostic = Diagnostic::new(self.problem, self.span(key.span()), format!("there is no key `{}`{place}", key.get_ref()));
        // Of very many mistakes only the first are told, and these words are not cheap to compare.
        let near = if self.diagnostics.len() < DIAGNOSTICS_MAX { nearest(key.get_ref(), known.iter().copied()) } else { None };
        self.diagnostics.push(match near {
            Some(near) => diagnostic.help(format!("did you mean `{near}`?")),
            None => diagnostic.help(format!("there are {}", one_of(known.iter().copied()))),
        });
    }

    /// The name of a key.
    pub fn placed(&self, key: &Key<'_>) -> Placed {
        let span = key.span();
        self.inside(key.get_ref(), span)
    }

    /// A string with the place of what stands between its quotes, if that is the same there.
    fn inside(&self, text: &str, span: std::ops::Range<usize>) -> Placed {
        let written = self.text.get(span.clone()).unwrap_or_default();
        let at = written.find(text).filter(|_| !text.is_empty());
        let start = at.map_or(span.start, |at| span.start + at);
        let end = at.map_or(span.end, |at| span.start + at + text.len());
        Placed { text: text.to_owned(), span: Span::new(self.file, start as u32, end as u32) }
    }

    /// A string that is not empty.
    pub fn string(&mut self, value: &Value<'_>, name: &str) -> Option<Placed> {
        match value.get_ref() {
            DeValue::String(text) if !text.trim().is_empty() => Some(self.inside(text, value.span())),
            DeValue::String(_) => {
                self.wrong(value, format!("`{name}` is empty"));
                None
            }
            _ => {
                self.wrong(value, format!("`{name}` is a string: `{name} = \"…\"`"));
                None
            }
        }
    }

    /// One string, or a list of them.
    pub fn strings(&mut self, value: &Value<'_>, name: &str) -> Vec<Placed> {
        match value.get_ref() {
            DeValue::Array(items) => items.iter().filter_map(|item| self.string(item, name)).collect(),
            DeValue::String(_) => self.string(value, name).into_iter().collect(),
            _ => {
                self.wrong(value, format!("`{name}` is a list of strings: `{name} = [\"…\", \"…\"]`"));
                Vec::new()
            }
        }
    }

    /// A whole number from `least`.
    pub fn whole(&mut self, value: &Value<'_>, name: &str, least: u64) -> Option<u64> {
        let number = match value.get_ref() {
            DeValue::Integer(integer) => u64::from_str_radix(integer.as_str(), integer.radix()).ok().filter(|&number| number >= least),
            _ => None,
        };
        if number.is_none() {
            self.wrong(value, format!("`{name}` is a whole number from {least} on: `{name} = {}`", least.max(7)));
        }
        number
    }

    /// A number that is finite.
    pub fn number(&mut self, value: &Value<'_>, name: &str) -> Option<f64> {
        let number = number(value);
        if number.is_none() {
            self.wrong(value, format!("`{name}` is a number: `{name} = 1.5`"));
        }
        number
    }

    /// A number from 0 to 1.
    pub fn chance(&mut self, value: &Value<'_>, name: &str) -> Option<f64> {
        let number = number(value).filter(|number| (0.0..=1.0).contains(number));
        if number.is_none() {
            self.wrong(value, format!("`{name}` is a number from 0 to 1: `{name} = 0.25`"));
        }
        number
    }

    /// A duration in microseconds.
    pub fn duration(&mut self, value: &Value<'_>, name: &str) -> Option<u64> {
        let DeValue::String(text) = value.get_ref() else {
            self.wrong(value, format!("`{name}` is a duration: `{name} = \"30s\"`"));
            return None;
        };
        match duration::parse(text) {
            // Not longer than ten years.
            Ok(time) => Some(time.as_micros() as u64),
            Err(message) => {
                self.wrong(value, message);
                None
            }
        }
    }
}
