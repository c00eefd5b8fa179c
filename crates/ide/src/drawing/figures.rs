//! The figures that stand in the cells of a grid: how wide they are, and the symbol that each becomes once its column is known.

use sieben_lang::network::model::{Element, Kind, Place};

use super::identity::STUB;
use super::layout::{Label, Layout, NetId, Outline, Role, Symbol, Wire};
use super::names::width;

/// A figure.
#[derive(Debug)]
pub(super) enum Figure {
    /// A contact or coil.
    Mark(Mark),
    /// A box.
    Box(BoxFigure),
    /// `»1`: the row goes on elsewhere.
    StubOut(u32),
    /// `1»`: it comes from elsewhere.
    StubIn(u32),
    /// A piece of line that keeps two vertical ones apart.
    Gap,
    /// An operand by itself; only in function block diagrams.
    Operand(Vec<String>, Option<String>),
}

/// A contact or coil.
#[derive(Debug)]
pub(super) struct Mark {
    /// Round.
    pub(super) is_coil: bool,
    /// What stands in it.
    pub(super) mark: String,
    /// Lines above it, top to bottom.
    pub(super) above: Vec<(String, Role)>,
    /// Lines below it.
    pub(super) below: Vec<(String, Role)>,
    /// The value of its operand.
    pub(super) value: Option<String>,
}

/// A box.
#[derive(Debug)]
pub(super) struct BoxFigure {
    /// Its title, in its upper edge.
    pub(super) title: String,
    /// Lines above it.
    pub(super) above: Vec<String>,
    /// Pins at the left.
    pub(super) left: Vec<PinFigure>,
    /// Pins at the right.
    pub(super) right: Vec<PinFigure>,
    /// Lines from the one of its power pin to its lower edge.
    pub(super) height: usize,
    /// The value of its operand.
    pub(super) value: Option<String>,
}

/// A pin of a box.
#[derive(Debug, Default)]
pub(super) struct PinFigure {
    /// Lines below the power pin.
    pub(super) offset: usize,
    /// Its name, inside.
    pub(super) name: String,
    /// With a circle.
    pub(super) negated: bool,
    /// What is wired to it, outside, in lines.
    pub(super) actual: Vec<String>,
    /// The value of that.
    pub(super) value: Option<String>,
    /// The line that is wired to it.
    pub(super) net: Option<NetId>,
    /// It keeps its line and is not drawn.
    pub(super) is_hidden: bool,
    /// What is wired to it is drawn elsewhere.
    pub(super) is_stub: bool,
    /// What is wired to it is an element of its own: kind, place, what it carries.
    pub(super) element: Option<(&'static str, Place, NetId)>,
}

impl PinFigure {
    /// A pin by its place and name, to which nothing is wired.
    pub(super) fn new(offset: usize, name: &str) -> Self {
        Self { offset, name: sieben_model::visible::name(name), ..Self::default() }
    }

    /// The value with what separates it from the operand.
    fn shown_value(&self) -> String {
        self.value.as_ref().map_or_else(String::new, |value| format!(" = {value}"))
    }

    /// Columns of what is written outside.
    fn outside(&self) -> usize {
        let longest = self.actual.iter().map(|line| width(line)).max().unwrap_or(0);
        let last = self.actual.last().map_or(0, |line| width(line)) + width(&self.shown_value());
        longest.max(last)
    }
}

/// Where a cell lies: its borders, the line of its wire, and the lines that enter and leave it.
pub(super) struct Spot {
    pub(super) left: usize,
    pub(super) right: usize,
    pub(super) line: usize,
    pub(super) kind: &'static str,
    pub(super) place: Place,
    pub(super) before: Option<NetId>,
    pub(super) after: Option<NetId>,
}

impl Figure {
    /// Columns between the borders of its cell.
    pub(super) fn width(&self) -> usize {
        match self {
            Self::Mark(mark) => {
                let labels = mark.above.iter().chain(&mark.below).map(|(text, _)| width(text)).max().unwrap_or(0);
                (labels + 2).max(width(&mark.mark).max(1) + 6)
            }
            Self::Box(boxed) => Self::width_of_box(boxed),
            Self::Gap => 1,
            Self::StubOut(number) | Self::StubIn(number) => number.to_string().len() + 3,
            Self::Operand(lines, value) => {
                lines.iter().map(|line| width(line)).max().unwrap_or(0) + value.as_ref().map_or(0, |value| width(value) + 3) + 2
            }
        }
    }

    /// Columns of a box between the borders of its cell.
    pub(super) fn width_of_box(boxed: &BoxFigure) -> usize {
        let (left, inner, right) = boxed.widths();
        let above = boxed.lines_above().iter().map(|(line, value)| width(line) + width(value)).max().unwrap_or(0);
        (left + inner + 2 + right).max(above + 2)
    }

    /// Lines above and below the one of its wire.
    pub(super) fn heights(&self) -> (usize, usize) {
        match self {
            Self::Mark(mark) => (mark.above.len(), mark.below.len()),
            Self::Box(boxed) => (1 + boxed.above.len(), boxed.height),
            Self::Gap | Self::StubOut(_) | Self::StubIn(_) => (0, 0),
            Self::Operand(lines, _) => (0, lines.len().saturating_sub(1)),
        }
    }

    /// Draws it.
    pub(super) fn draw(&self, spot: &Spot, layout: &mut Layout) {
        match self {
            Self::Mark(mark) => mark.draw(spot, layout),
            Self::Box(boxed) => boxed.draw(spot, layout),
            Self::Gap => wire(layout, spot.after, spot.line, spot.left, spot.right),
            Self::StubOut(number) => {
                let text = format!("»{number}");
                wire(layout, spot.before, spot.line, spot.left, spot.left + 1);
                spot.symbol(layout, STUB, Outline::None, vec![label(spot.left + 2, spot.line, text, Role::Stub)], None);
            }
            Self::StubIn(number) => {
                let text = format!("{number}»");
                let end = spot.left + 1 + width(&text);
                wire(layout, spot.after, spot.line, end, spot.right);
                spot.symbol(layout, STUB, Outline::None, vec![label(spot.left + 1, spot.line, text, Role::Stub)], None);
            }
            Self::Operand(lines, value) => {
                let mut labels: Vec<Label> = Vec::new();
                let mut end = spot.left + 1;
                for (index, text) in lines.iter().enumerate() {
                    end = end.max(spot.left + 1 + width(text));
                    labels.push(label(spot.left + 1, spot.line + index, text.clone(), Role::Name));
                }
                if let Some(value) = value {
                    let text = format!(" = {value}");
                    let begin = lines.first().map_or(end, |line| spot.left + 1 + width(line));
                    end = end.max(begin + width(&text));
                    labels.push(label(begin, spot.line, text, Role::Value));
                }
                wire(layout, spot.after, spot.line, end.min(spot.right), spot.right);
                spot.symbol(layout, spot.kind, Outline::None, labels, value.clone());
            }
        }
    }
}

impl Spot {
    fn symbol(&self, layout: &mut Layout, kind: &'static str, outline: Outline, labels: Vec<Label>, value: Option<String>) {
        let (before, after) = (self.before, self.after);
        layout.symbols.push(Symbol { kind, element: String::new(), place: self.place, outline, labels, before, after, value });
    }

    /// Columns between the borders.
    fn room(&self) -> usize {
        (self.right - self.left).saturating_sub(1)
    }

    /// The first column of something that stands in the middle.
    fn middle(&self, columns: usize) -> usize {
        self.left + 1 + self.room().saturating_sub(columns) / 2
    }
}

fn label(column: usize, line: usize, text: String, role: Role) -> Label {
    Label { column, line, text, role }
}

/// A horizontal piece, if there is a line.
fn wire(layout: &mut Layout, net: Option<NetId>, line: usize, from: usize, to: usize) {
    if let Some(net) = net
        && to > from
    {
        layout.wires.push(Wire { net, from: (from, line), to: (to, line) });
    }
}

impl Mark {
    fn draw(&self, spot: &Spot, layout: &mut Layout) {
        let inner = width(&self.mark).max(1);
        let from = spot.middle(inner + 2);
        let to = from + inner + 1;
        wire(layout, spot.before, spot.line, spot.left, from);
        wire(layout, spot.after, spot.line, to, spot.right);
        let mut labels = Vec::new();
        let top = spot.line.saturating_sub(self.above.len());
        for (index, (text, role)) in self.above.iter().enumerate() {
            labels.push(label(spot.middle(width(text)), top + index, text.clone(), *role));
        }
        if !self.mark.is_empty() {
            labels.push(label(from + 1, spot.line, self.mark.clone(), Role::Mark));
        }
        for (index, (text, role)) in self.below.iter().enumerate() {
            labels.push(label(spot.middle(width(text)), spot.line + 1 + index, text.clone(), *role));
        }
        let outline = match self.is_coil {
            true => Outline::Coil { from, to, line: spot.line },
            false => Outline::Contact { from, to, line: spot.line, closed: self.mark == "/" },
        };
        spot.symbol(layout, spot.kind, outline, labels, self.value.clone());
    }
}

impl BoxFigure {
    /// Makes the box at the end of the logic of a pin one whose result is used, if nothing else is said: it goes on from no named pin, and alone it has no EN.
    pub(super) fn hand_value_on(&mut self, line: &[Element]) {
        let Some(Element { kind: Kind::Named(named), .. }) = line.last() else { return };
        if named.flow.is_none()
            && let Some(flow) = self.right.first_mut()
            && flow.name == "ENO"
        {
            flow.name.clear();
        }
        if line.len() == 1 && named.power.is_none() && self.left.first().is_some_and(|power| power.name == "EN") {
            self.left[0].is_hidden = true;
        }
    }

    /// Columns at the left, inside, and at the right.
    fn widths(&self) -> (usize, usize, usize) {
        let most = |pins: &[PinFigure], of: &dyn Fn(&PinFigure) -> usize| pins.iter().map(of).max().unwrap_or(0);
        let name = |pin: &PinFigure| if pin.is_hidden { 0 } else { width(&pin.name) };
        let left = most(&self.left, &|pin| pin.outside());
        let right = most(&self.right, &|pin| pin.outside());
        let inner = (most(&self.left, &name) + most(&self.right, &name) + 1).max(width(&self.title) + 2).max(3);
        ((left + 1 + self.circle_room()).max(2), inner, if right == 0 { 2 } else { right + 2 })
    }

    /// Lines above it; the last one has the value of the operand after it.
    fn lines_above(&self) -> Vec<(&str, String)> {
        let mut lines: Vec<(&str, String)> = self.above.iter().map(|line| (line.as_str(), String::new())).collect();
        if let (Some((_, last)), Some(value)) = (lines.last_mut(), &self.value) {
            *last = format!(" = {value}");
        }
        lines
    }

    /// A column between operands and the box, where a circle stands between them.
    fn circle_room(&self) -> usize {
        usize::from(self.left.iter().any(|pin| pin.negated && !pin.actual.is_empty()))
    }

    fn draw(&self, spot: &Spot, layout: &mut Layout) {
        let (before, inner, after) = self.widths();
        let circle_room = self.circle_room();
        // What is wider than the box, such as a long name above it, leaves room at both sides.
        let from = spot.left + 1 + before + spot.room().saturating_sub(before + inner + 2 + after) / 2;
        let to = from + inner + 1;
        let (top, bottom) = (spot.line.saturating_sub(1), spot.line + self.height);
        let mut labels = vec![label(from + 1 + (inner - width(&self.title)) / 2, top, self.title.clone(), Role::Title)];
        let names = top.saturating_sub(self.above.len());
        for (index, (text, value)) in self.lines_above().into_iter().enumerate() {
            let own = width(text) + width(&value);
            let middle = (from + (inner + 2) / 2).saturating_sub(own / 2);
            let column = middle.min(spot.right.saturating_sub(own)).max(spot.left + 1);
            labels.push(label(column, names + index, text.to_owned(), Role::Name));
            if !value.is_empty() {
                labels.push(label(column + width(text), names + index, value, Role::Value));
            }
        }
        wire(layout, spot.after, spot.line, to, spot.right);
        let mut elements = Vec::new();
        for pin in self.left.iter().filter(|pin| !pin.is_hidden) {
            let line = spot.line + pin.offset;
            labels.push(label(from, line, String::new(), if pin.negated { Role::Circle } else { Role::TickLeft }));
            if !pin.name.is_empty() {
                labels.push(label(from + 1, line, pin.name.clone(), Role::Pin));
            }
            wire(layout, pin.net, line, spot.left, from);
            let value = pin.shown_value();
            let mut written = Vec::new();
            for (index, text) in pin.actual.iter().enumerate() {
                let room = circle_room + if index + 1 == pin.actual.len() { width(&value) } else { 0 };
                written.push(label(
                    from - room - width(text),
                    line + index,
                    text.clone(),
                    if pin.is_stub { Role::Stub } else { Role::Name },
                ));
            }
            if !value.is_empty() {
                written.push(label(from - circle_room - width(&value), line + pin.actual.len().saturating_sub(1), value, Role::Value));
            }
            match pin.element {
                Some((kind, place, net)) => elements.push((kind, place, net, written, pin.value.clone())),
                None => labels.append(&mut written),
            }
        }
        for pin in &self.right {
            let line = spot.line + pin.offset;
            labels.push(label(to, line, String::new(), if pin.negated { Role::Circle } else { Role::TickRight }));
            if !pin.name.is_empty() {
                labels.push(label(to - width(&pin.name), line, pin.name.clone(), Role::Pin));
            }
            let mut end = to + 2;
            for (index, text) in pin.actual.iter().enumerate() {
                labels.push(label(to + 2, line + index, text.clone(), Role::Name));
                end = to + 2 + width(text);
            }
            let value = pin.shown_value();
            if !value.is_empty() {
                labels.push(label(end, line + pin.actual.len().saturating_sub(1), value, Role::Value));
            }
        }
        spot.symbol(layout, spot.kind, Outline::Box { from, to, top, bottom }, labels, self.value.clone());
        for (kind, place, net, labels, value) in elements {
            let outline = Outline::None;
            layout.symbols.push(Symbol { kind, element: String::new(), place, outline, labels, before: None, after: Some(net), value });
        }
    }
}
