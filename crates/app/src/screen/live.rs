//! The screen live: keys in, pictures out, until the user leaves or the run is over.

use std::io::{self, ErrorKind};
use std::time::{Duration, Instant};

use ratatui::DefaultTerminal;

use super::asks::Asks;
use super::draw;
use super::look::Look;
use super::state::{Screen, Then};
use crate::output;
use crate::palette::Palette;
use crate::terminal::{self, Input};

/// Time between two pictures.
const FRAME: Duration = Duration::from_millis(66);
/// How long something that was said stays.
const SAID: Duration = Duration::from_secs(6);

/// How the screen was left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Left {
    /// The user has left, or the terminal has gone.
    ByUser,
    /// The run is over.
    RunOver,
}

/// What a screen needs to know of its surroundings.
pub(crate) struct Around<'a> {
    /// Whether it has to end: Ctrl-C by a signal, or the run is over.
    pub(crate) is_over: &'a (dyn Fn() -> bool + Sync),
    /// Takes what would have been printed meanwhile.
    pub(crate) note: &'a (dyn Fn(&str) + Sync),
}

/// Takes over the terminal until the user leaves, the run is over or the terminal goes.
///
/// # Errors
/// The terminal does not work, or the run does not answer. The terminal is restored in any case, also if we panic.
pub(crate) fn show(asks: &mut dyn Asks, screen: &mut Screen, palette: Palette, around: &Around<'_>) -> io::Result<Left> {
    let mut display = terminal::take()?;
    let result = play(&mut display, asks, screen, palette, around);
    terminal::restore(display);
    match result {
        Err(error) if error.kind() == ErrorKind::UnexpectedEof => Ok(Left::RunOver),
        result => result,
    }
}

fn play(
    display: &mut DefaultTerminal,
    asks: &mut dyn Asks,
    screen: &mut Screen,
    palette: Palette,
    around: &Around<'_>,
) -> io::Result<Left> {
    let mut look = Look::default();
    let mut said_at = Instant::now();
    loop {
        let began = Instant::now();
        if (around.is_over)() {
            return Ok(Left::RunOver);
        }
        for text in output::held() {
            text.lines().filter(|line| !line.trim().is_empty()).for_each(|line| (around.note)(line.trim_end()));
        }
        let run = look.run();
        look.refresh(asks, &screen.names, &screen.formats, screen.block.as_deref())?;
        if run.is_some() && look.run() != run {
            // Another project runs: nothing that was chosen is there any more.
            screen.begin_anew();
            look = Look::default();
            continue;
        }
        if said_at.elapsed() >= SAID {
            screen.said = None;
        }
        if screen.tell_note(&look) {
            said_at = Instant::now();
        }
        display.draw(|frame| draw::draw(frame, &look, screen, palette))?;
        let mut wait = FRAME.saturating_sub(began.elapsed()).max(Duration::from_millis(5));
        loop {
            let key = match terminal::input(wait)? {
                Input::Gone => return Ok(Left::ByUser),
                Input::Nothing | Input::Resized => break,
                Input::Key(key) => key,
            };
            // The picture after a key comes at once.
            wait = Duration::ZERO;
            said_at = Instant::now();
            if screen.key(key, &look, asks)? == Then::Leave {
                return Ok(Left::ByUser);
            }
        }
    }
}
