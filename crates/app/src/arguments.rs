//! Arguments that several verbs take.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use clap::{Args, ValueEnum};
use sieben_cpu::Cpu;
use sieben_engine::{Engine, Interpreter, Layout, Program};
use sieben_jit::{Jit, StatusBits, Tier, Tiers};
use sieben_lang::encoding::Encoding;
use sieben_lang::st::dialect::Dialect;
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::profile::Profile;
use sieben_sim::wrap::{self, Fault};

use crate::document::Document;
use crate::failure::Failure;
use crate::panics::Trouble;
use crate::project::{Overrides, Project};
use crate::settings::modules::Module;
use crate::{files, output, panics, settings};

/// What every verb that compiles a program takes.
#[derive(Args, Clone, Debug)]
pub(crate) struct ProgramArguments {
    /// CPU type: areas, accumulators, limits [default: the project's, else 315-2PN/DP]
    #[arg(long, value_name = "NAME")]
    cpu: Option<String>,
    /// Mnemonic language of the sources; auto judges each file as a whole [default: the project's, else auto]
    #[arg(long, value_name = "LANGUAGE")]
    mnemonics: Option<MnemonicsArgument>,
    /// Dialect of the sources of ST and SCL [default: the project's, else judged over each file]
    #[arg(long, value_name = "DIALECT", value_parser = dialect_argument)]
    dialect: Option<Dialect>,
    /// Allow the extension words of awlsim, such as `__ASSERT==` [default: the project's, else not]
    #[arg(long)]
    extended: bool,
    /// Whose rules hold where awlsim and the manual differ [default: the project's, else siemens]
    #[arg(long, value_name = "NAME")]
    profile: Option<ProfileArgument>,
    #[command(flatten)]
    encoding: EncodingArgument,
}

/// The dialect with this name.
pub(crate) fn dialect_argument(text: &str) -> Result<Dialect, String> {
    Dialect::from_name(text).ok_or_else(|| {
        let names = Dialect::ALL.map(Dialect::name).join(", ");
        format!("`{text}` is no dialect of ST; there are {names}")
    })
}

/// How the bytes of the files mean characters.
#[derive(Args, Clone, Copy, Debug)]
pub(crate) struct EncodingArgument {
    /// Encoding of the files without a byte order mark: utf-8, utf-16le, utf-16be, cp1250, cp1251 or cp1252 [default: guessed from each file]
    #[arg(long, value_name = "NAME", value_parser = encoding_argument)]
    encoding: Option<Encoding>,
}

impl EncodingArgument {
    /// The encoding that the user chose.
    pub(crate) fn chosen(self) -> Option<Encoding> {
        self.encoding
    }
}

fn encoding_argument(text: &str) -> Result<Encoding, String> {
    Encoding::from_name(text).ok_or_else(|| {
        let names = Encoding::ALL.map(Encoding::name).join(", ");
        format!("`{text}` is no encoding of source files; there are {names}")
    })
}

/// Whose rules hold where awlsim and the manual differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum ProfileArgument {
    // The manual.
    Siemens,
    // awlsim.
    Awlsim,
}

impl From<ProfileArgument> for Profile {
    fn from(argument: ProfileArgument) -> Self {
        match argument {
            ProfileArgument::Siemens => Self::Siemens,
            ProfileArgument::Awlsim => Self::Awlsim,
        }
    }
}

/// A mnemonic language, or the judgement over the whole file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum MnemonicsArgument {
    // Judged over each whole file.
    Auto,
    // International: A, JC, OPN.
    En,
    // SIMATIC: U, SPB, AUF.
    De,
}

impl MnemonicsArgument {
    /// The language, if one is named.
    pub(crate) fn language(self) -> Option<Mnemonics> {
        match self {
            Self::Auto => None,
            Self::En => Some(Mnemonics::English),
            Self::De => Some(Mnemonics::German),
        }
    }
}

/// How the plants of the project fail.
#[derive(Args, Clone, Debug)]
pub(crate) struct FaultArguments {
    /// Let a signal of a [[module]] fail: stuck, stuck=1, drift=0.5, late=200ms or bounce=50ms, at a time or between two
    #[arg(long = "fault", value_name = "MODULE.SIGNAL FAULT[@T[..T]]")]
    faults: Vec<String>,
}

impl FaultArguments {
    /// Lets the plants in the rack of a CPU fail. Times count from now.
    pub(crate) fn inject(&self, cpu: &mut Cpu) -> Result<(), Failure> {
        let inject = |text: &String| Fault::parse(text).and_then(|fault| wrap::inject(cpu.rack_mut(), &fault));
        self.faults.iter().try_for_each(inject).map_err(|message| Failure::usage(Problem::P6272, message))
    }

    /// Adds them to those of the project, which tells a recording of this run from one of a run without them.
    pub(crate) fn note(&self, modules: &mut [Module]) {
        for fault in self.faults.iter().filter_map(|text| Fault::parse(text).ok()) {
            if let Some(module) = modules.iter_mut().find(|module| module.device.name == fault.module) {
                module.faults.push(fault);
            }
        }
    }
}

impl ProgramArguments {
    /// Reads the files and folders of a program.
    pub(crate) fn load(&self, paths: &[PathBuf]) -> Result<Project, Failure> {
        Project::load(paths, self.encoding.chosen())
    }

    /// The encoding that the user chose for its files.
    pub(crate) fn encoding(&self) -> Option<Encoding> {
        self.encoding.chosen()
    }

    /// What these arguments say about the program.
    pub(crate) fn overrides(&self) -> Result<Overrides, Failure> {
        let cpu = match &self.cpu {
            None => None,
            Some(name) => Some(CpuType::by_name(name).ok_or_else(|| Failure::usage(Problem::P7002, settings::unknown_cpu(name)))?),
        };
        Ok(Overrides {
            cpu,
            mnemonics: self.mnemonics.map(MnemonicsArgument::language),
            dialect: self.dialect,
            extended: self.extended,
            profile: self.profile.map(Profile::from),
            ..Overrides::default()
        })
    }
}

/// How a verb that only reports prints what it found.
#[derive(Args, Clone, Debug)]
pub(crate) struct ReportArguments {
    /// Print JSON
    #[arg(long, conflicts_with = "html")]
    json: bool,
    /// Print a web page that needs nothing beside it, for reading and printing
    #[arg(long)]
    html: bool,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl ReportArguments {
    /// Whether diagnostics should be JSON too.
    pub(crate) fn json(&self) -> bool {
        self.json
    }

    /// Prints a document in the form that was asked for.
    pub(crate) fn put(&self, document: &Document, json: impl FnOnce() -> serde_json::Value) -> Result<(), Failure> {
        let text = match (self.json, self.html) {
            (true, _) => format!("{:#}\n", json()),
            (_, true) => document.html(),
            _ => document.text(),
        };
        match &self.output {
            Some(path) => files::write_whole(path, text.as_bytes()),
            None => output::print(&text),
        }
    }
}

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
            Self::Jit => panics::survive(|| Jit::compiled(program, layout, status)).unwrap_or_else(|trouble| {
                output::message(&stays_interpreted(&trouble.reason()));
                Interpreter::load(program, layout)
            }),
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

/// The message about a program that does not become machine code.
pub(crate) fn stays_interpreted(reason: &str) -> String {
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

/// Reads a duration argument.
pub(crate) fn duration_argument(text: &str) -> Result<Duration, String> {
    sieben_sim::duration::parse(text)
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
