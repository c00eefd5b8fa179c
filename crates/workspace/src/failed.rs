//! What the user learns of statements that failed while the program went on, and of the diagnostic buffer.

use serde_json::{Value, json};
use sieben_cpu::{Cpu, DiagnosticEntry, FailedStatements};
use sieben_sim::trace::moment;

use crate::controller;
use crate::project::Build;

/// Statements that failed in a run: how often, and the first one.
#[derive(Clone, Debug)]
pub struct Failed {
    /// How often a statement failed.
    pub count: u64,
    /// What was wrong with the first one.
    text: String,
    /// Its block.
    block: String,
    /// Its file, line and column; `None` for one that the compiler made.
    place: Option<(String, usize, usize)>,
    /// What is written there.
    statement: Option<String>,
    scan: Option<u64>,
}

impl Failed {
    /// Those of a CPU that ran this program.
    pub fn of(build: &Build, cpu: &Cpu) -> Option<Self> {
        Self::told(build, cpu.failed_statements())
    }

    /// What a CPU that ran this program noted.
    fn told(build: &Build, failed: &FailedStatements) -> Option<Self> {
        let first = failed.first.as_deref()?;
        let place = controller::span_at(build, first.place).map(|span| {
            let sources = &build.project.texts.program;
            let (line, column) = sources.line_column(span);
            (sources.file(span.file).name.clone(), line, column)
        });
        Some(Self {
            count: failed.count,
            text: first.text(),
            block: controller::block_text(build, first.place.block),
            place,
            statement: controller::line_at(build, first.place).map(|line| line.statement),
            scan: first.scan,
        })
    }

    /// The same, of so many.
    pub fn in_all(self, count: u64) -> Self {
        Self { count, ..self }
    }

    /// The same of several runs: how often in all, and the first of the first.
    pub fn of_all<'a>(all: impl IntoIterator<Item = &'a Self>) -> Option<Self> {
        let mut all = all.into_iter();
        let mut whole = all.next()?.clone();
        whole.count = all.fold(whole.count, |sum, one| sum.saturating_add(one.count));
        Some(whole)
    }

    /// In one line.
    pub fn line(&self) -> String {
        let often = match self.count {
            1 => "A statement failed once,".to_owned(),
            count => format!("Statements failed {count} times, first"),
        };
        format!("{often} in {}", self.first_line())
    }

    /// The first one: its scan, its place and what was wrong.
    pub fn first_line(&self) -> String {
        let place = self.place.as_ref().map_or_else(String::new, |(file, line, column)| format!("{file}:{line}:{column} "));
        let statement = self.statement.as_ref().map_or_else(String::new, |statement| format!(", `{statement}`"));
        format!("{}: {place}in {}{statement}: {}", moment::scan_words(self.scan), self.block, self.text)
    }

    /// As JSON.
    pub fn json(&self) -> Value {
        let (file, line, column) =
            self.place.clone().map_or((None, None, None), |(file, line, column)| (Some(file), Some(line), Some(column)));
        json!({
            "count": self.count,
            "first": {
                "text": self.text, "block": self.block, "file": file, "line": line, "column": column,
                "statement": self.statement, "scan": self.scan,
            },
        })
    }
}

/// Listens to a run in which the CPU may be another one after a power failure.
#[derive(Clone, Debug, Default)]
pub struct Heard {
    /// All until now; the first of the first.
    all: FailedStatements,
    /// Those of CPUs that are gone.
    before: u64,
}

impl Heard {
    /// After a scan.
    pub fn hear(&mut self, cpu: &Cpu) {
        let now = cpu.failed_statements();
        if self.before.saturating_add(now.count) < self.all.count {
            self.before = self.all.count;
        }
        self.all.count = self.before.saturating_add(now.count);
        if self.all.first.is_none() {
            self.all.first.clone_from(&now.first);
        }
    }

    /// What was heard.
    pub fn failed(&self, build: &Build) -> Option<Failed> {
        Failed::told(build, &self.all)
    }
}

/// The diagnostic buffer as people read it, newest entry first, with blocks as they are called.
pub fn buffer_text(build: &Build, cpu: &Cpu, most: usize) -> String {
    let lines: String = cpu.diagnostic_buffer().entries().take(most).map(|entry| format!("  {}\n", entry_text(build, entry))).collect();
    format!("Diagnostic buffer, newest first:\n{}", if lines.is_empty() { "  (empty)\n" } else { &lines })
}

/// An entry of the diagnostic buffer in one line.
pub fn entry_text(build: &Build, entry: &DiagnosticEntry) -> String {
    let at = entry.place.and_then(|place| controller::line_at(build, place));
    let at = at.map_or_else(String::new, |line| format!("  {}:{}", line.file, line.number));
    format!("{}  16#{:04X}  {}{at}", entry.time.display(), entry.event(), controller::named(build, &entry.text(), entry.place))
}

/// The diagnostic buffer as JSON, newest entry first.
pub fn buffer_json(build: &Build, cpu: &Cpu) -> Value {
    let entry = |entry: &DiagnosticEntry| {
        let line = entry.place.and_then(|place| controller::line_at(build, place));
        json!({
            "time": entry.time.display().to_string(),
            "event": format!("16#{:04X}", entry.event()),
            "text": controller::named(build, &entry.text(), entry.place),
            "block": entry.place.map(|place| place.block.to_string()),
            "statement": entry.place.map(|place| u64::from(place.statement) + 1),
            "file": line.as_ref().map(|line| &line.file),
            "line": line.as_ref().map(|line| line.number),
        })
    };
    cpu.diagnostic_buffer().entries().map(entry).collect()
}
