//! What a server writes down: the audit log and the frames, each by a thread of its own, so that no client and no scan waits for a disk.

pub mod audit;
pub mod frames;

use std::io::{self, BufWriter, Write};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, TryRecvError, sync_channel};
use std::sync::{Arc, Weak};
use std::thread::JoinHandle;

use audit::Audit;
use frames::Frames;

/// Records that wait to be written.
const RECORDS_WAITING_MAX: usize = 4_096;
/// Bytes of records that wait to be written.
const BYTES_WAITING_MAX: usize = 8 * 1024 * 1024;

/// Where a server notes what happens.
#[derive(Default)]
pub struct Recorders {
    /// What was done from outside.
    pub audit: Option<Audit>,
    /// What went over the network.
    pub frames: Option<Frames>,
}

/// Where a recorder writes to.
pub type Sink = Box<dyn Write + Send>;

/// Writes records in a thread of its own. What there is no room for is lost and counted.
pub struct Recorder {
    records: Option<Arc<SyncSender<Vec<u8>>>>,
    state: Arc<State>,
    thread: Option<JoinHandle<()>>,
}

#[derive(Default)]
struct State {
    /// Bytes that wait.
    waiting: AtomicUsize,
    /// Records that were lost.
    lost: AtomicU64,
    /// The last record could not be written.
    fails: AtomicBool,
}

impl State {
    fn put(&self, records: Option<&SyncSender<Vec<u8>>>, record: Vec<u8>) {
        let length = record.len();
        let waiting = self.waiting.fetch_add(length, Ordering::SeqCst);
        let sent = waiting <= BYTES_WAITING_MAX && records.is_some_and(|records| records.try_send(record).is_ok());
        if !sent {
            self.waiting.fetch_sub(length, Ordering::SeqCst);
            self.lost.fetch_add(1, Ordering::SeqCst);
        }
    }
}

/// A way to a recorder; it leads nowhere as soon as the recorder ends, and does not keep it.
#[derive(Clone)]
pub struct Way {
    records: Weak<SyncSender<Vec<u8>>>,
    state: Arc<State>,
}

impl Way {
    /// Takes a record; one that there is no room for is lost.
    pub fn put(&self, record: Vec<u8>) {
        self.state.put(self.records.upgrade().as_deref(), record);
    }
}

/// What stands in the place of lost records.
pub type LostRecord = fn(lost: u64) -> Vec<u8>;

impl Recorder {
    /// A recorder with the name of its thread.
    ///
    /// # Errors
    /// The system has no room for the thread.
    pub fn start(name: &str, sink: Sink, lost_record: LostRecord) -> io::Result<Self> {
        let (records, received) = sync_channel(RECORDS_WAITING_MAX);
        let state = Arc::new(State::default());
        let theirs = Arc::clone(&state);
        let thread = std::thread::Builder::new().name(name.to_owned()).spawn(move || write_all(&received, sink, &theirs, lost_record))?;
        Ok(Self { records: Some(Arc::new(records)), state, thread: Some(thread) })
    }

    /// Takes a record; one that there is no room for is lost.
    pub fn put(&self, record: Vec<u8>) {
        self.state.put(self.records.as_deref(), record);
    }

    /// Another way to it.
    pub fn way(&self) -> Way {
        Way { records: self.records.as_ref().map(Arc::downgrade).unwrap_or_default(), state: Arc::clone(&self.state) }
    }

    /// How many records were lost.
    pub fn lost(&self) -> u64 {
        self.state.lost.load(Ordering::SeqCst)
    }

    /// Whether the next record has room, and the last one was written.
    pub fn has_room(&self) -> bool {
        !self.state.fails.load(Ordering::SeqCst) && self.state.waiting.load(Ordering::SeqCst) < BYTES_WAITING_MAX / 2
    }
}

impl Drop for Recorder {
    fn drop(&mut self) {
        drop(self.records.take());
        if let Some(thread) = self.thread.take() {
            // A panic of the thread was reported where it happened.
            let _ = thread.join();
        }
    }
}

/// Writes what comes until nothing comes any more. What waits in memory goes out as soon as nothing else is to be written.
fn write_all(records: &Receiver<Vec<u8>>, sink: Sink, state: &State, lost_record: LostRecord) {
    let mut sink = BufWriter::new(sink);
    let mut reported = 0;
    loop {
        let record = match records.try_recv() {
            Ok(record) => record,
            Err(TryRecvError::Disconnected) => break,
            Err(TryRecvError::Empty) => {
                let flushed = sink.flush();
                state.fails.fetch_or(flushed.is_err(), Ordering::SeqCst);
                match records.recv() {
                    Ok(record) => record,
                    Err(_) => break,
                }
            }
        };
        let lost = state.lost.load(Ordering::SeqCst);
        if lost > reported {
            let told = lost_record(lost - reported);
            if told.is_empty() || sink.write_all(&told).is_ok() {
                reported = lost;
            }
        }
        let written = sink.write_all(&record);
        state.waiting.fetch_sub(record.len(), Ordering::SeqCst);
        state.fails.store(written.is_err(), Ordering::SeqCst);
        if written.is_err() {
            state.lost.fetch_add(1, Ordering::SeqCst);
        }
    }
    let lost = state.lost.load(Ordering::SeqCst);
    if lost > reported {
        // The end of the file is all that could say more.
        let _ = sink.write_all(&lost_record(lost - reported));
    }
    let _ = sink.flush();
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;
    use std::sync::mpsc::{Sender, channel};

    use super::*;

    /// A sink that takes nothing until it is let go.
    struct Slow(Receiver<()>, Arc<Mutex<Vec<u8>>>, bool);

    impl Write for Slow {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            if !self.2 {
                let _ = self.0.recv();
                self.2 = true;
            }
            self.1.lock().expect("a test").extend_from_slice(bytes);
            Ok(bytes.len())
        }
        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    fn slow() -> (Sender<()>, Arc<Mutex<Vec<u8>>>, Recorder) {
        let (go, waits) = channel();
        let written = Arc::new(Mutex::new(Vec::new()));
        let sink = Box::new(Slow(waits, Arc::clone(&written), false));
        let recorder = Recorder::start("test", sink, |lost| format!("lost {lost}\n").into_bytes()).expect("a thread");
        (go, written, recorder)
    }

    #[test]
    fn what_has_no_room_is_lost_and_counted_and_nothing_waits() {
        let (go, written, recorder) = slow();
        let put = RECORDS_WAITING_MAX as u64 + 10_000;
        for number in 0..put {
            recorder.put(format!("{number}\n").into_bytes());
        }
        let lost = recorder.lost();
        assert!(lost > 0);
        go.send(()).expect("the sink waits");
        drop(recorder);
        let text = String::from_utf8(written.lock().expect("a test").clone()).expect("text");
        let told: u64 = text.lines().filter_map(|line| line.strip_prefix("lost ")).map(|lost| lost.parse::<u64>().expect("a number")).sum();
        assert_eq!(told, lost);
        assert_eq!(text.lines().filter(|line| !line.starts_with("lost")).count() as u64, put - lost);
    }

    #[test]
    fn large_records_are_lost_before_memory_is() {
        let (go, _, recorder) = slow();
        for _ in 0..100 {
            recorder.put(vec![0; 1024 * 1024]);
        }
        assert!(recorder.lost() > 85, "{}", recorder.lost());
        assert!(!recorder.has_room());
        go.send(()).expect("the sink waits");
    }

    #[test]
    fn another_way_leads_to_the_recorder_as_long_as_it_lives() {
        let (go, written, recorder) = slow();
        go.send(()).expect("the sink waits");
        let way = recorder.way();
        way.put(b"before\n".to_vec());
        drop(recorder);
        way.put(b"after\n".to_vec());
        assert_eq!(*written.lock().expect("a test"), b"before\n");
    }

    struct Full;

    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::Error::other("full"))
        }
        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_full_disk_is_noticed() {
        let recorder = Recorder::start("test", Box::new(Full), |_| Vec::new()).expect("a thread");
        recorder.put(vec![0; 100_000]);
        while recorder.has_room() {
            std::thread::yield_now();
        }
        while recorder.lost() == 0 {
            std::thread::yield_now();
        }
    }
}
