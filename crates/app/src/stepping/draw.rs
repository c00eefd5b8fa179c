//! Draws the microscope.

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, BorderType, Clear, Paragraph, Wrap};
use sieben_workspace::session::texts::{self, pick};

use super::picture::{Focus, Picture, SourceLine, pointer};
use super::trail::Seen;
use super::words::{HELP, KEYS};

/// Smallest terminal that the picture fits into.
pub(super) const MIN_WIDTH: u16 = 80;
/// Its height.
pub(super) const MIN_HEIGHT: u16 = 24;
/// Registers and bits with their frames.
const SIDE_WIDTH: u16 = 28;
/// The same on a terminal that is wide.
const SIDE_WIDTH_WIDE: u16 = 40;
/// Columns from which on a terminal is.
const WIDE: u16 = 120;
/// The reason with its frame.
const REASON_HEIGHT: u16 = 5;
/// RLO, STA and ACCU 1 beside the source.
const COLUMNS_WIDTH: usize = 18;
/// Breakpoint, arrow, cursor and number of a line.
const MARKS_WIDTH: usize = 8;
/// Room for statements at least, where the terminal has it.
const TEXT_WIDTH: usize = 32;
/// Rows of a message at most.
const MESSAGE_ROWS: u16 = 5;

impl Picture {
    fn colour(&self, colour: Color) -> Style {
        if self.colour { Style::new().fg(colour) } else { Style::new() }
    }
    fn faint(&self) -> Style {
        if self.colour { Style::new().fg(Color::DarkGray) } else { Style::new().add_modifier(Modifier::DIM) }
    }
    fn frame(&self, title: String, focused: bool) -> Block<'static> {
        let style = if focused { self.colour(Color::Cyan) } else { self.faint() };
        let border = if focused { BorderType::Thick } else { BorderType::Rounded };
        Block::bordered().border_type(border).border_style(style).title(title)
    }
    fn say(&self, words: [&'static str; 2]) -> &'static str {
        pick(self.language, words)
    }
}

/// Lines of the source that an area of this height has room for.
pub(super) fn source_rows(height: u16) -> usize {
    usize::from(height.saturating_sub(REASON_HEIGHT + 4)).max(1)
}

/// Draws everything, or a request for more room.
pub(super) fn draw(frame: &mut Frame<'_>, picture: &Picture) {
    let area = frame.area();
    if area.width < MIN_WIDTH || area.height < MIN_HEIGHT {
        let text = match picture.say(["en", "de"]) {
            "de" => format!(
                "Das Mikroskop braucht {MIN_WIDTH} × {MIN_HEIGHT} Zeichen; dieses Terminal hat {} × {}. Vergrößern, oder q zum Beenden.",
                area.width, area.height
            ),
            _ => format!(
                "The microscope needs {MIN_WIDTH} × {MIN_HEIGHT} characters; this terminal has {} × {}. Enlarge it, or press q to quit.",
                area.width, area.height
            ),
        };
        frame.render_widget(Paragraph::new(text).wrap(Wrap { trim: true }), area);
        return;
    }
    let message = if picture.prompt.is_some() { Vec::new() } else { wrapped(&picture.message, area.width) };
    let foot = u16::try_from(message.len()).unwrap_or(MESSAGE_ROWS).clamp(1, MESSAGE_ROWS);
    let rows = [Constraint::Length(1), Constraint::Fill(1), Constraint::Length(REASON_HEIGHT), Constraint::Length(foot)];
    let [header, body, reason, keys] = Layout::vertical(rows).areas(area);
    let body = match &picture.diagram {
        Some((title, lines)) => {
            // A sentence instead of a diagram goes over several lines.
            let lines = if let [only] = lines.as_slice() { wrapped(only, area.width.saturating_sub(2)) } else { lines.clone() };
            let diagram = (title.clone(), lines);
            let room = body.height / 2;
            let height = u16::try_from(diagram.1.len() + 2).unwrap_or(u16::MAX).min(room);
            let [above, body] = Layout::vertical([Constraint::Length(height), Constraint::Fill(1)]).areas(body);
            draw_diagram(frame, above, picture, &diagram);
            body
        }
        None => body,
    };
    let side_width = if area.width >= WIDE { SIDE_WIDTH_WIDE } else { SIDE_WIDTH };
    let [source, side] = Layout::horizontal([Constraint::Fill(1), Constraint::Length(side_width)]).areas(body);
    draw_header(frame, header, picture);
    draw_source(frame, source, picture);
    draw_side(frame, side, picture);
    draw_reason(frame, reason, picture);
    draw_keys(frame, keys, picture, message);
    if picture.help {
        draw_help(frame, body, picture);
    }
}

/// What stands beside the source: registers or, in ST, variables, and below them bits and values.
fn draw_side(frame: &mut Frame<'_>, side: Rect, picture: &Picture) {
    if !picture.on_registers && picture.only_variables {
        return draw_variables(frame, side, picture);
    }
    let registers_height = if picture.four_accumulators { 12 } else { 10 };
    let wanted = 3 + picture.bytes.len() + picture.used.len() + picture.watched.len();
    let split = match picture.on_registers {
        true => [Constraint::Length(registers_height), Constraint::Fill(1)],
        false => [Constraint::Fill(1), Constraint::Length(u16::try_from(wanted).unwrap_or(u16::MAX).min(side.height / 2))],
    };
    let [above, below] = Layout::vertical(split).areas(side);
    match picture.on_registers {
        true => draw_registers(frame, above, picture),
        false => draw_variables(frame, above, picture),
    }
    match picture.on_registers && picture.only_variables {
        true => draw_variables(frame, below, picture),
        false => draw_values(frame, below, picture),
    }
}

fn draw_header(frame: &mut Frame<'_>, area: Rect, picture: &Picture) {
    let bold = Style::new().add_modifier(Modifier::BOLD);
    let view = &picture.view;
    let between = match view.position {
        0 => picture.say(["before the start", "vor dem Anlauf"]),
        _ => picture.say(["between two scans", "zwischen zwei Zyklen"]),
    };
    let stack = if picture.stack.is_empty() { between } else { &picture.stack };
    let left = Line::from(vec![Span::styled(" Sieben ", bold), Span::raw(stack.to_owned())]);
    let of = picture.say(["of", "von"]);
    let scan = match view.scan {
        Some(scan) => format!("{} {scan}", picture.say(["scan", "Zyklus"])),
        None => picture.say(["start", "Anlauf"]).to_owned(),
    };
    let milliseconds = view.time_us / 1_000;
    let now = if view.present { "" } else { picture.say(["past · ", "Vergangenheit · "]) };
    let right = format!("{now}{scan} · {milliseconds} ms · {} {of} {} · {} ", view.position, view.end, view.mode);
    frame.render_widget(Paragraph::new(Line::from(right).right_aligned()), area);
    frame.render_widget(Paragraph::new(left), Rect { width: area.width / 2, ..area });
}

/// The network as a diagram; what 1 carries is bold.
fn draw_diagram(frame: &mut Frame<'_>, area: Rect, picture: &Picture, (title, lines): &(String, Vec<String>)) {
    let block = picture.frame(format!(" {title} "), false);
    let on = picture.colour(Color::Green).add_modifier(Modifier::BOLD);
    let style = |line: char| match line {
        '═' | '║' => on,
        '┄' | '┆' | '·' => picture.faint(),
        _ => Style::new(),
    };
    let lines: Vec<Line<'_>> = lines
        .iter()
        .map(|line| Line::from(line.chars().map(|one| Span::styled(one.to_string(), style(one))).collect::<Vec<_>>()))
        .collect();
    frame.render_widget(Paragraph::new(lines).block(block), area);
}

fn draw_source(frame: &mut Frame<'_>, area: Rect, picture: &Picture) {
    let mut title = format!(" {} ", picture.file);
    if let Some(network) = picture.view.next.as_ref().or(picture.view.executed.as_ref()).and_then(|line| line.network) {
        title.push_str(&format!("· {} {network} ", picture.say(["network", "Netzwerk"])));
    }
    let block = picture.frame(title, picture.focus == Focus::Source);
    let inner = block.inner(area);
    let width = usize::from(inner.width);
    // The columns stand beside the statements, not at the far end of a wide terminal.
    let statements = picture.lines.iter().filter(|line| !line.text.trim_start().starts_with("//"));
    let longest = statements.map(|line| line.text.chars().count()).max().unwrap_or_default();
    let room = width.saturating_sub(COLUMNS_WIDTH + MARKS_WIDTH);
    let text_width = room.min(longest.max(TEXT_WIDTH));
    let width = text_width + COLUMNS_WIDTH + MARKS_WIDTH;
    let height = usize::from(inner.height);
    // The cursor stays in the middle third where the source is longer than the window.
    let top = |rows: usize| picture.cursor.saturating_sub(rows / 2).min(picture.lines.len().saturating_sub(rows));
    let has_columns = picture.lines.iter().skip(top(height)).take(height).any(|line| matches!(line.seen, Some(Seen::Registers(..))));
    let has_head = has_columns || picture.on_registers;
    let rows = if has_head { height.saturating_sub(1) } else { height };
    let top = top(rows);
    let head = format!("{:>width$}", picture.say(["RLO STA    ACCU1", "VKE STA    AKKU1"]), width = width);
    let mut lines = Vec::new();
    if has_head {
        lines.push(Line::styled(head, picture.faint()));
    }
    lines.extend(picture.lines.iter().skip(top).take(rows).map(|line| match line.seen {
        Some(Seen::Registers(..)) => source_line(line, text_width, picture),
        _ => source_line(line, usize::from(inner.width).saturating_sub(MARKS_WIDTH), picture),
    }));
    frame.render_widget(Paragraph::new(lines).block(block), area);
}

/// A message in lines of a width, broken between words where they fit: what it says last may be what was asked for.
fn wrapped(message: &str, width: u16) -> Vec<String> {
    let width = usize::from(width).max(2);
    let mut lines: Vec<String> = Vec::new();
    let words = message.lines().flat_map(|line| line.split_whitespace().enumerate());
    for (index, word) in words {
        let mut word: Vec<char> = word.chars().collect();
        if let Some(line) = lines.last_mut().filter(|_| index > 0)
            && line.chars().count() + 1 + word.len() <= width
        {
            line.extend(std::iter::once(' ').chain(word));
            continue;
        }
        while word.len() > width - 1 {
            lines.push(std::iter::once(' ').chain(word.drain(..width - 1)).collect());
        }
        lines.push(std::iter::once(' ').chain(word).collect());
    }
    lines
}

fn source_line(line: &SourceLine, width: usize, picture: &Picture) -> Line<'static> {
    let text: String = line.text.chars().take(width).collect();
    let marks = [
        Span::styled(if line.breakpoint { "●" } else { " " }, picture.colour(Color::Red)),
        Span::styled(
            if line.next {
                "▶"
            } else if line.executed {
                "•"
            } else {
                " "
            },
            picture.colour(Color::Yellow),
        ),
        Span::styled(if line.cursor { "›" } else { " " }, picture.colour(Color::Cyan)),
        Span::styled(format!("{:>4} ", line.number), picture.faint()),
    ];
    let mut style = Style::new();
    if line.next {
        style = style.add_modifier(Modifier::BOLD);
    }
    if line.cursor {
        style = style.add_modifier(Modifier::UNDERLINED);
    }
    let mut spans = Vec::from(marks);
    let (rlo, sta, accu1) = match &line.seen {
        Some(Seen::Registers(rlo, sta, accu1)) => (*rlo, *sta, *accu1),
        Some(Seen::Values(values)) => {
            let (text, values) = text_and_values(&line.text, values, width);
            spans.extend([Span::styled(text, style), Span::styled(values, picture.colour(Color::Green))]);
            return Line::from(spans);
        }
        None => {
            spans.push(Span::styled(text, style));
            return Line::from(spans);
        }
    };
    // An RLO of 1 shows in its column and, as with power that flows, in green.
    let on = picture.colour(Color::Green);
    spans.push(Span::styled(format!("{text:<width$}"), if rlo == 1 { style.patch(on) } else { style }));
    let bit = |bit: u64| Span::styled(format!("{bit:>4}"), if bit == 1 { on.add_modifier(Modifier::BOLD) } else { picture.faint() });
    spans.extend([bit(rlo), bit(sta), Span::styled(format!("  {accu1:08X}"), picture.faint())]);
    Line::from(spans)
}

/// A line and the values after it, as a comment; where both do not fit the values give way first, down to two fifths of the room.
fn text_and_values(text: &str, values: &str, width: usize) -> (String, String) {
    let values = format!("  // {values}");
    let (text_length, values_length) = (text.chars().count(), values.chars().count());
    let cut = |text: &str, room: usize| match text.chars().count() > room {
        true => text.chars().take(room.saturating_sub(1)).chain(['…']).collect(),
        false => text.to_owned(),
    };
    let for_values = values_length.min(width.saturating_sub(text_length).max(width * 2 / 5));
    (cut(text, width.saturating_sub(for_values)), cut(&values, for_values))
}

fn draw_registers(frame: &mut Frame<'_>, area: Rect, picture: &Picture) {
    let block = picture.frame(format!(" {} ", picture.say(["Registers", "Register"])), false);
    let registers = &picture.registers;
    let german = picture.say(["", "de"]) == "de";
    let name = |english: &'static str, other: &'static str| if german { other } else { english };
    let changed = |names: [&str; 2]| picture.view.changed.iter().any(|change| names.contains(&change.name.as_str()));
    let bit = |label: &'static str, names: [&str; 2], value: u64| {
        let style = if changed(names) { Style::new().add_modifier(Modifier::BOLD | Modifier::REVERSED) } else { Style::new() };
        [Span::raw(format!("{label} ")), Span::styled(value.to_string(), style), Span::raw("  ")]
    };
    let value = |label: &'static str, names: [&str; 2], value: String| {
        let style = if changed(names) { Style::new().add_modifier(Modifier::BOLD | Modifier::REVERSED) } else { Style::new() };
        Line::from(vec![Span::raw(format!("{label:<6}")), Span::styled(value, style)])
    };
    let accumulator = |bits: u64| {
        let bits = bits as u32;
        format!("{bits:08X} {}", bits as i32)
    };
    let mut lines = vec![
        Line::from(
            [
                bit(name("RLO", "VKE"), ["RLO", "VKE"], registers.rlo),
                bit("STA", ["STA", ""], registers.sta),
                bit(name("/FC", "/ER"), ["/FC", "/ER"], registers.fc),
            ]
            .concat(),
        ),
        Line::from(
            [
                bit("OR", ["OR", ""], registers.or),
                bit(name("BR", "BIE"), ["BR", "BIE"], registers.br),
                bit("OV", ["OV", ""], registers.ov),
                bit("OS", ["OS", ""], registers.os),
            ]
            .concat(),
        ),
        Line::from([bit(name("CC1", "A1"), ["CC", "CC1"], registers.cc1), bit(name("CC0", "A0"), ["CC", "CC0"], registers.cc0)].concat()),
        value(name("ACCU1", "AKKU1"), ["ACCU1", ""], accumulator(registers.accu1)),
        value(name("ACCU2", "AKKU2"), ["ACCU2", ""], accumulator(registers.accu2)),
    ];
    if picture.four_accumulators {
        lines.push(value(name("ACCU3", "AKKU3"), ["ACCU3", ""], accumulator(registers.accu3)));
        lines.push(value(name("ACCU4", "AKKU4"), ["ACCU4", ""], accumulator(registers.accu4)));
    }
    lines.push(value("AR1", ["AR1", ""], pointer(registers.ar1)));
    lines.push(value("AR2", ["AR2", ""], pointer(registers.ar2)));
    lines.push(value("DB/DI", ["DB", "DI"], format!("{} {}", registers.db_number, registers.di_number)));
    frame.render_widget(Paragraph::new(lines).block(block), area);
}

/// The variables of blocks; the names give way to the values.
fn draw_variables(frame: &mut Frame<'_>, area: Rect, picture: &Picture) {
    let of = |name: &String| texts::fill(picture.language, texts::VARIABLES_OF, &[name]);
    let title = picture.variables.first().map_or_else(|| picture.say(texts::NOTHING_KEPT).to_owned(), |(name, _)| of(name));
    let block = picture.frame(format!(" {title} "), false);
    let inner = block.inner(area);
    let (rows, width) = (usize::from(inner.height), usize::from(inner.width));
    // Where the bits have room of their own the watched values stand there.
    let for_watched = if picture.only_variables { picture.watched.len().min(rows / 3) } else { 0 };
    let room = rows - for_watched;
    let mut all: Vec<Line<'_>> = Vec::new();
    for (index, (name, values)) in picture.variables.iter().enumerate() {
        if index > 0 {
            all.push(Line::styled(of(name), picture.faint()));
        }
        all.extend(values.iter().map(|(name, value)| Line::from(pair(name, value, width))));
    }
    let shown = if all.len() > room { room.saturating_sub(1) } else { room };
    let hidden = all.len().saturating_sub(shown);
    let mut lines: Vec<Line<'_>> = all.into_iter().take(shown).collect();
    if hidden > 0 {
        lines.push(Line::styled(format!("… {hidden} :locals"), picture.faint()));
    }
    let skipped = picture.watched.len() - for_watched;
    lines.extend(picture.watched.iter().skip(skipped).map(|(name, value)| Line::from(format!("{name} = {value}"))));
    frame.render_widget(Paragraph::new(lines).block(block), area);
}

/// A name and, at the right, its value; the name gives way.
fn pair(name: &str, value: &str, width: usize) -> String {
    let value_width = value.chars().count().min(width);
    let left = width.saturating_sub(value_width + 1);
    let name: String = name.chars().take(left).collect();
    format!("{name:<left$} {value}")
}

fn draw_values(frame: &mut Frame<'_>, area: Rect, picture: &Picture) {
    let block = picture.frame(format!(" {} ", picture.say(["Bits and values", "Bits und Werte"])), picture.focus == Focus::Bits);
    let rows = usize::from(block.inner(area).height);
    let mut lines = vec![Line::styled("       7654 3210", picture.faint())];
    // Watched values have room of their own, and of what the program uses there is always something to be seen, and the chosen byte.
    let for_watched = picture.watched.len().min(rows.saturating_sub(1) / 2);
    let left = rows.saturating_sub(1 + for_watched);
    let for_used = picture.used.len().min(left.saturating_sub(picture.bytes.len()).max(left / 2));
    let for_bytes = left - for_used;
    let chosen = picture.bytes.iter().position(|byte| byte.chosen.is_some()).unwrap_or(0);
    let first = (chosen + 1).saturating_sub(for_bytes);
    for byte in picture.bytes.iter().skip(first).take(for_bytes) {
        let mut spans = vec![Span::raw(format!("{:<7}", byte.name))];
        for bit in (0..8).rev() {
            let is_one = byte.bits >> bit & 1 == 1;
            let mut style = if is_one { picture.colour(Color::Green).add_modifier(Modifier::BOLD) } else { picture.faint() };
            if byte.chosen.is_some_and(|(chosen, _)| chosen == bit) {
                style = style.add_modifier(Modifier::REVERSED);
            }
            spans.push(Span::styled(if is_one { "1" } else { "0" }, style));
            if bit == 4 {
                spans.push(Span::raw(" "));
            }
        }
        if let Some((bit, pending)) = byte.chosen {
            let pending = pending.map_or_else(String::new, |value| format!(" → {}", u8::from(value)));
            spans.push(Span::styled(format!("  .{bit}{pending}"), picture.colour(Color::Cyan)));
        }
        lines.push(Line::from(spans));
    }
    let width = usize::from(block.inner(area).width);
    lines.extend(picture.used.iter().take(for_used).map(|(name, value)| Line::from(pair(name, value, width))));
    let skipped = picture.watched.len().saturating_sub(for_watched.max(rows.saturating_sub(lines.len())));
    lines.extend(picture.watched.iter().skip(skipped).map(|(name, value)| Line::from(format!("{name} = {value}"))));
    frame.render_widget(Paragraph::new(lines).block(block), area);
}

fn draw_reason(frame: &mut Frame<'_>, area: Rect, picture: &Picture) {
    let block = picture.frame(format!(" {} ", picture.say(["Why", "Warum"])), false);
    let mut lines = Vec::new();
    if picture.statement.is_empty() {
        lines.push(Line::from(picture.say(["nothing has run yet", "noch ist nichts gelaufen"])));
    } else {
        let bold = Style::new().add_modifier(Modifier::BOLD);
        lines.push(Line::from(vec![Span::styled(picture.statement.clone(), bold), Span::raw(format!(": {}", picture.reason))]));
    }
    let is_register = |name: &str| picture.view.registers.iter().any(|(register, _)| *register == name);
    let changed = picture.view.changed.iter().filter(|change| !is_register(&change.name));
    let changed: Vec<String> = changed.map(|change| format!("{}: {} → {}", change.name, change.before, change.after)).collect();
    if !changed.is_empty() {
        lines.push(Line::styled(changed.join("; "), picture.colour(Color::Yellow)));
    }
    frame.render_widget(Paragraph::new(lines).wrap(Wrap { trim: true }).block(block), area);
}

fn draw_keys(frame: &mut Frame<'_>, area: Rect, picture: &Picture, message: Vec<String>) {
    if let Some(prompt) = &picture.prompt {
        frame.render_widget(Paragraph::new(format!(" : {prompt}▏")), area);
        return;
    }
    if !message.is_empty() {
        let lines: Vec<Line<'_>> = message.into_iter().map(|line| Line::styled(line, picture.colour(Color::Yellow))).collect();
        frame.render_widget(Paragraph::new(lines), area);
        return;
    }
    let mut spans = vec![Span::raw(" ")];
    for (key, words) in KEYS {
        spans.push(Span::styled(key, picture.colour(Color::Cyan).add_modifier(Modifier::BOLD)));
        spans.push(Span::raw(format!(" {}  ", picture.say(words))));
    }
    frame.render_widget(Paragraph::new(Line::from(spans)), area);
}

fn draw_help(frame: &mut Frame<'_>, area: Rect, picture: &Picture) {
    let block = picture.frame(format!(" {} ", picture.say(["Keys", "Tasten"])), true);
    let lines: Vec<Line<'_>> = HELP.iter().map(|(keys, words)| Line::from(format!("{keys:<14} {}", picture.say(*words)))).collect();
    frame.render_widget(Clear, area);
    frame.render_widget(Paragraph::new(lines).wrap(Wrap { trim: false }).block(block), area);
}
