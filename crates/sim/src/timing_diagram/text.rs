//! Timing diagrams as text: bits as two lines, numbers as stairs, all else as a band with its values.

use super::axis::{self, Axis};
use super::lanes::{self, Columns, Lane, Lanes, Scale};
use super::{Options, shown};
use crate::names::{Kind, Sample};
use crate::trace::{Channel, Trace, TraceError};

/// Widest column of names, in characters.
const NAME_WIDTH_MAX: usize = 24;
/// Widest label of a scale, in characters.
const SCALE_WIDTH_MAX: usize = 12;
/// Lines of a number.
const STAIRS: usize = 3;
/// Most columns of a scan: a trace of a few scans is stretched so far and no further.
const COLUMNS_OF_SCAN_MAX: usize = 8;
/// Steps are not drawn one by one here.
const STEPS_MAX: usize = 0;

/// The diagram of a trace, with a line end behind each line.
///
/// # Errors
/// The trace cannot be read.
pub fn text(trace: &Trace, options: &Options) -> Result<String, TraceError> {
    if trace.summary().scans == 0 {
        return Ok("nothing was recorded\n".to_owned());
    }
    let range = options.window.clone().unwrap_or_else(|| trace.all());
    let axis = Axis::new(trace, &range)?;
    let names = trace.channels().iter().map(|channel| channel.name.chars().count()).max().unwrap_or(0).clamp(4, NAME_WIDTH_MAX);
    let scaled = trace
        .channels()
        .iter()
        .zip(&trace.summary().changes)
        .any(|(channel, changes)| *changes > 0 && !matches!(channel.kind, Kind::Bit | Kind::Text));
    let labels = if scaled { SCALE_WIDTH_MAX.min(options.width() / 6) } else { 0 };
    let gutter = names + labels + 2;
    let columns = Columns::fit(&axis, options.width().saturating_sub(gutter), COLUMNS_OF_SCAN_MAX);
    let drawn = lanes::collect(trace, &range, &axis, columns, STEPS_MAX, &options.cursors_us)?;

    // Now the labels are known: what they do not need is left free.
    let widest = |channel: &Channel, lane: &Lane| {
        let scale = lane.scale(channel)?;
        let width = |value: &Sample| shown(channel, value).chars().count();
        Some(width(scale.low_value).max(width(scale.high_value)))
    };
    let labels =
        trace.channels().iter().zip(&drawn.lanes).filter_map(|(channel, lane)| widest(channel, lane)).max().unwrap_or(0).min(labels);
    let mut page = Page { lines: Vec::new(), names, labels };
    marks(trace, options, &axis, columns, &mut page);
    for (channel, lane) in trace.channels().iter().zip(&drawn.lanes) {
        match lane.scale(channel) {
            Some(scale) => stairs(channel, lane, scale, &mut page),
            None if channel.kind == Kind::Bit => bit(channel, lane, &mut page),
            None => band(channel, lane, &mut page),
        }
    }
    ticks(&axis, columns, &mut page);
    let drew = |sign: char| page.lines.iter().any(|line| line.contains(sign));
    let legend = legend(&axis, columns, drew('▒'), drew('┴'));
    page.lines.push(legend);
    cursors(trace, options, &drawn, &mut page);
    let mut out = String::new();
    for line in &page.lines {
        out.push_str(line.trim_end());
        out.push('\n');
    }
    Ok(if options.ascii { out.chars().map(ascii).collect() } else { out })
}

/// The character of ASCII for one that draws.
fn ascii(c: char) -> char {
    match c {
        '─' => '-',
        '│' | '┤' | '├' => '|',
        '┌' | '┐' | '└' | '┘' | '┬' | '┴' | '┼' => '+',
        '▒' => '#',
        '▼' => 'v',
        '·' => '.',
        '…' => '~',
        'µ' => 'u',
        c => c,
    }
}

struct Page {
    lines: Vec<String>,
    names: usize,
    labels: usize,
}

impl Page {
    fn line(&mut self, name: &str, label: &str, drawn: &str) {
        let (name, label) = (clip(name, self.names), clip(label, self.labels));
        let (names, labels) = (self.names, self.labels);
        self.lines.push(format!("{name:<names$} {label:>labels$} {drawn}"));
    }
}

/// A text that is not longer than so many characters: names differ at their ends more often than in the middle.
fn clip(text: &str, width: usize) -> String {
    let count = text.chars().count();
    if count <= width {
        return text.to_owned();
    }
    let behind = width.saturating_sub(1) / 2;
    let before = width.saturating_sub(1) - behind;
    let head: String = text.chars().take(before).collect();
    let tail: String = text.chars().skip(count - behind).collect();
    if width == 0 { String::new() } else { format!("{head}…{tail}") }
}

fn bit(channel: &Channel, lane: &Lane, page: &mut Page) {
    let (mut top, mut bottom) = (String::new(), String::new());
    let mut before = None;
    for cell in &lane.cells {
        let now = match cell.last {
            Sample::Bits(bits) => Some(bits != 0),
            _ => None,
        };
        let (above, below) = match (before.unwrap_or(now), now) {
            _ if cell.is_crowded() => ('▒', '▒'),
            (_, None) => (' ', '·'),
            (Some(false), Some(true)) => ('┌', '┘'),
            (Some(true), Some(false)) => ('┐', '└'),
            (_, Some(true)) => ('─', ' '),
            (_, Some(false)) => (' ', '─'),
        };
        top.push(above);
        bottom.push(below);
        before = Some(now);
    }
    page.line("", "", &top);
    page.line(&channel.name, "", &bottom);
}

fn stairs(channel: &Channel, lane: &Lane, scale: Scale<'_>, page: &mut Page) {
    let mut rows = vec![vec![' '; lane.cells.len()]; STAIRS];
    // Row 0 is at the top.
    let row_of = |number: f64| STAIRS - 1 - (scale.place(number) * (STAIRS - 1) as f64).round() as usize;
    let mut before = None;
    for (column, cell) in lane.cells.iter().enumerate() {
        let now = cell.last.number(&channel.kind).map(row_of);
        match (before.unwrap_or(now), now) {
            _ if cell.is_crowded() => {
                let (low, high) = cell.extent.unwrap_or((scale.low, scale.high));
                rows[row_of(high)..=row_of(low)].iter_mut().for_each(|row| row[column] = '▒');
            }
            (_, None) => rows[STAIRS - 1][column] = '·',
            (Some(from), Some(to)) if from != to => {
                let (upper, lower) = (from.min(to), from.max(to));
                rows[upper..lower].iter_mut().for_each(|row| row[column] = '│');
                (rows[upper][column], rows[lower][column]) = if to < from { ('┌', '┘') } else { ('┐', '└') };
            }
            // A change too small for another line is still a change.
            (_, Some(row)) => rows[row][column] = if cell.changes > 0 { '┴' } else { '─' },
        }
        before = Some(now);
    }
    let label = |value: &Sample| shown(channel, value);
    for (index, row) in rows.iter().enumerate() {
        let (name, label) = match index {
            0 => ("", label(scale.high_value)),
            _ if index == STAIRS - 1 => (channel.name.as_str(), label(scale.low_value)),
            _ => ("", String::new()),
        };
        page.line(name, &label, &row.iter().collect::<String>());
    }
    let values = values(channel, lane, ' ', false);
    if !values.trim().is_empty() {
        page.line("", "", &values);
    }
}

fn band(channel: &Channel, lane: &Lane, page: &mut Page) {
    page.line(&channel.name, "", &values(channel, lane, '─', true));
}

/// The values, each where it begins, as far as there is room for it; `cut` ones are better than none.
fn values(channel: &Channel, lane: &Lane, fill: char, cut: bool) -> String {
    let mut out = String::new();
    let mut column = 0;
    while column < lane.cells.len() {
        let cell = &lane.cells[column];
        if cell.is_crowded() {
            out.push(if cut { '▒' } else { ' ' });
            column += 1;
            continue;
        }
        let width = 1 + lane.cells[column + 1..].iter().take_while(|next| next.changes == 0).count();
        let shown = shown(channel, &cell.last);
        let mut part = String::new();
        if cut {
            part.push(if cell.changes > 0 { '│' } else { '─' });
            part.push_str(&clip(&shown.replace(char::is_control, " "), width.saturating_sub(1)));
        } else if shown.chars().count() < width || column + width == lane.cells.len() && shown.chars().count() == width {
            part.push_str(&shown);
        }
        let used = part.chars().count();
        part.extend(std::iter::repeat_n(fill, width.saturating_sub(used)));
        out.push_str(&part);
        column += width;
    }
    out
}

/// The marks and the trigger, each in a line of its own.
fn marks(trace: &Trace, options: &Options, axis: &Axis, columns: Columns, page: &mut Page) {
    let trigger = trace.trigger().map(|moment| (moment, "trigger"));
    for (moment, label) in trigger.into_iter().chain(options.marks.iter().map(|mark| (mark.moment, mark.label.as_str()))) {
        let position = axis.position(moment);
        if !(axis.start..axis.end).contains(&position) {
            continue;
        }
        let column = columns.of(axis, position);
        let label = label.replace(char::is_control, " ");
        let length = label.chars().count();
        let room = options.width().saturating_sub(page.names + page.labels + 2);
        let pointer = " ".repeat(column);
        if column + 2 + length <= room {
            page.line("", "", &format!("{pointer}▼ {label}"));
        } else if length < column {
            page.line("", "", &format!("{}{label} ▼", " ".repeat(column - length - 1)));
        } else {
            page.lines.push(clip(&label, options.width()));
            page.line("", "", &format!("{pointer}▼"));
        }
    }
}

/// The axis with its labels.
fn ticks(axis: &Axis, columns: Columns, page: &mut Page) {
    /// Least distance of two labels, in columns.
    const DISTANCE: u64 = 10;
    let mut least = columns.positions.saturating_mul(DISTANCE).div_ceil(columns.columns as u64);
    loop {
        let interval = axis.interval(least);
        let (unit_name, unit) = axis.label_unit(interval);
        let mut line = vec!['─'; columns.count];
        let mut labels = vec![' '; columns.count];
        let mut free = 0;
        let mut position = axis.first_label(interval);
        let mut fits = true;
        while position < axis.end && fits {
            let column = columns.of(axis, position);
            line[column] = '┬';
            let label: Vec<char> = axis::label(position, unit).chars().collect();
            fits = column >= free;
            if fits && column + label.len() <= columns.count {
                labels[column..column + label.len()].copy_from_slice(&label);
            } else if fits && position == axis.start {
                // The only label may stand out behind a short axis.
                labels.resize(column + label.len(), ' ');
                labels[column..].copy_from_slice(&label);
            }
            free = column + label.len() + 1;
            let Some(next) = position.checked_add(interval) else { break };
            position = next;
        }
        if fits || interval >= axis.span() {
            page.line("", "", &line.iter().collect::<String>());
            page.line(unit_name, "", &labels.iter().collect::<String>());
            return;
        }
        least = interval.saturating_add(1);
    }
}

fn legend(axis: &Axis, columns: Columns, crowded: bool, small: bool) -> String {
    let scans = columns.positions / axis.unit;
    let scans = if scans == 1 { "1 scan".to_owned() } else { format!("{scans} scans") };
    let column = if columns.columns == 1 { "1 column".to_owned() } else { format!("{} columns", columns.columns) };
    let width = match (axis.by_scan, axis.regular) {
        (true, _) => scans,
        (false, true) => format!("{} ({scans})", axis::time(columns.positions)),
        (false, false) => axis::time(columns.positions),
    };
    let crowded = if crowded { "; ▒ several changes in one column" } else { "" };
    let small = if small { "; ┴ a change smaller than a line" } else { "" };
    format!("{column} = {width}{crowded}{small}")
}

/// The values at the cursors, below the diagram.
fn cursors(trace: &Trace, options: &Options, drawn: &Lanes, page: &mut Page) {
    for (time_us, values) in options.cursors_us.iter().zip(&drawn.cursors) {
        page.lines.push(format!("at {}:", axis::time(*time_us)));
        for (channel, value) in trace.channels().iter().zip(values) {
            let names = page.names;
            page.lines.push(format!("  {:<names$} = {}", channel.name, shown(channel, value)));
        }
    }
}
