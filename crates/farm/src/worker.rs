//! The side of a worker: it takes ranges, and sends what comes of them.

mod entering;
mod holding;
mod pool;
mod serving;

use std::collections::HashMap;
use std::fmt;
use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::Arc;
use std::time::{Duration, Instant};

use async_nats::jetstream::context::StreamsError;
use futures_util::StreamExt;
use tokio::time::timeout;

use crate::connection::{ANSWER, Connection, chain};
use crate::error::FarmError;
use crate::message::word;
use crate::names::Names;
use crate::options::Options;
use crate::probe::runtime;
use crate::server::Server;
use pool::Pool;
use serving::{Campaign, Left};

/// Most campaigns that a worker looks at.
const CAMPAIGNS_MAX: usize = 1_000;

/// Most threads of a worker.
const THREADS_MAX: usize = 4_096;

/// What a worker does with a campaign; one for all threads of a process.
pub trait Work: Send + Sync {
    /// Runs a range; `None` if it was told that it is over before it was done.
    fn run(&self, range: Range<u64>, is_over: &dyn Fn() -> bool) -> Option<Vec<u8>>;
    /// The result of a single scenario that killed every worker that ran it.
    fn given_up(&self, number: u64) -> Vec<u8>;
}

/// A campaign as a worker finds it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Offer {
    /// The identity that it has on the server; whether what it brings along is of this identity is for the caller to check.
    pub campaign: String,
    /// What it brings along, checked by its SHA-256.
    pub bundle: Vec<u8>,
}

/// What a worker is to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WorkerOrders {
    /// Threads that run ranges.
    pub threads: NonZeroUsize,
    /// The only campaign to work for; else all that there are, one after another.
    pub campaign: Option<String>,
    /// How long it waits for something to do before it leaves; else for ever.
    pub idle_exit: Option<Duration>,
    /// The version of what code means.
    pub meaning: u32,
    /// How it is called in progress and alarms: the computer and the process.
    pub name: String,
}

/// What happens at a worker.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum News {
    /// It is connected, and looks for something to do.
    Ready,
    /// It works for a campaign.
    Began {
        /// The campaign.
        campaign: String,
    },
    /// It does not work for a campaign.
    Refused {
        /// The campaign.
        campaign: String,
        /// Why.
        why: FarmError,
    },
    /// It works no longer for a campaign.
    Ended {
        /// The campaign.
        campaign: String,
        /// Ranges whose result it sent.
        ranges: u64,
    },
    /// The server does not answer as it should.
    Trouble {
        /// What it said.
        why: String,
    },
}

impl fmt::Display for News {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let short = |campaign: &str| campaign.get(..12).unwrap_or(campaign).to_owned();
        match self {
            Self::Ready => write!(f, "connected, waiting for campaigns"),
            Self::Began { campaign } => write!(f, "campaign {}: at work", short(campaign)),
            Self::Refused { campaign, why } => write!(f, "campaign {}: refused, {why}", short(campaign)),
            Self::Ended { campaign, ranges } => write!(f, "campaign {}: nothing left to do, {ranges} ranges done", short(campaign)),
            Self::Trouble { why } => write!(f, "trouble with the server: {why}"),
        }
    }
}

/// What a worker did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Done {
    /// Campaigns that it worked for.
    pub campaigns: u64,
    /// Ranges whose result it sent.
    pub ranges: u64,
    /// Ranges that it split because they came for the third time.
    pub split: u64,
    /// Scenarios that it gave up.
    pub given_up: u64,
}

/// Makes a campaign ready to be run.
pub type Opener<'a> = dyn Fn(&Offer) -> Result<Arc<dyn Work>, String> + Sync + 'a;

/// Works until it is over, or for too long there is nothing to do.
pub fn work(
    server: &Server,
    options: &Options,
    orders: &WorkerOrders,
    open: &Opener<'_>,
    is_over: &(dyn Fn() -> bool + Sync),
    tell: &mut dyn FnMut(&News),
) -> Result<Done, FarmError> {
    let only = match &orders.campaign {
        Some(campaign) => Some(Names::of(campaign).ok_or_else(|| FarmError::Campaign(campaign.clone()))?),
        None => None,
    };
    let runtime = runtime()?;
    let threads = orders.threads.get().min(THREADS_MAX);
    let (pool, answers) = Pool::new();
    std::thread::scope(|scope| {
        let mut started = Ok(());
        for _ in 0..threads {
            if let Err(error) = std::thread::Builder::new().spawn_scoped(scope, || pool.serve(open, is_over)) {
                started = Err(FarmError::System(error.to_string()));
                break;
            }
        }
        let outcome = started.and_then(|()| {
            runtime.block_on(async {
                let connection =
                    Connection::open(server, &format!("sieben worker {}", word(&orders.name)), options.patience, is_over).await?;
                tell(&News::Ready);
                let worker = Worker {
                    connection,
                    options,
                    orders,
                    threads,
                    name: word(&orders.name),
                    pool: &pool,
                    answers,
                    is_over,
                    open: Vec::new(),
                    refused: HashMap::new(),
                    busy: Instant::now(),
                    answered: Instant::now(),
                    trouble: String::new(),
                    next_key: 0,
                    done: Done::default(),
                };
                worker.serve(only, tell).await
            })
        });
        pool.close();
        outcome
    })
}

/// A worker with its connection.
struct Worker<'a> {
    connection: Connection,
    options: &'a Options,
    orders: &'a WorkerOrders,
    threads: usize,
    name: String,
    pool: &'a Pool,
    answers: pool::Answers,
    is_over: &'a (dyn Fn() -> bool + Sync),
    /// Campaigns whose programs are ready, the one that was used last at the end.
    open: Vec<(String, Arc<dyn Work>)>,
    /// What was refused: the description with which it was.
    refused: HashMap<String, String>,
    /// When it last had something to do.
    busy: Instant,
    /// When the server last did what was asked.
    answered: Instant,
    /// What the server said last when it did not.
    trouble: String,
    /// The number of the next range that it holds.
    next_key: u64,
    done: Done,
}

impl Worker<'_> {
    async fn serve(mut self, only: Option<Names>, tell: &mut dyn FnMut(&News)) -> Result<Done, FarmError> {
        while !(self.is_over)() {
            self.is_well()?;
            let campaigns = match &only {
                Some(names) => vec![names.clone()],
                None => self.campaigns().await,
            };
            let mut is_idle = true;
            for names in campaigns {
                match self.enter(&names, only.is_some(), tell).await? {
                    Some(campaign) => is_idle &= self.serves(campaign, tell).await? == Left::Idle,
                    None => continue,
                }
                if (self.is_over)() {
                    break;
                }
            }
            if self.orders.idle_exit.is_some_and(|idle| self.busy.elapsed() >= idle) {
                break;
            }
            if is_idle {
                self.rest().await;
            }
        }
        Ok(self.done)
    }

    async fn serves(&mut self, mut campaign: Campaign, tell: &mut dyn FnMut(&News)) -> Result<Left, FarmError> {
        let before = self.done.ranges;
        let left = campaign.serve(self, tell).await?;
        if campaign.has_begun() {
            tell(&News::Ended { campaign: campaign.identity().to_owned(), ranges: self.done.ranges - before });
        }
        Ok(left)
    }

    /// A pause before the next look, short enough that the end is heard.
    async fn rest(&self) {
        tokio::time::sleep(self.options.beat.min(Duration::from_millis(250))).await;
    }

    fn is_well(&self) -> Result<(), FarmError> {
        if let Some(refusal) = self.connection.refusal() {
            return Err(refusal);
        }
        let (away, why) = match self.connection.away() {
            Some(away) => (away, "no connection"),
            None => (self.answered.elapsed(), self.trouble.as_str()),
        };
        if away > self.options.patience {
            return Err(FarmError::Gone { place: self.connection.place.clone(), seconds: away.as_secs(), why: why.to_owned() });
        }
        Ok(())
    }

    /// The campaigns that there are.
    async fn campaigns(&mut self) -> Vec<Names> {
        let listed = timeout(ANSWER, async {
            let mut streams = self.connection.jetstream.stream_names();
            let mut found = Vec::new();
            while let Some(name) = streams.next().await {
                found.extend(Names::of_stream(&name?));
                if found.len() >= CAMPAIGNS_MAX {
                    break;
                }
            }
            Ok::<_, StreamsError>(found)
        });
        match listed.await {
            Ok(Ok(found)) => {
                self.answered = Instant::now();
                found
            }
            Ok(Err(error)) => {
                self.trouble = chain(&error);
                Vec::new()
            }
            Err(_) => Vec::new(),
        }
    }
}
