//! Who may do what: tokens and roles, and which addresses and origins a request may come with.

use std::net::SocketAddr;

/// What a page may do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Role {
    /// It looks.
    View,
    /// It looks, writes, forces and starts and stops the CPU.
    Program,
}

impl Role {
    /// The word of the protocol.
    pub fn word(self) -> &'static str {
        match self {
            Self::View => "view",
            Self::Program => "program",
        }
    }
}

/// The tokens of a server.
#[derive(Clone, PartialEq, Eq)]
pub struct Tokens {
    /// For all that a page can do.
    pub program: String,
    /// For looking.
    pub view: String,
}

impl std::fmt::Debug for Tokens {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Tokens(…)")
    }
}

/// Whether two texts are the same, in a time that does not say where they differ.
fn same(one: &str, other: &str) -> bool {
    let differs = one.bytes().zip(other.bytes()).fold(0, |differs, (one, other)| differs | (one ^ other));
    one.len() == other.len() && differs == 0
}

/// What a request says about who sends it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Credentials<'r> {
    /// `Host`.
    pub host: Option<&'r str>,
    /// `Origin`.
    pub origin: Option<&'r str>,
    /// The token, from `Authorization: Bearer` or `?token=`.
    pub token: Option<&'r str>,
}

/// Why a request is not answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Denied {
    /// It is meant for another server.
    Host,
    /// A page of another server sends it.
    Origin,
    /// It has no token, or a wrong one.
    Token,
    /// Its token is for looking.
    Role,
}

/// What a server asks of requests.
#[derive(Clone, Debug)]
pub struct Access {
    /// Where it listens.
    pub listen: SocketAddr,
    /// Whether others than this computer reach it.
    pub exposed: bool,
    /// The tokens, if it has some.
    pub tokens: Option<Tokens>,
}

impl Access {
    /// What a request may do.
    ///
    /// # Errors
    /// It comes from elsewhere, or without the token.
    pub fn role(&self, credentials: Credentials<'_>) -> Result<Role, Denied> {
        // A name that leads to this computer and belongs to another page would make that page one of ours.
        let host = credentials.host.filter(|host| self.is_ours(host)).ok_or(Denied::Host)?;
        if let Some(origin) = credentials.origin {
            let of_origin = origin.strip_prefix("http://").or_else(|| origin.strip_prefix("https://"));
            if of_origin.is_none_or(|origin| !origin.eq_ignore_ascii_case(host)) {
                return Err(Denied::Origin);
            }
        }
        let Some(tokens) = &self.tokens else { return Ok(Role::Program) };
        match credentials.token {
            Some(token) if same(token, &tokens.program) => Ok(Role::Program),
            Some(token) if same(token, &tokens.view) => Ok(Role::View),
            _ => Err(Denied::Token),
        }
    }

    /// Whether a `Host` names this server: its address, or `localhost` where only this computer reaches it; an exposed one has whatever
    /// address the network gives it, and is protected by its token.
    fn is_ours(&self, host: &str) -> bool {
        let port = self.listen.port();
        let (name, given) = match host.rsplit_once(':') {
            Some((name, digits)) if !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit()) => {
                (name, digits.parse::<u16>().ok())
            }
            _ => (host, Some(80)),
        };
        if given != Some(port) {
            return false;
        }
        let plain = name.trim_start_matches('[').trim_end_matches(']');
        let address = plain.parse::<std::net::IpAddr>().ok();
        match self.exposed {
            // No name can be rebound to an address that is written as one.
            true => address.is_some() || plain.eq_ignore_ascii_case("localhost"),
            false => plain.eq_ignore_ascii_case("localhost") || address.is_some_and(|address| address.to_canonical().is_loopback()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn access(exposed: bool, tokens: bool) -> Access {
        let tokens = tokens.then(|| Tokens { program: "secret".to_owned(), view: "looking".to_owned() });
        let listen = if exposed { "0.0.0.0:7300" } else { "127.0.0.1:7300" };
        Access { listen: listen.parse().expect("an address"), exposed, tokens }
    }

    #[test]
    fn only_pages_of_this_server_are_answered() {
        let asks = |host, origin| access(false, false).role(Credentials { host, origin, token: None });
        for (host, origin, wanted) in [
            (Some("127.0.0.1:7300"), None, Ok(Role::Program)),
            (Some("localhost:7300"), Some("http://localhost:7300"), Ok(Role::Program)),
            (Some("[::1]:7300"), None, Ok(Role::Program)),
            (Some("127.0.0.1:7300"), Some("http://127.0.0.1:7301"), Err(Denied::Origin)),
            (Some("127.0.0.1:7300"), Some("null"), Err(Denied::Origin)),
            (Some("localhost:7300"), Some("http://127.0.0.1:7300"), Err(Denied::Origin)),
            (Some("example.org:7300"), None, Err(Denied::Host)),
            (Some("127.0.0.1:7301"), None, Err(Denied::Host)),
            (Some("127.0.0.1"), None, Err(Denied::Host)),
            (Some("192.168.0.4:7300"), None, Err(Denied::Host)),
            (Some(""), None, Err(Denied::Host)),
            (None, None, Err(Denied::Host)),
        ] {
            assert_eq!(asks(host, origin), wanted, "{host:?} {origin:?}");
        }
    }

    #[test]
    fn an_exposed_server_wants_a_token_and_an_address() {
        let asks = |host, token| access(true, true).role(Credentials { host: Some(host), origin: None, token });
        for (host, token, wanted) in [
            ("192.168.0.4:7300", Some("secret"), Ok(Role::Program)),
            ("192.168.0.4:7300", Some("looking"), Ok(Role::View)),
            ("192.168.0.4:7300", Some("secre"), Err(Denied::Token)),
            ("192.168.0.4:7300", Some(""), Err(Denied::Token)),
            ("192.168.0.4:7300", None, Err(Denied::Token)),
            ("rebound.example.org:7300", Some("secret"), Err(Denied::Host)),
        ] {
            assert_eq!(asks(host, token), wanted, "{host} {token:?}");
        }
    }
}
