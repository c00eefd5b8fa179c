//! What is left of answers that are longer than a PDU: the client asks for one fragment after the other.

use std::collections::VecDeque;

use crate::s7comm::wire::More;
use crate::s7comm::wire::codes::Refusal;
use crate::s7comm::wire::userdata::{self, Address, Content, FRAGMENT_HEAD, Place};

/// Answers of one connection that may be open at a time; the oldest goes for one more.
const REMAINDERS_MAX: usize = 4;
/// How long the rest of an answer is kept that is not asked for, in microseconds.
const KEPT_US_MAX: u64 = 30_000_000;

/// The answers of a connection that are not complete yet, the oldest first.
#[derive(Debug, Default)]
pub(super) struct Remainders {
    open: VecDeque<Remainder>,
    last_sequence: u8,
}

#[derive(Debug)]
struct Remainder {
    /// What the client calls it by.
    address: Address,
    content: Content,
    /// Bytes that were sent.
    sent: usize,
    until_us: u64,
}

impl Remainder {
    /// The next fragment and whether more follow.
    fn cut(&mut self, pdu_bytes: usize) -> (&[u8], More) {
        let room = pdu_bytes.saturating_sub(FRAGMENT_HEAD).max(1);
        let grain = self.content.grain.clamp(1, room);
        let rest = self.content.bytes.get(self.sent..).unwrap_or(&[]);
        let (length, more) = if rest.len() <= room { (rest.len(), More::None) } else { (room - room % grain, More::Follow) };
        self.sent += length;
        (&rest[..length], more)
    }
}

impl Remainders {
    /// The answer to a request, or its first fragment.
    pub(super) fn answer(&mut self, reference: u16, address: Address, content: Content, pdu_bytes: usize, now_us: u64) -> Vec<u8> {
        let mut whole = Remainder { address, content, sent: 0, until_us: now_us.saturating_add(KEPT_US_MAX) };
        if whole.content.bytes.len() <= pdu_bytes.saturating_sub(FRAGMENT_HEAD) {
            return userdata::answer(reference, address, Place::default(), &whole.content.bytes);
        }
        self.expire(now_us);
        if self.open.len() >= REMAINDERS_MAX {
            self.open.pop_front();
        }
        whole.address.sequence = self.next_sequence();
        let address = whole.address;
        let (bytes, more) = whole.cut(pdu_bytes);
        let answer = userdata::answer(reference, address, Place { unit: address.sequence, more }, bytes);
        self.open.push_back(whole);
        answer
    }

    /// The next fragment of an answer.
    pub(super) fn next(&mut self, reference: u16, address: Address, pdu_bytes: usize, now_us: u64) -> Vec<u8> {
        self.expire(now_us);
        let Some(at) = self.open.iter().position(|open| open.address == address) else {
            return userdata::refuse(reference, address, Refusal::WrongSequence);
        };
        let Some(mut open) = self.open.remove(at) else { return userdata::refuse(reference, address, Refusal::WrongSequence) };
        let (bytes, more) = open.cut(pdu_bytes);
        let answer = userdata::answer(reference, address, Place { unit: address.sequence, more }, bytes);
        if more == More::Follow {
            open.until_us = now_us.saturating_add(KEPT_US_MAX);
            self.open.push_back(open);
        }
        answer
    }

    fn expire(&mut self, now_us: u64) {
        self.open.retain(|open| now_us < open.until_us);
    }

    /// The next number from 1 on that no open answer has.
    fn next_sequence(&mut self) -> u8 {
        loop {
            self.last_sequence = self.last_sequence.checked_add(1).unwrap_or(1);
            if self.open.iter().all(|open| open.address.sequence != self.last_sequence) {
                return self.last_sequence;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::s7comm::wire::header;

    const LISTS: Address = Address { group: 4, subfunction: 1, sequence: 0 };

    /// Sequence number, unit, whether more follow, error, and the bytes of an answer.
    fn parts(answer: &[u8]) -> (u8, u8, u8, u16, Vec<u8>) {
        let message = header::read(answer).expect("it is a message").expect("with the right lengths");
        let p = message.parameters;
        (p[7], p[8], p[9], u16::from_be_bytes([p[10], p[11]]), message.data[4..].to_vec())
    }

    fn content(length: usize, grain: usize) -> Content {
        Content { bytes: (0..length).map(|at| at as u8).collect(), grain }
    }

    #[test]
    fn an_answer_comes_back_in_one_piece_after_all_its_fragments() {
        for (length, grain) in [(214, 4), (215, 4), (1_000, 4), (1_000, 0), (5_000, 28)] {
            let mut remainders = Remainders::default();
            let (sequence, mut unit, mut more, _, mut all) = parts(&remainders.answer(1, LISTS, content(length, grain), 240, 0));
            while more == 1 {
                assert!(sequence != 0 && unit != 0);
                assert_eq!(all.len() % grain.max(1), 0);
                let next = parts(&remainders.next(2, Address { sequence, ..LISTS }, 240, 0));
                (unit, more) = (next.1, next.2);
                all.extend(next.4);
            }
            assert_eq!(all, content(length, grain).bytes);
            assert!(remainders.open.is_empty());
        }
    }

    #[test]
    fn several_answers_are_open_side_by_side_but_never_too_many() {
        let mut remainders = Remainders::default();
        let sequences: Vec<u8> = (0..300).map(|_| parts(&remainders.answer(1, LISTS, content(500, 0), 240, 0)).0).collect();
        assert_eq!(remainders.open.len(), REMAINDERS_MAX);
        let mut next = |index: usize, now_us| parts(&remainders.next(1, Address { sequence: sequences[index], ..LISTS }, 240, now_us)).3;
        assert_eq!(next(296, 0), 0);
        assert_eq!(next(299, 0), 0);
        assert_eq!(next(295, 0), Refusal::WrongSequence.code());
        assert_eq!(next(298, KEPT_US_MAX), Refusal::WrongSequence.code());
    }
}
