//! `sieben campaign list`: how many scenarios a campaign has, and how long they take.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::Args;
use serde_json::json;
use sieben_workspace::campaign::{Campaign, Way};

use super::opened::open;
use crate::arguments::ProgramArguments;
use crate::campaign::said;
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::output;

/// Print how many scenarios a campaign has.
#[derive(Args)]
pub(super) struct Arguments {
    /// The file of the campaign
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    #[command(flatten)]
    program: ProgramArguments,
    /// Another seed than that of the file
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Print it as one JSON object
    #[arg(long)]
    json: bool,
}

/// Prints it.
pub(super) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let opened = match open(&arguments.spec, &arguments.program, arguments.seed, EngineArgument::Interpreter, arguments.json)? {
        Ok(opened) => opened,
        Err(exit) => return Ok(exit),
    };
    let campaign = &opened.campaign;
    let subject = &campaign.programs[0];
    let columns = said::columns(campaign);
    let guess = guessed(campaign);
    if arguments.json {
        let object = json!({
            "campaign": campaign.identity.campaign,
            "program": campaign.identity.program,
            "name": opened.name,
            "seed": campaign.spec.seed,
            "scenarios": campaign.scenarios(),
            "scans": subject.scans(),
            "cycle_us": subject.cycle_us(),
            "columns": columns.iter().map(|(name, _)| name).collect::<Vec<_>>(),
            "seconds": guess.as_secs_f64(),
        });
        output::print_json(&object, true)?;
        return Ok(Exit::Success);
    }
    let mut text = format!(
        "{}: {} of up to {} at a cycle of {}\n",
        opened.name,
        said::scenarios(campaign.scenarios()),
        said::several(subject.scans(), "scan"),
        sieben_workspace::duration::show(Duration::from_micros(subject.cycle_us()))
    );
    let width = columns.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    text.extend(columns.iter().map(|(name, said)| format!("  {name:width$}  {said}\n")));
    text.push_str(&format!("about {} of one processor, in the interpreter\n", about(guess)));
    output::print(&text)?;
    Ok(Exit::Success)
}

/// The first scenario is looked at for so long.
const LOOK: Duration = Duration::from_secs(2);

/// How long all scenarios take on one processor, by the first one.
fn guessed(campaign: &Campaign) -> Duration {
    let begun = Instant::now();
    let run = campaign.run(0, Way::Chosen, &|| begun.elapsed() < LOOK);
    let each = begun.elapsed().as_secs_f64();
    // Of one that takes long a part was run.
    let part = run.map_or_else(|scans| campaign.programs[0].scans() as f64 / scans.max(1) as f64, |_| 1.0);
    let all = each * part * campaign.scenarios() as f64;
    // What takes longer than there is a number for takes that long.
    Duration::try_from_secs_f64(all).unwrap_or(Duration::MAX)
}

/// A time that is only guessed.
fn about(time: Duration) -> String {
    match time.as_secs_f64() {
        seconds if seconds < 1.0 => "a second".to_owned(),
        seconds if seconds < 120.0 => format!("{seconds:.0} s"),
        seconds if seconds < 7200.0 => format!("{:.0} min", seconds / 60.0),
        seconds if seconds < 172_800.0 => format!("{:.0} h", seconds / 3600.0),
        seconds if seconds < 3e10 => format!("{:.0} days", seconds / 86_400.0),
        _ => "more than a thousand years".to_owned(),
    }
}
