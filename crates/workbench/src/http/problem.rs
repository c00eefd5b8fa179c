//! What went wrong, as a problem of RFC 9457 with the code of the product.

use axum::body::Body;
use axum::http::{HeaderValue, Response, StatusCode, header};
use serde_json::{Value as Json, json};
use sieben_model::problems::Problem;
use sieben_workspace::Refusal;

/// The status for a problem.
pub(super) fn status(problem: Problem) -> StatusCode {
    match problem {
        Problem::P7132 => StatusCode::UNAUTHORIZED,
        Problem::P7133 | Problem::P7134 => StatusCode::FORBIDDEN,
        Problem::P7135 => StatusCode::MISDIRECTED_REQUEST,
        Problem::P7136 => StatusCode::TOO_MANY_REQUESTS,
        Problem::P7138 => StatusCode::METHOD_NOT_ALLOWED,
        Problem::P7003 | Problem::P7095 | Problem::P7137 | Problem::P7139 | Problem::P7147 => StatusCode::NOT_FOUND,
        Problem::P7093 | Problem::P7145 => StatusCode::CONFLICT,
        Problem::P7092 | Problem::P7130 => StatusCode::PAYLOAD_TOO_LARGE,
        Problem::P7094 => StatusCode::SERVICE_UNAVAILABLE,
        Problem::P7004 | Problem::P7125 | Problem::P7126 | Problem::P7146 | Problem::P6272 => StatusCode::UNPROCESSABLE_ENTITY,
        _ => StatusCode::BAD_REQUEST,
    }
}

/// A problem as JSON.
pub(super) fn json(refusal: &Refusal) -> Json {
    let code = refusal.problem.code();
    json!({
        "type": format!("/docs/problems/{code}"), "title": refusal.problem.title(), "status": status(refusal.problem).as_u16(),
        "code": code, "detail": refusal.message, "help": refusal.shown_help(),
    })
}

/// The answer.
pub(super) fn response(refusal: &Refusal) -> Response<Body> {
    let status = status(refusal.problem);
    let mut response = super::response(status, "application/problem+json", json(refusal).to_string());
    let headers = response.headers_mut();
    match status {
        StatusCode::UNAUTHORIZED => drop(headers.insert(header::WWW_AUTHENTICATE, HeaderValue::from_static("Bearer"))),
        StatusCode::TOO_MANY_REQUESTS => drop(headers.insert(header::RETRY_AFTER, HeaderValue::from_static("1"))),
        _ => {}
    }
    response
}
