//! Boxes as both drawings show them: title, operand above, pins with what is wired to them.

use sieben_lang::network::boxes::{CounterKind, PowerPins};
use sieben_lang::network::model::{Actual, Alone, Element, Kind, Line, NamedBox, Output, OutputKind, Pin};
use sieben_lang::network::operand::Operand;

/// A box.
pub(super) struct Face<'n> {
    /// Its title.
    pub(super) title: String,
    /// The operand or instance above it.
    pub(super) above: &'n str,
    /// The pin that the line from the left enters.
    pub(super) power: &'n str,
    /// The pin that the line goes on from.
    pub(super) flow: &'n str,
    /// Inputs below the power pin, top to bottom.
    pub(super) inputs: Vec<Input<'n>>,
    /// Outputs below the pin that the line goes on from: name, what is written.
    pub(super) outputs: Vec<(&'n str, Option<&'n str>)>,
    /// A box at one of its pins is there for its result, of any type.
    pub(super) hands_values_on: bool,
}

/// An input of a box.
pub(super) struct Input<'n> {
    /// Its name.
    pub(super) name: &'n str,
    /// With a circle.
    pub(super) negated: bool,
    /// What is wired to it.
    pub(super) wired: Wired<'n>,
}

/// What is wired to an input.
pub(super) enum Wired<'n> {
    /// Nothing.
    Open,
    /// An operand or constant.
    Operand(&'n str),
    /// A contact that stands at the pin as its operand.
    Contact(&'n Element, &'n str),
    /// Logic.
    Logic(&'n Line),
}

impl<'n> Input<'n> {
    fn direct(name: &'n str, operand: &'n str) -> Self {
        Self { name, negated: false, wired: Wired::Operand(operand) }
    }

    fn logic(name: &'n str, line: Option<&'n Line>) -> Self {
        Self { name, negated: false, wired: line.map_or(Wired::Open, Wired::Logic) }
    }
}

fn text(operand: Option<&Operand>) -> Option<&str> {
    operand.map(|operand| operand.text.as_str())
}

/// The face of a box; `None` for elements that are none.
pub(super) fn face(kind: &Kind) -> Option<Face<'_>> {
    Some(match kind {
        Kind::Box { row, inputs, output } => Face {
            title: row.name.to_owned(),
            above: "",
            power: "EN",
            flow: "ENO",
            inputs: row.inputs.iter().zip(inputs).map(|(name, input)| Input::direct(name, &input.text)).collect(),
            outputs: vec![("OUT", Some(&output.text))],
            hands_values_on: false,
        },
        Kind::FlipFlop { reset_first, operand, second } => {
            let (title, power, other) = if *reset_first { ("RS", "R", "S") } else { ("SR", "S", "R") };
            let inputs = vec![Input::logic(other, second.as_ref())];
            Face { title: title.to_owned(), above: operand, power, flow: "Q", inputs, outputs: Vec::new(), hands_values_on: false }
        }
        Kind::Timer(timer) => Face {
            title: timer.kind.box_name().to_owned(),
            above: &timer.timer,
            power: "S",
            flow: "Q",
            inputs: vec![Input::direct("TV", &timer.value), Input::logic("R", timer.reset.as_ref())],
            outputs: vec![("BI", text(timer.binary.as_ref())), ("BCD", text(timer.bcd.as_ref()))],
            hands_values_on: false,
        },
        Kind::Counter(counter) => {
            let mut inputs = Vec::new();
            if counter.kind == CounterKind::UpDown {
                inputs.push(Input::logic("CD", counter.down.as_ref()));
            }
            let (set, value) = match &counter.set {
                Some((line, value)) => (Some(line), Wired::Operand(value)),
                None => (None, Wired::Open),
            };
            inputs.push(Input::logic("S", set));
            inputs.push(Input { name: "PV", negated: false, wired: value });
            inputs.push(Input::logic("R", counter.reset.as_ref()));
            Face {
                title: counter.kind.box_name().to_owned(),
                above: &counter.counter,
                power: counter.kind.power_pin(),
                flow: "Q",
                inputs,
                outputs: vec![("CV", text(counter.value.as_ref())), ("CV_BCD", text(counter.bcd.as_ref()))],
                hands_values_on: false,
            }
        }
        Kind::Call { block, instance, pins } => call(block, instance.as_ref(), pins),
        Kind::Named(named) => named_box(named),
        _ => return None,
    })
}

fn call<'n>(block: &'n Operand, instance: Option<&'n Operand>, pins: &'n [Pin]) -> Face<'n> {
    let (mut inputs, mut outputs) = (Vec::new(), Vec::new());
    for pin in pins {
        match &pin.actual {
            Actual::Direct(operand) => inputs.push(Input::direct(&pin.name, operand)),
            Actual::Logic(line) => inputs.push(Input::logic(&pin.name, Some(line))),
            Actual::Output(operand) => outputs.push((pin.name.text.as_str(), Some(operand.text.as_str()))),
        }
    }
    let (title, above) = (block.text.clone(), text(instance).unwrap_or(""));
    Face { title, above, power: "EN", flow: "ENO", inputs, outputs, hands_values_on: false }
}

fn named_box(named: &NamedBox) -> Face<'_> {
    let inputs = named.inputs.iter().map(|input| {
        let wired = match input.line.as_slice() {
            [] => Wired::Open,
            [only] if let Kind::Contact { operand, .. } = &only.kind => Wired::Contact(only, operand),
            _ => Wired::Logic(&input.line),
        };
        let closed = matches!(input.line.as_slice(), [Element { kind: Kind::Contact { negated: true, .. }, .. }]);
        Input { name: text(input.name.as_ref()).unwrap_or(""), negated: input.negated ^ closed, wired }
    });
    let pins = named.instance.as_ref().and_then(|_| PowerPins::of(&named.name));
    let usual = pins.map_or(("EN", "ENO"), |pins| (pins.input.first().copied().unwrap_or("EN"), pins.output));
    Face {
        title: named.name.text.clone(),
        above: text(named.instance.as_ref()).unwrap_or(""),
        power: text(named.power.as_ref()).unwrap_or(usual.0),
        flow: text(named.flow.as_ref()).unwrap_or(usual.1),
        inputs: inputs.collect(),
        outputs: named.outputs.iter().map(|(name, operand)| (text(name.as_ref()).unwrap_or(""), Some(operand.text.as_str()))).collect(),
        hands_values_on: true,
    }
}

/// An element that stands alone: the operand above it, and what stands in it.
pub(super) fn alone(alone: &Alone) -> (&str, &'static str) {
    match alone {
        Alone::Open(block) => (block, "OPN"),
        Alone::McrActivate => ("", "MCRA"),
        Alone::McrDeactivate => ("", "MCRD"),
        Alone::McrEnd => ("", "MCR>"),
        Alone::Jump(label) => (label, "JMP"),
        Alone::Call(block) => (block, "CALL"),
        Alone::Return => ("", "RET"),
    }
}

/// What stands at the right end: the operand above it, what stands in it, and its value with the name of its pin.
pub(super) struct Coil<'n> {
    pub(super) above: &'n str,
    pub(super) mark: &'static str,
    pub(super) value: Option<(&'static str, &'n str)>,
}

/// The coil of an output.
pub(super) fn coil(output: &Output) -> Coil<'_> {
    let of = |above, mark| Coil { above, mark, value: None };
    match &output.kind {
        OutputKind::Assign(operand) => of(operand, ""),
        OutputKind::AssignNegated(operand) => of(operand, "/"),
        OutputKind::AssignEdge { falling, operand } => of(operand, if *falling { "N" } else { "P" }),
        OutputKind::Set(operand) => of(operand, "S"),
        OutputKind::Reset(operand) => of(operand, "R"),
        OutputKind::Save => of("", "SAVE"),
        OutputKind::Return => of("", "RET"),
        OutputKind::Jump(label) => of(label, "JMP"),
        OutputKind::JumpNot(label) => of(label, "JMPN"),
        OutputKind::Call(block) => of(block, "CALL"),
        OutputKind::McrStart => of("", "MCR<"),
        OutputKind::Timer { kind, timer, value } => Coil { above: timer, mark: kind.instruction(), value: Some(("TV", value)) },
        OutputKind::SetCounter { counter, value } => Coil { above: counter, mark: "SC", value: Some(("PV", value)) },
        OutputKind::CountUp(counter) => of(counter, "CU"),
        OutputKind::CountDown(counter) => of(counter, "CD"),
    }
}
