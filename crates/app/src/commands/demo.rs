//! `sieben demo`: a dosing plant with its controller, live in the terminal.

use std::io;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::thread;
use std::time::Duration;

use clap::{Args, ValueEnum};
use sieben_lang::symbols::assignment;
use sieben_workbench::{PROJECT, Projects};
use sieben_workspace::Speed;

use crate::control::Server;
use crate::duration::duration_argument;
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::page::Answers;
use crate::palette::Palette;
use crate::screen::{self, Around, CYCLE_US, Demo, Direct, Outcome, Screen, clock, thousands};
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
    let demo = Arc::new(Demo::new(speed, arguments.time));
    let interrupted = Arc::clone(&demo);
    terminal::on_interrupt(move || interrupted.end());
    let server = Server::of_demo(&demo.gate, &demo.desk, &demo.facts);
    let start = |prepared: Prepared| prepared.start(demo.cpu_type, &demo.gate, EngineArgument::Auto);
    let mut servers = prepared.map(start).transpose()?;
    if let Some(servers) = &servers {
        servers.introduce(&demo.facts, &demo.gate);
        match has_screen {
            // The run has just begun, and nothing else closes the gate.
            true => drop(demo.note(servers.text().trim_end())),
            false => output::message(&servers.text()),
        }
    }
    let story = Arc::clone(&demo.story);
    // The story waits for users of pages, of the control socket and of S7 clients as for the one at the keys.
    demo.facts.add_listener(Box::new(move |_, changes| {
        if changes.iter().any(|change| change.what != PROJECT) {
            story.user_acted.store(true, Ordering::Relaxed);
        }
    }));
    let start_page = |page: PreparedPage| {
        let around = (&demo.gate, &demo.desk, &demo.facts);
        page.start(around, servers.as_ref(), Box::new(Answers::default()), Arc::clone(&demo.chosen) as Arc<dyn Projects>)
    };
    let page = prepared_page.map(start_page).transpose()?;
    if let Some(page) = &page {
        match has_screen {
            true => drop(demo.note(page.text().trim_end())),
            false => output::message(&page.text()),
        }
    }
    let metrics = arguments.servers.start_metrics(&demo.gate, servers.as_ref())?;
    if has_screen {
        if let Err(without) = &server {
            // The whole reason has no room there.
            let _ = demo.note(without.note());
        }
        show(&demo).map_err(|error| terminal::broken(&error))?;
    } else {
        if let Err(without) = &server {
            output::message(&without.to_string());
        }
        print_changes(&demo)?;
    }
    drop(metrics);
    drop(page);
    if let Some(lost) = servers.as_mut().and_then(Servers::end) {
        output::message(&lost);
    }
    drop(server);
    output::print(&farewell(&demo.outcome()))?;
    Ok(Exit::Success)
}

/// Ends the scans when it goes, however the screen was left.
struct Ending<'d>(&'d Demo);

impl Drop for Ending<'_> {
    fn drop(&mut self) {
        self.0.end();
    }
}

/// The demo on its screen. The scans end with it.
fn show(demo: &Demo) -> io::Result<()> {
    thread::scope(|scope| {
        let _ending = Ending(demo);
        thread::Builder::new().name("scan".to_owned()).spawn_scoped(scope, || demo.scan(None))?;
        let (gate, desk) = (Arc::clone(&demo.gate), Arc::clone(&demo.desk));
        // It ends by itself when the gate is closed.
        thread::Builder::new().name("status".to_owned()).spawn(move || desk.replay(|| gate.is_closed()))?;
        let mut asks = Direct::new(&demo.gate, &demo.desk, &demo.facts);
        let mut screen = Screen { story: Some(Arc::clone(&demo.story)), ..Screen::spoken() };
        let note = |text: &str| {
            // A demo that is over has no use for it.
            let _ = demo.note(text);
        };
        let around = Around { is_over: &|| demo.gate.is_closed(), note: &note };
        screen::show(&mut asks, &mut screen, Palette::wanted(), &around).map(drop)
    })
}

/// One sentence about what was seen.
fn farewell(outcome: &Outcome) -> String {
    let Outcome { example, scans, time_ms, litres } = *outcome;
    let litres = litres.map_or_else(String::new, |litres| format!(", {litres:.1} litres through the valve"));
    format!(
        "{} {} in {} of the plant{litres}.\nThe program is in examples/{example}; `sieben new my-plant --example {example}` copies it.\n",
        thousands(scans),
        if scans == 1 { "scan" } else { "scans" },
        clock(time_ms),
    )
}

/// The demo without a terminal.
fn print_changes(demo: &Demo) -> Result<(), Failure> {
    output::print(&format!(
        "Sieben demo: dosing of a liquid, CPU {}, cycle {} ms. One line per change; Ctrl-C ends it.\n\n{}\n",
        demo.cpu_type.name,
        CYCLE_US / 1_000,
        assignment::text(&demo.symbols)
    ))?;
    let mut printed = Ok(());
    demo.scan(Some(&mut |line| {
        if printed.is_ok() {
            printed = output::print(line);
            if printed.is_err() {
                demo.end();
            }
        }
    }));
    printed
}
