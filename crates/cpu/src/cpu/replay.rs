//! What a CPU did once more, elsewhere: what it began with and what came in since is copied, the CPU itself is not held up.

use std::sync::Arc;

use sieben_engine::{Interpreter, Program, Tracer};
use sieben_model::cpu_type::CpuType;

use super::snapshot::EndState;
use super::{Cpu, Loaded, ScanReport, Snapshot};
use crate::io::{Place, Rack};
use crate::retain::Declarations;
use crate::tape::Reading;

/// Most readings of the clock that are kept of one recording.
const READINGS_MAX: usize = 65_536;

/// A CPU at the beginning of a recording.
#[derive(Debug)]
struct Beginning {
    cpu_type: &'static CpuType,
    program: Arc<Program>,
    before: Snapshot,
    /// Where the modules are.
    places: Vec<Place>,
}

/// What a CPU does at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// [`Cpu::scan_with`].
    Scan,
    /// [`Cpu::serve_with`].
    Serve,
}

/// A step, and where the readings of the clock end that it made.
#[derive(Clone, Copy, Debug)]
struct Done {
    step: Step,
    readings: usize,
}

/// What came in while a CPU took a step.
#[derive(Debug)]
pub struct RecordedStep {
    step: Step,
    clock: Vec<u64>,
    readings: Vec<Reading>,
}

/// Steps of a CPU from one moment on, with all that came in while they ran. Nothing else may have happened to the CPU between them.
#[derive(Clone, Debug)]
pub struct Recording {
    beginning: Arc<Beginning>,
    steps: Vec<Done>,
    /// What the clock showed, in the order in which it was asked.
    clock: Vec<u64>,
    /// What those modules said that cannot be copied.
    readings: Vec<Reading>,
}

/// One scan with all that it began with and all that came in while it ran.
#[derive(Debug)]
pub struct RecordedScan {
    recording: Recording,
    after: Arc<EndState>,
    report: ScanReport,
}

/// A CPU that replays what others did, in the interpreter.
#[derive(Default)]
pub struct Replayer {
    /// The CPU, for the program and the layout that it was made for.
    cpu: Option<Cpu>,
    /// The recording that it plays, and how many of its steps it has played.
    at: Option<(Arc<Beginning>, usize)>,
}

/// Why something cannot be replayed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotReplayed {
    /// It asked the clock more often than is kept.
    TooLong,
}

impl std::fmt::Display for NotReplayed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::TooLong => "the scan is too long to be replayed",
        })
    }
}

impl std::error::Error for NotReplayed {}

impl Beginning {
    fn is_for(&self, cpu: &Cpu) -> bool {
        Arc::ptr_eq(&cpu.program, &self.program) && self.before.fits(cpu)
    }

    fn cpu(&self) -> Cpu {
        let layout = self.before.layout();
        let engine = Interpreter::load(&self.program, &layout);
        let loaded = Loaded {
            cpu_type: self.cpu_type,
            program: Arc::clone(&self.program),
            declarations: Arc::new(Declarations::of(&self.program)),
            image_writes: Arc::new(engine.image_writes(&self.program)),
            layout,
            engine,
        };
        Cpu::new(loaded, Rack::of_places(self.cpu_type, &self.places), self.before.settings().clone())
    }
}

impl RecordedStep {
    /// Lets a CPU take one step and records it. `cpu` says where the CPU is in `plant`, `run` takes the step with the clock that it is given.
    pub fn of<P, R>(
        plant: &mut P,
        (cpu, step): (impl Fn(&mut P) -> &mut Cpu, Step),
        clock: &mut dyn FnMut() -> u64,
        run: impl FnOnce(&mut P, &mut dyn FnMut() -> u64) -> R,
    ) -> (R, Self) {
        let begun = cpu(plant).rack.begin_record();
        let mut kept = Vec::new();
        let done = run(plant, &mut || {
            let now = clock();
            if kept.len() < READINGS_MAX {
                kept.push(now);
            }
            now
        });
        let readings = cpu(plant).rack.end_record(begun);
        (done, Self { step, clock: kept, readings })
    }
}

impl Recording {
    /// A recording that begins with a CPU as it is now. What did not change since another one began is shared with that.
    pub fn new(cpu: &Cpu, like: Option<&Self>) -> Self {
        Self::from(cpu, cpu.snapshot(like.map(|like| &like.beginning.before)))
    }

    fn from(cpu: &Cpu, before: Snapshot) -> Self {
        let beginning = Beginning { cpu_type: cpu.cpu_type, program: Arc::clone(&cpu.program), before, places: cpu.rack.places() };
        Self { beginning: Arc::new(beginning), steps: Vec::new(), clock: Vec::new(), readings: Vec::new() }
    }

    /// Adds the step that followed.
    pub fn push(&mut self, RecordedStep { step, clock, mut readings }: RecordedStep) {
        let room = READINGS_MAX.saturating_sub(self.clock.len());
        self.clock.extend(clock.into_iter().take(room));
        self.readings.append(&mut readings);
        self.steps.push(Done { step, readings: self.clock.len() });
    }

    /// How many steps it has.
    pub fn len(&self) -> usize {
        self.steps.len()
    }

    /// Whether it has no step yet.
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }

    /// Whether it takes no more steps: one of them asked the clock too often to be replayed.
    pub fn is_full(&self) -> bool {
        self.clock.len() >= READINGS_MAX
    }

    /// Whether it is one of this program.
    pub fn is_of(&self, program: &Arc<Program>) -> bool {
        Arc::ptr_eq(&self.beginning.program, program)
    }

    /// The program that runs in it.
    pub fn program(&self) -> &Arc<Program> {
        &self.beginning.program
    }

    /// Whether it begins with a CPU that is as this one: the same memory, timers, counters and mode.
    pub fn begins_as(&self, cpu: &Cpu) -> bool {
        self.beginning.before.is_of(cpu)
    }

    /// The memory that it takes beside what it shares with the one that it was made like; an estimate.
    pub fn bytes(&self) -> usize {
        let own = self.steps.len() * size_of::<Done>() + self.clock.len() * size_of::<u64>();
        self.beginning.before.bytes() + own + self.readings.iter().map(Reading::bytes).sum::<usize>()
    }
}

impl Replayer {
    /// The CPU after so many steps of a recording; of the last one a tracer is told each statement. Where that pauses, the CPU is as it was there.
    ///
    /// # Errors
    /// One of the steps cannot be taken again.
    pub fn play(&mut self, recording: &Recording, steps: usize, tracer: Option<&mut dyn Tracer>) -> Result<&Cpu, NotReplayed> {
        self.replay(recording, steps, tracer).map(|(cpu, _)| cpu)
    }

    /// As [`Self::play`]; whether the clock was asked as often as in the recording, too.
    fn replay(&mut self, recording: &Recording, steps: usize, mut tracer: Option<&mut dyn Tracer>) -> Result<(&Cpu, bool), NotReplayed> {
        let steps = steps.min(recording.len());
        let readings = |steps: usize| steps.checked_sub(1).map_or(0, |last| recording.steps[last].readings);
        if readings(steps) >= READINGS_MAX {
            return Err(NotReplayed::TooLong);
        }
        let beginning = &recording.beginning;
        // The last step is taken again if it is to be told.
        let reusable = steps - usize::from(tracer.is_some() && steps > 0);
        let mut played = match self.at.take() {
            Some((at, played)) if Arc::ptr_eq(&at, beginning) && played <= reusable => Some(played),
            _ => None,
        };
        let known = self.cpu.take().filter(|cpu| beginning.is_for(cpu));
        let cpu = self.cpu.insert(known.unwrap_or_else(|| {
            played = None;
            beginning.cpu()
        }));
        let first = played.unwrap_or_else(|| {
            cpu.go_back_to(&beginning.before);
            0
        });
        // What was recorded of the modules may have become more since.
        if !beginning.before.has_modules() && first == 0 {
            cpu.rack.play(recording.readings.clone());
        } else if !beginning.before.has_modules() {
            cpu.rack.play_on(&recording.readings);
        }
        let mut same = true;
        for index in first..steps {
            let Done { step, readings: end } = recording.steps[index];
            let mut next = readings(index);
            let mut clock = || {
                let reading = recording.clock.get(next).or(recording.clock.last()).copied().unwrap_or_default();
                next += 1;
                reading
            };
            let tracer = if index + 1 == steps { tracer.take() } else { None };
            match step {
                Step::Scan => drop(cpu.scan_with(&mut clock, tracer)),
                Step::Serve => cpu.serve_with(&mut clock, tracer),
            }
            same &= next == end;
        }
        // What a tracer has paused in the middle of a step is played from its beginning the next time.
        self.at = (!cpu.is_paused()).then(|| (Arc::clone(beginning), steps));
        Ok((cpu, same))
    }
}

impl Replayer {
    /// The CPU as the last replay left it.
    pub fn cpu(&self) -> Option<&Cpu> {
        self.cpu.as_ref()
    }
}

impl RecordedScan {
    /// What the scan did.
    pub fn report(&self) -> ScanReport {
        self.report
    }

    /// What the CPU was after the scan: the next recording shares with it what has not changed.
    pub fn after(&self) -> &Arc<EndState> {
        &self.after
    }

    /// Runs the scan again and tells the tracer of its statements; whether it ended as the real one did.
    ///
    /// # Errors
    /// It cannot be run again.
    pub fn replay(&self, replayer: &mut Replayer, tracer: &mut dyn Tracer) -> Result<bool, NotReplayed> {
        let (cpu, same) = replayer.replay(&self.recording, 1, Some(tracer))?;
        Ok(same && self.after.is_of(cpu))
    }
}

impl Cpu {
    /// As [`Self::scan_with`], with a recording for a [`Replayer`]. What did not change since the end of the recording `like` is shared with it.
    pub fn scan_recorded(&mut self, clock: &mut dyn FnMut() -> u64, like: Option<&EndState>) -> (ScanReport, RecordedScan) {
        let mut recording = Recording::from(self, self.snapshot_after(like));
        let (report, step) = RecordedStep::of(self, (|cpu: &mut Self| cpu, Step::Scan), clock, |cpu, clock| cpu.scan_with(clock, None));
        recording.push(step);
        let after = Arc::new(EndState::of(self, &recording.beginning.before));
        (report, RecordedScan { recording, after, report })
    }
}
