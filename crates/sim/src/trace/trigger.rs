//! Triggers: when the part of a run begins that is worth keeping.

use sieben_engine::Program;
use sieben_model::symbols::SymbolTable;

use super::Moment;
use crate::names::{Kind, Name, NameError, Sample};

/// What a trigger waits for.
#[derive(Clone, Debug, PartialEq)]
pub enum Trigger {
    /// A bit changes.
    Edge(Name, Edge),
    /// A comparison is true.
    Comparison(Name, Comparison, Sample),
    /// A scan begins, by its number from 0.
    Scan(u64),
}

/// Which change of a bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edge {
    /// From 0 to 1.
    Rising,
    /// From 1 to 0.
    Falling,
    /// Either.
    Both,
}

/// How a value is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// Both are the same.
    Equal,
    /// They differ.
    Unequal,
    /// The value is less than the limit.
    Less,
    /// The value is less than the limit, or the same.
    LessOrEqual,
    /// The value is more than the limit.
    More,
    /// The value is more than the limit, or the same.
    MoreOrEqual,
}

/// The signs of the comparisons; a longer one stands before the sign that it begins with.
const SIGNS: &[(&str, Comparison)] = &[
    ("<>", Comparison::Unequal),
    ("!=", Comparison::Unequal),
    ("<=", Comparison::LessOrEqual),
    (">=", Comparison::MoreOrEqual),
    ("==", Comparison::Equal),
    ("=", Comparison::Equal),
    ("<", Comparison::Less),
    (">", Comparison::More),
];

/// The words of the edges.
const EDGES: &[(&str, Edge)] = &[("rises", Edge::Rising), ("falls", Edge::Falling), ("changes", Edge::Both)];

/// Why a trigger is none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TriggerError {
    /// Its form, in one sentence.
    Form(String),
    /// A name in it.
    Name(String, NameError),
    /// The value that is compared with.
    Value(NameError),
}

impl Trigger {
    /// Reads `I 0.0 rises`, `I0.0 falls`, `I0.0 changes`, `MW10 > 5`, `scan 500`.
    ///
    /// # Errors
    /// It is none of them, or names what the program does not have.
    pub fn parse(text: &str, symbols: &SymbolTable, program: &Program) -> Result<Self, TriggerError> {
        let text = text.trim();
        let form = || {
            TriggerError::Form(format!(
                "`{text}` is no trigger; write `I0.0 rises`, `I0.0 falls`, `I0.0 changes`, `MW10 > 5` or `scan 500`"
            ))
        };
        let named = |name: &str| Name::parse(name, symbols, program).map_err(|error| TriggerError::Name(name.trim().to_owned(), error));
        if let Some((before, word)) = text.rsplit_once(char::is_whitespace) {
            if before.trim().eq_ignore_ascii_case("scan") {
                return word.parse().map(Self::Scan).map_err(|_| form());
            }
            if let Some(&(_, edge)) = EDGES.iter().find(|(name, _)| word.eq_ignore_ascii_case(name)) {
                let name = named(before)?;
                if *name.kind() != Kind::Bit {
                    let why = format!("`{}` is no bit, so it has no edges; write a comparison such as `{} > 5`", name.text(), name.text());
                    return Err(TriggerError::Form(why));
                }
                return Ok(Self::Edge(name, edge));
            }
        }
        let (at, sign, comparison) = comparison(text).ok_or_else(form)?;
        let (name, limit) = (named(&text[..at])?, text[at + sign.len()..].trim());
        if limit.is_empty() {
            return Err(form());
        }
        let kind = name.recorded();
        let limit = match kind {
            Kind::Text => Sample::text(limit),
            _ => Sample::of(&name.value(limit).map_err(TriggerError::Value)?),
        };
        if !matches!(comparison, Comparison::Equal | Comparison::Unequal) && limit.number(&kind).is_none() {
            let why = format!("`{}` has no order, so it can only be compared with `=` and `<>`", name.text());
            return Err(TriggerError::Form(why));
        }
        Ok(Self::Comparison(name, comparison, limit))
    }

    /// The name whose value it looks at.
    pub fn name(&self) -> Option<&Name> {
        match self {
            Self::Edge(name, _) | Self::Comparison(name, ..) => Some(name),
            Self::Scan(_) => None,
        }
    }

    /// Whether it comes in a scan: `value` is that of its name now, `before` in the scan before. An edge needs both.
    pub fn comes(&self, moment: Moment, before: Option<&Sample>, value: &Sample) -> bool {
        match self {
            Self::Scan(number) => moment.scan >= *number,
            Self::Edge(_, edge) => {
                let rises = before == Some(&Sample::Bits(0)) && *value == Sample::Bits(1);
                let falls = before == Some(&Sample::Bits(1)) && *value == Sample::Bits(0);
                match edge {
                    Edge::Rising => rises,
                    Edge::Falling => falls,
                    Edge::Both => rises || falls,
                }
            }
            Self::Comparison(name, comparison, limit) => {
                let kind = name.recorded();
                let numbers = value.scale(&kind).zip(limit.scale(&kind));
                match (comparison, numbers) {
                    _ if *value == Sample::Absent => false,
                    (Comparison::Equal, Some((value, limit))) => value == limit,
                    (Comparison::Unequal, Some((value, limit))) => value != limit,
                    (Comparison::Equal, None) => value == limit,
                    (Comparison::Unequal, None) => value != limit,
                    (Comparison::Less, Some((value, limit))) => value < limit,
                    (Comparison::LessOrEqual, Some((value, limit))) => value <= limit,
                    (Comparison::More, Some((value, limit))) => value > limit,
                    (Comparison::MoreOrEqual, Some((value, limit))) => value >= limit,
                    // A REAL that is no number is neither more nor less.
                    (_, None) => false,
                }
            }
        }
    }
}

/// The first sign of a comparison outside quotes: where it stands.
fn comparison(text: &str) -> Option<(usize, &'static str, Comparison)> {
    let mut quoted = false;
    text.char_indices().find_map(|(at, c)| {
        quoted ^= c == '"';
        let &(sign, comparison) = SIGNS.iter().find(|(sign, _)| !quoted && text[at..].starts_with(sign))?;
        Some((at, sign, comparison))
    })
}
