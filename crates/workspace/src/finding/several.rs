//! The findings of several programs as one list, each once.

use std::collections::{BTreeMap, BTreeSet};

use sieben_model::diagnostic::Severity;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Sources, Span};

use super::{Finding, Origin, Texts, sort};

/// Programs that a message names.
const NAMED_MAX: usize = 3;

/// What is wrong with several programs, which may share files.
#[derive(Debug, Default)]
pub struct Several {
    texts: Texts,
    findings: Vec<Finding>,
    /// Where a finding stands in the list.
    known: BTreeMap<(Origin, FileId, u32, u32, Problem, String), usize>,
    /// The texts by shelf and name.
    files: BTreeMap<(Origin, String), FileId>,
    /// In how many programs a text is.
    times: BTreeMap<(Origin, FileId), usize>,
    /// The programs, each with its errors and warnings.
    pub programs: Vec<Tally>,
}

/// How much is wrong with a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tally {
    /// What it is called.
    pub name: String,
    /// The files that it was read from.
    pub files: Vec<String>,
    /// How many errors.
    pub errors: usize,
    /// How many warnings.
    pub warnings: usize,
}

impl Several {
    /// Takes in what was found in a program.
    pub fn add(&mut self, name: &str, files: Vec<String>, findings: &[Finding], texts: &Texts) {
        let program = self.take(&Origin::Program, &texts.program);
        let document = self.take(&Origin::Document, &texts.documents);
        let errors = findings.iter().filter(|finding| finding.severity() == Severity::Error).count();
        self.programs.push(Tally { name: name.to_owned(), files, errors, warnings: findings.len() - errors });
        for finding in findings {
            let mut finding = finding.clone();
            let places = match finding.origin {
                Origin::Program => &program,
                Origin::Document => &document,
                Origin::File(_) => &Vec::new(),
            };
            let moved = |span: &mut Span| span.file = places.get(span.file.0 as usize).copied().unwrap_or_default();
            let diagnostic = &mut finding.diagnostic;
            moved(&mut diagnostic.span);
            diagnostic.related.iter_mut().for_each(|(span, _)| moved(span));
            diagnostic.fix.iter_mut().for_each(|fix| moved(&mut fix.span));
            let span = diagnostic.span;
            let key = (finding.origin.clone(), span.file, span.start, span.end, diagnostic.problem, diagnostic.message.clone());
            let at = *self.known.entry(key).or_insert_with(|| {
                self.findings.push(finding);
                self.findings.len() - 1
            });
            let programs = &mut self.findings[at].programs;
            if programs.last().is_none_or(|last| last != name) {
                programs.push(name.to_owned());
            }
        }
    }

    /// The places of texts among those that are known already.
    fn take(&mut self, shelf: &Origin, sources: &Sources) -> Vec<FileId> {
        let own = if *shelf == Origin::Program { &mut self.texts.program } else { &mut self.texts.documents };
        let mut places = Vec::new();
        for (_, source) in sources.iter() {
            let add = || own.add(source.name.clone(), source.text.clone());
            let file = *self.files.entry((shelf.clone(), source.name.clone())).or_insert_with(add);
            places.push(file);
        }
        for file in places.iter().collect::<BTreeSet<_>>() {
            *self.times.entry((shelf.clone(), *file)).or_default() += 1;
        }
        places
    }

    /// The list with these others, in the order of the names of files, then of places. What is wrong with a shared file in some programs
    /// only says in which.
    pub fn finish(mut self, others: Vec<Finding>) -> (Vec<Finding>, Texts, Vec<Tally>) {
        for finding in &mut self.findings {
            let times = self.times.get(&(finding.origin.clone(), finding.diagnostic.span.file)).copied().unwrap_or_default();
            let programs = &finding.programs;
            if programs.len() < times {
                let named: Vec<String> = programs.iter().take(NAMED_MAX).map(|name| format!("`{name}`")).collect();
                let more = programs.len().saturating_sub(NAMED_MAX);
                finding.note = Some(match more {
                    0 => format!("in {}", named.join(", ")),
                    more => format!("in {} and {more} more programs", named.join(", ")),
                });
            }
        }
        self.findings.extend(others);
        sort(&mut self.findings);
        let texts = &self.texts;
        self.findings.sort_by_key(|finding| match (&finding.origin, texts.of(&finding.origin)) {
            (Origin::File(path), _) => path.clone(),
            (_, sources) => sources.map_or_else(String::new, |sources| sources.file(finding.diagnostic.span.file).name.clone()),
        });
        (self.findings, self.texts, self.programs)
    }
}

#[cfg(test)]
mod tests {
    use sieben_model::diagnostic::Diagnostic;

    use super::*;

    #[test]
    fn what_is_wrong_with_a_shared_file_is_there_once() {
        let mut several = Several::default();
        for (name, wrong) in [("a", true), ("b", false), ("c", true)] {
            let mut texts = Texts::default();
            // The shared file has another place in each program.
            if name != "b" {
                texts.program.add(name, "x");
            }
            let shared = texts.program.add("shared", "y z");
            let always = Finding::program(Diagnostic::new(Problem::P2001, Span::new(shared, 0, 1), "always"));
            let sometimes = Finding::program(Diagnostic::new(Problem::P2001, Span::new(shared, 2, 3), "sometimes"));
            several.add(name, Vec::new(), &if wrong { vec![always, sometimes] } else { vec![always] }, &texts);
        }
        let (findings, texts, tallies) = several.finish(Vec::new());
        let seen: Vec<_> = findings
            .iter()
            .map(|finding| (texts.program.slice(finding.diagnostic.span), finding.message(), finding.programs.join(" ")))
            .collect();
        assert_eq!(seen, [("y", "always".to_owned(), "a b c".to_owned()), ("z", "sometimes (in `a`, `c`)".to_owned(), "a c".to_owned())]);
        assert_eq!(tallies.iter().map(|tally| tally.errors).collect::<Vec<_>>(), [2, 1, 2]);
    }
}
