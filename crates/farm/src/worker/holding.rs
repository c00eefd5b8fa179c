//! A range that a worker holds: its lease, and how its result gets to the server.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use async_nats::jetstream::context::{PublishError, PublishErrorKind};
use async_nats::jetstream::message::PublishMessage;
use async_nats::jetstream::object_store::ObjectStore;
use async_nats::jetstream::stream::LastRawMessageErrorKind;
use async_nats::jetstream::{AckKind, Message};
use tokio::time::{sleep, timeout};

use crate::connection::{ANSWER, Connection, chain};
use crate::message::{Body, Job, Outcome, hash};
use crate::names::Names;
use crate::store;

/// Most bytes of a result in a message; a larger one becomes an object.
const MESSAGE_BYTES_MAX: usize = 512 << 10;

/// Bytes of a message that are no result.
const LINE: usize = 1 << 10;

/// What is said of a scenario that is run alone.
const MARKED: &str = "alone";

/// The pause before what failed is tried again.
const PAUSE: Duration = Duration::from_millis(300);

/// A range that this worker holds.
#[derive(Clone)]
pub(super) struct Held {
    pub message: Arc<Message>,
    pub job: Job,
    /// Whether a thread has it.
    pub has_begun: Arc<AtomicBool>,
}

impl Held {
    /// Asks for another lease.
    pub(super) async fn renew(&self) {
        let _ = timeout(ANSWER, self.message.ack_with(AckKind::Progress)).await;
    }

    /// Gives it back, so that another worker gets it.
    pub(super) async fn give_back(&self, delay: Option<Duration>) {
        let _ = timeout(ANSWER, self.message.ack_with(AckKind::Nak(delay))).await;
    }

    /// It is done; if this is lost the range comes again, and its result is the same bytes.
    async fn done(&self) {
        let _ = timeout(ANSWER, self.message.double_ack()).await;
    }
}

/// What a worker needs to send something.
#[derive(Clone)]
pub(super) struct Post {
    pub connection: Connection,
    pub names: Names,
    pub bucket: ObjectStore,
    pub worker: String,
    pub lease: Duration,
    pub patience: Duration,
    /// Whether nothing is wanted any longer.
    pub stop: Arc<AtomicBool>,
}

/// What came of sending.
pub(super) struct Sent {
    pub key: u64,
    pub what: What,
    /// Why it failed, if it did.
    pub trouble: Option<String>,
}

/// What was sent.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum What {
    Result,
    GivenUp,
    Halves,
}

impl Post {
    /// Sends a result, waits until the server has it, and says that the range is done.
    pub(super) async fn result(self, key: u64, held: Held, bytes: Vec<u8>, is_given_up: bool) -> Sent {
        let what = if is_given_up { What::GivenUp } else { What::Result };
        let trouble = self.try_result(&held, &bytes, is_given_up).await.err();
        Sent { key, what, trouble }
    }

    async fn try_result(&self, held: &Held, bytes: &[u8], is_given_up: bool) -> Result<(), String> {
        let digest = hash(bytes);
        let (job, worker) = (held.job.clone(), self.worker.clone());
        let most = MESSAGE_BYTES_MAX.min(self.connection.client.max_payload().saturating_sub(LINE));
        let body = match is_given_up {
            _ if bytes.len() > most => {
                self.object(&job.object(&digest), bytes).await?;
                Body::Object(bytes.len() as u64, digest.clone())
            }
            true => Body::GivenUp(bytes),
            false => Body::Whole(bytes),
        };
        let id = job.result_id(&digest);
        let payload = Outcome { job, worker, body }.write();
        self.publish(&self.names.result, &id, &payload).await?;
        held.done().await;
        Ok(())
    }

    async fn object(&self, name: &str, bytes: &[u8]) -> Result<(), String> {
        let begun = Instant::now();
        loop {
            // Stored, and the answer was lost: its name has its hash.
            if let Ok(Ok(info)) = timeout(ANSWER, self.bucket.info(name)).await
                && !info.deleted
                && info.size == bytes.len()
            {
                return Ok(());
            }
            match store::put(&self.connection, &self.bucket, name, None, bytes).await {
                Ok(()) => return Ok(()),
                Err(error) if self.gives_up(begun, self.patience) => return Err(error.to_string()),
                Err(_) => sleep(PAUSE).await,
            }
        }
    }

    /// Says on the server that a scenario is run alone now; whether a worker had said so before, and did not come back.
    pub(super) async fn marks(&self, job: &Job) -> Result<bool, String> {
        let silent = |_| "the server does not answer".to_owned();
        let bucket =
            self.connection.jetstream.get_stream_no_info(format!("OBJ_{}", self.names.bucket)).await.map_err(|error| chain(&error))?;
        let was_marked =
            match timeout(ANSWER, bucket.get_last_raw_message_by_subject(&self.names.mark(job.range.start))).await.map_err(silent)? {
                Ok(message) => message.payload == MARKED,
                Err(error) if error.kind() == LastRawMessageErrorKind::NoMessageFound => false,
                Err(error) => return Err(chain(&error)),
            };
        if !was_marked {
            timeout(ANSWER, self.mark(job, MARKED)).await.map_err(silent)?.map_err(|error| chain(&error))?;
        }
        Ok(was_marked)
    }

    /// Takes back what was said.
    pub(super) async fn unmarks(&self, job: &Job) {
        let _ = timeout(ANSWER, self.mark(job, "")).await;
    }

    async fn mark(&self, job: &Job, text: &'static str) -> Result<(), PublishError> {
        let message = PublishMessage::build().payload(text.into());
        self.connection.jetstream.send_publish(self.names.mark(job.range.start), message).await?.await.map(|_| ())
    }

    /// Queues the two halves of a range that came too often, and takes it out of the queue.
    pub(super) async fn halves(self, key: u64, held: Held, halves: [Job; 2]) -> Sent {
        let mut trouble = None;
        for half in halves {
            if let Err(why) = self.publish(&self.names.job, &half.id(), half.to_string().as_bytes()).await {
                trouble = Some(why);
            }
        }
        if trouble.is_none() {
            held.done().await;
        }
        Sent { key, what: What::Halves, trouble }
    }

    /// Publishes until the server has it.
    async fn publish(&self, subject: &str, id: &str, payload: &[u8]) -> Result<(), String> {
        let begun = Instant::now();
        loop {
            let Err(error) = self.try_publish(subject, id, payload).await else { return Ok(()) };
            let patience = match error.kind() {
                PublishErrorKind::MaxPayloadExceeded => Duration::ZERO,
                // The campaign has ended, or the run makes its streams again.
                PublishErrorKind::StreamNotFound => self.lease,
                _ => self.patience,
            };
            if self.gives_up(begun, patience) {
                return Err(chain(&error));
            }
            sleep(PAUSE).await;
        }
    }

    async fn try_publish(&self, subject: &str, id: &str, payload: &[u8]) -> Result<(), PublishError> {
        let message = PublishMessage::build().message_id(id).payload(payload.to_vec().into());
        self.connection.jetstream.send_publish(subject.to_owned(), message).await?.await.map(|_| ())
    }

    fn gives_up(&self, begun: Instant, patience: Duration) -> bool {
        self.stop.load(Ordering::Relaxed) || begun.elapsed() >= patience || self.connection.refusal().is_some()
    }
}
