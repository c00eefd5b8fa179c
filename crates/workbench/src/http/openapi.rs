//! The description of the interface, from the table of its routes.

use serde_json::{Map, Value as Json, json};

use super::api::BASE;
use super::routes::{ROUTES, Route};

/// The description, as OpenAPI has it.
pub(super) fn document() -> Json {
    let mut paths: Map<String, Json> = Map::new();
    for route in ROUTES {
        let path = paths.entry(format!("{BASE}{}", route.path)).or_insert_with(|| json!({}));
        path[route.method.word().to_lowercase()] = operation(route);
    }
    let stream = json!({
        "summary": "What happens: the mode, programs that take over, entries of the diagnostic buffer.",
        "responses": { "200": { "description": "events", "content": { "text/event-stream": {} } }, "default": problem() },
    });
    paths.insert(format!("{BASE}events"), json!({ "get": stream }));
    let own =
        json!({ "summary": "This description.", "responses": { "200": { "description": "done", "content": { "application/json": {} } } } });
    paths.insert(format!("{BASE}openapi.json"), json!({ "get": own }));
    json!({
        "openapi": "3.1.0",
        "info": { "title": "Sieben", "version": env!("CARGO_PKG_VERSION"), "description": "A run of Sieben: its state, values and program." },
        "components": {
            "securitySchemes": { "token": { "type": "http", "scheme": "bearer" } },
            "schemas": { "Problem": {
                "type": "object", "required": ["code", "detail"],
                "properties": {
                    "type": { "type": "string" }, "title": { "type": "string" }, "status": { "type": "integer" },
                    "code": { "type": "string" }, "detail": { "type": "string" }, "help": { "type": "string" },
                },
            } },
        },
        "security": [{}, { "token": [] }],
        "paths": paths,
    })
}

fn problem() -> Json {
    json!({ "description": "a problem", "content": { "application/problem+json": { "schema": { "$ref": "#/components/schemas/Problem" } } } })
}

fn operation(route: &Route) -> Json {
    let parts = route.path.split('/').filter_map(|part| part.strip_prefix('{')?.strip_suffix('}'));
    let in_path = parts.map(|name| json!({ "name": name, "in": "path", "required": true, "schema": { "type": "string" } }));
    let in_query = route
        .query
        .iter()
        .map(|parameter| json!({ "name": parameter.name, "in": "query", "description": parameter.about, "schema": { "type": "string" } }));
    let mut operation = json!({
        "summary": route.about,
        "x-role": route.role.word(),
        "parameters": in_path.chain(in_query).collect::<Vec<_>>(),
        "responses": { "200": { "description": "done", "content": { "application/json": {} } }, "default": problem() },
    });
    if let Some(example) = route.body {
        let example: Json = serde_json::from_str(example).unwrap_or_default();
        operation["requestBody"] =
            json!({ "required": true, "content": { "application/json": { "schema": { "type": "object" }, "example": example } } });
    }
    operation
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_route_is_described_once_and_every_example_is_json() {
        let document = document();
        for route in ROUTES {
            let path = format!("{BASE}{}", route.path);
            let operation = &document["paths"][&path][route.method.word().to_lowercase()];
            assert_eq!(operation["summary"], route.about, "{} {path}", route.method.word());
            if route.body.is_some() {
                assert!(operation["requestBody"]["content"]["application/json"]["example"].is_object(), "{path}");
            }
        }
        let described: usize = document["paths"].as_object().expect("paths").values().filter_map(Json::as_object).map(Map::len).sum();
        assert_eq!(described, ROUTES.len() + 2, "no two routes are the same");
    }

    #[test]
    fn whatever_changes_something_is_not_for_looking() {
        for route in ROUTES {
            assert_eq!(route.role == crate::access::Role::View, route.method == crate::http::routes::Method::Get, "{}", route.path);
        }
    }
}
