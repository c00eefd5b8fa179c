//! Group 4 of userdata, subfunction 1: system status lists.

use super::codes::Refusal;
use super::userdata::Content;
use crate::s7comm::job::{Job, Reply};

/// The subfunction that reads a list; the others are about messages.
const READ_LIST: u8 = 1;

/// The job that a request means; `data` are the bytes after `FF 09` and the length, none if the request has no data.
///
/// # Errors
/// Why it is refused.
pub fn read(subfunction: u8, data: &[u8]) -> Result<Job, Refusal> {
    if subfunction != READ_LIST {
        // This CPU sends no messages.
        return Err(Refusal::ListNotAvailable);
    }
    let &[id_1, id_2, index_1, index_2] = data else { return Err(Refusal::ListSyntax) };
    Ok(Job::SystemStatus { id: u16::from_be_bytes([id_1, id_2]), index: u16::from_be_bytes([index_1, index_2]) })
}

/// The data of the answer: SZL_ID and INDEX, length and number of the records, the records.
///
/// # Errors
/// Why the job is refused.
pub fn write(job: &Job, reply: &Reply) -> Result<Content, Refusal> {
    match (job, reply) {
        (_, Reply::Refused(refusal)) => Err(*refusal),
        (Job::SystemStatus { .. }, Reply::SystemStatus(list)) => {
            let header = [list.id, list.index, list.record_bytes, list.count].map(u16::to_be_bytes);
            Ok(Content { bytes: [header.concat(), list.records.concat()].concat(), grain: 0 })
        }
        _ => Err(Refusal::CannotPerform),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use sieben_cpu::PartialList;

    #[test]
    fn a_list_has_its_header_and_its_records() {
        let job = read(1, &[0x01, 0x74, 0, 4]).expect("a request");
        assert_eq!(job, Job::SystemStatus { id: 0x0174, index: 4 });
        let list = PartialList { id: 0x0174, index: 4, record_bytes: 4, records: vec![vec![0, 4, 1, 0]], count: 1 };
        let bytes = write(&job, &Reply::SystemStatus(list)).expect("an answer").bytes;
        assert_eq!(bytes, [0x01, 0x74, 0, 4, 0, 4, 0, 1, 0, 4, 1, 0]);
        assert_eq!(write(&job, &Reply::Refused(Refusal::UnknownListIndex)), Err(Refusal::UnknownListIndex));
    }

    #[test]
    fn other_requests_of_the_group_are_refused() {
        assert_eq!(read(2, &[0; 10]), Err(Refusal::ListNotAvailable));
        for data in [&[][..], &[0, 0, 0], &[0; 5]] {
            assert_eq!(read(1, data), Err(Refusal::ListSyntax));
        }
    }
}
