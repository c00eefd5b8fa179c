//! A diagram as a line of form B.

use crate::network::boxes::BoxRow;
use crate::network::flavour::Drawing;
use crate::network::model::{
    Actual, Alone, Branch, Content, Counter, Element, End, Kind, Line, NamedBox, NamedInput, Network, Output, OutputKind, Pin, Rung, Timer,
    XorInput,
};
use crate::network::operand::{Operand, may_name_output};
use crate::network::write::reads_tap;

/// A network on one line.
pub fn print(network: &Network, drawing: Drawing) -> String {
    let label = network.label.as_ref().map(|label| format!("LABEL {label}: ")).unwrap_or_default();
    let content = match &network.content {
        Content::Empty => "empty network".to_owned(),
        Content::Alone(alone, _) => match alone {
            Alone::Open(block) => format!("|- OPN {block}"),
            Alone::McrActivate => "|- MCRA".to_owned(),
            Alone::McrDeactivate => "|- MCRD".to_owned(),
            Alone::McrEnd => "|- MCR>".to_owned(),
            Alone::Jump(label) => format!("|- JMP {label}"),
            Alone::Call(block) => format!("|- -> CALL {block}"),
            Alone::Return => "|- RETURN".to_owned(),
        },
        Content::Rung(rung) => Printer { drawing }.rung(rung, Begin::Rail),
    };
    label + &content
}

/// What a line begins at.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Begin {
    Rail,
    Tap,
    /// A branch, an input or a pin.
    Inside,
}

struct Printer {
    drawing: Drawing,
}

impl Printer {
    fn rung(&self, rung: &Rung, begin: Begin) -> String {
        let mut parts = Vec::new();
        let on_rail = match rung.line.first() {
            Some(first) => matches!(first.kind, Kind::Box { .. } | Kind::Call { .. } | Kind::Named(_)),
            None => true,
        };
        if begin == Begin::Rail && on_rail {
            parts.push("|-".to_owned());
        }
        let begin = if begin == Begin::Tap && reads_tap(&rung.line) { Begin::Inside } else { begin };
        if !rung.line.is_empty() {
            parts.push(self.line(&rung.line, begin));
        }
        match &rung.end {
            End::Open => {}
            End::Outputs(outputs) => parts.push(format!("-> {}", joined(outputs, output, ", "))),
            End::Branches(rungs) => parts.push(format!("{{ {} }}", joined(rungs, |rung| self.rung(rung, Begin::Tap), " ; "))),
        }
        parts.join(" ")
    }

    fn line(&self, line: &[Element], begin: Begin) -> String {
        match self.drawing {
            Drawing::Lad => joined(line, |one| self.element(&one.kind), " "),
            Drawing::Fbd => self.fbd_line(line, begin),
        }
    }

    fn inside(&self, line: &[Element]) -> String {
        self.line(line, Begin::Inside)
    }

    /// Operands side by side are an & box; what acts on the line comes after it.
    fn fbd_line(&self, line: &[Element], begin: Begin) -> String {
        let mut left = Left { value: None, taps: begin == Begin::Tap, inputs: Vec::new() };
        for Element { kind, .. } in line {
            match kind {
                Kind::Edge { falling, memory } => {
                    let before = left.take().unwrap_or_default();
                    left.value = Some(format!("{}({before}, {memory})", if *falling { "N" } else { "P" }));
                }
                Kind::Not => {
                    let before = left.take().map(|before| before + " ").unwrap_or_default();
                    left.value = Some(before + "!");
                }
                _ if kind.acts_on_line() => {
                    let mut before = left.take();
                    let text = match power_pin(kind) {
                        Some(pin) => {
                            let power = before.take_if(|before| !before.contains("->")).map(|before| format!("{pin} := {before}"));
                            self.with_pin(kind, power)
                        }
                        None => self.in_chain(kind),
                    };
                    left.value = Some(before.map(|before| before + " -> ").unwrap_or_default() + &text);
                }
                _ => left.inputs.push(self.element(kind)),
            }
        }
        left.take().unwrap_or_default()
    }

    /// After an arrow a call without pins would be a coil.
    fn in_chain(&self, kind: &Kind) -> String {
        match kind {
            Kind::Call { instance: None, pins, .. } if pins.is_empty() => self.element(kind).trim_end_matches("()").to_owned() + "()",
            _ => self.element(kind),
        }
    }

    fn element(&self, kind: &Kind) -> String {
        match kind {
            Kind::Contact { operand, negated } if operand.is_status() => format!("{}[{operand}]", slash(*negated)),
            Kind::Contact { operand, negated } => format!("{}{operand}", slash(*negated)),
            Kind::Compare { operation, left, right, negated } => format!("{}[{left} {operation} {right}]", slash(*negated)),
            Kind::Parallel { branches, negated } => format!("{}{}", circle(*negated), self.parallel(branches)),
            Kind::Xor { inputs, negated } => {
                let input = |input: &XorInput| format!("{}{}", slash(input.negated), self.inside(&input.line));
                format!("{}xor({})", circle(*negated), joined(inputs, input, ", "))
            }
            Kind::Group { line, negated } => self.group(line, *negated),
            Kind::Tap { negated } => format!("{}.", slash(*negated)),
            Kind::Edge { falling, memory } => format!("{}({memory})", if *falling { "N" } else { "P" }),
            Kind::EdgeBox { falling, operand, memory } => {
                let memory = memory.as_ref().map(|memory| format!(",{memory}")).unwrap_or_default();
                format!("{}({operand}{memory})", if *falling { "NEG" } else { "POS" })
            }
            Kind::Not => "!".to_owned(),
            Kind::Midline { operand, negated } => format!("{}#({operand})", slash(*negated)),
            Kind::Box { row, inputs, output } => plain_box(row, inputs, output),
            Kind::FlipFlop { .. } | Kind::Timer(_) | Kind::Counter(_) => self.with_pin(kind, None),
            Kind::Call { block, instance, pins } => self.call(block, instance.as_ref(), pins),
            Kind::Named(named) => self.named(named),
        }
    }

    fn parallel(&self, branches: &[Branch]) -> String {
        let (open, between) = match self.drawing {
            Drawing::Lad => ("(", " | "),
            Drawing::Fbd => ("or(", ", "),
        };
        let branch = |branch: &Branch| {
            let line = self.inside(&branch.line);
            if branch.bracketed { format!("({line})") } else { line }
        };
        format!("{open}{})", joined(branches, branch, between))
    }

    fn group(&self, line: &[Element], negated: bool) -> String {
        let inside = self.inside(line);
        let is_group = self.drawing == Drawing::Fbd && inside.starts_with("and(") && line.iter().all(|one| !one.kind.acts_on_line());
        match (self.drawing, negated) {
            (_, true) if is_group => format!("!{inside}"),
            (Drawing::Fbd, false) => inside,
            _ => format!("{}({inside})", circle(negated)),
        }
    }

    /// A box with an operand above it; `power` is its first pin, if logic is written there.
    fn with_pin(&self, kind: &Kind, power: Option<String>) -> String {
        let mut pins: Vec<String> = power.into_iter().collect();
        match kind {
            Kind::FlipFlop { reset_first, operand, second } => {
                let (name, pin) = if *reset_first { ("RS", "S") } else { ("SR", "R") };
                pins.extend(self.pin(pin, second.as_ref()));
                above(name, operand, &pins)
            }
            Kind::Timer(timer) => self.timer(timer, pins),
            Kind::Counter(counter) => self.counter(counter, pins),
            _ => String::new(),
        }
    }

    fn timer(&self, timer: &Timer, mut pins: Vec<String>) -> String {
        pins.push(format!("TV := {}", timer.value));
        pins.extend(self.pin("R", timer.reset.as_ref()));
        pins.extend(output_pin("BI", timer.binary.as_ref()));
        pins.extend(output_pin("BCD", timer.bcd.as_ref()));
        above(timer.kind.box_name(), &timer.timer, &pins)
    }

    fn counter(&self, counter: &Counter, mut pins: Vec<String>) -> String {
        pins.extend(self.pin("CD", counter.down.as_ref()));
        if let Some((line, value)) = &counter.set {
            pins.extend(self.pin("S", Some(line)));
            pins.push(format!("PV := {value}"));
        }
        pins.extend(self.pin("R", counter.reset.as_ref()));
        pins.extend(output_pin("CV", counter.value.as_ref()));
        pins.extend(output_pin("CV_BCD", counter.bcd.as_ref()));
        above(counter.kind.box_name(), &counter.counter, &pins)
    }

    fn pin(&self, name: &str, line: Option<&Line>) -> Option<String> {
        line.map(|line| format!("{name} := {}", self.inside(line)))
    }

    fn call(&self, block: &Operand, instance: Option<&Operand>, pins: &[Pin]) -> String {
        let one = |pin: &Pin| {
            let name = pin.name.as_name();
            match &pin.actual {
                Actual::Direct(actual) if actual.is_bit_address() => format!("{name} := ={actual}"),
                Actual::Direct(actual) => format!("{name} := {actual}"),
                // A name alone would be handed on as it is.
                Actual::Logic(line) if pin.actual.is_name_of_bit() => format!("{name} := ({})", self.inside(line)),
                Actual::Logic(line) => format!("{name} := {}", self.inside(line)),
                Actual::Output(output) => format!("{name} => {output}"),
            }
        };
        let instance_text = instance.map(|db| format!(", {db}")).unwrap_or_default();
        // Without the brackets a name that follows would be the instance.
        let brackets = !pins.is_empty() || (instance.is_none() && block.starts_with('"'));
        let pins = if brackets { format!("({})", joined(pins, one, ", ")) } else { String::new() };
        format!("CALL {block}{instance_text}{pins}")
    }

    fn named(&self, named: &NamedBox) -> String {
        let mut pins: Vec<String> = named.power.iter().map(|pin| format!("{pin} := .")).collect();
        for input in &named.inputs {
            let line = self.inside(&input.line);
            let line = if input.negated && input.line.len() > 1 { format!("({line})") } else { line };
            let name = input.name.as_ref().map(|name| format!("{name} := ")).unwrap_or_default();
            pins.push(format!("{name}{}{line}", slash(input.negated)));
        }
        // A word alone before the arrow would be read as the name of the output.
        let may_be_name = |input: &NamedInput| {
            let alone = match input.line.as_slice() {
                [Element { kind: Kind::Contact { operand, negated: false }, .. }] => Some(operand),
                _ => None,
            };
            !input.negated && alone.is_some_and(|operand| operand.starts_with('"') || may_name_output(operand))
        };
        let by_position = named.inputs.last().is_some_and(|input| input.name.is_none() && !may_be_name(input));
        for (index, (name, output)) in named.outputs.iter().enumerate() {
            match (name, pins.last_mut()) {
                (Some(name), _) => pins.push(format!("{name} => {output}")),
                // `ADD(a, b => sum)`.
                (None, Some(last)) if index == 0 && by_position => last.push_str(&format!(" => {output}")),
                (None, _) => pins.push(format!("=> {output}")),
            }
        }
        pins.extend(named.flow.iter().map(|pin| format!("{pin} => .")));
        let instance = named.instance.as_ref().map(|instance| format!("[{instance}]")).unwrap_or_default();
        format!("{}{instance}({})", named.name, pins.join(", "))
    }
}

/// What an & box takes so far, and what stands to its left.
struct Left {
    value: Option<String>,
    /// The tapped line comes from the left and is not used yet.
    taps: bool,
    inputs: Vec<String>,
}

impl Left {
    /// All of it as one value.
    fn take(&mut self) -> Option<String> {
        let mut inputs = std::mem::take(&mut self.inputs);
        let before = self.value.take();
        let taps = std::mem::take(&mut self.taps);
        if inputs.is_empty() {
            return before.or(taps.then(|| ".".to_owned()));
        }
        if before.is_some() || taps {
            inputs.insert(0, ".".to_owned());
        }
        let joined = match inputs.as_slice() {
            [only] => only.clone(),
            _ => format!("and({})", inputs.join(", ")),
        };
        Some(before.map(|before| before + " -> ").unwrap_or_default() + &joined)
    }
}

fn joined<T>(items: &[T], one: impl Fn(&T) -> String, between: &str) -> String {
    items.iter().map(one).collect::<Vec<_>>().join(between)
}

fn slash(negated: bool) -> &'static str {
    if negated { "/" } else { "" }
}

fn circle(negated: bool) -> &'static str {
    if negated { "!" } else { "" }
}

/// The pin that the line from the left enters, of boxes with an operand above them.
fn power_pin(kind: &Kind) -> Option<&'static str> {
    match kind {
        Kind::FlipFlop { reset_first, .. } => Some(if *reset_first { "R" } else { "S" }),
        Kind::Timer(_) => Some("S"),
        Kind::Counter(counter) => Some(counter.kind.power_pin()),
        _ => None,
    }
}

fn plain_box(row: &BoxRow, inputs: &[Operand], output: &Operand) -> String {
    let inputs: Vec<String> = match row.reversed {
        true => row.inputs.iter().zip(inputs).map(|(name, input)| format!("{name} := {input}")).collect(),
        false => inputs.iter().map(ToString::to_string).collect(),
    };
    format!("{}({} => {output})", row.name, inputs.join(", "))
}

fn above(name: &str, operand: &Operand, pins: &[String]) -> String {
    if pins.is_empty() { format!("{name}[{operand}]") } else { format!("{name}[{operand}]({})", pins.join(", ")) }
}

fn output_pin(name: &str, output: Option<&Operand>) -> Option<String> {
    output.map(|output| format!("{name} => {output}"))
}

fn output(output: &Output) -> String {
    match &output.kind {
        OutputKind::Assign(operand) => format!("= {operand}"),
        OutputKind::AssignNegated(operand) => format!("/ {operand}"),
        OutputKind::AssignEdge { falling, operand } => format!("{} {operand}", if *falling { "N" } else { "P" }),
        OutputKind::Set(operand) => format!("S {operand}"),
        OutputKind::Reset(operand) => format!("R {operand}"),
        OutputKind::Save => "SAVE".to_owned(),
        OutputKind::Return => "RET".to_owned(),
        OutputKind::Jump(label) => format!("JMP {label}"),
        OutputKind::JumpNot(label) => format!("JMPN {label}"),
        OutputKind::Call(block) => format!("CALL {block}"),
        OutputKind::McrStart => "MCR<".to_owned(),
        OutputKind::Timer { kind, timer, value } => format!("{} {timer} {value}", kind.instruction()),
        OutputKind::SetCounter { counter, value } => format!("SC {counter} {value}"),
        OutputKind::CountUp(counter) => format!("CU {counter}"),
        OutputKind::CountDown(counter) => format!("CD {counter}"),
    }
}
