//! What a user sees when we made a mistake.

use std::cell::{Cell, RefCell};
use std::panic::{self, AssertUnwindSafe};

use crate::failure::Exit;
use crate::{output, terminal};

thread_local! {
    /// Whether a mistake in this thread is survived: see [`survive`].
    static SURVIVES: Cell<bool> = const { Cell::new(false) };
    /// The mistake that was survived last, and where it was made.
    static SURVIVED: RefCell<String> = const { RefCell::new(String::new()) };
}

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
        if SURVIVES.get() {
            SURVIVED.replace(format!("{what}{place}"));
            return;
        }
        // The message belongs to the screen that the user came from.
        terminal::give_back();
        output::message(&format!(
            "\nThis is our mistake, not yours: Sieben {} broke an assumption of its own{place}:\n  {what}\n\
             Please report it with the command and the files that led here. `RUST_BACKTRACE=1` shows more.\n",
            env!("CARGO_PKG_VERSION"),
        ));
        // The process ends here in any thread.
        std::process::exit(Exit::Internal as i32);
    }));
}

/// Does work that the user can do without, such as making a program faster: a mistake of ours in it ends the work, not the process.
///
/// # Errors
/// The reason that the work gave, or what we did wrong, as the end of a sentence.
pub(crate) fn survive<T>(work: impl FnOnce() -> Result<T, String>) -> Result<T, Trouble> {
    let before = SURVIVES.replace(true);
    // What the work leaves half done is dropped with it: its callers see whole values or none.
    let done = panic::catch_unwind(AssertUnwindSafe(work));
    SURVIVES.set(before);
    match done {
        Ok(result) => result.map_err(Trouble::Refused),
        Err(_) => Err(Trouble::OurMistake(SURVIVED.take())),
    }
}

/// Why work was not done.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Trouble {
    /// It cannot be done, for this reason.
    Refused(String),
    /// We broke an assumption of our own: which, and where.
    OurMistake(String),
}

impl Trouble {
    /// The reason why bytes from outside cannot be read, as the end of a sentence: a library that did not expect them has no other word.
    #[cfg(feature = "parquet")]
    pub(crate) fn of_bytes(self) -> String {
        match self {
            Self::Refused(reason) => reason,
            Self::OurMistake(_) => "it is damaged".to_owned(),
        }
    }

    /// The reason as the end of a sentence.
    pub(crate) fn reason(self) -> String {
        match self {
            Self::Refused(reason) => reason,
            Self::OurMistake(what) => {
                format!("its machine code could not be made, which is our mistake, not yours; please report it with the program: {what}")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mistake_in_work_that_is_survived_does_not_end_the_process() {
        install();
        let mistaken: Result<(), Trouble> = survive(|| panic!("a register too many"));
        let refused: Result<(), Trouble> = survive(|| Err("it is too large".to_owned()));
        let done = survive(|| Ok(7));
        // The next test of the process may fail in the usual way.
        drop(panic::take_hook());
        let Err(Trouble::OurMistake(what)) = mistaken else { panic!("{mistaken:?}") };
        assert!(what.starts_with("a register too many") && what.contains("panics.rs"), "{what}");
        assert_eq!(refused, Err(Trouble::Refused("it is too large".to_owned())));
        assert_eq!(done, Ok(7));
        assert!(!SURVIVES.get(), "what is done later is not survived");
    }
}
