//! How a worker enters a campaign: it looks whether it can run it, and makes its program ready.

use std::sync::Arc;
use std::time::Instant;

use async_nats::jetstream::consumer::{Consumer, pull};
use async_nats::jetstream::object_store::ObjectStore;
use tokio::time::timeout;

use super::holding::Post;
use super::pool::{Answer, Task};
use super::serving::Campaign;
use super::{News, Offer, Work, Worker};
use crate::connection::{ANSWER, chain};
use crate::error::FarmError;
use crate::message::{hash, read_description};
use crate::names::{CONSUMER, Names, PROGRAM};
use crate::store::{self, BUNDLE_BYTES_MAX};

/// Most campaigns that a worker keeps open; the program of each is in memory.
const OPEN_MAX: usize = 4;

impl Worker<'_> {
    /// Enters a campaign, if there is one and this worker can run it.
    pub(super) async fn enter(&mut self, names: &Names, is_only: bool, tell: &mut dyn FnMut(&News)) -> Result<Option<Campaign>, FarmError> {
        let entered = timeout(ANSWER * 3, self.found(names)).await;
        let (bucket, description, size, consumer) = match entered {
            Ok(Ok(Some(found))) => found,
            Ok(Ok(None)) | Err(_) => return Ok(None),
            Ok(Err(why)) => {
                self.trouble = why;
                return Ok(None);
            }
        };
        self.answered = Instant::now();
        let is_pending = consumer.cached_info().num_pending > 0;
        let campaign = &names.campaign;
        if self.refused.get(campaign) == Some(&description)
            || !(is_pending || is_only || self.open.iter().any(|(open, _)| open == campaign))
        {
            return Ok(None);
        }
        let work = match self.open.iter().position(|(open, _)| open == campaign) {
            Some(index) => {
                let open = self.open.remove(index);
                self.open.push(open);
                self.open[self.open.len() - 1].1.clone()
            }
            None => match self.opened(campaign, &bucket, &description, size).await {
                Ok(work) => work,
                Err(Stop::Trouble(why)) => {
                    self.trouble = why;
                    return Ok(None);
                }
                Err(Stop::Refused(why)) if is_only => return Err(why),
                Err(Stop::Refused(why)) => {
                    tell(&News::Refused { campaign: campaign.clone(), why });
                    self.refused.insert(campaign.clone(), description);
                    return Ok(None);
                }
            },
        };
        let Ok(state) = self.connection.client.subscribe(names.state.clone()).await else { return Ok(None) };
        let lease = Some(consumer.cached_info().config.ack_wait).filter(|lease| !lease.is_zero()).unwrap_or(self.options.lease);
        let post = Post {
            connection: self.connection.clone(),
            names: names.clone(),
            bucket,
            worker: self.name.clone(),
            lease,
            patience: self.options.patience,
            stop: Arc::default(),
        };
        Ok(Some(Campaign::new(consumer, work, post, state)))
    }

    /// What the server has of a campaign: its bucket, the description and size of what it brings along, and its consumer.
    async fn found(&self, names: &Names) -> Result<Option<(ObjectStore, String, u64, Consumer<pull::Config>)>, String> {
        let jetstream = &self.connection.jetstream;
        let bucket = match jetstream.get_object_store(&names.bucket).await {
            Ok(bucket) => bucket,
            Err(error) if store::is_no_bucket(&error) => return Ok(None),
            Err(error) => return Err(chain(&error)),
        };
        let Ok(info) = bucket.info(PROGRAM).await else { return Ok(None) };
        let Some(description) = info.description.filter(|_| !info.deleted) else { return Ok(None) };
        let Ok(consumer) = jetstream.get_consumer_from_stream(CONSUMER, &names.jobs).await else { return Ok(None) };
        Ok(Some((bucket, description, info.size as u64, consumer)))
    }

    async fn opened(&mut self, campaign: &str, bucket: &ObjectStore, description: &str, size: u64) -> Result<Arc<dyn Work>, Stop> {
        let refused = |why: &str| Stop::Refused(FarmError::Bundle(why.to_owned()));
        let Some((theirs, digest)) = read_description(description) else { return Err(refused("it is not described as one of Sieben")) };
        let ours = self.orders.meaning;
        if theirs != ours {
            return Err(Stop::Refused(FarmError::Meaning { theirs, ours }));
        }
        if size > BUNDLE_BYTES_MAX {
            let what = "the program of the campaign";
            return Err(Stop::Refused(FarmError::TooLarge { what, bytes: size, max: BUNDLE_BYTES_MAX }));
        }
        let bundle = store::get(bucket, PROGRAM, BUNDLE_BYTES_MAX).await.map_err(Stop::Trouble)?;
        if hash(&bundle) != digest {
            return Err(refused("its SHA-256 is another one than was announced"));
        }
        self.pool.put(Task::Open(Offer { campaign: campaign.to_owned(), bundle }));
        let work = loop {
            match self.answers.recv().await {
                Some(Answer::Opened(Ok(work))) => break work,
                Some(Answer::Opened(Err(why))) => return Err(refused(&why)),
                // Of a campaign that was left.
                Some(Answer::Ran(..)) => {}
                None => return Err(Stop::Trouble("the threads have ended".to_owned())),
            }
        };
        if self.open.len() >= OPEN_MAX {
            self.open.remove(0);
        }
        self.open.push((campaign.to_owned(), work.clone()));
        Ok(work)
    }
}

/// Why a campaign was not opened.
enum Stop {
    /// It never will be.
    Refused(FarmError),
    /// Perhaps later.
    Trouble(String),
}
