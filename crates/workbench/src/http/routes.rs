//! Where each path of the interface leads: one table, from which the description of the interface comes too.

use serde_json::{Value as Json, json};
use sieben_cpu::Station;
use sieben_lang::reason::Language;
use sieben_model::address::Operand;
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_workspace::Refusal;
use sieben_workspace::control::answer::{Answer, Done};
use sieben_workspace::control::changes::Change;
use sieben_workspace::control::{Control, Request, parse};
use sieben_workspace::project::Build;
use sieben_workspace::watch_table::{self, Row};

use super::query::Query;
use crate::access::Role;
use crate::forces::{REASON_BYTES_MAX, Reason};
use crate::live::message::mnemonics;
use crate::live::program::Speech;
use crate::past::{self, Written};
use crate::projects::PROJECT;
use crate::reference::View;
use crate::server::{QUESTIONS_MAX, Shared};

/// What is answered.
pub(super) enum Reply {
    /// JSON.
    Json(Json),
    /// A text of another kind.
    Text(&'static str, String),
    /// Nothing but that it was done.
    Nothing,
}

/// A request as its route gets it.
pub(super) struct Asked<'r> {
    pub(super) shared: &'r Shared,
    /// What stands in the place of the `{…}` of the path.
    pub(super) captured: Vec<String>,
    pub(super) query: Query,
    /// The fields of the body.
    pub(super) body: Json,
    pub(super) peer: String,
    pub(super) language: Language,
}

/// Entries of the diagnostic buffer that are shown where no number is asked for: as many as a CPU in RUN shows.
const ENTRIES: usize = 10;
/// Entries that are shown at most: no CPU type keeps more.
const ENTRIES_MAX: usize = 500;

/// A field of a query.
pub(super) struct Parameter {
    pub(super) name: &'static str,
    pub(super) about: &'static str,
}

/// What is done at a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Method {
    Get,
    Post,
    Patch,
    Delete,
}

impl Method {
    /// Its word in a request.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Get => "GET",
            Self::Post => "POST",
            Self::Patch => "PATCH",
            Self::Delete => "DELETE",
        }
    }
}

/// A path with what it does.
pub(super) struct Route {
    pub(super) method: Method,
    pub(super) path: &'static str,
    pub(super) about: &'static str,
    /// Who may ask.
    pub(super) role: Role,
    pub(super) query: &'static [Parameter],
    /// An example of the body, if there is one.
    pub(super) body: Option<&'static str>,
    pub(super) answer: fn(&Asked<'_>) -> Result<Reply, Refusal>,
}

const fn get(path: &'static str, about: &'static str, answer: fn(&Asked<'_>) -> Result<Reply, Refusal>) -> Route {
    Route { method: Method::Get, path, about, role: Role::View, query: &[], body: None, answer }
}

const fn change(
    method: Method,
    path: &'static str,
    about: &'static str,
    body: Option<&'static str>,
    answer: fn(&Asked<'_>) -> Result<Reply, Refusal>,
) -> Route {
    Route { method, path, about, role: Role::Program, query: &[], body, answer }
}

/// All paths below `/api/v1/`, but for the stream of events and the description.
#[rustfmt::skip] // A table.
pub(super) const ROUTES: &[Route] = &[
    get("state", "How the run goes.", |asked| asked.control(&Request::State)),
    change(Method::Post, "mode", "Another operating mode: `run` (with `restart`: `warm`, `cold`, `hot`), `stop`, `mres`.", Some(r#"{"mode":"stop"}"#), |asked| asked.verb("mode")),
    change(Method::Post, "time", "Time stands still, goes on, goes so many scans, or goes so fast.", Some(r#"{"step":"scan","n":1}"#), time),
    get("blocks", "The blocks of the program, as a tree of calls.", |asked| asked.reference(|asked, build| Ok(asked.shared.reference.blocks(build)))),
    Route { query: &[Parameter { name: "view", about: "`stl`, `lad` or `fbd`" }, Parameter { name: "mnemonics", about: "`en` or `de`; those of the source without it" }], ..get("blocks/{block}", "A block with its networks.", block) },
    get("symbols", "The symbols with how often they are used.", |asked| asked.reference(|asked, build| Ok(asked.shared.reference.symbols(build)))),
    Route { query: &[Parameter { name: "name", about: "an address, a symbol or a block; all without one" }], ..get("refs", "Where a name is used.", |asked| asked.reference(|asked, build| asked.shared.reference.refs(build, asked.query.get("name")))) },
    get("assignments", "Which addresses are used.", |asked| asked.reference(|asked, build| Ok(asked.shared.reference.assignments(build)))),
    get("structure", "Which block calls which, and the local data of each path.", |asked| asked.reference(|asked, build| Ok(asked.shared.reference.structure(build)))),
    get("explain/{instruction}", "What an instruction does.", explain),
    Route { query: &[Parameter { name: "names", about: "names, separated by commas" }], ..get("tags", "Values of one scan.", tags) },
    change(Method::Patch, "tags", "Writes values, all between the same two scans.", Some(r#"{"M 50.0":true}"#), write),
    change(Method::Post, "press", "Bits are 1 for so many milliseconds of the CPU's time, as a push button.", Some(r#"{"items":["I 0.0"],"ms":400}"#), |asked| asked.verb("press")),
    get("names", "The assignment table as those need it who operate the program: symbols, addresses, terminals of plants.", |asked| asked.fields("names", json!({}))),
    get("forces", "What is forced, to what, by whom and why.", |asked| Ok(Reply::Json(asked.shared.hub.forces.json(&asked.shared.hub)))),
    change(Method::Post, "forces", "Forces a value, with a reason that everyone sees.", Some(r#"{"name":"I 0.1","value":"1","reason":"sensor is exchanged"}"#), force),
    change(Method::Delete, "forces", "Nothing is forced any more.", None, |asked| { asked.control(&Request::UnforceAll)?; Ok(asked.forces()) }),
    change(Method::Delete, "forces/{name}", "This is not forced any more.", None, |asked| { asked.done(&Request::Unforce(asked.captured.clone()))?; Ok(asked.forces()) }),
    Route { query: &[Parameter { name: "n", about: "so many of the newest entries: 1 to 500; without it 10, or all that came after `after`" }, Parameter { name: "after", about: "the number of the last entry that is known" }, Parameter { name: "format", about: "`text` for a text to save" }], ..get("diagnostics", "The diagnostic buffer.", diagnostics) },
    get("clients", "Who is connected to servers and looks at pages.", |asked| Ok(Reply::Json(asked.shared.hub.clients()))),
    get("plants", "The simulated plants with their terminals.", plants),
    get("faults", "The plants with their signals and faults.", |asked| asked.verb("faults")),
    change(Method::Post, "faults", "A signal of a plant fails, or is mended.", Some(r#"{"inject":"tank.level stuck=0"}"#), faults),
    Route { query: &[Parameter { name: "from", about: "the first scan" }, Parameter { name: "to", about: "the last scan" }, Parameter { name: "channels", about: "names, separated by commas" }, Parameter { name: "format", about: "`csv`, `vcd` or `svg`" }], ..get("trace", "Values of scans of the past.", trace) },
    get("project", "The project that runs, and the examples that may run instead.", |asked| Ok(Reply::Json(asked.shared.projects.listed().json()))),
    change(Method::Post, "project", "Another example runs from now on, with a CPU of its own.", Some(r#"{"example":"star-delta"}"#), project),
    get("watch", "The names of the watch tables of the project.", |asked| asked.shared.projects.watch_tables().map(|names| Reply::Json(json!(names)))),
    get("watch/{file}", "The rows of a watch table.", watch_table),
    Route { query: &[Parameter { name: "mnemonics", about: "`en` or `de`; those of the source without it" }], ..get("stacks", "What ran when a statement sent the CPU to STOP: blocks, registers, local data.", |asked| { let speech = Speech { language: asked.language, mnemonics: spelled(asked)? }; crate::stacks::stacks(&asked.shared.hub, speech).map(Reply::Json) }) },
    get("info", "What the run is: its CPU and its servers.", info),
];

impl Asked<'_> {
    fn control_answer(&self, request: &Request) -> Result<Answer, Refusal> {
        let hub = &self.shared.hub;
        Control::of_peer(std::sync::Arc::clone(&hub.facts), self.peer.clone()).answer(&hub.gate, &hub.desk, request)
    }

    /// Asks for a change of one thing.
    fn done(&self, request: &Request) -> Result<Done, Refusal> {
        let Answer::Done(mut done) = self.control_answer(request)? else { return Ok(Done::default()) };
        match done.items.pop() {
            Some((_, Err(refusal))) => Err(refusal),
            _ => Ok(done),
        }
    }

    /// Asks what the control socket is asked too.
    fn control(&self, request: &Request) -> Result<Reply, Refusal> {
        self.control_answer(request).map(|answer| Reply::Json(Json::Object(answer.fields())))
    }

    /// A verb of the control socket, whose fields are those of the body.
    fn verb(&self, verb: &str) -> Result<Reply, Refusal> {
        self.fields(verb, self.body.clone())
    }

    fn fields(&self, verb: &str, mut fields: Json) -> Result<Reply, Refusal> {
        if fields.is_null() {
            fields = json!({});
        }
        match fields.as_object_mut() {
            Some(object) => drop(object.insert("verb".to_owned(), verb.into())),
            None => return Err(Refusal::new(Problem::P7131, "the body is a JSON object")),
        }
        let (_, request) = parse(fields.to_string().as_bytes());
        self.control(&request?)
    }

    /// Asks about the program as a whole.
    fn reference(&self, ask: impl FnOnce(&Self, &Build) -> Result<Json, Refusal>) -> Result<Reply, Refusal> {
        let program = self.shared.hub.program();
        let build = program
            .facts
            .build
            .as_ref()
            .ok_or_else(|| Refusal::new(Problem::P7095, "this run keeps nothing of its program but the code"))?;
        ask(self, build).map(Reply::Json)
    }

    fn forces(&self) -> Reply {
        Reply::Json(self.shared.hub.forces.json(&self.shared.hub))
    }

    fn text(&self, key: &str) -> Option<&str> {
        self.body.get(key).and_then(Json::as_str)
    }
}

fn wrong(message: &str) -> Refusal {
    Refusal::new(Problem::P7131, message)
}

/// `{"pause":true}`, `{"go":true}`, `{"step":"scan","n":1}`, `{"speed":10}`.
fn time(asked: &Asked<'_>) -> Result<Reply, Refusal> {
    let has = |key: &str| asked.body.get(key).is_some_and(|value| value == &json!(true));
    let fields = match (asked.text("step"), asked.body.get("speed")) {
        (Some("scan"), _) => json!({ "time": "step", "scans": asked.body.get("n").cloned().unwrap_or(json!(1)) }),
        (Some(_), _) => {
            return Err(wrong("`step` is `scan`: the CPU stops between scans only; statements are stepped through in the past"));
        }
        (None, Some(Json::Number(factor))) => json!({ "time": "speed", "speed": format!("{factor}x") }),
        (None, Some(Json::String(speed))) => json!({ "time": "speed", "speed": speed }),
        _ if has("pause") => json!({ "time": "pause" }),
        _ if has("go") => json!({ "time": "go" }),
        _ => return Err(wrong("write `{\"pause\": true}`, `{\"go\": true}`, `{\"step\": \"scan\", \"n\": 1}` or `{\"speed\": 10}`")),
    };
    asked.fields("time", fields)
}

fn block_of(asked: &Asked<'_>) -> Result<BlockId, Refusal> {
    let name = asked.captured.first().map_or("", String::as_str);
    let none = || Refusal::new(Problem::P7095, format!("there is no block `{}`", shortened(name)));
    asked.shared.hub.program().facts.block(name).ok_or_else(none)
}

/// A word of a user as it fits into a sentence.
fn shortened(text: &str) -> String {
    /// Characters that are shown.
    const SHOWN: usize = 60;
    if text.chars().count() > SHOWN { text.chars().take(SHOWN).chain(['…']).collect() } else { text.to_owned() }
}

/// The mnemonics that are asked for.
fn spelled(asked: &Asked<'_>) -> Result<Option<Mnemonics>, Refusal> {
    let word = asked.query.get("mnemonics");
    word.map(|word| mnemonics(word).ok_or_else(|| wrong("`mnemonics` is `en` or `de`"))).transpose()
}

fn block(asked: &Asked<'_>) -> Result<Reply, Refusal> {
    let word = asked.query.get("view").unwrap_or("stl");
    let view = View::ALL.iter().find(|(known, _)| *known == word).map(|&(_, view)| view);
    let view = view.ok_or_else(|| wrong("`view` is `stl`, `lad` or `fbd`"))?;
    let spelled = spelled(asked)?;
    let id = block_of(asked)?;
    asked.reference(|asked, build| asked.shared.reference.block(build, id, (view, spelled)))
}

fn explain(asked: &Asked<'_>) -> Result<Reply, Refusal> {
    let word = asked.captured.first().map_or("", String::as_str);
    let text = asked.shared.reference.explain(word, asked.language);
    let text = text.ok_or_else(|| Refusal::new(Problem::P7137, format!("there is no instruction `{}`", shortened(word))))?;
    Ok(Reply::Json(json!({ "text": text })))
}

fn tags(asked: &Asked<'_>) -> Result<Reply, Refusal> {
    let names = asked.query.get("names").ok_or_else(|| wrong("`names` is missing; write `?names=MW10,Q0.0`"))?;
    let names = sieben_workspace::names::split_list(names).into_iter().map(str::to_owned).collect();
    asked.control(&Request::Read(names))
}

/// The names of the body with their values.
fn write(asked: &Asked<'_>) -> Result<Reply, Refusal> {
    asked.fields("write", json!({ "values": asked.body }))
}

fn force(asked: &Asked<'_>) -> Result<Reply, Refusal> {
    let (Some(name), Some(value)) = (asked.text("name"), asked.body.get("value")) else {
        return Err(wrong("write `{\"name\": \"I 0.1\", \"value\": \"1\", \"reason\": \"…\"}`"));
    };
    let reason = asked.text("reason").unwrap_or_default();
    if reason.len() > REASON_BYTES_MAX {
        return Err(wrong("`reason` is text of at most 500 bytes"));
    }
    let (_, request) = parse(json!({ "verb": "force", "values": { name: value } }).to_string().as_bytes());
    let done = asked.done(&request?)?;
    let facts = asked.shared.hub.facts.facts();
    let plain = name.trim().trim_matches('"');
    let operand = Operand::parse(plain).or_else(|| facts.symbols.operand(plain));
    let hub = &asked.shared.hub;
    let since = hub.gate.look(|plant| plant.cpu.clock().display())?;
    let by = asked.peer.clone();
    let Some(Operand::Address(address)) = operand else { return Ok(asked.forces()) };
    hub.forces.note(address, Reason { text: reason.to_owned(), by, since, scan: done.scan.unwrap_or_default() });
    Ok(asked.forces())
}

fn diagnostics(asked: &Asked<'_>) -> Result<Reply, Refusal> {
    let after = match asked.query.get("after") {
        None => 0,
        Some(after) => after.parse().map_err(|_| wrong("`after` is a whole number from 0"))?,
    };
    let is_text = asked.query.get("format") == Some("text");
    let most = match asked.query.get("n") {
        Some(n) => {
            let n = n.parse().ok().filter(|n| (1..=ENTRIES_MAX).contains(n));
            n.ok_or_else(|| wrong(&format!("`n` is a whole number from 1 to {ENTRIES_MAX}: so many of the newest entries")))?
        }
        // Who saves the buffer, or asks for what came after an entry, gets all of it.
        None if is_text || after > 0 => ENTRIES_MAX,
        None => ENTRIES,
    };
    let Answer::Diagnostics(mut found) = asked.control_answer(&Request::Diagnostics { after })? else { return Ok(Reply::Nothing) };
    let older = found.entries.len().saturating_sub(most);
    found.entries.drain(..older);
    if !is_text {
        return Ok(Reply::Json(Json::Object(Answer::Diagnostics(found).fields())));
    }
    let line = |entry: &sieben_workspace::control::answer::Entry| format!("{}  16#{:04X}  {}\n", entry.time, entry.event, entry.text);
    Ok(Reply::Text("text/plain; charset=utf-8", found.entries.iter().rev().map(line).collect()))
}

/// The plants, and what their inputs and outputs are for.
fn plants(asked: &Asked<'_>) -> Result<Reply, Refusal> {
    use sieben_cpu::IoModule;
    use sieben_sim::devices::{Direction, Operated, Signal};
    use sieben_sim::wrap;
    let hub = &asked.shared.hub;
    let facts = hub.facts.facts();
    let heads = hub.gate.look(|plant| {
        let head = |plant: &wrap::Plant| {
            let (inputs, outputs) = (plant.inputs().start, plant.outputs().start);
            (plant.name().to_owned(), plant.kind(), plant.device().signals().to_vec(), inputs, outputs)
        };
        wrap::plants(plant.cpu.rack()).map(head).collect::<Vec<_>>()
    })?;
    let plant = |(name, kind, signals, inputs, outputs): (String, &'static sieben_sim::devices::Kind, Vec<Signal>, u32, u32)| {
        let signal = |signal: &Signal| {
            let address = signal.address(if signal.is_input() { inputs } else { outputs });
            let operand = Operand::parse(&address);
            let symbol = operand.and_then(|operand| facts.symbols.find_operand(&operand)).map_or("", |symbol| &symbol.name);
            let (driven, handle) = match signal.direction {
                Direction::Sensor | Direction::Actuator => ("plant", None),
                Direction::Hand { operated: Operated::Button, closed: false } => ("user", Some("push")),
                Direction::Hand { operated: Operated::Button, closed: true } => ("user", Some("push-nc")),
                Direction::Hand { operated: Operated::Switch, closed: false } => ("user", Some("switch")),
                Direction::Hand { operated: Operated::Switch, closed: true } => ("user", Some("switch-nc")),
            };
            let mut object = json!({
                "name": signal.name, "address": address, "symbol": symbol, "direction": if signal.is_input() { "in" } else { "out" },
                "driven": driven, "about": signal.about, "unit": signal.unit, "per_unit": signal.per_unit,
            });
            if let Some(handle) = handle {
                object["handle"] = json!(handle);
            }
            object
        };
        let signals: Vec<Json> = signals.iter().map(signal).collect();
        let parameters: Vec<&str> = kind.parameters.iter().map(|parameter| parameter.name).collect();
        json!({ "name": name, "kind": kind.name, "title": kind.name, "detail": kind.about, "signals": signals, "parameters": parameters })
    };
    Ok(Reply::Json(heads.into_iter().map(plant).collect()))
}

/// `{"inject":"tank.level stuck=0"}`, `{"mend":"tank"}`; the page says `{"name":"tank.level","fault":"stuck=0"}`, and ends it with `""`.
fn faults(asked: &Asked<'_>) -> Result<Reply, Refusal> {
    let full = asked.text("name").map(|name| full_signal(asked, name)).transpose()?;
    match (full, asked.text("fault")) {
        (Some(name), Some("")) => asked.fields("faults", json!({ "mend": name })),
        (Some(name), Some(fault)) => asked.fields("faults", json!({ "inject": format!("{name} {fault}") })),
        _ => asked.verb("faults"),
    }
}

/// `tank.level` for `level`, where only one plant has a signal of that name.
fn full_signal(asked: &Asked<'_>, name: &str) -> Result<String, Refusal> {
    use sieben_cpu::IoModule;
    if name.contains('.') {
        return Ok(name.to_owned());
    }
    let plants = asked.shared.hub.gate.look(|plant| {
        let has = |plant: &&sieben_sim::wrap::Plant| plant.kind().signals.iter().any(|signal| signal.name == name);
        sieben_sim::wrap::plants(plant.cpu.rack()).filter(has).map(|plant| plant.name().to_owned()).collect::<Vec<_>>()
    })?;
    Ok(match plants.as_slice() {
        [only] => format!("{only}.{name}"),
        _ => name.to_owned(),
    })
}

fn trace(asked: &Asked<'_>) -> Result<Reply, Refusal> {
    let scan = |name: &str| {
        let number = asked.query.get(name).and_then(|text| text.parse().ok());
        number.ok_or_else(|| wrong("`from` and `to` are numbers of scans; write `?from=1&to=100&channels=Q0.0&format=csv`"))
    };
    let word = asked.query.get("format").unwrap_or("csv");
    let known = Written::ALL.iter().find(|(known, ..)| *known == word);
    let &(_, written, kind) = known.ok_or_else(|| wrong("`format` is `csv`, `vcd` or `svg`"))?;
    let _one = asked.shared.questions.try_acquire().map_err(|_| {
        Refusal::new(Problem::P7136, format!("{QUESTIONS_MAX} questions about the past are being answered already")).help("ask again")
    })?;
    let text = past::trace(&asked.shared.hub, (scan("from")?, scan("to")?), asked.query.get("channels").unwrap_or_default(), written)?;
    Ok(Reply::Text(kind, text))
}

/// `{"example":"star-delta"}`.
fn project(asked: &Asked<'_>) -> Result<Reply, Refusal> {
    let example = asked.text("example").ok_or_else(|| wrong("write `{\"example\": \"star-delta\"}`"))?;
    let (projects, facts) = (&asked.shared.projects, &asked.shared.hub.facts);
    let changed = projects.change(example);
    let refused = changed.as_ref().err().map(|refusal| refusal.problem.code());
    facts.tell(&asked.peer, Change { what: PROJECT, object: Some(shortened(example)), value: None, scan: None, refused });
    changed.map(|()| Reply::Json(projects.listed().json()))
}

fn watch_table(asked: &Asked<'_>) -> Result<Reply, Refusal> {
    let name = asked.captured.first().map_or("", String::as_str);
    let rows = watch_table::parse(name, &asked.shared.projects.watch_table(name)?)?;
    let row = |row: Row| json!({ "name": row.name, "format": row.format, "comment": row.comment });
    Ok(Reply::Json(rows.into_iter().map(row).collect()))
}

fn info(asked: &Asked<'_>) -> Result<Reply, Refusal> {
    let hub = &asked.shared.hub;
    let read = |plant: &sieben_workspace::Plant| {
        let cpu = &plant.cpu;
        (cpu.cpu_type(), cpu.clock().display(), plant.pace.cycle_us, cpu.system_status().memory())
    };
    let (cpu, clock, cycle_us, [work, load]) = hub.gate.look(read)?;
    let program = hub.program();
    let used: u64 = program.facts.program.data.values().map(|block| block.image.len() as u64).sum();
    Ok(Reply::Json(json!({
        "cpu": cpu.name, "project": program.facts.project, "program": program.hash(), "clock": clock, "cycle_us": cycle_us,
        "work_memory": work.size, "work_used": work.used, "load_memory": load.size, "load_used": load.used,
        "local_data": cpu.local_data, "data_bytes": used,
        "servers": [{ "name": "page", "address": asked.shared.access.listen.to_string() }], "connections": hub.facts.connections(),
    })))
}
