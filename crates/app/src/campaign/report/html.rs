//! A report as one page that needs no network.

use std::fmt::Write as _;

use serde_json::Value as Json;
use sieben_campaign::row::Verdict;
use sieben_workspace::xml::escaped;

use super::{Report, charts};
use crate::campaign::said;

const STYLE: &str = "body{font:15px/1.5 system-ui,sans-serif;max-width:62rem;margin:2rem auto;padding:0 1rem;color:#1c2430;background:#fff}\
h1{font-size:1.5rem}h2{font-size:1.15rem;margin-top:2rem}table{border-collapse:collapse}td,th{padding:.25rem .8rem .25rem 0;text-align:left;vertical-align:top}\
.good{color:#1f7a3d}figure{display:inline-block;width:460px;max-width:100%;margin:.5rem 1rem .5rem 0}\
figcaption{font-weight:600}.charts svg{width:100%}pre{overflow-x:auto;background:#f3f5f8;padding:.8rem;border-radius:4px}.said{white-space:pre-wrap}.diagram{overflow-x:auto}code{word-break:break-all}\
@media(prefers-color-scheme:dark){body{color:#dde3ea;background:#14181d}pre{background:#1f252d}.good{color:#6fd08c}.diagram{background:#fff}}";

/// The report as HTML.
pub(crate) fn page(report: &Report) -> String {
    let name = escaped(report.name());
    let mut out = format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\"><title>{name}</title><style>{STYLE}{}@media(prefers-color-scheme:dark){{{}}}</style></head><body>\n",
        charts::STYLE,
        charts::DARK
    );
    let verdict = if report.holds() { "<span class=\"good\">held</span>" } else { "<span class=\"fail\">did not hold</span>" };
    let run = report.file.tally.run();
    // Writing to a string cannot fail.
    let _ = writeln!(out, "<h1>{name}: {verdict}</h1>\n<p>{run} of {}</p>", said::scenarios(report.file.head.scenarios));
    verdicts(report, &mut out);
    failures(report, &mut out);
    drawn(report, &mut out);
    let head = &report.file.head;
    let _ = writeln!(
        out,
        "<h2>The file of the campaign</h2>\n<pre>{}</pre>\n<p>campaign <code>{}</code><br>program <code>{}</code><br>seed {}</p>\n</body></html>",
        escaped(&report.file.spec).replace("&#10;", "\n"),
        head.campaign,
        head.program,
        head.seed
    );
    out
}

fn verdicts(report: &Report, out: &mut String) {
    out.push_str("<table>\n");
    for verdict in Verdict::ALL.into_iter().filter(|&verdict| report.count(verdict) > 0) {
        let class = if verdict == Verdict::Pass { "good" } else { "fail" };
        let _ = writeln!(out, "<tr><td class=\"{class}\">{}</td><td>{}</td></tr>", verdict.word(), report.count(verdict));
    }
    out.push_str("</table>\n<h2>Properties</h2>\n<table>\n");
    for (kind, name, said, holds) in report.properties() {
        let class = if holds { "good" } else { "fail" };
        let _ = writeln!(out, "<tr><td>{kind}</td><td>{}</td><td class=\"{class}\">{}</td></tr>", escaped(&name), escaped(&said));
    }
    out.push_str("</table>\n");
    let measures: Vec<&Json> = report.file.summary["measures"].as_array().into_iter().flatten().collect();
    if measures.is_empty() {
        return;
    }
    out.push_str("<h2>Measures</h2>\n<table>\n<tr><th></th><th></th><th>least</th><th>greatest</th><th>mean</th></tr>\n");
    for measure in measures {
        let text = |key: &str| escaped(measure[key].as_str().unwrap_or_default());
        let number =
            |key: &str| measure[key].as_f64().map_or_else(|| "–".to_owned(), |value| format!("{} {}", said::number(value), text("unit")));
        let at = |key: &str| measure[key].as_u64().map_or_else(String::new, |number| format!(" (scenario {number})"));
        let _ = writeln!(
            out,
            "<tr><td>{}</td><td>{}</td><td>{}{}</td><td>{}{}</td><td>{}</td></tr>",
            text("of"),
            text("name"),
            number("min"),
            at("min_scenario"),
            number("max"),
            at("max_scenario"),
            number("mean")
        );
    }
    out.push_str("</table>\n");
}

/// What failed, made small, with its diagram where it lies beside the result; else the rows.
fn failures(report: &Report, out: &mut String) {
    if report.listed.is_empty() {
        return;
    }
    out.push_str("<h2>Failures</h2>\n");
    for failure in report.run["failures"].as_array().into_iter().flatten() {
        let text = |key: &str| failure[key].as_str().unwrap_or_default();
        let _ = writeln!(
            out,
            "<h3>Scenario {}: {}</h3>\n<pre class=\"said\">{}</pre>",
            failure["scenario"],
            escaped(text("what")),
            escaped(text("reasons")).replace("&#10;", "\n")
        );
        if !text("svg").is_empty() {
            let _ = writeln!(out, "<div class=\"diagram\"><img alt=\"timing diagram\" src=\"{}\"></div>", picture(text("svg")));
        } else if !text("diagram").is_empty() {
            let _ = writeln!(out, "<pre>{}</pre>", escaped(text("diagram")).replace("&#10;", "\n"));
        }
        if !text("file").is_empty() {
            let _ = writeln!(out, "<p><code>{}</code></p>", escaped(text("file")));
        }
    }
    out.push_str("<table>\n");
    let properties = report.properties();
    for row in &report.listed {
        let what = row
            .property
            .and_then(|index| properties.get(index))
            .map_or_else(|| row.message.clone().unwrap_or_default(), |(_, name, ..)| name.clone());
        let at = row.at.map_or_else(String::new, |at| format!("after {at}"));
        let _ = writeln!(
            out,
            "<tr><td>scenario {}</td><td class=\"fail\">{}</td><td>{}</td><td>{at}</td></tr>",
            row.scenario,
            row.verdict.word(),
            escaped(&what)
        );
    }
    out.push_str("</table>\n");
}

fn drawn(report: &Report, out: &mut String) {
    let all: Vec<String> = report.charts().iter().map(charts::Chart::figure).collect();
    if !all.is_empty() {
        let _ = writeln!(out, "<h2>Charts</h2>\n<div class=\"charts\">\n{}\n</div>", all.join("\n"));
    }
}

/// A picture as an address that holds all of it: what is in such a picture cannot do anything in the page.
fn picture(svg: &str) -> String {
    let mut address = String::from("data:image/svg+xml,");
    for byte in svg.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'=' | b'-' | b'.' | b',' | b';' | b'(' | b')' => address.push(char::from(byte)),
            // Writing to a string cannot fail.
            _ => drop(write!(address, "%{byte:02X}")),
        }
    }
    address
}
