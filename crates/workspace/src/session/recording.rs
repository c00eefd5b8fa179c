//! A run as a file: the program it belongs to and what came from outside. Virtual time makes the rest come again.

use sieben_cpu::Restart;
use sieben_engine::Program;
use sieben_sim::duration::CYCLE_MAX;
use sieben_sim::history::{Action, History};
use sieben_sim::names::{Name, Setting};

use super::Session;
use crate::project::Build;

/// The first line of a recording.
const HEAD: &str = "sieben recording 1";
/// Actions of a recording at most.
const ACTIONS_MAX: u64 = 2_000_000;
/// Bytes of a recording at most.
pub const BYTES_MAX: u64 = 64 << 20;

/// Why a recording is of no use.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unusable {
    /// It belongs to another program, or to another CPU type.
    OtherProgram,
    /// A line is not understood: its number from 1, and why.
    Line(usize, String),
}

/// A number for a program on a CPU type: another one is another program, as far as a run can tell.
///
/// FNV-1a over the code and the values of data blocks as they are printed for debugging: it is the same on every machine, and a new version
/// of Sieben that compiles otherwise has other numbers, as it should.
pub fn fingerprint(build: &Build) -> u64 {
    struct Hasher(u64);
    impl std::fmt::Write for Hasher {
        fn write_str(&mut self, text: &str) -> std::fmt::Result {
            for byte in text.bytes() {
                self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3);
            }
            Ok(())
        }
    }
    let mut hasher = Hasher(0xCBF2_9CE4_8422_2325);
    let Program { code, data, .. } = &build.compiled.program;
    use std::fmt::Write;
    // Writing into a number cannot fail.
    let _ = write!(hasher, "{}", build.cpu.name);
    for (id, block) in code {
        let _ = write!(hasher, "{id} {:?} {} {:?}", block.code, block.local_size, block.interface);
    }
    for (number, block) in data {
        let _ = write!(hasher, "{number} {:?} {} {}", block.image, block.read_only, block.non_retain);
    }
    let _ = write!(hasher, "{:?}", build.project.settings.modules);
    hasher.0
}

/// The recording of a run from its beginning to where it stands, as text. `None` if its beginning is forgotten.
pub fn write(session: &Session) -> Option<String> {
    let history: &History = session.history();
    if !history.is_whole() {
        return None;
    }
    let mut text = format!("{HEAD}\nprogram {:016x} on {}\n", fingerprint(session.build()), session.build().cpu.name);
    let mut scans: Option<Scans> = None;
    for (action, at, inside) in history.actions().take(history.position().actions) {
        if let (Action::Scan { now_us }, Some(run)) = (action, &mut scans)
            && run.goes_on(*now_us)
        {
            continue;
        }
        if let Some(run) = scans.take() {
            text.push_str(&run.text());
        }
        match action {
            Action::Scan { now_us } => scans = Some(Scans { first_us: *now_us, step_us: 0, count: 1 }),
            Action::Restart(restart) => text.push_str(&format!("restart {}\n", restart.word())),
            Action::Set(set) if inside => text.push_str(&format!("set @{at} {}={}\n", set.name.full_text(), set.text)),
            Action::Set(set) => text.push_str(&format!("set {}={}\n", set.name.full_text(), set.text)),
        }
    }
    if let Some(run) = scans {
        text.push_str(&run.text());
    }
    text.push_str(&format!("end {}\n", history.position().statements));
    Some(text)
}

/// Scans in equal distances, one line of a recording.
struct Scans {
    first_us: u64,
    step_us: u64,
    count: u64,
}

impl Scans {
    fn goes_on(&mut self, now_us: u64) -> bool {
        let step = now_us.wrapping_sub(self.first_us + self.step_us * (self.count - 1));
        if self.count == 1 && now_us >= self.first_us {
            self.step_us = step;
        } else if step != self.step_us {
            return false;
        }
        self.count += 1;
        true
    }

    fn text(&self) -> String {
        format!("scan {} {} {}\n", self.first_us, self.step_us, self.count)
    }
}

/// What a recording says: what came from outside, and where the run ends, in statements.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// Action, statements before it if it came inside a scan.
    pub actions: Vec<(Action, Option<u64>)>,
    /// Statements of the run.
    pub end: u64,
}

/// Reads a recording of a program; `parse` reads names.
///
/// # Errors
/// It is another program's, or a line is not understood.
pub fn read(text: &str, build: &Build, parse: impl Fn(&str) -> Result<Name, String>) -> Result<Recording, Unusable> {
    let mut lines = (1..).zip(text.lines());
    let wrong = |line: usize, message: &str| Unusable::Line(line, message.to_owned());
    if lines.next().is_none_or(|(_, line)| line.trim() != HEAD) {
        return Err(wrong(1, &format!("a recording begins with `{HEAD}`")));
    }
    let program = lines.next().and_then(|(_, line)| line.strip_prefix("program ")).and_then(|rest| rest.split(' ').next());
    let program = program.and_then(|hash| u64::from_str_radix(hash, 16).ok()).ok_or_else(|| wrong(2, "the program is missing"))?;
    if program != fingerprint(build) {
        return Err(Unusable::OtherProgram);
    }
    let mut actions: Vec<(Action, Option<u64>)> = Vec::new();
    let mut count = 0_u64;
    let mut last_us = 0;
    for (number, line) in lines {
        let (word, rest) = line.trim().split_once(' ').unwrap_or((line.trim(), ""));
        match word {
            "" => {}
            "end" => {
                let end = rest.parse().map_err(|_| wrong(number, "`end` needs the number of statements"))?;
                return Ok(Recording { actions, end });
            }
            "restart" => {
                let restart = Restart::ALL.into_iter().find(|one| one.word() == rest);
                let restart = restart.ok_or_else(|| wrong(number, "`restart` is cold, warm or hot"))?;
                actions.push((Action::Restart(restart), None));
            }
            "scan" => {
                let numbers: Vec<u64> = rest.split(' ').filter_map(|word| word.parse().ok()).collect();
                let &[first, step, times] = &numbers[..] else { return Err(wrong(number, "`scan` needs first, distance and count")) };
                count = count.saturating_add(times);
                if count > ACTIONS_MAX {
                    return Err(wrong(number, &format!("a recording has at most {ACTIONS_MAX} scans")));
                }
                let longest = u64::try_from(CYCLE_MAX.as_micros()).unwrap_or(u64::MAX);
                if first.saturating_sub(last_us) > longest || times > 1 && step > longest {
                    return Err(wrong(number, "two scans are 24 hours apart at most"));
                }
                last_us = first.saturating_add(step.saturating_mul(times.saturating_sub(1)));
                let at = |index: u64| first.saturating_add(step.saturating_mul(index));
                actions.extend((0..times).map(|index| (Action::Scan { now_us: at(index) }, None)));
            }
            "set" => {
                let (at, assignment) = match rest.strip_prefix('@').and_then(|rest| rest.split_once(' ')) {
                    Some((at, rest)) => (Some(at.parse().map_err(|_| wrong(number, "`@` is followed by a number of statements"))?), rest),
                    None => (None, rest),
                };
                let (name, value) = crate::names::split_assignment(assignment).map_err(|refusal| wrong(number, &refusal.message))?;
                let name = parse(name).map_err(|message| wrong(number, &message))?;
                let setting = Setting::new(name, value).map_err(|error| wrong(number, &error.to_string()))?;
                actions.push((Action::Set(setting), at));
            }
            _ => return Err(wrong(number, &format!("`{word}` is none of restart, scan, set and end"))),
        }
    }
    Err(wrong(text.lines().count() + 1, "the recording breaks off before `end`"))
}
