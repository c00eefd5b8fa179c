//! `sieben demo`: a dosing plant with its controller, live in the terminal.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use clap::{Args, ValueEnum};
use sieben_lang::symbols::assignment;
use sieben_workspace::Speed;

use crate::duration::duration_argument;
use crate::failure::{Exit, Failure};
use crate::palette::Palette;
use crate::screen::{self, CYCLE_US, Session, clock, thousands};
use crate::screen::{Entry, Event};
use crate::{output, terminal};

/// Longest sleep without a look at Ctrl-C.
const STEP: Duration = Duration::from_millis(50);

/// A demo plant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Plant {
    /// Dosing of a liquid: START, STOP, flow meter, valve, BCD display
    #[default]
    Dosing,
}

#[derive(Args, Default)]
pub(crate) struct Arguments {
    /// Which plant
    #[arg(value_enum, default_value = "dosing", value_name = "NAME")]
    name: Plant,
    /// End after this time of the plant
    #[arg(long = "for", value_name = "DURATION", id = "duration", allow_hyphen_values = true, value_parser = duration_argument)]
    time: Option<Duration>,
    /// How fast time goes: 1x, 10x, 0.5x, or max
    #[arg(long, value_name = "FACTOR", allow_hyphen_values = true, value_parser = Speed::parse)]
    speed: Option<Speed>,
}

/// Runs the demo: with a picture on a terminal, else with one line per change.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let Plant::Dosing = arguments.name;
    let mut session = Session::new();
    let interrupted = terminal::interrupted();
    let speed = arguments.speed.unwrap_or(Speed::Factor(1.0));
    if terminal::has_screen() {
        let factor = if let Speed::Factor(factor) = speed { factor } else { f64::INFINITY };
        screen::run(&mut session, factor, arguments.time, Palette::wanted(), &interrupted).map_err(|error| terminal::broken(&error))?;
        output::print(&farewell(&session))?;
    } else {
        print_changes(&mut session, speed, arguments.time, &interrupted)?;
    }
    Ok(Exit::Success)
}

/// One sentence about what was seen.
fn farewell(session: &Session) -> String {
    let scans = session.scans();
    format!(
        "{} {} in {} of the plant, {:.1} litres through the valve.\nThe program is in examples/dosing; `sieben new my-plant --example dosing` copies it.\n",
        thousands(scans),
        if scans == 1 { "scan" } else { "scans" },
        clock(session.time_ms()),
        session.plant().tank.litres_delivered(),
    )
}

/// The demo without a terminal.
fn print_changes(session: &mut Session, speed: Speed, time: Option<Duration>, interrupted: &AtomicBool) -> Result<(), Failure> {
    output::print(&format!(
        "Sieben demo: dosing of a liquid, CPU {}, cycle {} ms. One line per change; Ctrl-C ends it.\n\n{}\n",
        session.cpu().cpu_type().name,
        CYCLE_US / 1_000,
        assignment::text(session.symbols())
    ))?;
    let begin = Instant::now();
    let mut printed = session.changes.count;
    let mut plant_time = Duration::ZERO;
    while !interrupted.load(Ordering::Relaxed) && time.is_none_or(|time| plant_time < time) {
        session.scan(false);
        plant_time += Duration::from_micros(CYCLE_US);
        let new = (session.changes.count - printed) as usize;
        printed = session.changes.count;
        let entries = &session.changes.entries;
        let lines: String = entries.iter().skip(entries.len().saturating_sub(new)).map(line).collect();
        if !lines.is_empty() {
            output::print(&lines)?;
        }
        if let Speed::Factor(factor) = speed {
            wait_until(begin + plant_time.div_f64(factor), interrupted);
        }
    }
    output::print(&farewell(session))
}

/// Waits in short steps, so that Ctrl-C is heard at any speed.
fn wait_until(due: Instant, interrupted: &AtomicBool) {
    while !interrupted.load(Ordering::Relaxed) {
        let left = due.saturating_duration_since(Instant::now());
        if left.is_zero() {
            break;
        }
        std::thread::sleep(left.min(STEP));
    }
}

/// `scan 1,204 (12.04 s): Q 0.0 0→1 (Dosing valve)`.
fn line(entry: &Entry) -> String {
    let place = format!("scan {} ({})", thousands(entry.scan), clock(entry.time_ms));
    match &entry.event {
        Event::Change { address, values, comment } if comment.is_empty() => format!("{place}: {address} {values}\n"),
        Event::Change { address, values, comment } => format!("{place}: {address} {values} ({comment})\n"),
        Event::Note(text) => format!("{place}: {text}\n"),
    }
}
