//! What a client only tells.

use std::path::PathBuf;

use lsp_server::ErrorCode;
use lsp_types::notification::{
    DidChangeTextDocument, DidChangeWatchedFiles, DidChangeWorkspaceFolders, DidCloseTextDocument, DidOpenTextDocument,
    DidSaveTextDocument, Notification,
};
use serde_json::Value;

use super::client::Settings;
use super::server::Server;
use super::uri::{self, Place};
use super::work::{Answer, refused};

/// Takes in what is told; what is not known is left out.
pub(super) fn take(server: &mut Server, method: &str, params: Value) -> Answer {
    match method {
        "initialized" => server.initialized(),
        DidOpenTextDocument::METHOD => open(server, read::<DidOpenTextDocument>(params)?),
        DidChangeTextDocument::METHOD => change(server, read::<DidChangeTextDocument>(params)?)?,
        DidCloseTextDocument::METHOD => close(server, &read::<DidCloseTextDocument>(params)?.text_document.uri.to_string()),
        DidSaveTextDocument::METHOD => {
            // A client that cannot watch files says at least when it has written one.
            let place = Place::of(read::<DidSaveTextDocument>(params)?.text_document.uri.as_str());
            server.changed(place);
        }
        DidChangeWatchedFiles::METHOD => {
            for change in read::<DidChangeWatchedFiles>(params)?.changes {
                outside(server, change.uri.as_str());
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
                server.set(Settings::of(settings));
            }
        }
        _ => {}
    }
    Ok(Value::Null)
}

fn read<N: Notification>(params: Value) -> Result<N::Params, lsp_server::ResponseError> {
    serde_json::from_value(params).map_err(|error| refused(ErrorCode::InvalidParams, format!("`{}` is not understood: {error}", N::METHOD)))
}

fn open(server: &mut Server, params: lsp_types::DidOpenTextDocumentParams) {
    let lsp_types::TextDocumentItem { uri, language_id, version, text } = params.text_document;
    let columns = server.columns();
    let place = server.documents.open(uri.to_string(), language_id, version, text, columns);
    if server.documents.get(&place).is_some_and(|document| document.is_lossy) {
        let name = place.path().and_then(|path| path.file_name()).map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        server.show(
            2,
            &format!("`{name}` is not UTF-8: saving it would lose characters. Reopen it with its encoding, for example Windows 1252."),
        );
    }
    server.changed(place);
}

fn change(server: &mut Server, params: lsp_types::DidChangeTextDocumentParams) -> Result<(), lsp_server::ResponseError> {
    let uri = params.text_document.uri.to_string();
    let columns = server.columns();
    let changed = server.documents.change(&uri, params.text_document.version, params.content_changes, columns);
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
