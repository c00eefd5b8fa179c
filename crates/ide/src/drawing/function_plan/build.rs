//! Which box feeds which: what stands in series are the inputs of an `&` box, branches those of `>=1`.

use sieben_lang::network::model::{Branch, Element, End, Kind, Line, Output, OutputKind, Place, Rung};
use sieben_lang::network::write::{reads_tap, tap_in};

use super::super::faces::{self, Face, Wired};
use super::super::figures::{BoxFigure, Figure, PinFigure};
use super::super::identity::{self, kind_of, kind_of_output};
use super::super::layout::{Gate, Net, NetId};
use super::super::names::{PIN_COLUMNS_MAX, wrapped};
use super::{Drawn, Maker, Node, Operand, Row, Source, TAP_LINES_MAX, Tail};

/// The rail: what feeds an open power pin.
const RAIL: NetId = NetId(0);

/// A pin with what feeds it.
struct Pin {
    name: String,
    negated: bool,
    source: Source,
}

impl Pin {
    fn new(name: &str, source: Source) -> Self {
        Self { name: name.to_owned(), negated: false, source }
    }
}

/// A box before its room is known.
struct Plan<'n> {
    kind: &'static str,
    place: Place,
    title: String,
    above: &'n str,
    pins: Vec<Pin>,
    right: Vec<PinFigure>,
    after: NetId,
    /// The line that leaves it does so at a pin: its name, with a circle.
    flow: Option<(&'n str, bool)>,
}

impl Source {
    pub(super) fn net(&self) -> NetId {
        match self {
            Self::Open => RAIL,
            Self::Operand(operand) => operand.net,
            Self::Node(node) => node.after,
            Self::Left(net) | Self::Stub(_, net) => *net,
        }
    }

    /// Where it comes from, if it is an element.
    fn place(&self) -> Place {
        match self {
            Self::Operand(Operand { element: Some((_, place)), .. }) => *place,
            Self::Node(node) => node.place,
            _ => Place::default(),
        }
    }

    /// Widths of its columns, the rightmost first.
    pub(super) fn columns(&self) -> Vec<usize> {
        match self {
            Self::Open | Self::Left(_) => Vec::new(),
            Self::Operand(operand) => vec![Figure::Operand(operand.lines.clone(), operand.value.clone()).width()],
            Self::Node(node) => node.columns.clone(),
            Self::Stub(number, _) => vec![Figure::StubIn(*number).width()],
        }
    }
}

/// Columns of characters.
fn characters(columns: &[usize]) -> usize {
    columns.iter().sum::<usize>() + columns.len()
}

impl Tail {
    fn characters(&self) -> usize {
        match self {
            Self::Open => 0,
            Self::Outputs(nodes) => nodes.iter().map(|node| characters(&node.columns)).max().unwrap_or(0),
            Self::Branches(rungs, _) => rungs.iter().map(Drawn::characters).max().unwrap_or(0),
            Self::Stub(number) => Figure::StubOut(*number).width() + 1,
        }
    }
}

impl Drawn {
    fn characters(&self) -> usize {
        characters(&self.source.columns()) + self.tail.characters()
    }
}

impl Maker<'_> {
    fn net(&mut self, net: Net) -> NetId {
        self.nets.push(net);
        NetId(u32::try_from(self.nets.len() - 1).unwrap_or(u32::MAX))
    }

    fn value(&self, place: Place, operand: &str) -> Option<String> {
        self.options.status.and_then(|status| status.value(place, operand))
    }

    fn number(&mut self) -> u32 {
        self.stubs = self.stubs.saturating_add(1);
        self.stubs
    }

    /// A rung; `tapped` is the line that it taps.
    pub(super) fn rung(&mut self, rung: &Rung, tapped: Option<NetId>) -> Drawn {
        let left = tapped.filter(|_| !reads_tap(&rung.line)).map_or(Source::Open, Source::Left);
        let folded = self.fold(&rung.line, left);
        if let End::Outputs(outputs) = &rung.end
            && let [only] = outputs.as_slice()
            && !matches!(folded.source, Source::Node(_) | Source::Left(_))
        {
            // A single output has its operand at its own pin.
            let net = self.signal(&folded);
            let node = self.output(only, folded);
            return Drawn { source: Source::Open, tail: Tail::Outputs(vec![node]), net };
        }
        let circle = folded.negated && matches!(rung.end, End::Outputs(_));
        let source = if circle { folded.source } else { self.without_circle(folded) };
        let net = source.net();
        let mut drawn = Drawn { source, tail: Tail::Open, net };
        drawn.tail = match &rung.end {
            End::Open => return drawn,
            End::Outputs(outputs) => {
                let feed = || Pin { negated: circle, ..Pin::new("", Source::Left(net)) };
                Tail::Outputs(outputs.iter().map(|output| self.output(output, feed())).collect())
            }
            End::Branches(rungs) => {
                self.taps.push((net, None));
                let mut all = Vec::new();
                for rung in rungs {
                    let tapped = self.net(match tap_in(&rung.line) {
                        Some(tap) => Net::Found(tap.place),
                        None => Net::Tapped { before: net, place: rung.tap },
                    });
                    if let Some(tap) = self.taps.last_mut() {
                        tap.0 = tapped;
                    }
                    let mut sub = self.rung(rung, Some(tapped));
                    if let Source::Node(node) = &mut sub.source {
                        self.name_taps(node, 0, TAP_LINES_MAX);
                    }
                    all.push(sub);
                }
                let number = self.taps.pop().and_then(|(_, number)| number);
                Tail::Branches(all, number)
            }
        };
        if !matches!(drawn.source, Source::Open | Source::Left(_)) && drawn.characters() > self.columns {
            let number = self.number();
            let tail = std::mem::replace(&mut drawn.tail, Tail::Stub(number));
            self.after.push(Row::Drawn(Drawn { source: Source::Stub(number, net), tail, net }));
        }
        drawn
    }

    /// A tapped line that is read farther away than so many lines is drawn as its number.
    fn name_taps(&mut self, node: &mut Node, line: usize, lines_max: usize) {
        let mut sources = std::mem::take(&mut node.sources);
        for (pin, source) in &mut sources {
            let Some(figure) = node.figure.left.get_mut(*pin) else { continue };
            let line = line + figure.offset;
            match source {
                Source::Node(inner) => self.name_taps(inner, line, lines_max),
                Source::Left(net) if line > lines_max || lines_max == 0 => {
                    let number = self.tap_number(*net);
                    figure.actual = vec![format!("{number}»")];
                    figure.is_stub = true;
                    figure.net = None;
                    *source = Source::Open;
                }
                _ => {}
            }
        }
        node.sources = sources;
    }

    fn tap_number(&mut self, net: NetId) -> u32 {
        let Some(index) = self.taps.iter().rposition(|(own, _)| *own == net) else { return self.number() };
        if let Some(number) = self.taps[index].1 {
            return number;
        }
        let number = self.number();
        self.taps[index].1 = Some(number);
        number
    }

    /// What a pin carries.
    fn signal(&mut self, pin: &Pin) -> NetId {
        let net = pin.source.net();
        if pin.negated { self.net(Net::Not(net)) } else { net }
    }

    /// A source without a circle: the circle goes to a box of its own.
    fn without_circle(&mut self, pin: Pin) -> Source {
        if !pin.negated {
            return pin.source;
        }
        let place = pin.source.place();
        self.gate(Gate::And, "&", vec![pin], "and", place)
    }

    /// A line as what feeds one pin.
    fn fold(&mut self, line: &[Element], before: Source) -> Pin {
        let mut before = Pin::new("", before);
        let mut inputs: Vec<Pin> = Vec::new();
        let mut place = Place::default();
        for element in line {
            if element.kind.acts_on_line() {
                before = self.join(before, &mut inputs, place);
                let node = self.acting(element, before);
                before = Pin::new("", Source::Node(Box::new(node)));
            } else {
                if inputs.is_empty() {
                    place = element.place;
                }
                let pin = self.operand(element);
                inputs.push(pin);
            }
        }
        self.join(before, &mut inputs, place)
    }

    fn join(&mut self, before: Pin, inputs: &mut Vec<Pin>, place: Place) -> Pin {
        let mut pins = std::mem::take(inputs);
        if pins.is_empty() {
            return before;
        }
        if !matches!(before.source, Source::Open) {
            pins.insert(0, before);
        }
        match pins.len() {
            1 => pins.remove(0),
            _ => Pin::new("", self.gate(Gate::And, "&", pins, "and", place)),
        }
    }

    fn gate(&mut self, gate: Gate, title: &str, pins: Vec<Pin>, kind: &'static str, place: Place) -> Source {
        let after = self.net(Net::Gate { gate, inputs: pins.iter().map(|pin| (pin.source.net(), pin.negated)).collect() });
        let plan = Plan { kind, place, title: title.to_owned(), above: "", pins, right: Vec::new(), after, flow: Some(("", false)) };
        Source::Node(Box::new(self.node(plan)))
    }

    /// What is wired to a pin without being an element: an operand or constant.
    fn direct(&mut self, place: Place, name: &str, operand: &str) -> Source {
        let value = self.value(place, operand).or_else(|| self.value(place, name));
        Source::Operand(Operand { lines: wrapped(operand, PIN_COLUMNS_MAX), value, element: None, net: RAIL })
    }

    /// An element that is an input.
    fn operand(&mut self, element: &Element) -> Pin {
        let place = element.place;
        let with = |negated: bool, source| Pin { name: String::new(), negated, source };
        match &element.kind {
            Kind::Contact { operand, negated } => {
                let net = self.net(Net::Found(place));
                let value = self.value(place, operand);
                let lines = wrapped(operand, PIN_COLUMNS_MAX);
                with(*negated, Source::Operand(Operand { lines, value, element: Some((kind_of(&element.kind), place)), net }))
            }
            Kind::Tap { negated } => {
                let source = self.taps.last().map_or(Source::Open, |(net, _)| Source::Left(*net));
                with(*negated, source)
            }
            Kind::Compare { operation, left, right, negated } => {
                let pins = vec![Pin::new("IN1", self.direct(place, "", left)), Pin::new("IN2", self.direct(place, "", right))];
                let title = format!("CMP {operation}");
                let after = self.net(Net::Found(place));
                let plan = Plan { kind: "compare", place, title, above: "", pins, right: Vec::new(), after, flow: Some(("", false)) };
                with(*negated, Source::Node(Box::new(self.node(plan))))
            }
            Kind::Parallel { branches, negated } => {
                let pins = branches.iter().map(|Branch { line, .. }| self.input(line, false)).collect();
                with(*negated, self.gate(Gate::Or, ">=1", pins, "or", place))
            }
            Kind::Xor { inputs, negated } => {
                let pins = inputs.iter().map(|input| self.input(&input.line, input.negated)).collect();
                with(*negated, self.gate(Gate::Xor, "XOR", pins, "xor", place))
            }
            Kind::Group { line, negated } => self.input(line, *negated),
            Kind::EdgeBox { falling, operand, memory } => {
                let title = if *falling { "NEG" } else { "POS" };
                let pins = memory.iter().map(|memory| Pin::new("M_BIT", self.direct(place, "M_BIT", memory))).collect();
                let after = self.net(Net::Found(place));
                let (title, right) = (title.to_owned(), Vec::new());
                let plan = Plan { kind: "edge", place, title, above: operand, pins, right, after, flow: Some(("Q", false)) };
                with(false, Source::Node(Box::new(self.node(plan))))
            }
            _ => with(false, Source::Open),
        }
    }

    /// Logic at a pin.
    fn input(&mut self, line: &Line, negated: bool) -> Pin {
        if let [only] = line.as_slice()
            && !only.kind.acts_on_line()
        {
            let pin = self.operand(only);
            return Pin { negated: pin.negated ^ negated, ..pin };
        }
        let pin = self.fold(line, Source::Open);
        Pin { negated: pin.negated ^ negated, ..pin }
    }

    /// A box that acts on what comes from the left.
    fn acting(&mut self, element: &Element, before: Pin) -> Node {
        let place = element.place;
        let kind = kind_of(&element.kind);
        let power = self.signal(&before);
        let pins = vec![before];
        let (title, above, negated, after) = match &element.kind {
            Kind::Edge { falling, memory } => (if *falling { "N" } else { "P" }, memory.text.as_str(), false, self.net(Net::Found(place))),
            Kind::Not => ("NOT", "", false, self.net(Net::Not(power))),
            Kind::Midline { operand, negated } => {
                let found = self.net(Net::Found(place));
                let after = if *negated { self.net(Net::Not(found)) } else { found };
                ("#", operand.text.as_str(), *negated, after)
            }
            _ => return self.boxed(element, pins),
        };
        let (title, right) = (title.to_owned(), Vec::new());
        self.node(Plan { kind, place, title, above, pins, right, after, flow: Some(("", negated)) })
    }

    fn boxed(&mut self, element: &Element, mut pins: Vec<Pin>) -> Node {
        let place = element.place;
        let face = faces::face(&element.kind).unwrap_or(Face {
            title: String::new(),
            above: "",
            power: "",
            flow: "",
            inputs: Vec::new(),
            outputs: Vec::new(),
            hands_values_on: false,
        });
        if let Some(power) = pins.first_mut() {
            face.power.clone_into(&mut power.name);
        }
        for input in &face.inputs {
            let mut pin = match &input.wired {
                Wired::Open => Pin::new("", Source::Open),
                Wired::Operand(operand) => Pin::new("", self.direct(place, input.name, operand)),
                Wired::Contact(contact, operand) => {
                    let net = self.net(Net::Found(contact.place));
                    let value = self.value(contact.place, operand);
                    let (lines, element) = (wrapped(operand, PIN_COLUMNS_MAX), Some((kind_of(&contact.kind), contact.place)));
                    Pin::new("", Source::Operand(Operand { lines, value, element, net }))
                }
                Wired::Logic(line) => {
                    let mut pin = self.input(line, false);
                    if face.hands_values_on
                        && let Source::Node(node) = &mut pin.source
                    {
                        node.figure.hand_value_on(line);
                        node.settle();
                    }
                    pin
                }
            };
            pin.negated ^= input.negated;
            pins.push(Pin { name: input.name.to_owned(), ..pin });
        }
        let mut right = Vec::new();
        let mut at = 0;
        for (name, operand) in &face.outputs {
            at += 1;
            let mut pin = PinFigure::new(at, name);
            pin.actual = operand.map_or_else(|| vec![OPEN.to_owned()], |operand| wrapped(operand, PIN_COLUMNS_MAX));
            pin.value = operand.and_then(|operand| self.value(place, operand).or_else(|| self.value(place, name)));
            at += pin.actual.len().saturating_sub(1);
            right.push(pin);
        }
        let after = self.net(Net::Found(place));
        let kind = kind_of(&element.kind);
        self.node(Plan { kind, place, title: face.title, above: face.above, pins, right, after, flow: Some((face.flow, false)) })
    }

    fn output(&mut self, output: &Output, feed: Pin) -> Node {
        let coil = faces::coil(output);
        let place = output.place;
        let after = self.signal(&feed);
        let title = if matches!(output.kind, OutputKind::Assign(_) | OutputKind::AssignNegated(_)) { "=" } else { coil.mark };
        let mut pins = vec![Pin { negated: feed.negated ^ matches!(output.kind, OutputKind::AssignNegated(_)), ..feed }];
        if let Some((name, value)) = coil.value {
            pins.push(Pin::new(name, self.direct(place, name, value)));
        }
        let (kind, title) = (kind_of_output(&output.kind), title.to_owned());
        self.node(Plan { kind, place, title, above: coil.above, pins, right: Vec::new(), after, flow: None })
    }

    /// An element that stands alone.
    pub(super) fn alone(&mut self, title: &str, above: &str, place: Place) -> Node {
        let (pins, right, title) = (Vec::new(), Vec::new(), title.to_owned());
        self.node(Plan { kind: identity::ALONE, place, title, above, pins, right, after: RAIL, flow: None })
    }

    /// A box with the room that it takes; what feeds it and is too wide goes into a row of its own.
    fn node(&mut self, plan: Plan<'_>) -> Node {
        let value = if plan.above.is_empty() { None } else { self.value(plan.place, plan.above) };
        let above = wrapped(plan.above, PIN_COLUMNS_MAX);
        let mut left = Vec::with_capacity(plan.pins.len());
        let mut sources: Vec<(usize, Source)> = Vec::new();
        for (index, pin) in plan.pins.into_iter().enumerate() {
            let mut figure = PinFigure { negated: pin.negated, ..PinFigure::new(0, &pin.name) };
            match pin.source {
                Source::Open if index == 0 => {}
                Source::Open => figure.actual = vec![OPEN.to_owned()],
                Source::Operand(operand) => {
                    figure.element = operand.element.map(|(kind, place)| (kind, place, operand.net));
                    figure.actual = operand.lines;
                    figure.value = operand.value;
                }
                Source::Stub(number, _) => set_stub(&mut figure, number),
                Source::Node(_) | Source::Left(_) => {
                    figure.net = Some(pin.source.net());
                    sources.push((index, pin.source));
                }
            }
            left.push(figure);
        }
        let mut right = plan.right;
        if let Some((name, negated)) = plan.flow {
            right.insert(0, PinFigure { negated, ..PinFigure::new(0, name) });
        }
        let title = sieben_model::visible::name(&plan.title);
        let mut figure = BoxFigure { title, above, left, right, height: 1, value };
        let columns = self.columns(&mut figure, &mut sources);
        let mut node = Node { figure, kind: plan.kind, place: plan.place, sources, after: plan.after, above: 0, below: 0, columns };
        node.settle();
        node
    }

    /// Widths of a box and of what feeds it, which is cut off where it is too wide.
    fn columns(&mut self, figure: &mut BoxFigure, sources: &mut [(usize, Source)]) -> Vec<usize> {
        let own = Figure::width_of_box(figure);
        let room = self.columns.saturating_sub(own + 1);
        for (pin, source) in sources.iter_mut() {
            let is_wide = matches!(source, Source::Node(node) if characters(&node.columns) > room);
            if is_wide {
                self.cut(figure, *pin, source);
            }
        }
        let mut merged = merge(sources);
        if characters(&merged) > room {
            for (pin, source) in sources.iter_mut() {
                if matches!(source, Source::Node(node) if node.columns.len() > 1) {
                    self.cut(figure, *pin, source);
                }
            }
            merged = merge(sources);
        }
        merged.insert(0, Figure::width_of_box(figure));
        merged
    }

    fn cut(&mut self, figure: &mut BoxFigure, pin: usize, source: &mut Source) {
        let Source::Node(mut node) = std::mem::replace(source, Source::Open) else { return };
        self.name_taps(&mut node, 0, 0);
        let number = self.number();
        if let Some(figure) = figure.left.get_mut(pin) {
            set_stub(figure, number);
        }
        self.before.push(Row::Source(*node, number));
    }
}

/// What is written where nothing is wired to a pin.
const OPEN: &str = "...";

fn set_stub(figure: &mut PinFigure, number: u32) {
    figure.actual = vec![format!("{number}»")];
    figure.is_stub = true;
    figure.net = None;
}

/// Widths of the columns of several sources that lie under one another, each at the same right border.
fn merge(sources: &[(usize, Source)]) -> Vec<usize> {
    let mut merged: Vec<usize> = Vec::new();
    for (_, source) in sources {
        if let Source::Node(node) = source {
            merged.resize(merged.len().max(node.columns.len()), 0);
            for (all, own) in merged.iter_mut().zip(&node.columns) {
                *all = (*all).max(*own);
            }
        }
    }
    merged
}

impl Node {
    /// The lines of its pins: below one another, and each below all that feeds the ones before it.
    pub(super) fn settle(&mut self) {
        let (mut pin_line, mut free_line) = (0, 0);
        let mut sources = self.sources.iter().peekable();
        let mut first_above = 0;
        for (index, pin) in self.figure.left.iter_mut().enumerate() {
            let source = sources.next_if(|(own, _)| *own == index).map(|(_, source)| source);
            let (above, below, is_drawn) = match source {
                Some(Source::Node(node)) => (node.above, node.below, true),
                Some(Source::Left(_)) => (0, 0, true),
                _ => (0, 0, false),
            };
            let at = if index > 0 && is_drawn { pin_line.max(free_line + above) } else { pin_line };
            if is_drawn {
                free_line = at + below + 1;
            }
            if index == 0 {
                first_above = above;
            }
            pin.offset = at;
            pin_line = at + pin.actual.len().max(1);
        }
        let at_right = self.figure.right.iter().map(|pin| pin.offset + pin.actual.len().max(1)).max().unwrap_or(0);
        self.figure.height = pin_line.max(at_right).max(1);
        self.above = first_above.max(1 + self.figure.above.len());
        self.below = self.figure.height.max(free_line.saturating_sub(1));
    }
}
