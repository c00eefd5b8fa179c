//! The microscope on the terminal: the source, the registers, the reason, and keys for every step there and back.

mod draw;
mod keys;
mod picture;
#[cfg(test)]
mod tests;
mod words;

use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use ratatui::DefaultTerminal;
use ratatui::crossterm::event::{self, Event};

use super::{Language, Stepper};
use picture::Screen;

/// How long a key is waited for before it is looked whether the program is to end.
const WAIT: Duration = Duration::from_millis(100);

/// Takes over the terminal until the user quits or `interrupted` is set.
///
/// # Errors
/// The terminal does not work. It is restored in any case, also if we panic.
pub(crate) fn run(stepper: &mut Stepper<'_>, language: Language, colour: bool, interrupted: &AtomicBool) -> io::Result<()> {
    let mut terminal = ratatui::try_init()?;
    let screen = Screen::new(stepper, language, colour);
    let result = play(&mut terminal, stepper, screen, interrupted);
    ratatui::restore();
    result
}

fn play(terminal: &mut DefaultTerminal, stepper: &mut Stepper<'_>, mut screen: Screen, interrupted: &AtomicBool) -> io::Result<()> {
    loop {
        let picture = screen.picture(stepper);
        terminal.draw(|frame| draw::draw(frame, &picture))?;
        let rows = draw::source_rows(terminal.size()?.height);
        // The picture only changes with a key: nothing runs by itself.
        loop {
            if interrupted.load(Ordering::Relaxed) {
                return Ok(());
            }
            if !event::poll(WAIT)? {
                continue;
            }
            match event::read()? {
                Event::Key(key) => {
                    let Some(command) = keys::command(key, screen.is_typing()) else { continue };
                    if screen.act(stepper, command, rows) {
                        return Ok(());
                    }
                    break;
                }
                Event::Resize(..) => break,
                _ => {}
            }
        }
    }
}
