//! What the keys of the microscope mean.

use ratatui::crossterm::event::KeyCode;
use sieben_workspace::session::{Direction, Unit};

use crate::terminal::Key;

/// What a key means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Command {
    /// Leaves the microscope.
    Quit,
    /// One step.
    Step(Unit, Direction),
    /// To a breakpoint.
    Run(Direction),
    /// To the line of the cursor.
    ToCursor,
    /// A breakpoint in the source, a bit among the bits.
    Toggle,
    /// Moves the cursor by lines.
    Lines(i32),
    /// Moves the cursor by pages.
    Pages(i32),
    /// Moves the cursor among the bits of a byte.
    Bits(i32),
    /// Goes between source and bits.
    Focus,
    /// Shows the variables of the block, or the bits.
    Variables,
    /// Shows the network as a diagram, or hides it.
    Diagram,
    /// Shows accumulators and address registers bit by bit, or hides that.
    RegisterBits,
    /// English or German.
    Language,
    /// Shows all keys, or hides them.
    Help,
    /// Begins a command line, with these words.
    Prompt(&'static str),
    /// A character of the command line.
    Type(char),
    /// Deletes the last one.
    Erase,
    /// Carries the command line out.
    Enter,
    /// Leaves the command line.
    Cancel,
}

/// The command of a key; `typing` while a command line is open.
pub(super) fn command(key: Key, typing: bool) -> Option<Command> {
    use Direction::{Back, Forward};
    let code = match key {
        Key::Leave => return Some(Command::Quit),
        Key::Plain(code) => code,
    };
    if typing {
        return match code {
            KeyCode::Char(character) => Some(Command::Type(character)),
            KeyCode::Backspace => Some(Command::Erase),
            KeyCode::Enter => Some(Command::Enter),
            KeyCode::Esc => Some(Command::Cancel),
            _ => None,
        };
    }
    Some(match code {
        KeyCode::Char(letter) => {
            let direction = if letter.is_ascii_uppercase() { Back } else { Forward };
            match letter.to_ascii_lowercase() {
                'q' => Command::Quit,
                's' => Command::Step(Unit::Statement, direction),
                'i' => Command::Step(Unit::Into, direction),
                'o' => Command::Step(Unit::Over, direction),
                'u' => Command::Step(Unit::Out, direction),
                'n' => Command::Step(Unit::Network, direction),
                'b' => Command::Step(Unit::Block, direction),
                'c' => Command::Step(Unit::Scan, direction),
                'r' => Command::Run(direction),
                'g' => Command::ToCursor,
                ' ' => Command::Toggle,
                'd' => Command::Diagram,
                'x' => Command::RegisterBits,
                'l' => Command::Language,
                'v' => Command::Variables,
                'h' | '?' => Command::Help,
                'w' => Command::Prompt("watch "),
                'p' => Command::Prompt("print "),
                'f' => Command::Prompt("who "),
                ':' => Command::Prompt(""),
                _ => return None,
            }
        }
        KeyCode::F(11) => Command::Step(Unit::Statement, Forward),
        KeyCode::F(10) => Command::Step(Unit::Over, Forward),
        KeyCode::F(9) => Command::Toggle,
        KeyCode::F(5) => Command::Run(Forward),
        KeyCode::F(1) => Command::Help,
        KeyCode::Right => Command::Bits(1),
        KeyCode::Left => Command::Bits(-1),
        KeyCode::Up => Command::Lines(-1),
        KeyCode::Down => Command::Lines(1),
        KeyCode::PageUp => Command::Pages(-1),
        KeyCode::PageDown => Command::Pages(1),
        KeyCode::Tab | KeyCode::BackTab => Command::Focus,
        KeyCode::Esc => Command::Cancel,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(code: KeyCode) -> Option<Command> {
        command(Key::Plain(code), false)
    }

    #[test]
    fn every_step_has_a_key_there_and_the_same_in_upper_case_back() {
        for (letter, unit) in [
            ('s', Unit::Statement),
            ('i', Unit::Into),
            ('o', Unit::Over),
            ('u', Unit::Out),
            ('n', Unit::Network),
            ('b', Unit::Block),
            ('c', Unit::Scan),
        ] {
            assert_eq!(press(KeyCode::Char(letter)), Some(Command::Step(unit, Direction::Forward)));
            assert_eq!(press(KeyCode::Char(letter.to_ascii_uppercase())), Some(Command::Step(unit, Direction::Back)));
        }
    }

    #[test]
    fn control_c_leaves_even_while_typing() {
        assert_eq!([command(Key::Leave, false), command(Key::Leave, true)], [Some(Command::Quit); 2]);
    }

    #[test]
    fn while_typing_letters_are_letters() {
        let key = |code| command(Key::Plain(code), true);
        assert_eq!(key(KeyCode::Char('q')), Some(Command::Type('q')));
        assert_eq!(key(KeyCode::Esc), Some(Command::Cancel));
        assert_eq!(key(KeyCode::Up), None);
    }
}
