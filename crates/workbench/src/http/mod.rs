//! What is answered over HTTP: who may ask, and where each path leads.

mod api;
mod assets;
mod book;
mod connections;
mod events;
mod limits;
mod openapi;
mod problem;
mod query;
mod routes;
mod security;
mod socket;

use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use axum::body::{Body, Bytes};
use axum::extract::{FromRequestParts, Request, WebSocketUpgrade};
use axum::http::{HeaderMap, Method, Response, StatusCode, header, request::Parts};
use sieben_model::problems::Problem;
use sieben_workspace::{Closed, Refusal};

pub(crate) use connections::serve;
pub(crate) use limits::Limits;

use crate::access::{Credentials, Denied, Role};
use crate::server::Shared;
use query::Query;

/// Longest body of a request, in bytes.
const BODY_BYTES_MAX: usize = 64 * 1024;

/// How long the body of a request may take.
const BODY_WAIT_MAX: Duration = Duration::from_secs(10);

/// A request with who sends it.
struct From<'r> {
    peer: SocketAddr,
    role: Role,
    headers: &'r HeaderMap,
    query: Query,
}

/// Answers any request.
async fn answer(shared: Arc<Shared>, peer: SocketAddr, request: Request) -> Response<Body> {
    let (parts, body) = request.into_parts();
    let mut response = match answered(&shared, peer, parts, body).await {
        Ok(response) => response,
        Err(refusal) => problem::response(&refusal),
    };
    security::protect(&mut response);
    response
}

async fn answered(shared: &Arc<Shared>, peer: SocketAddr, mut parts: Parts, body: Body) -> Result<Response<Body>, Refusal> {
    if !shared.limits.allows(peer.ip(), shared.hub.gate.now_us()) {
        return Err(Refusal::new(Problem::P7136, format!("more than {} requests came within a second", limits::PER_SECOND_MAX)));
    }
    let query = Query::parse(parts.uri.query().unwrap_or_default());
    let role = role(shared, &parts.headers, &query);
    let path = parts.uri.path().to_owned();
    let is_open = !(path.starts_with("/api/") || path == "/ws" || path == "/metrics");
    let role = match role {
        Ok(role) => role,
        // The code of the page has no data in it.
        Err(Denied::Token) if is_open => Role::View,
        Err(denied) => return Err(refused(denied)),
    };
    if path == "/ws" {
        let upgrade = WebSocketUpgrade::from_request_parts(&mut parts, &()).await.map_err(|_| {
            Refusal::new(Problem::P7131, "`/ws` is a WebSocket, and the request does not ask for one")
                .help("open it with a browser, or with a client of WebSockets")
        })?;
        return Ok(socket::upgrade(upgrade, Arc::clone(shared), peer, role));
    }
    let from = From { peer, role, headers: &parts.headers, query };
    match path.as_str() {
        "/metrics" => metrics(shared, &parts.method).await,
        "/api/v1/events" => events::stream(shared, &from, &parts.method),
        _ if path.starts_with("/api/") => {
            let body = body_bytes(body).await?;
            api::answer(shared, from, &parts.method, &path, body).await
        }
        _ if path == "/docs" || path.starts_with("/docs/") => get(&parts.method, || book::page(&path)),
        _ => get(&parts.method, || assets::file(&path, &from)),
    }
}

/// Whatever is only fetched.
fn get(method: &Method, answer: impl FnOnce() -> Result<Response<Body>, Refusal>) -> Result<Response<Body>, Refusal> {
    match *method {
        Method::GET | Method::HEAD => answer(),
        _ => Err(not_taken(method, &["GET"])),
    }
}

fn not_taken(method: &Method, takes: &[&str]) -> Refusal {
    Refusal::new(Problem::P7138, format!("this address does not take {method}; it takes {}", takes.join(", ")))
}

fn refused(denied: Denied) -> Refusal {
    match denied {
        Denied::Host => Refusal::new(Problem::P7135, "the request names another server than this one"),
        Denied::Origin => Refusal::new(Problem::P7134, "the request comes from a page of another server"),
        Denied::Token => Refusal::new(Problem::P7132, "the token is missing or wrong"),
        Denied::Role => Refusal::new(Problem::P7133, "this token is for looking only"),
    }
}

fn role(shared: &Shared, headers: &HeaderMap, query: &Query) -> Result<Role, Denied> {
    let text = |name| headers.get(name).and_then(|value| value.to_str().ok());
    if headers.get_all(header::HOST).iter().count() > 1 {
        return Err(Denied::Host);
    }
    let bearer = text(header::AUTHORIZATION).and_then(|value| value.strip_prefix("Bearer "));
    shared.access.role(Credentials { host: text(header::HOST), origin: text(header::ORIGIN), token: bearer.or(query.get("token")) })
}

async fn body_bytes(body: Body) -> Result<Bytes, Refusal> {
    let too_long = |_| Refusal::new(Problem::P7130, format!("a request has at most {BODY_BYTES_MAX} bytes"));
    let bytes = tokio::time::timeout(BODY_WAIT_MAX, axum::body::to_bytes(body, BODY_BYTES_MAX));
    let late = |_| Refusal::new(Problem::P7131, format!("the body of a request comes within {} seconds", BODY_WAIT_MAX.as_secs()));
    bytes.await.map_err(late)?.map_err(too_long)
}

/// The numbers of the run, as Prometheus takes them.
async fn metrics(shared: &Arc<Shared>, method: &Method) -> Result<Response<Body>, Refusal> {
    if !matches!(*method, Method::GET | Method::HEAD) {
        return Err(not_taken(method, &["GET"]));
    }
    let asked = Arc::clone(shared);
    let text = blocking(move || (asked.metrics)()).await?;
    let text = text.ok_or(Closed)?;
    Ok(response(StatusCode::OK, "text/plain; version=0.0.4; charset=utf-8", text))
}

/// Does something that waits for the CPU, while others are answered.
async fn blocking<R: Send + 'static>(work: impl FnOnce() -> R + Send + 'static) -> Result<R, Refusal> {
    tokio::task::spawn_blocking(work).await.map_err(|_| Refusal::new(Problem::P7094, "the server ends"))
}

/// A response with a body of this kind.
fn response(status: StatusCode, kind: &str, body: impl Into<Body>) -> Response<Body> {
    let mut response = Response::new(body.into());
    *response.status_mut() = status;
    if let Ok(kind) = kind.parse() {
        response.headers_mut().insert(header::CONTENT_TYPE, kind);
    }
    response
}
