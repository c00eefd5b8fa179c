//! A diagram as SVG, without styles of its own and without script: classes, and the element, flow and value of each symbol as attributes.
//!
//! A page changes `data-flow` and `data-value` instead of drawing again. [`STYLE`](super::style::STYLE) makes it look as it does.

use std::fmt::Write as _;

use super::flow::Flow;
use super::layout::{Label, Layout, NetId, Outline, Role, Side, Symbol};
use super::style::STYLE;

/// Pixels of a column.
const COLUMN: usize = 8;
/// Pixels of a line.
const LINE: usize = 18;
/// Pixels around a diagram.
const MARGIN: usize = 6;
/// Half the height of a contact or coil.
const HALF: usize = 7;

/// A diagram with what its lines carry.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// What it is, said in a sentence: `Network 3 as ladder diagram`.
    pub title: &'a str,
    /// The diagram.
    pub layout: &'a Layout,
    /// What its nets carry, if that is known.
    pub flows: Option<&'a [Flow]>,
}

/// Pixels of a picture.
fn size(layout: &Layout) -> (usize, usize) {
    (layout.columns * COLUMN + 2 * MARGIN, layout.lines.max(1) * LINE + 2 * MARGIN)
}

/// A text as markup: nothing in it can end an element or an attribute, and it has only characters that XML allows.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\t' | '\n' => out.push(character),
            '\u{FFFE}' | '\u{FFFF}' => out.push('\u{FFFD}'),
            other if other.is_control() => out.push('\u{FFFD}'),
            other => out.push(other),
        }
    }
    out
}

/// A picture for a page that has the style sheet.
pub fn svg(picture: &Picture<'_>) -> String {
    let mut out = String::new();
    let (width, height) = size(picture.layout);
    let title = escaped(picture.title);
    let _ = writeln!(
        out,
        r#"<svg xmlns="http://www.w3.org/2000/svg" class="diagram" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" aria-label="{title}">"#
    );
    draw(picture, &mut out);
    out.push_str("</svg>\n");
    out
}

/// Pictures under one another as a file of its own, each below its title.
pub fn stand_alone(pictures: &[Picture<'_>]) -> String {
    let sizes: Vec<(usize, usize)> = pictures.iter().map(|picture| size(picture.layout)).collect();
    let titles = pictures.iter().map(|picture| (unicode_width::UnicodeWidthStr::width(picture.title) + 2) * COLUMN);
    let width = sizes.iter().map(|size| size.0).chain(titles).max().unwrap_or(0);
    let height: usize = sizes.iter().map(|size| size.1 + LINE + MARGIN).sum::<usize>() + MARGIN;
    let title = escaped(&pictures.iter().map(|picture| picture.title).collect::<Vec<_>>().join("; "));
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"diagram\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" role=\"img\" aria-label=\"{title}\">\n<style>{STYLE}</style>\n<rect class=\"paper\" width=\"{width}\" height=\"{height}\"/>\n"
    );
    let mut top = MARGIN;
    for (picture, size) in pictures.iter().zip(sizes) {
        let _ = writeln!(out, "<text class=\"heading\" x=\"{MARGIN}\" y=\"{}\">{}</text>", top + 13, escaped(picture.title));
        let _ = writeln!(out, "<svg y=\"{}\" width=\"{}\" height=\"{}\">", top + LINE, size.0, size.1);
        draw(picture, &mut out);
        out.push_str("</svg>\n");
        top += size.1 + LINE + MARGIN;
    }
    out.push_str("</svg>\n");
    out
}

/// The middle of a column.
fn x(column: usize) -> usize {
    column * COLUMN + COLUMN / 2 + MARGIN
}

/// The middle of a line.
fn y(line: usize) -> usize {
    line * LINE + LINE / 2 + MARGIN
}

impl Picture<'_> {
    /// What `data-flow` says: nothing where no moment is shown.
    fn flow(&self, net: Option<NetId>) -> &'static str {
        match (self.flows, net) {
            (Some(flows), Some(net)) => flows.get(net.0 as usize).map_or(Flow::Unknown.word(), |flow| flow.word()),
            _ => "",
        }
    }
}

fn draw(picture: &Picture<'_>, out: &mut String) {
    wires(picture, out);
    for rail in &picture.layout.rails {
        let is_short = rail.from == rail.to;
        let (top, bottom) = (y(rail.from) - if is_short { HALF } else { LINE / 2 }, y(rail.to) + if is_short { HALF } else { LINE / 2 });
        let side = if rail.side == Side::Left { "left" } else { "right" };
        let _ = writeln!(out, "<path class=\"rail {side}\" d=\"M{} {top}V{bottom}\"/>", x(rail.column));
    }
    for symbol in &picture.layout.symbols {
        draw_symbol(picture, symbol, out);
    }
}

/// All pieces of a net are one path.
fn wires(picture: &Picture<'_>, out: &mut String) {
    let mut order: Vec<usize> = (0..picture.layout.wires.len()).collect();
    order.sort_by_key(|&index| picture.layout.wires[index].net);
    let mut before = None;
    for index in order {
        let wire = picture.layout.wires[index];
        if before != Some(wire.net) {
            if before.is_some() {
                out.push_str("\"/>\n");
            }
            let flow = picture.flow(Some(wire.net));
            let _ = write!(out, "<path class=\"wire\" data-net=\"{}\" data-flow=\"{flow}\" d=\"", wire.net.0);
            before = Some(wire.net);
        }
        let ((from, first), (to, last)) = (wire.from, wire.to);
        let _ = match first == last {
            true => write!(out, "M{} {}H{}", x(from), y(first), x(to)),
            false => write!(out, "M{} {}V{}", x(from), y(first), y(last)),
        };
    }
    if before.is_some() {
        out.push_str("\"/>\n");
    }
}

fn draw_symbol(picture: &Picture<'_>, symbol: &Symbol, out: &mut String) {
    let _ = write!(out, "<g class=\"symbol {}\"", symbol.kind);
    if !symbol.element.is_empty() {
        let flow = picture.flow(symbol.after.or(symbol.before));
        let value = symbol.value.as_deref().map(escaped).unwrap_or_default();
        let _ = write!(out, " data-element=\"{}\" data-flow=\"{flow}\" data-value=\"{value}\"", symbol.element);
    }
    out.push_str(">\n");
    outline(symbol.outline, out);
    let is_closed = matches!(symbol.outline, Outline::Contact { closed: true, .. });
    for label in &symbol.labels {
        if !(is_closed && label.role == Role::Mark) {
            written(label, symbol.outline, out);
        }
    }
    out.push_str("</g>\n");
}

fn outline(outline: Outline, out: &mut String) {
    match outline {
        Outline::None => {}
        Outline::Contact { from, to, line, closed } => {
            let (left, right, top, bottom) = (x(from), x(to), y(line) - HALF, y(line) + HALF);
            let stroke = if closed { format!("M{} {bottom}L{} {top}", left + 1, right - 1) } else { String::new() };
            let _ = writeln!(out, "<path class=\"stroke\" d=\"M{left} {top}V{bottom}M{right} {top}V{bottom}{stroke}\"/>");
        }
        Outline::Coil { from, to, line } => {
            let (left, right, top, bottom) = (x(from), x(to), y(line) - HALF, y(line) + HALF);
            let (near, far) = (left + 3, right - 3);
            let middle = y(line);
            let _ = writeln!(
                out,
                "<path class=\"stroke\" d=\"M{near} {top}Q{} {middle} {near} {bottom}M{far} {top}Q{} {middle} {far} {bottom}\"/>",
                left - 3,
                right + 3
            );
        }
        Outline::Box { from, to, top, bottom } => {
            let (upper, lower) = (y(top) - HALF - 1, y(bottom) - 4);
            let _ = writeln!(
                out,
                "<rect class=\"face\" x=\"{}\" y=\"{upper}\" width=\"{}\" height=\"{}\"/>",
                x(from),
                x(to) - x(from),
                lower - upper
            );
        }
    }
}

fn written(label: &Label, outline: Outline, out: &mut String) {
    let class = match label.role {
        Role::Name => "name",
        Role::Value => "value",
        Role::Title => "title",
        Role::Pin => "pin",
        Role::Mark => "mark",
        Role::Stub => "stub",
        Role::Jump => "jump",
        Role::TickLeft | Role::TickRight => return,
        Role::Circle => {
            let is_left = matches!(outline, Outline::Box { from, .. } if from == label.column);
            let middle = if is_left { x(label.column) - 4 } else { x(label.column) + 4 };
            let _ = writeln!(out, "<circle class=\"circle\" cx=\"{middle}\" cy=\"{}\" r=\"4\"/>", y(label.line));
            return;
        }
    };
    let (left, base) = (label.column * COLUMN + MARGIN, y(label.line) + 5);
    let _ = writeln!(out, "<text class=\"{class}\" x=\"{left}\" y=\"{base}\">{}</text>", escaped(&label.text));
}
