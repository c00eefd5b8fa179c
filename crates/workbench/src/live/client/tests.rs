//! Pages in virtual time.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use sieben_cpu::OperatingMode;

use super::super::program::Known;
use super::super::shot::Head;
use super::*;

fn shot(scan: u64) -> Shot {
    Shot {
        head: Head { scan, newest: scan, mode: OperatingMode::Run, same: true, ..Head::default() },
        program: Arc::new(Known::new(0, Arc::default())),
        sample: None,
        position: None,
        pending: Arc::default(),
        reasons: HashMap::new(),
        flows: HashMap::new(),
        tags: HashMap::from([("a".to_owned(), json!(scan)), ("b".to_owned(), json!(scan / 100))]),
        common: BTreeMap::new(),
    }
}

fn page() -> Client {
    let mut client = Client::default();
    hear(&mut client, r#"{"t":"sub","id":"x","what":"tags","names":["a","b"]}"#, 0).expect("it is understood");
    client
}

fn hear(client: &mut Client, text: &str, now_us: u64) -> Result<Option<Asked>, String> {
    client.hear(text.as_bytes(), now_us).map_err(|refusal| format!("{}: {}", refusal.problem.code(), refusal.message))
}

fn update(client: &mut Client, scan: u64, now_us: u64) -> Option<Json> {
    let text = client.update(&shot(scan), Live::Yes, now_us).expect("it is short");
    text.map(|text| serde_json::from_str(&text).expect("JSON"))
}

fn acknowledge(client: &mut Client, message: &Json, now_us: u64) {
    hear(client, &json!({ "t": "ack", "seq": message["seq"] }).to_string(), now_us).expect("it is understood");
}

#[test]
fn a_message_has_what_became_another_since_the_one_before() {
    let mut client = page();
    let first = update(&mut client, 1, 1_000_000).expect("a message");
    assert_eq!((first["s"]["x"].clone(), first["n"].clone(), first["seq"].clone()), (json!({ "a": 1, "b": 0 }), json!(1), json!(1)));
    assert_eq!(update(&mut client, 2, 1_049_999), None, "20 messages a second are enough");
    // What came in between is left out: only the newest counts.
    let second = update(&mut client, 101, 1_050_000).expect("a message");
    assert_eq!((second["s"]["x"].clone(), second["n"].clone()), (json!({ "a": 101, "b": 1 }), json!(101)));
    assert_eq!(update(&mut client, 102, 1_100_000).expect("a message")["s"]["x"], json!({ "a": 102 }));
    assert_eq!(update(&mut client, 102, 1_150_000), None, "nothing is new");
    assert_eq!(update(&mut client, 102, 2_100_000).expect("a sign of life")["s"], json!({}));
}

#[test]
fn a_page_that_takes_nothing_in_gets_one_message_a_second_and_is_gone_in_the_end() {
    let mut client = page();
    let mut sent = Vec::new();
    let mut now_us = 1_000_000;
    while !client.is_gone(now_us) {
        if update(&mut client, now_us, now_us).is_some() {
            sent.push(now_us);
        }
        now_us += 50_000;
    }
    assert_eq!(now_us, 16_000_000);
    let slow: Vec<u64> = sent.iter().copied().filter(|&at| at > 3_000_000).collect();
    assert!(slow.len() <= 13 && sent.len() <= 40 + 14, "{} of {}", slow.len(), sent.len());
    assert!(slow.windows(2).all(|pair| pair[1] - pair[0] >= 1_000_000));
    // What it has missed comes with one message.
    let mut client = page();
    let first = update(&mut client, 1, 0).expect("a message");
    assert!(update(&mut client, 2, 1_000_000).is_some());
    acknowledge(&mut client, &json!({ "seq": 2 }), 2_500_000);
    assert_eq!(first["seq"], 1);
    assert_eq!(update(&mut client, 9, 2_500_000).expect("a message")["s"]["x"], json!({ "a": 9 }));
    assert!(update(&mut client, 10, 2_550_000).is_some(), "it is quick again");
}

#[test]
fn every_limit_is_kept() {
    let mut client = Client::default();
    for number in 0..MESSAGES_PER_SECOND_MAX {
        hear(&mut client, r#"{"t":"ack","seq":0}"#, number as u64).expect("it is one of few");
    }
    assert!(hear(&mut client, r#"{"t":"ack","seq":0}"#, 900_000).is_err_and(|why| why.starts_with("P7130: more than 50 messages")));
    assert_eq!(hear(&mut client, r#"{"t":"ack","seq":0}"#, 1_000_100), Ok(None));

    let mut client = Client::default();
    let subscribe = |client: &mut Client, number: usize, what: &str| {
        hear(client, &format!(r#"{{"t":"sub","id":"{number}",{what}}}"#), number as u64 * 100_000)
    };
    for number in 0..SUBSCRIPTIONS_MAX {
        subscribe(&mut client, number, r#""what":"leds""#).expect("there is room");
    }
    assert!(subscribe(&mut client, 64, r#""what":"leds""#).is_err_and(|why| why.starts_with("P7130: a page has at most 64")));
    subscribe(&mut client, 63, r#""what":"plant""#).expect("another one in the place of one that is there");

    let mut client = Client::default();
    let names = format!(r#""what":"tags","names":[{}]"#, vec![r#""M""#; 1_500].join(","));
    subscribe(&mut client, 0, &names).expect("there is room");
    assert!(
        subscribe(&mut client, 1, &names).is_err_and(|why| why.starts_with("P7130: the subscriptions of a page have at most 2000 names"))
    );

    let mut client = page();
    let mut long = shot(1);
    long.tags.insert("a".to_owned(), json!("x".repeat(MESSAGE_BYTES_MAX)));
    assert!(client.update(&long, Live::Yes, 0).is_err_and(|refusal| refusal.problem.code() == "P7130"));
}

#[test]
fn acknowledgements_that_come_late_and_all_at_once_are_not_too_much() {
    let mut client = page();
    let sent: Vec<_> = (0..30).filter_map(|step| update(&mut client, step, step * 50_000)).collect();
    for number in 1..MESSAGES_PER_SECOND_MAX as u64 {
        hear(&mut client, r#"{"t":"rate","hz":20}"#, 1_500_000 + number).expect("it is one of few");
    }
    for message in &sent {
        acknowledge(&mut client, message, 1_600_000);
    }
    acknowledge(&mut client, &sent[0], 1_600_000);
    assert!(hear(&mut client, &json!({ "t": "ack", "seq": sent[0]["seq"] }).to_string(), 1_600_000).is_err(), "nothing of that is open");
}

#[test]
fn a_page_chooses_how_often_and_none_at_all() {
    let mut client = page();
    hear(&mut client, r#"{"t":"rate","hz":2}"#, 0).expect("it is understood");
    let sent = (0..100_u64).filter(|step| {
        let message = update(&mut client, *step, step * 50_000);
        message.inspect(|message| acknowledge(&mut client, message, step * 50_000)).is_some()
    });
    assert_eq!(sent.count(), 10);
    hear(&mut client, r#"{"t":"rate","hz":0}"#, 5_000_000).expect("it is understood");
    assert_eq!((client.due_us(6_000_000), update(&mut client, 900, 9_000_000)), (None, None));
}

#[test]
fn another_program_is_told_of_and_all_is_sent_again() {
    let mut client = page();
    assert_eq!(client.meets(&shot(1)), None);
    update(&mut client, 1, 0).expect("a message");
    let other = Shot { program: Arc::new(Known::new(1, Arc::default())), ..shot(2) };
    let told: Json = serde_json::from_str(&client.meets(&other).expect("it is another one")).expect("JSON");
    assert_eq!((told["t"].clone(), told["hash"].clone()), (json!("program"), json!(other.program.hash())));
    let text = client.update(&other, Live::Yes, 100_000).expect("it is short").expect("a message");
    assert!(text.contains(r#""x":{"a":2,"b":0}"#), "{text}");
}
