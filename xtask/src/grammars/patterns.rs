//! What all grammars are made of: rules, words as regular expressions, and the few notations that the languages share.
//!
//! Expressions are those of Oniguruma: `\w` knows umlauts, and alternatives of different length may stand in a look-behind at its top level only.

use serde_json::{Value, json};

/// A letter of a name, and what may follow it.
pub(super) const NAME: &str = r"[\p{L}_][\p{L}\p{N}_]*";
/// Before a word that is none of a longer name, of a symbol or of a path.
pub(super) const ALONE: &str = r#"(?<![\w#"$.])"#;

/// What a rule colours.
pub(super) fn rule(scope: &str, expression: &str) -> Value {
    json!({ "name": scope, "match": expression })
}

/// A rule that colours parts of what it finds.
pub(super) fn parts(expression: &str, scopes: &[(usize, &str)]) -> Value {
    let captures: serde_json::Map<String, Value> =
        scopes.iter().map(|(number, scope)| (number.to_string(), json!({ "name": scope }))).collect();
    json!({ "match": expression, "captures": captures })
}

/// What stands between a beginning and an end.
pub(super) fn region(scope: &str, begin: &str, end: &str, inner: &[Value]) -> Value {
    json!({ "name": scope, "begin": begin, "end": end, "patterns": inner })
}

/// A region whose ends are coloured by parts.
pub(super) fn region_with_parts(begin: &str, begins: &[(usize, &str)], end: &str, ends: &[(usize, &str)], inner: &[Value]) -> Value {
    let captures = |scopes: &[(usize, &str)]| {
        scopes.iter().map(|(number, scope)| (number.to_string(), json!({ "name": scope }))).collect::<serde_json::Map<String, Value>>()
    };
    json!({ "begin": begin, "beginCaptures": captures(begins), "end": end, "endCaptures": captures(ends), "patterns": inner })
}

/// What stands under this name in the repository.
pub(super) fn include(name: &str) -> Value {
    json!({ "include": format!("#{name}") })
}

/// One of these words, the longest first: what begins like another one is not taken for it.
pub(super) fn any_of<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    longest_first(words).into_iter().map(escaped).collect::<Vec<_>>().join("|")
}

/// The same for words of which some end in signs: those that end in a letter end there.
pub(super) fn any_whole<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    let guarded = |word: &str| if word.ends_with(|last: char| last.is_ascii_alphanumeric()) { r"(?!\w)" } else { "" };
    let sorted = longest_first(words);
    sorted.into_iter().map(|word| format!("{}{}", escaped(word), guarded(word))).collect::<Vec<_>>().join("|")
}

fn longest_first<'a>(words: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let mut words: Vec<&str> = words.into_iter().collect();
    words.sort_by(|a, b| b.len().cmp(&a.len()).then(a.cmp(b)));
    words.dedup();
    words
}

/// A word without the meaning that its characters have in an expression.
fn escaped(word: &str) -> String {
    let mut out = String::new();
    for character in word.chars() {
        if r"\.+*?()[]{}|^$/-".contains(character) {
            out.push('\\');
        }
        out.push(character);
    }
    out
}

/// A rule for words that stand alone, whatever their case.
pub(super) fn words<'a>(scope: &str, words: impl IntoIterator<Item = &'a str>) -> Value {
    rule(scope, &format!(r"(?i){ALONE}(?:{})\b", any_of(words)))
}

/// `// …`.
pub(super) fn line_comment(language: &str) -> Value {
    rule(&format!("comment.line.double-slash.{language}"), "//.*$")
}

/// A comment between two marks.
pub(super) fn block_comment(language: &str, begin: &str, end: &str, inner: &[Value]) -> Value {
    region(&format!("comment.block.{language}"), begin, end, inner)
}

/// `'…'`, with the escapes of STEP 7; it ends with its line.
pub(super) fn characters(language: &str) -> Value {
    let escape = rule(&format!("constant.character.escape.{language}"), r"\$(?:[$'LNPRTlnprt]|[0-9A-Fa-f]{2})|''");
    region(&format!("string.quoted.single.{language}"), "'", "'(?!')|$", &[escape])
}

/// A value with its type before it: `S5T#3S`, `W#16#FF`, `P#M 1.0 BYTE 4`, `2#1010`.
pub(super) fn typed_constant(language: &str, types: &str) -> Value {
    let pointer = r"P#(?:[A-Z]+\d*\s*\.?\s*(?:[A-Z]+\s*)?)?\d+(?:\.\d+)?(?:\s+[A-Z_]+\s+\d+)?|P##\w+";
    let expression = format!(r"(?i){ALONE}(?:{pointer}|(?:{types}|2|8|16)#(?:16#)?(?:\([\d,\s]*\)|[\w.:+-]+))");
    rule(&format!("constant.numeric.typed.{language}"), &expression)
}

/// An absolute address in either mnemonic language.
pub(super) fn address(language: &str) -> Value {
    let area =
        r"P?[IQEAML](?:[BWDX])?\s*\d+(?:\.\d+)?(?::P)?|P[IQEA][BWD]\s*\d+|D[IB][BWDX]\s*\d+(?:\.\d+)?|D[BI]\d+\.DB[BWDX]\s*\d+(?:\.\d+)?";
    rule(&format!("variable.other.address.{language}"), &format!(r"(?i){ALONE}%?(?:{area})(?![\w.])"))
}

/// An address that a register or a double word points to: `MW [MD 10]`, `W [AR1, P#0.0]`.
pub(super) fn indirect_address(language: &str) -> Value {
    rule(
        &format!("variable.other.address.{language}"),
        &format!(r"(?i){ALONE}(?:P?[IQEAML][BWDX]?|D[BI][BWDX]|[BWDTCZ]|OB|FB|FC|DB|DI)\s*(?=\[)"),
    )
}

/// A block, a timer or a counter by its number.
pub(super) fn numbered(language: &str) -> Value {
    let expression = format!(r"(?i){ALONE}%?(?:(OB|FB|FC|SFC|SFB)|(DB|DI|UDT|T|C|Z))\s*\d+\b(?!#)");
    json!({ "match": expression, "captures": {
        "0": { "patterns": [
            rule(&format!("entity.name.function.{language}"), r"(?i)%?(?:OB|FB|FC|SFC|SFB)\s*\d+"),
            rule(&format!("variable.other.address.{language}"), r".+"),
        ] },
    } })
}

/// A number.
pub(super) fn number(language: &str) -> Value {
    rule(&format!("constant.numeric.{language}"), r"(?<![\w#])\d[\d_]*(?:\.\d+)?(?:[eE][+-]?\d+)?\b")
}

/// A variable of the block.
pub(super) fn local(language: &str) -> Value {
    rule(&format!("variable.other.local.{language}"), &format!(r##"(?<!\w)#(?:{NAME}|"[^"\r\n]*")"##))
}

/// A symbol in quotation marks; it ends with its line.
pub(super) fn symbol(language: &str) -> Value {
    rule(&format!("variable.other.symbol.{language}"), r#""[^"\r\n]*(?:"|$)"#)
}
