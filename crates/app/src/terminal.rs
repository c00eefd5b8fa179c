//! The terminal as a screen: whether there is one, and Ctrl-C while it is drawn on.

use std::io::{self, IsTerminal};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use sieben_model::problems::Problem;

use crate::failure::Failure;

/// Whether someone sits at a terminal that can be drawn on.
pub(crate) fn has_screen() -> bool {
    let capable = std::env::var_os("TERM").is_none_or(|term| term != "dumb");
    io::stdout().is_terminal() && io::stdin().is_terminal() && capable
}

/// Becomes true when someone presses Ctrl-C.
pub(crate) fn interrupted() -> Arc<AtomicBool> {
    let interrupted = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&interrupted);
    // Without a handler Ctrl-C still ends the program, only less tidily.
    let _ = ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed));
    interrupted
}

/// A terminal that does not do what it is asked for.
pub(crate) fn broken(error: &io::Error) -> Failure {
    Failure::usage(Problem::P6013, format!("the terminal does not work: {error}"))
}
