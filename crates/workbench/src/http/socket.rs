//! The WebSocket of a page: frames in, scans out.

use std::net::SocketAddr;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use axum::body::Body;
use axum::extract::ws::{Message, WebSocket, WebSocketUpgrade};
use axum::http::Response;
use serde_json::json;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_workspace::past::Viewer;
use sieben_workspace::{Closed, Refusal};
use tokio::sync::watch;
use tokio::time::timeout;

use super::api::peer_text;
use super::blocking;
use crate::access::Role;
use crate::hub::{Hub, PAGES_MAX, Visitor};
use crate::live::client::{Asked, Client, GONE_US, Live, bye, event};
use crate::live::message::{At, FRAME_BYTES_MAX};
use crate::live::shot::Shot;
use crate::lock;
use crate::moment::{self, Moment};
use crate::past;
use crate::server::Shared;
use crate::stepping::step;

/// Longest frame that is read at all: one that is too long is still answered with why.
const READ_BYTES_MAX: usize = 32 * FRAME_BYTES_MAX;
/// How long a page may take for a message that does not fit into its socket.
const SEND_WAIT_MAX: Duration = Duration::from_secs(15);
/// How long a page may wait with its first message.
const HELLO_WAIT_MAX: Duration = Duration::from_secs(10);
/// How long what a page still sends is taken in after the farewell.
const UNREAD_WAIT_MAX: Duration = Duration::from_secs(5);
/// How often a page is asked whether it is still there, in microseconds: one that wants no messages says nothing by itself.
const PING_US: u64 = 10_000_000;
/// Longest wait before it is looked whether a page is still there.
const LOOK_AGAIN: Duration = Duration::from_secs(1);

/// Answers the request for a WebSocket.
pub(super) fn upgrade(upgrade: WebSocketUpgrade, shared: Arc<Shared>, peer: SocketAddr, role: Role) -> Response<Body> {
    let upgrade = upgrade.max_message_size(READ_BYTES_MAX).max_frame_size(READ_BYTES_MAX);
    upgrade.on_upgrade(move |mut socket| async move {
        let visitor = Visitor { peer: peer_text(peer), role };
        let end = match shared.hub.enter(visitor.clone()) {
            Some(page) => {
                let end = serve(&mut socket, &shared, page, &visitor).await;
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
        // What the page has sent meanwhile is taken in: a connection that ends with something unread loses what was said last.
        let _ = timeout(UNREAD_WAIT_MAX, async { while let Some(Ok(_)) = socket.recv().await {} }).await;
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
async fn serve(socket: &mut WebSocket, shared: &Arc<Shared>, page: u64, visitor: &Visitor) -> Result<(), Refusal> {
    let hub = &shared.hub;
    let mut client = Client::default();
    let mut views = Views { at: None, moved: false, replayer: Arc::default() };
    let mut past: Option<Arc<Shot>> = None;
    let mut looks = hub.looks();
    looks.mark_unchanged();
    let first = match timeout(HELLO_WAIT_MAX, receive(socket)).await {
        Ok(Ok(Some(frame))) => frame,
        Ok(Ok(None)) => b"{\"t\":\"hello\",\"v\":1}".to_vec(),
        Ok(Err(None)) => return Ok(()),
        Ok(Err(Some(refusal))) => return Err(refusal),
        Err(_) => return Err(Refusal::new(Problem::P7131, format!("a page says `hello` within {} seconds", HELLO_WAIT_MAX.as_secs()))),
    };
    client.hear(&first, hub.gate.now_us())?;
    let asked = Arc::clone(shared);
    let role = visitor.role;
    let (mut run, text) = blocking(move || welcome(&asked, role)).await?;
    if send(socket, text).await.is_err() {
        return Ok(());
    }
    let [mut heard_us, mut pinged_us, mut looked_us] = [hub.gate.now_us(); 3];
    loop {
        let now_us = hub.gate.now_us();
        if client.is_gone(now_us) {
            return Err(Refusal::new(Problem::P7130, format!("no message was acknowledged for {} seconds", GONE_US / 1_000_000)));
        }
        if now_us.saturating_sub(std::mem::replace(&mut looked_us, now_us)) > PING_US / 2 {
            // While a long question was answered nothing was read.
            heard_us = now_us;
        }
        if now_us.saturating_sub(heard_us.max(pinged_us)) >= PING_US {
            // Its answer to the last one is late: the computer at the other end is off, or the way to it.
            if pinged_us > heard_us {
                return Ok(());
            }
            pinged_us = now_us;
            if timeout(SEND_WAIT_MAX, socket.send(Message::Ping(Vec::new().into()))).await.is_err() {
                return Ok(());
            }
        }
        let due = client.due_us(now_us).map(|due| Duration::from_micros(due.saturating_sub(now_us)));
        let has_news = matches!(due, Some(due) if due.is_zero());
        tokio::select! {
            biased;
            came = receive(socket) => {
                heard_us = hub.gate.now_us();
                match came {
                Ok(None) => {}
                Ok(Some(frame)) => {
                    let asked = client.hear(&frame, hub.gate.now_us())?;
                    if client.take_changed() {
                        hub.wanted.set(page, Some(client.wanted(&hub.program())));
                    }
                    let begun_us = hub.gate.now_us();
                    let said = match asked {
                        Some(asked) => answer(shared, &mut views, (&mut client, visitor), asked).await,
                        None => None,
                    };
                    client.was_not_read(hub.gate.now_us().saturating_sub(begun_us));
                    if let Some(text) = said
                        && send(socket, text).await.is_err()
                    {
                        return Ok(());
                    }
                }
                Err(None) => return Ok(()),
                Err(Some(refusal)) => return Err(refusal),
                }
            },
            changed = looks.changed(), if has_news => {
                if changed.is_err() {
                    return Err(over());
                }
                let newest = newest(&mut looks)?;
                if newest.program.facts.run != run {
                    let asked = Arc::clone(shared);
                    let text;
                    (run, text) = blocking(move || welcome(&asked, role)).await?;
                    views = Views { at: None, moved: false, replayer: Arc::default() };
                    past = None;
                    let moved = client.moves(&newest.program, &shared.projects.listed().name);
                    hub.wanted.set(page, Some(client.wanted(&newest.program)));
                    if send(socket, moved).await.is_err() || send(socket, text).await.is_err() {
                        return Ok(());
                    }
                    continue;
                }
                let is_known = client.knows();
                let (shot, live, refusal) = match (&past, is_known) {
                    // A scan of the past does not change; only how the run goes does.
                    (Some(past), true) if views.at.is_some() && !views.moved => (Arc::new(past.with_head_of(&newest)), Live::No, None),
                    _ => shown(shared, &mut views, &client, newest).await,
                };
                past = (live == Live::No).then(|| Arc::clone(&shot));
                if let Some(refusal) = refusal {
                    client.forget();
                    if send(socket, event(&refusal)).await.is_err() {
                        return Ok(());
                    }
                }
                if tell(socket, &mut client, (&shot, live), hub).await?.is_err() {
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
    Closed.into()
}

/// The newest look.
fn newest(looks: &mut watch::Receiver<Option<Arc<Shot>>>) -> Result<Arc<Shot>, Refusal> {
    looks.borrow_and_update().clone().ok_or_else(over)
}

/// Sends what is new of a scan.
async fn tell(socket: &mut WebSocket, client: &mut Client, (shot, live): (&Shot, Live), hub: &Hub) -> Result<Result<(), Gone>, Refusal> {
    if let Some(text) = client.meets(shot)
        && send(socket, text).await.is_err()
    {
        return Ok(Err(Gone));
    }
    Ok(match client.update(shot, live, hub.gate.now_us())? {
        Some(text) => send(socket, text).await,
        None => Ok(()),
    })
}

/// What a page is sent first, and which CPU of the run that is about.
fn welcome(shared: &Shared, role: Role) -> (u64, String) {
    let hub = &shared.hub;
    let program = hub.program();
    let head = hub.gate.look(|plant| (plant.cpu.cpu_type().name, plant.scans, plant.pace.cycle_us));
    let (cpu, scans, cycle_us) = head.unwrap_or_default();
    let oldest = hub.desk.past().range().map_or(scans, |(first, _)| first.scan.min(scans));
    let project = shared.projects.listed();
    let text = json!({
        "t": "welcome", "v": 1, "cpu": cpu, "project": project.name, "program": program.hash(), "role": role.word(),
        "oldest": oldest, "newest": scans, "cycle_us": cycle_us, "offers": ["flow", "step"], "examples": project.names(),
        "mnemonics": if program.mnemonics() == Mnemonics::German { "de" } else { "en" },
    });
    (program.facts.run, text.to_string())
}

/// What a page sees of the past; it has a CPU of its own for that.
struct Views {
    /// What is shown; `None`: the newest scan.
    at: Option<Moment>,
    /// It has not been shown yet.
    moved: bool,
    replayer: Arc<Mutex<Viewer>>,
}

/// Answers what is no subscription: texts to send, or a scan to show.
async fn answer(shared: &Arc<Shared>, views: &mut Views, (client, visitor): (&mut Client, &Visitor), asked: Asked) -> Option<String> {
    let (shown, newest) = shared.hub.looks().borrow().as_ref().map_or((0, 0), |shot| (shot.head.scan, shot.head.newest));
    let (hub, replayer, language) = (Arc::clone(&shared.hub), Arc::clone(&views.replayer), client.speech().language);
    match asked {
        Asked::At(at) => {
            let end_of = |scan| Moment { scan, statements: None };
            let moved = match at {
                At::Live => Ok(None),
                At::Scan(scan) => Ok(Some(end_of(scan)).filter(|_| scan < newest)),
                At::Step(unit, steps) => {
                    let wanted = client.wanted(&hub.program());
                    let (from, runs) = (views.at, (visitor.role == Role::Program).then(|| visitor.peer.clone()));
                    blocking(move || step(&hub, &mut lock(&replayer), (from, shown, runs), (&wanted, unit, steps))).await.and_then(|to| to)
                }
            };
            let to = match moved {
                Ok(to) => to,
                Err(refusal) => return Some(event(&refusal)),
            };
            let before = std::mem::replace(&mut views.at, to);
            views.moved = true;
            if before.is_some() || views.at.is_some() {
                client.forget();
            }
            None
        }
        Asked::History(history) => {
            let asked = history.clone();
            let _one = shared.questions.acquire().await;
            let answered = blocking(move || past::history(&hub, &mut lock(&replayer), &asked)).await;
            Some(answered.and_then(|answer| answer).map_or_else(|refusal| event(&refusal), |answer| answer.to_string()))
        }
        Asked::Who(who) => {
            let _one = shared.questions.acquire().await;
            let answered = blocking(move || past::who(&hub, &mut lock(&replayer), &who, language)).await;
            Some(answered.and_then(|answer| answer).map_or_else(|refusal| event(&refusal), |answer| answer.to_string()))
        }
    }
}

/// What a page is shown: the newest look, or the scan of the past that it has chosen.
async fn shown(shared: &Arc<Shared>, views: &mut Views, client: &Client, newest: Arc<Shot>) -> (Arc<Shot>, Live, Option<Refusal>) {
    views.moved = false;
    let Some(moment) = views.at else { return (newest, Live::Yes, None) };
    let wanted = client.wanted(&newest.program);
    let (hub, replayer) = (Arc::clone(&shared.hub), Arc::clone(&views.replayer));
    let shot = blocking(move || moment::shot(&hub, &mut lock(&replayer), moment, &wanted)).await.and_then(|shot| shot);
    match shot {
        Ok(shot) => (Arc::new(shot), Live::No, None),
        Err(refusal) => {
            views.at = None;
            (newest, Live::Yes, Some(refusal))
        }
    }
}
