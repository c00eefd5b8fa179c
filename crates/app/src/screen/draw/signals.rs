//! Draws what can be chosen: inputs and outputs, timers, counters and words.

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};
use ratatui::widgets::Paragraph;

use super::Scene;
use crate::palette::Lit;
use crate::screen::columns::{columns, fitted, padded};
use crate::screen::rows::{Driver, Group};
use crate::screen::state::Screen;
use crate::screen::words;

/// A panel of this width has inputs and outputs side by side.
const BESIDE: u16 = 40;
/// A panel of this height has them one above the other.
const ABOVE: u16 = 16;
/// Columns of an address: `I 20.0`, `QW 12`.
const ADDRESS: usize = 7;

impl Scene<'_> {
    /// The rows of a group, by their number among all.
    fn rows_of(&self, group: Group) -> Vec<usize> {
        self.look.rows.iter().enumerate().filter(|(_, row)| row.group == group).map(|(at, _)| at).collect()
    }

    /// Inputs and outputs.
    pub(super) fn signals(&self, frame: &mut Frame<'_>, area: Rect) {
        let groups = [(Group::Inputs, words::INPUTS), (Group::Outputs, words::OUTPUTS)];
        let [first, second] = if area.height < ABOVE && area.width >= BESIDE {
            Layout::horizontal([Constraint::Fill(1), Constraint::Fill(1)]).areas(area)
        } else {
            // The one that needs less has what it needs, up to half of the room.
            let [inputs, outputs] =
                groups.map(|(group, _)| u16::try_from(self.rows_of(group).len().max(2)).unwrap_or(u16::MAX).saturating_add(2));
            let half = area.height / 2;
            let height = if inputs <= outputs { inputs.min(half) } else { area.height.saturating_sub(outputs.min(half)) };
            Layout::vertical([Constraint::Length(height), Constraint::Fill(1)]).areas(area)
        };
        for ((group, head), area) in groups.into_iter().zip([first, second]) {
            self.group(frame, area, group, self.screen.word(head));
        }
    }

    /// Timers, counters, words.
    pub(super) fn values(&self, frame: &mut Frame<'_>, area: Rect) {
        self.group(frame, area, Group::Values, self.screen.word(words::VALUES));
    }

    fn group(&self, frame: &mut Frame<'_>, area: Rect, group: Group, head: &str) {
        let all = self.rows_of(group);
        let room = usize::from(area.height.saturating_sub(2));
        let chosen = all.iter().position(|&at| at == self.screen.chosen(self.look));
        // The chosen row is seen; otherwise the first ones.
        let first = chosen.map_or(0, |chosen| (chosen + 1).saturating_sub(room)).min(all.len().saturating_sub(room));
        let title = match all.len() {
            count if count > room => format!(" {head} · {}–{}/{count} ", first + 1, (first + room).min(count)),
            _ => format!(" {head} "),
        };
        let digits = Screen::digits(self.look);
        let width = usize::from(area.width.saturating_sub(2));
        let mut lines: Vec<Line<'static>> = all.iter().skip(first).take(room).map(|&at| self.row(at, &digits, width)).collect();
        if lines.is_empty() {
            lines.push(Line::styled(format!(" {}", self.screen.word(words::NONE)), self.palette.faint()));
        }
        frame.render_widget(Paragraph::new(lines).block(self.palette.frame(title)), area);
    }

    /// `1● START   I 0.0`: the key, the state, name, value and address of a row.
    fn row(&self, at: usize, digits: &[usize], width: usize) -> Line<'static> {
        let (Some(row), Some(shown)) = (self.look.rows.get(at), self.look.shown.get(at)) else { return Line::default() };
        let key = match (digits.iter().position(|&digit| digit == at), &row.driver) {
            (Some(index), _) => (index + 1).to_string(),
            (None, Driver::Plant(_)) => "~".to_owned(),
            (None, Driver::People) => " ".to_owned(),
        };
        let is_chosen = at == self.screen.chosen(self.look);
        let named = row.name != row.address && !row.address.is_empty();
        let address = if named { row.address.as_str() } else { "" };
        let lamp = match shown.on {
            Some(on) => self.palette.led(Lit::when(on), Color::Green),
            None => Span::raw(" "),
        };
        // Bits have a lamp; of everything else the value stands before the address.
        let value = if shown.on.is_some() && !self.screen.formats.contains_key(&row.item) { "" } else { shown.text.as_str() };
        let mut left = width.saturating_sub(3);
        // On a narrow panel a value that is read goes before the address.
        let has_room = left >= 16 && (left >= 24 || columns(value) + ADDRESS + 6 <= left);
        let address = if has_room { format!(" {address:<ADDRESS$}") } else { String::new() };
        left = left.saturating_sub(columns(&address));
        let least_name = columns(&row.name).min(left / 3);
        let room = left.saturating_sub(least_name + 1);
        // Without the number that the bits are, a value may still be read.
        let short = value.split_once(" (").map_or(value, |(short, _)| short);
        let value = fitted(if columns(value) > room { short } else { value }, room);
        let gap = if value.is_empty() { 0 } else { columns(&value) + 1 };
        let name = padded(&row.name, left.saturating_sub(gap));
        let value_style = if shown.is_error { self.palette.colour(Color::Yellow) } else { Style::new().add_modifier(Modifier::BOLD) };
        let mut spans =
            vec![Span::styled(key, self.palette.colour(Color::Cyan).add_modifier(Modifier::BOLD)), lamp, Span::raw(" "), Span::raw(name)];
        if gap > 0 {
            spans.extend([Span::raw(" "), Span::styled(value, value_style)]);
        }
        spans.push(Span::styled(address, self.palette.faint()));
        if is_chosen {
            // One colour for all of it, which every terminal has.
            let text: String = spans.iter().map(|span| span.content.as_ref()).collect();
            return Line::styled(text, Style::new().add_modifier(Modifier::REVERSED));
        }
        Line::from(spans)
    }
}
