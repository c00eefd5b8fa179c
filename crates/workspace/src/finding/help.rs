//! What a finding says about what is wrong and what to do.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::language::Language;
use sieben_model::problems::Problem;

use crate::refusal::capitalized;

/// What to do, if that is more than the message and the title of the fix say already.
pub fn help_of(diagnostic: &Diagnostic) -> Option<String> {
    let help = diagnostic.help.as_deref().unwrap_or(diagnostic.problem.help());
    let said = diagnostic.fix.as_ref().map_or(diagnostic.message.clone(), |fix| format!("{} {}", diagnostic.message, fix.title));
    let refers = diagnostic.fix.is_some() && help.ends_with("the message names.");
    (!refers && !repeats(help, &said)).then(|| capitalized(help))
}

/// What is wrong: the sentence about it, in German after what the table of problems says.
pub fn said_in(language: Language, problem: Problem, message: &str) -> String {
    match language {
        Language::English => message.to_owned(),
        Language::German => format!("{}: {message}", problem.title_in(language)),
    }
}

/// What to do, if there is more to say: in German what the table of problems says, then what is more specific, on a line of its own.
pub fn help_in(language: Language, diagnostic: &Diagnostic) -> Option<String> {
    match language {
        Language::English => help_of(diagnostic),
        Language::German if help_of(diagnostic).is_none() => None,
        Language::German => Some(german_help(diagnostic.problem, diagnostic.help.as_deref())),
    }
}

/// What to do in German: what the table of problems says, then what is more specific, on a line of its own.
pub fn german_help(problem: Problem, specific: Option<&str>) -> String {
    let help = problem.help_in(Language::German);
    specific.map_or_else(|| help.to_owned(), |specific| format!("{help}\n{}", capitalized(specific)))
}

/// Words of a help that tell nothing by themselves.
const EMPTY_WORDS: [&str; 29] = [
    "write", "use", "give", "name", "names", "named", "what", "that", "this", "the", "a", "an", "it", "its", "is", "are", "of", "or",
    "and", "in", "to", "with", "for", "here", "message", "instead", "did", "you", "mean",
];

/// Whether a help says nothing that was not said already: each of its words that tell something was.
fn repeats(help: &str, said: &str) -> bool {
    let words = |text: &str| -> Vec<String> {
        let pieces = text.split(|c: char| c.is_whitespace() || matches!(c, '`' | ',' | '.' | ';' | '?' | '"'));
        pieces.filter(|piece| !piece.is_empty()).map(str::to_lowercase).collect()
    };
    let said = words(said);
    // A sign such as `;` tells something, although no word is left of it.
    let has_signs = help.split('`').skip(1).step_by(2).any(|quoted| words(quoted).is_empty());
    !has_signs && words(help).iter().all(|word| EMPTY_WORDS.contains(&word.as_str()) || said.contains(word))
}
