//! The process that started the server: without it the server ends, too.

use std::sync::mpsc::SyncSender;
use std::thread;
use std::time::Duration;

use rustix::process::{Pid, test_kill_process};

use super::transport::Event;

/// How often it is looked at.
const LOOK_PERIOD: Duration = Duration::from_secs(3);

/// Starts the thread that looks; the server learns of the end as if the input had ended.
pub(super) fn watch(process: u32, events: SyncSender<Event>) {
    let Some(pid) = i32::try_from(process).ok().and_then(Pid::from_raw) else { return };
    let look = move || {
        // A process of another user may not be asked, but is there.
        while test_kill_process(pid) != Err(rustix::io::Errno::SRCH) {
            thread::sleep(LOOK_PERIOD);
        }
        let _ = events.send(Event::Gone(None));
    };
    // Without the thread the end of the input is what is left.
    let _ = thread::Builder::new().name("parent".to_owned()).spawn(look);
}
