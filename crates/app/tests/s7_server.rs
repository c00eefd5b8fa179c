//! The server for S7 clients: real processes, real sockets, telegrams of our own.
#![cfg(unix)]

mod command;

use std::fs;
use std::io::{BufRead, BufReader, ErrorKind, Read, Write};
use std::net::{Ipv4Addr, SocketAddr, SocketAddrV4, TcpListener, TcpStream};
use std::os::unix::net::UnixStream;
use std::process::{Child, ChildStdout, Command, Stdio};
use std::time::{Duration, Instant};

use command::{DEADLINE, Folder, sieben, until};
use rustix::net::{AddressFamily, SocketType};
use serde_json::Value;

/// Counts scans in MW 10, copies MW 100 to MW 102, and goes to STOP when M 50.0 is set.
const PROGRAM: &str = "
DATA_BLOCK DB 1
STRUCT
 n : INT := 5;
 b : ARRAY [0 .. 399] OF BYTE;
END_STRUCT;
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
L MW 10; L 1; +I; T MW 10;
L MW 100; T MW 102;
A M 50.0; CC FC 2;
END_ORGANIZATION_BLOCK
FUNCTION FC 2 : VOID
BEGIN
CALL SFC 46;
END_FUNCTION
";

/// Areas of the protocol.
const MEMORY: u8 = 0x83;
const DATA: u8 = 0x84;

/// A run with a server. It is ended when this goes.
struct Running {
    child: Child,
    stdout: BufReader<ChildStdout>,
    address: SocketAddr,
}

fn project(servers: &str) -> Folder {
    let settings = format!("[project]\nname = \"plant\"\nsources = [\"*.awl\"]\n{servers}");
    Folder::with(&[("sieben.toml", &settings), ("main.awl", PROGRAM)])
}

fn start(folder: &Folder, arguments: &[&str]) -> Child {
    let runtime = folder.path().join("runtime");
    fs::create_dir_all(&runtime).expect("the folder is writable");
    let mut command = sieben(folder.path(), arguments);
    command.env("XDG_RUNTIME_DIR", runtime).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the binary starts")
}

impl Running {
    /// Serves the project in a folder, at a port that the system chooses.
    fn of(folder: &Folder, more: &[&str]) -> Self {
        let arguments: Vec<&str> = ["serve", ".", "--json", "--s7", "127.0.0.1:0"].iter().chain(more).copied().collect();
        Self::started(start(folder, &arguments))
    }

    fn started(mut child: Child) -> Self {
        let mut stdout = BufReader::new(child.stdout.take().expect("a pipe"));
        let mut line = String::new();
        stdout.read_line(&mut line).expect("UTF-8");
        let listening: Value = serde_json::from_str(&line).unwrap_or_else(|error| {
            let mut stderr = String::new();
            let _ = child.stderr.take().map(|mut messages| messages.read_to_string(&mut stderr));
            panic!("{error}: {line}{stderr}")
        });
        let address = listening["listening"]["s7"].as_str().expect("an address").parse().expect("an address");
        Self { child, stdout, address }
    }

    fn client(&self) -> Client {
        let mut client = Client::of(TcpStream::connect(self.address).expect("the server accepts"));
        client.set_up();
        client
    }

    /// Ends it as a service manager does; exit code and result.
    fn end(mut self) -> (Option<i32>, Value) {
        self.signal("-TERM");
        let mut line = String::new();
        self.stdout.read_line(&mut line).expect("UTF-8");
        let code = self.child.wait().expect("the binary ends").code();
        (code, serde_json::from_str(&line).unwrap_or_else(|error| panic!("{error}: {line}")))
    }

    fn signal(&self, signal: &str) {
        let killed = Command::new("kill").args([signal, &self.child.id().to_string()]).status().expect("kill exists");
        assert!(killed.success());
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A client that speaks the protocol.
struct Client {
    stream: TcpStream,
    reference: u16,
}

/// What the end of a connection looks like.
#[derive(Debug, PartialEq, Eq)]
enum End {
    InOrder,
    Reset,
}

impl Client {
    fn of(stream: TcpStream) -> Self {
        stream.set_read_timeout(Some(DEADLINE)).expect("a timeout");
        stream.set_nodelay(true).expect("an option");
        Self { stream, reference: 0 }
    }

    fn send(&mut self, bytes: &[u8]) {
        self.stream.write_all(bytes).expect("the server reads");
    }

    /// The next frame, or how the connection ended.
    fn receive(&mut self) -> Result<Vec<u8>, End> {
        let mut head = [0; 4];
        let ended = |error: std::io::Error| match error.kind() {
            ErrorKind::UnexpectedEof => End::InOrder,
            ErrorKind::ConnectionReset => End::Reset,
            _ => panic!("{error}"),
        };
        self.stream.read_exact(&mut head).map_err(ended)?;
        let length = usize::from(u16::from_be_bytes([head[2], head[3]]));
        let mut frame = head.to_vec();
        frame.resize(length, 0);
        self.stream.read_exact(&mut frame[4..]).map_err(ended)?;
        Ok(frame)
    }

    fn ask(&mut self, frame: &[u8]) -> Vec<u8> {
        self.send(frame);
        self.receive().expect("an answer")
    }

    /// Connects as a programming device, with slot 2, and agrees on PDUs of 240 bytes.
    fn set_up(&mut self) {
        let confirmed = self.ask(&CONNECT);
        assert_eq!(confirmed[5], 0xD0);
        let setup = self.ask(&job(1, &[0xF0, 0, 0, 1, 0, 1, 1, 0xE0], &[]));
        assert_eq!(setup[setup.len() - 2..], [0, 240]);
    }

    fn next(&mut self) -> u16 {
        self.reference = self.reference.wrapping_add(1);
        self.reference
    }

    /// Reads bytes of an area: what follows the return code, or the code.
    fn read(&mut self, area: u8, db: u16, byte: u32, count: u16) -> Result<Vec<u8>, u8> {
        let reference = self.next();
        let answer = self.ask(&job(reference, &read_request(area, db, byte, count), &[]));
        assert_eq!(answer[11..13], reference.to_be_bytes());
        if answer[21] == 0xFF { Ok(answer[25..].to_vec()) } else { Err(answer[21]) }
    }

    /// Writes bytes; the return code.
    fn write(&mut self, area: u8, db: u16, byte: u32, bytes: &[u8]) -> u8 {
        let mut request = read_request(area, db, byte, bytes.len() as u16);
        request[0] = 5;
        let mut data = vec![0, 4];
        data.extend((bytes.len() as u16 * 8).to_be_bytes());
        data.extend(bytes);
        let reference = self.next();
        let answer = self.ask(&job(reference, &request, &data));
        answer[21]
    }

    /// Reads until the end.
    fn end(mut self) -> End {
        loop {
            if let Err(end) = self.receive() {
                return end;
            }
        }
    }
}

const CONNECT: [u8; 22] = [3, 0, 0, 22, 17, 0xE0, 0, 0, 0, 1, 0, 0xC0, 1, 10, 0xC1, 2, 1, 0, 0xC2, 2, 1, 2];

fn job(reference: u16, parameters: &[u8], data: &[u8]) -> Vec<u8> {
    let length = 17 + parameters.len() + data.len();
    let mut frame = vec![3, 0];
    frame.extend((length as u16).to_be_bytes());
    frame.extend([2, 0xF0, 0x80, 0x32, 1, 0, 0]);
    frame.extend(reference.to_be_bytes());
    frame.extend((parameters.len() as u16).to_be_bytes());
    frame.extend((data.len() as u16).to_be_bytes());
    frame.extend(parameters);
    frame.extend(data);
    frame
}

fn read_request(area: u8, db: u16, byte: u32, count: u16) -> Vec<u8> {
    let mut request = vec![4, 1, 0x12, 10, 0x10, 2];
    request.extend(count.to_be_bytes());
    request.extend(db.to_be_bytes());
    request.push(area);
    request.extend(&(byte * 8).to_be_bytes()[1..]);
    request
}

/// Connects from one of the addresses of this computer, 127.0.0.N.
fn connect_from(number: u8, to: SocketAddr) -> TcpStream {
    let SocketAddr::V4(to) = to else { panic!("{to}") };
    let socket = rustix::net::socket(AddressFamily::INET, SocketType::STREAM, None).expect("a socket");
    rustix::net::bind(&socket, &SocketAddrV4::new(Ipv4Addr::new(127, 0, 0, number), 0)).expect("an address of this computer");
    rustix::net::connect(&socket, &to).expect("the server accepts");
    socket.into()
}

#[test]
fn variables_are_read_and_written_while_the_program_runs() {
    let folder = project("");
    let running = Running::of(&folder, &[]);
    let mut client = running.client();
    assert_eq!(client.read(DATA, 1, 0, 2), Ok(vec![0, 5]));
    assert_eq!(client.write(MEMORY, 0, 100, &[0x12, 0x34]), 0xFF);
    until("the program copies the word", || (client.read(MEMORY, 0, 102, 2) == Ok(vec![0x12, 0x34])).then_some(()));
    let before = client.read(MEMORY, 0, 10, 2);
    until("the program scans", || (client.read(MEMORY, 0, 10, 2) != before).then_some(()));
    assert_eq!(client.read(DATA, 2, 0, 2), Err(0x0A));
    assert_eq!(client.read(DATA, 1, 401, 2), Err(0x05));
    let (code, result) = running.end();
    assert_eq!((code, &result["mode"]), (Some(0), &Value::from("RUN")));
    assert_eq!(client.end(), End::InOrder);
}

#[test]
fn it_does_not_matter_how_the_bytes_come() {
    let folder = project("");
    let running = Running::of(&folder, &[]);
    let mut client = Client::of(TcpStream::connect(running.address).expect("the server accepts"));
    let read = |reference| job(reference, &read_request(DATA, 1, 0, 2), &[]);
    let setup = job(1, &[0xF0, 0, 0, 1, 0, 1, 1, 0xE0], &[]);
    for byte in CONNECT.iter().chain(&setup).chain(&read(2)) {
        client.send(&[*byte]);
    }
    for _ in 0..3 {
        client.receive().expect("an answer");
    }
    // Many in one piece, and half of one at the end: each has its answer, in order.
    let mut glued: Vec<u8> = (0..50).flat_map(read).collect();
    let half = glued.split_off(glued.len() - 10);
    client.send(&glued);
    for reference in 0..49_u16 {
        assert_eq!(client.receive().expect("an answer")[11..13], reference.to_be_bytes());
    }
    client.send(&half);
    assert_eq!(client.receive().expect("an answer")[11..13], 49_u16.to_be_bytes());
}

#[test]
fn what_is_no_telegram_ends_its_own_connection_only() {
    let folder = project("");
    let running = Running::of(&folder, &[]);
    let mut other = running.client();
    let too_early = job(1, &read_request(DATA, 1, 0, 2), &[]);
    for garbage in [&b"GET / HTTP/1.1\r\n\r\n"[..], &[3, 0, 0, 3], &[0xFF; 2_000], &too_early] {
        let mut client = Client::of(TcpStream::connect(running.address).expect("the server accepts"));
        client.send(garbage);
        assert_eq!(client.receive(), Err(End::InOrder), "{garbage:?}");
        assert_eq!(other.read(DATA, 1, 0, 2), Ok(vec![0, 5]));
    }
    // Half a telegram holds up no other client.
    let mut half = Client::of(TcpStream::connect(running.address).expect("the server accepts"));
    half.send(&CONNECT[..9]);
    assert_eq!(other.read(DATA, 1, 0, 2), Ok(vec![0, 5]));
    assert_eq!(running.end().0, Some(0));
    assert_eq!(half.end(), End::InOrder);
}

#[test]
fn two_hundred_connections_are_served_or_refused_and_leave_room_again() {
    let folder = project("");
    let running = Running::of(&folder, &[]);
    let (mut served, mut refused) = (Vec::new(), 0);
    for number in 0..200 {
        let mut client = Client::of(connect_from(1 + number % 8, running.address));
        client.send(&CONNECT);
        match client.receive().expect("an answer")[5] {
            0xD0 => served.push(client),
            code => {
                assert_eq!(code, 0x80);
                assert_eq!(client.end(), End::InOrder);
                refused += 1;
            }
        }
    }
    assert_eq!((served.len(), refused), (64, 136));
    for client in &mut served {
        client.ask(&job(1, &[0xF0, 0, 0, 1, 0, 1, 1, 0xE0], &[]));
        assert_eq!(client.read(DATA, 1, 0, 2), Ok(vec![0, 5]));
    }
    drop(served);
    until("the server has room again", || {
        let mut client = Client::of(TcpStream::connect(running.address).expect("the server accepts"));
        client.send(&CONNECT);
        (client.receive().expect("an answer")[5] == 0xD0).then_some(())
    });
}

#[test]
fn one_address_takes_half_of_the_connections() {
    let folder = project("");
    let running = Running::of(&folder, &[]);
    let code = |number| {
        let mut client = Client::of(connect_from(number, running.address));
        client.send(&CONNECT);
        (client.receive().expect("an answer")[5], client)
    };
    let clients: Vec<_> = (0..33).map(|_| code(1)).collect();
    assert_eq!(clients.iter().filter(|(code, _)| *code == 0xD0).count(), 32);
    assert_eq!(code(2).0, 0xD0);
}

#[test]
fn a_configured_limit_of_connections_holds() {
    let folder = project("[servers.s7]\nmax_connections = 1\n");
    let running = Running::of(&folder, &[]);
    let first = running.client();
    let mut second = Client::of(TcpStream::connect(running.address).expect("the server accepts"));
    second.send(&CONNECT);
    assert_eq!(second.receive().expect("an answer")[5], 0x80);
    drop(first);
}

#[test]
fn who_never_reads_holds_up_nothing() {
    let folder = project("");
    let running = Running::of(&folder, &[]);
    let mut greedy = running.client();
    greedy.stream.set_nonblocking(true).expect("an option");
    let requests: Vec<u8> = (0..2_000).flat_map(|reference| job(reference, &read_request(DATA, 1, 0, 222), &[])).collect();
    let mut other = running.client();
    let (mut sent, mut full_since) = (0_usize, None);
    // As much as the two sockets and the server take: then nothing more is read.
    until("the server stops reading", || {
        assert_eq!(other.read(DATA, 1, 0, 2), Ok(vec![0, 5]));
        match greedy.stream.write(&requests[sent % requests.len()..]) {
            Ok(count) => {
                (sent, full_since) = (sent + count, None);
                assert!(sent < 256 * 1024 * 1024, "the server reads without end");
                None
            }
            Err(error) if error.kind() == ErrorKind::WouldBlock => {
                let since = *full_since.get_or_insert_with(Instant::now);
                (since.elapsed() > Duration::from_millis(500)).then_some(())
            }
            Err(error) => panic!("{error}"),
        }
    });
    assert_eq!(other.read(DATA, 1, 0, 2), Ok(vec![0, 5]));
}

#[test]
fn a_cpu_in_stop_is_still_served_and_the_run_stays_up() {
    let folder = project("");
    let running = Running::of(&folder, &[]);
    let mut client = running.client();
    let mut waiting = running.client();
    assert_eq!(client.write(MEMORY, 0, 50, &[1]), 0xFF);
    let count = until("the CPU goes to STOP", || {
        let before = client.read(MEMORY, 0, 10, 2);
        std::thread::sleep(Duration::from_millis(100));
        (client.read(MEMORY, 0, 10, 2) == before).then_some(before)
    });
    assert_eq!(waiting.read(MEMORY, 0, 10, 2), count);
    assert_eq!(waiting.write(MEMORY, 0, 100, &[0x56, 0x78]), 0xFF);
    let mut late = running.client();
    assert_eq!(late.read(MEMORY, 0, 100, 2), Ok(vec![0x56, 0x78]));
    let (code, result) = running.end();
    assert_eq!((code, &result["mode"]), (Some(0), &Value::from("STOP")));
}

#[test]
fn with_an_end_of_its_own_a_stop_is_the_result() {
    let folder = project("");
    folder.write("main.awl", PROGRAM.replace("A M 50.0; CC FC 2;", "CALL FC 2;").as_bytes());
    folder.run(&["run", ".", "--s7", "127.0.0.1:0", "--for", "1h"]).code(4).stderr("S7 clients are served at 127.0.0.1:");
}

#[test]
fn an_address_of_this_computer_alone_needs_no_more_and_every_other_one_does() {
    let folder = project("");
    folder.run(&["run", ".", "--s7", "0.0.0.0:0", "--for", "10ms"]).code(2).stderr("P7100").stderr("--expose s7=0.0.0.0:0");
    folder
        .run(&["run", ".", "--s7", "0.0.0.0:0", "--expose", "s7=0.0.0.0:1", "--for", "10ms"])
        .code(2)
        .stderr("what `--expose` names is 0.0.0.0:1");
    folder
        .run(&["run", ".", "--s7", "127.0.0.1:0", "--expose", "s7=0.0.0.0:1", "--for", "10ms"])
        .code(2)
        .stderr("for this computer alone, but what `--expose` names is 0.0.0.0:1");
    folder.run(&["run", ".", "--expose", "s7=0.0.0.0:0", "--for", "10ms"]).code(0).stderr("Other computers reach it");
    folder.run(&["run", "--s7", ".", "--expose", "modbus=0.0.0.0:0"]).code(2).stderr("there is no server `modbus`");
    folder.run(&["run", "--s7", "nowhere"]).code(2).stderr("neither an address nor a file or folder");
    let exposed = project("[servers.s7]\nlisten = \"0.0.0.0:0\"\n");
    exposed.run(&["serve", ".", "--for", "10ms"]).code(2).stderr("P7100");
    exposed.run(&["serve", ".", "--expose", "s7=0.0.0.0:0", "--for", "10ms"]).code(0);
}

#[test]
fn the_demo_is_served_at_the_next_port_that_is_free() {
    let folder = Folder::new();
    let start = || {
        let mut command = sieben(folder.path(), &["demo", "--s7"]);
        command.env("XDG_RUNTIME_DIR", folder.path()).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("the binary starts")
    };
    // The first one may find the usual port taken already, the second one certainly does.
    let mut demos: Vec<Child> = vec![start()];
    let address = |child: &mut Child| {
        let mut messages = BufReader::new(child.stderr.take().expect("a pipe"));
        let mut line = String::new();
        while !line.contains("S7 clients are served at ") {
            line.clear();
            assert!(messages.read_line(&mut line).expect("UTF-8") > 0, "the demo has ended");
        }
        let text = line.split("served at ").nth(1).and_then(|rest| rest.split(',').next()).expect("an address");
        text.parse::<SocketAddr>().expect("an address")
    };
    let first = address(&mut demos[0]);
    demos.push(start());
    let second = address(&mut demos[1]);
    assert!(second.port() > first.port() && first.port() >= 1102);
    for to in [first, second] {
        let mut client = Client::of(TcpStream::connect(to).expect("the demo accepts"));
        client.set_up();
        assert!(client.read(0x82, 0, 0, 1).is_ok());
    }
    for mut demo in demos {
        let _ = demo.kill();
        let _ = demo.wait();
    }
}

#[test]
fn a_socket_that_was_handed_over_is_served() {
    let folder = project("");
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = listener.local_addr().expect("an address");
    rustix::io::fcntl_setfd(&listener, rustix::io::FdFlags::empty()).expect("a handle that is inherited");
    let script = format!(
        "exec 3<&{}; LISTEN_PID=$$ LISTEN_FDS=1 exec '{}' serve . --json",
        std::os::fd::AsRawFd::as_raw_fd(&listener),
        env!("CARGO_BIN_EXE_sieben")
    );
    let mut shell = Command::new("sh");
    shell.args(["-c", &script]).current_dir(folder.path()).env("LC_ALL", "C").env("XDG_RUNTIME_DIR", folder.path()).stdout(Stdio::piped());
    let running = Running::started(shell.spawn().expect("a shell"));
    assert_eq!(running.address, address);
    assert_eq!(running.client().read(DATA, 1, 0, 2), Ok(vec![0, 5]));
}

#[test]
fn an_address_that_is_taken_or_elsewhere_is_a_message_with_what_to_do() {
    let folder = project("");
    let taken = TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = taken.local_addr().expect("an address").to_string();
    folder
        .run(&["run", ".", "--s7", &address, "--for", "10ms"])
        .code(2)
        .stderr("P7101")
        .stderr("choose another port: `--s7 127.0.0.1:1102`");
    let elsewhere = "192.0.2.1:1102";
    let expose = format!("s7={elsewhere}");
    folder.run(&["run", ".", "--expose", &expose, "--for", "10ms"]).code(2).stderr("P7102").stderr("no address of this computer");
}

#[test]
fn what_the_project_says_wrongly_of_its_server_is_said() {
    let folder = project("[servers.s7]\nprotection = 9\naudit = \"../log\"\nprot = 102\n");
    folder.run(&["serve", ".", "--for", "10ms"]).code(3).stderr("P6009").stderr("`protection` is a level").stderr("there is no key `prot`");
}

#[test]
fn what_was_done_and_what_was_sent_is_written_down() {
    let folder = project("[servers.s7]\naudit = \"logs/audit.jsonl\"\npcap = \"logs/s7.pcapng\"\n");
    folder.write("logs/audit.jsonl", b"{\"what\":\"before\"}\n");
    let running = Running::of(&folder, &[]);
    let mut client = running.client();
    assert_eq!(client.write(MEMORY, 0, 100, &[0x12, 0x34]), 0xFF);
    assert_eq!(client.write(DATA, 9, 0, &[1]), 0x0A);
    assert_eq!(running.end().0, Some(0));
    let log = String::from_utf8(folder.read("logs/audit.jsonl")).expect("UTF-8");
    let records: Vec<Value> = log.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let what: Vec<_> = records.iter().map(|record| record["what"].as_str().expect("a word")).collect();
    assert_eq!(what, ["before", "connect", "setup", "write", "write", "close"]);
    assert_eq!(
        (&records[3]["object"], &records[3]["value"], &records[3]["result"]),
        (&"P#M100.0 BYTE 2".into(), &"1234".into(), &"ok".into())
    );
    assert!(records[3]["scan"].is_u64());
    assert_eq!(records[4]["result"], "000A");
    let frames = folder.read("logs/s7.pcapng");
    assert_eq!(frames[..4], [0x0A, 0x0D, 0x0D, 0x0A]);
    let sent = job(3, &read_request(DATA, 9, 0, 1), &[]);
    assert!(frames.windows(8).any(|bytes| bytes == &sent[19..27]), "the request is in the recording");
}

#[test]
fn what_is_done_at_the_control_socket_is_in_the_audit_log_too() {
    let folder = project("[servers.s7]\naudit = \"audit.jsonl\"\n");
    let running = Running::of(&folder, &[]);
    let socket = folder.path().join(".sieben/control.sock");
    let mut stream = until("the run answers", || UnixStream::connect(&socket).ok());
    let mut answers = BufReader::new(stream.try_clone().expect("a handle"));
    for request in [
        r#"{"verb":"write","values":{"MW100":"5"}}"#,
        r#"{"verb":"write","values":{"DB9.DBW0":"5"}}"#,
        r#"{"verb":"force","values":{"Q4.0":"1"}}"#,
        r#"{"verb":"read","items":["MW100"]}"#,
        r#"{"verb":"mode","mode":"stop"}"#,
    ] {
        stream.write_all(format!("{request}\n").as_bytes()).expect("the run reads");
        assert!(answers.read_line(&mut String::new()).expect("UTF-8") > 0);
    }
    assert_eq!(running.end().0, Some(0));
    let log = String::from_utf8(folder.read("audit.jsonl")).expect("UTF-8");
    let record = |line: &str| {
        let record: Value = serde_json::from_str(line).expect("JSON");
        let text = |key: &str| record[key].as_str().unwrap_or("-").to_owned();
        ["peer", "what", "object", "value", "result"].map(text).join(" ")
    };
    let refused = log.lines().map(record).find(|record| record.contains("DB9")).expect("a refusal is noted");
    assert_eq!(
        log.lines().map(record).collect::<Vec<_>>(),
        ["control socket write MW100 5 ok", refused.as_str(), "control socket force Q4.0 1 ok", "control socket stop - - ok"]
    );
    assert!(refused.starts_with("control socket write DB9.DBW0 5 P"), "{refused}");
}

#[test]
fn a_link_leads_no_record_out_of_the_project() {
    let folder = project("[servers.s7]\naudit = \"audit.jsonl\"\n");
    folder.write("elsewhere", b"mine");
    std::os::unix::fs::symlink("elsewhere", folder.path().join("audit.jsonl")).expect("a link");
    folder.run(&["serve", ".", "--s7", "127.0.0.1:0", "--for", "10ms"]).code(2).stderr("P7103").stderr("symbolic link");
    assert_eq!(folder.read("elsewhere"), b"mine");
}

#[test]
fn a_record_takes_no_place_of_a_source() {
    for key in ["audit", "pcap"] {
        let folder = project(&format!("[servers.s7]\n{key} = \"main.awl\"\n"));
        folder
            .run(&["serve", ".", "--s7", "127.0.0.1:0", "--for", "10ms"])
            .code(2)
            .stderr("P7103")
            .stderr("`main.awl`: it is there already");
        assert_eq!(folder.read("main.awl"), PROGRAM.as_bytes());
    }
}

#[test]
fn who_sends_nothing_more_gets_the_answer_of_a_start_and_who_is_gone_is_noted() {
    let folder = project("[servers.s7]\naudit = \"audit.jsonl\"\n");
    let running = Running::of(&folder, &[]);
    let (stop, start) = (job(1, b"\x29\0\0\0\0\0\x09P_PROGRAM", &[]), job(2, b"\x28\0\0\0\0\0\0\xFD\0\0\x09P_PROGRAM", &[]));
    let mut client = running.client();
    assert_eq!(client.ask(&stop)[17..], [0, 0, 0x29]);
    client.send(&start);
    client.stream.shutdown(std::net::Shutdown::Write).expect("a connection");
    assert_eq!(client.receive().expect("the answer")[17..], [0, 0, 0x28]);
    let mut client = running.client();
    assert_eq!(client.ask(&stop)[17..], [0, 0, 0x29]);
    client.send(&start);
    drop(client);
    until("both starts are noted", || {
        let log = String::from_utf8(folder.read("audit.jsonl")).expect("UTF-8");
        (log.matches("\"what\":\"start\"").count() == 2).then_some(())
    });
}

#[test]
fn a_server_that_only_reads_refuses_writing() {
    let folder = project("[servers.s7]\nread_only = true\nallow = [\"DB1\"]\n");
    let running = Running::of(&folder, &[]);
    let mut client = running.client();
    assert_eq!(client.read(DATA, 1, 0, 2), Ok(vec![0, 5]));
    assert_eq!(client.read(MEMORY, 0, 10, 2), Err(3));
    assert_eq!(client.write(DATA, 1, 0, &[1]), 3);
    assert_eq!(client.read(DATA, 1, 0, 2), Ok(vec![0, 5]));
}

#[test]
fn top_tells_who_is_connected() {
    let folder = project("");
    let running = Running::of(&folder, &[]);
    let mut client = running.client();
    assert!(client.read(DATA, 1, 0, 2).is_ok());
    let peer = client.stream.local_addr().expect("an address").to_string();
    let look = until("the run answers", || {
        let output = sieben(folder.path(), &["top", ".", "--json"]).env("XDG_RUNTIME_DIR", folder.path().join("runtime")).output();
        serde_json::from_slice::<Value>(&output.expect("the binary starts").stdout).ok()
    });
    let clients = look["clients"].as_array().expect("a list");
    assert_eq!(clients.len(), 1, "{look}");
    let told = |key: &str| clients[0][key].clone();
    assert_eq!(
        [told("protocol"), told("peer"), told("partner"), told("last")],
        ["S7".into(), peer.into(), Value::from("PG"), "read".into()]
    );
    assert_eq!(told("pdu"), 240);
}

#[test]
fn prometheus_finds_the_numbers() {
    let folder = project("");
    let port = TcpListener::bind("127.0.0.1:0").and_then(|listener| listener.local_addr()).expect("a port");
    let running = Running::of(&folder, &["--metrics", &port.to_string()]);
    let mut client = running.client();
    assert!(client.read(DATA, 1, 0, 2).is_ok());
    let get = |path: &str| {
        let mut stream = TcpStream::connect(port).expect("the run answers");
        stream.write_all(format!("GET {path} HTTP/1.1\r\nHost: x\r\n\r\n").as_bytes()).expect("the run reads");
        let mut answer = String::new();
        stream.read_to_string(&mut answer).expect("UTF-8");
        answer
    };
    let numbers = until("the request and a scan were counted", || {
        let answer = get("/metrics");
        let request = answer.contains("sieben_server_requests_total{protocol=\"s7\",function=\"read\"} 1\n");
        (request && answer.contains("sieben_organization_block_seconds_bucket{block=\"OB 1\",le=\"+Inf\"} ")).then_some(answer)
    });
    assert!(numbers.starts_with("HTTP/1.1 200 OK\r\n"));
    assert!(numbers.contains("sieben_mode{mode=\"run\"} 1\n") && numbers.contains("sieben_server_connections{protocol=\"s7\"} 1\n"));
    assert!(get("/").starts_with("HTTP/1.1 404 "));
    assert_eq!(running.end().0, Some(0));
    folder.run(&["run", ".", "--metrics", "0.0.0.0:0", "--for", "10ms"]).code(2).stderr("P7100").stderr("--expose metrics=0.0.0.0:0");
}

#[test]
fn retentive_data_survives_the_end_of_a_server() {
    let folder = project("");
    let running = Running::of(&folder, &[]);
    let mut client = running.client();
    assert_eq!(client.write(DATA, 1, 0, &[0x11, 0x22]), 0xFF);
    assert_eq!(client.bring(9, &data_block(9, &[1, 2])), 0, "which the sources do not have");
    assert_eq!(running.end().0, Some(0));
    let running = Running::of(&folder, &[]);
    assert_eq!(running.client().read(DATA, 1, 0, 2), Ok(vec![0x11, 0x22]));
}

/// The image of a data block with these values.
fn data_block(number: u8, values: &[u8]) -> Vec<u8> {
    let [bytes, load] = [values.len(), values.len() + 72].map(|length| (length as u32).to_be_bytes());
    let header = [&b"pp\x01\x01\x05\x0A\x00"[..], &[number], &load, &[0; 16], &[0; 6], &bytes[2..]].concat();
    [&header, values, &[0; 36]].concat()
}

impl Client {
    /// Downloads a data block in pieces and links it; the error of the last answer.
    fn bring(&mut self, number: u8, image: &[u8]) -> u16 {
        let announced = format!("\x09_0A{number:05}P\x0D1{:06}{:06}", image.len(), image.len() - 72);
        let reference = self.next();
        let answer = self.ask(&job(reference, &[&[0x1A, 0, 1, 0, 0, 0, 0, 0], announced.as_bytes()].concat(), &[]));
        assert_eq!(answer[17..], [0, 0, 0x1A]);
        for (index, piece) in image.chunks(200).enumerate() {
            let asked = self.receive().expect("the CPU asks for a piece");
            assert_eq!(asked[17], 0x1B);
            let follows = u8::from((index + 1) * 200 < image.len());
            let data = [&(piece.len() as u16).to_be_bytes()[..], &[0, 0xFB], piece].concat();
            self.send(&reply(&asked, &[0x1B, follows], &data));
        }
        let ended = self.receive().expect("the CPU has all of it");
        assert_eq!(ended[17..21], [0x1C, 0, 0, 0]);
        self.send(&reply(&ended, &[0x1C], &[]));
        self.service(number, 'P', "_INSE")
    }

    /// Has a data block linked or deleted; the error of the answer.
    fn service(&mut self, number: u8, place: char, service: &str) -> u16 {
        let arguments = format!("\x01\x000A{number:05}{place}\x05{service}");
        let reference = self.next();
        let answer = self.ask(&job(reference, &[&[0x28, 0, 0, 0, 0, 0, 0, 0xFD, 0, 10], arguments.as_bytes()].concat(), &[]));
        u16::from_be_bytes([answer[17], answer[18]])
    }
}

/// The answer of a client to a job of the CPU.
fn reply(asked: &[u8], parameters: &[u8], data: &[u8]) -> Vec<u8> {
    let mut frame = job(u16::from_be_bytes([asked[11], asked[12]]), parameters, data);
    frame[8] = 3;
    frame.splice(17..17, [0, 0]);
    let length = frame.len() as u16;
    frame[2..4].copy_from_slice(&length.to_be_bytes());
    frame
}

#[test]
fn data_blocks_come_grow_and_go_while_the_program_runs() {
    let folder = project("");
    let running = Running::of(&folder, &["--engine", "jit"]);
    let [mut client, mut other] = [running.client(), running.client()];
    let scans = |client: &mut Client| client.read(MEMORY, 0, 10, 2).map(|bytes| u16::from_be_bytes([bytes[0], bytes[1]]));
    let before = scans(&mut other).expect("MW 10");
    assert_eq!(client.bring(9, &data_block(9, &[1, 2, 3, 4])), 0);
    assert_eq!(other.read(DATA, 9, 0, 4), Ok(vec![1, 2, 3, 4]));
    let longer: Vec<u8> = (0..500).map(|byte| byte as u8).collect();
    assert_eq!(client.bring(1, &data_block(1, &longer)), 0);
    assert_eq!(other.read(DATA, 1, 490, 4), Ok(longer[490..494].to_vec()));
    assert_eq!(client.bring(1, &data_block(1, &[7; 500])), 0);
    assert_eq!(other.read(DATA, 1, 0, 2), Ok(vec![7, 7]));
    assert_eq!(other.read(DATA, 9, 0, 4), Ok(vec![1, 2, 3, 4]), "all other values stay");
    assert!(scans(&mut other).expect("MW 10") > before, "the program has gone on");
    // Those at the control socket know the new one as well.
    let seen = until("the control socket knows DB 9", || {
        let output = sieben(folder.path(), &["top", ".", "--json", "--show", "DB9.DBW 2"])
            .env("XDG_RUNTIME_DIR", folder.path().join("runtime"))
            .output();
        let look = serde_json::from_slice::<Value>(&output.expect("the binary starts").stdout).ok()?;
        Some(look.to_string()).filter(|text| text.contains("0304"))
    });
    assert!(seen.contains("DB9"), "{seen}");
    assert_eq!(client.service(9, 'B', "_DELE"), 0);
    assert_eq!(other.read(DATA, 9, 0, 4), Err(0x0A));
    assert_eq!(client.service(9, 'B', "_DELE"), 0xD209);
    assert_eq!(running.end().0, Some(0));
}
