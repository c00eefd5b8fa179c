//! What a server for S7 communication does and allows: `[servers.s7]` as data.

use std::net::{IpAddr, Ipv4Addr, SocketAddr};

use sieben_cpu::ProtectionLevel;
use sieben_model::cpu_type::CpuType;
pub use sieben_workspace::settings::servers::CONNECTIONS_MAX;
use sieben_workspace::settings::servers::{Allowed, AuditLog, Password, S7};

use crate::s7comm::guard::{Rules, Writing};

/// Where a server listens that is asked for nothing else.
pub const LISTEN: SocketAddr = SocketAddr::new(IpAddr::V4(Ipv4Addr::LOCALHOST), 1102);
/// Most connections of one address at a time: half of all, so that no client alone keeps the others out.
pub const CONNECTIONS_OF_ADDRESS_MAX: usize = 32;

/// What a server for S7 communication does and allows.
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// Where it listens.
    pub listen: SocketAddr,
    /// What a connection may do without the password.
    pub protection: ProtectionLevel,
    /// What lifts the protection for a connection.
    pub password: Option<Password>,
    /// Whether anything is changed from outside.
    pub writing: Writing,
    /// Which variables are read and written; `None`: all.
    pub allow: Option<Vec<Allowed>>,
    /// Most connections at a time, at most [`CONNECTIONS_MAX`].
    pub connections_max: usize,
    /// Connections and restarts as the real CPU type has them.
    pub strict: bool,
    /// Only the rack and slot of the CPU are connected to.
    pub strict_slot: bool,
    /// Where what is done from outside is noted.
    pub audit: Option<AuditLog>,
    /// The file that frames are recorded in.
    pub pcap: Option<String>,
}

impl Default for Config {
    fn default() -> Self {
        Self::of(&S7::default())
    }
}

impl Config {
    /// What `[servers.s7]` says, with the defaults for what it does not say.
    pub fn of(file: &S7) -> Self {
        Self {
            listen: file.listen.map_or(LISTEN, |(address, _)| address),
            protection: file.protection.unwrap_or_default(),
            password: file.password.clone(),
            writing: if file.read_only == Some(true) { Writing::ReadOnly } else { Writing::Allowed },
            allow: file.allow.clone(),
            connections_max: file.connections_max.unwrap_or(CONNECTIONS_MAX).min(CONNECTIONS_MAX),
            strict: file.strict == Some(true),
            strict_slot: file.strict_slot == Some(true),
            audit: file.audit.clone(),
            pcap: file.pcap.clone(),
        }
    }

    /// What it means for the connections to a CPU of this type.
    pub fn rules(&self, cpu: &'static CpuType) -> Rules {
        Rules {
            cpu,
            protection: self.protection,
            password: self.password.as_ref().map(Password::characters),
            writing: self.writing,
            allow: self.allow.clone(),
            strict: self.strict,
            strict_slot: self.strict_slot,
        }
    }
}
