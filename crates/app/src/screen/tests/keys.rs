//! What keys do.

use ratatui::crossterm::event::KeyCode;
use serde_json::{Value, json};

use super::super::keys::command;
use super::super::rows::Driver;
use super::super::state::{Command, Over, Said, Then};
use super::play::Played;
use crate::terminal::Key;

fn plain(character: char) -> Key {
    Key::Plain(KeyCode::Char(character))
}

/// Presses a key so many times.
fn press(played: &mut Played, code: KeyCode, times: usize) {
    for _ in 0..times {
        played.key(Key::Plain(code));
    }
}

fn value(played: &mut Played, name: &str) -> Value {
    played.ask("read", &json!({ "items": [name] }))["items"][0]["value"].clone()
}

fn refused(played: &Played) -> String {
    match &played.screen.said {
        Some(Said::Refused(text)) => text.clone(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn every_way_to_leave_is_known() {
    for key in [Key::Leave, Key::Plain(KeyCode::Esc), plain('q'), plain('Q')] {
        assert_eq!(command(key), Some(Command::Quit));
    }
    assert_eq!(command(Key::Plain(KeyCode::Insert)), None);
    let mut played = Played::example("tank");
    played.key(plain('f'));
    assert_eq!(played.key(Key::Leave), Then::Leave, "Ctrl-C leaves whatever lies over the screen");
}

#[test]
fn digits_switch_inputs_and_press_buttons() {
    let mut played = Played::example("tank");
    played.key(plain('1'));
    played.scans(1);
    assert_eq!(value(&mut played, "Auto"), json!(1));
    // Twice between two scans is as good as not at all, however little of it the program has seen.
    played.refresh();
    press(&mut played, KeyCode::Char('1'), 3);
    played.scans(100);
    assert_eq!(value(&mut played, "Auto"), json!(0));
    played.key(plain('9'));
    assert_eq!(refused(&played), "there is no input 9 to operate");
    let mut played = Played::example("dosing");
    played.key(plain('1'));
    played.key(plain('1'));
    played.scans(39);
    assert_eq!((value(&mut played, "START"), value(&mut played, "VALVE")), (json!(1), json!(1)), "a button stays pressed for 400 ms");
    played.scans(3);
    assert_eq!(value(&mut played, "START"), json!(0));
    // STOP breaks: pressed it is 0.
    played.key(plain('2'));
    played.scans(1);
    assert_eq!((value(&mut played, "STOP"), value(&mut played, "VALVE")), (json!(0), json!(0)));
    played.scans(42);
    assert_eq!(value(&mut played, "STOP"), json!(1));
}

#[test]
fn an_input_of_a_sensor_and_an_output_say_who_drives_them() {
    let mut played = Played::example("dosing");
    press(&mut played, KeyCode::Down, 2);
    played.key(plain(' '));
    assert_eq!(refused(&played), "I 0.7 FLOW is driven by the plant `plant`; hold it with a fault: f");
    played.key(Key::Plain(KeyCode::Right));
    played.key(Key::Plain(KeyCode::Enter));
    assert_eq!(refused(&played), "Q 0.0 VALVE is written by the program in every scan");
}

#[test]
fn a_word_is_typed_in_any_notation_and_a_wrong_value_stays() {
    let mut played = Played::example("car-park");
    played.screen.row = played.look.rows.iter().position(|row| row.name == "SetValue");
    let typed = |played: &mut Played, text: &str| {
        text.chars().for_each(|character| press(played, KeyCode::Char(character), 1));
        played.key(Key::Plain(KeyCode::Enter));
    };
    played.key(plain('e'));
    typed(&mut played, "99999");
    assert!(refused(&played).starts_with("P7004: "), "{}", refused(&played));
    assert!(matches!(&played.screen.over, Over::Prompt { typed, .. } if typed == "99999"), "nothing typed is lost");
    press(&mut played, KeyCode::Backspace, 5);
    typed(&mut played, "16#0011");
    assert_eq!(played.screen.over, Over::Nothing);
    played.scans(1);
    assert_eq!(value(&mut played, "SetValue"), json!(17));
}

#[test]
fn formats_go_round() {
    let mut played = Played::example("tank");
    played.screen.row = played.look.rows.iter().position(|row| row.name == "ScaleError");
    let shown = |played: &Played| played.look.shown[played.screen.chosen(&played.look)].text.clone();
    let first = shown(&played);
    assert_eq!(first, "16#0000 (0)");
    played.key(plain('x'));
    assert_eq!(shown(&played), "2#0000_0000_0000_0000");
    let formats = played.look.rows[played.screen.chosen(&played.look)].formats().len();
    press(&mut played, KeyCode::Char('x'), formats);
    assert_eq!(shown(&played), first);
}

#[test]
fn faults_are_injected_and_mended_from_the_list() {
    let mut played = Played::example("tank");
    played.key(plain('f'));
    played.key(Key::Plain(KeyCode::Enter));
    assert_eq!(played.look.plants[0]["faults"], json!(["tank.low stuck=0"]));
    played.key(plain('f'));
    played.key(Key::Plain(KeyCode::Enter));
    assert_eq!(played.look.plants[0]["faults"], json!([]));
    // The list begins where the selected signal stands.
    let last = played.look.rows.iter().rposition(|row| row.driver == Driver::Plant("tank".to_owned()));
    let address = played.look.rows[last.expect("a sensor")].address.clone();
    played.screen.row = last;
    played.key(plain('f'));
    let Over::Menu(menu) = &played.screen.over else { panic!("{:?}", played.screen.over) };
    assert!(menu.at > 0 && menu.rows[menu.at].1.contains(&format!("  {address} ")), "{address}: {:?}", menu.rows[menu.at]);
}

#[test]
fn modes_and_time_obey_keys_and_a_memory_reset_asks() {
    let mut played = Played::example("tank");
    played.scans(2);
    played.key(plain('m'));
    played.key(plain('n'));
    assert_eq!(played.screen.said, None, "only y resets");
    played.key(plain('m'));
    played.key(plain('y'));
    assert!(refused(&played).starts_with("P7093: "), "{}", refused(&played));
    played.key(plain('s'));
    assert_eq!(played.look.word("mode"), "STOP");
    played.key(plain('m'));
    played.key(plain('y'));
    assert!(matches!(played.screen.said, Some(Said::Done(_))));
    press(&mut played, KeyCode::Char('+'), 20);
    assert_eq!(played.look.word("speed"), "max");
    press(&mut played, KeyCode::Char('-'), 20);
    assert_eq!(played.look.word("speed"), "0.1x");
    assert!(played.look.is_paused());
    played.key(plain('p'));
    assert!(!played.look.is_paused());
}

#[test]
fn keys_that_are_pressed_between_two_pictures_all_count() {
    let mut played = Played::example("tank");
    let mut keys = |text: &str| {
        for character in text.chars() {
            played.screen.key(plain(character), &played.look, &mut played.asks).expect("the run answers");
        }
        played.refresh();
        (played.look.word("speed").to_owned(), played.look.is_paused())
    };
    assert_eq!(keys("+++"), ("10x".to_owned(), true));
    assert_eq!(keys("p--"), ("2x".to_owned(), false));
}

#[test]
fn a_note_is_said_once_whatever_part_is_shown() {
    let mut played = Played::example("tank");
    assert!(!played.screen.tell_note(&played.look));
    played.gate.enter(|plant| played.desk.observed.note(plant, "a source is broken")).expect("the gate is open");
    played.refresh();
    assert!(played.screen.tell_note(&played.look));
    assert_eq!(refused(&played), "a source is broken");
    assert!(!played.screen.tell_note(&played.look));
}

#[test]
fn another_block_is_chosen_from_the_list() {
    let mut played = Played::example("traffic-light");
    let block = played.look.program.block.clone();
    assert_ne!(block, "OB 1", "OB 1 only calls");
    played.key(plain('b'));
    press(&mut played, KeyCode::Up, 20);
    played.key(Key::Plain(KeyCode::Enter));
    assert_ne!(played.look.program.block, block);
    assert!(!played.look.program.lines.is_empty());
}
