//! The side of the run: it sends ranges, and hands what comes of them to the ledger.

mod results;
mod sending;

use std::collections::{BTreeMap, BTreeSet};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use async_nats::{Message, Subscriber};
use futures_util::StreamExt;
use futures_util::stream::FuturesUnordered;
use tokio::time::{MissedTickBehavior, interval, timeout};

use crate::connection::{ANSWER, Connection};
use crate::error::FarmError;
use crate::ledger::{Announced, Finished, Ledger};
use crate::message::{State, StateKind, read_alive};
use crate::names::Names;
use crate::options::Options;
use crate::probe::runtime;
use crate::server::Server;
use crate::store;
use crate::workers::{Heard, Workers};
use results::Results;
use sending::Sending;

/// How often the run looks whether it is to end, and at what is due.
const TICK: Duration = Duration::from_millis(100);

/// Beats between two looks at the streams of the server.
const LOOK: u32 = 3;

/// Beats after which a run is no newcomer.
const SETTLED: u32 = 3;

/// Runs a campaign with whatever workers there are, until its ledger is whole or over.
///
/// At the end its streams are removed from the server, also if the run ends early: what is known is in the ledger. They stay if it ends with an
/// error, and a later run of the same campaign finds what came in the meantime.
pub fn run(
    server: &Server,
    options: &Options,
    announced: &Announced,
    ledger: &mut dyn Ledger,
    tell: &mut dyn FnMut(&Workers),
) -> Result<Finished, FarmError> {
    let names = Names::of(&announced.campaign).ok_or_else(|| FarmError::Campaign(announced.campaign.clone()))?;
    runtime()?.block_on(async {
        let connection = Connection::open(server, "sieben run", options.arrival, &|| ledger.is_over()).await?;
        let alive = connection.client.subscribe(names.alive.clone()).await;
        let state = connection.client.subscribe(names.state.clone()).await;
        let (alive, state) = alive.and_then(|alive| state.map(|state| (alive, state))).map_err(|_| FarmError::Address)?;
        let mut run = Run {
            sending: Sending::new(),
            results: Results::default(),
            heard: Heard::default(),
            finished: Finished::default(),
            given_up: BTreeMap::new(),
            handed: BTreeSet::new(),
            name: name(),
            begun: Instant::now(),
            progress: Instant::now(),
            answered: Instant::now(),
            trouble: String::new(),
            is_lost: true,
            is_new: true,
            connection,
            names,
            options,
            announced,
            ledger,
        };
        run.serve(alive, state, tell).await?;
        run.end().await;
        Ok(run.finished)
    })
}

/// A name that no other run has: when it began, and its process.
fn name() -> String {
    let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    format!("{:x}-{:x}", since.as_millis(), std::process::id())
}

struct Run<'a> {
    connection: Connection,
    names: Names,
    options: &'a Options,
    announced: &'a Announced,
    ledger: &'a mut dyn Ledger,
    sending: Sending,
    results: Results,
    heard: Heard,
    finished: Finished,
    /// Results of scenarios that workers died of: held back, because one of these workers may only be slow.
    given_up: BTreeMap<u64, (Instant, Vec<u8>)>,
    /// The scenarios whose given-up result the ledger has.
    handed: BTreeSet<u64>,
    name: String,
    begun: Instant,
    /// When the last new result came, or something was sent after long silence.
    progress: Instant,
    /// When the server last did what was asked.
    answered: Instant,
    /// What the server said last when it did not.
    trouble: String,
    /// Whether the streams must be made.
    is_lost: bool,
    /// Whether they were never made by this run.
    is_new: bool,
}

impl Run<'_> {
    async fn serve(&mut self, mut alive: Subscriber, mut state: Subscriber, tell: &mut dyn FnMut(&Workers)) -> Result<(), FarmError> {
        let mut open = FuturesUnordered::new();
        let mut tick = interval(TICK.min(self.options.beat));
        tick.set_missed_tick_behavior(MissedTickBehavior::Skip);
        let (mut beat, mut look) = (Instant::now(), Instant::now());
        while !self.ledger.is_whole() && !self.ledger.is_over() {
            if !self.is_lost && self.results.have_caught_up() {
                self.fill(&mut open).await;
            }
            tokio::select! {
                message = self.results.next() => self.takes(message).await,
                Some(answer) = open.next(), if !open.is_empty() => self.answer(answer),
                Some(message) = alive.next() => self.hears(&message),
                Some(message) = state.next() => self.meets(&message)?,
                _ = tick.tick() => {
                    self.is_well()?;
                    if self.is_lost || look.elapsed() >= self.options.beat * LOOK {
                        self.look().await?;
                        look = Instant::now();
                    }
                    if beat.elapsed() >= self.options.beat {
                        self.says(if self.is_settled() { StateKind::Settled } else { StateKind::New }).await;
                        tell(&self.workers());
                        beat = Instant::now();
                    }
                    self.hands_given_up();
                }
            }
        }
        tell(&self.workers());
        Ok(())
    }

    /// Whether going on makes sense.
    fn is_well(&self) -> Result<(), FarmError> {
        if let Some(refusal) = self.connection.refusal() {
            return Err(refusal);
        }
        let gone = |away: Duration, why: &str| FarmError::Gone {
            place: self.connection.place.clone(),
            seconds: away.as_secs(),
            why: why.to_owned(),
        };
        match self.connection.away() {
            Some(away) if away > self.options.patience => Err(gone(away, "no connection")),
            None if self.answered.elapsed() > self.options.patience => Err(gone(self.answered.elapsed(), &self.trouble)),
            _ => Ok(()),
        }
    }

    /// Looks at what the server has of the campaign, and makes what is missing; sends again what is lost.
    async fn look(&mut self) -> Result<(), FarmError> {
        if self.connection.away().is_some() {
            return Ok(());
        }
        let found = match store::look(&self.connection.jetstream, &self.names).await {
            Ok(Some(found)) if !self.is_new => found,
            Ok(_) => return self.set_up().await,
            Err(trouble) => {
                self.trouble = trouble;
                return Ok(());
            }
        };
        self.answered = Instant::now();
        self.is_lost = false;
        self.results.follow(found.results);
        self.results.open(&self.connection, &self.names).await;
        self.sweep(found.queued);
        Ok(())
    }

    /// Makes the streams, for the first time or because the server lost them.
    async fn set_up(&mut self) -> Result<(), FarmError> {
        self.is_lost = true;
        let results = match store::set_up(&self.connection, &self.names, self.options, self.announced).await {
            Ok(results) => results,
            // A server on its way down is waited for; one that never did it will not.
            Err(FarmError::Refused { why, .. }) if !self.is_new => {
                self.trouble = why;
                return Ok(());
            }
            Err(error) => return Err(error),
        };
        self.answered = Instant::now();
        self.is_lost = false;
        let jetstream = &self.connection.jetstream;
        if self.is_new {
            // What an earlier run sent is sent again, cut as this one cuts it.
            if let Ok(jobs) = jetstream.get_stream(&self.names.jobs).await {
                let _ = jobs.purge().await;
            }
        } else {
            self.finished.rebuilt += 1;
        }
        self.is_new = false;
        self.results.follow(results);
        self.results.open(&self.connection, &self.names).await;
        self.send_missing();
        Ok(())
    }

    fn hears(&mut self, message: &Message) {
        if let Some((worker, threads)) = read_alive(&message.payload) {
            self.heard.hears(worker, threads, Instant::now());
        }
    }

    /// Another run of the same campaign: the newcomer of the two leaves, of two newcomers the one with the higher name.
    fn meets(&self, message: &Message) -> Result<(), FarmError> {
        let Some(other) = State::read(&message.payload).filter(|other| other.run != self.name) else { return Ok(()) };
        let leaves = match (other.kind, self.is_settled()) {
            (StateKind::Over, _) | (StateKind::New, true) => false,
            (StateKind::Settled, false) => true,
            (StateKind::New, false) | (StateKind::Settled, true) => self.name > other.run,
        };
        if leaves { Err(FarmError::Busy) } else { Ok(()) }
    }

    fn is_settled(&self) -> bool {
        self.begun.elapsed() > self.options.beat * SETTLED
    }

    async fn says(&self, kind: StateKind) {
        let state = State { run: self.name.clone(), kind }.to_string();
        let _ = timeout(ANSWER, self.connection.client.publish(self.names.state.clone(), state.into())).await;
    }

    fn workers(&mut self) -> Workers {
        let (alive, threads) = self.heard.count(self.options.beat, Instant::now());
        Workers {
            alive,
            threads,
            is_connected: self.connection.away().is_none(),
            under_way: self.sending.under_way(),
            differing: self.finished.differing,
        }
    }

    /// Tells the workers that it is over, and leaves nothing on the server.
    async fn end(&mut self) {
        if self.connection.away().is_some() {
            return;
        }
        self.says(StateKind::Over).await;
        self.results.close();
        self.finished.is_removed = timeout(ANSWER * 2, store::remove(&self.connection.jetstream, &self.names)).await.unwrap_or(false);
        self.says(StateKind::Over).await;
        let _ = timeout(ANSWER, self.connection.client.flush()).await;
    }
}
