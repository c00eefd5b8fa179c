//! What messages hold: one line of words, after that of a result its bytes.

use std::fmt;
use std::ops::Range;

use sha2::{Digest, Sha256};

/// Most bytes of the line.
const LINE_MAX: usize = 512;

/// Most letters of a word.
const WORD_MAX: usize = 80;

/// Most bytes of a result; a larger one is not fetched.
pub(crate) const RESULT_BYTES_MAX: u64 = 64 << 20;

/// A range that is to be run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Job {
    pub range: Range<u64>,
    /// Which run sent it, and the how manieth time: letters, digits and `-`.
    pub tag: String,
}

/// What came of a range.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Outcome<'a> {
    pub job: Job,
    /// The worker that ran it.
    pub worker: String,
    pub body: Body<'a>,
}

/// The bytes of a result, or where they are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Body<'a> {
    /// The result.
    Whole(&'a [u8]),
    /// The result of one scenario that was not run, because workers died of it.
    GivenUp(&'a [u8]),
    /// The result is an object: its size and its SHA-256.
    Object(u64, String),
}

/// What a run says of itself on the subject `state`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct State {
    /// The run.
    pub run: String,
    pub kind: StateKind,
}

/// How far a run is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StateKind {
    /// It has just begun.
    New,
    /// It has been at work for some beats.
    Settled,
    /// It is over: what is under way need not be finished.
    Over,
}

/// The first 16 digits of a hash: enough to tell results of one range apart.
pub(crate) fn short(hash: &str) -> &str {
    hash.get(..16).unwrap_or(hash)
}

/// The SHA-256 of bytes as hexadecimal digits.
pub(crate) fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn is_word(word: &str) -> bool {
    !word.is_empty() && word.len() <= WORD_MAX && word.bytes().all(|byte| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'.'))
}

/// A name as a word: what does not belong into one becomes `-`.
pub(crate) fn word(name: &str) -> String {
    let word: String =
        name.chars().take(WORD_MAX).map(|letter| if letter.is_ascii_alphanumeric() || letter == '.' { letter } else { '-' }).collect();
    if word.is_empty() { "-".to_owned() } else { word }
}

impl fmt::Display for Job {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {}", self.range.start, self.range.end, self.tag)
    }
}

impl Job {
    /// Reads the message of a job; `None` if it is none.
    pub(crate) fn read(payload: &[u8]) -> Option<Self> {
        let line = std::str::from_utf8(payload.get(..payload.len().min(LINE_MAX))?).ok()?;
        let mut words = line.split(' ');
        let job = Self::of(&mut words)?;
        (words.next().is_none() && job.to_string().len() == payload.len()).then_some(job)
    }

    fn of<'w>(words: &mut impl Iterator<Item = &'w str>) -> Option<Self> {
        let range = words.next()?.parse().ok()?..words.next()?.parse().ok()?;
        let tag = words.next().filter(|tag| is_word(tag))?.to_owned();
        (range.start < range.end).then_some(Self { range, tag })
    }

    /// The identity of its message: the server drops a second one with the same for two minutes.
    pub(crate) fn id(&self) -> String {
        format!("j{}-{}-{}", self.range.start, self.range.end, self.tag)
    }

    /// The identity of a result of it; results that differ have another.
    pub(crate) fn result_id(&self, hash: &str) -> String {
        format!("r{}-{}-{}-{}", self.range.start, self.range.end, self.tag, short(hash))
    }

    /// The object of a result of it that is too large for a message.
    pub(crate) fn object(&self, hash: &str) -> String {
        format!("part-{}-{}-{}-{}", self.range.start, self.range.end, self.tag, short(hash))
    }

    /// Its two halves; `None` if it is a single scenario.
    pub(crate) fn halves(&self) -> Option<[Self; 2]> {
        let Range { start, end } = self.range;
        let middle = start + (end - start) / 2;
        (middle > start).then(|| [start..middle, middle..end].map(|range| Self { range, tag: self.tag.clone() }))
    }
}

impl Outcome<'_> {
    /// The message.
    pub(crate) fn write(&self) -> Vec<u8> {
        let (job, worker) = (&self.job, &self.worker);
        let (line, bytes) = match &self.body {
            Body::Whole(bytes) => (format!("result {job} {worker} whole\n"), *bytes),
            Body::GivenUp(bytes) => (format!("result {job} {worker} given-up\n"), *bytes),
            Body::Object(size, hash) => (format!("result {job} {worker} object {size} {hash}\n"), &[][..]),
        };
        [line.as_bytes(), bytes].concat()
    }
}

impl<'a> Outcome<'a> {
    /// Reads the message of a result; `None` if it is none.
    pub(crate) fn read(payload: &'a [u8]) -> Option<Self> {
        let end = payload.iter().take(LINE_MAX).position(|&byte| byte == b'\n')?;
        let (line, bytes) = (std::str::from_utf8(&payload[..end]).ok()?, &payload[end + 1..]);
        let mut words = line.split(' ');
        (words.next()? == "result").then_some(())?;
        let job = Job::of(&mut words)?;
        let worker = words.next().filter(|worker| is_word(worker))?.to_owned();
        let body = match words.next()? {
            "whole" => Body::Whole(bytes),
            "given-up" if job.range.end - job.range.start == 1 => Body::GivenUp(bytes),
            "object" if bytes.is_empty() => {
                let size = words.next()?.parse().ok()?;
                let hash = words.next().filter(|hash| hash.len() == 64 && is_word(hash))?;
                Body::Object(size, hash.to_owned())
            }
            _ => return None,
        };
        words.next().is_none().then_some(Self { job, worker, body })
    }
}

impl fmt::Display for State {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = match self.kind {
            StateKind::New => "new",
            StateKind::Settled => "settled",
            StateKind::Over => "over",
        };
        write!(f, "{kind} {}", self.run)
    }
}

impl State {
    /// Reads the message of a state; `None` if it is none.
    pub(crate) fn read(payload: &[u8]) -> Option<Self> {
        let (kind, run) = std::str::from_utf8(payload).ok()?.split_once(' ')?;
        let kind = match kind {
            "new" => StateKind::New,
            "settled" => StateKind::Settled,
            "over" => StateKind::Over,
            _ => return None,
        };
        is_word(run).then(|| Self { run: run.to_owned(), kind })
    }
}

/// What a worker says of itself: its name and its threads.
pub(crate) fn alive(worker: &str, threads: usize) -> String {
    format!("{worker} {threads}")
}

/// Reads what a worker says of itself; `None` if it is nothing of the kind.
pub(crate) fn read_alive(payload: &[u8]) -> Option<(&str, u64)> {
    let (worker, threads) = std::str::from_utf8(payload).ok()?.split_once(' ')?;
    Some((Some(worker).filter(|worker| is_word(worker))?, threads.parse().ok()?))
}

/// The description of the object with what a campaign brings along.
pub(crate) fn description(meaning: u32, hash: &str) -> String {
    format!("meaning {meaning} sha256 {hash}")
}

/// Reads such a description: the meaning version and the SHA-256.
pub(crate) fn read_description(text: &str) -> Option<(u32, &str)> {
    let (meaning, hash) = text.strip_prefix("meaning ")?.split_once(" sha256 ")?;
    Some((meaning.parse().ok()?, Some(hash).filter(|hash| hash.len() == 64 && is_word(hash))?))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn job() -> Job {
        Job { range: 100..200, tag: "k3-1".to_owned() }
    }

    #[test]
    fn a_message_is_read_as_it_was_written() {
        assert_eq!(Job::read(job().to_string().as_bytes()), Some(job()));
        let single = Job { range: u64::MAX - 1..u64::MAX, tag: "t".to_owned() };
        for (job, body) in [
            (job(), Body::Whole(b"a\nb\0c")),
            (job(), Body::Whole(b"")),
            (single, Body::GivenUp(b"bytes")),
            (job(), Body::Object(1 << 40, hash(b"x"))),
        ] {
            let outcome = Outcome { job, worker: word("Rechner 7.local"), body };
            assert_eq!(Outcome::read(&outcome.write()), Some(outcome.clone()));
        }
        for kind in [StateKind::New, StateKind::Settled, StateKind::Over] {
            let state = State { run: "r-1".to_owned(), kind };
            assert_eq!(State::read(state.to_string().as_bytes()), Some(state));
        }
        assert_eq!(read_alive(alive("w-1", 16).as_bytes()), Some(("w-1", 16)));
        assert_eq!(read_description(&description(3, &hash(b""))), Some((3, hash(b"").as_str())));
    }

    #[test]
    fn what_is_no_message_is_not_read() {
        for payload in
            ["", "1 2", "2 1 t", "1 1 t", "1 2 t ", "1 2 t u", "01 2 t", "1 2 t\n", "-1 2 t", "1 18446744073709551616 t", "1 2 a/b"]
        {
            assert_eq!(Job::read(payload.as_bytes()), None, "{payload:?}");
        }
        for payload in
            ["result", "result 1 2 t w whole", "result 1 2 t w given\n", "result 1 3 t w given-up\n", "result 1 2 t w object 4 ff\n"]
        {
            assert_eq!(Outcome::read(payload.as_bytes()), None, "{payload:?}");
        }
    }

    #[test]
    fn the_halves_of_a_range_are_the_range() {
        let [first, second] = job().halves().expect("two");
        assert_eq!((first.range, second.range), (100..150, 150..200));
        assert_eq!(Job { range: 5..6, tag: "t".to_owned() }.halves(), None);
        assert_eq!(Job { range: 5..8, tag: "t".to_owned() }.halves().map(|halves| halves.map(|half| half.range)), Some([5..6, 6..8]));
    }
}
