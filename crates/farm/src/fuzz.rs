//! The messages of a farm as a target of the fuzzer.

use crate::message::{Job, Outcome, State, read_alive, read_description};
use crate::names::Names;

/// Reads the input as every message that there is; what is read is written and read once more.
pub fn fuzz(data: &[u8]) {
    if let Some(job) = Job::read(data) {
        assert_eq!(job.to_string().as_bytes(), data, "a job has one form");
        if let Some([first, second]) = job.halves() {
            assert!(first.range.end == second.range.start && !first.range.is_empty() && !second.range.is_empty(), "two halves");
        }
    }
    if let Some(outcome) = Outcome::read(data) {
        assert_eq!(Outcome::read(&outcome.write()), Some(outcome), "a result stays what it is");
    }
    if let Some(state) = State::read(data) {
        assert_eq!(State::read(state.to_string().as_bytes()), Some(state), "a state stays what it is");
    }
    read_alive(data);
    let text = String::from_utf8_lossy(data);
    read_description(&text);
    if let Some(names) = Names::of_stream(&text) {
        assert_eq!(names.jobs, text, "a stream names its campaign");
    }
}
