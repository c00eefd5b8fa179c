//! Boxes of form B → elements.

use super::parse::{Left, Parsed, Parser, is_tap, takes_left};
use super::pins::{RawInput, RawPin};
use crate::network::boxes::{BoxRow, CounterKind, TimerKind};
use crate::network::model::{Actual, Counter, Kind, Line, NamedBox, NamedInput, Pin, Timer};
use crate::network::operand::Operand;

/// Boxes with an operand above them: flip-flops, timers, counters.
#[derive(Clone, Copy)]
enum Above {
    FlipFlop { reset_first: bool },
    Timer(TimerKind),
    Counter(CounterKind),
}

impl Above {
    fn of_name(name: &str) -> Option<Self> {
        let timer = TimerKind::ALL.iter().find(|row| row.2 == name).map(|row| Self::Timer(row.0));
        let counter = CounterKind::ALL.iter().find(|row| row.1 == name).map(|row| Self::Counter(row.0));
        match name {
            "SR" => Some(Self::FlipFlop { reset_first: false }),
            "RS" => Some(Self::FlipFlop { reset_first: true }),
            _ => timer.or(counter),
        }
    }

    /// The pin that the line from the left enters.
    fn power_pin(self) -> &'static str {
        match self {
            Self::FlipFlop { reset_first } => if_else(reset_first, "R", "S"),
            Self::Timer(_) => "S",
            Self::Counter(kind) => kind.power_pin(),
        }
    }

    /// Its other pins.
    fn pins(self) -> &'static [&'static str] {
        match self {
            Self::FlipFlop { reset_first } => if_else(reset_first, &["S"], &["R"]),
            Self::Timer(_) => &["TV", "R", "BI", "BCD"],
            Self::Counter(CounterKind::UpDown) => &["CD", "S", "PV", "R", "CV", "CV_BCD"],
            Self::Counter(_) => &["S", "PV", "R", "CV", "CV_BCD"],
        }
    }
}

fn if_else<T>(first: bool, then: T, otherwise: T) -> T {
    if first { then } else { otherwise }
}

pub(super) fn is_box_with_operand(name: &str) -> bool {
    Above::of_name(name).is_some()
}

/// The pins of a box, taken one by one.
struct Wiring(Vec<RawPin>);

impl Wiring {
    fn take(&mut self, name: &str) -> Option<RawPin> {
        let index = self.0.iter().position(|pin| pin.name.as_deref() == Some(name))?;
        Some(self.0.remove(index))
    }

    fn logic(&mut self, name: &str) -> Option<Line> {
        self.take(name)?.input?.line()
    }

    fn operand(&mut self, name: &str) -> Option<Operand> {
        self.take(name)?.input?.operand()
    }

    fn output(&mut self, name: &str) -> Option<Operand> {
        self.take(name)?.output
    }
}

impl Parser<'_> {
    pub(super) fn plain_box(&mut self, row: &'static BoxRow, from: usize) -> Parsed<Line> {
        let pins = self.pins()?;
        let mut inputs: Vec<Option<Operand>> = vec![None; row.inputs.len()];
        let mut output = None;
        let mut next = 0;
        for mut pin in pins {
            // `MW10 => MW12`: what stands before the arrow is an input, unless it is the name of the output.
            if pin.input.is_none() && pin.name.as_deref().is_some_and(|name| name != "OUT") {
                pin.name = None;
                pin.input = Some(RawInput::Operand(pin.written.clone(), Line::new()));
            }
            if let Some(input) = pin.input {
                let Some(operand) = input.operand() else {
                    return self.scan.wrong_at(pin.from, format!("an input of `{}` takes an operand or a constant, no logic", row.name));
                };
                let index = match &pin.name {
                    Some(name) => row.inputs.iter().position(|own| *name == *own),
                    None => Some(next),
                };
                let Some(slot) = index.and_then(|index| inputs.get_mut(index)) else {
                    let pins = row.inputs.join("`, `");
                    return self.scan.wrong_at(
                        pin.from,
                        format!("`{}` has no such input; its pins are `{pins}` and `OUT`, and what is written stands after `=>`", row.name),
                    );
                };
                if slot.replace(operand).is_some() {
                    return self.scan.wrong_at(pin.from, format!("this input of `{}` is wired twice", row.name));
                }
                next += 1;
            }
            if let Some(operand) = pin.output
                && output.replace(operand).is_some()
            {
                return self.scan.wrong_at(pin.from, format!("`{}` has one output", row.name));
            }
        }
        if let Some(open) = inputs.iter().position(Option::is_none) {
            let pin = row.inputs.get(open).copied().unwrap_or_default();
            return self.scan.wrong_at(from, format!("`{pin}` of `{}` is not wired", row.name));
        }
        let Some(output) = output else {
            return self.scan.wrong_at(from, format!("`OUT` of `{0}` is not wired: `{0}(… => MW 0)`", row.name));
        };
        self.one(Kind::Box { row, inputs: inputs.into_iter().flatten().collect(), output }, from)
    }

    /// `S_ODT[T 5](TV := S5T#2S, …)`.
    pub(super) fn box_with_operand(&mut self, name: &str, operand: Operand, from: usize, left: Left) -> Parsed<Line> {
        let Some(above) = Above::of_name(name) else { return self.scan.wrong_at(from, format!("there is no box `{name}`")) };
        let pins = if self.scan.touches('(') {
            self.scan.eat("(");
            self.pins()?
        } else {
            Vec::new()
        };
        let (power, known) = (above.power_pin(), above.pins());
        for pin in &pins {
            let wanted = pin.name.as_deref().filter(|own| *own == power || known.contains(own));
            let is_output = wanted.is_some_and(|own| ["BI", "BCD", "CV", "CV_BCD"].contains(&own));
            let fits = match (&pin.input, &pin.output) {
                (Some(RawInput::Direct(_)), _) => false,
                (Some(input), None) => {
                    !is_output && (matches!(input, RawInput::Operand(..)) || !wanted.is_some_and(|own| ["TV", "PV"].contains(&own)))
                }
                (None, Some(_)) => is_output,
                _ => false,
            };
            if wanted.is_none() {
                let pins = known.join("`, `");
                return self
                    .scan
                    .wrong_at(pin.from, format!("a pin of `{name}` is expected here: `{power}`, `{pins}`, each with its name"));
            }
            if !fits {
                let pin_name = wanted.unwrap_or_default();
                let way = if is_output { "=> MW 0" } else { ":= …" };
                return self.scan.wrong_at(pin.from, format!("`{pin_name}` of `{name}` is written `{pin_name} {way}`"));
            }
        }
        let mut pins = Wiring(pins);
        let mut front = Line::new();
        if let Some(pin) = pins.take(power) {
            front = pin.input.and_then(RawInput::line).unwrap_or_default();
            if !takes_left(&mut front, left) {
                return self.scan.wrong_at(pin.from, format!("the line from the left enters `{power}` already; write `.` for it"));
            }
        }
        let kind = match above {
            Above::FlipFlop { reset_first } => Kind::FlipFlop { reset_first, operand, second: pins.logic(if_else(reset_first, "S", "R")) },
            Above::Timer(kind) => {
                let Some(value) = pins.operand("TV") else {
                    return self.scan.wrong_at(from, format!("`TV`, the time, of `{name}` is not wired: `TV := S5T#2S`"));
                };
                let reset = pins.logic("R");
                Kind::Timer(Box::new(Timer { kind, timer: operand, value, reset, binary: pins.output("BI"), bcd: pins.output("BCD") }))
            }
            Above::Counter(kind) => {
                let set = match (pins.logic("S"), pins.operand("PV")) {
                    (None, None) => None,
                    (Some(line), Some(value)) => Some((line, value)),
                    _ => return self.scan.wrong_at(from, format!("`S` and `PV` of `{name}` are wired both or not at all")),
                };
                let down = pins.logic("CD");
                let reset = pins.logic("R");
                let (value, bcd) = (pins.output("CV"), pins.output("CV_BCD"));
                Kind::Counter(Box::new(Counter { kind, counter: operand, down, set, reset, value, bcd }))
            }
        };
        if let Some(again) = pins.0.first() {
            return self.scan.wrong_at(again.from, "this pin is wired twice");
        }
        front.push(kind.at(self.scan.since(from)));
        Ok(front)
    }

    /// `CALL FB 3, DB 6(IN := …)`.
    pub(super) fn call(&mut self, from: usize) -> Parsed<Line> {
        let block = self.scan.operand()?;
        let mut instance = None;
        if self.scan.touches(',') {
            let mark = self.scan.at;
            self.scan.eat(",");
            match self.scan.operand() {
                Ok(operand) if is_data_block(&operand) => instance = Some(operand),
                _ => self.scan.at = mark,
            }
        }
        let mut pins = Vec::new();
        if self.scan.touches('(') {
            self.scan.eat("(");
            for pin in self.pins()? {
                let Some(name) = pin.name else {
                    return self.scan.wrong_at(pin.from, "a pin of a call is written with its name: `NAME := …`");
                };
                let actual = match (pin.input, pin.output) {
                    (Some(RawInput::Direct(operand)), None) => Actual::Direct(operand),
                    (Some(RawInput::Operand(operand, line)), None) => Actual::of_operand(operand, line),
                    (Some(RawInput::Logic(line)), None) => Actual::Logic(line),
                    (None, Some(output)) => Actual::Output(output),
                    _ => return self.scan.wrong_at(pin.from, "a pin is either an input (`:=`) or an output (`=>`)"),
                };
                pins.push(Pin { name, actual });
            }
        }
        self.one(Kind::Call { block, instance, pins }, from)
    }

    /// A box of IEC 61131-3: `TON[delay](IN := ., PT := T#5s, Q => .)`.
    pub(super) fn named_box(&mut self, name: &str, from: usize) -> Parsed<Line> {
        let start = self.scan.since(from).first;
        self.scan.at = from + name.len();
        let name = Operand { text: name.to_owned(), start: Some(start) };
        let mut instance = None;
        if self.scan.touches('[') {
            self.scan.eat("[");
            instance = Some(self.scan.operand()?);
            self.scan.want("]", "`]` is missing after the instance")?;
        }
        self.scan.want("(", "`(` is missing before the pins")?;
        let mut named = NamedBox { name, instance, inputs: Vec::new(), outputs: Vec::new(), power: None, flow: None };
        for pin in self.pins()? {
            self.named_pin(&mut named, pin)?;
        }
        self.one(Kind::Named(Box::new(named)), from)
    }

    /// `ADD(a, b => sum)`: only those who know the box can tell whether `b` is one of its outputs, or its last input.
    fn named_pin(&mut self, named: &mut NamedBox, pin: RawPin) -> Parsed<()> {
        if let Some(input) = pin.input {
            let Some(mut line) = input.line() else { return self.scan.wrong_at(pin.from, "an input is written `NAME := …`") };
            if is_tap(&line) && !pin.negated {
                let (Some(name), None) = (pin.name, &named.power) else {
                    return self.scan.wrong_at(pin.from, "the line from the left enters one pin, which is named: `IN := .`");
                };
                named.power = Some(name);
                return Ok(());
            }
            let mut negated = pin.negated;
            if let [only] = line.as_mut_slice()
                && only.kind.is_negated()
                && !negated
            {
                negated = only.kind.negate();
            }
            if let [crate::network::model::Element { kind: Kind::Group { line: inner, negated: false }, .. }] = line.as_mut_slice() {
                line = std::mem::take(inner);
            }
            named.inputs.push(NamedInput { name: pin.name.clone(), negated, line });
            if let Some(output) = pin.output {
                if output == "." {
                    return self.scan.wrong_at(pin.from, "the line goes on from one output, which is named: `Q => .`");
                }
                named.outputs.push((None, output));
            }
            return Ok(());
        }
        match pin.output {
            Some(output) if output == "." => {
                let (Some(name), None) = (pin.name, &named.flow) else {
                    return self.scan.wrong_at(pin.from, "the line goes on from one output, which is named: `Q => .`");
                };
                named.flow = Some(name);
            }
            Some(output) => named.outputs.push((pin.name, output)),
            None => return self.scan.wrong_at(pin.from, "nothing is wired to this pin; leave it out"),
        }
        Ok(())
    }
}

/// What can be the instance of a call.
fn is_data_block(operand: &Operand) -> bool {
    let number = operand.get(..2).filter(|begin| begin.eq_ignore_ascii_case("DB")).and(operand.get(2..));
    number.is_some_and(|number| number.trim_start().starts_with(|sign: char| sign.is_ascii_digit())) || operand.starts_with('"')
}
