//! Editor services as plain data (none yet).
#![forbid(unsafe_code)]
