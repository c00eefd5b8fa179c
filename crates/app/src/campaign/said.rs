//! What is said about a campaign: how many scenarios it has, and what they came to.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Duration;

use serde_json::{Value as Json, json};
use sieben_campaign::row::{Row, Verdict};
use sieben_campaign::spec::{PropertyKind, Value};
use sieben_workspace::campaign::Campaign;
use sieben_workspace::duration;

use super::collected::Collected;

/// A run that has ended.
pub(crate) struct Run<'a> {
    /// The campaign.
    pub(crate) campaign: &'a Campaign,
    /// Its name.
    pub(crate) name: &'a str,
    /// Its file, as it was given.
    pub(crate) file: &'a str,
    /// How many scenarios were asked for.
    pub(crate) asked: u64,
    /// What came of those that were run.
    pub(crate) collected: &'a Collected,
    /// Scenarios that failed and were written down, with their files.
    pub(crate) written: &'a [(u64, PathBuf)],
    /// How long it took.
    pub(crate) took: Duration,
}

/// What a worker is called: its computer and process.
#[cfg(feature = "nats")]
pub(crate) fn computer() -> String {
    let name = rustix::system::uname().nodename().to_string_lossy().into_owned();
    format!("{name}/{}", std::process::id())
}

/// `1 scenario`, `128 scenarios`.
pub(crate) fn scenarios(count: u64) -> String {
    several(count, "scenario")
}

/// `1 scan`, `3 scans`.
pub(crate) fn several(count: u64, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// Characters of what is said in the name of a file.
const NAME_MAX: usize = 60;

/// What is said as the name of a file: `delta-onto-star`.
pub(crate) fn plain(text: &str) -> String {
    let mut plain = String::new();
    for c in text.chars().take(NAME_MAX) {
        match c {
            c if c.is_alphanumeric() => plain.push(c),
            _ if plain.ends_with('-') => {}
            _ => plain.push('-'),
        }
    }
    plain.trim_matches('-').to_owned()
}

/// A number without the digits that say nothing: whole numbers as they are, others with six digits.
pub(crate) fn number(value: f64) -> String {
    let value = if value.fract() == 0.0 { value } else { format!("{value:.5e}").parse().unwrap_or(value) };
    let short = format!("{value:.6}");
    let short = short.trim_end_matches('0').trim_end_matches('.');
    if value != 0.0 && (value.abs() >= 1e12 || value.abs() < 1e-4) { format!("{value:.3e}") } else { short.to_owned() }
}

fn with_unit(value: f64, unit: Option<&str>) -> String {
    unit.map_or_else(|| number(value), |unit| format!("{} {unit}", number(value)))
}

/// A value as the file has it.
pub(crate) fn value(value: &Value) -> String {
    match value {
        Value::Boolean(value) => value.to_string(),
        Value::Number(value) => number(*value),
        Value::Text(text) => text.clone(),
    }
}

impl Run<'_> {
    /// For people.
    pub(crate) fn text(&self) -> String {
        let Self { campaign, name, took, .. } = self;
        let tally = &self.collected.tally;
        let spec = &campaign.spec;
        let run = if tally.run() == self.asked { scenarios(self.asked) } else { format!("{} of {}", tally.run(), scenarios(self.asked)) };
        let mut text = format!("{name}: {run}, {} in {}\n", several(tally.scans, "scan"), duration::show(rounded(*took)));
        let wide = |names: &mut dyn Iterator<Item = usize>| names.max().unwrap_or(0);
        let names =
            wide(&mut spec.properties.iter().map(|p| p.name.chars().count()).chain(spec.measures.iter().map(|m| m.name.chars().count())));
        for (property, of) in spec.properties.iter().zip(&tally.properties) {
            let came = match (property.kind, of.came, of.broken, of.first) {
                (PropertyKind::Sometimes, 0, ..) => "never came".to_owned(),
                (PropertyKind::Sometimes, came, _, Some(first)) => format!("came in {}, first in {first}", scenarios(came)),
                (_, _, broken, Some(first)) => format!("broken in {}, first in {first}", scenarios(broken)),
                _ if tally.run() == 0 => "not looked at".to_owned(),
                _ if tally.run() < self.asked => "holds so far".to_owned(),
                _ => "holds".to_owned(),
            };
            let _ = writeln!(text, "  {:10}  {:names$}  {came}", property.kind.word(), property.name);
        }
        for (measure, of) in spec.measures.iter().zip(&tally.measures) {
            let unit = measure.unit.as_deref();
            let said = match (of.least, of.most) {
                (Some((least, at)), Some((most, most_at))) => format!(
                    "{} (scenario {at}) to {} (scenario {most_at}), mean {}",
                    with_unit(least, unit),
                    with_unit(most, unit),
                    with_unit(of.mean().unwrap_or(f64::NAN), unit)
                ),
                _ => "no value".to_owned(),
            };
            let _ = writeln!(text, "  {:10}  {:names$}  {said}", measure.of.word(), measure.name);
        }
        if let Some(first) = &self.collected.first {
            text.push_str(&self.first(first));
        }
        for (number, path) in self.written {
            let _ = writeln!(text, "  `{}` is scenario {number}, made small: `sieben test` runs it from now on", path.display());
        }
        let others = Verdict::ALL.iter().filter(|&&verdict| verdict != Verdict::Pass && tally.of(verdict) > 0);
        let counts: String = others.map(|&verdict| format!(", {} {}", tally.of(verdict), ended_as(verdict))).collect();
        let _ = writeln!(text, "{} passed{counts}", tally.of(Verdict::Pass));
        text
    }

    /// The first scenario that did not pass.
    fn first(&self, row: &Row) -> String {
        let spec = &self.campaign.spec;
        let mut text = format!("First that did not pass: scenario {}", row.scenario);
        if let Some(property) = row.property.and_then(|index| spec.properties.get(index)) {
            let _ = write!(text, ", `{}`", property.name);
        }
        if let Some(at) = row.at {
            let _ = write!(text, ", after scan {} at {}", at.scan, duration::show(Duration::from_micros(at.time_us)));
        }
        text.push('\n');
        if let Some(message) = &row.message {
            let _ = writeln!(text, "  {message}");
        }
        if spec.exhaustive.is_some() {
            let bits = self.campaign.bits();
            let combination = self.campaign.given(row.scenario).point.combination;
            let set: Vec<&str> = bits.enumerate().filter(|(index, _)| combination >> index & 1 != 0).map(|(_, name)| name).collect();
            let shown = if set.is_empty() { "none".to_owned() } else { set.join(", ") };
            let _ = writeln!(text, "  inputs that are 1: {shown}");
        }
        for (parameter, given) in spec.parameters().zip(&row.parameters) {
            let unit = parameter.unit.map_or(String::new(), |unit| format!(" {unit}"));
            let _ = writeln!(text, "  {} = {}{unit}", parameter.name, value(given));
        }
        for (fault, how) in spec.faults.iter().zip(&row.faults) {
            if let Some(how) = how {
                let _ = writeln!(text, "  fault {} {how}", fault.signal.text);
            }
        }
        let _ = writeln!(text, "  `sieben campaign show {} {}` prints it as a scenario", self.file, row.scenario);
        text
    }

    /// For programs: the object that a run ends with.
    pub(crate) fn json(&self) -> Json {
        let tally = &self.collected.tally;
        let spec = &self.campaign.spec;
        let first = self.collected.first.as_ref().map(|row| {
            json!({
                "scenario": row.scenario,
                "property": row.property.and_then(|index| spec.properties.get(index)).map(|property| &property.name),
                "verdict": row.verdict.word(),
                "scan": row.at.map(|at| at.scan),
                "at_us": row.at.map(|at| at.time_us),
                "message": row.message,
                "file": self.written.iter().find(|(number, _)| *number == row.scenario).map(|(_, path)| path.display().to_string()),
            })
        });
        let property = |(index, of): (usize, &sieben_campaign::tally::PropertyTally)| {
            let property = &spec.properties[index];
            json!({ "kind": property.kind.word(), "name": property.name, "broken": of.broken, "came": of.came, "first": of.first })
        };
        let measure = |(index, of): (usize, &sieben_campaign::tally::MeasureTally)| {
            let measure = &spec.measures[index];
            json!({
                "name": measure.name, "of": measure.of.word(), "unit": measure.unit, "count": of.count,
                "min": of.least.map(|(value, _)| value), "min_scenario": of.least.map(|(_, at)| at),
                "max": of.most.map(|(value, _)| value), "max_scenario": of.most.map(|(_, at)| at),
                "mean": of.mean(),
            })
        };
        let mut object = json!({
            "campaign": self.campaign.identity.campaign,
            "program": self.campaign.identity.program,
            "name": self.name,
            "seed": spec.seed,
            "scenarios": self.asked,
            "run": tally.run(),
            "resumed": self.collected.resumed,
        });
        for verdict in Verdict::ALL {
            object[verdict.word()] = tally.of(verdict).into();
        }
        object["duplicates"] = self.collected.duplicates.into();
        object["margin"] = tally.margin.map(|(margin, _)| margin).into();
        object["margin_scenario"] = tally.margin.map(|(_, at)| at).into();
        object["result_hash"] = format!("{:016x}", tally.hash).into();
        object["seconds"] = self.took.as_secs_f64().into();
        object["first_failure"] = first.into();
        object["properties"] = tally.properties.iter().enumerate().map(property).collect();
        object["measures"] = tally.measures.iter().enumerate().map(measure).collect();
        object
    }
}

fn rounded(took: Duration) -> Duration {
    Duration::from_millis(u64::try_from(took.as_millis()).unwrap_or(u64::MAX))
}

fn ended_as(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Pass => "passed",
        Verdict::Fail => "failed",
        Verdict::Stop => "went to STOP",
        Verdict::Limit => "did not end",
        Verdict::Error => "could not be judged",
    }
}

/// What `list` says of a column.
pub(crate) fn columns(campaign: &Campaign) -> Vec<(String, String)> {
    let spec = &campaign.spec;
    let mut all: Vec<(String, String)> = campaign.bits().map(|name| (format!("p.{name}"), "0 and 1".to_owned())).collect();
    for sweep in &spec.sweep {
        let ends = sweep.values.first().zip(sweep.values.last());
        let of = ends.map_or(String::new(), |(first, last)| format!(", {} to {}", value(first), value(last)));
        all.push((format!("p.{}", sweep.name.text), format!("{}{of}", several(sweep.values.len() as u64, "value"))));
    }
    let drawn = spec.parameters().skip(spec.sweep.len());
    all.extend(drawn.map(|draw| (format!("p.{}", draw.name), "drawn".to_owned())));
    all.extend(spec.faults.iter().map(|row| (format!("f.{}", row.stream), format!("with a chance of {}", number(row.chance)))));
    all.extend(spec.measures.iter().map(|measure| (format!("m.{}", measure.name), measure.of.word().to_owned())));
    all
}
