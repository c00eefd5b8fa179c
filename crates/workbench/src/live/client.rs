//! One page: what it has subscribed to, what it knows already, and when it is sent what.
//!
//! There is no queue: what a message holds is made when it goes out, from the newest scan and from what the page knows. A page that is slow
//! gets fewer messages, and each of them is as new as can be.

use std::collections::{BTreeMap, VecDeque};

use serde_json::{Map, Value as Json, json};
use sieben_cpu::OperatingMode;
use sieben_workspace::Refusal;

use super::content::Content;
use super::message::{At, History, NAMES_MAX, Said, What, Who, parse, too_much};
use super::program::Speech;
use super::shot::{Position, Shot, mode_word};
use super::wanted::Wanted;

/// Subscriptions that a page has at most.
pub const SUBSCRIPTIONS_MAX: usize = 64;
/// Messages that a page sends in a second at most, beside acknowledgements of what it was sent.
pub const MESSAGES_PER_SECOND_MAX: usize = 50;
/// Messages that a page is sent in a second at most.
pub const UPDATES_PER_SECOND_MAX: u32 = 20;
/// Longest message that a page is sent, in bytes.
pub const MESSAGE_BYTES_MAX: usize = 1024 * 1024;
/// A page that has not acknowledged a message for so long gets one a second, in microseconds.
const SLOW_US: u64 = 2_000_000;
/// One that has not for so long is gone.
pub const GONE_US: u64 = 15_000_000;
/// Time between two messages of a page that is slow, and the longest silence of one that is not: it takes silence for a dead connection.
const SIGN_US: u64 = 1_000_000;
const SECOND_US: u64 = 1_000_000;

/// What a page asks for that is not among its subscriptions.
#[derive(Clone, Debug, PartialEq)]
pub enum Asked {
    /// Another scan.
    At(At),
    /// Values of the past.
    History(History),
    /// Who wrote a value.
    Who(Who),
}

/// A subscription with what the page knows of it.
struct Subscription {
    what: What,
    known: Option<Content>,
}

/// One page.
pub struct Client {
    speech: Speech,
    subscriptions: BTreeMap<String, Subscription>,
    /// When its messages of the last second came.
    heard: VecDeque<u64>,
    /// Messages that it has not acknowledged, with the time they went out.
    open: VecDeque<(u64, u64)>,
    sequence: u64,
    /// When it was sent something last.
    sent_us: Option<u64>,
    /// Messages a second that it wants.
    rate: u32,
    /// The version of the program that it knows.
    program: Option<u64>,
    /// It has subscribed to something else since it was asked.
    has_changed: bool,
    /// The scan and time of the last message: another one is news.
    shown: Option<(u64, u64, OperatingMode, bool, Option<Position>)>,
}

impl Default for Client {
    fn default() -> Self {
        Self {
            speech: Speech::default(),
            subscriptions: BTreeMap::new(),
            heard: VecDeque::new(),
            open: VecDeque::new(),
            sequence: 0,
            sent_us: None,
            rate: UPDATES_PER_SECOND_MAX,
            program: None,
            has_changed: false,
            shown: None,
        }
    }
}

impl Client {
    /// Takes a message of the page in; what it asks for beside its subscriptions.
    ///
    /// # Errors
    /// The message is not understood, or there is too much: the page is sent why, and the connection ends.
    pub fn hear(&mut self, frame: &[u8], now_us: u64) -> Result<Option<Asked>, Refusal> {
        while self.heard.front().is_some_and(|&at| at.saturating_add(SECOND_US) <= now_us) {
            self.heard.pop_front();
        }
        if self.heard.len() >= MESSAGES_PER_SECOND_MAX {
            return Err(too_much(format!("more than {MESSAGES_PER_SECOND_MAX} messages came within a second")));
        }
        self.heard.push_back(now_us);
        match parse(frame)? {
            Said::Hello(speech) => self.speak(speech),
            Said::Subscribe(id, what) => {
                self.has_changed = true;
                self.subscribe(id, what)?;
            }
            Said::Unsubscribe(id) => {
                self.has_changed = true;
                self.subscriptions.remove(&id);
            }
            Said::Acknowledge(sequence) => self.acknowledge(sequence),
            Said::Rate(hz) => self.rate = hz.min(UPDATES_PER_SECOND_MAX),
            Said::At(at) => return Ok(Some(Asked::At(at))),
            Said::History(history) => return Ok(Some(Asked::History(history))),
            Said::Who(who) => return Ok(Some(Asked::Who(who))),
        }
        Ok(None)
    }

    /// What acknowledges a message is not counted: there are no more of these than messages, and they come late and many at once where the computer is busy.
    fn acknowledge(&mut self, sequence: u64) {
        if self.open.iter().any(|&(open, _)| open == sequence) {
            self.heard.pop_back();
        }
        self.open.retain(|&(open, _)| open > sequence);
    }

    fn speak(&mut self, speech: Speech) {
        self.speech = speech;
        self.subscriptions.values_mut().for_each(|subscription| subscription.known = None);
    }

    fn subscribe(&mut self, id: String, what: What) -> Result<(), Refusal> {
        if !self.subscriptions.contains_key(&id) && self.subscriptions.len() >= SUBSCRIPTIONS_MAX {
            return Err(too_much(format!("a page has at most {SUBSCRIPTIONS_MAX} subscriptions")));
        }
        self.subscriptions.insert(id, Subscription { what, known: None });
        let names = |subscription: &Subscription| if let What::Tags(names) = &subscription.what { names.len() } else { 0 };
        match self.subscriptions.values().map(names).sum::<usize>() > NAMES_MAX {
            true => Err(too_much(format!("the subscriptions of a page have at most {NAMES_MAX} names together"))),
            false => Ok(()),
        }
    }

    /// How its sentences are written.
    pub fn speech(&self) -> Speech {
        self.speech
    }

    /// Whether it wants something else than when this was asked the last time.
    pub fn take_changed(&mut self) -> bool {
        std::mem::take(&mut self.has_changed)
    }

    /// What it wants of a scan.
    pub fn wanted(&self, program: &super::program::Known) -> Wanted {
        let mut wanted = Wanted::default();
        for subscription in self.subscriptions.values() {
            match &subscription.what {
                What::Rows(rows) => {
                    if let Some(calls) = program.calls(&rows.block, rows.instance.as_deref()) {
                        wanted.calls.insert(calls);
                        wanted.rows.insert(calls);
                        wanted.reasons.extend(rows.reason.map(|number| (calls, number)));
                    }
                }
                What::Tags(names) => wanted.names.extend(names.iter().cloned()),
                What::Flow(flow) => {
                    if let Some(calls) = program.calls(&flow.block, flow.instance.as_deref()) {
                        wanted.calls.insert(calls);
                        wanted.flows.extend(flow.networks.iter().map(|&network| (calls, flow.view, network)));
                    }
                }
                What::Common(common) => drop(wanted.common.insert(*common)),
            }
        }
        wanted
    }

    /// Whether it knows all of its subscriptions at the scan that it looks at.
    pub fn knows(&self) -> bool {
        self.subscriptions.values().all(|subscription| subscription.known.is_some())
    }

    /// All that it has subscribed to is sent whole with the next message: it looks at another scan.
    pub fn forget(&mut self) {
        self.subscriptions.values_mut().for_each(|subscription| subscription.known = None);
        self.shown = None;
    }

    /// Whether it takes nothing in any more.
    pub fn is_gone(&self, now_us: u64) -> bool {
        self.waits_us(now_us) >= GONE_US
    }

    /// For so long nothing was read of what it sent: it may have acknowledged meanwhile.
    pub fn was_not_read(&mut self, us: u64) {
        self.open.iter_mut().for_each(|(_, at)| *at = at.saturating_add(us));
    }

    /// For how long its oldest message has not been acknowledged.
    fn waits_us(&self, now_us: u64) -> u64 {
        self.open.front().map_or(0, |&(_, at)| now_us.saturating_sub(at))
    }

    /// When the next message may go out; `None` if it wants none.
    pub fn due_us(&self, now_us: u64) -> Option<u64> {
        let between = match self.rate {
            0 => return None,
            _ if self.waits_us(now_us) >= SLOW_US => SIGN_US,
            rate => SECOND_US / u64::from(rate),
        };
        Some(self.sent_us.map_or(0, |sent| sent.saturating_add(between)))
    }

    /// Another program runs than the page knows, on the same CPU: what it is sent then.
    pub fn meets(&mut self, shot: &Shot) -> Option<String> {
        let version = shot.program.version;
        let before = self.program.replace(version)?;
        (before != version).then(|| {
            self.forget();
            json!({ "t": "program", "hash": shot.program.hash(), "changed": [] }).to_string()
        })
    }

    /// Another project runs from now on: what the page is sent before it is welcomed again. It has no subscriptions any more.
    pub fn moves(&mut self, program: &super::program::Known, project: &str) -> String {
        self.subscriptions.clear();
        self.forget();
        self.program = Some(program.version);
        json!({ "t": "program", "hash": program.hash(), "changed": [], "project": project }).to_string()
    }

    /// The message for a scan; `None` if it is not yet time for one, or there is nothing to say.
    ///
    /// # Errors
    /// It would be too long.
    pub fn update(&mut self, shot: &Shot, live: Live, now_us: u64) -> Result<Option<String>, Refusal> {
        if self.due_us(now_us).is_none_or(|due| due > now_us) {
            return Ok(None);
        }
        let mut parts = Map::new();
        for (id, subscription) in &mut self.subscriptions {
            if !shot.has(&subscription.what) {
                continue;
            }
            let now = shot.content(&subscription.what, self.speech);
            let part = match &subscription.known {
                Some(known) => now.since(known),
                None => Some(now.all()),
            };
            if let Some(part) = part {
                parts.insert(id.clone(), part);
                subscription.known = Some(now);
            }
        }
        let head = &shot.head;
        let shown = (head.scan, head.newest, head.mode, head.paused, shot.position.clone());
        let silent = self.sent_us.is_none_or(|sent| now_us.saturating_sub(sent) >= SIGN_US);
        if parts.is_empty() && self.shown.as_ref() == Some(&shown) && !silent {
            return Ok(None);
        }
        self.shown = Some(shown);
        self.sequence += 1;
        let mut message = json!({
            "t": "scan", "seq": self.sequence, "n": head.scan, "t_us": head.time_us, "mode": mode_word(head.mode), "oldest": head.oldest,
            "newest": head.newest, "newest_us": head.newest_us, "live": live == Live::Yes, "paused": head.paused, "speed": head.speed,
            "same": head.same,
        });
        if let Some(why) = &head.why {
            message["why"] = json!(why);
        }
        if let Some(at) = &shot.position {
            message["pos"] = json!({ "block": at.block, "index": at.index, "line": at.line, "reason": at.reason.text(self.speech) });
        }
        message["s"] = Json::Object(parts);
        let text = message.to_string();
        if text.len() > MESSAGE_BYTES_MAX {
            return Err(too_much(format!("what the page has subscribed to is longer than {MESSAGE_BYTES_MAX} bytes")));
        }
        self.sent_us = Some(now_us);
        self.open.push_back((self.sequence, now_us));
        Ok(Some(text))
    }
}

/// Whether a page follows the newest scan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Live {
    /// It does.
    Yes,
    /// It shows one of the past.
    No,
}

/// The last message of a connection: why it ends.
pub fn bye(refusal: &Refusal) -> String {
    json!({ "t": "bye", "why": refusal.problem.code(), "text": refusal.message }).to_string()
}

/// Something that went wrong, after which the connection goes on.
pub fn event(refusal: &Refusal) -> String {
    json!({ "t": "event", "level": "error", "code": refusal.problem.code(), "text": refusal.message }).to_string()
}

#[cfg(test)]
mod tests;
