//! Jobs 28 (program invocation services) and 29 (stop): start, link, delete, copy RAM to ROM, compress, memory reset.

use sieben_cpu::Restart;

use super::codes::Refusal;
use super::names;
use crate::s7comm::job::{BlockName, Job, Reply};

/// Function code of a service.
pub const SERVICE: u8 = 0x28;
/// Function code of a stop.
pub const STOP: u8 = 0x29;
/// What stands before the arguments of a service.
const BEFORE_ARGUMENTS: u8 = 0xFD;
/// The program as a whole, which is started and stopped.
const PROGRAM: &[u8] = b"P_PROGRAM";
/// Second bytes of an answer: it cannot be started, it runs already, it is in STOP already.
const CANNOT_START: u8 = 2;
const RUNS_ALREADY: u8 = 3;
const STOPPED_ALREADY: u8 = 7;
/// Bytes of the name of a block in the arguments of a service.
const NAME_BYTES: usize = 8;

/// The job that the parameters of a job 28 or 29 mean, function code included.
///
/// # Errors
/// Why it is refused.
pub fn read(parameters: &[u8]) -> Result<Job, Refusal> {
    match parameters {
        [SERVICE, _, _, _, _, _, _, BEFORE_ARGUMENTS, rest @ ..] => {
            let (arguments, rest) = after_length(rest).ok_or(Refusal::CannotPerform)?;
            service(arguments, name(rest).ok_or(Refusal::CannotPerform)?)
        }
        [STOP, _, _, _, _, _, rest @ ..] if name(rest) == Some(PROGRAM) => Ok(Job::Stop),
        _ => Err(Refusal::CannotPerform),
    }
}

/// Bytes after their length, which has two bytes, and what follows them.
fn after_length(bytes: &[u8]) -> Option<(&[u8], &[u8])> {
    let (&[high, low], rest) = bytes.split_first_chunk::<2>()?;
    rest.split_at_checked(usize::from(u16::from_be_bytes([high, low])))
}

/// A name after its length, which has one byte; nothing may follow.
fn name(bytes: &[u8]) -> Option<&[u8]> {
    let (&length, name) = bytes.split_first()?;
    (name.len() == usize::from(length)).then_some(name)
}

fn service(arguments: &[u8], name: &[u8]) -> Result<Job, Refusal> {
    match (name, arguments) {
        (PROGRAM, []) => Ok(Job::Start(Restart::Warm)),
        (PROGRAM, b"C ") => Ok(Job::Start(Restart::Cold)),
        (b"_INSE", _) => blocks(arguments).map(Job::Link),
        (b"_DELE", _) => blocks(arguments).map(Job::Delete),
        (b"_MODU", b"EP") => Ok(Job::CopyRamToRom),
        (b"_GARB", []) => Ok(Job::Compress),
        (b"_PLC_MEMORYRESET", []) => Ok(Job::MemoryReset),
        (PROGRAM | b"_MODU" | b"_GARB" | b"_PLC_MEMORYRESET", _) => Err(Refusal::CannotPerform),
        // Services of numerical controls begin with `_N_`; they and all others do not exist here.
        _ => Err(Refusal::NotImplemented),
    }
}

/// How many blocks there are, a zero, their names.
fn blocks(arguments: &[u8]) -> Result<Vec<BlockName>, Refusal> {
    let &[count, _, ref names @ ..] = arguments else { return Err(Refusal::BlockParameterSyntax) };
    if count == 0 || names.len() != usize::from(count) * NAME_BYTES {
        return Err(Refusal::BlockParameterSyntax);
    }
    names.chunks(NAME_BYTES).map(names::read).collect()
}

/// The parameters of the answer, and the error in its header: `29 07` and `28 03` come with one, because clients look at the second byte only then.
pub fn write(job: &Job, reply: &Reply) -> (Option<Refusal>, Vec<u8>) {
    let function = if *job == Job::Stop { STOP } else { SERVICE };
    match (job, reply) {
        (_, Reply::Done) => (None, vec![function]),
        (Job::Stop, Reply::Already) => (Some(Refusal::CannotPerform), vec![function, STOPPED_ALREADY]),
        (_, Reply::Already) => (Some(Refusal::CannotPerform), vec![function, RUNS_ALREADY]),
        (Job::Start(_), Reply::Refused(refusal)) => (Some(*refusal), vec![function, CANNOT_START]),
        (_, Reply::Refused(refusal)) => (Some(*refusal), vec![function]),
        _ => (Some(Refusal::CannotPerform), vec![function]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::s7comm::job::{BlockPlace, BlockType};

    fn request(arguments: &[u8], name: &[u8]) -> Vec<u8> {
        let length = (arguments.len() as u16).to_be_bytes();
        [&[0x28, 0, 0, 0, 0, 0, 0, 0xFD], &length[..], arguments, &[name.len() as u8], name].concat()
    }

    #[test]
    fn services_are_read_as_clients_write_them() {
        let db = |number| BlockName { block_type: BlockType::DataBlock, number, place: BlockPlace::Passive };
        let cases: [(&[u8], &[u8], Job); 7] = [
            (b"", b"P_PROGRAM", Job::Start(Restart::Warm)),
            (b"C ", b"P_PROGRAM", Job::Start(Restart::Cold)),
            (b"EP", b"_MODU", Job::CopyRamToRom),
            (b"", b"_GARB", Job::Compress),
            (b"", b"_PLC_MEMORYRESET", Job::MemoryReset),
            (b"\x01\x000A00012P", b"_INSE", Job::Link(vec![db(12)])),
            (b"\x02\x000A00012P0A00013P", b"_DELE", Job::Delete(vec![db(12), db(13)])),
        ];
        for (arguments, name, job) in cases {
            let request = request(arguments, name);
            assert_eq!(read(&request), Ok(job));
            // Whatever is cut off or hung on makes something else of it.
            for end in 0..request.len() {
                assert!(read(&request[..end]).is_err(), "{end} bytes of {request:02x?}");
            }
            assert!(read(&[&request[..], &[0]].concat()).is_err());
        }
        assert_eq!(read(b"\x29\0\0\0\0\0\x09P_PROGRAM"), Ok(Job::Stop));
        assert_eq!(request(b"", b"P_PROGRAM").len(), 20);
        assert_eq!(request(b"C ", b"P_PROGRAM").len(), 22);
    }

    #[test]
    fn what_is_no_service_is_refused_with_a_reason() {
        let cases: [(&[u8], &[u8], Refusal); 9] = [
            (b"", b"_N_F_XY", Refusal::NotImplemented),
            (b"", b"", Refusal::NotImplemented),
            (b"X ", b"P_PROGRAM", Refusal::CannotPerform),
            (b"", b"_MODU", Refusal::CannotPerform),
            (b"", b"_INSE", Refusal::BlockParameterSyntax),
            (b"\x00\x00", b"_DELE", Refusal::BlockParameterSyntax),
            (b"\x02\x000A00012P", b"_DELE", Refusal::BlockParameterSyntax),
            (b"\x01\x000A0001xP", b"_DELE", Refusal::BlockNameSyntax),
            (b"\x01\x000A99999P", b"_DELE", Refusal::BlockNumber),
        ];
        for (arguments, name, refusal) in cases {
            assert_eq!(read(&request(arguments, name)), Err(refusal), "{}", name.escape_ascii());
        }
        // No CPU's syntax, but a client sends it.
        assert_eq!(read(b"\x28\0\0\0\0\0\x08\x05\x004100075P_DELE"), Err(Refusal::CannotPerform));
        assert_eq!(read(b"\x29\0\0\0\0\0\x09P_PROGRAN"), Err(Refusal::CannotPerform));
    }

    #[test]
    fn what_is_so_already_is_an_error_with_a_second_byte() {
        let start = Job::Start(Restart::Warm);
        assert_eq!(write(&Job::Stop, &Reply::Done), (None, vec![0x29]));
        assert_eq!(write(&Job::Stop, &Reply::Already), (Some(Refusal::CannotPerform), vec![0x29, 7]));
        assert_eq!(write(&start, &Reply::Done), (None, vec![0x28]));
        assert_eq!(write(&start, &Reply::Already), (Some(Refusal::CannotPerform), vec![0x28, 3]));
        assert_eq!(write(&start, &Reply::Refused(Refusal::CannotPerform)), (Some(Refusal::CannotPerform), vec![0x28, 2]));
        assert_eq!(write(&Job::Compress, &Reply::Refused(Refusal::Protected)), (Some(Refusal::Protected), vec![0x28]));
    }
}
