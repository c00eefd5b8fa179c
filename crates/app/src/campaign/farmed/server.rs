//! Which queue server, and how to get in.

use std::path::PathBuf;

use clap::Args;
use sieben_farm::{FarmError, Server};
use sieben_model::problems::Problem;

use crate::failure::Failure;

/// The address in the environment: it may hold a user and a password, which a command line shows to everyone.
const ADDRESS: &str = "SIEBEN_NATS";

/// What a command line says of the server.
#[derive(Args, Clone, Debug)]
pub(crate) struct ServerArguments {
    /// Take scenarios through the NATS server at this address [default: that of SIEBEN_NATS]
    #[arg(long, value_name = "URL", num_args = 0..=1, default_missing_value = "")]
    nats: Option<String>,
    /// A file with the credentials for the server
    #[arg(long, value_name = "FILE")]
    creds: Option<PathBuf>,
    /// A file with the certificate of the authority that the server belongs to
    #[arg(long, value_name = "FILE")]
    ca: Option<PathBuf>,
}

impl ServerArguments {
    /// Whether one is asked for.
    pub(crate) fn is_asked_for(&self) -> bool {
        self.nats.is_some()
    }

    /// The server.
    ///
    /// # Errors
    /// Neither the command line nor the environment has an address.
    pub(crate) fn server(&self) -> Result<Server, Failure> {
        let said = self.nats.clone().filter(|url| !url.is_empty());
        let url = said.or_else(|| std::env::var(ADDRESS).ok().filter(|url| !url.is_empty())).ok_or_else(|| {
            let told = Failure::usage(Problem::P7165, "there is no address of a NATS server");
            told.help(format!("write `--nats nats://HOST:4222`, or put the address into {ADDRESS}"))
        })?;
        Ok(Server { url, credentials: self.creds.clone(), authority: self.ca.clone() })
    }
}

/// What is said where the server or what comes of it fails.
pub(crate) fn failed(error: &FarmError) -> Failure {
    Failure::usage(error.problem(), error.to_string())
}
