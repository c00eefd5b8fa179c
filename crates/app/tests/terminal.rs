//! The screens on a terminal: what keys do there, and that a program that draws on it ends with it, even if no signal says so.
#![cfg(unix)]

mod command;

use std::fs::File;
use std::io::{BufRead, BufReader, Read, Write};
use std::os::fd::OwnedFd;
use std::os::unix::net::UnixStream;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use command::{Folder, sieben};
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::{Mode, OFlags, open};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{Winsize, tcsetwinsize};

/// How long nothing moves when all that was asked for has been done.
const STILL: Duration = Duration::from_millis(300);
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
    start_as(folder, arguments, inside, "xterm-256color")
}

/// The same on a terminal that calls itself something else; an empty name is none.
fn start_as(folder: &Folder, arguments: &[&str], inside: OwnedFd, term: &str) -> Child {
    let stdio = || Stdio::from(File::from(inside.try_clone().expect("one more handle")));
    let mut command = Command::new(env!("CARGO_BIN_EXE_sieben"));
    command.args(arguments).current_dir(folder.path()).env("TERM", term).env("LC_ALL", "C").env("XDG_RUNTIME_DIR", folder.path());
    if term.is_empty() {
        command.env_remove("TERM");
    }
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

fn folder() -> Folder {
    let program = "ORGANIZATION_BLOCK OB 1\nBEGIN\nA I 0.0\n= Q 4.0\nEND_ORGANIZATION_BLOCK\n";
    Folder::with(&[("sieben.toml", "[project]\nname = \"lamp\"\n"), ("main.awl", program)])
}

/// Waits until a program draws, or has something to say.
fn drawn(window: &OwnedFd) {
    let wait = Timespec { tv_sec: DEADLINE.as_secs().cast_signed(), tv_nsec: 0 };
    let drawn = poll(&mut [PollFd::new(window, PollFlags::IN)], Some(&wait));
    assert_eq!(drawn, Ok(1), "sieben draws");
}

fn ends_with_its_terminal(folder: &Folder, arguments: &[&str]) {
    let (window, inside) = terminal();
    let child = start(folder, arguments, inside);
    drawn(&window);
    drop(window);
    // It may have been drawing at this very moment, which is an error of the terminal.
    let status = end(child);
    assert!(matches!(status.code(), Some(0 | 2)), "{status}");
}

#[test]
fn the_microscope_ends_with_its_terminal() {
    ends_with_its_terminal(&folder(), &["step", "main.awl"]);
}

#[test]
fn the_demo_ends_with_its_terminal() {
    ends_with_its_terminal(&folder(), &["demo"]);
}

/// A run of the project in a folder, which answers already.
fn running(folder: &Folder) -> Child {
    let mut run = sieben(folder.path(), &["run"]);
    let mut run = run.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("sieben runs");
    let socket = folder.path().join(".sieben/control.sock");
    let end = Instant::now() + DEADLINE;
    while UnixStream::connect(&socket).is_err() {
        assert!(run.try_wait().expect("a status").is_none() && Instant::now() < end, "the run answers");
        std::thread::sleep(Duration::from_millis(5));
    }
    run
}

fn interrupt(child: &Child) {
    let _ = rustix::process::kill_process(rustix::process::Pid::from_child(child), rustix::process::Signal::INT);
}

#[test]
fn top_ends_with_its_terminal() {
    let folder = folder();
    let run = running(&folder);
    ends_with_its_terminal(&folder, &["top"]);
    interrupt(&run);
    assert_eq!(end(run).code(), Some(0), "the run goes on without it");
}

/// What a terminal shows that has got these characters: places and text, which is all that a screen sends beside colours.
fn picture(drawn: &str, columns: usize, rows: usize) -> Vec<String> {
    let mut cells = vec![vec![' '; columns]; rows];
    let (mut row, mut column) = (0, 0);
    let mut characters = drawn.chars();
    while let Some(character) = characters.next() {
        match character {
            '\u{1b}' => {
                let mut sequence = String::new();
                let end = characters.by_ref().skip(1).find(|character| {
                    sequence.push(*character);
                    character.is_ascii_alphabetic()
                });
                let numbers: Vec<usize> =
                    sequence.trim_end_matches(char::is_alphabetic).split(';').filter_map(|one| one.parse().ok()).collect();
                match (end, numbers.as_slice()) {
                    (Some('H'), [down, right]) => (row, column) = (down.saturating_sub(1), right.saturating_sub(1)),
                    (Some('J'), _) => cells.iter_mut().for_each(|row| row.fill(' ')),
                    _ => {}
                }
            }
            character if !character.is_control() => {
                if let Some(cell) = cells.get_mut(row).and_then(|cells| cells.get_mut(column)) {
                    *cell = character;
                }
                column += 1;
            }
            _ => {}
        }
    }
    cells.into_iter().map(String::from_iter).collect()
}

/// A window in which a program draws, and all that it has drawn.
struct Window {
    file: File,
    drawn: mpsc::Receiver<String>,
    seen: String,
}

impl Window {
    fn of(window: OwnedFd) -> Self {
        let mut read = File::from(window.try_clone().expect("one more handle"));
        let (sender, drawn) = mpsc::channel();
        std::thread::spawn(move || {
            let mut chunk = [0; 4096];
            // A terminal that no program uses any more cannot be read.
            while let Ok(count @ 1..) = read.read(&mut chunk) {
                if sender.send(String::from_utf8_lossy(&chunk[..count]).into_owned()).is_err() {
                    return;
                }
            }
        });
        Self { file: File::from(window), drawn, seen: String::new() }
    }

    /// Waits until this is drawn after all that was waited for. One word: spaces that are there already are not drawn.
    fn shows(&mut self, word: &str) {
        let until = Instant::now() + DEADLINE;
        let mut from = self.seen.len();
        while !self.seen[from..].contains(word) {
            assert!(Instant::now() < until, "{word}: {:?}", self.seen);
            self.seen.push_str(&self.drawn.recv_timeout(DEADLINE).unwrap_or_else(|_| panic!("{word}: {:?}", self.seen)));
            // What is drawn may come in two parts.
            from = from.min(self.seen.len());
        }
    }

    /// Waits until the picture is as it should be; what it looks like then.
    fn looks(&mut self, columns: usize, rows: usize, wanted: impl Fn(&[String]) -> bool) -> Vec<String> {
        let until = Instant::now() + DEADLINE;
        loop {
            let picture = picture(&self.seen, columns, rows);
            if wanted(&picture) {
                return picture;
            }
            assert!(Instant::now() < until, "{}", picture.join("\n"));
            self.seen.push_str(&self.drawn.recv_timeout(DEADLINE).unwrap_or_else(|_| panic!("{}", picture.join("\n"))));
        }
    }

    fn press(&mut self, keys: &str) {
        self.file.write_all(keys.as_bytes()).expect("the terminal takes keys");
    }

    /// All that was printed, to the end.
    fn printed(mut self) -> String {
        while let Ok(more) = self.drawn.recv_timeout(DEADLINE) {
            self.seen.push_str(&more);
        }
        self.seen
    }

    /// What was drawn, and what was printed after the terminal was given back.
    fn left(mut self) -> (String, String) {
        while let Ok(more) = self.drawn.recv_timeout(DEADLINE) {
            self.seen.push_str(&more);
        }
        let (screen, after) = self.seen.rsplit_once("\u{1b}[?1049l").unwrap_or_else(|| panic!("the other screen is left: {:?}", self.seen));
        (screen.to_owned(), after.to_owned())
    }
}

#[test]
fn top_ends_with_the_run_and_gives_the_terminal_back() {
    let folder = folder();
    let run = running(&folder);
    let (window, inside) = terminal();
    let top = start(&folder, &["top"], inside);
    let mut window = Window::of(window);
    window.shows("Inputs");
    interrupt(&run);
    assert_eq!(end(run).code(), Some(0));
    assert_eq!(end(top).code(), Some(0));
    let (screen, after) = window.left();
    assert!(screen.contains("lamp") && after.contains("The run is over."), "{screen:?} {after:?}");
}

/// Asks a run at its socket.
fn asked(socket: &std::path::Path, request: &str) -> String {
    let mut stream = UnixStream::connect(socket).expect("the run answers");
    writeln!(stream, "{request}").expect("the run reads");
    let mut answer = String::new();
    BufReader::new(stream).read_line(&mut answer).expect("the run answers");
    answer
}

/// Asks the demo whose socket lies in a folder.
fn ask(folder: &Folder, request: &str) -> String {
    let until = Instant::now() + DEADLINE;
    loop {
        let sockets = std::fs::read_dir(folder.path().join("sieben")).into_iter().flatten().flatten();
        if let Some(mut stream) = sockets.map(|entry| entry.path()).find_map(|path| UnixStream::connect(path).ok()) {
            writeln!(stream, "{request}").expect("the demo reads");
            let mut answer = String::new();
            BufReader::new(stream).read_line(&mut answer).expect("the demo answers");
            return answer;
        }
        assert!(Instant::now() < until, "the demo answers");
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn the_demo_shows_what_its_keys_and_others_do() {
    let folder = folder();
    let (window, inside) = terminal();
    let demo = start(&folder, &["demo"], inside);
    let mut window = Window::of(window);
    window.shows("DISPLAY");
    // START is the first input of the screen: the plant doses.
    window.press("1");
    window.press("\t\t");
    window.shows("VALVE");
    ask(&folder, r#"{"verb":"mode","mode":"stop"}"#);
    window.press("r");
    window.press("p");
    window.shows("paused");
    let scans = |answer: &str| answer.split("\"scans\":").nth(1).and_then(|rest| rest.split(',').next()?.parse::<u64>().ok());
    let state = |folder: &Folder| ask(folder, r#"{"verb":"state"}"#);
    // The start and the scan that a pause ends with are carried out by the thread that scans: they have come when nothing moves any more.
    let until = Instant::now() + DEADLINE;
    let before = loop {
        let (first, ()) = (state(&folder), std::thread::sleep(STILL));
        let second = state(&folder);
        let stands = second.contains(r#""paused":true"#) && second.contains(r#""mode":"RUN""#) && scans(&first) == scans(&second);
        if stands {
            break second;
        }
        assert!(Instant::now() < until, "paused in RUN: {second}");
    };
    window.press("nn");
    while scans(&state(&folder)) != scans(&before).map(|scans| scans + 2) {
        assert!(Instant::now() < until, "two scans more: {before} {}", state(&folder));
    }
    ask(&folder, r#"{"verb":"time","time":"go"}"#);
    window.shows("pause");
    ask(&folder, r#"{"verb":"time","time":"speed","speed":"50x"}"#);
    // What stays of the header is not drawn again.
    window.shows("m50");
    // A second one has no socket: it says so where there is room, and draws.
    let (second_window, inside) = terminal();
    let second = start(&folder, &["demo", "--for", "1s"], inside);
    let mut second_window = Window::of(second_window);
    second_window.shows("STOP");
    second_window.press("\t\t");
    second_window.shows("another");
    assert_eq!(end(second).code(), Some(0));
    let (_, after) = second_window.left();
    assert!(after.contains("100 scans in 1.00 s of the plant"), "{after:?}");
    window.press("q");
    assert_eq!(end(demo).code(), Some(0));
    let (_, after) = window.left();
    assert!(after.contains("of the plant,") && !after.contains("our mistake"), "{after:?}");
}

#[test]
fn the_demo_without_a_terminal_that_can_be_drawn_on_prints_lines() {
    let folder = folder();
    for term in ["dumb", ""] {
        let (window, inside) = terminal();
        let demo = start_as(&folder, &["demo", "--for", "4s", "--speed", "max"], inside, term);
        assert_eq!(end(demo).code(), Some(0));
        let printed = Window::of(window).printed();
        assert!(printed.contains("Dosing valve") && !printed.contains("\u{1b}[?1049h"), "{term:?} {printed:?}");
    }
}

#[test]
fn a_signal_ends_the_demo_and_gives_the_terminal_back() {
    let folder = folder();
    let (window, inside) = terminal();
    let demo = start(&folder, &["demo"], inside);
    let mut window = Window::of(window);
    window.shows("DISPLAY");
    interrupt(&demo);
    assert_eq!(end(demo).code(), Some(0));
    assert!(window.left().1.contains("of the plant,"));
}

#[test]
fn a_run_has_the_screen_and_its_report_comes_after_it() {
    let folder = folder();
    for (keys, code) in [("q", 0), ("\u{3}", 0), ("\u{1b}", 0)] {
        let (window, inside) = terminal();
        let run = start(&folder, &["run", "."], inside);
        let mut window = Window::of(window);
        window.shows("Inputs");
        window.press("1");
        let is_on = || asked(&folder.path().join(".sieben/control.sock"), r#"{"verb":"read","items":["Q4.0"]}"#).contains(r#""value":1"#);
        let until = Instant::now() + DEADLINE;
        while !is_on() {
            assert!(Instant::now() < until, "the key 1 switches I 0.0");
            std::thread::sleep(Duration::from_millis(20));
        }
        window.press(keys);
        assert_eq!(end(run).code(), Some(code), "{keys:?}");
        let (screen, after) = window.left();
        assert!(screen.contains("lamp") && after.contains("RUN: stopped by Ctrl-C after"), "{screen:?} {after:?}");
    }
}

#[test]
fn a_run_that_ends_by_itself_closes_its_screen() {
    let folder = folder();
    let (window, inside) = terminal();
    let run = start(&folder, &["run", "--for", "1s"], inside);
    assert_eq!(end(run).code(), Some(0));
    let (_, after) = Window::of(window).left();
    assert!(after.contains("RUN: ran for 1.0 s"), "{after:?}");
    // FC 99 is missing: the CPU goes to STOP.
    let stops = Folder::with(&[("main.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL SFC 46;\nEND_ORGANIZATION_BLOCK\n")]);
    let (window, inside) = terminal();
    let run = start(&stops, &["run", "main.awl"], inside);
    assert_eq!(end(run).code(), Some(4));
    let (_, after) = Window::of(window).left();
    assert!(after.contains("The CPU went to STOP"), "{after:?}");
}

#[test]
fn a_run_ends_with_its_terminal_and_at_every_signal() {
    ends_with_its_terminal(&folder(), &["run"]);
    for signal in [rustix::process::Signal::INT, rustix::process::Signal::TERM, rustix::process::Signal::HUP] {
        let folder = folder();
        let (window, inside) = terminal();
        let run = start(&folder, &["run"], inside);
        let mut window = Window::of(window);
        window.shows("Inputs");
        let _ = rustix::process::kill_process(rustix::process::Pid::from_child(&run), signal);
        assert_eq!(end(run).code(), Some(0), "{signal:?}");
        assert!(window.left().1.contains("RUN: stopped"));
    }
}

#[test]
fn a_terminal_that_changes_its_size_is_drawn_anew() {
    let folder = folder();
    let (window, inside) = terminal();
    let resize = window.try_clone().expect("one more handle");
    let size = |columns, rows| {
        let size = Winsize { ws_row: rows, ws_col: columns, ws_xpixel: 0, ws_ypixel: 0 };
        tcsetwinsize(&resize, size).expect("it has a size");
    };
    size(40, 10);
    let run = start(&folder, &["run"], inside);
    let mut window = Window::of(window);
    window.shows("needs");
    size(200, 50);
    window.press("?");
    window.shows("Inputs");
    size(1, 1);
    window.press("qq");
    assert_eq!(end(run).code(), Some(0));
}

#[test]
fn without_a_screen_a_run_prints_lines_where_it_is_asked_to() {
    let program = "ORGANIZATION_BLOCK OB 1\nBEGIN\nAN M 0.0\n= Q 4.0\nEND_ORGANIZATION_BLOCK\n";
    let folder = Folder::with(&[("main.awl", program)]);
    // When its first scan comes is a matter of the computer in real time.
    let (begins, ends) = ("scan 1 (", " s): Q 4.0 0→1");
    let on_terminal = |arguments: &[&str], term: &str| {
        let (window, inside) = terminal();
        let run = start_as(&folder, arguments, inside, term);
        assert_eq!(end(run).code(), Some(0));
        Window::of(window).printed()
    };
    for (arguments, term) in
        [(&["run", "--plain", "--for", "1s"][..], "xterm"), (&["run", "--for", "1s"], "dumb"), (&["run", "--for", "1s"], "")]
    {
        let printed = on_terminal(arguments, term);
        let line = printed.lines().any(|line| line.starts_with(begins) && line.trim_end().ends_with(ends));
        assert!(line && printed.contains("RUN: ran for 1.0 s") && !printed.contains("\u{1b}[?1049h"), "{printed:?}");
    }
    // Programs read what they always have, unless they ask for the lines.
    for (more, lines) in [(None, 0), (Some("--plain"), 1)] {
        let arguments: Vec<&str> = ["run", "--for", "1s", "--speed", "max"].into_iter().chain(more).collect();
        let output = sieben(folder.path(), &arguments).output().expect("sieben runs");
        let text = String::from_utf8(output.stdout).expect("UTF-8");
        assert_eq!(text.matches(&format!("{begins}0.00{ends}")).count(), lines, "{text}");
        assert!(text.ends_with(" scans, cycle 10 ms (min 10 ms, max 10 ms)\n"), "{text}");
    }
    let both = sieben(folder.path(), &["run", "--plain", "--json"]).output().expect("sieben runs");
    assert_eq!(both.status.code(), Some(2), "lines and one JSON object do not go together");
}

/// Exercise 1.1 of the course, with keys alone: the decades are shown while they are not below the toggle switches.
#[test]
fn the_exercise_with_the_decade_switches_is_done_with_keys_alone() {
    let folder = Folder::new();
    let new = sieben(folder.path(), &["new", "my", "--example", "decade-switches"]).output().expect("sieben runs");
    assert!(new.status.success());
    let (window, inside) = terminal();
    let (columns, rows) = (120, 40);
    let size = Winsize { ws_row: rows as u16, ws_col: columns as u16, ws_xpixel: 0, ws_ypixel: 0 };
    tcsetwinsize(&window, size).expect("it has a size");
    let run = start(&folder, &["run", "my"], inside);
    let mut window = Window::of(window);
    // The column of inputs and outputs stands in the middle.
    let shows = |picture: &[String], name: &str, value: &str| {
        let middle = |line: &String| line.chars().skip(40).take(38).collect::<String>();
        picture.iter().map(middle).any(|line| line.contains(name) && line.contains(value))
    };
    let display = |value: &'static str| move |picture: &[String]| shows(picture, "Display", value);
    window.looks(columns, rows, display("16#0000"));
    // The first row is that of the toggle switches, the second that of the decade switches.
    let typed = |window: &mut Window, value: &str| {
        window.press("e");
        window.looks(columns, rows, |picture| picture[rows - 1].contains(" = "));
        window.press(value);
        window.press("\r");
    };
    typed(&mut window, "16#0012");
    window.press("\u{1b}[B");
    typed(&mut window, "16#1234");
    window.looks(columns, rows, display("16#1234"));
    // Below the toggle switches nothing is shown.
    typed(&mut window, "16#0011");
    window.looks(columns, rows, |picture| shows(picture, "Decades", "16#0011") && shows(picture, "Display", "16#0000"));
    // A switch between two digits is no number: a lamp says so.
    typed(&mut window, "16#12A4");
    window.looks(columns, rows, |picture| shows(picture, "DigitLamp", "●"));
    window.press("q");
    assert_eq!(end(run).code(), Some(0));
}
