//! Fences of Markdown whose language is one of ours.

use serde_json::{Value, json};

/// Words after the three backticks, and the grammar of what stands between them.
const FENCES: &[(&str, &str)] = &[
    ("stl|awl", "source.awl"),
    ("lad|fbd", "source.lad"),
    ("scl", "source.scl"),
    ("st|iecst|test", "source.st"),
    ("s7db|s7udt", "source.s7db"),
];

/// A grammar that is injected into that of Markdown.
pub(super) fn grammar() -> Value {
    let fence = |(words, scope): &(&str, &str)| {
        json!({
            "name": "markup.fenced_code.block.markdown",
            "begin": format!(r"(^|\G)(\s*)(`{{3,}}|~{{3,}})\s*(?i:({words})((\s+|[{{:,?])[^`]*)?$)"),
            "beginCaptures": {
                "3": { "name": "punctuation.definition.markdown" },
                "4": { "name": "fenced_code.block.language.markdown" },
                "5": { "name": "fenced_code.block.language.attributes.markdown" },
            },
            "end": r"(^|\G)(\2|\s{0,3})(\3)\s*$",
            "endCaptures": { "3": { "name": "punctuation.definition.markdown" } },
            "patterns": [{ "begin": r"(^|\G)(\s*)(.*)", "while": r"(^|\G)(?!\s*([`~]{3,})\s*$)", "contentName": format!("meta.embedded.block.{}", scope.trim_start_matches("source.")), "patterns": [{ "include": scope }] }],
        })
    };
    json!({
        "name": "Fences of Markdown with sources of an S7",
        "scopeName": "markdown.sieben.codeblock",
        "injectionSelector": "L:text.html.markdown",
        "patterns": FENCES.iter().map(fence).collect::<Vec<_>>(),
    })
}
