//! Results on their way to the ledger.

use std::time::{Duration, Instant};

use async_nats::jetstream::Message;
use async_nats::jetstream::consumer::DeliverPolicy;
use async_nats::jetstream::consumer::pull::{Ordered, OrderedConfig};
use futures_util::StreamExt;
use tokio::time::timeout;

use super::Run;
use crate::connection::{ANSWER, Connection, chain};
use crate::ledger::{ALARMS_MAX, Alarm, Came};
use crate::message::{Body, Job, Outcome, RESULT_BYTES_MAX, hash};
use crate::names::Names;
use crate::store::{self, FoundResults};

/// Results after which those that the ledger has are removed from the server.
const PURGE: u64 = 1_000;

/// How long a result that was given up waits for a worker that is only slow, in leases.
const GRACE: u32 = 1;

/// A message that was read, or why there is none.
pub(super) type Read = Result<Message, String>;

/// The stream of results, read in order.
#[derive(Default)]
pub(super) struct Results {
    messages: Option<Ordered>,
    /// The sequence number of the last one that was read.
    last: u64,
    /// The newest one that there was when reading began.
    newest: u64,
    /// When the stream was made.
    created: i128,
    /// The last one that was removed.
    purged: u64,
}

impl Results {
    /// The next message; waits for ever while the stream is not open.
    pub(super) async fn next(&mut self) -> Read {
        match &mut self.messages {
            Some(messages) => match messages.next().await {
                Some(Ok(message)) => Ok(message),
                Some(Err(error)) => Err(chain(&error)),
                None => Err("the stream of results ended".to_owned()),
            },
            None => std::future::pending().await,
        }
    }

    /// Whether what was there at the beginning was read: only then it is known what is missing.
    pub(super) fn have_caught_up(&self) -> bool {
        self.last >= self.newest
    }

    /// Goes on with the stream that is there: with another one from its beginning.
    pub(super) fn follow(&mut self, found: FoundResults) {
        if found.created != self.created {
            *self = Self { newest: found.newest, created: found.created, ..Self::default() };
        }
    }

    pub(super) fn close(&mut self) {
        self.messages = None;
    }

    /// Opens the stream after the last message that was read, if it is not open.
    pub(super) async fn open(&mut self, connection: &Connection, names: &Names) {
        if self.messages.is_some() {
            return;
        }
        let deliver_policy = match self.last {
            0 => DeliverPolicy::All,
            last => DeliverPolicy::ByStartSequence { start_sequence: last + 1 },
        };
        let config = OrderedConfig { deliver_policy, ..OrderedConfig::default() };
        let opened = timeout(ANSWER, async {
            let stream = connection.jetstream.get_stream(&names.results).await.ok()?;
            if stream.cached_info().state.messages == 0 {
                // Nothing is left of what was there.
                self.last = self.last.max(stream.cached_info().state.last_sequence);
            }
            stream.create_consumer(config).await.ok()?.messages().await.ok()
        });
        self.messages = opened.await.ok().flatten();
    }
}

impl Run<'_> {
    /// Takes a message of the stream of results.
    pub(super) async fn takes(&mut self, read: Read) {
        let message = match read {
            Ok(message) => message,
            Err(trouble) => {
                self.trouble = trouble;
                self.results.close();
                return;
            }
        };
        self.answered = Instant::now();
        let Ok(sequence) = message.info().map(|info| info.stream_sequence) else { return };
        self.results.last = sequence;
        match Outcome::read(&message.payload) {
            Some(outcome) => self.outcome(outcome).await,
            None => self.finished.unreadable += 1,
        }
        if self.results.last >= self.results.purged + PURGE {
            self.purge().await;
        }
    }

    async fn outcome(&mut self, outcome: Outcome<'_>) {
        let Outcome { job, worker, body } = outcome;
        match body {
            Body::Whole(bytes) => self.came(&job, &worker, bytes),
            Body::GivenUp(bytes) => {
                let number = job.range.start;
                if !self.handed.contains(&number) && self.is_missing(number) {
                    self.sending.came(&job.range);
                    self.given_up.insert(number, (Instant::now(), bytes.to_owned()));
                    self.progress = Instant::now();
                }
            }
            Body::Object(size, digest) => match self.fetched(&job, size, &digest).await {
                Ok(bytes) => self.came(&job, &worker, &bytes),
                Err(trouble) => {
                    self.finished.unreadable += 1;
                    self.trouble = trouble;
                }
            },
        }
    }

    fn is_missing(&mut self, number: u64) -> bool {
        self.ledger.missing().iter().any(|range| range.contains(&number))
    }

    /// Fetches a result that was too large for a message.
    async fn fetched(&mut self, job: &Job, size: u64, digest: &str) -> Result<Vec<u8>, String> {
        if size > RESULT_BYTES_MAX {
            return Err(format!("a result has {size} bytes"));
        }
        let name = job.object(digest);
        let bucket = self.connection.jetstream.get_object_store(&self.names.bucket).await.map_err(|error| chain(&error))?;
        let bytes = store::get(&bucket, &name, RESULT_BYTES_MAX).await?;
        if bytes.len() as u64 != size || hash(&bytes) != digest {
            return Err("a result is not what its message says".to_owned());
        }
        let _ = bucket.delete(&name).await;
        Ok(bytes)
    }

    fn came(&mut self, job: &Job, worker: &str, bytes: &[u8]) {
        let range = job.range.clone();
        if range.end - range.start == 1 && self.handed.contains(&range.start) {
            // It was given up, and its worker was slow after all: what the ledger has stays.
            self.finished.duplicates += 1;
            return;
        }
        match self.ledger.came(range.clone(), bytes) {
            Came::New => {
                self.finished.results += 1;
                self.sending.came(&range);
                self.given_up.retain(|number, _| !range.contains(number));
                self.progress = Instant::now();
            }
            // What the ledger had before this run is no duplicate.
            Came::Same if self.results.last <= self.results.newest => {}
            Came::Same => self.finished.duplicates += 1,
            Came::Other => {
                self.finished.differing += 1;
                if self.finished.alarms.len() < ALARMS_MAX {
                    self.finished.alarms.push(Alarm { range, worker: worker.to_owned() });
                }
            }
            Came::Unreadable => self.finished.unreadable += 1,
        }
    }

    /// Hands over what was given up, once nothing else is under way and no slow worker came with a result.
    pub(super) fn hands_given_up(&mut self) {
        let grace: Duration = self.options.lease * GRACE;
        if !self.sending.is_done() || self.given_up.values().any(|(since, _)| since.elapsed() < grace) {
            return;
        }
        for (number, (_, bytes)) in std::mem::take(&mut self.given_up) {
            match self.ledger.came(number..number + 1, &bytes) {
                Came::New => {
                    self.finished.results += 1;
                    self.finished.given_up += 1;
                    self.handed.insert(number);
                }
                _ => self.finished.unreadable += 1,
            }
        }
    }

    /// Removes from the server what the ledger has.
    async fn purge(&mut self) {
        self.results.purged = self.results.last;
        if let Ok(stream) = self.connection.jetstream.get_stream_no_info(&self.names.results).await {
            let _ = timeout(ANSWER, stream.purge().sequence(self.results.last + 1)).await;
        }
    }
}
