//! The file of a campaign and its programs, read and compiled for a command.

use std::ops::Range;
use std::path::{Path, PathBuf};

use clap::Args;
use sieben_campaign::parse::parse;
use sieben_jit::StatusBits;
use sieben_model::problems::Problem;
use sieben_workspace::campaign::{self, Campaign, Failed, Files};
use sieben_workspace::finding::{self, Finding, Texts};
use sieben_workspace::project::Project;
use sieben_workspace::refusal::Refusal;

use crate::arguments::ProgramArguments;
use crate::campaign::said;
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::{files, project, report};

/// Which scenario, and where what is made of it goes.
#[derive(Args)]
pub(super) struct OneScenario {
    /// The file of the campaign
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    /// The number of the scenario, from 0
    #[arg(value_name = "N")]
    pub(super) number: u64,
    #[command(flatten)]
    program: ProgramArguments,
    /// Another seed than that of the file
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}

impl OneScenario {
    /// The campaign, which has that scenario; otherwise its findings are printed.
    pub(super) fn open(&self, engine: EngineArgument) -> Result<Result<Opened, Exit>, Failure> {
        let opened = open(&self.spec, &self.program, self.seed, engine, false)?;
        if let Ok(opened) = &opened {
            wanted(&opened.campaign, Some((self.number, self.number)))?;
        }
        Ok(opened)
    }
}

/// A campaign that was read, with what it is called.
pub(super) struct Opened {
    pub(super) campaign: Campaign,
    /// What it is called.
    pub(super) name: String,
    /// The folder that its paths count from.
    pub(super) folder: PathBuf,
    /// Its file.
    #[cfg_attr(not(feature = "parquet"), expect(dead_code))]
    pub(super) text: String,
}

/// The files around that of a campaign or of a fleet.
pub(in crate::commands) struct Around<'a> {
    folder: PathBuf,
    program: &'a ProgramArguments,
}

impl<'a> Around<'a> {
    /// Those around this file.
    pub(in crate::commands) fn of(path: &Path, program: &'a ProgramArguments) -> Self {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).map_or_else(|| PathBuf::from("."), Path::to_path_buf);
        Self { folder, program }
    }
}

impl Files for Around<'_> {
    fn project(&self, path: &str) -> Result<Project, Refusal> {
        let at = if path == "." { self.folder.clone() } else { self.folder.join(path) };
        project::load(&[at], self.program.encoding()).map_err(|failure| failure.refusal)
    }

    fn text(&self, path: &str) -> Result<String, Refusal> {
        let bytes = files::read(&self.folder.join(path)).map_err(|failure| failure.refusal)?;
        String::from_utf8(bytes).map_err(|_| Refusal::new(Problem::P7163, format!("`{path}` is not UTF-8 text")))
    }
}

/// Reads a campaign and compiles its programs; otherwise its findings are printed.
pub(super) fn open(
    path: &Path,
    program: &ProgramArguments,
    seed: Option<u64>,
    engine: EngineArgument,
    json: bool,
) -> Result<Result<Opened, Exit>, Failure> {
    let bytes = files::read(path)?;
    let mut texts = Texts::default();
    let text = String::from_utf8(bytes).map_err(|_| Failure::usage(Problem::P7156, format!("`{}` is not UTF-8 text", path.display())))?;
    let text = text.strip_prefix('\u{FEFF}').unwrap_or(&text);
    let file = texts.documents.add(path.display().to_string(), text);
    let (spec, diagnostics) = parse(text, file);
    let mut findings: Vec<Finding> = diagnostics.into_iter().map(Finding::document).collect();
    let told = |findings: &mut Vec<Finding>, texts: &Texts| {
        finding::sort(findings);
        report::print(findings, texts, json);
    };
    let Some(mut spec) = spec.filter(|_| !finding::has_errors(&findings)) else {
        told(&mut findings, &texts);
        return Ok(Err(Exit::DoesNotCompile));
    };
    spec.seed = seed.unwrap_or(spec.seed);
    let name = spec.name.clone().unwrap_or_else(|| path.file_stem().unwrap_or_default().to_string_lossy().into_owned());
    let around = Around::of(path, program);
    let factory = engine.settled().factory(StatusBits::Needed);
    match campaign::open(spec, text, &around, program.overrides()?, &factory) {
        Ok(campaign) => {
            findings.extend(campaign.warnings.iter().cloned().map(Finding::document));
            if !findings.is_empty() {
                told(&mut findings, &texts);
            }
            Ok(Ok(Opened { campaign, name, folder: around.folder, text: text.to_owned() }))
        }
        Err(Failed::Spec(wrong)) => {
            findings.extend(wrong.into_iter().map(Finding::document));
            told(&mut findings, &texts);
            Ok(Err(Exit::DoesNotCompile))
        }
        Err(Failed::Program(build)) => {
            report::print(&build.findings, &build.project.texts, json);
            Ok(Err(Exit::DoesNotCompile))
        }
        Err(Failed::Refused(refusal)) => Err(refusal.into()),
    }
}

/// The numbers that are asked for.
pub(super) fn wanted(campaign: &Campaign, only: Option<(u64, u64)>) -> Result<Range<u64>, Failure> {
    let all = campaign.scenarios();
    match only {
        None => Ok(0..all),
        Some((from, to)) if to < all => Ok(from..to + 1),
        Some((from, to)) => {
            let which = if from == to { format!("there is no scenario {from}") } else { format!("`--only {from}..{to}`") };
            let message = format!("{which}: the campaign has {}, 0 to {}", said::scenarios(all), all.saturating_sub(1));
            Err(Failure::usage(Problem::P7001, message))
        }
    }
}
