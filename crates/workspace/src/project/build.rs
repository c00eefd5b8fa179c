//! A project compiled.

use sieben_lang::st::dialect::Dialect;
use sieben_lang::{Compiled, LostResults, Options, TemporaryReads};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Diagnostic;
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

/// How a project is compiled, made of what it says itself and what is said beside it.
#[derive(Clone, Debug)]
pub(super) struct Order {
    /// What the compiler is told.
    pub(super) options: Options,
    cpu: &'static CpuType,
    /// There is no text that could be compiled.
    pub(super) nothing: bool,
    may_be_empty: bool,
    strict: bool,
}

impl Order {
    /// For the CPU type of the overrides, else of the project, else the default.
    pub(super) fn of(project: &Project, overrides: Overrides, syntax_only: bool) -> Self {
        // Blocks and symbols of a refused diagram are missing everywhere else.
        let syntax_only = syntax_only || project.findings.iter().any(|finding| finding.diagnostic.problem == Problem::P6043);
        let settings = &project.settings;
        let cpu = overrides.cpu.or(settings.cpu).unwrap_or(&CpuType::ALL[0]);
        let profile = overrides.profile.or(settings.profile).unwrap_or_default();
        // A CPU type lives as long as the process; few have rules of their own.
        let cpu = if profile == Profile::Siemens { cpu } else { Box::leak(Box::new(profile.applied_to(cpu))) };
        let extended = overrides.extended || settings.extended;
        let mut system_blocks = sieben_cpu::system::interfaces();
        if extended {
            system_blocks.extend(sieben_cpu::system::extension_interfaces());
        }
        if overrides.tests {
            system_blocks.extend(sieben_cpu::system::test_interfaces());
        }
        let options = Options {
            cpu: Some(cpu),
            mnemonics: overrides.mnemonics.unwrap_or(settings.mnemonics),
            syntax_only,
            temporaries: overrides.temporaries,
            extended,
            replacing: overrides.replacing.then_some(FileId(0)),
            system_blocks,
            library: settings.library.clone(),
            dialect: overrides.dialect.or(settings.dialect),
            tests: overrides.tests,
            counted: overrides.counted,
            tells_lost: overrides.tells_lost,
        };
        // An extended program may be empty.
        let may_be_empty = extended && !project.sources.is_empty();
        let nothing = !may_be_empty && project.findings.iter().any(is_empty);
        Self { options, cpu, nothing, may_be_empty, strict: overrides.strict }
    }
}

fn is_empty(finding: &Finding) -> bool {
    finding.diagnostic.problem == Problem::P6005
}

impl Project {
    /// Compiles it for the CPU type of the overrides, else of the project, else the default.
    pub fn compile(self, overrides: Overrides, syntax_only: bool) -> Build {
        let order = Order::of(&self, overrides, syntax_only);
        let compiled = match order.nothing {
            true => Compiled::default(),
            false => sieben_lang::dialects::compile(&self.texts.program, &self.symbols, &order.options),
        };
        self.built(&order, compiled)
    }

    /// What was noticed, with what the compiler has to say.
    pub(super) fn found(&self, order: &Order, diagnostics: &[Diagnostic]) -> Vec<Finding> {
        let mut findings = self.findings.clone();
        findings.retain(|finding| !(order.may_be_empty && is_empty(finding)));
        findings.extend(self.settings.retain.beyond(order.cpu).into_iter().map(Finding::document));
        findings.extend(settings::modules::problems(&self.settings.modules, order.cpu).into_iter().map(Finding::document));
        findings.extend(diagnostics.iter().cloned().map(Finding::program));
        finding::sort(&mut findings);
        findings.iter_mut().for_each(|finding| finding.strict = order.strict);
        findings
    }

    /// The project with what the compiler made of it.
    pub(super) fn built(mut self, order: &Order, compiled: Compiled) -> Build {
        compiled.add_library_sources(&mut self.texts.program);
        let findings = self.found(order, &compiled.diagnostics);
        Build { project: self, compiled, cpu: order.cpu, findings }
    }
}
