//! Group 7 of userdata: reading and setting the clock.

use super::codes::Refusal;
use super::userdata::Content;
use crate::s7comm::job::{Job, Reply};

/// The job that a request means; `data` are the bytes after `FF 09` and the length, none if the request has no data.
///
/// # Errors
/// Why it is refused.
pub fn read(subfunction: u8, data: &[u8]) -> Result<Job, Refusal> {
    let _ = (subfunction, data);
    Err(Refusal::NotImplemented)
}

/// The data of the answer.
///
/// # Errors
/// Why the job is refused.
pub fn write(job: &Job, reply: &Reply) -> Result<Content, Refusal> {
    let _ = (job, reply);
    Err(Refusal::NotImplemented)
}
