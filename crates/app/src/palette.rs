//! Colours and frames that screens share; without colours the same things are bold or dim.

use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, BorderType};

/// Whether and how a screen is coloured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Palette {
    /// In the colours of the terminal.
    Colours,
    /// Without: `NO_COLOR` is set.
    Plain,
}

impl Palette {
    /// What the user wishes.
    pub(crate) fn wanted() -> Self {
        match std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty()) {
            true => Self::Colours,
            false => Self::Plain,
        }
    }

    /// A style in a colour.
    pub(crate) fn colour(self, colour: Color) -> Style {
        match self {
            Self::Colours => Style::new().fg(colour),
            Self::Plain => Style::new(),
        }
    }

    /// A style for what matters less.
    pub(crate) fn faint(self) -> Style {
        match self {
            Self::Colours => Style::new().fg(Color::DarkGray),
            Self::Plain => Style::new().add_modifier(Modifier::DIM),
        }
    }

    /// A frame with a title.
    pub(crate) fn frame(self, title: impl Into<Line<'static>>) -> Block<'static> {
        Block::bordered().border_type(BorderType::Rounded).border_style(self.faint()).title(title)
    }

    /// A light that is on or off.
    pub(crate) fn led(self, lit: Lit, colour: Color) -> Span<'static> {
        match lit {
            Lit::On => Span::styled("●", self.colour(colour)),
            Lit::Off => Span::styled("○", self.faint()),
        }
    }

    /// The line of keys at the foot of a screen.
    pub(crate) fn keys(self, keys: &[(&str, &str)]) -> Line<'static> {
        let mut spans = vec![Span::raw(" ")];
        for (key, word) in keys {
            spans.push(Span::styled((*key).to_owned(), self.colour(Color::Cyan).add_modifier(Modifier::BOLD)));
            spans.push(Span::raw(format!(" {word}  ")));
        }
        Line::from(spans)
    }
}

/// Whether a light is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lit {
    On,
    Off,
}

impl Lit {
    /// On if this is true.
    pub(crate) fn when(on: bool) -> Self {
        if on { Self::On } else { Self::Off }
    }
}
