//! Arguments that several verbs take.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use sieben_cpu::Cpu;
use sieben_lang::LostResults;
use sieben_lang::encoding::Encoding;
use sieben_lang::st::dialect::Dialect;
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::profile::Profile;
use sieben_sim::wrap::{self, Fault};
use sieben_workspace::project::{Overrides, Project};
use sieben_workspace::settings::{self, modules::Module};

use crate::document::Document;
use crate::failure::Failure;
use crate::project;
use crate::{files, language, output};

/// What every verb that compiles a program takes.
#[derive(Args, Clone, Debug, Default)]
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

impl ProgramArguments {
    /// Whether the command line says something about the program that its files do not say.
    #[cfg(feature = "nats")]
    pub(crate) fn says_more(&self) -> bool {
        let Self { cpu, mnemonics, dialect, extended, profile, encoding: _ } = self;
        cpu.is_some() || mnemonics.is_some() || dialect.is_some() || *extended || profile.is_some()
    }
}

/// The dialect with this name.
pub(crate) fn dialect_argument(text: &str) -> Result<Dialect, String> {
    Dialect::from_name(text).ok_or_else(|| {
        let names = Dialect::ALL.map(Dialect::name).join(", ");
        format!("`{text}` is no dialect of ST; there are {names}")
    })
}

/// How the bytes of the files mean characters.
#[derive(Args, Clone, Copy, Debug, Default)]
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

/// How much is let pass.
#[derive(Args, Clone, Copy, Debug)]
pub(crate) struct StrictArgument {
    /// What STEP 7 refuses is an error (exit code 3), and so is a statement that fails while the program runs (exit code 1)
    #[arg(long)]
    strict: bool,
}

impl StrictArgument {
    /// Whether nothing is let pass.
    pub(crate) fn is_strict(self) -> bool {
        self.strict
    }

    /// What it says about the program.
    pub(crate) fn overrides(self, overrides: Overrides) -> Overrides {
        Overrides { strict: self.strict, ..overrides }
    }
}

/// Whether the diagnostic buffer is shown.
#[derive(Args, Clone, Copy, Debug)]
pub(crate) struct DiagnosticsArgument {
    /// Print the diagnostic buffer at the end, the newest entry first
    #[arg(long)]
    diagnostics: bool,
}

impl DiagnosticsArgument {
    /// Whether it is.
    pub(crate) fn wanted(self) -> bool {
        self.diagnostics
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
        project::load(paths, self.encoding.chosen())
    }

    /// Reads them as files of which each is looked at by itself.
    pub(crate) fn load_files(&self, paths: &[PathBuf]) -> Result<Project, Failure> {
        project::load_files(paths, self.encoding.chosen())
    }

    /// The encoding that the user chose for its files.
    pub(crate) fn encoding(&self) -> Option<Encoding> {
        self.encoding.chosen()
    }

    /// The same for a run at full speed: what costs time in a program in which nothing fails is left out.
    pub(crate) fn overrides_at_speed(&self) -> Result<Overrides, Failure> {
        Ok(Overrides { tells_lost: LostResults::Quotients, ..self.overrides()? })
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
            tells_lost: LostResults::All,
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
        let document = document.clone().in_language(language::spoken());
        match (&self.output, self.json, self.html) {
            (Some(path), true, _) => files::write_whole(path, format!("{:#}\n", json()).as_bytes()),
            (Some(path), _, true) => files::write_whole(path, document.html().as_bytes()),
            (Some(path), ..) => files::write_whole(path, document.text().as_bytes()),
            (None, true, _) => output::print_json(&json(), true),
            (None, _, true) => output::print_data(&document.html()),
            (None, ..) => output::print(&document.text()),
        }
    }
}
