//! Properties: what has to hold of a run, as expressions that whoever runs the scenario compiles.

use std::fmt;

use crate::duration;

macro_rules! kinds {
    ($( $(#[$doc:meta])* $Variant:ident $word:literal, )*) => {
        /// Kinds of properties.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum PropertyKind { $( $(#[$doc])* $Variant, )* }

        impl PropertyKind {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$Variant),*];
            /// The word of files.
            pub fn word(self) -> &'static str {
                match self { $(Self::$Variant => $word),* }
            }
        }
    };
}

kinds! {
    /// It is false after each scan.
    Never "never",
    /// It is true after each scan.
    Always "always",
    /// It is true after at least one scan of a whole campaign.
    Sometimes "sometimes",
    /// Whenever it is true, another one is true at once or within a time.
    Response "response",
    /// It is true after the last scan.
    Finally "finally",
    /// It has the same value after each scan of several programs.
    Same "same",
}

impl PropertyKind {
    /// What a word means.
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|one| one.word() == word)
    }

    /// What has to hold where it does not.
    pub fn demand(self) -> &'static str {
        match self {
            Self::Never => "must never be true, and is",
            Self::Always => "must always be true, and is not",
            Self::Sometimes => "must be true sometimes, and was not",
            Self::Response => "must be answered in time, and was not",
            Self::Finally => "must be true at the end, and is not",
            Self::Same => "must be the same in all programs, and is not",
        }
    }
}

/// A line `property`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PropertyLine {
    /// The line of the scenario, from 1.
    pub line: usize,
    /// Its kind: of one run, so neither `sometimes` nor `same`.
    pub kind: PropertyKind,
    /// What it is called.
    pub name: String,
    /// The expression; of a response what it is asked by.
    pub expression: String,
    /// What a response has to become.
    pub then: Option<String>,
    /// How much time it has, in microseconds.
    pub within_us: u64,
}

impl PropertyLine {
    /// Reads `never "short circuit" Star AND Delta` or `response "it starts" within 2s Start -> Running`.
    pub(super) fn parse(line: usize, rest: &str) -> Result<Self, String> {
        let wanted = || {
            format!(
                "`property {rest}` is not understood; write `property never \"short circuit\" Star AND Delta`, `always`, `finally`, or \
                 `property response \"it starts\" within 2s Start -> Running`"
            )
        };
        let (word, rest_of) = rest.split_once(char::is_whitespace).ok_or_else(wanted)?;
        let of_one_run = |kind: &PropertyKind| !matches!(kind, PropertyKind::Sometimes | PropertyKind::Same);
        let kind = PropertyKind::from_word(word).filter(of_one_run).ok_or_else(wanted)?;
        let (name, expression) = rest_of.trim().strip_prefix('"').and_then(|rest| rest.split_once('"')).ok_or_else(wanted)?;
        let (mut expression, mut then, mut within_us) = (expression.trim(), None, 0);
        if kind == PropertyKind::Response {
            if let Some(timed) = expression.strip_prefix("within ") {
                let (time, rest) = timed.trim().split_once(char::is_whitespace).ok_or_else(wanted)?;
                // Not longer than ten years.
                within_us = duration::parse(time)?.as_micros() as u64;
                expression = rest.trim();
            }
            let (when, what) = expression.split_once("->").ok_or_else(wanted)?;
            (expression, then) = (when.trim(), Some(what.trim().to_owned()));
        }
        if expression.is_empty() || name.trim().is_empty() || then.as_ref().is_some_and(String::is_empty) {
            return Err(wanted());
        }
        Ok(Self { line, kind, name: name.to_owned(), expression: expression.to_owned(), then, within_us })
    }
}

impl fmt::Display for PropertyLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "property {} \"{}\" ", self.kind.word(), self.name.replace('"', "'"))?;
        if self.within_us > 0 {
            write!(f, "within {} ", super::spelling::time(self.within_us))?;
        }
        f.write_str(&one_line(&self.expression))?;
        self.then.as_ref().map_or(Ok(()), |then| write!(f, " -> {}", one_line(then)))
    }
}

/// An expression without line ends and without the comments that go to one.
fn one_line(expression: &str) -> String {
    let lines = expression.lines().map(|line| line.find("//").map_or(line, |at| &line[..at]));
    lines.flat_map(str::split_whitespace).collect::<Vec<_>>().join(" ")
}
