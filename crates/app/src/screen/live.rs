//! The demo live: keys in, pictures out, time from the computer's clock.

use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use ratatui::DefaultTerminal;
use ratatui::crossterm::event::{Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
use sieben_sim::devices::dosing::Button;

use super::draw::{self, View};
use super::session::{Action, CYCLE_US, Session};
use crate::palette::Palette;
use crate::terminal::{self, Input};

/// Time between two pictures.
const FRAME: Duration = Duration::from_millis(33);
/// Scans between two pictures; a computer that does not keep up lets the plant go slower instead of hanging.
const SCANS_PER_FRAME: u64 = 5_000;
/// Longest work on scans between two pictures.
const WORK: Duration = Duration::from_millis(25);
/// The speeds that `+` and `-` step through.
const SPEEDS: [f64; 10] = [0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0];

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

/// Takes over the terminal until the user quits, the time is up, the terminal goes or `interrupted` is set.
///
/// # Errors
/// The terminal does not work. It is restored in any case, also if we panic.
pub(crate) fn run(session: &mut Session, speed: f64, time: Option<Duration>, palette: Palette, interrupted: &AtomicBool) -> io::Result<()> {
    let mut display = ratatui::try_init()?;
    let result = play(&mut display, session, speed, time, palette, interrupted);
    terminal::restore(display);
    result
}

fn play(
    display: &mut DefaultTerminal,
    session: &mut Session,
    mut speed: f64,
    time: Option<Duration>,
    palette: Palette,
    interrupted: &AtomicBool,
) -> io::Result<()> {
    speed = speed.clamp(SPEEDS[0], SPEEDS[SPEEDS.len() - 1]);
    let mut view = View { paused: false, speed: String::new(), scan_us: None, palette };
    let mut last = Instant::now();
    let mut due_us = 0.0;
    loop {
        let over = time.is_some_and(|time| u128::from(session.time_ms()) >= time.as_millis());
        if over || interrupted.load(Ordering::Relaxed) {
            return Ok(());
        }
        let now = Instant::now();
        if !view.paused {
            due_us += (now - last).as_secs_f64() * 1e6 * speed;
            due_us = scan(session, due_us, &mut view);
        }
        last = now;
        view.speed = format!("{speed}×");
        display.draw(|frame| draw::draw(frame, session, &view))?;
        let mut wait = FRAME.saturating_sub(now.elapsed());
        loop {
            let event = match terminal::input(wait)? {
                Input::Gone => return Ok(()),
                Input::Nothing => break,
                Input::Event(event) => event,
            };
            wait = Duration::ZERO;
            let Event::Key(key) = event else { continue };
            match command(key) {
                None => {}
                Some(Command::Quit) => return Ok(()),
                Some(Command::Act(action)) => session.act(action),
                Some(Command::Pause) => view.paused = !view.paused,
                Some(Command::OneScan) => {
                    view.paused = true;
                    session.scan(true);
                }
                Some(Command::Faster) => speed = SPEEDS.into_iter().find(|&next| next > speed).unwrap_or(speed),
                Some(Command::Slower) => speed = SPEEDS.into_iter().rev().find(|&next| next < speed).unwrap_or(speed),
            }
        }
    }
}

/// Runs the scans that are due and gives the time that is left over.
fn scan(session: &mut Session, due_us: f64, view: &mut View) -> f64 {
    let cycle = CYCLE_US as f64;
    let wanted = ((due_us / cycle) as u64).min(SCANS_PER_FRAME);
    let begin = Instant::now();
    for done in 0..wanted {
        let last = done + 1 == wanted || begin.elapsed() > WORK;
        session.scan(last);
        if last {
            let us = begin.elapsed().as_secs_f64() * 1e6 / (done + 1) as f64;
            // Smoothed, so that the number can be read.
            view.scan_us = Some(view.scan_us.map_or(us, |before| before * 0.9 + us * 0.1));
            break;
        }
    }
    due_us % cycle
}

fn command(key: KeyEvent) -> Option<Command> {
    if key.kind == KeyEventKind::Release {
        return None;
    }
    let control = key.modifiers.contains(KeyModifiers::CONTROL);
    match key.code {
        KeyCode::Char('c' | 'd') if control => Some(Command::Quit),
        KeyCode::Char(_) if control => None,
        KeyCode::Esc => Some(Command::Quit),
        KeyCode::Char(character) => match character.to_ascii_lowercase() {
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
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_way_to_leave_is_known() {
        for (code, modifiers) in [
            (KeyCode::Char('q'), KeyModifiers::NONE),
            (KeyCode::Char('Q'), KeyModifiers::SHIFT),
            (KeyCode::Char('c'), KeyModifiers::CONTROL),
            (KeyCode::Esc, KeyModifiers::NONE),
        ] {
            assert_eq!(command(KeyEvent::new(code, modifiers)), Some(Command::Quit));
        }
        assert_eq!(command(KeyEvent::new(KeyCode::Char('s'), KeyModifiers::CONTROL)), None);
    }

    #[test]
    fn a_picture_takes_bounded_work_at_any_speed() {
        let mut session = Session::new();
        let mut view = View { paused: false, speed: String::new(), scan_us: None, palette: Palette::Plain };
        let rest = scan(&mut session, 1e15, &mut view);
        assert!(session.scans() <= SCANS_PER_FRAME && rest < CYCLE_US as f64);
        assert!(view.scan_us.is_some());
    }
}
