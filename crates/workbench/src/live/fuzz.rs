//! A page that sends anything: a target of the fuzzer.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use sieben_cpu::OperatingMode;

use super::client::{Client, Live, MESSAGE_BYTES_MAX, bye};
use super::program::Known;
use super::shot::{Head, Shot};

/// Reads the input as messages, one on each line, and answers each of them with a scan of an empty program.
pub fn fuzz(data: &[u8]) {
    let program = Arc::new(Known::new(0, Arc::default()));
    let mut client = Client::default();
    for (number, frame) in (0_u64..).zip(data.split(|&byte| byte == b'\n')) {
        let now_us = number.saturating_mul(30_000);
        if let Err(refusal) = client.hear(frame, now_us) {
            assert!(serde_json::from_str::<serde_json::Value>(&bye(&refusal)).is_ok(), "a farewell is JSON");
            client = Client::default();
            continue;
        }
        let wanted = client.wanted(&program);
        let tags: HashMap<_, _> = wanted.names.iter().map(|name| (name.clone(), number.into())).collect();
        let head = Head { scan: number, mode: OperatingMode::Run, ..Head::default() };
        let shot = Shot {
            head,
            program: Arc::clone(&program),
            sample: None,
            position: None,
            pending: Arc::default(),
            reasons: HashMap::new(),
            flows: HashMap::new(),
            tags,
            common: BTreeMap::new(),
        };
        if let Ok(Some(message)) = client.update(&shot, Live::Yes, now_us) {
            assert!(message.len() <= MESSAGE_BYTES_MAX, "a message has a limit");
            assert!(serde_json::from_str::<serde_json::Value>(&message).is_ok_and(|message| message["n"] == number), "a message is JSON");
        }
    }
}
