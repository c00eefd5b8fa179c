//! Applies the fixes that diagnostics carry to the sources on the disk.

use sieben_lang::codesys_files;
use sieben_model::diagnostic::{Certainty, Fix};
use sieben_model::source::{FileId, Sources};
use sieben_workspace::finding::{Finding, Origin};
use sieben_workspace::project::Build;

use crate::failure::Failure;
use crate::rewriting;

/// What was done to the sources, as one line each: `line4.awl:3:5: wrote `:=` for `=:``.
pub(crate) fn apply(build: &Build) -> Result<Vec<String>, Failure> {
    let mut done = Vec::new();
    for source in &build.project.sources {
        let mut fixes = fixes(&build.findings, source.id);
        // In a file that holds more than Structured Text a fix changes only that.
        if let Some(read) = codesys_files::read(source.id, &source.path.to_string_lossy(), &source.decoded.text) {
            fixes.retain(|fix| is_inside(&read.text, &source.decoded.text, fix));
        }
        if fixes.is_empty() {
            continue;
        }
        let text = fixed(&source.decoded.text, &fixes);
        rewriting::write(&source.path, source, &text, source.decoded.encoding)?;
        done.extend(fixes.iter().map(|fix| line(&build.project.texts.program, fix)));
    }
    Ok(done)
}

/// Whether what a fix replaces is Structured Text of the file, and it leaves the end of a CDATA section where it is.
fn is_inside(read: &str, whole: &str, fix: &Fix) -> bool {
    let (start, end) = (fix.span.start as usize, fix.span.end as usize);
    let replaced = read.get(start..end);
    replaced.is_some_and(|text| !text.trim().is_empty()) && replaced == whole.get(start..end) && !fix.replacement.contains("]]>")
}

/// The certain fixes of a file, in the order of the text, none inside another.
fn fixes(findings: &[Finding], file: FileId) -> Vec<&Fix> {
    let of_program = findings.iter().filter(|finding| finding.origin == Origin::Program);
    let fixes = of_program.filter_map(|finding| finding.diagnostic.fix.as_ref());
    let mut fixes: Vec<&Fix> = fixes.filter(|fix| fix.certainty == Certainty::Certain && fix.span.file == file).collect();
    fixes.sort_by_key(|fix| (fix.span.start, fix.span.end));
    let mut behind = 0;
    fixes.retain(|fix| {
        // An empty place takes what is missing there.
        let free = fix.span.start >= behind && (fix.span.start < fix.span.end || !fix.replacement.is_empty());
        if free {
            behind = fix.span.end;
        }
        free
    });
    fixes
}

/// The text with its fixes; what lies between them is kept byte for byte.
fn fixed(text: &str, fixes: &[&Fix]) -> String {
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    for fix in fixes {
        let (start, end) = (fix.span.start as usize, fix.span.end as usize);
        let (Some(kept), Some(_)) = (text.get(at..start), text.get(start..end)) else { continue };
        out.push_str(kept);
        out.push_str(&fix.replacement);
        at = end;
    }
    out.push_str(&text[at..]);
    out
}

fn line(sources: &Sources, fix: &Fix) -> String {
    let (line, column) = sources.line_column(fix.span);
    let place = format!("{}:{line}:{column}", sources.file(fix.span.file).name);
    // A line end would tear the report apart.
    let shown = |text: &str| text.lines().map(str::trim).collect::<Vec<_>>().join(" ⏎ ").replace("⏎  ⏎", "⏎").trim().to_owned();
    let (right, wrong) = (shown(&fix.replacement), shown(sources.slice(fix.span)));
    match (right.as_str(), wrong.as_str()) {
        ("", _) => format!("{place}: removed `{wrong}`"),
        (_, "") => format!("{place}: wrote `{right}`"),
        _ => format!("{place}: wrote `{right}` for `{wrong}`"),
    }
}
