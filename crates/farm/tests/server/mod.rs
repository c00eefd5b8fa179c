//! A NATS server of one's own, and the processes that talk with it; all of them end with the test.
#![allow(clippy::print_stdout)] // A test that is skipped says so.
#![allow(dead_code)] // Each test program uses a part of it.

use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::{Duration, Instant};

/// Far more than any of the tests takes, also on a busy machine.
const DEADLINE: Duration = Duration::from_secs(60);

/// Whether the server is installed; notes that its tests are skipped if not.
pub(crate) fn is_there() -> bool {
    let there = Command::new("nats-server").arg("--version").output().is_ok_and(|output| output.status.success());
    if !there {
        let line = "skipped: nats-server is not installed (`cargo xtask clients`)";
        assert!(std::env::var_os("SIEBEN_NO_SKIP").is_none_or(|value| value != "1"), "{line}");
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/skipped");
        fs::create_dir_all(&folder).and_then(|()| fs::write(folder.join("nats-server"), format!("{line}\n"))).expect("target/ is writable");
        println!("{line}");
    }
    there
}

/// A NATS server in a folder of its own.
pub(crate) struct Nats {
    pub(crate) folder: PathBuf,
    pub(crate) port: u16,
    child: Option<Child>,
}

impl Nats {
    /// Starts a server with JetStream.
    pub(crate) fn start() -> Self {
        Self::with("", true)
    }

    /// Starts a server with more settings.
    pub(crate) fn with(settings: &str, has_jetstream: bool) -> Self {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        let name = format!("sieben-farm-{}-{}", std::process::id(), NUMBER.fetch_add(1, Ordering::Relaxed));
        let folder = std::env::temp_dir().join(name);
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("a folder");
        let port = TcpListener::bind("127.0.0.1:0").and_then(|listener| listener.local_addr()).expect("a free port").port();
        let store = folder.join("store");
        let jetstream = match has_jetstream {
            true => format!("jetstream {{ store_dir: \"{}\", max_file: 256MB, max_mem: 64MB }}\n", store.display()),
            false => String::new(),
        };
        let settings = settings.replace("FOLDER", &folder.display().to_string());
        fs::write(folder.join("nats.conf"), format!("listen: \"127.0.0.1:{port}\"\n{jetstream}{settings}\n")).expect("a file");
        let mut server = Self { folder, port, child: None };
        server.again();
        server
    }

    /// Starts it once more.
    pub(crate) fn again(&mut self) {
        let child = Command::new("nats-server")
            .arg("-c")
            .arg(self.folder.join("nats.conf"))
            .args(["-l", &self.folder.join("log").display().to_string()])
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the server starts");
        self.child = Some(child);
        let begun = Instant::now();
        while !self.greets() {
            assert!(begun.elapsed() < DEADLINE, "{}", fs::read_to_string(self.folder.join("log")).unwrap_or_default());
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    fn greets(&self) -> bool {
        let Ok(stream) = TcpStream::connect(("127.0.0.1", self.port)) else { return false };
        let _ = stream.set_read_timeout(Some(Duration::from_secs(2)));
        let mut start = [0; 4];
        BufReader::new(stream).read_exact(&mut start).is_ok() && &start == b"INFO"
    }

    /// `kill -9`.
    pub(crate) fn kill(&mut self) {
        if let Some(mut child) = self.child.take() {
            let _ = child.kill();
            let _ = child.wait();
        }
    }

    /// Deletes all that it stored.
    pub(crate) fn lose_store(&self) {
        fs::remove_dir_all(self.folder.join("store")).expect("the store goes");
    }

    pub(crate) fn url(&self) -> String {
        format!("nats://127.0.0.1:{}", self.port)
    }

    /// The streams that are stored.
    pub(crate) fn streams(&self) -> Vec<String> {
        let folder = self.folder.join("store/jetstream/$G/streams");
        let entries = fs::read_dir(folder).map(|entries| entries.filter_map(Result::ok).collect::<Vec<_>>()).unwrap_or_default();
        entries.iter().map(|entry| entry.file_name().to_string_lossy().into_owned()).collect()
    }

    /// Starts the trial program: a verb, and words like `count=10`.
    pub(crate) fn trial(&self, verb: &str, words: &str) -> Trial {
        Trial::start(verb, &format!("url={} {words}", self.url()))
    }
}

impl Drop for Nats {
    fn drop(&mut self) {
        self.kill();
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// A process of the trial program.
pub(crate) struct Trial {
    child: Child,
}

impl Trial {
    pub(crate) fn start(verb: &str, words: &str) -> Self {
        let child = Command::new(env!("CARGO_BIN_EXE_farm-trial"))
            .arg(verb)
            .args(words.split(' ').filter(|word| !word.is_empty()))
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the trial program starts");
        Self { child }
    }

    /// `kill -9`.
    pub(crate) fn kill(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }

    /// Sends a signal, such as `STOP`.
    pub(crate) fn signal(&self, name: &str) {
        let sent = Command::new("kill").arg(format!("-{name}")).arg(self.child.id().to_string()).status();
        assert!(sent.is_ok_and(|status| status.success()), "a signal is sent");
    }

    /// Whether it has ended.
    pub(crate) fn has_ended(&mut self) -> bool {
        self.child.try_wait().is_ok_and(|status| status.is_some())
    }

    /// Waits until it says a line with this in it.
    pub(crate) fn waits_for(&mut self, words: &str) -> String {
        // Byte by byte, so that nothing of a later line is taken.
        let stdout = self.child.stdout.as_mut().expect("a pipe");
        let mut reader = BufReader::with_capacity(1, stdout);
        let mut said = String::new();
        loop {
            let mut line = String::new();
            let read = reader.read_line(&mut line).expect("a line");
            said.push_str(&line);
            assert!(read > 0, "`{words}` is not in:\n{said}");
            if line.contains(words) {
                return line;
            }
        }
    }

    /// Waits for its end; what it said.
    pub(crate) fn ends(mut self) -> String {
        let mut stdout = self.child.stdout.take().expect("a pipe");
        let reader = std::thread::spawn(move || {
            let mut said = String::new();
            let _ = stdout.read_to_string(&mut said);
            said
        });
        let begun = Instant::now();
        while !self.has_ended() {
            if begun.elapsed() > DEADLINE {
                self.kill();
                panic!("it does not end; it said: {}", reader.join().unwrap_or_default());
            }
            std::thread::sleep(Duration::from_millis(10));
        }
        reader.join().expect("no panic")
    }
}

impl Drop for Trial {
    fn drop(&mut self) {
        self.kill();
    }
}
