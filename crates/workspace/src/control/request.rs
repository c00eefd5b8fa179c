//! What can be asked of a run, and how a line of JSON becomes a request.

use serde_json::{Map, Value as Json};
use sieben_cpu::Restart;
use sieben_model::problems::Problem;

use crate::gate::ITEMS_MAX;
use crate::pace::Speed;
use crate::refusal::Refusal;

/// Longest line of a request, in bytes.
pub const LINE_BYTES_MAX: usize = 64 * 1024;
/// Longest `id` that is text, in bytes: it comes back with the answer.
const ID_BYTES_MAX: usize = 200;
/// Most scans that one request asks for while time stands still.
const STEPS_MAX: u64 = 1_000_000;

/// How long a bit is pressed if the request does not say it, in milliseconds.
const PRESS_MS: u64 = 400;
/// How long it is pressed at most, in milliseconds: a minute.
const PRESS_MS_MAX: u64 = 60_000;

/// Something that is asked of a run.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// How it goes.
    State,
    /// Values of items.
    Read(Vec<String>),
    /// Items with the values that they shall have.
    Write(Vec<(String, String)>),
    /// Items with the values that they are forced to.
    Force(Vec<(String, String)>),
    /// Items that are no longer forced.
    Unforce(Vec<String>),
    /// Nothing is forced any more.
    UnforceAll,
    /// Entries of the diagnostic buffer after the one with this number.
    Diagnostics {
        /// The number of the last entry that is known; 0 for none.
        after: u64,
    },
    /// The blocks that are loaded.
    Blocks {
        /// How many are left out at the beginning of the list.
        from: usize,
    },
    /// What the statements of a block found and left in one scan.
    Status {
        /// The block.
        block: String,
        /// The number of the last sample that is known; 0 for none.
        after: u64,
        /// The first statement that is wanted, from 1.
        from: u32,
        /// Whether the next sample is waited for.
        wait: Wait,
    },
    /// The plants at one moment.
    Plants,
    /// A block as it is listed.
    Listing {
        /// The block; none = where a screen begins.
        block: Option<String>,
        /// How many lines are left out at the beginning.
        from: usize,
    },
    /// The assignment table.
    Names {
        /// How many rows are left out at the beginning.
        from: usize,
    },
    /// What changed after the entry with this number.
    Changes {
        /// The number of the last entry that is known; 0 for none.
        after: u64,
    },
    /// Bits that have the other value for a while.
    Press {
        /// Their names.
        items: Vec<String>,
        /// For how many milliseconds of the CPU's time.
        ms: u64,
    },
    /// Another operating mode.
    Mode(ModeChange),
    /// Another time.
    Time(TimeChange),
    /// The plants with their faults, after this change.
    Faults(FaultChange),
}

/// Whether a sample is waited for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wait {
    /// Until there is a newer one, for two seconds at most.
    ForNewer,
    /// Not at all: the newest one is taken.
    Not,
}

/// Another operating mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeChange {
    /// STOP.
    Stop,
    /// A start from STOP.
    Run(Restart),
    /// All memory as after loading; in STOP.
    MemoryReset,
}

/// Another time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TimeChange {
    /// It stands still.
    Pause,
    /// It goes on.
    Go,
    /// So many scans, then it stands still.
    Step(u64),
    /// It goes so fast.
    Speed(Speed),
}

impl std::fmt::Display for TimeChange {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Pause => f.write_str("pause"),
            Self::Go => f.write_str("go"),
            Self::Step(scans) => write!(f, "step {scans}"),
            Self::Speed(speed) => write!(f, "speed {speed}"),
        }
    }
}

/// What happens to the faults of plants.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FaultChange {
    /// Nothing.
    None,
    /// A signal fails.
    Inject(String),
    /// The faults of a signal, or of a plant, end.
    Mend(String),
}

/// A verb with the fields that it takes.
struct Verb {
    name: &'static str,
    fields: &'static [&'static str],
    read: fn(&Fields<'_>) -> Result<Request, Refusal>,
}

/// All verbs.
#[rustfmt::skip] // A table.
const VERBS: &[Verb] = &[
    Verb { name: "state", fields: &[], read: |_| Ok(Request::State) },
    Verb { name: "read", fields: &["items"], read: |fields| Ok(Request::Read(fields.names()?)) },
    Verb { name: "write", fields: &["values"], read: |fields| Ok(Request::Write(fields.values()?)) },
    Verb { name: "force", fields: &["values"], read: |fields| Ok(Request::Force(fields.values()?)) },
    Verb { name: "unforce", fields: &["items"], read: |fields| Ok(Request::Unforce(fields.names()?)) },
    Verb { name: "unforce_all", fields: &[], read: |_| Ok(Request::UnforceAll) },
    Verb { name: "diagnostics", fields: &["after"], read: |fields| Ok(Request::Diagnostics { after: fields.number("after", 0)? }) },
    Verb { name: "blocks", fields: &["from"], read: |fields| Ok(Request::Blocks { from: fields.count("from")? }) },
    Verb { name: "status", fields: &["block", "after", "from", "wait"], read: |fields| fields.status() },
    Verb { name: "mode", fields: &["mode", "restart"], read: |fields| fields.mode() },
    Verb { name: "time", fields: &["time", "scans", "speed"], read: |fields| fields.time() },
    Verb { name: "faults", fields: &["inject", "mend"], read: |fields| fields.faults() },
    Verb { name: "plants", fields: &[], read: |_| Ok(Request::Plants) },
    Verb { name: "listing", fields: &["block", "from"], read: |fields| Ok(Request::Listing { block: fields.text("block")?.map(str::to_owned), from: fields.count("from")? }) },
    Verb { name: "names", fields: &["from"], read: |fields| Ok(Request::Names { from: fields.count("from")? }) },
    Verb { name: "changes", fields: &["after"], read: |fields| Ok(Request::Changes { after: fields.number("after", 0)? }) },
    Verb { name: "press", fields: &["items", "ms"], read: |fields| fields.press() },
];

fn not_understood(message: impl Into<String>) -> Refusal {
    Refusal::new(Problem::P7091, message)
}

/// Reads one line: the `id` that comes back with the answer, and the request.
pub fn parse(line: &[u8]) -> (Json, Result<Request, Refusal>) {
    if line.len() > LINE_BYTES_MAX {
        return (Json::Null, Err(too_long()));
    }
    let object = match serde_json::from_slice::<Json>(line) {
        Ok(Json::Object(object)) => object,
        Ok(_) => return (Json::Null, Err(not_understood("the line is no JSON object; write `{\"id\": 1, \"verb\": \"state\"}`"))),
        Err(error) => return (Json::Null, Err(not_understood(format!("the line is no JSON: {error}")))),
    };
    let id = match object.get("id") {
        None | Some(Json::Null) => Json::Null,
        // Another number would not come back digit by digit.
        Some(Json::Number(id)) if id.is_i64() || id.is_u64() => Json::Number(id.clone()),
        Some(Json::String(id)) if id.len() <= ID_BYTES_MAX => Json::String(id.clone()),
        Some(_) => {
            return (Json::Null, Err(not_understood(format!("the `id` is a whole number, or text of at most {ID_BYTES_MAX} bytes"))));
        }
    };
    let request = Fields(&object).request();
    (id, request)
}

/// A line that is longer than [`LINE_BYTES_MAX`].
pub fn too_long() -> Refusal {
    Refusal::new(Problem::P7092, format!("the line is longer than {LINE_BYTES_MAX} bytes"))
}

/// The fields of a request.
struct Fields<'a>(&'a Map<String, Json>);

impl<'a> Fields<'a> {
    fn request(&self) -> Result<Request, Refusal> {
        let name = self.text("verb")?.unwrap_or_default();
        let Some(verb) = VERBS.iter().find(|verb| verb.name == name) else {
            let known = VERBS.iter().map(|verb| format!("`{}`", verb.name)).collect::<Vec<_>>().join(", ");
            let what = if name.is_empty() { "there is no `verb`".to_owned() } else { format!("there is no verb `{}`", shortened(name)) };
            return Err(not_understood(format!("{what}; there are {known}")));
        };
        let unknown = self.0.keys().find(|key| !matches!(key.as_str(), "id" | "verb") && !verb.fields.contains(&key.as_str()));
        if let Some(unknown) = unknown {
            let fields = verb.fields.iter().map(|field| format!("`{field}`")).collect::<Vec<_>>().join(", ");
            let takes = if fields.is_empty() { "no fields".to_owned() } else { fields };
            return Err(not_understood(format!("`{name}` has no field `{}`; it takes {takes}", shortened(unknown))));
        }
        (verb.read)(self)
    }

    fn text(&self, key: &str) -> Result<Option<&'a str>, Refusal> {
        match self.0.get(key) {
            None => Ok(None),
            Some(Json::String(text)) => Ok(Some(text)),
            Some(_) => Err(not_understood(format!("`{key}` is text in quotation marks"))),
        }
    }

    fn wanted(&self, key: &str, example: &str) -> Result<&'a str, Refusal> {
        self.text(key)?.ok_or_else(|| not_understood(format!("`{key}` is missing; write `\"{key}\": \"{example}\"`")))
    }

    fn number(&self, key: &str, otherwise: u64) -> Result<u64, Refusal> {
        match self.0.get(key) {
            None => Ok(otherwise),
            Some(value) => value.as_u64().ok_or_else(|| not_understood(format!("`{key}` is a whole number from 0"))),
        }
    }

    /// How many things are left out.
    fn count(&self, key: &str) -> Result<usize, Refusal> {
        Ok(usize::try_from(self.number(key, 0)?).unwrap_or(usize::MAX))
    }

    fn press(&self) -> Result<Request, Refusal> {
        match self.number("ms", PRESS_MS)? {
            ms @ 1..=PRESS_MS_MAX => Ok(Request::Press { items: self.names()?, ms }),
            _ => Err(Refusal::new(Problem::P7092, format!("`ms` is a number from 1 to {PRESS_MS_MAX}"))),
        }
    }

    fn names(&self) -> Result<Vec<String>, Refusal> {
        let wanted = || not_understood("`items` is a list of names; write `\"items\": [\"MW10\", \"DB1.speed\"]`");
        let Some(Json::Array(items)) = self.0.get("items") else { return Err(wanted()) };
        few(items.len())?;
        items.iter().map(|item| item.as_str().map(str::to_owned).ok_or_else(wanted)).collect()
    }

    fn values(&self) -> Result<Vec<(String, String)>, Refusal> {
        let wanted = || not_understood("`values` has names with their values; write `\"values\": {\"MW10\": \"5\", \"Q0.0\": 1}`");
        let Some(Json::Object(values)) = self.0.get("values") else { return Err(wanted()) };
        few(values.len())?;
        let value = |(name, value): (&String, &Json)| {
            let text = match value {
                Json::String(text) => text.clone(),
                Json::Number(number) => number.to_string(),
                Json::Bool(bit) => u8::from(*bit).to_string(),
                _ => return Err(wanted()),
            };
            Ok((name.clone(), text))
        };
        values.iter().map(value).collect()
    }

    fn status(&self) -> Result<Request, Refusal> {
        let block = self.wanted("block", "OB 1")?.to_owned();
        let from = u32::try_from(self.number("from", 1)?.max(1)).unwrap_or(u32::MAX);
        let wait = match self.0.get("wait") {
            None | Some(Json::Bool(true)) => Wait::ForNewer,
            Some(Json::Bool(false)) => Wait::Not,
            Some(_) => return Err(not_understood("`wait` is true or false")),
        };
        Ok(Request::Status { block, after: self.number("after", 0)?, from, wait })
    }

    fn mode(&self) -> Result<Request, Refusal> {
        let restart = match self.text("restart")? {
            None => Restart::Warm,
            Some(word) => Restart::ALL
                .into_iter()
                .find(|kind| kind.word() == word)
                .ok_or_else(|| not_understood(format!("`{}` is no restart; there are `warm`, `cold` and `hot`", shortened(word))))?,
        };
        match self.wanted("mode", "run")? {
            "run" => Ok(Request::Mode(ModeChange::Run(restart))),
            _ if self.0.contains_key("restart") => Err(not_understood("`restart` belongs to `\"mode\": \"run\"`")),
            "stop" => Ok(Request::Mode(ModeChange::Stop)),
            "mres" => Ok(Request::Mode(ModeChange::MemoryReset)),
            other => Err(not_understood(format!("`{}` is no mode; there are `run`, `stop` and `mres`", shortened(other)))),
        }
    }

    fn time(&self) -> Result<Request, Refusal> {
        let word = self.wanted("time", "pause")?;
        let only = |key: &str, owner: &str| match self.0.contains_key(key) && word != owner {
            true => Err(not_understood(format!("`{key}` belongs to `\"time\": \"{owner}\"`"))),
            false => Ok(()),
        };
        only("scans", "step")?;
        only("speed", "speed")?;
        Ok(Request::Time(match word {
            "pause" => TimeChange::Pause,
            "go" => TimeChange::Go,
            "step" => match self.number("scans", 1)? {
                scans @ 1..=STEPS_MAX => TimeChange::Step(scans),
                _ => return Err(Refusal::new(Problem::P7092, format!("`scans` is a number from 1 to {STEPS_MAX}"))),
            },
            "speed" => TimeChange::Speed(Speed::parse(self.wanted("speed", "10x")?).map_err(not_understood)?),
            other => {
                return Err(not_understood(format!("`{}` is no time; there are `pause`, `go`, `step` and `speed`", shortened(other))));
            }
        }))
    }

    fn faults(&self) -> Result<Request, Refusal> {
        Ok(Request::Faults(match (self.text("inject")?, self.text("mend")?) {
            (None, None) => FaultChange::None,
            (Some(fault), None) => FaultChange::Inject(fault.to_owned()),
            (None, Some(signal)) => FaultChange::Mend(signal.to_owned()),
            (Some(_), Some(_)) => return Err(not_understood("one request has `inject` or `mend`, not both")),
        }))
    }
}

/// A list of items that is not too long.
fn few(length: usize) -> Result<(), Refusal> {
    match length > ITEMS_MAX {
        true => Err(Refusal::new(Problem::P7092, format!("{length} items are too many for one request; it takes {ITEMS_MAX}"))),
        false => Ok(()),
    }
}

/// A word of a user as it fits into a sentence.
pub(crate) fn shortened(text: &str) -> String {
    /// Characters that are shown.
    const SHOWN: usize = 60;
    match text.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or_default()),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn request(line: &str) -> Result<Request, String> {
        parse(line.as_bytes()).1.map_err(|refusal| format!("{}: {}", refusal.problem.code(), refusal.message))
    }

    #[test]
    fn every_verb_is_read() {
        let pair = |name: &str, value: &str| (name.to_owned(), value.to_owned());
        for (line, wanted) in [
            (r#"{"verb":"state"}"#, Request::State),
            (r#"{"verb":"read","items":["MW10","DB1.speed"]}"#, Request::Read(vec!["MW10".to_owned(), "DB1.speed".to_owned()])),
            (
                r#"{"verb":"write","values":{"MW10":"W#16#5","Q0.0":true,"DB1.x":1.5}}"#,
                Request::Write(vec![pair("MW10", "W#16#5"), pair("Q0.0", "1"), pair("DB1.x", "1.5")]),
            ),
            (r#"{"verb":"force","values":{"Q0.0":1}}"#, Request::Force(vec![pair("Q0.0", "1")])),
            (r#"{"verb":"unforce","items":["Q0.0"]}"#, Request::Unforce(vec!["Q0.0".to_owned()])),
            (r#"{"verb":"unforce_all"}"#, Request::UnforceAll),
            (r#"{"verb":"diagnostics"}"#, Request::Diagnostics { after: 0 }),
            (r#"{"verb":"diagnostics","after":7}"#, Request::Diagnostics { after: 7 }),
            (r#"{"verb":"blocks","from":3}"#, Request::Blocks { from: 3 }),
            (r#"{"verb":"status","block":"OB1"}"#, Request::Status { block: "OB1".to_owned(), after: 0, from: 1, wait: Wait::ForNewer }),
            (
                r#"{"verb":"status","block":"OB1","wait":false}"#,
                Request::Status { block: "OB1".to_owned(), after: 0, from: 1, wait: Wait::Not },
            ),
            (r#"{"verb":"plants"}"#, Request::Plants),
            (r#"{"verb":"listing","from":3}"#, Request::Listing { block: None, from: 3 }),
            (r#"{"verb":"names"}"#, Request::Names { from: 0 }),
            (r#"{"verb":"changes","after":7}"#, Request::Changes { after: 7 }),
            (r#"{"verb":"press","items":["I0.0"]}"#, Request::Press { items: vec!["I0.0".to_owned()], ms: 400 }),
            (r#"{"verb":"mode","mode":"run"}"#, Request::Mode(ModeChange::Run(Restart::Warm))),
            (r#"{"verb":"mode","mode":"run","restart":"cold"}"#, Request::Mode(ModeChange::Run(Restart::Cold))),
            (r#"{"verb":"mode","mode":"stop"}"#, Request::Mode(ModeChange::Stop)),
            (r#"{"verb":"mode","mode":"mres"}"#, Request::Mode(ModeChange::MemoryReset)),
            (r#"{"verb":"time","time":"pause"}"#, Request::Time(TimeChange::Pause)),
            (r#"{"verb":"time","time":"step","scans":5}"#, Request::Time(TimeChange::Step(5))),
            (r#"{"verb":"time","time":"speed","speed":"max"}"#, Request::Time(TimeChange::Speed(Speed::Max))),
            (r#"{"verb":"faults"}"#, Request::Faults(FaultChange::None)),
            (r#"{"verb":"faults","inject":"tank.level stuck"}"#, Request::Faults(FaultChange::Inject("tank.level stuck".to_owned()))),
            (r#"{"verb":"faults","mend":"tank"}"#, Request::Faults(FaultChange::Mend("tank".to_owned()))),
        ] {
            assert_eq!(request(line), Ok(wanted), "{line}");
        }
    }

    #[test]
    fn what_is_wrong_is_said() {
        let many = format!(r#"{{"verb":"read","items":[{}]}}"#, vec![r#""M""#; ITEMS_MAX + 1].join(","));
        let long = " ".repeat(LINE_BYTES_MAX + 1);
        for (line, part) in [
            ("", "P7091: the line is no JSON"),
            ("[1]", "P7091: the line is no JSON object"),
            ("{}", "P7091: there is no `verb`; there are `state`"),
            (r#"{"verb":1}"#, "P7091: `verb` is text"),
            (r#"{"verb":"fly"}"#, "P7091: there is no verb `fly`"),
            (r#"{"verb":"state","items":[]}"#, "P7091: `state` has no field `items`; it takes no fields"),
            (r#"{"verb":"read"}"#, "P7091: `items` is a list"),
            (r#"{"verb":"read","items":[1]}"#, "P7091: `items` is a list"),
            (r#"{"verb":"write","values":{"MW1":[]}}"#, "P7091: `values` has names"),
            (r#"{"verb":"status"}"#, "P7091: `block` is missing"),
            (r#"{"verb":"diagnostics","after":-1}"#, "P7091: `after` is a whole number"),
            (r#"{"verb":"mode","mode":"stop","restart":"warm"}"#, "P7091: `restart` belongs"),
            (r#"{"verb":"mode","mode":"fly"}"#, "P7091: `fly` is no mode"),
            (r#"{"verb":"time","time":"go","scans":1}"#, "P7091: `scans` belongs"),
            (r#"{"verb":"status","block":"OB1","wait":1}"#, "P7091: `wait` is true or false"),
            (r#"{"verb":"press","items":["I0.0"],"ms":0}"#, "P7092: `ms` is a number from 1"),
            (r#"{"verb":"time","time":"step","scans":0}"#, "P7092: `scans` is a number from 1"),
            (r#"{"verb":"time","time":"speed","speed":"0x"}"#, "P7091: `0x` is no speed"),
            (r#"{"verb":"faults","inject":"a","mend":"b"}"#, "P7091: one request has"),
            (r#"{"verb":"state","id":0.1}"#, "P7091: the `id` is a whole number"),
            (r#"{"verb":"state","id":[1]}"#, "P7091: the `id` is a whole number"),
            (&many, "P7092: 1001 items are too many"),
            (&long, "P7092: the line is longer"),
        ] {
            let error = request(line).expect_err(line);
            assert!(error.starts_with(part), "{line}: {error}");
        }
    }

    #[test]
    fn the_id_comes_back() {
        for (line, id) in [(r#"{"id":7,"verb":"state"}"#, "7"), (r#"{"id":"a","verb":"fly"}"#, r#""a""#), ("{", "null")] {
            assert_eq!(parse(line.as_bytes()).0.to_string(), id);
        }
    }
}
