//! Names for the pins that a box is written without, for those who draw it: a pin without a name is the next one of what the box calls.

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Interface, Section};
use sieben_model::types::DataType;

use crate::network::boxes::PowerPins;
use crate::network::model::{Content, End, Kind, Line, NamedBox, NamedInput, Network, Place, Rung};
use crate::network::operand::Operand;
use crate::st::dialect::Dialect;
use crate::st::standard::catalogue;

/// What the result of a function is called at its box.
const RESULT: &str = "OUT";

/// EN and ENO, which every box has.
const FLOW: [&str; 2] = ["EN", "ENO"];

/// The pins of what a box calls.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pins {
    inputs: Vec<String>,
    /// Whether more inputs may follow the last one, which are counted on: `IN2`, `IN3`.
    goes_on: bool,
    outputs: Vec<String>,
    /// `None` for a function block.
    result: Option<ResultKind>,
}

/// What a function delivers itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ResultKind {
    Nothing,
    Bool,
    Other,
    /// As its inputs have it.
    OfInputs,
}

impl Pins {
    /// Those of a block of the user.
    pub fn of_block(block: BlockId, interface: &Interface) -> Self {
        let mut declared: Vec<_> = interface.parameters().collect();
        declared.sort_by_key(|formal| formal.span.start);
        let of = |wanted: &[Section]| -> Vec<String> {
            declared.iter().filter(|formal| wanted.contains(&formal.section)).map(|formal| formal.name.clone()).collect()
        };
        let result = declared.iter().find(|formal| formal.section == Section::Return);
        let kind = match result.map(|formal| &formal.data_type) {
            None => ResultKind::Nothing,
            Some(DataType::Bool) => ResultKind::Bool,
            Some(_) => ResultKind::Other,
        };
        let is_function = matches!(block.kind, BlockKind::Function | BlockKind::SystemFunction);
        Self {
            inputs: of(&[Section::Input, Section::InOut]),
            goes_on: false,
            outputs: of(&[Section::Output]),
            result: is_function.then_some(kind),
        }
    }

    /// Those of a function or function block that the dialect brings along; `None` if there is none of this name, or its pins have no names.
    pub fn of_standard(name: &str, dialect: Dialect) -> Option<Self> {
        let page = catalogue::page(name)?;
        let calls = page.calls.iter().filter_map(|call| signature(call, dialect));
        let mut calls: Vec<(&str, Self)> = calls.collect();
        if let Some(own) = calls.iter().position(|(own, _)| own.eq_ignore_ascii_case(name)) {
            return Some(calls.swap_remove(own).1);
        }
        // One for many, as of the conversions: only what all have in common.
        let (_, first) = calls.first()?.clone();
        let is_common = calls.iter().all(|(_, other)| (&other.inputs, other.result.is_some()) == (&first.inputs, first.result.is_some()));
        let result = first.result.map(|_| ResultKind::OfInputs);
        is_common.then_some(Self { result, ..first })
    }

    /// Whether an output has this name.
    pub fn has_output(&self, name: &str) -> bool {
        self.outputs.iter().any(|output| output.eq_ignore_ascii_case(name))
    }

    /// An input by its place: after the last one it is counted on where that is so.
    fn input(&self, index: usize) -> Option<String> {
        if let Some(name) = self.inputs.get(index) {
            return Some(name.clone()).filter(|name| !name.is_empty());
        }
        let last = self.inputs.last().filter(|_| self.goes_on)?;
        let word = last.trim_end_matches(|sign: char| sign.is_ascii_digit());
        let number: usize = last[word.len()..].parse().ok()?;
        Some(format!("{word}{}", number.checked_add(index - self.inputs.len() + 1)?))
    }
}

/// How a call is written in the catalogue: `iec tia: MUX(K: ANY_INT; IN0: ANY; …): ANY`, `TON(IN: BOOL; PT: TIME) → Q: BOOL; ET: TIME`.
fn signature(call: &'static str, dialect: Dialect) -> Option<(&'static str, Pins)> {
    let (head, rest) = call.split_once('(')?;
    let (inside, after) = rest.split_once(')')?;
    let name = match head.split_once(": ") {
        Some((dialects, _)) if !dialects.split(' ').any(|one| one == dialect.base().name()) => return None,
        Some((_, name)) => name,
        None => head,
    };
    let mut pins = Pins { inputs: Vec::new(), goes_on: false, outputs: Vec::new(), result: None };
    for pin in inside.split(';').map(str::trim).filter(|pin| !pin.is_empty()) {
        match (pin.split_once(" => "), pin.split_once(": ")) {
            // What comes after it is written with its name.
            _ if pin == "…" => {
                pins.goes_on = true;
                break;
            }
            (Some((name, _)), _) => pins.outputs.push(name.to_owned()),
            (_, Some((name, _))) => pins.inputs.push(name.to_owned()),
            _ => pins.inputs.push(String::new()),
        }
    }
    match after.trim().strip_prefix('→') {
        Some(outputs) => pins.outputs.extend(outputs.split(';').filter_map(|pin| Some(pin.split_once(": ")?.0.trim().to_owned()))),
        None => {
            pins.result = Some(match after.trim_start_matches(':').trim() {
                "" => ResultKind::Nothing,
                "BOOL" => ResultKind::Bool,
                of_inputs if of_inputs.starts_with("ANY") || of_inputs.starts_with("the same") => ResultKind::OfInputs,
                _ => ResultKind::Other,
            });
        }
    }
    Some((name, pins))
}

/// Names all pins of the boxes of a network; `pins` says which ones a box has.
pub fn name_pins(network: &mut Network, pins: &dyn Fn(&str) -> Option<Pins>) {
    if let Content::Rung(rung) = &mut network.content {
        in_rung(rung, pins);
    }
}

fn in_rung(rung: &mut Rung, pins: &dyn Fn(&str) -> Option<Pins>) {
    let feeds = if matches!(rung.end, End::Open) { Feeds::Nothing } else { Feeds::Line };
    in_line(&mut rung.line, pins, feeds);
    if let End::Branches(rungs) = &mut rung.end {
        rungs.iter_mut().for_each(|rung| in_rung(rung, pins));
    }
}

/// What an element feeds.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Feeds {
    Nothing,
    Line,
    /// A pin of a box, with a value of any type.
    Pin,
}

fn in_line(line: &mut Line, pins: &dyn Fn(&str) -> Option<Pins>, feeds: Feeds) {
    let last = line.len().saturating_sub(1);
    for (index, element) in line.iter_mut().enumerate() {
        let place = element.place;
        match &mut element.kind {
            Kind::Parallel { branches, .. } => branches.iter_mut().for_each(|branch| in_line(&mut branch.line, pins, Feeds::Line)),
            Kind::Xor { inputs, .. } => inputs.iter_mut().for_each(|input| in_line(&mut input.line, pins, Feeds::Line)),
            Kind::Group { line, .. } => in_line(line, pins, Feeds::Line),
            Kind::Named(one) => {
                one.inputs.iter_mut().for_each(|input| in_line(&mut input.line, pins, Feeds::Pin));
                if let Some(pins) = pins(&one.name.text) {
                    in_box(one, &pins, place, if index == last { feeds } else { Feeds::Line });
                }
            }
            _ => {}
        }
    }
}

fn in_box(one: &mut NamedBox, pins: &Pins, place: Place, feeds: Feeds) {
    if let Some(result) = pins.result {
        as_of_function(one, pins, place);
        // A line goes on from the result if that is a BOOL which is not written anywhere.
        let names_result = |name: &Operand| name.eq_ignore_ascii_case(RESULT) || name.eq_ignore_ascii_case(&one.name);
        let is_written = one.outputs.iter().any(|(name, _)| name.as_ref().is_none_or(names_result));
        if one.flow.is_none() && !is_written {
            one.flow = match (feeds, result) {
                (Feeds::Nothing, _) | (_, ResultKind::Nothing) => None,
                (Feeds::Pin, _) | (Feeds::Line, ResultKind::Bool) => Some(RESULT.into()),
                // Only the types of its inputs say what it goes on from.
                (Feeds::Line, ResultKind::OfInputs) => Some("".into()),
                (Feeds::Line, ResultKind::Other) => None,
            };
        }
    }
    let of_line = |row: &PowerPins| row.input.iter().copied().find(|name| pins.inputs.iter().any(|own| own == name));
    let power = match (&one.power, pins.result) {
        (Some(power), _) => Some(power.text.as_str()),
        (None, None) => PowerPins::of(&one.name).and_then(of_line),
        (None, Some(_)) => None,
    };
    let mut given: Vec<String> = one.inputs.iter().filter_map(|input| Some(input.name.as_ref()?.to_lowercase())).collect();
    given.extend(power.map(str::to_lowercase));
    let mut next = 0;
    for input in one.inputs.iter_mut().filter(|input| input.name.is_none()) {
        let mut name = pins.input(next);
        while let Some(taken) = &name
            && given.contains(&taken.to_lowercase())
        {
            next += 1;
            name = pins.input(next);
        }
        next += 1;
        input.name = name.map(Operand::from);
    }
    let given: Vec<String> = one.outputs.iter().filter_map(|(name, _)| Some(name.as_ref()?.to_lowercase())).collect();
    let mut others = pins.outputs.iter().filter(|output| !given.contains(&output.to_lowercase()));
    for (name, _) in one.outputs.iter_mut().filter(|(name, _)| name.is_none()) {
        *name = match pins.result {
            Some(result) if result != ResultKind::Nothing => Some(RESULT.into()),
            _ => others.next().map(|output| output.as_str().into()),
        };
    }
}

/// What is an instance or an output by its look is an input of a function: `ABS x`, `ADD a, b => c`.
fn as_of_function(one: &mut NamedBox, pins: &Pins, place: Place) {
    let input = |operand: Operand| NamedInput { name: None, negated: false, line: vec![Kind::contact(operand, false).at(place)] };
    if let Some(first) = one.instance.take() {
        one.inputs.insert(0, input(first));
    }
    let own = one.name.text.clone();
    let is_output = |name: &Operand| {
        let mut known = pins.outputs.iter().map(String::as_str).chain(FLOW).chain([RESULT, own.as_str()]);
        known.any(|known| known.eq_ignore_ascii_case(name))
    };
    let by_position = one.inputs.iter().all(|input| input.name.is_none());
    for (name, _) in &mut one.outputs {
        if by_position && let Some(last) = name.take_if(|name| !is_output(name)) {
            one.inputs.push(input(last));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::network::flavour::{Drawing, Flavour};
    use crate::network::{form_a, form_b};

    fn named(text: &str) -> String {
        let mut network = form_a::parse(text, 0, text.len(), Flavour::Iec).network;
        name_pins(&mut network, &|name| Pins::of_standard(name, Dialect::Iec));
        form_b::print(&network, Drawing::Lad)
    }

    #[test]
    fn pins_without_names_are_the_next_ones() {
        let cases = [
            ("    NO on\n    ADD a, b => c\n    COIL d\n", "on ADD(IN1 := a, IN2 := b, OUT => c) -> = d"),
            ("    ADD a, b, e => c\n", "|- ADD(IN1 := a, IN2 := b, IN3 := e, OUT => c)"),
            ("    ABS a => c\n", "|- ABS(IN := a, OUT => c)"),
            ("    MUX k, a, b, e => c\n", "|- MUX(K := k, IN0 := a, IN1 := b, IN2 := e, OUT => c)"),
            ("    INT_TO_REAL a => c\n", "|- INT_TO_REAL(IN := a, OUT => c)"),
            ("    NO on\n    TON t\n        PT := T#1s\n        ET => c\n", "on TON[t](PT := T#1s, ET => c)"),
        ];
        for (text, wanted) in cases {
            assert_eq!(named(text), wanted, "{text}");
        }
    }

    #[test]
    fn every_call_of_the_catalogue_is_understood() {
        for page in catalogue::CHAPTERS.iter().flat_map(|chapter| chapter.pages) {
            for call in page.calls {
                // `TypeOf(variant) = type` is no call that a box may be.
                let read = Dialect::ALL.iter().find_map(|dialect| signature(call, *dialect));
                let Some((name, pins)) = read else { panic!("{call}") };
                let is_name = |text: &str| text.chars().all(|sign| sign.is_ascii_alphanumeric() || matches!(sign, '_' | '.'));
                assert!(is_name(name) && pins.inputs.iter().chain(&pins.outputs).all(|pin| is_name(pin)), "{call}: {pins:?}");
            }
        }
    }
}
