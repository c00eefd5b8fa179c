//! Plugging modules into a rack: each byte belongs to one module at most.

use std::any::Any;
use std::fmt;
use std::ops::Range;

use sieben_model::cpu_type::CpuType;
use sieben_model::problems::Problem;

use super::{IoModule, Rack, SimulatedModule};
use crate::listening::Orders;
use crate::tape::Tape;

/// Why modules cannot be plugged in together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RackError {
    /// Two modules want the same byte.
    Overlap {
        /// The module that came first.
        first: String,
        /// The module that came later.
        second: String,
        /// `true` for an input byte.
        input: bool,
        /// The byte.
        byte: u32,
    },
    /// A module reaches beyond the peripheral area.
    Beyond {
        /// The module.
        module: String,
        /// One after its last byte.
        end: u32,
        /// Bytes that the CPU type has.
        limit: u32,
    },
}

impl RackError {
    /// The problem code.
    pub fn problem(&self) -> Problem {
        match self {
            Self::Overlap { .. } => Problem::P8002,
            Self::Beyond { .. } => Problem::P8003,
        }
    }
}

impl fmt::Display for RackError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Overlap { first, second, input, byte } => {
                let area = if *input { "PIB" } else { "PQB" };
                write!(f, "the modules `{first}` and `{second}` both use `{area} {byte}`; every byte belongs to at most one module")
            }
            Self::Beyond { module, end, limit } => {
                write!(f, "the module `{module}` reaches to byte {}, the CPU type has bytes 0 to {}", end.saturating_sub(1), limit - 1)
            }
        }
    }
}

impl std::error::Error for RackError {}

/// Bytes next to each other that belong to one module.
#[derive(Clone, Debug)]
pub(super) struct Run {
    /// The module, as it was plugged in.
    pub(super) module: usize,
    /// The bytes.
    pub(super) bytes: Range<usize>,
}

impl Rack {
    /// One simulated module at every address: what a program without a configuration runs with.
    pub fn simulated(cpu: &CpuType) -> Self {
        Self::of(cpu, vec![background(cpu)])
    }

    /// These modules, and a simulated one at every address that they leave free.
    ///
    /// # Errors
    /// Two of them overlap, or one reaches beyond the peripheral area.
    pub fn with_background(cpu: &CpuType, modules: Vec<Box<dyn IoModule>>) -> Result<Self, RackError> {
        Self::check(cpu, &modules)?;
        Ok(Self::of(cpu, std::iter::once(background(cpu)).chain(modules).collect()))
    }

    /// Only these modules; an access elsewhere is an I/O access error.
    ///
    /// # Errors
    /// Two of them overlap, or one reaches beyond the peripheral area.
    pub fn with_only(cpu: &CpuType, modules: Vec<Box<dyn IoModule>>) -> Result<Self, RackError> {
        Self::check(cpu, &modules)?;
        Ok(Self::of(cpu, modules))
    }

    /// Modules that lie within the peripheral area; where two have the same byte it belongs to the later one.
    pub(super) fn of(cpu: &CpuType, modules: Vec<Box<dyn IoModule>>) -> Self {
        let size = cpu.peripheral as usize;
        let [mut input_owner, mut output_owner] = [(); 2].map(|()| vec![None; size]);
        // There are at most as many modules as bytes, far below 2^16.
        for (index, module) in (0_u16..).zip(&modules) {
            let places = |bytes: Range<u32>| bytes.start as usize..(bytes.end as usize).max(bytes.start as usize);
            input_owner[places(module.inputs())].fill(Some(index));
            output_owner[places(module.outputs())].fill(Some(index));
        }
        Self {
            lively: modules.iter().map(|module| !is_simulated(&**module)).collect(),
            modules,
            input_runs: runs(&input_owner),
            output_runs: runs(&output_owner),
            outputs: vec![0; size],
            enabled: false,
            changed: true,
            plain: false,
            alarms: Vec::new(),
            alarmed: false,
            tape: Tape::default(),
            now_us: 0,
            orders: Orders::default(),
            listener: None,
        }
    }

    fn check(cpu: &CpuType, modules: &[Box<dyn IoModule>]) -> Result<(), RackError> {
        for (index, module) in modules.iter().enumerate() {
            for (input, range) in [(true, module.inputs()), (false, module.outputs())] {
                if range.is_empty() && range.start < cpu.peripheral {
                    continue;
                }
                if range.end > cpu.peripheral {
                    return Err(RackError::Beyond { module: module.name().into(), end: range.end, limit: cpu.peripheral });
                }
                for earlier in &modules[..index] {
                    let other = if input { earlier.inputs() } else { earlier.outputs() };
                    let byte = range.start.max(other.start);
                    if byte < range.end.min(other.end) {
                        return Err(RackError::Overlap { first: earlier.name().into(), second: module.name().into(), input, byte });
                    }
                }
            }
        }
        Ok(())
    }
}

/// The simulated module of all addresses.
fn background(cpu: &CpuType) -> Box<dyn IoModule> {
    Box::new(SimulatedModule::new("simulated", 0..cpu.peripheral))
}

pub(super) fn is_simulated(module: &dyn IoModule) -> bool {
    (module as &dyn Any).is::<SimulatedModule>()
}

/// The module that a byte belongs to.
pub(super) fn owner(runs: &[Run], byte: u32) -> Option<usize> {
    let byte = byte as usize;
    let run = runs.get(runs.partition_point(|run| run.bytes.end <= byte))?;
    run.bytes.contains(&byte).then_some(run.module)
}

fn runs(owners: &[Option<u16>]) -> Vec<Run> {
    let mut begin = 0;
    let run = |owners: &[Option<u16>]| {
        let bytes = begin..begin + owners.len();
        begin = bytes.end;
        owners[0].map(|module| Run { module: usize::from(module), bytes })
    };
    owners.chunk_by(|one, other| one == other).filter_map(run).collect()
}
