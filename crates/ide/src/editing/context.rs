//! What stands before a position, read from the text alone: it need not be understood as a whole.

use sieben_lang::language::Language;
use sieben_lang::names::DefId;
use sieben_lang::source_names::key;
use sieben_lang::st::Dialect;
use sieben_model::address::Operand;
use sieben_model::block::BlockKind;

use super::{Position, Snapshot};

/// How far a service looks back for the beginning of a call or a section, in bytes: calls are shorter.
const LOOK_BACK_MAX: usize = 20_000;

/// How a name is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quoting {
    /// `name`.
    Bare,
    /// `"name"`.
    Global,
    /// `#name`.
    Local,
}

/// A name as written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Name {
    pub(super) text: String,
    pub(super) quoting: Quoting,
}

/// A word that is being typed, with what it is a part of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Typed {
    /// The first byte of the word, with its quote or `#`.
    pub(super) start: usize,
    /// The word without them.
    pub(super) word: Name,
    /// The names before it, with points between them.
    pub(super) path: Vec<Name>,
}

pub(super) fn in_word(sign: char) -> bool {
    sign.is_alphanumeric() || sign == '_'
}

/// The line up to a byte.
pub(super) fn line_before(text: &str, offset: usize) -> &str {
    let before = text.get(..offset).unwrap_or_default();
    &before[before.rfind(['\n', '\r']).map_or(0, |at| at + 1)..]
}

/// Whether `"` writes a name there and no string.
pub(super) fn quotes_names(language: Language) -> bool {
    language.dialect().is_none_or(|dialect| matches!(dialect.base(), Dialect::Scl | Dialect::Tia))
}

/// Whether a byte lies in a comment or a string.
pub(super) fn in_comment(text: &str, offset: usize) -> bool {
    let line = line_before(text, offset);
    let mut quote = None;
    let mut signs = line.chars().peekable();
    while let Some(sign) = signs.next() {
        match (quote, sign) {
            (None, '\'' | '"') => quote = Some(sign),
            (Some(open), _) if open == sign => quote = None,
            (None, '/') if signs.peek() == Some(&'/') => return true,
            _ => {}
        }
    }
    let from = floor(text, offset.saturating_sub(LOOK_BACK_MAX));
    let before = text.get(from..offset).unwrap_or_default();
    let is_open = match (before.rfind("(*"), before.rfind("*)")) {
        (Some(open), Some(close)) => close < open,
        (Some(_), None) => true,
        _ => false,
    };
    is_open || quote == Some('\'')
}

fn floor(text: &str, mut offset: usize) -> usize {
    offset = offset.min(text.len());
    while !text.is_char_boundary(offset) {
        offset -= 1;
    }
    offset
}

/// The word before a byte.
pub(super) fn typed(text: &str, offset: usize, language: Language) -> Typed {
    let line = line_before(text, offset);
    let line_start = offset - line.len();
    let open = (quotes_names(language) && line.matches('"').count() % 2 == 1).then(|| line.rfind('"')).flatten();
    let (start, word) = match open {
        Some(at) if line[..at].ends_with('#') => (at - 1, Name { text: line[at + 1..].to_owned(), quoting: Quoting::Local }),
        Some(at) => (at, Name { text: line[at + 1..].to_owned(), quoting: Quoting::Global }),
        None => {
            let begin = line.len() - line.chars().rev().take_while(|&sign| in_word(sign)).map(char::len_utf8).sum::<usize>();
            let word = line[begin..].to_owned();
            match line[..begin].ends_with('#') {
                true => (begin - 1, Name { text: word, quoting: Quoting::Local }),
                false => (begin, Name { text: word, quoting: Quoting::Bare }),
            }
        }
    };
    let (path, _) = path_before(line, start);
    Typed { start: line_start + start, word, path }
}

/// Takes the letters of a block into a word of STL that is its number: `FC 1`.
pub(super) fn with_kind(text: &str, typed: &mut Typed) {
    let is_number = typed.word.quoting == Quoting::Bare && typed.word.text.chars().all(|sign| sign.is_ascii_digit());
    let line = line_before(text, typed.start);
    let Some(before) = line.strip_suffix(' ').map(str::trim_end).filter(|_| is_number && typed.path.is_empty()) else { return };
    let letters = &before[before.trim_end_matches(|sign: char| sign.is_ascii_alphabetic()).len()..];
    if BlockKind::from_abbreviation(letters).is_some() {
        typed.start -= line.len() - before.len() + letters.len();
        typed.word.text = format!("{letters} {}", typed.word.text);
    }
}

/// The names with points after them before a byte of a line, and where the first begins.
fn path_before(line: &str, start: usize) -> (Vec<Name>, usize) {
    let mut path = Vec::new();
    let mut end = start;
    while let Some(before) = line[..end].strip_suffix('.') {
        let mut at = before.len();
        // Indexes do not matter.
        while before[..at].ends_with(']') {
            let mut depth = 0;
            let open = before[..at].char_indices().rev().find(|&(_, sign)| {
                depth += i32::from(sign == ']') - i32::from(sign == '[');
                depth == 0
            });
            let Some((open, _)) = open else { return (path, end) };
            at = before[..open].trim_end_matches([' ', '^']).len();
        }
        at = before[..at].trim_end_matches('^').len();
        let Some((name, begin)) = name_before(before, at) else { break };
        path.insert(0, name);
        end = begin;
    }
    (path, end)
}

/// The name that ends at a byte, and where it begins.
fn name_before(text: &str, end: usize) -> Option<(Name, usize)> {
    let before = text.get(..end)?;
    if let Some(inner) = before.strip_suffix('"') {
        let open = inner.rfind('"')?;
        let is_local = inner[..open].ends_with('#');
        let quoting = if is_local { Quoting::Local } else { Quoting::Global };
        return Some((Name { text: inner[open + 1..].to_owned(), quoting }, open - usize::from(is_local)));
    }
    let begin = before.len() - before.chars().rev().take_while(|&sign| in_word(sign)).map(char::len_utf8).sum::<usize>();
    if begin == before.len() {
        return None;
    }
    let is_local = before[..begin].ends_with('#');
    let quoting = if is_local { Quoting::Local } else { Quoting::Bare };
    Some((Name { text: before[begin..].to_owned(), quoting }, begin - usize::from(is_local)))
}

/// What a path of names stands for in the block around a position.
pub(super) fn resolve(snapshot: &Snapshot, position: Position, path: &[Name]) -> Option<DefId> {
    let names = snapshot.names();
    let text = position.text.0 as u32;
    let source = snapshot.of_text(position.text)?;
    let (first, rest) = path.split_first()?;
    let local = || {
        let scope = source.scope_at(position.offset)?;
        names.local(text, Some(scope), source.id(&key(&first.text))?)
    };
    let numbered = || match Operand::parse(&first.text)? {
        Operand::Block(block) => Some(DefId::Block(block)),
        _ => None,
    };
    let own = || {
        let index = source.definitions_of(&key(&first.text)).iter().copied();
        let mut global = index.filter(|&index| source.definition(index).is_some_and(|one| one.parent.is_none()));
        names.of_definition((text, global.next()?))
    };
    let mut found = match first.quoting {
        Quoting::Local => local(),
        Quoting::Global => names.global(&first.text),
        Quoting::Bare => local().or_else(|| names.global(&first.text)).or_else(numbered).or_else(own),
    }?;
    for name in rest {
        found = names.member(found, &key(&name.text))?;
    }
    Some(found)
}

/// A call around a position.
#[derive(Clone, Debug)]
pub(super) struct Call {
    /// The word that is called.
    pub(super) word: String,
    /// What is called, if that is known.
    pub(super) callee: Option<DefId>,
    /// How many arguments end before the position.
    pub(super) argument: usize,
    /// The formal parameter that the argument at the position begins with.
    pub(super) name: Option<String>,
    /// The formal parameters that are written already.
    pub(super) given: Vec<String>,
    /// Whether a value stands at the position: its formal parameter is written, or it has none.
    pub(super) at_value: bool,
}

/// The call whose brackets are around a position.
pub(super) fn call(snapshot: &Snapshot, position: Position) -> Option<Call> {
    let text = &snapshot.text(position.text)?.text;
    let offset = snapshot.offset(position)?;
    let language = snapshot.language(position.text)?;
    let from = floor(text, offset.saturating_sub(LOOK_BACK_MAX));
    let before = text.get(from..offset)?;
    let (mut depth, mut open, mut quoted) = (0_i32, None, None);
    for (at, sign) in before.char_indices().rev() {
        match (quoted, sign) {
            (None, '\'' | '"') => quoted = Some(sign),
            (Some(quote), _) if quote == sign => quoted = None,
            (Some(_), '\n') => quoted = None,
            (Some(_), _) => {}
            (None, ')' | ']') => depth += 1,
            (None, '(' | '[') if depth > 0 => depth -= 1,
            (None, '(') => {
                open = Some(at);
                break;
            }
            (None, ';') => return None,
            _ => {}
        }
    }
    let open = open?;
    let arguments = &before[open + 1..];
    let callee_end = before[..open].trim_end().len();
    let (word, callee) = match language.dialect() {
        None => {
            // `CALL FB 1, DB 2 (`: what stands after the word.
            let line = &before[..callee_end];
            let statement = &line[line.rfind(['\n', '\r', ';']).map_or(0, |at| at + 1)..];
            let upper = statement.to_ascii_uppercase();
            let at = upper.find("CALL")? + "CALL".len();
            let written = statement.get(at..)?.split(',').next()?.trim();
            let callee = stl_callee(snapshot, position, written);
            (written.trim_matches(['"', '#']).to_owned(), callee)
        }
        Some(_) => {
            let line_start = before[..callee_end].rfind(['\n', '\r']).map_or(0, |at| at + 1);
            let line = &before[line_start..callee_end];
            let (name, begin) = name_before(line, line.len())?;
            let (mut path, _) = path_before(line, begin);
            let word = name.text.clone();
            path.push(name);
            (word, resolve(snapshot, position, &path))
        }
    };
    let mut parts = Vec::new();
    let (mut start, mut depth, mut quoted) = (0, 0_i32, None);
    for (at, sign) in arguments.char_indices() {
        match (quoted, sign) {
            (None, '\'' | '"') => quoted = Some(sign),
            (Some(quote), _) if quote == sign => quoted = None,
            (Some(_), _) => {}
            (None, '(' | '[') => depth += 1,
            (None, ')' | ']') => depth -= 1,
            (None, ',') if depth == 0 => {
                parts.push(&arguments[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    let last = &arguments[start..];
    let formal = |part: &str| {
        let at = part.find(":=").or_else(|| part.find("=>"))?;
        let name = part[..at].trim().trim_matches(['"', '#']);
        let name = name.rsplit(['\n', '\r']).next().unwrap_or(name).trim();
        (!name.is_empty()).then(|| name.to_owned())
    };
    let name = formal(last);
    Some(Call {
        word,
        callee,
        argument: parts.len(),
        given: parts.iter().filter_map(|part| formal(part)).collect(),
        at_value: name.is_some() || language.dialect().is_some(),
        name,
    })
}

fn stl_callee(snapshot: &Snapshot, position: Position, written: &str) -> Option<DefId> {
    if let Some(Operand::Block(block)) = Operand::parse(written) {
        return Some(DefId::Block(block));
    }
    let path: Vec<Name> = written
        .split('.')
        .map(|part| {
            let part = part.split('[').next().unwrap_or(part).trim();
            match part.strip_prefix('#') {
                Some(name) => Name { text: name.trim_matches('"').to_owned(), quoting: Quoting::Local },
                None if part.starts_with('"') => Name { text: part.trim_matches('"').to_owned(), quoting: Quoting::Global },
                None => Name { text: part.to_owned(), quoting: Quoting::Bare },
            }
        })
        .collect();
    resolve(snapshot, position, &path)
}

/// The block with parameters that something stands for: itself, or the type of an instance.
pub(super) fn block_of(snapshot: &Snapshot, target: DefId) -> DefId {
    let names = snapshot.names();
    let is_data = |block: sieben_model::block::BlockId| block.kind == BlockKind::DataBlock;
    let heads = names.heads(target);
    let is_instance = match target {
        DefId::Block(block) => is_data(block),
        _ => heads
            .iter()
            .filter_map(|at| names.definition_at(*at))
            .any(|one| one.kind.is_variable() || one.kind == sieben_lang::names::DefinitionKind::DataBlock),
    };
    let of_type = is_instance.then(|| heads.into_iter().find_map(|at| names.type_of(at))).flatten();
    of_type.unwrap_or(target)
}
