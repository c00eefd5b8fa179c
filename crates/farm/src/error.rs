//! Why a farm cannot go on: one sentence each, with what to do.

use std::fmt;
use std::path::PathBuf;

use sieben_model::problems::Problem;

/// Why a run or a worker ended without having done its work.
///
/// No text in it holds a secret: servers are named by host and port.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FarmError {
    /// The address of the server is none.
    Address,
    /// The server did not answer at the start.
    Unreachable {
        /// Host and port.
        place: String,
        /// What the system said.
        why: String,
    },
    /// The server refused the user.
    Login {
        /// Host and port.
        place: String,
    },
    /// The certificate of the server is not trusted, or the server wants another one.
    Certificate {
        /// Host and port.
        place: String,
        /// What is wrong with it.
        why: String,
    },
    /// A file with credentials or certificates that cannot be used.
    File {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        why: String,
    },
    /// The server has no JetStream, or none for this user.
    NoJetStream {
        /// Host and port.
        place: String,
    },
    /// The user lacks a right.
    Rights {
        /// What was refused, in the words of the server: `publish to "sieben.1f.job"`.
        what: String,
    },
    /// The server was away for too long.
    Gone {
        /// Host and port.
        place: String,
        /// For how long.
        seconds: u64,
        /// What was heard last.
        why: String,
    },
    /// The server answers, and does not do what is asked.
    Refused {
        /// What was asked.
        what: &'static str,
        /// What the server said.
        why: String,
    },
    /// Something is larger than what can be sent.
    TooLarge {
        /// What it is.
        what: &'static str,
        /// Its bytes.
        bytes: u64,
        /// The most that there may be.
        max: u64,
    },
    /// Another run of the same campaign is at work.
    Busy,
    /// The name of a campaign is none.
    Campaign(String),
    /// The campaign was announced by another version of Sieben.
    Meaning {
        /// What the campaign needs.
        theirs: u32,
        /// What this worker has.
        ours: u32,
    },
    /// What the campaign brings along cannot be used.
    Bundle(String),
    /// The system gives no more threads, or no timers.
    System(String),
}

impl FarmError {
    /// The problem that it is an instance of.
    pub fn problem(&self) -> Problem {
        match self {
            Self::Address | Self::Unreachable { .. } | Self::Certificate { .. } | Self::Gone { .. } | Self::System(_) => Problem::P7165,
            Self::Login { .. } | Self::File { .. } | Self::Rights { .. } => Problem::P7166,
            Self::NoJetStream { .. } | Self::Refused { .. } | Self::TooLarge { .. } | Self::Busy => Problem::P7167,
            Self::Campaign(_) | Self::Meaning { .. } | Self::Bundle(_) => Problem::P7168,
        }
    }
}

impl fmt::Display for FarmError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Address => write!(f, "the address of the NATS server is not understood: write it as `nats://HOST:4222`"),
            Self::Unreachable { place, why } => {
                write!(f, "the NATS server at {place} cannot be reached ({why}): look whether it runs, and whether the address is right")
            }
            Self::Login { place } => {
                write!(
                    f,
                    "the NATS server at {place} refuses the user: give name and password, a token or a file with credentials that it knows"
                )
            }
            Self::Certificate { place, why } => {
                write!(f, "no secure connection to the NATS server at {place} ({why}): name the file of its certificate authority")
            }
            Self::File { path, why } => write!(f, "{}: {why}", path.display()),
            Self::NoJetStream { place } => {
                write!(f, "the NATS server at {place} has no JetStream for this user: start it with `-js`, or allow it to the account")
            }
            Self::Rights { what } => {
                write!(f, "the NATS server refuses this user to {what}: allow what `docs/reference/campaign-queue.md` lists")
            }
            Self::Gone { place, seconds, why } => {
                write!(f, "the NATS server at {place} has been away for {seconds} s ({why}): start it again, then go on with `--resume`")
            }
            Self::Refused { what, why } => write!(f, "the NATS server does not {what}: {why}"),
            Self::TooLarge { what, bytes, max } => write!(f, "{what} has {bytes} bytes, more than the {max} that can be sent"),
            Self::Busy => write!(f, "another run of this campaign is at work on this server: wait for it, or end it"),
            Self::Campaign(name) => {
                write!(f, "`{name}` names no campaign: write its identity, the hexadecimal digits that `sieben campaign run` prints")
            }
            Self::Meaning { theirs, ours } => write!(
                f,
                "the campaign needs meaning version {theirs}, this worker has {ours}: use the same version of Sieben on all machines"
            ),
            Self::Bundle(why) => write!(f, "what the campaign brings along cannot be used: {why}"),
            Self::System(why) => write!(f, "the system gives no threads or timers for the connection: {why}"),
        }
    }
}

impl std::error::Error for FarmError {}
