//! Changes that are offered: fixes of what is wrong, all certain fixes of a text, and what `ide::editing` offers.

use lsp_types::Range;
use serde_json::{Value, json};
use sieben_ide::editing::actions::{Kind, actions as offered};
use sieben_model::diagnostic::{Certainty, Fix};
use sieben_workspace::finding::Origin;

use super::naming::{Asked, workspace_edit};
use super::server::Server;
use super::work::Answer;

/// The kind of the action that applies all certain fixes.
const FIX_ALL: &str = "source.fixAll.sieben";

/// The changes for a range; `only` are the kinds that are asked for, `given` the diagnostics that the client shows there.
pub(super) fn actions(server: &mut Server, uri: &str, range: Range, only: &[String], given: &[Value]) -> Answer {
    let (place, document) = server.document(uri)?;
    if document.is_lossy {
        return Ok(Value::Array(Vec::new()));
    }
    let is_wanted = |kind: &str| only.is_empty() || only.iter().any(|only| kind == only || kind.starts_with(&format!("{only}.")));
    server.renew();
    let fixes: Vec<(Fix, u32, u32, &'static str)> = match server.folders.program_of(&place) {
        None => Vec::new(),
        Some((program, file)) => {
            let of_file = program.findings().iter().filter(|finding| finding.origin == Origin::Program);
            let with_fix = of_file.filter_map(|finding| Some((finding.diagnostic.fix.clone()?, &finding.diagnostic)));
            let here = with_fix.filter(|(fix, diagnostic)| fix.span.file == file && diagnostic.span.file == file);
            here.map(|(fix, one)| (fix, one.span.start, one.span.end, one.problem.code())).collect()
        }
    };
    let (_, document) = server.document(uri)?;
    let (start, end) = (server.byte(document, range.start), server.byte(document, range.end));
    let edit = |fixes: &[&Fix]| {
        let edits = fixes.iter().map(
            |fix| json!({ "range": server.range(document, fix.span.start as usize, fix.span.end as usize), "newText": fix.replacement }),
        );
        workspace_edit(server, std::iter::once((document.uri.clone(), Some(document.version), edits.collect())))
    };
    let mut shown = Vec::new();
    for (fix, first, last, code) in fixes.iter().filter(|_| is_wanted("quickfix")) {
        if (*first as usize) > end || (*last as usize) < start {
            continue;
        }
        let of: Vec<&Value> = given.iter().filter(|diagnostic| diagnostic.get("code").is_some_and(|given| given == code)).collect();
        shown.push(json!({
            "title": capital(&fix.title), "kind": "quickfix", "isPreferred": fix.certainty == Certainty::Certain,
            "diagnostics": of, "edit": edit(&[fix]),
        }));
    }
    // The same order and choice as `sieben check --fix`.
    let mut certain: Vec<&Fix> = fixes.iter().map(|(fix, ..)| fix).filter(|fix| fix.certainty == Certainty::Certain).collect();
    certain.sort_by_key(|fix| (fix.span.start, fix.span.end));
    let mut after = 0;
    certain.retain(|fix| {
        let free = fix.span.start >= after && (fix.span.start < fix.span.end || !fix.replacement.is_empty());
        if free {
            after = fix.span.end;
        }
        free
    });
    if !certain.is_empty() && is_wanted(FIX_ALL) {
        shown.push(json!({ "title": "Fix all that can mean only one thing", "kind": FIX_ALL, "edit": edit(&certain) }));
    }
    if let Some(asked) = Asked::of(server, uri)? {
        for action in offered(&asked.snapshot, asked.text, asked.bytes(range)) {
            let kind = match action.kind {
                Kind::QuickFix => "quickfix",
                Kind::Extract => "refactor.extract",
                Kind::Rewrite => "refactor.rewrite",
            };
            if !is_wanted(kind) {
                continue;
            }
            let mut one = json!({ "title": action.title, "kind": kind });
            match action.disabled {
                Some(_) if !server.client.disabled_actions => continue,
                Some(reason) => one["disabled"] = json!({ "reason": reason }),
                None => one["edit"] = asked.edit(server, &action.edits),
            }
            shown.push(one);
        }
    }
    Ok(shown.into())
}

/// A text with its first letter as at the beginning of a sentence.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
