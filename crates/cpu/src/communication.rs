//! What a CPU is told of the communication around it: who asks, and what its status lists show of servers and names.

use std::net::Ipv4Addr;

/// Where a request for another operating mode comes from.
///
/// The diagnostic buffer keeps it with the request: data ID 1 says that info 2 is the IPv4 address.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Requester {
    /// The address of who asked, if it has one of IPv4.
    pub address: Option<Ipv4Addr>,
}

/// The data ID of an entry whose info 2 is the address of who asked.
const HAS_ADDRESS: u16 = 1;

impl Requester {
    /// Data ID and info 2 of an entry about the request; `otherwise` is what info 2 holds without an address.
    pub(crate) fn fields(self, otherwise: u32) -> (u16, u32) {
        self.address.map_or((0, otherwise), |address| (HAS_ADDRESS, address.to_bits()))
    }

    /// The address in an entry about a request.
    pub(crate) fn read(data_id: u16, info_2: u32) -> Option<Ipv4Addr> {
        (data_id == HAS_ADDRESS).then(|| Ipv4Addr::from_bits(info_2))
    }
}

/// What a connection may do without a password.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ProtectionLevel {
    /// Everything; no level is configured.
    #[default]
    Open,
    /// Level 2: programming devices read.
    WriteProtected,
    /// Level 3: programming devices neither read nor write.
    ReadWriteProtected,
}

impl ProtectionLevel {
    /// Its number, 1 to 3.
    pub fn number(self) -> u16 {
        match self {
            Self::Open => 1,
            Self::WriteProtected => 2,
            Self::ReadWriteProtected => 3,
        }
    }
}

/// What servers tell the CPU, for its status lists; nothing that it does depends on it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Communication {
    /// Connections of programming devices.
    pub programming_devices: u16,
    /// Connections of operator panels.
    pub operator_panels: u16,
    /// All other connections.
    pub others: u16,
    /// What a connection may do.
    pub protection: ProtectionLevel,
    /// The name of the system; empty: `Sieben`.
    pub system_name: String,
    /// The name of the module; empty: that of the CPU type.
    pub module_name: String,
    /// The designation of the plant.
    pub plant_name: String,
    /// Where a server can be reached.
    pub address: Option<Ipv4Addr>,
}
