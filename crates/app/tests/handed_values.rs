//! Functions and function blocks that get constants and variables, often the same ones again, on some ways only, from blocks that become
//! part of their callers and from others: what statements hand to them is there, on all engines, wherever a Host is asked.

use std::fmt::Write as _;

use dice::{Dice, seeds};
use sieben_engine::{Interpreter, Layout, Program};
use sieben_jit::{Jit, StatusBits};

mod asked;
#[path = "../../jit/tests/dice/mod.rs"]
mod dice;
#[allow(dead_code)] // The tests of whole programs need more of it.
mod program;
#[allow(dead_code)] // The measurements need more of it.
#[path = "../benches/side_by_side/mod.rs"]
mod side_by_side;

/// Programs that are compared.
const PROGRAMS: u64 = 40;
/// Scans of each.
const SCANS: i32 = 4;
const VARIABLES: u64 = 4;
/// More loops than a block may have that becomes part of its caller.
const LOOPS: i32 = 17;

/// What a block is handed.
#[derive(Clone, Copy)]
enum Given {
    Constant(i32),
    Variable(usize),
}

#[derive(Clone, Copy)]
enum Callee {
    Short,
    Branching,
    /// It does not become part of its caller.
    Long,
    Instance,
}

enum Statement {
    Call { to: usize, callee: Callee, given: [Given; 2], added: Option<(Callee, [Given; 2])> },
    If { variable: usize, than: i32, then: Vec<Statement>, otherwise: Vec<Statement> },
}

const BLOCKS: &str = "FUNCTION Short : DINT\nVAR_INPUT a, b : DINT; END_VAR\nShort := (a * 3 - b) MOD 1009;\nEND_FUNCTION\n\
    FUNCTION Branching : DINT\nVAR_INPUT a, b : DINT; END_VAR\nIF a > b THEN Branching := Short(a, 7);\nELSE Branching := Short(a := 7, b := b) + 5; END_IF;\nEND_FUNCTION\n";

fn callee(dice: &mut Dice) -> Callee {
    dice.of(&[Callee::Short, Callee::Branching, Callee::Long, Callee::Instance])
}

fn given(dice: &mut Dice) -> [Given; 2] {
    [(); 2].map(|()| match dice.roll(2) {
        0 => Given::Constant(dice.of(&[1, 2, 500])),
        _ => Given::Variable(dice.roll(VARIABLES) as usize),
    })
}

fn statements(dice: &mut Dice, depth: u32) -> Vec<Statement> {
    let count = 1 + dice.roll(if depth == 0 { 12 } else { 3 });
    let one = |_| {
        if depth < 2 && dice.roll(4) == 0 {
            let (variable, than) = (dice.roll(VARIABLES) as usize, dice.of(&[0, 10, 300]));
            return Statement::If { variable, than, then: statements(dice, depth + 1), otherwise: statements(dice, depth + 1) };
        }
        let added = (dice.roll(3) == 0).then(|| (callee(dice), given(dice)));
        Statement::Call { to: dice.roll(VARIABLES) as usize, callee: callee(dice), given: given(dice), added }
    };
    (0..count).map(one).collect()
}

fn shown(given: Given) -> String {
    match given {
        Given::Constant(value) => value.to_string(),
        Given::Variable(variable) => format!("v{variable}"),
    }
}

fn call(callee: Callee, given: [Given; 2]) -> String {
    let [a, b] = given.map(shown);
    match callee {
        Callee::Short => format!("Short({a}, {b})"),
        Callee::Branching => format!("Branching(a := {a}, b := {b})"),
        Callee::Long => format!("Long({a}, {b})"),
        Callee::Instance => "f.y".to_owned(),
    }
}

fn write(statements: &[Statement], text: &mut String) {
    for statement in statements {
        match statement {
            Statement::If { variable, than, then, otherwise } => {
                let _ = writeln!(text, "IF v{variable} > {than} THEN");
                write(then, text);
                let _ = writeln!(text, "ELSE");
                write(otherwise, text);
                let _ = writeln!(text, "END_IF;");
            }
            &Statement::Call { to, callee, given, added } => {
                let all = [Some((callee, given)), added];
                for (_, given) in all.iter().flatten().filter(|(callee, _)| matches!(callee, Callee::Instance)) {
                    let [a, b] = given.map(shown);
                    let _ = writeln!(text, "f(a := {a}, b := {b});");
                }
                let parts: Vec<String> = all.into_iter().flatten().map(|(callee, given)| call(callee, given)).collect();
                let _ = writeln!(text, "v{to} := {};", parts.join(" + "));
            }
        }
    }
}

/// The variables and the instance.
#[derive(Default)]
struct Model {
    v: [i32; VARIABLES as usize],
    y: i32,
}

impl Model {
    fn given(&self, given: [Given; 2]) -> [i32; 2] {
        given.map(|given| match given {
            Given::Constant(value) => value,
            Given::Variable(variable) => self.v[variable],
        })
    }

    fn result(&self, callee: Callee, given: [Given; 2]) -> i32 {
        let [a, b] = self.given(given);
        match callee {
            Callee::Short => short(a, b),
            Callee::Branching => branching(a, b),
            Callee::Long => LOOPS * 2 * (a - b) % 997,
            Callee::Instance => self.y,
        }
    }

    fn run(&mut self, statements: &[Statement]) {
        for statement in statements {
            match statement {
                Statement::If { variable, than, then, otherwise } => {
                    self.run(if self.v[*variable] > *than { then } else { otherwise });
                }
                &Statement::Call { to, callee, given, added } => {
                    for (_, given) in
                        [Some((callee, given)), added].into_iter().flatten().filter(|(callee, _)| matches!(callee, Callee::Instance))
                    {
                        let [a, b] = self.given(given);
                        self.y = (self.y + short(a, b) + branching(b, 2)) % 4001;
                    }
                    let added = added.map_or(0, |(callee, given)| self.result(callee, given));
                    self.v[to] = self.result(callee, given) + added;
                }
            }
        }
    }
}

fn short(a: i32, b: i32) -> i32 {
    (a * 3 - b) % 1009
}

fn branching(a: i32, b: i32) -> i32 {
    if a > b { short(a, 7) } else { short(7, b) + 5 }
}

fn text(statements: &[Statement]) -> String {
    let mut text = BLOCKS.to_owned();
    text += "FUNCTION Long : DINT\nVAR_INPUT a, b : DINT; END_VAR\nVAR i, s : DINT; END_VAR\n";
    (0..LOOPS).for_each(|_| text += "FOR i := 1 TO 2 DO s := s + a - b; END_FOR;\n");
    text += "Long := s MOD 997;\nEND_FUNCTION\nFUNCTION_BLOCK Adder\nVAR_INPUT a, b : DINT; END_VAR\nVAR_OUTPUT y : DINT; END_VAR\n\
             y := (y + Short(a, b) + Branching(b, 2)) MOD 4001;\nEND_FUNCTION_BLOCK\n\
             PROGRAM Main\nVAR scans, check : DINT; v0, v1, v2, v3 : DINT; f : Adder; END_VAR\nscans := scans + 1;\nv1 := v1 + scans;\n";
    write(statements, &mut text);
    text + "check := (check * 31 + v0 + v1 * 3 + v2 * 5 + v3 * 7) MOD 1000003;\nEND_PROGRAM\n"
}

#[test]
fn what_is_handed_to_blocks_is_there() {
    let needed: program::Load =
        |program: &Program, layout: &Layout| Jit::compiled(program, layout, StatusBits::Needed).expect("machine code");
    for seed in seeds(PROGRAMS) {
        let mut dice = Dice(seed);
        let statements = statements(&mut dice, 0);
        let text = text(&statements);
        let program = side_by_side::compiled("handed.st", &text).expect("it compiles");
        let (mut model, mut check) = (Model::default(), 0);
        let scan = |scans: i32| {
            model.v[1] += scans;
            model.run(&statements);
            let [a, b, c, d] = model.v;
            check = (check * 31 + a + b * 3 + c * 5 + d * 7) % 1_000_003;
            check
        };
        let checks: Vec<i32> = (1..=SCANS).map(scan).collect();
        let first = asked::run(&program, Interpreter::load, (SCANS, seed));
        assert_eq!(first.0, checks, "{text}");
        for (name, load) in program::ENGINES.iter().copied().chain([("status bits as needed", needed)]) {
            let other = asked::run(&program, load, (SCANS, seed));
            assert!(first == other, "{name}: {text}\n{:?}\n{:?}", first.0, other.0);
        }
    }
}
