//! Findings as JSON, with lines and columns.

use std::collections::BTreeMap;

use serde_json::{Value, json};
use sieben_model::diagnostic::{Certainty, Severity};
use sieben_model::source::{FileId, Span};

use super::{Finding, Origin, Texts, clamp, help_of};

/// Findings as programs read them.
pub fn to_json(findings: &[Finding], texts: &Texts) -> Value {
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
