//! What a server for S7 communication does and allows: `[servers.s7]` as data.

use std::net::{Ipv4Addr, SocketAddr};
use std::path::PathBuf;

use sieben_cpu::ProtectionLevel;
pub use sieben_workspace::settings::servers::{Access, Allowed, AuditLog, Password, Scope, Writes};

/// Where a server listens that is asked for nothing else.
pub const LISTEN: SocketAddr = SocketAddr::new(std::net::IpAddr::V4(Ipv4Addr::LOCALHOST), 1102);
/// Most connections at a time.
pub const CONNECTIONS_MAX: usize = 64;
/// Most connections of one address at a time: half of all, so that no client alone keeps the others out.
pub const CONNECTIONS_OF_ADDRESS_MAX: usize = 32;

/// Whether variables are written from outside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Switch {
    /// Clients write.
    #[default]
    Writable,
    /// Nothing is changed from outside: neither variables nor blocks, operating mode or clock.
    ReadOnly,
}

/// How much of a real CPU's narrowness is wanted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rigour {
    /// What clients expect works.
    #[default]
    Tolerant,
    /// Connections as on the real CPU type, one of them for a programming device and one for an operator panel; no cold restart on an S7-300.
    Strict,
}

/// Which racks and slots are connected to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Slots {
    /// All.
    #[default]
    Any,
    /// Only that of the CPU; another one is refused.
    OfTheCpu,
}

/// How long a client may take, in microseconds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Deadlines {
    /// From the first byte of a frame to its last.
    pub frame_us: u64,
    /// From the connection to the end of the setup.
    pub setup_us: u64,
    /// Without reading anything of what it was sent.
    pub unread_us: u64,
}

impl Default for Deadlines {
    fn default() -> Self {
        Self { frame_us: 10_000_000, setup_us: 10_000_000, unread_us: 10_000_000 }
    }
}

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
    pub switch: Switch,
    /// Which variables are read and written; `None`: all.
    pub allow: Option<Vec<Allowed>>,
    /// Most connections at a time, at most [`CONNECTIONS_MAX`].
    pub connections_max: usize,
    /// How much of a real CPU's narrowness is wanted.
    pub rigour: Rigour,
    /// Which racks and slots are connected to.
    pub slots: Slots,
    /// Where what is done from outside is noted.
    pub audit: Option<AuditLog>,
    /// The file that the frames are recorded in.
    pub pcap: Option<PathBuf>,
    /// How long a client may take.
    pub deadlines: Deadlines,
}

impl Default for Config {
    fn default() -> Self {
        Self {
            listen: LISTEN,
            protection: ProtectionLevel::default(),
            password: None,
            switch: Switch::default(),
            allow: None,
            connections_max: CONNECTIONS_MAX,
            rigour: Rigour::default(),
            slots: Slots::default(),
            audit: None,
            pcap: None,
            deadlines: Deadlines::default(),
        }
    }
}

impl Config {
    /// Whether variables of this scope are accessed in this way.
    pub fn allows(&self, scope: Scope, access: Access) -> bool {
        self.allow.as_ref().is_none_or(|allowed| allowed.iter().any(|entry| entry.covers(scope, access)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_allow_list_says_what_is_read_and_written() {
        let all = Config::default();
        let parse = |text: &str| Allowed::parse(text).expect("an entry");
        let some = Config { allow: Some(["M", "DB10..19 read", "DB 7", "Q read"].map(parse).to_vec()), ..Config::default() };
        for (scope, read, write) in [
            (Scope::BitMemory, true, true),
            (Scope::DataBlock(7), true, true),
            (Scope::DataBlock(10), true, false),
            (Scope::DataBlock(19), true, false),
            (Scope::DataBlock(20), false, false),
            (Scope::Outputs, true, false),
            (Scope::Inputs, false, false),
            (Scope::Timers, false, false),
        ] {
            assert!(all.allows(scope, Access::Write), "{scope:?}");
            assert_eq!((some.allows(scope, Access::Read), some.allows(scope, Access::Write)), (read, write), "{scope:?}");
        }
    }
}
