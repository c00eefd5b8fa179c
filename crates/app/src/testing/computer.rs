//! What tests need of the computer that they run on: its clock, threads, engines and folders.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use sieben_cpu::StopRequest;
use sieben_engine::{Engine, Layout, Program};
use sieben_jit::StatusBits;
use sieben_model::language::Language;
use sieben_workspace::finding::{Finding, Texts};
use sieben_workspace::testing::{self, Outside};

use super::time_limit::TimeLimit;
use crate::engines::EngineArgument;
use crate::folder::write_named;
use crate::paths::shown;
use crate::report;

/// The computer as tests see it.
pub(crate) struct Computer {
    begun: Instant,
    engine: EngineArgument,
    /// The folder for the timing diagrams of tests that fail, as SVG.
    svg: Option<PathBuf>,
    /// In which it says what is wrong with a program.
    language: Language,
}

impl Computer {
    /// It runs programs with this engine, and keeps diagrams in this folder if somebody wants them.
    pub(crate) fn new(engine: EngineArgument, svg: Option<PathBuf>, language: Language) -> Self {
        Self { begun: Instant::now(), engine, svg, language }
    }
}

impl Outside for Computer {
    fn now(&self) -> Duration {
        self.begun.elapsed()
    }

    fn stop_after(&self, request: StopRequest, timeout: Duration) -> Box<dyn testing::TimeLimit> {
        Box::new(TimeLimit::start(request, timeout))
    }

    fn load(&self, program: &Program, layout: &Layout) -> Arc<dyn Engine> {
        self.engine.load(program, layout, StatusBits::All)
    }

    fn show(&self, findings: &[Finding], texts: &Texts) -> Vec<String> {
        report::parts(findings, texts, self.language)
    }

    fn keep_diagram(&self, name: &str, draw: &dyn Fn() -> Result<String, String>) -> Option<String> {
        let folder = self.svg.as_ref()?;
        let path = folder.join(name);
        let written =
            draw().and_then(|svg| write_named(folder, name, svg.as_bytes()).map_err(|error| format!("`{}`: {error}", shown(&path))));
        Some(match written {
            Ok(()) => format!("timing diagram: {}", shown(&path)),
            Err(error) => format!("the timing diagram could not be written: {error}"),
        })
    }
}
