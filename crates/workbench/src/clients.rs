//! Who is connected: clients of servers with what they wrote last, and pages.

use std::collections::HashMap;
use std::sync::Mutex;

use serde_json::{Value as Json, json};
use sieben_model::address::Operand;
use sieben_workspace::control::{Client, Facts};

use crate::lock;

/// Over so many microseconds requests are counted for a rate.
const RATE_US: u64 = 1_000_000;

/// What a client had asked for at a moment, and how often it asked in a second before that.
#[derive(Clone, Copy, Default)]
struct Counted {
    at_us: u64,
    reads: u64,
    writes: u64,
    reads_per_second: u64,
    writes_per_second: u64,
}

/// How often clients ask.
#[derive(Default)]
pub(crate) struct Rates(Mutex<HashMap<String, Counted>>);

impl Rates {
    /// Reads and writes in a second, of each of these.
    fn of(&self, clients: &[(String, Client)], now_us: u64) -> Vec<(u64, u64)> {
        let mut known = lock(&self.0);
        known.retain(|id, _| clients.iter().any(|(other, _)| other == id));
        let rate = |(id, client): &(String, Client)| {
            let (reads, writes) = (client.reads, client.writes);
            let counted = known.entry(id.clone()).or_insert_with(|| {
                // What it did since it came, however short that is.
                Counted { at_us: now_us.saturating_sub(client.for_us), ..Counted::default() }
            });
            let passed_us = now_us.saturating_sub(counted.at_us);
            if passed_us >= RATE_US || counted.reads_per_second == 0 && counted.writes_per_second == 0 {
                let rate = |now: u64, before: u64| {
                    let per_second = u128::from(now.saturating_sub(before)) * u128::from(RATE_US) / u128::from(passed_us.max(RATE_US));
                    u64::try_from(per_second).unwrap_or(u64::MAX)
                };
                let (reads_per_second, writes_per_second) = (rate(reads, counted.reads), rate(writes, counted.writes));
                if passed_us >= RATE_US {
                    *counted = Counted { at_us: now_us, reads, writes, reads_per_second, writes_per_second };
                }
                return (reads_per_second, writes_per_second);
            }
            (counted.reads_per_second, counted.writes_per_second)
        };
        clients.iter().map(rate).collect()
    }

    /// Clients of servers as pages take them.
    pub(crate) fn json(&self, clients: Vec<Client>, facts: &Facts, now_us: u64) -> Vec<Json> {
        let clients: Vec<(String, Client)> =
            clients.into_iter().map(|client| (format!("{} {}", client.protocol, client.peer), client)).collect();
        let rates = self.of(&clients, now_us);
        let row = |((id, client), (reads, writes)): (&(String, Client), (u64, u64))| {
            let mut row = json!({
                "id": id, "name": client.partner, "protocol": client.protocol, "peer": client.peer,
                "connected_ms": client.for_us as f64 / 1000.0, "request": client.last, "reads": reads, "writes": writes,
            });
            if let Some(last) = &client.written {
                let symbol = Operand::parse(&last.name).and_then(|operand| facts.symbols.find_operand(&operand));
                let symbol = symbol.map_or("", |symbol| &symbol.name);
                row["last"] = json!({ "name": last.name, "symbol": symbol, "n": last.scan, "t_us": last.time_us, "to": last.value });
            }
            row
        };
        clients.iter().zip(rates).map(row).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn client(reads: u64, for_us: u64) -> (String, Client) {
        let client = Client {
            protocol: "S7",
            peer: "127.0.0.1:1".to_owned(),
            partner: None,
            for_us,
            last: None,
            pdu_bytes: None,
            reads,
            writes: 0,
            written: None,
        };
        ("S7 127.0.0.1:1".to_owned(), client)
    }

    #[test]
    fn requests_are_counted_by_the_second() {
        let rates = Rates::default();
        let rate = |reads, for_us, now_us| rates.of(&[client(reads, for_us)], now_us)[0].0;
        assert_eq!(rate(5, 100_000, 10_000_000), 5, "of one that has just come all count");
        assert_eq!(rate(20, 2_000_000, 11_900_000), 10);
        assert_eq!(rate(100, 2_100_000, 12_000_000), 10, "a second is not over");
        assert_eq!(rate(60, 4_000_000, 13_900_000), 20);
        assert_eq!(rate(60, 6_000_000, 15_900_000), 0);
        assert_eq!(rates.of(&[], 16_000_000), []);
        assert!(rates.0.lock().expect("a test").is_empty(), "one that has gone is forgotten");
    }
}
