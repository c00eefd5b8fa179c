//! What a client only tells.

use std::path::PathBuf;

use lsp_server::ErrorCode;
use lsp_types::notification::{
    DidChangeTextDocument, DidChangeWatchedFiles, DidChangeWorkspaceFolders, DidCloseTextDocument, DidOpenTextDocument,
    DidSaveTextDocument, Notification,
};
use serde_json::Value;

use super::server::Server;
use super::uri::{self, Place};
use super::work::{Answer, refused};

/// Takes in what is told; what is not known is left out.
pub(super) fn take(server: &mut Server, method: &str, params: Value) -> Answer {
    match method {
        "initialized" => server.initialized(),
        DidOpenTextDocument::METHOD => open(server, &params)?,
        DidChangeTextDocument::METHOD => change(server, &params)?,
        DidCloseTextDocument::METHOD => close(server, uri_in(method, &params)?),
        DidSaveTextDocument::METHOD => {
            let place = Place::of(uri_in(method, &params)?);
            server.changed(place);
        }
        DidChangeWatchedFiles::METHOD => {
            let changes = params.get("changes").and_then(Value::as_array);
            for uri in changes.into_iter().flatten().filter_map(|change| change.get("uri")?.as_str()) {
                outside(server, uri);
            }
        }
        DidChangeWorkspaceFolders::METHOD => {
            let event = read::<DidChangeWorkspaceFolders>(params)?.event;
            let paths = |folders: Vec<lsp_types::WorkspaceFolder>| -> Vec<PathBuf> {
                folders.iter().filter_map(|folder| uri::path_of(folder.uri.as_str())).collect()
            };
            paths(event.removed).iter().for_each(|path| server.folders.remove(path));
            paths(event.added).iter().for_each(|path| server.folders.add(path));
            server.soon();
        }
        "workspace/didChangeConfiguration" => {
            let settings = params.get("settings").filter(|settings| settings.is_object());
            if let Some(settings) = settings {
                server.set(server.client.changed(settings));
            }
        }
        _ => {}
    }
    Ok(Value::Null)
}

/// A field of the text that is told of. URIs are taken as clients spell them, also such that are none to the letter.
fn field<'p>(method: &str, params: &'p Value, name: &str) -> Result<&'p str, lsp_server::ResponseError> {
    let field = params.pointer(&format!("/textDocument/{name}")).and_then(Value::as_str);
    field.ok_or_else(|| refused(ErrorCode::InvalidParams, format!("`{method}` has no `textDocument.{name}`")))
}

fn uri_in<'p>(method: &str, params: &'p Value) -> Result<&'p str, lsp_server::ResponseError> {
    field(method, params, "uri")
}

/// The number that a client gave a text; without one it is the one that it had.
fn version(params: &Value) -> Option<i32> {
    params.pointer("/textDocument/version").and_then(Value::as_i64).and_then(|version| i32::try_from(version).ok())
}

fn read<N: Notification>(params: Value) -> Result<N::Params, lsp_server::ResponseError> {
    serde_json::from_value(params).map_err(|error| refused(ErrorCode::InvalidParams, format!("`{}` is not understood: {error}", N::METHOD)))
}

fn open(server: &mut Server, params: &Value) -> Result<(), lsp_server::ResponseError> {
    let text_field = |name| field(DidOpenTextDocument::METHOD, params, name).map(str::to_owned);
    let (uri, text) = (text_field("uri")?, text_field("text")?);
    let columns = server.columns();
    let language = text_field("languageId").unwrap_or_default();
    let place = server.documents.open(uri, language, version(params).unwrap_or_default(), text, columns);
    if server.documents.get(&place).is_some_and(|document| document.is_lossy) {
        let name = place.path().and_then(|path| path.file_name()).map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        server.show(
            2,
            &format!("`{name}` is not UTF-8: saving it would lose characters. Reopen it with its encoding, for example Windows 1252."),
        );
    }
    server.changed(place);
    Ok(())
}

fn change(server: &mut Server, params: &Value) -> Result<(), lsp_server::ResponseError> {
    let method = DidChangeTextDocument::METHOD;
    let uri = uri_in(method, params)?;
    let columns = server.columns();
    let changes = params.get("contentChanges").cloned().unwrap_or_default();
    let changes = serde_json::from_value(changes)
        .map_err(|error| refused(ErrorCode::InvalidParams, format!("`{method}` is not understood: {error}")))?;
    let changed = server.documents.change(uri, version(params), changes, columns);
    let place = changed.ok_or_else(|| refused(ErrorCode::InvalidParams, format!("`{uri}` was changed, but is not open")))?;
    server.changed(place);
    Ok(())
}

fn close(server: &mut Server, uri: &str) {
    if let Some((place, _)) = server.documents.close(uri) {
        server.changed(place);
    }
}

/// Another program has changed, made or removed a file. What is open is what the client says it is.
fn outside(server: &mut Server, uri: &str) {
    let place = Place::of(uri);
    if let Place::File(path) = &place
        && server.documents.get(&place).is_none()
    {
        server.folders.changed_outside(path);
        server.soon();
    }
}
