//! What a campaign has on the server: two streams, a consumer and a bucket.

use std::error::Error;
use std::time::Duration;

use async_nats::jetstream::consumer::{AckPolicy, pull};
use async_nats::jetstream::context::{ConsumerInfoErrorKind, CreateStreamErrorKind, GetStreamErrorKind, ObjectStoreError};
use async_nats::jetstream::object_store::{self, ObjectMetadata, ObjectStore};
use async_nats::jetstream::stream::{self, DiscardPolicy, RetentionPolicy, Stream};
use async_nats::jetstream::{Context, ErrorCode};
use tokio::io::AsyncReadExt;
use tokio::time::timeout;

use crate::connection::Connection;
use crate::error::FarmError;
use crate::ledger::Announced;
use crate::message::{description, hash};
use crate::names::{CONSUMER, Names, PROGRAM};
use crate::options::Options;

/// How long the server drops a second message with the same identity.
const DUPLICATES: Duration = Duration::from_secs(120);

/// Most ranges that workers hold at the same time.
const HELD_MAX: i64 = 50_000;

/// Most workers that wait for ranges at the same time.
const WAITING_MAX: i64 = 10_000;

/// How long an object may stand still while it is fetched.
const STANDSTILL: Duration = Duration::from_secs(10);

/// How long an object may take to be stored.
const PUT: Duration = Duration::from_secs(120);

/// Most bytes of what a campaign brings along.
pub(crate) const BUNDLE_BYTES_MAX: u64 = 256 << 20;

/// What is there of a campaign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Found {
    /// Ranges that are queued or held.
    pub queued: u64,
    pub results: FoundResults,
}

fn jobs(names: &Names, options: &Options) -> stream::Config {
    stream::Config {
        name: names.jobs.clone(),
        subjects: vec![names.job.clone()],
        retention: RetentionPolicy::WorkQueue,
        discard: DiscardPolicy::New,
        max_messages: i64::try_from(options.queue.max(1)).unwrap_or(i64::MAX),
        duplicate_window: DUPLICATES,
        ..stream::Config::default()
    }
}

fn results(names: &Names) -> stream::Config {
    stream::Config {
        name: names.results.clone(),
        subjects: vec![names.result.clone()],
        retention: RetentionPolicy::Limits,
        duplicate_window: DUPLICATES,
        ..stream::Config::default()
    }
}

fn consumer(options: &Options) -> pull::Config {
    pull::Config {
        durable_name: Some(CONSUMER.to_owned()),
        ack_policy: AckPolicy::Explicit,
        ack_wait: options.lease,
        max_deliver: -1,
        max_ack_pending: HELD_MAX,
        max_waiting: WAITING_MAX,
        ..pull::Config::default()
    }
}

/// What is there of the results.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct FoundResults {
    /// The sequence number of the newest one.
    pub newest: u64,
    /// When the stream was made, in nanoseconds: one that was lost and made again is another one.
    pub created: i128,
}

impl FoundResults {
    fn of(stream: &Stream) -> Self {
        let info = stream.cached_info();
        Self { newest: info.state.last_sequence, created: info.created.unix_timestamp_nanos() }
    }
}

/// Makes what is missing; what is there with other settings gets these.
pub(crate) async fn set_up(
    connection: &Connection,
    names: &Names,
    options: &Options,
    announced: &Announced,
) -> Result<FoundResults, FarmError> {
    let bucket = object_store::Config { bucket: names.bucket.clone(), ..object_store::Config::default() };
    let bucket = connection.jetstream.create_object_store(bucket).await;
    let bucket = bucket.map_err(|error| connection.failed("make the bucket of the campaign", &error))?;
    announce(connection, &bucket, announced).await?;
    let results = FoundResults::of(&made(connection, results(names)).await?);
    let stream = made(connection, jobs(names, options)).await?;
    let made = stream.create_consumer(consumer(options)).await;
    made.map(|_| results).map_err(|error| connection.failed("make the consumer of the workers", &error))
}

/// Makes a stream, or gives one that is there these settings.
async fn made(connection: &Connection, config: stream::Config) -> Result<Stream, FarmError> {
    let jetstream = &connection.jetstream;
    let failed = |error: &dyn Error| connection.failed("make a stream of the campaign", error);
    match jetstream.create_stream(config.clone()).await {
        Ok(stream) => return Ok(stream),
        Err(error) => match error.kind() {
            CreateStreamErrorKind::JetStream(other) if other.error_code() == ErrorCode::STREAM_NAME_EXIST => {}
            _ => return Err(failed(&error)),
        },
    }
    let name = config.name.clone();
    if jetstream.update_stream(config.clone()).await.is_err() {
        // Of another kind: what it holds is not what a campaign needs, and comes again.
        jetstream.delete_stream(&name).await.map_err(|error| failed(&error))?;
        return jetstream.create_stream(config).await.map_err(|error| failed(&error));
    }
    jetstream.get_stream(&name).await.map_err(|error| failed(&error))
}

async fn announce(connection: &Connection, bucket: &ObjectStore, announced: &Announced) -> Result<(), FarmError> {
    let size = announced.bundle.len() as u64;
    if size > BUNDLE_BYTES_MAX {
        return Err(FarmError::TooLarge { what: "the program of the campaign", bytes: size, max: BUNDLE_BYTES_MAX });
    }
    let description = description(announced.meaning, &hash(&announced.bundle));
    if let Ok(info) = bucket.info(PROGRAM).await
        && !info.deleted
        && info.description.as_deref() == Some(&description)
        && info.size as u64 == size
    {
        return Ok(());
    }
    put(connection, bucket, PROGRAM, Some(description), &announced.bundle).await
}

/// Stores an object.
pub(crate) async fn put(
    connection: &Connection,
    bucket: &ObjectStore,
    name: &str,
    description: Option<String>,
    bytes: &[u8],
) -> Result<(), FarmError> {
    let meta = ObjectMetadata { name: name.to_owned(), description, ..ObjectMetadata::default() };
    match timeout(PUT, bucket.put(meta, &mut &*bytes)).await {
        Ok(Ok(_)) => Ok(()),
        Ok(Err(error)) => Err(connection.failed("store an object of the campaign", &error)),
        Err(_) => Err(connection.failed("store an object of the campaign", &Silent)),
    }
}

/// The server says nothing.
#[derive(Debug)]
struct Silent;

impl std::fmt::Display for Silent {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("it does not answer")
    }
}

impl Error for Silent {}

/// Fetches an object of at most so many bytes.
pub(crate) async fn get(bucket: &ObjectStore, name: &str, max: u64) -> Result<Vec<u8>, String> {
    let silent = |_| Silent.to_string();
    let mut object = timeout(STANDSTILL, bucket.get(name)).await.map_err(silent)?.map_err(|error| crate::connection::chain(&error))?;
    if object.info().size as u64 > max {
        return Err(format!("it has {} bytes, more than {max}", object.info().size));
    }
    let mut bytes = Vec::new();
    loop {
        let read = timeout(STANDSTILL, object.read_buf(&mut bytes)).await.map_err(silent)?.map_err(|error| error.to_string())?;
        if bytes.len() as u64 > max {
            return Err(format!("it has more than {max} bytes"));
        }
        if read == 0 {
            return Ok(bytes);
        }
    }
}

/// Looks at what is there: `None` if a part of it is missing.
pub(crate) async fn look(jetstream: &Context, names: &Names) -> Result<Option<Found>, String> {
    let Some(jobs) = there(jetstream, &names.jobs).await? else { return Ok(None) };
    let Some(results) = there(jetstream, &names.results).await? else { return Ok(None) };
    if there(jetstream, &format!("OBJ_{}", names.bucket)).await?.is_none() {
        return Ok(None);
    }
    if let Err(error) = jobs.consumer_info(CONSUMER).await {
        return match error.kind() {
            ConsumerInfoErrorKind::NotFound | ConsumerInfoErrorKind::StreamNotFound => Ok(None),
            ConsumerInfoErrorKind::JetStream(error) if is_missing(error.error_code()) => Ok(None),
            _ => Err(crate::connection::chain(&error)),
        };
    }
    Ok(Some(Found { queued: jobs.cached_info().state.messages, results: FoundResults::of(&results) }))
}

async fn there(jetstream: &Context, name: &str) -> Result<Option<Stream>, String> {
    match jetstream.get_stream(name).await {
        Ok(stream) => Ok(Some(stream)),
        Err(error) => match error.kind() {
            GetStreamErrorKind::JetStream(error) if is_missing(error.error_code()) => Ok(None),
            _ => Err(crate::connection::chain(&error)),
        },
    }
}

/// Whether the server says that a stream or consumer does not exist.
pub(crate) fn is_missing(code: ErrorCode) -> bool {
    matches!(code, ErrorCode::STREAM_NOT_FOUND | ErrorCode::CONSUMER_NOT_FOUND)
}

/// Whether getting a bucket failed because there is none.
pub(crate) fn is_no_bucket(error: &ObjectStoreError) -> bool {
    error
        .source()
        .and_then(|source| source.downcast_ref::<async_nats::jetstream::context::GetStreamError>())
        .is_some_and(|error| matches!(error.kind(), GetStreamErrorKind::JetStream(error) if is_missing(error.error_code())))
}

/// Removes all of it; whether nothing is left.
pub(crate) async fn remove(jetstream: &Context, names: &Names) -> bool {
    let mut is_removed = true;
    for name in [names.jobs.clone(), names.results.clone(), format!("OBJ_{}", names.bucket)] {
        let gone = match jetstream.delete_stream(&name).await {
            Ok(_) => true,
            Err(_) => matches!(there(jetstream, &name).await, Ok(None)),
        };
        is_removed &= gone;
    }
    is_removed
}
