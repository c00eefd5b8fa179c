//! The WebSocket of a page: frames in, scans out.

use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use axum::body::Body;
use axum::extract::ws::{Message, WebSocket, WebSocketUpgrade};
use axum::http::Response;
use serde_json::json;
use sieben_model::problems::Problem;
use sieben_workspace::Refusal;
use tokio::sync::watch;
use tokio::time::timeout;

use super::api::peer_text;
use crate::access::Role;
use crate::hub::{Hub, PAGES_MAX, Visitor};
use crate::live::client::{Asked, Client, Live, bye, event};
use crate::live::message::{At, FRAME_BYTES_MAX};
use crate::live::shot::Shot;
use crate::server::Shared;

/// Longest frame that is read at all: one that is too long is still answered with why.
const READ_BYTES_MAX: usize = 2 * FRAME_BYTES_MAX;
/// How long a page may take for a message that does not fit into its socket.
const SEND_WAIT_MAX: Duration = Duration::from_secs(15);
/// How long a page may wait with its first message.
const HELLO_WAIT_MAX: Duration = Duration::from_secs(10);
/// Longest wait before it is looked whether a page is still there.
const LOOK_AGAIN: Duration = Duration::from_secs(1);

/// Answers the request for a WebSocket.
pub(super) fn upgrade(upgrade: WebSocketUpgrade, shared: Arc<Shared>, peer: SocketAddr, role: Role) -> Response<Body> {
    let upgrade = upgrade.max_message_size(READ_BYTES_MAX).max_frame_size(READ_BYTES_MAX);
    upgrade.on_upgrade(move |mut socket| async move {
        let visitor = Visitor { peer: peer_text(peer), role };
        let end = match shared.hub.enter(visitor) {
            Some(page) => {
                let end = serve(&mut socket, &shared, page, role).await;
                shared.hub.leave(page);
                end
            }
            None => Err(Refusal::new(Problem::P7130, format!("{PAGES_MAX} pages are open already"))),
        };
        if let Err(refusal) = end {
            // One that has gone hears nothing.
            let _ = timeout(LOOK_AGAIN, socket.send(Message::Text(bye(&refusal).into()))).await;
        }
        let _ = timeout(LOOK_AGAIN, socket.send(Message::Close(None))).await;
    })
}

/// The connection has ended.
struct Gone;

async fn send(socket: &mut WebSocket, text: String) -> Result<(), Gone> {
    match timeout(SEND_WAIT_MAX, socket.send(Message::Text(text.into()))).await {
        Ok(Ok(())) => Ok(()),
        _ => Err(Gone),
    }
}

/// What came: a text, nothing that matters, or the end.
async fn receive(socket: &mut WebSocket) -> Result<Option<Vec<u8>>, Option<Refusal>> {
    match socket.recv().await {
        Some(Ok(Message::Text(text))) => Ok(Some(text.as_bytes().to_vec())),
        Some(Ok(Message::Binary(bytes))) => Ok(Some(bytes.to_vec())),
        Some(Ok(Message::Ping(_) | Message::Pong(_))) => Ok(None),
        Some(Ok(Message::Close(_))) | None => Err(None),
        Some(Err(error)) => Err(Some(Refusal::new(Problem::P7131, format!("the frame cannot be read: {error}")))),
    }
}

/// Serves a page until it goes.
///
/// # Errors
/// It is sent away.
async fn serve(socket: &mut WebSocket, shared: &Shared, page: u64, role: Role) -> Result<(), Refusal> {
    let hub = &shared.hub;
    let mut client = Client::default();
    let mut looks = hub.looks();
    looks.mark_unchanged();
    let first = match timeout(HELLO_WAIT_MAX, receive(socket)).await {
        Ok(Ok(Some(frame))) => frame,
        Ok(Ok(None)) => b"{\"t\":\"hello\",\"v\":1}".to_vec(),
        Ok(Err(None)) => return Ok(()),
        Ok(Err(Some(refusal))) => return Err(refusal),
        Err(_) => return Err(Refusal::new(Problem::P7131, "a page says `hello` within ten seconds")),
    };
    client.hear(&first, hub.gate.now_us())?;
    if send(socket, welcome(shared, role)).await.is_err() {
        return Ok(());
    }
    loop {
        let now_us = hub.gate.now_us();
        if client.is_gone(now_us) {
            return Err(Refusal::new(Problem::P7130, "no message was acknowledged for 15 seconds"));
        }
        let due = client.due_us(now_us).map(|due| Duration::from_micros(due.saturating_sub(now_us)));
        let has_news = matches!(due, Some(due) if due.is_zero());
        tokio::select! {
            biased;
            came = receive(socket) => match came {
                Ok(None) => {}
                Ok(Some(frame)) => {
                    let asked = client.hear(&frame, hub.gate.now_us())?;
                    hub.wanted.set(page, Some(client.wanted(&hub.program())));
                    if let Some(asked) = asked
                        && let Some(text) = answer(hub, &mut client, asked)
                        && send(socket, text).await.is_err()
                    {
                        return Ok(());
                    }
                }
                Err(None) => return Ok(()),
                Err(Some(refusal)) => return Err(refusal),
            },
            changed = looks.changed(), if has_news => {
                if changed.is_err() {
                    return Err(over());
                }
                let shot = newest(&mut looks)?;
                if tell(socket, &mut client, &shot, hub).await?.is_err() {
                    return Ok(());
                }
            }
            () = tokio::time::sleep(due.filter(|due| !due.is_zero()).unwrap_or(LOOK_AGAIN)) => {
                if hub.is_over() {
                    return Err(over());
                }
            }
        }
    }
}

fn over() -> Refusal {
    Refusal::new(Problem::P7094, "the run is over")
}

/// The newest look.
fn newest(looks: &mut watch::Receiver<Option<Arc<Shot>>>) -> Result<Arc<Shot>, Refusal> {
    looks.borrow_and_update().clone().ok_or_else(over)
}

/// Sends what is new of a scan.
async fn tell(socket: &mut WebSocket, client: &mut Client, shot: &Shot, hub: &Hub) -> Result<Result<(), Gone>, Refusal> {
    if let Some(text) = client.meets(shot)
        && send(socket, text).await.is_err()
    {
        return Ok(Err(Gone));
    }
    Ok(match client.update(shot, Live::Yes, hub.gate.now_us())? {
        Some(text) => send(socket, text).await,
        None => Ok(()),
    })
}

/// What a page is sent first.
fn welcome(shared: &Shared, role: Role) -> String {
    let hub = &shared.hub;
    let program = hub.program();
    let head = hub.gate.enter(|plant| (plant.cpu.cpu_type().name, plant.scans, plant.pace.cycle_us));
    let (cpu, scans, cycle_us) = head.unwrap_or_default();
    json!({
        "t": "welcome", "v": 1, "cpu": cpu, "project": program.facts.project.as_deref().unwrap_or("Sieben"), "program": program.hash(),
        "role": role.word(), "oldest": scans, "newest": scans, "cycle_us": cycle_us, "mnemonics": "en",
    })
    .to_string()
}

/// Answers what is no subscription.
fn answer(hub: &Hub, client: &mut Client, asked: Asked) -> Option<String> {
    let newest = hub.looks().borrow().as_ref().map_or(0, |shot| shot.head.newest);
    match asked {
        Asked::At(At::Live) => {
            client.forget();
            None
        }
        Asked::At(At::Scan(scan)) if scan >= newest => {
            client.forget();
            None
        }
        Asked::At(_) => Some(event(&Refusal::new(Problem::P7139, "scans of the past are not kept"))),
        Asked::History(history) => {
            let mut answer: serde_json::Value = json!({ "t": "history", "id": history.id, "from": newest, "to": newest });
            answer["channels"] = history.channels.into_iter().map(|channel| (channel, json!([]))).collect::<serde_json::Map<_, _>>().into();
            Some(answer.to_string())
        }
        Asked::Who(who) => {
            let text = "what wrote it is not kept";
            Some(json!({ "t": "who", "id": who.id, "name": who.name, "text": text }).to_string())
        }
    }
}
