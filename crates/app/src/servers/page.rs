//! The page of a run: where it is served, to whom, and what is written down of it.

use std::ffi::OsStr;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr, TcpListener, UdpSocket};
use std::path::Path;
use std::sync::Arc;

use rustix::rand::{GetRandomFlags, getrandom};
use sieben_comm::recording::audit::Audit;
use sieben_model::problems::Problem;
use sieben_workbench::access::{Access, Tokens};
use sieben_workbench::{PORT, Page, Projects, Reference, Setup};
use sieben_workspace::Gate;
use sieben_workspace::control::CurrentFacts;
use sieben_workspace::metrics;
use sieben_workspace::settings::servers::{Page as PageSettings, Writes, address};
use sieben_workspace::status::Desk;

use super::{Content, Kind, PORTS_MAX, ServerArguments, Servers, not_written, open, served, wall_us};
use crate::failure::Failure;
use crate::folder::{self, Folder};

/// Where the page is served if nothing else is said.
pub(super) const LISTEN: SocketAddr = SocketAddr::new(IpAddr::V4(Ipv4Addr::LOCALHOST), PORT);
/// Where what is done at pages is noted.
const AUDIT_FILE: &str = ".sieben/audit.log";
/// Where the tokens are kept, if nothing else is said.
const TOKENS_FILE: &str = ".sieben/page-tokens";
/// Bytes of a file of tokens that are read.
const TOKENS_BYTES_MAX: u64 = 4 * 1024;
/// Fewest characters of a token that a user has chosen.
const TOKEN_CHARACTERS_MIN: usize = 16;

/// A page that is about to be served: it listens already, so that what is wrong with its address is said before the run begins.
pub(crate) struct PreparedPage {
    listener: TcpListener,
    access: Access,
    audit: Option<Audit>,
    opens: Opens,
}

/// Whether the page is opened in a browser.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Opens {
    No,
    Yes,
}

/// A page that is served, and the log of what is done there.
pub(crate) struct ServedPage {
    page: Page,
    tokens: Option<Tokens>,
    /// The log is open as long as this is there.
    _audit: Option<Audit>,
}

/// Whether a run has a page although none was asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Usually {
    /// Only where one is asked for.
    Without,
    /// Unless it is left out.
    With,
}

impl ServerArguments {
    /// Listens for the page, if there is to be one. `home` is the folder of the project.
    pub(crate) fn prepare_page(
        &self,
        settings: Option<&PageSettings>,
        home: Option<&Path>,
        usually: Usually,
    ) -> Result<Option<PreparedPage>, Failure> {
        let exposed = self.exposed(Kind::Page);
        let asked = self.page.is_some() || exposed.is_some() || self.open;
        if self.no_page || !asked && usually == Usually::Without {
            return Ok(None);
        }
        let named = match self.page.as_deref() {
            Some(word) if !word.is_empty() => Some(address(word).ok_or_else(|| {
                Failure::usage(Problem::P7001, format!("`{word}` is no address with a port"))
                    .help("write `--page 127.0.0.1:7300`, or `--page` alone")
            })?),
            _ => None,
        };
        let of_file = settings.and_then(|page| page.listen.as_ref()).map(|&(address, _)| address);
        let chosen = named.or(of_file).or(exposed);
        let wanted = chosen.unwrap_or(LISTEN);
        self.check(Kind::Page, wanted)?;
        let listener = match listen(wanted, chosen) {
            Ok(listener) => listener,
            // A run for which no page was asked goes on without one.
            Err(_) if !asked => return Ok(None),
            Err(error) => return Err(super::not_listening(Kind::Page, wanted, &error)),
        };
        let is_ours = wanted.ip().to_canonical().is_loopback();
        let file = settings.and_then(|page| page.tokens.as_deref());
        let tokens = match (file, is_ours) {
            (None, true) => None,
            (file, _) => Some(tokens(home, file.unwrap_or(TOKENS_FILE))?),
        };
        let audit = home.map(|home| -> Result<Audit, Failure> {
            let sink = open(home, AUDIT_FILE, Content::Kept).map_err(|error| not_written(AUDIT_FILE, &error))?;
            let no_thread = |error: io::Error| Failure::usage(Problem::P7103, format!("no thread can be started: {error}"));
            Audit::start(sink, Writes::All, false).map_err(no_thread)
        });
        let opens = if self.open { Opens::Yes } else { Opens::No };
        let access = Access { listen: wanted, exposed: !is_ours, tokens };
        Ok(Some(PreparedPage { listener, access, audit: audit.transpose()?, opens }))
    }
}

/// Listens at the address that was chosen, or else at the usual one or the next free one.
fn listen(wanted: SocketAddr, chosen: Option<SocketAddr>) -> io::Result<TcpListener> {
    let more = if chosen.is_some() { 0 } else { PORTS_MAX };
    let mut listening = Err(io::Error::from(ErrorKind::AddrInUse));
    for port in wanted.port()..=wanted.port().saturating_add(more) {
        listening = sieben_workbench::listen(SocketAddr::new(wanted.ip(), port));
        if !matches!(&listening, Err(error) if error.kind() == ErrorKind::AddrInUse) {
            break;
        }
    }
    listening
}

impl PreparedPage {
    /// Begins to serve.
    pub(crate) fn start(
        self,
        (gate, desk, facts): (&Arc<Gate>, &Arc<Desk>, &Arc<CurrentFacts>),
        servers: Option<&Servers>,
        reference: Box<dyn Reference>,
        projects: Arc<dyn Projects>,
    ) -> Result<ServedPage, Failure> {
        let viewer = servers.map(|servers| servers.s7.viewer());
        // A run that is over already has nothing to measure.
        let _ = gate.enter(|plant| plant.cpu.measure_blocks());
        let measured = Arc::clone(gate);
        let text = move || {
            let served: Vec<metrics::Served> = viewer.iter().map(|viewer| served(viewer.view())).collect();
            metrics::text(&measured, &served).ok()
        };
        if let Some(audit) = &self.audit {
            let log = audit.of_control();
            facts.add_listener(Box::new(move |peer, changes| log.note(peer, changes, wall_us())));
        }
        let tokens = self.access.tokens.clone();
        let setup = Setup {
            gate: Arc::clone(gate),
            desk: Arc::clone(desk),
            facts: Arc::clone(facts),
            reference,
            projects,
            metrics: Box::new(text),
            access: self.access,
        };
        let no_thread = |error: io::Error| Failure::usage(Problem::P7102, format!("the page cannot be served: {error}"));
        let page = Page::start(self.listener, setup).map_err(no_thread)?;
        let served = ServedPage { page, tokens, _audit: self.audit };
        facts.set_page(format!("http://{}/", reached_at(served.address())));
        if self.opens == Opens::Yes {
            served.open();
        }
        Ok(served)
    }
}

impl ServedPage {
    /// Where it is served.
    pub(crate) fn address(&self) -> SocketAddr {
        self.page.address()
    }

    /// Where it is, for people; with the tokens, if it has some.
    pub(crate) fn text(&self) -> String {
        let address = reached_at(self.address());
        match &self.tokens {
            None => format!("The page is at http://{address}/.\n"),
            Some(Tokens { program, view }) => format!(
                "The page is at http://{address}/?token={program}\n\
                 to view only: http://{address}/?token={view}\n\
                 Other computers reach it: HTTP has no encryption, and who has the first token starts and stops this CPU.\n"
            ),
        }
    }

    /// Opens it in the browser of this user; where there is none its address is printed all the same.
    fn open(&self) {
        let token = self.tokens.as_ref().map_or_else(String::new, |tokens| format!("?token={}", tokens.program));
        let address = format!("http://{}/{token}", reached_at(self.address()));
        let quiet = std::process::Stdio::null;
        let opened = std::process::Command::new("xdg-open").arg(address).stdin(quiet()).stdout(quiet()).stderr(quiet()).spawn();
        if let Ok(mut opener) = opened {
            // It ends as soon as the browser has the address.
            let _ = std::thread::Builder::new().name("opener".to_owned()).spawn(move || opener.wait());
        }
    }
}

/// Where others reach what listens at all addresses of this computer: at the one that leads out of it.
fn reached_at(listening: SocketAddr) -> SocketAddr {
    if !listening.ip().is_unspecified() {
        return listening;
    }
    // Addresses of the documentation: nothing is sent there, only the way to them is looked up.
    let far: IpAddr =
        if listening.is_ipv4() { Ipv4Addr::new(192, 0, 2, 1).into() } else { Ipv6Addr::new(0x2001, 0xDB8, 0, 0, 0, 0, 0, 1).into() };
    let way = UdpSocket::bind((listening.ip(), 0)).and_then(|socket| socket.connect((far, 9)).and_then(|()| socket.local_addr()));
    let here: IpAddr = if listening.is_ipv4() { Ipv4Addr::LOCALHOST.into() } else { Ipv6Addr::LOCALHOST.into() };
    SocketAddr::new(way.map_or(here, |way| way.ip()), listening.port())
}

fn not_kept(file: &str, why: &str) -> Failure {
    Failure::usage(Problem::P7140, format!("the tokens of the page cannot be kept in `{file}`: {why}"))
}

/// The tokens that a file has; new ones where there is no such file. Without a project they live as long as the run.
fn tokens(home: Option<&Path>, file: &str) -> Result<Tokens, Failure> {
    let Some(home) = home else { return new_tokens().map_err(|error| not_kept(file, &error.to_string())) };
    let failed = |error: io::Error| not_kept(file, &error.to_string());
    let (folders, name) = folder::parts(Path::new(file)).map_err(failed)?;
    let mut folder = Folder::open(home).map_err(failed)?;
    for part in &folders {
        folder = folder.make(part).map_err(failed)?;
    }
    let name = OsStr::new(name);
    if folder.holds(name).map_err(failed)? {
        let opened = folder.read(name).map_err(failed)?;
        let mode = rustix::fs::fstat(&opened).map_err(|error| failed(error.into()))?.st_mode & 0o777;
        if mode & 0o077 != 0 {
            return Err(not_kept(file, &format!("others may read it (mode {mode:04o})")).help(format!("`chmod 600 {file}`, or remove it")));
        }
        let mut text = String::new();
        opened.take(TOKENS_BYTES_MAX).read_to_string(&mut text).map_err(failed)?;
        return read_tokens(&text).ok_or_else(|| {
            not_kept(file, "it has no tokens").help(format!(
                "it has two lines, `program …` and `view …`, each with {TOKEN_CHARACTERS_MIN} letters and digits or more; remove it, and new ones are made"
            ))
        });
    }
    let tokens = new_tokens().map_err(failed)?;
    let mut new = folder.new_private(name).map_err(failed)?;
    let text = format!("program {}\nview {}\n", tokens.program, tokens.view);
    new.write_all(text.as_bytes()).and_then(|()| new.sync_all()).map_err(failed)?;
    Ok(tokens)
}

/// Two lines: `program TOKEN` and `view TOKEN`.
fn read_tokens(text: &str) -> Option<Tokens> {
    let is_token = |token: &&str| token.len() >= TOKEN_CHARACTERS_MIN && token.bytes().all(|byte| byte.is_ascii_alphanumeric());
    let token =
        |word: &str| text.lines().find_map(|line| line.trim().strip_prefix(word)?.strip_prefix(' ')).map(str::trim).filter(is_token);
    Some(Tokens { program: token("program")?.to_owned(), view: token("view")?.to_owned() })
}

/// Two tokens of 128 bits.
fn new_tokens() -> io::Result<Tokens> {
    let token = || -> io::Result<String> {
        let mut bytes = [0_u8; 16];
        let count = getrandom(&mut bytes, GetRandomFlags::empty())?;
        if count < bytes.len() {
            return Err(io::Error::other("the system gives no random numbers"));
        }
        Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
    };
    Ok(Tokens { program: token()?, view: token()? })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tokens_are_read_as_they_are_written_and_short_ones_are_none() {
        let tokens = new_tokens().expect("random numbers");
        assert_ne!(tokens.program, tokens.view);
        let text = format!("program {}\nview {}\n", tokens.program, tokens.view);
        assert_eq!(read_tokens(&text), Some(tokens));
        for text in
            ["", "program 0123456789abcdef\n", "program secret\nview 0123456789abcdef", "program 0123456789 abcdef\nview 0123456789abcdef"]
        {
            assert_eq!(read_tokens(text), None, "{text}");
        }
    }
}
