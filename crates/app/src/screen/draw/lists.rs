//! Draws what changed, the diagnostic buffer and how the run goes.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};
use ratatui::widgets::Paragraph;
use serde_json::Value;
use sieben_model::visible::visible;
use sieben_workspace::session::texts::Text;

use super::Scene;
use crate::screen::columns::{columns, fitted};
use crate::screen::numbers::{clock, thousands};
use crate::screen::words;

/// Columns of the number of a scan.
const SCAN: usize = 7;

/// Lines of a note at most.
const NOTE_LINES: usize = 4;

/// A text broken between words into lines of this width, and not more than [`NOTE_LINES`] of them.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = vec![String::new()];
    for word in text.split_whitespace() {
        let is_last = lines.len() >= NOTE_LINES;
        match lines.last_mut() {
            Some(line) if line.is_empty() => line.push_str(word),
            Some(line) if is_last || columns(line) + 1 + columns(word) <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines.iter().map(|line| fitted(line, width)).collect()
}

/// `10.02 ms`; `-` for 0, which was not measured.
fn milliseconds(value: &Value) -> String {
    value.as_f64().filter(|&ms| ms > 0.0).map_or_else(|| "-".to_owned(), |ms| format!("{ms:.2} ms"))
}

impl Scene<'_> {
    pub(super) fn changes(&self, frame: &mut Frame<'_>, area: Rect) {
        let room = usize::from(area.height.saturating_sub(2));
        let width = usize::from(area.width.saturating_sub(2));
        let changes = &self.look.changes;
        let mut above = None;
        let shown = changes.iter().skip(changes.len().saturating_sub(room));
        let lines: Vec<Line<'static>> = shown.flat_map(|entry| self.change(entry, above.replace(entry["scan"].as_u64()), width)).collect();
        // A note may take several lines: the newest ones are seen.
        let lines = lines.split_at(lines.len().saturating_sub(room)).1.to_vec();
        let head = format!(" {} ", self.screen.word(words::CHANGES));
        frame.render_widget(Paragraph::new(lines).block(self.palette.frame(head)), area);
    }

    /// An entry; its scan is written only where it differs from the one above.
    fn change(&self, entry: &Value, above: Option<Option<u64>>, width: usize) -> Vec<Line<'static>> {
        let text = |key: &str| visible(entry[key].as_str().unwrap_or_default()).into_owned();
        let scan = entry["scan"].as_u64();
        let scan = if above == Some(scan) { String::new() } else { thousands(scan.unwrap_or_default()) };
        let scan = Span::styled(format!("{scan:>SCAN$} "), self.palette.faint());
        let room = width.saturating_sub(SCAN + 1);
        if let Some(note) = entry["note"].as_str() {
            let parts = wrapped(&visible(note.trim_end()), room);
            let line = |(index, part): (usize, String)| {
                let scan = if index == 0 { scan.clone() } else { Span::raw(" ".repeat(SCAN + 1)) };
                Line::from(vec![scan, Span::styled(part, self.palette.colour(Color::Yellow))])
            };
            return parts.into_iter().enumerate().map(line).collect();
        }
        let (name, address) = (text("name"), text("address"));
        let name = if name.is_empty() { address } else { name };
        let values = format!("{}→{}", text("before"), text("after"));
        let name = fitted(&name, room.saturating_sub(columns(&values) + 1).max(room / 3));
        let left = room.saturating_sub(columns(&name) + columns(&values) + 2);
        vec![Line::from(vec![
            scan,
            Span::raw(format!("{name} ")),
            Span::styled(values, Style::new().add_modifier(Modifier::BOLD)),
            Span::styled(format!(" {}", fitted(&text("comment"), left)), self.palette.faint()),
        ])]
    }

    pub(super) fn diagnostics(&self, frame: &mut Frame<'_>, area: Rect) {
        let room = usize::from(area.height.saturating_sub(2));
        let line = |entry: &Value| {
            let text = |key: &str| entry[key].as_str().unwrap_or_default();
            let place = match (entry["file"].as_str(), entry["line"].as_u64()) {
                (Some(file), Some(line)) => format!("  {file}:{line}"),
                _ => String::new(),
            };
            // The date stands in the panel of the run.
            let time = text("time").split_once(' ').map_or(text("time"), |(_, time)| time);
            let time = format!(" {time}  ");
            let left = usize::from(area.width.saturating_sub(2)).saturating_sub(columns(&time));
            let said = fitted(&format!("{}  {}{place}", text("event"), text("text")), left);
            Line::from(vec![Span::styled(time, self.palette.faint()), Span::raw(said)])
        };
        let lines: Vec<Line<'static>> = self.look.entries.iter().take(room).map(line).collect();
        let head = format!(" {} ", self.screen.word(words::DIAGNOSTICS));
        frame.render_widget(Paragraph::new(lines).block(self.palette.frame(head)), area);
    }

    pub(super) fn run(&self, frame: &mut Frame<'_>, area: Rect) {
        let state = &self.look.state;
        let (cycle, work) = (&state["cycle_ms"], &state["execution_ms"]);
        let row = |name: Text, value: String| {
            let name = self.screen.word(name);
            Line::from(vec![Span::styled(format!(" {name:<11}"), self.palette.faint()), Span::raw(visible(&value).into_owned())])
        };
        let forced = state["forced"].as_array().into_iter().flatten();
        let forced: Vec<String> = forced
            .map(|one| format!("{} = {}", one["name"].as_str().unwrap_or_default(), one["shown"].as_str().unwrap_or_default()))
            .collect();
        let forced = if forced.is_empty() { self.screen.word(words::NOTHING).to_owned() } else { forced.join(", ") };
        let longest = self.screen.word(words::AT_MOST);
        let mut lines = vec![
            row(words::CYCLE, milliseconds(&cycle["last"])),
            row(words::SHORTEST, milliseconds(&cycle["min"])),
            row(words::LONGEST, milliseconds(&cycle["max"])),
            row(words::EXECUTION, format!("{} ({longest} {})", milliseconds(&work["last"]), milliseconds(&work["max"]))),
            row(words::SCANS, thousands(state["scans"].as_u64().unwrap_or_default())),
            row(words::CLOCK, self.look.word("clock").to_owned()),
            row(words::FORCED, forced),
            row(words::CONNECTED, state["connections"].to_string()),
        ];
        lines.extend(state["clients"].as_array().into_iter().flatten().map(|client| row(words::CLIENTS, client_text(client))));
        let head = format!(" {} ", self.screen.word(words::RUN));
        frame.render_widget(Paragraph::new(lines).block(self.palette.frame(head)), area);
    }
}

/// A client of a server in one line.
pub(super) fn client_text(client: &Value) -> String {
    let word = |key: &str| client[key].as_str().unwrap_or("-");
    let time = clock(client["connected_ms"].as_f64().unwrap_or_default() as u64);
    format!("{} {} {} {} {time}", word("protocol"), word("peer"), word("partner"), word("last"))
}
