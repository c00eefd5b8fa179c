//! `sieben worker`: scenarios of campaigns that other machines run, through a NATS server.

use std::num::NonZero;
use std::time::Duration;

use clap::Args;

use crate::duration::duration_argument;
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};

/// Take scenarios of campaigns through a NATS server, and send back what comes of them.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben worker --nats nats://queue:4222                     until Ctrl+C\n  \
  sieben worker --nats nats://queue:4222 --idle-exit 30s     as long as there is work\n  \
  SIEBEN_NATS=nats://user:password@queue:4222 sieben worker  the password in no list of processes\n\n\
The program comes with the campaign: nothing but this binary is needed.\n\n\
Exit codes: 0 ended, 2 usage, or a server that cannot be used.")]
pub(crate) struct Arguments {
    #[command(flatten)]
    #[cfg(feature = "nats")]
    server: crate::campaign::farmed::ServerArguments,
    /// Threads [default: one for each processor]
    #[arg(long, value_name = "N")]
    threads: Option<NonZero<usize>>,
    /// Work for this campaign only
    #[arg(long, value_name = "ID")]
    campaign: Option<String>,
    /// End after so long without work
    #[arg(long, value_name = "DURATION", value_parser = duration_argument)]
    idle_exit: Option<Duration>,
    /// Only say whether the server can be used, by the exit code
    #[arg(long)]
    ready: bool,
    /// Which engine runs the programs
    #[arg(long, value_name = "ENGINE", default_value = "auto")]
    engine: EngineArgument,
}

/// Works.
#[cfg(feature = "nats")]
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    use std::sync::atomic::Ordering;

    use sieben_campaign::identity::MEANING;
    use sieben_farm::{Options, WorkerOrders};

    use crate::campaign::farmed::{Working, failed};
    use crate::campaign::{abort, said};
    use crate::{output, terminal};

    let server = arguments.server.server()?;
    if arguments.ready {
        return sieben_farm::ready(&server).map(|()| Exit::Success).map_err(|error| failed(&error));
    }
    let cancelled = terminal::interrupted();
    let orders = WorkerOrders {
        threads: terminal::threads(arguments.threads),
        campaign: arguments.campaign.clone(),
        idle_exit: arguments.idle_exit,
        meaning: MEANING,
        name: said::computer(),
    };
    let (engine, abort) = (arguments.engine, abort());
    let done = sieben_farm::work(
        &server,
        &Options::default(),
        &orders,
        &move |offer| Working::open(offer, engine, abort),
        &|| cancelled.load(Ordering::Relaxed),
        &mut |news| output::message(&format!("{news}\n")),
    );
    let done = done.map_err(|error| failed(&error))?;
    output::message(&format!("{} of {} done\n", said::several(done.ranges, "range"), said::several(done.campaigns, "campaign")));
    Ok(Exit::Success)
}

/// Works.
#[cfg(not(feature = "nats"))]
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let Arguments { threads: _, campaign: _, idle_exit: _, ready: _, engine: _ } = arguments;
    let told = "this build of Sieben was made without the feature `nats`, which workers need";
    Err(Failure::usage(sieben_model::problems::Problem::P7165, told).help("build with the default features"))
}
