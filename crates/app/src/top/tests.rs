//! What `sieben top` shows, drawn into memory.

use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::crossterm::event::KeyCode;
use serde_json::{Value, json};

use super::draw::draw;
use super::live::{Command, command};
use super::look::{BYTES, Look, Watched};
use crate::palette::Palette;
use crate::terminal::Key;

fn look(state: Value) -> Look {
    let mut all = json!({
        "project": "pump", "cpu": "315-2PN/DP", "mode": "RUN", "stop": null, "scans": 12_345, "time_ms": 123_450.0,
        "clock": "2026-11-28 15:52:42.064", "cycle_ms": { "last": 10.03, "min": 9.87, "max": 12.5 },
        "execution_ms": { "last": 0.05, "max": 0.08 }, "speed": "1x", "paused": false, "forced": [], "forced_count": 0,
        "connections": 1, "newest_entry": 2,
    });
    for (key, value) in state.as_object().expect("fields") {
        all[key] = value.clone();
    }
    let entry = |number: u64, text: &str| json!({ "number": number, "time": "2026-11-28 15:52:39.887", "event": "16#4302", "text": text, "file": "main.awl", "line": 5 });
    Look {
        state: all,
        bytes: BYTES.into_iter().zip([Some(0xA5), Some(0), None, Some(1), Some(0xFF), Some(0), Some(0), Some(0)]).collect(),
        values: vec![
            Watched { name: "MW10".to_owned(), value: Ok(json!("16#0005")), shown: "16#0005".to_owned() },
            Watched { name: "DB1.speed".to_owned(), value: Err("the data block is not loaded".to_owned()), shown: "-".to_owned() },
        ],
        entries: vec![entry(2, "mode change from STARTUP to RUN"), entry(1, "\u{1b}[31mred")],
        blocks: vec!["OB 1".to_owned(), "FC 5".to_owned(), "DB 1".to_owned()],
        block_count: 2_000,
    }
}

fn shown(look: &Look, (width, height): (u16, u16), message: Option<&str>) -> String {
    let mut terminal = Terminal::new(TestBackend::new(width, height)).expect("a backend in memory");
    terminal.draw(|frame| draw(frame, look, Palette::Colours, message)).expect("a backend in memory");
    terminal.backend().to_string()
}

fn stopped() -> Look {
    look(json!({
        "mode": "STOP", "paused": true, "forced": [{ "name": "Q 0.0", "shown": "1" }], "forced_count": 1,
        "stop": { "text": "OB 122 is missing; STOP by a programming error (FC 5, statement 3)", "file": "main.awl", "line": 12 },
    }))
}

#[test]
fn a_run_fits_into_a_small_terminal() {
    insta::assert_snapshot!(shown(&look(json!({})), (80, 24), None));
}

#[test]
fn a_stop_shows_its_cause() {
    insta::assert_snapshot!(shown(&stopped(), (80, 24), Some("the CPU is in RUN already")));
}

#[test]
fn a_larger_terminal_has_room_for_values() {
    insta::assert_snapshot!(shown(&stopped(), (130, 30), None));
}

#[test]
fn clients_of_servers_are_listed_and_many_are_counted() {
    let client = |port: u16| json!({ "protocol": "S7", "peer": format!("10.0.0.9:{port}"), "partner": "PG", "connected_ms": 61_000.0, "last": "read", "pdu": 240 });
    let few = look(json!({ "clients": [client(50_001)] }));
    let screen = shown(&few, (80, 24), None);
    assert!(screen.contains("S7  10.0.0.9:50001         PG     read            for 1:01.0 min"), "{screen}");
    assert!(few.text().contains("Clients:\n  S7  10.0.0.9:50001"), "{}", few.text());
    let many = look(json!({ "clients": (0..9).map(client).collect::<Vec<_>>() }));
    let screen = shown(&many, (130, 40), None);
    assert!(screen.contains(" Clients · 4 of 9 "), "{screen}");
    assert!(!shown(&look(json!({})), (130, 40), None).contains("Clients"));
}

#[test]
fn the_picture_in_the_documentation_is_what_the_screen_shows() {
    let page = include_str!("../../../../docs/how-to/watch-a-run.md");
    let picture = page.split("```text\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a picture on the page");
    let mut look = look(json!({ "scans": 218, "time_ms": 2_180.0 }));
    look.bytes = BYTES.into_iter().map(|name| (name, Some(u8::from(name.ends_with("B0"))))).collect();
    let screen = shown(&look, (80, 24), None);
    let shown: Vec<&str> = screen.lines().map(|line| line.trim_matches('"').trim_end()).collect();
    let picture: Vec<&str> = picture.lines().collect();
    assert_eq!(picture, shown[..picture.len()]);
}

#[test]
fn every_size_can_be_drawn() {
    for width in [1, 20, 79, 80, 81, 119, 120, 200, 400] {
        for height in [1, 5, 23, 24, 25, 50, 120] {
            shown(&look(json!({})), (width, height), None);
            shown(&stopped(), (width, height), Some("a message"));
            shown(&Look::default(), (width, height), None);
        }
    }
}

#[test]
fn every_key_has_its_meaning() {
    for (key, meant) in [
        (Key::Plain(KeyCode::Char('q')), Some(Command::Quit)),
        (Key::Leave, Some(Command::Quit)),
        (Key::Plain(KeyCode::Esc), Some(Command::Quit)),
        (Key::Plain(KeyCode::Char('s')), Some(Command::Stop)),
        (Key::Plain(KeyCode::Char('R')), Some(Command::Run)),
        (Key::Plain(KeyCode::Char('p')), Some(Command::Pause)),
        (Key::Plain(KeyCode::Char('g')), Some(Command::Go)),
        (Key::Plain(KeyCode::Char('n')), Some(Command::OneScan)),
        (Key::Plain(KeyCode::Char('+')), Some(Command::Faster)),
        (Key::Plain(KeyCode::Char('-')), Some(Command::Slower)),
        (Key::Plain(KeyCode::Enter), None),
    ] {
        assert_eq!(command(key), meant, "{key:?}");
    }
}

#[test]
fn one_look_is_an_object_with_values_by_name() {
    let json = look(json!({ "id": 7 })).json();
    assert_eq!(json["id"], Value::Null);
    assert_eq!(
        (&json["values"]["IB0"], &json["values"]["IB2"], &json["values"]["MW10"]),
        (&json!("16#A5"), &Value::Null, &json!("16#0005"))
    );
    assert_eq!((&json["values"]["DB1.speed"], &json["block_count"], &json["mode"]), (&Value::Null, &json!(2_000), &json!("RUN")));
}
