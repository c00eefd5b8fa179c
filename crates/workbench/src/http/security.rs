//! What each answer says to the browser about what it may do with it.

use axum::body::Body;
use axum::http::{HeaderName, HeaderValue, Response, header};
use rustix::rand::{GetRandomFlags, getrandom};

/// For what is no page: nothing is loaded, and no page frames it.
const NOTHING: &str = "default-src 'none'; frame-ancestors 'none'; base-uri 'none'; form-action 'none'";

/// Adds the headers that every answer has.
pub(super) fn protect(response: &mut Response<Body>) {
    let headers = response.headers_mut();
    let mut add = |name: HeaderName, value: &'static str| {
        headers.entry(name).or_insert(HeaderValue::from_static(value));
    };
    add(header::CONTENT_SECURITY_POLICY, NOTHING);
    add(header::X_CONTENT_TYPE_OPTIONS, "nosniff");
    add(header::REFERRER_POLICY, "no-referrer");
    add(header::X_FRAME_OPTIONS, "DENY");
    add(HeaderName::from_static("cross-origin-resource-policy"), "same-origin");
    add(HeaderName::from_static("cross-origin-opener-policy"), "same-origin");
    add(header::CACHE_CONTROL, "no-store");
}

/// What a page may load: only from this server, and styles and scripts in it only with this word.
pub(super) fn policy(nonce: &str) -> String {
    format!(
        "default-src 'none'; script-src 'self' 'nonce-{nonce}'; style-src 'self' 'nonce-{nonce}'; img-src 'self' data:; font-src 'self'; \
         connect-src 'self'; manifest-src 'self'; frame-ancestors 'none'; base-uri 'none'; form-action 'none'"
    )
}

/// A word that nothing else knows: 128 bits as hexadecimal digits.
pub(super) fn nonce() -> String {
    let mut bytes = [0_u8; 16];
    // It fails only before the system has collected any chance, and then the page shows without styles.
    let _ = getrandom(&mut bytes, GetRandomFlags::empty());
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
