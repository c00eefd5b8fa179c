//! Methods that an instance chooses, through an INTERFACE, a base or THIS: programs that nobody wrote come to what they say, on all
//! engines, which ask a Host at the same places.

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
const SCANS: i32 = 6;
/// Instances in the array of interfaces.
const PARTS: usize = 20;

/// A function block with the method `Step`, its own, one over that of its base, or that of its base.
struct Class {
    base: Option<usize>,
    own: bool,
    calls_base: bool,
    factor: i32,
    added: i32,
}

/// What a program does, without any block.
struct Model {
    classes: Vec<Class>,
    values: Vec<i32>,
}

impl Model {
    fn step(&mut self, class: usize, instance: usize, by: i32) -> i32 {
        let Class { base, own, calls_base, factor, added } = self.classes[class];
        match base {
            Some(base) if !own => self.step(base, instance, by),
            Some(base) if calls_base => self.step(base, instance, by + added) * 3 + factor,
            _ => {
                self.values[instance] = (self.values[instance] * factor + by + added) % 10_007;
                self.values[instance] + added
            }
        }
    }

    /// `Twice` of the root calls what the instance chooses.
    fn twice(&mut self, class: usize, instance: usize) -> i32 {
        let root = (0..).try_fold(class, |class, _: u32| self.classes[class].base.ok_or(class)).unwrap_err();
        let factor = self.classes[root].factor;
        self.step(class, instance, factor) + self.values[instance]
    }
}

fn classes(dice: &mut Dice) -> Vec<Class> {
    let count = 1 + dice.of(&[1, 2, 3, 4, 8, 15]);
    let one = |index: u64, dice: &mut Dice| Class {
        base: (index > 0 && dice.roll(3) != 0).then(|| dice.roll(index) as usize),
        own: dice.roll(4) != 0,
        calls_base: dice.roll(2) == 0,
        factor: 1 + dice.roll(9) as i32,
        added: dice.roll(50) as i32,
    };
    (0..count).map(|index| one(index, dice)).collect()
}

fn text(classes: &[Class], of: &[Option<usize>; PARTS]) -> String {
    let mut text = String::from(
        "INTERFACE IPart\nMETHOD Step : DINT\nVAR_INPUT add_on : INT; END_VAR\nEND_METHOD\nMETHOD Twice : DINT\nEND_METHOD\nEND_INTERFACE\n",
    );
    for (index, Class { base, own, calls_base, factor, added }) in classes.iter().enumerate() {
        let above = base.map_or("IMPLEMENTS IPart".to_owned(), |base| format!("EXTENDS B{base}"));
        let variables = if base.is_none() { "VAR PROTECTED v : DINT; END_VAR\n" } else { "" };
        let _ = write!(text, "FUNCTION_BLOCK B{index} {above}\n{variables}");
        let word = if base.is_some() { "OVERRIDE " } else { "" };
        if *own || base.is_none() {
            let _ = write!(text, "METHOD PUBLIC {word}Step : DINT\nVAR_INPUT add_on : INT; END_VAR\n");
            text += &match base {
                Some(_) if *calls_base => format!("Step := SUPER.Step(add_on := add_on + {added}) * 3 + {factor};\n"),
                _ => format!("v := (v * {factor} + add_on + {added}) MOD 10007;\nStep := v + {added};\n"),
            };
            text += "END_METHOD\n";
        }
        if base.is_none() {
            let _ = write!(text, "METHOD PUBLIC Twice : DINT\nTwice := THIS.Step(add_on := {factor}) + v;\nEND_METHOD\n");
        }
        text += "END_FUNCTION_BLOCK\n";
    }
    text += "FUNCTION Work : DINT\nVAR_INPUT s : IPart; add_on : INT; END_VAR\nWork := s.Step(add_on := add_on) + s.Twice();\nEND_FUNCTION\n\
             PROGRAM Main\nVAR scans, check : DINT; i : INT; parts : ARRAY[0..19] OF IPart;\n";
    for (part, class) in of.iter().enumerate() {
        let _ = class.map(|class| writeln!(text, "b{part} : B{class};"));
    }
    text += "END_VAR\nscans := scans + 1;\nIF scans = 1 THEN\n";
    for (part, class) in of.iter().enumerate() {
        let _ = class.map(|_| writeln!(text, "parts[{part}] := b{part};"));
    }
    text + "END_IF;\nFOR i := 0 TO 19 DO\n check := (check * 31 + parts[i].Step(add_on := i)) MOD 1000003;\n\
            check := (check * 7 + Work(s := parts[i], add_on := DINT_TO_INT(scans))) MOD 1000003;\nEND_FOR;\nEND_PROGRAM\n"
}

/// `check` behind each scan.
fn expected(model: &mut Model, of: &[Option<usize>; PARTS]) -> Vec<i32> {
    let mut check = 0;
    let scan = |scans: i32| {
        for (part, class) in of.iter().enumerate() {
            // What calls a method of nothing is left out: the statement here, and the one in `Work`, which gives 0.
            if let Some(class) = *class {
                check = (check * 31 + model.step(class, part, part as i32)) % 1_000_003;
            }
            let work = class.map_or(0, |class| model.step(class, part, scans) + model.twice(class, part));
            check = (check * 7 + work) % 1_000_003;
        }
        check
    };
    (1..=SCANS).map(scan).collect()
}

#[test]
fn instances_choose_their_methods() {
    let needed: program::Load =
        |program: &Program, layout: &Layout| Jit::compiled(program, layout, StatusBits::Needed).expect("machine code");
    let mut faults = 0;
    for seed in seeds(PROGRAMS) {
        let mut dice = Dice(seed);
        let classes = classes(&mut dice);
        let nothing = dice.roll(2) == 0;
        let of = [(); PARTS].map(|()| (!nothing || dice.roll(8) != 0).then(|| dice.roll(classes.len() as u64) as usize));
        let text = text(&classes, &of);
        let program = side_by_side::compiled("chosen.st", &text).expect("it compiles");
        let mut model = Model { classes, values: vec![0; PARTS] };
        let checks = expected(&mut model, &of);
        let first = asked::run(&program, Interpreter::load, (SCANS, seed));
        assert_eq!(first.0, checks, "{text}");
        faults += first.1.iter().filter(|asked| asked.contains(" at ")).count();
        for (name, load) in program::ENGINES.iter().copied().chain([("status bits as needed", needed)]) {
            let other = asked::run(&program, load, (SCANS, seed));
            assert!(first == other, "{name}: {text}\n{:?}\n{:?}", first.1, other.1);
        }
    }
    assert!(faults > 100, "{faults}: some instances are nothing");
}
