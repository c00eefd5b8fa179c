//! What a page says over its WebSocket: one JSON text each, read with limits.

use serde_json::{Map, Value as Json};
use sieben_lang::reason::Language;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_workspace::Refusal;

use super::program::Speech;
use crate::reference::View;

/// Longest message of a page, in bytes.
pub const FRAME_BYTES_MAX: usize = 64 * 1024;
/// Rows that one subscription has at most: more than any screen shows.
pub const ROWS_MAX: u32 = 400;
/// Names that all subscriptions of a page have together at most.
pub const NAMES_MAX: usize = 2_000;
/// Networks of one subscription to what diagrams carry.
pub const NETWORKS_MAX: usize = 100;
/// Channels of one question for the past.
pub const CHANNELS_MAX: usize = 64;
/// Longest `id` of a subscription, in bytes.
const ID_BYTES_MAX: usize = 64;
/// Longest name of a value, in bytes.
const NAME_BYTES_MAX: usize = 200;

/// What a page says.
#[derive(Clone, Debug, PartialEq)]
pub enum Said {
    /// Who it is: how its sentences are written.
    Hello(Speech),
    /// It wants to be sent something from now on.
    Subscribe(String, What),
    /// It no longer wants that.
    Unsubscribe(String),
    /// It wants to see another scan.
    At(At),
    /// It asks for values of the past.
    History(History),
    /// It asks who wrote a value.
    Who(Who),
    /// It has taken a message in.
    Acknowledge(u64),
    /// So many messages a second are enough.
    Rate(u32),
}

/// What a page can be sent.
#[derive(Clone, Debug, PartialEq)]
pub enum What {
    /// Statements of a block.
    Rows(Rows),
    /// Values by name.
    Tags(Vec<String>),
    /// What the lines of diagrams carry.
    Flow(Flow),
    /// Something that is the same for all pages.
    Common(Common),
}

/// Statements of a block, counted from 0, both included.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    /// The block as the page calls it.
    pub block: String,
    /// The instance data block of the calls that are meant; `None`: all calls.
    pub instance: Option<String>,
    /// The first statement.
    pub from: u32,
    /// The last statement.
    pub to: u32,
    /// The statement whose reason is wanted.
    pub reason: Option<u32>,
}

/// Networks of a block as diagrams.
#[derive(Clone, Debug, PartialEq)]
pub struct Flow {
    /// The block as the page calls it.
    pub block: String,
    /// The instance data block of the calls that are meant; `None`: all calls.
    pub instance: Option<String>,
    /// As what they are drawn.
    pub view: View,
    /// The networks, from 1.
    pub networks: Vec<u32>,
}

/// What is the same for all pages.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Common {
    /// The simulated plants.
    Plant,
    /// The lamps of the CPU.
    Leds,
    /// What changed.
    Changes,
    /// Who is connected.
    Clients,
    /// The diagnostic buffer.
    Diagnostics,
    /// How long the cycle takes.
    Cycle,
    /// What is forced.
    Forces,
}

impl Common {
    /// All of them with the word of `what`.
    pub const ALL: [(&'static str, Self); 7] = [
        ("plant", Self::Plant),
        ("leds", Self::Leds),
        ("changes", Self::Changes),
        ("clients", Self::Clients),
        ("diag", Self::Diagnostics),
        ("cycle", Self::Cycle),
        ("forces", Self::Forces),
    ];
}

/// Which scan a page wants to see.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum At {
    /// Always the newest.
    Live,
    /// This one.
    Scan(u64),
    /// So much on, or back.
    Step(Unit, i64),
}

/// What a page steps by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// One statement.
    Statement,
    /// All statements of a network.
    Network,
    /// A scan.
    Scan,
}

impl Unit {
    /// All of them with their words.
    pub const ALL: [(&'static str, Self); 3] = [("statement", Self::Statement), ("network", Self::Network), ("scan", Self::Scan)];
}

/// A question for values of the past.
#[derive(Clone, Debug, PartialEq)]
pub struct History {
    /// Comes back with the answer.
    pub id: String,
    /// The first scan.
    pub from: u64,
    /// The last scan.
    pub to: u64,
    /// Names.
    pub channels: Vec<String>,
    /// How many points of a channel are enough.
    pub points: usize,
}

/// The question who wrote a value.
#[derive(Clone, Debug, PartialEq)]
pub struct Who {
    /// Comes back with the answer.
    pub id: String,
    /// The name of the value.
    pub name: String,
    /// Up to this scan.
    pub scan: u64,
}

/// `en` and `de`, the mnemonics of people who speak that.
pub(crate) fn mnemonics(word: &str) -> Option<Mnemonics> {
    match word {
        "en" => Some(Mnemonics::English),
        "de" => Some(Mnemonics::German),
        _ => None,
    }
}

fn not_understood(message: impl Into<String>) -> Refusal {
    Refusal::new(Problem::P7131, message)
}

pub(crate) fn too_much(message: impl Into<String>) -> Refusal {
    Refusal::new(Problem::P7130, message)
}

/// Reads a message.
///
/// # Errors
/// It is not understood, or asks for more than one page gets.
pub fn parse(frame: &[u8]) -> Result<Said, Refusal> {
    if frame.len() > FRAME_BYTES_MAX {
        return Err(too_much(format!("a message of {} bytes is too long; it may have {FRAME_BYTES_MAX}", frame.len())));
    }
    match serde_json::from_slice::<Json>(frame) {
        Ok(Json::Object(object)) => Fields(&object).said(),
        Ok(_) => Err(not_understood("a message is a JSON object; write `{\"t\": \"hello\", \"v\": 1}`")),
        Err(error) => Err(not_understood(format!("the message is no JSON: {error}"))),
    }
}

/// The fields of a message.
struct Fields<'m>(&'m Map<String, Json>);

impl<'m> Fields<'m> {
    fn said(&self) -> Result<Said, Refusal> {
        match self.text("t").unwrap_or_default() {
            "hello" => match self.number("v") {
                Some(1) => Ok(Said::Hello(Speech {
                    language: self.text("lang").and_then(Language::from_code).unwrap_or_default(),
                    mnemonics: self.text("mnemonics").and_then(mnemonics),
                })),
                _ => Err(not_understood("`hello` has `\"v\": 1`, the version of the protocol; reload the page if it is older")),
            },
            "sub" => Ok(Said::Subscribe(self.id()?, self.what()?)),
            "unsub" => Ok(Said::Unsubscribe(self.id()?)),
            "at" => self.at().map(Said::At),
            "history" => Ok(Said::History(History {
                id: self.id()?,
                from: self.needed("from")?,
                to: self.needed("to")?,
                channels: self.names("channels", CHANNELS_MAX)?,
                points: usize::try_from(self.number("points").unwrap_or(0)).unwrap_or(usize::MAX),
            })),
            "who" => Ok(Said::Who(Who { id: self.id()?, name: self.name("name")?, scan: self.needed("scan")? })),
            "ack" => self.needed("seq").map(Said::Acknowledge),
            "rate" => Ok(Said::Rate(u32::try_from(self.needed("hz")?).unwrap_or(u32::MAX))),
            _ => Err(not_understood("`t` is one of `hello`, `sub`, `unsub`, `at`, `history`, `who`, `ack` and `rate`")),
        }
    }

    fn text(&self, key: &str) -> Option<&'m str> {
        self.0.get(key).and_then(Json::as_str)
    }

    fn number(&self, key: &str) -> Option<u64> {
        self.0.get(key).and_then(Json::as_u64)
    }

    fn needed(&self, key: &str) -> Result<u64, Refusal> {
        self.number(key).ok_or_else(|| not_understood(format!("`{key}` is a whole number from 0")))
    }

    fn statement(&self, key: &str) -> Result<u32, Refusal> {
        Ok(u32::try_from(self.needed(key)?).unwrap_or(u32::MAX))
    }

    fn id(&self) -> Result<String, Refusal> {
        let fits = |id: &&str| (1..=ID_BYTES_MAX).contains(&id.len());
        let id = self.text("id").filter(fits);
        id.map(str::to_owned).ok_or_else(|| not_understood(format!("`id` is text of 1 to {ID_BYTES_MAX} bytes")))
    }

    fn name(&self, key: &str) -> Result<String, Refusal> {
        let name = self.text(key).filter(|name| name.len() <= NAME_BYTES_MAX);
        name.map(str::to_owned).ok_or_else(|| not_understood(format!("`{key}` is text of at most {NAME_BYTES_MAX} bytes")))
    }

    fn names(&self, key: &str, most: usize) -> Result<Vec<String>, Refusal> {
        let wrong = || not_understood(format!("`{key}` is a list of names, each of at most {NAME_BYTES_MAX} bytes"));
        let names = self.0.get(key).and_then(Json::as_array).ok_or_else(wrong)?;
        if names.len() > most {
            return Err(too_much(format!("{} names are too many; `{key}` takes {most}", names.len())));
        }
        let name = |name: &Json| name.as_str().filter(|name| name.len() <= NAME_BYTES_MAX).map(str::to_owned).ok_or_else(wrong);
        names.iter().map(name).collect()
    }

    fn what(&self) -> Result<What, Refusal> {
        let word = self.text("what").unwrap_or_default();
        match word {
            "rows" => {
                let (from, to) = (self.statement("from")?, self.statement("to")?);
                if to.saturating_sub(from) >= ROWS_MAX {
                    return Err(too_much(format!("`rows` has at most {ROWS_MAX} statements")));
                }
                let reason = self.number("reason").and_then(|reason| u32::try_from(reason).ok());
                Ok(What::Rows(Rows { block: self.name("block")?, instance: self.instance()?, from, to, reason }))
            }
            "tags" => self.names("names", NAMES_MAX).map(What::Tags),
            "flow" => self.flow().map(What::Flow),
            _ => {
                let common = Common::ALL.iter().find(|(name, _)| *name == word).map(|&(_, common)| What::Common(common));
                let known = || Common::ALL.map(|(name, _)| format!("`{name}`")).join(", ");
                common.ok_or_else(|| not_understood(format!("`what` is one of `rows`, `tags`, `flow`, {}", known())))
            }
        }
    }

    fn flow(&self) -> Result<Flow, Refusal> {
        let word = self.text("view").unwrap_or_default();
        let view = View::ALL.iter().find(|(known, _)| *known == word).map(|&(_, view)| view).filter(|&view| view != View::Stl);
        let numbers = self.0.get("networks").and_then(Json::as_array);
        let (Some(view), Some(numbers)) = (view, numbers) else {
            return Err(not_understood("`flow` has `view`, which is `lad` or `fbd`, and `networks`, a list of numbers"));
        };
        if numbers.len() > NETWORKS_MAX {
            return Err(too_much(format!("`flow` has at most {NETWORKS_MAX} networks")));
        }
        let networks = numbers.iter().filter_map(|number| u32::try_from(number.as_u64()?).ok()).collect();
        Ok(Flow { block: self.name("block")?, instance: self.instance()?, view, networks })
    }

    fn instance(&self) -> Result<Option<String>, Refusal> {
        if self.0.contains_key("instance") { self.name("instance").map(Some) } else { Ok(None) }
    }

    fn at(&self) -> Result<At, Refusal> {
        match (self.0.get("scan"), self.text("step")) {
            (Some(Json::String(word)), _) if word == "live" => Ok(At::Live),
            (Some(Json::Number(scan)), _) if scan.is_u64() => Ok(At::Scan(scan.as_u64().unwrap_or_default())),
            (None, Some(word)) => {
                let unit = Unit::ALL.iter().find(|(known, _)| *known == word).map(|&(_, unit)| unit);
                let unit = unit.ok_or_else(|| not_understood("`step` is `statement`, `network` or `scan`"))?;
                let count = self.0.get("n").and_then(Json::as_i64).ok_or_else(|| not_understood("`n` is a whole number"))?;
                Ok(At::Step(unit, count))
            }
            _ => Err(not_understood(
                "`at` has a scan, `\"scan\": 421` or `\"scan\": \"live\"`, or a step, `\"step\": \"statement\", \"n\": -1`; scans count from 0",
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(text: &str) -> Result<Said, String> {
        parse(text.as_bytes()).map_err(|refusal| format!("{}: {}", refusal.problem.code(), refusal.message))
    }

    #[test]
    fn every_message_is_read() {
        let rows = Rows { block: "OB1".to_owned(), instance: None, from: 0, to: 29, reason: Some(3) };
        let german = Speech { language: Language::German, mnemonics: Some(Mnemonics::English) };
        let instance = Rows { instance: Some("DB 7".to_owned()), reason: None, ..rows.clone() };
        for (text, wanted) in [
            (r#"{"t":"hello","v":1,"lang":"de","mnemonics":"en"}"#, Said::Hello(german)),
            (r#"{"t":"hello","v":1}"#, Said::Hello(Speech::default())),
            (
                r#"{"t":"sub","id":"a","what":"rows","block":"OB1","instance":"DB 7","from":0,"to":29}"#,
                Said::Subscribe("a".into(), What::Rows(instance)),
            ),
            (
                r#"{"t":"sub","id":"a","what":"rows","block":"OB1","from":0,"to":29,"reason":3}"#,
                Said::Subscribe("a".into(), What::Rows(rows)),
            ),
            (r#"{"t":"sub","id":"b","what":"tags","names":["MW 10"]}"#, Said::Subscribe("b".into(), What::Tags(vec!["MW 10".into()]))),
            (
                r#"{"t":"sub","id":"f","what":"flow","block":"FB20","view":"lad","networks":[1,2]}"#,
                Said::Subscribe(
                    "f".into(),
                    What::Flow(Flow { block: "FB20".into(), instance: None, view: View::Lad, networks: vec![1, 2] }),
                ),
            ),
            (r#"{"t":"sub","id":"c","what":"leds"}"#, Said::Subscribe("c".into(), What::Common(Common::Leds))),
            (r#"{"t":"unsub","id":"c"}"#, Said::Unsubscribe("c".into())),
            (r#"{"t":"at","scan":421}"#, Said::At(At::Scan(421))),
            (r#"{"t":"at","scan":"live"}"#, Said::At(At::Live)),
            (r#"{"t":"at","step":"scan","n":-2}"#, Said::At(At::Step(Unit::Scan, -2))),
            (r#"{"t":"at","step":"statement","n":1}"#, Said::At(At::Step(Unit::Statement, 1))),
            (r#"{"t":"at","step":"network","n":-1}"#, Said::At(At::Step(Unit::Network, -1))),
            (
                r#"{"t":"history","id":"h","from":1,"to":9,"channels":["Q 0.0"],"points":500}"#,
                Said::History(History { id: "h".into(), from: 1, to: 9, channels: vec!["Q 0.0".into()], points: 500 }),
            ),
            (r#"{"t":"who","id":"w","name":"Q 0.0","scan":7}"#, Said::Who(Who { id: "w".into(), name: "Q 0.0".into(), scan: 7 })),
            (r#"{"t":"ack","seq":12}"#, Said::Acknowledge(12)),
            (r#"{"t":"rate","hz":2}"#, Said::Rate(2)),
        ] {
            assert_eq!(said(text), Ok(wanted), "{text}");
        }
        for (word, common) in Common::ALL {
            assert_eq!(said(&format!(r#"{{"t":"sub","id":"x","what":"{word}"}}"#)), Ok(Said::Subscribe("x".into(), What::Common(common))));
        }
    }

    #[test]
    fn what_is_wrong_is_said() {
        let many = format!(r#"{{"t":"sub","id":"x","what":"tags","names":[{}]}}"#, vec![r#""M""#; NAMES_MAX + 1].join(","));
        let deep = format!(r#"{{"t":{}"#, "[".repeat(60_000));
        let long = " ".repeat(FRAME_BYTES_MAX + 1);
        for (text, part) in [
            ("", "P7131: the message is no JSON"),
            ("[]", "P7131: a message is a JSON object"),
            ("{}", "P7131: `t` is one of"),
            (r#"{"t":"fly"}"#, "P7131: `t` is one of"),
            (r#"{"t":"hello","v":2}"#, "P7131: `hello` has `\"v\": 1`"),
            (r#"{"t":"sub","what":"leds"}"#, "P7131: `id` is text"),
            (r#"{"t":"sub","id":"","what":"leds"}"#, "P7131: `id` is text"),
            (r#"{"t":"sub","id":"x","what":"everything"}"#, "P7131: `what` is one of `rows`, `tags`, `flow`, `plant`"),
            (r#"{"t":"sub","id":"x","what":"tags","names":[1]}"#, "P7131: `names` is a list"),
            (r#"{"t":"sub","id":"x","what":"rows","block":"OB1","from":0,"to":400}"#, "P7130: `rows` has at most 400"),
            (r#"{"t":"sub","id":"x","what":"rows","block":"OB1","from":-1,"to":4}"#, "P7131: `from` is a whole number"),
            (r#"{"t":"at","scan":-1}"#, "P7131: `at` has a scan"),
            (r#"{"t":"at","scan":null}"#, "P7131: `at` has a scan"),
            (r#"{"t":"at","scan":1.5}"#, "P7131: `at` has a scan"),
            (r#"{"t":"at","step":"block","n":1}"#, "P7131: `step` is `statement`"),
            (r#"{"t":"at","step":"scan","n":0.5}"#, "P7131: `n` is a whole number"),
            (r#"{"t":"history","id":"h","from":-5,"to":9,"channels":[]}"#, "P7131: `from` is a whole number from 0"),
            (r#"{"t":"history","id":"h","from":1,"to":null,"channels":[]}"#, "P7131: `to` is a whole number from 0"),
            (r#"{"t":"history","id":"h","from":1,"to":NaN,"channels":[]}"#, "P7131: the message is no JSON"),
            (r#"{"t":"sub","id":"x","what":"rows","block":"OB1","instance":5,"from":0,"to":4}"#, "P7131: `instance` is text"),
            (r#"{"t":"ack"}"#, "P7131: `seq` is a whole number"),
            (&many, "P7130: 2001 names are too many"),
            (&deep, "P7131: the message is no JSON: recursion limit"),
            (&long, "P7130: a message of 65537 bytes"),
        ] {
            assert!(said(text).is_err_and(|message| message.starts_with(part)), "{text:.80}: {:?}", said(text));
        }
        assert!(parse(b"\xFF{\"t\":\"leds\"}").is_err());
    }
}
