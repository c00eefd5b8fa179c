//! Random diagrams that both LAD and FBD can show.

use sieben_lang::network::boxes::{BOXES, CounterKind, TimerKind};
use sieben_lang::network::model::{
    Actual, Branch, Content, Counter, Element, End, Kind, Line, Network, Output, OutputKind, Pin, Place, Rung, Timer,
};

const NAMES: [&str; 8] =
    ["I 0.0", "M 10.7", "\"Start\"", "\"Pump_Running_Feedback_Of_Hopper\"", "#x", "DB10.DBX 12.3", "\"水泵启动按钮\"", "Q 124.7"];

struct Random(u64, u32);

impl Random {
    /// Below a number.
    fn below(&mut self, end: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % end
    }

    fn name(&mut self) -> &'static str {
        NAMES[self.below(NAMES.len() as u64) as usize]
    }

    fn place(&mut self) -> Place {
        self.1 += 1;
        Place { first: self.1, last: self.1 }
    }

    fn contact(&mut self) -> Element {
        let kind = Kind::contact(self.name(), self.below(2) == 0);
        kind.at(self.place())
    }

    fn line(&mut self, depth: u64, most: u64) -> Line {
        (0..=self.below(most)).map(|_| self.element(depth)).collect()
    }

    fn pin(&mut self, depth: u64) -> Option<Line> {
        (self.below(3) > 0).then(|| self.line(depth.saturating_sub(1), 2))
    }

    fn element(&mut self, depth: u64) -> Element {
        let choice = if depth == 0 { self.below(8) } else { self.below(20) };
        let kind = match choice {
            0..=3 => return self.contact(),
            4 => Kind::Compare { operation: ">I", left: self.name().into(), right: "MW 10".into(), negated: false },
            5 => Kind::EdgeBox { falling: false, operand: self.name().into(), memory: Some(self.name().into()) },
            6 => Kind::Not,
            7 => Kind::Midline { operand: self.name().into(), negated: false },
            8..=13 => {
                let branches = (0..2 + self.below(3)).map(|_| Branch { line: self.line(depth - 1, 4), bracketed: false });
                Kind::Parallel { branches: branches.collect(), negated: false }
            }
            14 => Kind::Edge { falling: true, memory: self.name().into() },
            15 => {
                let row = &BOXES[self.below(BOXES.len() as u64) as usize];
                Kind::Box { row, inputs: row.inputs.iter().map(|_| self.name().into()).collect(), output: self.name().into() }
            }
            16 => Kind::FlipFlop { reset_first: false, operand: self.name().into(), second: self.pin(depth) },
            17 => Kind::Timer(Box::new(Timer {
                kind: TimerKind::OnDelay,
                timer: "T 5".into(),
                value: "S5T#2S".into(),
                reset: self.pin(depth),
                binary: Some(self.name().into()),
                bcd: None,
            })),
            18 => Kind::Counter(Box::new(Counter {
                kind: CounterKind::UpDown,
                counter: "C 5".into(),
                down: self.pin(depth),
                set: self.pin(depth).map(|line| (line, "C#10".into())),
                reset: self.pin(depth),
                value: Some("MW 20".into()),
                bcd: None,
            })),
            _ => {
                let pins = (0..self.below(4)).map(|index| Pin {
                    name: format!("IN{index}").into(),
                    actual: if self.below(2) == 0 { Actual::Direct(self.name().into()) } else { Actual::Logic(self.line(depth - 1, 3)) },
                });
                Kind::Call { block: "FC 1".into(), instance: None, pins: pins.collect() }
            }
        };
        kind.at(self.place())
    }

    fn rung(&mut self, depth: u64) -> Rung {
        let most = if self.below(4) == 0 { 14 } else { 4 };
        let line = self.line(depth, most);
        let end = match self.below(if depth == 0 { 3 } else { 5 }) {
            0..=2 => End::Outputs((0..=self.below(3)).map(|_| self.output()).collect()),
            _ => End::Branches((0..2 + self.below(2)).map(|_| self.rung(depth - 1)).collect()),
        };
        Rung::new(line, end)
    }

    fn output(&mut self) -> Output {
        let kind = match self.below(5) {
            0 => OutputKind::Set(self.name().into()),
            1 => OutputKind::Timer { kind: TimerKind::Pulse, timer: "T 1".into(), value: "S5T#100MS".into() },
            2 => OutputKind::Jump("M001".into()),
            _ => OutputKind::Assign(self.name().into()),
        };
        kind.at(self.place())
    }
}

/// A diagram, the same for the same seed.
pub(crate) fn network(seed: u64) -> Network {
    let mut random = Random(seed, 0);
    let label = (random.below(4) == 0).then(|| "M001".into());
    let rung = random.rung(3);
    Network { label, content: Content::Rung(rung) }
}

/// How many contacts it has.
pub(crate) fn contacts(network: &Network) -> usize {
    let Content::Rung(rung) = &network.content else { return 0 };
    in_rung(rung, &in_line)
}

/// How many outputs it has.
pub(crate) fn outputs(network: &Network) -> usize {
    let Content::Rung(rung) = &network.content else { return 0 };
    in_rung(rung, &|_| 0) + outputs_of(rung)
}

fn outputs_of(rung: &Rung) -> usize {
    match &rung.end {
        End::Open => 0,
        End::Outputs(outputs) => outputs.len(),
        End::Branches(rungs) => rungs.iter().map(outputs_of).sum(),
    }
}

fn in_rung(rung: &Rung, count: &dyn Fn(&Line) -> usize) -> usize {
    let inner = match &rung.end {
        End::Branches(rungs) => rungs.iter().map(|rung| in_rung(rung, count)).sum(),
        _ => 0,
    };
    count(&rung.line) + inner
}

fn in_line(line: &Line) -> usize {
    line.iter().map(|element| in_kind(&element.kind)).sum()
}

fn in_kind(kind: &Kind) -> usize {
    let option = |line: &Option<Line>| line.as_ref().map_or(0, in_line);
    match kind {
        Kind::Contact { .. } => 1,
        Kind::Parallel { branches, .. } => branches.iter().map(|branch| in_line(&branch.line)).sum(),
        Kind::FlipFlop { second, .. } => option(second),
        Kind::Timer(timer) => option(&timer.reset),
        Kind::Counter(counter) => {
            option(&counter.down) + counter.set.as_ref().map_or(0, |(line, _)| in_line(line)) + option(&counter.reset)
        }
        Kind::Call { pins, .. } => pins.iter().map(|pin| if let Actual::Logic(line) = &pin.actual { in_line(line) } else { 0 }).sum(),
        _ => 0,
    }
}
