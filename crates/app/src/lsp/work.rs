//! Work that takes long, in threads of its own: its results come back as events.

use std::sync::mpsc::SyncSender;
use std::thread;

use lsp_server::{ErrorCode, RequestId, ResponseError};
use serde_json::Value;

use super::transport::Event;
use crate::panics::{self, Trouble};

/// What came of a request.
pub(super) type Answer = Result<Value, ResponseError>;

/// A request that another thread worked on.
#[derive(Debug)]
pub(super) struct Finished {
    /// The request.
    pub(super) id: RequestId,
    /// What came of it.
    pub(super) answer: Answer,
}

/// An answer that says why there is none.
pub(super) fn refused(code: ErrorCode, message: impl Into<String>) -> ResponseError {
    ResponseError { code: code as i32, message: message.into(), data: None }
}

/// Works on a request without ever ending the process: a mistake of ours is its answer.
pub(super) fn survive(method: &str, work: impl FnOnce() -> Answer) -> Answer {
    panics::survive(|| Ok(work())).unwrap_or_else(|trouble| {
        let what = match trouble {
            Trouble::OurMistake(what) | Trouble::Refused(what) => what,
        };
        Err(refused(ErrorCode::InternalError, format!("`{method}` failed, which is our mistake, not yours; please report it: {what}")))
    })
}

/// Does work in a thread of its own and sends what came of it.
pub(super) fn start(
    id: RequestId,
    method: &'static str,
    events: SyncSender<Event>,
    work: impl FnOnce() -> Answer + Send + 'static,
) -> Result<(), ResponseError> {
    let run = move || {
        let answer = survive(method, work);
        // Without a server there is no client either.
        let _ = events.send(Event::Finished(Finished { id, answer }));
    };
    let started = thread::Builder::new().name(method.to_owned()).spawn(run);
    started.map(drop).map_err(|error| refused(ErrorCode::RequestFailed, format!("no thread can be started: {error}")))
}
