//! Ranges on their way to the workers.

use std::collections::VecDeque;
use std::ops::Range;
use std::pin::Pin;
use std::time::{Duration, Instant};

use async_nats::jetstream::context::{PublishError, PublishErrorKind};
use async_nats::jetstream::message::PublishMessage;
use async_nats::jetstream::publish::PublishAck;
use futures_util::stream::FuturesUnordered;

use super::Run;
use crate::connection::chain;
use crate::message::Job;
use crate::ranges::Ranges;

/// Most publications that wait for their answer.
const OPEN_MAX: usize = 256;

/// Ranges that are sent before any worker was heard of.
const AHEAD: usize = 64;

/// Ranges for each thread of the workers that are sent and have no result: enough that none waits, few enough that the last ones end together.
const AHEAD_OF_A_THREAD: u64 = 4;

/// Most ranges that are sent and have no result.
const UNDER_WAY_MAX: usize = 50_000;

/// The pause after the server refused a range: its queue is full.
const PAUSE: Duration = Duration::from_millis(200);

/// How much longer it takes each time until what is missing is sent once more, while the queue says that it is held.
const PATIENCE_MAX: u32 = 16;

/// The answer of the server to a range.
pub(super) type Answer = (Job, Result<PublishAck, PublishError>);

/// Publications that wait for their answer.
pub(super) type Open = FuturesUnordered<Pin<Box<dyn Future<Output = Answer>>>>;

/// Ranges on their way.
pub(super) struct Sending {
    /// What was sent, and has no result.
    under_way: Ranges,
    /// What is to be sent once more, under the identity that it has.
    again: VecDeque<Job>,
    /// Nothing is sent before.
    pause: Option<Instant>,
    /// How often what is missing was sent again; a part of the identity of each message.
    round: u32,
    /// How many times as long as usual a sweep waits.
    patience: u32,
}

impl Sending {
    pub(super) fn new() -> Self {
        Self { under_way: Ranges::default(), again: VecDeque::new(), pause: None, round: 0, patience: 4 }
    }

    pub(super) fn under_way(&self) -> usize {
        self.under_way.len()
    }

    /// A result came.
    pub(super) fn came(&mut self, range: &Range<u64>) {
        self.under_way.remove(range);
    }

    /// Whether nothing is on its way, and nothing is to be.
    pub(super) fn is_done(&self) -> bool {
        self.under_way.is_empty() && self.again.is_empty()
    }
}

impl Run<'_> {
    /// Sends as much as there is room for.
    pub(super) async fn fill(&mut self, open: &mut Open) {
        if self.sending.pause.is_some_and(|until| Instant::now() < until) || self.connection.away().is_some() {
            return;
        }
        self.sending.pause = None;
        let (_, threads) = self.heard.count(self.options.beat, Instant::now());
        let ahead = usize::try_from(threads.saturating_mul(AHEAD_OF_A_THREAD)).unwrap_or(usize::MAX).clamp(AHEAD, UNDER_WAY_MAX);
        while open.len() < OPEN_MAX {
            let Some(job) = self.next_job(ahead) else { break };
            let message = PublishMessage::build().message_id(job.id()).payload(job.to_string().into());
            match self.connection.jetstream.send_publish(self.names.job.clone(), message).await {
                Ok(answer) => open.push(Box::pin(async move { (job, answer.await) })),
                Err(error) => {
                    self.refused(job, &error);
                    break;
                }
            }
        }
    }

    fn next_job(&mut self, ahead: usize) -> Option<Job> {
        if let Some(job) = self.sending.again.pop_front() {
            return Some(job);
        }
        if self.sending.under_way() >= ahead {
            return None;
        }
        let range = self.ledger.next().filter(|range| !range.is_empty())?;
        self.sending.under_way.insert(range.clone());
        Some(self.job(range))
    }

    fn job(&self, range: Range<u64>) -> Job {
        Job { range, tag: format!("{}-{}", self.name, self.sending.round) }
    }

    /// The server answered a publication.
    pub(super) fn answer(&mut self, (job, answer): Answer) {
        match answer {
            Ok(_) => self.answered = Instant::now(),
            Err(error) => self.refused(job, &error),
        }
    }

    /// A range did not get into the queue: it is full, or away, or lost.
    fn refused(&mut self, job: Job, error: &PublishError) {
        let why = chain(error);
        // A full queue is what slows the run down to the pace of its workers.
        let is_full = why.contains("maximum messages exceeded");
        if is_full {
            self.answered = Instant::now();
        } else {
            self.trouble = why;
        }
        self.is_lost |= error.kind() == PublishErrorKind::StreamNotFound;
        self.sending.again.push_back(job);
        self.sending.pause = Some(Instant::now() + PAUSE);
    }

    /// Sends again what has no result although the queue is empty, or has stood still for very long.
    pub(super) fn sweep(&mut self, queued: u64) {
        let is_waiting = self.sending.under_way.is_empty() || !self.sending.again.is_empty() || !self.results.have_caught_up();
        let wait = if queued == 0 { self.options.sweep } else { self.options.sweep * self.sending.patience };
        if is_waiting || self.progress.elapsed() < wait {
            return;
        }
        if queued > 0 {
            self.sending.patience = (self.sending.patience * 2).min(PATIENCE_MAX);
        }
        self.results.close();
        self.send_missing();
    }

    /// Sends again what has no result, under new identities.
    pub(super) fn send_missing(&mut self) {
        let mut missing = Ranges::default();
        for range in self.ledger.missing() {
            missing.insert(range);
        }
        for number in self.given_up.keys() {
            missing.remove(&(*number..*number + 1));
        }
        self.sending.round += 1;
        self.sending.again = missing.iter().map(|range| self.job(range)).collect();
        self.sending.under_way = missing;
        self.finished.sent_again += self.sending.again.len() as u64;
        self.progress = Instant::now();
    }
}
