//! A report for build servers: a test case for each property.

use std::fmt::Write as _;

use sieben_campaign::row::Verdict;
use sieben_workspace::xml::escaped;

use super::Report;
use crate::campaign::said;

/// The report as XML of JUnit.
pub(crate) fn junit(report: &Report) -> String {
    let mut cases: Vec<(String, Option<String>)> =
        report.properties().into_iter().map(|(kind, name, said, holds)| (format!("{kind}: {name}"), (!holds).then_some(said))).collect();
    // What ended before a property could be looked at.
    for verdict in [Verdict::Stop, Verdict::Limit, Verdict::Error] {
        let count = report.count(verdict);
        let first =
            report.listed.iter().find(|row| row.verdict == verdict).map_or_else(String::new, |row| format!(", first in {}", row.scenario));
        cases.push((format!("no {}", verdict.word()), (count > 0).then(|| format!("{}{first}", said::scenarios(count)))));
    }
    let missing: u64 = report.there().missing(0..report.file.head.scenarios).map(|range| range.end - range.start).sum();
    cases.push(("all scenarios".to_owned(), (missing > 0).then(|| format!("{} missing", said::scenarios(missing)))));
    let name = escaped(report.name());
    let failures = cases.iter().filter(|(_, failure)| failure.is_some()).count();
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    // Writing to a string cannot fail.
    let _ = writeln!(out, "<testsuites>\n  <testsuite name=\"{name}\" tests=\"{}\" failures=\"{failures}\" errors=\"0\">", cases.len());
    for (case, failure) in cases {
        let _ = write!(out, "    <testcase name=\"{}\" classname=\"{name}\"", escaped(&case));
        match failure {
            None => out.push_str("/>\n"),
            Some(said) => {
                let _ = writeln!(out, ">\n      <failure message=\"{}\"/>\n    </testcase>", escaped(&said));
            }
        }
    }
    out.push_str("  </testsuite>\n</testsuites>\n");
    out
}
