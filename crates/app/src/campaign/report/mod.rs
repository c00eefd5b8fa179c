//! What a result says, for people and for other programs: all of it is made of the file alone, and of what lies beside it.

mod charts;
mod heat_map;
mod html;
mod junit;
mod text;

pub(crate) use html::page;
pub(crate) use junit::junit;
pub(crate) use text::text;

use serde_json::Value as Json;
use sieben_campaign::ranges::Ranges;
use sieben_campaign::row::{Row, Verdict};
use sieben_campaign::spec::Value;

use super::files::ResultFile;
use super::{said, summary};
use crate::failure::Failure;
use charts::Chart;
use heat_map::Grid;

/// Rows that are drawn; the counts are of all.
const ROWS_MAX: usize = 200_000;
/// Heat maps of one kind.
const HEAT_MAPS_MAX: usize = 2;
/// Measures with charts.
const MEASURES_MAX: usize = 12;
/// Charts of a measure over parameters.
const SCATTERS_MAX: usize = 4;
/// Scenarios that did not pass and are listed.
const LISTED_MAX: usize = 20;

/// A result, ready to be shown.
pub(crate) struct Report {
    pub(crate) file: ResultFile,
    /// How it was run, if that lies beside it: with what failed, made small.
    run: Json,
    /// Numbers of rows, column by column.
    parameters: Vec<Column>,
    measures: Vec<Column>,
    /// Whether each of these rows passed.
    passed: Vec<bool>,
    /// The first that did not pass.
    listed: Vec<Row>,
}

/// A column of numbers.
struct Column {
    name: String,
    unit: Option<String>,
    values: Vec<Option<f64>>,
}

impl Column {
    /// The name with its unit.
    fn label(&self) -> String {
        self.unit.as_ref().map_or_else(|| self.name.clone(), |unit| format!("{} in {unit}", self.name))
    }
}

impl Report {
    /// Reads a result with what lies beside it.
    ///
    /// # Errors
    /// It cannot be read.
    pub(crate) fn read(file: ResultFile) -> Result<Self, Failure> {
        let column = |(name, unit)| Column { name, unit, values: Vec::new() };
        let mut parameters: Vec<Column> = file.columns.named("p.").into_iter().map(column).collect();
        let mut measures: Vec<Column> = file.columns.named("m.").into_iter().map(column).collect();
        let (mut passed, mut listed) = (Vec::new(), Vec::new());
        for rows in file.rows()? {
            for row in rows? {
                if row.verdict != Verdict::Pass && listed.len() < LISTED_MAX {
                    listed.push(row.clone());
                }
                if passed.len() < ROWS_MAX {
                    passed.push(row.verdict == Verdict::Pass);
                    for (column, value) in parameters.iter_mut().zip(&row.parameters) {
                        column.values.push(if let Value::Number(number) = value { Some(*number) } else { None });
                    }
                    for (column, value) in measures.iter_mut().zip(&row.measures) {
                        column.values.push(*value);
                    }
                }
            }
        }
        // It says only how it was run: a result without it is whole.
        let run = std::fs::read(super::files::beside(&file.path)).ok().and_then(|bytes| serde_json::from_slice(&bytes).ok());
        Ok(Self { file, run: run.unwrap_or(Json::Null), parameters, measures, passed, listed })
    }

    /// What the campaign is called.
    fn name(&self) -> &str {
        self.file.summary["name"].as_str().unwrap_or("campaign")
    }

    fn count(&self, verdict: Verdict) -> u64 {
        self.file.tally.of(verdict)
    }

    /// Scenarios that it is of.
    fn there(&self) -> Ranges {
        self.file.there()
    }

    /// What each property of the file came to: kind, name, what is said of it, and whether it held.
    fn properties(&self) -> Vec<(String, String, String, bool)> {
        let text = |json: &Json| json.as_str().unwrap_or_default().to_owned();
        let all = self.file.summary["properties"].as_array().into_iter().flatten();
        all.map(|property| {
            let (kind, name) = (text(&property["kind"]), text(&property["name"]));
            let first = property["first"].as_u64().unwrap_or(0);
            let several = |key: &str| said::scenarios(property[key].as_u64().unwrap_or(0));
            let (said, holds) = match (kind.as_str(), property["came"].as_u64(), property["broken"].as_u64()) {
                ("sometimes", Some(0), _) => ("never came".to_owned(), false),
                ("sometimes", ..) => (format!("came in {}, first in {first}", several("came")), true),
                (_, _, Some(0)) => ("holds".to_owned(), true),
                _ => (format!("broken in {}, first in {first}", several("broken")), false),
            };
            (kind, name, said, holds)
        })
        .collect()
    }

    /// Whether all scenarios are there, all passed, and what has to come sometimes came.
    pub(crate) fn holds(&self) -> bool {
        summary::holds(&self.file.summary, &self.there(), self.file.head.scenarios)
    }

    /// What can be drawn of it.
    fn charts(&self) -> Vec<Chart> {
        let varied: Vec<&Column> = self.parameters.iter().filter(|column| column.values.iter().any(Option::is_some)).collect();
        // The sweeps come first: two of them make a grid.
        let pairs = varied.iter().enumerate().flat_map(|(index, up)| varied[index + 1..].iter().map(move |across| (*across, *up)));
        let grids: Vec<Grid<'_>> = pairs.filter_map(|(across, up)| Grid::of(across, up)).take(HEAT_MAPS_MAX).collect();
        let mut all: Vec<Chart> = Vec::new();
        if self.passed.contains(&false) {
            all.extend(grids.iter().map(|grid| grid.failures(&self.passed)));
        }
        for (measure, tally) in self.measures.iter().zip(&self.file.tally.measures).take(MEASURES_MAX) {
            all.extend(grids.iter().filter_map(|grid| grid.means(measure)));
            let buckets: Vec<_> = tally.histogram.buckets().collect();
            all.extend(charts::histogram(measure, &buckets));
            all.extend(varied.iter().filter_map(|parameter| charts::scatter(parameter, measure, &self.passed)).take(SCATTERS_MAX));
        }
        all
    }

    /// Its pictures, each with the name of its file: charts, and timing diagrams of what failed.
    pub(crate) fn pictures(&self) -> Vec<(String, String)> {
        let charts = self.charts().into_iter().map(|chart| (said::plain(&chart.title), chart.file()));
        let failures = self.run["failures"].as_array().into_iter().flatten();
        let diagrams = failures.filter_map(|failure| {
            let (what, svg) = (failure["what"].as_str()?, failure["svg"].as_str().filter(|svg| !svg.is_empty())?);
            Some((format!("{}-{}", said::plain(what), failure["scenario"]), svg.to_owned()))
        });
        let mut all: Vec<(String, String)> = Vec::new();
        for (name, svg) in charts.chain(diagrams) {
            let again = all
                .iter()
                .filter(|(known, _)| *known == name || known.strip_prefix(&name).is_some_and(|rest| rest.starts_with("--")))
                .count();
            all.push((if again == 0 { name } else { format!("{name}--{}", again + 1) }, svg));
        }
        all.into_iter().map(|(name, svg)| (format!("{name}.svg"), svg)).collect()
    }

    /// For other programs: the summary with what identifies the campaign.
    pub(crate) fn json(&self) -> Json {
        let mut json = self.file.summary.clone();
        let head = &self.file.head;
        json["campaign"] = head.campaign.clone().into();
        json["program"] = head.program.clone().into();
        json["seed"] = head.seed.into();
        json["scenarios"] = head.scenarios.into();
        json["run"] = self.file.tally.run().into();
        json
    }
}
