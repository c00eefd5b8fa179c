//! Draws the screen: where its panels stand, and each of them.

mod layout;
mod lists;
mod over;
mod program;
mod signals;

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Paragraph, Wrap};
use sieben_model::visible::visible;
use sieben_workspace::session::texts::fill;
use std::sync::atomic::Ordering;

use super::columns::{columns, fitted};
use super::look::Look;
use super::numbers::clock;
use super::pictured;
use super::plants::{self, Moment};
use super::state::{Over, Said, Screen};
use super::words;
use crate::palette::{Lit, Palette};
use layout::Panel;

/// Smallest terminal that the screen fits into.
pub(crate) const MIN_WIDTH: u16 = 80;
/// Its height.
pub(crate) const MIN_HEIGHT: u16 = 24;
/// Columns of the first line that are left free for a time and a speed that grow.
const SPARE_COLUMNS: usize = 12;
/// Rows of the cause of a STOP at most.
const STOP_ROWS: u16 = 3;

/// What a panel is drawn of.
#[derive(Clone, Copy)]
struct Scene<'s> {
    look: &'s Look,
    screen: &'s Screen,
    palette: Palette,
}

/// Draws everything, or a request for more room.
pub(crate) fn draw(frame: &mut Frame<'_>, look: &Look, screen: &Screen, palette: Palette) {
    let area = frame.area();
    if area.width < MIN_WIDTH || area.height < MIN_HEIGHT {
        let text = fill(screen.language, words::TOO_SMALL, &[&MIN_WIDTH, &MIN_HEIGHT, &area.width, &area.height]);
        frame.render_widget(Paragraph::new(text).wrap(Wrap { trim: true }), area);
        return;
    }
    let scene = Scene { look, screen, palette };
    let stop = stop_text(look);
    let stop_rows = stop.as_ref().map_or(0, |text| rows_of(text, area.width).clamp(1, STOP_ROWS));
    let rows = [Constraint::Length(1), Constraint::Length(stop_rows), Constraint::Fill(1), Constraint::Length(1)];
    let [header, cause, body, foot] = Layout::vertical(rows).areas(area);
    scene.header(frame, header);
    if let Some(stop) = stop {
        let text = Line::styled(format!(" {}", visible(&stop)), palette.colour(Color::Yellow));
        frame.render_widget(Paragraph::new(text).wrap(Wrap { trim: false }), cause);
    }
    let plant = look.plants.get(screen.plant).and_then(pictured::look);
    for (panel, area) in layout::panels(body, plant.as_ref().map(|plant| plants::size(plant.kind)), screen.part) {
        match panel {
            Panel::Plant => scene.plant(frame, area, plant.as_ref()),
            Panel::Signals => scene.signals(frame, area),
            Panel::Program => scene.program(frame, area),
            Panel::Values => scene.values(frame, area),
            Panel::Changes => scene.changes(frame, area),
            Panel::Diagnostics => scene.diagnostics(frame, area),
            Panel::Run => scene.run(frame, area),
        }
    }
    scene.foot(frame, foot);
    scene.over(frame, body);
}

/// Rows that a text needs in this width, if it can be broken anywhere.
fn rows_of(text: &str, width: u16) -> u16 {
    u16::try_from((columns(text) + 1).div_ceil(usize::from(width.max(1)))).unwrap_or(u16::MAX)
}

/// Why the CPU is in STOP.
fn stop_text(look: &Look) -> Option<String> {
    let stop = &look.state["stop"];
    let place = match (stop["file"].as_str(), stop["line"].as_u64()) {
        (Some(file), Some(line)) => format!("  {file}:{line}"),
        _ => String::new(),
    };
    Some(format!("{}{place}", stop["text"].as_str()?))
}

impl Scene<'_> {
    fn header(&self, frame: &mut Frame<'_>, area: Rect) {
        let Self { look, palette, .. } = self;
        let bold = Style::new().add_modifier(Modifier::BOLD);
        let mode = look.word("mode");
        let mut left = vec![Span::styled(" Sieben ", bold)];
        if let Some(project) = look.state["project"].as_str() {
            left.push(Span::raw(format!(" {}  ", fitted(project, usize::from(area.width / 4)))));
        }
        left.push(Span::styled("│ ", palette.faint()));
        let at = left.len();
        let has_failed = look.state["stop"]["event"].as_str().is_some_and(|event| !event.starts_with("16#43"));
        let is_forced = look.state["forced_count"].as_u64().unwrap_or_default() > 0;
        for (word, lit, colour) in [
            ("RUN", mode == "RUN", Color::Green),
            ("STOP", mode == "STOP", Color::Yellow),
            ("SF", has_failed, Color::Red),
            ("FRCE", is_forced, Color::Yellow),
        ] {
            left.push(palette.led(Lit::when(lit), colour));
            left.push(Span::raw(format!(" {word} ")));
        }
        if !matches!(mode, "RUN" | "STOP" | "") {
            left.push(Span::styled(mode.to_owned(), palette.colour(Color::Yellow)));
        }
        // `10x` is a factor, `max` a word.
        let speed = look.word("speed");
        let speed = match speed.strip_suffix('x') {
            Some(factor) if speed != "max" => format!("{factor}×"),
            _ => speed.to_owned(),
        };
        let speed = if look.is_paused() { format!("{}, {speed}", self.screen.word(words::PAUSED)) } else { speed };
        let auto = self.screen.story.as_ref().is_some_and(|story| story.is_on.load(Ordering::Relaxed) && story.has_plant.load(Ordering::Relaxed));
        let auto = if auto { format!("{}  ", self.screen.word(words::AUTO)) } else { String::new() };
        let right = Line::from(vec![
            Span::styled(format!(" {auto}"), palette.faint()),
            Span::raw(format!("{}  ", clock(look.time_ms()))),
            Span::styled(format!("{speed} "), bold),
        ]);
        let width = u16::try_from(right.width()).unwrap_or(area.width).min(area.width);
        // Where the page is stands there as it fits, rather than which CPU it is.
        let (cpu, page) = (look.word("cpu"), look.word("page"));
        let short = page.trim_start_matches("http://").trim_end_matches('/');
        let room = usize::from(area.width - width).saturating_sub(left.iter().map(Span::width).sum());
        let texts = match page {
            "" => vec![format!("CPU {cpu}  ")],
            _ => vec![format!("CPU {cpu}  {page}  "), format!("CPU {cpu}  {short}  "), format!("{short}  ")],
        };
        // What stands to the right of it grows; the whole address is there only where it need not become shorter then.
        let fits = |(index, text): &(usize, String)| columns(text) + if *index == 0 { SPARE_COLUMNS } else { 0 } <= room;
        let text = texts.into_iter().enumerate().find(fits).map_or_else(|| format!("CPU {cpu}  "), |(_, text)| text);
        left.insert(at, Span::raw(text));
        frame.render_widget(Paragraph::new(Line::from(left)), area);
        frame.render_widget(Paragraph::new(right), Rect { x: area.right() - width, width, ..area });
    }

    fn plant(&self, frame: &mut Frame<'_>, area: Rect, plant: Option<&plants::PlantLook>) {
        let Some(plant) = plant else { return };
        let head = self.screen.word(words::PLANT);
        let title = match self.look.plants.len() {
            0 | 1 => format!(" {head} {} ", visible(&plant.name)),
            count => format!(" {head} {} · {}/{count} o ", visible(&plant.name), self.screen.plant + 1),
        };
        let mut block = self.palette.frame(title);
        let seconds = self.screen.story.as_ref().map_or(u64::MAX, |story| story.seconds.load(Ordering::Relaxed));
        if seconds != u64::MAX {
            let text = fill(self.screen.language, words::AUTO_IN, &[&seconds]);
            block = block.title_bottom(Line::from(format!(" {text} ")).style(self.palette.colour(Color::Cyan)));
        }
        let inner = block.inner(area);
        frame.render_widget(block, area);
        plants::draw(frame.buffer_mut(), inner, plant, Moment { time_ms: self.look.time_ms() }, self.palette);
    }

    fn foot(&self, frame: &mut Frame<'_>, area: Rect) {
        let screen = self.screen;
        let line = match (&screen.over, &screen.said) {
            (Over::Prompt { row, typed }, said) => {
                let name = self.look.rows.get(*row).map_or("", |row| row.name.as_str());
                let mut spans = vec![
                    Span::styled(format!(" {name} = "), self.palette.colour(Color::Cyan)),
                    Span::raw(visible(typed).into_owned()),
                    Span::styled("▏", self.palette.colour(Color::Cyan)),
                ];
                match said {
                    Some(Said::Refused(why)) => spans.push(Span::styled(format!("  {}", visible(why)), self.palette.colour(Color::Yellow))),
                    _ => spans.push(Span::styled(format!("  {}", fill(screen.language, words::NEW_VALUE, &[&name])), self.palette.faint())),
                }
                Line::from(spans)
            }
            (Over::MemoryReset, _) => Line::styled(format!(" {}", screen.word(words::MRES_ASKED)), self.palette.colour(Color::Yellow)),
            (_, Some(Said::Refused(text))) => Line::styled(format!(" {}", visible(text)), self.palette.colour(Color::Yellow)),
            (_, Some(Said::Done(text))) => Line::styled(format!(" {}", visible(text)), self.palette.colour(Color::Green)),
            (_, None) => self.keys(area.width),
        };
        frame.render_widget(Paragraph::new(line), area);
    }

    /// As many keys as there is room for.
    fn keys(&self, width: u16) -> Line<'static> {
        let mut keys: Vec<(&str, &str)> = Vec::new();
        let mut left = usize::from(width).saturating_sub(1);
        let auto = self.screen.story.is_some().then_some(words::AUTO_KEY);
        let (first, rest) = words::KEYS.split_at(2);
        for &(key, text) in first.iter().chain(&auto).chain(rest) {
            let word = match key {
                "p" if self.look.is_paused() => self.screen.word(words::GO_ON),
                _ => self.screen.word(text),
            };
            let room = columns(key) + columns(word) + 3;
            if room > left + 2 {
                break;
            }
            left = left.saturating_sub(room);
            keys.push((key, word));
        }
        self.palette.keys(&keys)
    }
}
