//! Requests of the interface: which route they take, who may take it, and what is answered.

use std::net::SocketAddr;
use std::sync::Arc;

use axum::body::{Body, Bytes};
use axum::http::{HeaderValue, Method, Response, StatusCode, header};
use serde_json::Value as Json;
use sieben_lang::reason::Language;
use sieben_model::problems::Problem;
use sieben_workspace::Refusal;

use super::query::decoded;
use super::routes::{Asked, ROUTES, Reply, Route};
use super::{From, blocking, not_taken, openapi, refused, response};
use crate::access::Denied;
use crate::fnv_1a;
use crate::server::Shared;

/// Where the interface begins.
pub(super) const BASE: &str = "/api/v1/";

/// What stands in a path in the places of `{…}`; `None` if it is another path.
fn captured(pattern: &str, path: &str) -> Option<Vec<String>> {
    let mut found = Vec::new();
    let mut parts = path.split('/');
    for wanted in pattern.split('/') {
        let part = parts.next()?;
        match wanted.starts_with('{') {
            true => found.push(decoded(part).filter(|part| !part.is_empty())?),
            false if wanted == part => {}
            false => return None,
        }
    }
    parts.next().is_none().then_some(found)
}

/// Answers a request.
pub(super) async fn answer(
    shared: &Arc<Shared>,
    from: From<'_>,
    method: &Method,
    path: &str,
    body: Bytes,
) -> Result<Response<Body>, Refusal> {
    let nothing = || Refusal::new(Problem::P7137, "there is no such address; `/api/v1/openapi.json` describes all of them");
    let inside = path.strip_prefix(BASE).ok_or_else(nothing)?;
    if inside == "openapi.json" {
        return super::get(method, || Ok(response(StatusCode::OK, "application/json", openapi::document().to_string())));
    }
    let at_path: Vec<(&Route, Vec<String>)> = ROUTES.iter().filter_map(|route| Some((route, captured(route.path, inside)?))).collect();
    let takes: Vec<&str> = at_path.iter().map(|(route, _)| route.method.word()).collect();
    if takes.is_empty() {
        return Err(nothing());
    }
    let refusal = not_taken(method, &takes);
    let wanted = if *method == Method::HEAD { "GET" } else { method.as_str() };
    let (route, captured) = at_path.into_iter().find(|(route, _)| route.method.word() == wanted).ok_or(refusal)?;
    if route.role > from.role {
        return Err(refused(Denied::Role));
    }
    let body = match (route.body, body.is_empty()) {
        (Some(_), false) => {
            serde_json::from_slice::<Json>(&body).map_err(|error| Refusal::new(Problem::P7131, format!("the body is no JSON: {error}")))?
        }
        _ => Json::Null,
    };
    let spoken = from.headers.get(header::ACCEPT_LANGUAGE).and_then(|value| value.to_str().ok());
    let language = from.query.get("lang").or(spoken).map_or(Language::English, language);
    let (shared, peer, query) = (Arc::clone(shared), peer_text(from.peer), from.query);
    let reply = blocking(move || (route.answer)(&Asked { shared: &shared, captured, query, body, peer, language })).await??;
    let known = from.headers.get(header::IF_NONE_MATCH).and_then(|value| value.to_str().ok());
    Ok(match reply {
        Reply::Json(json) => tagged("application/json", json.to_string(), known),
        Reply::Text(kind, text) => tagged(kind, text, known),
        Reply::Nothing => response(StatusCode::NO_CONTENT, "application/json", Body::empty()),
    })
}

/// The peer as it stands in the log.
pub(super) fn peer_text(peer: SocketAddr) -> String {
    format!("page {peer}")
}

/// The first language of a list that we speak.
fn language(accepted: &str) -> Language {
    let codes = accepted.split(',').filter_map(|one| one.split([';', '-']).next());
    codes.filter_map(|code| Language::from_code(code.trim())).next().unwrap_or_default()
}

/// An answer with a tag: a hash of its text.
fn tagged(kind: &str, text: String, known: Option<&str>) -> Response<Body> {
    let tag = format!("\"{:016x}\"", fnv_1a(text.bytes()));
    let mut response = match known == Some(tag.as_str()) {
        true => response(StatusCode::NOT_MODIFIED, kind, Body::empty()),
        false => response(StatusCode::OK, kind, text),
    };
    response.headers_mut().insert(header::CACHE_CONTROL, HeaderValue::from_static("no-cache"));
    if let Ok(tag) = HeaderValue::from_str(&tag) {
        response.headers_mut().insert(header::ETAG, tag);
    }
    response
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_compared_part_by_part() {
        for (pattern, path, wanted) in [
            ("state", "state", Some(vec![])),
            ("blocks/{block}", "blocks/OB%201", Some(vec!["OB 1"])),
            ("blocks/{block}", "blocks", None),
            ("blocks/{block}", "blocks/", None),
            ("blocks/{block}", "blocks/OB1/more", None),
            ("forces", "forces/x", None),
        ] {
            let wanted: Option<Vec<String>> = wanted.map(|parts| parts.into_iter().map(str::to_owned).collect());
            assert_eq!(captured(pattern, path), wanted, "{pattern} {path}");
        }
    }

    #[test]
    fn a_browser_says_which_languages_it_likes() {
        for (accepted, wanted) in [
            ("de-DE,de;q=0.9,en;q=0.8", Language::German),
            ("fr,en-GB", Language::English),
            ("fr, de", Language::German),
            ("", Language::English),
        ] {
            assert_eq!(language(accepted), wanted, "{accepted}");
        }
    }
}
