//! Exports of CoDeSys 2.3: blocks one after another, with what the tool keeps about them in comments, and sections that are no program.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};

use super::{Read, View};

/// Comments that only exports have.
const SIGNS: [&str; 4] = ["(* @NESTEDCOMMENTS", "(* @END_DECLARATION", "(* @OBJECTFLAGS", "(* @GLOBAL_VARIABLE_LIST"];
/// Sections of a project that are no program, by the words of their first and last lines.
const SECTIONS: [(&str, &str); 5] = [
    ("LIBRARY", "END_LIBRARY"),
    ("PLC_CONFIGURATION", "PLC_END"),
    ("RESOURCE", "END_RESOURCE"),
    ("VISUALISATION", "END_VISUALISATION"),
    ("_ALARMCONFIG", "_ALARMCONFIGEND"),
];
/// Words that begin a block or an action.
const BLOCKS: [&str; 4] = ["PROGRAM", "FUNCTION_BLOCK", "FUNCTION", "ACTION"];
/// Words that end a diagram.
const ENDS: [&str; 5] = ["ACTION", "END_ACTION", "END_PROGRAM", "END_FUNCTION_BLOCK", "END_FUNCTION"];

/// Whether a text is an export.
pub(super) fn is_export(text: &str) -> bool {
    SIGNS.iter().any(|sign| text.contains(sign))
}

/// What a line belongs to.
enum Inside {
    /// The program.
    Program,
    /// A section that is none, up to this word.
    Section(&'static str),
    /// A diagram.
    Diagram,
}

/// Reads an export: what is no Structured Text becomes spaces.
pub(super) fn read(file: FileId, text: &str) -> Read {
    let mut view = View::blank(text);
    let mut diagnostics = Vec::new();
    let (mut inside, mut block, mut comment, mut at) = (Inside::Program, String::new(), false, 0);
    for line in text.split_inclusive('\n') {
        let range = at..at + line.len();
        at = range.end;
        let word: String = line.trim_start().chars().take_while(|&c| c.is_ascii_alphanumeric() || c == '_').collect();
        let word = if comment { String::new() } else { word.to_ascii_uppercase() };
        match inside {
            Inside::Section(end) if word == end => {
                inside = Inside::Program;
                continue;
            }
            Inside::Section(_) => continue,
            Inside::Diagram if ENDS.contains(&word.as_str()) => inside = Inside::Program,
            Inside::Diagram => continue,
            Inside::Program => {}
        }
        if let Some(&(_, end)) = SECTIONS.iter().find(|(begin, _)| *begin == word).filter(|_| block.is_empty()) {
            inside = Inside::Section(end);
            continue;
        }
        if word.starts_with('_') && word.ends_with("_BODY") && line.trim().len() == word.len() {
            let start = range.start + line.len() - line.trim_start().len();
            let message = format!("the body of `{block}` is a diagram (`{word}`), and only Structured Text is read");
            diagnostics.push(Diagnostic::new(Problem::P6078, Span::new(file, start as u32, (start + word.len()) as u32), message));
            inside = Inside::Diagram;
            continue;
        }
        if BLOCKS.contains(&word.as_str()) {
            let rest = line.trim_start()[word.len()..].trim_start();
            block = rest.chars().take_while(|&c| c.is_alphanumeric() || c == '_').collect();
        } else if word.starts_with("END_") && ENDS.contains(&word.as_str()) && word != "END_ACTION" {
            block.clear();
        }
        comment = ends_in_comment(line, comment);
        view.keep(text, range);
    }
    Read { text: view.finish(), diagnostics }
}

/// Whether a line ends inside a comment.
pub(crate) fn ends_in_comment(line: &str, mut inside: bool) -> bool {
    let mut rest = line;
    while let Some(at) = rest.find(if inside { "*)" } else { "(*" }) {
        rest = &rest[at + 2..];
        inside = !inside;
    }
    inside
}
