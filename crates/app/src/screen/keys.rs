//! What keys mean, and what takes them: the screen, or what lies over it.

use std::io;

use ratatui::crossterm::event::KeyCode;

use super::asks::Asks;
use super::look::Look;
use super::state::{Command, Over, Screen, Then};
use crate::terminal::Key;

/// Rows that a page of a list has.
const PAGE: usize = 10;

/// What a key means where nothing lies over the screen.
pub(crate) fn command(key: Key) -> Option<Command> {
    Some(match key {
        Key::Leave | Key::Plain(KeyCode::Esc) => Command::Quit,
        Key::Plain(KeyCode::Up) => Command::Up,
        Key::Plain(KeyCode::Down) => Command::Down,
        Key::Plain(KeyCode::Left) => Command::Left,
        Key::Plain(KeyCode::Right) => Command::Right,
        Key::Plain(KeyCode::Enter) => Command::Press,
        Key::Plain(KeyCode::PageUp) => Command::PageUp,
        Key::Plain(KeyCode::PageDown) => Command::PageDown,
        Key::Plain(KeyCode::Tab) => Command::Part,
        Key::Plain(KeyCode::Char(character)) => match character.to_ascii_lowercase() {
            'q' => Command::Quit,
            ' ' => Command::Toggle,
            '1'..='9' => Command::Digit(character.to_digit(10)? as usize),
            'e' => Command::Set,
            'x' => Command::Format,
            'r' => Command::Run,
            's' => Command::Stop,
            'm' => Command::MemoryReset,
            'p' => Command::Pause,
            'g' => Command::Go,
            'n' => Command::OneScan,
            '+' | '=' => Command::Faster,
            '-' => Command::Slower,
            'f' => Command::Faults,
            'b' => Command::Block,
            'o' => Command::Plant,
            'a' => Command::Auto,
            '?' | 'h' => Command::Help,
            _ => return None,
        },
        Key::Plain(_) => return None,
    })
}

impl Screen {
    /// Takes a key.
    ///
    /// # Errors
    /// The run is over, or does not answer.
    pub(crate) fn key(&mut self, key: Key, look: &Look, asks: &mut dyn Asks) -> io::Result<Then> {
        if key == Key::Leave {
            return Ok(Then::Leave);
        }
        match std::mem::take(&mut self.over) {
            Over::Nothing => match command(key) {
                Some(command) => return self.act(command, look, asks),
                None => return Ok(Then::On),
            },
            Over::Help => {}
            Over::MemoryReset => {
                if matches!(key, Key::Plain(KeyCode::Char('y' | 'Y' | 'j' | 'J'))) {
                    self.reset(asks)?;
                }
            }
            Over::Menu(mut menu) => match key {
                Key::Plain(KeyCode::Esc | KeyCode::Char('q')) => {}
                Key::Plain(KeyCode::Enter) => self.choose(&menu, asks)?,
                key => {
                    let last = menu.rows.len().saturating_sub(1);
                    menu.at = match key {
                        Key::Plain(KeyCode::Up) => menu.at.saturating_sub(1),
                        Key::Plain(KeyCode::Down) => (menu.at + 1).min(last),
                        Key::Plain(KeyCode::PageUp) => menu.at.saturating_sub(PAGE),
                        Key::Plain(KeyCode::PageDown) => (menu.at + PAGE).min(last),
                        Key::Plain(KeyCode::Home) => 0,
                        Key::Plain(KeyCode::End) => last,
                        _ => menu.at,
                    };
                    self.over = Over::Menu(menu);
                }
            },
            Over::Prompt { row, mut typed } => match key {
                Key::Plain(KeyCode::Esc) => self.said = None,
                Key::Plain(KeyCode::Enter) => {
                    self.said = None;
                    self.enter(row, typed, look, asks)?;
                }
                key => {
                    match key {
                        Key::Plain(KeyCode::Backspace) => drop(typed.pop()),
                        Key::Plain(KeyCode::Char(character)) => Self::type_in(&mut typed, character),
                        _ => {}
                    }
                    self.over = Over::Prompt { row, typed };
                }
            },
        }
        Ok(Then::On)
    }
}
