//! What a client asks: one row for each method.

use lsp_server::{ErrorCode, RequestId, ResponseError};
use lsp_types::request::Request;
use serde_json::Value;

use super::server::Server;
use super::work::{Answer, refused};

/// The code of an answer that another thread gives.
pub(super) const LATER: i32 = i32::MIN;

/// Answers a request.
pub(super) fn answer(server: &mut Server, id: &RequestId, method: &str, params: Value) -> Answer {
    let _ = id;
    let _ = params;
    match method {
        _ => Err(refused(ErrorCode::MethodNotFound, format!("`{method}` is not known"))),
    }
}

/// The parameters of a method.
pub(super) fn read<R: Request>(params: Value) -> Result<R::Params, ResponseError> {
    serde_json::from_value(params).map_err(|error| refused(ErrorCode::InvalidParams, format!("`{}` is not understood: {error}", R::METHOD)))
}
