//! The screen in virtual time: what it shows of the examples, and what its keys do.

mod keys;
mod play;
mod svg;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;
use serde_json::json;
use sieben_workspace::project::{Overrides, Project};
use sieben_workspace::session::Language;

use super::draw;
use super::look::Look;
use super::rows::Group;
use super::state::{Over, Part, Screen};
use super::words;
use crate::palette::Palette;
use play::Played;

/// Each example with a moment of its scenario at which something happens, in milliseconds.
const MOMENTS: [(&str, u64); 10] = [
    ("car-park", 2_000),
    ("conveyor", 2_400),
    ("decade-switches", 300),
    ("dosing", 3_000),
    ("elevator", 4_000),
    ("heater", 30_000),
    ("packing", 9_000),
    ("star-delta", 3_000),
    ("tank", 6_000),
    ("traffic-light", 9_000),
];
/// The sizes of the pictures in the documentation, with the part that the changing part of the screen shows.
const SIZES: [(u16, u16); 2] = [(100, 30), (200, 50)];

fn drawn(look: &Look, screen: &Screen, (width, height): (u16, u16)) -> Buffer {
    let mut terminal = Terminal::new(TestBackend::new(width, height)).expect("a backend in memory");
    terminal.draw(|frame| draw::draw(frame, look, screen, Palette::Colours)).expect("a backend in memory");
    terminal.backend().buffer().clone()
}

fn text(buffer: &Buffer) -> String {
    let row = |y: u16| (0..buffer.area.width).map(|x| buffer[(x, y)].symbol()).collect::<String>().trim_end().to_owned() + "\n";
    (0..buffer.area.height).map(row).collect()
}

fn at_moment(name: &str, ms: u64) -> Played {
    let mut played = Played::example(name);
    played.play(name, ms);
    played.scan_and_look();
    // A run whose time goes on looks like this.
    played.look.state["paused"] = json!(false);
    played
}

fn file(name: &str, width: u16, ending: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reference/screens").join(format!("{name}-{width}.{ending}"))
}

/// Compares a generated file, or writes it where `SIEBEN_GENERATE` is set.
fn keep(path: &Path, now: &str) -> bool {
    if std::env::var_os("SIEBEN_GENERATE").is_some() {
        fs::create_dir_all(path.parent().expect("a folder")).expect("the folder can be made");
        fs::write(path, now).expect("the file can be written");
    }
    fs::read_to_string(path).is_ok_and(|stored| stored == now)
}

#[test]
fn screens_of_all_examples_are_those_of_the_documentation() {
    assert_eq!(MOMENTS.map(|(name, _)| name)[..], crate::examples::ALL.iter().map(|example| example.name).collect::<Vec<_>>());
    let mut stale = Vec::new();
    for (name, ms) in MOMENTS {
        let played = at_moment(name, ms);
        for size in SIZES {
            let buffer = drawn(&played.look, &played.screen, size);
            for (ending, now) in [("txt", text(&buffer)), ("svg", svg::svg(&buffer))] {
                let path = file(name, size.0, ending);
                if !keep(&path, &now) {
                    stale.push(path.display().to_string());
                }
            }
        }
    }
    assert_eq!(stale, [""; 0], "these are stale: SIEBEN_GENERATE=1 cargo test -p sieben-app screens");
}

#[test]
fn the_picture_in_the_readme_is_what_the_screen_shows() {
    let mut played = at_moment("dosing", 2_500);
    played.look.state["project"] = json!("demo");
    played.screen.story = Some(Arc::default());
    let shown = text(&drawn(&played.look, &played.screen, (80, 24)));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../README.md");
    let readme = fs::read_to_string(&path).expect("the README is there");
    let (before, rest) = readme.split_once("```text\n").expect("a picture in the README");
    let (_, after) = rest.split_once("```").expect("the end of the picture");
    assert!(keep(&path, &format!("{before}```text\n{shown}```{after}")), "the picture in README.md is stale; it is now\n{shown}");
}

#[test]
fn every_size_part_and_list_can_be_drawn() {
    let mut played = at_moment("tank", 2_000);
    let overs = [Over::Nothing, Over::Help, Over::MemoryReset, Over::Prompt { row: 0, typed: "16#".to_owned() }];
    for language in [Language::English, Language::German] {
        played.screen.language = language;
        for (width, height) in [(1, 1), (2, 50), (79, 24), (80, 23), (80, 24), (81, 25), (119, 40), (120, 24), (160, 24), (300, 100)] {
            for part in [Part::Program, Part::Values, Part::Changes, Part::Diagnostics, Part::Run] {
                for over in &overs {
                    (played.screen.part, played.screen.over) = (part, over.clone());
                    drawn(&played.look, &played.screen, (width, height));
                    drawn(&Look::default(), &played.screen, (width, height));
                }
            }
        }
    }
}

#[test]
fn a_small_terminal_is_asked_to_grow_in_the_language_of_the_user() {
    let mut screen = Screen::default();
    let shown = |screen: &Screen| text(&drawn(&Look::default(), screen, (79, 10)));
    assert!(shown(&screen).contains("needs 80 × 24 characters; the terminal has 79 × 10."), "{}", shown(&screen));
    screen.language = Language::German;
    assert!(shown(&screen).contains("braucht 80 × 24 Zeichen; das Terminal hat 79 × 10."), "{}", shown(&screen));
}

#[test]
fn a_stop_shows_its_cause_and_a_block_that_does_not_run_nothing() {
    let mut played = at_moment("tank", 1_000);
    assert!(!played.look.program.seen.is_empty());
    played.ask("mode", &json!({ "mode": "stop" }));
    played.scan_and_look();
    let shown = text(&drawn(&played.look, &played.screen, (100, 30)));
    assert!(shown.contains("● STOP") && shown.lines().nth(1).is_some_and(|line| line.contains("STOP")), "{shown}");
    assert!(played.look.program.seen.is_empty(), "a CPU in STOP executes nothing");
    for (speed, shown) in [("max", " max "), ("0.5x", " 0.5× "), ("1x", " 1× ")] {
        played.look.state["speed"] = json!(speed);
        let header = text(&drawn(&played.look, &played.screen, (100, 30))).lines().next().map(|line| format!("{line} "));
        assert!(header.as_ref().is_some_and(|header| header.contains(shown)), "{header:?}");
    }
}

/// A project of one statement with this table of symbols.
fn with_symbols(rows: impl Iterator<Item = String>) -> Played {
    let mut project = Project::new(None);
    project.add_settings(Path::new("sieben.toml"), b"sources = [\"a.awl\"]\nsymbols = [\"s.csv\"]\nmnemonics = \"en\"\n");
    let table = "symbol,address,type,comment\n".to_owned() + &rows.collect::<String>();
    project.add_symbols(Path::new("s.csv"), table.as_bytes()).expect("a table");
    project.add_source(Path::new("a.awl"), b"ORGANIZATION_BLOCK OB 1\nBEGIN\n A I 0.0;\n = Q 0.0;\nEND_ORGANIZATION_BLOCK\n");
    Played::of(&project.compile(Overrides::default(), false))
}

#[test]
fn many_inputs_leave_room_for_outputs_and_long_names_are_read() {
    let name = "N".repeat(100);
    let row = |area: char, at: usize| format!("{name}{area}{at},{area} {}.{},BOOL,\n", at / 8, at % 8);
    let mut played = with_symbols((0..1_000).map(|at| row('I', at)).chain((0..1_000).map(|at| row('Q', at))));
    played.ask("write", &json!({ "values": { "I0.0": 1 } }));
    played.scan_and_look();
    let first = |group| played.look.rows.iter().zip(&played.look.shown).find(|(row, _)| row.group == group).map(|(_, shown)| shown.on);
    assert_eq!([Group::Inputs, Group::Outputs].map(first), [Some(Some(true)); 2]);
}

#[test]
fn wide_characters_leave_the_columns_where_they_are() {
    let mut played = with_symbols(["漢字漢字漢字,I 0.0,BOOL,漢字\n", "Motor,I 0.1,BOOL,\n"].map(str::to_owned).into_iter());
    played.scan_and_look();
    let shown = drawn(&played.look, &played.screen, (80, 24));
    // A cell after a wide character has a space of its own, so cells are compared, not characters of a line.
    let address = |y: u16| (1..40).find(|&x| (0..5).map(|at| shown[(x + at, y)].symbol()).collect::<String>() == format!("I 0.{}", y - 2));
    assert!(address(2).is_some() && address(2) == address(3), "{}", text(&shown));
    let frames = |y: u16| [0, 41, 42, 79].map(|x| shown[(x, y)].symbol().to_owned());
    assert_eq!([frames(2), frames(3)], [["│"; 4].map(str::to_owned), ["│"; 4].map(str::to_owned)], "{}", text(&shown));
}

#[test]
fn the_help_is_whole_on_the_least_terminal() {
    let mut played = at_moment("tank", 1_000);
    played.screen.over = Over::Help;
    for language in [Language::English, Language::German] {
        played.screen.language = language;
        let shown = text(&drawn(&played.look, &played.screen, (80, 24)));
        for (_, words) in words::HELP {
            assert!(shown.contains(played.screen.word(*words)), "{words:?}\n{shown}");
        }
    }
}

#[test]
fn the_words_of_both_languages_fit() {
    let mut played = at_moment("tank", 1_000);
    played.screen.language = Language::German;
    let shown = text(&drawn(&played.look, &played.screen, (80, 24)));
    for word in ["Anlage", "Eingänge", "Ausgänge", "VKE", "AKKU 1", "Tasten"] {
        assert!(shown.contains(word), "{word}\n{shown}");
    }
}
