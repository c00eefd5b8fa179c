//! Counters and edge memories of a network: what keeps something from one scan to the next, and belongs to one element. Timers are followed on the paths of
//! the statements.

use super::boxes::CounterKind;
use super::model::{Actual, Content, Element, End, Kind, Network, Place, Rung};
use super::operand::Operand;

/// What an element keeps something in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Memory {
    /// The counter of a box of this kind: one that counts up and one that counts down have an edge of their own.
    Counter(CounterKind),
    /// The bit in which an edge keeps what its line was.
    Edge,
}

impl Memory {
    /// What a second element does with it.
    pub fn used_twice(self, operand: &Operand) -> String {
        match self {
            Self::Counter(kind) => format!("a second box {} counts with `{operand}`", kind.box_name()),
            Self::Edge => format!("a second edge keeps its line in `{operand}`"),
        }
    }

    /// What to do instead.
    pub fn instead(self) -> &'static str {
        match self {
            Self::Counter(_) => "Join the lines before one box, or take another counter.",
            Self::Edge => "Take another bit: the two edges would write to it in turn.",
        }
    }
}

/// All of a network, in its order.
pub fn memories(network: &Network) -> Vec<(Memory, &Operand, Place)> {
    let mut found = Vec::new();
    if let Content::Rung(rung) = &network.content {
        in_rung(rung, &mut found);
    }
    found
}

fn in_rung<'n>(rung: &'n Rung, found: &mut Vec<(Memory, &'n Operand, Place)>) {
    in_line(&rung.line, found);
    if let End::Branches(rungs) = &rung.end {
        rungs.iter().for_each(|rung| in_rung(rung, found));
    }
}

fn in_line<'n>(line: &'n [Element], found: &mut Vec<(Memory, &'n Operand, Place)>) {
    for element in line {
        let place = element.place;
        match &element.kind {
            Kind::Edge { memory, .. } | Kind::EdgeBox { memory: Some(memory), .. } => found.push((Memory::Edge, memory, place)),
            Kind::Timer(timer) => in_line(timer.reset.as_deref().unwrap_or_default(), found),
            Kind::Counter(counter) => {
                let pins = [counter.down.as_ref(), counter.set.as_ref().map(|set| &set.0), counter.reset.as_ref()];
                pins.into_iter().flatten().for_each(|line| in_line(line, found));
                found.push((Memory::Counter(counter.kind), &counter.counter, place));
            }
            Kind::FlipFlop { second, .. } => in_line(second.as_deref().unwrap_or_default(), found),
            Kind::Parallel { branches, .. } => branches.iter().for_each(|branch| in_line(&branch.line, found)),
            Kind::Xor { inputs, .. } => inputs.iter().for_each(|input| in_line(&input.line, found)),
            Kind::Group { line, .. } => in_line(line, found),
            Kind::Named(named) => named.inputs.iter().for_each(|input| in_line(&input.line, found)),
            Kind::Call { pins, .. } => {
                for pin in pins {
                    if let Actual::Logic(line) = &pin.actual {
                        in_line(line, found);
                    }
                }
            }
            _ => {}
        }
    }
}
