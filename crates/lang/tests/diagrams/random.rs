//! Random diagrams come back from their statements and from their text; random statements keep their meaning.

use std::collections::HashMap;

use proptest::prelude::*;
use sieben_lang::network::boxes::{BOXES, COMPARISONS, CounterKind, TimerKind};
use sieben_lang::network::flavour::{Drawing, Flavour};
use sieben_lang::network::form_b::{parse, print};
use sieben_lang::network::model::{
    Actual, Branch, Content, Counter, Element, End, Kind, Line, Network, OutputKind, Pin, Place, Rung, Timer, XorInput,
};
use sieben_lang::network::operand::Operand;
use sieben_lang::network::pin_types::PinType;
use sieben_lang::network::read::{Answer, Mode, draw};
use sieben_lang::network::rules;
use sieben_lang::network::statement::Statement;
use sieben_lang::network::to_lad::to_lad;
use sieben_lang::network::write::{keep_needed_brackets, write};

use crate::statements::{PLAIN, all_shown};

/// Random numbers from one seed.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 >> 33).expect("31 bits fit") % limit
    }

    fn one_in(&mut self, limit: usize) -> bool {
        self.below(limit) == 0
    }

    fn pick<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }

    fn bit(&mut self) -> Operand {
        match self.below(6) {
            0 => Operand::from(format!("\"Valve {}\"", self.below(4))),
            1 => Operand::from(format!("#ready{}", self.below(4))),
            2 => Operand::from(format!("DB 10.DBX {}.{}", self.below(4), self.below(8))),
            _ => Operand::from(format!("{} {}.{}", self.pick(&["I", "M", "Q"]), self.below(3), self.below(8))),
        }
    }

    fn memory(&mut self) -> Operand {
        Operand::from(format!("M {}.{}", 100 + self.below(50), self.below(8)))
    }

    fn of_width(&mut self, width: u8) -> Operand {
        let size = match width {
            8 => "B",
            16 => "W",
            _ => "D",
        };
        Operand::from(format!("M{size} {}", 20 + 2 * self.below(20)))
    }
}

/// Where a line stands.
#[derive(Clone, Copy, PartialEq, Eq)]
enum At {
    Rail,
    Tap,
    Inside,
}

/// Makes diagrams in the form that reading gives back.
struct Maker {
    random: Random,
    drawing: Drawing,
}

const NOWHERE: Place = Place { first: 0, last: 0 };

impl Maker {
    fn network(&mut self) -> Network {
        let label = self.random.one_in(6).then(|| Operand::from("m001"));
        Network { label, content: Content::Rung(self.rung(At::Rail, 0)) }
    }

    fn rung(&mut self, at: At, depth: usize) -> Rung {
        let mut line = if at == At::Tap && self.random.one_in(3) { Line::new() } else { self.line(at, depth) };
        if self.random.one_in(4) && at != At::Inside {
            let unconditional = line.is_empty() && at == At::Rail;
            if !unconditional {
                line.push(self.boxed(depth));
            }
        }
        if at == At::Rail && self.random.one_in(8) {
            // A box straight on the rail.
            line.clear();
            line.push(self.enabled(depth));
        }
        let ends_with_box = line.last().is_some_and(|one| one.kind.is_box());
        let end = match self.random.below(4) {
            0 if depth < 2 => {
                let count = 2 + self.random.below(2);
                End::Branches((0..count).map(|_| self.rung(At::Tap, depth + 1)).collect())
            }
            1 if ends_with_box => End::Open,
            _ => self.outputs(),
        };
        Rung::new(line, end)
    }

    fn outputs(&mut self) -> End {
        let random = &mut self.random;
        let single = match random.below(10) {
            0 => Some(OutputKind::Jump("m002".into())),
            1 => Some(OutputKind::Return),
            2 => Some(OutputKind::Timer { kind: random.pick(&TimerKind::ALL).0, timer: "T 5".into(), value: "S5T#2S".into() }),
            3 => Some(OutputKind::SetCounter { counter: "C 5".into(), value: "C#10".into() }),
            4 => Some(OutputKind::CountUp("C 6".into())),
            5 => Some(OutputKind::McrStart),
            6 => Some(OutputKind::Call("FC 1".into())),
            _ => None,
        };
        if let Some(kind) = single {
            return End::Outputs(vec![kind.at(NOWHERE)]);
        }
        let count = 1 + random.below(3);
        let output = |random: &mut Random| match random.below(4) {
            0 => OutputKind::Set(random.bit()),
            1 => OutputKind::Reset(random.bit()),
            2 => OutputKind::Save,
            _ => OutputKind::Assign(random.bit()),
        };
        End::Outputs((0..count).map(|_| output(random).at(NOWHERE)).collect())
    }

    /// At least one element.
    fn line(&mut self, at: At, depth: usize) -> Line {
        let mut line = Line::new();
        let count = 1 + self.random.below(3);
        for index in 0..count {
            let first = index == 0 && at != At::Tap;
            if !first && self.random.one_in(5) {
                line.push(self.acting());
            } else {
                line.push(self.operand(first, depth));
            }
        }
        line
    }

    fn acting(&mut self) -> Element {
        let kind = match self.random.below(4) {
            0 => Kind::Not,
            1 => Kind::Midline { operand: self.random.memory(), negated: self.drawing == Drawing::Fbd && self.random.one_in(3) },
            _ => Kind::Edge { falling: self.random.one_in(2), memory: self.random.memory() },
        };
        kind.at(NOWHERE)
    }

    fn operand(&mut self, first: bool, depth: usize) -> Element {
        let fbd = self.drawing == Drawing::Fbd;
        let circle = fbd && self.random.one_in(4);
        let kind = match self.random.below(14) {
            0 => Kind::Contact { operand: self.random.pick(&["OV", "==0", "BR", "<>0", "UO"]).into(), negated: self.random.one_in(2) },
            1 | 2 => {
                let operation = self.random.pick(&COMPARISONS);
                let left = self.random.of_width(PinType::of_comparison(operation).bits().unwrap_or(16));
                Kind::Compare { operation, left, right: "5".into(), negated: circle }
            }
            3 => Kind::EdgeBox { falling: self.random.one_in(2), operand: self.random.bit(), memory: Some(self.random.memory()) },
            4 | 5 if depth < 3 => {
                let count = 2 + self.random.below(2);
                let branch = |maker: &mut Self| Branch { line: maker.line(At::Inside, depth + 1), bracketed: maker.random.one_in(4) };
                let mut branches: Vec<Branch> = (0..count).map(|_| branch(self)).collect();
                keep_needed_brackets(&mut branches);
                Kind::Parallel { branches, negated: circle }
            }
            6 if fbd && depth < 3 => {
                let count = 2 + self.random.below(2);
                let inputs = (0..count).map(|_| XorInput { line: self.line(At::Inside, depth + 1), negated: false }).collect();
                Kind::Xor { inputs, negated: circle }
            }
            7 if fbd && depth < 3 && !first => {
                let mut line = self.line(At::Inside, depth + 1);
                line.push(self.acting());
                Kind::Group { line, negated: self.random.one_in(2) }
            }
            _ => Kind::Contact { operand: self.random.bit(), negated: self.random.one_in(3) },
        };
        kind.at(NOWHERE)
    }

    fn pin(&mut self, depth: usize) -> Option<Line> {
        self.random.one_in(2).then(|| self.line(At::Inside, depth + 1))
    }

    /// A box with EN, or one with a pin for the line.
    fn boxed(&mut self, depth: usize) -> Element {
        let kind = match self.random.below(5) {
            0 => Kind::FlipFlop { reset_first: self.random.one_in(2), operand: self.random.memory(), second: self.pin(depth) },
            1 => Kind::Timer(Box::new(Timer {
                kind: self.random.pick(&TimerKind::ALL).0,
                timer: "T 7".into(),
                value: "S5T#1S".into(),
                reset: self.pin(depth),
                binary: self.random.one_in(2).then(|| self.random.of_width(16)),
                bcd: self.random.one_in(2).then(|| self.random.of_width(16)),
            })),
            2 => {
                let kind = self.random.pick(&CounterKind::ALL).0;
                let down = if kind == CounterKind::UpDown { self.pin(depth) } else { None };
                let set = self.pin(depth).map(|line| (line, "C#3".into()));
                let (reset, value) = (self.pin(depth), self.random.one_in(2).then(|| self.random.of_width(16)));
                Kind::Counter(Box::new(Counter { kind, counter: "C 7".into(), down, set, reset, value, bcd: None }))
            }
            _ => return self.enabled(depth),
        };
        kind.at(NOWHERE)
    }

    fn enabled(&mut self, depth: usize) -> Element {
        if self.random.one_in(4) {
            let mut pins = Vec::new();
            for name in ["START", "STOP", "SPEED", "DONE"] {
                let actual = match name {
                    "SPEED" => Actual::Direct("MW 90".into()),
                    "DONE" => Actual::Direct("M 90.0".into()),
                    _ => Actual::Logic(self.line(At::Inside, depth + 1)),
                };
                if self.random.one_in(2) {
                    pins.push(Pin { name: name.into(), actual });
                }
            }
            return Kind::Call { block: "FB 3".into(), instance: Some("DB 6".into()), pins }.at(NOWHERE);
        }
        let row = &BOXES[self.random.below(BOXES.len())];
        let width = |index: usize| row.types.get(index).and_then(|pin| pin.bits()).unwrap_or(16);
        let inputs = (0..row.inputs.len()).map(|index| self.random.of_width(width(index))).collect();
        let output = self.random.of_width(width(row.inputs.len()));
        Kind::Box { row, inputs, output }.at(NOWHERE)
    }
}

fn made(seed: u64, drawing: Drawing) -> Option<Network> {
    let network = Maker { random: Random(seed | 1), drawing }.network();
    rules::mistakes(&network, Flavour::S7, None).is_empty().then_some(network)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1_000))]

    #[test]
    fn a_diagram_comes_back_from_its_line(seed: u64) {
        for drawing in [Drawing::Lad, Drawing::Fbd] {
            let Some(network) = made(seed, drawing) else { continue };
            for shown in [Drawing::Lad, Drawing::Fbd] {
                let line = print(&network, shown);
                let again = parse(&line, 0, Flavour::S7).unwrap_or_else(|wrong| panic!("{line}: {wrong:?}"));
                prop_assert_eq!(&again, &network, "{}", line);
            }
        }
    }

    #[test]
    fn a_diagram_comes_back_from_its_statements(seed: u64) {
        for drawing in [Drawing::Lad, Drawing::Fbd] {
            let Some(network) = made(seed, drawing) else { continue };
            let statements = write(&network, 48, &mut 0).statements;
            // Without its last statements, or one in the middle, it is another network, or none.
            let mut random = Random(seed | 1);
            for _ in 0..2 {
                let mut cut = statements.clone();
                match random.one_in(2) {
                    true => cut.truncate(random.below(statements.len())),
                    false => drop(cut.remove(random.below(statements.len()))),
                }
                for mode in [Mode::Strict, Mode::Rewriting, Mode::RewritingConstants] {
                    if let Answer::Equivalent(reading, _) = draw(&cut, &PLAIN, 48, mode) {
                        prop_assert!(!reading.rewrites.is_empty(), "{}", all_shown(&cut));
                    }
                }
            }
            match draw(&statements, &PLAIN, 48, Mode::Strict) {
                Answer::Exact(again) => prop_assert_eq!(&again, &network, "{}\n{}", print(&network, drawing), all_shown(&statements)),
                other => prop_assert!(false, "{}\n{}\n{:?}", print(&network, drawing), all_shown(&statements), other),
            }
            if drawing == Drawing::Lad {
                let (lad, rewrites) = to_lad(&network).unwrap_or_else(|refusal| panic!("{}: {refusal:?}", print(&network, drawing)));
                prop_assert_eq!(&lad, &network);
                prop_assert!(rewrites.is_empty());
            }
        }
    }

    #[test]
    fn rewritten_statements_do_the_same(seed: u64) {
        let mut random = Random(seed | 1);
        let statements = random_statements(&mut random);
        for mode in [Mode::Strict, Mode::Rewriting, Mode::RewritingConstants] {
            let networks = match draw(&statements, &PLAIN, 800, mode) {
                Answer::Exact(network) => vec![network],
                Answer::Equivalent(reading, _) => {
                    prop_assert!(!reading.rewrites.is_empty(), "{}", all_shown(&statements));
                    reading.networks
                }
                Answer::No(_) => continue,
            };
            let written: Vec<Statement> = networks.iter().flat_map(|network| write(network, 800, &mut 0).statements).collect();
            let lad: Option<Vec<Network>> = networks.iter().map(|network| to_lad(network).ok().map(|drawn| drawn.0)).collect();
            let lad = lad.map(|networks| networks.iter().flat_map(|network| write(network, 800, &mut 0).statements).collect::<Vec<_>>());
            for _ in 0..8 {
                let memory: HashMap<String, bool> = BITS.iter().map(|bit| ((*bit).to_owned(), random.one_in(2))).collect();
                let before = run(&statements, memory.clone());
                prop_assert_eq!(&before, &run(&written, memory.clone()), "{}\n{}", all_shown(&statements), all_shown(&written));
                if let Some(lad) = &lad {
                    prop_assert_eq!(&before, &run(lad, memory), "{}\n{}", all_shown(&statements), all_shown(lad));
                }
            }
        }
    }
}

const BITS: [&str; 8] = ["I0.0", "I0.1", "I0.2", "M0.0", "M0.1", "#t1", "Q4.0", "L20.0"];

/// Logic as people write it by hand, and a little as nobody would.
fn random_statements(random: &mut Random) -> Vec<Statement> {
    let mut out = Vec::new();
    for _ in 0..1 + random.below(3) {
        random_string(random, 0, &mut out);
        if random.one_in(6) {
            let bit = random.pick(&["#t1", "L20.0", "M0.1"]);
            out.push(Statement::new("=", bit));
            out.push(Statement::new(random.pick(&["A", "A", "AN", "O"]), bit));
            if random.one_in(2) {
                random_string(random, 1, &mut out);
            }
            out.push(Statement::new("=", "Q4.0"));
            if random.one_in(2) {
                out.push(Statement::new("A", bit));
                random_string(random, 2, &mut out);
            }
        }
        for _ in 0..1 + random.below(2) {
            out.push(Statement::new(random.pick(&["=", "=", "S", "R"]), random.pick(&["M0.0", "M0.1", "Q4.0"])));
        }
        if random.one_in(8) {
            out.push(Statement::new("NOP", "0"));
        }
        if random.one_in(10) {
            out.push(Statement::new(random.pick(&["SET", "CLR"]), ""));
            out.push(Statement::new("=", "M0.1"));
        }
    }
    out
}

fn random_string(random: &mut Random, depth: usize, out: &mut Vec<Statement>) {
    for index in 0..1 + random.below(4) {
        match random.below(12) {
            0 | 1 if depth < 3 => {
                out.push(Statement::new(random.pick(&["A(", "AN(", "O(", "ON(", "X(", "XN("]), ""));
                random_string(random, depth + 1, out);
                out.push(Statement::new(")", ""));
            }
            2 if index > 0 => {
                out.push(Statement::new("O", ""));
                out.push(Statement::new("A", random.pick(&BITS[..6])));
            }
            3 if index > 0 => out.push(Statement::new("NOT", "")),
            4 if index > 0 => out.push(Statement::new(random.pick(&["FP", "FN"]), random.pick(&["M0.1", "#t1"]))),
            _ => out.push(Statement::new(random.pick(&["A", "A", "A", "AN", "O", "O", "ON", "X", "XN"]), random.pick(&BITS[..6]))),
        }
    }
}

/// What the statements leave in the bits that count, by the rules of the status word: a first check, AND before OR, brackets.
fn run(statements: &[Statement], mut memory: HashMap<String, bool>) -> Vec<(String, bool)> {
    #[derive(Clone, Copy, Default)]
    struct Status {
        rlo: bool,
        or: bool,
        continues: bool,
    }
    let mut status = Status::default();
    let mut stack: Vec<(Status, &str)> = Vec::new();
    fn combine(status: &mut Status, operation: &str, value: bool) {
        let value = value ^ operation.contains('N');
        let kind = operation.as_bytes()[0];
        match (status.continues, kind) {
            (false, _) => {
                status.rlo = value;
                if kind == b'A' {
                    status.rlo |= status.or;
                } else {
                    status.or = false;
                }
            }
            (true, b'A') => status.rlo = (status.rlo && value) || status.or,
            (true, b'O') => {
                status.rlo |= value;
                status.or = false;
            }
            (true, _) => {
                status.rlo ^= value;
                status.or = false;
            }
        }
        status.continues = true;
    }
    for statement in statements {
        let operand = statement.operand.replace(' ', "");
        match statement.mnemonic {
            "O" if operand.is_empty() => {
                // The AND before this OR is complete; the next check begins the second one.
                if status.continues {
                    status.or = status.rlo;
                    status.continues = false;
                }
            }
            "A(" | "AN(" | "O(" | "ON(" | "X(" | "XN(" => stack.push((std::mem::take(&mut status), statement.mnemonic)),
            ")" => {
                let (mut outer, operation) = stack.pop().expect("brackets match");
                combine(&mut outer, operation, status.rlo);
                status = outer;
            }
            "NOT" => status.rlo = !status.rlo,
            "FP" | "FN" => {
                let before = memory.insert(operand, status.rlo).unwrap_or_default();
                status.rlo = if statement.mnemonic == "FP" { status.rlo && !before } else { !status.rlo && before };
                (status.or, status.continues) = (false, true);
            }
            "=" | "S" | "R" => {
                if statement.mnemonic == "=" || status.rlo {
                    memory.insert(operand, statement.mnemonic == "S" || (statement.mnemonic == "=" && status.rlo));
                }
                (status.or, status.continues) = (false, false);
            }
            "SET" | "CLR" => status = Status { rlo: statement.mnemonic == "SET", or: false, continues: false },
            "NOP" | "BLD" => {}
            "A" | "AN" | "O" | "ON" | "X" | "XN" => {
                let value = memory.get(&operand).copied().unwrap_or_default();
                combine(&mut status, statement.mnemonic, value);
            }
            other => panic!("{other} is not made"),
        }
    }
    let mut left: Vec<(String, bool)> = memory.into_iter().filter(|(bit, _)| !bit.starts_with('L') && !bit.starts_with("#t")).collect();
    left.sort();
    left
}

#[test]
fn random_statements_are_drawn_in_every_way() {
    let mut random = Random(0x5EED);
    let mut seen: HashMap<String, usize> = HashMap::new();
    for _ in 0..3_000 {
        let statements = random_statements(&mut random);
        match draw(&statements, &PLAIN, 800, Mode::RewritingConstants) {
            Answer::Exact(_) => *seen.entry("exact".to_owned()).or_default() += 1,
            Answer::Equivalent(reading, _) => {
                for rewrite in reading.rewrites {
                    *seen.entry(rewrite.to_string()).or_default() += 1;
                }
            }
            Answer::No(refusal) => *seen.entry(refusal.reason.to_string()).or_default() += 1,
        }
    }
    for answer in ["exact", "W2", "W4", "W5", "W6", "W7", "W10", "W11", "W12", "R-NEG", "R-OPCODE"] {
        assert!(seen.get(answer).is_some_and(|count| *count > 5), "{answer}: {seen:?}");
    }
}

#[test]
fn long_networks_are_read_and_written_in_linear_time() {
    // Each of these was or would be quadratic if something were read twice for each element.
    type Form = fn(usize) -> String;
    let forms: [Form; 6] = [
        |count| "A I0.0; ".repeat(count) + "= Q4.0",
        |count| "A I0.0; = Q4.0".to_owned() + &"; S M0.0".repeat(count),
        |count| "A I0.0; = L20.0".to_owned() + &"; A L20.0; S M0.0; A L20.0; A I0.1; R M0.1".repeat(count),
        |count| "O I0.0".to_owned() + &"; O; A I0.1; A(; O I0.2; O I0.3; )".repeat(count) + "; = Q4.0",
        |count| "A I0.0; = Q4.0; ".repeat(count) + "A I0.0; = Q4.1",
        |count| "A I0.1; = L20.0; BLD 103; ".repeat(count) + "CALL FC1 (P := L20.0)",
    ];
    for form in forms {
        let text = form(20_000);
        let statements = crate::statements::statements(&text);
        if let Answer::Exact(network) = draw(&statements, &PLAIN, 160, Mode::Rewriting) {
            let line = print(&network, Drawing::Lad);
            // More elements than a network may have are read all the same, to be refused for that.
            assert!(parse(&line, 0, Flavour::S7).is_ok_and(|again| again == network) || line.len() > 50_000);
        }
    }
    let taps: String = (0..5_000).map(|bit| format!("= L{}.{}; A L{}.{}; ", bit / 8, bit % 8, bit / 8, bit % 8)).collect();
    let nested = crate::statements::statements(&format!("A I0.0; {taps}= Q4.0"));
    assert!(matches!(draw(&nested, &PLAIN, 0, Mode::Rewriting), Answer::No(_)), "T-branches do not nest without end");
    let brackets = crate::statements::statements(&("A(; ".repeat(10_000) + "A I0.0; = Q4.0"));
    assert!(matches!(draw(&brackets, &PLAIN, 0, Mode::Rewriting), Answer::No(refusal) if refusal.statement == 7));
}
