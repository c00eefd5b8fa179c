//! The microscope on the terminal: the source, the registers, the reason, and keys for every step there and back.

mod draw;
mod keys;
mod picture;
#[cfg(test)]
mod tests;
mod trail;
mod used;
pub(crate) mod words;

use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use ratatui::DefaultTerminal;
use sieben_workspace::session::Session;

use crate::terminal::{self, Input};
use picture::Screen;

/// How long a key is waited for before it is looked whether the program is to end.
const WAIT: Duration = Duration::from_millis(100);

/// Takes over the terminal until the user quits, the terminal goes or `interrupted` is set.
///
/// # Errors
/// The terminal does not work. It is restored in any case, also if we panic.
pub(crate) fn run(session: &mut Session, colour: bool, interrupted: &AtomicBool) -> io::Result<()> {
    let mut display = ratatui::try_init()?;
    let screen = Screen::new(session, colour);
    let result = play(&mut display, session, screen, interrupted);
    terminal::restore(display);
    result
}

fn play(display: &mut DefaultTerminal, session: &mut Session, mut screen: Screen, interrupted: &AtomicBool) -> io::Result<()> {
    loop {
        let picture = screen.picture(session);
        display.draw(|frame| draw::draw(frame, &picture))?;
        let rows = draw::source_rows(display.size()?.height);
        // The picture only changes with a key: nothing runs by itself.
        loop {
            if interrupted.load(Ordering::Relaxed) {
                return Ok(());
            }
            match terminal::input(WAIT)? {
                Input::Gone => return Ok(()),
                Input::Key(key) => {
                    let Some(command) = keys::command(key, screen.is_typing()) else { continue };
                    if screen.act(session, command, rows) {
                        return Ok(());
                    }
                    break;
                }
                Input::Resized => break,
                Input::Nothing => {}
            }
        }
    }
}
