//! Arguments that several verbs take.

use std::time::Duration;

use clap::{Args, ValueEnum};
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;

use crate::failure::Failure;
use crate::project::Overrides;
use crate::settings;

/// What every verb that compiles a program takes.
#[derive(Args, Clone, Debug)]
pub(crate) struct ProgramArguments {
    /// CPU type: areas, accumulators, limits [default: the project's, else 315-2PN/DP]
    #[arg(long, value_name = "NAME")]
    cpu: Option<String>,
    /// Mnemonic language of the sources; auto judges each file as a whole [default: the project's, else auto]
    #[arg(long, value_name = "LANGUAGE")]
    mnemonics: Option<MnemonicsArgument>,
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

impl ProgramArguments {
    /// What these arguments say about the program.
    pub(crate) fn overrides(&self) -> Result<Overrides, Failure> {
        let cpu = match &self.cpu {
            None => None,
            Some(name) => Some(CpuType::by_name(name).ok_or_else(|| Failure::usage(Problem::P7002, settings::unknown_cpu(name)))?),
        };
        Ok(Overrides { cpu, mnemonics: self.mnemonics.map(MnemonicsArgument::language) })
    }
}

/// Which engine runs the program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum EngineArgument {
    // The fastest there is.
    #[default]
    Auto,
    // The interpreter.
    Interpreter,
    // Machine code.
    #[value(hide = true)]
    Jit,
}

impl EngineArgument {
    /// Refuses an engine that does not exist yet.
    pub(crate) fn require_available(self) -> Result<(), Failure> {
        match self {
            Self::Auto | Self::Interpreter => Ok(()),
            Self::Jit => Err(Failure::usage(Problem::P7006, "there is no `jit` engine in this version")),
        }
    }
}

/// Reads a duration argument.
pub(crate) fn duration_argument(text: &str) -> Result<Duration, String> {
    sieben_sim::duration::parse(text)
}
