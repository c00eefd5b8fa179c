//! Commands that a client has the server execute.

use std::ops::Range;
use std::sync::Arc;
use std::time::{Duration, Instant};

use lsp_server::{ErrorCode, RequestId};
use lsp_types::Position;
use serde_json::{Value, json};
use sieben_ide::text::Text;
use sieben_ide::text::outline::{Kind, Row};
use sieben_model::block::BlockId;
use sieben_model::language::Language;
use sieben_sim::scenario::Rules;
use sieben_workspace::places::Places;
use sieben_workspace::testing::{Conditions, report};

use super::reading::missing;
use super::requests::LATER;
use super::server::Server;
use super::work::{self, Answer, refused};
use crate::diagrams::{Diagrams, ElementPlaces, Form, Written, svg};
use crate::engines::EngineArgument;
use crate::files;
use crate::testing::computer::Computer;
use crate::testing::{discovery, run_all};

/// All of them.
pub(super) const ALL: [&str; 2] = ["sieben.runTest", "sieben.showDiagram"];

/// Real time after which a test is given up.
const TIMEOUT: Duration = Duration::from_secs(60);

/// Executes a command.
pub(super) fn execute(server: &mut Server, id: &RequestId, command: &str, arguments: &[Value]) -> Answer {
    match command {
        "sieben.runTest" => run_test(server, id, arguments),
        "sieben.showDiagram" => show_diagram(server, arguments),
        _ => Err(refused(ErrorCode::InvalidParams, format!("there is no command `{command}`; there are {}", ALL.join(", ")))),
    }
}

/// Runs the tests of a file, or the one with this name: the same JSON as `sieben test --json`. Texts are those that are open.
fn run_test(server: &mut Server, id: &RequestId, arguments: &[Value]) -> Answer {
    let uri = arguments.first().and_then(Value::as_str).ok_or_else(|| missing("arguments[0]"))?;
    let path = super::uri::path_of(uri).ok_or_else(|| refused(ErrorCode::RequestFailed, format!("`{uri}` is no file")))?;
    let name = arguments.get(1).and_then(Value::as_str).map(str::to_owned);
    let open = server.documents.over_files();
    let conditions = Conditions {
        outside: Arc::new(Computer::new(EngineArgument::default(), None, Language::English)),
        overrides: server.client.settings.overrides(),
        diagnostics: false,
        encoding: None,
        cycle: None,
        limit: None,
        scans: None,
        timeout: TIMEOUT,
        coverage: None,
        rules: Rules::default(),
    };
    let run = move || {
        let begun = Instant::now();
        let finished = files::with_open(open, || {
            let found = discovery::cases(&[path], &[], &conditions).map_err(|failure| failure.refusal.message)?;
            let mut cases = found.cases;
            if let Some(name) = &name {
                cases.retain(|case| case.name.ends_with(&format!(": {name}")) || case.name == *name);
            }
            if cases.is_empty() {
                return Err("there is no such test".to_owned());
            }
            Ok(run_all(&cases, &conditions, 1, &|_| ()))
        });
        match finished {
            Ok(finished) => Ok(report::to_json(&finished, begun.elapsed())),
            Err(why) => Err(refused(ErrorCode::RequestFailed, why)),
        }
    };
    work::start(id.clone(), "sieben.runTest", server.events.clone(), run)?;
    Err(refused_later())
}

fn refused_later() -> lsp_server::ResponseError {
    lsp_server::ResponseError { code: LATER, message: String::new(), data: None }
}

/// The bytes of the network that a byte belongs to; those of a block without networks, which is one.
fn network_at(rows: &[Row], byte: usize) -> Option<Range<usize>> {
    let row = rows.iter().rfind(|row| (row.whole.0..=row.whole.1).contains(&byte))?;
    let is_whole = match row.kind {
        Kind::Network => true,
        Kind::Section | Kind::Variable | Kind::Constant | Kind::Label => false,
        _ => !has_networks(row),
    };
    network_at(&row.rows, byte).or_else(|| is_whole.then_some(row.whole.0..row.whole.1))
}

fn has_networks(row: &Row) -> bool {
    row.rows.iter().any(|row| row.kind == Kind::Network || has_networks(row))
}

/// The network at a position as SVG: `[uri, position, "lad" | "fbd"]`.
fn show_diagram(server: &mut Server, arguments: &[Value]) -> Answer {
    let uri = arguments.first().and_then(Value::as_str).ok_or_else(|| missing("arguments[0]"))?.to_owned();
    let position: Position =
        arguments.get(1).cloned().and_then(|position| serde_json::from_value(position).ok()).ok_or_else(|| missing("arguments[1]"))?;
    let form = match arguments.get(2).and_then(Value::as_str).unwrap_or("lad").to_ascii_lowercase().as_str() {
        "fbd" => Form::Fbd,
        _ => Form::Lad,
    };
    let refuse = |why: &str| refused(ErrorCode::RequestFailed, why);
    let (place, _) = server.document(&uri)?;
    let known = server.known(&place).ok_or_else(|| refuse("this text is part of no program"))?;
    let (_, document) = server.document(&uri)?;
    let parsed = Text::parse(&known.name, document.text(), known.language, known.mnemonics);
    let none = "there is no network here that can be drawn; a block with errors has none";
    let within = network_at(&parsed.outline(), server.byte(document, position)).ok_or_else(|| refuse(none))?;
    server.renew();
    let (program, file) = server.folders.program_of(&place).ok_or_else(|| refuse("this text is part of no program"))?;
    let build = program.build();
    let places = Places::new(&build);
    let diagrams = Diagrams::new(&build, &places);
    let mut best: Option<(u32, BlockId, &Written)> = None;
    for (block, code) in diagrams.blocks() {
        for network in &code.networks {
            let first = match &network.places {
                ElementPlaces::Statements(spans) => spans.iter().filter(|span| span.file == file).map(|span| span.start).min(),
                ElementPlaces::Bytes(of, start) => (*of == file).then_some(*start),
            };
            let Some(first) = first.filter(|first| within.contains(&(*first as usize))) else { continue };
            if best.as_ref().is_none_or(|(known, ..)| first < *known) {
                best = Some((first, block, network));
            }
        }
    }
    let (_, block, network) = best.ok_or_else(|| refuse(none))?;
    let shown = diagrams.shown(block, network, form, None);
    let (title, reason) = (shown.title.clone(), shown.reason.clone());
    let picture = svg(&[(shown, network)]);
    Ok(json!({ "title": title, "block": diagrams.name(block), "network": network.number, "svg": picture, "reason": reason }))
}
