//! `sieben demo`: a dosing plant with its controller, live in the terminal.

use std::sync::Arc;
use std::time::Duration;

use clap::{Args, ValueEnum};
use sieben_lang::symbols::assignment;
use sieben_workspace::Speed;

use crate::control::Server;
use crate::duration::duration_argument;
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::page::Answers;
use crate::palette::Palette;
use crate::screen::{self, CYCLE_US, Entry, Event, Outcome, Session, clock, thousands};
use crate::servers::{Prepared, PreparedPage, ServerArguments, Servers, Usually};
use crate::{output, terminal};

/// The speeds of the picture.
const FACTORS: (f64, f64) = (0.1, 100.0);

/// A demo plant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Plant {
    /// Dosing of a liquid: START, STOP, flow meter, valve, BCD display
    #[default]
    Dosing,
}

#[derive(Args, Default)]
#[command(after_help = "Examples:\n  \
  sieben demo                  the plant, live in the terminal\n  \
  sieben demo --s7             S7 clients reach it at 127.0.0.1:1102, or at the next free port\n  \
  sieben demo --for 1m --speed max")]
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
    #[command(flatten)]
    servers: ServerArguments,
}

/// Runs the demo: with a picture on a terminal, else with one line per change.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let Plant::Dosing = arguments.name;
    let has_screen = terminal::has_screen();
    let speed = match arguments.speed.unwrap_or(Speed::Factor(1.0)) {
        Speed::Factor(factor) if has_screen => Speed::Factor(factor.clamp(FACTORS.0, FACTORS.1)),
        Speed::Max if has_screen => Speed::Factor(FACTORS.1),
        speed => speed,
    };
    let prepared = Prepared::of_demo(&arguments.servers)?;
    // Without a screen there is no user who could look at a page that was not asked for.
    let usually = if has_screen { Usually::With } else { Usually::Without };
    let prepared_page = arguments.servers.prepare_page(None, None, usually)?;
    let session = Arc::new(Session::new(speed, arguments.time));
    let interrupted = Arc::clone(&session);
    terminal::on_interrupt(move || interrupted.end());
    let server = Server::of_demo(&session.gate, &session.desk, &session.facts);
    let start = |prepared: Prepared| prepared.start(session.cpu_type, &session.gate, EngineArgument::Auto);
    let mut servers = prepared.map(start).transpose()?;
    if let Some(servers) = &servers {
        servers.introduce(&session.facts, &session.gate);
        match has_screen {
            // The run has just begun, and nothing else closes the gate.
            true => drop(session.note(servers.text().trim_end())),
            false => output::message(&servers.text()),
        }
    }
    let start_page = |page: PreparedPage| page.start((&session.gate, &session.desk, &session.facts), servers.as_ref(), Box::new(Answers));
    let page = prepared_page.map(start_page).transpose()?;
    if let Some(page) = &page {
        match has_screen {
            true => drop(session.note(page.text().trim_end())),
            false => output::message(&page.text()),
        }
    }
    let metrics = arguments.servers.start_metrics(&session.gate, servers.as_ref())?;
    if has_screen {
        if let Err(without) = &server {
            // The whole reason has no room there.
            let _ = session.note(without.note());
        }
        screen::run(&session, Palette::wanted()).map_err(|error| terminal::broken(&error))?;
    } else {
        if let Err(without) = &server {
            output::message(&without.to_string());
        }
        print_changes(&session)?;
    }
    drop(metrics);
    drop(page);
    if let Some(lost) = servers.as_mut().and_then(Servers::end) {
        output::message(&lost);
    }
    drop(server);
    output::print(&farewell(&session.outcome()))?;
    Ok(Exit::Success)
}

/// One sentence about what was seen.
fn farewell(outcome: &Outcome) -> String {
    let Outcome { scans, time_ms, litres } = *outcome;
    format!(
        "{} {} in {} of the plant, {litres:.1} litres through the valve.\nThe program is in examples/dosing; `sieben new my-plant --example dosing` copies it.\n",
        thousands(scans),
        if scans == 1 { "scan" } else { "scans" },
        clock(time_ms),
    )
}

/// The demo without a terminal.
fn print_changes(session: &Session) -> Result<(), Failure> {
    output::print(&format!(
        "Sieben demo: dosing of a liquid, CPU {}, cycle {} ms. One line per change; Ctrl-C ends it.\n\n{}\n",
        session.cpu_type.name,
        CYCLE_US / 1_000,
        assignment::text(&session.symbols)
    ))?;
    let mut printed = Ok(());
    session.scan(&mut |entry| {
        if printed.is_ok() {
            printed = output::print(&line(entry));
            if printed.is_err() {
                session.end();
            }
        }
    });
    printed
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
