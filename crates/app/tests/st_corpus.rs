//! The corpus of ST sources as they are found in the wild, one folder for each dialect: all are read without an error, come back
//! byte for byte, keep their layout when they are formatted twice, and survive the loss of any one of their tokens.

use std::fs;
use std::path::Path;

use sieben_lang::encoding;
use sieben_lang::st::syntax::SyntaxKind;
use sieben_lang::st::{self, Dialect};
use sieben_model::diagnostic::Severity;
use sieben_model::source::FileId;

/// Most messages that a lost token may have, but in one of a hundred cases.
const MESSAGES_MAX: usize = 3;

struct Case {
    name: String,
    dialect: Dialect,
    text: String,
}

fn cases() -> Vec<Case> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut cases = Vec::new();
    let corpus = Dialect::ALL.map(|dialect| (dialect, root.join("spec/corpus/st").join(dialect.name())));
    for (dialect, folder) in corpus {
        let mut paths: Vec<_> = fs::read_dir(&folder).expect("the corpus is there").map(|file| file.expect("a file").path()).collect();
        paths.sort();
        for path in paths.iter().filter(|path| path.extension().is_some_and(|ending| ending != "txt")) {
            let bytes = fs::read(path).expect("a source can be read");
            let text = encoding::read_source(&bytes).expect("a source is a text").text;
            let name = format!("{}/{}", dialect.name(), path.file_name().expect("a name").to_string_lossy());
            assert!(path.with_extension("txt").exists(), "{name} has no text that says what is odd");
            cases.push(Case { name, dialect, text });
        }
    }
    cases
}

#[test]
fn every_source_is_read_without_an_error() {
    let cases = cases();
    let mut failures = Vec::new();
    for Case { name, dialect, text } in &cases {
        let parsed = st::parse(FileId::default(), text, *dialect);
        for diagnostic in parsed.diagnostics.iter().filter(|diagnostic| diagnostic.severity() == Severity::Error) {
            let line = text[..diagnostic.span.start as usize].lines().count();
            failures.push(format!("{name}:{line}: {} {}", diagnostic.problem.code(), diagnostic.message));
        }
        if parsed.file.items.is_empty() {
            failures.push(format!("{name}: nothing was understood"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(cases.len() >= 40, "{} sources", cases.len());
}

#[test]
fn every_source_keeps_its_tokens_and_its_layout_when_it_is_formatted() {
    for Case { name, dialect, text } in cases() {
        st::fuzz(text.as_bytes());
        let formatted = st::format(&text, dialect).unwrap_or_else(|errors| panic!("{name}: {errors:?}"));
        let parsed = st::parse(FileId::default(), &formatted, dialect);
        assert!(parsed.diagnostics.iter().all(|diagnostic| diagnostic.severity() != Severity::Error), "{name}: {formatted}");
    }
}

#[test]
fn a_lost_token_has_few_messages() {
    let mut counts: Vec<(usize, String)> = Vec::new();
    for Case { name, dialect, text } in cases() {
        let tree = st::parse(FileId::default(), &text, dialect).syntax(&text);
        for token in tree.descendants_with_tokens().filter_map(|element| element.into_token()) {
            if token.kind() <= SyntaxKind::Inactive {
                continue;
            }
            let range = token.text_range();
            let (start, end) = (usize::from(range.start()), usize::from(range.end()));
            let rest = format!("{} {}", &text[..start], &text[end..]);
            let parsed = st::parse(FileId::default(), &rest, dialect);
            let errors: Vec<_> = parsed.diagnostics.iter().filter(|diagnostic| diagnostic.severity() == Severity::Error).collect();
            let codes: Vec<&str> = errors.iter().map(|diagnostic| diagnostic.problem.code()).collect();
            let line = text[..start].lines().count();
            counts.push((errors.len(), format!("{name}:{line} without `{}`: {}", token.text(), codes.join(" "))));
            // Cut off before it.
            st::parse(FileId::default(), &text[..start], dialect);
        }
    }
    counts.sort();
    let share = |part: usize| &counts[counts.len() * part / 100];
    let worst: Vec<&str> = counts.iter().rev().take(40).map(|(_, which)| which.as_str()).collect();
    assert!(counts.len() > 2_500, "{} tokens", counts.len());
    assert!(share(50).0 <= 1, "the median is {}\n{}", share(50).0, worst.join("\n"));
    assert!(share(99).0 <= MESSAGES_MAX, "one of a hundred has more than {MESSAGES_MAX} messages\n{}", worst.join("\n"));
}
