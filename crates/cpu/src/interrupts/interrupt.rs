//! Events from outside the program that start an organization block.

use sieben_model::block::BlockId;

use crate::organization_blocks as ob;
use crate::start_information::StartInformation;

/// Whether a disturbance begins or ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coming {
    /// It begins: event class 16#39.
    Coming,
    /// It is over: event class 16#38.
    Going,
}

impl Coming {
    fn class(self) -> u16 {
        match self {
            Self::Coming => 0x3900,
            Self::Going => 0x3800,
        }
    }
}

/// A module by its logical address.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModuleAddress {
    /// First input byte.
    Input(u16),
    /// First output byte, of a module without inputs.
    Output(u16),
}

impl ModuleAddress {
    /// IO_FLAG of the start information.
    fn flag(self) -> u16 {
        match self {
            Self::Input(_) => 0x54,
            Self::Output(_) => 0x55,
        }
    }
    fn byte(self) -> u16 {
        match self {
            Self::Input(byte) | Self::Output(byte) => byte,
        }
    }
}

/// What a module reports about its insertion or removal: the second byte of the event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exchange {
    /// Plugged in, and it is the type that is configured.
    Inserted,
    /// Plugged in, and it is another type.
    WrongType,
    /// Pulled.
    Removed,
}

/// An interrupt or asynchronous error, with the start information of its organization block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interrupt(StartInformation);

impl Interrupt {
    fn new(number: u16, event: u16, data_id: u16, info_1: u16, info_2: u32) -> Self {
        let block = BlockId::ob(number);
        Self(StartInformation { event, priority: ob::priority(block), block: number as u8, data_id, info_1, info_2 })
    }

    /// Any event with its fields: the organization block, event, bytes 4 and 5, 6 and 7, 8 to 11.
    /// `None` if no event starts such a block: 10 to 17, 20 to 23, 30 to 38, 40 to 47, 55 to 57, 60 and 80 to 87 can be started.
    pub fn event(number: u16, event: u16, data_id: u16, info_1: u16, info_2: u32) -> Option<Self> {
        ob::is_interrupt(number).then(|| Self::new(number, event, data_id, info_1, info_2))
    }

    /// The event that an organization block usually has, without details; `None` if no event starts such a block.
    pub fn usual(number: u16) -> Option<Self> {
        let event = match number {
            10..=17 => 0x1111 + (number - 10),
            20..=23 => 0x1121 + (number - 20),
            30..=38 => 0x1131 + (number - 30),
            40..=47 => return Some(Self::hardware((number - 40) as u8, ModuleAddress::Input(0), 0)),
            55..=57 => status_event(number),
            60 => return Some(Self::multicomputing(0)),
            80 => 0x3501,
            81 => 0x3921,
            82 => return Some(Self::diagnostic(Coming::Coming, ModuleAddress::Input(0), 0x0100_0000)),
            83 => return Some(Self::exchange(Exchange::Removed, ModuleAddress::Input(0), 0, 0)),
            84 => 0x3583,
            85 => 0x35A3,
            86 => 0x39C1,
            87 => 0x35E1,
            _ => return None,
        };
        Some(Self::new(number, event, 0, 0, 0))
    }

    /// Hardware interrupt, OB 40 to OB 47: its line counts from 0, up to 7. `point` says which input of the module, one bit each.
    pub fn hardware(line: u8, module: ModuleAddress, point: u32) -> Self {
        // The second byte names the interrupt line of the CPU; modules of this rack all use the first.
        Self::new(40 + u16::from(line & 7), 0x1141, module.flag(), module.byte(), point)
    }

    /// Status (OB 55), update (OB 56) or manufacturer interrupt (OB 57) of a DPV1 slave: length, type, slot and specifier of its data.
    pub fn status(kind: StatusKind, module: ModuleAddress, data: [u8; 4]) -> Self {
        let number = match kind {
            StatusKind::Status => 55,
            StatusKind::Update => 56,
            StatusKind::Manufacturer => 57,
        };
        Self::new(number, status_event(number), module.flag(), module.byte(), u32::from_be_bytes(data))
    }

    /// Multicomputing interrupt that this CPU has raised, OB 60, with the job that the program gave (1 to 15).
    pub fn multicomputing(job: u8) -> Self {
        Self::new(60, 0x1161, 0, u16::from(job), 0)
    }

    /// Diagnostic interrupt, OB 82: the first four bytes of the diagnostic data of the module.
    pub fn diagnostic(coming: Coming, module: ModuleAddress, data: u32) -> Self {
        Self::new(82, coming.class() | 0x42, module.flag(), module.byte(), data)
    }

    /// A module was plugged in or pulled, OB 83, with its rack and its type.
    pub fn exchange(what: Exchange, module: ModuleAddress, rack: u16, module_type: u16) -> Self {
        let event = match what {
            Exchange::Inserted => 0x3861,
            Exchange::WrongType => 0x3863,
            Exchange::Removed => 0x3961,
        };
        Self::new(83, event, 0xC400 | module.flag(), module.byte(), u32::from(rack) << 16 | u32::from(module_type))
    }

    /// Power supply, OB 81: 16#21, 22, 23 battery, backup voltage and 24 V of the central rack, 16#31 to 33 those of an expansion rack.
    pub fn power_supply(coming: Coming, what: u8, rack: u16) -> Self {
        Self::new(81, coming.class() | u16::from(what), 0, rack, 0)
    }

    /// Rack or station, OB 86: 16#C1 a rack, 16#C3 a DP master system, 16#C4 and C5 a station; `failed` has one bit per rack.
    pub fn rack_failure(coming: Coming, what: u8, module: u16, failed: u32) -> Self {
        Self::new(86, coming.class() | u16::from(what), 0, module, failed)
    }

    /// The start information of the organization block.
    pub fn start_information(&self) -> StartInformation {
        self.0
    }
}

/// The event of OB 55, OB 56 or OB 57: its second byte shows the number of the block in hexadecimal digits.
fn status_event(number: u16) -> u16 {
    0x1155 + (number - 55)
}

/// The three interrupts of a DPV1 slave.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StatusKind {
    /// OB 55.
    Status,
    /// OB 56.
    Update,
    /// OB 57.
    Manufacturer,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_interrupt_block_has_a_usual_event_with_a_text() {
        for number in 0..=u16::from(u8::MAX) {
            let usual = Interrupt::usual(number);
            assert_eq!(usual.is_some(), ob::is_interrupt(number), "OB {number}");
            let Some(Interrupt(info)) = usual else { continue };
            assert_eq!(u16::from(info.block), number);
            assert!(info.priority > 0, "OB {number}");
            if ob::is_asynchronous_error(number) {
                assert_ne!(crate::diagnostic_buffer::event_text(info.event), "unknown event", "16#{:04X}", info.event);
            }
        }
    }
}
