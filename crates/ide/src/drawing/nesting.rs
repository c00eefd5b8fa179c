//! What cannot be drawn, said before anything is: a diagram that nests too deep, and in ladder what only a function block diagram has.

use sieben_lang::network::model::{Actual, Content, Element, End, Kind, Network, Rung};

/// How deep branches, pins and T-branches of a diagram may lie in one another to be drawn: the S7 allows 7 brackets, and a picture of more than this would be read by no one.
pub const NESTING_MAX: usize = 100;

/// Why a network is not drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// It nests deeper than [`NESTING_MAX`].
    TooDeep,
    /// An element that only FBD has, named as a reader knows it.
    OnlyFunctionPlan(&'static str),
}

impl Refusal {
    /// One sentence.
    pub fn message(&self) -> String {
        match self {
            Self::TooDeep => format!("the diagram nests deeper than {NESTING_MAX} levels, more than is drawn"),
            Self::OnlyFunctionPlan(what) => format!("ladder has no element for {what}; as FBD it can be drawn"),
        }
    }
}

/// What is left to look at.
enum Task<'n> {
    Line(&'n [Element]),
    Rung(&'n Rung),
}

/// Walks through a network without recursion, since how deep it nests is the question.
pub(super) fn check(network: &Network, mut look: impl FnMut(&Element, bool) -> Option<Refusal>) -> Result<(), Refusal> {
    let Content::Rung(rung) = &network.content else { return Ok(()) };
    let mut tasks = vec![(Task::Rung(rung), 0)];
    while let Some((task, depth)) = tasks.pop() {
        if depth > NESTING_MAX {
            return Err(Refusal::TooDeep);
        }
        let line = match task {
            Task::Line(line) => line,
            Task::Rung(rung) => {
                if let End::Branches(rungs) = &rung.end {
                    tasks.extend(rungs.iter().map(|rung| (Task::Rung(rung), depth + 1)));
                }
                &rung.line
            }
        };
        for (index, element) in line.iter().enumerate() {
            if let Some(refusal) = look(element, index == 0) {
                return Err(refusal);
            }
            tasks.extend(parts(&element.kind).into_iter().map(|line| (Task::Line(line), depth + 1)));
        }
    }
    Ok(())
}

/// The lines that lie inside of an element.
fn parts(kind: &Kind) -> Vec<&[Element]> {
    match kind {
        Kind::Parallel { branches, .. } => branches.iter().map(|branch| branch.line.as_slice()).collect(),
        Kind::Xor { inputs, .. } => inputs.iter().map(|input| input.line.as_slice()).collect(),
        Kind::Group { line, .. } => vec![line],
        Kind::FlipFlop { second, .. } => second.iter().map(Vec::as_slice).collect(),
        Kind::Timer(timer) => timer.reset.iter().map(Vec::as_slice).collect(),
        Kind::Counter(counter) => {
            let set = counter.set.as_ref().map(|(line, _)| line);
            [counter.down.as_ref(), set, counter.reset.as_ref()].into_iter().flatten().map(Vec::as_slice).collect()
        }
        Kind::Call { pins, .. } => {
            let logic = pins.iter().filter_map(|pin| if let Actual::Logic(line) = &pin.actual { Some(line) } else { None });
            logic.map(Vec::as_slice).collect()
        }
        Kind::Named(named) => named.inputs.iter().map(|input| input.line.as_slice()).collect(),
        _ => Vec::new(),
    }
}

/// What ladder has no element for.
pub(super) fn only_function_plan(element: &Element, is_first: bool) -> Option<Refusal> {
    let what = match &element.kind {
        Kind::Xor { .. } => "an exclusive OR",
        Kind::Tap { .. } => "a line that is tapped a second time",
        Kind::Compare { negated: true, .. } => "a comparison with a circle",
        Kind::Parallel { negated: true, .. } | Kind::Group { negated: true, .. } => "a circle at a group",
        Kind::Midline { negated: true, .. } => "a midline output with a circle",
        Kind::Group { line, .. } if !is_first && line.iter().any(|one| one.kind.acts_on_line()) => "an edge or NOT of a part of the line",
        _ => return None,
    };
    Some(Refusal::OnlyFunctionPlan(what))
}
