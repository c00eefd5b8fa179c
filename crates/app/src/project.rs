//! From the paths of the command line to the texts of a project.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use sieben_lang::awlsim_project::{Content, Source};
use sieben_lang::encoding::{self, Encoding};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::nearest::nearest;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_workspace::finding::Finding;
use sieben_workspace::project::Project;
use sieben_workspace::settings::{self, Placed, Settings};

use crate::failure::Failure;
use crate::files;
use crate::glob::Pattern;
use crate::paths::{
    FAILURES, Listing, folder_of, is_awlsim_project, is_scenario, is_source, is_symbols, is_test, join, leaves_folder, shown, slashed,
};
use crate::programs::{self, Folder, Kind, is_symbols_by_default};

/// Reads the files and folders that the command line names; none = the current folder. `encoding` is what the user chose for
/// the files without a byte order mark; none = guessed from each.
pub(crate) fn load(paths: &[PathBuf], encoding: Option<Encoding>) -> Result<Project, Failure> {
    Reading::new(encoding, Several::Refused).read(paths)
}

/// The same for what is done with each source by itself: all programs of a folder may be among them.
pub(crate) fn load_files(paths: &[PathBuf], encoding: Option<Encoding>) -> Result<Project, Failure> {
    Reading::new(encoding, Several::Files).read(paths)
}

/// What a folder with several programs is to whoever reads it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Several {
    /// A mistake: one program is wanted.
    Refused,
    /// Files, each for itself.
    Files,
}

/// A project that is being read.
struct Reading {
    project: Project,
    several: Several,
    /// The files that were read, or told that they cannot be.
    seen: BTreeSet<PathBuf>,
}

impl Reading {
    fn new(encoding: Option<Encoding>, several: Several) -> Self {
        Self { project: Project::new(encoding), several, seen: BTreeSet::new() }
    }

    fn read(mut self, paths: &[PathBuf]) -> Result<Project, Failure> {
        let here = [PathBuf::from(".")];
        let paths = if paths.is_empty() { &here } else { paths };
        for path in paths {
            let is_project_file = path.file_name().is_some_and(|name| name == settings::FILE_NAME);
            if is_project_file {
                self.folder(folder_of(path))?;
            } else if path.is_dir() {
                self.folder(path)?;
            } else if is_awlsim_project(path) {
                self.awlsim_project(path)?;
            } else if is_symbols(path) {
                self.symbol_table(path)?;
            } else {
                self.source(path)?;
            }
        }
        self.project.require_text(paths);
        Ok(self.project)
    }

    fn source(&mut self, path: &Path) -> Result<(), Failure> {
        if self.is_new(path) {
            self.project.add_source(path, &files::read(path)?);
        }
        Ok(())
    }

    fn symbol_table(&mut self, path: &Path) -> Result<(), Failure> {
        if self.is_new(path) {
            self.project.add_symbols(path, &files::read(path)?)?;
        }
        Ok(())
    }

    /// Whether a file was not named before; a file named twice is read once.
    fn is_new(&mut self, path: &Path) -> bool {
        self.seen.insert(fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf()))
    }

    fn folder(&mut self, folder: &Path) -> Result<(), Failure> {
        let project_file = join(folder, Path::new(settings::FILE_NAME));
        let has_settings = project_file.is_file();
        if has_settings {
            self.project.home = Some(folder.to_path_buf());
            self.project.add_settings(&project_file, &files::read(&project_file)?);
        }
        let listing = Listing::of(folder)?;
        // A project of awlsim that is alone in its folder is what the folder means, unless a `sieben.toml` says otherwise.
        let others: Vec<&PathBuf> = listing.files.iter().filter(|file| is_awlsim_project(file)).collect();
        if let ([other], false) = (others.as_slice(), has_settings) {
            return self.awlsim_project(&join(folder, other));
        }
        if self.several == Several::Refused
            && let Some(found) = Folder::of(folder, self.project.encoding)?
        {
            if found.has_several() {
                return Err(found.too_many());
            }
            if let Some(program) = found.programs.first().filter(|program| program.kind == Kind::Project) {
                return self.folder(&program.paths[0]);
            }
        }
        if !has_settings {
            self.project.settings = Settings::default();
        }
        let Settings { symbols: symbol_patterns, sources: source_patterns, tests: test_patterns, .. } = self.project.settings.clone();
        let mut symbols = self.chosen(&listing, symbol_patterns.as_deref(), is_symbols_by_default);
        let mut sources = self.chosen(&listing, source_patterns.as_deref(), is_source);
        let mut tests = match &test_patterns {
            Some(tests) => {
                let mut chosen = self.chosen(&listing, Some(tests), |_| false);
                // What a campaign has found is a test from then on.
                let found = listing.files.iter().filter(|file| file.starts_with(FAILURES) && is_scenario(file));
                let found: Vec<PathBuf> = found.filter(|file| !chosen.contains(file)).cloned().collect();
                chosen.extend(found);
                chosen
            }
            None => listing.files.iter().filter(|file| is_test(file) || is_scenario(file)).cloned().collect(),
        };
        // Tests are known by their text, too.
        let (by_text, others): (Vec<PathBuf>, Vec<PathBuf>) = sources
            .into_iter()
            .filter(|source| !tests.contains(source) && !is_test(source))
            .partition(|source| programs::is_test(&join(folder, source), self.project.encoding));
        sources = others;
        if test_patterns.is_none() {
            tests.extend(by_text);
            tests.sort();
        }
        self.project.tests.extend(tests.iter().map(|test| join(folder, test)));
        // `.asc` also ends the names of signatures: without a program there is nothing that they could name.
        if sources.is_empty() && symbol_patterns.is_none() {
            symbols.clear();
        }
        for relative in symbols {
            self.symbol_table(&join(folder, &relative))?;
        }
        for relative in sources {
            self.source(&join(folder, &relative))?;
        }
        Ok(())
    }

    /// The files that match the patterns, in the order of the patterns, then by path; without patterns those of the default.
    fn chosen(&mut self, listing: &Listing<'_>, patterns: Option<&[Placed]>, default: impl Fn(&Path) -> bool) -> Vec<PathBuf> {
        let Some(patterns) = patterns else {
            self.links_outside(listing, &default);
            return listing.files.iter().filter(|path| default(path)).cloned().collect();
        };
        let mut chosen = Vec::new();
        for placed in patterns {
            if leaves_folder(&placed.text) {
                self.project.findings.push(Finding::document(Diagnostic::new(
                    Problem::P6010,
                    placed.span,
                    format!("`{}` leaves the project folder", placed.text),
                )));
                continue;
            }
            let pattern = Pattern::new(&placed.text);
            let before = chosen.len();
            let mut matched = false;
            for path in listing.files.iter().filter(|path| pattern.matches(&slashed(path))) {
                matched = true;
                if !chosen[..before].contains(path) {
                    chosen.push(path.clone());
                }
            }
            matched |= self.links_outside(listing, |path| pattern.matches(&slashed(path)));
            if !matched {
                self.project.findings.push(Finding::document(no_match(&placed.text, placed.span, listing)));
            }
        }
        chosen
    }

    /// Says which of the links out of the folder would have been read, and whether there are any.
    fn links_outside(&mut self, listing: &Listing<'_>, wanted: impl Fn(&Path) -> bool) -> bool {
        let before = self.project.findings.len();
        for relative in listing.links_outside.iter().filter(|path| wanted(path)) {
            let path = shown(&join(listing.root, relative));
            self.project.findings.push(Finding::outside(&path));
        }
        self.project.findings.len() > before
    }

    /// Reads a project of awlsim with everything that it names.
    fn awlsim_project(&mut self, path: &Path) -> Result<(), Failure> {
        let Some(read) = self.project.add_awlsim_project(path, &files::read(path)?) else { return Ok(()) };
        for table in &read.symbols {
            self.awlsim_symbols(path, table)?;
        }
        for source in &read.sources {
            match &source.content {
                Content::File(file) => {
                    if let Some(file) = self.inside(path, file, source) {
                        self.source(&file)?;
                    }
                }
                Content::Inline(text) => self.project.add_embedded_source(path, &source.name, text),
            }
        }
        Ok(())
    }

    fn awlsim_symbols(&mut self, path: &Path, table: &Source) -> Result<(), Failure> {
        let (name, text) = match &table.content {
            Content::Inline(text) => (format!("{} ({})", shown(path), table.name), text.clone()),
            Content::File(file) => {
                let Some(target) = self.inside(path, file, table) else { return Ok(()) };
                match encoding::read_source_as(&files::read(&target)?, self.project.encoding) {
                    Ok(decoded) => {
                        if decoded.had_errors {
                            self.project.findings.push(Finding::lost_bytes(&shown(&target), decoded.encoding));
                        }
                        (shown(&target), decoded.text)
                    }
                    Err(_) => return self.symbol_table(&target),
                }
            }
        };
        self.project.add_awlsim_symbols(name, text);
        Ok(())
    }

    /// The path of a file that a project of awlsim names; says so if it lies elsewhere or is not there.
    fn inside(&mut self, path: &Path, file: &str, source: &Source) -> Option<PathBuf> {
        let folder = folder_of(path);
        let target = join(folder, Path::new(file));
        let outside = || match (fs::canonicalize(&target), fs::canonicalize(folder)) {
            (Ok(target), Ok(folder)) => !target.starts_with(folder),
            _ => false,
        };
        let (problem, message) = if leaves_folder(file) || outside() {
            (Problem::P6010, format!("`{file}` leaves the folder of the project"))
        } else if !target.is_file() {
            (Problem::P6001, format!("there is no file `{}`", shown(&target)))
        } else {
            return Some(target);
        };
        self.project.findings.push(Finding::document(Diagnostic::new(problem, source.span, message)));
        None
    }
}

fn no_match(pattern: &str, span: Span, listing: &Listing<'_>) -> Diagnostic {
    let diagnostic = Diagnostic::new(Problem::P6011, span, format!("no file matches `{pattern}`"));
    let paths: Vec<String> = listing.files.iter().map(|path| slashed(path)).collect();
    match nearest(pattern, paths.iter().map(String::as_str)) {
        Some(near) => diagnostic.help(format!("did you mean `{near}`?")),
        None => diagnostic,
    }
}
