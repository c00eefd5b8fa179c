//! How long a farm waits for what.

use std::time::Duration;

/// How long a farm waits for what; the default is for machines of one's own in a network of one's own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// How long a worker may be silent before the range that it holds goes to another one.
    pub lease: Duration,
    /// After how long without a result what is missing is sent once more.
    pub sweep: Duration,
    /// How long a run or worker waits for a server that is away.
    pub patience: Duration,
    /// How long a run tries to reach a server that was never there.
    pub arrival: Duration,
    /// How often a run and its workers say that they are alive.
    pub beat: Duration,
    /// Most ranges that the queue of the server holds.
    pub queue: u64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            lease: Duration::from_secs(30),
            sweep: Duration::from_secs(60),
            patience: Duration::from_secs(600),
            arrival: Duration::from_secs(5),
            beat: Duration::from_secs(1),
            queue: 100_000,
        }
    }
}
