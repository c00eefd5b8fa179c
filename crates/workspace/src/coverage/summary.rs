//! Coverage for a terminal and as JSON: a line for each source, and the sums.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::{Coverage, Share};

/// Ranges of lines that a line of the summary shows.
const RANGES_MAX: usize = 8;

/// `12 of 15 (80 %)`.
fn share(share: Share) -> String {
    match share.all {
        0 => "none".to_owned(),
        _ => format!("{} of {} ({} %)", share.hit, share.all, share.percent()),
    }
}

impl Coverage {
    /// What the end of a run of tests shows.
    pub fn summary(&self) -> String {
        if self.files.is_empty() {
            return "coverage: no unit test has run, so nothing was counted\n".to_owned();
        }
        let rows: Vec<[String; 3]> =
            self.files.iter().map(|(name, file)| [name.clone(), share(file.lines()), share(file.decisions())]).collect();
        let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
        let widths = [width(0).max("coverage".len()), width(1).max("lines".len()), width(2).max("decisions".len())];
        let [name, lines, decisions] = widths;
        let mut out = format!("{:name$}  {:lines$}  {:decisions$}  lines not run\n", "coverage", "lines", "decisions");
        for (row, file) in rows.iter().zip(self.files.values()) {
            let missed = file.missed();
            let one = |&(from, to): &(usize, usize)| if from == to { from.to_string() } else { format!("{from}–{to}") };
            let mut ranges = missed.iter().take(RANGES_MAX).map(one).collect::<Vec<_>>().join(", ");
            if missed.len() > RANGES_MAX {
                let _ = write!(ranges, " and {} more", missed.len() - RANGES_MAX);
            }
            let line = format!("{:name$}  {:lines$}  {:decisions$}  {ranges}", row[0], row[1], row[2]);
            let _ = writeln!(out, "{}", line.trim_end());
        }
        let lines = self.lines();
        let _ = writeln!(out, "{} of {} lines with statements were run ({} %)", lines.hit, lines.all, lines.percent());
        let decisions = self.decisions();
        if decisions.all > 0 {
            let _ = writeln!(out, "{} of {} decisions have gone every way ({} %)", decisions.hit, decisions.all, decisions.percent());
        }
        out
    }

    /// Each source, for `--json`.
    pub fn to_json(&self) -> Value {
        let files = self.files.iter().map(|(name, file)| {
            let (lines, decisions) = (file.lines(), file.decisions());
            json!({
                "file": name,
                "lines": lines.all,
                "lines_covered": lines.hit,
                "lines_not_run": file.missed(),
                "decisions": decisions.all,
                "decisions_covered": decisions.hit,
            })
        });
        files.collect()
    }
}
