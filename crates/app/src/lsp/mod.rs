//! The language server: what editors ask of programs, over standard input and output.
//!
//! `transport` reads and writes in threads of their own, so that the server never waits for a client. `server` has one thread with all that is
//! known: `documents` (open texts), `folders` (what is on the disk, with open texts in its place) and `programs` (each with its database).
//! Types of the protocol end in this room; `ide` and `workspace` know none of them.

mod actions;
mod client;
mod diagnostics;
mod documents;
mod executing;
mod folders;
mod live;
mod naming;
mod notifications;
mod parent;
mod positions;
mod programs;
mod reading;
mod requests;
mod server;
mod transport;
mod uri;
mod work;

use std::time::{Duration, Instant};
use std::{io, thread};

use sieben_model::problems::Problem;

use crate::failure::{Exit, Failure};

/// How long a client may take to read what was said last.
const FAREWELL_MAX: Duration = Duration::from_secs(2);

/// Serves the client at standard input and output until it is gone.
pub(crate) fn run() -> Result<Exit, Failure> {
    let no_thread = |error: io::Error| Failure::usage(Problem::P7155, format!("no thread can be started: {error}"));
    let (sender, events) = transport::events();
    let cancelled = transport::Cancelled::default();
    let (outbox, out, unread) = transport::Outbox::new();
    let writer = transport::write(io::stdout(), out, unread, sender.clone()).map_err(no_thread)?;
    transport::read(io::BufReader::new(io::stdin()), sender.clone(), cancelled.clone()).map_err(no_thread)?;
    let mut server = server::Server::new(outbox, sender, cancelled);
    let exit = server.run(&events);
    // What was said last is written before the process ends; a client that does not read is not waited for.
    drop(server);
    drop(events);
    let begun = Instant::now();
    while !writer.is_finished() && begun.elapsed() < FAREWELL_MAX {
        thread::sleep(Duration::from_millis(1));
    }
    Ok(exit)
}
