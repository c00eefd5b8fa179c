//! When scans begin and what changes between them, as `exec`, `trace` and `record` take it from the command line.

use std::time::Duration;

use clap::Args;
use sieben_cpu::Cpu;
use sieben_model::problems::Problem;
use sieben_model::symbols::SymbolTable;
use sieben_sim::duration::CYCLE_MAX;
use sieben_sim::names::Setting;
use sieben_sim::scenario::{Scenario, Times};
use sieben_workspace::duration;
use sieben_workspace::names;
use sieben_workspace::schedule::{self, Changes, Schedule};
use sieben_workspace::settings::Settings;

use crate::duration::{cycle_argument, duration_argument};
use crate::failure::Failure;

/// What is set from outside in a run in virtual time.
#[derive(Args, Clone, Debug)]
pub(crate) struct ChangeArguments {
    /// Set before the first scan: an address, a symbol, DB1.name, ACCU1 to ACCU4, AR1, AR2 or STW
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Set at a time, seen by the next scan
    #[arg(long, value_names = ["T", "NAME=VALUE"], num_args = 2)]
    at: Vec<String>,
}

impl ChangeArguments {
    /// The changes with their times, in their order, as names of this CPU; what is set before the first scan is set at 0.
    pub(crate) fn timed(&self, symbols: &SymbolTable, cpu: &Cpu) -> Result<Vec<(Duration, Setting)>, Failure> {
        let set = self.set.iter().map(|text| Ok((Duration::ZERO, names::setting(text, symbols, cpu)?)));
        let mut all = set.collect::<Result<Vec<_>, Failure>>()?;
        all.extend(timed(&self.at, symbols, cpu)?);
        Ok(all)
    }
}

/// Scans and changes of a run in virtual time.
#[derive(Args, Clone, Debug)]
pub(crate) struct ScheduleArguments {
    #[command(flatten)]
    change: ChangeArguments,
    /// Run so many scans [default: 1 with exec, 100 with trace, without end with record]
    #[arg(long, value_name = "N", conflicts_with_all = ["duration", "scan_at"], value_parser = clap::value_parser!(u64).range(1..))]
    scans: Option<u64>,
    /// Run all scans that begin before this time
    #[arg(long = "for", value_name = "DURATION", id = "duration", conflicts_with = "scan_at", allow_hyphen_values = true, value_parser = duration_argument)]
    duration: Option<Duration>,
    /// Time from one scan to the next [default: the project's, else 10ms]
    #[arg(long, value_name = "DURATION", conflicts_with = "scan_at", allow_hyphen_values = true, value_parser = cycle_argument)]
    cycle: Option<Duration>,
    /// Scan exactly at these times instead of every cycle
    #[arg(long, value_name = "T1,T2,…", value_delimiter = ',', allow_hyphen_values = true, value_parser = duration_argument)]
    scan_at: Vec<Duration>,
}

impl ScheduleArguments {
    /// Whether nothing is said about when scans begin or what changes.
    pub(crate) fn is_empty(&self) -> bool {
        self.change.set.is_empty()
            && self.change.at.is_empty()
            && self.scan_at.is_empty()
            && (self.scans, self.duration, self.cycle) == (None, None, None)
    }

    /// Whether it is said how many scans there are.
    pub(crate) fn has_end(&self) -> bool {
        self.scans.is_some() || self.duration.is_some() || !self.scan_at.is_empty()
    }

    /// When the scans begin; `usual` is their number if nothing is said.
    pub(crate) fn schedule(&self, settings: &Settings, usual: u64) -> Result<Schedule, Failure> {
        if !self.scan_at.is_empty() {
            if let Some(pair) = self.scan_at.windows(2).find(|pair| pair[1] < pair[0]) {
                let (late, early) = (duration::show(pair[0]), duration::show(pair[1]));
                return Err(Failure::usage(
                    Problem::P7009,
                    format!("time does not run backwards: {early} stands behind {late} in `--scan-at`"),
                ));
            }
            let from_zero = std::iter::once(&Duration::ZERO).chain(&self.scan_at).zip(&self.scan_at);
            if let Some((before, at)) = from_zero.into_iter().find(|(before, at)| at.saturating_sub(**before) > CYCLE_MAX) {
                let (before, at) = (duration::show(*before), duration::show(*at));
                let message = format!("between {before} and {at} in `--scan-at` lie more than 24 hours, the longest cycle");
                return Err(Failure::usage(Problem::P7009, message).help("scan at times between them, too"));
            }
            return Ok(Schedule::At(self.scan_at.clone()));
        }
        let cycle = schedule::cycle(self.cycle, settings);
        let scans = match self.duration {
            None => self.scans.unwrap_or(usual),
            Some(_) if cycle.is_zero() => {
                return Err(Failure::usage(Problem::P7009, "with a cycle of 0 virtual time stands still, and `--for` never ends"));
            }
            Some(duration) => u64::try_from(duration.as_micros().div_ceil(cycle.as_micros())).unwrap_or(u64::MAX).max(1),
        };
        Ok(Schedule::Cyclic { cycle, scans })
    }

    /// The run as a scenario without expectations; without a number of scans it is endless.
    pub(crate) fn scenario(&self, settings: &Settings, symbols: &SymbolTable, cpu: &Cpu) -> Result<Scenario, Failure> {
        let times = match self.schedule(settings, u64::MAX)? {
            Schedule::Cyclic { cycle, .. } if cycle.is_zero() => {
                return Err(Failure::usage(Problem::P7009, "with a cycle of 0 virtual time stands still").help("give `--cycle 10ms`"));
            }
            Schedule::Cyclic { cycle, scans } => Times::Cyclic { cycle_us: duration::micros(cycle), scans },
            Schedule::At(times) => Times::At(times.into_iter().map(duration::micros).collect()),
        };
        let set = self.change.set.iter().map(|text| names::setting(text, symbols, cpu).map(Into::into)).collect::<Result<_, _>>()?;
        let at = timed(&self.change.at, symbols, cpu)?;
        let at = at.into_iter().map(|(time, setting)| (duration::micros(time), vec![setting.into()])).collect();
        Ok(Scenario::plain(times, set, at))
    }

    /// What changes, as names of this CPU.
    pub(crate) fn changes(&self, symbols: &SymbolTable, cpu: &Cpu) -> Result<Changes, Failure> {
        let set = self.change.set.iter().map(|text| names::setting(text, symbols, cpu)).collect::<Result<_, _>>()?;
        Ok(Changes::new(set, timed(&self.change.at, symbols, cpu)?))
    }
}

/// The changes of `--at` in the order of their times; those of the same time as they were written.
fn timed(words: &[String], symbols: &SymbolTable, cpu: &Cpu) -> Result<Vec<(Duration, Setting)>, Failure> {
    let mut timed = Vec::new();
    for pair in words.chunks_exact(2) {
        let time = sieben_sim::duration::parse(&pair[0]).map_err(|message| Failure::usage(Problem::P7005, message))?;
        let setting = names::setting(&pair[1], symbols, cpu)?;
        if setting.name.is_register() {
            return Err(
                Failure::usage(Problem::P7003, format!("`{}`: a register can only be set for the first scan", pair[1])).help("use `--set`")
            );
        }
        timed.push((time, setting));
    }
    timed.sort_by_key(|(time, _)| *time);
    Ok(timed)
}
