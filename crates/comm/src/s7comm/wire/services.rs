//! Jobs 28 (program invocation services) and 29 (stop): start, link, delete, copy RAM to ROM, compress, memory reset.

use super::codes::Refusal;
use crate::s7comm::job::{Job, Reply};

/// The job that the parameters of a job 28 or 29 mean, function code included.
///
/// # Errors
/// Why it is refused.
pub fn read(parameters: &[u8]) -> Result<Job, Refusal> {
    let _ = parameters;
    Err(Refusal::NotImplemented)
}

/// The parameters of the answer, and the error in its header: `29 07` and `28 03` come with one, because clients look at the second byte only then.
pub fn write(job: &Job, reply: &Reply) -> (Option<Refusal>, Vec<u8>) {
    let _ = (job, reply);
    (Some(Refusal::NotImplemented), Vec::new())
}
