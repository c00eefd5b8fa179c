//! What a client asks: one row for each method.

use lsp_server::{ErrorCode, RequestId, ResponseError};
use lsp_types::{Position, Range};
use serde_json::{Value, json};
use sieben_ide::editing::definition;

use super::programs::Tests;
use super::server::Server;
use super::uri::Place;
use super::work::{Answer, refused};
use super::{actions, executing, naming, reading};
use crate::problem_pages;

/// The code of an answer that another thread gives.
pub(super) const LATER: i32 = i32::MIN;

/// The parameters of a request, of which clients leave out what they like.
struct Parameters(Value);

impl Parameters {
    fn at(&self, path: &str) -> Option<&Value> {
        self.0.pointer(path).filter(|value| !value.is_null())
    }

    fn uri(&self) -> Result<String, ResponseError> {
        self.text("/textDocument/uri")
    }

    fn text(&self, path: &str) -> Result<String, ResponseError> {
        self.at(path).and_then(Value::as_str).map(str::to_owned).ok_or_else(|| reading::missing(path))
    }

    fn position(&self) -> Result<Position, ResponseError> {
        self.at("/position").and_then(|value| serde_json::from_value(value.clone()).ok()).ok_or_else(|| reading::missing("/position"))
    }

    fn range(&self) -> Result<Range, ResponseError> {
        self.at("/range").and_then(|value| serde_json::from_value(value.clone()).ok()).ok_or_else(|| reading::missing("/range"))
    }

    fn list(&self, path: &str) -> Vec<Value> {
        self.at(path).and_then(Value::as_array).cloned().unwrap_or_default()
    }
}

/// Answers a request.
pub(super) fn answer(server: &mut Server, id: &RequestId, method: &str, params: Value) -> Answer {
    let given = Parameters(params);
    match method {
        "textDocument/documentSymbol" => reading::outline(server, &given.uri()?),
        "textDocument/foldingRange" => reading::folds(server, &given.uri()?),
        "textDocument/selectionRange" => {
            let positions: Vec<Position> =
                given.list("/positions").into_iter().filter_map(|one| serde_json::from_value(one).ok()).collect();
            reading::selections(server, &given.uri()?, &positions)
        }
        "textDocument/semanticTokens/full" => reading::tokens(server, &given.uri()?, None),
        "textDocument/semanticTokens/range" => reading::tokens(server, &given.uri()?, Some(given.range()?)),
        "textDocument/formatting" => reading::format(server, &given.uri()?, None),
        "textDocument/rangeFormatting" => reading::format(server, &given.uri()?, Some(given.range()?)),
        "textDocument/codeLens" => reading::lenses(server, &given.uri()?),
        "textDocument/hover" => naming::hover(server, &given.uri()?, given.position()?),
        "textDocument/completion" => naming::completion(server, &given.uri()?, given.position()?),
        "textDocument/signatureHelp" => naming::signature(server, &given.uri()?, given.position()?),
        "textDocument/definition" => naming::links(server, &given.uri()?, given.position()?, definition::definition),
        "textDocument/declaration" => naming::links(server, &given.uri()?, given.position()?, definition::declaration),
        "textDocument/typeDefinition" => naming::links(server, &given.uri()?, given.position()?, definition::type_definition),
        "textDocument/references" => {
            let with = given.at("/context/includeDeclaration").and_then(Value::as_bool).unwrap_or(true);
            naming::references(server, &given.uri()?, given.position()?, with)
        }
        "textDocument/documentHighlight" => naming::highlights(server, &given.uri()?, given.position()?),
        "textDocument/prepareRename" => naming::prepare_rename(server, &given.uri()?, given.position()?),
        "textDocument/rename" => naming::rename(server, &given.uri()?, given.position()?, &given.text("/newName")?),
        "textDocument/linkedEditingRange" => naming::linked(server, &given.uri()?, given.position()?),
        "textDocument/inlayHint" => naming::inlay_hints(server, &given.uri()?, given.range()?),
        "textDocument/prepareCallHierarchy" => naming::prepare_calls(server, &given.uri()?, given.position()?),
        "callHierarchy/incomingCalls" => naming::calls(server, given.at("/item").unwrap_or(&Value::Null), true),
        "callHierarchy/outgoingCalls" => naming::calls(server, given.at("/item").unwrap_or(&Value::Null), false),
        "workspace/symbol" => naming::symbols(server, &given.text("/query")?),
        "textDocument/codeAction" => {
            let only: Vec<String> = given.list("/context/only").iter().filter_map(Value::as_str).map(str::to_owned).collect();
            actions::actions(server, &given.uri()?, given.range()?, &only, &given.list("/context/diagnostics"))
        }
        "workspace/executeCommand" => executing::execute(server, id, &given.text("/command")?, &given.list("/arguments")),
        "textDocument/diagnostic" => {
            let place = Place::of(&given.uri()?);
            let tests = if place.path().is_some_and(crate::paths::is_test) { Tests::All } else { Tests::Typed };
            let items = server.found(tests).0.remove(&place).unwrap_or_default();
            Ok(json!({ "kind": "full", "items": items }))
        }
        "workspace/textDocumentContent" => {
            let uri = given.text("/uri").or_else(|_| given.uri())?;
            let page = uri.strip_prefix(super::diagnostics::PAGES).and_then(problem_pages::page);
            let page = page.ok_or_else(|| refused(ErrorCode::InvalidParams, format!("there is no page `{uri}`")))?;
            Ok(json!({ "text": page }))
        }
        _ => Err(refused(ErrorCode::MethodNotFound, format!("`{method}` is not known"))),
    }
}
