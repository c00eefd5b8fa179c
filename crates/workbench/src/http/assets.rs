//! The page itself: its files as they were built, inside of this binary.

use axum::body::Body;
use axum::http::{HeaderValue, Response, StatusCode, header};
use rust_embed::RustEmbed;
use sieben_model::problems::Problem;
use sieben_workspace::Refusal;

use super::{From, security};

/// What the build of the page has written.
#[derive(RustEmbed)]
#[folder = "dist"]
struct Files;

/// What stands in the page where the word for its scripts and styles goes.
const PLACE_OF_NONCE: &str = "__NONCE__";
/// Files in this folder have a hash in their names: they never change.
const HASHED: &str = "assets/";

/// A file of the page; `/` is the page.
pub(super) fn file(path: &str, from: &From<'_>) -> Result<Response<Body>, Refusal> {
    let name = path.trim_start_matches('/');
    let name = if name.is_empty() { "index.html" } else { name };
    let Some(file) = Files::get(name) else {
        return Err(Refusal::new(Problem::P7137, format!("there is nothing at `{path}`")));
    };
    if name == "index.html" {
        return Ok(page(&String::from_utf8_lossy(&file.data)));
    }
    let tag: String = file.metadata.sha256_hash().iter().take(16).map(|byte| format!("{byte:02x}")).collect();
    let tag = format!("\"{tag}\"");
    let known = from.headers.get(header::IF_NONE_MATCH).and_then(|value| value.to_str().ok());
    let takes_brotli =
        from.headers.get(header::ACCEPT_ENCODING).and_then(|value| value.to_str().ok()).is_some_and(|value| value.contains("br"));
    let packed = if takes_brotli { Files::get(&format!("{name}.br")) } else { None };
    let mut response = match (known == Some(tag.as_str()), &packed) {
        (true, _) => super::response(StatusCode::NOT_MODIFIED, kind(name), Body::empty()),
        (false, Some(packed)) => super::response(StatusCode::OK, kind(name), packed.data.to_vec()),
        (false, None) => super::response(StatusCode::OK, kind(name), file.data.to_vec()),
    };
    let headers = response.headers_mut();
    let caching = if name.starts_with(HASHED) { "public, max-age=31536000, immutable" } else { "no-cache" };
    headers.insert(header::CACHE_CONTROL, HeaderValue::from_static(caching));
    headers.insert(header::VARY, HeaderValue::from_static("Accept-Encoding"));
    if packed.is_some() {
        headers.insert(header::CONTENT_ENCODING, HeaderValue::from_static("br"));
    }
    if let Ok(tag) = HeaderValue::from_str(&tag) {
        headers.insert(header::ETAG, tag);
    }
    Ok(response)
}

/// A page of HTML, with a word of its own for its scripts and styles.
pub(super) fn page(text: &str) -> Response<Body> {
    let nonce = security::nonce();
    let mut response = super::response(StatusCode::OK, "text/html; charset=utf-8", text.replace(PLACE_OF_NONCE, &nonce));
    if let Ok(policy) = HeaderValue::from_str(&security::policy(&nonce)) {
        response.headers_mut().insert(header::CONTENT_SECURITY_POLICY, policy);
    }
    response
}

/// What a file is, by its name.
pub(super) fn kind(name: &str) -> &'static str {
    const KINDS: [(&str, &str); 11] = [
        ("html", "text/html; charset=utf-8"),
        ("js", "text/javascript; charset=utf-8"),
        ("css", "text/css; charset=utf-8"),
        ("svg", "image/svg+xml"),
        ("json", "application/json"),
        ("webmanifest", "application/manifest+json"),
        ("png", "image/png"),
        ("ico", "image/x-icon"),
        ("txt", "text/plain; charset=utf-8"),
        ("csv", "text/csv; charset=utf-8"),
        ("woff2", "font/woff2"),
    ];
    let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
    KINDS.iter().find(|(known, _)| *known == ending).map_or("application/octet-stream", |(_, kind)| kind)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_is_embedded() {
        let page = Files::get("index.html").expect("the page is embedded");
        assert!(String::from_utf8_lossy(&page.data).contains("<title>Sieben</title>"));
    }

    #[test]
    fn every_page_has_a_word_of_its_own() {
        let policy = || {
            let response = page("<script nonce=\"__NONCE__\"></script>");
            response.headers().get(header::CONTENT_SECURITY_POLICY).and_then(|value| value.to_str().ok()).map(str::to_owned)
        };
        let (one, other) = (policy().expect("a policy"), policy().expect("a policy"));
        assert!(one.contains("default-src 'none'") && one.contains("frame-ancestors 'none'"));
        assert_ne!(one, other);
    }
}
