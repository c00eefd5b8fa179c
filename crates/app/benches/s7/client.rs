//! A client of the measurement: it asks, waits for the answer, and asks again.

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::time::{Duration, Instant};

/// Longest wait for an answer.
const PATIENCE: Duration = Duration::from_secs(10);
/// Connects a programming device to rack 0, slot 2, with TPDUs of 1,024 bytes.
const CONNECT: [u8; 22] = [3, 0, 0, 22, 17, 0xE0, 0, 0, 0, 1, 0, 0xC0, 1, 10, 0xC1, 2, 1, 0, 0xC2, 2, 1, 2];
/// Asks for one job at a time and a PDU of 240 bytes.
const SETUP: [u8; 25] = [3, 0, 0, 25, 2, 0xF0, 0x80, 0x32, 1, 0, 0, 0, 0, 0, 8, 0, 0, 0xF0, 0, 0, 1, 0, 1, 0, 240];
/// Bytes of TPKT, COTP and the header of an answer.
const HEADER: usize = 4 + 3 + 12;

/// What a client reads at a time: bytes of an area.
#[derive(Clone, Copy)]
pub(crate) struct Item {
    /// The area's code.
    pub(crate) area: u8,
    /// The data block, or 0.
    pub(crate) db: u16,
    /// The first byte.
    pub(crate) byte: u32,
    /// How many.
    pub(crate) length: u16,
}

/// The job that reads these items.
pub(crate) fn job(items: &[Item]) -> Vec<u8> {
    let parameters: Vec<u8> = [4, items.len() as u8]
        .into_iter()
        .chain(items.iter().flat_map(|item| {
            let [_, a, b, c] = (item.byte * 8).to_be_bytes();
            let ([lh, ll], [dh, dl]) = (item.length.to_be_bytes(), item.db.to_be_bytes());
            [0x12, 10, 0x10, 2, lh, ll, dh, dl, item.area, a, b, c]
        }))
        .collect();
    let [ph, pl] = (parameters.len() as u16).to_be_bytes();
    let [th, tl] = (17 + parameters.len() as u16).to_be_bytes();
    let mut frame = vec![3, 0, th, tl, 2, 0xF0, 0x80, 0x32, 1, 0, 0, 0, 1, ph, pl, 0, 0];
    frame.extend(parameters);
    frame
}

/// A connection.
pub(crate) struct Client {
    stream: TcpStream,
    answer: Vec<u8>,
}

impl Client {
    /// Makes a connected socket a connection that takes jobs.
    pub(crate) fn new(stream: TcpStream) -> Self {
        stream.set_nodelay(true).expect("a socket of TCP");
        stream.set_read_timeout(Some(PATIENCE)).expect("a socket of TCP");
        let mut client = Self { stream, answer: Vec::new() };
        client.ask(&CONNECT);
        assert_eq!(client.answer.get(5), Some(&0xD0), "the connection is confirmed");
        client.ask(&SETUP);
        assert_eq!(client.answer.get(25..27), Some(&[0, 240][..]), "PDUs of 240 bytes");
        client
    }

    /// Connects.
    pub(crate) fn connect(address: SocketAddr) -> Self {
        Self::new(TcpStream::connect(address).expect("the server listens"))
    }

    /// Asks, and waits for the whole answer.
    fn ask(&mut self, frame: &[u8]) {
        self.stream.write_all(frame).expect("the server reads");
        let mut start = [0; 4];
        self.stream.read_exact(&mut start).expect("the server answers");
        self.answer.resize(usize::from(u16::from_be_bytes([start[2], start[3]])), 0);
        self.answer[..4].copy_from_slice(&start);
        self.stream.read_exact(&mut self.answer[4..]).expect("the whole answer");
    }

    /// Reads, and looks whether every item was delivered.
    pub(crate) fn read(&mut self, job: &[u8], items: &[Item]) {
        self.ask(job);
        assert_eq!(self.answer.get(17..19), Some(&[0, 0][..]), "the job was done");
        let mut at = HEADER + 2;
        for item in items {
            assert_eq!(self.answer.get(at), Some(&0xFF), "the item was read");
            at += 4 + usize::from(item.length.next_multiple_of(2));
        }
    }

    /// Asks until the time is over; how long each answer took, in microseconds.
    pub(crate) fn read_until(&mut self, end: Instant, job: &[u8], items: &[Item]) -> Vec<f64> {
        let mut waits = Vec::new();
        while Instant::now() < end {
            let asked = Instant::now();
            self.read(job, items);
            waits.push(asked.elapsed().as_secs_f64() * 1e6);
        }
        waits
    }
}
