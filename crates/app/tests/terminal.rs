//! The screens on a terminal that goes away: whoever draws on it ends, even if no signal says so.
#![cfg(unix)]

mod command;

use std::fs::File;
use std::os::fd::OwnedFd;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc;
use std::time::Duration;

use command::Folder;
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::{Mode, OFlags, open};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{Winsize, tcsetwinsize};

/// A program that has not drawn or ended by then never will.
const DEADLINE: Duration = Duration::from_secs(30);

/// A pseudo-terminal: what a window holds, and what a program in it gets.
fn terminal() -> (OwnedFd, OwnedFd) {
    // A program that inherits the window would keep it open.
    let window = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC).expect("a pseudo-terminal");
    grantpt(&window).expect("it is ours");
    unlockpt(&window).expect("it can be opened");
    let size = Winsize { ws_row: 24, ws_col: 80, ws_xpixel: 0, ws_ypixel: 0 };
    tcsetwinsize(&window, size).expect("it has a size");
    let path = ptsname(&window, Vec::new()).expect("it has a name");
    let inside = open(path.as_c_str(), OFlags::RDWR | OFlags::NOCTTY, Mode::empty()).expect("it can be opened");
    (window, inside)
}

fn start(folder: &Folder, arguments: &[&str], inside: OwnedFd) -> Child {
    let stdio = || Stdio::from(File::from(inside.try_clone().expect("one more handle")));
    let mut command = Command::new(env!("CARGO_BIN_EXE_sieben"));
    command.args(arguments).current_dir(folder.path()).env("TERM", "xterm-256color");
    command.stdin(stdio()).stdout(stdio()).stderr(stdio()).spawn().expect("sieben runs")
}

/// How a program ends, which it must do before the deadline.
fn end(mut child: Child) -> ExitStatus {
    let (sender, receiver) = mpsc::channel();
    let id = rustix::process::Pid::from_child(&child);
    std::thread::spawn(move || sender.send(child.wait()));
    match receiver.recv_timeout(DEADLINE) {
        Ok(status) => status.expect("a status"),
        Err(_) => {
            let _ = rustix::process::kill_process(id, rustix::process::Signal::KILL);
            panic!("sieben does not end when its terminal has gone");
        }
    }
}

fn ends_with_its_terminal(arguments: &[&str]) {
    let folder = Folder::with(&[("main.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nA I 0.0\n= Q 4.0\nEND_ORGANIZATION_BLOCK\n")]);
    let (window, inside) = terminal();
    let child = start(&folder, arguments, inside);
    let wait = Timespec { tv_sec: DEADLINE.as_secs().cast_signed(), tv_nsec: 0 };
    let drawn = poll(&mut [PollFd::new(&window, PollFlags::IN)], Some(&wait));
    assert_eq!(drawn, Ok(1), "sieben draws");
    drop(window);
    // It may have been drawing at this very moment, which is an error of the terminal.
    let status = end(child);
    assert!(matches!(status.code(), Some(0 | 2)), "{status}");
}

#[test]
fn the_microscope_ends_with_its_terminal() {
    ends_with_its_terminal(&["step", "main.awl"]);
}

#[test]
fn the_demo_ends_with_its_terminal() {
    ends_with_its_terminal(&["demo"]);
}
