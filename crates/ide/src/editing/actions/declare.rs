//! A declaration for a name that its block does not have.

use sieben_lang::names::{Access, Definition, DefinitionKind, Written};

use super::super::context::{in_word, line_before};
use super::{Action, At, Bytes, Kind};

/// Declares the variable at the cursor in its block.
pub(super) fn action(at: &At<'_>) -> Option<Action> {
    let source = at.snapshot.of_text(at.text)?;
    let language = at.snapshot.language(at.text)?;
    let index = source.at(at.range.start)?;
    let one = source.occurrence(index)?;
    if at.snapshot.names().resolve(at.text.0 as u32, index).is_some() || one.access == Access::Call {
        return None;
    }
    match one.written {
        Written::Local(_) => {}
        // A bare name of STL may be anything.
        Written::Plain(_) if language.dialect().is_some() => {}
        _ => return None,
    }
    let name = at.snapshot.slice(at.text, one.span.into());
    let block = one.scope.and_then(|scope| source.definition(scope)).filter(|block| block.kind.is_code())?;
    let is_static = language.dialect().is_some() && matches!(block.kind, DefinitionKind::FunctionBlock | DefinitionKind::Program);
    let (kind, section) = match (is_static, language.dialect()) {
        (true, _) => (DefinitionKind::Static, "VAR"),
        (false, Some(_)) if block.kind == DefinitionKind::Test => (DefinitionKind::Temp, "VAR"),
        _ => (DefinitionKind::Temp, "VAR_TEMP"),
    };
    let data_type = data_type(at, index, one.span.into());
    let title = format!("Declare `{name}` as {data_type} in {section}");
    let is_word = name.chars().all(super::super::context::in_word);
    let written = if is_word { name.to_owned() } else { format!("\"{name}\"") };
    let text = at.content();
    let line_end = at.line_end();
    let members = block.members.iter().filter_map(|&member| source.definition(member));
    let last = members.filter(|one| one.kind == kind).max_by_key(|one| one.whole.end);
    let edit = match last {
        // After the last declaration of the kind.
        Some(last) => {
            let line = text.get(last.whole.end as usize..)?.split(['\n', '\r']).next()?;
            let end = last.whole.end as usize;
            let rest = line.find(';').map_or(0, |at| at + 1);
            // A section on one line goes on there.
            let is_one_line = line.to_ascii_uppercase().contains("END_VAR");
            let indent = indent(text, last.whole.start as usize);
            match is_one_line {
                true => at.edit(Bytes { start: end + rest, end: end + rest }, format!(" {written} : {data_type};")),
                false => {
                    let start = end + line.len();
                    at.edit(Bytes { start, end: start }, format!("{line_end}{indent}{written} : {data_type};"))
                }
            }
        }
        None => {
            let start = section_start(text, block)?;
            let new_text = format!("{section}{line_end}  {written} : {data_type};{line_end}END_VAR{line_end}");
            at.edit(Bytes { start, end: start }, new_text)
        }
    };
    Some(Action::new(Kind::QuickFix, title, vec![edit]))
}

/// The blanks that a line begins with.
fn indent(text: &str, at: usize) -> String {
    line_before(text, at).chars().take_while(|sign| matches!(sign, ' ' | '\t')).collect()
}

/// Where another section of a block begins: after its last one, else before its statements.
fn section_start(text: &str, block: &Definition) -> Option<usize> {
    let (start, end) =
        (block.whole.start as usize, (block.body.start as usize).clamp(block.whole.start as usize, block.whole.end as usize));
    let end = if block.body.start == block.body.end { block.whole.end as usize } else { end };
    let head = text.get(start..end)?;
    let mut at = start;
    let mut found = None;
    let mut first_line = true;
    for line in head.split_inclusive('\n') {
        let word: String = line.trim_start().chars().take_while(|&sign| super::super::context::in_word(sign)).collect();
        let word = word.to_ascii_uppercase();
        let is_end = word == "END_VAR" || (word.starts_with("VAR") && line.to_ascii_uppercase().contains("END_VAR"));
        if word == "BEGIN" && found.is_none() {
            return Some(at);
        }
        at += line.len();
        if is_end || first_line {
            found = is_end.then_some(at).or(found);
            if first_line && !is_end {
                first_line = false;
                continue;
            }
        }
        first_line = false;
    }
    found.or_else(|| head.find('\n').map(|line| start + line + 1)).filter(|at| text.is_char_boundary(*at))
}

/// The type that a name seems to have where it stands.
fn data_type(at: &At<'_>, index: u32, span: Bytes) -> String {
    let text = at.content();
    let line = line_before(text, span.start);
    let is_st = at.snapshot.language(at.text).is_some_and(|language| language.dialect().is_some());
    if let Some(known) = type_beside(at, index, span) {
        return known;
    }
    if !is_st {
        let statement = line.rsplit(';').next().unwrap_or_default();
        let statement = statement.rsplit(':').next().unwrap_or_default().trim();
        let word = statement.split_whitespace().next().unwrap_or_default().to_ascii_uppercase();
        let found = match word.as_str() {
            "L" | "T" => "INT",
            "LAR1" | "LAR2" | "TAR1" | "TAR2" => "DWORD",
            _ => "BOOL",
        };
        return found.to_owned();
    }
    let rest = text.get(span.end..).unwrap_or_default();
    let rest = rest.split([';', '\n', '\r']).next().unwrap_or_default().to_ascii_uppercase();
    let before = line.trim_end_matches(['#', ' ']).to_ascii_uppercase();
    let is_condition = ["IF", "ELSIF", "WHILE", "UNTIL", "NOT", "AND", "OR", "XOR"].iter().any(|word| before.ends_with(word));
    // What another argument takes stands after a comma.
    let assigned = rest.trim_start_matches(['"', ' ', '\t']).strip_prefix(":=").map_or("", str::trim);
    let found = match () {
        () if assigned.starts_with("TRUE") || assigned.starts_with("FALSE") || assigned.starts_with("NOT ") => "BOOL",
        () if assigned.starts_with("T#") || assigned.starts_with("TIME#") => "TIME",
        () if assigned.starts_with('\'') => "STRING",
        () if assigned.contains('.') && assigned.trim_end().parse::<f64>().is_ok() => "REAL",
        () if is_condition && !rest.contains(['<', '>', '=']) => "BOOL",
        () => "INT",
    };
    found.to_owned()
}

/// The type of the parameter that takes the name, or of the other side of its assignment.
fn type_beside(at: &At<'_>, index: u32, span: Bytes) -> Option<String> {
    let (source, names, text) = (at.snapshot.of_text(at.text)?, at.snapshot.names(), at.content());
    let type_of = |index: u32| {
        let target = names.resolve(at.text.0 as u32, index)?;
        let found = names.heads(target).into_iter().find_map(|head| names.definition_at(head))?.data_type.clone();
        // Types with parts of their own are none for a variable beside them.
        let is_word = !found.is_empty() && found.chars().all(|sign| in_word(sign) || sign == '"');
        is_word.then_some(found)
    };
    let between = |from: usize, to: usize| text.get(from..to).map(|signs| signs.trim_matches(['#', '"', ' ', '\t', '\r', '\n']));
    let end = text.get(span.end..)?.find([';', '\n', '\r']).map_or(text.len(), |length| span.end + length);
    let before = (0..index).rev().take(16).find_map(|other| {
        let one = source.occurrence(other)?;
        let gap = between(one.span.end as usize, span.start)?;
        if matches!(gap, ":=" | "=>") && matches!(one.written, Written::Parameter(..)) {
            return Some(other);
        }
        // A whole expression has the type of what takes it, where nothing is called or compared.
        let expression = text.get(one.span.end as usize..end)?.trim_start_matches(['"', ' ', '\t']).strip_prefix(":=")?;
        (!expression.contains(['(', ')', '[', ']', '<', '>', '=', ';'])).then_some(other)
    });
    let after = || {
        let next = source.occurrence(index + 1)?;
        let is_whole = between(next.span.end as usize, end) == Some("");
        (is_whole && between(span.end, next.span.start as usize) == Some(":=")).then_some(index + 1)
    };
    before.or_else(after).and_then(type_of)
}
