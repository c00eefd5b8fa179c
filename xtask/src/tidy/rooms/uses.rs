//! What a Rust source names of its own crate, read from its text.

/// A path that a source names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Use {
    /// The path from the root of the crate, without `crate`.
    pub path: Vec<String>,
    /// What it is called here, if that is another name.
    pub alias: Option<String>,
    /// The line, counted from 1.
    pub line: usize,
}

/// What a source names, and which of its modules are there for tests only.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Uses {
    /// The paths, without those in test code.
    pub named: Vec<Use>,
    /// Modules in files of their own that only tests have, as paths from the root of the crate.
    pub tests: Vec<Vec<String>>,
}

/// Reads the source of the module with this path; the root of the crate has the empty one.
///
/// Code under `#[cfg(test)]` is left out: a test may use whatever it likes.
pub(super) fn read(text: &str, module: &[String]) -> Uses {
    let tokens = tokens(text);
    let children = children(&tokens);
    let mut reader =
        Reader { tokens: &tokens, at: 0, module: module.to_vec(), inner: Vec::new(), depth: 0, children, uses: Uses::default() };
    reader.run();
    reader.uses
}

/// A word or a sign, with its line.
#[derive(Clone, Copy, Debug)]
struct Token<'a> {
    text: &'a str,
    line: usize,
}

/// The text in tokens: words, `::`, and all other signs one by one, without comments and literals.
fn tokens(text: &str) -> Vec<Token<'_>> {
    let bytes = text.as_bytes();
    let is_word = |at: usize| bytes.get(at).is_some_and(|&byte| byte == b'_' || byte.is_ascii_alphanumeric() || !byte.is_ascii());
    let (mut tokens, mut at, mut line) = (Vec::new(), 0, 1);
    while at < bytes.len() {
        let start = at;
        at = match bytes[at] {
            b'/' if bytes.get(at + 1) == Some(&b'/') => text[at..].find('\n').map_or(bytes.len(), |length| at + length),
            b'/' if bytes.get(at + 1) == Some(&b'*') => behind_comment(bytes, at),
            b'"' => behind_string(bytes, at),
            b'\'' => behind_quote(text, at),
            _ if is_word(at) => {
                let mut end = at;
                while is_word(end) {
                    end += 1;
                }
                match behind_raw_string(text, at, end) {
                    Some(behind) => behind,
                    None => {
                        tokens.push(Token { text: &text[at..end], line });
                        end
                    }
                }
            }
            byte if byte.is_ascii_whitespace() => at + 1,
            _ => {
                let length = if text[at..].starts_with("::") { 2 } else { 1 };
                tokens.push(Token { text: &text[at..at + length], line });
                at + length
            }
        };
        line += bytes[start..at].iter().filter(|&&byte| byte == b'\n').count();
    }
    tokens
}

/// Behind a comment between `/*` and `*/`, which may hold others.
fn behind_comment(bytes: &[u8], start: usize) -> usize {
    let (mut at, mut depth) = (start, 0);
    while at < bytes.len() {
        match bytes.get(at..at + 2) {
            Some(b"/*") => (at, depth) = (at + 2, depth + 1),
            Some(b"*/") => (at, depth) = (at + 2, depth - 1),
            _ => at += 1,
        }
        if depth == 0 {
            break;
        }
    }
    at
}

/// Behind a string literal that begins here.
fn behind_string(bytes: &[u8], start: usize) -> usize {
    let mut at = start + 1;
    while at < bytes.len() && bytes[at] != b'"' {
        at += if bytes[at] == b'\\' { 2 } else { 1 };
    }
    (at + 1).min(bytes.len())
}

/// Behind a character literal, or behind the quote of a lifetime.
fn behind_quote(text: &str, start: usize) -> usize {
    let mut rest = text[start + 1..].char_indices();
    match (rest.next(), rest.next()) {
        (Some((_, '\\')), Some((next, escaped))) => {
            let behind = start + 1 + next + escaped.len_utf8();
            text[behind..].find('\'').map_or(text.len(), |length| behind + length + 1)
        }
        (Some(_), Some((next, '\''))) => start + 1 + next + 1,
        _ => start + 1,
    }
}

/// Behind a raw string whose prefix is the word from `start` to `end`; `None` if it is a word like others.
fn behind_raw_string(text: &str, start: usize, end: usize) -> Option<usize> {
    if !matches!(&text[start..end], "r" | "br" | "cr") {
        return None;
    }
    let hashes = text[end..].bytes().take_while(|&byte| byte == b'#').count();
    let opened = text[end + hashes..].starts_with('"');
    let close = format!("\"{}", "#".repeat(hashes));
    let from = end + hashes + 1;
    opened.then(|| text[from..].find(&close).map_or(text.len(), |length| from + length + close.len()))
}

/// The modules that the source declares at its top, in files of their own or not.
fn children(tokens: &[Token<'_>]) -> Vec<String> {
    let mut depth = 0_usize;
    let mut children = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        match token.text {
            "{" => depth += 1,
            "}" => depth = depth.saturating_sub(1),
            "mod" if depth == 0 => children.extend(tokens.get(at + 1).map(|name| name.text.to_owned())),
            _ => {}
        }
    }
    children
}

struct Reader<'a> {
    tokens: &'a [Token<'a>],
    at: usize,
    /// The module of the file.
    module: Vec<String>,
    /// Modules inside the file around this token: the depth of their braces, and their names.
    inner: Vec<(usize, String)>,
    depth: usize,
    children: Vec<String>,
    uses: Uses,
}

impl<'a> Reader<'a> {
    fn text(&self, ahead: usize) -> &'a str {
        self.tokens.get(self.at + ahead).map_or("", |token| token.text)
    }

    /// Whether the tokens from here on are these.
    fn sees(&self, words: &[&str]) -> bool {
        words.iter().enumerate().all(|(ahead, word)| self.text(ahead) == *word)
    }

    fn run(&mut self) {
        while self.at < self.tokens.len() {
            if self.sees(&["#", "[", "cfg", "(", "test", ")", "]"]) {
                self.skip_item();
                continue;
            }
            if self.sees(&["#", "!", "[", "cfg", "(", "test", ")", "]"]) {
                return;
            }
            if self.sees(&["pub", "(", "in"]) {
                // Who may see an item is no use of theirs.
                self.skip_to(")");
                continue;
            }
            let begins = self.at == 0 || !matches!(self.tokens[self.at - 1].text, "::" | ".");
            match self.text(0) {
                "{" => self.depth += 1,
                "}" => {
                    self.depth = self.depth.saturating_sub(1);
                    self.inner.retain(|(depth, _)| *depth < self.depth + 1);
                }
                "mod" if self.text(2) == "{" => {
                    let name = self.text(1).to_owned();
                    self.inner.push((self.depth + 1, name));
                }
                first if begins && self.text(1) == "::" => {
                    let base = match first {
                        "crate" => Some(Vec::new()),
                        "self" => Some(self.here()),
                        "super" => {
                            let mut base = self.here();
                            base.pop();
                            while self.text(2) == "super" && self.text(3) == "::" {
                                base.pop();
                                self.at += 2;
                            }
                            Some(base)
                        }
                        child if self.inner.is_empty() && self.children.iter().any(|known| known == child) => {
                            let mut base = self.module.clone();
                            base.push(child.to_owned());
                            Some(base)
                        }
                        _ => None,
                    };
                    if let Some(base) = base {
                        self.at += 2;
                        self.tree(base);
                        continue;
                    }
                }
                _ => {}
            }
            self.at += 1;
        }
    }

    /// The module around this token.
    fn here(&self) -> Vec<String> {
        self.module.iter().chain(self.inner.iter().map(|(_, name)| name)).cloned().collect()
    }

    /// Reads what stands behind `crate::` and the like: a path, or many in braces.
    fn tree(&mut self, mut path: Vec<String>) {
        let line = self.tokens.get(self.at).map_or(0, |token| token.line);
        if self.text(0) == "{" {
            self.at += 1;
            while self.at < self.tokens.len() && self.text(0) != "}" {
                let before = self.at;
                if self.text(0) != "," {
                    self.tree(path.clone());
                }
                // A comma, or what does not belong here.
                self.at += usize::from(self.at == before);
            }
            self.at += 1;
            return;
        }
        match self.text(0) {
            word if word.starts_with(|c: char| c == '_' || c.is_alphabetic()) => {
                if word != "self" {
                    path.push(word.to_owned());
                }
                self.at += 1;
                if self.text(0) == "::" {
                    self.at += 1;
                    return self.tree(path);
                }
            }
            "*" => self.at += 1,
            // `crate::room::name::<Type>`: the path is over.
            _ => {}
        }
        let alias = (self.text(0) == "as").then(|| self.text(1).to_owned());
        if alias.is_some() {
            self.at += 2;
        }
        self.uses.named.push(Use { path, alias, line });
    }

    fn skip_to(&mut self, word: &str) {
        while self.at < self.tokens.len() && self.text(0) != word {
            self.at += 1;
        }
        self.at += 1;
    }

    /// Passes over an item with its attributes, of which this is the first.
    fn skip_item(&mut self) {
        while self.text(0) == "#" {
            self.skip_to("]");
        }
        let whole = self.at;
        while matches!(self.text(0), "pub" | "(" | ")" | "crate" | "super" | "in" | "::") {
            self.at += 1;
        }
        if self.text(0) == "mod" && self.text(2) == ";" {
            let mut module = self.here();
            module.push(self.text(1).to_owned());
            self.uses.tests.push(module);
        }
        if self.text(0) == "use" {
            return self.skip_to(";");
        }
        self.at = whole;
        let mut depth = 0_usize;
        while self.at < self.tokens.len() {
            let text = self.text(0);
            self.at += 1;
            match text {
                "{" | "(" | "[" => depth += 1,
                "}" | ")" | "]" => depth = depth.saturating_sub(1),
                _ => {}
            }
            if depth == 0 && matches!(text, "}" | ";") {
                return;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a source of the module `a/b` names, one path with its line after the other.
    fn named(text: &str) -> Vec<String> {
        let uses = read(text, &["a".to_owned(), "b".to_owned()]);
        uses.named.iter().map(|one| format!("{} {}", one.path.join("/"), one.line)).collect()
    }

    #[test]
    fn every_form_of_a_path_is_read() {
        for (text, paths) in [
            ("use crate::io::Rack;", &["io/Rack 1"][..]),
            ("use crate::{\n    clock::{self, Date as D},\n    mode,\n};", &["clock 2", "clock/Date 2", "mode 3"]),
            ("fn f() { crate::io::g::<u8>(super::h(), super::super::mode::X) }", &["io/g 1", "a/h 1", "mode/X 1"]),
            ("mod c;\nuse c::D;\nfn f(c: C) { c.d(); self::c::e() }", &["a/b/c/D 2", "a/b/c/e 3"]),
            ("use super::*;\nmacro_rules! m { () => { $crate::io::f() } }", &["a 1", "io/f 2"]),
            ("mod inner {\n    use super::x;\n    use super::super::y;\n}\nuse super::z;", &["a/b/x 2", "a/y 3", "a/z 5"]),
        ] {
            assert_eq!(named(text), paths, "{text}");
        }
    }

    #[test]
    fn words_in_comments_and_literals_and_visibilities_are_no_uses() {
        for text in [
            "// crate::io::Rack\n/* crate::io /* crate::mode */ crate::io */\n//! [`crate::io`]",
            "const A: &str = \"crate::io\\\" crate::mode\";\nconst B: &str = r#\"crate::io\" crate::mode\"#;",
            "const A: [char; 2] = ['\"', '\\''];\nfn f<'a>(text: &'a str) {}",
            "pub(super) fn f() {}\npub(in crate::io) fn g() {}\npub(crate) fn h() {}",
        ] {
            assert!(named(text).is_empty(), "{text}: {:?}", named(text));
        }
    }

    #[test]
    fn code_for_tests_is_left_out() {
        let text = "#[cfg(test)]\nuse crate::x::{A, B};\n#[cfg(test)]\nmod tests {\n    use crate::y::{C};\n}\n#[cfg(test)]\npub(crate) mod plant;\n\
            #[cfg(test)]\nfn f(a: [u8; 2]) { crate::y::g() }\nuse crate::z;";
        assert_eq!(named(text), ["z 11"]);
        assert_eq!(read(text, &["a".to_owned()]).tests, [["a", "plant"]]);
        assert!(named("#![cfg(test)]\nuse crate::x;").is_empty());
    }
}
