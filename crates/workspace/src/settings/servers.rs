//! `[servers.s7]` in `sieben.toml`: what a server for S7 communication does and allows.

use std::fmt;
use std::net::SocketAddr;
use std::ops::RangeInclusive;

use sieben_cpu::ProtectionLevel;
use sieben_model::source::Span;
use toml::de::{DeTable, DeValue};

use super::{Reader, Value};

/// Most connections that a server takes.
pub const CONNECTIONS_MAX: usize = 64;
/// The file of the audit log where it is only said that there is one.
const AUDIT_FILE: &str = "audit.jsonl";

/// What `[servers]` says; all of it optional.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Servers {
    /// `[servers.s7]`, if it is there.
    pub s7: Option<S7>,
    /// `[servers.page]`, if it is there.
    pub page: Option<Page>,
}

/// What `[servers.page]` says; all of it optional.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Page {
    /// `listen`, with its place.
    pub listen: Option<(SocketAddr, Span)>,
    /// `tokens`: the file, inside the project folder, that the tokens are kept in.
    pub tokens: Option<String>,
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

impl Reader {
    /// `[servers]`: one table for each protocol.
    pub(super) fn servers(&mut self, content: &DeTable<'_>) {
        for (key, value) in content {
            if !self.known("servers", key) {
                continue;
            }
            match value.get_ref() {
                DeValue::Table(inner) if key.get_ref() == "page" => self.page(inner),
                DeValue::Table(inner) => self.s7(inner),
                _ => self.wrong(value, &format!("write `[servers.{}]` on a line of its own, and its keys below", key.get_ref())),
            }
        }
    }

    fn s7(&mut self, content: &DeTable<'_>) {
        let mut s7 = S7::default();
        for (key, value) in content {
            if !self.known("servers.s7", key) {
                continue;
            }
            match key.get_ref().as_ref() {
                "listen" => s7.listen = self.listen(value, "127.0.0.1:1102"),
                "protection" => s7.protection = self.protection(value),
                "password" => s7.password = self.password(value),
                "read_only" => s7.read_only = self.truth(value, "read_only"),
                "allow" => s7.allow = self.allow(value),
                "max_connections" => s7.connections_max = self.connections_max(value),
                "strict" => s7.strict = self.truth(value, "strict"),
                "strict_slot" => s7.strict_slot = self.truth(value, "strict_slot"),
                "audit" => s7.audit = self.audit(value),
                _ => s7.pcap = self.file(value, "pcap", "s7.pcapng"),
            }
        }
        self.settings.servers.s7 = Some(s7);
    }

    fn page(&mut self, content: &DeTable<'_>) {
        let mut page = Page::default();
        for (key, value) in content {
            if !self.known("servers.page", key) {
                continue;
            }
            match key.get_ref().as_ref() {
                "listen" => page.listen = self.listen(value, "127.0.0.1:7300"),
                _ => page.tokens = self.file(value, "tokens", "page-tokens"),
            }
        }
        self.settings.servers.page = Some(page);
    }

    fn truth(&mut self, value: &Value<'_>, name: &str) -> Option<bool> {
        match value.get_ref() {
            DeValue::Boolean(truth) => Some(*truth),
            _ => {
                self.wrong(value, &format!("`{name}` is `true` or `false`: `{name} = true`"));
                None
            }
        }
    }

    fn integer(value: &Value<'_>) -> Option<usize> {
        match value.get_ref() {
            DeValue::Integer(integer) => usize::from_str_radix(integer.as_str(), integer.radix()).ok(),
            _ => None,
        }
    }

    fn listen(&mut self, value: &Value<'_>, example: &str) -> Option<(SocketAddr, Span)> {
        let text = match value.get_ref() {
            DeValue::String(text) => text.as_ref(),
            _ => "",
        };
        let address = address(text);
        if address.is_none() {
            self.wrong(value, &format!("`listen` is an address with a port: `listen = \"{example}\"`"));
        }
        address.map(|address| (address, self.span(value.span())))
    }

    fn protection(&mut self, value: &Value<'_>) -> Option<ProtectionLevel> {
        match Self::integer(value) {
            Some(1) => Some(ProtectionLevel::Open),
            Some(2) => Some(ProtectionLevel::WriteProtected),
            Some(3) => Some(ProtectionLevel::ReadWriteProtected),
            _ => {
                self.wrong(
                    value,
                    "`protection` is a level: 1 for none, 2 against writing, 3 against reading and writing: `protection = 2`",
                );
                None
            }
        }
    }

    fn password(&mut self, value: &Value<'_>) -> Option<Password> {
        let password = match value.get_ref() {
            DeValue::String(text) => Password::new(text),
            _ => None,
        };
        if password.is_none() {
            let most = Password::CHARACTERS_MAX;
            self.wrong(
                value,
                &format!("`password` is a string of 1 to {most} letters, digits and signs of ASCII: `password = \"secret\"`"),
            );
        }
        password
    }

    fn allow(&mut self, value: &Value<'_>) -> Option<Vec<Allowed>> {
        let DeValue::Array(entries) = value.get_ref() else {
            self.wrong(value, "`allow` is a list of areas and data blocks: `allow = [\"DB1\", \"DB10..19\", \"M\", \"I read\"]`");
            return None;
        };
        let mut allowed = Vec::new();
        for entry in entries {
            let text = match entry.get_ref() {
                DeValue::String(text) => text.as_ref(),
                _ => "",
            };
            match Allowed::parse(text) {
                Some(entry) => allowed.push(entry),
                None => self.wrong(
                    entry,
                    "an entry of `allow` is an area (`I`, `Q`, `M`, `P`, `T`, `C`), a data block (`DB1`) or a range of them (`DB10..19`), \
                     with ` read` after it if nothing is written there",
                ),
            }
        }
        Some(allowed)
    }

    fn connections_max(&mut self, value: &Value<'_>) -> Option<usize> {
        let count = Self::integer(value).filter(|count| (1..=CONNECTIONS_MAX).contains(count));
        if count.is_none() {
            self.wrong(value, &format!("`max_connections` is a number from 1 to {CONNECTIONS_MAX}: `max_connections = 16`"));
        }
        count
    }

    fn audit(&mut self, value: &Value<'_>) -> Option<AuditLog> {
        let plain = |file| AuditLog { file, writes: Writes::default(), required: false };
        match value.get_ref() {
            DeValue::Boolean(true) => Some(plain(AUDIT_FILE.to_owned())),
            DeValue::Boolean(false) => None,
            DeValue::String(_) => self.file(value, "audit", AUDIT_FILE).map(plain),
            DeValue::Table(inner) => {
                let mut log = plain(AUDIT_FILE.to_owned());
                for (key, value) in inner {
                    if !self.known("servers.s7.audit", key) {
                        continue;
                    }
                    match key.get_ref().as_ref() {
                        "file" => log.file = self.file(value, "file", AUDIT_FILE).unwrap_or(log.file),
                        "required" => log.required = self.truth(value, "required").unwrap_or_default(),
                        _ => log.writes = self.writes(value).unwrap_or_default(),
                    }
                }
                Some(log)
            }
            _ => {
                self.wrong(
                    value,
                    &format!("`audit` is a file: `audit = \"{AUDIT_FILE}\"`, or a table with `file`, `writes` and `required`"),
                );
                None
            }
        }
    }

    fn writes(&mut self, value: &Value<'_>) -> Option<Writes> {
        match value.get_ref() {
            DeValue::String(text) if text == "merged" => Some(Writes::Merged),
            DeValue::String(text) if text == "all" => Some(Writes::All),
            _ => {
                self.wrong(value, "`writes` says which writes are noted: `merged` (a second of writes to one item is a record) or `all`");
                None
            }
        }
    }

    /// The name of a file that lies in the folder of the project: one of a stranger writes nowhere else.
    fn file(&mut self, value: &Value<'_>, name: &str, example: &str) -> Option<String> {
        let file = match value.get_ref() {
            DeValue::String(text) => text.as_ref(),
            _ => "",
        };
        let is_plain = |part: &str| !part.is_empty() && !part.starts_with('.') && !part.contains(['\\', ':', '\0']);
        if file.split('/').all(is_plain) {
            return Some(file.to_owned());
        }
        self.wrong(value, &format!("`{name}` is a file in the folder of the project, by its path from there: `{name} = \"{example}\"`"));
        None
    }
}

/// An address with a port; `localhost` is 127.0.0.1, and a port alone is one of it.
pub fn address(text: &str) -> Option<SocketAddr> {
    let text = text.trim();
    if let Ok(port) = text.parse::<u16>() {
        return Some(SocketAddr::from(([127, 0, 0, 1], port)));
    }
    match text.strip_prefix("localhost:") {
        Some(port) => port.parse().ok().map(|port: u16| SocketAddr::from(([127, 0, 0, 1], port))),
        None => text.parse().ok(),
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

    fn read(text: &str) -> (Option<S7>, Vec<String>) {
        let (settings, diagnostics) = super::super::parse(text, sieben_model::source::FileId(0));
        let said = |diagnostic: sieben_model::diagnostic::Diagnostic| format!("{}: {}", diagnostic.problem.code(), diagnostic.message);
        (settings.servers.s7, diagnostics.into_iter().map(said).collect())
    }

    #[test]
    fn every_key_is_read() {
        let (s7, wrong) = read(
            "[servers.s7]\nlisten = \"0.0.0.0:102\"\nprotection = 3\npassword = \"secret\"\nread_only = true\nallow = [\"M\", \"DB1..9 read\"]\n\
             max_connections = 8\nstrict = true\nstrict_slot = true\npcap = \"logs/s7.pcapng\"\n\
             [servers.s7.audit]\nfile = \"logs/audit.jsonl\"\nwrites = \"all\"\nrequired = true\n",
        );
        assert_eq!(wrong, [""; 0]);
        let mut s7 = s7.expect("a server");
        assert_eq!(s7.listen.take().map(|(address, _)| address.to_string()).as_deref(), Some("0.0.0.0:102"));
        let expected = S7 {
            listen: None,
            protection: Some(ProtectionLevel::ReadWriteProtected),
            password: Password::new("secret"),
            read_only: Some(true),
            allow: Some(["M", "DB1..9 READ"].map(|text| Allowed::parse(text).expect("an entry")).to_vec()),
            connections_max: Some(8),
            strict: Some(true),
            strict_slot: Some(true),
            audit: Some(AuditLog { file: "logs/audit.jsonl".to_owned(), writes: Writes::All, required: true }),
            pcap: Some("logs/s7.pcapng".to_owned()),
        };
        assert_eq!(s7, expected);
        let log = |text: &str| read(&format!("[servers.s7]\naudit = {text}\n")).0.expect("a server").audit.map(|audit| audit.file);
        assert_eq!([log("true"), log("false"), log("\"a.jsonl\"")], [Some(AUDIT_FILE.to_owned()), None, Some("a.jsonl".to_owned())]);
        assert_eq!(read("[servers.s7]\n").0, Some(S7::default()));
        assert_eq!(read("").0, None);
    }

    #[test]
    fn what_is_wrong_is_said_and_the_rest_holds() {
        for (key, part) in [
            ("listen = \"somewhere\"", "P6009: `listen` is an address"),
            ("listen = \"example.org:102\"", "P6009: `listen` is an address"),
            ("protection = 4", "P6009: `protection` is a level"),
            ("password = \"much too long\"", "P6009: `password` is a string of 1 to 8"),
            ("password = 5", "P6009: `password` is a string"),
            ("read_only = \"yes\"", "P6009: `read_only` is `true` or `false`"),
            ("allow = \"M\"", "P6009: `allow` is a list"),
            ("allow = [\"V\"]", "P6009: an entry of `allow`"),
            ("max_connections = 65", "P6009: `max_connections` is a number from 1 to 64"),
            ("max_connections = 0", "P6009: `max_connections` is a number from 1 to 64"),
            ("audit = 1", "P6009: `audit` is a file"),
            ("audit = \"/var/log/audit\"", "P6009: `audit` is a file in the folder"),
            ("audit = { writes = \"some\" }", "P6009: `writes` says which"),
            ("audit = { fiel = \"x\" }", "P6008: there is no key `fiel`"),
            ("pcap = \"../s7.pcapng\"", "P6009: `pcap` is a file in the folder"),
            ("pcap = \".git/config\"", "P6009: `pcap` is a file in the folder"),
            ("port = 102", "P6008: there is no key `port`"),
        ] {
            let (s7, wrong) = read(&format!("[servers.s7]\n{key}\nstrict = true\n"));
            assert_eq!(s7.expect("a server").strict, Some(true), "{key}");
            assert!(matches!(&wrong[..], [one] if one.starts_with(part)), "{key}: {wrong:?}");
        }
    }

    #[test]
    fn the_page_has_an_address_and_a_file_of_tokens() {
        let page = |text: &str| {
            let (settings, diagnostics) = super::super::parse(text, sieben_model::source::FileId(0));
            (settings.servers.page, diagnostics.into_iter().map(|one| one.message).collect::<Vec<_>>())
        };
        let (read, wrong) = page("[servers.page]\nlisten = \"0.0.0.0:7300\"\ntokens = \"page-tokens\"\n");
        assert_eq!(wrong, [""; 0]);
        let read = read.expect("a page");
        assert_eq!(read.listen.map(|(address, _)| address.to_string()).as_deref(), Some("0.0.0.0:7300"));
        assert_eq!(read.tokens.as_deref(), Some("page-tokens"));
        for (text, part) in [
            ("listen = 1", "`listen` is an address with a port: `listen = \"127.0.0.1:7300\"`"),
            ("tokens = \"/etc/passwd\"", "`tokens` is a file in the folder of the project"),
            ("users = []", "there is no key `users`"),
        ] {
            let (read, wrong) = page(&format!("[servers.page]\n{text}\n"));
            assert!(read.is_some() && matches!(&wrong[..], [one] if one.starts_with(part)), "{text}: {wrong:?}");
        }
        assert_eq!(page("").0, None);
    }

    #[test]
    fn an_address_may_be_a_port_alone() {
        for (text, expected) in [
            ("1102", Some("127.0.0.1:1102")),
            ("localhost:102", Some("127.0.0.1:102")),
            ("[::1]:1102", Some("[::1]:1102")),
            ("0.0.0.0:102", Some("0.0.0.0:102")),
            ("127.0.0.1", None),
            ("99999", None),
            ("", None),
        ] {
            assert_eq!(address(text).map(|address| address.to_string()).as_deref(), expected, "{text}");
        }
    }
}
