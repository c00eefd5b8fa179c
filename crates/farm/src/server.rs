//! Where the server is and how to get in.

use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

use async_nats::ServerAddr;

use crate::error::FarmError;

/// Where the server is and how to get in.
///
/// The address may hold a user with a password or a token: `nats://user:password@host:4222`, `tls://token@host`. Several addresses of one
/// cluster are separated by commas; who logs in is taken from the first that says it. Shown for debugging, it keeps these secrets.
#[derive(Clone, PartialEq, Eq)]
pub struct Server {
    /// The address.
    pub url: String,
    /// A file with credentials: what `nsc` writes, or a seed.
    pub credentials: Option<PathBuf>,
    /// The certificates of the authority that signed the certificate of the server, as PEM.
    pub authority: Option<PathBuf>,
}

impl fmt::Debug for Server {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Server")
            .field("url", &self.place())
            .field("credentials", &self.credentials)
            .field("authority", &self.authority)
            .finish()
    }
}

/// Who logs in by the address.
#[derive(Clone, PartialEq, Eq)]
pub(crate) enum Login {
    None,
    Token(String),
    User(String, String),
}

impl Server {
    /// Host and port of the first address, without who logs in.
    pub fn place(&self) -> String {
        self.addresses().map_or_else(|_| "(not an address)".to_owned(), |addresses| place(&addresses[0]))
    }

    /// The addresses as they were written.
    fn addresses(&self) -> Result<Vec<ServerAddr>, FarmError> {
        let addresses: Result<Vec<_>, _> = self.url.split(',').map(|url| ServerAddr::from_str(url.trim())).collect();
        addresses.ok().filter(|addresses| addresses.iter().all(|address| !address.host().is_empty())).ok_or(FarmError::Address)
    }

    /// The addresses without who logs in, and who does.
    pub(crate) fn parts(&self) -> Result<(Vec<ServerAddr>, Login), FarmError> {
        let addresses = self.addresses()?;
        let login = addresses
            .iter()
            .find_map(|address| match (address.username(), address.password()) {
                (Some(user), Some(password)) => Some(Login::User(decoded(user), decoded(password))),
                (Some(token), None) => Some(Login::Token(decoded(token))),
                _ => None,
            })
            .unwrap_or(Login::None);
        let plain: Result<Vec<_>, _> =
            addresses.iter().map(|address| ServerAddr::from_str(&format!("{}://{}", address.scheme(), place(address)))).collect();
        Ok((plain.map_err(|_| FarmError::Address)?, login))
    }
}

fn place(address: &ServerAddr) -> String {
    match address.host() {
        host if host.contains(':') && !host.starts_with('[') => format!("[{host}]:{}", address.port()),
        host => format!("{host}:{}", address.port()),
    }
}

/// A part of an address with its `%41` as characters; what is none stays as it is.
fn decoded(part: &str) -> String {
    let bytes = part.as_bytes();
    let mut out = Vec::with_capacity(bytes.len());
    let mut index = 0;
    while index < bytes.len() {
        let coded = (bytes[index] == b'%').then(|| part.get(index + 1..index + 3)).flatten();
        match coded.and_then(|digits| u8::from_str_radix(digits, 16).ok()) {
            Some(byte) => {
                out.push(byte);
                index += 3;
            }
            None => {
                out.push(bytes[index]);
                index += 1;
            }
        }
    }
    String::from_utf8_lossy(&out).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn server(url: &str) -> Server {
        Server { url: url.to_owned(), credentials: None, authority: None }
    }

    #[test]
    fn a_password_is_never_shown() {
        let shown = format!("{:?} {}", server("nats://anna:ge%20heim@queue:4333"), server("nats://geheim@queue").place());
        assert!(!shown.contains("geheim") && !shown.contains("heim") && !shown.contains("anna"), "{shown}");
        assert!(shown.contains("queue:4333") && shown.contains("queue:4222"), "{shown}");
    }

    #[test]
    fn who_logs_in_is_taken_out_of_the_address() {
        let (addresses, login) = server("nats://anna:ge%20heim@queue:4333, nats://other:4333").parts().expect("addresses");
        assert!(login == Login::User("anna".to_owned(), "ge heim".to_owned()));
        assert_eq!(addresses.iter().map(ServerAddr::as_url_str).collect::<Vec<_>>(), ["nats://queue:4333", "nats://other:4333"]);
        assert!(server("tls://a-token@queue").parts().expect("an address").1 == Login::Token("a-token".to_owned()));
        assert!(server("queue").parts().expect("an address").1 == Login::None);
    }

    #[test]
    fn what_is_no_address_is_said_to_be_none() {
        for url in ["", "nats://", ",", "http://[", "nats://a,,nats://b"] {
            assert_eq!(server(url).parts().err(), Some(FarmError::Address), "{url}");
        }
    }
}
