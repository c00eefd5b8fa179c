//! Names and values as users write them: lists, assignments, and what they mean on a CPU, in the vocabulary of scenarios.

use serde_json::{Value as Json, json};
use sieben_cpu::Cpu;
use sieben_engine::Program;
use sieben_model::bcd;
use sieben_model::format::{Figure, Format, FormatError, ROWS};
use sieben_model::problems::Problem;
use sieben_model::symbols::SymbolTable;
use sieben_sim::names::{Name, NameError, Setting, Shown, catalogue};

use crate::refusal::Refusal;
use sieben_model::nearest::nearest;

/// Splits a list of names at commas outside brackets and quotes: `MW 10,DB1.field[1,2],"a,b"`.
pub fn split_list(list: &str) -> Vec<&str> {
    split_outside(list, ',', usize::MAX).into_iter().map(str::trim).filter(|name| !name.is_empty()).collect()
}

/// Splits `NAME=VALUE` at the first `=` outside quotes.
pub fn split_assignment(text: &str) -> Result<(&str, &str), Refusal> {
    match split_outside(text, '=', 2)[..] {
        // `:=` is what STL writes.
        [name, value] => Ok((name.trim().trim_end_matches(':').trim_end(), value.trim())),
        _ => Err(Refusal::new(Problem::P7003, format!("`{text}` gives no value"))
            .help("write `NAME=VALUE`, such as `I0.0=1` or `MW10=W#16#00FF`")),
    }
}

fn split_outside(text: &str, separator: char, parts_max: usize) -> Vec<&str> {
    let (mut parts, mut start, mut quoted, mut depth) = (Vec::new(), 0, false, 0_usize);
    for (at, c) in text.char_indices() {
        match c {
            '"' => quoted = !quoted,
            '[' if !quoted => depth += 1,
            ']' if !quoted => depth = depth.saturating_sub(1),
            _ if c == separator && !quoted && depth == 0 && parts.len() + 1 < parts_max => {
                parts.push(&text[start..at]);
                start = at + c.len_utf8();
            }
            _ => {}
        }
    }
    parts.push(&text[start..]);
    parts
}

/// What a name means on this CPU; refuses what has no value there.
pub fn resolve(name: &str, symbols: &SymbolTable, cpu: &Cpu) -> Result<Name, Refusal> {
    let failed = |error: NameError| {
        let refusal = refused(&error);
        if refusal.problem != Problem::P7003 {
            return refusal;
        }
        let (word, format) = Format::split(name).map_or((name, String::new()), |(word, format)| (word, format!(":{format}")));
        match suggested(word, symbols, cpu.program()) {
            Some((near, true)) => refusal.help(format!("did you mean the symbol `{near}{format}`?")),
            Some((near, false)) => refusal.help(format!("did you mean `{near}{format}`?")),
            None => refusal,
        }
    };
    let name = Name::parse(name, symbols, cpu.program()).map_err(failed)?;
    name.read(cpu).map_err(failed)?;
    Ok(name)
}

/// Why a name is of no use, by what is wrong with it: the name, or the format that it is to be shown in.
pub fn refused(error: &NameError) -> Refusal {
    match error.format() {
        None if error.is_of_constant() => Refusal::new(Problem::P7113, error.to_string()),
        None => Refusal::new(Problem::P7003, error.to_string()),
        Some(format @ FormatError::Unknown(word)) => {
            let near = nearest(word, ROWS.iter().map(|row| row.name));
            let help =
                near.map_or_else(|| format.help(), |near| format!("did you mean `{near}`? `sieben explain formats` lists all formats"));
            Refusal::new(Problem::P7125, error.to_string()).help(help)
        }
        Some(format) => Refusal::new(Problem::P7126, error.to_string()).help(format.help()),
    }
}

/// The name that a user may have meant, and whether it is a symbol.
fn suggested(word: &str, symbols: &SymbolTable, program: &Program) -> Option<(String, bool)> {
    let plain = word.trim_matches('"');
    let differs = |near: &&str| !near.eq_ignore_ascii_case(plain);
    let symbol = nearest(plain, symbols.symbols().iter().map(|symbol| symbol.name.as_str())).filter(differs);
    if let Some(symbol) = symbol {
        return Some((symbol.to_owned(), true));
    }
    let known = catalogue(symbols, program);
    nearest(plain, known.iter().map(|name| name.text())).filter(differs).map(|near| (near.to_owned(), false))
}

/// All names that have a value on this CPU: symbols, variables of the program, fields of data blocks.
pub fn all(symbols: &SymbolTable, cpu: &Cpu) -> Vec<Name> {
    catalogue(symbols, cpu.program()).into_iter().filter(|name| name.read(cpu).is_ok()).collect()
}

/// What the names in the lists of `--show` mean on this CPU, in their order.
pub fn resolve_lists(lists: &[String], symbols: &SymbolTable, cpu: &Cpu) -> Result<Vec<Name>, Refusal> {
    lists.iter().flat_map(|list| split_list(list)).map(|name| resolve(name, symbols, cpu)).collect()
}

/// Reads `NAME=VALUE`.
pub fn setting(text: &str, symbols: &SymbolTable, cpu: &Cpu) -> Result<Setting, Refusal> {
    let (name, value) = split_assignment(text)?;
    let name = resolve(name, symbols, cpu)?;
    Setting::new(name, value).map_err(|error| unfit(text, &error))
}

/// Gives a name its value.
pub fn apply(setting: &Setting, cpu: &mut Cpu) -> Result<(), Refusal> {
    setting.apply(cpu).map_err(|error| unfit(&format!("{}={}", setting.name.text(), setting.text), &error))
}

fn unfit(text: &str, error: &NameError) -> Refusal {
    let refusal = Refusal::new(problem_of_value(error), format!("`{text}`: {error}"));
    let status = text.split('=').next().is_some_and(|name| name.trim().eq_ignore_ascii_case("STW"));
    if status {
        refusal.help("write nine characters 0 or 1 in the order BR CC1 CC0 OV OS OR STA RLO /FC: `STW=000000110`")
    } else {
        refusal
    }
}

/// Which problem it is that something cannot be set.
pub fn problem_of_value(error: &NameError) -> Problem {
    if error.is_of_constant() { Problem::P7113 } else { Problem::P7004 }
}

/// The value of a name as people read it; data blocks can disappear while a program runs.
pub fn text(name: &Name, cpu: &Cpu) -> String {
    name.read(cpu).map_or_else(|_| "not loaded".to_owned(), |shown| shown.to_string())
}

/// The value of a name as people read it where they look at many: bits also as the number that they are, a timer as a time.
pub fn readable(name: &Name, cpu: &Cpu) -> String {
    name.clone().readable().read(cpu).map_or_else(|_| "not loaded".to_owned(), |shown| shown.readable())
}

/// What else there is to see of a value in its format: the numbers of its bits, its fields.
pub fn details(name: &Name, cpu: &Cpu) -> Vec<String> {
    match name.read(cpu) {
        Ok(Shown::Formatted(formatted)) => formatted.details,
        _ => Vec::new(),
    }
}

/// The value of a name as JSON: bits and numbers as numbers, all else as strings; so are integers of 64 bits and what is infinite or no number.
pub fn to_json(name: &Name, cpu: &Cpu) -> Json {
    name.read(cpu).map_or(Json::Null, |shown| shown_json(&shown))
}

/// A value as JSON.
pub fn shown_json(shown: &Shown) -> Json {
    match shown {
        Shown::Bit(bit) => json!(u8::from(*bit)),
        Shown::Number(number) => json!(number),
        Shown::TimeLeft(word) => json!(bcd::decode(u32::from(*word), 3)),
        Shown::Real(number) if number.is_finite() => real_json(*number),
        Shown::Formatted(formatted) => match formatted.figure {
            Some(Figure::OfBase { count, base_ms }) => json!({ "shown": formatted.text, "value": count, "base_ms": base_ms }),
            Some(Figure::Whole(number)) if number.unsigned_abs() <= JSON_WHOLE_MAX => json!(number),
            Some(Figure::Real(number)) if number.is_finite() => real_json(number),
            Some(Figure::LongReal(number)) if number.is_finite() => json!(number),
            _ => json!(formatted.text),
        },
        Shown::LongReal(number) if number.is_finite() => json!(number),
        shown => json!(shown.to_string()),
    }
}

/// The digits of the REAL itself, not those of its widening to 64 bits.
fn real_json(number: f32) -> Json {
    number.to_string().parse::<f64>().map_or(Json::Null, |number| json!(number))
}

/// Largest whole number that every reader of JSON keeps: 53 bits, as many as a number of JavaScript has.
const JSON_WHOLE_MAX: u64 = (1 << 53) - 1;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_and_assignments_are_split_outside_quotes_and_brackets() {
        assert_eq!(split_list("MW 10, DB1.a[1,2],\"a,b\",,"), ["MW 10", "DB1.a[1,2]", "\"a,b\""]);
        assert_eq!(split_assignment("\"a=b\" = 5").ok(), Some(("\"a=b\"", "5")));
        assert_eq!(split_assignment("MW10:=5").ok(), Some(("MW10", "5")));
        assert!(split_assignment("MW10").is_err());
    }
}
