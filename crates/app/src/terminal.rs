//! The terminal as a screen: whether there is one, what comes from it, its end, and Ctrl-C while it is drawn on.

use std::io::{self, IsTerminal};
use std::num::NonZero;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use ratatui::backend::CrosstermBackend;
use ratatui::crossterm::cursor::Show;
use ratatui::crossterm::event::{Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
use ratatui::crossterm::terminal::{self, Clear, ClearType, EnterAlternateScreen, LeaveAlternateScreen};
use ratatui::crossterm::{event, execute};
use ratatui::{DefaultTerminal, Terminal};
#[cfg(unix)]
use rustix::event::PollFlags;
use sieben_model::problems::Problem;

use crate::failure::Failure;
use crate::output;

/// How long the end of the terminal is waited for at a time.
#[cfg(unix)]
const WATCHED: Duration = Duration::from_secs(3_600);
/// How long a screen has to end by itself when its terminal has gone.
#[cfg(unix)]
const GONE_MAX: Duration = Duration::from_secs(3);
/// The exit code of a program whose terminal does not work.
#[cfg(unix)]
const NO_TERMINAL: i32 = 2;

/// Whether input and output are a terminal that can be drawn on.
pub(crate) fn has_screen() -> bool {
    io::stdout().is_terminal() && io::stdin().is_terminal() && is_capable()
}

/// Whether a terminal that is there can be drawn on: `TERM` says what it understands, and on Unix one without it is not known to understand anything.
fn is_capable() -> bool {
    match std::env::var_os("TERM") {
        Some(term) => !term.is_empty() && term != "dumb",
        None => cfg!(not(unix)),
    }
}

/// Whether results go to a terminal that cannot be drawn on.
pub(crate) fn is_without_screen() -> bool {
    io::stdout().is_terminal() && io::stdin().is_terminal() && !is_capable()
}

/// A screen has the terminal.
static IS_TAKEN: AtomicBool = AtomicBool::new(false);

/// Takes over the terminal for a screen; messages wait from now on.
///
/// # Errors
/// The terminal does not work; it is as it was.
pub(crate) fn take() -> io::Result<DefaultTerminal> {
    terminal::enable_raw_mode()?;
    IS_TAKEN.store(true, Ordering::SeqCst);
    output::hold();
    // Not every terminal has an empty second screen.
    let entered = execute!(io::stdout(), EnterAlternateScreen, Clear(ClearType::All));
    let display = entered.and_then(|()| Terminal::new(CrosstermBackend::new(io::stdout())));
    match display.is_err() {
        true => give_back(),
        false => end_after_terminal(),
    }
    display
}

/// Ends the program if it does not notice by itself that its terminal has gone: one that goes between our look and that of crossterm is read
/// from without end.
#[cfg(unix)]
fn end_after_terminal() {
    let watch = || {
        while !has_gone_or(PollFlags::empty(), WATCHED) {}
        std::thread::sleep(GONE_MAX);
        if IS_TAKEN.load(Ordering::SeqCst) {
            std::process::exit(NO_TERMINAL);
        }
    };
    // Without the thread all else goes on.
    let _ = std::thread::Builder::new().name("terminal".to_owned()).spawn(watch);
}

/// Only Unix has terminals that go.
#[cfg(not(unix))]
fn end_after_terminal() {}

/// Gives the terminal back if a screen has it: before a message about our own mistake. It may be called from any thread, and more than once.
pub(crate) fn give_back() {
    if IS_TAKEN.swap(false, Ordering::SeqCst) {
        // A terminal that has gone takes nothing back.
        let _ = terminal::disable_raw_mode();
        let _ = execute!(io::stdout(), LeaveAlternateScreen, Show);
    }
    output::release();
}

/// Whether results go to a terminal, and not into a file or another program.
pub(crate) fn shows_results() -> bool {
    io::stdout().is_terminal()
}

/// Becomes true when Ctrl-C is pressed.
pub(crate) fn interrupted() -> Arc<AtomicBool> {
    let interrupted = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&interrupted);
    on_interrupt(move || flag.store(true, Ordering::Relaxed));
    interrupted
}

/// As many threads as are asked for, else one for each processor.
pub(crate) fn threads(asked: Option<NonZero<usize>>) -> NonZero<usize> {
    asked.or_else(|| std::thread::available_parallelism().ok()).unwrap_or(NonZero::<usize>::MIN)
}

/// Does something when Ctrl-C is pressed.
pub(crate) fn on_interrupt(act: impl FnMut() + Send + 'static) {
    // Without a handler Ctrl-C still ends the program, only less tidily.
    let _ = ctrlc::set_handler(act);
}

/// What came from a terminal.
#[derive(Debug)]
pub(crate) enum Input {
    /// A key was pressed.
    Key(Key),
    /// The terminal has a new size.
    Resized,
    /// Nothing within the time, or nothing that means anything to a screen.
    Nothing,
    /// The terminal itself has gone: its window was closed, the connection broke.
    Gone,
}

/// A key that was pressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Key {
    /// Ctrl-C or Ctrl-D, which leave every screen.
    Leave,
    /// A key without Ctrl.
    Plain(KeyCode),
}

impl Key {
    /// The key of an event; `None` for one that is released, and for Ctrl with any other key.
    fn of(event: KeyEvent) -> Option<Self> {
        match (event.kind, event.code) {
            (KeyEventKind::Release, _) => None,
            (_, KeyCode::Char('c' | 'd')) if event.modifiers.contains(KeyModifiers::CONTROL) => Some(Self::Leave),
            _ if event.modifiers.contains(KeyModifiers::CONTROL) => None,
            (_, code) => Some(Self::Plain(code)),
        }
    }
}

/// Waits for the next thing from the terminal, so long at most.
///
/// # Errors
/// The terminal does not work.
pub(crate) fn input(wait: Duration) -> io::Result<Input> {
    // Reading from a terminal that has gone fails at once, which crossterm answers by reading again, without end.
    if has_gone(Duration::ZERO) {
        return Ok(Input::Gone);
    }
    if !event::poll(Duration::ZERO)? {
        if has_gone(wait) {
            return Ok(Input::Gone);
        }
        // Where only crossterm can wait, the time has not passed yet.
        if !event::poll(if cfg!(unix) { Duration::ZERO } else { wait })? {
            return Ok(Input::Nothing);
        }
    }
    Ok(match event::read()? {
        Event::Key(key) => Key::of(key).map_or(Input::Nothing, Input::Key),
        Event::Resize(..) => Input::Resized,
        _ => Input::Nothing,
    })
}

/// Gives the terminal back as it was. One that has gone takes nothing back, not even the complaint about that, which would panic.
pub(crate) fn restore(mut display: DefaultTerminal) {
    let cursor = display.show_cursor();
    IS_TAKEN.store(false, Ordering::SeqCst);
    if ratatui::try_restore().and(cursor).is_err() {
        std::mem::forget(display);
    }
    output::release();
}

/// Waits until something can be read, so long at most; whether the terminal has gone.
#[cfg(unix)]
fn has_gone(wait: Duration) -> bool {
    has_gone_or(PollFlags::IN, wait)
}

/// Waits until the terminal has gone or one of these has come, so long at most; whether it has gone.
#[cfg(unix)]
fn has_gone_or(others: PollFlags, wait: Duration) -> bool {
    use rustix::event::{PollFd, Timespec, poll};
    let stdin = io::stdin();
    let mut waiting = [PollFd::new(&stdin, others)];
    let wait = Timespec { tv_sec: wait.as_secs().cast_signed(), tv_nsec: wait.subsec_nanos().into() };
    // A signal, such as that of a new size, ends the waiting.
    let _ = poll(&mut waiting, Some(&wait));
    waiting[0].revents().intersects(PollFlags::HUP | PollFlags::ERR | PollFlags::NVAL)
}

/// Whether the terminal has gone: only Unix has terminals that do.
#[cfg(not(unix))]
fn has_gone(_wait: Duration) -> bool {
    false
}

/// A terminal that does not do what it is asked for.
pub(crate) fn broken(error: &io::Error) -> Failure {
    Failure::usage(Problem::P6013, format!("the terminal does not work: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_counts_once_and_control_only_leaves() {
        let key = |code, modifiers, kind| Key::of(KeyEvent::new_with_kind(code, modifiers, kind));
        let (plain, control) = (KeyModifiers::NONE, KeyModifiers::CONTROL);
        assert_eq!(key(KeyCode::Char('s'), plain, KeyEventKind::Press), Some(Key::Plain(KeyCode::Char('s'))));
        assert_eq!(key(KeyCode::Char('S'), KeyModifiers::SHIFT, KeyEventKind::Repeat), Some(Key::Plain(KeyCode::Char('S'))));
        assert_eq!(key(KeyCode::Char('s'), plain, KeyEventKind::Release), None);
        for letter in ['c', 'd'] {
            assert_eq!(key(KeyCode::Char(letter), control, KeyEventKind::Press), Some(Key::Leave));
            assert_eq!(key(KeyCode::Char(letter), control, KeyEventKind::Release), None);
        }
        assert_eq!(key(KeyCode::Char('s'), control, KeyEventKind::Press), None);
        assert_eq!(key(KeyCode::Left, control, KeyEventKind::Press), None);
    }
}
