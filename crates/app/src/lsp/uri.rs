//! URIs of clients and the paths that they mean.

use std::fs;
use std::path::{Component, Path, PathBuf};

/// What a URI names.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Place {
    /// A file, by a path that is the same for every spelling of it.
    File(PathBuf),
    /// A text that has no file: `untitled:Untitled-1`.
    Untitled(String),
    /// Anything else, such as the old side of a comparison.
    Other(String),
}

impl Place {
    /// What a client means by a URI.
    pub(super) fn of(uri: &str) -> Self {
        match path_of(uri) {
            Some(path) => Self::File(known(&path)),
            None if scheme(uri).eq_ignore_ascii_case("untitled") => Self::Untitled(uri.to_owned()),
            None => Self::Other(uri.to_owned()),
        }
    }

    /// Its path, if it is a file.
    pub(super) fn path(&self) -> Option<&Path> {
        match self {
            Self::File(path) => Some(path),
            Self::Untitled(_) | Self::Other(_) => None,
        }
    }
}

fn scheme(uri: &str) -> &str {
    uri.split_once(':').map_or("", |(scheme, _)| scheme)
}

/// The path of a `file:` URI, as the client spells it; `None` for every other URI, and for a file of another computer.
pub(super) fn path_of(uri: &str) -> Option<PathBuf> {
    if !scheme(uri).eq_ignore_ascii_case("file") {
        return None;
    }
    let rest = &uri["file:".len()..];
    let path = match rest.strip_prefix("//") {
        None => rest,
        Some(rest) => {
            let (host, path) = rest.split_at(rest.find('/')?);
            (host.is_empty() || host.eq_ignore_ascii_case("localhost")).then_some(path)?
        }
    };
    // What follows these signs is no part of the path: inside of it they are encoded.
    let path = decoded(path.split(['?', '#']).next().unwrap_or_default())?;
    if !path.starts_with('/') || path.contains('\0') {
        return None;
    }
    let mut path = path.into_bytes();
    // `file:///C:/x` and `file:///c%3A/x` are one file.
    if path.len() > 2 && path[1].is_ascii_alphabetic() && path[2] == b':' {
        path[1].make_ascii_lowercase();
    }
    String::from_utf8(path).ok().map(PathBuf::from)
}

/// A text with its `%C3%A4` decoded; `None` if that is no UTF-8.
fn decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, after @ ..] = rest {
        let pair = after.get(..2).and_then(|pair| std::str::from_utf8(pair).ok());
        let value = pair.filter(|pair| *first == b'%' && pair.bytes().all(|byte| byte.is_ascii_hexdigit()));
        match value.and_then(|pair| u8::from_str_radix(pair, 16).ok()) {
            Some(byte) => {
                bytes.push(byte);
                rest = &after[2..];
            }
            None => {
                bytes.push(*first);
                rest = after;
            }
        }
    }
    String::from_utf8(bytes).ok()
}

/// The URI of a path.
pub(super) fn of_path(path: &Path) -> String {
    let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
    let mut uri = String::from("file://");
    for byte in absolute.to_string_lossy().bytes() {
        match byte {
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => uri.push(byte as char),
            _ => uri.push_str(&format!("%{byte:02X}")),
        }
    }
    uri
}

/// A path that is the same for every spelling: links resolved as far as there are files.
pub(super) fn known(path: &Path) -> PathBuf {
    if let Ok(path) = fs::canonicalize(path) {
        return path;
    }
    let plain = lexical(path);
    match (plain.parent().and_then(|parent| fs::canonicalize(parent).ok()), plain.file_name()) {
        (Some(parent), Some(name)) => parent.join(name),
        _ => plain,
    }
}

/// A path without `.` and `..`.
fn lexical(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in std::path::absolute(path).as_deref().unwrap_or(path).components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir => {
                plain.pop();
            }
            other => plain.push(other),
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_spelling_of_a_uri_means_the_same_path() {
        let path = |uri: &str| path_of(uri).map(|path| path.display().to_string());
        for (uri, expected) in [
            ("file:///plant/main.awl", Some("/plant/main.awl")),
            ("FILE:///plant/main.awl", Some("/plant/main.awl")),
            ("file:/plant/main.awl", Some("/plant/main.awl")),
            ("file://localhost/plant/main.awl", Some("/plant/main.awl")),
            ("file:///plant/T%C3%BCr%20%2B%40.awl", Some("/plant/Tür +@.awl")),
            ("file:///plant/Tür.awl", Some("/plant/Tür.awl")),
            ("file:///c%3A/plant", Some("/c:/plant")),
            ("file:///C:/plant", Some("/c:/plant")),
            ("file:///100%", Some("/100%")),
            ("file:///a%2", Some("/a%2")),
            ("file:///a?b#c", Some("/a")),
            ("file://server/share/a.awl", None),
            ("file:///%FF", None),
            ("file:///a%00b", None),
            ("file://", None),
            ("file:", None),
            ("untitled:Untitled-1", None),
            ("git:/plant/main.awl?%7B%7D", None),
            ("", None),
        ] {
            assert_eq!(path(uri).as_deref(), expected, "{uri}");
        }
        assert_eq!(of_path(Path::new("/plant/Tür +.awl")), "file:///plant/T%C3%BCr%20%2B.awl");
        assert_eq!(path(&of_path(Path::new("/plant/100 % ä#?.awl"))).as_deref(), Some("/plant/100 % ä#?.awl"));
    }

    #[test]
    fn what_is_no_file_is_known_by_its_uri() {
        assert_eq!(Place::of("untitled:Untitled-1"), Place::Untitled("untitled:Untitled-1".to_owned()));
        assert_eq!(Place::of("git:/a.awl"), Place::Other("git:/a.awl".to_owned()));
        assert_eq!(Place::of("file:///no/such/../folder/./a.awl"), Place::File(PathBuf::from("/no/folder/a.awl")));
    }
}
