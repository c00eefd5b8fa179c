//! What a diagram must not do, whichever way it was written.

use super::flavour::{Drawing, Flavour};
use super::mistake::{Mistake, MistakeKind};
use super::model::{Actual, Content, Element, End, Kind, Line, Network, Output, OutputKind, Place, Rung};

/// How many elements a network may have. A block of STEP 7 has at most 64 Kbyte of code, which is about as many.
pub const ELEMENTS_MAX: usize = 8192;

/// How many brackets a CPU of the S7 keeps open at a time.
pub const BRACKETS_MAX: usize = 7;

/// The end of a rung with these coils. Coils that need a statement of their own before them stand on a T-branch each.
pub fn outputs(outputs: Vec<Output>) -> End {
    let plain = |output: &Output| {
        !matches!(output.kind, OutputKind::Timer { .. } | OutputKind::SetCounter { .. } | OutputKind::CountUp(_) | OutputKind::CountDown(_))
    };
    if outputs.len() < 2 || outputs.iter().all(plain) {
        return End::Outputs(outputs);
    }
    let rung = |output| Rung::new(Line::new(), End::Outputs(vec![output]));
    End::Branches(outputs.into_iter().map(rung).collect())
}

/// All that is wrong with a network, in its order. Places of elements are bytes of the text; `drawing` is what it is written as, if that is known.
pub fn mistakes(network: &Network, flavour: Flavour, drawing: Option<Drawing>) -> Vec<Mistake> {
    Rules::of(network, flavour, drawing).found
}

/// What a diagram has too much of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// Elements.
    Elements,
    /// Brackets inside one another.
    Brackets,
}

/// What a network has too much of, if anything.
pub fn limit(network: &Network) -> Option<Limit> {
    let rules = Rules::of(network, Flavour::S7, None);
    match rules.elements > ELEMENTS_MAX {
        true => Some(Limit::Elements),
        false => rules.found.iter().any(|mistake| mistake.kind == MistakeKind::Size).then_some(Limit::Brackets),
    }
}

/// What a line begins at.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Begin {
    /// The rail.
    Rail,
    /// A tapped line.
    Tap,
    /// Nothing: a branch, an input or a pin outside of a T-branch.
    Nothing,
    /// A branch, an input or a pin of a sub-rung, which may read the tapped line.
    InsideTap,
}

impl Begin {
    fn inside(self) -> Self {
        match self {
            Self::Rail | Self::Nothing => Self::Nothing,
            Self::Tap | Self::InsideTap => Self::InsideTap,
        }
    }
}

struct Rules {
    flavour: Flavour,
    drawing: Option<Drawing>,
    found: Vec<Mistake>,
    /// The last element that was looked at.
    place: Place,
    /// Elements that were looked at.
    elements: usize,
}

impl Rules {
    /// What is to be said of a network.
    fn of(network: &Network, flavour: Flavour, drawing: Option<Drawing>) -> Self {
        let mut rules = Self { flavour, drawing, found: Vec::new(), place: Place::default(), elements: 0 };
        if let Content::Rung(rung) = &network.content {
            rules.rung(rung, Begin::Rail);
        }
        rules
    }

    /// A mistake; what is to be done follows a semicolon.
    fn report(&mut self, kind: MistakeKind, place: Place, message: impl Into<String>) {
        self.found.push(Mistake::told(kind, place.first as usize, place.last as usize, &message.into()));
    }

    fn rung(&mut self, rung: &Rung, from: Begin) {
        self.line(&rung.line, from, 0);
        let logic = from == Begin::Tap || !rung.line.is_empty();
        match &rung.end {
            End::Open => {
                if !rung.line.last().is_some_and(|one| one.kind.is_box()) {
                    self.report(
                        MistakeKind::Open,
                        self.place,
                        "this rung has no output; end it with a coil such as `= Q 4.0`, or with a box",
                    );
                }
            }
            End::Outputs(outputs) => {
                for (index, output) in outputs.iter().enumerate() {
                    self.place = output.place;
                    if !logic && self.flavour == Flavour::S7 {
                        self.report(
                            MistakeKind::Position,
                            output.place,
                            "a coil needs logic before it; put a contact between it and the rail",
                        );
                    }
                    let leaves = matches!(
                        output.kind,
                        OutputKind::Jump(_) | OutputKind::JumpNot(_) | OutputKind::Return | OutputKind::Call(_) | OutputKind::McrStart
                    );
                    if leaves && index + 1 < outputs.len() {
                        self.report(MistakeKind::Position, output.place, "nothing may follow this coil in its rung; put it last");
                    }
                }
                if outputs.is_empty() {
                    self.report(MistakeKind::Open, self.place, "an output is missing at the end of this rung");
                }
            }
            End::Branches(rungs) => {
                if !logic {
                    self.report(
                        MistakeKind::Position,
                        self.place,
                        "a T-branch needs logic before it; put a contact between it and the rail",
                    );
                }
                if rungs.is_empty() {
                    self.report(MistakeKind::Open, self.place, "this T-branch has no branch");
                }
                rungs.iter().for_each(|rung| self.rung(rung, Begin::Tap));
            }
        }
    }

    /// A line inside of `depth` brackets.
    fn line(&mut self, line: &[Element], from: Begin, depth: usize) {
        self.elements += line.len();
        if self.elements > ELEMENTS_MAX && self.elements - line.len() <= ELEMENTS_MAX {
            let place = line.get(ELEMENTS_MAX - (self.elements - line.len())).map_or(self.place, |one| one.place);
            self.report(MistakeKind::Size, place, format!("a network has at most {ELEMENTS_MAX} elements; divide it into several"));
        }
        let boxes = line.iter().filter(|one| one.kind.is_box()).count();
        let ends_with_box = line.last().is_some_and(|one| one.kind.is_box());
        let depth = depth + boxes.saturating_sub(usize::from(ends_with_box));
        if depth > BRACKETS_MAX
            && self.flavour == Flavour::S7
            && let Some(element) = line.get(BRACKETS_MAX).or(line.last())
        {
            let message =
                format!("this needs more than {BRACKETS_MAX} brackets inside of one another, which a CPU does not have; split the network");
            return self.report(MistakeKind::Size, element.place, message);
        }
        for (index, element) in line.iter().enumerate() {
            self.place = element.place;
            let first = index == 0 && matches!(from, Begin::Rail | Begin::Nothing | Begin::InsideTap);
            match &element.kind {
                Kind::Edge { .. } | Kind::Not | Kind::Midline { .. } if first => {
                    self.report(
                        MistakeKind::Position,
                        element.place,
                        "this acts on the line to its left, and there is none; put a contact before it",
                    );
                }
                Kind::FlipFlop { .. } | Kind::Timer(_) | Kind::Counter(_) if first && self.flavour == Flavour::S7 => {
                    self.report(MistakeKind::Position, element.place, "the first input of this box has no logic; put a contact before it");
                }
                Kind::Tap { .. } if matches!(from, Begin::Rail | Begin::Nothing) => {
                    self.report(
                        MistakeKind::Position,
                        element.place,
                        "`.` stands for the line that a T-branch taps, and there is none here",
                    );
                }
                _ => {}
            }
            let only_fbd = match &element.kind {
                Kind::Xor { .. } | Kind::Group { .. } | Kind::Tap { .. } => true,
                Kind::Compare { negated, .. } | Kind::Parallel { negated, .. } | Kind::Midline { negated, .. } => *negated,
                _ => false,
            };
            if only_fbd && self.drawing == Some(Drawing::Lad) {
                let message = "only FBD has this element; begin the network with `NETWORK FBD`, or draw it with contacts and `NOT`";
                self.report(MistakeKind::OnlyFbd, element.place, message);
            }
            self.element(element, from, depth);
        }
    }

    fn element(&mut self, element: &Element, from: Begin, depth: usize) {
        let place = element.place;
        let inside = from.inside();
        match &element.kind {
            Kind::Parallel { branches, .. } => {
                if branches.len() == 1 {
                    self.report(
                        MistakeKind::Open,
                        place,
                        "this parallel has only one branch; write another one, or leave the parallel out",
                    );
                }
                for branch in branches {
                    if branch.line.is_empty() {
                        self.report(
                            MistakeKind::Short,
                            place,
                            "a branch without an element is a short circuit; put a contact into it, or take it away",
                        );
                    }
                    self.line(&branch.line, inside, depth + 1);
                }
            }
            Kind::Xor { inputs, .. } => {
                if inputs.len() < 2 {
                    self.report(MistakeKind::Open, place, "an exclusive OR needs two inputs");
                }
                for input in inputs {
                    self.pin(Some(&input.line), place, inside, depth);
                }
            }
            Kind::Group { line, .. } => self.pin(Some(line), place, inside, depth),
            Kind::FlipFlop { second, .. } => self.pin(second.as_ref(), place, inside, depth),
            Kind::Timer(timer) => self.pin(timer.reset.as_ref(), place, inside, depth),
            Kind::Counter(counter) => {
                for line in [counter.down.as_ref(), counter.set.as_ref().map(|set| &set.0), counter.reset.as_ref()] {
                    self.pin(line, place, inside, depth);
                }
            }
            Kind::Call { pins, .. } => {
                for (index, pin) in pins.iter().enumerate() {
                    if pins.iter().take(index).any(|before| before.name.eq_ignore_ascii_case(&pin.name)) {
                        self.report(MistakeKind::Pin, place, format!("`{}` is wired twice", pin.name));
                    }
                    if let Actual::Logic(line) = &pin.actual {
                        self.pin(Some(line), place, inside, depth);
                    }
                }
            }
            Kind::Named(named) => {
                for input in &named.inputs {
                    self.pin(Some(&input.line), place, inside, depth);
                }
            }
            _ => {}
        }
        self.place = place;
    }

    fn pin(&mut self, line: Option<&Line>, place: Place, from: Begin, depth: usize) {
        let Some(line) = line else { return };
        if line.is_empty() {
            return self.report(MistakeKind::Pin, place, "a wire to this box begins nowhere; connect a contact, or leave the pin out");
        }
        self.line(line, from, depth + 1);
    }
}
