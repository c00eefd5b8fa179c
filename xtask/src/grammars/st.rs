//! The grammars of Structured Text and SCL, and that of data blocks and types as TIA writes them.

use serde_json::{Value, json};
use sieben_lang::st::dialect::Dialect;
use sieben_lang::st::standard::catalogue;
use sieben_lang::st::words::{self, Kind, Word};
use sieben_model::testing;
use sieben_model::types::DataType;

use super::patterns::{
    ALONE, NAME, address, any_of, block_comment, characters, include, line_comment, local, number, numbered, parts, region,
    region_with_parts, rule, symbol, typed_constant, words as alone,
};

/// Which sources a grammar is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Family {
    /// Those of a controller of the S7: SCL.
    Scl,
    /// Those of IEC 61131-3, and test files.
    St,
    /// Data blocks and types.
    Data,
}

impl Family {
    /// What its grammar is called, its scope, and what its scopes end with.
    fn names(self) -> [&'static str; 3] {
        match self {
            Self::Scl => ["SCL", "source.scl", "scl"],
            Self::St => ["Structured Text", "source.st", "st"],
            Self::Data => ["Data blocks and types of the S7", "source.s7db", "s7db"],
        }
    }

    fn has(self, word: &Word) -> bool {
        let any = |dialects: &[Dialect]| dialects.iter().any(|&dialect| word.is_of(dialect));
        match self {
            Self::Scl => any(&[Dialect::Scl, Dialect::Tia]),
            Self::St => word.of_tests || any(&Dialect::ALL),
            Self::Data => {
                any(&[Dialect::Scl, Dialect::Tia]) && matches!(word.kind, Kind::Block | Kind::Declaration | Kind::Constant | Kind::Other)
            }
        }
    }
}

/// Heads of blocks in sources of a controller.
const HEADS: &[&str] = &[
    "AUTHOR",
    "FAMILY",
    "NAME",
    "VERSION",
    "TITLE",
    "KNOW_HOW_PROTECT",
    "UNLINKED",
    "READ_ONLY",
    "NON_RETAIN",
    "STANDARD",
    "CODE_VERSION1",
    "RETAIN",
    "DB_SPECIFIC",
    "NOT_RETAIN",
    "CONSTANT",
    "PERSISTENT",
    "AT",
    "EXTENDS",
    "IMPLEMENTS",
    "ABSTRACT",
    "FINAL",
    "OVERRIDE",
    "PUBLIC",
    "PRIVATE",
    "PROTECTED",
    "INTERNAL",
];

/// The grammar.
pub(super) fn grammar(family: Family) -> Value {
    let [name, scope, language] = family.names();
    let of = |kind: Kind| words::all().filter(|word| word.kind == kind && family.has(word)).map(|word| word.word).collect::<Vec<_>>();
    let named = |part: &str| format!("{part}.{language}");
    // A name such as `floor` is free for a variable: a function is one where it is called, a block where it is a type.
    let standard = any_of(catalogue::names().filter(|name| name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')));
    let modifiers = any_of(MODIFIERS.iter().copied());
    let mut patterns = vec![
        include("comments"),
        parts(
            r"(?i)^\s*(TITLE)\s*(=)(.*)$",
            &[(1, &named("keyword.other.head")), (2, &named("keyword.operator.assignment")), (3, &named("string.unquoted.title"))],
        ),
        rule(&named("constant.other.attributes"), r"\{[^}\r\n]*\}?"),
        characters(language),
    ];
    if family == Family::St {
        // A name in a test file of any dialect, and the value of a WSTRING.
        patterns.push(parts(
            r#"(?i)(?<![\w#"$.])(TEST)\s+('[^'\r\n]*'|"[^"\r\n]*")"#,
            &[(1, &named("keyword.control.block")), (2, &named("string.quoted entity.name.function.test"))],
        ));
    }
    patterns.extend([local(language), symbol(language), rule(&named("variable.other"), r"`[^`\r\n]*`")]);
    patterns.extend([
        parts(
            &format!(
                r#"(?i){ALONE}({})\b(?:\s+(?:{modifiers}))*\s+((?:OB|FB|FC|DB|UDT|SFB|SFC)\s*\d+|"[^"\r\n]*"|(?!(?:{modifiers})\b){NAME})"#,
                begins(&of(Kind::Block))
            ),
            &[(1, &named("keyword.control.block")), (2, &named("entity.name.function"))],
        ),
        alone(&named("keyword.control.block"), of(Kind::Block)),
        alone(
            &named("keyword.other.declaration"),
            of(Kind::Declaration).into_iter().chain(["ARRAY", "REF_TO", "REFERENCE TO", "POINTER TO"]),
        ),
    ]);
    if family != Family::Data {
        patterns.extend([
            region_of_region(language),
            alone(&named("keyword.control"), of(Kind::Control)),
            alone(&named("keyword.operator.word"), of(Kind::Operator)),
            rule(&named("support.function"), &format!(r"(?i){ALONE}(?:{standard})(?=\s*\()")),
            parts(&format!(r"(?i):\s*({standard})\b(?!\s*[.(])"), &[(1, &named("support.type"))]),
            rule(&named("support.function.conversion"), &format!(r"(?i){ALONE}(?:\w+_)?TO_\w+(?=\s*\()")),
        ]);
    }
    if family == Family::St {
        patterns.push(alone(&named("support.function.test"), testing::Word::ALL.iter().map(|word| word.text()).chain(["RETURNS"])));
    }
    patterns.extend([
        alone(&named("constant.language"), of(Kind::Constant)),
        alone(&named("variable.language"), of(Kind::Other).into_iter().filter(|word| *word != "ARRAY").chain(["OF"])),
        alone(&named("keyword.other.head"), HEADS.iter().copied()),
        typed_constant(
            language,
            &any_of(DataType::all_words().chain(["S5T", "T", "LT", "D", "LD", "TOD", "LTOD", "DT", "LDT", "C", "B", "W", "DW", "DI", "L"])),
        ),
        alone(&named("support.type"), DataType::all_words()),
        address(language),
        rule(&named("variable.other.address"), r"%[A-Za-z]+\d*(?:[.:]\w+)*"),
        numbered(language),
        rule(&named("constant.other.enumeration"), &format!(r"(?<![\w#]){NAME}#{NAME}")),
        number(language),
        // On a line of its own a parameter is one if the line does not end the statement.
        rule(
            &named("variable.parameter"),
            &format!(r"(?<=[(,]|\(\s|,\s)\s*{NAME}(?=\s*(?::=|=>))|{NAME}(?=\s*=>)|^\s*{NAME}(?=\s*:=[^;]*,\s*(?://.*)?$)"),
        ),
        rule(&named("variable.other.declaration"), &format!(r"{NAME}(?=\s*(?:\{{[^}}\r\n]*\}}\s*)?:(?!=))")),
        rule(&named("entity.name.function"), &format!(r"{ALONE}{NAME}(?=\s*\()")),
        rule(&named("keyword.operator.assignment"), r":=|=>|\?=|[-+*/]=(?!=)"),
        rule(&named("keyword.operator"), r"<>|<=|>=|\*\*|[-+*/=<>&^]"),
    ]);
    json!({
        "name": name,
        "scopeName": scope,
        "patterns": patterns,
        "repository": { "comments": { "patterns": comments(language) } },
    })
}

/// What may stand between the word that begins a block and its name.
const MODIFIERS: &[&str] = &["ABSTRACT", "FINAL", "PUBLIC", "PRIVATE", "PROTECTED", "INTERNAL", "OVERRIDE"];

/// The words of blocks that do not end one.
fn begins(all: &[&'static str]) -> String {
    any_of(all.iter().copied().filter(|word| !word.starts_with("END_") && !matches!(*word, "BEGIN" | "SETUP" | "TEARDOWN" | "TEST")))
}

/// `REGION title`: what follows the word is a name and no code.
fn region_of_region(language: &str) -> Value {
    let named = |part: &str| format!("{part}.{language}");
    parts(r"(?i)^\s*(REGION)\b(?!\s*[:=.(])(.*)$", &[(1, &named("keyword.control")), (2, &named("entity.name.section"))])
}

/// Comments of all dialects; those of codesys may hold others.
fn comments(language: &str) -> Vec<Value> {
    let nested = region(&format!("comment.block.{language}"), r"\(\*", r"\*\)", &[]);
    vec![
        line_comment(language),
        block_comment(language, r"\(\*", r"\*\)", &[nested]),
        region_with_parts(
            r"/\*",
            &[(0, &format!("comment.block.{language}"))],
            r"\*/",
            &[(0, &format!("comment.block.{language}"))],
            &[rule(&format!("comment.block.{language}"), ".+?(?=\\*/|$)")],
        ),
    ]
}
