//! The demo live: keys in, pictures out, while another thread scans.

use std::io;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use ratatui::DefaultTerminal;
use ratatui::crossterm::event::KeyCode;
use sieben_sim::devices::dosing::Button;
use sieben_workspace::{Closed, Speed};

use super::draw;
use super::operator::Action;
use super::picture::Viewer;
use super::session::Session;
use crate::palette::Palette;
use crate::terminal::{self, Input, Key};

/// Time between two pictures.
const FRAME: Duration = Duration::from_millis(33);

/// What a key means.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Command {
    Quit,
    Act(Action),
    Pause,
    OneScan,
    Faster,
    Slower,
}

/// Ends the scans when it goes, however the screen was left.
struct Ending<'s>(&'s Session);

impl Drop for Ending<'_> {
    fn drop(&mut self) {
        self.0.end();
    }
}

/// Takes over the terminal until the user quits, the demo is over or the terminal goes. The scans end with it.
///
/// # Errors
/// The terminal does not work. It is restored in any case, also if we panic.
pub(crate) fn run(session: &Session, palette: Palette) -> io::Result<()> {
    let mut display = ratatui::try_init()?;
    let result = thread::scope(|scope| {
        let _ending = Ending(session);
        thread::Builder::new().name("scan".to_owned()).spawn_scoped(scope, || session.scan(&mut |_| {}))?;
        let (gate, desk) = (Arc::clone(&session.gate), Arc::clone(&session.desk));
        // It ends by itself when the gate is closed.
        thread::Builder::new().name("status".to_owned()).spawn(move || desk.replay(|| gate.is_closed()))?;
        play(&mut display, session, palette)
    });
    terminal::restore(display);
    result
}

fn play(display: &mut DefaultTerminal, session: &Session, palette: Palette) -> io::Result<()> {
    let mut viewer = Viewer::new(session);
    loop {
        let began = Instant::now();
        let Ok(picture) = viewer.picture(usize::from(display.size()?.height)) else { return Ok(()) };
        display.draw(|frame| draw::draw(frame, &picture, palette))?;
        let mut wait = FRAME.saturating_sub(began.elapsed());
        loop {
            let key = match terminal::input(wait)? {
                Input::Gone => return Ok(()),
                Input::Nothing | Input::Resized => break,
                Input::Key(key) => key,
            };
            wait = Duration::ZERO;
            let Some(command) = command(key) else { continue };
            if command == Command::Quit || carry_out(session, command).is_err() {
                return Ok(());
            }
        }
    }
}

/// Does what a key means.
fn carry_out(session: &Session, command: Command) -> Result<(), Closed> {
    let gate = &session.gate;
    match command {
        Command::Quit => Ok(()),
        Command::Act(action) => session.act(action),
        // The scan after which time stands still is the one whose status is shown.
        Command::Pause => gate.command(|plant| match plant.pace.is_paused() {
            true => plant.pace.go(gate.now_us()),
            false => plant.pace.step(1, gate.now_us()),
        }),
        Command::OneScan => gate.command(|plant| plant.pace.step(1, gate.now_us())),
        Command::Faster | Command::Slower => gate.command(|plant| {
            let now = plant.pace.speed();
            let next = if command == Command::Faster { now.faster() } else { now.slower() };
            // As fast as it goes is too fast to look at.
            if next != Speed::Max {
                plant.pace.set_speed(next, gate.now_us());
            }
        }),
    }
}

fn command(key: Key) -> Option<Command> {
    match key {
        Key::Leave | Key::Plain(KeyCode::Esc) => Some(Command::Quit),
        Key::Plain(KeyCode::Char(character)) => match character.to_ascii_lowercase() {
            'q' => Some(Command::Quit),
            's' => Some(Command::Act(Action::Push(Button::Start))),
            'x' => Some(Command::Act(Action::Push(Button::Stop))),
            '0' => Some(Command::Act(Action::Hold(Button::Start))),
            '1' => Some(Command::Act(Action::Hold(Button::Stop))),
            'f' | '7' => Some(Command::Act(Action::Meter)),
            'm' => Some(Command::Act(Action::Mode)),
            'a' => Some(Command::Act(Action::Story)),
            'p' | ' ' => Some(Command::Pause),
            'n' => Some(Command::OneScan),
            '+' | '=' => Some(Command::Faster),
            '-' => Some(Command::Slower),
            _ => None,
        },
        Key::Plain(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_way_to_leave_is_known() {
        for key in [Key::Leave, Key::Plain(KeyCode::Esc), Key::Plain(KeyCode::Char('q')), Key::Plain(KeyCode::Char('Q'))] {
            assert_eq!(command(key), Some(Command::Quit));
        }
        assert_eq!(command(Key::Plain(KeyCode::Enter)), None);
    }

    #[test]
    fn keys_come_in_through_the_gate() {
        let session = Session::in_steps();
        let press = |letter| {
            let command = command(Key::Plain(KeyCode::Char(letter))).expect("a key of the demo");
            carry_out(&session, command).expect("the gate is open");
        };
        let pace = || session.gate.enter(|plant| plant.pace.clone()).expect("the gate is open");
        press('n');
        assert_eq!(pace().steps_left(), 1);
        press('p');
        assert!(!pace().is_paused());
        press('p');
        assert!(pace().is_paused() && pace().steps_left() == 1, "one scan more, whose status is recorded");
        (0..20).for_each(|_| press('+'));
        assert_eq!(pace().speed(), Speed::Factor(100.0));
        (0..20).for_each(|_| press('-'));
        assert_eq!(pace().speed(), Speed::Factor(0.1));
        session.gate.enter(|plant| plant.pace.set_speed(Speed::Max, 0)).expect("the gate is open");
        press('+');
        assert_eq!(pace().speed(), Speed::Max, "set from outside");
        press('-');
        assert_eq!(pace().speed(), Speed::Factor(100.0));
    }
}
