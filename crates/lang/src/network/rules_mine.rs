//! What a diagram that is written down has to keep to: no open wire, no short circuit, a condition where an element needs one.

use super::mistake::{Mistake, MistakeKind};
use super::model::{Actual, Content, Element, End, Kind, Network, Output, OutputKind, Place, Rung};
use super::notation::{Drawing, Flavour};

/// What is wrong with a network whose places are bytes of its text.
pub fn mistakes(network: &Network, drawing: Drawing, flavour: Flavour, text: &str) -> Vec<Mistake> {
    let mut rules = Rules { drawing, flavour, text, mistakes: Vec::new() };
    if let Content::Rung(rung) = &network.content {
        rules.rung(rung, Power::Rail);
    }
    rules.mistakes
}

/// What comes from the left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Power {
    /// The rail: no logic yet.
    Rail,
    /// A line that carries logic.
    Logic,
}

struct Rules<'t> {
    drawing: Drawing,
    flavour: Flavour,
    text: &'t str,
    mistakes: Vec<Mistake>,
}

impl Rules<'_> {
    fn report(&mut self, kind: MistakeKind, place: Place, message: impl Into<String>, help: &str) {
        let mistake = Mistake::new(kind, place.first as usize, place.last as usize, message);
        self.mistakes.push(if help.is_empty() { mistake } else { mistake.help(help) });
    }

    /// The element as it is written.
    fn shown(&self, place: Place) -> String {
        let written = self.text.get(place.first as usize..place.last as usize).unwrap_or_default();
        let line = written.lines().next().unwrap_or_default().trim();
        let short: String = line.chars().take(60).collect();
        format!("`{short}`")
    }

    fn rung(&mut self, rung: &Rung, power: Power) {
        let power = self.line(&rung.line, power);
        match &rung.end {
            End::Open => match rung.line.last() {
                Some(last) if last.kind.is_box() => {}
                Some(last) => {
                    let message = format!("nothing follows {}: the wire is open", self.shown(last.place));
                    self.report(MistakeKind::Open, last.place, message, "a rung ends with a coil or with a box");
                }
                None => {}
            },
            End::Outputs(outputs) => self.outputs(outputs, power),
            End::Branches(rungs) => {
                let tapped = if power == Power::Rail && rung.line.is_empty() { Power::Rail } else { Power::Logic };
                let empty = rungs.iter().any(|one| one.line.is_empty() && matches!(one.end, End::Open));
                let place = rung.line.last().map_or_else(Place::default, |last| last.place);
                if empty || rungs.is_empty() {
                    self.report(MistakeKind::Open, place, "a branch of this T-branch has no element: its wire is open", "");
                }
                if tapped == Power::Rail && self.flavour == Flavour::S7 {
                    let place = rungs.first().and_then(first_place).unwrap_or(place);
                    self.report(
                        MistakeKind::Position,
                        place,
                        "a T-branch needs logic before it",
                        "write networks of their own for rungs that begin at the rail",
                    );
                }
                rungs.iter().for_each(|one| self.rung(one, Power::Logic));
            }
        }
    }

    fn outputs(&mut self, outputs: &[Output], power: Power) {
        for output in outputs {
            if power == Power::Rail && self.flavour == Flavour::S7 {
                let message = format!("{} needs a condition: no logic stands before it", self.shown(output.place));
                self.report(MistakeKind::Position, output.place, message, "write a contact before it");
            }
            let alone = matches!(
                output.kind,
                OutputKind::Jump(_) | OutputKind::JumpNot(_) | OutputKind::Return | OutputKind::Call(_) | OutputKind::McrStart
            );
            if alone && outputs.len() > 1 && self.flavour == Flavour::S7 {
                let message = format!("{} stands in parallel with other coils", self.shown(output.place));
                self.report(MistakeKind::Position, output.place, message, "give it a network of its own");
            }
        }
    }

    /// The elements of a line; what goes on from its end.
    fn line(&mut self, line: &[Element], mut power: Power) -> Power {
        for element in line {
            self.element(element, power);
            power = Power::Logic;
        }
        power
    }

    fn element(&mut self, element: &Element, power: Power) {
        let place = element.place;
        let needs_logic = match &element.kind {
            Kind::Edge { .. } | Kind::Not | Kind::Midline { .. } => true,
            Kind::FlipFlop { .. } | Kind::Timer(_) | Kind::Counter(_) => self.flavour == Flavour::S7,
            _ => false,
        };
        if needs_logic && power == Power::Rail {
            let message = format!("{} needs logic before it", self.shown(place));
            self.report(MistakeKind::Position, place, message, "it stands first in its line; write a contact before it");
        }
        let only_fbd = match &element.kind {
            Kind::Xor { .. } | Kind::Group { .. } | Kind::Tap { .. } => true,
            Kind::Compare { negated, .. } | Kind::Parallel { negated, .. } | Kind::Midline { negated, .. } => *negated,
            _ => false,
        };
        if only_fbd && self.drawing == Drawing::Lad {
            let message = format!("only FBD has {}", self.shown(place));
            self.report(MistakeKind::OnlyFbd, place, message, "begin the network with `NETWORK FBD`, or draw it with contacts and `NOT`");
        }
        match &element.kind {
            Kind::Parallel { branches, .. } => {
                if branches.len() == 1 {
                    self.report(
                        MistakeKind::Open,
                        place,
                        "this parallel has only one branch",
                        "write another branch, or leave the parallel out",
                    );
                }
                branches.iter().for_each(|branch| self.inner(&branch.line, place));
            }
            Kind::Xor { inputs, .. } => {
                if inputs.len() == 1 {
                    self.report(MistakeKind::Open, place, "this XOR has only one input", "");
                }
                inputs.iter().for_each(|input| self.inner(&input.line, place));
            }
            Kind::Group { line, .. } => self.inner(line, place),
            Kind::FlipFlop { second, .. } => self.pin(second.as_ref()),
            Kind::Timer(timer) => self.pin(timer.reset.as_ref()),
            Kind::Counter(counter) => {
                self.pin(counter.down.as_ref());
                self.pin(counter.set.as_ref().map(|(line, _)| line));
                self.pin(counter.reset.as_ref());
            }
            Kind::Call { pins, .. } => {
                for pin in pins {
                    if let Actual::Logic(line) = &pin.actual {
                        self.line(line, Power::Rail);
                    }
                }
            }
            Kind::Named(named) => named.inputs.iter().for_each(|input| {
                self.line(&input.line, Power::Rail);
            }),
            _ => {}
        }
    }

    /// A branch or an input.
    fn inner(&mut self, line: &[Element], place: Place) {
        if line.is_empty() {
            self.report(MistakeKind::Short, place, "a branch has no element: it would be a short circuit", "");
        }
        // The tap of a T-branch is an element of its own here.
        self.line(line, Power::Rail);
    }

    fn pin(&mut self, line: Option<&Vec<Element>>) {
        if let Some(line) = line {
            self.line(line, Power::Rail);
        }
    }
}

/// Where a rung begins.
fn first_place(rung: &Rung) -> Option<Place> {
    let output = match &rung.end {
        End::Outputs(outputs) => outputs.first().map(|output| output.place),
        _ => None,
    };
    rung.line.first().map(|element| element.place).or(output)
}
