//! The screen of `sieben top`: keys in, pictures out, until the user leaves or the run is over.

use std::io::{self, ErrorKind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use ratatui::DefaultTerminal;
use ratatui::crossterm::event::KeyCode;
use serde_json::json;
use sieben_workspace::Speed;

use super::draw;
use super::look::{Look, Onlooker};
use crate::palette::Palette;
use crate::terminal::{self, Input, Key};

/// Time between two looks.
const FRAME: Duration = Duration::from_millis(100);
/// Time between two looks at the blocks.
const BLOCKS: Duration = Duration::from_secs(2);
/// How long a message stays.
const MESSAGE: Duration = Duration::from_secs(5);
/// How the screen was left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Left {
    /// The user has left.
    ByUser,
    /// The run is over.
    RunOver,
}

/// What a key means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Command {
    Quit,
    Run,
    Stop,
    Pause,
    Go,
    OneScan,
    Faster,
    Slower,
}

/// Takes over the terminal until the user leaves, the run is over, the terminal goes or `interrupted` is set.
///
/// # Errors
/// The terminal does not work, or the run does not answer. The terminal is restored in any case.
pub(crate) fn run(onlooker: &mut Onlooker, palette: Palette, interrupted: &AtomicBool) -> io::Result<Left> {
    let mut display = ratatui::try_init()?;
    let result = play(&mut display, onlooker, palette, interrupted);
    terminal::restore(display);
    result
}

/// What was asked of the run, or that it is over.
fn answered<T>(asked: io::Result<T>) -> io::Result<Option<T>> {
    match asked {
        Ok(answer) => Ok(Some(answer)),
        Err(error) if matches!(error.kind(), ErrorKind::UnexpectedEof | ErrorKind::BrokenPipe | ErrorKind::ConnectionReset) => Ok(None),
        Err(error) => Err(error),
    }
}

fn play(display: &mut DefaultTerminal, onlooker: &mut Onlooker, palette: Palette, interrupted: &AtomicBool) -> io::Result<Left> {
    let mut blocks: Option<Instant> = None;
    let mut message: Option<(String, Instant)> = None;
    loop {
        let began = Instant::now();
        if interrupted.load(Ordering::Relaxed) {
            return Ok(Left::ByUser);
        }
        if blocks.is_none_or(|at| at.elapsed() >= BLOCKS) {
            blocks = Some(began);
            if answered(onlooker.look_at_blocks())?.is_none() {
                return Ok(Left::RunOver);
            }
        }
        let Some(look) = answered(onlooker.look())? else { return Ok(Left::RunOver) };
        message = message.filter(|(_, at)| at.elapsed() < MESSAGE);
        let shown = message.as_ref().map(|(text, _)| text.as_str());
        display.draw(|frame| draw::draw(frame, &look, palette, shown))?;
        let mut wait = FRAME.saturating_sub(began.elapsed());
        loop {
            let key = match terminal::input(wait)? {
                Input::Gone => return Ok(Left::ByUser),
                Input::Nothing | Input::Resized => break,
                Input::Key(key) => key,
            };
            // The picture after a key comes at once.
            wait = Duration::ZERO;
            match command(key) {
                None => {}
                Some(Command::Quit) => return Ok(Left::ByUser),
                Some(command) => {
                    let Some(refused) = answered(act(onlooker, command, &look))? else { return Ok(Left::RunOver) };
                    message = refused.map(|text| (text, Instant::now()));
                }
            }
        }
    }
}

/// Asks the run for what a key means; what to say if it was refused.
fn act(onlooker: &mut Onlooker, command: Command, look: &Look) -> io::Result<Option<String>> {
    let time = |word: &str| json!({ "time": word });
    match command {
        Command::Quit => Ok(None),
        Command::Run => onlooker.command("mode", &json!({ "mode": "run" })),
        Command::Stop => onlooker.command("mode", &json!({ "mode": "stop" })),
        Command::Pause => onlooker.command("time", &time("pause")),
        Command::Go => onlooker.command("time", &time("go")),
        Command::OneScan => onlooker.command("time", &time("step")),
        Command::Faster | Command::Slower => {
            let now = Speed::parse(look.word("speed")).unwrap_or(Speed::Factor(1.0));
            let next = if command == Command::Faster { now.faster() } else { now.slower() };
            onlooker.command("time", &json!({ "time": "speed", "speed": next.to_string() }))
        }
    }
}

pub(super) fn command(key: Key) -> Option<Command> {
    match key {
        Key::Leave | Key::Plain(KeyCode::Esc) => Some(Command::Quit),
        Key::Plain(KeyCode::Char(character)) => match character.to_ascii_lowercase() {
            'q' => Some(Command::Quit),
            'r' => Some(Command::Run),
            's' => Some(Command::Stop),
            'p' => Some(Command::Pause),
            'g' => Some(Command::Go),
            'n' => Some(Command::OneScan),
            '+' | '=' => Some(Command::Faster),
            '-' => Some(Command::Slower),
            _ => None,
        },
        Key::Plain(_) => None,
    }
}
