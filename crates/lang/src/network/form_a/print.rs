//! A diagram → form A.

use super::layout::{FormLine, layout};
use crate::network::flavour::Drawing;
use crate::network::model::{Actual, Alone, Content, Counter, Element, End, Kind, Network, Output, OutputKind, Pin, Place, Rung};
use crate::network::operand::Operand;

/// Boxes whose pins fit into so many columns are written on one line.
const COLUMNS_MAX: usize = 80;

/// The comments of an element, or of its pin with this name: those before it, and the one on its line.
pub type CommentsOf<'c> = &'c dyn Fn(Place, Option<&str>) -> (Vec<String>, Option<String>);

/// The lines of a network, with the comments that belong to its places.
pub fn print(network: &Network, drawing: Drawing, comments: CommentsOf<'_>) -> String {
    let mut printer = Printer { lines: Vec::new(), drawing, comments };
    if let Some(label) = &network.label {
        printer.line(0, format!("LABEL {label}:"));
    }
    match &network.content {
        Content::Empty => {}
        Content::Alone(alone, place) => {
            let content = match alone {
                Alone::Open(block) => format!("OPN {}", block.spaced()),
                Alone::McrActivate => "MCRA".to_owned(),
                Alone::McrDeactivate => "MCRD".to_owned(),
                Alone::McrEnd => "MCR>".to_owned(),
                Alone::Jump(label) => format!("JMP {label}"),
                Alone::Call(block) => format!("UC {}", block.spaced()),
                Alone::Return => "RET".to_owned(),
            };
            printer.element(0, content, *place);
        }
        Content::Rung(rung) => printer.rung(0, rung),
    }
    layout(&printer.lines)
}

struct Printer<'c> {
    lines: Vec<FormLine>,
    drawing: Drawing,
    comments: CommentsOf<'c>,
}

impl Printer<'_> {
    fn line(&mut self, level: usize, content: String) {
        self.lines.push(FormLine { level, content, ..FormLine::default() });
    }

    /// The first line of an element, with its comments.
    fn element(&mut self, level: usize, content: String, place: Place) {
        self.with_pins(level, content, place, |_| {});
    }

    /// The first line of a box and its pins. What lies in the logic at a pin has its own comments, so the pins are asked first.
    fn with_pins(&mut self, level: usize, content: String, place: Place, pins: impl FnOnce(&mut Self)) {
        let below = self.lines.len();
        pins(self);
        let pins = self.lines.split_off(below);
        let comments = (self.comments)(place, None);
        self.commented(level, content, comments);
        self.lines.extend(pins);
    }

    /// A line with its comments.
    fn commented(&mut self, level: usize, content: String, (before, comment): (Vec<String>, Option<String>)) {
        for comment in before {
            self.lines.push(FormLine { level, comment: Some(comment), ..FormLine::default() });
        }
        self.lines.push(FormLine { level, content, comment, after_empty: false });
    }

    /// A line of a pin of the box at a place.
    fn pin(&mut self, level: usize, place: Place, name: &str, content: String) {
        let comments = (self.comments)(place, Some(name));
        self.commented(level, content, comments);
    }

    fn rung(&mut self, level: usize, rung: &Rung) {
        self.series(level, &rung.line);
        match &rung.end {
            End::Open => {}
            End::Outputs(outputs) => outputs.iter().for_each(|output| self.output(level, output)),
            End::Branches(rungs) => {
                for rung in rungs {
                    self.line(level, "BRANCH".to_owned());
                    self.rung(level + 1, rung);
                }
                self.line(level, "END".to_owned());
            }
        }
    }

    /// Elements in series. In FBD neighbours that only read are the inputs of an & box.
    fn series(&mut self, level: usize, line: &[Element]) {
        if self.drawing == Drawing::Lad {
            line.iter().for_each(|element| self.one(level, element));
            return;
        }
        let mut rest = line;
        while !rest.is_empty() {
            let inputs = rest.iter().take_while(|one| !one.kind.acts_on_line()).count();
            if inputs > 1 {
                self.line(level, "AND".to_owned());
                rest[..inputs].iter().for_each(|element| self.one(level + 1, element));
                self.line(level, "END".to_owned());
            } else {
                rest[..inputs].iter().for_each(|element| self.one(level, element));
            }
            rest = &rest[inputs..];
            let acting = rest.iter().take_while(|one| one.kind.acts_on_line()).count();
            rest[..acting].iter().for_each(|element| self.one(level, element));
            rest = &rest[acting..];
        }
    }

    fn one(&mut self, level: usize, element: &Element) {
        let place = element.place;
        let circle = |negated: &bool| if *negated { "/" } else { "" };
        match &element.kind {
            Kind::Contact { operand, negated } => {
                self.element(level, format!("{} {}", if *negated { "NC" } else { "NO" }, operand.spaced()), place);
            }
            Kind::Compare { operation, left, right, negated } => {
                self.element(level, format!("{}CMP {operation} {}, {}", circle(negated), left.spaced(), right.spaced()), place);
            }
            Kind::Parallel { branches, negated } => {
                for (index, branch) in branches.iter().enumerate() {
                    let sign = if index == 0 { circle(negated) } else { "" };
                    self.line(level, format!("{sign}OR{}", if branch.bracketed { " ( )" } else { "" }));
                    self.series(level + 1, &branch.line);
                }
                self.line(level, "END".to_owned());
            }
            Kind::Xor { inputs, negated } => {
                for (index, input) in inputs.iter().enumerate() {
                    let sign = if index == 0 { circle(negated) } else { "" };
                    self.line(level, format!("{sign}XOR"));
                    match input.negated {
                        true => {
                            self.line(level + 1, "/AND".to_owned());
                            self.series(level + 2, &input.line);
                            self.line(level + 1, "END".to_owned());
                        }
                        false => self.series(level + 1, &input.line),
                    }
                }
                self.line(level, "END".to_owned());
            }
            Kind::Group { line, negated } => {
                self.line(level, format!("{}AND", circle(negated)));
                line.iter().for_each(|element| self.one(level + 1, element));
                self.line(level, "END".to_owned());
            }
            Kind::Tap { negated } => self.element(level, format!("{}TAP", circle(negated)), place),
            Kind::Edge { falling, memory } => {
                self.element(level, format!("{} {}", if *falling { "N" } else { "P" }, memory.spaced()), place);
            }
            Kind::EdgeBox { falling, operand, memory } => {
                let content = match memory {
                    Some(memory) => format!("{} {}, {}", if *falling { "NEG" } else { "POS" }, operand.spaced(), memory.spaced()),
                    None => format!("{} {operand}", if *falling { "N" } else { "P" }),
                };
                self.element(level, content, place);
            }
            Kind::Not => self.element(level, "NOT".to_owned(), place),
            Kind::Midline { operand, negated } => {
                self.element(level, format!("MID {}{}", if *negated { "/ " } else { "" }, operand.spaced()), place);
            }
            Kind::Box { row, inputs, output } => {
                let inputs: Vec<String> = inputs.iter().map(Operand::spaced).collect();
                let inline = match row.reversed {
                    true => row.inputs.iter().zip(&inputs).map(|(name, input)| format!("{name} := {input}")).collect::<Vec<_>>().join(", "),
                    false => inputs.join(", "),
                };
                let content = format!("{} {inline} => {}", row.name, output.spaced());
                // A comment at a pin needs a line of the pin.
                let below = self.lines.len();
                for (name, input) in row.inputs.iter().zip(&inputs) {
                    self.pin(level + 1, place, name, format!("{name} := {input}"));
                }
                self.pin(level + 1, place, "OUT", format!("OUT => {}", output.spaced()));
                let pins = self.lines.split_off(below);
                let inline = level * 4 + content.len() <= COLUMNS_MAX && pins.iter().all(|line| line.comment.is_none());
                match inline {
                    true => self.element(level, content, place),
                    false => self.with_pins(level, row.name.to_owned(), place, |this| this.lines.extend(pins)),
                }
            }
            Kind::FlipFlop { reset_first, operand, second } => {
                let (name, pin) = if *reset_first { ("RS", "S") } else { ("SR", "R") };
                self.with_pins(level, format!("{name} {}", operand.spaced()), place, |this| {
                    this.logic(level + 1, place, pin, second.as_deref());
                });
            }
            Kind::Timer(timer) => {
                self.with_pins(level, format!("{} {}", timer.kind.box_name(), timer.timer.spaced()), place, |this| {
                    this.pin(level + 1, place, "TV", format!("TV := {}", timer.value.spaced()));
                    this.logic(level + 1, place, "R", timer.reset.as_deref());
                    this.wired(level + 1, place, "BI", timer.binary.as_ref());
                    this.wired(level + 1, place, "BCD", timer.bcd.as_ref());
                });
            }
            Kind::Counter(counter) => self.counter(level, counter, place),
            Kind::Call { block, instance, pins } => {
                let instance = instance.as_ref().map(|block| format!(", {}", block.spaced())).unwrap_or_default();
                self.with_pins(level, format!("CALL {}{instance}", block.spaced()), place, |this| {
                    pins.iter().for_each(|pin| this.pin_of_call(level + 1, place, pin));
                });
            }
            Kind::Named(named) => {
                let instance = named.instance.as_ref().map(|instance| format!("[{instance}]")).unwrap_or_default();
                self.element(level, format!("{}{instance}", named.name), place);
                if let Some(pin) = &named.power {
                    self.line(level + 1, format!("{pin} := ."));
                }
                for input in &named.inputs {
                    let sign = if input.negated { "/" } else { "" };
                    match (&input.name, input.line.as_slice()) {
                        (Some(name), [Element { kind: Kind::Contact { operand, negated: false }, .. }]) => {
                            self.line(level + 1, format!("{name} := {sign}{operand}"));
                        }
                        (Some(name), line) => self.logic(level + 1, place, name, Some(line)),
                        // A pin without its name is only written on the line of the box.
                        (None, [Element { kind: Kind::Contact { operand, .. }, .. }]) => {
                            if let Some(head) = self.lines.iter_mut().rev().find(|line| line.level == level) {
                                let comma = if head.content.contains(' ') { "," } else { "" };
                                head.content.push_str(&format!("{comma} {sign}{operand}"));
                            }
                        }
                        (None, _) => {}
                    }
                }
                for (name, output) in &named.outputs {
                    match name {
                        Some(name) => self.line(level + 1, format!("{name} => {output}")),
                        None => {
                            if let Some(head) = self.lines.iter_mut().rev().find(|line| line.level == level) {
                                head.content.push_str(&format!(" => {output}"));
                            }
                        }
                    }
                }
                if let Some(pin) = &named.flow {
                    self.line(level + 1, format!("{pin} => ."));
                }
            }
        }
    }

    fn counter(&mut self, level: usize, counter: &Counter, place: Place) {
        self.with_pins(level, format!("{} {}", counter.kind.box_name(), counter.counter.spaced()), place, |this| {
            this.logic(level + 1, place, "CD", counter.down.as_deref());
            if let Some((line, value)) = &counter.set {
                this.logic(level + 1, place, "S", Some(line));
                this.pin(level + 1, place, "PV", format!("PV := {}", value.spaced()));
            }
            this.logic(level + 1, place, "R", counter.reset.as_deref());
            this.wired(level + 1, place, "CV", counter.value.as_ref());
            this.wired(level + 1, place, "CV_BCD", counter.bcd.as_ref());
        });
    }

    fn pin_of_call(&mut self, level: usize, place: Place, pin: &Pin) {
        let name = pin.name.as_name();
        match &pin.actual {
            Actual::Direct(actual) => {
                let sign = if actual.is_bit_address() { "=" } else { "" };
                self.pin(level, place, &pin.name, format!("{name} := {sign}{}", actual.spaced()));
            }
            Actual::Output(actual) => self.pin(level, place, &pin.name, format!("{name} => {}", actual.spaced())),
            Actual::Logic(line) => match line.as_slice() {
                [Element { kind: Kind::Contact { operand, negated }, place: contact }] if operand.is_bit_address() || *negated => {
                    let sign = if *negated { "/" } else { "" };
                    // The contact has no line of its own.
                    let (mut before, own) = (self.comments)(place, Some(&pin.name));
                    let (more, of_contact) = (self.comments)(*contact, None);
                    before.extend(more);
                    let comment = match (own, of_contact) {
                        (Some(own), Some(second)) => {
                            before.push(own);
                            Some(second)
                        }
                        (own, second) => own.or(second),
                    };
                    self.commented(level, format!("{name} := {sign}{}", operand.spaced()), (before, comment));
                }
                line => self.logic_at(level, place, &pin.name, &name, line),
            },
        }
    }

    /// Logic at a pin.
    fn logic(&mut self, level: usize, place: Place, pin: &str, line: Option<&[Element]>) {
        if let Some(line) = line {
            self.logic_at(level, place, pin, pin, line);
        }
    }

    /// Logic at a pin that is written in another way than it is called.
    fn logic_at(&mut self, level: usize, place: Place, pin: &str, written: &str, line: &[Element]) {
        self.pin(level, place, pin, format!("{written}:"));
        self.series(level + 1, line);
    }

    fn wired(&mut self, level: usize, place: Place, pin: &str, output: Option<&Operand>) {
        if let Some(output) = output {
            self.pin(level, place, pin, format!("{pin} => {}", output.spaced()));
        }
    }

    fn output(&mut self, level: usize, output: &Output) {
        let content = match &output.kind {
            OutputKind::Assign(operand) => format!("COIL {}", operand.spaced()),
            OutputKind::AssignNegated(operand) => format!("COIL / {operand}"),
            OutputKind::AssignEdge { falling, operand } => format!("{} {operand}", if *falling { "NCOIL" } else { "PCOIL" }),
            OutputKind::Set(operand) => format!("SET {}", operand.spaced()),
            OutputKind::Reset(operand) => format!("RESET {}", operand.spaced()),
            OutputKind::Save => "SAVE".to_owned(),
            OutputKind::Return => "RET".to_owned(),
            OutputKind::Jump(label) => format!("JMP {label}"),
            OutputKind::JumpNot(label) => format!("JMPN {label}"),
            OutputKind::Call(block) => format!("CC {}", block.spaced()),
            OutputKind::McrStart => "MCR<".to_owned(),
            OutputKind::Timer { kind, timer, value } => format!("{} {}, {}", kind.instruction(), timer.spaced(), value.spaced()),
            OutputKind::SetCounter { counter, value } => format!("SC {}, {}", counter.spaced(), value.spaced()),
            OutputKind::CountUp(counter) => format!("CU {}", counter.spaced()),
            OutputKind::CountDown(counter) => format!("CD {}", counter.spaced()),
        };
        self.element(level, content, output.place);
    }
}
