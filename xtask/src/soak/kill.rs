//! Kills a running `sieben run` again and again, and proves after each kill that the retentive data is one whole scan's
//! and that at most the running scan is lost.
//!
//! The program counts its scans and fills a data block of several pages with the count. Its startup compares every copy and goes
//! to STOP if one differs: a mix of two scans ends the run. What a run had counted when it was killed is read from its memory:
//! the next one has to begin with that count, or with the one before it.

use std::fs;
use std::io::BufRead;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

/// Copies of the count in the data block: more than two pages.
const COPIES: u32 = 2048;
/// Bytes that stand before the count in the data block, and before what the startup notes.
const COUNT_MARK: [u8; 8] = [0xC0, 0x17, 0x5A, 0x3E, 0x91, 0xB2, 0x0D, 0xF8];
const START_MARK: [u8; 8] = [0x57, 0xA2, 0x7E, 0xD1, 0x6C, 0x0B, 0x94, 0xE3];
/// A run that does not begin to count within this time hangs.
const START_MAX: Duration = Duration::from_secs(30);
/// Time between two looks at a run that has not begun to count.
const LOOK: Duration = Duration::from_millis(5);
/// Largest piece of memory of a run that is searched; the memory of a CPU is far smaller.
const REGION_BYTES_MAX: u64 = 64 << 20;

/// What came of the kills.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outcome {
    /// Kills.
    pub kills: u32,
    /// Kills of a run that had been stopped and looked at: nothing happened between the look and the kill.
    pub looked_at: u32,
    /// Of those, how often the running scan was lost.
    pub scans_lost: u32,
    /// Kills before the run had begun to count.
    pub early: u32,
    /// Scans of all runs together.
    pub scans: u32,
}

/// What the memory of a run says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Seen {
    /// The count of the newest scan, also one that is not whole.
    count: Option<u32>,
    /// The count that this run began with.
    start: Option<u32>,
}

/// Kills `kills` runs of the binary in a folder of its own, which is removed if all is well.
pub fn run(binary: &Path, folder: &Path, kills: u32, sync: &str, mut progress: impl FnMut(Outcome)) -> Result<Outcome, String> {
    if !Path::new("/proc/self/maps").exists() {
        return Err("the memory of another process can be read on Linux only".to_owned());
    }
    fs::create_dir_all(folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
    write(folder, "sieben.toml", &format!("[project]\nname = \"kill\"\n[cpu]\nwatchdog = \"6s\"\nretain = {{ sync = \"{sync}\" }}\n"))?;
    let mut outcome = Outcome::default();
    let mut random = Random(u64::from(std::process::id()) << 32 | 0x9E37_79B9);
    // The count that is safe, and the newest that any run may have kept.
    let (mut at_least, mut at_most) = (0, Some(0));
    for number in 1..=kills + 1 {
        write(folder, "main.awl", &program(number))?;
        let mut running = Running::start(binary, folder)?;
        // Every eighth kill comes before the run has begun; the last run is only looked at.
        let early = number % 8 == 0 && number <= kills;
        let seen = if early {
            std::thread::sleep(Duration::from_micros(random.below(15_000)));
            Seen::default()
        } else {
            let begun = running.wait_for_start(number)?;
            check(number, begun.start, at_least, at_most)?;
            outcome.scans_lost += u32::from(at_most.is_some() && at_most != begun.start);
            std::thread::sleep(Duration::from_micros(random.below(60_000)));
            begun
        };
        if number > kills {
            running.kill()?;
            break;
        }
        // Half of the kills hit a run that goes on to the last moment, and may tear a write.
        let stop = number % 2 == 0;
        if stop {
            running.stop()?;
        }
        let last = running.look(number)?;
        running.kill()?;
        outcome.kills += 1;
        outcome.looked_at += u32::from(stop);
        if let (Some(start), true) = (last.start, early) {
            check(number, Some(start), at_least, at_most)?;
            outcome.scans_lost += u32::from(at_most.is_some_and(|at_most| at_most != start));
        }
        match (last.count, last.start.or(seen.start)) {
            (Some(count), Some(start)) => {
                outcome.scans += count - start;
                // What the next run begins with: the scan that ran when the kill came may be lost, no other.
                at_least = count.saturating_sub(1);
                at_most = stop.then_some(count);
            }
            _ => {
                outcome.early += 1;
                at_most = None;
            }
        }
        progress(outcome);
    }
    fs::remove_dir_all(folder).map_err(|error| format!("cannot remove {}: {error}", folder.display()))?;
    Ok(outcome)
}

/// Whether a run began with what the one before it had counted.
fn check(number: u32, start: Option<u32>, at_least: u32, at_most: Option<u32>) -> Result<(), String> {
    let Some(start) = start else { return Err(format!("run {number} did not note what it began with")) };
    if start < at_least {
        return Err(format!("run {number} began with {start}, but {at_least} scans were whole: {} are lost", at_least - start));
    }
    match at_most {
        Some(at_most) if start > at_most => Err(format!("run {number} began with {start}, but only {at_most} scans had begun")),
        _ => Ok(()),
    }
}

fn write(folder: &Path, name: &str, text: &str) -> Result<(), String> {
    fs::write(folder.join(name), text).map_err(|error| format!("cannot write {name}: {error}"))
}

/// The counting program; the number of the run stands in its startup, so that old memory is not taken for new.
fn program(number: u32) -> String {
    let words =
        |mark: [u8; 8]| mark.chunks(4).map(|four| four.iter().map(|byte| format!("{byte:02X}")).collect::<String>()).collect::<Vec<_>>();
    let (count, start) = (words(COUNT_MARK), words(START_MARK));
    format!(
        "DATA_BLOCK DB 1
STRUCT
 count_mark : ARRAY [1..2] OF DWORD;
 count : DINT;
 start_mark : ARRAY [1..2] OF DWORD;
 run : DINT;
 start : DINT;
 copies : ARRAY [1..{COPIES}] OF DINT;
END_STRUCT
BEGIN
END_DATA_BLOCK

ORGANIZATION_BLOCK OB 100
BEGIN
      L     DB1.DBD 8;
      L     MD 0;
      <>D   ;
      JC    bad;
      L     P#28.0;
      T     MD 200;
      L     {COPIES};
next: T     MW 204;
      OPN   DB 1;
      L     DBD [MD 200];
      L     DBD 8;
      <>D   ;
      JC    bad;
      L     MD 200;
      L     P#4.0;
      +D    ;
      T     MD 200;
      L     MW 204;
      LOOP  next;
      L     DW#16#{c0};
      T     DB1.DBD 0;
      L     DW#16#{c1};
      T     DB1.DBD 4;
      L     L#{number};
      T     DB1.DBD 20;
      L     DB1.DBD 8;
      T     DB1.DBD 24;
      L     DW#16#{s0};
      T     DB1.DBD 12;
      L     DW#16#{s1};
      T     DB1.DBD 16;
      BEU   ;
bad:  CALL  SFC 46;
END_ORGANIZATION_BLOCK

ORGANIZATION_BLOCK OB 1
VAR_TEMP
 info : ARRAY [1..20] OF BYTE;
END_VAR
BEGIN
      L     DB1.DBD 8;
      L     L#1;
      +D    ;
      T     DB1.DBD 8;
      T     MD 0;
      CALL  SFC 21 (BVAL := P#DB1.DBX 8.0 BYTE 4, RET_VAL := MW 210, BLK := P#DB1.DBX 28.0 BYTE {bytes});
END_ORGANIZATION_BLOCK
",
        c0 = count[0],
        c1 = count[1],
        s0 = start[0],
        s1 = start[1],
        bytes = COPIES * 4,
    )
}

/// A run, killed when it is dropped.
struct Running {
    child: Child,
    messages: PathBuf,
}

impl Running {
    fn start(binary: &Path, folder: &Path) -> Result<Self, String> {
        let messages = folder.join("messages.txt");
        let file = fs::File::create(&messages).map_err(|error| format!("cannot write {}: {error}", messages.display()))?;
        let child = Command::new(binary)
            .args(["run", ".", "--cycle", "1ms", "--engine", "interpreter"])
            .current_dir(folder)
            // Its messages are read, which are English so.
            .env("LC_ALL", "C")
            // Its allocator makes memory readable as it is needed, so that there is little to search.
            .env("MIMALLOC_ARENA_EAGER_COMMIT", "0")
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(file)
            .spawn()
            .map_err(|error| format!("cannot start {}: {error}", binary.display()))?;
        Ok(Self { child, messages })
    }

    /// Waits until the startup of this run has noted what it began with.
    fn wait_for_start(&mut self, number: u32) -> Result<Seen, String> {
        let began = Instant::now();
        loop {
            let seen = self.look(number)?;
            if seen.start.is_some() {
                return Ok(seen);
            }
            if began.elapsed() > START_MAX {
                return Err(format!("run {number} does not begin to count\n{}", self.said()));
            }
            std::thread::sleep(LOOK);
        }
    }

    /// Searches the memory of the run for the marks.
    fn look(&mut self, number: u32) -> Result<Seen, String> {
        if let Some(status) = self.child.try_wait().map_err(|error| error.to_string())? {
            return Err(self.ended(number, status));
        }
        let mut seen = Seen::default();
        for (mut at, end) in regions(self.child.id()) {
            let mut bytes = Vec::new();
            if end - at <= REGION_BYTES_MAX && read_memory(self.child.id(), &mut at, end, &mut bytes).is_ok() {
                seen.take(&bytes, number);
            }
        }
        Ok(seen)
    }

    fn ended(&self, number: u32, status: ExitStatus) -> String {
        format!("run {number} ended by itself ({status}): its data is not one whole scan's, or it could not start\n{}", self.said())
    }

    fn said(&self) -> String {
        fs::read_to_string(&self.messages).unwrap_or_default()
    }

    /// Lets the run stand still.
    fn stop(&self) -> Result<(), String> {
        let status = Command::new("kill").args(["-STOP", &self.child.id().to_string()]).status().map_err(|error| error.to_string())?;
        if status.success() { Ok(()) } else { Err(format!("kill -STOP: {status}")) }
    }

    /// kill -9.
    fn kill(mut self) -> Result<(), String> {
        self.child.kill().and_then(|()| self.child.wait()).map_err(|error| error.to_string())?;
        Ok(())
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // One that has ended already cannot be killed.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Seen {
    /// The highest count behind a mark; older ones are copies on their way to a file.
    fn take(&mut self, bytes: &[u8], number: u32) {
        let word = |at: usize| bytes.get(at..at + 4).map(|four| four.iter().fold(0, |word: u32, &byte| word << 8 | u32::from(byte)));
        for at in positions(bytes, &COUNT_MARK) {
            self.count = self.count.max(word(at + 8));
        }
        for at in positions(bytes, &START_MARK) {
            if word(at + 8) == Some(number) {
                self.start = word(at + 12);
            }
        }
    }
}

/// Where a mark stands in memory: data blocks and their double words lie at multiples of 4. What searches for its first byte is fast without
/// optimization, too.
fn positions<'a>(bytes: &'a [u8], mark: &'a [u8]) -> impl Iterator<Item = usize> + 'a {
    let mut rest = bytes;
    std::iter::from_fn(move || {
        while rest.skip_until(mark[0]).is_ok_and(|skipped| skipped > 0) {
            let at = bytes.len() - rest.len() - 1;
            if at.is_multiple_of(4) && bytes[at..].starts_with(mark) {
                return Some(at);
            }
        }
        None
    })
}

/// The memory that a process can write.
fn regions(process: u32) -> Vec<(u64, u64)> {
    let maps = fs::read_to_string(format!("/proc/{process}/maps")).unwrap_or_default();
    let region = |line: &str| {
        let (range, rest) = line.split_once(' ')?;
        let (start, end) = range.split_once('-')?;
        let number = |text: &str| u64::from_str_radix(text, 16).ok();
        rest.starts_with("rw").then_some((number(start)?, number(end)?))
    };
    maps.lines().filter_map(region).collect()
}

/// Reads what is there of a region.
fn read_memory(process: u32, at: &mut u64, end: u64, bytes: &mut Vec<u8>) -> std::io::Result<()> {
    use std::io::{Read, Seek, SeekFrom};
    let mut memory = fs::File::open(format!("/proc/{process}/mem"))?;
    memory.seek(SeekFrom::Start(*at))?;
    memory.take(end - *at).read_to_end(bytes)?;
    Ok(())
}

/// SplitMix64.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        (z ^ (z >> 31)) % limit
    }
}
