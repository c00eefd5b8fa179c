//! Group 7 of userdata: reading and setting the clock.

use sieben_cpu::DateAndTime;

use super::codes::Refusal;
use super::userdata::Content;
use crate::s7comm::job::{Job, Reply};

/// Subfunctions; the second of each kind means the clock of the module itself, which is the only one here.
const READ: [u8; 2] = [1, 3];
const SET: [u8; 2] = [2, 4];
/// The first year that is written as 19xx: its last two digits.
const FIRST_YEAR: u8 = 0x90;

/// The job that a request means; `data` are the bytes after `FF 09` and the length, none if the request has no data.
///
/// # Errors
/// Why it is refused.
pub fn read(subfunction: u8, data: &[u8]) -> Result<Job, Refusal> {
    match subfunction {
        _ if READ.contains(&subfunction) => Ok(Job::Clock),
        _ if SET.contains(&subfunction) => time(data).map(Job::SetClock).ok_or(Refusal::WrongTime),
        _ => Err(Refusal::NotImplemented),
    }
}

/// The time in ten bytes: a zero, the century, and the eight of DATE_AND_TIME. Clients send any century and any weekday; neither is looked at.
fn time(data: &[u8]) -> Option<DateAndTime> {
    let &[_, _, ref time @ ..] = data else { return None };
    DateAndTime::from_bytes(time.try_into().ok()?)
}

/// The data of the answer.
///
/// # Errors
/// Why the job is refused.
pub fn write(job: &Job, reply: &Reply) -> Result<Content, Refusal> {
    match (job, reply) {
        (_, Reply::Refused(refusal)) => Err(*refusal),
        (Job::Clock, Reply::Clock(time)) => {
            let time = time.to_bcd();
            let century = if time[0] >= FIRST_YEAR { 0x19 } else { 0x20 };
            Ok(Content { bytes: [&[0, century], &time[..]].concat(), grain: 0 })
        }
        (Job::SetClock(_), Reply::Done) => Ok(Content::none()),
        _ => Err(Refusal::CannotPerform),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Saturday, 2026-11-28 18:05:09.123.
    const TIME: [u8; 10] = [0, 0x20, 0x26, 0x11, 0x28, 0x18, 0x05, 0x09, 0x12, 0x37];

    #[test]
    fn the_clock_is_read_with_its_century_and_weekday() {
        let at = |bytes: [u8; 8]| DateAndTime::from_bytes(bytes).expect("a time");
        let answer = |time| write(&Job::Clock, &Reply::Clock(time)).map(|content| content.bytes);
        assert_eq!(answer(at([0x26, 0x11, 0x28, 0x18, 0x05, 0x09, 0x12, 0x30])), Ok(TIME.to_vec()));
        assert_eq!(answer(DateAndTime::DEFAULT), Ok(vec![0, 0x19, 0x94, 1, 1, 0, 0, 0, 0, 7]));
        for subfunction in READ {
            assert_eq!(read(subfunction, &[]), Ok(Job::Clock));
        }
        assert_eq!(read(5, &[]), Err(Refusal::NotImplemented));
    }

    #[test]
    fn the_clock_is_set_whatever_century_and_weekday_say() {
        let expected = DateAndTime::from_bytes([0x26, 0x11, 0x28, 0x18, 0x05, 0x09, 0x12, 0x37]).expect("a time");
        for (century, weekday) in [(0x20, 7), (0x19, 0), (0, 0xF)] {
            let mut data = TIME;
            (data[1], data[9]) = (century, 0x30 | weekday);
            assert_eq!(read(2, &data), Ok(Job::SetClock(expected)));
        }
        assert_eq!(write(&Job::SetClock(expected), &Reply::Done), Ok(Content::none()));
    }

    #[test]
    fn what_no_clock_shows_is_refused() {
        for (at, byte) in [(2, 0x2A), (3, 0x13), (3, 0), (4, 0x31), (5, 0x24), (6, 0x60), (7, 0x60), (8, 0xA0), (9, 0xA1)] {
            let mut data = TIME;
            data[at] = byte;
            assert_eq!(read(2, &data), Err(Refusal::WrongTime), "byte {at} = {byte:#x}");
        }
        for data in [&TIME[..9], &[], &[0; 11]] {
            assert_eq!(read(4, data), Err(Refusal::WrongTime));
        }
    }
}
