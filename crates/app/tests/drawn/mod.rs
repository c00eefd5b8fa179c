//! Programs whose networks are drawn, as LAD and FBD, and written as statements again: each step must do what the program did.

use std::sync::Arc;

use sieben_lang::Compiled;
use sieben_lang::body::CheckedBody;
use sieben_lang::network::flavour::Drawing;
use sieben_lang::network::read::Mode;
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
        let settings = program::settings(&compiled);
        forms.push(Written { name, text: text.clone(), compiled: Arc::new(compiled.program.clone()), settings });
    }
    Ok(forms)
}

fn redraw(text: &str, compiled: &Compiled, target: Target) -> Redrawn {
    let blocks = compiled.bodies.values().filter_map(|body| match &**body {
        CheckedBody::Stl(block) => Some(block),
        CheckedBody::St(_) => None,
    });
    let source = Source { file: FileId(0), text, mnemonics: Mnemonics::English, drawing: None, blocks: blocks.collect() };
    source.redraw(&Redrawing { target, block: None, mode: Mode::RewritingConstants })
}
