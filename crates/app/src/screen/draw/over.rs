//! Draws what lies over the screen: the keys, and lists to choose from.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Clear, Paragraph};
use sieben_workspace::session::Language;

use super::Scene;
use crate::screen::columns::{columns, padded};
use crate::screen::menu::{Choice, Menu};
use crate::screen::state::Over;
use crate::screen::words;

/// The middle of an area, in this size at most.
fn centred(area: Rect, width: usize, height: usize) -> Rect {
    let width = u16::try_from(width).unwrap_or(u16::MAX).min(area.width);
    let height = u16::try_from(height).unwrap_or(u16::MAX).min(area.height);
    Rect { x: area.x + (area.width - width) / 2, y: area.y + (area.height - height) / 2, width, height }
}

impl Scene<'_> {
    pub(super) fn over(&self, frame: &mut Frame<'_>, area: Rect) {
        match &self.screen.over {
            Over::Help => self.help(frame, area),
            Over::Menu(menu) => self.menu(frame, area, menu),
            Over::Nothing | Over::Prompt { .. } | Over::MemoryReset => {}
        }
    }

    fn help(&self, frame: &mut Frame<'_>, area: Rect) {
        let auto = self.screen.story.is_some().then_some(words::AUTO_HELP);
        let rows: Vec<(&str, &str)> = words::HELP.iter().copied().chain(auto).map(|(keys, text)| (keys, self.screen.word(text))).collect();
        let line = |(keys, text): &(&'static str, &'static str)| {
            let german = words::GERMAN_KEYS.iter().find(|(english, _)| english == keys && self.screen.language == Language::German);
            let keys = german.map_or(*keys, |(_, german)| german);
            let keys = Span::styled(format!(" {keys:<12}"), self.palette.colour(Color::Cyan).add_modifier(Modifier::BOLD));
            Line::from(vec![keys, Span::raw(*text)])
        };
        let lines: Vec<Line<'static>> = rows.iter().map(line).collect();
        let width = lines.iter().map(Line::width).max().unwrap_or_default() + 3;
        let area = centred(area, width, lines.len() + 2);
        frame.render_widget(Clear, area);
        let head = format!(" {} ", self.screen.word(words::KEYS_HEAD));
        frame.render_widget(Paragraph::new(lines).block(self.palette.frame(head)), area);
    }

    fn menu(&self, frame: &mut Frame<'_>, area: Rect, menu: &Menu) {
        let width = menu.rows.iter().map(|(_, text)| columns(text) + 4).max().unwrap_or_default().max(44);
        let area = centred(area, width, menu.rows.len().max(1) + 2);
        let room = usize::from(area.height.saturating_sub(2));
        let first = (menu.at + 1).saturating_sub(room);
        let inner = usize::from(area.width.saturating_sub(2));
        let line = |(at, (_, text)): (usize, &(Choice, String))| {
            let text = format!(" {} ", padded(text, inner.saturating_sub(2)));
            Line::styled(text, if at == menu.at { Style::new().add_modifier(Modifier::REVERSED) } else { Style::new() })
        };
        let mut lines: Vec<Line<'static>> = menu.rows.iter().enumerate().skip(first).take(room).map(line).collect();
        if lines.is_empty() {
            lines.push(Line::styled(format!(" {}", self.screen.word(words::NONE)), self.palette.faint()));
        }
        frame.render_widget(Clear, area);
        let head = format!(" {} ", self.screen.word(menu.head));
        frame.render_widget(Paragraph::new(lines).block(self.palette.frame(head)), area);
    }
}
