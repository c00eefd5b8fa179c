//! Setup of the communication: how long a PDU is, and how many jobs may be under way.

use sieben_model::cpu_type::CpuType;

use super::codes::Refusal;
use super::cotp;

/// The function code.
pub const FUNCTION: u8 = 0xF0;
/// The shortest PDU that is agreed on: clients rely on it, also those that offer less.
const PDU_BYTES_MIN: u16 = 240;
/// The longest PDU of all CPU types.
pub const PDU_BYTES_MAX: u16 = 480;
/// Jobs of one connection that may wait for their answers.
pub const JOBS_MAX: u16 = 8;

/// What a client offers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Offer {
    /// Jobs that it may have under way.
    pub jobs_calling: u16,
    /// Jobs that the CPU may have under way.
    pub jobs_called: u16,
    /// Bytes of the longest PDU.
    pub pdu_bytes: u16,
}

/// Reads the parameters of the job, function code included.
///
/// # Errors
/// They have another length.
pub fn read(parameters: &[u8]) -> Result<Offer, Refusal> {
    match *parameters {
        [FUNCTION, _, a, b, c, d, e, f] => Ok(Offer {
            jobs_calling: u16::from_be_bytes([a, b]),
            jobs_called: u16::from_be_bytes([c, d]),
            pdu_bytes: u16::from_be_bytes([e, f]),
        }),
        _ => Err(Refusal::WrongFrame),
    }
}

impl Offer {
    /// What is agreed on with a CPU over TPDUs of so many bytes.
    #[must_use]
    pub fn agreed(self, cpu: &CpuType, tpdu_bytes: usize) -> Self {
        let jobs = |offered: u16| offered.clamp(1, JOBS_MAX);
        let mut pdu_bytes = self.pdu_bytes.clamp(PDU_BYTES_MIN, cpu.pdu);
        // A TPDU counts its head too. What is still longer than one goes out in fragments.
        if usize::from(pdu_bytes) + cotp::DATA_HEAD > tpdu_bytes {
            pdu_bytes = PDU_BYTES_MIN;
        }
        Self { jobs_calling: jobs(self.jobs_calling), jobs_called: jobs(self.jobs_called), pdu_bytes }
    }

    /// The parameters of the answer.
    pub fn write(self) -> [u8; 8] {
        let [a, b] = self.jobs_calling.to_be_bytes();
        let [c, d] = self.jobs_called.to_be_bytes();
        let [e, f] = self.pdu_bytes.to_be_bytes();
        [FUNCTION, 0, a, b, c, d, e, f]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pdu_is_as_long_as_both_sides_and_the_tpdu_allow() {
        let [cpu_315, cpu_416] = ["315-2PN/DP", "416-3"].map(|name| CpuType::by_name(name).expect("a CPU type"));
        let rows = [
            (cpu_315, 480, 1024, 240),
            (cpu_315, 960, 1024, 240),
            (cpu_416, 960, 1024, 480),
            (cpu_416, 960, 512, 480),
            (cpu_416, 960, 256, 240),
            (cpu_416, 300, 1024, 300),
            (cpu_416, 0, 1024, 240),
            (cpu_315, 1, 128, 240),
            (cpu_315, u16::MAX, 1024, 240),
        ];
        for (cpu, offered, tpdu_bytes, agreed) in rows {
            let offer = Offer { jobs_calling: 0, jobs_called: 100, pdu_bytes: offered };
            let expected = Offer { jobs_calling: 1, jobs_called: 8, pdu_bytes: agreed };
            assert_eq!(offer.agreed(cpu, tpdu_bytes), expected, "{} {offered} {tpdu_bytes}", cpu.name);
        }
    }
}
