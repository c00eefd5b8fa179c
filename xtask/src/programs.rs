//! Other people's programs: whether they are there, how they are installed, and how one runs to its end.

use std::fs::{self, File};
use std::io::{Read, Seek};
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use crate::workspace;

/// Seconds that a package client waits for its registry: a machine without a network shall say so soon.
pub const REGISTRY_SECONDS_MAX: u32 = 20;
/// Seconds that one step of an installation may take; a browser from the system's packages is the longest, with about 45.
const STEP_SECONDS_MAX: u64 = 300;

/// Whether a program is there and answers.
pub fn starts(program: &str) -> bool {
    version(program).is_some()
}

/// Where a program lies.
pub fn path_of(program: &str) -> Option<String> {
    let places = std::env::var_os("PATH")?;
    let path = std::env::split_paths(&places).map(|folder| folder.join(program)).find(|path| path.is_file())?;
    Some(path.to_string_lossy().into_owned())
}

/// The first line that a program says about its version.
pub fn version(program: &str) -> Option<String> {
    let output = Command::new(program).arg("--version").stdin(Stdio::null()).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).lines().next().unwrap_or_default().trim().to_owned();
    output.status.success().then_some(text)
}

/// A command of npm that asks its registry at most twice and says what failed, nothing else.
pub fn npm(verb: &str) -> Command {
    let mut command = Command::new("npm");
    let timeout = format!("--fetch-timeout={REGISTRY_SECONDS_MAX}000");
    command.args([
        verb,
        "--no-audit",
        "--no-fund",
        "--loglevel=error",
        "--fetch-retries=1",
        "--fetch-retry-mintimeout=1000",
        "--fetch-retry-maxtimeout=2000",
        &timeout,
    ]);
    command
}

/// Installs Debian's packages, where we may.
pub fn install_packages(packages: &[&str]) -> Result<(), String> {
    let by_hand = format!("`apt-get install {}` as root, or what your system has for it", packages.join(" "));
    if !rustix::process::geteuid().is_root() || !starts("apt-get") {
        return Err(by_hand);
    }
    let quiet = |arguments: &[&str]| {
        done(Command::new("apt-get").args(arguments).args(["-qq", "-o", "Acquire::Retries=1"]).env("DEBIAN_FRONTEND", "noninteractive"))
    };
    let wanted = [&["install", "--yes", "--no-install-recommends"], packages].concat();
    quiet(&["update"]).and_then(|()| quiet(&wanted)).map_err(|reason| format!("{reason}; {by_hand}"))
}

/// How a binary is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Build {
    /// Soon, with checks: for tests.
    Debug,
    /// As users have it: for measurements.
    Release,
}

/// The binary of Sieben: the one that is named, or a fresh one.
pub fn sieben(named: Option<&PathBuf>, build: Build) -> Result<PathBuf, String> {
    if let Some(binary) = named {
        return binary.canonicalize().map_err(|error| format!("cannot find {}: {error}", binary.display()));
    }
    let status = Command::new(crate::test::cargo())
        .args(["build", "-p", "sieben-app"])
        .args((build == Build::Release).then_some("--release"))
        .current_dir(workspace::root())
        .status()
        .map_err(|error| format!("cannot start cargo: {error}"))?;
    if !status.success() {
        return Err("the binary cannot be built".to_owned());
    }
    // Its folder is the one of this program, or the one beside it.
    let own = std::env::current_exe().map_err(|error| format!("cannot find myself: {error}"))?;
    let folders = own.parent().and_then(|folder| folder.parent()).ok_or("this program lies in no folder of cargo")?;
    let folder = if build == Build::Release { "release" } else { "debug" };
    Ok(folders.join(folder).join("sieben").with_extension(std::env::consts::EXE_EXTENSION))
}

/// Runs a command to its end; what failed is its last words.
pub fn done(command: &mut Command) -> Result<(), String> {
    let program = command.get_program().to_string_lossy().into_owned();
    let failed = |error: std::io::Error| error.to_string();
    // A file and no pipe: what the command starts may hold a pipe open after it.
    let mut said = tempfile().map_err(failed)?;
    let stderr = said.try_clone().map_err(failed)?;
    let child = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(stderr).spawn();
    let mut child = child.map_err(|error| format!("`{program}` does not start: {error}"))?;
    let begun = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().map_err(failed)? {
            break status;
        }
        if begun.elapsed() > Duration::from_secs(STEP_SECONDS_MAX) {
            child.kill().and_then(|()| child.wait()).map_err(failed)?;
            return Err(format!("`{program}` took more than {STEP_SECONDS_MAX} s"));
        }
        thread::sleep(Duration::from_millis(20));
    };
    if status.success() {
        return Ok(());
    }
    let mut words = Vec::new();
    said.rewind().and_then(|()| said.read_to_end(&mut words)).map_err(failed)?;
    let words = String::from_utf8_lossy(&words);
    // npm ends with where its log lies, pip with a word about itself.
    let last =
        words.lines().rev().map(str::trim).find(|line| !line.is_empty() && !line.contains("complete log") && !line.contains("[notice]"));
    Err(format!("`{program}` failed: {}", last.unwrap_or("it says nothing")))
}

/// A file without a name below `target/`.
fn tempfile() -> std::io::Result<File> {
    static NUMBER: AtomicUsize = AtomicUsize::new(0);
    let folder = workspace::root().join("target");
    fs::create_dir_all(&folder)?;
    let path = folder.join(format!(".said-{}-{}", std::process::id(), NUMBER.fetch_add(1, Ordering::Relaxed)));
    let file = File::options().read(true).write(true).create_new(true).open(&path)?;
    fs::remove_file(path)?;
    Ok(file)
}

/// Where a test that lacks a program leaves a file that says so: a test runner shows nothing of what passes.
pub fn skipped() -> PathBuf {
    workspace::root().join("target/skipped")
}

/// Notes that something is skipped, for the list at the end of `cargo xtask test`; with `SIEBEN_NO_SKIP=1` that is a failure.
pub fn skip(what: &str, reason: &str) -> Result<(), String> {
    let line = format!("skipped: {reason}");
    if std::env::var_os("SIEBEN_NO_SKIP").is_some_and(|value| value == "1") {
        return Err(line);
    }
    println!("{line}");
    let folder = skipped();
    fs::create_dir_all(&folder)
        .and_then(|()| fs::write(folder.join(what), format!("{line}\n")))
        .map_err(|error| format!("cannot write into {}: {error}", folder.display()))
}
