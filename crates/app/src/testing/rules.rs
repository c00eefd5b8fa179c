//! How closely a program has to follow a recording, and what its names are called here, as the command line says it.

use std::path::PathBuf;

use clap::Args;
use sieben_model::problems::Problem;
use sieben_sim::duration;
use sieben_sim::scenario::Rules;
use sieben_sim::scenario::rules::Tolerance;
use sieben_workspace::names::{split_assignment, split_list};

use crate::failure::Failure;
use crate::tracing::scenario;

/// What the command line says about recordings.
#[derive(Args, Clone, Debug)]
pub(crate) struct RuleArguments {
    /// What a scenario calls OLD is called NEW in this program; or a file with such a line for each
    #[arg(long, value_name = "OLD=NEW|FILE")]
    map: Vec<String>,
    /// An output may come so many scans earlier or later than in the recording, or so much time
    #[arg(long, value_name = "N|DURATION")]
    within: Option<String>,
    /// A number may be so far from the recorded one, or so many percent; without NAME every number
    #[arg(long, value_name = "[NAME=]NUMBER[%]")]
    tolerance: Vec<String>,
    /// Do not compare these
    #[arg(long, value_name = "NAME,…")]
    ignore: Vec<String>,
}

/// Scans that an output may come earlier or later at most: they are kept for every output.
const WITHIN_MAX: u64 = 100_000;

impl RuleArguments {
    /// The rules. A name that none of these scenarios has is a slip of the pen.
    pub(crate) fn rules(&self, scenarios: &[PathBuf]) -> Result<Rules, Failure> {
        let mut rules = Rules::default();
        for text in &self.map {
            match text.contains('=') {
                true => {
                    let (old, new) = split_assignment(text)?;
                    rules.rename(old, new);
                }
                false => map_file(text, &mut rules)?,
            }
        }
        for text in &self.tolerance {
            let (name, number) = match text.contains('=') {
                true => split_assignment(text).map(|(name, number)| (Some(name), number))?,
                false => (None, text.as_str()),
            };
            rules.tolerate(name, Tolerance::parse(number).map_err(|message| Failure::usage(Problem::P7051, message))?);
        }
        self.ignore.iter().flat_map(|list| split_list(list)).for_each(|name| rules.ignore(name));
        let read: Vec<_> = match self.map.is_empty() && self.tolerance.is_empty() && self.ignore.is_empty() && self.within.is_none() {
            true => return Ok(rules),
            // What is wrong with a scenario is told by its test.
            false => scenarios.iter().filter_map(|path| scenario::read(path).ok()).collect(),
        };
        if let Some(within) = &self.within {
            let cycle_us = read.iter().map(sieben_sim::scenario::Scenario::cycle_us).min().unwrap_or(1).max(1);
            rules.within = scans(within, cycle_us)?;
        }
        let known = read.iter().flat_map(|scenario| scenario.names()).map(|(_, name)| name);
        match rules.unknown(known)[..] {
            [] => Ok(rules),
            [name, ..] if read.is_empty() => {
                let message = format!("there is no scenario to which the rule about `{name}` could belong");
                Err(Failure::usage(Problem::P7050, message).help("name it: `--tests plant.scenario`"))
            }
            [name, ..] => Err(Failure::usage(Problem::P7050, format!("no scenario has the name `{name}`, which a rule is about"))),
        }
    }
}

/// `3`, or `30ms` as scans of the shortest cycle.
fn scans(text: &str, cycle_us: u64) -> Result<u64, Failure> {
    let wanted = || format!("`{text}` is no distance; write a number of scans up to {WITHIN_MAX}, or a time such as `20ms`");
    let scans = match text.trim().parse::<u64>() {
        Ok(scans) => Some(scans),
        Err(_) => duration::parse(text).ok().and_then(|time| u64::try_from(time.as_micros()).ok()).map(|us| us.div_ceil(cycle_us)),
    };
    scans.filter(|&scans| scans <= WITHIN_MAX).ok_or_else(|| Failure::usage(Problem::P7051, wanted()))
}

/// Reads a file with a line `OLD=NEW` for each name; what stands behind `//` or `#` is a comment.
fn map_file(path: &str, rules: &mut Rules) -> Result<(), Failure> {
    let bytes = crate::files::read(path.as_ref())?;
    for (number, line) in (1..).zip(String::from_utf8_lossy(&bytes).trim_start_matches('\u{FEFF}').lines()) {
        let line = line.split_once("//").map_or(line, |(before, _)| before).trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        match split_assignment(line) {
            Ok((old, new)) if !old.is_empty() && !new.is_empty() => rules.rename(old, new),
            _ => {
                let message = format!("{path}:{number}: `{line}` is no `OLD=NEW`");
                return Err(Failure::usage(Problem::P7051, message));
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::scans;

    #[test]
    fn distances_are_scans_or_times() {
        for (text, wanted) in
            [("0", Some(0)), ("3", Some(3)), ("25ms", Some(3)), ("1s", Some(100)), ("soon", None), ("-1", None), ("1h", None)]
        {
            assert_eq!(scans(text, 10_000).ok(), wanted, "{text}");
        }
    }
}
