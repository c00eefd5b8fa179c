//! What a user sees when we made a mistake.

use std::panic;

use crate::failure::Exit;
use crate::output;

/// Replaces the panic message by one that a user can do something with, and the exit code by 70.
pub(crate) fn install() {
    let verbose = std::env::var_os("RUST_BACKTRACE").is_some_and(|value| value != "0");
    let default = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        if verbose {
            default(info);
        }
        let place = info.location().map_or_else(String::new, |location| format!(" ({}:{})", location.file(), location.line()));
        let what = info.payload_as_str().unwrap_or("no message");
        output::message(&format!(
            "\nThis is our mistake, not yours: Sieben {} broke an assumption of its own{place}:\n  {what}\n\
             Please report it with the command and the files that led here. `RUST_BACKTRACE=1` shows more.\n",
            env!("CARGO_PKG_VERSION"),
        ));
        // The terminal of the demo may still be in its own mode; the process ends here in any thread.
        std::process::exit(Exit::Internal as i32);
    }));
}
