//! `[servers.s7]` in `sieben.toml`: what a server for S7 communication does and allows.

use std::fmt;
use std::net::SocketAddr;
use std::ops::RangeInclusive;

use sieben_cpu::ProtectionLevel;
use sieben_model::source::Span;

/// What `[servers]` says; all of it optional.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Servers {
    /// `[servers.s7]`, if it is there.
    pub s7: Option<S7>,
}

/// What `[servers.s7]` says; all of it optional.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct S7 {
    /// `listen`, with its place.
    pub listen: Option<(SocketAddr, Span)>,
    /// `protection`: the level that a connection has without the password.
    pub protection: Option<ProtectionLevel>,
    /// `password`.
    pub password: Option<Password>,
    /// `read_only`.
    pub read_only: Option<bool>,
    /// `allow`: which variables are read and written; `None`: all.
    pub allow: Option<Vec<Allowed>>,
    /// `max_connections`.
    pub connections_max: Option<usize>,
    /// `strict`: connections and restarts as the real CPU type has them.
    pub strict: Option<bool>,
    /// `strict_slot`: only the rack and slot of the CPU are connected to.
    pub strict_slot: Option<bool>,
    /// `audit`: where what is done from outside is noted.
    pub audit: Option<AuditLog>,
    /// `pcap`: the file, inside the project folder, that frames are recorded in.
    pub pcap: Option<String>,
}

/// A password as a CPU has it: eight characters, short ones filled with spaces.
#[derive(Clone, PartialEq, Eq)]
pub struct Password([u8; Password::CHARACTERS_MAX]);

impl Password {
    /// Most characters.
    pub const CHARACTERS_MAX: usize = 8;

    /// A password of one to eight printable ASCII characters.
    pub fn new(text: &str) -> Option<Self> {
        let fits = (1..=Self::CHARACTERS_MAX).contains(&text.len()) && text.bytes().all(|byte| (b' '..=b'~').contains(&byte));
        fits.then(|| {
            let mut bytes = [b' '; Self::CHARACTERS_MAX];
            bytes.iter_mut().zip(text.bytes()).for_each(|(to, from)| *to = from);
            Self(bytes)
        })
    }

    /// Its eight characters.
    pub fn characters(&self) -> [u8; Self::CHARACTERS_MAX] {
        self.0
    }
}

impl fmt::Debug for Password {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Password(…)")
    }
}

/// Which variables an entry of an allow-list is about.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Scope {
    /// I.
    Inputs,
    /// Q.
    Outputs,
    /// M.
    BitMemory,
    /// P: peripheral inputs and outputs.
    Peripheral,
    /// T.
    Timers,
    /// C.
    Counters,
    /// Data blocks with these numbers.
    DataBlocks(RangeInclusive<u16>),
}

/// What may be done to variables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Access {
    /// They are read.
    Read,
    /// They are read and written.
    ReadAndWrite,
}

/// Which writes a log has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Writes {
    /// Those of a client to the same item within a second are one record.
    #[default]
    Merged,
    /// Each one is a record.
    All,
}

/// Where what is done from outside is noted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AuditLog {
    /// The file, inside the project folder.
    pub file: String,
    /// Which writes it has.
    pub writes: Writes,
    /// Whether what cannot be noted is refused.
    pub required: bool,
}

/// An entry of an allow-list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Allowed {
    /// Which variables.
    pub scope: Scope,
    /// What may be done to them.
    pub access: Access,
}

/// How an allow-list names the areas, in both mnemonic languages.
const AREAS: [(&str, Scope); 9] = [
    ("I", Scope::Inputs),
    ("E", Scope::Inputs),
    ("Q", Scope::Outputs),
    ("A", Scope::Outputs),
    ("M", Scope::BitMemory),
    ("P", Scope::Peripheral),
    ("T", Scope::Timers),
    ("C", Scope::Counters),
    ("Z", Scope::Counters),
];

impl Allowed {
    /// An entry: `M`, `DB7`, `DB10..19`; with ` read` after it nothing is written there.
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim().to_ascii_uppercase();
        let (what, access) = match text.strip_suffix("READ") {
            Some(what) if what.ends_with(char::is_whitespace) => (what.trim_end(), Access::Read),
            _ => (text.as_str(), Access::ReadAndWrite),
        };
        let scope = match AREAS.iter().find(|(name, _)| *name == what) {
            Some((_, scope)) => scope.clone(),
            None => {
                let numbers = what.strip_prefix("DB")?;
                let number = |text: &str| text.trim().parse::<u16>().ok().filter(|&number| number > 0);
                let (first, last) = numbers.split_once("..").unwrap_or((numbers, numbers));
                let range = number(first)?..=number(last)?;
                (!range.is_empty()).then_some(Scope::DataBlocks(range))?
            }
        };
        Some(Self { scope, access })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_of_an_allow_list_are_read_and_others_are_not() {
        let blocks = Allowed::parse("db10 ..19 read").expect("an entry");
        assert_eq!(blocks, Allowed { scope: Scope::DataBlocks(10..=19), access: Access::Read });
        assert_eq!(Allowed::parse("e"), Some(Allowed { scope: Scope::Inputs, access: Access::ReadAndWrite }));
        for text in ["M", "e", "Z read", "DB1", "DB 7", "db10..19", "DB10 .. 19 READ", "DB65535"] {
            assert!(Allowed::parse(text).is_some(), "{text}");
        }
        for text in ["", "X", "DB", "DB0", "DB9..1", "DB1..", "DB65536", "MREAD", "DB1 write", "M0..9"] {
            assert_eq!(Allowed::parse(text), None, "{text}");
        }
    }

    #[test]
    fn a_password_has_up_to_eight_characters_and_is_not_shown() {
        let password = Password::new("secret").expect("a password");
        assert_eq!(password.characters(), *b"secret  ");
        for text in ["", "ninechars", "ü", "tab\t"] {
            assert_eq!(Password::new(text), None, "{text}");
        }
        assert!(!format!("{password:?}").contains("secret"));
    }
}
