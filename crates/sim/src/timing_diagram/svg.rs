//! Timing diagrams as SVG: steps and nothing between them, light or dark as the reader prefers, no script.

use std::fmt::Write as _;

use sieben_model::visible;

use super::axis::{self, Axis};
use super::lanes::{self, Columns, Lane, Lanes, Scale};
use super::{Options, shown};
use crate::names::{Kind, Sample};
use crate::trace::{Channel, Trace, TraceError};

/// Width of a character of the labels, in pixels: enough for most fonts.
const CHARACTER: f64 = 7.0;
/// Longest name or value that is written, in characters; the tooltip has the rest.
const CHARACTERS_MAX: usize = 32;
/// Heights of lanes, in pixels.
const BIT: f64 = 34.0;
const STAIRS: f64 = 70.0;
const BAND: f64 = 34.0;
/// Height of a line of labels.
const LINE: f64 = 18.0;
/// Room above and below what is drawn in a lane.
const MARGIN: f64 = 8.0;
/// Steps that are drawn one by one in the whole diagram: a few megabytes.
const STEPS_MAX: usize = 20_000;
/// Steps of one lane that always are.
const STEPS_OF_LANE: usize = 64;
/// Least distance of two labels of the axis, in pixels.
const TICKS: f64 = 70.0;

const STYLE: &str = "\
.sieben{--paper:#fff;--ink:#1f2328;--soft:#59636e;--faint:#d9dee3;--line:#0550ae;--fill:#0550ae22;--mark:#cf222e;--cursor:#8250df;font:12px ui-monospace,Menlo,Consolas,monospace}
@media(prefers-color-scheme:dark){.sieben{--paper:#0d1117;--ink:#e6edf3;--soft:#9198a1;--faint:#2f353d;--line:#79c0ff;--fill:#79c0ff2b;--mark:#ff7b72;--cursor:#d2a8ff}}
.sieben .paper{fill:var(--paper)}
.sieben text{fill:var(--ink)}
.sieben .soft{fill:var(--soft)}
.sieben .grid{stroke:var(--faint);fill:none}
.sieben .line{stroke:var(--line);stroke-width:1.5;fill:none}
.sieben .high{fill:var(--fill)}
.sieben .crowd{fill:var(--line);opacity:.45}
.sieben .gone{stroke:var(--soft);stroke-dasharray:2 3;fill:none}
.sieben .step{fill:transparent}
.sieben .step:hover{fill:var(--fill)}
.sieben .mark{stroke:var(--mark);stroke-dasharray:5 3}
.sieben text.mark{fill:var(--mark);stroke:none}
.sieben .cursor{stroke:var(--cursor)}
.sieben text.cursor{fill:var(--cursor);stroke:none}
.sieben .tag{fill:var(--paper);opacity:.85}
";

/// The diagram of a trace.
///
/// # Errors
/// The trace cannot be read.
pub fn svg(trace: &Trace, options: &Options) -> Result<String, TraceError> {
    let range = options.window.clone().unwrap_or_else(|| trace.all());
    let axis = Axis::new(trace, &range)?;
    let longest = trace.channels().iter().map(|channel| channel.name.chars().count()).max().unwrap_or(0).min(CHARACTERS_MAX);
    let names = (longest as f64 * CHARACTER).max(60.0) + 16.0;
    let scaled = trace
        .channels()
        .iter()
        .zip(&trace.summary().changes)
        .any(|(channel, changes)| *changes > 0 && !matches!(channel.kind, Kind::Bit | Kind::Text));
    let left = names + if scaled { 12.0 * CHARACTER } else { 0.0 };
    let width = (options.width() as f64).max(left + 200.0);
    let plot = width - left - 16.0;
    let columns = Columns::fit(&axis, plot as usize, 1);
    let steps_max = (STEPS_MAX / trace.channels().len().max(1)).max(STEPS_OF_LANE);
    let drawn = lanes::collect(trace, &range, &axis, columns, steps_max, &options.cursors_us)?;

    let marks = usize::from(trace.trigger().is_some()) + options.marks.len() + usize::from(!options.cursors_us.is_empty());
    let top = MARGIN + marks as f64 * LINE;
    let heights: Vec<f64> = trace.channels().iter().zip(&drawn.lanes).map(|(channel, lane)| height(channel, lane)).collect();
    let bottom = top + heights.iter().sum::<f64>();
    let total = bottom + 2.0 * LINE + MARGIN;
    let mut page = Page { out: String::new(), axis: &axis, left, plot, top, bottom };
    let _ = write!(
        page.out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"sieben\" width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {w} {h}\" role=\"img\">\n<title>{}</title>\n<style>\n{STYLE}</style>\n<rect class=\"paper\" width=\"{w}\" height=\"{h}\"/>\n",
        escape(&title(trace)),
        w = number(width),
        h = number(total),
    );
    if trace.summary().scans == 0 {
        let _ = writeln!(page.out, "<text x=\"8\" y=\"{}\">nothing was recorded</text>\n</svg>", number(top + LINE));
        return Ok(page.out);
    }
    page.ticks();
    let mut y = top;
    for ((channel, lane), height) in trace.channels().iter().zip(&drawn.lanes).zip(&heights) {
        page.lane(channel, lane, columns, y, *height);
        y += height;
    }
    page.marks(trace, options);
    page.cursors(trace, options, &drawn, &heights);
    page.out.push_str("</svg>\n");
    Ok(page.out)
}

fn title(trace: &Trace) -> String {
    let names: Vec<&str> = trace.channels().iter().map(|channel| channel.name.as_str()).take(8).collect();
    format!("Timing diagram: {}{}", names.join(", "), if trace.channels().len() > 8 { " …" } else { "" })
}

fn height(channel: &Channel, lane: &Lane) -> f64 {
    match channel.kind {
        Kind::Bit => BIT,
        _ if lane.scale(channel).is_some() => STAIRS,
        _ => BAND,
    }
}

struct Page<'a> {
    out: String,
    axis: &'a Axis,
    left: f64,
    plot: f64,
    top: f64,
    bottom: f64,
}

impl Page<'_> {
    fn x(&self, position: u64) -> f64 {
        self.left + position.saturating_sub(self.axis.start) as f64 * self.plot / self.axis.span() as f64
    }

    /// A position as a reader wants it.
    fn moment(&self, position: u64) -> String {
        if self.axis.by_scan { format!("scan {position}") } else { axis::time(position) }
    }

    fn ticks(&mut self) {
        let axis = self.axis;
        let least = (TICKS * axis.span() as f64 / self.plot).ceil() as u64;
        let interval = axis.interval(least.max(1));
        let (unit_name, unit) = axis.label_unit(interval);
        let (top, bottom) = (number(self.top), number(self.bottom));
        let mut position = axis.first_label(interval);
        let mut lines = String::new();
        while position < axis.end {
            let x = number(self.x(position));
            let _ = write!(lines, "M{x} {top}V{bottom}");
            let y = number(self.bottom + LINE);
            let label = axis::label(position, unit);
            let _ = writeln!(self.out, "<text class=\"soft\" x=\"{x}\" y=\"{y}\" text-anchor=\"middle\">{label}</text>");
            let Some(next) = position.checked_add(interval) else { break };
            position = next;
        }
        let (right, y) = (number(self.left + self.plot), number(self.bottom + 2.0 * LINE));
        let _ = writeln!(self.out, "<path class=\"grid\" d=\"{lines}M{} {bottom}H{right}\"/>", number(self.left));
        let _ = writeln!(self.out, "<text class=\"soft\" x=\"{right}\" y=\"{y}\" text-anchor=\"end\">{unit_name}</text>");
    }

    fn lane(&mut self, channel: &Channel, lane: &Lane, columns: Columns, y: f64, height: f64) {
        let middle = number(y + height / 2.0 + 4.0);
        let name = escape(&clip(&channel.name, CHARACTERS_MAX));
        let _ = writeln!(self.out, "<text x=\"8\" y=\"{middle}\">{name}<title>{}</title></text>", escape(&channel.name));
        let scale = lane.scale(channel);
        if let Some(scale) = scale {
            for (value, y) in [(scale.high_value, y + MARGIN + 4.0), (scale.low_value, y + height - MARGIN + 4.0)] {
                let (x, y) = (number(self.left - 8.0), number(y));
                let label = escape(&clip(&shown(channel, value), 11));
                let _ = writeln!(self.out, "<text class=\"soft\" x=\"{x}\" y=\"{y}\" text-anchor=\"end\">{label}</text>");
            }
        }
        let level = Level { channel, scale, low: y + height - MARGIN, high: y + MARGIN };
        if lane.steps.is_empty() {
            self.crowded(lane, columns, &level);
        } else {
            self.steps(lane, &level);
        }
    }

    /// Every step, with its value where there is room and in a tooltip.
    fn steps(&mut self, lane: &Lane, level: &Level<'_>) {
        let (mut line, mut gone, mut high) = (String::new(), String::new(), String::new());
        let (mut labels, mut tips) = (String::new(), String::new());
        let mut joined = false;
        for (index, step) in lane.steps.iter().enumerate() {
            let end = lane.steps.get(index + 1).map_or(self.axis.end, |next| next.position);
            let (from, to) = (self.x(step.position), self.x(end));
            let (x, next) = (number(from), number(to));
            let shown = shown(level.channel, &step.value);
            match level.of(&step.value) {
                None => {
                    let _ = write!(gone, "M{x} {}H{next}", number(level.low));
                    joined = false;
                }
                Some(Place::At(at)) => {
                    let at = number(at);
                    let _ = if joined { write!(line, "V{at}H{next}") } else { write!(line, "M{x} {at}H{next}") };
                    joined = true;
                    if step.value == Sample::Bits(1) && level.channel.kind == Kind::Bit {
                        let _ = write!(high, "M{x} {at}H{next}V{}H{x}Z", number(level.low));
                    }
                    if level.scale.is_some() {
                        self.label(&mut labels, &shown, from, to, level, &step.value);
                    }
                }
                Some(Place::Band) => {
                    let (top, bottom) = (number(level.high), number(level.low));
                    let _ = write!(line, "M{x} {top}H{next}V{bottom}H{x}Z");
                    let room = ((to - from - 8.0) / CHARACTER).max(0.0) as usize;
                    if room >= 2 || shown.chars().count() <= room {
                        let (x, y) = (number(from + 5.0), number((level.high + level.low) / 2.0 + 4.0));
                        let _ = writeln!(labels, "<text x=\"{x}\" y=\"{y}\">{}</text>", escape(&clip(&shown, room.min(CHARACTERS_MAX))));
                    }
                }
            }
            let (y, w, h) = (number(level.high - 4.0), number(to - from), number(level.low - level.high + 8.0));
            let times = format!("{} to {}", self.moment(step.position), self.moment(end));
            let tip = escape(&format!("{} = {shown}, {times}", level.channel.name));
            let _ = writeln!(tips, "<rect class=\"step\" x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\"><title>{tip}</title></rect>");
        }
        for (class, path) in [("high", high), ("line", line), ("gone", gone)] {
            if !path.is_empty() {
                let _ = writeln!(self.out, "<path class=\"{class}\" d=\"{path}\"/>");
            }
        }
        self.out.push_str(&labels);
        self.out.push_str(&tips);
    }

    /// The value of a step of a number, above its line or below where that is the upper edge.
    fn label(&self, labels: &mut String, shown: &str, from: f64, to: f64, level: &Level<'_>, value: &Sample) {
        let Some(Place::At(at)) = level.of(value) else { return };
        if shown.chars().count() as f64 * CHARACTER + 6.0 > to - from {
            return;
        }
        let y = if at - level.high < 12.0 { at + 14.0 } else { at - 4.0 };
        let _ = writeln!(labels, "<text x=\"{}\" y=\"{}\">{}</text>", number(from + 4.0), number(y), escape(shown));
    }

    /// A lane with too many steps: columns, and those with several changes filled from the least to the greatest value.
    fn crowded(&mut self, lane: &Lane, columns: Columns, level: &Level<'_>) {
        let (mut line, mut crowd) = (String::new(), String::new());
        let mut joined = false;
        for (index, cell) in lane.cells.iter().enumerate() {
            let position = self.axis.start.saturating_add(columns.positions.saturating_mul(index as u64));
            let end = position.saturating_add(columns.positions).min(self.axis.end);
            let (x, next) = (number(self.x(position)), number(self.x(end)));
            let place = level.of(&cell.last);
            if cell.is_crowded() || matches!(place, None | Some(Place::Band)) && cell.changes > 0 {
                let (high, low) = level.extent(cell.extent);
                let _ = write!(crowd, "M{x} {}H{next}V{}H{x}Z", number(high - 0.75), number(low + 0.75));
                joined = false;
            } else if let Some(Place::At(at)) = place {
                let at = number(at);
                let _ = if joined { write!(line, "V{at}H{next}") } else { write!(line, "M{x} {at}H{next}") };
                joined = true;
            } else {
                joined = false;
            }
        }
        let tip = escape(&format!("{}: {} changes, too many to be drawn one by one", level.channel.name, lane.changes));
        let _ = writeln!(self.out, "<path class=\"line\" d=\"{line}\"/>\n<path class=\"crowd\" d=\"{crowd}\"><title>{tip}</title></path>");
    }

    fn marks(&mut self, trace: &Trace, options: &Options) {
        let mut y = MARGIN + 12.0 + if options.cursors_us.is_empty() { 0.0 } else { LINE };
        let trigger = trace.trigger().map(|moment| (moment, "trigger"));
        for (moment, label) in trigger.into_iter().chain(options.marks.iter().map(|mark| (mark.moment, mark.label.as_str()))) {
            let position = self.axis.position(moment);
            if (self.axis.start..self.axis.end).contains(&position) {
                let x = self.x(position);
                self.pointer("mark", x, y, label);
            }
            y += LINE;
        }
    }

    /// A line through all lanes with a text at its upper end.
    fn pointer(&mut self, class: &str, x: f64, y: f64, label: &str) {
        // A text that would stand out on the right stands on the left.
        let room = ((x.max(self.left + self.plot - x + self.left) - self.left) / CHARACTER) as usize;
        let label = clip(label, room.max(12));
        let wide = label.chars().count() as f64 * CHARACTER > self.left + self.plot - x;
        let (anchor, at) = if wide { ("end", x - 4.0) } else { ("start", x + 4.0) };
        let (at, y, line, bottom) = (number(at), number(y), number(x), number(self.bottom));
        let _ = writeln!(
            self.out,
            "<path class=\"{class}\" d=\"M{line} {}V{bottom}\"/>\n<text class=\"{class}\" x=\"{at}\" y=\"{y}\" text-anchor=\"{anchor}\">{}</text>",
            number(self.top - LINE),
            escape(&label)
        );
    }

    fn cursors(&mut self, trace: &Trace, options: &Options, drawn: &Lanes, heights: &[f64]) {
        for (time_us, values) in options.cursors_us.iter().zip(&drawn.cursors) {
            if self.axis.by_scan || !(self.axis.start..self.axis.end).contains(time_us) {
                continue;
            }
            let x = self.x(*time_us);
            self.pointer("cursor", x, MARGIN + 12.0, &axis::time(*time_us));
            let mut y = self.top;
            for ((channel, value), height) in trace.channels().iter().zip(values).zip(heights) {
                let shown = clip(&shown(channel, value), CHARACTERS_MAX);
                let length = shown.chars().count() as f64 * CHARACTER + 4.0;
                let at = if x + length + 4.0 > self.left + self.plot { x - length - 3.0 } else { x + 3.0 };
                let line = y + height / 2.0;
                let _ = writeln!(
                    self.out,
                    "<rect class=\"tag\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"15\"/><text class=\"cursor\" x=\"{}\" y=\"{}\">{}</text>",
                    number(at),
                    number(line - 7.5),
                    number(length),
                    number(at + 2.0),
                    number(line + 4.0),
                    escape(&shown)
                );
                y += height;
            }
        }
    }
}

/// Where the values of a lane lie.
struct Level<'a> {
    channel: &'a Channel,
    scale: Option<Scale<'a>>,
    low: f64,
    high: f64,
}

enum Place {
    At(f64),
    /// Between two lines, with the value as text.
    Band,
}

impl Level<'_> {
    fn of(&self, value: &Sample) -> Option<Place> {
        match (value, &self.scale) {
            (Sample::Absent, _) => None,
            (Sample::Bits(bits), _) if self.channel.kind == Kind::Bit => Some(Place::At(if *bits != 0 { self.high } else { self.low })),
            (_, Some(scale)) => value.number(&self.channel.kind).map(|number| Place::At(self.at(scale, number))),
            (_, None) => Some(Place::Band),
        }
    }

    fn at(&self, scale: &Scale<'_>, number: f64) -> f64 {
        self.low - scale.place(number) * (self.low - self.high)
    }

    /// The upper and the lower edge of what was reached.
    fn extent(&self, extent: Option<(f64, f64)>) -> (f64, f64) {
        match (&self.scale, extent) {
            (Some(scale), Some((low, high))) => (self.at(scale, high), self.at(scale, low)),
            _ => (self.high, self.low),
        }
    }
}

/// A coordinate with at most two digits behind the point.
fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn clip(text: &str, characters: usize) -> String {
    if text.chars().count() <= characters {
        return text.to_owned();
    }
    text.chars().take(characters.saturating_sub(1)).chain(std::iter::once('…')).collect()
}

/// Text inside an element; what XML does not have becomes a space, what is hidden is shown.
fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\n' | '\t' | '\u{FFFE}' | '\u{FFFF}' => out.push(' '),
            c if visible::is_hidden(c) => visible::push(&mut out, c),
            c => out.push(c),
        }
    }
    out
}
