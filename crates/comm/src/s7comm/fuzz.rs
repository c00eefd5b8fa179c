//! What the fuzzer runs, and what has to be true of the answers whatever comes in.

use std::collections::BTreeMap;
use std::net::{Ipv4Addr, SocketAddr};
use std::sync::Arc;

use sieben_cpu::ProtectionLevel;
use sieben_workspace::gate::Plant;

use super::guard::{Rules, Writing};
use super::session::{Session, Shared};
use super::wire::header::{self, Kind};
use super::wire::{block_image, blocks, clock, cotp, names, security, services, setup, system_status, tpkt, transfer, userdata, variables};

/// Bytes that may wait to be sent, with the answers to the jobs of one more portion.
const OUTPUT_BYTES_MAX: usize = 72 * 1024;
/// Deadlines that are waited for after the last byte; there are fewer.
const DEADLINES_MAX: usize = 10_000;

/// What an input of [`session`] begins with: how its bytes are handed over, and what the server is like.
mod flag {
    /// The rest is a list of messages, each after its length in one byte, on a connection that is set up; without it the rest is a stream.
    pub(super) const MESSAGES: u8 = 1;
    /// Level 2 with a password.
    pub(super) const PROTECTED: u8 = 2;
    /// The lengths in the headers of the messages are put right.
    pub(super) const LENGTHS: u8 = 4;
    /// The bytes come one by one.
    pub(super) const BYTES: u8 = 8;
    /// Nothing may be changed.
    pub(super) const READ_ONLY: u8 = 16;
    /// All messages come before the first entry of the gate.
    pub(super) const TOGETHER: u8 = 32;
}

/// Reads the input as everything that may come in.
pub fn wire(data: &[u8]) {
    if let Ok(Some((tpdu, length))) = tpkt::split(data) {
        assert!(length <= data.len() && tpdu.len() + tpkt::HEAD == length, "a frame lies in its stream");
        if let Ok(cotp::Tpdu::ConnectRequest(request)) = cotp::read(tpdu) {
            let mut confirmed = Vec::new();
            cotp::connect_confirm(&mut confirmed, &request);
            assert!(cotp::read(tpdu).is_ok() && (128..=1024).contains(&request.tpdu_bytes()), "a TPDU has a size");
        }
    }
    let _ = cotp::read(data);
    if let Ok(Ok(message)) = header::read(data) {
        let again = header::write(&message);
        assert_eq!(header::read(&again), Ok(Ok(message)), "a message is written as it was read");
        if let Ok(request) = userdata::read(&message)
            && let Ok(data) = request.data
        {
            group(request.address.subfunction, data);
        }
        let _ = transfer::read_piece(&message);
        let _ = variables::write_request(message.parameters, message.data);
        parameters(message.parameters);
    }
    parameters(data);
    if let Ok(image) = block_image::Image::read(data) {
        assert!(image.body.len() + block_image::FRAME_BYTES <= data.len(), "an image has room for its code");
        assert!(data.starts_with(&image.header) && data.ends_with(&image.footer), "an image is what it was read from");
    }
    if let Some((&subfunction, data)) = data.split_first() {
        group(subfunction, data);
    }
}

/// Reads parameters of a job.
fn parameters(bytes: &[u8]) {
    for pdu_bytes in [240, 480] {
        if let Ok(items) = variables::read_request(bytes, pdu_bytes) {
            let values: Vec<_> = items.iter().map(|item| item.map(|variable| vec![0; variable.bytes()].into())).collect();
            let data = variables::values(&items, &values);
            assert!(header::ANSWER_HEAD + 2 + data.len() <= pdu_bytes, "what was let through fits a PDU");
        }
    }
    let _ = (setup::read(bytes), services::read(bytes), names::read(bytes));
    let _ = (transfer::read_request_download(bytes), transfer::read_start_upload(bytes), transfer::read_upload_id(bytes));
}

/// Reads the data of a request of the second kind.
fn group(subfunction: u8, data: &[u8]) {
    let _ = (blocks::read(subfunction, data), clock::read(subfunction, data));
    let _ = (security::read(subfunction, data), system_status::read(subfunction, data));
}

/// Gives the input to a session, as a stream or as messages, and looks at all that comes back: frames of the protocol, none longer than was agreed
/// on, and one answer to each request as long as the connection is not closed.
pub fn session(plant: &mut Plant, data: &[u8]) {
    let Some((&flags, data)) = data.split_first() else { return };
    let has = |flag: u8| flags & flag != 0;
    let rules = Rules {
        cpu: plant.cpu.cpu_type(),
        protection: if has(flag::PROTECTED) { ProtectionLevel::WriteProtected } else { ProtectionLevel::Open },
        password: has(flag::PROTECTED).then_some(*b"SECRET  "),
        writing: if has(flag::READ_ONLY) { Writing::ReadOnly } else { Writing::Allowed },
        allow: None,
        strict: false,
        strict_slot: false,
    };
    let peer = SocketAddr::from((Ipv4Addr::LOCALHOST, 50_000));
    let mut run = Run {
        pdu_bytes: usize::from(rules.cpu.pdu),
        session: Session::new(Arc::new(rules), peer, 0),
        shared: Shared::default(),
        plant,
        now_us: 0,
        answered: BTreeMap::new(),
        fragments: Vec::new(),
    };
    let piece = if has(flag::BYTES) { 1 } else { usize::MAX };
    if !has(flag::MESSAGES) {
        for piece in data.chunks(piece) {
            run.receive(piece, Serve::AtOnce);
        }
        run.finish();
        return;
    }
    run.receive(&[3, 0, 0, 0x16, 0x11, 0xE0, 0, 0, 0, 1, 0, 0xC0, 1, 0x0A, 0xC1, 2, 1, 0, 0xC2, 2, 1, 2], Serve::AtOnce);
    let mut asked = vec![0];
    run.receive(&framed(&[0x32, 1, 0, 0, 0, 0, 0, 8, 0, 0, 0xF0, 0, 0, 8, 0, 8, 1, 0xE0]), Serve::AtOnce);
    assert!(run.session.is_ready(), "a good setup is taken");
    let serve = if has(flag::TOGETHER) { Serve::Later } else { Serve::AtOnce };
    let mut rest = data;
    while let Some((&length, after)) = rest.split_first() {
        let (message, after) = after.split_at(after.len().min(usize::from(length)));
        rest = after;
        let mut message = message.to_vec();
        let Some(reference) = prepare(&mut message, asked.len(), has(flag::LENGTHS)) else { continue };
        if matches!(header::read(&message), Ok(Ok(header::Message { kind: Kind::Ack | Kind::AckData, .. }))) {
            // An answer of the client, which nothing answers; the CPU knows it by its own reference.
        } else {
            asked.push(reference);
        }
        for piece in framed(&message).chunks(piece) {
            run.receive(piece, serve);
        }
    }
    run.finish();
    if !run.session.is_over() {
        for reference in asked {
            assert_eq!(run.answered.get(&reference), Some(&1), "job {reference:04X} is answered once");
        }
    }
}

/// Gives a message the next reference, unless it answers the CPU, and if asked for the right lengths; `None` if it is so short that it has none.
fn prepare(message: &mut [u8], number: usize, puts_lengths_right: bool) -> Option<u16> {
    let number = u16::try_from(number).ok()?;
    let length = message.len();
    let head = message.first_chunk_mut::<10>()?;
    if head[0] != 0x32 {
        return None;
    }
    let bytes = if matches!(head[1], 2 | 3) { header::ANSWER_HEAD } else { header::HEAD };
    if bytes == header::HEAD {
        head[4..6].copy_from_slice(&number.to_be_bytes());
    }
    if puts_lengths_right {
        let all = u16::try_from(length.checked_sub(bytes)?).ok()?;
        let parameters = u16::from_be_bytes([head[6], head[7]]).min(all);
        head[6..8].copy_from_slice(&parameters.to_be_bytes());
        head[8..10].copy_from_slice(&(all - parameters).to_be_bytes());
    }
    Some(number)
}

fn framed(message: &[u8]) -> Vec<u8> {
    let mut out = Vec::new();
    tpkt::frame(&mut out, |out| {
        cotp::data_head(out, cotp::Part::Last);
        out.extend_from_slice(message);
    });
    out
}

/// When the gate is entered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Serve {
    AtOnce,
    Later,
}

struct Run<'p> {
    session: Session,
    shared: Shared,
    plant: &'p mut Plant,
    pdu_bytes: usize,
    now_us: u64,
    /// How often each reference was answered.
    answered: BTreeMap<u16, usize>,
    fragments: Vec<u8>,
}

impl Run<'_> {
    fn receive(&mut self, bytes: &[u8], serve: Serve) {
        if self.session.reads() {
            self.session.receive(bytes, &mut self.shared, self.now_us);
        } else {
            // A server reads on when the client may go on.
            self.finish();
            self.session.receive(bytes, &mut self.shared, self.now_us);
        }
        if serve == Serve::AtOnce {
            self.serve();
        }
    }

    /// What a server does after each wake.
    fn serve(&mut self) {
        while self.session.wants_in() {
            assert!(self.session.serve(self.plant, &mut self.shared, self.now_us), "who wants in does something there");
        }
        assert!(self.session.output().len() <= OUTPUT_BYTES_MAX, "what waits to be sent is bounded");
        let output = self.session.output().to_vec();
        self.session.sent(output.len(), self.now_us);
        self.shared.events.clear();
        self.look(&output);
    }

    /// Goes from deadline to deadline until nothing waits.
    fn finish(&mut self) {
        self.serve();
        for _ in 0..DEADLINES_MAX {
            let Some(wake_us) = self.session.wake_us() else { return };
            // A connection that is set up and idle has no deadline but that of a frame that was begun.
            if wake_us > self.now_us.saturating_add(9_000_000) {
                return;
            }
            self.now_us = self.now_us.max(wake_us);
            self.session.tick(&mut self.shared, self.now_us);
            self.serve();
        }
        panic!("the deadlines never end");
    }

    /// Looks at what was sent.
    fn look(&mut self, mut output: &[u8]) {
        while !output.is_empty() {
            let (tpdu, length) = tpkt::split(output).expect("a frame").expect("frames go out whole");
            output = &output[length..];
            if tpdu.get(1).is_some_and(|code| code & 0xF0 != 0xF0) {
                continue;
            }
            let Ok(cotp::Tpdu::Data { part, payload }) = cotp::read(tpdu) else { panic!("a data frame") };
            self.fragments.extend_from_slice(payload);
            if part == cotp::Part::More {
                continue;
            }
            let message = std::mem::take(&mut self.fragments);
            assert!(message.len() <= self.pdu_bytes, "a message of {} bytes is longer than a PDU", message.len());
            let message = header::read(&message).expect("a message").expect("with the right lengths");
            if message.kind != Kind::Job {
                *self.answered.entry(message.reference).or_default() += 1;
            }
        }
    }
}
