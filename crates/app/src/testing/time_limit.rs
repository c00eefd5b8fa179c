//! The real time of a test also ends what a CPU does inside one scan, such as a day of cyclic interrupts.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::time::Duration;

use sieben_cpu::StopRequest;
use sieben_workspace::testing;

/// Sends a CPU to STOP when the time is over, unless it is dropped before.
pub(super) struct TimeLimit {
    ended: Arc<AtomicBool>,
    /// The thread ends with it.
    _running: Sender<()>,
}

impl TimeLimit {
    /// From now on the CPU has so much real time. Without a thread it has as much as its next scan takes.
    pub(super) fn start(request: StopRequest, timeout: Duration) -> Self {
        let (running, ended_before) = channel();
        let ended = Arc::new(AtomicBool::new(false));
        let told = Arc::clone(&ended);
        let wait = move || {
            if ended_before.recv_timeout(timeout) == Err(RecvTimeoutError::Timeout) {
                told.store(true, Ordering::Relaxed);
                request.stop();
            }
        };
        // The time is looked at between two scans, too.
        let _ = std::thread::Builder::new().name("time of a test".to_owned()).spawn(wait);
        Self { ended, _running: running }
    }
}

impl testing::TimeLimit for TimeLimit {
    fn has_ended_it(&self) -> bool {
        self.ended.load(Ordering::Relaxed)
    }
}
