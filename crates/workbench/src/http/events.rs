//! What happens, as events that a server sends: the mode, programs that take over, entries of the diagnostic buffer.

use std::pin::Pin;
use std::sync::Arc;
use std::task::{Context, Poll};
use std::time::Duration;

use axum::body::{Body, Bytes};
use axum::http::{HeaderValue, Method, Response, StatusCode, header};
use futures_core::Stream;
use serde_json::json;
use sieben_model::problems::Problem;
use sieben_workspace::Refusal;
use sieben_workspace::control::answer::Answer;
use sieben_workspace::control::{Control, Request};
use tokio::sync::mpsc;

use super::api::peer_text;
use super::{From, blocking, get, response};
use crate::hub::{PAGES_MAX, Visitor};
use crate::server::Shared;

/// Events that wait for a slow client; one more, and it has to come again.
const WAITING_MAX: usize = 64;
/// Time between two looks.
const LOOK: Duration = Duration::from_millis(250);
/// Time after which a sign of life is sent.
const SIGN: Duration = Duration::from_secs(15);

/// Events as a body.
struct Events(mpsc::Receiver<String>);

impl Stream for Events {
    type Item = Result<Bytes, std::convert::Infallible>;
    fn poll_next(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<Option<Self::Item>> {
        self.0.poll_recv(context).map(|event| event.map(|event| Ok(Bytes::from(event))))
    }
}

/// The stream of events.
pub(super) fn stream(shared: &Arc<Shared>, from: &From<'_>, method: &Method) -> Result<Response<Body>, Refusal> {
    get(method, || {
        let visitor = Visitor { peer: peer_text(from.peer), role: from.role };
        let too_many = || Refusal::new(Problem::P7136, format!("{PAGES_MAX} pages are open already"));
        let page = shared.hub.enter(visitor).ok_or_else(too_many)?;
        let (events, waiting) = mpsc::channel(WAITING_MAX);
        let shared = Arc::clone(shared);
        tokio::spawn(async move {
            watch(&shared, &events).await;
            shared.hub.leave(page);
        });
        let mut response = response(StatusCode::OK, "text/event-stream", Body::from_stream(Events(waiting)));
        response.headers_mut().insert(header::CACHE_CONTROL, HeaderValue::from_static("no-store"));
        Ok(response)
    })
}

/// Looks for what happens until the client goes or the run is over.
async fn watch(shared: &Arc<Shared>, events: &mpsc::Sender<String>) {
    let (mut mode, mut program, mut entry): (String, Option<String>, Option<(u64, u64)>) = Default::default();
    let mut silent = Duration::ZERO;
    loop {
        let asked = Arc::clone(shared);
        let after = entry;
        let looked = blocking(move || {
            let hub = &asked.hub;
            let mut control = Control::new(Arc::clone(&hub.facts));
            let state = control.answer(&hub.gate, &hub.desk, &Request::State);
            let Ok(Answer::State(state)) = state else { return None };
            // Another CPU counts its entries from 0 again.
            let after = after.map(|(run, after)| if run == state.run { after } else { 0 });
            let new = after.filter(|&after| state.newest_entry > after);
            let entries = new.map(|after| control.answer(&hub.gate, &hub.desk, &Request::Diagnostics { after }));
            Some((state, entries, hub.program().hash(), asked.projects.listed().name))
        });
        let Ok(Some((state, entries, hash, project))) = looked.await else {
            let _ = events.try_send(named("bye", &json!({ "why": "P7094", "text": "the run is over" })));
            return;
        };
        let mut said = Vec::new();
        let now = state.mode.to_string();
        if now != mode {
            said.push(named("mode", &json!({ "mode": now, "scans": state.scans, "why": state.stop.as_ref().map(|stop| &stop.text) })));
            mode = now;
        }
        if program.as_ref() != Some(&hash) {
            said.push(named("program", &json!({ "hash": hash, "project": project })));
            program = Some(hash);
        }
        if let Some(Ok(answer @ Answer::Diagnostics(_))) = &entries {
            said.push(named("diagnostics", &serde_json::Value::Object(answer.fields())));
        }
        entry = Some((state.run, state.newest_entry));
        silent = if said.is_empty() { silent + LOOK } else { Duration::ZERO };
        if silent >= SIGN {
            silent = Duration::ZERO;
            said.push(": still here\n\n".to_owned());
        }
        for event in said {
            if events.try_send(event).is_err() {
                return;
            }
        }
        tokio::select! {
            () = events.closed() => return,
            () = tokio::time::sleep(LOOK) => {}
        }
    }
}

fn named(name: &str, data: &serde_json::Value) -> String {
    format!("event: {name}\ndata: {data}\n\n")
}
