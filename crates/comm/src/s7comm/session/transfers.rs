//! Blocks on their way: uploads, whose pieces the client asks for, and a download, where the CPU asks.

use crate::s7comm::guard::Rules;
use crate::s7comm::job::Download;
use crate::s7comm::wire::More;
use crate::s7comm::wire::codes::Refusal;
use crate::s7comm::wire::header::{self, Message};
use crate::s7comm::wire::transfer::{self, Announced, PIECE_OVERHEAD, function};

/// Uploads of one connection at a time.
const UPLOADS_MAX: usize = 4;
/// Bytes of the image of a block that is downloaded: code, interface and table of networks together.
const IMAGE_BYTES_MAX: u32 = 196_608;
/// How long a transfer waits for the client, in microseconds.
const WAIT_US_MAX: u64 = 30_000_000;

/// The uploads of a connection.
#[derive(Debug, Default)]
pub(super) struct Uploads {
    running: Vec<Upload>,
    last_id: u8,
}

#[derive(Debug)]
struct Upload {
    id: u8,
    image: Vec<u8>,
    sent: usize,
    until_us: u64,
}

impl Uploads {
    /// Whether one more may begin.
    pub(super) fn has_room(&mut self, now_us: u64) -> Result<(), Refusal> {
        self.running.retain(|upload| now_us < upload.until_us);
        if self.running.len() < UPLOADS_MAX { Ok(()) } else { Err(Refusal::NoParallelUpload) }
    }

    /// Begins one; the answer to job 1D.
    pub(super) fn start(&mut self, reference: u16, image: Vec<u8>, now_us: u64) -> Vec<u8> {
        if let Err(refusal) = self.has_room(now_us) {
            return header::refuse(reference, refusal);
        }
        loop {
            self.last_id = self.last_id.checked_add(1).unwrap_or(1);
            if self.running.iter().all(|upload| upload.id != self.last_id) {
                break;
            }
        }
        let parameters = transfer::start_upload_answer(self.last_id, image.len());
        self.running.push(Upload { id: self.last_id, image, sent: 0, until_us: now_us.saturating_add(WAIT_US_MAX) });
        header::answer(reference, &parameters, &[])
    }

    /// The answer to job 1E: the next piece.
    pub(super) fn next(&mut self, reference: u16, parameters: &[u8], pdu_bytes: usize, now_us: u64) -> Vec<u8> {
        let found = transfer::read_upload_id(parameters)
            .and_then(|id| self.running.iter_mut().find(|upload| upload.id == id).ok_or(Refusal::WrongSequence));
        match found {
            Err(refusal) => header::refuse(reference, refusal),
            Ok(upload) if now_us >= upload.until_us || upload.sent > 0 && upload.sent >= upload.image.len() => {
                header::refuse(reference, Refusal::WrongSequence)
            }
            Ok(upload) => {
                let end = upload.image.len().min(upload.sent.saturating_add(pdu_bytes.saturating_sub(PIECE_OVERHEAD).max(1)));
                let piece = upload.image.get(upload.sent..end).unwrap_or(&[]);
                let more = if end < upload.image.len() { More::Follow } else { More::None };
                let answer = transfer::upload_answer(reference, piece, more);
                upload.sent = end;
                upload.until_us = now_us.saturating_add(WAIT_US_MAX);
                answer
            }
        }
    }

    /// The answer to job 1F.
    pub(super) fn end(&mut self, reference: u16, parameters: &[u8]) -> Vec<u8> {
        let found = transfer::read_upload_id(parameters)
            .and_then(|id| self.running.iter().position(|upload| upload.id == id).ok_or(Refusal::WrongSequence));
        match found {
            Err(refusal) => header::refuse(reference, refusal),
            Ok(at) => {
                self.running.swap_remove(at);
                header::answer(reference, &[function::END_UPLOAD], &[])
            }
        }
    }
}

/// A download.
#[derive(Debug)]
pub(super) struct Incoming {
    announced: Announced,
    image: Vec<u8>,
    stage: Stage,
    /// The reference of the job of the CPU that waits for its answer.
    reference: u16,
    until_us: u64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// The client is asked for a piece.
    Pieces,
    /// The block is complete and waits for the gate.
    Storing,
    /// The client was told that it is complete.
    Ending,
}

/// What comes of an answer of the client.
#[derive(Debug)]
pub(super) enum Step {
    /// It answers something that was not asked.
    Nothing,
    /// The next job of the CPU.
    Ask(Vec<u8>),
    /// The block is complete.
    Complete(Download),
    /// The download is over.
    Over,
}

impl Incoming {
    /// A download that a client announces.
    ///
    /// # Errors
    /// The block has more bytes than this CPU takes.
    pub(super) fn new(announced: Announced, rules: &Rules, reference: u16, now_us: u64) -> Result<Self, Refusal> {
        if announced.load_bytes > IMAGE_BYTES_MAX || announced.code_bytes > rules.cpu.block_size_max {
            return Err(Refusal::BlockTooLarge);
        }
        let until_us = now_us.saturating_add(WAIT_US_MAX);
        Ok(Self { announced, image: Vec::new(), stage: Stage::Pieces, reference, until_us })
    }

    /// Whether another one may begin: the client has been told that this one is complete, or has not answered for too long.
    pub(super) fn is_given_up(&self, now_us: u64) -> bool {
        match self.stage {
            Stage::Pieces => now_us >= self.until_us,
            Stage::Storing => false,
            Stage::Ending => true,
        }
    }

    /// The job of the CPU that is asked next.
    pub(super) fn ask(&self) -> Vec<u8> {
        transfer::own_job(self.reference, function::DOWNLOAD, None, self.announced.name)
    }

    /// Takes an answer of the client; `reference` is that of the next job of the CPU.
    pub(super) fn answered(&mut self, message: &Message<'_>, reference: u16, now_us: u64) -> Step {
        if message.reference != self.reference || self.stage == Stage::Storing {
            return Step::Nothing;
        }
        if self.stage == Stage::Ending {
            return Step::Over;
        }
        self.reference = reference;
        let (piece, more) = match transfer::read_piece(message) {
            Ok((piece, _)) if self.image.len() + piece.len() > self.announced.load_bytes as usize => {
                return self.fail(Refusal::BlockLengths, now_us);
            }
            Ok(piece) => piece,
            Err(refusal) => return self.fail(refusal, now_us),
        };
        self.image.extend_from_slice(piece);
        self.until_us = now_us.saturating_add(WAIT_US_MAX);
        if more == More::Follow {
            return Step::Ask(self.ask());
        }
        self.stage = Stage::Storing;
        let Announced { name, load_bytes, code_bytes } = self.announced;
        Step::Complete(Download { name, image: std::mem::take(&mut self.image), load_bytes, code_bytes })
    }

    /// The client hears at once that nothing comes of it.
    fn fail(&mut self, refusal: Refusal, now_us: u64) -> Step {
        self.image = Vec::new();
        Step::Ask(self.stored(Some(refusal), now_us))
    }

    /// The block is stored, or not: the job of the CPU that says so.
    pub(super) fn stored(&mut self, error: Option<Refusal>, now_us: u64) -> Vec<u8> {
        self.stage = Stage::Ending;
        self.until_us = now_us.saturating_add(WAIT_US_MAX);
        transfer::own_job(self.reference, function::DOWNLOAD_ENDED, error, self.announced.name)
    }
}
