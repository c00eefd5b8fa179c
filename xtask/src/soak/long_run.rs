//! Runs a program for a long time and watches the memory of the process: it may not grow.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// Time between two looks.
const LOOK: Duration = Duration::from_millis(500);
/// What an allocator may take more after the beginning, in KiB: its pages come in pieces.
const GROWTH_KIB_MAX: u64 = 1024;

/// A program that uses what could leak: errors for the diagnostic buffer, created data blocks, timers, calls, retentive data.
const PROGRAM: &str = "DATA_BLOCK DB 1
STRUCT
 n : DINT;
 copies : ARRAY [1..2000] OF DINT;
END_STRUCT
BEGIN
END_DATA_BLOCK

FUNCTION FC 1 : VOID
VAR_INPUT
 x : DINT;
END_VAR
VAR_TEMP
 t : DINT;
END_VAR
BEGIN
      L     #x;
      T     #t;
      L     DB1.DBD 0;
      L     L#1;
      +D    ;
      T     DB1.DBD 0;
END_FUNCTION

ORGANIZATION_BLOCK OB 121
BEGIN
      L     MW 20;
      +     1;
      T     MW 20;
END_ORGANIZATION_BLOCK

ORGANIZATION_BLOCK OB 1
BEGIN
      CALL  FC 1 (x := L#5);
      CALL  SFC 21 (BVAL := P#DB1.DBX 0.0 BYTE 4, RET_VAL := MW 30, BLK := P#DB1.DBX 4.0 BYTE 8000);
      CALL  SFC 22 (LOW_LIMIT := W#16#64, UP_LIMIT := W#16#74, COUNT := 100, RET_VAL := MW 32, DB_NUMBER := MW 34);
      L     MW 32;
      L     0;
      ==I   ;
      JC    more;
      L     100;
      T     MW 36;
next: CALL  SFC 23 (DB_NUMBER := MW 36, RET_VAL := MW 32);
      L     MW 36;
      +     1;
      T     MW 36;
      L     116;
      <=I   ;
      JC    next;
more: L     B#16#88;
      L     DW#16#88000000;
      LAR1  ;
      L     B [AR1,P#0.0];
      AN    T 1;
      L     S5T#50MS;
      SE    T 1;
END_ORGANIZATION_BLOCK
";

/// Runs the binary for so long.
pub(super) fn run(binary: &Path, folder: &Path, time: Duration) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
    for (name, text) in [("sieben.toml", "[cpu]\nwatchdog = \"6s\"\n"), ("main.awl", PROGRAM)] {
        fs::write(folder.join(name), text).map_err(|error| format!("cannot write {name}: {error}"))?;
    }
    let messages = folder.join("messages.txt");
    let file = fs::File::create(&messages).map_err(|error| format!("cannot write {}: {error}", messages.display()))?;
    let mut child = Command::new(binary)
        .args(["run", ".", "--cycle", "1ms"])
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(file)
        .spawn()
        .map_err(|error| format!("cannot start {}: {error}", binary.display()))?;
    let watched = watch(&mut child, time);
    // One that has ended already cannot be killed.
    let _ = child.kill();
    let _ = child.wait();
    let outcome = watched.map_err(|error| format!("{error}\n{}", fs::read_to_string(&messages).unwrap_or_default()));
    fs::remove_dir_all(folder).map_err(|error| format!("cannot remove {}: {error}", folder.display()))?;
    outcome
}

fn watch(child: &mut Child, time: Duration) -> Result<(), String> {
    let began = Instant::now();
    // Until then caches fill and files are made.
    let warm_up = (time / 10).max(Duration::from_secs(2));
    let (mut first, mut most) = (None, 0);
    while began.elapsed() < time.max(warm_up * 2) {
        std::thread::sleep(LOOK);
        if let Some(status) = child.try_wait().map_err(|error| error.to_string())? {
            return Err(format!("the run ended by itself after {:.0} s ({status})", began.elapsed().as_secs_f64()));
        }
        let resident = resident_kib(child.id()).ok_or("the memory of a process can be looked at on Linux only")?;
        if began.elapsed() >= warm_up {
            first = first.or(Some(resident));
            most = most.max(resident);
        }
    }
    let first = first.ok_or("no look was taken")?;
    println!(
        "soak run: {:.0} s, {first} KiB after {:.0} s, {most} KiB at most later",
        began.elapsed().as_secs_f64(),
        warm_up.as_secs_f64()
    );
    if most <= first + GROWTH_KIB_MAX { Ok(()) } else { Err(format!("the memory of the run grows: from {first} to {most} KiB")) }
}

/// What the process holds in memory.
fn resident_kib(process: u32) -> Option<u64> {
    let status = fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?.split_whitespace().next()?.parse().ok()
}
