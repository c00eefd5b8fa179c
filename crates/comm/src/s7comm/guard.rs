//! What a connection may do: functions, areas and data blocks.

use sieben_cpu::{ProtectionLevel, Restart};
use sieben_model::cpu_type::CpuType;
use sieben_workspace::settings::servers::{Access, Allowed, Scope};

use super::job::{BlockName, BlockType, Job, VariableArea};
use super::wire::codes::{ItemCode, Refusal};

/// The rules that a server has for all its connections.
#[derive(Clone, Debug, PartialEq)]
pub struct Rules {
    /// The CPU that it serves: its type says how long a PDU is.
    pub cpu: &'static CpuType,
    /// The protection level of the CPU.
    pub protection: ProtectionLevel,
    /// The password that lifts it, filled up with spaces to eight characters.
    pub password: Option<[u8; 8]>,
    /// Whether anything may be changed at all.
    pub writing: Writing,
    /// The areas that may be reached; `None` for all.
    pub allow: Option<Vec<Allowed>>,
    /// As a real CPU where that makes tests harder: no cold start on an S7-300.
    pub strict: bool,
    /// Only connections to the slot of the CPU.
    pub strict_slot: bool,
}

/// Whether clients may change anything.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Writing {
    /// They may, as far as the protection level allows it.
    #[default]
    Allowed,
    /// They may not: every write is refused.
    ReadOnly,
}

/// Whether a connection has entered the password.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Legitimation {
    /// It has not.
    #[default]
    None,
    /// It has: the protection level does not bind it.
    Password,
}

/// What clients ask for, as it is guarded and counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Function {
    /// Setup of the connection.
    Setup,
    /// Reading variables.
    Read,
    /// Writing variables.
    Write,
    /// System status lists.
    SystemStatus,
    /// Reading the clock.
    Clock,
    /// Setting the clock.
    SetClock,
    /// Lists of blocks and their headers.
    BlockLists,
    /// Upload.
    Upload,
    /// Download.
    Download,
    /// Linking.
    Link,
    /// Deleting.
    Delete,
    /// STOP.
    Stop,
    /// A start.
    Start,
    /// Copy RAM to ROM.
    CopyRamToRom,
    /// Compressing the memory.
    Compress,
    /// Memory reset.
    MemoryReset,
    /// Entering and clearing a password.
    Password,
    /// Everything else.
    Other,
}

/// What a function does to the CPU.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Effect {
    Looks,
    Changes,
}

use Effect::{Changes, Looks};

/// The functions, from which protection level on each needs the password, what it does, and its name. Operator control (variables and the clock)
/// needs none at any level: that is what the levels are for.
#[rustfmt::skip] // A table.
const FUNCTIONS: &[(Function, Option<ProtectionLevel>, Effect, &str)] = &[
    (Function::Setup,        None,                                      Looks,   "setup"),
    (Function::Read,         None,                                      Looks,   "read"),
    (Function::Write,        None,                                      Changes, "write"),
    (Function::SystemStatus, None,                                      Looks,   "system_status"),
    (Function::Clock,        None,                                      Looks,   "clock"),
    (Function::SetClock,     None,                                      Changes, "set_clock"),
    (Function::BlockLists,   None,                                      Looks,   "block_lists"),
    (Function::Upload,       Some(ProtectionLevel::ReadWriteProtected), Looks,   "upload"),
    (Function::Download,     Some(ProtectionLevel::WriteProtected),     Changes, "download"),
    (Function::Link,         Some(ProtectionLevel::WriteProtected),     Changes, "link"),
    (Function::Delete,       Some(ProtectionLevel::WriteProtected),     Changes, "delete"),
    (Function::Stop,         Some(ProtectionLevel::WriteProtected),     Changes, "stop"),
    (Function::Start,        Some(ProtectionLevel::WriteProtected),     Changes, "start"),
    (Function::CopyRamToRom, Some(ProtectionLevel::WriteProtected),     Changes, "copy_ram_to_rom"),
    (Function::Compress,     Some(ProtectionLevel::WriteProtected),     Changes, "compress"),
    (Function::MemoryReset,  Some(ProtectionLevel::WriteProtected),     Changes, "memory_reset"),
    (Function::Password,     None,                                      Looks,   "password"),
    (Function::Other,        None,                                      Looks,   "other"),
];

impl Function {
    /// How many there are.
    pub const COUNT: usize = FUNCTIONS.len();

    /// All of them.
    pub fn all() -> impl Iterator<Item = Self> {
        FUNCTIONS.iter().map(|row| row.0)
    }

    /// The function of a job.
    pub fn of(job: &Job) -> Self {
        match job {
            Job::Read(_) => Self::Read,
            Job::Write(_) => Self::Write,
            Job::SystemStatus { .. } => Self::SystemStatus,
            Job::Clock => Self::Clock,
            Job::SetClock(_) => Self::SetClock,
            Job::BlockCounts | Job::BlockList(_) | Job::BlockInfo(_) => Self::BlockLists,
            Job::Stop => Self::Stop,
            Job::Start(_) => Self::Start,
            Job::CopyRamToRom => Self::CopyRamToRom,
            Job::Compress => Self::Compress,
            Job::MemoryReset => Self::MemoryReset,
            Job::Upload(_) => Self::Upload,
            Job::Download(_) => Self::Download,
            Job::Link(_) => Self::Link,
            Job::Delete(_) => Self::Delete,
        }
    }

    /// Its name, as counters have it.
    pub fn name(self) -> &'static str {
        self.row().3
    }

    fn row(self) -> &'static (Self, Option<ProtectionLevel>, Effect, &'static str) {
        FUNCTIONS.iter().find(|row| row.0 == self).expect("each function has its row")
    }
}

impl Rules {
    /// Judges a job before it is done. Variables that may not be reached get a code of their own.
    ///
    /// # Errors
    /// The job as a whole is refused.
    pub fn judge(&self, job: &mut Job, legitimation: Legitimation) -> Result<(), Refusal> {
        self.judge_function(Function::of(job), legitimation)?;
        match job {
            Job::Read(variables) => refuse_items(variables, |variable| self.reaches(variable.area, Looks)),
            Job::Write(assignments) => {
                refuse_items(assignments, |assignment| self.writing == Writing::Allowed && self.reaches(assignment.variable.area, Changes))
            }
            Job::Start(Restart::Cold) if self.strict && self.cpu.accumulators == 2 => return Err(Refusal::CannotPerform),
            // They act on all of the memory, and so on what a list keeps closed.
            Job::MemoryReset | Job::CopyRamToRom if self.allow.is_some() => return Err(Refusal::Protected),
            Job::Upload(name) => self.judge_block(*name, Looks)?,
            Job::Download(download) => self.judge_block(download.name, Changes)?,
            Job::Link(names) | Job::Delete(names) => names.iter().try_for_each(|&name| self.judge_block(name, Changes))?,
            _ => {}
        }
        Ok(())
    }

    /// Judges a download before the block has come.
    ///
    /// # Errors
    /// It is refused.
    pub fn judge_download(&self, name: BlockName, legitimation: Legitimation) -> Result<(), Refusal> {
        self.judge_function(Function::Download, legitimation)?;
        self.judge_block(name, Changes)
    }

    /// Whether single variables of a write job may be refused.
    pub(super) fn limit_writes(&self) -> bool {
        self.writing == Writing::ReadOnly || self.allow.is_some()
    }

    /// Judges a function, whatever it is about.
    fn judge_function(&self, function: Function, legitimation: Legitimation) -> Result<(), Refusal> {
        let &(_, level, effect, _) = function.row();
        let protected = legitimation == Legitimation::None && level.is_some_and(|level| self.protection >= level);
        // Variables have codes of their own.
        let read_only = self.writing == Writing::ReadOnly && effect == Changes && function != Function::Write;
        if protected || read_only { Err(Refusal::Protected) } else { Ok(()) }
    }

    /// A data block is judged as its variables are.
    fn judge_block(&self, name: BlockName, effect: Effect) -> Result<(), Refusal> {
        let reaches = name.block_type != BlockType::DataBlock || self.reaches(VariableArea::DataBlock(name.number), effect);
        if reaches { Ok(()) } else { Err(Refusal::Protected) }
    }

    fn reaches(&self, area: VariableArea, effect: Effect) -> bool {
        self.allow.as_ref().is_none_or(|allowed| {
            allowed.iter().any(|one| holds(&one.scope, area) && (effect == Looks || one.access == Access::ReadAndWrite))
        })
    }
}

fn refuse_items<T>(items: &mut [Result<T, ItemCode>], reaches: impl Fn(&T) -> bool) {
    for item in items {
        if item.as_ref().is_ok_and(|found| !reaches(found)) {
            *item = Err(ItemCode::AccessRefused);
        }
    }
}

/// Whether an entry of an allow-list is about an area.
fn holds(scope: &Scope, area: VariableArea) -> bool {
    match (scope, area) {
        (Scope::Peripheral, VariableArea::Peripheral)
        | (Scope::Inputs, VariableArea::Input)
        | (Scope::Outputs, VariableArea::Output)
        | (Scope::BitMemory, VariableArea::BitMemory)
        | (Scope::Timers, VariableArea::Timer)
        | (Scope::Counters, VariableArea::Counter) => true,
        (Scope::DataBlocks(numbers), VariableArea::DataBlock(number)) => numbers.contains(&number),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::s7comm::job::{Assignment, BlockPlace, TransportSize, Variable};

    fn rules() -> Rules {
        Rules {
            cpu: &CpuType::ALL[0],
            protection: ProtectionLevel::Open,
            password: None,
            writing: Writing::Allowed,
            allow: None,
            strict: false,
            strict_slot: false,
        }
    }

    fn name(block_type: BlockType, number: u16) -> BlockName {
        BlockName { block_type, number, place: BlockPlace::Passive }
    }

    fn write(area: VariableArea) -> Job {
        let variable = Variable { area, size: TransportSize::Byte, count: 1, address: 0 };
        Job::Write(vec![Ok(Assignment { variable, bytes: Box::new([1]) })])
    }

    #[test]
    fn each_function_has_one_row_at_its_place() {
        for (index, function) in Function::all().enumerate() {
            assert_eq!(function as usize, index);
        }
    }

    #[test]
    fn protection_levels_refuse_what_they_protect_until_the_password_comes() {
        let levels = [ProtectionLevel::Open, ProtectionLevel::WriteProtected, ProtectionLevel::ReadWriteProtected];
        let refused = |legitimation| {
            levels.map(|protection| {
                let rules = Rules { protection, ..rules() };
                Function::all().filter(|&function| rules.judge_function(function, legitimation).is_err()).count()
            })
        };
        assert_eq!(refused(Legitimation::None), [0, 8, 9]);
        assert_eq!(refused(Legitimation::Password), [0, 0, 0]);
        let level_3 = Rules { protection: ProtectionLevel::ReadWriteProtected, ..rules() };
        assert_eq!(level_3.judge(&mut Job::Upload(name(BlockType::Function, 1)), Legitimation::None), Err(Refusal::Protected));
        let mut job = write(VariableArea::BitMemory);
        assert_eq!(level_3.judge(&mut job, Legitimation::None), Ok(()));
        assert_eq!(job, write(VariableArea::BitMemory));
    }

    #[test]
    fn read_only_refuses_every_change_also_with_the_password() {
        let rules = Rules { writing: Writing::ReadOnly, ..rules() };
        let mut job = write(VariableArea::DataBlock(1));
        assert_eq!(rules.judge(&mut job, Legitimation::Password), Ok(()));
        assert_eq!(job, Job::Write(vec![Err(ItemCode::AccessRefused)]));
        for mut job in [Job::Stop, Job::SetClock(sieben_cpu::DateAndTime::DEFAULT), Job::Compress, Job::Link(Vec::new())] {
            assert_eq!(rules.judge(&mut job, Legitimation::Password), Err(Refusal::Protected), "{job:?}");
        }
        assert_eq!(rules.judge(&mut Job::Clock, Legitimation::None), Ok(()));
    }

    #[test]
    fn an_allow_list_holds_for_variables_and_for_data_blocks_as_a_whole() {
        let allow = vec![
            Allowed { scope: Scope::DataBlocks(10..=19), access: Access::ReadAndWrite },
            Allowed { scope: Scope::DataBlocks(20..=29), access: Access::Read },
            Allowed { scope: Scope::BitMemory, access: Access::Read },
        ];
        let rules = Rules { allow: Some(allow), ..rules() };
        let reads = |area| {
            let mut job = Job::Read(vec![Ok(Variable { area, size: TransportSize::Byte, count: 1, address: 0 })]);
            rules.judge(&mut job, Legitimation::None).expect("items are refused one by one");
            matches!(job, Job::Read(items) if items[0].is_ok())
        };
        let writes = |area| {
            let mut job = write(area);
            rules.judge(&mut job, Legitimation::None).expect("items are refused one by one");
            matches!(job, Job::Write(items) if items[0].is_ok())
        };
        for (area, expected) in [
            (VariableArea::DataBlock(9), (false, false)),
            (VariableArea::DataBlock(10), (true, true)),
            (VariableArea::DataBlock(20), (true, false)),
            (VariableArea::BitMemory, (true, false)),
            (VariableArea::Output, (false, false)),
            (VariableArea::Timer, (false, false)),
        ] {
            assert_eq!((reads(area), writes(area)), expected, "{area:?}");
        }
        let judge = |mut job| rules.judge(&mut job, Legitimation::None).is_ok();
        assert!(judge(Job::Upload(name(BlockType::DataBlock, 20))));
        assert!(!judge(Job::Upload(name(BlockType::DataBlock, 30))));
        assert!(!judge(Job::Delete(vec![name(BlockType::DataBlock, 10), name(BlockType::DataBlock, 20)])));
        // What acts on all of the memory would go round it; the operating mode is a matter of the protection level.
        assert!(!judge(Job::MemoryReset) && !judge(Job::CopyRamToRom));
        assert!(judge(Job::Stop) && judge(Job::Start(Restart::Warm)));
    }

    #[test]
    fn a_strict_s7_300_has_no_cold_start() {
        let strict = Rules { strict: true, ..rules() };
        let judge = |rules: &Rules, restart| rules.judge(&mut Job::Start(restart), Legitimation::None);
        assert_eq!(judge(&strict, Restart::Cold), Err(Refusal::CannotPerform));
        assert_eq!(judge(&strict, Restart::Warm), Ok(()));
        assert_eq!(judge(&rules(), Restart::Cold), Ok(()));
        let cpu = CpuType::by_name("416-3").expect("a CPU type");
        assert_eq!(judge(&Rules { cpu, ..strict }, Restart::Cold), Ok(()));
    }
}
