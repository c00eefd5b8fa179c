//! A connection to the server, and what is known of its health.

use std::error::Error;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use async_nats::client::RequestErrorKind;
use async_nats::jetstream::context::ContextBuilder;
use async_nats::jetstream::{Context, ErrorCode};
use async_nats::{Client, ConnectError, ConnectErrorKind, ConnectOptions, Event, ServerError};

use serde_json::Value;

use crate::error::FarmError;
use crate::server::{Login, Server};

/// How long the server may take for an answer.
pub(crate) const ANSWER: Duration = Duration::from_secs(5);

/// How long one attempt to connect may take.
const ATTEMPT: Duration = Duration::from_secs(5);

/// The pause between two attempts at the start.
const PAUSE: Duration = Duration::from_millis(250);

/// The longest pause between two attempts after a connection was lost.
const LONGEST_PAUSE: Duration = Duration::from_secs(4);

/// Most bytes of a file with credentials.
const CREDENTIALS_BYTES_MAX: u64 = 64 << 10;

/// A connection to the server; it is made again whenever it is lost.
#[derive(Clone)]
pub(crate) struct Connection {
    pub client: Client,
    pub jetstream: Context,
    /// Host and port, for messages.
    pub place: String,
    health: Arc<Health>,
}

/// What the client said of the connection.
#[derive(Default)]
struct Health(Mutex<State>);

#[derive(Default)]
struct State {
    lost: Option<Instant>,
    /// What the user may not do.
    refused: Option<String>,
    is_locked_out: bool,
}

impl Health {
    fn change(&self, change: impl FnOnce(&mut State)) {
        change(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner));
    }

    fn hears(&self, event: &Event) {
        self.change(|state| match event {
            Event::Connected => {
                state.lost = None;
                state.is_locked_out = false;
            }
            Event::Disconnected | Event::Closed => state.lost = state.lost.or_else(|| Some(Instant::now())),
            Event::ServerError(ServerError::AuthorizationViolation) => state.is_locked_out = true,
            Event::ServerError(ServerError::Other(text)) => {
                if let Some(what) = violation(text) {
                    state.refused = Some(what);
                }
            }
            _ => {}
        });
    }
}

/// What a user may not do, from the words of the server: `Permissions Violation for Publish to "x"`.
fn violation(text: &str) -> Option<String> {
    const WORDS: &str = "permissions violation for ";
    let at = text.to_ascii_lowercase().find(WORDS)?;
    let what = text.get(at + WORDS.len()..)?.trim_matches(['\'', ' ', '\r', '\n']);
    let (verb, rest) = what.split_once(' ')?;
    Some(format!("{} {rest}", verb.to_ascii_lowercase()))
}

impl Connection {
    /// Connects; a server that cannot be reached is tried until the time is over, what else goes wrong is said immediately.
    pub(crate) async fn open(server: &Server, name: &str, patience: Duration, is_over: &dyn Fn() -> bool) -> Result<Self, FarmError> {
        let begun = Instant::now();
        loop {
            match Self::attempt(server, name).await {
                Err(FarmError::Unreachable { .. }) if begun.elapsed() + PAUSE < patience && !is_over() => tokio::time::sleep(PAUSE).await,
                outcome => return outcome,
            }
        }
    }

    async fn attempt(server: &Server, name: &str) -> Result<Self, FarmError> {
        let (addresses, login) = server.parts()?;
        let place = server.place();
        let health = Arc::new(Health::default());
        let listening = health.clone();
        let mut options = ConnectOptions::new()
            .name(name)
            .connection_timeout(ATTEMPT)
            .request_timeout(Some(ANSWER))
            .ping_interval(Duration::from_secs(10))
            .event_callback(move |event| {
                listening.hears(&event);
                std::future::ready(())
            })
            .reconnect_delay_callback(|attempts| PAUSE.saturating_mul(1 << attempts.min(4)).min(LONGEST_PAUSE));
        options = match login {
            Login::None => options,
            Login::Token(token) => options.token(token),
            Login::User(user, password) => options.user_and_password(user, password),
        };
        if let Some(path) = &server.credentials {
            options = with_file(options, path)?;
        }
        if let Some(path) = &server.authority {
            if let Err(error) = std::fs::File::open(path) {
                return Err(FarmError::File { path: path.clone(), why: format!("cannot be read: {error}") });
            }
            options = options.add_root_certificates(path.clone()).require_tls(true);
        }
        let client = options.connect(addresses).await.map_err(|error| unreachable(&error, &place, server))?;
        let jetstream = ContextBuilder::new().timeout(ANSWER).ack_timeout(ANSWER).max_ack_inflight(4096).build(client.clone());
        let connection = Self { client, jetstream, place, health };
        connection.has_jetstream().await?;
        Ok(connection)
    }

    /// Asks the server about JetStream; what a server of 2.9 answers is more than the client reads itself.
    async fn has_jetstream(&self) -> Result<(), FarmError> {
        let none = || FarmError::NoJetStream { place: self.place.clone() };
        let answer = match self.client.request("$JS.API.INFO", "".into()).await {
            Ok(answer) => answer,
            Err(error) if error.kind() == RequestErrorKind::NoResponders => return Err(none()),
            Err(error) => return Err(self.failed("answer", &error)),
        };
        let answer: Value = serde_json::from_slice(&answer.payload).unwrap_or_default();
        let error = &answer["error"];
        match error["err_code"].as_u64() {
            None => Ok(()),
            Some(code) if is_without_jetstream(ErrorCode(code)) => Err(none()),
            Some(_) => Err(FarmError::Refused { what: "answer", why: error["description"].as_str().unwrap_or_default().to_owned() }),
        }
    }

    /// What is wrong with the connection for good, if anything is.
    pub(crate) fn refusal(&self) -> Option<FarmError> {
        let mut refusal = None;
        self.health.change(|state| {
            refusal = match &state.refused {
                Some(what) => Some(FarmError::Rights { what: what.clone() }),
                None => state.is_locked_out.then(|| FarmError::Login { place: self.place.clone() }),
            };
        });
        refusal
    }

    /// How long the server has been away; nothing if it is there.
    pub(crate) fn away(&self) -> Option<Duration> {
        let mut away = None;
        self.health.change(|state| away = state.lost.map(|lost| lost.elapsed()));
        away
    }

    /// Why something failed: a right that lacks, else what the server said.
    pub(crate) fn failed(&self, what: &'static str, error: &dyn Error) -> FarmError {
        self.refusal().unwrap_or_else(|| FarmError::Refused { what, why: chain(error) })
    }
}

fn is_without_jetstream(code: ErrorCode) -> bool {
    matches!(code, ErrorCode::JETSTREAM_NOT_ENABLED | ErrorCode::JETSTREAM_NOT_ENABLED_FOR_ACCOUNT)
}

/// An error with what caused it, in one line.
pub(crate) fn chain(error: &dyn Error) -> String {
    let mut text = error.to_string();
    let mut source = error.source();
    while let Some(inner) = source {
        let inner_text = inner.to_string();
        if !text.contains(&inner_text) {
            text.push_str(": ");
            text.push_str(&inner_text);
        }
        source = inner.source();
    }
    text.replace(['\n', '\r'], " ")
}

fn unreachable(error: &ConnectError, place: &str, server: &Server) -> FarmError {
    let place = place.to_owned();
    let why = chain(error);
    match error.kind() {
        ConnectErrorKind::ServerParse => FarmError::Address,
        ConnectErrorKind::AuthorizationViolation => FarmError::Login { place },
        ConnectErrorKind::Authentication => match &server.credentials {
            Some(path) => FarmError::File { path: path.clone(), why: "holds no seed that signs what the server asks".to_owned() },
            None => FarmError::Login { place },
        },
        ConnectErrorKind::Tls => FarmError::Certificate { place, why },
        _ if ["certificate", "Certificate", "tls", "TLS"].iter().any(|word| why.contains(word)) => FarmError::Certificate { place, why },
        _ => FarmError::Unreachable { place, why },
    }
}

/// A file of `nsc` with a token and a seed, or one with a seed alone.
fn with_file(options: ConnectOptions, path: &Path) -> Result<ConnectOptions, FarmError> {
    let failed = |why: String| FarmError::File { path: path.to_owned(), why };
    let size = std::fs::metadata(path).map_err(|error| failed(format!("cannot be read: {error}")))?.len();
    if size > CREDENTIALS_BYTES_MAX {
        return Err(failed(format!("is no file with credentials: it has {size} bytes")));
    }
    let text = std::fs::read_to_string(path).map_err(|error| failed(format!("cannot be read: {error}")))?;
    let wanted = || failed("is no file with credentials: it holds a JWT with its seed as `nsc` writes it, or a seed alone".to_owned());
    if text.contains("BEGIN NATS USER JWT") {
        return options.credentials(&text).map_err(|_| wanted());
    }
    let seed = text.lines().map(str::trim).find(|line| line.starts_with("SU") && line.len() == 58).ok_or_else(wanted)?;
    Ok(options.nkey(seed.to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_violation_names_what_was_refused() {
        assert_eq!(violation("Permissions Violation for Publish to \"sieben.1f.job\"").as_deref(), Some("publish to \"sieben.1f.job\""));
        assert_eq!(
            violation("'Permissions Violation for Subscription to \"_INBOX.x.>\"'").as_deref(),
            Some("subscription to \"_INBOX.x.>\"")
        );
        assert_eq!(violation("Stale Connection"), None);
    }
}
