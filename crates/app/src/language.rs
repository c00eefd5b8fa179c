//! The language that people are spoken to in: that of `--lang`, else that of the environment.

use std::ffi::OsString;
use std::ops::Range;
use std::sync::OnceLock;

use sieben_model::language::Language;

/// The variables of the environment that name it; the first one that is not empty decides.
const VARIABLES: [&str; 3] = ["LC_ALL", "LC_MESSAGES", "LANG"];

/// What was decided, after the command line was read.
static CHOICE: OnceLock<Choice> = OnceLock::new();

/// The language, and whether the command line names it.
#[derive(Clone, Copy, Debug, Default)]
struct Choice {
    spoken: Language,
    named: Option<Language>,
}

/// Keeps the language for the whole run: the one that the command line names, else the environment's.
pub(crate) fn choose(named: Option<Language>) {
    // It is read once, before any verb begins.
    let _ = CHOICE.set(Choice { spoken: named.unwrap_or_else(of_environment), named });
}

/// The language for people; English before the command line was read, and in unit tests.
pub(crate) fn spoken() -> Language {
    CHOICE.get().copied().unwrap_or_default().spoken
}

/// The language of what programs read: English, unless the command line names another one.
pub(crate) fn for_programs() -> Language {
    CHOICE.get().copied().unwrap_or_default().named.unwrap_or_default()
}

/// The language of the help, which is wanted before the command line is understood.
pub(crate) fn before_parsing(arguments: impl Iterator<Item = OsString>) -> Language {
    named_in(arguments).unwrap_or_else(of_environment)
}

/// A language of the command line.
pub(crate) fn argument(text: &str) -> Result<Language, String> {
    Language::from_code(text).ok_or_else(|| format!("`{text}` is no language of Sieben; there are en and de"))
}

fn named_in(arguments: impl Iterator<Item = OsString>) -> Option<Language> {
    let words: Vec<String> = arguments.map(|word| word.to_string_lossy().into_owned()).take_while(|word| word != "--").collect();
    Some(option(&words)?.1)
}

/// Where `--lang` stands among words with a language, and which.
pub(crate) fn option(words: &[String]) -> Option<(Range<usize>, Language)> {
    words.iter().enumerate().find_map(|(at, word)| {
        let (code, count) = match word.strip_prefix("--lang")? {
            "" => (words.get(at + 1)?.as_str(), 2),
            rest => (rest.strip_prefix('=')?, 1),
        };
        Some((at..at + count, Language::from_code(code)?))
    })
}

fn of_environment() -> Language {
    let set = VARIABLES.iter().filter_map(std::env::var_os).find(|value| !value.is_empty());
    set.map_or(Language::English, |locale| Language::of_locale(&locale.to_string_lossy()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_language_stands_anywhere_before_two_dashes() {
        let named = |line: &str| named_in(line.split(' ').map(OsString::from));
        assert_eq!(named("run --lang de --help"), Some(Language::German));
        assert_eq!(named("--lang=en run"), Some(Language::English));
        assert_eq!(named("run --language de"), None);
        assert_eq!(named("run -- --lang de"), None);
        assert_eq!(named("run --lang"), None);
        assert_eq!(named("run --lang nl"), None);
    }
}
