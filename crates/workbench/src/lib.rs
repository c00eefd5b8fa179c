//! The web page (not built yet).
#![forbid(unsafe_code)]
