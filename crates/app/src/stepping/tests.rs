//! What the microscope shows, drawn into memory.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use ratatui::Terminal;
use ratatui::backend::TestBackend;
use sieben_engine::Interpreter;
use sieben_sim::history::Plan;
use sieben_workspace::controller;
use sieben_workspace::project::{Build, Overrides};
use sieben_workspace::session::{Direction, Language, Session, Unit};

use super::draw;
use super::keys::Command;
use super::picture::Screen;
use crate::project;

fn build() -> Build {
    of_example("dosing", &["dosing.awl", "symbols.csv"])
}

fn of_example(name: &str, files: &[&str]) -> Build {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    let paths: Vec<PathBuf> = files.iter().map(|name| root.join(name)).collect();
    let project = project::load(&paths, None).unwrap_or_else(|failure| panic!("{}", failure.render(false, Language::English)));
    project.compile(Overrides::default(), false)
}

fn session(build: Build) -> Session {
    let cpu = controller::load(&build, Interpreter::load, controller::settings(&build));
    Session::new(Arc::new(build), cpu, Plan::new(10_000, None, Vec::new()))
}

/// The screen behind these commands.
fn shown(commands: &[Command], language: Language, size: (u16, u16)) -> String {
    shown_of(build(), commands, language, size)
}

fn shown_of(build: Build, commands: &[Command], language: Language, (width, height): (u16, u16)) -> String {
    let mut session = session(build);
    session.language = language;
    let mut screen = Screen::new(&mut session, true);
    for &command in commands {
        assert!(!screen.act(&mut session, command, 10), "{command:?} does not leave");
    }
    let picture = screen.picture(&mut session);
    let mut terminal = Terminal::new(TestBackend::new(width, height)).expect("a backend in memory");
    terminal.draw(|frame| draw::draw(frame, &picture)).expect("a backend in memory");
    terminal.backend().to_string()
}

const STEP: Command = Command::Step(Unit::Statement, Direction::Forward);
const BACK: Command = Command::Step(Unit::Statement, Direction::Back);

#[test]
fn the_screen_shows_source_registers_and_reason() {
    insta::assert_snapshot!(shown(&[STEP, STEP, STEP], Language::English, (80, 24)));
}

#[test]
fn registers_are_shown_bit_by_bit_above_the_source_in_either_language() {
    let screen = shown(&[STEP, STEP, STEP, Command::RegisterBits], Language::English, (80, 24));
    let lines: Vec<&str> = screen.lines().map(|line| line.trim_matches(['"', '│', ' '])).collect();
    let head = lines.iter().position(|line| line.contains("Registers, bit by bit")).expect("a title");
    assert_eq!(lines[head + 1], "31   27   23   19   15   11   7    3", "{screen}");
    for (line, name) in lines[head + 2..].iter().zip(["ACCU1 2#", "ACCU2 2#", "AR1   2#", "AR2   2#"]) {
        assert!(line.starts_with(name), "{screen}");
    }
    let german = shown(&[Command::RegisterBits, Command::RegisterBits, Command::RegisterBits], Language::German, (80, 24));
    assert!(german.contains("AKKU1 2#0000_0000_0000_0000_0000_0000_0000_0000  0"), "{german}");
}

#[test]
fn the_picture_in_the_documentation_is_what_the_screen_shows() {
    let page = include_str!("../../../../docs/learn/step-through-a-network.md");
    let picture = page.split("```text\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a picture on the page");
    let screen = shown(&[STEP, STEP, STEP], Language::English, (80, 24));
    let shown: Vec<&str> = screen.lines().map(|line| line.trim_matches('"').trim_end()).collect();
    assert_eq!(picture.lines().collect::<Vec<_>>(), shown);
}

#[test]
fn the_screen_speaks_german() {
    insta::assert_snapshot!(shown(&[STEP, STEP, STEP, Command::Help], Language::German, (80, 24)));
}

#[test]
fn a_larger_terminal_shows_more_source() {
    let commands = [Command::Step(Unit::Scan, Direction::Forward), STEP, Command::Focus, Command::Toggle, STEP, STEP];
    insta::assert_snapshot!(shown(&commands, Language::English, (120, 40)));
}

#[test]
fn a_step_back_shows_what_was_before() {
    let message = |text: &str| text.lines().last().unwrap_or_default().to_owned();
    let there = shown(&[STEP, STEP], Language::English, (80, 24));
    let and_back = shown(&[STEP, STEP, STEP, BACK], Language::English, (80, 24));
    // The picture is the same but for the header, which tells how much lies ahead.
    assert_eq!(there.lines().skip(1).collect::<Vec<_>>(), and_back.lines().skip(1).collect::<Vec<_>>());
    assert!(and_back.lines().next().is_some_and(|header| header.contains("past · ")), "{and_back}");
    assert!(message(&shown(&[BACK], Language::English, (80, 24))).contains("this is the beginning of the run"));
}

#[test]
fn a_breakpoint_at_the_cursor_stops_the_run() {
    let commands = [Command::Lines(3), Command::Toggle, Command::Run(Direction::Forward)];
    let text = shown(&commands, Language::English, (80, 24));
    assert!(text.contains('●') && text.contains("breakpoint 1"), "{text}");
}

#[test]
fn a_command_line_takes_every_command() {
    let type_in = |line: &str| {
        let mut commands = vec![Command::Prompt("")];
        commands.extend(line.chars().map(Command::Type));
        commands.push(Command::Enter);
        commands
    };
    let text = shown(&type_in("watch MW10"), Language::English, (80, 24));
    let wrong = shown(&type_in("walk"), Language::English, (80, 24));
    assert!(text.contains("MW10"), "{text}");
    assert!(wrong.contains("walk"), "{wrong}");
    // A movement is shown by the screen itself, not by a row of the table.
    let moved = shown(&type_in("step 3"), Language::English, (80, 24));
    assert!(moved.lines().last().is_some_and(|line| line.contains("s step")), "{moved}");
}

#[test]
fn a_message_is_shown_to_its_end() {
    let text = shown(&[vec![Command::Prompt("walk")], vec![Command::Enter]].concat(), Language::English, (80, 24));
    // The longest of all lists every command; the last one stands in its last line.
    assert!(text.contains("[P7040] Error: `walk` is no command") && text.contains("`help` or `quit`"), "{text}");
}

#[test]
fn registers_stand_beside_the_statements_on_a_wide_terminal() {
    let text = shown(&[STEP, STEP, STEP], Language::English, (160, 50));
    let line = text.lines().find(|line| line.contains("L     C#25")).expect("the statement is shown");
    let column = line.split("00000025").next().map(|left| left.chars().count());
    assert!(column.is_some_and(|column| column < 90), "{text}");
}

#[test]
fn before_the_start_there_is_no_number_of_a_scan() {
    let text = shown(&[], Language::English, (80, 24));
    assert!(text.lines().next().is_some_and(|header| header.contains("before the start") && header.contains("start · 0 ms")), "{text}");
}

#[test]
fn an_input_is_switched_among_the_bits_and_the_next_scan_sees_it() {
    let text = shown(&[Command::Focus, Command::Toggle], Language::English, (80, 24));
    assert!(text.contains("I 0.0 becomes 1 with the next scan") && text.contains("0000 0000  .0 → 1"), "{text}");
    let scan = Command::Step(Unit::Scan, Direction::Forward);
    let next = shown(&[Command::Focus, Command::Toggle, scan], Language::English, (80, 24));
    assert!(next.contains("0000 0001  .0 "), "{next}");
    let back_off = shown(&[Command::Focus, Command::Toggle, Command::Toggle, scan], Language::German, (80, 24));
    assert!(back_off.contains("0000 0000  .0 "), "{back_off}");
}

#[test]
fn a_small_terminal_is_asked_to_grow_and_no_size_panics() {
    let text = shown(&[], Language::English, (79, 10));
    assert!(text.contains("The microscope needs 80 × 24 characters; this terminal has 79 × 10."), "{text}");
    for size in [(1, 1), (2, 60), (200, 1), (80, 24), (81, 25), (300, 100)] {
        shown(&[STEP, Command::Help], Language::German, size);
    }
}

#[test]
fn the_network_is_shown_as_a_diagram_above_its_statements() {
    let network = Command::Step(Unit::Network, Direction::Forward);
    let steps = [network, network, network, STEP, Command::Diagram];
    insta::assert_snapshot!(shown(&steps, Language::English, (100, 36)));
    let steps = [network, network, network, STEP, Command::Diagram, Command::Diagram];
    insta::assert_snapshot!(shown(&steps, Language::German, (100, 36)));
    let sentence = shown(&[STEP, Command::Diagram], Language::English, (100, 36));
    assert!(sentence.contains("Stays STL: `L C#25` (line 10)"), "{sentence}");
}

fn car_park() -> Build {
    of_example("car-park", &["car-park.st", "symbols.csv"])
}

#[test]
fn in_structured_text_values_stand_after_the_lines_and_variables_in_the_place_of_the_registers() {
    let steps = [STEP; 13];
    let text = shown_of(car_park(), &steps, Language::English, (120, 40));
    // After a call of the library the outputs of the instance.
    assert!(text.contains("   41   long(IN := first OR second, PT := T#2m);  // long.Q = FALSE"), "{text}");
    assert!(text.contains("   40   position := next;  // position = 0, next = 0 "), "{text}");
    for gone in ["RLO", "ACCU1"] {
        assert!(!text.contains(gone), "{text}");
    }
    assert!(text.contains("variables of Lane") && text.contains("│first                            FALSE│"), "{text}");
    // Into the library on request.
    let into = shown_of(
        car_park(),
        &[[STEP; 12].as_slice(), &[Command::Step(Unit::Into, Direction::Forward)]].concat(),
        Language::English,
        (120, 40),
    );
    assert!(into.contains("timers.st") && into.contains("Lane › TON"), "{into}");
}

#[test]
fn between_two_scans_the_variables_of_the_program_stay_on_the_screen() {
    let scan = Command::Step(Unit::Scan, Direction::Forward);
    let text = shown_of(car_park(), &[scan], Language::English, (120, 40));
    assert!(text.contains("between two scans") && text.contains("variables of CarPark"), "{text}");
    assert!(text.contains("│cars                                 0│"), "{text}");
    // In STL they take the place of the bits when they are asked for.
    let stl = || of_example("star-delta", &["star-delta.awl", "symbols.csv"]);
    let asked = shown_of(stl(), &[scan, Command::Variables], Language::German, (120, 40));
    assert!(asked.contains("Variablen von FB 20, DB 20") && asked.contains("DB20.star_time"), "{asked}");
}

#[test]
fn timers_counters_and_words_of_the_program_stand_below_its_bits() {
    let text = shown(&[STEP, STEP, STEP], Language::English, (80, 30));
    for line in ["│C 0                      0│", "│QW 4           16#0000 (0)│"] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    let stl = of_example("star-delta", &["star-delta.awl", "symbols.csv"]);
    let text = shown_of(stl, &[STEP, STEP, STEP], Language::English, (120, 40));
    assert!(text.contains("│T 1                            S5T#0MS│"), "{text}");
    // What is watched stands once.
    let watch: Vec<Command> = [vec![Command::Prompt("show ")], "C0".chars().map(Command::Type).collect(), vec![Command::Enter]].concat();
    let watched = shown(&watch, Language::English, (80, 30));
    assert!(watched.contains("│C0 = 0") && !watched.contains("│C 0 "), "{watched}");
}

#[test]
fn pointers_are_shown_field_by_field_below_the_registers() {
    let source = "FUNCTION FC 1 : VOID\nVAR_INPUT\n p : POINTER;\n a : ANY;\nEND_VAR\nBEGIN\nNOP 0\nEND_FUNCTION\n\
        ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1 (p := P#M 10.0, a := P#DB5.DBX 10.0 BYTE 20);\nEND_ORGANIZATION_BLOCK\n";
    let mut project = sieben_workspace::project::Project::default();
    project.add_source(Path::new("main.awl"), source.as_bytes());
    let build = project.compile(Overrides::default(), false);
    let text = shown_of(build, &[STEP, Command::RegisterBits], Language::English, (100, 50));
    for line in ["#p P#M 10.0", "byte 2: area M (16#83)", "#a P#DB5.DBX 10.0 BYTE 20", "bytes 2 and 3: count 20"] {
        assert!(text.contains(line), "`{line}` is missing in\n{text}");
    }
}
