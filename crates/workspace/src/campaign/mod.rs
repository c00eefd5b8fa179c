//! Campaigns of a project: its programs with the expressions of the campaign compiled in, and the run of one scenario by its number.

mod case;
mod closely;
mod distance;
mod opening;
mod running;
mod shrinking;
pub mod targets;
pub(crate) mod watching;

use std::sync::{Arc, OnceLock};

use sieben_campaign::given::Given;
use sieben_campaign::identity::{Bundle, Identity};
use sieben_campaign::numbering::Numbering;
use sieben_campaign::row::Row;
use sieben_campaign::spec::Spec;
use sieben_cpu::{Loaded, Settings};
use sieben_engine::{Engine, Interpreter, Layout, Program};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Diagnostic;
use sieben_sim::names::{Name, Setting};
use sieben_sim::scenario::Scenario;

use crate::project::Build;
use targets::Target;
use watching::Watching;

pub use closely::Found;
pub use opening::{Failed, Files, open};
pub use shrinking::Smaller;

/// A campaign, ready to run: any number of threads run scenarios of it.
pub struct Campaign {
    /// What it is asked for.
    pub spec: Spec,
    /// How its scenarios are numbered.
    pub numbering: Numbering,
    /// What identifies it.
    pub identity: Identity,
    /// All files of its programs.
    pub bundle: Bundle,
    /// The programs that each scenario runs on.
    pub programs: Vec<Subject>,
    /// What its user is told although it can be run.
    pub warnings: Vec<Diagnostic>,
    /// The recording that it replays, if it does.
    recording: Option<Scenario>,
}

/// A program of a campaign.
pub struct Subject {
    /// What its file is called in the campaign.
    pub path: String,
    /// The program with the expressions of the campaign.
    pub build: Build,
    cpu: &'static CpuType,
    loaded: Loaded,
    /// The same program in the interpreter, once it is asked for.
    interpreted: OnceLock<Loaded>,
    settings: Settings,
    watching: Watching,
    cycle_us: u64,
    scans: u64,
    /// What is set before the first scan, whatever the number is.
    set: Vec<Setting>,
    /// Parameters of plants that are the same in every scenario: module, parameter, value.
    fixed: Vec<(usize, usize, f64)>,
    /// Where the values of `[sweep]` and `[draw]` go, in their order.
    targets: Vec<Target>,
    /// The bits of `[exhaustive]`.
    bits: Vec<Name>,
}

/// What runs the program of a scenario.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// The engine that the campaign was opened with.
    Chosen,
    /// The interpreter, which has to come to the same.
    Interpreted,
}

/// What makes a program run.
pub type Factory<'a> = dyn Fn(&Program, &Layout) -> Arc<dyn Engine> + 'a;

impl Campaign {
    /// How many scenarios it has.
    pub fn scenarios(&self) -> u64 {
        self.numbering.count()
    }

    /// What a number stands for.
    pub fn given(&self, number: u64) -> Given {
        Given::of(&self.spec, &self.numbering, number)
    }

    /// The scenario of a number, as a file of it says it.
    ///
    /// # Errors
    /// A value that was drawn does not fit; the message says so.
    pub fn scenario(&self, number: u64) -> Result<Scenario, String> {
        let scenario = self.programs[0].scenario(self, &self.given(number))?;
        Ok(scenario.with_properties(running::properties(&self.spec)))
    }

    /// What the bits of `[exhaustive]` are called, the first of the number first.
    pub fn bits(&self) -> impl Iterator<Item = &str> {
        self.programs[0].bits.iter().map(Name::text)
    }

    /// The row of a scenario that could not be run, and why.
    pub fn not_run(&self, number: u64, message: String) -> Row {
        running::not_run(self, &self.given(number), message)
    }

    /// Runs a scenario on all programs, as long as it may go on.
    ///
    /// # Errors
    /// It was given up after so many scans.
    pub fn run(&self, number: u64, way: Way, may_go_on: &dyn Fn() -> bool) -> Result<Row, u64> {
        running::run(self, &self.given(number), way, may_go_on)
    }
}

impl Subject {
    fn loaded(&self, way: Way) -> &Loaded {
        match way {
            Way::Chosen => &self.loaded,
            Way::Interpreted => self.interpreted.get_or_init(|| {
                let program = Arc::new(self.build.compiled.program.clone());
                Loaded::new(self.cpu, program, |program, layout| Interpreter::load(program, layout))
            }),
        }
    }

    /// From one scan to the next, in microseconds.
    pub fn cycle_us(&self) -> u64 {
        self.cycle_us
    }

    /// How many scans a scenario has that nothing ends before its time.
    pub fn scans(&self) -> u64 {
        self.scans
    }
}
