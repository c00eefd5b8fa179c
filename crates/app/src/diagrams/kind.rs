//! What a file of diagrams is written as, by its ending.

use std::path::Path;

use sieben_model::problems::Problem;

use crate::failure::Failure;
use crate::{files, output};

/// What a file is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Svg,
    Html,
    Text,
}

/// The endings that are known.
const ENDINGS: [(&str, Kind); 4] = [("svg", Kind::Svg), ("html", Kind::Html), ("htm", Kind::Html), ("txt", Kind::Text)];

impl Kind {
    /// What a file is written as by its ending; `-` is standard output, as text.
    pub(crate) fn of(path: &Path) -> Result<Self, Failure> {
        if path.as_os_str() == "-" {
            return Ok(Self::Text);
        }
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let known = ENDINGS.iter().find(|(known, _)| ending.eq_ignore_ascii_case(known));
        known.map(|(_, kind)| *kind).ok_or_else(|| {
            let message = match ending {
                "" => format!("`{}` has no ending that says what to draw; there are `.svg`, `.html` and `.txt`", path.display()),
                _ => format!("`.{ending}` is nothing that a diagram is written as; there are `.svg`, `.html` and `.txt`"),
            };
            Failure::usage(Problem::P7081, message)
        })
    }
}

/// Writes what was drawn; `-` is standard output.
pub(crate) fn put(path: &Path, text: &str) -> Result<(), Failure> {
    if path.as_os_str() == "-" {
        return output::print(text);
    }
    files::write_whole(path, text.as_bytes())
}
