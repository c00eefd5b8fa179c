//! The engines: which one runs a program, and the thread that makes its machine code.

use std::sync::Arc;

use clap::ValueEnum;
use sieben_engine::{Engine, Interpreter, Layout, Program};
use sieben_jit::{Jit, PassSet, StatusBits, Tier, Tiers};

use crate::panics::Trouble;
use crate::{output, panics};

/// Which engine runs the program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum EngineArgument {
    // The interpreter at once, machine code as soon as it is there.
    #[default]
    Auto,
    // The interpreter.
    Interpreter,
    // Machine code from the first scan.
    Jit,
    // Machine code from the first scan, compiled as fast as possible.
    Quick,
}

impl EngineArgument {
    /// What is measured: with `auto` the machine code that a program becomes in the end.
    pub(crate) fn settled(self) -> Self {
        if self == Self::Auto { Self::Jit } else { self }
    }

    /// What runs a program that is to take over within a moment: machine code comes after it.
    pub(crate) fn at_once(self) -> Self {
        if self == Self::Interpreter { Self::Interpreter } else { Self::Auto }
    }

    /// What makes programs runnable, for a CPU that is made of a build.
    pub(crate) fn factory(self, status: StatusBits) -> impl Fn(&Program, &Layout) -> Arc<dyn Engine> {
        move |program, layout| self.load(program, layout, status)
    }

    /// Loads a program. With `auto` a thread makes the machine code, which takes over at a scan boundary; else it is there at once.
    /// If machine code was asked for and cannot be had, says why and interprets the program.
    pub(crate) fn load(self, program: &Program, layout: &Layout, status: StatusBits) -> Arc<dyn Engine> {
        match self {
            Self::Interpreter => Interpreter::load(program, layout),
            Self::Auto => {
                let tiers = Tiers::load(program, layout, status);
                // Who shows all status bits runs for a moment; who does not runs for long, and wants to know.
                if let (StatusBits::Needed, Some(reason)) = (status, tiers.refusal()) {
                    output::message(&stays_interpreted(reason));
                }
                let engine = tiers.engine();
                // Without a thread the program stays in the interpreter, which is slower but right.
                let _ = std::thread::Builder::new().name("compiler".to_owned()).spawn(move || {
                    compile(|| Arc::strong_count(&tiers) > 1, |tier| tiers.compile(tier), &|| tiers.tier(), &mut output::message);
                });
                engine
            }
            Self::Jit => machine_code(program, layout, status, PassSet::default()),
            Self::Quick => {
                let tiers = Tiers::load(program, layout, status);
                if let Err(trouble) = panics::survive(|| tiers.compile(Tier::Quick)) {
                    output::message(&stays_interpreted(&trouble.reason()));
                }
                tiers.engine()
            }
        }
    }
}

/// Makes machine code with these optimizations; a program that cannot become it is interpreted, which is said.
pub(crate) fn machine_code(program: &Program, layout: &Layout, status: StatusBits, passes: PassSet) -> Arc<dyn Engine> {
    panics::survive(|| Jit::compiled_with(program, layout, status, passes)).unwrap_or_else(|trouble| {
        output::message(&stays_interpreted(&trouble.reason()));
        Interpreter::load(program, layout)
    })
}

/// The message about a program that does not become machine code.
fn stays_interpreted(reason: &str) -> String {
    format!("the program runs in the interpreter: {reason}\n")
}

/// Compiles one tier after the other, as long as some CPU runs the program. A mistake of ours is told once, and ends no run.
fn compile(
    mut wanted: impl FnMut() -> bool,
    mut attempt: impl FnMut(Tier) -> Result<(), String>,
    reached: &dyn Fn() -> Tier,
    tell: &mut dyn FnMut(&str),
) {
    let mut mistake = None;
    for tier in [Tier::Quick, Tier::Optimized] {
        if !wanted() {
            break;
        }
        // What cannot be compiled in one way may be in the other, and stays as it is if in none.
        match panics::survive(|| attempt(tier)) {
            Ok(()) | Err(Trouble::Refused(_)) => {}
            Err(trouble) => mistake = Some(trouble),
        }
    }
    if let Some(trouble) = mistake {
        match reached() {
            Tier::Interpreter => tell(&stays_interpreted(&trouble.reason())),
            _ => tell(&format!("the program runs as slower machine code than it could: {}\n", trouble.reason())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(reached: Tier, attempt: impl FnMut(Tier) -> Result<(), String>) -> Vec<String> {
        let mut told = Vec::new();
        compile(|| true, attempt, &|| reached, &mut |text| told.push(text.to_owned()));
        told
    }

    #[test]
    fn a_mistake_of_the_compiler_is_told_once_and_leaves_the_program_running() {
        let both = told(Tier::Interpreter, |_| panic!("no register left"));
        assert!(both.len() == 1 && both[0].starts_with("the program runs in the interpreter: its machine code"), "{both:?}");
        let second = told(Tier::Quick, |tier| if tier == Tier::Optimized { panic!("no register left") } else { Ok(()) });
        assert!(second.len() == 1 && second[0].starts_with("the program runs as slower machine code"), "{second:?}");
        assert!(told(Tier::Quick, |_| Err("it is too large".to_owned())).is_empty());
    }
}
