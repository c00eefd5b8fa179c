//! Retentive data in a run: found, judged and restored at its start, kept after every scan, and what is said about it.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use sieben_cpu::retain::{Adoption, Refusal, Restored, data_blocks};
use sieben_cpu::{Cpu, DataLoss};
use sieben_model::problems::Problem;
use sieben_workspace::finding::{Finding, Texts};

use super::disk::{Disk, FOLDER, RealDisk, behind_links, foreign, with_ending};
use super::lock::NoLock;
use super::record::{self, Record};
use super::slots::{self, Contents, Slots};
use super::store::{Change, Store, synced_path};
use crate::failure::Failure;
use crate::output;
use crate::report;

/// The file in the folder of a project for what a run leaves there.
const FILE: &str = "retain.bin";
/// How often the data goes to the disk if the project does not say.
pub(crate) const SYNC: Duration = Duration::from_secs(1);

/// What the command line and the project say about retentive data.
#[derive(Clone, Debug)]
pub(crate) struct Choice {
    /// Where it is kept.
    pub(crate) file: PathBuf,
    /// Whether the user named the file.
    pub(crate) named: bool,
    /// How often it goes to the disk; 0 = before every release of outputs.
    pub(crate) sync: Duration,
    /// A file whose data is taken over as far as it fits, whatever program it is of.
    pub(crate) adopt: Option<PathBuf>,
    /// Memory reset: what is there is not taken back.
    pub(crate) reset: bool,
    /// Messages as JSON.
    pub(crate) json: bool,
}

impl Choice {
    /// The file of a project.
    pub(crate) fn project_file(folder: &Path) -> PathBuf {
        crate::paths::join(folder, &Path::new(FOLDER).join(FILE))
    }
}

/// The retentive data of a running CPU.
pub(crate) struct Retention {
    file: PathBuf,
    json: bool,
    store: Store<RealDisk>,
    restored: Option<Restored>,
}

impl Retention {
    /// Takes back what the last run kept and gets ready to keep what this one changes. The CPU has not started yet.
    pub(crate) fn open(choice: &Choice, cpu: &mut Cpu) -> Result<Self, Failure> {
        let path = &choice.file;
        if let Some((path, foreign)) = foreign(path) {
            let message = format!("retentive data is not kept in `{}`: {foreign}", path.display());
            let failure = Failure::usage(Problem::P8033, message);
            return Err(if choice.named { failure.help("name a plain file with `--retain`") } else { failure });
        }
        let disk = match RealDisk::locked(path) {
            Ok(disk) => disk,
            Err(NoLock::Taken) => {
                return Err(Failure::usage(Problem::P6031, format!("another run uses the retentive data in `{}`", path.display())));
            }
            Err(NoLock::Failed(error)) => {
                let message = format!("retentive data cannot be kept from other runs: {error}");
                warn(Problem::P8030, path, message, None, choice.json);
                RealDisk::default()
            }
        };
        let disk = Arc::new(disk);
        let found = Found::read(&*disk, path, choice.named)?;
        let mut sequence = found.newest().map_or(0, |record| record.sequence);
        let restored = match &choice.adopt {
            Some(source) => Some(adopt(source, Some(&choice.file), &*disk, cpu, choice.json)?),
            None if choice.reset => {
                cpu.memory_reset();
                None
            }
            None => found.restore(choice, &*disk, cpu)?,
        };
        if sequence > SEQUENCE_RENEWED {
            let record = found.newest().filter(|_| restored.is_some() && choice.adopt.is_none());
            sequence = renumber(&*disk, path, record).map_err(|error| crate::files::unwritable(path, &error))?;
        }
        let store = Store::new(&disk, path, choice.sync, sequence);
        Ok(Self { file: path.clone(), json: choice.json, store, restored })
    }

    /// Keeps what the last scan or startup has changed; called before the outputs of the scan are released.
    pub(crate) fn keep(&mut self, cpu: &mut Cpu) {
        let change = self.store.keep(cpu.retain_image(), Instant::now());
        self.tell(change, cpu);
    }

    /// Brings everything to the disk.
    pub(crate) fn close(&mut self, cpu: &mut Cpu) {
        self.keep(cpu);
        let change = self.store.close(Instant::now());
        self.tell(change, cpu);
    }

    fn tell(&self, change: Option<Change>, cpu: &mut Cpu) {
        match change {
            None => {}
            Some(Change::Failed(why)) => {
                cpu.backup_failed();
                warn(Problem::P8030, &self.file, format!("retentive data cannot be kept: {why}"), None, self.json);
            }
            Some(Change::MadeAgain(path)) => {
                let message = format!("`{}` was removed or replaced while the CPU was running; it is made again", path.display());
                warn(Problem::P8034, &self.file, message, None, self.json);
            }
            Some(Change::Works) => {
                cpu.backup_works();
                if !self.json {
                    output::message("Retentive data is kept again.\n");
                }
            }
        }
    }

    /// What a run in JSON says about it.
    pub(crate) fn json(&self) -> Value {
        json!({
            "file": self.file.display().to_string(),
            "restored_scan": self.restored.as_ref().map(|restored| restored.scan),
        })
    }
}

/// A warning that belongs to the file of the data.
fn warn(problem: Problem, file: &Path, message: String, help: Option<String>, json: bool) {
    let mut finding = Finding::file(problem, file.display().to_string(), message);
    finding.diagnostic.help = help;
    report::print(&[finding], &Texts::default(), json);
}

/// Takes over what fits of a file that the user names, for a run that keeps nothing.
pub(crate) fn adopt_only(source: &Path, cpu: &mut Cpu, json: bool) -> Result<(), Failure> {
    adopt(source, None, &RealDisk::default(), cpu, json).map(|_| ())
}

/// Takes over what fits of a file that the user names. That file stays what it is, unless it is the one that is written from now on.
fn adopt<D: Disk>(source: &Path, written: Option<&Path>, disk: &D, cpu: &mut Cpu, json: bool) -> Result<Restored, Failure> {
    let found = Found::read(disk, source, true)?;
    let nothing = |why: &str| Failure::usage(Problem::P6032, format!("there is {why} in `{}`", source.display()));
    let record = found.newest().ok_or_else(|| nothing("no retentive data"))?;
    let restored = cpu.restore(&record.image, Adoption::WhatFits).map_err(|_| nothing("only damaged retentive data"))?;
    if !restored.left_out.is_empty() {
        let kept = match written == Some(behind_links(source).as_path()) {
            true => set_aside_record(disk, source, record)?,
            false => source.display().to_string(),
        };
        let message = format!("{} could not be taken over from another program; all of it is in `{kept}`", data_blocks(&restored.left_out));
        warn(Problem::P8032, source, message, Some("nothing, if the program does not need it any more".to_owned()), json);
    }
    say_restored(&restored, source, false, json);
    Ok(restored)
}

fn say_restored(restored: &Restored, path: &Path, damaged: bool, json: bool) {
    if json {
        return;
    }
    let cut = if damaged { "; a write that was cut short is left out" } else { "" };
    let initial =
        if restored.initial.is_empty() { String::new() } else { format!("; {} with initial values", data_blocks(&restored.initial)) };
    output::message(&format!(
        "Retentive data of {} is restored: {}{initial} (`{}`){cut}.\n",
        scan(restored),
        contents(restored),
        path.display()
    ));
}

/// What the last run left.
pub(crate) struct Found {
    /// The bytes of the file that every scan writes and of the one that is synced, and what they mean.
    files: [Option<(PathBuf, Vec<u8>, Contents)>; 2],
}

impl Found {
    /// Reads both files. One that exists and cannot be read must not be replaced.
    pub(crate) fn read<D: Disk>(disk: &D, path: &Path, named: bool) -> Result<Self, Failure> {
        let read = |path: PathBuf| match disk.read(&path) {
            Ok(bytes) => {
                let contents = slots::read(&bytes);
                if named && contents == Contents::Foreign && !bytes.is_empty() {
                    let message = format!("`{}` is no file of retentive data", path.display());
                    return Err(Failure::usage(Problem::P6032, message).help("name another file, or remove this one if it is damaged"));
                }
                Ok(Some((path, bytes, contents)))
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(error) => {
                Err(Failure::usage(Problem::P6032, format!("the retentive data in `{}` cannot be read: {error}", path.display())))
            }
        };
        Ok(Self { files: [read(path.to_path_buf())?, read(synced_path(path))?] })
    }

    fn files(&self) -> impl Iterator<Item = &(PathBuf, Vec<u8>, Contents)> {
        self.files.iter().flatten()
    }

    /// The newest whole record of both files.
    pub(crate) fn newest(&self) -> Option<&Record> {
        self.files().filter_map(|(_, _, contents)| contents.newest()).max_by_key(|record| record.sequence)
    }

    /// Restores the newest record, says what became of it, and sets aside what is not restored.
    fn restore<D: Disk>(&self, choice: &Choice, disk: &D, cpu: &mut Cpu) -> Result<Option<Restored>, Failure> {
        let path = &choice.file;
        let damaged = self.files().any(|(_, _, contents)| contents.damaged());
        let Some(record) = self.newest() else {
            if !damaged {
                return Ok(None);
            }
            let lost = self.files().find(|(_, bytes, contents)| contents.damaged() && !bytes.is_empty());
            let (help, what) = match lost {
                Some((_, bytes, _)) => (
                    None,
                    format!("is damaged: the CPU starts with its initial values; the data is now in `{}`", set_aside(disk, path, bytes)?),
                ),
                // A run never leaves an empty file: somebody else does, or a disk that lost it.
                None => (
                    Some("check the disk; if you made the file yourself, nothing was lost".to_owned()),
                    "is empty: the CPU starts with its initial values".to_owned(),
                ),
            };
            cpu.retentive_data_lost(DataLoss::Damaged);
            warn(Problem::P8031, path, format!("the retentive data {what}"), help, choice.json);
            return Ok(None);
        };
        match cpu.restore(&record.image, Adoption::SameProgram) {
            Ok(restored) => {
                say_restored(&restored, path, damaged, choice.json);
                Ok(Some(restored))
            }
            Err(refusal) => {
                let old = set_aside_record(disk, path, record)?;
                let message = |why| {
                    format!("retentive data is not restored: {why}; the CPU starts with its initial values, and the data is now in `{old}`")
                };
                match &refusal {
                    Refusal::Damaged => warn(
                        Problem::P8031,
                        path,
                        message("it is damaged, or another version of Sieben wrote it".to_owned()),
                        None,
                        choice.json,
                    ),
                    Refusal::OtherProgram { .. } => {
                        let help = format!("run with `--adopt {old}` to take over what still fits");
                        warn(Problem::P8032, path, message(refusal.to_string()), Some(help), choice.json);
                    }
                }
                Ok(None)
            }
        }
    }
}

/// Numbers that no run reaches, with a record in every microsecond of 2,000 years: a file with a greater one was made by something else,
/// and the numbers begin anew before they end.
const SEQUENCE_RENEWED: u64 = 1 << 56;

/// Gives the newest record the first number, in both files: none of them is newer than it then. Without a record both are empty.
pub(super) fn renumber<D: Disk>(disk: &D, path: &Path, newest: Option<&Record>) -> io::Result<u64> {
    const FIRST: u64 = 1;
    let mut bytes = Vec::new();
    if let Some(record) = newest {
        record::write(&mut bytes, FIRST, &record.image);
    }
    // A kill between the two leaves the same image with the great number.
    for path in [path.to_path_buf(), synced_path(path)] {
        Slots::create(disk, &path, 0, &bytes)?;
    }
    Ok(FIRST)
}

/// Puts a record that this program cannot use into a file of its own.
fn set_aside_record<D: Disk>(disk: &D, path: &Path, record: &Record) -> Result<String, Failure> {
    let mut bytes = Vec::new();
    record::write(&mut bytes, record.sequence, &record.image);
    let old = with_ending(path, "old");
    Slots::create(disk, &old, 0, &bytes).map_err(|error| cannot_set_aside(&old, &error))?;
    Ok(old.display().to_string())
}

/// Puts bytes that cannot be read into a file of their own: somebody may find a use for them.
fn set_aside<D: Disk>(disk: &D, path: &Path, bytes: &[u8]) -> Result<String, Failure> {
    let old = with_ending(path, "old");
    disk.create(&old, bytes).map_err(|error| cannot_set_aside(&old, &error))?;
    Ok(old.display().to_string())
}

/// What cannot be set aside would be written over: the run does not begin.
fn cannot_set_aside(old: &Path, error: &io::Error) -> Failure {
    Failure::usage(Problem::P6013, format!("retentive data that this program cannot use was to be kept in `{}`: {error}", old.display()))
        .help("make room or correct the permissions, or run with --no-retain")
}

fn scan(restored: &Restored) -> String {
    match restored.scan {
        0 => "a startup".to_owned(),
        scan => format!("scan {scan}"),
    }
}

/// `16 bytes of M, 8 counters, DB 1`.
fn contents(restored: &Restored) -> String {
    let mut parts = Vec::new();
    for (count, one, many) in [
        (restored.bit_memory_bytes, "byte of M", "bytes of M"),
        (restored.timers, "timer", "timers"),
        (restored.counters, "counter", "counters"),
    ] {
        if count > 0 {
            parts.push(format!("{count} {}", if count == 1 { one } else { many }));
        }
    }
    if !restored.data_blocks.is_empty() {
        parts.push(data_blocks(&restored.data_blocks));
    }
    if parts.is_empty() { "nothing of this program".to_owned() } else { parts.join(", ") }
}
