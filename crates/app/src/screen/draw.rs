//! Draws the demo: plant, program, changes and keys.

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line as TextLine, Span};
use ratatui::widgets::{Paragraph, Wrap};
use sieben_cpu::OperatingMode;
use sieben_sim::devices::dosing::Button;
use sieben_workspace::Speed;

use super::changes::{Entry, Event, clock, thousands};
use super::digits::{self, Cell};
use super::listing::Line;
use super::operator::CYCLE_US;
use super::picture::Picture;
use crate::palette::{Lit, Palette};

/// Smallest terminal that the picture fits into.
pub(crate) const MIN_WIDTH: u16 = 80;
/// Its height.
pub(crate) const MIN_HEIGHT: u16 = 24;
/// The plant with its frame.
const PLANT_WIDTH: u16 = 42;
const PLANT_HEIGHT: u16 = 13;

/// Eighths of a cell, for levels.
const EIGHTHS: [char; 9] = [' ', '▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];

/// Draws everything, or a request for more room.
pub(crate) fn draw(frame: &mut Frame<'_>, picture: &Picture<'_>, palette: Palette) {
    let area = frame.area();
    if area.width < MIN_WIDTH || area.height < MIN_HEIGHT {
        let text = format!(
            "The demo needs {MIN_WIDTH} × {MIN_HEIGHT} characters; this terminal has {} × {}. Enlarge it, or press q to quit.",
            area.width, area.height
        );
        frame.render_widget(Paragraph::new(text).wrap(Wrap { trim: true }), area);
        return;
    }
    let [header, body, keys] = Layout::vertical([Constraint::Length(1), Constraint::Fill(1), Constraint::Length(1)]).areas(area);
    let [left, right] = Layout::horizontal([Constraint::Length(PLANT_WIDTH), Constraint::Fill(1)]).areas(body);
    let [plant, log] = Layout::vertical([Constraint::Length(PLANT_HEIGHT), Constraint::Fill(1)]).areas(left);
    draw_header(frame, header, picture, palette);
    draw_plant(frame, plant, picture, palette);
    draw_changes(frame, log, picture, palette);
    draw_program(frame, right, picture, palette);
    draw_keys(frame, keys, picture, palette);
}

fn draw_header(frame: &mut Frame<'_>, area: Rect, picture: &Picture<'_>, palette: Palette) {
    let bold = Style::new().add_modifier(Modifier::BOLD);
    let mode = picture.mode;
    let running = mode == OperatingMode::Run;
    let led = |on: bool, colour: Color| palette.led(Lit::when(on), colour);
    let left = TextLine::from(vec![
        Span::styled(" Sieben", bold),
        Span::raw("  dosing of a liquid  "),
        Span::styled("│ ", palette.faint()),
        Span::raw(format!("CPU {}  ", picture.cpu_type.name)),
        led(running, Color::Green),
        Span::raw(" RUN "),
        led(!running, Color::Yellow),
        Span::raw(" STOP"),
    ]);
    let speed = match picture.speed {
        _ if picture.paused => "paused".to_owned(),
        Speed::Factor(factor) => format!("{factor}×"),
        Speed::Max => "max".to_owned(),
    };
    let right = TextLine::from(vec![Span::raw(format!("{}  ", clock(picture.time_ms))), Span::styled(format!("{speed} "), bold)]);
    frame.render_widget(Paragraph::new(left), area);
    frame.render_widget(Paragraph::new(right.right_aligned()), area);
}

fn draw_keys(frame: &mut Frame<'_>, area: Rect, picture: &Picture<'_>, palette: Palette) {
    let keys = [
        ("s", "START"),
        ("x", "STOP"),
        ("f", "fault"),
        ("m", "CPU"),
        ("a", "auto"),
        ("p", if picture.paused { "go on" } else { "pause" }),
        ("n", "step"),
        ("+ -", "speed"),
        ("q", "quit"),
    ];
    frame.render_widget(Paragraph::new(palette.keys(&keys)), area);
}

/// The words under the plant: what a user can do now.
fn hint(picture: &Picture<'_>) -> String {
    if picture.mode != OperatingMode::Run {
        return " the CPU is in STOP: m starts it ".to_owned();
    }
    if picture.dosing.meter_failed && picture.dosing.tank.valve_open() {
        return " no pulses, nobody counts: x stops it ".to_owned();
    }
    if picture.dosing.tank.valve_open() {
        return " dosing … what if the meter fails? f ".to_owned();
    }
    match picture.seconds_to_story {
        Some(seconds) => format!(" press s for START, or wait {seconds} s "),
        None => " press s for START ".to_owned(),
    }
}

fn draw_plant(frame: &mut Frame<'_>, area: Rect, picture: &Picture<'_>, palette: Palette) {
    let block = palette.frame(" Plant ").title_bottom(TextLine::from(hint(picture)).style(palette.colour(Color::Cyan)));
    let inner = block.inner(area);
    frame.render_widget(block, area);
    let buffer = frame.buffer_mut();
    draw_tank(buffer, inner, picture, palette);
    draw_display(buffer, inner.x + 16, inner.y, picture, palette);
    draw_signals(buffer, inner.x + 16, inner.y + 6, picture, palette);
}

/// Tank, valve, flow meter and container, one above the other.
fn draw_tank(buffer: &mut Buffer, area: Rect, picture: &Picture<'_>, palette: Palette) {
    let tank = &picture.dosing.tank;
    let water = palette.colour(Color::Blue);
    let wall = Style::new();
    let (x, y) = (area.x + 1, area.y);
    let supply = f64::from(tank.settings().supply_litres);
    buffer.set_string(x, y, format!("╭{:─^11}╮", format!(" {:.0} l ", tank.supply_litres())), wall);
    vessel(buffer, Rect::new(x, y + 1, 13, 3), tank.supply_litres() / supply, (wall, water));
    buffer.set_string(x, y + 4, "╰────┬─┬────╯", wall);

    let open = tank.valve_open();
    let (valve, style) = if open { ("▶═◀", palette.colour(Color::Green)) } else { ("▶│◀", palette.faint()) };
    buffer.set_string(x + 5, y + 5, valve, style.add_modifier(Modifier::BOLD));
    buffer.set_string(x, y + 5, "Y1", palette.faint());
    // The wheel of the flow meter turns a quarter with every half litre.
    let wheel = ["◐", "◓", "◑", "◒"][(tank.litres_delivered() * 2.0) as usize % 4];
    let meter = if picture.dosing.meter_failed { palette.colour(Color::Red) } else { Style::new() };
    buffer.set_string(x, y + 6, "B1", palette.faint());
    buffer.set_string(x + 5, y + 6, "│ │", wall);
    buffer.set_string(x + 6, y + 6, if picture.dosing.meter_failed { "✗" } else { wheel }, meter);

    let capacity = f64::from(tank.settings().vessel_litres);
    let container = Rect::new(x + 2, y + 7, 9, 3);
    vessel(buffer, container, tank.vessel_litres() / capacity, (wall, water));
    let overflowing = tank.flowing() && tank.vessel_litres() >= capacity;
    if tank.flowing() && !overflowing {
        let empty_rows = ((1.0 - tank.vessel_litres() / capacity) * f64::from(container.height)) as u16;
        (0..empty_rows).for_each(|row| buffer.set_string(x + 6, container.y + row, "┆", water));
    }
    if overflowing {
        (0..3).for_each(|row| {
            buffer.set_string(x + 1, container.y + row, "╎", water);
            buffer.set_string(x + 11, container.y + row, "╎", water);
        });
    }
    buffer.set_string(x + 2, y + 10, format!("╰{:─^7}╯", format!(" {:.0} l ", tank.vessel_litres())), wall);
}

/// Two walls with liquid between them.
fn vessel(buffer: &mut Buffer, area: Rect, level: f64, (wall, water): (Style, Style)) {
    let eighths = (level.clamp(0.0, 1.0) * f64::from(area.height) * 8.0).round() as u16;
    for row in 0..area.height {
        let y = area.bottom() - 1 - row;
        let filled = usize::from(eighths.saturating_sub(row * 8).min(8));
        buffer.set_string(area.x, y, "│", wall);
        buffer.set_string(area.x + 1, y, EIGHTHS[filled].to_string().repeat(usize::from(area.width) - 2), water);
        buffer.set_string(area.right() - 1, y, "│", wall);
    }
}

fn draw_display(buffer: &mut Buffer, x: u16, y: u16, picture: &Picture<'_>, palette: Palette) {
    let lit = palette.colour(Color::LightRed).add_modifier(Modifier::BOLD);
    let word = picture.dosing.tank.display();
    for (position, digit) in digits::of_word(word).into_iter().enumerate() {
        for row in 0..digits::HEIGHT {
            let text: String = digits::row(digit, row).into_iter().map(|cell| if cell == Cell::Lit { '█' } else { ' ' }).collect();
            buffer.set_string(x + (position * digits::WIDTH) as u16, y + row as u16, text, lit);
        }
    }
    buffer.set_string(
        x,
        y + 5,
        format!("QW 4 {word:04X}   C 0 {:>3}", picture.watched("C 0").map_or(0, |(_, count)| count)),
        palette.faint(),
    );
}

/// The inputs with their keys, and the outputs.
fn draw_signals(buffer: &mut Buffer, x: u16, y: u16, picture: &Picture<'_>, palette: Palette) {
    let tank = &picture.dosing.tank;
    let pressed = |button: Button| if tank.is_pressed(button) { "pressed" } else { "" };
    let meter = if picture.dosing.meter_failed { "failed" } else { "" };
    let rows = [
        ("I 0.0", "s", pressed(Button::Start)),
        ("I 0.1", "x", pressed(Button::Stop)),
        ("I 0.7", "f", meter),
        ("Q 0.0", " ", if tank.valve_open() { "open" } else { "closed" }),
        ("M 0.0", " ", ""),
    ];
    for (row, (address, key, state)) in rows.into_iter().enumerate() {
        let y = y + row as u16;
        let Some((watched, value)) = picture.watched(address) else { continue };
        let (symbol, on) = (&watched.symbol, value == 1);
        let (lamp, style) = if on { ("●", palette.colour(Color::Green)) } else { ("○", palette.faint()) };
        buffer.set_string(x, y, address, Style::new());
        buffer.set_string(x + 6, y, lamp, style);
        buffer.set_string(x + 8, y, symbol, Style::new());
        buffer.set_string(x + 14, y, key, palette.colour(Color::Cyan).add_modifier(Modifier::BOLD));
        buffer.set_string(x + 16, y, state, palette.faint());
    }
}

fn draw_changes(frame: &mut Frame<'_>, area: Rect, picture: &Picture<'_>, palette: Palette) {
    let block = palette.frame(" What changed ");
    let room = usize::from(block.inner(area).height);
    let entries = &picture.entries;
    let mut last = None;
    let shown = entries.iter().skip(entries.len().saturating_sub(room));
    let lines: Vec<TextLine<'_>> = shown.map(|entry| change_line(entry, last.replace(entry.scan), palette)).collect();
    frame.render_widget(Paragraph::new(lines).block(block), area);
}

/// An entry; its scan is written only where it differs from the one above.
fn change_line<'a>(entry: &'a Entry, above: Option<u64>, palette: Palette) -> TextLine<'a> {
    let scan = if above == Some(entry.scan) { String::new() } else { thousands(entry.scan) };
    let scan = Span::styled(format!("{scan:>7} "), palette.faint());
    match &entry.event {
        Event::Change { address, values, comment } => TextLine::from(vec![
            scan,
            Span::raw(format!("{address} ")),
            Span::styled(values.as_str(), Style::new().add_modifier(Modifier::BOLD)),
            Span::raw(" "),
            Span::styled(comment.as_str(), palette.faint()),
        ]),
        Event::Note(text) => TextLine::from(vec![scan, Span::styled(text.as_str(), palette.colour(Color::Yellow))]),
    }
}

fn draw_program(frame: &mut Frame<'_>, area: Rect, picture: &Picture<'_>, palette: Palette) {
    let cycle = if picture.cycle_us == 0 { CYCLE_US } else { picture.cycle_us };
    let needs = picture.scan_us.map_or(String::new(), |us| format!("· {us:.0} µs a scan "));
    let status = format!(" scan {}  cycle {} ms ", thousands(picture.scans), cycle / 1_000);
    let block = palette.frame(format!(" OB 1 {needs}")).title_bottom(TextLine::from(status));
    let inner = block.inner(area);
    // Titles of networks need five more lines.
    let titles = usize::from(inner.height) > picture.lines.len();
    let symbol_width = usize::from(inner.width).saturating_sub(27).min(24);
    let mut lines = vec![TextLine::styled(format!("{:<width$}STA RLO ACCU 1", "", width = 13 + symbol_width), palette.faint())];
    for line in picture.lines {
        match line {
            Line::Network(title) if titles => lines.push(TextLine::styled(format!("// {title}"), palette.faint())),
            Line::Network(_) => {}
            Line::Statement { index, mnemonic, operand, symbol } => {
                let symbol: String = symbol.chars().take(symbol_width).collect();
                let text = format!("  {mnemonic:<3} {operand:<6}{symbol:<symbol_width$}");
                let Some(seen) = picture.seen(*index) else {
                    lines.push(TextLine::styled(text, palette.faint()));
                    continue;
                };
                let on = palette.colour(Color::Green).add_modifier(Modifier::BOLD);
                let bit = |value: bool| Span::styled(if value { "1" } else { "0" }, if value { on } else { palette.faint() });
                let style = if seen.rlo { palette.colour(Color::Green) } else { Style::new() };
                lines.push(TextLine::from(vec![
                    Span::styled(text, style),
                    Span::raw("  "),
                    bit(seen.sta),
                    Span::raw("   "),
                    bit(seen.rlo),
                    Span::styled(format!("   {:04X}", seen.accu1 & 0xFFFF), palette.faint()),
                ]));
            }
        }
    }
    frame.render_widget(Paragraph::new(lines).block(block), area);
}

#[cfg(test)]
mod tests {
    use super::super::operator::Action;
    use super::super::picture::Viewer;
    use super::super::session::Session;
    use super::*;
    use ratatui::Terminal;
    use ratatui::backend::TestBackend;

    fn screen(picture: &Picture<'_>, width: u16, height: u16) -> String {
        let mut terminal = Terminal::new(TestBackend::new(width, height)).expect("a backend in memory");
        terminal.draw(|frame| draw(frame, picture, Palette::Colours)).expect("a backend in memory");
        terminal.backend().to_string()
    }

    /// A picture after so much time. What depends on the computer is left out.
    fn after<'s>(session: &'s Session, seconds: u64, actions: &[Action]) -> Picture<'s> {
        actions.iter().for_each(|&action| session.act(action).expect("the gate is open"));
        session.steps(seconds * 1_000_000 / CYCLE_US - 1);
        let mut viewer = Viewer::new(session);
        session.steps(1);
        session.desk.replay(|| session.desk.number() > 0);
        let mut picture = viewer.picture(30).expect("the gate is open");
        (picture.paused, picture.scan_us) = (false, None);
        picture
    }

    #[test]
    fn the_screen_shows_a_dose_on_its_way() {
        insta::assert_snapshot!(screen(&after(&Session::in_steps(), 7, &[]), 80, 24));
    }

    #[test]
    fn the_picture_in_the_readme_is_what_the_screen_shows() {
        let readme = include_str!("../../../../README.md");
        let picture = readme.split("```text\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a picture in the README");
        let session = Session::in_steps();
        let screen = screen(&after(&session, 7, &[]), 80, 24);
        let shown: Vec<&str> = screen.lines().map(|line| line.trim_matches('"').trim_end()).collect();
        assert_eq!(picture.lines().collect::<Vec<_>>(), shown);
    }

    #[test]
    fn a_larger_terminal_shows_the_networks_too() {
        insta::assert_snapshot!(screen(&after(&Session::in_steps(), 13, &[Action::Meter, Action::Push(Button::Start)]), 110, 30));
    }

    #[test]
    fn every_statement_is_listed_and_seen() {
        let session = Session::in_steps();
        let picture = after(&session, 1, &[]);
        let index = |line: &Line| if let Line::Statement { index, .. } = line { Some(*index) } else { None };
        let statements: Vec<u32> = picture.lines.iter().filter_map(index).collect();
        assert_eq!((statements.len(), picture.lines.len()), (15, 20));
        assert!(statements.iter().all(|&index| picture.seen(index).is_some()));
        session.act(Action::Mode).expect("the gate is open");
        let picture = { after(&session, 1, &[]) };
        assert!(statements.iter().all(|&index| picture.seen(index).is_none()), "a CPU in STOP executes nothing");
    }

    #[test]
    fn a_small_terminal_is_asked_to_grow() {
        let text = screen(&after(&Session::in_steps(), 1, &[]), 79, 10);
        assert!(text.contains("The demo needs 80 × 24 characters; this terminal has 79 × 10. Enlarge it,"), "{text}");
    }

    #[test]
    fn no_size_of_the_terminal_panics() {
        let session = Session::in_steps();
        let picture = after(&session, 1, &[]);
        for (width, height) in [(1, 1), (2, 50), (200, 1), (80, 24), (81, 25), (300, 100)] {
            screen(&picture, width, height);
        }
    }
}
