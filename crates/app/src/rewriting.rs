//! Sources that are written anew: same file, same encoding, same line ends, nothing lost.

use std::borrow::Cow;
use std::fs;
use std::path::{Path, PathBuf};

use sieben_lang::codesys_files;
use sieben_lang::encoding::{self, Encoding};
use sieben_lang::language::Language;
use sieben_lang::stl::heads;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};
use sieben_workspace::finding::{self, Finding};
use sieben_workspace::project::{Project, SourceFile};

use crate::failure::{Exit, Failure};
use crate::project;
use crate::report;
use crate::{files, output};

/// What to do with the new text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Destination {
    /// Print it.
    Print,
    /// Replace the file.
    InPlace,
    /// Write it to another file.
    File(PathBuf),
    /// Only say whether it differs.
    Check,
}

/// A rewriting of sources.
pub(crate) struct Rewriting {
    /// Where the new text goes.
    pub(crate) destination: Destination,
    /// Write UTF-8 instead of the encoding of the file.
    pub(crate) utf8: bool,
    /// The encoding that the user chose for the files.
    pub(crate) encoding: Option<Encoding>,
    /// What happened to a file, for messages: `formatted`.
    pub(crate) done: &'static str,
}

impl Rewriting {
    /// Rewrites all sources that the paths name. A source that cannot be understood stays as it is, and the others are still done.
    pub(crate) fn run(
        &self,
        paths: &[PathBuf],
        rewrite: impl Fn(&Project, &SourceFile) -> Result<String, Vec<Diagnostic>>,
    ) -> Result<Exit, Failure> {
        let mut project = project::load_files(paths, self.encoding)?;
        if project.sources.len() > 1 && matches!(self.destination, Destination::Print | Destination::File(_)) {
            let message = format!("{} sources cannot go into one place", project.sources.len());
            return Err(Failure::usage(Problem::P7001, message).help("give one file, or `--write` to replace each of them"));
        }
        let mut findings = std::mem::take(&mut project.findings);
        let mut differing = false;
        for source in &project.sources {
            if codesys_files::kind(&source.path.to_string_lossy(), &source.decoded.text).is_some() {
                let message = "this file of CODESYS or TwinCAT holds more than the text of a source; it is left alone";
                findings.push(Finding::program(Diagnostic::new(Problem::P6080, Span::new(source.id, 0, 0), message)));
                continue;
            }
            match rewrite(&project, source) {
                Ok(text) => differing |= self.finish(source, &text)?,
                Err(diagnostics) => {
                    findings.extend(diagnostics.into_iter().map(|diagnostic| Finding::program(in_file(diagnostic, source.id))))
                }
            }
        }
        finding::sort(&mut findings);
        if !findings.is_empty() {
            report::print(&findings, &project.texts, false);
        }
        Ok(match () {
            () if finding::has_errors(&findings) => Exit::DoesNotCompile,
            () if differing && self.destination == Destination::Check => Exit::CheckFailed,
            () => Exit::Success,
        })
    }

    /// Puts the new text of one source where it belongs; whether it differs from the old one.
    pub(crate) fn finish(&self, source: &SourceFile, text: &str) -> Result<bool, Failure> {
        let path = &source.path;
        let old = &source.decoded;
        let encoding = if self.utf8 { Encoding::Utf8 } else { old.encoding };
        let differs = *text != old.text || encoding != old.encoding;
        match &self.destination {
            Destination::Check if differs => output::print(&format!("{} would be {}\n", path.display(), self.done))?,
            Destination::Check => {}
            Destination::Print => output::print_data(text)?,
            Destination::InPlace if !differs => {}
            Destination::InPlace => {
                write(path, source, text, encoding)?;
                output::print(&format!("{} {}\n", path.display(), self.done))?;
            }
            Destination::File(target) => write(target, source, &in_file_called(target, source, text)?, encoding)?,
        }
        Ok(differs)
    }
}

/// The text for a file whose ending may say that networks are written otherwise than in the source: then each network says it itself.
fn in_file_called<'t>(target: &Path, source: &SourceFile, text: &'t str) -> Result<Cow<'t, str>, Failure> {
    let (own, other) = (source.language(None), Language::of(&target.to_string_lossy(), text, None));
    match (own.dialect(), other.dialect()) {
        (None, None) if own.drawing() != other.drawing() => Ok(heads::with_words(text, own.drawing()).into()),
        (None, Some(_)) => {
            let message = format!("`{}` would be read as Structured Text, and the source is STL, LAD or FBD", target.display());
            Err(Failure::usage(Problem::P7001, message).help("give a file that ends in `.awl`, `.lad` or `.fbd`"))
        }
        _ => Ok(text.into()),
    }
}

/// Writes the new text of a source to a file as a whole, unless something would be lost or someone else has changed the file.
pub(crate) fn write(target: &Path, source: &SourceFile, text: &str, encoding: Encoding) -> Result<(), Failure> {
    let shown = source.path.display();
    if source.embedded {
        let message = format!("`{shown}` holds this source inside; it is not ours to write");
        return Err(Failure::usage(Problem::P6046, message));
    }
    if source.decoded.had_errors {
        let message = format!("`{shown}` holds bytes that mean nothing in {}; rewriting would lose them", source.decoded.encoding.name());
        return Err(Failure::usage(Problem::P1102, message));
    }
    let bytes = encoding::encode(text, encoding).map_err(|unencodable| {
        Failure::usage(Problem::P1103, format!("`{shown}` cannot be written: {unencodable}")).help("use `--utf8`")
    })?;
    // Between reading and writing someone may have saved the file in an editor.
    let current = fs::read(target).ok().filter(|_| target == source.path);
    if current.is_some_and(|current| encoding::decode_as(&current, source.decoded.encoding).text != source.decoded.text) {
        return Err(Failure::usage(Problem::P6013, format!("`{shown}` was changed by someone else in the meantime; it is left alone")));
    }
    files::write_whole(target, &bytes)
}

/// A diagnostic of a text that was looked at alone, in its place among the texts of the project.
fn in_file(mut diagnostic: Diagnostic, file: FileId) -> Diagnostic {
    diagnostic.span.file = file;
    if let Some(fix) = &mut diagnostic.fix {
        fix.span.file = file;
    }
    diagnostic.related.iter_mut().for_each(|(span, _)| span.file = file);
    diagnostic
}
