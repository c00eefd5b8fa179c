//! One campaign at a worker: from the first range to the last.

use std::collections::{HashMap, VecDeque};
use std::pin::Pin;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use async_nats::Subscriber;
use async_nats::jetstream::consumer::{Consumer, pull};
use async_nats::jetstream::{AckKind, Message};
use futures_util::StreamExt;
use futures_util::stream::FuturesUnordered;
use tokio::time::{MissedTickBehavior, interval, timeout};

use super::holding::{Held, Post, Sent, What};
use super::pool::{Answer, Ran, Running, Task};
use super::{News, Work, Worker};
use crate::connection::{ANSWER, chain};
use crate::error::FarmError;
use crate::message::{Job, State, StateKind, alive};

/// How long the server keeps a request for ranges open. Without an end it may be forgotten at the end of a queue.
const PULL: Duration = Duration::from_secs(2);

/// The pause after a request for ranges failed.
const PAUSE: Duration = Duration::from_millis(500);

/// How long a worker that ends waits for what its threads have in hand.
const GRACE: Duration = Duration::from_secs(8);

/// How often a worker looks whether it is to end.
const TICK: Duration = Duration::from_millis(50);

/// The delivery with which a range is split: two workers had it and did not answer.
const SPLIT_AT: i64 = 3;

/// The delivery with which a single scenario is run alone in its worker, which says so before: if that worker does not answer either, the scenario
/// killed it, and not another one that ran beside it.
const ALONE_AT: i64 = 3;

/// How a worker left a campaign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Left {
    /// There was nothing to do.
    Idle,
    /// It is over, or the worker is.
    Done,
}

/// One campaign at a worker.
pub(super) struct Campaign {
    consumer: Consumer<pull::Config>,
    work: Arc<dyn Work>,
    post: Post,
    state: Subscriber,
    /// What is held, by the number that the threads know.
    held: HashMap<u64, Held>,
    /// Scenarios that are to be run alone.
    suspects: VecDeque<u64>,
    /// The one that is.
    alone: Option<u64>,
    /// What is being sent.
    posts: FuturesUnordered<Pin<Box<dyn Future<Output = Sent>>>>,
    /// The open request for ranges.
    pull: Option<pull::Batch>,
    /// Ranges that it brought.
    pulled: usize,
    /// No request before.
    pause: Option<Instant>,
    /// Since when the worker is ending.
    ending: Option<Instant>,
    /// Whether a range came.
    has_begun: bool,
}

impl Campaign {
    pub(super) fn new(consumer: Consumer<pull::Config>, work: Arc<dyn Work>, post: Post, state: Subscriber) -> Self {
        Self {
            consumer,
            work,
            post,
            state,
            held: HashMap::new(),
            suspects: VecDeque::new(),
            alone: None,
            posts: FuturesUnordered::new(),
            pull: None,
            pulled: 0,
            pause: None,
            ending: None,
            has_begun: false,
        }
    }

    pub(super) fn identity(&self) -> &str {
        &self.post.names.campaign
    }

    pub(super) fn has_begun(&self) -> bool {
        self.has_begun
    }

    /// Works until there is nothing left to do.
    pub(super) async fn serve(&mut self, worker: &mut Worker<'_>, tell: &mut dyn FnMut(&News)) -> Result<Left, FarmError> {
        let mut tick = interval(TICK.min(self.post.lease / 6).max(Duration::from_millis(5)));
        tick.set_missed_tick_behavior(MissedTickBehavior::Skip);
        let (mut renewed, mut beat) = (Instant::now(), None::<Instant>);
        let left = loop {
            self.asks(worker).await;
            let left = tokio::select! {
                message = next(&mut self.pull) => self.takes(worker, message, tell).await,
                Some(answer) = worker.answers.recv() => self.ran(answer, tell).await,
                Some(sent) = self.posts.next(), if !self.posts.is_empty() => self.sent(worker, sent, tell),
                Some(message) = self.state.next() => {
                    let is_over = State::read(&message.payload).is_some_and(|state| state.kind == StateKind::Over);
                    is_over.then_some(Left::Done)
                }
                _ = tick.tick() => {
                    worker.is_well()?;
                    if renewed.elapsed() >= self.post.lease / 3 {
                        for held in self.held.values() {
                            held.renew().await;
                        }
                        renewed = Instant::now();
                    }
                    if beat.is_none_or(|beat| beat.elapsed() >= worker.options.beat) {
                        let text = alive(&worker.name, worker.threads);
                        let _ = timeout(ANSWER, worker.connection.client.publish(self.post.names.alive.clone(), text.into())).await;
                        beat = Some(Instant::now());
                    }
                    if self.ending.is_none() && (worker.is_over)() {
                        self.give_back(worker).await;
                        self.ending = Some(Instant::now());
                    }
                    self.ending.filter(|since| self.held.is_empty() || since.elapsed() >= GRACE).map(|_| Left::Done)
                }
            };
            if let Some(left) = left {
                break left;
            }
        };
        self.post.stop.store(true, Ordering::Relaxed);
        worker.pool.clear();
        let _ = timeout(ANSWER, worker.connection.client.flush()).await;
        Ok(left)
    }

    /// Asks for ranges, if there is room for more.
    async fn asks(&mut self, worker: &mut Worker<'_>) {
        let is_waiting = self.pause.is_some_and(|until| Instant::now() < until);
        if self.pull.is_some() || self.ending.is_some() || is_waiting || worker.connection.away().is_some() {
            return;
        }
        if !self.suspects.is_empty() || self.alone.is_some() {
            self.begins_alone(worker).await;
            return;
        }
        // A few more than there are threads, so that none of them waits for the network.
        let room = (worker.threads + worker.threads.div_ceil(2)).saturating_sub(self.held.len());
        if room == 0 {
            return;
        }
        match timeout(ANSWER, self.consumer.batch().max_messages(room).expires(PULL).messages()).await {
            Ok(Ok(batch)) => self.pull = Some(batch),
            Ok(Err(error)) => worker.trouble = chain(&error),
            Err(_) => {}
        }
        self.pulled = 0;
        self.pause = self.pull.is_none().then(|| Instant::now() + PAUSE);
    }

    /// Takes what a request brought: a range, or its end.
    async fn takes(
        &mut self,
        worker: &mut Worker<'_>,
        message: Option<Result<Message, String>>,
        tell: &mut dyn FnMut(&News),
    ) -> Option<Left> {
        match message {
            Some(Ok(message)) => {
                worker.answered = Instant::now();
                worker.busy = Instant::now();
                self.pulled += 1;
                self.has(worker, message, tell).await;
                None
            }
            Some(Err(why)) => {
                worker.trouble = why;
                self.pull = None;
                self.pause = Some(Instant::now() + PAUSE);
                // Whether the campaign is still there is seen by entering it again.
                self.held.is_empty().then_some(Left::Idle)
            }
            None => {
                if worker.connection.away().is_none() {
                    worker.answered = Instant::now();
                }
                self.pull = None;
                (self.pulled == 0 && self.held.is_empty()).then_some(Left::Idle)
            }
        }
    }

    /// Decides what becomes of a range.
    async fn has(&mut self, worker: &mut Worker<'_>, message: Message, tell: &mut dyn FnMut(&News)) {
        let Some(job) = Job::read(&message.payload) else {
            // Never to be delivered again.
            let _ = timeout(ANSWER, message.ack_with(AckKind::Term)).await;
            return;
        };
        if !self.has_begun {
            self.has_begun = true;
            worker.done.campaigns += 1;
            tell(&News::Began { campaign: self.identity().to_owned() });
        }
        let delivered = message.info().map_or(1, |info| info.delivered);
        let key = worker.next_key;
        worker.next_key += 1;
        let held = Held { message: Arc::new(message), job, has_begun: Arc::default() };
        self.held.insert(key, held.clone());
        match held.job.halves() {
            Some(halves) if delivered >= SPLIT_AT => {
                held.has_begun.store(true, Ordering::Relaxed);
                self.posts.push(Box::pin(self.post.clone().halves(key, held, halves)));
            }
            None if delivered >= ALONE_AT => self.suspects.push_back(key),
            _ => self.begins(worker, key, &held, false),
        }
    }

    fn begins(&self, worker: &Worker<'_>, key: u64, held: &Held, is_given_up: bool) {
        worker.pool.put(Task::Run(Running {
            key,
            range: held.job.range.clone(),
            work: self.work.clone(),
            stop: self.post.stop.clone(),
            has_begun: held.has_begun.clone(),
            is_given_up,
        }));
    }

    /// Begins the next scenario that is to be run alone, once nothing else is held.
    async fn begins_alone(&mut self, worker: &mut Worker<'_>) {
        if self.alone.is_some() || self.held.len() > self.suspects.len() {
            return;
        }
        let Some(key) = self.suspects.front().copied() else { return };
        let Some(held) = self.held.get(&key).cloned() else {
            self.suspects.pop_front();
            return;
        };
        match self.post.marks(&held.job).await {
            Ok(was_marked) => {
                self.suspects.pop_front();
                self.alone = Some(key);
                self.begins(worker, key, &held, was_marked);
            }
            Err(why) => {
                worker.trouble = why;
                self.pause = Some(Instant::now() + PAUSE);
            }
        }
    }

    /// A thread is done with a range.
    async fn ran(&mut self, answer: Answer, tell: &mut dyn FnMut(&News)) -> Option<Left> {
        let Answer::Ran(key, ran) = answer else { return None };
        // What is not held is of a campaign that was left.
        let held = self.held.get(&key)?.clone();
        let is_alone = self.alone == Some(key);
        match ran {
            Ran::Done(bytes, is_given_up) => self.posts.push(Box::pin(self.post.clone().result(key, held, bytes, is_given_up))),
            Ran::Stopped => {
                if is_alone {
                    self.post.unmarks(&held.job).await;
                }
                held.give_back(None).await;
                self.held.remove(&key);
            }
            Ran::Panicked => {
                let why = format!("scenarios {}..{} broke an assumption of this program", held.job.range.start, held.job.range.end);
                tell(&News::Trouble { why });
                held.give_back(Some(self.post.lease / 4)).await;
                self.held.remove(&key);
            }
        }
        if is_alone {
            self.alone = None;
        }
        None
    }

    /// Something was sent, or could not be.
    fn sent(&mut self, worker: &mut Worker<'_>, sent: Sent, tell: &mut dyn FnMut(&News)) -> Option<Left> {
        self.held.remove(&sent.key);
        worker.busy = Instant::now();
        let Some(why) = sent.trouble else {
            worker.answered = Instant::now();
            match sent.what {
                What::Result => worker.done.ranges += 1,
                What::GivenUp => worker.done.given_up += 1,
                What::Halves => worker.done.split += 1,
            }
            return None;
        };
        if !self.post.stop.load(Ordering::Relaxed) {
            tell(&News::Trouble { why: why.clone() });
        }
        worker.trouble = why;
        None
    }

    /// Gives back what no thread has, so that other workers get it without waiting for the lease to end.
    async fn give_back(&mut self, worker: &Worker<'_>) {
        worker.pool.clear();
        let waiting: Vec<u64> = self.held.iter().filter(|(_, held)| !held.has_begun.load(Ordering::Relaxed)).map(|(key, _)| *key).collect();
        for key in waiting {
            if let Some(held) = self.held.remove(&key) {
                held.give_back(None).await;
            }
        }
    }
}

/// The next message of a request; waits for ever if there is none.
async fn next(pull: &mut Option<pull::Batch>) -> Option<Result<Message, String>> {
    match pull {
        Some(batch) => batch.next().await.map(|message| message.map_err(|error| error.to_string())),
        None => std::future::pending().await,
    }
}
