//! Cuts ST text into tokens.

use std::borrow::Cow;

use super::diagrams::text::BodyBegins;
use super::dialect::{Construct, Dialect, Judgement};
use super::keywords::Keyword;
pub(super) use crate::scan::in_word;
use crate::scan::{self, ends_in_escape, is_blank, pointer, straight_quote, while_in};

/// What a token looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Raw {
    End,
    /// Blanks, tabs and a byte order mark.
    Blank,
    /// CR LF, LF or CR.
    Newline,
    /// `// …`.
    LineComment,
    /// `(* … *)`, `/* … */`; unterminated to the end of the text.
    BlockComment,
    /// `{ … }`; unterminated to the end of the line.
    Pragma,
    /// What a conditional pragma has switched off.
    Inactive,
    /// Letters, digits and underscores, not beginning with a digit; also a keyword.
    Word,
    /// `5`, `1.5`, `1.0e+003`, `16#FF`.
    Number,
    /// `T#5s`, `INT#5`, `P#M0.0`, `STRING#'a'`.
    Literal,
    /// `Color#red`.
    EnumValue,
    /// `'text'`, unterminated to the end of the line.
    Characters,
    /// `"text"`: a name or a WSTRING by the dialect; unterminated to the end of the line.
    Quoted,
    /// `#local`, `#"local"`.
    Local,
    /// `` `name` ``.
    Backquoted,
    /// `%MW10`, `%I0.0:P`, `%X3`.
    Percent,
    Semicolon,
    Colon,
    /// `:=`.
    Becomes,
    /// `=>`.
    Delivers,
    Comma,
    Point,
    /// `..`.
    Range,
    ParenOpen,
    ParenClose,
    BracketOpen,
    BracketClose,
    Caret,
    Ampersand,
    Plus,
    Minus,
    Star,
    Slash,
    /// `**`.
    Power,
    Equal,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    NotEqual,
    /// `+=`, `-=`, `*=`, `/=`.
    Combined,
    /// `?=`.
    Attempt,
    /// `==`, `!=`.
    Foreign,
    /// LD or FBD as the first word of a body.
    DiagramWord,
    /// The networks of such a body.
    Diagram,
    /// A character that begins nothing.
    Unknown,
}

impl Raw {
    /// Whether the parser reads over it.
    pub(super) fn is_trivia(self) -> bool {
        use Raw::{Blank, BlockComment, Inactive, LineComment, Newline, Pragma};
        matches!(self, Blank | Newline | LineComment | BlockComment | Pragma | Inactive)
    }
}

/// A token with its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Token {
    pub(super) raw: Raw,
    pub(super) keyword: Option<Keyword>,
    pub(super) start: u32,
    pub(super) end: u32,
}

/// All tokens of a text; the last one is [`Raw::End`].
pub(super) fn tokens(text: &str, dialect: Dialect) -> Vec<Token> {
    let mut tokens = Vec::with_capacity(text.len() / 4 + 1);
    let mut start = 0;
    let mut body = BodyBegins::default();
    let mut diagram = None;
    loop {
        let (mut raw, mut end) = token(text, start, dialect);
        let keyword = (raw == Raw::Word).then(|| Keyword::of(&text[start..end], dialect)).flatten();
        if raw == Raw::Word
            && keyword.is_none()
            && let Some(networks) = body.diagram(text, start..end, dialect)
        {
            raw = Raw::DiagramWord;
            diagram = Some(networks).filter(|networks| !networks.is_empty());
        } else if let Some(networks) = diagram.take_if(|networks| networks.start == start) {
            (raw, end) = (Raw::Diagram, networks.end);
        }
        let token = Token { raw, keyword: keyword.filter(|_| raw == Raw::Word), start: start as u32, end: end as u32 };
        tokens.push(token);
        if raw == Raw::End {
            return tokens;
        }
        body.see(token);
        start = end;
    }
}

/// The token that begins at byte `start`: its look and the byte behind it.
fn token(text: &str, start: usize, dialect: Dialect) -> (Raw, usize) {
    let rest = &text[start..];
    let Some(first) = rest.chars().next() else { return (Raw::End, start) };
    let one = start + first.len_utf8();
    let byte = |at: usize| text.as_bytes().get(at).copied().unwrap_or(0);
    let second = byte(one);
    match first {
        '\r' if second == b'\n' => (Raw::Newline, one + 1),
        '\r' | '\n' | '\u{c}' => (Raw::Newline, one),
        first if is_blank(first) => (Raw::Blank, while_in(text, one, is_blank)),
        '/' if second == b'/' => (Raw::LineComment, start + rest.find(['\r', '\n']).unwrap_or(rest.len())),
        '/' if second == b'*' => (Raw::BlockComment, comment(text, start, "/*", "*/", true)),
        '(' if second == b'*' => {
            let nested = dialect.judge(Construct::NestedComment) != Judgement::Reject;
            (Raw::BlockComment, comment(text, start, "(*", "*)", nested))
        }
        // The multi-language comment of TIA Portal.
        '(' if second == b'/' && byte(one + 1) == b'*' => {
            (Raw::BlockComment, text[one + 2..].find("*/)").map_or(text.len(), |at| one + 2 + at + 3))
        }
        '(' => (Raw::ParenOpen, one),
        ')' => (Raw::ParenClose, one),
        '[' => (Raw::BracketOpen, one),
        ']' => (Raw::BracketClose, one),
        '{' => (Raw::Pragma, pragma(text, start)),
        ';' => (Raw::Semicolon, one),
        ',' => (Raw::Comma, one),
        ':' if second == b'=' => (Raw::Becomes, one + 1),
        ':' => (Raw::Colon, one),
        '=' if second == b'>' => (Raw::Delivers, one + 1),
        '=' if second == b'=' => (Raw::Foreign, one + 1),
        '!' if second == b'=' => (Raw::Foreign, one + 1),
        '=' => (Raw::Equal, one),
        '<' if second == b'=' => (Raw::LessEqual, one + 1),
        '<' if second == b'>' => (Raw::NotEqual, one + 1),
        '<' => (Raw::Less, one),
        '>' if second == b'=' => (Raw::GreaterEqual, one + 1),
        '>' => (Raw::Greater, one),
        '?' if second == b'=' => (Raw::Attempt, one + 1),
        '+' | '-' | '*' | '/' if second == b'=' => (Raw::Combined, one + 1),
        '*' if second == b'*' => (Raw::Power, one + 1),
        '+' => (Raw::Plus, one),
        '-' => (Raw::Minus, one),
        '*' => (Raw::Star, one),
        '/' => (Raw::Slash, one),
        '&' => (Raw::Ampersand, one),
        '^' => (Raw::Caret, one),
        '.' if second == b'.' => (Raw::Range, one + 1),
        '.' => (Raw::Point, one),
        first if straight_quote(first) == Some('\'') => (Raw::Characters, quoted_by_any(text, one, '\'')),
        first if straight_quote(first) == Some('"') => (Raw::Quoted, quoted_by_any(text, one, '"')),
        first if typeset_sign(first).is_some() => (typeset_sign(first).map_or(Raw::Unknown, |(raw, _)| raw), one),
        '\'' => (Raw::Characters, quoted(text, one, '\'', true)),
        '"' => (Raw::Quoted, quoted(text, one, '"', !quotes_names(dialect))),
        '`' => (Raw::Backquoted, quoted(text, one, '`', false)),
        '#' if second == b'"' => (Raw::Local, quoted(text, one + 1, '"', false)),
        '#' => match while_in(text, one, in_word) {
            end if end > one => (Raw::Local, end),
            _ => (Raw::Unknown, one),
        },
        '%' => match address(text, one) {
            end if end > one => (Raw::Percent, end),
            _ => (Raw::Unknown, one),
        },
        '0'..='9' => (Raw::Number, number(text, start)),
        first if in_word(first) => word(text, start, dialect),
        _ => (Raw::Unknown, one),
    }
}

/// Whether `"…"` is a name in this dialect, and no WSTRING.
pub(super) fn quotes_names(dialect: Dialect) -> bool {
    dialect.judge(Construct::QuotedName) != Judgement::Reject
}

/// Whether a token has its end.
pub(super) fn is_terminated(raw: Raw, text: &str) -> bool {
    match raw {
        Raw::Characters | Raw::Quoted if text.starts_with(|first| straight_quote(first).is_some()) => {
            let straight = straightened(text);
            is_terminated(raw, &straight)
        }
        Raw::Characters | Raw::Quoted | Raw::Backquoted => {
            let quote = text.chars().next().unwrap_or_default();
            text.len() > 1 && text.ends_with(quote) && (quote == '`' || !ends_in_escape(text) || quote == '"')
        }
        Raw::Local => !text.starts_with("#\"") || (text.len() > 2 && text.ends_with('"')),
        Raw::BlockComment => text.len() > 3 && (text.ends_with("*)") || text.ends_with("*/") || text.ends_with("*/)")),
        Raw::Pragma => text.ends_with('}'),
        Raw::Literal => match text.find('\'') {
            Some(at) => is_terminated(Raw::Characters, &text[at..]),
            None => true,
        },
        _ => true,
    }
}

/// The byte behind a comment; comments inside it count if they may be nested.
fn comment(text: &str, start: usize, open: &str, close: &str, nested: bool) -> usize {
    let bytes = text.as_bytes();
    let mut at = start + open.len();
    let first_end = text[at..].find(close).map_or(text.len(), |end| at + end + close.len());
    if !nested {
        return first_end;
    }
    let mut depth = 1_usize;
    while at < bytes.len() {
        if bytes[at..].starts_with(close.as_bytes()) {
            depth -= 1;
            at += close.len();
            if depth == 0 {
                return at;
            }
        } else if bytes[at..].starts_with(open.as_bytes()) {
            depth += 1;
            at += open.len();
        } else {
            at += 1;
        }
    }
    // An opening sign that is only mentioned in a comment does not swallow the rest of the file.
    first_end
}

/// The byte behind the brace that closes a pragma, or the end of the line if another one begins before.
fn pragma(text: &str, start: usize) -> usize {
    let mut in_string = false;
    for (at, byte) in text.bytes().enumerate().skip(start + 1) {
        match byte {
            b'\'' => in_string = !in_string,
            b'\r' | b'\n' => in_string = false,
            b'}' if !in_string => return at + 1,
            b'{' if !in_string => break,
            _ => {}
        }
    }
    start + text[start..].find(['\r', '\n']).unwrap_or(text.len() - start)
}

/// The token that a sign of typesetting stands for, and how ST writes it.
pub(super) fn typeset_sign(sign: char) -> Option<(Raw, &'static str)> {
    let signs = scan::typeset_sign(sign)?;
    let raw = match signs {
        ">=" => Raw::GreaterEqual,
        "<=" => Raw::LessEqual,
        "<>" => Raw::NotEqual,
        ":=" => Raw::Becomes,
        "=>" => Raw::Delivers,
        "*" => Raw::Star,
        "/" => Raw::Slash,
        "-" => Raw::Minus,
        "=" => Raw::Equal,
        _ => return None,
    };
    Some((raw, signs))
}

/// A quoted text with straight quotes; the same text if its own are straight.
pub(super) fn straightened(text: &str) -> Cow<'_, str> {
    let Some(quote) = text.chars().next().and_then(straight_quote) else { return Cow::Borrowed(text) };
    let inner: String = text.chars().skip(1).collect();
    match inner.strip_suffix(|last| straight_quote(last) == Some(quote) || last == quote) {
        Some(inner) => Cow::Owned(format!("{quote}{inner}{quote}")),
        None => Cow::Owned(format!("{quote}{inner}")),
    }
}

/// The byte behind the next quote of a kind, straight or curly, or the end of the line.
fn quoted_by_any(text: &str, start: usize, quote: char) -> usize {
    let closes = |c: char| c == quote || straight_quote(c) == Some(quote) || matches!(c, '\r' | '\n');
    match text[start..].char_indices().find(|&(_, c)| closes(c)) {
        Some((at, '\r' | '\n')) => start + at,
        Some((at, closing)) => start + at + closing.len_utf8(),
        None => text.len(),
    }
}

/// The byte behind the closing quote, or the end of the line.
fn quoted(text: &str, start: usize, quote: char, escapes: bool) -> usize {
    let bytes = text.as_bytes();
    let quote = quote as u8;
    let mut at = start;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'\r' | b'\n' => return at,
            b'$' if escapes && bytes.get(at + 1) == Some(&b'>') => match joined(text, at + 2) {
                Some(behind) => at = behind,
                None => at += 2,
            },
            b'$' if escapes && !matches!(bytes.get(at + 1), None | Some(b'\r' | b'\n')) => at += 2,
            byte if byte == quote => return at + 1,
            _ => at += 1,
        }
    }
    // An escape may have stepped into the middle of a wide character at most at the very end.
    at.min(text.len())
}

/// The byte behind the `$<` that continues a string on another line.
fn joined(text: &str, start: usize) -> Option<usize> {
    let at = while_in(text, start, char::is_whitespace);
    text[at..].starts_with("$<").then_some(at + 2)
}

/// `MW10`, `IX0.0`, `I*`, `I0.0:P`, `DB10.DBX0.0` behind the `%`.
fn address(text: &str, start: usize) -> usize {
    let bytes = text.as_bytes();
    let mut end = start;
    loop {
        end = while_in(text, end, in_word);
        match bytes.get(end) {
            Some(b'.') if bytes.get(end + 1).is_some_and(u8::is_ascii_alphanumeric) => end += 1,
            Some(b'*') if end > start => {
                end += 1;
                break;
            }
            _ => break,
        }
    }
    let direct = bytes.get(end) == Some(&b':') && matches!(bytes.get(end + 1), Some(b'p' | b'P'));
    if direct && !text[end + 2..].starts_with(in_word) { end + 2 } else { end }
}

fn number(text: &str, start: usize) -> usize {
    let bytes = text.as_bytes();
    let digit = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_digit);
    let digits = |at: usize| while_in(text, at, |c| c.is_ascii_digit() || c == '_');
    let mut end = digits(start);
    if bytes.get(end) == Some(&b'#') {
        return while_in(text, end + 1, in_word);
    }
    if bytes.get(end) == Some(&b'.') && digit(end + 1) {
        end = digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        if digit(end + 1 + sign) {
            end = digits(end + 1 + sign);
        }
    }
    // `5x` is one token, so that it gives one message.
    while_in(text, end, in_word)
}

/// What stands behind the `#` of a prefix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Prefix {
    /// `INT#-5`, `WORD#16#FF`, `REAL#1.5`, `BOOL#TRUE`, `BYTE#(1,2)`: with the long word of the type.
    Number(&'static str),
    /// `T#`, `TIME#`.
    Duration,
    /// `LT#`, `LTIME#`.
    LongDuration,
    S5Time,
    Date,
    LongDate,
    TimeOfDay,
    LongTimeOfDay,
    DateAndTime,
    LongDateAndTime,
    StructuredDateAndTime,
    /// `STRING#'a'`, `CHAR#'a'`, `CHAR#65`: with the type.
    Characters(&'static str),
    Counter,
    Pointer,
}

#[rustfmt::skip] // A table.
const PREFIXES: &[(&str, Prefix)] = &[
    ("INT", Prefix::Number("INT")), ("DINT", Prefix::Number("DINT")), ("UINT", Prefix::Number("UINT")), ("UDINT", Prefix::Number("UDINT")),
    ("SINT", Prefix::Number("SINT")), ("USINT", Prefix::Number("USINT")), ("LINT", Prefix::Number("LINT")), ("ULINT", Prefix::Number("ULINT")),
    ("L", Prefix::Number("DINT")), ("BOOL", Prefix::Number("BOOL")), ("BYTE", Prefix::Number("BYTE")), ("B", Prefix::Number("BYTE")),
    ("WORD", Prefix::Number("WORD")), ("W", Prefix::Number("WORD")), ("DWORD", Prefix::Number("DWORD")), ("DW", Prefix::Number("DWORD")),
    ("LWORD", Prefix::Number("LWORD")), ("LW", Prefix::Number("LWORD")), ("REAL", Prefix::Number("REAL")), ("LREAL", Prefix::Number("LREAL")),
    ("T", Prefix::Duration), ("TIME", Prefix::Duration), ("LT", Prefix::LongDuration), ("LTIME", Prefix::LongDuration),
    ("S5T", Prefix::S5Time), ("S5TIME", Prefix::S5Time),
    ("D", Prefix::Date), ("DATE", Prefix::Date), ("LD", Prefix::LongDate), ("LDATE", Prefix::LongDate),
    ("TOD", Prefix::TimeOfDay), ("TIME_OF_DAY", Prefix::TimeOfDay),
    ("LTOD", Prefix::LongTimeOfDay), ("LTIME_OF_DAY", Prefix::LongTimeOfDay),
    ("DT", Prefix::DateAndTime), ("DATE_AND_TIME", Prefix::DateAndTime),
    ("LDT", Prefix::LongDateAndTime), ("LDATE_AND_TIME", Prefix::LongDateAndTime), ("DTL", Prefix::StructuredDateAndTime),
    ("STRING", Prefix::Characters("STRING")), ("WSTRING", Prefix::Characters("WSTRING")),
    ("CHAR", Prefix::Characters("CHAR")), ("WCHAR", Prefix::Characters("WCHAR")),
    ("C", Prefix::Counter), ("Z", Prefix::Counter), ("P", Prefix::Pointer),
];

impl Prefix {
    /// The prefix that a word is, without regard to case.
    pub(super) fn of(word: &str) -> Option<Self> {
        PREFIXES.iter().find(|(name, _)| name.eq_ignore_ascii_case(word)).map(|&(_, prefix)| prefix)
    }
}

fn word(text: &str, start: usize, dialect: Dialect) -> (Raw, usize) {
    let end = while_in(text, start, in_word);
    if text.as_bytes().get(end) != Some(&b'#') {
        return (Raw::Word, end);
    }
    let behind = end + 1;
    let next = text.as_bytes().get(behind).copied().unwrap_or(0);
    let Some(prefix) = Prefix::of(&text[start..end]) else {
        // Where `#` marks a local variable, `NOT#x` is two words.
        let marks = dialect.judge(Construct::LocalMark) != Judgement::Reject;
        return match while_in(text, behind, in_word) {
            end if end > behind && !marks => (Raw::EnumValue, end),
            _ => (Raw::Word, end),
        };
    };
    let sign = usize::from(matches!(next, b'+' | b'-'));
    let with_points = |at: usize, belongs: &dyn Fn(char) -> bool| {
        let mut end = at;
        loop {
            end = while_in(text, end, belongs);
            if text.as_bytes().get(end) != Some(&b'.') || !text.as_bytes().get(end + 1).is_some_and(u8::is_ascii_digit) {
                return end;
            }
            end += 1;
        }
    };
    let end = match prefix {
        Prefix::Pointer => pointer(text, behind),
        Prefix::Number(_) if next == b'(' => {
            let rest = &text[behind..];
            let close = rest.find([')', '\r', '\n', ';']);
            close.map_or(text.len(), |at| behind + at + usize::from(rest.as_bytes()[at] == b')'))
        }
        Prefix::Characters(_) if matches!(next, b'\'' | b'"') => quoted(text, behind + 1, next as char, true),
        Prefix::Number("REAL" | "LREAL") => {
            let end = with_points(behind + sign, &in_word);
            let exponent = text[..end].ends_with(['e', 'E']) && matches!(text.as_bytes().get(end), Some(b'+' | b'-'));
            if exponent { while_in(text, end + 1, in_word) } else { end }
        }
        Prefix::Number(_) | Prefix::Characters(_) | Prefix::Counter => while_in(text, behind + sign, |c| in_word(c) || c == '#'),
        Prefix::Duration | Prefix::LongDuration | Prefix::S5Time => with_points(behind + sign, &in_word),
        _ => with_points(behind, &|c| c.is_ascii_digit() || matches!(c, '-' | ':' | '_')),
    };
    match end {
        end if end > behind => (Raw::Literal, end),
        end => (Raw::Word, end - 1),
    }
}
