//! Which statements of a program its tests have run, and which way its decisions have gone.

mod counts;
pub mod html;
mod lcov;
mod summary;

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use sieben_lang::coverage::{Decision as Countable, Label};
use sieben_model::source::{FileId, Sources, Span};

use crate::project::Build;
pub use counts::{Counting, Counts, Looking, looking};

/// Characters of the source that the name of a decision has at most.
const NAME_MAX: usize = 80;

/// Takes in what tests count while they run, several at once.
#[derive(Default)]
pub struct Collector {
    /// The programs that were run, and what was counted in each; a program is known by its address.
    programs: Mutex<BTreeMap<usize, Counted>>,
}

struct Counted {
    build: Arc<Build>,
    /// A source that is a test and none of the program.
    test: Option<FileId>,
    counts: Counts,
}

impl Collector {
    /// Takes in what a run of a program has counted.
    pub fn add(&self, build: &Arc<Build>, test: Option<FileId>, counts: Counts) {
        let mut programs = self.programs.lock().unwrap_or_else(PoisonError::into_inner);
        let known = programs.entry(Arc::as_ptr(build) as usize);
        known.or_insert_with(|| Counted { build: Arc::clone(build), test, counts: Counts::default() }).counts.add(counts);
    }

    /// What was counted, by the lines of the sources.
    pub fn coverage(&self) -> Coverage {
        let mut coverage = Coverage::default();
        for Counted { build, test, counts } in self.programs.lock().unwrap_or_else(PoisonError::into_inner).values() {
            coverage.add(build, *test, counts);
        }
        coverage
    }
}

/// The sources of all programs that were tested.
#[derive(Clone, Debug, Default)]
pub struct Coverage {
    /// By name.
    files: BTreeMap<String, File>,
}

/// A source.
#[derive(Clone, Debug, Default)]
struct File {
    /// All of it.
    text: String,
    /// Its lines with statements, counted from 1.
    lines: BTreeMap<usize, Line>,
}

/// A line with statements.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Line {
    /// How often its statements were run: as often as the one that was run most.
    ran: u64,
    /// The decisions that begin in it.
    decisions: Vec<Decision>,
}

/// A place where the program goes one way or another.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Decision {
    /// What decides, as it is written.
    name: String,
    /// The ways, and how often each was gone.
    ways: Vec<(String, u64)>,
}

impl Decision {
    /// Whether it was come to at all.
    fn is_reached(&self) -> bool {
        self.ways.iter().any(|(_, count)| *count > 0)
    }

    /// Whether every way was gone.
    fn is_whole(&self) -> bool {
        self.ways.iter().all(|(_, count)| *count > 0)
    }

    /// `RLO 0: 3 times, RLO 1: never`.
    fn told(&self) -> String {
        if !self.is_reached() {
            return "never reached".to_owned();
        }
        let one = |(way, count): &(String, u64)| match count {
            0 => format!("{way}: never"),
            1 => format!("{way}: once"),
            _ => format!("{way}: {count} times"),
        };
        self.ways.iter().map(one).collect::<Vec<_>>().join(", ")
    }
}

/// How many of how many.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Share {
    /// Those that were.
    pub hit: usize,
    /// All.
    pub all: usize,
}

impl Share {
    fn of<T>(all: impl Iterator<Item = T>, hit: impl Fn(&T) -> bool) -> Self {
        all.fold(Self::default(), |share, one| Self { hit: share.hit + usize::from(hit(&one)), all: share.all + 1 })
    }

    /// In percent, rounded down: only all of it is 100.
    pub fn percent(self) -> usize {
        (self.hit * 100).checked_div(self.all).unwrap_or(100)
    }
}

impl File {
    fn lines(&self) -> Share {
        Share::of(self.lines.values(), |line| line.ran > 0)
    }

    fn decisions(&self) -> Share {
        Share::of(self.lines.values().flat_map(|line| &line.decisions), |decision| decision.is_whole())
    }

    /// Lines with statements that were not run: from and to, those without statements between them left out.
    fn missed(&self) -> Vec<(usize, usize)> {
        let mut all: Vec<(usize, usize)> = Vec::new();
        let mut goes_on = false;
        for (&number, line) in &self.lines {
            match (line.ran, all.last_mut()) {
                (0, Some((_, last))) if goes_on => *last = number,
                (0, _) => all.push((number, number)),
                _ => {}
            }
            goes_on = line.ran == 0;
        }
        all
    }
}

impl Coverage {
    /// Takes in what runs of a program have counted. Lines that nothing has run count with 0.
    fn add(&mut self, build: &Build, test: Option<FileId>, counts: &Counts) {
        let sources = &build.project.texts.program;
        let mut files: BTreeMap<FileId, File> = BTreeMap::new();
        for (&block, countable) in &build.compiled.countable {
            let is_known = |span: Span| sources.iter().any(|(file, _)| file == span.file) && Some(span.file) != test;
            for (span, seen) in countable.statements.iter().filter(|(span, _)| is_known(*span)) {
                let line = files.entry(span.file).or_default().lines.entry(sources.line_column(*span).0).or_default();
                line.ran = line.ran.max(counts.of(block, seen));
            }
            for decision in countable.decisions.iter().filter(|decision| is_known(decision.span)) {
                let line = files.entry(decision.span.file).or_default().lines.entry(sources.line_column(decision.span).0).or_default();
                let ways = decision.outcomes.iter().map(|outcome| (way(outcome.label, sources), counts.of(block, &outcome.seen))).collect();
                let decision = Decision { name: name(decision, sources), ways };
                line.ran = line.ran.max(decision.ways.iter().map(|(_, count)| *count).fold(0, u64::saturating_add));
                line.decisions.push(decision);
            }
        }
        for (id, file) in files {
            let source = sources.file(id);
            self.merge(source.name.clone(), File { text: source.text.clone(), ..file });
        }
    }

    /// Adds what was counted in a source.
    fn merge(&mut self, name: String, file: File) {
        let known = self.files.entry(name).or_insert_with(|| File { text: file.text.clone(), ..File::default() });
        for (number, line) in file.lines {
            let known = known.lines.entry(number).or_default();
            known.ran = known.ran.saturating_add(line.ran);
            for (index, decision) in line.decisions.into_iter().enumerate() {
                match known.decisions.get_mut(index) {
                    // Two programs may read one source in two ways: `--dialect`, a mocked block.
                    Some(known) => {
                        for (known, more) in known.ways.iter_mut().zip(decision.ways) {
                            known.1 = known.1.saturating_add(more.1);
                        }
                    }
                    None => known.decisions.push(decision),
                }
            }
        }
    }

    /// Lines with statements that were run.
    pub fn lines(&self) -> Share {
        Share::of(self.files.values().flat_map(|file| file.lines.values()), |line| line.ran > 0)
    }

    /// Decisions that have gone every way.
    pub fn decisions(&self) -> Share {
        let lines = self.files.values().flat_map(|file| file.lines.values());
        Share::of(lines.flat_map(|line| &line.decisions), |decision| decision.is_whole())
    }
}

/// What decides, on one line.
fn name(decision: &Countable, sources: &Sources) -> String {
    one_line(&format!("{} {}", decision.word, sources.slice(decision.span)))
}

/// What a way is called.
fn way(label: Label, sources: &Sources) -> String {
    match label {
        Label::Word(word) => word.to_owned(),
        Label::Source(span) => format!("`{}`", one_line(sources.slice(span))),
    }
}

fn one_line(text: &str) -> String {
    let whole = text.split_whitespace().collect::<Vec<_>>().join(" ");
    match whole.char_indices().nth(NAME_MAX) {
        Some((end, _)) => format!("{}…", &whole[..end]),
        None => whole,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    pub(super) fn file(lines: &[(usize, u64, &[[u64; 2]])]) -> File {
        let decision = |&[no, yes]: &[u64; 2]| Decision {
            name: "= Q 0.0".to_owned(),
            ways: vec![("RLO 0".to_owned(), no), ("RLO 1".to_owned(), yes)],
        };
        let line = |&(number, ran, decisions): &(usize, u64, &[[u64; 2]])| {
            (number, Line { ran, decisions: decisions.iter().map(decision).collect() })
        };
        File { text: String::new(), lines: lines.iter().map(line).collect() }
    }

    #[test]
    fn counts_of_several_programs_add_up() {
        let mut all = Coverage::default();
        all.merge("a.awl".to_owned(), file(&[(1, 0, &[[0, 0]]), (2, 3, &[[3, 0]])]));
        all.merge("a.awl".to_owned(), file(&[(1, 0, &[[0, 0]]), (2, 1, &[[0, 1]])]));
        assert_eq!((all.lines(), all.decisions()), (Share { hit: 1, all: 2 }, Share { hit: 1, all: 2 }));
        let line = &all.files["a.awl"].lines[&2];
        assert_eq!(line.decisions[0].told(), "RLO 0: 3 times, RLO 1: once");
        assert_eq!(all.files["a.awl"].lines[&1].decisions[0].told(), "never reached");
    }

    #[test]
    fn only_all_of_it_is_a_hundred_percent() {
        assert_eq!(Share { hit: 999, all: 1000 }.percent(), 99);
        assert_eq!(Share { hit: 0, all: 0 }.percent(), 100);
    }

    #[test]
    fn missed_lines_are_told_as_ranges_over_lines_without_statements() {
        assert_eq!(file(&[(1, 0, &[]), (2, 0, &[]), (5, 0, &[]), (6, 2, &[]), (8, 0, &[])]).missed(), [(1, 5), (8, 8)]);
    }
}
