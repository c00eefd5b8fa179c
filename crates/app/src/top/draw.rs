//! Draws `sieben top`.

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Padding, Paragraph, Wrap};
use sieben_model::visible::visible;

use super::look::{Look, entry_text, milliseconds};
use crate::palette::{Lit, Palette};
use crate::screen::thousands;

/// Smallest terminal that the picture fits into.
const MIN_WIDTH: u16 = 80;
/// Its height.
const MIN_HEIGHT: u16 = 24;
/// From this width on, values have a column of their own.
const WIDE: u16 = 120;
/// The run with its frame.
const RUN_WIDTH: u16 = 40;
/// Inputs and outputs with their frame.
const BYTES_WIDTH: u16 = 40;
/// Both with their frames.
const HEAD_HEIGHT: u16 = 10;
/// Clients of servers that are shown at most; of more their number is.
const CLIENT_ROWS: u16 = 4;
/// Rows of the cause of a STOP at most.
const STOP_ROWS: u16 = 3;

/// Draws everything, or a request for more room.
pub(super) fn draw(frame: &mut Frame<'_>, look: &Look, palette: Palette, message: Option<&str>) {
    let area = frame.area();
    if area.width < MIN_WIDTH || area.height < MIN_HEIGHT {
        let text = format!(
            "sieben top needs {MIN_WIDTH} × {MIN_HEIGHT} characters; this terminal has {} × {}. Enlarge it, or press q to quit.",
            area.width, area.height
        );
        frame.render_widget(Paragraph::new(text).wrap(Wrap { trim: true }), area);
        return;
    }
    let stop = look.stop_text();
    let stop_rows = stop.as_ref().map_or(0, |text| rows_of(text, area.width).clamp(1, STOP_ROWS));
    let rows = [Constraint::Length(1), Constraint::Length(stop_rows), Constraint::Fill(1), Constraint::Length(1)];
    let [header, cause, body, foot] = Layout::vertical(rows).areas(area);
    draw_header(frame, header, look, palette);
    if let Some(stop) = stop {
        let text = Line::styled(format!(" {}", visible(&stop)), palette.colour(Color::Yellow));
        frame.render_widget(Paragraph::new(text).wrap(Wrap { trim: false }), cause);
    }
    let clients = look.clients();
    let client_rows = u16::try_from(clients.len()).unwrap_or(u16::MAX).min(CLIENT_ROWS);
    let clients_height = if client_rows == 0 { 0 } else { (client_rows + 2).min(body.height / 4) };
    let [body, below] = Layout::vertical([Constraint::Fill(1), Constraint::Length(clients_height)]).areas(body);
    if clients_height > 0 {
        draw_clients(frame, below, &clients, palette);
    }
    if area.width < WIDE {
        draw_narrow(frame, body, look, palette);
    } else {
        draw_wide(frame, body, look, palette);
    }
    draw_foot(frame, foot, look, palette, message);
}

/// Rows that a text needs in this width, if it can be broken anywhere.
fn rows_of(text: &str, width: u16) -> u16 {
    u16::try_from((text.chars().count() + 1).div_ceil(usize::from(width.max(1)))).unwrap_or(u16::MAX)
}

/// Run and bytes, below them values or blocks, below them the diagnostic buffer.
fn draw_narrow(frame: &mut Frame<'_>, area: Rect, look: &Look, palette: Palette) {
    let watched = u16::try_from(look.values.len()).unwrap_or(u16::MAX);
    let left = area.height.saturating_sub(HEAD_HEIGHT);
    // At least half of what is left is for the diagnostic buffer.
    let middle_height = watched.saturating_add(2).max(4).min(left / 2);
    let rows = [Constraint::Length(HEAD_HEIGHT), Constraint::Length(middle_height), Constraint::Fill(1)];
    let [head, middle, entries] = Layout::vertical(rows).areas(area);
    let [run, bytes] = Layout::horizontal([Constraint::Length(RUN_WIDTH), Constraint::Fill(1)]).areas(head);
    draw_run(frame, run, look, palette);
    draw_bytes(frame, bytes, look, palette);
    if watched == 0 {
        draw_blocks(frame, middle, look, palette);
    } else {
        let [values, blocks] = Layout::horizontal([Constraint::Fill(2), Constraint::Fill(1)]).areas(middle);
        draw_values(frame, values, look, palette);
        draw_blocks(frame, blocks, look, palette);
    }
    draw_entries(frame, entries, look, palette);
}

/// Run, bytes and values side by side, below them the diagnostic buffer and the blocks.
fn draw_wide(frame: &mut Frame<'_>, area: Rect, look: &Look, palette: Palette) {
    let watched = u16::try_from(look.values.len()).unwrap_or(u16::MAX);
    let head_height = watched.saturating_add(2).max(HEAD_HEIGHT).min((area.height / 2).max(HEAD_HEIGHT));
    let [head, rest] = Layout::vertical([Constraint::Length(head_height), Constraint::Fill(1)]).areas(area);
    let columns = [Constraint::Length(RUN_WIDTH), Constraint::Length(BYTES_WIDTH), Constraint::Fill(1)];
    let [run, bytes, right] = Layout::horizontal(columns).areas(head);
    draw_run(frame, run, look, palette);
    draw_bytes(frame, bytes, look, palette);
    if watched == 0 {
        draw_blocks(frame, right, look, palette);
        draw_entries(frame, rest, look, palette);
        return;
    }
    draw_values(frame, right, look, palette);
    let [entries, blocks] = Layout::horizontal([Constraint::Fill(3), Constraint::Fill(1)]).areas(rest);
    draw_entries(frame, entries, look, palette);
    draw_blocks(frame, blocks, look, palette);
}

fn draw_header(frame: &mut Frame<'_>, area: Rect, look: &Look, palette: Palette) {
    let bold = Style::new().add_modifier(Modifier::BOLD);
    let mode = look.word("mode");
    let mut left = vec![Span::styled(" Sieben ", bold)];
    if let Some(project) = look.state["project"].as_str() {
        left.push(Span::raw(format!(" {}  ", visible(project))));
    }
    left.push(Span::styled("│ ", palette.faint()));
    left.push(Span::raw(format!("CPU {}  ", look.word("cpu"))));
    left.push(palette.led(Lit::when(mode == "RUN"), Color::Green));
    left.push(Span::raw(" RUN "));
    left.push(palette.led(Lit::when(mode == "STOP"), Color::Yellow));
    left.push(Span::raw(" STOP"));
    if !matches!(mode, "RUN" | "STOP") {
        left.push(Span::styled(format!("  {mode}"), palette.colour(Color::Yellow)));
    }
    if look.state["forced_count"].as_u64().unwrap_or_default() > 0 {
        left.push(Span::raw(" "));
        left.push(palette.led(Lit::On, Color::Yellow));
        left.push(Span::raw(" FRCE"));
    }
    let right = Line::from(vec![Span::raw(format!("{}  ", look.time_text())), Span::styled(format!("{} ", look.speed_text()), bold)]);
    frame.render_widget(Paragraph::new(Line::from(left)), area);
    let width = u16::try_from(right.width()).unwrap_or(area.width).min(area.width);
    frame.render_widget(Paragraph::new(right), Rect { x: area.right() - width, width, ..area });
}

fn draw_run(frame: &mut Frame<'_>, area: Rect, look: &Look, palette: Palette) {
    let (cycle, work) = (&look.state["cycle_ms"], &look.state["execution_ms"]);
    let row = |name: &str, value: String| Line::from(vec![Span::styled(format!(" {name:<10}"), palette.faint()), Span::raw(value)]);
    let forced = look.forced();
    let forced = if forced.is_empty() { "nothing".to_owned() } else { forced.join(", ") };
    let lines = vec![
        row("cycle", milliseconds(&cycle["last"])),
        row("shortest", milliseconds(&cycle["min"])),
        row("longest", milliseconds(&cycle["max"])),
        row("program", format!("{} (longest {})", milliseconds(&work["last"]), milliseconds(&work["max"]))),
        row("scans", look.scans_text()),
        row("clock", look.word("clock").to_owned()),
        row("forced", forced),
        row("connected", look.state["connections"].to_string()),
    ];
    frame.render_widget(Paragraph::new(lines).block(palette.frame(" Run ")), area);
}

fn draw_bytes(frame: &mut Frame<'_>, area: Rect, look: &Look, palette: Palette) {
    let on = palette.colour(Color::Green).add_modifier(Modifier::BOLD);
    let line = |&(name, byte): &(&'static str, Option<u8>)| {
        let mut spans = vec![Span::styled(format!(" {name}  "), palette.faint())];
        let Some(byte) = byte else {
            spans.push(Span::raw(" -"));
            return Line::from(spans);
        };
        for bit in (0..8).rev() {
            let is_on = byte >> bit & 1 == 1;
            spans.push(Span::styled(if is_on { " 1" } else { " 0" }, if is_on { on } else { palette.faint() }));
        }
        spans.push(Span::raw(format!("   16#{byte:02X}")));
        Line::from(spans)
    };
    let title = Line::from(vec![Span::raw(" Inputs, outputs "), Span::styled("· bits 7 to 0 ", palette.faint())]);
    let lines: Vec<Line<'_>> = look.bytes.iter().map(line).collect();
    frame.render_widget(Paragraph::new(lines).block(palette.frame(title)), area);
}

fn draw_values(frame: &mut Frame<'_>, area: Rect, look: &Look, palette: Palette) {
    let room = usize::from(area.width.saturating_sub(4));
    let longest = look.values.iter().map(|one| one.name.chars().count()).max().unwrap_or_default();
    let width = longest.min(room * 2 / 3);
    let line = |one: &super::look::Watched| {
        let name: String = one.name.chars().take(width).collect();
        let value = match &one.value {
            Ok(_) => Span::raw(visible(&one.shown).into_owned()),
            Err(why) => Span::styled(visible(why).into_owned(), palette.colour(Color::Yellow)),
        };
        Line::from(vec![Span::styled(format!(" {:<width$}  ", visible(&name)), palette.faint()), value])
    };
    let rows = usize::from(area.height.saturating_sub(2));
    let title = match look.values.len() {
        count if count > rows => format!(" Values · {rows} of {count} "),
        _ => " Values ".to_owned(),
    };
    let lines: Vec<Line<'_>> = look.values.iter().take(rows).map(line).collect();
    frame.render_widget(Paragraph::new(lines).block(palette.frame(title)), area);
}

fn draw_clients(frame: &mut Frame<'_>, area: Rect, clients: &[String], palette: Palette) {
    let rows = usize::from(area.height.saturating_sub(2));
    let title = match clients.len() {
        count if count > rows => format!(" Clients · {rows} of {count} "),
        _ => " Clients ".to_owned(),
    };
    let lines: Vec<Line<'_>> = clients.iter().take(rows).map(|client| Line::raw(format!(" {}", visible(client)))).collect();
    frame.render_widget(Paragraph::new(lines).block(palette.frame(title)), area);
}

fn draw_blocks(frame: &mut Frame<'_>, area: Rect, look: &Look, palette: Palette) {
    let text = Paragraph::new(visible(&look.blocks_text()).into_owned()).wrap(Wrap { trim: true });
    let title = format!(" {} {} ", thousands(look.block_count), if look.block_count == 1 { "block" } else { "blocks" });
    frame.render_widget(text.block(palette.frame(title).padding(Padding::horizontal(1))), area);
}

fn draw_entries(frame: &mut Frame<'_>, area: Rect, look: &Look, palette: Palette) {
    // The date stands in the frame above.
    let line = |entry: &serde_json::Value| {
        let text = entry_text(entry);
        let (time, rest) = text.split_once("  ").unwrap_or(("", &text));
        let time = time.split_once(' ').map_or(time, |(_, time)| time);
        Line::from(vec![Span::styled(format!(" {time}  "), palette.faint()), Span::raw(visible(rest).into_owned())])
    };
    let rows = usize::from(area.height.saturating_sub(2));
    let lines: Vec<Line<'_>> = look.entries.iter().take(rows).map(line).collect();
    frame.render_widget(Paragraph::new(lines).block(palette.frame(" Diagnostic buffer, newest first ")), area);
}

fn draw_foot(frame: &mut Frame<'_>, area: Rect, look: &Look, palette: Palette, message: Option<&str>) {
    let line = match message {
        Some(message) => Line::styled(format!(" {}", visible(message)), palette.colour(Color::Yellow)),
        None => {
            let time = if look.is_paused() { ("g", "go on") } else { ("p", "pause") };
            palette.keys(&[("r", "run"), ("s", "stop"), time, ("n", "one scan"), ("+ -", "speed"), ("q", "quit")])
        }
    };
    frame.render_widget(Paragraph::new(line), area);
}
