//! A report for the terminal.

use std::fmt::Write as _;

use serde_json::Value as Json;

use super::Report;
use crate::campaign::{said, summary};

/// The report as lines.
pub(crate) fn text(report: &Report) -> String {
    let run = report.file.tally.run();
    let mut text = format!("{}: {} of {}\n", report.name(), run, said::scenarios(report.file.head.scenarios));
    let properties = report.properties();
    let measures: Vec<&Json> = report.file.summary["measures"].as_array().into_iter().flatten().collect();
    let names = properties.iter().map(|(_, name, ..)| name.chars().count());
    let width = names.chain(measures.iter().map(|measure| measure["name"].as_str().unwrap_or_default().chars().count())).max().unwrap_or(0);
    for (kind, name, said, _) in &properties {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {kind:10}  {name:width$}  {said}");
    }
    for measure in measures {
        let unit = measure["unit"].as_str().map_or_else(String::new, |unit| format!(" {unit}"));
        let number = |key: &str| measure[key].as_f64().map_or_else(|| "?".to_owned(), said::number);
        let (of, name) = (measure["of"].as_str().unwrap_or_default(), measure["name"].as_str().unwrap_or_default());
        let said = match measure["count"].as_u64() {
            Some(0) | None => "no value".to_owned(),
            _ => format!(
                "{}{unit} (scenario {}) to {}{unit} (scenario {}), mean {}{unit}",
                number("min"),
                measure["min_scenario"],
                number("max"),
                measure["max_scenario"],
                number("mean")
            ),
        };
        let _ = writeln!(text, "  {of:10}  {name:width$}  {said}");
    }
    for row in &report.listed {
        let property = row.property.and_then(|index| properties.get(index)).map_or_else(String::new, |(_, name, ..)| format!(", `{name}`"));
        let message = row.message.as_ref().map_or_else(String::new, |message| format!(": {message}"));
        let _ = writeln!(text, "  scenario {}: {}{property}{message}", row.scenario, row.verdict.word());
    }
    text.extend(summary::missing(&report.there(), report.file.head.scenarios));
    let _ = writeln!(text, "{}", summary::counts(&report.file.summary));
    text
}
