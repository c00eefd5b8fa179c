//! `sieben fmt`.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::FileId;

/// T.
pub fn format(text: &str, mnemonics: Option<Mnemonics>) -> Result<String, Vec<Diagnostic>> {
    let _ = (super::parser::parse(FileId::default(), text, mnemonics), super::convert::stops_rewriting);
    Ok(text.to_owned())
}
