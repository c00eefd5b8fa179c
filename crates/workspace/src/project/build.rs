//! A project compiled.

use sieben_lang::st::dialect::Dialect;
use sieben_lang::{Compiled, LostResults, Options, TemporaryReads};
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::profile::Profile;
use sieben_model::source::FileId;

use super::Project;
use crate::finding::{self, Finding};
use crate::settings;

/// What is said about a program beside its project: on the command line, or by who runs it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Overrides {
    /// `--cpu`.
    pub cpu: Option<&'static CpuType>,
    /// `--mnemonics en|de`; `Some(None)` is `auto`.
    pub mnemonics: Option<Option<Mnemonics>>,
    /// `--dialect`.
    pub dialect: Option<Dialect>,
    /// `--temp`.
    pub temporaries: TemporaryReads,
    /// `--extended`.
    pub extended: bool,
    /// `--profile`.
    pub profile: Option<Profile>,
    /// The first source is a test: its blocks take the place of those with the same number.
    pub replacing: bool,
    /// Test files among the sources are compiled.
    pub tests: bool,
    /// It is told how statements and decisions are counted.
    pub counted: bool,
    /// Which lost results the CPU is told of.
    pub tells_lost: LostResults,
    /// `--strict`: what STEP 7 refuses is an error.
    pub strict: bool,
}

/// A project with what the compiler made of it.
#[derive(Clone, Debug)]
pub struct Build {
    /// Where it came from.
    pub project: Project,
    /// The program.
    pub compiled: Compiled,
    /// The CPU type it is for.
    pub cpu: &'static CpuType,
    /// Everything that was noticed, in order.
    pub findings: Vec<Finding>,
}

impl Project {
    /// Compiles it for the CPU type of the overrides, else of the project, else the default.
    pub fn compile(mut self, overrides: Overrides, syntax_only: bool) -> Build {
        // Blocks and symbols of a refused diagram are missing everywhere else.
        let syntax_only = syntax_only || self.findings.iter().any(|finding| finding.diagnostic.problem == Problem::P6043);
        let cpu = overrides.cpu.or(self.settings.cpu).unwrap_or(&CpuType::ALL[0]);
        let profile = overrides.profile.or(self.settings.profile).unwrap_or_default();
        // A CPU type lives as long as the process; few have rules of their own.
        let cpu = if profile == Profile::Siemens { cpu } else { Box::leak(Box::new(profile.applied_to(cpu))) };
        let extended = overrides.extended || self.settings.extended;
        let mut system_blocks = sieben_cpu::system::interfaces();
        if extended {
            system_blocks.extend(sieben_cpu::system::extension_interfaces());
        }
        if overrides.tests {
            system_blocks.extend(sieben_cpu::system::test_interfaces());
        }
        let options = Options {
            cpu: Some(cpu),
            mnemonics: overrides.mnemonics.unwrap_or(self.settings.mnemonics),
            syntax_only,
            temporaries: overrides.temporaries,
            extended,
            replacing: overrides.replacing.then_some(FileId(0)),
            system_blocks,
            library: self.settings.library.clone(),
            dialect: overrides.dialect.or(self.settings.dialect),
            tests: overrides.tests,
            counted: overrides.counted,
            tells_lost: overrides.tells_lost,
        };
        // An extended program may be empty.
        let empty = |finding: &Finding| finding.diagnostic.problem == Problem::P6005;
        let may_be_empty = extended && !self.sources.is_empty();
        let nothing = !may_be_empty && self.findings.iter().any(empty);
        let compiled = match nothing {
            true => Compiled::default(),
            false => sieben_lang::dialects::compile(&self.texts.program, &self.symbols, &options),
        };
        compiled.add_library_sources(&mut self.texts.program);
        let mut findings = self.findings.clone();
        findings.retain(|finding| !(may_be_empty && empty(finding)));
        findings.extend(self.settings.retain.beyond(cpu).into_iter().map(Finding::document));
        findings.extend(settings::modules::problems(&self.settings.modules, cpu).into_iter().map(Finding::document));
        findings.extend(compiled.diagnostics.iter().cloned().map(Finding::program));
        finding::sort(&mut findings);
        findings.iter_mut().for_each(|finding| finding.strict = overrides.strict);
        Build { project: self, compiled, cpu, findings }
    }
}
