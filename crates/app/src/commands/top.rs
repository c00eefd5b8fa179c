//! `sieben top [PATH]`: looks at a program that runs, and starts, stops or pauses it.

use std::path::PathBuf;
use std::sync::atomic::Ordering;

use clap::Args;
use sieben_model::problems::Problem;
use sieben_workspace::names::split_list;

use crate::control::Client;
use crate::control::client::silent;
use crate::failure::{Exit, Failure};

use crate::palette::Palette;
use crate::screen::{self, Around, Left, Screen};
use crate::top::Onlooker;
use crate::{output, terminal};

/// Most names that are watched: as many as a screen has room for, and far fewer than one request takes.
const NAMES_MAX: usize = 200;

/// Watch a program that runs.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben top                         the run of the project in this folder\n  \
  sieben top pump --show MW10,Motor  with values\n  \
  sieben top pump --json             one look, for programs\n  \
  sieben top demo                    the demo\n\n\
The run is one that `sieben run` with the same PATH, or `sieben demo`, has started in another terminal.\n\
It has the screen of `sieben run`; ? shows its keys, q leaves and lets the run go on.\n\
Exit codes: 0 ok, 2 usage, or nothing runs.")]
pub(crate) struct Arguments {
    /// Source files, symbol tables, or a project folder, as `run` was given them, or `demo` [default: this folder]
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// Show values too: addresses, symbols, DB1.name, ACCU1 …, separated by commas
    #[arg(long, value_name = "NAME,…")]
    show: Vec<String>,
    /// Look once and print what is seen as one JSON object
    #[arg(long)]
    json: bool,
}

/// Shows the run live on a terminal, else once.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let names: Vec<String> = arguments.show.iter().flat_map(|list| split_list(list)).map(str::to_owned).collect();
    if names.len() > NAMES_MAX {
        return Err(Failure::usage(Problem::P7092, format!("{} names are too many; {NAMES_MAX} can be watched", names.len())));
    }
    let mut onlooker = Onlooker::new(Client::connect(&arguments.paths)?, names);
    onlooker.check_names()?;
    if !arguments.json && terminal::has_screen() {
        let interrupted = terminal::interrupted();
        let is_over = || interrupted.load(Ordering::Relaxed);
        let around = Around { is_over: &is_over, note: &|_| {} };
        let (mut client, names) = onlooker.into_parts();
        let mut screen = Screen { names, ..Screen::spoken() };
        let left = screen::show(&mut client, &mut screen, Palette::wanted(), &around).map_err(|error| failed(&error))?;
        if left == Left::RunOver && !is_over() {
            output::print("The run is over.\n")?;
        }
        return Ok(Exit::Success);
    }
    let look = onlooker.look_at_blocks().and_then(|()| onlooker.look()).map_err(|error| silent(&error))?;
    match arguments.json {
        true => output::print_json(&look.json(), false)?,
        false => output::print(&look.text())?,
    }
    Ok(Exit::Success)
}

/// A terminal that does not work, or a run that does not answer.
fn failed(error: &std::io::Error) -> Failure {
    match error.kind() {
        std::io::ErrorKind::WouldBlock | std::io::ErrorKind::TimedOut => silent(error),
        _ => terminal::broken(error),
    }
}
