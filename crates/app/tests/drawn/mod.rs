//! Programs whose networks are drawn, as LAD and FBD, and written as statements again: each step must do what the program did.

use std::sync::Arc;

use sieben_lang::Compiled;
use sieben_lang::body::CheckedBody;
use sieben_lang::network::flavour::Drawing;
use sieben_lang::network::read::Mode;
use sieben_lang::stl::heads::with_words;
use sieben_lang::stl::operands::Operand;
use sieben_lang::stl::redraw::{AnswerKind, Form, Redrawing, Redrawn, Source, Target};
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::FileId;

use crate::program;

/// A program in another form: which, its text, and what came of compiling it.
pub(crate) struct Written {
    pub(crate) name: &'static str,
    pub(crate) text: String,
    pub(crate) compiled: Arc<sieben_engine::Program>,
    pub(crate) settings: sieben_cpu::Settings,
}

/// How many networks were answered how.
#[derive(Debug, Default)]
pub(crate) struct Count {
    pub(crate) exact: usize,
    pub(crate) equivalent: usize,
    pub(crate) no: usize,
}

const STEPS: &[(&str, Target)] = &[
    ("as LAD", Target::Diagram(Drawing::Lad, Form::A)),
    ("as FBD", Target::Diagram(Drawing::Fbd, Form::A)),
    ("as LAD on one line", Target::Diagram(Drawing::Lad, Form::B)),
    ("as FBD on one line", Target::Diagram(Drawing::Fbd, Form::B)),
    ("as STL again", Target::Statements),
];

/// The forms of a program, each made of the one before it.
pub(crate) fn forms(stl: &str, cpu_type: &'static CpuType, count: &mut Count) -> Result<Vec<Written>, String> {
    let mut text = stl.to_owned();
    let mut compiled = program::compile(stl, Mnemonics::English, cpu_type)?;
    let mut forms = Vec::new();
    for (name, target) in STEPS {
        let redrawn = redraw(&text, &compiled, *target);
        if forms.is_empty() {
            for network in &redrawn.networks {
                match network.answer {
                    AnswerKind::Exact => count.exact += 1,
                    AnswerKind::Equivalent => count.equivalent += 1,
                    AnswerKind::No => count.no += 1,
                }
            }
        }
        if redrawn.text == text {
            continue;
        }
        compiled = program::compile(&redrawn.text, Mnemonics::English, cpu_type)
            .map_err(|message| format!("{name}: {message}\n{}", redrawn.text))?;
        text = redrawn.text;
        under_other_endings(&text, &compiled, cpu_type).map_err(|message| format!("{name}: {message}"))?;
        let settings = program::settings(&compiled);
        forms.push(Written { name, text: text.clone(), compiled: Arc::new(compiled.program.clone()), settings });
    }
    Ok(forms)
}

/// In a file whose ending says that networks are diagrams, a text with the word at each network is the same program; and the other way round.
fn under_other_endings(text: &str, compiled: &Compiled, cpu_type: &'static CpuType) -> Result<(), String> {
    let words = with_words(text, None);
    let moved = program::compile_sources(&[("page.lad", &words)], Some(Mnemonics::English), None, cpu_type)
        .map_err(|message| format!("in a file of LAD: {message}\n{words}"))?;
    if statements(&moved) != statements(compiled) {
        return Err(format!("in a file of LAD it is another program:\n{words}"));
    }
    let usual = words.replace("NETWORK LAD\n", "NETWORK\n");
    if with_words(&usual, Some(Drawing::Lad)) != words {
        return Err(format!("from a file of LAD it is another text:\n{usual}"));
    }
    Ok(())
}

/// What each block does, without where it is written.
fn statements(compiled: &Compiled) -> Vec<String> {
    let operand = |operand: &Operand| match operand {
        Operand::Call(call) => {
            let parameters: Vec<_> = call.parameters.iter().map(|one| (&one.name, &one.actual)).collect();
            format!("{} {:?} {parameters:?}", call.callee, call.instance)
        }
        other => format!("{other:?}"),
    };
    let stl = compiled.bodies.values().filter_map(|body| match &**body {
        CheckedBody::Stl(block) => Some(block),
        CheckedBody::St(_) => None,
    });
    let all = stl.flat_map(|block| block.statements.iter().map(|one| (block.id, one)));
    all.map(|(id, one)| format!("{id} {} {}", one.instruction.english(), operand(&one.operand))).collect()
}

fn redraw(text: &str, compiled: &Compiled, target: Target) -> Redrawn {
    let blocks = compiled.bodies.values().filter_map(|body| match &**body {
        CheckedBody::Stl(block) => Some(block),
        CheckedBody::St(_) => None,
    });
    let source = Source { file: FileId(0), text, mnemonics: Mnemonics::English, drawing: None, blocks: blocks.collect() };
    source.redraw(&Redrawing { target, block: None, mode: Mode::RewritingConstants })
}

/// Random networks of statements, some of which no diagram can show.
pub(crate) struct RandomNetworks {
    state: u64,
    labels: u64,
}

impl RandomNetworks {
    pub(crate) fn new(seed: u64) -> Self {
        Self { state: seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1, labels: 0 }
    }

    fn below(&mut self, end: u64) -> u64 {
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        (self.state >> 11) % end
    }

    fn one_of<'t>(&mut self, all: &[&'t str]) -> &'t str {
        all[self.below(all.len() as u64) as usize]
    }

    /// A program with a few networks.
    pub(crate) fn program(&mut self) -> String {
        let count = 1 + self.below(3);
        (0..count).map(|_| format!("NETWORK\n{}", self.network())).collect()
    }

    fn network(&mut self) -> String {
        let mut out = String::new();
        for _ in 0..=self.below(2) {
            if self.below(5) == 0 {
                out.push_str(&self.value());
                continue;
            }
            self.logic(&mut out, 0);
            self.end(&mut out);
        }
        out
    }

    /// A string of logic.
    fn logic(&mut self, out: &mut String, depth: u64) {
        let steps = 1 + self.below(4);
        for step in 0..steps {
            let check = self.one_of(&["A", "A", "AN", "O", "ON", "X"]);
            match self.below(12) {
                0 if depth < 3 => {
                    out.push_str(&format!("{}(;\n", self.one_of(&["A", "O", "AN", "X"])));
                    self.logic(out, depth + 1);
                    out.push_str(");\n");
                }
                1 if depth < 3 => {
                    let (left, right) = (self.below(4) * 2, self.below(4) * 2);
                    let compare = self.one_of(&["==I", ">I", "<=I"]);
                    out.push_str(&format!("{}(;\nL MW {};\nL MW {};\n{compare};\n);\n", self.one_of(&["A", "O"]), 10 + left, 10 + right));
                }
                2 if step > 0 => out.push_str("NOT;\n"),
                3 if step > 0 => {
                    let bit = self.below(8);
                    out.push_str(&format!("{} M 30.{bit};\n", self.one_of(&["FP", "FN"])));
                }
                4 if step > 0 && step + 1 < steps => out.push_str("O;\n"),
                5 if step > 0 => {
                    let bit = self.below(4);
                    out.push_str(&format!("= M 40.{bit};\nA M 40.{bit};\n"));
                }
                6 => out.push_str(&format!("{check} T {};\n", 1 + self.below(2))),
                _ => {
                    let bit = self.below(6);
                    out.push_str(&format!("{check} I 0.{bit};\n"));
                }
            }
        }
    }

    fn end(&mut self, out: &mut String) {
        let (bit, timer) = (self.below(4), 1 + self.below(2));
        match self.below(10) {
            0 => out.push_str(&format!("S M 41.{bit};\n")),
            1 => out.push_str(&format!("S M 41.{bit};\nA I 0.{bit};\nR M 41.{bit};\nNOP 0;\n")),
            2 => out.push_str(&format!("L S5T#200MS;\n{} T {timer};\n", self.one_of(&["SD", "SE", "SP", "SS", "SF"]))),
            3 => {
                out.push_str(&format!("L S5T#200MS;\nSD T {timer};\nA I 0.5;\nR T {timer};\nNOP 0;\nNOP 0;\nA T {timer};\n= Q 4.{bit};\n"))
            }
            4 => {
                self.labels += 1;
                let label = self.labels;
                out.push_str(&format!("JNB _{label:03};\nL MW 10;\nT MW 50;\n_{label:03}: NOP 0;\n"));
            }
            5 => out.push_str(&format!("= L 20.0;\nA L 20.0;\nBLD 102;\n= Q 4.{bit};\nA L 20.0;\nA I 0.{bit};\nS M 42.{bit};\n")),
            6 => out.push_str(&format!("= Q 4.{bit};\nR M 41.{bit};\n")),
            7 => out.push_str(&format!("CU C {timer};\n")),
            _ => out.push_str(&format!("= Q 4.{bit};\n")),
        }
    }

    /// A box without condition.
    fn value(&mut self) -> String {
        let (from, to) = (10 + self.below(4) * 2, 50 + self.below(4) * 2);
        match self.below(3) {
            0 => format!("L MW {from};\nT MW {to};\n"),
            1 => format!("L MW {from};\nL 5;\n{};\nT MW {to};\nNOP 0;\n", self.one_of(&["+I", "-I", "*I", "/I"])),
            _ => format!("L MW {from};\nITD;\nT MD {};\n", to + 10),
        }
    }
}
