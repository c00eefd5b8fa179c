//! Who is connected to a run with a page, and that connections that only wait keep no others out: real processes, real sockets.
#![cfg(unix)]

mod command;
mod pages;

use std::io::{Read, Write};
use std::net::TcpStream;
use std::process::Command;
use std::time::{Duration, Instant};

use command::{Folder, until};
use pages::Serving;
use pages::socket::PING;
use serde_json::{Value, json};

const PROGRAM: &str = "ORGANIZATION_BLOCK OB 1\nBEGIN\nL MW 10;\nL 1;\n+I;\nT MW 10;\nEND_ORGANIZATION_BLOCK\n";

fn project() -> Folder {
    let symbols = "symbol,address,type,comment\nSetpoint,MW 20,INT,\n";
    Folder::with(&[("sieben.toml", "[project]\nname = \"pump\"\n"), ("main.awl", PROGRAM), ("symbols.csv", symbols)])
}

/// An answer of the S7 server.
fn asked(stream: &mut TcpStream, telegram: &[u8]) -> Vec<u8> {
    stream.write_all(telegram).expect("it reads");
    let mut head = [0; 4];
    stream.read_exact(&mut head).expect("an answer");
    let mut rest = vec![0; usize::from(u16::from_be_bytes([head[2], head[3]])) - head.len()];
    stream.read_exact(&mut rest).expect("an answer");
    rest
}

/// An S7 client that has written 16#0005 to MW 20.
fn writer(serving: &Serving) -> TcpStream {
    let mut client = TcpStream::connect(serving.s7.expect("an S7 server")).expect("it accepts");
    // Connect, set up, write 16#0005 as two bytes from MB 20 on.
    let connect = [3, 0, 0, 22, 17, 0xE0, 0, 0, 0, 1, 0, 0xC0, 1, 10, 0xC1, 2, 1, 0, 0xC2, 2, 1, 2];
    let set_up = [3, 0, 0, 25, 2, 0xF0, 0x80, 0x32, 1, 0, 0, 0, 1, 0, 8, 0, 0, 0xF0, 0, 0, 1, 0, 1, 0, 240];
    let write = [
        3, 0, 0, 37, 2, 0xF0, 0x80, 0x32, 1, 0, 0, 0, 2, 0, 14, 0, 6, 5, 1, 0x12, 10, 0x10, 2, 0, 2, 0, 0, 0x83, 0, 0, 160, 0, 4, 0, 16, 0,
        5,
    ];
    asked(&mut client, &connect);
    asked(&mut client, &set_up);
    let answer = asked(&mut client, &write);
    assert_eq!(answer.last(), Some(&0xFF), "{answer:?}");
    client
}

#[test]
fn a_client_is_seen_with_what_it_wrote_last() {
    let folder = project();
    let serving = Serving::usual(&folder);
    let mut page = serving.page("");
    page.say(&json!({ "t": "sub", "id": "c", "what": "clients" }));
    page.until("the clients", |message| message["s"]["c"].is_array());
    let wrote = Instant::now();
    let client = writer(&serving);
    let peer = client.local_addr().expect("an address").to_string();
    let scan = serving.json("GET", "/api/v1/state", "")["scans"].as_u64().expect("scans");
    let row = |list: &Value| list.as_array().into_iter().flatten().find(|row| row["peer"] == *peer && row["last"].is_object()).cloned();
    let seen = page.until("the client", |message| row(&message["s"]["c"]).is_some());
    let took = wrote.elapsed();
    let client_row = row(&seen["s"]["c"]).expect("it is there");
    assert!(took < Duration::from_secs(5), "{took:?}");
    let last = &client_row["last"];
    assert_eq!((client_row["protocol"].as_str(), client_row["writes"].as_u64()), (Some("S7"), Some(1)), "{client_row}");
    assert_eq!((last["name"].as_str(), last["symbol"].as_str(), last["to"].as_str()), (Some("MW 20"), Some("Setpoint"), Some("16#0005")));
    assert!(last["n"].as_u64().is_some_and(|n| n > 0 && n <= scan) && last["t_us"].as_u64() > Some(0), "{last}");
    let own = seen["s"]["c"].as_array().expect("a list").iter().find(|row| row["role"] == "program").expect("this page");
    assert!(own["peer"].as_str().is_some_and(|peer| peer.starts_with("page 127.0.0.1:")), "{own}");
    assert_eq!(serving.json("GET", "/api/v1/clients", "").as_array().expect("a list").len(), 2);
    // Pages are no connections that a STOP would ask about.
    let state = serving.json("GET", "/api/v1/state", "");
    assert_eq!((state["clients"].as_array().map(Vec::len), state["connections"].as_u64()), (Some(1), Some(0)), "{state}");
    assert_eq!(state["clients"][0]["written"]["name"], "MW 20");
    assert_eq!(state["page"], json!(format!("http://{}/", serving.page)));
    drop(client);
    page.until("it has gone", |message| message["s"]["c"].as_array().is_some_and(|list| list.len() == 1));
}

#[test]
fn connections_that_only_wait_keep_nobody_out() {
    let folder = project();
    let serving = Serving::usual(&folder);
    let mut page = serving.page("");
    page.until("a scan", |message| message["t"] == "scan");
    // Heads that never end, one byte at a time, and such that have not begun.
    let mut slow: Vec<TcpStream> = (0..300).map(|_| serving.connect()).collect();
    for (number, stream) in slow.iter_mut().enumerate() {
        if number % 2 == 0 {
            let _ = stream.write_all(b"GET / HTTP/1.1\r\nHost: ");
        }
    }
    let begin = Instant::now();
    for _ in 0..20 {
        let (status, _, text) = serving.ask("GET", "/", "", "");
        assert!(status == 200 && text.contains("<title>"), "{text}");
        slow.iter_mut().for_each(|stream| drop(stream.write(b"x")));
    }
    let mut other = serving.page("");
    other.until("a scan", |message| message["t"] == "scan");
    page.until("a scan", |message| message["t"] == "scan");
    assert!(begin.elapsed() < Duration::from_secs(20), "{:?}", begin.elapsed());
    // A browser that has a free connection may go on with it.
    let mut kept = serving.connect();
    let request = format!("GET /api/v1/state HTTP/1.1\r\nHost: {}\r\n\r\n", serving.page);
    for _ in 0..2 {
        kept.write_all(request.as_bytes()).expect("it reads");
        let mut buffer = [0; 16 * 1024];
        let count = kept.read(&mut buffer).expect("an answer");
        assert!(buffer[..count].starts_with(b"HTTP/1.1 200"), "it answers");
    }
    // Those that were too many are gone.
    let is_gone = |stream: &mut TcpStream| {
        stream.set_read_timeout(Some(Duration::from_millis(1))).expect("a timeout");
        !matches!(stream.read(&mut [0; 512]), Err(error) if error.kind() == std::io::ErrorKind::WouldBlock)
    };
    let gone = slow.iter_mut().map(is_gone).filter(|gone| *gone).count();
    assert!(gone >= 150, "{gone}");
}

#[test]
fn a_page_that_wants_nothing_goes_when_it_answers_nothing() {
    let folder = project();
    let serving = Serving::usual(&folder);
    let (mut there, mut gone) = (serving.page(""), serving.page(""));
    for page in [&mut there, &mut gone] {
        page.say(&json!({ "t": "rate", "hz": 0 }));
    }
    let answering = std::thread::spawn(move || while there.next().is_some() {});
    let begin = Instant::now();
    let mut pings = 0;
    // It reads and answers nothing, as a computer that went to sleep.
    while let Some((kind, _)) = gone.next_frame() {
        pings += u32::from(kind == PING);
    }
    assert!(pings == 1 && begin.elapsed() < Duration::from_secs(60), "{pings} {:?}", begin.elapsed());
    until("one page is left", || (serving.json("GET", "/api/v1/clients", "").as_array()?.len() == 1).then_some(()));
    drop(serving);
    answering.join().expect("it ends with the server");
}

#[test]
fn a_body_that_does_not_come_is_not_waited_for() {
    let folder = project();
    let serving = Serving::usual(&folder);
    let mut stream = serving.connect();
    let head = format!("POST /api/v1/mode HTTP/1.1\r\nHost: {}\r\nConnection: close\r\nContent-Length: 100\r\n\r\n{{", serving.page);
    stream.write_all(head.as_bytes()).expect("it reads");
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("an answer");
    assert!(answer.starts_with("HTTP/1.1 400") && answer.contains("P7131"), "{answer}");
}

#[test]
fn a_server_that_was_killed_begins_again_at_the_same_port() {
    let folder = project();
    let mut serving = Serving::usual(&folder);
    let mut page = serving.page("");
    page.until("a scan", |message| message["t"] == "scan");
    serving.child.kill().expect("it is ours");
    serving.child.wait().expect("it ends");
    // The connection is still there for the system.
    let again = Serving::new(&folder, &["--page", &serving.page.to_string()]);
    assert_eq!(again.page, serving.page);
    until("a page comes back", || again.page("").until("a scan", |message| message["t"] == "scan")["n"].as_u64());
}

#[test]
fn a_run_with_pages_ends_at_once() {
    let folder = project();
    let mut serving = Serving::usual(&folder);
    let mut pages: Vec<_> = (0..5).map(|_| serving.page("")).collect();
    for page in &mut pages {
        page.say(&json!({ "t": "sub", "id": "r", "what": "rows", "block": "OB1", "from": 0, "to": 20 }));
        page.until("rows", |message| message["s"]["r"].is_array());
    }
    let begin = Instant::now();
    let killed = Command::new("kill").args(["-INT", &serving.child.id().to_string()]).status().expect("kill exists");
    assert!(killed.success() && serving.child.wait().expect("it ends").success());
    let took = begin.elapsed();
    assert!(took < Duration::from_secs(3), "{took:?}");
    for page in &mut pages {
        assert_eq!(page.until("a farewell", |message| message["t"] == "bye")["why"], "P7094");
    }
}
