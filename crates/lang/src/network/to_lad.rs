//! What ladder cannot draw, and how it is drawn instead.

use std::collections::BTreeSet;

use super::model::{Actual, Branch, Content, Element, End, Kind, Line, Network, Place, Rung, XorInput};
use super::operand::Operand;
use super::reasons::{Reason, Refusal, Rewrite};
use super::write::reads_tap;

/// The network as ladder can draw it, and which rewrites that took.
///
/// # Errors
///
/// The first element that only a function block diagram has.
pub fn to_lad(network: &Network) -> Result<(Network, BTreeSet<Rewrite>), Refusal> {
    let mut drawer = Drawer { rewrites: BTreeSet::new() };
    let content = match &network.content {
        Content::Rung(rung) => Content::Rung(drawer.rung(rung, Begins::Rail)?),
        other => other.clone(),
    };
    Ok((Network { label: network.label.clone(), content }, drawer.rewrites))
}

type Drawn<T> = Result<T, Refusal>;

/// Where a line begins.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Begins {
    /// At the rail.
    Rail,
    /// At a tapped line, which comes from the left unless the line reads it itself.
    Tap,
    /// It is a branch or a pin.
    Inside,
}

struct Drawer {
    rewrites: BTreeSet<Rewrite>,
}

fn refuse<T>(reason: Reason, place: Place) -> Drawn<T> {
    Err(Refusal::new(reason, usize::try_from(place.first).unwrap_or(usize::MAX)))
}

impl Drawer {
    fn rung(&mut self, rung: &Rung, begins: Begins) -> Drawn<Rung> {
        let line = self.line(&rung.line, begins)?;
        let end = match &rung.end {
            End::Branches(rungs) => End::Branches(rungs.iter().map(|rung| self.rung(rung, Begins::Tap)).collect::<Drawn<_>>()?),
            other => other.clone(),
        };
        Ok(Rung { line, end, tap: rung.tap })
    }

    fn line(&mut self, elements: &[Element], begins: Begins) -> Drawn<Line> {
        let mut out = Line::new();
        let from_left = begins == Begins::Tap && !reads_tap(elements);
        for (index, element) in elements.iter().enumerate() {
            let place = element.place;
            match &element.kind {
                Kind::Tap { negated: true } if index == 0 && begins == Begins::Tap => {
                    self.rewrites.insert(Rewrite::NegatedBracket);
                    out.push(Kind::Not.at(place));
                }
                Kind::Tap { .. } => return refuse(Reason::Back, place),
                Kind::Xor { inputs, negated } => out.push(self.exclusive(inputs, *negated, place)?),
                kind if kind.is_negated() && !matches!(kind, Kind::Contact { .. }) => {
                    let positive = self.line(&positive(element), Begins::Inside)?;
                    self.rewrites.insert(Rewrite::NegatedBracket);
                    // NOT acts on all of the line to its left, so that the negated part moves to the front, past what only reads.
                    let memory = written(&positive);
                    if from_left || !out.iter().all(|one| only_reads(&one.kind) && !memory.iter().any(|bit| reads(&one.kind, bit))) {
                        return refuse(Reason::Neg, place);
                    }
                    let before = std::mem::take(&mut out);
                    out.extend(positive);
                    out.push(Kind::Not.at(place));
                    out.extend(before);
                }
                Kind::Group { line, .. } => {
                    if from_left || !out.is_empty() {
                        let culprit = line.iter().find(|one| one.kind.acts_on_line()).map_or(place, |one| one.place);
                        return refuse(Reason::Neg, culprit);
                    }
                    out.extend(self.line(line, begins)?);
                }
                Kind::Midline { negated: true, .. } => return refuse(Reason::Neg, place),
                Kind::Parallel { branches, .. } => {
                    let branch =
                        |branch: &Branch| Ok(Branch { line: self.line(&branch.line, Begins::Inside)?, bracketed: branch.bracketed });
                    let branches = branches.iter().map(branch).collect::<Drawn<_>>()?;
                    out.push(Kind::Parallel { branches, negated: false }.at(place));
                }
                kind => out.push(self.pins(kind)?.at(place)),
            }
        }
        Ok(out)
    }

    /// Two branches in parallel: one, and not the other. An XNOR has one side negated.
    fn exclusive(&mut self, inputs: &[XorInput], negated: bool, place: Place) -> Drawn<Element> {
        let [left, right] = inputs else { return refuse(Reason::Neg, place) };
        let (Some(left), Some(right)) = (as_contact(left), as_contact(right)) else { return refuse(Reason::Neg, place) };
        self.rewrites.insert(Rewrite::ExclusiveOr);
        let flip = left.1 ^ right.1 ^ negated;
        let branch = |first: bool, second: bool| Branch {
            line: vec![Kind::contact(left.0.clone(), first).at(place), Kind::contact(right.0.clone(), second).at(place)],
            bracketed: false,
        };
        let branches = if flip { vec![branch(false, false), branch(true, true)] } else { vec![branch(false, true), branch(true, false)] };
        Ok(Kind::Parallel { branches, negated: false }.at(place))
    }

    /// The logic at the pins of a box.
    fn pins(&mut self, kind: &Kind) -> Drawn<Kind> {
        let mut kind = kind.clone();
        match &mut kind {
            Kind::FlipFlop { second, .. } => self.pin(second.as_mut())?,
            Kind::Timer(timer) => self.pin(timer.reset.as_mut())?,
            Kind::Counter(counter) => {
                self.pin(counter.down.as_mut())?;
                self.pin(counter.set.as_mut().map(|set| &mut set.0))?;
                self.pin(counter.reset.as_mut())?;
            }
            Kind::Call { pins, .. } => {
                for pin in pins {
                    if let Actual::Logic(line) = &mut pin.actual {
                        self.pin(Some(line))?;
                    }
                }
            }
            _ => {}
        }
        Ok(kind)
    }

    fn pin(&mut self, line: Option<&mut Line>) -> Drawn<()> {
        if let Some(line) = line {
            *line = self.line(line, Begins::Inside)?;
        }
        Ok(())
    }
}

fn as_contact(input: &XorInput) -> Option<(&Operand, bool)> {
    match input.line.as_slice() {
        [Element { kind: Kind::Contact { operand, negated }, .. }] => Some((operand, *negated ^ input.negated)),
        _ => None,
    }
}

/// A negated element without its circle.
fn positive(element: &Element) -> Line {
    let mut element = element.clone();
    if let Kind::Group { line, .. } = element.kind {
        return line;
    }
    element.kind.negate();
    vec![element]
}

/// The bits that a line writes on its way: edge memory and midline outputs.
fn written(line: &[Element]) -> Vec<Operand> {
    let mut bits = Vec::new();
    for element in line {
        match &element.kind {
            Kind::Edge { memory, .. } | Kind::EdgeBox { memory: Some(memory), .. } => bits.push(memory.clone()),
            Kind::Midline { operand, .. } => bits.push(operand.clone()),
            Kind::Parallel { branches, .. } => bits.extend(branches.iter().flat_map(|branch| written(&branch.line))),
            Kind::Group { line, .. } => bits.extend(written(line)),
            Kind::Xor { inputs, .. } => bits.extend(inputs.iter().flat_map(|input| written(&input.line))),
            _ => {}
        }
    }
    bits
}

/// Contacts that read a bit.
fn reads(kind: &Kind, bit: &Operand) -> bool {
    match kind {
        Kind::Contact { operand, .. } => operand == bit,
        Kind::Parallel { branches, .. } => branches.iter().any(|branch| branch.line.iter().any(|one| reads(&one.kind, bit))),
        _ => false,
    }
}

/// It only reads, so that it does not matter when.
fn only_reads(kind: &Kind) -> bool {
    match kind {
        Kind::Contact { .. } | Kind::Compare { .. } => true,
        Kind::Parallel { branches, .. } => branches.iter().all(|branch| branch.line.iter().all(|one| only_reads(&one.kind))),
        _ => false,
    }
}
