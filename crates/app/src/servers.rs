//! The servers of a run: what the command line and the project say of them, and how they begin and end.

use std::ffi::OsStr;
use std::io::{self, ErrorKind, Read, Seek, SeekFrom};
use std::net::{IpAddr, SocketAddr, TcpListener};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::SystemTime;

use clap::Args;
use listenfd::ListenFd;
use rustix::io::Errno;
use serde_json::{Value, json};
use sieben_comm::config::{Config, LISTEN};
use sieben_comm::metrics::Metrics;
use sieben_comm::recording::audit::{Audit, ControlLog};
use sieben_comm::recording::frames::Frames;
use sieben_comm::recording::{Recorders, Sink};
use sieben_comm::s7comm::answer::Linker;
use sieben_comm::s7comm::guard::Function;
use sieben_comm::s7comm::session::Shared;
use sieben_comm::s7comm::wire::cotp::Partner;
use sieben_comm::server::{self, ConnectionView, Server, Setup, View, Written};
use sieben_cpu::{Communication, ProtectionLevel};
use sieben_model::cpu_type::CpuType;
use sieben_model::problems::Problem;
use sieben_workspace::Gate;
use sieben_workspace::control::{Client, Clients, CurrentFacts, LastWrite};
use sieben_workspace::metrics::{self, Served};
use sieben_workspace::project::Project;
use sieben_workspace::settings::servers::address;

use crate::engines::EngineArgument;
use crate::failure::Failure;
use crate::folder::{self, Folder};
use crate::linking::Preparing;

mod page;

pub(crate) use page::{PreparedPage, Usually};

/// Ports after the usual one that the demo tries.
const PORTS_MAX: u16 = 20;
/// First port that needs no right of its own.
const FREE_PORTS: u16 = 1024;

/// Who may reach a run over the network.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct ServerArguments {
    /// Serve S7 clients, at this address [default: that of the project, else 127.0.0.1:1102]
    #[arg(long, value_name = "ADDRESS", num_args = 0..=1, default_missing_value = "")]
    s7: Option<String>,
    /// Serve the page, at this address [default: that of the project, else 127.0.0.1:7300 or the next free port]
    #[arg(long, value_name = "ADDRESS", num_args = 0..=1, default_missing_value = "")]
    page: Option<String>,
    /// Serve no page
    #[arg(long, conflicts_with_all = ["page", "open"])]
    no_page: bool,
    /// Open the page in the browser
    #[arg(long)]
    open: bool,
    /// Let others than this computer reach a server, at exactly this address: `s7=0.0.0.0:102`
    #[arg(long, value_name = "SERVER=ADDRESS", value_parser = exposed)]
    expose: Vec<Exposed>,
    /// Tell Prometheus the numbers of the run, at http://ADDRESS/metrics
    #[arg(long, value_name = "ADDRESS", value_parser = metrics_address)]
    metrics: Option<SocketAddr>,
}

/// A server of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    S7,
    Metrics,
    Page,
}

impl Kind {
    /// Its word on the command line.
    fn word(self) -> &'static str {
        match self {
            Self::S7 => "s7",
            Self::Metrics => "metrics",
            Self::Page => "page",
        }
    }

    /// Where it listens for this computer alone, and where it does not disturb others.
    fn usual(self) -> SocketAddr {
        match self {
            Self::S7 => LISTEN,
            Self::Metrics => SocketAddr::from(([127, 0, 0, 1], 9100)),
            Self::Page => page::LISTEN,
        }
    }
}

/// A server that others may reach, at this address.
type Exposed = (Kind, SocketAddr);

fn exposed(text: &str) -> Result<Exposed, String> {
    let wanted = || format!("`{text}` is no server with its address; write `s7=0.0.0.0:1102`");
    let (name, place) = text.split_once('=').ok_or_else(wanted)?;
    let kind = [Kind::S7, Kind::Metrics, Kind::Page].into_iter().find(|kind| kind.word() == name);
    let kind =
        kind.ok_or_else(|| format!("there is no server `{name}`; write `s7=0.0.0.0:1102`, `page=0.0.0.0:7300` or `metrics=0.0.0.0:9100`"))?;
    address(place).map(|address| (kind, address)).ok_or_else(wanted)
}

fn metrics_address(text: &str) -> Result<SocketAddr, String> {
    address(text).ok_or_else(|| format!("`{text}` is no address with a port; write `127.0.0.1:9100`"))
}

impl ServerArguments {
    /// Takes a path back that followed `--s7` or `--page`, where an address may stand.
    pub(crate) fn give_back(&mut self, paths: &mut Vec<PathBuf>) -> Result<(), Failure> {
        for (kind, option) in [(Kind::S7, &mut self.s7), (Kind::Page, &mut self.page)] {
            let Some(word) = option.as_ref().filter(|word| !word.is_empty() && address(word).is_none()) else { continue };
            if !Path::new(word).exists() {
                let (message, option) = (format!("`{word}` is neither an address nor a file or folder"), kind.word());
                let help = format!("write `--{option} {}`, or `--{option}` alone", kind.usual());
                return Err(Failure::usage(Problem::P7001, message).help(help));
            }
            paths.insert(0, PathBuf::from(word));
            *option = Some(String::new());
        }
        Ok(())
    }

    /// What the S7 server does, if there is to be one.
    pub(crate) fn config(&self, project: &Project, always: Always) -> Result<Option<Config>, Failure> {
        let file = project.settings.servers.s7.as_ref();
        let named = self.s7.as_deref().and_then(address);
        if self.s7.is_none() && self.exposed(Kind::S7).is_none() && always == Always::No {
            return Ok(None);
        }
        let mut config = Config::of(file.unwrap_or(&Default::default()));
        let of_file = file.and_then(|file| file.listen).map(|(address, _)| address);
        config.listen = named.or(of_file).or(self.exposed(Kind::S7)).unwrap_or(LISTEN);
        Ok(Some(config))
    }

    /// The address of the S7 server of a run without a project; `None` if none was asked for.
    fn alone(&self) -> Result<Option<SocketAddr>, Failure> {
        match self.s7.as_deref() {
            Some(word) if !word.is_empty() => address(word).map(Some).ok_or_else(|| {
                Failure::usage(Problem::P7001, format!("`{word}` is no address with a port"))
                    .help("write `--s7 127.0.0.1:1102`, or `--s7` alone")
            }),
            None => Ok(self.exposed(Kind::S7)),
            Some(_) => Ok(Some(self.exposed(Kind::S7).unwrap_or(LISTEN))),
        }
    }

    /// The address at which others may reach a server.
    fn exposed(&self, wanted: Kind) -> Option<SocketAddr> {
        self.expose.iter().rev().find(|(kind, _)| *kind == wanted).map(|&(_, address)| address)
    }

    /// Begins to tell the numbers of a run, if that is wanted; where it listens is said.
    pub(crate) fn start_metrics(&self, gate: &Arc<Gate>, servers: Option<&Servers>) -> Result<Option<Metrics>, Failure> {
        let Some(wanted) = self.metrics.or(self.exposed(Kind::Metrics)) else { return Ok(None) };
        self.check(Kind::Metrics, wanted)?;
        // A run that is over already has nothing to measure.
        let _ = gate.enter(|plant| plant.cpu.measure_blocks());
        let (gate, viewer) = (Arc::clone(gate), servers.map(|servers| servers.s7.viewer()));
        let text = move || {
            let served: Vec<Served> = viewer.iter().map(|viewer| served(viewer.view())).collect();
            metrics::text(&gate, &served).ok()
        };
        let failed = |error: io::Error| not_listening(Kind::Metrics, wanted, &error);
        server::listen(wanted).and_then(|listener| Metrics::start(listener, Box::new(text))).map(Some).map_err(failed)
    }

    /// Only this computer reaches a server that was not exposed.
    fn check(&self, kind: Kind, listen: SocketAddr) -> Result<(), Failure> {
        let is_ours = |address: IpAddr| address.to_canonical().is_loopback();
        let exposed = self.exposed(kind);
        if is_ours(listen.ip()) && exposed.is_none() || self.expose.contains(&(kind, listen)) {
            return Ok(());
        }
        let word = kind.word();
        if let (true, Some(other)) = (is_ours(listen.ip()), exposed) {
            let message =
                format!("the server `{word}` would listen at {listen}, for this computer alone, but what `--expose` names is {other}");
            return Err(Failure::usage(Problem::P7100, message)
                .help(format!("for others too, `--{word} {other}`; for this computer alone, leave `--expose` out")));
        }
        let message = match (exposed, kind) {
            (Some(other), _) => format!("the server `{word}` would listen at {listen}, but what `--expose` names is {other}"),
            (None, Kind::Metrics) => {
                format!("{listen} can be reached by other computers, and every client reads the numbers of this run")
            }
            (None, Kind::Page) => {
                format!(
                    "{listen} can be reached by other computers, and HTTP has no encryption: who sees its token writes and stops this CPU"
                )
            }
            (None, Kind::S7) => format!(
                "{listen} can be reached by other computers, and S7 has no encryption: every client reads, writes and stops this CPU"
            ),
        };
        Err(Failure::usage(Problem::P7100, message).help(format!(
            "if the network is yours and you want that, add `--expose {word}={listen}`; for this computer alone, `--{word} 127.0.0.1:{}`",
            listen.port()
        )))
    }
}

/// Whether there is a server although none was asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Always {
    /// A run, which has servers only if it is told so.
    No,
    /// `sieben serve`.
    Yes,
}

/// The servers of a run.
pub(crate) struct Servers {
    s7: Server,
    /// Where what is done at the control socket is noted.
    control_log: Option<ControlLog>,
    protection: ProtectionLevel,
    has_password: bool,
    is_exposed: bool,
}

/// A server that is about to begin: it listens already, so that what is wrong with its address is said before the run begins.
pub(crate) struct Prepared {
    listener: TcpListener,
    config: Config,
    recorders: Recorders,
    names: Communication,
}

impl Prepared {
    /// Listens, and opens the files that are written.
    pub(crate) fn new(arguments: &ServerArguments, mut config: Config, project: &Project) -> Result<Self, Failure> {
        let listener = match handed_over()? {
            Some((listener, address)) => {
                config.listen = address;
                listener
            }
            None => {
                arguments.check(Kind::S7, config.listen)?;
                server::listen(config.listen).map_err(|error| not_listening(Kind::S7, config.listen, &error))?
            }
        };
        let home = project.home.as_deref().unwrap_or(Path::new(""));
        let opened = |file: &str, content: Content| open(home, file, content).map_err(|error| not_written(file, &error));
        let no_thread = |error: io::Error| Failure::usage(Problem::P7103, format!("no thread can be started: {error}"));
        let audit = match &config.audit {
            Some(log) => Some(Audit::start(opened(&log.file, Content::Kept)?, log.writes, log.required).map_err(no_thread)?),
            None => None,
        };
        let frames = match &config.pcap {
            Some(file) => Some(Frames::start(opened(file, Content::Replaced)?).map_err(no_thread)?),
            None => None,
        };
        Ok(Self { listener, config, recorders: Recorders { audit, frames }, names: names(project) })
    }

    /// Listens for the demo, at the next free port if none was named and the usual one is taken.
    pub(crate) fn of_demo(arguments: &ServerArguments) -> Result<Option<Self>, Failure> {
        let Some(wanted) = arguments.alone()? else { return Ok(None) };
        arguments.check(Kind::S7, wanted)?;
        let is_usual = wanted == LISTEN;
        let ports = wanted.port()..=wanted.port().saturating_add(if is_usual { PORTS_MAX } else { 0 });
        let mut listening = Err(io::Error::from(ErrorKind::AddrInUse));
        for port in ports {
            listening = server::listen(SocketAddr::new(wanted.ip(), port));
            if !matches!(&listening, Err(error) if error.kind() == ErrorKind::AddrInUse) {
                break;
            }
        }
        let listener = listening.map_err(|error| not_listening(Kind::S7, wanted, &error))?;
        let config = Config { listen: wanted, ..Config::default() };
        let names = Communication { system_name: "Dosing".to_owned(), plant_name: "Sieben demo".to_owned(), ..Communication::default() };
        Ok(Some(Self { listener, config, recorders: Recorders::default(), names }))
    }

    /// Begins to serve.
    pub(crate) fn start(self, cpu: &'static CpuType, gate: &Arc<Gate>, engine: EngineArgument) -> Result<Servers, Failure> {
        let Self { listener, config, recorders, names } = self;
        let (protection, has_password, listen) = (config.protection, config.password.is_some(), config.listen);
        let control_log = recorders.audit.as_ref().map(Audit::of_control);
        let mut shared = Shared::default();
        // Without the thread data blocks get other values and nothing else.
        shared.around.linker = Preparing::start(engine).ok().map(|preparing| Arc::new(preparing) as Arc<dyn Linker>);
        let setup = Setup { config, shared, names, recorders, clock: Box::new(wall_us) };
        let s7 = Server::start(listener, cpu, Arc::clone(gate), setup).map_err(|error| not_listening(Kind::S7, listen, &error))?;
        let is_exposed = !s7.address().ip().to_canonical().is_loopback();
        Ok(Servers { s7, control_log, protection, has_password, is_exposed })
    }
}

/// What a server has counted.
fn served(view: View) -> Served {
    let View { connections, counters } = view;
    Served {
        protocol: "s7",
        connected: connections.len() as u64,
        connections: counters.connections,
        refused: counters.refused,
        requests: Function::all().map(|function| (function.name(), counters.requests.of(function))).collect(),
        bytes_in: counters.bytes_in,
        bytes_out: counters.bytes_out,
        lost: counters.audit_lost + counters.frames_lost,
    }
}

/// What the CPU is called for those who ask: as the project is.
fn names(project: &Project) -> Communication {
    let name = project.settings.name.clone().unwrap_or_else(|| "Sieben".to_owned());
    Communication { system_name: name.clone(), plant_name: name, ..Communication::default() }
}

impl Servers {
    /// Where they listen, for programs.
    pub(crate) fn json(&self) -> Value {
        json!({ "s7": self.s7.address().to_string() })
    }

    /// Where they listen, in one line, and what that means.
    pub(crate) fn text(&self) -> String {
        let level = match (self.protection, self.has_password) {
            (ProtectionLevel::Open, false) => "without protection",
            (ProtectionLevel::Open, true) => "without protection (`password` protects from `protection = 2` on)",
            (ProtectionLevel::WriteProtected, true) => "write protection, with a password",
            (ProtectionLevel::WriteProtected, false) => "write protection, without a password that lifts it",
            (ProtectionLevel::ReadWriteProtected, true) => "read and write protection, with a password",
            (ProtectionLevel::ReadWriteProtected, false) => "read and write protection, without a password that lifts it",
        };
        let exposed = match self.is_exposed {
            true => " Other computers reach it: the protocol has no encryption, and its variables no password.",
            false => "",
        };
        format!("S7 clients are served at {}, {level}.{exposed}\n", self.s7.address())
    }

    /// Those who look at the run see the clients of these servers, and what they change is in the same log.
    pub(crate) fn introduce(&self, facts: &CurrentFacts, gate: &Arc<Gate>) {
        facts.set_clients(self.clients(gate));
        if let Some(log) = self.control_log.clone() {
            facts.add_listener(Box::new(move |peer, changes| log.note(peer, changes, wall_us())));
        }
    }

    fn clients(&self, gate: &Arc<Gate>) -> Clients {
        let (viewer, gate) = (self.s7.viewer(), Arc::clone(gate));
        Box::new(move || {
            let now_us = gate.now_us();
            let client = |one: ConnectionView| Client {
                protocol: "S7",
                peer: one.peer.to_string(),
                partner: one.partner.map(|partner| match partner {
                    Partner::ProgrammingDevice => "PG",
                    Partner::OperatorPanel => "OP",
                    Partner::Other => "other",
                }),
                for_us: now_us.saturating_sub(one.since_us),
                last: one.last.map(Function::name),
                pdu_bytes: one.pdu_bytes,
                reads: one.reads,
                writes: one.writes,
                written: one.written.map(last_write),
            };
            viewer.view().connections.into_iter().map(client).collect()
        })
    }

    /// Closes all connections in order; what was lost of the records, in a sentence.
    pub(crate) fn end(&mut self) -> Option<String> {
        let View { counters, .. } = self.s7.end();
        let lost = [(counters.audit_lost, "records of the audit log"), (counters.frames_lost, "recorded frames")];
        let lost: Vec<String> = lost.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}")).collect();
        (!lost.is_empty()).then(|| format!("Lost, because the disk was full or too slow: {}.\n", lost.join(", ")))
    }
}

/// What a client wrote last, for people.
fn last_write(Written { address, bytes, scan, time_us }: Written) -> LastWrite {
    let digits: String = bytes.iter().map(|byte| format!("{byte:02X}")).collect();
    LastWrite { name: address, value: format!("16#{digits}"), scan, time_us }
}

/// A socket that was made for this process, as systemd does; its address was chosen there, and so was who reaches it.
fn handed_over() -> Result<Option<(TcpListener, SocketAddr)>, Failure> {
    let wrong =
        |error: io::Error| Failure::usage(Problem::P7102, format!("the socket that was handed over (LISTEN_FDS) cannot be used: {error}"));
    let mut handed = ListenFd::from_env();
    if handed.len() == 0 {
        return Ok(None);
    }
    let listener = handed.take_tcp_listener(0).map_err(wrong)?;
    listener.map(|listener| listener.local_addr().map(|address| (listener, address)).map_err(wrong)).transpose()
}

/// Microseconds since 1970.
fn wall_us() -> u64 {
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    u64::try_from(since.as_micros()).unwrap_or(u64::MAX)
}

/// What becomes of what a file has already.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Content {
    /// The new comes after it.
    Kept,
    /// It goes.
    Replaced,
}

impl Content {
    /// What files of it begin with.
    fn begin(self) -> &'static [u8] {
        match self {
            Self::Kept => b"{\"",
            Self::Replaced => b"\x0A\x0D\x0D\x0A",
        }
    }

    fn is_other(self) -> &'static str {
        match self {
            Self::Kept => "it is there already and is no audit log; move it away, or name another file",
            Self::Replaced => "it is there already and has no recorded frames (pcapng); move it away, or name another file",
        }
    }
}

/// Opens a file in the folder of the project; no link in it leads elsewhere.
fn open(home: &Path, file: &str, content: Content) -> io::Result<Sink> {
    let (folders, name) = folder::parts(Path::new(file))?;
    let mut folder = Folder::open(home)?;
    for part in &folders {
        folder = folder.make(part)?;
    }
    let name = OsStr::new(name);
    // A name that was meant otherwise must not cost a source.
    if folder.holds(name)? {
        let mut begin = Vec::new();
        io::Read::take(folder.read(name)?, 4).read_to_end(&mut begin)?;
        if !begin.is_empty() && !begin.starts_with(content.begin()) {
            return Err(io::Error::other(content.is_other()));
        }
    }
    let mut file = folder.write(name)?;
    match content {
        Content::Kept => drop(file.seek(SeekFrom::End(0))?),
        Content::Replaced => file.set_len(0)?,
    }
    Ok(Box::new(file))
}

fn not_written(file: &str, error: &io::Error) -> Failure {
    Failure::usage(Problem::P7103, format!("the server cannot write `{file}`: {error}"))
}

fn not_listening(kind: Kind, address: SocketAddr, error: &io::Error) -> Failure {
    let (port, usual, word) = (address.port(), kind.usual().port(), kind.word());
    let other = SocketAddr::new(address.ip(), if port == usual { port.saturating_add(1) } else { usual });
    match error.kind() {
        ErrorKind::AddrInUse => Failure::usage(Problem::P7101, format!("another program listens at {address} already"))
            .help(format!("end it, perhaps another `sieben`, or choose another port: `--{word} {other}`")),
        ErrorKind::PermissionDenied if port < FREE_PORTS => {
            Failure::usage(Problem::P7102, format!("this user may not listen at port {port}, which is below {FREE_PORTS}")).help(format!(
                "allow it with `sudo setcap cap_net_bind_service=+ep {}`, or in a unit of systemd with `AmbientCapabilities=CAP_NET_BIND_SERVICE`; without, choose another port: `--{word} {other}`",
                std::env::current_exe().map_or_else(|_| "sieben".to_owned(), |path| crate::paths::shown(&path))
            ))
        }
        ErrorKind::AddrNotAvailable => Failure::usage(Problem::P7102, format!("{} is no address of this computer", address.ip()))
            .help("`127.0.0.1` is this computer alone, `0.0.0.0` all of its addresses"),
        _ if Errno::from_io_error(error) == Some(Errno::AFNOSUPPORT) => {
            Failure::usage(Problem::P7102, format!("this computer has no such addresses: {address}"))
        }
        _ => Failure::usage(Problem::P7102, format!("{address} cannot be listened at: {error}")),
    }
}
