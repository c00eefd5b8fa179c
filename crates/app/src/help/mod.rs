//! The help of the command line in German: every sentence is put in the place of the English one before the command line is parsed.

mod german;

use clap::builder::{Str, StyledStr};
use clap::{Arg, Command};
use sieben_model::language::{Language, Text, pick};

use german::{BELOW, Row, SENTENCES, VALUES};

/// Words of clap in its errors, with ours.
const WORDS_OF_ERRORS: [Text; 4] =
    [["error:", "Fehler:"], ["Usage:", "Aufruf:"], ["For more information, try", "Mehr sagt"], ["tip:", "Tipp:"]];

/// The command line with its help in a language.
pub(crate) fn in_language(mut command: Command, language: Language) -> Command {
    match language {
        Language::English => command,
        Language::German => {
            // What clap adds, such as `--help`, is there after this.
            command.build();
            german(command)
        }
    }
}

/// What clap says about a wrong command line, with its headings in a language. The sentence itself stays English.
pub(crate) fn error_in(language: Language, text: &str) -> String {
    WORDS_OF_ERRORS.iter().fold(text.to_owned(), |text, &words| text.replacen(words[0], pick(language, words), 1))
}

fn german(command: Command) -> Command {
    let style = *command.get_styles().get_usage();
    let template = format!("{{before-help}}{{about-with-newline}}\n{style}Aufruf:{style:#} {{usage}}\n\n{{all-args}}{{after-help}}");
    let mut command = command
        .help_template(template)
        .subcommand_help_heading("Befehle")
        .subcommand_value_name("BEFEHL")
        .mut_args(argument)
        .mut_subcommands(german);
    if let Some(about) = text(command.get_about()) {
        command = command.about(sentence(SENTENCES, &about));
    }
    if let Some(after) = text(command.get_after_help()) {
        command = command.after_help(below(&after));
    }
    let usage = command.render_usage().ansi().to_string().replace("[OPTIONS]", "[OPTIONEN]");
    match usage.split_once(' ') {
        // What stands before the first space is the word for it.
        Some((_, usage)) => command.override_usage(usage.to_owned()),
        None => command,
    }
}

/// An argument with its help, the name of its value, its default and the possible values.
fn argument(argument: Arg) -> Arg {
    let heading = if argument.is_positional() { "Argumente" } else { "Optionen" };
    let mut help = help_of(&argument).map_or_else(String::new, |english| sentence(SENTENCES, &english));
    let takes_values = argument.get_action().takes_values();
    if takes_values && !argument.is_hide_default_value_set() {
        let defaults: Vec<_> = argument.get_default_values().iter().map(|value| value.to_string_lossy().into_owned()).collect();
        if !defaults.is_empty() {
            help.push_str(&format!(" [Standard: {}]", defaults.join(", ")));
        }
    }
    if takes_values && !argument.is_hide_possible_values_set() {
        let values = argument.get_possible_values();
        let values: Vec<_> = values.iter().filter(|value| !value.is_hide_set()).map(|value| value.get_name().to_owned()).collect();
        if !values.is_empty() {
            help.push_str(&format!(" [möglich: {}]", values.join(", ")));
        }
    }
    let name = |name: &Str| row(VALUES, name).map_or_else(|| name.clone(), Str::from);
    let names: Option<Vec<Str>> = argument.get_value_names().filter(|_| takes_values).map(|names| names.iter().map(name).collect());
    let mut argument =
        argument.help_heading(heading).help(help).long_help(None::<&'static str>).hide_default_value(true).hide_possible_values(true);
    if let Some(names) = names {
        argument = argument.value_names(names);
    }
    argument
}

/// What stands below the arguments, in German.
fn below(english: &str) -> String {
    let german = |piece: Piece<'_>| match piece {
        Piece::Heading(line) => sentence(BELOW, line),
        Piece::Example { left, comment } => format!("{left}{}", sentence(BELOW, comment)),
        Piece::Plain(line) => line.to_owned(),
        Piece::Paragraph(text) => sentence(BELOW, &text),
    };
    let section = |section: &str| pieces(section).into_iter().map(german).collect::<Vec<_>>().join("\n");
    english.split("\n\n").map(section).collect::<Vec<_>>().join("\n\n")
}

/// A part of what stands below the arguments.
enum Piece<'a> {
    /// A line above examples.
    Heading(&'a str),
    /// A line with a command, and what it does in the column after it.
    Example { left: &'a str, comment: &'a str },
    /// A line with a command alone.
    Plain(&'a str),
    /// A paragraph, on one line.
    Paragraph(String),
}

/// The parts of a section: a heading with its examples, or a paragraph.
fn pieces(section: &str) -> Vec<Piece<'_>> {
    let example = |line: &'_ str| line.starts_with("  ");
    let Some((heading, examples)) = section.split_once('\n').filter(|(_, rest)| rest.lines().all(example)) else {
        return vec![Piece::Paragraph(section.split_whitespace().collect::<Vec<_>>().join(" "))];
    };
    let column = |line| {
        let line: &str = line;
        match line.rfind("  ").map(|at| line.split_at(at + 2)) {
            Some((left, comment)) if !left.trim().is_empty() => Piece::Example { left, comment },
            _ => Piece::Plain(line),
        }
    };
    std::iter::once(Piece::Heading(heading)).chain(examples.lines().map(column)).collect()
}

/// The German sentence; the English one where there is none.
fn sentence(rows: &[Row], english: &str) -> String {
    row(rows, english).unwrap_or(english).to_owned()
}

fn row(rows: &[Row], english: &str) -> Option<&'static str> {
    rows.iter().find(|(key, _)| *key == english).map(|(_, german)| *german)
}

/// The help of an argument; that of `--help` says more where there is a longer form, which no verb needs.
fn help_of(argument: &Arg) -> Option<String> {
    if argument.get_id() == "help" { Some(PRINT_HELP.to_owned()) } else { text(argument.get_help()) }
}

const PRINT_HELP: &str = "Print help";

fn text(styled: Option<&StyledStr>) -> Option<String> {
    styled.map(ToString::to_string).filter(|text| !text.is_empty())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use clap::CommandFactory;

    use super::*;
    use crate::CommandLine;

    /// Everything that the help of a command and of all below it says, in English.
    struct Said {
        sentences: BTreeSet<String>,
        values: BTreeSet<String>,
        below: BTreeSet<String>,
    }

    fn said() -> Said {
        fn collect(command: &Command, said: &mut Said) {
            said.sentences.extend(text(command.get_about()));
            for argument in command.get_arguments().filter(|argument| !argument.is_hide_set()) {
                said.sentences.extend(help_of(argument));
                assert!(
                    argument.get_id() == "help" || argument.get_long_help().is_none(),
                    "{}: a help of one paragraph",
                    argument.get_id()
                );
                if argument.get_action().takes_values() {
                    said.values.extend(argument.get_value_names().unwrap_or_default().iter().map(ToString::to_string));
                }
            }
            for section in text(command.get_after_help()).iter().flat_map(|text| text.split("\n\n")) {
                said.below.extend(pieces(section).into_iter().filter_map(|piece| match piece {
                    Piece::Heading(text) | Piece::Example { comment: text, .. } => Some(text.to_owned()),
                    Piece::Paragraph(text) => Some(text),
                    Piece::Plain(_) => None,
                }));
            }
            command.get_subcommands().filter(|verb| !verb.is_hide_set()).for_each(|verb| collect(verb, said));
        }
        let mut said = Said { sentences: BTreeSet::new(), values: BTreeSet::new(), below: BTreeSet::new() };
        let mut command = CommandLine::command();
        command.build();
        collect(&command, &mut said);
        said
    }

    /// Sentences without a row, and rows without a sentence.
    fn differences(said: &BTreeSet<String>, rows: &[Row]) -> Vec<String> {
        let keys: BTreeSet<String> = rows.iter().map(|(english, _)| (*english).to_owned()).collect();
        assert_eq!(keys.len(), rows.len(), "each sentence stands once");
        said.symmetric_difference(&keys).cloned().collect()
    }

    #[test]
    fn every_sentence_of_the_help_has_a_german_row_and_every_row_a_sentence() {
        let said = said();
        assert_eq!(differences(&said.sentences, SENTENCES), [""; 0]);
        assert_eq!(differences(&said.below, BELOW), [""; 0]);
    }

    #[test]
    fn every_german_name_of_a_value_is_used() {
        let said = said();
        let unused: Vec<_> = VALUES.iter().filter(|(english, _)| !said.values.contains(*english)).collect();
        assert!(unused.is_empty(), "{unused:?}");
    }

    #[test]
    fn the_help_of_every_verb_is_german_from_end_to_end() {
        let mut command = in_language(CommandLine::command(), Language::German);
        let root = command.render_help().to_string();
        let verbs = command.get_subcommands().filter(|verb| !verb.is_hide_set() && verb.get_name() != "help");
        let helps = verbs.map(|verb| verb.clone().render_help().to_string()).chain([root]);
        for help in helps {
            for english in ["Usage:", "Options:", "Arguments:", "Commands:", "Examples:", "[default:", "[possible values:", "Print "] {
                assert!(!help.contains(english), "{english}: {help}");
            }
            assert!(help.contains("Aufruf: sieben") && help.contains("Optionen:") && help.contains("--lang <SPRACHE>"), "{help}");
        }
    }

    #[test]
    fn a_wrong_command_line_has_german_headings() {
        let command = in_language(CommandLine::command(), Language::German);
        let error = command.try_get_matches_from(["sieben", "run", "--cycel", "1s"]).expect_err("no such option");
        let text = error_in(Language::German, &error.render().to_string());
        assert!(text.starts_with("Fehler: ") && text.contains("\nAufruf: sieben run") && text.contains("Mehr sagt '--help'."), "{text}");
    }
}
